//! Derivations: how the verdict on a claim comes about, step by step.

mod definitions;
mod frames;
mod reasons;
mod show;
mod signs;

use std::collections::BTreeSet;

use hodograph_algebra::{budget, budget::Exhausted};

use self::show::Show;
use super::item::Model;
use super::judgement::{Judged, Judgement, Origin};
use crate::language::Diagnostic;
use crate::language::ast::{Claim, Verdict};

/// How many steps the parts of a claim may take; what rests on more is not read by anybody.
const MOST_STEPS: usize = 120;

/// The length of a formula, in characters, beyond which [`Model::explain`] cuts it between its terms, and says how many there
/// are, unless it is asked for everything.
const LONGEST: usize = 240;

/// A step of a derivation, computed when the claim was judged or from what was compared then.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Step {
    /// What the step is, in a word or two; see [`Explanation::steps`].
    pub what: &'static str,
    /// What was derived, in the language of the formulas.
    pub formula: String,
    /// Where it comes from, or what follows; often nothing.
    pub because: String,
}

/// A judgement with its derivation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Explanation {
    /// The judgement.
    pub judgement: Judgement,
    /// The steps, in the order in which each rests on those before it:
    ///
    /// | [`Step::what`] | what it is |
    /// | --- | --- |
    /// | `piece` | of an item in several pieces, the one that the other steps are about |
    /// | `definition` | a clause of the item on which the claim rests |
    /// | `value` | what a name, a member or a call in it is |
    /// | `claim` | the relation |
    /// | `left side`, `right side` | what the sides of the relation are |
    /// | `difference` | the left side without the right one, in lowest terms |
    /// | `factor`, `minor` | of two vectors: the one as a multiple of the other, or a minor that is not zero |
    /// | `coefficient`, `degree` | the leading coefficients of polynomials, and their degrees |
    /// | `function`, `factor`, `root`, `certificate`, `sign` | of an inequality: what is to be positive, and why it is or is not |
    /// | `at a point` | the sides of an inequality at a point at which it fails |
    /// | `square` | `|N|²` or a radicand as a square times a squarefree rest |
    /// | `preimage`, `spin`, `rotation`, `residues` | of a rotation-minimizing frame: how the Euler–Rodrigues frame turns, and what turns it back, or why nothing does |
    /// | `joint` | how the pieces of a function meet |
    /// | `polynomial`, `common factor`, `certificate` | of a claim of coprimality |
    /// | `number`, `decimal` | a number with an enclosure, and the decimal that it is compared with |
    /// | `negation` | what `not` makes of it |
    /// | `where` | what a radical stands for |
    /// | `condition` | what must hold of the symbols, and why |
    /// | `witness` | a point at which the claim fails, with both sides |
    /// | `verdict` | the verdict, and for what it holds |
    pub steps: Vec<Step>,
}

