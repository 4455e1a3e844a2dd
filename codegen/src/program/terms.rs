//! Values of both parameters as sums of products of values of one.

use super::{Constant, Operation, Program, Stage, Value};

/// A product of values, by the parameters that they depend on.
#[derive(Clone, PartialEq, Eq, Default, Debug)]
pub struct Term {
    /// Whether it is subtracted.
    pub negative: bool,
    /// Factors that depend on no parameter.
    pub numbers: Vec<Value>,
    /// Factors that depend on u alone.
    pub u: Vec<Value>,
    /// Factors that depend on v alone.
    pub v: Vec<Value>,
}

impl Term {
    fn of(value: Value, stage: Stage) -> Term {
        let mut term = Term::default();
        match stage {
            Stage::Constant | Stage::Symbols => term.numbers.push(value),
            Stage::U => term.u.push(value),
            Stage::V | Stage::Both => term.v.push(value),
        }
        term
    }

    fn times(&self, other: &Term) -> Term {
        Term {
            negative: self.negative != other.negative,
            numbers: [self.numbers.as_slice(), &other.numbers].concat(),
            u: [self.u.as_slice(), &other.u].concat(),
            v: [self.v.as_slice(), &other.v].concat(),
        }
    }
}

impl<C: Constant> Program<C> {
    /// The value as a sum of products of values that depend on one parameter at most; `None` if it is a quotient or a root
    /// of what depends on both.
    ///
    /// # Example
    /// ```
    /// use hodograph_codegen::program::{Input, Program};
    /// let mut program = Program::<f64>::new();
    /// let (u, v) = (program.input(Input::U), program.input(Input::V));
    /// let product = program.multiply(u, v);
    /// let difference = program.subtract(u, product);
    /// let terms = program.terms(difference).unwrap();
    /// assert_eq!((terms[1].negative, &terms[1].u, &terms[1].v), (true, &vec![u], &vec![v]));
    /// let quotient = program.divide(u, v);
    /// assert!(program.terms(quotient).is_none());
    /// ```
    #[must_use]
    pub fn terms(&self, value: Value) -> Option<Vec<Term>> {
        let stage = self.stage(value);
        if stage != Stage::Both {
            return Some(vec![Term::of(value, stage)]);
        }
        let negative = |terms: Vec<Term>| -> Vec<Term> {
            terms.into_iter().map(|term| Term { negative: !term.negative, ..term }).collect()
        };
        match *self.operation(value) {
            Operation::Add(a, b) => Some([self.terms(a)?, self.terms(b)?].concat()),
            Operation::Subtract(a, b) => Some([self.terms(a)?, negative(self.terms(b)?)].concat()),
            Operation::Negate(a) => Some(negative(self.terms(a)?)),
            Operation::Multiply(a, b) => {
                let (left, right) = (self.terms(a)?, self.terms(b)?);
                Some(left.iter().flat_map(|a| right.iter().map(|b| a.times(b))).collect())
            }
            Operation::MultiplyAdd(a, b, c) => {
                let (left, right) = (self.terms(a)?, self.terms(b)?);
                let products = left.iter().flat_map(|a| right.iter().map(|b| a.times(b)));
                Some(products.chain(self.terms(c)?).collect())
            }
            Operation::Constant(_)
            | Operation::Input(_)
            | Operation::Divide(..)
            | Operation::SquareRoot(_)
            | Operation::Orient(..)
            | Operation::Scale(..) => None,
        }
    }
}
