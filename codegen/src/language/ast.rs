//! What a source says, as it is written: sweeps, lemmas, their clauses and expressions, with the places of all.
//!
//! Two trees are equal when they say the same; places do not count.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use super::token::Span;

/// Something that stands at a place; equality looks at the value alone.
#[derive(Clone, Debug)]
pub struct Spanned<T> {
    /// What it is.
    pub value: T,
    /// Where it stands.
    pub span: Span,
}

impl<T: PartialEq> PartialEq for Spanned<T> {
    fn eq(&self, other: &Spanned<T>) -> bool {
        self.value == other.value
    }
}

/// A name where it is defined, or a member where it is asked for.
pub type Name = Spanned<String>;

/// All of a source.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct File {
    /// Sweeps and lemmas, in the order of the source.
    pub items: Vec<Item>,
    /// The texts of the other files that the source names, by these names, or why they could not be read.
    pub inputs: BTreeMap<String, Result<String, String>>,
}

impl File {
    /// The names of the other files that the source names, in `frames_file("…")`: paths from the folder of the source. Each
    /// stands there once, in the order of the alphabet.
    #[must_use]
    pub fn input_names(&self) -> BTreeSet<String> {
        let mut names = BTreeSet::new();
        for clause in self.items.iter().flat_map(|item| &item.clauses) {
            if let ClauseKind::Curve(Curve { role: CurveRole::Frames, value, .. }) = &clause.kind
                && let ExprKind::Call { callee, arguments } = value.kind()
                && matches!(callee.kind(), ExprKind::Ident(name) if name == "frames_file")
                && let Some(Argument { name: None, value }) = arguments.first()
                && let ExprKind::Str(name) = value.kind()
            {
                names.insert(name.clone());
            }
        }
        names
    }

    /// Gives the texts of the other files that the source names: `read` is called with each of their names.
    ///
    /// ```
    /// use hodograph_codegen::{language::parse_text, meaning::models};
    ///
    /// let text = r#"lemma turn {
    ///     frames F(v) = frames_file("turn.json");
    ///     claim "end": F.position(1) == (2, 0, 1/2);
    /// }"#;
    /// let (mut file, _source) = parse_text("turn.sweep", text).unwrap();
    /// file.attach(|name| {
    ///     assert_eq!(name, "turn.json");
    ///     let frames = r#"[
    ///         {"position": [0, 0, 0], "quaternion": ["3/5", 0, 0, "4/5"]},
    ///         {"position": [2, 0, 0.5], "quaternion": [-1, 0, 0, 0], "scale": 1.5}
    ///     ]"#;
    ///     Ok(frames.to_owned())
    /// });
    /// let (models, mistakes) = models(&file);
    /// assert!(mistakes.is_empty());
    /// assert_eq!(models[0].check(&models[0].claims[0], u64::MAX).unwrap().derived, "both sides are (2, 0, 1/2)");
    /// ```
    pub fn attach(&mut self, mut read: impl FnMut(&str) -> Result<String, String>) {
        for name in self.input_names() {
            let text = read(&name);
            self.inputs.insert(name, text);
        }
    }
}

/// A sweep or a lemma: `sweep name { … }`.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    /// Which of both.
    pub kind: ItemKind,
    /// The lines of its documentation.
    pub docs: Vec<Spanned<String>>,
    /// What it is called.
    pub name: Name,
    /// What it says, in the order of the source.
    pub clauses: Vec<Clause>,
}

/// The kinds of items.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ItemKind {
    /// A surface with its domain, from which code is generated, and claims on it.
    Sweep,
    /// Claims on curves, frames and identities, without a surface.
    Lemma,
}

impl fmt::Display for ItemKind {
    /// The keyword.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ItemKind::Sweep => "sweep",
            ItemKind::Lemma => "lemma",
        })
    }
}

/// One statement of an item, up to its `;`.
#[derive(Clone, Debug)]
pub struct Clause {
    /// The lines of its documentation.
    pub docs: Vec<Spanned<String>>,
    /// Where it stands, from its keyword to its `;`.
    pub span: Span,
    /// What it says.
    pub kind: ClauseKind,
}

impl PartialEq for Clause {
    fn eq(&self, other: &Clause) -> bool {
        self.docs == other.docs && self.kind == other.kind
    }
}

