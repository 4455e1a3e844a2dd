//! Exact numbers.

pub(crate) mod algebraic;
pub(crate) mod bracket;
pub(crate) mod complex;
pub(crate) mod complex_gcd;
pub(crate) mod enclosure;
pub(crate) mod field;
pub(crate) mod int;
pub(crate) mod lehmer;
pub(crate) mod rational;
pub(crate) mod square_root;
pub(crate) mod subfield;
pub(crate) mod trig;
