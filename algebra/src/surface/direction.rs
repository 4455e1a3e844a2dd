//! The direction of a vector of rational functions, apart from its length.

use crate::{Fraction, Poly, Vector, budget};

/// A vector as `factor · numerator`, with a numerator of three polynomials without common factor and without common
/// content.
///
/// Products of vectors are taken of numerators: the factors, such as `σ(1 + κx)` in `R_v` of an oriented translation, need
/// not be multiplied out to be found again.
#[derive(Clone, Debug)]
pub(crate) struct Direction {
    pub(crate) factor: Fraction,
    pub(crate) numerator: [Poly; 3],
}

impl Direction {
    /// The direction of a vector; `None` for the zero vector.
    ///
    /// Known factors of the denominators are kept; the gcd of the three components finds the factor that no denominator
    /// announces.
    pub(crate) fn of(vector: &Vector) -> Option<Direction> {
        let vector = vector.reduced();
        if vector.is_zero() {
            return None;
        }
        let common = Fraction::common_denominator(vector.components());
        let numerators = vector.components().each_ref().map(|component| component.numerator_over(&common));
        Some(Direction::of_polynomials(numerators).times(&Fraction::new(Poly::one(), common)))
    }

    /// The direction of a nonzero vector of polynomials.
    fn of_polynomials(vector: [Poly; 3]) -> Direction {
        let gcd = budget::doing("the common factor of a vector", || Poly::gcd_many(&vector));
        let numerator = vector.map(|component| component.exact_div(&gcd).unwrap_or(component));
        let content = Poly::common_content(&numerator);
        let numerator = numerator.map(|component| component.scale(&content.recip()).pruned());
        Direction { factor: gcd.scale(&content).into(), numerator }
    }

    /// The direction of the vector product; `None` where both are parallel.
    pub(crate) fn cross(&self, other: &Direction) -> Option<Direction> {
        let [a, b] = [&self.numerator, &other.numerator];
        let minor = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
        let product = [minor(1, 2), minor(2, 0), minor(0, 1)];
        if product.iter().all(Poly::is_zero) {
            return None;
        }
        Some(Direction::of_polynomials(product).times(&(&self.factor * &other.factor)))
    }

    /// The squared length of the numerator.
    pub(crate) fn norm2(&self) -> Poly {
        self.numerator.iter().map(|component| component * component).sum()
    }

    /// The opposite numerator with the opposite factor: the same vector.
    pub(crate) fn reversed(&self) -> Direction {
        Direction { factor: -&self.factor, numerator: self.numerator.each_ref().map(|component| -component) }
    }

    fn times(&self, factor: &Fraction) -> Direction {
        Direction { factor: (&self.factor * factor).reduced(), numerator: self.numerator.clone() }
    }
}
