//! What becomes of a claim: relations to verdicts, computed exactly.

use hodograph_algebra::{Fraction, Poly, QuadraticFraction, Variable};

use super::assumptions::Assumptions;
use super::expression::shortened;
use super::fault::Fault;
use super::finding::{Evidence, Finding};
use super::inequality::{TWO_PARTS, approx, inequality, sign, signed};
use super::rationality::{is_pn, is_rational};
use super::value::Value;
use super::witness;
use super::{calls, functions, generic, roots};
use crate::language::ast::{Argument, Expr, ExprKind, RelationOperator, Verdict};

/// Settles a relation.
pub(super) fn settle(assumptions: &Assumptions, relation: &Expr) -> Result<Finding, Fault> {
    let mut finding = finding(assumptions, relation)?;
    let reduced = generic::reduced(&assumptions.scope, relation);
    if !reduced.is_empty() {
        finding = finding.in_general(true).about_variables(reduced);
    }
    let samples = assumptions.samples();
    let satisfiable = !samples.points.is_empty();
    // What holds identically does so under any conditions; what holds or fails in general, where the conditions leave room.
    if (finding.general || finding.verdict == Verdict::Refuted)
        && !(samples.inner || (satisfiable && finding.is_refuted_at_a_point()))
    {
        let found = if satisfiable {
            "only at special values were the conditions found to hold"
        } else {
            "no values of the symbols were found that satisfy the conditions"
        };
        finding = Finding::undecided(found).about_variables(finding.variables);
    }
    match finding.variables.iter().find(|variable| variable.name() == "pi") {
        Some(_) => Err(Fault::pi(relation.span())),
        None => Ok(finding),
    }
}

fn finding(assumptions: &Assumptions, relation: &Expr) -> Result<Finding, Fault> {
    match relation.kind() {
        ExprKind::Not(inner) => Ok(finding(assumptions, inner)?.negated()),
        ExprKind::Relation { left, operator, right } => compare(assumptions, left, *operator, right),
        ExprKind::Call { callee, arguments } => match callee.kind() {
            ExprKind::Ident(name) => predicate(assumptions, relation, name, arguments),
            _ => Err(no_relation(relation)),
        },
        _ => Err(no_relation(relation)),
    }
}

fn no_relation(expr: &Expr) -> Fault {
    Fault::new(expr.span(), "this is a value, not a relation")
        .help("a claim is `a == b`, `a <= b`, `parallel(a, b)`, `positive(a)`, `is_rational(a)`, `coprime(a, b)` or `approx(a, 1.5)`")
}

fn predicate(
    assumptions: &Assumptions,
    relation: &Expr,
    name: &str,
    arguments: &[Argument],
) -> Result<Finding, Fault> {
    let scope = &assumptions.scope;
    let call = calls::Call { scope, span: relation.span(), name, arguments };
    match name {
        "parallel" => {
            let [a, b] = call.positional()?;
            parallel(assumptions, a, b)
        }
        "positive" => {
            let [a] = call.positional()?;
            match signed(scope, a, &scope.evaluate(a)?, "what is claimed to be positive")? {
                Some(value) => inequality(scope, &value, true, relation.span()),
                None => Ok(Finding::undecided(TWO_PARTS)),
            }
        }
        "is_pn" => {
            let [a] = call.positional()?;
            Ok(is_pn(scope, a)?.with_evidence(Evidence::Rationality))
        }
        "is_rational" => {
            let [a] = call.positional()?;
            Ok(is_rational(assumptions, a)?.with_evidence(Evidence::Rationality))
        }
        "approx" => {
            let [a, digits] = call.positional()?;
            approx(scope, a, digits)
        }
        "coprime" => {
            let exprs = arguments.iter().map(|argument| &argument.value);
            let polys =
                exprs.map(|expr| functions::polynomial(scope, expr)).collect::<Result<Vec<_>, _>>()?;
            if polys.len() < 2 {
                return Err(Fault::new(relation.span(), "`coprime` takes two polynomials at least"));
            }
            let gcd = Poly::gcd_many(&polys);
            let sides: Vec<Fraction> = polys.iter().cloned().map(Fraction::from).collect();
            let text = format!("the common factor is {}", shortened(&gcd.to_string()));
            // What depends on symbols alone is a number.
            let finding = Finding::new(!functions::is_varying(scope, &gcd), text);
            let evidence = Evidence::CommonFactor { polynomials: polys, common: gcd };
            Ok(finding.in_general(true).about(&sides).with_evidence(evidence))
        }
        _ => Err(no_relation(relation)),
    }
}

