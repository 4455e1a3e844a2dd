//! The rational Bézier form of a surface.

use super::homogeneous::Homogeneous;
use crate::{Bernstein, Interval, Poly, Variable};

/// The control points and weights of a rational surface over a box of parameters, in homogeneous coordinates:
/// `(W, X, Y, Z)(u, v) = Σᵢ Σⱼ points[i][j] · Bᵢᵐ(u) · Bⱼⁿ(v)` for the patch degree `(m, n)` and the Bernstein polynomials of the
/// domain's intervals.
///
/// # Example
/// ```
/// use hodograph_algebra::{ControlNet, Fraction, Homogeneous, Interval, Poly, Variable, Vector};
/// let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
/// let [u, v] = parameters.each_ref().map(|p| Fraction::from(Poly::variable(p)));
/// let saddle = Homogeneous::of(&Vector::new(u.clone(), v.clone(), &u * &v), &parameters);
/// let net = ControlNet::of(&saddle, &[Interval::unit(), Interval::unit()]);
/// assert_eq!(net.degree, [1, 1]);
/// assert_eq!(net.points[1][1].each_ref().map(ToString::to_string), ["1", "1", "1", "1"]);
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ControlNet {
    /// The degrees in both parameters.
    pub degree: [u32; 2],
    /// Rows by the index of the first parameter, in each one homogeneous point for each index of the second.
    pub points: Vec<Vec<[Poly; 4]>>,
}

impl ControlNet {
    /// The net of a surface over `domain`.
    #[must_use]
    pub fn of(surface: &Homogeneous, domain: &[Interval; 2]) -> ControlNet {
        let patch = surface.degree();
        // The weight is not zero, so no degree is negative.
        let degree = [patch.u, patch.v].map(|d| u32::try_from(d).unwrap_or(0));
        let parameters = surface.parameters();
        let domain: Vec<(Variable, Interval)> =
            parameters.iter().cloned().zip(domain.iter().cloned()).collect();
        let forms =
            surface.coordinates().each_ref().map(|coordinate| coefficients(coordinate, &domain, degree));
        let columns = degree[1] as usize + 1;
        let point = |index: usize| forms.each_ref().map(|form| form[index].clone());
        let row = |i: usize| (0..columns).map(|j| point(i * columns + j)).collect();
        ControlNet { degree, points: (0..=degree[0] as usize).map(row).collect() }
    }

    /// The net with `map` applied to every number.
    pub(crate) fn map(&self, mut map: impl FnMut(&Poly) -> Poly) -> ControlNet {
        let mut row = |row: &Vec<[Poly; 4]>| row.iter().map(|point| point.each_ref().map(&mut map)).collect();
        ControlNet { degree: self.degree, points: self.points.iter().map(&mut row).collect() }
    }
}

fn coefficients(poly: &Poly, domain: &[(Variable, Interval)], degree: [u32; 2]) -> Vec<Poly> {
    let size = (degree[0] as usize + 1) * (degree[1] as usize + 1);
    // The degree is that of the patch, so no coordinate exceeds it.
    let form = Bernstein::with_degrees(poly, domain, &degree);
    form.map_or_else(|| vec![Poly::zero(); size], |form| form.coefficients().to_vec())
}
