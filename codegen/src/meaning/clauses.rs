//! Clauses in their order: domains, definitions, curves and the surface, each evaluated under what is left of the budget.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

use hodograph_algebra::{Fraction, Interval, SweptSurface, Variable, Vector, budget};

use super::curves::{self, CurveContext};
use super::expression;
use super::fault::Fault;
use super::outline::{parameters, states_domain, symbolic_curves};
use super::scope::Scope;
use super::value::{FunctionValue, Value};
use crate::language::Span;
use crate::language::ast::{Clause, ClauseKind, CurveRole, Definition, Expr, Item, Name};

/// Evaluates the clauses of an item in their order, domains first, since arc lengths begin where they do.
pub(super) fn run(item: &Item, scope: &mut Scope, prefixes: bool) -> Vec<Fault> {
    let mut faults = Vec::new();
    let intervals = item.clauses.iter().filter_map(|clause| match &clause.kind {
        ClauseKind::Domain(intervals) => Some(intervals),
        _ => None,
    });
    for interval in intervals.flatten() {
        let result = guarded(scope, interval.start.span().to(interval.end.span()), |scope| {
            domain(scope, &interval.parameter, &interval.start, &interval.end)
        });
        match result {
            Ok((parameter, interval)) => _ = scope.domains.insert(parameter, interval),
            // Domains come first, so no definition is known yet.
            Err(fault) if fault.diagnostic.message.ends_with("is not defined") => {
                faults.push(fault.help("the ends of a domain are numbers that are written out, `0..1`"));
            }
            Err(fault) => faults.push(fault),
        }
    }
    for clause in &item.clauses {
        let result = match &clause.kind {
            ClauseKind::Source(_) | ClauseKind::Claim(_) | ClauseKind::Domain(_) | ClauseKind::Prefer(_) => {
                Ok(())
            }
            ClauseKind::Surface(definition) => surface_of(scope, item, &definition.value, "the surface")
                .and_then(|value| {
                    let value = Rc::new(value);
                    scope.define(&definition.name, Value::Surface(value.clone()))?;
                    scope.surface = Some(value);
                    Ok(())
                }),
            _ => define(scope, clause, prefixes),
        };
        if let Err(fault) = result {
            faults.push(fault);
            // Later clauses would only repeat that a name is missing.
            poison(scope, clause);
        }
        if scope.left == 0 {
            // Nor has any of them anything left to be computed with.
            item.clauses.iter().for_each(|clause| poison(scope, clause));
            break;
        }
    }
    faults
}

/// The scope of an item where symbols have the given values: all of its clauses are evaluated anew, since a parametric
/// speed, a gcd or a degree does not follow from its general form.
pub(super) fn with_settings(
    known: &Scope,
    item: &Rc<Item>,
    settings: BTreeMap<Variable, Fraction>,
) -> Result<Scope, Fault> {
    let continuities: Rc<RefCell<Vec<(Span, i64)>>> = Rc::default();
    let piece = |segment: usize| {
        let mut scope = Scope::new(parameters(item), known.limit);
        scope.item = Some(item.clone());
        scope.settings = settings.clone();
        scope.inputs = known.inputs.clone();
        scope.segment = segment;
        scope.continuities = continuities.clone();
        match run(item, &mut scope, symbolic_curves(item) > 1).into_iter().next() {
            None => Ok(scope),
            Some(fault) => Err(fault),
        }
    };
    let mut scope = piece(known.segment)?;
    scope.siblings = (0..known.siblings.len()).map(piece).collect::<Result<_, _>>()?;
    Ok(scope)
}

