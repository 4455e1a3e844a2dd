//! Polynomials of one parameter by their coefficients: Horner's and Estrin's scheme, and the Bernstein basis.

use hodograph_algebra::{Poly, Variable};

use super::forms::{Choice, Range, Scheme, Sparsity, choose, levels, unscaled_net};
use super::univariate::Builder;
use crate::program::{Input, Operation, Stage, Table, Value};
use crate::round::{exact, nearest};

impl Builder<'_> {
    /// The value of a polynomial of one parameter by the scheme that is preferred for it.
    pub(super) fn evaluate(
        &mut self,
        poly: &Poly,
        variable: &Variable,
        input: Input,
        name: Option<&str>,
    ) -> Value {
        let choice = choose(poly, variable, self.range(input), self.preference);
        let value = match choice.scheme {
            Scheme::Bernstein => self.in_bernstein_basis(poly, variable, input),
            Scheme::Horner | Scheme::Estrin => None,
        };
        let value = match value {
            Some(value) => {
                self.describe(value, poly, None, name);
                value
            }
            None => self.in_powers(poly, variable, input, (choice, name)),
        };
        self.written.insert(value);
        value
    }

    pub(super) fn range(&self, input: Input) -> Option<&Range> {
        match input {
            Input::U => self.ranges[0].as_ref(),
            Input::V => self.ranges[1].as_ref(),
            Input::Symbol(_) => None,
        }
    }

    fn in_powers(
        &mut self,
        poly: &Poly,
        variable: &Variable,
        input: Input,
        (choice, name): (Choice, Option<&str>),
    ) -> Value {
        let parameter = self.program.input(input);
        let center = self.range(input).filter(|_| choice.centered).map(|range| range.center.clone());
        let (coefficients, base) = match center {
            None => (poly.coefficients(variable), parameter),
            Some(place) => {
                let moved = poly.substitute(variable, &(Poly::variable(variable) + &place));
                let place = self.program.constant(place);
                (moved.coefficients(variable), self.program.subtract(parameter, place))
            }
        };
        let Sparsity { lowest, step } = Sparsity::of(&coefficients);
        let power = self.power(base, step);
        let every: Vec<&Poly> = coefficients[lowest..].iter().step_by(step).collect();
        let sum = match choice.scheme {
            Scheme::Estrin => self.estrin(&every, power),
            Scheme::Horner | Scheme::Bernstein => self.horner(&every, power),
        };
        let value = if lowest == 0 {
            sum
        } else {
            let factor = self.power(base, lowest);
            self.program.multiply(sum, factor)
        };
        self.describe(value, poly, Some(&coefficients), name);
        value
    }

    /// c_0 + x·(c_1 + x·(c_2 + …))
    fn horner(&mut self, coefficients: &[&Poly], base: Value) -> Value {
        let mut sum = self.program.constant(Poly::zero());
        for coefficient in coefficients.iter().rev() {
            let constant = self.number(coefficient);
            sum = match self.program.operation(sum) {
                // The leading coefficient −1 is a subtraction.
                Operation::Constant(leading) if (-leading).is_one() => self.program.subtract(constant, base),
                _ => {
                    let product = self.program.multiply(sum, base);
                    self.program.add(product, constant)
                }
            };
        }
        sum
    }

    /// The first half of the coefficients, and the second one times a power of x, both by the same scheme.
    fn estrin(&mut self, coefficients: &[&Poly], base: Value) -> Value {
        if coefficients.len() <= 2 {
            return self.horner(coefficients, base);
        }
        let half = 1 << (levels(coefficients.len()) - 1);
        let (low, high) = coefficients.split_at(half);
        let (low, high) = (self.estrin(low, base), self.estrin(high, base));
        let power = self.power(base, half);
        let product = self.program.multiply(high, power);
        self.program.add(product, low)
    }

    /// Σ_j β_j·t^j·s^(n−j); `None` if the parameter has no domain between floats.
    fn in_bernstein_basis(&mut self, poly: &Poly, variable: &Variable, input: Input) -> Option<Value> {
        let degree = poly.degree(variable)?;
        let coefficients = unscaled_net(poly, &[(variable.clone(), self.range(input)?, degree)])?;
        let basis = self.bernstein_basis(input, degree as usize)?;
        let numbers: Vec<Value> = coefficients.iter().map(|coefficient| self.number(coefficient)).collect();
        let products: Vec<(Value, Value)> = numbers.into_iter().zip(basis).collect();
        Some(self.sum_of_nonzero_products(&products))
    }

    /// The products t^j·s^(n−j), j = 0, …, n, of t = x − a and s = b − x on the domain from a to b, where none is
    /// negative.
    pub(super) fn bernstein_basis(&mut self, input: Input, degree: usize) -> Option<Vec<Value>> {
        let [start, end] = self.range(input)?.ends().clone();
        let parameter = self.program.input(input);
        let (t, s) = (self.distance(parameter, &start, true), self.distance(parameter, &end, false));
        let product = |builder: &mut Self, j: usize| match j {
            0 => builder.power(s, degree),
            _ if j == degree => builder.power(t, degree),
            _ => {
                let (left, right) = (builder.power(t, j), builder.power(s, degree - j));
                builder.program.multiply(left, right)
            }
        };
        if degree == 0 {
            return Some(vec![self.program.constant(Poly::one())]);
        }
        Some((0..=degree).map(|j| product(self, j)).collect())
    }

    /// The distance of a parameter from a number, which is below it or above it.
    ///
    /// A number that is no float of single precision is taken in parts: the nearest such float, what the nearest float of double precision
    /// has besides, and the rest. Near the number the difference from the first part is exact, and the others make up for what that
    /// lacks, so that the error is of the size of the distance in both precisions.
    pub(super) fn distance(&mut self, parameter: Value, number: &Poly, is_below: bool) -> Value {
        let mut distance = None;
        for part in parts(number) {
            let part = self.program.constant(part);
            distance = Some(match (distance, is_below) {
                (None, true) => self.program.subtract(parameter, part),
                (None, false) => self.program.subtract(part, parameter),
                (Some(distance), true) => self.program.subtract(distance, part),
                (Some(distance), false) => self.program.add(distance, part),
            });
        }
        distance.unwrap_or(parameter)
    }

    /// `base` to a positive power, by squaring.
    pub(super) fn power(&mut self, base: Value, exponent: usize) -> Value {
        if exponent <= 1 {
            return base;
        }
        let half = self.power(base, exponent / 2);
        let square = self.program.multiply(half, half);
        if exponent.is_multiple_of(2) { square } else { self.program.multiply(square, base) }
    }

    /// Names the value of a polynomial that has a degree above 1, and keeps its coefficients of powers together.
    fn describe(&mut self, value: Value, poly: &Poly, coefficients: Option<&[Poly]>, name: Option<&str>) {
        if coefficients.is_some_and(|coefficients| coefficients.len() < 3) {
            return;
        }
        let name = name.map_or_else(
            || {
                let of_u = self.program.stage(value) == Stage::U;
                let count = &mut self.unnamed[usize::from(!of_u)];
                *count += 1;
                format!("{}{count}", if of_u { 'p' } else { 'q' })
            },
            str::to_string,
        );
        self.program.name(value, &name);
        if let Some(coefficients) = coefficients {
            let coefficients = coefficients.iter().map(|coefficient| self.number(coefficient)).collect();
            self.program.table(Table { value, name, formula: poly.to_string(), coefficients });
        }
    }
}

/// A number as the sum of the nearest float of single precision, what the nearest one of double precision has besides, and the rest, as
/// far as they are not zero.
#[allow(clippy::cast_possible_truncation)]
fn parts(number: &Poly) -> Vec<Poly> {
    let float = nearest(number).ok();
    let of = |float: f64| exact(float).map(Poly::constant);
    let (Some(single), Some(double)) =
        (float.and_then(|float| of((float as f32).into())), float.and_then(of))
    else {
        return vec![number.clone()];
    };
    let parts = [single.clone(), &double - &single, number - &double];
    let mut parts: Vec<Poly> = parts
        .into_iter()
        .enumerate()
        .filter(|(place, part)| *place == 0 || !part.is_zero())
        .map(|(_, part)| part)
        .collect();
    if parts[0].is_zero() && parts.len() > 1 {
        parts.remove(0);
    }
    parts
}
