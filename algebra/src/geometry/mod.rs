//! Curves and surfaces.

pub(crate) mod calculus;
pub(crate) mod canal;
pub(crate) mod curve;
pub(crate) mod curve_error;
pub(crate) mod frame;
pub(crate) mod hermite;
pub(crate) mod plane;
pub(crate) mod preimage;
pub(crate) mod quaternion;
pub(crate) mod rotation;
pub(crate) mod sample;
pub(crate) mod spatial;
pub(crate) mod spatial_hermite;
pub(crate) mod spin;
pub(crate) mod vector;
