//! The body of a generated function in no language yet: named values, then expressions.

use std::collections::{BTreeMap, BTreeSet};

use super::chain::{Chain, Coefficient};
use super::code::Code;
use crate::program::{Input, Operation, Program, Value};

/// An expression that a language writes.
#[derive(Clone, PartialEq, Debug)]
pub(super) enum Expression {
    /// A variable of the function.
    Variable(String),
    /// A parameter or a symbol.
    Input(Input),
    /// A coefficient that a member of a family keeps.
    Kept(Value),
    /// A number.
    Constant(f64),
    /// a + b
    Sum(Box<[Expression; 2]>),
    /// a − b
    Difference(Box<[Expression; 2]>),
    /// a · b
    Product(Box<[Expression; 2]>),
    /// a / b
    Quotient(Box<[Expression; 2]>),
    /// −a
    Negative(Box<Expression>),
    /// √a
    Root(Box<Expression>),
    /// a · b + c in one operation
    MultiplyAdd(Box<[Expression; 3]>),
    /// [`Operation::Orient`]
    Orient(Box<[Expression; 2]>),
    /// [`Operation::Scale`]
    Scale(Box<[Expression; 3]>),
    /// Horner's scheme for a base: with the coefficients of a chain that has an array of them, or with these.
    Horner(Value, Vec<Expression>, Box<Expression>),
}

/// The body of a function that computes some values of a program.
pub(super) struct Body {
    /// Named values, in order: those that have a name in the program or occur more than once.
    pub(super) statements: Vec<(String, Expression)>,
    /// The results.
    pub(super) results: Vec<Expression>,
    /// The parameters and symbols that occur.
    pub(super) inputs: BTreeSet<Input>,
}

impl Body {
    /// The body that computes `results` where the values `given` have expressions already.
    pub(super) fn new(code: &Code<'_>, results: &[Value], given: &BTreeMap<Value, Expression>) -> Body {
        let Code { program, names, .. } = code;
        let operands = |value: Value| -> Vec<Value> {
            match code.chains.get(&value) {
                _ if given.contains_key(&value) => Vec::new(),
                Some(chain) => chain.operands(),
                None => program.operation(value).operands(),
            }
        };
        let needed = needed(results, operands);
        let mut uses: BTreeMap<Value, usize> = BTreeMap::new();
        for value in needed.iter().flat_map(|&value| operands(value)).chain(results.iter().copied()) {
            *uses.entry(value).or_default() += 1;
        }
        let mut writer = Writer { code, program, variables: given.clone(), inputs: BTreeSet::new() };
        let mut statements = Vec::new();
        for value in needed {
            let repeated = uses.get(&value).is_some_and(|&count| count > 1);
            // A single result is returned without being named first.
            let named = program.name_of(value).is_some() && results != [value];
            let leaf = matches!(program.operation(value), Operation::Constant(_) | Operation::Input(_));
            if given.contains_key(&value) || leaf || !(repeated || named) {
                continue;
            }
            let expression = writer.expression(value);
            let variable = names.of(program, value);
            statements.push((variable.clone(), expression));
            writer.variables.insert(value, Expression::Variable(variable));
        }
        let results = results.iter().map(|&result| writer.value(result)).collect();
        Body { statements, results, inputs: writer.inputs }
    }
}

/// The values that `results` are computed from, in order.
fn needed(results: &[Value], operands: impl Fn(Value) -> Vec<Value>) -> Vec<Value> {
    let mut wanted = BTreeSet::new();
    let mut open: Vec<Value> = results.to_vec();
    while let Some(value) = open.pop() {
        if wanted.insert(value) {
            open.extend(operands(value));
        }
    }
    wanted.into_iter().collect()
}

struct Writer<'a> {
    code: &'a Code<'a>,
    program: &'a Program<f64>,
    variables: BTreeMap<Value, Expression>,
    inputs: BTreeSet<Input>,
}

impl Writer<'_> {
    /// The variable that holds a value, or its expression.
    fn value(&mut self, value: Value) -> Expression {
        match self.variables.get(&value) {
            Some(variable) => variable.clone(),
            None => self.expression(value),
        }
    }

    /// The expression that computes a value, also where a variable holds it.
    fn expression(&mut self, value: Value) -> Expression {
        if let Some(chain) = self.code.chains.get(&value) {
            return self.horner(value, chain);
        }
        let program = self.program;
        let mut pair = |a: Value, b: Value| Box::new([self.value(a), self.value(b)]);
        match *program.operation(value) {
            Operation::Constant(constant) => Expression::Constant(constant),
            Operation::Input(input) => {
                self.inputs.insert(input);
                Expression::Input(input)
            }
            Operation::Add(a, b) => Expression::Sum(pair(a, b)),
            Operation::Subtract(a, b) => Expression::Difference(pair(a, b)),
            Operation::Multiply(a, b) => Expression::Product(pair(a, b)),
            Operation::Divide(a, b) => Expression::Quotient(pair(a, b)),
            Operation::Orient(a, b) => Expression::Orient(pair(a, b)),
            Operation::Negate(a) => Expression::Negative(Box::new(self.value(a))),
            Operation::SquareRoot(a) => Expression::Root(Box::new(self.value(a))),
            Operation::MultiplyAdd(a, b, c) => Expression::MultiplyAdd(self.triple(a, b, c)),
            Operation::Scale(a, b, c) => Expression::Scale(self.triple(a, b, c)),
        }
    }

    fn triple(&mut self, a: Value, b: Value, c: Value) -> Box<[Expression; 3]> {
        Box::new([self.value(a), self.value(b), self.value(c)])
    }

    /// The call that evaluates a chain.
    fn horner(&mut self, value: Value, chain: &Chain) -> Expression {
        let base = Box::new(self.value(chain.base));
        let mut coefficients = Vec::new();
        if !self.code.has_array(value) {
            for coefficient in &chain.coefficients {
                coefficients.push(match coefficient {
                    Coefficient::Value(value) => self.value(*value),
                    Coefficient::One => Expression::Constant(1.0),
                    Coefficient::MinusOne => Expression::Constant(-1.0),
                });
            }
        }
        Expression::Horner(value, coefficients, base)
    }
}

/// How tightly an expression binds, in languages with the usual signs.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Binding {
    /// a + b, a − b
    Sum,
    /// a · b, a / b
    Product,
    /// −a
    Sign,
    /// All others.
    Atom,
}
