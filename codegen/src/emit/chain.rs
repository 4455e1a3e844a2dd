//! Horner's scheme, recognized in a program.

use std::collections::BTreeMap;

use crate::program::{Operation, Program, Stage, Table, Value};

/// A value that is a polynomial c_0 + c_1·x + … + c_n·x^n, n ≥ 2, computed by Horner's scheme with a [`Operation::MultiplyAdd`]
/// for each step but perhaps the first, where c_n is 1 or −1.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    /// x
    pub(super) base: Value,
    /// c_0, …, c_n
    pub(super) coefficients: Vec<Coefficient>,
}

impl Chain {
    /// The values that it is computed from.
    pub(super) fn operands(&self) -> Vec<Value> {
        let value = |coefficient: &Coefficient| match coefficient {
            Coefficient::Value(value) => Some(*value),
            Coefficient::One | Coefficient::MinusOne => None,
        };
        self.coefficients.iter().filter_map(value).chain([self.base]).collect()
    }
}

/// A coefficient of a [`Chain`].
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Coefficient {
    /// A value that depends on no parameter.
    Value(Value),
    /// 1, which takes no multiplication.
    One,
    /// −1, which takes none either.
    MinusOne,
}

/// The chains among the values that `results` need, as long as they can be, by the values that they compute.
pub(super) fn chains(program: &Program<f64>, results: &[Value]) -> BTreeMap<Value, Chain> {
    let needed = program.needed(results);
    let mut uses: BTreeMap<Value, usize> = BTreeMap::new();
    for value in needed.iter().flat_map(|&value| program.operation(value).operands()).chain(results.to_vec())
    {
        *uses.entry(value).or_default() += 1;
    }
    let early = |value: Value| program.stage(value) <= Stage::Symbols;
    let mut chains: BTreeMap<Value, Chain> = BTreeMap::new();
    for &value in needed.iter().filter(|&&value| matches!(program.stage(value), Stage::U | Stage::V)) {
        let (previous, base, last) = match *program.operation(value) {
            Operation::MultiplyAdd(previous, base, last) if early(last) => (Some(previous), base, last),
            Operation::Add(base, last) if early(last) && !early(base) => {
                let coefficients = vec![Coefficient::Value(last), Coefficient::One];
                chains.insert(value, Chain { base, coefficients });
                continue;
            }
            Operation::Subtract(last, base) if early(last) && !early(base) => {
                let coefficients = vec![Coefficient::Value(last), Coefficient::MinusOne];
                chains.insert(value, Chain { base, coefficients });
                continue;
            }
            _ => continue,
        };
        let Some(previous) = previous else { continue };
        if early(previous) {
            let coefficients = vec![Coefficient::Value(last), Coefficient::Value(previous)];
            chains.insert(value, Chain { base, coefficients });
            continue;
        }
        let extended = chains.get(&previous).filter(|chain| chain.base == base && uses[&previous] == 1);
        if let Some(chain) = extended {
            let coefficients = [&[Coefficient::Value(last)], chain.coefficients.as_slice()].concat();
            chains.insert(value, Chain { base, coefficients });
            chains.remove(&previous);
        }
    }
    chains.retain(|_, chain| chain.coefficients.len() > 2);
    chains
}

/// The table of the polynomial that a chain computes, or computes up to a power of the parameter.
pub(super) fn table_of(program: &Program<f64>, value: Value) -> Option<&Table> {
    program.tables().iter().find(|table| {
        let multiple = match *program.operation(table.value) {
            Operation::Multiply(a, b) => a == value || b == value,
            _ => false,
        };
        table.value == value || multiple
    })
}
