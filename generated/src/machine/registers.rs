//! Numbers that are vector registers of 256 bits: points are evaluated as many at a time as a register has numbers, and written
//! in the order of points in memory.
//!
//! Compilers make vectors of most loops by themselves. But where a build assumes AVX-512, as those for most processors of Intel do,
//! LLVM computes with 256 bits and brings coordinates into order with 512 bits, during which such processors compute at half their
//! rate.
//!
//! That the machine has the instructions used here rests on one thing: [`points`] makes registers only where the build assumes AVX and
//! FMA, or a test has asked the machine.

use core::any::TypeId;
use core::arch::x86_64::*;
use core::marker::PhantomData;
use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::real::{Float, Real, Rounded};
use crate::task::{Part, Stages, Task};

/// Whether points are evaluated in registers.
const IN_REGISTERS: bool =
    cfg!(all(target_feature = "avx", target_feature = "fma", target_feature = "avx512f"));

/// Bytes from what is written to what is fetched into the cache to be written.
const AHEAD: usize = 1024;

/// Evaluates the first points, as many as fill registers. Returns how many, and what is `true`
/// only if all their coordinates are finite.
#[inline(always)]
pub(crate) fn points<T: Task, F: Float, S: Stages<T>, R: Rounded<F>>(
    surface: &S,
    us: &[F],
    vs: &[F],
    out: &mut [[F; 3]],
) -> (usize, bool) {
    // Tests run what only some builds do, wherever the machine can.
    if !(IN_REGISTERS || cfg!(test) && super::has_fused()) {
        (0, true)
    } else if TypeId::of::<F>() == TypeId::of::<f64>() {
        // SAFETY: the machine has the instructions, and `F` is `f64`.
        unsafe { evaluate::<T, F, S, Doubles<R, F>>(surface, us, vs, out) }
    } else if TypeId::of::<F>() == TypeId::of::<f32>() {
        // SAFETY: the machine has the instructions, and `F` is `f32`.
        unsafe { evaluate::<T, F, S, Singles<R, F>>(surface, us, vs, out) }
    } else {
        (0, true)
    }
}

/// Evaluates points on a machine that must have AVX and FMA, in registers that must be of numbers of the type `F`.
#[inline(always)]
unsafe fn evaluate<T: Task, F: Float, S: Stages<T>, V: Register>(
    surface: &S,
    us: &[F],
    vs: &[F],
    out: &mut [[F; 3]],
) -> (usize, bool) {
    let parameters = us.chunks_exact(V::LANES).zip(vs.chunks_exact(V::LANES));
    let mut defect = V::default();
    let mut written = 0;
    for ((us, vs), points) in parameters.zip(out.chunks_exact_mut(V::LANES)) {
        // SAFETY: each slice has the numbers of one register.
        let (u, v) = unsafe { (V::load(us.as_ptr().cast()), V::load(vs.as_ptr().cast())) };
        let values = surface.join(surface.of_u(u), surface.of_v(v));
        let [x, y, z] = [values.get(0), values.get(1), values.get(2)];
        let sum = x + z + y;
        defect = defect.or(sum.defect());
        // What is written between reads of parameters is fetched too late by the machine itself.
        let ahead = points.as_ptr().wrapping_byte_add(AHEAD).cast::<i8>();
        // SAFETY: prefetching does nothing at addresses that are not the program's.
        unsafe {
            _mm_prefetch::<_MM_HINT_ET0>(ahead);
            _mm_prefetch::<_MM_HINT_ET0>(ahead.wrapping_add(64));
        }
        // SAFETY: the points have three coordinates each, the numbers of three registers.
        unsafe { V::store([x, y, z], points.as_mut_ptr().cast()) };
        written += V::LANES;
    }
    (written, defect.is_zero())
}

/// A vector register.
trait Register: Real {
    /// Its numbers.
    type Number;

    /// How many numbers it has.
    const LANES: usize;

    /// The register of the numbers at a place, of which there must be enough.
    unsafe fn load(numbers: *const Self::Number) -> Self;

    /// Writes points of these coordinates to a place, which must suffice for the numbers of three registers.
    unsafe fn store(coordinates: [Self; 3], points: *mut Self::Number);

    /// Zeros exactly where the numbers are finite: x − x.
    fn defect(self) -> Self;

    /// All bits that are in one of two registers.
    fn or(self, other: Self) -> Self;

