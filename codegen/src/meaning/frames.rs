//! Frames and motions through them: `frame(…)`, `frames([…])`, `frames_file("…")`, and the members of motions.

use std::rc::Rc;

use hodograph_algebra::{
    Fraction, Frame, Lift, Motion, MotionEnds, MotionError, MotionOptions, MotionSegment, Orientation, Poly,
    Smoothness,
};

use super::calls::Call;
use super::fault::Fault;
use super::frames_file;
use super::pieces::Joints;
use super::scope::Scope;
use super::value::Value;
use crate::language::ast::{Argument, Expr, ExprKind, Name};
use crate::language::{Span, closest};

/// The members of motions that are values.
const MEMBERS: &[&str] = &["curve", "position", "quaternion", "scale", "weight"];

/// The members of motions that take a point or a curve.
const METHODS: &[&str] = &["published", "rotate", "sweep"];

/// `frame(position, quaternion)` and `frame(position, quaternion, scale)`.
pub(super) fn frame(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let (positional, []) = call.with_names([])?;
    let (position, quaternion, scale) = match positional.as_slice() {
        [position, quaternion] => (*position, *quaternion, None),
        [position, quaternion, scale] => (*position, *quaternion, Some(*scale)),
        _ => {
            let fault = Fault::new(call.span, "`frame` takes a position, a quaternion and perhaps a scale");
            return Err(fault.help("write `frame((0, 0, 0), (1, 0, 0, 0))`"));
        }
    };
    let numbers = |expr: &Expr, parts: Vec<Fraction>, role: &str| {
        let number = |part: Fraction| {
            part.to_number().ok_or_else(|| {
                let message = format!("{role} consists of numbers, but {part} is none");
                Fault::new(expr.span(), message)
            })
        };
        parts.into_iter().map(number).collect::<Result<Vec<Poly>, Fault>>()
    };
    let role = "the position of a frame";
    let place = numbers(position, call.vector(position)?.components().to_vec(), role)?;
    let value = scope.evaluate(quaternion)?;
    let role = "the quaternion of a frame";
    let parts = match value.bare() {
        Value::Tuple(parts) if parts.len() == 4 => numbers(quaternion, parts.clone(), role)?,
        Value::Quaternion(parts) => numbers(quaternion, parts.components().to_vec(), role)?,
        other => {
            let message = format!("{role} has four parts, but this is {}", other.kind());
            return Err(Fault::new(quaternion.span(), message).help("write `quat(w, x, y, z)`"));
        }
    };
    let scale = match scale {
        Some(scale) => scope.number(scale, "the scale of a frame")?,
        None => Poly::one(),
    };
    let wrong = || Fault::new(call.span, "a frame has three coordinates and a quaternion of four parts");
    Ok(Value::Frame(Rc::new(Frame {
        position: place.try_into().map_err(|_| wrong())?,
        quaternion: parts.try_into().map_err(|_| wrong())?,
        scale,
    })))
}

/// `frames([frame(…), …], …)` and `frames_file("…", …)`: the segment of the motion that is evaluated.
pub(super) fn motion(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let Some(context) = &scope.curve else {
        let fault = Fault::new(call.span, format!("`{}` makes a motion", call.name));
        return Err(fault.help(format!("define it first: `frames F(v) = {}(…);`", call.name)));
    };
    let (positional, named) = call.with_names(OPTIONS)?;
    let [argument] = positional.as_slice() else {
        let what = if call.name == "frames" { "a list of frames" } else { "the name of a file" };
        return Err(Fault::new(call.span, format!("`{}` takes {what}", call.name)));
    };
    let options = options(scope, named)?;
    let motion = if call.name == "frames" {
        let frames = listed(scope, argument)?;
        Motion::through(&frames, &options).map_err(|error| {
            let element = error.frame().and_then(|frame| argument.children().nth(frame));
            fault(element.map_or(argument.span(), Expr::span), &error)
        })?
    } else {
        frames_file::motion(scope, argument, &options)?
    };
    let joints = Joints { parameter: context.parameter.clone(), knots: motion.knots().into() };
    if let Some(known) = &scope.joints
        && *known != joints
    {
        let fault = Fault::new(call.span, "these frames have other knots than those before them");
        return Err(fault.help("all frames of one item have one parameter and the same knots"));
    }
    let index = scope.segment.min(motion.segment_count() - 1);
    let segment = motion.segment(index, &context.parameter);
    scope.announce_joints(joints);
    Ok(Value::Motion(Rc::new(segment)))
}

