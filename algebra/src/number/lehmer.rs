//! Euclid's algorithm on large integers, many steps at a time.

use num_bigint::{BigInt, BigUint};
use num_integer::Integer;

use crate::budget;

/// Two successive remainders of Euclid's algorithm, the larger one first, as words with the least significant one first.
///
/// Lehmer's method (*Euclid's algorithm for large numbers*, 1938): the first words of both decide many quotients together, as
/// long as Collins's condition holds (Jebelean, *A double-digit Lehmer–Euclid algorithm*, 1995), and all their steps are one
/// pass over the other words. Complexity: quadratic, some 2 ns for each pair of words, where the binary gcd of `num-bigint` takes
/// thirty times as much.
#[derive(Clone, Debug)]
pub(crate) struct Remainders {
    high: Vec<u64>,
    low: Vec<u64>,
}

/// Successive steps of Euclid's algorithm: the matrix that takes two remainders to two later ones, up to its signs, which alternate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Steps {
    /// The factors of the larger number and of the smaller one, for the first of the later remainders and for the second.
    rows: [[u64; 2]; 2],
    /// Whether the number of steps is even.
    even: bool,
}

impl Remainders {
    /// The sequence that begins with the absolute values of both.
    pub(crate) fn new(a: &BigInt, b: &BigInt) -> Remainders {
        let (high, low) = if a.magnitude() < b.magnitude() { (b, a) } else { (a, b) };
        Remainders { high: high.iter_u64_digits().collect(), low: low.iter_u64_digits().collect() }
    }

    /// The larger remainder.
    pub(crate) fn high(&self) -> BigUint {
        from_words(&self.high)
    }

    /// The smaller remainder.
    pub(crate) fn low(&self) -> BigUint {
        from_words(&self.low)
    }

    /// The bits of the larger remainder.
    pub(crate) fn bits(&self) -> u64 {
        let last = self.high.last().map_or(0, |word| word.leading_zeros());
        64 * self.high.len() as u64 - u64::from(last)
    }

    /// Takes as many steps as the first words tell, up to the first quotient that exceeds `most`; `None` if they tell none.
    pub(crate) fn advance(&mut self, most: u64) -> Option<Steps> {
        let steps = Steps::of(&self.high, &self.low, most)?;
        budget::spend(8 + self.high.len() as u64 / 8);
        let (mut first, mut second) = (0_i128, 0_i128);
        let [[a, b], [c, d]] = steps.rows.map(|row| row.map(i128::from));
        // The factors are below 2³², since they are bounded by the first words over later remainders: no sum leaves 128 bits.
        let sign = if steps.even { 1 } else { -1 };
        for (i, high) in self.high.iter_mut().enumerate() {
            let low = self.low.get(i).copied().unwrap_or_default();
            let (x, y) = (i128::from(*high), i128::from(low));
            first += sign * (a * x - b * y);
            second += sign * (d * y - c * x);
            // The low 64 bits.
            *high = first as u64;
            if let Some(low) = self.low.get_mut(i) {
                *low = second as u64;
            } else {
                self.low.push(second as u64);
            }
            first >>= 64;
            second >>= 64;
        }
        trim(&mut self.high);
        trim(&mut self.low);
        Some(steps)
    }

    /// Takes one step, and gives its quotient; the smaller remainder is not zero.
    pub(crate) fn divide(&mut self) -> BigUint {
        budget::spend(8 + (self.high.len() as u64 - self.low.len() as u64) * self.low.len() as u64 / 8);
        let (quotient, rest) = self.high().div_rem(&self.low());
        self.high = std::mem::replace(&mut self.low, rest.iter_u64_digits().collect());
        quotient
    }

    /// The greatest common divisor.
    pub(crate) fn gcd(mut self) -> BigUint {
        while self.low.len() > 1 {
            if self.advance(u64::MAX).is_none() {
                self.divide();
            }
        }
        let [last] = self.low.as_slice() else { return self.high() };
        let last = *last;
        let rest = self.high() % last;
        let (mut a, mut b) = (last, rest.iter_u64_digits().next().unwrap_or(0));
        while b != 0 {
            (a, b) = (b, a % b);
        }
        a.into()
    }
}

impl Steps {
    /// The steps that the first words of two remainders decide; `None` if they decide none.
    fn of(high: &[u64], low: &[u64], most: u64) -> Option<Steps> {
        let count = high.len();
        if let ([high], [low]) = (high, low) {
            return Steps::of_words(*high, *low, most);
        }
        if count < 2 || low.len() + 1 < count {
            return None;
        }
        let shift = high[count - 1].leading_zeros();
        let window = |words: &[u64]| {
            let word = |i: usize| words.get(i).copied().unwrap_or_default();
            let pair = u128::from(word(count - 1)) << 64 | u128::from(word(count - 2));
            // The upper word of what is left.
            (pair << shift >> 64) as u64
        };
        let (mut x, mut y) = (window(high), window(low));
        // The rows lag one step behind, which Collins's condition certifies.
        let mut even = false;
        let (mut first, mut second, mut third) = ([0, 0], [1, 0], [0, 1]);
        while y >= third[1] && x - y >= second[1] + third[1] {
            // Four quotients of ten are 1, and a division is slow.
            let (quotient, rest) = if x - y < y { (1, x - y) } else { (x / y, x % y) };
            if quotient > most {
                break;
            }
            (x, y) = (y, rest);
            let next = [second[0] + quotient * third[0], second[1] + quotient * third[1]];
            (first, second, third) = (second, third, next);
            even = !even;
        }
        (first[1] != 0).then_some(Steps { rows: [first, second], even })
    }

