//! Exact evaluation: what the evaluators' floats are measured with.
//!
//! Everything follows from the derived homogeneous coordinates by the classical formulas of differential geometry, which are not
//! those of the programs: quotient rule, cross product, fundamental forms, Weingarten's equations.

use std::collections::BTreeMap;

use hodograph_algebra::{Derivation, Poly, Rational};
use hodograph_codegen::round::exact;
use hodograph_codegen::schedule::outputs;

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
    /// Derivatives of the homogeneous coordinates by u, by v, twice by u, by both, twice by v.
    derivatives: [[Enclosed; 4]; 5],
    normal: [Enclosed; 3],
    singular: Enclosed,
}

/// What a surface is at one pair of parameters: balls that hold the exact numbers, far narrower than the step between floats.
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
    /// R_uu, R_uv and R_vv.
    pub second: [[Fixed; 3]; 3],
    /// E, F, G.
    pub first_form: [Fixed; 3],
    /// ‖R_u‖ and ‖R_v‖.
    pub speeds: [Fixed; 2],
    /// What needs a normal; `None` exactly where R_u × R_v vanishes, or is too small for the enclosures.
    pub regular: Option<Regular>,
}

/// What a surface is at a regular point.
#[derive(Clone, Debug)]
pub struct Regular {
    /// The unit normal n on the side of R_u × R_v.
    pub unit_normal: [Fixed; 3],
    /// L, M, N.
    pub second_form: [Fixed; 3],
    /// K.
    pub gaussian: Fixed,
    /// H.
    pub mean: Fixed,
    /// k₁ ≥ k₂.
    pub principal: [Fixed; 2],
    /// n_u.
    pub normal_u: [Fixed; 3],
    /// n_v.
    pub normal_v: [Fixed; 3],
}

