//! Fundamental forms, curvatures, parametric speeds, and derivatives of the unit normal.
//!
//! With the unit normal n on the side of R_u × R_v, the fundamental forms are (do Carmo, *Differential Geometry of
//! Curves and Surfaces*, §2-5 and §3-3)
//!
//! ```text
//! E = R_u·R_u, F = R_u·R_v, G = R_v·R_v,     L = n·R_uu, M = n·R_uv, N = n·R_vv.
//! ```
//!
//! The textbook's K = (LN − M²)/(EG − F²) cancels in both differences. Here the shape operator is written in the
//! orthonormal basis e₁ = R_u/√E, e₂ = n × e₁ of the tangent plane instead, or in that of R_v. Its matrix
//!
//! ```text
//! ( a  b )
//! ( b  c )
//! ```
//!
//! follows from the derivatives of the normal (`weingarten.rs`), with L = −n_u·R_u and so on; where these are not scheduled, as
//! for families of surfaces, from second derivatives. Its invariants are the mean curvature H = (a + c)/2, the Gaussian curvature
//! K = a·c − b², and the principal curvatures H ± √(((a − c)/2)² + b²), whose radicand is a sum of squares and so never negative.
//! Curvatures are positive where the surface bends to the side of n: the unit sphere with the normal outwards has a = c = −1.
//!
//! From second derivatives: with the area ‖R_u × R_v‖ = (n × R_u)·R_v the derivative by v is R_v = (F·e₁ + area·e₂)/√E, so that
//! e₂ = (√E/area)·(R_v − (F/E)·R_u), and
//!
//! ```text
//! a = II(e₁, e₁) = L/E,   b = II(e₁, e₂) = m/area with m = M − F·a,   c = II(e₂, e₂) = (E·N − F·(M + m))/area².
//! ```
//!
//! The matrix is that of −dn: dn(e₁) = −(a·e₁ + b·e₂), dn(e₂) = −(b·e₁ + c·e₂). Hence
//!
//! ```text
//! n_u = √E·dn(e₁) = −(a·R_u + b·(n × R_u)),
//! n_v = (F·dn(e₁) + area·dn(e₂))/√E = (F/E)·n_u − (area/E)·(b·R_u + c·(n × R_u)).
//! ```
//!
//! Many sweeps are parametrized by lines of curvature, F = M = 0 (do Carmo, §3-3). Where that is an identity
//! (`vanish.rs`), the shape operator is diagonal in the basis R_u, R_v itself: a = L/E, b = 0, c = N/G, n_u = −a·R_u
//! and n_v = −c·R_v. On planes a, b and c are 0, and on spheres
//! a = c is a number and b is 0.

use hodograph_algebra::{Poly, ratio};

use super::normal::{self, turned};
use super::vanish::is_zero_identically;
use super::vector::{cross, dot, is_zero, sum_of};
use super::weingarten::{Base, Direction};
use super::{OutputValues, outputs};
use crate::program::{Program, Value};

/// The outputs that follow from the derivatives and the unit normal of a program, with its derivatives if it has them.
///
/// That they are right follows from the formulas above once those are proved, so a proof compares them with what this
/// function makes of a copy of the program. For a sphere its `curvature` is known, on the side of what the normal is made of.
pub(super) fn of_patch(
    program: &mut Program<Poly>,
    base: Base,
    curvature: Option<&Poly>,
) -> Vec<OutputValues> {
    let (forms, shape, side);
    if let Some(direction) = Direction::of(program, base) {
        side = normal::parts(program).and_then(|parts| parts.side);
        forms = direction.forms(program);
        shape = match curvature {
            Some(curvature) => direction.shape_of_sphere(program, curvature),
            None => direction.shape(program, &forms, side.is_none()),
        };
    } else {
        side = None;
        forms = forms_of_patch(program);
        shape = shape_of_patch(program, &forms);
    }
    let Forms { e, f, g, l, m, n } = forms;
    let Shape { a, b, c, normal_u, normal_v } = shape;
    let speeds = vec![program.square_root(e), program.square_root(g)];

    let (mean, gaussian, root);
    if let Some(curvature) = curvature {
        (mean, root) = (a, b);
        gaussian = program.constant(curvature * curvature);
    } else {
        let half = program.constant(Poly::constant(ratio(1, 2)));
        let sum = program.add(a, c);
        mean = program.multiply(half, sum);
        gaussian = sum_of(program, &[(a, c, false), (b, b, true)]);
        let difference = program.subtract(a, c);
        let difference = program.multiply(half, difference);
        let radicand = sum_of(program, &[(difference, difference, false), (b, b, false)]);
        root = if is_zero(program, radicand) { radicand } else { program.square_root(radicand) };
    }
    let mean = turned(program, &[mean], side)[0];
    let principal = vec![program.add(mean, root), program.subtract(mean, root)];

    vec![
        (outputs::FIRST_FORM, vec![e, f, g]),
        (outputs::SECOND_FORM, turned(program, &[l, m, n], side)),
        (outputs::GAUSSIAN, vec![gaussian]),
        (outputs::MEAN, vec![mean]),
        (outputs::PRINCIPAL, principal),
        (outputs::SPEEDS, speeds),
        (outputs::NORMAL_U, turned(program, &normal_u, side)),
        (outputs::NORMAL_V, turned(program, &normal_v, side)),
    ]
}

