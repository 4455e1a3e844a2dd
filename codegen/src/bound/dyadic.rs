//! Numbers m·2^k with a mantissa of 62 bits, rounded in a known direction: what bounds are computed with.

use std::cmp::Ordering;
use std::ops::Neg;

use hodograph_algebra::{Int, Rational};

/// The number `mantissa`·2^`exponent`, with a mantissa that is 0 or has 62 bits.
///
/// Every operation rounds up; [negation](Neg) is exact, so that −((−a) + (−b)) is rounded down. The relative
/// error of one operation is below 2^-59.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Dyadic {
    mantissa: i64,
    exponent: i32,
}

/// The bits of a mantissa.
const BITS: i32 = 62;

/// The least mantissa above 0.
const LEAST: i64 = 1 << (BITS - 1);

/// The number above all mantissas.
const MOST: i64 = 1 << BITS;

/// Numbers below 2^-LEAST_EXPONENT are rounded to that or to 0.
pub(super) const LEAST_EXPONENT: i32 = 1 << 16;

impl Dyadic {
    /// 0
    pub(super) const ZERO: Dyadic = Dyadic { mantissa: 0, exponent: 0 };

    /// 1
    pub(super) const ONE: Dyadic = Dyadic::power_of_two(0);

    /// 2^`exponent`
    pub(super) const fn power_of_two(exponent: i32) -> Dyadic {
        Dyadic { mantissa: LEAST, exponent: exponent - (BITS - 1) }
    }

    /// The least such number that is not below `mantissa`·2^`exponent`.
    pub(super) fn new(mantissa: i64, exponent: i32) -> Dyadic {
        if mantissa == 0 {
            return Dyadic::ZERO;
        }
        if exponent < -LEAST_EXPONENT {
            let least = Dyadic { mantissa: LEAST, exponent: -LEAST_EXPONENT };
            return if mantissa > 0 { least } else { Dyadic::ZERO };
        }
        let magnitude = if mantissa < 0 { -mantissa } else { mantissa };
        let shift = magnitude.leading_zeros() as i32 - (64 - BITS);
        if shift >= 0 {
            return Dyadic { mantissa: mantissa << shift, exponent: exponent - shift };
        }
        let half = -((-mantissa) >> 1);
        // A mantissa of all ones was rounded up to the next power of two.
        match half == MOST {
            true => Dyadic { mantissa: LEAST, exponent: exponent + 2 },
            false => Dyadic { mantissa: half, exponent: exponent + 1 },
        }
    }

    /// The same, for a mantissa that mostly has 62 bits already.
    fn ready(mantissa: i64, exponent: i32) -> Dyadic {
        let fits = (LEAST..MOST).contains(&if mantissa < 0 { -mantissa } else { mantissa });
        if fits && exponent >= -LEAST_EXPONENT {
            Dyadic { mantissa, exponent }
        } else {
            Dyadic::new(mantissa, exponent)
        }
    }

    /// A number that is not below `value` and, but for a relative error of 2^-60, not above.
    pub(super) fn above(value: &Rational) -> Dyadic {
        let (negative, denominator) = (*value.numer() < Int::ZERO, value.denom());
        let numerator = if negative { -value.numer() } else { value.numer().clone() };
        if numerator == Int::ZERO {
            return Dyadic::ZERO;
        }
        // The quotient has 62 or 63 bits.
        let exponent = numerator.bits() as i64 - denominator.bits() as i64 - i64::from(BITS);
        let bits = exponent.unsigned_abs();
        let (numerator, denominator) = match exponent < 0 {
            true => (numerator.shl(bits), denominator.clone()),
            false => (numerator, denominator.shl(bits)),
        };
        let quotient = &numerator / &denominator;
        let rest = &quotient * &denominator != numerator;
        let floor = quotient.small().unwrap_or(i64::MAX);
        // What is as large as that is refused by whoever asks for the magnitude.
        let exponent = exponent.clamp(-(1 << 20), 1 << 20) as i32;
        match negative {
            true => Dyadic::new(-floor, exponent),
            false => Dyadic::new(floor.saturating_add(i64::from(rest)), exponent),
        }
    }

