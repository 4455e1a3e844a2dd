//! Pipe and canal surfaces: envelopes of spheres along a curve.

use std::fmt;

use super::curve::Curve;
use super::curve_error::CurveError;
use super::frame::AdaptedFrame;
use super::vector::Vector;
use crate::{Complex, Fraction, Poly, Variable, integer};

/// Why the envelope of spheres has no parametrization here.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum CanalError {
    /// What the spine lacks.
    Spine(CurveError),
    /// `σ² − r'²` changes its sign, so that it is no sum of two squares: where it is negative, the radius grows faster than the
    /// spine is long, and the spheres have no envelope.
    Imaginary {
        /// The factor of odd multiplicity that changes its sign.
        factor: Box<Poly>,
    },
    /// `σ² − r'²` is nowhere positive: the spheres have no envelope at all.
    Negative {
        /// `σ² − r'²`.
        value: Box<Fraction>,
    },
    /// `σ² − r'²` is a sum of two squares over the real numbers if it is nowhere negative, but finding them takes more than
    /// square roots, or symbols decide.
    Unsplit {
        /// The factor of odd multiplicity that is not a quadratic with numbers for coefficients.
        factor: Box<Poly>,
    },
}

impl fmt::Display for CanalError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CanalError::Spine(error) => error.fmt(f),
            CanalError::Imaginary { factor } => write!(
                f,
                "this canal surface is not rational: σ^2 - r'^2 must be a sum p^2 + q^2 of two squares, but it changes its \
                 sign with its factor {factor}; where it is negative, the radius changes faster than the spine moves"
            ),
            CanalError::Negative { value } => write!(
                f,
                "this canal surface is not rational: σ^2 - r'^2 must be a sum p^2 + q^2 of two squares, but it is {value}, \
                 which is nowhere positive: the radius changes faster than the spine moves"
            ),
            CanalError::Unsplit { factor } => write!(
                f,
                "σ^2 - r'^2 must be split into a sum p^2 + q^2 of two squares, but its factor {factor} is not a \
                 quadratic with numbers for coefficients"
            ),
        }
    }
}

impl std::error::Error for CanalError {}

impl From<CurveError> for CanalError {
    fn from(error: CurveError) -> CanalError {
        CanalError::Spine(error)
    }
}

impl Curve {
    /// The canal surface: the envelope of the spheres around the points of the curve with the radius `radius`, a function of
    /// the curve's parameter. With a constant radius it is the pipe surface.
    ///
    /// Each sphere touches it in a circle, `s − (r r'/σ) t + (r/σ)(P f + Q g)` with `P² + Q² = σ² − r'²` for a frame `(t, f, g)` of the
    /// curve, here `P + I Q = (p + I q)(1 + I u)²/(1 + u²)` with the parameter `across`. So it is rational over the real numbers if `σ² − r'² = p² +
    /// q²`, that is if this is nowhere negative (Peternell and Pottmann, *Computing rational parametrizations of canal surfaces*, 1997).
    /// It is split here where its factors of odd multiplicity, taken from `σ − r'` and `σ + r'`, are quadratics; for pipes it is a
    /// square.
    ///
    /// # Errors
    /// As for [`Curve::speed`], and [`CanalError`].
    ///
    /// # Example
    /// ```
    /// use hodograph_algebra::{Curve, Fraction, KnownProperties, Poly, Variable, Vector, ratio};
    /// let [u, v] = [Variable::new(0, "u"), Variable::new(1, "v")];
    /// let t = Poly::variable(&v);
    /// let line = Vector::new(t.scale(&ratio(5, 1)).into(), Fraction::zero(), Fraction::zero());
    /// let line = Curve::new(&v, line, None, KnownProperties::default(), Default::default());
    /// let frame = line.euler_rodrigues_frame().unwrap();
    /// let cone = line.canal(&frame, &Fraction::from(t.scale(&ratio(3, 1))), &u).unwrap();
    /// let [x, y, z] = cone.components();
    /// assert_eq!(x.reduced().to_string(), "16/5*v");
    /// // The cone y² + z² = (9/16) x².
    /// assert_eq!(&(y * y) + &(z * z), (x * x).scale(&ratio(9, 16)));
    /// ```
    pub fn canal(
        &self,
        frame: &AdaptedFrame,
        radius: &Fraction,
        across: &Variable,
    ) -> Result<Vector, CanalError> {
        let speed = self.speed()?;
        let growth = self.calculus().derivative(radius, self.parameter());
        let known: Vec<Poly> = speed.numerator().squarefree().factors.into_iter().map(|(f, _)| f).collect();
        let inverse = speed.reciprocal(&known).ok_or(CurveError::Point)?;
        let root = self.two_squares(&speed, &growth)?;
        let u = Poly::variable(across);
        let weight = Poly::one() + u.pow(2);
        let over = |numerator: Poly| Fraction::new(numerator, [(weight.clone(), 1)]);
        let (cosine, sine) = (over(Poly::one() - u.pow(2)), over(u.scale(&integer(2))));
        let along = &(&(radius * &growth) * &inverse).reduced();
        let scale = &(radius * &inverse);
        let part = |part: Fraction| (&part * scale).reduced();
        let p = part(&(&root.0 * &cosine) - &(&root.1 * &sine));
        let q = part(&(&root.0 * &sine) + &(&root.1 * &cosine));
        let circle = &frame.f.scale(&p) + &frame.g.scale(&q);
        Ok(&(self.position() - &frame.tangent.scale(along)) + &circle)
    }

