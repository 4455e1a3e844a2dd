//! Polynomials without a common factor: certified by images in one variable, or by a full gcd.

use divan::{Bencher, black_box};
use hodograph_algebra::Poly;

use crate::brown::brown_gcd;
use crate::euclid::naive_gcd;
use crate::sweeps;

/// The last two numerators of the normal of the oriented translation, along a quintic with numbers or with six symbols.
fn numerators(coefficients: &str) -> [Poly; 2] {
    let surface = match coefficients {
        "numbers" => sweeps::oriented_translation(&sweeps::numeric_path()),
        _ => sweeps::translation(),
    };
    let components = sweeps::normal(&surface);
    [components[1].clone(), components[2].clone()]
}

#[divan::bench(args = ["numbers", "symbols"])]
fn engine(bencher: Bencher<'_, '_>, coefficients: &str) {
    let polys = numerators(coefficients);
    bencher.bench_local(|| Poly::coprime(black_box(&polys)));
}

#[divan::bench(args = ["numbers", "symbols"])]
fn naive_brown(bencher: Bencher<'_, '_>, coefficients: &str) {
    let [a, b] = numerators(coefficients);
    let variables = (&a * &b).occurring_variables();
    bencher.bench_local(|| brown_gcd(black_box(&a), &b, &variables));
}

/// Without symbols: with them it takes minutes.
#[divan::bench(args = ["numbers"])]
fn naive_euclid(bencher: Bencher<'_, '_>, coefficients: &str) {
    let [a, b] = numerators(coefficients);
    bencher.bench_local(|| naive_gcd(black_box(&a), &b));
}
