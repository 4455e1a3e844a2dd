//! What can be evaluated at a point.

use hodograph_algebra::{Poly, SweptSurface, Variable};

use super::place::Place;
use crate::args::Quantity;
use crate::failure::Failure;

impl Quantity {
    /// The names of the components.
    pub(super) fn components(self) -> &'static [&'static str] {
        match self {
            Quantity::Homogeneous => &["W", "X", "Y", "Z"],
            Quantity::SpeedU => &["|R_u|"],
            Quantity::SpeedV => &["|R_v|"],
            _ => &["x", "y", "z"],
        }
    }
}

/// The symbol of the distance that a quantity needs, if it needs one: `r`, or the first of `r1`, `r2`, … that is no symbol
/// of the surface.
pub(super) fn distance(surface: &SweptSurface, what: Quantity) -> Option<Variable> {
    (what == Quantity::Offset).then(|| surface.distance_symbol())
}

/// The components of the quantity, as exact numbers.
///
/// # Errors
/// A pole, or a point without a normal where one is needed.
pub(super) fn evaluate(place: &Place, what: Quantity, distance: Option<&Poly>) -> Result<Vec<Poly>, Failure> {
    // At a pole the homogeneous coordinates are a point at infinity.
    if what != Quantity::Homogeneous {
        place.check_finite()?;
    }
    match what {
        Quantity::Point => place.point(),
        Quantity::Homogeneous => Ok(place.homogeneous().to_vec()),
        Quantity::Normal => normal(place),
        Quantity::UnitNormal => unit_normal(place),
        Quantity::Du => place.derivative(0),
        Quantity::Dv => place.derivative(1),
        Quantity::SpeedU => Ok(vec![length(&place.derivative(0)?)]),
        Quantity::SpeedV => Ok(vec![length(&place.derivative(1)?)]),
        Quantity::Offset => {
            let zero = Poly::zero();
            let distance = distance.unwrap_or(&zero);
            let point = place.point()?;
            Ok(point.iter().zip(unit_normal(place)?).map(|(p, n)| p + distance * n).collect())
        }
    }
}

/// The normal R_u × R_v.
fn normal(place: &Place) -> Result<Vec<Poly>, Failure> {
    let (a, b) = (place.derivative(0)?, place.derivative(1)?);
    let minor = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
    let normal = vec![minor(1, 2), minor(2, 0), minor(0, 1)];
    if normal.iter().all(Poly::is_zero) {
        let at = place.description();
        return Err(Failure::new(format!(
            "the surface is singular at {at}: R_u x R_v = 0, so there is no normal"
        )));
    }
    Ok(normal)
}

fn unit_normal(place: &Place) -> Result<Vec<Poly>, Failure> {
    let normal = normal(place)?;
    let inverse = length(&normal).inverse();
    Ok(normal.iter().map(|component| component * &inverse).collect())
}

fn length(vector: &[Poly]) -> Poly {
    let squared: Poly = vector.iter().map(|component| component * component).sum();
    // A sum of squares of real numbers is not negative.
    squared.sqrt().unwrap_or_else(Poly::zero)
}
