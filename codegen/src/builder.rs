//! Sweeps compiled by a build script.

use std::fmt;
use std::path::{Path, PathBuf};

use crate::compile::expand;
use crate::emit;
use crate::language::{Report, decode, parse_text, read_input};

/// Compiles `.sweep` files from a build script into `OUT_DIR`: an alternative to the macro, with the same output, that shows the
/// generated text and leaves the choice of profile to `build-override`.
///
/// A file `formulas/saddle.sweep` becomes `OUT_DIR/saddle.rs`, which the crate includes:
///
/// ```text
/// include!(concat!(env!("OUT_DIR"), "/saddle.rs"));
/// ```
///
/// The items need the crate `hodograph` at run time, as those of the macro do. Cargo runs the script again when a file changes.
///
/// # Example
/// ```
/// use hodograph_codegen::Builder;
/// # let folder = std::env::temp_dir().join(format!("hodograph-builder-{}", std::process::id()));
/// # std::fs::create_dir_all(&folder).unwrap();
/// # let file = folder.join("saddle.sweep");
/// # std::fs::write(&file, "sweep saddle { surface R = (u, v, u*v); domain u in 0..1, v in 0..1; }").unwrap();
/// // In build.rs there is an `OUT_DIR`, so that `to` is not needed.
/// let written = Builder::new().file(&file).to(&folder).build().unwrap();
/// assert_eq!(written, [folder.join("saddle.rs")]);
/// assert!(std::fs::read_to_string(&written[0]).unwrap().contains("pub mod saddle"));
/// # std::fs::remove_dir_all(&folder).unwrap();
/// ```
#[derive(Clone, Debug, Default)]
pub struct Builder {
    files: Vec<PathBuf>,
    folder: Option<PathBuf>,
}

impl Builder {
    /// A builder without files.
    #[must_use]
    pub fn new() -> Builder {
        Builder::default()
    }

    /// Adds a file of sweeps; build scripts run in the folder of `Cargo.toml`.
    #[must_use]
    pub fn file(mut self, path: impl AsRef<Path>) -> Builder {
        self.files.push(path.as_ref().to_path_buf());
        self
    }

    /// Writes to this folder instead of `OUT_DIR`.
    #[must_use]
    pub fn to(mut self, folder: impl AsRef<Path>) -> Builder {
        self.folder = Some(folder.as_ref().to_path_buf());
        self
    }

    /// Compiles all files, and gives the paths that were written, in the order of the files.
    ///
    /// # Errors
    /// [`BuildError`] for the first file that cannot be read, has mistakes, or cannot be written; its text shows all mistakes of
    /// that file at their places.
    pub fn build(&self) -> Result<Vec<PathBuf>, BuildError> {
        let folder = match &self.folder {
            Some(folder) => folder.clone(),
            None => std::env::var_os("OUT_DIR").map(PathBuf::from).ok_or_else(|| {
                BuildError(
                    "OUT_DIR is not set: run from a build script, or say a folder with `to`".to_string(),
                )
            })?,
        };
        let mut written = Vec::new();
        for path in &self.files {
            println!("cargo::rerun-if-changed={}", path.display());
            let text = text(path)?;
            let Some(stem) = path.file_stem() else {
                return Err(BuildError(format!("{} is not the path of a file", path.display())));
            };
            let target = folder.join(stem).with_extension("rs");
            if written.contains(&target) {
                let message =
                    format!("{}: another file is written to {} too", path.display(), target.display());
                return Err(BuildError(message));
            }
            std::fs::write(&target, text)
                .map_err(|error| BuildError(format!("cannot write {}: {error}", target.display())))?;
            written.push(target);
        }
        Ok(written)
    }
}

/// The generated text of a file.
fn text(path: &Path) -> Result<String, BuildError> {
    let name = path.display().to_string();
    let bytes = std::fs::read(path).map_err(|error| BuildError(format!("cannot read {name}: {error}")))?;
    let shown = |report: &Report| BuildError(report.to_string());
    let parsed = decode(&name, &bytes).and_then(|text| parse_text(&name, text));
    let (mut file, source) = parsed.map_err(|report| shown(&report))?;
    file.attach(|input| {
        let beside = path.parent().unwrap_or(Path::new("")).join(input);
        println!("cargo::rerun-if-changed={}", beside.display());
        read_input(&beside, input)
    });
    let (tokens, diagnostics) = expand(&file);
    if !diagnostics.is_empty() {
        return Err(shown(&Report::new(source, diagnostics)));
    }
    emit::format(tokens)
        .map_err(|error| BuildError(format!("{name}: the generated source is not valid: {error}")))
}

/// Why sweeps have not been compiled.
///
/// It is shown as its text by `{:?}` too, since this is how Cargo shows the error of a build script's `main`.
#[derive(Clone, PartialEq, Eq)]
pub struct BuildError(String);

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl fmt::Debug for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for BuildError {}

#[cfg(test)]
mod tests {
    use super::Builder;

    #[test]
    fn mistakes_are_shown_at_their_places() {
        let folder = std::env::temp_dir().join(format!("hodograph-builder-test-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let file = folder.join("wrong.sweep");
        std::fs::write(&file, "sweep wrong { surface R = (u, v, w); domain u in 0..1, v in 0..1; }").unwrap();
        let error = Builder::new().file(&file).to(&folder).build().unwrap_err();
        assert!(error.to_string().contains("wrong.sweep:1:34"), "{error}");
        assert!(!folder.join("wrong.rs").exists());
        let missing = Builder::new().file(folder.join("none.sweep")).to(&folder).build().unwrap_err();
        assert!(missing.to_string().contains("cannot read"), "{missing:?}");
        std::fs::write(&file, "sweep wrong { surface R = (u, v, u*v); domain u in 0..1, v in 0..1; }")
            .unwrap();
        let twice = Builder::new().file(&file).file(&file).to(&folder).build().unwrap_err();
        assert!(twice.to_string().contains("another file"), "{twice}");
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
