//! Numbers outside of items, such as the arguments of a command.

use hodograph_algebra::{Poly, budget};

use super::expression::place_of_exhaustion;
use super::fault::Fault;
use super::scope::Scope;
use crate::language::{Diagnostics, Report, parse_expression};

/// The real number that `text` says in the language, exactly: `-1/2`, `0.25`, `sqrt(2)/2`, `cos(pi/8)`. Errors call the
/// text `name`, and the number `role`; it may take `limit` units of work.
///
/// # Errors
/// Mistakes in the text; what is not a number; work beyond the limit.
///
/// ```
/// use hodograph_algebra::budget::DEFAULT_LIMIT;
/// use hodograph_codegen::meaning::number;
///
/// let parameter = |text| number("--u", "the parameter u", text, DEFAULT_LIMIT);
/// assert_eq!(parameter("1 - 0.25").unwrap().to_string(), "3/4");
/// assert_eq!(parameter("sqrt(8)/2").unwrap().to_string(), "sqrt2");
/// let report = parameter("1 + t").unwrap_err();
/// assert_eq!(report.lines(), ["--u:1:5: `t` is not defined"]);
/// ```
pub fn number(name: &str, role: &str, text: &str, limit: u64) -> Result<Poly, Box<Report>> {
    let (expr, source) = parse_expression(name, text)?;
    let scope = Scope::new(Vec::new(), limit);
    let value = match budget::with_budget(limit, || scope.number(&expr, role)) {
        Ok(value) => value,
        Err(exhausted) => Err(Fault::exhausted(place_of_exhaustion().unwrap_or(expr.span()), &exhausted)),
    };
    value.map_err(|fault| {
        let mut diagnostics = Diagnostics::new();
        diagnostics.push(*fault.diagnostic);
        Box::new(Report::new(source, diagnostics))
    })
}
