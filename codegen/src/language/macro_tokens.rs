//! The tokens of a macro's input to the tokens of the language.

use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, TokenStream, TokenTree};

use super::diagnostic::{Diagnostic, Diagnostics};
use super::spelling;
use super::token::{Span, SpanId, Token, TokenKind, Tokens};

/// The input of a macro, which resolves the places of its tokens.
#[derive(Clone, Debug)]
pub struct MacroSource {
    spans: Vec<proc_macro2::Span>,
}

impl MacroSource {
    /// The places of the first and the last token.
    pub fn ends(&self, span: Span) -> (proc_macro2::Span, proc_macro2::Span) {
        let place = |id: SpanId| self.spans.get(id.0 as usize).copied();
        let whole = proc_macro2::Span::call_site;
        (place(span.first).unwrap_or_else(whole), place(span.last).unwrap_or_else(whole))
    }

    /// The mistakes as one error at the user's tokens, at most twenty and then a count; `None` if there are none.
    pub fn error(&self, diagnostics: &Diagnostics) -> Option<syn::Error> {
        let mut all: Option<syn::Error> = None;
        for diagnostic in diagnostics.shown() {
            let mut message = diagnostic.message.clone();
            for text in diagnostic.label.iter() {
                message.push_str(": ");
                message.push_str(text);
            }
            for text in diagnostic.help.iter() {
                message.push_str("\nhelp: ");
                message.push_str(text);
            }
            let mut errors = vec![self.error_at(diagnostic.span, &message)];
            errors.extend(diagnostic.also.iter().map(|(span, text)| self.error_at(*span, text)));
            for error in errors {
                match &mut all {
                    Some(all) => all.combine(error),
                    None => all = Some(error),
                }
            }
        }
        if let (Some(all), Some(remainder)) = (&mut all, diagnostics.remainder()) {
            all.combine(syn::Error::new(proc_macro2::Span::call_site(), remainder));
        }
        all
    }

    fn error_at(&self, span: Span, message: &str) -> syn::Error {
        // An error from the first to the last of some tokens is what stable Rust offers for a joined place.
        let (first, last) = self.ends(span);
        let ends = [Ident::new("first", first), Ident::new("last", last)];
        syn::Error::new_spanned(ends.into_iter().map(TokenTree::from).collect::<TokenStream>(), message)
    }
}

/// The tokens of a macro's input, the source that knows their places, and what was wrong.
///
/// Groups become their delimiters and what is in them. Groups without visible delimiters, which `macro_rules!`
/// makes of `$x:expr`, are transparent, except that one with an operator in it keeps together as if in parentheses.
pub fn adapt(input: TokenStream) -> (Tokens, MacroSource, Diagnostics) {
    let mut adapter = Adapter { tokens: vec![], spans: vec![], diagnostics: Diagnostics::new() };
    // Groups are entered by a stack of our own: input may be nested more deeply than the program's stack allows.
    let mut open = vec![Level { trees: input.into_iter().collect(), at: 0, close: None }];
    while let Some(level) = open.last_mut() {
        let at = level.at;
        let Some(tree) = level.trees.get(at) else {
            let close = level.close.take();
            open.pop();
            if let Some((kind, span)) = close {
                adapter.add(kind, span);
            }
            continue;
        };
        if let TokenTree::Group(group) = tree {
            let group = group.clone();
            level.at += 1;
            open.push(adapter.open(&group));
        } else {
            level.at += adapter.leaf(&level.trees[at..]);
        }
    }
    let end = adapter.spans.last().copied().unwrap_or_else(proc_macro2::Span::call_site);
    let end = adapter.place(end);
    (Tokens::new(adapter.tokens, end), MacroSource { spans: adapter.spans }, adapter.diagnostics)
}

/// A group that is being read: what is in it, how much of that is read, and what closes it.
struct Level {
    trees: Vec<TokenTree>,
    at: usize,
    close: Option<(TokenKind, proc_macro2::Span)>,
}

