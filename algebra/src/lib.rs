//! Exact mathematics of rational swept surfaces: from integers to the homogeneous coordinates of a sweep.
//!
//! Everything here is exact; there are no floats, no tokens and no files.

#![deny(clippy::float_arithmetic)]

pub mod budget;
mod number;
mod poly;

pub use number::algebraic::minimize_field;
pub use number::enclosure::Enclosure;
pub use number::field::{Generator, NumberField, Relation};
pub use number::int::Int;
pub use number::rational::{
    MAX_DECIMAL_EXPONENT, Rational, integer, parse_decimal, ratio, rational_gcd, rational_sqrt, square_part,
};
pub use poly::{Monomial, Poly, Ring, Term, Variable};
