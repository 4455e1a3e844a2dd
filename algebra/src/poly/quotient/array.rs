//! Quotients whose remainders are kept in arrays that packed exponents index.

use std::collections::BinaryHeap;

use crate::poly::Term;
use crate::poly::boxes::cell::DivisibleCell;
use crate::poly::boxes::sums::{CELLS_PER_MARK, Sums};
use crate::poly::boxes::{Boxes, group_counts};
use crate::poly::ring::{Monomial, Ring};
use crate::{Int, budget};

/// A division over the integers, cut into [`Boxes`].
///
/// The boxes of the remainder are made one after the other, the largest monomials first: the terms of the dividend in it, minus
/// the products of groups of the quotient, which are complete, with groups of the divisor. The largest sum that is not zero,
/// divided by the first term of the divisor, is the next term of the quotient; its products with the other terms of the
/// first group of the divisor fall into the same box. This is the dense division, where there is one box, and the classical
/// division by main variables else.
pub(super) struct Division<'a> {
    ring: &'a Ring,
    a: &'a [Term],
    b: &'a [Term],
    /// The degrees of the quotient.
    bound: Monomial,
    boxes: Boxes,
}

/// An array has at most so many cells: in cells of one word it stays in the second-level cache.
const MOST_CELLS: usize = 1 << 17;
/// A box has at most so many cells for each term of the dividend.
const CELLS_PER_TERM: usize = 64;
/// What a pair of groups costs, in units of about a nanosecond.
const PAIR_COST: usize = 40;
/// As [`PAIR_COST`], for each box.
const BOX_COST: usize = 60;
/// As [`PAIR_COST`], for each product that a heap would take.
const HEAP_COST: usize = 100;

