//! The numbers that generated code computes with: floats of both precisions and in both variants.

use core::fmt::Debug;
use core::ops::{Add, BitOr, Div, Mul, Neg, Sub};

use crate::float::{mul_add, mul_add_f32, sqrt, sqrt_f32};

/// A number that generated code computes with. A quotient by an infinite divisor is NaN, not zero, so that a weight beyond the range of
/// floats does not pass for a finite result.
///
/// Evaluators are generated once, as code over any `Real`: a precision and a variant of rounding for speed ([`Plain`] and
/// [`Fused`] floats), or a number that knows how far it may be from the exact one.
///
/// ```
/// use hodograph::{Fused, Plain, Real, Rounded};
/// fn square_less_one<R: Real>(x: R) -> R {
///     x.mul_add(x, R::of(-1.0))
/// }
/// let x = 1.0 + f64::EPSILON;
/// assert_eq!(square_less_one(Plain::new(x)).value(), 2.0 * f64::EPSILON);
/// assert_eq!(square_less_one(Fused::new(x)).value(), 2.0 * f64::EPSILON + f64::EPSILON * f64::EPSILON);
/// ```
pub trait Real:
    Copy
    + Default
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The number of the type that is nearest to a constant.
    fn of(constant: f64) -> Self;

    /// a·b + c, rounded as the variant has it: after the product and after the sum, or once.
    #[must_use]
    fn mul_add(self, b: Self, c: Self) -> Self;

    /// The square root.
    #[must_use]
    fn sqrt(self) -> Self;

    /// `self` where `by` is positive, −`self` where it is negative; NaN where it is neither.
    #[must_use]
    fn orient(self, by: Self) -> Self;

    /// The power of two that brings the largest of |a|, |b| and |c| into [1, 2), as far as floats reach; NaN where all are zero
    /// or one is infinite.
    fn scale(a: Self, b: Self, c: Self) -> Self;
}

/// c_0 + c_1·x + … + c_n·xⁿ by Horner's scheme; 0 without coefficients.
///
/// ```
/// use hodograph::{Plain, Rounded, horner};
/// let coefficients = [1.0, 0.0, 2.0].map(Plain::new);
/// assert_eq!(horner(coefficients, Plain::new(3.0)).value(), 19.0);
/// ```
#[inline(always)]
#[must_use]
pub fn horner<R: Real, const N: usize>(coefficients: [R; N], x: R) -> R {
    let mut k = N.max(1) - 1;
    let mut sum = if N == 0 { R::default() } else { coefficients[k] };
    while k > 0 {
        k -= 1;
        sum = sum.mul_add(x, coefficients[k]);
    }
    sum
}

/// The numbers of a type that are nearest to constants.
///
/// ```
/// use hodograph::{Plain, Rounded, constants};
/// assert_eq!(constants([0.5, 0.1]).map(Plain::<f32>::value), [0.5, 0.1]);
/// ```
#[inline(always)]
#[must_use]
pub fn constants<R: Real, const N: usize>(constants: [f64; N]) -> [R; N] {
    // Loops are always inlined, and mapped arrays are not.
    let mut numbers = [R::default(); N];
    let mut k = 0;
    while k < N {
        numbers[k] = R::of(constants[k]);
        k += 1;
    }
    numbers
}

