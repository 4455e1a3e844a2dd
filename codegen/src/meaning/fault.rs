//! Why an expression has no value.

use hodograph_algebra::budget::Exhausted;
use hodograph_algebra::{CurveError, OffsetError, SpinError};

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

    /// π outside of angles: it is not algebraic.
    pub(super) fn pi(span: Span) -> Fault {
        let fault = Fault::new(span, "pi is not algebraic, so it can only stand in angles");
        fault.help("write `cos(pi/8)`, `sin(pi/8)` or `exp(I*pi/8)`")
    }

    /// A property that a curve does not have.
    pub(super) fn curve(span: Span, error: &CurveError) -> Fault {
        let help = match error {
            CurveError::IrrationalSpeed { .. } => {
                "only curves with a rational parametric speed, such as Pythagorean-hodograph curves (`ph`, \
                 `ph_hermite`), have a rational tangent and normal"
            }
            CurveError::SpeedChangesSign { .. } => "state a `domain` on which the curve has no such cusp",
            CurveError::Point => "give a curve whose points differ",
            CurveError::NotPlanar => {
                "give a curve that lies in a plane; a curve in space has no normal of its own"
            }
            CurveError::Line => "write the normal that is meant, a vector of length 1",
            CurveError::IrrationalPlane { .. } => {
                "choose symbols in which the plane's unit normal is rational"
            }
            CurveError::ArcLength { .. } => {
                "a parametric speed that is a polynomial, as that of `ph` curves, or the derivative of a rational \
                 function has a rational one"
            }
            CurveError::UnknownArcLength { .. } => {
                "`regular_curve` and `curve_from_hodograph` have a symbol for it"
            }
            CurveError::Pole { .. } => "state a `domain` without this pole",
            CurveError::Straight => "give a curve that bends",
            CurveError::NoRationalFrame { .. } => {
                "a quintic with the preimage A0, A1, A2 has one if A0*i*conj(A2) + A2*i*conj(A0) == 2*A1*i*conj(A1), as those of \
                 `rrmf` do; the Euler-Rodrigues frame `.frame` of a PH curve is always rational, but turns about the tangent"
            }
            CurveError::UnknownFrame => "write the functions out",
            CurveError::IrrationalFrenet { .. } => {
                "its spin `.frenet.spin` is rational all the same, and its values at points, `s.frenet.normal(1/2)`, are numbers"
            }
            CurveError::SymbolicFrenet { .. } => "set symbols by `when`, or give the curve numbers",
            CurveError::NoDomain => "state `domain`, with the interval of the curve's parameter",
            _ => "",
        };
        let mut fault = Fault::new(span, error.to_string());
        fault.irrational = matches!(
            error,
            CurveError::IrrationalSpeed { .. }
                | CurveError::SpeedChangesSign { .. }
                | CurveError::ArcLength { .. }
                | CurveError::NoRationalFrame { .. }
                | CurveError::IrrationalFrenet { .. }
        );
        fault.undecidable = matches!(
            error,
            CurveError::UnknownArcLength { .. }
                | CurveError::IrrationalPlane { .. }
                | CurveError::UnknownFrame
                | CurveError::SymbolicFrenet { .. }
        );
        if let CurveError::NoRationalFrame { error, .. } = error
            && **error == SpinError::Undecided
        {
            (fault.irrational, fault.undecidable) = (false, true);
        }
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
        let fault = Fault::new(span, error.to_string());
        fault.help("use smaller degrees, fewer symbols, or simpler numbers, or give the command a larger `--budget`").undecidable()
    }

    /// The same for something that exists, but cannot be decided here.
    #[must_use]
    pub(super) fn undecidable(mut self) -> Fault {
        self.undecidable = true;
        self
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
