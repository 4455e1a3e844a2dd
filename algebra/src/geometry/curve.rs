//! Rational curves, and what their parametric speed makes of them.

use std::cell::OnceCell;
use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::rc::Rc;

use super::calculus::Calculus;
use super::curve_error::CurveError;
use super::frame::AdaptedFrame;
use super::plane;
use super::quaternion::Quaternion;
use super::sample::sample_sign;
use super::vector::Vector;
use num_traits::Signed;

use crate::{BoxSign, Complex, Fraction, Interval, Poly, Rational, Term, Variable, ratio};

/// A rational curve with its derivative properties, where these are rational.
///
/// Any curve whose parametric speed is a rational function offers its unit tangent and normal, curvature, offsets,
/// involute and evolute; whether it is one is decided by a perfect-square test on `|s'|²`, however the curve was made.
///
/// A planar curve may lie in any plane; `e` is the unit vector orthogonal to it whose last component other than zero is
/// positive: **k** for the xy-plane, **j** for the xz-plane, **i** for the yz-plane. The normal is `n = t × e` (FN (3)):
/// seen from the tip of `e` it points to the right of the tangent, away from the center of curvature where the curvature
/// is positive.
///
/// # Example
/// A PH cubic with the preimage `w = 1 + I·v` (FN (7)):
/// ```
/// use hodograph_algebra::{Calculus, Curve, Fraction, Interval, KnownProperties, Poly, Variable, Vector, ratio};
/// use std::rc::Rc;
/// let v = Variable::new(1, "v");
/// let t = Poly::variable(&v);
/// let position = Vector::new((&t - t.pow(3).scale(&ratio(1, 3))).into(), t.pow(2).into(), Fraction::zero());
/// let known = KnownProperties::default();
/// let curve = Curve::new(&v, position, Some(Interval::unit()), known, Rc::new(Calculus::new()));
/// assert_eq!(curve.speed().unwrap().to_string(), "v^2 + 1");
/// assert_eq!(curve.arclength().unwrap().to_string(), "1/3*v^3 + v");
/// assert_eq!(curve.length().unwrap(), Fraction::from(Poly::constant(ratio(4, 3))));
/// assert_eq!(curve.curvature().unwrap().to_string(), "2/(v^2 + 1)^2");
/// ```
#[derive(Clone, Debug)]
pub struct Curve {
    parameter: Variable,
    position: Vector,
    hodograph: Vector,
    speed: Result<Fraction, CurveError>,
    /// What must be positive for the speed to be that, where symbols decide it.
    speed_condition: Option<Poly>,
    preimage: Option<[Poly; 2]>,
    quaternion: Option<Quaternion>,
    rotation: Option<Complex>,
    known_arclength: Option<Fraction>,
    domain: Option<Interval>,
    calculus: Rc<Calculus>,
    axis: OnceCell<Result<Vector, CurveError>>,
    arclength: OnceCell<Result<Fraction, CurveError>>,
    frames: Frames,
}

/// The frames of a curve that have been asked for.
#[derive(Clone, Debug, Default)]
pub(crate) struct Frames {
    pub(crate) euler_rodrigues: OnceCell<Result<AdaptedFrame, CurveError>>,
    pub(crate) rotation_minimizing: OnceCell<Result<AdaptedFrame, CurveError>>,
    pub(crate) frenet: OnceCell<Result<AdaptedFrame, CurveError>>,
}

/// What is known of a curve's parametric speed before it is computed.
#[derive(Clone, Debug, Default)]
pub struct KnownProperties {
    /// A rational function whose square is `|s'|²`; it is checked.
    pub speed: Option<Fraction>,
    /// The arc length from the start, as a symbol of the calculus.
    pub arclength: Option<Fraction>,
    /// Real and imaginary part of the preimage `w` of a planar PH curve.
    pub preimage: Option<[Poly; 2]>,
    /// The preimage `A` of a spatial PH curve, with `s' = A i A*`.
    pub quaternion: Option<Quaternion>,
    /// A complex polynomial `W` for which the Euler–Rodrigues frame of `A·W` may be rotation-minimizing; it is checked.
    pub rotation: Option<Complex>,
}

