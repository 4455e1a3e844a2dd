//! Functions and members of surfaces: fundamental forms, similarity offsets, similarities, Bézier patches.

use std::rc::Rc;

use hodograph_algebra::{FormFunction, Fraction, Poly, SweptSurface, Vector};

use super::calls::Call;
use super::curves::{bernstein_basis, element};
use super::fault::Fault;
use super::functions::surface_parameters;
use super::roots::{self, FormValue};
use super::scope::Scope;
use super::value::{FunctionValue, Value};
use crate::language::Span;
use crate::language::ast::Expr;

/// The most control points of a Bézier patch in one direction.
const MAX_ROW: usize = 33;

/// The value of a call of a function of surfaces.
pub(super) fn function(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    match call.name {
        "similarity_offset" => similarity_offset(scope, call),
        "similarity" => similarity(scope, call),
        _ => bezier_patch(scope, call),
    }
}

/// Whether a member of this name is about fundamental forms.
pub(super) fn is_form(name: &str) -> bool {
    name == "unit_normal" || FormFunction::named(name).is_some()
}

/// Whether a member changes its sign with the side that the unit normal points to.
pub(super) fn is_sided(name: &str) -> bool {
    matches!(name, "H" | "L" | "M" | "N" | "unit_normal")
}

/// Whether a value is a surface, or a vector that may be one.
pub(super) fn may_be_surface(value: &Value) -> bool {
    match value.bare() {
        Value::Tuple(parts) => parts.len() <= 3,
        other => matches!(other, Value::Surface(_) | Value::Offset(_) | Value::Vector(_)),
    }
}

/// The surface that an argument is.
pub(super) fn surface(scope: &Scope, expr: &Expr) -> Result<Rc<SweptSurface>, Fault> {
    surface_of(scope, expr.span(), &scope.evaluate(expr)?)
}

/// The surface that a value is: a surface, an offset, or a vector in the two parameters of the item.
fn surface_of(scope: &Scope, span: Span, value: &Value) -> Result<Rc<SweptSurface>, Fault> {
    match value.bare() {
        Value::Surface(surface) => return Ok(surface.clone()),
        Value::Offset(offset) => {
            if let Err(error) = offset.as_ref() {
                return Err(Fault::offset(span, error));
            }
        }
        _ => {}
    }
    let position = value.vector().filter(|_| may_be_surface(value)).ok_or_else(|| {
        Fault::new(span, format!("a surface is needed here, but this is {}", value.kind()))
            .help("give the surface, or a vector in its two parameters")
    })?;
    let parameters = surface_parameters(scope);
    if scope.surface.is_none() && scope.parameters.len() != 2 {
        return Err(Fault::new(span, "a surface has two parameters").help("use two parameters in this item"));
    }
    let mut domain = Vec::new();
    for parameter in &parameters {
        let interval = scope.domains.get(parameter).ok_or_else(|| {
            Fault::new(span, format!("the domain of `{parameter}` is not stated"))
                .help(format!("add `domain {parameter} in 0..1;`"))
        })?;
        domain.push(interval.clone());
    }
    let functions = position.components().iter().flat_map(Fraction::occurring_variables);
    if let Some(unknown) = functions.into_iter().find(|variable| scope.calculus.is_function(variable)) {
        let message = format!("a surface cannot contain the unknown function `{unknown}`");
        return Err(Fault::new(span, message).help("use symbols for its derivatives"));
    }
    let [Some(first), Some(second)] = [domain.first(), domain.get(1)] else {
        return Err(Fault::silent(span));
    };
    let made = Rc::new(SweptSurface::new(position, parameters, [first.clone(), second.clone()]));
    let mut known = scope.patches.borrow_mut();
    if let Some(same) =
        known.iter().find(|known| known.domain() == made.domain() && roots::same(known, &made))
    {
        return Ok(same.clone());
    }
    known.push(made.clone());
    Ok(made)
}

