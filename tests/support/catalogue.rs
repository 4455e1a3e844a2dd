//! The catalogue's files with all that is derived from them.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use hodograph_algebra::{
    ControlNet, Derivation, DifferentialGeometry, Poly, Rational, SweptSurface, Variable,
};
use hodograph_codegen::compile;
use hodograph_codegen::language::ast::{File, ItemKind};
use hodograph_codegen::language::{Report, Source, decode, parse_text, read_input};
use hodograph_codegen::meaning::{Model, models};
use hodograph_codegen::round::exact;

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
    let (mut file, source) = parse_text(&name, text).unwrap_or_else(|report| panic!("{report}"));
    file.attach(|input| read_input(&folder().join(input), input));
    let (models, diagnostics) = models(&file);
    assert!(diagnostics.is_empty(), "{}", Report::new(source, diagnostics));
    let stem = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    Formulas { stem, text: text.to_owned(), file, source, models }
}

impl Formulas {
    /// Whether the file is expanded to evaluators: it holds sweeps alone. Other files are there for their claims.
    #[must_use]
    pub fn is_expanded(&self) -> bool {
        self.models.iter().all(|model| model.kind == ItemKind::Sweep)
    }
}

/// The derivation of every sweep, those of claim-only files too, by file and place.
#[must_use]
pub fn sweeps() -> Vec<Entry> {
    derived(files())
}

impl Entry {
    /// What derivatives tell of the surface.
    ///
    /// # Panics
    /// If the budget does not suffice for that.
    #[must_use]
    pub fn geometry(&self) -> &DifferentialGeometry {
        match &self.derivation.geometry {
            Ok(geometry) => geometry,
            Err(exhausted) => panic!("{}: {exhausted}", self.model.name),
        }
    }

    /// The control points.
    ///
    /// # Panics
    /// If the budget does not suffice for them.
    #[must_use]
    pub fn control_net(&self) -> &ControlNet {
        match &self.derivation.control_net {
            Ok(net) => net,
            Err(exhausted) => panic!("{}: {exhausted}", self.model.name),
        }
    }
}

/// The sweeps that have an evaluator and no symbols.
#[must_use]
pub fn entries() -> Vec<Entry> {
    let mut files = files();
    files.retain(Formulas::is_expanded);
    for formulas in &mut files {
        formulas.models.retain(|model| !is_family(model));
    }
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

/// The families of the catalogue: expanded sweeps with symbols in their surfaces.
#[must_use]
pub fn families() -> Vec<Model> {
    let models = files().into_iter().filter(Formulas::is_expanded).flat_map(|formulas| formulas.models);
    models.filter(is_family).collect()
}

fn is_family(model: &Model) -> bool {
    model.surface.as_ref().is_some_and(|surface| !surface.symbols().is_empty())
}

/// The derivation of a member of a family: its symbols are the very numbers that these floats are. Beside it the number by
/// which the family's homogeneous coordinates, with these values, are multiples of the member's.
///
/// # Panics
/// If a float is not finite, or the member is no surface.
#[must_use]
pub fn member(family: &Model, values: &BTreeMap<&str, f64>) -> (Derivation, Rational) {
    let surface = family.surface.as_ref().unwrap_or_else(|| panic!("{} has no surface", family.name));
    let values: BTreeMap<Variable, Rational> = values
        .iter()
        .map(|(name, float)| {
            let number = exact(*float).unwrap_or_else(|| panic!("{name} = {float} is no number"));
            (Variable::new(Variable::SYMBOL, name), number)
        })
        .collect();
    let fractions =
        values.iter().map(|(symbol, value)| (symbol.clone(), Poly::constant(value.clone()).into())).collect();
    let position = surface.position().map(|coordinate| {
        coordinate.substitute(&fractions).unwrap_or_else(|| panic!("{} divides by zero", family.name))
    });
    let member = SweptSurface::new(position, surface.parameters().clone(), surface.domain().clone());
    let derivation = member.derive().unwrap_or_else(|error| panic!("{}: {error}", family.name));
    let point: Vec<(&Variable, &Rational)> = values.iter().collect();
    let [generic, ..] = surface.homogeneous().coordinates();
    let [own, ..] = derivation.homogeneous.coordinates();
    let scale = generic.at(&point).exact_div(own).and_then(|quotient| quotient.to_rational());
    (derivation, scale.unwrap_or_else(|| panic!("{}: the degree is not generic", family.name)))
}
