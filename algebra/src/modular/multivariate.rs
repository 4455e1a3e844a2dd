//! Sparse polynomials in several variables over a prime field.

use super::field::{PrimeField, Residue};
use super::heap::{NextProduct, ProductHeap};
use super::univariate::Univariate;
use crate::budget;

/// How exponents are packed into one word: the first variable has the most significant bits.
///
/// The order of words is the lexicographic order of monomials. Words are never added beyond the degrees that the layout
/// was made for, so there are no guard bits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Layout {
    /// The position of the lowest bit of each variable's exponent; one more entry than there are variables, above all.
    shifts: Vec<u32>,
}

impl Layout {
    /// The layout for variables of at most these degrees; `None` if that takes more than 128 bits.
    pub(crate) fn new(degrees: &[u32]) -> Option<Self> {
        let mut shifts = vec![0_u32; degrees.len() + 1];
        for (i, degree) in degrees.iter().enumerate().rev() {
            shifts[i] = shifts[i + 1] + (32 - degree.leading_zeros()).max(1);
        }
        // The first entry becomes the total, the others the shifts of the variables.
        let total = shifts[0];
        shifts.rotate_left(1);
        if let Some(last) = shifts.last_mut() {
            *last = total;
        }
        (total <= 128).then_some(Self { shifts })
    }

    /// The number of variables.
    pub(crate) fn len(&self) -> usize {
        self.shifts.len() - 1
    }

    /// The word of a monomial.
    #[cfg(test)]
    pub(crate) fn pack(&self, exponents: &[u32]) -> u128 {
        exponents.iter().zip(&self.shifts).map(|(&exponent, &shift)| u128::from(exponent) << shift).sum()
    }

    /// The word of a power of the variable `position`.
    pub(crate) fn power(&self, position: usize, exponent: u32) -> u128 {
        u128::from(exponent) << self.shifts[position]
    }

    /// The exponent of the variable `position`.
    pub(crate) fn exponent(&self, word: u128, position: usize) -> u32 {
        let below = if position == 0 { self.shifts[self.len()] } else { self.shifts[position - 1] };
        let bits = below - self.shifts[position];
        // The mask leaves at most 32 bits.
        (word >> self.shifts[position] & ((1 << bits) - 1)) as u32
    }

    /// The word with the exponents of `position` and all later variables cleared.
    fn prefix(&self, word: u128, position: usize) -> u128 {
        let below = if position == 0 { self.shifts[self.len()] } else { self.shifts[position - 1] };
        if below == 128 { 0 } else { word >> below << below }
    }
}

/// A polynomial over F_p: words of a [`Layout`], strictly descending, with nonzero coefficients.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Multivariate {
    terms: Vec<(u128, Residue)>,
}

impl Multivariate {
    /// The sum of these terms, whose words may repeat and stand in any order.
    pub(crate) fn new(field: &PrimeField, mut terms: Vec<(u128, Residue)>) -> Self {
        if !terms.is_sorted_by(|a, b| a.0 > b.0) {
            terms.sort_unstable_by_key(|term| std::cmp::Reverse(term.0));
            terms.dedup_by(|next, kept| {
                let same = next.0 == kept.0;
                if same {
                    kept.1 = field.add(kept.1, next.1);
                }
                same
            });
        }
        terms.retain(|term| !term.1.is_zero());
        Self { terms }
    }

    /// The sum of these terms, with strictly descending words and nonzero coefficients.
    pub(crate) fn from_sorted(terms: Vec<(u128, Residue)>) -> Self {
        Self { terms }
    }

    /// A constant.
    pub(crate) fn constant(value: Residue) -> Self {
        Self { terms: if value.is_zero() { Vec::new() } else { vec![(0, value)] } }
    }

    /// The terms, in descending order of their words.
    pub(crate) fn terms(&self) -> &[(u128, Residue)] {
        &self.terms
    }

    /// Whether this is the zero polynomial.
    pub(crate) fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The word of the leading monomial; zero for the zero polynomial too.
    pub(crate) fn leading_word(&self) -> u128 {
        self.terms.first().map_or(0, |term| term.0)
    }

    /// Whether this is constant (zero included).
    pub(crate) fn is_constant(&self) -> bool {
        self.leading_word() == 0
    }

    /// The polynomial divided by its leading coefficient; zero stays zero.
    pub(crate) fn monic(&self, field: &PrimeField) -> Self {
        let leading = self.terms.first().map_or(Residue::ZERO, |term| term.1);
        field.invert(leading).map_or_else(Self::default, |inverse| self.scale(field, inverse))
    }

