//! Sparse polynomials over the integers as sorted lists of packed exponents, multiplied and divided as in a textbook.

use std::collections::{BTreeMap, BinaryHeap};

use hodograph_algebra::{Int, Poly, Variable};
use num_integer::Integer;
use num_traits::Zero;

/// Terms by descending monomial: 12 bits for each exponent, the first variable in the most significant ones.
pub(crate) type Packed = Vec<(u128, Int)>;

/// Bits of an exponent, the highest of which stays clear.
const BITS: usize = 12;

/// The primitive part of a polynomial over the rationals, which has no other variables and no exponent above 2047.
pub(crate) fn pack(poly: &Poly, variables: &[Variable]) -> Packed {
    let own = poly.ring().variables();
    let place = |variable: &Variable| variables.iter().position(|other| other == variable);
    let places: Vec<Option<usize>> = own.iter().map(place).collect();
    let word = |exponents: Vec<u32>| {
        let shifted = |(exponent, place): (&u32, &Option<usize>)| {
            place.map_or(0, |place| u128::from(*exponent) << (BITS * (variables.len() - 1 - place)))
        };
        exponents.iter().zip(&places).map(shifted).sum::<u128>()
    };
    let terms = poly.terms().iter();
    let mut packed: Packed =
        terms.map(|term| (word(poly.ring().exponents(term.monomial)), term.coefficient.clone())).collect();
    packed.sort_by_key(|term| std::cmp::Reverse(term.0));
    packed
}

/// The product, summed in an ordered map.
pub(crate) fn product_by_map(a: &Packed, b: &Packed) -> Packed {
    let mut sums: BTreeMap<u128, Int> = BTreeMap::new();
    for (left, x) in a {
        for (right, y) in b {
            *sums.entry(left + right).or_default() += x * y;
        }
    }
    sums.into_iter().rev().filter(|(_, sum)| !sum.is_zero()).collect()
}

/// The product, whose terms are merged by a heap with one product of each term of `a` (Johnson, *Sparse polynomial arithmetic*,
/// 1974).
pub(crate) fn product_by_heap(a: &Packed, b: &Packed) -> Packed {
    let Some((first, _)) = b.first() else { return Packed::new() };
    let mut heap: BinaryHeap<(u128, usize, usize)> =
        a.iter().enumerate().map(|(i, (word, _))| (word + first, i, 0)).collect();
    let mut product = Packed::new();
    while let Some(&(word, ..)) = heap.peek() {
        let mut sum = Int::zero();
        while let Some(mut top) = heap.peek_mut().filter(|top| top.0 == word) {
            let (_, i, j) = *top;
            sum += &a[i].1 * &b[j].1;
            match b.get(j + 1) {
                Some((next, _)) => *top = (a[i].0 + next, i, j + 1),
                None => drop(std::collections::binary_heap::PeekMut::pop(top)),
            }
        }
        if !sum.is_zero() {
            product.push((word, sum));
        }
    }
    product
}

/// The quotient of polynomials in `count` variables over the integers, if there is one: the products of each of its terms are
/// taken off a map of the remainder.
pub(crate) fn quotient_by_map(a: &Packed, b: &Packed, count: usize) -> Option<Packed> {
    let guards: u128 = (1..=count).map(|i| 1_u128 << (BITS * i - 1)).sum();
    let mut rest: BTreeMap<u128, Int> = a.iter().cloned().collect();
    let (&(leading, ref divisor), tail) = b.split_first()?;
    let mut quotient = Packed::new();
    while let Some((word, value)) = rest.pop_last() {
        if value.is_zero() {
            continue;
        }
        let monomial = (word | guards) - leading;
        let (factor, remainder) = value.div_rem(divisor);
        if monomial & guards != guards || !remainder.is_zero() {
            return None;
        }
        let monomial = monomial - guards;
        for (other, coefficient) in tail {
            *rest.entry(monomial + other).or_default() -= &factor * coefficient;
        }
        quotient.push((monomial, factor));
    }
    Some(quotient)
}
