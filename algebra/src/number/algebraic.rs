//! Numbers of a number field, that is polynomials without variables: inverse, sign, enclosures and decimals.

use std::cmp::Ordering;

use num_traits::{Signed, Zero};

use super::bracket::Bracket;
use super::enclosure::Enclosure;
use crate::poly::Poly;
use crate::{Int, Rational, budget};

impl Poly {
    /// The number `1/self`, for a nonzero number of the field.
    ///
    /// The norm to the next smaller field of the tower, `(a + b·g)(a − b·g) = a² − r·b²`, takes out one generator after
    /// the other. Complexity: some three products for each generator. Elimination in the basis of the field, the general way
    /// (Cohen, *A Course in Computational Algebraic Number Theory*, section 4.2), is cubic in its degree.
    ///
    /// # Panics
    /// If `self` is zero, or has variables.
    #[must_use]
    pub fn inverse(&self) -> Poly {
        assert!(!self.is_zero(), "division by zero in a number field");
        if let Some(value) = self.to_rational() {
            return Poly::constant(value.recip());
        }
        assert!(self.is_constant(), "only a number has an inverse");
        let Some(last) = last_generator(self) else { unreachable!("an irrational number has a generator") };
        let conjugate = self.conjugate(last);
        let norm = self * &conjugate;
        conjugate * norm.inverse()
    }

    /// An interval of width at most `2^-bits` that holds the number.
    ///
    /// # Panics
    /// If `self` has variables.
    #[must_use]
    pub fn enclosure(&self, bits: u64) -> Enclosure {
        if let Some(value) = self.to_rational() {
            return Enclosure::exact(value);
        }
        assert!(self.is_constant(), "only a number has a value");
        let mut working = bits + 32;
        loop {
            let bracket = self.working_bracket(working);
            if bracket.is_narrow(self.content(), working, bits) {
                return bracket.times(self.content(), working);
            }
            working *= 2;
        }
    }

    fn working_bracket(&self, bits: u64) -> Bracket {
        budget::spend((4 + bits / 16).saturating_mul(self.terms().len() as u64));
        self.bracket(bits)
    }

    /// The sign of the number.
    ///
    /// Zero is recognized by the canonical form; otherwise enclosures are refined until they exclude zero.
    ///
    /// # Panics
    /// If `self` has variables.
    #[must_use]
    pub fn sign(&self) -> Ordering {
        if self.is_zero() {
            return Ordering::Equal;
        }
        if self.to_rational().is_some() {
            return self.content().cmp(&Rational::zero());
        }
        assert!(self.is_constant(), "only a number has a sign");
        let mut bits = 64;
        let primitive = loop {
            let bracket = self.working_bracket(bits);
            if bracket.lower.is_positive() {
                break Ordering::Greater;
            }
            if bracket.upper.is_negative() {
                break Ordering::Less;
            }
            bits *= 2;
        };
        if self.content().is_negative() { primitive.reverse() } else { primitive }
    }

    /// Compares two numbers by their real values.
    #[must_use]
    pub fn compare(&self, other: &Poly) -> Ordering {
        (self - other).sign()
    }

    /// The number as a decimal, correctly rounded to `digits` places after the point, halves away from zero.
    #[must_use]
    pub fn to_decimal(&self, digits: u32) -> String {
        let scale = Rational::from(Int::from(10).pow(digits));
        let mut bits = 64 + 4 * u64::from(digits);
        let rounded = loop {
            let enclosure = self.enclosure(bits);
            let round = |value: &Rational| (value * &scale).round().to_integer();
            let (low, high) = (round(enclosure.lower()), round(enclosure.upper()));
            if low == high {
                break low;
            }
            // An irrational number is no midpoint of two decimals, so narrower enclosures decide.
            bits *= 2;
        };
        let text = format!("{:0>width$}", rounded.abs().to_string(), width = digits as usize + 1);
        let (whole, fraction) = text.split_at(text.len() - digits as usize);
        let sign = if rounded.is_negative() { "-" } else { "" };
        if digits == 0 { format!("{sign}{whole}") } else { format!("{sign}{whole}.{fraction}") }
    }
}

/// The last generator that occurs in `poly`.
pub(super) fn last_generator(poly: &Poly) -> Option<usize> {
    let ring = poly.ring();
    let count = ring.field().generators().len();
    (0..count).rev().find(|&i| poly.terms().iter().any(|term| ring.generator_exponent(term.monomial, i) > 0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{integer, ratio};

    fn root(n: i64) -> Poly {
        Poly::sqrt_of(&integer(n))
    }

    #[test]
    fn equal_numbers_are_equal() {
        // √2·√3 = √6, and √(5 + 2√6) = √2 + √3.
        assert_eq!(root(2) * root(3), root(6));
        let nested = (root(6).scale(&integer(2)) + Poly::integer(5)).sqrt().unwrap();
        assert_eq!(nested, root(2) + root(3));
        assert_eq!((root(2) - root(2)).sign(), Ordering::Equal);
    }

    #[test]
    fn inverses_multiply_to_one() {
        let number = Poly::integer(7) + root(2) * root(3) - root(5).scale(&ratio(2, 3));
        assert!((&number * number.inverse()).is_one());
        let nested = (Poly::integer(2) + root(2)).sqrt().unwrap() + root(2);
        assert!((&nested * nested.inverse()).is_one());
    }

    #[test]
    fn signs_of_close_numbers() {
        // 99²·… : 577/408 is just above √2.
        assert_eq!((Poly::constant(ratio(577, 408)) - root(2)).sign(), Ordering::Greater);
        assert_eq!((Poly::constant(ratio(239, 169)) - root(2)).sign(), Ordering::Less);
    }

    #[test]
    fn decimals_are_rounded_correctly() {
        assert_eq!(root(2).to_decimal(5), "1.41421");
        assert_eq!((-root(2)).to_decimal(4), "-1.4142");
        assert_eq!(Poly::constant(ratio(1, 3)).to_decimal(3), "0.333");
        assert_eq!(Poly::constant(ratio(5, 2)).to_decimal(0), "3");
        assert_eq!(Poly::constant(ratio(-1, 20)).to_decimal(1), "-0.1");
    }
}
