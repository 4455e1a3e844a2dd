//! Expressions to values.

use std::cell::Cell;

use hodograph_algebra::{Fraction, Poly, Rational, budget, integer, parse_decimal};

use super::fault::Fault;
use super::scope::Scope;
use super::value::{ComplexFraction, Value};
use super::{calls, members, roots};
use crate::language::Span;
use crate::language::ast::{Expr, ExprKind, ProductOperator, SumOperator};

/// The largest exponent, up or down, that an expression may raise to.
pub const MAX_EXPONENT: i64 = 1000;

/// How many levels of an expression are evaluated: in debug builds each takes some twenty kilobytes of the stack, of which
/// a thread may have two megabytes.
const MAX_LEVELS: usize = 64;

thread_local! {
    /// The levels under way.
    static LEVELS: Cell<usize> = const { Cell::new(0) };
    /// The innermost expression whose value is under way, or was when a budget was exhausted.
    static PLACE: Cell<Option<Span>> = const { Cell::new(None) };
}

/// The innermost expression whose value was being computed when a budget was exhausted last; asking forgets it.
pub(super) fn place_of_exhaustion() -> Option<Span> {
    PLACE.take()
}

impl Scope {
    /// The value of an expression.
    pub(super) fn evaluate(&self, expr: &Expr) -> Result<Value, Fault> {
        budget::spend(1);
        let Some(_level) = Level::enter(expr.span()) else {
            let message = format!("this is nested more than {MAX_LEVELS} levels deep");
            return Err(Fault::new(expr.span(), message).help("name its parts with `let`"));
        };
        let span = expr.span();
        match expr.kind() {
            ExprKind::Number(text) => number(text, span),
            ExprKind::Ident(name) => self.value(name, span),
            ExprKind::Str(_) => Err(Fault::new(span, "a text has no value in a formula")),
            ExprKind::Tuple(parts) => Ok(Value::Tuple(each(parts, |part| self.scalar(part, "a component"))?)),
            ExprKind::Array(parts) => Ok(Value::List(each(parts, |part| self.evaluate(part))?)),
            ExprKind::Call { callee, arguments } => calls::call(self, span, callee, arguments),
            ExprKind::Member { object, member } => members::member(self, span, object, member),
            ExprKind::Negative(operand) => {
                let value = self.evaluate(operand)?;
                if roots::is_rooted(&value) {
                    let negative = roots::product(&scalar(integer(-1)), &value, span)?;
                    return negative.ok_or_else(|| no_sign(operand.span(), &value));
                }
                product(&scalar(integer(-1)), &value).ok_or_else(|| no_sign(operand.span(), &value))
            }
            ExprKind::Sum { first, rest } => self.sum(first, rest),
            ExprKind::Product { first, rest } => self.product(first, rest),
            ExprKind::Power { base, exponent } => self.power(base, exponent),
            ExprKind::Not(_) | ExprKind::Relation { .. } => {
                Err(Fault::new(span, "a relation has no value").help("relations stand in `claim` clauses"))
            }
        }
    }

    /// The value of an expression that must be rational: not the offset of a surface that has none.
    pub(super) fn rational_value(&self, expr: &Expr) -> Result<Value, Fault> {
        let value = self.evaluate(expr)?;
        check_rational(expr, &value)?;
        Ok(value)
    }

    /// The value of an expression that must be a scalar.
    pub(super) fn scalar(&self, expr: &Expr, role: &str) -> Result<Fraction, Fault> {
        let value = self.evaluate(expr)?;
        if roots::is_rooted(&value) {
            return roots::rational(&value, expr.span());
        }
        value.scalar().ok_or_else(|| {
            let message = format!("{role} must be a scalar, but this is {}", value.kind());
            let fault = Fault::new(expr.span(), message);
            match value.bare() {
                Value::Vector(_) | Value::Curve(_) => fault.help("take a component with `.x`, `.y` or `.z`"),
                Value::Complex(_) => fault.help("take `re(…)` or `im(…)`"),
                _ => fault,
            }
        })
    }

