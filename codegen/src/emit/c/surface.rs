//! The evaluators of a surface in one precision.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::super::code::Code;
use super::super::expression::{Body, Expression};
use super::super::stages::Frontier;
use super::super::task::{TASKS, Task};
use super::Type;
use super::expression::{variable, write};
use super::template::fill;
use crate::program::{Input, Value};
use crate::schedule::outputs;

/// What single results are named, each with the output of the program that holds it, its first number there and their count.
const SELECTED: [(&str, &str, &str, usize, usize); 4] = [
    ("partial_u", "derivative R_u", outputs::PARTIAL_U, 0, 3),
    ("partial_v", "derivative R_v", outputs::PARTIAL_V, 0, 3),
    ("speed_u", "parametric speed |R_u|", outputs::SPEEDS, 0, 1),
    ("speed_v", "parametric speed |R_v|", outputs::SPEEDS, 1, 1),
];

/// All functions of a surface.
pub(super) fn evaluators(name: &str, code: &Code<'_>, kind: Type) -> String {
    let writer = Writer { name, code, kind };
    let stages: String = TASKS.iter().map(|task| writer.stages(task)).collect();
    let reason = writer.fill(include_str!("reason.h.in"), &[]);
    let tasks: String = TASKS.iter().map(|task| writer.task(task)).collect();
    let selected: String = SELECTED.iter().map(|selected| writer.selected(*selected)).collect();
    let offset = writer.fill(include_str!("offset.h.in"), &[]);
    [stages, reason, tasks, selected, offset].concat()
}

/// How results of a task are passed.
struct Form {
    /// What its function is named after.
    function: &'static str,
    /// What the names of its batches begin with.
    batch: &'static str,
    /// The type of the result, if it is a struct.
    structure: Option<&'static str>,
    /// Whether there is none where the surface has no normal.
    needs_normal: bool,
}

impl Form {
    fn of(task: &Task) -> Form {
        let (function, batch, structure) = match task.name {
            "Homogeneous" => ("homogeneous", "homogeneous_", None),
            "Point" => ("point", "", None),
            "Separated" => ("separated_point", "separated_", None),
            "First" => ("first_order", "first_", Some("hodograph_first_order")),
            "Second" => ("second_order", "second_", Some("hodograph_second_order")),
            "Normal" => ("unit_normal", "normal_", None),
            "Local" => ("local_geometry", "local_", Some("hodograph_local_geometry")),
            other => unreachable!("the task {other} has no form in C"),
        };
        Form { function, batch, structure, needs_normal: task.outputs.contains(&outputs::UNIT_NORMAL) }
    }
}

struct Writer<'a> {
    name: &'a str,
    code: &'a Code<'a>,
    kind: Type,
}

