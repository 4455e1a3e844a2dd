//! Output: lines of text for people, JSON for programs.

use hodograph_algebra::{Poly, Variable};
use serde::Serialize;

/// The width of what is printed, in characters.
pub(crate) const WIDTH: usize = 100;

/// The most that a continued line is indented.
const INDENT: usize = 40;

/// How many characters of a polynomial are printed; further terms are only counted.
const LONGEST: usize = 600;

/// `first` and then `text`, broken at spaces into lines of at most [`WIDTH`] characters where that is possible; the lines
/// after the first one are indented by as much as `first` takes, at most by [`INDENT`].
pub(crate) fn wrapped(first: &str, text: &str) -> String {
    let indent = first.chars().count().min(INDENT);
    let mut lines = vec![first.to_owned()];
    let mut length = first.chars().count();
    let mut fresh = true;
    for word in text.split(' ') {
        let size = word.chars().count();
        if !fresh && length + 1 + size > WIDTH {
            lines.push(" ".repeat(indent));
            length = indent;
            fresh = true;
        }
        if let Some(line) = lines.last_mut() {
            if !fresh {
                line.push(' ');
                length += 1;
            }
            line.push_str(word);
            length += size;
            fresh = false;
        }
    }
    let lines: Vec<&str> = lines.iter().map(|line| line.trim_end()).collect();
    lines.join("\n")
}

/// At most `most` characters of a text, with `…` for the rest.
pub(crate) fn cut(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        None => text.to_owned(),
        Some((end, _)) => {
            let kept = &text[..end];
            let end = kept.rfind(' ').filter(|space| *space > end / 2).unwrap_or(end);
            format!("{} …", text[..end].trim_end_matches([' ', '+', '-']))
        }
    }
}

/// A polynomial as a sum of monomials with their coefficients in the field, such as `(sqrt2 + 1)*u^2 + 3`; of a very long
/// one the first monomials and the number of all.
pub(crate) fn polynomial(poly: &Poly) -> String {
    let monomials = monomials(poly);
    if monomials.iter().map(String::len).sum::<usize>() <= LONGEST {
        return monomials.concat();
    }
    let mut text = String::new();
    for monomial in monomials.iter().take_while(|monomial| !monomial.is_empty()) {
        if text.len() + monomial.len() > LONGEST && !text.is_empty() {
            break;
        }
        text += monomial;
    }
    format!("{text} + … ({} monomials)", monomials.len())
}

/// Whether [`polynomial`] prints the whole of it.
pub(crate) fn is_short(poly: &Poly) -> bool {
    monomials(poly).iter().map(String::len).sum::<usize>() <= LONGEST
}

/// The monomials in the variables, each with its coefficient and the sign before it.
fn monomials(poly: &Poly) -> Vec<String> {
    let variables = poly.occurring_variables();
    if variables.is_empty() {
        return vec![poly.to_string()];
    }
    let mut signed = Vec::new();
    for (exponents, coefficient) in
        poly.coefficients_of(&variables).iter().rev().filter(|(_, c)| !c.is_zero())
    {
        let powers = variables.iter().zip(exponents).filter(|(_, exponent)| **exponent > 0);
        // Symbols before parameters, as polynomials print.
        let (symbols, parameters): (Vec<_>, Vec<_>) = powers.partition(|(v, _)| v.rank() >= Variable::SYMBOL);
        let power = |(variable, exponent): (&Variable, &u32)| match exponent {
            1 => variable.to_string(),
            _ => format!("{variable}^{exponent}"),
        };
        let monomial = symbols.into_iter().chain(parameters).map(power).collect::<Vec<_>>().join("*");
        let text = coefficient.to_string();
        let (sign, factor) = match coefficient.terms() {
            [_] => text.strip_prefix('-').map_or(("+", text.clone()), |rest| ("-", rest.to_owned())),
            _ if monomial.is_empty() => ("+", text.clone()),
            _ => ("+", format!("({text})")),
        };
        let term = match (factor.as_str(), monomial.as_str()) {
            (_, "") => factor,
            ("1", _) => monomial,
            _ => format!("{factor}*{monomial}"),
        };
        // A coefficient without a monomial is a sum that continues this one.
        signed.push(match (signed.is_empty(), sign) {
            (true, "+") => term,
            (true, _) => format!("-{term}"),
            (false, "+") => match term.strip_prefix('-') {
                Some(rest) => format!(" - {rest}"),
                None => format!(" + {term}"),
            },
            (false, _) => format!(" - {term}"),
        });
    }
    signed
}

