//! The catalogue's evaluators against exact evaluation.

use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::fmt::Write;

use hodograph::{Regularity, Surface, catalogue};
use hodograph_algebra::{Enclosure, Poly};
use hodograph_codegen::round::nearest;
use hodograph_tests::catalogue::{Entry, entries};
use hodograph_tests::oracle::{Oracle, Truth, error, magnitude};
use hodograph_tests::precision::{Quantity, allowance};
use hodograph_tests::random::SplitMix64;

/// Random points of each surface, beside its corners and the middles of its edges.
const RANDOM_POINTS: usize = 1000;

/// Distances at which offset points are evaluated.
const DISTANCES: [f64; 4] = [-1.25, 0.0, 1.0 / 3.0, 2.0];

thread_local! {
    static ENTRIES: OnceCell<&'static [Entry]> = const { OnceCell::new() };
}

/// Runs `test` for each surface of the catalogue with what is derived from its formula.
fn for_each(mut test: impl FnMut(&'static dyn Surface, &Entry)) {
    let entries = entries();
    assert_eq!(entries.len(), catalogue::all().len(), "the catalogue misses a sweep");
    for &surface in catalogue::all() {
        let entry = entries.iter().find(|entry| entry.model.name == surface.name());
        test(surface, entry.unwrap_or_else(|| panic!("{} has no formula", surface.name())));
    }
}

/// The corners, the middles of the edges, and random points of a surface's domain.
fn parameters(surface: &dyn Surface) -> Vec<(f64, f64)> {
    let mut random = SplitMix64::new(20_140_101);
    let thirds = [0.0, 0.5, 1.0];
    let border = thirds.iter().flat_map(|&s| thirds.iter().map(move |&t| (s, t)));
    let border = border.filter(|&at| at != (0.5, 0.5));
    let random = (0..RANDOM_POINTS).map(|_| (random.next_f64(), random.next_f64()));
    border.chain(random).map(|(s, t)| surface.domain().at(s, t)).collect()
}
