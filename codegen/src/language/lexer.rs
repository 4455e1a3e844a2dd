//! Text to tokens. A text is cut as Rust would cut it, and what is no token is reported without stopping.

use std::ops::Range;

use super::diagnostic::{Diagnostic, Diagnostics};
use super::source::Source;
use super::spelling;
use super::token::{Span, SpanId, Token, TokenKind, Tokens, shortened};

/// The tokens of a text, the source that knows their places, and what was wrong.
///
/// Every character belongs to a token, a comment or a reported mistake. Takes O(length).
pub fn lex(name: &str, text: &str) -> (Tokens, Source, Diagnostics) {
    let mut lexer = Lexer { text, at: 0, tokens: vec![], places: vec![], diagnostics: Diagnostics::new() };
    while let Some(character) = lexer.peek() {
        lexer.token(character);
    }
    let end = text.trim_end().len();
    let end = lexer.place(end..end);
    (Tokens::new(lexer.tokens, end), Source::new(name, text, lexer.places), lexer.diagnostics)
}

struct Lexer<'a> {
    text: &'a str,
    at: usize,
    tokens: Vec<Token>,
    places: Vec<Range<usize>>,
    diagnostics: Diagnostics,
}

impl Lexer<'_> {
    /// Reads the token, the space or the comment that begins with `character`.
    fn token(&mut self, character: char) {
        let start = self.at;
        if is_space(character) {
            self.at += character.len_utf8();
        } else if self.rest().starts_with("//") {
            self.line_comment();
        } else if self.rest().starts_with("/*") {
            self.block_comment();
        } else if character.is_ascii_digit() {
            self.at += number_length(self.rest());
            self.push(start, spelling::number);
        } else if spelling::begins_name(character) {
            self.name();
        } else if character == '"' {
            self.string(start);
        } else if character == '\'' {
            self.single_quote();
        } else if matches!(character, '“' | '”' | '„') {
            self.typographic_string(character);
        } else {
            let next = self.rest()[character.len_utf8()..].chars().next();
            if let Some(kind) = next.and_then(|next| spelling::pair(character, next)) {
                self.at += 2;
                self.push(start, |_, _| (kind, None));
            } else if let Some(kind) = spelling::single(character) {
                self.at += 1;
                self.push(start, |_, _| (kind, None));
            } else {
                self.take_while(|c| c == character);
                let span = self.place(start..self.at);
                let (meant, wrong) = spelling::unknown(character, span);
                self.diagnostics.push(wrong);
                self.tokens.extend(meant.into_iter().map(|kind| Token { kind, span }));
            }
        }
    }

    fn line_comment(&mut self) {
        let start = self.at;
        self.take_while(|c| c != '\n');
        let comment = self.text[start..self.at].trim_end_matches('\r');
        if comment.starts_with("//!") {
            let span = self.place(start..start + comment.len());
            self.diagnostics.push(spelling::inner_documentation(span));
        } else if let Some(text) = comment.strip_prefix("///").filter(|text| !text.starts_with('/')) {
            self.documentation(start..start + comment.len(), text);
        }
    }

    fn block_comment(&mut self) {
        let start = self.at;
        let mut depth = 0;
        loop {
            if self.rest().starts_with("/*") {
                depth += 1;
                self.at += 2;
            } else if self.rest().starts_with("*/") {
                depth -= 1;
                self.at += 2;
                if depth == 0 {
                    break;
                }
            } else if let Some(character) = self.peek() {
                self.at += character.len_utf8();
            } else {
                let span = self.place(start..start + 2);
                self.diagnostics
                    .push(Diagnostic::new(span, "this comment is not closed").help("close it with `*/`"));
                return;
            }
        }
        let comment = &self.text[start..self.at];
        let is_documentation =
            comment.starts_with("/**") && !comment.starts_with("/***") && comment != "/**/";
        if comment.starts_with("/*!") {
            let span = self.place(start..self.at);
            self.diagnostics.push(spelling::inner_documentation(span));
        } else if is_documentation {
            self.documentation(start..self.at, &comment[3..comment.len() - 2]);
        }
    }

    fn documentation(&mut self, range: Range<usize>, text: &str) {
        let span = self.place(range);
        self.tokens.push(Token { kind: TokenKind::DocComment(text.replace("\r\n", "\n")), span });
    }

    fn name(&mut self) {
        let start = self.at;
        self.take_while(spelling::continues_name);
        let word = &self.text[start..self.at];
        let byte = if word == "b" { character_length(self.rest()) } else { None };
        // `b'c'`, `b"…"`, `r"…"` and their kin are single tokens of Rust.
        if let Some(length) = byte {
            self.at += length;
            self.push(start, spelling::foreign_literal);
            return;
        }
        match self.peek() {
            Some('"') if matches!(word, "b" | "c" | "r" | "br" | "cr") => {
                self.at += string_length(self.rest()).0;
                self.push(start, spelling::foreign_literal);
            }
            Some('"') => {
                self.push(start, spelling::name);
                self.missing_space(format!("a space is missing after `{}`", shortened(word)));
            }
            Some('#') if word == "r" && self.rest()[1..].starts_with(spelling::begins_name) => {
                self.at += 1;
                self.take_while(spelling::continues_name);
                self.push(start, spelling::name);
            }
            _ => self.push(start, spelling::name),
        }
    }

    /// A string from its opening quote on, which is at `self.at`.
    fn string(&mut self, start: usize) {
        let (length, closed) = string_length(self.rest());
        self.at += length;
        if closed {
            self.push(start, |text, span| spelling::string(&text[1..text.len() - 1], span));
            if self.peek().is_some_and(spelling::begins_name) {
                self.missing_space("a space is missing after this text".to_string());
            }
        } else {
            self.push(start, |text, span| {
                let (kind, _) = spelling::string(&text[1..], span);
                (kind, Some(Diagnostic::new(span, "this text is not closed").help("close it with `\"`")))
            });
        }
    }

    /// `“…”`, which word processors make of `"…"`: one mistake, and the text that was meant.
    fn typographic_string(&mut self, quote: char) {
        let start = self.at;
        self.at += quote.len_utf8();
        let body = self.at;
        self.take_while(|c| !matches!(c, '“' | '”' | '„' | '"' | '\n'));
        let text = self.text[body..self.at].trim_end_matches('\r').to_string();
        if let Some(closing) = self.peek().filter(|&c| c != '\n') {
            self.at += closing.len_utf8();
        }
        self.push(start, |_, span| (TokenKind::Str(text), Some(spelling::unknown(quote, span).1)));
    }

    /// A prime, or a character literal of Rust.
    fn single_quote(&mut self) {
        let start = self.at;
        let before = self.text[..start].chars().next_back();
        let of = match self.tokens.last() {
            Some(Token { kind: TokenKind::Ident(name), .. }) => Some(name.clone()),
            _ => None,
        };
        let is_prime = before.is_some_and(|c| spelling::continues_name(c) || matches!(c, ')' | ']' | '\''));
        let length = if is_prime { None } else { character_length(self.rest()) };
        if let Some(length) = length {
            self.at += length;
            self.push(start, spelling::foreign_literal);
        } else {
            self.take_while(|c| c == '\'');
            let span = self.place(start..self.at);
            self.diagnostics.push(spelling::prime(of.as_deref(), span));
        }
    }

    fn missing_space(&mut self, message: String) {
        let character = self.peek().map_or(0, char::len_utf8);
        let span = self.place(self.at..self.at + character);
        self.diagnostics.push(Diagnostic::new(span, message).help("write a space here"));
    }

    fn rest(&self) -> &str {
        &self.text[self.at..]
    }

    fn peek(&self) -> Option<char> {
        self.rest().chars().next()
    }

    fn take_while(&mut self, continues: impl Fn(char) -> bool) {
        let rest = self.rest();
        self.at += rest.find(|c| !continues(c)).unwrap_or(rest.len());
    }

    fn place(&mut self, range: Range<usize>) -> Span {
        let id = SpanId(self.places.len() as u32);
        self.places.push(range);
        Span::at(id)
    }

    /// Adds the token that is spelled by the text from `start` to here.
    fn push(&mut self, start: usize, spell: impl FnOnce(&str, Span) -> (TokenKind, Option<Diagnostic>)) {
        let span = self.place(start..self.at);
        let (kind, wrong) = spell(&self.text[start..self.at], span);
        if let Some(wrong) = wrong {
            self.diagnostics.push(wrong);
        }
        self.tokens.push(Token { kind, span });
    }
}

