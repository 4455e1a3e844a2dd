//! From programs to source text.
//!
//! [`module`] gives the documented module of one surface, as the macro expands to; [`format`](format()) lays tokens out as
//! text, and [`standalone`] adds the little of the runtime that the items need.

mod body;
mod c;
mod chain;
mod code;
mod documentation;
mod expression;
mod family;
pub mod latex;
mod names;
mod net;
mod pieces;
mod rust;
mod stages;
mod standalone;
mod task;

use proc_macro2::TokenStream;

pub use c::{Clash, header};
pub use pieces::modules;
pub use rust::module;
pub use standalone::standalone;
pub use task::{TASKS, Task};

use crate::meaning::CoefficientKind;
use crate::offset::OffsetPatch;
use crate::program::Program;
use crate::proofs::Proofs;

/// A surface to be emitted: its program, and what is said of it.
#[derive(Clone, Debug)]
pub struct Artifact {
    /// The name of the sweep, in snake case.
    pub name: String,
    /// The documentation that its author wrote, a string for each line.
    pub documentation: Vec<String>,
    /// The formula, in the sweep language.
    pub formula: String,
    /// Where the formula is from.
    pub source: Option<String>,
    /// The strict degrees in u and v of W, X, Y and Z; −1 for a zero polynomial.
    pub coordinate_degrees: [(i64, i64); 4],
    /// The patch degree.
    pub degree: (u32, u32),
    /// First and last value of u, then of v.
    pub domain: [[f64; 2]; 2],
    /// Homogeneous control points over the domain, the index of u outer.
    pub control_net: Vec<[f64; 4]>,
    /// What is proved of the evaluators; families, whose coefficients are not known, have no bounds that are constants.
    pub proofs: Option<Proofs>,
    /// The exact offset patches, if they are rational; families have none.
    pub offset: Option<OffsetPatch>,
    /// What is set at run time; nothing for a surface whose coefficients are all numbers. Then the control net is empty,
    /// since each member of the family has its own.
    pub symbols: Vec<Setting>,
    /// Which piece of a surface of several pieces it is.
    pub piece: Option<PieceOf>,
    /// Whether its point is the one without cancellation.
    pub is_accurate: bool,
    /// The scheduled program (see [`crate::schedule`]) with rounded constants.
    pub program: Program<f64>,
}

/// The place of a surface among the pieces of a larger one.
#[derive(Clone, PartialEq, Debug)]
pub struct PieceOf {
    /// The name of the whole.
    pub of: String,
    /// Which of the pieces it is, from 0 on.
    pub index: usize,
    /// How many pieces there are.
    pub count: usize,
    /// The least float that is not below the first v.
    pub start: f64,
    /// Whether that is the first v itself.
    pub start_is_exact: bool,
    /// Whether it meets the piece before it: whether both have the same points at its first v.
    pub meets: bool,
}

/// What the values of symbols are given by at run time.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Setting {
    /// A number: the name of the symbol.
    Number(String),
    /// The coefficients of a curve.
    Curve {
        /// The name of the curve.
        name: String,
        /// What the coefficients are.
        kind: CoefficientKind,
        /// The names of the symbols, a row for each coefficient.
        rows: Vec<Vec<String>>,
    },
}

/// The text of `tokens`, which are items of a file, laid out by prettyplease.
///
/// # Errors
/// The error of syn if the tokens are not items.
pub fn format(tokens: TokenStream) -> Result<String, syn::Error> {
    Ok(prettyplease::unparse(&syn::parse2(tokens)?))
}

#[cfg(test)]
mod tests;
