//! Quaternions, spatial PH curves, their frames, and the surfaces around them.

use std::rc::Rc;

use hodograph_algebra::{
    AdaptedFrame, CanalError, Complex, Curve, CurveError, Fraction, KnownProperties, Poly, PreimageError,
    Quaternion, Rational, SpatialHermite, SpatialHermiteError, SpatialPreimage, Variable, Vector, integer,
};

use super::calls::Call;
use super::curves::{self, CurveContext};
use super::fault::Fault;
use super::functions::surface_parameters;
use super::group::CoefficientKind;
use super::members::no_member;
use super::scope::Scope;
use super::value::{ComplexFraction, Value};
use crate::language::Span;
use crate::language::ast::{Expr, Name};

/// The members of quaternions.
const QUATERNION_MEMBERS: &[&str] = &["vector", "w", "x", "y", "z"];

/// The members of frames.
const FRAME_MEMBERS: &[&str] = &["binormal", "f", "g", "normal", "preimage", "rotation", "spin", "tangent"];

/// A frame along a curve, which need not be rational.
#[derive(Clone, Debug)]
pub(super) struct FrameValue {
    /// The curve.
    pub(super) curve: Rc<Curve>,
    /// Which of its frames.
    pub(super) kind: FrameKind,
}

/// The frames that a curve has.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum FrameKind {
    EulerRodrigues,
    RotationMinimizing,
    Frenet,
}

impl FrameValue {
    /// The frame as a member of a curve: `frame`, `rmf` or `frenet`.
    pub(super) fn named(curve: &Rc<Curve>, member: &str) -> Option<FrameValue> {
        let kind = match member {
            "frame" => FrameKind::EulerRodrigues,
            "rmf" => FrameKind::RotationMinimizing,
            "frenet" => FrameKind::Frenet,
            _ => return None,
        };
        Some(FrameValue { curve: curve.clone(), kind })
    }

    /// The frame, if it is rational.
    pub(super) fn rational(&self) -> Result<AdaptedFrame, CurveError> {
        match self.kind {
            FrameKind::EulerRodrigues => self.curve.euler_rodrigues_frame(),
            FrameKind::RotationMinimizing => self.curve.rotation_minimizing_frame(),
            FrameKind::Frenet => self.curve.frenet_frame(),
        }
    }

    /// Member `member` of the frame, at a number `at` if that is given.
    pub(super) fn member(&self, span: Span, member: &Name, at: Option<&Poly>) -> Result<Value, Fault> {
        let fault = |error: CurveError| Fault::curve(span, &error);
        let name = member.value.as_str();
        let frenet = self.kind == FrameKind::Frenet;
        if !FRAME_MEMBERS.contains(&name) || (matches!(name, "normal" | "binormal") && !frenet) {
            let known: Vec<&str> = FRAME_MEMBERS.iter().copied().filter(|known| self.has(known)).collect();
            return Err(no_member(member, "this frame", &known));
        }
        // Rational also where the frame is not.
        if name == "spin" && frenet {
            return self.curve.frenet_spin().map(Value::Scalar).map_err(fault);
        }
        let pointwise = at.filter(|_| frenet).and_then(|value| self.curve.frenet_frame_at(value));
        let frame = match pointwise {
            Some(frame) => frame,
            None => self.rational().map_err(fault)?,
        };
        let value = match name {
            "tangent" => Some(Value::Vector(frame.tangent)),
            "f" | "normal" => Some(Value::Vector(frame.f)),
            "g" | "binormal" => Some(Value::Vector(frame.g)),
            "spin" => Some(Value::Scalar(frame.spin)),
            "preimage" => frame.quaternion.map(Value::Quaternion),
            _ => frame.rotation.map(|w| Value::Complex(ComplexFraction { re: w.re.into(), im: w.im.into() })),
        };
        value.ok_or_else(|| {
            let known: Vec<&str> = FRAME_MEMBERS.iter().copied().filter(|known| self.has(known)).collect();
            no_member(member, "this frame", &known)
        })
    }

