//! Bounds against errors that occur.

#![allow(clippy::float_arithmetic)]

use std::cmp::Ordering;
use std::convert::Infallible;

use hodograph_algebra::{Int, Poly, Rational, integer, ratio};
use proptest::prelude::*;

use super::{Misaligned, Precision, Proof, Reason, Rounding, ValueBound, prove};
use crate::compile::exact_program;
use crate::language::parse_text;
use crate::meaning::models;
use crate::program::{
    Arithmetic, Constant, Floats, Input, Interpreter, Operation, Program, Value, Variant, interpret,
};
use crate::round::{exact, nearest, round};
use crate::schedule::outputs;

/// Exact arithmetic but for rounding to multiples of 2^-6000, with roots: a reference that shares nothing with
/// what is tested.
struct Reference {
    u: Int,
    v: Int,
}

/// The binary digits after the point of a reference.
const DIGITS: u64 = 6000;

/// The exponent of what references may be off by: far below the least float, but roots of what they lose are larger.
const TOLERANCE: u64 = 1100;

/// A number as a multiple of 2^-6000.
#[derive(Clone, PartialEq, Debug)]
struct Fixed(Int);

impl Constant for Fixed {
    fn is_zero(&self) -> bool {
        self.0 == Int::ZERO
    }

    fn is_one(&self) -> bool {
        self.0 == Int::ONE.shl(DIGITS)
    }

    fn negated(&self) -> Fixed {
        Fixed(-&self.0)
    }

    fn fingerprint(&self) -> u64 {
        self.0.bits()
    }
}

fn fixed(number: &Rational) -> Int {
    &number.numer().shl(DIGITS) / number.denom()
}

fn fixed_float(float: f64) -> Option<Int> {
    exact(float).map(|number| fixed(&number))
}

fn magnitude(number: &Int) -> Int {
    if *number < Int::ZERO { -number } else { number.clone() }
}

impl Arithmetic<Fixed> for Reference {
    type Number = Int;

    fn constant(&self, constant: &Fixed) -> Int {
        constant.0.clone()
    }

    fn input(&self, input: Input) -> Int {
        if input == Input::U { self.u.clone() } else { self.v.clone() }
    }

    fn add(&self, a: &Int, b: &Int) -> Int {
        a + b
    }

    fn subtract(&self, a: &Int, b: &Int) -> Int {
        a - b
    }

    fn multiply(&self, a: &Int, b: &Int) -> Int {
        (a * b).shr(DIGITS)
    }

    fn divide(&self, a: &Int, b: &Int) -> Option<Int> {
        (*b != Int::ZERO).then(|| &a.shl(DIGITS) / b)
    }

    fn negate(&self, a: &Int) -> Int {
        -a
    }

    fn square_root(&self, a: &Int) -> Option<Int> {
        (*a >= Int::ZERO).then(|| a.shl(DIGITS).isqrt())
    }

    fn orient(&self, a: &Int, b: &Int) -> Option<Int> {
        match b.cmp(&Int::ZERO) {
            Ordering::Less => Some(-a),
            Ordering::Equal => None,
            Ordering::Greater => Some(a.clone()),
        }
    }

    fn scale(&self, _: &Int, _: &Int, _: &Int) -> Option<Int> {
        Some(Int::ONE.shl(DIGITS))
    }
}

/// The arithmetic of `f32`.
struct Singles {
    u: f32,
    v: f32,
    variant: Variant,
}

impl Arithmetic<f64> for Singles {
    type Number = f32;

    fn constant(&self, constant: &f64) -> f32 {
        *constant as f32
    }

    fn input(&self, input: Input) -> f32 {
        if input == Input::U { self.u } else { self.v }
    }

    fn add(&self, a: &f32, b: &f32) -> f32 {
        a + b
    }

    fn subtract(&self, a: &f32, b: &f32) -> f32 {
        a - b
    }

    fn multiply(&self, a: &f32, b: &f32) -> f32 {
        a * b
    }

    fn divide(&self, a: &f32, b: &f32) -> Option<f32> {
        Some(a / b)
    }

    fn negate(&self, a: &f32) -> f32 {
        -a
    }

    fn square_root(&self, a: &f32) -> Option<f32> {
        Some(a.sqrt())
    }

    fn multiply_add(&self, a: &f32, b: &f32, c: &f32) -> f32 {
        match self.variant {
            Variant::Plain => a * b + c,
            Variant::Fused => a.mul_add(*b, *c),
        }
    }

    fn orient(&self, a: &f32, b: &f32) -> Option<f32> {
        (*b != 0.0 && !b.is_nan()).then_some(if *b < 0.0 { -a } else { *a })
    }

    fn scale(&self, a: &f32, b: &f32, c: &f32) -> Option<f32> {
        let largest = a.abs().max(b.abs()).max(c.abs());
        let exponent = (largest.to_bits() >> 23).max(1);
        (largest > 0.0 && largest.is_finite())
            .then(|| f32::from_bits(254_u32.saturating_sub(exponent).max(1) << 23))
    }
}

