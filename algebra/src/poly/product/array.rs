//! Products whose sums are kept in arrays that packed exponents index.

use crate::budget;
use crate::poly::Term;
use crate::poly::boxes::cell::Cell;
use crate::poly::boxes::sums::{CELLS_PER_MARK, Sums};
use crate::poly::boxes::{Boxes, group_counts};
use crate::poly::ring::Ring;

/// The array holds at most so many bytes: it stays in the second-level cache.
const MOST_BYTES: usize = 1 << 20;

/// How a product is cut into [`Boxes`].
///
/// Where there is one box, this is the classical dense product, or Kronecker's substitution without the univariate product.
/// Complexity: one product of coefficients and one addition in the cache for each pair of terms, and one step for each cell or
/// mark. Fast univariate products would need far denser operands than those of geometry.
#[derive(Debug)]
pub(super) struct Plan {
    boxes: Boxes,
    /// Whether boxes are so full that all their cells are looked at.
    full: bool,
}

/// What a plan costs, in units of about a nanosecond, for each pair of groups, apart from the products of coefficients.
const PAIR_COST: usize = 20;
/// As [`PAIR_COST`], for each box.
const BOX_COST: usize = 30;
/// As [`PAIR_COST`], for each product that a hash table would take.
const TABLE_COST: usize = 12;
/// Boxes whose cells are at most so many for each product are full.
const FULL_CELLS: usize = 2;
/// A box has at most so many cells for each product.
const MOST_CELLS: usize = 64;

impl Plan {
    /// The cheapest plan for a product where `exponents` holds the largest exponent of each variable and generator; `None` if a
    /// hash table is cheaper.
    pub(super) fn new(ring: &Ring, operands: [&[Term]; 2], exponents: u128, bytes: usize) -> Option<Plan> {
        let products = operands[0].len().saturating_mul(operands[1].len());
        let most = (MOST_BYTES / bytes).min(products.saturating_mul(MOST_CELLS));
        let counts = operands.map(group_counts);
        let mut best: Option<(usize, Plan)> = None;
        for boxes in Boxes::candidates(ring, exponents) {
            if boxes.size() > most {
                break;
            }
            let pairs = boxes.group_count(&counts[0]).saturating_mul(boxes.group_count(&counts[1]));
            let count = boxes.room().min(pairs);
            let marks = count.saturating_mul(BOX_COST + boxes.size() / (8 * CELLS_PER_MARK));
            let cost = pairs.saturating_mul(PAIR_COST).saturating_add(marks) + boxes.size() * bytes / 16;
            let limit = best.as_ref().map_or(products.saturating_mul(TABLE_COST), |(least, _)| *least);
            if cost < limit {
                let full = boxes.size().saturating_mul(count) <= products.saturating_mul(FULL_CELLS);
                best = Some((cost, Plan { boxes, full }));
            }
        }
        best.map(|(_, plan)| plan)
    }

    /// All plans with small boxes.
    #[cfg(test)]
    pub(super) fn all(ring: &Ring, exponents: u128) -> Vec<Plan> {
        let small = Boxes::candidates(ring, exponents).into_iter().filter(|boxes| boxes.size() < 1 << 16);
        small.flat_map(|boxes| [true, false].map(|full| Plan { boxes: boxes.clone(), full })).collect()
    }

    /// The product of sorted lists of terms, whose coefficients are `values`.
    pub(super) fn multiply<C: Cell>(&self, operands: [&[Term]; 2], values: [&[C]; 2]) -> Vec<Term> {
        let boxes = &self.boxes;
        let places = operands.map(|terms| boxes.places(terms));
        let groups = operands.map(|terms| boxes.groups(terms));
        let prefix =
            |operand: usize, group: usize| boxes.prefix(operands[operand][groups[operand][group]].monomial.0);
        let counts = [0, 1].map(|operand| groups[operand].len() - 1);
        let count = counts[0] as u64 * counts[1] as u64;
        budget::spend(count);
        budget::reserve(count * size_of::<(u128, usize, usize)>() as u64);
        let mut pairs = Vec::with_capacity(counts[0] * counts[1]);
        for i in 0..counts[0] {
            let own = prefix(0, i);
            pairs.extend((0..counts[1]).map(|j| (own + prefix(1, j), i, j)));
        }
        pairs.sort_unstable_by(|a, b| b.cmp(a));
        let mut sums = Sums::new(boxes, self.full);
        let mut terms = Vec::new();
        for (number, &(prefix, i, j)) in pairs.iter().enumerate() {
            let columns = groups[1][j]..groups[1][j + 1];
            for row in groups[0][i]..groups[0][i + 1] {
                let (column_places, column_values) =
                    (&places[1][columns.clone()], &values[1][columns.clone()]);
                sums.add_row(places[0][row], &values[0][row], column_places, column_values);
            }
            if pairs.get(number + 1).is_none_or(|next| next.0 != prefix) {
                sums.drain(prefix, &mut terms);
                // The list grows by doubling.
                budget::reserve(2 * (terms.len() * size_of::<Term>()) as u64);
            }
        }
        terms
    }
}
