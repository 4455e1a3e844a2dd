//! Why an expression has no value.

use hodograph_algebra::budget::Exhausted;
use hodograph_algebra::{CurveError, OffsetError};

use crate::language::{Diagnostic, Span};

/// Why an expression has no value, at its place.
#[derive(Clone, Debug)]
pub(super) struct Fault {
    /// What to tell the user.
    pub diagnostic: Box<Diagnostic>,
    /// Whether the value exists but is not a rational function: what `is_rational` asks for.
    pub irrational: bool,
    /// Whether the value exists, but over a root of symbols that has no form here.
    pub undecidable: bool,
    /// Whether the cause has been reported already.
    pub reported: bool,
    /// Further mistakes in the same expression.
    pub others: Vec<Diagnostic>,
}

impl Fault {
    /// A mistake at a place.
    pub(super) fn new(span: Span, message: impl Into<String>) -> Fault {
        Diagnostic::new(span, message).into()
    }

    /// A consequence of a mistake that has been reported already.
    pub(super) fn silent(span: Span) -> Fault {
        let mut fault = Fault::new(span, "this depends on a definition with a mistake");
        fault.reported = true;
        fault
    }

    /// Both faults as one.
    #[must_use]
    pub(super) fn and(mut self, other: Fault) -> Fault {
        if self.reported {
            return other;
        }
        if !other.reported {
            self.others.push(*other.diagnostic);
            self.others.extend(other.others);
        }
        self
    }

    /// All mistakes, for a report; none if they have been reported already.
    pub(super) fn into_diagnostics(self) -> Vec<Diagnostic> {
        if self.reported {
            Vec::new()
        } else {
            std::iter::once(*self.diagnostic).chain(self.others).collect()
        }
    }

    /// The same with what to do.
    #[must_use]
    pub(super) fn help(mut self, help: impl Into<String>) -> Fault {
        *self.diagnostic = self.diagnostic.clone().help(help);
        self
    }

    /// A property that a curve does not have.
    pub(super) fn curve(span: Span, error: &CurveError) -> Fault {
        let irrational =
            matches!(error, CurveError::IrrationalSpeed { .. } | CurveError::SpeedChangesSign { .. });
        let help = match error {
            CurveError::IrrationalSpeed { .. } => {
                "only curves with a rational parametric speed, such as Pythagorean-hodograph curves (`ph`, \
                 `ph_hermite`), have a rational tangent and normal"
            }
            CurveError::SpeedChangesSign { .. } => "state a `domain` on which the curve has no such cusp",
            CurveError::Point => "give a curve whose points differ",
            CurveError::NotPlanar => "a planar normal needs a curve with one coordinate that is zero",
            CurveError::ArcLength { .. } => "a polynomial parametric speed, as that of `ph` curves, has one",
            CurveError::Straight => "give a curve that bends",
            CurveError::NoDomain => "state `domain`, with the interval of the curve's parameter",
            _ => "",
        };
        let mut fault = Fault::new(span, error.to_string());
        fault.irrational = irrational;
        fault.undecidable = matches!(error, CurveError::ArcLength { .. });
        if help.is_empty() { fault } else { fault.help(help) }
    }

    /// An offset that a surface does not have.
    pub(super) fn offset(span: Span, error: &OffsetError) -> Fault {
        let mut fault = Fault::new(span, error.to_string());
        fault.irrational = matches!(error, OffsetError::Irrational { .. });
        fault.undecidable = matches!(error, OffsetError::SymbolicRadical { .. });
        fault
    }

    /// Work beyond the budget.
    pub(super) fn exhausted(span: Span, error: &Exhausted) -> Fault {
        let message = error.to_string();
        Fault::new(span, message).help("use smaller degrees, fewer symbols, or simpler numbers")
    }
}

impl From<Diagnostic> for Fault {
    fn from(diagnostic: Diagnostic) -> Fault {
        Fault {
            diagnostic: Box::new(diagnostic),
            irrational: false,
            undecidable: false,
            reported: false,
            others: Vec::new(),
        }
    }
}
