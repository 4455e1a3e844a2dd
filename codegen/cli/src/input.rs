//! Formulas: from files, standard input and the catalogue.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use hodograph_codegen::language::ast::{self, ItemKind};
use hodograph_codegen::language::{MAX_LENGTH, Report, Source, closest, decode, parse_text, read_input};
use hodograph_codegen::meaning::{Model, models_within};

use crate::failure::Failure;

/// The name that stands for standard input.
const STANDARD_INPUT: &str = "-";

/// A source with all that it means, and the items of it that were asked for.
#[derive(Debug)]
pub(crate) struct Document {
    /// The text, which resolves places.
    pub source: Source,
    /// What it says.
    pub file: ast::File,
    /// What it means: a model for each item, or for each of its pieces.
    models: Vec<Model>,
    /// The item that was asked for by its name, if it was.
    selected: Option<String>,
}

impl Document {
    /// The models that were asked for, in the order of the source.
    pub(crate) fn models(&self) -> impl Iterator<Item = &Model> {
        self.models.iter().filter(|model| self.selected.as_ref().is_none_or(|name| is_called(model, name)))
    }

    /// The sweeps that were asked for: all, or the one named `sweep`.
    ///
    /// # Errors
    /// No sweep of that name, or none at all.
    pub(crate) fn sweeps(&self, sweep: Option<&str>) -> Result<Vec<&Model>, Failure> {
        let name = self.source.name();
        let named = match sweep {
            Some(wanted) => {
                let named: Vec<&Model> =
                    self.models.iter().filter(|model| is_called(model, wanted)).collect();
                if named.is_empty() {
                    let sweeps = self.models.iter().filter(|model| model.kind == ItemKind::Sweep);
                    let mut sweeps: Vec<&str> = sweeps.map(Model::item_name).collect();
                    sweeps.dedup();
                    let failure = Failure::new(format!("{name} has no sweep `{wanted}`"));
                    return Err(failure.help(suggestion(wanted, &sweeps)));
                }
                named
            }
            None => self.models().collect(),
        };
        let asked = sweep.or(self.selected.as_deref());
        if let (Some(asked), [model]) = (asked, named.as_slice())
            && model.kind == ItemKind::Lemma
        {
            let failure = Failure::new(format!("`{asked}` is a lemma, so it has no surface"));
            return Err(failure.help("`hodograph verify` checks what a lemma claims"));
        }
        let sweeps: Vec<&Model> = named.into_iter().filter(|model| model.kind == ItemKind::Sweep).collect();
        if sweeps.is_empty() {
            let failure = Failure::new(format!("{name} has only lemmas, so it has no surface"));
            return Err(failure.help("`hodograph verify` checks what they claim"));
        }
        Ok(sweeps)
    }

    /// The only sweep that was asked for, by its pieces: one, or several in their order.
    ///
    /// # Errors
    /// As [`Document::sweeps`]; several sweeps to choose from.
    pub(crate) fn sweep(&self, sweep: Option<&str>) -> Result<Vec<&Model>, Failure> {
        let sweeps = self.sweeps(sweep)?;
        let first = sweeps.first().map(|model| model.item_name());
        match sweeps.iter().all(|model| Some(model.item_name()) == first) {
            true => Ok(sweeps),
            false => {
                let mut names: Vec<&str> = sweeps.iter().map(|model| model.item_name()).collect();
                names.dedup();
                let failure = Failure::new(format!("{} has several sweeps", self.source.name()));
                Err(failure.help(format!("choose one with --sweep: {}", names.join(", "))))
            }
        }
    }

    /// The item that a model of this document stands for.
    pub(crate) fn item(&self, model: &Model) -> Option<&ast::Item> {
        self.file.items.iter().find(|item| item.name.value == model.item_name())
    }
}

/// Whether a model is called so: by its own name, or by that of the item that it is a piece of.
fn is_called(model: &Model, name: &str) -> bool {
    model.name == name || model.item_name() == name
}

/// The document at `input`: a path, `-`, or the name of a sweep, a lemma or a file of the catalogue.
///
/// What exists as a file, has a path separator or ends in `.sweep` is a path. Its definitions may take `limit` units of work.
///
/// # Errors
/// Nothing of that name; a file that cannot be read; all mistakes in it.
pub(crate) fn load(input: &str, limit: u64) -> Result<Document, Failure> {
    if input == STANDARD_INPUT {
        let bytes = bounded(io::stdin(), "standard input")?;
        return document("<standard input>", &bytes, limit, |name| beside(Path::new(""), name));
    }
    let path = Path::new(input);
    let is_path = input.contains(std::path::is_separator) || input.ends_with(".sweep");
    // A directory may happen to have the name of an entry.
    if is_path || path.is_file() {
        return document(input, &read(path, input)?, limit, |name| beside(path, name));
    }
    match entry(input, limit)? {
        Some(document) => Ok(document),
        None if path.exists() => document(input, &read(path, input)?, limit, |name| beside(path, name)),
        None => Err(unknown(input)),
    }
}

/// All documents of the catalogue, in its order; the definitions of each may take `limit` units of work.
///
/// # Errors
/// Mistakes in a formula of the catalogue.
pub(crate) fn catalogue(limit: u64) -> Result<Vec<Document>, Failure> {
    selection(limit, |_| true)
}

