//! Quotients by a heap of products.

use num_integer::Integer;
use num_traits::Zero;

use crate::modular::heap::{NextProduct, ProductHeap};
use crate::poly::Term;
use crate::poly::ring::{Monomial, Ring};
use crate::{Int, budget};

/// The quotient of sorted lists of terms over the integers, if it is one; the degrees of the quotient are those of `bound`.
///
/// Johnson's heap (*Sparse polynomial arithmetic*, 1974) holds the products that are to be taken off next: one product of each
/// term of the divisor waits in it at a time. Complexity: O(log n) for each product of a term of the quotient and one of the
/// n terms of the divisor. Chosen where exponents are too scattered for boxes.
pub(super) fn divide(ring: &Ring, a: &[Term], b: &[Term], bound: Monomial) -> Option<Vec<Term>> {
    let (leading, tail) = b.split_first()?;
    let mut quotient: Vec<Term> = Vec::new();
    let mut heap = ProductHeap::default();
    // Terms of the tail whose next partner is not known yet.
    let mut waiting: Vec<usize> = (0..tail.len()).collect();
    let mut own = 0;
    loop {
        let next = a.get(own).map(|term| term.monomial.0).max(heap.top().map(|product| product.word));
        let Some(word) = next else { return Some(quotient) };
        let mut coefficient = Int::ZERO;
        if let Some(term) = a.get(own).filter(|term| term.monomial.0 == word) {
            coefficient = term.coefficient.clone();
            own += 1;
        }
        while let Some(product) = heap.top_at(word) {
            let NextProduct { divisor: j, quotient: i, .. } = product;
            coefficient -= &tail[j].coefficient * &quotient[i].coefficient;
            if let Some(partner) = quotient.get(i + 1) {
                let word = tail[j].monomial.0 + partner.monomial.0;
                heap.replace_top(NextProduct { word, divisor: j, quotient: i + 1 });
            } else {
                heap.pop();
                waiting.push(j);
            }
        }
        if coefficient.is_zero() {
            continue;
        }
        budget::spend(4 * b.len() as u64);
        let monomial = ring.quotient(Monomial(word), leading.monomial)?;
        ring.quotient(bound, monomial)?;
        let (factor, remainder) = coefficient.div_rem(&leading.coefficient);
        if !remainder.is_zero() {
            return None;
        }
        for j in waiting.drain(..) {
            let word = tail[j].monomial.0 + monomial.0;
            heap.push(NextProduct { word, divisor: j, quotient: quotient.len() });
        }
        quotient.push(Term { monomial, coefficient: factor });
    }
}
