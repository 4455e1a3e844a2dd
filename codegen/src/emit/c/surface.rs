//! The evaluators of a surface in one precision.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::super::code::Code;
use super::super::expression::{Body, Expression};
use super::super::stages::Frontier;
use super::super::task::{TASKS, Task};
use super::Type;
use super::expression::{variable, write};
use super::form::{Form, SELECTED, Selected};
use super::template::fill;
use crate::program::{Input, Value};
use crate::schedule::outputs;

/// All functions of a surface.
pub(super) fn evaluators(name: &str, code: &Code<'_>, kind: Type) -> String {
    let writer = Writer { name, code, kind };
    let stages: String = TASKS.iter().map(|task| writer.stages(task)).collect();
    let reason = writer.fill(include_str!("reason.h.in"), &[]);
    let tasks: String = TASKS.iter().map(|task| writer.task(task)).collect();
    let selected: String = SELECTED.iter().map(|selected| writer.selected(selected)).collect();
    let offset = writer.fill(include_str!("offset.h.in"), &[]);
    [stages, reason, tasks, selected, offset].concat()
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
        let (stages, size) = (self.stages_of(&Form::of(task)), results.len().to_string());
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
    fn stages_of(&self, form: &Form) -> String {
        format!("{}_{}", self.name, form.stage)
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
        let form = Form::of(task);
        let program = self.code.program;
        let results = task.results(program);
        let size = results.len().to_string();
        let [one, many] = form.out(self.kind, results.len());
        let documentation = format!("The {} at (u, v), in {}.", form.text, program.count_all(&results));
        let reason = match task.outputs {
            // They exist at poles.
            [outputs::HOMOGENEOUS] => self.fill("hodograph_out_of_range@f@(u, v)", &[]),
            _ => self.reason(form.needs_normal),
        };
        let (none, none_text) = form.none(self.kind);
        let (stages, batch) = (self.stages_of(&form), format!("{}_{}", self.name, form.batch));
        let values = [("task", stages.as_str()), ("size", &size)];
        let single = self.fill(
            include_str!("evaluator.h.in"),
            &[
                values.as_slice(),
                &[
                    ("function", form.function),
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
                    ("text", form.text),
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
    fn selected(&self, selected: &Selected) -> String {
        let Selected { function, text, output, first, size } = *selected;
        let program = self.code.program;
        let results = &program.results(output)[first..first + size];
        let body = self.code.body(results, &BTreeMap::new());
        let mut numbers = self.numbers(&body);
        for (input, letter) in [(Input::U, "u"), (Input::V, "v")] {
            if !body.inputs.contains(&input) {
                _ = writeln!(numbers, "    (void){letter};");
            }
        }
        let (name, size) = (format!("{}_{function}", self.name), size.to_string());
        let out = selected.out(self.kind);
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
