//! The symbols of an item, in the groups in which values are given to them.

use hodograph_algebra::Variable;

/// What the rows of a curve's symbolic coefficients are.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum CoefficientKind {
    /// The real and the imaginary part of a Bernstein coefficient w_j of the preimage of a planar PH curve.
    Preimage,
    /// The components of a Bernstein coefficient A_j of the preimage of a spatial PH curve, a quaternion.
    Quaternion,
    /// The coefficients (x_j, y_j) of the power t^j of a polynomial curve.
    Polynomial,
    /// The coefficients (w_j, x_j, y_j) of the power t^j in the homogeneous coordinates of a rational curve.
    Rational,
}

/// Symbols that a curve has for coefficients, `ph(5)` or `polynomial_curve(2)` for example.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CoefficientGroup {
    /// The name of the curve.
    pub curve: String,
    /// What the coefficients are.
    pub kind: CoefficientKind,
    /// A row for each coefficient.
    pub rows: Vec<Vec<Variable>>,
}
