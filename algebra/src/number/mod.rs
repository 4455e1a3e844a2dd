//! Exact numbers.

pub(crate) mod algebraic;
pub(crate) mod bracket;
pub(crate) mod complex;
pub(crate) mod enclosure;
pub(crate) mod field;
pub(crate) mod int;
pub(crate) mod rational;
pub(crate) mod trig;