impl<'a> Oracle<'a> {
    /// The oracle for a derived surface without symbols.
    #[must_use]
    pub fn new(derivation: &'a Derivation) -> Oracle<'a> {
        let enclosed = |poly: &Poly| Enclosed::new(poly, derivation);
        let homogeneous = derivation.homogeneous.coordinates();
        let geometry = derivation.geometry.as_ref().expect("the budget suffices for the catalogue's normals");
        let [u, v] = &derivation.parameters;
        let along = |first: &_| homogeneous.each_ref().map(|poly| poly.derivative(first));
        let [along_u, along_v] = [along(u), along(v)];
        let again = |along: &[Poly; 4], second: &_| along.each_ref().map(|poly| poly.derivative(second));
        let second = [again(&along_u, u), again(&along_u, v), again(&along_v, v)];
        let [uu, uv, vv] = second.each_ref().map(|polys| polys.each_ref().map(enclosed));
        Oracle {
            derivation,
            homogeneous: homogeneous.each_ref().map(enclosed),
            derivatives: [along_u.each_ref().map(enclosed), along_v.each_ref().map(enclosed), uu, uv, vv],
            normal: geometry.normal.numerator().each_ref().map(enclosed),
            singular: enclosed(&geometry.singular.factor),
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
        let over = |number: &Fixed| {
            number.div(weight).unwrap_or_else(|| panic!("the surface has a pole at ({u}, {v})"))
        };
        let point = coordinates.each_ref().map(over);
        let [along_u, along_v, along_uu, along_uv, along_vv] =
            self.derivatives.each_ref().map(|polys| polys.each_ref().map(|poly| poly.at(&place)));
        // X = W·x, so that X_u = W_u·x + W·x_u and X_uv = W_uv·x + W_u·x_v + W_v·x_u + W·x_uv.
        let first = |[slope, along @ ..]: &[Fixed; 4]| -> [Fixed; 3] {
            std::array::from_fn(|i| over(&along[i].sub(&point[i].mul(slope))))
        };
        let (partial_u, partial_v) = (first(&along_u), first(&along_v));
        let second = |[curve, along @ ..]: &[Fixed; 4],
                      a: &Fixed,
                      of_b: &[Fixed; 3],
                      b: &Fixed,
                      of_a: &[Fixed; 3]|
         -> [Fixed; 3] {
            std::array::from_fn(|i| {
                let others = point[i].mul(curve).add(&a.mul(&of_b[i])).add(&b.mul(&of_a[i]));
                over(&along[i].sub(&others))
            })
        };
        let (weight_u, weight_v) = (&along_u[0], &along_v[0]);
        let second = [
            second(&along_uu, weight_u, &partial_u, weight_u, &partial_u),
            second(&along_uv, weight_u, &partial_v, weight_v, &partial_u),
            second(&along_vv, weight_v, &partial_v, weight_v, &partial_v),
        ];
        let first_form =
            [dot(&partial_u, &partial_u), dot(&partial_u, &partial_v), dot(&partial_v, &partial_v)];
        let speeds = [first_form[0].sqrt(), first_form[2].sqrt()];
        let regular = if self.is_regular(&place) {
            Regular::new(&partial_u, &partial_v, &second, &first_form)
        } else {
            None
        };
        Truth { homogeneous, point, partial_u, partial_v, second, first_form, speeds, regular }
    }

    /// Whether R_u × R_v does not vanish: decided in the number field where enclosures hold zero.
    fn is_regular(&self, place: &Place) -> bool {
        let vanishes = |poly: &Enclosed| {
            poly.at(place).contains_zero() && {
                let [u, v] = place.numbers();
                self.exact(&poly.exact, &u, &v).is_zero()
            }
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
        let [u, v] = Place::new(u, v).numbers();
        self.homogeneous.each_ref().map(|poly| self.exact(&poly.exact, &u, &v))
    }
}

impl Regular {
    /// Normal and curvatures of the derivatives; `None` where R_u × R_v is too small.
    fn new(
        partial_u: &[Fixed; 3],
        partial_v: &[Fixed; 3],
        [uu, uv, vv]: &[[Fixed; 3]; 3],
        [e, f, g]: &[Fixed; 3],
    ) -> Option<Regular> {
        let cross = cross(partial_u, partial_v);
        let length = dot(&cross, &cross).sqrt();
        let [Some(x), Some(y), Some(z)] = cross.each_ref().map(|component| component.div(&length)) else {
            return None;
        };
        let unit_normal = [x, y, z];
        let second_form @ [l, m, n] = &[dot(&unit_normal, uu), dot(&unit_normal, uv), dot(&unit_normal, vv)];
        let area = e.mul(g).sub(&f.mul(f));
        let difference = |a: &Fixed, b: &Fixed, c: &Fixed, d: &Fixed| a.mul(b).sub(&c.mul(d)).div(&area);
        let gaussian = difference(l, n, m, m)?;
        let mean = e.mul(n).add(&g.mul(l)).sub(&f.mul(m)).sub(&f.mul(m)).div(&area)?.half();
        let root = mean.mul(&mean).sub(&gaussian).sqrt();
        let principal = [mean.add(&root), mean.sub(&root)];
        // Weingarten's equations: n_u = ((M F − L G) R_u + (L F − M E) R_v)/(E G − F²), and the same for n_v with M and N.
        let slope = |l: &Fixed, m: &Fixed| -> Option<[Fixed; 3]> {
            let (a, b) = (difference(m, f, l, g)?, difference(l, f, m, e)?);
            Some(std::array::from_fn(|i| a.mul(&partial_u[i]).add(&b.mul(&partial_v[i]))))
        };
        let (normal_u, normal_v) = (slope(l, m)?, slope(m, n)?);
        let second_form = second_form.clone();
        Some(Regular { unit_normal, second_form, gaussian, mean, principal, normal_u, normal_v })
    }
}

/// A pair of parameters.
struct Place {
    floats: [f64; 2],
    u: Fixed,
    v: Fixed,
}

impl Place {
    fn new(u: f64, v: f64) -> Place {
        let fixed =
            |float| Fixed::float(float).unwrap_or_else(|| panic!("the parameter {float} is no number"));
        Place { floats: [u, v], u: fixed(u), v: fixed(v) }
    }

    /// The parameters, exactly.
    fn numbers(&self) -> [Rational; 2] {
        self.floats.map(|float| exact(float).unwrap_or_else(|| panic!("the parameter {float} is no number")))
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
        let row = |row: &BTreeMap<u32, Fixed>| horner(row.iter().map(|(i, c)| (*i, c.clone())), &place.v);
        horner(self.coefficients.iter().map(|(i, coefficients)| (*i, row(coefficients))), &place.u)
    }
}

/// Σ cᵢ·tⁱ for the pairs (i, cᵢ), by increasing exponents.
fn horner(terms: impl DoubleEndedIterator<Item = (u32, Fixed)>, t: &Fixed) -> Fixed {
    let mut sum: Option<(Fixed, u32)> = None;
    for (exponent, coefficient) in terms.rev() {
        let raised = sum.map(|(sum, at)| (exponent..at).fold(sum, |sum, _| sum.mul(t)));
        sum = Some((raised.map_or(coefficient.clone(), |sum| sum.add(&coefficient)), exponent));
    }
    sum.map_or_else(Fixed::zero, |(sum, at)| (0..at).fold(sum, |sum, _| sum.mul(t)))
}

impl Truth {
    /// The exact numbers of an output of the programs, by its name; `None` if it needs a normal where there is none.
    ///
    /// # Panics
    /// If there is no such output.
    #[must_use]
    pub fn output(&self, name: &str) -> Option<&[Fixed]> {
        use std::slice::from_ref;
        let regular = self.regular.as_ref();
        let [uu, uv, vv] = &self.second;
        Some(match name {
            outputs::HOMOGENEOUS => &self.homogeneous,
            outputs::POINT | outputs::SEPARATED_POINT => &self.point,
            outputs::PARTIAL_U => &self.partial_u,
            outputs::PARTIAL_V => &self.partial_v,
            outputs::PARTIAL_UU => uu,
            outputs::PARTIAL_UV => uv,
            outputs::PARTIAL_VV => vv,
            outputs::FIRST_FORM => &self.first_form,
            outputs::SPEEDS => &self.speeds,
            outputs::UNIT_NORMAL => &regular?.unit_normal,
            outputs::SECOND_FORM => &regular?.second_form,
            outputs::GAUSSIAN => from_ref(&regular?.gaussian),
            outputs::MEAN => from_ref(&regular?.mean),
            outputs::PRINCIPAL => &regular?.principal,
            outputs::NORMAL_U => &regular?.normal_u,
            outputs::NORMAL_V => &regular?.normal_v,
            _ => panic!("`{name}` is no output"),
        })
    }

    /// The unit normal, where there is one.
    #[must_use]
    pub fn unit_normal(&self) -> Option<&[Fixed; 3]> {
        self.regular.as_ref().map(|regular| &regular.unit_normal)
    }

    /// The point R + r·N of the offset at the distance `r`, where the surface is regular.
    ///
    /// # Panics
    /// If `r` is not finite.
    #[must_use]
    pub fn offset_point(&self, r: f64) -> Option<[Fixed; 3]> {
        let r = Fixed::float(r).unwrap_or_else(|| panic!("the distance {r} is no number"));
        let normal = self.unit_normal()?;
        Some(std::array::from_fn(|i| self.point[i].add(&normal[i].mul(&r))))
    }
}

fn dot(a: &[Fixed; 3], b: &[Fixed; 3]) -> Fixed {
    a[0].mul(&b[0]).add(&a[1].mul(&b[1])).add(&a[2].mul(&b[2]))
}

fn cross(a: &[Fixed; 3], b: &[Fixed; 3]) -> [Fixed; 3] {
    let minor = |i: usize, j: usize| a[i].mul(&b[j]).sub(&a[j].mul(&b[i]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}