impl Curve {
    /// The curve `position` over the closed interval `domain` of `parameter` (from 0 on if there is none).
    /// A property that the curve does not have is reported when it is asked for.
    #[must_use]
    pub fn new(
        parameter: &Variable,
        position: Vector,
        domain: Option<Interval>,
        known: KnownProperties,
        calculus: Rc<Calculus>,
    ) -> Curve {
        let hodograph = calculus.vector_derivative(&position, parameter);
        let squared = hodograph.norm2().reduced();
        let speed = match known.speed.filter(|speed| speed * speed == squared) {
            Some(speed) => Ok(speed),
            None => rational_root(&squared),
        };
        let mut speed = speed.map(|speed| {
            let interval = domain.clone().unwrap_or_else(Interval::unit);
            let negative = sample_sign(&speed, parameter, &interval).is_lt();
            if negative { -&speed } else { speed }
        });
        let of_planar = known.preimage.as_ref().map(|[a, b]| a * a + b * b);
        let norm = known.quaternion.as_ref().map(|quaternion| quaternion.norm2().numerator().clone());
        let sign = speed
            .as_ref()
            .map(|speed| speed_sign(speed, of_planar.or(norm).as_ref(), parameter, domain.as_ref()));
        let mut speed_condition = None;
        match sign {
            Ok(SpeedSign::Changes(factor)) => {
                speed = Err(CurveError::SpeedChangesSign { factor: Box::new(factor) });
            }
            Ok(SpeedSign::Depends(condition)) => speed_condition = Some(condition),
            Ok(SpeedSign::Nonnegative) | Err(_) => {}
        }
        Curve {
            parameter: parameter.clone(),
            position,
            hodograph,
            speed,
            speed_condition,
            preimage: known.preimage,
            quaternion: known.quaternion,
            rotation: known.rotation.filter(|rotation| !rotation.is_zero()),
            known_arclength: known.arclength,
            domain,
            calculus,
            axis: OnceCell::new(),
            arclength: OnceCell::new(),
            frames: Frames::default(),
        }
    }

    /// The parameter.
    #[must_use]
    pub fn parameter(&self) -> &Variable {
        &self.parameter
    }

    /// The position vector.
    #[must_use]
    pub fn position(&self) -> &Vector {
        &self.position
    }

    /// Real and imaginary part `a`, `b` of the preimage `w`, if the curve was made from one: `s' = h·w²`.
    #[must_use]
    pub fn preimage(&self) -> Option<&[Poly; 2]> {
        self.preimage.as_ref()
    }

    /// The preimage `A` of a spatial PH curve, if the curve was made from one: `s' = A i A*`.
    #[must_use]
    pub fn quaternion(&self) -> Option<&Quaternion> {
        self.quaternion.as_ref()
    }

    /// The rotation that the curve was made with, from its Euler–Rodrigues frame to what may be the rotation-minimizing one.
    pub(crate) fn known_rotation(&self) -> Option<&Complex> {
        self.rotation.as_ref()
    }

    /// The interval of the parameter, if one is stated.
    #[must_use]
    pub fn domain(&self) -> Option<&Interval> {
        self.domain.as_ref()
    }

    pub(crate) fn calculus(&self) -> &Calculus {
        &self.calculus
    }

    pub(crate) fn frames(&self) -> &Frames {
        &self.frames
    }