fn compare(
    assumptions: &Assumptions,
    left: &Expr,
    operator: RelationOperator,
    right: &Expr,
) -> Result<Finding, Fault> {
    let scope = &assumptions.scope;
    let (a, b) = (scope.rational_value(left)?, scope.rational_value(right)?);
    if let Value::Degree(degree) = a.bare() {
        let derived = degree.to_string();
        let stated = degrees(&b).filter(|stated| stated.len() == degree.degrees.len()).ok_or_else(|| {
            let (stated, form) = match degree.degrees.len() {
                1 => ("an integer", "degree(f, parameter = v) == 4"),
                _ => ("a pair of integers", "degree(X) == (2, 9)"),
            };
            let message = format!("a degree is compared with {stated}");
            Fault::new(right.span(), message).help(format!("write `{form}`"))
        })?;
        let holds =
            |test: fn(&i64, &i64) -> bool| degree.degrees.iter().zip(&stated).all(|(a, b)| test(a, b));
        let holds = match operator {
            RelationOperator::Equal => holds(i64::eq),
            RelationOperator::NotEqual => !holds(i64::eq),
            RelationOperator::LessEqual => holds(i64::le),
            RelationOperator::GreaterEqual => holds(i64::ge),
            RelationOperator::Less => holds(i64::lt),
            RelationOperator::Greater => holds(i64::gt),
        };
        // Special values of the coefficients can only lower a degree.
        let beyond = degree.degrees.iter().zip(&stated).any(|(derived, stated)| stated > derived);
        let certain = match operator {
            RelationOperator::LessEqual | RelationOperator::Less => holds,
            RelationOperator::GreaterEqual | RelationOperator::Greater => !holds,
            RelationOperator::Equal | RelationOperator::NotEqual => beyond,
        };
        let mut variables = degree.variables.clone();
        let mut fixed = true;
        if let Value::Degree(other) = b.bare() {
            fixed = other.variables.iter().all(|variable| scope.parameters.contains(variable));
            variables.extend(other.variables.iter().cloned());
        }
        let finding = Finding::new(holds, derived).in_general(!(certain && fixed)).about_variables(variables);
        return Ok(finding.with_evidence(Evidence::Degrees { derived: degree.as_ref().clone(), stated }));
    }
    match operator {
        RelationOperator::Equal => return equality(assumptions, left, &a, right, &b),
        RelationOperator::NotEqual => return Ok(equality(assumptions, left, &a, right, &b)?.negated()),
        _ => {}
    }
    let strict = matches!(operator, RelationOperator::Less | RelationOperator::Greater);
    if roots::concern(&a, &b) {
        let span = left.span().to(right.span());
        let (more, less) = if operator.is_less() { (&b, &a) } else { (&a, &b) };
        let Some(difference) = roots::sum(more, less, true, span)? else {
            return Err(Fault::new(span, "an inequality compares scalars"));
        };
        return match signed(scope, left, &difference, "a side of an inequality")? {
            Some(value) => sign(scope, &value, strict, operator.is_less(), span),
            None => Ok(Finding::undecided(TWO_PARTS)),
        };
    }
    let side = |value: &Value, expr: &Expr| {
        value.scalar().ok_or_else(|| {
            Fault::new(expr.span(), format!("an inequality compares scalars, but this is {}", value.kind()))
        })
    };
    let (a, b) = (side(&a, left)?, side(&b, right)?);
    let difference = if operator.is_less() { &b - &a } else { &a - &b };
    sign(scope, &difference, strict, operator.is_less(), left.span().to(right.span()))
}

/// The degrees that a pair or an integer states.
fn degrees(value: &Value) -> Option<Vec<i64>> {
    let part = |part: &Fraction| part.to_rational().filter(|value| value.is_integer())?.to_integer().small();
    match value.bare() {
        Value::Degree(degree) => Some(degree.degrees.clone()),
        Value::Tuple(parts) => parts.iter().map(part).collect(),
        Value::Scalar(degree) => Some(vec![part(degree)?]),
        _ => None,
    }
}

fn equality(
    assumptions: &Assumptions,
    left: &Expr,
    a: &Value,
    right: &Expr,
    b: &Value,
) -> Result<Finding, Fault> {
    if roots::concern(a, b) {
        return rooted_equality(assumptions, left, a, right, b);
    }
    let (a, b) = components(left, a, right, b)?;
    let differences: Vec<Fraction> = a.iter().zip(&b).map(|(a, b)| a - b).collect();
    let holds = differences.iter().all(Fraction::is_zero);
    let value = print(&a);
    let finding = if holds {
        Finding::new(true, format!("both sides are {value}"))
    } else {
        let witness = witness::unequal(assumptions, &a, &b);
        Finding::new(false, format!("the left side is {value}")).with_witness(witness)
    };
    Ok(finding.about(a.iter().chain(&b)).with_evidence(Evidence::Sides { left: a, right: b }))
}

