//! Expressions in C.

use super::Type;
use crate::bound::Precision;
use crate::emit::code::Code;
use crate::emit::expression::{Binding, Body, Expression};
use crate::program::Input;

/// The statements and the results of a body in C.
pub(super) fn write(code: &Code<'_>, kind: Type, body: &Body) -> (Vec<String>, Vec<String>) {
    let writer = Writer { code, kind };
    let statement = |(name, expression): &(String, Expression)| {
        format!("const {} {} = {};", kind.real, variable(name), writer.write(expression).0)
    };
    let statements = body.statements.iter().map(statement).collect();
    (statements, body.results.iter().map(|result| writer.write(result).0).collect())
}

/// A number that depends on no parameter.
pub(super) fn number(code: &Code<'_>, kind: Type, number: &Expression) -> String {
    Writer { code, kind }.write(number).0
}

/// A name that is no word of C or C++, and that no generated function means something else by.
pub(super) fn variable(name: &str) -> String {
    if TAKEN.contains(&name) { format!("{name}_") } else { name.to_string() }
}

#[rustfmt::skip]
const TAKEN: [&str; 126] = [
    // Words of C and C++, and names that compilers define.
    "alignas", "alignof", "and", "and_eq", "asm", "assert", "auto", "bitand", "bitor", "bool", "break", "case", "catch", "char",
    "char8_t", "char16_t", "char32_t", "class", "co_await", "co_return", "co_yield", "compl", "concept", "const", "const_cast",
    "consteval", "constexpr", "constinit", "continue", "decltype", "default", "delete", "do", "double", "dynamic_cast", "else",
    "enum", "errno", "explicit", "export", "extern", "false", "float", "for", "friend", "goto", "if", "inline", "int", "linux",
    "long", "mutable", "namespace", "new", "noexcept", "not", "not_eq", "nullptr", "operator", "or", "or_eq", "private",
    "protected", "public", "register", "reinterpret_cast", "requires", "restrict", "return", "short", "signed", "sizeof",
    "static", "static_assert", "static_cast", "struct", "switch", "template", "this", "thread_local", "throw", "true", "try",
    "typedef", "typeid", "typename", "typeof", "union", "unix", "unsigned", "using", "virtual", "void", "volatile", "wchar_t",
    "while", "xor", "xor_eq",
    // What functions and macros of the standard headers that are used are called.
    "DBL_MAX", "FLT_MAX", "INFINITY", "NAN", "NULL", "fabs", "fabsf", "memcpy", "size_t", "sqrt", "sqrtf",
    // Variables of the generated functions.
    "control_net", "finite", "hodograph_all_finite", "hodograph_orient", "hodograph_orientf", "hodograph_over", "hodograph_overf",
    "hodograph_scale", "hodograph_scalef", "of_u", "of_v", "out", "parameters", "room", "status", "surface", "values",
];

struct Writer<'a> {
    code: &'a Code<'a>,
    kind: Type,
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
            Expression::Quotient(operands) => {
                let operands = operands.each_ref().map(|operand| self.write(operand).0);
                (self.call("hodograph_over", &operands), Binding::Atom)
            }
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
        format!("{function}{}({})", self.kind.suffix, arguments.join(", "))
    }

    fn kept(&self, name: &str, place: usize) -> String {
        let name = variable(name);
        match self.kind.precision {
            Precision::Double => format!("surface->{name}[{place}]"),
            Precision::Single => format!("(float)surface->{name}[{place}]"),
        }
    }

    /// Horner's scheme, written out.
    fn horner(&self, value: crate::program::Value, coefficients: &[Expression], base: &Expression) -> String {
        let base = self.within(base, Binding::Sign);
        let coefficients: Vec<String> = match self.code.arrays.get(&value) {
            Some((name, true)) => {
                let numbers = self.code.constant_array(name).iter();
                numbers
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
        (self.kind.literal(constant), binding)
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
