//! Expressions to text: the statement of a claim and the formula of a surface, the same from every source.

use std::fmt;

use super::ast::{
    Argument, Clause, ClauseKind, CurveRole, Definition, Expr, ExprKind, Function, Interval, Name,
    Preference, ProductOperator, RelationOperator, SumOperator,
};

/// How tightly an expression holds together, loosest first; each level of the grammar is one.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Level {
    Relation,
    Sum,
    Product,
    Negative,
    Power,
    Postfix,
}

impl fmt::Display for Expr {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write(self, Level::Relation, f)
    }
}

/// Writes the expression where the grammar asks for this level or a tighter one.
fn write(expr: &Expr, asked: Level, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    if level(expr) < asked {
        f.write_str("(")?;
        write_bare(expr, f)?;
        f.write_str(")")
    } else {
        write_bare(expr, f)
    }
}

fn level(expr: &Expr) -> Level {
    match expr.kind() {
        ExprKind::Relation { .. } | ExprKind::Not(_) => Level::Relation,
        ExprKind::Sum { .. } => Level::Sum,
        ExprKind::Product { .. } => Level::Product,
        ExprKind::Negative(_) => Level::Negative,
        ExprKind::Power { .. } => Level::Power,
        _ => Level::Postfix,
    }
}

fn write_bare(expr: &Expr, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    match expr.kind() {
        ExprKind::Number(text) | ExprKind::Ident(text) => f.write_str(text),
        ExprKind::Str(text) => write!(f, "{text:?}"),
        ExprKind::Tuple(parts) => write_list("(", parts, ")", f),
        ExprKind::Array(parts) => write_list("[", parts, "]", f),
        ExprKind::Call { callee, arguments } => {
            write_object(callee, f)?;
            write_arguments(arguments, f)
        }
        ExprKind::Member { object, member } => {
            write_object(object, f)?;
            write!(f, ".{}", member.value)
        }
        ExprKind::Negative(operand) => {
            f.write_str("-")?;
            write(operand, Level::Negative, f)
        }
        ExprKind::Not(operand) => {
            f.write_str("not ")?;
            write(operand, Level::Relation, f)
        }
        ExprKind::Sum { first, rest } => {
            write(first, Level::Product, f)?;
            for (operator, operand) in rest {
                write!(f, " {operator} ")?;
                write(operand, Level::Product, f)?;
            }
            Ok(())
        }
        ExprKind::Product { first, rest } => {
            write(first, Level::Negative, f)?;
            for (operator, operand) in rest {
                write!(f, "{operator}")?;
                write(operand, Level::Negative, f)?;
            }
            Ok(())
        }
        ExprKind::Power { base, exponent } => {
            write(base, Level::Postfix, f)?;
            f.write_str("^")?;
            write(exponent, Level::Negative, f)
        }
        ExprKind::Relation { left, operator, right } => {
            write(left, Level::Sum, f)?;
            write!(f, " {operator} ")?;
            write(right, Level::Sum, f)
        }
    }
}

/// Writes what is called or asked for a member; after a number `.` and `(` would read differently.
fn write_object(object: &Expr, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    match object.kind() {
        ExprKind::Number(text) => write!(f, "({text})"),
        _ => write(object, Level::Postfix, f),
    }
}

fn write_arguments(arguments: &[Argument], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    f.write_str("(")?;
    for (index, argument) in arguments.iter().enumerate() {
        f.write_str(if index == 0 { "" } else { ", " })?;
        if let Some(name) = &argument.name {
            f.write_str(&name.value)?;
            f.write_str(" = ")?;
        }
        write(&argument.value, Level::Relation, f)?;
    }
    f.write_str(")")
}

fn write_list(open: &str, parts: &[Expr], close: &str, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    f.write_str(open)?;
    for (index, part) in parts.iter().enumerate() {
        f.write_str(if index == 0 { "" } else { ", " })?;
        write(part, Level::Relation, f)?;
    }
    f.write_str(close)
}

