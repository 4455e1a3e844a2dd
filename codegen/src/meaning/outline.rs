//! What an item says before anything in it is evaluated: its parameters, its surface's place, its symbolic curves.

use hodograph_algebra::Variable;

use crate::language::Span;
use crate::language::ast::{Clause, ClauseKind, ExprKind, Item, Name};

/// The place of the surface's formula.
pub(super) fn surface_place(item: &Item) -> Option<Span> {
    item.clauses.iter().find_map(|clause| match &clause.kind {
        ClauseKind::Surface(surface) => Some(surface.value.span()),
        _ => None,
    })
}

/// The parameters of an item: those of its surface, or of its curves and functions.
pub(super) fn parameters(item: &Item) -> Vec<Variable> {
    let mut names: Vec<&str> = Vec::new();
    for clause in &item.clauses {
        match &clause.kind {
            ClauseKind::Surface(surface) => names.extend(surface.parameter_names()),
            ClauseKind::Domain(intervals) => {
                names.extend(intervals.iter().map(|i| i.parameter.value.as_str()))
            }
            ClauseKind::Curve(curve) => names.push(&curve.parameter.value),
            ClauseKind::Function(functions) => {
                names.extend(functions.iter().map(|f| f.parameter.value.as_str()))
            }
            ClauseKind::Let(definition) => {
                names.extend(definition.parameters.iter().map(|p| p.value.as_str()))
            }
            _ => {}
        }
    }
    let surface = item.clauses.iter().find_map(|clause| match &clause.kind {
        ClauseKind::Surface(surface) => Some(surface.parameter_names()),
        _ => None,
    });
    names.sort_unstable();
    names.dedup();
    if let Some(own) = surface {
        names.retain(|name| !own.contains(name));
        names.splice(0..0, own);
    }
    (0_u32..).zip(names).map(|(rank, name)| Variable::new(rank.min(Variable::SYMBOL - 1), name)).collect()
}

/// Each parameter where it is first named.
pub(super) fn parameter_names(item: &Item) -> Vec<&Name> {
    let mut names: Vec<&Name> = Vec::new();
    for clause in &item.clauses {
        match &clause.kind {
            ClauseKind::Surface(surface) => names.extend(surface.parameters.iter().flatten()),
            ClauseKind::Domain(intervals) => {
                names.extend(intervals.iter().map(|interval| &interval.parameter))
            }
            ClauseKind::Curve(curve) => names.push(&curve.parameter),
            ClauseKind::Function(functions) => {
                names.extend(functions.iter().map(|function| &function.parameter))
            }
            ClauseKind::Let(definition) => names.extend(&definition.parameters),
            _ => {}
        }
    }
    let mut seen = std::collections::BTreeSet::new();
    names.retain(|name| seen.insert(name.value.as_str()));
    names
}

/// The number of curves with symbolic coefficients.
pub(super) fn symbolic_curves(item: &Item) -> usize {
    let symbolic = |clause: &&Clause| match &clause.kind {
        ClauseKind::Curve(curve) => match curve.value.kind() {
            ExprKind::Call { callee, arguments } => match callee.kind() {
                ExprKind::Ident(name) => match name.as_str() {
                    "polynomial_curve" | "rational_curve" => true,
                    "ph" | "ph_spatial" => {
                        !arguments.iter().any(|argument| matches!(argument.value.kind(), ExprKind::Array(_)))
                    }
                    _ => false,
                },
                _ => false,
            },
            _ => false,
        },
        _ => false,
    };
    item.clauses.iter().filter(symbolic).count()
}

/// Whether the item has a domain for the parameter, be it a wrong one.
pub(super) fn states_domain(item: &Item, parameter: &Variable) -> bool {
    item.clauses.iter().any(|clause| match &clause.kind {
        ClauseKind::Domain(intervals) => intervals.iter().any(|i| i.parameter.value == parameter.name()),
        _ => false,
    })
}
