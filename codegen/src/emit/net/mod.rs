//! The control net of a member of a family, in no language yet: its polynomials, computed in the Bernstein basis at run time.

mod rust;

use std::collections::BTreeMap;

use super::Artifact;
use super::chain::Coefficient;
use super::code::Code;
use super::expression::Expression;
use crate::program::{Input, Operation, Program, Stage, Value};
use crate::schedule::outputs;

pub(super) use rust::{net, speeds};

/// Statements, and what they are for.
pub(super) struct Computation<T> {
    /// Bernstein coefficients by name, in order.
    pub(super) statements: Vec<Statement>,
    /// What is read of them.
    pub(super) result: T,
}

/// Bernstein coefficients that have a name.
pub(super) struct Statement {
    pub(super) name: String,
    pub(super) degree: usize,
    pub(super) form: Form,
}

/// How Bernstein coefficients are computed from others.
pub(super) enum Form {
    /// A parameter itself: the ends of the domain.
    Parameter(Input),
    /// c·a
    Scaled(Coefficients, Expression),
    /// a + b, or a − b if so
    Sum(Coefficients, Coefficients, bool),
    /// a·b
    Product(Coefficients, Coefficients),
    /// a, as a polynomial of a degree that is not less
    Elevated(Coefficients),
    /// Horner's scheme for a base: with the array that the chain of a value has, or with these numbers
    Horner(Value, Vec<Expression>, Coefficients),
}

/// Bernstein coefficients.
#[derive(Clone)]
pub(super) enum Coefficients {
    /// Those of a constant.
    Number(Expression),
    /// Those of a statement, by its name, with their degree.
    Polynomial(String, usize),
}

impl Coefficients {
    pub(super) fn degree(&self) -> usize {
        match self {
            Coefficients::Number(_) => 0,
            Coefficients::Polynomial(_, degree) => *degree,
        }
    }
}

/// What is added to a coordinate of the control net: ±(product of numbers)·u·v.
pub(super) struct Term {
    pub(super) coordinate: usize,
    pub(super) negative: bool,
    pub(super) numbers: Vec<Expression>,
    /// The factor that depends on u, of the degree in u; `None` for 1.
    pub(super) u: Option<Coefficients>,
    /// The factor that depends on v, of the degree in v; `None` for 1.
    pub(super) v: Option<Coefficients>,
}

/// The terms of the homogeneous coordinates.
pub(super) fn terms(artifact: &Artifact, code: &Code<'_>) -> Computation<Vec<Term>> {
    let (m, n) = (artifact.degree.0 as usize, artifact.degree.1 as usize);
    let mut writer = Writer::new(code);
    let mut result = Vec::new();
    for (coordinate, &value) in code.program.results(outputs::HOMOGENEOUS).iter().enumerate() {
        let Some(terms) = code.program.terms(value) else {
            unreachable!("homogeneous coordinates are polynomials")
        };
        for term in terms {
            let mut negative = term.negative;
            let number = |&value: &Value| match code.program.operation(value) {
                Operation::Constant(constant) => {
                    negative ^= constant.is_sign_negative();
                    Expression::Constant(constant.abs())
                }
                _ => writer.number(value),
            };
            let numbers = term.numbers.iter().map(number).collect();
            let (u, v) = (writer.elevated(&term.u, m), writer.elevated(&term.v, n));
            result.push(Term { coordinate, negative, numbers, u, v });
        }
    }
    Computation { statements: writer.statements, result }
}

/// The Bernstein coefficients of each of the parametric speeds, which depend on one parameter, that symbols decide on.
pub(super) fn conditions(code: &Code<'_>) -> Vec<Computation<Coefficients>> {
    let conditions = code.program.results(outputs::CONDITIONS).iter();
    let coefficients = |&condition: &Value| {
        let mut writer = Writer::new(code);
        let result = writer.value(condition);
        Computation { statements: writer.statements, result }
    };
    conditions.map(coefficients).collect()
}

struct Writer<'a> {
    code: &'a Code<'a>,
    program: &'a Program<f64>,
    statements: Vec<Statement>,
    known: BTreeMap<Value, Coefficients>,
    temporaries: usize,
}

