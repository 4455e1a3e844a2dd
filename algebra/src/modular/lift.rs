//! From images modulo primes back to rational numbers.

use std::collections::BTreeMap;

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Zero};

use super::field::{PrimeField, Residue};
use crate::number::lehmer::{self, Remainders};
use crate::{Int, budget};

/// How much larger than numerator times denominator the modulus must be, before its bit length: the chance that a
/// number that is not determined yet passes for one is about the reciprocal of this.
const SLACK: i64 = 1 << 12;

/// Integers under keys of type `K`, known modulo a product of primes; what has no entry is zero.
#[derive(Clone, Debug)]
pub(crate) struct Chinese<K> {
    modulus: Int,
    /// Representatives in 0 … modulus − 1.
    residues: BTreeMap<K, Int>,
    /// The number of primes.
    primes: usize,
    /// From this many primes on, rational numbers are looked for again.
    due: usize,
}

/// Rational numbers under keys of type `K`: numerators, and one denominator for all.
pub(crate) type Rationals<K> = (Vec<(K, Int)>, Int);

impl<K: Ord + Clone> Chinese<K> {
    /// Nothing known: the modulus is 1.
    pub(crate) fn new() -> Self {
        Self { modulus: Int::one(), residues: BTreeMap::new(), primes: 0, due: 0 }
    }

    /// Adds the image modulo a prime that was not used before: a step of Garner (*The residue number system*, 1959), linear in the
    /// length of the modulus for each entry.
    pub(crate) fn absorb(&mut self, field: &PrimeField, image: &BTreeMap<K, Residue>) {
        let Some(inverse) = field.invert(self.modulus.modulo(field)) else { return };
        for key in image.keys() {
            if !self.residues.contains_key(key) {
                self.residues.insert(key.clone(), Int::zero());
            }
        }
        budget::spend(self.residues.len() as u64 * (self.modulus.bits() / 64 + 1));
        for (key, residue) in &mut self.residues {
            let target = image.get(key).copied().unwrap_or_default();
            let digit = field.mul(field.sub(target, residue.modulo(field)), inverse);
            if !digit.is_zero() {
                *residue += &self.modulus * Int::from(field.representative(digit));
            }
        }
        self.modulus *= Int::from(field.modulus());
        self.primes += 1;
    }

    /// The product of the primes.
    pub(crate) fn modulus(&self) -> &Int {
        &self.modulus
    }

    /// The integers of least absolute value that have this image.
    pub(crate) fn symmetric(&self) -> BTreeMap<K, Int> {
        let half = &self.modulus / Int::from(2);
        let least = |residue: &Int| if *residue > half { residue - &self.modulus } else { residue.clone() };
        self.residues.iter().map(|(key, residue)| (key.clone(), least(residue))).collect()
    }

    /// The rational numbers that have this image, if the modulus is large enough to tell, over their common denominator.
    ///
    /// Entries are tried with the least common denominator so far, then alone by the maximal quotient (Monagan,
    /// *Maximal quotient rational reconstruction*, 2004). The result is very likely right; its reader checks it. After a
    /// failure nothing is tried until there are an eighth more primes, so that all failures together cost about as much as
    /// the success.
    pub(crate) fn reconstruct(&mut self) -> Option<Rationals<K>> {
        if self.primes < self.due {
            return None;
        }
        self.due = self.primes + 1 + self.primes / 8;
        let threshold = Int::from(SLACK) * Int::from(self.modulus.bits());
        let half = &self.modulus / Int::from(2);
        let words = self.modulus.bits() / 64 + 1;
        let mut denominator = Int::one();
        let mut found: Vec<(&K, Int, Int)> = Vec::with_capacity(self.residues.len());
        for (key, residue) in &self.residues {
            budget::spend(words + words * words / 16);
            let mut scaled = (residue * &denominator).mod_floor(&self.modulus);
            if scaled > half {
                scaled -= &self.modulus;
            }
            if scaled.bits() + denominator.bits() + threshold.bits() >= self.modulus.bits() {
                let (numerator, own) = maximal_quotient(residue, &self.modulus, &threshold)?;
                let common = denominator.lcm(&own);
                scaled = numerator * (&common / &own);
                denominator = common;
            }
            found.push((key, scaled, denominator.clone()));
        }
        let over_common = |(key, numerator, own): (&K, Int, Int)| {
            let numerator = if own == denominator { numerator } else { numerator * (&denominator / &own) };
            (key.clone(), numerator)
        };
        Some((found.into_iter().map(over_common).collect(), denominator))
    }
}

/// The image of an integer in a prime field.
pub(crate) trait Modulo {
    /// `self` modulo p.
    fn modulo(&self, field: &PrimeField) -> Residue;
}

