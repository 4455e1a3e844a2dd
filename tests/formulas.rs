//! What is derived from every formula of the catalogue, and the verdict on every claim, as snapshots.

use std::collections::BTreeSet;
use std::path::Path;

use hodograph_codegen::language::ast::ItemKind;
use hodograph_tests::catalogue::{entries, families, files, sweeps};
use hodograph_tests::{layout, verdicts};

/// Compares with `snapshots/formulas__NAME.snap`.
fn compare(name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

#[test]
fn sweeps_are_derived_as_recorded() {
    for entry in sweeps() {
        compare(&entry.model.name, &layout::text(&entry));
    }
}

#[test]
fn claims_have_the_recorded_and_expected_verdicts() {
    let mut unexpected = Vec::new();
    let mut count = 0;
    for formulas in files() {
        let judgements = verdicts::judgements(&formulas);
        count += judgements.len();
        let wrong = judgements.iter().filter(|judgement| judgement.verdict != judgement.expected);
        unexpected.extend(wrong.map(|judgement| {
            let (id, statement) = (&judgement.id, &judgement.statement);
            format!("{id} in {} is {}: {statement}", judgement.sweep, judgement.verdict)
        }));
        if !judgements.is_empty() {
            compare(&format!("claims_{}", formulas.stem), &verdicts::text(&judgements));
        }
    }
    assert!(count > 0, "there are no claims");
    assert!(unexpected.is_empty(), "verdicts other than expected:\n{}", unexpected.join("\n"));
}

#[test]
fn the_library_holds_every_file() {
    let found: BTreeSet<(String, String)> = files().into_iter().map(|file| (file.stem, file.text)).collect();
    let sources = hodograph::sources();
    let held: BTreeSet<(String, String)> =
        sources.iter().map(|source| (source.name.to_owned(), source.text.to_owned())).collect();
    let names =
        |set: &BTreeSet<(String, String)>| set.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>();
    assert_eq!(names(&found), names(&held), "generated/formulas and generated/src/sources.rs");
    assert_eq!(sources.len(), held.len(), "a file is named twice");
    assert!(found == held, "a text is not up to date");
}

#[test]
fn every_sweep_has_an_evaluator() {
    let names = |names: Vec<String>| names.into_iter().collect::<BTreeSet<String>>();
    let sweeps = names(entries().into_iter().map(|entry| entry.model.name).collect());
    let surfaces = hodograph::catalogue::all();
    assert_eq!(sweeps, names(surfaces.iter().map(|surface| surface.name().to_owned()).collect()));
    assert_eq!(surfaces.len(), sweeps.len(), "a surface is there twice");
}

#[test]
fn names_are_unique_in_the_catalogue() {
    let mut names = BTreeSet::new();
    for formulas in files() {
        for model in &formulas.models {
            assert!(names.insert(model.name.clone()), "{} is defined twice", model.name);
        }
        let sweeps = formulas.models.iter().filter(|model| model.kind == ItemKind::Sweep).count();
        assert!(!formulas.is_expanded() || sweeps > 0, "{} has nothing to expand", formulas.stem);
    }
}

#[test]
fn every_snapshot_is_of_something() {
    let mut expected: BTreeSet<String> =
        sweeps().into_iter().map(|entry| format!("formulas__{}.snap", entry.model.name)).collect();
    let claims = |name: &String| format!("formulas__claims_{name}.snap");
    let has_claims =
        files().into_iter().filter(|file| file.models.iter().any(|model| !model.claims.is_empty()));
    expected.extend(has_claims.map(|file| claims(&file.stem)));
    let concrete = entries().into_iter().map(|entry| entry.model);
    for model in concrete.chain(families()) {
        let name = model.name;
        expected.extend([format!("codegen__{name}.snap"), format!("codegen__{name}_program.snap")]);
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("snapshots");
    let found: BTreeSet<String> = std::fs::read_dir(&folder)
        .unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
        .flatten()
        .map(|file| file.file_name().to_string_lossy().into_owned())
        .filter(|name| name.ends_with(".snap"))
        .collect();
    let missing: Vec<_> = expected.difference(&found).collect();
    let orphans: Vec<_> = found.difference(&expected).collect();
    assert!(missing.is_empty() && orphans.is_empty(), "missing: {missing:?}\nof nothing: {orphans:?}");
}
