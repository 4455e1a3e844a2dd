//! Judgements: what becomes of the claims of a model, and for what that holds.

use std::cmp::Ordering;

use hodograph_algebra::{Fraction, Poly, Variable, budget};

use super::expression::shortened;
use super::fault::Fault;
use super::generic;
use super::item::{Model, check_names};
use super::relation::{self, Finding};
use super::scope::Scope;
use crate::language::ast::{Claim, Expr, ExprKind, ItemKind, RelationOperator, Verdict};
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

impl Model {
    /// Checks one claim under a budget.
    ///
    /// # Errors
    /// A mistake in the claim. A claim that needs more than the budget is *undecided*, not a mistake.
    pub fn check(&self, claim: &Claim, limit: u64) -> Result<Judgement, Box<Diagnostic>> {
        self.judge(claim, limit, true)
    }

    /// Checks one claim as [`Model::check`] does, for the verdict alone: the condition leaves out the values of symbols at
    /// which what holds in general may fail. They can take more work than the verdict.
    ///
    /// # Errors
    /// As for [`Model::check`].
    pub fn check_verdict(&self, claim: &Claim, limit: u64) -> Result<Judgement, Box<Diagnostic>> {
        self.judge(claim, limit, false)
    }

    fn judge(&self, claim: &Claim, limit: u64, with_exceptions: bool) -> Result<Judgement, Box<Diagnostic>> {
        let outcome = budget::with_budget(limit, || {
            let conditioned = self.conditioned(claim)?;
            check_names_at_once(&conditioned.scope, &claim.relation)?;
            let finding = relation::settle(&conditioned.scope, &claim.relation)?;
            Ok::<_, Fault>((conditioned, finding))
        });
        let (conditioned, finding) = match outcome {
            Ok(Ok((conditioned, finding))) => (Some(conditioned), finding),
            // Something that exists but has no rational form here is no mistake of the claim.
            Ok(Err(fault)) if fault.undecidable => (None, Finding::undecided(fault.diagnostic.message)),
            Ok(Err(fault)) => return Err(fault.diagnostic),
            Err(exhausted) => (None, Finding::undecided(exhausted.to_string())),
        };
        let mut conditions: Vec<String> = claim.conditions.iter().map(ToString::to_string).collect();
        conditions.extend(self.speed_conditions(&claim.relation));
        if let (Some(conditioned), true) = (conditioned, with_exceptions)
            && finding.verdict != Verdict::Undecided
            && !conditioned.scope.symbols.is_empty()
        {
            conditions.extend(generic::conditions(
                &conditioned.scope,
                &claim.relation,
                finding.general,
                &conditioned.nonzero,
            ));
        }
        Ok(Judgement {
            id: claim.id.value.clone(),
            sweep: self.name.clone(),
            source: self.source.clone(),
            statement: claim.relation.to_string(),
            notes: claim.notes.iter().map(|note| note.value.clone()).collect(),
            verdict: finding.verdict,
            scope: self.scope_of(&finding),
            condition: (!conditions.is_empty()).then(|| conditions.join(" and ")),
            expected: claim.expected.as_ref().map_or(Verdict::Proved, |expected| expected.value),
            derived: finding.derived,
            witness: finding.witness.filter(|_| finding.verdict == Verdict::Refuted),
        })
    }

    /// The scope of a claim with its conditions put in: `when c0 == 1` sets a symbol, `when c0 != 0` is stated.
    fn conditioned(&self, claim: &Claim) -> Result<Conditioned, Fault> {
        let mut conditioned = Conditioned { scope: self.scope.clone(), nonzero: Vec::new() };
        for condition in &claim.conditions {
            conditioned = conditioned.with(condition)?;
        }
        Ok(conditioned)
    }

    /// What must be positive for the curves that a relation is about to have the parametric speed that was used.
    fn speed_conditions(&self, relation: &Expr) -> Vec<String> {
        let curves = self.curves();
        let mut names = Vec::new();
        identifiers(relation, &mut names);
        // Any other name that was defined may be about all of them.
        let direct = |name: &str| curves.iter().any(|(curve, _)| *curve == name) || self.scope.is_plain(name);
        let all = !names.iter().all(|name| direct(name));
        let concerned = curves.iter().filter(|(name, _)| all || names.contains(name));
        let conditions = concerned.filter_map(|(_, curve)| curve.speed_condition());
        conditions.map(|condition| format!("{} > 0", shortened(&condition.to_string()))).collect()
    }

