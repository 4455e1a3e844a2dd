//! Families in C: the structs of a member's parameters and coefficients, and the function that makes a member.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::super::code::{Code, Field, Number};
use super::super::expression::Body;
use super::super::family::documentation;
use super::super::{Artifact, Setting};
use super::DOUBLE;
use super::expression::{variable, write};
use super::net::{longest, net, speeds};
use crate::program::Input;

/// The types `name_parameters` and `name_surface`, and the function `name_new`.
pub(super) fn family(name: &str, artifact: &Artifact, code: &Code<'_>) -> String {
    let mut text = String::new();
    _ = writeln!(text, "/* What a surface of the family is made of. */\ntypedef struct {{");
    for setting in &artifact.symbols {
        let (field, size) = match setting {
            Setting::Number(symbol) => (variable(symbol), String::new()),
            Setting::Curve { name, rows, .. } => {
                (variable(name), format!("[{}][{}]", rows.len(), rows.first().map_or(0, Vec::len)))
            }
        };
        _ = writeln!(text, "    /* {} */\n    double {field}{size};", documentation(setting));
    }
    _ = writeln!(text, "}} {name}_parameters;\n");
    _ = writeln!(text, "/* A surface of the family, made by {name}_new. */\ntypedef struct {{");
    for (field, values) in &code.fields {
        _ = writeln!(text, "    double {}[{}];", variable(&field.to_string()), values.len());
    }
    let (m, n) = artifact.degree;
    let length = (m as usize + 1) * (n as usize + 1);
    _ = writeln!(
        text,
        "    /* Homogeneous Bezier control points (W, X, Y, Z) over the domain; the index of u is the outer one. */\n    double control_net[{length}][4];"
    );
    _ = writeln!(text, "}} {name}_surface;\n");
    text.push_str(&net(name, artifact, code));
    construction(&mut text, name, artifact, code);
    text
}

fn construction(text: &mut String, name: &str, artifact: &Artifact, code: &Code<'_>) {
    let (values, fields) = code.computed();
    let body = Body::new(code, &values, &BTreeMap::new());
    let (statements, results) = write(code, DOUBLE, &body);
    let (checks, symbols) = settings(artifact, code, &body);
    text.push_str(
        "/*
 * Makes a surface: HODOGRAPH_PARAMETER if a parameter is infinite or NaN, HODOGRAPH_OVERFLOW if the control net is not finite,
 * HODOGRAPH_POLE if the weight W vanishes on the domain or comes nearer to zero than rounding can tell, HODOGRAPH_SPEED if the
 * parametric speed of a curve is not positive.
 */
",
    );
    _ = writeln!(
        text,
        "static inline hodograph_status {name}_new(const {name}_parameters *parameters, {name}_surface *surface)\n{{"
    );
    let (m, n) = artifact.degree;
    let (length, columns) = ((m as usize + 1) * (n as usize + 1), n + 1);
    _ = writeln!(text, "    double room[(HODOGRAPH_DEPTH + 1) * {}];", longest(artifact, code));
    _ = writeln!(text, "    hodograph_status status;\n    bool finite = true;");
    for check in checks {
        _ = writeln!(text, "    finite &= {check};");
    }
    _ = writeln!(text, "    if (!finite)\n        return HODOGRAPH_PARAMETER;");
    for line in symbols.into_iter().chain(statements) {
        _ = writeln!(text, "    {line}");
    }
    for Field { name, numbers } in &fields {
        let field = variable(&name.to_string());
        for (place, number) in numbers.iter().enumerate() {
            let result = match *number {
                Number::Computed(place) => results[place].clone(),
                Number::Constant(number) => DOUBLE.literal(number),
            };
            _ = writeln!(text, "    surface->{field}[{place}] = {result};");
        }
    }
    _ = writeln!(text, "    {name}_net(surface, surface->control_net);");
    _ = writeln!(text, "    status = hodograph_check_net(surface->control_net, {length}, {columns}, room);");
    text.push_str(&speeds(name, code));
    _ = writeln!(text, "    return status;\n}}\n");
}

/// The checks of what is set, and the variables for those symbols that are read.
fn settings(artifact: &Artifact, code: &Code<'_>, body: &Body) -> (Vec<String>, Vec<String>) {
    let (mut checks, mut symbols) = (Vec::new(), Vec::new());
    let mut read = |symbol: &String, place: String| {
        let index = code.program.symbols().iter().position(|known| known == symbol);
        if index.is_some_and(|index| body.inputs.contains(&Input::Symbol(index as u32))) {
            symbols.push(format!("const double {} = parameters->{place};", variable(symbol)));
        }
    };
    for setting in &artifact.symbols {
        match setting {
            Setting::Number(symbol) => {
                let field = variable(symbol);
                checks.push(format!("hodograph_all_finite(&parameters->{field}, 1)"));
                read(symbol, field);
            }
            Setting::Curve { name, rows, .. } => {
                let (field, count) = (variable(name), rows.iter().map(Vec::len).sum::<usize>());
                checks.push(format!("hodograph_all_finite(&parameters->{field}[0][0], {count})"));
                for (i, row) in rows.iter().enumerate() {
                    for (j, symbol) in row.iter().enumerate() {
                        read(symbol, format!("{field}[{i}][{j}]"));
                    }
                }
            }
        }
    }
    (checks, symbols)
}
