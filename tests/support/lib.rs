//! What the tests that cross packages share: the catalogue with everything derived from it, its layout for snapshots,
//! exact evaluation, and the tools to build what a test runs.

pub mod arithmetic;
pub mod build;
pub mod catalogue;
pub mod cost;
pub mod digest;
pub mod fixed;
pub mod layout;
pub mod measure;
pub mod oracle;
pub mod points;
pub mod precision;
pub mod random;
pub mod search;
pub mod surfaces;
pub mod verdicts;

/// The Rust examples of the README, run as documentation tests.
#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
pub struct Readme;
