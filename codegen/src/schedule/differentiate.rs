//! Proof of derivatives without multiplying out: the terms of a derivative are those of the point, differentiated.

use std::collections::{BTreeMap, BTreeSet};

use hodograph_algebra::{Poly, Variable};

use super::check::Fractions;
use super::letters::Letters;
use crate::program::{Arithmetic, Interpreter, Operation, Stage, Term, Value};

/// A program's numbers as fractions of polynomials.
pub(super) type Numbers<'a> = Interpreter<'a, Poly, Fractions>;

/// A fraction of polynomials.
pub(super) type Fraction = (Poly, Poly);

/// The proof of derivatives of a program's values.
pub(super) struct Derivatives<'a> {
    numbers: Numbers<'a>,
    arithmetic: &'a Fractions,
    /// Which values need a division.
    divided: Vec<bool>,
    /// What has been found about sums of products and their derivatives: the same ones occur in several coordinates.
    known: BTreeMap<(Stage, [Vec<Product>; 2]), bool>,
    /// Values that are proved to be the derivatives of others, or of these with the sign changed (`true`).
    slopes: BTreeMap<(Stage, Value), (bool, Value)>,
}

impl<'a> Derivatives<'a> {
    /// For the program of which these `numbers` are known.
    pub(super) fn new(numbers: Numbers<'a>, arithmetic: &'a Fractions) -> Derivatives<'a> {
        let mut divided: Vec<bool> = Vec::new();
        for operation in numbers.program().operations() {
            let inherited = operation.operands().iter().any(|operand| divided[operand.index()]);
            divided.push(inherited || matches!(operation, Operation::Divide(..)));
        }
        Derivatives { numbers, arithmetic, divided, known: BTreeMap::new(), slopes: BTreeMap::new() }
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
        let mut factors = BTreeSet::new();
        for term in terms {
            let (product, other) = Product::of(term, stage);
            factors.extend(other.iter().copied());
            groups.entry(other).or_default()[0].push(product);
        }
        for term in found {
            let (product, other) = Product::of(term, stage);
            match self.parts(&other, &factors) {
                Some(parts) => {
                    for (part, factor) in parts {
                        groups.entry(vec![factor]).or_default()[1].push(product.times(part));
                    }
                }
                None => groups.entry(other).or_default()[1].push(product),
            }
        }
        groups.into_values().all(|group| self.proves_group(group, parameter, stage))
    }

    /// A single value as a sum of products of `factors` and numbers, if it is not one of the factors itself: what no
    /// longer depends on the parameter may have been added to one value.
    fn parts(&self, values: &[Value], factors: &BTreeSet<Value>) -> Option<Vec<(Product, Value)>> {
        let &[value] = values else { return None };
        if factors.contains(&value) {
            return Some(vec![(Product::default(), value)]);
        }
        let program = self.numbers.program();
        let of = |value: Value| self.parts(&[value], factors);
        let times = |parts: Vec<(Product, Value)>, factor: &Product| {
            parts.into_iter().map(|(part, value)| (factor.times(part), value)).collect()
        };
        let minus = Product { negative: true, factors: Vec::new() };
        match *program.operation(value) {
            Operation::Add(a, b) => Some([of(a)?, of(b)?].concat()),
            Operation::Subtract(a, b) => Some([of(a)?, times(of(b)?, &minus)].concat()),
            Operation::Negate(a) => Some(times(of(a)?, &minus)),
            Operation::Multiply(a, b) => {
                let (number, other) = if program.stage(a) <= Stage::Symbols { (a, b) } else { (b, a) };
                let number = (program.stage(number) <= Stage::Symbols).then_some(number)?;
                Some(times(of(other)?, &Product { negative: false, factors: vec![number] }))
            }
            _ => None,
        }
    }

    /// The same for products that have the same factors in the other parameter.
    fn proves_group(&mut self, mut group: [Vec<Product>; 2], parameter: &Variable, stage: Stage) -> bool {
        // Signs are relative to that of the first product.
        if group.iter().flatten().next().is_some_and(|product| product.negative) {
            group.iter_mut().flatten().for_each(|product| product.negative = !product.negative);
        }
        let key = (stage, group);
        if let Some(&known) = self.known.get(&key) {
            return known;
        }
        let group = &key.1;
        let proved = self.by_rules(group, parameter, stage) == Some(true)
            || self.multiplied_out(group, parameter) == Some(true);
        if let ([value], [slope]) = (&*group[0], &*group[1]) {
            // What needs no division is a letter itself.
            if let (true, &[of], &[derivative]) = (proved, &*value.factors, &*slope.factors)
                && self.divided[derivative.index()]
                && !self.needs(of, derivative, stage)
            {
                self.slopes.insert((stage, derivative), (value.negative != slope.negative, of));
            }
        }
        self.known.insert(key, proved);
        proved
    }

    /// Whether one value is computed from another, or is a derivative of one that is: that of a multiple of the parameter is the number
    /// which it is the multiple by, and is no derivative for the rules then.
    fn needs(&self, value: Value, other: Value, stage: Stage) -> bool {
        let mut open = vec![value];
        let mut seen = BTreeSet::new();
        while let Some(value) = open.pop() {
            if value == other {
                return true;
            }
            if self.divided[value.index()] && seen.insert(value) {
                open.extend(self.numbers.program().operation(value).operands());
                open.extend(self.slopes.get(&(stage, value)).map(|(_, of)| *of));
            }
        }
        false
    }

    /// Whether the sum of the derivatives of the first products is the sum of the second ones.
    fn multiplied_out(&mut self, group: &[Vec<Product>; 2], parameter: &Variable) -> Option<bool> {
        let arithmetic = self.arithmetic;
        difference_is_zero(group, arithmetic, &mut MultipliedOut { numbers: &mut self.numbers, parameter })
    }

    /// The same with letters for polynomials; `None` where that tells nothing.
    fn by_rules(&mut self, group: &[Vec<Product>; 2], parameter: &Variable, stage: Stage) -> Option<bool> {
        let mut values = Vec::new();
        for &factor in group.iter().flatten().flat_map(|product| &product.factors) {
            self.collect_letters(factor, stage, &mut values)?;
        }
        self.numbers.run(&values).ok()?;
        let slopes = |value| self.slopes.get(&(stage, value)).copied();
        let mut letters = Letters::new(&self.numbers, self.arithmetic, &values, parameter, &slopes)?;
        difference_is_zero(group, self.arithmetic, &mut letters)
    }

    /// Adds the largest parts of a value that need no division. Denominators must be such. A derivative has the parts
    /// of what it is the derivative of.
    fn collect_letters(&self, value: Value, stage: Stage, values: &mut Vec<Value>) -> Option<()> {
        let operation = self.numbers.program().operation(value);
        match *operation {
            Operation::Constant(_) => {}
            _ if !self.divided[value.index()] => values.extend((!values.contains(&value)).then_some(value)),
            _ if self.slopes.contains_key(&(stage, value)) => {
                let (_, of) = self.slopes[&(stage, value)];
                self.collect_letters(of, stage, values)?;
            }
            Operation::Divide(_, denominator) if self.divided[denominator.index()] => return None,
            _ => operation
                .operands()
                .into_iter()
                .try_for_each(|operand| self.collect_letters(operand, stage, values))?,
        }
        Some(())
    }
}

