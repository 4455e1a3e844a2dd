//! Balls around multiples of a small power of two: fast enclosures for many points.

use hodograph_algebra::{Enclosure, Int, Rational};
use hodograph_codegen::round::exact;
use num_bigint::BigInt;
use num_traits::{FromPrimitive, Signed, ToPrimitive, Zero};

/// The bits after the point.
pub const BITS: u64 = 320;

/// The real numbers that are no farther than `radius`·2⁻³²⁰ from `center`·2⁻³²⁰; all operations enlarge the radius by what they
/// round.
#[derive(Clone, Debug)]
pub struct Fixed {
    center: BigInt,
    radius: f64,
}

/// A number that is not below the exact value of a short expression of floats that are not negative.
fn up(number: f64) -> f64 {
    number * (1.0 + 16.0 * f64::EPSILON)
}

/// A number that is not above it.
fn down(number: f64) -> f64 {
    number * (1.0 - 16.0 * f64::EPSILON)
}

/// |`number`|, rounded somehow.
fn size(number: &BigInt) -> f64 {
    number.to_f64().map_or(f64::INFINITY, f64::abs)
}

/// 2⁻³²⁰
fn unit() -> f64 {
    2_f64.powi(-(BITS as i32))
}

/// The ends of an enclosure in units of 2⁻³²⁰, rounded outward.
fn scaled(enclosure: &Enclosure) -> (BigInt, BigInt) {
    let scaled = |end: &Rational| end * Rational::from(Int::from(1).shl(BITS));
    let lower = scaled(enclosure.lower()).floor().to_integer().to_big();
    (lower, scaled(enclosure.upper()).ceil().to_integer().to_big())
}

impl Fixed {
    /// A ball around an enclosure.
    #[must_use]
    pub fn around(enclosure: &Enclosure) -> Fixed {
        let (lower, upper) = scaled(enclosure);
        let center = (&lower + &upper) >> 1;
        let radius = size(&(upper - lower));
        Fixed { center, radius: up(radius) }
    }

    /// A ball around one number.
    #[must_use]
    pub fn of(number: &Rational) -> Fixed {
        Fixed::around(&Enclosure::exact(number.clone()))
    }

    /// A ball around a float; `None` if it is not finite.
    #[must_use]
    pub fn float(number: f64) -> Option<Fixed> {
        let field = number.to_bits() >> 52 & 0x7ff;
        let fraction = number.to_bits() & ((1 << 52) - 1);
        let magnitude = BigInt::from(if field == 0 { fraction } else { fraction | 1 << 52 });
        let signed = if number.is_sign_negative() { -magnitude } else { magnitude };
        // number = signed·2^(field − 1075)
        let shift = field.max(1) as i64 - 1075 + BITS as i64;
        let (center, radius) = if shift >= 0 { (signed << shift, 0.0) } else { (signed >> -shift, 1.0) };
        number.is_finite().then_some(Fixed { center, radius })
    }

    /// Zero alone.
    #[must_use]
    pub fn zero() -> Fixed {
        Fixed { center: BigInt::zero(), radius: 0.0 }
    }

    /// Whether zero may be among the numbers.
    #[must_use]
    pub fn contains_zero(&self) -> bool {
        let clear = down(size(&self.center)) > self.radius;
        !clear
    }

    /// Whether all numbers are negative.
    #[must_use]
    pub fn is_negative(&self) -> bool {
        self.center.is_negative() && !self.contains_zero()
    }

    /// The sums of numbers of both.
    #[must_use]
    pub fn add(&self, other: &Fixed) -> Fixed {
        Fixed { center: &self.center + &other.center, radius: up(self.radius + other.radius) }
    }

    /// The differences of numbers of both.
    #[must_use]
    pub fn sub(&self, other: &Fixed) -> Fixed {
        Fixed { center: &self.center - &other.center, radius: up(self.radius + other.radius) }
    }

    /// The negatives of the numbers.
    #[must_use]
    pub fn neg(&self) -> Fixed {
        Fixed { center: -&self.center, radius: self.radius }
    }

    /// The products of numbers of both.
    #[must_use]
    pub fn mul(&self, other: &Fixed) -> Fixed {
        let center = (&self.center * &other.center) >> BITS;
        let radius = if self.radius == 0.0 && other.radius == 0.0 {
            1.0
        } else {
            let (a, b) = (size(&self.center) + self.radius, size(&other.center));
            up((a * other.radius + b * self.radius) * unit() + 1.0)
        };
        Fixed { center, radius }
    }

    /// Half of the numbers.
    #[must_use]
    pub fn half(&self) -> Fixed {
        Fixed { center: &self.center >> 1, radius: up(0.5 * self.radius + 1.0) }
    }

    /// The quotients of numbers of both; `None` if zero may be among the divisors.
    #[must_use]
    pub fn div(&self, divisor: &Fixed) -> Option<Fixed> {
        if divisor.contains_zero() {
            return None;
        }
        let center = (&self.center << BITS) / &divisor.center;
        // |a/b − q| for the quotient q of the centers is |(a − a₀) − q·(b − b₀)|/|b|.
        let least = down(down(size(&divisor.center)) - divisor.radius) * unit();
        let radius = up(up(self.radius + (size(&center) + 1.0) * unit() * divisor.radius) / least + 1.0);
        (least > 0.0).then_some(Fixed { center, radius })
    }