struct Adapter {
    tokens: Vec<Token>,
    spans: Vec<proc_macro2::Span>,
    diagnostics: Diagnostics,
}

impl Adapter {
    fn open(&mut self, group: &Group) -> Level {
        let trees: Vec<TokenTree> = group.stream().into_iter().collect();
        let delimiters = match group.delimiter() {
            Delimiter::Parenthesis => Some((TokenKind::OpenParen, TokenKind::CloseParen)),
            Delimiter::Bracket => Some((TokenKind::OpenBracket, TokenKind::CloseBracket)),
            Delimiter::Brace => Some((TokenKind::OpenBrace, TokenKind::CloseBrace)),
            Delimiter::None if is_operation(&trees) => Some((TokenKind::OpenParen, TokenKind::CloseParen)),
            Delimiter::None => None,
        };
        let close = delimiters.map(|(open, close)| {
            self.add(open, group.span_open());
            (close, group.span_close())
        });
        Level { trees, at: 0, close }
    }

    /// Reads what begins with the first of these trees, which is no group; gives the number of trees read.
    fn leaf(&mut self, trees: &[TokenTree]) -> usize {
        match trees {
            [TokenTree::Ident(ident), ..] => {
                self.spelled(ident.span(), |span| spelling::name(&ident.to_string(), span));
                1
            }
            [TokenTree::Literal(literal), ..] => {
                self.literal(literal);
                1
            }
            [TokenTree::Punct(punct), rest @ ..] => 1 + self.punct(punct, rest),
            _ => 1,
        }
    }

    /// Gives the number of trees read from those after the sign.
    fn punct(&mut self, punct: &Punct, rest: &[TokenTree]) -> usize {
        let character = punct.as_char();
        if character == '#'
            && let Some(length) = self.documentation(punct.span(), rest)
        {
            return length;
        }
        if let [TokenTree::Punct(next), ..] = rest
            && punct.spacing() == Spacing::Joint
            && let Some(kind) = spelling::pair(character, next.as_char())
        {
            let first = self.place(punct.span());
            let last = self.place(next.span());
            self.tokens.push(Token { kind, span: first.to(last) });
            return 1;
        }
        if let Some(kind) = spelling::single(character) {
            self.add(kind, punct.span());
            return 0;
        }
        let repeated = if punct.spacing() == Spacing::Joint { repetitions(character, rest) } else { 0 };
        let first = self.place(punct.span());
        let span = match rest[..repeated].last() {
            Some(last) => first.to(self.place(last.span())),
            None => first,
        };
        if character == '\'' {
            let of = match self.tokens.last() {
                Some(Token { kind: TokenKind::Ident(name), .. }) => Some(name.clone()),
                _ => None,
            };
            self.diagnostics.push(spelling::prime(of.as_deref(), span));
        } else {
            let (meant, wrong) = spelling::unknown(character, span);
            self.diagnostics.push(wrong);
            self.tokens.extend(meant.into_iter().map(|kind| Token { kind, span }));
        }
        repeated
    }

    /// Reads the rest of `#[doc = "…"]`, which Rust makes of a documentation comment; gives the number of trees read.
    fn documentation(&mut self, hash: proc_macro2::Span, rest: &[TokenTree]) -> Option<usize> {
        let (is_inner, group, length) = match rest {
            [TokenTree::Group(group), ..] => (false, group, 1),
            [TokenTree::Punct(bang), TokenTree::Group(group), ..] if bang.as_char() == '!' => {
                (true, group, 2)
            }
            _ => return None,
        };
        let attribute: Vec<TokenTree> = group.stream().into_iter().collect();
        let [TokenTree::Ident(doc), TokenTree::Punct(equal), TokenTree::Literal(text)] = attribute.as_slice()
        else {
            return None;
        };
        if group.delimiter() != Delimiter::Bracket || doc != "doc" || equal.as_char() != '=' {
            return None;
        }
        let syn::Lit::Str(text) = syn::Lit::new(text.clone()) else { return None };
        let first = self.place(hash);
        let span = first.to(self.place(group.span_close()));
        if is_inner {
            self.diagnostics.push(spelling::inner_documentation(span));
        } else {
            self.tokens.push(Token { kind: TokenKind::DocComment(text.value()), span });
        }
        Some(length)
    }

