//! What is stated of a surface as a whole.

use std::fmt::Write;

use super::super::Artifact;
use super::DOUBLE;
use crate::offset::OffsetPatch;
use crate::proofs::Proofs;

/// The degree, the domain, and what families do not have: the control net, the offset's and the bounds.
pub(super) fn constants(name: &str, artifact: &Artifact) -> String {
    let mut text = String::new();
    degree(&mut text, "The patch degree in u and v.", name, "degree", artifact.degree);
    let [u, v] = artifact.domain.map(|ends| list(&ends));
    _ = writeln!(text, "/* The parameters over which the surface is stated. */");
    _ = writeln!(text, "static const hodograph_domain {name}_domain = {{{u}, {v}}};\n");
    if artifact.symbols.is_empty() {
        let points: Vec<String> = artifact.control_net.iter().map(|point| list(point)).collect();
        text += "/* Homogeneous Bezier control points (W, X, Y, Z) over the domain, rounded; the index of u is the outer one. */\n";
        let size = format!("{}][4", points.len());
        table(&mut text, &format!("{name}_control_net"), &size, &points);
    }
    if let Some(patch) = &artifact.offset {
        offset(&mut text, name, patch);
    }
    if let Some(proofs) = &artifact.proofs {
        bounds(&mut text, name, proofs);
    }
    text
}

/// A list of numbers in braces.
fn list(numbers: &[f64]) -> String {
    let numbers: Vec<String> = numbers.iter().map(|&number| DOUBLE.literal(number)).collect();
    format!("{{{}}}", numbers.join(", "))
}

/// Degrees in u and v, as numbers that sizes of arrays may depend on.
fn degree(text: &mut String, documentation: &str, name: &str, what: &str, (m, n): (u32, u32)) {
    _ = writeln!(text, "/* {documentation} */\nenum {{ {name}_{what}_u = {m}, {name}_{what}_v = {n} }};\n");
}

fn table(text: &mut String, name: &str, size: &str, rows: &[String]) {
    let rows: Vec<String> = rows.iter().map(|row| format!("    {row}")).collect();
    _ = writeln!(text, "static const double {name}[{size}] = {{\n{}\n}};\n", rows.join(",\n"));
}

/// The exact offset patches.
fn offset(text: &mut String, name: &str, patch: &OffsetPatch) {
    let length = patch.net.len();
    degree(text, "The patch degree in u and v of the offsets.", name, "offset_degree", patch.degree);
    text.push_str(
        "/* Homogeneous control points (W, X, Y, Z) for the distance 0, and what X, Y and Z increase by for each unit of it. */\n",
    );
    let row = |[[w, x, y, z], [_, a, b, c]]: &[[f64; 4]; 2]| list(&[*w, *x, *y, *z, *a, *b, *c]);
    let rows: Vec<String> = patch.net.iter().map(row).collect();
    table(text, &format!("{name}_offset_net"), &format!("{length}][7"), &rows);
    _ = writeln!(
        text,
        "/*
 * The homogeneous control points of the exact offset R + r N over the domain, of the offsets' degree; the index of u is the outer
 * one. The side of the normal does not turn over where R_u x R_v does.
 */
static inline void {name}_offset_control_net(double r, double out[{length}][4])
{{
    for (size_t i = 0; i < {length}; i++) {{
        const double *point = {name}_offset_net[i];
        out[i][0] = point[0];
        for (size_t k = 1; k < 4; k++)
            out[i][k] = point[k] + r * point[k + 3];
    }}
}}
"
    );
}

/// The bounds of errors, of the plain variant.
fn bounds(text: &mut String, name: &str, proofs: &Proofs) {
    let row = |bound: &crate::proofs::OutputBound| {
        let ([double, _, single, _], [relative, _, relative_single, _]) =
            (bound.errors, bound.relative_errors);
        format!("    /* {} */ {}", bound.name, list(&[double, single, relative, relative_single, bound.size]))
    };
    let rows: Vec<String> = proofs.bounds.iter().map(row).collect();
    let rows = rows.join(",\n");
    _ = writeln!(
        text,
        "/* Proved bounds of the errors of the evaluators over the domain. */\nstatic const hodograph_bounds {name}_bounds = {{\n{rows}\n}};\n"
    );
}
