//! Derivations as LaTeX.

use hodograph_algebra::{Conditions, DifferentialGeometry, Homogeneous, Offset, Poly, Variable};
use hodograph_codegen::emit::latex;
use hodograph_codegen::language::ast::{ClauseKind, Item};

use super::Derived;
use super::conditions::{Alternative, UNDETERMINED, statements};
use super::factors::Factors;

/// How many characters of LaTeX stand on a line of a formula.
const LINE: usize = 160;

/// All derivations, a subsection each, for a document that uses amsmath.
pub(super) fn output(all: &[Derived<'_>]) -> String {
    let mut text =
        "% Needs \\usepackage{amsmath}; long formulas may break with \\allowdisplaybreaks.\n".to_owned();
    for derived in all {
        text += &subsection(derived);
    }
    text
}

fn subsection(derived: &Derived<'_>) -> String {
    let Derived { item, model, derivation, .. } = derived;
    let mut text = format!("\\subsection*{{{}}}\n", latex::text(&model.name));
    if let Some(source) = &model.source {
        text += &format!("{}.\n", latex::text(source));
    }
    text += &aligned(formula(item));
    let homogeneous = &derivation.homogeneous;
    let [u, v] = homogeneous.parameters().each_ref().map(|parameter| latex::name(parameter.name()));
    text += &format!("Homogeneous coordinates of degree ${}$ in $({u}, {v})$:\n", homogeneous.degree());
    text += &aligned(coordinates(homogeneous));
    text += &conditions(derived.conditions.as_ref(), &derivation.parameters);
    let field = &derivation.field;
    if !field.generators().is_empty() {
        let relation = |position: usize| {
            let generator = latex::poly(&Poly::generator(field, position));
            format!("{generator}^{{2}} = {}", latex::poly(&field.radicand(position)))
        };
        let relations: Vec<String> = (0..field.generators().len()).map(relation).collect();
        text += &format!("Over the number field with ${}$.\n", relations.join("$, $"));
    }
    match &derivation.geometry {
        Ok(geometry) => text += &differential_geometry(derived, geometry),
        Err(exhausted) => {
            text +=
                &format!("Normal and offset are undetermined: {}.\n", latex::text(&exhausted.to_string()));
        }
    }
    text
}

fn differential_geometry(derived: &Derived<'_>, geometry: &DifferentialGeometry) -> String {
    let derivation = &derived.derivation;
    let mut text = "Normal $\\mathbf R_u \\times \\mathbf R_v = c\\,\\mathbf N$:\n".to_owned();
    let normal = &geometry.normal;
    let mut lines: Vec<(String, Vec<String>)> = ["x", "y", "z"]
        .iter()
        .zip(normal.numerator())
        .map(|(axis, component)| {
            (format!("N_{axis}"), factored(&Factors::of(component, &derivation.parameters)))
        })
        .collect();
    lines.push(("c".to_owned(), vec![latex::fraction(&normal.factor().lowest_terms())]));
    text += &aligned(lines);
    match &geometry.offset {
        Offset::Rational(offset) => {
            text += &format!(
                "Rational offset at the distance ${}$, of degree ${}$:\n",
                latex::name(derivation.distance.name()),
                offset.degree()
            );
            text += &aligned(coordinates(offset));
            text += &conditions(derived.offset_conditions.as_ref(), &derivation.parameters);
        }
        Offset::Irrational { odd } => {
            text += "The offset is not rational, because of the factor\n";
            text += &aligned(vec![(String::new(), broken(&latex::terms(odd)))]);
        }
        Offset::SymbolicRadical { radicand, radical, surface } => {
            text += &format!(
                "Offset at the distance ${}$, rational with ${} = \\sqrt{{{}}}$, of degree ${}$:\n",
                latex::name(derivation.distance.name()),
                latex::name(radical.name()),
                latex::poly(radicand),
                surface.degree()
            );
            text += &aligned(coordinates(surface));
            text += &conditions(derived.offset_conditions.as_ref(), &derivation.parameters);
        }
        _ => {}
    }
    text
}

/// Where symbols change degrees: a sentence and its equations each.
fn conditions(conditions: Option<&Conditions>, parameters: &[Variable; 2]) -> String {
    let Some(conditions) = conditions else {
        return format!("The {UNDETERMINED}.\n");
    };
    let mut text = String::new();
    for statement in statements(conditions, parameters) {
        let several = statement.alternatives.len() > 1;
        for (number, alternative) in statement.alternatives.iter().enumerate() {
            let what = if number == 0 { latex::text(&statement.what) } else { "or".to_owned() };
            text += &format!("{what} {}\n", alternative.relation(several));
            text += &aligned(equations(alternative));
            for (number, exception) in alternative.unless.alternatives().iter().enumerate() {
                text += if number == 0 { "except perhaps where\n" } else { "or where\n" };
                text += &aligned(exception.iter().map(|poly| equation(poly, " = 0")).collect());
            }
        }
    }
    text
}

fn equations(alternative: &Alternative) -> Vec<(String, Vec<String>)> {
    match (&alternative.equations, &alternative.common_zero) {
        (Some(equations), _) => equations.iter().map(|poly| equation(poly, " = 0")).collect(),
        (None, Some((_, polynomials))) if polynomials.len() == 1 => {
            let end = "\\quad\\text{has a factor in common with X, Y and Z}";
            polynomials.iter().map(|poly| equation(poly, end)).collect()
        }
        (None, Some((parameter, polynomials))) => {
            let end = format!("\\quad\\text{{have a common zero in }}{}", latex::name(parameter.name()));
            let last = polynomials.len().saturating_sub(1);
            let lines = polynomials.iter().enumerate();
            lines.map(|(position, poly)| equation(poly, if position == last { &end } else { "," })).collect()
        }
        (None, None) => Vec::new(),
    }
}

/// The terms of a polynomial as lines without a left side, and what follows them.
fn equation(poly: &Poly, end: &str) -> (String, Vec<String>) {
    let mut lines = broken(&latex::terms(poly));
    if let Some(last) = lines.last_mut() {
        last.push_str(end);
    }
    (String::new(), lines)
}

/// The definitions of a sweep as pairs of a left side and the right side.
fn formula(item: &Item) -> Vec<(String, Vec<String>)> {
    let applied = |name: &str, parameters: &[&str]| {
        let parameters: Vec<String> = parameters.iter().map(|parameter| latex::name(parameter)).collect();
        if parameters.is_empty() {
            latex::name(name)
        } else {
            format!("{}({})", latex::name(name), parameters.join(", "))
        }
    };
    item.clauses
        .iter()
        .filter_map(|clause| match &clause.kind {
            ClauseKind::Let(definition) => {
                let parameters: Vec<&str> =
                    definition.parameters.iter().map(|name| name.value.as_str()).collect();
                Some((applied(&definition.name.value, &parameters), &definition.value))
            }
            ClauseKind::Curve(curve) => {
                Some((applied(&curve.name.value, &[&curve.parameter.value]), &curve.value))
            }
            ClauseKind::Surface(surface) => {
                Some((applied(&surface.name.value, &surface.parameter_names()), &surface.value))
            }
            _ => None,
        })
        .map(|(left, right)| (left, vec![latex::expression(right)]))
        .collect()
}

fn coordinates(homogeneous: &Homogeneous) -> Vec<(String, Vec<String>)> {
    let weight = Factors::of_weight(homogeneous);
    let others =
        homogeneous.coordinates().iter().skip(1).map(|poly| Factors::of(poly, homogeneous.parameters()));
    let all = std::iter::once(weight).chain(others);
    Homogeneous::NAMES
        .iter()
        .zip(all)
        .map(|(name, factors)| ((*name).to_owned(), factored(&factors)))
        .collect()
}

/// A product as lines: a factor that is long is broken between its terms.
fn factored(factors: &Factors) -> Vec<String> {
    let mut lines = vec![String::new()];
    let alone = factors.factors.is_empty() || (factors.factors.len() == 1 && factors.unit.is_one());
    let mut append = |mut pieces: Vec<String>| {
        if let (Some(line), false) = (lines.last_mut(), pieces.is_empty()) {
            line.push_str(&pieces.remove(0));
        }
        lines.extend(pieces);
    };
    let negative = factors.unit == Poly::integer(-1);
    let alone = alone && !negative;
    if factors.factors.is_empty() {
        append(broken(&latex::terms(&factors.unit)));
    } else if negative {
        append(vec!["-".to_owned()]);
    } else if !factors.unit.is_one() {
        append(enclosed(&factors.unit, 1));
    }
    for (factor, exponent) in &factors.factors {
        let bare = alone && *exponent == 1;
        append(if bare { broken(&latex::terms(factor)) } else { enclosed(factor, *exponent) });
    }
    lines
}

/// A factor in parentheses where it needs them.
fn enclosed(poly: &Poly, exponent: u32) -> Vec<String> {
    let power = if exponent == 1 { String::new() } else { format!("^{{{exponent}}}") };
    let terms = latex::terms(poly);
    if terms.len() == 1
        && (exponent == 1 || poly.content().is_integer() && !terms[0].contains(['^', '\\', '-']))
    {
        return vec![format!("{}{power}", terms[0])];
    }
    let mut lines = broken(&terms);
    // \left and \right cannot stand on different lines of a formula.
    if let Some(first) = lines.first_mut() {
        first.insert_str(0, "\\bigl(");
    }
    if let Some(last) = lines.last_mut() {
        last.push_str(&format!("\\bigr){power}"));
    }
    lines
}

/// Terms with their signs, joined to lines of moderate length.
fn broken(terms: &[String]) -> Vec<String> {
    let mut lines = vec![String::new()];
    for term in terms {
        match lines.last_mut() {
            Some(line) if line.len() + term.len() <= LINE || line.is_empty() => line.push_str(term),
            _ => lines.push(term.trim_start().to_owned()),
        }
    }
    lines
}

fn aligned(equations: Vec<(String, Vec<String>)>) -> String {
    let equations = equations.into_iter().map(|(left, right)| {
        let relation = if left.is_empty() { "&" } else { " &= " };
        format!("  {left}{relation}{}", right.join(" \\\\\n  &\\quad "))
    });
    format!("\\begin{{align*}}\n{}\n\\end{{align*}}\n", equations.collect::<Vec<_>>().join(" \\\\\n"))
}
