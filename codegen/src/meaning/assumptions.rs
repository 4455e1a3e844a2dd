//! What a claim assumes of the symbols, as `when` states it, and values that satisfy it.

use std::cell::OnceCell;
use std::cmp::Ordering;
use std::collections::BTreeMap;

use hodograph_algebra::{Fraction, Point, Poly, Rational, Variable, integer, ratio};

use super::fault::Fault;
use super::scope::Scope;
use crate::language::ast::{Expr, ExprKind, RelationOperator};

/// How many values that satisfy the inequalities are collected.
const MOST_SAMPLES: usize = 24;

/// How many values are tried for them.
const MOST_TRIALS: usize = 4000;

/// What a claim assumes.
pub(super) struct Assumptions {
    /// The scope, with the values that equations give to symbols.
    pub scope: Scope,
    inequalities: Vec<Inequality>,
    samples: OnceCell<Samples>,
}

/// An inequality: which signs a function of the symbols may have.
#[derive(Clone)]
struct Inequality {
    function: Fraction,
    operator: RelationOperator,
    negated: bool,
}

/// Values of the symbols in inequalities that satisfy them.
pub(super) struct Samples {
    /// The values; none if no such values were found.
    pub points: Vec<Point>,
    /// Whether what is near the points satisfies the inequalities too.
    pub inner: bool,
}

impl Assumptions {
    /// The assumptions that a claim states: `when c0 == 1` sets a symbol, `when c0 != 0` restricts its values. Equations come
    /// first, so that the inequalities are about the symbols that remain.
    pub(super) fn of(scope: &Scope, conditions: &[Expr]) -> Result<Assumptions, Fault> {
        let mut scope = scope.clone();
        let mut inequalities = Vec::new();
        let relations = conditions.iter().map(|condition| Ok((condition, relation(condition)?)));
        let relations = relations.collect::<Result<Vec<_>, Fault>>()?;
        let (equations, others): (Vec<_>, Vec<_>) =
            relations.into_iter().partition(|(_, relation)| relation.is_equation());
        for (condition, relation) in equations.into_iter().chain(others) {
            let function = difference(&scope, condition, &relation)?;
            let inequality = Inequality { function, operator: relation.operator, negated: relation.negated };
            if let Some(number) = inequality.function.to_number() {
                if !inequality.allows(number.sign()) {
                    return Err(wrong(condition, "this condition never holds"));
                }
            } else if relation.is_equation() {
                let (symbol, value) = solved(&inequality.function).ok_or_else(|| {
                    let message = "this equation cannot be solved for a symbol: none stands in it linearly, times a number";
                    wrong(condition, message)
                })?;
                scope = scope.with_symbol(&symbol, &value, condition.span())?;
            } else {
                inequalities.push(inequality);
            }
        }
        Ok(Assumptions { scope, inequalities, samples: OnceCell::new() })
    }

    /// The same assumptions in the scope of another piece.
    pub(super) fn with_scope(&self, scope: Scope) -> Assumptions {
        Assumptions { scope, inequalities: self.inequalities.clone(), samples: OnceCell::new() }
    }

    /// No assumptions.
    pub(super) fn none(scope: &Scope) -> Assumptions {
        Assumptions { scope: scope.clone(), inequalities: Vec::new(), samples: OnceCell::new() }
    }

    /// The polynomials of which the inequalities say that they do not vanish.
    pub(super) fn nonzero(&self) -> Vec<Poly> {
        let excluding = self.inequalities.iter().filter(|inequality| !inequality.allows(Ordering::Equal));
        excluding.map(|inequality| inequality.function.numerator().clone()).collect()
    }

    /// Whether one of the inequalities says that a polynomial is not negative.
    pub(super) fn state_nonnegative(&self, poly: &Poly) -> bool {
        let function = Fraction::from(poly.clone());
        let opposite = -&function;
        self.inequalities.iter().any(|inequality| {
            (inequality.function == function && !inequality.allows(Ordering::Less))
                || (inequality.function == opposite && !inequality.allows(Ordering::Greater))
        })
    }

