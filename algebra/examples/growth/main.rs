//! Measures how the derivation of an oriented translation grows with the degree of its path and with the field of its numbers.
//!
//! ```text
//! cargo run --release -p hodograph-algebra --example growth -- [FAMILY…] [--write]
//! ```
//!
//! Each family is a sequence of PH curves of rising degree with coefficients of one kind; the profile is FN (16). Each row holds
//! for W, X, Y, Z (from the coefficients of the preimage), for the normal (from these) and for the offset by a symbol r (from
//! both) the time, terms, bits of the largest coefficient, and units of the budget. With `--write` all of it becomes the
//! table in the documentation of the library.

mod document;
mod families;
mod fit;
mod measure;
#[path = "../workloads/sweeps.rs"]
#[expect(dead_code, reason = "shared with the workloads, which have further sweeps")]
mod sweeps;

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;

use clap::Parser;
use document::Measured;
use families::FAMILIES;

/// Measures how derivations grow with the degree of the path and with the field of its numbers.
#[derive(Parser)]
struct Arguments {
    /// The families to measure; all if none is named
    #[arg(value_name = "FAMILY", value_parser = FAMILIES.each_ref().map(|family| family.name))]
    names: Vec<String>,
    /// Measure up to this degree of the path
    #[arg(long, value_name = "DEGREE")]
    highest: Option<u32>,
    /// Write the table in the documentation of the library
    #[arg(long, conflicts_with_all = ["names", "highest"])]
    write: bool,
}

fn main() -> ExitCode {
    match run(&Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let names = &arguments.names;
    let chosen = FAMILIES.iter().filter(|f| names.is_empty() || names.iter().any(|name| name == f.name));
    let mut measured: Vec<Measured<'_>> = Vec::new();
    for family in chosen {
        println!("{}: {}", family.name, family.title);
        println!("{}", document::heading());
        let mut rows = Vec::new();
        for &degree in
            family.degrees.iter().filter(|&&degree| arguments.highest.is_none_or(|most| degree <= most))
        {
            let row = measure::row(family, degree)?;
            println!("{row}");
            let ended = row.end.is_some();
            if let Some(end) = &row.end {
                println!("{end}");
            }
            rows.push(row);
            if ended {
                break;
            }
        }
        println!("{}\n", document::exponents(&rows));
        measured.push((family, rows));
    }
    if arguments.write {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("src").join("growth.md");
        std::fs::write(&path, document::markdown(&measured))?;
        println!("written to {}", path.display());
    }
    Ok(())
}
