//! Proved bounds of the rounding errors of a program.
//!
//! [`prove`] takes a program with its constants rounded, the exact program that it came from, and a domain, and
//! bounds |computed − exact| over the whole closed domain, for the very sequence of operations: the rounding of
//! constants, every sum, product, quotient and root, a fused multiply-add as one rounding where it is one, and
//! underflow. The parameters are floats and count as exact numbers. Overflow is excluded, or there is no bound.
//!
//! How: the domain is divided into boxes. On a box every value lies in an interval (Moore, *Interval Analysis*,
//! 1966) and is a linear function of the parameters up to a remainder (affine arithmetic); its error is at most
//! what the errors of its operands and its own rounding make of it: running error analysis (Higham, *Accuracy
//! and Stability of Numerical Algorithms*, 2nd ed., 2002, §3.3) over intervals in place of computed numbers.
//! Values of one parameter are bounded on many narrow intervals; those of both on boxes that are divided
//! further where the errors are largest, or where a denominator or a radicand is not yet known to stay away
//! from zero. That it does is proved along the way, and where it is not, there is no bound, but an
//! [`Unbounded`] with the place.
//!
//! A value that is turned by the sign of another one is no number where that one is computed as 0. A bound holds wherever there
//! is a number: for a unit normal on a domain with singular points, everywhere else. That the sign is the right one is proved
//! where the other value is not 0, be it as small as it may.
//!
//! The bound is above the largest error by what errors that happen to cancel are not seen to, and by what boxes are too wide: by
//! a factor of 2 to 8 for points and first derivatives of the catalogue, up to 90 for curvatures.
//!
//! All numbers here are integers times powers of two, rounded outward; no float takes part in a proof.
//!
//! ```text
//! dyadic → interval, affine → place → format (one rounding) → steps (one box) → axis, tiles (the domain) → prove
//! ```

#![deny(clippy::float_arithmetic)]

mod affine;
mod axis;
mod cells;
mod constant;
mod dyadic;
mod format;
mod interval;
mod place;
mod scale;
mod steps;
#[cfg(test)]
mod tests;
mod tiles;

use std::collections::BTreeMap;
use std::convert::Infallible;
use std::fmt;

use hodograph_algebra::{Poly, Rational};

use crate::program::{Input, Operation, Program, Stage, Value, Variant};
use axis::{Axis, LEAF_LEVEL, Part};
use cells::Cells;
use constant::Constant;
use dyadic::Dyadic;
use interval::Interval;
use steps::Steps;
use tiles::{Known, Tiles};

/// A format of floats.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Precision {
    /// `f64`, with u = 2^-53.
    Double,
    /// `f32`, with u = 2^-24; constants are those of `f64`, rounded once more.
    Single,
}

impl Precision {
    /// The exponent of the unit roundoff u, which is −53 or −24.
    #[must_use]
    pub fn unit_exponent(self) -> i32 {
        match self {
            Precision::Double => -53,
            Precision::Single => -24,
        }
    }
}

/// How a program is run: in which format, and whether products are rounded before they are added.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Rounding {
    /// The format.
    pub precision: Precision,
    /// How a product is added.
    pub variant: Variant,
}

impl Rounding {
    /// Both formats in both variants.
    pub const ALL: [Rounding; 4] = [
        Rounding { precision: Precision::Double, variant: Variant::Plain },
        Rounding { precision: Precision::Double, variant: Variant::Fused },
        Rounding { precision: Precision::Single, variant: Variant::Plain },
        Rounding { precision: Precision::Single, variant: Variant::Fused },
    ];
}

/// What is proved of one value over the domain; all numbers are rounded to the safe side.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ValueBound {
    /// |computed − exact| is at most this.
    pub error: f64,
    /// The exact value is never below the first nor above the second.
    pub range: [f64; 2],
    /// The exact value is somewhere at least as large in magnitude as this.
    pub attained: f64,
    /// |computed − exact| ≤ `factor`·|exact| + `underflow`, if there is such a bound.
    pub relative: Option<RelativeBound>,
}

impl ValueBound {
    /// An upper bound of |exact|.
    #[must_use]
    pub fn size(&self) -> f64 {
        self.range[1].max(negative(self.range[0]))
    }
}