    fn has(&self, member: &str) -> bool {
        match member {
            "normal" | "binormal" => self.kind == FrameKind::Frenet,
            "preimage" => self.kind != FrameKind::Frenet,
            "rotation" => self.kind == FrameKind::RotationMinimizing,
            _ => true,
        }
    }
}

/// The value of a member of a quaternion.
pub(super) fn quaternion_member(quaternion: &Quaternion, member: &Name) -> Result<Value, Fault> {
    let name = member.value.as_str();
    if name == "vector" {
        return Ok(Value::Vector(quaternion.vector()));
    }
    match ["w", "x", "y", "z"].iter().position(|known| *known == name) {
        Some(index) => Ok(Value::Scalar(quaternion.components()[index].clone())),
        None => Err(no_member(member, "a quaternion", QUATERNION_MEMBERS)),
    }
}

/// `quat(w, x, y, z)`.
pub(super) fn quaternion(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let parts = call.positional::<4>()?.map(|part| scope.scalar(part, "a component of a quaternion"));
    let [w, x, y, z] = parts;
    Ok(Value::Quaternion(Quaternion::new(w?, x?, y?, z?)))
}

/// The functions that make spatial curves.
pub(super) fn constructor(scope: &Scope, context: &CurveContext, call: &Call<'_>) -> Result<Value, Fault> {
    match call.name {
        "rrmf" => constrained(scope, context, call),
        "rrmf_hermite" => between(scope, context, call),
        _ => ph_spatial(scope, context, call),
    }
}

/// `ph_spatial([A0, …])` or `ph_spatial(n)`.
fn ph_spatial(scope: &Scope, context: &CurveContext, call: &Call<'_>) -> Result<Value, Fault> {
    let (positional, [start]) = call.with_names(["start"])?;
    let [argument] = positional.as_slice() else {
        let fault = Fault::new(call.span, "`ph_spatial` takes the preimage's coefficients, or a degree");
        return Err(fault.help("write `ph_spatial([A0, A1, A2])` or `ph_spatial(5)`"));
    };
    let preimage = match scope.evaluate(argument)? {
        Value::List(list) => {
            let coefficient = |(index, value): (usize, &Value)| {
                let span = curves::element(argument, index).unwrap_or(argument.span());
                constant_quaternion(scope, value, span)
            };
            SpatialPreimage::new(list.iter().enumerate().map(coefficient).collect::<Result<Vec<_>, _>>()?)
        }
        value => symbolic(scope, context, argument, &value)?,
    };
    let preimage = preimage.map_err(|error| Fault::new(argument.span(), error.to_string()))?;
    curve(scope, context, &preimage, start)
}

/// The preimage with symbols for coefficients; those that are set take their values.
fn symbolic(
    scope: &Scope,
    context: &CurveContext,
    argument: &Expr,
    value: &Value,
) -> Result<Result<SpatialPreimage, PreimageError>, Fault> {
    let degree = value.scalar().and_then(|degree| degree.to_rational()).filter(Rational::is_integer);
    let degree = degree.and_then(|degree| u32::try_from(degree.to_integer().small()?).ok());
    let degree = degree
        .ok_or_else(|| Fault::new(argument.span(), "the degree of a PH curve is an odd positive integer"))?;
    let Ok(preimage) = SpatialPreimage::symbolic(degree, &context.prefix) else {
        return Ok(SpatialPreimage::symbolic(degree, &context.prefix));
    };
    let row = |coefficient: &Quaternion| -> Vec<Variable> {
        coefficient.components().iter().flat_map(Fraction::occurring_variables).collect()
    };
    let rows = preimage.coefficients().iter().map(row).collect();
    scope.announce(context.group(CoefficientKind::Quaternion, rows));
    let set = |part: &Fraction| part.substitute(&scope.settings).unwrap_or_else(|| part.clone());
    Ok(SpatialPreimage::new(preimage.coefficients().iter().map(|coefficient| coefficient.map(set)).collect()))
}

