//! Swept surfaces, exactly derived, with evaluators that are generated at build time.
//!
//! Each surface of the catalogue is expanded from its formula by `sweep!`: homogeneous coordinates, derivatives,
//! normals and offsets are derived by exact algebra and become straight-line `f64` code that depends on nothing.
//! Generic code takes any of them through the trait [`Surface`].
//!
//! Families have coefficients that are set at run time, and a constructor that checks them. The module [`ph`] finds the
//! preimages of Pythagorean-hodograph curves for them, [`bernstein::power_coefficients`] the coefficients of Bézier curves.
//!
//! # Build time
//!
//! A sweep is derived each time its crate is compiled, by a macro that Cargo does not optimize, in `--release` neither. Most take
//! about a tenth of a second; the whole catalogue takes 1.8 s, and 0.7 s with optimized algebra. Where sweeps of your own take
//! seconds, this in the `Cargo.toml` of your workspace makes that saving, and the first build some 25 s of CPU longer:
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
//! The feature `sources` adds the text of the catalogue's formulas.

#![cfg_attr(not(any(feature = "std", test)), no_std)]
#![forbid(unsafe_code)]

// What `sweep!` expands to names `::hodograph`, in this crate too.
#[allow(unused_extern_crates)]
extern crate self as hodograph;

pub mod bernstein;
pub mod catalogue;
pub mod family;
pub mod float;
pub mod grid;
pub mod ph;
mod regularity;
#[cfg(feature = "sources")]
mod sources;
mod surface;

pub use family::ParameterError;
pub use grid::GridError;
pub use hodograph_macros::sweep;
pub use regularity::Regularity;
#[cfg(feature = "sources")]
pub use sources::{Source, runtime, sources};
pub use surface::{Domain, Surface};
