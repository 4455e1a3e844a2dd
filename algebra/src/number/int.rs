//! Integers of any size, with a fast path for those that fit a machine word.

use std::cmp::Ordering;
use std::fmt;
use std::ops::Neg;
use std::str::FromStr;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Num, One, Signed, ToPrimitive, Zero};

use super::lehmer::Remainders;
use crate::operators::binary_operator;

/// An integer of any size.
///
/// Values in the range of `i64` are stored without allocation; only larger ones are a [`BigInt`]. The representation
/// is canonical (a value that fits is never stored big), so equality and hashing are structural.
///
/// # Example
/// ```
/// use hodograph_algebra::Int;
/// let big = Int::from(i64::MAX) * Int::from(2);
/// assert_eq!(big.to_string(), "18446744073709551614");
/// assert_eq!(big / Int::from(2), Int::from(i64::MAX));
/// ```
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Int(Repr);

#[derive(Clone, PartialEq, Eq, Hash)]
enum Repr {
    Small(i64),
    Big(Box<BigInt>),
}

use Repr::{Big, Small};

impl Int {
    /// Zero.
    pub const ZERO: Int = Int(Small(0));
    /// One.
    pub const ONE: Int = Int(Small(1));

    /// The value as a machine word, if it fits.
    #[must_use]
    pub fn small(&self) -> Option<i64> {
        match &self.0 {
            Small(value) => Some(*value),
            Big(_) => None,
        }
    }

    /// The value as a [`BigInt`].
    #[must_use]
    pub fn to_big(&self) -> BigInt {
        match &self.0 {
            Small(value) => BigInt::from(*value),
            Big(value) => (**value).clone(),
        }
    }

    /// The value, if it does not fit a machine word.
    pub(crate) fn big(&self) -> Option<&BigInt> {
        match &self.0 {
            Small(_) => None,
            Big(value) => Some(value),
        }
    }

    /// The number of bits of the absolute value; zero for zero.
    #[must_use]
    pub fn bits(&self) -> u64 {
        match &self.0 {
            Small(value) => u64::from(64 - value.unsigned_abs().leading_zeros()),
            Big(value) => value.bits(),
        }
    }

    /// `self` to the power `exponent`.
    #[must_use]
    pub fn pow(&self, exponent: u32) -> Int {
        if let Some(power) = self.small().and_then(|value| value.checked_pow(exponent)) {
            return power.into();
        }
        let words = (self.bits() / 64 + 1).saturating_mul(u64::from(exponent));
        crate::budget::spend(product_price(words, words));
        self.to_big().pow(exponent).into()
    }

    /// The largest integer whose square is at most `self`, for `self ≥ 0`; zero for negative `self`.
    #[must_use]
    pub fn isqrt(&self) -> Int {
        match &self.0 {
            Small(value) => Int(Small(value.max(&0).isqrt())),
            Big(value) if value.is_negative() => Int::ZERO,
            Big(value) => {
                let words = value.bits() / 64;
                crate::budget::spend(words * 8 + words * words / 16);
                value.sqrt().into()
            }
        }
    }

    /// The nonnegative square root, if `self` is a perfect square.
    #[must_use]
    pub fn exact_sqrt(&self) -> Option<Int> {
        if self.is_negative() {
            return None;
        }
        let root = self.isqrt();
        (&root * &root == *self).then_some(root)
    }

    /// `self · 2^bits`.
    #[must_use]
    pub fn shl(&self, bits: u64) -> Int {
        match &self.0 {
            _ if bits == 0 || self.is_zero() => self.clone(),
            Small(value) if bits < 64 => (i128::from(*value) << bits).into(),
            Small(value) => (BigInt::from(*value) << bits).into(),
            Big(value) => (&**value << bits).into(),
        }
    }

    /// `⌊self / 2^bits⌋`.
    #[must_use]
    pub fn shr(&self, bits: u64) -> Int {
        match &self.0 {
            Small(value) => Int(Small(value >> bits.min(63))),
            Big(value) => (&**value >> bits).into(),
        }
    }

    /// The exponent of the largest power of two that divides it; `None` for zero.
    pub(crate) fn trailing_zeros(&self) -> Option<u64> {
        match &self.0 {
            Small(0) => None,
            Small(value) => Some(u64::from(value.trailing_zeros())),
            Big(value) => value.trailing_zeros(),
        }
    }

    /// Whether the representation is canonical.
    #[must_use]
    pub fn is_valid(&self) -> bool {
        match &self.0 {
            Small(_) => true,
            Big(value) => value.to_i64().is_none(),
        }
    }
}

impl Default for Int {
    fn default() -> Int {
        Int::ZERO
    }
}

