//! Preimages of planar Pythagorean-hodograph curves.

use std::fmt;

use crate::{Complex, Int, Poly, Rational, Variable, budget, minimize_field};

/// The largest degree of a curve with symbolic preimage.
pub const MAX_PH_DEGREE: u32 = 201;

/// The preimage of a planar Pythagorean-hodograph (PH) curve: a complex polynomial
/// `w(t) = Σ w_j · C(k, j)·tʲ·(1 − t)ᵏ⁻ʲ` with `s'(t) = h(t)·w(t)²` (FN (9); Farouki, *The conformal map z → z² of the
/// hodograph plane*, 1994).
///
/// The real factor `h` is 1, which gives the primitive hodographs, unless [`Preimage::with_factor`] sets another one.
/// With `w = a + I·b` the curve of degree `2k + 1` has the hodograph `(x', y') = h·(a² − b², 2ab)` (FN (7)) and the
/// parametric speed `σ = h·(a² + b²)`, a polynomial.
///
/// # Example
/// ```
/// use hodograph_algebra::{Complex, Poly, Preimage, Variable};
/// let t = Variable::new(1, "t");
/// let w = Preimage::new(vec![Complex::one(), Complex::one() + Complex::i()]).unwrap();
/// let curve = w.curve(&t, &Complex::zero());
/// assert_eq!(curve.hodograph.to_string(), "-t^2 + 1 + I*(2*t)");
/// assert_eq!(curve.speed.to_string(), "t^2 + 1");
/// assert_eq!(curve.position.to_string(), "-1/3*t^3 + t + I*(t^2)");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Preimage {
    coefficients: Vec<Complex>,
    factor: Poly,
}

/// What a [`Preimage`] says of its curve, in a given parameter; the plane's points are complex numbers `x + I·y`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PhCurve {
    /// The hodograph `s' = h·w²`.
    pub hodograph: Complex,
    /// The parametric speed `σ = h·|w|²`, of the sign of `h`.
    pub speed: Poly,
    /// The curve `s` itself.
    pub position: Complex,
}

/// Why there is no such preimage.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PreimageError {
    /// There are no coefficients, or all are zero, so that the curve would be a point.
    Zero,
    /// A PH curve with a preimage, planar or spatial, has an odd degree.
    EvenDegree {
        /// The degree asked for.
        degree: u32,
    },
    /// The degree is above [`MAX_PH_DEGREE`].
    DegreeTooLarge {
        /// The degree asked for.
        degree: u32,
    },
}

impl fmt::Display for PreimageError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PreimageError::Zero => {
                f.write_str("the preimage has no nonzero coefficient: its curve would be a single point")
            }
            PreimageError::EvenDegree { degree } => {
                write!(f, "a PH curve with a preimage has an odd degree 1, 3, 5, …, not {degree}")
            }
            PreimageError::DegreeTooLarge { degree } => {
                write!(f, "a PH curve of degree {degree} is asked for; the largest degree is {MAX_PH_DEGREE}")
            }
        }
    }
}

impl std::error::Error for PreimageError {}

impl Preimage {
    /// The preimage with the Bernstein coefficients `w₀, …, w_k`, and factor 1.
    ///
    /// # Errors
    /// [`PreimageError::Zero`] if no coefficient differs from zero.
    pub fn new(coefficients: Vec<Complex>) -> Result<Preimage, PreimageError> {
        if coefficients.iter().all(Complex::is_zero) {
            return Err(PreimageError::Zero);
        }
        Ok(Preimage::nonzero(coefficients))
    }

    /// The preimage of a curve of degree `2k + 1` with symbols for coefficients, `w_j = a_j + I·b_j`; the symbols are
    /// named `a0`, `b0`, `a1`, …, after the prefix.
    ///
    /// # Errors
    /// [`PreimageError::EvenDegree`] and [`PreimageError::DegreeTooLarge`].
    ///
    /// # Example
    /// ```
    /// use hodograph_algebra::{Preimage, Variable};
    /// let cubic = Preimage::symbolic(3, "").unwrap();
    /// assert_eq!(cubic.coefficients()[1].to_string(), "a1 + I*(b1)");
    /// let t = Variable::new(1, "t");
    /// assert_eq!(cubic.speed(&t).degree(&t), Some(2));
    /// assert!(Preimage::symbolic(4, "").is_err());
    /// ```
    pub fn symbolic(degree: u32, prefix: &str) -> Result<Preimage, PreimageError> {
        if degree.is_multiple_of(2) {
            return Err(PreimageError::EvenDegree { degree });
        }
        if degree > MAX_PH_DEGREE {
            return Err(PreimageError::DegreeTooLarge { degree });
        }
        let symbol = |letter: &str, j: u32| {
            Poly::variable(&Variable::new(Variable::SYMBOL, &format!("{prefix}{letter}{j}")))
        };
        let coefficient = |j| Complex::new(symbol("a", j), symbol("b", j));
        Ok(Preimage::nonzero((0..=degree / 2).map(coefficient).collect()))
    }

    /// The preimage with coefficients of which one is known not to be zero.
    pub(crate) fn nonzero(coefficients: Vec<Complex>) -> Preimage {
        Preimage { coefficients, factor: Poly::one() }
    }

    /// The preimage with the real polynomial `factor` for `h`.
    #[must_use]
    pub fn with_factor(self, factor: Poly) -> Preimage {
        Preimage { factor, ..self }
    }

