//! The command `hodograph`: verifies, derives, evaluates and emits rational swept surfaces.
//!
//! Data go to standard output; errors, notes and progress to standard error. The exit status is 0 if all is as expected,
//! 1 if a claim is refuted or proved against expectation or `--check` finds a difference, 2 for bad usage or bad input, and
//! 3 if a claim is undecided against expectation.

mod args;
mod console;
mod decimal;
mod derive;
mod emit;
mod errors;
mod eval;
mod failure;
mod input;
mod layout;
mod output;
mod radical;
mod verify;

use std::process::ExitCode;

use clap::Parser;

use args::{Arguments, Command, VerifyArguments};

fn main() -> ExitCode {
    let command = Arguments::parse().command.unwrap_or(Command::Verify(VerifyArguments::default()));
    let outcome = match command {
        Command::Verify(arguments) => verify::run(&arguments),
        Command::Derive(arguments) => derive::run(&arguments),
        Command::Eval(arguments) => eval::run(&arguments),
        Command::Emit(arguments) => emit::run(&arguments),
        Command::Errors(arguments) => errors::run(&arguments),
    };
    outcome.unwrap_or_else(|failure| {
        console::report(&failure);
        failure::BAD_INPUT.into()
    })
}
