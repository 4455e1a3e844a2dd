//! The shape operator of a surface from the derivatives of its unit normal (Weingarten; do Carmo, *Differential Geometry of
//! Curves and Surfaces*, §3-2 and §3-3), by which no second derivative is needed.
//!
//! The *direction* t is the reduced normal N/‖N‖, which is the unit normal n or −n. Its derivatives are bounded wherever N does
//! not vanish, singular points of the surface included, and are known up to multiples of t: exactly where N/ρ is rational, and
//! else as N_u/‖N‖ and N_v/‖N‖, since only their products with tangents occur here.
//!
//! One of both parameters is the *base*, X, and the other one is Y. The orthonormal basis e₁ = R_X/√E, e₂ = t × e₁ of the tangent
//! plane has the tangent *across* = t × R_X = √E·e₂ (E, F, G are meant for this order of parameters), and with the signed area
//! α = across·R_Y, which is ±(R_u × R_v)·t, the shape operator −dt has the matrix
//!
//! ```text
//! ( a  b )    a = −t_X·R_X/E,    b = −t_X·across/E,
//! ( b  c )    c = −(t_Y·across + F·b)/α.
//! ```
//!
//! R_Y occurs in F and in α alone. So if R_Y vanishes somewhere, as it does where a profile meets its axis, all that is divided by
//! E has full accuracy there. α is computed as a product: R_u × R_v = factor·N with the factor that was derived, so that it keeps
//! its accuracy near its zeros too.
//!
//! Where R_Y, t_Y and α have a factor φ(x) in common, c is computed from what is left of each (`regular.rs`), and so is defined
//! where φ = 0.
//!
//! Where F = M = 0 identically, b is 0 and c = −t_Y·R_Y/G. The derivatives of t follow from their products with the basis,
//!
//! ```text
//! t_X = −(a·R_X + b·across),    t_Y = ((t_Y·R_X)·R_X + (t_Y·across)·across)/E.
//! ```
//!
//! All of it is on the side of t; what changes its sign with n is turned to the side of n at last (`curvature.rs`).

use hodograph_algebra::Poly;

use super::curvature::{Forms, Shape, dot_or_zero};
use super::normal::{self, Parts};
use super::outputs;
use super::vanish::is_zero_identically;
use super::vector::{cross, dot, is_zero, sum_of};
use crate::program::{Program, Value};

/// The parameter by which a surface is differentiated first.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Base {
    U,
    V,
}

impl Base {
    /// A pair for u and v as one for the base and the other parameter, and back.
    pub(super) fn order<T>(self, [u, v]: [T; 2]) -> [T; 2] {
        if self == Base::U { [u, v] } else { [v, u] }
    }
}

/// Derivatives, and the unit vector t with what it changes by.
pub(super) struct Direction {
    /// R_X and R_Y.
    partials: [Vec<Value>; 2],
    /// t
    unit: Vec<Value>,
    /// t_X and t_Y up to multiples of t, over the next field.
    slopes: [Vec<Value>; 2],
    /// R_Y and t_Y like that, divided by a factor that they have in common, and this factor.
    divided: Option<[Vec<Value>; 3]>,
    /// 1/‖N‖; `None` if the slopes are t_X and t_Y themselves.
    inverse_length: Option<Value>,
    /// ‖N‖, or 1.
    length: Option<Value>,
    base: Base,
}

impl Direction {
    /// The direction of a program that has derivatives of it.
    pub(super) fn of(program: &mut Program<Poly>, base: Base) -> Option<Direction> {
        let results = |name| program.results(name).to_vec();
        let slopes = base.order([outputs::DIRECTION_U, outputs::DIRECTION_V].map(results));
        let partials = base.order([outputs::PARTIAL_U, outputs::PARTIAL_V].map(results));
        let Parts { turned, direction, .. } = normal::parts(program)?;
        if slopes.iter().any(|slope| slope.len() != 3) {
            return None;
        }
        let divided =
            [outputs::PARTIAL_DIVIDED, outputs::DIRECTION_DIVIDED, outputs::COMMON_FACTOR].map(results);
        let divided = divided.iter().all(|values| !values.is_empty()).then_some(divided);
        let (mut inverse_length, mut length) = (None, None);
        if let Some(direction) = direction {
            let (scale, norm, inverse) = normal::scaled_norm(program, &direction);
            inverse_length = Some(program.multiply(scale, inverse));
            length = Some(program.divide(norm, scale));
        }
        Some(Direction { partials, unit: turned, slopes, divided, inverse_length, length, base })
    }

    /// The product of a slope with a tangent, times −1; 0 if that is an identity.
    fn bend(&self, program: &mut Program<Poly>, slope: &[Value], tangent: &[Value]) -> Value {
        let Some(inverse) = self.inverse_length else {
            return dot_or_zero(program, slope, tangent, true);
        };
        let product = dot_or_zero(program, slope, tangent, false);
        let product = program.multiply(product, inverse);
        program.negate(product)
    }

