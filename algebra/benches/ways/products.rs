//! Products: sums in boxes of exponents, in a hash table, in an ordered map, and merged by a heap.

use divan::{Bencher, black_box};

use crate::operands::{Operands, SHAPES, operands, scattered};
use crate::packed::{pack, product_by_heap, product_by_map};

#[divan::bench(args = SHAPES)]
fn engine(bencher: Bencher<'_, '_>, shape: &str) {
    let [a, b] = operands(shape).factors;
    bencher.bench_local(|| black_box(&a) * &b);
}

#[divan::bench(args = SHAPES)]
fn scattered_into_a_hash_table(bencher: Bencher<'_, '_>, shape: &str) {
    let [a, b] = scattered(&operands(shape).factors);
    bencher.bench_local(|| black_box(&a) * &b);
}

#[divan::bench(args = SHAPES)]
fn naive_heap(bencher: Bencher<'_, '_>, shape: &str) {
    let Operands { variables, factors } = operands(shape);
    let [a, b] = factors.each_ref().map(|factor| pack(factor, &variables));
    bencher.bench_local(|| product_by_heap(black_box(&a), &b));
}

#[divan::bench(args = SHAPES)]
fn naive_map(bencher: Bencher<'_, '_>, shape: &str) {
    let Operands { variables, factors } = operands(shape);
    let [a, b] = factors.each_ref().map(|factor| pack(factor, &variables));
    bencher.bench_local(|| product_by_map(black_box(&a), &b));
}
