//! The operations of a program, run over intervals and errors at once.

use hodograph_algebra::Rational;

use super::affine::Affine;
use super::cells::Cells;
use super::constant::Constant;
use super::dyadic::Dyadic;
use super::format::{Error, Format, Rounds, Spread};
use super::interval::Interval;
use super::place::Place;
use super::scale::{Degree, degrees};
use super::{Reason, Rounding, negative};
use crate::program::{Input, Operation, Program, Stage, Value};
use crate::round::{exact, nearest_to_rational};

/// A value's operation, with what can be told before any box is known.
#[derive(Clone, Copy, Debug)]
enum Step {
    Constant,
    Input(Input),
    /// The result may be the distance of a parameter from a number in parts.
    Add {
        a: usize,
        b: usize,
        minus: bool,
        distance: bool,
    },
    /// A component of a unit vector is between −1 and 1.
    Multiply {
        a: usize,
        b: usize,
        rounds: Rounds,
        unit: bool,
    },
    Divide {
        a: usize,
        b: usize,
    },
    Negate(usize),
    SquareRoot {
        a: usize,
        squares: Squares,
    },
    MultiplyAdd {
        a: usize,
        b: usize,
        c: usize,
        rounds: Rounds,
    },
    Orient {
        a: usize,
        b: usize,
    },
    Scale([usize; 3]),
}

/// The values whose squares another value is the sum of, if it is one.
#[derive(Clone, Copy, Default, Debug)]
struct Squares {
    parts: [usize; Squares::MOST],
    count: usize,
}

impl Squares {
    /// How many squares are looked for.
    const MOST: usize = 3;

    /// `None` if the value is no sum of so few squares, added in at most `depth` steps.
    fn of(program: &Program<f64>, value: Value, depth: usize) -> Option<Squares> {
        let depth = depth.checked_sub(1)?;
        let (part, rest) = match *program.operation(value) {
            Operation::Multiply(a, b) if a == b => (a, Squares::default()),
            Operation::MultiplyAdd(a, b, c) if a == b => (a, Squares::of(program, c, depth)?),
            Operation::Add(a, b) => {
                let (first, second) = (Squares::of(program, a, depth)?, Squares::of(program, b, depth)?);
                let mut sum = first;
                for &part in &second.parts[..second.count] {
                    sum = sum.with(part)?;
                }
                return Some(sum);
            }
            _ => return None,
        };
        rest.with(part.index())
    }

    fn with(mut self, part: usize) -> Option<Squares> {
        *self.parts.get_mut(self.count)? = part;
        self.count += 1;
        Some(self)
    }
}

