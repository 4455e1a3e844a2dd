//! Exact mathematics of rational swept surfaces: from integers to the homogeneous coordinates of a sweep.
//!
//! Everything here is exact; there are no floats, no tokens and no files. Each layer uses those above it alone:
//!
//! | layer | what it is |
//! | --- | --- |
//! | [`budget`] | deterministic limits for work that could explode |
//! | numbers | [`Int`], [`Rational`], [`Enclosure`]; [`NumberField`]: towers of square roots; [`Complex`]; [`cos_pi`] |
//! | polynomials | [`Poly`] over a [`Ring`]: arithmetic, exact division, gcd, [`Squarefree`], [`SquareSplit`], resultant |
//! | reals | [`Bernstein`] forms, [`RealRoot`], the sign of a polynomial on a box ([`BoxSign`]), [`ZeroSet`] |
//! | fractions | [`Fraction`]: rational functions that keep their denominators as products of known factors; [`QuadraticFraction`], [`Integral`] |
//! | curves | [`Vector`], [`Quaternion`], [`Calculus`], [`Curve`], PH curves by [`Preimage`] and [`Hermite`] data, spatial ones by [`SpatialPreimage`]; [`AdaptedFrame`] |
//! | motions | [`Motion`] through [`Frame`]s: [`Spline`], [`onto_sphere`] |
//! | surfaces | [`SweptSurface`]: [`Homogeneous`] coordinates, [`Normal`], [`FundamentalForms`], offsets, [`SingularLocus`] |
//!
//! # Example
//! FN Example 2: a circular arc moves along a PH quintic, in its normal plane.
//! ```
//! use hodograph_algebra::*;
//! use std::rc::Rc;
//!
//! let [u, v] = [Variable::new(0, "u"), Variable::new(1, "v")];
//! // The profile (16): x = (1 − u²)/(1 + u²), z = 2u/(1 + u²).
//! let square = Poly::variable(&u).pow(2);
//! let over_weight = |numerator: Poly| Fraction::new(numerator, [(&square + Poly::one(), 1)]);
//! let [x, z] = [over_weight(Poly::one() - &square), over_weight(Poly::variable(&u).scale(&integer(2)))];
//! // The path: the PH quintic of least absolute rotation index with these Hermite data.
//! let point = |x, y| Complex::new(Poly::integer(x), Poly::integer(y));
//! let data = Hermite::new(&point(0, 0), &point(0, 4), &point(2, 2), &point(4, 0)).unwrap();
//! let PhCurve { position, .. } = data.least_rotation().unwrap().curve(&v, &point(0, 0));
//! let position = Vector::new(position.re.into(), position.im.into(), Fraction::zero());
//! let path = Curve::new(&v, position, Some(Interval::unit()), KnownProperties::default(), Rc::default());
//! // The sweep (17): R = s + x n + z k.
//! let across = path.normal().unwrap().scale(&x);
//! let formula = &(path.position() + &across) + &Vector::unit(2).scale(&z);
//! let surface = SweptSurface::new(formula, [u, v], [Interval::unit(), Interval::unit()]);
//!
//! let derivation = surface.derive().unwrap();
//! assert_eq!(derivation.homogeneous.degree().to_string(), "(2, 9)");
//! assert_eq!(derivation.field.degree(), 4);
//! let geometry = derivation.geometry.unwrap();
//! assert!(geometry.offset.is_rational() && geometry.singular.is_regular());
//! ```
#![doc = include_str!("speed.md")]
#![doc = include_str!("algorithms.md")]
#![doc = include_str!("growth.md")]
#![deny(clippy::float_arithmetic)]

pub mod budget;
mod fraction;
mod geometry;
mod integral;
mod modular;
mod motion;
mod number;
mod operators;
mod poly;
mod real;
mod surface;

pub use fraction::Fraction;
pub use fraction::quadratic::QuadraticFraction;
pub use geometry::calculus::Calculus;
pub use geometry::canal::CanalError;
pub use geometry::curve::{Curve, KnownProperties, moving_frame_curve, rational_root};
pub use geometry::curve_error::CurveError;
pub use geometry::frame::AdaptedFrame;
pub use geometry::hermite::{Hermite, HermiteDatum, HermiteError, HermiteSolution};
pub use geometry::preimage::{MAX_PH_DEGREE, PhCurve, Preimage, PreimageError};
pub use geometry::quaternion::Quaternion;
pub use geometry::spatial::{SpatialPhCurve, SpatialPreimage};
pub use geometry::spatial_hermite::{SpatialHermite, SpatialHermiteError};
pub use geometry::spin::{Rotation, SpinError};
pub use geometry::vector::Vector;
pub use integral::Integral;
pub use motion::error::{MAX_FRAMES, MotionError};
pub use motion::frame::Frame;
pub use motion::path::{Motion, MotionEnds, MotionOptions, Orientation};
pub use motion::segment::MotionSegment;
pub use motion::sphere::{Lift, from_sphere, onto_sphere};
pub use motion::spline::{Ends, Smoothness, Spline, bernstein_product, bernstein_sum};
pub use number::complex::Complex;
pub use number::enclosure::Enclosure;
pub use number::field::{Generator, NumberField, Relation};
pub use number::int::Int;
pub use number::rational::{
    MAX_DECIMAL_EXPONENT, Rational, integer, parse_decimal, ratio, rational_gcd, rational_sqrt, square_part,
};
pub use number::subfield::minimize_field;
pub use number::trig::{MAX_ANGLE_HALVINGS, NotConstructible, cos_pi, exp_i_pi, sin_pi};
pub use poly::{Monomial, Poly, Ring, SquareSplit, Squarefree, Term, Variable};
pub use real::bernstein::{Axis, Bernstein};
pub use real::interval::Interval;
pub use real::positivity::BoxSign;
pub use real::roots::RealRoot;
pub use real::subdivision::Point;
pub use real::zeros::{EdgeZeros, ZeroCurve, ZeroSet};
pub use surface::common_zero::CommonZero;
pub use surface::conditions::{Conditions, common_factors, falling_degree};
pub use surface::control_net::ControlNet;
pub use surface::curvature_zeros::CurvatureZeros;
pub use surface::degree::Bidegree;
pub use surface::derivation::{Derivation, DifferentialGeometry, Offset};
pub use surface::essentials::Essentials;
pub use surface::form_function::FormFunction;
pub use surface::fundamental_forms::{FormError, FundamentalForms};
pub use surface::homogeneous::Homogeneous;
pub use surface::locus::Locus;
pub use surface::normal::Normal;
pub use surface::singular::SingularLocus;
pub use surface::squared_length::SquaredLength;
pub use surface::swept::{OffsetError, ParametricSpeed, RadicalSurface, SweptSurface};
