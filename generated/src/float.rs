//! The floating-point functions that evaluators need beyond the four operations, from `std` or from `libm`.

/// The square root and the fused product and sum of a precision, under these names.
#[cfg(feature = "std")]
macro_rules! functions {
    ($float:ident, $sqrt:ident, $mul_add:ident, $of_libm:ident, $fma_of_libm:ident) => {
        /// The correctly rounded square root √x of `x`; NaN for negative `x`, as IEEE 754 has it.
        ///
        /// It comes from the standard library with the feature `std`, else from `libm`; both give the same bits.
        #[inline(always)]
        #[must_use]
        pub fn $sqrt(x: $float) -> $float {
            x.sqrt()
        }

        /// a·b + c, rounded once.
        ///
        /// It is one instruction where the code around it is compiled for a machine that has it. Elsewhere it is computed by
        /// software, correctly and slowly.
        #[inline(always)]
        #[must_use]
        pub fn $mul_add(a: $float, b: $float, c: $float) -> $float {
            a.mul_add(b, c)
        }
    };
}

/// The square root and the fused product and sum of a precision, under these names.
#[cfg(all(feature = "libm", not(feature = "std")))]
macro_rules! functions {
    ($float:ident, $sqrt:ident, $mul_add:ident, $of_libm:ident, $fma_of_libm:ident) => {
        /// The correctly rounded square root √x of `x`; NaN for negative `x`, as IEEE 754 has it.
        #[inline(always)]
        #[must_use]
        pub fn $sqrt(x: $float) -> $float {
            libm::$of_libm(x)
        }

        /// a·b + c, rounded once, by software.
        #[inline(always)]
        #[must_use]
        pub fn $mul_add(a: $float, b: $float, c: $float) -> $float {
            libm::$fma_of_libm(a, b, c)
        }
    };
}

/// What neither feature provides.
#[cfg(not(any(feature = "std", feature = "libm")))]
macro_rules! functions {
    ($float:ident, $sqrt:ident, $mul_add:ident, $of_libm:ident, $fma_of_libm:ident) => {
        /// The square root that neither feature provides.
        #[must_use]
        pub fn $sqrt(_: $float) -> $float {
            $float::NAN
        }

        /// The fused product and sum that neither feature provides.
        #[must_use]
        pub fn $mul_add(_: $float, _: $float, _: $float) -> $float {
            $float::NAN
        }
    };
}

/// Whether `mul_add` is an instruction wherever the code runs: never without `std`, since `libm` has it in software alone.
// Machines that are asked at run time do not need it.
#[allow(dead_code)]
pub(crate) const HAS_FUSED: bool =
    cfg!(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64")));

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!("`hodograph` needs square roots: enable its feature `std` (the default) or `libm`");

functions!(f64, sqrt, mul_add, sqrt, fma);
functions!(f32, sqrt_f32, mul_add_f32, sqrtf, fmaf);

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
        assert_eq!(super::sqrt_f32(2.0).to_bits(), core::f32::consts::SQRT_2.to_bits());
        assert_eq!(super::sqrt(0.0), 0.0);
        assert!(super::sqrt(-1.0).is_nan());
    }

    #[test]
    fn products_and_sums_are_rounded_once() {
        let (a, b) = (1.0 + f64::EPSILON, 1.0 - f64::EPSILON);
        assert_eq!(super::mul_add(a, b, -1.0), -f64::EPSILON * f64::EPSILON);
        let (a, b) = (1.0 + f32::EPSILON, 1.0 - f32::EPSILON);
        assert_eq!(super::mul_add_f32(a, b, -1.0), -f32::EPSILON * f32::EPSILON);
    }
}
