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
//! The square root of a polynomial in the symbols, in offsets, is a generator whose `approximation` is `null`.

use hodograph_algebra::{Bidegree, Conditions, Derivation, Homogeneous, Offset, Poly, Variable};
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
    normal: Normal,
    speeds: Speeds,
    singular: Singular<'a>,
    offset: OffsetSurface,
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
    let [speed_u, speed_v] = derivation.speeds.each_ref().map(ToString::to_string);
    let net = &derivation.control_net;
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
        normal: Normal {
            numerator: derivation.normal.numerator().each_ref().map(Poly::to_string),
            norm_squared: norm_squared(derivation),
            rational: derivation.normal.is_rational(),
        },
        speeds: Speeds { u: speed_u, v: speed_v },
        singular: Singular {
            factor: derivation.singular.factor.to_string(),
            zeros: &derivation.singular_zeros,
        },
        offset: OffsetSurface {
            rational: derivation.offset.is_rational(),
            homogeneous: match &derivation.offset {
                Offset::Rational(offset) | Offset::SymbolicRadical { surface: offset, .. } => {
                    Some(coordinates(offset))
                }
                _ => None,
            },
            conditions: conditions(derived.offset_conditions.as_ref(), &derivation.parameters),
            reason: offset_reason(derivation, Poly::to_string),
        },
        control_net: Some(Net {
            degree: net.degree,
            points: net.points.iter().flatten().map(|point| point.each_ref().map(Poly::to_string)).collect(),
        }),
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
    if let Offset::SymbolicRadical { radicand, radical, .. } = &derivation.offset {
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

/// `|N|²`, as a sum of squares where it is too large to be multiplied out.
fn norm_squared(derivation: &Derivation) -> String {
    let squared = derivation.normal.squared_length();
    match squared.expanded() {
        Some(square) => square.to_string(),
        None => squared.sum_of_squares(),
    }
}
