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
//! Where a bound is no float, the difference from it is made up of parts, so that its error is small near the bound too. The degrees are
//! those of the coordinate itself, or those of the patch where only its control points have one sign for the coordinate.

use hodograph_algebra::{Poly, Rational, Variable};

use super::forms::{Preference, Range, unscaled_net};
use super::separate::{Parameters, split_weight};
use super::univariate::Builder;
use crate::program::{Input, Value};
use crate::round::nearest;

/// The point; `None` if the domain has ends beyond the range of floats, or a coefficient is no number.
pub(super) fn point(builder: &mut Builder<'_>, homogeneous: &[Poly; 4]) -> Option<Vec<Value>> {
    let [weight, coordinates @ ..] = homogeneous;
    let Parameters { u, v } = builder.parameters;
    let highest = |by: &Variable| homogeneous.iter().filter_map(|poly| poly.degree(by)).max();
    let patch = [highest(u)?, highest(v)?];
    if weight.is_constant() {
        let scale = weight.inverse();
        return coordinates.iter().map(|poly| coordinate(builder, &(poly * &scale), patch)).collect();
    }
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
    let ranges = [builder.range(Input::U)?, builder.range(Input::V)?];
    let net = net(poly, builder.parameters, ranges, [poly.degree(u)?, poly.degree(v)?])?;
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
    let ranges = [builder.range(Input::U)?, builder.range(Input::V)?];
    let (net, degrees) = own_or_elevated(poly, builder.parameters, ranges, patch)?;
    let [m, n] = degrees.map(|degree| degree as usize);
    let (of_u, of_v) = (builder.bernstein_basis(Input::U, m)?, builder.bernstein_basis(Input::V, n)?);
    let mut terms = Vec::new();
    for (row, factor) in net.chunks(n + 1).zip(of_u) {
        let numbers: Vec<Value> = row.iter().map(|coefficient| builder.number(coefficient)).collect();
        let products: Vec<(Value, Value)> = numbers.into_iter().zip(of_v.iter().copied()).collect();
        terms.push((builder.sum_of_nonzero_products(&products), factor));
    }
    Some(builder.sum_of_nonzero_products(&terms))
}

/// Whether all control points have one sign for x, for y and for z, so that the accurate coordinate is a sum without cancellation.
pub(crate) fn have_one_sign(
    parameters: [&Variable; 2],
    homogeneous: &[Poly; 4],
    domain: &[[Rational; 2]; 2],
) -> [bool; 3] {
    let [weight, x, y, z] = homogeneous;
    let parameters = Parameters { u: parameters[0].clone(), v: parameters[1].clone() };
    let [of_u, of_v] = domain.each_ref().map(|ends| Range::of(ends, Preference::Accurate));
    let (Some(of_u), Some(of_v)) = (of_u, of_v) else { return [false; 3] };
    let highest = |by: &Variable| homogeneous.iter().filter_map(|poly| poly.degree(by)).max().unwrap_or(0);
    let patch = [highest(&parameters.u), highest(&parameters.v)];
    let one_sign = |poly: &Poly| {
        let net = own_or_elevated(poly, &parameters, [&of_u, &of_v], patch);
        poly.is_zero() || net.is_some_and(|(net, _)| has_one_sign(&net) == Some(true))
    };
    if one_sign(weight) { [x, y, z].map(one_sign) } else { [false; 3] }
}

/// The net of a polynomial of its own degrees, with these; or that of the degrees of the patch if only it has one sign.
fn own_or_elevated(
    poly: &Poly,
    parameters: &Parameters,
    ranges: [&Range; 2],
    patch: [u32; 2],
) -> Option<(Vec<Poly>, [u32; 2])> {
    let own = [poly.degree(&parameters.u)?, poly.degree(&parameters.v)?];
    let net_of_own = net(poly, parameters, ranges, own)?;
    if !has_one_sign(&net_of_own)? && own != patch {
        let elevated = net(poly, parameters, ranges, patch)?;
        if has_one_sign(&elevated)? {
            return Some((elevated, patch));
        }
    }
    Some((net_of_own, own))
}

fn net(
    poly: &Poly,
    Parameters { u, v }: &Parameters,
    [of_u, of_v]: [&Range; 2],
    [m, n]: [u32; 2],
) -> Option<Vec<Poly>> {
    unscaled_net(poly, &[(u.clone(), of_u, m), (v.clone(), of_v, n)])
}

/// Whether no two coefficients have different signs; `None` if one of them is no number.
fn has_one_sign(net: &[Poly]) -> Option<bool> {
    let signs: Vec<f64> = net.iter().map(|b| nearest(b).ok()).collect::<Option<_>>()?;
    Some(signs.iter().all(|b| *b >= 0.0) || signs.iter().all(|b| *b <= 0.0))
}