impl From<i64> for Int {
    fn from(value: i64) -> Int {
        Int(Small(value))
    }
}

impl From<i32> for Int {
    fn from(value: i32) -> Int {
        Int(Small(value.into()))
    }
}

impl From<u32> for Int {
    fn from(value: u32) -> Int {
        Int(Small(value.into()))
    }
}

impl From<i128> for Int {
    fn from(value: i128) -> Int {
        match i64::try_from(value) {
            Ok(small) => Int(Small(small)),
            Err(_) => Int(Big(Box::new(value.into()))),
        }
    }
}

impl From<u64> for Int {
    fn from(value: u64) -> Int {
        i128::from(value).into()
    }
}

impl From<BigInt> for Int {
    fn from(value: BigInt) -> Int {
        if value.bits() <= 64
            && let Some(small) = value.to_i64()
        {
            return Int(Small(small));
        }
        Int(Big(Box::new(value)))
    }
}

impl fmt::Display for Int {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Small(value) => value.fmt(f),
            Big(value) => {
                // The digits are found by divisions by powers of ten.
                let words = value.bits() / 64;
                crate::budget::spend(2 * product_price(words, words));
                value.fmt(f)
            }
        }
    }
}

impl fmt::Debug for Int {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl FromStr for Int {
    type Err = num_bigint::ParseBigIntError;

    fn from_str(text: &str) -> Result<Int, Self::Err> {
        text.parse::<BigInt>().map(Int::from)
    }
}

impl Ord for Int {
    fn cmp(&self, other: &Int) -> Ordering {
        match (&self.0, &other.0) {
            (Small(a), Small(b)) => a.cmp(b),
            (Big(a), Big(b)) => a.cmp(b),
            (Small(_), Big(b)) => {
                if b.is_negative() {
                    Ordering::Greater
                } else {
                    Ordering::Less
                }
            }
            (Big(a), Small(_)) => {
                if a.is_negative() {
                    Ordering::Less
                } else {
                    Ordering::Greater
                }
            }
        }
    }
}

impl PartialOrd for Int {
    fn partial_cmp(&self, other: &Int) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Neg for Int {
    type Output = Int;

    fn neg(self) -> Int {
        -&self
    }
}

impl Neg for &Int {
    type Output = Int;

    fn neg(self) -> Int {
        match &self.0 {
            Small(value) => match value.checked_neg() {
                Some(negated) => Int(Small(negated)),
                None => (-i128::from(*value)).into(),
            },
            Big(value) => (-(**value).clone()).into(),
        }
    }
}

/// The price of a product of numbers of `a` and `b` words: the work that schoolbook multiplication takes with small ones, and
/// with large ones less, like the power 3/2 of their length.
fn product_price(a: u64, b: u64) -> u64 {
    a.saturating_mul(b) / (8 + 2 * a.min(b).isqrt())
}

/// The price of the quotient, or remainder, of numbers of `a` and `b` words, by schoolbook division.
fn quotient_price(a: u64, b: u64) -> u64 {
    (a.saturating_sub(b) + 1).saturating_mul(b) / (8 + (2 * b.isqrt()).min(92))
}

/// The price of a sum.
fn sum_price(a: u64, b: u64) -> u64 {
    a.max(b) / 8
}

/// Spends the `price` of an operation on numbers that are so large that it counts: what smaller ones cost is paid by those
/// who use them.
fn charge(a: &BigInt, b: &BigInt, price: impl Fn(u64, u64) -> u64) {
    const COUNTS: u64 = 8;
    let words = [a, b].map(|value| value.bits() / 64);
    if words.iter().all(|words| *words > COUNTS) {
        crate::budget::spend(price(words[0], words[1]));
    }
}

/// One arithmetic operator: words are combined in a type that holds every result, big values by their own operator.
macro_rules! arithmetic {
    ($Op:ident $op:ident $OpAssign:ident $op_assign:ident $checked:ident $symbol:tt $price:ident) => {
        binary_operator!(Int: $Op $op $OpAssign $op_assign, |a, b| match (&a.0, &b.0) {
            (Small(a), Small(b)) => match a.$checked(*b) {
                Some(result) => Int(Small(result)),
                // Two words hold the result, except that of a division by zero.
                None => (i128::from(*a) $symbol i128::from(*b)).into(),
            },
            (Big(a), Big(b)) => {
                charge(a, b, $price);
                (&**a $symbol &**b).into()
            }
            (Big(a), Small(b)) => (&**a $symbol *b).into(),
            (Small(a), Big(b)) => (*a $symbol &**b).into(),
        });
    };
}

arithmetic!(Add add AddAssign add_assign checked_add + sum_price);
arithmetic!(Sub sub SubAssign sub_assign checked_sub - sum_price);
arithmetic!(Mul mul MulAssign mul_assign checked_mul * product_price);
arithmetic!(Div div DivAssign div_assign checked_div / quotient_price);
arithmetic!(Rem rem RemAssign rem_assign checked_rem % quotient_price);

impl Zero for Int {
    fn zero() -> Int {
        Int::ZERO
    }

