//! Values with the square root of a function: formulas in fundamental forms, scalars and vectors.

use std::rc::Rc;

use hodograph_algebra::{
    FormError, FormFunction, Fraction, QuadraticFraction, SweptSurface, Vector, integer,
};

use super::expression::shortened;
use super::fault::Fault;
use super::value::Value;
use crate::language::Span;

/// A formula in the fundamental forms of a surface.
#[derive(Clone, Debug)]
pub(super) struct FormValue {
    /// The surface.
    pub surface: Rc<SweptSurface>,
    /// The formula.
    pub function: FormFunction,
}

impl FormValue {
    /// Its value on the surface.
    pub(super) fn value(&self) -> Result<QuadraticFraction, FormError> {
        let forms =
            self.surface.forms().map_err(|_| FormError::Vanishes { divisor: "E*G - F^2".to_owned() })?;
        forms.value(&self.function)
    }

    /// The same formula's value in place of both, if they are about one surface.
    fn with(&self, function: FormFunction) -> Value {
        Value::Form(Rc::new(FormValue { surface: self.surface.clone(), function }))
    }
}

/// Whether one of two operands has, or may have, a square root.
pub(super) fn concern(a: &Value, b: &Value) -> bool {
    is_rooted(a) || is_rooted(b)
}

/// Whether a value is of a kind that may have a square root.
pub(super) fn is_rooted(value: &Value) -> bool {
    matches!(value.bare(), Value::Form(_) | Value::Root(_) | Value::RootVector(_))
}

/// A scalar as a value, without root where it is rational.
fn scalar_value(value: QuadraticFraction) -> Value {
    match value.to_rational_function() {
        Some(rational) => Value::Scalar(rational),
        None => Value::Root(Rc::new(value)),
    }
}

/// A scalar or vector as a value, without roots where it is rational.
pub(super) fn value_of(mut parts: Vec<QuadraticFraction>) -> Value {
    if parts.len() == 1 {
        return scalar_value(parts.remove(0));
    }
    let rational: Option<Vec<Fraction>> = parts.iter().map(QuadraticFraction::to_rational_function).collect();
    match rational.as_deref() {
        Some([x, y, z]) => Value::Vector(Vector::new(x.clone(), y.clone(), z.clone())),
        _ => Value::RootVector(parts.into()),
    }
}

/// The components of a scalar, or of a vector, with their square roots; `None` for other kinds.
pub(super) fn parts(value: &Value, span: Span) -> Result<Option<Vec<QuadraticFraction>>, Fault> {
    Ok(match value.bare() {
        Value::Form(form) => Some(vec![form.value().map_err(|error| fault(span, &error))?]),
        Value::Root(root) => Some(vec![root.as_ref().clone()]),
        Value::RootVector(parts) => Some(parts.to_vec()),
        other => match (other.scalar(), other.vector()) {
            (Some(scalar), _) => Some(vec![scalar.into()]),
            (_, Some(vector)) => Some(vector.components().iter().cloned().map(Into::into).collect()),
            _ => None,
        },
    })
}

/// The scalar that must be rational.
pub(super) fn rational(value: &Value, span: Span) -> Result<Fraction, Fault> {
    match parts(value, span)?.as_deref() {
        Some([one]) => one.to_rational_function().ok_or_else(|| irrational(span, one)),
        Some([one, ..]) => Err(irrational(span, one)),
        _ => Err(Fault::new(span, format!("this must be a scalar, but it is {}", value.kind()))),
    }
}

/// What has a square root where a rational function is needed.
pub(super) fn irrational(span: Span, value: &QuadraticFraction) -> Fault {
    let radicand = shortened(&value.radicand().to_string());
    let message = format!("this square root is not a rational function: {radicand} is not a square");
    let mut fault =
        Fault::new(span, message).help("roots of functions must be exact: only squares have them");
    fault.irrational = true;
    fault
}

/// Why a formula in fundamental forms has no value.
pub(super) fn fault(span: Span, error: &FormError) -> Fault {
    let fault = Fault::new(span, error.to_string());
    match error {
        FormError::Weight { .. } | FormError::Mixed => fault
            .help("similarity functions scale as lengths do: R.L - 2*R.M + R.N, R.H/R.K, 1/R.H, R.E/R.L, …"),
        FormError::Vanishes { .. } => fault.help("take a formula without this divisor"),
        _ => fault.undecidable(),
    }
}