    fn literal(&mut self, literal: &Literal) {
        let text = literal.to_string();
        // A negative literal comes only from another macro.
        let positive = text.strip_prefix('-');
        if positive.is_some() {
            self.add(TokenKind::Minus, literal.span());
        }
        let text = positive.unwrap_or(&text);
        let string = text.strip_prefix('"').and_then(|rest| rest.rsplit_once('"'));
        if text.starts_with(|c: char| c.is_ascii_digit()) {
            self.spelled(literal.span(), |span| spelling::number(text, span));
        } else if let Some((body, suffix)) = string {
            self.spelled(literal.span(), |span| spelling::string(body, span));
            if !suffix.is_empty() {
                let span = self.place(literal.span());
                let wrong = Diagnostic::new(span, "a space is missing after this text");
                self.diagnostics.push(wrong.help("write a space here"));
                self.spelled(literal.span(), |span| spelling::name(suffix, span));
            }
        } else {
            self.spelled(literal.span(), |span| spelling::foreign_literal(text, span));
        }
    }

    fn spelled(
        &mut self,
        at: proc_macro2::Span,
        spell: impl FnOnce(Span) -> (TokenKind, Option<Diagnostic>),
    ) {
        let span = self.place(at);
        let (kind, wrong) = spell(span);
        if let Some(wrong) = wrong {
            self.diagnostics.push(wrong);
        }
        self.tokens.push(Token { kind, span });
    }

    fn add(&mut self, kind: TokenKind, at: proc_macro2::Span) {
        let span = self.place(at);
        self.tokens.push(Token { kind, span });
    }

    fn place(&mut self, at: proc_macro2::Span) -> Span {
        let id = SpanId(self.spans.len() as u32);
        self.spans.push(at);
        Span::at(id)
    }
}

/// How often the sign is joined by itself.
fn repetitions(character: char, rest: &[TokenTree]) -> usize {
    let mut count = 0;
    for tree in rest {
        let TokenTree::Punct(next) = tree else { break };
        if next.as_char() != character {
            break;
        }
        count += 1;
        if next.spacing() == Spacing::Alone {
            break;
        }
    }
    count
}

/// Whether an operator stands in these trees, and nothing that ends an expression.
fn is_operation(trees: &[TokenTree]) -> bool {
    let signs: String = trees
        .iter()
        .filter_map(|tree| if let TokenTree::Punct(punct) = tree { Some(punct.as_char()) } else { None })
        .collect();
    signs.contains(['+', '-', '*', '/', '^', '<', '>'])
        && !signs.contains([',', ';', ':'])
        && !signs.contains("..")
}

#[cfg(test)]
mod tests {
    use super::super::lexer::lex;
    use super::*;

    /// Sources that Rust can cut into tokens.
    const SOURCES: &[&str] = &[
        "",
        "sweep a { source \"x \\\"y\\\" \\u{e9}\"; domain u in 0..1, v in -1..1.5; }",
        "/// One\n/// Two\nlemma b { /* c /* d */ */ claim \"e\": f == g; } // h",
        "//! inner\n/** block */ a",
        "a <= b >= c < d > e == f = g == = .. . ... ..= === <== => =",
        "2^-3*-a^-b--c",
        "0.5.x 1.x 1..2 1_000 1e-3 2.5E+7 1_e2 007",
        "2u 2.5u 1_000u 0x10 0b101 0o17 1f64 3usize 5i 2e3x 1. ",
        "p.x * s.normal + (a, b)[c]{d}",
        "σ + κ*x_1 straße",
        "a ! b && c || d % e # f @ g $ h ~ i ? j != k",
        "'c' '\\n' b'c' r\"raw\" b\"bytes\" c\"c\" r#name",
        "\"two\nlines\" after",
        "_ _a a_ _1 not in expect when",
        "#[doc = \"attribute\"]",
    ];

