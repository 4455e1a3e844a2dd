//! Derivations for people.

use hodograph_algebra::{
    Bidegree, Conditions, ControlNet, Derivation, DifferentialGeometry, Fraction, Homogeneous, Offset, Poly,
    Variable,
};

use hodograph_algebra::budget::Exhausted;

use super::conditions::{Alternative, UNDETERMINED, statements};
use super::factors::Factors;
use super::{APPROXIMATION_DIGITS, Derived, offset_reason};
use crate::decimal::significant;
use crate::layout::{cut, is_short, polynomial, product, wrapped};

/// How many characters an exact control point may take; numbers that need more are shown as decimals.
const LONGEST_POINT: usize = 85;

/// How many significant digits these decimals have.
const POINT_DIGITS: u32 = 12;

/// How many characters of equations that hold together are printed.
const LONGEST_CONDITION: usize = 200;

/// How many characters of the description of a zero are printed.
const LONGEST: usize = 600;

/// Everything that is derived of one sweep.
pub(super) fn output(derived: &Derived<'_>) -> String {
    let Derived { model, derivation, .. } = derived;
    let mut page = Page::default();
    page.line(&format!("sweep {}", model.name));
    if let Some(source) = &model.source {
        page.item("", source);
    }
    for paragraph in model.docs.split(String::is_empty).filter(|lines| !lines.is_empty()) {
        page.line("");
        page.item("", &paragraph.join(" "));
    }
    page.title("Formula");
    for clause in &model.formula {
        page.item("", clause);
    }
    degrees(&mut page, &derivation.homogeneous);
    if !derivation.symbols.is_empty() {
        page.title("Conditions on the symbols for these degrees");
        conditions(&mut page, derived.conditions.as_ref(), &derivation.parameters);
    }
    field(&mut page, derivation);
    page.title("Homogeneous coordinates");
    coordinates(&mut page, &derivation.homogeneous);
    match &derivation.geometry {
        Ok(geometry) => {
            normal(&mut page, derivation, geometry);
            speeds(&mut page, derivation, geometry);
            singular(&mut page, derivation, geometry);
            curvature(&mut page, derived);
            offset(&mut page, derived, geometry);
        }
        Err(exhausted) => {
            page.title("Poles on the domain");
            poles(&mut page, derivation);
            undetermined(&mut page, "Normal, parametric speeds, singular locus and offset", exhausted);
        }
    }
    match &derivation.control_net {
        Ok(net) => control_net(&mut page, net),
        Err(exhausted) => undetermined(&mut page, "Control net", exhausted),
    }
    if page.shortened {
        page.title("`--format json` prints everything in full.");
    }
    page.text
}

/// What the budget does not suffice for.
fn undetermined(page: &mut Page, title: &str, exhausted: &Exhausted) {
    page.title(title);
    page.item("undetermined: ", &exhausted.to_string());
    page.item("", "with a larger number of units, `--budget` goes on");
}

fn speeds(page: &mut Page, derivation: &Derivation, geometry: &DifferentialGeometry) {
    page.title("Parametric speeds");
    for (name, speed) in ["|R_u|", "|R_v|"].iter().zip(&geometry.speeds) {
        let (function, value) = match &speed.root {
            Some(root) if speed.certified || root.is_zero() => ("", root.clone()),
            Some(root) => ("abs", root.clone()),
            None => match speed.squared() {
                Some(squared) => ("sqrt", squared),
                None => {
                    page.item(&format!("{name} = "), &cut(&speed.to_string(), LONGEST));
                    page.shortened = true;
                    continue;
                }
            },
        };
        let value = page.fraction(&value, &derivation.parameters);
        let value = if function.is_empty() { value } else { format!("{function}({value})") };
        page.item(&format!("{name} = "), &value);
    }
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

    /// A rational function with numerator and denominator as products.
    fn fraction(&mut self, fraction: &Fraction, parameters: &[Variable; 2]) -> String {
        let lowest = fraction.lowest_terms();
        let numerator = Factors::of(lowest.numerator(), parameters);
        self.shortened |=
            !numerator.factors.iter().chain(lowest.factors()).all(|(factor, _)| is_short(factor));
        let above = product(&numerator.unit, &numerator.factors);
        match lowest.factors() {
            [] => above,
            factors if above.contains([' ', '/', '*']) => {
                format!("({above}) / ({})", product(&Poly::one(), factors))
            }
            factors => format!("{above} / ({})", product(&Poly::one(), factors)),
        }
    }
}

