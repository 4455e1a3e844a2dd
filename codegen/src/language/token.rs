//! Tokens of the sweep language, and the opaque places that they carry.

use std::fmt;

/// The place of one token: a number that only the source of the tokens can resolve ([`Source`] for text,
/// [`MacroSource`] for the tokens of a macro). Numbers grow from the beginning of the source to its end.
///
/// [`Source`]: super::Source
/// [`MacroSource`]: super::MacroSource
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SpanId(pub(super) u32);

/// The place of a run of tokens, from the first to the last of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Span {
    /// The first token.
    pub first: SpanId,
    /// The last token, itself included.
    pub last: SpanId,
}

impl Span {
    /// The place of one token.
    pub fn at(id: SpanId) -> Span {
        Span { first: id, last: id }
    }

    /// The place from the beginning of `self` to the end of `end`.
    pub fn to(self, end: Span) -> Span {
        Span { first: self.first, last: end.last }
    }
}

/// A token and where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Token {
    /// What it is.
    pub kind: TokenKind,
    /// Where it stands.
    pub span: Span,
}

/// The kinds of tokens. Each of them is one token of Rust, or two joined ones.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum TokenKind {
    /// A name or a keyword: ASCII letters, digits and `_`.
    Ident(String),
    /// A decimal number as it is written, without `_`: `12`, `0.25`, `1e-3`.
    Number(String),
    /// A text in double quotes, its escapes resolved.
    Str(String),
    /// The text after `///`.
    DocComment(String),
    /// `+`
    Plus,
    /// `-`
    Minus,
    /// `*`
    Star,
    /// `/`
    Slash,
    /// `^`
    Caret,
    /// `(`
    OpenParen,
    /// `)`
    CloseParen,
    /// `[`
    OpenBracket,
    /// `]`
    CloseBracket,
    /// `{`
    OpenBrace,
    /// `}`
    CloseBrace,
    /// `,`
    Comma,
    /// `;`
    Semicolon,
    /// `:`
    Colon,
    /// `.`
    Dot,
    /// `..`
    DotDot,
    /// `=`
    Equal,
    /// `==`
    EqualEqual,
    /// `!=`
    NotEqual,
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
    /// Something that is no token of the language and has been reported already.
    Unknown,
    /// The end of the source.
    End,
}

impl TokenKind {
    /// Whether the token is this word.
    pub(super) fn is_word(&self, word: &str) -> bool {
        matches!(self, TokenKind::Ident(name) if name == word)
    }
}

impl fmt::Display for TokenKind {
    /// Names the token as a message does: "`;`", "the number 2", "the end".
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let symbol = match self {
            TokenKind::Ident(name) => return write!(f, "`{}`", shortened(name)),
            TokenKind::Number(text) => return write!(f, "the number {}", shortened(text)),
            TokenKind::Str(text) => return write!(f, "the text {:?}", shortened(text)),
            TokenKind::DocComment(_) => return f.write_str("a documentation comment"),
            TokenKind::Unknown => return f.write_str("something unknown"),
            TokenKind::End => return f.write_str("the end"),
            TokenKind::Plus => "+",
            TokenKind::Minus => "-",
            TokenKind::Star => "*",
            TokenKind::Slash => "/",
            TokenKind::Caret => "^",
            TokenKind::OpenParen => "(",
            TokenKind::CloseParen => ")",
            TokenKind::OpenBracket => "[",
            TokenKind::CloseBracket => "]",
            TokenKind::OpenBrace => "{",
            TokenKind::CloseBrace => "}",
            TokenKind::Comma => ",",
            TokenKind::Semicolon => ";",
            TokenKind::Colon => ":",
            TokenKind::Dot => ".",
            TokenKind::DotDot => "..",
            TokenKind::Equal => "=",
            TokenKind::EqualEqual => "==",
            TokenKind::NotEqual => "!=",
            TokenKind::Less => "<",
            TokenKind::LessEqual => "<=",
            TokenKind::Greater => ">",
            TokenKind::GreaterEqual => ">=",
        };
        write!(f, "`{symbol}`")
    }
}

/// The tokens of one source, with [`TokenKind::End`] at the end and nowhere else.
#[derive(Clone, Debug)]
pub struct Tokens(Vec<Token>);

impl Tokens {
    /// Tokens that end in [`TokenKind::End`], which stands at `end`.
    pub(super) fn new(mut tokens: Vec<Token>, end: Span) -> Tokens {
        tokens.push(Token { kind: TokenKind::End, span: end });
        Tokens(tokens)
    }

    /// The token at `index`, or the end for every index beyond it.
    pub(super) fn at(&self, index: usize) -> &Token {
        &self.0[index.min(self.0.len() - 1)]
    }

    /// Only what the tokens are.
    #[cfg(test)]
    pub(super) fn kinds(&self) -> Vec<TokenKind> {
        self.0.iter().map(|token| token.kind.clone()).collect()
    }
}

/// The text, cut after forty characters.
pub(super) fn shortened(text: &str) -> String {
    match text.char_indices().nth(40) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_string(),
    }
}
