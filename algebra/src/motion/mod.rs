//! Rational motions through given frames: position, orientation and scale as functions of one parameter.
//!
//! JW is Johnstone and Williams, *A rational model of the surface swept by a curve*, 1995; its
//! sections and equations are cited.

pub(crate) mod error;
pub(crate) mod frame;
pub(crate) mod path;
pub(crate) mod segment;
pub(crate) mod sphere;
pub(crate) mod spline;
