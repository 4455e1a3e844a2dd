//! Adapted frames of spatial curves: Euler–Rodrigues, rotation-minimizing, Frenet.

use super::curve::{Curve, rational_root};
use super::curve_error::CurveError;
use super::quaternion::Quaternion;
use super::sample::sample_sign;
use super::spin::{Rotation, SpinError};
use super::vector::Vector;
use crate::{Complex, Fraction, Interval, Poly, Variable, integer};

/// A right-handed orthonormal frame `(t, f, g)` along a curve, of which the first vector is the unit tangent.
///
/// It turns with the parameter, and `f'·g` is its spin: the component of its angular velocity along the tangent. The
/// frame is rotation-minimizing where the spin is zero (Bishop, *There is more than one way to frame a curve*, 1975).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AdaptedFrame {
    /// The unit tangent `t`.
    pub tangent: Vector,
    /// The unit vector `f`, orthogonal to `t`.
    pub f: Vector,
    /// `g = t × f`.
    pub g: Vector,
    /// The spin `f'·g`, by the curve's parameter.
    pub spin: Fraction,
    /// A quaternion polynomial whose Euler–Rodrigues frame it is, if it was made from one.
    pub quaternion: Option<Quaternion>,
    /// The polynomial `W` with `2·arg W` the angle by which it is ahead of the Euler–Rodrigues frame, if it was made so.
    pub rotation: Option<Complex>,
}

impl AdaptedFrame {
    /// The Euler–Rodrigues frame `(A i A*, A j A*, A k A*)/|A|²` of a quaternion with the derivative `derivative`. Its spin is
    /// `2·(A* A')_i/|A|²`, the **i**-component of the angular velocity in the frame (Choi and Han, *Euler–Rodrigues frames on
    /// spatial Pythagorean-hodograph curves*, 2002). `None` for zero.
    #[must_use]
    pub fn euler_rodrigues(quaternion: &Quaternion, derivative: &Quaternion) -> Option<AdaptedFrame> {
        let [tangent, f, g] = quaternion.rotation()?.map(|column| column.map(Fraction::reduced));
        let inverse = quaternion.norm2().reduced().reciprocal(&[])?;
        let spin = (&twist(quaternion, derivative).scale(&integer(2)) * &inverse).reduced();
        Some(AdaptedFrame { tangent, f, g, spin, quaternion: Some(quaternion.clone()), rotation: None })
    }

    /// This Euler–Rodrigues frame, of `A`, turned in the normal plane by the angle `2·arg W`: that of `A·W`, with `f` turned
    /// into `((p² − q²)·f + 2pq·g)/|W|²` for `W = p + I·q`. Its spin is larger by `2·Im(conj(W)·W')/|W|²`; `None` unless it is zero.
    fn unspun_by(&self, rotation: &Rotation, variable: &Variable) -> Option<AdaptedFrame> {
        // Nothing but this identity says that the frame is rotation-minimizing.
        let turning = rotation.spin(variable).scale(&integer(2));
        if !(&self.spin + &turning).is_zero() {
            return None;
        }
        let w = &rotation.polynomial;
        let square = w * w;
        let factors: Vec<Poly> = self
            .tangent
            .components()
            .iter()
            .flat_map(|part| part.factors().iter().map(|(f, _)| f.clone()))
            .collect();
        let inverse = Fraction::from(w.norm2()).reciprocal(&factors)?;
        let (cosine, sine) = (&inverse * &Fraction::from(square.re), &inverse * &Fraction::from(square.im));
        let turned =
            |a: &Fraction, b: &Fraction| (&self.f.scale(a) + &self.g.scale(b)).map(Fraction::reduced);
        let quaternion = self.quaternion.as_ref().map(|quaternion| {
            let turned = quaternion * &quaternion_of(&w.re, &w.im);
            primitive(&turned).unwrap_or(turned)
        });
        Some(AdaptedFrame {
            tangent: self.tangent.clone(),
            f: turned(&cosine, &sine),
            g: turned(&-&sine, &cosine),
            spin: Fraction::zero(),
            quaternion,
            rotation: Some(w.clone()),
        })
    }
}

