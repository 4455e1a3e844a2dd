//! Exact evaluation: what the evaluators' floats are measured with.

use hodograph_algebra::{Derivation, Enclosure, Int, Poly, Rational};
use hodograph_codegen::round::exact;
use num_traits::{Signed, ToPrimitive, Zero};

/// The bits after the point of all enclosures; beside them no rounding error of an `f64` is visible.
const BITS: u64 = 256;

/// A derived surface, ready to be evaluated exactly.
#[derive(Clone, Debug)]
pub struct Oracle<'a> {
    derivation: &'a Derivation,
    homogeneous: Vec<Poly>,
    along_u: Vec<Poly>,
    along_v: Vec<Poly>,
    length: Option<Poly>,
}

/// What a surface is at one pair of parameters; every number is enclosed in an interval of width below 2⁻²⁰⁰.
#[derive(Clone, Debug)]
pub struct Truth {
    /// W, X, Y, Z.
    pub homogeneous: Vec<Enclosure>,
    /// R, unless W = 0.
    pub point: Vec<Enclosure>,
    /// R_u.
    pub partial_u: Vec<Enclosure>,
    /// R_v.
    pub partial_v: Vec<Enclosure>,
    /// ‖R_u‖.
    pub speed_u: Enclosure,
    /// ‖R_v‖.
    pub speed_v: Enclosure,
    /// The unit normal; `None` exactly where R_u × R_v vanishes.
    pub unit_normal: Option<Vec<Enclosure>>,
}

impl<'a> Oracle<'a> {
    /// The oracle for a derived surface without symbols.
    #[must_use]
    pub fn new(derivation: &'a Derivation) -> Oracle<'a> {
        let [u, v] = &derivation.parameters;
        let homogeneous = derivation.homogeneous.coordinates().to_vec();
        let along = |variable| homogeneous.iter().map(|poly| poly.derivative(variable)).collect();
        Oracle {
            derivation,
            along_u: along(u),
            along_v: along(v),
            length: derivation.normal.length(&derivation.parameters, &derivation.domain),
            homogeneous,
        }
    }

    /// The surface at the very numbers that the floats `u` and `v` are.
    ///
    /// # Panics
    /// If one of them is not finite, and at a pole of the surface.
    #[must_use]
    pub fn at(&self, u: f64, v: f64) -> Truth {
        let [u, v] = [u, v].map(|float| exact(float).expect("parameters are finite"));
        let [first, second] = &self.derivation.parameters;
        let number = |poly: &Poly| poly.at(&[(first, &u), (second, &v)]);
        let enclosures = |polys: &[Poly]| -> Vec<Enclosure> {
            polys.iter().map(|poly| number(poly).enclosure(BITS).rounded(BITS)).collect()
        };
        let homogeneous = enclosures(&self.homogeneous);
        let point = quotients(&homogeneous[1..], &homogeneous[0]);
        // (X/W)' = (X' − (X/W)·W')/W
        let partial = |along: &[Poly]| {
            let slopes = enclosures(along);
            let numerators: Vec<Enclosure> =
                slopes[1..].iter().zip(&point).map(|(slope, x)| slope.add(&negated(&x.mul(&slopes[0])))).collect();
            quotients(&numerators, &homogeneous[0])
        };
        let (partial_u, partial_v) = (partial(&self.along_u), partial(&self.along_v));
        let normal = &self.derivation.normal;
        let components = normal.numerator().each_ref().map(number);
        let regular = !number(&self.derivation.singular.factor).is_zero()
            && components.iter().any(|component| !component.is_zero());
        let unit_normal = regular.then(|| {
            let components = components.map(|component| component.enclosure(BITS));
            let length = match &self.length {
                Some(length) => number(length).enclosure(BITS),
                None => norm(&components),
            };
            quotients(&components, &length)
        });
        let (speed_u, speed_v) = (norm(&partial_u), norm(&partial_v));
        Truth { homogeneous, point, partial_u, partial_v, speed_u, speed_v, unit_normal }
    }
}

impl Truth {
    /// The point R + r·N of the offset at the distance `r`, where the surface is regular.
    ///
    /// # Panics
    /// If `r` is not finite.
    #[must_use]
    pub fn offset_point(&self, r: f64) -> Option<Vec<Enclosure>> {
        let r = exact(r).expect("the distance is finite");
        let normal = self.unit_normal.as_ref()?;
        Some(self.point.iter().zip(normal).map(|(x, n)| x.add(&n.scale(&r))).collect())
    }
}

/// The largest distance of `float` from a number in `truth`, rounded to an `f64`; infinite for NaN and infinities.
#[must_use]
pub fn error(float: f64, truth: &Enclosure) -> f64 {
    let Some(float) = exact(float) else { return f64::INFINITY };
    let distance = |end: &Rational| (&float - end).abs();
    let largest = distance(truth.lower()).max(distance(truth.upper()));
    to_f64(&largest)
}

/// The largest absolute value in `truth`.
#[must_use]
pub fn magnitude(truth: &Enclosure) -> f64 {
    to_f64(&truth.lower().abs().max(truth.upper().abs()))
}

/// The nearest `f64`, up to the resolution 2⁻²⁵⁶.
fn to_f64(number: &Rational) -> f64 {
    let scale = Int::from(1).shl(BITS);
    let scaled = (number * Rational::from(scale)).ceil().to_integer().to_big();
    scaled.to_f64().map_or(f64::INFINITY, |value| value / 2_f64.powi(BITS as i32))
}

fn negated(x: &Enclosure) -> Enclosure {
    Enclosure::new(-x.upper(), -x.lower())
}

fn quotients(numerators: &[Enclosure], denominator: &Enclosure) -> Vec<Enclosure> {
    assert!(!denominator.contains_zero(), "the parameters are those of a pole");
    let inverse = Enclosure::new(denominator.upper().recip(), denominator.lower().recip());
    numerators.iter().map(|numerator| numerator.mul(&inverse).rounded(BITS)).collect()
}

fn norm(vector: &[Enclosure]) -> Enclosure {
    let zero = Enclosure::exact(Rational::zero());
    let square = vector.iter().fold(zero, |sum, x| sum.add(&square(x)));
    square.sqrt(BITS)
}

/// The squares of the numbers in `x`.
fn square(x: &Enclosure) -> Enclosure {
    let product = x.mul(x);
    if x.contains_zero() { Enclosure::new(Rational::zero(), product.upper().clone()) } else { product }
}
