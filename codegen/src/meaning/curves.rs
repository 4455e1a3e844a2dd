//! Constructors of curves: `ph`, `ph_hermite`, `bezier`, symbolic curves.

use std::rc::Rc;

use hodograph_algebra::{
    Calculus, Complex, Curve, Fraction, Hermite, KnownProperties, Poly, Preimage, Rational, Variable, Vector,
    minimize_field, moving_frame_curve,
};

use super::calls::Call;
use super::expression::shortened;
use super::fault::Fault;
use super::group::{CoefficientGroup, CoefficientKind};
use super::scope::Scope;
use super::spatial;
use super::value::{ComplexFraction, Value};
use crate::language::Span;
use crate::language::ast::{Expr, ExprKind};

/// The curve that a clause defines: what constructors need to know.
#[derive(Clone, Debug)]
pub(super) struct CurveContext {
    /// The curve's name.
    pub(super) name: String,
    /// Its parameter.
    pub(super) parameter: Variable,
    /// What the names of symbolic coefficients begin with.
    pub(super) prefix: String,
}

impl CurveContext {
    pub(super) fn group(&self, kind: CoefficientKind, rows: Vec<Vec<Variable>>) -> CoefficientGroup {
        CoefficientGroup { curve: self.name.clone(), kind, rows }
    }
}

/// The largest number of control points of a Bézier curve.
const MAX_CONTROL_POINTS: usize = 101;

/// The largest degree of symbolic polynomial and rational curves.
const MAX_SYMBOLIC_DEGREE: i64 = 32;

/// The curve with the given position in the scope of a clause.
pub(super) fn curve(
    scope: &Scope,
    parameter: &Variable,
    position: Vector,
    known: KnownProperties,
) -> Rc<Curve> {
    let domain = scope.whole_domain(parameter);
    Rc::new(Curve::new(parameter, over_least_field(&position), domain, known, scope.calculus.clone()))
}

/// The same vector over a number field that is no larger than it needs.
fn over_least_field(vector: &Vector) -> Vector {
    let polys: Vec<Poly> = vector
        .components()
        .iter()
        .flat_map(|f| {
            f.factors().iter().map(|(factor, _)| factor).chain([f.numerator()]).cloned().collect::<Vec<_>>()
        })
        .collect();
    if polys.iter().all(|poly| poly.ring().field().generators().is_empty()) {
        return vector.clone();
    }
    let mut least = minimize_field(&polys).into_iter();
    vector.map(|f| {
        let factors: Vec<(Poly, u32)> = f
            .factors()
            .iter()
            .map(|(_, exponent)| (least.next().unwrap_or_else(Poly::one), *exponent))
            .collect();
        Fraction::new(least.next().unwrap_or_else(Poly::zero), factors)
    })
}

/// The value of a constructor, which makes a curve and stands in a curve's clause.
pub(super) fn constructor(scope: &Scope, call: &Call<'_>) -> Result<Value, Fault> {
    let Some(context) = &scope.curve else {
        let fault = Fault::new(call.span, format!("`{}` makes a curve", call.name));
        return Err(fault.help(format!("define it first: `path s(v) = {}(…);`", call.name)));
    };
    match call.name {
        "ph" => ph(scope, context, call),
        "ph_hermite" => ph_hermite(scope, context, call),
        "bezier" => bezier(scope, context, call),
        "polynomial_curve" | "rational_curve" => symbolic(scope, context, call),
        "regular_curve" => regular(scope, context, call),
        "curve_from_hodograph" => from_hodograph(scope, context, call),
        "ph_spatial" | "rrmf" | "rrmf_hermite" => spatial::constructor(scope, context, call),
        _ => Err(Fault::new(call.span, format!("`{}` is not a function", call.name))),
    }
}

