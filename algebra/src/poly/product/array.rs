//! Products whose sums are kept in arrays that packed exponents index.

use super::cell::Cell;
use crate::poly::Term;
use crate::poly::ring::{Monomial, Ring};

/// The array holds at most so many bytes: it stays in the second-level cache.
const MOST_BYTES: usize = 1 << 20;
/// The cells that share a mark.
const CELLS_PER_MARK: usize = 8;

/// How a product is cut into boxes: the terms of an operand with the same exponents of the first variables are a *group*, and
/// the products of two groups fall into one box of exponents of the other variables. All products that fall into one box are
/// summed in an array, one box after the other, the largest monomials first.
///
/// Where there is one box, this is the classical dense product, or Kronecker's substitution without the univariate product.
/// Cutting off the first variables keeps the array in the cache whatever the degrees are, and marks for every eighth cell
/// make empty parts of a box cheap (compare Monagan and Pearce, *Polynomial division using dynamic arrays, heaps, and packed
/// exponent vectors*, 2007, on what sparse products cost).
#[derive(Debug)]
pub(super) struct Plan {
    /// The bits of the first variables.
    prefix: u128,
    /// Shift and mask in the packed word, and the stride in the array, for each other variable and generator that occurs,
    /// the most significant first.
    fields: Vec<(u32, u128, usize)>,
    /// The cells of a box.
    size: usize,
    /// Whether boxes are so full that all their cells are looked at.
    full: bool,
}

/// What a plan costs, in units of about a nanosecond, apart from the products of coefficients.
const PAIR_COST: usize = 20;
/// As [`PAIR_COST`], for each box.
const BOX_COST: usize = 30;
/// As [`PAIR_COST`], for each product that a hash table would take.
const TABLE_COST: usize = 8;

impl Plan {
    /// The cheapest plan for a product where `exponents` holds the largest exponent of each variable and generator; `None` if a
    /// hash table is cheaper.
    pub(super) fn new(ring: &Ring, operands: [&[Term]; 2], exponents: u128, bytes: usize) -> Option<Plan> {
        let products = operands[0].len().saturating_mul(operands[1].len());
        let most_cells = (MOST_BYTES / bytes).min(products.saturating_mul(64));
        let mut best: Option<(usize, Plan)> = None;
        for (plan, pairs, boxes) in Plan::candidates(ring, operands, exponents) {
            if plan.size > most_cells {
                continue;
            }
            let marks = boxes.saturating_mul(BOX_COST + plan.size / (8 * CELLS_PER_MARK));
            let cost = (pairs.saturating_mul(PAIR_COST))
                .saturating_add(marks)
                .saturating_add(plan.size * bytes / 32);
            if cost < products.saturating_mul(TABLE_COST)
                && best.as_ref().is_none_or(|(least, _)| cost < *least)
            {
                best = Some((cost, plan));
            }
        }
        best.map(|(_, plan)| plan)
    }

    /// All plans, for tests.
    #[cfg(test)]
    pub(super) fn all(ring: &Ring, operands: [&[Term]; 2], exponents: u128) -> Vec<Plan> {
        let plans = Plan::candidates(ring, operands, exponents).into_iter().map(|(plan, ..)| plan);
        let small = plans.filter(|plan| plan.size < 1 << 16);
        small
            .flat_map(|plan| [true, false].map(|full| Plan { fields: plan.fields.clone(), full, ..plan }))
            .collect()
    }

    /// For each number of first variables the plan, its pairs of groups, and the boxes that these can fall into at most.
    fn candidates(ring: &Ring, operands: [&[Term]; 2], exponents: u128) -> Vec<(Plan, usize, usize)> {
        let groups = operands.map(group_counts);
        let products = operands[0].len().saturating_mul(operands[1].len());
        let occurring = ring.fields().into_iter().filter(|(shift, mask)| exponents >> shift & mask > 0);
        let mut plans = Vec::new();
        // From the last variable up, the box grows.
        let (mut fields, mut size) = (Vec::new(), 1_usize);
        let occurring: Vec<(u32, u128)> = occurring.collect();
        for first in (0..=occurring.len()).rev() {
            if let Some((shift, mask)) = occurring.get(first) {
                fields.insert(0, (*shift, *mask, size));
                // An exponent has at most 20 bits.
                let extent = (exponents >> shift & mask) as usize + 1;
                match size.checked_mul(extent) {
                    Some(next) => size = next,
                    None => break,
                }
            }
            let lowest = first.checked_sub(1).map_or(128, |last| occurring[last].0);
            let prefix = u128::MAX.checked_shl(lowest).unwrap_or(0);
            let [own, other] = [0, 1].map(|operand| groups[operand][lowest as usize] as usize);
            let pairs = own.saturating_mul(other);
            let room = occurring[..first].iter().fold(1_usize, |room, (shift, mask)| {
                room.saturating_mul((exponents >> shift & mask) as usize + 1)
            });
            let boxes = pairs.min(room);
            let full = size.saturating_mul(boxes) <= products.saturating_mul(2);
            plans.push((Plan { prefix, fields: fields.clone(), size, full }, pairs, boxes));
        }
        plans
    }

