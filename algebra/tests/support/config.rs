//! The configuration of property tests.

use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// So many cases, the same ones in every run.
pub(crate) fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        rng_seed: RngSeed::Fixed(0x50_48),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}
