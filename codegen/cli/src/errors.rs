//! `hodograph errors`: the page of the claims of sources that are refuted, with what is right.

use std::collections::BTreeSet;
use std::process::ExitCode;

use hodograph_codegen::language::ast::{Severity, Verdict};
use hodograph_codegen::language::{Diagnostic, Diagnostics, Report};
use hodograph_codegen::meaning::{Explanation, Judgement, Step};

use crate::args::ErrorsArguments;
use crate::console::{self, Progress};
use crate::failure::Failure;
use crate::input::{self, Document};
use crate::layout::{cut, wrapped};
use crate::output::{self, quoted};

/// What the page begins with.
const HEAD: &str = include_str!("errors.md");

/// How many characters of a condition are shown.
const LONGEST: usize = 300;

/// The steps of a derivation that say what is claimed and what became of it, which the page says elsewhere.
const ELSEWHERE: &[&str] = &["claim", "condition", "verdict"];

/// All that is known of one id of which a claim is refuted.
struct Entry {
    id: String,
    source: String,
    /// The refuted clauses, in the order of the source.
    refuted: Vec<Explanation>,
    /// What holds in their place.
    corrections: Vec<Judgement>,
}

impl Entry {
    /// How grave it is: as the gravest of its clauses; those of which nothing is said come last.
    fn severity(&self) -> Option<Severity> {
        self.refuted
            .iter()
            .filter_map(|one| one.judgement.effect.as_ref())
            .map(|(severity, _)| *severity)
            .min()
    }
}

/// Runs the command.
///
/// # Errors
/// Bad input; a claim that is not refuted though that is expected; a file that cannot be written.
pub(crate) fn run(arguments: &ErrorsArguments) -> Result<ExitCode, Failure> {
    let limit = arguments.budget.limit;
    let documents = if arguments.inputs.is_empty() {
        let ids: BTreeSet<String> = refuted_ids()?;
        input::selection(limit, |file| input::claims(file).any(|(_, claim)| ids.contains(&claim.id.value)))?
    } else {
        input::load_all(&arguments.inputs, limit)?
    };
    let text = page(&entries(&documents)?);
    match &arguments.output {
        None => console::print(&text)?,
        Some(path) if arguments.check => {
            let inputs: String = arguments.inputs.iter().map(|input| format!(" {}", quoted(input))).collect();
            let mending = format!("hodograph errors{inputs} -o {}", quoted(&path.display().to_string()));
            return output::check(path, &text, &mending);
        }
        Some(path) => output::write(path, &text)?,
    }
    Ok(ExitCode::SUCCESS)
}

/// The ids of the catalogue of which a clause is expected to be refuted.
fn refuted_ids() -> Result<BTreeSet<String>, Failure> {
    let mut ids = BTreeSet::new();
    // Nothing is evaluated for this.
    input::selection(1, |file| {
        let refuted = input::claims(file).filter(|(_, claim)| expects_refutation(claim));
        ids.extend(refuted.map(|(_, claim)| claim.id.value.clone()));
        false
    })?;
    Ok(ids)
}

fn expects_refutation(claim: &hodograph_codegen::language::ast::Claim) -> bool {
    claim.expected.as_ref().is_some_and(|expected| expected.value == Verdict::Refuted)
}

