//! What becomes of a claim: relations to verdicts, computed exactly.

use hodograph_algebra::{
    BoxSign, Fraction, Interval, OffsetError, Poly, QuadraticFraction, Variable, integer, parse_decimal,
};

use super::assumptions::Assumptions;
use super::expression::shortened;
use super::fault::Fault;
use super::scope::Scope;
use super::value::Value;
use super::witness;
use super::{calls, functions, generic, roots, surfaces};
use crate::language::Span;
use crate::language::ast::{Argument, Expr, ExprKind, RelationOperator, Verdict};

/// A verdict with what supports it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Finding {
    /// The verdict.
    pub verdict: Verdict,
    /// The value that was derived, in place of which the claim has its own.
    pub derived: String,
    /// Where the claim fails.
    pub witness: Option<String>,
    /// What must hold of the symbols besides what the claim assumes, as relations of the language.
    pub conditions: Vec<String>,
    /// The variables that the sides depend on.
    pub variables: Vec<Variable>,
    /// Whether the finding is about unknowns in general, and may differ for special values of them.
    pub general: bool,
}

impl Finding {
    fn new(holds: bool, derived: impl Into<String>) -> Finding {
        let verdict = if holds { Verdict::Proved } else { Verdict::Refuted };
        // What holds identically holds for all values; what fails somewhere may hold elsewhere.
        Finding {
            verdict,
            derived: derived.into(),
            witness: None,
            conditions: Vec::new(),
            variables: Vec::new(),
            general: !holds,
        }
    }

    pub(super) fn undecided(derived: impl Into<String>) -> Finding {
        Finding { verdict: Verdict::Undecided, general: false, ..Finding::new(false, derived) }
    }

    /// The finding on the opposite relation.
    fn negated(self) -> Finding {
        let verdict = match self.verdict {
            Verdict::Proved => Verdict::Refuted,
            Verdict::Refuted => Verdict::Proved,
            Verdict::Undecided => Verdict::Undecided,
        };
        Finding { verdict, ..self }
    }

    fn in_general(self, general: bool) -> Finding {
        Finding { general, ..self }
    }

    fn is_refuted_at_a_point(&self) -> bool {
        self.verdict == Verdict::Refuted && self.witness.is_some()
    }

    fn with_witness(mut self, witness: Option<String>) -> Finding {
        self.witness = witness;
        self
    }

    fn about<'a>(self, values: impl IntoIterator<Item = &'a Fraction>) -> Finding {
        self.about_variables(values.into_iter().flat_map(Fraction::occurring_variables))
    }

    pub(super) fn about_variables(mut self, variables: impl IntoIterator<Item = Variable>) -> Finding {
        self.variables.extend(variables);
        self.variables.sort();
        self.variables.dedup();
        self
    }
}

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
            is_pn(scope, a)
        }
        "is_rational" => {
            let [a] = call.positional()?;
            is_rational(assumptions, a)
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
            let sides: Vec<Fraction> = polys.into_iter().map(Fraction::from).collect();
            let text = format!("the common factor is {}", shortened(&gcd.to_string()));
            // What depends on symbols alone is a number.
            Ok(Finding::new(!functions::is_varying(scope, &gcd), text).in_general(true).about(&sides))
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
        return Ok(Finding::new(holds, derived).in_general(!(certain && fixed)).about_variables(variables));
    }
    match operator {
        RelationOperator::Equal => return equality(assumptions, left, &a, right, &b),
        RelationOperator::NotEqual => return Ok(equality(assumptions, left, &a, right, &b)?.negated()),
        _ => {}
    }
    if roots::concern(&a, &b) {
        let span = left.span().to(right.span());
        let (more, less, strict) = match operator {
            RelationOperator::Less => (&b, &a, true),
            RelationOperator::Greater => (&a, &b, true),
            RelationOperator::GreaterEqual => (&a, &b, false),
            _ => (&b, &a, false),
        };
        let Some(difference) = roots::sum(more, less, true, span)? else {
            return Err(Fault::new(span, "an inequality compares scalars"));
        };
        return match signed(scope, left, &difference, "a side of an inequality")? {
            Some(value) => inequality(scope, &value, strict, span),
            None => Ok(Finding::undecided(TWO_PARTS)),
        };
    }
    let side = |value: &Value, expr: &Expr| {
        value.scalar().ok_or_else(|| {
            Fault::new(expr.span(), format!("an inequality compares scalars, but this is {}", value.kind()))
        })
    };
    let (a, b) = (side(&a, left)?, side(&b, right)?);
    let (difference, strict) = match operator {
        RelationOperator::Less => (&b - &a, true),
        RelationOperator::Greater => (&a - &b, true),
        RelationOperator::GreaterEqual => (&a - &b, false),
        _ => (&b - &a, false),
    };
    inequality(scope, &difference, strict, left.span().to(right.span()))
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
    if holds {
        return Ok(Finding::new(true, format!("both sides are {value}")).about(a.iter().chain(&b)));
    }
    let witness = witness::unequal(assumptions, &a, &b);
    Ok(Finding::new(false, format!("the left side is {value}"))
        .with_witness(witness)
        .about(a.iter().chain(&b)))
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
    let variables = a.iter().chain(&b).flat_map(QuadraticFraction::occurring_variables);
    let value = print_rooted(&a);
    let finding = if holds {
        Finding::new(true, format!("both sides are {value}"))
    } else {
        let witness = witness::unequal_roots(assumptions, &a, &b);
        Finding::new(false, format!("the left side is {value}")).with_witness(witness)
    };
    Ok(finding.about_variables(variables))
}

