//! Operation counts.

use std::collections::BTreeSet;
use std::fmt;
use std::ops::Add;

use super::{Constant, Operation, Program, Stage, Value};

/// How many operations of each kind a part of a program takes.
///
/// Subtractions count as additions, and a fused multiply-add as both. Changes of sign and of scale by a power of two count for
/// nothing, since they are no arithmetic on significands, nor do tests whether a number is finite: that of a divisor, those of
/// results.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct OperationCounts {
    /// Additions and subtractions.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Square roots.
    pub square_roots: usize,
}

impl OperationCounts {
    /// All operations.
    #[must_use]
    pub fn total(&self) -> usize {
        self.additions + self.multiplications + self.divisions + self.square_roots
    }
}

impl Add for OperationCounts {
    type Output = OperationCounts;

    fn add(self, other: OperationCounts) -> OperationCounts {
        OperationCounts {
            additions: self.additions + other.additions,
            multiplications: self.multiplications + other.multiplications,
            divisions: self.divisions + other.divisions,
            square_roots: self.square_roots + other.square_roots,
        }
    }
}

impl fmt::Display for OperationCounts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kinds = [
            (self.additions, "+"),
            (self.multiplications, "×"),
            (self.divisions, "÷"),
            (self.square_roots, "√"),
        ];
        let parts: Vec<String> = kinds
            .iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, sign)| format!("{count} {sign}"))
            .collect();
        let plural = if self.total() == 1 { "" } else { "s" };
        write!(f, "{} operation{plural}", self.total())?;
        if parts.is_empty() { Ok(()) } else { write!(f, " ({})", parts.join(", ")) }
    }
}

impl<C: Constant> Program<C> {
    /// The operations of one stage that `results` take.
    #[must_use]
    pub fn count(&self, results: &[Value], stage: Stage) -> OperationCounts {
        let mut counts = OperationCounts::default();
        // A product that is added to several numbers is one product.
        let mut products = BTreeSet::new();
        for value in self.needed(results) {
            if self.stage(value) != stage {
                continue;
            }
            match self.operation(value) {
                Operation::Add(..) | Operation::Subtract(..) => counts.additions += 1,
                Operation::Multiply(a, b) => _ = products.insert(self.factors(*a, *b)),
                Operation::Divide(..) => counts.divisions += 1,
                Operation::SquareRoot(_) => counts.square_roots += 1,
                Operation::MultiplyAdd(a, b, _) => {
                    counts.additions += 1;
                    products.insert(self.factors(*a, *b));
                }
                Operation::Constant(_)
                | Operation::Input(_)
                | Operation::Negate(_)
                | Operation::Orient(..)
                | Operation::Scale(..) => {}
            }
        }
        counts.multiplications = products.len();
        counts
    }

    /// The factors of a product without their signs, in a fixed order.
    fn factors(&self, a: Value, b: Value) -> (Value, Value) {
        let magnitude = |value: Value| match *self.operation(value) {
            Operation::Negate(a) => a,
            _ => value,
        };
        let (a, b) = (magnitude(a), magnitude(b));
        (a.min(b), a.max(b))
    }

    /// The operations that `results` take in a single evaluation: those of all stages but [`Stage::Symbols`], which are done
    /// once for each member of a family.
    #[must_use]
    pub fn count_all(&self, results: &[Value]) -> OperationCounts {
        let stages = [Stage::Constant, Stage::V, Stage::U, Stage::Both];
        stages.iter().fold(OperationCounts::default(), |sum, &stage| sum + self.count(results, stage))
    }
}

#[cfg(test)]
mod tests {
    use crate::program::{Input, Program, Stage};

    #[test]
    fn counts_are_by_stage() {
        let mut program = Program::<f64>::new();
        let (u, v) = (program.input(Input::U), program.input(Input::V));
        let square = program.multiply(u, u);
        let root = program.square_root(square);
        let difference = program.subtract(v, root);
        let result = program.divide(difference, v);
        assert_eq!(program.count(&[result], Stage::U).to_string(), "2 operations (1 ×, 1 √)");
        assert_eq!(program.count(&[result], Stage::Both).to_string(), "2 operations (1 +, 1 ÷)");
        assert_eq!(program.count(&[result], Stage::V).to_string(), "0 operations");
        assert_eq!(program.count_all(&[result]).total(), 4);
    }
}
