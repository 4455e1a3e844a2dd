//! Language and code generation.

pub mod program;
