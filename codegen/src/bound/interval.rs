//! Intervals of dyadic numbers, rounded outward (Moore, *Interval Analysis*, 1966).

use super::dyadic::Dyadic;

/// All real numbers from `lower` to `upper`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Interval {
    pub(super) lower: Dyadic,
    pub(super) upper: Dyadic,
}

impl Interval {
    /// The interval of one number.
    pub(super) fn point(number: Dyadic) -> Interval {
        Interval { lower: number, upper: number }
    }

    /// max |x|
    pub(super) fn largest(&self) -> Dyadic {
        self.upper.max(-self.lower)
    }

    /// min |x|
    pub(super) fn least(&self) -> Dyadic {
        match (self.lower.is_positive(), self.upper.is_negative()) {
            (true, _) => self.lower,
            (_, true) => -self.upper,
            _ => Dyadic::ZERO,
        }
    }

    /// Whether no number of it is below 0.
    pub(super) fn is_nonnegative(&self) -> bool {
        !self.lower.is_negative()
    }

    /// Whether no number of it is above 0.
    pub(super) fn is_nonpositive(&self) -> bool {
        !self.upper.is_positive()
    }

    /// Whether sums of numbers of both add magnitudes.
    pub(super) fn agrees_with(&self, other: &Interval) -> bool {
        self.is_nonnegative() && other.is_nonnegative() || self.is_nonpositive() && other.is_nonpositive()
    }

    /// −x
    pub(super) fn negated(&self) -> Interval {
        Interval { lower: -self.upper, upper: -self.lower }
    }

    /// x + y
    pub(super) fn plus(&self, other: &Interval) -> Interval {
        Interval { lower: -(-self.lower).plus(-other.lower), upper: self.upper.plus(other.upper) }
    }

    /// x·y
    pub(super) fn times(&self, other: &Interval) -> Interval {
        if self.is_nonpositive() && self.lower.is_negative() {
            return self.negated().times(other).negated();
        }
        if other.is_nonpositive() && other.lower.is_negative() {
            return self.times(&other.negated()).negated();
        }
        // Neither has numbers below 0 alone.
        let down = |a: Dyadic, b: Dyadic| -(-a).times(b);
        let (a, b) = (self, other);
        match (a.is_nonnegative(), b.is_nonnegative()) {
            (true, true) => Interval { lower: down(a.lower, b.lower), upper: a.upper.times(b.upper) },
            (true, false) => Interval { lower: down(b.lower, a.upper), upper: a.upper.times(b.upper) },
            (false, true) => Interval { lower: down(a.lower, b.upper), upper: a.upper.times(b.upper) },
            (false, false) => Interval {
                lower: down(a.lower, b.upper).min(down(b.lower, a.upper)),
                upper: a.upper.times(b.upper).max(a.lower.times(b.lower)),
            },
        }
    }

    /// x²
    pub(super) fn square(&self) -> Interval {
        let (least, largest) = (self.least(), self.largest());
        Interval { lower: -(-least).times(least), upper: largest.times(largest) }
    }

    /// x/y; `None` where y may be 0.
    pub(super) fn over(&self, other: &Interval) -> Option<Interval> {
        if other.upper.is_negative() {
            return self.over(&other.negated()).map(|quotient| quotient.negated());
        }
        let (least, largest) = (other.lower, other.upper);
        let by = |far: bool| if far { largest } else { least };
        least.is_positive().then(|| Interval {
            lower: -(-self.lower).over(by(self.is_nonnegative())),
            upper: self.upper.over(by(self.is_nonpositive())),
        })
    }

    /// √x of the numbers x ≥ 0 of it; `None` if there are none.
    pub(super) fn root(&self) -> Option<Interval> {
        let lower = self.lower.max(Dyadic::ZERO);
        (!self.upper.is_negative()).then(|| Interval { lower: lower.root_down(), upper: self.upper.root() })
    }

    /// The least interval around both.
    pub(super) fn hull(&self, other: &Interval) -> Interval {
        Interval { lower: self.lower.min(other.lower), upper: self.upper.max(other.upper) }
    }

    /// The numbers of both intervals, which have a number in common.
    pub(super) fn meet(&self, other: &Interval) -> Interval {
        Interval { lower: self.lower.max(other.lower), upper: self.upper.min(other.upper) }
    }
}
