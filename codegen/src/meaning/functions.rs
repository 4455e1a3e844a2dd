//! The functions of the language: derivatives, roots, angles, degrees, offsets.

use std::collections::BTreeSet;
use std::rc::Rc;

use hodograph_algebra::{
    Bidegree, BoxSign, Curve, Fraction, Homogeneous, NotConstructible, OffsetError, Point, Poly,
    QuadraticFraction, Rational, Variable, Vector, cos_pi, exp_i_pi, integer, rational_root, sin_pi,
};

use super::calls::Call;
use super::fault::Fault;
use super::scope::{COORDINATES, Scope};
use super::value::{ComplexFraction, DegreeValue, Value};
use super::{curves, products, roots, spatial, surfaces};
use crate::language::Span;
use crate::language::ast::{Expr, ExprKind};

/// The value of a call of a function of the language.
pub(super) fn function(scope: &Scope, name: &str, call: &Call<'_>) -> Result<Value, Fault> {
    // What functions have on the stack adds up where calls are nested, so that each is by itself.
    match name {
        "diff" => derivative(scope, call),
        "dot" => products::dot(scope, call),
        "cross" => products::cross(call),
        "norm2" => products::norm2(scope, call),
        "conj" | "re" | "im" => products::part(scope, name, call),
        "sqrt" => square_root(scope, call),
        "abs" => absolute(scope, call),
        "exp" | "cos" | "sin" => angle(scope, call),
        "degree" => degree(scope, call),
        "homogeneous" => coordinates(scope, call),
        "normal" => normal(scope, call),
        "offset" => offset(scope, call),
        "gcd" => gcd(scope, call),
        "resultant" => resultant(scope, call),
        "continuity" => super::pieces::continuity(scope, call),
        "bernstein" | "bernstein_coefficient" | "bernstein_product" => {
            super::bernstein::function(scope, call)
        }
        "frame" => super::frames::frame(scope, call),
        "frames" | "frames_file" => super::frames::motion(scope, call),
        "bezier_patch" | "similarity" | "similarity_offset" => surfaces::function(scope, call),
        "quat" => spatial::quaternion(scope, call),
        "canal" | "pipe" => spatial::canal(scope, call),
        "approx" | "coprime" | "is_pn" | "is_rational" | "parallel" | "positive" => Err(no_value(name, call)),
        _ => curves::constructor(scope, call),
    }
}

fn no_value(name: &str, call: &Call<'_>) -> Fault {
    let fault = Fault::new(call.span, format!("`{name}` is a relation and has no value"));
    fault.help("relations stand in `claim` clauses")
}

fn absolute(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let [a] = call.positional()?;
    let number = scope.number(a, "the argument of `abs`")?;
    let negative = number.sign().is_lt();
    Ok(Value::Scalar(if negative { (-number).into() } else { number.into() }))
}

fn coordinates(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let [a] = call.positional()?;
    let homogeneous = homogeneous(scope, call, a)?;
    Ok(Value::Tuple(homogeneous.coordinates().iter().map(|poly| poly.clone().into()).collect()))
}

fn normal(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let [a] = call.positional()?;
    match scope.evaluate(a)?.bare() {
        Value::Surface(surface) => {
            let normal = surface.normal().map_err(|error| Fault::offset(a.span(), &error))?;
            let [x, y, z] = normal.numerator().each_ref().map(|poly| Fraction::from(poly.clone()));
            Ok(Value::Vector(Vector::new(x, y, z)))
        }
        other => {
            let message = format!("`normal` needs the surface, but this is {}", other.kind());
            Err(Fault::new(a.span(), message).help("the normal of a curve is `s.normal`"))
        }
    }
}

fn offset(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let [surface, distance] = call.positional()?;
    let distance = scope.scalar(distance, "the distance of an offset")?;
    match scope.evaluate(surface)?.bare() {
        Value::Surface(surface) => Ok(Value::Offset(Rc::new(surface.offset(&distance)))),
        Value::Curve(curve) => {
            curve.offset(&distance).map(Value::Vector).map_err(|error| Fault::curve(call.span, &error))
        }
        other => {
            let message = format!("`offset` needs a surface or a curve, but this is {}", other.kind());
            Err(Fault::new(surface.span(), message))
        }
    }
}

