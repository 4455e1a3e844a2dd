//! Counting real roots by Sturm's theorem.

use std::cmp::Ordering;

use hodograph_algebra::{Poly, Variable};

/// The number of distinct real roots of a nonzero polynomial in the closed interval from `lower` to `upper`.
pub(crate) fn count_roots(poly: &Poly, variable: &Variable, lower: &Poly, upper: &Poly) -> usize {
    let f = poly.coefficients(variable);
    let mut chain = vec![f.clone(), poly.derivative(variable).coefficients(variable)];
    while let [.., a, b] = chain.as_slice() {
        if b.is_empty() {
            chain.pop();
            break;
        }
        let next = remainder(a, b).into_iter().map(|c| -c).collect();
        chain.push(next);
    }
    // Divided by its last element, the chain is that of the squarefree part.
    let last = chain.last().cloned().unwrap_or_default();
    let chain: Vec<Vec<Poly>> = chain.iter().map(|element| quotient(element, &last)).collect();
    let at_lower = usize::from(value(&f, lower).is_zero());
    at_lower + changes(&chain, lower) - changes(&chain, upper)
}

fn changes(chain: &[Vec<Poly>], at: &Poly) -> usize {
    let signs = chain.iter().map(|element| value(element, at).sign());
    let signs: Vec<Ordering> = signs.filter(|sign| sign.is_ne()).collect();
    signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
}

fn value(coefficients: &[Poly], at: &Poly) -> Poly {
    coefficients.iter().rev().fold(Poly::zero(), |sum, c| sum * at + c)
}

fn divide(a: &[Poly], b: &[Poly]) -> (Vec<Poly>, Vec<Poly>) {
    let (mut rest, mut quotient) = (a.to_vec(), Vec::new());
    let inverse = b.last().expect("the divisor is not zero").inverse();
    while rest.len() >= b.len() {
        let factor = rest.last().expect("it is longer than the divisor") * &inverse;
        let offset = rest.len() - b.len();
        for (i, c) in b.iter().enumerate() {
            rest[offset + i] = &rest[offset + i] - c * &factor;
        }
        rest.pop();
        quotient.insert(0, factor);
    }
    while rest.last().is_some_and(Poly::is_zero) {
        rest.pop();
    }
    (quotient, rest)
}

fn remainder(a: &[Poly], b: &[Poly]) -> Vec<Poly> {
    divide(a, b).1
}

fn quotient(a: &[Poly], b: &[Poly]) -> Vec<Poly> {
    divide(a, b).0
}
