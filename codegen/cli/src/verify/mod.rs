//! `hodograph verify`: the verdict on every claim.

mod explain;
mod json;
mod text;

use std::process::ExitCode;
use std::time::{Duration, Instant};

use hodograph_algebra::{Bidegree, OffsetError, budget};
use hodograph_codegen::language::ast::{ItemKind, Verdict};
use hodograph_codegen::language::{Diagnostic, Diagnostics, Report};
use hodograph_codegen::meaning::{Judgement, Model};

use crate::args::{Format, VerifyArguments};
use crate::console::{self, Progress};
use crate::failure::Failure;
use crate::input::{self, Document};

/// The claims of one file together may take as many times the budget of a single one.
const FULL_CLAIMS: u64 = 4;

/// The exit status if a verdict is other than expected.
const UNEXPECTED: u8 = 1;

/// The exit status if a claim is undecided that was expected to be decided.
const UNDECIDED: u8 = 3;

/// A sweep or a lemma with the verdicts on its claims.
#[derive(Debug)]
pub(crate) struct Entry {
    kind: ItemKind,
    name: String,
    source: Option<String>,
    degrees: Option<Degrees>,
    judgements: Vec<Judgement>,
}

/// The degrees of a sweep's homogeneous coordinates.
#[derive(Debug)]
struct Degrees {
    coordinates: [Bidegree; 4],
    patch: Bidegree,
    raw: Bidegree,
}

impl Entry {
    /// Adds another piece of the same sweep: its degrees, of which the largest count.
    fn extend(&mut self, piece: Entry) {
        let degrees = self.degrees.take().zip(piece.degrees).map(|(own, other)| {
            let largest = |a: Bidegree, b: Bidegree| Bidegree { u: a.u.max(b.u), v: a.v.max(b.v) };
            let [w, x, y, z] = own.coordinates;
            let [a, b, c, d] = other.coordinates;
            Degrees {
                coordinates: [largest(w, a), largest(x, b), largest(y, c), largest(z, d)],
                patch: largest(own.patch, other.patch),
                raw: largest(own.raw, other.raw),
            }
        });
        self.degrees = degrees;
        self.judgements.extend(piece.judgements);
    }
}

/// Runs the command.
///
/// # Errors
/// Bad input, mistakes in claims included.
pub(crate) fn run(arguments: &VerifyArguments) -> Result<ExitCode, Failure> {
    let start = Instant::now();
    let limit = arguments.budget.limit;
    if let Some(id) = &arguments.explain {
        return explain::run(id, arguments);
    }
    let documents = if arguments.inputs.is_empty() {
        input::catalogue(limit)?
    } else {
        input::load_all(&arguments.inputs, limit)?
    };
    let entries = check_all(&documents, limit)?;
    let output = match arguments.format {
        Format::Text => text::output(&entries, start.elapsed()),
        Format::Json => json::output(&entries),
    };
    console::print(&output)?;
    Ok(status(entries.iter().flat_map(|entry| &entry.judgements)).into())
}

fn check_all(documents: &[Document], limit: u64) -> Result<Vec<Entry>, Failure> {
    let progress = Progress::new();
    let (mut entries, mut failures) = (Vec::new(), Vec::new());
    for document in documents {
        let mut diagnostics = Diagnostics::new();
        let mut left = limit.saturating_mul(FULL_CLAIMS);
        for model in document.models() {
            progress.show(&format!("checking {}", model.name));
            let entry = check(model, &mut left, &mut diagnostics);
            match (&model.piece, entries.last_mut()) {
                (Some(piece), Some(whole)) if piece.index > 0 => Entry::extend(whole, entry),
                _ => entries.push(entry),
            }
        }
        if !diagnostics.is_empty() {
            failures.push(Failure::Report(Box::new(Report::new(document.source.clone(), diagnostics))));
        }
    }
    if failures.is_empty() { Ok(entries) } else { Err(Failure::Several(failures)) }
}

