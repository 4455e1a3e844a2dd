//! Exact evaluation: what the evaluators' floats are measured with.

use std::collections::BTreeMap;

use hodograph_algebra::{Derivation, Poly, Rational};
use hodograph_codegen::round::exact;

use crate::fixed::{BITS, Fixed};

/// A polynomial in the parameters with its coefficients enclosed.
#[derive(Clone, Debug)]
struct Enclosed {
    exact: Poly,
    /// By the exponents of u, then of v.
    coefficients: BTreeMap<u32, BTreeMap<u32, Fixed>>,
}

/// A derived surface, ready to be evaluated.
#[derive(Clone, Debug)]
pub struct Oracle<'a> {
    derivation: &'a Derivation,
    homogeneous: [Enclosed; 4],
    along_u: [Enclosed; 4],
    along_v: [Enclosed; 4],
    normal: [Enclosed; 3],
    singular: Enclosed,
}

/// What a surface is at one pair of parameters: intervals that enclose the exact numbers, far narrower than the step
/// between floats.
#[derive(Clone, Debug)]
pub struct Truth {
    /// W, X, Y, Z.
    pub homogeneous: [Fixed; 4],
    /// R.
    pub point: [Fixed; 3],
    /// R_u.
    pub partial_u: [Fixed; 3],
    /// R_v.
    pub partial_v: [Fixed; 3],
    /// ‖R_u‖.
    pub speed_u: Fixed,
    /// ‖R_v‖.
    pub speed_v: Fixed,
    /// The unit normal; `None` exactly where R_u × R_v vanishes.
    pub unit_normal: Option<[Fixed; 3]>,
}

impl<'a> Oracle<'a> {
    /// The oracle for a derived surface without symbols.
    #[must_use]
    pub fn new(derivation: &'a Derivation) -> Oracle<'a> {
        let enclosed = |poly: &Poly| Enclosed::new(poly, derivation);
        let homogeneous = derivation.homogeneous.coordinates();
        let along = |variable| homogeneous.each_ref().map(|poly| enclosed(&poly.derivative(variable)));
        let [u, v] = &derivation.parameters;
        Oracle {
            derivation,
            homogeneous: homogeneous.each_ref().map(enclosed),
            along_u: along(u),
            along_v: along(v),
            normal: derivation.normal.numerator().each_ref().map(enclosed),
            singular: enclosed(&derivation.singular.factor),
        }
    }

    /// The surface at the very numbers that the floats `u` and `v` are.
    ///
    /// # Panics
    /// If one of them is not finite, and at a pole of the surface.
    #[must_use]
    pub fn at(&self, u: f64, v: f64) -> Truth {
        let place = Place::new(u, v);
        let homogeneous = self.homogeneous.each_ref().map(|poly| poly.at(&place));
        let [weight, coordinates @ ..] = &homogeneous;
        let point = coordinates.each_ref().map(|x| x.div(weight));
        // (X/W)' = (X' − (X/W)·W')/W
        let partial = |along: &[Enclosed; 4]| -> [Fixed; 3] {
            let [slope, along @ ..] = along.each_ref().map(|poly| poly.at(&place));
            std::array::from_fn(|i| along[i].sub(&point[i].mul(&slope)).div(weight))
        };
        let (partial_u, partial_v) = (partial(&self.along_u), partial(&self.along_v));
        let unit_normal = self.is_regular(&place).then(|| {
            let cross = cross(&partial_u, &partial_v);
            let length = norm(&cross);
            cross.map(|component| component.div(&length))
        });
        let (speed_u, speed_v) = (norm(&partial_u), norm(&partial_v));
        Truth { homogeneous, point, partial_u, partial_v, speed_u, speed_v, unit_normal }
    }

    /// Whether R_u × R_v does not vanish: decided in the number field where enclosures hold zero.
    fn is_regular(&self, place: &Place) -> bool {
        let vanishes = |poly: &Enclosed| {
            poly.at(place).contains_zero() && self.exact(&poly.exact, &place.u.0, &place.v.0).is_zero()
        };
        !vanishes(&self.singular) && !self.normal.iter().all(vanishes)
    }

    /// The number of the field that `poly` is at (u, v).
    #[must_use]
    pub fn exact(&self, poly: &Poly, u: &Rational, v: &Rational) -> Poly {
        let [first, second] = &self.derivation.parameters;
        poly.at(&[(first, u), (second, v)])
    }

    /// The homogeneous coordinates in the number field: what [`Oracle::at`] encloses, by another way.
    ///
    /// # Panics
    /// If a parameter is not finite.
    #[must_use]
    pub fn homogeneous_in_field(&self, u: f64, v: f64) -> [Poly; 4] {
        let place = Place::new(u, v);
        self.homogeneous.each_ref().map(|poly| self.exact(&poly.exact, &place.u.0, &place.v.0))
    }
}

/// A pair of parameters, exactly and enclosed.
struct Place {
    u: (Rational, Fixed),
    v: (Rational, Fixed),
}

impl Place {
    fn new(u: f64, v: f64) -> Place {
        let [u, v] = [u, v].map(|float| {
            let number = exact(float).unwrap_or_else(|| panic!("the parameter {float} is no number"));
            let fixed = Fixed::of(&number);
            (number, fixed)
        });
        Place { u, v }
    }
}

impl Enclosed {
    fn new(poly: &Poly, derivation: &Derivation) -> Enclosed {
        let mut coefficients: BTreeMap<u32, BTreeMap<u32, Fixed>> = BTreeMap::new();
        for (exponents, coefficient) in poly.coefficients_of(&derivation.parameters) {
            let row = coefficients.entry(exponents[0]).or_default();
            row.insert(exponents[1], Fixed::around(&coefficient.enclosure(BITS)));
        }
        Enclosed { exact: poly.clone(), coefficients }
    }

