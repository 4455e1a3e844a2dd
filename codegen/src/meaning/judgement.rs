//! Judgements: what becomes of the claims of a model, and for what that holds.

use std::collections::BTreeSet;
use std::rc::Rc;

use hodograph_algebra::{BoxSign, Interval, SweptSurface, Variable, budget};

use super::assumptions::Assumptions;
use super::expression::shortened;
use super::fault::Fault;
use super::finding::Finding;
use super::generality;
use super::generic;
use super::item::{Model, check_names};
use super::pieces;
use super::relation;
use super::scope::Scope;
use super::surfaces;
use crate::language::ast::{Claim, ClauseKind, Expr, ExprKind, Severity, Verdict};
use crate::language::{Diagnostic, Diagnostics};

/// What became of one claim.
///
/// # Example
/// ```
/// use hodograph_algebra::budget::DEFAULT_LIMIT;
/// use hodograph_codegen::language::{ast::Verdict, parse_text};
/// use hodograph_codegen::meaning::models;
///
/// let text = "lemma square { domain u in 0..1; claim \"strict\": u^2 < u, \"both ends\", expect refuted; }";
/// let (file, _source) = parse_text("square.sweep", text).unwrap();
/// let model = &models(&file).0[0];
/// let judgement = model.check(&model.claims[0], DEFAULT_LIMIT).unwrap();
/// assert_eq!((judgement.id.as_str(), judgement.statement.as_str()), ("strict", "u^2 < u"));
/// assert_eq!((judgement.verdict, judgement.expected), (Verdict::Refuted, Verdict::Refuted));
/// assert_eq!(judgement.witness.as_deref(), Some("u = 0"));
/// assert_eq!(judgement.notes, ["both ends"]);
/// // A claim that does not fit in the budget is neither proved nor refuted.
/// assert_eq!(model.check(&model.claims[0], 1).unwrap().verdict, Verdict::Undecided);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Judgement {
    /// The claim's id.
    pub id: String,
    /// The sweep or lemma that it stands in.
    pub sweep: String,
    /// What the item gives as its source.
    pub source: Option<String>,
    /// The claim as the language writes it.
    pub statement: String,
    /// The notes of the claim.
    pub notes: Vec<String>,
    /// What it says in place of refuted claims with the same id, if it does.
    pub instead: Option<String>,
    /// What a mistake in it means for whoever uses it, and how grave that is.
    pub effect: Option<(Severity, String)>,
    /// The verdict.
    pub verdict: Verdict,
    /// For what the verdict holds.
    pub scope: String,
    /// Under which conditions, as relations of the language: those of the claim, the signs that parametric speeds are taken
    /// to have, and for what holds in general, such as a degree, the values of symbols at which it may fail.
    pub condition: Option<String>,
    /// The verdict that the source expects.
    pub expected: Verdict,
    /// What was derived.
    pub derived: String,
    /// Where the claim fails.
    pub witness: Option<String>,
}

/// A judgement with all that it was made from.
pub(super) struct Judged {
    pub judgement: Judgement,
    pub finding: Finding,
    pub assumptions: Assumptions,
    /// The conditions, each with where it comes from.
    pub conditions: Vec<(Origin, String)>,
}

/// Where a condition of a judgement comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Origin {
    /// The claim states it.
    Claim,
    /// A polynomial of the symbols has a real square root.
    Radical,
    /// The root that is taken for a parametric speed is positive.
    Speed,
    /// The unit normal is on the side that was taken.
    Side,
    /// No leading coefficient vanishes, and no new common factor appears.
    General,
}

impl Model {
    /// Checks one claim under a budget.
    ///
    /// # Errors
    /// A mistake in the claim. A claim that needs more than the budget is *undecided*, not a mistake.
    pub fn check(&self, claim: &Claim, limit: u64) -> Result<Judgement, Box<Diagnostic>> {
        Ok(self.judge(claim, limit, true)?.judgement)
    }

