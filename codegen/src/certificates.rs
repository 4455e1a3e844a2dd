//! Sentences on where a surface has no point or no normal.

use hodograph_algebra::{
    BoxSign, EdgeZeros, Essentials, Interval, Point, Poly, Rational, RealRoot, Variable, ZeroCurve, ZeroSet,
    budget, ratio,
};

/// The units of work that the zeros of one polynomial may take.
const LIMIT: u64 = 5_000_000;

/// The longest number, and the longest polynomial, that documentation shows.
const LONGEST: [usize; 2] = [40, 120];

/// How many points, lines and curves documentation shows.
const MOST: usize = 6;

/// What is said of zeros that were not found.
const UNDETERMINED: &str = "not determined within the budget";

/// Where the surface has no poles and no singular points, or where those are. The surface `is_regular` if it is known already that
/// the numerator of the normal does not vanish.
pub(crate) fn certificates(derivation: &Essentials, is_regular: bool) -> Vec<String> {
    let Essentials { parameters, domain, .. } = derivation;
    let region: Vec<(Variable, Interval)> = parameters.iter().cloned().zip(domain.iter().cloned()).collect();
    let weight = &derivation.homogeneous.coordinates()[0];
    let has_sign = |poly: &Poly| matches!(poly.sign_on(&region), Some(BoxSign::Positive | BoxSign::Negative));
    let has_poles = !has_sign(weight);
    let mut lines = vec![if has_poles {
        let poles = budget::with_budget(LIMIT, || weight.zeros_on(&region)).ok().flatten();
        format!("Poles on the domain, where W = 0: {}.", text(&[poles], &region))
    } else {
        "W ≠ 0 on the domain: certified.".to_string()
    }];
    let Some(normal) = &derivation.normal else { return lines };
    let mut sets = Vec::new();
    if derivation.orientation.is_some() {
        sets.push(normal.factor_zeros(weight, parameters, domain, LIMIT));
    }
    if !is_regular {
        let zeros = normal.zeros(weight, parameters, domain, LIMIT);
        sets.push(match sets.first() {
            Some(Some(known)) => zeros.map(|zeros| zeros.without(known)),
            _ => zeros,
        });
    }
    let are_none = sets.iter().all(|set| set.as_ref().is_some_and(ZeroSet::is_empty));
    lines.push(if are_none && !has_poles {
        "R_u × R_v ≠ 0 on the domain: certified.".to_string()
    } else {
        format!("Singular points on the domain, where R_u × R_v = 0: {}.", text(&sets, &region))
    });
    if derivation.orientation.is_some() && is_regular && !are_none {
        lines.push("Bounds of what has no value at singular points hold at all others.".to_string());
    }
    lines
}

/// The zeros of several polynomials, or that there are none, or that they are not known.
fn text(sets: &[Option<ZeroSet>], region: &[(Variable, Interval)]) -> String {
    let known = || sets.iter().flatten();
    let mut parts: Vec<String> = known().flat_map(|zeros| zeros.lines.iter().map(line)).collect();
    parts.extend(known().flat_map(|zeros| zeros.points.iter().map(point)));
    let names = || region.iter().map(|(variable, _)| variable);
    let on_line = |edge: &EdgeZeros| -> Vec<String> {
        edge.roots.iter().map(|root| place(names(), "≈", &on(edge, root, region))).collect()
    };
    parts.extend(known().flat_map(|zeros| zeros.roots.iter().flat_map(on_line)));
    parts.extend(known().flat_map(|zeros| zeros.curves.iter().map(|zeros| curve(zeros, region))));
    if parts.len() > MOST {
        let others = parts.len() - MOST;
        parts.truncate(MOST);
        parts.push(format!("and {others} more, which `hodograph derive` lists"));
    }
    if sets.iter().any(Option::is_none) {
        parts.push(if parts.is_empty() {
            UNDETERMINED.to_string()
        } else {
            format!("others {UNDETERMINED}")
        });
    }
    if parts.is_empty() { "none".to_string() } else { parts.join("; ") }
}

fn line(root: &RealRoot) -> String {
    let exact = root.exact().map(Poly::to_string).filter(|text| text.len() <= LONGEST[0]);
    exact.map_or_else(
        || format!("{} ≈ {}", root.variable(), decimal(root.to_decimal(DIGITS))),
        |exact| format!("{} = {exact}", root.variable()),
    )
}

fn point(point: &Point) -> String {
    let values: Vec<String> = point.values().map(Poly::to_string).collect();
    if values.iter().all(|value| value.len() <= LONGEST[0]) {
        place(point.keys(), "=", &values)
    } else {
        let values: Vec<String> = point.values().map(|value| decimal(value.to_decimal(DIGITS))).collect();
        place(point.keys(), "≈", &values)
    }
}

fn place<'a>(variables: impl Iterator<Item = &'a Variable>, sign: &str, values: &[String]) -> String {
    let names: Vec<&str> = variables.map(Variable::name).collect();
    format!("({}) {sign} ({})", names.join(", "), values.join(", "))
}

/// The equation of a curve, or its degrees and a point of it.
fn curve(curve: &ZeroCurve, region: &[(Variable, Interval)]) -> String {
    let text = curve.polynomial.to_string();
    let is_short = text.len() <= LONGEST[1];
    if curve.crossing.is_none() {
        return if is_short {
            format!("{text} = 0 (undecided)")
        } else {
            "where a polynomial vanishes that `hodograph derive` prints, if anywhere (undecided)".to_string()
        };
    }
    if is_short {
        return format!("{text} = 0");
    }
    let degrees = region.iter().map(|(variable, _)| curve.polynomial.degree(variable).unwrap_or(0));
    let degrees: Vec<String> = degrees.map(|degree| degree.to_string()).collect();
    let through = some_point(curve, region).map_or_else(String::new, |values| {
        format!(" through {}", place(region.iter().map(|(variable, _)| variable), "≈", &values))
    });
    format!("a curve of degree ({}){through}, whose equation `hodograph derive` prints", degrees.join(", "))
}

