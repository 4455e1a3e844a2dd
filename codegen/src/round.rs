//! Exact numbers to floats: the only place where a constant is rounded.

use std::cmp::Ordering;
use std::fmt;

use hodograph_algebra::{Int, Poly, Rational, integer};

use crate::program::Program;

/// Why an exact number has no float.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum RoundError {
    /// The number is beyond the range of `f64`; its leading digits and its power of ten are given, as in `1.000e400`.
    TooLarge(String),
    /// There are symbols in it.
    NotANumber(String),
}

impl fmt::Display for RoundError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RoundError::TooLarge(number) => write!(f, "the number {number} is beyond the range of `f64`"),
            RoundError::NotANumber(poly) => write!(f, "`{poly}` has no value, because symbols occur in it"),
        }
    }
}

impl std::error::Error for RoundError {}

/// The `f64` nearest to a number of a field, ties to even; correctly rounded, subnormal results included.
///
/// Rational numbers are rounded by one exact division. Others lie on no tie, so enclosures are narrowed until both ends
/// round to the same float.
///
/// # Errors
/// [`RoundError`] if the result would be infinite, or `number` has variables.
///
/// # Example
/// ```
/// use hodograph_algebra::{Poly, integer, ratio};
/// use hodograph_codegen::round::nearest;
/// assert_eq!(nearest(&Poly::constant(ratio(1, 3))), Ok(1.0 / 3.0));
/// assert_eq!(nearest(&Poly::sqrt_of(&integer(2))), Ok(std::f64::consts::SQRT_2));
/// ```
pub fn nearest(number: &Poly) -> Result<f64, RoundError> {
    if !number.is_constant() {
        return Err(RoundError::NotANumber(number.to_string()));
    }
    let too_large = || RoundError::TooLarge(leading_digits(&number.to_decimal(0)));
    if let Some(value) = number.to_rational() {
        return nearest_to_rational(&value).ok_or_else(too_large);
    }
    let mut bits = 128;
    loop {
        let enclosure = number.enclosure(bits);
        let (lower, upper) = (nearest_to_rational(enclosure.lower()), nearest_to_rational(enclosure.upper()));
        if lower.map(f64::to_bits) == upper.map(f64::to_bits) {
            return lower.ok_or_else(too_large);
        }
        bits *= 2;
    }
}

/// The first four digits of an integer in decimals, and its power of ten.
fn leading_digits(decimal: &str) -> String {
    let (sign, digits) = decimal.strip_prefix('-').map_or(("", decimal), |digits| ("-", digits));
    match (digits.get(..1), digits.get(1..4)) {
        (Some(first), Some(next)) => format!("{sign}{first}.{next}e{}", digits.len() - 1),
        _ => decimal.to_string(),
    }
}

/// The rational number that a float is; `None` for infinities and NaN.
///
/// ```
/// use hodograph_codegen::round::exact;
/// assert_eq!(exact(-0.375).unwrap().to_string(), "-3/8");
/// ```
#[must_use]
pub fn exact(float: f64) -> Option<Rational> {
    let (field, fraction) = (float.to_bits() >> 52 & 0x7ff, float.to_bits() & ((1 << 52) - 1));
    let significand = if field == 0 { fraction } else { fraction | 1 << 52 };
    let (numerator, denominator) = scaled(&Int::from(significand), &Int::from(1), 1075 - field.max(1) as i64);
    let magnitude = Rational::new(numerator, denominator);
    float.is_finite().then_some(if float.is_sign_negative() { -magnitude } else { magnitude })
}

/// The program with every constant rounded to nearest.
///
/// # Errors
/// The first [`RoundError`].
pub fn round(program: &Program<Poly>) -> Result<Program<f64>, RoundError> {
    program.map_constants(nearest)
}

/// The `f64` nearest to `value`, ties to even; `None` beyond the range.
pub(crate) fn nearest_to_rational(value: &Rational) -> Option<f64> {
    /// The exponent of the least subnormal number, 2^-1074.
    const LEAST: i64 = -1074;
    let (zero, numerator, denominator) = (Int::from(0), value.numer(), value.denom());
    let negative = *numerator < zero;
    let numerator = if negative { -numerator } else { numerator.clone() };
    if numerator == zero {
        return Some(0.0);
    }
    // 2^exponent ≤ value < 2^(exponent + 1)
    let mut exponent = numerator.bits() as i64 - denominator.bits() as i64;
    let (above, below) = scaled(&numerator, denominator, exponent);
    if above < below {
        exponent -= 1;
    }
    // One unit in the last place is 2^unit.
    let unit = (exponent - 52).max(LEAST);
    let (above, below) = scaled(&numerator, denominator, unit);
    let (mut quotient, rest) = (&above / &below, &above % &below);
    let up = match (&rest + &rest).cmp(&below) {
        Ordering::Less => false,
        Ordering::Equal => &quotient % Int::from(2) == Int::from(1),
        Ordering::Greater => true,
    };
    if up {
        quotient += Int::from(1);
    }
    // The quotient has its leading bit at 52, which carries into the exponent's field; a subnormal one has not.
    let significand = u64::try_from(quotient.small()?).ok()?;
    let biased = u64::try_from(unit - LEAST).ok().filter(|biased| *biased < 0x7ff)?;
    let magnitude = f64::from_bits((biased << 52) + significand);
    magnitude.is_finite().then_some(if negative { -magnitude } else { magnitude })
}