fn gcd(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let polys = call.several()?.into_iter().map(|expr| polynomial(scope, expr));
    Ok(Value::Scalar(Poly::gcd_many(&polys.collect::<Result<Vec<_>, _>>()?).into()))
}

/// A parameter, given by its name.
pub(super) fn parameter(scope: &Scope, expr: &Expr) -> Result<Variable, Fault> {
    let ExprKind::Ident(name) = expr.kind() else {
        return Err(
            Fault::new(expr.span(), "a parameter is expected here").help("give its name, such as `u`")
        );
    };
    let found = scope.parameters.iter().find(|parameter| parameter.name() == name);
    found.cloned().ok_or_else(|| {
        let known: Vec<&str> = scope.parameters.iter().map(Variable::name).collect();
        let fault = Fault::new(expr.span(), format!("`{name}` is not a parameter"));
        if known.is_empty() { fault } else { fault.help(format!("the parameters are {}", known.join(", "))) }
    })
}

fn derivative(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let (positional, []) = call.with_names([])?;
    let (value, by, order) = match positional.as_slice() {
        [value, by] => (*value, *by, 1),
        [value, by, order] => {
            let n = scope.rational(order, "the order of a derivative")?;
            let small =
                n.is_integer().then(|| n.to_integer().small()).flatten().filter(|n| (0..=100).contains(n));
            let message = "the order of a derivative is an integer from 0 to 100";
            (*value, *by, small.ok_or_else(|| Fault::new(order.span(), message))?)
        }
        _ => return Err(Fault::new(call.span, "`diff` takes a function and a parameter: `diff(f, u)`")),
    };
    let by = parameter(scope, by)?;
    let calculus = &scope.calculus;
    let scalar = |f: &Fraction| (0..order).fold(f.clone(), |f, _| calculus.derivative(&f, &by));
    let evaluated = scope.evaluate(value)?;
    Ok(match evaluated.bare() {
        Value::Scalar(f) => Value::Scalar(scalar(f)),
        Value::Complex(f) => Value::Complex(ComplexFraction { re: scalar(&f.re), im: scalar(&f.im) }),
        Value::Quaternion(f) => Value::Quaternion(f.map(scalar)),
        rooted if roots::is_rooted(rooted) => {
            let parts = roots::parts(rooted, value.span())?.unwrap_or_default();
            let derive = |f: &Fraction| calculus.derivative(f, &by);
            let derived = |part| (0..order).fold(part, |part: QuadraticFraction, _| part.derivation(&derive));
            roots::value_of(parts.into_iter().map(derived).collect())
        }
        _ => {
            let derived = Value::Vector(call.vector_of(value, &evaluated)?.map(scalar));
            // The derivative of a curve is a function of the curve's parameter.
            match evaluated.bare() {
                Value::Curve(curve) if *curve.parameter() == by => as_function(curve, derived),
                _ => derived,
            }
        }
    })
}

fn as_function(curve: &Curve, value: Value) -> Value {
    let parameters = vec![curve.parameter().clone()];
    Value::Function(Rc::new(super::value::FunctionValue { parameters, value }))
}

fn square_root(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let [a] = call.positional()?;
    let value = scope.scalar(a, "a radicand")?;
    if value.is_zero() {
        return Ok(Value::Scalar(value));
    }
    if let Some(number) = value.to_number() {
        return match number.sqrt() {
            Some(root) => Ok(Value::Scalar(root.into())),
            None => {
                let fault = Fault::new(
                    a.span(),
                    format!("the radicand {} is negative", super::expression::shortened(&number.to_string())),
                );
                Err(fault.help("write `I*sqrt(…)` for the square root of a negative number"))
            }
        };
    }
    if let Ok(root) = rational_root(&value.reduced()) {
        return nonnegative(scope, &root.lowest_terms(), a.span()).map(Value::Scalar);
    }
    if let Some((radicand, _)) = symbolic_radicand(scope, &value) {
        let radicand = super::expression::shortened(&radicand.to_string());
        let message = format!(
            "the square root of {radicand} depends on the symbols alone, but is no rational function of them"
        );
        let mut fault =
            Fault::new(a.span(), message).help("introduce a symbol for the root, or set symbols by `when`");
        fault.undecidable = true;
        return Err(fault);
    }
    let root = QuadraticFraction::root_of(&value).ok_or_else(|| {
        Fault::new(a.span(), "this square root has no form here").help("the radicand must not be negative")
    })?;
    // √(f²q) = |f|·√q
    let factor = nonnegative(scope, &root.root_part().lowest_terms(), a.span()).map_err(|fault| {
        // Whatever the sign of f, the root is irrational.
        Fault { irrational: true, ..fault }
    })?;
    let negative = factor != *root.root_part();
    Ok(Value::Root(Rc::new(if negative { root.scale(&integer(-1).into()) } else { root })))
}

