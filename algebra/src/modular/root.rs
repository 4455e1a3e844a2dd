//! Square roots of polynomials over prime fields.

use super::field::{PrimeField, Residue};
use super::heap::{NextProduct, ProductHeap};
use super::multivariate::{Layout, Multivariate};
use crate::budget;

impl Multivariate {
    /// The polynomial r with the leading coefficient 1 for which this one is a multiple of r² by a number, if there is one; p is
    /// odd.
    ///
    /// As in a division, the terms come from the largest down: once the products of those that are known are taken off, what
    /// leads is twice the product of the first term and the next one. The products wait in a heap, one for each known term
    /// (Johnson, *Sparse polynomial arithmetic*, 1974). Complexity: O(log n) for each pair of the n terms of the root.
    pub(crate) fn monic_root(&self, field: &PrimeField, layout: &Layout) -> Option<Multivariate> {
        let &(leading, first) = self.terms().first()?;
        let variables = 0..layout.len();
        let halves: Option<Vec<u32>> = variables
            .clone()
            .map(|i| {
                let degree = self.degree(layout, i);
                (degree.is_multiple_of(2) && layout.exponent(leading, i).is_multiple_of(2))
                    .then_some(degree / 2)
            })
            .collect();
        let halves = halves?;
        let top: u128 = variables.clone().map(|i| layout.power(i, layout.exponent(leading, i) / 2)).sum();
        // Of r² = f/first, and of half of that.
        let scale = field.invert(first)?;
        let half = field.invert(field.residue(2))?;
        let mut root: Vec<(u128, Residue)> = vec![(top, field.one())];
        let mut heap = ProductHeap::default();
        // Terms whose next partner is not known yet.
        let mut waiting: Vec<usize> = Vec::new();
        let mut own = 1;
        loop {
            let word = self.terms().get(own).map(|term| term.0).max(heap.top().map(|product| product.word));
            let Some(word) = word else { return Some(Multivariate::from_sorted(root)) };
            let mut value = Residue::ZERO;
            if let Some(term) = self.terms().get(own).filter(|term| term.0 == word) {
                value = field.mul(term.1, scale);
                own += 1;
            }
            while let Some(NextProduct { divisor: i, quotient: j, .. }) = heap.top_at(word) {
                let product = field.mul(root[i].1, root[j].1);
                value = field.sub(value, if i == j { product } else { field.add(product, product) });
                match root.get(j + 1) {
                    Some(next) => {
                        heap.replace_top(NextProduct {
                            word: root[i].0 + next.0,
                            divisor: i,
                            quotient: j + 1,
                        });
                    }
                    None => {
                        heap.pop();
                        waiting.push(i);
                    }
                }
            }
            if value.is_zero() {
                continue;
            }
            budget::spend(root.len() as u64);
            // Within the bounds no product of two terms leaves the layout.
            let exponent = |i: usize| layout.exponent(word, i).checked_sub(layout.exponent(top, i));
            if !variables.clone().all(|i| exponent(i).is_some_and(|exponent| exponent <= halves[i])) {
                return None;
            }
            let place = root.len();
            let next = word - top;
            root.push((next, field.mul(value, half)));
            for i in waiting.drain(..) {
                heap.push(NextProduct { word: root[i].0 + next, divisor: i, quotient: place });
            }
            heap.push(NextProduct { word: next + next, divisor: place, quotient: place });
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn product(field: &PrimeField, a: &Multivariate, b: &Multivariate) -> Multivariate {
        let pairs =
            a.terms().iter().flat_map(|x| b.terms().iter().map(move |y| (x.0 + y.0, field.mul(x.1, y.1))));
        Multivariate::new(field, pairs.collect())
    }

    proptest! {
        #[test]
        fn squares_have_roots(
            terms in prop::collection::vec(([0_u32..5, 0_u32..5, 0_u32..5], 1_i64..90), 1..12),
            other in ([0_u32..9, 0_u32..9, 0_u32..9], 1_i64..90),
            unit in 1_i64..90,
        ) {
            let field = PrimeField::new(1_000_003).unwrap();
            let layout = Layout::new(&[9, 9, 9]).unwrap();
            let term = |(exponents, value): &([u32; 3], i64)| (layout.pack(exponents), field.residue(*value));
            let root = Multivariate::new(&field, terms.iter().map(term).collect()).monic(&field);
            let square = product(&field, &root, &root).scale(&field, field.residue(unit));
            prop_assert_eq!(square.monic_root(&field, &layout), Some(root));
            let changed = Multivariate::new(&field, [square.terms(), &[term(&other)]].concat());
            let found = changed.monic_root(&field, &layout);
            let squared = found.as_ref().map(|root| product(&field, root, root));
            prop_assert!(squared.is_none_or(|squared| squared == changed.monic(&field)));
        }
    }
}
