//! Output: lines of text for people, JSON for programs.

use hodograph_algebra::Poly;
use hodograph_codegen::formula;
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
    formula::polynomial(poly, LONGEST)
}

/// Whether [`polynomial`] prints the whole of it.
pub(crate) fn is_short(poly: &Poly) -> bool {
    formula::is_short(poly, LONGEST)
}

/// A product of a number and of powers of polynomials, as a formula.
pub(crate) fn product(unit: &Poly, factors: &[(Poly, u32)]) -> String {
    formula::product(unit, factors, LONGEST)
}

/// A value as JSON, with a final line break.
pub(crate) fn json(value: &impl Serialize) -> String {
    match serde_json::to_string_pretty(value) {
        Ok(text) => text + "\n",
        // Only maps with other keys than strings, and foreign implementations, have no JSON.
        Err(error) => unreachable!("plain structures have a JSON form: {error}"),
    }
}

#[cfg(test)]
mod tests {
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
}