/// Components with square roots for a report.
fn print_rooted(parts: &[QuadraticFraction]) -> String {
    let texts: Vec<String> = parts.iter().map(ToString::to_string).collect();
    match texts.as_slice() {
        [one] => cut(one.clone()),
        many => cut(format!("({})", many.join(", "))),
    }
}

/// What is undecided of a sum of a rational function and a root.
const TWO_PARTS: &str =
    "the rational part and the square root may cancel on the domain, so the sign is not decided";

/// A rational function of the same sign as a scalar `a + b·√q` on the domain: `a` where `a² − b²q` is positive, `b·q` where it is negative or
/// a is zero. `None` where neither is certain.
fn signed(scope: &Scope, expr: &Expr, value: &Value, role: &str) -> Result<Option<Fraction>, Fault> {
    if !roots::is_rooted(value) {
        let scalar = value.scalar();
        return if scalar.is_some() { Ok(scalar) } else { scope.scalar(expr, role).map(Some) };
    }
    let parts = roots::parts(value, expr.span())?.unwrap_or_default();
    let [scalar] = parts.as_slice() else {
        return Err(Fault::new(
            expr.span(),
            format!("{role} must be a scalar, but this is {}", value.kind()),
        ));
    };
    if let Some(rational) = scalar.to_rational_function() {
        return Ok(Some(rational));
    }
    let (a, b) = (scalar.rational_part(), scalar.root_part());
    let radicand = Fraction::from(scalar.radicand().clone());
    let irrational = || (b * &radicand).reduced();
    if a.is_zero() {
        return Ok(Some(irrational()));
    }
    let norm = (&(a * a) - &(&(b * b) * &radicand)).reduced();
    let positive = |norm: &Fraction| {
        inequality(scope, norm, true, expr.span()).map(|finding| finding.verdict == Verdict::Proved)
    };
    if positive(&norm)? {
        return Ok(Some(a.clone()));
    }
    Ok(positive(&-&norm)?.then(irrational))
}

/// Whether a surface is a Pythagorean-normal surface in its parameters.
fn is_pn(scope: &Scope, expr: &Expr) -> Result<Finding, Fault> {
    let surface = surfaces::surface(scope, expr)?;
    let normal = surface.normal().map_err(|error| Fault::offset(expr.span(), &error))?;
    let squared = normal.squared_length();
    let split = squared.split();
    let derived = if split.is_square() {
        format!(
            "R_u x R_v has the direction N with |N|^2 = {}*({})^2",
            split.unit,
            cut(split.root.to_string())
        )
    } else {
        format!(
            "|N|^2 for the direction N of R_u x R_v has the factor {} to an odd power",
            cut(split.odd.to_string())
        )
    };
    Ok(Finding::new(normal.is_rational(), derived).about(surface.position().components()))
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
fn cut(parts: String) -> String {
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
            .about(a.iter().chain(&b)));
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
    .about(a.iter().chain(&b)))
}