/// The kinds of clauses.
#[derive(Clone, Debug, PartialEq)]
pub enum ClauseKind {
    /// `source "…";`: where the formula is taken from.
    Source(Spanned<String>),
    /// `symbol c0, c1;`: unknown constants.
    Symbol(Vec<Name>),
    /// `function x(u), z(u);`: unknown functions of one parameter.
    Function(Vec<Function>),
    /// `let f(u, v) = …;`: a name for a value.
    Let(Definition),
    /// `profile p(u) = …;`, `path s(v) = …;`, `curve c(t) = …;`, `frames F(v) = …;`
    Curve(Curve),
    /// `surface R = …;`
    Surface(Surface),
    /// `domain u in 0..1, v in 0..1;`
    Domain(Vec<Interval>),
    /// `prefer accurate;`: what evaluators should be above all.
    Prefer(Spanned<Preference>),
    /// `claim "id": …;`
    Claim(Claim),
    /// `substitute u = …;`
    Substitute(Definition),
}

/// What evaluators should be above all.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Debug)]
pub enum Preference {
    /// `fast`, which is the default.
    #[default]
    Fast,
    /// `accurate`
    Accurate,
}

/// An unknown function of one parameter, `x(u)`.
#[derive(Clone, Debug, PartialEq)]
pub struct Function {
    /// The function.
    pub name: Name,
    /// What it depends on.
    pub parameter: Name,
}

/// `name(parameters) = value`
#[derive(Clone, Debug, PartialEq)]
pub struct Definition {
    /// What is defined.
    pub name: Name,
    /// What it depends on; no two have one name.
    pub parameters: Vec<Name>,
    /// What it is.
    pub value: Expr,
}

/// `role name(parameter) = value`
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// What the curve is in the sweep.
    pub role: CurveRole,
    /// What it is called.
    pub name: Name,
    /// What it depends on.
    pub parameter: Name,
    /// What it is.
    pub value: Expr,
}

/// What a curve is in a sweep.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveRole {
    /// The curve that is swept.
    Profile,
    /// The curve along which it is swept.
    Path,
    /// Any other.
    Curve,
    /// A motion through frames.
    Frames,
}

/// `surface name(parameters) = value`
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// What it is called.
    pub name: Name,
    /// Its two parameters, if they are named; `u` and `v` otherwise.
    pub parameters: Option<[Name; 2]>,
    /// The formula; its `Display` is the statement to be shown.
    pub value: Expr,
}

impl Surface {
    /// The names of its two parameters.
    pub fn parameter_names(&self) -> [&str; 2] {
        match &self.parameters {
            Some([first, second]) => [&first.value, &second.value],
            None => ["u", "v"],
        }
    }
}

/// The closed interval `parameter in start..end`.
#[derive(Clone, Debug, PartialEq)]
pub struct Interval {
    /// The parameter that runs through it.
    pub parameter: Name,
    /// Its beginning.
    pub start: Expr,
    /// Its end.
    pub end: Expr,
}

/// `claim "id": relation, "note", instead "…", effect major "…", expect refuted, when condition;`
#[derive(Clone, Debug, PartialEq)]
pub struct Claim {
    /// The claim's id, which need not be unique.
    pub id: Spanned<String>,
    /// What is claimed; its `Display` is the statement to be shown.
    pub relation: Expr,
    /// Remarks.
    pub notes: Vec<Spanned<String>>,
    /// What this says in place of refuted claims with the same id, if it does.
    pub instead: Option<Spanned<String>>,
    /// What a mistake in it means for whoever uses it.
    pub effect: Option<Effect>,
    /// The verdict that is expected, if the source says so.
    pub expected: Option<Spanned<Verdict>>,
    /// Under which conditions it is claimed.
    pub conditions: Vec<Expr>,
}

/// What a mistake means for whoever uses what is claimed: `effect major "…"`.
#[derive(Clone, Debug, PartialEq)]
pub struct Effect {
    /// How grave it is.
    pub severity: Spanned<Severity>,
    /// What it means.
    pub text: Spanned<String>,
}

/// How grave a mistake is, gravest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Whoever computes with what is claimed gets another surface, or a wrong value.
    Major,
    /// What is claimed holds under a condition that is not stated.
    Moderate,
    /// A number is misprinted, or nobody computes with it.
    Minor,
}

impl fmt::Display for Severity {
    /// The word that the language has for it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Severity::Major => "major",
            Severity::Moderate => "moderate",
            Severity::Minor => "minor",
        })
    }
}

/// What became of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// It holds.
    Proved,
    /// It does not hold.
    Refuted,
    /// It is not known whether it holds.
    Undecided,
}

impl fmt::Display for Verdict {
    /// The word that the language has for it.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Verdict::Proved => "proved",
            Verdict::Refuted => "refuted",
            Verdict::Undecided => "undecided",
        })
    }
}

/// An expression. `Display` writes it with the parentheses that it needs and no others; what is written is read
/// back as an equal expression.
#[derive(Clone, Debug)]
pub struct Expr {
    kind: ExprKind,
    span: Span,
    depth: usize,
}

