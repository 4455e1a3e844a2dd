//! Polynomials as text that can be pasted into any computer-algebra system.

use std::fmt;

use num_traits::{One, Signed};

use super::{Poly, Term};
use crate::Rational;

impl fmt::Display for Poly {
    /// A sum of terms in a fixed order, each a rational coefficient, then generators, symbols and parameters.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_zero() {
            return f.write_str("0");
        }
        for (index, term) in self.terms.iter().enumerate() {
            let coefficient = &self.content * Rational::from(term.coefficient.clone());
            let sign = match (index, coefficient.is_negative()) {
                (0, true) => "-",
                (0, false) => "",
                (_, true) => " - ",
                (_, false) => " + ",
            };
            f.write_str(sign)?;
            write_term(f, self, term, &coefficient.abs())?;
        }
        Ok(())
    }
}

fn write_term(f: &mut fmt::Formatter<'_>, poly: &Poly, term: &Term, coefficient: &Rational) -> fmt::Result {
    let ring = &poly.ring;
    let generators = ring.field().generators().iter().map(|generator| generator.name());
    let generators = generators.zip(ring.generator_exponents(term.monomial));
    let variables = ring.variables().iter().zip(ring.exponents(term.monomial));
    let parameters = |symbol: bool| {
        variables.clone().filter(move |(variable, _)| (variable.rank() >= super::Variable::SYMBOL) == symbol)
    };
    let named = |(variable, exponent): (&super::Variable, u32)| (variable.name().to_owned(), exponent);
    let factors: Vec<(String, u32)> = generators
        .map(|(name, exponent)| (name.to_owned(), exponent))
        .chain(parameters(true).map(named))
        .chain(parameters(false).map(named))
        .filter(|(_, exponent)| *exponent > 0)
        .collect();
    if factors.is_empty() || !coefficient.is_one() {
        write!(f, "{coefficient}")?;
        if !factors.is_empty() {
            f.write_str("*")?;
        }
    }
    for (index, (name, exponent)) in factors.iter().enumerate() {
        if index > 0 {
            f.write_str("*")?;
        }
        f.write_str(name)?;
        if *exponent > 1 {
            write!(f, "^{exponent}")?;
        }
    }
    Ok(())
}

impl fmt::Debug for Poly {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}
