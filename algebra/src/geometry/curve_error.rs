//! Why a curve does not have a property.

use std::fmt;

use super::spin::SpinError;
use crate::{Fraction, Poly};

/// Why a curve does not have a property.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum CurveError {
    /// The curve is a point: its derivative is zero.
    Point,
    /// `|s'|²` is not the square of a rational function.
    IrrationalSpeed {
        /// `|s'|²`.
        squared: Box<Fraction>,
        /// The factor of it that is no square; 1 if only the sign is wrong.
        odd: Box<Poly>,
    },
    /// The rational root of `|s'|²` changes its sign on the domain, so its absolute value is not rational.
    SpeedChangesSign {
        /// The factor of the root that changes its sign.
        factor: Box<Poly>,
    },
    /// The curve lies in no plane, so it has no planar normal.
    NotPlanar,
    /// The curve is a straight line that is parallel to no coordinate plane: it has no normal of its own.
    Line,
    /// The unit vector orthogonal to the curve's plane contains the square root of a polynomial in symbols.
    IrrationalPlane {
        /// A vector orthogonal to the plane has this squared length.
        squared: Box<Poly>,
    },
    /// The integral of the parametric speed is not a rational function.
    ArcLength {
        /// The parametric speed.
        speed: Box<Fraction>,
        /// The part of it whose integral is a sum of logarithms and arctangents.
        remainder: Box<Fraction>,
    },
    /// The integral of the parametric speed is not known, since unknown functions occur in it.
    UnknownArcLength {
        /// The parametric speed.
        speed: Box<Fraction>,
    },
    /// The parametric speed has a pole on the domain, so that the arc length is infinite.
    Pole {
        /// The factor of its denominator that vanishes there.
        factor: Box<Poly>,
    },
    /// The curvature is zero everywhere: a straight line has no evolute.
    Straight,
    /// No rotation-minimizing frame of the curve is rational.
    NoRationalFrame {
        /// Half the rate at which it would turn against the Euler–Rodrigues frame.
        spin: Box<Fraction>,
        /// What this lacks.
        error: Box<SpinError>,
    },
    /// Whether a rotation-minimizing frame is rational is not known, since unknown functions occur.
    UnknownFrame,
    /// `|s' × s''|²` is not the square of a rational function, so the Frenet frame is not rational.
    IrrationalFrenet {
        /// `|s' × s''|²`.
        squared: Box<Fraction>,
        /// The factor of it that is no square; 1 if only the sign is wrong.
        odd: Box<Poly>,
    },
    /// The Frenet frame contains the square root of a polynomial in symbols: for numbers in their place it is rational.
    SymbolicFrenet {
        /// The polynomial, up to a number.
        radicand: Box<Poly>,
    },
    /// No domain is stated for the parameter, so that a property at its end is not defined.
    NoDomain,
}

impl fmt::Display for CurveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CurveError::Point => f.write_str("the curve is a single point: its derivative is zero"),
            CurveError::IrrationalSpeed { squared, odd } => {
                write!(f, "the parametric speed is not rational: |s'|^2 = {squared}")?;
                if odd.is_one() { Ok(()) } else { write!(f, ", in which {odd} is not a square") }
            }
            CurveError::SpeedChangesSign { factor } => {
                write!(
                    f,
                    "the parametric speed is not rational on this domain: its factor {factor} changes its sign there"
                )
            }
            CurveError::NotPlanar => f.write_str("the curve lies in no plane"),
            CurveError::Line => f.write_str(
                "the curve is a straight line that is parallel to no coordinate plane, so that no plane determines its normal",
            ),
            CurveError::IrrationalPlane { squared } => {
                write!(f, "the unit normal of the curve's plane is not rational in the symbols: {squared} is not a square")
            }
            CurveError::ArcLength { speed, remainder } => {
                let lead = "the arc length is not rational: the integral of the parametric speed";
                if speed == remainder {
                    write!(f, "{lead} {speed} consists of logarithms or arctangents")
                } else {
                    write!(f, "{lead} {speed} contains that of {remainder}, logarithms or arctangents")
                }
            }
            CurveError::UnknownArcLength { speed } => {
                write!(f, "no arc length is known: the parametric speed {speed} contains unknown functions")
            }
            CurveError::Pole { factor } => {
                write!(
                    f,
                    "the arc length is infinite: {factor} in the denominator of the parametric speed vanishes on the domain"
                )
            }
            CurveError::Straight => f.write_str("the curvature is zero everywhere, so there is no evolute and no Frenet frame"),
            CurveError::NoRationalFrame { spin, error } => write!(
                f,
                "the curve has no rational rotation-minimizing frame: {error}. Half the rate at which such a frame would \
                 turn against the Euler-Rodrigues frame is h = {spin}"
            ),
            CurveError::UnknownFrame => f.write_str(
                "whether a rotation-minimizing frame is rational is not known, since unknown functions occur in it",
            ),
            CurveError::IrrationalFrenet { squared, odd } => {
                write!(f, "the Frenet frame is not rational: |s' x s''|^2 = {squared}")?;
                if odd.is_one() { Ok(()) } else { write!(f, ", in which {odd} is not a square") }
            }
            CurveError::SymbolicFrenet { radicand } => {
                write!(f, "the Frenet frame contains the square root of {radicand}, which depends on the symbols alone")
            }
            CurveError::NoDomain => f.write_str("no domain is stated for the curve's parameter"),
        }
    }
}

impl std::error::Error for CurveError {}
