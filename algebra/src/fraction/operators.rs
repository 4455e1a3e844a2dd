//! Conversions, arithmetic and equality of rational functions.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{Fraction, insert};
use crate::{Poly, Rational, integer};

impl From<Poly> for Fraction {
    fn from(numerator: Poly) -> Fraction {
        Fraction { numerator, factors: Vec::new() }
    }
}

impl From<Rational> for Fraction {
    fn from(value: Rational) -> Fraction {
        Poly::constant(value).into()
    }
}

fn combine(a: &Fraction, b: &Fraction, sign: i64) -> Fraction {
    if b.is_zero() {
        return a.clone();
    }
    if a.is_zero() {
        return b.scale(&integer(sign));
    }
    let common = Fraction::common_denominator([a, b]);
    let numerator = a.numerator_over(&common) + b.numerator_over(&common).scale(&integer(sign));
    if numerator.is_zero() {
        return Fraction::zero();
    }
    Fraction { numerator, factors: common }
}

impl Add for &Fraction {
    type Output = Fraction;

    fn add(self, other: &Fraction) -> Fraction {
        combine(self, other, 1)
    }
}

impl Sub for &Fraction {
    type Output = Fraction;

    fn sub(self, other: &Fraction) -> Fraction {
        combine(self, other, -1)
    }
}

impl Mul for &Fraction {
    type Output = Fraction;

    fn mul(self, other: &Fraction) -> Fraction {
        let mut factors = self.factors.clone();
        for (factor, exponent) in &other.factors {
            insert(&mut factors, factor.clone(), *exponent);
        }
        let numerator = &self.numerator * &other.numerator;
        if numerator.is_zero() {
            return Fraction::zero();
        }
        Fraction { numerator, factors }
    }
}

impl Mul<&Rational> for &Fraction {
    type Output = Fraction;

    fn mul(self, factor: &Rational) -> Fraction {
        self.scale(factor)
    }
}

impl Div for &Fraction {
    type Output = Fraction;

    /// # Panics
    /// If `divisor` is zero; see [`Fraction::checked_div`].
    fn div(self, divisor: &Fraction) -> Fraction {
        match self.checked_div(divisor) {
            Some(quotient) => quotient,
            None => panic!("division of a rational function by zero"),
        }
    }
}

impl Neg for &Fraction {
    type Output = Fraction;

    fn neg(self) -> Fraction {
        self.scale(&integer(-1))
    }
}

impl PartialEq for Fraction {
    fn eq(&self, other: &Fraction) -> bool {
        (self - other).is_zero()
    }
}

impl Eq for Fraction {}
