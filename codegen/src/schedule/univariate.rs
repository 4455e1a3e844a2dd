//! Evaluation of polynomials of one parameter, as operations of a program.

use std::collections::BTreeMap;
use std::hash::{DefaultHasher, Hash, Hasher};

use hodograph_algebra::{Poly, Rational, Variable};

use super::quotient::Quotient;
use super::separate::Parameters;
use crate::program::{Constant, Input, Operation, Program, Stage, Table, Value};
use crate::round::{exact, nearest};

impl Constant for Poly {
    fn is_zero(&self) -> bool {
        Poly::is_zero(self)
    }

    fn is_one(&self) -> bool {
        Poly::is_one(self)
    }

    /// That of a rational number; all others share one, since they may be written in several ways.
    fn fingerprint(&self) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.to_rational().hash(&mut hasher);
        hasher.finish()
    }
}

/// A program under construction, and which polynomials it evaluates already.
pub(super) struct Builder<'a> {
    pub(super) program: Program<Poly>,
    pub(super) parameters: &'a Parameters,
    /// Names for polynomials of one parameter, the sign included.
    pub(super) known: &'a [(String, Poly)],
    /// What has been evaluated, by Horner's scheme or as a product.
    pub(super) evaluated: Vec<(Poly, Value)>,
    /// Denominators that are divided by more than once.
    shared: Vec<Poly>,
    /// For each parameter a place near the middle of its domain, and the distance to the domain's ends.
    centers: [Option<Center>; 2],
    /// How many polynomials of u and of v have been given a name here.
    unnamed: [usize; 2],
    /// Factors of the weight in u and in v, which are likely to be worth having in a basis for other polynomials too; used for
    /// families, where no linear algebra finds such a basis.
    pub(super) hint: Option<(Poly, Poly)>,
    /// Polynomials in symbols alone that are evaluated, by a number that equal ones share.
    pub(super) numbers: BTreeMap<u64, Vec<(Poly, Value)>>,
}

