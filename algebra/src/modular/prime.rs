//! Word-sized primes: a deterministic test and one fixed, descending sequence.

use std::sync::{Mutex, PoisonError};

use super::montgomery::Montgomery;

/// The sequence of [`primes`] starts below this power of two, so that the sum of two residues never overflows a word.
pub(crate) const PRIME_LIMIT: u64 = 1 << 62;

/// `PRIME_LIMIT - p` for the first primes p of the sequence; a test compares the table with the search.
const FIRST_GAPS: [u64; 24] = [
    57, 87, 117, 143, 153, 167, 171, 195, 203, 273, 287, 317, 443, 483, 495, 575, 581, 603, 633, 663, 765,
    773, 777, 791,
];

/// The primes after those of the table that have been searched so far, in their order.
static SEARCHED: Mutex<Vec<u64>> = Mutex::new(Vec::new());

/// Decides whether `n` below 2⁶³ is prime.
///
/// After trial divisions, strong pseudoprime tests (Miller, Rabin) to the first twelve prime bases, which decide every n below
/// 3.18·10²³ (Sorenson and Webster, *Strong pseudoprimes to twelve prime bases*, 2017). At most twelve modular powers; most
/// composite numbers take none or one.
pub(crate) fn is_prime(n: u64) -> bool {
    const BASES: [u64; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    const FURTHER: [u64; 13] = [41, 43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89, 97];
    if n < 2 {
        return false;
    }
    for divisor in BASES.into_iter().chain(FURTHER) {
        if n.is_multiple_of(divisor) {
            return n == divisor;
        }
    }
    let ring = Montgomery::new(n);
    let (one, minus_one) = (ring.one(), ring.element(n - 1));
    let twos = (n - 1).trailing_zeros();
    let odd = (n - 1) >> twos;
    BASES.iter().all(|&base| {
        let mut power = ring.pow(ring.element(base), odd);
        if power == one || power == minus_one {
            return true;
        }
        for _ in 1..twos {
            power = ring.mul(power, power);
            if power == minus_one {
                return true;
            }
        }
        false
    })
}

/// The price of trying a prime of the sequence, in units of work: those beyond the table have to be found, with a square root
/// modulo each.
pub(crate) fn price(prime: u64) -> u64 {
    if prime >= PRIME_LIMIT - FIRST_GAPS[FIRST_GAPS.len() - 1] { 100 } else { 600 }
}

/// All odd primes below 2⁶² in descending order: the moduli of every modular algorithm, always tried in this order.
///
/// The first of them are tabulated, the others are searched on demand (some twenty candidates for each) and remembered.
pub(crate) fn primes() -> impl Iterator<Item = u64> {
    FIRST_GAPS.iter().map(|gap| PRIME_LIMIT - gap).chain((0..).map_while(searched))
}

/// The prime at `place` of those after the table.
fn searched(place: usize) -> Option<u64> {
    // Nothing unwinds with the lock.
    let mut known = SEARCHED.lock().unwrap_or_else(PoisonError::into_inner);
    while known.len() <= place {
        let last = known.last().copied().unwrap_or(PRIME_LIMIT - FIRST_GAPS[FIRST_GAPS.len() - 1]);
        known.push(odd_primes_below(last).next()?);
    }
    Some(known[place])
}

/// The odd primes below an odd `limit`, descending, by search.
fn odd_primes_below(limit: u64) -> impl Iterator<Item = u64> {
    (3..limit).rev().filter(|n| !n.is_multiple_of(2)).filter(|&n| is_prime(n))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_the_sieve() {
        let limit = 20_000_usize;
        let mut composite = vec![false; limit];
        for n in 2..limit {
            assert_eq!(is_prime(n as u64), !composite[n], "{n}");
            (n * n..limit).step_by(n).for_each(|multiple| composite[multiple] = true);
        }
    }

    #[test]
    fn pseudoprimes_and_large_numbers() {
        for strong_pseudoprime in
            [2047, 1_373_653, 25_326_001, 3_215_031_751, 341_550_071_728_321, 3_825_123_056_546_413_051]
        {
            assert!(!is_prime(strong_pseudoprime), "{strong_pseudoprime}");
        }
        assert!(is_prime(9_223_372_036_854_775_783));
        assert!(!is_prime(u64::MAX / 2));
    }

    #[test]
    fn the_table_is_what_the_search_finds() {
        let found: Vec<u64> = odd_primes_below(PRIME_LIMIT).take(FIRST_GAPS.len()).collect();
        let gaps: Vec<u64> = found.iter().map(|prime| PRIME_LIMIT - prime).collect();
        assert_eq!(gaps, FIRST_GAPS);
        let beyond: Vec<u64> = primes().take(FIRST_GAPS.len() + 2).collect();
        assert!(beyond.is_sorted_by(|a, b| a > b) && beyond.iter().all(|&prime| is_prime(prime)));
    }
}
