//! Vectors of three values of a program.

use hodograph_algebra::Poly;

use crate::program::{Operation, Program, Value};

/// a × b
pub(super) fn cross(program: &mut Program<Poly>, a: &[Value], b: &[Value]) -> Vec<Value> {
    let minor = |(i, j): (usize, usize)| sum_of(program, &[(a[i], b[j], false), (a[j], b[i], true)]);
    [(1, 2), (2, 0), (0, 1)].into_iter().map(minor).collect()
}

/// a·b
pub(super) fn dot(program: &mut Program<Poly>, a: &[Value], b: &[Value]) -> Value {
    let products: Vec<(Value, Value, bool)> = a.iter().zip(b).map(|(&a, &b)| (a, b, false)).collect();
    sum_of(program, &products)
}

/// The vector times a number.
pub(super) fn scaled(program: &mut Program<Poly>, factor: Value, vector: &[Value]) -> Vec<Value> {
    vector.iter().map(|&component| program.multiply(component, factor)).collect()
}

/// A sum of products, each added or subtracted (`true`), in this order; negative factors change the sign of their
/// product.
pub(super) fn sum_of(program: &mut Program<Poly>, products: &[(Value, Value, bool)]) -> Value {
    let mut sum: Option<(bool, Value)> = None;
    for &(a, b, minus) in products {
        let ((minus_a, a), (minus_b, b)) = (split_sign(program, a), split_sign(program, b));
        let (minus, term) = (minus ^ minus_a ^ minus_b, program.multiply(a, b));
        if is_zero(program, term) {
            continue;
        }
        sum = Some(match sum {
            None => (minus, term),
            Some((negative, sum)) if negative == minus => (negative, program.add(sum, term)),
            Some((false, sum)) => (false, program.subtract(sum, term)),
            Some((true, sum)) => (false, program.subtract(term, sum)),
        });
    }
    match sum {
        None => program.constant(Poly::zero()),
        Some((true, sum)) => program.negate(sum),
        Some((false, sum)) => sum,
    }
}

/// Whether a value is −a, and a; else the value itself.
pub(super) fn split_sign(program: &Program<Poly>, value: Value) -> (bool, Value) {
    match *program.operation(value) {
        Operation::Negate(a) => (true, a),
        _ => (false, value),
    }
}

/// Whether a value is the constant 0.
pub(super) fn is_zero(program: &Program<Poly>, value: Value) -> bool {
    matches!(program.operation(value), Operation::Constant(constant) if constant.is_zero())
}