    /// The value of an expression that must be a real number.
    pub(super) fn number(&self, expr: &Expr, role: &str) -> Result<Poly, Fault> {
        let value = self.scalar(expr, role)?;
        value.to_number().ok_or_else(|| {
            Fault::new(expr.span(), format!("{role} must be a number, but this depends on {}", list(&value)))
        })
    }

    /// The value of an expression that must be a rational number.
    pub(super) fn rational(&self, expr: &Expr, role: &str) -> Result<Rational, Fault> {
        let number = self.number(expr, role)?;
        number
            .to_rational()
            .ok_or_else(|| Fault::new(expr.span(), format!("{role} must be a rational number")))
    }

    fn sum(&self, first: &Expr, rest: &[(SumOperator, Expr)]) -> Result<Value, Fault> {
        let mut values = self.operands(first, rest)?.into_iter();
        let mut sum = values.next().unwrap_or_else(|| scalar(integer(0)));
        for ((operator, operand), value) in rest.iter().zip(values) {
            if roots::concern(&sum, &value) {
                let negative = matches!(operator, SumOperator::Minus);
                let total = roots::sum(&sum, &value, negative, operand.span())?;
                sum = total.ok_or_else(|| cannot(operand.span(), "add", &sum, &value))?;
                continue;
            }
            let signed = match operator {
                SumOperator::Plus => Some(value.clone()),
                SumOperator::Minus => product(&scalar(integer(-1)), &value),
            };
            let total = signed.and_then(|signed| add(&sum, &signed));
            sum = total.ok_or_else(|| cannot(operand.span(), "add", &sum, &value))?;
        }
        Ok(sum)
    }

    fn product(&self, first: &Expr, rest: &[(ProductOperator, Expr)]) -> Result<Value, Fault> {
        let mut values = self.operands(first, rest)?.into_iter();
        let mut result = values.next().unwrap_or_else(|| scalar(integer(1)));
        for ((operator, operand), value) in rest.iter().zip(values) {
            if roots::concern(&result, &value) {
                let (total, verb) = match operator {
                    ProductOperator::Times => (roots::product(&result, &value, operand.span())?, "multiply"),
                    ProductOperator::Over => (roots::quotient(&result, &value, operand.span())?, "divide"),
                };
                result = total.ok_or_else(|| cannot(operand.span(), verb, &result, &value))?;
                continue;
            }
            result = match operator {
                ProductOperator::Times => product(&result, &value)
                    .ok_or_else(|| cannot(operand.span(), "multiply", &result, &value))?,
                ProductOperator::Over => quotient(&result, &value, operand.span())?,
            };
        }
        Ok(result)
    }

    /// The values of all operands of a sum or product; the mistakes in all of them are found.
    fn operands<O>(&self, first: &Expr, rest: &[(O, Expr)]) -> Result<Vec<Value>, Fault> {
        let operands: Vec<&Expr> =
            std::iter::once(first).chain(rest.iter().map(|(_, operand)| operand)).collect();
        each(&operands, |operand| self.evaluate(operand))
    }

