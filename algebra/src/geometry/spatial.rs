//! Quaternion preimages of spatial Pythagorean-hodograph curves.

use super::preimage::{MAX_PH_DEGREE, PreimageError};
use super::quaternion::Quaternion;
use super::vector::Vector;
use crate::{Complex, Fraction, Int, Poly, Rational, Variable, budget, integer};

/// The preimage of a spatial Pythagorean-hodograph (PH) curve: a quaternion polynomial
/// `A(t) = Σ A_j · C(k, j)·tʲ·(1 − t)ᵏ⁻ʲ` with `s'(t) = A(t) i A*(t)`.
///
/// The curve has the degree `2k + 1` and the parametric speed `σ = |A|²`. Its hodograph is `(u² + v² − p² − q², 2(uq + vp),
/// 2(vq − up))` for `A = u + v i + p j + q k`, the form of all spatial hodographs of polynomial speed that have no common
/// factor (Dietz, Hoschek and Jüttler, *An algebraic approach to curves and surfaces on the sphere and on other quadrics*, 1993). A
/// quaternion with complex right factor, `A = B·C` with `C = a + b i`, has the hodograph of `B` times `|C|²`.
///
/// # Example
/// ```
/// use hodograph_algebra::{Fraction, Quaternion, SpatialPreimage, Variable, Vector, integer};
/// let n = |n| Fraction::from(integer(n));
/// let a0 = Quaternion::one();
/// let a1 = Quaternion::new(n(1), n(0), n(1), n(0));
/// let t = Variable::new(1, "t");
/// let curve = SpatialPreimage::new(vec![a0, a1]).unwrap().curve(&t, &Vector::zero());
/// assert_eq!(curve.hodograph.to_string(), "(-t^2 + 1, 0, -2*t)");
/// assert_eq!(curve.speed.to_string(), "t^2 + 1");
/// assert_eq!(curve.position.to_string(), "(-1/3*t^3 + t, 0, -t^2)");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SpatialPreimage {
    coefficients: Vec<Quaternion>,
}

/// What a [`SpatialPreimage`] says of its curve, in a given parameter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SpatialPhCurve {
    /// The preimage `A` itself, a quaternion polynomial.
    pub quaternion: Quaternion,
    /// The hodograph `s' = A i A*`.
    pub hodograph: Vector,
    /// The parametric speed `σ = |A|²`.
    pub speed: Fraction,
    /// The curve `s` itself.
    pub position: Vector,
    /// What turns its Euler–Rodrigues frame into a rotation-minimizing one, where [`SpatialPreimage::quintic_rotation`] says it.
    pub rotation: Option<Complex>,
}

impl SpatialPreimage {
    /// The preimage with the Bernstein coefficients `A₀, …, A_k`, quaternions without the curve's parameter.
    ///
    /// # Errors
    /// [`PreimageError::Zero`] if no coefficient differs from zero.
    pub fn new(coefficients: Vec<Quaternion>) -> Result<SpatialPreimage, PreimageError> {
        if coefficients.iter().all(Quaternion::is_zero) {
            return Err(PreimageError::Zero);
        }
        Ok(SpatialPreimage::nonzero(coefficients))
    }

    /// The preimage with coefficients of which one is known not to be zero.
    pub(crate) fn nonzero(coefficients: Vec<Quaternion>) -> SpatialPreimage {
        SpatialPreimage { coefficients }
    }