/// How many digits of a number are shown that is not shown exactly.
const DIGITS: u32 = 6;

/// A point of a curve, as decimals: on the boundary of the box, or between two points where the polynomial has different signs.
fn some_point(curve: &ZeroCurve, region: &[(Variable, Interval)]) -> Option<Vec<String>> {
    for edge in &curve.edges {
        if let Some(root) = edge.roots.first() {
            return Some(on(edge, root, region));
        }
    }
    let (positive, negative) = curve.crossing.as_ref()?;
    let along = Variable::new(2, "t");
    let segment = |(variable, interval): &(Variable, Interval)| {
        let end = |point: &Point| point.get(variable).unwrap_or(interval.lower()).clone();
        let (from, to) = (end(positive), end(negative));
        (variable.clone(), (to - &from) * Poly::variable(&along) + from)
    };
    let segment: Point = region.iter().map(segment).collect();
    let root =
        curve.polynomial.evaluate(&segment).real_roots_in(&along, &Interval::unit())?.into_iter().next()?;
    let enclosure = root.enclosure(64);
    let middle: Rational = (enclosure.lower() + enclosure.upper()) * ratio(1, 2);
    let value = |(variable, _): &(Variable, Interval)| {
        decimal(segment[variable].at(&[(&along, &middle)]).to_decimal(DIGITS))
    };
    Some(region.iter().map(value).collect())
}

/// A point on a line, as decimals.
fn on(edge: &EdgeZeros, root: &RealRoot, region: &[(Variable, Interval)]) -> Vec<String> {
    let value = |(variable, _): &(Variable, Interval)| {
        let is_fixed = *variable == edge.fixed;
        decimal(if is_fixed { edge.value.to_decimal(DIGITS) } else { root.to_decimal(DIGITS) })
    };
    region.iter().map(value).collect()
}

/// A decimal without zeros at its end.
fn decimal(text: String) -> String {
    if !text.contains('.') {
        return text;
    }
    match text.trim_end_matches('0').trim_end_matches('.') {
        "-0" => "0".to_string(),
        short => short.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::certificates;
    use crate::language::parse_text;
    use crate::meaning::models;

    /// The certificates of a surface.
    fn of(text: &str) -> Vec<String> {
        let (file, _source) = parse_text("sweep", &format!("sweep example {{ {text} }}")).unwrap();
        let (models, _) = models(&file);
        certificates(&models[0].surface.as_ref().unwrap().essentials().unwrap(), false)
    }

    #[test]
    fn zeros_of_the_factor_and_of_the_normal_are_listed() {
        assert_eq!(
            of("surface R = ((u^2 - 3/2*u)*v, u^2 - 3/2*u, v^2); domain u in -1/2..1, v in -1..1;"),
            [
                "W ≠ 0 on the domain: certified.",
                "Singular points on the domain, where R_u × R_v = 0: u = 3/4; (u, v) = (0, 0)."
            ]
        );
        assert_eq!(
            of("surface R = (u, v, u*v); domain u in 0..1, v in 0..1;"),
            ["W ≠ 0 on the domain: certified.", "R_u × R_v ≠ 0 on the domain: certified."]
        );
    }

    #[test]
    fn poles_are_no_singular_points() {
        assert_eq!(
            of("surface R = (u/v, (1 + u^2)/(u + v), v); domain u in 0..1, v in 0..1;"),
            [
                "Poles on the domain, where W = 0: v = 0.",
                "Singular points on the domain, where R_u × R_v = 0: none."
            ]
        );
        assert_eq!(
            of("surface R = (u/(v - 1/3), v^2/(u*u + (v - 1/3)), u); domain u in -1..1, v in 0..1;")[1],
            "Singular points on the domain, where R_u × R_v = 0: (u, v) = (0, 0); (u, v) = (0, 2/3)."
        );
        // A cubic root.
        assert_eq!(
            of("surface R = (u, v^2, (u^3 - 1/2)*v); domain u in 0..1, v in -1..1;")[1],
            "Singular points on the domain, where R_u × R_v = 0: (u, v) ≈ (0.793701, 0)."
        );
    }

    #[test]
    fn what_is_too_long_is_described() {
        let tube =
            "profile p(u) = (1 - u^2)/(1 + u^2)*i + 2*u/(1 + u^2)*k; path s(v) = ph([1, 2 + I, 1/3 - 2*I]);
            surface R = s + p.x*s.normal + p.z*k;";
        assert_eq!(
            of(&format!("{tube} domain u in -1..1, v in 0..1;"))[1],
            "Singular points on the domain, where R_u × R_v = 0: a curve of degree (2, 8) through (u, v) ≈ (-0.112346, 1), whose \
             equation `hodograph derive` prints."
        );
        // A closed curve, of which only a point between a positive and a negative value is known: z = x_u·f with f_u = f·x_u.
        let closed = of("surface R = (0, v, u*(u^2/3 + v^2 - 1/4) + u*(u^18/19 + 3*v^16 + v^12/7 + v^10/13 + 2*v^8/5 + v^4/9 + v^6/11));
            domain u in -1..1, v in -1..1;");
        assert!(closed[1].contains(": a curve of degree (18, 16) through (u, v) ≈ ("), "{}", closed[1]);
    }
}
