//! Numbers outside of items, such as the arguments of a command.

use hodograph_algebra::{Poly, budget};

use super::fault::Fault;
use super::scope::Scope;
use crate::language::{Diagnostics, Report, parse_expression};

/// The real number that `text` says in the language, exactly: `-1/2`, `0.25`, `sqrt(2)/2`, `cos(pi/8)`. Errors call the
/// text `name`, and the number `role`.
///
/// # Errors
/// Mistakes in the text; what is not a number; work beyond [`budget::DEFAULT_LIMIT`].
///
/// ```
/// use hodograph_codegen::meaning::number;
///
/// assert_eq!(number("--u", "the parameter u", "1 - 0.25").unwrap().to_string(), "3/4");
/// assert_eq!(number("--u", "the parameter u", "sqrt(8)/2").unwrap().to_string(), "sqrt2");
/// let report = number("--u", "the parameter u", "1 + t").unwrap_err();
/// assert_eq!(report.lines(), ["--u:1:5: `t` is not defined"]);
/// ```
pub fn number(name: &str, role: &str, text: &str) -> Result<Poly, Box<Report>> {
    let (expr, source) = parse_expression(name, text)?;
    let scope = Scope::new(Vec::new());
    let value = match budget::with_budget(budget::DEFAULT_LIMIT, || scope.number(&expr, role)) {
        Ok(value) => value,
        Err(exhausted) => Err(Fault::exhausted(expr.span(), &exhausted)),
    };
    value.map_err(|fault| {
        let mut diagnostics = Diagnostics::new();
        diagnostics.push(*fault.diagnostic);
        Box::new(Report::new(source, diagnostics))
    })
}
