//! Expressions in C.

use super::Precision;
use crate::emit::code::Code;
use crate::emit::expression::{Binding, Body, Expression};
use crate::program::Input;

/// The statements and the results of a body in C.
pub(super) fn write(code: &Code<'_>, precision: Precision, body: &Body) -> (Vec<String>, Vec<String>) {
    let writer = Writer { code, precision };
    let statement = |(name, expression): &(String, Expression)| {
        format!("const {} {} = {};", precision.name(), variable(name), writer.write(expression).0)
    };
    let statements = body.statements.iter().map(statement).collect();
    (statements, body.results.iter().map(|result| writer.write(result).0).collect())
}

/// A name that is no word of C.
pub(super) fn variable(name: &str) -> String {
    const TAKEN: [&str; 44] = [
        "auto", "bool", "break", "case", "char", "const", "continue", "default", "do", "double", "else",
        "enum", "extern", "false", "float", "for", "goto", "if", "inline", "int", "long", "out", "register",
        "restrict", "return", "short", "signed", "sizeof", "static", "struct", "surface", "switch", "true",
        "typedef", "typeof", "union", "unsigned", "void", "volatile", "while", "asm", "errno", "linux",
        "unix",
    ];
    if TAKEN.contains(&name) { format!("{name}_") } else { name.to_string() }
}

struct Writer<'a> {
    code: &'a Code<'a>,
    precision: Precision,
}

impl Writer<'_> {
    fn write(&self, expression: &Expression) -> (String, Binding) {
        match expression {
            Expression::Variable(name) => (variable(name), Binding::Atom),
            Expression::Input(Input::U) => ("u".to_string(), Binding::Atom),
            Expression::Input(Input::V) => ("v".to_string(), Binding::Atom),
            Expression::Input(Input::Symbol(place)) => {
                (variable(&self.code.program.symbols()[*place as usize]), Binding::Atom)
            }
            Expression::Kept(value) => {
                let (name, place) = &self.code.kept[value];
                (self.kept(&name.to_string(), *place), Binding::Atom)
            }
            Expression::Constant(constant) => self.constant(*constant),
            Expression::Sum(operands) => self.sum(operands),
            Expression::Difference(operands) => self.binary(operands, "-", Binding::Sum, Binding::Product),
            Expression::Product(operands) => self.binary(operands, "*", Binding::Product, Binding::Sign),
            Expression::Quotient(operands) => self.binary(operands, "/", Binding::Product, Binding::Sign),
            Expression::Negative(a) => (format!("-{}", self.within(a, Binding::Atom)), Binding::Sign),
            Expression::Root(a) => (self.call("sqrt", &[self.write(a).0]), Binding::Atom),
            Expression::MultiplyAdd(operands) => {
                let [a, b, c] = &**operands;
                self.sum(&[Expression::Product(Box::new([a.clone(), b.clone()])), c.clone()])
            }
            Expression::Orient(operands) => {
                let operands = operands.each_ref().map(|operand| self.write(operand).0);
                (self.call("hodograph_orient", &operands), Binding::Atom)
            }
            Expression::Scale(operands) => {
                let operands = operands.each_ref().map(|operand| self.write(operand).0);
                (self.call("hodograph_scale", &operands), Binding::Atom)
            }
            Expression::Horner(value, coefficients, base) => {
                (self.horner(*value, coefficients, base), Binding::Atom)
            }
        }
    }

    /// A function of the mathematical library, or of the header, in the precision.
    fn call(&self, function: &str, arguments: &[String]) -> String {
        format!("{function}{}({})", self.precision.suffix(), arguments.join(", "))
    }

    fn kept(&self, name: &str, place: usize) -> String {
        match self.precision {
            Precision::Double => format!("surface->{name}[{place}]"),
            Precision::Single => format!("(float)surface->{name}[{place}]"),
        }
    }

    /// Horner's scheme, written out.
    fn horner(&self, value: crate::program::Value, coefficients: &[Expression], base: &Expression) -> String {
        let base = self.within(base, Binding::Sign);
        let coefficients: Vec<String> = match self.code.arrays.get(&value) {
            Some((name, true)) => {
                let constant = |(other, ..): &&(proc_macro2::Ident, _, Vec<f64>)| other == name;
                let numbers =
                    self.code.constants.iter().find(constant).map_or(&[][..], |(.., numbers)| numbers);
                numbers
                    .iter()
                    .map(|&number| self.constant(number))
                    .map(|(text, binding)| in_sum(text, binding))
                    .collect()
            }
            Some((name, false)) => {
                let length = self.code.chains[&value].coefficients.len();
                (0..length).map(|place| self.kept(&name.to_string(), place)).collect()
            }
            None => {
                coefficients.iter().map(|coefficient| self.within(coefficient, Binding::Product)).collect()
            }
        };
        let mut coefficients = coefficients.into_iter().rev();
        let mut sum = coefficients.next().unwrap_or_default();
        for coefficient in coefficients {
            sum = format!("({sum} * {base} + {coefficient})");
        }
        sum
    }

    fn binary(
        &self,
        operands: &[Expression; 2],
        sign: &str,
        binding: Binding,
        right: Binding,
    ) -> (String, Binding) {
        let [a, b] = operands;
        (format!("{} {sign} {}", self.within(a, binding), self.within(b, right)), binding)
    }

    /// a + b
    fn sum(&self, [a, b]: &[Expression; 2]) -> (String, Binding) {
        let left = self.within(a, Binding::Sum);
        match b {
            Expression::Constant(constant) if *constant < 0.0 => {
                (format!("{left} - {}", self.constant(-constant).0), Binding::Sum)
            }
            _ => (format!("{left} + {}", self.within(b, Binding::Product)), Binding::Sum),
        }
    }

    fn constant(&self, constant: f64) -> (String, Binding) {
        let binding = if constant.is_sign_negative() { Binding::Sign } else { Binding::Atom };
        (self.precision.literal(constant), binding)
    }

    /// An expression, in parentheses if it binds less than `least`.
    fn within(&self, expression: &Expression, least: Binding) -> String {
        let (text, binding) = self.write(expression);
        if binding < least { format!("({text})") } else { text }
    }
}

fn in_sum(text: String, binding: Binding) -> String {
    if binding < Binding::Atom { format!("({text})") } else { text }
}