/// Whether F = M = 0 identically, so that the area is not needed where it has no zeros.
pub(super) fn is_diagonal(program: &mut Program<Poly>, base: Base) -> bool {
    Direction::of(program, base).is_some_and(|direction| direction.forms(program).is_diagonal(program))
}

/// a·b or −a·b, or the constant 0 if that is an identity.
pub(super) fn dot_or_zero(program: &mut Program<Poly>, a: &[Value], b: &[Value], minus: bool) -> Value {
    let products: Vec<(Value, Value, bool)> = a.iter().zip(b).map(|(&a, &b)| (a, b, minus)).collect();
    let product = sum_of(program, &products);
    if is_zero_identically(program, product) { program.constant(Poly::zero()) } else { product }
}

/// The coefficients of both fundamental forms.
pub(super) struct Forms {
    pub(super) e: Value,
    pub(super) f: Value,
    pub(super) g: Value,
    pub(super) l: Value,
    pub(super) m: Value,
    pub(super) n: Value,
}

impl Forms {
    /// Whether F = M = 0.
    pub(super) fn is_diagonal(&self, program: &Program<Poly>) -> bool {
        is_zero(program, self.f) && is_zero(program, self.m)
    }
}

/// The matrix of the shape operator in an orthonormal basis, and the derivatives of the normal.
pub(super) struct Shape {
    pub(super) a: Value,
    pub(super) b: Value,
    pub(super) c: Value,
    pub(super) normal_u: Vec<Value>,
    pub(super) normal_v: Vec<Value>,
}

/// Both forms from second derivatives.
fn forms_of_patch(program: &mut Program<Poly>) -> Forms {
    let results = |name| program.results(name).to_vec();
    let [of_u, of_v] = [outputs::PARTIAL_U, outputs::PARTIAL_V].map(results);
    let [of_uu, of_uv, of_vv] = [outputs::PARTIAL_UU, outputs::PARTIAL_UV, outputs::PARTIAL_VV].map(results);
    let normal = results(outputs::UNIT_NORMAL);
    let e = dot(program, &of_u, &of_u);
    let f = dot_or_zero(program, &of_u, &of_v, false);
    let g = dot(program, &of_v, &of_v);
    let l = dot(program, &normal, &of_uu);
    let m = dot_or_zero(program, &normal, &of_uv, false);
    let n = dot(program, &normal, &of_vv);
    Forms { e, f, g, l, m, n }
}

/// The shape operator from second derivatives.
fn shape_of_patch(program: &mut Program<Poly>, forms: &Forms) -> Shape {
    let results = |name| program.results(name).to_vec();
    let [of_u, of_v] = [outputs::PARTIAL_U, outputs::PARTIAL_V].map(results);
    if forms.is_diagonal(program) {
        diagonal(program, forms, &of_u, &of_v)
    } else {
        general(program, forms, &of_u, &of_v)
    }
}

/// For F = M = 0.
fn diagonal(program: &mut Program<Poly>, forms: &Forms, of_u: &[Value], of_v: &[Value]) -> Shape {
    let (a, c) = (program.divide(forms.l, forms.e), program.divide(forms.n, forms.g));
    let mut derivative = |curvature: Value, vector: &[Value]| -> Vec<Value> {
        vector.iter().map(|&x| sum_of(program, &[(curvature, x, true)])).collect()
    };
    let (normal_u, normal_v) = (derivative(a, of_u), derivative(c, of_v));
    Shape { a, b: forms.f, c, normal_u, normal_v }
}

fn general(program: &mut Program<Poly>, forms: &Forms, of_u: &[Value], of_v: &[Value]) -> Shape {
    let &Forms { e, f, l, m, n, .. } = forms;
    let normal = program.results(outputs::UNIT_NORMAL).to_vec();
    let one = program.constant(Poly::one());
    let across = cross(program, &normal, of_u);
    let area = dot(program, &across, of_v);
    let e_inverse = program.divide(one, e);
    let area_inverse = program.divide(one, area);

    let a = program.multiply(l, e_inverse);
    let rest = sum_of(program, &[(m, one, false), (f, a, true)]);
    let b = program.multiply(rest, area_inverse);
    let sum = program.add(m, rest);
    let square = sum_of(program, &[(e, n, false), (f, sum, true)]);
    let square = program.multiply(square, area_inverse);
    let c = program.multiply(square, area_inverse);

    let mut combination = |(p, x): (Value, &[Value]), (q, y): (Value, &[Value]), minus| -> Vec<Value> {
        x.iter().zip(y).map(|(&x, &y)| sum_of(program, &[(p, x, minus), (q, y, minus)])).collect()
    };
    let normal_u = combination((a, of_u), (b, &across), true);
    let turned = combination((b, of_u), (c, &across), false);
    let (shear, stretch) = (program.multiply(f, e_inverse), program.multiply(area, e_inverse));
    let pairs = normal_u.iter().zip(&turned);
    let normal_v = pairs.map(|(&x, &y)| sum_of(program, &[(shear, x, false), (stretch, y, true)])).collect();
    Shape { a, b, c, normal_u, normal_v }
}
