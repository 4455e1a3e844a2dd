//! Items to models: the surface and the claims that a sweep or a lemma stands for.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::rc::Rc;

use hodograph_algebra::{Curve, Fraction, Interval, Poly, SweptSurface, Variable, Vector, budget};

use super::curves::{self, CurveContext};
use super::expression;
use super::fault::Fault;
use super::group::CoefficientGroup;
use super::pieces::Piece;
use super::scope::Scope;
use super::value::{FunctionValue, Value};
use crate::language::ast::{
    Claim, Clause, ClauseKind, CurveRole, Definition, Expr, ExprKind, File, Item, ItemKind, Name, Preference,
};
use crate::language::{Diagnostic, Diagnostics, Span};

/// What a sweep or a lemma means: its surface, and its claims ready to be checked.
///
/// # Example
/// ```
/// use hodograph_codegen::{language::parse_text, meaning::models};
///
/// let text = "/// A tube.
/// sweep tube {
///     source \"FN (17)\";
///     path s(v) = ph([1, 1 + I]);
///     surface R = s + u*k;
///     domain u in 0..1, v in 0..1;
/// }";
/// let (file, _source) = parse_text("tube.sweep", text).unwrap();
/// let (models, _mistakes) = models(&file);
/// let model = &models[0];
/// assert_eq!((model.name.as_str(), model.source.as_deref()), ("tube", Some("FN (17)")));
/// assert_eq!(model.docs, ["A tube."]);
/// assert_eq!(model.formula[1], "surface R = s + u*k;");
/// assert_eq!(model.surface.as_ref().unwrap().homogeneous().to_string(), "(3, -v^3 + 3*v, 3*v^2, 3*u)");
/// let [(name, curve)] = model.curves()[..] else { panic!() };
/// assert_eq!(format!("{name}: {}", curve.speed().unwrap()), "s: v^2 + 1");
/// ```
#[derive(Clone, Debug)]
pub struct Model {
    /// Sweep or lemma.
    pub kind: ItemKind,
    /// The name.
    pub name: String,
    /// Where the formula of the surface stands; for a lemma, its name.
    pub place: Span,
    /// The documentation, line by line.
    pub docs: Vec<String>,
    /// Where the formula is taken from, as `source` says.
    pub source: Option<String>,
    /// The clauses that define the surface, as the language writes them, one a line.
    pub formula: Vec<String>,
    /// What evaluators should be above all.
    pub preference: Preference,
    /// The surface of a sweep.
    pub surface: Option<Rc<SweptSurface>>,
    /// Which piece of an item in several pieces it is. Each piece is a model with a surface over the piece's own interval, called
    /// by the name of the item, `_` and its number from 1; the pieces of an item follow one another.
    pub piece: Option<Piece>,
    /// The claims, in the order of the source. Of several pieces the first one has the claims, which are about all of them.
    pub claims: Vec<Claim>,
    /// The units of work that a derivation or a program of the surface may take; see [`models_within`].
    pub limit: u64,
    pub(super) path: Option<String>,
    pub(super) scope: Scope,
}

/// The models of all items of a file, and the mistakes in them, within [`budget::DEFAULT_LIMIT`].
///
/// # Example
/// ```
/// use hodograph_codegen::{language::parse_text, meaning::models};
///
/// let text = "lemma right { let a = 1/2; } lemma wrong { let a = (1, 2)*k; }";
/// let (file, _source) = parse_text("two.sweep", text).unwrap();
/// let (models, mistakes) = models(&file);
/// assert_eq!(models.iter().map(|model| model.name.as_str()).collect::<Vec<_>>(), ["right"]);
/// let messages: Vec<&str> = mistakes.iter().map(|mistake| mistake.message.as_str()).collect();
/// assert_eq!(messages, ["a vector and a vector cannot be multiplied with `*`"]);
/// ```
#[must_use]
pub fn models(file: &File) -> (Vec<Model>, Diagnostics) {
    models_within(file, budget::DEFAULT_LIMIT)
}

