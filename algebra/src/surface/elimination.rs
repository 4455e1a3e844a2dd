//! Shorter systems of polynomials with the same common zeros.

use crate::poly::Monomial;
use crate::{Poly, Term, Variable};

/// How many times a remainder is reduced, before it stays as it is.
const MOST_REDUCTIONS: usize = 400;

/// The polynomials with a multiple of one subtracted from another wherever that makes it shorter, until nothing does; zeros
/// are left out. They span the same space over the number field.
///
/// Complexity: for each subtraction at most one pass over all pairs.
pub(crate) fn shortened(polys: &[Poly]) -> Vec<Poly> {
    let mut rows: Vec<Poly> = polys.iter().filter(|poly| !poly.is_zero()).cloned().collect();
    let mut changed = true;
    while changed {
        changed = false;
        for i in 0..rows.len() {
            for j in 0..rows.len() {
                if i == j || rows[i].is_zero() || rows[j].is_zero() {
                    continue;
                }
                let combined = remainder(&rows[i], &rows[j..=j], Quotient::Number);
                if combined.terms().len() < rows[i].terms().len() {
                    rows[i] = combined;
                    changed = true;
                }
            }
        }
    }
    rows.retain(|row| !row.is_zero());
    rows
}

/// The polynomials without those that another one divides, the shortest first. They vanish together where all do.
pub(crate) fn without_multiples(mut polys: Vec<Poly>) -> Vec<Poly> {
    polys.sort_by_key(|poly| poly.terms().len());
    let mut kept: Vec<Poly> = Vec::new();
    for poly in polys {
        if !kept.iter().any(|other| other.divides(&poly)) {
            kept.push(poly);
        }
    }
    kept
}

/// By what divisors are multiplied in a division.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Quotient {
    /// A number, for the first term that allows it alone.
    Number,
    /// Any polynomial.
    Polynomial,
}

/// The remainder of a division by several polynomials in the lexicographic order of monomials (Cox, Little and O'Shea, *Ideals,
/// Varieties, and Algorithms*, chapter 2, section 3).
pub(crate) fn remainder(poly: &Poly, divisors: &[Poly], by: Quotient) -> Poly {
    let joint =
        divisors.iter().fold(poly.clone(), |joint, divisor| Poly::unify(&joint, divisor).0.into_owned());
    let ring = joint.ring().clone();
    let divisors = divisors.iter().map(|divisor| Poly::unify(&joint, divisor).1.into_owned());
    let divisors: Vec<(Poly, Monomial)> = divisors
        .filter_map(|divisor| {
            let leading = ring.variable_part(divisor.terms().first()?.monomial);
            Some((divisor.leading_coefficient().inverse() * divisor, leading))
        })
        .collect();
    let mut rest = joint;
    for _ in 0..MOST_REDUCTIONS {
        let step = rest.terms().iter().find_map(|term| {
            let monomial = ring.variable_part(term.monomial);
            divisors.iter().find_map(|(divisor, leading)| {
                let quotient = ring.quotient(monomial, *leading)?;
                (by == Quotient::Polynomial || quotient == Monomial::ONE)
                    .then_some((monomial, quotient, divisor))
            })
        });
        let Some((monomial, quotient, divisor)) = step else { break };
        let terms = rest.terms().iter().filter(|term| ring.variable_part(term.monomial) == monomial);
        let terms = terms.map(|term| Term {
            monomial: Monomial(ring.generator_part(term.monomial).0 + quotient.0),
            coefficient: term.coefficient.clone(),
        });
        let multiplier = Poly::from_sorted(ring.clone(), rest.content().clone(), terms.collect());
        rest = (&rest - multiplier * divisor).transfer_to(&ring);
        if by == Quotient::Number {
            break;
        }
    }
    rest
}

/// The remainder of a division by a polynomial in `parameter` alone, over the coefficients.
pub(crate) fn modulo(poly: &Poly, divisor: &Poly, parameter: &Variable) -> Poly {
    let divisor = divisor.coefficients(parameter);
    let Some((leading, lower)) = divisor.split_last() else { return poly.clone() };
    let inverse = leading.inverse();
    let mut rest = poly.coefficients(parameter);
    while rest.len() > lower.len() {
        let factor = rest.pop().unwrap_or_else(Poly::zero) * &inverse;
        let shift = rest.len() - lower.len();
        for (coefficient, below) in rest[shift..].iter_mut().zip(lower) {
            *coefficient -= &factor * below;
        }
    }
    Poly::from_coefficients(parameter, &rest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integer;

    #[test]
    fn sums_and_differences_become_their_parts() {
        let [v, a, b] = ["v", "a", "b"].map(|name| Poly::variable(&Variable::new(0, name)));
        let (first, second) = (v.pow(2) * &a + &v, &b * &v - Poly::one());
        let root = Poly::sqrt_of(&integer(2));
        let rows = shortened(&[&first + &second, &first * &root - &second * &root, Poly::zero()]);
        assert_eq!(
            rows.iter().map(Poly::normalized).collect::<Vec<_>>(),
            [second.normalized(), first.normalized()]
        );
    }

    #[test]
    fn remainders_lie_in_the_same_class() {
        let variable = Variable::new(0, "v");
        let [v, a] = [&variable, &Variable::new(Variable::SYMBOL, "a")].map(Poly::variable);
        let root = Poly::sqrt_of(&integer(3));
        let (f, g) = (v.pow(2) * &root - &a, &a + Poly::one());
        let inside = &f * (&v + &a) + &g * (v.pow(3) - &root);
        assert!(remainder(&(&f * (&v + &a)), std::slice::from_ref(&f), Quotient::Polynomial).is_zero());
        let rest = remainder(&(&inside + &a), &[f, g], Quotient::Polynomial);
        assert_eq!(rest, Poly::integer(-1));
        let quadratic = v.pow(2).scale(&integer(2)) + Poly::one();
        let rest = modulo(&(&inside * &quadratic + &a * &v), &quadratic, &variable);
        assert_eq!(rest, a * v);
    }
}
