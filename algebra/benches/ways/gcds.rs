//! Greatest common divisors: by modular images with sparse interpolation, with Brown's dense one alone, and by Euclid's
//! algorithm over the rationals.

use divan::{Bencher, black_box};
use hodograph_algebra::{Poly, Variable};

use crate::brown::brown_gcd;
use crate::euclid::naive_gcd;
use crate::operands::variables;

const SHAPES: [&str; 3] = ["dense", "sparse", "small"];

/// Two multiples of one polynomial.
fn multiples(shape: &str) -> ([Poly; 2], Vec<Variable>) {
    let (count, [a, b, g]) = match shape {
        "dense" => (3, dense()),
        "sparse" => (4, sparse()),
        _ => (2, small()),
    };
    ([a * &g, b * &g], variables(count))
}

/// All monomials in three variables up to the degree 4.
fn dense() -> [Poly; 3] {
    [[2, 3, -5], [1, -4, 3], [7, 1, 2]].map(|factors| {
        let terms = variables(3).into_iter().zip(factors);
        let sum: Poly =
            terms.map(|(variable, factor)| Poly::variable(&variable) * Poly::integer(factor)).sum();
        sum.pow(4) + (sum + Poly::one()).pow(3)
    })
}

/// Eight terms of degrees up to 12 in four variables.
fn sparse() -> [Poly; 3] {
    let variables = variables(4);
    [3_u32, 5, 7].map(|step| {
        let term = |i: u32| {
            let exponents = [12 - i, (step * i) % 11, (step * step * i + 2) % 13, (i * i + step) % 7];
            let powers = variables
                .iter()
                .zip(exponents)
                .map(|(variable, exponent)| Poly::variable(variable).pow(exponent));
            powers.product::<Poly>() * Poly::integer(i64::from(i % 5) + 1)
        };
        (0..8).map(term).sum()
    })
}

/// Three terms in two variables.
fn small() -> [Poly; 3] {
    let [x, y] = [0, 1].map(|place: usize| Poly::variable(&variables(2)[place]));
    [
        x.pow(3) - &y * Poly::integer(2) + Poly::one(),
        &x * &y + y.pow(2) - Poly::integer(3),
        x.pow(2) * Poly::integer(2) + &x * y.pow(2) - y,
    ]
}

#[divan::bench(args = SHAPES)]
fn engine(bencher: Bencher<'_, '_>, shape: &str) {
    let ([a, b], _) = multiples(shape);
    bencher.bench_local(|| black_box(&a).gcd(&b));
}

#[divan::bench(args = SHAPES)]
fn naive_brown(bencher: Bencher<'_, '_>, shape: &str) {
    let ([a, b], variables) = multiples(shape);
    assert_eq!(brown_gcd(&a, &b, &variables), Some(a.gcd(&b)));
    bencher.bench_local(|| brown_gcd(black_box(&a), &b, &variables));
}

/// Of the small operands alone: the others take minutes.
#[divan::bench(args = ["small"])]
fn naive_euclid(bencher: Bencher<'_, '_>, shape: &str) {
    let ([a, b], _) = multiples(shape);
    bencher.bench_local(|| naive_gcd(black_box(&a), &b));
}
