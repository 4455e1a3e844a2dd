//! Calls: functions of the language, and values for parameters.

use std::collections::BTreeMap;
use std::rc::Rc;

use hodograph_algebra::{
    Bidegree, BoxSign, Curve, Fraction, Homogeneous, NotConstructible, Poly, Rational, Variable, Vector,
    cos_pi, exp_i_pi, integer, rational_root, sin_pi,
};

use super::curves;
use super::fault::Fault;
use super::scope::Scope;
use super::value::{ComplexFraction, DegreeValue, Value};
use crate::language::Span;
use crate::language::ast::{Argument, Expr, ExprKind};

/// The value of `callee(arguments)`.
pub(super) fn call(scope: &Scope, span: Span, callee: &Expr, arguments: &[Argument]) -> Result<Value, Fault> {
    match callee.kind() {
        ExprKind::Ident(name) if super::scope::FUNCTIONS.contains(&name.as_str()) => {
            function(scope, name, &Call { scope, span, name, arguments })
        }
        ExprKind::Member { object, member } => {
            let owner = scope.evaluate(object)?;
            if let Value::Curve(curve) = owner.bare() {
                if member.value == "offset" {
                    let call = Call { scope, span, name: "offset", arguments };
                    let [distance] = call.positional()?;
                    let distance = scope.scalar(distance, "the distance of an offset")?;
                    return curve
                        .offset(&distance)
                        .map(Value::Vector)
                        .map_err(|error| Fault::curve(span, &error));
                }
                let value = super::members::member(scope, callee.span(), object, member)?;
                return apply(scope, span, &value, &[curve.parameter().clone()], arguments);
            }
            let value = scope.evaluate(callee)?;
            apply_value(scope, span, callee, &value, arguments)
        }
        _ => {
            let value = scope.evaluate(callee)?;
            apply_value(scope, span, callee, &value, arguments)
        }
    }
}

fn apply_value(
    scope: &Scope,
    span: Span,
    callee: &Expr,
    value: &Value,
    arguments: &[Argument],
) -> Result<Value, Fault> {
    match value {
        Value::Curve(curve) => apply(scope, span, value, &[curve.parameter().clone()], arguments),
        Value::Surface(surface) => apply(scope, span, value, surface.parameters(), arguments),
        Value::Function(function) => apply(scope, span, &function.value, &function.parameters, arguments),
        Value::Offset(offset) => match offset.as_ref() {
            Ok(surface) => apply(scope, span, value, surface.parameters(), arguments),
            Err(error) => Err(Fault::offset(callee.span(), error)),
        },
        other => {
            let fault = Fault::new(callee.span(), format!("{} cannot be called", other.kind()));
            Err(fault.help("name a function of parameters with `let c(v) = …`, then write `c(1/2)`"))
        }
    }
}

/// The value for given values of the parameters.
fn apply(
    scope: &Scope,
    span: Span,
    value: &Value,
    parameters: &[Variable],
    arguments: &[Argument],
) -> Result<Value, Fault> {
    if arguments.len() != parameters.len() || arguments.iter().any(|argument| argument.name.is_some()) {
        let names: Vec<&str> = parameters.iter().map(Variable::name).collect();
        let message =
            format!("this depends on {}, so it takes {}", names.join(" and "), count(parameters.len()));
        return Err(Fault::new(span, message));
    }
    let mut values = BTreeMap::new();
    for (parameter, argument) in parameters.iter().zip(arguments) {
        let role = format!("the value of `{parameter}`");
        values.insert(parameter.clone(), scope.scalar(&argument.value, &role)?);
    }
    substitute(scope, span, value, &values)
}

