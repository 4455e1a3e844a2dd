//! Recursive descent through the items of a source, and how to go on after a mistake.

use super::ast::{Clause, Expr, File, Item, ItemKind, Name, Spanned};
use super::check;
use super::diagnostic::{Diagnostic, Diagnostics};
use super::suggest::closest;
use super::token::{Span, TokenKind, Tokens, shortened};

/// The words that begin clauses.
pub(super) const KEYWORDS: [&str; 13] = [
    "source",
    "symbol",
    "function",
    "let",
    "profile",
    "path",
    "curve",
    "frames",
    "surface",
    "prefer",
    "domain",
    "claim",
    "substitute",
];

/// Reads the tokens of a source. With mistakes, the file holds what could be read. Takes O(tokens · log tokens).
pub fn parse(tokens: &Tokens) -> (File, Diagnostics) {
    let mut parser = Parser::new(tokens);
    let file = parser.file();
    (file, parser.diagnostics)
}

/// Reads tokens that are a single expression.
pub(super) fn parse_single_expression(tokens: &Tokens) -> (Option<Expr>, Diagnostics) {
    let mut parser = Parser::new(tokens);
    let expr = parser.expression().ok();
    if expr.is_some() && *parser.peek() != TokenKind::End {
        let wrong = parser.expected("an operator or the end");
        let _reported: Parsed<()> = parser.fail(wrong);
    }
    (expr, parser.diagnostics)
}

/// Says that a mistake stopped the parser and has been reported.
pub(super) struct Reported;

/// What was read, unless a mistake that has been reported was in the way.
pub(super) type Parsed<T> = Result<T, Reported>;

/// The tokens, how far they are read, and the mistakes so far.
pub(super) struct Parser<'a> {
    tokens: &'a Tokens,
    at: usize,
    /// In how many parentheses and exponents the parser is.
    pub(super) depth: usize,
    diagnostics: Diagnostics,
}

impl<'a> Parser<'a> {
    fn new(tokens: &'a Tokens) -> Parser<'a> {
        Parser { tokens, at: 0, depth: 0, diagnostics: Diagnostics::new() }
    }

    fn file(&mut self) -> File {
        let mut file = File::default();
        let mut is_whole = true;
        loop {
            let docs = self.documentation();
            if *self.peek() == TokenKind::End {
                self.check_documented(&docs);
                break;
            }
            match self.item(docs) {
                Ok(item) => file.items.push(item),
                Err(Reported) => {
                    is_whole = false;
                    self.recover_to_item();
                }
            }
        }
        if is_whole && file.items.is_empty() && self.diagnostics.is_empty() {
            let wrong = self.wrong("there is neither a sweep nor a lemma here");
            self.diagnostics.push(wrong.help("write `sweep name { … }` or `lemma name { … }`"));
        }
        check::repeated_items(&file, &mut self.diagnostics);
        file
    }

    /// `sweep name { clauses }`
    fn item(&mut self, docs: Vec<Spanned<String>>) -> Parsed<Item> {
        let kind = match self.peek() {
            TokenKind::Ident(word) if word == "sweep" => ItemKind::Sweep,
            TokenKind::Ident(word) if word == "lemma" => ItemKind::Lemma,
            _ => return self.no_item(),
        };
        self.advance();
        let name = self.name(&format!("the name of the {kind}"))?;
        // `gen` is a keyword since edition 2024, which syn does not know.
        if name.value == "gen" || syn::parse_str::<syn::Ident>(&name.value).is_err() {
            let wrong = Diagnostic::new(name.span, format!("`{}` is a keyword of Rust", name.value));
            self.diagnostics
                .push(wrong.help(format!("choose another name, such as `{}_{kind}`", name.value)));
        }
        let open = self.expect(&TokenKind::OpenBrace)?;
        let (clauses, attempted) = self.clauses(kind, &name, open);
        let item = Item { kind, docs, name, clauses };
        check::item(&item, &attempted, &mut self.diagnostics);
        Ok(item)
    }

    /// The clauses up to the closing brace, and the keywords of those that could not be read.
    fn clauses(&mut self, kind: ItemKind, name: &Name, open: Span) -> (Vec<Clause>, Vec<&'static str>) {
        let mut clauses = Vec::new();
        let mut attempted = Vec::new();
        loop {
            let docs = self.documentation();
            match self.peek() {
                TokenKind::CloseBrace => {
                    self.advance();
                    self.check_documented(&docs);
                    break;
                }
                TokenKind::Semicolon => {
                    let wrong = self.wrong("there is no clause before this `;`");
                    self.diagnostics.push(wrong.help("leave it out"));
                    self.advance();
                }
                _ if *self.peek() == TokenKind::End || self.begins_item() => {
                    let wrong = self.wrong(format!("the {kind} `{}` is not closed", shortened(&name.value)));
                    self.diagnostics.push(wrong.also(open, "opened here").help("close it with `}`"));
                    break;
                }
                _ => {
                    self.depth = 0;
                    let keyword = self.keyword();
                    match self.clause(docs) {
                        Ok(clause) => clauses.push(clause),
                        Err(Reported) => {
                            attempted.extend(keyword);
                            self.recover_to_clause();
                        }
                    }
                }
            }
        }
        (clauses, attempted)
    }

    fn no_item<T>(&mut self) -> Parsed<T> {
        let is_clause = self.keyword().is_some();
        let wrong = match self.peek() {
            TokenKind::CloseBrace => self.wrong("this `}` closes nothing").help("leave it out"),
            TokenKind::Ident(word) => match closest(word, ["sweep", "lemma"]) {
                Some(meant) => self.expected("`sweep` or `lemma`").help(format!("did you mean `{meant}`?")),
                None if is_clause => {
                    self.expected("`sweep` or `lemma`").help("clauses stand in `sweep name { … }`")
                }
                None => self.expected("`sweep` or `lemma`"),
            },
            _ => self.expected("`sweep` or `lemma`"),
        };
        self.fail(wrong)
    }

    /// The keyword of the clause that begins here, or the one that was probably meant.
    fn keyword(&self) -> Option<&'static str> {
        match self.peek() {
            TokenKind::Ident(word) => {
                KEYWORDS.into_iter().find(|keyword| keyword == word).or_else(|| closest(word, KEYWORDS))
            }
            _ => None,
        }
    }

