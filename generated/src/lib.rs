//! Swept surfaces, exactly derived, with evaluators that are generated at build time.
//!
//! Each surface of the catalogue is expanded from its formula by `sweep!`: homogeneous coordinates, derivatives,
//! normals, curvatures and offsets are derived by exact algebra and become straight-line code that depends on nothing.
//! Generic code takes any of them through the trait [`Surface`], in double and in single precision:
//!
//! ```
//! use hodograph::catalogue::oriented_translation_example_2::OrientedTranslationExample2;
//! use hodograph::{FirstOrder, Surface, Sweep, Undefined, Variant};
//!
//! let surface = OrientedTranslationExample2;
//! assert_eq!(surface.pinned(Variant::Plain).point(0.0, 0.0), Ok([1.0, 0.0, 0.0]));
//! let FirstOrder { point, partial_u, partial_v } = surface.first_order(0.25_f32, 0.5)?;
//! let mut grid = [[0.0; 3]; 6];
//! surface.grid(&[0.0, 0.5, 1.0], &[0.25, 0.75], &mut grid).unwrap();
//! assert_eq!(Ok(grid[4]), surface.point(0.5, 0.75));
//! # Ok::<(), Undefined>(())
//! ```
//!
//! [`Sweep::batch`] evaluates everything on grids, at independent points and row by row; [`Sweep::pinned`] fixes how products
//! are rounded, which otherwise is what the machine does fastest ([`Variant`]).
//!
//! Families have coefficients that are set at run time, and a constructor that checks them. The module [`ph`] finds the
//! preimages of Pythagorean-hodograph curves for them, [`bernstein::power_coefficients`] the coefficients of Bézier curves.
//!
//! # Build time
//!
//! A sweep is derived, and its bounds are proved, each time its crate is compiled, by a macro that Cargo does not optimize, in
//! `--release` neither. Most take some tenths of a second; the whole catalogue takes some 5 s. Where sweeps of your own take
//! many seconds, this in the `Cargo.toml` of your workspace saves a third of that, and makes the first build some 40 s of CPU longer:
//!
//! ```toml
//! [profile.dev.package.hodograph-algebra]
//! opt-level = 1
//! ```
//!
//! The table for `cargo build --release` is `[profile.release.package.hodograph-algebra]`.
//!
//! # Features
//!
//! Without the default feature `std` the library is `no_std`, and its square roots come from `libm` (feature `libm`).
//! The feature `rayon` evaluates grids on several threads, `Batch::parallel_grid`; `sources` adds the text of the catalogue's
//! formulas, and the page of the errors that were found in the papers.
//!
//! With `std` on x86-64, evaluators use fused multiply-add and AVX2 where the machine has both, and AVX-512 where that is faster.
//! Elsewhere they use what the build assumes of the machine. A build for the machine (`-C target-cpu=native`) makes single
//! evaluations faster, since they need no choice and are inlined. For machines with AVX-512 it makes batches in cache slower: compilers
//! then take vectors of 256 bits; `-C target-cpu=x86-64-v3` has the best of both.

#![cfg_attr(not(any(feature = "std", test)), no_std)]
#![deny(unsafe_code)]

// What `sweep!` expands to names `::hodograph`, in this crate too.
#[allow(unused_extern_crates)]
extern crate self as hodograph;

mod batch;
pub mod bernstein;
mod bounds;
pub mod catalogue;
mod dispatch;
#[cfg(feature = "sources")]
pub mod errors;
pub mod family;
pub mod float;
#[cfg_attr(all(feature = "std", target_arch = "x86_64"), path = "machine/detected.rs")]
#[cfg_attr(not(all(feature = "std", target_arch = "x86_64")), path = "machine/fixed.rs")]
mod machine;
mod output;
#[cfg(feature = "rayon")]
mod parallel;
pub mod ph;
mod pieces;
mod real;
#[cfg(feature = "sources")]
mod sources;
mod surface;
mod task;
#[cfg(test)]
mod testing;
mod tracked;
mod undefined;
mod values;

pub use batch::{Batch, BatchError, Rows, Values};
pub use bounds::{Bound, Bounds};
pub use dispatch::Variant;
pub use family::ParameterError;
pub use hodograph_macros::sweep;
pub use output::{Item, Output, Window};
pub use pieces::{Pieces, Piecewise, PiecewiseBatch, Visitor};
pub use real::{Float, Fused, Plain, Real, Rounded, constants, horner};
#[cfg(feature = "sources")]
pub use sources::{Source, inputs, runtime, sources};
pub use surface::{Domain, Patch, Surface, offset_net};
pub use task::{
    First, Homogeneous, Local, Normal, Part, Pinned, Point, Second, Separated, Staged, Stages, Sweep, Task,
};
pub use tracked::{NumberBound, error_bounds};
pub use undefined::Undefined;
pub use values::{FirstOrder, LocalGeometry, SecondOrder};