/// The models of all items of a file, and the mistakes in them. The clauses of the whole file, but for the claims, may
/// take `limit` units of work together, and so may what is derived from each model: see [`Model::limit`].
///
/// # Example
/// ```
/// use hodograph_codegen::{language::{Report, parse_text}, meaning::models_within};
///
/// let text = "lemma power { domain u in 0..1; symbol a; let small = (u + a)^2; let f = 1 + (u + a)^60; }";
/// let (file, source) = parse_text("power", text).unwrap();
/// assert!(models_within(&file, 100_000).1.is_empty());
/// let report = Report::new(source, models_within(&file, 1000).1);
/// assert!(report.lines()[0].starts_with("power:1:78: this needs more than the budget of 1000 units of work"));
/// ```
#[must_use]
pub fn models_within(file: &File, limit: u64) -> (Vec<Model>, Diagnostics) {
    let mut diagnostics = Diagnostics::new();
    let mut models = Vec::new();
    let mut left = limit;
    let inputs = Rc::new(file.inputs.clone());
    for item in &file.items {
        let before = diagnostics.count();
        let inputs = &inputs;
        let (pieces, spent) = budget::measured(|| pieces(item, inputs, limit, left, &mut diagnostics));
        debug_assert!(!pieces.is_empty() || diagnostics.count() > before);
        models.extend(pieces);
        left = left.saturating_sub(spent);
        if left == 0 {
            break;
        }
    }
    check_piece_names(file, &models, &mut diagnostics);
    (models, diagnostics)
}

/// Reports a piece that would have the name of another item.
fn check_piece_names(file: &File, models: &[Model], diagnostics: &mut Diagnostics) {
    for model in models.iter().filter(|model| model.piece.is_some()) {
        if let Some(item) = file.items.iter().find(|item| item.name.value == model.name) {
            let message = format!("`{}` is also the name of a piece of `{}`", model.name, model.item_name());
            diagnostics.push(Diagnostic::new(item.name.span, message).help("use another name"));
        }
    }
}

/// The texts of other files.
type Inputs = Rc<BTreeMap<String, Result<String, String>>>;

/// The models of an item, of which `left` units are left for its clauses: one, or one for each piece of a sweep in several
/// pieces.
fn pieces(item: &Item, inputs: &Inputs, limit: u64, left: u64, diagnostics: &mut Diagnostics) -> Vec<Model> {
    let shared = Rc::new(item.clone());
    let mut scope = Scope::new(parameters(item), limit);
    scope.left = left;
    scope.item = Some(shared.clone());
    scope.inputs = inputs.clone();
    let Some(first) = model(item, scope.clone(), diagnostics) else { return Vec::new() };
    let Some(joints) = first.scope.joints.clone().filter(|joints| joints.count() > 1) else {
        return vec![first];
    };
    let count = joints.count();
    let mut models = vec![first];
    for index in 1..count {
        scope.segment = index;
        scope.left = models.last().map_or(0, |model| model.scope.left);
        let Some(next) = model(item, scope.clone(), diagnostics) else { return Vec::new() };
        models.push(next);
    }
    models[0].scope.siblings = models.iter().map(|model| model.scope.clone()).collect();
    if item.kind == ItemKind::Lemma {
        models.truncate(1);
        return models;
    }
    for (index, model) in models.iter_mut().enumerate() {
        let of = std::mem::replace(&mut model.name, format!("{}_{}", item.name.value, index + 1));
        model.piece = Some(Piece { of, index, count });
        if index > 0 {
            model.claims.clear();
        }
    }
    models
}

