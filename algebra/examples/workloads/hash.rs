//! A hash of polynomials with integer coefficients: a value modulo the prime 2⁶¹ − 1.

use hodograph_algebra::{Int, Poly};
use num_traits::ToPrimitive;

/// The prime.
const MODULUS: u64 = (1 << 61) - 1;
/// The coordinates of the point, for the variables in their order.
const POINT: [u64; 10] = [3, 5, 7, 11, 13, 17, 19, 23, 29, 31];
/// The weight of each further polynomial, relative to the one before it.
const WEIGHT: u64 = 1_000_003;

/// The hash of several polynomials: their values at the point, each up to its sign, combined with the powers of a weight.
///
/// # Panics
/// If a coefficient is no integer, or if a variable is not among `variables`.
pub(crate) fn hash(polys: &[Poly], variables: &[&str]) -> u64 {
    let mut weight = 1;
    polys.iter().fold(0, |sum, poly| {
        let value = value(poly, variables);
        let term = times(value.min(MODULUS - value), weight);
        weight = times(weight, WEIGHT);
        (sum + term) % MODULUS
    })
}

fn value(poly: &Poly, variables: &[&str]) -> u64 {
    assert!(poly.content().is_integer(), "the hash is one of integer coefficients");
    let ring = poly.ring();
    let places =
        ring.variables().iter().map(|variable| variables.iter().position(|name| *name == variable.name()));
    let bases: Vec<u64> = places.map(|place| POINT[place.expect("the hash names all variables")]).collect();
    let content = residue(poly.content().numer());
    poly.terms().iter().fold(0, |sum, term| {
        let exponents = ring.exponents(term.monomial);
        let powers = bases.iter().zip(&exponents).map(|(&base, &exponent)| power(base, exponent));
        let monomial = powers.fold(content, times);
        (sum + times(monomial, residue(&term.coefficient))) % MODULUS
    })
}

fn residue(value: &Int) -> u64 {
    let modulus = Int::from(MODULUS);
    let residue = (value % &modulus + &modulus) % &modulus;
    residue.small().and_then(|residue| residue.to_u64()).expect("a residue is below the modulus")
}

fn times(a: u64, b: u64) -> u64 {
    // The remainder is below 2⁶¹.
    (u128::from(a) * u128::from(b) % u128::from(MODULUS)) as u64
}

fn power(base: u64, exponent: u32) -> u64 {
    (0..exponent).fold(1, |power, _| times(power, base))
}
