//! Why the frames of a curve are rational, or are not.

use hodograph_algebra::{CurveError, Fraction, SpinError, budget};

use super::reasons::Reasons;
use crate::language::ast::{Expr, ExprKind};
use crate::meaning::functions;
use crate::meaning::generic::resolved;
use crate::meaning::scope::Scope;
use crate::meaning::spatial::{FrameKind, FrameValue};
use crate::meaning::value::{ComplexFraction, Value};

/// The units of work that the check of a frame may take once more.
const BUDGET: u64 = 20_000_000;

/// The frames of curves that an expression names, each once, with the curve as it is written.
pub(super) fn occurring(scope: &Scope, expr: &Expr) -> Vec<(Expr, FrameValue)> {
    let mut found = Vec::new();
    collect(scope, expr, &mut found);
    found
}

fn collect(scope: &Scope, expr: &Expr, found: &mut Vec<(Expr, FrameValue)>) {
    let expr = resolved(scope, expr);
    if let ExprKind::Member { object, .. } = expr.kind()
        && let Ok(value) = scope.evaluate(expr)
        && let Value::AdaptedFrame(frame) = value.bare()
    {
        let name = object.to_string();
        if !found.iter().any(|(other, own)| other.to_string() == name && own.kind == frame.kind) {
            found.push((object.as_ref().clone(), frame.as_ref().clone()));
        }
        return;
    }
    for child in expr.children() {
        collect(scope, child, found);
    }
}

impl Reasons<'_, '_> {
    /// Why a frame of the curve `name` is rational, or is not.
    pub(super) fn frame(&mut self, name: &Expr, frame: &FrameValue) {
        if frame.curve.speed().is_err() {
            return self.speed(name, &frame.curve);
        }
        match frame.kind {
            FrameKind::EulerRodrigues => self.preimage(name, frame),
            FrameKind::RotationMinimizing => self.rotation_minimizing(name, frame),
            FrameKind::Frenet => self.frenet(name, frame),
        }
    }

    /// The quaternion of the Euler–Rodrigues frame.
    fn preimage(&mut self, name: &Expr, frame: &FrameValue) {
        let Ok(own) = frame.curve.euler_rodrigues_frame() else { return };
        let quaternion =
            own.quaternion.and_then(|quaternion| self.show.value(&Value::Quaternion(quaternion)));
        if let Some(text) = quaternion {
            let because = "A*i*conj(A) has the direction of the tangent, so that A*j*conj(A) and A*k*conj(A) over norm2(A) are a \
                           rational frame, that of Euler and Rodrigues";
            self.push("preimage", format!("{name}.frame.preimage = A = {text}"), because);
        }
    }

    fn rotation_minimizing(&mut self, name: &Expr, frame: &FrameValue) {
        self.preimage(name, frame);
        let Ok(own) = frame.curve.euler_rodrigues_frame() else { return };
        let h = own.spin.scale(&hodograph_algebra::ratio(-1, 2)).lowest_terms();
        let because = "A W has the same tangent for every complex polynomial W; its frame does not turn about the tangent if h is \
                       Im(conj(W)*W')/|W|^2, and every rational frame is of this form";
        self.push("spin", format!("h = -{name}.frame.spin/2 = {}", self.show.scalar(&h)), because);
        match frame.curve.rotation_minimizing_frame() {
            Ok(minimizing) => {
                if let Some(w) = &minimizing.rotation {
                    let parts = ComplexFraction { re: w.re.clone().into(), im: w.im.clone().into() };
                    if let Some(text) = self.show.value(&Value::Complex(parts)) {
                        let norm = Fraction::from(w.norm2()).checked_div(&h.denominator().into());
                        let norm = norm.map(|quotient| quotient.lowest_terms());
                        let poles = match norm.filter(|quotient| quotient.to_poly().is_some() && !h.is_zero())
                        {
                            Some(quotient) if quotient == Fraction::one() => {
                                ": |W|^2 is the denominator of h".to_owned()
                            }
                            Some(quotient)
                                if !functions::is_varying(self.show.scope(), quotient.numerator()) =>
                            {
                                format!(
                                    ": |W|^2 is {} times the denominator of h",
                                    self.show.scalar(&quotient)
                                )
                            }
                            _ => String::new(),
                        };
                        let because = format!("Im(conj(W)*W')/|W|^2 - h = 0, identically{poles}");
                        self.push("rotation", format!("W = {text}"), because);
                    }
                }
                let parameter = frame.curve.parameter();
                let spin = || {
                    let turning =
                        minimizing.f.map(|part| self.show.scope().calculus.derivative(part, parameter));
                    turning.dot(&minimizing.g).reduced()
                };
                if let Ok(spin) = budget::with_budget(BUDGET, spin) {
                    let formula = format!(
                        "dot(diff({name}.rmf.f, {parameter}), {name}.rmf.g) = {}",
                        self.show.scalar(&spin)
                    );
                    self.push("spin", formula, "computed from the vectors f and g of the frame of A W");
                }
            }
            Err(CurveError::NoRationalFrame { error, .. }) => self.no_rotation(&error),
            Err(error) => self.push("rotation", "none was found", error.to_string()),
        }
    }

    /// Why no polynomial W turns a frame back.
    fn no_rotation(&mut self, error: &SpinError) {
        match error {
            SpinError::MultiplePole { factor } => self.push(
                "residues",
                format!("({})^2 divides the denominator of h", self.show.poly(factor)),
                "the poles of Im(conj(W)*W')/|W|^2 are simple for every W, so there is no W",
            ),
            SpinError::NotProper => self.push(
                "residues",
                "the degree of the numerator of h is not below that of its denominator",
                "Im(conj(W)*W')/|W|^2 vanishes at infinity for every W, so there is no W",
            ),
            SpinError::Residues { factor, squares, at } => {
                let [factor, squares] = [factor, squares].map(|poly| self.show.poly(poly));
                let values: Vec<String> =
                    at.iter().map(|(symbol, value)| format!("{symbol} = {value}")).collect();
                let general = if values.is_empty() {
                    String::new()
                } else {
                    let values = values.join(", ");
                    format!(" (for {values}; integers would stay what they are where symbols change)")
                };
                self.push(
                    "residues",
                    format!("residue^2 = r with {squares} = 0, at the zeros of {factor}"),
                    format!(
                        "2*I*h = W'/W - conj(W)'/conj(W) has integers for residues, but these squares are not those of \
                         integers, so there is no W{general}"
                    ),
                );
            }
            other => self.push("residues", "undecided", other.to_string()),
        }
    }

    /// The squared length of `s' × s''`, of which that of s' is taken out.
    fn frenet(&mut self, name: &Expr, frame: &FrameValue) {
        let curve = &frame.curve;
        let cross = format!("cross({name}.hodograph, diff({name}.hodograph, {}))", curve.parameter());
        let (direction, speed) = match (curve.osculating_direction(), curve.speed()) {
            (Ok(direction), Ok(speed)) => (direction, speed),
            (Err(error), _) | (_, Err(error)) => {
                return self.push("value", format!("{cross} = 0"), error.to_string());
            }
        };
        self.push(
            "value",
            format!("{cross} = {}", self.show.vector(&direction)),
            "the direction of the binormal",
        );
        let squared = direction.norm2().reduced();
        let Some(rest) = squared.checked_div(&speed.pow(2)) else { return };
        self.radicand(&format!("norm2({cross})/{name}.speed^2"), &rest);
    }
}
