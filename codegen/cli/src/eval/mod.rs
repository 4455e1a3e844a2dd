//! `hodograph eval`: a surface at a point.

mod place;
mod quantity;

use std::process::ExitCode;

use hodograph_algebra::{Poly, Variable, budget};
use hodograph_codegen::language::{Diagnostic, closest};
use hodograph_codegen::meaning::{Model, number};
use serde::Serialize;

use crate::args::{EvalArguments, Format, Quantity};
use crate::console;
use crate::decimal::{is_exact, significant};
use crate::failure::Failure;
use crate::input;
use crate::layout;
use crate::radical;
use place::Place;

/// The result for programs.
#[derive(Serialize)]
struct Output<'a> {
    schema: u32,
    sweep: &'a str,
    u: String,
    v: String,
    what: String,
    exact: Option<Vec<String>>,
    decimal: Vec<String>,
}

/// Runs the command.
///
/// # Errors
/// Bad input; symbols without a value; a pole or a singular point.
pub(crate) fn run(arguments: &EvalArguments) -> Result<ExitCode, Failure> {
    let limit = arguments.budget.limit;
    let document = input::load(&arguments.input.input, limit)?;
    let pieces = document.sweep(arguments.input.sweep.as_deref())?;
    let parameters = [
        number("--u", "the first parameter", &arguments.u, limit)?,
        number("--v", "the second parameter", &arguments.v, limit)?,
    ];
    let model = piece_at(&pieces, &parameters)?;
    let surface =
        model.surface.as_ref().ok_or_else(|| Failure::new(format!("`{}` has no surface", model.name)))?;
    let settings = settings(&arguments.set, limit)?;
    let symbols = surface.symbols();
    let distance = quantity::distance(surface, arguments.what);
    let distance = check(model, &symbols, distance, &settings)?;
    let values =
        symbols.into_iter().filter_map(|symbol| Some((symbol.clone(), find(&settings, &symbol)?.clone())));
    let values = values.collect();
    note_outside(&pieces, &parameters);

    let computed = budget::with_budget(limit, || {
        // The formula is evaluated anew: a parametric speed |s'|, for one, depends on the values.
        let set = model.with_values(&values).map_err(|mistake| {
            let message = format!("with these values of the symbols: {}", mistake.message);
            let told = Diagnostic::new(mistake.span, message).help("set other values");
            Failure::at(&document.source, told)
        })?;
        let surface = set.surface.as_deref().unwrap_or(surface);
        let place = Place::new(surface, &parameters);
        let task = format!("the {} at these parameters", arguments.what.name());
        let numbers = budget::doing(task, || quantity::evaluate(&place, arguments.what, distance.as_ref()))?;
        let decimal: Vec<String> =
            numbers.iter().map(|number| significant(number, arguments.digits)).collect();
        Ok::<_, Failure>((numbers, decimal))
    });
    let exhausted = |error: budget::Exhausted| {
        Failure::new(error.to_string()).help("use simpler numbers or fewer digits")
    };
    let (numbers, decimal) = computed.map_err(exhausted)??;
    let [u, v] = parameters.each_ref().map(radical::written_one);
    // Writing a number over the smallest field may cost more than the number itself; its decimals are there anyway.
    let exact = budget::with_budget(limit, || radical::written(&numbers)).ok();
    let result = Output { schema: 1, sweep: &model.name, u, v, what: arguments.what.name(), exact, decimal };
    console::print(&match arguments.format {
        Format::Json => layout::json(&result),
        Format::Text => text(&result, &numbers, surface.parameters(), arguments.what),
    })?;
    Ok(ExitCode::SUCCESS)
}

/// The piece to which values of the parameters belong: at a joint the one that begins there, beyond all of them the nearest one.
fn piece_at<'a>(pieces: &[&'a Model], values: &[Poly; 2]) -> Result<&'a Model, Failure> {
    let reaches = |model: &&&Model| {
        let surface = model.surface.as_ref();
        surface.is_some_and(|surface| values[1].compare(surface.domain()[1].upper()).is_lt())
    };
    let found = pieces.iter().find(reaches).or(pieces.last());
    found.copied().ok_or_else(|| Failure::new("there is no surface"))
}

