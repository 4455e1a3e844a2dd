//! The surface normal.

use std::cell::OnceCell;

use num_traits::{One, Signed};

use super::combination::Combination;
use super::direction::Direction;
use super::squared_length::SquaredLength;
use crate::geometry::sample::sample_sign_on_box;
use crate::{Fraction, Interval, Poly, Rational, Variable, Vector, budget};

/// The normal direction of a rational surface, in lowest terms: `R_u × R_v = factor · numerator` (FN (11)).
///
/// The three components of the numerator are polynomials without common factor and without common content. The sign is
/// chosen so that `factor` is positive where the domain begins; so where `factor` is positive, the numerator points the
/// way of `R_u × R_v`.
///
/// # Example
/// The cylinder over the unit circle, whose unit normal is rational:
/// ```
/// use hodograph_algebra::{Fraction, Interval, Poly, SweptSurface, Variable, Vector};
/// let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
/// let [u, v] = parameters.each_ref().map(|parameter| Fraction::from(Poly::variable(parameter)));
/// let (one, square) = (Fraction::one(), &u * &u);
/// let weight = &one + &square;
/// let circle = Vector::new(&(&one - &square) / &weight, &(&u + &u) / &weight, v);
/// let domain = [Interval::unit(), Interval::unit()];
/// let surface = SweptSurface::new(circle, parameters, domain.clone());
/// let normal = surface.normal().unwrap();
/// assert_eq!(normal.numerator().each_ref().map(ToString::to_string), ["-u^2 + 1", "2*u", "0"]);
/// assert!(normal.is_rational());
/// assert_eq!(normal.length(surface.parameters(), &domain).unwrap().to_string(), "u^2 + 1");
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Normal {
    numerator: [Poly; 3],
    factor: Fraction,
    parameters: [Variable; 2],
    length: OnceCell<SquaredLength>,
}

impl Normal {
    /// The normal of a surface; `None` if `R_u × R_v` vanishes identically, so that it is no surface but a curve or a
    /// point. `domain` is where the parameters run; `directions` are tried for the derivatives.
    ///
    /// The derivatives are kept as combinations of the directions that the position is made of, with the known factors of their
    /// denominators.
    #[must_use]
    pub(crate) fn of(
        position: &Vector,
        parameters: &[Variable; 2],
        domain: &[Interval; 2],
        directions: &[[Poly; 3]],
    ) -> Option<Normal> {
        let [u, v] = parameters;
        let along_u = Combination::derivative(position, u, directions)?;
        let along_v = Combination::derivative(position, v, directions)?;
        let mut cross = budget::doing("the product of R_u and R_v", || along_u.cross(&along_v, directions))?;
        if sample_sign_on_box(&cross.factor, parameters, domain).is_lt() {
            cross = cross.reversed();
        }
        let Direction { factor, numerator } = cross;
        Some(Normal { numerator, factor, parameters: parameters.clone(), length: OnceCell::new() })
    }

    /// The same normal with a factor in lowest terms: parts that the known factors of its denominator have in common with its
    /// numerator are cancelled as well.
    #[must_use]
    pub(crate) fn in_lowest_terms(self) -> Normal {
        Normal { factor: self.factor.lowest_terms(), ..self }
    }

    /// The components of the numerator.
    #[must_use]
    pub fn numerator(&self) -> &[Poly; 3] {
        &self.numerator
    }

    /// The rational function with `R_u × R_v = factor · numerator`.
    #[must_use]
    pub fn factor(&self) -> &Fraction {
        &self.factor
    }

    /// A polynomial with the sign of the factor: its numerator times the parts that its denominator has to an odd power. Where
    /// it is positive, the numerator points the way of `R_u × R_v`.
    #[must_use]
    pub fn orientation(&self) -> Poly {
        let factor = self.factor.lowest_terms();
        let odd = factor.factors().iter().filter(|(_, exponent)| exponent % 2 == 1);
        let signed = odd.fold(factor.numerator().clone(), |product, (part, _)| product * part);
        if signed.content().is_negative() { -signed.primitive() } else { signed.primitive() }
    }

    /// The squared length of the numerator.
    #[must_use]
    pub fn squared_length(&self) -> &SquaredLength {
        self.length.get_or_init(|| {
            budget::doing("the square |N|^2 of the normal", || {
                SquaredLength::of(&self.numerator, &self.parameters)
            })
        })
    }

    /// Whether the unit normal, and with it every offset, is rational in the given parameters, over the real numbers: the
    /// squared length is a square up to a positive number, or a polynomial in the symbols, which is positive as it is the
    /// quotient of a sum of squares and a square.
    #[must_use]
    pub fn is_rational(&self) -> bool {
        self.squared_length().split().is_square()
    }

    /// The length of the numerator, if it is a polynomial over the real numbers: positive where the domain begins.
    #[must_use]
    pub fn length(&self, parameters: &[Variable; 2], domain: &[Interval; 2]) -> Option<Poly> {
        let squared = self.squared_length();
        let split = squared.split();
        if !split.is_square() || !squared.radicand().is_one() {
            return None;
        }
        let length = &split.root * split.unit.sqrt()?;
        let negative = sample_sign_on_box(&length.clone().into(), parameters, domain).is_lt();
        Some(if negative { -length } else { length })
    }

    /// The unit normal, if it is rational; on the part of the domain where factor and length keep their signs.
    #[must_use]
    pub fn unit(&self, parameters: &[Variable; 2], domain: &[Interval; 2]) -> Option<Vector> {
        let length = self.length(parameters, domain)?;
        let [x, y, z] = self.numerator.each_ref().map(|component| Fraction::from(component.clone()));
        let factors = length.squarefree();
        let inverse = Fraction::new(factors.unit.inverse(), factors.factors);
        Some(Vector::new(x, y, z).scale(&inverse).reduced())
    }

    /// The same normal with `map`, a homomorphism that keeps the parameters, applied to all polynomials.
    pub(crate) fn map(&self, mut map: impl FnMut(&Poly) -> Poly) -> Normal {
        Normal {
            numerator: self.numerator.each_ref().map(&mut map),
            factor: self.factor.map(&mut map),
            length: self.length.get().map(|length| OnceCell::from(length.map(&mut map))).unwrap_or_default(),
            parameters: self.parameters.clone(),
        }
    }

    /// Shows all polynomials that are known already to `see`, in the order in which [`Normal::map`] maps them.
    pub(crate) fn visit(&self, mut see: impl FnMut(&Poly)) {
        self.map(|poly| {
            see(poly);
            poly.clone()
        });
    }

    /// Whether all three components are polynomials without common content: what holds of every normal.
    #[must_use]
    pub fn is_valid(&self) -> bool {
        Poly::common_content(&self.numerator) == Rational::one()
            && self.numerator.iter().all(Poly::is_valid)
            && Poly::coprime(&self.numerator)
    }
}
