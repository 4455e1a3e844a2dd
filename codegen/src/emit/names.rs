//! The names of variables.

use std::collections::BTreeSet;

use super::body::symbol;
use crate::program::{Input, Operation, Program, Value};

/// The names of variables: those of the program, and numbered ones that no value of the program has.
pub(super) struct Names(BTreeSet<String>);

impl Names {
    pub(super) fn new(program: &Program<f64>) -> Names {
        let named = program.values().filter_map(|value| program.name_of(value)).map(str::to_string);
        let symbols = program.symbols().iter().map(|name| symbol(name).to_string());
        Names(named.chain(symbols).collect())
    }

    /// The variable for `value`.
    pub(super) fn of(&self, program: &Program<f64>, value: Value) -> String {
        match (program.operation(value), program.name_of(value)) {
            (Operation::Input(Input::U), _) => "u".to_string(),
            (Operation::Input(Input::V), _) => "v".to_string(),
            (Operation::Input(Input::Symbol(place)), _) => {
                symbol(&program.symbols()[*place as usize]).to_string()
            }
            (_, Some(name)) if ["u", "v", "of_u", "of_v", "values"].contains(&name) => {
                format!("{name}_value")
            }
            (_, Some(name)) => name.to_string(),
            (_, None) => {
                let mut name = format!("t{}", value.index());
                while self.0.contains(&name) {
                    name.push('_');
                }
                name
            }
        }
    }
}
