//! Proved bounds on rounding errors at run time, for surfaces whose coefficients are not known before.
//!
//! Evaluators are generic over the numbers that they compute with. Over [`Tracked`] numbers they compute, for all parameters of a
//! rectangle at once, where exact results lie and how far computed ones may be from them.

use core::marker::PhantomData;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::dispatch::Variant;
use crate::real::{Float, Real};
use crate::surface::Domain;
use crate::task::{Part, Stages, Sweep, Task, convert};

/// A set of numbers that a precision `F` computes in a variant, fused or not: their exact values, and how far the computed ones
/// are from them.
///
/// The bounds themselves are computed in `f64`, each rounded away from what it bounds.
#[derive(Clone, Copy, Debug)]
struct Tracked<F, const FUSED: bool> {
    /// The least exact value.
    low: f64,
    /// The greatest exact value.
    high: f64,
    /// At least |computed − exact|; infinite where nothing is known.
    error: f64,
    precision: PhantomData<F>,
}

/// A proved bound on a number that an evaluator computes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NumberBound {
    /// |computed − exact| is no greater, for all parameters that are floats in the rectangle; infinite if no bound was proved.
    pub error: f64,
    /// The exact number is no greater in absolute value; infinite if no bound was proved.
    pub magnitude: f64,
}

impl Default for NumberBound {
    fn default() -> Self {
        Self { error: 0.0, magnitude: 0.0 }
    }
}

impl NumberBound {
    const UNPROVED: Self = Self { error: f64::INFINITY, magnitude: f64::INFINITY };

    /// Whether there is a bound.
    #[must_use]
    pub fn is_proved(&self) -> bool {
        self.error.is_finite()
    }

    fn max(self, other: Self) -> Self {
        Self { error: self.error.max(other.error), magnitude: self.magnitude.max(other.magnitude) }
    }
}

/// Proves bounds on the rounding errors of a task over a rectangle of parameters, for each of its numbers.
///
/// Exact numbers are those of the formulas with the surface's coefficients as they are stored, in `f64`: that is what evaluators
/// of a [family](crate::family) are given. The rectangle is halved `depth` times in both directions, which makes bounds
/// tighter, and where something is not yet proved up to 6 times more; the work is that of 4^`depth` evaluations, about a hundred
/// times slower than floats. Numbers that are not defined everywhere in the rectangle, or all but, have no bound: their error is
/// infinite.
///
/// Parameters are exact; those of single precision are among those of the rectangle.
#[must_use]
pub fn error_bounds<T: Task, F: Float>(
    surface: &(impl Sweep + Stages<T>),
    _: T,
    variant: Variant,
    rectangle: Domain,
    depth: u32,
) -> T::Values<NumberBound> {
    let mut bounds = T::Values::of(|_| NumberBound::default());
    match variant {
        Variant::Plain => cover::<T, _, Tracked<F, false>>(surface, rectangle, depth, EXTRA, &mut bounds),
        Variant::Fused => cover::<T, _, Tracked<F, true>>(surface, rectangle, depth, EXTRA, &mut bounds),
    }
    bounds
}

/// How often rectangles without a proof are halved beyond what was asked for.
const EXTRA: u32 = 6;

/// Numbers that bounds are read from.
trait Bounding: Real {
    fn between(ends: [f64; 2]) -> Self;
    fn bound(self) -> NumberBound;
}

