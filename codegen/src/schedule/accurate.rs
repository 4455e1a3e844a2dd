//! The point without cancellation.
//!
//! On the domain [a, b] × [c, d] with u = a + (b − a)·s and v = c + (d − c)·t, every homogeneous coordinate is a sum
//! of products of nonnegative polynomials,
//!
//! ```text
//! X(u, v) = Σ_i U_i(u)·(Σ_j β_ij·V_j(v)),   U_i = (u − a)^i·(b − u)^(m−i),   V_j = (v − c)^j·(d − v)^(n−j),
//! β_ij = b_ij·C(m, i)·C(n, j)/((b − a)^m·(d − c)^n)
//! ```
//!
//! where b_ij are the coordinates of its control points. If these have one sign, nothing cancels: every product has a
//! relative error of some unit roundoffs, and so has the sum. So has the weight, which is the product of its factors
//! where it is one; a factor whose coefficients differ in sign is evaluated by the scheme that has the least error
//! figure. The point is X times the inverse of W.
//!
//! The bounds a, b, c, d are floats, so that a factor is a difference of two floats. The degrees are those of the
//! coordinate itself, or those of the patch where only its control points have one sign for the coordinate.

use hodograph_algebra::{Poly, Variable};

use super::forms::unscaled_net;
use super::separate::{Parameters, split_weight};
use super::univariate::Builder;
use crate::program::{Input, Value};
use crate::round::nearest;

/// The point; `None` if the domain has no ends that are floats, or a coefficient is no number.
pub(super) fn point(builder: &mut Builder<'_>, homogeneous: &[Poly; 4]) -> Option<Vec<Value>> {
    let [weight, coordinates @ ..] = homogeneous;
    let Parameters { u, v } = builder.parameters;
    let highest = |by: &Variable| homogeneous.iter().filter_map(|poly| poly.degree(by)).max();
    let patch = [highest(u)?, highest(v)?];
    let denominator = match split_weight(weight, builder.parameters) {
        Some((a, b)) => {
            let (a, b) = (factor(builder, &a)?, factor(builder, &b)?);
            builder.sum_of_products(&[(a, b)])
        }
        None => coordinate(builder, weight, patch)?,
    };
    let one = builder.program.constant(Poly::one());
    let inverse = builder.program.divide(one, denominator);
    let mut point = Vec::new();
    for poly in coordinates {
        let value = coordinate(builder, poly, patch)?;
        point.push(builder.sum_of_nonzero_products(&[(value, inverse)]));
    }
    Some(point)
}

/// A polynomial in the Bernstein basis of the domain, if its coefficients have one sign.
pub(super) fn of_one_sign(builder: &mut Builder<'_>, poly: &Poly) -> Option<Value> {
    let Parameters { u, v } = builder.parameters;
    let net = net(builder, poly, [poly.degree(u)?, poly.degree(v)?])?;
    has_one_sign(&net)?.then(|| coordinate(builder, poly, [0, 0]))?
}

/// A factor of the weight, which depends on one parameter.
fn factor(builder: &mut Builder<'_>, poly: &Poly) -> Option<Value> {
    of_one_sign(builder, poly).or_else(|| Some(builder.polynomial(poly)))
}

/// A coordinate in the Bernstein basis, of its own degrees or of those of the patch.
fn coordinate(builder: &mut Builder<'_>, poly: &Poly, patch: [u32; 2]) -> Option<Value> {
    if poly.is_zero() {
        return Some(builder.program.constant(Poly::zero()));
    }
    let Parameters { u, v } = builder.parameters;
    let own = [poly.degree(u)?, poly.degree(v)?];
    let mut chosen = own;
    let mut net = net(builder, poly, own)?;
    if !has_one_sign(&net)? && own != patch {
        let elevated = self::net(builder, poly, patch)?;
        if has_one_sign(&elevated)? {
            (chosen, net) = (patch, elevated);
        }
    }
    let [m, n] = chosen.map(|degree| degree as usize);
    let (of_u, of_v) = (builder.bernstein_basis(Input::U, m)?, builder.bernstein_basis(Input::V, n)?);
    let mut terms = Vec::new();
    for (row, factor) in net.chunks(n + 1).zip(of_u) {
        let numbers: Vec<Value> = row.iter().map(|coefficient| builder.number(coefficient)).collect();
        let products: Vec<(Value, Value)> = numbers.into_iter().zip(of_v.iter().copied()).collect();
        terms.push((builder.sum_of_nonzero_products(&products), factor));
    }
    Some(builder.sum_of_nonzero_products(&terms))
}

fn net(builder: &Builder<'_>, poly: &Poly, [m, n]: [u32; 2]) -> Option<Vec<Poly>> {
    let Parameters { u, v } = builder.parameters;
    let (of_u, of_v) = (builder.range(Input::U)?, builder.range(Input::V)?);
    unscaled_net(poly, &[(u.clone(), of_u, m), (v.clone(), of_v, n)])
}

/// Whether no two coefficients have different signs; `None` if one of them is no number.
fn has_one_sign(net: &[Poly]) -> Option<bool> {
    let signs: Vec<f64> = net.iter().map(|b| nearest(b).ok()).collect::<Option<_>>()?;
    Some(signs.iter().all(|b| *b >= 0.0) || signs.iter().all(|b| *b <= 0.0))
}
