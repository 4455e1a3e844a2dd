//! Derivations for programs.
//!
//! `conditions` lists where the symbols, which are real, change what is stated of degrees: `{"what", "where", "common_zero",
//! "exact", "unless"}`. It happens (`what`) where the polynomials of `where` vanish together; entries with the same `what`
//! are alternatives. For a common factor of W, X, Y, Z, `common_zero` is `{"parameter", "polynomials"}`: it exists where
//! these polynomials have a common zero, real or complex, in the parameter, or, if it is a single polynomial, where X, Y and Z
//! have a factor in common with this one; `where`, from which the parameter is eliminated, is `null` where that takes too
//! much work. `exact` is false if it happens nowhere else but perhaps not everywhere there; where the polynomials of a list
//! in `unless` vanish together, it may or may not happen. What happens only where W vanishes identically is left out.
//! `conditions` is `null` if the budget does not suffice, and `[]` without symbols. The offset has its own, in which its
//! distance is one more symbol.
//!
//! Where the budget does not suffice, `normal`, `speeds`, `singular` and `offset` are `null`, or `control_net` is, and `undetermined`
//! lists how far these computations came; else it is absent.
//!
//! The square root of a polynomial in the symbols, in offsets, is a generator whose `approximation` is `null`.

use hodograph_algebra::{
    Bidegree, Conditions, Derivation, DifferentialGeometry, Homogeneous, Offset, Poly, Variable,
};
use serde::Serialize;

use super::conditions::{Alternative, statements};
use super::{APPROXIMATION_DIGITS, Derived, offset_reason};
use crate::decimal::significant;

#[derive(Serialize)]
struct Output<'a> {
    schema: u32,
    sweeps: Vec<Sweep<'a>>,
}

#[derive(Serialize)]
struct Sweep<'a> {
    name: &'a str,
    source: Option<&'a str>,
    parameters: [&'a str; 2],
    symbols: Vec<&'a str>,
    field: Field,
    homogeneous: Coordinates,
    degree: [i64; 2],
    raw_degree: [i64; 2],
    common_factor: String,
    conditions: Option<Vec<Condition>>,
    normal: Option<Normal>,
    speeds: Option<Speeds>,
    singular: Option<Singular<'a>>,
    offset: Option<OffsetSurface>,
    /// Why some are `null`.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    undetermined: Vec<String>,
    control_net: Option<Net>,
}

#[derive(Serialize)]
struct Field {
    degree: u64,
    generators: Vec<Generator>,
}

#[derive(Serialize)]
struct Generator {
    symbol: String,
    relation: String,
    approximation: Option<String>,
}

#[derive(Serialize)]
#[serde(rename_all = "UPPERCASE")]
struct Coordinates {
    w: Coordinate,
    x: Coordinate,
    y: Coordinate,
    z: Coordinate,
}

#[derive(Serialize)]
struct Coordinate {
    degree: [i64; 2],
    terms: usize,
    polynomial: String,
}

#[derive(Serialize)]
struct Normal {
    numerator: [String; 3],
    norm_squared: String,
    rational: bool,
}

#[derive(Serialize)]
struct Speeds {
    u: String,
    v: String,
}

#[derive(Serialize)]
struct Singular<'a> {
    factor: String,
    zeros: &'a [String],
}

#[derive(Serialize)]
struct OffsetSurface {
    rational: bool,
    homogeneous: Option<Coordinates>,
    conditions: Option<Vec<Condition>>,
    reason: String,
}

/// What happens where polynomials in the symbols vanish together; entries that say the same are alternatives.
#[derive(Serialize)]
struct Condition {
    what: String,
    #[serde(rename = "where")]
    equations: Option<Vec<String>>,
    common_zero: Option<CommonZero>,
    exact: bool,
    unless: Vec<Vec<String>>,
}

#[derive(Serialize)]
struct CommonZero {
    parameter: String,
    polynomials: Vec<String>,
}

#[derive(Serialize)]
struct Net {
    degree: [u32; 2],
    points: Vec<[String; 4]>,
}

