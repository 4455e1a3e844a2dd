//! Parameters at which evaluators are tried: where errors are likely to be large, and everywhere else.

use hodograph::Domain;
use hodograph_codegen::bound::{Precision, Rounding};
use hodograph_codegen::program::Variant;

use crate::random::SplitMix64;
use crate::surfaces::Evaluator;

/// A source of parameters of a surface's domain, which are floats of one precision.
pub struct Points<'a> {
    surface: &'a dyn Evaluator,
    precision: Precision,
    random: SplitMix64,
}

/// The float of a precision that is nearest to `number`.
#[must_use]
pub fn rounded(number: f64, precision: Precision) -> f64 {
    match precision {
        Precision::Double => number,
        Precision::Single => f64::from(number as f32),
    }
}

/// The next float of a precision above a number of it, or below.
#[must_use]
pub fn neighbor(number: f64, precision: Precision, above: bool) -> f64 {
    match (precision, above) {
        (Precision::Double, true) => number.next_up(),
        (Precision::Double, false) => number.next_down(),
        (Precision::Single, true) => f64::from((number as f32).next_up()),
        (Precision::Single, false) => f64::from((number as f32).next_down()),
    }
}

impl<'a> Points<'a> {
    /// The source with this seed.
    #[must_use]
    pub fn new(surface: &'a dyn Evaluator, precision: Precision, seed: u64) -> Points<'a> {
        Points { surface, precision, random: SplitMix64::new(seed) }
    }

    fn domain(&self) -> Domain {
        self.surface.domain()
    }

    /// The parameters at fractions of the domain's sides, as floats of the precision.
    fn at(&self, s: f64, t: f64) -> (f64, f64) {
        let (u, v) = self.domain().at(s, t);
        (rounded(u, self.precision), rounded(v, self.precision))
    }

    /// The corners, the middles of the edges, and the floats next to the corners within the domain.
    #[must_use]
    pub fn border(&self) -> Vec<(f64, f64)> {
        let mut points = Vec::new();
        for s in [0.0, 0.5, 1.0] {
            for t in [0.0, 0.5, 1.0] {
                let (u, v) = self.at(s, t);
                let inward = |number: f64, fraction: f64| neighbor(number, self.precision, fraction == 0.0);
                points.extend([(u, v), (inward(u, s), v), (u, inward(v, t)), (inward(u, s), inward(v, t))]);
            }
        }
        points
    }

    /// Parameters all over the domain.
    pub fn anywhere(&mut self) -> (f64, f64) {
        let (s, t) = (self.random.next_f64(), self.random.next_f64());
        self.at(s, t)
    }

    /// Parameters near an edge or a corner, at distances of all sizes.
    pub fn near_border(&mut self) -> (f64, f64) {
        let near = |random: &mut SplitMix64, [first, last]: [f64; 2]| {
            let bits = random.next_u64();
            let most = if bits & 4 == 0 { 60.0 } else { 1074.0 };
            let distance = (last - first) * (-most * random.next_f64()).exp2() * random.next_f64();
            match bits & 3 {
                0 => first + distance,
                1 => last - distance,
                _ => first + (last - first) * random.next_f64(),
            }
        };
        let domain = self.domain();
        let (u, v) = (near(&mut self.random, domain.u), near(&mut self.random, domain.v));
        (rounded(u, self.precision), rounded(v, self.precision))
    }

    /// Parameters where one of the numbers that are computed changes its sign, so that it is a difference of nearly equal ones;
    /// or where the normal turns over, as it does where the surface is singular. `None` if random search finds no such change.
    pub fn cancelling(&mut self) -> Option<(f64, f64)> {
        let rounding = Rounding { precision: self.precision, variant: Variant::Plain };
        let surface = self.surface;
        let numbers = |(u, v)| surface.numbers("Local", rounding, (u, v));
        let (mut a, mut b) = (self.anywhere(), self.anywhere());
        let (at_a, at_b) = (numbers(a), numbers(b));
        // The last one is the cosine of the angle to the normal at `a`.
        let cosine = |x: &[f64]| (18..21).map(|k| x[k] * at_a[k]).sum::<f64>();
        let of = |x: &[f64], k: usize| if k < x.len() { x[k] } else { cosine(x) };
        let changes: Vec<usize> = (0..=at_a.len()).filter(|&k| of(&at_a, k) * of(&at_b, k) < 0.0).collect();
        let k = *changes.get((self.random.next_u64() % changes.len().max(1) as u64) as usize)?;
        let positive = of(&at_a, k) > 0.0;
        loop {
            let middle = (0.5 * (a.0 + b.0), 0.5 * (a.1 + b.1));
            let middle = (rounded(middle.0, self.precision), rounded(middle.1, self.precision));
            if middle == a || middle == b {
                return Some(middle);
            }
            let number = of(&numbers(middle), k);
            if number == 0.0 || number.is_nan() {
                return Some(middle);
            }
            if (number > 0.0) == positive {
                a = middle;
            } else {
                b = middle;
            }
        }
    }

    /// Parameters near others: some floats away, or a part of the domain of any size.
    pub fn near(&mut self, (u, v): (f64, f64)) -> (f64, f64) {
        let precision = self.precision;
        let step = |random: &mut SplitMix64, number: f64, [first, last]: [f64; 2]| {
            let bits = random.next_u64();
            let moved = match bits & 7 {
                0 => number,
                1..4 => (0..=(bits >> 3) % 4)
                    .fold(number, |number, _| neighbor(number, precision, bits & 256 == 0)),
                _ => {
                    let distance = (last - first) * (-55.0 * random.next_f64()).exp2();
                    if bits & 256 == 0 { number + distance } else { number - distance }
                }
            };
            rounded(moved, precision).clamp(rounded(first, precision), rounded(last, precision))
        };
        let domain = self.domain();
        (step(&mut self.random, u, domain.u), step(&mut self.random, v, domain.v))
    }

    /// A random fraction.
    pub fn chance(&mut self) -> f64 {
        self.random.next_f64()
    }
}
