//! Verdicts for people.

use std::collections::BTreeMap;
use std::time::Duration;

use hodograph_codegen::language::ast::{ItemKind, Verdict};
use hodograph_codegen::meaning::Judgement;

use super::{Entry, expected, seconds};
use crate::layout::{cut, wrapped};

/// How many characters of a derived value or a witness are shown.
const LONGEST: usize = 240;

/// The width of the column of ids, at least and at most.
const ID: [usize; 2] = [8, 24];

/// The width of the column of names of sweeps, at least and at most.
const NAME: [usize; 2] = [5, 44];

/// The table of sweeps, the verdicts by sweep and lemma, and the summary.
pub(super) fn output(entries: &[Entry], time: Duration) -> String {
    let mut parts = Vec::new();
    parts.extend(table(entries));
    let ids =
        entries.iter().flat_map(|entry| &entry.judgements).map(|judgement| judgement.id.chars().count());
    let id = ids.max().unwrap_or(0).clamp(ID[0], ID[1]);
    parts.extend(entries.iter().filter(|entry| !entry.judgements.is_empty()).map(|entry| claims(entry, id)));
    parts.push(summary(entries, id, time));
    parts.join("\n")
}

/// The degrees of all sweeps; nothing if there are none.
fn table(entries: &[Entry]) -> Option<String> {
    let sweeps: Vec<&Entry> = entries.iter().filter(|entry| entry.kind == ItemKind::Sweep).collect();
    let width = sweeps.iter().map(|entry| entry.name.chars().count()).max()?.clamp(NAME[0], NAME[1]);
    let row = |name: &str, cells: [String; 7]| {
        // A name that is too long has a line of its own.
        let (above, name) =
            if name.chars().count() > width { (format!("{name}\n"), "") } else { (String::new(), name) };
        let cells = cells.map(|cell| format!(" {cell:<7}")).concat();
        format!("{above}{}\n", format!("{name:<width$}{cells}").trim_end())
    };
    let mut text = row("sweep", ["W", "X", "Y", "Z", "patch", "raw", "claims"].map(str::to_owned));
    for entry in sweeps {
        let wrong = entry.judgements.iter().filter(|judgement| !expected(judgement)).count();
        let claims = match (entry.judgements.len(), wrong) {
            (0, _) => "none".to_owned(),
            (count, 0) => format!("{count} ok"),
            (count, wrong) => format!("{wrong} of {count} unexpected"),
        };
        let name = &entry.name;
        text += &match &entry.degrees {
            Some(degrees) => {
                let [w, x, y, z] = degrees.coordinates.map(|degree| degree.to_string());
                row(name, [w, x, y, z, degrees.patch.to_string(), degrees.raw.to_string(), claims])
            }
            None => row(name, ["?", "?", "?", "?", "?", "?", claims.as_str()].map(str::to_owned)),
        };
    }
    Some(text)
}

/// The verdicts on the claims of a sweep or lemma; `id` is the width of the column of ids.
fn claims(entry: &Entry, id: usize) -> String {
    let mut text = match &entry.source {
        Some(source) => wrapped(&format!("{} {}: ", entry.kind, entry.name), source),
        None => format!("{} {}", entry.kind, entry.name),
    };
    text.push('\n');
    for judgement in &entry.judgements {
        text += &claim(judgement, id);
    }
    text
}

fn claim(judgement: &Judgement, id: usize) -> String {
    let as_expected = expected(judgement);
    let mark = if as_expected { ' ' } else { '!' };
    let symbol = match judgement.verdict {
        Verdict::Proved => '✓',
        Verdict::Refuted => '✗',
        Verdict::Undecided => '?',
    };
    let condition = judgement.condition.as_ref().map_or_else(String::new, |c| format!(", when {c}"));
    let mut text = wrapped(
        &format!("{mark} {symbol} {:<id$} ", judgement.id),
        &format!("{}{condition}", judgement.statement),
    );
    text.push('\n');
    let mut detail = |title: &str, value: &str| {
        text += &wrapped(&format!("{:width$}{title}: ", "", width = id + 5), &cut(value, LONGEST));
        text.push('\n');
    };
    if as_expected && judgement.verdict == Verdict::Proved {
        return text;
    }
    let expectation =
        if as_expected { "as expected".to_owned() } else { format!("expected {}", judgement.expected) };
    detail(&judgement.verdict.to_string(), &expectation);
    detail("derived", &judgement.derived);
    if let Some(witness) = &judgement.witness {
        detail("witness", witness);
    }
    if judgement.verdict != Verdict::Undecided {
        detail("holds for", &judgement.scope);
    }
    for note in &judgement.notes {
        detail("note", note);
    }
    if let Some((severity, text)) = &judgement.effect {
        detail("effect", &format!("{severity}: {text}"));
    }
    text
}