fn ph(scope: &Scope, context: &CurveContext, call: &Call<'_>) -> Result<Value, Fault> {
    let (positional, [factor, start]) = call.with_names(["factor", "start"])?;
    let [argument] = positional.as_slice() else {
        let fault = Fault::new(call.span, "`ph` takes the preimage's coefficients, or a degree");
        return Err(fault.help("write `ph([w0, w1, w2])` or `ph(5)`"));
    };
    let preimage = match scope.evaluate(argument)? {
        Value::List(list) => {
            let coefficient = |(index, value): (usize, &Value)| {
                complex_number(value).ok_or_else(|| {
                    let span = element(argument, index).unwrap_or(argument.span());
                    Fault::new(
                        span,
                        format!(
                            "a preimage's coefficient must be a complex number, but this is {}",
                            value.kind()
                        ),
                    )
                })
            };
            let coefficients = list.iter().enumerate().map(coefficient).collect::<Result<Vec<_>, _>>()?;
            Preimage::new(coefficients)
        }
        value => {
            let degree = value.scalar().and_then(|degree| degree.to_rational()).filter(Rational::is_integer);
            let degree =
                degree.and_then(|degree| u32::try_from(degree.to_integer().small()?).ok()).ok_or_else(
                    || Fault::new(argument.span(), "the degree of a PH curve is an odd positive integer"),
                )?;
            let preimage = Preimage::symbolic(degree, &context.prefix);
            if let Ok(preimage) = &preimage {
                let row =
                    |w: &Complex| [&w.re, &w.im].into_iter().flat_map(Poly::occurring_variables).collect();
                let rows = preimage.coefficients().iter().map(row).collect();
                scope.announce(context.group(CoefficientKind::Preimage, rows));
            }
            // Symbols that are set take their values here.
            match preimage {
                Ok(symbolic) if !scope.settings.is_empty() => {
                    let set = |poly: &Poly| match poly.occurring_variables().as_slice() {
                        [symbol] => scope.coefficient(symbol, argument.span()),
                        _ => Ok(poly.clone()),
                    };
                    let coefficients = symbolic.coefficients().iter();
                    let coefficients = coefficients.map(|w| Ok(Complex::new(set(&w.re)?, set(&w.im)?)));
                    Preimage::new(coefficients.collect::<Result<Vec<_>, Fault>>()?)
                }
                other => other,
            }
        }
    };
    let mut preimage = preimage.map_err(|error| Fault::new(argument.span(), error.to_string()))?;
    if let Some(factor) = factor {
        let poly = super::functions::polynomial(scope, factor)?;
        if poly.is_zero() {
            return Err(Fault::new(
                factor.span(),
                "the factor of a hodograph is zero, so the curve is a point",
            ));
        }
        preimage = preimage.with_factor(poly);
    }
    let start = match start {
        Some(start) => plane_point(scope, start)?,
        None => Complex::zero(),
    };
    Ok(ph_curve(scope, context, &preimage, &start))
}

fn ph_curve(scope: &Scope, context: &CurveContext, preimage: &Preimage, start: &Complex) -> Value {
    let w = preimage.polynomial(&context.parameter);
    let parts = preimage.curve(&context.parameter, start);
    let position = Vector::new(parts.position.re.into(), parts.position.im.into(), Fraction::zero());
    let known = KnownProperties {
        speed: Some(parts.speed.into()),
        preimage: Some([w.re, w.im]),
        ..KnownProperties::default()
    };
    Value::Curve(curve(scope, &context.parameter, position, known))
}

fn ph_hermite(scope: &Scope, context: &CurveContext, call: &Call<'_>) -> Result<Value, Fault> {
    let (positional, [selector]) = call.with_names(["solution"])?;
    let [start, start_tangent, end, end_tangent] = positional.as_slice() else {
        let fault =
            Fault::new(call.span, format!("`ph_hermite` takes 4 arguments, not {}", positional.len()));
        return Err(fault.help("write `ph_hermite(from, tangent, to, tangent)`, each a pair `(x, y)`"));
    };
    let start = plane_point(scope, start)?;
    let data = Hermite::new(
        &start,
        &plane_point(scope, start_tangent)?,
        &plane_point(scope, end)?,
        &plane_point(scope, end_tangent)?,
    );
    let fault = |error: hodograph_algebra::HermiteError| Fault::new(call.span, error.to_string());
    let data = data.map_err(fault)?;
    let preimage = match selector {
        None => data
            .least_rotation()
            .map_err(|error| fault(error).help("add `solution = …` with one of these numbers to choose"))?,
        Some(selector) => {
            let index = scope.rational(selector, "the number of a solution")?;
            let index =
                usize::try_from(index.to_integer().small().filter(|_| index.is_integer()).unwrap_or(-1));
            let index =
                index.map_err(|_| Fault::new(selector.span(), "the solutions are numbered from 0 to 3"))?;
            data.solution(index).map_err(|error| Fault::new(selector.span(), error.to_string()))?
        }
    };
    Ok(ph_curve(scope, context, &preimage, &start))
}

