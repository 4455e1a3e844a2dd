//! `hodograph emit`: the generated source.

use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use hodograph_codegen::compile::compile_all;
use hodograph_codegen::emit;
use hodograph_codegen::language::{Diagnostic, Diagnostics, Report};
use quote::quote;

use crate::args::{EmitArguments, Target};
use crate::console::{self, Progress};
use crate::failure::Failure;
use crate::input::{self, Document};

/// The exit status if the file differs from what would be written.
const DIFFERENT: u8 = 1;

/// Runs the command.
///
/// # Errors
/// Bad input; a surface without evaluator; a file that cannot be written.
pub(crate) fn run(arguments: &EmitArguments) -> Result<ExitCode, Failure> {
    let document = input::load(&arguments.input.input, arguments.budget.limit)?;
    let text = source(&document, arguments)?;
    match &arguments.output {
        None => console::print(&text)?,
        Some(path) if arguments.check => return check(path, &text, arguments),
        Some(path) => write(path, &text)?,
    }
    Ok(ExitCode::SUCCESS)
}

/// The source of all sweeps that were asked for.
fn source(document: &Document, arguments: &EmitArguments) -> Result<String, Failure> {
    let progress = Progress::new();
    let mut artifacts = Vec::new();
    let mut diagnostics = Diagnostics::new();
    let models = document.sweeps(arguments.input.sweep.as_deref())?;
    let shown = models.into_iter().inspect(|model| progress.show(&format!("compiling {}", model.name)));
    for (model, artifact) in compile_all(shown) {
        match artifact {
            Ok(artifact) => artifacts.push(artifact),
            Err(error) => diagnostics.push(Diagnostic::new(model.place, error.to_string())),
        }
    }
    if !diagnostics.is_empty() {
        return Err(Failure::Report(Box::new(Report::new(document.source.clone(), diagnostics))));
    }
    if arguments.target == Target::C {
        return Ok(emit::header(&artifacts));
    }
    let text = if arguments.standalone {
        let runtime: Vec<(&str, &str)> =
            hodograph::runtime().iter().map(|file| (file.name, file.text)).collect();
        emit::standalone(&artifacts, &runtime)
    } else {
        emit::format(emit::modules(&artifacts, &quote!(::hodograph)))
    };
    text.map_err(|error| Failure::new(format!("the generated source is not valid Rust: {error}")))
}

/// Compares a file with what would be written.
fn check(path: &Path, text: &str, arguments: &EmitArguments) -> Result<ExitCode, Failure> {
    let name = path.display();
    let difference = match fs::read(path) {
        Ok(bytes) if bytes == text.as_bytes() => return Ok(ExitCode::SUCCESS),
        Ok(bytes) => match first_difference(&bytes, text) {
            Some(line) => format!("{name} differs from what its formula gives, first in line {line}"),
            None => format!("{name} differs from what its formula gives"),
        },
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => format!("{name} does not exist"),
        Err(error) => return Err(Failure::io("read", &name.to_string(), &error)),
    };
    console::report(&Failure::new(difference).help(format!("`{}` mends it", mending(path, arguments))));
    Ok(DIFFERENT.into())
}

/// The number of the first line that differs, if the bytes are a text.
fn first_difference(bytes: &[u8], text: &str) -> Option<usize> {
    let old = std::str::from_utf8(bytes).ok()?;
    let same = old.lines().zip(text.lines()).take_while(|(a, b)| a == b).count();
    Some(same + 1)
}

/// The command that writes the file.
fn mending(path: &Path, arguments: &EmitArguments) -> String {
    let mut command = format!("hodograph emit {}", quoted(&arguments.input.input));
    if let Some(sweep) = &arguments.input.sweep {
        command += &format!(" --sweep {}", quoted(sweep));
    }
    command += match arguments.target {
        Target::Rust => " --target rust",
        Target::C => " --target c",
    };
    if arguments.standalone {
        command += " --standalone";
    }
    format!("{command} -o {}", quoted(&path.display().to_string()))
}

/// An argument as a POSIX shell reads it.
fn quoted(argument: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "-_./:+,@".contains(c);
    if !argument.is_empty() && argument.chars().all(plain) {
        argument.to_owned()
    } else {
        format!("'{}'", argument.replace('\'', "'\\''"))
    }
}

/// Writes a file all at once: whoever reads it finds the old text or the new one, also after a failure.
fn write(path: &Path, text: &str) -> Result<(), Failure> {
    let name = path.display().to_string();
    let failed = |error: &std::io::Error| Failure::io("write", &name, error);
    if path.is_dir() {
        return Err(Failure::new(format!("{name} is a directory")).help("give the path of a file"));
    }
    // What a link points at is replaced, not the link.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    let existing = fs::metadata(&target).ok();
    if existing.as_ref().is_some_and(|metadata| !metadata.is_file()) {
        // Pipes and devices cannot be replaced.
        let mut file = File::options().write(true).open(&target).map_err(|error| failed(&error))?;
        return file.write_all(text.as_bytes()).map_err(|error| failed(&error));
    }
    let directory = match target.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_path_buf(),
        _ => PathBuf::from("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".hodograph");
    if let Some(permissions) = permissions(existing.as_ref()) {
        builder.permissions(permissions);
    }
    let mut file = builder.tempfile_in(&directory).map_err(|error| failed(&error))?;
    file.write_all(text.as_bytes())
        .and_then(|()| file.as_file().sync_all())
        .map_err(|error| failed(&error))?;
    file.persist(&target).map_err(|error| failed(&error.error))?;
    Ok(())
}

/// The permissions of the new file: those of the old one, or the usual ones.
#[cfg(unix)]
fn permissions(existing: Option<&fs::Metadata>) -> Option<fs::Permissions> {
    use std::os::unix::fs::PermissionsExt;
    let usual = || fs::Permissions::from_mode(0o666);
    Some(existing.map_or_else(usual, fs::Metadata::permissions))
}

/// The permissions of the new file: those that the system gives.
#[cfg(not(unix))]
fn permissions(_existing: Option<&fs::Metadata>) -> Option<fs::Permissions> {
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_replaced_whole() -> Result<(), Box<dyn std::error::Error>> {
        let directory = tempfile::tempdir()?;
        let path = directory.path().join("a.rs");
        for text in ["fn a() {}\n", "", "fn b() {}\n"] {
            assert!(write(&path, text).is_ok());
            assert_eq!(fs::read_to_string(&path)?, text);
        }
        assert_eq!(fs::read_dir(directory.path())?.count(), 1, "no temporary file is left");
        assert!(write(directory.path(), "").is_err());
        assert!(write(&directory.path().join("none/a.rs"), "").is_err());
        Ok(())
    }

    #[test]
    fn arguments_are_quoted_for_a_shell() {
        assert_eq!(quoted("a/b-c_1.sweep"), "a/b-c_1.sweep");
        assert_eq!(quoted("it's a file"), "'it'\\''s a file'");
        assert_eq!(quoted(""), "''");
    }

    #[test]
    fn differences_are_found_by_line() {
        assert_eq!(first_difference(b"a\nb\nc\n", "a\nx\nc\n"), Some(2));
        assert_eq!(first_difference(b"a\n", "a\nb\n"), Some(2));
        assert_eq!(first_difference(b"\xff", "a"), None);
    }
}
