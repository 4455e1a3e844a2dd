//! What is found of a relation: a verdict with what supports it.

use hodograph_algebra::{BoxSign, Fraction, Interval, Point, Poly, QuadraticFraction, Variable};

use super::value::DegreeValue;
use crate::language::ast::Verdict;

/// A verdict with what supports it.
#[derive(Clone, Debug)]
pub(super) struct Finding {
    /// The verdict.
    pub verdict: Verdict,
    /// The value that was derived, in place of which the claim has its own.
    pub derived: String,
    /// Where the claim fails.
    pub witness: Option<String>,
    /// What must hold of the symbols besides what the claim assumes, as relations of the language.
    pub conditions: Vec<String>,
    /// The variables that the sides depend on.
    pub variables: Vec<Variable>,
    /// Whether the finding is about unknowns in general, and may differ for special values of them.
    pub general: bool,
    /// The piece that decides, of an item in several pieces: its index, and how it is called.
    pub piece: Option<(usize, String)>,
    /// What was compared.
    pub evidence: Evidence,
}

impl Finding {
    pub(super) fn new(holds: bool, derived: impl Into<String>) -> Finding {
        let verdict = if holds { Verdict::Proved } else { Verdict::Refuted };
        // What holds identically holds for all values; what fails somewhere may hold elsewhere.
        Finding {
            verdict,
            derived: derived.into(),
            witness: None,
            conditions: Vec::new(),
            variables: Vec::new(),
            general: !holds,
            piece: None,
            evidence: Evidence::None,
        }
    }

    pub(super) fn undecided(derived: impl Into<String>) -> Finding {
        Finding { verdict: Verdict::Undecided, general: false, ..Finding::new(false, derived) }
    }

    /// The finding on the opposite relation.
    pub(super) fn negated(self) -> Finding {
        let verdict = match self.verdict {
            Verdict::Proved => Verdict::Refuted,
            Verdict::Refuted => Verdict::Proved,
            Verdict::Undecided => Verdict::Undecided,
        };
        Finding { verdict, ..self }
    }

    pub(super) fn in_general(self, general: bool) -> Finding {
        Finding { general, ..self }
    }

    pub(super) fn is_refuted_at_a_point(&self) -> bool {
        self.verdict == Verdict::Refuted && self.witness.is_some()
    }

    pub(super) fn with_witness(mut self, witness: Option<String>) -> Finding {
        self.witness = witness;
        self
    }

    pub(super) fn with_evidence(self, evidence: Evidence) -> Finding {
        Finding { evidence, ..self }
    }

    pub(super) fn about<'a>(self, values: impl IntoIterator<Item = &'a Fraction>) -> Finding {
        self.about_variables(values.into_iter().flat_map(Fraction::occurring_variables))
    }

    pub(super) fn about_variables(mut self, variables: impl IntoIterator<Item = Variable>) -> Finding {
        self.variables.extend(variables);
        self.variables.sort();
        self.variables.dedup();
        self
    }
}

/// The exact values from which a verdict follows.
#[derive(Clone, Debug)]
pub(super) enum Evidence {
    /// Nothing but what was derived.
    None,
    /// The components of both sides of an equation.
    Sides {
        /// Those of the left side.
        left: Vec<Fraction>,
        /// As many of the right side.
        right: Vec<Fraction>,
    },
    /// The components of both sides of an equation with square roots.
    RootedSides {
        /// Those of the left side.
        left: Vec<QuadraticFraction>,
        /// As many of the right side.
        right: Vec<QuadraticFraction>,
    },
    /// The components of two vectors that are parallel or not.
    Directions {
        /// Those of the left side.
        left: Vec<Fraction>,
        /// As many of the right side.
        right: Vec<Fraction>,
    },
    /// Degrees that were derived, and those that are stated.
    Degrees {
        /// The polynomials with their degrees.
        derived: DegreeValue,
        /// As many degrees.
        stated: Vec<i64>,
    },
    /// A function that is to be positive, or not negative.
    Sign {
        /// The function, in lowest terms.
        function: Fraction,
        /// A polynomial with the same sign wherever the denominator is not zero.
        polynomial: Poly,
        /// The box of parameters.
        domain: Vec<(Variable, Interval)>,
        /// What is known of the sign on it.
        sign: BoxSign,
        /// A point at which the function is not what it is to be.
        at: Option<Point>,
    },
    /// Polynomials that are to have no common factor.
    CommonFactor {
        /// The polynomials.
        polynomials: Vec<Poly>,
        /// Their greatest common divisor.
        common: Poly,
    },
    /// A number beside a decimal.
    Decimal {
        /// The number.
        number: Poly,
        /// What the decimal is.
        stated: Poly,
        /// The unit of its last digit.
        unit: Poly,
        /// How many digits after the point are of interest.
        places: u32,
    },
    /// That something is rational, or is not: see the expression.
    Rationality,
}
