//! Products of sorted lists of terms with integer coefficients.
//!
//! | way | where | cost |
//! | --- | --- | --- |
//! | [`monomial`] | one operand has one term or two | one product of coefficients for each term, and a merge |
//! | [`array`] | the exponents of the product fill boxes well enough | some 1–3 ns for each product of terms |
//! | [`table`] | everything else | some 10 ns for each product of terms as long as the sums fit the cache, then a sort |
//!
//! All accumulate without allocation, in cells as wide as the largest sum can be (see [`Cell`]).

mod array;
mod table;

use super::boxes::cell::{Cell, Wide};
use super::reduction::reduce;
use super::ring::{Monomial, Ring};
use super::{Term, terms};
use crate::{Int, budget};
use array::Plan;

/// The product of sorted lists of terms, with the rules of the field applied.
pub(crate) fn product(ring: &Ring, x: &[Term], y: &[Term]) -> Vec<Term> {
    let (x, y) = if x.len() <= y.len() { (x, y) } else { (y, x) };
    let Some(first) = x.first() else { return Vec::new() };
    // The product has terms of these exponents.
    let degrees = [x, y].map(|terms| terms::maximum(ring, terms));
    ring.check_exponents(degrees[0] + degrees[1]);
    let widths = max_bits(x) + max_bits(y) + u64::from(usize::BITS - x.len().leading_zeros());
    let price = (x.len() as u64).saturating_mul(y.len() as u64).saturating_mul(1 + widths / 64);
    // Where sums lie in arrays, the work for eight products of words is one unit.
    budget::spend(price / 8);
    let unreduced = match x {
        [_] => monomial(first, y),
        [_, second] => {
            let one = Int::ONE;
            terms::linear_combination(&one, &monomial(first, y), &one, &monomial(second, y))
        }
        // One bit is the sign's.
        _ => match widths {
            ..63 => multiply::<i64>(ring, x, y, degrees),
            63..127 => multiply::<i128>(ring, x, y, degrees),
            127..255 => multiply::<Wide<4>>(ring, x, y, degrees),
            255..511 => multiply::<Wide<8>>(ring, x, y, degrees),
            511..1023 => multiply::<Wide<16>>(ring, x, y, degrees),
            _ => multiply::<Int>(ring, x, y, degrees),
        },
    };
    reduce(ring, unreduced)
}

fn max_bits(terms: &[Term]) -> u64 {
    let (mut most, mut i) = (0, 0);
    while i < terms.len() {
        most = most.max(terms[i].coefficient.bits());
        i += 1;
    }
    most
}

/// The product with one term.
fn monomial(factor: &Term, terms: &[Term]) -> Vec<Term> {
    let mut product = Vec::with_capacity(terms.len());
    for term in terms {
        let coefficient = &factor.coefficient * &term.coefficient;
        product.push(Term { monomial: Monomial(factor.monomial.0 + term.monomial.0), coefficient });
    }
    product
}

/// The product in the way that suits the exponents.
fn multiply<C: Cell>(ring: &Ring, x: &[Term], y: &[Term], degrees: [u128; 2]) -> Vec<Term> {
    let coefficients = |terms: &[Term]| terms.iter().map(|term| C::of(&term.coefficient)).collect::<Vec<C>>();
    let (a, b) = (coefficients(x), coefficients(y));
    match Plan::new(ring, [x, y], degrees[0] + degrees[1], size_of::<C>()) {
        Some(plan) => plan.multiply([x, y], [&a, &b]),
        None => table::multiply([x, y], [&a, &b]),
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::sync::Arc;

    use num_traits::Zero;
    use proptest::prelude::*;

    use super::*;
    use crate::poly::terms::collect;
    use crate::{NumberField, Variable};

    /// A ring in six variables.
    fn ring() -> Arc<Ring> {
        Ring::new((0..6).map(|rank| Variable::new(rank, "x")), NumberField::rationals())
    }

    fn polynomials(highest: u32, most: usize, bits: u32) -> impl Strategy<Value = Vec<Term>> {
        let term = (prop::collection::vec(0..=highest, 6), -5_i64..=5, 0..=bits);
        prop::collection::vec(term, 0..most).prop_map(|terms| {
            let term = |(exponents, value, bits): (Vec<u32>, i64, u32)| Term {
                monomial: ring().monomial(&exponents, &[]),
                coefficient: Int::from(value).shl(bits.into()) + Int::from(value),
            };
            collect(terms.into_iter().map(term).collect())
        })
    }

    fn naive_product(x: &[Term], y: &[Term]) -> Vec<Term> {
        let mut sums: BTreeMap<Monomial, Int> = BTreeMap::new();
        for (p, q) in x.iter().flat_map(|p| y.iter().map(move |q| (p, q))) {
            *sums.entry(Monomial(p.monomial.0 + q.monomial.0)).or_default() +=
                &p.coefficient * &q.coefficient;
        }
        let terms = sums.into_iter().rev().filter(|(_, coefficient)| !coefficient.is_zero());
        terms.map(|(monomial, coefficient)| Term { monomial, coefficient }).collect()
    }

    /// Every way in cells of every width that holds the sums.
    fn all_products(x: &[Term], y: &[Term]) -> Vec<Vec<Term>> {
        let mut found = vec![product(&ring(), x, y)];
        let widths = max_bits(x) + max_bits(y) + u64::from(usize::BITS - x.len().leading_zeros());
        if widths < 63 {
            found.extend(ways::<i64>(x, y));
        }
        if widths < 127 {
            found.extend(ways::<i128>(x, y));
        }
        if widths < 255 {
            found.extend(ways::<Wide<4>>(x, y));
        }
        found.extend(ways::<Wide<16>>(x, y));
        found.extend(ways::<Int>(x, y));
        found
    }

    fn ways<C: Cell>(x: &[Term], y: &[Term]) -> Vec<Vec<Term>> {
        let ring = ring();
        let [a, b] =
            [x, y].map(|terms| terms.iter().map(|term| C::of(&term.coefficient)).collect::<Vec<C>>());
        let exponents = terms::maximum(&ring, x) + terms::maximum(&ring, y);
        let mut found = vec![table::multiply([x, y], [&a, &b])];
        found.extend(Plan::all(&ring, exponents).into_iter().map(|plan| plan.multiply([x, y], [&a, &b])));
        found
    }

    proptest! {
        #[test]
        fn all_ways_agree_with_the_naive_one(
            sparse in [polynomials(9, 20, 40), polynomials(9, 20, 40)],
            dense in [polynomials(1, 50, 0), polynomials(1, 50, 0)],
            large in [polynomials(2, 9, 400), polynomials(2, 9, 400)],
        ) {
            for [x, y] in [sparse, dense, large] {
                let expected = naive_product(&x, &y);
                for found in all_products(&x, &y) {
                    prop_assert_eq!(&found, &expected);
                }
            }
        }
    }
}
