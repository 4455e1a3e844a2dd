//! Derivatives of quotients of one parameter, reduced or by the rules of calculus.

use hodograph_algebra::{Poly, Variable};

use super::forms::Sparsity;
use super::quotient::Quotient;
use super::univariate::Builder;
use super::vector::{is_zero, sum_of};
use crate::program::{Operation, Stage, Value};

/// The number of products of terms up to which a derivative is reduced, and of terms up to which it is written out:
/// so large that the derivatives along PH quintics are reduced, and so small that Horner's scheme costs no more than
/// the rules.
const LARGE_PRODUCT: usize = 2000;
const LARGE: usize = 150;

impl Builder<'_> {
    /// The first and the second derivatives of quotients by a parameter.
    ///
    /// A small first derivative is reduced, since a common factor leaves little of it: (y'/σ)' = 2 Im(w̄w')·x'/σ². A
    /// large one is computed from the values of n, d and their derivatives, by the rules for products and sums:
    /// (n/d)' = (n' − (n/d)·d')/d. For second derivatives there are both ways too: of the numerator n₁ of a reduced
    /// first derivative n₁/d² is (n₁/d²)' = (n₁'·d − 2·n₁·d')/d³, and by the rules (n/d)'' = (n'' − 2·(n/d)'·d' −
    /// (n/d)·d'')/d. What takes fewer operations is done for all quotients of one denominator.
    pub(super) fn slopes(
        &mut self,
        quotients: &[Quotient],
        parameter: &Variable,
        preferred: &[Poly],
    ) -> [Vec<Value>; 2] {
        let (first, reduced) = self.first_slopes(quotients, parameter, preferred);
        let second = self.second(quotients, &reduced, &first, parameter);
        [first, second]
    }

    /// The first derivatives alone, with those that are reduced.
    pub(super) fn first_slopes(
        &mut self,
        quotients: &[Quotient],
        parameter: &Variable,
        preferred: &[Poly],
    ) -> (Vec<Value>, Vec<Option<Quotient>>) {
        let reduced: Vec<Option<Quotient>> = quotients
            .iter()
            .map(|quotient| {
                let (n, d) = (quotient.numerator.terms().len(), quotient.denominator.terms().len());
                let derivative =
                    (n.saturating_mul(d) <= LARGE_PRODUCT).then(|| quotient.derivative(parameter, preferred));
                derivative.filter(|derivative| derivative.numerator.terms().len() <= LARGE)
            })
            .collect();
        let denominators =
            || quotients.iter().chain(reduced.iter().flatten()).map(|slope| &slope.denominator);
        for denominator in denominators().filter(|denominator| !denominator.is_one()) {
            self.share_denominator(denominator);
        }
        self.prepare(reduced.iter().flatten().map(|slope| &slope.numerator));
        let mut first = Vec::new();
        for (quotient, reduced) in quotients.iter().zip(&reduced) {
            first.push(match reduced {
                Some(slope) => self.quotient(slope),
                None => self.first_by_rules(quotient, parameter),
            });
        }
        (first, reduced)
    }

    fn first_by_rules(&mut self, quotient: &Quotient, parameter: &Variable) -> Value {
        let value = self.quotient(quotient);
        let numerator = self.polynomial(&quotient.numerator);
        let slope = self.slope(numerator, parameter);
        if quotient.denominator.is_one() {
            return slope;
        }
        let denominator = self.polynomial(&quotient.denominator);
        let change = self.slope(denominator, parameter);
        let difference = self.difference(slope, &[(value, change)]);
        let inverse = self.inverse(&quotient.denominator);
        self.program.multiply(difference, inverse)
    }

    fn second(
        &mut self,
        quotients: &[Quotient],
        reduced: &[Option<Quotient>],
        first: &[Value],
        parameter: &Variable,
    ) -> Vec<Value> {
        let bends: Vec<Option<Quotient>> = quotients
            .iter()
            .zip(reduced)
            .map(|(quotient, slope)| bend(quotient, slope.as_ref()?, parameter))
            .collect();
        let written_out: Vec<bool> =
            (0..quotients.len()).map(|k| self.is_shorter(quotients, &bends, k, parameter)).collect();
        let chosen: Vec<&Quotient> = bends
            .iter()
            .zip(&written_out)
            .filter(|(_, out)| **out)
            .filter_map(|(bend, _)| bend.as_ref())
            .collect();
        for bend in chosen.iter().filter(|bend| !bend.denominator.is_one()) {
            self.share_denominator(&bend.denominator);
        }
        self.prepare(chosen.iter().map(|bend| &bend.numerator));
        let mut second = Vec::new();
        for (k, quotient) in quotients.iter().enumerate() {
            second.push(match &bends[k] {
                Some(bend) if written_out[k] => self.quotient(bend),
                _ => self.second_by_rules(quotient, first[k], parameter),
            });
        }
        second
    }

    fn second_by_rules(&mut self, quotient: &Quotient, first: Value, parameter: &Variable) -> Value {
        let numerator = self.polynomial(&quotient.numerator);
        let slope = self.slope(numerator, parameter);
        let bend = self.slope(slope, parameter);
        if quotient.denominator.is_one() {
            return bend;
        }
        let value = self.quotient(quotient);
        let denominator = self.polynomial(&quotient.denominator);
        let change = self.slope(denominator, parameter);
        let second_change = self.slope(change, parameter);
        let two = self.program.constant(Poly::integer(2));
        let twice = self.program.multiply(two, change);
        let difference = self.difference(bend, &[(first, twice), (value, second_change)]);
        let inverse = self.inverse(&quotient.denominator);
        self.program.multiply(difference, inverse)
    }

    /// `value` − Σ a·b
    fn difference(&mut self, value: Value, products: &[(Value, Value)]) -> Value {
        let one = self.program.constant(Poly::one());
        let products = products.iter().map(|&(a, b)| (a, b, true));
        let all: Vec<(Value, Value, bool)> = std::iter::once((value, one, false)).chain(products).collect();
        sum_of(&mut self.program, &all)
    }

    /// Whether the second derivatives of the quotients that have the denominator of the `place`-th one take fewer
    /// operations written out than by the rules, as far as the degrees of the polynomials tell.
    fn is_shorter(
        &self,
        quotients: &[Quotient],
        bends: &[Option<Quotient>],
        place: usize,
        parameter: &Variable,
    ) -> bool {
        let denominator = &quotients[place].denominator;
        if denominator.is_one() || bends[place].is_none() {
            return bends[place].is_some();
        }
        let horner = |poly: &Poly| match self.evaluated.iter().any(|(known, _)| known == poly) {
            true => 0,
            false => Sparsity::operations(&poly.coefficients(parameter)),
        };
        let (mut written_out, mut by_rules) = (2, 1);
        let change = denominator.derivative(parameter);
        by_rules += horner(&change) + horner(&change.derivative(parameter));
        let same = |(quotient, _): &(&Quotient, &Option<Quotient>)| quotient.denominator == *denominator;
        let mut seen: Vec<&Poly> = Vec::new();
        for (quotient, bend) in quotients.iter().zip(bends).filter(same) {
            if seen.contains(&&quotient.numerator) {
                continue;
            }
            seen.push(&quotient.numerator);
            let Some(bend) = bend else { return false };
            written_out += horner(&bend.numerator) + 1;
            let slope = quotient.numerator.derivative(parameter);
            by_rules += horner(&slope.derivative(parameter)) + 5;
        }
        written_out <= by_rules
    }

    /// The derivative of a value that is made of polynomials of the parameter.
    fn slope(&mut self, value: Value, parameter: &Variable) -> Value {
        if self.program.stage(value) <= Stage::Symbols {
            return self.program.constant(Poly::zero());
        }
        let poly = self.evaluated.iter().find(|(_, known)| *known == value).map(|(poly, _)| poly.clone());
        if let Some(derivative) = poly.as_ref().map(|poly| poly.derivative(parameter)) {
            let known = self.known.iter().any(|(_, known)| *known == derivative || *known == -&derivative);
            if known || derivative.terms().len() <= LARGE {
                return self.polynomial(&derivative);
            }
        }
        match *self.program.operation(value) {
            Operation::Multiply(a, b) if poly.is_none() || !self.written.contains(&value) => {
                let (slope_a, slope_b) = (self.slope(a, parameter), self.slope(b, parameter));
                let (first, second) = (self.program.multiply(slope_a, b), self.program.multiply(a, slope_b));
                self.program.add(first, second)
            }
            Operation::Add(a, b) if poly.is_none() || !self.written.contains(&value) => {
                let (a, b) = (self.slope(a, parameter), self.slope(b, parameter));
                self.program.add(a, b)
            }
            Operation::Subtract(a, b) if poly.is_none() || !self.written.contains(&value) => {
                let (a, b) = (self.slope(a, parameter), self.slope(b, parameter));
                self.program.subtract(a, b)
            }
            Operation::Negate(a) => {
                let slope = self.slope(a, parameter);
                self.program.negate(slope)
            }
            // A value of the other parameter does not occur in a polynomial of this one.
            Operation::Input(_) => self.program.constant(Poly::one()),
            _ => match poly {
                Some(poly) => self.polynomial(&poly.derivative(parameter)),
                None => unreachable!("polynomials are sums and products"),
            },
        }
    }

    /// A sum of products, without those that are 0.
    pub(super) fn sum_of_nonzero_products(&mut self, products: &[(Value, Value)]) -> Value {
        let zero = |value: Value| is_zero(&self.program, value);
        let products: Vec<(Value, Value)> =
            products.iter().copied().filter(|&(a, b)| !zero(a) && !zero(b)).collect();
        self.sum_of_products(&products)
    }
}

/// The derivative of the reduced derivative `slope` of a quotient, with a small numerator and without another gcd.
fn bend(quotient: &Quotient, slope: &Quotient, parameter: &Variable) -> Option<Quotient> {
    let (n, d) = (&slope.numerator, &quotient.denominator);
    if slope.denominator.is_one() {
        let bend = Quotient::polynomial(n.derivative(parameter));
        return (bend.numerator.terms().len() <= LARGE).then_some(bend);
    }
    let small = n.terms().len().saturating_mul(d.terms().len()) <= LARGE_PRODUCT;
    if !small || slope.denominator != d * d {
        return None;
    }
    let numerator = n.derivative(parameter) * d - Poly::integer(2) * n * d.derivative(parameter);
    let bend = Quotient { numerator, denominator: &slope.denominator * d };
    (bend.numerator.terms().len() <= LARGE).then_some(bend)
}