    /// Checks one claim as [`Model::check`] does, for the verdict alone: the condition leaves out the values of symbols at
    /// which what holds in general may fail. They can take more work than the verdict.
    ///
    /// # Errors
    /// As for [`Model::check`].
    pub fn check_verdict(&self, claim: &Claim, limit: u64) -> Result<Judgement, Box<Diagnostic>> {
        Ok(self.judge(claim, limit, false)?.judgement)
    }

    /// Checks one claim; `with_exceptions` asks for the values of symbols at which what holds in general may fail.
    pub(super) fn judge(
        &self,
        claim: &Claim,
        limit: u64,
        with_exceptions: bool,
    ) -> Result<Judged, Box<Diagnostic>> {
        let outcome = budget::with_budget(limit, || {
            let assumptions = Assumptions::of(&self.scope, &claim.conditions)?;
            check_names_at_once(&assumptions.scope, &claim.relation)?;
            let findings = if assumptions.scope.siblings.is_empty() {
                vec![relation::settle(&assumptions, &claim.relation)?]
            } else {
                let settle = |scope: Scope| relation::settle(&assumptions.with_scope(scope), &claim.relation);
                assumptions.scope.pieces().into_iter().map(settle).collect::<Result<Vec<_>, Fault>>()?
            };
            let finding = pieces::merged(&claim.relation, assumptions.scope.joints.as_ref(), findings);
            Ok::<_, Fault>((assumptions, finding))
        });
        let (assumptions, finding) = match outcome {
            Ok(Ok((assumptions, finding))) => (Some(assumptions), finding),
            // Something that exists but has no rational form here is no mistake of the claim.
            Ok(Err(fault)) if fault.undecidable => (None, Finding::undecided(fault.diagnostic.message)),
            Ok(Err(fault)) => return Err(fault.diagnostic),
            Err(exhausted) => (None, Finding::undecided(exhausted.to_string())),
        };
        let mut conditions: Vec<(Origin, String)> = Vec::new();
        let mut add = |origin: Origin, more: Vec<String>| {
            conditions.extend(more.into_iter().map(|condition| (origin, condition)));
        };
        add(Origin::Claim, claim.conditions.iter().map(ToString::to_string).collect());
        add(Origin::Radical, finding.conditions.clone());
        let scope = assumptions.as_ref().map_or(&self.scope, |assumptions| &assumptions.scope);
        add(Origin::Speed, self.speed_conditions(scope, &claim.relation));
        if with_exceptions {
            add(Origin::Side, side_conditions(scope, &claim.relation));
        }
        if let (Some(assumptions), true) = (&assumptions, with_exceptions)
            && finding.verdict != Verdict::Undecided
            && !assumptions.scope.symbols.is_empty()
        {
            let nonzero = assumptions.nonzero();
            let exceptions =
                generic::conditions(&assumptions.scope, &claim.relation, finding.general, &nonzero);
            add(Origin::General, exceptions);
        }
        let mut stated = BTreeSet::new();
        conditions.retain(|(_, condition)| stated.insert(condition.clone()));
        let texts: Vec<&str> = conditions.iter().map(|(_, condition)| condition.as_str()).collect();
        let judgement = Judgement {
            id: claim.id.value.clone(),
            sweep: self.item_name().to_owned(),
            source: self.source.clone(),
            statement: claim.relation.to_string(),
            notes: claim.notes.iter().map(|note| note.value.clone()).collect(),
            instead: claim.instead.as_ref().map(|text| text.value.clone()),
            effect: claim.effect.as_ref().map(|effect| (effect.severity.value, effect.text.value.clone())),
            verdict: finding.verdict,
            scope: generality::of(self, scope, &claim.relation, &finding),
            condition: (!texts.is_empty()).then(|| texts.join(" and ")),
            expected: claim.expected.as_ref().map_or(Verdict::Proved, |expected| expected.value),
            derived: finding.derived.clone(),
            witness: finding.witness.clone().filter(|_| finding.verdict == Verdict::Refuted),
        };
        let assumptions = assumptions.unwrap_or_else(|| Assumptions::none(&self.scope));
        Ok(Judged { judgement, finding, assumptions, conditions })
    }

