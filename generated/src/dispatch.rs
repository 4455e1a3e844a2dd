//! How products are rounded, and the choice of the instructions that computations are compiled for.

use crate::machine;
use crate::real::{Float, Rounded};

/// How products that are added are rounded.
///
/// Within one variant all evaluators of a surface give the same bits, for single points and batches, on every machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variant {
    /// Products are rounded before they are added.
    Plain,
    /// Products are added unrounded, by fused multiply-add. On a machine without the instruction, software computes the same
    /// bits many times slower.
    Fused,
}

impl Variant {
    /// The variant that is used where none is pinned: [`Fused`](Variant::Fused) where the machine has the instruction, which
    /// without `std` is what the build assumes of it.
    #[inline]
    #[must_use]
    pub fn native() -> Self {
        if machine::has_fused() { Self::Fused } else { Self::Plain }
    }
}

/// A computation that can be compiled for several instruction sets and in both variants.
pub(crate) trait Kernel<F: Float> {
    /// What is computed.
    type Output;

    /// Computes it. Implementations are `#[inline(always)]`, as is all that they call for many points, so that they are
    /// compiled for the instructions of their caller.
    fn run<R: Rounded<F>>(self) -> Self::Output;
}

/// Runs a kernel, in the native variant if none is given.
#[inline(always)]
pub(crate) fn run<F: Float, K: Kernel<F>>(variant: Option<Variant>, kernel: K) -> K::Output {
    machine::run(variant, kernel)
}

/// Runs a kernel that works on many numbers in the fastest cache, where wide vectors are the fastest, in the native variant if
/// none is given.
#[inline(always)]
pub(crate) fn run_wide<F: Float, K: Kernel<F>>(variant: Option<Variant>, kernel: K) -> K::Output {
    machine::run_wide(variant, kernel)
}

#[cfg(test)]
mod tests {
    use super::{Kernel, Variant, run, run_wide};
    use crate::real::{Float, Rounded};

    /// a·b + c.
    struct MultiplyAdd<F>(F, F, F);

    impl<F: Float> Kernel<F> for MultiplyAdd<F> {
        type Output = F;

        #[inline(always)]
        fn run<R: Rounded<F>>(self) -> F {
            R::new(self.0).mul_add(R::new(self.1), R::new(self.2)).value()
        }
    }

    #[test]
    fn variants_round_as_they_say_on_every_machine() {
        let (a, b) = (1.0 + f64::EPSILON, 1.0 - f64::EPSILON);
        let of = |variant| {
            let result = run(variant, MultiplyAdd(a, b, -1.0));
            assert_eq!(result, run_wide(variant, MultiplyAdd(a, b, -1.0)));
            result
        };
        let fused = -f64::EPSILON * f64::EPSILON;
        assert_eq!((of(Some(Variant::Plain)), of(Some(Variant::Fused))), (0.0, fused));
        assert_eq!(of(None), if Variant::native() == Variant::Fused { fused } else { 0.0 });
        let (a, b) = (1.0 + f32::EPSILON, 1.0 - f32::EPSILON);
        assert_eq!(run(Some(Variant::Plain), MultiplyAdd(a, b, -1.0)), 0.0);
        assert_eq!(run(Some(Variant::Fused), MultiplyAdd(a, b, -1.0)), -f32::EPSILON * f32::EPSILON);
    }
}
