//! Derived surfaces as text that a mathematician can read: degrees first, factors kept, one term a line.

use std::fmt::Write;

use hodograph_algebra::{
    Bidegree, ControlNet, Derivation, DifferentialGeometry, Fraction, Homogeneous, Offset, Poly, Variable,
};

use crate::catalogue::Entry;
use crate::digest::fnv1a;

/// The most terms of a polynomial that are written out.
const MOST_TERMS: usize = 60;

/// The most characters of a polynomial in one line.
const SHORT: usize = 60;

/// The most characters of a coefficient that are written out.
const WIDEST: usize = 160;

/// All that is derived of a sweep.
#[must_use]
pub fn text(entry: &Entry) -> String {
    let Entry { model, derivation } = entry;
    let geometry = entry.geometry();
    let mut page = Page::new(&derivation.parameters);
    let out = &mut page.text;
    _ = writeln!(out, "{}\n{}\n", model.name, "=".repeat(model.name.len()));
    for line in &model.docs {
        _ = writeln!(out, "{}", line.trim_end());
    }
    _ = writeln!(out);
    for line in &model.formula {
        _ = writeln!(out, "    {line}");
    }
    _ = writeln!(out, "\nSource: {}", model.source.as_deref().unwrap_or("none"));
    degrees(&mut page, derivation);
    field(&mut page, derivation);
    page.heading("Homogeneous coordinates");
    coordinates(&mut page, &derivation.homogeneous);
    normal(&mut page, derivation, geometry);
    page.heading("Parametric speeds");
    for (variable, speed) in derivation.parameters.iter().zip(&geometry.speeds) {
        let name = format!("|R_{}|", variable.name());
        match &speed.root {
            Some(root) if speed.certified => page.fraction(&format!("{name} = "), root),
            Some(root) => page.fraction(&format!("{name} = ± "), root),
            None => match speed.squared() {
                Some(squared) => page.fraction(&format!("{name}² = "), &squared),
                None => page.fraction(&format!("{name} = |N| · "), &speed.factor),
            },
        }
    }
    page.heading("Singular points on the domain");
    match geometry.singular_zeros.as_slice() {
        [] => page.line("none"),
        zeros => zeros.iter().for_each(|zero| page.line(zero)),
    }
    offset(&mut page, derivation, geometry);
    control_net(&mut page, entry.control_net());
    page.text
}

fn degrees(page: &mut Page<'_>, derivation: &Derivation) {
    let [u, v] = derivation.parameters.each_ref().map(Variable::name);
    page.heading(&format!("Degrees in ({u}, {v})"));
    let homogeneous = &derivation.homogeneous;
    let [w, x, y, z] = homogeneous.coordinates();
    let groups: [(&str, &[&Poly]); 6] =
        [("W", &[w]), ("X", &[x]), ("Y", &[y]), ("Z", &[z]), ("W and Z", &[w, z]), ("X and Y", &[x, y])];
    for (name, group) in groups {
        let degree = Bidegree::of_group(group.iter().copied(), &derivation.parameters);
        page.line(&format!("{name:<16}{degree}"));
    }
    page.line(&format!("{:<16}{}", "patch", homogeneous.degree()));
    page.line(&format!("{:<16}{}", "as constructed", homogeneous.raw_degree()));
    page.polynomial("common factor removed: ", homogeneous.common_factor());
}

fn field(page: &mut Page<'_>, derivation: &Derivation) {
    let field = &derivation.field;
    page.heading(&format!("Number field of degree {}", field.degree()));
    for (position, generator) in field.generators().iter().enumerate() {
        let value = Poly::generator(field, position).to_decimal(20);
        page.line(&format!("{} ≈ {value}, {} = 0", generator.name(), field.relation(position)));
    }
}

fn coordinates(page: &mut Page<'_>, homogeneous: &Homogeneous) {
    let [weight, ..] = homogeneous.coordinates();
    let product: Poly = homogeneous.weight_factors().iter().map(|(factor, e)| factor.pow(*e)).product();
    match weight.exact_div(&product) {
        Some(unit) => page.product("W = ", &unit, homogeneous.weight_factors()),
        None => page.polynomial("W = ", weight),
    }
    for (name, poly) in Homogeneous::NAMES.iter().zip(homogeneous.coordinates()).skip(1) {
        page.polynomial(&format!("{name} = "), poly);
    }
}

fn normal(page: &mut Page<'_>, derivation: &Derivation, geometry: &DifferentialGeometry) {
    let normal = &geometry.normal;
    let [u, v] = derivation.parameters.each_ref().map(Variable::name);
    page.heading(&format!("Normal: R_{u} × R_{v} = factor · N"));
    page.fraction("factor = ", normal.factor());
    for (name, component) in ["N_x", "N_y", "N_z"].iter().zip(normal.numerator()) {
        page.polynomial(&format!("{name} = "), component);
    }
    page.heading("|N|² = unit · root² · odd");
    let squared = normal.squared_length();
    for (symbol, value) in squared.member() {
        page.line(&format!("where {symbol} = {value}"));
    }
    page.polynomial("unit = ", &squared.split().unit);
    page.polynomial("root = ", &squared.split().root);
    page.polynomial("odd = ", &squared.split().odd);
    if !squared.radicand().is_one() {
        page.polynomial("further factor in the symbols = ", squared.radicand());
    }
}

