//! Sums and products of sorted lists of terms with integer coefficients.

use num_traits::Zero;

use super::Term;
use super::reduction::reduce;
use super::ring::{Monomial, Ring};
use crate::{Int, budget};

/// `a·x + b·y` for sorted lists `x` and `y`.
pub(crate) fn linear_combination(a: &Int, x: &[Term], b: &Int, y: &[Term]) -> Vec<Term> {
    budget::spend((x.len() + y.len()) as u64);
    let mut sum = Vec::with_capacity(x.len() + y.len());
    let (mut i, mut j) = (0, 0);
    while i < x.len() || j < y.len() {
        let from_x = j == y.len() || (i < x.len() && x[i].monomial >= y[j].monomial);
        let from_y = i == x.len() || (j < y.len() && y[j].monomial >= x[i].monomial);
        let (monomial, coefficient) = match (from_x, from_y) {
            (true, true) => (x[i].monomial, a * &x[i].coefficient + b * &y[j].coefficient),
            (true, false) => (x[i].monomial, a * &x[i].coefficient),
            _ => (y[j].monomial, b * &y[j].coefficient),
        };
        i += usize::from(from_x);
        j += usize::from(from_y);
        if !coefficient.is_zero() {
            sum.push(Term { monomial, coefficient });
        }
    }
    sum
}

/// The product of sorted lists of terms, with the rules of the field applied.
///
/// Dense products (where the exponents of the result fill their box well) accumulate in an array indexed by packed
/// exponents; sparse ones in a hash table, and are sorted at the end. Both use machine words as long as the coefficients provably fit.
pub(crate) fn product(ring: &Ring, x: &[Term], y: &[Term]) -> Vec<Term> {
    let (x, y) = if x.len() <= y.len() { (x, y) } else { (y, x) };
    if x.is_empty() {
        return Vec::new();
    }
    let widths = max_bits(x) + max_bits(y) + u64::from(usize::BITS - x.len().leading_zeros());
    let words = 1 + widths / 64;
    budget::spend((x.len() as u64).saturating_mul(y.len() as u64).saturating_mul(words));
    let unreduced = if widths < 126 { multiply::<i128>(ring, x, y) } else { multiply::<Int>(ring, x, y) };
    reduce(ring, unreduced)
}

/// A coefficient under accumulation: a machine integer where everything fits, else an [`Int`].
trait Accumulator: Clone + Default {
    fn of(coefficient: &Int) -> Self;
    fn add_product(&mut self, a: &Self, b: &Self);
    fn is_nothing(&self) -> bool;
    fn finish(self) -> Int;
}

impl Accumulator for i128 {
    #[inline]
    fn of(coefficient: &Int) -> i128 {
        match coefficient.small() {
            Some(small) => small.into(),
            // Only called below 126 bits.
            None => i128::try_from(coefficient.to_big()).unwrap_or_default(),
        }
    }

    #[inline]
    fn add_product(&mut self, a: &i128, b: &i128) {
        // The widths were checked beforehand, so nothing wraps.
        *self = self.wrapping_add(a.wrapping_mul(*b));
    }

    #[inline]
    fn is_nothing(&self) -> bool {
        *self == 0
    }

    #[inline]
    fn finish(self) -> Int {
        self.into()
    }
}

impl Accumulator for Int {
    fn of(coefficient: &Int) -> Int {
        coefficient.clone()
    }

    fn add_product(&mut self, a: &Int, b: &Int) {
        *self += a * b;
    }

    fn is_nothing(&self) -> bool {
        self.is_zero()
    }

    fn finish(self) -> Int {
        self
    }
}

/// A dense box may have this many cells for every product of two terms.
const CELLS_PER_PRODUCT: usize = 2;
/// A dense box has at most this many cells.
const MOST_CELLS: usize = 1 << 22;

