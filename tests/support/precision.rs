//! How far the evaluators' floats may be from the exact values: every allowance, with its reason.
//!
//! Errors are measured in units of 2⁻⁵³ times the size of the quantity: the largest absolute value of its components on
//! the patch (for the homogeneous coordinates, of that coordinate). One unit is half a step between floats of the
//! quantity's size, so that a correctly rounded result has an error of at most 1.

use hodograph::{Surface, Variant};

/// What an evaluator computes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Quantity {
    /// W, X, Y, Z.
    Homogeneous,
    /// R.
    Point,
    /// R_u.
    PartialU,
    /// R_v.
    PartialV,
    /// ‖R_u‖.
    SpeedU,
    /// ‖R_v‖.
    SpeedV,
    /// N.
    UnitNormal,
    /// R + r·N.
    OffsetPoint,
    /// W, X, Y, Z from the control net, by de Casteljau's scheme.
    ControlNet,
}

impl Quantity {
    /// All of them, in the order of the table.
    pub const ALL: [Quantity; 9] = [
        Quantity::Homogeneous,
        Quantity::Point,
        Quantity::PartialU,
        Quantity::PartialV,
        Quantity::SpeedU,
        Quantity::SpeedV,
        Quantity::UnitNormal,
        Quantity::OffsetPoint,
        Quantity::ControlNet,
    ];

    /// The name in the table.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Quantity::Homogeneous => "homogeneous",
            Quantity::Point => "point",
            Quantity::PartialU => "partial_u",
            Quantity::PartialV => "partial_v",
            Quantity::SpeedU => "speed_u",
            Quantity::SpeedV => "speed_v",
            Quantity::UnitNormal => "unit_normal",
            Quantity::OffsetPoint => "offset_point",
            Quantity::ControlNet => "control_net",
        }
    }
}

/// The largest error allowed, in units of 2⁻⁵³ times the size of the quantity.
///
/// Each is less than twice what 1000 points of each surface show, so that a loss of one bit is noticed.
#[must_use]
pub fn allowance(quantity: Quantity) -> f64 {
    match quantity {
        // Horner's scheme for degree 9 with rounded coefficients, and two products: the errors of the last steps weigh
        // most, and terms of the position x(v) have both signs.
        Quantity::Homogeneous => 8.0,
        // Two polynomials of degree 5 or less, two quotients by the speed and by the profile's weight, a product, a sum.
        Quantity::Point => 6.0,
        // Squares of the profile's weight and of the speed in the denominators double the relative error of these; along an
        // involute the derivative is a product with the arc length besides.
        Quantity::PartialU | Quantity::PartialV => 16.0,
        // The derivative's errors; the square root halves that of the sum of squares.
        Quantity::SpeedU | Quantity::SpeedV => 16.0,
        // Products of rational functions of u and of v, or a direction divided by its length.
        Quantity::UnitNormal => 6.0,
        // The errors of the point and of the normal, relative to the sum of both, and two roundings.
        Quantity::OffsetPoint => 6.0,
        // Convex combinations alone: as many roundings as degrees, but each of a part of the sum.
        Quantity::ControlNet => 6.0,
    }
}

/// The same for a surface of the catalogue.
#[must_use]
pub fn allowance_on(surface: &dyn Surface, quantity: Quantity) -> f64 {
    let allowed = allowance(quantity);
    let normal =
        surface.bounds().map_or(f64::INFINITY, |bounds| bounds.unit_normal.error::<f64>(Variant::Plain));
    match quantity {
        // Each degree is a step of the scheme; what is allowed is for 9 of them.
        Quantity::ControlNet => allowed * f64::from(surface.degree().1.max(9)) / 9.0,
        // Where the direction of the normal has a zero on the domain there is no bound: relative errors are the larger the
        // nearer it is, and of some 1000 points the nearest is at a hundredth of the domain.
        Quantity::UnitNormal | Quantity::OffsetPoint if normal.is_infinite() => 6.0 * allowed,
        _ => allowed,
    }
}

/// The same for members of families: their coefficients are computed from the parameters with rounding errors of their own.
#[must_use]
pub fn family_allowance(quantity: Quantity) -> f64 {
    2.0 * allowance(quantity)
}