/// Numbers and factors in one parameter that are multiplied.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Default)]
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

    fn times(&self, other: Product) -> Product {
        let factors = [self.factors.as_slice(), &other.factors].concat();
        Product { negative: self.negative != other.negative, factors }
    }

    /// The product, with a fraction for each factor.
    fn fraction(&self, arithmetic: &Fractions, calculus: &mut impl Calculus) -> Option<Fraction> {
        let mut product = (Poly::one(), Poly::one());
        for &factor in &self.factors {
            product = arithmetic.multiply(&product, &calculus.fraction(factor)?);
        }
        Some(if self.negative { arithmetic.negate(&product) } else { product })
    }
}

/// What values and derivatives are as polynomials, of the parameters or of letters.
pub(super) trait Calculus {
    /// A value as a fraction.
    fn fraction(&mut self, value: Value) -> Option<Fraction>;
    /// The derivative of a polynomial by the parameter.
    fn derivative(&mut self, poly: &Poly) -> Option<Poly>;

    /// (n/d)' = (n'·d − n·d')/d²
    fn derivative_of_fraction(&mut self, (numerator, denominator): &Fraction) -> Option<Fraction> {
        if denominator.is_one() {
            return Some((self.derivative(numerator)?, Poly::one()));
        }
        let change = self.derivative(numerator)? * denominator - numerator * self.derivative(denominator)?;
        Some((change, denominator * denominator))
    }
}

/// Values as fractions of polynomials of the parameters.
struct MultipliedOut<'a, 'b> {
    numbers: &'b mut Numbers<'a>,
    parameter: &'b Variable,
}

impl Calculus for MultipliedOut<'_, '_> {
    fn fraction(&mut self, value: Value) -> Option<Fraction> {
        self.numbers.run(&[value]).ok()?;
        self.numbers.number(value).ok().cloned()
    }

    fn derivative(&mut self, poly: &Poly) -> Option<Poly> {
        Some(poly.derivative(self.parameter))
    }
}

/// Whether Σ terms' − Σ found is zero.
fn difference_is_zero(
    [terms, found]: &[Vec<Product>; 2],
    arithmetic: &Fractions,
    calculus: &mut impl Calculus,
) -> Option<bool> {
    let mut sum = (Poly::zero(), Poly::one());
    for product in terms {
        let fraction = product.fraction(arithmetic, calculus)?;
        sum = arithmetic.add(&sum, &calculus.derivative_of_fraction(&fraction)?);
    }
    for product in found {
        sum = arithmetic.subtract(&sum, &product.fraction(arithmetic, calculus)?);
    }
    Some(sum.0.is_zero())
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
            assert_eq!(proof.by_rules(&group, &u, Stage::U), Some(slope == 2));
            assert_eq!(proof.multiplied_out(&group, &u), Some(slope == 2));
            assert_eq!(proof.proves(found, value, (&u, Stage::U)), slope == 2);
            assert!(!proof.proves(found, value, (&v, Stage::V)));
        }
    }
}