/// The value with scalars in place of parameters.
pub(super) fn substitute(
    scope: &Scope,
    span: Span,
    value: &Value,
    values: &BTreeMap<Variable, Fraction>,
) -> Result<Value, Fault> {
    let replace = |fraction: &Fraction| -> Result<Fraction, Fault> {
        let unknown = fraction.occurring_variables().into_iter().find(|variable| {
            let parameter = scope.calculus.parameter_of(variable);
            let changed = |parameter| {
                let value = values.get(parameter);
                value.is_some_and(|value| *value != Fraction::from(Poly::variable(parameter)))
            };
            parameter.is_some_and(changed)
        });
        if let Some(unknown) = unknown {
            return Err(Fault::new(
                span,
                format!("the unknown function `{unknown}` has no value at a point"),
            ));
        }
        let undefined = || {
            let at: Vec<String> =
                values.iter().map(|(variable, value)| format!("{variable} = {value}")).collect();
            Fault::new(span, format!("the expression is not defined at {}", at.join(", ")))
                .help("its denominator vanishes there")
        };
        // What cancels is no pole.
        fraction
            .substitute(values)
            .or_else(|| fraction.lowest_terms().substitute(values))
            .ok_or_else(undefined)
    };
    Ok(match value.bare() {
        Value::Scalar(scalar) => Value::Scalar(replace(scalar)?),
        Value::Complex(complex) => {
            Value::Complex(ComplexFraction { re: replace(&complex.re)?, im: replace(&complex.im)? })
        }
        Value::Tuple(parts) => Value::Tuple(parts.iter().map(replace).collect::<Result<_, _>>()?),
        other => {
            let Some(vector) = other.vector() else {
                return Err(Fault::new(span, format!("{} has no value at a point", other.kind())));
            };
            let [x, y, z] = vector.components();
            Value::Vector(Vector::new(replace(x)?, replace(y)?, replace(z)?))
        }
    })
}

fn count(n: usize) -> String {
    if n == 1 { "one value".to_owned() } else { format!("{n} values") }
}

/// The call of a function of the language.
pub(super) struct Call<'a> {
    pub(super) scope: &'a Scope,
    pub(super) span: Span,
    pub(super) name: &'a str,
    pub(super) arguments: &'a [Argument],
}

impl<'a> Call<'a> {
    /// Exactly `N` arguments without names.
    pub(super) fn positional<const N: usize>(&self) -> Result<[&'a Expr; N], Fault> {
        self.without_names()?;
        let exprs: Vec<&Expr> = self.arguments.iter().map(|argument| &argument.value).collect();
        exprs.try_into().map_err(|exprs: Vec<&Expr>| {
            let message = format!("`{}` takes {}, not {}", self.name, arguments(N), exprs.len());
            Fault::new(self.span, message)
        })
    }

    /// Any number of arguments without names, one at least.
    fn several(&self) -> Result<Vec<&'a Expr>, Fault> {
        self.without_names()?;
        if self.arguments.is_empty() {
            return Err(Fault::new(self.span, format!("`{}` takes one argument at least", self.name)));
        }
        Ok(self.arguments.iter().map(|argument| &argument.value).collect())
    }

    fn without_names(&self) -> Result<(), Fault> {
        match self.arguments.iter().find_map(|argument| argument.name.as_ref()) {
            Some(name) => {
                Err(Fault::new(name.span, format!("`{}` has no argument `{}`", self.name, name.value)))
            }
            None => Ok(()),
        }
    }

    /// The arguments without names, and those with the given names.
    pub(super) fn with_names<const N: usize>(
        &self,
        names: [&str; N],
    ) -> Result<(Vec<&'a Expr>, [Option<&'a Expr>; N]), Fault> {
        let mut positional = Vec::new();
        let mut named = [None; N];
        for argument in self.arguments {
            match &argument.name {
                None => positional.push(&argument.value),
                Some(name) => match names.iter().position(|known| *known == name.value) {
                    Some(index) => named[index] = Some(&argument.value),
                    None => {
                        let message = format!("`{}` has no argument `{}`", self.name, name.value);
                        let fault = Fault::new(name.span, message);
                        return Err(fault.help(format!(
                            "it may have {}",
                            names.map(|n| format!("`{n} = …`")).join(", ")
                        )));
                    }
                },
            }
        }
        Ok((positional, named))
    }

    fn vector(&self, expr: &Expr) -> Result<Vector, Fault> {
        let value = self.scope.rational_value(expr)?;
        value.vector().ok_or_else(|| {
            let message = format!("`{}` needs a vector here, but this is {}", self.name, value.kind());
            Fault::new(expr.span(), message)
        })
    }
}