/// A mistake in a motion, at its place.
pub(super) fn fault(span: Span, error: &MotionError) -> Fault {
    let help = match error {
        MotionError::NotUnit { .. } => {
            "divide it by its length, or add `normalize = yes`, which may adjoin square roots"
        }
        MotionError::ZeroQuaternion { .. } => "the quaternion (1, 0, 0, 0) leaves a curve as it is",
        MotionError::Repeated { .. } => "leave one of them out",
        MotionError::TooMany(_) => "split the motion into several sweeps",
        MotionError::KnotCount { .. } => "give one knot for each frame",
        MotionError::KnotOrder { .. } => "knots increase from frame to frame",
        MotionError::Open => "end with the first frame once more, or write `end = natural`",
        MotionError::OppositeSheet => "write `orientation = direct`, which closes with the opposite sign",
        MotionError::Ends => "write `continuity = 2`, or `end = natural` without `tangents`",
        _ => "",
    };
    let fault = Fault::new(span, error.to_string());
    if help.is_empty() { fault } else { fault.help(help) }
}

fn listed(scope: &Scope, list: &Expr) -> Result<Vec<Frame>, Fault> {
    let (Value::List(values), ExprKind::Array(parts)) = (scope.evaluate(list)?, list.kind()) else {
        let fault = Fault::new(list.span(), "the frames must be a list");
        return Err(fault.help("write `frames([frame((0, 0, 0), (1, 0, 0, 0)), …])`"));
    };
    let frame = |(value, part): (&Value, &Expr)| match value.bare() {
        Value::Frame(frame) => Ok(Frame::clone(frame)),
        other => {
            let fault =
                Fault::new(part.span(), format!("a frame is expected here, but this is {}", other.kind()));
            Err(fault.help("write `frame((0, 0, 0), (1, 0, 0, 0))`"))
        }
    };
    values.iter().zip(parts).map(frame).collect()
}

const OPTIONS: [&str; 7] = ["knots", "end", "tangents", "continuity", "orientation", "preimage", "normalize"];

fn options(scope: &Scope, named: [Option<&Expr>; 7]) -> Result<MotionOptions, Fault> {
    let [knots, end, tangents, continuity, orientation, preimage, normalize] = named;
    let mut options = MotionOptions::default();
    if let Some(knots) = knots {
        let (Value::List(_), ExprKind::Array(parts)) = (scope.evaluate(knots)?, knots.kind()) else {
            return Err(
                Fault::new(knots.span(), "the knots must be a list").help("write `knots = [0, 1, 2]`")
            );
        };
        let numbers = parts.iter().map(|part| scope.number(part, "a knot"));
        options.knots = Some(numbers.collect::<Result<_, _>>()?);
    }
    if let Some(tangents) = tangents {
        let ExprKind::Array(parts) = tangents.kind() else {
            return Err(Fault::new(tangents.span(), "the tangents must be a list")
                .help("write `tangents = [(1, 0, 0), (0, 1, 0)]`"));
        };
        let [start, end] = parts.as_slice() else {
            return Err(Fault::new(tangents.span(), "there is one tangent at each end: two in all"));
        };
        options.tangents = Some([tangent(scope, start)?, tangent(scope, end)?]);
    }
    if let Some(continuity) = continuity {
        options.smoothness = smoothness(scope, continuity)?;
    }
    if let Some(end) = end {
        let known = [
            ("natural", MotionEnds::Natural),
            ("rest", MotionEnds::AtRest),
            ("periodic", MotionEnds::Periodic),
        ];
        options.ends = choice(end, &known)?;
    }
    if let Some(orientation) = orientation {
        options.orientation =
            choice(orientation, &[("sphere", Orientation::Sphere), ("direct", Orientation::Direct)])?;
    }
    if let Some(preimage) = preimage {
        options.lift = choice(
            preimage,
            &[("projective", Lift::Projective), ("unit", Lift::Unit), ("positive", Lift::Positive)],
        )?;
    }
    if let Some(normalize) = normalize {
        options.normalize = choice(normalize, &[("yes", true), ("no", false)])?;
    }
    Ok(options)
}