/// An exact program with the domain that it is bounded on.
struct Subject {
    exact: Program<Poly>,
    reference: Program<Fixed>,
    rounded: Program<f64>,
    domain: [[Rational; 2]; 2],
}

impl Subject {
    /// The subject of a program that is not fused yet.
    fn new(exact: &Program<Poly>, domain: [[Rational; 2]; 2]) -> Subject {
        let exact = exact.fused();
        let number =
            |number: &Poly| number.to_rational().unwrap_or_else(|| number.enclosure(DIGITS).lower().clone());
        let reference = exact.map_constants(|constant| Ok::<_, Infallible>(Fixed(fixed(&number(constant)))));
        Subject { reference: reference.unwrap(), rounded: round(&exact).unwrap(), exact, domain }
    }

    fn prove(&self) -> Vec<Proof> {
        prove(&self.exact, &self.rounded, &self.domain, &Rounding::ALL).unwrap()
    }

    fn results(&self) -> Vec<Value> {
        self.rounded.outputs().iter().flat_map(|output| output.values.clone()).collect()
    }

    /// The errors of all results at a point, which `rounding` has floats for, beside the exact numbers, both as
    /// multiples of 2^-6000; none where they are not defined.
    fn errors(&self, rounding: Rounding, [u, v]: [f64; 2]) -> Vec<Option<(Int, Int)>> {
        let floats = Floats { u, v, symbols: &[], variant: rounding.variant };
        let singles = Singles { u: u as f32, v: v as f32, variant: rounding.variant };
        let reference = Reference { u: fixed_float(u).unwrap(), v: fixed_float(v).unwrap() };
        let mut doubles = Interpreter::new(&self.rounded, &floats);
        let mut singles = Interpreter::new(&self.rounded, &singles);
        let mut numbers = Interpreter::new(&self.reference, &reference);
        let mut error = |result: Value| {
            let computed = match rounding.precision {
                Precision::Double => {
                    doubles.run(&[result]).ok()?;
                    *doubles.number(result).ok()?
                }
                Precision::Single => {
                    singles.run(&[result]).ok()?;
                    f64::from(*singles.number(result).ok()?)
                }
            };
            numbers.run(&[result]).ok()?;
            let number = numbers.number(result).ok()?.clone();
            Some((magnitude(&(fixed_float(computed)? - &number)), number))
        };
        self.results().into_iter().map(&mut error).collect()
    }

    /// The point of the domain at the fractions `s` and `t` of it, as floats of `precision` within the domain.
    fn point(&self, [s, t]: [f64; 2], precision: Precision) -> [f64; 2] {
        let at = |fraction: f64, [first, last]: &[Rational; 2]| {
            let place = first + (last - first) * exact(fraction).unwrap();
            let near = nearest(&Poly::constant(place)).unwrap();
            let mut near = if precision == Precision::Single { f64::from(near as f32) } else { near };
            let step = |near: f64, up: bool| match (precision, up) {
                (Precision::Double, true) => near.next_up(),
                (Precision::Double, false) => near.next_down(),
                (Precision::Single, true) => f64::from((near as f32).next_up()),
                (Precision::Single, false) => f64::from((near as f32).next_down()),
            };
            while exact(near).unwrap() < *first {
                near = step(near, true);
            }
            while exact(near).unwrap() > *last {
                near = step(near, false);
            }
            near
        };
        [at(s, &self.domain[0]), at(t, &self.domain[1])]
    }

    /// Whether all errors at a point are within the bounds.
    fn holds_at(&self, proof: &Proof, fractions: [f64; 2]) -> bool {
        let point = self.point(fractions, proof.rounding.precision);
        let bounds = self.rounded.outputs().iter().flat_map(|output| proof.output(&output.name));
        bounds.zip(self.errors(proof.rounding, point)).all(|(bound, error)| match (bound, error) {
            (Err(_), _) => true,
            (Ok(_), None) => self.turns_by_zero(proof.rounding, point),
            (Ok(bound), Some(error)) => is_within(bound, &error),
        })
    }
}

impl Subject {
    /// Whether something is turned by what is computed as 0, so that it is no number.
    fn turns_by_zero(&self, rounding: Rounding, [u, v]: [f64; 2]) -> bool {
        let floats = Floats { u, v, symbols: &[], variant: rounding.variant };
        let singles = Singles { u: u as f32, v: v as f32, variant: rounding.variant };
        self.rounded.operations().iter().any(|operation| {
            let Operation::Orient(_, by) = *operation else { return false };
            match rounding.precision {
                Precision::Double => interpret(&self.rounded, &[by], &floats) == Ok(vec![0.0]),
                Precision::Single => interpret(&self.rounded, &[by], &singles) == Ok(vec![0.0]),
            }
        })
    }
}

