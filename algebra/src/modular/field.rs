//! The prime fields F_p for word-sized p, with Montgomery's multiplication.

use num_bigint::{BigInt, Sign};

use super::montgomery::Montgomery;
use super::prime::primes;
#[cfg(test)]
use super::prime::{PRIME_LIMIT, is_prime};

/// An element of a [`PrimeField`]: only the field that made it can read it, since it is kept as x·2⁶⁴ modulo p.
///
/// Two residues of one field are equal if and only if they are the same element; the default is zero.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct Residue(u64);

impl Residue {
    /// The zero of every prime field.
    pub(crate) const ZERO: Self = Self(0);

    /// Whether this is zero.
    pub(crate) fn is_zero(self) -> bool {
        self.0 == 0
    }
}

/// The field F_p for an odd prime p below 2⁶².
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PrimeField {
    ring: Montgomery,
}

impl PrimeField {
    /// The field with `modulus` elements; `None` unless the modulus is an odd prime below 2⁶².
    #[cfg(test)]
    pub(crate) fn new(modulus: u64) -> Option<Self> {
        (modulus > 2 && modulus < PRIME_LIMIT && is_prime(modulus)).then(|| Self::with_prime(modulus))
    }

    /// The fields of all [`primes`], in their order.
    pub(crate) fn sequence() -> impl Iterator<Item = Self> {
        primes().map(Self::with_prime)
    }

    fn with_prime(modulus: u64) -> Self {
        Self { ring: Montgomery::new(modulus) }
    }

    /// The prime p.
    pub(crate) fn modulus(&self) -> u64 {
        self.ring.modulus()
    }

    /// The element 1.
    pub(crate) fn one(&self) -> Residue {
        Residue(self.ring.one())
    }

    /// The image of an unsigned integer.
    pub(crate) fn residue_of_word(&self, value: u64) -> Residue {
        Residue(self.ring.element(value))
    }

    /// The image of an integer.
    pub(crate) fn residue(&self, value: i64) -> Residue {
        let magnitude = self.residue_of_word(value.unsigned_abs());
        if value < 0 { self.neg(magnitude) } else { magnitude }
    }

    /// The image of an integer of any size, in time linear in its length.
    pub(crate) fn residue_of_big(&self, value: &BigInt) -> Residue {
        // From the least significant digit up, Montgomery's reduction divides by 2⁶⁴ for each.
        let (mut sum, mut digits) = (0, 0);
        for digit in value.iter_u64_digits() {
            sum = self.ring.reduce(u128::from(sum) + u128::from(digit));
            digits += 1;
        }
        let remainder = Residue(self.ring.mul(sum, self.ring.pow(self.ring.radix(), digits + 1)));
        if value.sign() == Sign::Minus { self.neg(remainder) } else { remainder }
    }

    /// The representative of an element in 0 … p − 1.
    pub(crate) fn representative(&self, a: Residue) -> u64 {
        self.ring.representative(a.0)
    }

    /// a + b.
    pub(crate) fn add(&self, a: Residue, b: Residue) -> Residue {
        let sum = a.0 + b.0;
        Residue(if sum >= self.modulus() { sum - self.modulus() } else { sum })
    }

    /// a − b.
    pub(crate) fn sub(&self, a: Residue, b: Residue) -> Residue {
        let (difference, borrow) = a.0.overflowing_sub(b.0);
        Residue(if borrow { difference.wrapping_add(self.modulus()) } else { difference })
    }

    /// −a.
    pub(crate) fn neg(&self, a: Residue) -> Residue {
        self.sub(Residue::ZERO, a)
    }

    /// a·b.
    pub(crate) fn mul(&self, a: Residue, b: Residue) -> Residue {
        Residue(self.ring.mul(a.0, b.0))
    }

    /// a^exponent, with 0⁰ = 1, in O(log exponent) products.
    pub(crate) fn pow(&self, a: Residue, exponent: u64) -> Residue {
        Residue(self.ring.pow(a.0, exponent))
    }

    /// 1/a, or `None` for zero; by the extended Euclidean algorithm.
    pub(crate) fn invert(&self, a: Residue) -> Option<Residue> {
        if a.is_zero() {
            return None;
        }
        let (mut high, mut low) = (self.modulus(), self.representative(a));
        let (mut high_factor, mut low_factor) = (0_i64, 1_i64);
        while low != 0 {
            let quotient = high / low;
            (high, low) = (low, high % low);
            (high_factor, low_factor) =
                (low_factor, high_factor.wrapping_sub((quotient as i64).wrapping_mul(low_factor)));
        }
        // `high` is 1, and |high_factor| < p.
        Some(self.residue(high_factor))
    }

