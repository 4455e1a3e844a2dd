//! By which powers of a scale the values of a program are multiplied.
//!
//! [`Operation::Scale`] is a power of two s. Where it multiplies the three components of a direction, every
//! value computed from them is s^d times what it would be for s = 1, with the same significand: products,
//! quotients and sums of values of equal degree d commute with it, and so do roots of even degree, save for
//! overflow and underflow. So errors are computed for s = 1, and s^d enters what is said on overflow and
//! underflow alone.

use crate::program::{Operation, Program, Value};

/// The power of a scale that a value has as a factor.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Degree {
    /// s^d for the scale at a place; (0, 0) without one.
    Of {
        /// The place of the scale.
        scale: usize,
        /// d
        degree: i32,
    },
    /// The value is no such multiple.
    Mixed,
}

impl Degree {
    const ZERO: Degree = Degree::Of { scale: 0, degree: 0 };

    /// Whether the value is a multiple of a power of a scale, maybe the power 0.
    pub(super) fn is_homogeneous(self) -> bool {
        self != Degree::Mixed
    }

    /// The scale's place and power, if the power is not 0.
    pub(super) fn scale(self) -> Option<(usize, i32)> {
        match self {
            Degree::Of { scale, degree } if degree != 0 => Some((scale, degree)),
            _ => None,
        }
    }

    fn of(scale: usize, degree: i32) -> Degree {
        // What is beyond is not a direction.
        match degree {
            0 => Degree::ZERO,
            -16..=16 => Degree::Of { scale, degree },
            _ => Degree::Mixed,
        }
    }

    fn times(self, other: Degree, sign: i32) -> Degree {
        match (self, other) {
            (Degree::Of { scale: s, degree: a }, Degree::Of { scale: t, degree: b }) => match (a, b) {
                (_, 0) => self,
                (0, _) => Degree::of(t, sign * b),
                _ if s == t => Degree::of(s, a + sign * b),
                _ => Degree::Mixed,
            },
            _ => Degree::Mixed,
        }
    }

    fn plus(self, other: Degree) -> Degree {
        if self == other { self } else { Degree::Mixed }
    }
}

/// The degrees of all values.
pub(super) fn degrees(program: &Program<f64>) -> Vec<Degree> {
    let mut degrees: Vec<Degree> = Vec::new();
    for (place, operation) in program.operations().iter().enumerate() {
        let of = |value: Value| degrees[value.index()];
        let degree = match *operation {
            Operation::Constant(_) | Operation::Input(_) => Degree::ZERO,
            Operation::Add(a, b) | Operation::Subtract(a, b) => of(a).plus(of(b)),
            Operation::Multiply(a, b) => of(a).times(of(b), 1),
            Operation::Divide(a, b) => of(a).times(of(b), -1),
            Operation::Negate(a) => of(a),
            Operation::Orient(a, b) => {
                if of(b).is_homogeneous() {
                    of(a)
                } else {
                    Degree::Mixed
                }
            }
            Operation::SquareRoot(a) => match of(a) {
                Degree::Of { scale, degree } if degree % 2 == 0 => Degree::of(scale, degree / 2),
                _ => Degree::Mixed,
            },
            Operation::MultiplyAdd(a, b, c) => of(a).times(of(b), 1).plus(of(c)),
            Operation::Scale(a, b, c) => match [a, b, c].iter().all(|&value| of(value) == Degree::ZERO) {
                true => Degree::of(place, 1),
                false => Degree::Mixed,
            },
        };
        degrees.push(degree);
    }
    degrees
}
