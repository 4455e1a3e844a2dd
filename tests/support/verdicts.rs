//! The claims of a file with their verdicts, as text.

use std::fmt::Write;

use hodograph_algebra::budget;
use hodograph_codegen::language::{Diagnostics, Report};
use hodograph_codegen::meaning::Judgement;

use crate::catalogue::Formulas;
use crate::digest::fnv1a;

/// How many characters of a derived value are shown.
const SHOWN: usize = 160;

/// The judgements of all claims of a file, in the order of the source.
///
/// # Panics
/// With the report of a mistake in a claim.
#[must_use]
pub fn judgements(formulas: &Formulas) -> Vec<Judgement> {
    let claims =
        formulas.models.iter().flat_map(|model| model.claims.iter().map(move |claim| (model, claim)));
    claims
        .map(|(model, claim)| {
            model.check(claim, budget::DEFAULT_LIMIT).unwrap_or_else(|diagnostic| {
                let mut diagnostics = Diagnostics::new();
                diagnostics.push(*diagnostic);
                panic!("{}", Report::new(formulas.source.clone(), diagnostics))
            })
        })
        .collect()
}

/// A paragraph for each judgement, under the name of its sweep or lemma.
#[must_use]
pub fn text(judgements: &[Judgement]) -> String {
    let mut text = String::new();
    for (index, judgement) in judgements.iter().enumerate() {
        let first = index == 0 || judgements[index - 1].sweep != judgement.sweep;
        if first {
            let rule = "=".repeat(judgement.sweep.len());
            let source = judgement.source.as_deref().unwrap_or("no source");
            let gap = if index == 0 { "" } else { "\n" };
            _ = writeln!(text, "{gap}{}\n{rule}\n{source}", judgement.sweep);
        }
        _ = write!(text, "\n{}: {}", judgement.id, judgement.verdict);
        if judgement.expected != judgement.verdict {
            _ = write!(text, ", but expected {}", judgement.expected);
        } else if judgement.expected.to_string() != "proved" {
            text.push_str(", as expected");
        }
        text.push('\n');
        let notes = judgement.notes.join("; ");
        let effect = judgement.effect.as_ref().map(|(severity, text)| format!("{severity}: {text}"));
        let lines = [
            ("claim", Some(judgement.statement.as_str())),
            ("when", judgement.condition.as_deref()),
            ("note", Some(notes.as_str()).filter(|notes| !notes.is_empty())),
            ("instead", judgement.instead.as_deref()),
            ("effect", effect.as_deref()),
            ("scope", Some(judgement.scope.as_str())),
            ("derived", Some(judgement.derived.as_str())),
            ("witness", judgement.witness.as_deref()),
        ];
        for (name, value) in lines {
            if let Some(value) = value {
                _ = writeln!(text, "  {name:<8}{}", cut(value));
            }
        }
    }
    text
}

/// The beginning of a long text, with its length and digest.
fn cut(text: &str) -> String {
    let length = text.chars().count();
    if length <= 2 * SHOWN {
        return text.to_owned();
    }
    let beginning: String = text.chars().take(SHOWN).collect();
    format!("{beginning} … ({length} characters, digest {})", fnv1a(text))
}
