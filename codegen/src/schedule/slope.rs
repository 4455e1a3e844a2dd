//! Derivatives of quotients in families, by the rules of calculus where the reduced form would be large.

use hodograph_algebra::{Poly, Variable};

use super::quotient::Quotient;
use super::univariate::Builder;
use crate::program::{Operation, Stage, Value};

/// The number of products of terms up to which a derivative is reduced, and of terms up to which it is written out: so large
/// that the derivatives along PH quintics are reduced, and so small that Horner's scheme costs no more than the rules.
const LARGE_PRODUCT: usize = 2000;
const LARGE: usize = 150;

impl Builder<'_> {
    /// The derivatives of quotients by a parameter.
    ///
    /// A small one is reduced, since a common factor leaves little of it: (y'/σ)' = 2 Im(w̄w')·x'/σ². A large one,
    /// (n/d)' = (n' − (n/d)·d')/d, is computed from the values of n and d, by the rules for products and sums.
    pub(super) fn slopes(
        &mut self,
        quotients: &[Quotient],
        parameter: &Variable,
        preferred: &[Poly],
    ) -> Vec<Value> {
        let reduced: Vec<Option<Quotient>> = quotients
            .iter()
            .map(|quotient| {
                let (n, d) = (quotient.numerator.terms().len(), quotient.denominator.terms().len());
                let derivative =
                    (n.saturating_mul(d) <= LARGE_PRODUCT).then(|| quotient.derivative(parameter, preferred));
                derivative.filter(|derivative| derivative.numerator.terms().len() <= LARGE)
            })
            .collect();
        self.share(reduced.iter().flatten());
        self.prepare(reduced.iter().flatten().flat_map(|slope| [&slope.denominator, &slope.numerator]));
        let by_rules = |(builder, quotient): (&mut Self, &Quotient)| {
            let value = builder.quotient(quotient);
            let numerator = builder.polynomial(&quotient.numerator);
            let slope = builder.slope(numerator, parameter);
            if quotient.denominator.is_one() {
                return slope;
            }
            let denominator = builder.polynomial(&quotient.denominator);
            let change = builder.slope(denominator, parameter);
            let change = builder.program.multiply(value, change);
            let difference = builder.program.subtract(slope, change);
            builder.program.divide(difference, denominator)
        };
        let pairs = quotients.iter().zip(&reduced);
        pairs
            .map(|(quotient, reduced)| match reduced {
                Some(slope) => self.quotient(slope),
                None => by_rules((self, quotient)),
            })
            .collect()
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
            Operation::Multiply(a, b) if poly.is_none() || !self.is_horner(value) => {
                let (slope_a, slope_b) = (self.slope(a, parameter), self.slope(b, parameter));
                let (first, second) = (self.program.multiply(slope_a, b), self.program.multiply(a, slope_b));
                self.program.add(first, second)
            }
            Operation::Add(a, b) if poly.is_none() || !self.is_horner(value) => {
                let (a, b) = (self.slope(a, parameter), self.slope(b, parameter));
                self.program.add(a, b)
            }
            Operation::Subtract(a, b) if poly.is_none() || !self.is_horner(value) => {
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

    /// Whether a value is the result of Horner's scheme.
    fn is_horner(&self, value: Value) -> bool {
        self.program.tables().iter().any(|table| table.value == value)
    }

    /// A sum of products, without those that are 0.
    pub(super) fn sum_of_nonzero_products(&mut self, products: &[(Value, Value)]) -> Value {
        let zero =
            |value: Value| matches!(self.program.operation(value), Operation::Constant(c) if c.is_zero());
        let products: Vec<(Value, Value)> =
            products.iter().copied().filter(|&(a, b)| !zero(a) && !zero(b)).collect();
        self.sum_of_products(&products)
    }
}