/// The entries by severity, gravest first, then in the order of the documents.
fn entries(documents: &[Document]) -> Result<Vec<Entry>, Failure> {
    let progress = Progress::new();
    let (mut entries, mut failures): (Vec<Entry>, Vec<Failure>) = (Vec::new(), Vec::new());
    for document in documents {
        let mut diagnostics = Diagnostics::new();
        for model in document.models() {
            for claim in model.claims.iter().filter(|claim| expects_refutation(claim)) {
                progress.show(&format!("refuting {} of {}", claim.id.value, model.item_name()));
                let explanation = match model.explain(claim, model.limit, false) {
                    Ok(explanation) if explanation.judgement.verdict == Verdict::Refuted => explanation,
                    Ok(explanation) => {
                        let judgement = explanation.judgement;
                        let message =
                            format!("this is expected to be refuted, but it is {}", judgement.verdict);
                        diagnostics.push(Diagnostic::new(claim.relation.span(), message));
                        continue;
                    }
                    Err(diagnostic) => {
                        diagnostics.push(*diagnostic);
                        continue;
                    }
                };
                match entries.iter_mut().find(|entry| entry.id == claim.id.value) {
                    Some(entry) => entry.refuted.push(explanation),
                    None => entries.push(Entry {
                        id: claim.id.value.clone(),
                        source: model.source.clone().unwrap_or_default(),
                        refuted: vec![explanation],
                        corrections: Vec::new(),
                    }),
                }
            }
        }
        if !diagnostics.is_empty() {
            failures.push(Failure::Report(Box::new(Report::new(document.source.clone(), diagnostics))));
        }
    }
    for entry in &mut entries {
        progress.show(&format!("what holds instead of {}", entry.id));
        correct(entry, documents, &mut failures);
    }
    entries.sort_by_key(|entry| entry.severity().map_or((1, None), |severity| (0, Some(severity))));
    if failures.is_empty() { Ok(entries) } else { Err(Failure::Several(failures)) }
}

/// Adds the clauses that hold in place of those that do not: those that say so; if none does, all that are proved in the
/// same items.
fn correct(entry: &mut Entry, documents: &[Document], failures: &mut Vec<Failure>) {
    let items: BTreeSet<&str> = entry.refuted.iter().map(|one| one.judgement.sweep.as_str()).collect();
    let all = || {
        let models =
            documents.iter().flat_map(|document| document.models().map(move |model| (document, model)));
        let claims = models
            .flat_map(|(document, model)| model.claims.iter().map(move |claim| (document, model, claim)));
        claims.filter(|(_, _, claim)| claim.id.value == entry.id && !expects_refutation(claim))
    };
    let stated = all().any(|(_, _, claim)| claim.instead.is_some());
    let mut corrections = Vec::new();
    for (document, model, claim) in all() {
        if if stated { claim.instead.is_some() } else { items.contains(model.item_name()) } {
            match model.check(claim, model.limit) {
                Ok(judgement) if judgement.verdict == Verdict::Proved => corrections.push(judgement),
                Ok(_) => {}
                Err(diagnostic) => failures.push(Failure::at(&document.source, *diagnostic)),
            }
        }
    }
    entry.corrections = corrections;
}

/// The page, in Markdown.
fn page(entries: &[Entry]) -> String {
    let mut text = HEAD.to_owned();
    text += "\n| severity | claim | where | what is wrong |\n| --- | --- | --- | --- |\n";
    for entry in entries {
        let severity = entry.severity().map_or_else(|| "—".to_owned(), |severity| severity.to_string());
        let notes =
            entry.refuted.first().map_or("", |one| one.judgement.notes.first().map_or("", String::as_str));
        text += &format!(
            "| {severity} | [{id}](#{anchor}) | {} | {} |\n",
            cell(&entry.source),
            cell(notes),
            id = cell(&entry.id),
            anchor = anchor(&entry.id),
        );
    }
    for entry in entries {
        text += &section(entry);
    }
    text
}

/// The name that a heading with this text is linked by.
fn anchor(heading: &str) -> String {
    let kept = |c: char| match c {
        ' ' => Some('-'),
        '-' | '_' => Some(c),
        _ if c.is_alphanumeric() => Some(c.to_ascii_lowercase()),
        _ => None,
    };
    heading.chars().filter_map(kept).collect()
}

/// A text in a cell of a table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|").replace('\n', " ")
}