/// The **i**-component of `A* A'`.
fn twist(quaternion: &Quaternion, derivative: &Quaternion) -> Fraction {
    (&quaternion.conj() * derivative).components()[1].reduced()
}

impl Curve {
    /// The Euler–Rodrigues frame of the curve's preimage `A`, with `s' = A i A*`.
    ///
    /// A curve that was not made from a preimage has one all the same if its parametric speed is rational: `A` is then
    /// `σ + x' − z' j + y' k`, over all factors that leave the direction of `A i A*`; its frame begins and turns as that
    /// quaternion does.
    ///
    /// # Errors
    /// As for [`Curve::speed`].
    ///
    /// # Example
    /// The spatial PH cubic with `A = 1 + v j`, in fact planar:
    /// ```
    /// use hodograph_algebra::{Curve, Fraction, KnownProperties, Poly, Variable, Vector, ratio};
    /// let v = Variable::new(1, "v");
    /// let t = Poly::variable(&v);
    /// let z = -t.pow(2);
    /// let position = Vector::new((&t - t.pow(3).scale(&ratio(1, 3))).into(), Fraction::zero(), z.into());
    /// let curve = Curve::new(&v, position, None, KnownProperties::default(), Default::default());
    /// let frame = curve.euler_rodrigues_frame().unwrap();
    /// assert_eq!(frame.quaternion.unwrap().to_string(), "(1, 0, v, 0)");
    /// assert_eq!(frame.f, Vector::unit(1));
    /// assert!(frame.spin.is_zero());
    /// ```
    pub fn euler_rodrigues_frame(&self) -> Result<AdaptedFrame, CurveError> {
        self.frames().euler_rodrigues.get_or_init(|| self.oriented()).clone()
    }

    fn oriented(&self) -> Result<AdaptedFrame, CurveError> {
        let quaternion = match self.quaternion() {
            Some(quaternion) => quaternion.clone(),
            None => self.orienting_quaternion()?,
        };
        AdaptedFrame::euler_rodrigues(&quaternion, &self.turning(&quaternion)).ok_or(CurveError::Point)
    }

    /// The derivative of a quaternion by the curve's parameter.
    fn turning(&self, quaternion: &Quaternion) -> Quaternion {
        quaternion.map(|part| self.calculus().derivative(part, self.parameter()))
    }

    /// A quaternion polynomial `A` with `A i A*` along the tangent: `σ + x' − z' j + y' k` up to factors on its right.
    fn orienting_quaternion(&self) -> Result<Quaternion, CurveError> {
        let speed = self.speed()?.reduced();
        let [x, y, z] = self.hodograph().components();
        let parts = [&speed, x, y, z];
        let common = Fraction::common_denominator(parts);
        let [speed, x, y, z] = parts.map(|part| part.numerator_over(&common));
        let w = speed + x;
        if w.is_zero() {
            return Ok(Quaternion::from(Vector::unit(1)));
        }
        let content = Poly::gcd_many(&[w.clone(), y.clone(), z.clone()]);
        let divided = |part: Poly| part.exact_div(&content).unwrap_or(part);
        let [w, y, z] = [w, y, z].map(divided);
        // A = α + γ j, and a common factor of α and conj(γ) is a complex factor on the right.
        let (alpha, gamma) = (Complex::from(w.clone()), Complex::new(-&z, y.clone()));
        let factor = alpha.gcd(&gamma.conj(), self.parameter());
        let norm = factor.norm2();
        let (alpha, gamma) = (&alpha * &factor.conj(), &gamma * &factor);
        let quotient = |part: &Poly| part.exact_div(&norm);
        let parts = [&alpha.re, &alpha.im, &gamma.re, &gamma.im].map(quotient);
        let [Some(a), Some(b), Some(c), Some(d)] = parts else {
            return Ok(quaternion([w, Poly::zero(), -&z, y]));
        };
        let reduced = quaternion([a, b, c, d]);
        Ok(primitive(&reduced).unwrap_or(reduced))
    }