    fn at(&self, place: &Place) -> Fixed {
        let row = |row: &BTreeMap<u32, Fixed>| horner(row.iter().map(|(i, c)| (*i, c.clone())), &place.v.1);
        horner(self.coefficients.iter().map(|(i, coefficients)| (*i, row(coefficients))), &place.u.1)
    }
}

/// Σ cᵢ·tⁱ for the pairs (i, cᵢ), by increasing exponents.
fn horner(terms: impl DoubleEndedIterator<Item = (u32, Fixed)>, t: &Fixed) -> Fixed {
    let (mut sum, mut at) = (Fixed::zero(), 0);
    for (exponent, coefficient) in terms.rev() {
        sum = (exponent..at).fold(sum, |sum, _| sum.mul(t)).add(&coefficient);
        at = exponent;
    }
    (0..at).fold(sum, |sum, _| sum.mul(t))
}

impl Truth {
    /// The point R + r·N of the offset at the distance `r`, where the surface is regular.
    ///
    /// # Panics
    /// If `r` is not finite.
    #[must_use]
    pub fn offset_point(&self, r: f64) -> Option<[Fixed; 3]> {
        let r = Fixed::of(&exact(r).unwrap_or_else(|| panic!("the distance {r} is no number")));
        let normal = self.unit_normal.as_ref()?;
        Some(std::array::from_fn(|i| self.point[i].add(&normal[i].mul(&r))))
    }
}

/// The largest distance of `float` from a number in `truth`; infinite for NaN and infinities.
#[must_use]
pub fn error(float: f64, truth: &Fixed) -> f64 {
    exact(float).map_or(f64::INFINITY, |float| truth.distance(&float))
}

fn cross(a: &[Fixed; 3], b: &[Fixed; 3]) -> [Fixed; 3] {
    let minor = |i: usize, j: usize| a[i].mul(&b[j]).sub(&a[j].mul(&b[i]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

fn norm(vector: &[Fixed; 3]) -> Fixed {
    vector.iter().fold(Fixed::zero(), |sum, x| sum.add(&x.mul(x))).sqrt()
}