    /// The product of sorted lists of terms, whose coefficients are `values`.
    pub(super) fn multiply<C: Cell>(&self, operands: [&[Term]; 2], values: [&[C]; 2]) -> Vec<Term> {
        let [x, y] = operands;
        let places = operands.map(|terms| self.places(terms));
        let groups = operands.map(|terms| self.groups(terms));
        let mut pairs = Vec::with_capacity(groups[0].len() * groups[1].len());
        for (i, &begin) in groups[0].iter().enumerate() {
            let prefix = x[begin].monomial.0 & self.prefix;
            pairs.extend(
                groups[1]
                    .iter()
                    .enumerate()
                    .map(|(j, &begin)| (prefix + (y[begin].monomial.0 & self.prefix), i, j)),
            );
        }
        pairs.sort_unstable_by(|a, b| b.cmp(a));
        let range = |operand: usize, group: usize| {
            let end = groups[operand].get(group + 1).copied().unwrap_or(operands[operand].len());
            groups[operand][group]..end
        };
        let mut sums = Sums::new(self);
        for (number, &(prefix, i, j)) in pairs.iter().enumerate() {
            let (rows, columns) = (range(0, i), range(1, j));
            for row in rows {
                let column_places = &places[1][columns.clone()];
                sums.add_row(places[0][row], &values[0][row], column_places, &values[1][columns.clone()]);
            }
            if pairs.get(number + 1).is_none_or(|next| next.0 != prefix) {
                sums.take(prefix);
            }
        }
        sums.terms
    }

    /// The places where the groups of terms begin.
    fn groups(&self, terms: &[Term]) -> Vec<usize> {
        let mut begins = Vec::new();
        let mut last = None;
        for (place, term) in terms.iter().enumerate() {
            let prefix = term.monomial.0 & self.prefix;
            if last != Some(prefix) {
                begins.push(place);
                last = Some(prefix);
            }
        }
        begins
    }
}

/// For each position of a bit, 1 + how many neighbors in a sorted list differ there or above: the number of groups of terms
/// that agree from there on. The last entry is 1.
fn group_counts(terms: &[Term]) -> [u32; 129] {
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

impl Plan {
    /// The places of terms in the array, as far as they depend on them alone.
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

/// The sums of one box.
struct Sums<C> {
    full: bool,
    cells: Vec<C>,
    /// For each [`CELLS_PER_MARK`] cells whether one of them may differ from zero; not used where boxes are full.
    marks: Vec<u8>,
    words: [Vec<u128>; 2],
    /// The terms of the boxes that are done.
    terms: Vec<Term>,
}

impl<C: Cell> Sums<C> {
    fn new(plan: &Plan) -> Sums<C> {
        // Marks are looked at eight at a time.
        let marks = if plan.full { 0 } else { plan.size.div_ceil(CELLS_PER_MARK).next_multiple_of(8) };
        let cells = vec![C::default(); plan.size];
        Sums { full: plan.full, cells, marks: vec![0; marks], words: plan.words(), terms: Vec::new() }
    }

    /// Adds `factor · values[j]` to the cell at `place + places[j]` for all j.
    ///
    /// This is the innermost loop of most derivations. It counts by itself: iterators are several times slower where nothing
    /// is inlined, as in a macro that is built without optimization.
    fn add_row(&mut self, place: usize, factor: &C, places: &[usize], values: &[C]) {
        let count = places.len().min(values.len());
        let (places, values) = (&places[..count], &values[..count]);
        let cells = &mut self.cells[place..];
        let mut j = 0;
        if self.full {
            while j < count {
                cells[places[j]].add_product(factor, &values[j]);
                j += 1;
            }
            return;
        }
        let marks = self.marks.as_mut_slice();
        while j < count {
            cells[places[j]].add_product(factor, &values[j]);
            marks[(place + places[j]) / CELLS_PER_MARK] = 1;
            j += 1;
        }
    }

    /// Appends the terms of the box, whose first variables have the word `prefix`, and clears it.
    fn take(&mut self, prefix: u128) {
        if self.full {
            self.take_cells(prefix, 0, self.cells.len());
            return;
        }
        let mut block = self.marks.len() / 8;
        while block > 0 {
            block -= 1;
            let marks = &mut self.marks[8 * block..8 * block + 8];
            if marks == [0; 8] {
                continue;
            }
            for i in (0..8).rev() {
                if std::mem::take(&mut self.marks[8 * block + i]) != 0 {
                    let begin = (8 * block + i) * CELLS_PER_MARK;
                    self.take_cells(prefix, begin, (begin + CELLS_PER_MARK).min(self.cells.len()));
                }
            }
        }
    }

    /// Appends the nonzero cells from `begin` to `end` as terms, the last one first, and clears them.
    fn take_cells(&mut self, prefix: u128, begin: usize, end: usize) {
        let [upper, lower] = &self.words;
        let (mut above, mut below) = (end / lower.len(), end % lower.len());
        let cells = self.cells.as_mut_slice();
        let mut place = end;
        while place > begin {
            place -= 1;
            if below == 0 {
                (above, below) = (above - 1, lower.len());
            }
            below -= 1;
            if !cells[place].is_nothing() {
                let coefficient = std::mem::take(&mut cells[place]).finish();
                let monomial = Monomial(prefix + upper[above] + lower[below]);
                self.terms.push(Term { monomial, coefficient });
            }
        }
    }
}
