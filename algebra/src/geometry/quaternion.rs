//! Quaternions of rational functions.

use std::fmt;
use std::ops::Neg;

use super::vector::Vector;
use crate::operators::binary_operator;
use crate::{Fraction, Rational};

/// A quaternion `w + x i + y j + z k` whose components are rational functions, with Hamilton's product `i j = k`.
///
/// A vector is a quaternion with `w = 0`; for every quaternion `A` and vector `v` the product `A v A*` is a vector, the
/// vector `v` rotated and stretched by `|A|²`. (Kuipers, *Quaternions and Rotation Sequences*, 1999, chapter 5.)
///
/// # Example
/// ```
/// use hodograph_algebra::{Fraction, Quaternion, Vector, integer};
/// let [one, two] = [1, 2].map(|n| Fraction::from(integer(n)));
/// let a = Quaternion::new(one.clone(), two, Fraction::zero(), one);
/// assert_eq!((&a * &a.conj()).to_string(), "(6, 0, 0, 0)");
/// let [i, j, k] = [0, 1, 2].map(|axis| Quaternion::from(Vector::unit(axis)));
/// assert_eq!(&i * &j, k);
/// let [first, second, third] = a.rotation().unwrap();
/// assert_eq!(first.cross(&second), third);
/// assert_eq!(first.to_string(), "(2/3, 1/3, 2/3)");
/// ```
#[derive(Clone, PartialEq, Eq)]
pub struct Quaternion {
    components: [Fraction; 4],
}

impl Quaternion {
    /// The quaternion `w + x i + y j + z k`.
    #[must_use]
    pub fn new(w: Fraction, x: Fraction, y: Fraction, z: Fraction) -> Quaternion {
        Quaternion { components: [w, x, y, z] }
    }

    /// Zero.
    #[must_use]
    pub fn zero() -> Quaternion {
        Quaternion::from(Fraction::zero())
    }

    /// One.
    #[must_use]
    pub fn one() -> Quaternion {
        Quaternion::from(Fraction::one())
    }

    /// The components w, x, y and z.
    #[must_use]
    pub fn components(&self) -> &[Fraction; 4] {
        &self.components
    }

    /// The scalar part `w`.
    #[must_use]
    pub fn scalar(&self) -> &Fraction {
        &self.components[0]
    }

    /// The vector part `x i + y j + z k`.
    #[must_use]
    pub fn vector(&self) -> Vector {
        let [_, x, y, z] = self.components.clone();
        Vector::new(x, y, z)
    }

    /// Whether all components are zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.components.iter().all(Fraction::is_zero)
    }

    /// Whether the scalar part is zero.
    #[must_use]
    pub fn is_vector(&self) -> bool {
        self.scalar().is_zero()
    }

    /// Whether the vector part is zero.
    #[must_use]
    pub fn is_scalar(&self) -> bool {
        self.components[1..].iter().all(Fraction::is_zero)
    }

    /// The conjugate `A* = w − x i − y j − z k`.
    #[must_use]
    pub fn conj(&self) -> Quaternion {
        let [w, x, y, z] = &self.components;
        Quaternion::new(w.clone(), -x, -y, -z)
    }

    /// The squared norm `|A|² = w² + x² + y² + z²`.
    #[must_use]
    pub fn norm2(&self) -> Fraction {
        self.components.iter().fold(Fraction::zero(), |sum, part| &sum + &(part * part))
    }

    /// The quaternion with `map` applied to each component.
    #[must_use]
    pub fn map(&self, map: impl FnMut(&Fraction) -> Fraction) -> Quaternion {
        Quaternion { components: self.components.each_ref().map(map) }
    }

    /// The product with a scalar.
    #[must_use]
    pub fn scale(&self, factor: &Fraction) -> Quaternion {
        self.map(|part| part * factor)
    }

    /// The product with a rational number.
    #[must_use]
    pub fn scale_by(&self, factor: &Rational) -> Quaternion {
        self.map(|part| part.scale(factor))
    }

    /// The inverse `A*/|A|²`; `None` for zero.
    #[must_use]
    pub fn inverse(&self) -> Option<Quaternion> {
        let inverse = self.norm2().reciprocal(&[])?;
        Some(self.conj().scale(&inverse).reduced())
    }

    /// The quaternion with known factors cancelled in each component.
    #[must_use]
    pub fn reduced(&self) -> Quaternion {
        self.map(Fraction::reduced)
    }

    /// The vector `A v A*`.
    #[must_use]
    pub fn sandwich(&self, v: &Vector) -> Vector {
        (&(self * &Quaternion::from(v.clone())) * &self.conj()).vector()
    }

    /// The rotation `v ↦ A v A*/|A|²` as the columns of its matrix: the images of **i**, **j** and **k**, which are
    /// orthonormal and right-handed. The quaternion need not have length 1: this is its homogeneous Euler–Rodrigues matrix
    /// over `|A|²`. `None` for zero.
    #[must_use]
    pub fn rotation(&self) -> Option<[Vector; 3]> {
        let inverse = self.norm2().reduced().reciprocal(&[])?;
        Some([0, 1, 2].map(|axis| {
            let image = self.sandwich(&Vector::unit(axis));
            image.map(|component| component * &inverse)
        }))
    }
}

