//! Output: lines of text for people, JSON for programs.

use hodograph_algebra::Poly;
use serde::Serialize;

/// The width of what is printed, in characters.
pub const WIDTH: usize = 100;

/// How many characters of a polynomial are printed; further terms are only counted.
const LONGEST: usize = 600;

/// `first` and then `text`, broken at spaces into lines of at most [`WIDTH`] characters where that is possible; the lines
/// after the first one are indented by as much as `first` takes, at most by 20.
pub fn wrapped(first: &str, text: &str) -> String {
    let indent = first.chars().count().min(20);
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
pub fn cut(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        None => text.to_owned(),
        Some((end, _)) => {
            let kept = &text[..end];
            let end = kept.rfind(' ').filter(|space| *space > end / 2).unwrap_or(end);
            format!("{} …", text[..end].trim_end_matches([' ', '+', '-']))
        }
    }
}

/// A polynomial as a sum of terms; of a very long one the first terms and the number of all.
pub fn polynomial(poly: &Poly) -> String {
    let text = poly.to_string();
    if text.len() <= LONGEST { text } else { format!("{} ({} terms)", cut(&text, LONGEST), poly.terms().len()) }
}

/// Whether [`polynomial`] prints the whole of it.
pub fn is_short(poly: &Poly) -> bool {
    poly.to_string().len() <= LONGEST
}

/// A product of a number and of powers of polynomials, as a formula.
pub fn product(unit: &Poly, factors: &[(Poly, u32)]) -> String {
    let mut parts = Vec::new();
    if !unit.is_one() || factors.is_empty() {
        parts.push(if factors.is_empty() { polynomial(unit) } else { parenthesized(unit) });
    }
    let alone = factors.len() == 1 && parts.is_empty();
    for (factor, exponent) in factors {
        parts.push(match exponent {
            1 if alone => polynomial(factor),
            1 => parenthesized(factor),
            _ => format!("{}^{exponent}", parenthesized(factor)),
        });
    }
    parts.join("*")
}

/// A value as JSON, with a final line break.
pub fn json(value: &impl Serialize) -> String {
    match serde_json::to_string_pretty(value) {
        Ok(text) => text + "\n",
        // Only maps with other keys than strings, and foreign implementations, have no JSON.
        Err(error) => unreachable!("plain structures have a JSON form: {error}"),
    }
}

fn parenthesized(poly: &Poly) -> String {
    match poly.terms() {
        [_] if poly.to_rational().is_none_or(|value| value.is_integer()) && poly.content().is_integer() => {
            let text = poly.to_string();
            if text.contains(['^', '*']) { format!("({text})") } else { text }
        }
        _ => format!("({})", polynomial(poly)),
    }
}

#[cfg(test)]
mod tests {
    use hodograph_algebra::Variable;

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
        assert_eq!(product(&(&f * &u), &[]), "u^2 + u");
    }

    #[test]
    fn long_polynomials_are_cut_between_terms() {
        let (u, v) = (Poly::variable(&Variable::new(0, "u")), Poly::variable(&Variable::new(1, "v")));
        let long = (u + v + Poly::one()).pow(20);
        let text = polynomial(&long);
        assert!(text.len() < LONGEST + 40 && text.ends_with(" … (231 terms)"), "{text}");
        assert!(long.to_string().starts_with(text.trim_end_matches(" … (231 terms)")));
        assert!(!is_short(&long));
    }
}
