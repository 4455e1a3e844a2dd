//! Multiplication without division.

/// The odd modulus n below 2⁶³ of a residue ring, whose elements x are kept as x·2⁶⁴ modulo n.
///
/// Montgomery, *Modular multiplication without trial division*, 1985.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Montgomery {
    modulus: u64,
    /// −n⁻¹ modulo 2⁶⁴.
    negated_inverse: u64,
    one: u64,
    /// 2¹²⁸ modulo n.
    radix_squared: u64,
}

impl Montgomery {
    /// The ring modulo an odd number below 2⁶³.
    pub(super) fn new(modulus: u64) -> Montgomery {
        // Newton's iteration doubles the number of correct low bits, of which n·n ≡ 1 (mod 8) gives three.
        let mut inverse = modulus;
        for _ in 0..5 {
            inverse = inverse.wrapping_mul(2_u64.wrapping_sub(modulus.wrapping_mul(inverse)));
        }
        let one = ((1_u128 << 64) % u128::from(modulus)) as u64;
        let radix_squared = (u128::from(one) * u128::from(one) % u128::from(modulus)) as u64;
        Montgomery { modulus, negated_inverse: inverse.wrapping_neg(), one, radix_squared }
    }

    /// The modulus.
    pub(super) fn modulus(&self) -> u64 {
        self.modulus
    }

    /// The element 1.
    pub(super) fn one(&self) -> u64 {
        self.one
    }

    /// The element 2⁶⁴.
    pub(super) fn radix(&self) -> u64 {
        self.radix_squared
    }

    /// The element of a number.
    pub(super) fn element(&self, value: u64) -> u64 {
        let value = if value < self.modulus { value } else { value % self.modulus };
        self.reduce(u128::from(value) * u128::from(self.radix_squared))
    }

    /// The number in 0 … n − 1 of an element.
    pub(super) fn representative(&self, a: u64) -> u64 {
        self.reduce(u128::from(a))
    }

    /// a·b.
    pub(super) fn mul(&self, a: u64, b: u64) -> u64 {
        self.reduce(u128::from(a) * u128::from(b))
    }

    /// a^exponent, with 0⁰ = 1, in O(log exponent) products.
    pub(super) fn pow(&self, a: u64, mut exponent: u64) -> u64 {
        let (mut result, mut base) = (self.one, a);
        while exponent > 0 {
            if exponent & 1 == 1 {
                result = self.mul(result, base);
            }
            base = self.mul(base, base);
            exponent >>= 1;
        }
        result
    }

    /// value·2⁻⁶⁴ modulo n, for value < n·2⁶⁴.
    pub(super) fn reduce(&self, value: u128) -> u64 {
        let multiple = (value as u64).wrapping_mul(self.negated_inverse);
        let sum = ((value + u128::from(multiple) * u128::from(self.modulus)) >> 64) as u64;
        if sum >= self.modulus { sum - self.modulus } else { sum }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn products_are_those_of_numbers(half in 1_u64..1 << 62, a: u64, b: u64) {
            let n = 2 * half + 1;
            let ring = Montgomery::new(n);
            let product = (u128::from(a) * u128::from(b) % u128::from(n)) as u64;
            prop_assert_eq!(ring.representative(ring.mul(ring.element(a), ring.element(b))), product);
            prop_assert_eq!(ring.element(product), ring.mul(ring.element(a), ring.element(b)));
            prop_assert_eq!(ring.pow(ring.element(a), 3), ring.mul(ring.element(a), ring.pow(ring.element(a), 2)));
            prop_assert_eq!((ring.representative(ring.one()), ring.modulus()), (1, n));
            prop_assert_eq!(ring.radix(), ring.mul(ring.element(1 << 63), ring.element(2)));
        }
    }
}
