//! The meaning of the sweep language: from the syntax tree to curves, surfaces and verdicts.
//!
//! The grammar is that of [`language`](crate::language). This is the reference of what clauses, names, operators,
//! functions, members and relations stand for. FN is Farouki and Nittler, *Rational swept surface constructions based
//! on differential and integral sweep curve properties*, 2014; numbers in brackets are its equations. GE is Georgiev, *Rational
//! generalized offsets of rational surfaces*, 2012.
//!
//! ```
//! use hodograph_algebra::budget::DEFAULT_LIMIT;
//! use hodograph_codegen::language::{ast::Verdict, parse_text};
//! use hodograph_codegen::meaning::{Judgement, models};
//!
//! /// What becomes of the claims of a text.
//! fn judge(text: &str) -> Vec<Judgement> {
//!     let (file, _source) = parse_text("example.sweep", text).unwrap();
//!     let (models, mistakes) = models(&file);
//!     assert!(mistakes.is_empty());
//!     let check = |model: &hodograph_codegen::meaning::Model| -> Vec<Judgement> {
//!         model.claims.iter().map(|claim| model.check(claim, DEFAULT_LIMIT).unwrap()).collect()
//!     };
//!     models.iter().flat_map(check).collect()
//! }
//!
//! // The oriented-translation sweep (17) of a line along a PH cubic.
//! let judgements = judge(r#"sweep cylinder {
//!     profile p(u) = u*k;
//!     path s(v) = ph([1, 1 + I]);
//!     surface R = s + p.x*s.normal + p.z*k;
//!     domain u in 0..1, v in 0..1;
//!     claim "degree": degree(R) == (1, 3);
//!     claim "normal": parallel(normal(R), s.normal);
//! }"#);
//! assert!(judgements.iter().all(|judgement| judgement.verdict == Verdict::Proved));
//! assert_eq!(judgements[0].derived, "(1, 3)");
//! ```
//!
//! # Exactness
//!
//! A value is a rational function (or two, or three) of parameters, symbols and unknown functions over a tower of real
//! square roots; nothing is ever rounded. Two values are equal if they are the same function, which also says that a
//! claim speaks of all points at which both sides are defined.
#![doc = include_str!("reference/clauses.md")]
#![doc = include_str!("reference/values.md")]
#![doc = include_str!("reference/functions.md")]
#![doc = include_str!("reference/surfaces.md")]
#![doc = include_str!("reference/curves.md")]
#![doc = include_str!("reference/frames.md")]
#![doc = include_str!("reference/claims.md")]
#![doc = include_str!("reference/limits.md")]

mod assumptions;
mod bernstein;
mod calls;
mod clauses;
mod curves;
mod explain;
mod expression;
mod fault;
mod finding;
mod frames;
mod frames_file;
mod functions;
mod generality;
mod generic;
mod group;
mod inequality;
mod item;
mod judgement;
mod members;
mod number;
mod outline;
mod pieces;
mod products;
mod rationality;
mod relation;
mod roots;
mod scope;
mod spatial;
mod surfaces;
mod value;
mod witness;

pub use explain::{Explanation, Step};
pub use expression::MAX_EXPONENT;
pub use group::{CoefficientGroup, CoefficientKind};
pub use item::{Model, models, models_within};
pub use judgement::Judgement;
pub use number::number;
pub use pieces::Piece;
