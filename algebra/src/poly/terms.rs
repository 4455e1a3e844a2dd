//! Sums of sorted lists of terms with integer coefficients.

use num_traits::Zero;

use super::Term;
use super::ring::Ring;
use crate::{Int, budget};

/// `a·x + b·y` for sorted lists `x` and `y`, which are merged: linear in their lengths.
pub(crate) fn linear_combination(a: &Int, x: &[Term], b: &Int, y: &[Term]) -> Vec<Term> {
    budget::spend((x.len() + y.len()) as u64);
    let mut sum = Vec::with_capacity(x.len() + y.len());
    let (mut i, mut j) = (0, 0);
    while i < x.len() || j < y.len() {
        let from_x = j == y.len() || (i < x.len() && x[i].monomial >= y[j].monomial);
        let from_y = i == x.len() || (j < y.len() && y[j].monomial >= x[i].monomial);
        let (monomial, coefficient) = match (from_x, from_y) {
            (true, true) => (x[i].monomial, a * &x[i].coefficient + b * &y[j].coefficient),
            (true, false) => (x[i].monomial, a * &x[i].coefficient),
            _ => (y[j].monomial, b * &y[j].coefficient),
        };
        i += usize::from(from_x);
        j += usize::from(from_y);
        if !coefficient.is_zero() {
            sum.push(Term { monomial, coefficient });
        }
    }
    sum
}

/// The largest exponent of each variable and generator, as a word.
pub(crate) fn maximum(ring: &Ring, terms: &[Term]) -> u128 {
    let (mut most, mut i) = (0, 0);
    while i < terms.len() {
        most = ring.maximum(most, terms[i].monomial.0);
        i += 1;
    }
    most
}

/// Sorts terms and adds those of equal monomials.
pub(crate) fn collect(mut terms: Vec<Term>) -> Vec<Term> {
    budget::spend(4 * terms.len() as u64);
    terms.sort_by_key(|term| std::cmp::Reverse(term.monomial));
    let mut sum: Vec<Term> = Vec::with_capacity(terms.len());
    for term in terms {
        match sum.last_mut() {
            Some(last) if last.monomial == term.monomial => last.coefficient += term.coefficient,
            _ => {
                if sum.last().is_some_and(|last| last.coefficient.is_zero()) {
                    sum.pop();
                }
                sum.push(term);
            }
        }
    }
    if sum.last().is_some_and(|last| last.coefficient.is_zero()) {
        sum.pop();
    }
    sum
}
