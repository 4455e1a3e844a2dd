//! Coefficients, derivatives, integrals, substitution and evaluation.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::ring::{Monomial, Ring, Variable};
use super::{Poly, Term};
use crate::number::field::NumberField;
use crate::{Int, Rational, ratio};

impl Poly {
    /// The coefficients of the powers of `variable`, from the constant one up; empty for the zero polynomial.
    ///
    /// ```
    /// use hodograph_algebra::{Poly, Variable};
    /// let u = Variable::new(0, "u");
    /// let f = Poly::variable(&u).pow(2) + Poly::integer(3);
    /// assert_eq!(f.coefficients(&u), [Poly::integer(3), Poly::zero(), Poly::one()]);
    /// ```
    #[must_use]
    pub fn coefficients(&self, variable: &Variable) -> Vec<Poly> {
        let Some(degree) = self.degree(variable) else { return Vec::new() };
        let Some(position) = self.ring.position(variable) else { return vec![self.clone()] };
        let word = self.ring.variable_word(position);
        let mut lists: Vec<Vec<Term>> = vec![Vec::new(); degree as usize + 1];
        for term in &self.terms {
            let exponent = self.ring.exponent(term.monomial, position);
            let monomial = Monomial(term.monomial.0 - word * u128::from(exponent));
            lists[exponent as usize].push(Term { monomial, coefficient: term.coefficient.clone() });
        }
        let build = |list| Poly::from_sorted(self.ring.clone(), self.content.clone(), list);
        lists.into_iter().map(build).collect()
    }

    /// The polynomial `Σ coefficients[i] · variable^i`.
    #[must_use]
    pub fn from_coefficients(variable: &Variable, coefficients: &[Poly]) -> Poly {
        let x = Poly::variable(variable);
        coefficients.iter().rev().fold(Poly::zero(), |sum, coefficient| sum * &x + coefficient)
    }

    /// The coefficients of all monomials in `variables`, keyed by the exponents in the order given.
    #[must_use]
    pub fn coefficients_of(&self, variables: &[Variable]) -> BTreeMap<Vec<u32>, Poly> {
        let Some((first, rest)) = variables.split_first() else {
            return if self.is_zero() {
                BTreeMap::new()
            } else {
                BTreeMap::from([(Vec::new(), self.clone())])
            };
        };
        let mut all = BTreeMap::new();
        for (exponent, coefficient) in (0_u32..).zip(self.coefficients(first)) {
            for (mut exponents, value) in coefficient.coefficients_of(rest) {
                exponents.insert(0, exponent);
                all.insert(exponents, value);
            }
        }
        all
    }

    /// The partial derivative by `variable`.
    #[must_use]
    pub fn derivative(&self, variable: &Variable) -> Poly {
        let Some(position) = self.ring.position(variable) else { return Poly::zero() };
        let word = self.ring.variable_word(position);
        let derived = self.terms.iter().filter_map(|term| {
            let exponent = self.ring.exponent(term.monomial, position);
            let monomial = Monomial(term.monomial.0.checked_sub(word)?);
            (exponent > 0).then(|| Term { monomial, coefficient: &term.coefficient * Int::from(exponent) })
        });
        // Lowering one exponent of all terms keeps their order.
        Poly::from_sorted(self.ring.clone(), self.content.clone(), derived.collect())
    }

    /// The antiderivative by `variable` that vanishes where `variable` is zero.
    #[must_use]
    pub fn integral(&self, variable: &Variable) -> Poly {
        let mut lists = self.coefficients(variable);
        for (power, coefficient) in (1_i64..).zip(&mut lists) {
            *coefficient = coefficient.scale(&ratio(1, power));
        }
        lists.insert(0, Poly::zero());
        Poly::from_coefficients(variable, &lists)
    }

    /// The polynomial with `value` in place of `variable`.
    ///
    /// Horner's rule in the coefficients of `variable`.
    #[must_use]
    pub fn substitute(&self, variable: &Variable, value: &Poly) -> Poly {
        if !self.contains(variable) {
            return self.clone();
        }
        let coefficients = self.coefficients(variable);
        coefficients.iter().rev().fold(Poly::zero(), |sum, coefficient| sum * value + coefficient)
    }

