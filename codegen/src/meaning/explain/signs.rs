//! Why a function has its sign on a box: the zeros of its squarefree factors, and their Bernstein coefficients.

use std::cmp::Ordering;

use hodograph_algebra::{Bernstein, BoxSign, Fraction, Interval, Point, Poly, Variable, ratio};

use super::reasons::Reasons;
use super::show::Show;
use crate::meaning::witness;

/// How many boxes a certificate may have; those of verdicts may have more.
const MOST_BOXES: usize = 64;

/// How many Bernstein coefficients are written out.
const MOST_COEFFICIENTS: usize = 12;

/// How many digits after the point values have.
const DIGITS: u32 = 6;

/// Adds the steps from a function to its sign on a box.
pub(super) fn explain(
    reasons: &mut Reasons<'_, '_>,
    function: &Fraction,
    polynomial: &Poly,
    domain: &[(Variable, Interval)],
    sign: &BoxSign,
) {
    let show = reasons.show;
    let region: Vec<String> = domain.iter().map(|(variable, interval)| over(variable, interval)).collect();
    reasons.push("function", show.scalar(function), format!("for {}", region.join(", ")));
    if *polynomial != *function.numerator() {
        let because =
            "the same sign: it differs by an even power of the denominator, which has no zero there";
        reasons.push("function", show.poly(polynomial), because);
    }
    let decomposition = polynomial.squarefree();
    if !decomposition.unit.is_one() {
        let because = format!("a {} number", word(decomposition.unit.sign()));
        reasons.push("factor", show.number(&decomposition.unit), because);
    }
    for (factor, multiplicity) in &decomposition.factors {
        let own: Vec<(Variable, Interval)> =
            domain.iter().filter(|(variable, _)| factor.contains(variable)).cloned().collect();
        let written = match multiplicity {
            1 => show.poly(factor),
            _ => format!("({})^{multiplicity}", show.poly(factor)),
        };
        match own.as_slice() {
            [(variable, interval)] => univariate(reasons, factor, &written, variable, interval),
            _ => mixed(reasons, factor, &written, &own),
        }
    }
    let (formula, because) = conclusion(show, polynomial, sign);
    reasons.push("sign", formula, because);
}

fn over(variable: &Variable, interval: &Interval) -> String {
    format!("{variable} in {}..{}", interval.lower(), interval.upper())
}

/// A factor in one variable: its Bernstein coefficients if they decide, else its zeros on the interval.
fn univariate(
    reasons: &mut Reasons<'_, '_>,
    factor: &Poly,
    written: &str,
    variable: &Variable,
    interval: &Interval,
) {
    let show = reasons.show;
    let domain = [(variable.clone(), interval.clone())];
    let form = Bernstein::new(factor, &domain);
    if let Some(sign) = strict_sign(&form) {
        let count = form.coefficients().len();
        let because = if count <= MOST_COEFFICIENTS {
            let list: Vec<String> = form.coefficients().iter().map(decimal).collect();
            format!("its Bernstein coefficients {} are all {sign}", list.join(", "))
        } else {
            let (least, most) = extremes(&form);
            format!("its {count} Bernstein coefficients are all {sign}, from {least} to {most}")
        };
        reasons.push("certificate", written, because);
        return;
    }
    let Some(roots) = factor.real_roots_in(variable, interval) else { return };
    if roots.is_empty() {
        let start = Point::from([(variable.clone(), interval.lower().clone())]);
        let value = factor.evaluate(&start);
        let because = format!(
            "no real zero in {}..{}, where its real roots were isolated, and {} at the beginning",
            interval.lower(),
            interval.upper(),
            word(value.sign()),
        );
        reasons.push("certificate", written, because);
    }
    for root in roots {
        let because = match root.exact() {
            Some(number) => format!("where {variable} = {}", show.number(number)),
            None => format!(
                "where {variable} = {}…, the only real zero in an isolating interval",
                root.to_decimal(DIGITS)
            ),
        };
        reasons.push("root", format!("{written} = 0"), because);
    }
}

