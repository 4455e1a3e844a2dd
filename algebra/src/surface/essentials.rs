//! What an evaluator needs of a surface.

use super::homogeneous::Homogeneous;
use super::normal::Normal;
use super::swept::{OffsetError, SweptSurface};
use crate::{BoxSign, Fraction, Interval, Poly, Rational, Variable, budget, minimize_field, ratio};

/// The part of a [`crate::Derivation`] that an evaluator needs: coordinates and normal, over one number field.
///
/// # Example
/// ```
/// use hodograph_algebra::{Fraction, Interval, Poly, SweptSurface, Variable, Vector};
/// let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
/// let [u, v] = parameters.each_ref().map(|parameter| Fraction::from(Poly::variable(parameter)));
/// let height = &(&u * &u) + &(&v * &v);
/// let domain = [Interval::unit(), Interval::unit()];
/// let essentials = SweptSurface::new(Vector::new(u, v, height), parameters, domain).essentials().unwrap();
/// assert_eq!(essentials.homogeneous.to_string(), "(1, u, v, u^2 + v^2)");
/// assert!(essentials.orientation.is_none());
/// ```
#[derive(Clone, Debug)]
pub struct Essentials {
    /// The two parameters.
    pub parameters: [Variable; 2],
    /// The unknown constants, in their order.
    pub symbols: Vec<Variable>,
    /// The intervals of the parameters.
    pub domain: [Interval; 2],
    /// The homogeneous coordinates.
    pub homogeneous: Homogeneous,
    /// The normal; `None` where symbols make it so large that an evaluator had better take the product of the derivatives.
    pub normal: Option<Normal>,
    /// The polynomial that is positive where the numerator N of the normal points the way of `R_u × R_v`; `None` where
    /// that is certified for the whole domain, and without a normal.
    pub orientation: Option<Poly>,
}

impl SweptSurface {
    /// Derives what an evaluator needs.
    ///
    /// # Errors
    /// [`OffsetError::NoSurface`] if the formula gives a curve or a point.
    pub fn essentials(&self) -> Result<Essentials, OffsetError> {
        let homogeneous = budget::doing("the homogeneous coordinates", || self.homogeneous());
        let terms: usize = homogeneous.coordinates().iter().map(|poly| poly.terms().len()).sum();
        let normal = if self.symbols().is_empty() {
            let normal = budget::doing("the normal", || self.normal())?;
            // Known before the visit below: the unit normal may need a further root.
            let _ = normal.squared_length();
            Some(normal)
        } else if terms <= LARGE {
            let normal = budget::doing("the normal", || self.normal())?;
            let size: usize = normal.numerator().iter().map(|component| component.terms().len()).sum();
            (size <= LARGE_NORMAL).then_some(normal)
        } else {
            if !self.has_normal_at_samples() {
                budget::doing("the normal of a member", || self.member(homogeneous).normal().map(|_| ()))?;
            }
            None
        };
        // One field for both: what the visit collects is minimized, and given back in the same order.
        let mut all = Vec::new();
        homogeneous.visit(|poly| all.push(poly.clone()));
        if let Some(normal) = normal {
            normal.visit(|poly| all.push(poly.clone()));
        }
        let mut minimized = minimize_field(&all).into_iter();
        let mut replace = |_: &Poly| minimized.next().unwrap_or_else(Poly::zero);
        let homogeneous = homogeneous.map(&mut replace);
        let normal = normal.map(|normal| normal.map(&mut replace));
        let region: Vec<(Variable, Interval)> =
            self.parameters().iter().cloned().zip(self.domain().iter().cloned()).collect();
        let uncertain = |orientation: &Poly| !matches!(orientation.sign_on(&region), Some(BoxSign::Positive));
        let orientation = normal.as_ref().map(Normal::orientation).filter(uncertain);
        Ok(Essentials {
            parameters: self.parameters().clone(),
            symbols: self.symbols(),
            domain: self.domain().clone(),
            homogeneous,
            normal,
            orientation,
        })
    }

    /// The surface with numbers for its symbols.
    fn member(&self, homogeneous: &Homogeneous) -> SweptSurface {
        let values: Vec<Rational> =
            (0..).map(|k| ratio(7 + 3 * k % 11, 5)).take(self.symbols().len()).collect();
        let symbols = self.symbols();
        let point: Vec<(&Variable, &Rational)> = symbols.iter().zip(&values).collect();
        let position = homogeneous.cartesian().map(|coordinate| {
            let factors =
                coordinate.factors().iter().map(|(factor, exponent)| (factor.at(&point), *exponent));
            Fraction::new(coordinate.numerator().at(&point), factors)
        });
        SweptSurface::new(position, self.parameters().clone(), self.domain().clone())
    }
}

/// The number of terms of the homogeneous coordinates beyond which the normal of a family is not derived for an evaluator:
/// those of the translations and involutes along PH quintics have some 1300, and their normals some 150; those of the conical
/// sweeps have 10 000, and their normals 60 000.
const LARGE: usize = 3000;

/// The number of terms of a family's normal beyond which an evaluator had better take the product of the derivatives: it costs
/// less then, and has smaller rounding errors.
const LARGE_NORMAL: usize = 600;
