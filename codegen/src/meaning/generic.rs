//! The conditions on symbols under which what holds in general holds: degrees, coprimality, reduced coordinates.

use std::collections::BTreeSet;
use std::rc::Rc;

use hodograph_algebra::{
    CommonZero, Conditions, Fraction, Homogeneous, Locus, Poly, SweptSurface, Variable, budget,
    common_factors, falling_degree,
};

use super::expression::shortened;
use super::fault::Fault;
use super::functions::{is_varying, polynomial, surface_parameters};
use super::relation;
use super::scope::{COORDINATES, Scope};
use super::value::Value;
use crate::language::ast::{Argument, ClauseKind, Expr, ExprKind, RelationOperator};

/// How many characters a polynomial takes before it is cut.
const LONGEST: usize = 240;

/// How many equations of one case are printed.
const MOST_EQUATIONS: usize = 6;

/// The condition of what holds for general values of symbols, where it is not known which ones are special.
const GENERAL: &str = "general values of the symbols";

/// The values of symbols at which a general statement may fail.
#[derive(Default)]
struct Exceptions {
    locus: Locus,
    /// What must hold besides, as relations of the language.
    others: Vec<String>,
    /// The names whose definitions were looked at.
    seen: BTreeSet<String>,
}

/// The conditions under which what was found of a relation for general symbols holds, as relations of the language.
///
/// `general` says that it may differ for special ones; `nonzero` are polynomials that do not vanish, as the claim itself says.
pub(super) fn conditions(scope: &Scope, relation: &Expr, general: bool, nonzero: &[Poly]) -> Vec<String> {
    let found = budget::with_budget(Conditions::BUDGET, || exceptions(scope, relation, general, false));
    let exceptions = match found {
        Ok(Ok(exceptions)) => exceptions,
        // A mistake in the relation has been reported with its verdict.
        Ok(Err(_)) => return Vec::new(),
        Err(_) => return vec![GENERAL.to_owned()],
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

fn exceptions(scope: &Scope, relation: &Expr, general: bool, negated: bool) -> Result<Exceptions, Fault> {
    let mut exceptions = Exceptions::default();
    match relation.kind() {
        ExprKind::Not(inner) => return self::exceptions(scope, inner, general, !negated),
        ExprKind::Relation { left, operator, right } => {
            if let Some(("degree", arguments)) = called(resolved(scope, left)) {
                if general {
                    exceptions.of_degree(scope, arguments)?;
                    if let Some(("degree", arguments)) = called(resolved(scope, right)) {
                        exceptions.of_degree(scope, arguments)?;
                    }
                }
            } else if matches!(operator, RelationOperator::Equal | RelationOperator::NotEqual) {
                exceptions.of_reduced(scope, left)?;
                exceptions.of_reduced(scope, right)?;
                if (*operator == RelationOperator::NotEqual) != negated {
                    exceptions.of_difference(scope, left, right)?;
                }
            }
        }
        _ => match called(relation) {
            Some(("coprime", arguments)) => exceptions.of_coprime(scope, arguments)?,
            Some(("is_rational", [argument])) if general => exceptions.of_rational(scope, &argument.value)?,
            Some((_, arguments)) if !reduced(scope, relation).is_empty() => {
                arguments.iter().try_for_each(|argument| exceptions.of_reduced(scope, &argument.value))?;
            }
            _ => {}
        },
    }
    Ok(exceptions)
}

/// The unknowns in what is reduced by a common factor that special symbols and functions change: in a `gcd`, or in the
/// coordinates that `homogeneous` gives, except where only their direction matters.
pub(super) fn reduced(scope: &Scope, relation: &Expr) -> BTreeSet<Variable> {
    fn collect(
        scope: &Scope,
        expr: &Expr,
        functions: &[&str],
        seen: &mut BTreeSet<String>,
        found: &mut BTreeSet<Variable>,
    ) {
        if let Some((name, arguments)) = called(expr)
            && functions.contains(&name)
        {
            found.extend(arguments.iter().flat_map(|argument| unknowns(scope, &argument.value)));
        }
        if let ExprKind::Ident(name) = expr.kind()
            && seen.insert(name.clone())
            && let Some(value) = definition(scope, name)
        {
            collect(scope, value, functions, seen, found);
        }
        expr.children().for_each(|child| collect(scope, child, functions, seen, found));
    }
    let functions: &[&str] =
        if matches!(called(relation), Some(("parallel", _))) { &["gcd"] } else { &["gcd", "homogeneous"] };
    let mut found = BTreeSet::new();
    collect(scope, relation, functions, &mut BTreeSet::new(), &mut found);
    found
}

/// The symbols and unknown functions in the values of the names in an expression.
pub(super) fn unknowns(scope: &Scope, expr: &Expr) -> BTreeSet<Variable> {
    fn of_value(scope: &Scope, value: &Value) -> Vec<Variable> {
        match value.bare() {
            Value::Degree(degree) => degree.variables.clone(),
            Value::List(parts) => parts.iter().flat_map(|part| of_value(scope, part)).collect(),
            other => {
                let components = other.complex().map(|z| vec![z.re, z.im]).or_else(|| other.components());
                match components {
                    Some(components) => components.iter().flat_map(Fraction::occurring_variables).collect(),
                    None => scope.unknowns(),
                }
            }
        }
    }
    let mut unknowns = BTreeSet::new();
    match expr.kind() {
        // The names of functions of the language have no value.
        ExprKind::Ident(name) => {
            if let Ok(value) = scope.value(name, expr.span()) {
                match (value.bare(), definition(scope, name)) {
                    (Value::Offset(offset), Some(definition)) if offset.is_err() => {
                        unknowns.extend(self::unknowns(scope, definition));
                    }
                    _ => unknowns.extend(of_value(scope, &value)),
                }
            }
        }
        _ => expr.children().for_each(|child| unknowns.extend(self::unknowns(scope, child))),
    }
    // π only stands in angles.
    unknowns.retain(|variable| !scope.parameters.contains(variable) && variable.name() != "pi");
    unknowns
}

/// The expression that defines a name.
pub(super) fn definition<'a>(scope: &'a Scope, name: &str) -> Option<&'a Expr> {
    let clauses = scope.item.as_ref()?.clauses.iter();
    clauses.into_iter().find_map(|clause| match &clause.kind {
        ClauseKind::Let(definition) if definition.name.value == name => Some(&definition.value),
        ClauseKind::Curve(curve) if curve.name.value == name => Some(&curve.value),
        ClauseKind::Surface(surface) if surface.name.value == name => Some(&surface.value),
        _ => None,
    })
}

