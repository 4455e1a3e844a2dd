//! Frames in a file: JSON, with every mistake at its place.

use hodograph_algebra::{Frame, Motion, MotionError, MotionOptions, Poly, Rational, parse_decimal};

use super::fault::Fault;
use super::frames;
use super::scope::Scope;
use crate::language::ast::{Expr, ExprKind, Spanned};
use crate::language::json::{self, Json, JsonKind};
use crate::language::{Diagnostic, Diagnostics, Report, Source, Span, closest};

/// How many mistakes of a file stand in one message.
const SHOWN: usize = 4;

const KEYS: [&str; 3] = ["position", "quaternion", "scale"];

/// A frame with the places of its parts.
struct Placed {
    frame: Frame,
    quaternion: Span,
    scale: Span,
    whole: Span,
}

/// The motion through the frames in the file that an argument names.
pub(super) fn motion(scope: &Scope, argument: &Expr, options: &MotionOptions) -> Result<Motion, Fault> {
    let ExprKind::Str(name) = argument.kind() else {
        return Err(Fault::new(argument.span(), "the name of a file stands in double quotes")
            .help("write `frames_file(\"frames.json\")`"));
    };
    let text = match scope.inputs.get(name) {
        Some(Ok(text)) => text,
        Some(Err(error)) => {
            let fault = Fault::new(argument.span(), format!("cannot read {name}: {error}"));
            return Err(fault.help("the path is relative to the folder of the file that names it"));
        }
        None => {
            let fault = Fault::new(argument.span(), format!("there is no text of {name} here"));
            return Err(fault.help("a program gives it with `File::attach`"));
        }
    };
    let (source, value) = json::parse(name, text);
    let report = |diagnostics: Diagnostics| fault(argument.span(), source.clone(), diagnostics);
    let placed = value.and_then(|value| frames_of(&value)).map_err(report)?;
    let frames: Vec<Frame> = placed.iter().map(|placed| placed.frame.clone()).collect();
    Motion::through(&frames, options).map_err(|error| {
        let Some(at) = error.frame().and_then(|frame| placed.get(frame)) else {
            // What is wrong with the frames together, or with the options.
            return frames::fault(argument.span(), &error);
        };
        let place = match error {
            MotionError::ZeroQuaternion { .. } | MotionError::NotUnit { .. } => at.quaternion,
            MotionError::Scale { .. } => at.scale,
            _ => at.whole,
        };
        let mut diagnostics = Diagnostics::new();
        diagnostics.push(*frames::fault(place, &error).diagnostic);
        report(diagnostics)
    })
}

/// The mistakes of a file as one at the place that names it.
fn fault(span: Span, source: Source, diagnostics: Diagnostics) -> Fault {
    let help = diagnostics.iter().find_map(|mistake| mistake.help.clone());
    let lines = Report::new(source, diagnostics).lines();
    let mut message = lines.iter().take(SHOWN).cloned().collect::<Vec<_>>().join("; ");
    if lines.len() > SHOWN {
        message += &format!("; … and {} more mistakes", lines.len() - SHOWN);
    }
    let fault = Fault::new(span, message);
    match help {
        Some(help) => fault.help(help),
        None => fault,
    }
}

fn frames_of(value: &Json) -> Result<Vec<Placed>, Diagnostics> {
    let mut diagnostics = Diagnostics::new();
    let JsonKind::List(parts) = &value.kind else {
        let message = format!("a list of frames is expected, but this is {}", value.kind.name());
        diagnostics.push(Diagnostic::new(value.span, message).help("write `[{\"position\": …}, …]`"));
        return Err(diagnostics);
    };
    let mut frames = Vec::new();
    for part in parts {
        match frame(part, &mut diagnostics) {
            Some(frame) => frames.push(frame),
            None => debug_assert!(!diagnostics.is_empty()),
        }
    }
    if diagnostics.is_empty() { Ok(frames) } else { Err(diagnostics) }
}