    /// Whether no bits are set.
    fn is_zero(self) -> bool;
}

macro_rules! register {
    (
        $(#[$documentation:meta])*
        $name:ident, $number:ident, $vector:ident, $lanes:literal,
        $load:ident, $store:ident, $set:ident, $cast:ident,
        $add:ident, $sub:ident, $mul:ident, $div:ident, $fmadd:ident, $sqrt:ident,
        $or:ident, $xor:ident, $andnot:ident, $compare:ident, $choose:ident, $max:ident,
        |$x:ident, $y:ident, $z:ident| $ordered:expr
    ) => {
        $(#[$documentation])*
        #[derive(Clone, Copy)]
        struct $name<R, F>($vector, PhantomData<(R, F)>);

        impl<R: Rounded<F>, F: Float> $name<R, F> {
            #[inline(always)]
            fn new(vector: $vector) -> Self {
                Self(vector, PhantomData)
            }

            #[inline(always)]
            fn all(number: $number) -> Self {
                // SAFETY: see the module.
                Self::new(unsafe { $set(number) })
            }

            /// The numbers of `yes` where those of `self` and `other` compare, else those of `no`.
            #[inline(always)]
            fn choose<const COMPARISON: i32>(self, other: Self, yes: Self, no: Self) -> Self {
                // SAFETY: see the module.
                Self::new(unsafe { $choose(no.0, yes.0, $compare::<COMPARISON>(self.0, other.0)) })
            }
        }

        impl<R: Rounded<F>, F: Float> Default for $name<R, F> {
            #[inline(always)]
            fn default() -> Self {
                Self::all(0.0)
            }
        }

        register!($name, Add, add, $add);
        register!($name, Sub, sub, $sub);
        register!($name, Mul, mul, $mul);

        impl<R: Rounded<F>, F: Float> Div for $name<R, F> {
            type Output = Self;

            #[inline(always)]
            fn div(self, other: Self) -> Self {
                // As for single numbers: a quotient by infinity is NaN.
                let divisor = other.mul_add(Self::default(), other);
                // SAFETY: see the module.
                Self::new(unsafe { $div(self.0, divisor.0) })
            }
        }

        impl<R: Rounded<F>, F: Float> Neg for $name<R, F> {
            type Output = Self;

            #[inline(always)]
            fn neg(self) -> Self {
                // SAFETY: see the module.
                Self::new(unsafe { $xor(self.0, Self::all(-0.0).0) })
            }
        }

        impl<R: Rounded<F>, F: Float> Real for $name<R, F> {
            #[inline(always)]
            fn of(constant: f64) -> Self {
                Self::all(<$number as Float>::of(constant))
            }

            #[inline(always)]
            fn mul_add(self, b: Self, c: Self) -> Self {
                if R::FUSED {
                    // SAFETY: see the module.
                    Self::new(unsafe { $fmadd(self.0, b.0, c.0) })
                } else {
                    self * b + c
                }
            }

            #[inline(always)]
            fn sqrt(self) -> Self {
                // SAFETY: see the module.
                Self::new(unsafe { $sqrt(self.0) })
            }

            #[inline(always)]
            fn orient(self, by: Self) -> Self {
                let zero = Self::default();
                let turned = by.choose::<_CMP_LT_OQ>(zero, -self, Self::all($number::NAN));
                by.choose::<_CMP_GT_OQ>(zero, self, turned)
            }

            #[inline(always)]
            fn scale(a: Self, b: Self, c: Self) -> Self {
                let mut numbers = [0.0; $lanes];
                // SAFETY: see the module; there is a place for each number.
                unsafe {
                    let [a, b, c] = [a, b, c].map(|x| $andnot(Self::all(-0.0).0, x.0));
                    $store(numbers.as_mut_ptr(), $max($max(a, b), c));
                    numbers = numbers.map(Float::normalizer);
                    Self::load(numbers.as_ptr())
                }
            }
        }

        impl<R: Rounded<F>, F: Float> Register for $name<R, F> {
            type Number = $number;
            const LANES: usize = $lanes;

            #[inline(always)]
            unsafe fn load(numbers: *const $number) -> Self {
                // SAFETY: see the module; the caller has so many numbers.
                Self::new(unsafe { $load(numbers) })
            }

            #[inline(always)]
            unsafe fn store([x, y, z]: [Self; 3], points: *mut $number) {
                let ($x, $y, $z) = (x.0, y.0, z.0);
                // SAFETY: see the module; the caller has so many places.
                unsafe {
                    let [first, second, third] = $ordered;
                    $store(points, first);
                    $store(points.add($lanes), second);
                    $store(points.add(2 * $lanes), third);
                }
            }

            #[inline(always)]
            fn defect(self) -> Self {
                // SAFETY: see the module.
                Self::new(unsafe { $sub(self.0, self.0) })
            }

            #[inline(always)]
            fn or(self, other: Self) -> Self {
                // SAFETY: see the module.
                Self::new(unsafe { $or(self.0, other.0) })
            }

            #[inline(always)]
            fn is_zero(self) -> bool {
                // SAFETY: see the module.
                unsafe { _mm256_testz_si256($cast(self.0), $cast(self.0)) == 1 }
            }
        }
    };
    ($name:ident, $operation:ident, $method:ident, $function:ident) => {
        impl<R: Rounded<F>, F: Float> $operation for $name<R, F> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: see the module.
                Self::new(unsafe { $function(self.0, other.0) })
            }
        }
    };
}