/// The model of an item, or of one piece of it, in a scope that knows no names yet.
fn model(item: &Item, mut scope: Scope, diagnostics: &mut Diagnostics) -> Option<Model> {
    let before = diagnostics.count();
    let limit = scope.limit;
    scope.has_surface = surface_place(item).is_some();
    for name in parameter_names(item) {
        if let Some(taken) = scope.reserved(&name.value) {
            let message = format!("`{}` {taken}, so it cannot be a parameter", name.value);
            diagnostics.push(Diagnostic::new(name.span, message).help("use another name"));
        }
    }
    let prefixes = symbolic_curves(item) > 1;
    for fault in run(item, &mut scope, prefixes) {
        fault.into_diagnostics().into_iter().for_each(|one| diagnostics.push(one));
    }
    let surface = scope.surface.clone();
    let source = item.clauses.iter().find_map(|clause| match &clause.kind {
        ClauseKind::Source(text) => Some(text.value.clone()),
        _ => None,
    });
    let preference = item.clauses.iter().find_map(|clause| match &clause.kind {
        ClauseKind::Prefer(preference) => Some(preference.value),
        _ => None,
    });
    let claims: Vec<Claim> = item
        .clauses
        .iter()
        .filter_map(
            |clause| if let ClauseKind::Claim(claim) = &clause.kind { Some(claim.clone()) } else { None },
        )
        .collect();
    // Without budget, definitions are missing that are no mistake.
    for claim in claims.iter().filter(|_| scope.left > 0) {
        for expr in std::iter::once(&claim.relation).chain(&claim.conditions) {
            check_names(&scope, expr, diagnostics);
        }
    }
    if diagnostics.count() > before {
        return None;
    }
    Some(Model {
        kind: item.kind,
        name: item.name.value.clone(),
        place: surface_place(item).unwrap_or(item.name.span),
        docs: item.docs.iter().map(|line| line.value.trim().to_owned()).collect(),
        source,
        limit,
        formula: formula(item, surface.as_deref()),
        preference: preference.unwrap_or_default(),
        surface,
        piece: None,
        claims,
        path: item.clauses.iter().find_map(|clause| match &clause.kind {
            ClauseKind::Curve(curve) if curve.role == CurveRole::Path => Some(curve.name.value.clone()),
            _ => None,
        }),
        scope,
    })
}

