//! Formulas and polynomials as LaTeX, for mathematics mode.

use hodograph_algebra::{Fraction, Poly, Rational, Term};

use crate::language::ast::{Argument, Expr, ExprKind, ProductOperator, RelationOperator, SumOperator};

/// Greek letters, which print as such.
const GREEK: &[&str] = &[
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "kappa", "lambda", "mu", "nu",
    "xi", "pi", "rho", "sigma", "tau", "phi", "chi", "psi", "omega",
];

/// Functions that LaTeX knows by name.
const OPERATORS: &[&str] = &["cos", "exp", "gcd", "sin"];

/// A polynomial as a sum of terms, in the order in which it prints as text.
///
/// ```
/// use hodograph_algebra::{Poly, Variable, integer, ratio};
/// use hodograph_codegen::emit::latex;
///
/// let (u, a) = (Poly::variable(&Variable::new(0, "u")), Poly::variable(&Variable::new(Variable::SYMBOL, "a10")));
/// let f = u.pow(12).scale(&ratio(-1, 2)) + Poly::sqrt_of(&integer(2)) * a * u;
/// assert_eq!(latex::poly(&f), "-\\frac{1}{2} u^{12} + \\sqrt{2} a_{10} u");
/// ```
#[must_use]
pub fn poly(poly: &Poly) -> String {
    terms(poly).concat()
}

/// The terms of a polynomial, each with the sign before it: lines may break between them.
#[must_use]
pub fn terms(poly: &Poly) -> Vec<String> {
    if poly.is_zero() {
        return vec!["0".to_owned()];
    }
    poly.terms().iter().enumerate().map(|(index, term)| signed_term(poly, term, index == 0)).collect()
}

/// A rational function, with the factors of its denominator.
///
/// ```
/// use hodograph_algebra::{Fraction, Poly, Variable};
/// use hodograph_codegen::emit::latex;
///
/// let u = Poly::variable(&Variable::new(0, "u"));
/// let f = Fraction::new(u.clone(), [(u.pow(2) + Poly::one(), 2)]);
/// assert_eq!(latex::fraction(&f), "\\frac{u}{(u^{2} + 1)^{2}}");
/// ```
#[must_use]
pub fn fraction(fraction: &Fraction) -> String {
    let numerator = poly(fraction.numerator());
    match fraction.factors() {
        [] => numerator,
        [(factor, 1)] => format!("\\frac{{{numerator}}}{{{}}}", poly(factor)),
        factors => {
            let power = |(factor, exponent): &(Poly, u32)| match exponent {
                1 => parenthesized(factor),
                _ => format!("{}^{{{exponent}}}", parenthesized(factor)),
            };
            format!("\\frac{{{numerator}}}{{{}}}", factors.iter().map(power).collect::<Vec<_>>().join(" "))
        }
    }
}

/// A name: digits at its end are an index, Greek letters are written as such, and longer names are upright.
///
/// ```
/// use hodograph_codegen::emit::latex;
///
/// assert_eq!(["u", "a10", "kappa", "path_b0"].map(latex::name), ["u", "a_{10}", "\\kappa", "\\mathrm{path\\_b}_{0}"]);
/// ```
#[must_use]
pub fn name(name: &str) -> String {
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let (stem, index) = if stem.is_empty() { (name, "") } else { (stem, &name[stem.len()..]) };
    let stem = match stem {
        greek if GREEK.contains(&greek) => format!("\\{greek}"),
        one if one.chars().count() == 1 => one.to_owned(),
        long => format!("\\mathrm{{{}}}", text(long)),
    };
    if index.is_empty() { stem } else { format!("{stem}_{{{index}}}") }
}

/// Plain text, with the characters escaped that have a meaning in LaTeX.
///
/// ```
/// use hodograph_codegen::emit::latex;
///
/// assert_eq!(latex::text("Farouki & Nittler, 50%"), "Farouki \\& Nittler, 50\\%");
/// ```
#[must_use]
pub fn text(text: &str) -> String {
    let mut escaped = String::new();
    for character in text.chars() {
        match character {
            '&' | '%' | '$' | '#' | '_' | '{' | '}' => escaped.extend(['\\', character]),
            '\\' => escaped.push_str("\\textbackslash{}"),
            '~' => escaped.push_str("\\textasciitilde{}"),
            '^' => escaped.push_str("\\textasciicircum{}"),
            _ => escaped.push(character),
        }
    }
    escaped
}

