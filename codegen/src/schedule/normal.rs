//! The unit normal.
//!
//! With N the numerators of the reduced normal it is N/ρ where ρ = √(N·N) is a polynomial, and else
//!
//! ```text
//! s = scale(N),   n = (s·N)/√((s·N)·(s·N))
//! ```
//!
//! where s is the power of two that brings the largest component to between 1 and 2: the square neither overflows nor
//! underflows, and no rounding is added. R_u × R_v is N times a factor; where that one may vanish on the domain, the
//! normal is turned to the side of R_u × R_v by its sign.

use hodograph_algebra::{Fraction, Poly, Variable};

use super::regular::Common;
use super::sign::signed;
use super::surface::{Form, polynomials, quotients};
use super::univariate::Builder;
use super::vector::is_zero;
use super::weingarten::Base;
use super::{Derived, outputs, vector};
use crate::program::{Operation, Program, Value};

/// The unit normal of a surface whose derivatives are scheduled, and the derivatives of what it is made of, N/ρ or N, unless the
/// surface `is_family`: they would be large.
pub(super) fn schedule(
    builder: &mut Builder<'_>,
    derived: &Derived<'_>,
    preferred: &[Poly],
    is_family: bool,
) {
    builder.is_careful = derived.singular.is_some() && !is_family;
    let (normal, slopes) = match (derived.normal, derived.normal_root) {
        (None, _) => {
            let direction = cross_product(&mut builder.program);
            (unit(&mut builder.program, &direction, None), None)
        }
        (Some(normal), None) => {
            let direction = polynomials(builder, normal);
            let side = side(builder, derived, is_family);
            let unit = unit(&mut builder.program, &direction, side);
            let slopes = (!is_family).then(|| {
                derived
                    .parameters
                    .map(|by| polynomials(builder, &normal.each_ref().map(|n| n.derivative(by))))
            });
            (unit, slopes)
        }
        (Some(normal), Some(root)) => {
            let (rational, slopes) = over_root(builder, normal, root, derived.parameters, preferred);
            let side = side(builder, derived, is_family);
            (oriented(&mut builder.program, &rational, side), (!is_family).then_some(slopes))
        }
    };
    builder.is_careful = false;
    builder.program.output(outputs::UNIT_NORMAL, normal);
    if let Some([of_u, of_v]) = slopes {
        builder.program.output(outputs::DIRECTION_U, of_u);
        builder.program.output(outputs::DIRECTION_V, of_v);
    }
}

/// The factor of R_u × R_v whose sign decides on the side of the normal, if one does.
fn side(builder: &mut Builder<'_>, derived: &Derived<'_>, is_family: bool) -> Option<Value> {
    let singular = derived.singular?;
    let value = if is_family {
        polynomials(builder, std::slice::from_ref(singular))[0]
    } else {
        signed(builder, singular)
    };
    builder.program.name(value, "singular");
    Some(value)
}

/// The signed area (R_u × R_v)·N/ρ where the normal has a root ρ, or the factor by which R_u × R_v is N; divided by what it has in
/// common with the derivative by the other parameter than the base, which is scheduled without that too.
pub(super) fn schedule_area(
    builder: &mut Builder<'_>,
    derived: &Derived<'_>,
    base: Base,
    preferred: &[Poly],
) {
    let common = Common::of(derived, base);
    let (Some(factor), Some(singular)) =
        (area_factor(derived, common.as_ref()), singular(derived, common.as_ref()))
    else {
        return;
    };
    builder.is_careful = derived.singular.is_some();
    if let Some(common) = &common {
        let Common { partial, square, slope, denominator, factor } = common;
        let values = fractions(builder, partial, square, preferred);
        builder.program.output(outputs::PARTIAL_DIVIDED, values);
        let values = fractions(builder, slope, denominator, preferred);
        builder.program.output(outputs::DIRECTION_DIVIDED, values);
        let value = builder.polynomial(factor);
        builder.program.output(outputs::COMMON_FACTOR, vec![value]);
    }
    // The sign of the factor is that of a polynomial, which is computed with care.
    let rest = Fraction::from(Poly::one()).checked_div(&Fraction::from(singular.clone()));
    let rest = rest.map_or_else(|| factor.clone(), |inverse| (&factor * &inverse).lowest_terms());
    let value = fractions(builder, std::slice::from_ref(rest.numerator()), &rest.denominator(), preferred)[0];
    let side = if singular.is_constant() { builder.number(&singular) } else { signed(builder, &singular) };
    let value = builder.program.multiply(value, side);
    builder.is_careful = false;
    builder.program.name(value, "area");
    builder.program.output(outputs::AREA_FACTOR, vec![value]);
}

/// The polynomial that decides on the side of the normal, divided by a factor; 1 if there is none.
fn singular(derived: &Derived<'_>, common: Option<&Common>) -> Option<Poly> {
    let Some(singular) = derived.singular else { return Some(Poly::one()) };
    match common {
        Some(common) => singular.exact_div(&common.factor),
        None => Some(singular.clone()),
    }
}

/// What [`schedule_area`] computes.
pub(super) fn area_factor(derived: &Derived<'_>, common: Option<&Common>) -> Option<Fraction> {
    let factor = derived.factor?;
    let root = derived.normal_root.cloned().unwrap_or_else(Poly::one);
    let factor = (factor * &Fraction::from(root)).lowest_terms();
    match common {
        Some(common) => common.divided(&factor),
        None => Some(factor),
    }
}

