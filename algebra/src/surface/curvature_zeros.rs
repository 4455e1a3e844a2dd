//! Where the curvatures of a surface vanish.

use std::fmt;

use super::fundamental_forms::FundamentalForms;
use super::singular;
use crate::{Interval, Poly, Variable, ZeroSet};

/// Where a curvature vanishes on the domain: there similarity offsets whose distance it divides have poles, `H/K` for the Gaussian
/// and `1/H` for the mean curvature.
///
/// # Example
/// The torus-like surface `z = u³ + v²` has parabolic points along u = 0; its mean curvature vanishes along a curve.
/// ```
/// use hodograph_algebra::{Fraction, Interval, Poly, SweptSurface, Variable, Vector};
/// let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
/// let [u, v] = parameters.each_ref().map(|p| Fraction::from(Poly::variable(p)));
/// let graph = Vector::new(u.clone(), v.clone(), &u.pow(3) + &v.pow(2));
/// let around = || Interval::new(Poly::integer(-1), Poly::integer(1)).unwrap();
/// let surface = SweptSurface::new(graph, parameters, [around(), around()]);
/// let forms = surface.forms().unwrap();
/// assert_eq!(forms.gaussian_zeros().to_string(), "where u = 0");
/// assert_eq!(forms.mean_zeros().to_string(), "where 9*u^4 + 12*u*v^2 + 3*u + 1 = 0");
/// ```
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum CurvatureZeros {
    /// On the whole surface: it is developable, or minimal.
    Everywhere,
    /// At these points of the domain, besides points where the surface has no normal.
    At(ZeroSet),
    /// Symbols decide, or the zeros need more than their share of the budget.
    Undetermined,
}

impl CurvatureZeros {
    fn of(numerator: &Poly, domain: &[(Variable, Interval)]) -> CurvatureZeros {
        if numerator.is_zero() {
            return CurvatureZeros::Everywhere;
        }
        singular::zeros(&numerator.primitive(), domain)
            .map_or(CurvatureZeros::Undetermined, CurvatureZeros::At)
    }
}

impl fmt::Display for CurvatureZeros {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CurvatureZeros::Everywhere => f.write_str("everywhere"),
            CurvatureZeros::At(zeros) if zeros.is_empty() => f.write_str("nowhere on the domain"),
            CurvatureZeros::At(zeros) => write!(f, "where {zeros}"),
            CurvatureZeros::Undetermined => {
                f.write_str("undetermined: it depends on symbols, or needs more than its budget")
            }
        }
    }
}

impl FundamentalForms {
    /// Where the Gaussian curvature vanishes: parabolic and planar points, the zeros of `[N N_u N_v]`.
    #[must_use]
    pub fn gaussian_zeros(&self) -> CurvatureZeros {
        CurvatureZeros::of(self.gaussian_numerator(), &self.region())
    }

    /// Where the mean curvature vanishes: the zeros of `[N R_v N_u] − [N R_u N_v]`.
    #[must_use]
    pub fn mean_zeros(&self) -> CurvatureZeros {
        CurvatureZeros::of(&self.mean_numerator(), &self.region())
    }
}
