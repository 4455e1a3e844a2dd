//! Rational curves, and what their parametric speed makes of them.

use std::fmt;
use std::rc::Rc;

use super::calculus::Calculus;
use super::sample::sample_sign;
use super::vector::Vector;
use num_traits::Signed;

use crate::{BoxSign, Fraction, Interval, Poly, Rational, Term, Variable, ratio};

/// A rational curve with its derivative properties, where these are rational.
///
/// Any curve whose parametric speed is a rational function offers its unit tangent and normal, curvature, offsets,
/// involute and evolute; whether it is one is decided by a perfect-square test on `|s'|²`, however the curve was made.
///
/// Planar curves lie in a coordinate plane; `e` is the unit vector of the third axis (**k** for the xy-plane, **j** for
/// the xz-plane, **i** for the yz-plane). The normal is `n = t × e` (FN (3)): it points to the right of the tangent, away
/// from the center of curvature where the curvature is positive.
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
    arclength: Option<Fraction>,
    preimage: Option<[Poly; 2]>,
    domain: Option<Interval>,
    calculus: Rc<Calculus>,
}

/// Why a curve does not have a property.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum CurveError {
    /// The curve is a point: its derivative is zero.
    Point,
    /// `|s'|²` is not the square of a rational function.
    IrrationalSpeed {
        /// `|s'|²`.
        squared: Box<Fraction>,
        /// The factor of it that is no square; 1 if only the sign is wrong.
        odd: Box<Poly>,
    },
    /// The rational root of `|s'|²` changes its sign on the domain, so its absolute value is not rational.
    SpeedChangesSign {
        /// The factor of the root that changes its sign.
        factor: Box<Poly>,
    },
    /// The curve lies in none of the coordinate planes, so it has no planar normal.
    NotPlanar,
    /// The integral of the parametric speed is not known to be a rational function.
    ArcLength {
        /// The parametric speed.
        speed: Box<Fraction>,
    },
    /// The curvature is zero everywhere: a straight line has no evolute.
    Straight,
    /// No domain is stated for the parameter, so that a property at its end is not defined.
    NoDomain,
}

impl fmt::Display for CurveError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CurveError::Point => f.write_str("the curve is a single point: its derivative is zero"),
            CurveError::IrrationalSpeed { squared, odd } => {
                write!(f, "the parametric speed is not rational: |s'|^2 = {squared}")?;
                if odd.is_one() { Ok(()) } else { write!(f, ", in which {odd} is not a square") }
            }
            CurveError::SpeedChangesSign { factor } => {
                write!(
                    f,
                    "the parametric speed is not rational on this domain: its factor {factor} changes its sign there"
                )
            }
            CurveError::NotPlanar => f.write_str("the curve lies in none of the coordinate planes"),
            CurveError::ArcLength { speed } => {
                write!(f, "no rational arc length is known: the parametric speed {speed} is not a polynomial")
            }
            CurveError::Straight => f.write_str("the curvature is zero everywhere, so there is no evolute"),
            CurveError::NoDomain => f.write_str("no domain is stated for the curve's parameter"),
        }
    }
}

impl std::error::Error for CurveError {}

/// What is known of a curve's parametric speed before it is computed.
#[derive(Clone, Debug, Default)]
pub struct KnownProperties {
    /// A rational function whose square is `|s'|²`; it is checked.
    pub speed: Option<Fraction>,
    /// The arc length from the start, as a symbol of the calculus.
    pub arclength: Option<Fraction>,
    /// Real and imaginary part of the preimage `w` of a planar PH curve.
    pub preimage: Option<[Poly; 2]>,
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
        let sign = speed
            .as_ref()
            .map(|speed| speed_sign(speed, known.preimage.as_ref(), parameter, domain.as_ref()));
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
            arclength: known.arclength,
            preimage: known.preimage,
            domain,
            calculus,
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

    /// The axis orthogonal to the coordinate plane in which the curve lies; the xy-plane comes first.
    ///
    /// # Errors
    /// [`CurveError::NotPlanar`].
    pub fn axis(&self) -> Result<Vector, CurveError> {
        let [x, y, z] = self.position.components();
        let axis = [(z, 2), (y, 1), (x, 0)].into_iter().find(|(component, _)| component.is_zero());
        axis.map(|(_, axis)| Vector::unit(axis)).ok_or(CurveError::NotPlanar)
    }

    /// The unit normal `n = t × e` (FN (3)).
    ///
    /// # Errors
    /// As for [`Curve::speed`], and [`CurveError::NotPlanar`].
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
        let cube = self.speed()?.pow(3);
        Ok(turning.checked_div(&cube).ok_or(CurveError::Point)?.reduced())
    }

    /// The arc length `∫σ` from the beginning of the domain (FN (6)).
    ///
    /// # Errors
    /// As for [`Curve::speed`], and [`CurveError::ArcLength`] if σ is not a polynomial in the parameter.
    pub fn arclength(&self) -> Result<Fraction, CurveError> {
        if let Some(known) = &self.arclength {
            return Ok(known.clone());
        }
        let speed = self.speed()?.reduced();
        if speed.factors().iter().any(|(factor, _)| factor.contains(&self.parameter)) {
            return Err(CurveError::ArcLength { speed: Box::new(speed) });
        }
        let integral = speed.numerator().integral(&self.parameter);
        let start = self.domain.as_ref().map_or_else(Poly::zero, |domain| domain.lower().clone());
        let from_start = &integral - integral.substitute(&self.parameter, &start);
        Ok(Fraction::new(from_start, speed.factors().iter().cloned()))
    }

    /// The total arc length over the domain.
    ///
    /// # Errors
    /// As for [`Curve::arclength`], and [`CurveError::NoDomain`].
    pub fn length(&self) -> Result<Fraction, CurveError> {
        let end = self.domain.as_ref().ok_or(CurveError::NoDomain)?.upper().clone();
        let values = [(self.parameter.clone(), Fraction::from(end))].into();
        self.arclength()?.substitute(&values).ok_or(CurveError::Point)
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

/// The sign of a rational root of `|s'|²`; for `h·|w|²` it is that of `h`.
fn speed_sign(
    speed: &Fraction,
    preimage: Option<&[Poly; 2]>,
    parameter: &Variable,
    domain: Option<&Interval>,
) -> SpeedSign {
    let odd = speed.factors().iter().filter(|(_, exponent)| exponent % 2 == 1);
    let signed = odd.fold(speed.numerator().clone(), |product, (factor, _)| product * factor);
    let of_factor = preimage.and_then(|[a, b]| signed.exact_div(&(a * a + b * b)));
    let signed = of_factor.unwrap_or(signed);
    if is_sum_of_even_powers(&signed) {
        return SpeedSign::Nonnegative;
    }
    if signed.occurring_variables().iter().any(|variable| variable != parameter) {
        return SpeedSign::Depends(signed.primitive());
    }
    let nonnegative = match domain {
        Some(domain) => {
            let sign = signed.sign_on(&[(parameter.clone(), domain.clone())]);
            matches!(sign, Some(BoxSign::Positive | BoxSign::NonNegative { .. }))
        }
        // Without a domain the sign must hold everywhere: no root of odd multiplicity.
        None => signed
            .real_roots(parameter)
            .is_some_and(|roots| roots.iter().all(|root| root.multiplicity() % 2 == 0)),
    };
    if nonnegative { SpeedSign::Nonnegative } else { SpeedSign::Changes(signed.primitive()) }
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
    let known = KnownProperties { speed: Some(sigma.clone()), arclength: Some(arclength), preimage: None };
    (Vector::new(x, y, Fraction::zero()), known)
}