/// A factor in several variables: Bernstein coefficients on as few boxes as decide.
fn mixed(reasons: &mut Reasons<'_, '_>, factor: &Poly, written: &str, domain: &[(Variable, Interval)]) {
    match boxes(Bernstein::new(factor, domain)) {
        Some(forms) => {
            let sign = forms.first().and_then(strict_sign).unwrap_or("of one sign");
            let ends = forms.iter().filter_map(Bernstein::range);
            let nearest = ends
                .map(|(least, most)| if least.sign().is_gt() { least.clone() } else { most.clone() })
                .min_by(|a, b| absolute(a).compare(&absolute(b)));
            let nearest = nearest
                .map_or_else(String::new, |value| format!(", the one nearest to 0 is {}", decimal(&value)));
            let boxes = if forms.len() == 1 {
                "the box".to_owned()
            } else {
                format!("{} boxes that cover it", forms.len())
            };
            reasons.push(
                "certificate",
                written,
                format!("all Bernstein coefficients on {boxes} are {sign}{nearest}"),
            );
        }
        None => reasons.push(
            "factor",
            written,
            "decided by its zeros on edges, and by subdivision of its Bernstein form or its discriminants",
        ),
    }
}

/// Boxes that cover the one of a form, on each of which all coefficients have one sign, the same on all.
fn boxes(form: Bernstein) -> Option<Vec<Bernstein>> {
    let (mut open, mut done) = (vec![form], Vec::new());
    while let Some(form) = open.pop() {
        if open.len() + done.len() >= MOST_BOXES {
            return None;
        }
        match strict_sign(&form) {
            Some(sign) => {
                if done.first().and_then(strict_sign).is_some_and(|other| other != sign) {
                    return None;
                }
                done.push(form);
            }
            None => {
                let widest = form.axes().iter().enumerate().max_by(|(i, a), (j, b)| {
                    a.interval().width().compare(&b.interval().width()).then(j.cmp(i))
                });
                let (position, axis) = widest?;
                let middle = axis.interval().point(&ratio(1, 2));
                let (lower, upper) = form.subdivided(position, &middle)?;
                open.extend([upper, lower]);
            }
        }
    }
    Some(done)
}

/// The sign of all coefficients, if they have the same one and none is zero.
fn strict_sign(form: &Bernstein) -> Option<&'static str> {
    let mut signs = form.coefficients().iter().map(Poly::sign);
    let first = signs.next().filter(|sign| sign.is_ne())?;
    signs.all(|sign| sign == first).then(|| word(first))
}

fn extremes(form: &Bernstein) -> (String, String) {
    form.range().map(|(least, most)| (decimal(least), decimal(most))).unwrap_or_default()
}

fn word(sign: Ordering) -> &'static str {
    match sign {
        Ordering::Less => "negative",
        Ordering::Equal => "zero",
        Ordering::Greater => "positive",
    }
}

fn absolute(number: &Poly) -> Poly {
    if number.sign().is_lt() { -number } else { number.clone() }
}

/// A number: short rationals as they are, others by a decimal.
fn decimal(number: &Poly) -> String {
    match number.to_rational().map(|value| value.to_string()).filter(|text| text.len() <= 12) {
        Some(text) => text,
        None => format!("{}…", number.to_decimal(DIGITS)),
    }
}

fn conclusion(show: &Show<'_>, polynomial: &Poly, sign: &BoxSign) -> (String, String) {
    let at = |point: &Point| {
        let value = polynomial.evaluate(point);
        format!("{} at {}", show.number(&value), witness::point(point))
    };
    let plain = |text: &str| (text.to_owned(), String::new());
    match sign {
        BoxSign::Positive => plain("positive on the whole domain"),
        BoxSign::Negative => plain("negative on the whole domain"),
        BoxSign::Zero => plain("zero everywhere"),
        BoxSign::NonNegative { zeros } => ("nowhere negative".to_owned(), format!("zeros: {zeros}")),
        BoxSign::NonPositive { zeros } => ("nowhere positive".to_owned(), format!("zeros: {zeros}")),
        BoxSign::ChangesSign { positive, negative } => {
            ("of both signs".to_owned(), format!("{}, but {}", at(positive), at(negative)))
        }
        BoxSign::Undecided { zero: Some(zero), .. } => ("it vanishes".to_owned(), at(zero)),
        _ => plain("not decided within the limit of subdivision"),
    }
}
