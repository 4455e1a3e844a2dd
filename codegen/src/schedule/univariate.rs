//! Evaluation of polynomials of one parameter, as operations of a program.

use std::collections::{BTreeMap, BTreeSet};
use std::hash::{DefaultHasher, Hash, Hasher};

use hodograph_algebra::{Poly, Rational, Variable};

use super::forms::{Preference, Range};
use super::quotient::Quotient;
use super::separate::Parameters;
use super::vector::split_sign;
use crate::program::{Constant, Input, Program, Value};

impl Constant for Poly {
    fn is_zero(&self) -> bool {
        Poly::is_zero(self)
    }

    fn is_one(&self) -> bool {
        Poly::is_one(self)
    }

    fn negated(&self) -> Poly {
        -self
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
    /// Polynomials whose inverses are known, with these.
    inverses: Vec<(Poly, Value)>,
    /// The domains of the parameters.
    pub(super) ranges: [Option<Range>; 2],
    /// How polynomials of one parameter are evaluated.
    pub(super) preference: Preference,
    /// How many polynomials of u and of v have been given a name here.
    pub(super) unnamed: [usize; 2],
    /// The values of polynomials that are written out by their coefficients.
    pub(super) written: BTreeSet<Value>,
    /// Factors of the weight in u and in v, which are likely to be worth having in a basis for other polynomials too;
    /// used for families, where no linear algebra finds such a basis.
    pub(super) hint: Option<(Poly, Poly)>,
    /// Whether polynomials are evaluated so that they are accurate near roots at the ends of the domain.
    pub(super) is_careful: bool,
    /// Polynomials in symbols alone that are evaluated, by a number that equal ones share.
    pub(super) numbers: BTreeMap<u64, Vec<(Poly, Value)>>,
}

impl<'a> Builder<'a> {
    pub(super) fn new(
        parameters: &'a Parameters,
        known: &'a [(String, Poly)],
        domain: &[[Rational; 2]; 2],
        preference: Preference,
    ) -> Builder<'a> {
        Builder {
            ranges: domain.each_ref().map(|ends| Range::of(ends, preference)),
            preference,
            written: BTreeSet::new(),
            program: Program::new(),
            parameters,
            known,
            evaluated: Vec::new(),
            shared: Vec::new(),
            inverses: Vec::new(),
            unnamed: [0, 0],
            hint: None,
            is_careful: false,
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
            if seen.iter().any(same) {
                self.share_denominator(&quotient.denominator);
            }
            seen.push(quotient);
        }
    }

    /// Makes a denominator known, so that it is divided by once.
    pub(super) fn share_denominator(&mut self, denominator: &Poly) {
        if !self.shared.contains(denominator) {
            self.shared.push(denominator.clone());
        }
    }

    /// The value of a quotient of polynomials of one parameter.
    pub(super) fn quotient(&mut self, quotient: &Quotient) -> Value {
        let numerator = self.polynomial(&quotient.numerator);
        if quotient.denominator.is_one() || quotient.is_zero() {
            return numerator;
        }
        let (negative, magnitude) = split_sign(&self.program, numerator);
        let value = if self.shared.contains(&quotient.denominator) {
            let inverse = self.inverse(&quotient.denominator);
            self.program.multiply(magnitude, inverse)
        } else {
            let denominator = self.polynomial(&quotient.denominator);
            self.program.divide(magnitude, denominator)
        };
        let denominator = self.evaluated.iter().find(|(known, _)| *known == quotient.denominator);
        let below = denominator.and_then(|(_, value)| self.program.name_of(*value));
        if let (Some(above), Some(below)) = (self.program.name_of(magnitude), below) {
            let name = format!("{above}_over_{below}");
            self.program.name(value, &name);
        }
        if negative { self.program.negate(value) } else { value }
    }

    /// The inverse of a polynomial of one parameter: a product of such inverses where these are known, else by a
    /// division.
    pub(super) fn inverse(&mut self, poly: &Poly) -> Value {
        if let Some((_, value)) = self.inverses.iter().find(|(known, _)| known == poly) {
            return *value;
        }
        let known = self.inverses.iter().rev().find_map(|(factor, value)| {
            let cofactor = poly.exact_div(factor)?;
            let (_, other) = self.inverses.iter().find(|(known, _)| *known == cofactor)?;
            Some((*value, *other))
        });
        let value = match known {
            Some((factor, cofactor)) => self.program.multiply(factor, cofactor),
            None => {
                let (one, value) = (self.program.constant(Poly::one()), self.polynomial(poly));
                let inverse = self.program.divide(one, value);
                if let Some(name) = self.program.name_of(value) {
                    let name = format!("{name}_inverse");
                    self.program.name(inverse, &name);
                }
                inverse
            }
        };
        self.inverses.push((poly.clone(), value));
        value
    }

    /// The value of a polynomial of at most one parameter.
    ///
    /// A multiple of a polynomial that is evaluated already, or a product with one, costs one operation more than that.
    pub(super) fn polynomial(&mut self, poly: &Poly) -> Value {
        let Some((variable, input)) = self.parameter(poly) else {
            return self.number(poly);
        };
        if self.is_careful
            && let Some(value) = self.with_roots(poly, input)
        {
            return value;
        }
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
                let ((minus_a, a), (minus_b, b)) =
                    (split_sign(&self.program, a), split_sign(&self.program, b));
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
}
