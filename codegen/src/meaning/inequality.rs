//! Signs on the domain, and numbers beside decimals.

use hodograph_algebra::{BoxSign, Fraction, Interval, Poly, Variable, integer, parse_decimal};

use super::expression::shortened;
use super::fault::Fault;
use super::finding::{Evidence, Finding};
use super::scope::Scope;
use super::value::Value;
use super::{roots, witness};
use crate::language::Span;
use crate::language::ast::{Expr, ExprKind, Verdict};

/// Whether `value` is positive (or, if not `strict`, not negative) for all values of the parameters in their domains.
pub(super) fn inequality(
    scope: &Scope,
    value: &Fraction,
    strict: bool,
    span: Span,
) -> Result<Finding, Fault> {
    sign(scope, value, strict, false, span)
}

/// The same, told of `-value` if `minus`: what is found of a < b is told of a − b, as what is found of a > b is.
pub(super) fn sign(
    scope: &Scope,
    value: &Fraction,
    strict: bool,
    minus: bool,
    span: Span,
) -> Result<Finding, Fault> {
    let [positive, negative] = if minus { ["negative", "positive"] } else { ["positive", "negative"] };
    let value = value.lowest_terms();
    if let Some(number) = value.to_number() {
        let sign = number.sign();
        let holds = sign.is_gt() || (!strict && sign.is_eq());
        return Ok(Finding::new(
            holds,
            format!(
                "the difference to zero is {}",
                shortened(&if minus { -&number } else { number }.to_string())
            ),
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
    let Some(box_sign) = signed.sign_on(&domain) else {
        return Ok(Finding::undecided("the sign cannot be determined").about([&value]));
    };
    let corner = || Some(witness::corner(&domain));
    let (finding, at) = match &box_sign {
        BoxSign::Positive => (Finding::new(true, format!("{positive} on the whole domain")), None),
        BoxSign::Negative => (Finding::new(false, format!("{negative} on the whole domain")), corner()),
        BoxSign::Zero => (Finding::new(!strict, "zero everywhere"), corner()),
        BoxSign::NonNegative { zeros } if !strict => {
            (Finding::new(true, format!("not {negative}; zeros: {zeros}")), None)
        }
        BoxSign::NonNegative { zeros } if zeros.is_empty() => {
            (Finding::new(true, format!("{positive} on the whole domain")), None)
        }
        BoxSign::NonNegative { zeros } if zeros.is_complete() => {
            let finding = Finding::new(false, format!("not {negative}, with zeros: {zeros}"));
            (finding, zeros.witness(&domain))
        }
        BoxSign::NonPositive { zeros } => {
            let finding = Finding::new(false, format!("not {positive}; zeros: {zeros}"));
            (finding, witness::negative(&signed, &domain))
        }
        BoxSign::ChangesSign { negative, .. } => {
            (Finding::new(false, "of both signs on the domain"), Some(negative.clone()))
        }
        BoxSign::Undecided { zero: Some(zero), .. } if strict => {
            (Finding::new(false, "it vanishes on the domain"), Some(zero.clone()))
        }
        _ => (Finding::undecided("subdivision reached its limit before the sign was decided"), None),
    };
    let finding = finding.with_witness(at.as_ref().map(witness::point)).about([&value]);
    Ok(finding.with_evidence(Evidence::Sign {
        function: value,
        polynomial: signed,
        domain,
        sign: box_sign,
        at,
    }))
}

/// What is undecided of a sum of a rational function and a root.
pub(super) const TWO_PARTS: &str =
    "the rational part and the square root may cancel on the domain, so the sign is not decided";

/// A rational function of the same sign as a scalar `a + b·√q` on the domain: `a` where `a² − b²q` is positive, `b·q` where it is
/// negative or a is zero. `None` where neither is certain.
pub(super) fn signed(
    scope: &Scope,
    expr: &Expr,
    value: &Value,
    role: &str,
) -> Result<Option<Fraction>, Fault> {
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

/// Whether a value agrees with a printed decimal: their difference is at most half a unit of the last digit.
pub(super) fn approx(scope: &Scope, value: &Expr, digits: &Expr) -> Result<Finding, Fault> {
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
    let unit = Poly::constant(unit);
    let holds = size.scale(&integer(2)).compare(&unit).is_le();
    let shown = u32::try_from(places.max(0)).unwrap_or(0) + 6;
    let exact = shortened(&number.to_string());
    let derived = format!("{} ({exact})", number.to_decimal(shown));
    Ok(Finding::new(holds, derived).with_evidence(Evidence::Decimal { number, stated, unit, places: shown }))
}
