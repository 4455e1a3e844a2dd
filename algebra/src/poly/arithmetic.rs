//! Sums, differences, products and powers of polynomials.

use std::iter::{Product, Sum};
use std::ops::Neg;

use num_traits::{One, Zero};

use super::product::product;
use super::{Poly, terms};
use crate::operators::binary_operator;
use crate::{Int, Rational, budget, rational_gcd};

impl Poly {
    /// `self · factor`.
    #[must_use]
    pub fn scale(&self, factor: &Rational) -> Poly {
        if factor.is_zero() {
            return Poly::zero();
        }
        Poly { content: &self.content * factor, ..self.clone() }
    }

    /// `self` to the power `exponent`; the power 0 is 1.
    ///
    /// Repeated multiplication, since the powers of sparse polynomials are dense and squaring would cost more
    /// (Fateman, *On the computation of powers of sparse polynomials*, 1974).
    #[must_use]
    pub fn pow(&self, exponent: u32) -> Poly {
        if exponent == 0 {
            return Poly::one();
        }
        if self.is_zero() {
            return Poly::zero();
        }
        // The exponents of the result, so that an impossible power is refused at once.
        let degrees = self.ring.variables().iter().map(|variable| self.degree(variable).unwrap_or(0));
        let degrees: Vec<u32> = degrees.map(|degree| degree.saturating_mul(exponent)).collect();
        let leading = self.ring.monomial(&degrees, &[]);
        if let [term] = self.terms.as_slice()
            && self.ring.generator_part(term.monomial) == super::Monomial::ONE
        {
            let terms = vec![super::Term { monomial: leading, coefficient: Int::ONE }];
            let power = |part: &Int| part.pow(exponent);
            let content = Rational::new_raw(power(self.content.numer()), power(self.content.denom()));
            return Poly { ring: self.ring.clone(), content, terms };
        }
        budget::doing("a power of a polynomial", || {
            budget::require(self.power_work(exponent, &degrees));
            let mut power = self.clone();
            for step in 1..exponent {
                budget::progress(step.into(), exponent.into());
                power = &power * self;
            }
            power
        })
    }

    /// A cautious estimate of the work for a power with the given degrees, from the number of terms that it can have: at
    /// most the multinomial one, at most those of its box.
    fn power_work(&self, exponent: u32, degrees: &[u32]) -> u64 {
        let cells = degrees.iter().fold(1_u64, |cells, degree| cells.saturating_mul(u64::from(*degree) + 1));
        let count = self.terms.len() as u64;
        // C(exponent + count − 1, count − 1), as far as it stays below the number of cells.
        let mut multinomial = 1_u64;
        for k in 1..count {
            multinomial = multinomial.saturating_mul(u64::from(exponent) + k) / k;
            if multinomial > cells {
                break;
            }
        }
        let terms = cells.min(multinomial);
        let bits = self.terms.iter().map(|term| term.coefficient.bits()).max().unwrap_or(0)
            + u64::from(count.max(1).ilog2());
        let words = 1 + bits.saturating_mul(u64::from(exponent)) / 128;
        // The powers before it have fewer terms: a third of them on average, for two variables.
        terms.saturating_mul(count).saturating_mul(words).saturating_mul(u64::from(exponent)) / 16
    }

    fn combine(&self, other: &Poly, sign: i64) -> Poly {
        if other.is_zero() {
            return self.clone();
        }
        if self.is_zero() {
            return other.scale(&crate::integer(sign));
        }
        let (a, b) = Poly::unify(self, other);
        let content = rational_gcd(&a.content, &b.content);
        let (p, q) = if content == a.content && content == b.content {
            (Int::ONE, Int::from(sign))
        } else {
            // Both quotients are integers.
            let p = (&a.content / &content).to_integer();
            let q = (&b.content / &content).to_integer() * Int::from(sign);
            (p, q)
        };
        let sum = terms::linear_combination(&p, &a.terms, &q, &b.terms);
        Poly::from_sorted(a.ring.clone(), content, sum)
    }

    fn times(&self, other: &Poly) -> Poly {
        if self.is_zero() || other.is_zero() {
            return Poly::zero();
        }
        if let Some(factor) = self.to_rational() {
            return other.scale(&factor);
        }
        if let Some(factor) = other.to_rational() {
            return self.scale(&factor);
        }
        let (a, b) = Poly::unify(self, other);
        let terms = product(&a.ring, &a.terms, &b.terms);
        let content = &a.content * &b.content;
        if a.ring.field().generators().is_empty() {
            // The product of primitive integer polynomials is primitive (Gauss's lemma).
            return Poly { ring: a.ring.clone(), content, terms };
        }
        Poly::from_sorted(a.ring.clone(), content, terms)
    }
}

binary_operator!(Poly: Add add AddAssign add_assign, |a, b| a.combine(b, 1));
binary_operator!(Poly: Sub sub SubAssign sub_assign, |a, b| a.combine(b, -1));
binary_operator!(Poly: Mul mul MulAssign mul_assign, |a, b| a.times(b));

impl Neg for &Poly {
    type Output = Poly;

    fn neg(self) -> Poly {
        Poly { content: -&self.content, ..self.clone() }
    }
}

impl Neg for Poly {
    type Output = Poly;

    fn neg(self) -> Poly {
        -&self
    }
}

impl Zero for Poly {
    fn zero() -> Poly {
        Poly::zero()
    }

    fn is_zero(&self) -> bool {
        Poly::is_zero(self)
    }
}

impl One for Poly {
    fn one() -> Poly {
        Poly::one()
    }
}

impl Sum for Poly {
    fn sum<I: Iterator<Item = Poly>>(items: I) -> Poly {
        items.fold(Poly::zero(), |sum, item| sum + item)
    }
}

impl Product for Poly {
    fn product<I: Iterator<Item = Poly>>(items: I) -> Poly {
        items.fold(Poly::one(), |product, item| product * item)
    }
}

impl From<Rational> for Poly {
    fn from(value: Rational) -> Poly {
        Poly::constant(value)
    }
}

impl From<i64> for Poly {
    fn from(value: i64) -> Poly {
        Poly::integer(value)
    }
}
