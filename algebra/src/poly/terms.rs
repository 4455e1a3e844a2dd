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
        let nonzero = cells.into_iter().enumerate().rev().filter(|(_, cell)| !cell.is_nothing());
        return nonzero
            .map(|(place, cell)| Term { monomial: layout.monomial(place), coefficient: cell.finish() })
            .collect();
    }
    let mut sums = SumTable::<A>::new(x.len() + y.len());
    for (p, a) in x.iter().zip(&a) {
        for (q, b) in y.iter().zip(&b) {
            sums.at(p.monomial.0 + q.monomial.0).add_product(a, b);
        }
    }
    let mut terms: Vec<Term> = sums.into_sums().collect();
    terms.sort_unstable_by_key(|term| std::cmp::Reverse(term.monomial));
    ring.check_exponents(terms.iter().fold(0, |union, term| union | term.monomial.0));
    terms
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
/// monomials, as in polynomials of several symbols.
struct SumTable<A> {
    monomials: Vec<u128>,
    sums: Vec<A>,
    occupied: usize,
}

/// No monomial: its guard bits would be set.
const VACANT: u128 = u128::MAX;

impl<A: Accumulator> SumTable<A> {
    fn new(expected: usize) -> SumTable<A> {
        let size = (2 * expected).next_power_of_two();
        SumTable { monomials: vec![VACANT; size], sums: vec![A::default(); size], occupied: 0 }
    }

    /// The place of a monomial, or the vacant one where it belongs.
    #[inline]
    fn place(&self, monomial: u128) -> usize {
        let (low, high) = (monomial as u64, (monomial >> 64) as u64);
        // Multiplicative hashing of both halves by odd constants (Knuth, vol. 3, 6.4).
        let hash = low.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ high.wrapping_mul(0xC2B2_AE3D_27D4_EB4F);
        let mask = self.monomials.len() - 1;
        let mut place = (hash ^ hash >> 32) as usize & mask;
        while self.monomials[place] != VACANT && self.monomials[place] != monomial {
            place = (place + 1) & mask;
        }
        place
    }

    #[inline]
    fn at(&mut self, monomial: u128) -> &mut A {
        let mut place = self.place(monomial);
        if self.monomials[place] == VACANT {
            if 2 * self.occupied >= self.monomials.len() {
                self.grow();
                place = self.place(monomial);
            }
            self.monomials[place] = monomial;
            self.occupied += 1;
        }
        &mut self.sums[place]
    }

    fn grow(&mut self) {
        let larger = SumTable::new(self.monomials.len());
        let old = std::mem::replace(self, larger);
        for (monomial, sum) in old.monomials.into_iter().zip(old.sums) {
            if monomial != VACANT {
                let place = self.place(monomial);
                self.monomials[place] = monomial;
                self.sums[place] = sum;
                self.occupied += 1;
            }
        }
    }

    /// The nonzero sums, in no order.
    fn into_sums(self) -> impl Iterator<Item = Term> {
        let sums = self.monomials.into_iter().zip(self.sums);
        sums.filter(|(monomial, sum)| *monomial != VACANT && !sum.is_nothing())
            .map(|(monomial, sum)| Term { monomial: Monomial(monomial), coefficient: sum.finish() })
    }
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
        let degree = |terms: &[Term], shift: u32, mask: u128| {
            terms.iter().map(|term| term.monomial.0 >> shift & mask).max().unwrap_or(0)
        };
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
        let place = |word: u128| {
            self.fields.iter().map(|&(shift, mask, stride)| (word >> shift & mask) as usize * stride).sum()
        };
        terms.iter().map(|term| place(term.monomial.0)).collect()
    }

    fn monomial(&self, mut place: usize) -> Monomial {
        let mut word = 0;
        for &(shift, _, stride) in &self.fields {
            word |= ((place / stride) as u128) << shift;
            place %= stride;
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
