//! x86-64 machines that are asked at run time: where they have fused multiply-add and vectors of 256 or 512 bits, these are used,
//! without a build for such a machine. What the build assumes of the machine is not asked.
//!
//! The width of vectors changes no bits: LLVM neither fuses nor reorders anything by itself. Whether products are fused before
//! they are added is what the kernel's numbers say, [`Plain`] or [`Fused`].
//!
//! This is the only module with unsafe code: calls of functions that are compiled for such machines, after the machine has been
//! asked; and its part `registers`, numbers that are vector registers.

#![allow(unsafe_code)]

#[path = "registers.rs"]
mod registers;

use std::arch::is_x86_feature_detected as has;

use crate::dispatch::{Kernel, Variant};
use crate::real::{Float, Fused, Plain, Rounded};

pub(crate) use registers::points;

/// Whether the machine has AVX2 and FMA. The standard library asks it once.
#[inline(always)]
pub(crate) fn has_fused() -> bool {
    has!("avx2") && has!("fma")
}

/// Whether the machine also has AVX-512 for floats and integers, in vectors of all lengths.
#[inline(always)]
fn has_512() -> bool {
    has_fused() && has!("avx512f") && has!("avx512dq") && has!("avx512vl") && has!("avx512bw")
}

/// Runs a kernel, in the native variant if none is given, with vectors of 256 bits where the machine has them: memory is written
/// no faster with wider ones.
#[inline(always)]
pub(crate) fn run<F: Float, K: Kernel<F>>(variant: Option<Variant>, kernel: K) -> K::Output {
    if cfg!(all(target_feature = "avx2", target_feature = "fma")) {
        // The code around this call is compiled for such machines, and can have the kernel inlined.
        match variant {
            None | Some(Variant::Fused) => kernel.run::<Fused<F>>(),
            Some(Variant::Plain) => kernel.run::<Plain<F>>(),
        }
    } else if has_fused() {
        match variant {
            // SAFETY: the machine has just been found to have AVX2 and FMA.
            None | Some(Variant::Fused) => unsafe { with_256::<F, Fused<F>, K>(kernel) },
            // SAFETY: as before.
            Some(Variant::Plain) => unsafe { with_256::<F, Plain<F>, K>(kernel) },
        }
    } else {
        match variant {
            None | Some(Variant::Plain) => with_128::<F, Plain<F>, K>(kernel),
            Some(Variant::Fused) => with_128::<F, Fused<F>, K>(kernel),
        }
    }
}

/// Runs a kernel, in the native variant if none is given, with the widest vectors that the machine has,
/// but for builds that assume AVX-512, in which compilers choose the width.
#[inline(always)]
pub(crate) fn run_wide<F: Float, K: Kernel<F>>(variant: Option<Variant>, kernel: K) -> K::Output {
    if cfg!(target_feature = "avx512f") {
        // As in `run`.
        run(variant, kernel)
    } else if has_512() {
        match variant {
            // SAFETY: the machine has just been found to have FMA and these parts of AVX-512.
            None | Some(Variant::Fused) => unsafe { with_512::<F, Fused<F>, K>(kernel) },
            // SAFETY: as before.
            Some(Variant::Plain) => unsafe { with_512::<F, Plain<F>, K>(kernel) },
        }
    } else {
        run(variant, kernel)
    }
}

/// The kernel, compiled for what the build assumes. It is not inlined, since callers then read all results alike.
#[inline(never)]
fn with_128<F: Float, R: Rounded<F>, K: Kernel<F>>(kernel: K) -> K::Output {
    kernel.run::<R>()
}

/// The kernel, compiled for AVX2 and FMA.
#[target_feature(enable = "avx2,fma")]
fn with_256<F: Float, R: Rounded<F>, K: Kernel<F>>(kernel: K) -> K::Output {
    kernel.run::<R>()
}

/// The kernel, compiled for AVX-512 and FMA.
#[target_feature(enable = "avx2,fma,avx512f,avx512dq,avx512vl,avx512bw")]
fn with_512<F: Float, R: Rounded<F>, K: Kernel<F>>(kernel: K) -> K::Output {
    kernel.run::<R>()
}
