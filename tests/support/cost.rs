//! What the expansion of a catalogue's entry costs the compiler.

use std::time::{Duration, Instant};

use hodograph::Source;
use hodograph_algebra::budget;
use hodograph_codegen::compile::expand;
use hodograph_codegen::emit::format;
use hodograph_codegen::language::ast::ItemKind;
use hodograph_codegen::language::{Report, parse_text};
use proc_macro2::{TokenStream, TokenTree};

/// One expansion of an entry: the work of `sweep!(file = "…")`, from the text to the tokens.
#[derive(Clone, Debug)]
pub struct Expansion {
    /// How long it took.
    pub time: Duration,
    /// The units of work that it spent, which are the same everywhere.
    pub units: u64,
    /// What the macro gives to the compiler.
    pub code: TokenStream,
}

impl Expansion {
    /// Expands an entry.
    ///
    /// # Panics
    /// With the report of the mistakes in its text.
    #[must_use]
    pub fn of(entry: &Source) -> Expansion {
        let start = Instant::now();
        let (expanded, units) = budget::measured(|| {
            let (file, source) = parse_text(entry.name, entry.text)?;
            let (code, mistakes) = expand(&file);
            if mistakes.is_empty() { Ok(code) } else { Err(Box::new(Report::new(source, mistakes))) }
        });
        let time = start.elapsed();
        let code = expanded.unwrap_or_else(|report| panic!("{report}"));
        Expansion { time, units, code }
    }

    /// The number of tokens; a pair of delimiters is two.
    #[must_use]
    pub fn tokens(&self) -> usize {
        tokens(&self.code)
    }

    /// The code laid out as text, as the command `hodograph emit` writes it.
    ///
    /// # Panics
    /// If the code is not that of items.
    #[must_use]
    pub fn text(&self) -> String {
        format(self.code.clone()).unwrap_or_else(|error| panic!("{error}"))
    }
}

/// The entry whose code is checked in, since it is too much work for every build.
pub const CHECKED_IN: &str = "frames_gutter";

/// The entries of the catalogue that are expanded in every build, in its order; the others hold nothing but claims, or are
/// [checked in](CHECKED_IN).
///
/// # Panics
/// With the report of a mistake in an entry's syntax.
#[must_use]
pub fn expanded() -> Vec<Source> {
    let is_expanded = |entry: &Source| {
        let (file, _) = parse_text(entry.name, entry.text).unwrap_or_else(|report| panic!("{report}"));
        file.items.iter().all(|item| item.kind == ItemKind::Sweep)
    };
    let entries = hodograph::sources().iter().copied().filter(|entry| entry.name != CHECKED_IN);
    entries.filter(is_expanded).collect()
}

fn tokens(code: &TokenStream) -> usize {
    let count = |token: TokenTree| match token {
        TokenTree::Group(group) => 2 + tokens(&group.stream()),
        _ => 1,
    };
    code.clone().into_iter().map(count).sum()
}
