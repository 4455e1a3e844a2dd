//! A surface with everything that is derived from its formula, each part when it is first asked for.

use std::cell::OnceCell;
use std::fmt;

use super::conditions::Conditions;
use super::direction::Direction;
use super::fundamental_forms::FundamentalForms;
use super::homogeneous::Homogeneous;
use super::normal::Normal;
use super::squared_length::SquaredLength;
use crate::geometry::curve::rational_root;
use crate::geometry::sample::sample_sign_on_box;
use crate::{BoxSign, Fraction, Interval, Point, Poly, Variable, Vector, ratio};

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
/// assert_eq!(normal.squared_length().split().odd.to_string(), "u^2 + v^2 + 1");
/// ```
#[derive(Clone, Debug)]
pub struct SweptSurface {
    position: Vector,
    parameters: [Variable; 2],
    domain: [Interval; 2],
    /// Vectors of polynomials without common factor that derivatives may be parallel to.
    directions: Vec<[Poly; 3]>,
    homogeneous: OnceCell<Homogeneous>,
    normal: OnceCell<Option<Normal>>,
    conditions: OnceCell<Conditions>,
    forms: OnceCell<Option<Box<FundamentalForms>>>,
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
    /// The factor f of the derivative `f·N`, whose numerator N has coprime components.
    pub factor: Fraction,
    /// `|N|²`.
    pub length: SquaredLength,
    /// The square root of `f²·|N|²`, if that is a rational function: positive where the domain begins.
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
        directions: &[[Poly; 3]],
    ) -> [ParametricSpeed; 2] {
        parameters.each_ref().map(|parameter| {
            let Some(direction) = Direction::of(&position.derivative(parameter), directions) else {
                let zero = [Poly::zero(), Poly::zero(), Poly::zero()];
                return ParametricSpeed {
                    factor: Fraction::zero(),
                    length: SquaredLength::of(&zero, parameters),
                    root: Some(Fraction::zero()),
                    certified: false,
                };
            };
            // |f·N| = |f|·|N|: only the length of the direction needs a root.
            let length = SquaredLength::of(&direction.numerator, parameters);
            let root = length.expanded().and_then(|square| rational_root(&square.clone().into()).ok());
            let root = root.map(|length| (&direction.factor * &length).reduced());
            let oriented = root.map(|root| {
                let negative = sample_sign_on_box(&root, parameters, domain).is_lt();
                if negative { -&root } else { root }
            });
            let certified = oriented.as_ref().is_some_and(|root| is_positive(root, parameters, domain));
            ParametricSpeed { factor: direction.factor, length, root: oriented, certified }
        })
    }

    /// `|R_u|²` or `|R_v|²`, multiplied out; `None` if that is too large to be of use.
    #[must_use]
    pub fn squared(&self) -> Option<Fraction> {
        let square = self.length.expanded()?;
        let size = self.factor.numerator().terms().len();
        let products = size.saturating_mul(size).saturating_mul(square.terms().len());
        let square = Fraction::from(square.clone());
        (products <= LARGE).then(|| (&(&self.factor * &self.factor) * &square).reduced())
    }
}

/// The number of products of terms up to which the square of a parametric speed is multiplied out.
const LARGE: usize = 1_000_000;

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
            None => match (self.squared(), self.length.expanded()) {
                (Some(squared), _) => write!(f, "sqrt({squared})"),
                (None, Some(square)) => write!(f, "sqrt(({})^2*({square}))", self.factor),
                (None, None) => write!(f, "sqrt(({})^2*({}))", self.factor, self.length.sum_of_squares()),
            },
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
        /// The surface, if the distance is a symbol that does not occur in the surface itself.
        surface: Option<Box<RadicalSurface>>,
    },
    /// `R_u × R_v` vanishes identically: a curve or a point has no normal.
    NoSurface,
}