fn multiply<A: Accumulator>(ring: &Ring, x: &[Term], y: &[Term]) -> Vec<Term> {
    let coefficients = |terms: &[Term]| terms.iter().map(|term| A::of(&term.coefficient)).collect::<Vec<A>>();
    let (a, b) = (coefficients(x), coefficients(y));
    if let Some(layout) = DenseBox::new(ring, x, y) {
        let (places_x, places_y) = (layout.places(x), layout.places(y));
        let mut cells = vec![A::default(); layout.size];
        for (place, a) in places_x.iter().zip(&a) {
            add_multiple(&mut cells[*place..], a, &places_y, &b);
        }
        return layout.terms(cells);
    }
    let mut sums = SumTable::<A>::new(x.len() + y.len());
    for (p, a) in x.iter().zip(&a) {
        sums.add_row(p.monomial, a, y, &b);
    }
    let terms = sums.into_terms();
    ring.check_exponents(terms.iter().fold(0, |union, term| union | term.monomial.0));
    terms
}

/// The largest value that the bits of `mask` have in the monomials.
pub(crate) fn largest(terms: &[Term], mask: u128) -> u128 {
    let (count, mut most, mut i) = (terms.len(), 0, 0);
    while i < count {
        let bits = terms[i].monomial.0 & mask;
        if bits > most {
            most = bits;
        }
        i += 1;
    }
    most
}

/// Adds `factor · values[j]` to the cell at `places[j]` for all j.
///
/// This is the innermost loop of most derivations. It counts by itself: iterators are several times slower where nothing
/// is inlined, as in a macro that is built without optimization.
fn add_multiple<A: Accumulator>(cells: &mut [A], factor: &A, places: &[usize], values: &[A]) {
    let count = places.len().min(values.len());
    let (places, values) = (&places[..count], &values[..count]);
    let mut j = 0;
    while j < count {
        cells[places[j]].add_product(factor, &values[j]);
        j += 1;
    }
}

/// Sums under accumulation by monomial: a hash table with open addressing, which is cheap where many products share few
/// monomials, as in polynomials of several symbols. Like [`add_multiple`] it counts by itself.
struct SumTable<A> {
    /// For each slot 1 + the place of a sum, or 0.
    slots: Vec<u32>,
    /// The monomials in the order in which they came.
    words: Vec<u128>,
    sums: Vec<A>,
}

