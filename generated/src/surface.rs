//! The trait of every swept surface.

use crate::float::sqrt;
use crate::grid::{GridError, check_length};
use crate::regularity::Regularity;

/// The rectangle of parameters over which a surface is stated.
///
/// Evaluators accept every `f64`; what is certified of a surface, such as its regularity and the sides of its normal, is
/// certified on its domain. The rectangle is closed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain {
    /// First and last value of u.
    pub u: [f64; 2],
    /// First and last value of v.
    pub v: [f64; 2],
}

impl Domain {
    /// Whether (u, v) lies in the closed rectangle.
    ///
    /// ```
    /// let unit_square = hodograph::Domain { u: [0.0, 1.0], v: [0.0, 1.0] };
    /// assert!(unit_square.contains(0.5, 1.0));
    /// assert!(!unit_square.contains(0.5, f64::NAN));
    /// ```
    #[must_use]
    pub fn contains(&self, u: f64, v: f64) -> bool {
        self.u[0] <= u && u <= self.u[1] && self.v[0] <= v && v <= self.v[1]
    }

    /// The domain's point at the fractions (s, t) of its sides; (0, 0) and (1, 1) are opposite corners exactly.
    ///
    /// ```
    /// let domain = hodograph::Domain { u: [-1.0, 1.0], v: [0.0, 3.0] };
    /// assert_eq!(domain.at(0.5, 1.0), (0.0, 3.0));
    /// ```
    #[must_use]
    pub fn at(&self, s: f64, t: f64) -> (f64, f64) {
        let between = |[first, last]: [f64; 2], t: f64| first * (1.0 - t) + last * t;
        (between(self.u, s), between(self.v, t))
    }
}

/// A rational surface R(u, v) = (X, Y, Z)/W with everything that the catalogue generates for it.
///
/// The trait is object safe, so that callers can hold `&dyn Surface`; generated surfaces have the facts that do not
/// depend on a value (`NAME`, `DEGREE`, `DOMAIN`, …) as constants too.
///
/// Where W = 0 the surface has a pole: [`homogeneous`](Surface::homogeneous) is meaningful there,
/// [`point`](Surface::point) and the derivatives are what IEEE 754 makes of the division, infinite or NaN, and
/// [`unit_normal`](Surface::unit_normal) and [`offset_point`](Surface::offset_point) say that there is none.
pub trait Surface {
    /// The name of the surface in the formula that it was generated from.
    fn name(&self) -> &str;

    /// The patch degree: the largest degrees of W, X, Y and Z in u and in v.
    fn degree(&self) -> (u32, u32);

    /// The rectangle of parameters over which the surface is stated.
    fn domain(&self) -> Domain;

    /// The homogeneous coordinates (W, X, Y, Z) at (u, v).
    fn homogeneous(&self, u: f64, v: f64) -> [f64; 4];

    /// The point R(u, v) = (X/W, Y/W, Z/W).
    fn point(&self, u: f64, v: f64) -> [f64; 3];

    /// The partial derivative R_u = ∂R/∂u at (u, v).
    fn partial_u(&self, u: f64, v: f64) -> [f64; 3];

    /// The partial derivative R_v = ∂R/∂v at (u, v).
    fn partial_v(&self, u: f64, v: f64) -> [f64; 3];

    /// The unit normal of the surface at (u, v): the unit vector of R_u × R_v.
    ///
    /// It is [`Regularity::Singular`] where R_u × R_v, as it is computed, vanishes, and never NaN. On the domain it turns over where the common
    /// factor of the components of R_u × R_v changes its sign; outside of the domain it may continue smoothly instead.
    fn unit_normal(&self, u: f64, v: f64) -> Regularity;

    /// The Bézier control points over [`domain`](Surface::domain), homogeneous (W, X, Y, Z); the index of u is the
    /// outer one, so that with degree (m, n) the point b_ij is `control_net()[i * (n + 1) + j]`.
    fn control_net(&self) -> &[[f64; 4]];

    /// The parametric speed ‖R_u‖ of the curves v = const.
    fn speed_u(&self, u: f64, v: f64) -> f64 {
        norm(self.partial_u(u, v))
    }

    /// The parametric speed ‖R_v‖ of the curves u = const.
    fn speed_v(&self, u: f64, v: f64) -> f64 {
        norm(self.partial_v(u, v))
    }

