//! A surface with everything that is derived from its formula, each part when it is first asked for.

use std::cell::OnceCell;
use std::fmt;

use super::direction::Direction;
use super::homogeneous::Homogeneous;
use super::normal::Normal;
use crate::geometry::curve::rational_root;
use crate::geometry::sample::sample_sign_on_box;
use crate::{BoxSign, Fraction, Interval, Poly, Variable, Vector};

/// A rational surface `R(u, v)` over a closed box of parameters.
///
/// # Example
/// ```
/// use hodograph_algebra::{Fraction, Interval, Poly, SweptSurface, Variable, Vector};
/// let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
/// let [u, v] = parameters.each_ref().map(|p| Fraction::from(Poly::variable(p)));
/// let saddle = SweptSurface::new(Vector::new(u.clone(), v.clone(), &u * &v), parameters, [Interval::unit(), Interval::unit()]);
/// let normal = saddle.normal().unwrap();
/// assert_eq!(normal.numerator().each_ref().map(ToString::to_string), ["-v", "-u", "1"]);
/// assert!(!normal.is_rational());
/// assert_eq!(normal.split().odd.to_string(), "u^2 + v^2 + 1");
/// ```
#[derive(Clone, Debug)]
pub struct SweptSurface {
    position: Vector,
    parameters: [Variable; 2],
    domain: [Interval; 2],
    homogeneous: OnceCell<Homogeneous>,
    normal: OnceCell<Option<Normal>>,
}

/// The parametric speed along one family of isoparametric curves.
///
/// # Example
/// On the cone `R = u·(3, 4v, 4)` the curves u = const are straight lines with the parametric speed 4u:
/// ```
/// use hodograph_algebra::{Fraction, Interval, Poly, SweptSurface, Variable, Vector, integer};
/// let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
/// let [u, v] = parameters.each_ref().map(|parameter| Fraction::from(Poly::variable(parameter)));
/// let ruling = Vector::new(integer(3).into(), &v * &integer(4), integer(4).into());
/// let domain = [Interval::unit(), Interval::unit()];
/// let [along_u, along_v] = SweptSurface::new(ruling.scale(&u), parameters, domain).speeds();
/// assert_eq!(along_u.to_string(), "sqrt(16*v^2 + 25)");
/// // Not certified to be positive, since it is zero at the apex.
/// assert_eq!(along_v.root.as_ref().unwrap().to_string(), "4*u");
/// assert_eq!(along_v.to_string(), "abs(4*u)");
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ParametricSpeed {
    /// `|R_u|²` or `|R_v|²`.
    pub squared: Fraction,
    /// Its square root, if that is a rational function: positive where the domain begins.
    pub root: Option<Fraction>,
    /// Whether the root is certified to be positive on the whole domain, so that it is the parametric speed.
    pub certified: bool,
}

impl ParametricSpeed {
    /// The parametric speeds of a surface along its two families of isoparametric curves.
    #[must_use]
    pub(crate) fn both(
        position: &Vector,
        parameters: &[Variable; 2],
        domain: &[Interval; 2],
    ) -> [ParametricSpeed; 2] {
        parameters.each_ref().map(|parameter| {
            let Some(direction) = Direction::of(&position.derivative(parameter)) else {
                return ParametricSpeed {
                    squared: Fraction::zero(),
                    root: Some(Fraction::zero()),
                    certified: false,
                };
            };
            // |f·N| = |f|·|N|: only the length of the direction needs a root.
            let norm2 = Fraction::from(direction.norm2());
            let squared = (&(&direction.factor * &direction.factor) * &norm2).reduced();
            let root = rational_root(&norm2).ok().map(|length| (&direction.factor * &length).reduced());
            let oriented = root.map(|root| {
                let negative = sample_sign_on_box(&root, parameters, domain).is_lt();
                if negative { -&root } else { root }
            });
            let certified = oriented.as_ref().is_some_and(|root| is_positive(root, parameters, domain));
            ParametricSpeed { squared, root: oriented, certified }
        })
    }
}

/// Whether a rational function is certified to be positive on a box.
fn is_positive(f: &Fraction, parameters: &[Variable; 2], domain: &[Interval; 2]) -> bool {
    let domain: Vec<(Variable, Interval)> = parameters.iter().cloned().zip(domain.iter().cloned()).collect();
    let odd = f.factors().iter().filter(|(_, exponent)| exponent % 2 == 1);
    let signed = odd.fold(f.numerator().clone(), |product, (factor, _)| product * factor);
    matches!(signed.sign_on(&domain), Some(BoxSign::Positive))
}