    /// The preimage of a curve of degree `2k + 1` with symbols for coefficients, `A_j = a_j + b_j i + c_j j + d_j k`; the
    /// symbols are named `a0`, `b0`, `c0`, `d0`, `a1`, …, after the prefix.
    ///
    /// # Errors
    /// [`PreimageError::EvenDegree`] and [`PreimageError::DegreeTooLarge`].
    pub fn symbolic(degree: u32, prefix: &str) -> Result<SpatialPreimage, PreimageError> {
        if degree.is_multiple_of(2) {
            return Err(PreimageError::EvenDegree { degree });
        }
        if degree > MAX_PH_DEGREE {
            return Err(PreimageError::DegreeTooLarge { degree });
        }
        let coefficient = |j: u32| {
            let symbol = |letter: &str| {
                let symbol = Variable::new(Variable::SYMBOL, &format!("{prefix}{letter}{j}"));
                Fraction::from(Poly::variable(&symbol))
            };
            Quaternion::new(symbol("a"), symbol("b"), symbol("c"), symbol("d"))
        };
        Ok(SpatialPreimage { coefficients: (0..=degree / 2).map(coefficient).collect() })
    }

    /// The Bernstein coefficients `A₀, …, A_k`.
    #[must_use]
    pub fn coefficients(&self) -> &[Quaternion] {
        &self.coefficients
    }

    /// The polynomial `A(t)` in powers of `variable`, whose components have denominators without it.
    ///
    /// The coefficient of `tᵐ` is `C(k, m)·ΔᵐA₀` with forward differences Δ.
    #[must_use]
    pub fn polynomial(&self, variable: &Variable) -> Quaternion {
        let degree = self.coefficients.len() - 1;
        let mut differences = self.coefficients.clone();
        let mut binomial = Rational::from(Int::ONE);
        let mut powers = Vec::new();
        for m in 0..=degree {
            budget::spend(differences.len() as u64);
            powers.push(differences[0].scale_by(&binomial));
            differences = differences.windows(2).map(|pair| &pair[1] - &pair[0]).collect();
            binomial *= Rational::new(Int::from((degree - m) as u64), Int::from(m as u64 + 1));
        }
        let t = Fraction::from(Poly::variable(variable));
        powers.iter().rev().fold(Quaternion::zero(), |sum, power| &sum.scale(&t) + power)
    }

    /// The curve that begins at `start` for the value 0 of `variable`.
    #[must_use]
    pub fn curve(&self, variable: &Variable, start: &Vector) -> SpatialPhCurve {
        let quaternion = self.polynomial(variable);
        let hodograph = quaternion.sandwich(&Vector::unit(0)).reduced();
        let integral =
            |f: &Fraction| Fraction::new(f.numerator().integral(variable), f.factors().iter().cloned());
        let integral = hodograph.map(integral);
        let [a, b] = [start.components(), integral.components()];
        let position = Vector::new(&a[0] + &b[0], &a[1] + &b[1], &a[2] + &b[2]);
        let speed = quaternion.norm2().reduced();
        let rotation = self.quintic_rotation(variable);
        SpatialPhCurve { quaternion, hodograph, speed, position, rotation }
    }

    /// `A₀ i A₂* + A₂ i A₀* − 2 A₁ i A₁*` of a quadratic preimage, a vector: where it is zero the quintic has a rational
    /// rotation-minimizing frame (Farouki, *Quaternion and Hopf map characterizations for the existence of rational
    /// rotation-minimizing frames on quintic space curves*, 2010). `None` for other degrees.
    #[must_use]
    pub fn quintic_constraint(&self) -> Option<Vector> {
        let [a0, a1, a2] = self.coefficients.as_slice() else { return None };
        let i = Quaternion::from(Vector::unit(0));
        let mixed = &(&(a0 * &i) * &a2.conj()) + &(&(a2 * &i) * &a0.conj());
        let square = (&(a1 * &i) * &a1.conj()).scale_by(&integer(2));
        Some((&mixed - &square).vector().reduced())
    }

