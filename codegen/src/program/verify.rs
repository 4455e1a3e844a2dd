//! The invariants of programs, checked.
//!
//! 1. Every operand stands before the value that it is used in, so that a program can be run in order.
//! 2. Every value's stage is the join of its operands' stages; constants and inputs have their own.
//! 3. No two values are the same operation on the same operands.
//! 4. Names are identifiers, no two values share one, and neither constants nor inputs have one.
//! 5. Every output has values, all of them of the program, and no two outputs share a name.
//! 6. The coefficients of a table depend on no parameter, and at least one of them is there.

use std::collections::BTreeSet;
use std::fmt;

use super::{Constant, Input, Operation, Program, Stage, Value};

/// An invariant that a program breaks.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Fault {
    /// The value at fault, if it is one.
    pub value: Option<Value>,
    /// What is wrong.
    pub message: String,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.value {
            Some(value) => write!(f, "%{}: {}", value.index(), self.message),
            None => f.write_str(&self.message),
        }
    }
}

impl std::error::Error for Fault {}

/// Checks the invariants listed at the head of this file.
///
/// # Errors
/// The first [`Fault`].
pub fn verify<C: Constant>(program: &Program<C>) -> Result<(), Fault> {
    let mut known = BTreeSet::new();
    for value in program.values() {
        let fault = |message: &str| Err(Fault { value: Some(value), message: message.to_string() });
        let operation = program.operation(value);
        let operands = operation.operands();
        if operands.iter().any(|operand| *operand >= value) {
            return fault("an operand does not stand before it");
        }
        let stage = match operation {
            Operation::Input(input) => input.stage(),
            _ => operands.iter().fold(Stage::Constant, |stage, &a| stage.join(program.stage(a))),
        };
        if stage != program.stage(value) {
            return fault("its stage is not that of its operands");
        }
        let kind = match operation {
            Operation::Constant(_) => None,
            Operation::Input(Input::Symbol(place)) if *place as usize >= program.symbols().len() => {
                return fault("it is no symbol of the program");
            }
            Operation::Input(input) => Some(5_u32.saturating_add(input.key())),
            Operation::Add(..) => Some(0),
            Operation::Subtract(..) => Some(1),
            Operation::Multiply(..) => Some(2),
            Operation::Divide(..) => Some(3),
            Operation::Negate(_) | Operation::SquareRoot(_) | Operation::MultiplyAdd(..) => Some(4),
            Operation::Orient(..) | Operation::Scale(..) => Some(4),
        };
        // Kinds that share a number differ in this, or in the number of their operands.
        let root = matches!(operation, Operation::SquareRoot(_) | Operation::Scale(..));
        if kind.is_some_and(|kind| !known.insert((kind, root, operands))) {
            return fault("it repeats an earlier operation");
        }
    }
    verify_names(program)?;
    verify_outputs(program)
}

fn verify_names<C: Constant>(program: &Program<C>) -> Result<(), Fault> {
    let mut names = BTreeSet::new();
    for value in program.values() {
        let Some(name) = program.name_of(value) else { continue };
        let fault = |message: String| Err(Fault { value: Some(value), message });
        if matches!(program.operation(value), Operation::Constant(_) | Operation::Input(_)) {
            return fault(format!("a constant or an input has the name `{name}`"));
        }
        if syn::parse_str::<syn::Ident>(name).is_err() {
            return fault(format!("the name `{name}` is no identifier"));
        }
        if !names.insert(name) {
            return fault(format!("another value has the name `{name}` too"));
        }
    }
    Ok(())
}

fn verify_outputs<C: Constant>(program: &Program<C>) -> Result<(), Fault> {
    let count = program.operations().len();
    let fault = |message: String| Err(Fault { value: None, message });
    let mut names = BTreeSet::new();
    for output in program.outputs() {
        if output.values.is_empty() || output.values.iter().any(|value| value.index() >= count) {
            return fault(format!("the output `{}` has no values of the program", output.name));
        }
        if !names.insert(&output.name) {
            return fault(format!("two outputs have the name `{}`", output.name));
        }
    }
    for table in program.tables() {
        let early = |value: &Value| value.index() < count && program.stage(*value) <= Stage::Symbols;
        if table.coefficients.is_empty() || !table.coefficients.iter().all(early) {
            return fault(format!("the coefficients of `{}` depend on a parameter", table.name));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::verify;
    use crate::program::{Input, Program, Table};

    #[test]
    fn what_builders_make_is_valid() {
        let mut program = Program::<f64>::new();
        let (u, two) = (program.input(Input::U), program.constant(2.0));
        let twice = program.multiply(two, u);
        program.name(twice, "twice");
        program.name(two, "two");
        program.output("result", vec![twice]);
        assert_eq!(verify(&program), Ok(()));
        assert_eq!(program.name_of(two), None);
    }

    #[test]
    fn faults_are_found() {
        let mut program = Program::<f64>::new();
        let u = program.input(Input::U);
        let square = program.multiply(u, u);
        let valid = program.clone();

        let mut named = valid.clone();
        named.name(square, "not an identifier");
        assert!(verify(&named).is_err_and(|fault| fault.to_string().contains("no identifier")));

        let mut empty = valid.clone();
        empty.output("nothing", Vec::new());
        assert!(verify(&empty).is_err_and(|fault| fault.to_string().contains("no values")));

        let mut double = valid.clone();
        double.output("one", vec![u]);
        double.output("one", vec![square]);
        assert!(verify(&double).is_err_and(|fault| fault.to_string().contains("two outputs")));

        let mut table = valid;
        table.table(Table { value: square, name: "q".into(), formula: "u^2".into(), coefficients: vec![u] });
        assert!(verify(&table).is_err_and(|fault| fault.to_string().contains("depend on a parameter")));
    }
}
