//! Surfaces whose weight is no product: every coordinate is divided by the weight at each point.
//!
//! From X = x·W follow X_s = x_s·W + x·W_s and X_st = x_st·W + x_s·W_t + x_t·W_s + x·W_st, and so
//!
//! ```text
//! x = X/W,   x_s = (X_s − x·W_s)/W,   x_st = (X_st − x_s·W_t − x_t·W_s − x·W_st)/W
//! ```
//!
//! for any parameters s and t. One inverse of W serves all of them.

use hodograph_algebra::{Poly, Variable};

use super::outputs;
use super::separate::Parameters;
use super::surface::polynomials;
use super::univariate::Builder;
use crate::program::Value;

/// Homogeneous coordinates, the point, which has one form only, and first and second derivatives.
pub(super) fn schedule_surface(builder: &mut Builder<'_>, homogeneous: &[Poly; 4]) {
    let Parameters { u, v } = builder.parameters;
    let values = polynomials(builder, homogeneous);
    let one = builder.program.constant(Poly::one());
    let inverse = builder.program.divide(one, values[0]);
    builder.program.name(inverse, "weight_inverse");
    let point: Vec<Value> =
        values[1..].iter().map(|&value| builder.program.multiply(value, inverse)).collect();
    builder.program.output(outputs::HOMOGENEOUS, values);
    builder.program.output(outputs::POINT, point.clone());
    builder.program.output(outputs::SEPARATED_POINT, point.clone());

    let first = |builder: &mut Builder<'_>, s| {
        let slopes = derivatives(builder, homogeneous, &[s]);
        let partial = over_weight(builder, &slopes[1..], &[(&point, slopes[0])], inverse);
        (slopes[0], partial)
    };
    let (weight_u, partial_u) = first(builder, u);
    let (weight_v, partial_v) = first(builder, v);
    let square = |builder: &mut Builder<'_>, s, (weight_s, partial): (Value, &[Value])| {
        let bends = derivatives(builder, homogeneous, &[s, s]);
        let two = builder.program.constant(Poly::integer(2));
        let twice = builder.program.multiply(two, weight_s);
        over_weight(builder, &bends[1..], &[(partial, twice), (&point, bends[0])], inverse)
    };
    let partial_uu = square(builder, u, (weight_u, &partial_u));
    let partial_vv = square(builder, v, (weight_v, &partial_v));
    let twists = derivatives(builder, homogeneous, &[u, v]);
    let products = [(&*partial_u, weight_v), (&*partial_v, weight_u), (&*point, twists[0])];
    let partial_uv = over_weight(builder, &twists[1..], &products, inverse);
    for (name, values) in [
        (outputs::PARTIAL_U, partial_u),
        (outputs::PARTIAL_V, partial_v),
        (outputs::PARTIAL_UU, partial_uu),
        (outputs::PARTIAL_UV, partial_uv),
        (outputs::PARTIAL_VV, partial_vv),
    ] {
        builder.program.output(name, values);
    }
}

/// The derivatives of W, X, Y and Z by the variables, one after the other.
fn derivatives(builder: &mut Builder<'_>, homogeneous: &[Poly; 4], variables: &[&Variable]) -> Vec<Value> {
    let derivative = |poly: &Poly| variables.iter().fold(poly.clone(), |poly, by| poly.derivative(by));
    polynomials(builder, &homogeneous.each_ref().map(derivative))
}

/// (X − Σ a·w)/W for each coordinate X, where a is the coordinate of another derivative and w one of the weight.
fn over_weight(
    builder: &mut Builder<'_>,
    coordinates: &[Value],
    products: &[(&[Value], Value)],
    inverse: Value,
) -> Vec<Value> {
    let program = &mut builder.program;
    let quotient = |(place, &coordinate): (usize, &Value)| {
        let rest = products.iter().fold(coordinate, |rest, &(lower, slope)| {
            let product = program.multiply(lower[place], slope);
            program.subtract(rest, product)
        });
        program.multiply(rest, inverse)
    };
    coordinates.iter().enumerate().map(quotient).collect()
}