    /// The complex polynomial `W` of a quadratic preimage with the [quintic constraint](SpatialPreimage::quintic_constraint): the
    /// Euler–Rodrigues frame of `A·W` is rotation-minimizing. `None` for other preimages.
    ///
    /// With the scalar `c = A₂ i A₀* − A₁ i A₁*` it is, up to real factors, `W = |A₀|²(1 − t)² + 2(A₀* A₁)~(1 − t)t + (|A₁|² +
    /// c i)t²`, where `~` is the conjugate of the part in 1 and **i**; and `|W|² = |A₀|²|A|²`.
    ///
    /// # Example
    /// ```
    /// use hodograph_algebra::{Fraction, Quaternion, SpatialPreimage, Variable, integer};
    /// let n = |n| Fraction::from(integer(n));
    /// let a1 = Quaternion::new(n(2), n(1), n(1), n(0));
    /// let preimage = SpatialPreimage::constrained_quintic(&Quaternion::one(), &a1, &n(-3)).unwrap();
    /// let t = Variable::new(1, "t");
    /// assert_eq!(preimage.quintic_rotation(&t).unwrap().to_string(), "3*t^2 + 2*t + 1 + I*(-t^2 - 2*t)");
    /// ```
    #[must_use]
    pub fn quintic_rotation(&self, variable: &Variable) -> Option<Complex> {
        let [a0, a1, a2] = self.coefficients.as_slice() else { return None };
        let i = Quaternion::from(Vector::unit(0));
        let left = &(&(a2 * &i) * &a0.conj()) - &(&(a1 * &i) * &a1.conj());
        if !left.vector().reduced().is_zero() {
            return None;
        }
        let mixed = &a0.conj() * a1;
        let [w, x, ..] = mixed.components();
        let parts = [[a0.norm2(), w.clone(), a1.norm2()], [Fraction::zero(), -x, left.scalar().clone()]];
        let parts = parts.map(|part| part.map(|value| value.reduced()));
        let common = Fraction::common_denominator(parts.iter().flatten());
        let t = Poly::variable(variable);
        let other = Poly::one() - &t;
        let powers = [other.pow(2), (&t * other).scale(&integer(2)), t.pow(2)];
        let sum = |part: &[Fraction; 3]| -> Poly {
            part.iter().zip(&powers).map(|(value, power)| value.numerator_over(&common) * power).sum()
        };
        let [re, im] = parts.each_ref().map(sum);
        Some(Complex::new(re, im)).filter(|rotation| !rotation.is_zero())
    }

    /// The quadratic preimage with these first coefficients that satisfies the [quintic constraint]: `A₂ = −(c + A₁ i A₁*) A₀
    /// i/|A₀|²` for a real `c`.
    ///
    /// The constraint says that `A₂ i A₀* − A₁ i A₁*` is a scalar, `c`, and is linear in `A₂`: with `A₀ ≠ 0`, `A₁` and `c` these
    /// are all quintics that satisfy it and are regular where they begin. `None` if `A₀` is zero.
    ///
    /// # Example
    /// ```
    /// use hodograph_algebra::{Fraction, Quaternion, SpatialPreimage, integer};
    /// let n = |n| Fraction::from(integer(n));
    /// let a1 = Quaternion::new(n(2), n(1), n(1), n(0));
    /// let preimage = SpatialPreimage::constrained_quintic(&Quaternion::one(), &a1, &n(-3)).unwrap();
    /// assert_eq!(preimage.coefficients()[2].to_string(), "(4, 3, 4, 2)");
    /// assert!(preimage.quintic_constraint().unwrap().is_zero());
    /// ```
    ///
    /// [quintic constraint]: SpatialPreimage::quintic_constraint
    #[must_use]
    pub fn constrained_quintic(a0: &Quaternion, a1: &Quaternion, c: &Fraction) -> Option<SpatialPreimage> {
        let i = Quaternion::from(Vector::unit(0));
        let inverse = a0.norm2().reduced().reciprocal(&[])?;
        let sum = &Quaternion::from(c.clone()) + &(&(a1 * &i) * &a1.conj());
        let a2 = (&(&sum * a0) * &i).scale(&-&inverse).reduced();
        Some(SpatialPreimage { coefficients: vec![a0.clone(), a1.clone(), a2] })
    }
}
