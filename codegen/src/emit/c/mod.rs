//! A self-contained C11 header with the evaluators of surfaces, in both precisions.
//!
//! Its functions have the bits of the plain variant, on machines and with options that compute as IEEE 754 has it: the header
//! checks what it can of that.

mod expression;

use std::collections::BTreeMap;
use std::fmt::Write;

use expression::{variable, write};

use super::code::{Code, Field, Number};
use super::expression::Expression;
use super::stages::Frontier;
use super::task::{TASKS, Task};
use super::{Artifact, Setting, documentation};
use crate::program::{Input, Stage, Value};

/// The precision of a function.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Precision {
    /// `float`
    Single,
    /// `double`
    Double,
}

impl Precision {
    fn name(self) -> &'static str {
        match self {
            Precision::Single => "float",
            Precision::Double => "double",
        }
    }

    /// What names of functions end with, as in `sqrtf`.
    fn suffix(self) -> &'static str {
        match self {
            Precision::Single => "f",
            Precision::Double => "",
        }
    }

    /// A number, with the fewest digits that are read back as the same.
    fn literal(self, number: f64) -> String {
        match self {
            // Beyond the range of the precision: results are infinite, which functions tell.
            Precision::Single if !(number as f32).is_finite() => {
                if number < 0.0 { "-INFINITY" } else { "INFINITY" }.to_string()
            }
            Precision::Single => format!("{:?}f", number as f32),
            Precision::Double => format!("{number:?}"),
        }
    }
}

/// The header for `artifacts`.
///
/// For each sweep `name` it has `name_point(u, v, out)` and the like for the tasks of [`TASKS`], with `f` after the name in single
/// precision, which return whether all numbers are finite; `name_grid`; and for a family a struct that `name_set` fills with
/// the member's coefficients.
///
/// # Example
/// ```
/// use hodograph_codegen::{compile::compile, emit, language::parse_text, meaning::models};
///
/// let text = "sweep saddle { surface R = (u, v, u*v); domain u in 0..1, v in 0..1; }";
/// let (file, _source) = parse_text("saddle.sweep", text).unwrap();
/// let header = emit::header(&[compile(&models(&file).0[0]).unwrap()]);
/// assert!(header.contains("static inline bool saddle_point(double u, double v, double out[3])"));
/// ```
#[must_use]
pub fn header(artifacts: &[Artifact]) -> String {
    let mut text = PROLOGUE.to_string();
    for artifact in artifacts {
        surface(&mut text, artifact);
    }
    text
}

/// What every header begins with.
const PROLOGUE: &str = include_str!("prologue.h");

fn surface(text: &mut String, artifact: &Artifact) {
    let name = &artifact.name;
    let guard = format!("HODOGRAPH_{}", name.to_uppercase());
    let runtime = proc_macro2::TokenStream::new();
    let code = &Code::new(&artifact.program, &runtime);
    text.push_str("\n/*\n");
    for line in documentation::lines(artifact) {
        let line = line.replace("*/", "* /");
        _ = writeln!(text, " *{}{}", if line.is_empty() { "" } else { " " }, line);
    }
    _ = write!(text, " */\n#ifndef {guard}\n#define {guard}\n\n");
    if code.is_family() {
        family(text, artifact, code);
    }
    let frontiers: Vec<Frontier> =
        TASKS.iter().map(|task| Frontier::of(code.program, &task.results(code.program))).collect();
    for precision in [Precision::Double, Precision::Single] {
        for input in [Input::U, Input::V] {
            let of =
                |frontier: &Frontier| if input == Input::U { frontier.u.clone() } else { frontier.v.clone() };
            let mut values: Vec<Value> = frontiers.iter().flat_map(of).collect();
            values.sort();
            values.dedup();
            part(text, artifact, code, precision, input, &values);
        }
        for (task, frontier) in TASKS.iter().zip(&frontiers) {
            evaluator(text, artifact, code, precision, task, frontier);
        }
        grid(text, artifact, code, precision);
    }
    _ = writeln!(text, "#endif");
}

/// The parameter list of a function: the member of a family first.
fn parameters(artifact: &Artifact, code: &Code<'_>, rest: &str) -> String {
    match code.is_family() {
        true => format!("const {} *surface, {rest}", artifact.name),
        false => rest.to_string(),
    }
}