impl<'a> Division<'a> {
    /// The division of lists of at least two terms in the cheapest boxes; `None` if a heap is cheaper.
    pub(super) fn new(ring: &'a Ring, a: &'a [Term], b: &'a [Term], bound: Monomial) -> Option<Division<'a>> {
        let exponents = bound.0 + crate::poly::terms::maximum(ring, b);
        let most = a.len().saturating_mul(CELLS_PER_TERM).min(MOST_CELLS);
        let counts = [a, b].map(group_counts);
        // A guess: each term of the dividend is a sum of at least one product and at most as many as the divisor has terms.
        let mut limit = a.len().saturating_mul(b.len().isqrt()).saturating_mul(HEAP_COST);
        let mut best = None;
        for boxes in Boxes::candidates(ring, exponents) {
            if boxes.size() > most {
                break;
            }
            let [own, other] = counts.each_ref().map(|counts| boxes.group_count(counts));
            let count = boxes.room().min(own.saturating_mul(other));
            let marks = count.saturating_mul(BOX_COST + boxes.size() / (8 * CELLS_PER_MARK));
            let cost =
                own.saturating_mul(other).saturating_mul(PAIR_COST).saturating_add(marks) + boxes.size() / 2;
            if cost < limit {
                limit = cost;
                best = Some(boxes);
            }
        }
        best.map(|boxes| Division { ring, a, b, bound, boxes })
    }

    /// The division in all small boxes.
    #[cfg(test)]
    pub(super) fn all(ring: &'a Ring, a: &'a [Term], b: &'a [Term], bound: Monomial) -> Vec<Division<'a>> {
        let exponents = bound.0 + crate::poly::terms::maximum(ring, b);
        let small = Boxes::candidates(ring, exponents).into_iter().filter(|boxes| boxes.size() < 1 << 16);
        small.map(|boxes| Division { ring, a, b, bound, boxes }).collect()
    }

    /// The quotient, or `None` if the divisor does not divide.
    ///
    /// # Errors
    /// [`TooNarrow`] if cells of this type do not hold all sums, which is not known before.
    pub(super) fn run<C: DivisibleCell>(&self) -> Result<Option<Vec<Term>>, TooNarrow> {
        let boxes = &self.boxes;
        let bits = |terms: &[Term]| terms.iter().map(|term| term.coefficient.bits()).max().unwrap_or(0);
        // A cell sums at most as many products as the divisor has terms, and one term of the dividend.
        let widest = C::WIDTH - 1;
        let room =
            widest.saturating_sub(bits(self.b) + u64::from(usize::BITS - self.b.len().leading_zeros()));
        if bits(self.a) >= widest || bits(self.b) >= widest {
            return Err(TooNarrow);
        }
        let coefficients =
            |terms: &[Term]| terms.iter().map(|term| C::of(&term.coefficient)).collect::<Vec<C>>();
        let (values, places) = (coefficients(self.b), boxes.places(self.b));
        let groups = [self.a, self.b].map(|terms| boxes.groups(terms));
        let prefix = |terms: &[Term], place: usize| boxes.prefix(terms[place].monomial.0);
        let (first, one) = (self.b[0].monomial, C::of(&Int::ONE));
        let mut sums = Sums::new(boxes, false);
        let mut quotient =
            Quotient { terms: Vec::new(), places: Vec::new(), negated: Vec::new(), groups: vec![0] };
        // Pairs of a group of the quotient and one of the divisor, by the prefix of their products.
        let mut waiting: BinaryHeap<(u128, usize, usize)> = BinaryHeap::new();
        let mut next = 0;
        loop {
            let own = (next + 1 < groups[0].len()).then(|| prefix(self.a, groups[0][next]));
            let Some(current) = own.max(waiting.peek().map(|pair| pair.0)) else {
                return Ok(Some(quotient.terms));
            };
            if own == Some(current) {
                // Most attempts end in the first box.
                let group = &self.a[groups[0][next]..groups[0][next + 1]];
                sums.add_row(0, &one, &boxes.places(group), &coefficients(group));
                next += 1;
            }
            while let Some(&(_, i, j)) = waiting.peek().filter(|pair| pair.0 == current) {
                waiting.pop();
                let columns = groups[1][j]..groups[1][j + 1];
                for row in quotient.groups[i]..quotient.groups[i + 1] {
                    let (places, values) = (&places[columns.clone()], &values[columns.clone()]);
                    sums.add_row(quotient.places[row], &quotient.negated[row], places, values);
                }
            }
            let mut end = sums.end();
            while let Some(place) = sums.last_before(end) {
                budget::spend(2 * self.b.len() as u64);
                let word = Monomial(current + sums.word(place));
                let monomial =
                    self.ring.quotient(word, first).filter(|&m| self.ring.quotient(self.bound, m).is_some());
                let negated = sums.take(place).negated_quotient(&values[0]);
                let (Some(monomial), Some(negated)) = (monomial, negated) else { return Ok(None) };
                if negated.bits() > room {
                    return Err(TooNarrow);
                }
                // Exponents are not smaller than those of the first term, so neither is the place.
                let from = place - places[0];
                sums.add_row(from, &negated, &places[1..groups[1][1]], &values[1..groups[1][1]]);
                quotient.push(monomial, from, negated);
                end = place;
            }
            if quotient.close_group() {
                let group = quotient.groups.len() - 2;
                let own = prefix(&quotient.terms, quotient.groups[group]);
                waiting
                    .extend((1..groups[1].len() - 1).map(|j| (own + prefix(self.b, groups[1][j]), group, j)));
            }
        }
    }
}

/// The cells of an array are too narrow for a division.
#[derive(Clone, Copy, Debug)]
pub(super) struct TooNarrow;

/// The quotient as far as it is known.
struct Quotient<C> {
    terms: Vec<Term>,
    /// The places of the terms in the array of their box.
    places: Vec<usize>,
    /// Minus the coefficients.
    negated: Vec<C>,
    /// Where the groups of terms begin, and where the last one ends.
    groups: Vec<usize>,
}

impl<C: DivisibleCell> Quotient<C> {
    fn push(&mut self, monomial: Monomial, place: usize, negated: C) {
        self.terms.push(Term { monomial, coefficient: -negated.clone().finish() });
        self.places.push(place);
        self.negated.push(negated);
    }

    /// Ends a group of terms; whether it has any.
    fn close_group(&mut self) -> bool {
        let any = self.groups.last().is_some_and(|&begin| begin < self.terms.len());
        if any {
            self.groups.push(self.terms.len());
        }
        any
    }
}
