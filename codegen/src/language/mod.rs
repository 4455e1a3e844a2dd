//! The sweep language: from a text or the tokens of a macro to a syntax tree, with every mistake at its place.
//!
//! ```text
//! file       = { item }                                          one at least
//! item       = ("sweep" | "lemma") name "{" { clause ";" } "}"
//! clause     = "source" text
//!            | "symbol" name { "," name }
//!            | "function" name "(" name ")" { "," name "(" name ")" }
//!            | "let" name [ "(" names ")" ] "=" expression
//!            | ("profile" | "path" | "curve" | "frames") name "(" name ")" "=" expression
//!            | "surface" name [ "(" name "," name ")" ] "=" expression
//!            | "prefer" ("fast" | "accurate")
//!            | "domain" name "in" sum ".." sum { "," … }
//!            | "claim" text ":" expression { "," remark }
//!            | "substitute" name [ "(" names ")" ] "=" expression
//! remark     = text | "expect" verdict | "when" expression | "instead" text | "effect" severity text
//! verdict    = "proved" | "refuted" | "undecided"
//! severity   = "major" | "moderate" | "minor"
//! expression = { "not" } sum [ ("==" | "!=" | "<" | "<=" | ">" | ">=") sum ]
//! sum        = product { ("+" | "-") product }
//! product    = unary { ("*" | "/") unary }
//! unary      = { "-" } postfix [ "^" unary ]
//! postfix    = primary { "." name | "(" [ arguments ] ")" }
//! primary    = number | name | text | "(" expression ")" | "(" expression "," expression … ")" | "[" … "]"
//! arguments  = [ name "=" ] expression { "," … }                 those with names last
//! ```
//!
//! A power binds as in mathematics: `-u^2` is −(u²), `2^-3` is 1/8, and `a^b^c` is a^(b^c). Every source is cut into
//! tokens as Rust cuts it, so that the same text means the same in a `.sweep` file, a string and a macro's body.
//! Comments are those of Rust; `///` documents the item or the clause that follows.
//!
//! A sweep has one surface and a domain for each of its two parameters; a lemma has no surface. Names of items are
//! unique in a file.

pub mod ast;
mod check;
mod clause;
mod diagnostic;
mod expression;
pub(crate) mod json;
mod lexer;
mod macro_tokens;
mod parser;
mod print;
mod report;
mod source;
mod spelling;
mod suggest;
mod token;

pub use diagnostic::{Diagnostic, Diagnostics};
pub use lexer::lex;
pub use macro_tokens::{MacroSource, adapt};
pub use parser::parse;
pub use report::Report;
pub use source::{Position, Source, decode, read_input};
pub use suggest::closest;
pub use token::{Span, SpanId, Token, TokenKind, Tokens};

use proc_macro2::TokenStream;

use ast::{Expr, File};

/// How deeply an expression may be nested.
pub const MAX_DEPTH: usize = 256;

/// How many bytes a text may have.
pub const MAX_LENGTH: usize = 1 << 20;

/// Reads a text.
///
/// # Errors
/// All mistakes in its syntax; a text longer than [`MAX_LENGTH`]; a sweep or a file that lacks what it must have.
///
/// ```
/// use hodograph_codegen::language::{ast::ClauseKind, parse_text};
///
/// let text = "sweep cylinder {
///     path s(u) = ((1 - u^2)/(1 + u^2), 2*u/(1 + u^2));
///     surface R = (s) + v*k;
///     domain u in 0..1, v in 0..1;
/// }";
/// let (file, _source) = parse_text("cylinder.sweep", text).unwrap();
/// let ClauseKind::Surface(surface) = &file.items[0].clauses[1].kind else { panic!() };
/// assert_eq!(surface.value.to_string(), "s + v*k");
///
/// let report = parse_text("circle.sweep", "lemma circle {\n  let c = 2u;\n}").unwrap_err();
/// assert_eq!(report.lines(), ["circle.sweep:2:11: `2u` is neither a number nor a product"]);
/// ```
pub fn parse_text(name: &str, text: &str) -> Result<(File, Source), Box<Report>> {
    let (tokens, source, mut diagnostics) = lex_limited(name, text)?;
    let (file, wrong) = parse(&tokens);
    diagnostics.append(wrong);
    if diagnostics.is_empty() { Ok((file, source)) } else { Err(Box::new(Report::new(source, diagnostics))) }
}

/// Reads a text that is one expression.
///
/// # Errors
/// All mistakes in its syntax; a text longer than [`MAX_LENGTH`].
///
/// ```
/// use hodograph_codegen::language::parse_expression;
///
/// let (expr, _source) = parse_expression("--u", "-(u^2) + (p.x)*s(1/2)").unwrap();
/// assert_eq!(expr.to_string(), "-u^2 + p.x*s(1/2)");
/// ```
pub fn parse_expression(name: &str, text: &str) -> Result<(Expr, Source), Box<Report>> {
    let (tokens, source, mut diagnostics) = lex_limited(name, text)?;
    let (expr, wrong) = parser::parse_single_expression(&tokens);
    diagnostics.append(wrong);
    match expr {
        Some(expr) if diagnostics.is_empty() => Ok((expr, source)),
        _ => Err(Box::new(Report::new(source, diagnostics))),
    }
}

/// Reads the input of a macro.
///
/// # Errors
/// All mistakes in its syntax as one error at the user's tokens; a sweep or an input that lacks what it must have.
///
/// ```
/// use hodograph_codegen::language::parse_macro;
///
/// let input: proc_macro2::TokenStream = "sweep a { domian u in 0..1; }".parse().unwrap();
/// let error = parse_macro(input).unwrap_err();
/// assert!(error.into_iter().any(|error| error.to_string().contains("did you mean `domain`?")));
/// ```
pub fn parse_macro(input: TokenStream) -> syn::Result<(File, MacroSource)> {
    let (tokens, source, mut diagnostics) = adapt(input);
    let (file, wrong) = parse(&tokens);
    diagnostics.append(wrong);
    match source.error(&diagnostics) {
        None => Ok((file, source)),
        Some(error) => Err(error),
    }
}

/// Reads a macro's input that is one expression.
#[cfg(test)]
fn parse_macro_expression(input: TokenStream) -> syn::Result<(Expr, MacroSource)> {
    let (tokens, source, mut diagnostics) = adapt(input);
    let (expr, wrong) = parser::parse_single_expression(&tokens);
    diagnostics.append(wrong);
    match (expr, source.error(&diagnostics)) {
        (_, Some(error)) => Err(error),
        (Some(expr), None) => Ok((expr, source)),
        (None, None) => unreachable!("no expression is a mistake"),
    }
}

/// The tokens of a text that is not too long.
fn lex_limited(name: &str, text: &str) -> Result<(Tokens, Source, Diagnostics), Box<Report>> {
    if text.len() <= MAX_LENGTH {
        return Ok(lex(name, text));
    }
    let (tokens, source, mut diagnostics) = lex(name, "");
    let message = format!("this source is {} bytes long, more than the limit of {MAX_LENGTH}", text.len());
    diagnostics.push(Diagnostic::new(tokens.at(0).span, message).help("split it into several files"));
    Err(Box::new(Report::new(source, diagnostics)))
}

#[cfg(test)]
mod tests;