fn bezier(scope: &Scope, context: &CurveContext, call: &Call<'_>) -> Result<Value, Fault> {
    let (positional, [weights]) = call.with_names(["weights"])?;
    let [points] = positional.as_slice() else {
        return Err(Fault::new(call.span, "`bezier` takes a list of control points")
            .help("write `bezier([(0, 0), (1, 2)])`"));
    };
    let (Value::List(list), ExprKind::Array(_)) = (scope.evaluate(points)?, points.kind()) else {
        return Err(
            Fault::new(points.span(), "the control points must be a list").help("write `[(0, 0), (1, 2)]`")
        );
    };
    let at = |index: usize| element(points, index).unwrap_or(points.span());
    if list.len() < 2 {
        return Err(Fault::new(points.span(), "a Bézier curve needs two control points at least"));
    }
    if list.len() > MAX_CONTROL_POINTS {
        let message = format!("{} control points are more than {MAX_CONTROL_POINTS}", list.len());
        return Err(Fault::new(points.span(), message).help("split the curve"));
    }
    let mut control = Vec::new();
    for (index, value) in list.iter().enumerate() {
        let point = value.vector().ok_or_else(|| {
            Fault::new(at(index), format!("a control point must be a vector, but this is {}", value.kind()))
        })?;
        control.push(point);
    }
    let weights = match weights {
        None => vec![Fraction::one(); control.len()],
        Some(expr) => {
            let Value::List(list) = scope.evaluate(expr)? else {
                return Err(Fault::new(expr.span(), "the weights must be a list"));
            };
            if list.len() != control.len() {
                let message = format!("{} weights for {} control points", list.len(), control.len());
                return Err(Fault::new(expr.span(), message).help("give one weight for each control point"));
            }
            let weight = |(index, value): (usize, &Value)| {
                let span = element(expr, index).unwrap_or(expr.span());
                value.scalar().ok_or_else(|| {
                    Fault::new(span, format!("a weight must be a number, but this is {}", value.kind()))
                })
            };
            list.iter().enumerate().map(weight).collect::<Result<Vec<_>, _>>()?
        }
    };
    let (mut position, mut weight) = (Vector::zero(), Fraction::zero());
    for ((basis, point), w) in
        bernstein_basis(control.len() - 1, &context.parameter).iter().zip(&control).zip(&weights)
    {
        let weighted = &Fraction::from(basis.clone()) * w;
        position = &position + &point.scale(&weighted);
        weight = &weight + &weighted;
    }
    if weight.to_poly().is_none_or(|weight| !weight.is_one()) {
        let zero = || Fault::new(call.span, "the weights cancel: their sum is zero for every parameter");
        position = position.scale(&weight.reciprocal(&[]).ok_or_else(zero)?);
    }
    Ok(Value::Curve(curve(scope, &context.parameter, position, KnownProperties::default())))
}

/// The Bernstein polynomials of a degree on [0, 1].
pub(super) fn bernstein_basis(degree: usize, parameter: &Variable) -> Vec<Poly> {
    let t = Poly::variable(parameter);
    let s = Poly::one() - &t;
    let mut basis = vec![Poly::one()];
    for _ in 0..degree {
        let mut next = vec![Poly::zero(); basis.len() + 1];
        for (index, poly) in basis.iter().enumerate() {
            next[index] += poly * &s;
            next[index + 1] += poly * &t;
        }
        basis = next;
    }
    basis
}

fn symbolic(scope: &Scope, context: &CurveContext, call: &Call<'_>) -> Result<Value, Fault> {
    let [degree] = call.positional()?;
    let n = scope.rational(degree, "the degree of a curve")?;
    let n = n.is_integer().then(|| n.to_integer().small()).flatten();
    let n = n.filter(|n| (1..=MAX_SYMBOLIC_DEGREE).contains(n)).ok_or_else(|| {
        Fault::new(
            degree.span(),
            format!("the degree of a symbolic curve is an integer from 1 to {MAX_SYMBOLIC_DEGREE}"),
        )
    })?;
    let coordinate = |letter: &str| {
        let coefficients: Vec<Variable> = (0..=n)
            .map(|i| Variable::new(Variable::SYMBOL, &format!("{}{letter}{i}", context.prefix)))
            .collect();
        let poly = coefficients.iter().map(|symbol| scope.coefficient(symbol, degree.span()));
        let poly = poly.collect::<Result<Vec<Poly>, Fault>>()?;
        Ok::<_, Fault>((Poly::from_coefficients(&context.parameter, &poly), coefficients))
    };
    let over = |numerator: Poly, weight: &Option<Poly>| match weight {
        Some(weight) => Fraction::new(numerator, [(weight.clone(), 1)]),
        None => numerator.into(),
    };
    let ((x, of_x), (y, of_y)) = (coordinate("x")?, coordinate("y")?);
    let rational = (call.name == "rational_curve").then(|| coordinate("w")).transpose()?;
    let (weight, of_weight): (Option<Poly>, Option<Vec<Variable>>) = rational.unzip();
    if weight.as_ref().is_some_and(Poly::is_zero) {
        return Err(Fault::new(call.span, "the weight of the curve is zero everywhere"));
    }
    let columns: Vec<Vec<Variable>> = of_weight.into_iter().chain([of_x, of_y]).collect();
    let kind = if weight.is_some() { CoefficientKind::Rational } else { CoefficientKind::Polynomial };
    let rows = (0..=n as usize).map(|i| columns.iter().map(|column| column[i].clone()).collect()).collect();
    scope.announce(context.group(kind, rows));
    let position = Vector::new(over(x, &weight), over(y, &weight), Fraction::zero());
    Ok(Value::Curve(curve(scope, &context.parameter, position, KnownProperties::default())))
}

