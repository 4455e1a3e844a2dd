//! What a text and the tokens of a macro have in common: how names, numbers, strings and signs are spelled.
//!
//! Each function takes the spelling as Rust delimits it, and gives the tokens to go on with, and what is wrong
//! with it if anything is.

use super::diagnostic::Diagnostic;
use super::token::{Span, TokenKind, shortened};

/// The token that these two characters make together.
pub(super) fn pair(first: char, second: char) -> Option<TokenKind> {
    Some(match (first, second) {
        ('=', '=') => TokenKind::EqualEqual,
        ('!', '=') => TokenKind::NotEqual,
        ('<', '=') => TokenKind::LessEqual,
        ('>', '=') => TokenKind::GreaterEqual,
        ('.', '.') => TokenKind::DotDot,
        _ => return None,
    })
}

/// The token of this character alone.
pub(super) fn single(character: char) -> Option<TokenKind> {
    Some(match character {
        '+' => TokenKind::Plus,
        '-' => TokenKind::Minus,
        '*' => TokenKind::Star,
        '/' => TokenKind::Slash,
        '^' => TokenKind::Caret,
        '(' => TokenKind::OpenParen,
        ')' => TokenKind::CloseParen,
        '[' => TokenKind::OpenBracket,
        ']' => TokenKind::CloseBracket,
        '{' => TokenKind::OpenBrace,
        '}' => TokenKind::CloseBrace,
        ',' => TokenKind::Comma,
        ';' => TokenKind::Semicolon,
        ':' => TokenKind::Colon,
        '.' => TokenKind::Dot,
        '=' => TokenKind::Equal,
        '<' => TokenKind::Less,
        '>' => TokenKind::Greater,
        _ => return None,
    })
}

/// Whether a name may begin so; names that are not ASCII are found whole, to be refused whole.
pub(super) fn begins_name(character: char) -> bool {
    character == '_' || character.is_alphabetic()
}

/// Whether a name may go on so.
pub(super) fn continues_name(character: char) -> bool {
    begins_name(character) || character.is_ascii_digit()
}

/// A name: ASCII only, so that it is the same in every source that is generated from it.
pub(super) fn name(word: &str, span: Span) -> (TokenKind, Option<Diagnostic>) {
    if let Some(plain) = word.strip_prefix("r#") {
        let wrong = Diagnostic::new(span, format!("`{}` is no name", shortened(word)))
            .help(format!("write `{}`", shortened(plain)));
        return (TokenKind::Ident(plain.to_string()), Some(wrong));
    }
    if word.is_ascii() {
        return (TokenKind::Ident(word.to_string()), None);
    }
    let spelled: String = word.chars().map(spelled_out).collect();
    let wrong = Diagnostic::new(span, format!("the name `{}` is not ASCII", shortened(word)));
    let wrong = if spelled.is_ascii() {
        wrong.help(format!("write `{}`", shortened(&spelled)))
    } else {
        wrong.help("names are made of the letters a to z and A to Z, digits and `_`")
    };
    (TokenKind::Ident(spelled), Some(wrong))
}

/// The name of a Greek letter, any other letter as it is.
fn spelled_out(letter: char) -> String {
    const SMALL: [&str; 25] = [
        "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda",
        "mu", "nu", "xi", "omicron", "pi", "rho", "sigma", "sigma", "tau", "upsilon", "phi", "chi", "psi",
        "omega",
    ];
    let small = letter.to_lowercase().next().unwrap_or(letter);
    let index = (small as usize).checked_sub('α' as usize);
    match index.and_then(|index| SMALL.get(index)) {
        Some(name) if small == letter => (*name).to_string(),
        Some(name) => name[..1].to_uppercase() + &name[1..],
        None if letter == 'ϕ' => "phi".to_string(),
        None if letter == 'ϑ' => "theta".to_string(),
        None => letter.to_string(),
    }
}

