//! The conditions on symbols under which what holds in general holds: degrees, coprimality, reduced coordinates.

use std::rc::Rc;

use hodograph_algebra::{
    CommonZero, Conditions, Homogeneous, Locus, Poly, SweptSurface, Variable, budget, common_factors,
    falling_degree,
};

use super::expression::shortened;
use super::fault::Fault;
use super::functions::{polynomial, surface_parameters};
use super::scope::{COORDINATES, Scope};
use super::value::Value;
use crate::language::ast::{Argument, Expr, ExprKind, RelationOperator};

/// Units of work for the conditions of one claim.
const LIMIT: u64 = 60_000_000;

/// How many characters a polynomial takes before it is cut.
const LONGEST: usize = 240;

/// How many equations of one case are printed.
const MOST_EQUATIONS: usize = 6;

/// The values of symbols at which a general statement may fail.
#[derive(Default)]
struct Exceptions {
    locus: Locus,
    /// What must hold besides, as relations of the language.
    others: Vec<String>,
}

/// The conditions under which what was found of a relation for general symbols holds, as relations of the language;
/// `general` says that it may differ for special ones, and `nonzero` are polynomials of which the claim itself says that they do not vanish.
pub(super) fn conditions(scope: &Scope, relation: &Expr, general: bool, nonzero: &[Poly]) -> Vec<String> {
    let found = budget::with_budget(LIMIT, || exceptions(scope, relation, general));
    let exceptions = match found {
        Ok(Ok(exceptions)) => exceptions,
        // A mistake in the relation has been reported with its verdict.
        Ok(Err(_)) => return Vec::new(),
        Err(_) => return vec!["general values of the symbols".to_owned()],
    };
    let stated = nonzero
        .iter()
        .fold(Locus::empty(), |all, poly| all.union(&Locus::of(std::slice::from_ref(poly), &[])));
    let mut conditions = Vec::new();
    for alternative in exceptions.locus.without(&stated).alternatives() {
        conditions.push(match alternative.as_slice() {
            [one] => format!("{} != 0", show(one)),
            many if many.len() <= MOST_EQUATIONS => format!("not ({})", equations(many)),
            many => format!("not ({} and … ({} equations))", equations(&many[..2]), many.len()),
        });
    }
    conditions.extend(exceptions.others);
    conditions
}

fn equations(polys: &[Poly]) -> String {
    polys.iter().map(|poly| format!("{} == 0", show(poly))).collect::<Vec<_>>().join(" and ")
}

fn show(poly: &Poly) -> String {
    let text = poly.to_string();
    if text.chars().count() <= LONGEST { text } else { shortened(&text) }
}

fn exceptions(scope: &Scope, relation: &Expr, general: bool) -> Result<Exceptions, Fault> {
    let mut exceptions = Exceptions::default();
    match relation.kind() {
        ExprKind::Not(inner) => return self::exceptions(scope, inner, general),
        ExprKind::Relation { left, operator, right } => {
            if let Some(("degree", arguments)) = called(left) {
                if general {
                    exceptions.of_degree(scope, arguments)?;
                }
            } else if matches!(operator, RelationOperator::Equal | RelationOperator::NotEqual) {
                exceptions.of_reduced(scope, left)?;
                exceptions.of_reduced(scope, right)?;
            }
        }
        _ => {
            if let Some(("coprime", arguments)) = called(relation) {
                exceptions.of_coprime(scope, arguments)?;
            }
        }
    }
    Ok(exceptions)
}

/// The function's name and the arguments of a call.
fn called(expr: &Expr) -> Option<(&str, &[Argument])> {
    match expr.kind() {
        ExprKind::Call { callee, arguments } => match callee.kind() {
            ExprKind::Ident(name) => Some((name, arguments)),
            _ => None,
        },
        _ => None,
    }
}

/// The surface of which an expression is a homogeneous coordinate, or which it is.
fn surface(scope: &Scope, expr: &Expr) -> Option<Rc<SweptSurface>> {
    match expr.kind() {
        ExprKind::Ident(name) if COORDINATES.contains(&name.as_str()) => scope.surface.clone(),
        ExprKind::Member { object, member } if COORDINATES.contains(&member.value.as_str()) => {
            surface(scope, object)
        }
        _ => match scope.evaluate(expr).ok()?.bare() {
            Value::Surface(surface) => Some(surface.clone()),
            Value::Offset(offset) => offset.as_ref().as_ref().ok().map(|surface| Rc::new(surface.clone())),
            _ => None,
        },
    }
}

/// Whether an expression is a name, or a member of what has a name: an offset is computed anew.
fn is_named(expr: &Expr) -> bool {
    match expr.kind() {
        ExprKind::Ident(_) => true,
        ExprKind::Member { object, .. } => is_named(object),
        _ => false,
    }
}

fn is_symbolic(scope: &Scope, poly: &Poly) -> bool {
    poly.occurring_variables().iter().any(|variable| !scope.parameters.contains(variable))
}

impl Exceptions {
    fn add(&mut self, locus: &Locus) {
        self.locus = self.locus.union(locus);
    }