/// The first argument of a call within.
fn member(code: &Code<'_>) -> &'static str {
    if code.is_family() { "surface, " } else { "" }
}

fn letter(input: Input) -> &'static str {
    if input == Input::U { "u" } else { "v" }
}

/// The struct of what is needed of one parameter alone, and the function that computes it.
fn part(
    text: &mut String,
    artifact: &Artifact,
    code: &Code<'_>,
    precision: Precision,
    input: Input,
    values: &[Value],
) {
    let (name, real, suffix, letter) = (&artifact.name, precision.name(), precision.suffix(), letter(input));
    let fields: Vec<String> =
        values.iter().map(|&value| variable(&code.names.of(code.program, value))).collect();
    _ = writeln!(text, "/* What points need of {letter} alone. */");
    // C has no empty structs.
    let declared = if fields.is_empty() { "unused".to_string() } else { fields.join(", ") };
    _ = writeln!(text, "typedef struct {{ {real} {declared}; }} {name}_of_{letter}{suffix};\n");
    let body = code.body(values, &BTreeMap::new());
    let (statements, results) = write(code, precision, &body);
    let list = parameters(artifact, code, &format!("{real} {letter}"));
    _ = writeln!(
        text,
        "static inline {name}_of_{letter}{suffix} {name}_values_of_{letter}{suffix}({list})\n{{"
    );
    _ = writeln!(text, "    {name}_of_{letter}{suffix} values;");
    for statement in statements {
        _ = writeln!(text, "    {statement}");
    }
    for (field, result) in fields.iter().zip(results) {
        _ = writeln!(text, "    values.{field} = {result};");
    }
    if fields.is_empty() {
        _ = writeln!(text, "    values.unused = {};", precision.literal(0.0));
    }
    if !body.inputs.contains(&input) {
        _ = writeln!(text, "    (void){letter};");
    }
    if code.is_family() {
        _ = writeln!(text, "    (void)surface;");
    }
    _ = writeln!(text, "    return values;\n}}\n");
}

/// The C name of a task.
fn task_name(task: &Task) -> String {
    task.name.to_lowercase()
}

/// The function that joins both parts for a task, and the one that evaluates it at a place.
fn evaluator(
    text: &mut String,
    artifact: &Artifact,
    code: &Code<'_>,
    precision: Precision,
    task: &Task,
    frontier: &Frontier,
) {
    let (name, real, suffix) = (&artifact.name, precision.name(), precision.suffix());
    let program = code.program;
    let results = task.results(program);
    let mut given = BTreeMap::new();
    for (part, values) in [("of_u", &frontier.u), ("of_v", &frontier.v)] {
        for &value in values {
            let field = variable(&code.names.of(program, value));
            given.insert(value, Expression::Variable(format!("{part}->{field}")));
        }
    }
    let (statements, joined) = write(code, precision, &code.body(&results, &given));
    let (function, size) = (task_name(task), results.len());
    let list = parameters(
        artifact,
        code,
        &format!("const {name}_of_u{suffix} *of_u, const {name}_of_v{suffix} *of_v, {real} out[{size}]"),
    );
    _ = writeln!(text, "static inline bool {name}_join_{function}{suffix}({list})\n{{");
    for statement in statements {
        _ = writeln!(text, "    {statement}");
    }
    for (place, result) in joined.iter().enumerate() {
        _ = writeln!(text, "    out[{place}] = {result};");
    }
    for unused in ["of_u", "of_v"].into_iter().chain(code.is_family().then_some("surface")) {
        _ = writeln!(text, "    (void){unused};");
    }
    _ = writeln!(text, "    return hodograph_all_finite{suffix}(out, {size});\n}}\n");
    let total = program.count_all(&results);
    _ = writeln!(
        text,
        "/* The {} at (u, v), in {total}. False where a number is not finite. */",
        layout(task, program)
    );
    let list = parameters(artifact, code, &format!("{real} u, {real} v, {real} out[{size}]"));
    let member = member(code);
    _ = writeln!(
        text,
        "static inline bool {name}_{function}{suffix}({list})\n{{\n    const {name}_of_u{suffix} of_u = {name}_values_of_u{suffix}({member}u);\n    const {name}_of_v{suffix} of_v = {name}_values_of_v{suffix}({member}v);\n    return {name}_join_{function}{suffix}({member}&of_u, &of_v, out);\n}}\n"
    );
}

