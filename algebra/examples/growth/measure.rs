//! Time, terms, bits and units of the steps of one derivation.

use std::error::Error;
use std::fmt;
use std::time::{Duration, Instant};

use hodograph_algebra::budget::{Exhausted, measured, with_budget};
use hodograph_algebra::{Fraction, Poly, Preimage, SweptSurface, Variable};

use crate::families::Family;
use crate::sweeps;

/// The steps, in their order.
pub(crate) const STEPS: [&str; 3] = ["W, X, Y, Z", "normal", "offset"];

/// What the derivation of one surface takes.
pub(crate) struct Row {
    /// The degree of the path.
    pub(crate) degree: u32,
    /// What each of the [`STEPS`] takes; `None` from the one on that does not end.
    pub(crate) steps: [Option<Step>; 3],
    /// Why a step did not end.
    pub(crate) end: Option<Exhausted>,
}

/// What one step takes, and how large its result is.
#[derive(Clone, Copy)]
pub(crate) struct Step {
    pub(crate) time: Duration,
    /// The terms of all polynomials of the result.
    pub(crate) terms: usize,
    /// The bits of the largest coefficient of the result.
    pub(crate) bits: u64,
    /// Units of the budget.
    pub(crate) units: u64,
}

/// The budget of a step: some minute.
const LIMIT: u64 = 2_000_000_000;
/// A derivation is repeated for at least so long, and the least time of each step counts.
const LONG_ENOUGH: Duration = Duration::from_millis(400);
/// A derivation is repeated at least so often.
const LEAST_RUNS: usize = 3;
/// A derivation is repeated at most so often.
const MOST_RUNS: usize = 50;

/// Measures the oriented translation along the curve of this degree.
pub(crate) fn row(family: &Family, degree: u32) -> Result<Row, Box<dyn Error>> {
    let begin = Instant::now();
    let mut row = Row::derive(family, degree)?;
    for run in 1..MOST_RUNS {
        if run >= LEAST_RUNS && begin.elapsed() >= LONG_ENOUGH {
            break;
        }
        for (best, again) in row.steps.iter_mut().zip(Row::derive(family, degree)?.steps) {
            if let (Some(best), Some(again)) = (best, again) {
                best.time = best.time.min(again.time);
            }
        }
    }
    Ok(row)
}

impl Row {
    /// Derives once.
    fn derive(family: &Family, degree: u32) -> Result<Row, Box<dyn Error>> {
        let preimage = family.preimage(degree)?;
        let mut row = Row { degree, steps: [None; 3], end: None };
        row.end = row.fill(&preimage).err();
        Ok(row)
    }

    fn fill(&mut self, preimage: &Preimage) -> Result<(), Exhausted> {
        let coordinates = |surface: &SweptSurface| surface.homogeneous().coordinates().to_vec();
        let (first, surface) = step(|| {
            let surface = sweeps::oriented_translation(&sweeps::path(preimage));
            (coordinates(&surface), surface)
        })?;
        self.steps[0] = Some(first);
        self.steps[1] = Some(step(|| (sweeps::normal(&surface), ()))?.0);
        let distance = Fraction::from(Poly::variable(&Variable::new(Variable::SYMBOL, "r")));
        let offset = || surface.offset(&distance).expect("the normal of an oriented translation is rational");
        self.steps[2] = Some(step(|| (coordinates(&offset()), ()))?.0);
        Ok(())
    }
}

/// Measures what gives the polynomials of a result and something more.
fn step<T>(work: impl FnOnce() -> (Vec<Poly>, T)) -> Result<(Step, T), Exhausted> {
    let start = Instant::now();
    let ((polys, rest), units) = with_budget(LIMIT, || measured(work))?;
    let time = start.elapsed();
    let bits = |poly: &Poly| {
        let content = poly.content();
        let bits = poly.terms().iter().map(|term| (&term.coefficient * content.numer()).bits());
        bits.max().unwrap_or(0)
    };
    let terms = polys.iter().map(|poly| poly.terms().len()).sum();
    Ok((Step { time, terms, bits: polys.iter().map(bits).max().unwrap_or(0), units }, rest))
}

impl Step {
    /// The time in milliseconds.
    pub(crate) fn milliseconds(&self) -> f64 {
        self.time.as_secs_f64() * 1e3
    }

    /// Units of the budget in a microsecond.
    pub(crate) fn rate(&self) -> f64 {
        self.units as f64 / (self.time.as_secs_f64() * 1e6)
    }
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:>6}", self.degree)?;
        for step in self.steps {
            match step {
                None => write!(f, " | {:^37}", "-")?,
                Some(step) => {
                    let (time, rate) = (step.milliseconds(), step.rate());
                    write!(
                        f,
                        " | {time:>10.3} {:>7} {:>6} {:>6} {rate:>5.1}",
                        step.terms,
                        step.bits,
                        step.units / 1000
                    )?;
                }
            }
        }
        Ok(())
    }
}