/// A bound relative to the value itself.
///
/// Values that vanish may have one, such as the product of a parameter with what does not vanish.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct RelativeBound {
    /// The factor of |exact|.
    pub factor: f64,
    /// What comes from underflow: a few of the least subnormal numbers, or 0 if there is none.
    pub underflow: f64,
}

/// Why the error of a value has no bound.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Reason {
    /// It depends on a symbol, whose values are not known.
    Symbol,
    /// A denominator is not known to stay away from 0.
    Denominator,
    /// A quotient grows beyond all numbers: its denominator is 0 somewhere, and its numerator is not.
    Pole,
    /// A radicand is not known to stay above 0.
    Radicand,
    /// The sign of an operand that turns another one is not known.
    Sign,
    /// The largest component of a direction is not known to stay away from 0.
    Direction,
    /// An operation may overflow.
    Overflow,
    /// It is not independent of the power of two that a direction is scaled by.
    Scale,
}

/// A value whose error has no bound, and where.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Unbounded {
    /// The first value without a bound among those that it is computed from.
    pub value: Value,
    /// Why that value has none.
    pub reason: Reason,
    /// A box within the domain, or a little beyond its ends, where it has none: from and to for u, then for v.
    pub place: [[f64; 2]; 2],
}

impl fmt::Display for Unbounded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let value = self.value.index();
        let [[u0, u1], [v0, v1]] = self.place;
        match self.reason {
            Reason::Symbol => return write!(f, "%{value} is not known before the program is run"),
            Reason::Scale => return write!(f, "%{value} depends on the scale of a direction"),
            Reason::Denominator => write!(f, "the denominator of %{value} may be zero")?,
            Reason::Pole => write!(f, "%{value} grows beyond all bounds")?,
            Reason::Radicand => write!(f, "the radicand of %{value} may be zero or less")?,
            Reason::Sign => write!(f, "the sign that %{value} takes is not known")?,
            Reason::Direction => write!(f, "the direction that %{value} scales may be zero")?,
            Reason::Overflow => write!(f, "%{value} may overflow")?,
        }
        write!(f, " near u in {u0}..{u1}, v in {v0}..{v1}")
    }
}

impl std::error::Error for Unbounded {}

/// The error of two programs that are not the same but for constants.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Misaligned;

impl fmt::Display for Misaligned {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the exact program and the rounded one have other operations")
    }
}

impl std::error::Error for Misaligned {}

/// What is proved of a program in one format and variant.
#[derive(Clone, Debug)]
pub struct Proof {
    /// The format and the variant.
    pub rounding: Rounding,
    outputs: BTreeMap<String, Vec<Result<ValueBound, Unbounded>>>,
}

impl Proof {
    /// The bounds of the results of an output; none if there is no such output.
    pub fn output(&self, name: &str) -> &[Result<ValueBound, Unbounded>] {
        self.outputs.get(name).map_or(&[], Vec::as_slice)
    }

    /// The largest error of the results of an output; infinite if there is no such output.
    ///
    /// # Errors
    /// The first result without a bound.
    pub fn error(&self, name: &str) -> Result<f64, Unbounded> {
        let mut largest = if self.output(name).is_empty() { f64::INFINITY } else { 0.0 };
        for bound in self.output(name) {
            largest = largest.max((*bound)?.error);
        }
        Ok(largest)
    }

    /// The largest magnitude that a result of an output has for certain somewhere on the domain: a lower bound
    /// of the size that an error is compared with.
    #[must_use]
    pub fn attained(&self, name: &str) -> f64 {
        let bounds = self.output(name).iter().flatten();
        bounds.fold(0.0, |largest: f64, bound| largest.max(bound.attained))
    }
}