impl fmt::Display for Clause {
    /// The clause on one line, without its documentation.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names =
            |names: &[Name]| names.iter().map(|name| name.value.as_str()).collect::<Vec<_>>().join(", ");
        let definition = |f: &mut fmt::Formatter<'_>, keyword: &str, definition: &Definition| {
            write!(f, "{keyword} {}", definition.name.value)?;
            if !definition.parameters.is_empty() {
                write!(f, "({})", names(&definition.parameters))?;
            }
            write!(f, " = {};", definition.value)
        };
        match &self.kind {
            ClauseKind::Source(text) => write!(f, "source {:?};", text.value),
            ClauseKind::Symbol(symbols) => write!(f, "symbol {};", names(symbols)),
            ClauseKind::Function(functions) => {
                let one =
                    |function: &Function| format!("{}({})", function.name.value, function.parameter.value);
                write!(f, "function {};", functions.iter().map(one).collect::<Vec<_>>().join(", "))
            }
            ClauseKind::Let(value) => definition(f, "let", value),
            ClauseKind::Substitute(value) => definition(f, "substitute", value),
            ClauseKind::Curve(curve) => {
                let keyword = match curve.role {
                    CurveRole::Profile => "profile",
                    CurveRole::Path => "path",
                    CurveRole::Curve => "curve",
                    CurveRole::Frames => "frames",
                };
                write!(f, "{keyword} {}({}) = {};", curve.name.value, curve.parameter.value, curve.value)
            }
            ClauseKind::Surface(surface) => {
                write!(f, "surface {}", surface.name.value)?;
                if let Some([first, second]) = &surface.parameters {
                    write!(f, "({}, {})", first.value, second.value)?;
                }
                write!(f, " = {};", surface.value)
            }
            ClauseKind::Domain(intervals) => {
                let one = |i: &Interval| format!("{} in {}..{}", i.parameter.value, i.start, i.end);
                write!(f, "domain {};", intervals.iter().map(one).collect::<Vec<_>>().join(", "))
            }
            ClauseKind::Prefer(preference) => write!(f, "prefer {};", preference.value),
            ClauseKind::Claim(claim) => write!(f, "claim {:?}: {};", claim.id.value, claim.relation),
        }
    }
}

impl fmt::Display for Preference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Preference::Fast => "fast",
            Preference::Accurate => "accurate",
        })
    }
}

impl fmt::Display for SumOperator {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            SumOperator::Plus => "+",
            SumOperator::Minus => "-",
        })
    }
}

impl fmt::Display for ProductOperator {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            ProductOperator::Times => "*",
            ProductOperator::Over => "/",
        })
    }
}

