//! Adaptive subdivision of the domain: what is known of results on the boxes that it is divided into.

use hodograph_algebra::budget;

use super::axis::{Axis, Part, halves};
use super::cells::Cells;
use super::dyadic::Dyadic;
use super::steps::Steps;

/// The level of halving of the first boxes.
const FIRST_LEVEL: u32 = 3;

/// The level of halving beyond which a result counts as not bounded.
const LAST_LEVEL: u32 = 10;

/// The level of halving beyond which a result counts as having zeros.
const LAST_LEVEL_FOR_ZEROS: u32 = 6;

/// How many operations are run over boxes at most, beside those over the first ones.
const MOST_WORK: usize = 50_000;

/// How many operations a box counts for at least: it is looked at whenever one is chosen to be divided.
const LEAST_WORK: usize = 50;

/// How many of these are for absolute errors.
const WORK_FOR_ABSOLUTE: usize = 40_000;

/// How many more are for boxes where a result has no bound yet.
const WORK_FOR_BOUNDS: usize = 300_000;

/// How many more are for results whose last division made the largest error smaller by a quarter.
const WORK_FOR_GAIN: usize = 32_000;

/// A maximum counts as found when halving its box makes it smaller by less than the part 2^-GAIN.
const GAIN: i32 = 5;

/// A box, and what is known of the results on it.
struct Tile {
    u: Part,
    v: Part,
    cells: Cells,
    /// How large the errors of each result are, absolute and relative.
    sizes: Vec<[Size; 2]>,
    /// The tile that it is a part of.
    parent: Option<usize>,
    divided: bool,
}

/// What is to be made small.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Aim {
    Absolute = 0,
    Relative = 1,
}

/// How large an error is; `None` if there is no bound.
type Size = Option<Dyadic>;

fn is_larger(a: &Size, b: &Size) -> bool {
    match (a, b) {
        (_, None) => false,
        (None, Some(_)) => true,
        (Some(a), Some(b)) => a > b,
    }
}

/// Whether a gain is at least 5/4.
fn is_large(gain: Dyadic) -> bool {
    gain >= Dyadic::ONE.plus(Dyadic::power_of_two(-2))
}

/// Whether a result is known to be positive on one tile and negative on another one, so that it vanishes
/// between them.
fn changes_sign(tiles: &[Tile], result: usize) -> bool {
    let ranges = || tiles.iter().filter_map(|tile| tile.cells.range(result));
    ranges().any(|range| range.lower.is_positive()) && ranges().any(|range| range.upper.is_negative())
}

/// What is known of results on a domain.
pub(super) struct Known {
    /// What is known of each result on the whole domain.
    pub(super) cells: Cells,
    /// For each result a lower bound of its largest magnitude.
    pub(super) attained: Vec<Dyadic>,
    /// For each result and each format a box where there is no bound, if there is one.
    pub(super) failures: Vec<Vec<Option<(Part, Part)>>>,
}

/// The values of both parameters, on boxes.
pub(super) struct Tiles<'a, 'b> {
    pub(super) steps: &'a Steps,
    pub(super) axes: &'b mut [Axis<'a>; 2],
    /// The values to compute, in order.
    pub(super) order: Vec<usize>,
    pub(super) results: Vec<usize>,
    /// Cells of all values, with constants filled in.
    pub(super) cells: Cells,
    /// For each result the formats in which there is no bound on a smallest box; nothing is divided for them any more, unless
    /// they are all.
    pub(super) hopeless: Vec<Vec<bool>>,
}

impl Tiles<'_, '_> {
    /// Divides the domain until the largest errors are known well.
    pub(super) fn prove(&mut self) -> Known {
        let mut tiles: Vec<Tile> = Vec::new();
        for i in 0..1 << FIRST_LEVEL {
            for j in 0..1 << FIRST_LEVEL {
                let tile = self.on((FIRST_LEVEL, i), (FIRST_LEVEL, j), None);
                tiles.push(tile);
            }
        }
        // Relative errors profit from what is divided for absolute ones.
        let mut work = 0;
        self.divide(&mut tiles, Aim::Absolute, &mut work, WORK_FOR_ABSOLUTE);
        self.divide(&mut tiles, Aim::Relative, &mut work, MOST_WORK);
        self.collected(&tiles)
    }

    /// Divides the tiles of the largest errors, those first of the results that gain most from it, until all are known well or
    /// `work` is done up to `most`.
    fn divide(&mut self, tiles: &mut Vec<Tile>, aim: Aim, work: &mut usize, most: usize) {
        // By which factor the last division made the largest error of each result smaller; unknown before.
        let mut aims: Vec<(usize, Size)> = (0..self.results.len()).map(|result| (result, None)).collect();
        loop {
            let mut next: Option<(usize, usize)> = None;
            for place in (0..aims.len()).rev() {
                let (result, gain) = aims[place];
                let mut worst = Self::to_divide(tiles, result, aim);
                if worst.is_none() && self.give_up(tiles, result) {
                    worst = Self::to_divide(tiles, result, aim);
                }
                let none = worst.filter(|&worst| tiles[worst].sizes[result][aim as usize].is_none());
                let hopeless = aim == Aim::Relative && none.is_some() && changes_sign(tiles, result);
                let extra = match aim {
                    Aim::Absolute if none.is_some() => WORK_FOR_BOUNDS,
                    Aim::Absolute if gain.is_none_or(is_large) => WORK_FOR_GAIN,
                    _ => 0,
                };
                let Some(worst) = worst.filter(|_| !hopeless && *work < most + extra) else {
                    aims.remove(place);
                    next = next.map(|(other, worst)| (other - 1, worst));
                    continue;
                };
                if next.is_none_or(|(other, _)| !is_larger(&aims[other].1, &gain)) {
                    next = Some((place, worst));
                }
            }
            let Some((place, worst)) = next else { return };
            let result = aims[place].0;
            tiles[worst].divided = true;
            let first = tiles.len();
            for u in halves(tiles[worst].u) {
                for v in halves(tiles[worst].v) {
                    *work += self.order.len().max(LEAST_WORK);
                    let tile = self.on(u, v, Some(worst));
                    tiles.push(tile);
                }
            }
            let size = |tile: &Tile| tile.sizes[result][aim as usize];
            let after = tiles[first..].iter().map(size).reduce(|a, b| if is_larger(&b, &a) { b } else { a });
            aims[place].1 = match (size(&tiles[worst]), after.flatten()) {
                (Some(before), Some(after)) if after.is_positive() => Some(before.over(after)),
                (Some(_), Some(_)) => Some(Dyadic::ZERO),
                _ => None,
            };
        }
    }

