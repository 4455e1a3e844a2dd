//! The exact values that an operation gives on a box.

use super::affine::Affine;
use super::dyadic::Dyadic;
use super::interval::Interval;

/// The exact values that an operand takes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) range: Interval,
    /// max |x|
    pub(super) largest: Dyadic,
    /// min |x|
    pub(super) least: Dyadic,
    /// How the values depend on the parameters.
    pub(super) affine: Affine,
}

impl Place {
    /// The values of a form that lie in an interval as well.
    pub(super) fn new(interval: &Interval, affine: Affine) -> Place {
        let range = interval.meet(&affine.range());
        Place { range, largest: range.largest(), least: range.least(), affine: affine.or(&range) }
    }

    /// The values of an interval.
    pub(super) fn of(interval: &Interval) -> Place {
        Place::new(interval, Affine::of(interval))
    }

    /// With −x in place of the values.
    pub(super) fn negated(&self) -> Place {
        Place { range: self.range.negated(), affine: self.affine.negated(), ..*self }
    }

    /// With x + y in place of the values.
    pub(super) fn plus(&self, other: &Place) -> Place {
        Place::new(&self.range.plus(&other.range), self.affine.plus(&other.affine))
    }

    /// With x·y in place of the values.
    pub(super) fn times(&self, other: &Place) -> Place {
        Place::new(&self.range.times(&other.range), self.affine.times(&other.affine))
    }

    /// With x² in place of the values.
    pub(super) fn square(&self) -> Place {
        Place::new(&self.range.square(), self.affine.square())
    }

    /// With x/y in place of the values; `None` where y may be 0.
    pub(super) fn over(&self, other: &Place) -> Option<Place> {
        if other.range.upper.is_negative() {
            return self.negated().over(&other.negated());
        }
        let range = self.range.over(&other.range)?;
        Some(match other.affine.inverse(other.least) {
            Some(inverse) => Place::new(&range, self.affine.times(&inverse)),
            None => Place::of(&range),
        })
    }

    /// With √x in place of the values; `None` where there is none.
    pub(super) fn root(&self) -> Option<Place> {
        let range = self.range.root()?;
        Some(match self.affine.root(self.range.lower.max(Dyadic::ZERO)) {
            Some(root) => Place::new(&range, root),
            None => Place::of(&range),
        })
    }

    /// The values of either place, if the box is made of two boxes; `self` is what is known of them together.
    pub(super) fn within(&self, first: &Place, second: &Place) -> Place {
        Place::new(&self.range.meet(&first.range.hull(&second.range)), self.affine)
    }
}
