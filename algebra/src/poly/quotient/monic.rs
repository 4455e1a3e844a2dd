//! Quotients over a number field, one monomial at a time.

use std::sync::Arc;

use num_integer::Integer;
use num_traits::One;

use crate::modular::field::PrimeField;
use crate::poly::evaluation::Evaluation;
use crate::poly::images::Frame;
use crate::poly::product::product;
use crate::poly::ring::{Monomial, Ring};
use crate::poly::{Poly, Term, terms};
use crate::{Int, Rational, budget};

/// A dividend of more terms is looked at modulo a prime first, since most trial divisions fail.
const IMAGE_FROM: usize = 16;

/// The most bits of the norm of a divisor's leading coefficient.
const MOST_BITS: u64 = 256;

/// Whether the monic multiple of a divisor has coefficients of a sensible size.
pub(super) fn suits(divisor: &Poly) -> bool {
    let leading = divisor.leading_coefficient();
    let bits = leading.terms.iter().map(|term| term.coefficient.bits()).max().unwrap_or(0);
    leading.to_rational().is_some() || bits.saturating_mul(divisor.ring.field().degree()) <= MOST_BITS
}

/// The quotient over a number field, if it is one; its degrees are those of `bound`.
///
/// The divisor is made monic. Then each step takes off one monomial in the variables with its coefficient in the field. The
/// remainder is kept as integers over one denominator, which grows by what the leading integer of the divisor's primitive part
/// does not find in a coefficient of the quotient: so it is the least common denominator of the terms found so far, and no step
/// needs another gcd than with that integer. Complexity: for each monomial of the quotient a product of its coefficient and the
/// divisor. Chosen for small operands, for which images modulo primes cost more to set up.
pub(super) fn quotient(a: &Poly, b: &Poly, bound: Monomial) -> Option<Poly> {
    if a.terms.len() > IMAGE_FROM && image_excludes(a, b) {
        return None;
    }
    // b = c·m with m monic over the field, so a/b = (a/m)/c.
    let inverse = b.leading_coefficient().inverse();
    let quotient = divide(&a.ring, a, &(b * &inverse).transfer_to(&a.ring), bound)?;
    Some(quotient * inverse)
}

/// The quotient by a polynomial with the leading coefficient 1.
fn divide(ring: &Arc<Ring>, a: &Poly, b: &Poly, bound: Monomial) -> Option<Poly> {
    let (first, tail) = b.terms.split_first()?;
    let (leading, divisor) = (ring.variable_part(first.monomial), &first.coefficient);
    let mut rest = a.terms.clone();
    let mut denominator = Int::ONE;
    // Each coefficient with the denominator of its time.
    let mut found: Vec<(Vec<Term>, Int)> = Vec::new();
    while let Some(first) = rest.first() {
        let variables = ring.variable_part(first.monomial);
        let monomial = ring.quotient(variables, leading)?;
        ring.quotient(bound, monomial)?;
        let count = rest.iter().take_while(|term| ring.variable_part(term.monomial) == variables).count();
        budget::spend((4 * count * b.terms.len() + rest.len()) as u64);
        let common = rest[..count].iter().fold(divisor.clone(), |common, term| common.gcd(&term.coefficient));
        let missing = divisor / &common;
        let coefficient = |term: &Term| Term {
            monomial: Monomial(ring.generator_part(term.monomial).0 | monomial.0),
            coefficient: if common.is_one() { term.coefficient.clone() } else { &term.coefficient / &common },
        };
        let step: Vec<Term> = rest[..count].iter().map(coefficient).collect();
        let products = product(ring, &step, tail);
        rest = terms::linear_combination(&missing, &rest[count..], &Int::from(-1), &products);
        denominator *= &missing;
        found.push((step, denominator.clone()));
    }
    let over_common = |(step, own): (Vec<Term>, Int)| {
        let factor = &denominator / own;
        step.into_iter().map(move |term| Term { coefficient: term.coefficient * &factor, ..term })
    };
    let quotient = found.into_iter().flat_map(over_common).collect();
    let content = &a.content / &b.content / Rational::from(denominator.clone());
    Some(Poly::from_sorted(ring.clone(), content, quotient))
}

/// Whether an image modulo a prime proves that `b` does not divide `a`: its image would divide that of `a`.
fn image_excludes(a: &Poly, b: &Poly) -> bool {
    let degrees = a.degrees();
    let positions: Vec<usize> = (0..degrees.len()).filter(|&i| degrees[i] > 0).collect();
    let Some(position) = b.degrees().iter().position(|&degree| degree > 0) else { return false };
    let most: Vec<u32> = positions.iter().map(|&i| degrees[i]).collect();
    let frame = Frame::new([a, b], positions, &most);
    let splitting = frame.splitting(&mut PrimeField::sequence());
    let evaluation = Evaluation::new(&a.ring, splitting.field(), &frame.generator_images(&splitting));
    let remainder = evaluation.image(a, position).divide(splitting.field(), &evaluation.image(b, position));
    remainder.is_some_and(|(_, remainder)| !remainder.is_zero())
}