register!(
    /// Four doubles.
    Doubles, f64, __m256d, 4,
    _mm256_loadu_pd, _mm256_storeu_pd, _mm256_set1_pd, _mm256_castpd_si256,
    _mm256_add_pd, _mm256_sub_pd, _mm256_mul_pd, _mm256_div_pd, _mm256_fmadd_pd, _mm256_sqrt_pd,
    _mm256_or_pd, _mm256_xor_pd, _mm256_andnot_pd, _mm256_cmp_pd, _mm256_blendv_pd, _mm256_max_pd,
    |x, y, z| {
        let xy = _mm256_unpacklo_pd(x, y); // x0 y0, x2 y2
        let yz = _mm256_unpackhi_pd(y, z); // y1 z1, y3 z3
        let zx = _mm256_shuffle_pd::<0b1010>(z, x); // z0 x1, z2 x3
        [
            _mm256_permute2f128_pd::<0x20>(xy, zx),
            _mm256_blend_pd::<0b1100>(yz, xy),
            _mm256_permute2f128_pd::<0x31>(zx, yz),
        ]
    }
);

register!(
    /// Eight singles.
    Singles, f32, __m256, 8,
    _mm256_loadu_ps, _mm256_storeu_ps, _mm256_set1_ps, _mm256_castps_si256,
    _mm256_add_ps, _mm256_sub_ps, _mm256_mul_ps, _mm256_div_ps, _mm256_fmadd_ps, _mm256_sqrt_ps,
    _mm256_or_ps, _mm256_xor_ps, _mm256_andnot_ps, _mm256_cmp_ps, _mm256_blendv_ps, _mm256_max_ps,
    |x, y, z| {
        let xy = _mm256_shuffle_ps::<0b10_00_10_00>(x, y); // x0 x2 y0 y2, and the same of 4 to 7
        let yz = _mm256_shuffle_ps::<0b11_01_11_01>(y, z); // y1 y3 z1 z3
        let zx = _mm256_shuffle_ps::<0b11_01_10_00>(z, x); // z0 z2 x1 x3
        let first = _mm256_shuffle_ps::<0b10_00_10_00>(xy, zx); // x0 y0 z0 x1
        let second = _mm256_shuffle_ps::<0b11_01_10_00>(yz, xy); // y1 z1 x2 y2
        let third = _mm256_shuffle_ps::<0b11_01_11_01>(zx, yz); // z2 x3 y3 z3
        [
            _mm256_permute2f128_ps::<0x20>(first, second),
            _mm256_blend_ps::<0b1111_0000>(third, first),
            _mm256_permute2f128_ps::<0x31>(second, third),
        ]
    }
);

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::{Doubles, Register, Singles, evaluate};
    use crate::batch::is_finite;
    use crate::machine::has_fused;
    use crate::real::{Float, Fused, Plain, Real, Rounded};
    use crate::task::{Point, Separated, Stages, Task};
    use crate::testing::Cone;

    /// All operations of two numbers, some of which have no finite result.
    fn operations<R: Real>(a: R, b: R) -> [R; 10] {
        let c = R::of(-0.75);
        [
            a + b,
            a - b,
            a * b,
            a / b,
            -a,
            a.mul_add(b, c),
            a.sqrt(),
            a.orient(b),
            R::scale(a, b, c),
            R::scale(R::default(), a, R::default()),
        ]
    }

    /// Checks the operations of registers against those of single numbers.
    fn check_operations<F: Float, R: Rounded<F>, V: Register>() {
        let numbers =
            [0.0, -0.0, 1.0, -3.0, 0.1, 1e30, -1e-30, 1e-40, f64::INFINITY, -f64::INFINITY, f64::NAN];
        let numbers = numbers.map(F::of);
        for a in numbers {
            for first in 0..numbers.len() {
                let bs: Vec<F> = (0..V::LANES).map(|i| numbers[(first + i) % numbers.len()]).collect();
                let mut stored = std::vec![F::NAN; 3 * V::LANES];
                let constant = V::of(a.to_f64());
                // SAFETY: the tests below have asked the machine, and both slices have the numbers of registers.
                let found = operations(constant, unsafe { V::load(bs.as_ptr().cast()) });
                for (k, result) in found.into_iter().enumerate() {
                    // SAFETY: as before.
                    unsafe { V::store([constant, result, V::of(7.0)], stored.as_mut_ptr().cast()) };
                    for (i, &b) in bs.iter().enumerate() {
                        let expected = operations(R::new(a), R::new(b))[k].value();
                        let [x, y, z] = [stored[3 * i], stored[3 * i + 1], stored[3 * i + 2]];
                        let same = |x: F, y: F| x == y || (x.to_f64().is_nan() && y.to_f64().is_nan());
                        assert!(
                            same(x, a) && same(y, expected) && z == F::of(7.0),
                            "{k}: {a:?}, {b:?}: {y:?}, not {expected:?}"
                        );
                        assert!(y != F::default() || F::of(1.0) / y == F::of(1.0) / expected);
                    }
                }
            }
        }
    }

    /// Checks points of a cone, some of which are poles, against single evaluations.
    fn check_points<T: Task, F: Float, R: Rounded<F>, V: Register>()
    where
        Cone: Stages<T>,
    {
        for (length, step) in [(0, 0.25), (7, 0.25), (8, 0.1), (45, 0.25), (45, 0.3)] {
            let us: Vec<F> = (0..length).map(|i| F::of(f64::from(i % 9) * step)).collect();
            let vs: Vec<F> = (0..length).map(|i| F::of(f64::from(i) / 7.0 - 3.0)).collect();
            let untouched = [F::of(7.0); 3];
            let mut points = std::vec![untouched; us.len()];
            // SAFETY: the test below has asked the machine.
            let (written, are_finite) = unsafe { evaluate::<T, F, Cone, V>(&Cone, &us, &vs, &mut points) };
            assert_eq!(written, us.len() - us.len() % V::LANES);
            let mut all_finite = true;
            for (i, point) in points.iter().enumerate() {
                let mut expected = untouched;
                if i < written {
                    let (u, v) = (Cone.of_u(R::new(us[i])), Cone.of_v(R::new(vs[i])));
                    let values = <Cone as Stages<T>>::join(&Cone, u, v);
                    expected = core::array::from_fn(|k| crate::task::Part::get(&values, k).value());
                }
                if is_finite(&expected) {
                    assert_eq!(*point, expected);
                } else {
                    assert!(!is_finite(point));
                    all_finite = false;
                }
            }
            assert_eq!(are_finite, all_finite);
            assert_eq!(all_finite, step != 0.25 || written < 5);
        }
    }

    #[test]
    fn registers_compute_as_single_numbers_do() {
        if has_fused() {
            check_operations::<f64, Plain<f64>, Doubles<Plain<f64>, f64>>();
            check_operations::<f64, Fused<f64>, Doubles<Fused<f64>, f64>>();
            check_operations::<f32, Plain<f32>, Singles<Plain<f32>, f32>>();
            check_operations::<f32, Fused<f32>, Singles<Fused<f32>, f32>>();
        }
    }

    #[test]
    fn points_in_registers_are_single_ones() {
        if has_fused() {
            check_points::<Point, f64, Plain<f64>, Doubles<Plain<f64>, f64>>();
            check_points::<Point, f64, Fused<f64>, Doubles<Fused<f64>, f64>>();
            check_points::<Separated, f32, Plain<f32>, Singles<Plain<f32>, f32>>();
            check_points::<Separated, f32, Fused<f32>, Singles<Fused<f32>, f32>>();
        }
    }
}
