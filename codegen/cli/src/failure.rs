//! Why the command could not do what it was asked for.

use std::io;

use hodograph_codegen::language::{Diagnostic, Diagnostics, Report, Source};

/// The exit status for bad usage and bad input.
pub(crate) const BAD_INPUT: u8 = 2;

/// Why the command could not do what it was asked for.
#[derive(Debug)]
pub(crate) enum Failure {
    /// Something that no place in a source belongs to, and what to do about it.
    Message {
        /// What is wrong.
        message: String,
        /// What to do.
        help: Option<String>,
    },
    /// Mistakes in a source.
    Report(Box<Report>),
    /// Failures of several inputs.
    Several(Vec<Failure>),
}

impl Failure {
    /// A failure without a place.
    pub(crate) fn new(message: impl Into<String>) -> Failure {
        Failure::Message { message: message.into(), help: None }
    }

    /// The same with what to do.
    pub(crate) fn help(self, text: impl Into<String>) -> Failure {
        match self {
            Failure::Message { message, .. } => Failure::Message { message, help: Some(text.into()) },
            other => other,
        }
    }

    /// A failure of the operating system while `doing` something to `name`.
    pub(crate) fn io(doing: &str, name: &str, error: &io::Error) -> Failure {
        Failure::new(format!("cannot {doing} {name}: {error}"))
    }

    /// One mistake in a source.
    pub(crate) fn at(source: &Source, diagnostic: Diagnostic) -> Failure {
        let mut diagnostics = Diagnostics::new();
        diagnostics.push(diagnostic);
        Failure::Report(Box::new(Report::new(source.clone(), diagnostics)))
    }
}

impl From<Box<Report>> for Failure {
    fn from(report: Box<Report>) -> Failure {
        Failure::Report(report)
    }
}