/// The documents of the catalogue whose syntax trees are `wanted`: only their definitions are evaluated.
///
/// # Errors
/// Mistakes in a formula of the catalogue.
pub(crate) fn selection(
    limit: u64,
    mut wanted: impl FnMut(&ast::File) -> bool,
) -> Result<Vec<Document>, Failure> {
    let mut documents = Vec::new();
    for source in hodograph::sources() {
        let name = file_name(source.name);
        if wanted(&parse_text(&name, source.text)?.0) {
            documents.push(document(&name, source.text.as_bytes(), limit, catalogued)?);
        }
    }
    Ok(documents)
}

/// All claims of a syntax tree, each with the name of its item.
pub(crate) fn claims(file: &ast::File) -> impl Iterator<Item = (&str, &ast::Claim)> {
    file.items.iter().flat_map(|item| {
        let claims = item.clauses.iter().filter_map(|clause| match &clause.kind {
            ast::ClauseKind::Claim(claim) => Some(claim),
            _ => None,
        });
        claims.map(|claim| (item.name.value.as_str(), claim))
    })
}

/// The documents at all inputs, as [`load`] gives them.
///
/// # Errors
/// The failures of all inputs together.
pub(crate) fn load_all(inputs: &[String], limit: u64) -> Result<Vec<Document>, Failure> {
    let mut documents = Vec::new();
    let mut failures = Vec::new();
    for input in inputs {
        match load(input, limit) {
            Ok(document) => documents.push(document),
            Err(failure) => failures.push(failure),
        }
    }
    if failures.is_empty() { Ok(documents) } else { Err(Failure::Several(failures)) }
}

/// The entry of the catalogue with this name: an item, else a file.
fn entry(name: &str, limit: u64) -> Result<Option<Document>, Failure> {
    let mut whole = None;
    for source in hodograph::sources() {
        let named = file_name(source.name);
        let (file, _) = parse_text(&named, source.text)?;
        if file.items.iter().any(|item| item.name.value == name) {
            let document = document(&named, source.text.as_bytes(), limit, catalogued)?;
            return Ok(Some(Document { selected: Some(name.to_owned()), ..document }));
        }
        if source.name == name {
            whole = Some(document(&named, source.text.as_bytes(), limit, catalogued)?);
        }
    }
    Ok(whole)
}

fn unknown(input: &str) -> Failure {
    let parsed = hodograph::sources().iter().filter_map(|source| parse_text(source.name, source.text).ok());
    let items: Vec<String> =
        parsed.flat_map(|(file, _)| file.items.into_iter().map(|item| item.name.value)).collect();
    let files = hodograph::sources().iter().map(|source| source.name);
    let names: Vec<&str> = items.iter().map(String::as_str).chain(files).collect();
    let failure =
        Failure::new(format!("there is neither a file nor an entry of the catalogue named `{input}`"));
    failure.help(match closest(input, names) {
        Some(similar) => format!("did you mean `{similar}`?"),
        None => "`hodograph verify` lists the catalogue; a file is given by its path".to_owned(),
    })
}

fn suggestion(wanted: &str, known: &[&str]) -> String {
    match closest(wanted, known.iter().copied()) {
        Some(similar) => format!("did you mean `{similar}`?"),
        None if known.is_empty() => "it has only lemmas".to_owned(),
        None => format!("it has {}", known.join(", ")),
    }
}

fn file_name(stem: &str) -> String {
    format!("{stem}.sweep")
}

fn read(path: &Path, name: &str) -> Result<Vec<u8>, Failure> {
    if path.is_dir() {
        return Err(Failure::new(format!("{name} is a directory")).help("give a file in the sweep language"));
    }
    bounded(File::open(path).map_err(|error| Failure::io("read", name, &error))?, name)
}

/// All bytes of a source, or a failure if there are too many of them.
fn bounded(reader: impl Read, name: &str) -> Result<Vec<u8>, Failure> {
    let mut bytes = Vec::new();
    let limit = u64::try_from(MAX_LENGTH).unwrap_or(u64::MAX);
    // Room for a byte-order mark, and for one byte that is too many.
    reader.take(limit + 4).read_to_end(&mut bytes).map_err(|error| Failure::io("read", name, &error))?;
    if bytes.len() > MAX_LENGTH + 3 {
        let failure = Failure::new(format!("{name} is longer than the limit of {MAX_LENGTH} bytes"));
        return Err(failure.help("split it into several files"));
    }
    Ok(bytes)
}

/// The text of a file of data that stands beside a formula.
fn beside(formula: &Path, name: &str) -> Result<String, String> {
    let path = formula.parent().unwrap_or(Path::new("")).join(name);
    read_input(&path, name)
}

/// The text of a file of data of the catalogue.
fn catalogued(name: &str) -> Result<String, String> {
    let found = hodograph::inputs().iter().find(|input| input.name == name);
    found.map(|input| input.text.to_owned()).ok_or_else(|| "the catalogue has no such file".to_owned())
}

fn document(
    name: &str,
    bytes: &[u8],
    limit: u64,
    read: impl FnMut(&str) -> Result<String, String>,
) -> Result<Document, Failure> {
    let (mut file, source) = parse_text(name, decode(name, bytes)?)?;
    file.attach(read);
    let (models, diagnostics) = models_within(&file, limit);
    if !diagnostics.is_empty() {
        return Err(Failure::Report(Box::new(Report::new(source, diagnostics))));
    }
    Ok(Document { source, file, models, selected: None })
}
