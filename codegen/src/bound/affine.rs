//! Values on a box as linear functions of the parameters, up to a remainder.
//!
//! Intervals forget that the values in them are functions of the same parameters; affine forms keep the linear
//! part of that, so that what they enclose is too wide by the square of a box's width alone (Stolfi and de
//! Figueiredo, *Self-Validated Numerical Methods and Applications*, 1997, chapter 3).

use super::dyadic::{self, Dyadic};
use super::interval::Interval;

/// All x with |x − center − u·ε − v·δ| ≤ `rest` for the parameters' places −1 ≤ ε, δ ≤ 1 on a box.
#[derive(Clone, Copy, Debug)]
pub(super) struct Affine {
    center: Dyadic,
    u: Dyadic,
    v: Dyadic,
    rest: Dyadic,
    /// |u| + |v| + rest
    extent: Dyadic,
}

/// The terms of a form are each computed with at most eight operations, whose relative errors are below 2^-59.
const SLACK: i32 = -55;

/// a/2, rounded up.
fn half(a: Dyadic) -> Dyadic {
    a.scaled(-1)
}

impl Affine {
    /// The form of these terms, which were computed from numbers below 2^(`magnitude` + 1).
    fn new(center: Dyadic, u: Dyadic, v: Dyadic, rest: Dyadic, magnitude: i32) -> Affine {
        // Nothing below the least exponent is told from 0; far below it, all terms are 0.
        let least = -dyadic::LEAST_EXPONENT;
        let slack = match magnitude < 8 * least {
            true => Dyadic::ZERO,
            false => Dyadic::power_of_two((magnitude + SLACK).max(least + 4)),
        };
        let rest = rest.plus(slack);
        Affine { center, u, v, rest, extent: u.abs().plus(v.abs()).plus(rest) }
    }

    /// The form of an interval without dependence on the parameters.
    pub(super) fn of(interval: &Interval) -> Affine {
        let center = half(interval.lower.plus(interval.upper));
        let rest = interval.upper.plus(-center).max(center.plus(-interval.lower));
        Affine { center, u: Dyadic::ZERO, v: Dyadic::ZERO, rest, extent: rest }
    }

    /// The form of a parameter that runs over an interval: the first one or the second one.
    pub(super) fn parameter(interval: &Interval, first: bool) -> Affine {
        let Affine { center, rest, extent, .. } = Affine::of(interval);
        let (u, v) = if first { (rest, Dyadic::ZERO) } else { (Dyadic::ZERO, rest) };
        Affine { u, v, rest: Dyadic::ZERO, center, extent }
    }

    /// The numbers of the form.
    pub(super) fn range(&self) -> Interval {
        Interval { lower: -(-self.center).plus(self.extent), upper: self.center.plus(self.extent) }
    }

    /// max |x| is below 2^(this + 1).
    fn magnitude(&self) -> i32 {
        self.center.magnitude().max(self.extent.magnitude()) + 1
    }

    /// −x
    pub(super) fn negated(&self) -> Affine {
        Affine { center: -self.center, u: -self.u, v: -self.v, ..*self }
    }

    /// x + y
    pub(super) fn plus(&self, other: &Affine) -> Affine {
        let rest = self.rest.plus(other.rest);
        let magnitude = self.magnitude().max(other.magnitude()) + 1;
        let (u, v) = (self.u.plus(other.u), self.v.plus(other.v));
        Affine::new(self.center.plus(other.center), u, v, rest, magnitude)
    }

    /// x·y
    pub(super) fn times(&self, other: &Affine) -> Affine {
        let (a, b) = (self.center, other.center);
        let u = a.times(other.u).plus(b.times(self.u));
        let v = a.times(other.v).plus(b.times(self.v));
        let mut rest = self.extent.times(other.extent);
        rest = rest.plus(a.abs().times(other.rest)).plus(b.abs().times(self.rest));
        Affine::new(a.times(b), u, v, rest, self.magnitude() + other.magnitude() + 2)
    }

    /// x²
    pub(super) fn square(&self) -> Affine {
        let a = self.center;
        let twice = a.scaled(1);
        // The square of the deviation is between 0 and this.
        let square = self.extent.times(self.extent);
        let rest = half(square).plus(twice.abs().times(self.rest));
        let center = a.times(a).plus(half(square));
        Affine::new(center, twice.times(self.u), twice.times(self.v), rest, 2 * self.magnitude() + 2)
    }

    /// 1/x for x ≥ `least` > 0; `None` if the middle of the form is not above 0.
    pub(super) fn inverse(&self, least: Dyadic) -> Option<Affine> {
        if !self.center.is_positive() || !least.is_positive() {
            return None;
        }
        // 1/x = 1/c − (x − c)/c² + (x − c)²/(c²·x)
        let center = Dyadic::ONE.over(self.center);
        let slope = center.times(center);
        let remainder = self.extent.times(self.extent).times(slope).over(least);
        let (u, v) = ((-self.u).times(slope), (-self.v).times(slope));
        let rest = half(remainder).plus(self.rest.times(slope));
        let magnitude = center.magnitude().max(u.magnitude()).max(v.magnitude()).max(rest.magnitude()) + 2;
        Some(Affine::new(center.plus(half(remainder)), u, v, rest, magnitude))
    }

