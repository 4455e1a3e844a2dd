//! Proof of a schedule: its program, run over polynomials, gives back what was derived.

use std::fmt;

use hodograph_algebra::{Poly, Variable, budget};

use super::differentiate::Derivatives;
use super::normal::{self, Parts};
use super::regular::{self, Common};
use super::weingarten::Base;
use super::{Derived, curvature, outputs};
use crate::program::{Arithmetic, Fault, Input, Interpreter, Program, Stage, Value, verify};

/// The arithmetic of fractions of polynomials: a number is a numerator and a denominator.
///
/// With the parameters as variables a program is run symbolically; with numbers for them it is evaluated exactly.
/// Fractions are not reduced, except that equal denominators are added and equal factors divided at once.
///
/// # Example
/// ```
/// use hodograph_algebra::{Poly, ratio};
/// use hodograph_codegen::program::{Input, Program, interpret};
/// use hodograph_codegen::schedule::Fractions;
/// let mut program = Program::<Poly>::new();
/// let (u, v) = (program.input(Input::U), program.input(Input::V));
/// let quotient = program.divide(u, v);
/// let numbers = Fractions { u: Poly::constant(ratio(1, 2)), v: Poly::integer(3), symbols: Vec::new() };
/// let (numerator, denominator) = interpret(&program, &[quotient], &numbers).unwrap().remove(0);
/// assert_eq!(numerator.exact_div(&denominator).unwrap().to_string(), "1/6");
/// ```
#[derive(Clone, Debug)]
pub struct Fractions {
    /// What stands for the first parameter.
    pub u: Poly,
    /// What stands for the second parameter.
    pub v: Poly,
    /// What stands for the program's symbols, in its order; 0 for missing ones.
    pub symbols: Vec<Poly>,
}

impl Fractions {
    fn sum(a: &(Poly, Poly), b: &(Poly, Poly)) -> (Poly, Poly) {
        if a.1 == b.1 {
            return (&a.0 + &b.0, a.1.clone());
        }
        if let Some(factor) = a.1.exact_div(&b.1) {
            return (&a.0 + &(&b.0 * &factor), a.1.clone());
        }
        if let Some(factor) = b.1.exact_div(&a.1) {
            return (&a.0 * &factor + &b.0, b.1.clone());
        }
        (&a.0 * &b.1 + &b.0 * &a.1, &a.1 * &b.1)
    }
}

impl Arithmetic<Poly> for Fractions {
    type Number = (Poly, Poly);

    fn constant(&self, constant: &Poly) -> (Poly, Poly) {
        (constant.clone(), Poly::one())
    }

    fn input(&self, input: Input) -> (Poly, Poly) {
        let value = match input {
            Input::U => self.u.clone(),
            Input::V => self.v.clone(),
            Input::Symbol(place) => self.symbols.get(place as usize).cloned().unwrap_or_else(Poly::zero),
        };
        (value, Poly::one())
    }

    fn add(&self, a: &(Poly, Poly), b: &(Poly, Poly)) -> (Poly, Poly) {
        Fractions::sum(a, b)
    }

    fn subtract(&self, a: &(Poly, Poly), b: &(Poly, Poly)) -> (Poly, Poly) {
        Fractions::sum(a, &self.negate(b))
    }

    fn multiply(&self, a: &(Poly, Poly), b: &(Poly, Poly)) -> (Poly, Poly) {
        (&a.0 * &b.0, &a.1 * &b.1)
    }

    fn divide(&self, a: &(Poly, Poly), b: &(Poly, Poly)) -> Option<(Poly, Poly)> {
        if b.0.is_zero() {
            return None;
        }
        Some((&a.0 * &b.1, &a.1 * &b.0))
    }

    fn negate(&self, a: &(Poly, Poly)) -> (Poly, Poly) {
        (-&a.0, a.1.clone())
    }

    /// Scheduled programs take no square roots, so none is known here.
    fn square_root(&self, _: &(Poly, Poly)) -> Option<(Poly, Poly)> {
        None
    }

    /// The sign of a polynomial is that of no number.
    fn orient(&self, _: &(Poly, Poly), _: &(Poly, Poly)) -> Option<(Poly, Poly)> {
        None
    }

