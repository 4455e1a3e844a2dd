//! Quotients of polynomials.
//!
//! | way | where | cost for each product of a term of the quotient and one of the divisor |
//! | --- | --- | --- |
//! | [`array`] | over the rationals, where exponents fill boxes well enough | some 2 ns |
//! | [`heap`] | over the rationals, everything else | some 20 ns times the logarithm of the divisor's size |
//! | [`monic`] | over number fields, small operands | a product of numbers of the field |
//! | [`modular`] | over number fields, everything else | for each prime and homomorphism a step in a heap |
//!
//! All find the terms of the quotient from the largest down, and the first that cannot be one ends the attempt: trial divisions,
//! most of which fail, are cheap.

mod array;
mod heap;
mod modular;
mod monic;

use super::evaluation::image_excludes;
use super::ring::Monomial;
use super::{Poly, Term};
use crate::Int;
use array::Division;

/// Over the rationals, a dividend of more terms is looked at modulo a prime first, since most trial divisions fail.
const IMAGE_FROM: usize = 100;

/// Over a number field, from this many products of terms on, a quotient is found by its images modulo primes.
const MODULAR_FROM: usize = 500;

/// The quotient of nonzero polynomials of one ring, if it is a polynomial.
///
/// Over the rationals the primitive parts are divided over the integers, which is enough by Gauss's lemma.
pub(super) fn quotient(a: &Poly, b: &Poly) -> Option<Poly> {
    let ring = &a.ring;
    let degrees: Option<Vec<u32>> =
        a.degrees().into_iter().zip(b.degrees()).map(|(a, b)| a.checked_sub(b)).collect();
    let bound = ring.monomial(&degrees?, &[]);
    if ring.field().generators().is_empty() {
        if a.terms.len() > IMAGE_FROM && image_excludes(a, b) {
            return None;
        }
        let terms = integer_quotient(a, b, bound)?;
        return Some(Poly::from_sorted(ring.clone(), &a.content / &b.content, terms));
    }
    if a.terms.len() * b.terms.len() > MODULAR_FROM || !monic::suits(b) {
        return modular::quotient(a, b);
    }
    monic::quotient(a, b, bound)
}

fn integer_quotient(a: &Poly, b: &Poly, bound: Monomial) -> Option<Vec<Term>> {
    if b.terms.len() > 1
        && let Some(division) = Division::new(&a.ring, &a.terms, &b.terms, bound)
    {
        let found =
            division.run::<i64>().or_else(|_| division.run::<i128>()).or_else(|_| division.run::<Int>());
        if let Ok(found) = found {
            return found;
        }
    }
    heap::divide(&a.ring, &a.terms, &b.terms, bound)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use num_traits::Zero;
    use proptest::prelude::*;

    use super::*;
    use crate::poly::Ring;
    use crate::{Rational, Variable, ratio};

    /// The division that takes all products off a map of the remainder at once.
    fn naive_quotient(a: &Poly, b: &Poly) -> Option<Poly> {
        if a.is_zero() {
            return Some(Poly::zero());
        }
        let ring = &a.ring;
        let degrees = a.degrees().into_iter().zip(b.degrees()).map(|(a, b)| a.checked_sub(b));
        let bound = ring.monomial(&degrees.collect::<Option<Vec<u32>>>()?, &[]);
        let mut rest: BTreeMap<Monomial, Rational> =
            a.terms.iter().map(|term| (term.monomial, Rational::from(term.coefficient.clone()))).collect();
        let mut quotient = Vec::new();
        while let Some((monomial, coefficient)) = rest.pop_last() {
            if coefficient.is_zero() {
                continue;
            }
            let monomial = ring.quotient(monomial, b.terms[0].monomial)?;
            ring.quotient(bound, monomial)?;
            let factor = coefficient / Rational::from(b.terms[0].coefficient.clone());
            for term in &b.terms[1..] {
                let entry = rest.entry(Monomial(monomial.0 + term.monomial.0)).or_insert_with(Rational::zero);
                *entry -= &factor * Rational::from(term.coefficient.clone());
            }
            quotient.push((monomial, factor));
        }
        Some(Poly::from_rational_terms(ring.clone(), quotient).scale(&(&a.content / &b.content)))
    }

    fn polynomials(terms: usize) -> impl Strategy<Value = Poly> {
        (prop::collection::vec((0_u32..4, 0_u32..4, 0_u32..3, -9_i64..=9), 1..=terms), 0_u32..80).prop_map(
            |(terms, bits)| {
                let [u, v, a] = [(0, "u"), (1, "v"), (Variable::SYMBOL, "a")]
                    .map(|(rank, name)| Variable::new(rank, name));
                let ring = Ring::new([u, v, a], crate::NumberField::rationals());
                let term = |(i, j, k, value): (u32, u32, u32, i64)| {
                    (ring.monomial(&[i, j, k], &[]), ratio(value, 3))
                };
                let distinct: BTreeMap<Monomial, Rational> = terms.into_iter().map(term).collect();
                let poly = Poly::from_rational_terms(ring.clone(), distinct.into_iter().collect());
                // Coefficients of one word, and of more.
                poly + Poly::constant(Int::ONE.shl(bits.into()).into()).transfer(&ring)
            },
        )
    }

    /// What every way to divide over the integers finds, for polynomials that no monomial excludes.
    fn all_quotients(a: &Poly, b: &Poly) -> Vec<Option<Poly>> {
        let degrees = a.degrees().into_iter().zip(b.degrees()).map(|(a, b)| a.checked_sub(b));
        let Some(degrees) = degrees.collect::<Option<Vec<u32>>>() else { return vec![None] };
        let bound = a.ring.monomial(&degrees, &[]);
        let mut found = vec![heap::divide(&a.ring, &a.terms, &b.terms, bound)];
        for division in Division::all(&a.ring, &a.terms, &b.terms, bound) {
            found.extend(
                [division.run::<i64>(), division.run::<i128>(), division.run::<Int>()].into_iter().flatten(),
            );
        }
        let content = &a.content / &b.content;
        let poly = |terms: Vec<Term>| Poly::from_sorted(a.ring.clone(), content.clone(), terms);
        found.into_iter().map(|terms| terms.map(poly)).collect()
    }

    proptest! {
        #[test]
        fn all_ways_agree_with_the_naive_one(a in polynomials(8), b in polynomials(8), r in polynomials(2)) {
            prop_assume!(!b.is_zero());
            let exact = (&a * &b).transfer_to(&b.ring);
            for dividend in [exact.clone(), exact + r] {
                prop_assume!(!dividend.is_zero());
                let expected = naive_quotient(&dividend, &b);
                prop_assert_eq!(&dividend.exact_div(&b), &expected);
                for found in all_quotients(&dividend, &b) {
                    prop_assert_eq!(&found, &expected);
                }
            }
        }
    }
}
