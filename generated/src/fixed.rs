//! Machines that have what the build assumes of them: nothing is asked at run time, and everything can be inlined.

use crate::dispatch::{Kernel, Variant};
use crate::float::HAS_FUSED;
use crate::real::{Float, Fused, Plain};

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
