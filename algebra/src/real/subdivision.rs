//! The sign of a polynomial on a box, by subdivision of its Bernstein net.

use std::cmp::Ordering;
use std::collections::{BTreeMap, VecDeque};

use super::interval::Interval;
use super::net::Net;
use crate::{Int, Poly, Rational, Variable, budget};

/// A point: a number for each variable. A variable without a number is free.
pub type Point = BTreeMap<Variable, Poly>;

/// What subdivision finds out about a polynomial on a box.
#[derive(Clone, Debug)]
pub(crate) enum Decision {
    /// It never vanishes, and has this sign.
    Strict(Ordering),
    /// It has this sign but at the points, where it vanishes.
    Touches { sign: Ordering, points: Vec<Point> },
    /// It is positive at one point and negative at another.
    Changes { positive: Point, negative: Point },
    /// The limit was reached at this depth; perhaps a zero was found.
    Unknown { depth: u32, zero: Option<Point> },
}

/// How many times a box is halved, at most: only isolated zeros of a squarefree polynomial can withstand that, since it
/// changes its sign across every curve of zeros, which a coarser box shows.
const MOST_HALVINGS: u32 = 96;
/// How many boxes are looked at, at most.
const MOST_BOXES: u64 = 20_000;
/// How many words the coefficients of all boxes together have, at most.
const MOST_WORDS: u64 = 1 << 24;

/// Decides the sign of a nonzero `poly` on the box `domain`, which names all its variables.
///
/// A box is done when no two Bernstein coefficients have opposite signs; the zeros of the polynomial in such a box are
/// zero coefficients at corners, unless it vanishes on a whole edge, which ends undecided if no change of sign is found:
/// factors in one variable are to be split off before. The other boxes are halved along their axes in turn, breadth
/// first, so that a change of sign is found at its coarsest scale. `cuts` are values of variables where the box is
/// divided at first; a zero on an edge is certified only when it becomes a corner.
pub(crate) fn decide(poly: &Poly, domain: &[(Variable, Interval)], cuts: &[(Variable, Poly)]) -> Decision {
    let mut regions = vec![domain.to_vec()];
    for (variable, value) in cuts {
        let Some(axis) = domain.iter().position(|(other, _)| other == variable) else { continue };
        regions = regions.into_iter().flat_map(|region| divided(region, axis, value)).collect();
    }
    let whole = vec![Part { level: 0, index: Int::ZERO }; domain.len()];
    let cell = |region| Net::of(poly, region).map(|net| Cell { region, parts: whole.clone(), net, depth: 0 });
    let mut queue: VecDeque<Cell<'_>> = regions.iter().filter_map(|region| cell(region)).collect();
    let mut found = Found::default();
    let (mut boxes, mut words) = (0, 0);
    while let Some(cell) = queue.pop_front() {
        budget::progress(boxes, MOST_BOXES);
        boxes += 1;
        words += cell.net.words();
        let definite = found.look_at(&cell);
        if let (Some(positive), Some(negative)) = (&found.positive, &found.negative) {
            return Decision::Changes { positive: positive.clone(), negative: negative.clone() };
        }
        if definite {
            continue;
        }
        if cell.depth == MOST_HALVINGS || boxes == MOST_BOXES || words > MOST_WORDS {
            return found.unknown(cell.depth);
        }
        let lengths = cell.net.lengths();
        let mut turns = (0..lengths.len()).map(|k| (cell.depth as usize + k) % lengths.len());
        if let Some(axis) = turns.find(|&k| lengths[k] > 1) {
            queue.extend(cell.halves(axis));
        }
    }
    found.decision()
}

/// The parts of a box below and above `value` on an axis; the box itself if there are none.
fn divided(region: Vec<(Variable, Interval)>, axis: usize, value: &Poly) -> Vec<Vec<(Variable, Interval)>> {
    let (variable, interval) = &region[axis];
    let below = Interval::new(interval.lower().clone(), value.clone());
    let above = Interval::new(value.clone(), interval.upper().clone());
    let (Some(below), Some(above)) = (below, above) else { return vec![region] };
    let part = |interval| {
        let mut part = region.clone();
        part[axis] = (variable.clone(), interval);
        part
    };
    vec![part(below), part(above)]
}

/// The part `[index/2^level, (index + 1)/2^level]` of the unit interval.
#[derive(Clone)]
struct Part {
    level: u64,
    index: Int,
}

/// A box: parts of the intervals of a larger one, and the net of coefficients over it.
struct Cell<'a> {
    region: &'a [(Variable, Interval)],
    parts: Vec<Part>,
    net: Net,
    depth: u32,
}