impl fmt::Display for ParametricSpeed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.root {
            Some(root) if self.certified || root.is_zero() => write!(f, "{root}"),
            Some(root) => write!(f, "abs({root})"),
            None => write!(f, "sqrt({})", self.squared),
        }
    }
}

/// Why a surface has no rational offset.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum OffsetError {
    /// `|R_u × R_v|²` is not a square: `odd` is the product of the factors of odd multiplicity.
    Irrational {
        /// The squarefree factor that is no square.
        odd: Poly,
    },
    /// It is rational, but over the square root of a polynomial in the symbols.
    SymbolicRadical {
        /// That polynomial.
        radicand: Poly,
    },
    /// `R_u × R_v` vanishes identically: a curve or a point has no normal.
    NoSurface,
}

impl fmt::Display for OffsetError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            OffsetError::Irrational { odd } => {
                write!(
                    f,
                    "|R_u x R_v|^2 contains the factor {odd} to an odd power, so its root is not rational"
                )
            }
            OffsetError::SymbolicRadical { radicand } => {
                write!(f, "the offset contains the square root of {radicand}, which depends on the symbols")
            }
            OffsetError::NoSurface => f.write_str(
                "R_u x R_v is zero everywhere: the formula gives a curve or a point, not a surface",
            ),
        }
    }
}

impl std::error::Error for OffsetError {}

impl SweptSurface {
    /// The surface with the given Cartesian coordinates.
    #[must_use]
    pub fn new(position: Vector, parameters: [Variable; 2], domain: [Interval; 2]) -> SweptSurface {
        SweptSurface { position, parameters, domain, homogeneous: OnceCell::new(), normal: OnceCell::new() }
    }

    /// The Cartesian coordinates, as constructed.
    #[must_use]
    pub fn position(&self) -> &Vector {
        &self.position
    }

    /// The two parameters.
    #[must_use]
    pub fn parameters(&self) -> &[Variable; 2] {
        &self.parameters
    }

    /// The intervals of the two parameters.
    #[must_use]
    pub fn domain(&self) -> &[Interval; 2] {
        &self.domain
    }

    /// The unknown constants in it, in their order.
    #[must_use]
    pub fn symbols(&self) -> Vec<Variable> {
        let occurring = self.position.components().iter().flat_map(Fraction::occurring_variables);
        let mut symbols: Vec<Variable> =
            occurring.filter(|variable| !self.parameters.contains(variable)).collect();
        symbols.sort();
        symbols.dedup();
        symbols
    }

    /// The homogeneous coordinates without common factor; the weight at the domain's beginning is rational where it is a
    /// number other than zero.
    pub fn homogeneous(&self) -> &Homogeneous {
        self.homogeneous.get_or_init(|| {
            let [u, v] = self.domain.each_ref().map(Interval::lower);
            Homogeneous::of(&self.position, &self.parameters).with_rational_weight_at(u, v)
        })
    }

    /// The normal.
    ///
    /// # Errors
    /// [`OffsetError::NoSurface`] if `R_u × R_v` vanishes identically.
    pub fn normal(&self) -> Result<&Normal, OffsetError> {
        let normal = self.normal.get_or_init(|| Normal::of(self.homogeneous(), &self.domain));
        normal.as_ref().ok_or(OffsetError::NoSurface)
    }

    /// The parametric speeds `‖R_u‖` along the curves v = const, and `‖R_v‖` along the curves u = const.
    #[must_use]
    pub fn speeds(&self) -> [ParametricSpeed; 2] {
        ParametricSpeed::both(&self.homogeneous().cartesian(), &self.parameters, &self.domain)
    }

    /// The offset surface `R + distance·N` at a signed distance along the unit normal (FN (12)), if it is rational in the
    /// given parameters; a radical may be adjoined.
    ///
    /// # Errors
    /// [`OffsetError`] if it is not.
    pub fn offset(&self, distance: &Fraction) -> Result<SweptSurface, OffsetError> {
        let normal = self.normal()?;
        if normal.is_rational() && !normal.radicand().is_one() {
            return Err(OffsetError::SymbolicRadical { radicand: normal.radicand().clone() });
        }
        let unit = normal
            .unit(&self.parameters, &self.domain)
            .ok_or_else(|| OffsetError::Irrational { odd: normal.split().odd.clone() })?;
        let position = &self.homogeneous().cartesian() + &unit.scale(distance);
        Ok(SweptSurface::new(position, self.parameters.clone(), self.domain.clone()))
    }
}
