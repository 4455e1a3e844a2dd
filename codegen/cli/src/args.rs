//! The arguments of the command.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use hodograph_algebra::budget;

use crate::decimal::MAX_DIGITS;

/// Exactly derived rational swept surfaces: claims, coordinates, values and code.
///
/// Without a command, all claims of the catalogue are checked, as by `hodograph verify`.
#[derive(Debug, Parser)]
#[command(name = "hodograph", version, subcommand_value_name = "COMMAND", after_help = EXIT_STATUS)]
pub(crate) struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub command: Option<Command>,
}

const EXIT_STATUS: &str = "\
Exit status:
  0  all as expected
  1  a claim is refuted without `expect refuted`, or proved with it; or --check found a difference
  2  bad usage or bad input
  3  a claim is undecided without `expect undecided`";

/// The commands.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Check every claim of the catalogue, or of files
    Verify(VerifyArguments),
    /// Derive what a surface is: coordinates, degrees, normal, offset, singular loci, control net
    Derive(DeriveArguments),
    /// Evaluate a surface at a point, exactly
    Eval(EvalArguments),
    /// Write the generated source of a surface's evaluator
    Emit(EmitArguments),
    /// Write a page of all claims of sources that are refuted, with what is right
    Errors(ErrorsArguments),
}

/// Where formulas come from.
#[derive(Debug, Args)]
pub(crate) struct Input {
    /// A file in the sweep language, `-` for standard input, or the name of an entry of the catalogue
    #[arg(value_name = "FILE|NAME")]
    pub input: String,
    /// Only this sweep
    #[arg(long, value_name = "NAME")]
    pub sweep: Option<String>,
}

/// How much work may be done.
#[derive(Clone, Copy, Debug, Args)]
pub(crate) struct Budget {
    /// The units of work that may go into the definitions of a file, into each derivation, and into each claim; beyond
    /// them, an error says how far it came. A unit takes some 30 ns
    #[arg(long = "budget", value_name = "UNITS", default_value_t = budget::DEFAULT_LIMIT, value_parser = units)]
    pub limit: u64,
}

impl Default for Budget {
    fn default() -> Budget {
        Budget { limit: budget::DEFAULT_LIMIT }
    }
}

/// A number of units, such as `300000000` or `300_000_000`.
fn units(text: &str) -> Result<u64, String> {
    let units = text.replace('_', "").parse().map_err(|error| format!("{error}"))?;
    if units == 0 { Err("nothing can be computed with 0 units".to_owned()) } else { Ok(units) }
}

/// `hodograph verify`
#[derive(Debug, Default, Args)]
pub(crate) struct VerifyArguments {
    /// Files in the sweep language, `-` for standard input, or names of entries of the catalogue; the whole catalogue if
    /// there are none
    #[arg(value_name = "FILE|NAME")]
    pub inputs: Vec<String>,
    /// Show how the verdicts on the claim of this id come about, step by step
    #[arg(long, value_name = "ID")]
    pub explain: Option<String>,
    /// Write long formulas out
    #[arg(long, requires = "explain")]
    pub full: bool,
    /// The form of the result
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
    #[command(flatten)]
    pub budget: Budget,
}

/// `hodograph derive`
#[derive(Debug, Args)]
pub(crate) struct DeriveArguments {
    #[command(flatten)]
    pub input: Input,
    /// The form of the result
    #[arg(long, value_enum, default_value_t)]
    pub format: DeriveFormat,
    #[command(flatten)]
    pub budget: Budget,
}

/// `hodograph eval`
#[derive(Debug, Args)]
pub(crate) struct EvalArguments {
    #[command(flatten)]
    pub input: Input,
    /// The value of a symbol, such as `a0=1/2`; every symbol of the surface needs one
    #[arg(long, value_name = "NAME=NUMBER")]
    pub set: Vec<String>,
    /// The first parameter: an exact number such as `1/2`, `-0.25` or `sqrt(2)/2`
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    pub u: String,
    /// The second parameter
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    pub v: String,
    /// What to evaluate
    #[arg(long, value_enum, default_value_t)]
    pub what: Quantity,
    /// How many significant digits the decimals are rounded to (fewer are printed of a number that needs fewer)
    #[arg(long, default_value_t = 17, value_parser = clap::value_parser!(u32).range(1..=i64::from(MAX_DIGITS)))]
    pub digits: u32,
    /// The form of the result
    #[arg(long, value_enum, default_value_t)]
    pub format: Format,
    #[command(flatten)]
    pub budget: Budget,
}

