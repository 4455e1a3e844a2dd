//! Signs of rational functions at sample points, to choose between two roots.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use crate::{Fraction, Interval, Poly, Variable, ratio};

/// The sign of `f` at some point with `parameter` near the beginning of its interval, where `f` is defined and not zero;
/// symbols take sample values. It chooses between `f` and `−f`, and decides nothing else.
pub(crate) fn sample_sign(f: &Fraction, parameter: &Variable, domain: &Interval) -> Ordering {
    sample(f, &[(parameter, domain)])
}

/// The same for two parameters on a box.
pub(crate) fn sample_sign_on_box(
    f: &Fraction,
    parameters: &[Variable; 2],
    domain: &[Interval; 2],
) -> Ordering {
    sample(f, &[(&parameters[0], &domain[0]), (&parameters[1], &domain[1])])
}

fn sample(f: &Fraction, intervals: &[(&Variable, &Interval)]) -> Ordering {
    // Beginning with the start itself, then ever farther from it.
    for step in 0..24_i64 {
        let mut values = BTreeMap::new();
        for (variable, seed) in f.occurring_variables().into_iter().zip(1_i64..) {
            let value = match intervals.iter().find(|(parameter, _)| **parameter == variable) {
                Some((_, interval)) => interval.point(&ratio(step * step * (seed + 1), 1200 * seed)),
                // Any values will do; these are distinct and meet no simple relation.
                None => Poly::constant(ratio(3 + 7 * seed + step * seed * seed, 5 + 2 * seed + step)),
            };
            values.insert(variable, Fraction::from(value));
        }
        let sign = f.substitute(&values).and_then(|value| value.to_number()).map(|value| value.sign());
        if let Some(sign) = sign.filter(|sign| sign.is_ne()) {
            return sign;
        }
    }
    Ordering::Equal
}
