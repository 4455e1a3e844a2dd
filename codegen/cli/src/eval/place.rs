//! A point of the parameter plane of a surface without symbols.

use std::collections::BTreeMap;

use hodograph_algebra::{Fraction, Poly, SweptSurface, Variable, Vector};

use crate::failure::Failure;
use crate::radical;

/// A surface without symbols, and a point of its parameter plane.
pub(super) struct Place {
    surface: SweptSurface,
    cartesian: Vector,
    values: BTreeMap<Variable, Poly>,
    fractions: BTreeMap<Variable, Fraction>,
}

impl Place {
    /// The place of a surface without symbols with these values of the parameters.
    pub(super) fn new(surface: &SweptSurface, parameters: &[Poly; 2]) -> Place {
        let surface = surface.clone();
        let names = surface.parameters().iter().cloned();
        let values: BTreeMap<Variable, Poly> = names.zip(parameters.iter().cloned()).collect();
        let fractions = values.iter().map(|(name, value)| (name.clone(), value.clone().into())).collect();
        let cartesian = surface.homogeneous().cartesian();
        Place { surface, cartesian, values, fractions }
    }

    /// Checks that the surface has a point here.
    ///
    /// # Errors
    /// A pole, or a point where all homogeneous coordinates vanish.
    pub(super) fn check_finite(&self) -> Result<(), Failure> {
        let [weight, coordinates @ ..] = self.homogeneous();
        if !weight.is_zero() {
            return Ok(());
        }
        let at = self.description();
        Err(if coordinates.iter().all(Poly::is_zero) {
            Failure::new(format!(
                "W, X, Y and Z all vanish at {at}, so the surface has no definite point there"
            ))
        } else {
            Failure::new(format!("the surface has a pole at {at}: W = 0"))
        })
    }

    /// The homogeneous coordinates.
    pub(super) fn homogeneous(&self) -> [Poly; 4] {
        self.surface.homogeneous().coordinates().each_ref().map(|coordinate| self.poly(coordinate))
    }

    /// The value of a polynomial in the parameters.
    fn poly(&self, poly: &Poly) -> Poly {
        poly.evaluate(&self.values)
    }

    /// The value of a rational function of the parameters; `None` at its poles.
    fn fraction(&self, fraction: &Fraction) -> Option<Poly> {
        fraction.substitute(&self.fractions)?.to_number()
    }

    /// The point of the surface.
    ///
    /// # Errors
    /// As [`Place::vector`].
    pub(super) fn point(&self) -> Result<Vec<Poly>, Failure> {
        self.vector(&self.cartesian)
    }

    /// The derivative of the surface by the parameter at `index`, at the point.
    ///
    /// # Errors
    /// As [`Place::vector`].
    pub(super) fn derivative(&self, index: usize) -> Result<Vec<Poly>, Failure> {
        self.vector(&self.cartesian.derivative(&self.surface.parameters()[index]))
    }

    /// The value of a vector of rational functions.
    ///
    /// # Errors
    /// A pole.
    fn vector(&self, vector: &Vector) -> Result<Vec<Poly>, Failure> {
        let components: Option<Vec<Poly>> = vector.components().iter().map(|f| self.fraction(f)).collect();
        components.ok_or_else(|| Failure::new(format!("the surface has a pole at {}", self.description())))
    }

    /// The point as `u = 1/2, v = 0`.
    pub(super) fn description(&self) -> String {
        let equation =
            |(name, value): (&Variable, &Poly)| format!("{name} = {}", radical::written_one(value));
        self.values.iter().map(equation).collect::<Vec<_>>().join(", ")
    }
}
