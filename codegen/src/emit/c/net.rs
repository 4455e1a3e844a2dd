//! The control net of a member of a family in C, and the check of its curves' speeds.

use std::fmt::Write;

use super::super::Artifact;
use super::super::code::Code;
use super::super::expression::Expression;
use super::super::net::{Coefficients, Form, Statement, Term, conditions, terms};
use super::DOUBLE;
use super::expression::{number, variable};
use crate::program::{Input, Value};

/// The function that computes the control net from the homogeneous coordinates.
pub(super) fn net(name: &str, artifact: &Artifact, code: &Code<'_>) -> String {
    let (m, n) = (artifact.degree.0 as usize, artifact.degree.1 as usize);
    let computation = terms(artifact, code);
    let mut writer = Writer { name, code, text: String::new(), arrays: 0 };
    for statement in &computation.statements {
        writer.statement(statement);
    }
    let length = (m + 1) * (n + 1);
    writer.line(&format!("for (size_t i = 0; i < {length}; i++)"));
    writer.line("    for (size_t k = 0; k < 4; k++)");
    writer.line("        net[i][k] = 0.0;");
    if computation.result.iter().any(|term| term.u.is_none() || term.v.is_none()) {
        let ones = vec![Expression::Constant(1.0); m.max(n) + 1];
        writer.array("ones", &ones);
    }
    for Term { coordinate, negative, numbers, u, v } in &computation.result {
        let numbers: Vec<String> = numbers.iter().map(|factor| number(code, DOUBLE, factor)).collect();
        let product = if numbers.is_empty() { DOUBLE.literal(1.0) } else { numbers.join(" * ") };
        let sign = if *negative { "-" } else { "" };
        let [u, v] =
            [u, v].map(|factor| factor.as_ref().map_or("ones".to_string(), |factor| writer.operand(factor)));
        writer
            .line(&format!("hodograph_accumulate(net, {coordinate}, {sign}{product}, {u}, {m}, {v}, {n});"));
    }
    if !writer.text.contains("surface->") {
        writer.line("(void)surface;");
    }
    format!(
        "/* The control net over the domain. */\nstatic inline void {name}_net(const {name}_surface *surface, double (*net)[4])\n{{\n{}}}\n\n",
        writer.text
    )
}

/// The statements that end the construction of a member whose curves do not have positive parametric speeds.
pub(super) fn speeds(name: &str, code: &Code<'_>) -> String {
    let mut text = String::new();
    for condition in conditions(code) {
        let mut writer = Writer { name, code, text: String::new(), arrays: 0 };
        for statement in &condition.statements {
            writer.statement(statement);
        }
        let coefficients = writer.operand(&condition.result);
        let degree = condition.result.degree();
        _ = write!(
            text,
            "    if (status == HODOGRAPH_OK) {{\n{}        status = hodograph_check_speed({coefficients}, {degree}, room);\n    }}\n",
            writer.text.lines().map(|line| format!("    {line}\n")).collect::<String>()
        );
    }
    text
}

/// The number of coefficients that checks of a member may need room for at a time.
pub(super) fn longest(artifact: &Artifact, code: &Code<'_>) -> usize {
    let (m, n) = (artifact.degree.0 as usize, artifact.degree.1 as usize);
    let speeds = conditions(code).into_iter().map(|condition| condition.result.degree() + 1);
    speeds.fold((m + 1) * (n + 1), usize::max)
}

struct Writer<'a> {
    name: &'a str,
    code: &'a Code<'a>,
    text: String,
    /// How many arrays have been numbered.
    arrays: usize,
}

impl Writer<'_> {
    fn line(&mut self, line: &str) {
        _ = writeln!(self.text, "    {line}");
    }

    fn array(&mut self, name: &str, numbers: &[Expression]) {
        let numbers: Vec<String> =
            numbers.iter().map(|expression| number(self.code, DOUBLE, expression)).collect();
        self.line(&format!("const double {name}[{}] = {{{}}};", numbers.len(), numbers.join(", ")));
    }

    /// An array of numbers with a name of its own.
    fn new_array(&mut self, numbers: &[Expression]) -> String {
        self.arrays += 1;
        let name = format!("n{}", self.arrays);
        self.array(&name, numbers);
        name
    }

    /// The array of coefficients.
    fn operand(&mut self, coefficients: &Coefficients) -> String {
        match coefficients {
            Coefficients::Number(number) => self.new_array(std::slice::from_ref(number)),
            Coefficients::Polynomial(name, _) => name.clone(),
        }
    }

    /// The coefficients of a chain.
    fn chain(&mut self, value: Value, numbers: &[Expression]) -> String {
        match self.code.arrays.get(&value) {
            Some((name, true)) => {
                let constants = self.code.constant_array(name);
                let numbers: Vec<Expression> =
                    constants.iter().map(|&number| Expression::Constant(number)).collect();
                self.new_array(&numbers)
            }
            Some((name, false)) => format!("surface->{}", variable(&name.to_string())),
            None => self.new_array(numbers),
        }
    }

    fn statement(&mut self, Statement { name, degree, form }: &Statement) {
        let length = degree + 1;
        let call = match form {
            Form::Parameter(input) => {
                let letter = if *input == Input::U { "u" } else { "v" };
                let domain = self.name;
                return self.line(&format!("const double *{name} = {domain}_domain.{letter};"));
            }
            Form::Scaled(a, factor) => {
                let factor = number(self.code, DOUBLE, factor);
                format!("scaled({}, {}, {factor}, {name})", self.operand(a), a.degree())
            }
            Form::Sum(a, b, negative) => {
                let sign = DOUBLE.literal(if *negative { -1.0 } else { 1.0 });
                let (first, second) = (self.operand(a), self.operand(b));
                format!("sum({first}, {}, {second}, {}, {sign}, {name}, {degree})", a.degree(), b.degree())
            }
            Form::Product(a, b) => {
                let (first, second) = (self.operand(a), self.operand(b));
                format!("product({first}, {}, {second}, {}, {name})", a.degree(), b.degree())
            }
            Form::Elevated(a) => format!("elevated({}, {}, {name}, {degree})", self.operand(a), a.degree()),
            Form::Horner(value, numbers, base) => {
                let (coefficients, operand) = (self.chain(*value, numbers), self.operand(base));
                let steps = self.code.chains[value].coefficients.len() - 1;
                format!("horner({coefficients}, {steps}, {operand}, {}, {name})", base.degree())
            }
        };
        let parts = if matches!(form, Form::Sum(..) | Form::Horner(..)) { "2 * " } else { "" };
        self.line(&format!("double {name}[{parts}{length}];"));
        self.line(&format!("hodograph_{call};"));
    }
}