fn is_rational(assumptions: &Assumptions, expr: &Expr) -> Result<Finding, Fault> {
    let scope = &assumptions.scope;
    let unknowns = || generic::unknowns(scope, expr);
    match scope.evaluate(expr) {
        Ok(value) if roots::is_rooted(&value) && value.scalar().is_none() => {
            let parts = roots::parts(&value, expr.span())?.unwrap_or_default();
            let message = match parts.iter().find(|part| !part.is_rational()) {
                Some(part) => *roots::irrational(expr.span(), part).diagnostic,
                None => *Fault::new(expr.span(), "it has a square root").diagnostic,
            };
            Ok(Finding::new(false, message.message).about_variables(unknowns()))
        }
        Err(fault) if fault.irrational => {
            Ok(Finding::new(false, fault.diagnostic.message).about_variables(unknowns()))
        }
        Err(fault) => match functions::symbolic_root(scope, expr)? {
            // Over the real numbers a function of the symbols is a constant.
            Some(radicand) if assumptions.with_nonnegative(&radicand).samples().points.is_empty() => {
                let text =
                    format!("no values of the symbols were found for which {radicand} is not negative");
                Ok(Finding::undecided(text).about_variables(unknowns()))
            }
            Some(radicand) => {
                let text =
                    format!("it contains the square root of {radicand}, which depends on the symbols alone");
                let mut finding = Finding::new(true, text).about_variables(unknowns());
                if !functions::is_positive_everywhere(&radicand) && !assumptions.state_nonnegative(&radicand)
                {
                    finding.conditions.push(format!("{radicand} >= 0"));
                }
                Ok(finding)
            }
            None => Err(fault),
        },
        Ok(value) => match value.bare() {
            Value::AdaptedFrame(frame) => {
                match frame.rational().map_err(|error| Fault::curve(expr.span(), &error)) {
                    Ok(frame) => {
                        let parts = frame.f.components().iter().chain(frame.g.components());
                        let text = match &frame.rotation {
                            Some(w) => format!(
                                "rational, of the angle 2*arg(W) with W = {}",
                                shortened(&w.to_string())
                            ),
                            None => format!("rational, f = {}", print(frame.f.components())),
                        };
                        Ok(Finding::new(true, text).about(parts))
                    }
                    Err(fault) if fault.irrational => {
                        Ok(Finding::new(false, fault.diagnostic.message).about_variables(unknowns()))
                    }
                    Err(fault) => Err(fault),
                }
            }
            Value::Offset(offset) => match offset.as_ref() {
                Ok(surface) => {
                    let degree = surface.homogeneous().degree();
                    Ok(Finding::new(true, format!("rational, of degree {degree}"))
                        .about(surface.position().components()))
                }
                Err(error @ OffsetError::SymbolicRadical { radicand, .. }) => {
                    Ok(Finding::new(true, error.to_string())
                        .about_variables(radicand.occurring_variables().into_iter().chain(unknowns())))
                }
                Err(error @ OffsetError::Irrational { .. }) => {
                    Ok(Finding::new(false, error.to_string()).about_variables(unknowns()))
                }
                Err(error) => Err(Fault::offset(expr.span(), error)),
            },
            other => {
                let components = other.complex().map(|z| vec![z.re, z.im]).or_else(|| other.components());
                let derived = components.as_deref().map_or_else(|| other.kind().to_owned(), print);
                Ok(Finding::new(true, derived).about(components.iter().flatten()))
            }
        },
    }
}

