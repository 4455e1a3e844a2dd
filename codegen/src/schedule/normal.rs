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

use hodograph_algebra::Poly;

use super::surface::{Form, polynomials, quotients};
use super::univariate::Builder;
use super::{Derived, outputs, vector};
use crate::program::{Operation, Program, Value};

/// The unit normal of a surface whose derivatives are scheduled.
pub(super) fn schedule(builder: &mut Builder<'_>, derived: &Derived<'_>, preferred: &[Poly]) {
    let normal = match (derived.normal, derived.normal_root) {
        (None, _) => {
            let direction = cross_product(&mut builder.program);
            unit(&mut builder.program, &direction, None)
        }
        (Some(normal), None) => {
            let direction = polynomials(builder, normal);
            let side = side(builder, derived);
            unit(&mut builder.program, &direction, side)
        }
        (Some(normal), Some(root)) => {
            let rational = over_root(builder, normal, root, preferred);
            let side = side(builder, derived);
            oriented(&mut builder.program, &rational, side)
        }
    };
    builder.program.output(outputs::UNIT_NORMAL, normal);
}

/// The factor of R_u × R_v whose sign decides on the side of the normal, if one does.
fn side(builder: &mut Builder<'_>, derived: &Derived<'_>) -> Option<Value> {
    let singular = derived.singular?;
    let value = polynomials(builder, std::slice::from_ref(singular))[0];
    builder.program.name(value, "singular");
    Some(value)
}

/// R_u × R_v
pub(super) fn cross_product(program: &mut Program<Poly>) -> Vec<Value> {
    let [a, b] = [outputs::PARTIAL_U, outputs::PARTIAL_V].map(|name| program.results(name).to_vec());
    vector::cross(program, &a, &b)
}

/// N/ρ, as a sum of products of one parameter each where ρ is a product.
fn over_root(builder: &mut Builder<'_>, normal: &[Poly; 3], root: &Poly, preferred: &[Poly]) -> Vec<Value> {
    if let Some(form) = Form::of(root, normal, builder.parameters, preferred) {
        return quotients(builder, &form.of_u, &form.of_v);
    }
    let root = polynomials(builder, std::slice::from_ref(root))[0];
    let one = builder.program.constant(Poly::one());
    let inverse = builder.program.divide(one, root);
    let direction = polynomials(builder, normal);
    vector::scaled(&mut builder.program, inverse, &direction)
}

/// The unit vector of a direction, on the given side.
pub(super) fn unit(program: &mut Program<Poly>, direction: &[Value], side: Option<Value>) -> Vec<Value> {
    let scale = program.scale(direction[0], direction[1], direction[2]);
    let scaled = vector::scaled(program, scale, direction);
    let square = vector::dot(program, &scaled, &scaled);
    let norm = program.square_root(square);
    let one = program.constant(Poly::one());
    let inverse = program.divide(one, norm);
    let normal = vector::scaled(program, inverse, &scaled);
    oriented(program, &normal, side)
}

fn oriented(program: &mut Program<Poly>, vector: &[Value], side: Option<Value>) -> Vec<Value> {
    let Some(side) = side else { return vector.to_vec() };
    vector.iter().map(|&component| program.orient(component, side)).collect()
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
