//! Tasks: what evaluators compute in one pass.

use crate::program::{Program, Value};
use crate::proofs::BOUNDED;
use crate::schedule::outputs;

/// Several outputs of a program that are evaluated together.
#[derive(Clone, Copy, Debug)]
pub struct Task {
    /// The name of the runtime's type for it.
    pub name: &'static str,
    /// What it computes, for documentation.
    pub text: &'static str,
    /// The outputs, in order.
    pub outputs: &'static [&'static str],
}

/// All tasks, in the order of documentation.
pub const TASKS: [Task; 7] = [
    Task { name: "Homogeneous", text: "homogeneous coordinates", outputs: &[outputs::HOMOGENEOUS] },
    Task { name: "Point", text: "point", outputs: &[outputs::POINT] },
    Task { name: "Separated", text: "point, separated", outputs: &[outputs::SEPARATED_POINT] },
    Task { name: "First", text: "point and first derivatives", outputs: part(2, 5) },
    Task { name: "Second", text: "point, first and second derivatives", outputs: part(2, 8) },
    Task { name: "Normal", text: "unit normal", outputs: &[outputs::UNIT_NORMAL] },
    Task {
        name: "Local",
        text: "everything: derivatives, normal, fundamental forms, curvatures",
        outputs: part(2, BOUNDED.len()),
    },
];

/// The outputs from one place of [`BOUNDED`] to before another, where the separated point is the third.
const fn part(first: usize, end: usize) -> &'static [&'static str] {
    const ALL: &[&str] = &BOUNDED;
    ALL.split_at(end).0.split_at(first).1
}

impl Task {
    /// The values that it computes, in order.
    #[must_use]
    pub fn results<C: crate::program::Constant>(&self, program: &Program<C>) -> Vec<Value> {
        self.outputs.iter().flat_map(|output| program.results(output).to_vec()).collect()
    }
}

/// The values that evaluators compute.
pub(super) fn all_results(program: &Program<f64>) -> Vec<Value> {
    TASKS.iter().flat_map(|task| task.results(program)).collect()
}
