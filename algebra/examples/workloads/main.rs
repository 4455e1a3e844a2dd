//! Times the engine on the derivations that it exists for, and on plain products and gcds.
//!
//! ```text
//! cargo run --release -p hodograph-algebra --example workloads -- [NAME…] [--format json]
//! ```
//!
//! | name | the timed work |
//! | --- | --- |
//! | `translation`, `involute`, `conical` | W, X, Y, Z of the sweeps FN (18), (26), (31), from the coefficients of the preimage |
//! | `translation-normal`, `conical-normal-full` | the numerator of `R_u × R_v` without common factor, from the same data |
//! | `conical-normal` | the same for w₀, w₁, w₂ = 1 + 2i, 3 + i, 2 − i; c₀ and c₁ remain symbols |
//! | `fateman`, `sparse` | one product, its operands ready |
//! | `gcd-small`, `gcd-middle`, `gcd-large` | one gcd of polynomials in four variables, its operands ready |
//!
//! The profile is FN (16), the path a PH quintic with symbols for its preimage. Each workload runs in a process of its own, so
//! that its peak memory (resident, with the program itself) is its own; that figure needs Linux. The hash is the value at
//! (3, 5, 7, 11, …) modulo 2⁶¹ − 1, up to sign, by which results can be compared with those of other programs.

mod hash;
mod measure;
mod products;
mod sweeps;

use std::error::Error;
use std::fmt;
use std::process::{Command, ExitCode, Stdio};

use clap::{Parser, ValueEnum};
use hodograph_algebra::Poly;
use serde::{Deserialize, Serialize};

/// One workload: its name, its variables in the order of the hash's points, and the work, which [`Workload::prepare`] sets up.
pub(crate) struct Workload {
    name: &'static str,
    variables: &'static [&'static str],
    prepare: fn() -> Box<dyn FnMut() -> Vec<Poly>>,
}

const WORKLOADS: [Workload; 11] = {
    use {products as p, sweeps as s};
    const fn new(
        name: &'static str,
        variables: &'static [&'static str],
        prepare: fn() -> Box<dyn FnMut() -> Vec<Poly>>,
    ) -> Workload {
        Workload { name, variables, prepare }
    }
    [
        new("translation", s::VARIABLES, || Box::new(|| s::coordinates(&s::translation()))),
        new("involute", s::VARIABLES, || Box::new(|| s::coordinates(&s::involute()))),
        new("conical", s::VARIABLES, || Box::new(|| s::coordinates(&s::conical(s::symbolic_path())))),
        new("translation-normal", s::VARIABLES, || Box::new(|| s::normal(&s::translation()))),
        new("conical-normal", s::PARAMETERS_AND_SCALE, || {
            Box::new(|| s::normal(&s::conical(s::numeric_path())))
        }),
        new("conical-normal-full", s::VARIABLES, || Box::new(|| s::normal(&s::conical(s::symbolic_path())))),
        new("fateman", p::FIVE, p::fateman),
        new("sparse", p::FIVE, p::sparse),
        new("gcd-small", p::FOUR, || p::gcd(include_str!("gcd_small.txt"))),
        new("gcd-middle", p::FOUR, || p::gcd(include_str!("gcd_middle.txt"))),
        new("gcd-large", p::FOUR, || p::gcd(include_str!("gcd_large.txt"))),
    ]
};

/// What is measured of one workload.
#[derive(Serialize, Deserialize)]
struct Measurement {
    name: String,
    median_ms: f64,
    min_ms: f64,
    runs: usize,
    /// The number of terms of each polynomial of the result.
    terms: Vec<usize>,
    hash: u64,
    /// The largest resident size of the process; absent where the system does not tell.
    peak_mib: Option<f64>,
}

/// All measurements.
#[derive(Serialize, Deserialize)]
struct Report {
    schema: u32,
    workloads: Vec<Measurement>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Format {
    Text,
    Json,
}

/// Times the engine on derivations, products and gcds.
#[derive(Parser)]
struct Arguments {
    /// The workloads to run; all if none is named
    #[arg(value_name = "NAME", value_parser = WORKLOADS.each_ref().map(|workload| workload.name))]
    names: Vec<String>,
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
    /// Run the one workload in this process
    #[arg(long, hide = true)]
    here: bool,
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

fn run(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let names = &arguments.names;
    let chosen = WORKLOADS.iter().filter(|w| names.is_empty() || names.iter().any(|name| name == w.name));
    let text = matches!(arguments.format, Format::Text);
    if text {
        println!(
            "{:19} {:>11} {:>11} {:>5} {:>9} {:>20}  terms",
            "", "median ms", "min ms", "runs", "peak MiB", "hash"
        );
    }
    let mut workloads = Vec::new();
    for workload in chosen {
        let measurement = if arguments.here { measure::run(workload) } else { in_own_process(workload)? };
        if text {
            println!("{measurement}");
        }
        workloads.push(measurement);
    }
    if !text {
        println!("{}", serde_json::to_string(&Report { schema: 1, workloads })?);
    }
    Ok(())
}

/// Runs this program once more, for one workload.
fn in_own_process(workload: &Workload) -> Result<Measurement, Box<dyn Error>> {
    let mut command = Command::new(std::env::current_exe()?);
    let output =
        command.args([workload.name, "--format", "json", "--here"]).stderr(Stdio::inherit()).output()?;
    if !output.status.success() {
        return Err(format!("the process of {} ended with {}", workload.name, output.status).into());
    }
    let mut report: Report = serde_json::from_slice(&output.stdout)?;
    report.workloads.pop().ok_or_else(|| format!("the process of {} measured nothing", workload.name).into())
}

impl fmt::Display for Measurement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Measurement { name, median_ms, min_ms, runs, terms, hash, peak_mib } = self;
        let peak = peak_mib.map_or_else(|| "-".to_owned(), |peak| format!("{peak:.1}"));
        let terms: Vec<String> = terms.iter().map(ToString::to_string).collect();
        write!(
            f,
            "{name:19} {median_ms:11.3} {min_ms:11.3} {runs:5} {peak:>9} {hash:>20}  {}",
            terms.join(" ")
        )
    }
}
