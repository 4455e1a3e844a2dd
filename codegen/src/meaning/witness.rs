//! Points at which a claim fails.

use std::collections::BTreeMap;

use hodograph_algebra::{Fraction, Interval, Point, Poly, QuadraticFraction, Rational, Variable, ratio};

use super::assumptions::Assumptions;

/// How many points are tried; a nonzero rational function vanishes or has poles at few of them.
const MOST_TRIALS: i64 = 64;

/// A rational point at which the components of `a` and `b` differ, with both values.
pub(super) fn unequal(assumptions: &Assumptions, a: &[Fraction], b: &[Fraction]) -> Option<String> {
    find(assumptions, a, b, |a, b| a != b)
}

/// The same for components with square roots.
pub(super) fn unequal_roots(
    assumptions: &Assumptions,
    a: &[QuadraticFraction],
    b: &[QuadraticFraction],
) -> Option<String> {
    let variables = a.iter().chain(b).flat_map(QuadraticFraction::occurring_variables).collect();
    let evaluate = |side: &[QuadraticFraction], values: &BTreeMap<Variable, Fraction>| -> Option<Vec<Poly>> {
        side.iter().map(|f| f.substitute(values)?.to_rational_function()?.to_number()).collect()
    };
    let sides = |values: &BTreeMap<Variable, Fraction>| Some((evaluate(a, values)?, evaluate(b, values)?));
    search(assumptions, variables, a.len(), &sides, |a, b| a != b)
}

/// A rational point at which `p ≠ q`, which are a minor's products for `a` and `b`; the values shown are those of `a` and
/// `b`.
pub(super) fn not_parallel(
    assumptions: &Assumptions,
    p: &[Fraction],
    q: &[Fraction],
    a: &[Fraction],
    b: &[Fraction],
) -> Option<String> {
    let joined = |x: &[Fraction], y: &[Fraction]| x.iter().chain(y).cloned().collect::<Vec<_>>();
    let (left, right) = (joined(a, p), joined(b, q));
    let split = a.len();
    find_shown(assumptions, &left, &right, split, |a, b| a[split..] != b[split..])
}

/// A point of the domain where all variables are at the beginning of their intervals.
pub(super) fn corner(domain: &[(Variable, Interval)]) -> Point {
    domain.iter().map(|(variable, interval)| (variable.clone(), interval.lower().clone())).collect()
}

/// A point of the domain where the polynomial is negative, among a few rational ones.
pub(super) fn negative(poly: &Poly, domain: &[(Variable, Interval)]) -> Option<Point> {
    (1..MOST_TRIALS).find_map(|trial| {
        let place = |(index, (variable, interval)): (i64, &(Variable, Interval))| {
            (variable.clone(), interval.point(&fraction_of(trial, index)))
        };
        let at: Point = (0_i64..).zip(domain).map(place).collect();
        poly.evaluate(&at).sign().is_lt().then_some(at)
    })
}

/// A point as text: `u = 1/2, v = 0`.
pub(super) fn point(point: &Point) -> String {
    let equations: Vec<String> =
        point.iter().map(|(variable, value)| format!("{variable} = {value}")).collect();
    equations.join(", ")
}

fn find(
    assumptions: &Assumptions,
    a: &[Fraction],
    b: &[Fraction],
    differ: impl Fn(&[Poly], &[Poly]) -> bool,
) -> Option<String> {
    find_shown(assumptions, a, b, a.len(), differ)
}

fn find_shown(
    assumptions: &Assumptions,
    a: &[Fraction],
    b: &[Fraction],
    shown: usize,
    differ: impl Fn(&[Poly], &[Poly]) -> bool,
) -> Option<String> {
    let variables = a.iter().chain(b).flat_map(Fraction::occurring_variables).collect();
    let evaluate = |side: &[Fraction], values: &BTreeMap<Variable, Fraction>| -> Option<Vec<Poly>> {
        side.iter().map(|f| f.substitute(values).and_then(|value| value.to_number())).collect()
    };
    let sides = |values: &BTreeMap<Variable, Fraction>| Some((evaluate(a, values)?, evaluate(b, values)?));
    search(assumptions, variables, shown, &sides, differ)
}

/// Both sides at a point.
type Sides<'a> = dyn Fn(&BTreeMap<Variable, Fraction>) -> Option<(Vec<Poly>, Vec<Poly>)> + 'a;

/// A point at which both sides, which depend on `variables`, differ; so many of their components are shown.
fn search(
    assumptions: &Assumptions,
    mut variables: Vec<Variable>,
    shown: usize,
    sides: &Sides<'_>,
    differ: impl Fn(&[Poly], &[Poly]) -> bool,
) -> Option<String> {
    variables.sort();
    variables.dedup();
    // The values of symbols must be such as the claim assumes.
    let samples = assumptions.samples().points.iter().cycle();
    for (trial, sample) in (0..MOST_TRIALS).zip(samples) {
        let mut at = sample.clone();
        at.retain(|symbol, _| variables.contains(symbol));
        for (index, variable) in (0_i64..).zip(&variables) {
            if at.contains_key(variable) {
                continue;
            }
            let value = match assumptions.scope.domains.get(variable) {
                Some(interval) => interval.point(&fraction_of(trial, index)),
                None => Poly::constant(ratio(1 + index + trial * (index + 2), 1 + trial)),
            };
            at.insert(variable.clone(), value);
        }
        let values: BTreeMap<Variable, Fraction> =
            at.iter().map(|(variable, value)| (variable.clone(), value.clone().into())).collect();
        let Some((left, right)) = sides(&values) else { continue };
        if differ(&left, &right) {
            let print = |side: &[Poly]| {
                let parts: Vec<String> = side.iter().take(shown).map(Poly::to_string).collect();
                if let [one] = parts.as_slice() { one.clone() } else { format!("({})", parts.join(", ")) }
            };
            let sides = format!("left {}, right {}", print(&left), print(&right));
            return Some(if at.is_empty() { sides } else { format!("{}: {sides}", point(&at)) });
        }
    }
    None
}

/// Distinct rationals in the unit interval: both ends first, then points inside.
fn fraction_of(trial: i64, index: i64) -> Rational {
    match trial {
        0 => ratio(1, 2 + index),
        1 => ratio(index % 2, 1),
        2 => ratio((index + 1) % 2, 1),
        _ => ratio(1 + (trial * (index + 1)) % (trial + 3), trial + 4),
    }
}