    /// The point R + r·N of the offset surface at the signed distance `r` along the unit normal.
    ///
    /// It is [`Regularity::Singular`] where the normal is, and where the point is not finite; never NaN.
    fn offset_point(&self, r: f64, u: f64, v: f64) -> Regularity {
        self.unit_normal(u, v).offset(self.point(u, v), r)
    }

    /// Writes R(`us[i]`, `vs[j]`) to `out[j * us.len() + i]`, a row for each v.
    ///
    /// Every point has the bits of [`point`](Surface::point). Nothing is allocated; generated surfaces compute what
    /// depends on one parameter alone once for many points.
    ///
    /// # Errors
    /// [`GridError`] if the length of `out` is not `us.len() * vs.len()`; nothing is written then.
    fn grid(&self, us: &[f64], vs: &[f64], out: &mut [[f64; 3]]) -> Result<(), GridError> {
        check_length(us.len(), vs.len(), out.len())?;
        let parameters = vs.iter().flat_map(|&v| us.iter().map(move |&u| (u, v)));
        for (point, (u, v)) in out.iter_mut().zip(parameters) {
            *point = self.point(u, v);
        }
        Ok(())
    }
}

/// The length √(x² + y² + z²) of a vector.
fn norm([x, y, z]: [f64; 3]) -> f64 {
    sqrt(x * x + y * y + z * z)
}

#[cfg(test)]
mod tests {
    use super::{Domain, Surface};
    use crate::{GridError, Regularity};

    /// The paraboloid (u, v, u² + v²), with a pole nowhere.
    struct Paraboloid;

    impl Surface for Paraboloid {
        fn name(&self) -> &str {
            "paraboloid"
        }
        fn degree(&self) -> (u32, u32) {
            (2, 2)
        }
        fn domain(&self) -> Domain {
            Domain { u: [0.0, 1.0], v: [0.0, 1.0] }
        }
        fn homogeneous(&self, u: f64, v: f64) -> [f64; 4] {
            [1.0, u, v, u * u + v * v]
        }
        fn point(&self, u: f64, v: f64) -> [f64; 3] {
            [u, v, u * u + v * v]
        }
        fn partial_u(&self, u: f64, _: f64) -> [f64; 3] {
            [1.0, 0.0, 2.0 * u]
        }
        fn partial_v(&self, _: f64, v: f64) -> [f64; 3] {
            [0.0, 1.0, 2.0 * v]
        }
        fn unit_normal(&self, u: f64, v: f64) -> Regularity {
            Regularity::unit([-2.0 * u, -2.0 * v, 1.0])
        }
        fn control_net(&self) -> &[[f64; 4]] {
            const NET: [[f64; 4]; 9] = [
                [1.0, 0.0, 0.0, 0.0],
                [1.0, 0.0, 0.5, 0.0],
                [1.0, 0.0, 1.0, 1.0],
                [1.0, 0.5, 0.0, 0.0],
                [1.0, 0.5, 0.5, 0.0],
                [1.0, 0.5, 1.0, 1.0],
                [1.0, 1.0, 0.0, 1.0],
                [1.0, 1.0, 0.5, 1.0],
                [1.0, 1.0, 1.0, 2.0],
            ];
            &NET
        }
    }

    #[test]
    fn surfaces_work_as_trait_objects() {
        let surface: &dyn Surface = &Paraboloid;
        assert_eq!(surface.speed_u(0.0, 7.0), 1.0);
        assert_eq!(surface.offset_point(2.0, 0.0, 0.0), Regularity::Regular([0.0, 0.0, 2.0]));
        assert!(surface.unit_normal(f64::NAN, 0.0).is_singular());
        let (m, n) = surface.degree();
        assert_eq!(surface.control_net().len() as u32, (m + 1) * (n + 1));
    }

    #[test]
    fn provided_grid_writes_points_row_by_row() {
        let (us, vs) = ([0.0, 0.25, 1.0], [0.5, -2.0]);
        let mut out = [[0.0; 3]; 6];
        assert_eq!(Paraboloid.grid(&us, &vs, &mut out), Ok(()));
        assert_eq!(out[3 + 1], Paraboloid.point(0.25, -2.0));
        let wrong = Paraboloid.grid(&us, &vs, &mut out[..5]);
        assert_eq!(wrong, Err(GridError::Length { expected: 6, found: 5 }));
    }
}
