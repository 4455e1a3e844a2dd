//! Items in several pieces: frames cut the interval of their parameter at their knots, and all clauses are evaluated once for
//! each segment.

use std::collections::BTreeMap;
use std::rc::Rc;

use hodograph_algebra::{Fraction, Interval, Poly, Variable};

use super::calls::Call;
use super::fault::Fault;
use super::finding::Finding;
use super::scope::Scope;
use super::value::Value;
use crate::language::Span;
use crate::language::ast::{Expr, ExprKind, RelationOperator, Verdict};

/// Up to which order `continuity` compares derivatives.
const MOST_DERIVATIVES: i64 = 9;

/// A piece of an item in several pieces.
///
/// # Example
/// ```
/// use hodograph_codegen::{language::parse_text, meaning::models};
///
/// let text = "sweep turn {
///     profile c(u) = (u, 0, 0);
///     frames F(v) = frames([frame((0, 0, 0), (0, 0, 0, 1)), frame((0, 0, 1), (3/5, 0, 0, 4/5)), frame((0, 0, 3), (4/5, 0, 0, 3/5))]);
///     surface R = F.sweep(c);
///     domain u in 0..1;
/// }";
/// let (models, _mistakes) = models(&parse_text("turn.sweep", text).unwrap().0);
/// let names: Vec<&str> = models.iter().map(|model| model.name.as_str()).collect();
/// assert_eq!(names, ["turn_1", "turn_2"]);
/// let piece = models[1].piece.as_ref().unwrap();
/// assert_eq!((piece.of.as_str(), piece.index, piece.count), ("turn", 1, 2));
/// let [_, v] = models[1].surface.as_ref().unwrap().domain();
/// assert_eq!(v.to_string(), "[1, 2]");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Piece {
    /// The name of the item.
    pub of: String,
    /// Which of its pieces it is, from 0 in the order of the parameter.
    pub index: usize,
    /// How many pieces there are, two at least.
    pub count: usize,
}

/// Where the pieces of an item meet: the knots of its frames.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Joints {
    /// The parameter of the frames.
    pub(super) parameter: Variable,
    /// The knots, in increasing order; two at least.
    pub(super) knots: Rc<[Poly]>,
}

impl Joints {
    /// The number of pieces.
    pub(super) fn count(&self) -> usize {
        self.knots.len() - 1
    }

    /// The interval of a piece.
    pub(super) fn interval(&self, index: usize) -> Option<Interval> {
        Interval::new(self.knots.get(index)?.clone(), self.knots.get(index + 1)?.clone())
    }

    /// The interval of all pieces together.
    pub(super) fn whole(&self) -> Option<Interval> {
        Interval::new(self.knots.first()?.clone(), self.knots.last()?.clone())
    }
}

impl Scope {
    /// The interval of a parameter, over all pieces.
    pub(super) fn whole_domain(&self, parameter: &Variable) -> Option<Interval> {
        match &self.joints {
            Some(joints) if joints.parameter == *parameter => joints.whole(),
            _ => self.domains.get(parameter).cloned(),
        }
    }

    /// The scopes of all pieces, of which each knows the others; the scope itself if there is one piece only.
    pub(super) fn pieces(&self) -> Vec<Scope> {
        if self.siblings.is_empty() {
            return vec![self.clone()];
        }
        self.siblings.iter().map(|sibling| self.knowing(sibling.clone())).collect()
    }

    /// A sibling that knows all others.
    fn knowing(&self, mut sibling: Scope) -> Scope {
        sibling.siblings = self.siblings.clone();
        sibling
    }
}