/// Proves bounds of the errors of all outputs of `rounded` over `domain`, in each of `roundings`.
///
/// `exact` is the same program with the numbers that the constants of `rounded` stand for; [`Program::fused`]
/// is applied to it before its constants are rounded, not after, so that both have the same values.
///
/// A program of n operations takes at most some 10^5 + 10^2·n operations on boxes, each with one error for each
/// rounding.
///
/// # Errors
/// [`Misaligned`] if both are not the same program.
///
/// # Example
/// ```
/// use hodograph_algebra::{Poly, integer, ratio};
/// use hodograph_codegen::bound::{Rounding, prove};
/// use hodograph_codegen::program::{Input, Program};
/// use hodograph_codegen::round::round;
///
/// let mut program = Program::new();
/// let (u, third) = (program.input(Input::U), program.constant(Poly::constant(ratio(1, 3))));
/// let product = program.multiply(third, u);
/// program.output("third", vec![product]);
///
/// let domain = [[integer(1), integer(2)], [integer(0), integer(1)]];
/// let proofs = prove(&program, &round(&program).unwrap(), &domain, &Rounding::ALL).unwrap();
/// let bound = proofs[0].output("third")[0].unwrap();
/// // The constant is off by 2^-54/3, and the product below 1 is rounded by at most 2^-54.
/// assert!(bound.error <= 2.0_f64.powi(-53) * 0.84);
/// assert!(bound.relative.unwrap().factor <= 2.0_f64.powi(-53) * 1.51);
/// ```
pub fn prove(
    exact: &Program<Poly>,
    rounded: &Program<f64>,
    domain: &[[Rational; 2]; 2],
    roundings: &[Rounding],
) -> Result<Vec<Proof>, Misaligned> {
    let constants = constants(exact, rounded, roundings)?;
    let steps = Steps::new(rounded, constants, roundings);
    let results = Domain::new(rounded, &steps, domain).prove();
    let proof = |(k, &rounding): (usize, &Rounding)| {
        let of = |value: &Value| {
            let Some(result) = results.get(&value.index()) else {
                return Err(unknown(*value, Reason::Symbol));
            };
            result[k]
        };
        let outputs = rounded.outputs().iter();
        let outputs = outputs.map(|output| (output.name.clone(), output.values.iter().map(of).collect()));
        Proof { rounding, outputs: outputs.collect() }
    };
    Ok(roundings.iter().enumerate().map(proof).collect())
}

/// The constants of a program, at their values.
fn constants(
    exact: &Program<Poly>,
    rounded: &Program<f64>,
    roundings: &[Rounding],
) -> Result<Vec<Option<Constant>>, Misaligned> {
    let shape =
        |program: Result<Program<f64>, Infallible>| program.map(|program| program.operations().to_vec());
    let shapes = (shape(exact.map_constants(|_| Ok(0.0))), shape(rounded.map_constants(|_| Ok(0.0))));
    if shapes.0 != shapes.1 {
        return Err(Misaligned);
    }
    let constant = |(number, used): (&Operation<Poly>, &Operation<f64>)| match (number, used) {
        (Operation::Constant(number), Operation::Constant(used)) => Constant::new(number, *used, roundings),
        _ => None,
    };
    Ok(exact.operations().iter().zip(rounded.operations()).map(constant).collect())
}

/// Which values depend on symbols.
fn depends_on_symbols(program: &Program<f64>) -> Vec<bool> {
    let mut depends: Vec<bool> = Vec::new();
    for operation in program.operations() {
        let symbol = matches!(operation, Operation::Input(Input::Symbol(_)));
        depends.push(symbol || operation.operands().iter().any(|operand| depends[operand.index()]));
    }
    depends
}

/// What is proved of one value: for each rounding a bound, or why there is none.
type Outcome = Vec<Result<ValueBound, Unbounded>>;

/// A box.
type Place = (Part, Part);

fn unknown(value: Value, reason: Reason) -> Unbounded {
    Unbounded { value, reason, place: [[f64::NEG_INFINITY, f64::INFINITY]; 2] }
}

/// A program on a domain.
struct Domain<'a> {
    program: &'a Program<f64>,
    steps: &'a Steps,
    /// The values that are asked for.
    results: Vec<usize>,
    /// All values that they are computed from, in order.
    needed: Vec<usize>,
    /// Cells of all values, with constants filled in.
    cells: Cells,
    axes: [Axis<'a>; 2],
}

