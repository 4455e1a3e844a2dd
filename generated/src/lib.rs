//! Swept surfaces, exactly derived, with evaluators that are generated at build time.
//!
//! Each surface of the catalogue is expanded from its formula by `sweep!`: homogeneous coordinates, derivatives,
//! normals and offsets are derived by exact algebra and become straight-line `f64` code that depends on nothing.
//! Generic code takes any of them through the trait [`Surface`].
//!
//! Families have coefficients that are set at run time, and a constructor that checks them. The module [`ph`] finds the
//! preimages of Pythagorean-hodograph curves for them, [`bernstein::power_coefficients`] the coefficients of Bézier curves.
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