/// `R.E`, …, `R.N`, `R.K`, `R.H`, `R.unit_normal`: functions of the parameters.
pub(super) fn form(scope: &Scope, span: Span, value: &Value, name: &str) -> Result<Value, Fault> {
    let surface = surface_of(scope, span, value)?;
    let parameters = surface.parameters().to_vec();
    let forms = surface.forms().map_err(|error| Fault::offset(span, &error))?;
    let value = match FormFunction::named(name) {
        Some(function) => Value::Form(Rc::new(FormValue { surface: surface.clone(), function })),
        None => {
            let normal = forms.unit_normal().map_err(|error| roots::fault(span, &error))?;
            roots::value_of(normal.to_vec())
        }
    };
    Ok(Value::Function(Rc::new(FunctionValue { parameters, value })))
}

/// `similarity_offset(R, f, d)`.
fn similarity_offset(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let [surface, function, distance] = call.positional()?;
    let place = function.span();
    let surface = self::surface(scope, surface)?;
    let value = scope.evaluate(function)?;
    let Value::Form(form) = value.bare() else {
        let message = format!(
            "a similarity function is a formula in E, F, G, L, M, N, K, H, but this is {}",
            value.kind()
        );
        return Err(Fault::new(place, message).help("write `similarity_offset(R, R.H/R.K, d)`"));
    };
    if !roots::same(&form.surface, &surface) {
        return Err(Fault::new(place, "these are the fundamental forms of another surface")
            .help("the formula must be about the surface that is offset"));
    }
    let distance = scope.scalar(distance, "the distance of an offset")?;
    let offset = surface.similarity_offset(&form.function, &distance);
    offset.map(|surface| Value::Surface(Rc::new(surface))).map_err(|error| roots::fault(place, &error))
}

/// `similarity(a, ratio = rho, rotation = (w, x, y, z), translation = t)`.
fn similarity(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let (positional, [ratio, rotation, translation]) =
        call.with_names(["ratio", "rotation", "translation"])?;
    let [argument] = positional.as_slice() else {
        return Err(Fault::new(call.span, "`similarity` takes one vector or surface")
            .help("write `similarity(R, ratio = 2, rotation = (w, x, y, z), translation = (a, b, c))`"));
    };
    let mut image = call.vector(argument)?;
    if let Some(rotation) = rotation {
        let value = scope.evaluate(rotation)?;
        let parts = value.components().unwrap_or_default();
        let [w, x, y, z] = parts.as_slice() else {
            let message =
                format!("a rotation is a quaternion of four components, but this is {}", value.kind());
            return Err(Fault::new(rotation.span(), message).help("write `rotation = (w, x, y, z)`"));
        };
        image = rotated(&image, w, &Vector::new(x.clone(), y.clone(), z.clone()))
            .ok_or_else(|| Fault::new(rotation.span(), "the quaternion zero is no rotation"))?;
    }
    if let Some(ratio) = ratio {
        let ratio = scope.scalar(ratio, "the ratio of a similarity")?;
        image = image.scale(&ratio);
    }
    if let Some(translation) = translation {
        image = &image + &call.vector(translation)?;
    }
    Ok(Value::Vector(image.reduced()))
}

/// The vector a turned by the quaternion w + **q**, which need not be of length 1:
/// `((w² − q·q)·a + 2(q·a)·q + 2w·q × a)/(w² + q·q)`; `None` for the quaternion zero.
fn rotated(a: &Vector, w: &Fraction, q: &Vector) -> Option<Vector> {
    let (square, length) = (w * w, q.norm2());
    let two = |f: &Fraction| f + f;
    let along = q.scale(&two(&q.dot(a)));
    let across = q.cross(a).scale(&two(w));
    let sum = &(&a.scale(&(&square - &length)) + &along) + &across;
    Some(sum.scale(&(&square + &length).reciprocal(&[])?))
}

