//! Polynomials as functions of real numbers: Bernstein forms, roots, and signs on a box.

pub(crate) mod bernstein;
pub(crate) mod common;
pub(crate) mod interval;
pub(crate) mod isolate;
mod net;
pub(crate) mod positivity;
pub(crate) mod roots;
pub(crate) mod subdivision;
mod tensor;
pub(crate) mod zeros;