impl<'a> Builder<'a> {
    pub(super) fn new(
        parameters: &'a Parameters,
        known: &'a [(String, Poly)],
        domain: &[[Rational; 2]; 2],
    ) -> Builder<'a> {
        let (program, centers) = (Program::new(), domain.each_ref().map(Center::of));
        Builder {
            centers,
            program,
            parameters,
            known,
            evaluated: Vec::new(),
            shared: Vec::new(),
            unnamed: [0, 0],
            hint: None,
            numbers: BTreeMap::new(),
        }
    }

    /// Evaluates polynomials of one parameter, smaller ones first, so that they serve as factors of larger ones.
    pub(super) fn prepare<'b>(&mut self, polys: impl IntoIterator<Item = &'b Poly>) {
        let mut polys: Vec<&Poly> = polys.into_iter().collect();
        polys.sort_by_key(|poly| {
            self.parameter(poly).map_or(0, |(variable, _)| poly.degree(&variable).unwrap_or(0))
        });
        for poly in polys {
            self.polynomial(poly);
        }
    }

    /// Makes denominators that occur more than once known, so that they are divided by once.
    pub(super) fn share<'b>(&mut self, quotients: impl IntoIterator<Item = &'b Quotient>) {
        let mut seen: Vec<&Quotient> = Vec::new();
        for quotient in quotients {
            if quotient.denominator.is_one() || quotient.is_zero() {
                continue;
            }
            let same = |other: &&Quotient| {
                other.denominator == quotient.denominator
                    && other.numerator != quotient.numerator
                    && other.numerator != -&quotient.numerator
            };
            if seen.iter().any(same) && !self.shared.contains(&quotient.denominator) {
                self.shared.push(quotient.denominator.clone());
            }
            seen.push(quotient);
        }
    }

    /// The value of a quotient of polynomials of one parameter.
    pub(super) fn quotient(&mut self, quotient: &Quotient) -> Value {
        let numerator = self.polynomial(&quotient.numerator);
        if quotient.denominator.is_one() {
            return numerator;
        }
        let denominator = self.polynomial(&quotient.denominator);
        let (negative, magnitude) = self.split_sign(numerator);
        let value = if self.shared.contains(&quotient.denominator) {
            let one = self.program.constant(Poly::one());
            let reciprocal = self.program.divide(one, denominator);
            if let Some(name) = self.program.name_of(denominator) {
                let name = format!("{name}_inverse");
                self.program.name(reciprocal, &name);
            }
            self.program.multiply(magnitude, reciprocal)
        } else {
            self.program.divide(magnitude, denominator)
        };
        if let (Some(above), Some(below)) =
            (self.program.name_of(magnitude), self.program.name_of(denominator))
        {
            let name = format!("{above}_over_{below}");
            self.program.name(value, &name);
        }
        if negative { self.program.negate(value) } else { value }
    }

    /// The value of a polynomial of at most one parameter.
    ///
    /// A multiple of a polynomial that is evaluated already, or a product with one, costs one operation more than that.
    pub(super) fn polynomial(&mut self, poly: &Poly) -> Value {
        let Some((variable, input)) = self.parameter(poly) else {
            return self.number(poly);
        };
        let linear = poly.degree(&variable) <= Some(1);
        let is_sign = |factor: &Poly| factor.is_one() || (-factor).is_one();
        let multiple = |(known, value): &(Poly, Value)| {
            let factor = poly.number_quotient(known)?;
            (!linear || is_sign(&factor)).then_some((factor, *value))
        };
        if let Some((factor, value)) = self.evaluated.iter().find_map(multiple) {
            return self.scaled(&factor, value);
        }
        let named = |(name, known): &'a (String, Poly)| {
            let factor = poly.number_quotient(known)?;
            is_sign(&factor).then_some((name, known, factor.is_one()))
        };
        if let Some((name, known, equal)) = self.known.iter().find_map(named) {
            let value = self.new_polynomial(known, &variable, input, Some(name));
            return if equal { value } else { self.program.negate(value) };
        }
        self.new_polynomial(poly, &variable, input, None)
    }

    /// A sum of products; the terms that are known earliest are added first.
    pub(super) fn sum_of_products(&mut self, products: &[(Value, Value)]) -> Value {
        let mut terms: Vec<(bool, Value)> = products
            .iter()
            .map(|&(a, b)| {
                let ((minus_a, a), (minus_b, b)) = (self.split_sign(a), self.split_sign(b));
                (minus_a != minus_b, self.program.multiply(a, b))
            })
            .collect();
        terms.sort_by_key(|&(negative, value)| (self.program.stage(value), negative));
        let mut terms = terms.into_iter();
        let Some(first) = terms.next() else { return self.program.constant(Poly::zero()) };
        let (negative, sum) = terms.fold(first, |(negative, sum), (minus, term)| match (negative, minus) {
            (false, false) | (true, true) => (negative, self.program.add(sum, term)),
            (false, true) => (false, self.program.subtract(sum, term)),
            (true, false) => (false, self.program.subtract(term, sum)),
        });
        if negative { self.program.negate(sum) } else { sum }
    }

    fn split_sign(&self, value: Value) -> (bool, Value) {
        match *self.program.operation(value) {
            Operation::Negate(a) => (true, a),
            _ => (false, value),
        }
    }

    fn center(&self, input: Input) -> Option<&Center> {
        match input {
            Input::U => self.centers[0].as_ref(),
            Input::V => self.centers[1].as_ref(),
            Input::Symbol(_) => None,
        }
    }

    /// The parameter that occurs in `poly`, if one does.
    fn parameter(&self, poly: &Poly) -> Option<(Variable, Input)> {
        let Parameters { u, v } = self.parameters;
        [(u, Input::U), (v, Input::V)]
            .into_iter()
            .find(|(variable, _)| poly.contains(variable))
            .map(|(variable, input)| (variable.clone(), input))
    }

    fn scaled(&mut self, factor: &Poly, value: Value) -> Value {
        if (-factor).is_one() {
            return self.program.negate(value);
        }
        let factor = self.number(factor);
        self.program.multiply(factor, value)
    }

    fn new_polynomial(
        &mut self,
        poly: &Poly,
        variable: &Variable,
        input: Input,
        name: Option<&str>,
    ) -> Value {
        let degree = |poly: &Poly| poly.degree(variable).unwrap_or(0);
        // Of the factors of the largest degree the last one is taken.
        let mut factors: Vec<(u32, &Poly, Value)> =
            self.evaluated.iter().rev().map(|(factor, value)| (degree(factor), factor, *value)).collect();
        let most = degree(poly);
        factors.retain(|(degree, ..)| (2..=most).contains(degree));
        factors.sort_by_key(|(degree, ..)| std::cmp::Reverse(*degree));
        let mut quotients =
            factors.into_iter().filter_map(|(_, factor, value)| Some((value, poly.exact_div(factor)?)));
        let value = match quotients.next() {
            Some((value, cofactor)) => {
                let cofactor = self.polynomial(&cofactor);
                self.program.multiply(cofactor, value)
            }
            None => match self.component(poly, variable) {
                Some(value) => value,
                None => self.evaluate(poly, variable, input, name),
            },
        };
        if let Some(name) = name {
            self.program.name(value, name);
        }
        self.evaluated.push((poly.clone(), value));
        value
    }

    /// Horner's scheme around zero, or around the middle of the domain where that is more accurate.
    fn evaluate(&mut self, poly: &Poly, variable: &Variable, input: Input, name: Option<&str>) -> Value {
        let parameter = self.program.input(input);
        let center = self.center(input).filter(|center| center.helps(poly, variable));
        let (coefficients, base) = match center.map(|center| center.place.clone()) {
            None => (poly.coefficients(variable), parameter),
            Some(place) => {
                let moved = poly.substitute(variable, &(Poly::variable(variable) + &place));
                let place = self.program.constant(place);
                (moved.coefficients(variable), self.program.subtract(parameter, place))
            }
        };
        let value = self.horner(&coefficients, base);
        self.describe(value, poly, &coefficients, name);
        value
    }

    /// A component of the hodograph of a curve whose preimage a + i·b is known: a² + b², ±(a² − b²) or ±2ab.
    ///
    /// Together σ, x' and y' take 6 operations more than a and b, whose degrees are half of theirs.
    fn component(&mut self, poly: &Poly, variable: &Variable) -> Option<Value> {
        let degree = poly.degree(variable)?;
        let is_half = |half: &&Poly| half.degree(variable).is_some_and(|d| d > 0 && 2 * d == degree);
        let halves: Vec<&Poly> = self.known.iter().map(|(_, half)| half).filter(is_half).collect();
        for (place, &b) in halves.iter().enumerate() {
            for &a in &halves[..place] {
                let (square_a, square_b, twice) = (a * a, b * b, Poly::integer(2) * a * b);
                let (sum, difference) = (&square_a + &square_b, square_a - square_b);
                if ![&sum, &difference, &-&difference, &twice, &-&twice].contains(&poly) {
                    continue;
                }
                let (a, b) = (self.polynomial(a), self.polynomial(b));
                let program = &mut self.program;
                if *poly == twice || -poly == twice {
                    let two = program.constant(Poly::integer(2));
                    let double = program.multiply(two, a);
                    let product = program.multiply(double, b);
                    return Some(if *poly == twice { product } else { program.negate(product) });
                }
                let (square_a, square_b) = (program.multiply(a, a), program.multiply(b, b));
                return Some(match *poly == sum {
                    true => program.add(square_a, square_b),
                    false if *poly == difference => program.subtract(square_a, square_b),
                    false => program.subtract(square_b, square_a),
                });
            }
        }
        None
    }

    /// Horner's scheme for coefficients of powers of `parameter`, in the greatest power of the parameter that the polynomial is a polynomial of, after its least
    /// power is taken out.
    fn horner(&mut self, coefficients: &[Poly], parameter: Value) -> Value {
        let lowest = coefficients.iter().position(|c| !c.is_zero()).unwrap_or(0);
        let coefficients = &coefficients[lowest..];
        let even = |step: &usize| {
            coefficients.iter().enumerate().all(|(i, c)| i.is_multiple_of(*step) || c.is_zero())
        };
        let step = (1..=coefficients.len()).rev().find(even).unwrap_or(1);
        let base = self.power(parameter, step);
        let mut sum = self.program.constant(Poly::zero());
        for coefficient in coefficients.iter().step_by(step).rev() {
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
        if lowest == 0 {
            return sum;
        }
        let power = self.power(parameter, lowest);
        self.program.multiply(sum, power)
    }

    /// `base` to a positive power, by squaring.
    fn power(&mut self, base: Value, exponent: usize) -> Value {
        if exponent <= 1 {
            return base;
        }
        let half = self.power(base, exponent / 2);
        let square = self.program.multiply(half, half);
        if exponent.is_multiple_of(2) { square } else { self.program.multiply(square, base) }
    }

    /// Names the value of a polynomial that has a degree above 1, and keeps its coefficients together.
    fn describe(&mut self, value: Value, poly: &Poly, coefficients: &[Poly], name: Option<&str>) {
        if coefficients.len() < 3 {
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
        let coefficients = coefficients.iter().map(|coefficient| self.number(coefficient)).collect();
        self.program.table(Table { value, name, formula: poly.to_string(), coefficients });
    }
}

/// A place near the middle of a parameter's domain; polynomials on a domain far from zero are evaluated around it.
struct Center {
    /// A number with a short binary expansion, so that it is exact as a float.
    place: Poly,
    /// The largest distance to a point of the domain.
    reach: f64,
    /// The largest magnitude of a point of the domain.
    magnitude: f64,
}

impl Center {
    /// How many times smaller the terms around the center must be, to be worth an operation and simple coefficients.
    const GAIN: f64 = 8.0;

    /// The center of a domain; `None` if it has none with an exact float.
    fn of([first, last]: &[Rational; 2]) -> Option<Center> {
        let float = |value: &Rational| nearest(&Poly::constant(value.clone())).ok();
        let (start, end) = (float(first)?, float(last)?);
        // The place is a multiple of a power of two of the size of a quarter of the domain.
        let step = f64::from_bits(((end - start) / 4.0).to_bits() & !((1 << 52) - 1));
        let place = ((start / 2.0 + end / 2.0) / step).round() * step;
        let (reach, magnitude) = ((end - place).max(place - start), start.abs().max(end.abs()));
        let exact = exact(place)?;
        (step > 0.0 && reach.is_finite()).then(|| Center { place: Poly::constant(exact), reach, magnitude })
    }

    /// Whether the rounding errors of Horner's scheme are much smaller around the center than around zero.
    ///
    /// The errors are in proportion to Σ|c_i|·r^i for the largest distance r.
    fn helps(&self, poly: &Poly, variable: &Variable) -> bool {
        let moved = poly.substitute(variable, &(Poly::variable(variable) + &self.place));
        match (terms(poly, variable, self.magnitude), terms(&moved, variable, self.reach)) {
            (Some(here), Some(there)) => here > Center::GAIN * there,
            _ => false,
        }
    }
}

/// Σ|c_i|·r^i
fn terms(poly: &Poly, variable: &Variable, r: f64) -> Option<f64> {
    let coefficients = poly.coefficients(variable);
    coefficients
        .iter()
        .rev()
        .try_fold(0.0, |sum, coefficient| Some(sum * r + nearest(coefficient).ok()?.abs()))
}
