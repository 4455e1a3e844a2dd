//! Proof of derivatives without multiplying out: the terms of a derivative are those of the point, differentiated.

use std::collections::BTreeMap;

use hodograph_algebra::{Poly, Variable};

use super::check::Fractions;
use crate::program::{Arithmetic, Interpreter, Operation, Program, Stage, Term, Value};

/// A program's numbers as fractions of polynomials.
type Numbers<'a> = Interpreter<'a, Poly, Fractions>;

/// The proof of derivatives of a program's values.
pub(super) struct Derivatives<'a> {
    numbers: Numbers<'a>,
    arithmetic: &'a Fractions,
    /// Which values need a division.
    divided: Vec<bool>,
}

impl<'a> Derivatives<'a> {
    /// For the program of which these `numbers` are known.
    pub(super) fn new(numbers: Numbers<'a>, arithmetic: &'a Fractions) -> Derivatives<'a> {
        let mut divided: Vec<bool> = Vec::new();
        for operation in numbers.program().operations() {
            let inherited = operation.operands().iter().any(|operand| divided[operand.index()]);
            divided.push(inherited || matches!(operation, Operation::Divide(..)));
        }
        Derivatives { numbers, arithmetic, divided }
    }

    /// The numbers that are known by now.
    pub(super) fn numbers(&mut self) -> &mut Numbers<'a> {
        &mut self.numbers
    }

    /// Whether `derivative` is proved to be the derivative of `value` by a parameter, that of `stage`.
    ///
    /// Both are sums of products a(u)·b(v). Products with the same factors in the other parameter are collected, and the
    /// factors in this one compared as rational functions of one parameter: first with letters for their numerators and
    /// denominators, since most derivatives follow from the rules of calculus; else multiplied out. What is proved so
    /// is true; what is not may be so for another reason.
    pub(super) fn proves(
        &mut self,
        derivative: Value,
        value: Value,
        (parameter, stage): (&Variable, Stage),
    ) -> bool {
        let program = self.numbers.program();
        let (Some(found), Some(terms)) = (program.terms(derivative), program.terms(value)) else {
            return false;
        };
        // By the factors in the other parameter the products to be differentiated, then those found.
        let mut groups: BTreeMap<Vec<Value>, [Vec<Product>; 2]> = BTreeMap::new();
        for (place, terms) in [terms, found].into_iter().enumerate() {
            for term in terms {
                let (product, other) = Product::of(term, stage);
                groups.entry(other).or_default()[place].push(product);
            }
        }
        groups.values().all(|group| {
            self.by_rules(group, parameter) == Some(true)
                || self.multiplied_out(group, parameter) == Some(true)
        })
    }

    /// Whether the sum of the derivatives of the first products is the sum of the second ones.
    fn multiplied_out(&mut self, group: &[Vec<Product>; 2], parameter: &Variable) -> Option<bool> {
        let slope = |poly: &Poly| Some(poly.derivative(parameter));
        let mut of = |value: Value| {
            self.numbers.run(&[value]).ok()?;
            self.numbers.number(value).ok().cloned()
        };
        difference_is_zero(group, self.arithmetic, &mut of, slope)
    }

    /// The same with letters for polynomials; `None` where that tells nothing.
    fn by_rules(&mut self, group: &[Vec<Product>; 2], parameter: &Variable) -> Option<bool> {
        let program = self.numbers.program();
        let mut values = Vec::new();
        for &factor in group.iter().flatten().flat_map(|product| &product.factors) {
            self.collect_letters(factor, &mut values)?;
        }
        if values.len() > MOST_LETTERS {
            return None;
        }
        self.numbers.run(&values).ok()?;
        let poly =
            |&value: &Value| self.numbers.number(value).ok().map(|(poly, _)| poly).filter(|p| !p.is_zero());
        let polys: Vec<&Poly> = values.iter().map(poly).collect::<Option<_>>()?;
        let letter = |place| Variable::new(0, &format!("letter{place}"));
        let letters: Vec<Variable> = (0..values.len()).map(letter).collect();
        // The derivative of each letter, if it is a multiple of a letter or a number.
        let slope = |poly: &&Poly| {
            let slope = poly.derivative(parameter);
            if slope.is_constant() {
                return Some(slope);
            }
            let multiple = |(&poly, letter)| Some(slope.number_quotient(poly)? * Poly::variable(letter));
            polys.iter().zip(&letters).find_map(multiple)
        };
        let slopes: Vec<Option<Poly>> = polys.iter().map(slope).collect();
        let differentiate = |poly: &Poly| -> Option<Poly> {
            let mut sum = Poly::zero();
            for (letter, slope) in letters.iter().zip(&slopes).filter(|(letter, _)| poly.contains(letter)) {
                sum += poly.derivative(letter) * slope.as_ref()?;
            }
            Some(sum)
        };
        let arithmetic = self.arithmetic;
        let mut of = |value: Value| {
            in_letters(
                program,
                value,
                &|value| {
                    let place = values.iter().position(|known| *known == value)?;
                    Some((Poly::variable(&letters[place]), Poly::one()))
                },
                arithmetic,
            )
        };
        difference_is_zero(group, arithmetic, &mut of, differentiate)
    }

    /// Adds the largest parts of a value that need no division. Denominators must be such.
    fn collect_letters(&self, value: Value, values: &mut Vec<Value>) -> Option<()> {
        let operation = self.numbers.program().operation(value);
        match *operation {
            Operation::Constant(_) => {}
            _ if !self.divided[value.index()] => values.extend((!values.contains(&value)).then_some(value)),
            Operation::Divide(_, denominator) if self.divided[denominator.index()] => return None,
            _ => operation
                .operands()
                .into_iter()
                .try_for_each(|operand| self.collect_letters(operand, values))?,
        }
        Some(())
    }
}

