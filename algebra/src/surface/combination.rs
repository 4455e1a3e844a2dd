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
        if !sum.is_independent() {
            sum = Sum::new(known);
            sum.add(&Fraction::one(), &vector.derivative(parameter));
        }
        sum.combined(&[])
    }

    /// The vector product; `None` where both are parallel.
    pub(super) fn cross(&self, other: &Combination, known: &[[Poly; 3]]) -> Option<Direction> {
        let mut sum = Sum::new(known);
        for (a, p) in &self.terms {
            for (b, q) in other.terms.iter().filter(|(_, q)| p != q) {
                sum.add_direction(&(a * b).into(), product(p, q));
            }
        }
        if !sum.is_independent() {
            sum = Sum::new(known);
            sum.add_direction(&Fraction::one(), product(&self.vector(), &other.vector()));
        }
        let denominators = [&self.factor, &other.factor].into_iter().flat_map(Fraction::factors);
        // What the derivatives were divided by is likely to divide their product once more.
        let likely: Vec<&Poly> = denominators.map(|(factor, _)| factor).collect();
        let combined = sum.combined(&likely)?;
        let direction = Direction::of_polynomials(combined.vector(), &likely)?;
        Some(direction.times(&combined.factor.reduced_product(&self.factor.reduced_product(&other.factor))))
    }

    /// The sum without its factor.
    fn vector(&self) -> [Poly; 3] {
        [0, 1, 2].map(|axis| {
            self.terms.iter().map(|(coefficient, direction)| coefficient * &direction[axis]).sum()
        })
    }
}

/// The vector product.
fn product(p: &[Poly; 3], q: &[Poly; 3]) -> [Poly; 3] {
    let minor = |i: usize, j: usize| &p[i] * &q[j] - &p[j] * &q[i];
    [minor(1, 2), minor(2, 0), minor(0, 1)]
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

    /// Whether the directions are certainly linearly independent, so that the coefficients are determined: a sum where some cancel in
    /// disguise would be much larger than its components.
    fn is_independent(&self) -> bool {
        match self.terms.as_slice() {
            // No two are multiples of each other.
            [] | [_] | [_, _] => true,
            [(_, p), (_, q), (_, r)] => {
                let at_sample = |vector: &[Poly; 3]| {
                    vector.each_ref().map(|component| {
                        let variables = component.occurring_variables().into_iter();
                        // Numbers that belong to the variables, whichever occur.
                        let number = |variable: &Variable| {
                            let name = variable.name().bytes().fold(7, |sum, byte| 3 * sum + i64::from(byte));
                            Poly::integer(2 + name % 97)
                        };
                        component.evaluate(
                            &variables.map(|variable| (variable.clone(), number(&variable))).collect(),
                        )
                    })
                };
                let [p, q, r] = [p, q, r].map(at_sample);
                let determinant: Poly = product(&p, &q).iter().zip(&r).map(|(a, b)| a * b).sum();
                !determinant.is_zero()
            }
            _ => false,
        }
    }

    /// The combination; `None` if no term is left. Likely common factors are tried first.
    fn combined(self, likely: &[&Poly]) -> Option<Combination> {
        let common = Fraction::common_denominator(self.terms.iter().map(|(coefficient, _)| coefficient));
        let (mut coefficients, directions): (Vec<Poly>, Vec<[Poly; 3]>) =
            self.terms.into_iter().map(|(c, direction)| (c.numerator_over(&common), direction)).unzip();
        let mut factor = Poly::one();
        for &candidate in likely {
            factor *= candidate.pow(Poly::take_out_of_all(&mut coefficients, candidate, u32::MAX));
        }
        let gcd = match coefficients.as_slice() {
            [] => return None,
            [only] => only.clone(),
            several => budget::doing("the common factor of a combination", || Poly::gcd_many(several)),
        };
        let quotient = |coefficient: Poly| coefficient.exact_div(&gcd).unwrap_or(coefficient);
        let terms = coefficients.into_iter().map(quotient).zip(directions).collect();
        Some(Combination { factor: Fraction::new(factor * &gcd, common).reduced(), terms })
    }
}