/// Whether an error, at an exact number, is within a bound.
fn is_within(bound: &ValueBound, (error, number): &(Int, Int)) -> bool {
    let tolerance = Int::ONE.shl(DIGITS - TOLERANCE);
    let fixed = |float: f64| fixed_float(float).unwrap() + &tolerance;
    let relative = bound.relative.is_none_or(|relative| {
        let product = (fixed(relative.factor) * magnitude(number)).shr(DIGITS);
        *error <= product + fixed(relative.underflow)
    });
    let is_in_range = -fixed(-bound.range[0]) <= *number && *number <= fixed(bound.range[1]);
    *error <= fixed(bound.error) && is_in_range && relative
}

/// A sequence of numbers in [0, 1] with some at the ends and very near to 0.
struct Fractions(u64);

impl Fractions {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        let fraction = (self.0 >> 11) as f64 / (1_u64 << 53) as f64;
        match self.0 % 32 {
            0 => 0.0,
            1 => 1.0,
            2 => fraction * 1e-9,
            _ => fraction,
        }
    }

    fn pair(&mut self) -> [f64; 2] {
        [self.next(), self.next()]
    }
}

/// The sweep of a text.
fn sweep(text: &str) -> Subject {
    let (file, _source) = parse_text("sweep", text).unwrap();
    let (models, _) = models(&file);
    let essentials = models[0].surface.as_ref().unwrap().essentials().unwrap();
    let exact = exact_program(&models[0], &essentials).unwrap();
    let domain = essentials
        .domain
        .each_ref()
        .map(|interval| [interval.lower().to_rational().unwrap(), interval.upper().to_rational().unwrap()]);
    Subject::new(&exact, domain)
}

/// Farouki and Nittler's Example 2.
const EXAMPLE_2: &str = "sweep example_2 {
    profile p(u) = (1 - u^2)/(1 + u^2)*i + 2*u/(1 + u^2)*k;
    path s(v) = ph_hermite((0, 0), (0, 4), (2, 2), (4, 0));
    surface R = s + p.x*s.normal + p.z*k;
    domain u in 0..1, v in 0..1;
}";

#[test]
fn bounds_of_example_2_are_tight() {
    const POINTS: usize = 2_000;
    let subject = sweep(EXAMPLE_2);
    let proofs = subject.prove();
    for proof in &proofs {
        let mut found = vec![Int::ZERO; subject.results().len()];
        let mut fractions = Fractions(0x9e37_79b9_7f4a_7c15);
        for _ in 0..POINTS {
            let point = subject.point(fractions.pair(), proof.rounding.precision);
            for (found, error) in found.iter_mut().zip(subject.errors(proof.rounding, point)) {
                *found = error.unwrap().0.max(found.clone());
            }
        }
        let mut found = found.into_iter();
        for output in subject.rounded.outputs() {
            let found = found.by_ref().take(output.values.len()).max().unwrap();
            let bound = proof.error(&output.name).unwrap();
            let found = Rational::new(found, Int::ONE.shl(DIGITS));
            let found = nearest(&Poly::constant(found)).unwrap();
            let unit = 2.0_f64.powi(proof.rounding.precision.unit_exponent());
            println!(
                "{:?} {}: bound {:.2} u, found {:.2} u, {:.2} times; size {:.2}",
                proof.rounding,
                output.name,
                bound / unit,
                found / unit,
                bound / found,
                proof.attained(&output.name)
            );
            let most = match output.name.as_str() {
                outputs::POINT | outputs::SEPARATED_POINT | outputs::PARTIAL_U | outputs::PARTIAL_V => 20.0,
                // Their formulas are longer, and errors of their terms that cancel are not seen to do so.
                _ => 100.0,
            };
            assert!(bound >= found && bound <= most * found, "{}", output.name);
        }
    }
}

/// How a random program goes on: a kind of operation, and the places of its operands counted from the last
/// value.
type Recipe = Vec<(u8, usize, usize, usize)>;

