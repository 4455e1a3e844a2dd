//! Everything that is derived from the formula of a surface, over one number field.

use std::sync::Arc;

use super::control_net::ControlNet;
use super::homogeneous::Homogeneous;
use super::normal::Normal;
use super::singular::{self, SingularLocus};
use super::swept::{OffsetError, ParametricSpeed, RadicalSurface, SweptSurface, unused};
use crate::budget::Exhausted;
use crate::number::field;
use crate::{BoxSign, Interval, NumberField, Poly, Variable, ZeroSet, budget, minimize_field};

/// What follows from the formula of a surface: coordinates, degrees, normal, speeds, singular locus, offset, control net.
///
/// All polynomials are over [`Derivation::field`], which has no generator that none of them needs as far as
/// [`minimize_field`] finds.
///
/// # Example
/// The paraboloid `z = u² + v²`:
/// ```
/// use hodograph_algebra::{Fraction, Interval, Poly, SweptSurface, Variable, Vector};
/// let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
/// let [u, v] = parameters.each_ref().map(|parameter| Fraction::from(Poly::variable(parameter)));
/// let height = &(&u * &u) + &(&v * &v);
/// let domain = [Interval::unit(), Interval::unit()];
/// let derivation = SweptSurface::new(Vector::new(u, v, height), parameters, domain).derive().unwrap();
/// assert_eq!(derivation.homogeneous.to_string(), "(1, u, v, u^2 + v^2)");
/// assert_eq!(derivation.control_net.unwrap().degree, [2, 2]);
/// let geometry = derivation.geometry.unwrap();
/// assert_eq!(geometry.speeds[0].to_string(), "sqrt(4*u^2 + 1)");
/// assert!(geometry.singular.is_regular() && !geometry.offset.is_rational());
/// ```
#[derive(Clone, Debug)]
pub struct Derivation {
    /// The number field of all coefficients.
    pub field: Arc<NumberField>,
    /// The two parameters.
    pub parameters: [Variable; 2],
    /// The unknown constants, in their order.
    pub symbols: Vec<Variable>,
    /// The intervals of the parameters.
    pub domain: [Interval; 2],
    /// The homogeneous coordinates.
    pub homogeneous: Homogeneous,
    /// What derivatives tell of the surface; the error if that needs more than the budget leaves to it, which the coordinates of
    /// one further construction upon another soon do.
    pub geometry: Result<DifferentialGeometry, Exhausted>,
    /// The symbol for the distance of the offset.
    pub distance: Variable,
    /// Where the weight W vanishes on the domain, so that the surface has poles; `None` where symbols decide, or the poles
    /// need more than their share of the budget.
    pub poles: Option<ZeroSet>,
    /// The control points over the domain; the error if the budget does not suffice for them.
    pub control_net: Result<ControlNet, Exhausted>,
}

/// What derivatives tell of a surface: normal, parametric speeds, singular locus and offset.
///
/// # Example
/// The cylinder over the unit circle, at the distance `r`:
/// ```
/// use hodograph_algebra::{Fraction, Interval, Offset, Poly, SweptSurface, Variable, Vector};
/// let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
/// let [u, v] = parameters.each_ref().map(|parameter| Fraction::from(Poly::variable(parameter)));
/// let square = &u * &u;
/// let weight = &Fraction::one() + &square;
/// let x = (&Fraction::one() - &square).checked_div(&weight).unwrap();
/// let y = (&u + &u).checked_div(&weight).unwrap();
/// let domain = [Interval::unit(), Interval::unit()];
/// let derivation = SweptSurface::new(Vector::new(x, y, v), parameters, domain).derive().unwrap();
/// let geometry = derivation.geometry.unwrap();
/// assert!(geometry.singular.is_regular());
/// let Offset::Rational(offset) = geometry.offset else { unreachable!("the unit normal is (x, y, 0)") };
/// assert_eq!(offset.to_string(), "(u^2 + 1, -r*u^2 - u^2 + r + 1, 2*r*u + 2*u, u^2*v + v)");
/// ```
#[derive(Clone, Debug)]
pub struct DifferentialGeometry {
    /// The normal.
    pub normal: Normal,
    /// The parametric speeds `‖R_u‖` and `‖R_v‖`.
    pub speeds: [ParametricSpeed; 2],
    /// Where there is no normal.
    pub singular: SingularLocus,
    /// The zeros of the singular locus on the domain, one text each.
    pub singular_zeros: Vec<String>,
    /// The offset surface at the distance [`Derivation::distance`].
    pub offset: Offset,
    /// The polynomial that is positive where the unit normal `N/|N|` points the way of `R_u × R_v`; `None` where that is
    /// certified for the whole domain. Beyond its zeros the offset at the distance `r` is the one at `−r`.
    pub orientation: Option<Poly>,
}

