//! The page of the claims that are refuted: up to date, and complete.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

use hodograph_codegen::language::ast::{Claim, Verdict};
use hodograph_tests::build::built;
use hodograph_tests::catalogue::files;

/// The page, with the lines of each formula joined.
fn page() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../generated/documentation/errors.md");
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    text.replace("\n    ", " ")
}

/// The claims of the catalogue that are expected to be refuted.
fn refuted() -> Vec<Claim> {
    let claims = files().into_iter().flat_map(|file| file.models).flat_map(|model| model.claims);
    let expected = |claim: &Claim| claim.expected.as_ref().is_some_and(|it| it.value == Verdict::Refuted);
    let refuted: Vec<Claim> = claims.filter(expected).collect();
    assert!(!refuted.is_empty());
    refuted
}

#[test]
fn the_page_is_what_the_command_writes() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let output = Command::new(&built().binary)
        .args(["errors", "-o", "generated/documentation/errors.md", "--check"])
        .current_dir(folder)
        .output()
        .unwrap_or_else(|error| panic!("{error}"));
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn no_refuted_claim_is_missing() {
    let page = page();
    let sections: BTreeSet<&str> = page.lines().filter_map(|line| line.strip_prefix("## ")).collect();
    for claim in refuted() {
        assert!(sections.contains(claim.id.value.as_str()), "{} has no section", claim.id.value);
        let statement = claim.relation.to_string();
        assert!(page.contains(&format!("```text\n{statement}\n```")), "{}: {statement}", claim.id.value);
    }
}

#[test]
fn sections_stand_in_the_order_of_severity() {
    let page = page();
    let severities = page.lines().filter_map(|line| line.strip_prefix("Severity: "));
    let rank = |word: &str| ["major.", "moderate.", "minor."].iter().position(|known| *known == word);
    let ranks: Vec<Option<usize>> = severities.map(rank).collect();
    assert!(ranks.iter().all(Option::is_some) && ranks.is_sorted(), "{ranks:?}");
    assert!(!ranks.is_empty());
}

#[test]
fn every_section_says_what_it_means_for_a_user() {
    let refuted = refuted();
    let ids: BTreeSet<&str> = refuted.iter().map(|claim| claim.id.value.as_str()).collect();
    let explained = refuted.iter().filter(|claim| claim.effect.is_some());
    let explained: BTreeSet<&str> = explained.map(|claim| claim.id.value.as_str()).collect();
    let silent: Vec<_> = ids.difference(&explained).collect();
    assert!(silent.is_empty(), "add `effect …` to a clause of {silent:?}");
}

/// The ids of the claims that the papers make, one a line.
const CLAIMS: &str = include_str!("claims.txt");

#[test]
fn every_claim_of_the_papers_is_settled() {
    let claims = files().into_iter().flat_map(|file| file.models).flat_map(|model| model.claims);
    let settled: BTreeSet<String> = claims.map(|claim| claim.id.value).collect();
    let missing: Vec<&str> = CLAIMS.lines().filter(|id| !settled.contains(*id)).collect();
    assert!(missing.is_empty(), "no claim has the id {missing:?}");
    assert_eq!(
        CLAIMS.lines().collect::<BTreeSet<_>>().len(),
        CLAIMS.lines().count(),
        "an id is listed twice"
    );
}