    fn documentation(&mut self) -> Vec<Spanned<String>> {
        let mut docs = Vec::new();
        while let TokenKind::DocComment(text) = self.peek() {
            let value = text.clone();
            docs.push(Spanned { value, span: self.advance() });
        }
        docs
    }

    /// Reports documentation that nothing follows.
    fn check_documented(&mut self, docs: &[Spanned<String>]) {
        if let (Some(first), Some(last)) = (docs.first(), docs.last()) {
            let wrong = Diagnostic::new(first.span.to(last.span), "nothing follows that this could document");
            self.diagnostics.push(wrong.help("write `//` for a comment"));
        }
    }

    /// Goes on after a mistake in a clause: behind its `;`, or before what can only be the next clause or the end.
    fn recover_to_clause(&mut self) {
        let mut braces = 0;
        loop {
            match self.peek() {
                TokenKind::End => return,
                TokenKind::CloseBrace if braces == 0 => return,
                TokenKind::Semicolon => {
                    self.advance();
                    return;
                }
                _ if self.begins_clause() || self.begins_item() => return,
                TokenKind::OpenBrace => braces += 1,
                TokenKind::CloseBrace => braces -= 1,
                _ => {}
            }
            self.advance();
        }
    }

    /// Goes on after a mistake outside of clauses: before the next item.
    fn recover_to_item(&mut self) {
        let mut braces = 0;
        loop {
            match self.peek() {
                TokenKind::End => return,
                TokenKind::OpenBrace => braces += 1,
                TokenKind::CloseBrace if braces <= 1 => {
                    self.advance();
                    return;
                }
                TokenKind::CloseBrace => braces -= 1,
                _ => {}
            }
            self.advance();
            if self.begins_item() {
                return;
            }
        }
    }

    /// Whether only a clause can begin so: no expression holds a name followed by a name or a text.
    pub(super) fn begins_clause(&self) -> bool {
        let is_keyword = matches!(self.peek(), TokenKind::Ident(word) if KEYWORDS.contains(&word.as_str()));
        is_keyword && matches!(self.peek_second(), TokenKind::Ident(_) | TokenKind::Str(_))
    }

    /// Whether only an item can begin so.
    fn begins_item(&self) -> bool {
        let is_keyword = self.peek().is_word("sweep") || self.peek().is_word("lemma");
        is_keyword && matches!(self.peek_second(), TokenKind::Ident(_) | TokenKind::OpenBrace)
    }

    /// What stands here.
    pub(super) fn peek(&self) -> &'a TokenKind {
        &self.tokens.at(self.at).kind
    }

    /// What stands behind it.
    pub(super) fn peek_second(&self) -> &'a TokenKind {
        &self.tokens.at(self.at + 1).kind
    }

    /// What stands before the token that was read last.
    pub(super) fn before_last(&self) -> &'a TokenKind {
        &self.tokens.at(self.at.saturating_sub(2)).kind
    }

    /// The place here.
    pub(super) fn span(&self) -> Span {
        self.tokens.at(self.at).span
    }

    /// Reads the token here, and gives its place. The end is never passed.
    pub(super) fn advance(&mut self) -> Span {
        let span = self.span();
        if *self.peek() != TokenKind::End {
            self.at += 1;
        }
        span
    }

    /// Reads this token, and gives its place.
    pub(super) fn expect(&mut self, kind: &TokenKind) -> Parsed<Span> {
        if self.peek() == kind {
            return Ok(self.advance());
        }
        let wrong = self.expected(&kind.to_string());
        self.fail(wrong)
    }

    /// Reads a name; `what` says which one for the message.
    pub(super) fn name(&mut self, what: &str) -> Parsed<Name> {
        match self.peek() {
            TokenKind::Ident(word) if word != "_" => {
                let value = word.clone();
                Ok(Name { value, span: self.advance() })
            }
            _ => {
                let wrong = self.expected(what);
                self.fail(wrong)
            }
        }
    }

    /// Reads a text in quotes; `what` says which one for the message.
    pub(super) fn text(&mut self, what: &str) -> Parsed<Spanned<String>> {
        if let TokenKind::Str(text) = self.peek() {
            let value = text.clone();
            return Ok(Spanned { value, span: self.advance() });
        }
        let wrong = self.expected(&format!("{what} in double quotes"));
        self.fail(wrong)
    }

    /// A mistake at the token here.
    pub(super) fn wrong(&self, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(self.span(), message)
    }

    /// The mistake that something else stands here than what should.
    pub(super) fn expected(&self, what: &str) -> Diagnostic {
        self.wrong(format!("expected {what}, found {}", self.peek()))
    }

    /// Reports the mistake, unless it is that something unknown stands here, which has been reported already.
    pub(super) fn fail<T>(&mut self, wrong: Diagnostic) -> Parsed<T> {
        if *self.peek() != TokenKind::Unknown || wrong.span != self.span() {
            self.diagnostics.push(wrong);
        }
        Err(Reported)
    }
}