    /// A square root of `a`, the one with the smaller representative, or `None` if `a` is not a square.
    ///
    /// Tonelli's and Shanks's algorithm (Cohen, *A Course in Computational Algebraic Number Theory*, 1.5.1).
    pub(crate) fn sqrt(&self, a: Residue) -> Option<Residue> {
        if a.is_zero() {
            return Some(a);
        }
        let half = (self.modulus() - 1) / 2;
        if self.pow(a, half) != self.one() {
            return None;
        }
        let twos = (self.modulus() - 1).trailing_zeros();
        let odd = (self.modulus() - 1) >> twos;
        let mut root = self.pow(a, odd.div_ceil(2));
        let mut defect = self.pow(a, odd);
        if twos > 1 {
            let non_residue =
                (2..).map(|n| self.residue_of_word(n)).find(|&n| self.pow(n, half) != self.one());
            let mut generator = self.pow(non_residue.unwrap_or(self.one()), odd);
            let mut order = twos;
            // Invariant: root² = a·defect, and `defect` has order 2^k with k < `order`, that of `generator`.
            while defect != self.one() {
                let mut exponent = 0;
                let mut power = defect;
                while power != self.one() {
                    power = self.mul(power, power);
                    exponent += 1;
                }
                for _ in 0..order - exponent - 1 {
                    generator = self.mul(generator, generator);
                }
                root = self.mul(root, generator);
                generator = self.mul(generator, generator);
                defect = self.mul(defect, generator);
                order = exponent;
            }
        }
        let other = self.neg(root);
        Some(if self.representative(root) <= self.representative(other) { root } else { other })
    }
}

#[cfg(test)]
mod tests {
    use num_bigint::BigInt;
    use proptest::prelude::*;

    use super::*;

    fn fields() -> impl Strategy<Value = PrimeField> {
        prop::sample::select(vec![3, 5, 17, 97, 65_537, 1_000_003, 4_179_340_454_199_820_289, (1 << 62) - 57])
            .prop_map(|prime| PrimeField::new(prime).unwrap())
    }

    #[test]
    fn refuses_what_is_not_a_suitable_prime() {
        for modulus in [0, 1, 2, 9, 1 << 62, 18_446_744_073_709_551_557] {
            assert_eq!(PrimeField::new(modulus), None, "{modulus}");
        }
    }

    #[test]
    fn squares_of_small_fields() {
        for prime in [3, 5, 7, 13, 17, 41, 97, 193, 257] {
            let field = PrimeField::new(prime).unwrap();
            for value in 0..prime {
                let square = (0..prime).find(|root| root * root % prime == value);
                let root = field.sqrt(field.residue_of_word(value)).map(|root| field.representative(root));
                assert_eq!(root, square, "{value} modulo {prime}");
            }
        }
    }

    proptest! {
        #[test]
        fn arithmetic_is_that_of_the_integers(field in fields(), a: i64, b: i64) {
            let p = i128::from(field.modulus());
            let image = |value: i128| value.rem_euclid(p) as u64;
            let (x, y) = (field.residue(a), field.residue(b));
            let (a, b) = (i128::from(a), i128::from(b));
            prop_assert_eq!(field.representative(x), image(a));
            prop_assert_eq!(field.representative(field.add(x, y)), image(a + b));
            prop_assert_eq!(field.representative(field.sub(x, y)), image(a - b));
            prop_assert_eq!(field.representative(field.mul(x, y)), image(a * b));
            prop_assert_eq!(field.pow(x, 3), field.mul(x, field.mul(x, x)));
            prop_assert_eq!(field.invert(x).map(|inverse| field.mul(inverse, x)), (!x.is_zero()).then(|| field.one()));
            let root = field.sqrt(field.mul(x, x)).unwrap();
            prop_assert!(root == x || root == field.neg(x));
        }

        #[test]
        fn big_integers_have_the_right_image(field in fields(), digits: Vec<u32>, negative: bool) {
            let sign = if negative { num_bigint::Sign::Minus } else { num_bigint::Sign::Plus };
            let value = BigInt::from_slice(sign, &digits);
            let modulus = BigInt::from(field.modulus());
            let expected = ((&value % &modulus) + &modulus) % &modulus;
            prop_assert_eq!(BigInt::from(field.representative(field.residue_of_big(&value))), expected);
        }
    }
}