/// The values of `--set`.
fn settings(set: &[String], limit: u64) -> Result<Vec<(String, Poly)>, Failure> {
    let mut settings: Vec<(String, Poly)> = Vec::new();
    for setting in set {
        let Some((name, value)) = setting.split_once('=') else {
            let failure = Failure::new(format!("--set {setting} does not say a value"));
            return Err(failure.help("write `--set a0=1/2`"));
        };
        let name = name.trim();
        if settings.iter().any(|(known, _)| known == name) {
            return Err(Failure::new(format!("--set gives `{name}` two values")));
        }
        let value = number(&format!("--set {name}"), &format!("the value of {name}"), value, limit)?;
        settings.push((name.to_owned(), value));
    }
    Ok(settings)
}

/// Checks that every symbol, and nothing else, has a value; gives that of the distance, if one is needed.
fn check(
    model: &Model,
    symbols: &[Variable],
    distance: Option<Variable>,
    settings: &[(String, Poly)],
) -> Result<Option<Poly>, Failure> {
    let needed: Vec<&Variable> = symbols.iter().chain(&distance).collect();
    let names: Vec<&str> = needed.iter().map(|symbol| symbol.name()).collect();
    for (name, _) in settings {
        if !names.contains(&name.as_str()) {
            let failure = Failure::new(format!("`{}` has no symbol `{name}`", model.name));
            return Err(failure.help(match closest(name, names.iter().copied()) {
                Some(similar) => format!("did you mean `{similar}`?"),
                None if names.is_empty() => "it has no symbols at all".to_owned(),
                None => format!("it has {}", names.join(", ")),
            }));
        }
    }
    let missing: Vec<&str> =
        needed.iter().filter(|symbol| find(settings, symbol).is_none()).map(|symbol| symbol.name()).collect();
    if !missing.is_empty() {
        let what = if missing.len() == 1 { "a value" } else { "values" };
        let failure = Failure::new(format!("`{}` needs {what} for {}", model.name, missing.join(", ")));
        return Err(
            failure.help(missing.iter().map(|name| format!("--set {name}=1")).collect::<Vec<_>>().join(" "))
        );
    }
    Ok(distance.and_then(|distance| find(settings, &distance).cloned()))
}

fn find<'a>(settings: &'a [(String, Poly)], symbol: &Variable) -> Option<&'a Poly> {
    settings.iter().find(|(name, _)| name == symbol.name()).map(|(_, value)| value)
}

/// Says so if a parameter lies outside of the domain, that of all pieces together.
fn note_outside(pieces: &[&Model], values: &[Poly; 2]) {
    let surfaces = || pieces.iter().filter_map(|piece| piece.surface.as_deref());
    let (Some(first), Some(last)) = (surfaces().next(), surfaces().next_back()) else { return };
    for (index, (parameter, value)) in first.parameters().iter().zip(values).enumerate() {
        let ends = [first.domain()[index].lower(), last.domain()[index].upper()];
        if value.compare(ends[0]).is_lt() || value.compare(ends[1]).is_gt() {
            let [value, lower, upper] = [value, ends[0], ends[1]].map(radical::written_one);
            console::note(&format!("{parameter} = {value} lies outside of the domain {lower}..{upper}"));
        }
    }
}

fn text(result: &Output<'_>, numbers: &[Poly], parameters: &[Variable; 2], what: Quantity) -> String {
    let [u, v] = parameters;
    let mut text = format!("{} of {} at {u} = {}, {v} = {}\n", result.what, result.sweep, result.u, result.v);
    for (index, (name, decimal)) in what.components().iter().zip(&result.decimal).enumerate() {
        let relation =
            if numbers.get(index).is_some_and(|number| is_exact(number, decimal)) { '=' } else { '≈' };
        let exact = result.exact.as_ref().and_then(|exact| exact.get(index));
        match exact.filter(|exact| *exact != decimal) {
            Some(exact) => {
                text += &layout::wrapped(&format!("  {name} = "), exact);
                text += &format!("\n  {:width$} {relation} {decimal}\n", "", width = name.len());
            }
            None => text += &format!("  {name} {relation} {decimal}\n"),
        }
    }
    text
}
