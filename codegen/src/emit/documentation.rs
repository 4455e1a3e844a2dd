//! What is said of a surface in its documentation: formula, degrees, domain, costs and bounds.

use super::Artifact;
use super::pieces::Whole;
use super::task::TASKS;
use crate::bound::{Reason, Unbounded};
use crate::program::{OperationCounts, Stage, Value};
use crate::proofs::{OutputBound, Proofs};

/// The lines of the documentation of a surface, in Markdown.
pub(super) fn lines(artifact: &Artifact) -> Vec<String> {
    let mut lines: Vec<String> = artifact.documentation.clone();
    if lines.is_empty() {
        lines.push(format!("The surface `{}`.", artifact.name));
    }
    lines.extend([String::new(), "```text".to_string()]);
    lines.extend(artifact.formula.lines().map(str::to_string));
    lines.extend(["```".to_string(), String::new()]);
    if let Some(source) = &artifact.source {
        lines.extend([format!("Source: `{}`.", source.replace('`', "'")), String::new()]);
    }
    let (m, n) = artifact.degree;
    let [w, x, y, z] = artifact.coordinate_degrees.map(|(m, n)| format!("({m}, {n})"));
    let [[u_first, u_last], [v_first, v_last]] = artifact.domain;
    lines.push(format!("- Degree ({m}, {n}): W {w}, X {x}, Y {y}, Z {z}."));
    lines.push(format!("- Domain: u from {u_first:?} to {u_last:?}, v from {v_first:?} to {v_last:?}."));
    if !artifact.symbols.is_empty() {
        let program = &artifact.program;
        let all: Vec<Value> = program.outputs().iter().flat_map(|output| output.values.clone()).collect();
        let once = program.count(&all, Stage::Symbols);
        lines.push(format!("- A family: each member computes its coefficients once, in {once}."));
        lines.push("- The degrees are those of a general member.".to_string());
    }
    if artifact.is_accurate {
        lines.push(
            "- Accurate: the point, on grids and of offsets too. The separated point, derivatives and homogeneous coordinates are those of \
             the smaller bounds."
                .to_string(),
        );
    }
    if let Some(proofs) = &artifact.proofs {
        lines.extend(proofs.certificates.iter().map(|line| format!("- {line}")));
        lines.extend(proofs.bounds.iter().flat_map(boundless));
    }
    lines.extend(costs(artifact));
    lines.extend(artifact.proofs.as_ref().map(bounds).unwrap_or_default());
    lines
}

/// The lines of the documentation of a surface of several pieces, in Markdown; `link` refers to the piece of a name.
pub(super) fn of_pieces(whole: Whole<'_>, link: impl Fn(&str) -> String) -> Vec<String> {
    let Whole { name, pieces } = whole;
    let Some(first) = pieces.first() else { return Vec::new() };
    let mut lines: Vec<String> = first.documentation.clone();
    if lines.is_empty() {
        lines.push(format!("The surface `{name}`."));
    }
    lines.extend([String::new(), "```text".to_string()]);
    lines.extend(first.formula.lines().map(str::to_string));
    lines.extend(["```".to_string(), String::new()]);
    if let Some(source) = &first.source {
        lines.extend([format!("Source: `{}`.", source.replace('`', "'")), String::new()]);
    }
    lines.push(format!("It consists of {} pieces:", pieces.len()));
    lines.extend([String::new(), "| piece | v | degree |".to_string(), "| --- | --- | --- |".to_string()]);
    for piece in pieces {
        let ([_, [start, end]], (m, n)) = (piece.domain, piece.degree);
        lines.push(format!("| {} | from {start:?} to {end:?} | ({m}, {n}) |", link(&piece.name)));
    }
    lines.push(String::new());
    let [plain, fused, single_plain, single_fused] = whole.jumps();
    if plain.is_finite() {
        lines.push(format!(
            "They meet exactly. The points that two neighbors compute at a joint differ by {plain:e} at most in `f64` plain, {fused:e} \
             fused, {single_plain:e} in `f32` plain, {single_fused:e} fused."
        ));
    } else if pieces.iter().skip(1).all(|piece| piece.piece.as_ref().is_some_and(|piece| piece.meets)) {
        lines.push(
            "They meet exactly. How far rounding separates their points at the joints is not proved."
                .to_string(),
        );
    } else {
        lines.push("Not all of them meet.".to_string());
    }
    lines.extend(whole.proofs().as_ref().map(bounds).unwrap_or_default());
    lines
}

fn words(name: &str) -> String {
    name.replace('_', " ")
}

