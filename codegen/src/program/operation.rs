//! The operations of programs, on values that wait for parameters, and what constants must be able to.

#[cfg(doc)]
use super::Program;

/// A value of a [`Program`], by its place in the program.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct Value(pub(super) u32);

impl Value {
    /// The place of the value in [`Program::operations`].
    #[must_use]
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// What a program is run with: a parameter of the surface, or a coefficient that is known at run time.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Input {
    /// The first parameter, u.
    U,
    /// The second parameter, v.
    V,
    /// The symbol at this place in [`Program::symbols`].
    Symbol(u32),
}

impl Input {
    /// The stage at which it is known.
    #[must_use]
    pub fn stage(self) -> Stage {
        match self {
            Input::U => Stage::U,
            Input::V => Stage::V,
            Input::Symbol(_) => Stage::Symbols,
        }
    }

    /// A number that tells it from other inputs.
    pub(crate) fn key(self) -> u32 {
        match self {
            Input::U => 0,
            Input::V => 1,
            Input::Symbol(place) => place.saturating_add(2),
        }
    }
}

/// What a value waits for: the least stage is known first.
///
/// A value that depends on u alone and one that depends on v alone meet in [`Stage::Both`]; every other pair of stages
/// meets in the later one.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Stage {
    /// Known when the program is made.
    Constant,
    /// Depends on symbols alone: once for each surface of a family.
    Symbols,
    /// Depends on v alone: once for each row of a grid.
    V,
    /// Depends on u alone: once for each column of a grid.
    U,
    /// Depends on u and v: once for each point.
    Both,
}

impl Stage {
    /// The earliest stage at which values of both stages are known.
    #[must_use]
    pub fn join(self, other: Stage) -> Stage {
        match (self, other) {
            (Stage::U, Stage::V) | (Stage::V, Stage::U) => Stage::Both,
            _ => self.max(other),
        }
    }
}

/// How a value of a [`Program`] comes about.
#[derive(Clone, PartialEq, Debug)]
pub enum Operation<C> {
    /// A constant.
    Constant(C),
    /// A parameter or a symbol.
    Input(Input),
    /// a + b
    Add(Value, Value),
    /// a − b
    Subtract(Value, Value),
    /// a · b
    Multiply(Value, Value),
    /// a / b
    Divide(Value, Value),
    /// −a
    Negate(Value),
    /// √a
    SquareRoot(Value),
    /// a · b + c, with one rounding in the fused variant and two in the plain one.
    MultiplyAdd(Value, Value, Value),
    /// a with the sign of b turned to plus: a where b > 0, −a where b < 0, and undefined where b = 0.
    Orient(Value, Value),
    /// A power of two 2^k with 1 ≤ max(|a|, |b|, |c|) · 2^k < 2, undefined where all three are zero. A direction that is multiplied
    /// by it is the same direction, without rounding, and its squared norm neither overflows nor underflows.
    Scale(Value, Value, Value),
}

/// What a multiplication and an addition that follows it do on a machine.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Variant {
    /// Each is rounded: the same bits on every machine.
    Plain,
    /// They are rounded together, as machines with fused multiply-add do.
    Fused,
}

impl<C> Operation<C> {
    /// The values that it is computed from, in order.
    #[must_use]
    pub fn operands(&self) -> Vec<Value> {
        match *self {
            Operation::Constant(_) | Operation::Input(_) => Vec::new(),
            Operation::Negate(a) | Operation::SquareRoot(a) => vec![a],
            Operation::Add(a, b)
            | Operation::Subtract(a, b)
            | Operation::Multiply(a, b)
            | Operation::Divide(a, b)
            | Operation::Orient(a, b) => vec![a, b],
            Operation::MultiplyAdd(a, b, c) | Operation::Scale(a, b, c) => vec![a, b, c],
        }
    }
}

/// What a [`Program`] asks of its constants.
pub trait Constant: Clone + PartialEq {
    /// Whether it is 0.
    fn is_zero(&self) -> bool;
    /// Whether it is 1.
    fn is_one(&self) -> bool;
    /// −a
    fn negated(&self) -> Self;
    /// A number that equal constants share.
    fn fingerprint(&self) -> u64;
}

impl Constant for f64 {
    fn is_zero(&self) -> bool {
        *self == 0.0
    }

    fn is_one(&self) -> bool {
        *self == 1.0
    }

    fn negated(&self) -> f64 {
        -self
    }

    fn fingerprint(&self) -> u64 {
        // Both zeros are equal.
        if *self == 0.0 { 0 } else { self.to_bits() }
    }
}
