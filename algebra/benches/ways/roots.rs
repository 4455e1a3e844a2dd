//! Real roots: isolated by Bernstein forms and recognized where they are rational, and merely counted, by Sturm's theorem.

use divan::{Bencher, black_box};
use hodograph_algebra::{Interval, Poly, Variable, integer, ratio};

use crate::sturm::count_roots;

const SHAPES: [&str; 3] = ["apart", "close", "irrational"];

fn x() -> Variable {
    Variable::new(0, "x")
}

/// Polynomials of degree 16 to 23 with roots between 0 and 1.
fn polynomial(shape: &str) -> Poly {
    let variable = Poly::variable(&x());
    let linear = |n: i64| &variable - Poly::constant(ratio(n, 24));
    match shape {
        "apart" => (1..24).map(linear).product(),
        // Mignotte's: two roots about 10⁻²¹ apart.
        "close" => variable.pow(20) - (variable * Poly::integer(100) - Poly::one()).pow(2).scale(&integer(2)),
        _ => (1..17).map(|n| linear(n) - Poly::sqrt_of(&integer(2)).scale(&ratio(1, 40))).product(),
    }
}

#[divan::bench(args = SHAPES)]
fn engine(bencher: Bencher<'_, '_>, shape: &str) {
    let (poly, interval) = (polynomial(shape), Interval::unit());
    bencher.bench_local(|| black_box(&poly).real_roots_in(&x(), &interval));
}

#[divan::bench(args = SHAPES)]
fn naive_sturm(bencher: Bencher<'_, '_>, shape: &str) {
    let (poly, interval) = (polynomial(shape), Interval::unit());
    bencher.bench_local(|| count_roots(black_box(&poly), &x(), interval.lower(), interval.upper()));
}