/// What has no bound, in which precisions and variants, and why; for each reason one place.
fn boundless(bound: &OutputBound) -> Vec<String> {
    let mut reasons: Vec<(&Unbounded, Vec<usize>)> = Vec::new();
    for (rounding, failure) in bound.failures.iter().enumerate() {
        let Some(failure) = failure else { continue };
        match reasons.iter_mut().find(|(known, _)| known.reason == failure.reason) {
            Some((_, roundings)) => roundings.push(rounding),
            None => reasons.push((failure, vec![rounding])),
        }
    }
    let name = words(bound.name);
    let of_one = |(failure, roundings): (&Unbounded, Vec<usize>)| {
        let precision = match roundings.as_slice() {
            [0, 1, 2, 3] => String::new(),
            [0, 1] => " in `f64`".to_string(),
            [2, 3] => " in `f32`".to_string(),
            some => {
                let names = ["`f64` plain", "`f64` fused", "`f32` plain", "`f32` fused"];
                let some: Vec<&str> = some.iter().map(|&rounding| names[rounding]).collect();
                format!(" in {}", some.join(", "))
            }
        };
        format!("- No bound for the error of {name}{precision}: {}.", place(failure))
    };
    reasons.into_iter().map(of_one).collect()
}

/// Where and why something has no bound.
fn place(failure: &Unbounded) -> String {
    let [[u0, u1], [v0, v1]] = failure.place;
    let why = match failure.reason {
        Reason::Pole => "it is computed from a quotient that grows beyond all bounds",
        Reason::Denominator => "a denominator is not proved to stay away from zero",
        Reason::Radicand => "a radicand is not proved to stay above zero",
        Reason::Sign => "the sign of a factor is not proved",
        Reason::Direction => "a direction is not proved to stay away from zero",
        Reason::Overflow => "numbers are not proved to stay in range",
        _ => "it is not known",
    };
    format!("{why} near u in {u0:?} to {u1:?}, v in {v0:?} to {v1:?}")
}

/// The table of bounds.
fn bounds(proofs: &Proofs) -> Vec<String> {
    let number = |number: f64| if number.is_finite() { format!("{number:e}") } else { "–".to_string() };
    let mut lines = vec![
        String::new(),
        "| error at most | `f64` plain | fused | `f32` plain | fused | size from | to | each, `f64` plain | relative |"
            .to_string(),
        "| --- | --- | --- | --- | --- | --- | --- | --- | --- |".to_string(),
    ];
    let (mut is_vacuous, mut underflows) = (false, false);
    for bound in proofs.bounds.iter().filter(|bound| bound.errors.iter().any(|error| error.is_finite())) {
        let errors = bound.errors.map(|error| {
            let vacuous = error > 0.0 && error.is_finite() && error >= bound.most;
            is_vacuous |= vacuous;
            if vacuous { format!("({})", number(error)) } else { number(error) }
        });
        let each: Vec<String> = bound.results.iter().map(|result| number(result.errors[0])).collect();
        let relative = bound.results.iter().map(|result| {
            let star = if result.underflow > 0.0 { "*" } else { "" };
            underflows |= result.underflow > 0.0;
            format!("{}{star}", number(result.relative_error))
        });
        let relative: Vec<String> = relative.collect();
        lines.push(format!(
            "| {} | {} | {} | {} | {} | {} |",
            words(bound.name),
            errors.join(" | "),
            number(bound.size),
            number(bound.most),
            each.join(", "),
            relative.join(", ")
        ));
    }
    if is_vacuous || underflows {
        lines.push(String::new());
    }
    if is_vacuous {
        lines.push("In parentheses: no less than the size, so that 0 is as near.".to_string());
    }
    if underflows {
        lines.push("A star: but for what numbers lose that underflow.".to_string());
    }
    lines
}

/// The table of operations.
fn costs(artifact: &Artifact) -> Vec<String> {
    let program = &artifact.program;
    let short = |counts: OperationCounts| {
        let kinds = [
            (counts.additions, "+"),
            (counts.multiplications, "×"),
            (counts.divisions, "÷"),
            (counts.square_roots, "√"),
        ];
        let kinds = kinds.iter().filter(|(count, _)| *count > 0);
        let parts: Vec<String> = kinds.map(|(count, sign)| format!("{count} {sign}")).collect();
        if parts.is_empty() { "none".to_string() } else { parts.join(", ") }
    };
    let mut lines = vec![
        String::new(),
        "| operations | at one place | on a grid for each v | for each u | for each point |".to_string(),
        "| --- | --- | --- | --- | --- |".to_string(),
    ];
    for task in &TASKS {
        let results = task.results(program);
        let all = program.count_all(&results);
        let [v, u, both] =
            [Stage::V, Stage::U, Stage::Both].map(|stage| short(program.count(&results, stage)));
        let total = format!("{}: {}", all.total(), short(all));
        lines.push(format!("| {} | {total} | {v} | {u} | {both} |", task.text));
    }
    lines
}
