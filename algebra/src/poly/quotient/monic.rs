//! Quotients over a number field, one monomial at a time.

use std::sync::Arc;

use crate::poly::ring::{Monomial, Ring};
use crate::poly::{Poly, Term};
use crate::{Rational, budget};

/// The quotient over a number field by a divisor with the leading coefficient 1, if it is one; its degrees are those of `bound`.
///
/// Each step takes off one monomial in the variables with its coefficient in the field, by a product and a difference of
/// polynomials. Complexity: one such step for each monomial of the quotient. Chosen for small operands, for which images modulo
/// primes cost more to set up.
pub(super) fn divide(ring: &Arc<Ring>, a: &Poly, b: &Poly, bound: Monomial) -> Option<Poly> {
    let leading = ring.variable_part(b.terms.first()?.monomial);
    let mut rest = a.transfer_to(ring);
    let mut quotient: Vec<(Monomial, Rational)> = Vec::new();
    while let Some(first) = rest.terms.first() {
        budget::spend(16 * b.terms.len() as u64);
        let monomial = ring.quotient(ring.variable_part(first.monomial), leading)?;
        ring.quotient(bound, monomial)?;
        let mut step = rest.leading_coefficient();
        for term in &mut step.terms {
            term.monomial = Monomial(term.monomial.0 | monomial.0);
        }
        let scaled = |term: &Term| (term.monomial, &step.content * Rational::from(term.coefficient.clone()));
        quotient.extend(step.terms.iter().map(scaled));
        rest -= step * b;
    }
    Some(Poly::from_rational_terms(ring.clone(), quotient))
}