/// Rational functions of both parameters with one denominator.
fn fractions(
    builder: &mut Builder<'_>,
    numerators: &[Poly],
    denominator: &Poly,
    preferred: &[Poly],
) -> Vec<Value> {
    if let Some(form) = Form::of(denominator, numerators, builder.parameters, preferred) {
        return quotients(builder, &form.of_u, &form.of_v);
    }
    let numerators = polynomials(builder, numerators);
    let denominator = polynomials(builder, std::slice::from_ref(denominator))[0];
    let one = builder.program.constant(Poly::one());
    let inverse = builder.program.divide(one, denominator);
    vector::scaled(&mut builder.program, inverse, &numerators)
}

/// R_u × R_v
pub(super) fn cross_product(program: &mut Program<Poly>) -> Vec<Value> {
    let [a, b] = [outputs::PARTIAL_U, outputs::PARTIAL_V].map(|name| program.results(name).to_vec());
    vector::cross(program, &a, &b)
}

/// N/ρ, as a sum of products of one parameter each where ρ is a product, and its derivatives.
fn over_root(
    builder: &mut Builder<'_>,
    normal: &[Poly; 3],
    root: &Poly,
    parameters: [&Variable; 2],
    preferred: &[Poly],
) -> (Vec<Value>, [Vec<Value>; 2]) {
    if let Some(form) = Form::of(root, normal, builder.parameters, preferred) {
        let values = quotients(builder, &form.of_u, &form.of_v);
        return (values, form.schedule_slopes(builder, preferred));
    }
    let length = polynomials(builder, std::slice::from_ref(root))[0];
    let one = builder.program.constant(Poly::one());
    let inverse = builder.program.divide(one, length);
    let direction = polynomials(builder, normal);
    let unit = vector::scaled(&mut builder.program, inverse, &direction);
    // (N/ρ)' = (N' − (N/ρ)·ρ')/ρ
    let slopes = parameters.map(|by| {
        let slope = polynomials(builder, std::slice::from_ref(&root.derivative(by)))[0];
        let slopes = polynomials(builder, &normal.each_ref().map(|n| n.derivative(by)));
        let program = &mut builder.program;
        let terms = slopes.iter().zip(&unit);
        let difference =
            |(&n, &t): (&Value, &Value)| vector::sum_of(program, &[(n, one, false), (t, slope, true)]);
        let differences: Vec<Value> = terms.map(difference).collect();
        vector::scaled(program, inverse, &differences)
    });
    (unit, slopes)
}

/// The unit vector of a direction, on the given side.
pub(super) fn unit(program: &mut Program<Poly>, direction: &[Value], side: Option<Value>) -> Vec<Value> {
    let (scale, _, inverse) = scaled_norm(program, direction);
    let scaled = vector::scaled(program, scale, direction);
    let normal = vector::scaled(program, inverse, &scaled);
    oriented(program, &normal, side)
}

/// The scale s of a direction N, the norm ‖s·N‖ and its inverse.
pub(super) fn scaled_norm(program: &mut Program<Poly>, direction: &[Value]) -> (Value, Value, Value) {
    let scale = program.scale(direction[0], direction[1], direction[2]);
    let scaled = vector::scaled(program, scale, direction);
    let square = vector::dot(program, &scaled, &scaled);
    let norm = program.square_root(square);
    let one = program.constant(Poly::one());
    (scale, norm, program.divide(one, norm))
}

fn oriented(program: &mut Program<Poly>, vector: &[Value], side: Option<Value>) -> Vec<Value> {
    let Some(side) = side else { return vector.to_vec() };
    vector.iter().map(|&component| program.orient(component, side)).collect()
}

/// Values on the given side, where 0 is the same on both.
pub(super) fn turned(program: &mut Program<Poly>, values: &[Value], side: Option<Value>) -> Vec<Value> {
    let Some(side) = side else { return values.to_vec() };
    let turn = |&value: &Value| if is_zero(program, value) { value } else { program.orient(value, side) };
    values.iter().map(turn).collect()
}

/// What a unit normal was made of, as its operations show: the vector that was turned to one side and by which value; and
/// the direction of which that is the unit vector.
pub(super) struct Parts {
    pub(super) turned: Vec<Value>,
    pub(super) side: Option<Value>,
    pub(super) direction: Option<[Value; 3]>,
}

/// The parts of the program's unit normal; `None` if its components are not turned to one side all.
pub(super) fn parts(program: &Program<Poly>) -> Option<Parts> {
    let normal = program.results(outputs::UNIT_NORMAL);
    let turn = |value: &Value| match *program.operation(*value) {
        Operation::Orient(component, side) => (component, Some(side)),
        _ => (*value, None),
    };
    let (turned, sides): (Vec<Value>, Vec<Option<Value>>) = normal.iter().map(turn).unzip();
    let side = *sides.first()?;
    let direction = program.needed(normal).into_iter().find_map(|value| match *program.operation(value) {
        Operation::Scale(a, b, c) => Some([a, b, c]),
        _ => None,
    });
    sides.iter().all(|other| *other == side).then_some(Parts { turned, side, direction })
}
