//! Calls: what is called, its arguments, and values in place of parameters.

use std::collections::BTreeMap;

use hodograph_algebra::{Fraction, Poly, QuadraticFraction, Quaternion, Variable, Vector};

use super::expression::check_rational;
use super::fault::Fault;
use super::functions::function;
use super::pieces;
use super::roots;
use super::scope::Scope;
use super::value::{ComplexFraction, Value};
use crate::language::Span;
use crate::language::ast::{Argument, Expr, ExprKind, Name};

/// The value of `callee(arguments)`.
pub(super) fn call(scope: &Scope, span: Span, callee: &Expr, arguments: &[Argument]) -> Result<Value, Fault> {
    match callee.kind() {
        ExprKind::Ident(name) if super::scope::FUNCTIONS.contains(&name.as_str()) => {
            function(scope, name, &Call { scope, span, name, arguments })
        }
        ExprKind::Member { object, member } => call_member(scope, span, callee, (object, member), arguments),
        _ => {
            let value = scope.evaluate(callee)?;
            apply_value(scope, span, callee, &value, arguments)
        }
    }
}

/// The value of `object.member(arguments)`, where `callee` is `object.member`.
fn call_member(
    scope: &Scope,
    span: Span,
    callee: &Expr,
    (object, member): (&Expr, &Name),
    arguments: &[Argument],
) -> Result<Value, Fault> {
    let owner = scope.evaluate(object)?;
    if let Value::Curve(curve) = owner.bare() {
        if member.value == "offset" {
            let call = Call { scope, span, name: "offset", arguments };
            let [distance] = call.positional()?;
            let distance = scope.scalar(distance, "the distance of an offset")?;
            return curve.offset(&distance).map(Value::Vector).map_err(|error| Fault::curve(span, &error));
        }
        let value = super::members::member(scope, callee.span(), object, member)?;
        return apply(scope, span, callee, &value, &[curve.parameter().clone()], arguments);
    }
    if let Value::Motion(motion) = owner.bare() {
        let name = &member.value;
        if let Some(moved) = super::frames::method(scope, motion, span, name, arguments) {
            return moved;
        }
        let value = super::frames::member(motion, callee.span(), member)?;
        return apply(scope, span, callee, &value, &[motion.parameter().clone()], arguments);
    }
    if let Value::AdaptedFrame(frame) = owner.bare() {
        // The Frenet frame has values at points, be it rational or not.
        let at = match arguments {
            [argument] if argument.name.is_none() => {
                scope.scalar(&argument.value, "the value of the parameter")?.to_number()
            }
            _ => None,
        };
        let value = frame.member(callee.span(), member, at.as_ref())?;
        return apply(scope, span, callee, &value, &[frame.curve.parameter().clone()], arguments);
    }
    let value = scope.evaluate(callee)?;
    apply_value(scope, span, callee, &value, arguments)
}

fn apply_value(
    scope: &Scope,
    span: Span,
    callee: &Expr,
    value: &Value,
    arguments: &[Argument],
) -> Result<Value, Fault> {
    match value {
        Value::Curve(curve) => apply(scope, span, callee, value, &[curve.parameter().clone()], arguments),
        Value::Surface(surface) => apply(scope, span, callee, value, surface.parameters(), arguments),
        Value::Function(function) => {
            apply(scope, span, callee, &function.value, &function.parameters, arguments)
        }
        Value::Offset(offset) => match offset.as_ref() {
            Ok(surface) => apply(scope, span, callee, value, surface.parameters(), arguments),
            Err(error) => Err(Fault::offset(callee.span(), error)),
        },
        other => {
            let fault = Fault::new(callee.span(), format!("{} cannot be called", other.kind()));
            Err(fault.help("name a function of parameters with `let c(v) = …`, then write `c(1/2)`"))
        }
    }
}

/// The value for given values of the parameters; where they belong to another piece, the value of `callee` there.
fn apply(
    scope: &Scope,
    span: Span,
    callee: &Expr,
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
    if let Some(index) = pieces::other_piece(scope, span, &values)?
        && let Some(there) = pieces::in_piece(scope, index, |scope| call(scope, span, callee, arguments))
    {
        return there;
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
    if roots::is_rooted(value) {
        let parts = roots::parts(value, span)?.unwrap_or_default();
        let here = |part: &QuadraticFraction| {
            // Reports unknown functions and poles.
            replace(part.rational_part())?;
            replace(part.root_part())?;
            part.substitute(values)
                .ok_or_else(|| Fault::new(span, "the root of a negative number is not real"))
        };
        return Ok(roots::value_of(parts.iter().map(here).collect::<Result<_, _>>()?));
    }
    Ok(match value.bare() {
        Value::Scalar(scalar) => Value::Scalar(replace(scalar)?),
        Value::Complex(complex) => {
            Value::Complex(ComplexFraction { re: replace(&complex.re)?, im: replace(&complex.im)? })
        }
        Value::Quaternion(value) => {
            let [w, x, y, z] = value.components().each_ref().map(replace);
            Value::Quaternion(Quaternion::new(w?, x?, y?, z?))
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
    pub(super) fn several(&self) -> Result<Vec<&'a Expr>, Fault> {
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

    pub(super) fn vector(&self, expr: &Expr) -> Result<Vector, Fault> {
        self.vector_of(expr, &self.scope.evaluate(expr)?)
    }

    /// The vector that the value of an argument is, which must be one.
    pub(super) fn vector_of(&self, expr: &Expr, value: &Value) -> Result<Vector, Fault> {
        check_rational(expr, value)?;
        if roots::is_rooted(value)
            && let Some(parts) = roots::parts(value, expr.span())?
            && let Some(part) = parts.iter().find(|part| !part.is_rational())
        {
            return Err(roots::irrational(expr.span(), part));
        }
        value.vector().ok_or_else(|| {
            let message = format!("`{}` needs a vector here, but this is {}", self.name, value.kind());
            Fault::new(expr.span(), message)
        })
    }
}

fn arguments(n: usize) -> String {
    if n == 1 { "one argument".to_owned() } else { format!("{n} arguments") }
}
