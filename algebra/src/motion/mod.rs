//! Rational motions through given frames: position, orientation and scale as functions of one parameter.
//!
//! JW is Johnstone and Williams, *Rational modeling of swept surfaces through frames* (cited by its sections and equations).

pub(crate) mod error;
pub(crate) mod frame;
pub(crate) mod path;
pub(crate) mod segment;
pub(crate) mod sphere;
pub(crate) mod spline;
