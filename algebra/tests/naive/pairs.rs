//! Rational functions as pairs of polynomials, reduced by a gcd after every operation.

use hodograph_algebra::{Fraction, Poly, Variable};

/// A numerator over a denominator.
#[derive(Clone, Debug)]
pub(crate) struct Pair {
    pub(crate) numerator: Poly,
    pub(crate) denominator: Poly,
}

impl Pair {
    /// The pair in lowest terms.
    fn reduced(numerator: Poly, denominator: Poly) -> Pair {
        let gcd = numerator.gcd(&denominator);
        let quotient = |poly: &Poly| poly.exact_div(&gcd).expect("the gcd divides");
        Pair { numerator: quotient(&numerator), denominator: quotient(&denominator) }
    }

    pub(crate) fn of(fraction: &Fraction) -> Pair {
        Pair::reduced(fraction.numerator().clone(), fraction.denominator())
    }

    pub(crate) fn sub(&self, other: &Pair) -> Pair {
        let difference = &self.numerator * &other.denominator - &other.numerator * &self.denominator;
        Pair::reduced(difference, &self.denominator * &other.denominator)
    }

    pub(crate) fn mul(&self, other: &Pair) -> Pair {
        Pair::reduced(&self.numerator * &other.numerator, &self.denominator * &other.denominator)
    }

    /// The derivative by the quotient rule.
    pub(crate) fn derivative(&self, variable: &Variable) -> Pair {
        let (n, d) = (&self.numerator, &self.denominator);
        Pair::reduced(n.derivative(variable) * d - n * d.derivative(variable), d * d)
    }
}
