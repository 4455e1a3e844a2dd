//! Names that two sweeps of a header would both define.

use std::collections::BTreeMap;
use std::fmt;

/// Two sweeps define one name in C, which has no modules: `tube_normal_grid` is the grid of normals of `tube` and the grid of points of
/// `tube_normal`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Clash {
    /// The name that both define.
    pub name: String,
    /// The sweep that has it first.
    pub first: String,
    /// The sweep that has it again.
    pub second: String,
}

impl fmt::Display for Clash {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Clash { name, first, second } = self;
        write!(f, "`{second}` and `{first}` would both define `{name}` in C")
    }
}

impl std::error::Error for Clash {}

/// The names that have been defined, with the sweeps that did.
#[derive(Default)]
pub(super) struct Names<'a>(BTreeMap<String, &'a str>);

impl<'a> Names<'a> {
    /// Takes the names that a sweep defines in its part of a header.
    ///
    /// # Errors
    /// The first name that another sweep has defined.
    pub(super) fn take(&mut self, sweep: &'a str, text: &str) -> Result<(), Clash> {
        for name in text.lines().filter_map(defined) {
            match self.0.insert(name.to_string(), sweep) {
                Some(first) if first != sweep => {
                    let (first, second) = (first.to_string(), sweep.to_string());
                    return Err(Clash { name: name.to_string(), first, second });
                }
                _ => {}
            }
        }
        Ok(())
    }
}

/// The name that a line defines for the whole header: of a function, a constant or a type.
fn defined(line: &str) -> Option<&str> {
    let declared = match line.strip_prefix("static ") {
        Some(rest) => rest.split(['(', '[', '=', ';']).next()?,
        None => line.strip_prefix("} ")?.strip_suffix(';')?,
    };
    declared.split([' ', '*']).rfind(|word| !word.is_empty())
}