/// White space as Rust knows it (Unicode's Pattern_White_Space).
fn is_space(character: char) -> bool {
    character.is_ascii_whitespace()
        || matches!(character, '\u{b}' | '\u{85}' | '\u{200e}' | '\u{200f}' | '\u{2028}' | '\u{2029}')
}

/// The length of the number at the beginning of the text, cut as Rust cuts it: `0` of `0..1`, `1.5` of `1.5.x`,
/// `2u` of `2u + 1`.
fn number_length(text: &str) -> usize {
    let after = |from: usize, part: fn(char) -> bool| {
        text[from..].find(|c| !part(c)).map_or(text.len(), |length| from + length)
    };
    let is_digit = |c: char| c.is_ascii_digit() || c == '_';
    let has_radix = ["0x", "0o", "0b"].iter().any(|prefix| text.starts_with(prefix));
    let mut end = after(0, is_digit);
    let beyond_point = text[end..].strip_prefix('.').map(|rest| rest.chars().next());
    let is_fraction =
        beyond_point.is_some_and(|next| next.is_none_or(|next| next != '.' && !spelling::begins_name(next)));
    if is_fraction && !has_radix {
        end = after(end + 1, is_digit);
    }
    if let Some(exponent) = text[end..].strip_prefix(['e', 'E']).filter(|_| !has_radix) {
        let digits = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
        if digits.trim_start_matches('_').starts_with(|c: char| c.is_ascii_digit()) {
            end = after(text.len() - digits.len(), is_digit);
        }
    }
    after(end, spelling::continues_name)
}