/// The outputs of a task with their lengths.
fn layout(task: &Task, program: &crate::program::Program<f64>) -> String {
    let part = |output: &&str| format!("{}[{}]", output, program.results(output).len());
    task.outputs.iter().map(part).collect::<Vec<_>>().join(", ")
}

/// The function that evaluates the point on a grid.
fn grid(text: &mut String, artifact: &Artifact, code: &Code<'_>, precision: Precision) {
    let (name, real, suffix, member) = (&artifact.name, precision.name(), precision.suffix(), member(code));
    let list = parameters(
        artifact,
        code,
        &format!("const {real} *us, size_t columns, const {real} *vs, size_t rows, {real} (*out)[3]"),
    );
    _ = writeln!(
        text,
        "/* The point at (us[i], vs[j]) as out[j * columns + i], with the bits of {name}_point{suffix}. False where one is not finite. */
static inline bool {name}_grid{suffix}({list})
{{
    {name}_of_u{suffix} strip[HODOGRAPH_STRIP];
    bool finite = true;
    for (size_t start = 0; start < columns; start += HODOGRAPH_STRIP) {{
        const size_t length = columns - start < HODOGRAPH_STRIP ? columns - start : HODOGRAPH_STRIP;
        for (size_t i = 0; i < length; i++)
            strip[i] = {name}_values_of_u{suffix}({member}us[start + i]);
        for (size_t j = 0; j < rows; j++) {{
            const {name}_of_v{suffix} of_v = {name}_values_of_v{suffix}({member}vs[j]);
            for (size_t i = 0; i < length; i++)
                finite &= {name}_join_point{suffix}({member}&strip[i], &of_v, out[j * columns + start + i]);
        }}
    }}
    return finite;
}}
"
    );
}

/// The struct of a member's coefficients, and the function that computes them.
fn family(text: &mut String, artifact: &Artifact, code: &Code<'_>) {
    let name = &artifact.name;
    _ = writeln!(text, "/* A surface of the family, made by {name}_set. */\ntypedef struct {{");
    for (field, values) in &code.fields {
        _ = writeln!(text, "    double {field}[{}];", values.len());
    }
    _ = writeln!(text, "}} {name};\n");
    let mut parameters = vec![format!("{name} *surface")];
    let mut symbols = Vec::new();
    for setting in &artifact.symbols {
        match setting {
            Setting::Number(symbol) => parameters.push(format!("double {}", variable(symbol))),
            Setting::Curve { name, rows, .. } => {
                let width = rows.first().map_or(0, Vec::len);
                parameters.push(format!("const double {name}_rows[{}][{width}]", rows.len()));
                for (i, row) in rows.iter().enumerate() {
                    for (j, symbol) in row.iter().enumerate() {
                        symbols.push((symbol, format!("{name}_rows[{i}][{j}]")));
                    }
                }
            }
        }
    }
    _ = writeln!(
        text,
        "/* The coefficients of a member. Where its weight vanishes, evaluators return false. */"
    );
    _ = writeln!(text, "static inline void {name}_set({})\n{{", parameters.join(", "));
    for (symbol, place) in symbols {
        _ = writeln!(text, "    const double {0} = {place};\n    (void){0};", variable(symbol));
    }
    let (values, fields) = code.computed();
    let body = super::expression::Body::new(code, &values, &BTreeMap::new());
    let (statements, results) = write(code, Precision::Double, &body);
    for statement in statements {
        _ = writeln!(text, "    {statement}");
    }
    for Field { name, numbers } in fields {
        for (place, number) in numbers.into_iter().enumerate() {
            let result = match number {
                Number::Computed(place) => results[place].clone(),
                Number::Constant(number) => Precision::Double.literal(number),
            };
            _ = writeln!(text, "    surface->{name}[{place}] = {result};");
        }
    }
    _ = writeln!(text, "}}\n");
    debug_assert!(values.iter().all(|&value| code.program.stage(value) <= Stage::Symbols));
}