fn section(entry: &Entry) -> String {
    let mut text = format!("\n## {}\n", entry.id);
    if let Some(severity) = entry.severity() {
        text += &format!("\nSeverity: {severity}.\n");
    }
    let mut corrected = BTreeSet::new();
    for explanation in &entry.refuted {
        let judgement = &explanation.judgement;
        let source = judgement.source.as_deref().unwrap_or("no source");
        let notes = judgement.notes.join("; ");
        let notes = if notes.is_empty() { String::new() } else { format!(": {notes}") };
        text += &format!("\n**Printed** ({source}){notes}.\n\n{}", block([judgement.statement.clone()]));
        let definitions = explanation.steps.iter().filter(|step| step.what == "definition");
        let definitions: Vec<String> = definitions.map(|step| step.formula.clone()).collect();
        if !definitions.is_empty() {
            text += &format!("\nwhere, in `{}`,\n\n{}", judgement.sweep, block(definitions));
        }
        text += &format!("\n**Refuted**, for {}.\n\n{}", judgement.scope, reasons(&explanation.steps));
        if let Some(condition) = &judgement.condition {
            text += &format!("\nThis assumes that\n\n{}", block([cut(condition, LONGEST)]));
        }
        let own = entry.corrections.iter().filter(|correction| correction.sweep == judgement.sweep);
        let fresh: Vec<&Judgement> =
            own.filter(|correction| corrected.insert((&correction.sweep, &correction.statement))).collect();
        text += &right(&fresh);
        if let Some((_, effect)) = &judgement.effect {
            text += &format!("\n**Effect.** {}.\n", sentence(effect.trim_end_matches('.')));
        }
    }
    let others = entry.corrections.iter();
    let others: Vec<&Judgement> =
        others.filter(|correction| corrected.insert((&correction.sweep, &correction.statement))).collect();
    text + &right(&others)
}

/// What holds, each clause with its formula.
fn right(corrections: &[&Judgement]) -> String {
    let mut text = String::new();
    for correction in corrections {
        let mut notes: Vec<&str> = correction.notes.iter().map(String::as_str).collect();
        notes.extend(correction.instead.as_deref());
        let named = correction.scope.contains(&correction.sweep);
        let item = if named { String::new() } else { format!(" (`{}`)", correction.sweep) };
        let notes = if notes.is_empty() { String::new() } else { format!(": {}", notes.join("; ")) };
        let condition = correction.condition.as_ref();
        let condition = condition.map(|condition| format!("    when {}", cut(condition, LONGEST)));
        text += &format!(
            "\n**Right**, proved for {}{item}{notes}.\n\n{}",
            correction.scope,
            block(std::iter::once(correction.statement.clone()).chain(condition))
        );
    }
    text
}

/// A text with a capital at its beginning.
fn sentence(text: &str) -> String {
    let mut characters = text.chars();
    characters
        .next()
        .map_or_else(String::new, |first| first.to_uppercase().collect::<String>() + characters.as_str())
}

/// The steps behind the claim itself, as a block of formulas with what follows from each.
fn reasons(steps: &[Step]) -> String {
    let behind = steps.iter().skip_while(|step| step.what != "claim");
    let lines = behind.filter(|step| !ELSEWHERE.contains(&step.what)).map(|step| {
        let because = if step.because.is_empty() { String::new() } else { format!("   // {}", step.because) };
        format!("{}: {}{because}", step.what, step.formula)
    });
    block(lines)
}

/// Formulas, each on lines of its own.
fn block(formulas: impl IntoIterator<Item = String>) -> String {
    let lines: Vec<String> = formulas.into_iter().map(|formula| continued(&formula)).collect();
    format!("```text\n{}\n```\n", lines.join("\n"))
}

/// A formula, broken into lines of which all but the first are indented.
fn continued(formula: &str) -> String {
    let indent = &formula[..formula.len() - formula.trim_start().len()];
    let formula = formula.trim_start();
    match formula.split_once(' ') {
        Some((first, rest)) => {
            let lines = wrapped(&format!("{first} "), rest);
            let lines: Vec<&str> = lines.lines().map(str::trim_start).collect();
            format!("{indent}{}", lines.join(&format!("\n{indent}    ")))
        }
        None => format!("{indent}{formula}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn anchors_are_those_of_headings() {
        assert_eq!(anchor("FN-13,15"), "fn-1315");
        assert_eq!(anchor("A b_c"), "a-b_c");
    }

    #[test]
    fn formulas_are_continued_with_an_indent() {
        let formula = vec!["u^2*v^3"; 40].join(" + ");
        let text = continued(&formula);
        assert!(
            text.lines().skip(1).all(|line| line.starts_with("    u") || line.starts_with("    +")),
            "{text}"
        );
        assert_eq!(text.replace("\n    ", " "), formula);
        assert_eq!(continued("x"), "x");
    }

    #[test]
    fn sentences_begin_with_a_capital() {
        assert_eq!(sentence("a remark"), "A remark");
        assert_eq!(sentence(""), "");
    }
}
