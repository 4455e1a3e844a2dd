//! From images modulo primes back to rational numbers.

use std::collections::BTreeMap;

use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use super::field::{PrimeField, Residue};
use crate::{Int, Rational, budget};

/// How much larger than numerator times denominator the modulus must be, before its bit length: the chance that a
/// number that is not determined yet passes for one is about the reciprocal of this.
const SLACK: i64 = 1 << 12;

/// Integers under keys of type `K`, known modulo a product of primes; what has no entry is zero.
#[derive(Clone, Debug)]
pub(crate) struct Chinese<K> {
    modulus: Int,
    /// Representatives in 0 … modulus − 1.
    residues: BTreeMap<K, Int>,
}

impl<K: Ord + Clone> Chinese<K> {
    /// Nothing known: the modulus is 1.
    pub(crate) fn new() -> Self {
        Self { modulus: Int::one(), residues: BTreeMap::new() }
    }

    /// Adds the image modulo a prime that was not used before (Garner's step).
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

    /// The rational numbers that have this image, if the modulus is large enough to tell.
    ///
    /// Entries are tried with the least common denominator so far, then alone by the maximal quotient (Monagan,
    /// *Maximal quotient rational reconstruction*, 2004). The result is very likely right; its reader checks it.
    pub(crate) fn reconstruct(&self) -> Option<Vec<(K, Rational)>> {
        let threshold = Int::from(SLACK) * Int::from(self.modulus.bits());
        let half = &self.modulus / Int::from(2);
        let mut denominator = Int::one();
        let mut result = Vec::with_capacity(self.residues.len());
        let words = self.modulus.bits() / 64 + 1;
        for (key, residue) in &self.residues {
            budget::spend(words * words * 16);
            let mut scaled = (residue * &denominator).mod_floor(&self.modulus);
            if scaled > half {
                scaled -= &self.modulus;
            }
            if scaled.abs() * &denominator * &threshold < self.modulus {
                result.push((key.clone(), Rational::new(scaled, denominator.clone())));
                continue;
            }
            let value = maximal_quotient(residue, &self.modulus, &threshold)?;
            denominator = denominator.lcm(value.denom());
            result.push((key.clone(), value));
        }
        Some(result)
    }
}

/// The image of an integer in a prime field.
pub(crate) trait Modulo {
    /// `self` modulo p.
    fn modulo(&self, field: &PrimeField) -> Residue;
}

impl Modulo for Int {
    fn modulo(&self, field: &PrimeField) -> Residue {
        match self.small() {
            Some(value) => field.residue(value),
            None => field.residue_of_big(&self.to_big()),
        }
    }
}

/// The fraction n/d ≡ `residue` with the smallest |n|·d, if that is below `modulus / threshold`.
fn maximal_quotient(residue: &Int, modulus: &Int, threshold: &Int) -> Option<Rational> {
    if residue.is_zero() {
        return (modulus > threshold).then(Rational::zero);
    }
    let mut best: Option<(Int, Int)> = None;
    let mut largest = threshold.clone();
    let (mut high, mut low) = (modulus.clone(), residue.clone());
    let (mut high_factor, mut low_factor) = (Int::zero(), Int::one());
    while !low.is_zero() && high > largest {
        let (quotient, rest) = high.div_rem(&low);
        if quotient > largest {
            best = Some((low.clone(), low_factor.clone()));
            largest = quotient.clone();
        }
        let factor = &high_factor - &(&quotient * &low_factor);
        (high, low) = (low, rest);
        (high_factor, low_factor) = (low_factor, factor);
    }
    let (numerator, denominator) = best?;
    numerator.gcd(&denominator).is_one().then(|| Rational::new(numerator, denominator))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

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
            prop_assert_eq!(chinese.reconstruct(), Some(values.into_iter().enumerate().collect()));
        }

        #[test]
        fn the_maximal_quotient_is_nearly_the_best_fraction(residue in 0_i64..1_000_003) {
            let modulus = 1_000_003;
            let found = maximal_quotient(&Int::from(residue), &Int::from(modulus), &Int::from(40));
            let size = |value: &Rational| value.numer().abs().max(Int::one()) * value.denom();
            for d in 1..100_i64 {
                let n = (residue * d + modulus / 2).rem_euclid(modulus) - modulus / 2;
                // By Monagan's theorem, what is three times smaller than the modulus over the threshold must be seen.
                if n.abs().max(1) * d < modulus / 120 {
                    let found = found.as_ref().expect("a fraction that is small enough");
                    prop_assert!(size(found) <= Int::from(3 * n.abs().max(1) * d));
                    prop_assert!((found.numer() - found.denom() * Int::from(residue)).is_multiple_of(&Int::from(modulus)));
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