    /// The polynomial times a nonzero constant.
    pub(crate) fn scale(&self, field: &PrimeField, factor: Residue) -> Self {
        Self { terms: self.terms.iter().map(|&(word, value)| (word, field.mul(value, factor))).collect() }
    }

    /// The degree in the variable `position`; zero for the zero polynomial.
    pub(crate) fn degree(&self, layout: &Layout, position: usize) -> u32 {
        self.terms.iter().map(|&(word, _)| layout.exponent(word, position)).max().unwrap_or(0)
    }

    /// The quotient by a nonzero polynomial, if it divides; `bounds` are the differences of the degrees.
    ///
    /// The products of terms are merged by a heap, which holds at most one for each term of the divisor.
    pub(crate) fn quotient(
        &self,
        field: &PrimeField,
        layout: &Layout,
        divisor: &Self,
        bounds: &[u32],
    ) -> Option<Self> {
        let (&(leading, first), tail) = divisor.terms.split_first()?;
        let inverse = field.invert(first)?;
        let mut quotient: Vec<(u128, Residue)> = Vec::new();
        let mut heap = ProductHeap::default();
        // Terms of the tail whose next partner is not known yet.
        let mut waiting: Vec<usize> = (0..tail.len()).collect();
        let mut own = 0;
        loop {
            let word = self.terms.get(own).map(|term| term.0).max(heap.top().map(|product| product.word));
            let Some(word) = word else { return Some(Self { terms: quotient }) };
            let mut value = Residue::ZERO;
            if let Some(term) = self.terms.get(own).filter(|term| term.0 == word) {
                value = term.1;
                own += 1;
            }
            while let Some(NextProduct { divisor: j, quotient: i, .. }) = heap.top_at(word) {
                value = field.sub(value, field.mul(tail[j].1, quotient[i].1));
                if let Some(partner) = quotient.get(i + 1) {
                    heap.replace_top(NextProduct {
                        word: tail[j].0 + partner.0,
                        divisor: j,
                        quotient: i + 1,
                    });
                } else {
                    heap.pop();
                    waiting.push(j);
                }
            }
            if value.is_zero() {
                continue;
            }
            budget::spend(divisor.terms.len() as u64);
            // Within the bounds no product of a term with one of the divisor leaves the layout.
            let exponent = |i: usize| layout.exponent(word, i).checked_sub(layout.exponent(leading, i));
            if !(0..layout.len()).all(|i| exponent(i).is_some_and(|exponent| exponent <= bounds[i])) {
                return None;
            }
            let position = quotient.len();
            quotient.push((word - leading, field.mul(value, inverse)));
            for j in waiting.drain(..) {
                heap.push(NextProduct { word: tail[j].0 + (word - leading), divisor: j, quotient: position });
            }
        }
    }

    /// The coefficients as polynomials in the variable `position`, none later than which occurs, by descending monomial
    /// of the variables before it.
    pub(super) fn split(&self, layout: &Layout, position: usize) -> Vec<(u128, Univariate)> {
        let prefix = |word| layout.prefix(word, position);
        let groups = self.terms.chunk_by(|a, b| prefix(a.0) == prefix(b.0));
        let collect = |group: &[(u128, Residue)]| {
            let mut coefficients = vec![Residue::ZERO; layout.exponent(group[0].0, position) as usize + 1];
            for &(word, coefficient) in group {
                coefficients[layout.exponent(word, position) as usize] = coefficient;
            }
            (prefix(group[0].0), Univariate::new(coefficients))
        };
        groups.map(collect).collect()
    }

    /// The inverse of [`Multivariate::split`].
    pub(super) fn join(layout: &Layout, position: usize, parts: &[(u128, Univariate)]) -> Self {
        let mut terms = Vec::new();
        for (prefix, part) in parts {
            for (exponent, &coefficient) in part.coefficients().iter().enumerate().rev() {
                if !coefficient.is_zero() {
                    terms.push((prefix | (exponent as u128) << layout.shifts[position], coefficient));
                }
            }
        }
        Self { terms }
    }
}

/// The powers 0 … `highest` of `base`.
pub(crate) fn powers(field: &PrimeField, base: Residue, highest: u32) -> Vec<Residue> {
    let mut powers = vec![field.one()];
    for i in 0..highest as usize {
        powers.push(field.mul(powers[i], base));
    }
    powers
}

/// A reproducible stream of evaluation points without visible structure (Steele, Lea and Flood, *Fast splittable
/// pseudorandom number generators*, 2014).
#[derive(Clone, Debug)]
pub(crate) struct Points {
    field: PrimeField,
    state: u64,
}

