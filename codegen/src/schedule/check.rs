//! Proof of a schedule: its program, run over polynomials, gives back what was derived.

use std::fmt;

use hodograph_algebra::{Poly, Variable, budget};

use super::differentiate::Derivatives;
use super::{Derived, outputs};
use crate::program::{Arithmetic, Fault, Input, Interpreter, Program, Stage, verify};

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

/// Proves that `program` computes the surface `derived`: every output, as a rational function, is identical with it.
///
/// Constants are exact, so this proves the program before its constants are rounded; rounding then changes constants only.
///
/// # Errors
/// The first [`Mismatch`].
pub fn check(program: &Program<Poly>, derived: &Derived<'_>) -> Result<(), Mismatch> {
    verify(program).map_err(Mismatch::Invalid)?;
    let [u, v] = derived.parameters;
    let [weight, coordinates @ ..] = derived.homogeneous;
    let one = Poly::one();
    let over = |polys: &[Poly], denominator: &Poly| -> Vec<(Poly, Poly)> {
        polys.iter().map(|poly| (poly.clone(), denominator.clone())).collect()
    };
    let partial = |variable| -> Vec<(Poly, Poly)> {
        let slope = weight.derivative(variable);
        let numerator = |x: &Poly| x.derivative(variable) * weight - x * &slope;
        coordinates.iter().map(|x| (numerator(x), weight * weight)).collect()
    };
    let mut expected = vec![
        (outputs::HOMOGENEOUS, over(derived.homogeneous, &one)),
        (outputs::POINT, over(coordinates, weight)),
    ];
    let crossed = program.results(outputs::CROSS_PRODUCT);
    let normal = derived.normal.map_or(&[][..], |normal| normal.as_slice());
    match derived.normal_root {
        // The derivatives are proved; their product is built once more, which gives the same values.
        _ if !crossed.is_empty() => {
            let mut copy = program.clone();
            super::schedule_cross_product(&mut copy);
            let last = copy.outputs().last().map(|output| output.values.as_slice());
            if last != Some(crossed) {
                return Err(Mismatch::Differs { output: outputs::CROSS_PRODUCT.to_string(), place: 0 });
            }
        }
        None => expected.push((outputs::NORMAL_DIRECTION, over(normal, &one))),
        Some(root) => {
            let square: Poly = normal.iter().map(|n| n * n).sum();
            if square != root * root {
                return Err(Mismatch::Root);
            }
            expected.push((outputs::UNIT_NORMAL, over(normal, root)));
        }
    }
    if let Some(singular) = derived.singular.filter(|_| crossed.is_empty()) {
        expected.push((outputs::SINGULAR, over(std::slice::from_ref(singular), &one)));
    }
    if !derived.conditions.is_empty() {
        expected.push((outputs::CONDITIONS, over(derived.conditions, &one)));
    }
    let symbol = |name: &String| Poly::variable(&Variable::new(Variable::SYMBOL, name));
    let symbols = program.symbols().iter().map(symbol).collect();
    let arithmetic = Fractions { u: Poly::variable(u), v: Poly::variable(v), symbols };
    let mut numbers = Interpreter::new(program, &arithmetic);
    for (output, fractions) in expected {
        doing(output, || check_output(&mut numbers, output, &fractions))?;
    }
    // The point is proved now; most derivatives follow from it, term by term.
    let point = program.results(outputs::POINT);
    let mut derivatives = Derivatives::new(numbers, &arithmetic);
    for (output, variable, stage) in [(outputs::PARTIAL_U, u, Stage::U), (outputs::PARTIAL_V, v, Stage::V)] {
        let found = program.results(output);
        doing(output, || {
            let mut pairs = found.iter().zip(point);
            let follows = pairs.all(|(&slope, &value)| derivatives.proves(slope, value, (variable, stage)));
            if follows && found.len() == point.len() {
                return Ok(());
            }
            check_output(derivatives.numbers(), output, &partial(variable))
        })?;
    }
    Ok(())
}

fn doing<T>(output: &str, work: impl FnOnce() -> T) -> T {
    budget::doing(format!("the proof of the evaluator's output `{output}`"), work)
}

fn check_output(
    numbers: &mut Interpreter<'_, Poly, Fractions>,
    output: &str,
    expected: &[(Poly, Poly)],
) -> Result<(), Mismatch> {
    let results = numbers.program().results(output);
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
