//! Products of vectors, and what they are of complex numbers and quaternions.

use super::calls::Call;
use super::fault::Fault;
use super::roots;
use super::scope::Scope;
use super::value::Value;

/// `dot(a, b)`.
pub(super) fn dot(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let [a, b] = call.positional()?;
    let (left, right) = (scope.evaluate(a)?, scope.evaluate(b)?);
    if roots::concern(&left, &right)
        && let Some(product) = roots::dot(&left, &right, call.span)?
    {
        return Ok(product);
    }
    Ok(Value::Scalar(call.vector_of(a, &left)?.dot(&call.vector_of(b, &right)?)))
}

/// `cross(a, b)`.
pub(super) fn cross(call: &Call<'_>) -> Result<Value, Fault> {
    let [a, b] = call.positional()?;
    Ok(Value::Vector(call.vector(a)?.cross(&call.vector(b)?)))
}

/// `norm2(a)`.
pub(super) fn norm2(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let [a] = call.positional()?;
    let value = scope.evaluate(a)?;
    if let Value::Quaternion(quaternion) = value.bare() {
        return Ok(Value::Scalar(quaternion.norm2()));
    }
    if roots::is_rooted(&value)
        && let Some(product) = roots::dot(&value, &value, call.span)?
    {
        return Ok(product);
    }
    match value.complex() {
        Some(complex) => Ok(Value::Scalar(complex.norm2())),
        None => Ok(Value::Scalar(call.vector_of(a, &value)?.norm2())),
    }
}

/// `conj(a)`, `re(a)` and `im(a)`.
pub(super) fn part(scope: &Scope, name: &str, call: &Call<'_>) -> Result<Value, Fault> {
    let [a] = call.positional()?;
    let value = scope.evaluate(a)?;
    if let (Value::Quaternion(quaternion), "conj") = (value.bare(), name) {
        return Ok(Value::Quaternion(quaternion.conj()));
    }
    let Some(complex) = value.complex() else {
        let message = format!("`{name}` needs a complex number, but this is {}", value.kind());
        return Err(Fault::new(a.span(), message));
    };
    Ok(match name {
        "conj" => Value::Complex(complex.conj()),
        "re" => Value::Scalar(complex.re),
        _ => Value::Scalar(complex.im),
    })
}
