//! Standard output and standard error.

use std::io::{self, IsTerminal, Write};

use crate::failure::Failure;

/// Writes data to standard output. A reader that has gone away is no failure.
///
/// # Errors
/// Any other failure to write.
pub(crate) fn print(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(Failure::io("write to", "standard output", &error))
        }
        _ => Ok(()),
    }
}

/// Writes a failure to standard error.
pub(crate) fn report(failure: &Failure) {
    match failure {
        Failure::Message { message, help } => {
            complain(&format!("{} {message}", styled("error:", "1;91")));
            if let Some(help) = help {
                complain(&format!("{} {help}", styled("help:", "1;96")));
            }
        }
        Failure::Report(report) => {
            complain(&if colors() { report.colored() } else { report.to_string() });
        }
        Failure::Several(failures) => failures.iter().for_each(self::report),
    }
}

/// Writes a remark to standard error.
pub(crate) fn note(text: &str) {
    complain(&format!("{} {text}", styled("note:", "1;92")));
}

/// What is under way, on one line of a terminal that the next one replaces; elsewhere nothing.
#[derive(Debug)]
pub(crate) struct Progress {
    shown: bool,
}

impl Progress {
    /// Nothing yet.
    pub(crate) fn new() -> Progress {
        Progress { shown: io::stderr().is_terminal() }
    }

    /// Shows what is under way.
    pub(crate) fn show(&self, text: &str) {
        if self.shown {
            // A closed standard error leaves nobody to tell.
            let _ = write!(io::stderr(), "\r\u{1b}[K{text}");
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.show("");
    }
}

fn complain(text: &str) {
    // A closed standard error leaves nobody to tell.
    let _ = writeln!(io::stderr(), "{text}");
}

/// Whether standard error shows colors: on a terminal, unless `NO_COLOR` is set and not empty (no-color.org).
fn colors() -> bool {
    io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
}

fn styled(text: &str, style: &str) -> String {
    if colors() { format!("\u{1b}[{style}m{text}\u{1b}[0m") } else { text.to_owned() }
}