/// The verdicts on the claims of a model, whose file has `left` units of work for all of its claims.
fn check(model: &Model, left: &mut u64, diagnostics: &mut Diagnostics) -> Entry {
    let degrees = model.surface.as_ref().and_then(|surface| {
        let homogeneous = match budget::with_budget(model.limit, || surface.homogeneous().clone()) {
            Ok(homogeneous) => homogeneous,
            Err(exhausted) => {
                diagnostics.push(Diagnostic::new(model.place, exhausted.to_string()));
                return None;
            }
        };
        match budget::with_budget(model.limit, || surface.is_surface()) {
            Ok(true) => {}
            Ok(false) => diagnostics.push(Diagnostic::new(model.place, OffsetError::NoSurface.to_string())),
            Err(exhausted) => diagnostics.push(Diagnostic::new(model.place, exhausted.to_string())),
        }
        let (patch, raw) = (homogeneous.degree(), homogeneous.raw_degree());
        Some(Degrees { coordinates: homogeneous.degrees(), patch, raw })
    });
    let mut judgements = Vec::new();
    for claim in &model.claims {
        let (judgement, spent) = budget::measured(|| model.check(claim, model.limit.min(*left)));
        match judgement {
            Ok(mut judgement) => {
                if judgement.verdict == Verdict::Undecided && *left < model.limit {
                    judgement.derived +=
                        "; the claims of this file before it took much of what they have together";
                }
                judgements.push(judgement);
            }
            Err(diagnostic) => diagnostics.push(*diagnostic),
        }
        *left = left.saturating_sub(spent);
    }
    Entry {
        kind: model.kind,
        name: model.item_name().to_owned(),
        source: model.source.clone(),
        degrees,
        judgements,
    }
}

/// The exit status for these verdicts.
fn status<'a>(judgements: impl Iterator<Item = &'a Judgement> + Clone) -> u8 {
    let mut unexpected = judgements.filter(|judgement| !expected(judgement));
    let mut status = 0;
    // One claim that is wrong outranks any number of undecided ones.
    if unexpected.clone().any(|judgement| judgement.verdict == Verdict::Undecided) {
        status = UNDECIDED;
    }
    if unexpected.any(|judgement| judgement.verdict != Verdict::Undecided) {
        status = UNEXPECTED;
    }
    status
}

/// Whether the verdict is the one that the source expects.
fn expected(judgement: &Judgement) -> bool {
    judgement.verdict == judgement.expected
}

/// How long something took, for people.
fn seconds(duration: Duration) -> String {
    format!("{:.1} s", duration.as_secs_f64())
}

#[cfg(test)]
mod tests {
    use super::*;

    pub(super) fn judgement(id: &str, verdict: Verdict, expected: Verdict) -> Judgement {
        Judgement {
            id: id.to_owned(),
            sweep: "s".to_owned(),
            source: Some("a book".to_owned()),
            statement: "degree(X) == (2, 9)".to_owned(),
            notes: vec!["a note".to_owned()],
            instead: None,
            effect: None,
            verdict,
            scope: "the sweep s".to_owned(),
            condition: None,
            expected,
            derived: "(2, 8)".to_owned(),
            witness: (verdict == Verdict::Refuted).then(|| "u = 1/2: left 1, right 2".to_owned()),
        }
    }

    pub(super) fn entry(judgements: Vec<Judgement>) -> Entry {
        Entry { kind: ItemKind::Lemma, name: "s".to_owned(), source: None, degrees: None, judgements }
    }

    #[test]
    fn what_is_wrong_outranks_what_is_undecided() {
        use Verdict::{Proved, Refuted, Undecided};
        let of = |pairs: &[(Verdict, Verdict)]| {
            let judgements: Vec<Judgement> =
                pairs.iter().map(|(verdict, expected)| judgement("a", *verdict, *expected)).collect();
            status(judgements.iter())
        };
        assert_eq!(of(&[]), 0);
        assert_eq!(of(&[(Proved, Proved), (Refuted, Refuted), (Undecided, Undecided)]), 0);
        assert_eq!(of(&[(Refuted, Proved)]), 1);
        assert_eq!(of(&[(Proved, Refuted)]), 1);
        assert_eq!(of(&[(Proved, Undecided)]), 1);
        assert_eq!(of(&[(Undecided, Proved), (Proved, Proved)]), 3);
        assert_eq!(of(&[(Undecided, Refuted), (Refuted, Proved)]), 1);
        assert_eq!(of(&[(Refuted, Undecided), (Undecided, Proved)]), 1);
    }
}