/// `bezier_patch([[p00, p01, …], …], weights = [[…], …])`.
fn bezier_patch(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let (positional, [weights]) = call.with_names(["weights"])?;
    let [points] = positional.as_slice() else {
        return Err(Fault::new(call.span, "`bezier_patch` takes a net of control points").help(
            "write `bezier_patch([[p00, p01], [p10, p11]])`, a row for each index of the first parameter",
        ));
    };
    let net = net(scope, points, "control points")?;
    let weights =
        weights.map(|weights| self::net(scope, weights, "weights").map(|net| (weights, net))).transpose()?;
    let [u, v] = surface_parameters(scope);
    let columns = net.first().map_or(0, Vec::len);
    if let Some((expr, weights)) = &weights
        && (weights.len() != net.len() || weights.first().map_or(0, Vec::len) != columns)
    {
        let message = format!("{} by {} control points need as many weights", net.len(), columns);
        return Err(Fault::new(expr.span(), message).help("give one weight for each control point"));
    }
    let along = [bernstein_basis(net.len() - 1, &u), bernstein_basis(columns - 1, &v)];
    let (mut position, mut weight) = (Vector::zero(), Fraction::zero());
    for (i, row) in net.iter().enumerate() {
        for (j, value) in row.iter().enumerate() {
            let point = value.vector().ok_or_else(|| {
                let message = format!("a control point must be a vector, but this is {}", value.kind());
                Fault::new(place(points, i, j), message)
            })?;
            let mut basis = Fraction::from(&along[0][i] * &along[1][j]);
            if let Some((expr, weights)) = &weights {
                let value = &weights[i][j];
                let own = value.scalar().ok_or_else(|| {
                    Fault::new(
                        place(expr, i, j),
                        format!("a weight must be a scalar, but this is {}", value.kind()),
                    )
                })?;
                basis = &basis * &own;
            }
            position = Vector::new(
                &position.components()[0] + &(&point.components()[0] * &basis),
                &position.components()[1] + &(&point.components()[1] * &basis),
                &position.components()[2] + &(&point.components()[2] * &basis),
            );
            weight = &weight + &basis;
        }
    }
    if weight.to_poly().is_none_or(|weight: Poly| !weight.is_one()) {
        let zero = || Fault::new(call.span, "the weights cancel: their sum is zero for all parameters");
        let inverse = weight.reciprocal(&[]).ok_or_else(zero)?;
        position = position.map(|component| component * &inverse);
    }
    Ok(Value::Vector(position))
}

/// The rows of a rectangular list of lists.
fn net(scope: &Scope, expr: &Expr, what: &str) -> Result<Vec<Vec<Value>>, Fault> {
    let shape = |span: Span, message: String| {
        Fault::new(span, message).help("write a list of rows of one length, such as `[[a, b], [c, d]]`")
    };
    let Value::List(rows) = scope.evaluate(expr)? else {
        return Err(shape(expr.span(), format!("the {what} must be a list of lists")));
    };
    let mut net: Vec<Vec<Value>> = Vec::new();
    for (index, row) in rows.into_iter().enumerate() {
        let span = element(expr, index).unwrap_or(expr.span());
        let Value::List(row) = row else {
            return Err(shape(
                span,
                format!("a row of the {what} must be a list, but this is {}", row.kind()),
            ));
        };
        if net.first().is_some_and(|first| first.len() != row.len()) {
            return Err(shape(span, format!("this row of the {what} has another length than the first")));
        }
        net.push(row);
    }
    let columns = net.first().map_or(0, Vec::len);
    if columns == 0 || net.len() * columns < 2 {
        return Err(shape(expr.span(), format!("there are no {what} for a patch")));
    }
    if net.len() > MAX_ROW || columns > MAX_ROW {
        return Err(shape(expr.span(), format!("more than {MAX_ROW} rows or columns of {what}")));
    }
    Ok(net)
}

/// Where an entry of a net stands.
fn place(net: &Expr, row: usize, column: usize) -> Span {
    match net.kind() {
        crate::language::ast::ExprKind::Array(rows) => {
            rows.get(row).and_then(|row| element(row, column)).unwrap_or(net.span())
        }
        _ => net.span(),
    }
}