/// The length of the string whose opening quote (perhaps after a prefix) begins the text, and whether it is closed;
/// one that is not closed on its line goes to the end of that line.
fn string_length(text: &str) -> (usize, bool) {
    let mut is_escaped = false;
    for (at, character) in text.char_indices().skip(1) {
        match character {
            '\n' => return (text[..at].trim_end_matches('\r').len(), false),
            '"' if !is_escaped => return (at + 1, true),
            _ => is_escaped = character == '\\' && !is_escaped,
        }
    }
    (text.len(), false)
}

/// The length of the character literal `'c'` at the beginning of the text, if there is one.
fn character_length(text: &str) -> Option<usize> {
    let mut characters = text.char_indices();
    let (_, _quote) = characters.next().filter(|&(_, quote)| quote == '\'')?;
    let (_, first) = characters.next()?;
    if first == '\\' {
        let _escaped = characters.next()?;
    } else if first == '\n' || first == '\'' {
        return None;
    }
    let (at, closing) = characters.next()?;
    (closing == '\'').then_some(at + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kinds(text: &str) -> Vec<TokenKind> {
        let (tokens, _, diagnostics) = lex("test", text);
        assert!(diagnostics.is_empty(), "{text}: {diagnostics:?}");
        let mut kinds = tokens.kinds();
        assert_eq!(kinds.pop(), Some(TokenKind::End));
        kinds
    }

    /// The first mistake with the text at its place and what to do.
    fn mistake(text: &str) -> (String, String, String) {
        let (_, source, diagnostics) = lex("test", text);
        let first = diagnostics.iter().next().unwrap_or_else(|| panic!("nothing wrong in {text}"));
        let place = source.text()[source.range(first.span)].to_string();
        (first.message.clone(), place, first.help.clone().unwrap_or_default())
    }

    #[test]
    fn numbers_are_cut_as_in_rust() {
        use TokenKind::{Dot, DotDot, Ident, Minus, Number};
        let number = |text: &str| Number(text.into());
        assert_eq!(kinds("0..1"), [number("0"), DotDot, number("1")]);
        assert_eq!(kinds("0.5..1.5"), [number("0.5"), DotDot, number("1.5")]);
        assert_eq!(kinds("1...2"), [number("1"), DotDot, Dot, number("2")]);
        assert_eq!(kinds("1_000.2_5e-1_0"), [number("1000.25e-10")]);
        assert_eq!(kinds("1.x"), [number("1"), Dot, Ident("x".into())]);
        assert_eq!(kinds("1.5.x"), [number("1.5"), Dot, Ident("x".into())]);
        assert_eq!(kinds("1e5-2"), [number("1e5"), Minus, number("2")]);
    }

    #[test]
    fn mistakes_name_place_and_remedy() {
        for (text, place, help) in [
            ("x + 2u", "2u", "write 2*u"),
            ("2.5sqrt(2)", "2.5sqrt", "write 2.5*sqrt"),
            ("2e", "2e", "write 2*e"),
            ("1f64", "1f64", "write 1: numbers are exact and have no type"),
            ("1. ", "1.", "write 1.0 or 1"),
            ("a*0x10", "0x10", "write 16"),
            ("0b12", "0b12", "write decimal digits"),
            ("x' + y", "'", "write `diff(x, v)`, with the parameter that it is differentiated by"),
            ("s(v)''", "''", "write `diff(x, v)`, with the parameter that it is differentiated by"),
            ("= 'c'", "'c'", "a text stands in plain double quotes: \"…\""),
            ("b x' y", "'", "write `diff(x, v)`, with the parameter that it is differentiated by"),
            ("r\"c\"", "r\"c\"", "a text stands in plain double quotes: \"…\""),
            ("a \"b;\nc", "\"b;", "close it with `\"`"),
            ("\"\\q\"", "\"\\q\"", "write `\\\\` for a backslash itself"),
            ("a /* b /* c */", "/*", "close it with `*/`"),
            ("√2", "√", "write `sqrt(…)`"),
            ("u²", "²", "write `^2`"),
            ("a ≤ b", "≤", "write `<=`"),
            ("a − b", "−", "write the minus sign `-`"),
            ("“a” b", "“a”", "write plain double quotes `\"` around a text"),
            ("2*σ_1", "σ_1", "write `sigma_1`"),
            ("Ω", "Ω", "write `Omega`"),
            ("straße", "straße", "names are made of the letters a to z and A to Z, digits and `_`"),
            ("a\u{a0}b", "\u{a0}", "write a plain space"),
            ("source\"b\"", "\"", "write a space here"),
            ("a && b", "&&", "write a claim for each relation, or `when` before a condition"),
            ("//! x", "//! x", "write `///` before a sweep, or `//` for a comment"),
        ] {
            let (message, at, remedy) = mistake(text);
            assert_eq!((at.as_str(), remedy.as_str()), (place, help), "{text}: {message}");
        }
    }

    #[test]
    fn mistakes_do_not_stop_the_lexer() {
        let (tokens, _, diagnostics) = lex("test", "2u ≤ √ x' “a”; 0x1F");
        assert_eq!(diagnostics.count(), 6);
        let shown: Vec<String> = tokens.kinds().iter().map(ToString::to_string).collect();
        assert_eq!(
            shown.join(" "),
            "the number 2 `<=` something unknown `x` the text \"a\" `;` the number 31 the end"
        );
    }

    #[test]
    fn comments_and_documentation() {
        assert_eq!(kinds("a // b\r\n//// c\n/* d /* e */ f */ /***/ /**/").len(), 1);
        let documentation = [TokenKind::DocComment(" a".into()), TokenKind::DocComment(" b ".into())];
        assert_eq!(kinds("/// a\r\n/** b */"), documentation);
    }

    #[test]
    fn strings_resolve_escapes() {
        let text = r#""\"\\\n\x41\u{1F600}é""#;
        assert_eq!(kinds(text), [TokenKind::Str("\"\\\nA😀é".into())]);
        let rust: syn::LitStr = syn::parse_str(text).expect("a string of Rust");
        assert_eq!(kinds(text), [TokenKind::Str(rust.value())]);
    }

    #[test]
    fn strings_resolve_the_escapes_of_json() {
        let text = r#""1\/2 \u0031\u00e9\ud83d\ude00\b\f""#;
        assert_eq!(kinds(text), [TokenKind::Str("1/2 1é😀\u{8}\u{c}".into())]);
    }
}