    /// The Bernstein coefficients `w₀, …, w_k`.
    #[must_use]
    pub fn coefficients(&self) -> &[Complex] {
        &self.coefficients
    }

    /// The factor `h`.
    #[must_use]
    pub fn factor(&self) -> &Poly {
        &self.factor
    }

    /// The polynomial `w(t) = a(t) + I·b(t)` in powers of `variable`.
    ///
    /// The coefficient of `tᵐ` is `C(k, m)·Δᵐw₀` with forward differences Δ.
    ///
    /// Complexity: `O(k²)` operations on coefficients.
    #[must_use]
    pub fn polynomial(&self, variable: &Variable) -> Complex {
        let degree = self.coefficients.len() - 1;
        let mut differences = self.coefficients.clone();
        let mut binomial = Rational::from(Int::ONE);
        let (mut re, mut im) = (Vec::new(), Vec::new());
        for m in 0..=degree {
            budget::spend(differences.len() as u64);
            re.push(differences[0].re.scale(&binomial));
            im.push(differences[0].im.scale(&binomial));
            differences = differences.windows(2).map(|pair| &pair[1] - &pair[0]).collect();
            binomial *= Rational::new(Int::from((degree - m) as u64), Int::from(m as u64 + 1));
        }
        Complex { re: Poly::from_coefficients(variable, &re), im: Poly::from_coefficients(variable, &im) }
    }

    /// The hodograph `s' = h·w²`, that is `h·(a² − b²) + I·2hab`.
    #[must_use]
    pub fn hodograph(&self, variable: &Variable) -> Complex {
        let w = self.polynomial(variable);
        (&w * &w).times_real(&self.factor)
    }

    /// The parametric speed `σ = h·(a² + b²)`; where `h` is negative, so is this.
    #[must_use]
    pub fn speed(&self, variable: &Variable) -> Poly {
        self.polynomial(variable).norm2() * &self.factor
    }

    /// The curve that begins at `start` for the value 0 of `variable`; hodograph, speed and position are over one number
    /// field, with as few generators as [`minimize_field`] finds.
    ///
    /// Since these contain products of two coefficients only, their field can be smaller than that of the preimage:
    /// for FN Example 4 it is Q(√35), while the preimage needs √2 as well.
    #[must_use]
    pub fn curve(&self, variable: &Variable, start: &Complex) -> PhCurve {
        let w = self.polynomial(variable);
        let hodograph = (&w * &w).times_real(&self.factor);
        let speed = w.norm2() * &self.factor;
        let position = Complex {
            re: hodograph.re.integral(variable) + &start.re,
            im: hodograph.im.integral(variable) + &start.im,
        };
        let parts = [hodograph.re, hodograph.im, speed, position.re, position.im];
        let mut parts = minimize_field(&parts).into_iter();
        let mut next = || parts.next().unwrap_or_else(Poly::zero);
        PhCurve {
            hodograph: Complex { re: next(), im: next() },
            speed: next(),
            position: Complex { re: next(), im: next() },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symbolic_preimages_have_pythagorean_hodographs() {
        let t = Variable::new(1, "t");
        for degree in [1, 3, 5, 7] {
            let preimage = Preimage::symbolic(degree, "s").unwrap();
            let curve = preimage.curve(&t, &Complex::zero());
            assert_eq!(curve.hodograph.norm2(), curve.speed.pow(2));
            assert_eq!(curve.position.re.degree(&t), Some(degree));
            assert_eq!(curve.position.im.derivative(&t), curve.hodograph.im);
            assert!(curve.speed.occurring_variables().iter().any(|variable| variable.name() == "sa0"));
        }
    }

    #[test]
    fn ends_are_the_outer_coefficients() {
        let t = Variable::new(1, "t");
        let preimage = Preimage::symbolic(9, "").unwrap();
        let w = preimage.polynomial(&t);
        for (end, coefficient) in [(0, 0), (1, 4)] {
            let value = |poly: &Poly| poly.substitute(&t, &Poly::integer(end));
            assert_eq!(value(&w.re), preimage.coefficients()[coefficient].re);
            assert_eq!(value(&w.im), preimage.coefficients()[coefficient].im);
        }
    }

    #[test]
    fn factors_multiply_hodograph_and_speed() {
        let t = Variable::new(1, "t");
        let factor = Poly::variable(&t) - Poly::integer(3);
        let preimage = Preimage::symbolic(3, "").unwrap();
        let scaled = preimage.clone().with_factor(factor.clone());
        assert_eq!(scaled.speed(&t), preimage.speed(&t) * &factor);
        assert_eq!(scaled.hodograph(&t).im, preimage.hodograph(&t).im * &factor);
    }

    #[test]
    fn impossible_degrees_are_refused() {
        assert_eq!(Preimage::symbolic(0, ""), Err(PreimageError::EvenDegree { degree: 0 }));
        assert_eq!(Preimage::symbolic(6, ""), Err(PreimageError::EvenDegree { degree: 6 }));
        assert_eq!(Preimage::symbolic(203, ""), Err(PreimageError::DegreeTooLarge { degree: 203 }));
        assert_eq!(Preimage::symbolic(201, "").unwrap().coefficients().len(), 101);
        assert_eq!(Preimage::new(vec![Complex::zero()]), Err(PreimageError::Zero));
        assert_eq!(Preimage::new(Vec::new()), Err(PreimageError::Zero));
    }
}