/// Whether the sum of both, or their difference, is the distance d = ±(x − e) of a parameter x from a number e = a + b + c in parts that are
/// subtracted one after the other: the nearest float of single precision, the rest of the nearest one of double precision, and the
/// rest of e. One of the last two may be absent.
///
/// Then the relative error is at most 5 u in both precisions. Far from a, for |x − a| ≥ 2^-20·|a|, b and c are small, and there are three
/// roundings. Else x − a is exact. In double precision so is x − a − b then, and |d| ≥ |c|, since a + b is the float that is nearest to e:
/// what is left are the roundings of c and of the last sum. In single precision |d| ≥ |b + c|, since a is nearest; c is at most half as
/// large as b, and much smaller than x − a if that is not 0: the roundings of b and c and of two sums are left, or of one for x = a.
fn is_distance(program: &Program<f64>, first: Value, second: Value, minus: bool) -> bool {
    let Some(last) = constant(program, second) else { return false };
    let from = |value: Value| match *program.operation(value) {
        Operation::Subtract(a, b) => match (program.operation(a), program.operation(b)) {
            (Operation::Input(Input::U | Input::V), Operation::Constant(number)) => Some((*number, true)),
            (Operation::Constant(number), Operation::Input(Input::U | Input::V)) => Some((*number, false)),
            _ => None,
        },
        _ => None,
    };
    let is_single = |part: f64, number: &Rational| {
        nearest_to_rational(number).is_some_and(|number| f64::from(number as f32) == part)
    };
    // Parts that no float of single precision holds would be lost there.
    let is_normal = |part: f64| part.abs() > 1e-30;
    // The sum of parts that is a float of double precision, of which the first one is that of single precision.
    let joined = |a: f64, b: f64| {
        let sum = exact(a)? + exact(b)?;
        let is_float = nearest_to_rational(&sum).and_then(exact).is_some_and(|float| float == sum);
        (is_float && is_single(a, &sum) && is_normal(b)).then_some(sum)
    };
    let is_rest = |number: &Rational, c: f64| {
        let sum = exact(c).map(|c| number + &c);
        let float = sum.and_then(|sum| nearest_to_rational(&sum)).and_then(exact);
        float.is_some_and(|float| float == *number) && is_normal(c)
    };
    // What is subtracted from x − a, or added to a − x, is a part.
    let signed =
        |part: f64, minus: bool, is_above: bool| if minus == is_above { part } else { negative(part) };
    if let Some((a, is_above)) = from(first) {
        let last = signed(last, minus, is_above);
        let is_whole = exact(a).is_some_and(|number| is_single(a, &number) && is_rest(&number, last));
        return is_whole || joined(a, last).is_some();
    }
    let (start, part, inner_minus) = match program.operation(first) {
        Operation::Add(start, part) => (*start, *part, false),
        Operation::Subtract(start, part) => (*start, *part, true),
        _ => return false,
    };
    let (Some((a, is_above)), Some(b)) = (from(start), constant(program, part)) else { return false };
    let (b, c) = (signed(b, inner_minus, is_above), signed(last, minus, is_above));
    joined(a, b).is_some_and(|sum| is_rest(&sum, c))
}

fn constant(program: &Program<f64>, value: Value) -> Option<f64> {
    match program.operation(value) {
        Operation::Constant(number) => Some(*number),
        _ => None,
    }
}

/// A program that is ready to be run over boxes.
pub(super) struct Steps {
    steps: Vec<Step>,
    stages: Vec<Stage>,
    degrees: Vec<Degree>,
    formats: Vec<Format>,
    constants: Vec<Option<Constant>>,
}

impl Steps {
    pub(super) fn new(
        program: &Program<f64>,
        constants: Vec<Option<Constant>>,
        roundings: &[Rounding],
    ) -> Steps {
        let power = |value: usize| -> Option<i32> {
            let Operation::Constant(constant) = &program.operations()[value] else { return None };
            // Below 2^64 they are the same in both formats.
            Dyadic::of(*constant)?.as_power_of_two().filter(|power| (-64..64).contains(power))
        };
        let is_scale = |value: usize| matches!(program.operations()[value], Operation::Scale(..));
        let rounds = |a: usize, b: usize| match power(a).or(power(b)) {
            Some(0..) => Rounds::Exactly,
            Some(_) => Rounds::WhereSubnormal,
            None if is_scale(a) || is_scale(b) => Rounds::WhereSubnormal,
            None => Rounds::Product,
        };
        // Whether `inverse` is 1/√(a² + …).
        let is_part = |a: usize, inverse: usize| {
            let Operation::Divide(one, norm) = program.operations()[inverse] else { return false };
            let Operation::SquareRoot(sum) = *program.operation(norm) else { return false };
            let squares = Squares::of(program, sum, Squares::MOST).unwrap_or_default();
            let one = matches!(program.operation(one), Operation::Constant(one) if *one == 1.0);
            one && squares.parts[..squares.count].contains(&a)
        };
        let step = |operation: &Operation<f64>| match *operation {
            Operation::Constant(_) => Step::Constant,
            Operation::Input(input) => Step::Input(input),
            Operation::Add(a, b) => Step::Add {
                a: a.index(),
                b: b.index(),
                minus: false,
                distance: is_distance(program, a, b, false),
            },
            Operation::Subtract(a, b) => Step::Add {
                a: a.index(),
                b: b.index(),
                minus: true,
                distance: is_distance(program, a, b, true),
            },
            Operation::Multiply(a, b) => {
                let (a, b) = (a.index(), b.index());
                Step::Multiply { a, b, rounds: rounds(a, b), unit: is_part(a, b) || is_part(b, a) }
            }
            Operation::Divide(a, b) => Step::Divide { a: a.index(), b: b.index() },
            Operation::Negate(a) => Step::Negate(a.index()),
            Operation::SquareRoot(a) => Step::SquareRoot {
                a: a.index(),
                squares: Squares::of(program, a, Squares::MOST).unwrap_or_default(),
            },
            Operation::MultiplyAdd(a, b, c) => {
                let (a, b, c) = (a.index(), b.index(), c.index());
                Step::MultiplyAdd { a, b, c, rounds: rounds(a, b) }
            }
            Operation::Orient(a, b) => Step::Orient { a: a.index(), b: b.index() },
            Operation::Scale(a, b, c) => Step::Scale([a.index(), b.index(), c.index()]),
        };
        Steps {
            steps: program.operations().iter().map(step).collect(),
            stages: program.values().map(|value| program.stage(value)).collect(),
            degrees: degrees(program),
            formats: roundings.iter().map(|&rounding| Format::new(rounding)).collect(),
            constants,
        }
    }