/// An expression of the sweep language: quotients as fractions, members as indices.
///
/// ```
/// use hodograph_codegen::emit::latex;
/// use hodograph_codegen::language::parse_expression;
///
/// let (expr, _) = parse_expression("formula", "s + (1 - u^2)/(1 + u^2)*s.normal + p.z*k").unwrap();
/// let expected = "s + \\frac{1 - u^{2}}{1 + u^{2}}\\, \\mathbf{n}_{s} + z_{p}\\, \\mathbf{k}";
/// assert_eq!(latex::expression(&expr), expected);
/// ```
#[must_use]
pub fn expression(expr: &Expr) -> String {
    match expr.kind() {
        ExprKind::Number(digits) => digits.replace('_', ""),
        ExprKind::Ident(ident) => match ident.as_str() {
            "i" | "j" | "k" => format!("\\mathbf{{{ident}}}"),
            "I" => "\\mathrm{i}".to_owned(),
            other => name(other),
        },
        ExprKind::Str(string) => format!("\\text{{{}}}", text(string)),
        ExprKind::Tuple(parts) => format!("\\left({}\\right)", list(parts)),
        ExprKind::Array(parts) => format!("\\left[{}\\right]", list(parts)),
        ExprKind::Call { callee, arguments } => call(callee, arguments),
        ExprKind::Member { object, member } => {
            let object = expression(object);
            match member.value.as_str() {
                "normal" => format!("\\mathbf{{n}}_{{{object}}}"),
                "tangent" => format!("\\mathbf{{t}}_{{{object}}}"),
                "curvature" => format!("\\kappa_{{{object}}}"),
                "speed" => format!("\\sigma_{{{object}}}"),
                other => format!("{}_{{{object}}}", name(other)),
            }
        }
        ExprKind::Negative(operand) => format!("-{}", operand_of_product(operand)),
        ExprKind::Not(operand) => format!("\\neg\\left({}\\right)", expression(operand)),
        ExprKind::Sum { first, rest } => {
            let mut sum = expression(first);
            for (operator, operand) in rest {
                let is_sum = matches!(operand.kind(), ExprKind::Sum { .. } | ExprKind::Negative(_));
                let operand = expression(operand);
                let operand = if is_sum { format!("\\left({operand}\\right)") } else { operand };
                sum += &match operator {
                    SumOperator::Plus => format!(" + {operand}"),
                    SumOperator::Minus => format!(" - {operand}"),
                };
            }
            sum
        }
        ExprKind::Product { first, rest } => product(first, rest),
        ExprKind::Power { base, exponent } => {
            let simple = matches!(base.kind(), ExprKind::Ident(_) | ExprKind::Number(_));
            let base = expression(base);
            let base = if simple { base } else { format!("\\left({base}\\right)") };
            format!("{base}^{{{}}}", expression(exponent))
        }
        ExprKind::Relation { left, operator, right } => {
            let operator = match operator {
                RelationOperator::Equal => "=",
                RelationOperator::NotEqual => "\\ne",
                RelationOperator::Less => "<",
                RelationOperator::LessEqual => "\\le",
                RelationOperator::Greater => ">",
                RelationOperator::GreaterEqual => "\\ge",
            };
            format!("{} {operator} {}", expression(left), expression(right))
        }
    }
}

/// `a*b/c*d`: a quotient covers all that stands before it.
fn product(first: &Expr, rest: &[(ProductOperator, Expr)]) -> String {
    let mut text = operand_of_product(first);
    // What becomes a numerator needs no parentheses.
    let mut bare = Some(expression(first));
    for (operator, operand) in rest {
        match operator {
            ProductOperator::Times => {
                text = format!("{text}\\, {}", operand_of_product(operand));
                bare = None;
            }
            ProductOperator::Over => {
                text = format!("\\frac{{{}}}{{{}}}", bare.take().unwrap_or(text), expression(operand));
            }
        }
    }
    text
}

fn operand_of_product(expr: &Expr) -> String {
    let text = expression(expr);
    match expr.kind() {
        ExprKind::Sum { .. } | ExprKind::Negative(_) | ExprKind::Relation { .. } | ExprKind::Not(_) => {
            format!("\\left({text}\\right)")
        }
        _ => text,
    }
}

