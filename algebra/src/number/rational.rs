//! Rational numbers, as a ratio of two [`Int`]s.

use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use crate::Int;

/// A rational number in lowest terms with a positive denominator.
///
/// # Example
/// ```
/// use hodograph_algebra::{Rational, ratio};
/// assert_eq!((ratio(1, 2) + ratio(1, 3)).to_string(), "5/6");
/// ```
pub type Rational = num_rational::Ratio<Int>;

/// The rational `numerator / denominator`, for a nonzero denominator.
///
/// # Panics
/// If `denominator` is zero, as the division by zero that it is.
#[must_use]
pub fn ratio(numerator: i64, denominator: i64) -> Rational {
    Rational::new(numerator.into(), denominator.into())
}

/// The integer `value` as a rational.
#[must_use]
pub fn integer(value: i64) -> Rational {
    Rational::from_integer(value.into())
}

/// The nonnegative square root of `value`, if that is rational.
///
/// ```
/// use hodograph_algebra::{ratio, rational_sqrt};
/// assert_eq!(rational_sqrt(&ratio(9, 4)), Some(ratio(3, 2)));
/// assert_eq!(rational_sqrt(&ratio(2, 1)), None);
/// ```
#[must_use]
pub fn rational_sqrt(value: &Rational) -> Option<Rational> {
    Some(Rational::new_raw(value.numer().exact_sqrt()?, value.denom().exact_sqrt()?))
}

/// The positive greatest rational `g` such that both `a/g` and `b/g` are integers; `gcd(0, 0) = 0`.
#[must_use]
pub fn rational_gcd(a: &Rational, b: &Rational) -> Rational {
    if a.is_zero() {
        return b.abs();
    }
    if b.is_zero() {
        return a.abs();
    }
    Rational::new_raw(a.numer().gcd(b.numer()), a.denom().lcm(b.denom()))
}

/// An exact decimal literal, such as `12`, `0.25` or `1.5e-3`; `None` if `text` is not one, or if its exponent is beyond
/// ±[`MAX_DECIMAL_EXPONENT`] or the number of its digits is.
///
/// ```
/// use hodograph_algebra::{parse_decimal, ratio};
/// assert_eq!(parse_decimal("0.8"), Some(ratio(4, 5)));
/// assert_eq!(parse_decimal("1.5e-3"), Some(ratio(3, 2000)));
/// assert_eq!(parse_decimal("1e999999999"), None);
/// ```
#[must_use]
pub fn parse_decimal(text: &str) -> Option<Rational> {
    let text = text.replace('_', "");
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i64>().ok()?),
        None => (text.as_str(), 0),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{fraction}");
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    if digits.len() as u64 > MAX_DECIMAL_EXPONENT {
        return None;
    }
    let digits: Int = digits.parse().ok()?;
    let exponent = exponent - i64::try_from(fraction.len()).ok()?;
    if exponent.unsigned_abs() > MAX_DECIMAL_EXPONENT {
        return None;
    }
    let power = Int::from(10).pow(u32::try_from(exponent.unsigned_abs()).ok()?);
    Some(if exponent < 0 { Rational::new(digits, power) } else { (digits * power).into() })
}

/// The largest power of ten, up or down, that a decimal literal may carry, its digits included.
pub const MAX_DECIMAL_EXPONENT: u64 = 4096;

/// Writes `value ≥ 0` as `s² · f` with `s` rational and `f` a positive integer that has no square factor of a small
/// prime (all primes below 2^12 are tried), so that `√value = s·√f`.
///
/// The result is used to choose a readable radical, not to decide anything; for zero it is `(0, 1)`.
#[must_use]
pub fn square_part(value: &Rational) -> (Rational, Int) {
    if value.is_zero() {
        return (Rational::zero(), Int::one());
    }
    // √(n/d) = √(n·d)/d
    let mut rest = value.numer() * value.denom();
    let mut root = Int::one();
    let mut prime = Int::from(2);
    while &prime * &prime <= rest && prime < Int::from(4096) {
        let square = &prime * &prime;
        while rest.is_multiple_of(&square) {
            rest /= &square;
            root *= &prime;
        }
        prime += Int::one();
    }
    if let Some(exact) = rest.exact_sqrt() {
        root *= exact;
        rest = Int::one();
    }
    (Rational::new(root, value.denom().clone()), rest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_exact() {
        assert_eq!(parse_decimal("2.4"), Some(ratio(12, 5)));
        assert_eq!(parse_decimal("1_000"), Some(integer(1000)));
        assert_eq!(parse_decimal("1e3"), Some(integer(1000)));
        assert_eq!(parse_decimal(""), None);
        assert_eq!(parse_decimal("."), None);
        assert_eq!(parse_decimal("1.2.3"), None);
    }

    #[test]
    fn square_parts_recombine() {
        for (n, d) in [(8, 1), (1, 2), (11_000, 7), (35, 8), (49, 1), (1, 1)] {
            let (root, free) = square_part(&ratio(n, d));
            assert_eq!(&root * &root * Rational::from(free), ratio(n, d));
        }
        assert_eq!(square_part(&ratio(8, 1)), (integer(2), Int::from(2)));
    }
}