    /// What is known of the curve with scalars in place of symbols; nothing where a denominator vanishes.
    #[must_use]
    pub fn known_for(&self, values: &BTreeMap<Variable, Fraction>) -> KnownProperties {
        let at = |f: &Fraction| f.substitute(values);
        let poly = |poly: &Poly| at(&poly.clone().into()).and_then(|value| value.to_poly());
        KnownProperties {
            speed: self.speed.as_ref().ok().and_then(at),
            arclength: self.known_arclength.as_ref().and_then(at),
            preimage: self.preimage.as_ref().and_then(|[a, b]| Some([poly(a)?, poly(b)?])),
            quaternion: self.quaternion.as_ref().and_then(|quaternion| {
                let [w, x, y, z] = quaternion.components().each_ref().map(at);
                Some(Quaternion::new(w?, x?, y?, z?))
            }),
            // What is only a candidate needs no more than real factors.
            rotation: self.rotation.as_ref().and_then(|rotation| {
                let (re, im) = (at(&rotation.re.clone().into())?, at(&rotation.im.clone().into())?);
                Some(Complex::over_common_denominator(&re, &im))
            }),
        }
    }

    /// The hodograph: the derivative by the parameter.
    #[must_use]
    pub fn hodograph(&self) -> &Vector {
        &self.hodograph
    }

    /// The parametric speed `σ = |s'|` (FN (2)): not negative on the domain, or for all values of the parameter where there
    /// is none; see [`Curve::speed_condition`] where symbols occur in it.
    ///
    /// # Errors
    /// [`CurveError::Point`], [`CurveError::IrrationalSpeed`], [`CurveError::SpeedChangesSign`].
    pub fn speed(&self) -> Result<Fraction, CurveError> {
        self.speed.clone()
    }

    /// The polynomial in symbols or unknown functions that must be positive for [`Curve::speed`] to be `+|s'|`; `None` where
    /// that is certain.
    #[must_use]
    pub fn speed_condition(&self) -> Option<&Poly> {
        self.speed_condition.as_ref()
    }

    /// The unit tangent `t = s'/σ` (FN (3)), with σ as its denominator.
    ///
    /// # Errors
    /// As for [`Curve::speed`].
    pub fn tangent(&self) -> Result<Vector, CurveError> {
        let speed = self.speed()?;
        let known: Vec<Poly> = speed.numerator().squarefree().factors.into_iter().map(|(f, _)| f).collect();
        let reciprocal = speed.reciprocal(&known).ok_or(CurveError::Point)?;
        Ok(self.hodograph.scale(&reciprocal))
    }

    /// The unit vector `e` orthogonal to the plane in which the curve lies: its last component other than zero is positive;
    /// where symbols decide on that, its first term is. A radical may be adjoined.
    ///
    /// A straight line lies in many planes: that coordinate plane counts in which it lies, else one to which it is parallel;
    /// xy before xz before yz.
    ///
    /// # Errors
    /// [`CurveError::Point`], [`CurveError::NotPlanar`], [`CurveError::Line`], [`CurveError::IrrationalPlane`].
    ///
    /// # Example
    /// ```
    /// use hodograph_algebra::{Curve, Fraction, KnownProperties, Poly, Variable, Vector, integer};
    /// let v = Variable::new(1, "v");
    /// let scaled = |poly: Poly, factor: i64| Fraction::from(poly.scale(&integer(factor)));
    /// let [t, square] = [1, 2].map(|n| Poly::variable(&v).pow(n));
    /// let position = Vector::new(scaled(t.clone(), 3), scaled(square, 1), scaled(t, 4));
    /// let curve = Curve::new(&v, position, None, KnownProperties::default(), Default::default());
    /// assert_eq!(curve.axis().unwrap().to_string(), "(-4/5, 0, 3/5)");
    /// ```
    pub fn axis(&self) -> Result<Vector, CurveError> {
        let axis = self.axis.get_or_init(|| {
            let functions = self.hodograph.components().iter().flat_map(Fraction::occurring_variables);
            let mut moving = vec![self.parameter.clone()];
            moving.extend(functions.filter(|variable| self.calculus.is_function(variable)));
            moving.sort();
            moving.dedup();
            plane::axis(&self.position, &self.hodograph, &moving)
        });
        axis.clone()
    }