/// Runs a part of the evaluation under what is left of the budget. If that does not suffice, the place is that of the
/// innermost expression whose value was being computed, or `span`, that of the whole.
fn guarded<T>(
    scope: &mut Scope,
    span: Span,
    work: impl FnOnce(&Scope) -> Result<T, Fault>,
) -> Result<T, Fault> {
    let left = scope.left;
    let shared = &*scope;
    let (outcome, spent) = budget::measured(|| budget::with_budget(left, || work(shared)));
    let place = expression::place_of_exhaustion();
    match outcome {
        Ok(result) => {
            scope.left = left.saturating_sub(spent);
            result
        }
        Err(mut exhausted) => {
            // What is beyond a range, rather than the budget, leaves the rest of it.
            scope.left = if exhausted.reason.is_some() { left.saturating_sub(spent) } else { 0 };
            if left < scope.limit {
                let task = "the clauses before this one".into();
                let units = scope.limit - left;
                exhausted.limit = scope.limit;
                exhausted.done.insert(0, budget::Finished { task, times: 1, units });
            }
            Err(Fault::exhausted(place.unwrap_or(span), &exhausted))
        }
    }
}

fn domain(scope: &Scope, parameter: &Name, start: &Expr, end: &Expr) -> Result<(Variable, Interval), Fault> {
    let found = scope.parameters.iter().find(|known| known.name() == parameter.value);
    let variable = found.cloned().ok_or_else(|| {
        Fault::new(parameter.span, format!("`{}` is not a parameter of this item", parameter.value))
    })?;
    let lower = scope.number(start, "the beginning of a domain")?;
    let upper = scope.number(end, "the end of a domain")?;
    match Interval::new(lower, upper) {
        Some(interval) => Ok((variable, interval)),
        None => Err(Fault::new(start.span().to(end.span()), "this domain does not end after its beginning")
            .help("write the smaller number first: `0..1`")),
    }
}

fn surface_of(scope: &mut Scope, item: &Item, expr: &Expr, role: &str) -> Result<SweptSurface, Fault> {
    guarded(scope, expr.span(), |scope| {
        let value = scope.evaluate(expr)?;
        let position = value.vector().ok_or_else(|| {
            let fault = Fault::new(
                expr.span(),
                format!("{role} must be a vector in space, but this is {}", value.kind()),
            );
            fault.help("a scalar becomes a vector by a unit vector: `z*k`")
        })?;
        check_finite(&value, expr.span())?;
        let parameters = super::functions::surface_parameters(scope);
        let domain = |parameter: &Variable| {
            scope.domains.get(parameter).cloned().ok_or_else(|| {
                if states_domain(item, parameter) {
                    return Fault::silent(item.name.span);
                }
                Fault::new(item.name.span, format!("the domain of `{parameter}` is not stated"))
                    .help(format!("add `domain {parameter} in 0..1;`"))
            })
        };
        if let Some(joints) = scope.joints.as_ref().filter(|joints| joints.parameter != parameters[1]) {
            let message =
                format!("the frames run along `{}`, which must be the second parameter", joints.parameter);
            let help = format!("write `surface R(u, {}) = …`", joints.parameter);
            return Err(Fault::new(item.name.span, message).help(help));
        }
        let domain = [domain(&parameters[0])?, domain(&parameters[1])?];
        check_surface_variables(scope, &position, &parameters, expr.span())?;
        let surface = SweptSurface::new(position, parameters, domain);
        if surface.symbols().is_empty() {
            return Ok(surface);
        }
        let curves = scope.curves();
        let normals: Vec<Vector> = curves.iter().filter_map(|(_, curve)| curve.normal().ok()).collect();
        let vectors = curves.iter().map(|(_, curve)| curve.hodograph()).chain(&normals);
        Ok(surface.with_directions(vectors))
    })
}

/// Reports what a surface cannot contain: unknown functions, and parameters that are not its own.
fn check_surface_variables(
    scope: &Scope,
    position: &Vector,
    parameters: &[Variable; 2],
    span: Span,
) -> Result<(), Fault> {
    let other = position.components().iter().flat_map(Fraction::occurring_variables).find(|variable| {
        scope.calculus.is_function(variable)
            || (scope.parameters.contains(variable) && !parameters.contains(variable))
    });
    let Some(other) = other else { return Ok(()) };
    let message = if scope.calculus.is_function(&other) {
        format!("the surface contains the unknown function `{other}`")
    } else {
        format!("the surface contains the parameter `{other}`, which is not one of its own")
    };
    Err(Fault::new(span, message).help("a lemma can state identities for unknown functions"))
}