/// A program with constants of all kinds, one of them a multiple of 2^`power`, and the operations of a recipe; its last values are
/// its results.
fn program(recipe: &Recipe, numbers: &[i64], power: i32) -> Program<Poly> {
    let mut program = Program::new();
    let mut values = vec![program.input(Input::U), program.input(Input::V)];
    for (place, &number) in numbers.iter().enumerate() {
        let number = match place % 4 {
            0 => Poly::constant(ratio(number, 7)),
            1 => Poly::sqrt_of(&integer(2)) + Poly::constant(ratio(number, 3)),
            2 => Poly::integer(number),
            _ => {
                let power_of_two = Int::from(1).shl(u64::from(power.unsigned_abs()));
                Poly::constant(match power < 0 {
                    true => Rational::new(Int::from(number), power_of_two),
                    false => Rational::from(Int::from(number) * power_of_two),
                })
            }
        };
        values.push(program.constant(number));
    }
    for &(kind, a, b, c) in recipe {
        let of = |back: usize| values[values.len() - 1 - back % values.len()];
        let (a, b, c) = (of(a), of(b), of(c));
        let value = match kind {
            0 | 1 => program.add(a, b),
            2 => program.subtract(a, b),
            3 | 4 => program.multiply(a, b),
            5 => program.multiply_add(a, b, c),
            6 => program.divide(a, b),
            7 => program.square_root(a),
            8 => program.negate(a),
            9 => program.orient(a, b),
            10 => {
                let squares = [a, b, c].map(|x| program.multiply(x, x));
                let sum = program.add(squares[0], squares[1]);
                let sum = program.add(sum, squares[2]);
                program.square_root(sum)
            }
            _ => {
                let scale = program.scale(a, b, c);
                let direction = [a, b, c].map(|x| program.multiply(x, scale));
                let squares = direction.map(|x| program.multiply(x, x));
                let sum = program.add(squares[0], squares[1]);
                let sum = program.add(sum, squares[2]);
                let norm = program.square_root(sum);
                program.divide(direction[0], norm)
            }
        };
        values.push(value);
    }
    let last = values.len().saturating_sub(4);
    let mut results = values[last..].to_vec();
    results.dedup();
    program.output("results", results);
    program
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Numbers may be near the ends of the range of `f32`, or of `f64`, where they or their squares overflow or underflow.
    #[test]
    fn errors_are_within_bounds(
        recipe in prop::collection::vec((0_u8..12, 0_usize..6, 0_usize..6, 0_usize..6), 1..14),
        numbers in prop::collection::vec(-9_i64..10, 4),
        power in prop::sample::select(vec![-540, -520, -140, -130, -75, -65, 61, 64, 122, 505, 512, 640, 1019]),
        starts in [-3_i64..3, -3_i64..3],
        widths in [1_i64..5, 1_i64..5],
        seed in 1_u64..u64::MAX,
    ) {
        let domain = [0, 1].map(|k| [ratio(starts[k], 3), ratio(starts[k], 3) + ratio(widths[k], 5)]);
        let subject = Subject::new(&program(&recipe, &numbers, power), domain);
        let mut fractions = Fractions(seed);
        for proof in subject.prove() {
            for _ in 0..12 {
                let at = fractions.pair();
                prop_assert!(subject.holds_at(&proof, at), "{} at {at:?} {:?}: {:?}", subject.rounded, proof.rounding, proof.output("results"));
            }
        }
    }
}

/// A program of u and v on a domain.
fn subject(
    build: impl Fn(&mut Program<Poly>, Value, Value) -> Vec<Value>,
    domain: [[Rational; 2]; 2],
) -> Subject {
    let mut program = Program::new();
    let (u, v) = (program.input(Input::U), program.input(Input::V));
    let results = build(&mut program, u, v);
    program.output("results", results);
    Subject::new(&program, domain)
}

fn unit_square() -> [[Rational; 2]; 2] {
    [[integer(0), integer(1)], [integer(0), integer(1)]]
}

fn number(program: &mut Program<Poly>, numerator: i64, denominator: i64) -> Value {
    program.constant(Poly::constant(ratio(numerator, denominator)))
}

#[test]
fn bounds_that_are_too_small_are_exceeded() {
    let subject = sweep(EXAMPLE_2);
    for proof in subject.prove() {
        let mut fractions = Fractions(0x1234_5678_9abc_def1);
        let mut exceeded = 0;
        for _ in 0..200 {
            let at = fractions.pair();
            assert!(subject.holds_at(&proof, at));
            // Half of the largest error that was found with many points is a bound that does not hold.
            let mut small = proof.clone();
            for bound in small.outputs.values_mut().flatten().flatten() {
                bound.error /= 40.0;
                bound.relative = None;
            }
            exceeded += usize::from(!subject.holds_at(&small, at));
        }
        assert!(exceeded > 50, "{exceeded}");
    }
}