    /// `p` and `q` with `p² + q² = σ² − r'²`.
    fn two_squares(&self, speed: &Fraction, growth: &Fraction) -> Result<(Fraction, Fraction), CanalError> {
        if growth.is_zero() {
            return Ok((speed.clone(), Fraction::zero()));
        }
        let sides = [(speed - growth).lowest_terms(), (speed + growth).lowest_terms()];
        let mut unit = Poly::one();
        let mut root = Complex::one();
        let mut denominator = Fraction::one();
        for side in &sides {
            // n/d = n·d/d².
            let odd = side.factors().iter().filter(|(_, exponent)| exponent % 2 == 1);
            let numerator = odd.fold(side.numerator().clone(), |product, (factor, _)| product * factor);
            let below = side.factors().iter().map(|(factor, e)| (factor.clone(), e.div_ceil(2)));
            denominator = &denominator * &Fraction::new(Poly::one(), below);
            let parts = numerator.squarefree();
            unit *= parts.unit;
            for (factor, multiplicity) in parts.factors {
                root = root.times_real(&factor.pow(multiplicity / 2));
                if multiplicity % 2 == 1 {
                    let (scale, split) = self.split(&factor)?;
                    unit *= scale;
                    root = &root * &split;
                }
            }
        }
        let scale = unit.sqrt().filter(|_| unit.is_constant());
        let whole = || CanalError::Negative {
            value: Box::new((&(speed * speed) - &(growth * growth)).lowest_terms()),
        };
        let scale = scale.ok_or_else(whole)?;
        let part = |part: Poly| &Fraction::from(part * &scale) * &denominator;
        Ok((part(root.re), part(root.im)))
    }

    /// A quadratic `f` without real zeros as `scale·|root|²`.
    fn split(&self, f: &Poly) -> Result<(Poly, Complex), CanalError> {
        let variable = self.parameter();
        let coefficients = f.coefficients(variable);
        if coefficients.iter().any(|part| !part.is_constant()) {
            return Err(CanalError::Unsplit { factor: Box::new(f.clone()) });
        }
        if f.real_roots(variable).is_some_and(|roots| !roots.is_empty()) {
            return Err(CanalError::Imaginary { factor: Box::new(f.clone()) });
        }
        let [c, b, a] = coefficients.as_slice() else {
            return Err(CanalError::Unsplit { factor: Box::new(f.clone()) });
        };
        // 4a·f = (2a v + b)² + (4ac − b²).
        let discriminant = (a * c).scale(&integer(4)) - b * b;
        let im = discriminant.sqrt().ok_or_else(|| CanalError::Imaginary { factor: Box::new(f.clone()) })?;
        let re = Poly::variable(variable) * a.scale(&integer(2)) + b;
        Ok((a.scale(&integer(4)).inverse(), Complex::new(re, im)))
    }
}