fn regular(scope: &Scope, context: &CurveContext, call: &Call<'_>) -> Result<Value, Fault> {
    let [sigma, kappa] = call.positional()?;
    let sigma = scope.scalar(sigma, "the parametric speed")?;
    let kappa = scope.scalar(kappa, "the curvature")?;
    let mut calculus = Calculus::clone(&scope.calculus);
    let (position, known) =
        moving_frame_curve(&context.name, &context.parameter, &sigma, &kappa, &mut calculus);
    with_calculus(scope, context, call.span, position, known, calculus)
}

fn from_hodograph(scope: &Scope, context: &CurveContext, call: &Call<'_>) -> Result<Value, Fault> {
    let [hodograph] = call.positional()?;
    let value = scope.evaluate(hodograph)?;
    let hodograph = value.vector().ok_or_else(|| {
        Fault::new(hodograph.span(), format!("a hodograph must be a vector, but this is {}", value.kind()))
    })?;
    let mut calculus = Calculus::clone(&scope.calculus);
    let mut names = ["x", "y", "z"].into_iter();
    let position = hodograph.map(|component| {
        let name = names.next().unwrap_or_default();
        if component.is_zero() {
            return Fraction::zero();
        }
        let name = format!("{}_{name}", context.name);
        calculus.symbol_with_derivative(&name, &context.parameter, component.clone()).into()
    });
    // The speed has the sign that the curve gives it.
    let speed =
        plain(scope, context, position.clone(), KnownProperties::default(), Rc::new(calculus.clone()))
            .speed();
    let arclength = speed.ok().map(|speed| {
        let name = format!("{}_arclength", context.name);
        calculus.symbol_with_derivative(&name, &context.parameter, speed).into()
    });
    let known = KnownProperties { arclength, ..KnownProperties::default() };
    with_calculus(scope, context, call.span, position, known, calculus)
}

/// A curve with symbols of its own, whose derivatives every later formula knows.
fn with_calculus(
    scope: &Scope,
    context: &CurveContext,
    span: Span,
    position: Vector,
    known: KnownProperties,
    calculus: Calculus,
) -> Result<Value, Fault> {
    for suffix in ["arclength", "m", "x", "y", "z"] {
        scope.check_coordinate(&context.name, suffix, span)?;
    }
    let calculus = Rc::new(calculus);
    scope.announce_calculus(calculus.clone());
    Ok(Value::Curve(Rc::new(plain(scope, context, position, known, calculus))))
}

/// The curve of a clause, over the domain of its parameter.
fn plain(
    scope: &Scope,
    context: &CurveContext,
    position: Vector,
    known: KnownProperties,
    calculus: Rc<Calculus>,
) -> Curve {
    let domain = scope.whole_domain(&context.parameter);
    Curve::new(&context.parameter, position, domain, known, calculus)
}

/// The place of an element of a list.
pub(super) fn element(list: &Expr, index: usize) -> Option<Span> {
    list.children().nth(index).map(Expr::span)
}

pub(super) fn complex_number(value: &Value) -> Option<Complex> {
    let ComplexFraction { re, im } = value.complex()?;
    let (re, im) = (re.to_poly()?, im.to_poly()?);
    Some(Complex::new(re, im))
}

/// A point of the plane, as a complex number.
fn plane_point(scope: &Scope, expr: &Expr) -> Result<Complex, Fault> {
    let value = scope.evaluate(expr)?;
    let vector = value.vector().filter(|vector| vector.components()[2].is_zero());
    let pair = vector.and_then(|vector| {
        let [x, y, _] = vector.components();
        Some(Complex::new(x.to_poly()?, y.to_poly()?))
    });
    pair.ok_or_else(|| {
        let message =
            format!("a point or vector of the plane is expected, but this is {}", shortened(value.kind()));
        Fault::new(expr.span(), message).help("write a pair `(x, y)`")
    })
}
