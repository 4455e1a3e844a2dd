//! Square roots of polynomials, worked out by hand.

use hodograph_algebra::{Poly, Rational, ratio, rational_sqrt};

/// The polynomial over the rationals with this square and a positive leading coefficient, if there is one.
///
/// From the first term down: the largest term of what is missing, divided by twice the first term of the root, is the next one.
pub(crate) fn square_root(square: &Poly) -> Option<Poly> {
    let Some((exponents, coefficient)) = leading_term(square) else { return Some(Poly::zero()) };
    if exponents.iter().any(|exponent| exponent % 2 == 1) {
        return None;
    }
    let halves: Vec<u32> = exponents.iter().map(|exponent| exponent / 2).collect();
    let first = monomial(square, &halves).scale(&rational_sqrt(&coefficient)?);
    let (mut root, mut rest) = (first.clone(), square - &first * &first);
    while let Some((exponents, coefficient)) = leading_term(&rest) {
        let term = monomial(&rest, &exponents).scale(&(coefficient * ratio(1, 2))).exact_div(&first)?;
        let variables = square.ring().variables().iter();
        let fits = |variable| 2 * term.degree(variable).unwrap_or(0) <= square.degree(variable).unwrap_or(0);
        if !variables.into_iter().all(fits) {
            return None;
        }
        rest -= &term * (&root + &root + &term);
        root += term;
    }
    Some(root)
}

/// The exponents and the coefficient of the largest term.
fn leading_term(poly: &Poly) -> Option<(Vec<u32>, Rational)> {
    let term = poly.terms().first()?;
    let coefficient = poly.content() * Rational::from(term.coefficient.clone());
    Some((poly.ring().exponents(term.monomial), coefficient))
}

/// The product of powers of the variables of the ring of `poly`.
fn monomial(poly: &Poly, exponents: &[u32]) -> Poly {
    let powers = poly.ring().variables().iter().zip(exponents);
    powers.map(|(variable, &exponent)| Poly::variable(variable).pow(exponent)).product()
}
