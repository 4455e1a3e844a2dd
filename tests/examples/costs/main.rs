//! Lists what each entry of the catalogue costs the compiler, in the profile that this program is built in.
//!
//! ```text
//! cargo run [--release] -p hodograph-tests --example costs -- [NAME…] [--runs N] [--format json]
//! ```
//!
//! | column | what it is |
//! | --- | --- |
//! | expansion | the time of the macro's work, from the text to the tokens; in a build without settings it is that of this program without `--release` |
//! | units | the same work in units of the budget, which are the same everywhere |
//! | tokens, KiB | the size of what the macro gives to the compiler, and of its text as `hodograph emit` writes it |
//! | compiled, -O | the time of rustc for that code, beyond the time for an empty crate: without optimization and with debug information, as `cargo build` does, and with `opt-level=3` |
//!
//! Times are the shortest of N runs, of one if N is not given. The total is that of the entries shown. The JSON
//! is `{"schema":1,"optimized","entries":[{"name","expansion_ms","units","tokens","bytes","compile_ms","compile_optimized_ms"}],"total"}`
//! with a total like an entry. Where rustc does not run, times of compilation are absent, and the reason is on standard error.

mod rustc;

use std::io;
use std::process::ExitCode;
use std::time::Duration;

use clap::{Parser, ValueEnum};
use hodograph::Source;
use hodograph_tests::cost::{Expansion, expanded};
use serde::Serialize;

use rustc::{Compiler, Level};

/// Lists what each entry of the catalogue costs the compiler.
#[derive(Parser)]
struct Arguments {
    /// The entries to measure; all if none is named
    #[arg(value_name = "NAME", value_parser = expanded().into_iter().map(|entry| entry.name).collect::<Vec<_>>())]
    names: Vec<String>,
    /// How often each time is measured
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=1000))]
    runs: u32,
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Format {
    Text,
    Json,
}

/// What an entry costs, or several of them together.
#[derive(Serialize)]
struct Cost {
    name: &'static str,
    expansion_ms: f64,
    units: u64,
    tokens: usize,
    bytes: usize,
    /// Not optimized; absent where rustc does not run.
    compile_ms: Option<f64>,
    /// With `opt-level=3`.
    compile_optimized_ms: Option<f64>,
}

/// The costs of all entries.
#[derive(Serialize)]
struct Report {
    schema: u32,
    /// Whether this program, and so the expansion, is optimized.
    optimized: bool,
    entries: Vec<Cost>,
    total: Cost,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    match run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(arguments: &Arguments) -> io::Result<()> {
    let chosen =
        |entry: &Source| arguments.names.is_empty() || arguments.names.iter().any(|name| name == entry.name);
    let compilers =
        match (Compiler::new(Level::Plain, arguments.runs), Compiler::new(Level::Optimizing, arguments.runs))
        {
            (Ok(plain), Ok(optimizing)) => Some([plain, optimizing]),
            (Err(error), _) | (_, Err(error)) => {
                eprintln!("times of compilation are not measured: {error}");
                None
            }
        };
    let text = arguments.format == Format::Text;
    if text {
        println!(
            "{:44} {:>12} {:>9} {:>7} {:>6} {:>11} {:>11}",
            "", "expansion ms", "units", "tokens", "KiB", "compiled ms", "-O ms"
        );
    }
    let mut entries = Vec::new();
    for entry in expanded().into_iter().filter(chosen) {
        let cost = cost(&entry, arguments.runs, compilers.as_ref())?;
        if text {
            println!("{}", line(&cost));
        }
        entries.push(cost);
    }
    let report = Report { schema: 1, optimized: !cfg!(debug_assertions), total: total(&entries), entries };
    if text {
        println!("{}", line(&report.total));
    } else {
        println!("{}", serde_json::to_string(&report)?);
    }
    Ok(())
}

/// Measures an entry.
fn cost(entry: &Source, runs: u32, compilers: Option<&[Compiler; 2]>) -> io::Result<Cost> {
    let mut expansion = Expansion::of(entry);
    for _ in 1..runs {
        expansion.time = expansion.time.min(Expansion::of(entry).time);
    }
    let text = expansion.text();
    let compiled = match compilers {
        None => [None; 2],
        Some([plain, optimizing]) => {
            [Some(milliseconds(plain.time(&text, runs)?)), Some(milliseconds(optimizing.time(&text, runs)?))]
        }
    };
    Ok(Cost {
        name: entry.name,
        expansion_ms: milliseconds(expansion.time),
        units: expansion.units,
        tokens: expansion.tokens(),
        bytes: text.len(),
        compile_ms: compiled[0],
        compile_optimized_ms: compiled[1],
    })
}

fn milliseconds(time: Duration) -> f64 {
    (time.as_secs_f64() * 1e4).round() / 10.0
}

/// The sum of the entries' costs.
fn total(entries: &[Cost]) -> Cost {
    let sum = |part: fn(&Cost) -> Option<f64>| entries.iter().map(part).sum();
    Cost {
        name: "total",
        expansion_ms: entries.iter().map(|cost| cost.expansion_ms).sum(),
        units: entries.iter().map(|cost| cost.units).sum(),
        tokens: entries.iter().map(|cost| cost.tokens).sum(),
        bytes: entries.iter().map(|cost| cost.bytes).sum(),
        compile_ms: sum(|cost| cost.compile_ms),
        compile_optimized_ms: sum(|cost| cost.compile_optimized_ms),
    }
}

/// A line of the table.
fn line(cost: &Cost) -> String {
    let Cost { name, expansion_ms, units, tokens, bytes, .. } = cost;
    let kib = *bytes as f64 / 1024.0;
    let time = |time: Option<f64>| time.map_or_else(|| "-".to_owned(), |time| format!("{time:.0}"));
    let (plain, optimized) = (time(cost.compile_ms), time(cost.compile_optimized_ms));
    format!("{name:44} {expansion_ms:12.1} {units:9} {tokens:7} {kib:6.1} {plain:>11} {optimized:>11}")
}