    fn power(&self, base: &Expr, exponent: &Expr) -> Result<Value, Fault> {
        let power = self.rational(exponent, "an exponent")?;
        let small = power.is_integer().then(|| power.to_integer().small()).flatten();
        let Some(power) = small.filter(|power| power.abs() <= MAX_EXPONENT) else {
            let message = if power.is_integer() {
                format!(
                    "the exponent {} is beyond the limit of {MAX_EXPONENT}",
                    shortened(&power.to_string())
                )
            } else {
                format!("the exponent {power} is not an integer")
            };
            let fault = Fault::new(exponent.span(), message);
            return Err(if power.is_integer() {
                fault
            } else {
                fault.help("write `sqrt(…)` for a square root")
            });
        };
        let value = self.evaluate(base)?;
        let count = u32::try_from(power.unsigned_abs()).unwrap_or(u32::MAX);
        let raised = match value.bare() {
            Value::Scalar(scalar) => Value::Scalar(scalar.pow(count)),
            Value::Complex(complex) => {
                let mut result = ComplexFraction::from(Fraction::one());
                for _ in 0..count {
                    result = result.times(complex);
                }
                Value::Complex(result)
            }
            rooted if roots::is_rooted(rooted) => match roots::power(rooted, count, base.span())? {
                Some(raised) if power >= 0 => return Ok(raised),
                Some(raised) => {
                    let inverse = roots::quotient(&scalar(integer(1)), &raised, base.span())?;
                    return inverse.ok_or_else(|| cannot(base.span(), "divide", rooted, rooted));
                }
                None => {
                    return Err(Fault::new(
                        base.span(),
                        format!("{} cannot be raised to a power", rooted.kind()),
                    ));
                }
            },
            other => {
                let message = format!("{} cannot be raised to a power", other.kind());
                return Err(
                    Fault::new(base.span(), message).help("`norm2(a)` is the square of a vector's length")
                );
            }
        };
        if power >= 0 { Ok(raised) } else { quotient(&scalar(integer(1)), &raised, base.span()) }
    }
}

/// One level of an expression that is being evaluated.
struct Level {
    /// The expression that this one is a part of.
    outer: Option<Span>,
}

impl Level {
    /// One level deeper, into the expression at `place`; `None` at [`MAX_LEVELS`].
    fn enter(place: Span) -> Option<Level> {
        let level = LEVELS.get();
        (level < MAX_LEVELS).then(|| {
            LEVELS.set(level + 1);
            Level { outer: PLACE.replace(Some(place)) }
        })
    }
}

impl Drop for Level {
    fn drop(&mut self) {
        LEVELS.set(LEVELS.get() - 1);
        // A computation that is left by unwinding leaves its place behind.
        if !std::thread::panicking() {
            PLACE.set(self.outer);
        }
    }
}

fn number(text: &str, span: Span) -> Result<Value, Fault> {
    parse_decimal(text).map(scalar).ok_or_else(|| {
        let message = format!("the number {} is beyond the range", shortened(text));
        Fault::new(span, message)
            .help("numbers of up to 4096 digits, and decimals with as many places, are exact here")
    })
}

/// The mistake in a value that must be rational, if it is the offset of a surface that has none.
pub(super) fn check_rational(expr: &Expr, value: &Value) -> Result<(), Fault> {
    match value.bare() {
        Value::Offset(offset) => match offset.as_ref() {
            Err(error) => Err(Fault::offset(expr.span(), error)),
            Ok(_) => Ok(()),
        },
        _ => Ok(()),
    }
}

/// The results for all items, or the mistakes in all of them.
pub(super) fn each<I, T>(items: &[I], evaluate: impl Fn(&I) -> Result<T, Fault>) -> Result<Vec<T>, Fault> {
    let mut values = Vec::with_capacity(items.len());
    let mut faults: Option<Fault> = None;
    for item in items {
        match evaluate(item) {
            Ok(value) => values.push(value),
            Err(fault) => {
                faults = Some(match faults {
                    Some(first) => first.and(fault),
                    None => fault,
                });
            }
        }
    }
    faults.map_or(Ok(values), Err)
}

/// The number as a value.
pub(super) fn scalar(value: Rational) -> Value {
    Value::Scalar(value.into())
}

