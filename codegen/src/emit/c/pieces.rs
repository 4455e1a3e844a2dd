//! Surfaces of several pieces in C: the functions of the whole, which call those of the piece that v belongs to.

use super::super::documentation::of_pieces;
use super::super::pieces::Whole;
use super::super::task::{TASKS, Task};
use super::form::{Form, SELECTED, Selected};
use super::template::fill;
use super::{DOUBLE, SINGLE, Type, constants, prefix, section};

/// The section of a surface that consists of the pieces before it.
pub(super) fn whole(text: &mut String, whole: Whole<'_>) {
    let name = &prefix(whole.name);
    let mut content = constants::of_whole(name, whole);
    for kind in [DOUBLE, SINGLE] {
        content.push_str(&evaluators(name, whole, kind));
    }
    section(text, name, &of_pieces(whole, |piece| format!("`{piece}`")), &content);
}

/// All functions of the whole.
fn evaluators(name: &str, whole: Whole<'_>, kind: Type) -> String {
    let pieces = whole.pieces.iter().map(|piece| prefix(&piece.name)).collect();
    let sizes = whole.pieces.first().map(|piece| &piece.program);
    let writer = Writer { name, pieces, kind };
    let mut text = writer.fill(include_str!("piece.h.in"), &[]);
    for task in &TASKS {
        text += &writer.task(task, sizes.map_or(0, |program| task.results(program).len()));
    }
    text.extend(SELECTED.iter().map(|selected| writer.selected(selected)));
    text += &writer.offset(
        "offset_point",
        "The point R + r N of the offset surface at the signed distance r along the unit normal N.",
        &format!("{} out[3]", kind.real),
    );
    text += &writer.offset(
        "offset_first_order",
        "The point R + r N of the offset surface with its derivatives R_u + r N_u and R_v + r N_v.",
        &format!("hodograph_first_order{} *out", kind.suffix),
    );
    text
}

struct Writer<'a> {
    name: &'a str,
    /// The names of the pieces.
    pieces: Vec<String>,
    kind: Type,
}

impl Writer<'_> {
    /// Fills a template with what is common to all, and with `values`.
    fn fill(&self, template: &str, values: &[(&str, &str)]) -> String {
        let common = [("name", self.name), ("real", self.kind.real), ("f", self.kind.suffix)];
        fill(template, &[common.as_slice(), values].concat())
    }

    /// The text of a template for each of the pieces, filled with the piece's name, its number from 1 on and its label in a
    /// `switch` over all pieces, and with `values`.
    fn each(&self, template: &str, values: &[(&str, &str)]) -> String {
        let of_piece = |(index, piece): (usize, &String)| {
            let number = (index + 1).to_string();
            let label =
                if index + 1 < self.pieces.len() { format!("case {index}") } else { "default".into() };
            let own = [("piece", piece.as_str()), ("number", &number), ("label", &label)];
            self.fill(template, &[own.as_slice(), values].concat())
        };
        self.pieces.iter().enumerate().map(of_piece).collect()
    }

    /// A function for one place, by that of the piece.
    fn single(&self, function: &str, documentation: &str, distance: [&str; 2], out: &str) -> String {
        let [distance_type, distance] = distance;
        let case = "    @label@:\n        return @piece@_@function@@f@(@distance@u, v, out);\n";
        let cases = self.each(case, &[("function", function), ("distance", distance)]);
        self.fill(
            include_str!("whole.h.in"),
            &[
                ("function", function),
                ("documentation", documentation),
                ("distance_type", distance_type),
                ("out", out),
                ("cases", &cases),
            ],
        )
    }

    /// The function of a single result.
    fn selected(&self, selected: &Selected) -> String {
        let documentation = format!("The {} at (u, v), by the piece that v belongs to.", selected.text);
        self.single(selected.function, &documentation, ["", ""], &selected.out(self.kind))
    }

    /// A function of an offset.
    fn offset(&self, function: &str, documentation: &str, out: &str) -> String {
        let distance_type = format!("{} r, ", self.kind.real);
        self.single(function, documentation, [&distance_type, "r, "], out)
    }

    /// The function of a task for one place, and those for many.
    fn task(&self, task: &Task, size: usize) -> String {
        let form = Form::of(task);
        let [one, many] = form.out(self.kind, size);
        let documentation = format!("The {} at (u, v), by the piece that v belongs to.", form.text);
        let single = self.single(form.function, &documentation, ["", ""], &one);
        let (none, none_text) = form.none(self.kind);
        let name = |own: &str| format!("{}_{own}", self.name);
        let size = size.to_string();
        let values =
            [("stage", form.stage.as_str()), ("batch", form.batch), ("size", &size), ("none", &none)];
        let each = |template: &str| self.each(template, &values);
        let batches = self.fill(
            include_str!("whole_batches.h.in"),
            &[
                ("task", &name(&form.stage)),
                ("text", form.text),
                ("batch", &name(form.batch)),
                ("out", &many),
                ("size", &size),
                ("none_text", none_text),
                ("fields", &each("    @piece@_@stage@_of_u@f@ piece_@number@;\n")),
                ("stages", &each("        strip[i].piece_@number@ = @piece@_@stage@_stage_u@f@(us[i]);\n")),
                ("rows", &each(include_str!("whole_row.h.in"))),
                ("grids", &each(include_str!("whole_grid.h.in"))),
                ("points", &each(include_str!("whole_points.h.in"))),
            ],
        );
        single + &batches
    }
}
