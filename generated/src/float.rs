//! The floating-point functions that evaluators need beyond the four operations.

/// The correctly rounded square root √x of `x`; NaN for negative `x`, as IEEE 754 has it.
///
/// It comes from the standard library with the feature `std`, else from `libm`; both give the same bits.
///
/// ```
/// assert_eq!(hodograph::float::sqrt(2.25), 1.5);
/// ```
#[cfg(feature = "std")]
#[inline]
#[must_use]
pub fn sqrt(x: f64) -> f64 {
    x.sqrt()
}

/// The correctly rounded square root √x of `x`; NaN for negative `x`, as IEEE 754 has it.
#[cfg(all(feature = "libm", not(feature = "std")))]
#[inline]
#[must_use]
pub fn sqrt(x: f64) -> f64 {
    libm::sqrt(x)
}

/// The square root that neither feature provides.
#[cfg(not(any(feature = "std", feature = "libm")))]
#[must_use]
pub fn sqrt(_: f64) -> f64 {
    compile_error!("`hodograph` needs square roots: enable its feature `std` (the default) or `libm`")
}

/// The angle of the vector (x, y) in radians, from −π to π.
#[cfg(feature = "std")]
#[inline]
#[must_use]
pub fn atan2(y: f64, x: f64) -> f64 {
    y.atan2(x)
}

/// The angle of the vector (x, y) in radians, from −π to π.
#[cfg(all(feature = "libm", not(feature = "std")))]
#[inline]
#[must_use]
pub fn atan2(y: f64, x: f64) -> f64 {
    libm::atan2(y, x)
}

/// The angle that neither feature provides.
#[cfg(not(any(feature = "std", feature = "libm")))]
#[must_use]
pub fn atan2(_: f64, _: f64) -> f64 {
    f64::NAN
}

#[cfg(test)]
mod tests {
    #[test]
    fn square_roots_are_correctly_rounded() {
        assert_eq!(super::sqrt(2.0).to_bits(), core::f64::consts::SQRT_2.to_bits());
        assert_eq!(super::sqrt(0.0), 0.0);
        assert!(super::sqrt(-1.0).is_nan());
    }
}