    /// Whether it is 0.
    pub(super) fn is_zero(self) -> bool {
        self.mantissa == 0
    }

    /// Whether it is above 0.
    pub(super) fn is_positive(self) -> bool {
        self.mantissa > 0
    }

    /// Whether it is below 0.
    pub(super) fn is_negative(self) -> bool {
        self.mantissa < 0
    }

    /// |a|
    pub(super) fn abs(self) -> Dyadic {
        if self.mantissa < 0 { -self } else { self }
    }

    /// ⌊log₂|a|⌋; less than that of any other number for 0.
    pub(super) fn magnitude(self) -> i32 {
        if self.mantissa == 0 { -(1 << 28) } else { self.exponent + (BITS - 1) }
    }

    /// Whether it is ±2^k.
    pub(super) fn is_power_of_two(self) -> bool {
        self.mantissa == LEAST || self.mantissa == -LEAST
    }

    /// k for ±2^k.
    pub(super) fn as_power_of_two(self) -> Option<i32> {
        self.is_power_of_two().then(|| self.magnitude())
    }

    /// a·2^`exponent`
    pub(super) fn scaled(self, exponent: i32) -> Dyadic {
        Dyadic::new(self.mantissa, self.exponent + exponent)
    }

    /// a + b, rounded up.
    pub(super) fn plus(self, other: Dyadic) -> Dyadic {
        if self.mantissa == 0 {
            return other;
        }
        if other.mantissa == 0 {
            return self;
        }
        let (large, small) = if self.exponent >= other.exponent { (self, other) } else { (other, self) };
        let moved = shifted_up(small.mantissa, large.exponent - small.exponent);
        // Both are at most 2^62 − 1 in magnitude.
        Dyadic::ready(large.mantissa + moved, large.exponent)
    }

    /// a·b, rounded up.
    pub(super) fn times(self, other: Dyadic) -> Dyadic {
        if self.mantissa == 0 || other.mantissa == 0 {
            return Dyadic::ZERO;
        }
        // Below 2^124 in magnitude.
        let product = self.mantissa as i128 * other.mantissa as i128;
        let up = -((-product) >> BITS) as i64;
        Dyadic::ready(up, self.exponent + other.exponent + BITS)
    }

    /// a/b, rounded up, for b > 0.
    pub(super) fn over(self, other: Dyadic) -> Dyadic {
        if self.mantissa == 0 {
            return Dyadic::ZERO;
        }
        let numerator = (self.mantissa as i128) << BITS;
        let denominator = other.mantissa.max(1) as i128;
        // Division is toward 0, which is up for negative quotients; quotients are at most 2^63 − 2.
        let quotient = numerator / denominator;
        let rest = self.mantissa > 0 && quotient * denominator != numerator;
        Dyadic::new(quotient as i64 + i64::from(rest), self.exponent - other.exponent - BITS)
    }

    /// √a rounded up, for a ≥ 0.
    pub(super) fn root(self) -> Dyadic {
        let (square, exponent) = self.even();
        let root = square.isqrt();
        Dyadic::new(root as i64 + i64::from(root * root != square), exponent)
    }

    /// √a rounded down, for a ≥ 0.
    pub(super) fn root_down(self) -> Dyadic {
        let (square, exponent) = self.even();
        // The root has 61 or 62 bits, so it is not rounded any more.
        Dyadic::new(square.isqrt() as i64, exponent)
    }

    /// a as s·2^(2k) with an integer s below 2^124: (s, k).
    fn even(self) -> (u128, i32) {
        let odd = self.exponent & 1;
        let shift = BITS - 2 + odd;
        ((self.mantissa.unsigned_abs() as u128) << shift, (self.exponent - shift) >> 1)
    }

