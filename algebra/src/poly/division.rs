//! Exact division.

use std::collections::BTreeMap;

use num_integer::Integer;
use num_traits::{One, Zero};

use super::ring::{Monomial, Ring};
use super::{Poly, Term, quotient, terms};
use crate::{Int, Rational, budget};

/// Over a number field, from this many products of terms on, a quotient is found by its images modulo primes; below, by
/// taking off terms, which costs less to set up.
const MODULAR_FROM: usize = 500;

impl Poly {
    /// The quotient `self / divisor`, if that is a polynomial.
    ///
    /// Over the rationals the primitive parts are divided over the integers, which is enough by Gauss's lemma. Over a
    /// number field the divisor is first made monic. Terms are taken off the remainder from the largest down; the first
    /// term that cannot be one of a quotient ends the attempt. Complexity: one ordered-map access for each product of a
    /// term of the quotient and one of the divisor.
    ///
    /// # Panics
    /// If `divisor` is zero.
    #[must_use]
    pub fn exact_div(&self, divisor: &Poly) -> Option<Poly> {
        assert!(!divisor.is_zero(), "division by the zero polynomial");
        if self.is_zero() {
            return Some(Poly::zero());
        }
        if let Some(value) = divisor.to_rational() {
            return Some(self.scale(&value.recip()));
        }
        let (a, b) = Poly::unify(self, divisor);
        let bounds = quotient_degrees(&a, &b)?;
        if a.ring.field().generators().is_empty() {
            let quotient = divide(&a.ring, &a.terms, &b.terms, &bounds)?;
            return Some(Poly::from_sorted(a.ring.clone(), &a.content / &b.content, quotient));
        }
        if a.terms.len() * b.terms.len() > MODULAR_FROM {
            return quotient::modular_quotient(&a, &b);
        }
        // b = c·m with m monic over the field, so a/b = (a/m)/c.
        let inverse = b.leading_coefficient().inverse();
        let monic = (&b * &inverse).transfer_to(&a.ring);
        let quotient = divide_monic(&a.ring, &a, &monic, &bounds)?;
        Some(quotient * inverse)
    }

    /// Whether `self` divides `other`; zero divides only zero.
    #[must_use]
    pub fn divides(&self, other: &Poly) -> bool {
        if self.is_zero() { other.is_zero() } else { other.exact_div(self).is_some() }
    }

    /// Divides by `divisor` as often as that goes: `(m, q)` with `self = divisor^m · q`. For constants `(0, self)`.
    #[must_use]
    pub fn take_out(&self, divisor: &Poly) -> (u32, Poly) {
        let mut rest = self.clone();
        let mut multiplicity = 0;
        if divisor.is_constant() || self.is_zero() {
            return (0, rest);
        }
        while let Some(quotient) = rest.exact_div(divisor) {
            rest = quotient;
            multiplicity += 1;
        }
        (multiplicity, rest)
    }

    /// The coefficient, in the field, of the lexicographically largest monomial in the variables; zero for zero.
    #[must_use]
    pub fn leading_coefficient(&self) -> Poly {
        let Some(first) = self.terms.first() else { return Poly::zero() };
        let leading = self.ring.variable_part(first.monomial);
        let terms: Vec<Term> = self
            .terms
            .iter()
            .take_while(|term| self.ring.variable_part(term.monomial) == leading)
            .map(|term| Term { monomial: self.ring.generator_part(term.monomial), ..term.clone() })
            .collect();
        Poly::from_sorted(self.ring.clone(), self.content.clone(), terms)
    }

    /// `self` divided by its leading coefficient (see [`Poly::leading_coefficient`]); zero for zero.
    #[must_use]
    pub fn monic(&self) -> Poly {
        if self.is_zero() { self.clone() } else { self * self.leading_coefficient().inverse() }
    }

    /// The representative of all nonzero multiples by numbers of the field that has a rational leading coefficient, and
    /// content 1.
    ///
    /// It is what gcds and factors are normalized to, so that equal factors compare equal.
    #[must_use]
    pub fn normalized(&self) -> Poly {
        if self.ring.field().generators().is_empty() || self.leading_coefficient().to_rational().is_some() {
            return self.primitive();
        }
        self.monic().primitive()
    }

    pub(crate) fn transfer_to(&self, ring: &std::sync::Arc<Ring>) -> Poly {
        if *self.ring == **ring { Poly { ring: ring.clone(), ..self.clone() } } else { self.transfer(ring) }
    }
}