impl<'a> Cell<'a> {
    fn halves(&self, axis: usize) -> [Cell<'a>; 2] {
        let (below, above) = self.net.halves(axis);
        let half = |net: Net, upper: i64| {
            let mut parts = self.parts.clone();
            let Part { level, index } = &self.parts[axis];
            parts[axis] = Part { level: level + 1, index: index * Int::from(2) + Int::from(upper) };
            Cell { region: self.region, parts, net, depth: self.depth + 1 }
        };
        [half(below, 0), half(above, 1)]
    }

    /// The point of the box that has, on each axis, the given number of halves of the width from the lower end.
    fn point(&self, halves: impl Fn(usize) -> i64) -> Point {
        let axes = self.region.iter().zip(&self.parts).enumerate();
        let number = |(k, ((variable, interval), part)): (usize, (&(Variable, Interval), &Part))| {
            let numerator = &part.index * Int::from(2) + Int::from(halves(k));
            let t = Rational::new(numerator, Int::ONE.shl(part.level + 1));
            (variable.clone(), interval.point(&t))
        };
        axes.map(number).collect()
    }
}

/// Points at which the sign is known.
#[derive(Default)]
struct Found {
    positive: Option<Point>,
    negative: Option<Point>,
    zeros: Vec<Point>,
    /// Whether there may be zeros on an edge of a box, apart from these.
    on_edges: bool,
}

impl Found {
    /// Records what a box shows; whether nothing remains to be seen of it.
    fn look_at(&mut self, cell: &Cell<'_>) -> bool {
        for upper in cell.net.corners() {
            let corner = || cell.point(|k| if upper[k] { 2 } else { 0 });
            match cell.net.corner_sign(&upper) {
                Ordering::Greater => _ = self.positive.get_or_insert_with(corner),
                Ordering::Less => _ = self.negative.get_or_insert_with(corner),
                Ordering::Equal => {
                    let zero = corner();
                    if !self.zeros.contains(&zero) {
                        self.zeros.push(zero);
                    }
                }
            }
        }
        // The sign in the whole interior, where all basis functions are positive.
        let Some(sign) = cell.net.definite_sign() else { return false };
        let witness = if sign.is_gt() { &mut self.positive } else { &mut self.negative };
        witness.get_or_insert_with(|| cell.point(|_| 1));
        self.on_edges |= cell.net.vanishes_on_an_edge();
        true
    }

    fn unknown(self, depth: u32) -> Decision {
        Decision::Unknown { depth, zero: self.zeros.into_iter().next() }
    }

    /// The decision when all boxes are done.
    fn decision(self) -> Decision {
        let sign = match (&self.positive, &self.negative) {
            (Some(_), None) => Ordering::Greater,
            (None, Some(_)) => Ordering::Less,
            _ => return self.unknown(0),
        };
        match (self.zeros.is_empty(), self.on_edges) {
            (true, _) => Decision::Strict(sign),
            (false, false) => Decision::Touches { sign, points: self.zeros },
            (false, true) => self.unknown(0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit_square() -> (Poly, Poly, [(Variable, Interval); 2]) {
        let (u, v) = (Variable::new(0, "u"), Variable::new(1, "v"));
        (Poly::variable(&u), Poly::variable(&v), [(u, Interval::unit()), (v, Interval::unit())])
    }

    #[test]
    fn a_zero_off_the_grid_needs_a_cut() {
        let (x, y, domain) = unit_square();
        let third = Poly::constant(crate::ratio(1, 3));
        let f = &x + (&y - &third).pow(2);
        assert!(matches!(decide(&f, &domain, &[]), Decision::Unknown { depth: MOST_HALVINGS, zero: None }));
        let cut = (domain[1].0.clone(), third.clone());
        let Decision::Touches { sign, points } = decide(&f, &domain, &[cut]) else { panic!() };
        assert_eq!(sign, Ordering::Greater);
        let expected: Point = domain.iter().map(|(v, _)| v.clone()).zip([Poly::zero(), third]).collect();
        assert_eq!(points, [expected]);
    }

    #[test]
    fn whole_edges_of_zeros_are_not_passed_over() {
        let (x, y, domain) = unit_square();
        assert!(matches!(decide(&x, &domain, &[]), Decision::Unknown { .. }));
        let f = (&x - &y) * (&x - Poly::constant(crate::ratio(1, 2)));
        assert!(matches!(decide(&f, &domain, &[]), Decision::Changes { .. }));
        assert!(matches!(decide(&(x + y + Poly::one()), &domain, &[]), Decision::Strict(Ordering::Greater)));
    }
}