/// The sum, if both are of one kind.
pub(super) fn add(a: &Value, b: &Value) -> Option<Value> {
    if a.is_quaternion() || b.is_quaternion() {
        return Some(Value::Quaternion(&a.quaternion()? + &b.quaternion()?));
    }
    if let (Some(a), Some(b)) = (a.scalar(), b.scalar()) {
        return Some(Value::Scalar(&a + &b));
    }
    if let (Some(a), Some(b)) = (a.complex(), b.complex()) {
        return Some(Value::Complex(ComplexFraction { re: &a.re + &b.re, im: &a.im + &b.im }));
    }
    if let (Value::Tuple(a), Value::Tuple(b)) = (a.bare(), b.bare()) {
        let sums = a.iter().zip(b).map(|(a, b)| a + b).collect();
        return (a.len() == b.len()).then_some(Value::Tuple(sums));
    }
    Some(Value::Vector(&a.vector()? + &b.vector()?))
}

/// The product of two scalars, of two complex numbers, of a scalar and a vector, or with a quaternion.
pub(super) fn product(a: &Value, b: &Value) -> Option<Value> {
    if a.is_quaternion() || b.is_quaternion() {
        return Some(Value::Quaternion(&a.quaternion()? * &b.quaternion()?));
    }
    match (a.scalar(), b.scalar()) {
        (Some(a), Some(b)) => Some(Value::Scalar(&a * &b)),
        (Some(factor), None) | (None, Some(factor)) => {
            let other = if a.scalar().is_some() { b } else { a };
            if let Value::Tuple(parts) = other.bare() {
                return Some(Value::Tuple(parts.iter().map(|part| part * &factor).collect()));
            }
            match other.complex() {
                Some(other) => Some(Value::Complex(other.times(&factor.into()))),
                None => Some(Value::Vector(other.vector()?.scale(&factor))),
            }
        }
        (None, None) => Some(Value::Complex(a.complex()?.times(&b.complex()?))),
    }
}

fn quotient(a: &Value, b: &Value, span: Span) -> Result<Value, Fault> {
    let zero = || {
        Fault::new(span, "division by zero").help("this expression is zero for all values of its parameters")
    };
    let result = if let Some(divisor) = b.scalar() {
        let known: Option<Vec<Poly>> =
            a.scalar().map(|a| a.factors().iter().map(|(factor, _)| factor.clone()).collect());
        let inverse = divisor.reciprocal(&known.unwrap_or_default()).ok_or_else(zero)?;
        product(a, &Value::Scalar(inverse))
    } else if let Some(divisor) = b.complex() {
        product(a, &Value::Complex(divisor.reciprocal().ok_or_else(zero)?))
    } else {
        None
    };
    result.ok_or_else(|| cannot(span, "divide", a, b))
}

fn cannot(span: Span, verb: &str, a: &Value, b: &Value) -> Fault {
    let (a_kind, b_kind) = (a.kind(), b.kind());
    let (message, help) = match verb {
        "add" => (
            format!("{a_kind} and {b_kind} cannot be added"),
            "both sides of a sum must be scalars, or vectors",
        ),
        "divide" => (format!("{a_kind} cannot be divided by {b_kind}"), "a divisor must be a scalar"),
        _ => (
            format!("{a_kind} and {b_kind} cannot be multiplied with `*`"),
            "two vectors have the products `dot(a, b)` and `cross(a, b)`",
        ),
    };
    let is_vector =
        |value: &Value| matches!(value.bare(), Value::Vector(_) | Value::Curve(_) | Value::Tuple(_));
    let fault = Fault::new(span, message);
    if verb == "add" && is_vector(a) != is_vector(b) {
        return fault.help("a scalar becomes a vector by a unit vector: `z*k`");
    }
    fault.help(help)
}

fn no_sign(span: Span, value: &Value) -> Fault {
    Fault::new(span, format!("{} has no negative", value.kind()))
}

/// The names that a function depends on.
pub(super) fn list(value: &Fraction) -> String {
    let names: Vec<String> = value.occurring_variables().iter().map(|v| format!("`{v}`")).collect();
    names.join(", ")
}

/// A text, cut for a message.
pub(super) fn shortened(text: &str) -> String {
    if text.chars().count() <= 60 {
        return text.to_owned();
    }
    format!("{}…", text.chars().take(60).collect::<String>())
}
