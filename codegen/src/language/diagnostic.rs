//! What is wrong, where, and what to do about it: independent of where the tokens come from.

use super::token::Span;

/// One mistake of the user.
///
/// # Example
/// ```
/// use hodograph_codegen::language::parse_text;
///
/// let report = parse_text("a.sweep", "lemma a { lte b = 1; }").unwrap_err();
/// let diagnostic = report.diagnostics().iter().next().unwrap();
/// assert_eq!(diagnostic.message, "there is no clause `lte`");
/// assert_eq!(diagnostic.help.as_deref(), Some("did you mean `let`?"));
/// assert_eq!(report.source().position(diagnostic.span).column, 11);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// What is wrong, in one line without a full stop.
    pub message: String,
    /// Where.
    pub span: Span,
    /// A few words at the place itself.
    pub label: Option<String>,
    /// What to do.
    pub help: Option<String>,
    /// Other places that matter, each with what is there.
    pub also: Vec<(Span, String)>,
}

impl Diagnostic {
    /// A mistake at a place.
    pub fn new(span: Span, message: impl Into<String>) -> Diagnostic {
        Diagnostic { message: message.into(), span, label: None, help: None, also: Vec::new() }
    }

    /// The same with a few words at the place itself.
    pub fn label(mut self, label: impl Into<String>) -> Diagnostic {
        self.label = Some(label.into());
        self
    }

    /// The same with what to do.
    pub fn help(mut self, help: impl Into<String>) -> Diagnostic {
        self.help = Some(help.into());
        self
    }

    /// The same with another place that matters.
    pub fn also(mut self, span: Span, text: impl Into<String>) -> Diagnostic {
        self.also.push((span, text.into()));
        self
    }
}

/// How many mistakes are shown; the others are only counted.
const SHOWN: usize = 20;

/// How many mistakes are kept; the others are only counted.
const KEPT: usize = 1000;

/// The mistakes found in one source, sorted by place.
#[derive(Clone, Debug, Default)]
pub struct Diagnostics {
    kept: Vec<Diagnostic>,
    count: usize,
}

impl Diagnostics {
    /// No mistakes yet.
    pub fn new() -> Diagnostics {
        Diagnostics::default()
    }

    /// Adds a mistake, behind those at the same place. Beyond a thousand they are only counted.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        self.count += 1;
        if self.kept.len() < KEPT {
            let at = self.kept.partition_point(|other| other.span <= diagnostic.span);
            self.kept.insert(at, diagnostic);
        }
    }

    /// Adds all mistakes of `other`.
    pub fn append(&mut self, other: Diagnostics) {
        let uncounted = other.count - other.kept.len();
        for diagnostic in other.kept {
            self.push(diagnostic);
        }
        self.count += uncounted;
    }

    /// Whether nothing is wrong.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// How many mistakes were found, those not kept included.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The mistakes that are shown to a person: the first twenty.
    pub(super) fn shown(&self) -> impl Iterator<Item = &Diagnostic> {
        self.kept.iter().take(SHOWN)
    }

    /// How many mistakes are not shown, in words.
    pub(super) fn remainder(&self) -> Option<String> {
        match self.count.saturating_sub(SHOWN) {
            0 => None,
            1 => Some("… and 1 more mistake".to_string()),
            more => Some(format!("… and {more} more mistakes")),
        }
    }

    /// The mistakes, by place.
    pub fn iter(&self) -> impl Iterator<Item = &Diagnostic> {
        self.kept.iter()
    }
}
