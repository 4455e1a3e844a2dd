//! Why a surface has no point, or no normal.

use core::fmt;

/// Why a surface does not have at (u, v) what was asked for, as computed in the precision at hand.
///
/// Evaluators accept all parameters, and answer with this error where their result would not be finite: never with infinity
/// or NaN.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Undefined {
    /// The weight W vanishes.
    Pole,
    /// There is a point, and R_u × R_v vanishes as it is computed: the surface has no normal.
    Singular,
    /// A parameter that the result depends on is infinite or NaN.
    Parameter,
    /// Numbers on the way to the result, or itself, are beyond the range of the precision: far from the domain, or near a pole.
    Overflow,
}

impl fmt::Display for Undefined {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Pole => "the surface has a pole there",
            Self::Singular => "the surface has no normal there",
            Self::Parameter => "a parameter is infinite or NaN",
            Self::Overflow => "the result is beyond the range of floats",
        })
    }
}

impl core::error::Error for Undefined {}
