//! Quintics with rational rotation-minimizing frames between given tangents.

use std::cmp::Ordering;
use std::fmt;

use super::quaternion::Quaternion;
use super::spatial::SpatialPreimage;
use super::vector::Vector;
use crate::{Complex, Fraction, Int, Poly, Rational, integer, ratio};

/// Why there is no quintic with the data of a [`SpatialHermite`].
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SpatialHermiteError {
    /// A derivative is zero.
    Zero {
        /// Whether it is that at the end.
        end: bool,
    },
    /// A derivative does not consist of numbers.
    Symbolic {
        /// Whether it is that at the end.
        end: bool,
    },
    /// The middle coefficient does not fit the derivatives.
    Middle {
        /// The smallest value of `|α|²`, rounded up.
        least: String,
        /// The largest value of `|α|²`, rounded down.
        most: String,
    },
    /// The derivatives have opposite directions, which fix the middle coefficient.
    Opposite,
}

impl fmt::Display for SpatialHermiteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SpatialHermiteError::Zero { .. } => f.write_str("this tangent is zero"),
            SpatialHermiteError::Symbolic { .. } => f.write_str("a tangent must consist of numbers"),
            SpatialHermiteError::Middle { least, most } => {
                write!(
                    f,
                    "no such quintic has this middle coefficient: |middle|^2 lies between {least} and {most}"
                )
            }
            SpatialHermiteError::Opposite => {
                f.write_str("tangents of opposite directions leave no choice of the middle coefficient")
            }
        }
    }
}

impl std::error::Error for SpatialHermiteError {}

/// The derivatives at 0 and 1 of a spatial quintic that satisfies the [quintic
/// constraint](SpatialPreimage::quintic_constraint), so that its rotation-minimizing frame is rational.
///
/// In the frame of `A₀`, whose choice on its circle of roots changes no curve, let `A₁ = A₀(α + β j)` with complex numbers α and β.
/// The constraint makes `A₂ = −A₀(a + e)i` for a real `a` and `e = (α + β j) i (α + β j)*`. The rotation by `a + e` takes the
/// first tangent into the last one, which gives `(b, c, d) = e` by `a`, since with the lengths `l₀`, `l₁` of the derivatives and their
/// unit vectors at the angle γ
///
/// `a² + b² = r²`, `r² = (l₁/l₀)·(1 + cos γ)/2` and `c² + d² = ρ²`, `ρ² = (l₁/l₀)·(1 − cos γ)/2`.
///
/// As `b = |α|² − |β|²` and `c + I d = −2 I α β`, the complex number α tells all but the sign of `a`: `b = |α|² − ρ²/(4|α|²)`. So
/// the lengths `l₀`, `l₁` and `a` are all the square roots in a curve with a rational number for α, one more than in its tangents; its
/// preimage has one more in a real factor. α is the middle coefficient of the rotation `W`, but for `|A₀|²` and its
/// [conjugation](SpatialPreimage::quintic_rotation).
///
/// # Example
/// ```
/// use hodograph_algebra::{Fraction, SpatialHermite, Variable, Vector, integer};
/// let tangent = |[x, y, z]: [i64; 3]| Vector::new(integer(x).into(), integer(y).into(), integer(z).into());
/// let data = SpatialHermite::new(&tangent([1, 2, 0]), &tangent([0, 1, 1])).unwrap();
/// let preimage = data.preimage(None, false).unwrap();
/// assert!(preimage.quintic_constraint().unwrap().is_zero());
/// let v = Variable::new(1, "v");
/// let hodograph = preimage.curve(&v, &Vector::zero()).hodograph;
/// let end = hodograph.map(|part| part.substitute(&[(v.clone(), Fraction::one())].into()).unwrap());
/// assert_eq!(end.to_string(), "(0, 1, 1)");
/// ```
#[derive(Clone, Debug)]
pub struct SpatialHermite {
    /// A quaternion with `A i A*` along the first derivative.
    first: Quaternion,
    /// The factor that makes `A₀` of it, squared.
    scale: Poly,
    /// `cy + cz I` for the last derivative `(cx, cy, cz)` in the frame of `first`, over `l₀`.
    across: Complex,
    /// `r²`.
    along: Poly,
    /// `ρ²`.
    apart: Poly,
}

impl SpatialHermite {
    /// The data with these derivatives, vectors of numbers.
    ///
    /// # Errors
    /// [`SpatialHermiteError::Zero`] and [`SpatialHermiteError::Symbolic`].
    pub fn new(start: &Vector, end: &Vector) -> Result<SpatialHermite, SpatialHermiteError> {
        let numbers = |vector: &Vector, end| {
            let [x, y, z] = vector.components().each_ref().map(Fraction::to_number);
            let (Some(x), Some(y), Some(z)) = (x, y, z) else {
                return Err(SpatialHermiteError::Symbolic { end });
            };
            let square = &x * &x + &y * &y + &z * &z;
            let length = square.sqrt().filter(|length| !length.is_zero());
            Ok((Vector::new(x.into(), y.into(), z.into()), length.ok_or(SpatialHermiteError::Zero { end })?))
        };
        let ((start, l0), (end, l1)) = (numbers(start, false)?, numbers(end, true)?);
        let i = Vector::unit(0);
        let bisector = &i.scale(&l0.clone().into()) + &start;
        let first = Quaternion::from(if bisector.is_zero() { Vector::unit(1) } else { bisector });
        let number = |value: &Fraction| value.to_number().unwrap_or_else(Poly::zero);
        let norm = number(&first.norm2());
        let inverse = Fraction::from((&norm * &l0).inverse());
        let seen = first.conj().sandwich(&end).scale(&inverse);
        let [x, y, z] = seen.components().each_ref().map(number);
        let quotient = &l1 * l0.inverse();
        let half = |value: Poly| value.scale(&ratio(1, 2));
        Ok(SpatialHermite {
            first,
            scale: l0 * norm.inverse(),
            along: half(&quotient + &x),
            apart: half(quotient - x),
            across: Complex::new(y, z),
        })
    }

