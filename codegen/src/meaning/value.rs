//! The values of expressions.

use std::fmt;
use std::rc::Rc;

use hodograph_algebra::{
    Curve, Fraction, Frame, MotionSegment, OffsetError, Poly, QuadraticFraction, Quaternion, SweptSurface,
    Variable, Vector,
};

use super::roots::FormValue;
use super::spatial::FrameValue;

/// The value of an expression.
#[derive(Clone, Debug)]
pub(super) enum Value {
    /// A real number, or a function of the parameters and symbols.
    Scalar(Fraction),
    /// A complex number or function.
    Complex(ComplexFraction),
    /// A quaternion.
    Quaternion(Quaternion),
    /// A vector in space.
    Vector(Vector),
    /// A tuple `(a, b, …)` as written: a vector of the plane or of space, degrees, or homogeneous coordinates.
    Tuple(Vec<Fraction>),
    /// A list `[a, b, …]`.
    List(Vec<Value>),
    /// A curve with its properties.
    Curve(Rc<Curve>),
    /// A frame along a curve.
    AdaptedFrame(Rc<FrameValue>),
    /// A surface.
    Surface(Rc<SweptSurface>),
    /// A surface that may not be rational: the offset of a surface.
    Offset(Rc<Result<SweptSurface, OffsetError>>),
    /// A frame, `frame(…)`.
    Frame(Rc<Frame>),
    /// A segment of a motion through frames.
    Motion(Rc<MotionSegment>),
    /// A formula in the fundamental forms of a surface.
    Form(Rc<FormValue>),
    /// A scalar with a square root of a function.
    Root(Rc<QuadraticFraction>),
    /// A vector with a square root of a function.
    RootVector(Rc<[QuadraticFraction]>),
    /// A function of parameters, `let c(v) = …`.
    Function(Rc<FunctionValue>),
    /// The degrees of polynomials.
    Degree(Rc<DegreeValue>),
}

/// A complex rational function.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ComplexFraction {
    /// The real part.
    pub re: Fraction,
    /// The imaginary part.
    pub im: Fraction,
}

impl ComplexFraction {
    /// The product.
    #[must_use]
    pub(super) fn times(&self, other: &ComplexFraction) -> ComplexFraction {
        ComplexFraction {
            re: &(&self.re * &other.re) - &(&self.im * &other.im),
            im: &(&self.re * &other.im) + &(&self.im * &other.re),
        }
    }

    /// The conjugate.
    #[must_use]
    pub(super) fn conj(&self) -> ComplexFraction {
        ComplexFraction { re: self.re.clone(), im: -&self.im }
    }

    /// The squared absolute value.
    #[must_use]
    pub(super) fn norm2(&self) -> Fraction {
        &(&self.re * &self.re) + &(&self.im * &self.im)
    }

    /// The reciprocal; `None` for zero.
    #[must_use]
    pub(super) fn reciprocal(&self) -> Option<ComplexFraction> {
        let inverse = self.norm2().reciprocal(&[])?;
        Some(ComplexFraction { re: &self.re * &inverse, im: -&(&self.im * &inverse) })
    }
}

impl From<Fraction> for ComplexFraction {
    fn from(re: Fraction) -> ComplexFraction {
        ComplexFraction { re, im: Fraction::zero() }
    }
}

/// The degrees of polynomials in one or two parameters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct DegreeValue {
    /// The degree in each parameter; that of zero is −1.
    pub degrees: Vec<i64>,
    /// What the polynomials depend on besides.
    pub variables: Vec<Variable>,
    /// The parameters.
    pub parameters: Vec<Variable>,
    /// The polynomials with what they are called.
    pub polynomials: Vec<(String, Poly)>,
}

impl fmt::Display for DegreeValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.degrees.as_slice() {
            [degree] => write!(f, "{degree}"),
            degrees => {
                let degrees: Vec<String> = degrees.iter().map(i64::to_string).collect();
                write!(f, "({})", degrees.join(", "))
            }
        }
    }
}

/// A value that depends on named parameters.
#[derive(Clone, Debug)]
pub(super) struct FunctionValue {
    /// The parameters, in the order of a call.
    pub parameters: Vec<Variable>,
    /// The value for the parameters as they are.
    pub value: Value,
}