    /// The same with one more: that a polynomial in symbols is not negative.
    pub(super) fn with_nonnegative(&self, poly: &Poly) -> Assumptions {
        let function = Fraction::from(poly.clone());
        let more = Inequality { function, operator: RelationOperator::GreaterEqual, negated: false };
        let inequalities = self.inequalities.iter().cloned().chain([more]).collect();
        Assumptions { scope: self.scope.clone(), inequalities, samples: OnceCell::new() }
    }

    /// Some values that satisfy the inequalities; one point without coordinates if there are no inequalities.
    pub(super) fn samples(&self) -> &Samples {
        self.samples.get_or_init(|| {
            let functions = self.inequalities.iter();
            let mut symbols: Vec<Variable> =
                functions.flat_map(|inequality| inequality.function.occurring_variables()).collect();
            symbols.sort();
            symbols.dedup();
            for inner in [true, false] {
                let mut search =
                    Search { inequalities: &self.inequalities, inner, found: Vec::new(), trials: 0 };
                search.extend(&symbols, &mut Point::new());
                if !search.found.is_empty() {
                    return Samples { points: search.found, inner };
                }
            }
            Samples { points: Vec::new(), inner: false }
        })
    }
}

impl Inequality {
    fn allows(&self, sign: Ordering) -> bool {
        let holds = match self.operator {
            RelationOperator::Equal => sign.is_eq(),
            RelationOperator::NotEqual => sign.is_ne(),
            RelationOperator::Less => sign.is_lt(),
            RelationOperator::LessEqual => sign.is_le(),
            RelationOperator::Greater => sign.is_gt(),
            RelationOperator::GreaterEqual => sign.is_ge(),
        };
        holds != self.negated
    }
}

/// A search for values that satisfy inequalities, symbol by symbol.
struct Search<'a> {
    inequalities: &'a [Inequality],
    /// Whether all inequalities must hold strictly.
    inner: bool,
    found: Vec<Point>,
    trials: usize,
}

impl Search<'_> {
    /// Adds the points that give values to `symbols` besides those in `at`.
    fn extend(&mut self, symbols: &[Variable], at: &mut Point) {
        let Some((symbol, rest)) = symbols.split_first() else {
            self.found.push(at.clone());
            return;
        };
        // What becomes a function of this symbol alone, or a number.
        let decided: Vec<(Fraction, &Inequality)> = self
            .inequalities
            .iter()
            .filter(|inequality| !inequality.function.occurring_variables().iter().any(|v| rest.contains(v)))
            .filter_map(|inequality| Some((at_point(&inequality.function, at)?, inequality)))
            .collect();
        for value in candidates(symbol, decided.iter().map(|(function, _)| function)) {
            if self.found.len() >= MOST_SAMPLES || self.trials >= MOST_TRIALS {
                return;
            }
            self.trials += 1;
            let here = Point::from([(symbol.clone(), value.clone())]);
            let holds = decided.iter().all(|(function, inequality)| {
                let number = at_point(function, &here).and_then(|value| value.to_number());
                number.is_some_and(|number| {
                    inequality.allows(number.sign()) && !(self.inner && number.is_zero())
                })
            });
            if holds {
                at.insert(symbol.clone(), value);
                self.extend(rest, at);
                at.remove(symbol);
            }
        }
    }
}

fn at_point(function: &Fraction, at: &Point) -> Option<Fraction> {
    let values: BTreeMap<Variable, Fraction> =
        at.iter().map(|(variable, value)| (variable.clone(), value.clone().into())).collect();
    function.substitute(&values)
}