/// All derivations as JSON.
pub(super) fn output(all: &[Derived<'_>]) -> String {
    crate::layout::json(&Output { schema: 1, sweeps: all.iter().map(sweep).collect() })
}

fn sweep<'a>(derived: &'a Derived<'_>) -> Sweep<'a> {
    let Derived { model, derivation, .. } = derived;
    let homogeneous = &derivation.homogeneous;
    let geometry = derivation.geometry.as_ref();
    Sweep {
        name: &model.name,
        source: model.source.as_deref(),
        parameters: derivation.parameters.each_ref().map(|parameter| parameter.name()),
        symbols: derivation.symbols.iter().map(|symbol| symbol.name()).collect(),
        field: field(derivation),
        homogeneous: coordinates(homogeneous),
        degree: pair(homogeneous.degree()),
        raw_degree: pair(homogeneous.raw_degree()),
        common_factor: homogeneous.common_factor().to_string(),
        conditions: conditions(derived.conditions.as_ref(), &derivation.parameters),
        normal: geometry.ok().map(normal),
        speeds: geometry.ok().map(|geometry| {
            let [u, v] = geometry.speeds.each_ref().map(ToString::to_string);
            Speeds { u, v }
        }),
        singular: geometry.ok().map(|geometry| Singular {
            factor: geometry.singular.factor.to_string(),
            zeros: &geometry.singular_zeros,
        }),
        offset: geometry.ok().map(|geometry| offset(derived, geometry)),
        undetermined: geometry
            .err()
            .into_iter()
            .chain(derivation.control_net.as_ref().err())
            .map(ToString::to_string)
            .collect(),
        control_net: derivation.control_net.as_ref().ok().map(|net| Net {
            degree: net.degree,
            points: net.points.iter().flatten().map(|point| point.each_ref().map(Poly::to_string)).collect(),
        }),
    }
}

fn normal(geometry: &DifferentialGeometry) -> Normal {
    let normal = &geometry.normal;
    let squared = normal.squared_length();
    Normal {
        numerator: normal.numerator().each_ref().map(Poly::to_string),
        // A sum of squares where it is too large to be multiplied out.
        norm_squared: squared.expanded().map_or_else(|| squared.sum_of_squares(), ToString::to_string),
        rational: normal.is_rational(),
    }
}

fn offset(derived: &Derived<'_>, geometry: &DifferentialGeometry) -> OffsetSurface {
    OffsetSurface {
        rational: geometry.offset.is_rational(),
        homogeneous: match &geometry.offset {
            Offset::Rational(offset) | Offset::SymbolicRadical { surface: offset, .. } => {
                Some(coordinates(offset))
            }
            _ => None,
        },
        conditions: conditions(derived.offset_conditions.as_ref(), &derived.derivation.parameters),
        reason: offset_reason(geometry, &derived.derivation.distance, Poly::to_string),
    }
}

fn field(derivation: &Derivation) -> Field {
    let field = &derivation.field;
    let generator = |(position, generator): (usize, &hodograph_algebra::Generator)| Generator {
        symbol: generator.name().to_owned(),
        relation: field.relation(position).to_string(),
        approximation: Some(significant(&Poly::generator(field, position), APPROXIMATION_DIGITS)),
    };
    let mut degree = field.degree();
    let mut generators: Vec<Generator> = field.generators().iter().enumerate().map(generator).collect();
    // The root of a polynomial in the symbols is one more generator, with no value of its own.
    let offset = derivation.geometry.as_ref().map(|geometry| &geometry.offset);
    if let Ok(Offset::SymbolicRadical { radicand, radical, .. }) = offset {
        degree *= 2;
        generators.push(Generator {
            symbol: radical.to_string(),
            relation: (Poly::variable(radical).pow(2) - radicand).to_string(),
            approximation: None,
        });
    }
    Field { degree, generators }
}

fn coordinates(homogeneous: &Homogeneous) -> Coordinates {
    let one = |poly: &Poly| Coordinate {
        degree: pair(Bidegree::of(poly, homogeneous.parameters())),
        terms: poly.monomial_count(),
        polynomial: poly.to_string(),
    };
    let [w, x, y, z] = homogeneous.coordinates().each_ref().map(one);
    Coordinates { w, x, y, z }
}

fn conditions(conditions: Option<&Conditions>, parameters: &[Variable; 2]) -> Option<Vec<Condition>> {
    let texts = |polys: &[Poly]| polys.iter().map(Poly::to_string).collect::<Vec<String>>();
    let condition = |what: &str, alternative: &Alternative| Condition {
        what: what.to_owned(),
        equations: alternative.equations.as_deref().map(texts),
        common_zero: alternative.common_zero.as_ref().map(|(parameter, polynomials)| CommonZero {
            parameter: parameter.to_string(),
            polynomials: texts(polynomials),
        }),
        exact: alternative.exact,
        unless: alternative.unless.alternatives().iter().map(|all| texts(all)).collect(),
    };
    let statements = statements(conditions?, parameters);
    let entries = statements.iter().flat_map(|statement| {
        statement.alternatives.iter().map(|alternative| condition(&statement.what, alternative))
    });
    Some(entries.collect())
}

fn pair(degree: Bidegree) -> [i64; 2] {
    [degree.u, degree.v]
}
