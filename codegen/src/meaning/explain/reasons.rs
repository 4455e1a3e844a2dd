//! Why a relation holds or fails: the values that were compared, and what decides between them.

use std::collections::BTreeMap;

use hodograph_algebra::{
    Curve, Fraction, Point, Poly, QuadraticFraction, SquareSplit, SweptSurface, Variable, Vector, integer,
    parse_decimal, ratio,
};

use super::definitions::TOO_LONG;
use super::show::{Show, component_name};
use super::{Steps, frames, signs};
use crate::formula;
use crate::language::ast::{Claim, Expr, ExprKind, Verdict};
use crate::meaning::finding::{Evidence, Finding};
use crate::meaning::generic::{called, resolved};
use crate::meaning::judgement::Judged;
use crate::meaning::value::{DegreeValue, Value};
use crate::meaning::witness;
use crate::meaning::{functions, pieces, surfaces};

/// How many points are tried for a certificate of coprimality.
const MOST_POINTS: i64 = 40;

/// Adds the steps from the relation of a claim to its verdict.
pub(super) fn explain(show: &Show<'_>, steps: &mut Steps, claim: &Claim, judged: &Judged) {
    let mut relation = &claim.relation;
    let mut negations = 0_usize;
    while let ExprKind::Not(inner) = relation.kind() {
        (relation, negations) = (inner, negations + 1);
    }
    let mut added = Vec::new();
    let outcome = {
        let mut reasons = Reasons { show, steps: &mut added };
        steps.within(|| reasons.of(relation, &judged.finding))
    };
    for (what, formula, because) in added {
        steps.push(what, formula, because);
    }
    if outcome.is_err() {
        steps.push("value", relation.to_string(), TOO_LONG);
    }
    let inner = match judged.finding.verdict {
        Verdict::Proved => Verdict::Refuted,
        Verdict::Refuted => Verdict::Proved,
        Verdict::Undecided => return,
    };
    if negations % 2 == 1 {
        let because = format!("the relation under `not` is {inner}, so this is {}", judged.finding.verdict);
        steps.push("negation", claim.relation.to_string(), because);
    }
}