    /// The least integer that is not below it, for a ≥ 0; `None` beyond 62 bits.
    pub(super) fn ceiling(self) -> Option<u64> {
        match self.exponent {
            _ if self.mantissa == 0 => Some(0),
            exponent if exponent > 0 => None,
            exponent => Some(shifted_up(self.mantissa, -exponent).unsigned_abs()),
        }
    }

    /// The least `f64` that is not below it; +∞ beyond the range.
    pub(super) fn to_f64(self) -> f64 {
        if self.mantissa < 0 {
            let below = (-self).to_f64_toward_zero();
            return f64::from_bits(below.to_bits() | 1 << 63);
        }
        let below = self.to_f64_toward_zero();
        if Dyadic::of(below) == Some(self) { below } else { below.next_up() }
    }

    /// The `f64` next to a ≥ 0 that is not above it.
    fn to_f64_toward_zero(self) -> f64 {
        let magnitude = self.magnitude();
        if self.mantissa == 0 {
            return f64::from_bits(0);
        }
        if magnitude > 1023 {
            return f64::MAX;
        }
        // One unit in the last place is 2^unit.
        let unit = (magnitude - 52).max(-1074);
        let shift = unit - self.exponent;
        let significand = if shift > 63 { 0 } else { self.mantissa.unsigned_abs() >> shift };
        // The leading bit of a normal number carries into the exponent's field.
        f64::from_bits((((unit + 1074) as u64) << 52) + significand)
    }

    /// The number that a float is; `None` for infinities and NaN.
    pub(super) fn of(float: f64) -> Option<Dyadic> {
        let (field, fraction) = (float.to_bits() >> 52 & 0x7ff, float.to_bits() & ((1 << 52) - 1));
        let significand = if field == 0 { fraction } else { fraction | 1 << 52 } as i64;
        let signed = if float.is_sign_negative() { -significand } else { significand };
        float.is_finite().then(|| Dyadic::new(signed, field.max(1) as i32 - 1075))
    }

    /// The larger of two.
    pub(super) fn max(self, other: Dyadic) -> Dyadic {
        if self.is_below(other) { other } else { self }
    }

    /// The smaller of two.
    pub(super) fn min(self, other: Dyadic) -> Dyadic {
        if other.is_below(self) { other } else { self }
    }

    /// Whether a < b; in builds without optimization much faster than the operator.
    pub(super) fn is_below(self, other: Dyadic) -> bool {
        let (a, b) = (self.mantissa, other.mantissa);
        if self.exponent == other.exponent || (a > 0) != (b > 0) || a == 0 || b == 0 {
            return a < b;
        }
        (self.exponent < other.exponent) == (a > 0)
    }
}

/// ⌈m / 2^shift⌉
fn shifted_up(mantissa: i64, shift: i32) -> i64 {
    if shift > 63 { i64::from(mantissa > 0) } else { -((-mantissa) >> shift) }
}

impl Neg for Dyadic {
    type Output = Dyadic;

    fn neg(self) -> Dyadic {
        Dyadic { mantissa: -self.mantissa, exponent: self.exponent }
    }
}

impl Ord for Dyadic {
    fn cmp(&self, other: &Dyadic) -> Ordering {
        match (self.is_below(*other), other.is_below(*self)) {
            (true, _) => Ordering::Less,
            (_, true) => Ordering::Greater,
            _ => Ordering::Equal,
        }
    }
}

impl PartialOrd for Dyadic {
    fn partial_cmp(&self, other: &Dyadic) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

#[cfg(test)]
mod tests {
    use hodograph_algebra::{Int, Rational, integer, ratio};
    use proptest::prelude::*;

    use super::Dyadic;
    use crate::round;

    fn exact(number: Dyadic) -> Rational {
        let power = Rational::from(Int::from(1).shl(u64::from(number.exponent.unsigned_abs())));
        let mantissa = Rational::from(Int::from(number.mantissa));
        if number.exponent < 0 { mantissa / power } else { mantissa * power }
    }

    fn absolute(number: Rational) -> Rational {
        if number < integer(0) { -number } else { number }
    }

