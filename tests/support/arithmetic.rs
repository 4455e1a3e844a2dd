//! The arithmetic that expansions compute with, to run programs in, at many points at once.

use std::rc::Rc;

use hodograph::{Plain, Real, Rounded};
use hodograph_codegen::program::{Arithmetic, Input};

/// What a program computes at all points, in the precision and variant `R`.
#[derive(Clone, Debug)]
pub enum Numbers<R> {
    /// What depends on no parameter: it is computed in double precision and the plain variant, and rounded when it is used.
    Early(Plain<f64>),
    /// The number of each point.
    Late(Rc<[R]>),
}

/// The arithmetic of a surface's evaluators at a list of points, in the precision and variant `R`.
#[derive(Clone, Debug)]
pub struct Reals<'a, R> {
    us: Rc<[R]>,
    vs: Rc<[R]>,
    symbols: &'a [f64],
}

impl<R: Real> Numbers<R> {
    /// The number of a point, as evaluators have it.
    #[must_use]
    pub fn at(&self, point: usize) -> R {
        match self {
            Numbers::Early(number) => R::of(number.value()),
            Numbers::Late(numbers) => numbers[point],
        }
    }
}

impl<'a, R: Real> Reals<'a, R> {
    /// The arithmetic at points (u, v); the symbols are those of the program, in its order.
    #[must_use]
    pub fn new(us: Rc<[R]>, vs: Rc<[R]>, symbols: &'a [f64]) -> Reals<'a, R> {
        Reals { us, vs, symbols }
    }

    fn apply<const N: usize>(
        &self,
        operands: [&Numbers<R>; N],
        early: impl Fn([Plain<f64>; N]) -> Plain<f64>,
        late: impl Fn([R; N]) -> R,
    ) -> Numbers<R> {
        let mut numbers = [Plain::default(); N];
        let mut known = true;
        for (number, operand) in numbers.iter_mut().zip(operands) {
            match operand {
                Numbers::Early(operand) => *number = *operand,
                Numbers::Late(_) => known = false,
            }
        }
        if known {
            return Numbers::Early(early(numbers));
        }
        Numbers::Late(
            (0..self.us.len()).map(|point| late(operands.map(|operand| operand.at(point)))).collect(),
        )
    }
}

impl<R: Real> Arithmetic<f64> for Reals<'_, R> {
    type Number = Numbers<R>;

    fn constant(&self, constant: &f64) -> Numbers<R> {
        Numbers::Early(Plain::new(*constant))
    }

    fn input(&self, input: Input) -> Numbers<R> {
        match input {
            Input::U => Numbers::Late(self.us.clone()),
            Input::V => Numbers::Late(self.vs.clone()),
            Input::Symbol(place) => self.constant(&self.symbols[place as usize]),
        }
    }

    fn add(&self, a: &Numbers<R>, b: &Numbers<R>) -> Numbers<R> {
        self.apply([a, b], |[a, b]| a + b, |[a, b]| a + b)
    }

    fn subtract(&self, a: &Numbers<R>, b: &Numbers<R>) -> Numbers<R> {
        self.apply([a, b], |[a, b]| a - b, |[a, b]| a - b)
    }

    fn multiply(&self, a: &Numbers<R>, b: &Numbers<R>) -> Numbers<R> {
        self.apply([a, b], |[a, b]| a * b, |[a, b]| a * b)
    }

    fn divide(&self, a: &Numbers<R>, b: &Numbers<R>) -> Option<Numbers<R>> {
        Some(self.apply([a, b], |[a, b]| a / b, |[a, b]| a / b))
    }

    fn negate(&self, a: &Numbers<R>) -> Numbers<R> {
        self.apply([a], |[a]| -a, |[a]| -a)
    }

    fn square_root(&self, a: &Numbers<R>) -> Option<Numbers<R>> {
        Some(self.apply([a], |[a]| a.sqrt(), |[a]| a.sqrt()))
    }

    fn multiply_add(&self, a: &Numbers<R>, b: &Numbers<R>, c: &Numbers<R>) -> Numbers<R> {
        self.apply([a, b, c], |[a, b, c]| a.mul_add(b, c), |[a, b, c]| a.mul_add(b, c))
    }

    fn orient(&self, a: &Numbers<R>, b: &Numbers<R>) -> Option<Numbers<R>> {
        Some(self.apply([a, b], |[a, b]| a.orient(b), |[a, b]| a.orient(b)))
    }

    fn scale(&self, a: &Numbers<R>, b: &Numbers<R>, c: &Numbers<R>) -> Option<Numbers<R>> {
        Some(self.apply([a, b, c], |[a, b, c]| Real::scale(a, b, c), |[a, b, c]| Real::scale(a, b, c)))
    }
}