    /// The unit normal `n = t × e` (FN (3)).
    ///
    /// # Errors
    /// As for [`Curve::speed`] and [`Curve::axis`].
    pub fn normal(&self) -> Result<Vector, CurveError> {
        Ok(self.tangent()?.cross(&self.axis()?))
    }

    /// The signed curvature `κ = (s' × s'')·e / σ³` (FN (5)).
    ///
    /// # Errors
    /// As for [`Curve::normal`].
    pub fn curvature(&self) -> Result<Fraction, CurveError> {
        let second = self.calculus.vector_derivative(&self.hodograph, &self.parameter);
        let turning = self.hodograph.cross(&second).dot(&self.axis()?).reduced();
        let known: Vec<Poly> = turning.factors().iter().map(|(factor, _)| factor.clone()).collect();
        let inverse = self.speed()?.reciprocal(&known).ok_or(CurveError::Point)?;
        Ok((&turning * &inverse.pow(3)).reduced())
    }

    /// The arc length `∫σ` from the beginning of the domain (FN (6)), or from 0 to the first pole if there is none; symbols
    /// have general values (see [`Fraction::integral`]).
    ///
    /// # Errors
    /// As for [`Curve::speed`]; [`CurveError::ArcLength`] if it is not a rational function, [`CurveError::UnknownArcLength`],
    /// [`CurveError::Pole`].
    ///
    /// # Example
    /// A straight line in a rational parameter:
    /// ```
    /// use hodograph_algebra::{Curve, Fraction, Interval, KnownProperties, Poly, Variable, Vector, integer};
    /// let v = Variable::new(1, "v");
    /// let t = Poly::variable(&v);
    /// let x = Fraction::new(t.pow(2) - Poly::one(), [(t, 1)]);
    /// let line = Vector::new(x, Fraction::zero(), Fraction::zero());
    /// let domain = Interval::new(Poly::one(), Poly::integer(3));
    /// let line = Curve::new(&v, line, domain, KnownProperties::default(), Default::default());
    /// assert_eq!(line.speed().unwrap().to_string(), "(v^2 + 1)/v^2");
    /// assert_eq!(line.arclength().unwrap().to_string(), "(v^2 - 1)/v");
    /// assert_eq!(line.length().unwrap().to_string(), "8/3");
    /// ```
    pub fn arclength(&self) -> Result<Fraction, CurveError> {
        match &self.known_arclength {
            Some(known) => Ok(known.clone()),
            None => self.arclength.get_or_init(|| self.integrated_speed()).clone(),
        }
    }

    fn integrated_speed(&self) -> Result<Fraction, CurveError> {
        let speed = self.speed()?.reduced();
        if speed.occurring_variables().iter().any(|variable| self.calculus.is_function(variable)) {
            return Err(CurveError::UnknownArcLength { speed: Box::new(speed) });
        }
        let speed = speed.lowest_terms();
        if let Some(factor) = self.pole(&speed) {
            return Err(CurveError::Pole { factor: Box::new(factor) });
        }
        let integral = speed.integral(&self.parameter);
        if !integral.is_rational() {
            let remainder = Box::new(integral.remainder);
            return Err(CurveError::ArcLength { speed: Box::new(speed), remainder });
        }
        let start = self.domain.as_ref().map_or_else(Poly::zero, |domain| domain.lower().clone());
        Ok((&integral.rational - &self.at(&integral.rational, start)?).reduced())
    }

    /// The value of a function of the parameter.
    fn at(&self, f: &Fraction, value: Poly) -> Result<Fraction, CurveError> {
        let values = [(self.parameter.clone(), Fraction::from(value))].into();
        // The denominator of an integral has the zeros of that of the integrand, at which symbols may place a pole.
        let pole = || CurveError::Pole { factor: Box::new(f.denominator()) };
        f.substitute(&values).ok_or_else(pole)
    }