#[test]
fn simple_errors_are_known_exactly() {
    let subject = subject(
        |program, u, v| {
            let (two, third) = (number(program, 2, 1), number(program, 1, 3));
            let twice = program.multiply(two, u);
            let product = program.multiply(u, v);
            let difference = program.subtract(u, v);
            let square = program.multiply(u, u);
            let sum = program.multiply_add(u, v, third);
            let opposite = program.negate(product);
            vec![twice, product, difference, square, sum, opposite]
        },
        [[integer(1), integer(2)], [ratio(3, 2), integer(2)]],
    );
    for proof in subject.prove() {
        let unit = 2.0_f64.powi(proof.rounding.precision.unit_exponent());
        let third = if proof.rounding.precision == Precision::Double { 1.0 / 6.0 } else { 1.0 / 3.0 };
        let bounds: Vec<ValueBound> = proof.output("results").iter().map(|bound| bound.unwrap()).collect();
        let errors: Vec<f64> = bounds.iter().map(|bound| bound.error / unit).collect();
        // A product below 4 is rounded by at most 2u; a difference of such numbers is exact; 1/3 is off by
        // 2^-54/3 in f64 and by 2^-25/3 in f32.
        assert_eq!(errors[..4], [0.0, 2.0, 0.0, 2.0]);
        let sum = if proof.rounding.variant == Variant::Fused { 4.0 } else { 6.0 };
        assert!(errors[4] > sum && errors[4] <= sum + third * 1.000_001, "{errors:?}");
        assert_eq!(bounds[5].range, [-4.0, -1.5]);
        assert_eq!((bounds[1].attained, bounds[1].size()), (bounds[1].attained, 4.0));
        assert!(bounds[1].attained > 3.5);
        assert_eq!(bounds[0].relative.unwrap().factor, 0.0);
        assert!(bounds[1].relative.unwrap().factor <= 1.01 * unit);
    }
}

#[test]
fn products_that_vanish_have_relative_errors() {
    // v²·(1 + u/3) vanishes at v = 0, where v² may underflow.
    let subject = subject(
        |program, u, v| {
            let (one, third) = (number(program, 1, 1), number(program, 1, 3));
            let sum = program.multiply_add(third, u, one);
            let square = program.multiply(v, v);
            vec![program.multiply(square, sum)]
        },
        unit_square(),
    );
    for proof in subject.prove() {
        let bound = proof.output("results")[0].unwrap();
        let relative = bound.relative.unwrap();
        let unit = 2.0_f64.powi(proof.rounding.precision.unit_exponent());
        assert!(relative.factor < 4.6 * unit, "{}", relative.factor / unit);
        let least = if proof.rounding.precision == Precision::Double {
            f64::from_bits(1)
        } else {
            2.0_f64.powi(-149)
        };
        assert!(relative.underflow > 0.0 && relative.underflow <= 4.0 * least);
        for tiny in [1e-30, 1e-22, 1e-160, 3e-162, 1e-170, 0.25] {
            assert!(subject.holds_at(&proof, [0.75, tiny]));
        }
    }
}

#[test]
fn what_has_no_bound_says_where() {
    let reason = |subject: &Subject| {
        let failure = subject.prove()[0].output("results")[0].unwrap_err();
        (failure.reason, failure.place, failure.to_string())
    };
    // 1/(u − 1/3)
    let pole = subject(
        |program, u, _| {
            let (one, third) = (number(program, 1, 1), number(program, 1, 3));
            let difference = program.subtract(u, third);
            vec![program.divide(one, difference)]
        },
        unit_square(),
    );
    let (reason_of_pole, [[u0, u1], _], text) = reason(&pole);
    assert_eq!(reason_of_pole, Reason::Denominator);
    assert!(u0 <= 1.0 / 3.0 && 1.0 / 3.0 <= u1 && u1 - u0 < 1e-3, "{text}");
    assert!(text.starts_with("the denominator of %"), "{text}");

    // √(u − v), and u with the sign of u − v
    let domain = unit_square;
    let root = subject(
        |program, u, v| {
            let difference = program.subtract(u, v);
            vec![program.square_root(difference)]
        },
        domain(),
    );
    assert_eq!(reason(&root).0, Reason::Radicand);
    let turned = subject(
        |program, u, v| {
            let (third, difference) = (number(program, 1, 3), program.subtract(u, v));
            let difference = program.subtract(difference, third);
            vec![program.orient(u, difference)]
        },
        domain(),
    );
    assert_eq!(reason(&turned).0, Reason::Sign);
    // 1/(u·(1 − v)) grows at an edge; (1 − v)/(u·(1 − v)) does not, but is 0/0 there.
    for (numerator, expected) in [(false, Reason::Pole), (true, Reason::Denominator)] {
        let grows = subject(
            |program, u, v| {
                let one = number(program, 1, 1);
                let rest = program.subtract(one, v);
                let product = program.multiply(u, rest);
                vec![program.divide(if numerator { rest } else { one }, product)]
            },
            [[ratio(1, 3), integer(1)], [integer(0), integer(1)]],
        );
        let found = reason(&grows);
        assert_eq!(found.0, expected, "{}", found.2);
    }
    // A scale alone depends on its power of two.
    let scaled = subject(
        |program, u, v| {
            let scale = program.scale(u, v, v);
            vec![program.multiply(scale, u)]
        },
        [[integer(1), integer(2)], [integer(1), integer(2)]],
    );
    assert_eq!(reason(&scaled).0, Reason::Scale);
    // u^128 for u up to 2^10 is beyond both formats.
    let large = subject(
        |program, u, _| {
            let mut power = u;
            for _ in 0..7 {
                power = program.multiply(power, power);
            }
            vec![power]
        },
        [[integer(1), integer(1024)], [integer(0), integer(1)]],
    );
    assert_eq!(reason(&large).0, Reason::Overflow);
}

