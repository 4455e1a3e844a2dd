//! Members: `s.normal`, `p.x`, `R.X`.

use std::rc::Rc;

use hodograph_algebra::{Curve, Fraction, SweptSurface, Vector};

use super::fault::Fault;
use super::scope::{COORDINATES, Scope};
use super::spatial::{FrameValue, quaternion_member};
use super::surfaces;
use super::value::{ComplexFraction, Value};
use crate::language::ast::{Expr, Name};
use crate::language::{Span, closest};

/// The members of curves.
const CURVE_MEMBERS: &[&str] = &[
    "arclength",
    "axis",
    "curvature",
    "evolute",
    "frame",
    "frenet",
    "hodograph",
    "involute",
    "length",
    "normal",
    "offset",
    "preimage",
    "rmf",
    "speed",
    "tangent",
    "torsion",
    "x",
    "y",
    "z",
];

/// The members of surfaces.
const SURFACE_MEMBERS: &[&str] =
    &["E", "F", "G", "H", "K", "L", "M", "N", "W", "X", "Y", "Z", "unit_normal", "x", "y", "z"];

/// The value of `object.member`.
pub(super) fn member(scope: &Scope, span: Span, object: &Expr, member: &Name) -> Result<Value, Fault> {
    let value = scope.evaluate(object)?;
    let name = member.value.as_str();
    if surfaces::is_form(name) && surfaces::may_be_surface(&value) {
        return surfaces::form(scope, object.span(), &value, name);
    }
    match value.bare() {
        Value::Curve(curve) => curve_member(curve, span, member),
        Value::Motion(motion) => super::frames::member(motion, span, member),
        Value::Quaternion(value) => quaternion_member(value, member),
        Value::AdaptedFrame(frame) => frame.member(span, member, None),
        Value::Surface(surface) => surface_member(surface, member),
        Value::Offset(offset) => match offset.as_ref() {
            Ok(surface) => surface_member(surface, member),
            Err(error) => Err(Fault::offset(object.span(), error)),
        },
        Value::Tuple(parts) if parts.len() == COORDINATES.len() => match coordinate(name) {
            Some(index) => Ok(Value::Scalar(parts[index].clone())),
            None => Err(no_member(member, "a list of homogeneous coordinates", &COORDINATES)),
        },
        other => match (component(name), other.vector()) {
            (Some(axis), Some(vector)) => Ok(Value::Scalar(vector.components()[axis].clone())),
            (_, Some(_)) => Err(no_member(member, "a vector", &["x", "y", "z"])),
            _ => {
                let message = format!("{} has no members", other.kind());
                Err(Fault::new(member.span, message)
                    .help("curves, vectors of rational functions and surfaces have members"))
            }
        },
    }
}

fn component(name: &str) -> Option<usize> {
    ["x", "y", "z"].iter().position(|known| *known == name)
}

fn coordinate(name: &str) -> Option<usize> {
    COORDINATES.iter().position(|known| *known == name)
}

fn curve_member(curve: &Rc<Curve>, span: Span, member: &Name) -> Result<Value, Fault> {
    let name = member.value.as_str();
    if let Some(axis) = component(name) {
        return Ok(Value::Scalar(curve.position().components()[axis].clone()));
    }
    if let Some(frame) = FrameValue::named(curve, name) {
        return Ok(Value::AdaptedFrame(Rc::new(frame)));
    }
    let scalar = |value: Result<Fraction, _>| value.map(Value::Scalar);
    let vector = |value: Result<Vector, _>| value.map(Value::Vector);
    let value = match name {
        "speed" => scalar(curve.speed()),
        "curvature" => scalar(curve.curvature()),
        "arclength" => scalar(curve.arclength()),
        "length" => scalar(curve.length()),
        "hodograph" => Ok(Value::Vector(curve.hodograph().clone())),
        "tangent" => vector(curve.tangent()),
        "normal" => vector(curve.normal()),
        "axis" => vector(curve.axis()),
        "involute" => vector(curve.involute()),
        "evolute" => vector(curve.evolute()),
        "torsion" => scalar(curve.torsion()),
        "preimage" => Ok(match (curve.quaternion(), curve.preimage()) {
            (Some(quaternion), _) => Value::Quaternion(quaternion.clone()),
            (None, Some([a, b])) => {
                Value::Complex(ComplexFraction { re: a.clone().into(), im: b.clone().into() })
            }
            (None, None) => {
                let fault = Fault::new(span, "this curve was not made from a preimage");
                return Err(fault.help("`ph`, `ph_hermite`, `ph_spatial` and `rrmf` make curves from one"));
            }
        }),
        "offset" => {
            let fault = Fault::new(span, "`offset` needs the distance");
            return Err(fault.help("write `s.offset(d)`"));
        }
        _ => return Err(no_member(member, "a curve", CURVE_MEMBERS)),
    };
    value.map_err(|error| Fault::curve(span, &error))
}

fn surface_member(surface: &SweptSurface, member: &Name) -> Result<Value, Fault> {
    let name = member.value.as_str();
    if let Some(axis) = component(name) {
        return Ok(Value::Scalar(surface.position().components()[axis].clone()));
    }
    match coordinate(name) {
        Some(index) => Ok(Value::Scalar(surface.homogeneous().coordinates()[index].clone().into())),
        None => Err(no_member(member, "a surface", SURFACE_MEMBERS)),
    }
}

pub(super) fn no_member(member: &Name, kind: &str, known: &[&str]) -> Fault {
    let name = &member.value;
    let fault = Fault::new(member.span, format!("{kind} has no member `{name}`"));
    match closest(name, known.iter().copied()) {
        Some(similar) => fault.help(format!("did you mean `{similar}`?")),
        None => fault.help(format!("it has {}", known.join(", "))),
    }
}