    /// The nonnegative square roots of the numbers, of which those that are negative count as 0.
    #[must_use]
    pub fn sqrt(&self) -> Fixed {
        let root = |number: &BigInt| (number.max(&BigInt::zero()) << BITS).sqrt();
        if self.contains_zero() {
            let upper = up((size(&self.center) + self.radius).sqrt() * (1.0 / unit()).sqrt());
            let center = BigInt::from_f64(0.5 * upper).unwrap_or_default();
            return Fixed { center, radius: up(0.5 * upper + 1.0) };
        }
        let center = root(&self.center);
        // |√a − √c| = |a − c|/(√a + √c)
        let radius = up(self.radius / (down(size(&center)) * unit()) + 1.0);
        Fixed { center, radius }
    }

    /// The largest absolute value within.
    #[must_use]
    pub fn magnitude(&self) -> f64 {
        up(size(&self.center) + self.radius) * unit()
    }

    /// The diameter.
    #[must_use]
    pub fn width(&self) -> f64 {
        up(2.0 * self.radius) * unit()
    }

    /// The largest distance of `number` from a number within; infinite for NaN and infinities.
    #[must_use]
    pub fn distance(&self, number: f64) -> f64 {
        Fixed::float(number).map_or(f64::INFINITY, |number| self.sub(&number).magnitude())
    }

    /// The least distance of `number` from a number within; infinite for NaN and infinities.
    #[must_use]
    pub fn gap(&self, number: f64) -> f64 {
        Fixed::float(number).map_or(f64::INFINITY, |number| {
            let difference = self.sub(&number);
            down((down(size(&difference.center)) - difference.radius).max(0.0)) * unit()
        })
    }

    /// Whether all numbers of `enclosure` lie within.
    #[must_use]
    pub fn encloses(&self, enclosure: &Enclosure) -> bool {
        let number = |integer: &BigInt| Rational::from(Int::from(integer.clone()));
        let radius = exact(self.radius).unwrap_or_default();
        let lower = enclosure.lower() * number(&(BigInt::from(1) << BITS));
        let upper = enclosure.upper() * number(&(BigInt::from(1) << BITS));
        number(&self.center) - &radius <= lower && upper <= number(&self.center) + radius
    }
}

#[cfg(test)]
mod tests {
    use hodograph_algebra::{Enclosure, Rational, ratio};

    use super::Fixed;

    /// Whether the ball holds the number, and little else.
    fn holds(ball: &Fixed, number: &Rational) -> bool {
        ball.encloses(&Enclosure::exact(number.clone())) && ball.width() < 1e-60
    }

    #[test]
    fn balls_hold_the_exact_results() {
        let numbers = [ratio(1, 3), ratio(-22, 7), ratio(1, 1 << 40), ratio(123_456_789, 1000), ratio(5, 1)];
        for a in &numbers {
            for b in &numbers {
                let (x, y) = (Fixed::of(a), Fixed::of(b));
                assert!(holds(&x.add(&y), &(a + b)) && holds(&x.sub(&y), &(a - b)), "{a}, {b}");
                assert!(holds(&x.mul(&y), &(a * b)) && holds(&x.half(), &(a / ratio(2, 1))), "{a}, {b}");
                assert!(holds(&x.div(&y).unwrap(), &(a / b)), "{a}, {b}");
            }
            assert!(
                holds(&Fixed::of(&(a * a)).sqrt(), &if *a < ratio(0, 1) { -a } else { a.clone() }),
                "{a}"
            );
        }
        assert!(Fixed::zero().contains_zero() && Fixed::of(&ratio(1, 3)).div(&Fixed::zero()).is_none());
        assert!(Fixed::zero().sqrt().contains_zero());
        assert!(!Fixed::of(&ratio(1, 3)).encloses(&Enclosure::new(ratio(0, 1), ratio(1, 1))));
    }

    #[test]
    fn floats_are_their_numbers() {
        for float in [0.0, -0.375, 1e-40, 1e20, -f64::EPSILON] {
            let exact = hodograph_codegen::round::exact(float).unwrap();
            assert!(holds(&Fixed::float(float).unwrap(), &exact), "{float}");
        }
        assert!(Fixed::float(5e-324).unwrap().contains_zero());
        assert!(Fixed::float(f64::NAN).is_none() && Fixed::float(f64::INFINITY).is_none());
        assert_eq!(Fixed::float(1.0).unwrap().distance(f64::NAN), f64::INFINITY);
        let one = Fixed::float(1.0).unwrap();
        assert!(
            (0.25..0.25 + 1e-13).contains(&one.distance(0.75))
                && (0.25 - 1e-13..=0.25).contains(&one.gap(0.75))
        );
        assert!(one.gap(1.0) == 0.0 && one.gap(f64::NAN) == f64::INFINITY);
    }
}