/// With more letters than this, products are multiplied out.
const MOST_LETTERS: usize = 10;

/// Numbers and factors in one parameter that are multiplied.
struct Product {
    negative: bool,
    factors: Vec<Value>,
}

impl Product {
    /// The part of a term in one parameter and its numbers, and the factors in the other parameter.
    fn of(term: Term, stage: Stage) -> (Product, Vec<Value>) {
        let (own, mut other) = if stage == Stage::U { (term.u, term.v) } else { (term.v, term.u) };
        other.sort();
        (Product { negative: term.negative, factors: [term.numbers, own].concat() }, other)
    }

    /// The product, with a fraction for each factor.
    fn fraction(
        &self,
        arithmetic: &Fractions,
        mut of: impl FnMut(Value) -> Option<(Poly, Poly)>,
    ) -> Option<(Poly, Poly)> {
        let mut product = (Poly::one(), Poly::one());
        for &factor in &self.factors {
            product = arithmetic.multiply(&product, &of(factor)?);
        }
        Some(if self.negative { arithmetic.negate(&product) } else { product })
    }
}

/// Whether Σ terms' − Σ found is zero: `of` gives the fraction of a factor, `slope` the derivative of a polynomial.
fn difference_is_zero(
    [terms, found]: &[Vec<Product>; 2],
    arithmetic: &Fractions,
    of: &mut impl FnMut(Value) -> Option<(Poly, Poly)>,
    slope: impl Fn(&Poly) -> Option<Poly>,
) -> Option<bool> {
    let mut sum = (Poly::zero(), Poly::one());
    for product in terms {
        let (numerator, denominator) = product.fraction(arithmetic, &mut *of)?;
        let change = slope(&numerator)? * &denominator - &numerator * slope(&denominator)?;
        sum = arithmetic.add(&sum, &(change, &denominator * &denominator));
    }
    for product in found {
        sum = arithmetic.subtract(&sum, &product.fraction(arithmetic, &mut *of)?);
    }
    Some(sum.0.is_zero())
}

/// A value as a fraction of polynomials in letters, which stand for some values.
fn in_letters(
    program: &Program<Poly>,
    value: Value,
    letter: &impl Fn(Value) -> Option<(Poly, Poly)>,
    arithmetic: &Fractions,
) -> Option<(Poly, Poly)> {
    if let Some(letter) = letter(value) {
        return Some(letter);
    }
    let of = |value: Value| in_letters(program, value, letter, arithmetic);
    match *program.operation(value) {
        Operation::Constant(ref constant) => Some(arithmetic.constant(constant)),
        Operation::Add(a, b) => Some(arithmetic.add(&of(a)?, &of(b)?)),
        Operation::Subtract(a, b) => Some(arithmetic.subtract(&of(a)?, &of(b)?)),
        Operation::Multiply(a, b) => Some(arithmetic.multiply(&of(a)?, &of(b)?)),
        Operation::Divide(a, b) => arithmetic.divide(&of(a)?, &of(b)?),
        Operation::Negate(a) => Some(arithmetic.negate(&of(a)?)),
        Operation::Input(_) | Operation::SquareRoot(_) => None,
    }
}

#[cfg(test)]
mod tests {
    use hodograph_algebra::{Poly, Variable};

    use super::super::Fractions;
    use super::{Derivatives, Product};
    use crate::program::{Input, Interpreter, Program, Stage, Value};

    /// v·(n/d)(u) for n = u² + 1 and d = u³ + 2, and v·(n' − (n/d)·d')/d with the given factor for n'.
    fn quotient(slope: i64) -> (Program<Poly>, [Value; 4]) {
        let mut program = Program::<Poly>::new();
        let (u, v) = (program.input(Input::U), program.input(Input::V));
        let [one, two, three, slope] = [1, 2, 3, slope].map(|n| program.constant(Poly::integer(n)));
        let square = program.multiply(u, u);
        let cube = program.multiply(square, u);
        let (n, d) = (program.add(square, one), program.add(cube, two));
        let ratio = program.divide(n, d);
        let (n_slope, d_slope) = (program.multiply(slope, u), program.multiply(three, square));
        let change = program.multiply(ratio, d_slope);
        let difference = program.subtract(n_slope, change);
        let derivative = program.divide(difference, d);
        let (value, found) = (program.multiply(ratio, v), program.multiply(derivative, v));
        (program, [ratio, derivative, value, found])
    }

    #[test]
    fn quotients_are_proved_by_rules_and_by_multiplying_out() {
        let (u, v) = (Variable::new(0, "u"), Variable::new(1, "v"));
        let arithmetic = Fractions { u: Poly::variable(&u), v: Poly::variable(&v), symbols: Vec::new() };
        for slope in [2, 5] {
            let (program, [ratio, derivative, value, found]) = quotient(slope);
            let mut proof = Derivatives::new(Interpreter::new(&program, &arithmetic), &arithmetic);
            let product = |factor| vec![Product { negative: false, factors: vec![factor] }];
            let group = [product(ratio), product(derivative)];
            assert_eq!(proof.by_rules(&group, &u), Some(slope == 2));
            assert_eq!(proof.multiplied_out(&group, &u), Some(slope == 2));
            assert_eq!(proof.proves(found, value, (&u, Stage::U)), slope == 2);
            assert!(!proof.proves(found, value, (&v, Stage::V)));
        }
    }
}