impl fmt::Display for RelationOperator {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            RelationOperator::Equal => "==",
            RelationOperator::NotEqual => "!=",
            RelationOperator::Less => "<",
            RelationOperator::LessEqual => "<=",
            RelationOperator::Greater => ">",
            RelationOperator::GreaterEqual => ">=",
        })
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::ast::{Name, Spanned};
    use super::super::token::{Span, SpanId};
    use super::super::{parse_expression, parse_macro_expression};
    use super::*;

    const NOWHERE: Span = Span { first: SpanId(0), last: SpanId(0) };

    fn name() -> impl Strategy<Value = String> {
        prop_oneof!["[a-z]", "[A-Za-z_][a-z0-9_]{1,3}"]
            .prop_filter("keywords", |name| !matches!(&**name, "not" | "_"))
    }

    fn spanned(value: String) -> Name {
        Spanned { value, span: NOWHERE }
    }

    fn new(kind: ExprKind) -> Expr {
        Expr::new(kind, NOWHERE)
    }

    fn expr() -> impl Strategy<Value = Expr> {
        let leaf = prop_oneof![
            "[0-9]{1,3}(\\.[0-9]{1,2})?(e-?[0-9])?".prop_map(|text| new(ExprKind::Number(text))),
            name().prop_map(|text| new(ExprKind::Ident(text))),
            "[ -~é\n\t]{0,4}".prop_map(|text| new(ExprKind::Str(text))),
        ];
        leaf.prop_recursive(6, 60, 4, |inner| {
            let boxed = || inner.clone().prop_map(Box::new);
            let list = |least: usize| prop::collection::vec(inner.clone(), least..4);
            let argument = |index: usize, (is_named, value): (bool, Expr)| Argument {
                name: is_named.then(|| spanned(format!("n{index}"))),
                value,
            };
            prop_oneof![
                list(2).prop_map(|parts| new(ExprKind::Tuple(parts))),
                list(0).prop_map(|parts| new(ExprKind::Array(parts))),
                (boxed(), prop::collection::vec((any::<bool>(), inner.clone()), 0..4)).prop_map(
                    move |(callee, mut values)| {
                        values.sort_by_key(|(is_named, _)| *is_named);
                        let arguments = values.into_iter().enumerate().map(|(at, value)| argument(at, value));
                        new(ExprKind::Call { callee, arguments: arguments.collect() })
                    }
                ),
                (boxed(), name())
                    .prop_map(|(object, member)| new(ExprKind::Member { object, member: spanned(member) })),
                boxed().prop_map(|operand| new(ExprKind::Negative(operand))),
                boxed().prop_map(|operand| new(ExprKind::Not(operand))),
                (
                    boxed(),
                    prop::collection::vec(
                        (prop_oneof![Just(SumOperator::Plus), Just(SumOperator::Minus)], inner.clone()),
                        1..4
                    )
                )
                    .prop_map(|(first, rest)| new(ExprKind::Sum { first, rest })),
                (
                    boxed(),
                    prop::collection::vec(
                        (
                            prop_oneof![Just(ProductOperator::Times), Just(ProductOperator::Over)],
                            inner.clone()
                        ),
                        1..4
                    )
                )
                    .prop_map(|(first, rest)| new(ExprKind::Product { first, rest })),
                (boxed(), boxed()).prop_map(|(base, exponent)| new(ExprKind::Power { base, exponent })),
                (
                    boxed(),
                    prop_oneof![
                        Just(RelationOperator::Equal),
                        Just(RelationOperator::NotEqual),
                        Just(RelationOperator::Less),
                        Just(RelationOperator::LessEqual),
                        Just(RelationOperator::Greater),
                        Just(RelationOperator::GreaterEqual),
                    ],
                    boxed()
                )
                    .prop_map(|(left, operator, right)| new(ExprKind::Relation {
                        left,
                        operator,
                        right
                    })),
            ]
        })
    }

    proptest! {
        #[test]
        fn what_is_written_is_read_back(expr in expr()) {
            let text = expr.to_string();
            let (read, _) = parse_expression("test", &text).map_err(|wrong| TestCaseError::fail(wrong.to_string()))?;
            prop_assert_eq!(&read, &expr);
            let stream = text.parse().map_err(|_| TestCaseError::fail("Rust cannot read it"))?;
            let (adapted, _) = parse_macro_expression(stream).map_err(|wrong| TestCaseError::fail(wrong.to_string()))?;
            prop_assert_eq!(adapted, expr);
        }
    }

    #[test]
    fn only_necessary_parentheses_are_written() {
        for (text, written) in [
            ("((s)) + (p.x) * (s.normal) + p . z * k", "s + p.x*s.normal + p.z*k"),
            ("(1-u^2)/(1+u^2)*i", "(1 - u^2)/(1 + u^2)*i"),
            ("a-(b-c)", "a - (b - c)"),
            ("(a-b)-c", "(a - b) - c"),
            ("a/(b*c)", "a/(b*c)"),
            ("-(u^2)", "-u^2"),
            ("(-u)^2", "(-u)^2"),
            ("2^(-3)", "2^-3"),
            ("(a^b)^c", "(a^b)^c"),
            ("a^(b^c)", "a^b^c"),
            ("a - -b*(-c)", "a - -b*-c"),
            ("not (degree(W, Z)==(2,4))", "not degree(W, Z) == (2, 4)"),
            ("ph([1, I,], factor=1_0.5)", "ph([1, I], factor = 10.5)"),
            ("(a + b).x(1)(2)", "(a + b).x(1)(2)"),
            ("\"a\\u{22}\\n\"", "\"a\\\"\\n\""),
        ] {
            let (expr, _) = parse_expression("test", text).unwrap_or_else(|wrong| panic!("{wrong}"));
            assert_eq!(expr.to_string(), written);
        }
    }
}