/// Whether a polynomial depends on a parameter or an unknown function: with numbers for the symbols it is no number.
pub(super) fn is_varying(scope: &Scope, poly: &Poly) -> bool {
    let varies =
        |variable: &Variable| scope.parameters.contains(variable) || scope.calculus.is_function(variable);
    poly.occurring_variables().iter().any(varies)
}

/// The squarefree part `d` that depends on symbols alone, and the factor `f` of a root `f·√d`; `None` if the part that is
/// no square depends on more.
fn symbolic_radicand(scope: &Scope, radicand: &Fraction) -> Option<(Poly, Fraction)> {
    let radicand = radicand.lowest_terms();
    let odd = radicand.factors().iter().filter(|(_, exponent)| exponent % 2 == 1);
    let split =
        odd.fold(radicand.numerator().clone(), |product, (factor, _)| product * factor).square_split();
    if is_varying(scope, &split.odd) || split.is_square() {
        return None;
    }
    let below = radicand.factors().iter().map(|(factor, exponent)| (factor.clone(), exponent.div_ceil(2)));
    Some((&split.unit * &split.odd, Fraction::new(split.root, below)))
}

/// The polynomial `d` in symbols alone for a call `sqrt(f^2*d)`, which is no rational function of the symbols, but of the
/// parameters. `None` for other expressions.
///
/// # Errors
/// If the sign of f changes on the domain or is not known.
pub(super) fn symbolic_root(scope: &Scope, expr: &Expr) -> Result<Option<Poly>, Fault> {
    let ExprKind::Call { callee, arguments } = expr.kind() else { return Ok(None) };
    let (ExprKind::Ident(name), [argument]) = (callee.kind(), arguments.as_slice()) else { return Ok(None) };
    if name != "sqrt" {
        return Ok(None);
    }
    let Ok(value) = scope.scalar(&argument.value, "a radicand") else { return Ok(None) };
    let Some((radicand, factor)) = symbolic_radicand(scope, &value) else { return Ok(None) };
    let varying = Fraction::new(
        varying_part(scope, factor.numerator()),
        factor.factors().iter().map(|(part, exponent)| (varying_part(scope, part), *exponent)),
    );
    nonnegative(scope, &varying, argument.value.span())?;
    Ok(Some(radicand))
}

/// A polynomial without the factors that depend on symbols alone.
fn varying_part(scope: &Scope, poly: &Poly) -> Poly {
    let coefficients: Vec<Poly> = poly.coefficients_of(&scope.parameters).into_values().collect();
    let content = Poly::gcd_many(&coefficients);
    if is_varying(scope, &content) {
        poly.clone()
    } else {
        poly.exact_div(&content).unwrap_or_else(|| poly.clone())
    }
}

/// Whether a polynomial in one variable is certified to be positive for all of its values.
pub(super) fn is_positive_everywhere(poly: &Poly) -> bool {
    let variables = poly.occurring_variables();
    let [variable] = variables.as_slice() else { return false };
    let at_zero = poly.evaluate(&Point::from([(variable.clone(), Poly::zero())]));
    at_zero.sign().is_gt() && poly.real_roots(variable).is_some_and(|roots| roots.is_empty())
}