    fn scale(&self, _: &(Poly, Poly), _: &(Poly, Poly), _: &(Poly, Poly)) -> Option<(Poly, Poly)> {
        None
    }
}

/// How a program differs from what it should compute.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum Mismatch {
    /// The program breaks an invariant of all programs.
    Invalid(Fault),
    /// An output is missing, or has not as many results as it should.
    Missing(String),
    /// A result of an output is divided by zero for all parameters.
    Undefined(String),
    /// A result of an output is another function than the derived one.
    Differs {
        /// The output.
        output: String,
        /// The place of the result in it.
        place: usize,
    },
    /// The root of the normal's squared norm is not one.
    Root,
}

impl fmt::Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Mismatch::Invalid(fault) => write!(f, "the program is invalid: {fault}"),
            Mismatch::Missing(output) => write!(f, "the output `{output}` is not there or incomplete"),
            Mismatch::Undefined(output) => write!(f, "the output `{output}` divides by zero"),
            Mismatch::Differs { output, place } => {
                write!(f, "result {place} of the output `{output}` is not what was derived")
            }
            Mismatch::Root => f.write_str("the root of the normal's squared norm is not one"),
        }
    }
}

impl std::error::Error for Mismatch {}

/// Proves that `program` computes the surface `derived`: every output is what it should be.
///
/// - The homogeneous coordinates, all forms of the point, and the conditions are, as rational functions, identical with what
///   was derived.
/// - The first derivatives are derivatives of the separated point, and the second ones derivatives of the first.
/// - The unit normal N/ρ is identical with what was derived; where there is no root ρ, it consists of the operations of the
///   unit vector of a direction that is identical with the derived one or is the vector product of the first derivatives. Where
///   it is turned to one side, the value whose sign decides is identical with the derived factor.
/// - The derivatives of N/ρ or N, and the factor by which R_u × R_v is that, are identical with what was derived.
/// - The forms, curvatures, speeds and derivatives of the normal are the operations of their formulas on those values.
///
/// Constants are exact, so this proves the program before its constants are rounded; rounding then changes constants
/// only.
///
/// # Errors
/// The first [`Mismatch`].
pub fn check(program: &Program<Poly>, derived: &Derived<'_>) -> Result<(), Mismatch> {
    verify(program).map_err(Mismatch::Invalid)?;
    let [u, v] = derived.parameters;
    let [weight, coordinates @ ..] = derived.homogeneous;
    let symbol = |name: &String| Poly::variable(&Variable::new(Variable::SYMBOL, name));
    let symbols = program.symbols().iter().map(symbol).collect();
    let arithmetic = Fractions { u: Poly::variable(u), v: Poly::variable(v), symbols };
    let mut numbers = Interpreter::new(program, &arithmetic);
    let one = Poly::one();
    let mut expected = vec![
        (
            outputs::HOMOGENEOUS,
            over(&derived.homogeneous.each_ref().map(|poly| poly.scale(&derived.scale)), &one),
        ),
        (outputs::POINT, over(coordinates, weight)),
        (outputs::SEPARATED_POINT, over(coordinates, weight)),
    ];
    if !program.results(outputs::ACCURATE_POINT).is_empty() {
        expected.push((outputs::ACCURATE_POINT, over(coordinates, weight)));
    }
    if !derived.conditions.is_empty() {
        expected.push((outputs::CONDITIONS, over(derived.conditions, &one)));
    }
    for (output, fractions) in expected {
        doing(output, || check_values(&mut numbers, output, program.results(output), &fractions))?;
    }
    doing(outputs::UNIT_NORMAL, || check_normal(&mut numbers, derived))?;
    let mut derivatives = Derivatives::new(numbers, &arithmetic);
    let (by_u, by_v) = ((u, Stage::U), (v, Stage::V));
    for (output, of, parameters) in [
        (outputs::PARTIAL_U, outputs::SEPARATED_POINT, &[by_u][..]),
        (outputs::PARTIAL_V, outputs::SEPARATED_POINT, &[by_v]),
        (outputs::PARTIAL_UU, outputs::PARTIAL_U, &[by_u, by_u]),
        (outputs::PARTIAL_UV, outputs::PARTIAL_U, &[by_u, by_v]),
        (outputs::PARTIAL_VV, outputs::PARTIAL_V, &[by_v, by_v]),
    ] {
        doing(output, || {
            let (found, point) = (program.results(output), program.results(of));
            let last = parameters[parameters.len() - 1];
            let mut pairs = found.iter().zip(point);
            let follows = pairs.all(|(&slope, &value)| derivatives.proves(slope, value, last));
            if follows && found.len() == point.len() {
                return Ok(());
            }
            let expected = partial(derived.homogeneous, parameters.iter().map(|(parameter, _)| *parameter));
            check_values(derivatives.numbers(), output, found, &expected)
        })?;
    }
    check_directions(&mut derivatives, derived)?;
    let is_known = !program.results(outputs::DIRECTION_U).is_empty();
    let sphere = if is_known { regular::of_sphere(derived) } else { None };
    let mut compare = |base: Base| {
        check_area(derivatives.numbers(), derived, base)?;
        let mut copy = program.clone();
        let values = curvature::of_patch(&mut copy, base, sphere.as_ref());
        values.iter().try_for_each(|(output, values)| same(output, program.results(output), values))
    };
    // Either of the parameters is the base.
    compare(Base::U).or_else(|mismatch| compare(Base::V).map_err(|_| mismatch))
}