    /// What must be positive for the curves that a relation is about to have the parametric speed that was used.
    fn speed_conditions(&self, scope: &Scope, relation: &Expr) -> Vec<String> {
        let mut curves = scope.curves();
        curves.sort_by_key(|(name, _)| (Some(*name) != self.path.as_deref(), *name));
        let mut names = Vec::new();
        identifiers(relation, &mut names);
        // Any other name that was defined may be about all of them.
        let direct = |name: &str| curves.iter().any(|(curve, _)| *curve == name) || self.scope.is_plain(name);
        let all = !names.iter().all(|name| direct(name));
        let concerned = curves.iter().filter(|(name, _)| all || names.contains(name));
        let conditions = concerned.filter_map(|(_, curve)| curve.speed_condition());
        conditions.map(|condition| format!("{} > 0", shortened(&condition.to_string()))).collect()
    }
}

/// What must be positive for the unit normals of surfaces to be on the sides that were taken, if values of symbols decide on
/// that and the relation is about sides.
fn side_conditions(scope: &Scope, relation: &Expr) -> Vec<String> {
    let mut surfaces = Vec::new();
    collect_sided(scope, relation, 64, &mut surfaces);
    surfaces.retain(|surface| !surface.symbols().is_empty());
    let condition = |surface: &Rc<SweptSurface>| {
        let region: Vec<(Variable, Interval)> =
            surface.parameters().iter().cloned().zip(surface.domain().iter().cloned()).collect();
        let decide = || {
            let orientation = surface.normal().ok()?.orientation();
            let symbolic =
                orientation.occurring_variables().iter().any(|variable| scope.symbols.contains(variable));
            let certain = !symbolic || matches!(orientation.sign_on(&region), Some(BoxSign::Positive));
            (!certain).then(|| format!("{} > 0", shortened(&orientation.to_string())))
        };
        budget::with_budget(budget::DEFAULT_LIMIT, decide).ok().flatten()
    };
    surfaces.iter().filter_map(condition).collect()
}

/// The surfaces of which an expression contains a normal, or an offset or a form as the side of the normal decides on it, also by the name of a
/// definition.
fn collect_sided(scope: &Scope, expr: &Expr, depth: usize, surfaces: &mut Vec<Rc<SweptSurface>>) {
    let Some(depth) = depth.checked_sub(1) else { return };
    let mut name = None;
    match expr.kind() {
        ExprKind::Call { callee, .. } => {
            if let ExprKind::Ident(name) = callee.kind() {
                match name.as_str() {
                    "normal" | "offset" => surfaces.extend(scope.surface.clone()),
                    // These do not depend on the side.
                    "degree" | "is_pn" | "is_rational" | "parallel" | "similarity_offset" => return,
                    _ => {}
                }
            }
        }
        ExprKind::Member { object, member } if surfaces::is_sided(&member.value) => {
            let evaluated = budget::with_budget(budget::DEFAULT_LIMIT, || surfaces::surface(scope, object));
            surfaces.extend(evaluated.ok().and_then(Result::ok));
        }
        ExprKind::Ident(known) => name = Some(known),
        _ => {}
    }
    let clauses = scope.item.iter().flat_map(|item| &item.clauses);
    for clause in clauses {
        if let ClauseKind::Let(definition) = &clause.kind
            && Some(&definition.name.value) == name
        {
            collect_sided(scope, &definition.value, depth, surfaces);
        }
    }
    expr.children().for_each(|child| collect_sided(scope, child, depth, surfaces));
}

/// The names in an expression.
fn identifiers<'a>(expr: &'a Expr, names: &mut Vec<&'a str>) {
    if let ExprKind::Ident(name) = expr.kind() {
        names.push(name);
    }
    expr.children().for_each(|child| identifiers(child, names));
}

fn check_names_at_once(scope: &Scope, expr: &Expr) -> Result<(), Fault> {
    let mut diagnostics = Diagnostics::new();
    check_names(scope, expr, &mut diagnostics);
    match diagnostics.iter().next() {
        Some(diagnostic) => Err(diagnostic.clone().into()),
        None => Ok(()),
    }
}
