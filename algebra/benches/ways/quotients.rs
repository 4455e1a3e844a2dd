//! Exact quotients: remainders in boxes of exponents, merged by a heap, and in an ordered map.

use divan::{Bencher, black_box};
use hodograph_algebra::Poly;

use crate::operands::{Operands, SHAPES, operands, scattered};
use crate::packed::{pack, quotient_by_map};

#[divan::bench(args = SHAPES)]
fn engine(bencher: Bencher<'_, '_>, shape: &str) {
    let [a, b] = operands(shape).factors;
    let product = &a * &b;
    bencher.bench_local(|| black_box(&product).exact_div(&b));
}

#[divan::bench(args = SHAPES)]
fn scattered_into_a_heap(bencher: Bencher<'_, '_>, shape: &str) {
    let [a, b] = scattered(&operands(shape).factors);
    let product = &a * &b;
    bencher.bench_local(|| black_box(&product).exact_div(&b));
}

#[divan::bench(args = SHAPES)]
fn naive_map(bencher: Bencher<'_, '_>, shape: &str) {
    let Operands { variables, factors: [a, b] } = operands(shape);
    let [product, divisor] = [&(&a * &b), &b].map(|poly| pack(poly, &variables));
    bencher.bench_local(|| quotient_by_map(black_box(&product), &divisor, variables.len()));
}

/// A dividend that differs from a multiple in one term in the middle: most trial divisions fail.
#[divan::bench(args = SHAPES)]
fn engine_without_a_quotient(bencher: Bencher<'_, '_>, shape: &str) {
    let Operands { variables, factors: [a, b] } = operands(shape);
    let dividend = &a * &b + variables.iter().map(Poly::variable).product::<Poly>() * &a;
    assert_eq!(dividend.exact_div(&b), None);
    bencher.bench_local(|| black_box(&dividend).exact_div(&b));
}