impl Points {
    /// The stream that belongs to `field`.
    pub(crate) fn new(field: &PrimeField) -> Self {
        Self { field: *field, state: field.modulus() }
    }

    /// The next point.
    pub(crate) fn next(&mut self) -> Residue {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut word = self.state;
        word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        self.field.residue_of_word(word ^ (word >> 31))
    }

    /// The next `count` points.
    pub(crate) fn take(&mut self, count: usize) -> Vec<Residue> {
        (0..count).map(|_| self.next()).collect()
    }
}

#[cfg(test)]
pub(super) mod tests {
    use proptest::prelude::*;

    use super::*;

    pub(crate) const VARIABLES: usize = 3;

    pub(crate) fn field() -> PrimeField {
        PrimeField::new(1_000_003).unwrap()
    }

    pub(crate) fn layout() -> Layout {
        Layout::new(&[30; VARIABLES]).unwrap()
    }

    pub(crate) fn polynomial(terms: &[([u32; VARIABLES], i64)]) -> Multivariate {
        let layout = layout();
        let terms = terms.iter().map(|(exponents, value)| (layout.pack(exponents), field().residue(*value)));
        Multivariate::new(&field(), terms.collect())
    }

    pub(crate) fn polynomials(most: usize) -> impl Strategy<Value = Multivariate> {
        let term = ([0_u32..3, 0_u32..3, 0_u32..3], -4_i64..=4);
        prop::collection::vec(term, 1..most).prop_map(|terms| polynomial(&terms))
    }

    pub(crate) fn product(a: &Multivariate, b: &Multivariate) -> Multivariate {
        let field = field();
        let pairs =
            a.terms.iter().flat_map(|x| b.terms.iter().map(move |y| (x.0 + y.0, field.mul(x.1, y.1))));
        Multivariate::new(&field, pairs.collect())
    }

    /// The quotient by the naive division of leading terms, if it is exact.
    pub(crate) fn naive_quotient(a: &Multivariate, b: &Multivariate) -> Option<Multivariate> {
        let (field, layout) = (field(), layout());
        let mut rest = a.clone();
        let mut terms = Vec::new();
        let inverse = field.invert(b.terms[0].1).unwrap();
        while !rest.is_zero() {
            let (word, value) = rest.terms[0];
            let divides = |i| layout.exponent(word, i) >= layout.exponent(b.leading_word(), i);
            if !(0..VARIABLES).all(divides) {
                return None;
            }
            let term = (word - b.leading_word(), field.mul(value, inverse));
            terms.push(term);
            let minus = product(&Multivariate { terms: vec![(term.0, field.neg(term.1))] }, b);
            rest = Multivariate::new(&field, [rest.terms, minus.terms].concat());
        }
        Some(Multivariate { terms })
    }

    #[test]
    fn words_pack_and_unpack() {
        let layout = Layout::new(&[3, 0, 255, 1 << 20]).unwrap();
        let word = layout.pack(&[2, 1, 200, 1 << 20]);
        assert_eq!((0..4).map(|i| layout.exponent(word, i)).collect::<Vec<_>>(), [2, 1, 200, 1 << 20]);
        assert_eq!(layout.prefix(word, 2), layout.pack(&[2, 1, 0, 0]));
        assert_eq!(layout.prefix(word, 0), 0);
        let full = Layout::new(&[u32::MAX; 4]).unwrap();
        assert_eq!(full.exponent(full.pack(&[u32::MAX, 0, 0, 7]), 0), u32::MAX);
        assert_eq!(full.prefix(u128::MAX, 0), 0);
        assert_eq!(Layout::new(&[u32::MAX; 5]), None);
    }

    proptest! {
        #[test]
        fn quotients_agree_with_the_naive_division(a in polynomials(6), b in polynomials(6), r in polynomials(3)) {
            let (field, layout) = (field(), layout());
            prop_assume!(!b.is_zero());
            let exact = product(&a, &b);
            let inexact = Multivariate::new(&field, [exact.terms.clone(), r.terms].concat());
            for dividend in [exact, inexact] {
                let degree = |poly: &Multivariate, i| poly.degree(&layout, i);
                let bounds: Vec<u32> =
                    (0..VARIABLES).map(|i| degree(&dividend, i).saturating_sub(degree(&b, i))).collect();
                prop_assert_eq!(dividend.quotient(&field, &layout, &b, &bounds), naive_quotient(&dividend, &b));
            }
        }
    }
}