    /// A factor of the denominator that vanishes on the domain, or at 0 where there is none; those with symbols are taken
    /// not to vanish.
    fn pole(&self, speed: &Fraction) -> Option<Poly> {
        let vanishes = |factor: &Poly| match &self.domain {
            Some(domain) => {
                factor.real_roots_in(&self.parameter, domain).is_some_and(|roots| !roots.is_empty())
            }
            None => factor.substitute(&self.parameter, &Poly::zero()).is_zero(),
        };
        speed.factors().iter().map(|(factor, _)| factor).find(|factor| vanishes(factor)).cloned()
    }

    /// The total arc length over the domain.
    ///
    /// # Errors
    /// As for [`Curve::arclength`], and [`CurveError::NoDomain`].
    pub fn length(&self) -> Result<Fraction, CurveError> {
        let end = self.domain.as_ref().ok_or(CurveError::NoDomain)?.upper().clone();
        self.at(&self.arclength()?, end)
    }

    /// The involute `c = s − s(v)·t` (FN (24)).
    ///
    /// # Errors
    /// As for [`Curve::arclength`].
    pub fn involute(&self) -> Result<Vector, CurveError> {
        Ok(&self.position - &self.tangent()?.scale(&self.arclength()?))
    }

    /// The evolute `e = s − n/κ` (FN (28)).
    ///
    /// # Errors
    /// As for [`Curve::curvature`], and [`CurveError::Straight`].
    pub fn evolute(&self) -> Result<Vector, CurveError> {
        let radius = self.curvature()?.reciprocal(&[]).ok_or(CurveError::Straight)?;
        Ok(&self.position - &self.normal()?.scale(&radius).reduced())
    }

    /// The offset curve `s + d·n` at the signed distance `d` (FN (8)).
    ///
    /// # Errors
    /// As for [`Curve::normal`].
    pub fn offset(&self, distance: &Fraction) -> Result<Vector, CurveError> {
        Ok(&self.position + &self.normal()?.scale(distance))
    }
}

/// What is known of the sign of a rational root of `|s'|²`.
enum SpeedSign {
    Nonnegative,
    /// It is that of this polynomial in symbols or unknown functions.
    Depends(Poly),
    /// This factor changes its sign on the domain.
    Changes(Poly),
}

/// The sign of a rational root of `|s'|²`, which is positive somewhere; for `h·|w|²`, with
/// the norm `|w|²` of a preimage, it is that of `h`. Factors whose sign is
/// known decide on nothing.
fn speed_sign(
    speed: &Fraction,
    norm: Option<&Poly>,
    parameter: &Variable,
    domain: Option<&Interval>,
) -> SpeedSign {
    let odd = speed.factors().iter().filter(|(_, exponent)| exponent % 2 == 1);
    let signed = odd.fold(speed.numerator().clone(), |product, (factor, _)| product * factor);
    let of_factor = norm.and_then(|norm| signed.exact_div(norm));
    let parts = of_factor.unwrap_or(signed).squarefree();
    let mut open = parts.unit;
    for (factor, multiplicity) in parts.factors {
        if multiplicity % 2 == 0 || is_sum_of_even_powers(&factor) {
            continue;
        }
        if factor.occurring_variables().iter().any(|variable| variable != parameter) {
            open *= factor;
            continue;
        }
        match sign_in(&factor, parameter, domain) {
            Some(Ordering::Less) => open = -open,
            Some(_) => {}
            None => return SpeedSign::Changes(factor),
        }
    }
    if open.is_constant() { SpeedSign::Nonnegative } else { SpeedSign::Depends(open.primitive()) }
}

/// The sign of a polynomial in the parameter on the domain, or everywhere if there is none, where zeros without a change of
/// sign do not count; `None` if it changes.
fn sign_in(poly: &Poly, parameter: &Variable, domain: Option<&Interval>) -> Option<Ordering> {
    let Some(domain) = domain else {
        let roots = poly.real_roots(parameter)?;
        let changes = roots.iter().any(|root| root.multiplicity() % 2 == 1);
        return (!changes).then(|| poly.leading_coefficient().sign());
    };
    match poly.sign_on(&[(parameter.clone(), domain.clone())])? {
        BoxSign::Positive | BoxSign::NonNegative { .. } => Some(Ordering::Greater),
        BoxSign::Negative | BoxSign::NonPositive { .. } => Some(Ordering::Less),
        _ => None,
    }
}

