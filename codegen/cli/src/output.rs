//! Files that are written, or compared with what would be written.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use crate::console;
use crate::failure::Failure;

/// The exit status if the file differs from what would be written.
const DIFFERENT: u8 = 1;

/// Compares a file with what would be written, which the command `mending` does.
///
/// # Errors
/// A file that exists and cannot be read.
pub(crate) fn check(path: &Path, text: &str, mending: &str) -> Result<ExitCode, Failure> {
    let name = path.display();
    let difference = match fs::read(path) {
        Ok(bytes) if bytes == text.as_bytes() => return Ok(ExitCode::SUCCESS),
        Ok(bytes) => match first_difference(&bytes, text) {
            Some(line) => format!("{name} differs from what its formula gives, first in line {line}"),
            None => format!("{name} differs from what its formula gives"),
        },
        Err(error) if error.kind() == io::ErrorKind::NotFound => format!("{name} does not exist"),
        Err(error) => return Err(Failure::io("read", &name.to_string(), &error)),
    };
    console::report(&Failure::new(difference).help(format!("`{mending}` mends it")));
    Ok(DIFFERENT.into())
}

/// The number of the first line that differs, if the bytes are a text.
fn first_difference(bytes: &[u8], text: &str) -> Option<usize> {
    let old = std::str::from_utf8(bytes).ok()?;
    let same = old.lines().zip(text.lines()).take_while(|(a, b)| a == b).count();
    Some(same + 1)
}

/// An argument as a POSIX shell reads it.
pub(crate) fn quoted(argument: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "-_./:+,@".contains(c);
    if !argument.is_empty() && argument.chars().all(plain) {
        argument.to_owned()
    } else {
        format!("'{}'", argument.replace('\'', "'\\''"))
    }
}

/// Writes a file all at once: whoever reads it finds the old text or the new one, also after a failure.
///
/// # Errors
/// A file that cannot be written.
pub(crate) fn write(path: &Path, text: &str) -> Result<(), Failure> {
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
    if !directory.is_dir() {
        let failure =
            Failure::new(format!("cannot write {name}: there is no directory {}", directory.display()));
        return Err(failure.help("make the directory first, or give another path"));
    }
    let mut builder = tempfile::Builder::new();
    builder.prefix(".hodograph");
    if let Some(permissions) = permissions(existing.as_ref()) {
        builder.permissions(permissions);
    }
    let mut file = builder.tempfile_in(&directory).map_err(|error| failed(&cause(&error)))?;
    file.write_all(text.as_bytes())
        .and_then(|()| file.as_file().sync_all())
        .map_err(|error| failed(&cause(&error)))?;
    file.persist(&target).map_err(|error| failed(&error.error))?;
    Ok(())
}

/// What the operating system says, without the path of a temporary file.
fn cause(error: &io::Error) -> io::Error {
    error.raw_os_error().map_or_else(|| error.kind().into(), io::Error::from_raw_os_error)
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
    fn temporary_files_are_not_named() -> Result<(), Box<dyn std::error::Error>> {
        let directory = tempfile::tempdir()?;
        let Err(error) = tempfile::NamedTempFile::new_in(directory.path().join("none")) else {
            return Err("there is no directory".into());
        };
        assert!(error.to_string().contains("none"));
        assert!(!cause(&error).to_string().contains("none"), "{}", cause(&error));
        assert_eq!(cause(&error).kind(), error.kind());
        Ok(())
    }

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
        // Neither what is missing nor a file can hold one.
        for directory in ["none", "a.rs"].map(|name| directory.path().join(name)) {
            let path = directory.join("b.rs");
            let Err(Failure::Message { message, help }) = write(&path, "") else {
                return Err("there is no directory".into());
            };
            let (path, directory) = (path.display(), directory.display());
            assert_eq!(message, format!("cannot write {path}: there is no directory {directory}"));
            assert_eq!(help.as_deref(), Some("make the directory first, or give another path"));
        }
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
