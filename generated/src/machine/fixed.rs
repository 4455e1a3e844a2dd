//! Machines that have what the build assumes of them: nothing is asked at run time, and everything can be inlined.

use crate::dispatch::{Kernel, Variant};
use crate::float::HAS_FUSED;
use crate::real::{Float, Fused, Plain, Rounded};
use crate::task::{Stages, Task};

/// Whether the machine has fused multiply-add.
#[inline(always)]
pub(crate) fn has_fused() -> bool {
    HAS_FUSED
}

/// Runs a kernel, in the native variant if none is given.
#[inline(always)]
pub(crate) fn run<F: Float, K: Kernel<F>>(variant: Option<Variant>, kernel: K) -> K::Output {
    match variant.unwrap_or_else(Variant::native) {
        Variant::Plain => kernel.run::<Plain<F>>(),
        Variant::Fused => kernel.run::<Fused<F>>(),
    }
}

/// The same.
#[inline(always)]
pub(crate) fn run_wide<F: Float, K: Kernel<F>>(variant: Option<Variant>, kernel: K) -> K::Output {
    run(variant, kernel)
}

/// Evaluates no points, since compilers do it as well. Returns how many, and that all of them are finite.
#[inline(always)]
#[allow(clippy::extra_unused_type_parameters)]
pub(crate) fn points<T: Task, F: Float, S: Stages<T>, R: Rounded<F>>(
    _: &S,
    _: &[F],
    _: &[F],
    _: &mut [[F; 3]],
) -> (usize, bool) {
    (0, true)
}
