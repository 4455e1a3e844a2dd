//! Sums over many monomials in arrays that packed exponents index, cut into boxes that fit the cache.
//!
//! The terms of a sorted list with the same exponents of the first variables are a *group*; the products of two groups fall into
//! one *box* of exponents of the other variables. All products that fall into one box are summed in an array, one box after
//! the other, the largest monomials first. Cutting off the first variables keeps the array in the cache whatever the degrees
//! are, and marks for every eighth cell make empty parts of a box cheap. (Compare the blocks of van der Hoeven and Lecerf, *On the
//! complexity of multivariate blockwise polynomial multiplication*, 2012, which are multiplied as a whole.)

pub(crate) mod cell;
pub(crate) mod sums;

use super::Term;
use super::ring::Ring;

/// How words are cut into groups and boxes.
#[derive(Clone, Debug)]
pub(crate) struct Boxes {
    /// The bits of the first variables.
    prefix: u128,
    /// Shift and mask in the packed word, and the stride in the array, for each other variable and generator that occurs,
    /// the most significant first.
    fields: Vec<(u32, u128, usize)>,
    /// The cells of a box.
    size: usize,
    /// How many boxes there are at most.
    room: usize,
    /// The position of the lowest bit of the prefix; 128 if it has none.
    lowest: usize,
}

impl Boxes {
    /// For each number of first variables the boxes for monomials whose largest exponents are those of the word `exponents`; the
    /// smallest boxes first.
    pub(crate) fn candidates(ring: &Ring, exponents: u128) -> Vec<Boxes> {
        let extent = |&(shift, mask): &(u32, u128)| (exponents >> shift & mask) as usize + 1;
        let occurring: Vec<(u32, u128)> =
            ring.fields().into_iter().filter(|field| extent(field) > 1).collect();
        let (mut fields, mut size) = (Vec::new(), 1_usize);
        let mut candidates = Vec::new();
        for first in (0..=occurring.len()).rev() {
            if let Some(field) = occurring.get(first) {
                fields.insert(0, (field.0, field.1, size));
                let Some(larger) = size.checked_mul(extent(field)) else { break };
                size = larger;
            }
            let lowest = first.checked_sub(1).map_or(128, |last| occurring[last].0);
            let prefix = u128::MAX.checked_shl(lowest).unwrap_or(0);
            let room =
                occurring[..first].iter().fold(1_usize, |room, field| room.saturating_mul(extent(field)));
            candidates.push(Boxes { prefix, fields: fields.clone(), size, room, lowest: lowest as usize });
        }
        candidates
    }

    /// The cells of a box.
    pub(crate) fn size(&self) -> usize {
        self.size
    }

    /// How many boxes there are at most.
    pub(crate) fn room(&self) -> usize {
        self.room
    }

    /// The number of groups of a list with these [`group_counts`].
    pub(crate) fn group_count(&self, counts: &[u32; 129]) -> usize {
        counts[self.lowest] as usize
    }

    /// The part of a word in the first variables.
    pub(crate) fn prefix(&self, word: u128) -> u128 {
        word & self.prefix
    }

    /// The places of terms in the array of their box.
    pub(crate) fn places(&self, terms: &[Term]) -> Vec<usize> {
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

    /// The places where the groups of sorted terms begin, and the number of terms.
    pub(crate) fn groups(&self, terms: &[Term]) -> Vec<usize> {
        let mut begins = Vec::new();
        let mut last = None;
        for (place, term) in terms.iter().enumerate() {
            let prefix = self.prefix(term.monomial.0);
            if last != Some(prefix) {
                begins.push(place);
                last = Some(prefix);
            }
        }
        begins.push(terms.len());
        begins
    }

    /// The words of the monomials in a box, in two parts: the word at a place is the sum of `upper[place / n]` and
    /// `lower[place % n]`, where n is the length of the second part.
    fn words(&self) -> [Vec<u128>; 2] {
        let (mut upper, mut lower) = (vec![0], vec![0]);
        let ends = self.fields.iter().map(|field| field.2).rev().skip(1).chain([self.size]);
        for (&(shift, _, stride), end) in self.fields.iter().rev().zip(ends) {
            let part = if stride * stride <= self.size { &mut lower } else { &mut upper };
            let count = part.len();
            for exponent in 1..end / stride {
                for place in 0..count {
                    part.push(part[place] + ((exponent as u128) << shift));
                }
            }
        }
        [upper, lower]
    }
}

/// For each position of a bit, 1 + how many neighbors in a sorted list differ there or above: the number of groups of terms
/// that agree from there on. The last entry is 1.
pub(crate) fn group_counts(terms: &[Term]) -> [u32; 129] {
    let mut counts = [0_u32; 129];
    let mut i = 1;
    while i < terms.len() {
        let difference = terms[i - 1].monomial.0 ^ terms[i].monomial.0;
        // Distinct words differ.
        counts[127 - difference.leading_zeros() as usize] += 1;
        i += 1;
    }
    counts[128] = 1;
    for position in (0..128).rev() {
        counts[position] += counts[position + 1];
    }
    counts
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::sums::Sums;
    use super::*;
    use crate::poly::ring::Variable;
    use crate::poly::terms::{collect, maximum};
    use crate::{Int, Poly, integer};

    proptest! {
        #[test]
        fn places_and_groups_agree_with_the_words(
            list in prop::collection::vec(([0_u32..5, 0..2, 0..30, 0..4], 0_u32..2), 1..40)
        ) {
            let field = Poly::sqrt_of(&integer(2)).ring().field().clone();
            let ring = Ring::new((0..4).map(|rank| Variable::new(rank, "x")), field);
            let term = |(exponents, generator): ([u32; 4], u32)| Term {
                monomial: ring.monomial(&exponents, &[generator]),
                coefficient: Int::ONE,
            };
            let terms = collect(list.into_iter().map(term).collect());
            for boxes in Boxes::candidates(&ring, maximum(&ring, &terms)) {
                let sums = Sums::<i64>::new(&boxes, true);
                let places = boxes.places(&terms);
                for (term, &place) in terms.iter().zip(&places) {
                    prop_assert!(place < boxes.size());
                    prop_assert_eq!(boxes.prefix(term.monomial.0) + sums.word(place), term.monomial.0);
                }
                let groups = boxes.groups(&terms);
                prop_assert_eq!(boxes.group_count(&group_counts(&terms)), groups.len() - 1);
                prop_assert!(groups.len() - 1 <= boxes.room());
                for bounds in groups.windows(2) {
                    let prefix = boxes.prefix(terms[bounds[0]].monomial.0);
                    let same = |term: &Term| boxes.prefix(term.monomial.0) == prefix;
                    prop_assert!(terms[bounds[0]..bounds[1]].iter().all(same));
                    prop_assert!(terms.get(bounds[1]).is_none_or(|next| !same(next)));
                }
            }
        }
    }
}
