//! What a claim rests on: the clauses of its item, each with what it evaluates to.

use std::collections::BTreeSet;

use super::Steps;
use super::show::Show;
use crate::language::ast::{Claim, Clause, ClauseKind, Expr, ExprKind};
use crate::meaning::scope::{COORDINATES, FUNCTIONS};
use crate::meaning::value::Value;

/// Functions whose calls have no value of their own, or none that is not shown with what is made of it.
const SILENT: &[&str] = &[
    "approx",
    "bezier",
    "coprime",
    "curve_from_hodograph",
    "is_pn",
    "degree",
    "is_rational",
    "parallel",
    "ph",
    "ph_hermite",
    "polynomial_curve",
    "positive",
    "rational_curve",
    "regular_curve",
];

/// Adds the clauses on which a claim rests, with their values, and the parts of its relation.
pub(super) fn explain(show: &Show<'_>, steps: &mut Steps, claim: &Claim) {
    let Some(item) = show.scope().item.clone() else { return };
    let mut needed = BTreeSet::new();
    names(&claim.relation, &mut needed);
    claim.conditions.iter().for_each(|condition| names(condition, &mut needed));
    // Clauses use what stands before them alone.
    for clause in item.clauses.iter().rev() {
        if let Some(value) = defines(clause, &needed).and_then(|_| value(clause)) {
            names(value, &mut needed);
        }
    }
    let mut parts = Parts { show, steps, shown: BTreeSet::new() };
    for clause in &item.clauses {
        parts.clause(clause, &needed);
    }
    parts.steps.push("claim", claim.relation.to_string(), claim.notes_and_correction());
    parts.of(&claim.relation, true);
}

impl Claim {
    /// What the source says about the claim, in one text.
    fn notes_and_correction(&self) -> String {
        let notes = self.notes.iter().map(|note| note.value.clone());
        let instead = self.instead.iter().map(|text| format!("what holds: {}", text.value));
        notes.chain(instead).collect::<Vec<_>>().join("; ")
    }
}

/// The names in an expression, with `W` if one of the homogeneous coordinates is asked for.
fn names(expr: &Expr, found: &mut BTreeSet<String>) {
    if let ExprKind::Ident(name) = expr.kind() {
        let coordinate = COORDINATES.contains(&name.as_str());
        found.insert(if coordinate { COORDINATES[0].to_owned() } else { name.clone() });
    }
    expr.children().for_each(|child| names(child, found));
}

/// The name that a clause defines, if it is needed.
fn defines<'a>(clause: &'a Clause, needed: &BTreeSet<String>) -> Option<&'a str> {
    let name = match &clause.kind {
        ClauseKind::Let(definition) => &definition.name.value,
        ClauseKind::Curve(curve) => &curve.name.value,
        // The coordinates and what is put for a parameter belong to the surface.
        ClauseKind::Surface(surface) if needed.contains(COORDINATES[0]) => return Some(&surface.name.value),
        ClauseKind::Surface(surface) => &surface.name.value,
        ClauseKind::Substitute(definition) => return Some(&definition.name.value),
        _ => return None,
    };
    needed.contains(name).then_some(name)
}

fn value(clause: &Clause) -> Option<&Expr> {
    match &clause.kind {
        ClauseKind::Let(definition) | ClauseKind::Substitute(definition) => Some(&definition.value),
        ClauseKind::Curve(curve) => Some(&curve.value),
        ClauseKind::Surface(surface) => Some(&surface.value),
        _ => None,
    }
}

struct Parts<'a, 'b> {
    show: &'a Show<'b>,
    steps: &'a mut Steps,
    /// What has been shown, as it is written.
    shown: BTreeSet<String>,
}

impl Parts<'_, '_> {
    fn clause(&mut self, clause: &Clause, needed: &BTreeSet<String>) {
        match &clause.kind {
            ClauseKind::Symbol(symbols) => {
                let names = symbols.iter().map(|name| name.value.clone());
                self.declaration("symbol", names.filter(|name| needed.contains(name)), "real constants");
            }
            ClauseKind::Function(functions) => {
                let used = functions.iter().filter(|function| needed.contains(&function.name.value));
                let names =
                    used.map(|function| format!("{}({})", function.name.value, function.parameter.value));
                self.declaration("function", names, "unknown functions");
            }
            ClauseKind::Domain(_) => {
                self.steps.push("definition", text(clause), "closed intervals");
            }
            _ => {
                let (Some(name), Some(value)) = (defines(clause, needed), value(clause)) else { return };
                self.steps.push("definition", text(clause), docs(clause));
                self.shown.insert(value.to_string());
                self.of(value, false);
                if matches!(clause.kind, ClauseKind::Substitute(_)) {
                    return;
                }
                self.named(name, value);
                for (derivative, text) in self.show.frame_equations(name) {
                    let because = "a curve of this speed and curvature in its moving frame";
                    self.steps.push("value", format!("{derivative} = {text}"), because);
                    self.shown.insert(derivative);
                }
                if matches!(clause.kind, ClauseKind::Surface(_)) && needed.contains(COORDINATES[0]) {
                    self.coordinates();
                }
            }
        }
    }