/// `hodograph emit`
#[derive(Debug, Args)]
pub(crate) struct EmitArguments {
    #[command(flatten)]
    pub input: Input,
    /// The language of the source
    #[arg(long, value_enum)]
    pub target: Target,
    /// Put in what the source needs of the run-time library, so that it depends on nothing
    #[arg(long)]
    pub standalone: bool,
    /// The file to write, instead of standard output
    #[arg(short, long, value_name = "PATH")]
    pub output: Option<PathBuf>,
    /// Write nothing; compare the file with what would be written
    #[arg(long, requires = "output")]
    pub check: bool,
    #[command(flatten)]
    pub budget: Budget,
}

/// `hodograph errors`
#[derive(Debug, Args)]
pub(crate) struct ErrorsArguments {
    /// Files in the sweep language, `-` for standard input, or names of entries of the catalogue; the whole catalogue if
    /// there are none
    #[arg(value_name = "FILE|NAME")]
    pub inputs: Vec<String>,
    /// The file to write, instead of standard output
    #[arg(short, long, value_name = "PATH")]
    pub output: Option<PathBuf>,
    /// Write nothing; compare the file with what would be written
    #[arg(long, requires = "output")]
    pub check: bool,
    #[command(flatten)]
    pub budget: Budget,
}

/// Forms of results.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For people
    #[default]
    Text,
    /// For programs
    Json,
}

/// Forms of derivations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum DeriveFormat {
    /// For people
    #[default]
    Text,
    /// For programs, with all polynomials in full
    Json,
    /// A fragment of a document that uses amsmath
    Latex,
}

/// What is evaluated at a point of a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Quantity {
    /// The affine coordinates x, y, z
    #[default]
    Point,
    /// The homogeneous coordinates W, X, Y, Z, up to a common factor
    Homogeneous,
    /// The normal R_u x R_v
    Normal,
    /// The unit vector of R_u x R_v
    UnitNormal,
    /// The derivative R_u
    Du,
    /// The derivative R_v
    Dv,
    /// The parametric speed |R_u|
    SpeedU,
    /// The parametric speed |R_v|
    SpeedV,
    /// The point at the signed distance r along the unit normal, with `--set r=NUMBER`
    Offset,
}

/// Languages that sources are emitted in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Target {
    /// Rust
    Rust,
    /// C
    C,
}

impl Quantity {
    /// The name that the command line and results have for it.
    pub(crate) fn name(self) -> String {
        self.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned())
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    use super::*;

    #[test]
    fn arguments_are_consistent() {
        Arguments::command().debug_assert();
    }

    #[test]
    fn negative_numbers_are_values() {
        let arguments = ["hodograph", "eval", "a.sweep", "--u", "-1/2", "--v", "-sqrt(2)", "--set", "a0=-1"];
        let Some(Command::Eval(eval)) = Arguments::parse_from(arguments).command else { panic!("not eval") };
        assert_eq!((eval.u.as_str(), eval.v.as_str(), eval.digits), ("-1/2", "-sqrt(2)", 17));
        assert_eq!(eval.what.name(), "point");
        assert_eq!(Quantity::UnitNormal.name(), "unit-normal");
    }

    #[test]
    fn budgets_are_numbers_of_units() {
        let limit = |arguments: &[&str]| match Arguments::try_parse_from(arguments) {
            Ok(Arguments { command: Some(Command::Verify(verify)) }) => Some(verify.budget.limit),
            _ => None,
        };
        assert_eq!(limit(&["hodograph", "verify"]), Some(budget::DEFAULT_LIMIT));
        assert_eq!(VerifyArguments::default().budget.limit, budget::DEFAULT_LIMIT);
        assert_eq!(limit(&["hodograph", "verify", "--budget", "1_000_000"]), Some(1_000_000));
        for wrong in ["0", "-1", "1e9", "many", "99999999999999999999"] {
            assert_eq!(limit(&["hodograph", "verify", "--budget", wrong]), None, "{wrong}");
        }
    }
}
