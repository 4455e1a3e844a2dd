//! The sums of one box.

use super::Boxes;
use super::cell::Cell;
use crate::poly::Term;
use crate::poly::ring::Monomial;

/// The cells that share a mark.
pub(crate) const CELLS_PER_MARK: usize = 8;

/// The sums of one box.
pub(crate) struct Sums<C> {
    full: bool,
    cells: Vec<C>,
    /// For each [`CELLS_PER_MARK`] cells whether one of them may differ from zero; not used where boxes are full.
    marks: Vec<u8>,
    words: [Vec<u128>; 2],
}

impl<C: Cell> Sums<C> {
    /// An empty box; `full` ones have no marks.
    pub(crate) fn new(boxes: &Boxes, full: bool) -> Sums<C> {
        let size = boxes.size.next_multiple_of(CELLS_PER_MARK);
        let marks = if full { 0 } else { size / CELLS_PER_MARK };
        Sums { full, cells: vec![C::default(); size], marks: vec![0; marks], words: boxes.words() }
    }

    /// Adds `factor · values[j]` to the cell at `place + places[j]` for all j.
    ///
    /// This is the innermost loop of most derivations. It counts by itself: iterators are several times slower where nothing
    /// is inlined, as in a macro that is built without optimization.
    pub(crate) fn add_row(&mut self, place: usize, factor: &C, places: &[usize], values: &[C]) {
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

    /// The place above all others.
    pub(crate) fn end(&self) -> usize {
        self.cells.len()
    }

    /// The last place before `end` with a sum that is not zero. Marks are removed on the way.
    pub(crate) fn last_before(&mut self, end: usize) -> Option<usize> {
        let (cells, marks) = (self.cells.as_slice(), self.marks.as_mut_slice());
        let mut place = end;
        while place > 0 {
            if !self.full && place.is_multiple_of(CELLS_PER_MARK) {
                let mut mark = place / CELLS_PER_MARK;
                while mark > 0 && marks[mark - 1] == 0 {
                    let empty = mark.is_multiple_of(8) && marks[mark - 8..mark] == [0; 8];
                    mark -= if empty { 8 } else { 1 };
                }
                marks[mark.checked_sub(1)?] = 0;
                place = mark * CELLS_PER_MARK;
            }
            place -= 1;
            if !cells[place].is_nothing() {
                return Some(place);
            }
        }
        None
    }

    /// Takes the sum at a place, which becomes zero.
    pub(crate) fn take(&mut self, place: usize) -> C {
        std::mem::take(&mut self.cells[place])
    }

    /// The part of a monomial that its place in the box tells.
    pub(crate) fn word(&self, place: usize) -> u128 {
        let [upper, lower] = &self.words;
        upper[place / lower.len()] + lower[place % lower.len()]
    }

    /// Appends the terms of the box, whose first variables have the word `prefix`, and clears it.
    pub(crate) fn drain(&mut self, prefix: u128, terms: &mut Vec<Term>) {
        let mut end = self.end();
        while let Some(place) = self.last_before(end) {
            let coefficient = self.take(place).finish();
            terms.push(Term { monomial: Monomial(prefix + self.word(place)), coefficient });
            end = place;
        }
    }
}