    /// What it costs to run so many values, in units of work.
    pub(super) fn price(&self, values: usize) -> u64 {
        (values * (2 + 3 * self.formats.len())) as u64
    }

    /// The cells of some values, with the best errors that can be told from them.
    pub(super) fn best(&self, cells: &Cells, values: &[usize]) -> Cells {
        let mut best = cells.of(values);
        for value in 0..values.len() {
            let Some(place) = best.place(value).copied() else { continue };
            for (k, format) in self.formats.iter().enumerate() {
                let error = format.lessened(&place, best.error(value, k));
                if error.is_known {
                    best.set_error(value, k, format.best(&place, &error));
                }
            }
        }
        best
    }

    /// Whether the value is a multiple of a power of a scale other than the power 0.
    pub(super) fn is_scaled(&self, value: usize) -> bool {
        self.degrees[value].scale().is_some()
    }

    pub(super) fn formats(&self) -> &[Format] {
        &self.formats
    }

    pub(super) fn stage(&self, value: usize) -> Stage {
        self.stages[value]
    }

    /// The values whose squares are added under the root `value`, if it is one: its error is told from theirs.
    pub(super) fn squared(&self, value: usize) -> &[usize] {
        match &self.steps[value] {
            Step::SquareRoot { squares, .. } => &squares.parts[..squares.count],
            _ => &[],
        }
    }

    /// Cells of all values, of which nothing is known yet.
    pub(super) fn cells(&self) -> Cells {
        Cells::new(self.steps.len(), self.formats.len())
    }

    /// Computes the cell of `value` from those of its operands, on a box with these intervals of u and v.
    pub(super) fn run(&self, value: usize, inputs: &[Interval; 2], cells: &mut Cells) {
        let step = self.steps[value];
        let place = match self.degrees[value].is_homogeneous() {
            true => self.place(step, value, inputs, cells),
            false => None,
        };
        let Some(place) = place else { return cells.forget(value) };
        cells.set_place(value, Some(place));
        if let Step::Scale(operands) = step {
            return self.run_scale(value, operands, cells);
        }
        let spread = self.spread(value, cells);
        let product = match step {
            // It is needed by itself.
            Step::MultiplyAdd { a, b, .. } => self.product(a, b, cells).unwrap_or(place),
            _ => place,
        };
        let mut k = 0;
        while k < self.formats.len() {
            let error = self.error(step, value, k, cells, &place, &product, spread);
            let mut error = error.unwrap_or(Error::UNKNOWN);
            error.keeps_sign = error.is_known
                && (self.keeps_sign(step, k, cells, &product)
                    || self.formats[k].is_certain((&place, &error)));
            cells.set_error(value, k, error);
            k += 1;
        }
    }