    /// The rotation-minimizing frame that begins as the [Euler–Rodrigues frame](Curve::euler_rodrigues_frame) where the
    /// domain does (at 0 without one), if it is rational: the Euler–Rodrigues frame of `A·W`, where the complex polynomial `W = a +
    /// b i` turns back what that of A turns: `Im(conj(W)·W')/|W|² = −(A* A')_i/|A|²`.
    ///
    /// Every rational frame is such a one, so [`Rotation::with_spin`] decides for PH curves of every degree, whether or not
    /// their hodographs are primitive. The other rotation-minimizing frames, turned in the normal plane by a constant angle,
    /// are rational if this is.
    ///
    /// # Errors
    /// As for [`Curve::speed`]; [`CurveError::NoRationalFrame`] if it is not rational; [`CurveError::UnknownFrame`] if unknown functions
    /// occur.
    pub fn rotation_minimizing_frame(&self) -> Result<AdaptedFrame, CurveError> {
        self.frames().rotation_minimizing.get_or_init(|| self.unspun()).clone()
    }

    fn unspun(&self) -> Result<AdaptedFrame, CurveError> {
        let frame = self.euler_rodrigues_frame()?;
        let spin = frame.spin.scale(&crate::ratio(-1, 2));
        if spin.occurring_variables().iter().any(|variable| self.calculus().is_function(variable)) {
            return Err(CurveError::UnknownFrame);
        }
        let start = self.domain().map_or_else(Poly::zero, |domain| domain.lower().clone());
        let known = self.known_rotation().map(|known| Rotation::begun(known, self.parameter(), &start));
        if let Some(minimizing) = known.and_then(|known| frame.unspun_by(&known, self.parameter())) {
            return Ok(minimizing);
        }
        let none =
            |error| CurveError::NoRationalFrame { spin: Box::new(spin.clone()), error: Box::new(error) };
        let rotation = Rotation::with_spin(&spin, self.parameter(), &start).map_err(none)?;
        frame.unspun_by(&rotation, self.parameter()).ok_or_else(|| none(SpinError::Undecided))
    }

    /// The Frenet frame `(t, n, b)`, if it is rational: `b = s' × s''/|s' × s''|` and `n = b × t`.
    ///
    /// The root of `|s' × s''|²` is the rational one that is positive at the beginning; where it changes its sign, at an
    /// inflection, the frame goes on smoothly.
    ///
    /// # Errors
    /// As for [`Curve::speed`]; [`CurveError::Straight`]; [`CurveError::IrrationalFrenet`]; [`CurveError::SymbolicFrenet`].
    pub fn frenet_frame(&self) -> Result<AdaptedFrame, CurveError> {
        self.frames().frenet.get_or_init(|| self.osculating()).clone()
    }

    fn osculating(&self) -> Result<AdaptedFrame, CurveError> {
        let tangent = self.tangent()?;
        let cross = self.osculating_direction()?;
        let root = rational_root(&cross.norm2().reduced()).map_err(|error| match error {
            CurveError::IrrationalSpeed { odd, .. } if self.is_constant(&odd) => {
                CurveError::SymbolicFrenet { radicand: odd }
            }
            CurveError::IrrationalSpeed { squared, odd } => CurveError::IrrationalFrenet { squared, odd },
            other => other,
        })?;
        let interval = self.domain().cloned().unwrap_or_else(Interval::unit);
        let negative = sample_sign(&root, self.parameter(), &interval).is_lt();
        let inverse = root.reciprocal(&[]).ok_or(CurveError::Straight)?;
        let binormal = cross.scale(&if negative { -&inverse } else { inverse }).map(Fraction::lowest_terms);
        let f = binormal.cross(&tangent).map(Fraction::lowest_terms);
        let spin = self.frenet_spin()?;
        Ok(AdaptedFrame { tangent, f, g: binormal, spin, quaternion: None, rotation: None })
    }

