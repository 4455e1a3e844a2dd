//! `hodograph verify --explain ID`: how the verdicts on a claim come about.

use std::collections::BTreeSet;
use std::process::ExitCode;

use hodograph_codegen::language::ast::{Claim, ItemKind, Verdict};
use hodograph_codegen::language::{Diagnostics, Report, closest};
use hodograph_codegen::meaning::{Explanation, Judgement, Model, Step};

use super::{expected, json, status};
use crate::args::{Format, VerifyArguments};
use crate::console::{self, Progress};
use crate::failure::Failure;
use crate::input::{self, Document};
use crate::layout::wrapped;

/// How many ids an error lists.
const MOST_IDS: usize = 12;

/// The width of the column that says what a step is.
const WHAT: usize = 14;

/// The derivation of one clause.
struct Explained<'a> {
    model: &'a Model,
    file: &'a str,
    explanation: Explanation,
}

/// Explains all clauses with the id `id`.
///
/// # Errors
/// No claim of this id; mistakes in claims.
pub(super) fn run(id: &str, arguments: &VerifyArguments) -> Result<ExitCode, Failure> {
    let limit = arguments.budget.limit;
    let mut ids = BTreeSet::new();
    let documents = if arguments.inputs.is_empty() {
        // What has no such claim need not be evaluated.
        input::selection(limit, |file| {
            ids.extend(input::claims(file).map(|(_, claim)| claim.id.value.clone()));
            input::claims(file).any(|(_, claim)| claim.id.value == id)
        })?
    } else {
        let documents = input::load_all(&arguments.inputs, limit)?;
        ids.extend(documents.iter().flat_map(claims).map(|(_, claim)| claim.id.value.clone()));
        documents
    };
    let progress = Progress::new();
    let (mut all, mut failures) = (Vec::new(), Vec::new());
    for document in &documents {
        let mut diagnostics = Diagnostics::new();
        for (model, claim) in claims(document).filter(|(_, claim)| claim.id.value == id) {
            progress.show(&format!("explaining {id} of {}", model.item_name()));
            match model.explain(claim, model.limit, arguments.full) {
                Ok(explanation) => {
                    all.push(Explained { model, file: document.source.name(), explanation });
                }
                Err(diagnostic) => diagnostics.push(*diagnostic),
            }
        }
        if !diagnostics.is_empty() {
            failures.push(Failure::Report(Box::new(Report::new(document.source.clone(), diagnostics))));
        }
    }
    drop(progress);
    if !failures.is_empty() {
        return Err(Failure::Several(failures));
    }
    if all.is_empty() {
        return Err(unknown(&ids, id));
    }
    console::print(&match arguments.format {
        Format::Text => text(&all),
        Format::Json => {
            json::explanations(&all.iter().map(|explained| &explained.explanation).collect::<Vec<_>>())
        }
    })?;
    Ok(status(all.iter().map(|explained| &explained.explanation.judgement)).into())
}

fn claims(document: &Document) -> impl Iterator<Item = (&Model, &Claim)> {
    document.models().flat_map(|model| model.claims.iter().map(move |claim| (model, claim)))
}

/// No claim of this id, with those that may be meant.
fn unknown(ids: &BTreeSet<String>, id: &str) -> Failure {
    let ids: Vec<&str> = ids.iter().map(String::as_str).collect();
    let failure = Failure::new(format!("there is no claim `{id}`"));
    let similar: Vec<&str> = ids
        .iter()
        .copied()
        .filter(|known| !id.is_empty() && known.to_lowercase().contains(&id.to_lowercase()))
        .take(MOST_IDS)
        .collect();
    failure.help(match (closest(id, ids.iter().copied()), similar.as_slice()) {
        (_, [_, ..]) => format!("there are {}", similar.join(", ")),
        (Some(one), []) => format!("did you mean `{one}`?"),
        (None, []) if ids.is_empty() => "these files have no claims".to_owned(),
        (None, []) => {
            let rest =
                if ids.len() > MOST_IDS { format!(", … ({} ids)", ids.len()) } else { String::new() };
            format!("the ids are {}{rest}", ids[..ids.len().min(MOST_IDS)].join(", "))
        }
    })
}

fn text(all: &[Explained<'_>]) -> String {
    let mut parts: Vec<String> = all.iter().map(|explained| one(explained, all)).collect();
    let count = |verdict: Verdict| {
        all.iter().filter(|explained| explained.explanation.judgement.verdict == verdict).count()
    };
    let id = all.first().map_or("", |explained| &explained.explanation.judgement.id);
    let (proved, refuted, undecided) =
        (count(Verdict::Proved), count(Verdict::Refuted), count(Verdict::Undecided));
    parts.push(format!("{id}: {proved} proved, {refuted} refuted, {undecided} undecided\n"));
    parts.join("\n")
}

/// One clause: what is claimed, where, the steps and, if it is refuted, what is right.
fn one(explained: &Explained<'_>, all: &[Explained<'_>]) -> String {
    let Explained { model, file, explanation } = explained;
    let judgement = &explanation.judgement;
    let expectation = if expected(judgement) {
        ", as expected".to_owned()
    } else {
        format!(", expected {}", judgement.expected)
    };
    let expectation =
        if judgement.verdict == Verdict::Proved && expected(judgement) { "" } else { &expectation };
    let mut text = format!("{}: {}{expectation}\n", judgement.id, judgement.verdict);
    let kind = if model.kind == ItemKind::Sweep { "sweep" } else { "lemma" };
    let source = judgement.source.as_deref().unwrap_or("no source");
    text += &wrapped("  ", &format!("{kind} {} in {file}: {source}", model.item_name()));
    text.push('\n');
    for step in &explanation.steps {
        text += &line(step);
    }
    if judgement.verdict == Verdict::Refuted {
        for other in corrections(judgement, all) {
            let formula = &other.statement;
            let because = other.instead.as_deref().unwrap_or_default().to_owned();
            text += &line(&Step { what: "what is right", formula: formula.clone(), because });
        }
    }
    text
}

/// The clauses that state what holds in place of a refuted one: those of its item, else all.
fn corrections<'a>(refuted: &Judgement, all: &'a [Explained<'_>]) -> Vec<&'a Judgement> {
    let judgements = all.iter().map(|explained| &explained.explanation.judgement);
    let mut corrections: Vec<&Judgement> =
        judgements.filter(|other| other.verdict == Verdict::Proved && other.instead.is_some()).collect();
    if corrections.iter().any(|other| other.sweep == refuted.sweep) {
        corrections.retain(|other| other.sweep == refuted.sweep);
    }
    corrections
}

fn line(step: &Step) -> String {
    let mut text = wrapped(&format!("  {:<WHAT$} ", step.what), &step.formula);
    if !step.because.is_empty() {
        text.push('\n');
        text += &wrapped(&format!("  {:<WHAT$}   ", ""), &step.because);
    }
    text.push('\n');
    text
}
