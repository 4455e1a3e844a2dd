//! The C code that evaluates a surface at places, and what it prints.

use std::fmt::Write;

use hodograph_codegen::bound::{Precision, Rounding};
use hodograph_codegen::program::Variant;
use hodograph_tests::points::{Points, rounded};
use hodograph_tests::surfaces::Evaluator;

use crate::functions::{FUNCTIONS, Function, Outcome, Place, TYPES, Type};
use crate::program::Expected;

/// Points of each surface, in each precision.
pub(crate) const POINTS: usize = 200;

/// The first so many parameters u of these are those of a grid: more than are computed at a time.
const COLUMNS: usize = 150;

/// The distances of offsets, one after the other.
const DISTANCES: [f64; 5] = [0.25, -1.5, 0.0, f64::INFINITY, 1e30];

/// Places where a surface is evaluated, with distances: on its domain, beside it, and no places at all.
pub(crate) fn places(surface: &dyn Evaluator, precision: Precision) -> Vec<Place> {
    let mut points = Points::new(surface, precision, 11);
    let mut places = points.border();
    places.extend([(0.0, -0.0), (-1.5, 2.0), (1e18, 0.5), (f64::NAN, 0.0), (0.5, f64::INFINITY)]);
    let far = if precision == Precision::Double { 1.2e154 } else { 1.6e19 };
    places.push((far, far));
    while places.len() < POINTS {
        places.push(points.anywhere());
        places.push(points.near_border());
    }
    with_distances(places, precision)
}

/// The first of the parameters, so many as are tried, with distances.
pub(crate) fn with_distances(mut places: Vec<(f64, f64)>, precision: Precision) -> Vec<Place> {
    assert!(places.len() >= POINTS);
    places.truncate(POINTS);
    let distances = DISTANCES.iter().cycle();
    places.into_iter().zip(distances).map(|((u, v), &r)| (u, v, rounded(r, precision))).collect()
}

/// A surface that is called in C, and what its functions should give.
pub(crate) trait Called {
    /// What the names of its functions begin with.
    fn name(&self) -> &str;

    /// What stands before the parameters of a function, if anything.
    fn member(&self) -> &str {
        ""
    }

    /// Where it is evaluated.
    fn places(&self, precision: Precision) -> Vec<Place>;

    /// How many of the places have the parameters v of a grid, from the first one on.
    fn rows(&self) -> usize {
        4
    }

    /// What a function should give at a place.
    fn outcome(&self, function: &Function, precision: Precision, place: Place) -> Outcome;
}

/// A surface by the names of its functions in C and what stands before their parameters, with its expansion.
pub(crate) struct Expanded<'a>(pub &'a str, pub &'a str, pub &'a dyn Evaluator);

impl Called for Expanded<'_> {
    fn name(&self) -> &str {
        self.0
    }

    fn member(&self) -> &str {
        self.1
    }

    fn places(&self, precision: Precision) -> Vec<Place> {
        places(self.2, precision)
    }

    fn outcome(&self, function: &Function, precision: Precision, place: Place) -> Outcome {
        function.outcome(self.2, Rounding { precision, variant: Variant::Plain }, place)
    }
}