    /// α for `across`, by the derived factor of R_u × R_v if the program has it.
    fn area(&self, program: &mut Program<Poly>, across: &[Value]) -> Value {
        let Some(&factor) = program.results(outputs::AREA_FACTOR).first() else {
            return dot(program, across, &self.partials[1]);
        };
        let area = self.length.map_or(factor, |length| program.multiply(factor, length));
        if self.base == Base::U { area } else { program.negate(area) }
    }

    /// The shape operator of a sphere, which is a number: −1/r for the radius r.
    pub(super) fn shape_of_sphere(&self, program: &mut Program<Poly>, curvature: &Poly) -> Shape {
        let (a, zero) = (program.constant(curvature.clone()), program.constant(Poly::zero()));
        let [normal_u, normal_v] = self.base.order(self.slopes.clone());
        Shape { a, b: zero, c: a, normal_u, normal_v }
    }

    /// Both fundamental forms, the second one on the side of t.
    pub(super) fn forms(&self, program: &mut Program<Poly>) -> Forms {
        let [of_x, of_y] = &self.partials;
        let e = dot(program, of_x, of_x);
        let f = dot_or_zero(program, of_x, of_y, false);
        let g = dot(program, of_y, of_y);
        let (l, n) = (self.bend(program, &self.slopes[0], of_x), self.bend(program, &self.slopes[1], of_y));
        // Either product may be seen to vanish.
        let m = self.bend(program, &self.slopes[1], of_x);
        let other = dot(program, &self.slopes[0], of_y);
        let m = if is_zero_identically(program, other) { program.constant(Poly::zero()) } else { m };
        let ([e, g], [l, n]) = (self.base.order([e, g]), self.base.order([l, n]));
        Forms { e, f, g, l, m, n }
    }

    /// The shape operator and the derivatives of t; the area is needed unless the forms are diagonal and the surface `is_regular`.
    pub(super) fn shape(&self, program: &mut Program<Poly>, forms: &Forms, is_regular: bool) -> Shape {
        let [of_x, of_y] = &self.partials;
        let ([e, g], [l, n]) = (self.base.order([forms.e, forms.g]), self.base.order([forms.l, forms.n]));
        let (f, m) = (forms.f, forms.m);
        let opposite = |program: &mut Program<Poly>, factor: Value, tangent: &[Value]| -> Vec<Value> {
            tangent.iter().map(|&x| sum_of(program, &[(factor, x, true)])).collect()
        };
        let (a, b, c, by_rules);
        if forms.is_diagonal(program) && is_regular {
            (a, b, c) = (quotient(program, l, e), f, quotient(program, n, g));
            by_rules = [opposite(program, a, of_x), opposite(program, c, of_y)];
        } else {
            let across = cross(program, &self.unit, of_x);
            let area = self.area(program, &across);
            // φ = 1 if nothing is divided by it.
            let (turn_over, f_over, turn_y) = match &self.divided {
                Some([partial, slope, factor]) => {
                    let turn = self.bend(program, slope, &across);
                    let f_over = if is_zero(program, f) { f } else { dot(program, of_x, partial) };
                    (turn, f_over, program.multiply(turn, factor[0]))
                }
                None => {
                    let turn = self.bend(program, &self.slopes[1], &across);
                    (turn, f, turn)
                }
            };
            if forms.is_diagonal(program) {
                (a, b) = (quotient(program, l, e), f);
                c = quotient(program, turn_over, area);
                let turn = quotient(program, turn_y, e);
                by_rules = [opposite(program, a, of_x), opposite(program, turn, &across)];
            } else {
                let one = program.constant(Poly::one());
                let e_inverse = program.divide(one, e);
                let turn_x = self.bend(program, &self.slopes[0], &across);
                a = program.multiply(l, e_inverse);
                b = program.multiply(turn_x, e_inverse);
                let sum = sum_of(program, &[(turn_over, one, false), (f_over, b, true)]);
                c = quotient(program, sum, area);
                let (turn, shear) = (program.multiply(turn_y, e_inverse), program.multiply(m, e_inverse));
                let mut combination = |p: Value, q: Value| -> Vec<Value> {
                    let pairs = of_x.iter().zip(&across);
                    pairs.map(|(&x, &y)| sum_of(program, &[(p, x, true), (q, y, true)])).collect()
                };
                by_rules = [combination(a, b), combination(shear, turn)];
            }
        }
        let slopes = if self.inverse_length.is_none() { self.slopes.clone() } else { by_rules };
        let [normal_u, normal_v] = self.base.order(slopes);
        Shape { a, b, c, normal_u, normal_v }
    }
}

/// a/b, where 0/b is 0.
fn quotient(program: &mut Program<Poly>, a: Value, b: Value) -> Value {
    if is_zero(program, a) { a } else { program.divide(a, b) }
}
