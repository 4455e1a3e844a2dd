//! Derivations for programs.

use hodograph_algebra::{Bidegree, Derivation, Homogeneous, Offset, Poly};
use serde::Serialize;

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
    approximation: String,
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
    reason: String,
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
        normal: Normal {
            numerator: derivation.normal.numerator().each_ref().map(Poly::to_string),
            norm_squared: derivation.normal.norm_squared().to_string(),
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
                Offset::Rational(offset) => Some(coordinates(offset)),
                _ => None,
            },
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
        approximation: significant(&Poly::generator(field, position), APPROXIMATION_DIGITS),
    };
    Field {
        degree: field.degree(),
        generators: field.generators().iter().enumerate().map(generator).collect(),
    }
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

fn pair(degree: Bidegree) -> [i64; 2] {
    [degree.u, degree.v]
}