/// The kinds of expressions. Sums and products hold all their operands in one node, so that no long chain is deep.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// A decimal number, exact: `0.25`, `1e-3`.
    Number(String),
    /// A name.
    Ident(String),
    /// A text.
    Str(String),
    /// A vector `(a, b)` or `(a, b, c)`; two components at least.
    Tuple(Vec<Expr>),
    /// A list `[a, b]`.
    Array(Vec<Expr>),
    /// `callee(arguments)`
    Call {
        /// What is called: a name, mostly, or what a member gives.
        callee: Box<Expr>,
        /// With what: those without a name come first, and no two have one name.
        arguments: Vec<Argument>,
    },
    /// `object.member`
    Member {
        /// What is asked.
        object: Box<Expr>,
        /// What it is asked for.
        member: Name,
    },
    /// `-a`
    Negative(Box<Expr>),
    /// `not a`
    Not(Box<Expr>),
    /// `first + a - b`, from left to right.
    Sum {
        /// The first operand.
        first: Box<Expr>,
        /// The others, one at least.
        rest: Vec<(SumOperator, Expr)>,
    },
    /// `first*a/b`, from left to right.
    Product {
        /// The first operand.
        first: Box<Expr>,
        /// The others, one at least.
        rest: Vec<(ProductOperator, Expr)>,
    },
    /// `base^exponent`
    Power {
        /// What is raised.
        base: Box<Expr>,
        /// To which power.
        exponent: Box<Expr>,
    },
    /// `left == right`
    Relation {
        /// The left side.
        left: Box<Expr>,
        /// Which relation.
        operator: RelationOperator,
        /// The right side.
        right: Box<Expr>,
    },
}

/// An argument of a call: `value` or `name = value`.
#[derive(Clone, Debug, PartialEq)]
pub struct Argument {
    /// Its name, if it is given one.
    pub name: Option<Name>,
    /// What is given.
    pub value: Expr,
}

/// `+` or `-` between two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SumOperator {
    /// `+`
    Plus,
    /// `-`
    Minus,
}

/// `*` or `/` between two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ProductOperator {
    /// `*`
    Times,
    /// `/`
    Over,
}

/// What is said of two sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RelationOperator {
    /// `==`
    Equal,
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
}

impl RelationOperator {
    /// Whether the left side is to be the lesser one, `<` or `<=`.
    pub(crate) fn is_less(self) -> bool {
        matches!(self, RelationOperator::Less | RelationOperator::LessEqual)
    }
}

impl Expr {
    /// An expression at a place.
    pub fn new(kind: ExprKind, span: Span) -> Expr {
        let mut expr = Expr { kind, span, depth: 0 };
        expr.depth = 1 + expr.children().map(Expr::depth).max().unwrap_or(0);
        expr
    }

    /// What it is.
    pub fn kind(&self) -> &ExprKind {
        &self.kind
    }

    /// Where it stands, with the parentheses around it.
    pub fn span(&self) -> Span {
        self.span
    }

    /// How deeply it is nested: 1 for a name. What the parser gives is at most
    /// [`MAX_DEPTH`](super::MAX_DEPTH) deep, so that it can be walked by recursion. Takes O(1).
    pub fn depth(&self) -> usize {
        self.depth
    }

    /// Its direct parts, from left to right.
    pub fn children(&self) -> impl Iterator<Item = &Expr> {
        let (first, second, rest): (Option<&Expr>, Option<&Expr>, Vec<&Expr>) = match &self.kind {
            ExprKind::Number(_) | ExprKind::Ident(_) | ExprKind::Str(_) => (None, None, vec![]),
            ExprKind::Tuple(parts) | ExprKind::Array(parts) => (None, None, parts.iter().collect()),
            ExprKind::Call { callee, arguments } => {
                (Some(callee), None, arguments.iter().map(|argument| &argument.value).collect())
            }
            ExprKind::Member { object, .. } => (Some(object), None, vec![]),
            ExprKind::Negative(operand) | ExprKind::Not(operand) => (Some(operand), None, vec![]),
            ExprKind::Sum { first, rest } => (Some(first), None, rest.iter().map(|(_, part)| part).collect()),
            ExprKind::Product { first, rest } => {
                (Some(first), None, rest.iter().map(|(_, part)| part).collect())
            }
            ExprKind::Power { base, exponent } => (Some(base), Some(exponent), vec![]),
            ExprKind::Relation { left, right, .. } => (Some(left), Some(right), vec![]),
        };
        first.into_iter().chain(second).chain(rest)
    }

    /// The same expression at another place.
    pub(super) fn at(self, span: Span) -> Expr {
        Expr { span, ..self }
    }
}

impl PartialEq for Expr {
    fn eq(&self, other: &Expr) -> bool {
        self.kind == other.kind
    }
}
