//! Subdivision of the interval of one parameter, and what is known of the values that depend on it alone.

use std::collections::BTreeMap;

use hodograph_algebra::{Rational, budget};

use super::cells::Cells;
use super::dyadic::Dyadic;
use super::interval::Interval;
use super::steps::Steps;

/// What is known on intervals above this level of halving is improved by what is known of their parts.
pub(super) const LEAF_LEVEL: u32 = 5;

/// One of the 2^level equal parts of an interval, by level and place.
pub(super) type Part = (u32, u32);

/// The halves of a part.
pub(super) fn halves((level, place): Part) -> [Part; 2] {
    [(level + 1, 2 * place), (level + 1, 2 * place + 1)]
}

/// The domain of a parameter, and the values of the stage of this parameter.
pub(super) struct Axis<'a> {
    steps: &'a Steps,
    /// 0 for u, 1 for v.
    parameter: usize,
    /// The ends of the domain.
    ends: [Interval; 2],
    /// The values to compute, in order.
    order: Vec<usize>,
    /// The values that others ask for.
    kept: Vec<usize>,
    /// Cells of all values of the program, with constants filled in.
    cells: Cells,
    /// What is known of the kept values.
    known: BTreeMap<Part, Cells>,
}

impl<'a> Axis<'a> {
    pub(super) fn new(
        steps: &'a Steps,
        parameter: usize,
        domain: &[Rational; 2],
        order: Vec<usize>,
        kept: Vec<usize>,
        cells: Cells,
    ) -> Axis<'a> {
        let ends =
            domain.each_ref().map(|end| Interval { lower: -Dyadic::above(&-end), upper: Dyadic::above(end) });
        Axis { steps, parameter, ends, order, kept, cells, known: BTreeMap::new() }
    }

    /// The values that others ask for.
    pub(super) fn kept(&self) -> &[usize] {
        &self.kept
    }

    /// Fills in what is known of the kept values on a part of the domain.
    pub(super) fn load(&mut self, part: Part, cells: &mut Cells) {
        self.on(part);
        let known = &self.known[&part];
        for (place, &value) in self.kept.iter().enumerate() {
            cells.copy(value, known, place);
        }
    }

    /// An interval around a part of the domain.
    pub(super) fn interval(&self, part: Part) -> Interval {
        self.at(part).hull(&self.at((part.0, part.1 + 1)))
    }

    /// An interval around the first point of a part of the domain.
    fn at(&self, (level, place): Part) -> Interval {
        match place {
            0 => self.ends[0],
            _ if place == 1 << level => self.ends[1],
            _ => {
                let width = self.ends[1].plus(&self.ends[0].negated());
                let fraction = Interval::point(Dyadic::new(i64::from(place), -(level as i32)));
                self.ends[0].plus(&width.times(&fraction))
            }
        }
    }

    /// What is known of the kept values on a part of the domain.
    pub(super) fn on(&mut self, part: Part) -> &Cells {
        if !self.known.contains_key(&part) {
            let mut cells = self.evaluate(part);
            if part.0 < LEAF_LEVEL {
                let [first, second] = halves(part);
                self.on(first);
                self.on(second);
                cells.refine(&self.known[&first], &self.known[&second]);
            }
            self.known.insert(part, cells);
        }
        &self.known[&part]
    }

    fn evaluate(&mut self, part: Part) -> Cells {
        let interval = self.interval(part);
        budget::spend(self.steps.price(self.order.len()));
        // The other parameter does not occur.
        let mut inputs = [Interval::point(Dyadic::ZERO); 2];
        inputs[self.parameter] = interval;
        for &value in &self.order {
            self.steps.run(value, &inputs, &mut self.cells);
        }
        self.cells.of(&self.kept)
    }
}