    fn declaration(&mut self, keyword: &str, names: impl Iterator<Item = String>, because: &str) {
        let names: Vec<String> = names.collect();
        if !names.is_empty() {
            self.steps.push("definition", format!("{keyword} {}", names.join(", ")), because);
        }
    }

    /// The value of a name that has just been defined by an expression.
    fn named(&mut self, name: &str, expr: &Expr) {
        let show = self.show;
        // The place is used for errors alone.
        let Ok(value) = show.scope().value(name, expr.span()) else { return };
        match self.steps.within(|| show.value(&value)) {
            // What is written is what it is.
            Ok(Some(text)) if text == expr.to_string() || text == name => {}
            Ok(Some(text)) => self.steps.push("value", format!("{name} = {text}"), speed(&value)),
            Ok(None) => {}
            Err(_) => self.steps.push("value", name, TOO_LONG),
        }
    }

    /// The homogeneous coordinates of the surface, each with its degree.
    fn coordinates(&mut self) {
        let show = self.show;
        let Some(surface) = &show.scope().surface else { return };
        let work = || {
            let homogeneous = surface.homogeneous();
            let line = |(name, poly): (&str, _)| format!("{name} = {}", show.poly(poly));
            let lines: Vec<String> =
                COORDINATES.into_iter().zip(homogeneous.coordinates()).map(line).collect();
            let degrees = homogeneous.degrees().map(|degree| format!("of degree {degree}"));
            let factor = homogeneous.common_factor();
            let cancelled = if factor.is_constant() {
                String::new()
            } else {
                format!(", without the common factor {} of what the formula gives", show.poly(factor))
            };
            (lines, degrees, cancelled)
        };
        match self.steps.within(work) {
            Ok((lines, degrees, cancelled)) => {
                for (line, degree) in lines.into_iter().zip(degrees) {
                    self.steps.push("value", line, format!("{degree}{cancelled}"));
                }
            }
            Err(_) => self.steps.push("value", COORDINATES.join(", "), TOO_LONG),
        }
    }

    /// The members and calls in an expression, innermost first; `sides` says that it is a relation, whose sides are shown
    /// elsewhere.
    fn of(&mut self, expr: &Expr, sides: bool) {
        match expr.kind() {
            ExprKind::Relation { left, right, .. } => {
                self.within(left);
                self.within(right);
                return;
            }
            ExprKind::Not(inner) => return self.of(inner, sides),
            ExprKind::Call { arguments, .. } if sides => {
                for argument in arguments {
                    argument.value.children().for_each(|child| self.of(child, false));
                }
                return;
            }
            _ => self.within(expr),
        }
        if is_worth_showing(expr) && !self.steps.is_full() && self.shown.insert(expr.to_string()) {
            self.part(expr);
        }
    }

    /// What an expression is made of, without itself.
    fn within(&mut self, expr: &Expr) {
        if let ExprKind::Call { callee, arguments } = expr.kind() {
            // What a member that is called gives stands in the call's value.
            callee.children().for_each(|child| self.of(child, false));
            arguments.iter().for_each(|argument| self.of(&argument.value, false));
        } else {
            expr.children().for_each(|child| self.of(child, false));
        }
    }

    fn part(&mut self, expr: &Expr) {
        let show = self.show;
        let work = || match show.scope().evaluate(expr) {
            Ok(value) => show.value(&value).map(|text| (text, String::new())),
            Err(fault) => Some(("none".to_owned(), fault.diagnostic.message)),
        };
        match self.steps.within(work) {
            // A vector of a moving frame is what it is.
            Ok(Some((text, _))) if text == expr.to_string() => {}
            Ok(Some((text, because))) => self.steps.push("value", format!("{expr} = {text}"), because),
            Ok(None) => {}
            Err(_) => self.steps.push("value", expr.to_string(), TOO_LONG),
        }
    }
}

/// Why a value is not written out.
pub(super) const TOO_LONG: &str = "not written out: that takes more than what is left of the budget";

/// Members, and calls with a value.
fn is_worth_showing(expr: &Expr) -> bool {
    match expr.kind() {
        ExprKind::Member { .. } => true,
        ExprKind::Call { callee, .. } => match callee.kind() {
            ExprKind::Ident(name) => !SILENT.contains(&name.as_str()) || !FUNCTIONS.contains(&name.as_str()),
            _ => true,
        },
        _ => false,
    }
}

/// What is known of a curve from its construction.
fn speed(value: &Value) -> String {
    match value.bare() {
        Value::Curve(curve) if curve.preimage().is_some() => {
            "a Pythagorean-hodograph curve: its hodograph is made of a preimage".to_owned()
        }
        _ => String::new(),
    }
}

/// A clause without its semicolon.
fn text(clause: &Clause) -> String {
    clause.to_string().trim_end_matches(';').to_owned()
}

fn docs(clause: &Clause) -> String {
    clause.docs.iter().map(|line| line.value.trim()).collect::<Vec<_>>().join(" ")
}
