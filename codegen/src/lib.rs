//! Language and code generation: from the text of a sweep to verdicts on its claims and to source code that evaluates it.
//!
//! ```text
//! text | tokens --language--> syntax tree --meaning--> Model --compile--> Artifact --emit--> source
//! ```

pub mod bound;
mod builder;
mod certificates;
mod choice;
pub mod compile;
pub mod emit;
pub mod expansion;
pub mod formula;
pub mod language;
pub mod meaning;
mod offset;
pub mod program;
pub mod proofs;
pub mod round;
pub mod schedule;

pub use builder::{BuildError, Builder};
pub use offset::OffsetPatch;