impl Modulo for Int {
    fn modulo(&self, field: &PrimeField) -> Residue {
        match self.big() {
            Some(value) => field.residue_of_big(value),
            None => field.residue(self.small().unwrap_or_default()),
        }
    }
}

/// The fraction n/d ≡ `residue` in lowest terms with the smallest |n|·d, if that is below `modulus / threshold`.
fn maximal_quotient(residue: &Int, modulus: &Int, threshold: &Int) -> Option<(Int, Int)> {
    // Smaller quotients are no candidates, so that many steps can be taken together.
    let small = threshold.small().map_or(u64::MAX, i64::unsigned_abs);
    if residue.is_zero() {
        return (modulus > threshold).then(|| (Int::zero(), Int::one()));
    }
    let mut best: Option<(Int, Int)> = None;
    let mut largest = threshold.clone();
    let mut remainders = Remainders::new(&modulus.to_big(), &residue.to_big());
    // The factors of `residue` in both remainders; their signs alternate.
    let (mut factors, mut negative) = ([Vec::new(), vec![1]], false);
    while !remainders.low().is_zero() && remainders.bits() >= largest.bits() {
        if let Some(steps) = remainders.advance(small) {
            steps.apply(&mut factors);
            negative ^= steps.is_odd();
            continue;
        }
        let (numerator, denominator) = (remainders.low(), lehmer::from_words(&factors[1]));
        let quotient = remainders.divide();
        let next = lehmer::from_words(&factors[0]) + &quotient * &denominator;
        let quotient = Int::from(BigInt::from(quotient));
        if quotient > largest {
            let numerator = Int::from(BigInt::from(numerator));
            let numerator = if negative { -numerator } else { numerator };
            best = Some((numerator, Int::from(BigInt::from(denominator))));
            largest = quotient;
        }
        factors.swap(0, 1);
        factors[1] = next.iter_u64_digits().collect();
        negative = !negative;
    }
    best.filter(|(numerator, denominator)| numerator.gcd(denominator).is_one())
}

#[cfg(test)]
mod tests {
    use num_traits::Signed;
    use proptest::prelude::*;

    use super::*;
    use crate::Rational;

    fn image(field: &PrimeField, value: &Rational) -> Residue {
        let inverse = field.invert(value.denom().modulo(field)).unwrap();
        field.mul(value.numer().modulo(field), inverse)
    }

    proptest! {
        #[test]
        fn rationals_come_back(entries in prop::collection::vec((any::<i64>(), 1..i64::MAX), 1..5)) {
            let values: Vec<Rational> =
                entries.iter().map(|&(n, d)| Rational::new(Int::from(n), Int::from(d))).collect();
            let mut fields = PrimeField::sequence();
            let first = fields.next().unwrap();
            let images = |field: &PrimeField| values.iter().map(|value| image(field, value)).enumerate().collect();
            let mut chinese = Chinese::new();
            for field in [first].into_iter().chain(fields.take(3)) {
                chinese.absorb(&field, &images(&field));
            }
            let (numerators, denominator) = chinese.reconstruct().unwrap();
            let found = numerators.into_iter().map(|(key, value)| (key, Rational::new(value, denominator.clone())));
            prop_assert_eq!(found.collect::<Vec<_>>(), values.into_iter().enumerate().collect::<Vec<_>>());
        }

        #[test]
        fn the_maximal_quotient_is_nearly_the_best_fraction(residue in 0_i64..1_000_003) {
            let modulus = 1_000_003;
            let found = maximal_quotient(&Int::from(residue), &Int::from(modulus), &Int::from(40));
            let size = |(numerator, denominator): &(Int, Int)| numerator.abs().max(Int::one()) * denominator;
            for d in 1..100_i64 {
                let n = (residue * d + modulus / 2).rem_euclid(modulus) - modulus / 2;
                // By Monagan's theorem, what is three times smaller than the modulus over the threshold must be seen.
                if n.abs().max(1) * d < modulus / 120 {
                    let found = found.as_ref().expect("a fraction that is small enough");
                    prop_assert!(size(found) <= Int::from(3 * n.abs().max(1) * d));
                    prop_assert!((&found.0 - &found.1 * Int::from(residue)).is_multiple_of(&Int::from(modulus)));
                }
            }
        }
    }

    #[test]
    fn too_small_a_modulus_tells_nothing() {
        let field = PrimeField::sequence().next().unwrap();
        let value = Rational::new(Int::from(6_700_417_000_007_i64), Int::from(2_147_483_647_i64));
        let mut chinese = Chinese::new();
        chinese.absorb(&field, &BTreeMap::from([(0, image(&field, &value))]));
        assert_eq!(chinese.reconstruct(), None);
    }
}
