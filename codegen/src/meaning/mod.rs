//! The meaning of the sweep language: from the syntax tree to curves, surfaces and verdicts.

mod calls;
mod curves;
mod expression;
mod fault;
mod functions;
mod item;
mod judgement;
mod members;
mod number;
mod relation;
mod scope;
mod value;
mod witness;

pub use expression::MAX_EXPONENT;
pub use item::{Model, models};
pub use judgement::Judgement;
pub use number::number;