/// Which other piece the values of parameters belong to, if they do not belong to the one that is evaluated.
pub(super) fn other_piece(
    scope: &Scope,
    span: Span,
    values: &BTreeMap<Variable, Fraction>,
) -> Result<Option<usize>, Fault> {
    let Some(joints) = scope.joints.as_ref().filter(|joints| joints.count() > 1) else { return Ok(None) };
    let parameter = &joints.parameter;
    let Some(value) = values.get(parameter) else { return Ok(None) };
    if *value == Fraction::from(Poly::variable(parameter)) {
        return Ok(None);
    }
    let Some(number) = value.to_number() else {
        let message = format!("`{parameter}` runs through several pieces here, so it takes numbers only");
        return Err(Fault::new(span, message));
    };
    let holds = |index: usize| joints.interval(index).is_some_and(|interval| interval.contains(&number));
    if holds(scope.segment) {
        return Ok(None);
    }
    let Some(index) = (0..joints.count()).find(|&index| holds(index)) else {
        let message = format!("{parameter} = {number} lies beyond the frames");
        let whole = joints.whole().map(|whole| format!("they run through {whole}"));
        return Err(Fault::new(span, message).help(whole.unwrap_or_default()));
    };
    if scope.siblings.is_empty() {
        let message =
            format!("{parameter} = {number} lies in another piece than the one that this clause defines");
        return Err(Fault::new(span, message).help("only claims can look at all pieces"));
    }
    Ok(Some(index))
}

/// Evaluates in another piece.
pub(super) fn in_piece<T>(scope: &Scope, index: usize, work: impl FnOnce(&Scope) -> T) -> Option<T> {
    let sibling = scope.siblings.get(index)?.clone();
    Some(work(&scope.knowing(sibling)))
}

/// `continuity(f)`: the largest n ≤ 9 for which all derivatives up to the n-th one by the frames' parameter agree at all joints; −1
/// if the values themselves do not.
pub(super) fn continuity(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let [expr] = call.positional()?;
    let Some(joints) = scope.joints.clone().filter(|joints| joints.count() > 1) else {
        let fault =
            Fault::new(call.span, "there are no joints here, at which a function could be continuous");
        return Err(fault.help("three frames at least make an item of several pieces"));
    };
    if scope.siblings.is_empty() {
        return Err(Fault::new(call.span, "`continuity` looks at all pieces, so it stands in claims only"));
    }
    let found =
        scope.continuities.borrow().iter().find(|(span, _)| *span == expr.span()).map(|(_, order)| *order);
    if let Some(order) = found {
        return Ok(Value::Scalar(hodograph_algebra::integer(order).into()));
    }
    let mut order = MOST_DERIVATIVES;
    let pieces = values(scope, expr)?;
    for (pair, knot) in pieces.windows(2).zip(&joints.knots[1..]) {
        order = order.min(agreement(scope, expr.span(), &joints.parameter, knot, pair, order)?.order);
    }
    scope.continuities.borrow_mut().push((expr.span(), order));
    Ok(Value::Scalar(hodograph_algebra::integer(order).into()))
}

/// The components of an expression on each piece.
fn values(scope: &Scope, expr: &Expr) -> Result<Vec<Vec<Fraction>>, Fault> {
    let components = |piece: Scope| {
        let value = piece.rational_value(expr)?;
        let parts = match value.bare() {
            Value::Quaternion(quaternion) => Some(quaternion.components().to_vec()),
            _ => value.complex().map(|z| vec![z.re, z.im]).or_else(|| value.components()),
        };
        parts.ok_or_else(|| {
            Fault::new(expr.span(), format!("a function is expected here, but this is {}", value.kind()))
        })
    };
    scope.pieces().into_iter().map(components).collect()
}

/// How two pieces of a function meet.
pub(super) struct Joint {
    /// The value of the parameter.
    pub(super) knot: Poly,
    /// Up to which order the derivatives agree; −1 if the values do not.
    pub(super) order: i64,
    /// The first derivatives that do not agree, those from the right without those from the left; nothing if none were found.
    pub(super) difference: Option<Vec<Fraction>>,
}

/// How an expression that `continuity` takes meets at each joint, with the parameter of the frames.
pub(super) fn joints(scope: &Scope, expr: &Expr) -> Result<Option<(Variable, Vec<Joint>)>, Fault> {
    let Some(joints) = scope.joints.clone() else { return Ok(None) };
    let pieces = values(scope, expr)?;
    let meeting = pieces
        .windows(2)
        .zip(&joints.knots[1..])
        .map(|(pair, knot)| agreement(scope, expr.span(), &joints.parameter, knot, pair, MOST_DERIVATIVES));
    Ok(Some((joints.parameter.clone(), meeting.collect::<Result<_, Fault>>()?)))
}