    /// Whether `rounded` is not below `number` and above it by a part 2^-58 of `scale` at most.
    fn is_above(rounded: Dyadic, number: &Rational, scale: &Rational) -> bool {
        let difference = exact(rounded) - number;
        let fits = (1 << 61..1 << 62).contains(&rounded.mantissa.abs()) || rounded.is_zero();
        fits && difference >= integer(0) && difference <= absolute(scale.clone()) * ratio(1, 1 << 58)
    }

    fn dyadic() -> impl Strategy<Value = Dyadic> {
        let mantissas =
            prop_oneof![any::<i64>(), -20_i64..20, Just(i64::MAX), Just(-i64::MAX), Just(1 << 61)];
        (mantissas, -130_i32..130)
            .prop_map(|(mantissa, exponent)| Dyadic::new(mantissa.max(-i64::MAX), exponent))
    }

    proptest! {
        #[test]
        fn results_are_rounded_up(a in dyadic(), b in dyadic()) {
            let (x, y) = (exact(a), exact(b));
            prop_assert!(is_above(a.plus(b), &(&x + &y), &(absolute(x.clone()) + absolute(y.clone()))));
            prop_assert!(is_above(a.times(b), &(&x * &y), &(&x * &y)));
            if b.is_positive() {
                prop_assert!(is_above(a.over(b), &(&x / &y), &(&x / &y)));
                let square = |root: Dyadic| exact(root) * exact(root);
                let (above, below) = (square(b.root()), square(b.root_down()));
                prop_assert!(below <= y && y <= above && above - below <= &y * ratio(1, 1 << 57));
            }
            prop_assert_eq!(a.cmp(&b), x.cmp(&y));
            prop_assert_eq!(exact(a.max(b)), x.clone().max(y.clone()));
            prop_assert_eq!(exact(a.min(b)), x.clone().min(y));
            prop_assert_eq!(exact(-a), -x);
        }

        #[test]
        fn rational_numbers_are_rounded_up(numerator in any::<i64>(), denominator in 1_i64..i64::MAX, power in 0_u64..300) {
            for value in [ratio(numerator.max(-i64::MAX), denominator), ratio(numerator.max(-i64::MAX), 3)] {
                let power = Rational::from(Int::from(1).shl(power));
                for value in [&value * &power, &value / &power] {
                    prop_assert!(is_above(Dyadic::above(&value), &value, &value));
                }
            }
        }

        #[test]
        fn floats_are_the_next_above(a in dyadic(), shift in -1100_i32..1000, bits in any::<u64>()) {
            let number = a.scaled(shift);
            let float = number.to_f64();
            if float.is_finite() {
                let (value, float) = (exact(number), float);
                prop_assert!(round::exact(float).unwrap() >= value);
                let below = float.next_down();
                prop_assert!(round::exact(below).is_none_or(|below| below < value));
            } else {
                prop_assert!(number.magnitude() >= 1023);
            }
            let float = f64::from_bits(bits);
            if let Some(number) = Dyadic::of(float) {
                prop_assert_eq!(exact(number), round::exact(float).unwrap());
                prop_assert_eq!(number.to_f64(), float);
            }
        }
    }

    #[test]
    fn ceilings_and_powers() {
        let ceiling = |numerator, denominator| Dyadic::above(&ratio(numerator, denominator)).ceiling();
        assert_eq!(
            [ceiling(0, 1), ceiling(1, 3), ceiling(7, 2), ceiling(8, 1)],
            [Some(0), Some(1), Some(4), Some(8)]
        );
        assert_eq!(Dyadic::power_of_two(80).ceiling(), None);
        assert_eq!(Dyadic::above(&ratio(1, 8)).as_power_of_two(), Some(-3));
        assert_eq!(Dyadic::above(&ratio(3, 8)).as_power_of_two(), None);
        assert_eq!(Dyadic::power_of_two(-3), Dyadic::above(&ratio(1, 8)));
        assert_eq!(Dyadic::above(&ratio(-5, 3)).magnitude(), 0);
        assert_eq!(Dyadic::power_of_two(5000).to_f64(), f64::INFINITY);
    }
}