    /// √x for x ≥ `least` ≥ 0; `None` if the middle of the form is not above 0.
    pub(super) fn root(&self, least: Dyadic) -> Option<Affine> {
        if !self.center.is_positive() {
            return None;
        }
        // √x = √c + (x − c)/(2√c) − (x − c)²/(2√c·(√c + √x)²)
        let center = self.center.root();
        let slope = Dyadic::ONE.over(center.scaled(1));
        let low = -(-self.center.root_down()).plus(-least.root_down());
        let square = -(-low).times(low);
        let remainder = self.extent.times(self.extent).times(slope).over(square);
        let (u, v) = (self.u.times(slope), self.v.times(slope));
        let rest = half(remainder).plus(self.rest.times(slope));
        let magnitude = center.magnitude().max(u.magnitude()).max(v.magnitude()).max(rest.magnitude()) + 2;
        Some(Affine::new(center.plus(-half(remainder)), u, v, rest, magnitude))
    }

    /// The form, or that of an interval that holds the same values, if that is much narrower.
    pub(super) fn or(self, interval: &Interval) -> Affine {
        let width = interval.upper.plus(-interval.lower);
        if width.is_below(self.extent) { Affine::of(interval) } else { self }
    }
}

#[cfg(test)]
mod tests {
    use hodograph_algebra::{Rational, ratio};
    use proptest::prelude::*;

    use super::Affine;
    use crate::bound::dyadic::Dyadic;
    use crate::bound::interval::Interval;
    use crate::bound::place::Place;

    fn interval(lower: &Rational, upper: &Rational) -> Interval {
        Interval { lower: -Dyadic::above(&-lower), upper: Dyadic::above(upper) }
    }

    fn contains(place: &Place, value: &Rational) -> bool {
        let point = interval(value, value);
        let is_within = |around: &Interval| around.lower <= point.upper && point.lower <= around.upper;
        is_within(&place.range) && is_within(&place.affine.range())
    }

    proptest! {
        /// Places of random expressions of u and v hold the exact values at points of the box.
        #[test]
        fn places_hold_the_values(
            starts in [-8_i64..8, -8_i64..8],
            widths in [0_i64..9, 0_i64..9],
            at in [0_i64..17, 0_i64..17],
            recipe in prop::collection::vec((0_u8..6, 0_usize..5, 0_usize..5), 1..12),
        ) {
            let mut places = Vec::new();
            let mut values = Vec::new();
            for k in 0..2 {
                let (lower, upper) = (ratio(starts[k], 4), ratio(starts[k], 4) + ratio(widths[k], 7));
                let range = interval(&lower, &upper);
                places.push(Place::new(&range, Affine::parameter(&range, k == 0)));
                values.push(&lower + (upper - &lower) * ratio(at[k], 16));
            }
            for (kind, a, b) in recipe {
                let back = |back: usize| places.len() - 1 - back % places.len();
                let (a, b) = (back(a), back(b));
                let (place, value) = match kind {
                    0 => (Some(places[a].plus(&places[b])), Some(&values[a] + &values[b])),
                    1 => (Some(places[a].times(&places[b])), Some(&values[a] * &values[b])),
                    2 => (Some(places[a].square()), Some(&values[a] * &values[a])),
                    3 => (Some(places[a].negated()), Some(-&values[a])),
                    4 => (places[a].over(&places[b]), None),
                    // The root of a square is the absolute value.
                    _ => (places[a].square().root(), Some(values[a].clone().max(-&values[a]))),
                };
                let Some(place) = place else { continue };
                let value = value.unwrap_or_else(|| &values[a] / &values[b]);
                prop_assert!(contains(&place, &value));
                places.push(place);
                values.push(value);
            }
        }
    }

    #[test]
    fn differences_of_equal_values_are_narrow() {
        let range = interval(&ratio(1, 1), &ratio(9, 8));
        let u = Place::new(&range, Affine::parameter(&range, true));
        let width = |place: &Place| place.range.upper.plus(-place.range.lower);
        assert!(width(&u.plus(&u.negated())) < Dyadic::power_of_two(-50));
        // u·(1/u) and √u·√u − u
        let one = Place::of(&Interval::point(Dyadic::ONE)).over(&u).unwrap().times(&u);
        assert!(width(&one) < Dyadic::power_of_two(-6));
        let root = u.root().unwrap();
        assert!(width(&root.square().plus(&u.negated())) < Dyadic::power_of_two(-8));
    }
}