    fn is_zero(&self) -> bool {
        matches!(self.0, Small(0))
    }
}

impl One for Int {
    fn one() -> Int {
        Int::ONE
    }

    fn is_one(&self) -> bool {
        matches!(self.0, Small(1))
    }
}

impl Num for Int {
    type FromStrRadixErr = num_bigint::ParseBigIntError;

    fn from_str_radix(text: &str, radix: u32) -> Result<Int, Self::FromStrRadixErr> {
        BigInt::from_str_radix(text, radix).map(Int::from)
    }
}

impl Signed for Int {
    fn abs(&self) -> Int {
        if self.is_negative() { -self } else { self.clone() }
    }

    fn abs_sub(&self, other: &Int) -> Int {
        if self <= other { Int::ZERO } else { self - other }
    }

    fn signum(&self) -> Int {
        match &self.0 {
            Small(value) => Int(Small(value.signum())),
            Big(value) => value.signum().into(),
        }
    }

    fn is_positive(&self) -> bool {
        match &self.0 {
            Small(value) => *value > 0,
            Big(value) => value.is_positive(),
        }
    }

    fn is_negative(&self) -> bool {
        match &self.0 {
            Small(value) => *value < 0,
            Big(value) => value.is_negative(),
        }
    }
}

impl Integer for Int {
    fn div_floor(&self, other: &Int) -> Int {
        self.div_mod_floor(other).0
    }

    fn mod_floor(&self, other: &Int) -> Int {
        self.div_mod_floor(other).1
    }

    fn gcd(&self, other: &Int) -> Int {
        match (&self.0, &other.0) {
            (Small(a), Small(b)) => i128::from(word_gcd(a.unsigned_abs(), b.unsigned_abs())).into(),
            // One step of Euclid brings the larger one down to a word.
            (Big(a), Small(b)) if *b != 0 => {
                Int(Small((&**a % *b).to_i64().unwrap_or(0))).gcd(&Int(Small(*b)))
            }
            (Small(a), Big(_)) if *a != 0 => other.gcd(self),
            (Small(_), Big(value)) | (Big(value), Small(_)) => (**value).abs().into(),
            (Big(a), Big(b)) => {
                // One step of Euclid again, where binary gcd would be slow.
                let (large, small) = if a.bits() < b.bits() { (other, self) } else { (self, other) };
                if large.bits() > small.bits() + 64 {
                    return small.gcd(&(large % small));
                }
                BigInt::from(Remainders::new(a, b).gcd()).into()
            }
        }
    }

    fn lcm(&self, other: &Int) -> Int {
        if self.is_zero() || other.is_zero() {
            return Int::ZERO;
        }
        (self / &self.gcd(other) * other).abs()
    }

    fn divides(&self, other: &Int) -> bool {
        self.is_multiple_of(other)
    }

    fn is_multiple_of(&self, other: &Int) -> bool {
        if other.is_zero() { self.is_zero() } else { (self % other).is_zero() }
    }

    fn is_even(&self) -> bool {
        match &self.0 {
            Small(value) => value % 2 == 0,
            Big(value) => value.is_even(),
        }
    }

    fn is_odd(&self) -> bool {
        !self.is_even()
    }

    fn div_rem(&self, other: &Int) -> (Int, Int) {
        match (&self.0, &other.0) {
            (Big(a), Big(b)) => {
                charge(a, b, quotient_price);
                let (quotient, remainder) = (**a).div_rem(&**b);
                (quotient.into(), remainder.into())
            }
            (Big(a), Small(b)) => {
                let (quotient, remainder) = (**a).div_rem(&BigInt::from(*b));
                (quotient.into(), remainder.into())
            }
            (Small(_), _) => (self / other, self % other),
        }
    }

    fn div_mod_floor(&self, other: &Int) -> (Int, Int) {
        let (quotient, remainder) = self.div_rem(other);
        if !remainder.is_zero() && remainder.is_negative() != other.is_negative() {
            (quotient - Int::ONE, remainder + other)
        } else {
            (quotient, remainder)
        }
    }
}

/// Euclid's algorithm: most numbers here are small, and then it takes few steps.
fn word_gcd(mut a: u64, mut b: u64) -> u64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}