fn call(callee: &Expr, arguments: &[Argument]) -> String {
    let listed = |argument: &Argument| match &argument.name {
        Some(named) => format!("{} = {}", name(&named.value), expression(&argument.value)),
        None => expression(&argument.value),
    };
    let arguments: Vec<String> = arguments.iter().map(listed).collect();
    if let (ExprKind::Ident(function), [radicand]) = (callee.kind(), arguments.as_slice())
        && function == "sqrt"
    {
        return format!("\\sqrt{{{radicand}}}");
    }
    let callee = match callee.kind() {
        ExprKind::Ident(function) if OPERATORS.contains(&function.as_str()) => format!("\\{function}"),
        ExprKind::Sum { .. } | ExprKind::Product { .. } => format!("\\left({}\\right)", expression(callee)),
        _ => expression(callee),
    };
    format!("{callee}\\left({}\\right)", arguments.join(", "))
}

fn list(parts: &[Expr]) -> String {
    parts.iter().map(expression).collect::<Vec<_>>().join(", ")
}

fn parenthesized(factor: &Poly) -> String {
    let text = poly(factor);
    if factor.terms().len() == 1 && !text.contains(['^', ' ', '-']) { text } else { format!("({text})") }
}

fn signed_term(poly: &Poly, term: &Term, first: bool) -> String {
    let coefficient = poly.content() * Rational::from(term.coefficient.clone());
    let digits = coefficient.numer().to_string();
    let (sign, absolute) = match (digits.strip_prefix('-'), first) {
        (Some(rest), true) => ("-", rest),
        (Some(rest), false) => (" - ", rest),
        (None, true) => ("", digits.as_str()),
        (None, false) => (" + ", digits.as_str()),
    };
    let ring = poly.ring();
    let generators = ring.field().generators().iter().zip(ring.generator_exponents(term.monomial));
    let mut factors: Vec<String> = generators
        .filter(|(_, exponent)| *exponent > 0)
        .map(|(generator, _)| root(generator.name()))
        .collect();
    let variables = ring.variables().iter().zip(ring.exponents(term.monomial));
    let variables: Vec<_> = variables.filter(|(_, exponent)| *exponent > 0).collect();
    let is_symbol = |rank: u32| rank >= hodograph_algebra::Variable::SYMBOL;
    for symbols in [true, false] {
        for (variable, exponent) in
            variables.iter().filter(|(variable, _)| is_symbol(variable.rank()) == symbols)
        {
            let base = name(variable.name());
            factors.push(if *exponent == 1 { base } else { format!("{base}^{{{exponent}}}") });
        }
    }
    let denominator = coefficient.denom().to_string();
    if denominator != "1" {
        factors.insert(0, format!("\\frac{{{absolute}}}{{{denominator}}}"));
    } else if absolute != "1" || factors.is_empty() {
        factors.insert(0, absolute.to_owned());
    }
    format!("{sign}{}", factors.join(" "))
}

/// A generator of the field by its name: a square root of an integer, or a letter.
fn root(generator: &str) -> String {
    match generator.strip_prefix("sqrt") {
        Some(radicand) => format!("\\sqrt{{{radicand}}}"),
        None => name(generator),
    }
}

#[cfg(test)]
mod tests {
    use hodograph_algebra::{Variable, ratio};

    use super::*;
    use crate::language::parse_expression;

    fn written(text: &str) -> String {
        let (expr, _) = parse_expression("test", text).unwrap_or_else(|wrong| panic!("{wrong}"));
        expression(&expr)
    }

    #[test]
    fn expressions() {
        for (text, latex) in [
            ("2*(a + b)", "2\\, \\left(a + b\\right)"),
            ("(a + b)/c", "\\frac{a + b}{c}"),
            ("2*a/b/c", "\\frac{\\frac{2\\, a}{b}}{c}"),
            ("-(a + b)", "-\\left(a + b\\right)"),
            ("a - (b - c)", "a - \\left(b - c\\right)"),
            ("(a + b)^2", "\\left(a + b\\right)^{2}"),
            ("sqrt(2)*cos(pi/8)", "\\sqrt{2}\\, \\cos\\left(\\frac{\\pi}{8}\\right)"),
            ("ph([1, I])", "\\mathrm{ph}\\left(\\left[1, \\mathrm{i}\\right]\\right)"),
            ("s.curvature <= 3", "\\kappa_{s} \\le 3"),
        ] {
            assert_eq!(written(text), latex);
        }
    }

    #[test]
    fn fractions_keep_their_factors() {
        let u = Poly::variable(&Variable::new(0, "u"));
        let f = Fraction::new(Poly::constant(ratio(-3, 2)), [(u.clone(), 2), (u.clone() + Poly::one(), 1)]);
        assert_eq!(fraction(&f), "\\frac{-\\frac{3}{2}}{u^{2} (u + 1)}");
        assert_eq!(fraction(&Fraction::zero()), "0");
    }
}