/// A number as Rust delimits it, with whatever letters follow it directly.
pub(super) fn number(literal: &str, span: Span) -> (TokenKind, Option<Diagnostic>) {
    let digits = |text: &str| text.find(|c: char| !c.is_ascii_digit() && c != '_').unwrap_or(text.len());
    let plain = |text: &str| TokenKind::Number(text.replace('_', ""));

    if let Some((radix, rest)) = radix(literal) {
        let wrong = Diagnostic::new(span, format!("`{}` is not a decimal number", shortened(literal)));
        return match u128::from_str_radix(&rest.replace('_', ""), radix) {
            Ok(value) => (TokenKind::Number(value.to_string()), Some(wrong.help(format!("write {value}")))),
            Err(_) => (TokenKind::Number("0".into()), Some(wrong.help("write decimal digits"))),
        };
    }
    let mut end = digits(literal);
    if literal[end..].starts_with('.') {
        let fraction = digits(&literal[end + 1..]);
        if fraction == 0 {
            let whole = literal[..end].replace('_', "");
            let wrong = Diagnostic::new(span, "digits are missing after the decimal point")
                .help(format!("write {0}.0 or {0}", shortened(&whole)));
            return (TokenKind::Number(whole), Some(wrong));
        }
        end += 1 + fraction;
    }
    if literal[end..].starts_with(['e', 'E']) {
        let sign = usize::from(literal[end + 1..].starts_with(['+', '-']));
        let exponent = &literal[end + 1 + sign..];
        let length = digits(exponent);
        if exponent[..length].contains(|c: char| c.is_ascii_digit()) {
            end += 1 + sign + length;
        }
    }
    let (value, suffix) = literal.split_at(end);
    if suffix.is_empty() {
        return (plain(value), None);
    }
    let value = value.trim_end_matches('_');
    let wrong = Diagnostic::new(span, format!("`{}` is neither a number nor a product", shortened(literal)));
    let is_type = ["f", "i", "u"].iter().any(|&letter| {
        suffix.strip_prefix(letter).is_some_and(|bits| ["8", "16", "32", "64", "128", "size"].contains(&bits))
    });
    let wrong = if is_type {
        wrong.help(format!("write {}: numbers are exact and have no type", shortened(value)))
    } else {
        wrong.help(format!("write {}*{}", shortened(value), shortened(suffix)))
    };
    (plain(value), Some(wrong))
}

fn radix(literal: &str) -> Option<(u32, &str)> {
    [("0x", 16), ("0o", 8), ("0b", 2)]
        .into_iter()
        .find_map(|(prefix, radix)| literal.strip_prefix(prefix).map(|rest| (radix, rest)))
}

/// A string: what stands between its double quotes.
pub(super) fn string(body: &str, span: Span) -> (TokenKind, Option<Diagnostic>) {
    let mut text = String::new();
    let mut wrong = None;
    let mut rest = body.chars();
    while let Some(character) = rest.next() {
        match character {
            '\n' => {
                wrong.get_or_insert_with(|| {
                    Diagnostic::new(span, "this text goes on in the next line").help("close it with `\"`")
                });
            }
            '\\' => match escaped(&mut rest) {
                Some(escaped) => text.push(escaped),
                None => {
                    wrong.get_or_insert_with(|| {
                        Diagnostic::new(span, "this text holds an unknown escape after `\\`")
                            .help("write `\\\\` for a backslash itself")
                    });
                }
            },
            _ => text.push(character),
        }
    }
    (TokenKind::Str(text), wrong)
}

/// The character that an escape of Rust or JSON stands for, `rest` being what follows the backslash.
fn escaped(rest: &mut std::str::Chars<'_>) -> Option<char> {
    Some(match rest.next()? {
        'n' => '\n',
        'r' => '\r',
        't' => '\t',
        '0' => '\0',
        'b' => '\u{8}',
        'f' => '\u{c}',
        quoted @ ('\\' | '\'' | '"' | '/') => quoted,
        'x' => {
            let digits: String = rest.by_ref().take(2).collect();
            char::from(u8::from_str_radix(&digits, 16).ok().filter(u8::is_ascii)?)
        }
        'u' if !rest.as_str().starts_with('{') => {
            let first = unit(rest)?;
            let is_first = (0xd800..0xdc00).contains(&first);
            let mut second = None;
            if let Some(after) = rest.as_str().strip_prefix("\\u").filter(|_| is_first) {
                *rest = after.chars();
                second = Some(unit(rest)?);
            }
            char::decode_utf16(std::iter::once(first).chain(second)).next()?.ok()?
        }
        'u' => {
            let after = rest.as_str().strip_prefix('{')?;
            let (digits, after) = after.split_once('}')?;
            *rest = after.chars();
            char::from_u32(u32::from_str_radix(&digits.replace('_', ""), 16).ok()?)?
        }
        _ => return None,
    })
}

/// Four hexadecimal digits, as JSON writes a unit of UTF-16.
fn unit(rest: &mut std::str::Chars<'_>) -> Option<u16> {
    let digits =
        rest.as_str().get(..4).filter(|digits| digits.bytes().all(|digit| digit.is_ascii_hexdigit()))?;
    *rest = rest.as_str()[4..].chars();
    u16::from_str_radix(digits, 16).ok()
}

