//! How far the tangent of a planar PH quintic turns, compared exactly and without transcendental functions.

use std::cmp::Ordering;

use num_integer::Integer;
use num_traits::Signed;

use crate::{Complex, Int, Poly, Rational};

/// Real numbers in which a [`Turning`] is computed: exact ones, or enclosures that may leave a sign unknown.
pub(crate) trait Real: Clone {
    fn plus(&self, other: &Self) -> Self;
    fn minus(&self, other: &Self) -> Self;
    fn times(&self, other: &Self) -> Self;
    fn negated(&self) -> Self;
    /// The nonnegative root of a number that is not negative.
    fn root(&self) -> Self;
    /// The sign, if it is known.
    fn known_sign(&self) -> Option<Ordering>;
}

impl Real for Poly {
    fn plus(&self, other: &Poly) -> Poly {
        self + other
    }

    fn minus(&self, other: &Poly) -> Poly {
        self - other
    }

    fn times(&self, other: &Poly) -> Poly {
        self * other
    }

    fn negated(&self) -> Poly {
        -self
    }

    fn root(&self) -> Poly {
        self.sqrt().unwrap_or_else(Poly::zero)
    }

    fn known_sign(&self) -> Option<Ordering> {
        Some(self.sign())
    }
}

/// A closed interval whose ends are multiples of `2^-bits`: fixed-point numbers, which need no greatest common
/// divisors.
#[derive(Clone, Debug)]
pub(crate) struct Rounded {
    lower: Int,
    upper: Int,
    bits: u64,
}

impl Rounded {
    /// An interval that holds `number`.
    pub(crate) fn new(number: &Poly, bits: u64) -> Rounded {
        let enclosure = number.enclosure(bits);
        let one = Int::ONE.shl(bits);
        let floor = |value: &Rational| (value.numer() * &one).div_floor(value.denom());
        Rounded { lower: floor(enclosure.lower()), upper: -floor(&-enclosure.upper()), bits }
    }

    /// The interval with ends that are multiples of `2^-extra` units, rounded outward.
    fn shifted(&self, lower: &Int, upper: &Int, extra: u64) -> Rounded {
        Rounded { lower: lower.shr(extra), upper: -(-upper).shr(extra), bits: self.bits }
    }

    /// Half of it.
    pub(crate) fn half(&self) -> Rounded {
        self.shifted(&self.lower, &self.upper, 1)
    }
}

impl Real for Rounded {
    fn plus(&self, other: &Rounded) -> Rounded {
        Rounded { lower: &self.lower + &other.lower, upper: &self.upper + &other.upper, bits: self.bits }
    }

    fn minus(&self, other: &Rounded) -> Rounded {
        Rounded { lower: &self.lower - &other.upper, upper: &self.upper - &other.lower, bits: self.bits }
    }

    fn times(&self, other: &Rounded) -> Rounded {
        let [a, b] = [&self.lower, &self.upper].map(|end| (end * &other.lower, end * &other.upper));
        let (lower, upper) = ((&a.0).min(&a.1), (&a.0).max(&a.1));
        let (lower, upper) = (lower.min((&b.0).min(&b.1)), upper.max((&b.0).max(&b.1)));
        self.shifted(lower, upper, self.bits)
    }

    fn negated(&self) -> Rounded {
        Rounded { lower: -&self.upper, upper: -&self.lower, bits: self.bits }
    }

    fn root(&self) -> Rounded {
        // The integer root of a negative number is zero.
        let root = |end: &Int| end.shl(self.bits).isqrt();
        let upper = if self.upper.is_positive() { root(&self.upper) + Int::ONE } else { Int::ZERO };
        Rounded { lower: root(&self.lower), upper, bits: self.bits }
    }

    fn known_sign(&self) -> Option<Ordering> {
        if self.lower.is_positive() {
            Some(Ordering::Greater)
        } else if self.upper.is_negative() {
            Some(Ordering::Less)
        } else if self.lower == self.upper {
            Some(Ordering::Equal)
        } else {
            None
        }
    }
}

/// A vector of the plane, read as a complex number.
#[derive(Clone, Debug)]
pub(crate) struct Planar<N> {
    pub(crate) re: N,
    pub(crate) im: N,
}

impl From<&Complex> for Planar<Poly> {
    fn from(value: &Complex) -> Planar<Poly> {
        Planar { re: value.re.clone(), im: value.im.clone() }
    }
}

impl<N: Real> Planar<N> {
    pub(crate) fn plus(&self, other: &Planar<N>) -> Planar<N> {
        Planar { re: self.re.plus(&other.re), im: self.im.plus(&other.im) }
    }