/// Proves the factor of R_u × R_v, and what it is divided by.
fn check_area(
    numbers: &mut Interpreter<'_, Poly, Fractions>,
    derived: &Derived<'_>,
    base: Base,
) -> Result<(), Mismatch> {
    let program = numbers.program();
    let output = outputs::AREA_FACTOR;
    let found = program.results(output);
    if found.is_empty() {
        return Ok(());
    }
    let common = match program.results(outputs::COMMON_FACTOR) {
        [] => None,
        _ => Common::of(derived, base),
    };
    if let Some(Common { factor, partial, square, slope, denominator }) = &common {
        for (output, expected) in [
            (outputs::COMMON_FACTOR, over(std::slice::from_ref(factor), &Poly::one())),
            (outputs::PARTIAL_DIVIDED, over(partial, square)),
            (outputs::DIRECTION_DIVIDED, over(slope, denominator)),
        ] {
            doing(output, || check_values(numbers, output, program.results(output), &expected))?;
        }
    }
    let Some(factor) = normal::area_factor(derived, common.as_ref()) else {
        return Err(Mismatch::Missing(output.to_string()));
    };
    let expected = over(std::slice::from_ref(factor.numerator()), &factor.denominator());
    doing(output, || check_values(numbers, output, found, &expected))
}

/// Proves the derivatives of what the unit normal is made of.
fn check_directions(derivatives: &mut Derivatives<'_>, derived: &Derived<'_>) -> Result<(), Mismatch> {
    let program = derivatives.numbers().program();
    let stages = [Stage::U, Stage::V];
    let outputs = [outputs::DIRECTION_U, outputs::DIRECTION_V];
    let found = outputs.map(|output| program.results(output));
    if found.iter().all(|found| found.is_empty()) {
        return Ok(());
    }
    let (Some(normal), Some(Parts { turned, .. })) = (derived.normal, normal::parts(program)) else {
        return Err(Mismatch::Missing(outputs[0].to_string()));
    };
    for (((output, found), parameter), stage) in
        outputs.into_iter().zip(found).zip(derived.parameters).zip(stages)
    {
        doing(output, || {
            if derived.normal_root.is_some() && found.len() == turned.len() {
                let mut pairs = found.iter().zip(&turned);
                if pairs.all(|(&slope, &value)| derivatives.proves(slope, value, (parameter, stage))) {
                    return Ok(());
                }
            }
            let slope = |n: &Poly| match derived.normal_root {
                Some(root) => (n.derivative(parameter) * root - n * root.derivative(parameter), root * root),
                None => (n.derivative(parameter), Poly::one()),
            };
            check_values(derivatives.numbers(), output, found, &normal.each_ref().map(slope))
        })?;
    }
    Ok(())
}

/// The fractions p/d.
fn over(polys: &[Poly], denominator: &Poly) -> Vec<(Poly, Poly)> {
    polys.iter().map(|poly| (poly.clone(), denominator.clone())).collect()
}