/// A product of a number and of powers of polynomials, as a formula.
pub(crate) fn product(unit: &Poly, factors: &[(Poly, u32)]) -> String {
    if factors.is_empty() {
        return polynomial(unit);
    }
    let mut parts = Vec::new();
    let rational = unit.to_rational();
    let sign = if *unit == Poly::integer(-1) { "-" } else { "" };
    if sign.is_empty() && !unit.is_one() {
        parts.push(rational.map_or_else(|| parenthesized(unit), |value| value.to_string()));
    }
    let alone = factors.len() == 1 && parts.is_empty() && sign.is_empty();
    for (factor, exponent) in factors {
        parts.push(match exponent {
            1 if alone => polynomial(factor),
            1 => parenthesized(factor),
            _ => format!("{}^{exponent}", parenthesized(factor)),
        });
    }
    format!("{sign}{}", parts.join("*"))
}

/// A value as JSON, with a final line break.
pub(crate) fn json(value: &impl Serialize) -> String {
    match serde_json::to_string_pretty(value) {
        Ok(text) => text + "\n",
        // Only maps with other keys than strings, and foreign implementations, have no JSON.
        Err(error) => unreachable!("plain structures have a JSON form: {error}"),
    }
}

fn parenthesized(poly: &Poly) -> String {
    let text = polynomial(poly);
    if text.contains(['^', '*', '/', ' ', '-']) { format!("({text})") } else { text }
}

#[cfg(test)]
mod tests {
    use hodograph_algebra::integer;

    use super::*;

    #[test]
    fn lines_are_broken_at_spaces() {
        let text = vec!["word"; 60].join(" ");
        let lines = wrapped("  a  ", &text);
        assert!(lines.lines().all(|line| line.chars().count() <= WIDTH), "{lines}");
        assert_eq!(lines.lines().count(), 4);
        assert!(lines.lines().skip(1).all(|line| line.starts_with("     word")));
        assert_eq!(lines.replace("\n    ", ""), format!("  a  {text}"));
        let long = "x".repeat(300);
        assert_eq!(wrapped("a ", &long), format!("a {long}"));
    }

    #[test]
    fn products() {
        let u = Poly::variable(&Variable::new(0, "u"));
        let f = &u + Poly::one();
        assert_eq!(product(&Poly::one(), &[]), "1");
        assert_eq!(product(&Poly::one(), &[(f.clone(), 1)]), "u + 1");
        assert_eq!(product(&Poly::integer(-2), &[(u.clone(), 1), (f.clone(), 2)]), "-2*u*(u + 1)^2");
        assert_eq!(product(&Poly::integer(-1), &[(f.clone(), 1)]), "-(u + 1)");
        assert_eq!(product(&(&f * &u), &[]), "u^2 + u");
    }

    #[test]
    fn coefficients_are_collected() {
        let (u, a) =
            (Poly::variable(&Variable::new(0, "u")), Poly::variable(&Variable::new(Variable::SYMBOL, "a")));
        let number = Poly::sqrt_of(&integer(2)) - Poly::one();
        let f = &number * u.pow(2) * &a - &u * &a + u.pow(2) + &u - &number;
        assert_eq!(polynomial(&f), "(sqrt2 - 1)*a*u^2 + u^2 - a*u + u - sqrt2 + 1");
        assert_eq!(polynomial(&-(&u * &number)), "(-sqrt2 + 1)*u");
        assert_eq!(polynomial(&-u), "-u");
        assert_eq!(polynomial(&number), "sqrt2 - 1");
        assert_eq!(polynomial(&Poly::zero()), "0");
    }

    #[test]
    fn long_polynomials_are_cut_between_terms() {
        let (u, v) = (Poly::variable(&Variable::new(0, "u")), Poly::variable(&Variable::new(1, "v")));
        let long = (u + v + Poly::one()).pow(20);
        let text = polynomial(&long);
        let end = " + … (231 monomials)";
        assert!(text.len() < LONGEST + 40 && text.ends_with(end), "{text}");
        assert!(long.to_string().starts_with(text.trim_end_matches(end)));
        assert!(!is_short(&long));
    }
}