/// A value with the sign of another one has a bound where that one is 0 or has the right sign: at all other points.
#[test]
fn signs_of_differences_are_right() {
    let turned = |build: fn(&mut Program<Poly>, Value, Value) -> Value| {
        let build = |program: &mut Program<Poly>, u: Value, v: Value| {
            let by = build(program, u, v);
            vec![program.orient(u, by)]
        };
        subject(build, unit_square())
    };
    // u − v; (1 − u)·(1 + u)·v; (1 − u)·v³ + v·u/3, whose first term may underflow.
    let differences = turned(|program, u, v| program.subtract(u, v));
    let products = turned(|program, u, v| {
        let one = number(program, 1, 1);
        let (less, more) = (program.subtract(one, u), program.add(one, u));
        let product = program.multiply(less, more);
        program.multiply(product, v)
    });
    let sums = turned(|program, u, v| {
        let (one, third) = (number(program, 1, 1), number(program, 1, 3));
        let (rest, square, part) =
            (program.subtract(one, u), program.multiply(v, v), program.multiply(u, third));
        let (cube, product) = (program.multiply(square, v), program.multiply(part, v));
        program.multiply_add(cube, rest, product)
    });
    let below = 1.0 - 2.0_f64.powi(-24);
    for subject in [differences, products, sums] {
        for proof in subject.prove() {
            assert_eq!(proof.output("results")[0].unwrap().error, 0.0);
            for at in [
                [below, 1.0],
                [1.0, below],
                [below, 1e-40],
                [1.0, 1e-44],
                [0.5, 0.5],
                [1.0, 1.0],
                [0.0, 1e-20],
            ] {
                assert!(subject.holds_at(&proof, at), "{at:?}");
            }
        }
    }
    // 1 − u² is rounded to 0 where it is not 0.
    let rounded = turned(|program, u, _| {
        let (one, square) = (number(program, 1, 1), program.multiply(u, u));
        program.subtract(one, square)
    });
    assert!(rounded.prove().iter().all(|proof| proof.output("results")[0].is_err()));
}

/// Whether an output has a bound, and the reason if it has none.
fn reason_of(subject: &Subject, output: &str) -> Option<Reason> {
    let failures = subject.prove().into_iter().map(|proof| proof.error(output).err());
    failures.map(|failure| failure.map(|failure| failure.reason)).max_by_key(Option::is_some).flatten()
}

/// Bounds hold up to singular points, for all that stays bounded there.
#[test]
fn rotations_have_bounds_up_to_their_axes() {
    let surface = |z: &str| {
        sweep(&format!(
            "sweep s {{ surface R = (u*(1 - v^2)/(1 + v^2), 2*u*v/(1 + v^2), {z}); domain u in 0..1, v in 0..1; }}"
        ))
    };
    let paraboloid = surface("u^2");
    let (near, far) = (2.0_f64.powi(-60), 1.0 - 2.0_f64.powi(-24));
    for proof in paraboloid.prove() {
        for output in [outputs::UNIT_NORMAL, outputs::GAUSSIAN, outputs::PRINCIPAL, outputs::NORMAL_V] {
            let error = proof.error(output).unwrap();
            assert!(
                error < 300.0 * 2.0_f64.powi(proof.rounding.precision.unit_exponent()),
                "{output}: {error:e}"
            );
        }
        for at in [[near, 0.5], [near, 1.0], [1e-30, far], [0.5, 0.25], [0.0, 0.5]] {
            assert!(paraboloid.holds_at(&proof, at), "{at:?}");
        }
    }
    // Of a cone the normal has bounds, and the curvature, which is 0 along its lines, none.
    let cone = surface("2*u");
    assert_eq!(
        [outputs::UNIT_NORMAL, outputs::GAUSSIAN, outputs::NORMAL_V].map(|output| reason_of(&cone, output)),
        [None; 3]
    );
    assert_eq!(
        [outputs::MEAN, outputs::PRINCIPAL].map(|output| reason_of(&cone, output)),
        [Some(Reason::Pole); 2]
    );
}