/// A step: what it is, its formula, and why.
pub(super) type Line = (&'static str, String, String);

/// Steps that are being derived from evidence.
pub(super) struct Reasons<'a, 'b> {
    pub(super) show: &'a Show<'b>,
    pub(super) steps: &'a mut Vec<Line>,
}

impl Reasons<'_, '_> {
    pub(super) fn push(
        &mut self,
        what: &'static str,
        formula: impl Into<String>,
        because: impl Into<String>,
    ) {
        self.steps.push((what, formula.into(), because.into()));
    }

    fn of(&mut self, relation: &Expr, Finding { evidence, derived, .. }: &Finding) {
        let sides: Vec<&Expr> = match relation.kind() {
            ExprKind::Relation { left, right, .. } => vec![left, right],
            ExprKind::Call { arguments, .. } => arguments.iter().map(|argument| &argument.value).collect(),
            _ => Vec::new(),
        };
        for side in &sides {
            if let Some(("continuity", [argument])) = called(side) {
                self.joints(&argument.value);
            }
        }
        match (evidence, sides.as_slice()) {
            (Evidence::Sides { left, right }, [a, b]) => self.difference([a, b], left, right),
            (Evidence::RootedSides { left, right }, [a, b]) => self.rooted([a, b], left, right),
            (Evidence::Directions { left, right }, [a, b]) => self.directions([a, b], left, right),
            (Evidence::Degrees { derived, stated }, [a, _]) => self.degrees(a, derived, stated),
            (Evidence::Sign { function, polynomial, domain, sign, at }, _) => {
                signs::explain(self, function, polynomial, domain, sign);
                if let Some(at) = at {
                    self.at_point(&sides, at);
                }
            }
            (Evidence::CommonFactor { polynomials, common }, _) => {
                self.common_factor(&sides, polynomials, common);
            }
            (Evidence::Decimal { number, stated, unit, places }, [a, b]) => {
                self.decimal(a, b, number, stated, unit, *places);
            }
            (Evidence::Rationality, [a]) if matches!(called(relation), Some(("is_pn", _))) => {
                if let Ok(surface) = surfaces::surface(self.show.scope(), a) {
                    self.normal(&surface);
                }
            }
            (Evidence::Rationality, [a]) => self.rationality(a),
            _ => self.push("value", derived, ""),
        }
    }

    /// A side of a relation with its value, as it is written.
    fn side(&mut self, what: &'static str, expr: &Expr, text: String) {
        let written = expr.to_string();
        let formula = if written == text { text } else { format!("{written} = {text}") };
        self.push(what, formula, "");
    }

    /// The sides of a relation at a point.
    fn at_point(&mut self, sides: &[&Expr], at: &Point) {
        let values: BTreeMap<Variable, Fraction> =
            at.iter().map(|(variable, value)| (variable.clone(), value.clone().into())).collect();
        for side in sides {
            let value = self.show.scope().scalar(side, "a side").ok();
            let number = value.and_then(|value| value.substitute(&values)?.to_number());
            if let Some(number) = number.filter(|_| !matches!(side.kind(), ExprKind::Number(_))) {
                let because = format!("where {}", witness::point(at));
                self.push("at a point", format!("{side} = {}", self.show.number(&number)), because);
            }
        }
    }

    fn difference(&mut self, exprs: [&Expr; 2], left: &[Fraction], right: &[Fraction]) {
        self.side("left side", exprs[0], self.show.components(left));
        self.side("right side", exprs[1], self.show.components(right));
        let differences: Vec<Fraction> = left.iter().zip(right).map(|(a, b)| a - b).collect();
        if differences.iter().all(Fraction::is_zero) {
            self.push("difference", "0", "both sides are the same function, identically");
            return;
        }
        let text = self.show.components(&differences);
        let because = if differences.iter().all(|part| part.to_number().is_some()) {
            "not zero"
        } else {
            "not the zero function, so the sides differ where it does not vanish"
        };
        self.push("difference", text, because);
    }

    /// Sides with square roots.
    fn rooted(&mut self, exprs: [&Expr; 2], left: &[QuadraticFraction], right: &[QuadraticFraction]) {
        self.side("left side", exprs[0], self.show.rooted(left));
        self.side("right side", exprs[1], self.show.rooted(right));
        let differences: Option<Vec<QuadraticFraction>> =
            left.iter().zip(right).map(|(a, b)| a.minus(b)).collect();
        match differences {
            Some(parts) if parts.iter().all(QuadraticFraction::is_zero) => {
                self.push("difference", "0", "both sides are the same function, identically");
            }
            Some(parts) => {
                let text = self.show.rooted(&parts);
                self.push(
                    "difference",
                    text,
                    "not zero: neither the rational part nor that with the root cancels the other",
                );
            }
            None => self.push("difference", "not zero", "the sides have different square roots"),
        }
    }

    fn directions(&mut self, exprs: [&Expr; 2], left: &[Fraction], right: &[Fraction]) {
        self.side("left side", exprs[0], self.show.coordinates(left));
        self.side("right side", exprs[1], self.show.coordinates(right));
        let zero = |side: &[Fraction]| side.iter().all(Fraction::is_zero);
        if zero(left) || zero(right) {
            self.push("difference", "0", "one of the sides is zero, which has no direction");
            return;
        }
        let pairs: Vec<(usize, usize)> = (0..left.len()).flat_map(|i| (0..i).map(move |j| (j, i))).collect();
        let minor = |&(i, j): &(usize, usize)| &(&left[i] * &right[j]) - &(&left[j] * &right[i]);
        let unequal = pairs.iter().map(|pair| (pair, minor(pair))).find(|(_, minor)| !minor.is_zero());
        if let Some((&(i, j), minor)) = unequal {
            let names = [i, j].map(|index| component_name(left.len(), index));
            let formula = format!(
                "left{a}*right{b} - left{b}*right{a} = {}",
                self.show.scalar(&minor),
                a = names[0],
                b = names[1],
            );
            self.push("minor", formula, "not zero, so neither side is a multiple of the other");
            return;
        }
        let pair = left.iter().zip(right).find(|(_, b)| !b.is_zero());
        if let Some(factor) = pair.and_then(|(a, b)| a.checked_div(b)) {
            let formula = format!("left = ({})*right", self.show.scalar(&factor));
            let because = format!("all {} minors of the two vanish identically", pairs.len());
            self.push("factor", formula, because);
        }
    }

    fn degrees(&mut self, expr: &Expr, derived: &DegreeValue, stated: &[i64]) {
        for ((parameter, degree), stated) in derived.parameters.iter().zip(&derived.degrees).zip(stated) {
            if degree < stated {
                for (name, poly) in &derived.polynomials {
                    if let Some(own) = poly.degree(parameter) {
                        let formula = format!("the coefficient of {parameter}^{stated} in {name} is 0");
                        self.push(
                            "coefficient",
                            formula,
                            format!("{name} is of degree {own} in {parameter}"),
                        );
                    }
                }
            }
            // One polynomial that attains the degree proves that it is not less; none that exceeds it that it is not more.
            let degree_of = |poly: &Poly| poly.degree(parameter).map_or(-1, i64::from);
            let attaining = derived.polynomials.iter().find(|(_, poly)| degree_of(poly) == *degree);
            let Some((name, poly)) = attaining.filter(|_| *degree >= 0) else { continue };
            let leading = poly.coefficients(parameter).pop().unwrap_or_else(Poly::zero);
            let formula =
                format!("the coefficient of {parameter}^{degree} in {name} is {}", self.show.poly(&leading));
            self.push("coefficient", formula, "not zero, and no higher power occurs");
        }
        let because = if derived.polynomials.len() > 1 {
            "the largest of all polynomials for each parameter"
        } else {
            ""
        };
        self.push("degree", format!("{expr} = {derived}"), because);
    }

    fn common_factor(&mut self, exprs: &[&Expr], polynomials: &[Poly], common: &Poly) {
        for (expr, poly) in exprs.iter().zip(polynomials) {
            let (written, text) = (expr.to_string(), self.show.poly(poly));
            let formula = if written == text { text } else { format!("{written} = {text}") };
            self.push("polynomial", formula, "");
        }
        if !common.is_constant() {
            self.push("common factor", self.show.poly(common), "it divides all of them");
            return;
        }
        let scope = self.show.scope();
        for variable in &scope.parameters {
            if polynomials.iter().any(|poly| !poly.is_zero() && !poly.contains(variable)) {
                continue;
            }
            match certificate(polynomials, variable) {
                Some(Certificate { point, combination, resultant }) => {
                    let names: Vec<String> = exprs.iter().map(ToString::to_string).collect();
                    let second = combination
                        .iter()
                        .zip(&names[1..])
                        .map(
                            |(factor, name)| {
                                if *factor == 1 { name.clone() } else { format!("{factor}*({name})") }
                            },
                        )
                        .collect::<Vec<_>>()
                        .join(" + ");
                    let at = if point.is_empty() {
                        String::new()
                    } else {
                        format!(" at {}", witness::point(&point))
                    };
                    let formula = format!(
                        "resultant({}, {second}, parameter = {variable}) = {}{at}",
                        names[0],
                        self.show.poly(&resultant)
                    );
                    let because = format!("not zero, so no common factor depends on {variable}");
                    self.push("certificate", formula, because);
                }
                None => {
                    let because = "found by the algorithm for greatest common divisors alone";
                    self.push("common factor", format!("none that depends on {variable}"), because);
                }
            }
        }
        self.push("common factor", self.show.poly(common), "a number");
    }

    fn decimal(
        &mut self,
        value: &Expr,
        literal: &Expr,
        number: &Poly,
        stated: &Poly,
        unit: &Poly,
        places: u32,
    ) {
        self.push("number", format!("{value} = {}", self.show.poly(number)), "");
        // A unit of the last digit that is shown, below what rounding gives and above it.
        let shown = parse_decimal(&format!("1e-{places}")).unwrap_or_default();
        let rounded = parse_decimal(number.to_decimal(places).trim_start_matches('-')).unwrap_or_default();
        let rounded = if number.sign().is_lt() { -rounded } else { rounded };
        let [lower, upper] =
            [&rounded - &shown, &rounded + &shown].map(|end| Poly::constant(end).to_decimal(places));
        self.push("number", format!("{lower} < {value} < {upper}"), "an enclosure");
        let difference = number - stated;
        let half = unit.scale(&ratio(1, 2));
        let within = difference.compare(&half).is_le() && (-&difference).compare(&half).is_le();
        let relation = if within { "at most" } else { "more than" };
        let because = format!("{relation} half a unit of the last digit, {}", half.to_decimal(places));
        self.push("decimal", format!("{value} - ({literal}) = {}", difference.to_decimal(places)), because);
    }

    fn rationality(&mut self, expr: &Expr) {
        let scope = self.show.scope();
        match called(resolved(scope, expr)) {
            Some(("offset", [surface, _])) => {
                if let Ok(value) = scope.evaluate(&surface.value) {
                    match value.bare() {
                        Value::Surface(surface) => return self.normal(surface),
                        Value::Curve(curve) => return self.speed(&surface.value, curve),
                        _ => {}
                    }
                }
            }
            Some(("sqrt", [radicand])) => {
                if let Ok(Some(value)) = scope.evaluate(&radicand.value).map(|value| value.scalar()) {
                    return self.radicand(&radicand.value.to_string(), &value);
                }
            }
            _ => {}
        }
        let frames = frames::occurring(scope, expr);
        if frames.is_empty()
            && let ExprKind::Member { object, .. } = resolved(scope, expr).kind()
            && let Ok(value) = scope.evaluate(object)
            && let Value::Curve(curve) = value.bare()
        {
            self.speed(object, curve);
        }
        for (name, frame) in &frames {
            self.frame(name, frame);
        }
        match scope.evaluate(expr) {
            Ok(value) => {
                if let Some(text) = self.show.value(&value) {
                    self.push("value", format!("{expr} = {text}"), "a rational function");
                }
            }
            // Why frames are not rational has been said.
            Err(_) if !frames.is_empty() => {}
            Err(fault) => self.push("value", format!("{expr} = none"), fault.diagnostic.message),
        }
    }

    /// The squared length of a surface's normal as a square times a rest.
    fn normal(&mut self, surface: &SweptSurface) {
        let Ok(normal) = surface.normal() else { return };
        let [x, y, z] = normal.numerator().each_ref().map(|part| Fraction::from(part.clone()));
        let numerator = self.show.vector(&Vector::new(x, y, z));
        self.push("value", format!("N = {numerator}"), "R_u x R_v without its factor: coprime polynomials");
        let factor = self.show.scalar(normal.factor());
        self.push("value", format!("R_u x R_v = ({factor})*N"), "");
        let length = normal.squared_length();
        let member: Vec<String> = length.member().iter().map(|(s, value)| format!("{s} = {value}")).collect();
        let at = if member.is_empty() { String::new() } else { format!(" for {}", member.join(", ")) };
        let root = Fraction::from(length.split().root.clone());
        self.split("|N|^2", length.split(), &root, length.radicand(), &at);
    }

    /// The squared parametric speed of a curve as a square times a rest.
    pub(super) fn speed(&mut self, expr: &Expr, curve: &Curve) {
        self.radicand(&format!("norm2({expr}.hodograph)"), &curve.hodograph().norm2());
    }

    /// How the pieces of a function meet, joint by joint.
    fn joints(&mut self, expr: &Expr) {
        let Ok(Some((parameter, joints))) = pieces::joints(self.show.scope(), expr) else { return };
        let derivative = |order: i64| match order {
            0 => expr.to_string(),
            1 => format!("diff({expr}, {parameter})"),
            order => format!("diff({expr}, {parameter}, {order})"),
        };
        for joint in joints {
            let at = format!("{parameter} = {}", joint.knot);
            let agreeing = match joint.order {
                -1 => "the values from both sides differ".to_owned(),
                0 => "the values from both sides are equal, the first derivatives are not".to_owned(),
                order => format!("the derivatives from both sides are equal up to order {order}"),
            };
            let formula = match &joint.difference {
                Some(parts) => {
                    let jump = self.show.components(parts);
                    format!("{} jumps by {jump} at {at}", derivative(joint.order + 1))
                }
                None => format!("{} does not jump at {at}", derivative(joint.order)),
            };
            self.push("joint", formula, agreeing);
        }
    }

    pub(super) fn radicand(&mut self, name: &str, value: &Fraction) {
        let value = value.lowest_terms();
        let odd = value.factors().iter().filter(|(_, exponent)| exponent % 2 == 1);
        let numerator = odd.fold(value.numerator().clone(), |product, (factor, _)| product * factor);
        let below = value.factors().iter().map(|(factor, exponent)| (factor.clone(), exponent.div_ceil(2)));
        let split = numerator.square_split();
        let root = Fraction::new(split.root.clone(), below);
        self.split(name, &split, &root, &Poly::one(), "");
    }

    /// That something is `unit·radicand·root²·odd`.
    fn split(&mut self, name: &str, split: &SquareSplit, root: &Fraction, radicand: &Poly, at: &str) {
        let constant = &split.unit * radicand;
        let mut parts = vec![formula::grouped(&self.show.poly(&constant))];
        if *root != Fraction::one() {
            parts.push(format!("({})^2", self.show.scalar(root)));
        }
        if !split.odd.is_one() {
            parts.push(formula::grouped(&self.show.poly(&split.odd)));
        }
        if parts.len() > 1 && constant.is_one() {
            parts.remove(0);
        }
        let product = match parts.as_slice() {
            [_] if !split.odd.is_one() => self.show.poly(&split.odd),
            parts => parts.join("*"),
        };
        let because = if split.is_square() && radicand.is_one() {
            "a number times a square, so the root is a rational function over the real numbers"
        } else if !split.is_square() && !functions::is_varying(self.show.scope(), &split.odd) {
            "the last factor depends on the symbols alone: for all their values it is a number, so the root is a rational function"
        } else if split.is_square() {
            "a constant times a square, so the root is a rational function where that constant is not negative"
        } else {
            "the last factor is squarefree and no number, so there is no rational root"
        };
        self.push("square", format!("{name} = {product}{at}"), because);
    }
}

/// A proof that polynomials have no common factor that depends on a variable.
struct Certificate {
    /// Values of all other variables.
    point: Point,
    /// The numbers by which the second polynomial, the third, and so on are multiplied in their sum.
    combination: Vec<i64>,
    /// The resultant of the first polynomial and that sum, which is not zero.
    resultant: Poly,
}

/// A point at which the first polynomial and a combination of the others keep their degrees and have a resultant that is not
/// zero: a common factor of all would be one of these two there.
fn certificate(polynomials: &[Poly], variable: &Variable) -> Option<Certificate> {
    let (first, others) = polynomials.split_first()?;
    let mut variables: Vec<Variable> = polynomials.iter().flat_map(Poly::occurring_variables).collect();
    variables.sort();
    variables.dedup();
    variables.retain(|other| other != variable);
    (0..MOST_POINTS).find_map(|trial| {
        let combination: Vec<i64> = (0_i64..).zip(others).map(|(index, _)| 1 + index * (trial + 1)).collect();
        let second: Poly =
            combination.iter().zip(others).map(|(factor, poly)| poly.scale(&integer(*factor))).sum();
        let place = |(index, variable): (i64, &Variable)| {
            (variable.clone(), Poly::integer((trial * (index + 3) + index + 2) % (trial + 17) + 1))
        };
        let point: Point = (0_i64..).zip(&variables).map(place).collect();
        let (a, b) = (first.evaluate(&point), second.evaluate(&point));
        // A leading coefficient that vanishes could hide a common factor.
        if a.degree(variable) != first.degree(variable) || b.degree(variable) != second.degree(variable) {
            return None;
        }
        let resultant = a.resultant(&b, variable);
        (!resultant.is_zero()).then_some(Certificate { point, combination, resultant })
    })
}