/// The degrees of `a/b` in each variable, unless one would be negative.
fn quotient_degrees(a: &Poly, b: &Poly) -> Option<Vec<u32>> {
    let degree = |poly: &Poly, i: usize| poly.terms.iter().map(|t| poly.ring.exponent(t.monomial, i)).max();
    (0..a.ring.variables().len()).map(|i| degree(a, i)?.checked_sub(degree(b, i)?)).collect()
}

fn within(ring: &Ring, monomial: Monomial, bounds: &[u32]) -> bool {
    bounds.iter().enumerate().all(|(i, &bound)| ring.exponent(monomial, i) <= bound)
}

fn divide(ring: &Ring, a: &[Term], b: &[Term], bounds: &[u32]) -> Option<Vec<Term>> {
    let mut rest: BTreeMap<Monomial, Int> =
        a.iter().map(|term| (term.monomial, term.coefficient.clone())).collect();
    let (leading, tail) = b.split_first()?;
    // The smallest terms must divide as well: a cheap test that most failures do not pass.
    let (last_a, last_b) = (a.last()?, b.last()?);
    ring.quotient(last_a.monomial, last_b.monomial)?;
    if !last_a.coefficient.is_multiple_of(&last_b.coefficient) {
        return None;
    }
    let mut quotient = Vec::new();
    while let Some((monomial, coefficient)) = rest.pop_last() {
        if coefficient.is_zero() {
            continue;
        }
        budget::spend(4 * b.len() as u64);
        let monomial = ring.quotient(monomial, leading.monomial).filter(|&m| within(ring, m, bounds))?;
        let (factor, remainder) = coefficient.div_rem(&leading.coefficient);
        if !remainder.is_zero() {
            return None;
        }
        for term in tail {
            let entry = rest.entry(Monomial(monomial.0 + term.monomial.0)).or_default();
            *entry -= &factor * &term.coefficient;
        }
        quotient.push(Term { monomial, coefficient: factor });
    }
    Some(quotient)
}

fn divide_monic(ring: &std::sync::Arc<Ring>, a: &Poly, b: &Poly, bounds: &[u32]) -> Option<Poly> {
    let mut rest: BTreeMap<Monomial, Rational> =
        a.terms.iter().map(|term| (term.monomial, Rational::from(term.coefficient.clone()))).collect();
    let leading = b.terms.first()?.monomial;
    let mut quotient: Vec<(Monomial, Rational)> = Vec::new();
    while let Some((monomial, coefficient)) = rest.pop_last() {
        if coefficient.is_zero() {
            continue;
        }
        budget::spend(16 * b.terms.len() as u64);
        let generators = ring.generator_part(monomial);
        let monomial =
            ring.quotient(ring.variable_part(monomial), leading).filter(|&m| within(ring, m, bounds))?;
        let monomial = Monomial(monomial.0 + generators.0);
        let shifted: Vec<Term> = b
            .terms
            .iter()
            .skip(1)
            .map(|term| Term { monomial: Monomial(monomial.0 + term.monomial.0), ..term.clone() })
            .collect();
        let scale = &coefficient * b.content();
        for term in terms::reduce(ring, terms::collect(shifted)) {
            let entry = rest.entry(term.monomial).or_insert_with(Rational::zero);
            *entry -= &scale * Rational::from(term.coefficient);
        }
        quotient.push((monomial, coefficient));
    }
    Some(Poly::from_rational_terms(ring.clone(), quotient).scale(a.content()))
}

impl Poly {
    /// The polynomial with the given rational coefficients of distinct reduced monomials.
    pub(crate) fn from_rational_terms(
        ring: std::sync::Arc<Ring>,
        mut coefficients: Vec<(Monomial, Rational)>,
    ) -> Poly {
        coefficients.retain(|(_, value)| !value.is_zero());
        coefficients.sort_by_key(|(monomial, _)| std::cmp::Reverse(*monomial));
        let denominator = coefficients.iter().fold(Int::ONE, |d, (_, value)| d.lcm(value.denom()));
        let terms = coefficients
            .into_iter()
            .map(|(monomial, value)| {
                let coefficient = value.numer() * (&denominator / value.denom());
                Term { monomial, coefficient }
            })
            .collect();
        Poly::from_sorted(ring, Rational::new(Int::one(), denominator), terms)
    }
}