/// A precision: `f32` or `f64`.
pub trait Float:
    Copy
    + Default
    + PartialOrd
    + Debug
    + Send
    + Sync
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + sealed::Sealed
    + 'static
{
    /// The bits of a number, as an integer.
    type Bits: Copy + Default + Eq + BitOr<Output = Self::Bits>;

    /// Infinity.
    const INFINITY: Self;
    /// Not a number.
    const NAN: Self;
    /// Half the distance of 1 from the next number: what a rounding adds, relative to its result, where it is not subnormal.
    const UNIT_ROUNDOFF: f64;
    /// The smallest positive number, subnormal.
    const SMALLEST: f64;
    /// The largest number.
    const LARGEST: f64;

    /// The nearest number of this precision.
    fn of(number: f64) -> Self;

    /// The same number in double precision.
    fn to_f64(self) -> f64;

    /// The correctly rounded square root.
    #[must_use]
    fn sqrt(self) -> Self;

    /// a·b + c, rounded once.
    #[must_use]
    fn mul_add(self, b: Self, c: Self) -> Self;

    /// The absolute value.
    #[must_use]
    fn abs(self) -> Self;

    /// Whether the number is neither infinite nor NaN.
    fn is_finite(self) -> bool;

    /// The power of two that brings `self`, which is not negative, into [1, 2), as far as floats reach; NaN for zero,
    /// infinity and NaN.
    #[must_use]
    fn normalizer(self) -> Self;

    /// Zero exactly where the number is finite: the bits of x − x.
    fn defect(self) -> Self::Bits;
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

macro_rules! float {
    ($float:ident, $bits:ident, $signed:ident, $fraction:literal, $bias:literal, $sqrt:ident, $mul_add:ident) => {
        #[allow(
            clippy::cast_lossless,
            clippy::cast_possible_wrap,
            clippy::cast_sign_loss,
            clippy::unnecessary_cast
        )]
        impl Float for $float {
            type Bits = $bits;
            const INFINITY: Self = $float::INFINITY;
            const NAN: Self = $float::NAN;
            const UNIT_ROUNDOFF: f64 = 0.5 * $float::EPSILON as f64;
            const SMALLEST: f64 = $float::from_bits(1) as f64;
            const LARGEST: f64 = $float::MAX as f64;

            #[inline(always)]
            #[allow(clippy::cast_possible_truncation)]
            fn of(number: f64) -> Self {
                number as $float
            }

            #[inline(always)]
            fn to_f64(self) -> f64 {
                self.into()
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }

            #[inline(always)]
            fn mul_add(self, b: Self, c: Self) -> Self {
                $mul_add(self, b, c)
            }

            #[inline(always)]
            fn abs(self) -> Self {
                $float::abs(self)
            }

            #[inline(always)]
            fn is_finite(self) -> bool {
                $float::is_finite(self)
            }

            #[inline(always)]
            fn normalizer(self) -> Self {
                // Exponents add up to twice that of 1. Subnormal numbers have the least exponent, so that their multiples stay
                // below 2; the multiples of the largest numbers reach 4. All bits are those of numbers without a sign, which
                // vector instructions compare best.
                const LEAST: $signed = 1 << $fraction;
                const TWICE: $signed = 2 * $bias << $fraction;
                const MASK: $signed = $signed::MAX >> $fraction << $fraction;
                let exponent = (self.to_bits() as $signed & MASK).max(LEAST);
                let power = $float::from_bits((TWICE - exponent).max(LEAST) as $bits);
                if self > 0.0 && self < $float::INFINITY { power } else { $float::NAN }
            }

            #[inline(always)]
            fn defect(self) -> $bits {
                (self - self).to_bits()
            }
        }
    };
}

float!(f32, u32, i32, 23, 127, sqrt_f32, mul_add_f32);
float!(f64, u64, i64, 52, 1023, sqrt, mul_add);

/// A float whose products and sums are rounded one after the other, as every machine does.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
#[repr(transparent)]
pub struct Plain<F>(F);

/// A float whose products are added without having been rounded, as machines with fused multiply-add do.
///
/// Code that is compiled for a machine without the instruction calls software, which is correct and slow.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
#[repr(transparent)]
pub struct Fused<F>(F);

/// A [`Real`] that is a float: one of the variants of a precision.
pub trait Rounded<F: Float>: Real {
    /// Whether products are added unrounded.
    const FUSED: bool;

    /// The float as a number of the variant.
    fn new(value: F) -> Self;

    /// The float.
    fn value(self) -> F;
}

macro_rules! variant {
    ($name:ident, $fused:literal, $mul_add:expr) => {
        impl<F: Float> Rounded<F> for $name<F> {
            const FUSED: bool = $fused;

            #[inline(always)]
            fn new(value: F) -> Self {
                Self(value)
            }

            #[inline(always)]
            fn value(self) -> F {
                self.0
            }
        }

        impl<F: Float> Real for $name<F> {
            #[inline(always)]
            fn of(constant: f64) -> Self {
                Self(F::of(constant))
            }

            #[inline(always)]
            fn mul_add(self, b: Self, c: Self) -> Self {
                let mul_add: fn(F, F, F) -> F = $mul_add;
                Self(mul_add(self.0, b.0, c.0))
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                Self(self.0.sqrt())
            }

            #[inline(always)]
            fn orient(self, by: Self) -> Self {
                let zero = F::default();
                let turned = if by.0 < zero { -self.0 } else { F::NAN };
                Self(if by.0 > zero { self.0 } else { turned })
            }

            #[inline(always)]
            fn scale(a: Self, b: Self, c: Self) -> Self {
                let larger = |x: F, y: F| if x > y { x } else { y };
                Self(larger(larger(a.0.abs(), b.0.abs()), c.0.abs()).normalizer())
            }
        }

        variant!($name, Add, add, +);
        variant!($name, Sub, sub, -);
        variant!($name, Mul, mul, *);

        impl<F: Float> Div for $name<F> {
            type Output = Self;

            #[inline(always)]
            fn div(self, other: Self) -> Self {
                // x·0 is zero, or NaN where x is infinite.
                Self(self.0 / other.mul_add(Self(F::default()), other).0)
            }
        }

        impl<F: Float> Neg for $name<F> {
            type Output = Self;

            #[inline(always)]
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }
    };
    ($name:ident, $operation:ident, $method:ident, $operator:tt) => {
        impl<F: Float> $operation for $name<F> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0 $operator other.0)
            }
        }
    };
}