/// The one of `root` and `-root` that is not negative on the domain.
fn nonnegative(scope: &Scope, root: &Fraction, span: Span) -> Result<Fraction, Fault> {
    let unknown = |why: String, help: &str| {
        let root = super::expression::shortened(&root.to_string());
        Err(Fault::new(span, format!("this square root is the absolute value of {root}, and {why}"))
            .help(help))
    };
    // Even powers have no sign; a factor and its reciprocal have the same one.
    let squarefree = root.numerator().squarefree();
    let factors = root.factors().iter().cloned().chain(squarefree.factors);
    let signed: Vec<Poly> = factors
        .filter(|(factor, exponent)| exponent % 2 == 1 && !is_positive_everywhere(factor))
        .map(|(factor, _)| factor)
        .collect();
    let varying: BTreeSet<Variable> = signed.iter().flat_map(Poly::occurring_variables).collect();
    let mut domain = Vec::new();
    for variable in varying {
        let Some(interval) = scope.domains.get(&variable) else {
            let help =
                "write the root itself, with the sign that is meant, or state the domain of the parameter";
            return unknown(format!("nothing is known of the sign of `{variable}`"), help);
        };
        domain.push((variable, interval.clone()));
    }
    let signed = signed.iter().fold(squarefree.unit, |product, factor| product * factor);
    match signed.sign_on(&domain) {
        Some(BoxSign::Positive | BoxSign::Zero | BoxSign::NonNegative { .. }) => Ok(root.clone()),
        Some(BoxSign::Negative | BoxSign::NonPositive { .. }) => Ok(-root),
        _ => unknown("that changes its sign on the domain".to_owned(), "state a smaller domain"),
    }
}

/// The rational `q` of an argument `q·π`, for `what` in `cos(q·π)`.
fn multiple_of_pi(expr: &Expr, angle: &Fraction) -> Result<Rational, Fault> {
    let pi = Variable::new(Variable::SYMBOL, "pi");
    let rational = angle.to_poly().filter(|poly| poly.degree(&pi).unwrap_or(0) <= 1).and_then(|poly| {
        let coefficients = poly.coefficients(&pi);
        let constant = coefficients.first().map_or(Some(integer(0)), Poly::to_rational)?;
        let slope = coefficients.get(1).map_or(Some(integer(0)), Poly::to_rational)?;
        (constant == integer(0)).then_some(slope)
    });
    rational.ok_or_else(|| {
        Fault::new(expr.span(), "this angle is not a rational multiple of pi")
            .help("write it as `pi/8` or `3*pi/4`; other angles have no exact value here")
    })
}

fn angle(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let [a] = call.positional()?;
    let not_constructible = |error: NotConstructible| Fault::new(a.span(), error.to_string());
    if call.name == "exp" {
        let value = scope.evaluate(a)?;
        let complex = value.complex().ok_or_else(|| {
            Fault::new(a.span(), format!("`exp` needs an imaginary number, but this is {}", value.kind()))
        })?;
        if !complex.re.is_zero() {
            let fault = Fault::new(a.span(), "the exponential of a number with a real part is not algebraic");
            return Err(fault.help("write `exp(I*pi/8)`, an imaginary multiple of pi"));
        }
        let unit = exp_i_pi(&multiple_of_pi(a, &complex.im)?).map_err(not_constructible)?;
        return Ok(Value::Complex(ComplexFraction { re: unit.re.into(), im: unit.im.into() }));
    }
    let multiple = multiple_of_pi(a, &scope.scalar(a, "an angle")?)?;
    let value = if call.name == "cos" { cos_pi(&multiple) } else { sin_pi(&multiple) };
    Ok(Value::Scalar(value.map_err(not_constructible)?.into()))
}

/// The polynomial that an argument must be.
pub(super) fn polynomial(scope: &Scope, expr: &Expr) -> Result<Poly, Fault> {
    let value = scope.scalar(expr, "this")?;
    value.to_poly().ok_or_else(|| {
        let fault = Fault::new(
            expr.span(),
            format!(
                "this must be a polynomial, but it has the denominator {}",
                value.reduced().denominator()
            ),
        );
        fault.help("the homogeneous coordinates W, X, Y, Z are polynomials")
    })
}

