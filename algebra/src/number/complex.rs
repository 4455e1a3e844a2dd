//! Complex numbers whose parts are polynomials, numbers of the field in particular.

use std::fmt;
use std::ops::Neg;

use crate::operators::binary_operator;
use crate::{Fraction, Poly, Rational, minimize_field, ratio};

/// A complex number `re + I·im`, or a polynomial with such coefficients: both parts are [`Poly`]s.
///
/// The plane of a planar Pythagorean-hodograph curve is the plane of these numbers (Farouki, *The conformal map z → z²
/// of the hodograph plane*, 1994): points, tangents and preimages are all written with them.
///
/// # Example
/// ```
/// use hodograph_algebra::{Complex, Poly};
/// let z = Complex::new(Poly::integer(0), Poly::integer(4));
/// let w = z.sqrt();
/// assert_eq!(w.to_string(), "sqrt2 + I*(sqrt2)");
/// assert_eq!(&w * &w, z);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Complex {
    /// The real part.
    pub re: Poly,
    /// The imaginary part.
    pub im: Poly,
}

impl Complex {
    /// `re + I·im`.
    #[must_use]
    pub fn new(re: Poly, im: Poly) -> Complex {
        Complex { re, im }
    }

    /// `re + I·im`, times the least common multiple of the known denominators of both.
    #[must_use]
    pub(crate) fn over_common_denominator(re: &Fraction, im: &Fraction) -> Complex {
        let common = Fraction::common_denominator([re, im]);
        Complex::new(re.numerator_over(&common), im.numerator_over(&common))
    }

    /// Zero.
    #[must_use]
    pub fn zero() -> Complex {
        Complex::from(Poly::zero())
    }

    /// One.
    #[must_use]
    pub fn one() -> Complex {
        Complex::from(Poly::one())
    }

    /// The imaginary unit `I`.
    #[must_use]
    pub fn i() -> Complex {
        Complex { re: Poly::zero(), im: Poly::one() }
    }

    /// Whether it is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.re.is_zero() && self.im.is_zero()
    }

    /// Whether no variable occurs in it.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        self.re.is_constant() && self.im.is_constant()
    }

    /// The conjugate `re − I·im`.
    #[must_use]
    pub fn conj(&self) -> Complex {
        Complex { re: self.re.clone(), im: -&self.im }
    }

    /// The squared absolute value `re² + im²`.
    #[must_use]
    pub fn norm2(&self) -> Poly {
        &self.re * &self.re + &self.im * &self.im
    }

    /// The product with the rational `factor`.
    #[must_use]
    pub fn scale(&self, factor: &Rational) -> Complex {
        Complex { re: self.re.scale(factor), im: self.im.scale(factor) }
    }

    /// The product with the real `factor`.
    #[must_use]
    pub fn times_real(&self, factor: &Poly) -> Complex {
        Complex { re: &self.re * factor, im: &self.im * factor }
    }

    /// `self` to the power `exponent`, by repeated squaring; the power 0 is 1.
    #[must_use]
    pub fn pow(&self, exponent: u32) -> Complex {
        let (mut result, mut square) = (Complex::one(), self.clone());
        let mut rest = exponent;
        while rest > 0 {
            if rest & 1 == 1 {
                result = &result * &square;
            }
            rest >>= 1;
            if rest > 0 {
                square = &square * &square;
            }
        }
        result
    }

    /// The number `1/self = conj(self)/|self|²`, for a nonzero number of the field.
    ///
    /// # Panics
    /// If `self` is zero, or has variables.
    #[must_use]
    pub fn inverse(&self) -> Complex {
        self.conj().times_real(&self.norm2().inverse())
    }

    /// The principal square root of a number: the one with positive real part, or with real part zero and nonnegative
    /// imaginary part.
    ///
    /// With `√(a + I·b) = p + I·q`, `p = √((|z| + a)/2)` and `q = b/(2p)`; for negative real `z` it is `I·√(−z)`. Only
    /// real square roots are adjoined, in general two: `|z|` and `p`.
    ///
    /// # Panics
    /// If `self` has variables.
    #[must_use]
    pub fn sqrt(&self) -> Complex {
        assert!(self.is_constant(), "only a number has a principal square root");
        if self.im.is_zero() {
            return match self.re.sqrt() {
                Some(root) => Complex::from(root),
                None => Complex { re: Poly::zero(), im: nonnegative_sqrt(&-&self.re) },
            };
        }
        let absolute = nonnegative_sqrt(&self.norm2());
        // |z| > |a|, so the halved sum is positive, and so is its root.
        let square = (absolute + &self.re).scale(&ratio(1, 2));
        let re = nonnegative_sqrt(&square);
        // 1/p = p/p², where p² lies in the smaller field.
        let im = (&self.im * square.inverse()).scale(&ratio(1, 2)) * &re;
        let [root] = minimize_complex(&[Complex { re, im }]);
        root
    }

    /// The number as a decimal, both parts correctly rounded to `digits` places after the point: `1.41 - 0.50*I`.
    ///
    /// # Panics
    /// If `self` has variables.
    #[must_use]
    pub fn to_decimal(&self, digits: u32) -> String {
        let im = self.im.to_decimal(digits);
        let (sign, size) = match im.strip_prefix('-') {
            Some(size) => ('-', size),
            None => ('+', im.as_str()),
        };
        format!("{} {sign} {size}*I", self.re.to_decimal(digits))
    }
}

