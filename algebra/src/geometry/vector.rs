//! Vectors of rational functions.

use std::fmt;
use std::ops::{Add, Neg, Sub};
use std::rc::Rc;

use crate::{Fraction, Rational, Variable};

/// A vector in space whose components are rational functions.
///
/// Sums and multiples remember the vectors that they are made of: `s + x n + z k` knows that it is a combination of a position, a
/// normal and a unit vector. Its derivatives are found from these parts, which are much smaller than the components.
///
/// # Example
/// ```
/// use hodograph_algebra::Vector;
/// let (i, j) = (Vector::unit(0), Vector::unit(1));
/// assert_eq!(i.cross(&j), Vector::unit(2));
/// assert_eq!(i.dot(&i).to_string(), "1");
/// ```
#[derive(Clone)]
pub struct Vector {
    components: Rc<[Fraction; 3]>,
    /// Scalars other than zero, and what they multiply, if it was made as a combination.
    parts: Option<Rc<[Part]>>,
}

/// A summand of a combination: a scalar and the components of what it multiplies.
type Part = (Fraction, Rc<[Fraction; 3]>);

impl Vector {
    /// The vector with the given components.
    #[must_use]
    pub fn new(x: Fraction, y: Fraction, z: Fraction) -> Vector {
        Vector { components: Rc::new([x, y, z]), parts: None }
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
        let mut components = [Fraction::zero(), Fraction::zero(), Fraction::zero()];
        components[axis] = Fraction::one();
        Vector { components: Rc::new(components), parts: None }
    }

    /// The components x, y and z.
    #[must_use]
    pub fn components(&self) -> &[Fraction; 3] {
        &self.components
    }

    /// The vectors that it is a combination of, with their scalar factors.
    pub(crate) fn parts(&self) -> Vec<(Fraction, Vector)> {
        let part = |(scalar, vector): Part| (scalar, Vector { components: vector, parts: None });
        self.summands().into_iter().map(part).collect()
    }

    fn summands(&self) -> Vec<Part> {
        match &self.parts {
            Some(parts) => parts.to_vec(),
            None => vec![(Fraction::one(), self.components.clone())],
        }
    }

    /// Whether all components are zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.components.iter().all(Fraction::is_zero)
    }

    /// The vector with `map` applied to each component.
    #[must_use]
    pub fn map(&self, map: impl FnMut(&Fraction) -> Fraction) -> Vector {
        let [x, y, z] = self.components().each_ref().map(map);
        Vector::new(x, y, z)
    }

    /// The product with a scalar.
    #[must_use]
    pub fn scale(&self, factor: &Fraction) -> Vector {
        let parts = self.summands().into_iter().map(|(scalar, vector)| (times(&scalar, factor), vector));
        let parts = parts.filter(|(scalar, _)| !scalar.is_zero()).collect();
        Vector { parts: Some(parts), ..self.map(|component| component * factor) }
    }

    /// The product with a rational number.
    #[must_use]
    pub fn scale_by(&self, factor: &Rational) -> Vector {
        let parts = self.summands().into_iter().map(|(scalar, vector)| (scalar.scale(factor), vector));
        let parts = parts.filter(|(scalar, _)| !scalar.is_zero()).collect();
        Vector { parts: Some(parts), ..self.map(|component| component.scale(factor)) }
    }

    /// The scalar product.
    #[must_use]
    pub fn dot(&self, other: &Vector) -> Fraction {
        let products = self.components().iter().zip(other.components()).map(|(a, b)| a * b);
        products.fold(Fraction::zero(), |sum, product| &sum + &product)
    }

    /// The vector product.
    #[must_use]
    pub fn cross(&self, other: &Vector) -> Vector {
        let [a, b] = [self.components(), other.components()];
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
        Vector { parts: self.parts.clone(), ..self.map(Fraction::reduced) }
    }
}

/// The product, where 1 leaves the other factor as it is written.
fn times(scalar: &Fraction, factor: &Fraction) -> Fraction {
    if scalar.is_one() { factor.clone() } else { scalar * factor }
}

impl Add for &Vector {
    type Output = Vector;

    fn add(self, other: &Vector) -> Vector {
        let mut parts = self.summands();
        for (scalar, vector) in other.summands() {
            match parts.iter_mut().find(|(_, own)| Rc::ptr_eq(own, &vector)) {
                Some((own, _)) => *own = &*own + &scalar,
                None => parts.push((scalar, vector)),
            }
        }
        parts.retain(|(scalar, _)| !scalar.is_zero());
        let [a, b] = [self.components(), other.components()];
        let sum = Vector::new(&a[0] + &b[0], &a[1] + &b[1], &a[2] + &b[2]);
        Vector { parts: Some(parts.into()), ..sum }
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
        self.scale_by(&crate::integer(-1))
    }
}

impl PartialEq for Vector {
    fn eq(&self, other: &Vector) -> bool {
        self.components() == other.components()
    }
}

impl Eq for Vector {}

impl fmt::Debug for Vector {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Display for Vector {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y, z] = self.components();
        write!(f, "({x}, {y}, {z})")
    }
}