    /// Whether a format without bounds, but not all of them, is found to be hopeless for a result.
    fn give_up(&mut self, tiles: &mut [Tile], result: usize) -> bool {
        let hopeless = &mut self.hopeless[result];
        let before = hopeless.clone();
        for tile in tiles.iter().filter(|tile| !tile.divided && tile.u.0 >= LAST_LEVEL) {
            for (format, hopeless) in hopeless.iter_mut().enumerate() {
                *hopeless |= !tile.cells.is_bounded_in(result, format);
            }
        }
        if *hopeless == before || hopeless.iter().all(|&hopeless| hopeless) {
            return false;
        }
        for tile in tiles {
            tile.sizes[result] = self.sizes(&tile.cells, result);
        }
        true
    }

    fn collected(&self, tiles: &[Tile]) -> Known {
        let whole: Vec<&Tile> = tiles.iter().filter(|tile| !tile.divided).collect();
        let mut cells = whole.first().map_or_else(|| self.cells.of(&self.results), |tile| tile.cells.clone());
        for tile in whole.iter().skip(1) {
            cells.join(&tile.cells);
        }
        let results = 0..self.results.len();
        let attained =
            |result| whole.iter().fold(Dyadic::ZERO, |most, tile| most.max(tile.cells.least(result)));
        let failure = |result, format| {
            let failure = whole.iter().find(|tile| !tile.cells.is_bounded_in(result, format));
            failure.map(|tile| (tile.u, tile.v))
        };
        let formats = 0..self.steps.formats().len();
        let failures = |result| formats.clone().map(|format| failure(result, format)).collect();
        Known {
            cells,
            attained: results.clone().map(attained).collect(),
            failures: results.map(failures).collect(),
        }
    }

    /// The tile of the largest error, if it is worth being divided.
    fn to_divide(tiles: &[Tile], result: usize, aim: Aim) -> Option<usize> {
        let mut worst: Option<(usize, Size)> = None;
        for (place, tile) in tiles.iter().enumerate().filter(|(_, tile)| !tile.divided) {
            let size = tile.sizes[result][aim as usize];
            let larger = match &worst {
                None => true,
                // Of boxes without bounds the smallest ones are looked at first.
                Some((other, None)) => size.is_none() && tile.u.0 > tiles[*other].u.0,
                Some((_, known)) => is_larger(&size, known),
            };
            if larger {
                worst = Some((place, size));
            }
        }
        let (place, size) = worst?;
        let tile = &tiles[place];
        let last = if aim == Aim::Absolute { LAST_LEVEL } else { LAST_LEVEL_FOR_ZEROS };
        if tile.u.0 >= last && size.is_none() || tile.u.0 >= LAST_LEVEL {
            return None;
        }
        let before = tile.parent.map(|parent| tiles[parent].sizes[result][aim as usize]);
        let found = match (before, size) {
            (Some(Some(before)), Some(size)) => before <= size.plus(size.scaled(-GAIN)),
            (_, Some(size)) => size.is_zero(),
            _ => false,
        };
        (!found).then_some(place)
    }

    fn sizes(&self, cells: &Cells, result: usize) -> [Size; 2] {
        [Aim::Absolute, Aim::Relative].map(|aim| self.size(cells, result, aim))
    }

    /// The largest error of all formats but hopeless ones, each in its own unit.
    fn size(&self, cells: &Cells, result: usize, aim: Aim) -> Size {
        cells.place(result)?;
        let mut largest = Dyadic::ZERO;
        let hopeless = &self.hopeless[result];
        let all = hopeless.iter().all(|&hopeless| hopeless);
        for (k, format) in self.steps.formats().iter().enumerate() {
            if hopeless[k] && !all {
                continue;
            }
            let error = cells.error(result, k);
            if !error.is_known || aim == Aim::Relative && !error.relative.is_known() {
                return None;
            }
            let size = match aim {
                Aim::Absolute => error.absolute,
                Aim::Relative => format.number(error.relative),
            };
            largest = largest.max(format.in_units(size));
        }
        Some(largest)
    }

    /// What is known of the results on a box.
    fn on(&mut self, u: Part, v: Part, parent: Option<usize>) -> Tile {
        budget::spend(self.steps.price(self.order.len()));
        self.axes[0].load(u, &mut self.cells);
        self.axes[1].load(v, &mut self.cells);
        let inputs = [self.axes[0].interval(u), self.axes[1].interval(v)];
        for &value in &self.order {
            self.steps.run(value, &inputs, &mut self.cells);
        }
        let cells = self.steps.best(&self.cells, &self.results);
        let sizes = (0..self.results.len()).map(|result| self.sizes(&cells, result)).collect();
        Tile { u, v, sizes, cells, parent, divided: false }
    }
}