/// The same numbers over one field with as few generators as [`minimize_field`] finds.
pub(crate) fn minimize_complex<const N: usize>(numbers: &[Complex; N]) -> [Complex; N] {
    let parts: Vec<Poly> = numbers.iter().flat_map(|z| [z.re.clone(), z.im.clone()]).collect();
    let parts = minimize_field(&parts);
    std::array::from_fn(|j| Complex { re: parts[2 * j].clone(), im: parts[2 * j + 1].clone() })
}

/// The root of a number that the caller knows not to be negative.
fn nonnegative_sqrt(number: &Poly) -> Poly {
    number.sqrt().expect("the caller knows that the number is not negative")
}

impl From<Poly> for Complex {
    fn from(re: Poly) -> Complex {
        Complex { re, im: Poly::zero() }
    }
}

impl From<Rational> for Complex {
    fn from(re: Rational) -> Complex {
        Complex::from(Poly::constant(re))
    }
}

impl fmt::Display for Complex {
    /// The real part, then `I*(…)`; a part that is zero is left out.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.im.is_zero() {
            return self.re.fmt(f);
        }
        if !self.re.is_zero() {
            write!(f, "{} + ", self.re)?;
        }
        if self.im.is_one() { f.write_str("I") } else { write!(f, "I*({})", self.im) }
    }
}

binary_operator!(Complex: Add add, |a, b| Complex { re: &a.re + &b.re, im: &a.im + &b.im });
binary_operator!(Complex: Sub sub, |a, b| Complex { re: &a.re - &b.re, im: &a.im - &b.im });
binary_operator!(Complex: Mul mul, |a, b| Complex {
    re: &a.re * &b.re - &a.im * &b.im,
    im: &a.re * &b.im + &a.im * &b.re,
});

impl Neg for &Complex {
    type Output = Complex;

    fn neg(self) -> Complex {
        Complex { re: -&self.re, im: -&self.im }
    }
}

impl Neg for Complex {
    type Output = Complex;

    fn neg(self) -> Complex {
        -&self
    }
}

#[cfg(test)]
mod tests {
    use std::cmp::Ordering;

    use super::*;

    fn gauss(re: i64, im: i64) -> Complex {
        Complex::new(Poly::integer(re), Poly::integer(im))
    }

    #[test]
    fn roots_are_principal() {
        for (re, im) in
            [(3, 4), (-3, 4), (3, -4), (-3, -4), (0, 2), (0, -2), (5, 0), (-5, 0), (1, 1), (-2, 7)]
        {
            let z = gauss(re, im);
            let w = z.sqrt();
            assert_eq!(&w * &w, z, "the root of {z}");
            let principal = match w.re.sign() {
                Ordering::Greater => true,
                Ordering::Equal => w.im.sign() != Ordering::Less,
                Ordering::Less => false,
            };
            assert!(principal, "the root {w} of {z}");
        }
        assert_eq!(gauss(0, 0).sqrt(), Complex::zero());
        assert_eq!(gauss(3, 4).sqrt(), gauss(2, 1));
        assert_eq!(gauss(0, 2).sqrt().re.ring().field().degree(), 1);
        assert_eq!(gauss(1, 1).sqrt().re.ring().field().degree(), 4);
    }

    #[test]
    fn inverses_and_powers() {
        let z = gauss(2, -3) + Complex::new(Poly::sqrt_of(&crate::integer(2)), Poly::zero());
        assert_eq!(&z * z.inverse(), Complex::one());
        assert_eq!(z.pow(5), &z * &z * &z * &z * &z);
        assert_eq!(z.pow(0), Complex::one());
        assert_eq!(Complex::from(z.norm2()), &z * z.conj());
    }

    #[test]
    fn prints_for_any_computer_algebra_system() {
        assert_eq!(gauss(1, 0).to_string(), "1");
        assert_eq!(gauss(0, 1).to_string(), "I");
        assert_eq!(gauss(2, -1).to_string(), "2 + I*(-1)");
        assert_eq!(gauss(0, 0).to_string(), "0");
        assert_eq!(gauss(1, -1).sqrt().to_decimal(3), "1.099 - 0.455*I");
    }
}