fn frame(value: &Json, diagnostics: &mut Diagnostics) -> Option<Placed> {
    let JsonKind::Object(members) = &value.kind else {
        let message = format!("a frame is expected, but this is {}", value.kind.name());
        let help = "write `{\"position\": [0, 0, 0], \"quaternion\": [1, 0, 0, 0], \"scale\": 1}`";
        diagnostics.push(Diagnostic::new(value.span, message).help(help));
        return None;
    };
    for (key, _) in members.iter().filter(|(key, _)| !KEYS.contains(&key.value.as_str())) {
        diagnostics.push(unknown(key));
    }
    let member = |name: &str| members.iter().find(|(key, _)| key.value == name).map(|(_, value)| value);
    let mut missing = |name: &str| {
        let found = member(name);
        if found.is_none() {
            diagnostics.push(Diagnostic::new(value.span, format!("this frame has no {name:?}")));
        }
        found
    };
    let (position, quaternion) = (missing("position"), missing("quaternion"));
    let (position, quaternion) = (position?, quaternion?);
    let point = numbers::<3>(position, "the position", diagnostics);
    let parts = numbers::<4>(quaternion, "the quaternion", diagnostics);
    let (scale, place) = match member("scale") {
        Some(value) => (number(value, diagnostics), value.span),
        None => (Some(Poly::one()), value.span),
    };
    let frame = Frame { position: point?, quaternion: parts?, scale: scale? };
    Some(Placed { frame, quaternion: quaternion.span, scale: place, whole: value.span })
}

fn unknown(key: &Spanned<String>) -> Diagnostic {
    let wrong = Diagnostic::new(key.span, format!("a frame has no {:?}", key.value));
    match closest(&key.value, KEYS) {
        Some(similar) => wrong.help(format!("did you mean {similar:?}?")),
        None => wrong.help("it has \"position\", \"quaternion\" and, if it is not 1, \"scale\""),
    }
}

/// A list of `N` numbers.
fn numbers<const N: usize>(value: &Json, role: &str, diagnostics: &mut Diagnostics) -> Option<[Poly; N]> {
    let JsonKind::List(parts) = &value.kind else {
        let message = format!("{role} is a list of {N} numbers, but this is {}", value.kind.name());
        diagnostics.push(Diagnostic::new(value.span, message));
        return None;
    };
    if parts.len() != N {
        let message = format!("{role} is a list of {N} numbers, but here are {}", parts.len());
        diagnostics.push(Diagnostic::new(value.span, message));
        return None;
    }
    let numbers: Vec<Option<Poly>> = parts.iter().map(|part| number(part, diagnostics)).collect();
    numbers.into_iter().collect::<Option<Vec<Poly>>>()?.try_into().ok()
}

/// A decimal number, or a text with a decimal or a quotient of two integers.
fn number(value: &Json, diagnostics: &mut Diagnostics) -> Option<Poly> {
    let (negative, digits) = match &value.kind {
        JsonKind::Number(negative, digits) => (*negative, digits.as_str()),
        JsonKind::Text(text) => match text.trim().strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, text.trim()),
        },
        other => {
            let message = format!("a number is expected here, but this is {}", other.name());
            diagnostics.push(Diagnostic::new(value.span, message).help("write `0.6` or `\"3/5\"`"));
            return None;
        }
    };
    match exact(digits) {
        Some(number) => Some(Poly::constant(if negative { -number } else { number })),
        None => {
            let text = format!("{}{digits}", if negative { "-" } else { "" });
            let wrong = Diagnostic::new(value.span, format!("{text:?} is no number"));
            diagnostics
                .push(wrong.help("write a decimal of up to 4096 digits with an exponent of that size at most, or a quotient such as \"3/5\""));
            None
        }
    }
}

fn exact(digits: &str) -> Option<Rational> {
    match digits.split_once('/') {
        None => parse_decimal(digits),
        Some((above, below)) => {
            let integer = |text: &str| parse_decimal(text.trim()).filter(Rational::is_integer);
            let (above, below) = (integer(above)?, integer(below)?);
            (below != hodograph_algebra::integer(0)).then(|| above / below)
        }
    }
}
