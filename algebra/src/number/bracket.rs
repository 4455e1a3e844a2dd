//! Real numbers in fixed point, between two integers: what enclosures and signs of numbers of a field are computed with.
//!
//! This is interval arithmetic (Moore, *Interval Analysis*, 1966) with one denominator for all: unlike [`Enclosure`]s, whose ends
//! are rational, it needs no greatest common divisors. Complexity: one product of integers for each end and operation.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use num_integer::Integer;
use num_traits::Signed;

use super::enclosure::Enclosure;
use super::field::Generator;
use crate::poly::Poly;
use crate::{Int, Rational};

/// A real number `x` with `lower ≤ 2^bits·x ≤ upper`, for a precision `bits` that its reader knows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Bracket {
    /// An integer that is not above `2^bits·x`.
    pub(crate) lower: Int,
    /// An integer that is not below `2^bits·x`.
    pub(crate) upper: Int,
}

impl Bracket {
    fn zero() -> Bracket {
        Bracket { lower: Int::ZERO, upper: Int::ZERO }
    }

    fn one(bits: u64) -> Bracket {
        let one = Int::ONE.shl(bits);
        Bracket { lower: one.clone(), upper: one }
    }

    /// Adds `factor` times a number.
    pub(crate) fn add_multiple(&mut self, factor: &Int, other: &Bracket) {
        let (low, high) =
            if factor.is_negative() { (&other.upper, &other.lower) } else { (&other.lower, &other.upper) };
        self.lower += factor * low;
        self.upper += factor * high;
    }

    /// The product of numbers that are not negative.
    fn product(&self, other: &Bracket, bits: u64) -> Bracket {
        let lower = (&self.lower * &other.lower).shr(bits);
        let upper = (&self.upper * &other.upper).shr(bits) + Int::ONE;
        Bracket { lower, upper }
    }

    /// The square root of a number that is not negative.
    fn sqrt(&self, bits: u64) -> Bracket {
        let root = |scaled: &Int| scaled.shl(bits).isqrt();
        Bracket { lower: root(&self.lower), upper: root(&self.upper) + Int::ONE }
    }

    /// Whether the width of `factor` times the number is at most `2^-target`, for `target ≤ bits`.
    pub(crate) fn is_narrow(&self, factor: &Rational, bits: u64, target: u64) -> bool {
        (&self.upper - &self.lower) * factor.numer().abs() <= factor.denom().shl(bits - target)
    }

    /// The interval of `factor` times the number.
    pub(crate) fn times(&self, factor: &Rational, bits: u64) -> Enclosure {
        let (low, high) =
            if factor.is_negative() { (&self.upper, &self.lower) } else { (&self.lower, &self.upper) };
        Enclosure::ordered(dyadic_multiple(low, factor, bits), dyadic_multiple(high, factor, bits))
    }
}

/// `integer · factor / 2^bits` in lowest terms.
fn dyadic_multiple(integer: &Int, factor: &Rational, mut bits: u64) -> Rational {
    let common = integer.gcd(factor.denom());
    let (integer, denominator) = (integer / &common, factor.denom() / &common);
    // Now both numerators are coprime to the denominator, and only twos are left to cancel.
    let mut numerator = integer * factor.numer();
    let twos = numerator.trailing_zeros().unwrap_or(bits).min(bits);
    numerator = numerator.shr(twos);
    bits -= twos;
    Rational::new_raw(numerator, denominator.shl(bits))
}

/// The values of the generators of a number field and of their products, as far as they were asked for, by precision.
///
/// They follow from the field, so this is no part of what it is; it saves their computation for each number again.
#[derive(Debug, Default)]
pub(crate) struct GeneratorValues(Mutex<BTreeMap<u64, Table>>);

#[derive(Debug, Default)]
struct Table {
    generators: Vec<Bracket>,
    /// Products of distinct generators, by the set of their positions.
    products: BTreeMap<u64, Bracket>,
}

impl GeneratorValues {
    /// The number `Σ coefficient · Π generators` over terms that name the generators as a set of positions.
    pub(crate) fn sum<'a>(
        &self,
        generators: &[Generator],
        terms: impl IntoIterator<Item = (u64, &'a Int)>,
        bits: u64,
    ) -> Bracket {
        // Whoever unwound with the lock left complete entries behind.
        let mut tables = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let table = tables.entry(bits).or_default();
        table.extend(generators, bits);
        let mut sum = Bracket::zero();
        for (positions, coefficient) in terms {
            sum.add_multiple(coefficient, table.product(positions, bits));
        }
        sum
    }
}

impl Table {
    /// Computes the values of those `generators` that are not there.
    fn extend(&mut self, generators: &[Generator], bits: u64) {
        for generator in &generators[self.generators.len()..] {
            let mut radicand = Bracket::zero();
            for (exponents, coefficient) in generator.radicand_terms() {
                let bit = |(position, exponent): (usize, &u32)| u64::from(*exponent) << position;
                let positions = exponents.iter().enumerate().map(bit).sum();
                radicand.add_multiple(&coefficient, self.product(positions, bits));
            }
            if radicand.lower.is_negative() {
                radicand.lower = Int::ZERO;
            }
            self.generators.push(radicand.sqrt(bits));
        }
    }

    /// The product of the generators at `positions`.
    fn product(&mut self, positions: u64, bits: u64) -> &Bracket {
        if !self.products.contains_key(&positions) {
            let chosen = self.generators.iter().enumerate().filter(|(i, _)| positions >> i & 1 == 1);
            let mut chosen = chosen.map(|(_, generator)| generator);
            let first = chosen.next().cloned().unwrap_or_else(|| Bracket::one(bits));
            let product = chosen.fold(first, |product, generator| product.product(generator, bits));
            self.products.insert(positions, product);
        }
        &self.products[&positions]
    }
}

impl Poly {
    /// The value of the primitive part of a number, in fixed point with `bits` bits after the point.
    pub(crate) fn bracket(&self, bits: u64) -> Bracket {
        let ring = self.ring();
        let count = ring.field().generators().len();
        let positions =
            |monomial| (0..count).map(|i| u64::from(ring.generator_exponent(monomial, i)) << i).sum();
        let terms = self.terms().iter().map(|term| (positions(term.monomial), &term.coefficient));
        ring.field().sum_of_products(terms, bits)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ratio;

    #[test]
    fn products_of_nested_roots_are_bracketed() {
        // g² = 2, h² = 110 + 100·g: the square of 3·g·h − h is (19 − 6·g)·h² = 890 + 1240·g.
        let root = Poly::sqrt_of(&ratio(2, 1));
        let theta = (Poly::integer(110) + &root * Poly::integer(100)).sqrt().unwrap();
        let number = &root * &theta * Poly::integer(3) - &theta;
        let square = &number * &number;
        for bits in [8, 40, 400] {
            let [a, b] = [&number, &square].map(|x| x.bracket(bits).times(x.content(), bits));
            let squares = a.mul(&a);
            assert!(squares.lower() <= b.upper() && b.lower() <= squares.upper());
            assert!(number.bracket(bits).is_narrow(&ratio(1, 1), bits, bits.saturating_sub(16)));
        }
        assert_eq!(square.to_decimal(3), "2643.625");
    }

    #[test]
    fn negative_factors_turn_the_ends() {
        let root = Poly::sqrt_of(&ratio(2, 1));
        let enclosure = root.bracket(10).times(&ratio(-3, 2), 10);
        assert_eq!(enclosure, Enclosure::new(ratio(-3 * 1449, 2048), ratio(-3 * 1448, 2048)));
    }
}