/// The C code that evaluates everything at the places, and the lines that it prints.
pub(crate) fn evaluation(text: &mut String, expected: &mut Expected, surface: &dyn Called) {
    let (name, member) = (surface.name(), surface.member());
    for kind in TYPES {
        let Type { name: real, suffix, bits, precision } = kind;
        let places = surface.places(precision);
        let list: Vec<String> = places
            .iter()
            .map(|&(u, v, r)| format!("{{0x{}, 0x{}, 0x{}}}", kind.digits(u), kind.digits(v), kind.digits(r)))
            .collect();
        _ = writeln!(
            text,
            "    {{\n        static const {bits} places[{POINTS}][3] = {{{}}};",
            list.join(", ")
        );
        _ = writeln!(text, "        static {real} us[{POINTS}], vs[{POINTS}], rs[{POINTS}];");
        _ = writeln!(text, "        for (size_t i = 0; i < {POINTS}; i++) {{");
        for (k, letter) in ["us", "vs", "rs"].iter().enumerate() {
            _ = writeln!(text, "            memcpy(&{letter}[i], &places[i][{k}], sizeof {letter}[i]);");
        }
        _ = writeln!(text, "        }}");
        for function in &FUNCTIONS {
            let Function { name: method, size, .. } = function;
            let (declaration, result) = function.result(kind, "result");
            let distance = if function.is_offset() { "rs[i], " } else { "" };
            let pointer = function.pointer(kind, (name, member));
            _ = writeln!(
                text,
                "        {{
        {pointer};
        for (size_t i = 0; i < {POINTS}; i++) {{
            {declaration};
            const hodograph_status status = evaluate({member}{distance}us[i], vs[i], {result});
            put{suffix}(status, {result}, {size});
        }}
        }}"
            );
            let outcome = |&place: &Place| surface.outcome(function, precision, place);
            for place in &places {
                let label = format!("{method} of {name} at {place:?}, {real}");
                expected.push((label, kind.outcome(&outcome(place))));
            }
            let Some(prefix) = function.batch else { continue };
            batches(text, surface, prefix, kind, function);
            let grid = places[..surface.rows()].iter().flat_map(|&(_, v, _)| {
                places[..COLUMNS]
                    .iter()
                    .map(move |&(u, ..)| surface.outcome(function, precision, (u, v, 0.0)))
            });
            let of_grid = missing(grid);
            let of_points = missing(places.iter().map(outcome));
            for (what, line) in [("grid", &of_grid), ("points", &of_points), ("rows", &of_grid)] {
                expected.push((format!("{what} of {method} of {name}, {real}"), line.clone()));
            }
        }
        text.push_str("    }\n");
    }
}

/// What is printed of a batch that has the results of single evaluations.
fn missing(outcomes: impl Iterator<Item = Outcome>) -> String {
    let places: Vec<usize> =
        outcomes.enumerate().filter(|(_, outcome)| outcome.is_err()).map(|(i, _)| i).collect();
    format!("equal, {} missing from {}", places.len(), places.first().copied().unwrap_or(0))
}

/// The C code that evaluates batches, and compares them with single evaluations.
fn batches(text: &mut String, surface: &dyn Called, prefix: &str, kind: Type, function: &Function) {
    let (name, member, rows) = (surface.name(), surface.member(), surface.rows());
    let (suffix, size) = (kind.suffix, function.size);
    let (declaration, result) = function.result(kind, "result");
    let (out, _) = function.result(kind, &format!("out[{}]", rows * COLUMNS));
    let out = match function.structure {
        Some(_) => out,
        None => format!("{} out[{}][{size}]", kind.name, rows * COLUMNS),
    };
    let pointer = function.pointer(kind, (name, member));
    let none = if function.needs_normal() { "0" } else { "INFINITY" };
    _ = writeln!(
        text,
        "        {{
            {pointer};
            static {out};
            static {name}_{task}_of_u{suffix} strip[{COLUMNS}];
            hodograph_missing missing, expected = {{0, 0}};
            bool equal = true;
            missing = {name}_{prefix}grid{suffix}({member}us, {COLUMNS}, vs, {rows}, out);
            for (size_t i = 0; i < {rows} * {COLUMNS}; i++) {{
                {declaration};
                const hodograph_status status = evaluate({member}us[i % {COLUMNS}], vs[i / {COLUMNS}], {result});
                equal &= same{suffix}(status, {result}, &out[i], {size}, {none}, i, &expected);
            }}
            report(equal, missing, expected);
            expected.count = expected.first = 0;
            equal = true;
            missing = {name}_{prefix}points{suffix}({member}us, vs, {POINTS}, out);
            for (size_t i = 0; i < {POINTS}; i++) {{
                {declaration};
                const hodograph_status status = evaluate({member}us[i], vs[i], {result});
                equal &= same{suffix}(status, {result}, &out[i], {size}, {none}, i, &expected);
            }}
            report(equal, missing, expected);
            expected.count = expected.first = 0;
            equal = true;
            missing = expected;
            {name}_{prefix}prepare{suffix}({member}us, {COLUMNS}, strip);
            for (size_t j = 0; j < {rows}; j++) {{
                hodograph_add(&missing, {name}_{prefix}row{suffix}({member}strip, {COLUMNS}, vs[j], out), j * {COLUMNS});
                for (size_t i = 0; i < {COLUMNS}; i++) {{
                    {declaration};
                    const hodograph_status status = evaluate({member}us[i], vs[j], {result});
                    equal &= same{suffix}(status, {result}, &out[i], {size}, {none}, j * {COLUMNS} + i, &expected);
                }}
            }}
            report(equal, missing, expected);
        }}",
        task = if prefix.is_empty() { "point" } else { prefix.trim_end_matches('_') },
    );
}
