//! The homogeneous coordinates of a rational surface.

use std::fmt;

use num_traits::Signed;

use super::degree::Bidegree;
use crate::{Fraction, Poly, Variable, Vector, budget};

/// The homogeneous coordinates `(W, X, Y, Z)` of a rational surface: polynomials without common factor and without common
/// content, with the Cartesian coordinates `(X/W, Y/W, Z/W)` (FN (10)).
///
/// Over the rationals they are primitive integer polynomials. Over a number field their coefficients in the basis of the
/// field are integers without common divisor; of the factor in the field that remains free, a surface over a domain
/// makes the weight at the domain's beginning rational (see [`Homogeneous::with_rational_weight_at`]). That weight is
/// positive; where it is zero or depends on symbols, the first term of `W` is.
///
/// # Example
/// ```
/// use hodograph_algebra::{Fraction, Homogeneous, Poly, Variable, Vector};
/// let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
/// let [u, v] = parameters.each_ref().map(|p| Fraction::from(Poly::variable(p)));
/// let weight = &Fraction::one() + &(&u * &u);
/// let surface = Vector::new(&u / &weight, &v / &weight, Fraction::one());
/// let reduced = Homogeneous::of(&surface, &parameters);
/// assert_eq!(reduced.to_string(), "(u^2 + 1, u, v, u^2 + 1)");
/// assert_eq!(reduced.degree().to_string(), "(2, 1)");
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Homogeneous {
    coordinates: [Poly; 4],
    parameters: [Variable; 2],
    raw_degrees: [Bidegree; 4],
    common_factor: Poly,
    weight_factors: Vec<(Poly, u32)>,
}

impl Homogeneous {
    /// The names of the coordinates, in their order.
    pub const NAMES: [&str; 4] = ["W", "X", "Y", "Z"];

    /// The homogeneous coordinates of `surface`: over the least common denominator of the factors with which its
    /// components are written, then without common factor.
    ///
    /// Known factors of the denominator are tried first; the gcd of all four coordinates then certifies that nothing is
    /// left in common.
    #[must_use]
    pub fn of(surface: &Vector, parameters: &[Variable; 2]) -> Homogeneous {
        let common = Fraction::common_denominator(surface.components());
        let weight: Poly = common.iter().map(|(factor, exponent)| factor.pow(*exponent)).product();
        let [x, y, z] = surface.components().each_ref().map(|component| component.numerator_over(&common));
        Homogeneous::from_coordinates([weight, x, y, z], common, parameters)
    }

    fn from_coordinates(raw: [Poly; 4], known: Vec<(Poly, u32)>, parameters: &[Variable; 2]) -> Homogeneous {
        let raw_degrees = raw.each_ref().map(|coordinate| Bidegree::of(coordinate, parameters));
        let mut coordinates = raw;
        let mut common_factor = Poly::one();
        let mut weight_factors = Vec::new();
        for (factor, exponent) in known {
            let common = Poly::take_out_of_all(&mut coordinates, &factor, exponent);
            common_factor *= factor.pow(common);
            if common < exponent {
                weight_factors.push((factor, exponent - common));
            }
        }
        let rest = budget::doing("the common factor of W, X, Y, Z", || Poly::gcd_many(&coordinates));
        if Poly::take_out_of_all(&mut coordinates, &rest, 1) == 1 {
            common_factor *= &rest;
            weight_factors = coordinates[0].squarefree().factors;
        }
        let coordinates = without_content(coordinates);
        Homogeneous {
            coordinates,
            parameters: parameters.clone(),
            raw_degrees,
            common_factor,
            weight_factors,
        }
    }

    /// The same surface, scaled such that the weight at the point `(u, v)` is rational and positive, if it is a number other
    /// than zero.
    #[must_use]
    pub fn with_rational_weight_at(self, u: &Poly, v: &Poly) -> Homogeneous {
        let [first, second] = &self.parameters;
        let weight = self.coordinates[0].substitute(first, u).substitute(second, v);
        if weight.is_zero() || !weight.is_constant() {
            return self;
        }
        let inverse = weight.inverse();
        let scaled = self.coordinates.map(|coordinate| coordinate * &inverse);
        let content = Poly::common_content(&scaled).recip();
        let coordinates = scaled.map(|coordinate| coordinate.scale(&content).pruned());
        Homogeneous { coordinates, ..self }
    }