/// The offset surface at a symbolic distance.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Offset {
    /// It is rational in the given parameters, over the real numbers.
    Rational(Box<Homogeneous>),
    /// It is rational for all values of the symbols, but over a square root of `radicand`, which depends on them.
    SymbolicRadical {
        /// The polynomial in the symbols under the root.
        radicand: Poly,
        /// The symbol for the square root in `surface`.
        radical: Variable,
        /// The homogeneous coordinates, polynomials of degree 1 in `radical`.
        surface: Box<Homogeneous>,
    },
    /// It is not rational in the given parameters.
    Irrational {
        /// The factor of `|R_u × R_v|²` that is no square.
        odd: Poly,
    },
}

impl Offset {
    /// Whether it is rational in the given parameters, over the real numbers.
    #[must_use]
    pub fn is_rational(&self) -> bool {
        !matches!(self, Offset::Irrational { .. })
    }
}

impl SweptSurface {
    /// Derives everything. What the budget does not suffice for is left out, after the homogeneous coordinates: what derivatives tell,
    /// for which there are seven eighths of what is left, and the control net.
    ///
    /// # Errors
    /// [`OffsetError::NoSurface`] if the formula gives a curve or a point.
    pub fn derive(&self) -> Result<Derivation, OffsetError> {
        let parameters = self.parameters().clone();
        let domain = self.domain().clone();
        let symbols = self.symbols();
        let distance = self.distance_symbol();
        let homogeneous = budget::doing("the homogeneous coordinates", || self.homogeneous());
        let share = budget::left() / PARTS * (PARTS - 1);
        let geometry = budget::with_budget(share, || self.geometry(homogeneous, &distance));
        let (mut field, homogeneous, geometry) = match geometry {
            Ok(Ok((field, homogeneous, geometry))) => (field, homogeneous, Ok(geometry)),
            Ok(Err(error)) => return Err(error),
            Err(exhausted) => {
                let mut all = Vec::new();
                homogeneous.visit(|poly| all.push(poly.clone()));
                let (field, mut next) = in_one_field(&all);
                (
                    field,
                    homogeneous.map(&mut |_: &Poly| next.next().unwrap_or_else(Poly::zero)),
                    Err(exhausted),
                )
            }
        };
        let region: Vec<(Variable, Interval)> =
            parameters.iter().cloned().zip(domain.iter().cloned()).collect();
        // What has been derived is not to be lost with the zeros of one polynomial.
        let poles = budget::doing("the poles", || singular::zeros(&homogeneous.coordinates()[0], &region));
        let control_net = budget::with_budget(budget::left(), || {
            let net = budget::doing("the control net", || ControlNet::of(&homogeneous, &domain));
            net.map(|number| into_field(number, &mut field))
        });
        Ok(Derivation {
            field,
            parameters,
            symbols,
            domain,
            homogeneous,
            geometry,
            distance,
            poles,
            control_net,
        })
    }

