//! Recursive descent through the clauses of an item.

use std::collections::BTreeMap;
use std::fmt::Display;

use super::ast::{
    Claim, Clause, ClauseKind, Curve, CurveRole, Definition, Effect, Function, Interval, Name, Preference,
    Severity, Spanned, Surface, Verdict,
};
use super::diagnostic::Diagnostic;
use super::parser::{KEYWORDS, Parsed, Parser};
use super::suggest::closest;
use super::token::{Span, TokenKind, shortened};

impl Parser<'_> {
    /// One clause, its `;` included.
    pub(super) fn clause(&mut self, docs: Vec<Spanned<String>>) -> Parsed<Clause> {
        let start = self.span();
        let TokenKind::Ident(keyword) = self.peek() else {
            let wrong = self.expected("a clause or `}`");
            return self.fail(wrong);
        };
        if !KEYWORDS.contains(&keyword.as_str()) {
            return self.no_clause(keyword);
        }
        self.advance();
        let kind = match keyword.as_str() {
            "source" => ClauseKind::Source(self.text("where the formula is taken from,")?),
            "symbol" => {
                ClauseKind::Symbol(self.comma_separated(|parser| parser.name("the name of a constant"))?)
            }
            "function" => ClauseKind::Function(self.comma_separated(Self::function)?),
            "let" => ClauseKind::Let(self.definition()?),
            "profile" => ClauseKind::Curve(self.curve(CurveRole::Profile)?),
            "path" => ClauseKind::Curve(self.curve(CurveRole::Path)?),
            "curve" => ClauseKind::Curve(self.curve(CurveRole::Curve)?),
            "frames" => ClauseKind::Curve(self.curve(CurveRole::Frames)?),
            "surface" => ClauseKind::Surface(self.surface()?),
            "prefer" => ClauseKind::Prefer(self.preference()?),
            "domain" => ClauseKind::Domain(self.comma_separated(Self::interval)?),
            "claim" => ClauseKind::Claim(self.claim()?),
            _ => ClauseKind::Substitute(self.definition()?),
        };
        if *self.peek() != TokenKind::Semicolon {
            return self.no_semicolon();
        }
        let span = start.to(self.advance());
        Ok(Clause { docs, span, kind })
    }

    fn preference(&mut self) -> Parsed<Spanned<Preference>> {
        let value = match self.peek() {
            TokenKind::Ident(word) if word == "fast" => Preference::Fast,
            TokenKind::Ident(word) if word == "accurate" => Preference::Accurate,
            _ => {
                let wrong = self.expected("what is preferred");
                return self
                    .fail(wrong.help("write `prefer fast;`, which is the default, or `prefer accurate;`"));
            }
        };
        let span = self.advance();
        Ok(Spanned { value, span })
    }

    fn no_clause<T>(&mut self, word: &str) -> Parsed<T> {
        let wrong = self.wrong(format!("there is no clause `{}`", shortened(word)));
        let help = match (closest(word, KEYWORDS), self.peek_second()) {
            (_, TokenKind::Equal) => {
                format!("a definition begins with its kind, as in `let {} = …`", shortened(word))
            }
            (Some(meant), _) => format!("did you mean `{meant}`?"),
            (None, _) => format!("the clauses are {}", KEYWORDS.map(|word| format!("`{word}`")).join(", ")),
        };
        self.fail(wrong.help(help))
    }

    fn no_semicolon<T>(&mut self) -> Parsed<T> {
        let help = match self.peek() {
            TokenKind::End | TokenKind::CloseBrace => Some("every clause ends with `;`"),
            _ if self.begins_clause() => Some("the clause before this one ends with `;`"),
            TokenKind::Equal => Some("equality is written `==`"),
            TokenKind::Ident(_) | TokenKind::Number(_) | TokenKind::OpenParen => {
                Some("a product is written with `*`, and every clause ends with `;`")
            }
            _ => None,
        };
        let wrong = self.expected("`;`");
        self.fail(match help {
            Some(help) => wrong.help(help),
            None => wrong,
        })
    }

    /// `element, element, …`, one at least.
    fn comma_separated<T>(&mut self, element: fn(&mut Self) -> Parsed<T>) -> Parsed<Vec<T>> {
        let mut elements = vec![element(self)?];
        while *self.peek() == TokenKind::Comma {
            self.advance();
            elements.push(element(self)?);
        }
        Ok(elements)
    }

    /// `x(u)`
    fn function(&mut self) -> Parsed<Function> {
        let name = self.name("the name of a function")?;
        let parameter = self.one_parameter(&name)?;
        Ok(Function { name, parameter })
    }

    /// `name = value` or `name(parameters) = value`
    fn definition(&mut self) -> Parsed<Definition> {
        let name = self.name("the name that is defined")?;
        let parameters = if *self.peek() == TokenKind::OpenParen { self.parameters()? } else { Vec::new() };
        self.expect(&TokenKind::Equal)?;
        Ok(Definition { name, parameters, value: self.expression()? })
    }

    /// `name(parameter) = value`
    fn curve(&mut self, role: CurveRole) -> Parsed<Curve> {
        let name = self.name("the name of the curve")?;
        let parameter = self.one_parameter(&name)?;
        self.expect(&TokenKind::Equal)?;
        Ok(Curve { role, name, parameter, value: self.expression()? })
    }

    /// `name = value` or `name(u, v) = value`
    fn surface(&mut self) -> Parsed<Surface> {
        let name = self.name("the name of the surface")?;
        let parameters = if *self.peek() == TokenKind::OpenParen {
            let start = self.span();
            let parameters = self.parameters()?;
            let Ok(both) = <[Name; 2]>::try_from(parameters) else {
                let wrong = Diagnostic::new(start, "a surface has two parameters");
                return self
                    .fail(wrong.help(format!("write `surface {}(u, v) = …`", shortened(&name.value))));
            };
            Some(both)
        } else {
            None
        };
        self.expect(&TokenKind::Equal)?;
        Ok(Surface { name, parameters, value: self.expression()? })
    }

    fn one_parameter(&mut self, of: &Name) -> Parsed<Name> {
        let name = shortened(&of.value);
        if *self.peek() != TokenKind::OpenParen {
            let wrong = self.expected(&format!("the parameter of `{name}`"));
            return self.fail(wrong.help(format!("name it in parentheses, as in `{name}(u)`")));
        }
        let start = self.span();
        let mut parameters = self.parameters()?;
        match (parameters.pop(), parameters.is_empty()) {
            (Some(parameter), true) => Ok(parameter),
            _ => self.fail(Diagnostic::new(start, format!("`{name}` is to have one parameter"))),
        }
    }

    /// `(u, v)`: one parameter at least, and no two with one name.
    fn parameters(&mut self) -> Parsed<Vec<Name>> {
        let open = self.expect(&TokenKind::OpenParen)?;
        let parameters = self.comma_separated(|parser| parser.name("the name of a parameter"))?;
        if *self.peek() != TokenKind::CloseParen {
            return self.not_closed(open, &TokenKind::CloseParen);
        }
        self.advance();
        let mut first = BTreeMap::new();
        for name in &parameters {
            if let Some(first) = first.insert(&name.value, name.span) {
                let wrong = Diagnostic::new(
                    name.span,
                    format!("two parameters are called `{}`", shortened(&name.value)),
                );
                return self.fail(wrong.also(first, "the first of them"));
            }
        }
        Ok(parameters)
    }

    /// `u in 0..1`
    fn interval(&mut self) -> Parsed<Interval> {
        let parameter = self.name("the name of a parameter")?;
        if !self.peek().is_word("in") {
            let wrong = self.expected("`in`");
            return self.fail(wrong.help("a domain is written `domain u in 0..1, v in 0..1;`"));
        }
        self.advance();
        let start = self.sum()?;
        if *self.peek() != TokenKind::DotDot {
            let wrong = self.expected("`..`");
            return self.fail(wrong.help("a domain is written `domain u in 0..1, v in 0..1;`"));
        }
        self.advance();
        if *self.peek() == TokenKind::Equal {
            let wrong = self.expected("the end of the domain");
            return self.fail(wrong.help("domains are closed; write `0..1`"));
        }
        Ok(Interval { parameter, start, end: self.sum()? })
    }

    /// `"id": relation, "note", instead "…", effect major "…", expect refuted, when condition`
    fn claim(&mut self) -> Parsed<Claim> {
        let id = self.text("the claim's id")?;
        if id.value.trim().is_empty() {
            return self.fail(Diagnostic::new(id.span, "a claim needs an id to be known by"));
        }
        self.expect(&TokenKind::Colon)?;
        let relation = self.expression()?;
        let mut claim = Claim {
            id,
            relation,
            notes: vec![],
            instead: None,
            effect: None,
            expected: None,
            conditions: vec![],
        };
        while *self.peek() == TokenKind::Comma {
            self.advance();
            match self.peek() {
                TokenKind::Str(_) => claim.notes.push(self.text("a note")?),
                TokenKind::Ident(word) if word == "expect" => {
                    let start = self.advance();
                    let verdict = self.verdict()?;
                    if let Some(first) = &claim.expected {
                        let wrong =
                            Diagnostic::new(start.to(verdict.span), "two verdicts are expected of one claim");
                        return self.fail(wrong.also(first.span, "the first of them"));
                    }
                    claim.expected = Some(verdict);
                }
                TokenKind::Ident(word) if word == "when" => {
                    self.advance();
                    claim.conditions.push(self.expression()?);
                }
                TokenKind::Ident(word) if word == "instead" => {
                    let start = self.advance();
                    let text = self.text("what holds in place of a refuted claim,")?;
                    if let Some(first) = &claim.instead {
                        return self.twice("`instead`", start.to(text.span), first.span);
                    }
                    claim.instead = Some(text);
                }
                TokenKind::Ident(word) if word == "effect" => {
                    let start = self.advance();
                    let severity = self.severity()?;
                    let text = self.text("what the mistake means for whoever uses this,")?;
                    if let Some(first) = &claim.effect {
                        return self.twice("`effect`", start.to(text.span), first.text.span);
                    }
                    claim.effect = Some(Effect { severity, text });
                }
                other => {
                    let wrong = self.expected("a note in double quotes, `expect …` or `when …`");
                    let word = if let TokenKind::Ident(word) = other { word.as_str() } else { "" };
                    return self.fail(match closest(word, ["expect", "when", "instead", "effect"]) {
                        Some(meant) => wrong.help(format!("did you mean `{meant}`?")),
                        None => wrong,
                    });
                }
            }
        }
        if matches!(self.peek(), TokenKind::Str(_))
            || ["expect", "when", "instead", "effect"].into_iter().any(|word| self.peek().is_word(word))
        {
            let wrong = self.expected("`,` or `;`");
            return self.fail(wrong.help("the parts of a claim are separated by commas"));
        }
        Ok(claim)
    }

    fn twice<T>(&mut self, what: &str, again: Span, first: Span) -> Parsed<T> {
        let wrong = Diagnostic::new(again, format!("a claim has two parts {what}"));
        self.fail(wrong.also(first, "the first of them"))
    }

    fn verdict(&mut self) -> Parsed<Spanned<Verdict>> {
        self.one_of([Verdict::Proved, Verdict::Refuted, Verdict::Undecided])
    }

    fn severity(&mut self) -> Parsed<Spanned<Severity>> {
        self.one_of([Severity::Major, Severity::Moderate, Severity::Minor])
    }

    /// One of three words.
    fn one_of<T: Copy + Display>(&mut self, all: [T; 3]) -> Parsed<Spanned<T>> {
        let word = if let TokenKind::Ident(word) = self.peek() { word.as_str() } else { "" };
        let words = all.each_ref().map(T::to_string);
        match all.into_iter().zip(&words).find(|(_, known)| known.as_str() == word) {
            Some((value, _)) => Ok(Spanned { value, span: self.advance() }),
            None => {
                let [first, second, third] = &words;
                let wrong = self.expected(&format!("`{first}`, `{second}` or `{third}`"));
                self.fail(match closest(word, words.iter().map(String::as_str)) {
                    Some(meant) => wrong.help(format!("did you mean `{meant}`?")),
                    None => wrong,
                })
            }
        }
    }
}
