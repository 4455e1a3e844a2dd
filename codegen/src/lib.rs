//! Language and code generation.

pub mod language;
pub mod meaning;
pub mod program;
pub mod schedule;
pub mod round;
pub mod emit;
