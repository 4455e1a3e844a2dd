//! Exact mathematics of rational swept surfaces: from integers to the homogeneous coordinates of a sweep.
//!
//! Everything here is exact; there are no floats, no tokens and no files.

#![deny(clippy::float_arithmetic)]

pub mod budget;
mod fraction;
mod geometry;
mod modular;
mod number;
mod operators;
mod poly;
mod real;
mod surface;

pub use fraction::Fraction;
pub use geometry::calculus::Calculus;
pub use geometry::curve::{Curve, CurveError, KnownProperties, moving_frame_curve, rational_root};
pub use geometry::hermite::{Hermite, HermiteDatum, HermiteError, HermiteSolution};
pub use geometry::preimage::{MAX_PH_DEGREE, PhCurve, Preimage, PreimageError};
pub use geometry::vector::Vector;
pub use number::algebraic::minimize_field;
pub use number::complex::Complex;
pub use number::enclosure::Enclosure;
pub use number::field::{Generator, NumberField, Relation};
pub use number::int::Int;
pub use number::rational::{
    MAX_DECIMAL_EXPONENT, Rational, integer, parse_decimal, ratio, rational_gcd, rational_sqrt, square_part,
};
pub use number::trig::{MAX_ANGLE_HALVINGS, NotConstructible, cos_pi, exp_i_pi, sin_pi};
pub use poly::{Monomial, Poly, Ring, SquareSplit, Squarefree, Term, Variable};
pub use real::bernstein::{Axis, Bernstein};
pub use real::interval::Interval;
pub use real::positivity::BoxSign;
pub use real::roots::RealRoot;
pub use real::subdivision::Point;
pub use real::zeros::{EdgeZeros, ZeroCurve, ZeroSet};
pub use surface::control_net::ControlNet;
pub use surface::degree::Bidegree;
pub use surface::derivation::{Derivation, Offset};
pub use surface::homogeneous::Homogeneous;
pub use surface::normal::Normal;
pub use surface::singular::SingularLocus;
pub use surface::swept::{OffsetError, ParametricSpeed, SweptSurface};
