//! Vectors as combinations of directions.

use super::direction::Direction;
use crate::{Fraction, Poly, Variable, Vector, budget};

/// A vector `factor · Σ cᵢ dᵢ` with directions dᵢ that are no multiples of each other and polynomials cᵢ without common factor.
///
/// The derivatives of a sweep `s + x n + z k` are combinations of the tangent, the normal and **k** (FN (19), (27), (32)), and so is
/// their product. The cᵢ are polynomials of a few terms, where the components, which contain the coordinates of tangent and
/// normal, have thousands: common factors are found, and zeros are seen, before anything is multiplied out.
#[derive(Clone, Debug)]
pub(super) struct Combination {
    factor: Fraction,
    terms: Vec<(Poly, [Poly; 3])>,
}

/// With more directions a combination gains nothing over the components.
const MOST_DIRECTIONS: usize = 4;

impl Combination {
    /// The derivative of a vector by a parameter, with the directions that may occur; `None` if it is zero.
    pub(super) fn derivative(
        vector: &Vector,
        parameter: &Variable,
        known: &[[Poly; 3]],
    ) -> Option<Combination> {
        let mut sum = Sum::new(known);
        for (scalar, part) in vector.parts() {
            sum.add(&scalar.derivative(parameter), &part.reduced());
            sum.add(&scalar.reduced(), &part.derivative(parameter));
        }
        if sum.terms.len() > MOST_DIRECTIONS {
            sum = Sum::new(known);
            sum.add(&Fraction::one(), &vector.derivative(parameter));
        }
        sum.combined()
    }

    /// The vector product; `None` where both are parallel.
    pub(super) fn cross(&self, other: &Combination, known: &[[Poly; 3]]) -> Option<Direction> {
        let mut sum = Sum::new(known);
        for (a, p) in &self.terms {
            for (b, q) in &other.terms {
                if p != q {
                    let minor = |i: usize, j: usize| &p[i] * &q[j] - &p[j] * &q[i];
                    sum.add_direction(&(a * b).into(), [minor(1, 2), minor(2, 0), minor(0, 1)]);
                }
            }
        }
        let product = sum.combined()?;
        let denominators = [&self.factor, &other.factor].into_iter().flat_map(Fraction::factors);
        // What the derivatives were divided by is likely to divide their product once more.
        let likely: Vec<&Poly> = denominators.map(|(factor, _)| factor).collect();
        let direction = Direction::of_polynomials(product.vector(), &likely)?;
        Some(direction.times(&product.factor.reduced_product(&self.factor.reduced_product(&other.factor))))
    }

    /// The sum without its factor.
    fn vector(&self) -> [Poly; 3] {
        [0, 1, 2].map(|axis| {
            self.terms.iter().map(|(coefficient, direction)| coefficient * &direction[axis]).sum()
        })
    }
}

/// A sum of multiples of directions.
struct Sum<'a> {
    known: &'a [[Poly; 3]],
    /// Reduced coefficients other than zero, and distinct directions.
    terms: Vec<(Fraction, [Poly; 3])>,
}

impl<'a> Sum<'a> {
    fn new(known: &'a [[Poly; 3]]) -> Sum<'a> {
        Sum { known, terms: Vec::new() }
    }

    /// Adds a multiple of a reduced vector.
    fn add(&mut self, scalar: &Fraction, vector: &Vector) {
        if scalar.is_zero() || vector.is_zero() {
            return;
        }
        let common = Fraction::common_denominator(vector.components());
        let numerators = vector.components().each_ref().map(|component| component.numerator_over(&common));
        self.add_direction(&scalar.reduced_product(&Fraction::new(Poly::one(), common)), numerators);
    }

    /// Adds a multiple of a vector of polynomials.
    fn add_direction(&mut self, scalar: &Fraction, vector: [Poly; 3]) {
        let present = self.terms.iter().map(|(_, direction)| direction);
        let along = present.chain(self.known).find_map(|known| Direction::along(&vector, known));
        let Some(direction) = along.or_else(|| Direction::of_polynomials(vector, &[])) else { return };
        let coefficient = scalar.reduced_product(&direction.factor);
        match self.terms.iter().position(|(_, own)| *own == direction.numerator) {
            Some(place) => {
                let sum = (&self.terms[place].0 + &coefficient).reduced();
                if sum.is_zero() {
                    self.terms.remove(place);
                } else {
                    self.terms[place].0 = sum;
                }
            }
            None => self.terms.push((coefficient, direction.numerator)),
        }
    }

    /// The combination; `None` if no term is left.
    fn combined(self) -> Option<Combination> {
        let common = Fraction::common_denominator(self.terms.iter().map(|(coefficient, _)| coefficient));
        let (coefficients, directions): (Vec<Poly>, Vec<[Poly; 3]>) =
            self.terms.into_iter().map(|(c, direction)| (c.numerator_over(&common), direction)).unzip();
        let gcd = match coefficients.as_slice() {
            [] => return None,
            [only] => only.clone(),
            several => budget::doing("the common factor of a combination", || Poly::gcd_many(several)),
        };
        let quotient = |coefficient: Poly| coefficient.exact_div(&gcd).unwrap_or(coefficient);
        let terms = coefficients.into_iter().map(quotient).zip(directions).collect();
        Some(Combination { factor: Fraction::new(gcd, common).reduced(), terms })
    }
}