impl From<Fraction> for Quaternion {
    fn from(scalar: Fraction) -> Quaternion {
        Quaternion::new(scalar, Fraction::zero(), Fraction::zero(), Fraction::zero())
    }
}

impl From<Vector> for Quaternion {
    fn from(vector: Vector) -> Quaternion {
        let [x, y, z] = vector.components().clone();
        Quaternion::new(Fraction::zero(), x, y, z)
    }
}

binary_operator!(Quaternion: Add add, |a, b| Quaternion {
    components: std::array::from_fn(|i| &a.components[i] + &b.components[i]),
});
binary_operator!(Quaternion: Sub sub, |a, b| Quaternion {
    components: std::array::from_fn(|i| &a.components[i] - &b.components[i]),
});
binary_operator!(Quaternion: Mul mul, |a, b| product(a, b));

/// Hamilton's product: `(w + v)(w' + v') = ww' − v·v' + wv' + w'v + v × v'`.
fn product(a: &Quaternion, b: &Quaternion) -> Quaternion {
    let ([w, x, y, z], [p, q, r, s]) = (&a.components, &b.components);
    let sum = |terms: [(&Fraction, &Fraction, bool); 4]| {
        terms.into_iter().filter(|(a, b, _)| !a.is_zero() && !b.is_zero()).fold(
            Fraction::zero(),
            |sum, (a, b, positive)| {
                let term = a * b;
                if positive { &sum + &term } else { &sum - &term }
            },
        )
    };
    Quaternion::new(
        sum([(w, p, true), (x, q, false), (y, r, false), (z, s, false)]),
        sum([(w, q, true), (x, p, true), (y, s, true), (z, r, false)]),
        sum([(w, r, true), (y, p, true), (z, q, true), (x, s, false)]),
        sum([(w, s, true), (z, p, true), (x, r, true), (y, q, false)]),
    )
}

impl Neg for &Quaternion {
    type Output = Quaternion;

    fn neg(self) -> Quaternion {
        self.map(|part| -part)
    }
}

impl Neg for Quaternion {
    type Output = Quaternion;

    fn neg(self) -> Quaternion {
        -&self
    }
}

impl fmt::Debug for Quaternion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl fmt::Display for Quaternion {
    /// The components `(w, x, y, z)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [w, x, y, z] = &self.components;
        write!(f, "({w}, {x}, {y}, {z})")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Poly, Variable};

    /// A quaternion of four symbols.
    fn symbolic(name: &str) -> Quaternion {
        let part = |letter: char| {
            Fraction::from(Poly::variable(&Variable::new(Variable::SYMBOL, &format!("{name}{letter}"))))
        };
        Quaternion::new(part('w'), part('x'), part('y'), part('z'))
    }

    #[test]
    fn quaternions_are_a_division_ring() {
        let [a, b, c] = ["a", "b", "c"].map(symbolic);
        assert_eq!(&(&a * &b) * &c, &a * &(&b * &c));
        assert_eq!(&a * &(&b + &c), &a * &b + &a * &c);
        assert_ne!(&a * &b, &b * &a);
        assert_eq!((&a * &b).conj(), &b.conj() * &a.conj());
        assert_eq!((&a * &b).norm2(), &a.norm2() * &b.norm2());
        assert_eq!(&a * &a.inverse().unwrap(), Quaternion::one());
        assert_eq!(Quaternion::zero().inverse(), None);
        assert_eq!(&a - &a, Quaternion::zero());
        let units = [0, 1, 2].map(|axis| Quaternion::from(Vector::unit(axis)));
        for unit in &units {
            assert_eq!(unit * unit, -Quaternion::one());
        }
        assert_eq!(&(&units[0] * &units[1]) * &units[2], -Quaternion::one());
    }

    #[test]
    fn rotations_are_orthonormal_and_compose() {
        let [a, b] = ["a", "b"].map(symbolic);
        let columns = a.rotation().unwrap();
        for i in 0..3 {
            assert_eq!(columns[i].norm2(), Fraction::one());
            assert_eq!(columns[i].cross(&columns[(i + 1) % 3]), columns[(i + 2) % 3]);
        }
        let v = symbolic("v").vector();
        assert!((&(&a * &Quaternion::from(v.clone())) * &a.conj()).is_vector());
        assert_eq!((&a * &b).sandwich(&v), a.sandwich(&b.sandwich(&v)));
        assert_eq!(Quaternion::zero().rotation(), None);
    }
}
