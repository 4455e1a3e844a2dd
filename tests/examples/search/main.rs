//! Searches for errors of the catalogue's evaluators that exceed their proved bounds.
//!
//! ```text
//! cargo run --release -p hodograph-tests --example search -- [NAME…] [--points N]
//! ```
//!
//! Each surface is tried at N points (10⁵ if N is not given) that are floats of single precision, and at N others: at the border
//! and near it, anywhere, near changes of the sign of some result, where there is cancellation, near singular points, and near the
//! largest errors so far. Every point is tried in all functions, in the precisions that it is a point of and in both variants.
//!
//! A line shows for each function the largest error, the bound, and the bound divided by the error: in double precision, plain
//! and fused, then in single precision. Errors are in units of the unit roundoff, 2⁻⁵³ or 2⁻²⁴, times the function's size (1 where
//! that is not known). For a function without a bound, the reason follows, and in place of the ratio there is the largest error
//! in units of the unit roundoff times the size of the result itself. The exit status is 1 if a bound is exceeded.

use std::process::ExitCode;
use std::time::Instant;

use clap::Parser;
use hodograph_codegen::compile::compile;
use hodograph_tests::catalogue::entries;
use hodograph_tests::search::Search;
use hodograph_tests::surfaces::concrete;

/// Searches for errors of evaluators that exceed their proved bounds.
#[derive(Parser)]
struct Arguments {
    /// The entries to search; all if none is named
    #[arg(value_name = "NAME", value_parser = hodograph::catalogue::all().iter().map(|surface| surface.name()).collect::<Vec<_>>())]
    names: Vec<String>,
    /// How many points of each precision are tried
    #[arg(long, value_name = "N", default_value_t = 100_000)]
    points: usize,
}

fn main() -> ExitCode {
    let Arguments { names, points } = Arguments::parse();
    let entries = entries();
    let mut excesses = Vec::new();
    println!("{:18}{:^28} |{:^28} |{:^28} |{:^28}", "", "f64", "f64 fused", "f32", "f32 fused");
    let columns = format!("{:>9} {:>9} {:>8}", "error", "bound", "ratio");
    println!("{:18}{}", "", [columns.as_str(); 4].join(" |"));
    for subject in concrete() {
        let name = subject.surface.name();
        let entry = entries.iter().find(|entry| entry.model.name == name);
        let (Some(entry), Some(bounds)) = (entry, &subject.bounds) else { continue };
        if !names.is_empty() && !names.iter().any(|wanted| wanted == name) {
            continue;
        }
        let start = Instant::now();
        let mut search = Search::new(&subject, &entry.derivation);
        search.run(points);
        println!("\n{name}: {} points in {:.0} s", search.tried(), start.elapsed().as_secs_f64());
        print!("{}", search.table(bounds));
        let proofs = compile(&entry.model).ok().and_then(|artifact| artifact.proofs);
        for bound in proofs.iter().flat_map(|proofs| &proofs.bounds) {
            if let Some(reason) = bound.failures.iter().flatten().next() {
                let (u, v) = search.worst(bound.name, 0).at;
                println!(
                    "  {} has no bound: {reason}; the largest error at u = {u:?}, v = {v:?}",
                    bound.name
                );
            }
        }
        excesses.extend(search.excesses(bounds, 1.0));
    }
    for excess in &excesses {
        eprintln!("beyond the bound: {excess}");
    }
    if excesses.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
