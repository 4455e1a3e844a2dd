//! Whether a polynomial is a square: by roots modulo primes, by the squarefree decomposition, and by the square root that is
//! worked out by hand.

use divan::{Bencher, black_box};
use hodograph_algebra::Poly;

use crate::square_root::square_root;
use crate::sweeps;

const SHAPES: [&str; 2] = ["numbers", "symbols"];

/// The squared length of the normal of the oriented translation, which is a square.
fn square(coefficients: &str) -> Poly {
    let surface = match coefficients {
        "numbers" => sweeps::oriented_translation(&sweeps::numeric_path()),
        _ => sweeps::translation(),
    };
    sweeps::normal(&surface).iter().map(|component| component * component).sum()
}

#[divan::bench(args = SHAPES)]
fn engine(bencher: Bencher<'_, '_>, coefficients: &str) {
    let square = square(coefficients);
    bencher.bench_local(|| black_box(&square).square_split());
}

#[divan::bench(args = SHAPES)]
fn squarefree(bencher: Bencher<'_, '_>, coefficients: &str) {
    let square = square(coefficients);
    bencher.bench_local(|| black_box(&square).squarefree());
}

#[divan::bench(args = SHAPES)]
fn naive_root(bencher: Bencher<'_, '_>, coefficients: &str) {
    let square = square(coefficients);
    bencher.bench_local(|| square_root(black_box(&square)));
}