variant!(Plain, false, |a, b, c| a * b + c);
variant!(Fused, true, |a, b, c| a.mul_add(b, c));

#[cfg(test)]
mod tests {
    use super::{Float, Fused, Plain, Real, Rounded};

    #[test]
    fn variants_differ_in_the_product_that_is_added() {
        let (a, b, c) = (1.0 + f32::EPSILON, 1.0 - f32::EPSILON, -1.0);
        let plain = Real::mul_add(Plain::new(a), Plain::new(b), Plain::new(c));
        let fused = Real::mul_add(Fused::new(a), Fused::new(b), Fused::new(c));
        assert_eq!((plain.value(), fused.value()), (0.0, -f32::EPSILON * f32::EPSILON));
    }

    #[test]
    fn quotients_by_infinity_are_not_finite() {
        let quotient = |x: f64, y: f64| (Plain::new(x) / Plain::new(y)).value();
        assert!(quotient(1.0, f64::INFINITY).is_nan() && quotient(0.0, f64::NEG_INFINITY).is_nan());
        assert_eq!((quotient(1.0, 3.0), quotient(-1.0, f64::MAX)), (1.0 / 3.0, -1.0 / f64::MAX));
        assert!(
            quotient(1.0, 0.0).is_infinite()
                && (Fused::new(1.0) / Fused::new(f32::INFINITY)).value().is_nan()
        );
    }

    #[test]
    fn orientation_is_a_sign_or_nothing() {
        let orient = |by: f64| Plain::new(3.0).orient(Plain::new(by)).value();
        assert_eq!((orient(1e-300), orient(-7.0)), (3.0, -3.0));
        assert!(orient(0.0).is_nan() && orient(-0.0).is_nan() && orient(f64::NAN).is_nan());
    }

    #[test]
    fn scales_are_powers_of_two_that_normalize() {
        let mut size = f64::from_bits(1);
        while size < f64::INFINITY {
            let scale = Plain::scale(Plain::new(-0.5 * size), Plain::new(size), Plain::new(0.0)).value();
            assert_eq!(scale.to_bits() << 12, 0);
            let scaled = size * scale;
            let reached = (f64::MIN_POSITIVE..f64::MAX / 2.0).contains(&size);
            assert!(if reached { (1.0..2.0).contains(&scaled) } else { scaled > 0.0 && scaled < 4.0 });
            size *= 1.75_f64.max(1.0 + 2.0 * (size < 1e-322) as u8 as f64);
        }
        let mut size = f32::from_bits(1);
        while size < f32::INFINITY {
            let scaled = size * size.normalizer();
            let reached = (f32::MIN_POSITIVE..f32::MAX / 2.0).contains(&size);
            assert!(if reached { (1.0..2.0).contains(&scaled) } else { scaled > 0.0 && scaled < 4.0 });
            size *= 3.0;
        }
        for undefined in [0.0, f64::INFINITY, f64::NAN] {
            assert!(Fused::scale(Fused::new(undefined), Fused::new(0.0), Fused::new(-0.0)).value().is_nan());
        }
    }

    #[test]
    fn defects_tell_finite_numbers() {
        assert!([0.0, -0.0, f64::MAX, f64::MIN_POSITIVE].iter().all(|x| x.defect() == 0));
        assert!([f64::NAN, f64::INFINITY, f64::NEG_INFINITY].iter().all(|x| x.defect() != 0));
        assert!(f32::MAX.defect() == 0 && f32::INFINITY.defect() != 0);
    }
}
