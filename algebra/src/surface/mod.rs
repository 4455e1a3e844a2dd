//! Rational surfaces: coordinates, degrees, normals and offsets.

pub(crate) mod control_net;
pub(crate) mod degree;
pub(crate) mod derivation;
pub(crate) mod direction;
pub(crate) mod homogeneous;
pub(crate) mod normal;
pub(crate) mod singular;
pub(crate) mod swept;