    /// What derivatives tell, with the homogeneous coordinates over the same field.
    fn geometry(
        &self,
        homogeneous: &Homogeneous,
        distance: &Variable,
    ) -> Result<(Arc<NumberField>, Homogeneous, DifferentialGeometry), OffsetError> {
        let (parameters, domain) = (self.parameters(), self.domain());
        let normal = budget::doing("the normal", || self.normal())?;
        let offset = budget::doing("the offset", || self.offset(&Poly::variable(distance).into()));
        let (offset, radical) = match offset {
            Ok(surface) => (Ok(surface.homogeneous().clone()), None),
            Err(OffsetError::SymbolicRadical { surface: Some(surface), .. }) => {
                let RadicalSurface { radical, position } = *surface;
                (Ok(Homogeneous::of(&position, parameters)), Some(radical))
            }
            Err(error) => (Err(error), None),
        };

        let mut all = Vec::new();
        homogeneous.visit(|poly| all.push(poly.clone()));
        normal.visit(|poly| all.push(poly.clone()));
        if let Ok(offset) = &offset {
            offset.visit(|poly| all.push(poly.clone()));
        }
        let (mut field, mut next) = in_one_field(&all);
        let mut replace = |_: &Poly| next.next().unwrap_or_else(Poly::zero);
        let homogeneous = homogeneous.map(&mut replace);
        let normal = normal.map(&mut replace);
        let squared = normal.squared_length();
        let offset = match (offset, radical) {
            (Ok(offset), None) => Offset::Rational(Box::new(offset.map(&mut replace))),
            (Ok(offset), Some(radical)) => Offset::SymbolicRadical {
                radicand: squared.radicand().clone(),
                radical,
                surface: Box::new(offset.map(&mut replace)),
            },
            (Err(_), _) => Offset::Irrational { odd: squared.split().odd.clone() },
        };

        let position = homogeneous.cartesian();
        let speeds = budget::doing("the parametric speeds", || {
            ParametricSpeed::both(&position, parameters, domain, self.directions())
        });
        let speeds = speeds.map(|speed| {
            let root = speed.root.as_ref().map(|root| root.map(|poly| into_field(poly, &mut field)));
            ParametricSpeed { root, ..speed }
        });
        let weight = &homogeneous.coordinates()[0];
        let singular =
            budget::doing("the singular locus", || SingularLocus::of(&normal, weight, parameters, domain));
        let singular_zeros = singular.descriptions(|number| into_field(number, &mut field));
        let region: Vec<(Variable, Interval)> =
            parameters.iter().cloned().zip(domain.iter().cloned()).collect();
        let positive = |poly: &Poly| {
            let sign = budget::with_budget(singular::BUDGET, || poly.sign_on(&region));
            matches!(sign, Ok(Some(BoxSign::Positive)))
        };
        let orientation = normal.orientation();
        let oriented = budget::doing("the orientation of the normal", || positive(&orientation));
        let orientation = (!oriented).then_some(orientation);
        let geometry = DifferentialGeometry { normal, speeds, singular, singular_zeros, offset, orientation };
        Ok((field, homogeneous, geometry))
    }

    /// The symbol for the distance of an offset: `r`, or the first of `r1`, `r2`, … if the surface has a symbol of this
    /// name.
    #[must_use]
    pub fn distance_symbol(&self) -> Variable {
        unused("r", self.symbols().iter())
    }
}

/// All but one of these parts of the budget that is left may go into what derivatives tell: the rest suffices for the control net.
const PARTS: u64 = 8;

/// All polynomials over one field, with the fewest generators, in the same order.
fn in_one_field(all: &[Poly]) -> (Arc<NumberField>, impl Iterator<Item = Poly>) {
    let minimized = budget::doing("the number field", || minimize_field(all));
    let field = minimized.first().map_or_else(NumberField::rationals, |poly| poly.ring().field().clone());
    (field, minimized.into_iter())
}

/// The polynomial over `field`, which grows where it must.
fn into_field(poly: &Poly, field: &mut Arc<NumberField>) -> Poly {
    let (joined, images) = field::join(field, poly.ring().field());
    *field = joined;
    images.map_or_else(|| poly.clone(), |images| poly.map_generators(field, &images))
}