    /// The coordinates W, X, Y, Z.
    #[must_use]
    pub fn coordinates(&self) -> &[Poly; 4] {
        &self.coordinates
    }

    /// The two parameters of the surface.
    #[must_use]
    pub fn parameters(&self) -> &[Variable; 2] {
        &self.parameters
    }

    /// The known factors of the weight W, with their exponents; W is their product up to a number.
    #[must_use]
    pub fn weight_factors(&self) -> &[(Poly, u32)] {
        &self.weight_factors
    }

    /// The strict degree of each coordinate.
    #[must_use]
    pub fn degrees(&self) -> [Bidegree; 4] {
        self.coordinates.each_ref().map(|coordinate| Bidegree::of(coordinate, &self.parameters))
    }

    /// The degree of the patch: that of all four coordinates together.
    #[must_use]
    pub fn degree(&self) -> Bidegree {
        Bidegree::of_group(&self.coordinates, &self.parameters)
    }

    /// The strict degree of each coordinate as constructed, before the common factor was removed.
    #[must_use]
    pub fn raw_degrees(&self) -> [Bidegree; 4] {
        self.raw_degrees
    }

    /// The degree of the patch as constructed, before the common factor was removed.
    #[must_use]
    pub fn raw_degree(&self) -> Bidegree {
        self.raw_degrees.into_iter().fold(Bidegree::ZERO, Bidegree::max)
    }

    /// What W, X, Y and Z had in common as constructed; 1 if nothing.
    #[must_use]
    pub fn common_factor(&self) -> &Poly {
        &self.common_factor
    }

    /// The Cartesian coordinates, each with the factors of W as its denominator, reduced.
    #[must_use]
    pub fn cartesian(&self) -> Vector {
        let [weight, x, y, z] = &self.coordinates;
        let factors = &self.weight_factors;
        let product: Poly = factors.iter().map(|(factor, exponent)| factor.pow(*exponent)).product();
        // W = unit · product
        let unit = match weight.exact_div(&product) {
            Some(unit) if unit.is_constant() => unit,
            _ => {
                return Vector::new(x.clone().into(), y.clone().into(), z.clone().into())
                    .map(|c| Fraction::new(c.numerator().clone(), [(weight.clone(), 1)]).reduced());
            }
        };
        let inverse = unit.inverse();
        let over = |numerator: &Poly| Fraction::new(numerator * &inverse, factors.iter().cloned()).reduced();
        Vector::new(over(x), over(y), over(z))
    }

    /// The same surface with `map`, a homomorphism that keeps the parameters, applied to all polynomials.
    pub(crate) fn map(&self, mut map: impl FnMut(&Poly) -> Poly) -> Homogeneous {
        Homogeneous {
            coordinates: self.coordinates.each_ref().map(&mut map),
            parameters: self.parameters.clone(),
            raw_degrees: self.raw_degrees,
            common_factor: map(&self.common_factor),
            weight_factors: self.weight_factors.iter().map(|(factor, e)| (map(factor), *e)).collect(),
        }
    }

    /// Shows all polynomials to `see`, in the order in which [`Homogeneous::map`] maps them.
    pub(crate) fn visit(&self, mut see: impl FnMut(&Poly)) {
        self.map(|poly| {
            see(poly);
            poly.clone()
        });
    }
}

/// The coordinates without common content, the first term of the weight positive.
fn without_content(coordinates: [Poly; 4]) -> [Poly; 4] {
    let content = Poly::common_content(&coordinates);
    let negative = coordinates[0].content().is_negative();
    let scale = if negative { -content.recip() } else { content.recip() };
    coordinates.map(|coordinate| coordinate.scale(&scale).pruned())
}

impl fmt::Display for Homogeneous {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [w, x, y, z] = &self.coordinates;
        write!(f, "({w}, {x}, {y}, {z})")
    }
}
