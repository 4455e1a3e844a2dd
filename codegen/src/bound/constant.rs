//! What a program's constants are off by.

use hodograph_algebra::{Enclosure, Poly, Rational};

use super::dyadic::Dyadic;
use super::interval::Interval;
use super::{Precision, Rounding};
use crate::round::exact;

/// The bits to which constants that are not rational are enclosed, beside those of their magnitude.
const BITS: i64 = 96;

/// An exact constant and the errors of the floats that are used for it.
#[derive(Clone, Debug)]
pub(super) struct Constant {
    range: Interval,
    errors: Vec<Option<Dyadic>>,
}

impl Constant {
    /// `None` if the number has variables.
    pub(super) fn new(number: &Poly, used: f64, roundings: &[Rounding]) -> Option<Constant> {
        let value = enclosure(number, used)?;
        let error = |rounding: &Rounding| {
            let used = match rounding.precision {
                Precision::Double => used,
                Precision::Single => f64::from(used as f32),
            };
            let used = exact(used)?;
            let off = |end: &Rational| {
                let difference = end - &used;
                Dyadic::above(&difference).max(Dyadic::above(&-difference))
            };
            Some(off(value.lower()).max(off(value.upper())))
        };
        let range = Interval { lower: -Dyadic::above(&-value.lower()), upper: Dyadic::above(value.upper()) };
        Some(Constant { range, errors: roundings.iter().map(error).collect() })
    }

    /// The exact constant.
    pub(super) fn range(&self) -> Interval {
        self.range
    }

    /// The error in the format at a place; `None` if the constant is beyond it.
    pub(super) fn error(&self, format: usize) -> Option<Dyadic> {
        self.errors[format]
    }
}

/// A narrow enclosure of a number near the float `used`.
fn enclosure(number: &Poly, used: f64) -> Option<Enclosure> {
    if !number.is_constant() {
        return None;
    }
    if let Some(value) = number.to_rational() {
        return Some(Enclosure::exact(value));
    }
    let magnitude = Dyadic::of(used).filter(|used| !used.is_zero()).map_or(-1100, Dyadic::magnitude);
    let bits = (BITS - i64::from(magnitude)).max(8).unsigned_abs();
    Some(number.enclosure(bits))
}
