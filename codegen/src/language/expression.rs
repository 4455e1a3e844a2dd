//! Recursive descent through expressions: each level of precedence is a function, the loosest first.

use std::collections::BTreeMap;

use super::MAX_DEPTH;
use super::ast::{Argument, Expr, ExprKind, Name, ProductOperator, RelationOperator, SumOperator};
use super::diagnostic::Diagnostic;
use super::parser::{Parsed, Parser};
use super::token::{Span, TokenKind, shortened};

impl Parser<'_> {
    /// `not … sum == sum`
    pub(super) fn expression(&mut self) -> Parsed<Expr> {
        self.descend()?;
        let negations = self.repeated(|kind| kind.is_word("not"))?;
        let mut expr = self.sum()?;
        if let Some(operator) = relation(self.peek()) {
            self.advance();
            let right = self.sum()?;
            expr = self.related(expr, operator, right)?;
        }
        self.ascend();
        self.prefixed(negations, expr, ExprKind::Not)
    }

    /// `product + product - …`
    pub(super) fn sum(&mut self) -> Parsed<Expr> {
        let first = self.product()?;
        let mut rest = Vec::new();
        while let Some(operator) = sum_operator(self.peek()) {
            self.advance();
            rest.push((operator, self.product()?));
        }
        if rest.is_empty() {
            Ok(first)
        } else {
            self.chain(first, rest, |first, rest| ExprKind::Sum { first, rest })
        }
    }

    /// `unary * unary / …`
    fn product(&mut self) -> Parsed<Expr> {
        let first = self.unary()?;
        let mut rest = Vec::new();
        while let Some(operator) = product_operator(self.peek()) {
            self.advance();
            rest.push((operator, self.unary()?));
        }
        if rest.is_empty() {
            Ok(first)
        } else {
            self.chain(first, rest, |first, rest| ExprKind::Product { first, rest })
        }
    }

    /// `- … postfix ^ unary`: a power binds more tightly than a sign before it, and its exponent may have a sign.
    fn unary(&mut self) -> Parsed<Expr> {
        let signs = self.repeated(|kind| *kind == TokenKind::Minus)?;
        let mut expr = self.postfix()?;
        if *self.peek() == TokenKind::Caret {
            self.advance();
            self.descend()?;
            let exponent = self.unary()?;
            self.ascend();
            expr = self.power(expr, exponent)?;
        }
        self.prefixed(signs, expr, ExprKind::Negative)
    }

    /// `primary.member(arguments)…`
    fn postfix(&mut self) -> Parsed<Expr> {
        let is_bare_number = matches!(self.peek(), TokenKind::Number(_));
        let mut expr = self.primary()?;
        loop {
            expr = match self.peek() {
                TokenKind::Dot | TokenKind::OpenParen if is_bare_number => return self.after_number(&expr),
                TokenKind::Dot => self.member(expr)?,
                TokenKind::OpenParen => {
                    let (arguments, end) = self.list(&TokenKind::CloseParen, Self::argument)?;
                    self.call(expr, arguments, end)?
                }
                _ => return Ok(expr),
            };
        }
    }

    // The functions above call each other once a level. What they need besides stands in functions of its own, so
    // that each level takes little of the stack.

    /// The places of the tokens of one kind that stand here, unless there are too many.
    fn repeated(&mut self, is_kind: fn(&TokenKind) -> bool) -> Parsed<Vec<Span>> {
        let mut places = Vec::new();
        while is_kind(self.peek()) {
            if places.len() == MAX_DEPTH {
                return self.too_deep(self.span());
            }
            places.push(self.advance());
        }
        Ok(places)
    }

    fn prefixed(
        &mut self,
        prefixes: Vec<Span>,
        mut expr: Expr,
        kind: fn(Box<Expr>) -> ExprKind,
    ) -> Parsed<Expr> {
        for start in prefixes.into_iter().rev() {
            let span = start.to(expr.span());
            expr = self.node(kind(Box::new(expr)), span)?;
        }
        Ok(expr)
    }

    fn related(&mut self, left: Expr, operator: RelationOperator, right: Expr) -> Parsed<Expr> {
        if relation(self.peek()).is_some() {
            let wrong = self.wrong("relations do not chain");
            return self.fail(wrong.help("write a claim for each relation"));
        }
        let span = left.span().to(right.span());
        self.node(ExprKind::Relation { left: Box::new(left), operator, right: Box::new(right) }, span)
    }

    fn chain<O>(
        &mut self,
        first: Expr,
        rest: Vec<(O, Expr)>,
        kind: fn(Box<Expr>, Vec<(O, Expr)>) -> ExprKind,
    ) -> Parsed<Expr> {
        let span = rest.last().map_or(first.span(), |(_, last)| first.span().to(last.span()));
        self.node(kind(Box::new(first), rest), span)
    }

    fn power(&mut self, base: Expr, exponent: Expr) -> Parsed<Expr> {
        let span = base.span().to(exponent.span());
        self.node(ExprKind::Power { base: Box::new(base), exponent: Box::new(exponent) }, span)
    }

    fn member(&mut self, object: Expr) -> Parsed<Expr> {
        self.advance();
        let member = self.name("the name of a member")?;
        let span = object.span().to(member.span);
        self.node(ExprKind::Member { object: Box::new(object), member }, span)
    }

    fn call(&mut self, callee: Expr, arguments: Vec<Argument>, end: Span) -> Parsed<Expr> {
        self.check_arguments(&arguments)?;
        let span = callee.span().to(end);
        self.node(ExprKind::Call { callee: Box::new(callee), arguments }, span)
    }

    /// Reports a member or a call of a number.
    fn after_number(&mut self, number: &Expr) -> Parsed<Expr> {
        if *self.peek() == TokenKind::OpenParen {
            let wrong = self.wrong("a number cannot be called");
            return self.fail(wrong.help(format!("write `{number}*(…)` for a product")));
        }
        self.advance();
        let wrong = self.wrong("a number has no members");
        self.fail(wrong.help(format!("write `{number}*…` for a product")))
    }

    fn primary(&mut self) -> Parsed<Expr> {
        match self.peek() {
            TokenKind::OpenParen => {
                let start = self.span();
                let (parts, end) = self.list(&TokenKind::CloseParen, Self::expression)?;
                self.parenthesized(parts, start.to(end))
            }
            TokenKind::OpenBracket => {
                let start = self.span();
                let (parts, end) = self.list(&TokenKind::CloseBracket, Self::expression)?;
                self.node(ExprKind::Array(parts), start.to(end))
            }
            _ => self.word(),
        }
    }

    /// A number, a text or a name.
    fn word(&mut self) -> Parsed<Expr> {
        let kind = match self.peek() {
            TokenKind::Number(text) => ExprKind::Number(text.clone()),
            TokenKind::Str(text) => ExprKind::Str(text.clone()),
            TokenKind::Ident(name) if name != "not" && name != "_" => ExprKind::Ident(name.clone()),
            _ => return self.no_expression(),
        };
        let span = self.advance();
        self.node(kind, span)
    }

    /// `(a)`, or a vector `(a, b)`
    fn parenthesized(&mut self, mut parts: Vec<Expr>, span: Span) -> Parsed<Expr> {
        let has_comma = *self.before_last() == TokenKind::Comma;
        match (parts.pop(), parts.len()) {
            (Some(only), 0) if !has_comma => Ok(only.at(span)),
            (None, _) | (_, 0) => {
                let wrong = Diagnostic::new(span, "a vector has two or three components");
                self.fail(wrong.help("write `(a, b)` or `(a, b, c)`"))
            }
            (Some(last), _) => {
                parts.push(last);
                self.node(ExprKind::Tuple(parts), span)
            }
        }
    }

    fn argument(&mut self) -> Parsed<Argument> {
        let name = self.argument_name();
        Ok(Argument { name, value: self.expression()? })
    }

    /// `name =`, if that stands here.
    fn argument_name(&mut self) -> Option<Name> {
        let (TokenKind::Ident(name), TokenKind::Equal) = (self.peek(), self.peek_second()) else {
            return None;
        };
        let span = self.advance();
        self.advance();
        Some(Name { value: name.clone(), span })
    }

    fn check_arguments(&mut self, arguments: &[Argument]) -> Parsed<()> {
        let mut named: BTreeMap<&str, Span> = BTreeMap::new();
        let mut first_named = None;
        for argument in arguments {
            match (&argument.name, first_named) {
                (Some(name), _) => {
                    first_named.get_or_insert(name.span);
                    if let Some(first) = named.insert(&name.value, name.span) {
                        let wrong = Diagnostic::new(
                            name.span,
                            format!("`{}` is given twice", shortened(&name.value)),
                        );
                        return self.fail(wrong.also(first, "it is given first here"));
                    }
                }
                (None, Some(first)) => {
                    let wrong =
                        Diagnostic::new(argument.value.span(), "an argument without a name after named ones");
                    let wrong = wrong.also(first, "the first named argument");
                    return self.fail(wrong.help("put the arguments without names first"));
                }
                (None, None) => {}
            }
        }
        Ok(())
    }

    /// `open element, element, … close`, with a comma at the end or without; the place is that of the closing sign.
    fn list<T>(&mut self, close: &TokenKind, element: fn(&mut Self) -> Parsed<T>) -> Parsed<(Vec<T>, Span)> {
        let open = self.advance();
        let mut elements = Vec::new();
        loop {
            if self.peek() == close {
                return Ok((elements, self.advance()));
            }
            elements.push(element(self)?);
            if *self.peek() == TokenKind::Comma {
                self.advance();
            } else if self.peek() != close {
                return self.not_closed(open, close);
            }
        }
    }

    /// Reports that neither another element nor the end of a list stands here.
    pub(super) fn not_closed<T>(&mut self, open: Span, close: &TokenKind) -> Parsed<T> {
        let wrong = self.expected(&format!("`,` or {close}")).also(open, "opened here");
        self.fail(wrong)
    }

    fn no_expression(&mut self) -> Parsed<Expr> {
        let help = match self.peek() {
            TokenKind::Plus => "leave out the `+`",
            TokenKind::Star => "a power is written `a^b`",
            TokenKind::Dot => "a decimal begins with a digit, such as 0.5",
            TokenKind::Ident(name) if name == "not" => {
                "`not` stands before a whole relation; put it in parentheses"
            }
            TokenKind::Ident(_) => "`_` is no name",
            TokenKind::Equal => "equality is written `==`",
            _ => "",
        };
        let wrong = self.expected("an expression");
        self.fail(if help.is_empty() { wrong } else { wrong.help(help) })
    }

    /// An expression of this kind, unless it is nested too deeply.
    fn node(&mut self, kind: ExprKind, span: Span) -> Parsed<Expr> {
        let expr = Expr::new(kind, span);
        if expr.depth() > MAX_DEPTH { self.too_deep(Span::at(span.last)) } else { Ok(expr) }
    }

    /// Goes one level deeper into parentheses or exponents.
    fn descend(&mut self) -> Parsed<()> {
        self.depth += 1;
        if self.depth > MAX_DEPTH { self.too_deep(self.span()) } else { Ok(()) }
    }

    fn ascend(&mut self) {
        self.depth -= 1;
    }

    fn too_deep<T>(&mut self, span: Span) -> Parsed<T> {
        let wrong = Diagnostic::new(span, format!("this is nested more than {MAX_DEPTH} levels deep"));
        self.fail(wrong.help("name its parts: `let part = …;`"))
    }
}

fn sum_operator(kind: &TokenKind) -> Option<SumOperator> {
    match kind {
        TokenKind::Plus => Some(SumOperator::Plus),
        TokenKind::Minus => Some(SumOperator::Minus),
        _ => None,
    }
}

fn product_operator(kind: &TokenKind) -> Option<ProductOperator> {
    match kind {
        TokenKind::Star => Some(ProductOperator::Times),
        TokenKind::Slash => Some(ProductOperator::Over),
        _ => None,
    }
}

fn relation(kind: &TokenKind) -> Option<RelationOperator> {
    Some(match kind {
        TokenKind::EqualEqual => RelationOperator::Equal,
        TokenKind::NotEqual => RelationOperator::NotEqual,
        TokenKind::Less => RelationOperator::Less,
        TokenKind::LessEqual => RelationOperator::LessEqual,
        TokenKind::Greater => RelationOperator::Greater,
        TokenKind::GreaterEqual => RelationOperator::GreaterEqual,
        _ => return None,
    })
}