/// The derivatives of X/W, Y/W and Z/W by the parameters in turn: (n/W^k)' = (n'·W − k·n·W')/W^(k+1).
fn partial<'a>(
    [weight, coordinates @ ..]: &[Poly; 4],
    parameters: impl Iterator<Item = &'a Variable> + Clone,
) -> Vec<(Poly, Poly)> {
    let derivative = |coordinate: &Poly| {
        let start = (coordinate.clone(), weight.clone());
        (1..).zip(parameters.clone()).fold(start, |(numerator, denominator), (power, parameter)| {
            let slope = Poly::integer(power) * &numerator * weight.derivative(parameter);
            (numerator.derivative(parameter) * weight - slope, denominator * weight)
        })
    };
    coordinates.iter().map(derivative).collect()
}

/// Proves the unit normal, whose derivatives need no proof before.
fn check_normal(
    numbers: &mut Interpreter<'_, Poly, Fractions>,
    derived: &Derived<'_>,
) -> Result<(), Mismatch> {
    let (program, output) = (numbers.program(), outputs::UNIT_NORMAL);
    let found = program.results(output);
    let parts = normal::parts(program).filter(|_| found.len() == 3);
    let Some(Parts { turned, side, direction }) = parts else {
        return Err(Mismatch::Missing(output.to_string()));
    };
    let one = Poly::one();
    let singular = derived.singular.filter(|_| derived.normal.is_some());
    let sides: Vec<Value> = side.into_iter().collect();
    check_values(
        numbers,
        output,
        &sides,
        &singular.map_or_else(Vec::new, |factor| over(std::slice::from_ref(factor), &one)),
    )?;
    let mut copy = program.clone();
    let direction = match (derived.normal, derived.normal_root, direction) {
        (Some(normal), Some(root), _) => {
            let square: Poly = normal.iter().map(|n| n * n).sum();
            if square != root * root {
                return Err(Mismatch::Root);
            }
            return check_values(numbers, output, &turned, &over(normal, root));
        }
        (Some(normal), None, Some(direction)) => {
            check_values(numbers, output, &direction, &over(normal, &one))?;
            direction.to_vec()
        }
        (None, _, Some(_)) => normal::cross_product(&mut copy),
        (_, _, None) => return Err(Mismatch::Missing(output.to_string())),
    };
    same(output, found, &normal::unit(&mut copy, &direction, side))
}

/// Whether an output has the very values that it should have.
fn same(output: &str, found: &[Value], values: &[Value]) -> Result<(), Mismatch> {
    if found.len() != values.len() {
        return Err(Mismatch::Missing(output.to_string()));
    }
    match found.iter().zip(values).position(|(found, value)| found != value) {
        Some(place) => Err(Mismatch::Differs { output: output.to_string(), place }),
        None => Ok(()),
    }
}

fn doing<T>(output: &str, work: impl FnOnce() -> T) -> T {
    budget::doing(format!("the proof of the evaluator's output `{output}`"), work)
}

/// Whether the results of an output are identical with fractions.
fn check_values(
    numbers: &mut Interpreter<'_, Poly, Fractions>,
    output: &str,
    results: &[Value],
    expected: &[(Poly, Poly)],
) -> Result<(), Mismatch> {
    if results.len() != expected.len() {
        return Err(Mismatch::Missing(output.to_string()));
    }
    let undefined = |_| Mismatch::Undefined(output.to_string());
    numbers.run(results).map_err(undefined)?;
    for (place, (&result, expected)) in results.iter().zip(expected).enumerate() {
        if !equal(numbers.number(result).map_err(undefined)?, expected) {
            return Err(Mismatch::Differs { output: output.to_string(), place });
        }
    }
    Ok(())
}

/// Whether two fractions are equal; where one denominator divides the other, nothing is multiplied out but the quotient.
fn equal(a: &(Poly, Poly), b: &(Poly, Poly)) -> bool {
    if let Some(factor) = b.1.exact_div(&a.1) {
        return &a.0 * &factor == b.0;
    }
    if let Some(factor) = a.1.exact_div(&b.1) {
        return a.0 == &b.0 * &factor;
    }
    &a.0 * &b.1 == &b.0 * &a.1
}