/// Numbers among which each interval between zeros and poles of functions of one symbol has some, and the rational zeros
/// themselves: simple ones first.
fn candidates<'a>(symbol: &Variable, functions: impl Iterator<Item = &'a Fraction>) -> Vec<Poly> {
    let simple = [(1, 1), (-1, 1), (2, 1), (-2, 1), (1, 2), (-1, 2), (3, 1), (-3, 1), (0, 1)];
    let mut numbers: Vec<Poly> = simple.iter().map(|&(n, d)| Poly::constant(ratio(n, d))).collect();
    let polys = functions.flat_map(|function| {
        std::iter::once(function.numerator().clone())
            .chain(function.factors().iter().map(|(factor, _)| factor.clone()))
    });
    let mut bounds: Vec<Rational> = Vec::new();
    for root in polys.filter_map(|poly| poly.real_roots(symbol)).flatten() {
        let enclosure = root.enclosure(16);
        bounds.extend([enclosure.lower().clone(), enclosure.upper().clone()]);
        numbers.extend(root.exact().cloned());
    }
    bounds.sort();
    bounds.dedup();
    if let (Some(first), Some(last)) = (bounds.first(), bounds.last()) {
        for n in 1..=4 {
            numbers.push(Poly::constant(last + integer(n)));
            numbers.push(Poly::constant(first - integer(n)));
        }
    }
    for (n, pair) in bounds.windows(2).flat_map(|pair| (1..=4).map(move |n| (n, pair))) {
        numbers.push(Poly::constant(&pair[0] + (&pair[1] - &pair[0]) * ratio(n, 5)));
    }
    numbers
}

/// A condition as its relation, and whether that is negated.
struct Relation<'a> {
    left: &'a Expr,
    operator: RelationOperator,
    right: &'a Expr,
    negated: bool,
}

impl Relation<'_> {
    fn is_equation(&self) -> bool {
        let equality = if self.negated { RelationOperator::NotEqual } else { RelationOperator::Equal };
        self.operator == equality
    }
}

fn wrong(condition: &Expr, message: &str) -> Fault {
    Fault::new(condition.span(), message).help("write `when c0 == 1`, `when c0 != 0` or `when c0 > 0`")
}

fn relation(condition: &Expr) -> Result<Relation<'_>, Fault> {
    let (inner, negated) = match condition.kind() {
        ExprKind::Not(inner) => (inner.as_ref(), true),
        _ => (condition, false),
    };
    match inner.kind() {
        ExprKind::Relation { left, operator, right } => {
            Ok(Relation { left, operator: *operator, right, negated })
        }
        _ => Err(wrong(condition, "a condition is an equation or an inequality of symbols")),
    }
}

/// Left side minus right side: a function of symbols.
fn difference(scope: &Scope, condition: &Expr, relation: &Relation<'_>) -> Result<Fraction, Fault> {
    let side = |expr: &Expr| scope.scalar(expr, "a side of a condition");
    let difference = (&side(relation.left)? - &side(relation.right)?).lowest_terms();
    let variables = difference.occurring_variables();
    if variables.iter().any(|variable| variable.name() == "pi") {
        return Err(Fault::pi(condition.span()));
    }
    if variables
        .iter()
        .any(|variable| scope.parameters.contains(variable) || scope.calculus.is_function(variable))
    {
        return Err(wrong(condition, "a condition is about symbols, which do not depend on parameters"));
    }
    Ok(difference)
}

/// A symbol in which an equation `f = 0` is linear, with a number as its coefficient, and its value. The last one is taken,
/// so that `c1 == 2*c0` sets c1.
fn solved(equation: &Fraction) -> Option<(Variable, Fraction)> {
    let numerator = equation.numerator();
    let linear = |symbol: &Variable| {
        numerator.degree(symbol) == Some(1) && numerator.coefficients(symbol)[1].is_constant()
    };
    let symbol = numerator.occurring_variables().into_iter().rev().find(linear)?;
    let coefficients = numerator.coefficients(&symbol);
    let value = -(&coefficients[0] * coefficients[1].inverse());
    Some((symbol, value.into()))
}
