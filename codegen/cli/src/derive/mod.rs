//! `hodograph derive`: what a surface is.

mod conditions;
mod factors;
mod json;
mod latex;
mod text;

use std::process::ExitCode;

use hodograph_algebra::{
    Conditions, CurvatureZeros, Derivation, DifferentialGeometry, Offset, Poly, SweptSurface, Variable,
    budget,
};
use hodograph_codegen::language::Diagnostic;
use hodograph_codegen::language::ast::Item;
use hodograph_codegen::meaning::Model;

use crate::args::{DeriveArguments, DeriveFormat};
use crate::console::{self, Progress};
use crate::failure::Failure;
use crate::input::{self, Document};

/// How many significant digits the approximations of the field's generators have.
const APPROXIMATION_DIGITS: u32 = 20;

/// A sweep with what follows from its formula.
#[derive(Debug)]
pub(crate) struct Derived<'a> {
    /// The sweep as it is written.
    item: &'a Item,
    /// What it means.
    model: &'a Model,
    /// What follows.
    derivation: Derivation,
    /// Where symbols change its degrees; `None` if that exceeds the budget.
    conditions: Option<Conditions>,
    /// The same for the offset, if that is rational.
    offset_conditions: Option<Conditions>,
    /// Where the Gaussian and the mean curvature vanish; `None` with symbols.
    curvature_zeros: Option<[CurvatureZeros; 2]>,
}

/// Runs the command.
///
/// # Errors
/// Bad input; a surface that cannot be derived.
pub(crate) fn run(arguments: &DeriveArguments) -> Result<ExitCode, Failure> {
    let limit = arguments.budget.limit;
    let document = input::load(&arguments.input.input, limit)?;
    let sweeps = document.sweeps(arguments.input.sweep.as_deref())?;
    let progress = Progress::new();
    let mut all = Vec::new();
    for model in sweeps {
        progress.show(&format!("deriving {}", model.name));
        all.push(derived(&document, model)?);
    }
    // Factors for people are found by gcds.
    let output = budget::with_budget(limit, || match arguments.format {
        DeriveFormat::Text => all.iter().map(text::output).collect::<Vec<_>>().join("\n"),
        DeriveFormat::Json => json::output(&all),
        DeriveFormat::Latex => latex::output(&all),
    });
    drop(progress);
    let exhausted =
        |error: budget::Exhausted| Failure::new(error.to_string()).help("`--format json` needs less work");
    console::print(&output.map_err(exhausted)?)?;
    Ok(ExitCode::SUCCESS)
}

fn derived<'a>(document: &'a Document, model: &'a Model) -> Result<Derived<'a>, Failure> {
    let failed = |message: String| Failure::at(&document.source, Diagnostic::new(model.place, message));
    let (Some(surface), Some(item)) = (&model.surface, document.item(model)) else {
        return Err(failed(format!("`{}` has no surface", model.name)));
    };
    let derivation = match budget::with_budget(model.limit, || surface.derive()) {
        Ok(Ok(derivation)) => derivation,
        Ok(Err(error)) => return Err(failed(error.to_string())),
        Err(exhausted) => return Err(failed(exhausted.to_string())),
    };
    let conditions = conditions::of(&derivation.homogeneous, model.limit);
    let geometry = derivation.geometry.as_ref();
    let offset_conditions =
        geometry.ok().and_then(|geometry| conditions::of_offset(&geometry.offset, model.limit));
    let curvature_zeros = curvature_zeros(&derivation, model.limit);
    Ok(Derived { item, model, derivation, conditions, offset_conditions, curvature_zeros })
}

/// Where the curvatures vanish on the domain, over the number field of the derivation; `None` with symbols, and where not even the normal
/// is within the budget.
fn curvature_zeros(derivation: &Derivation, limit: u64) -> Option<[CurvatureZeros; 2]> {
    if !derivation.symbols.is_empty() || derivation.geometry.is_err() {
        return None;
    }
    let position = derivation.homogeneous.cartesian();
    let surface = SweptSurface::new(position, derivation.parameters.clone(), derivation.domain.clone());
    let zeros = || {
        let forms = surface.forms().ok()?;
        Some([forms.gaussian_zeros(), forms.mean_zeros()])
    };
    budget::with_budget(limit, zeros)
        .unwrap_or(Some([CurvatureZeros::Undetermined, CurvatureZeros::Undetermined]))
}

/// Why the offset is rational, or not, in a sentence; `show` writes polynomials.
fn offset_reason(
    geometry: &DifferentialGeometry,
    distance: &Variable,
    show: impl Fn(&Poly) -> String,
) -> String {
    let reason = match &geometry.offset {
        Offset::Irrational { odd } => {
            let values = geometry.normal.squared_length().member().iter();
            let values: Vec<String> = values.map(|(symbol, value)| format!("{symbol} = {value}")).collect();
            let place =
                if values.is_empty() { String::new() } else { format!(" where {}", values.join(", ")) };
            format!("|N|^2 contains the factor {} to an odd power{place}, so it is no square", show(odd))
        }
        Offset::SymbolicRadical { radicand, radical, .. } => {
            let radicand = show(radicand);
            format!(
                "|N| is a polynomial over {radical} = sqrt({radicand}), which depends on the symbols alone"
            )
        }
        _ if geometry.normal.squared_length().split().unit.is_one() => {
            "|N|^2 is the square of a polynomial".to_owned()
        }
        _ => "|N|^2 is the square of a polynomial, times a positive number".to_owned(),
    };
    match &geometry.orientation {
        Some(orientation) if geometry.offset.is_rational() => {
            format!(
                "{reason}; {distance} is the distance where {} > 0, and -{distance} beyond",
                show(orientation)
            )
        }
        _ => reason,
    }
}