impl<'a> Domain<'a> {
    fn new(program: &'a Program<f64>, steps: &'a Steps, domain: &[[Rational; 2]; 2]) -> Domain<'a> {
        let mut results: Vec<Value> =
            program.outputs().iter().flat_map(|output| output.values.clone()).collect();
        results.sort_unstable();
        results.dedup();
        // What depends on symbols is not known, so it is not looked at.
        let depends = depends_on_symbols(program);
        results.retain(|value| !depends[value.index()]);
        let needed = program.needed(&results);
        let of_stage = |stage: Stage| {
            let values = needed.iter().filter(|&&value| program.stage(value) == stage);
            values.map(|value| value.index()).collect::<Vec<usize>>()
        };
        let mut cells = steps.cells();
        let nowhere = [Interval::point(Dyadic::ZERO); 2];
        for value in of_stage(Stage::Constant) {
            steps.run(value, &nowhere, &mut cells);
        }
        let axis = |parameter: usize, stage: Stage| {
            let both = || needed.iter().filter(|&&value| program.stage(value) == Stage::Both);
            let operands = both().flat_map(|&value| program.operation(value).operands());
            let mut kept: Vec<usize> = operands.chain(results.clone()).map(|value| value.index()).collect();
            kept.extend(both().flat_map(|value| steps.squared(value.index())));
            kept.retain(|&value| steps.stage(value) == stage);
            kept.sort_unstable();
            kept.dedup();
            Axis::new(steps, parameter, &domain[parameter], of_stage(stage), kept, cells.clone())
        };
        let axes = [axis(0, Stage::U), axis(1, Stage::V)];
        let index = |values: &[Value]| values.iter().map(|value| value.index()).collect();
        Domain { program, steps, results: index(&results), needed: index(&needed), cells, axes }
    }

    /// What is proved of all results.
    fn prove(&mut self) -> BTreeMap<usize, Outcome> {
        let mut outcomes = BTreeMap::new();
        for value in self.results.clone() {
            let (cells, attained, failures) = match self.steps.stage(value) {
                Stage::Constant | Stage::Symbols => {
                    let cells = self.steps.best(&self.cells, &[value]);
                    let attained = cells.least(0);
                    (cells, attained, Vec::new())
                }
                Stage::U => self.of_one(value, 0),
                Stage::V => self.of_one(value, 1),
                Stage::Both => continue,
            };
            let outcome = self.outcome(value, &cells, 0, attained, &failures);
            outcomes.insert(value, outcome);
        }
        let both = |values: &[usize]| {
            let values = values.iter().copied().filter(|&value| self.steps.stage(value) == Stage::Both);
            values.collect::<Vec<usize>>()
        };
        let (order, results) = (both(&self.needed), both(&self.results));
        if results.is_empty() {
            return outcomes;
        }
        let cells = self.cells.clone();
        let hopeless = vec![vec![false; self.steps.formats().len()]; results.len()];
        let mut tiles = Tiles { steps: self.steps, axes: &mut self.axes, order, results, cells, hopeless };
        let Known { cells, attained, failures } = tiles.prove();
        let results = tiles.results;
        for (place, &value) in results.iter().enumerate() {
            let outcome = self.outcome(value, &cells, place, attained[place], &failures[place]);
            outcomes.insert(value, outcome);
        }
        outcomes
    }

    /// What is known of a value of one parameter, and for each format where it is not.
    fn of_one(&mut self, value: usize, parameter: usize) -> (Cells, Dyadic, Vec<Option<Place>>) {
        /// The level of halving beyond which a value counts as not bounded.
        const LAST_LEVEL: u32 = 12;
        let steps = self.steps;
        let axis = &mut self.axes[parameter];
        let place = axis.kept().iter().position(|&kept| kept == value).unwrap_or_default();
        let mut waiting: Vec<Part> = (0..1 << LEAF_LEVEL).rev().map(|place| (LEAF_LEVEL, place)).collect();
        let (mut whole, mut attained): (Option<Cells>, Dyadic) = (None, Dyadic::ZERO);
        let mut failures: Vec<Option<Part>> = vec![None; steps.formats().len()];
        while let Some(part) = waiting.pop() {
            let cells = steps.best(axis.on(part), &[place]);
            let mut open = failures
                .iter_mut()
                .enumerate()
                .filter(|(k, failure)| failure.is_none() && !cells.is_bounded_in(0, *k))
                .peekable();
            if open.peek().is_some() && part.0 < LAST_LEVEL {
                waiting.extend(axis::halves(part).into_iter().rev());
                continue;
            }
            open.for_each(|(_, failure)| *failure = Some(part));
            attained = attained.max(cells.least(0));
            match &mut whole {
                None => whole = Some(cells),
                Some(whole) => whole.join(&cells),
            }
        }
        let whole = whole.unwrap_or_else(|| self.cells.of(&[value]));
        let parts = |part: Part| if parameter == 0 { (part, (0, 0)) } else { ((0, 0), part) };
        (whole, attained, failures.into_iter().map(|failure| failure.map(parts)).collect())
    }

    /// What is proved of `value`, of which these cells know at `at`, and where they do not, for each format.
    fn outcome(
        &self,
        value: usize,
        cells: &Cells,
        at: usize,
        attained: Dyadic,
        failures: &[Option<Place>],
    ) -> Outcome {
        let formats = self.steps.formats();
        if self.steps.is_scaled(value) {
            return vec![Err(unknown(self.value(value), Reason::Scale)); formats.len()];
        }
        let bound = |k: usize, format: &format::Format| {
            let (range, error) = (cells.range(at)?, cells.error(at, k));
            let relative = error.relative.is_known().then(|| RelativeBound {
                factor: format.number(error.relative).to_f64(),
                underflow: error.tiny.to_f64(),
            });
            error.is_known.then(|| ValueBound {
                error: error.absolute.to_f64(),
                range: ends(&range),
                attained: negative((-attained).to_f64()),
                relative,
            })
        };
        let failure = |k: usize| {
            let place = failures.get(k).copied().flatten();
            self.failure(value, k, place.unwrap_or(((0, 0), (0, 0))))
        };
        formats.iter().enumerate().map(|(k, format)| bound(k, format).ok_or_else(|| failure(k))).collect()
    }

    /// What is the first to have no bound in a format on a box, of what `value` is computed from.
    fn failure(&self, value: usize, format: usize, (u, v): Place) -> Unbounded {
        let inputs = [self.axes[0].interval(u), self.axes[1].interval(v)];
        let mut cells = self.cells.clone();
        let mut first = value;
        for needed in self.program.needed(&[self.value(value)]) {
            let needed = needed.index();
            self.steps.run(needed, &inputs, &mut cells);
            if !cells.is_bounded_in(needed, format) {
                first = needed;
                break;
            }
        }
        let place = [ends(&inputs[0]), ends(&inputs[1])];
        let mut reason = self.steps.reason(first);
        if reason == Reason::Denominator && self.has_pole(first, &inputs) {
            reason = Reason::Pole;
        }
        Unbounded { value: self.value(first), reason, place }
    }

    /// Whether a quotient has a pole at a corner of a box.
    fn has_pole(&self, quotient: usize, [u, v]: &[Interval; 2]) -> bool {
        let corners = [(u.lower, v.lower), (u.lower, v.upper), (u.upper, v.lower), (u.upper, v.upper)];
        let needed = self.program.needed(&[self.value(quotient)]);
        corners.into_iter().any(|(u, v)| {
            let (inputs, mut cells) = ([Interval::point(u), Interval::point(v)], self.cells.clone());
            for &value in &needed {
                self.steps.run(value.index(), &inputs, &mut cells);
            }
            self.steps.has_pole(quotient, &cells)
        })
    }

    fn value(&self, index: usize) -> Value {
        self.program.values().nth(index).unwrap_or_else(|| unreachable!("the program has it"))
    }
}

/// The ends of an interval, rounded outward.
fn ends(interval: &Interval) -> [f64; 2] {
    [negative((-interval.lower).to_f64()), interval.upper.to_f64()]
}

/// −x of a float, where 0 has no sign.
fn negative(float: f64) -> f64 {
    let bits = float.to_bits() ^ 1 << 63;
    f64::from_bits(if bits == 1 << 63 { 0 } else { bits })
}