/// Whether all exponents are even and all coefficients positive, so that the polynomial is nowhere negative.
fn is_sum_of_even_powers(poly: &Poly) -> bool {
    let rational = poly.ring().field().generators().is_empty() || poly.generator_coefficients().len() == 1;
    let even = |term: &Term| {
        poly.ring().exponents(term.monomial).iter().all(|exponent| exponent % 2 == 0)
            && (&Rational::from(term.coefficient.clone()) * poly.content()).is_positive()
    };
    rational && poly.terms().iter().all(even)
}

/// The square root of a rational function, if it is rational over the real numbers; a radical may be adjoined.
///
/// # Errors
/// [`CurveError::Point`] for zero, else [`CurveError::IrrationalSpeed`].
pub fn rational_root(squared: &Fraction) -> Result<Fraction, CurveError> {
    if squared.is_zero() {
        return Err(CurveError::Point);
    }
    // √(n/Πf^e) = √(n·Πf)/Πf^((e+1)/2), the product over the factors of odd exponent.
    let odd_factors = squared.factors().iter().filter(|(_, exponent)| exponent % 2 == 1);
    let numerator = odd_factors.fold(squared.numerator().clone(), |product, (factor, _)| product * factor);
    let split = numerator.square_split();
    let irrational = || CurveError::IrrationalSpeed {
        squared: Box::new(squared.clone()),
        odd: Box::new(split.odd.clone()),
    };
    if !split.is_square() {
        return Err(irrational());
    }
    let unit = split.unit.sqrt().ok_or_else(irrational)?;
    let factors = squared.factors().iter().map(|(factor, exponent)| (factor.clone(), exponent.div_ceil(2)));
    Ok(Fraction::new(&split.root * unit, factors))
}

/// The general regular planar curve in the xy-plane, in its moving frame: parametric speed `sigma` and curvature `kappa`
/// are unknown functions of the parameter.
///
/// The tangent is `((1 − m²)/(1 + m²), 2m/(1 + m²))` with `m` the tangent of half its angle, so that `m' = σκ(1 + m²)/2`;
/// position and arc length are symbols with `s' = σt` and `s' = σ`. An identity of rational functions that holds for
/// these symbols holds for every regular curve (FN (4)).
pub fn moving_frame_curve(
    name: &str,
    parameter: &Variable,
    sigma: &Fraction,
    kappa: &Fraction,
    calculus: &mut Calculus,
) -> (Vector, KnownProperties) {
    let half_angle = Variable::new(Variable::SYMBOL, &format!("{name}_m"));
    let m = Fraction::from(Poly::variable(&half_angle));
    let weight = Poly::variable(&half_angle).pow(2) + Poly::one();
    let turning = &(&(sigma * kappa) * &Fraction::from(weight.clone())) * &ratio(1, 2);
    calculus.symbol_with_derivative(half_angle.name(), parameter, turning);
    let over_weight = Fraction::new(Poly::one(), [(weight, 1)]);
    let cosine = &(&Fraction::one() - &(&m * &m)) * &over_weight;
    let sine = &(&m + &m) * &over_weight;
    let mut coordinate = |suffix: &str, derivative: Fraction| {
        Fraction::from(calculus.symbol_with_derivative(&format!("{name}_{suffix}"), parameter, derivative))
    };
    let x = coordinate("x", sigma * &cosine);
    let y = coordinate("y", sigma * &sine);
    let arclength = coordinate("arclength", sigma.clone());
    let known = KnownProperties {
        speed: Some(sigma.clone()),
        arclength: Some(arclength),
        ..KnownProperties::default()
    };
    (Vector::new(x, y, Fraction::zero()), known)
}