/// Reports π outside of angles: it is not algebraic.
fn check_finite(value: &Value, span: Span) -> Result<(), Fault> {
    let pi = Variable::new(Variable::SYMBOL, "pi");
    let parts = value.complex().map(|z| vec![z.re, z.im]).or_else(|| value.components()).unwrap_or_default();
    if parts.iter().any(|part| part.occurring_variables().contains(&pi)) {
        return Err(Fault::pi(span));
    }
    Ok(())
}

fn define(scope: &mut Scope, clause: &Clause, prefixes: bool) -> Result<(), Fault> {
    match &clause.kind {
        ClauseKind::Symbol(names) => {
            for name in names {
                scope.define_symbol(name)?;
            }
        }
        ClauseKind::Function(functions) => {
            for function in functions {
                scope.check_new(&function.name)?;
                let parameter = parameter(scope, &function.parameter)?;
                let mut calculus = hodograph_algebra::Calculus::clone(&scope.calculus);
                scope.check_derivatives(&function.name, &parameter)?;
                let symbol = calculus.function(&function.name.value, &parameter);
                let value =
                    FunctionValue { parameters: vec![parameter], value: Value::Scalar(symbol.into()) };
                scope.define(&function.name, Value::Function(Rc::new(value)))?;
                scope.calculus = Rc::new(calculus);
            }
        }
        ClauseKind::Let(definition) => let_value(scope, definition)?,
        ClauseKind::Curve(curve) => {
            scope.check_new(&curve.name)?;
            let parameter = parameter(scope, &curve.parameter)?;
            let name = curve.name.value.clone();
            let prefix = if prefixes { format!("{name}_") } else { String::new() };
            scope.curve = Some(CurveContext { name, parameter: parameter.clone(), prefix });
            let value = guarded(scope, curve.value.span(), |scope| {
                let value = scope.evaluate(&curve.value)?;
                check_finite(&value, curve.value.span())?;
                curve_value(scope, curve.role, &parameter, &value, curve.value.span())
            });
            scope.curve = None;
            scope.define(&curve.name, value?)?;
            scope.settle(curve.name.span)?;
        }
        ClauseKind::Substitute(definition) => substitute_parameter(scope, definition)?,
        ClauseKind::Source(_)
        | ClauseKind::Surface(_)
        | ClauseKind::Domain(_)
        | ClauseKind::Prefer(_)
        | ClauseKind::Claim(_) => {}
    }
    Ok(())
}

/// A curve from what its clause says: a constructor's curve, or a position vector.
fn curve_value(
    scope: &Scope,
    role: CurveRole,
    parameter: &Variable,
    value: &Value,
    span: Span,
) -> Result<Value, Fault> {
    match (role, value.bare()) {
        (CurveRole::Frames, Value::Motion(_)) => return Ok(value.clone()),
        (CurveRole::Frames, other) => {
            let fault = Fault::new(span, format!("a motion is expected here, but this is {}", other.kind()));
            return Err(
                fault.help("write `frames F(v) = frames([…]);` or `frames F(v) = frames_file(\"…\");`")
            );
        }
        (_, Value::Motion(_)) => {
            let fault = Fault::new(span, "a motion is no curve");
            return Err(
                fault.help("its clause is `frames F(v) = …;`, and the curve of its positions `F.position`")
            );
        }
        _ => {}
    }
    if let Value::Curve(curve) = value.bare()
        && curve.parameter() == parameter
    {
        let components = curve.position().components().iter().chain(curve.hodograph().components());
        check_own_parameter(scope, parameter, components, span)?;
        return Ok(Value::Curve(curve.clone()));
    }
    let position: Vector = value.vector().ok_or_else(|| {
        let what = match role {
            CurveRole::Profile => "a profile",
            CurveRole::Path => "a path",
            CurveRole::Curve | CurveRole::Frames => "a curve",
        };
        let fault = Fault::new(span, format!("{what} must be a vector, but this is {}", value.kind()));
        fault.help("write `x*i + z*k`, `(x, y)` or `(x, y, z)`")
    })?;
    check_own_parameter(scope, parameter, position.components(), span)?;
    Ok(Value::Curve(curves::curve(scope, parameter, position, Default::default())))
}

