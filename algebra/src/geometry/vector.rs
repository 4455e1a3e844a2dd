//! Vectors of rational functions.

use std::fmt;
use std::ops::{Add, Neg, Sub};

use crate::{Fraction, Rational, Variable};

/// A vector in space whose components are rational functions.
///
/// # Example
/// ```
/// use hodograph_algebra::Vector;
/// let (i, j) = (Vector::unit(0), Vector::unit(1));
/// assert_eq!(i.cross(&j), Vector::unit(2));
/// assert_eq!(i.dot(&i).to_string(), "1");
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Vector {
    components: [Fraction; 3],
}

impl Vector {
    /// The vector with the given components.
    #[must_use]
    pub fn new(x: Fraction, y: Fraction, z: Fraction) -> Vector {
        Vector { components: [x, y, z] }
    }

    /// The zero vector.
    #[must_use]
    pub fn zero() -> Vector {
        Vector::new(Fraction::zero(), Fraction::zero(), Fraction::zero())
    }

    /// The unit vector **i**, **j** or **k** of the axis 0, 1 or 2.
    ///
    /// # Panics
    /// If `axis` is above 2.
    #[must_use]
    pub fn unit(axis: usize) -> Vector {
        let mut vector = Vector::zero();
        vector.components[axis] = Fraction::one();
        vector
    }

    /// The components x, y and z.
    #[must_use]
    pub fn components(&self) -> &[Fraction; 3] {
        &self.components
    }

    /// Whether all components are zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.components.iter().all(Fraction::is_zero)
    }

    /// The vector with `map` applied to each component.
    #[must_use]
    pub fn map(&self, map: impl FnMut(&Fraction) -> Fraction) -> Vector {
        Vector { components: self.components.each_ref().map(map) }
    }

    /// The product with a scalar.
    #[must_use]
    pub fn scale(&self, factor: &Fraction) -> Vector {
        self.map(|component| component * factor)
    }

    /// The product with a rational number.
    #[must_use]
    pub fn scale_by(&self, factor: &Rational) -> Vector {
        self.map(|component| component.scale(factor))
    }

    /// The scalar product.
    #[must_use]
    pub fn dot(&self, other: &Vector) -> Fraction {
        let products = self.components.iter().zip(&other.components).map(|(a, b)| a * b);
        products.fold(Fraction::zero(), |sum, product| &sum + &product)
    }

    /// The vector product.
    #[must_use]
    pub fn cross(&self, other: &Vector) -> Vector {
        let [a, b] = [&self.components, &other.components];
        let minor = |i: usize, j: usize| &(&a[i] * &b[j]) - &(&a[j] * &b[i]);
        Vector::new(minor(1, 2), minor(2, 0), minor(0, 1))
    }

    /// The squared length.
    #[must_use]
    pub fn norm2(&self) -> Fraction {
        self.dot(self)
    }

    /// The partial derivative by `variable`.
    #[must_use]
    pub fn derivative(&self, variable: &Variable) -> Vector {
        self.map(|component| component.derivative(variable))
    }

    /// The vector with known factors cancelled in each component.
    #[must_use]
    pub fn reduced(&self) -> Vector {
        self.map(Fraction::reduced)
    }
}

impl Add for &Vector {
    type Output = Vector;

    fn add(self, other: &Vector) -> Vector {
        let [a, b] = [&self.components, &other.components];
        Vector::new(&a[0] + &b[0], &a[1] + &b[1], &a[2] + &b[2])
    }
}

impl Sub for &Vector {
    type Output = Vector;

    fn sub(self, other: &Vector) -> Vector {
        self + &-other
    }
}

impl Neg for &Vector {
    type Output = Vector;

    fn neg(self) -> Vector {
        self.map(|component| -component)
    }
}

impl fmt::Display for Vector {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = &self.components;
        write!(f, "({x}, {y}, {z})")
    }
}