#[test]
fn spheres_and_planes_have_exact_curvatures() {
    let sphere = sweep(
        "sweep s {
            surface R = (1 + 6*u/(1 + u^2 + v^2), 6*v/(1 + u^2 + v^2), 3*(u^2 + v^2 - 1)/(1 + u^2 + v^2));
            domain u in 0..1, v in 0..1;
        }",
    );
    let plane =
        sweep("sweep s { surface R = (u + v^3, v^3 - u*v, u^2*v + v); domain u in 0..1, v in 0..1; }");
    let flat = sweep("sweep s { surface R = (u + v^3, v^3 - u, 2*u); domain u in 0..1, v in 1..2; }");
    for proof in sphere.prove() {
        // 1/9 and 1/3 are rounded, and nothing else is.
        let unit = 2.0_f64.powi(proof.rounding.precision.unit_exponent());
        assert!(proof.error(outputs::GAUSSIAN).unwrap() <= unit / 9.0);
        assert!(proof.error(outputs::PRINCIPAL).unwrap() <= unit / 3.0);
        assert!(sphere.holds_at(&proof, [0.25, 0.75]));
    }
    for proof in flat.prove() {
        assert_eq!(proof.error(outputs::PRINCIPAL).unwrap(), 0.0);
        assert_eq!(proof.attained(outputs::PRINCIPAL), 0.0);
    }
    assert!(plane.prove()[0].error(outputs::GAUSSIAN).unwrap() > 0.0);
}

/// Next to a singular point, which is a corner, curvatures have full accuracy relative to themselves.
#[test]
fn curvatures_are_accurate_next_to_singular_points() {
    let involute = sweep(
        "sweep s {
            profile p(u) = (1 - u^2)/(1 + u^2)*i + 2*u/(1 + u^2)*k;
            path s(v) = ph_hermite((0, 0), (-2, 0), (0, 1), (2, 0));
            surface R = s.involute - p.x*s.tangent + p.z*k;
            domain u in 0..1, v in 0..1;
        }",
    );
    assert_eq!(reason_of(&involute, outputs::UNIT_NORMAL), None);
    let places: Vec<usize> = {
        let wanted = [outputs::GAUSSIAN, outputs::MEAN];
        let outputs = involute.rounded.outputs().iter();
        outputs
            .flat_map(|output| output.values.iter().map(|_| wanted.contains(&output.name.as_str())))
            .enumerate()
            .filter_map(|(place, wanted)| wanted.then_some(place))
            .collect()
    };
    assert_eq!(places.len(), 2);
    for rounding in Rounding::ALL.into_iter().filter(|rounding| rounding.precision == Precision::Double) {
        for at in
            [[1.0 - 2.0_f64.powi(-52), 0.0], [1.0 - 3.0 * 2.0_f64.powi(-53), 1e-20], [1.0 - 1e-9, 1e-12]]
        {
            let errors = involute.errors(rounding, at);
            for &place in &places {
                let (error, number) = errors[place].clone().unwrap();
                // 2^-46 of the number itself.
                assert!(error.shl(46) < magnitude(&number), "{at:?}");
            }
        }
    }
}

#[test]
fn norms_have_bounds_where_they_vanish() {
    // √((u − v)² + (u + v − 1)²) is 0 at the middle of the square.
    let subject = subject(
        |program, u, v| {
            let one = number(program, 1, 1);
            let (first, sum) = (program.subtract(u, v), program.add(u, v));
            let second = program.subtract(sum, one);
            let squares = [first, second].map(|part| program.multiply(part, part));
            let sum = program.add(squares[0], squares[1]);
            vec![program.square_root(sum)]
        },
        unit_square(),
    );
    let mut fractions = Fractions(77);
    for proof in subject.prove() {
        let unit = 2.0_f64.powi(proof.rounding.precision.unit_exponent());
        let bound = proof.output("results")[0].unwrap();
        assert!(bound.error < 6.0 * unit, "{}", bound.error / unit);
        for _ in 0..100 {
            assert!(subject.holds_at(&proof, fractions.pair()));
        }
        assert!(subject.holds_at(&proof, [0.5, 0.5]));
        assert!(subject.holds_at(&proof, [0.500_000_1, 0.5]));
    }
}

/// √((c·u)² + (c·v)² + (c·u·v)²) for 1 ≤ u, v ≤ 2 and a number c = n·2^`power`.
fn large_norm(power: i32) -> Subject {
    let size = Int::ONE.shl(u64::from(power.unsigned_abs()));
    let size =
        if power < 0 { Rational::new(Int::from(3), size) } else { Rational::from(size * Int::from(3)) };
    subject(
        move |program, u, v| {
            let size = program.constant(Poly::constant(size.clone()));
            let first = program.multiply(size, u);
            let parts = [first, program.multiply(size, v), program.multiply(first, v)];
            let squares = parts.map(|part| program.multiply(part, part));
            let sum = program.add(squares[0], squares[1]);
            let sum = program.add(sum, squares[2]);
            vec![program.square_root(sum), parts[2]]
        },
        [[integer(1), integer(2)], [integer(1), integer(2)]],
    )
}