impl Value {
    /// What it is, with an article, as messages say it.
    #[must_use]
    pub(super) fn kind(&self) -> &'static str {
        match self {
            Value::Scalar(value) if value.to_number().is_some() => "a number",
            Value::Scalar(_) => "a scalar function",
            Value::Complex(_) => "a complex number",
            Value::Quaternion(_) => "a quaternion",
            Value::Vector(_) => "a vector",
            Value::Tuple(parts) if parts.len() <= 3 => "a vector",
            Value::Tuple(_) => "a list of homogeneous coordinates",
            Value::List(_) => "a list",
            Value::Curve(_) => "a curve",
            Value::AdaptedFrame(_) => "a frame of a curve",
            Value::Surface(_) => "a surface",
            Value::Offset(_) => "an offset surface",
            Value::Frame(_) => "a frame",
            Value::Motion(_) => "a motion",
            Value::Form(_) => "a formula in fundamental forms",
            Value::Root(_) => "a function with a square root",
            Value::RootVector(_) => "a vector with a square root",
            Value::Function(_) => "a function",
            Value::Degree(_) => "a degree",
        }
    }

    /// The value itself, of a function for its parameters as they are.
    #[must_use]
    pub(super) fn bare(&self) -> &Value {
        match self {
            Value::Function(function) => function.value.bare(),
            other => other,
        }
    }

    /// The scalar that it is.
    #[must_use]
    pub(super) fn scalar(&self) -> Option<Fraction> {
        match self.bare() {
            Value::Scalar(value) => Some(value.clone()),
            Value::Complex(value) if value.im.is_zero() => Some(value.re.clone()),
            Value::Form(form) => form.value().ok()?.to_rational_function(),
            Value::Quaternion(value) if value.is_scalar() => Some(value.scalar().clone()),
            _ => None,
        }
    }

    /// The vector that it is: also a pair or triple, a curve's position, a surface's, a quaternion without scalar part.
    #[must_use]
    pub(super) fn vector(&self) -> Option<Vector> {
        match self.bare() {
            Value::Vector(vector) => Some(vector.clone()),
            Value::Tuple(parts) => match parts.as_slice() {
                [x, y] => Some(Vector::new(x.clone(), y.clone(), Fraction::zero())),
                [x, y, z] => Some(Vector::new(x.clone(), y.clone(), z.clone())),
                _ => None,
            },
            Value::Quaternion(value) if value.is_vector() => Some(value.vector()),
            Value::Curve(curve) => Some(curve.position().clone()),
            Value::Surface(surface) => Some(surface.position().clone()),
            Value::Offset(offset) => offset.as_ref().as_ref().ok().map(|surface| surface.position().clone()),
            _ => None,
        }
    }

    /// The complex number that it is; real ones count.
    #[must_use]
    pub(super) fn complex(&self) -> Option<ComplexFraction> {
        match self.bare() {
            Value::Scalar(value) => Some(value.clone().into()),
            Value::Complex(value) => Some(value.clone()),
            Value::Form(_) => self.scalar().map(ComplexFraction::from),
            _ => None,
        }
    }

    /// The quaternion that it is; scalars and vectors count.
    #[must_use]
    pub(super) fn quaternion(&self) -> Option<Quaternion> {
        match self.bare() {
            Value::Quaternion(value) => Some(value.clone()),
            _ => self.scalar().map(Quaternion::from).or_else(|| self.vector().map(Quaternion::from)),
        }
    }

    /// Whether it is a quaternion as such, be its scalar or vector part zero.
    #[must_use]
    pub(super) fn is_quaternion(&self) -> bool {
        matches!(self.bare(), Value::Quaternion(_))
    }

    /// The components of a tuple of any length, of a vector or of a quaternion.
    #[must_use]
    pub(super) fn components(&self) -> Option<Vec<Fraction>> {
        match self.bare() {
            Value::Tuple(parts) => Some(parts.clone()),
            Value::Quaternion(value) if !value.is_vector() => Some(value.components().to_vec()),
            other => other.vector().map(|vector| vector.components().to_vec()),
        }
    }
}
