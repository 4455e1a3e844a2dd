//! JSON with the place of each value, cut into tokens as everything else is: so its mistakes are shown as those of a formula,
//! and its numbers stay exact.
//!
//! All of JSON's notation is read. Comments are skipped.

use super::ast::Spanned;
use super::lexer::lex;
use super::source::Source;
use super::token::{Span, TokenKind, Tokens};
use super::{Diagnostic, Diagnostics, MAX_LENGTH};

/// How deeply lists and objects may be nested.
const MAX_DEPTH: usize = 32;

/// A value with its place.
#[derive(Clone, Debug)]
pub(crate) struct Json {
    pub(crate) kind: JsonKind,
    pub(crate) span: Span,
}

/// The kinds of values.
#[derive(Clone, Debug)]
pub(crate) enum JsonKind {
    /// A decimal number as it is written, with its sign: whether it is negative, and the rest.
    Number(bool, String),
    /// A text.
    Text(String),
    /// `true`, `false` or `null`.
    Word,
    /// `[a, b]`
    List(Vec<Json>),
    /// `{"a": b}`
    Object(Vec<(Spanned<String>, Json)>),
}

impl JsonKind {
    /// What it is, with an article, as messages say it.
    pub(crate) fn name(&self) -> &'static str {
        match self {
            JsonKind::Number(..) => "a number",
            JsonKind::Text(_) => "a text",
            JsonKind::Word => "a word",
            JsonKind::List(_) => "a list",
            JsonKind::Object(_) => "an object",
        }
    }
}

/// Reads a text; the source resolves the places of the value and of the mistakes.
pub(crate) fn parse(name: &str, text: &str) -> (Source, Result<Json, Diagnostics>) {
    let fits = text.len() <= MAX_LENGTH;
    let (tokens, source, mut diagnostics) = lex(name, if fits { text } else { "" });
    let mut reader = Reader { tokens: &tokens, at: 0, depth: 0 };
    let value = if fits {
        reader.whole()
    } else {
        let message = format!("this file is {} bytes long, more than the limit of {MAX_LENGTH}", text.len());
        Err(Diagnostic::new(reader.span(), message))
    };
    match value {
        Ok(value) if diagnostics.is_empty() => (source, Ok(value)),
        // A mistake in a token is the cause of what comes behind it.
        Err(mistake) if diagnostics.is_empty() => {
            diagnostics.push(mistake);
            (source, Err(diagnostics))
        }
        _ => (source, Err(diagnostics)),
    }
}

struct Reader<'a> {
    tokens: &'a Tokens,
    at: usize,
    depth: usize,
}

impl Reader<'_> {
    fn whole(&mut self) -> Result<Json, Diagnostic> {
        let value = self.value()?;
        match self.peek() {
            TokenKind::End => Ok(value),
            _ => Err(self.expected("the end")),
        }
    }

    fn value(&mut self) -> Result<Json, Diagnostic> {
        let start = self.span();
        let token = self.peek().clone();
        match token {
            TokenKind::Minus => {
                self.at += 1;
                let text = self.number()?;
                let span = start.to(self.advance());
                Ok(Json { kind: JsonKind::Number(true, text), span })
            }
            TokenKind::Number(_) => {
                let text = self.number()?;
                self.one(JsonKind::Number(false, text))
            }
            TokenKind::Str(text) => self.one(JsonKind::Text(text)),
            TokenKind::Ident(word) if ["true", "false", "null"].contains(&word.as_str()) => {
                self.one(JsonKind::Word)
            }
            TokenKind::OpenBracket => {
                let mut parts = Vec::new();
                let span = self.several(&TokenKind::CloseBracket, |reader| {
                    parts.push(reader.value()?);
                    Ok(())
                })?;
                Ok(Json { kind: JsonKind::List(parts), span })
            }
            TokenKind::OpenBrace => {
                let mut members: Vec<(Spanned<String>, Json)> = Vec::new();
                let span = self.several(&TokenKind::CloseBrace, |reader| {
                    let TokenKind::Str(key) = reader.peek().clone() else {
                        return Err(reader.expected("a key in double quotes"));
                    };
                    let key = Spanned { value: key, span: reader.advance() };
                    if let Some((first, _)) = members.iter().find(|(known, _)| known.value == key.value) {
                        let wrong =
                            Diagnostic::new(key.span, format!("the key {:?} stands twice", key.value));
                        return Err(wrong.also(first.span, "the first is here"));
                    }
                    if *reader.peek() != TokenKind::Colon {
                        return Err(reader.expected("`:`"));
                    }
                    reader.at += 1;
                    members.push((key, reader.value()?));
                    Ok(())
                })?;
                Ok(Json { kind: JsonKind::Object(members), span })
            }
            _ => Err(self.expected("a value")),
        }
    }

    /// The number that stands here.
    fn number(&self) -> Result<String, Diagnostic> {
        let TokenKind::Number(text) = self.peek() else { return Err(self.expected("a number")) };
        let mut digits = text.bytes();
        if digits.next() == Some(b'0') && digits.next().is_some_and(|digit| digit.is_ascii_digit()) {
            let wrong =
                Diagnostic::new(self.span(), "a number in JSON does not begin with a zero that says nothing");
            let rest = text.trim_start_matches('0');
            let zero = if rest.starts_with(|first: char| first.is_ascii_digit()) { "" } else { "0" };
            return Err(wrong.help(format!("write `{zero}{rest}`")));
        }
        Ok(text.clone())
    }

    fn one(&mut self, kind: JsonKind) -> Result<Json, Diagnostic> {
        Ok(Json { kind, span: self.advance() })
    }

    /// What stands between an opening token and the closing one, separated by commas.
    fn several(
        &mut self,
        close: &TokenKind,
        mut part: impl FnMut(&mut Self) -> Result<(), Diagnostic>,
    ) -> Result<Span, Diagnostic> {
        if self.depth >= MAX_DEPTH {
            return Err(Diagnostic::new(
                self.span(),
                format!("this is nested more than {MAX_DEPTH} levels deep"),
            ));
        }
        self.depth += 1;
        let open = self.advance();
        if self.peek() != close {
            loop {
                part(self)?;
                match self.peek() {
                    TokenKind::Comma => {
                        let comma = self.advance();
                        if self.peek() == close {
                            return Err(
                                Diagnostic::new(comma, "nothing follows this comma").help("remove it")
                            );
                        }
                    }
                    token if token == close => break,
                    TokenKind::End => {
                        return Err(self.expected(&format!("`,` or {close}")).also(open, "opened here"));
                    }
                    _ => return Err(self.expected(&format!("`,` or {close}"))),
                }
            }
        }
        self.depth -= 1;
        Ok(open.to(self.advance()))
    }

    fn peek(&self) -> &TokenKind {
        &self.tokens.at(self.at).kind
    }

    fn span(&self) -> Span {
        self.tokens.at(self.at).span
    }

    fn advance(&mut self) -> Span {
        let span = self.span();
        self.at += 1;
        span
    }

    fn expected(&self, what: &str) -> Diagnostic {
        Diagnostic::new(self.span(), format!("expected {what}, found {}", self.peek()))
    }
}