    /// The error of `value` in a format, at its `place` and with that of its `product`.
    #[expect(clippy::too_many_arguments, reason = "it is one part of `run`")]
    fn error(
        &self,
        step: Step,
        value: usize,
        k: usize,
        cells: &Cells,
        place: &Place,
        product: &Place,
        spread: Spread,
    ) -> Option<Error> {
        let format = &self.formats[k];
        Some(match step {
            Step::Constant => format.constant(place, self.constants[value].as_ref()?.error(k)?),
            Step::Input(_) | Step::Scale(_) => Error::NONE,
            Step::Add { a, b, minus, distance } => {
                let (left, right) = ((cells.place(a)?, cells.error(a, k)), cells.error(b, k));
                let b = cells.place(b)?;
                let sum = if minus {
                    format.sum(left, (&b.negated(), right), place, spread)
                } else {
                    format.sum(left, (b, right), place, spread)
                };
                if distance { format.better(&sum, &format.distance(place)) } else { sum }
            }
            Step::Multiply { a, b, rounds, .. } => {
                let (left, right) =
                    ((cells.place(a)?, cells.error(a, k)), (cells.place(b)?, cells.error(b, k)));
                format.product(left, right, place, rounds, spread)
            }
            Step::Divide { a, b } => {
                format.quotient(cells.error(a, k), (cells.place(b)?, cells.error(b, k)), place, spread)
            }
            Step::Negate(a) => *cells.error(a, k),
            Step::SquareRoot { a, squares } => {
                let root = format.root((cells.place(a)?, cells.error(a, k)), place, spread);
                // A norm is in range where its square may not be.
                if squares.count == 0 || !cells.error(a, k).is_known {
                    return Some(root);
                }
                let mut parts = [(place, &Error::NONE); Squares::MOST];
                for (part, &value) in parts.iter_mut().zip(&squares.parts[..squares.count]) {
                    *part = (cells.place(value)?, cells.error(value, k));
                }
                format.better(&root, &format.norm(&parts[..squares.count], place, spread))
            }
            Step::MultiplyAdd { a, b, c, rounds } => {
                let operands = [
                    (cells.place(a)?, cells.error(a, k)),
                    (cells.place(b)?, cells.error(b, k)),
                    (cells.place(c)?, cells.error(c, k)),
                ];
                format.product_and_sum(operands, product, place, rounds, spread)
            }
            // Where b̂ is 0 there is no number.
            Step::Orient { a, b } => match cells.error(b, k).keeps_sign {
                true => *cells.error(a, k),
                false => Error::UNKNOWN,
            },
        })
    }

    /// Whether the computed value of a step is 0 or has the sign of the exact one, as its operands show; `product` is that of a
    /// product that is added.
    fn keeps_sign(&self, step: Step, k: usize, cells: &Cells, product: &Place) -> bool {
        let format = &self.formats[k];
        let of = |value: usize| cells.error(value, k).keeps_sign;
        match step {
            // Rounding, and underflow of a product, change no sign.
            Step::Constant | Step::Input(_) | Step::Scale(_) => true,
            // What is not 0 may be the root of 0.
            Step::Negate(a) | Step::SquareRoot { a, .. } => of(a),
            Step::Multiply { a, b, .. } | Step::Divide { a, b } | Step::Orient { a, b } => of(a) && of(b),
            Step::Add { distance: true, .. } => true,
            Step::Add { a, b, minus, .. } => match (cells.place(a), cells.place(b)) {
                (Some(first), Some(second)) => {
                    let second = if minus { second.negated() } else { *second };
                    format.sum_keeps_sign((first, cells.error(a, k)), (&second, cells.error(b, k)))
                }
                _ => false,
            },
            Step::MultiplyAdd { a, b, c, .. } => cells.place(c).is_some_and(|third| {
                let of_product = Error { keeps_sign: of(a) && of(b), ..Error::UNKNOWN };
                format.sum_keeps_sign((product, &of_product), (third, cells.error(c, k)))
            }),
        }
    }

    /// A scale counts as 1; its spread is what it may be in any of the formats.
    fn run_scale(&self, value: usize, operands: [usize; 3], cells: &mut Cells) {
        let mut spread: Option<Spread> = None;
        for (k, format) in self.formats.iter().enumerate() {
            let scales = || -> Option<Spread> {
                let (mut least, mut largest) = (Dyadic::ZERO, Dyadic::ZERO);
                for operand in operands {
                    let (place, error) = (cells.place(operand)?, cells.error(operand, k));
                    if !error.is_known {
                        return None;
                    }
                    least = least.max(-error.absolute.plus(-place.least));
                    largest = largest.max(place.largest.plus(error.absolute));
                }
                format.scales(least, largest)
            };
            let scales = scales();
            if let Some(found) = scales {
                let known = spread.unwrap_or(found);
                spread = Some((known.0.min(found.0), known.1.max(found.1)));
            }
            cells.set_error(value, k, if scales.is_some() { Error::NONE } else { Error::UNKNOWN });
        }
        cells.set_spread(value, spread.unwrap_or((0, 0)));
    }

