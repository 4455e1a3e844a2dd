//! Greatest common divisors by Euclid's algorithm.

use hodograph_algebra::{Poly, Variable};

/// The greatest common divisor by primitive pseudo-remainder sequences in one variable after the other.
pub(crate) fn naive_gcd(a: &Poly, b: &Poly) -> Poly {
    if a.is_zero() || b.is_zero() {
        return if a.is_zero() { b.normalized() } else { a.normalized() };
    }
    let occurring = [a, b].into_iter().flat_map(Poly::occurring_variables);
    let Some(variable) = occurring.min() else { return Poly::one() };
    let content =
        |poly: &Poly| poly.coefficients(&variable).iter().fold(Poly::zero(), |g, c| naive_gcd(&g, c));
    let primitive = |poly: &Poly| poly.exact_div(&content(poly)).expect("the content divides");
    let (mut high, mut low) = (primitive(a), primitive(b));
    if high.degree(&variable) < low.degree(&variable) {
        (high, low) = (low, high);
    }
    while !low.is_zero() {
        let remainder = naive_pseudo_remainder(&high, &low, &variable);
        high = low;
        low = if remainder.is_zero() { remainder } else { primitive(&remainder) };
    }
    (naive_gcd(&content(a), &content(b)) * high).normalized()
}

/// A multiple of `a` minus a multiple of `b` of lower degree than `b`.
fn naive_pseudo_remainder(a: &Poly, b: &Poly, variable: &Variable) -> Poly {
    let leading = |poly: &Poly| poly.coefficients(variable).last().cloned().unwrap_or_else(Poly::zero);
    let low = b.degree(variable).unwrap_or(0);
    let mut rest = a.clone();
    while let Some(degree) = rest.degree(variable).filter(|&degree| degree >= low) {
        rest = &rest * leading(b) - (b * leading(&rest)).shift(variable, degree - low);
    }
    rest
}