fn offset(page: &mut Page<'_>, derivation: &Derivation, geometry: &DifferentialGeometry) {
    let distance = derivation.distance.name();
    page.heading(&format!("Offset at the distance {distance}"));
    match &geometry.offset {
        Offset::Rational(surface) => {
            for (name, degree) in Homogeneous::NAMES.iter().zip(surface.degrees()) {
                page.line(&format!("{name:<16}{degree}"));
            }
            page.line(&format!("{:<16}{}", "patch", surface.degree()));
            coordinates(page, surface);
        }
        Offset::SymbolicRadical { radicand, .. } => {
            page.polynomial("rational, over the square root of ", radicand)
        }
        Offset::Irrational { odd } => page.polynomial("not rational: |N|² has the odd factor ", odd),
        other => page.line(&format!("{other:?}")),
    }
}

fn control_net(page: &mut Page<'_>, net: &ControlNet) {
    page.heading(&format!("Control net of degree ({}, {}): weights", net.degree[0], net.degree[1]));
    for (i, row) in net.points.iter().enumerate() {
        for (j, [weight, ..]) in row.iter().enumerate() {
            page.line(&format!("w[{i}][{j}] = {}", shortened(&weight.to_string())));
        }
    }
    let points: Vec<String> = net.points.iter().flatten().flatten().map(ToString::to_string).collect();
    page.line(&format!("all {} numbers: digest {}", points.len(), fnv1a(&points.join("\n"))));
}

struct Page<'a> {
    text: String,
    parameters: &'a [Variable; 2],
    /// Long factors, which are written out once and named F1, F2, … from then on.
    named: Vec<Poly>,
}

impl Page<'_> {
    fn new(parameters: &[Variable; 2]) -> Page<'_> {
        Page { text: String::new(), parameters, named: Vec::new() }
    }

    fn heading(&mut self, heading: &str) {
        _ = writeln!(self.text, "\n{heading}\n{}", "-".repeat(heading.chars().count()));
    }

    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }

    /// A polynomial in the parameters: a line for each of their monomials, with its coefficient; short ones in one line.
    fn polynomial(&mut self, name: &str, poly: &Poly) {
        let whole = poly.to_string();
        if whole.chars().count() <= SHORT {
            return self.line(&format!("{name}{whole}"));
        }
        let terms = poly.coefficients_of(self.parameters);
        if terms.len() > MOST_TERMS {
            let count = poly.monomial_count();
            return self.line(&format!("{name}{count} terms, digest {}", fnv1a(&whole)));
        }
        self.line(name.trim_end());
        let [u, v] = self.parameters;
        // From the highest power of u, then of v, downward.
        for (exponents, coefficient) in terms.iter().rev() {
            let power = |(variable, exponent): (&Variable, &u32)| match exponent {
                0 => String::new(),
                1 => format!(" {}", variable.name()),
                _ => format!(" {}^{exponent}", variable.name()),
            };
            let monomial: String = [u, v].into_iter().zip(exponents).map(power).collect();
            let monomial = if monomial.is_empty() { " 1" } else { monomial.as_str() };
            self.line(&format!("   {monomial:<10} : {}", shortened(&coefficient.to_string())));
        }
    }

    /// unit · Π factorᵉ.
    fn product(&mut self, name: &str, unit: &Poly, factors: &[(Poly, u32)]) {
        let first_new = self.named.len();
        let mut product: Vec<String> = Vec::new();
        if !unit.is_one() || factors.is_empty() {
            product.push(in_parentheses(unit.to_string()));
        }
        for (factor, exponent) in factors {
            let text = factor.to_string();
            let base =
                if text.chars().count() <= SHORT { in_parentheses(text) } else { self.name_of(factor) };
            product.push(if *exponent == 1 { base } else { format!("{base}^{exponent}") });
        }
        self.line(&format!("{name}{}", product.join(" · ")));
        for index in first_new..self.named.len() {
            let factor = self.named[index].clone();
            self.polynomial(&format!("  with F{} = ", index + 1), &factor);
        }
    }

    fn name_of(&mut self, factor: &Poly) -> String {
        let known = self.named.iter().position(|known| known == factor);
        let index = known.unwrap_or_else(|| {
            self.named.push(factor.clone());
            self.named.len() - 1
        });
        format!("F{}", index + 1)
    }

    fn fraction(&mut self, name: &str, fraction: &Fraction) {
        self.polynomial(name, fraction.numerator());
        if !fraction.factors().is_empty() {
            self.product("  over ", &Poly::one(), fraction.factors());
        }
    }
}

fn in_parentheses(sum: String) -> String {
    if sum.contains(' ') { format!("({})", shortened(&sum)) } else { shortened(&sum) }
}

fn shortened(number: &str) -> String {
    let length = number.chars().count();
    if length <= WIDEST {
        number.to_owned()
    } else {
        format!("{length} characters, digest {}", fnv1a(number))
    }
}