/// The expression that a name stands for, and what that is if it is a name again.
pub(super) fn resolved<'a>(scope: &'a Scope, expr: &'a Expr) -> &'a Expr {
    match expr.kind() {
        // Clauses only use names that are defined before them, so this ends.
        ExprKind::Ident(name) => definition(scope, name).map_or(expr, |value| resolved(scope, value)),
        _ => expr,
    }
}

/// The function's name and the arguments of a call.
pub(super) fn called(expr: &Expr) -> Option<(&str, &[Argument])> {
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

    /// The exceptions of homogeneous coordinates; several claims are about the same ones, so they are kept.
    fn of_homogeneous(&mut self, scope: &Scope, homogeneous: &Homogeneous) {
        let known = scope.conditions.borrow().iter().find(|(other, _)| other == homogeneous).cloned();
        let conditions = known.map(|(_, conditions)| conditions).unwrap_or_else(|| {
            let found = budget::with_budget(Conditions::BUDGET, || Conditions::of(homogeneous));
            let found = found.ok().map(Rc::new);
            scope.conditions.borrow_mut().push((homogeneous.clone(), found.clone()));
            found
        });
        match conditions {
            Some(conditions) => self.of_surface(&conditions),
            None => self.in_general(),
        }
    }

    /// Where the polynomials of `degree(…)` have a lower degree.
    fn of_degree(&mut self, scope: &Scope, arguments: &[Argument]) -> Result<(), Fault> {
        let by = arguments.iter().find(|argument| argument.name.is_some());
        let by = by.map(|by| super::functions::parameter(scope, &by.value)).transpose()?;
        let (mut polys, mut known) = (Vec::new(), Vec::new());
        for argument in arguments.iter().filter(|argument| argument.name.is_none()) {
            let expr = &argument.value;
            self.of_reduced(scope, expr)?;
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
                    self.of_homogeneous(scope, surface.homogeneous());
                    surface.homogeneous().clone()
                }
                None => {
                    let Some(vector) = value.vector() else {
                        self.in_general();
                        continue;
                    };
                    let homogeneous = Homogeneous::of(&vector, &surface_parameters(scope));
                    self.of_homogeneous(scope, &homogeneous);
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

    /// Where different functions become the same.
    fn of_difference(&mut self, scope: &Scope, left: &Expr, right: &Expr) -> Result<(), Fault> {
        let (a, b) = (scope.rational_value(left)?, scope.rational_value(right)?);
        let (a, b) = relation::components(left, &a, right, &b)?;
        let differences: Vec<Poly> =
            a.iter().zip(&b).map(|(a, b)| (a - b).reduced().numerator().clone()).collect();
        let unknown_function = |poly: &Poly| {
            poly.occurring_variables().iter().any(|variable| scope.calculus.is_function(variable))
        };
        if !differences.iter().all(Poly::is_zero) && !differences.iter().any(unknown_function) {
            let coefficients =
                differences.iter().flat_map(|poly| poly.coefficients_of(&scope.parameters).into_values());
            self.add(&Locus::of(&coefficients.collect::<Vec<_>>(), &[]));
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
                (None, _) => self.in_general(),
            }
        }
        if !undetermined.is_empty() {
            self.in_general();
        }
    }

    fn in_general(&mut self) {
        self.other(GENERAL.to_owned());
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
        let is_unknown = |variable: &Variable| scope.calculus.is_function(variable);
        if !polys.iter().any(|poly| is_symbolic(scope, poly)) {
            return;
        }
        let occurring: BTreeSet<Variable> = polys.iter().flat_map(Poly::occurring_variables).collect();
        if scope.parameters.len() > 2 || occurring.iter().any(is_unknown) {
            if occurring.iter().any(|variable| scope.symbols.contains(variable)) {
                self.in_general();
            }
            return;
        }
        let common = Poly::gcd_many(&polys);
        // The common factor must not become a number, nor zero.
        let mut coefficients = common.coefficients_of(&scope.parameters);
        if is_varying(scope, &common) {
            coefficients.retain(|exponents, _| exponents.iter().any(|exponent| *exponent > 0));
        }
        let cofactors: Vec<Poly> = polys.iter().filter_map(|poly| poly.exact_div(&common)).collect();
        self.add(&Locus::of(&coefficients.into_values().collect::<Vec<_>>(), &[]));
        if cofactors.iter().any(|cofactor| cofactor.is_constant() && !cofactor.is_zero()) {
            return;
        }
        // Where a cofactor vanishes, the others have their own common factor.
        for cofactor in cofactors.iter().filter(|cofactor| !cofactor.is_zero()) {
            let content = Poly::gcd_many(
                &cofactor.coefficients_of(&scope.parameters).into_values().collect::<Vec<_>>(),
            );
            if is_symbolic(scope, &content) {
                self.add(&Locus::of(&[content], &[]));
            }
        }
        let (cases, undetermined) = common_factors(&cofactors, &surface_parameters(scope));
        self.of_common_factor(&cases, &undetermined);
    }

    /// Where what is not rational in general may become so.
    fn of_rational(&mut self, scope: &Scope, expr: &Expr) -> Result<(), Fault> {
        if let Some(("offset", [surface, distance])) = called(resolved(scope, expr)) {
            // The offset at the distance zero is the surface itself.
            let distance = scope.scalar(&distance.value, "the distance of an offset")?;
            self.add(&Locus::of(&[distance.lowest_terms().numerator().clone()], &[]));
            if !unknowns(scope, &surface.value).is_empty() {
                self.in_general();
            }
        } else if !unknowns(scope, expr).is_empty() {
            self.in_general();
        }
        Ok(())
    }

    /// Where gcds and reduced homogeneous coordinates in an expression are not the generic ones.
    fn of_reduced(&mut self, scope: &Scope, expr: &Expr) -> Result<(), Fault> {
        match called(expr) {
            Some(("gcd", arguments)) => return self.of_coprime(scope, arguments),
            Some(("homogeneous", [argument])) => {
                if let Some(surface) = surface(scope, &argument.value) {
                    self.of_homogeneous(scope, surface.homogeneous());
                    return Ok(());
                }
                let vector = scope.evaluate(&argument.value)?.vector();
                let is_unknown = |variable: Variable| scope.calculus.is_function(&variable);
                match vector {
                    Some(vector)
                        if !vector
                            .components()
                            .iter()
                            .flat_map(Fraction::occurring_variables)
                            .any(is_unknown) =>
                    {
                        let homogeneous = Homogeneous::of(&vector, &surface_parameters(scope));
                        self.of_homogeneous(scope, &homogeneous);
                    }
                    _ => self.in_general(),
                }
                return Ok(());
            }
            _ => {}
        }
        if let ExprKind::Ident(name) = expr.kind()
            && self.seen.insert(name.clone())
            && let Some(value) = definition(scope, name)
        {
            return self.of_reduced(scope, value);
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