/// `resultant(f, g, parameter = v)`.
fn resultant(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let (positional, [by]) = call.with_names(["parameter"])?;
    let ([f, g], Some(by)) = (positional.as_slice(), by) else {
        let fault = Fault::new(call.span, "`resultant` takes two polynomials and the parameter to eliminate");
        return Err(fault.help("write `resultant(f, g, parameter = v)`"));
    };
    let by = parameter(scope, by)?;
    Ok(Value::Scalar(polynomial(scope, f)?.resultant(&polynomial(scope, g)?, &by).into()))
}

fn homogeneous(scope: &Scope, call: &Call<'_>, expr: &Expr) -> Result<Homogeneous, Fault> {
    let value = scope.evaluate(expr)?;
    match value.bare() {
        Value::Surface(surface) => return Ok(surface.homogeneous().clone()),
        Value::Offset(offset) => {
            if let Err(OffsetError::SymbolicRadical { surface: Some(surface), .. }) = offset.as_ref() {
                return Ok(Homogeneous::of(&surface.position, &surface_parameters(scope)));
            }
            return offset
                .as_ref()
                .as_ref()
                .map(|surface| surface.homogeneous().clone())
                .map_err(|error| Fault::offset(expr.span(), error));
        }
        _ => {}
    }
    Ok(Homogeneous::of(&call.vector_of(expr, &value)?, &surface_parameters(scope)))
}

/// The two parameters of the item, with a stand-in for one that is not there.
pub(super) fn surface_parameters(scope: &Scope) -> [Variable; 2] {
    if let Some(surface) = &scope.surface {
        return surface.parameters().clone();
    }
    let at = |index: usize| scope.parameters.get(index).cloned();
    let missing = |index: u32| Variable::new(index, "");
    [at(0).unwrap_or_else(|| missing(0)), at(1).unwrap_or_else(|| missing(1))]
}

fn degree(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let (exprs, [by]) = call.with_names(["parameter"])?;
    if exprs.is_empty() {
        return Err(Fault::new(call.span, "`degree` needs the polynomials whose degree is meant"));
    }
    let mut polynomials: Vec<(String, Poly)> = Vec::new();
    for expr in exprs {
        match scope.evaluate(expr)?.scalar() {
            Some(_) => polynomials.push((expr.to_string(), polynomial(scope, expr)?)),
            None => {
                let coordinates = homogeneous(scope, call, expr)?.coordinates().clone();
                let names = COORDINATES.map(|coordinate| format!("homogeneous({expr}).{coordinate}"));
                polynomials.extend(names.into_iter().zip(coordinates));
            }
        }
    }
    let polys = || polynomials.iter().map(|(_, poly)| poly);
    let mut variables: Vec<Variable> = polys().flat_map(Poly::occurring_variables).collect();
    variables.sort();
    variables.dedup();
    if let Some(function) = variables.iter().find(|variable| scope.calculus.is_function(variable)) {
        let message = format!("the unknown function `{function}` has no degree");
        return Err(
            Fault::new(call.span, message).help("write a polynomial with symbols for its coefficients")
        );
    }
    if let Some(by) = by {
        let by = parameter(scope, by)?;
        let degree = polys().map(|poly| poly.degree(&by).map_or(-1, i64::from)).max().unwrap_or(-1);
        let value = DegreeValue { degrees: vec![degree], variables, parameters: vec![by], polynomials };
        return Ok(Value::Degree(Rc::new(value)));
    }
    if scope.surface.is_none() && scope.parameters.len() != 2 {
        let known: Vec<&str> = scope.parameters.iter().map(Variable::name).collect();
        let fault = Fault::new(call.span, "a bidegree needs two parameters");
        return Err(fault.help(format!(
            "here are {}; write `degree(f, parameter = v)` for one",
            if known.is_empty() { "none".to_owned() } else { known.join(", ") }
        )));
    }
    let parameters = surface_parameters(scope);
    let Bidegree { u, v } = Bidegree::of_group(polys(), &parameters);
    let value = DegreeValue { degrees: vec![u, v], variables, parameters: parameters.to_vec(), polynomials };
    Ok(Value::Degree(Rc::new(value)))
}