/// The formula that a value is for the surface of `form`: another formula for it, or a rational coefficient.
fn formula(form: &FormValue, value: &Value) -> Option<FormFunction> {
    match value.bare() {
        Value::Form(other) => same(&form.surface, &other.surface).then(|| other.function.clone()),
        Value::Scalar(coefficient) => Some(coefficient.clone().into()),
        _ => None,
    }
}

/// Whether two surfaces are the same.
pub(super) fn same(a: &Rc<SweptSurface>, b: &Rc<SweptSurface>) -> bool {
    Rc::ptr_eq(a, b) || (a.parameters() == b.parameters() && a.position() == b.position())
}

/// Both operands as formulas for one surface, with one that has the surface.
fn formulas<'a>(a: &'a Value, b: &'a Value) -> Option<(&'a FormValue, FormFunction, FormFunction)> {
    let form = match (a.bare(), b.bare()) {
        (Value::Form(form), _) | (_, Value::Form(form)) => form,
        _ => return None,
    };
    Some((form, formula(form, a)?, formula(form, b)?))
}

fn differing(span: Span) -> Fault {
    Fault::new(span, "this has another square root than what stands before it")
        .help("there is a form for one square root only; state squares, or split the formula")
}

/// The sum or, with `negative`, the difference.
pub(super) fn sum(a: &Value, b: &Value, negative: bool, span: Span) -> Result<Option<Value>, Fault> {
    let sign = Fraction::from(integer(if negative { -1 } else { 1 }));
    if let Some((form, a, b)) = formulas(a, b) {
        return Ok(Some(form.with(a.plus(&b.times(&sign.into())))));
    }
    let (Some(a), Some(b)) = (parts(a, span)?, parts(b, span)?) else { return Ok(None) };
    if a.len() != b.len() {
        return Ok(None);
    }
    let sums: Option<Vec<_>> = a.iter().zip(&b).map(|(a, b)| a.plus(&b.scale(&sign))).collect();
    sums.map(value_of).map(Some).ok_or_else(|| differing(span))
}

/// The product of two scalars, or of a scalar and a vector.
pub(super) fn product(a: &Value, b: &Value, span: Span) -> Result<Option<Value>, Fault> {
    if let Some((form, a, b)) = formulas(a, b) {
        return Ok(Some(form.with(a.times(&b))));
    }
    let (Some(a), Some(b)) = (parts(a, span)?, parts(b, span)?) else { return Ok(None) };
    let (factor, others) = match (a.as_slice(), b.as_slice()) {
        ([factor], others) | (others, [factor]) => (factor, others),
        _ => return Ok(None),
    };
    let products: Option<Vec<_>> = others.iter().map(|other| other.times(factor)).collect();
    products.map(value_of).map(Some).ok_or_else(|| differing(span))
}

/// The quotient by a scalar.
pub(super) fn quotient(a: &Value, b: &Value, span: Span) -> Result<Option<Value>, Fault> {
    let zero = || Fault::new(span, "division by zero");
    if let Some((form, a, b)) = formulas(a, b) {
        return Ok(Some(form.with(a.times(&b.reciprocal().ok_or_else(zero)?))));
    }
    let Some(divisor) = parts(b, span)? else { return Ok(None) };
    let [divisor] = divisor.as_slice() else { return Ok(None) };
    product(a, &scalar_value(divisor.reciprocal().ok_or_else(zero)?), span)
}

/// The power with a natural number for its exponent.
pub(super) fn power(base: &Value, exponent: u32, span: Span) -> Result<Option<Value>, Fault> {
    if let Value::Form(form) = base.bare() {
        return Ok(Some(form.with(form.function.pow(exponent))));
    }
    let mut result = Value::Scalar(Fraction::one());
    for _ in 0..exponent {
        match product(&result, base, span)? {
            Some(next) => result = next,
            None => return Ok(None),
        }
    }
    Ok(Some(result))
}

/// The scalar product of two vectors.
pub(super) fn dot(a: &Value, b: &Value, span: Span) -> Result<Option<Value>, Fault> {
    let (Some(a), Some(b)) = (parts(a, span)?, parts(b, span)?) else { return Ok(None) };
    if a.len() != 3 || b.len() != 3 {
        return Ok(None);
    }
    let mut sum = QuadraticFraction::from(Fraction::zero());
    for (a, b) in a.iter().zip(&b) {
        sum = a.times(b).and_then(|product| sum.plus(&product)).ok_or_else(|| differing(span))?;
    }
    Ok(Some(scalar_value(sum.map(&|part| part.reduced()))))
}