impl<A: Accumulator> SumTable<A> {
    fn new(expected: usize) -> SumTable<A> {
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
    fn add_row(&mut self, monomial: Monomial, factor: &A, terms: &[Term], values: &[A]) {
        let count = terms.len().min(values.len());
        let (terms, values) = (&terms[..count], &values[..count]);
        let mut j = 0;
        while j < count {
            if 2 * self.words.len() >= self.slots.len() {
                self.grow();
            }
            let word = monomial.0 + terms[j].monomial.0;
            let (slots, words) = (self.slots.as_mut_slice(), self.words.as_slice());
            let slot = SumTable::<A>::slot(slots, words, word);
            if slots[slot] == 0 {
                // There are fewer than 2³² terms.
                slots[slot] = words.len() as u32 + 1;
                self.words.push(word);
                self.sums.push(A::default());
            }
            let place = slots[slot] as usize - 1;
            self.sums.as_mut_slice()[place].add_product(factor, &values[j]);
            j += 1;
        }
    }

    fn grow(&mut self) {
        let mut slots = vec![0; 2 * self.slots.len()];
        for (place, &word) in self.words.iter().enumerate() {
            let slot = SumTable::<A>::slot(&slots, &self.words, word);
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

/// The box of all exponents up to the degrees of a product, as an array in the order of monomials.
struct DenseBox {
    /// Shift and mask in the packed word, and the stride in the array, for each variable and generator that occurs.
    fields: Vec<(u32, u128, usize)>,
    size: usize,
}

impl DenseBox {
    fn new(ring: &Ring, x: &[Term], y: &[Term]) -> Option<DenseBox> {
        let limit = (x.len().saturating_mul(y.len())).saturating_mul(CELLS_PER_PRODUCT).min(MOST_CELLS);
        let degree = |terms: &[Term], shift: u32, mask: u128| largest(terms, mask << shift) >> shift;
        let mut fields = Vec::new();
        let mut size = 1_usize;
        for (shift, mask) in ring.fields().into_iter().rev() {
            let extent = degree(x, shift, mask) + degree(y, shift, mask);
            if extent == 0 {
                continue;
            }
            if extent > mask / 2 && mask > 3 {
                // An exponent beyond the range: the sparse way reports it.
                return None;
            }
            fields.push((shift, mask, size));
            size = size.checked_mul(usize::try_from(extent).ok()? + 1).filter(|&size| size <= limit)?;
        }
        fields.reverse();
        Some(DenseBox { fields, size })
    }

    fn places(&self, terms: &[Term]) -> Vec<usize> {
        let fields = self.fields.as_slice();
        let place = |term: &Term| {
            let (mut place, mut i) = (0, 0);
            while i < fields.len() {
                let (shift, mask, stride) = fields[i];
                place += (term.monomial.0 >> shift & mask) as usize * stride;
                i += 1;
            }
            place
        };
        terms.iter().map(place).collect()
    }

    /// The nonzero cells as terms, in descending order.
    fn terms<A: Accumulator>(&self, mut cells: Vec<A>) -> Vec<Term> {
        let mut terms = Vec::new();
        let cells = cells.as_mut_slice();
        let mut place = cells.len();
        while place > 0 {
            place -= 1;
            if !cells[place].is_nothing() {
                let coefficient = std::mem::take(&mut cells[place]).finish();
                terms.push(Term { monomial: self.monomial(place), coefficient });
            }
        }
        terms
    }

    fn monomial(&self, mut place: usize) -> Monomial {
        let fields = self.fields.as_slice();
        let (mut word, mut i) = (0, 0);
        while i < fields.len() {
            let (shift, _, stride) = fields[i];
            word |= ((place / stride) as u128) << shift;
            place %= stride;
            i += 1;
        }
        Monomial(word)
    }
}

fn max_bits(terms: &[Term]) -> u64 {
    terms.iter().map(|term| term.coefficient.bits()).max().unwrap_or(0)
}

/// Sorts terms and adds those of equal monomials.
pub(crate) fn collect(mut terms: Vec<Term>) -> Vec<Term> {
    budget::spend(terms.len() as u64);
    terms.sort_by_key(|term| std::cmp::Reverse(term.monomial));
    let mut sum: Vec<Term> = Vec::with_capacity(terms.len());
    for term in terms {
        match sum.last_mut() {
            Some(last) if last.monomial == term.monomial => last.coefficient += term.coefficient,
            _ => {
                if sum.last().is_some_and(|last| last.coefficient.is_zero()) {
                    sum.pop();
                }
                sum.push(term);
            }
        }
    }
    if sum.last().is_some_and(|last| last.coefficient.is_zero()) {
        sum.pop();
    }
    sum
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::sync::Arc;

    use proptest::prelude::*;

    use super::*;
    use crate::{NumberField, Variable};

    /// A ring in six variables.
    fn ring() -> Arc<Ring> {
        Ring::new((0..6).map(|rank| Variable::new(rank, "x")), NumberField::rationals())
    }

    fn polynomials(highest: u32, most: usize) -> impl Strategy<Value = Vec<Term>> {
        let term = (prop::collection::vec(0..=highest, 6), -5_i64..=5);
        prop::collection::vec(term, 0..most).prop_map(|terms| {
            let term = |(exponents, value): (Vec<u32>, i64)| Term {
                monomial: ring().monomial(&exponents, &[]),
                coefficient: value.into(),
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

    proptest! {
        #[test]
        fn products_agree_with_the_naive_ones(
            sparse in [polynomials(9, 30), polynomials(9, 30)],
            dense in [polynomials(1, 60), polynomials(1, 60)],
        ) {
            for [x, y] in [sparse, dense] {
                prop_assert_eq!(product(&ring(), &x, &y), naive_product(&x, &y));
            }
        }

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
