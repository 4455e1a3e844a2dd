//! Rational surfaces: coordinates, degrees, normals and offsets.

pub(crate) mod combination;
pub(crate) mod common_zero;
pub(crate) mod conditions;
pub(crate) mod control_net;
pub(crate) mod curvature_zeros;
pub(crate) mod degree;
pub(crate) mod derivation;
pub(crate) mod direction;
pub(crate) mod elimination;
pub(crate) mod essentials;
pub(crate) mod form_function;
pub(crate) mod fundamental_forms;
pub(crate) mod homogeneous;
pub(crate) mod locus;
pub(crate) mod normal;
pub(crate) mod singular;
pub(crate) mod squared_length;
pub(crate) mod swept;