    /// Where the polynomials of `degree(…)` have a lower degree.
    fn of_degree(&mut self, scope: &Scope, arguments: &[Argument]) -> Result<(), Fault> {
        let by = arguments.iter().find(|argument| argument.name.is_some());
        let by = by.map(|by| super::functions::parameter(scope, &by.value)).transpose()?;
        let (mut polys, mut known) = (Vec::new(), Vec::new());
        for argument in arguments.iter().filter(|argument| argument.name.is_none()) {
            let expr = &argument.value;
            let value = scope.evaluate(expr)?;
            if value.scalar().is_some() {
                let poly = polynomial(scope, expr)?;
                if (is_symbolic(scope, &poly) || is_named(expr))
                    && let Some(surface) = surface(scope, expr)
                {
                    self.of_surface(surface.conditions());
                    known.extend_from_slice(&surface.conditions().leading_factors);
                }
                polys.push(poly);
                continue;
            }
            let homogeneous = match surface(scope, expr) {
                Some(surface) => {
                    self.of_surface(surface.conditions());
                    surface.homogeneous().clone()
                }
                None => {
                    let Some(vector) = value.vector() else { continue };
                    let homogeneous = Homogeneous::of(&vector, &surface_parameters(scope));
                    self.of_surface(&Conditions::of(&homogeneous));
                    homogeneous
                }
            };
            polys.extend(homogeneous.coordinates().iter().cloned());
        }
        let parameters = by.map_or_else(|| surface_parameters(scope).to_vec(), |by| vec![by]);
        let group: Vec<&Poly> = polys.iter().collect();
        for parameter in &parameters {
            self.add(&falling_degree(&group, parameter, &scope.parameters, &known));
        }
        Ok(())
    }

    /// Where the coordinates of a surface vanish or get a common factor.
    fn of_surface(&mut self, conditions: &Conditions) {
        self.add(&conditions.weight);
        self.of_common_factor(&conditions.common_factors, &conditions.undetermined);
    }

    fn of_common_factor(&mut self, cases: &[CommonZero], undetermined: &[Poly]) {
        for case in cases {
            match (&case.locus, case.polynomials.as_slice()) {
                (Some(locus), _) => self.add(locus),
                (None, [first, second]) => {
                    let parameter = &case.parameter;
                    self.other(format!("resultant({first}, {second}, parameter = {parameter}) != 0"));
                }
                (None, _) => self.other("general values of the symbols".to_owned()),
            }
        }
        if !undetermined.is_empty() {
            self.other("general values of the symbols".to_owned());
        }
    }

    fn other(&mut self, condition: String) {
        if !self.others.contains(&condition) {
            self.others.push(condition);
        }
    }

    /// Where polynomials that are coprime get a common factor.
    fn of_coprime(&mut self, scope: &Scope, arguments: &[Argument]) -> Result<(), Fault> {
        let polys = arguments.iter().map(|argument| polynomial(scope, &argument.value));
        self.of_coprime_polys(scope, polys.collect::<Result<_, _>>()?);
        Ok(())
    }

    fn of_coprime_polys(&mut self, scope: &Scope, polys: Vec<Poly>) {
        let common = Poly::gcd_many(&polys);
        let unknown_function = |poly: &Poly| {
            poly.occurring_variables().iter().any(|variable| scope.calculus.is_function(variable))
        };
        if !polys.iter().any(|poly| is_symbolic(scope, poly)) || polys.iter().any(unknown_function) {
            return;
        }
        if scope.parameters.len() > 2 {
            self.other("general values of the symbols".to_owned());
            return;
        }
        let cofactors: Vec<Poly> = polys.iter().filter_map(|poly| poly.exact_div(&common)).collect();
        let parameters: [Variable; 2] = surface_parameters(scope);
        let (cases, undetermined) = common_factors(&cofactors, &parameters);
        self.of_common_factor(&cases, &undetermined);
    }

    /// Where gcds and reduced homogeneous coordinates in an expression are not the generic ones.
    fn of_reduced(&mut self, scope: &Scope, expr: &Expr) -> Result<(), Fault> {
        match called(expr) {
            Some(("gcd", arguments)) => return self.of_coprime(scope, arguments),
            Some(("homogeneous", [argument])) => {
                let Some(vector) = scope.evaluate(&argument.value)?.vector() else { return Ok(()) };
                let unknown = |variable: &Variable| scope.calculus.is_function(variable);
                if !vector
                    .components()
                    .iter()
                    .flat_map(|part| part.occurring_variables())
                    .any(|v| unknown(&v))
                {
                    let homogeneous = Homogeneous::of(&vector, &surface_parameters(scope));
                    self.of_surface(&Conditions::of(&homogeneous));
                }
                return Ok(());
            }
            _ => {}
        }
        if let ExprKind::Ident(name) = expr.kind()
            && COORDINATES.contains(&name.as_str())
            && let Some(surface) = &scope.surface
        {
            self.of_surface(surface.conditions());
        }
        expr.children().try_for_each(|child| self.of_reduced(scope, child))
    }
}
