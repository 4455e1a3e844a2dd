//! The surface normal.

use num_traits::One;

use num_traits::Signed;

use super::direction::Direction;
use super::homogeneous::Homogeneous;
use crate::geometry::sample::sample_sign_on_box;
use crate::{Fraction, Interval, Poly, Rational, SquareSplit, Variable, Vector, budget};

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
    norm_squared: Poly,
    split: SquareSplit,
    radicand: Poly,
}

impl Normal {
    /// The normal of a surface; `None` if `R_u × R_v` vanishes identically, so that it is no surface but a curve or a
    /// point. `domain` is where the parameters run.
    ///
    /// The derivatives keep the factors of the weight as their denominators; each is split into a factor and a direction,
    /// and only the directions are multiplied.
    #[must_use]
    pub fn of(surface: &Homogeneous, domain: &[Interval; 2]) -> Option<Normal> {
        let [u, v] = surface.parameters();
        let position = surface.cartesian();
        let along_u = Direction::of(&position.derivative(u))?;
        let along_v = Direction::of(&position.derivative(v))?;
        let mut cross = budget::doing("the product of R_u and R_v", || along_u.cross(&along_v))?;
        if sample_sign_on_box(&cross.factor, surface.parameters(), domain).is_lt() {
            cross = cross.reversed();
        }
        let norm_squared = cross.norm2();
        let Direction { factor, numerator } = cross;
        let split = budget::doing("the square root of |R_u x R_v|^2", || norm_squared.square_split());
        // Factors in the symbols alone are numbers, as far as the parameters go.
        let mut split = split;
        let mut radicand = Poly::one();
        for (part, _) in split.odd.squarefree().factors {
            if !surface.parameters().iter().any(|parameter| part.contains(parameter)) {
                split.odd = split.odd.exact_div(&part).unwrap_or(split.odd);
                radicand *= part;
            }
        }
        Some(Normal { numerator, factor, norm_squared, split, radicand })
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
    pub fn norm_squared(&self) -> &Poly {
        &self.norm_squared
    }

    /// The factor of odd multiplicity in the squared length that is free of the parameters: a polynomial in the symbols,
    /// 1 if there is none. The squared length is `unit · radicand · root² · odd`.
    #[must_use]
    pub fn radicand(&self) -> &Poly {
        &self.radicand
    }

    /// The squared length as `unit · root² · odd`, up to [`Normal::radicand`].
    #[must_use]
    pub fn split(&self) -> &SquareSplit {
        &self.split
    }

    /// Whether the unit normal, and with it every offset, is rational in the given parameters, over the real numbers: the
    /// squared length is a square up to a positive number, or a polynomial in the symbols, which is positive as it is the
    /// quotient of a sum of squares and a square.
    #[must_use]
    pub fn is_rational(&self) -> bool {
        self.split.is_square()
    }

    /// The length of the numerator, if it is a polynomial over the real numbers: positive where the domain begins.
    #[must_use]
    pub fn length(&self, parameters: &[Variable; 2], domain: &[Interval; 2]) -> Option<Poly> {
        if !self.is_rational() || !self.radicand.is_one() {
            return None;
        }
        let length = &self.split.root * self.split.unit.sqrt()?;
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
            norm_squared: map(&self.norm_squared),
            split: SquareSplit {
                unit: map(&self.split.unit),
                root: map(&self.split.root),
                odd: map(&self.split.odd),
            },
            radicand: map(&self.radicand),
        }
    }

    /// Shows all polynomials to `see`, in the order in which [`Normal::map`] maps them.
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
