//! Intervals with ends that are multiples of a small power of two: fast enclosures for many points.

use hodograph_algebra::{Enclosure, Int, Rational};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// The bits after the point.
pub const BITS: u64 = 320;

/// The real numbers between `lower`·2⁻³²⁰ and `upper`·2⁻³²⁰; all operations round outward.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fixed {
    lower: BigInt,
    upper: BigInt,
}

impl Fixed {
    /// The interval around an enclosure.
    #[must_use]
    pub fn around(enclosure: &Enclosure) -> Fixed {
        let scaled = |end: &Rational| end * Rational::from(Int::from(1).shl(BITS));
        let lower = scaled(enclosure.lower()).floor().to_integer().to_big();
        let upper = scaled(enclosure.upper()).ceil().to_integer().to_big();
        Fixed { lower, upper }
    }

    /// The interval around one number.
    #[must_use]
    pub fn of(number: &Rational) -> Fixed {
        Fixed::around(&Enclosure::exact(number.clone()))
    }

    /// Zero alone.
    #[must_use]
    pub fn zero() -> Fixed {
        Fixed { lower: BigInt::zero(), upper: BigInt::zero() }
    }

    /// Whether zero lies within.
    #[must_use]
    pub fn contains_zero(&self) -> bool {
        !self.lower.is_positive() && !self.upper.is_negative()
    }

    /// The sums of numbers of both.
    #[must_use]
    pub fn add(&self, other: &Fixed) -> Fixed {
        Fixed { lower: &self.lower + &other.lower, upper: &self.upper + &other.upper }
    }

    /// The differences of numbers of both.
    #[must_use]
    pub fn sub(&self, other: &Fixed) -> Fixed {
        Fixed { lower: &self.lower - &other.upper, upper: &self.upper - &other.lower }
    }

    /// The products of numbers of both.
    #[must_use]
    pub fn mul(&self, other: &Fixed) -> Fixed {
        let ends = [(&self.lower, &other.lower), (&self.lower, &other.upper), (&self.upper, &other.lower)];
        let mut lower = &self.upper * &other.upper;
        let mut upper = lower.clone();
        for (a, b) in ends {
            let product = a * b;
            if product < lower {
                lower = product;
            } else if product > upper {
                upper = product;
            }
        }
        let one = BigInt::one() << BITS;
        Fixed { lower: lower.div_floor(&one), upper: upper.div_ceil(&one) }
    }

    /// The quotients of numbers of both.
    ///
    /// # Panics
    /// If zero is among the divisors.
    #[must_use]
    pub fn div(&self, divisor: &Fixed) -> Fixed {
        assert!(!divisor.contains_zero(), "division by an interval around zero");
        let square = BigInt::one() << (2 * BITS);
        let inverse =
            Fixed { lower: square.div_floor(&divisor.upper), upper: square.div_ceil(&divisor.lower) };
        self.mul(&inverse)
    }

    /// The nonnegative square roots of sums of squares, so that no number within is negative.
    #[must_use]
    pub fn sqrt(&self) -> Fixed {
        let root = |end: &BigInt| (end.max(&BigInt::zero()) << BITS).sqrt();
        Fixed { lower: root(&self.lower), upper: root(&self.upper) + 1 }
    }

    /// The largest absolute value within.
    #[must_use]
    pub fn magnitude(&self) -> f64 {
        to_f64(&self.lower.abs().max(self.upper.abs()))
    }

    /// The difference of the ends.
    #[must_use]
    pub fn width(&self) -> f64 {
        to_f64(&(&self.upper - &self.lower))
    }

    /// The largest distance of `number` from a number within.
    #[must_use]
    pub fn distance(&self, number: &Rational) -> f64 {
        self.sub(&Fixed::of(number)).magnitude()
    }

    /// Whether all numbers of `enclosure` lie within.
    #[must_use]
    pub fn encloses(&self, enclosure: &Enclosure) -> bool {
        let Fixed { lower, upper } = Fixed::around(enclosure);
        self.lower <= lower && upper <= self.upper
    }
}

/// `number`·2⁻³²⁰ as a float.
fn to_f64(number: &BigInt) -> f64 {
    number.to_f64().map_or(f64::INFINITY, |float| float / 2_f64.powi(BITS as i32))
}