    /// Whether a polynomial depends neither on the parameter nor on unknown functions.
    fn is_constant(&self, poly: &Poly) -> bool {
        let moves =
            |variable: &Variable| variable == self.parameter() || self.calculus().is_function(variable);
        !poly.occurring_variables().iter().any(moves)
    }

    /// `s' × s''`, which is not zero: the direction of the binormal.
    ///
    /// # Errors
    /// [`CurveError::Straight`].
    pub fn osculating_direction(&self) -> Result<Vector, CurveError> {
        let second = self.calculus().vector_derivative(self.hodograph(), self.parameter());
        let cross = self.hodograph().cross(&second).reduced();
        if cross.is_zero() { Err(CurveError::Straight) } else { Ok(cross) }
    }

    /// The torsion `τ = (s' × s'')·s'''/|s' × s''|²`, which is rational for every rational curve.
    ///
    /// # Errors
    /// [`CurveError::Straight`].
    pub fn torsion(&self) -> Result<Fraction, CurveError> {
        let cross = self.osculating_direction()?;
        let by = |vector: &Vector| self.calculus().vector_derivative(vector, self.parameter());
        let volume = cross.dot(&by(&by(self.hodograph()))).reduced();
        let inverse = cross.norm2().reduced().reciprocal(&[]).ok_or(CurveError::Straight)?;
        Ok((&volume * &inverse).reduced().lowest_terms())
    }

    /// The spin of the Frenet frame about the tangent, `n'·b = σ τ`: rational wherever the parametric speed is, also where the
    /// frame is not.
    ///
    /// # Errors
    /// As for [`Curve::speed`] and [`Curve::torsion`].
    pub fn frenet_spin(&self) -> Result<Fraction, CurveError> {
        Ok((&self.speed()? * &self.torsion()?).lowest_terms())
    }

    /// The Frenet frame at a value of the parameter, a number without symbols: its vectors are numbers, square roots of
    /// numbers included. `None` where the curvature is zero, or not defined, or symbols occur.
    #[must_use]
    pub fn frenet_frame_at(&self, value: &Poly) -> Option<AdaptedFrame> {
        let values = [(self.parameter().clone(), Fraction::from(value.clone()))].into();
        let number = |f: &Fraction| f.substitute(&values).and_then(|value| value.to_number());
        let numbers = |vector: &Vector| {
            let [x, y, z] = vector.components().each_ref().map(number);
            Some(Vector::new(x?.into(), y?.into(), z?.into()))
        };
        let unit = |vector: &Vector| {
            let length = vector.norm2().to_number()?.sqrt().filter(|length| !length.is_zero())?;
            Some(vector.scale(&length.inverse().into()))
        };
        let hodograph = numbers(self.hodograph())?;
        let tangent = unit(&hodograph)?;
        let binormal = unit(&numbers(&self.osculating_direction().ok()?)?)?;
        let speed = hodograph.norm2().to_number()?.sqrt()?;
        let spin = (speed * number(&self.torsion().ok()?)?).into();
        let f = binormal.cross(&tangent);
        Some(AdaptedFrame { tangent, f, g: binormal, spin, quaternion: None, rotation: None })
    }
}

/// The quaternion `a + b i`.
fn quaternion_of(a: &Poly, b: &Poly) -> Quaternion {
    quaternion([a.clone(), b.clone(), Poly::zero(), Poly::zero()])
}

fn quaternion(parts: [Poly; 4]) -> Quaternion {
    let [w, x, y, z] = parts.map(Fraction::from);
    Quaternion::new(w, x, y, z)
}

/// A quaternion without the real factor that its components have in common, denominators included.
fn primitive(given: &Quaternion) -> Option<Quaternion> {
    let common = Fraction::common_denominator(given.components());
    let parts = given.components().each_ref().map(|part| part.numerator_over(&common));
    let content = Poly::gcd_many(&parts);
    let scale = Poly::common_content(&parts).recip();
    let divided = parts.each_ref().map(|part| Some(part.exact_div(&content)?.scale(&scale)));
    let [Some(w), Some(x), Some(y), Some(z)] = divided else { return None };
    Some(quaternion([w, x, y, z]))
}