/// The largest order up to `most` to which the components of two neighbouring pieces agree at a knot.
fn agreement(
    scope: &Scope,
    span: Span,
    parameter: &Variable,
    knot: &Poly,
    pair: &[Vec<Fraction>],
    most: i64,
) -> Result<Joint, Fault> {
    let at = BTreeMap::from([(parameter.clone(), Fraction::from(knot.clone()))]);
    let value = |f: &Fraction| {
        f.substitute(&at)
            .or_else(|| f.lowest_terms().substitute(&at))
            .ok_or_else(|| Fault::new(span, format!("this has a pole at the joint {parameter} = {knot}")))
    };
    let joint = |order, difference| Joint { knot: knot.clone(), order, difference };
    let [left, right] = pair else { return Ok(joint(most, None)) };
    let (mut left, mut right) = (left.clone(), right.clone());
    for order in 0..=most {
        let differences = left.iter().zip(&right).map(|(left, right)| Ok(&value(right)? - &value(left)?));
        let differences = differences.collect::<Result<Vec<Fraction>, Fault>>()?;
        if !differences.iter().all(Fraction::is_zero) {
            return Ok(joint(order - 1, Some(differences)));
        }
        if order < most {
            for part in left.iter_mut().chain(&mut right) {
                *part = scope.calculus.derivative(part, parameter);
            }
        }
    }
    Ok(joint(most, None))
}

/// The finding on all pieces from those on each: a relation holds if it holds on all of them, a negated one if it holds on any.
pub(super) fn merged(relation: &Expr, joints: Option<&Joints>, mut findings: Vec<Finding>) -> Finding {
    if findings.len() == 1
        && let Some(only) = findings.pop()
    {
        return only;
    }
    let decisive = if is_negated(relation) { Verdict::Proved } else { Verdict::Refuted };
    let found = findings.iter().position(|finding| finding.verdict == decisive);
    let undecided = findings.iter().position(|finding| finding.verdict == Verdict::Undecided);
    let name = |index: usize| {
        let interval = joints.and_then(|joints| Some((&joints.parameter, joints.interval(index)?)));
        match interval {
            Some((parameter, interval)) => {
                format!("piece {} ({parameter} in {}..{})", index + 1, interval.lower(), interval.upper())
            }
            None => format!("piece {}", index + 1),
        }
    };
    let variables: Vec<Variable> = findings.iter().flat_map(|finding| finding.variables.clone()).collect();
    let conditions: Vec<String> = findings.iter().flat_map(|finding| finding.conditions.clone()).collect();
    let same = findings.windows(2).all(|pair| pair[0].derived == pair[1].derived);
    let Some(index) = found.or(undecided).or((!findings.is_empty()).then_some(0)) else {
        return Finding::undecided("there are no pieces");
    };
    let together = |findings: &[Finding]| {
        let parts = findings.iter().enumerate();
        let parts = parts.map(|(index, finding)| format!("{}: {}", name(index), finding.derived));
        parts.collect::<Vec<_>>().join("; ")
    };
    let derived = if same {
        findings[index].derived.clone()
    } else if found.or(undecided).is_some() {
        format!("{}: {}", name(index), findings[index].derived)
    } else {
        together(&findings)
    };
    let general = findings.iter().any(|finding| finding.general);
    let piece = Some((index, name(index)));
    let mut merged = Finding { derived, general, conditions, piece, ..findings.swap_remove(index) };
    if let Some(witness) = &mut merged.witness {
        *witness = format!("{}, {witness}", name(index));
    }
    merged.about_variables(variables)
}

/// Whether a relation is the negation of another one.
fn is_negated(relation: &Expr) -> bool {
    match relation.kind() {
        ExprKind::Not(inner) => !is_negated(inner),
        ExprKind::Relation { operator, .. } => *operator == RelationOperator::NotEqual,
        _ => false,
    }
}