    /// The steps of two remainders that are words, as long as the factors are half as long.
    fn of_words(mut x: u64, mut y: u64, most: u64) -> Option<Steps> {
        let mut steps = Steps { rows: [[1, 0], [0, 1]], even: true };
        while y != 0 {
            let (quotient, rest) = (x / y, x % y);
            let [first, second] = steps.rows;
            let next = [0, 1].map(|i| quotient.checked_mul(second[i])?.checked_add(first[i]));
            let [Some(a), Some(b)] = next else { break };
            if quotient > most || a.max(b) >> 32 != 0 {
                break;
            }
            steps = Steps { rows: [second, [a, b]], even: !steps.even };
            (x, y) = (y, rest);
        }
        (steps.rows[0][1] != 0).then_some(steps)
    }

    /// Whether the number of steps is odd.
    pub(crate) fn is_odd(&self) -> bool {
        !self.even
    }

    /// The same steps for the absolute values of a sequence with the same recurrence whose signs alternate, as the factors of the
    /// remainders do.
    pub(crate) fn apply(&self, pair: &mut [Vec<u64>; 2]) {
        let [[a, b], [c, d]] = self.rows.map(|row| row.map(u128::from));
        let [high, low] = pair;
        let count = high.len().max(low.len()) + 1;
        high.resize(count, 0);
        low.resize(count, 0);
        let (mut first, mut second) = (0_u128, 0_u128);
        for (high, low) in high.iter_mut().zip(low.iter_mut()) {
            let (x, y) = (u128::from(*high), u128::from(*low));
            first += a * x + b * y;
            second += c * x + d * y;
            (*high, *low) = (first as u64, second as u64);
            first >>= 64;
            second >>= 64;
        }
        trim(high);
        trim(low);
    }
}

/// The number with these words.
pub(crate) fn from_words(words: &[u64]) -> BigUint {
    BigUint::new(words.iter().flat_map(|word| [*word as u32, (word >> 32) as u32]).collect())
}

fn trim(words: &mut Vec<u64>) {
    while words.last() == Some(&0) {
        words.pop();
    }
}

#[cfg(test)]
mod tests {
    use num_bigint::Sign;
    use num_traits::{One, Zero};
    use proptest::prelude::*;

    use super::*;

    fn integers(words: usize) -> impl Strategy<Value = BigInt> {
        let digit = prop_oneof![any::<u32>(), Just(0), Just(u32::MAX), 0_u32..3];
        prop::collection::vec(digit, 0..2 * words).prop_map(|digits| BigInt::from_slice(Sign::Plus, &digits))
    }

    /// The remainders and the factors of the smaller number, by Euclid's algorithm step by step.
    fn naive(a: &BigInt, b: &BigInt) -> Vec<[BigInt; 2]> {
        let mut sequence = vec![[a.clone(), BigInt::zero()], [b.clone(), BigInt::one()]];
        while let [.., high, low] = sequence.as_slice()
            && !low[0].is_zero()
        {
            let quotient = &high[0] / &low[0];
            sequence.push([0, 1].map(|i| &high[i] - &quotient * &low[i]));
        }
        sequence
    }

    proptest! {
        #[test]
        fn gcds_agree_with_binary_ones(a in integers(12), b in integers(12), g in integers(8)) {
            for (a, b) in [(&a * &g, &b * &g), (a.clone(), b.clone()), (&a * &b + 1, a.clone())] {
                let found = Remainders::new(&a, &-&b).gcd();
                prop_assert_eq!(BigInt::from(found), a.gcd(&b));
            }
        }

        #[test]
        fn many_steps_are_those_of_euclid(a in integers(9), b in integers(9), most in 1_u64..1000) {
            let (a, b) = if a < b { (b, a) } else { (a, b) };
            let sequence = naive(&a, &b);
            let mut remainders = Remainders::new(&a, &b);
            let (mut factors, mut odd) = ([vec![], vec![1]], false);
            let mut place = 0;
            while let Some(steps) = remainders.advance(most) {
                steps.apply(&mut factors);
                odd ^= steps.is_odd();
                let found = [remainders.high(), remainders.low()].map(BigInt::from);
                let later = sequence[place + 1..].iter().position(|[remainder, _]| *remainder == found[0]);
                place += 1 + later.expect("a remainder of the sequence");
                prop_assert_eq!(&found[1], &sequence[place + 1][0]);
                let sign = |value: &[u64], negative: bool| {
                    let value = BigInt::from(from_words(value));
                    if negative { -value } else { value }
                };
                prop_assert_eq!(odd, place % 2 == 1);
                prop_assert_eq!(&sign(&factors[0], !odd), &sequence[place][1]);
                prop_assert_eq!(&sign(&factors[1], odd), &sequence[place + 1][1]);
            }
        }
    }
}