    /// `value^degree · self(x/value)` for `x = numerator`: the numerator of `self` where `variable` is replaced by the
    /// fraction `numerator / denominator`, over `denominator^degree`. `degree` is at least the degree in `variable`.
    #[must_use]
    pub fn substitute_fraction(
        &self,
        variable: &Variable,
        numerator: &Poly,
        denominator: &Poly,
        degree: u32,
    ) -> Poly {
        let mut coefficients = self.coefficients(variable);
        coefficients.resize((degree as usize + 1).max(coefficients.len()), Poly::zero());
        let mut sum = Poly::zero();
        let mut power = Poly::one();
        for coefficient in coefficients.iter().rev() {
            sum = sum * numerator + coefficient * &power;
            power *= denominator;
        }
        sum
    }

    /// The polynomial with numbers or other polynomials in place of several variables at once.
    #[must_use]
    pub fn evaluate(&self, values: &BTreeMap<Variable, Poly>) -> Poly {
        // One variable after the other would substitute into what was put in, unless the new variables are others.
        let clash =
            values.values().any(|value| value.occurring_variables().iter().any(|v| values.contains_key(v)));
        if !clash {
            return values
                .iter()
                .fold(self.clone(), |poly, (variable, value)| poly.substitute(variable, value));
        }
        let fresh = |i: usize| Variable::new(u32::MAX, &format!("substitute{i}"));
        let renamed = values
            .keys()
            .enumerate()
            .fold(self.clone(), |poly, (i, variable)| poly.substitute(variable, &Poly::variable(&fresh(i))));
        values.values().enumerate().fold(renamed, |poly, (i, value)| poly.substitute(&fresh(i), value))
    }

    /// The value at a rational point.
    #[must_use]
    pub fn at(&self, point: &[(&Variable, &Rational)]) -> Poly {
        point.iter().fold(self.clone(), |poly, (variable, value)| {
            poly.substitute(variable, &Poly::constant((*value).clone()))
        })
    }

    /// The coefficients in the basis of the field's generators: pairs of the generators' exponents and a polynomial
    /// with rational coefficients.
    #[must_use]
    pub fn generator_coefficients(&self) -> BTreeMap<Vec<u32>, Poly> {
        let rational = Ring::new(self.ring.variables().iter().cloned(), NumberField::rationals());
        let transfer = self.ring.transfer(&rational);
        let mut lists: BTreeMap<Vec<u32>, Vec<Term>> = BTreeMap::new();
        for term in &self.terms {
            let exponents = self.ring.generator_exponents(term.monomial);
            let monomial = transfer.monomial(self.ring.variable_part(term.monomial));
            let list = lists.entry(exponents).or_default();
            list.push(Term { monomial, coefficient: term.coefficient.clone() });
        }
        let build = |list| Poly::from_sorted(rational.clone(), self.content.clone(), list);
        lists.into_iter().map(|(exponents, list)| (exponents, build(list))).collect()
    }

    /// The image under the homomorphism that maps the generators of the field to numbers of `field`.
    #[must_use]
    pub fn map_generators(&self, field: &Arc<NumberField>, images: &[Poly]) -> Poly {
        let ring = Ring::new(self.ring.variables().iter().cloned(), field.clone());
        let mut sum = Poly::constant_in(ring, crate::integer(0));
        for (exponents, coefficient) in self.generator_coefficients() {
            let image: Poly = exponents
                .iter()
                .zip(images)
                .filter(|(e, _)| **e == 1)
                .map(|(_, image)| image.clone())
                .product();
            sum += coefficient * image;
        }
        sum
    }

    /// The polynomial without those variables of its ring that do not occur.
    #[must_use]
    pub fn pruned(&self) -> Poly {
        self.transfer_to(&Ring::new(self.occurring_variables(), self.ring.field().clone()))
    }

    /// The polynomial with the generator at `position` replaced by its negative: the conjugate in the last quadratic
    /// extension, if it is the last one.
    pub(crate) fn conjugate(&self, position: usize) -> Poly {
        let flip = |term: &Term| {
            let odd = self.ring.generator_exponent(term.monomial, position) == 1;
            Term {
                monomial: term.monomial,
                coefficient: if odd { -&term.coefficient } else { term.coefficient.clone() },
            }
        };
        Poly::from_sorted(self.ring.clone(), self.content.clone(), self.terms.iter().map(flip).collect())
    }

    /// The sum of `scale · poly` over `items`, collected once.
    #[must_use]
    pub fn linear_combination(items: &[(Rational, Poly)]) -> Poly {
        items.iter().fold(Poly::zero(), |sum, (scale, poly)| sum + poly.scale(scale))
    }

    /// The product with the monomial `variable^exponent`.
    #[must_use]
    pub fn shift(&self, variable: &Variable, exponent: u32) -> Poly {
        self * Poly::variable(variable).pow(exponent)
    }
}