/// One of several words.
fn choice<T: Copy>(expr: &Expr, known: &[(&str, T)]) -> Result<T, Fault> {
    let word = if let ExprKind::Ident(word) = expr.kind() { word.as_str() } else { "" };
    if let Some((_, value)) = known.iter().find(|(name, _)| *name == word) {
        return Ok(*value);
    }
    let names: Vec<String> = known.iter().map(|(name, _)| format!("`{name}`")).collect();
    Err(Fault::new(expr.span(), format!("expected {}", names.join(" or "))))
}

fn tangent(scope: &Scope, expr: &Expr) -> Result<[Poly; 3], Fault> {
    let value = scope.evaluate(expr)?;
    let parts = value.vector().map(|vector| vector.components().each_ref().map(Fraction::to_number));
    match parts {
        Some([Some(x), Some(y), Some(z)]) => Ok([x, y, z]),
        _ => Err(Fault::new(
            expr.span(),
            format!("a tangent is a vector of numbers, but this is {}", value.kind()),
        )),
    }
}

/// `continuity = 2` or `continuity = (2, 1, 2)` for position, orientation and scale.
fn smoothness(scope: &Scope, expr: &Expr) -> Result<[Smoothness; 3], Fault> {
    let value = scope.evaluate(expr)?;
    let parts = match value.bare() {
        Value::Tuple(parts) if parts.len() == 3 => parts.clone(),
        Value::Scalar(order) => vec![order.clone(), order.clone(), order.clone()],
        _ => Vec::new(),
    };
    let orders = parts.iter().map(|part| match part.to_rational()?.to_integer().small() {
        Some(1) if part.to_rational()?.is_integer() => Some(Smoothness::Quadratic),
        Some(2) if part.to_rational()?.is_integer() => Some(Smoothness::Cubic),
        _ => None,
    });
    let orders: Option<Vec<Smoothness>> = orders.collect();
    orders.and_then(|orders| orders.try_into().ok()).ok_or_else(|| {
        let fault = Fault::new(expr.span(), "the order of continuity is 1 or 2");
        fault.help(
            "write `continuity = 1`, or one order each for position, orientation and scale: `(2, 1, 2)`",
        )
    })
}

/// The value of `F.member`.
pub(super) fn member(motion: &MotionSegment, span: Span, member: &Name) -> Result<Value, Fault> {
    let name = member.value.as_str();
    let tuple = |parts: &[Fraction]| Value::Tuple(parts.to_vec());
    match name {
        "position" => Ok(Value::Vector(motion.position())),
        "scale" => Ok(Value::Scalar(motion.scale())),
        "quaternion" => Ok(Value::Quaternion(motion.quaternion())),
        "curve" => Ok(tuple(motion.curve().components())),
        "weight" => Ok(Value::Scalar(motion.weight().into())),
        _ if METHODS.contains(&name) => {
            let fault = Fault::new(span, format!("`{name}` needs the curve that is moved"));
            Err(fault.help(format!("write `F.{name}(c)`")))
        }
        _ => {
            let known = MEMBERS.iter().chain(METHODS);
            let fault = Fault::new(member.span, format!("a motion has no member `{name}`"));
            Err(match closest(name, known.clone().copied()) {
                Some(similar) => fault.help(format!("did you mean `{similar}`?")),
                None => fault.help(format!("it has {}", known.copied().collect::<Vec<_>>().join(", "))),
            })
        }
    }
}

/// The value of `F.sweep(c)` and its kin; `None` if there is no such method.
pub(super) fn method(
    scope: &Scope,
    motion: &MotionSegment,
    span: Span,
    name: &str,
    arguments: &[Argument],
) -> Option<Result<Value, Fault>> {
    let apply: fn(&MotionSegment, &hodograph_algebra::Vector) -> hodograph_algebra::Vector = match name {
        "sweep" => MotionSegment::sweep,
        "rotate" => MotionSegment::rotate,
        "published" => MotionSegment::published,
        _ => return None,
    };
    let call = Call { scope, span, name, arguments };
    let moved = call.positional().and_then(|[curve]: [&Expr; 1]| call.vector(curve));
    Some(moved.map(|curve| Value::Vector(apply(motion, &curve))))
}
