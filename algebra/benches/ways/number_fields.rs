//! Products over a number field: its rules from a table, and one after the other where the field is too large for one.

use divan::{Bencher, black_box};
use hodograph_algebra::{Poly, Variable, integer};

fn root(radicand: i64) -> Poly {
    Poly::sqrt_of(&integer(radicand))
}

/// Two dense polynomials over `Q(√2, √3)`.
fn factors() -> [Poly; 2] {
    let [u, v] = [0, 1].map(|rank| Poly::variable(&Variable::new(rank, "x")));
    [1, -2].map(|factor| {
        (u.clone() * root(2) + &v * root(3) + (root(2) * root(3)).scale(&integer(factor)) + Poly::one())
            .pow(5)
    })
}

#[divan::bench]
fn table(bencher: Bencher<'_, '_>) {
    let [a, b] = factors();
    bencher.bench_local(|| black_box(&a) * &b);
}

/// The same polynomials over a field with three more generators, which do not occur.
#[divan::bench]
fn rules(bencher: Bencher<'_, '_>) {
    let further: Poly = [5, 7, 11].map(root).into_iter().sum();
    let [a, b] = factors().map(|factor| factor + &further - &further);
    assert_eq!(a.ring().field().degree(), 32);
    bencher.bench_local(|| black_box(&a) * &b);
}