    /// The quadratic preimage with the complex number `middle` for α and a nonnegative `a`, or a nonpositive one if it is
    /// `mirrored`. Without α it is a positive rational number, the simplest one for which `a² ≤ b²` and `b ≥ 0`, so that the
    /// frame turns little; see [`SpatialHermite`].
    ///
    /// For tangents of different directions that are not opposite these are all such quintics, each one for one α and sign. Those of the same
    /// direction give straight lines.
    ///
    /// # Errors
    /// [`SpatialHermiteError::Middle`] and [`SpatialHermiteError::Opposite`], only with an α.
    pub fn preimage(
        &self,
        middle: Option<&Complex>,
        mirrored: bool,
    ) -> Result<SpatialPreimage, SpatialHermiteError> {
        if self.along.is_zero() {
            return if middle.is_some() { Err(SpatialHermiteError::Opposite) } else { Ok(self.opposite()) };
        }
        let alpha = match middle {
            Some(alpha) => alpha.clone(),
            None => Complex::from(Poly::constant(self.simplest())),
        };
        let size = alpha.norm2();
        if size.is_zero() {
            return Err(self.outside());
        }
        let b = self.height(&size);
        let square = &self.along - &b * &b;
        let a = square.sqrt().ok_or_else(|| self.outside())?;
        let a = if mirrored { -a } else { a };
        // c + I d = (cy + I cz)/(2(b − I a)), and a² + b² = r².
        let turned = &self.across * &Complex::new(b, a.clone());
        let cross = turned.times_real(&self.along.scale(&integer(2)).inverse());
        Ok(self.with(&alpha, &cross, &a))
    }

    /// `b` for `|α|²`.
    fn height(&self, size: &Poly) -> Poly {
        size - &self.apart * size.scale(&integer(4)).inverse()
    }

    /// The preimage with α, `c + I d` and `a`.
    fn with(&self, alpha: &Complex, cross: &Complex, a: &Poly) -> SpatialPreimage {
        let half = Complex::i().scale(&ratio(1, 2));
        let beta = &(cross * &half) * &alpha.inverse();
        let [w, x, y, z] =
            [&alpha.re, &alpha.im, &beta.re, &beta.im].map(|part| Fraction::from(part.clone()));
        let second = Quaternion::new(w, x, y, z);
        let i = Quaternion::from(Vector::unit(0));
        let rotation = &Quaternion::from(Fraction::from(a.clone())) + &(&(&second * &i) * &second.conj());
        let third = &-&rotation * &i;
        let scale = Fraction::from(self.scale.sqrt().unwrap_or_else(Poly::one));
        let first = self.first.scale(&scale).reduced();
        let coefficients = [&first * &second, &first * &third].map(|quaternion| quaternion.reduced());
        let [second, third] = coefficients;
        SpatialPreimage::nonzero(vec![first, second, third])
    }

    /// For opposite directions: `a = b = 0`, so that `|α|⁴ = ρ²/4`, and `c + I d` has any argument.
    fn opposite(&self) -> SpatialPreimage {
        let root = |value: &Poly| value.sqrt().unwrap_or_else(Poly::one);
        let rho = root(&self.apart);
        let alpha = root(&rho.scale(&ratio(1, 2)));
        self.with(&alpha.into(), &rho.into(), &Poly::zero())
    }

    /// The simplest positive number for α: of those for which `b ≥ |a|` that with the smallest denominator, as the first one
    /// on the way through the tree of Stern and Brocot.
    fn simplest(&self) -> Rational {
        // A power of two brings the numbers near 1.
        let mut scale = integer(1);
        while self.side(&scale).is_lt() {
            scale = &scale * &integer(2);
        }
        while self.side(&scale).is_gt() {
            scale = &scale * &ratio(1, 2);
        }
        let (mut low, mut high) = ([Int::ZERO, Int::ONE], [Int::ONE, Int::ZERO]);
        loop {
            let mediant = [&low[0] + &high[0], &low[1] + &high[1]];
            let value = &Rational::new(mediant[0].clone(), mediant[1].clone()) * &scale;
            match self.side(&value) {
                Ordering::Equal => return value,
                Ordering::Less => low = mediant,
                Ordering::Greater => high = mediant,
            }
        }
    }

    /// Whether a positive number is too small for α, too large, or such that `b ≥ |a|`, that is `r²/2 ≤ b² ≤ r²`.
    fn side(&self, alpha: &Rational) -> Ordering {
        let b = self.height(&Poly::constant(alpha * alpha));
        let square = &b * &b;
        if b.sign().is_lt() || square.scale(&integer(2)).compare(&self.along).is_lt() {
            Ordering::Less
        } else if square.compare(&self.along).is_gt() {
            Ordering::Greater
        } else {
            Ordering::Equal
        }
    }

    /// For which |α|² there are quintics: `(√(r² + ρ²) ± r)/2`.
    fn outside(&self) -> SpatialHermiteError {
        let root = |value: &Poly| value.sqrt().unwrap_or_else(Poly::zero);
        let (r, whole) = (root(&self.along), root(&(&self.along + &self.apart)));
        let [least, most] = [&whole - &r, whole + r].map(|value| value.scale(&ratio(1, 2)).to_decimal(6));
        SpatialHermiteError::Middle { least, most }
    }
}
