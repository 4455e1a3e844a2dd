//! Interpretation of a program over any arithmetic.

use std::fmt;

use super::{Constant, Input, Operation, Program, Value};

/// The numbers that a program is run over: floats, exact numbers, or polynomials and their fractions.
pub trait Arithmetic<C> {
    /// A number.
    type Number: Clone;

    /// The number that stands for a constant of the program.
    fn constant(&self, constant: &C) -> Self::Number;
    /// The number that stands for a parameter or a symbol.
    fn input(&self, input: Input) -> Self::Number;
    /// a + b
    fn add(&self, a: &Self::Number, b: &Self::Number) -> Self::Number;
    /// a − b
    fn subtract(&self, a: &Self::Number, b: &Self::Number) -> Self::Number;
    /// a · b
    fn multiply(&self, a: &Self::Number, b: &Self::Number) -> Self::Number;
    /// a / b, or `None` where there is no quotient.
    fn divide(&self, a: &Self::Number, b: &Self::Number) -> Option<Self::Number>;
    /// −a
    fn negate(&self, a: &Self::Number) -> Self::Number;
    /// √a, or `None` where the arithmetic has no such root.
    fn square_root(&self, a: &Self::Number) -> Option<Self::Number>;
}

/// The value of a program that an arithmetic could not compute.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Undefined {
    /// The quotient or root.
    pub value: Value,
}

impl fmt::Display for Undefined {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "%{} is a quotient or a root that does not exist", self.value.index())
    }
}

impl std::error::Error for Undefined {}

/// Runs `program` over `arithmetic`, as far as `results` need it, and gives their numbers.
///
/// # Errors
/// [`Undefined`] names the first needed value that the arithmetic does not have.
pub fn interpret<C: Constant, A: Arithmetic<C>>(
    program: &Program<C>,
    results: &[Value],
    arithmetic: &A,
) -> Result<Vec<A::Number>, Undefined> {
    let mut numbers: Vec<Option<A::Number>> = vec![None; program.operations().len()];
    // What is needed is listed after its operands, so each operand has its number already.
    let number = |numbers: &[Option<A::Number>], value: Value| {
        numbers[value.index()].clone().ok_or(Undefined { value })
    };
    for value in program.needed(results) {
        let of = |operand: Value| number(&numbers, operand);
        let undefined = Undefined { value };
        let result = match program.operation(value) {
            Operation::Constant(constant) => arithmetic.constant(constant),
            Operation::Input(input) => arithmetic.input(*input),
            Operation::Add(a, b) => arithmetic.add(&of(*a)?, &of(*b)?),
            Operation::Subtract(a, b) => arithmetic.subtract(&of(*a)?, &of(*b)?),
            Operation::Multiply(a, b) => arithmetic.multiply(&of(*a)?, &of(*b)?),
            Operation::Divide(a, b) => arithmetic.divide(&of(*a)?, &of(*b)?).ok_or(undefined)?,
            Operation::Negate(a) => arithmetic.negate(&of(*a)?),
            Operation::SquareRoot(a) => arithmetic.square_root(&of(*a)?).ok_or(undefined)?,
        };
        numbers[value.index()] = Some(result);
    }
    results.iter().map(|&result| number(&numbers, result)).collect()
}

/// The arithmetic of `f64`, at one point: it computes what emitted code computes, bit for bit.
#[derive(Clone, Copy, Debug)]
pub struct Floats<'a> {
    /// The first parameter.
    pub u: f64,
    /// The second parameter.
    pub v: f64,
    /// The program's symbols, in its order; NaN stands for missing ones.
    pub symbols: &'a [f64],
}

impl Arithmetic<f64> for Floats<'_> {
    type Number = f64;

    fn constant(&self, constant: &f64) -> f64 {
        *constant
    }

    fn input(&self, input: Input) -> f64 {
        match input {
            Input::U => self.u,
            Input::V => self.v,
            Input::Symbol(place) => self.symbols.get(place as usize).copied().unwrap_or(f64::NAN),
        }
    }

    fn add(&self, a: &f64, b: &f64) -> f64 {
        a + b
    }

    fn subtract(&self, a: &f64, b: &f64) -> f64 {
        a - b
    }

    fn multiply(&self, a: &f64, b: &f64) -> f64 {
        a * b
    }

    fn divide(&self, a: &f64, b: &f64) -> Option<f64> {
        Some(a / b)
    }

    fn negate(&self, a: &f64) -> f64 {
        -a
    }

    fn square_root(&self, a: &f64) -> Option<f64> {
        Some(a.sqrt())
    }
}

#[cfg(test)]
mod tests {
    use crate::program::{Floats, Input, Program, interpret};

    #[test]
    fn every_operation_is_run() {
        let mut program = Program::<f64>::new();
        let (u, v, three) = (program.input(Input::U), program.input(Input::V), program.constant(3.0));
        let sum = program.add(u, three);
        let difference = program.subtract(u, v);
        let product = program.multiply(sum, difference);
        let quotient = program.divide(product, v);
        let root = program.square_root(quotient);
        let negative = program.negate(root);
        let numbers = interpret(&program, &[negative, product, u], &Floats { u: 6.0, v: 2.0, symbols: &[] });
        assert_eq!(numbers, Ok(vec![-(18.0_f64.sqrt()), 36.0, 6.0]));
    }
}
