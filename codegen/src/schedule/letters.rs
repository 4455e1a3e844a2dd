//! Polynomials of one parameter as letters, so that the rules of calculus are identities between small polynomials.
//!
//! That (n/d)'' = (n'' − 2·(n/d)'·d' − (n/d)·d'')/d holds for any n and d is seen from polynomials in six letters,
//! whatever n and d are.

use std::collections::BTreeMap;

use hodograph_algebra::{Poly, Variable};

use super::check::Fractions;
use super::differentiate::{Calculus, Fraction, Numbers};
use crate::program::{Arithmetic, Operation, Program, Value};

/// With more letters than this, products are multiplied out.
const MOST: usize = 12;

/// Letters for values that are polynomials, and for their derivatives.
pub(super) struct Letters<'a> {
    program: &'a Program<Poly>,
    arithmetic: &'a Fractions,
    parameter: &'a Variable,
    /// What each letter stands for.
    polys: Vec<Poly>,
    variables: Vec<Variable>,
    places: BTreeMap<Value, usize>,
    /// The value that another one is proved to be the derivative of, with the sign changed where `true`.
    slopes: &'a dyn Fn(Value) -> Option<(bool, Value)>,
}

impl<'a> Letters<'a> {
    /// Letters for `values`, whose numbers are known; `None` if they are too many, or one of them is 0.
    pub(super) fn new(
        numbers: &Numbers<'a>,
        arithmetic: &'a Fractions,
        values: &[Value],
        parameter: &'a Variable,
        slopes: &'a dyn Fn(Value) -> Option<(bool, Value)>,
    ) -> Option<Letters<'a>> {
        let program = numbers.program();
        let (polys, variables, places) = (Vec::new(), Vec::new(), BTreeMap::new());
        let mut letters = Letters { program, arithmetic, parameter, polys, variables, places, slopes };
        for &value in values {
            let poly = numbers.number(value).ok().map(|(poly, _)| poly).filter(|poly| !poly.is_zero())?;
            letters.places.insert(value, letters.polys.len());
            letters.add(poly.clone())?;
        }
        Some(letters)
    }

    /// A new letter.
    fn add(&mut self, poly: Poly) -> Option<()> {
        self.variables.push(Variable::new(0, &format!("letter{}", self.polys.len())));
        self.polys.push(poly);
        (self.polys.len() <= MOST).then_some(())
    }

    /// The derivative of a letter: a number, or a multiple of another letter, which is added where there is none.
    fn slope(&mut self, place: usize) -> Option<Poly> {
        let slope = self.polys[place].derivative(self.parameter);
        if slope.is_constant() {
            return Some(slope);
        }
        let known = self.polys.iter().zip(&self.variables);
        let multiple = known
            .into_iter()
            .find_map(|(poly, letter)| Some(slope.number_quotient(poly)? * Poly::variable(letter)));
        if multiple.is_some() {
            return multiple;
        }
        self.add(slope)?;
        self.variables.last().map(Poly::variable)
    }
}

impl Calculus for Letters<'_> {
    fn fraction(&mut self, value: Value) -> Option<Fraction> {
        if let Some(&place) = self.places.get(&value) {
            return Some((Poly::variable(&self.variables[place]), Poly::one()));
        }
        if let Some((negative, of)) = (self.slopes)(value) {
            let fraction = self.fraction(of)?;
            let (numerator, denominator) = self.derivative_of_fraction(&fraction)?;
            return Some((if negative { -numerator } else { numerator }, denominator));
        }
        let arithmetic = self.arithmetic;
        match *self.program.operation(value) {
            Operation::Constant(ref constant) => Some(arithmetic.constant(constant)),
            Operation::Add(a, b) => Some(arithmetic.add(&self.fraction(a)?, &self.fraction(b)?)),
            Operation::Subtract(a, b) => Some(arithmetic.subtract(&self.fraction(a)?, &self.fraction(b)?)),
            Operation::Multiply(a, b) => Some(arithmetic.multiply(&self.fraction(a)?, &self.fraction(b)?)),
            Operation::Divide(a, b) => arithmetic.divide(&self.fraction(a)?, &self.fraction(b)?),
            Operation::Negate(a) => Some(arithmetic.negate(&self.fraction(a)?)),
            Operation::MultiplyAdd(a, b, c) => {
                Some(arithmetic.multiply_add(&self.fraction(a)?, &self.fraction(b)?, &self.fraction(c)?))
            }
            Operation::Input(_) | Operation::SquareRoot(_) | Operation::Orient(..) | Operation::Scale(..) => {
                None
            }
        }
    }

    fn derivative(&mut self, poly: &Poly) -> Option<Poly> {
        let mut sum = Poly::zero();
        for place in 0..self.variables.len() {
            if poly.contains(&self.variables[place]) {
                let slope = self.slope(place)?;
                sum += poly.derivative(&self.variables[place]) * slope;
            }
        }
        Some(sum)
    }
}
