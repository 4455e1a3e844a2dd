//! The catalogue's files with all that is derived from them.

use std::path::{Path, PathBuf};

use hodograph_algebra::Derivation;
use hodograph_codegen::compile;
use hodograph_codegen::language::ast::{File, ItemKind};
use hodograph_codegen::language::{Report, Source, decode, parse_text};
use hodograph_codegen::meaning::{Model, models};

/// A file of formulas, read and understood.
#[derive(Clone, Debug)]
pub struct Formulas {
    /// The name of the file without its extension.
    pub stem: String,
    /// Its text.
    pub text: String,
    /// Its syntax tree.
    pub file: File,
    /// Where its spans are.
    pub source: Source,
    /// Its sweeps and lemmas.
    pub models: Vec<Model>,
}

/// A sweep of the catalogue that has an evaluator, with what is derived from its formula.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Its meaning.
    pub model: Model,
    /// Everything derived.
    pub derivation: Derivation,
}

/// The folder of the catalogue's formulas.
#[must_use]
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../generated/formulas")
}

/// The paths of the catalogue's files, sorted.
///
/// # Panics
/// If the folder cannot be read.
#[must_use]
pub fn paths() -> Vec<PathBuf> {
    let entries =
        std::fs::read_dir(folder()).unwrap_or_else(|error| panic!("{}: {error}", folder().display()));
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "sweep"));
    paths.sort();
    assert!(!paths.is_empty(), "the catalogue is empty");
    paths
}

/// All files of the catalogue, by name.
///
/// # Panics
/// With the report of the mistakes in a file.
#[must_use]
pub fn files() -> Vec<Formulas> {
    paths().iter().map(|path| read(path)).collect()
}

fn read(path: &Path) -> Formulas {
    let name = path.display().to_string();
    let bytes = std::fs::read(path).unwrap_or_else(|error| panic!("{name}: {error}"));
    let text = decode(&name, &bytes).unwrap_or_else(|report| panic!("{report}"));
    let (file, source) = parse_text(&name, text).unwrap_or_else(|report| panic!("{report}"));
    let (models, diagnostics) = models(&file);
    assert!(diagnostics.is_empty(), "{}", Report::new(source, diagnostics));
    let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    Formulas { stem, text: text.to_owned(), file, source, models }
}

impl Formulas {
    /// Whether the file is expanded to evaluators: it holds sweeps alone, and no symbol occurs in their surfaces. Other
    /// files are there for their claims.
    #[must_use]
    pub fn is_expanded(&self) -> bool {
        let has_numbers =
            |model: &Model| model.surface.as_ref().is_some_and(|surface| surface.symbols().is_empty());
        self.models.iter().all(|model| model.kind == ItemKind::Sweep && has_numbers(model))
    }
}

/// The derivation of every sweep, those of claim-only files too, by file and place.
#[must_use]
pub fn sweeps() -> Vec<Entry> {
    derived(files())
}

/// The sweeps that have an evaluator.
#[must_use]
pub fn entries() -> Vec<Entry> {
    let mut files = files();
    files.retain(Formulas::is_expanded);
    derived(files)
}

fn derived(files: Vec<Formulas>) -> Vec<Entry> {
    let models = files.into_iter().flat_map(|formulas| formulas.models);
    let derived = |model: Model| {
        let derivation = compile::derive(&model).unwrap_or_else(|error| panic!("{}: {error}", model.name));
        Entry { model, derivation }
    };
    models.filter(|model| model.kind == ItemKind::Sweep).map(derived).collect()
}
