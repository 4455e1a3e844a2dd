//! Random polynomials and naive algorithms that tests compare the fast ones with.

use hodograph_algebra::{Poly, Variable, integer};
use proptest::prelude::*;

/// The variables of random polynomials.
pub(crate) fn variables() -> [Variable; 3] {
    [Variable::new(0, "u"), Variable::new(1, "v"), Variable::new(Variable::SYMBOL, "a")]
}

/// The basis of the field that random coefficients are taken from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Coefficients {
    /// The rationals.
    Rational,
    /// Q(√2).
    Quadratic,
    /// Q(√2, √(110 + 100√2)).
    Tower,
}

impl Coefficients {
    fn basis(self) -> Vec<Poly> {
        let root = Poly::sqrt_of(&integer(2));
        let theta = || (Poly::integer(110) + &root * Poly::integer(100)).sqrt().expect("a positive number");
        match self {
            Coefficients::Rational => vec![Poly::one()],
            Coefficients::Quadratic => vec![Poly::one(), root],
            Coefficients::Tower => vec![Poly::one(), root.clone(), theta(), theta() * root],
        }
    }
}

/// Polynomials of at most `terms` terms and of degree at most `degree` in each variable; they may be zero.
pub(crate) fn polynomials(
    coefficients: Coefficients,
    terms: usize,
    degree: u32,
) -> impl Strategy<Value = Poly> {
    let basis = coefficients.basis();
    let term = (prop::array::uniform3(0..=degree), -5_i64..=5, 0..basis.len());
    prop::collection::vec(term, 1..=terms).prop_map(move |terms| {
        let value = |(exponents, value, index): ([u32; 3], i64, usize)| {
            let powers = variables().into_iter().zip(exponents);
            let monomial: Poly =
                powers.map(|(variable, exponent)| Poly::variable(&variable).pow(exponent)).product();
            monomial * &basis[index] * Poly::integer(value)
        };
        terms.into_iter().map(value).sum()
    })
}

/// The determinant of a square matrix by Bareiss's fraction-free elimination.
pub(crate) fn determinant(mut rows: Vec<Vec<Poly>>) -> Poly {
    let mut previous = Poly::one();
    let mut negative = false;
    for k in 0..rows.len() {
        let Some(pivot) = (k..rows.len()).find(|&i| !rows[i][k].is_zero()) else { return Poly::zero() };
        negative ^= pivot != k;
        rows.swap(pivot, k);
        for i in k + 1..rows.len() {
            for j in k + 1..rows.len() {
                let minor = &rows[k][k] * &rows[i][j] - &rows[i][k] * &rows[k][j];
                rows[i][j] = minor.exact_div(&previous).expect("a minor of the matrix");
            }
        }
        previous = rows[k][k].clone();
    }
    if negative { -previous } else { previous }
}

/// The matrix whose determinant is the resultant of two nonzero polynomials in `variable`.
pub(crate) fn sylvester(a: &Poly, b: &Poly, variable: &Variable) -> Vec<Vec<Poly>> {
    let (a, b) = (a.coefficients(variable), b.coefficients(variable));
    let (m, n) = (a.len() - 1, b.len() - 1);
    let row = |coefficients: &[Poly], shift: usize| {
        let mut row = vec![Poly::zero(); m + n];
        for (i, coefficient) in coefficients.iter().rev().enumerate() {
            row[shift + i] = coefficient.clone();
        }
        row
    };
    (0..n).map(|shift| row(&a, shift)).chain((0..m).map(|shift| row(&b, shift))).collect()
}
