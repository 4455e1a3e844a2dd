//! The meaning of the sweep language: from the syntax tree to curves, surfaces and verdicts.

mod calls;
mod curves;
mod expression;
mod fault;
mod item;
mod members;
mod number;
mod relation;
mod scope;
mod value;
mod witness;

pub use expression::MAX_EXPONENT;
pub use item::{Judgement, Model, models};
pub use number::number;
