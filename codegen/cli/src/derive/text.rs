//! Derivations for people.

use hodograph_algebra::{Derivation, Fraction, Homogeneous, Offset, Poly, Variable};

use super::factors::Factors;
use super::{APPROXIMATION_DIGITS, Derived, offset_reason};
use crate::decimal::significant;
use crate::layout::{cut, is_short, polynomial, product, wrapped};

/// How many characters a control point may take; where one needs more, points are only counted.
const LONGEST_POINT: usize = 160;

/// How many characters of a rational function are printed.
const LONGEST: usize = 600;

/// Everything that is derived of one sweep.
pub(super) fn output(derived: &Derived<'_>) -> String {
    let Derived { model, derivation, .. } = derived;
    let mut page = Page::default();
    page.line(&format!("sweep {}", model.name));
    if let Some(source) = &model.source {
        page.item("", source);
    }
    for line in &model.docs {
        page.item("", line);
    }
    page.title("Formula");
    for clause in &model.formula {
        page.item("", clause);
    }
    degrees(&mut page, &derivation.homogeneous);
    field(&mut page, derivation);
    page.title("Homogeneous coordinates");
    coordinates(&mut page, &derivation.homogeneous);
    normal(&mut page, derivation);
    page.title("Parametric speeds");
    for (name, speed) in ["|R_u|", "|R_v|"].iter().zip(&derivation.speeds) {
        let text = speed.to_string();
        page.shortened |= text.len() > LONGEST;
        page.item(&format!("{name} = "), &cut(&text, LONGEST));
    }
    singular(&mut page, derivation);
    offset(&mut page, derivation);
    control_net(&mut page, derivation);
    if page.shortened {
        page.title("`--format json` prints everything in full.");
    }
    page.text
}

/// Lines of text, and whether something in them was cut.
#[derive(Default)]
struct Page {
    text: String,
    shortened: bool,
}

impl Page {
    fn line(&mut self, line: &str) {
        self.text += line.trim_end();
        self.text.push('\n');
    }

    fn title(&mut self, title: &str) {
        self.text.push('\n');
        self.line(title);
    }

    fn item(&mut self, first: &str, text: &str) {
        let text = wrapped(&format!("  {first}"), text);
        self.line(&text);
    }

    fn poly(&mut self, first: &str, poly: &Poly) {
        self.shortened |= !is_short(poly);
        self.item(first, &polynomial(poly));
    }

    fn product(&mut self, first: &str, factors: &Factors) {
        self.shortened |= !factors.factors.iter().all(|(factor, _)| is_short(factor));
        self.item(first, &product(&factors.unit, &factors.factors));
    }
}

fn degrees(page: &mut Page, homogeneous: &Homogeneous) {
    let [u, v] = homogeneous.parameters();
    page.title(&format!("Degrees in ({u}, {v})"));
    let [w, x, y, z] = homogeneous.coordinates().each_ref();
    let group = |a: &Poly, b: &Poly| {
        hodograph_algebra::Bidegree::of_group([a, b], homogeneous.parameters()).to_string()
    };
    let each = Homogeneous::NAMES.iter().zip(homogeneous.degrees());
    let each: Vec<String> = each.map(|(name, degree)| format!("{name} {degree}")).collect();
    page.item("each      ", &each.join(", "));
    page.item("together  ", &format!("W and Z {}, X and Y {}", group(w, z), group(x, y)));
    page.item("patch     ", &homogeneous.degree().to_string());
    let factor = homogeneous.common_factor();
    let removed = if factor.is_constant() {
        "without a common factor".to_owned()
    } else {
        format!("with the common factor {}", polynomial(factor))
    };
    page.item("raw       ", &format!("{}, {removed}", homogeneous.raw_degree()));
}

fn field(page: &mut Page, derivation: &Derivation) {
    let field = &derivation.field;
    if field.generators().is_empty() {
        return;
    }
    page.title(&format!("Number field of degree {}", field.degree()));
    for (position, generator) in field.generators().iter().enumerate() {
        let approximation = significant(&Poly::generator(field, position), APPROXIMATION_DIGITS);
        page.item("", &format!("{} = {approximation}…, {} = 0", generator.name(), field.relation(position)));
    }
}

fn coordinates(page: &mut Page, homogeneous: &Homogeneous) {
    page.product("W = ", &Factors::of_weight(homogeneous));
    for (name, poly) in Homogeneous::NAMES.iter().zip(homogeneous.coordinates()).skip(1) {
        page.product(&format!("{name} = "), &Factors::of(poly, homogeneous.parameters()));
    }
}

fn normal(page: &mut Page, derivation: &Derivation) {
    let normal = &derivation.normal;
    page.title("Normal: R_u x R_v = c*N");
    for (name, component) in ["N_x", "N_y", "N_z"].iter().zip(normal.numerator()) {
        page.product(&format!("{name} = "), &Factors::of(component, &derivation.parameters));
    }
    fraction(page, "c = ", normal.factor(), &derivation.parameters);
    let split = normal.split();
    let squares = [(normal.radicand(), 1), (&split.root, 2), (&split.odd, 1)];
    let factors = squares.into_iter().filter(|(factor, _)| !factor.is_one());
    let factors = factors.map(|(factor, exponent)| (factor.clone(), exponent)).collect();
    page.product("|N|^2 = ", &Factors { unit: split.unit.clone(), factors });
}

fn fraction(page: &mut Page, first: &str, fraction: &Fraction, parameters: &[Variable; 2]) {
    let lowest = fraction.lowest_terms();
    let numerator = Factors::of(lowest.numerator(), parameters);
    page.shortened |= !numerator.factors.iter().chain(lowest.factors()).all(|(factor, _)| is_short(factor));
    let above = product(&numerator.unit, &numerator.factors);
    let text = match lowest.factors() {
        [] => above,
        factors => format!("({above}) / ({})", product(&Poly::one(), factors)),
    };
    page.item(first, &text);
}

fn singular(page: &mut Page, derivation: &Derivation) {
    page.title("Singular locus on the domain");
    page.poly("factor = ", &derivation.singular.factor);
    if derivation.singular_zeros.is_empty() {
        page.item("", "there is a normal everywhere");
    }
    for zero in &derivation.singular_zeros {
        page.shortened |= zero.len() > LONGEST;
        page.item("no normal at ", &cut(zero, LONGEST));
    }
}

fn offset(page: &mut Page, derivation: &Derivation) {
    page.title(&format!("Offset at the distance {}", derivation.distance));
    let answer = if derivation.offset.is_rational() { "rational: " } else { "not rational: " };
    page.item(answer, &cut(&offset_reason(derivation), 2 * LONGEST));
    if let Offset::Rational(offset) = &derivation.offset {
        let degrees: Vec<String> =
            Homogeneous::NAMES.iter().zip(offset.degrees()).map(|(name, degree)| format!("{name} {degree}")).collect();
        page.item("degrees ", &format!("{}, patch {}", degrees.join(", "), offset.degree()));
        coordinates(page, offset);
    }
}

fn control_net(page: &mut Page, derivation: &Derivation) {
    let net = &derivation.control_net;
    let [m, n] = net.degree;
    page.title(&format!("Control net of degree ({m}, {n}), points (W, X, Y, Z) over the domain"));
    for (i, row) in net.points.iter().enumerate() {
        for (j, point) in row.iter().enumerate() {
            let point = format!("({})", point.each_ref().map(Poly::to_string).join(", "));
            page.shortened |= point.len() > LONGEST_POINT;
            page.item(&format!("b[{i},{j}] = "), &cut(&point, LONGEST_POINT));
        }
    }
}