fn cover<T: Task, S: Stages<T>, R: Bounding>(
    surface: &S,
    Domain { u, v }: Domain,
    depth: u32,
    extra: u32,
    bounds: &mut T::Values<NumberBound>,
) {
    let mut split = depth > 0;
    if !split {
        let of_u = surface.of_u(R::between(u));
        let of_v = surface.of_v(R::between(v));
        let found: T::Values<NumberBound> = convert(surface.join(of_u, of_v), R::bound);
        // What is known not to be bounded somewhere does not get better elsewhere.
        let open = |k| !found.get(k).is_proved() && bounds.get(k).is_proved();
        split = extra > 0 && (0..<T::Values<NumberBound> as Part<NumberBound>>::LENGTH).any(open);
        if !split {
            *bounds = T::Values::of(|k| bounds.get(k).max(found.get(k)));
        }
    }
    if split {
        let (depth, extra) = if depth > 0 { (depth - 1, extra) } else { (0, extra - 1) };
        let halves = |[first, last]: [f64; 2]| {
            let middle = 0.5 * (first + last);
            [[first, middle], [middle, last]]
        };
        for u in halves(u) {
            for v in halves(v) {
                cover::<T, S, R>(surface, Domain { u, v }, depth, extra, bounds);
            }
        }
    }
}

impl<F: Float, const FUSED: bool> Tracked<F, FUSED> {
    const UNKNOWN: Self =
        Self { low: f64::NEG_INFINITY, high: f64::INFINITY, error: f64::INFINITY, precision: PhantomData };

    /// At least |exact|.
    fn magnitude(self) -> f64 {
        self.low.abs().max(self.high.abs())
    }

    /// An exact range and an error before rounding, if everything is in the range of the precision.
    fn unrounded(low: f64, high: f64, error: f64) -> Self {
        let result = Self { low, high, error, precision: PhantomData };
        // NaN is not less than anything.
        if up(result.magnitude() + error) < F::LARGEST { result } else { Self::UNKNOWN }
    }

    /// The same after a rounding.
    fn rounded(self) -> Self {
        let unit = up(up(self.magnitude() + self.error) * F::UNIT_ROUNDOFF);
        Self::unrounded(self.low, self.high, up(up(self.error + unit) + Self::UNDERFLOW))
    }

    /// What underflow may add to the error of an operation, even after a scaling by powers of two that differ a little from
    /// those that are taken here.
    const UNDERFLOW: f64 = F::SMALLEST * 65536.0;

    /// The exact range and error of a sum.
    fn sum(self, other: Self) -> Self {
        Self::unrounded(down(self.low + other.low), up(self.high + other.high), up(self.error + other.error))
    }

    /// The exact range and error of a product.
    fn product(self, other: Self) -> Self {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for a in [self.low, self.high] {
            for b in [other.low, other.high] {
                low = low.min(down(a * b));
                high = high.max(up(a * b));
            }
        }
        let of_self = up(self.error * up(other.magnitude() + other.error));
        Self::unrounded(low, high, up(of_self + up(self.magnitude() * other.error)))
    }

    fn is_known(self) -> bool {
        self.error < f64::INFINITY
    }
}

/// The next float, or the float after it: above the exact result of which `x` is the rounded one.
fn up(x: f64) -> f64 {
    x.next_up()
}

/// Below the exact result of which `x` is the rounded one.
fn down(x: f64) -> f64 {
    x.next_down()
}

impl<F: Float, const FUSED: bool> Default for Tracked<F, FUSED> {
    fn default() -> Self {
        Self { low: 0.0, high: 0.0, error: 0.0, precision: PhantomData }
    }
}

impl<F: Float, const FUSED: bool> Bounding for Tracked<F, FUSED> {
    fn between([low, high]: [f64; 2]) -> Self {
        Self::unrounded(low, high, 0.0)
    }

    fn bound(self) -> NumberBound {
        if self.is_known() {
            NumberBound { error: self.error, magnitude: self.magnitude() }
        } else {
            NumberBound::UNPROVED
        }
    }
}

impl<F: Float, const FUSED: bool> Add for Tracked<F, FUSED> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.sum(other).rounded()
    }
}

impl<F: Float, const FUSED: bool> Sub for Tracked<F, FUSED> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<F: Float, const FUSED: bool> Mul for Tracked<F, FUSED> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        self.product(other).rounded()
    }
}

