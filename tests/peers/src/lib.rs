//! What Hodograph's evaluators are measured against: other libraries, and generic evaluators that know of a surface no more than
//! its control net.
//!
//! The benchmark measures all of them in one run, in turns, and prints the ratios. From this folder, so that its
//! `.cargo/config.toml` has everything built for the processor at hand:
//!
//! ```text
//! cargo bench
//! ```
//!
//! The first line of a table is what the others are compared with: `ratio` is its rate in units of the line's own, `wanted` what it
//! should be. Before anything is timed, all alternatives are checked against de Casteljau's scheme, to 1e-12 in double precision.
//! `cargo bench -- normals` runs the works whose title has that word, `cargo bench -- --rounds 100` takes more turns.
//! `cargo test` checks that all evaluators agree.
//!
//! For processors with vectors of 512 bits, compilers prefer those of 256 when they build for the native processor; Hodograph's own choice
//! at run time, in builds for a general processor, takes the wide ones. What they are worth in a native build shows, but for independent
//! points, with
//! `RUSTFLAGS="-C target-cpu=native -C target-feature=-prefer-256-bit"`.
//!
//! The package is not published and not part of the workspace, so that nothing that it depends on is built with the rest.
//! `truck-geometry` is under the Apache-2.0 licence, `curvo` under MIT.

mod curvo;
mod de_casteljau;
mod hoisted;
mod horner;
mod net;
mod number;
mod quantity;
mod rational;
mod truck;

pub use curvo::Curvo;
pub use de_casteljau::DeCasteljau;
pub use hoisted::Hoisted;
pub use horner::Horner;
pub use net::Net;
pub use number::{LANES, Lanes, Number};
pub use quantity::{First, Local, Normal, Point, Quantity, Second};
pub use truck::Truck;

/// The value and the partial derivatives at a point, in the order R, R_u, R_v, R_uu, R_uv, R_vv, so far as they were asked for.
pub type Partials<N> = [[N; 3]; 6];

/// The same of the homogeneous coordinates (W, X, Y, Z).
pub type Jet<N> = [[N; 4]; 6];

/// An evaluator of single points.
pub trait Evaluator {
    /// The partial derivatives up to an order of 0, 1 or 2; what is beyond it is unspecified.
    fn partials(&self, order: usize, u: f64, v: f64) -> Partials<f64>;

    /// A quantity at a point.
    #[inline(always)]
    fn at<Q: Quantity<L>, const L: usize>(&self, u: f64, v: f64) -> [f64; L] {
        Q::of(&self.partials(Q::ORDER, u, v))
    }
}