fn degrees(page: &mut Page, homogeneous: &Homogeneous) {
    let [u, v] = homogeneous.parameters();
    page.title(&format!("Degrees in ({u}, {v})"));
    let [w, x, y, z] = homogeneous.coordinates().each_ref();
    let group = |a: &Poly, b: &Poly| Bidegree::of_group([a, b], homogeneous.parameters()).to_string();
    page.item("each      ", &named(homogeneous.degrees()));
    page.item("together  ", &format!("W and Z {}, X and Y {}", group(w, z), group(x, y)));
    page.item("patch     ", &homogeneous.degree().to_string());
    let factor = homogeneous.common_factor();
    let removed = if factor.is_constant() {
        "no common factor".to_owned()
    } else {
        format!("with the common factor {}", polynomial(factor))
    };
    page.item(
        "raw       ",
        &format!("{}, patch {}, {removed}", named(homogeneous.raw_degrees()), homogeneous.raw_degree()),
    );
}

/// The degrees of W, X, Y and Z.
fn named(degrees: [Bidegree; 4]) -> String {
    let named = Homogeneous::NAMES.iter().zip(degrees).map(|(name, degree)| format!("{name} {degree}"));
    named.collect::<Vec<_>>().join(", ")
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

fn normal(page: &mut Page, derivation: &Derivation, geometry: &DifferentialGeometry) {
    let normal = &geometry.normal;
    page.title("Normal: R_u x R_v = c*N");
    for (name, component) in ["N_x", "N_y", "N_z"].iter().zip(normal.numerator()) {
        page.product(&format!("{name} = "), &Factors::of(component, &derivation.parameters));
    }
    let factor = page.fraction(normal.factor(), &derivation.parameters);
    page.item("c = ", &factor);
    let squared = normal.squared_length();
    let split = squared.split();
    let squares = [(squared.radicand(), 1), (&split.root, 2), (&split.odd, 1)];
    let factors = squares.into_iter().filter(|(factor, _)| !factor.is_one());
    let factors = factors.map(|(factor, exponent)| (factor.clone(), exponent)).collect();
    let values = squared.member().iter().map(|(symbol, value)| format!("{symbol} = {value}"));
    let values = values.collect::<Vec<_>>().join(", ");
    let name = if values.is_empty() { "|N|^2 = ".to_owned() } else { format!("|N|^2 where {values} = ") };
    page.product(&name, &Factors { unit: split.unit.clone(), factors });
}

fn poles(page: &mut Page, derivation: &Derivation) {
    match &derivation.poles {
        Some(poles) if poles.is_empty() => page.item("", "there are no poles"),
        Some(poles) => page.item("poles where W = 0: ", &cut(&poles.to_string(), LONGEST)),
        None => page.item(
            "",
            "poles undetermined: they depend on symbols, or need more than their share of the budget",
        ),
    }
}

fn singular(page: &mut Page, derivation: &Derivation, geometry: &DifferentialGeometry) {
    page.title("Singular locus on the domain");
    page.poly("factor = ", &geometry.singular.factor);
    if derivation.poles.as_ref().is_none_or(|poles| !poles.is_empty()) {
        poles(page, derivation);
    }
    if geometry.singular_zeros.is_empty() {
        let poles = derivation.poles.as_ref().is_none_or(|poles| !poles.is_empty());
        page.item(
            "",
            if poles { "there is a normal everywhere but at poles" } else { "there is a normal everywhere" },
        );
    }
    for zero in &geometry.singular_zeros {
        page.shortened |= zero.len() > LONGEST;
        // What is not determined is no equation.
        let first = if zero.contains('=') { "no normal where " } else { "" };
        page.item(first, &cut(zero, LONGEST));
    }
}

/// Where the curvatures vanish, and so similarity offsets have poles.
fn curvature(page: &mut Page, derived: &Derived<'_>) {
    let Some([gaussian, mean]) = &derived.curvature_zeros else { return };
    page.title("Curvatures");
    page.item("K = 0 ", &cut(&gaussian.to_string(), LONGEST));
    page.item("H = 0 ", &cut(&mean.to_string(), LONGEST));
}

fn offset(page: &mut Page, derived: &Derived<'_>, geometry: &DifferentialGeometry) {
    let derivation = &derived.derivation;
    page.title(&format!("Offset at the distance {}", derivation.distance));
    let answer = if geometry.offset.is_rational() { "rational: " } else { "not rational: " };
    page.item(answer, &offset_reason(geometry, &derivation.distance, polynomial));
    if let Offset::Rational(offset) | Offset::SymbolicRadical { surface: offset, .. } = &geometry.offset {
        page.item("degrees ", &format!("{}, patch {}", named(offset.degrees()), offset.degree()));
        conditions(page, derived.offset_conditions.as_ref(), &derivation.parameters);
        coordinates(page, offset);
    }
}

/// Where the degrees are other ones, a sentence a line.
fn conditions(page: &mut Page, conditions: Option<&Conditions>, parameters: &[Variable; 2]) {
    let Some(conditions) = conditions else {
        page.item("the ", UNDETERMINED);
        return;
    };
    let statements = statements(conditions, parameters);
    if statements.is_empty() {
        page.item("", "none: no values of the symbols change a degree");
    }
    for statement in statements {
        let several = statement.alternatives.len() > 1;
        for (number, alternative) in statement.alternatives.iter().enumerate() {
            let what = if number == 0 { statement.what.as_str() } else { "or" };
            let text = alternative_text(page, alternative);
            page.item("", &format!("{what} {} {text}", alternative.relation(several)));
        }
    }
}

fn alternative_text(page: &mut Page, alternative: &Alternative) -> String {
    let mut text = match (&alternative.equations, &alternative.common_zero) {
        (Some(equations), _) => together(page, equations),
        (None, Some((parameter, polynomials))) => {
            let shown: Vec<String> = polynomials.iter().map(|poly| shown(page, poly)).collect();
            match shown.as_slice() {
                [factor] => format!(
                    "X, Y and Z have a factor in common with {factor} (not determined within the budget)"
                ),
                many => format!("{} have a common zero {parameter}", many.join(" and ")),
            }
        }
        (None, None) => String::new(),
    };
    if !alternative.unless.is_empty() {
        let unless = alternative.unless.alternatives().iter().map(|all| together(page, all));
        text += &format!(", except perhaps where {}", unless.collect::<Vec<_>>().join(" or "));
    }
    text
}

/// Equations, joined by `and`; of very many long ones the first.
fn together(page: &mut Page, equations: &[Poly]) -> String {
    let mut text = String::new();
    for (number, poly) in equations.iter().enumerate() {
        if number > 0
            && (text.len() > LONGEST_CONDITION || text.len() + poly.to_string().len() > LONGEST_CONDITION)
        {
            page.shortened = true;
            return format!("{text} and … ({} equations)", equations.len());
        }
        if number > 0 {
            text += " and ";
        }
        text += &format!("{} == 0", shown(page, poly));
    }
    text
}

fn shown(page: &mut Page, poly: &Poly) -> String {
    page.shortened |= !is_short(poly);
    polynomial(poly)
}

fn control_net(page: &mut Page, net: &ControlNet) {
    let [m, n] = net.degree;
    page.title(&format!("Control net of degree ({m}, {n}), points (W, X, Y, Z) over the domain"));
    for (i, row) in net.points.iter().enumerate() {
        for (j, point) in row.iter().enumerate() {
            let exact = format!("({})", point.each_ref().map(Poly::to_string).join(", "));
            let is_short = exact.len() <= LONGEST_POINT;
            page.shortened |= !is_short;
            let name = format!("b[{i},{j}]");
            if !is_short && point.iter().all(Poly::is_constant) {
                let near = point.each_ref().map(|number| significant(number, POINT_DIGITS));
                page.item(&format!("{name} ≈ "), &format!("({})", near.join(", ")));
            } else {
                page.item(&format!("{name} = "), &cut(&exact, LONGEST_POINT));
            }
        }
    }
}