impl<F: Float, const FUSED: bool> Div for Tracked<F, FUSED> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        if other.high < 0.0 {
            return -self / -other;
        }
        // ã/b̃ − a/b = ((ã − a) − (b̃ − b)·a/b)/b̃
        let least = down(other.low - other.error);
        if !(least > 0.0 && other.is_known()) {
            return Self::UNKNOWN;
        }
        let low = if self.low < 0.0 { self.low / other.low } else { self.low / other.high };
        let high = if self.high < 0.0 { self.high / other.high } else { self.high / other.low };
        let quotient = Self::unrounded(down(low), up(high), 0.0);
        let error = up(up(self.error + up(quotient.magnitude() * other.error)) / least);
        Self::unrounded(quotient.low, quotient.high, error).rounded()
    }
}

impl<F: Float, const FUSED: bool> Neg for Tracked<F, FUSED> {
    type Output = Self;

    fn neg(self) -> Self {
        Self { low: -self.high, high: -self.low, ..self }
    }
}

impl<F: Float, const FUSED: bool> Real for Tracked<F, FUSED> {
    fn of(constant: f64) -> Self {
        let error = (F::of(constant).to_f64() - constant).abs();
        Self::unrounded(constant, constant, if error > 0.0 { up(error) } else { error })
    }

    fn mul_add(self, b: Self, c: Self) -> Self {
        if FUSED { self.product(b).sum(c).rounded() } else { self * b + c }
    }

    fn sqrt(self) -> Self {
        // |√ã − √a| = |ã − a|/(√ã + √a)
        let least = down(self.low - self.error);
        if !(least > 0.0 && self.is_known()) {
            return Self::UNKNOWN;
        }
        let (low, high) = (down(Float::sqrt(self.low)), up(Float::sqrt(self.high)));
        let error = up(self.error / down(low + down(Float::sqrt(least))));
        Self::unrounded(low, high, error).rounded()
    }

    fn orient(self, by: Self) -> Self {
        if by.is_known() && down(by.low - by.error) > 0.0 {
            self
        } else if by.is_known() && up(by.high + by.error) < 0.0 {
            -self
        } else {
            Self::UNKNOWN
        }
    }

