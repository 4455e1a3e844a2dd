//! Rational intervals that are known to hold a real number.

use num_integer::Integer;
use num_traits::{Signed, Zero};

use crate::{Int, Rational};

/// A closed interval with rational ends.
///
/// Arithmetic on enclosures encloses the results of the arithmetic on all numbers within (Moore, *Interval Analysis*, 1966).
///
/// # Example
/// ```
/// use hodograph_algebra::{Enclosure, integer};
/// let x = Enclosure::new(integer(-1), integer(2));
/// assert_eq!(x.mul(&x), Enclosure::new(integer(-2), integer(4)));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Enclosure {
    lower: Rational,
    upper: Rational,
}

impl Enclosure {
    /// The interval from `lower` to `upper`.
    ///
    /// # Panics
    /// If `lower > upper`.
    #[must_use]
    pub fn new(lower: Rational, upper: Rational) -> Enclosure {
        assert!(lower <= upper, "an enclosure's lower end is above its upper one");
        Enclosure { lower, upper }
    }

    /// The interval from `lower` to `upper`, which are known to be in this order.
    pub(crate) fn ordered(lower: Rational, upper: Rational) -> Enclosure {
        Enclosure { lower, upper }
    }

    /// The interval that holds `value` alone.
    #[must_use]
    pub fn exact(value: Rational) -> Enclosure {
        Enclosure { lower: value.clone(), upper: value }
    }

    /// The lower end.
    #[must_use]
    pub fn lower(&self) -> &Rational {
        &self.lower
    }

    /// The upper end.
    #[must_use]
    pub fn upper(&self) -> &Rational {
        &self.upper
    }

    /// The difference of the ends.
    #[must_use]
    pub fn width(&self) -> Rational {
        &self.upper - &self.lower
    }

    /// Whether zero lies within.
    #[must_use]
    pub fn contains_zero(&self) -> bool {
        !self.lower.is_positive() && !self.upper.is_negative()
    }

    /// The sums of numbers of both.
    #[must_use]
    pub fn add(&self, other: &Enclosure) -> Enclosure {
        Enclosure { lower: &self.lower + &other.lower, upper: &self.upper + &other.upper }
    }

    /// The products of numbers of both.
    #[must_use]
    pub fn mul(&self, other: &Enclosure) -> Enclosure {
        let products = [
            &self.lower * &other.lower,
            &self.lower * &other.upper,
            &self.upper * &other.lower,
            &self.upper * &other.upper,
        ];
        let [mut lower, ..] = products.clone();
        let mut upper = lower.clone();
        for product in products {
            if product < lower {
                lower = product;
            } else if product > upper {
                upper = product;
            }
        }
        Enclosure { lower, upper }
    }

    /// The products with `factor`.
    #[must_use]
    pub fn scale(&self, factor: &Rational) -> Enclosure {
        self.mul(&Enclosure::exact(factor.clone()))
    }

    /// The nonnegative square roots, each end rounded outward to a multiple of `2^-bits`; the part below zero is left
    /// out.
    #[must_use]
    pub fn sqrt(&self, bits: u64) -> Enclosure {
        let root = |value: &Rational, up: bool| {
            if !value.is_positive() {
                return Rational::zero();
            }
            let scaled = (value * Rational::from(Int::ONE.shl(2 * bits))).floor().to_integer();
            let floor = scaled.isqrt();
            let root = if up { floor + Int::ONE } else { floor };
            Rational::new(root, Int::ONE.shl(bits))
        };
        Enclosure { lower: root(&self.lower, false), upper: root(&self.upper, true) }
    }

    /// The interval with its ends rounded outward to multiples of `2^-bits`.
    #[must_use]
    pub fn rounded(&self, bits: u64) -> Enclosure {
        let one = Int::ONE.shl(bits);
        let floor = |value: &Rational| (value.numer() * &one).div_floor(value.denom());
        let lower = Rational::new(floor(&self.lower), one.clone());
        let upper = Rational::new(-floor(&-&self.upper), one.clone());
        Enclosure { lower, upper }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{integer, ratio};

    #[test]
    fn roots_are_enclosed() {
        let root = Enclosure::exact(integer(2)).sqrt(40);
        assert!(root.lower() * root.lower() < integer(2));
        assert!(root.upper() * root.upper() > integer(2));
        assert!(root.width() <= Rational::new(Int::ONE, Int::ONE.shl(40)));
    }

    #[test]
    fn rounding_goes_outward() {
        let third = Enclosure::new(ratio(-1, 3), ratio(1, 3)).rounded(2);
        assert_eq!(third, Enclosure::new(ratio(-1, 2), ratio(1, 2)));
    }
}
