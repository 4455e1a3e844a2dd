//! Bernstein forms in the language: `bernstein`, `bernstein_product`, `bernstein_coefficient`.

use hodograph_algebra::{Bernstein, Fraction, Poly, Vector, bernstein_product, bernstein_sum};

use super::calls::Call;
use super::fault::Fault;
use super::functions::{parameter, polynomial};
use super::scope::Scope;
use super::value::Value;
use crate::language::ast::Expr;

/// The largest degree of a form.
const MAX_DEGREE: i64 = 100;

/// The value of a call.
pub(super) fn function(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    match call.name {
        "bernstein" => {
            let [list, t] = call.positional()?;
            sum(scope, list, t)
        }
        "bernstein_product" => {
            let [b, c] = call.positional()?;
            let product = bernstein_product(&scalars(scope, b)?, &scalars(scope, c)?);
            Ok(Value::List(product.into_iter().map(|part| Value::Scalar(part.into())).collect()))
        }
        _ => coefficient(scope, call),
    }
}

/// `bernstein([b0, …, bn], t)`: the sum of the list's scalars or vectors with the Bernstein polynomials of t.
fn sum(scope: &Scope, list: &Expr, t: &Expr) -> Result<Value, Fault> {
    let t = polynomial(scope, t)?;
    let values = elements(scope, list)?;
    if values.iter().all(|value| value.scalar().is_some()) {
        return Ok(Value::Scalar(bernstein_sum(&polys(list, &values, None)?, &t).into()));
    }
    let on =
        |axis: usize| Ok::<_, Fault>(Fraction::from(bernstein_sum(&polys(list, &values, Some(axis))?, &t)));
    Ok(Value::Vector(Vector::new(on(0)?, on(1)?, on(2)?)))
}

/// `bernstein_coefficient(f, v, n, k)`: the k-th of the n + 1 Bernstein coefficients on the domain of v.
fn coefficient(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let [f, by, degree, index] = call.positional()?;
    let poly = polynomial(scope, f)?;
    let by = parameter(scope, by)?;
    let Some(domain) = scope.domains.get(&by) else {
        let fault = Fault::new(call.span, format!("the domain of `{by}` is not stated"));
        return Err(fault.help(format!("add `domain {by} in 0..1;`")));
    };
    let small = |expr: &Expr, role: &str, most: i64| {
        let number = scope.rational(expr, role)?;
        let number = number.is_integer().then(|| number.to_integer().small()).flatten();
        number
            .filter(|number| (0..=most).contains(number))
            .ok_or_else(|| Fault::new(expr.span(), format!("{role} is an integer from 0 to {most}")))
    };
    let n = small(degree, "the degree of a Bernstein form", MAX_DEGREE)?;
    let k = small(index, "the index of a Bernstein coefficient", n)?;
    let (n, k) = (u32::try_from(n).unwrap_or(0), u32::try_from(k).unwrap_or(0));
    let form = Bernstein::with_degrees(&poly, &[(by.clone(), domain.clone())], &[n]);
    let found = form.as_ref().and_then(|form| form.coefficient(&[k]));
    found.map(|found| Value::Scalar(found.clone().into())).ok_or_else(|| {
        Fault::new(degree.span(), format!("the degree of this polynomial in `{by}` is higher than {n}"))
    })
}

fn elements(scope: &Scope, list: &Expr) -> Result<Vec<Value>, Fault> {
    match scope.evaluate(list)? {
        Value::List(values) if !values.is_empty() && values.len() as i64 <= MAX_DEGREE + 1 => Ok(values),
        Value::List(_) => {
            let message = format!("a Bernstein form has from 1 to {} coefficients", MAX_DEGREE + 1);
            Err(Fault::new(list.span(), message))
        }
        other => {
            let message = format!("the Bernstein coefficients are a list, but this is {}", other.kind());
            Err(Fault::new(list.span(), message).help("write `[b0, b1, b2]`"))
        }
    }
}

fn scalars(scope: &Scope, list: &Expr) -> Result<Vec<Poly>, Fault> {
    let values = elements(scope, list)?;
    if values.iter().any(|value| value.scalar().is_none()) {
        return Err(Fault::new(list.span(), "the factors' Bernstein coefficients are scalars"));
    }
    polys(list, &values, None)
}

/// The polynomials that scalars are, or those on one axis of vectors.
fn polys(list: &Expr, values: &[Value], axis: Option<usize>) -> Result<Vec<Poly>, Fault> {
    let poly = |value: &Value| {
        let part = match axis {
            None => value.scalar(),
            Some(axis) => value.vector().map(|vector| vector.components()[axis].clone()),
        };
        part.and_then(|part| part.to_poly()).ok_or_else(|| {
            let message =
                "Bernstein coefficients are scalars or vectors without denominators, all of one kind";
            Fault::new(list.span(), message)
        })
    };
    values.iter().map(poly).collect()
}
