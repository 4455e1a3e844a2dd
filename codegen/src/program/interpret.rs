//! Interpretation of a program over any arithmetic.

use std::collections::BTreeSet;
use std::fmt;

use super::{Constant, Input, Operation, Program, Value, Variant};

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

    /// a · b + c
    fn multiply_add(&self, a: &Self::Number, b: &Self::Number, c: &Self::Number) -> Self::Number {
        self.add(&self.multiply(a, b), c)
    }

    /// a where b > 0, −a where b < 0; `None` where there is neither, or the arithmetic does not know.
    fn orient(&self, a: &Self::Number, b: &Self::Number) -> Option<Self::Number>;

    /// The power of two that brings the largest of |a|, |b| and |c| to between 1 and 2; `None` where there is none, or the
    /// arithmetic does not know.
    fn scale(&self, a: &Self::Number, b: &Self::Number, c: &Self::Number) -> Option<Self::Number>;
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
    let mut interpreter = Interpreter::new(program, arithmetic);
    interpreter.run(results)?;
    results.iter().map(|&result| interpreter.number(result).cloned()).collect()
}

/// A program that is run over an arithmetic part by part: every number is computed once.
///
/// # Example
/// ```
/// use hodograph_codegen::program::{Floats, Input, Interpreter, Program, Variant};
/// let mut program = Program::<f64>::new();
/// let u = program.input(Input::U);
/// let square = program.multiply(u, u);
/// let floats = Floats { u: 3.0, v: 0.0, symbols: &[], variant: Variant::Plain };
/// let mut interpreter = Interpreter::new(&program, &floats);
/// assert_eq!(interpreter.run(&[square]), Ok(()));
/// assert_eq!(interpreter.number(square), Ok(&9.0));
/// ```
#[derive(Clone, Debug)]
pub struct Interpreter<'a, C, A: Arithmetic<C>> {
    program: &'a Program<C>,
    arithmetic: &'a A,
    numbers: Vec<Option<A::Number>>,
}

impl<'a, C: Constant, A: Arithmetic<C>> Interpreter<'a, C, A> {
    /// The interpreter that has computed nothing yet.
    #[must_use]
    pub fn new(program: &'a Program<C>, arithmetic: &'a A) -> Interpreter<'a, C, A> {
        Interpreter { program, arithmetic, numbers: vec![None; program.operations().len()] }
    }

    /// The program.
    #[must_use]
    pub fn program(&self) -> &'a Program<C> {
        self.program
    }

    /// Computes the numbers of `results`, and of what they need, as far as they are not known.
    ///
    /// # Errors
    /// [`Undefined`] names the first needed value that the arithmetic does not have.
    pub fn run(&mut self, results: &[Value]) -> Result<(), Undefined> {
        let mut wanted = BTreeSet::new();
        let mut waiting = results.to_vec();
        while let Some(value) = waiting.pop() {
            if self.numbers[value.index()].is_none() && wanted.insert(value) {
                waiting.extend(self.program.operation(value).operands());
            }
        }
        // Operands are listed before what they are operands of, so each one has its number already.
        for value in wanted {
            let number = self.compute(value)?;
            self.numbers[value.index()] = Some(number);
        }
        Ok(())
    }

    /// The number of a value.
    ///
    /// # Errors
    /// [`Undefined`] if it has not been computed.
    pub fn number(&self, value: Value) -> Result<&A::Number, Undefined> {
        self.numbers[value.index()].as_ref().ok_or(Undefined { value })
    }

    fn compute(&self, value: Value) -> Result<A::Number, Undefined> {
        let of = |operand: Value| self.number(operand);
        let undefined = Undefined { value };
        let arithmetic = self.arithmetic;
        Ok(match self.program.operation(value) {
            Operation::Constant(constant) => arithmetic.constant(constant),
            Operation::Input(input) => arithmetic.input(*input),
            Operation::Add(a, b) => arithmetic.add(of(*a)?, of(*b)?),
            Operation::Subtract(a, b) => arithmetic.subtract(of(*a)?, of(*b)?),
            Operation::Multiply(a, b) => arithmetic.multiply(of(*a)?, of(*b)?),
            Operation::Divide(a, b) => arithmetic.divide(of(*a)?, of(*b)?).ok_or(undefined)?,
            Operation::Negate(a) => arithmetic.negate(of(*a)?),
            Operation::SquareRoot(a) => arithmetic.square_root(of(*a)?).ok_or(undefined)?,
            Operation::MultiplyAdd(a, b, c) => arithmetic.multiply_add(of(*a)?, of(*b)?, of(*c)?),
            Operation::Orient(a, b) => arithmetic.orient(of(*a)?, of(*b)?).ok_or(undefined)?,
            Operation::Scale(a, b, c) => arithmetic.scale(of(*a)?, of(*b)?, of(*c)?).ok_or(undefined)?,
        })
    }
}

/// The arithmetic of `f64`, at one point: it computes what emitted code computes in the same variant, bit for bit.
#[derive(Clone, Copy, Debug)]
pub struct Floats<'a> {
    /// The first parameter.
    pub u: f64,
    /// The second parameter.
    pub v: f64,
    /// The program's symbols, in its order; NaN stands for missing ones.
    pub symbols: &'a [f64],
    /// How a product is added.
    pub variant: Variant,
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
        // NaN for an infinite divisor, as evaluators have it.
        Some(if b.is_infinite() { f64::NAN } else { a / b })
    }

    fn negate(&self, a: &f64) -> f64 {
        -a
    }

    fn square_root(&self, a: &f64) -> Option<f64> {
        Some(a.sqrt())
    }

    fn multiply_add(&self, a: &f64, b: &f64, c: &f64) -> f64 {
        match self.variant {
            Variant::Plain => a * b + c,
            Variant::Fused => a.mul_add(*b, *c),
        }
    }

    fn orient(&self, a: &f64, b: &f64) -> Option<f64> {
        (*b != 0.0 && !b.is_nan()).then_some(if *b < 0.0 { -a } else { *a })
    }

    fn scale(&self, a: &f64, b: &f64, c: &f64) -> Option<f64> {
        let largest = a.abs().max(b.abs()).max(c.abs());
        (largest > 0.0 && largest.is_finite()).then(|| power_of_two_for(largest))
    }
}

/// 2^k with 1 ≤ `size`·2^k < 2, as far as 2^k is a float; `size` is positive and finite.
fn power_of_two_for(size: f64) -> f64 {
    // Subnormal sizes have the least exponent, so that their multiples stay below 2.
    let exponent = (size.to_bits() >> 52).max(1);
    f64::from_bits(2046_u64.saturating_sub(exponent).max(1) << 52)
}

#[cfg(test)]
mod tests {
    use crate::program::{Floats, Input, Program, Variant, interpret};

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
        let numbers = interpret(
            &program,
            &[negative, product, u],
            &Floats { u: 6.0, v: 2.0, symbols: &[], variant: Variant::Plain },
        );
        assert_eq!(numbers, Ok(vec![-(18.0_f64.sqrt()), 36.0, 6.0]));
    }
}
