//! Decimals of exact numbers.

use std::cmp::Ordering;

use hodograph_algebra::{Int, Poly, Rational, parse_decimal};

/// The most significant digits that are printed.
pub(crate) const MAX_DIGITS: u32 = 1000;

/// Zeros between the point and the first digit up to which a decimal is printed without an exponent.
const MOST_ZEROS: i64 = 5;

/// The number of the field correctly rounded to `digits` significant digits, halves away from zero. A number that has
/// fewer digits is printed with all of them and no more; very small and very large ones have an exponent, as `1.5e-9`.
pub(crate) fn significant(number: &Poly, digits: u32) -> String {
    let sign = match number.sign() {
        Ordering::Equal => return "0".to_owned(),
        Ordering::Less => "-",
        Ordering::Greater => "",
    };
    let magnitude = if sign.is_empty() { number.clone() } else { -number };
    let mut exponent = magnitude_exponent(&magnitude);
    let places = i64::from(digits) - 1 - exponent;
    let scaled = magnitude.scale(&power_of_ten(places));
    let mut text = match u32::try_from(places) {
        Ok(places) => magnitude.to_decimal(places).replace('.', "").trim_start_matches('0').to_owned(),
        Err(_) => scaled.to_decimal(0),
    };
    if text.len() > digits as usize {
        // 9.99… was rounded to 10.
        text.pop();
        exponent += 1;
    }
    if scaled.to_rational().is_some_and(|value| value.is_integer()) {
        text.truncate(text.trim_end_matches('0').len());
    }
    format!("{sign}{}", placed(&text, exponent, digits))
}

/// Whether a decimal that [`significant`] gives is the number itself.
pub(crate) fn is_exact(number: &Poly, decimal: &str) -> bool {
    let (negative, digits) = decimal.strip_prefix('-').map_or((false, decimal), |digits| (true, digits));
    let value = parse_decimal(digits).map(|value| if negative { -value } else { value });
    value.is_some() && value == number.to_rational()
}

/// The digits with their first one at the place `10^exponent`.
fn placed(digits: &str, exponent: i64, wanted: u32) -> String {
    let count = digits.len();
    if exponent < -MOST_ZEROS || exponent > i64::from(wanted.max(17)) {
        let (first, rest) = digits.split_at(1);
        let point = if rest.is_empty() { "" } else { "." };
        return format!("{first}{point}{rest}e{exponent}");
    }
    match usize::try_from(exponent) {
        Ok(whole) if whole + 1 >= count => format!("{digits}{}", "0".repeat(whole + 1 - count)),
        Ok(whole) => format!("{}.{}", &digits[..=whole], &digits[whole + 1..]),
        Err(_) => format!("0.{}{digits}", "0".repeat(usize::try_from(-exponent - 1).unwrap_or(0))),
    }
}

/// The `e` with `10^e ≤ number < 10^(e + 1)`, for a positive number.
fn magnitude_exponent(number: &Poly) -> i64 {
    let mut bits = 64;
    loop {
        let enclosure = number.enclosure(bits);
        if !enclosure.contains_zero() {
            let (lower, upper) = (rational_exponent(enclosure.lower()), rational_exponent(enclosure.upper()));
            // An irrational number is no power of ten, and a rational one is enclosed exactly.
            if lower == upper {
                return lower;
            }
        }
        bits *= 2;
    }
}

fn rational_exponent(value: &Rational) -> i64 {
    let length = |value: &Int| i64::try_from(value.to_string().len()).unwrap_or(i64::MAX);
    let guess = length(value.numer()) - length(value.denom());
    if *value >= power_of_ten(guess) { guess } else { guess - 1 }
}

fn power_of_ten(exponent: i64) -> Rational {
    let power = Int::from(10).pow(u32::try_from(exponent.unsigned_abs()).unwrap_or(u32::MAX));
    if exponent < 0 { Rational::from(power).recip() } else { power.into() }
}

#[cfg(test)]
mod tests {
    use hodograph_algebra::{integer, ratio};

    use super::*;

    fn rational(n: i64, d: i64, digits: u32) -> String {
        significant(&Poly::constant(ratio(n, d)), digits)
    }

    #[test]
    fn digits_are_significant() {
        assert_eq!(rational(3, 4, 17), "0.75");
        assert_eq!(rational(-3, 4, 17), "-0.75");
        assert_eq!(rational(0, 1, 5), "0");
        assert_eq!(rational(2, 3, 5), "0.66667");
        assert_eq!(rational(200, 3, 5), "66.667");
        assert_eq!(rational(200_000, 3, 3), "66700");
        assert_eq!(rational(1, 3000, 3), "0.000333");
        assert_eq!(rational(9999, 10_000, 3), "1.00");
        assert_eq!(rational(1, 1, 3), "1");
        assert_eq!(rational(1000, 1, 3), "1000");
        assert_eq!(rational(25, 10, 1), "3");
        assert_eq!(rational(1, 10_000_000, 4), "1e-7");
        assert_eq!(rational(-5, 300_000_000, 4), "-1.667e-8");
    }

    #[test]
    fn roots_are_correctly_rounded() {
        let root = Poly::sqrt_of(&integer(2));
        assert_eq!(significant(&root, 17), "1.4142135623730950");
        assert_eq!(significant(&(&root - Poly::integer(1)), 5), "0.41421");
        // √2 − 1.4142135623730950488 is about 1.7e-21: all leading digits cancel.
        let close = Poly::constant(parse_decimal("1.4142135623730950488").unwrap_or_else(|| integer(0)));
        assert_eq!(significant(&(&root - close), 3), "1.69e-21");
        let large = Poly::constant(parse_decimal("1e40").unwrap_or_else(|| integer(0)));
        assert_eq!(significant(&(large * root), 6), "1.41421e40");
    }

    #[test]
    fn exact_decimals_are_recognized() {
        assert!(is_exact(&Poly::constant(ratio(-4, 5)), "-0.8"));
        assert!(is_exact(&Poly::zero(), "0"));
        assert!(!is_exact(&Poly::constant(ratio(2, 3)), "0.66667"));
        assert!(!is_exact(&Poly::sqrt_of(&integer(2)), "1.4"));
    }

    #[test]
    fn many_digits() {
        let text = significant(&Poly::sqrt_of(&integer(2)), 1000);
        assert_eq!(text.len(), 1001);
        let value = Poly::constant(parse_decimal(&text).unwrap_or_else(|| integer(0)));
        assert_eq!(
            significant(&value.pow(2), 900),
            "2.0000".chars().take(1).collect::<String>() + "." + &"0".repeat(899)
        );
    }
}
