//! What a file and its items must hold once, at least or at most.

use std::collections::BTreeMap;

use super::ast::{Clause, ClauseKind, CurveRole, File, Interval, Item, ItemKind, Surface};
use super::diagnostic::{Diagnostic, Diagnostics};
use super::suggest::closest;
use super::token::{Span, shortened};

/// Reports items with the same name.
pub(super) fn repeated_items(file: &File, diagnostics: &mut Diagnostics) {
    let mut first = BTreeMap::new();
    for item in &file.items {
        if let Some(&earlier) = first.get(&item.name.value) {
            let message = format!("`{}` is defined twice", shortened(&item.name.value));
            let wrong = Diagnostic::new(item.name.span, message).also(earlier, "it is defined first here");
            diagnostics.push(wrong.help("give each sweep and lemma a name of its own"));
        } else {
            first.insert(&item.name.value, item.name.span);
        }
    }
}

/// Reports clauses that are given twice or are missing. What could not be read (`attempted`, by keyword) is not
/// missing.
pub(super) fn item(item: &Item, attempted: &[&str], diagnostics: &mut Diagnostics) {
    let sources = item.clauses.iter().filter_map(|clause| match &clause.kind {
        ClauseKind::Source(text) => Some(text.span),
        _ => None,
    });
    report_repeated(sources.map(|span| ("two sources".to_string(), span)), diagnostics);
    let preferences = item.clauses.iter().filter_map(|clause| match &clause.kind {
        ClauseKind::Prefer(preference) => Some(("two preferences".to_string(), preference.span)),
        _ => None,
    });
    report_repeated(preferences, diagnostics);
    let surfaces: Vec<&Surface> = item.clauses.iter().filter_map(surface).collect();
    report_repeated(
        surfaces.iter().map(|surface| ("two surfaces".to_string(), surface.name.span)),
        diagnostics,
    );
    let intervals: Vec<&Interval> = item.clauses.iter().flat_map(intervals).collect();
    let named = |interval: &&Interval| {
        (format!("two domains of `{}`", shortened(&interval.parameter.value)), interval.parameter.span)
    };
    report_repeated(intervals.iter().map(named), diagnostics);

    let name = shortened(&item.name.value);
    if item.kind == ItemKind::Lemma {
        if let Some(surface) = surfaces.first() {
            let wrong = Diagnostic::new(surface.name.span, format!("the lemma `{name}` has a surface"));
            diagnostics.push(wrong.help("a surface belongs to a sweep: write `sweep` instead of `lemma`"));
        }
        return;
    }
    // The generated code names the package, and its type, which is called as the sweep but without underscores, cannot be `Self`.
    let bare = item.name.value.trim_matches('_');
    let is_type = bare.starts_with(char::is_alphabetic) && !["self", "Self"].contains(&bare);
    if item.name.value == "hodograph" || !is_type {
        let wrong =
            Diagnostic::new(item.name.span, format!("no code can be generated for a sweep called `{name}`"));
        diagnostics.push(wrong.help("use another name"));
    }
    let surface = surfaces.first();
    if surface.is_none() && !attempted.contains(&"surface") {
        let wrong = Diagnostic::new(item.name.span, format!("the sweep `{name}` has no surface"));
        let wrong =
            wrong.help("add its formula, `surface R = …;`, or write `lemma` for claims without a surface");
        diagnostics.push(wrong);
    }
    if ["domain", "frames", "surface"].iter().any(|keyword| attempted.contains(keyword)) {
        return;
    }
    let parameters = surface.map_or(["u", "v"], |surface| surface.parameter_names());
    // The parameter of frames runs from the first of them to the last one.
    let is_missing = |parameter: &str| {
        !intervals.iter().any(|interval| interval.parameter.value == parameter)
            && !item.clauses.iter().any(|clause| runs_through_frames(clause, parameter))
    };
    let missing: Vec<String> =
        parameters.into_iter().filter(|name| is_missing(name)).map(shortened).collect();
    if !missing.is_empty() {
        let of: Vec<String> = missing.iter().map(|name| format!("`{name}`")).collect();
        let ranges: Vec<String> = missing.iter().map(|name| format!("{name} in 0..1")).collect();
        let wrong = Diagnostic::new(
            item.name.span,
            format!("the sweep `{name}` has no domain for {}", of.join(" and ")),
        );
        diagnostics.push(wrong.help(format!("add `domain {};`", ranges.join(", "))));
    }
    for interval in
        intervals.iter().filter(|interval| !parameters.contains(&interval.parameter.value.as_str()))
    {
        let other = shortened(&interval.parameter.value);
        let wrong =
            Diagnostic::new(interval.parameter.span, format!("`{other}` is no parameter of the surface"));
        let help = match closest(&other, parameters) {
            Some(meant) => format!("did you mean `{meant}`?"),
            None => format!(
                "its parameters are `{}` and `{}`",
                shortened(parameters[0]),
                shortened(parameters[1])
            ),
        };
        diagnostics.push(wrong.help(help));
    }
}

fn runs_through_frames(clause: &Clause, parameter: &str) -> bool {
    let ClauseKind::Curve(curve) = &clause.kind else { return false };
    curve.role == CurveRole::Frames && curve.parameter.value == parameter
}

fn surface(clause: &Clause) -> Option<&Surface> {
    if let ClauseKind::Surface(surface) = &clause.kind { Some(surface) } else { None }
}

fn intervals(clause: &Clause) -> &[Interval] {
    if let ClauseKind::Domain(intervals) = &clause.kind { intervals } else { &[] }
}

/// Reports what stands a second time, with both places.
fn report_repeated(all: impl Iterator<Item = (String, Span)>, diagnostics: &mut Diagnostics) {
    let mut first: BTreeMap<String, Span> = BTreeMap::new();
    for (what, span) in all {
        if let Some(&earlier) = first.get(&what) {
            let wrong =
                Diagnostic::new(span, format!("{what} are given")).also(earlier, "the first is given here");
            diagnostics.push(wrong.help("leave one of them out"));
        } else {
            first.insert(what, span);
        }
    }
}
