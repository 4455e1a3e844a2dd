//! Where the curvatures of a surface vanish.

use std::fmt;

use super::fundamental_forms::FundamentalForms;
use super::singular;
use crate::{Fraction, Interval, Poly, Variable, ZeroSet, budget};

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
/// The sphere has none, although its formula may have no normal at a pole:
/// ```
/// # use hodograph_algebra::{Fraction, Interval, Poly, SweptSurface, Variable, Vector, integer};
/// # let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
/// # let [u, v] = parameters.each_ref().map(|p| Fraction::from(Poly::variable(p)));
/// let one = Fraction::one();
/// let circle = |t: &Fraction| {
///     let over = (&one + &t.pow(2)).reciprocal(&[]).unwrap();
///     [&(&one - &t.pow(2)) * &over, &t.scale(&integer(2)) * &over]
/// };
/// let ([height, radius], [x, y]) = (circle(&u), circle(&v));
/// let sphere = Vector::new(&radius * &x, &radius * &y, height);
/// let sphere = SweptSurface::new(sphere, parameters, [Interval::unit(), Interval::unit()]);
/// assert_eq!(sphere.normal().unwrap().factor().lowest_terms().numerator().primitive().to_string(), "u");
/// assert_eq!(sphere.forms().unwrap().gaussian_zeros().to_string(), "nowhere on the domain");
/// assert_eq!(sphere.forms().unwrap().mean_zeros().to_string(), "nowhere on the domain");
/// ```
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum CurvatureZeros {
    /// On the whole surface: it is developable, or minimal.
    Everywhere,
    /// At these points of the domain, but for poles. Where the surface has no normal, a curve is one of them if the curvature tends to zero
    /// there, and isolated points are left out.
    At(ZeroSet),
    /// Symbols decide, or the zeros need more than their share of the budget.
    Undetermined,
}

impl CurvatureZeros {
    /// Those of a fraction that is a multiple of the curvature, on a surface with this weight.
    fn of(curvature: &Fraction, weight: &Poly, domain: &[(Variable, Interval)]) -> CurvatureZeros {
        let zeros = budget::with_budget(singular::BUDGET, || {
            let curvature = curvature.lowest_terms();
            let finite = singular::without_factors_of(curvature.numerator().primitive(), weight)?;
            let zeros = finite.zeros_on(domain)?.without_zeros_of(weight);
            let factors = curvature.factors().iter();
            Some(factors.fold(zeros, |zeros, (factor, _)| zeros.without_zeros_of(factor)))
        });
        zeros.ok().flatten().map_or(CurvatureZeros::Undetermined, CurvatureZeros::At)
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
    /// Where the Gaussian curvature vanishes: parabolic and planar points.
    #[must_use]
    pub fn gaussian_zeros(&self) -> CurvatureZeros {
        self.zeros(0)
    }

    /// Where the mean curvature vanishes.
    #[must_use]
    pub fn mean_zeros(&self) -> CurvatureZeros {
        self.zeros(1)
    }

    fn zeros(&self, place: usize) -> CurvatureZeros {
        if self.are_zero()[place] {
            return CurvatureZeros::Everywhere;
        }
        match self.curvatures() {
            Ok(curvatures) => CurvatureZeros::of(&curvatures[place], self.weight(), &self.region()),
            Err(_) => CurvatureZeros::Undetermined,
        }
    }
}
