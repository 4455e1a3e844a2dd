//! Closed intervals between numbers of a real number field.

use std::cmp::Ordering;
use std::fmt;

use crate::{Poly, Rational};

/// A closed interval `[lower, upper]` between two numbers of a real number field, of positive width.
///
/// # Example
/// ```
/// use hodograph_algebra::{Interval, Poly, integer, ratio};
/// let interval = Interval::new(Poly::integer(0), Poly::sqrt_of(&integer(2))).unwrap();
/// assert_eq!(interval.to_string(), "[0, sqrt2]");
/// assert_eq!(interval.point(&ratio(1, 2)).to_string(), "1/2*sqrt2");
/// assert!(Interval::new(Poly::integer(1), Poly::integer(1)).is_none());
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Interval {
    lower: Poly,
    upper: Poly,
}

impl Interval {
    /// The interval from `lower` to `upper`; `None` unless both are numbers and `lower < upper`.
    #[must_use]
    pub fn new(lower: Poly, upper: Poly) -> Option<Interval> {
        let numbers = lower.is_constant() && upper.is_constant();
        (numbers && lower.compare(&upper) == Ordering::Less).then_some(Interval { lower, upper })
    }

    /// The unit interval `[0, 1]`.
    #[must_use]
    pub fn unit() -> Interval {
        Interval { lower: Poly::zero(), upper: Poly::one() }
    }

    /// The lower end.
    #[must_use]
    pub fn lower(&self) -> &Poly {
        &self.lower
    }

    /// The upper end.
    #[must_use]
    pub fn upper(&self) -> &Poly {
        &self.upper
    }

    /// The difference of the ends, which is positive.
    #[must_use]
    pub fn width(&self) -> Poly {
        &self.upper - &self.lower
    }

    /// The number `lower + t·(upper − lower)`.
    #[must_use]
    pub fn point(&self, t: &Rational) -> Poly {
        &self.lower + self.width().scale(t)
    }

    /// Whether the number `value` lies in the closed interval.
    ///
    /// # Panics
    /// If `value` has variables.
    #[must_use]
    pub fn contains(&self, value: &Poly) -> bool {
        value.compare(&self.lower) != Ordering::Less && value.compare(&self.upper) != Ordering::Greater
    }
}

impl fmt::Display for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "[{}, {}]", self.lower, self.upper)
    }
}