/// `rrmf(A0, A1, c)`.
fn constrained(scope: &Scope, context: &CurveContext, call: &Call<'_>) -> Result<Value, Fault> {
    let (positional, [start]) = call.with_names(["start"])?;
    let [first, second, c] = positional.as_slice() else {
        let message = format!("`rrmf` takes 3 arguments, not {}", positional.len());
        return Err(Fault::new(call.span, message)
            .help("write `rrmf(A0, A1, c)`: the first two coefficients of the preimage, and a number"));
    };
    let coefficient = |expr: &Expr| constant_quaternion(scope, &scope.evaluate(expr)?, expr.span());
    let scalar = scope.scalar(c, "the third argument of `rrmf`")?;
    check_constant(scope, [&scalar], c.span())?;
    let preimage = SpatialPreimage::constrained_quintic(&coefficient(first)?, &coefficient(second)?, &scalar)
        .ok_or_else(|| {
            Fault::new(first.span(), "this coefficient is zero, so the curve has no tangent where it begins")
                .help("begin with a quaternion that differs from zero, or write `ph_spatial([…])`")
        })?;
    curve(scope, context, &preimage, start)
}

/// `rrmf_hermite(from, tangent, tangent)`.
fn between(scope: &Scope, context: &CurveContext, call: &Call<'_>) -> Result<Value, Fault> {
    let (positional, [middle, solution]) = call.with_names(["middle", "solution"])?;
    let [start, first, last] = positional.as_slice() else {
        let message = format!("`rrmf_hermite` takes 3 arguments, not {}", positional.len());
        return Err(Fault::new(call.span, message)
            .help("write `rrmf_hermite(from, tangent, tangent)`, the tangents those at both ends"));
    };
    let data = SpatialHermite::new(&call.vector(first)?, &call.vector(last)?);
    let data = data.map_err(|error| {
        let at_end = matches!(
            error,
            SpatialHermiteError::Zero { end: true } | SpatialHermiteError::Symbolic { end: true }
        );
        Fault::new(if at_end { last.span() } else { first.span() }, error.to_string())
    })?;
    let mirrored = match solution {
        None => false,
        Some(selector) => match scope.rational(selector, "the number of a solution")? {
            index if index == integer(0) => false,
            index if index == integer(1) => true,
            _ => return Err(Fault::new(selector.span(), "the solutions are numbered 0 and 1")),
        },
    };
    let alpha = match middle {
        None => None,
        Some(expr) => {
            let number = curves::complex_number(&scope.evaluate(expr)?).filter(Complex::is_constant);
            let wrong = || {
                Fault::new(expr.span(), "the middle coefficient is a number, real or complex")
                    .help("write `middle = 1 + I/2`, or leave it out")
            };
            Some(number.ok_or_else(wrong)?)
        }
    };
    let preimage = data.preimage(alpha.as_ref(), mirrored).map_err(|error| {
        let fault = Fault::new(middle.map_or(call.span, Expr::span), error.to_string());
        fault.help("leave `middle` out, and it is chosen")
    })?;
    curve(scope, context, &preimage, Some(*start))
}

/// A spatial PH curve that begins at `start`, or at the origin.
fn curve(
    scope: &Scope,
    context: &CurveContext,
    preimage: &SpatialPreimage,
    start: Option<&Expr>,
) -> Result<Value, Fault> {
    let start = match start {
        Some(expr) => {
            let value = scope.evaluate(expr)?;
            let point = value.vector().ok_or_else(|| {
                Fault::new(expr.span(), format!("a point is expected here, but this is {}", value.kind()))
                    .help("write a triple `(x, y, z)`")
            })?;
            check_constant(scope, point.components(), expr.span())?;
            point
        }
        None => Vector::zero(),
    };
    let parts = preimage.curve(&context.parameter, &start);
    let known = KnownProperties {
        speed: Some(parts.speed),
        quaternion: Some(parts.quaternion),
        rotation: parts.rotation,
        ..KnownProperties::default()
    };
    Ok(Value::Curve(curves::curve(scope, &context.parameter, parts.position, known)))
}