/// Rust's other kinds of strings and characters: `r"…"`, `b"…"`, `'c'`.
pub(super) fn foreign_literal(literal: &str, span: Span) -> (TokenKind, Option<Diagnostic>) {
    let quote = if literal.contains('"') { '"' } else { '\'' };
    let body =
        literal.split_once(quote).and_then(|(_, rest)| rest.rsplit_once(quote)).map_or("", |(body, _)| body);
    let wrong = Diagnostic::new(span, format!("`{}` is no text of this language", shortened(literal)))
        .help("a text stands in plain double quotes: \"…\"");
    (TokenKind::Str(body.to_string()), Some(wrong))
}

/// A prime, as in `x'`.
pub(super) fn prime(of: Option<&str>, span: Span) -> Diagnostic {
    let what = shortened(of.unwrap_or("x"));
    Diagnostic::new(span, "a prime is no derivative here")
        .help(format!("write `diff({what}, v)`, with the parameter that it is differentiated by"))
}

/// A character that begins no token (perhaps several times in a row): what was meant, if that is clear.
pub(super) fn unknown(character: char, span: Span) -> (Vec<TokenKind>, Diagnostic) {
    if let Some(digit) = superscript(character) {
        let help = format!("write `^{digit}`");
        let meant = vec![TokenKind::Caret, TokenKind::Number(digit.to_string())];
        return (meant, Diagnostic::new(span, format!("unknown character `{character}`")).help(help));
    }
    let unknown = vec![TokenKind::Unknown];
    let (meant, help) = match character {
        '≤' => (vec![TokenKind::LessEqual], "write `<=`"),
        '≥' => (vec![TokenKind::GreaterEqual], "write `>=`"),
        '−' | '–' | '—' | '‐' | '‑' => (vec![TokenKind::Minus], "write the minus sign `-`"),
        '×' | '·' | '⋅' | '∗' | '∙' => {
            (vec![TokenKind::Star], "write `*` for a product, `cross` or `dot` for vectors")
        }
        '÷' | '∕' | '⁄' => (vec![TokenKind::Slash], "write `/`"),
        '…' => (vec![TokenKind::DotDot], "write `..`"),
        '∈' => (vec![TokenKind::Ident("in".into())], "write `in`"),
        '¬' => (vec![TokenKind::Ident("not".into())], "write `not`"),
        '≠' => (unknown, "write `not a == b`"),
        '≈' => (unknown, "write `approx(a, 1.414)`"),
        '√' => (unknown, "write `sqrt(…)`"),
        '∞' => (unknown, "domains are finite intervals, such as `0..1`"),
        '∂' => (unknown, "write `diff(R, u)`"),
        '′' | '″' | '´' | '’' => {
            (vec![], "write `diff(x, v)` for a derivative, and plain `\"` around a text")
        }
        '“' | '”' | '„' | '«' | '»' | '‘' => {
            (unknown, "write plain double quotes `\"` around a text")
        }
        '\u{a0}' | '\u{200b}' | '\u{2009}' | '\u{202f}' | '\u{3000}' | '\u{feff}' => {
            let code = u32::from(character);
            let wrong = Diagnostic::new(span, format!("an invisible character, U+{code:04X}"));
            return (vec![], wrong.help("write a plain space"));
        }
        '!' => (unknown, "write `not` before a relation, or `!=`"),
        '&' => (unknown, "write a claim for each relation, or `when` before a condition"),
        '|' => (unknown, "write `norm2(a)` for the squared length of a vector"),
        '#' => (unknown, "comments begin with `//`"),
        '%' => (unknown, "comments begin with `//`"),
        '\\' => (unknown, "names are plain words, as in `sigma`"),
        _ => (unknown, "see the reference of the language for what may stand here"),
    };
    let shown = if character.is_control() {
        format!("unknown character U+{:04X}", u32::from(character))
    } else {
        format!("unknown character `{character}`")
    };
    (meant, Diagnostic::new(span, shown).help(help))
}

fn superscript(character: char) -> Option<u8> {
    "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().zip(0..).find_map(|(superscript, digit)| (superscript == character).then_some(digit))
}

/// Documentation of what surrounds it (`//!`), which has no place in the language.
pub(super) fn inner_documentation(span: Span) -> Diagnostic {
    Diagnostic::new(span, "`//!` documents what surrounds it, which is nothing here")
        .help("write `///` before a sweep, or `//` for a comment")
}
