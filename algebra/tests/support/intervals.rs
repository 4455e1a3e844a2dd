//! Random numbers and intervals.

use hodograph_algebra::{Interval, Poly, Variable, integer, ratio};
use proptest::prelude::*;

/// The first variable.
pub(crate) fn u() -> Variable {
    Variable::new(0, "u")
}

/// The second variable.
pub(crate) fn v() -> Variable {
    Variable::new(1, "v")
}

/// `√2`.
pub(crate) fn root2() -> Poly {
    Poly::sqrt_of(&integer(2))
}

/// Rational numbers and numbers of Q(√2).
pub(crate) fn numbers() -> impl Strategy<Value = Poly> {
    (-9_i64..10, 1_i64..5, -3_i64..4, any::<bool>()).prop_map(|(n, d, r, irrational)| {
        let irrational = if irrational { root2().scale(&integer(r)) } else { Poly::zero() };
        Poly::constant(ratio(n, d)) + irrational
    })
}

/// Intervals between such numbers.
pub(crate) fn intervals() -> impl Strategy<Value = Interval> {
    (numbers(), numbers()).prop_filter_map("an interval has ends in order", |(a, b)| {
        Interval::new(a.clone(), b.clone()).or_else(|| Interval::new(b, a))
    })
}