/// A rational surface over the square root of a polynomial in its symbols.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct RadicalSurface {
    /// The symbol that stands for the positive square root.
    pub radical: Variable,
    /// The Cartesian coordinates, in which `radical` occurs to the power −1 at most.
    pub position: Vector,
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
            OffsetError::SymbolicRadical { radicand, .. } => {
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
        SweptSurface {
            position,
            parameters,
            domain,
            directions: Vec::new(),
            homogeneous: OnceCell::new(),
            normal: OnceCell::new(),
            conditions: OnceCell::new(),
            forms: OnceCell::new(),
        }
    }

    /// The same surface where its derivatives are likely to be parallel to some of these vectors, tangents and normals of the
    /// curves that it is made of. Nothing depends on that but the work: with symbols, the common factor of a derivative's
    /// components can be much larger than its direction.
    #[must_use]
    pub fn with_directions<'a>(self, vectors: impl IntoIterator<Item = &'a Vector>) -> SweptSurface {
        let directions = vectors.into_iter().filter_map(|vector| Direction::of(&vector.reduced(), &[]));
        SweptSurface { directions: directions.map(|direction| direction.numerator).collect(), ..self }
    }

    /// The same surface with these vectors for [`SweptSurface::with_directions`].
    pub(super) fn with_known_directions(self, directions: &[[Poly; 3]]) -> SweptSurface {
        SweptSurface { directions: directions.to_vec(), ..self }
    }

    /// Where the fundamental forms are kept.
    pub(super) fn forms_cell(&self) -> &OnceCell<Option<Box<FundamentalForms>>> {
        &self.forms
    }

    /// The vectors that derivatives may be parallel to.
    pub(crate) fn directions(&self) -> &[[Poly; 3]] {
        &self.directions
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

    /// Where the symbols change the degrees of the homogeneous coordinates.
    pub fn conditions(&self) -> &Conditions {
        self.conditions.get_or_init(|| Conditions::of(self.homogeneous()))
    }

    /// Whether it is a surface: `R_u × R_v` does not vanish identically. Else it is a curve or a point.
    ///
    /// A few points are looked at first, with numbers for the symbols: one with a normal is a proof.
    #[must_use]
    pub fn is_surface(&self) -> bool {
        self.has_normal_at_samples() || self.normal().is_ok()
    }

    /// Whether there is a normal at one of a few points, with numbers for the symbols.
    pub(crate) fn has_normal_at_samples(&self) -> bool {
        (1..=3).any(|seed| self.has_normal_at_sample(seed))
    }

    /// Whether there is a normal at some point, which depends on `seed`, for some values of the symbols.
    fn has_normal_at_sample(&self, seed: i64) -> bool {
        let number = |index: i64| Poly::constant(ratio(3 * index + seed + 1, index + 2 * seed));
        let symbols: Point = self.symbols().into_iter().zip((3..).map(number)).collect();
        let point: Point = self.parameters.iter().cloned().zip((1..).map(number)).collect();
        let derivatives = |component: &Fraction| -> Option<[Poly; 2]> {
            let numerator = component.numerator().evaluate(&symbols);
            let denominator: Poly =
                component.factors().iter().map(|(factor, e)| factor.evaluate(&symbols).pow(*e)).product();
            let at = |poly: &Poly| poly.evaluate(&point);
            let below = at(&denominator);
            // (n/d)' = (n'd − nd')/d²
            (!below.is_zero()).then(|| {
                let scale = (&below * &below).inverse();
                self.parameters.each_ref().map(|by| {
                    let upper = at(&numerator.derivative(by)) * &below;
                    (upper - at(&numerator) * at(&denominator.derivative(by))) * &scale
                })
            })
        };
        let [x, y, z] = self.position.components().each_ref().map(derivatives);
        let (Some(x), Some(y), Some(z)) = (x, y, z) else { return false };
        let minor = |a: &[Poly; 2], b: &[Poly; 2]| &a[0] * &b[1] - &a[1] * &b[0];
        [minor(&x, &y), minor(&y, &z), minor(&z, &x)].iter().any(|minor| !minor.is_zero())
    }

    /// The normal.
    ///
    /// # Errors
    /// [`OffsetError::NoSurface`] if `R_u × R_v` vanishes identically.
    pub fn normal(&self) -> Result<&Normal, OffsetError> {
        let normal = self.normal.get_or_init(|| {
            let normal = Normal::of(&self.position, &self.parameters, &self.domain, &self.directions)?;
            // Where the coordinates lost a factor, those that the formula is written with are not the ones that are left.
            let is_reduced = self.homogeneous().common_factor().is_constant();
            Some(if is_reduced { normal } else { normal.in_lowest_terms() })
        });
        normal.as_ref().ok_or(OffsetError::NoSurface)
    }

    /// The parametric speeds `‖R_u‖` along the curves v = const, and `‖R_v‖` along the curves u = const.
    #[must_use]
    pub fn speeds(&self) -> [ParametricSpeed; 2] {
        ParametricSpeed::both(
            &self.homogeneous().cartesian(),
            &self.parameters,
            &self.domain,
            &self.directions,
        )
    }

    /// The offset `R + r·N/(length·ρ)` with a symbol ρ for the square root of the radicand in the symbols, if the distance
    /// is another symbol.
    ///
    /// Since r does not occur in W, a common factor of the coordinates divides both parts of each, neither of which contains
    /// ρ: so the gcd with ρ as one more variable is right.
    fn offset_over_radical(&self, normal: &Normal, distance: &Fraction) -> Option<RadicalSurface> {
        let symbols = self.symbols();
        let plain = distance.occurring_variables();
        let [symbol] = plain.as_slice() else { return None };
        if *distance != Poly::variable(symbol).into()
            || symbols.contains(symbol)
            || self.parameters.contains(symbol)
        {
            return None;
        }
        let radical = unused("rho", symbols.iter().chain([symbol]));
        let split = normal.squared_length().split();
        let length = &split.root * split.unit.sqrt()?;
        let negative = sample_sign_on_box(&length.clone().into(), &self.parameters, &self.domain).is_lt();
        let length = if negative { -length } else { length }.squarefree();
        let factors = length.factors.into_iter().chain([(Poly::variable(&radical), 1)]);
        let inverse = Fraction::new(length.unit.inverse(), factors);
        let [x, y, z] = normal.numerator().each_ref().map(|component| Fraction::from(component.clone()));
        let unit = Vector::new(x, y, z).scale(&inverse).reduced();
        let position = &self.homogeneous().cartesian() + &unit.scale(distance);
        Some(RadicalSurface { radical, position })
    }

    /// The offset surface `R + distance·N` at a signed distance along the unit normal (FN (12)), if it is rational in the
    /// given parameters; a radical may be adjoined. At the distance zero it is the surface itself.
    ///
    /// # Errors
    /// [`OffsetError`] if it is not.
    pub fn offset(&self, distance: &Fraction) -> Result<SweptSurface, OffsetError> {
        if distance.is_zero() && self.is_surface() {
            return Ok(self.clone());
        }
        let normal = self.normal()?;
        let squared = normal.squared_length();
        if normal.is_rational() && !squared.radicand().is_one() {
            return Err(OffsetError::SymbolicRadical {
                radicand: squared.radicand().clone(),
                surface: self.offset_over_radical(normal, distance).map(Box::new),
            });
        }
        let unit = normal
            .unit(&self.parameters, &self.domain)
            .ok_or_else(|| OffsetError::Irrational { odd: squared.split().odd.clone() })?;
        let position = &self.homogeneous().cartesian() + &unit.scale(distance);
        let surface = SweptSurface::new(position, self.parameters.clone(), self.domain.clone());
        Ok(surface.with_known_directions(&self.directions))
    }
}

/// The symbol `name`, or the first of `name1`, `name2`, … that is not taken.
pub(crate) fn unused<'a>(name: &str, taken: impl Iterator<Item = &'a Variable> + Clone) -> Variable {
    let numbered = (1..).map(|number| format!("{name}{number}"));
    let mut names = std::iter::once(name.to_owned()).chain(numbered);
    let free = names.find(|name| !taken.clone().any(|symbol| symbol.name() == name));
    Variable::new(Variable::SYMBOL, &free.unwrap_or_default())
}
