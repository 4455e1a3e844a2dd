//! Products whose sums are kept in a hash table.

use crate::budget;
use crate::poly::Term;
use crate::poly::boxes::cell::Cell;
use crate::poly::ring::Monomial;

/// The product of sorted lists of terms, whose coefficients are `values`.
///
/// Chosen where the exponents are scattered, as in polynomials of many symbols: the table has one slot for each sum, while
/// boxes of exponents would be nearly empty. A heap of products (Johnson, *Sparse polynomial arithmetic*, 1974) needs less
/// memory and no sort. Its logarithmic factor makes it two to three times slower where many products share a monomial, as
/// in geometry; where few do it would be faster. Complexity: one product of coefficients and one look-up for each pair of
/// terms, and the sort of the sums.
pub(super) fn multiply<C: Cell>([x, y]: [&[Term]; 2], [a, b]: [&[C]; 2]) -> Vec<Term> {
    // Beyond the caches a sum takes some 50 ns to be found.
    budget::spend((x.len() as u64).saturating_mul(y.len() as u64));
    let mut sums = SumTable::<C>::new(x.len() + y.len());
    for (p, a) in x.iter().zip(a) {
        sums.add_row(p.monomial, a, y, b);
    }
    sums.into_terms()
}

/// Sums under accumulation by monomial: a hash table with open addressing, which is cheap where many products share few
/// monomials, as in polynomials of several symbols.
///
/// It counts by itself: iterators are several times slower where nothing is inlined, as in a macro that is built without
/// optimization.
struct SumTable<C> {
    /// For each slot 1 + the place of a sum, or 0.
    slots: Vec<u32>,
    /// The monomials in the order in which they came.
    words: Vec<u128>,
    sums: Vec<C>,
}
impl<C: Cell> SumTable<C> {
    fn new(expected: usize) -> SumTable<C> {
        let slots = vec![0; (2 * expected).next_power_of_two()];
        SumTable { slots, words: Vec::with_capacity(expected), sums: Vec::with_capacity(expected) }
    }

    /// The slot of a monomial, or the vacant one where it belongs.
    fn slot(slots: &[u32], words: &[u128], word: u128) -> usize {
        // Multiplicative hashing of both halves by odd constants (Knuth, vol. 3, 6.4).
        let low = (word as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        let hash = low ^ ((word >> 64) as u64).wrapping_mul(0xC2B2_AE3D_27D4_EB4F);
        let mask = slots.len() - 1;
        let mut slot = (hash ^ hash >> 32) as usize & mask;
        while slots[slot] != 0 && words[slots[slot] as usize - 1] != word {
            slot = (slot + 1) & mask;
        }
        slot
    }

    /// Adds the products of the term `factor · monomial` with all `terms`, whose coefficients are `values`.
    fn add_row(&mut self, monomial: Monomial, factor: &C, terms: &[Term], values: &[C]) {
        let count = terms.len().min(values.len());
        let (terms, values) = (&terms[..count], &values[..count]);
        let mut j = 0;
        while j < count {
            if 2 * self.words.len() >= self.slots.len() {
                self.grow();
            }
            let word = monomial.0 + terms[j].monomial.0;
            let (slots, words) = (self.slots.as_mut_slice(), self.words.as_slice());
            let slot = SumTable::<C>::slot(slots, words, word);
            if slots[slot] == 0 {
                // There are fewer than 2³² terms.
                slots[slot] = words.len() as u32 + 1;
                self.words.push(word);
                self.sums.push(C::default());
            }
            let place = slots[slot] as usize - 1;
            self.sums.as_mut_slice()[place].add_product(factor, &values[j]);
            j += 1;
        }
    }

    fn grow(&mut self) {
        let bytes = size_of::<u128>() + size_of::<C>() + 4 * size_of::<u32>() + size_of::<Term>();
        budget::reserve(2 * (self.words.len() * bytes) as u64);
        let mut slots = vec![0; 2 * self.slots.len()];
        for (place, &word) in self.words.iter().enumerate() {
            let slot = SumTable::<C>::slot(&slots, &self.words, word);
            slots[slot] = place as u32 + 1;
        }
        self.slots = slots;
    }

    /// The nonzero sums, in descending order.
    fn into_terms(self) -> Vec<Term> {
        let mut sums = self.sums;
        let mut terms = Vec::with_capacity(sums.len());
        for place in descending(&self.words) {
            let sum = std::mem::take(&mut sums[place]);
            if !sum.is_nothing() {
                terms.push(Term { monomial: Monomial(self.words[place]), coefficient: sum.finish() });
            }
        }
        terms
    }
}
/// The places of distinct words, the largest word first.
///
/// A merge sort that begins with the descending runs that there are (Knuth, vol. 3, 5.2.4): the products of one term of a
/// polynomial with all terms of another one come in order.
fn descending(words: &[u128]) -> Vec<usize> {
    let count = words.len();
    let mut order: Vec<usize> = (0..count).collect();
    let mut merged = vec![0; count];
    // The ends of runs.
    let mut ends: Vec<usize> = (1..=count).filter(|&i| i == count || words[i - 1] < words[i]).collect();
    while ends.len() > 1 {
        let (from, into) = (order.as_slice(), merged.as_mut_slice());
        let mut next = Vec::with_capacity(ends.len() / 2 + 1);
        let mut k = 0;
        for pair in ends.chunks(2) {
            let (middle, end) = (pair[0], pair[pair.len() - 1]);
            let (mut i, mut j) = (k, middle);
            while k < end {
                if j == end || (i < middle && words[from[i]] > words[from[j]]) {
                    into[k] = from[i];
                    i += 1;
                } else {
                    into[k] = from[j];
                    j += 1;
                }
                k += 1;
            }
            next.push(end);
        }
        std::mem::swap(&mut order, &mut merged);
        ends = next;
    }
    order
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn words_are_put_in_descending_order(
            words in prop::collection::btree_set(0_u128..1000, 0..100),
            turn in 0_usize..100,
        ) {
            let mut words: Vec<u128> = words.into_iter().rev().collect();
            let turn = turn % words.len().max(1);
            words.rotate_left(turn);
            words[turn..].reverse();
            let found: Vec<u128> = descending(&words).into_iter().map(|place| words[place]).collect();
            words.sort_unstable_by(|a, b| b.cmp(a));
            prop_assert_eq!(found, words);
        }
    }
}
