//! A self-contained C11 header with the evaluators of surfaces, in both precisions: the functions of the runtime's `Surface`,
//! `Sweep::batch` and `Piecewise`, and the constants of a surface, by the same names.
//!
//! Its functions have the bits of the plain variant, on machines and with options that compute as IEEE 754 has it: the header
//! checks what it can of that.

mod clash;
mod constants;
mod expression;
mod family;
mod form;
mod net;
mod pieces;
mod surface;
mod template;

use std::fmt::Write;

use super::code::Code;
use super::pieces::Whole;
use super::{Artifact, documentation};
use crate::bound::Precision;
use crate::proofs::BOUNDED;
use crate::schedule::outputs;
pub use clash::Clash;
use clash::Names;
use template::fill;

/// How C writes a precision.
#[derive(Clone, Copy, Debug)]
struct Type {
    precision: Precision,
    /// The type of numbers.
    real: &'static str,
    /// What names of functions end with, as in `sqrtf`.
    suffix: &'static str,
}

const DOUBLE: Type = Type { precision: Precision::Double, real: "double", suffix: "" };
const SINGLE: Type = Type { precision: Precision::Single, real: "float", suffix: "f" };

impl Type {
    /// A number, with the fewest digits that are read back as the same.
    fn literal(self, number: f64) -> String {
        let (finite, digits) = match self.precision {
            Precision::Double => (number.is_finite(), format!("{number:?}")),
            Precision::Single => ((number as f32).is_finite(), format!("{:?}f", number as f32)),
        };
        match finite {
            true => digits,
            // Beyond the range of the precision: results are not finite either, which functions tell.
            false if number < 0.0 => "-INFINITY".to_string(),
            false => "INFINITY".to_string(),
        }
    }
}

/// The header for `artifacts`.
///
/// For each sweep `name` it has `name_point(u, v, out)` and the like, with `f` after the name in single precision, which return a
/// `hodograph_status`; batches such as `name_grid`; constants such as `name_control_net`; and for a family a struct that
/// `name_new` fills with the member's coefficients. After all pieces of a surface comes the whole, with the same functions. The
/// comment at the beginning lists them all.
///
/// A name that begins with `hodograph`, as those of the header itself do, has `sweep_` in front.
///
/// # Errors
/// [`Clash`], where two sweeps would define one name.
///
/// # Example
/// ```
/// use hodograph_codegen::{compile::compile, emit, language::parse_text, meaning::models};
///
/// let text = "sweep saddle { surface R = (u, v, u*v); domain u in 0..1, v in 0..1; }";
/// let (file, _source) = parse_text("saddle.sweep", text).unwrap();
/// let header = emit::header(&[compile(&models(&file).0[0]).unwrap()]).unwrap();
/// assert!(header.contains("static inline hodograph_status saddle_point(double u, double v, double out[3])"));
/// ```
pub fn header(artifacts: &[Artifact]) -> Result<String, Clash> {
    let mut names = Names::default();
    let mut text = prologue();
    if artifacts.iter().any(|artifact| !artifact.symbols.is_empty()) {
        text.push_str(include_str!("families.h.in"));
    }
    let whole = |index: usize| Whole::completed(&artifacts[..=index]);
    if (0..artifacts.len()).any(|index| whole(index).is_some()) {
        text.push_str(include_str!("joints.h.in"));
    }
    for (index, artifact) in artifacts.iter().enumerate() {
        let start = text.len();
        surface(&mut text, artifact);
        names.take(&artifact.name, &text[start..])?;
        if let Some(whole) = whole(index) {
            let (name, start) = (whole.name, text.len());
            pieces::whole(&mut text, whole);
            names.take(name, &text[start..])?;
        }
    }
    text.push_str("\n#ifdef __cplusplus\n}\n#endif\n");
    Ok(text)
}

/// What every header begins with.
fn prologue() -> String {
    let runtime = include_str!("runtime.h.in");
    let precision = |Type { real, suffix, .. }, integers: [&str; 3], [limits, least, field]: [&str; 3]| {
        let [bits, fraction, exponents] = integers;
        let values = [("real", real), ("f", suffix), ("_f", field), ("limits", limits), ("least", least)];
        let layout = [("bits", bits), ("fraction", fraction), ("exponents", exponents)];
        fill(runtime, &[&values[..], &layout].concat())
    };
    let precisions = [
        precision(DOUBLE, ["uint64_t", "52", "2046"], ["DBL", "5e-324", ""]),
        precision(SINGLE, ["uint32_t", "23", "254"], ["FLT", "1e-45", "_f"]),
    ];
    let bounds = BOUNDED.map(|name| match name {
        outputs::POINT => include_str!("point_bound.h.in").trim_end().to_owned(),
        _ => format!("    hodograph_bound {name};"),
    });
    let values = [("bounds", bounds.join("\n")), ("precisions", precisions.concat())];
    fill(include_str!("prologue.h.in"), &values.each_ref().map(|(key, value)| (*key, value.as_str())))
}

/// What all names of the sweep of this name begin with.
fn prefix(name: &str) -> String {
    let own = if name.starts_with("hodograph") { "sweep_" } else { "" };
    format!("{own}{name}")
}

fn surface(text: &mut String, artifact: &Artifact) {
    let name = &prefix(&artifact.name);
    let runtime = proc_macro2::TokenStream::new();
    let code = &Code::new(&artifact.program, &runtime);
    let mut content = constants::constants(name, artifact);
    if code.is_family() {
        content.push_str(&family::family(name, artifact, code));
    }
    for kind in [DOUBLE, SINGLE] {
        content.push_str(&surface::evaluators(name, code, kind));
    }
    section(text, name, &documentation::lines(artifact), &content);
}

/// The section of a sweep, which can be in several headers that are included together.
fn section(text: &mut String, name: &str, documentation: &[String], content: &str) {
    text.push_str("\n/*\n");
    for line in documentation {
        let line = line.replace("*/", "* /").replace("/*", "/ *");
        _ = writeln!(text, " *{}{}", if line.is_empty() { "" } else { " " }, line);
    }
    _ = write!(
        text,
        " */\n#ifndef HODOGRAPH_SWEEP_{name}\n#define HODOGRAPH_SWEEP_{name}\n\n{content}#endif\n"
    );
}