    fn times(&self, other: &Planar<N>) -> Planar<N> {
        Planar {
            re: self.re.times(&other.re).minus(&self.im.times(&other.im)),
            im: self.re.times(&other.im).plus(&self.im.times(&other.re)),
        }
    }

    fn scaled(&self, factor: &N) -> Planar<N> {
        Planar { re: self.re.times(factor), im: self.im.times(factor) }
    }

    pub(crate) fn negated(&self) -> Planar<N> {
        Planar { re: self.re.negated(), im: self.im.negated() }
    }

    /// `Im(conj(self)·other)`: positive where `other` lies to the left.
    fn cross(&self, other: &Planar<N>) -> N {
        self.re.times(&other.im).minus(&self.im.times(&other.re))
    }

    /// `Re(conj(self)·other)`.
    fn dot(&self, other: &Planar<N>) -> N {
        self.re.times(&other.re).plus(&self.im.times(&other.im))
    }

    /// `conj(self)·other`: the direction of `other` seen from that of `self`.
    fn seen_from(&self, other: &Planar<N>) -> Planar<N> {
        Planar { re: self.dot(other), im: self.cross(other) }
    }
}

/// An angle `π·half_turns + arg(rest)` with `0 ≤ arg(rest) < π`.
#[derive(Clone, Debug)]
struct Angle<N> {
    half_turns: u32,
    rest: Planar<N>,
}

impl<N: Real> Angle<N> {
    /// The argument of `direction`, from 0 up to 2π.
    fn of(direction: Planar<N>) -> Option<Angle<N>> {
        let upper = match direction.im.known_sign()? {
            Ordering::Equal => direction.re.known_sign()?,
            sign => sign,
        };
        Some(if upper.is_gt() {
            Angle { half_turns: 0, rest: direction }
        } else {
            Angle { half_turns: 1, rest: direction.negated() }
        })
    }

    fn plus(&self, other: &Angle<N>) -> Option<Angle<N>> {
        // The arguments of the rests are below π, so that of their product does not wrap.
        let rests = Angle::of(self.rest.times(&other.rest))?;
        Some(Angle { half_turns: self.half_turns + other.half_turns + rests.half_turns, rest: rests.rest })
    }

    fn compare(&self, other: &Angle<N>) -> Option<Ordering> {
        match self.half_turns.cmp(&other.half_turns) {
            Ordering::Equal => other.rest.cross(&self.rest).known_sign(),
            unequal => Some(unequal),
        }
    }
}

/// How much a quadratic preimage `w` turns on (0, 1), without regard to the sense: `∫ |d arg w|`.
///
/// The absolute rotation index of the PH quintic is this angle over π, since its tangent is that of `w²`.
#[derive(Clone, Debug)]
pub(crate) struct Turning<N> {
    /// Whether `w` vanishes nowhere on the interval; if it does, the turning is that of its direction with a common
    /// real factor taken out.
    regular: bool,
    angle: Angle<N>,
}

impl<N: Real> Turning<N> {
    /// The turning of the quadratic with the Bernstein coefficients `w`, of which the first and last are not zero;
    /// `None` if a sign is not known.
    ///
    /// `Im(conj(w)·w')` is the quadratic with the Bernstein coefficients `2·Im(w̄₀w₁)`, `Im(w̄₀w₂)`, `2·Im(w̄₁w₂)`.
    /// By Descartes' rule its sign variations and discriminant tell where on (0, 1) the sense of turning changes;
    /// between these points `arg w` is monotone and changes by less than 2π, because a line through the origin meets
    /// a parabola at most twice.
    pub(crate) fn of(w: &[Planar<N>; 3]) -> Option<Turning<N>> {
        let [w0, w1, w2] = w;
        let double = |x: N| x.plus(&x);
        let b = [double(w0.cross(w1)), w0.cross(w2), double(w1.cross(w2))];
        let mut signs = Vec::new();
        for coefficient in &b {
            signs.push(coefficient.known_sign()?);
        }
        signs.retain(|sign| sign.is_ne());
        let Some(&sense) = signs.first() else { return Turning::straight(w) };
        let variations = signs.windows(2).filter(|pair| pair[0] != pair[1]).count();

        let discriminant = b[1].times(&b[1]).minus(&b[0].times(&b[2]));
        let mut directions = vec![w0.clone()];
        let mut regular = true;
        match variations {
            0 => {}
            1 => directions.push(at_root(w, &b, true, &discriminant)?),
            _ => match discriminant.known_sign()? {
                Ordering::Less => {}
                Ordering::Greater => {
                    directions.push(at_root(w, &b, false, &discriminant)?);
                    directions.push(at_root(w, &b, true, &discriminant)?);
                }
                // A double root inside is a common root of Re w and Im w: w is a real factor, which changes its sign
                // there, times a linear polynomial.
                Ordering::Equal => {
                    regular = false;
                    directions[0] = w0.negated();
                }
            },
        }
        directions.push(w2.clone());

        let mut angle: Option<Angle<N>> = None;
        let mut sense = sense;
        for pair in directions.windows(2) {
            let (from, to) = if sense.is_gt() { (&pair[0], &pair[1]) } else { (&pair[1], &pair[0]) };
            let turn = Angle::of(from.seen_from(to))?;
            angle = Some(match angle {
                Some(sum) => sum.plus(&turn)?,
                None => turn,
            });
            sense = sense.reverse();
        }
        angle.map(|angle| Turning { regular, angle })
    }