fn arguments(n: usize) -> String {
    if n == 1 { "one argument".to_owned() } else { format!("{n} arguments") }
}

fn function(scope: &Scope, name: &str, call: &Call<'_>) -> Result<Value, Fault> {
    match name {
        "diff" => derivative(scope, call),
        "dot" => {
            let [a, b] = call.positional()?;
            Ok(Value::Scalar(call.vector(a)?.dot(&call.vector(b)?)))
        }
        "cross" => {
            let [a, b] = call.positional()?;
            Ok(Value::Vector(call.vector(a)?.cross(&call.vector(b)?)))
        }
        "norm2" => {
            let [a] = call.positional()?;
            let value = scope.evaluate(a)?;
            match value.complex() {
                Some(complex) => Ok(Value::Scalar(complex.norm2())),
                None => Ok(Value::Scalar(call.vector(a)?.norm2())),
            }
        }
        "conj" | "re" | "im" => {
            let [a] = call.positional()?;
            let value = scope.evaluate(a)?;
            let complex = value.complex().ok_or_else(|| {
                Fault::new(a.span(), format!("`{name}` needs a complex number, but this is {}", value.kind()))
            })?;
            Ok(match name {
                "conj" => Value::Complex(complex.conj()),
                "re" => Value::Scalar(complex.re),
                _ => Value::Scalar(complex.im),
            })
        }
        "sqrt" => square_root(scope, call),
        "abs" => {
            let [a] = call.positional()?;
            let number = scope.number(a, "the argument of `abs`")?;
            let negative = number.sign().is_lt();
            Ok(Value::Scalar(if negative { (-number).into() } else { number.into() }))
        }
        "exp" | "cos" | "sin" => angle(scope, call),
        "degree" => degree(scope, call),
        "homogeneous" => {
            let [a] = call.positional()?;
            let homogeneous = homogeneous(scope, call, a)?;
            Ok(Value::Tuple(homogeneous.coordinates().iter().map(|poly| poly.clone().into()).collect()))
        }
        "normal" => {
            let [a] = call.positional()?;
            match scope.evaluate(a)?.bare() {
                Value::Surface(surface) => {
                    let normal = surface.normal().map_err(|error| Fault::offset(a.span(), &error))?;
                    let [x, y, z] = normal.numerator().each_ref().map(|poly| Fraction::from(poly.clone()));
                    Ok(Value::Vector(Vector::new(x, y, z)))
                }
                other => {
                    let fault = Fault::new(
                        a.span(),
                        format!("`normal` needs the surface, but this is {}", other.kind()),
                    );
                    Err(fault.help("the normal of a curve is `s.normal`"))
                }
            }
        }
        "offset" => {
            let [surface, distance] = call.positional()?;
            let distance = scope.scalar(distance, "the distance of an offset")?;
            match scope.evaluate(surface)?.bare() {
                Value::Surface(surface) => Ok(Value::Offset(Rc::new(surface.offset(&distance)))),
                Value::Curve(curve) => curve
                    .offset(&distance)
                    .map(Value::Vector)
                    .map_err(|error| Fault::curve(call.span, &error)),
                other => {
                    let message =
                        format!("`offset` needs a surface or a curve, but this is {}", other.kind());
                    Err(Fault::new(surface.span(), message))
                }
            }
        }
        "gcd" => {
            let polys = call
                .several()?
                .into_iter()
                .map(|expr| polynomial(scope, expr))
                .collect::<Result<Vec<_>, _>>()?;
            Ok(Value::Scalar(Poly::gcd_many(&polys).into()))
        }
        "approx" | "coprime" | "is_rational" | "parallel" | "positive" => {
            let fault = Fault::new(call.span, format!("`{name}` is a relation and has no value"));
            Err(fault.help("relations stand in `claim` clauses"))
        }
        _ => curves::constructor(scope, call),
    }
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
        _ => {
            let derived = Value::Vector(call.vector(value)?.map(scalar));
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
    let root = rational_root(&value.reduced()).map_err(|_| {
        let split = value.reduced().numerator().square_split();
        let message = format!("this square root is not a rational function: {} is not a square", split.odd);
        let mut fault =
            Fault::new(a.span(), message).help("roots of functions must be exact: only squares have them");
        fault.irrational = true;
        fault
    })?;
    nonnegative(scope, &root.lowest_terms(), a.span()).map(Value::Scalar)
}

/// The one of `root` and `-root` that is not negative on the domain.
fn nonnegative(scope: &Scope, root: &Fraction, span: Span) -> Result<Fraction, Fault> {
    let unknown = |why: String, help: &str| {
        let root = super::expression::shortened(&root.to_string());
        Err(Fault::new(span, format!("this square root is the absolute value of {root}, and {why}"))
            .help(help))
    };
    let mut domain = Vec::new();
    for variable in root.occurring_variables() {
        let Some(interval) = scope.domains.get(&variable) else {
            let help =
                "write the root itself, with the sign that is meant, or state the domain of the parameter";
            return unknown(format!("nothing is known of the sign of `{variable}`"), help);
        };
        domain.push((variable, interval.clone()));
    }
    // A factor and its reciprocal have the same sign.
    let signed = root.factors().iter().filter(|(_, exponent)| exponent % 2 == 1);
    let signed = signed.fold(root.numerator().clone(), |product, (factor, _)| product * factor);
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

fn homogeneous(scope: &Scope, call: &Call<'_>, expr: &Expr) -> Result<Homogeneous, Fault> {
    let value = scope.evaluate(expr)?;
    match value.bare() {
        Value::Surface(surface) => return Ok(surface.homogeneous().clone()),
        Value::Offset(offset) => {
            return offset
                .as_ref()
                .as_ref()
                .map(|surface| surface.homogeneous().clone())
                .map_err(|error| Fault::offset(expr.span(), error));
        }
        _ => {}
    }
    Ok(Homogeneous::of(&call.vector(expr)?, &surface_parameters(scope)))
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
    let mut polys = Vec::new();
    for expr in exprs {
        match scope.evaluate(expr)?.scalar() {
            Some(_) => polys.push(polynomial(scope, expr)?),
            None => polys.extend(homogeneous(scope, call, expr)?.coordinates().iter().cloned()),
        }
    }
    let mut variables: Vec<Variable> = polys.iter().flat_map(Poly::occurring_variables).collect();
    variables.sort();
    variables.dedup();
    if let Some(function) = variables.iter().find(|variable| scope.calculus.is_function(variable)) {
        let message = format!("the unknown function `{function}` has no degree");
        return Err(
            Fault::new(call.span, message).help("write a polynomial with symbols for its coefficients")
        );
    }
    let value = |degrees| Ok(Value::Degree(Rc::new(DegreeValue { degrees, variables })));
    if let Some(by) = by {
        let by = parameter(scope, by)?;
        let degree = polys.iter().map(|poly| poly.degree(&by).map_or(-1, i64::from)).max().unwrap_or(-1);
        return value(vec![degree]);
    }
    if scope.parameters.len() != 2 {
        let known: Vec<&str> = scope.parameters.iter().map(Variable::name).collect();
        let fault = Fault::new(call.span, "a bidegree needs two parameters");
        return Err(fault.help(format!(
            "here are {}; write `degree(f, parameter = v)` for one",
            if known.is_empty() { "none".to_owned() } else { known.join(", ") }
        )));
    }
    let Bidegree { u, v } = Bidegree::of_group(&polys, &surface_parameters(scope));
    value(vec![u, v])
}