    fn scale(a: Self, b: Self, c: Self) -> Self {
        // Whatever is scaled is divided by its norm later: the scale of the largest values may stand for all scales that differ from
        // it by few powers of two, of which only underflow can tell.
        let numbers = [a, b, c];
        let most = numbers.iter().fold(0.0, |most: f64, x| most.max(up(x.magnitude() + x.error)));
        let least = |x: &Self| down(x.low.max(-x.high) - x.error);
        let least = numbers.iter().map(least).fold(0.0, f64::max);
        let power = most.normalizer();
        if !(numbers.iter().all(|x| x.is_known()) && least > most / 16.0 && least > F::SMALLEST * 1e12) {
            return Self::UNKNOWN;
        }
        Self::unrounded(power, power, 0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::error_bounds;
    use crate::dispatch::Variant;
    use crate::surface::{Domain, Surface};
    use crate::task::{First, Local, Normal, Part, Point, Separated, Sweep};
    use crate::testing::Cone;

    const RECTANGLE: Domain = Domain { u: [0.0, 0.5], v: [0.25, 1.0] };

    fn parameters() -> impl Iterator<Item = (f32, f32)> {
        (0..500_u16).map(|k| {
            let (s, t) = (f32::from(k % 47) / 46.0, f32::from(k % 43) / 42.0);
            (0.5 * s, 0.25 + 0.75 * t)
        })
    }

    /// The largest error of single precision, as double precision sees it, relative to its bound.
    fn largest<const N: usize>(
        variant: Variant,
        bounds: [super::NumberBound; N],
        single: impl Fn(f32, f32) -> [f32; N],
        double: impl Fn(f64, f64) -> [f64; N],
    ) -> f64 {
        let mut ratio: f64 = 0.0;
        for (u, v) in parameters() {
            let (found, exact) = (single(u, v), double(u.into(), v.into()));
            for k in 0..N {
                assert!(exact[k].abs() <= bounds[k].magnitude * (1.0 + 1e-12), "{variant:?} {k}");
                let error = (f64::from(found[k]) - exact[k]).abs();
                if error > 0.0 {
                    ratio = ratio.max(error / bounds[k].error);
                }
            }
        }
        ratio
    }

    #[test]
    fn bounds_hold_and_are_no_luxury() {
        for variant in [Variant::Plain, Variant::Fused] {
            let s = Cone.pinned(variant);
            let bounds = error_bounds::<_, f32>(&s, Point, variant, RECTANGLE, 4);
            let ratio =
                largest(variant, bounds, |u, v| s.point(u, v).unwrap(), |u, v| s.point(u, v).unwrap());
            assert!(ratio > 0.1 && ratio < 1.0, "{ratio}");
            let bounds = error_bounds::<_, f32>(&s, First, variant, RECTANGLE, 4);
            let numbers = |u: f32, v: f32| s.first_order(u, v).unwrap().numbers();
            let ratio = largest(variant, bounds, numbers, |u, v| s.first_order(u, v).unwrap().numbers());
            assert!(ratio > 0.1 && ratio < 1.0, "{ratio}");
            let bounds = error_bounds::<_, f32>(&s, Normal, variant, RECTANGLE, 4);
            let ratio = largest(
                variant,
                bounds,
                |u, v| s.unit_normal(u, v).unwrap(),
                |u, v| s.unit_normal(u, v).unwrap(),
            );
            assert!(ratio > 0.05 && ratio < 1.0, "{ratio}");
            let bounds = error_bounds::<_, f32>(&s, Local, variant, RECTANGLE, 4);
            let numbers = |u: f32, v: f32| s.local_geometry(u, v).unwrap().numbers();
            let ratio = largest(variant, bounds, numbers, |u, v| s.local_geometry(u, v).unwrap().numbers());
            assert!(ratio > 0.01 && ratio < 1.0, "{ratio}");
        }
    }

    #[test]
    fn bounds_shrink_with_the_precision_and_the_boxes() {
        let of = |depth| error_bounds::<_, f64>(&Cone, Separated, Variant::Plain, RECTANGLE, depth);
        let single = error_bounds::<_, f32>(&Cone, Separated, Variant::Plain, RECTANGLE, 3);
        for ((rough, fine), single) in of(0).iter().zip(of(3)).zip(single) {
            assert!(rough.error >= fine.error && fine.error < 1e-14);
            let ratio = single.error / fine.error;
            assert!((ratio / f64::from(1 << 29) - 1.0).abs() < 1e-3, "{ratio}");
        }
    }

    #[test]
    fn nothing_is_proved_where_something_is_undefined() {
        let poles = Domain { u: [0.5, 1.5], v: [0.25, 1.0] };
        let bounds = error_bounds::<_, f64>(&Cone, Point, Variant::Fused, poles, 2);
        assert!(bounds.iter().all(|bound| !bound.is_proved()));
        let singular = Domain { u: [0.0, 0.5], v: [-1.0, 1.0] };
        let bounds = error_bounds::<_, f64>(&Cone, Normal, Variant::Fused, singular, 2);
        assert!(bounds.iter().all(|bound| !bound.is_proved()));
        let bounds = error_bounds::<_, f64>(&Cone, Point, Variant::Fused, singular, 2);
        assert!(bounds.iter().all(|bound| bound.is_proved()));
        let far = Domain { u: [0.0, 0.5], v: [0.0, 1e20] };
        assert!(!error_bounds::<_, f32>(&Cone, Point, Variant::Plain, far, 2).get(1).is_proved());
        assert!(error_bounds::<_, f64>(&Cone, Point, Variant::Plain, far, 2).get(1).is_proved());
    }
}