/// An equation between scalars or vectors with square roots.
fn rooted_equality(
    assumptions: &Assumptions,
    left: &Expr,
    a: &Value,
    right: &Expr,
    b: &Value,
) -> Result<Finding, Fault> {
    let (a_parts, b_parts) = (roots::parts(a, left.span())?, roots::parts(b, right.span())?);
    let (a, b) = match (a_parts, b_parts) {
        (Some(a), Some(b)) if a.len() == b.len() => (a, b),
        _ => {
            let message = format!("{} is compared with {}", a.kind(), b.kind());
            return Err(Fault::new(left.span().to(right.span()), message)
                .help("both sides must be scalars, or vectors"));
        }
    };
    let holds = a.iter().zip(&b).all(|(a, b)| a == b);
    let variables: Vec<Variable> =
        a.iter().chain(&b).flat_map(QuadraticFraction::occurring_variables).collect();
    let value = print_rooted(&a);
    let finding = if holds {
        Finding::new(true, format!("both sides are {value}"))
    } else {
        let witness = witness::unequal_roots(assumptions, &a, &b);
        Finding::new(false, format!("the left side is {value}")).with_witness(witness)
    };
    Ok(finding.about_variables(variables).with_evidence(Evidence::RootedSides { left: a, right: b }))
}

/// Components with square roots for a report.
fn print_rooted(parts: &[QuadraticFraction]) -> String {
    let texts: Vec<String> = parts.iter().map(ToString::to_string).collect();
    match texts.as_slice() {
        [one] => cut(one.clone()),
        many => cut(format!("({})", many.join(", "))),
    }
}

/// The components of both sides of an equation, as many on the left as on the right.
pub(super) fn components(
    left: &Expr,
    a: &Value,
    right: &Expr,
    b: &Value,
) -> Result<(Vec<Fraction>, Vec<Fraction>), Fault> {
    if let (true, Some(a), Some(b)) = (a.is_quaternion() || b.is_quaternion(), a.quaternion(), b.quaternion())
    {
        return Ok((a.components().to_vec(), b.components().to_vec()));
    }
    if let (Some(a), Some(b)) = (a.complex(), b.complex()) {
        let real = a.im.is_zero() && b.im.is_zero();
        return Ok(if real { (vec![a.re], vec![b.re]) } else { (vec![a.re, a.im], vec![b.re, b.im]) });
    }
    let mixed = || {
        let message = format!("{} is compared with {}", a.kind(), b.kind());
        Fault::new(left.span().to(right.span()), message).help("both sides must be scalars, or vectors")
    };
    let long = |value: &Value| matches!(value.bare(), Value::Tuple(parts) if parts.len() > 3);
    let sides = if long(a) || long(b) {
        (a.components(), b.components())
    } else {
        let components = |value: &Value| value.vector().map(|vector| vector.components().to_vec());
        (components(a), components(b))
    };
    match sides {
        (Some(a), Some(b)) if a.len() == b.len() => Ok((a, b)),
        _ => Err(mixed()),
    }
}

/// A value for a report: scalars bare, several components in parentheses, cut where very long.
pub(super) fn print(components: &[Fraction]) -> String {
    let reduced: Vec<String> = components.iter().map(|component| component.reduced().to_string()).collect();
    let parts = match reduced.as_slice() {
        // The imaginary part of a real number is no news.
        [re, im] if im == "0" => re.clone(),
        [one] => one.clone(),
        many => format!("({})", many.join(", ")),
    };
    cut(parts)
}

/// A text, cut where very long.
pub(super) fn cut(parts: String) -> String {
    const LONGEST: usize = 400;
    if parts.chars().count() <= LONGEST {
        return parts;
    }
    let length = parts.chars().count();
    format!("{}… ({length} characters)", parts.chars().take(LONGEST).collect::<String>())
}

fn parallel(assumptions: &Assumptions, left: &Expr, right: &Expr) -> Result<Finding, Fault> {
    let scope = &assumptions.scope;
    let side = |expr: &Expr| {
        let value = scope.rational_value(expr)?;
        value.components().ok_or_else(|| {
            Fault::new(expr.span(), format!("`parallel` compares vectors, but this is {}", value.kind()))
        })
    };
    let (mut a, mut b) = (side(left)?, side(right)?);
    if a.len() != b.len() {
        if a.len() > 3 || b.len() > 3 {
            let message = format!("{} components are compared with {}", a.len(), b.len());
            return Err(Fault::new(left.span().to(right.span()), message));
        }
        a.resize(3, Fraction::zero());
        b.resize(3, Fraction::zero());
    }
    let zero = |side: &[Fraction]| side.iter().all(Fraction::is_zero);
    if zero(&a) || zero(&b) {
        let which = if zero(&a) { "left" } else { "right" };
        return Ok(Finding::new(false, format!("the {which} side is zero and has no direction"))
            .about(a.iter().chain(&b))
            .with_evidence(Evidence::Directions { left: a, right: b }));
    }
    let pairs = (0..a.len()).flat_map(|i| (0..i).map(move |j| (j, i)));
    let unequal = pairs.into_iter().find(|&(i, j)| &a[i] * &b[j] != &a[j] * &b[i]);
    let derived = format!("the left side is {}", print(&a));
    Ok(match unequal {
        None => Finding::new(true, derived),
        Some((i, j)) => {
            let (p, q) = (&a[i] * &b[j], &a[j] * &b[i]);
            let witness = witness::not_parallel(assumptions, &[p], &[q], &a, &b);
            Finding::new(false, derived).with_witness(witness)
        }
    }
    .about(a.iter().chain(&b))
    .with_evidence(Evidence::Directions { left: a, right: b }))
}