    /// For what a finding holds, in words.
    fn scope_of(&self, finding: &Finding) -> String {
        let (mut functions, mut curves, mut symbols) = (Vec::new(), Vec::new(), Vec::new());
        let is_unknown = |variable: &&Variable| !self.scope.parameters.contains(variable);
        let mut unknowns: Vec<Variable> = finding.variables.iter().filter(is_unknown).cloned().collect();
        // Where all unknowns cancel, the finding is about each of them.
        if finding.variables.is_empty() && self.kind == ItemKind::Lemma {
            unknowns = self.scope.unknowns();
        }
        for variable in &unknowns {
            match self.scope.owner(variable) {
                Some((name, true)) => curves.push(name),
                Some((name, false)) => functions.push(name),
                None => symbols.push(variable.name()),
            }
        }
        let mut parts = Vec::new();
        let every = if finding.general { "a general" } else { "every" };
        let all = if finding.general { "general" } else { "all" };
        for (role, names) in [("functions ", &mut functions), ("", &mut symbols)] {
            names.sort_unstable();
            names.dedup();
            if !names.is_empty() {
                parts.push(format!("{all} {role}{}", names.join(", ")));
            }
        }
        curves.dedup();
        parts.extend(curves.iter().map(|curve| format!("{every} curve {curve}")));
        match (parts.is_empty(), self.kind) {
            (false, _) => parts.join(" and "),
            (true, ItemKind::Sweep) => format!("the sweep {}", self.name),
            (true, ItemKind::Lemma) => format!("the data of the lemma {}", self.name),
        }
    }
}

/// A scope with the conditions of a claim.
struct Conditioned {
    /// The scope, with the values that equations give to symbols.
    scope: Scope,
    /// Polynomials that do not vanish.
    nonzero: Vec<Poly>,
}

impl Conditioned {
    /// The same with one more condition.
    fn with(mut self, condition: &Expr) -> Result<Conditioned, Fault> {
        let wrong = |message: &str| {
            Fault::new(condition.span(), message)
                .help("write `when c0 == 1`, `when c0 != 0` or `when c0 > 0`")
        };
        let (inner, negated) = match condition.kind() {
            ExprKind::Not(inner) => (inner.as_ref(), true),
            _ => (condition, false),
        };
        let ExprKind::Relation { left, operator, right } = inner.kind() else {
            return Err(wrong("a condition is an equation or an inequality of symbols"));
        };
        let side = |expr: &Expr| self.scope.scalar(expr, "a side of a condition");
        let difference = (&side(left)? - &side(right)?).reduced();
        let foreign = |variable: &Variable| {
            self.scope.parameters.contains(variable) || self.scope.calculus.is_function(variable)
        };
        if difference.occurring_variables().iter().any(foreign) {
            return Err(wrong("a condition is about symbols, which do not depend on parameters"));
        }
        let holds = |operator: RelationOperator, sign: Ordering| match operator {
            RelationOperator::Equal => sign.is_eq(),
            RelationOperator::NotEqual => sign.is_ne(),
            RelationOperator::Less => sign.is_lt(),
            RelationOperator::LessEqual => sign.is_le(),
            RelationOperator::Greater => sign.is_gt(),
            RelationOperator::GreaterEqual => sign.is_ge(),
        };
        if let Some(number) = difference.to_number() {
            return match holds(*operator, number.sign()) != negated {
                true => Ok(self),
                false => Err(wrong("this condition never holds")),
            };
        }
        let allowed = |sign: Ordering| holds(*operator, sign) != negated;
        if !allowed(Ordering::Equal) {
            self.nonzero.push(difference.numerator().clone());
        } else if !allowed(Ordering::Less) && !allowed(Ordering::Greater) {
            let (symbol, value) = solved(&difference).ok_or_else(|| {
                wrong(
                    "this equation cannot be solved for a symbol: none stands in it linearly, times a number",
                )
            })?;
            self.scope = self.scope.with_symbol(&symbol, &value, condition.span())?;
        }
        Ok(self)
    }
}

/// A symbol in which an equation `f = 0` is linear, with a number as its coefficient, and its value. The last one is taken,
/// so that `c1 == 2*c0` sets c1.
fn solved(equation: &Fraction) -> Option<(Variable, Fraction)> {
    let numerator = equation.numerator();
    let linear = |symbol: &Variable| {
        numerator.degree(symbol) == Some(1) && numerator.coefficients(symbol)[1].is_constant()
    };
    let symbol = numerator.occurring_variables().into_iter().rev().find(linear)?;
    let coefficients = numerator.coefficients(&symbol);
    let value = -(&coefficients[0] * coefficients[1].inverse());
    Some((symbol, value.into()))
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
