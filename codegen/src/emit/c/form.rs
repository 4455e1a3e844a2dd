//! How results are passed in C, and what their functions are called.

use super::super::task::Task;
use super::Type;
use crate::schedule::outputs;

/// A single result, which an output of the program holds beside others.
pub(super) struct Selected {
    /// What its function is named after.
    pub(super) function: &'static str,
    /// What it is.
    pub(super) text: &'static str,
    /// The output that holds it.
    pub(super) output: &'static str,
    /// Its first number there.
    pub(super) first: usize,
    /// How many numbers it has.
    pub(super) size: usize,
}

/// All single results.
pub(super) const SELECTED: [Selected; 4] = [
    Selected::new("partial_u", "derivative R_u", outputs::PARTIAL_U, (0, 3)),
    Selected::new("partial_v", "derivative R_v", outputs::PARTIAL_V, (0, 3)),
    Selected::new("speed_u", "parametric speed |R_u|", outputs::SPEEDS, (0, 1)),
    Selected::new("speed_v", "parametric speed |R_v|", outputs::SPEEDS, (1, 1)),
];

impl Selected {
    const fn new(
        function: &'static str,
        text: &'static str,
        output: &'static str,
        (first, size): (usize, usize),
    ) -> Selected {
        Selected { function, text, output, first, size }
    }

    /// The declaration of its function's `out`.
    pub(super) fn out(&self, kind: Type) -> String {
        match self.size {
            1 => format!("{} *out", kind.real),
            size => format!("{} out[{size}]", kind.real),
        }
    }
}

/// How results of a task are passed.
pub(super) struct Form {
    /// What it is.
    pub(super) text: &'static str,
    /// What its function is named after.
    pub(super) function: &'static str,
    /// What the names of its batches begin with.
    pub(super) batch: &'static str,
    /// What the names of its stages begin with.
    pub(super) stage: String,
    /// The type of the result, if it is a struct.
    structure: Option<&'static str>,
    /// Whether there is none where the surface has no normal.
    pub(super) needs_normal: bool,
}

impl Form {
    pub(super) fn of(task: &Task) -> Form {
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
        let text = match task.name {
            "Separated" => "point as it is computed together with derivatives,",
            "Normal" => "unit normal in the direction of R_u x R_v",
            "Local" => "local geometry (derivatives, normal, fundamental forms, curvatures)",
            _ => task.text,
        };
        let (stage, needs_normal) = (task.name.to_lowercase(), task.outputs.contains(&outputs::UNIT_NORMAL));
        Form { text, function, batch, stage, structure, needs_normal }
    }

    /// The declarations of `out` for one result of so many numbers, and for many results.
    pub(super) fn out(&self, Type { real, suffix, .. }: Type, size: usize) -> [String; 2] {
        match self.structure {
            Some(name) => [format!("{name}{suffix} *out"), format!("{name}{suffix} *out")],
            None => [format!("{real} out[{size}]"), format!("{real} (*out)[{size}]")],
        }
    }

    /// What batches write for each number of a result that does not exist, and what is said of it.
    pub(super) fn none(&self, kind: Type) -> (String, &'static str) {
        match self.needs_normal {
            true => (kind.literal(0.0), "All numbers of one that does not exist are zero."),
            false => ("INFINITY".to_string(), "All numbers of one that does not exist are infinite."),
        }
    }
}