/// A coefficient of a preimage.
fn constant_quaternion(scope: &Scope, value: &Value, span: Span) -> Result<Quaternion, Fault> {
    let quaternion = value.quaternion().ok_or_else(|| {
        let message = format!("a preimage's coefficient must be a quaternion, but this is {}", value.kind());
        Fault::new(span, message).help("write `quat(w, x, y, z)`")
    })?;
    check_constant(scope, quaternion.components(), span)?;
    Ok(quaternion)
}

/// Reports parameters and unknown functions in what must be constant.
fn check_constant<'a>(
    scope: &Scope,
    parts: impl IntoIterator<Item = &'a Fraction>,
    span: Span,
) -> Result<(), Fault> {
    let mut occurring = parts.into_iter().flat_map(Fraction::occurring_variables);
    let varies =
        |variable: &Variable| scope.parameters.contains(variable) || scope.calculus.is_function(variable);
    match occurring.find(varies) {
        Some(variable) => {
            Err(Fault::new(span, format!("this depends on `{variable}`, but it must be constant")))
        }
        None => Ok(()),
    }
}

/// `pipe(s, r)` and `canal(s, r)`.
pub(super) fn canal(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let (positional, [frame]) = call.with_names(["frame"])?;
    let [spine, radius] = positional.as_slice() else {
        let fault = Fault::new(call.span, format!("`{}` takes a curve and a radius", call.name));
        return Err(fault.help(format!("write `{}(s, 1/4)`", call.name)));
    };
    let value = scope.evaluate(spine)?;
    let Value::Curve(curve) = value.bare() else {
        let message = format!("`{}` needs a curve, but this is {}", call.name, value.kind());
        return Err(Fault::new(spine.span(), message).help("define it first: `path s(v) = …;`"));
    };
    let size = scope.scalar(radius, "the radius")?;
    let allowed = |variable: &Variable| {
        variable == curve.parameter() && call.name == "canal" || !scope.parameters.contains(variable)
    };
    if let Some(variable) = size.occurring_variables().into_iter().find(|variable| !allowed(variable)) {
        let fault = Fault::new(radius.span(), format!("this radius depends on `{variable}`"));
        let is_own = variable == *curve.parameter();
        let help = if is_own {
            "`canal(s, r)` takes radii that vary along the curve"
        } else {
            "a radius depends on the curve's parameter alone"
        };
        return Err(fault.help(help));
    }
    let kept = match frame {
        Some(expr) => match scope.evaluate(expr)?.bare() {
            Value::AdaptedFrame(frame) => {
                frame.rational().map_err(|error| Fault::curve(expr.span(), &error))?
            }
            other => {
                let message = format!("a frame is expected here, but this is {}", other.kind());
                return Err(Fault::new(expr.span(), message).help("write `s.frame`, `s.rmf` or `s.frenet`"));
            }
        },
        None => curve.euler_rodrigues_frame().map_err(|error| Fault::curve(spine.span(), &error))?,
    };
    let across = surface_parameters(scope).into_iter().find(|parameter| parameter != curve.parameter());
    let across = across.ok_or_else(|| Fault::new(call.span, "there is no parameter to go around with"))?;
    curve.canal(&kept, &size, &across).map(Value::Vector).map_err(|error| canal_fault(call.span, &error))
}

fn canal_fault(span: Span, error: &CanalError) -> Fault {
    if let CanalError::Spine(error) = error {
        return Fault::curve(span, error);
    }
    let mut fault = Fault::new(span, error.to_string());
    fault.irrational = matches!(error, CanalError::Imaginary { .. } | CanalError::Negative { .. });
    fault.undecidable = !fault.irrational;
    match error {
        CanalError::Imaginary { .. } | CanalError::Negative { .. } => {
            fault.help("choose a radius that changes less fast")
        }
        _ => fault.help("choose a constant radius, or a spine of lower degree"),
    }
}