impl Writer<'_> {
    /// Fills a template with what is common to all, and with `values`.
    fn fill(&self, template: &str, values: &[(&str, &str)]) -> String {
        let Type { real, suffix, .. } = self.kind;
        let (member_type, member) = match self.code.is_family() {
            true => (format!("const {}_surface *surface, ", self.name), "surface, "),
            false => (String::new(), ""),
        };
        let common = [
            ("name", self.name),
            ("real", real),
            ("f", suffix),
            ("member_type", member_type.as_str()),
            ("member", member),
        ];
        fill(template, &[common.as_slice(), values].concat())
    }

    /// The stages of a task.
    fn stages(&self, task: &Task) -> String {
        let program = self.code.program;
        let results = task.results(program);
        let frontier = Frontier::of(program, &results);
        let mut given = BTreeMap::new();
        for (part, values) in [("of_u", &frontier.u), ("of_v", &frontier.v)] {
            for &value in values {
                let field = variable(&self.code.names.of(program, value));
                given.insert(value, Expression::Variable(format!("{part}->{field}")));
            }
        }
        let mut body = self.numbers(&self.code.body(&results, &given));
        for (part, values) in [("of_u", &frontier.u), ("of_v", &frontier.v)] {
            if values.is_empty() {
                _ = writeln!(body, "    (void){part};");
            }
        }
        let [(u_fields, u_body), (v_fields, v_body)] =
            [(Input::U, "u", &frontier.u), (Input::V, "v", &frontier.v)]
                .map(|(input, letter, values)| self.stage(input, letter, values));
        let (stages, size) = (self.stage_name(task.name), results.len().to_string());
        self.fill(
            include_str!("stages.h.in"),
            &[
                ("task", &stages),
                ("text", task.text),
                ("size", &size),
                ("u_fields", &u_fields),
                ("u_body", &u_body),
                ("v_fields", &v_fields),
                ("v_body", &v_body),
                ("body", &body),
            ],
        )
    }

    /// What the functions of a task's stages begin with.
    fn stage_name(&self, task: &str) -> String {
        format!("{}_{}", self.name, task.to_lowercase())
    }

    /// The fields of what is needed of one parameter alone, and the statements that compute them.
    fn stage(&self, input: Input, letter: &str, values: &[Value]) -> (String, String) {
        let program = self.code.program;
        // C has no empty structs.
        if values.is_empty() {
            let zero = self.kind.literal(0.0);
            return (
                "unused".to_string(),
                self.mark_unused(format!("    values.unused = {zero};\n"), letter),
            );
        }
        let fields: Vec<String> =
            values.iter().map(|&value| variable(&self.code.names.of(program, value))).collect();
        let body = self.code.body(values, &BTreeMap::new());
        let (statements, results) = write(self.code, self.kind, &body);
        let mut text = String::new();
        for statement in statements {
            _ = writeln!(text, "    {statement}");
        }
        for (field, result) in fields.iter().zip(results) {
            _ = writeln!(text, "    values.{field} = {result};");
        }
        let unread = if body.inputs.contains(&input) { "" } else { letter };
        (fields.join(", "), self.mark_unused(text, unread))
    }

    /// The statements that write results to `out`.
    fn numbers(&self, body: &Body) -> String {
        let (statements, results) = write(self.code, self.kind, body);
        let mut text = String::new();
        for statement in statements {
            _ = writeln!(text, "    {statement}");
        }
        for (place, result) in results.iter().enumerate() {
            _ = writeln!(text, "    out[{place}] = {result};");
        }
        self.mark_unused(text, "")
    }

    /// Marks a parameter, if it has a name, and the surface where a body does not read it.
    fn mark_unused(&self, mut body: String, parameter: &str) -> String {
        if !parameter.is_empty() {
            _ = writeln!(body, "    (void){parameter};");
        }
        if self.code.is_family() && !body.contains("surface->") {
            _ = writeln!(body, "    (void)surface;");
        }
        body
    }

    /// The function of a task for one place, and those for many.
    fn task(&self, task: &Task) -> String {
        let Form { function, batch, structure, needs_normal } = Form::of(task);
        let (program, Type { real, suffix, .. }) = (self.code.program, self.kind);
        let results = task.results(program);
        let size = results.len().to_string();
        let (one, many) = match structure {
            Some(name) => (format!("{name}{suffix} *out"), format!("{name}{suffix} *out")),
            None => (format!("{real} out[{size}]"), format!("{real} (*out)[{size}]")),
        };
        let documentation = format!("The {} at (u, v), in {}.", task.text, program.count_all(&results));
        let reason = match task.outputs {
            // They exist at poles.
            [outputs::HOMOGENEOUS] => self.fill("hodograph_out_of_range@f@(u, v)", &[]),
            _ => self.reason(needs_normal),
        };
        let (none, none_text) = match needs_normal {
            true => (self.kind.literal(0.0), "All numbers of one that does not exist are zero."),
            false => ("INFINITY".to_string(), "All numbers of one that does not exist are infinite."),
        };
        let (stages, batch) = (self.stage_name(task.name), format!("{}_{batch}", self.name));
        let values = [("task", stages.as_str()), ("size", &size)];
        let single = self.fill(
            include_str!("evaluator.h.in"),
            &[
                values.as_slice(),
                &[
                    ("function", function),
                    ("documentation", &documentation),
                    ("out", &one),
                    ("reason", &reason),
                ],
            ]
            .concat(),
        );
        let batches = self.fill(
            include_str!("batches.h.in"),
            &[
                values.as_slice(),
                &[
                    ("text", task.text),
                    ("batch", &batch),
                    ("out", &many),
                    ("none", &none),
                    ("none_text", none_text),
                ],
            ]
            .concat(),
        );
        single + &batches
    }

    /// The expression for why a result does not exist.
    fn reason(&self, needs_normal: bool) -> String {
        let needs_normal = if needs_normal { "true" } else { "false" };
        self.fill("@name@_reason@f@(@member@u, v, @needs_normal@)", &[("needs_normal", needs_normal)])
    }

    /// The function of a single result.
    fn selected(&self, (function, text, output, first, count): (&str, &str, &str, usize, usize)) -> String {
        let program = self.code.program;
        let results = &program.results(output)[first..first + count];
        let body = self.code.body(results, &BTreeMap::new());
        let mut numbers = self.numbers(&body);
        for (input, letter) in [(Input::U, "u"), (Input::V, "v")] {
            if !body.inputs.contains(&input) {
                _ = writeln!(numbers, "    (void){letter};");
            }
        }
        let (name, size) = (format!("{}_{function}", self.name), count.to_string());
        let out = match count {
            1 => format!("{} *out", self.kind.real),
            _ => format!("{} out[{size}]", self.kind.real),
        };
        let documentation = format!("The {text} at (u, v), in {}.", program.count_all(results));
        let reason = self.reason(false);
        let template = concat!(include_str!("direct.h.in"), include_str!("evaluator.h.in"));
        self.fill(
            template,
            &[
                ("task", &name),
                ("size", &size),
                ("body", &numbers),
                ("function", function),
                ("documentation", &documentation),
                ("out", &out),
                ("reason", &reason),
            ],
        )
    }
}