/// Whether a value agrees with a printed decimal: their difference is at most half a unit of the last digit.
fn approx(scope: &Scope, value: &Expr, digits: &Expr) -> Result<Finding, Fault> {
    let number = scope.number(value, "what is approximated")?;
    let (literal, negative) = match digits.kind() {
        ExprKind::Negative(inner) => (inner.as_ref(), true),
        _ => (digits, false),
    };
    let decimal = match literal.kind() {
        ExprKind::Number(text) => parse_decimal(text).map(|value| (text, value)),
        _ => None,
    };
    let Some((text, decimal)) = decimal else {
        return Err(
            Fault::new(digits.span(), "a decimal number is expected here").help("write `approx(a, 1.414)`")
        );
    };
    let stated = Poly::constant(if negative { -decimal } else { decimal });
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let places = mantissa.split_once('.').map_or(0, |(_, fraction)| fraction.len());
    // The literal was read, so its exponent is small.
    let places = i64::try_from(places).unwrap_or(0) - exponent.parse::<i64>().unwrap_or(0);
    let Some(unit) = parse_decimal(&format!("1e{}", -places)) else {
        return Err(Fault::new(digits.span(), "this decimal has too many digits"));
    };
    let difference = &number - &stated;
    let size = if difference.sign().is_lt() { -difference } else { difference };
    let holds = size.scale(&integer(2)).compare(&Poly::constant(unit)).is_le();
    let shown = u32::try_from(places.max(0)).unwrap_or(0) + 6;
    let exact = shortened(&number.to_string());
    Ok(Finding::new(holds, format!("{} ({exact})", number.to_decimal(shown))))
}

/// Whether `value` is positive (or, if not `strict`, not negative) for all values of the parameters in their domains.
fn inequality(scope: &Scope, value: &Fraction, strict: bool, span: Span) -> Result<Finding, Fault> {
    let value = value.lowest_terms();
    if let Some(number) = value.to_number() {
        let sign = number.sign();
        let holds = sign.is_gt() || (!strict && sign.is_eq());
        return Ok(Finding::new(
            holds,
            format!("the difference to zero is {}", shortened(&number.to_string())),
        ));
    }
    let variables = value.occurring_variables();
    let mut domain: Vec<(Variable, Interval)> = Vec::new();
    for variable in &variables {
        match scope.domains.get(variable) {
            Some(interval) => domain.push((variable.clone(), interval.clone())),
            None if scope.parameters.contains(variable) => {
                let message = format!("the domain of `{variable}` is not stated");
                return Err(Fault::new(span, message).help(format!("add `domain {variable} in 0..1;`")));
            }
            None => {
                return Ok(
                    Finding::undecided(format!("it depends on the unknown `{variable}`")).about([&value])
                );
            }
        }
    }
    for (factor, _) in value.factors() {
        if factor.sign_on(&domain).is_none_or(|sign| !matches!(sign, BoxSign::Positive | BoxSign::Negative)) {
            let message =
                format!("the denominator {} may vanish on the domain", shortened(&factor.to_string()));
            return Ok(Finding::undecided(message).about([&value]));
        }
    }
    // Even powers of the denominator do not matter for the sign.
    let odd = value.factors().iter().filter(|(_, exponent)| exponent % 2 == 1);
    let signed = odd.fold(value.numerator().clone(), |product, (factor, _)| product * factor);
    let Some(sign) = signed.sign_on(&domain) else {
        return Ok(Finding::undecided("the sign cannot be determined").about([&value]));
    };
    let at = |point| witness::point(&point);
    let finding = match sign {
        BoxSign::Positive => Finding::new(true, "positive on the whole domain"),
        BoxSign::Negative => {
            Finding::new(false, "negative on the whole domain").with_witness(witness::corner(&domain))
        }
        BoxSign::Zero => Finding::new(!strict, "zero everywhere").with_witness(witness::corner(&domain)),
        BoxSign::NonNegative { zeros } if !strict => {
            Finding::new(true, format!("not negative; zeros: {zeros}"))
        }
        BoxSign::NonNegative { zeros } if zeros.is_empty() => {
            Finding::new(true, "positive on the whole domain")
        }
        BoxSign::NonNegative { zeros } if zeros.is_complete() => {
            let finding = Finding::new(false, format!("not negative, with zeros: {zeros}"));
            finding.with_witness(zeros.witness(&domain).map(at))
        }
        BoxSign::NonPositive { zeros } => Finding::new(false, format!("not positive; zeros: {zeros}"))
            .with_witness(witness::negative(&signed, &domain)),
        BoxSign::ChangesSign { negative, .. } => {
            Finding::new(false, "of both signs on the domain").with_witness(Some(at(negative)))
        }
        BoxSign::Undecided { zero: Some(zero), .. } if strict => {
            Finding::new(false, "it vanishes on the domain").with_witness(Some(at(zero)))
        }
        _ => Finding::undecided("subdivision reached its limit before the sign was decided"),
    };
    Ok(finding.about([&value]))
}