/// Reports a parameter other than the curve's own, or an unknown function of one.
fn check_own_parameter<'a>(
    scope: &Scope,
    parameter: &Variable,
    components: impl IntoIterator<Item = &'a Fraction>,
    span: Span,
) -> Result<(), Fault> {
    let occurring = components.into_iter().flat_map(Fraction::occurring_variables);
    let foreign = |variable: &Variable| {
        let depends = scope.calculus.parameter_of(variable).unwrap_or(variable);
        depends != parameter && scope.parameters.contains(depends)
    };
    let Some(variable) = occurring.into_iter().find(foreign) else { return Ok(()) };
    let kind = if scope.parameters.contains(&variable) { "parameter" } else { "function" };
    let message = format!("this curve of `{parameter}` contains the {kind} `{variable}`");
    Err(Fault::new(span, message).help(format!("a curve depends on `{parameter}` alone")))
}

fn parameter(scope: &Scope, name: &Name) -> Result<Variable, Fault> {
    let found = scope.parameters.iter().find(|parameter| parameter.name() == name.value);
    found.cloned().ok_or_else(|| Fault::new(name.span, format!("`{}` is not a parameter", name.value)))
}

fn let_value(scope: &mut Scope, definition: &Definition) -> Result<(), Fault> {
    scope.check_new(&definition.name)?;
    let parameters =
        definition.parameters.iter().map(|name| parameter(scope, name)).collect::<Result<Vec<_>, _>>()?;
    let value = guarded(scope, definition.value.span(), |scope| {
        let value = scope.evaluate(&definition.value)?;
        let angle = parameters.is_empty();
        // An angle may have a name of its own, as long as it stays one.
        if !angle {
            check_finite(&value, definition.value.span())?;
        }
        Ok(value)
    })?;
    let value = if parameters.is_empty() {
        value
    } else {
        Value::Function(Rc::new(FunctionValue { parameters, value }))
    };
    scope.define(&definition.name, value)?;
    Ok(())
}

/// `substitute v = expr;`: the surface in another parameter, over the interval that is stated for the new one.
fn substitute_parameter(scope: &mut Scope, definition: &Definition) -> Result<(), Fault> {
    let name = &definition.name;
    let Some(surface) = scope.surface.clone() else {
        return Err(Fault::new(name.span, "there is no surface yet").help("put `substitute` after `surface`"));
    };
    if let Some(parameter) = definition.parameters.first() {
        return Err(Fault::new(parameter.span, "a substitution has no parameters of its own"));
    }
    let replaced = parameter(scope, name)?;
    let substituted = guarded(scope, definition.value.span(), |scope| {
        let value = scope.scalar(&definition.value, "what is substituted")?;
        let values = [(replaced, value)].into();
        let position = Value::Vector(surface.position().clone());
        let position = super::calls::substitute(scope, definition.value.span(), &position, &values)?;
        let position = position.vector().unwrap_or_else(Vector::zero).reduced();
        check_surface_variables(scope, &position, surface.parameters(), definition.value.span())?;
        Ok(position)
    })?;
    let domain = surface.domain().clone();
    let surface = Rc::new(SweptSurface::new(substituted, surface.parameters().clone(), domain));
    scope.replace_surface(&surface);
    Ok(())
}

/// Gives the names of a clause that failed some value, so that they are not reported as missing.
fn poison(scope: &mut Scope, clause: &Clause) {
    let names: Vec<&Name> = match &clause.kind {
        ClauseKind::Let(definition) => vec![&definition.name],
        ClauseKind::Curve(curve) => vec![&curve.name],
        ClauseKind::Surface(surface) => vec![&surface.name],
        ClauseKind::Symbol(names) => names.iter().collect(),
        ClauseKind::Function(functions) => functions.iter().map(|function| &function.name).collect(),
        _ => return,
    };
    for name in names {
        scope.poison(name);
    }
}
