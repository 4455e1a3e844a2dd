//! Cells in which products of coefficients accumulate.

use num_bigint::{BigInt, Sign};
use num_integer::Integer;
use num_traits::Zero;

use crate::Int;

/// An integer under accumulation: of a fixed width where all sums fit, else an [`Int`].
pub(crate) trait Cell: Clone + Default {
    /// The cell that holds a coefficient, which fits.
    fn of(coefficient: &Int) -> Self;
    /// Adds `a·b`.
    fn add_product(&mut self, a: &Self, b: &Self);
    /// Whether it holds zero.
    fn is_nothing(&self) -> bool;
    /// What it holds.
    fn finish(self) -> Int;
}

/// A cell in which remainders can be formed as well.
pub(crate) trait DivisibleCell: Cell {
    /// Bits that no value of the cell may have.
    const WIDTH: u64;
    /// Minus the quotient by `divisor`, which is not zero, if that is an integer.
    fn negated_quotient(&self, divisor: &Self) -> Option<Self>;
    /// The bits of the absolute value.
    fn bits(&self) -> u64;
}

macro_rules! divisible_word {
    ($Word:ty) => {
        impl DivisibleCell for $Word {
            const WIDTH: u64 = <$Word>::BITS as u64 - 1;

            #[inline]
            fn negated_quotient(&self, divisor: &$Word) -> Option<$Word> {
                // Neither is the smallest value of the type.
                match divisor {
                    1 => Some(-self),
                    _ if self % divisor == 0 => Some(-(self / divisor)),
                    _ => None,
                }
            }

            #[inline]
            fn bits(&self) -> u64 {
                u64::from(<$Word>::BITS - self.unsigned_abs().leading_zeros())
            }
        }
    };
}

divisible_word!(i64);
divisible_word!(i128);

impl DivisibleCell for Int {
    const WIDTH: u64 = u64::MAX;

    fn negated_quotient(&self, divisor: &Int) -> Option<Int> {
        let (quotient, remainder) = self.div_rem(divisor);
        remainder.is_zero().then(|| -quotient)
    }

    fn bits(&self) -> u64 {
        Int::bits(self)
    }
}

impl Cell for i64 {
    #[inline]
    fn of(coefficient: &Int) -> i64 {
        coefficient.small().unwrap_or_default()
    }

    #[inline]
    fn add_product(&mut self, a: &i64, b: &i64) {
        *self = self.wrapping_add(a.wrapping_mul(*b));
    }

    #[inline]
    fn is_nothing(&self) -> bool {
        *self == 0
    }

    #[inline]
    fn finish(self) -> Int {
        self.into()
    }
}

impl Cell for i128 {
    #[inline]
    fn of(coefficient: &Int) -> i128 {
        match coefficient.small() {
            Some(small) => small.into(),
            None => i128::try_from(coefficient.to_big()).unwrap_or_default(),
        }
    }

    #[inline]
    fn add_product(&mut self, a: &i128, b: &i128) {
        *self = self.wrapping_add(a.wrapping_mul(*b));
    }

    #[inline]
    fn is_nothing(&self) -> bool {
        *self == 0
    }

    #[inline]
    fn finish(self) -> Int {
        self.into()
    }
}

/// An integer of `N` words in two's complement, the lowest one first.
///
/// Products are taken modulo 2^(64·N), by the schoolbook method (Knuth, vol. 2, 4.3.1, algorithm M), so signs need no attention:
/// some N²/2 products of words. Faster methods need more words to gain anything, and an [`Int`] would be allocated for each
/// product.
#[derive(Clone)]
pub(crate) struct Wide<const N: usize>([u64; N]);

impl<const N: usize> Default for Wide<N> {
    fn default() -> Wide<N> {
        Wide([0; N])
    }
}

impl<const N: usize> Cell for Wide<N> {
    fn of(coefficient: &Int) -> Wide<N> {
        let mut words = [0; N];
        if let Some(small) = coefficient.small() {
            words = [if small < 0 { u64::MAX } else { 0 }; N];
            words[0] = small.cast_unsigned();
            return Wide(words);
        }
        let big = coefficient.to_big();
        for (word, digit) in words.iter_mut().zip(big.iter_u64_digits()) {
            *word = digit;
        }
        if big.sign() == Sign::Minus { Wide(negated(words)) } else { Wide(words) }
    }

    fn add_product(&mut self, a: &Wide<N>, b: &Wide<N>) {
        let mut i = 0;
        while i < N {
            let factor = u128::from(a.0[i]);
            let (mut carry, mut j) = (0_u64, 0);
            while i + j < N {
                // At most (2⁶⁴ − 1)² + 2·(2⁶⁴ − 1) = 2¹²⁸ − 1.
                let sum = factor * u128::from(b.0[j]) + u128::from(self.0[i + j]) + u128::from(carry);
                self.0[i + j] = sum as u64;
                carry = (sum >> 64) as u64;
                j += 1;
            }
            i += 1;
        }
    }

    fn is_nothing(&self) -> bool {
        self.0.iter().all(|word| *word == 0)
    }

    fn finish(self) -> Int {
        let negative = self.0[N - 1] >> 63 == 1;
        let words = if negative { negated(self.0) } else { self.0 };
        let halves: Vec<u32> = words.iter().flat_map(|word| [*word as u32, (word >> 32) as u32]).collect();
        BigInt::from_slice(if negative { Sign::Minus } else { Sign::Plus }, &halves).into()
    }
}

/// The two's complement.
fn negated<const N: usize>(words: [u64; N]) -> [u64; N] {
    let mut carry = true;
    words.map(|word| {
        let (negated, overflow) = (!word).overflowing_add(u64::from(carry));
        carry = overflow;
        negated
    })
}

impl Cell for Int {
    fn of(coefficient: &Int) -> Int {
        coefficient.clone()
    }

    fn add_product(&mut self, a: &Int, b: &Int) {
        *self += a * b;
    }

    fn is_nothing(&self) -> bool {
        self.is_zero()
    }

    fn finish(self) -> Int {
        self
    }
}