    #[test]
    fn a_macro_and_a_text_give_the_same_tokens() {
        for text in SOURCES {
            let stream: TokenStream = text.parse().unwrap_or_else(|error| panic!("{text}: {error}"));
            let (adapted, _, adapted_wrong) = adapt(stream);
            let (lexed, _, lexed_wrong) = lex("test", text);
            if text.starts_with("#[") || text.contains('\n') && text.starts_with('"') {
                continue;
            }
            assert_eq!(adapted.kinds(), lexed.kinds(), "{text}");
            let messages = |wrong: &Diagnostics| -> Vec<_> {
                wrong.iter().map(|wrong| (wrong.message.clone(), wrong.help.clone())).collect()
            };
            assert_eq!(messages(&adapted_wrong), messages(&lexed_wrong), "{text}");
        }
    }

    #[test]
    fn an_attribute_is_documentation() {
        let (tokens, _, wrong) = adapt("#[doc = r\" one\"] a".parse().unwrap());
        assert!(wrong.is_empty());
        let expected = [TokenKind::DocComment(" one".into()), TokenKind::Ident("a".into()), TokenKind::End];
        assert_eq!(tokens.kinds(), expected);
    }

    #[test]
    fn a_text_may_not_go_on_in_the_next_line() {
        let (_, _, wrong) = adapt("\"two\nlines\"".parse().unwrap());
        assert_eq!(wrong.count(), 1);
    }

    #[test]
    fn invisible_groups_keep_their_operators_together() {
        let hidden = |text: &str| TokenTree::Group(Group::new(Delimiter::None, text.parse().unwrap()));
        let product = |text: &str| -> Vec<TokenKind> {
            let stream: TokenStream =
                "2 *".parse::<TokenStream>().unwrap().into_iter().chain([hidden(text)]).collect();
            adapt(stream).0.kinds()
        };
        let lexed = |text: &str| lex("test", text).0.kinds();
        assert_eq!(product("a + b"), lexed("2*(a + b)"));
        assert_eq!(product("a"), lexed("2*a"));
        assert_eq!(product("f(a + b).x"), lexed("2*f(a + b).x"));
        assert_eq!(product("0..1 + 1"), lexed("2*0..1 + 1"));
        let negative = TokenTree::Literal(Literal::i32_unsuffixed(-3));
        assert_eq!(adapt(TokenStream::from(negative)).0.kinds(), lexed("-3"));
    }

    #[test]
    fn deep_groups_do_not_overflow_the_stack() {
        let mut stream = TokenStream::new();
        for _ in 0..20_000 {
            stream = TokenStream::from(TokenTree::Group(Group::new(Delimiter::Parenthesis, stream)));
        }
        assert_eq!(adapt(stream).0.kinds().len(), 40_001);
    }

    /// How many errors there are, and the last of them.
    fn source_error_count(text: String) -> (usize, String) {
        let (_, source, wrong) = adapt(text.parse().unwrap());
        let errors: Vec<String> =
            source.error(&wrong).into_iter().flatten().map(|error| error.to_string()).collect();
        (errors.len(), errors.last().cloned().unwrap_or_default())
    }

    #[test]
    fn mistakes_stand_at_the_tokens_of_the_user() {
        let (_, source, wrong) = adapt("a + 2u\n  + 0x10".parse().unwrap());
        let error = source.error(&wrong).expect("two mistakes");
        let places: Vec<_> =
            error.into_iter().map(|error| (error.span().start().line, error.to_string())).collect();
        assert_eq!(places.len(), 2);
        assert_eq!((places[0].0, places[1].0), (1, 2));
        let many = source_error_count("2u ".repeat(30));
        assert_eq!(many, (21, "… and 10 more mistakes".to_string()));
        assert_eq!(places[0].1, "`2u` is neither a number nor a product\nhelp: write 2*u");
    }
}