impl<'a> Writer<'a> {
    fn new(code: &'a Code<'a>) -> Writer<'a> {
        let program = code.program;
        Writer { code, program, statements: Vec::new(), known: BTreeMap::new(), temporaries: 0 }
    }

    /// A product of polynomials of one parameter, for a degree that is not too low; `None` without factors.
    fn elevated(&mut self, factors: &[Value], degree: usize) -> Option<Coefficients> {
        let mut product: Option<Coefficients> = None;
        for &factor in factors {
            let factor = self.value(factor);
            product = Some(match product {
                None => factor,
                Some(other) => self.temporary(other.degree() + factor.degree(), Form::Product(other, factor)),
            });
        }
        let product = product?;
        Some(if product.degree() == degree {
            product
        } else {
            self.temporary(degree, Form::Elevated(product))
        })
    }

    fn temporary(&mut self, degree: usize, form: Form) -> Coefficients {
        self.temporaries += 1;
        self.bind(format!("e{}", self.temporaries), degree, form)
    }

    fn bind(&mut self, name: String, degree: usize, form: Form) -> Coefficients {
        self.statements.push(Statement { name: name.clone(), degree, form });
        Coefficients::Polynomial(name, degree)
    }

    /// The coefficients of a value that depends on one parameter at most.
    fn value(&mut self, value: Value) -> Coefficients {
        if let Some(coefficients) = self.known.get(&value) {
            return coefficients.clone();
        }
        let coefficients = self.new_value(value);
        self.known.insert(value, coefficients.clone());
        coefficients
    }

    fn new_value(&mut self, value: Value) -> Coefficients {
        if self.program.stage(value) <= Stage::Symbols {
            return Coefficients::Number(self.number(value));
        }
        let (degree, form) = match self.code.chains.get(&value) {
            Some(chain) => {
                let base = self.value(chain.base);
                let number = |coefficient: &Coefficient| match coefficient {
                    Coefficient::Value(value) => self.number(*value),
                    Coefficient::One => Expression::Constant(1.0),
                    Coefficient::MinusOne => Expression::Constant(-1.0),
                };
                let numbers = match self.code.has_array(value) {
                    true => Vec::new(),
                    false => chain.coefficients.iter().map(number).collect(),
                };
                let degree = base.degree() * (chain.coefficients.len() - 1);
                (degree, Form::Horner(value, numbers, base))
            }
            None => {
                let program = self.program;
                self.operation(program.operation(value))
            }
        };
        self.bind(format!("b{}", value.index()), degree, form)
    }

    fn operation(&mut self, operation: &Operation<f64>) -> (usize, Form) {
        match *operation {
            Operation::Input(input) => (1, Form::Parameter(input)),
            Operation::Negate(a) => {
                let a = self.value(a);
                (a.degree(), Form::Scaled(a, Expression::Constant(-1.0)))
            }
            Operation::Add(a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                sum(a, b)
            }
            Operation::Subtract(a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                (a.degree().max(b.degree()), Form::Sum(a, b, true))
            }
            Operation::Multiply(a, b) => self.product(a, b),
            Operation::MultiplyAdd(a, b, c) => {
                let (degree, form) = self.product(a, b);
                let product = self.temporary(degree, form);
                let c = self.value(c);
                sum(product, c)
            }
            Operation::Constant(_)
            | Operation::Divide(..)
            | Operation::SquareRoot(_)
            | Operation::Orient(..)
            | Operation::Scale(..) => {
                unreachable!("homogeneous coordinates and conditions are polynomials")
            }
        }
    }

    fn product(&mut self, a: Value, b: Value) -> (usize, Form) {
        match (self.value(a), self.value(b)) {
            (Coefficients::Number(factor), other) | (other, Coefficients::Number(factor)) => {
                (other.degree(), Form::Scaled(other, factor))
            }
            (a, b) => (a.degree() + b.degree(), Form::Product(a, b)),
        }
    }

    /// A value that depends on no parameter.
    fn number(&self, value: Value) -> Expression {
        self.code.number(value)
    }
}

/// a + b; a number comes last.
fn sum(a: Coefficients, b: Coefficients) -> (usize, Form) {
    let (a, b) = if matches!(a, Coefficients::Number(_)) { (b, a) } else { (a, b) };
    (a.degree().max(b.degree()), Form::Sum(a, b, false))
}
