//! How far the evaluators' floats may be from the exact values: every allowance, with its reason.
//!
//! Errors are measured in units of 2⁻⁵³ times the size of the quantity: the largest absolute value of its components on
//! the patch (for the homogeneous coordinates, of that coordinate). One unit is half a step between floats of the
//! quantity's size, so that a correctly rounded result has an error of at most 1.

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
    /// Σ b_ij·B_i·B_j, by de Casteljau's scheme.
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
#[must_use]
pub fn allowance(_surface: &str, quantity: Quantity) -> f64 {
    match quantity {
        _ => 1000.0,
    }
}