/// `numerator / (denominator · 2^exponent)` as a numerator and a denominator.
fn scaled(numerator: &Int, denominator: &Int, exponent: i64) -> (Int, Int) {
    let bits = exponent.unsigned_abs();
    if exponent < 0 {
        (numerator.shl(bits), denominator.clone())
    } else {
        (numerator.clone(), denominator.shl(bits))
    }
}

/// The power of two that is about the size of the largest coefficient, if it is far from 1; 1 if it is not.
pub(crate) fn power_of_size(polys: &[Poly]) -> Rational {
    let bits = |int: &Int| i64::try_from(int.bits()).unwrap_or(i64::MAX / 4);
    let of_poly = |poly: &Poly| {
        let largest = poly.terms().iter().map(|term| bits(&term.coefficient)).max()?;
        Some(largest + bits(poly.content().numer()) - bits(poly.content().denom()))
    };
    let size = polys.iter().filter_map(of_poly).max().unwrap_or(0);
    if size.abs() < FAR {
        return integer(1);
    }
    let power = Rational::from(Int::from(1).shl(size.unsigned_abs()));
    if size < 0 { power.recip() } else { power }
}

/// The bits that coefficients may have before all are scaled.
const FAR: i64 = 64;

#[cfg(test)]
mod tests {
    use hodograph_algebra::{Int, Poly, Rational, integer, ratio};

    use super::{RoundError, nearest, nearest_to_rational, power_of_size};

    fn exact(value: f64) -> Rational {
        super::exact(value).unwrap()
    }

    fn power(exponent: i64) -> Rational {
        let power = Int::from(1).shl(exponent.unsigned_abs());
        if exponent < 0 { Rational::new(Int::from(1), power) } else { Rational::from(power) }
    }

    #[test]
    fn floats_round_to_themselves() {
        let values = [
            1.0,
            -1.5,
            0.1,
            1e-310,
            5e-324,
            f64::MIN_POSITIVE,
            f64::MAX,
            f64::MIN,
            1e300,
            -1e-300,
            4503599627370496.0,
        ];
        for value in values {
            assert_eq!(nearest_to_rational(&exact(value)), Some(value));
        }
    }

    #[test]
    fn neighbors_and_ties_round_correctly() {
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        let mut values = vec![1.0, 5e-324, f64::MIN_POSITIVE, f64::MIN_POSITIVE / 2.0, 2.0 - f64::EPSILON];
        for _ in 0..200 {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            values.push(f64::from_bits(state & !(1 << 63) & !(1 << 62)));
        }
        for value in values {
            let next = f64::from_bits(value.to_bits() + 1);
            let middle = (exact(value) + exact(next)) / integer(2);
            let even = if value.to_bits() % 2 == 0 { value } else { next };
            let little = power(-1200);
            assert_eq!(nearest_to_rational(&middle), Some(even));
            assert_eq!(nearest_to_rational(&(&middle - &little)), Some(value));
            assert_eq!(nearest_to_rational(&(&middle + &little)), Some(next));
            assert_eq!(nearest_to_rational(&-(&middle + &little)), Some(-next));
        }
    }

    #[test]
    fn decimals_agree_with_the_standard_library() {
        for text in
            ["0.1", "0.2", "12345.678", "9007199254740993", "1e22", "1.7976931348623157e308", "3e-320"]
        {
            let value = hodograph_algebra::parse_decimal(text).unwrap();
            assert_eq!(nearest_to_rational(&value), Some(text.parse().unwrap()), "{text}");
        }
    }

    #[test]
    fn radicals_are_correctly_rounded() {
        // Both square roots are correctly rounded by IEEE 754.
        for n in [2, 3, 5, 35, 110] {
            assert_eq!(nearest(&Poly::sqrt_of(&integer(n))), Ok((n as f64).sqrt()));
        }
        let tiny = Poly::sqrt_of(&integer(2)) * Poly::constant(power(-1080));
        assert_eq!(nearest(&-tiny), Ok(-0.0));
        // √2 − 665857/470832, which is −1.5948618246068547e-12, cancels most of its digits.
        let difference = Poly::sqrt_of(&integer(2)) - Poly::constant(ratio(665_857, 470_832));
        assert_eq!(nearest(&difference), Ok(-1.594_861_824_606_854_7e-12));
    }

    #[test]
    fn sizes_far_from_one_are_powers_of_two() {
        let one = |number: Rational| power_of_size(&[Poly::zero(), Poly::constant(number)]);
        assert_eq!(
            (one(integer(1000)), one(ratio(1, 1000)), power_of_size(&[])),
            (integer(1), integer(1), integer(1))
        );
        assert_eq!((one(power(80)), one(-power(-80) * integer(3))), (power(81), power(-78)));
    }

    #[test]
    fn what_has_no_float_is_an_error() {
        let too_large = |digits: &str| Err(RoundError::TooLarge(digits.to_string()));
        assert_eq!(nearest(&Poly::constant(power(1024))), too_large("1.797e308"));
        assert_eq!(nearest(&Poly::constant(-power(1024))), too_large("-1.797e308"));
        let huge = Poly::sqrt_of(&integer(2)) * Poly::constant(power(2000));
        assert!(matches!(nearest(&huge), Err(RoundError::TooLarge(_))));
        // Halfway to 2^1024 rounds to even, which is beyond.
        let tie = Poly::constant(power(1024) - power(970));
        assert!(matches!(nearest(&tie), Err(RoundError::TooLarge(_))));
        let symbol = Poly::variable(&hodograph_algebra::Variable::new(0, "u"));
        assert_eq!(nearest(&symbol), Err(RoundError::NotANumber("u".to_string())));
    }
}
