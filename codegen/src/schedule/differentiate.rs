//! Proof of derivatives without multiplying out: the terms of a derivative are those of the point, differentiated.

use std::collections::BTreeMap;

use hodograph_algebra::{Poly, Variable};

use super::check::Fractions;
use crate::program::{Arithmetic, Program, Stage, Term, Value, interpret};

/// Whether `derivative` is proved to be the derivative of `value` by a parameter, that of `stage`.
///
/// Both are sums of products a(u)·b(v). Products with the same factors in the other parameter are collected, and the
/// factors in this one compared as rational functions of one parameter. What is proved so is true; what is not may be so
/// for another reason.
pub(super) fn is_derivative(
    program: &Program<Poly>,
    derivative: Value,
    value: Value,
    (parameter, stage): (&Variable, Stage),
    arithmetic: &Fractions,
) -> bool {
    let (Some(found), Some(terms)) = (program.terms(derivative), program.terms(value)) else { return false };
    let mut sums: BTreeMap<Vec<Value>, (Poly, Poly)> = BTreeMap::new();
    let differentiated = terms.iter().map(|term| (term, true));
    for (term, differentiate) in differentiated.chain(found.iter().map(|term| (term, false))) {
        let Some((own, mut other)) = factors(program, term, stage, arithmetic) else { return false };
        other.sort();
        let (numerator, denominator) = own;
        let summand = if differentiate {
            let slope = numerator.derivative(parameter) * &denominator
                - &numerator * denominator.derivative(parameter);
            (slope, &denominator * &denominator)
        } else {
            (-numerator, denominator)
        };
        let sum = sums.entry(other).or_insert_with(|| (Poly::zero(), Poly::one()));
        *sum = arithmetic.add(sum, &summand);
    }
    sums.values().all(|(numerator, _)| numerator.is_zero())
}

/// The product of a term's numbers and factors in one parameter, and its factors in the other one.
fn factors(
    program: &Program<Poly>,
    term: &Term,
    stage: Stage,
    arithmetic: &Fractions,
) -> Option<((Poly, Poly), Vec<Value>)> {
    let (own, other) = if stage == Stage::U { (&term.u, &term.v) } else { (&term.v, &term.u) };
    let values: Vec<Value> = term.numbers.iter().chain(own).copied().collect();
    let numbers = interpret(program, &values, arithmetic).ok()?;
    let one = (Poly::one(), Poly::one());
    let product = numbers.iter().fold(one, |product, number| arithmetic.multiply(&product, number));
    let product = if term.negative { arithmetic.negate(&product) } else { product };
    Some((product, other.clone()))
}
