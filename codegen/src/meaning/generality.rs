//! For what a verdict holds, in words: every PH quintic, all functions, or one example.

use std::collections::BTreeSet;

use hodograph_algebra::Variable;

use super::finding::{Evidence, Finding};
use super::generic;
use super::group::{CoefficientGroup, CoefficientKind};
use super::item::Model;
use super::scope::Scope;
use crate::language::ast::{ClauseKind, Expr, ExprKind, Item, ItemKind};

/// For what a finding on a relation holds: the unknowns in the sides and in all names of the relation, also those that cancel.
pub(super) fn of(model: &Model, scope: &Scope, relation: &Expr, finding: &Finding) -> String {
    let mut unknowns: BTreeSet<Variable> = generic::unknowns(scope, relation);
    let is_unknown = |variable: &&Variable| !scope.parameters.contains(variable);
    unknowns.extend(finding.variables.iter().filter(is_unknown).cloned());
    unknowns.extend(unbound(scope, relation, finding));
    let curves: BTreeSet<&str> = unknowns.iter().filter_map(|variable| curve_of(scope, variable)).collect();
    for name in curves.into_iter().filter(|name| is_given(scope, name)) {
        unknowns.extend(given(scope, name));
    }
    let (mut functions, mut curves, mut symbols) = (Vec::new(), Vec::new(), Vec::new());
    let mut families: Vec<&CoefficientGroup> = Vec::new();
    for variable in &unknowns {
        let is_coefficient =
            |group: &&CoefficientGroup| group.rows.iter().flatten().any(|own| own == variable);
        match (scope.owner(variable), scope.groups.iter().find(is_coefficient)) {
            // The coordinates of a curve that is given are not unknown, whatever its symbols are.
            (Some((name, true)), _) if is_given(scope, name) => {}
            (Some((name, true)), _) => curves.push(name),
            (Some((name, false)), _) => functions.push(name),
            (None, Some(group)) if !families.contains(&group) => families.push(group),
            (None, Some(_)) => {}
            // Radicals of numbers and of symbols are no unknowns of their own.
            (None, None) if scope.symbols.contains(variable) || scope.parameters.contains(variable) => {
                symbols.push(variable.name());
            }
            (None, None) => {}
        }
    }
    let (every, all) = if finding.general { ("a general", "general") } else { ("every", "all") };
    let mut parts: Vec<String> =
        families.iter().map(|group| format!("{every} {}", family(scope, group))).collect();
    for (role, names) in [("functions ", &mut functions), ("", &mut symbols)] {
        names.sort_unstable();
        names.dedup();
        if !names.is_empty() {
            parts.push(format!("{all} {role}{}", names.join(", ")));
        }
    }
    curves.sort_unstable();
    curves.dedup();
    parts.extend(curves.iter().map(|curve| format!("{every} curve {curve}")));
    match (parts.is_empty(), model.kind) {
        (false, _) => parts.join(" and "),
        (true, ItemKind::Sweep) => format!("the sweep {}", model.item_name()),
        (true, ItemKind::Lemma) => format!("the example of the lemma {}", model.name),
    }
}

/// The parameters of an identity that stand for any numbers: those of `let` without a domain, in lemmas without curves, unknown
/// functions and surfaces, to which they would belong.
fn unbound(scope: &Scope, relation: &Expr, finding: &Finding) -> Vec<Variable> {
    let identity = matches!(
        finding.evidence,
        Evidence::Sides { .. } | Evidence::RootedSides { .. } | Evidence::Directions { .. }
    );
    let varies = |kind: &ClauseKind| {
        matches!(kind, ClauseKind::Curve(_) | ClauseKind::Function(_) | ClauseKind::Surface(_))
    };
    let is_map =
        |item: &Item| item.kind == ItemKind::Lemma && !item.clauses.iter().any(|clause| varies(&clause.kind));
    if !identity || !scope.item.as_deref().is_some_and(is_map) {
        return Vec::new();
    }
    let named = |parameter: &&Variable| {
        finding.variables.contains(parameter) || is_written(relation, parameter.name())
    };
    let free = scope.parameters.iter().filter(|parameter| !scope.domains.contains_key(parameter));
    free.filter(named).cloned().collect()
}

/// Whether a name stands in an expression, named arguments aside.
fn is_written(expr: &Expr, name: &str) -> bool {
    match expr.kind() {
        ExprKind::Ident(own) => own == name,
        ExprKind::Call { arguments, .. } => {
            let positional = arguments.iter().filter(|argument| argument.name.is_none());
            positional.into_iter().any(|argument| is_written(&argument.value, name))
        }
        _ => expr.children().any(|child| is_written(child, name)),
    }
}

/// The curve whose coordinates or arc length a symbol stands for.
fn curve_of<'a>(scope: &'a Scope, variable: &Variable) -> Option<&'a str> {
    scope.owner(variable).filter(|(_, is_curve)| *is_curve).map(|(name, _)| name)
}

/// The unknowns in what a curve is made from.
fn given(scope: &Scope, curve: &str) -> BTreeSet<Variable> {
    generic::definition(scope, curve).map(|value| generic::unknowns(scope, value)).unwrap_or_default()
}

/// Whether a curve with symbols for coordinates is made from a hodograph without unknown functions.
fn is_given(scope: &Scope, curve: &str) -> bool {
    !given(scope, curve).iter().any(|variable| scope.calculus.is_function(variable))
}

/// The curves that a group of coefficients stands for, with the name of the one that has them.
fn family(scope: &Scope, group: &CoefficientGroup) -> String {
    let name = &group.curve;
    let degree = group.rows.len().saturating_sub(1);
    match group.kind {
        CoefficientKind::Preimage => ph(scope, "", name, degree),
        CoefficientKind::Quaternion => ph(scope, "spatial ", name, degree),
        CoefficientKind::Polynomial => format!("polynomial curve {name} of degree {degree}"),
        CoefficientKind::Rational => format!("rational curve {name} of degree {degree}"),
    }
}

/// The PH curves with a preimage of this degree, in the plane or in space.
fn ph(scope: &Scope, kind: &str, name: &str, degree: usize) -> String {
    let of_curve = 2 * degree + 1;
    // A factor of the hodograph makes the degree higher.
    match (own_degree(scope, name) == Some(of_curve), of_curve) {
        (true, 3) => format!("{kind}PH cubic {name}"),
        (true, 5) => format!("{kind}PH quintic {name}"),
        (true, 7) => format!("{kind}PH septic {name}"),
        (true, _) => format!("{kind}PH curve {name} of degree {of_curve}"),
        (false, _) => format!("{kind}PH curve {name} with a preimage of degree {degree}"),
    }
}

fn own_degree(scope: &Scope, name: &str) -> Option<usize> {
    let (_, curve) = scope.curves().into_iter().find(|(other, _)| *other == name)?;
    let degrees = curve.position().components().iter().map(|part| part.numerator().degree(curve.parameter()));
    degrees.max().flatten().map(|degree| degree as usize)
}
