//! Modular images: prime fields, polynomials over them, and the way back to the rationals.
//!
//! Nothing here decides anything by itself: what is found modulo primes is a candidate, which [`crate::poly`] certifies
//! over the integers or the number field.

pub(crate) mod field;
pub(crate) mod gcd;
pub(crate) mod heap;
pub(crate) mod lift;
pub(crate) mod montgomery;
pub(crate) mod multivariate;
pub(crate) mod prime;
pub(crate) mod root;
pub(crate) mod sparse;
pub(crate) mod splitting;
pub(crate) mod univariate;
