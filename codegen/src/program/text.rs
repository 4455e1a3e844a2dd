//! The text form of programs, for snapshots.

use std::fmt;

use super::{Constant, Input, Operation, Program, Stage, Value};

impl fmt::Display for Stage {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Stage::Constant => "constant",
            Stage::Symbols => "symbols",
            Stage::V => "v",
            Stage::U => "u",
            Stage::Both => "u, v",
        })
    }
}

/// A line for each value that an output needs, under the heading of its stage; then the outputs.
///
/// Constants that are written in one line of text stand where they are used.
impl<C: Constant + fmt::Display> fmt::Display for Program<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let results: Vec<Value> = self.outputs().iter().flat_map(|output| output.values.clone()).collect();
        let needed = self.needed(&results);
        for stage in [Stage::Constant, Stage::Symbols, Stage::V, Stage::U, Stage::Both] {
            let of_stage = |&&value: &&Value| {
                let input = matches!(self.operation(value), Operation::Input(_) | Operation::Constant(_));
                self.stage(value) == stage && !input
            };
            let mut values = needed.iter().filter(of_stage).peekable();
            if values.peek().is_none() {
                continue;
            }
            writeln!(f, "stage {stage}: {}", self.count(&results, stage))?;
            for &value in values {
                write!(f, "  {} = ", Operand(self, value))?;
                self.write_operation(f, value)?;
                writeln!(f)?;
            }
        }
        for output in self.outputs() {
            let values: Vec<String> =
                output.values.iter().map(|&value| Operand(self, value).to_string()).collect();
            writeln!(f, "{} = [{}]", output.name, values.join(", "))?;
        }
        Ok(())
    }
}

/// A value as it is referred to: by its name, its constant, or its number.
struct Operand<'a, C>(&'a Program<C>, Value);

impl<C: Constant + fmt::Display> fmt::Display for Operand<'_, C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Operand(program, value) = self;
        match (program.operation(*value), program.name_of(*value)) {
            (Operation::Input(Input::U), _) => f.write_str("u"),
            (Operation::Input(Input::V), _) => f.write_str("v"),
            (Operation::Input(Input::Symbol(place)), _) => {
                f.write_str(program.symbols().get(*place as usize).map_or("?", String::as_str))
            }
            (Operation::Constant(constant), _) => {
                let text = constant.to_string();
                let bare = text.bytes().all(|byte| byte.is_ascii_digit() || b"./".contains(&byte));
                if bare { f.write_str(&text) } else { write!(f, "({text})") }
            }
            (_, Some(name)) => f.write_str(name),
            (_, None) => write!(f, "%{}", value.index()),
        }
    }
}

impl<C: Constant + fmt::Display> Program<C> {
    fn write_operation(&self, f: &mut fmt::Formatter<'_>, value: Value) -> fmt::Result {
        let of = |value: &Value| Operand(self, *value);
        match self.operation(value) {
            Operation::Constant(_) | Operation::Input(_) => write!(f, "{}", of(&value)),
            Operation::Add(a, b) => write!(f, "{} + {}", of(a), of(b)),
            Operation::Subtract(a, b) => write!(f, "{} - {}", of(a), of(b)),
            Operation::Multiply(a, b) => write!(f, "{} * {}", of(a), of(b)),
            Operation::Divide(a, b) => write!(f, "{} / {}", of(a), of(b)),
            Operation::Negate(a) => write!(f, "-{}", of(a)),
            Operation::SquareRoot(a) => write!(f, "sqrt({})", of(a)),
            Operation::MultiplyAdd(a, b, c) => write!(f, "{} * {} + {}", of(a), of(b), of(c)),
            Operation::Orient(a, b) => write!(f, "{} oriented by {}", of(a), of(b)),
            Operation::Scale(a, b, c) => write!(f, "scale({}, {}, {})", of(a), of(b), of(c)),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::program::{Input, Program};

    #[test]
    fn text_shows_stages_names_and_outputs() {
        let mut program = Program::<f64>::new();
        let (u, v) = (program.input(Input::U), program.input(Input::V));
        let (one, less) = (program.constant(1.0), program.constant(-0.5));
        let square = program.multiply(u, u);
        let weight = program.add(one, square);
        program.name(weight, "w");
        let shifted = program.add(v, less);
        let quotient = program.divide(shifted, weight);
        program.output("point", vec![quotient, v, one]);
        let expected = "\
stage v: 1 operation (1 +)
  %6 = v + (-0.5)
stage u: 2 operations (1 +, 1 ×)
  %4 = u * u
  w = 1 + %4
stage u, v: 1 operation (1 ÷)
  %7 = %6 / w
point = [%7, v, 1]
";
        assert_eq!(program.to_string(), expected);
    }
}