    /// A preimage on a line through the origin, which does not turn: `w` is `w₀` times a real quadratic.
    fn straight(w: &[Planar<N>; 3]) -> Option<Turning<N>> {
        let [f0, f1, f2] = [w[0].dot(&w[0]), w[0].dot(&w[1]), w[0].dot(&w[2])];
        let regular = match f2.known_sign()? {
            Ordering::Greater => {
                f1.known_sign()?.is_ge() || f1.times(&f1).minus(&f0.times(&f2)).known_sign()?.is_lt()
            }
            _ => false,
        };
        let rest = Planar { re: f0.clone(), im: f0.minus(&f0) };
        Some(Turning { regular, angle: Angle { half_turns: 0, rest } })
    }

    /// Compares by the angle; a preimage that vanishes somewhere comes after all that do not, since the tangent of its
    /// curve is not defined everywhere. `None` if a sign is not known.
    pub(crate) fn compare(&self, other: &Turning<N>) -> Option<Ordering> {
        match other.regular.cmp(&self.regular) {
            Ordering::Equal => self.angle.compare(&other.angle),
            unequal => Some(unequal),
        }
    }
}

/// The direction of `w` at the greater or smaller positive root `τ = t/(1 − t)` of `b₀ + 2b₁τ + b₂τ²`, of which
/// `discriminant` is a quarter of the discriminant: `w₀ + 2w₁τ + w₂τ²`, times the square of the denominator of τ.
fn at_root<N: Real>(w: &[Planar<N>; 3], b: &[N; 3], greater: bool, discriminant: &N) -> Option<Planar<N>> {
    let [w0, w1, w2] = w;
    let [b0, b1, b2] = b;
    let (numerator, denominator) = match b2.known_sign()? {
        Ordering::Equal => (b0.negated(), b1.plus(b1)),
        sign => {
            let root = discriminant.root();
            let root = if sign.is_gt() == greater { root } else { root.negated() };
            (root.minus(b1), b2.clone())
        }
    };
    let middle = w1.plus(w1).scaled(&numerator.times(&denominator));
    Some(
        w0.scaled(&denominator.times(&denominator))
            .plus(&middle)
            .plus(&w2.scaled(&numerator.times(&numerator))),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integer;

    fn planar(points: [(i64, i64); 3]) -> [Planar<Poly>; 3] {
        points.map(|(re, im)| Planar { re: Poly::integer(re), im: Poly::integer(im) })
    }

    fn turning(points: [(i64, i64); 3]) -> Turning<Poly> {
        Turning::of(&planar(points)).unwrap()
    }

    /// `arg w` summed up over a fine polygon, every step of which turns by much less than a right angle, as a multiple
    /// of π with a direction: the turning of the polygon's vertices.
    fn sampled(points: [(i64, i64); 3]) -> Angle<Poly> {
        const STEPS: i64 = 400;
        let at = |k: i64| {
            let weights = [(STEPS - k) * (STEPS - k), 2 * k * (STEPS - k), k * k];
            let sum = |pick: fn((i64, i64)) -> i64| {
                Poly::integer(weights.iter().zip(points).map(|(weight, point)| weight * pick(point)).sum())
            };
            Planar { re: sum(|point| point.0), im: sum(|point| point.1) }
        };
        let mut total = Angle::of(Planar { re: Poly::one(), im: Poly::zero() }).unwrap();
        for k in 0..STEPS {
            let (from, to) = (at(k), at(k + 1));
            let step = from.seen_from(&to);
            assert!(step.re.sign().is_gt(), "too coarse a polygon");
            let upward = if step.im.sign().is_lt() { Planar { im: -step.im, ..step } } else { step };
            // Rounding the direction keeps its digits few; 2^-60 of a turn is lost at most.
            let rational = |x: &Poly| x.to_rational().unwrap_or_else(|| integer(0));
            let (x, y) = (rational(&upward.re), rational(&upward.im));
            let unit = Rational::from(Int::ONE.shl(60));
            let scale = &unit / (x.abs() + y.abs());
            let direction =
                Planar { re: Poly::constant((x * &scale).round()), im: Poly::constant((y * &scale).round()) };
            total = total.plus(&Angle::of(direction).unwrap()).unwrap();
            let (x, y) = (rational(&total.rest.re), rational(&total.rest.im));
            let scale = &unit / (x.abs() + y.abs());
            total.rest.re = Poly::constant((x * &scale).round());
            total.rest.im = Poly::constant((y * &scale).round());
        }
        total
    }

    #[test]
    fn turnings_agree_with_those_of_fine_polygons() {
        // Of one sense, with one inflection, with two, and around the origin by more than half a turn.
        let preimages = [
            [(1, 0), (1, 1), (0, 1)],
            [(1, 0), (1, 3), (2, -1)],
            [(3, 1), (-2, 3), (4, 1)],
            [(4, 1), (1, -3), (5, 2)],
            [(2, -1), (-9, 1), (3, 4)],
            [(1, 0), (-3, 1), (1, -1)],
            [(1, 0), (-2, 5), (-1, -1)],
            [(1, 0), (0, 2), (0, 2)],
        ];
        for points in preimages {
            let exact = turning(points);
            assert!(exact.regular);
            let polygon = sampled(points);
            // The difference of both is below 2^-10: sin of it is compared, with equal half turns or wrapped by one.
            let difference = polygon.rest.seen_from(&exact.angle.rest);
            let length2 = difference.re.times(&difference.re).plus(&difference.im.times(&difference.im));
            let square = difference.im.times(&difference.im).scale(&integer(1 << 16));
            assert!(square.compare(&length2).is_lt(), "{points:?}");
            let same = difference.re.sign().is_gt();
            let gap = exact.angle.half_turns.abs_diff(polygon.half_turns);
            assert_eq!(gap, u32::from(!same), "{points:?}");
        }
    }

    #[test]
    fn enclosures_agree_with_exact_numbers() {
        let preimages = [[(1, 0), (1, 3), (2, -1)], [(2, -1), (-9, 1), (3, 4)], [(3, 1), (-2, 3), (4, 1)]];
        let rough = |points| {
            let exact = planar(points);
            let round = |z: &Planar<Poly>| Planar {
                re: Rounded::new(&z.re, 80).plus(&Rounded::new(&Poly::sqrt_of(&integer(2)), 80)),
                im: Rounded::new(&z.im, 80),
            };
            let moved = exact.map(|z| Planar { re: z.re + Poly::sqrt_of(&integer(2)), im: z.im });
            let rounded = [0, 1, 2].map(|j| round(&planar(points)[j]));
            (Turning::of(&moved).unwrap(), Turning::of(&rounded).unwrap())
        };
        for a in preimages {
            for b in preimages.iter().filter(|b| **b != a) {
                let ((exact_a, rough_a), (exact_b, rough_b)) = (rough(a), rough(*b));
                assert_eq!(rough_a.compare(&rough_b).unwrap(), exact_a.compare(&exact_b).unwrap());
            }
        }
    }

    #[test]
    fn preimages_through_the_origin_are_not_regular() {
        // (1 − 2t)·(1 + I·t), then real quadratics with a root inside, a double one, and none.
        let through = turning([(2, 0), (0, 1), (-2, -2)]);
        assert!(!through.regular);
        assert_eq!(through.angle.half_turns, 0);
        assert_eq!(
            through.angle.rest.cross(&Planar { re: Poly::one(), im: Poly::one() }).sign(),
            Ordering::Equal
        );
        assert!(!turning([(1, 0), (-4, 0), (1, 0)]).regular);
        assert!(!turning([(1, 0), (-1, 0), (1, 0)]).regular);
        assert!(!turning([(1, 0), (3, 0), (-1, 0)]).regular);
        let straight = turning([(1, 0), (1, 0), (1, 0)]);
        assert!(straight.regular);
        assert_eq!(straight.compare(&through), Some(Ordering::Less));
        assert_eq!(straight.compare(&turning([(1, 0), (1, 0), (1, 1)])), Some(Ordering::Less));
    }
}