    /// The exact values of a·b.
    fn product(&self, a: usize, b: usize, cells: &Cells) -> Option<Place> {
        let first = cells.place(a)?;
        Some(if a == b { first.square() } else { first.times(cells.place(b)?) })
    }

    /// The exact values of `value`.
    fn place(&self, step: Step, value: usize, inputs: &[Interval; 2], cells: &Cells) -> Option<Place> {
        let place = match step {
            Step::Constant => Place::of(&self.constants[value].as_ref()?.range()),
            Step::Input(Input::U) => Place::new(&inputs[0], Affine::parameter(&inputs[0], true)),
            Step::Input(Input::V) => Place::new(&inputs[1], Affine::parameter(&inputs[1], false)),
            Step::Input(Input::Symbol(_)) => return None,
            Step::Add { a, b, minus: false, .. } => cells.place(a)?.plus(cells.place(b)?),
            Step::Add { a, b, minus: true, .. } => cells.place(a)?.plus(&cells.place(b)?.negated()),
            Step::Multiply { a, b, unit, .. } => {
                let product = self.product(a, b, cells)?;
                let whole = Interval { lower: -Dyadic::ONE, upper: Dyadic::ONE };
                if unit { Place::new(&product.range.meet(&whole), product.affine) } else { product }
            }
            Step::Divide { a, b } => cells.place(a)?.over(cells.place(b)?)?,
            Step::Negate(a) => return Some(cells.place(a)?.negated()),
            Step::SquareRoot { a, .. } => cells.place(a)?.root()?,
            Step::MultiplyAdd { a, b, c, .. } => self.product(a, b, cells)?.plus(cells.place(c)?),
            Step::Orient { a, b } => match cells.place(b)?.range {
                // Where b is 0 there is no number.
                by if by.is_nonnegative() => return cells.place(a).copied(),
                by if by.is_nonpositive() => return Some(cells.place(a)?.negated()),
                _ => {
                    let range = cells.place(a)?.range;
                    return Some(Place::of(&range.hull(&range.negated())));
                }
            },
            Step::Scale(_) => Place::of(&Interval::point(Dyadic::ONE)),
        };
        // What is far beyond all formats is not computed with.
        if place.largest.magnitude() < 2048 { Some(place) } else { None }
    }

    /// By which powers of two the computed value is scaled.
    fn spread(&self, value: usize, cells: &Cells) -> Spread {
        match self.degrees[value].scale() {
            None => (0, 0),
            Some((scale, degree)) => {
                let (low, high) = cells.spread(scale);
                let ends = (low * degree, high * degree);
                (ends.0.min(ends.1), ends.0.max(ends.1))
            }
        }
    }

    /// Whether `value` is a quotient whose denominator is 0 at a point, and whose numerator is not.
    pub(super) fn has_pole(&self, value: usize, cells: &Cells) -> bool {
        let Step::Divide { a, b } = self.steps[value] else { return false };
        let (Some(a), Some(b)) = (cells.place(a), cells.place(b)) else { return false };
        b.largest.is_zero() && a.least.is_positive()
    }

    /// Why `value` has no bound, although its operands have.
    pub(super) fn reason(&self, value: usize) -> Reason {
        if !self.degrees[value].is_homogeneous() {
            return Reason::Scale;
        }
        match self.steps[value] {
            Step::Input(_) => Reason::Symbol,
            Step::Divide { .. } => Reason::Denominator,
            Step::SquareRoot { .. } => Reason::Radicand,
            Step::Orient { .. } => Reason::Sign,
            Step::Scale(_) => Reason::Direction,
            _ => Reason::Overflow,
        }
    }
}