fn summary(entries: &[Entry], id: usize, time: Duration) -> String {
    let all: Vec<&Judgement> = entries.iter().flat_map(|entry| &entry.judgements).collect();
    let sweeps = entries.iter().filter(|entry| entry.kind == ItemKind::Sweep).count();
    let lemmas = entries.len() - sweeps;
    let verdicts: Vec<Verdict> = all.iter().map(|judgement| judgement.verdict).collect();
    let ids = ids(&all);
    let ids: Vec<Verdict> = ids.into_values().collect();
    let mut text = format!(
        "{} and {}: {}\n{}: {}\n",
        counted(sweeps, "sweep"),
        counted(lemmas, "lemma"),
        tally(&verdicts, "clause"),
        "by id",
        tally(&ids, "claim"),
    );
    let wrong: Vec<&&Judgement> = all.iter().filter(|judgement| !expected(judgement)).collect();
    if wrong.is_empty() {
        text += &format!("all as expected, in {}\n", seconds(time));
    } else {
        let verb = if wrong.len() == 1 { "is" } else { "are" };
        text += &format!(
            "{} {verb} not as expected (marked with !), in {}\n",
            counted(wrong.len(), "clause"),
            seconds(time)
        );
        for judgement in wrong {
            let first = format!("! {:<id$} ", judgement.id);
            let what =
                format!("{}, expected {}, in {}", judgement.verdict, judgement.expected, judgement.sweep);
            text += &wrapped(&first, &what);
            text.push('\n');
        }
    }
    text
}

/// The verdict on each id: refuted if one of its clauses is, proved if all are.
fn ids<'a>(judgements: &[&'a Judgement]) -> BTreeMap<&'a str, Verdict> {
    let mut ids: BTreeMap<&str, Verdict> = BTreeMap::new();
    for judgement in judgements {
        let verdict = judgement.verdict;
        let entry = ids.entry(&judgement.id).or_insert(verdict);
        *entry = match (*entry, verdict) {
            (Verdict::Refuted, _) | (_, Verdict::Refuted) => Verdict::Refuted,
            (Verdict::Undecided, _) | (_, Verdict::Undecided) => Verdict::Undecided,
            (Verdict::Proved, Verdict::Proved) => Verdict::Proved,
        };
    }
    ids
}

fn tally(verdicts: &[Verdict], unit: &str) -> String {
    let count = |wanted: Verdict| verdicts.iter().filter(|verdict| **verdict == wanted).count();
    let (proved, refuted, undecided) =
        (count(Verdict::Proved), count(Verdict::Refuted), count(Verdict::Undecided));
    format!("{}, {proved} proved, {refuted} refuted, {undecided} undecided", counted(verdicts.len(), unit))
}

fn counted(count: usize, unit: &str) -> String {
    if count == 1 { format!("1 {unit}") } else { format!("{count} {unit}s") }
}

#[cfg(test)]
mod tests {
    use Verdict::{Proved, Refuted, Undecided};

    use super::super::tests::{entry, judgement};
    use super::*;

    #[test]
    fn an_id_is_refuted_if_one_clause_is() {
        let all = [
            judgement("a", Proved, Proved),
            judgement("a", Refuted, Refuted),
            judgement("b", Proved, Proved),
            judgement("c", Undecided, Undecided),
            judgement("c", Proved, Proved),
        ];
        let all: Vec<&Judgement> = all.iter().collect();
        assert_eq!(ids(&all), BTreeMap::from([("a", Refuted), ("b", Proved), ("c", Undecided)]));
    }

    #[test]
    fn what_is_unexpected_is_marked_and_explained() {
        let text = output(
            &[entry(vec![judgement("a", Refuted, Proved), judgement("b", Proved, Proved)])],
            Duration::ZERO,
        );
        let expected = "\
lemma s
! ✗ a        degree(X) == (2, 9)
             refuted: expected proved
             derived: (2, 8)
             witness: u = 1/2: left 1, right 2
             holds for: the sweep s
             note: a note
  ✓ b        degree(X) == (2, 9)

0 sweeps and 1 lemma: 2 clauses, 1 proved, 1 refuted, 0 undecided
by id: 2 claims, 1 proved, 1 refuted, 0 undecided
1 clause is not as expected (marked with !), in 0.0 s
! a        refuted, expected proved, in s
";
        assert_eq!(text, expected);
    }

    #[test]
    fn long_values_are_cut() {
        let mut long = judgement("a", Refuted, Refuted);
        long.derived = vec!["u^2*v^3"; 200].join(" + ");
        let text = claim(&long, 8);
        assert!(text.lines().all(|line| line.chars().count() <= crate::layout::WIDTH), "{text}");
        assert!(text.contains('…'));
    }
}
