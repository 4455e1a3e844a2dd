//! What is stated of a surface as a whole.

use std::fmt::Write;

use super::super::Artifact;
use super::super::pieces::Whole;
use super::DOUBLE;
use crate::offset::OffsetPatch;
use crate::proofs::Proofs;
use crate::schedule::outputs;

/// The degree, the domain, and what families do not have: the control net, the offset's and the bounds.
pub(super) fn constants(name: &str, artifact: &Artifact) -> String {
    let mut text = String::new();
    degree(&mut text, "The patch degree in u and v.", name, "degree", artifact.degree);
    domain(&mut text, name, artifact.domain);
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

/// The degree, the domain, the joints with the jumps there, and the bounds of a surface of several pieces.
pub(super) fn of_whole(name: &str, whole: Whole<'_>) -> String {
    let mut text = String::new();
    degree(&mut text, "The largest degrees of all pieces in u and v.", name, "degree", whole.degree());
    domain(&mut text, name, whole.domain());
    let joints: Vec<f64> = whole.joints().collect();
    let (length, [jump, _, jump_f, _]) = (joints.len(), whole.jumps().map(|jump| DOUBLE.literal(jump)));
    _ = writeln!(
        text,
        "/* How many pieces there are. */
enum {{ {name}_count = {count} }};

/*
 * The joints: where one piece ends and the next one begins, ascending. Of a joint that is no double it is the next larger one. A
 * piece is evaluated from the joint before it on, and without the one after it; beyond the first and the last joint, outside of
 * the domain too, it is the first and the last piece. All results have the bits of the piece.
 */
static const double {name}_joints[{length}] = {joints};

/*
 * Upper bounds for the length of the jump at a joint, from rounding alone: the largest difference of the points that two neighbors
 * compute there, in double and in single precision; infinite where nothing is proved.
 */
static const double {name}_jump = {jump}, {name}_jump_f = {jump_f};
",
        count = length + 1,
        joints = list(&joints),
    );
    if let Some(proofs) = &whole.proofs() {
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

fn domain(text: &mut String, name: &str, domain: [[f64; 2]; 2]) {
    let [u, v] = domain.map(|ends| list(&ends));
    _ = writeln!(text, "/* The parameters over which the surface is stated. */");
    _ = writeln!(text, "static const hodograph_domain {name}_domain = {{{u}, {v}}};\n");
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
        let numbers = list(&[double, single, relative, relative_single, bound.size, bound.most]);
        let coordinates = (bound.name == outputs::POINT).then(|| {
            let of = |rounding: usize| {
                list(&bound.results.iter().map(|result| result.errors[rounding]).collect::<Vec<f64>>())
            };
            format!(",\n    /* coordinates */ {}, {}", of(0), of(2))
        });
        format!("    /* {} */ {numbers}{}", bound.name, coordinates.unwrap_or_default())
    };
    let rows: Vec<String> = proofs.bounds.iter().map(row).collect();
    let rows = rows.join(",\n");
    _ = writeln!(
        text,
        "/* Proved bounds of the errors of the evaluators over the domain. */\nstatic const hodograph_bounds {name}_bounds = {{\n{rows}\n}};\n"
    );
}