/// A norm has no bound where the sum of squares overflows, although its parts and the norm itself are in range.
#[test]
fn norms_whose_squares_overflow_have_no_bounds() {
    for (power, overflowing) in
        [(58, &[][..]), (83, &[Precision::Single]), (660, &[Precision::Double, Precision::Single])]
    {
        let subject = large_norm(power);
        for proof in subject.prove() {
            let precision = proof.rounding.precision;
            let [norm, part] = proof.output("results") else { panic!() };
            assert_eq!(part.is_ok(), power < 120 || precision == Precision::Double);
            match norm {
                Ok(_) => assert!(!overflowing.contains(&precision), "{power} {precision:?}"),
                Err(failure) => {
                    assert!(overflowing.contains(&precision), "{power} {precision:?} {failure}");
                    assert_eq!(failure.reason, Reason::Overflow);
                }
            }
            assert!(subject.holds_at(&proof, [0.3, 0.7]));
        }
    }
}

/// What underflow takes from squares is counted: all of them, or their last digits.
#[test]
fn norms_whose_squares_underflow_have_bounds() {
    let mut fractions = Fractions(79);
    for power in [-30, -62, -67, -72, -76, -490, -530, -537, -540, -600] {
        let subject = large_norm(power);
        for proof in subject.prove() {
            let bound = proof.output("results")[0].unwrap();
            let close = bound.error < 1e-4 * bound.attained;
            assert!(close || power < if proof.rounding.precision == Precision::Single { -60 } else { -500 });
            for _ in 0..50 {
                assert!(subject.holds_at(&proof, fractions.pair()), "{power} {:?}", proof.rounding);
            }
        }
    }
}

#[test]
fn unit_vectors_do_not_depend_on_scales() {
    // (a, b, c)·s/|(a, b, c)·s| for a direction with components of very different sizes, and its turned first component.
    let subject = subject(
        |program, u, v| {
            let small = program.constant(Poly::constant(Rational::new(Int::from(3), Int::from(1).shl(90))));
            let (one, third) = (number(program, 1, 1), number(program, 1, 3));
            let first = program.multiply(small, u);
            let second = program.multiply_add(u, v, third);
            let third = program.multiply(first, v);
            let scale = program.scale(first, second, third);
            let direction = [first, second, third].map(|part| program.multiply(part, scale));
            let squares = direction.map(|part| program.multiply(part, part));
            let sum = program.add(squares[0], squares[1]);
            let sum = program.add(sum, squares[2]);
            let norm = program.square_root(sum);
            let inverse = program.divide(one, norm);
            let unit = direction.map(|part| program.multiply(part, inverse));
            let turned = program.orient(unit[1], second);
            [unit.as_slice(), &[turned]].concat()
        },
        unit_square(),
    );
    let mut fractions = Fractions(78);
    for proof in subject.prove() {
        let unit = 2.0_f64.powi(proof.rounding.precision.unit_exponent());
        let bounds: Vec<ValueBound> = proof.output("results").iter().map(|bound| bound.unwrap()).collect();
        assert!(
            bounds[1].error < 10.0 * unit && bounds[3].error == bounds[1].error,
            "{}",
            bounds[1].error / unit
        );
        assert!(bounds[0].error < 1e-20 * unit, "{}", bounds[0].error / unit);
        for _ in 0..100 {
            assert!(subject.holds_at(&proof, fractions.pair()));
        }
    }
}

#[test]
fn symbols_have_no_bounds_but_what_does_not_need_them_has() {
    let mut program = Program::new();
    let (u, symbol) = (program.input(Input::U), program.symbol("c0"));
    let (product, square) = (program.multiply(u, symbol), program.multiply(u, u));
    program.output("results", vec![product, square]);
    let subject = Subject::new(&program, unit_square());
    let proofs = subject.prove();
    assert_eq!(proofs[0].output("results")[0].unwrap_err().reason, Reason::Symbol);
    assert!(proofs[0].output("results")[1].unwrap().error <= 2.0_f64.powi(-54));
}

#[test]
fn programs_that_differ_are_refused() {
    let subject = sweep(EXAMPLE_2);
    let other = Program::new();
    let result = prove(&subject.exact, &other, &subject.domain, &Rounding::ALL);
    assert_eq!(result.unwrap_err(), Misaligned);
    let proof = subject.prove().remove(0);
    assert!(proof.output("nothing").is_empty());
    assert_eq!(proof.error("nothing"), Ok(f64::INFINITY));
}

#[test]
fn poles_within_a_hair_of_the_domain_are_told_from_those_on_it() {
    // 1/(u + v + e)
    let near = |epsilon: Rational| {
        let build = move |program: &mut Program<Poly>, u, v| {
            let (one, epsilon) = (number(program, 1, 1), program.constant(Poly::constant(epsilon.clone())));
            let sum = program.add(u, v);
            let sum = program.add(sum, epsilon);
            vec![program.divide(one, sum)]
        };
        subject(build, unit_square())
    };
    assert!(near(ratio(1, 1000)).prove().iter().all(|proof| proof.output("results")[0].is_ok()));
    assert!(near(integer(0)).prove().iter().all(|proof| proof.output("results")[0].is_err()));
}