impl Model {
    /// Checks one claim as [`Model::check`] does, and shows how. With `full`, formulas of any length are written out.
    ///
    /// Each part of a formula may take some more of the budget; what it does not suffice for is not written out.
    ///
    /// # Errors
    /// As for [`Model::check`].
    ///
    /// # Example
    /// ```
    /// use hodograph_algebra::budget::DEFAULT_LIMIT;
    /// use hodograph_codegen::{language::parse_text, meaning::models};
    ///
    /// let text = "lemma frame {
    ///     function sigma(v), kappa(v);
    ///     curve s(v) = regular_curve(sigma, kappa);
    ///     let d(v) = diff(s.normal, v);
    ///     claim \"(4)\": d == kappa*s.tangent, expect refuted;
    /// }";
    /// let (models, _mistakes) = models(&parse_text("frame.sweep", text).unwrap().0);
    /// let explanation = models[0].explain(&models[0].claims[0], DEFAULT_LIMIT, false).unwrap();
    /// let steps: Vec<String> =
    ///     explanation.steps.iter().map(|step| format!("{}: {}", step.what, step.formula)).collect();
    /// assert!(steps.contains(&"definition: let d(v) = diff(s.normal, v)".to_owned()));
    /// assert!(steps.contains(&"value: d = kappa*sigma*s.tangent".to_owned()));
    /// assert!(steps.contains(&"difference: kappa*(sigma - 1)*s.tangent".to_owned()));
    /// ```
    pub fn explain(&self, claim: &Claim, limit: u64, full: bool) -> Result<Explanation, Box<Diagnostic>> {
        let judged = self.judge(claim, limit, true)?;
        let steps = {
            let mut steps = Steps { steps: Vec::new(), left: limit };
            let scope = &judged.assumptions.scope;
            let decisive = judged.finding.piece.as_ref().and_then(|(index, name)| {
                steps.push("piece", name, "the relation was settled on each piece; this one decides");
                scope.pieces().into_iter().nth(*index)
            });
            let show = Show::new(decisive.as_ref().unwrap_or(scope), if full { usize::MAX } else { LONGEST });
            definitions::explain(&show, &mut steps, claim);
            reasons::explain(&show, &mut steps, claim, &judged);
            for relation in named(show.radicals(), &steps.steps) {
                steps.push("where", relation, "");
            }
            conclude(&mut steps, &judged);
            steps.steps
        };
        Ok(Explanation { judgement: judged.judgement, steps })
    }
}

/// The relations of those radicals that occur in steps, or in such relations.
fn named(radicals: Vec<(String, String)>, steps: &[Step]) -> Vec<String> {
    let words = |text: &str| -> Vec<String> {
        text.split(|c: char| !c.is_alphanumeric() && c != '_').map(str::to_owned).collect()
    };
    let mut occurring: BTreeSet<String> = steps.iter().flat_map(|step| words(&step.formula)).collect();
    let mut relations = Vec::new();
    // Later radicals are made of earlier ones.
    for (name, relation) in radicals.into_iter().rev() {
        if occurring.contains(&name) {
            occurring.extend(words(&relation));
            relations.push(relation);
        }
    }
    relations.reverse();
    relations
}

/// Conditions, witness and verdict.
fn conclude(steps: &mut Steps, judged: &Judged) {
    let Judged { judgement, conditions, .. } = judged;
    for (origin, condition) in conditions {
        let because = match origin {
            Origin::Claim => "stated with the claim",
            Origin::Radical => "so that the square root is real",
            Origin::Speed => "so that the root that is taken for the parametric speed is not negative",
            Origin::Side => "this decides to which side the unit normal points",
            Origin::General => "elsewhere a leading coefficient vanishes, or a new common factor appears",
        };
        steps.push("condition", condition, because);
    }
    if let Some(witness) = &judgement.witness {
        steps.push("witness", witness, "the claim fails here");
    }
    let scope = match judgement.verdict {
        Verdict::Undecided => judgement.derived.clone(),
        _ => format!("for {}", judgement.scope),
    };
    steps.push("verdict", judgement.verdict.to_string(), scope);
}

/// Steps that are being collected.
struct Steps {
    steps: Vec<Step>,
    /// The units of work that are left for their formulas.
    left: u64,
}

impl Steps {
    fn push(&mut self, what: &'static str, formula: impl Into<String>, because: impl Into<String>) {
        self.steps.push(Step { what, formula: formula.into(), because: because.into() });
    }

    /// The result of `work` within what is left of the budget.
    fn within<T>(&mut self, work: impl FnOnce() -> T) -> Result<T, Exhausted> {
        let left = self.left;
        let (result, spent) = budget::measured(|| budget::with_budget(left, work));
        self.left = left.saturating_sub(spent);
        result
    }

    /// Whether there are as many steps as anybody reads.
    fn is_full(&self) -> bool {
        self.steps.len() >= MOST_STEPS
    }
}
