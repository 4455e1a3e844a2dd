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
    /// The direction of a [reduced](Vector::reduced) vector; `None` for the zero vector.
    ///
    /// Known factors of the denominators are kept; the gcd of the three components finds the factor that no denominator
    /// announces, unless the vector is along one of the `known` directions, which is tried first.
    pub(crate) fn of(vector: &Vector, known: &[[Poly; 3]]) -> Option<Direction> {
        if vector.is_zero() {
            return None;
        }
        let common = Fraction::common_denominator(vector.components());
        let numerators = vector.components().each_ref().map(|component| component.numerator_over(&common));
        let direction = known.iter().find_map(|known| Direction::along(&numerators, known));
        let direction = direction.or_else(|| Direction::of_polynomials(numerators, &[]))?;
        Some(direction.times(&Fraction::new(Poly::one(), common)))
    }

    /// The vector as a multiple of `direction`, if it is one.
    pub(super) fn along(vector: &[Poly; 3], direction: &[Poly; 3]) -> Option<Direction> {
        let mut pairs: Vec<(&Poly, &Poly)> = vector.iter().zip(direction).collect();
        pairs.sort_by_key(|(_, component)| component.terms().len());
        pairs.retain(|(_, component)| !component.is_zero());
        let zero = |(component, known): (&Poly, &Poly)| !known.is_zero() || component.is_zero();
        if !vector.iter().zip(direction).all(zero) {
            return None;
        }
        let (first, others) = pairs.split_first()?;
        let factor = first.0.exact_div(first.1)?;
        let parallel = others.iter().all(|(component, known)| **component == &factor * *known);
        parallel.then(|| Direction { factor: factor.into(), numerator: direction.clone() })
    }

    /// The direction of a vector of polynomials; `None` for the zero vector. Likely common factors are tried first; the gcd then certifies that
    /// nothing is left in common, which is much cheaper than to find it.
    pub(super) fn of_polynomials(mut vector: [Poly; 3], likely: &[&Poly]) -> Option<Direction> {
        if vector.iter().all(Poly::is_zero) {
            return None;
        }
        let mut factor = Poly::one();
        for &candidate in likely {
            factor *= candidate.pow(Poly::take_out_of_all(&mut vector, candidate, u32::MAX));
        }
        let gcd = budget::doing("the common factor of a vector", || Poly::gcd_many(&vector));
        let numerator = vector.map(|component| component.exact_div(&gcd).unwrap_or(component));
        let content = Poly::common_content(&numerator);
        let numerator = numerator.map(|component| component.scale(&content.recip()).pruned());
        Some(Direction { factor: (factor * gcd).scale(&content).into(), numerator })
    }

    /// The opposite numerator with the opposite factor: the same vector.
    pub(crate) fn reversed(&self) -> Direction {
        Direction { factor: -&self.factor, numerator: self.numerator.each_ref().map(|component| -component) }
    }

    /// A multiple of the vector.
    pub(super) fn times(&self, factor: &Fraction) -> Direction {
        Direction { factor: self.factor.reduced_product(factor), numerator: self.numerator.clone() }
    }
}
