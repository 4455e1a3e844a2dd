//! The last component of `R_u × R_v` of an oriented translation: with known factors, and reduced by a gcd after every
//! operation.

use divan::{Bencher, black_box};
use hodograph_algebra::{Fraction, Preimage, Variable};

use crate::pairs::Pair;
use crate::sweeps;

const COEFFICIENTS: [&str; 2] = ["numbers", "symbols"];

/// x and y of the sweep along a quintic with numbers or a cubic with four symbols, and its parameters. (With a symbolic quintic
/// the pairs take minutes.)
fn position(coefficients: &str) -> ([Fraction; 2], [Variable; 2]) {
    let path = match coefficients {
        "numbers" => sweeps::numeric_path(),
        _ => sweeps::path(&Preimage::symbolic(3, "").expect("3 is odd")),
    };
    let surface = sweeps::oriented_translation(&path);
    let position = surface.homogeneous().cartesian();
    ([0, 1].map(|i: usize| position.components()[i].clone()), surface.parameters().clone())
}

#[divan::bench(args = COEFFICIENTS)]
fn engine(bencher: Bencher<'_, '_>, coefficients: &str) {
    let (position, parameters) = position(coefficients);
    bencher.bench_local(|| {
        let [along_u, along_v] =
            parameters.each_ref().map(|p| black_box(&position).each_ref().map(|x| x.derivative(p)));
        (&(&along_u[0] * &along_v[1]) - &(&along_u[1] * &along_v[0])).reduced()
    });
}

#[divan::bench(args = COEFFICIENTS)]
fn naive_pairs(bencher: Bencher<'_, '_>, coefficients: &str) {
    let (position, parameters) = position(coefficients);
    let position = position.each_ref().map(Pair::of);
    bencher.bench_local(|| {
        let [along_u, along_v] =
            parameters.each_ref().map(|p| black_box(&position).each_ref().map(|x| x.derivative(p)));
        along_u[0].mul(&along_v[1]).sub(&along_u[1].mul(&along_v[0]))
    });
}
