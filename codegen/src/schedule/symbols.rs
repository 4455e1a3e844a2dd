//! Coefficients in symbols: what a family of surfaces computes once for each of its members.

use std::hash::{DefaultHasher, Hash, Hasher};

use hodograph_algebra::{Poly, Variable, integer};

use super::univariate::Builder;
use crate::program::{Operation, Value};

impl Builder<'_> {
    /// The value of a number, or of a polynomial in symbols alone.
    ///
    /// Polynomials are evaluated by Horner's scheme in the symbol that most terms have, its coefficients in the same way;
    /// a common rational factor is multiplied last, so that the numbers within are integers.
    pub(super) fn number(&mut self, poly: &Poly) -> Value {
        if poly.is_constant() {
            return self.program.constant(poly.pruned());
        }
        let poly = &poly.pruned();
        let fingerprint = fingerprint(poly);
        let known = self.numbers.get(&fingerprint).into_iter().flatten();
        if let Some((_, value)) = known.into_iter().find(|(known, _)| known == poly) {
            return *value;
        }
        let primitive = poly.primitive();
        let value = if *poly.content() == integer(1) {
            self.sum_in_symbols(poly)
        } else {
            let value = self.number(&primitive);
            if poly.content() == &integer(-1) {
                self.program.negate(value)
            } else {
                let factor = self.program.constant(Poly::constant(poly.content().clone()));
                self.program.multiply(factor, value)
            }
        };
        self.numbers.entry(fingerprint).or_default().push((poly.clone(), value));
        value
    }

    fn sum_in_symbols(&mut self, poly: &Poly) -> Value {
        let count = |symbol: &Variable| {
            let place = poly.ring().position(symbol);
            let has = |place: usize| {
                poly.terms().iter().filter(|term| poly.ring().exponent(term.monomial, place) > 0).count()
            };
            place.map_or(0, has)
        };
        let mut symbols = poly.occurring_variables();
        symbols.sort_by_key(|symbol| std::cmp::Reverse(count(symbol)));
        let Some(symbol) = symbols.first() else { return self.program.constant(poly.pruned()) };
        let base = self.program.symbol(symbol.name());
        let mut coefficients = poly.coefficients(symbol).into_iter().rev();
        let mut sum = match coefficients.next() {
            Some(leading) => self.number(&leading),
            None => self.program.constant(Poly::zero()),
        };
        for coefficient in coefficients {
            let product = match self.program.operation(sum) {
                Operation::Constant(leading) if (-leading).is_one() => self.program.negate(base),
                _ => self.program.multiply(sum, base),
            };
            sum = if *coefficient.content() < integer(0) {
                let magnitude = self.number(&-coefficient);
                self.program.subtract(product, magnitude)
            } else {
                let term = self.number(&coefficient);
                self.program.add(product, term)
            };
        }
        sum
    }
}

/// A number that equal polynomials share, if they are written in the same variables.
fn fingerprint(poly: &Poly) -> u64 {
    let mut hasher = DefaultHasher::new();
    poly.ring().variables().hash(&mut hasher);
    poly.content().hash(&mut hasher);
    poly.terms().hash(&mut hasher);
    hasher.finish()
}