/// Evaluates the clauses of an item in their order, domains first, since arc lengths begin where they do.
fn run(item: &Item, scope: &mut Scope, prefixes: bool) -> Vec<Fault> {
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

/// The clauses that define the surface, one a line; symbols that only claims use are left out.
fn formula(item: &Item, surface: Option<&SweptSurface>) -> Vec<String> {
    let used = surface.map(SweptSurface::symbols).unwrap_or_default();
    let defines = |clause: &&Clause| match &clause.kind {
        ClauseKind::Source(_) | ClauseKind::Claim(_) => false,
        ClauseKind::Symbol(names) if surface.is_some() => {
            names.iter().any(|name| used.iter().any(|symbol| symbol.name() == name.value))
        }
        _ => true,
    };
    item.clauses.iter().filter(defines).map(ToString::to_string).collect()
}

/// The place of the surface's formula.
fn surface_place(item: &Item) -> Option<Span> {
    item.clauses.iter().find_map(|clause| match &clause.kind {
        ClauseKind::Surface(surface) => Some(surface.value.span()),
        _ => None,
    })
}

/// The parameters of an item: those of its surface, or of its curves and functions.
fn parameters(item: &Item) -> Vec<Variable> {
    let mut names: Vec<&str> = Vec::new();
    for clause in &item.clauses {
        match &clause.kind {
            ClauseKind::Surface(surface) => names.extend(surface.parameter_names()),
            ClauseKind::Domain(intervals) => {
                names.extend(intervals.iter().map(|i| i.parameter.value.as_str()))
            }
            ClauseKind::Curve(curve) => names.push(&curve.parameter.value),
            ClauseKind::Function(functions) => {
                names.extend(functions.iter().map(|f| f.parameter.value.as_str()))
            }
            ClauseKind::Let(definition) => {
                names.extend(definition.parameters.iter().map(|p| p.value.as_str()))
            }
            _ => {}
        }
    }
    let surface = item.clauses.iter().find_map(|clause| match &clause.kind {
        ClauseKind::Surface(surface) => Some(surface.parameter_names()),
        _ => None,
    });
    names.sort_unstable();
    names.dedup();
    if let Some(own) = surface {
        names.retain(|name| !own.contains(name));
        names.splice(0..0, own);
    }
    (0_u32..).zip(names).map(|(rank, name)| Variable::new(rank.min(Variable::SYMBOL - 1), name)).collect()
}

/// Each parameter where it is first named.
fn parameter_names(item: &Item) -> Vec<&Name> {
    let mut names: Vec<&Name> = Vec::new();
    for clause in &item.clauses {
        match &clause.kind {
            ClauseKind::Surface(surface) => names.extend(surface.parameters.iter().flatten()),
            ClauseKind::Domain(intervals) => {
                names.extend(intervals.iter().map(|interval| &interval.parameter))
            }
            ClauseKind::Curve(curve) => names.push(&curve.parameter),
            ClauseKind::Function(functions) => {
                names.extend(functions.iter().map(|function| &function.parameter))
            }
            ClauseKind::Let(definition) => names.extend(&definition.parameters),
            _ => {}
        }
    }
    let mut seen = std::collections::BTreeSet::new();
    names.retain(|name| seen.insert(name.value.as_str()));
    names
}

/// The number of curves with symbolic coefficients.
fn symbolic_curves(item: &Item) -> usize {
    let symbolic = |clause: &&Clause| match &clause.kind {
        ClauseKind::Curve(curve) => match curve.value.kind() {
            ExprKind::Call { callee, arguments } => match callee.kind() {
                ExprKind::Ident(name) => match name.as_str() {
                    "polynomial_curve" | "rational_curve" => true,
                    "ph" | "ph_spatial" => {
                        !arguments.iter().any(|argument| matches!(argument.value.kind(), ExprKind::Array(_)))
                    }
                    _ => false,
                },
                _ => false,
            },
            _ => false,
        },
        _ => false,
    };
    item.clauses.iter().filter(symbolic).count()
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

/// Whether the item has a domain for the parameter, be it a wrong one.
fn states_domain(item: &Item, parameter: &Variable) -> bool {
    item.clauses.iter().any(|clause| match &clause.kind {
        ClauseKind::Domain(intervals) => intervals.iter().any(|i| i.parameter.value == parameter.name()),
        _ => false,
    })
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

/// Reports unknown names in a claim, which is evaluated only when it is checked.
pub(super) fn check_names(scope: &Scope, expr: &Expr, diagnostics: &mut Diagnostics) {
    match expr.kind() {
        ExprKind::Ident(name) => {
            if !scope.knows(name) {
                diagnostics.push(*scope.unknown(name, expr.span()).diagnostic);
            }
        }
        _ => expr.children().for_each(|child| check_names(scope, child, diagnostics)),
    }
}

impl Model {
    /// The same item where symbols have these values; every clause is evaluated anew.
    ///
    /// # Errors
    /// The first mistake that the values make, such as a curve that becomes a point.
    pub fn with_values(&self, values: &BTreeMap<Variable, Poly>) -> Result<Model, Box<Diagnostic>> {
        let settings = values.iter().map(|(symbol, value)| (symbol.clone(), value.clone().into())).collect();
        let scope = match &self.scope.item {
            Some(item) => with_settings(&self.scope, item, settings).map_err(|fault| fault.diagnostic)?,
            None => self.scope.clone(),
        };
        Ok(Model { surface: scope.surface.clone(), scope, ..self.clone() })
    }

    /// The name of the item in the source; that of a [piece](Model::piece) has its number behind it.
    #[must_use]
    pub fn item_name(&self) -> &str {
        self.piece.as_ref().map_or(&self.name, |piece| &piece.of)
    }

    /// The symbols that are coefficients of curves, in the order of the clauses.
    #[must_use]
    pub fn coefficient_groups(&self) -> &[CoefficientGroup] {
        &self.scope.groups
    }

    /// The curves of the item by their names; the path comes first, then by name.
    #[must_use]
    pub fn curves(&self) -> Vec<(&str, &Curve)> {
        let mut curves = self.scope.curves();
        curves.sort_by_key(|(name, _)| (Some(*name) != self.path.as_deref(), *name));
        curves
    }
}
