//! Values as formulas of a derivation: in the moving frame of a curve where that is shorter, with the radicals that occur.

use std::cell::RefCell;
use std::sync::Arc;

use hodograph_algebra::{
    Fraction, NumberField, OffsetError, Poly, QuadraticFraction, Variable, Vector, budget,
};

use crate::formula;
use crate::meaning::scope::{COORDINATES, Scope};
use crate::meaning::value::Value;

/// The units of work that may go into one formula.
const BUDGET: u64 = 20_000_000;

/// How many digits after the point numbers have beside their exact form.
const DIGITS: u32 = 8;

/// Writes the values of one item.
pub(super) struct Show<'a> {
    scope: &'a Scope,
    longest: usize,
    frames: Vec<Frame>,
    fields: RefCell<Vec<Arc<NumberField>>>,
}

/// The moving frame of a curve that is given by its speed and curvature alone.
struct Frame {
    name: String,
    position: Vector,
    /// Tangent, normal, axis.
    directions: [Vector; 3],
    /// How these are written.
    names: [String; 3],
    /// The symbols for the position and the direction of the frame, which mean nothing to a reader.
    own: Vec<Variable>,
}

impl<'a> Show<'a> {
    /// Writes values with formulas of at most `longest` characters each, as far as there is a choice.
    pub(super) fn new(scope: &'a Scope, longest: usize) -> Show<'a> {
        let frames = scope.curves().into_iter().filter_map(|(name, curve)| {
            let symbol = |suffix: &str| Variable::new(Variable::SYMBOL, &format!("{name}_{suffix}"));
            let own: Vec<Variable> = ["m", "x", "y"].into_iter().map(symbol).collect();
            let directions = [curve.tangent().ok()?, curve.normal().ok()?, curve.axis().ok()?];
            let moves = |vector: &Vector| {
                vector.components().iter().any(|part| part.occurring_variables().contains(&own[0]))
            };
            let axis = if directions[2] == Vector::unit(2) { "k".to_owned() } else { format!("{name}.axis") };
            (scope.calculus.is_function(&own[0]) && moves(&directions[0])).then(|| Frame {
                position: curve.position().clone(),
                names: [format!("{name}.tangent"), format!("{name}.normal"), axis],
                name: name.to_owned(),
                directions,
                own,
            })
        });
        let frames = budget::with_budget(BUDGET, || frames.collect()).unwrap_or_default();
        Show { scope, longest, frames, fields: RefCell::default() }
    }

    /// Any value; `None` for lists, which only stand in constructors.
    pub(super) fn value(&self, value: &Value) -> Option<String> {
        Some(match value.bare() {
            Value::Scalar(scalar) => self.scalar(scalar),
            Value::Complex(complex) if complex.im.is_zero() => self.scalar(&complex.re),
            Value::Complex(complex) => {
                let im = self.scalar(&complex.im);
                let im = if im == "1" { "I".to_owned() } else { format!("{}*I", formula::grouped(&im)) };
                if complex.re.is_zero() { im } else { format!("{} + {im}", self.scalar(&complex.re)) }
            }
            Value::Vector(vector) => self.vector(vector),
            Value::Tuple(parts) if parts.len() <= 3 => self.vector(&value.vector()?),
            Value::Tuple(parts) => self.tuple(parts),
            Value::Curve(curve) => self.vector(curve.position()),
            Value::Surface(surface) => self.vector(surface.position()),
            Value::Offset(offset) => match offset.as_ref() {
                Ok(surface) => self.vector(surface.position()),
                Err(OffsetError::SymbolicRadical { surface: Some(surface), .. }) => {
                    self.vector(&surface.position)
                }
                Err(error) => format!("none: {error}"),
            },
            Value::Degree(degree) => degree.to_string(),
            Value::Form(form) => self.rooted(&[form.value().ok()?]),
            Value::Root(root) => self.rooted(&[root.as_ref().clone()]),
            Value::RootVector(parts) => self.rooted(parts),
            Value::Quaternion(quaternion) => self.tuple(quaternion.components()),
            Value::AdaptedFrame(_)
            | Value::Frame(_)
            | Value::Motion(_)
            | Value::List(_)
            | Value::Function(_) => return None,
        })
    }

    /// The components of a side of an equation.
    pub(super) fn components(&self, components: &[Fraction]) -> String {
        match components {
            [one] => self.scalar(one),
            [re, im] => format!("{} + {}*I", self.scalar(re), formula::grouped(&self.scalar(im))),
            many => self.coordinates(many),
        }
    }

    /// The coordinates of a vector or of a longer tuple.
    pub(super) fn coordinates(&self, coordinates: &[Fraction]) -> String {
        match coordinates {
            [x, y, z] => self.vector(&Vector::new(x.clone(), y.clone(), z.clone())),
            many => self.tuple(many),
        }
    }

    /// The derivatives of the position, the tangent and the normal of a curve whose moving frame is used: a name and its
    /// derivative for each.
    pub(super) fn frame_equations(&self, name: &str) -> Vec<(String, String)> {
        let Some(frame) = self.frames.iter().find(|frame| frame.name == name) else { return Vec::new() };
        let parameter = self.scope.curves().into_iter().find(|(other, _)| *other == name);
        let Some(parameter) = parameter.map(|(_, curve)| curve.parameter().clone()) else {
            return Vec::new();
        };
        let [tangent, normal, _] = &frame.directions;
        let moving = [(&frame.name, &frame.position), (&frame.names[0], tangent), (&frame.names[1], normal)];
        let equation = |(name, vector): (&String, &Vector)| {
            let derivative = self.scope.calculus.vector_derivative(vector, &parameter);
            (format!("diff({name}, {parameter})"), self.vector(&derivative))
        };
        moving.into_iter().map(equation).collect()
    }

    /// A vector: in a moving frame if its symbols are in it, else by its coordinates.
    pub(super) fn vector(&self, vector: &Vector) -> String {
        let framed = self.frames.iter().find_map(|frame| {
            let text = budget::with_budget(BUDGET, || self.in_frame(frame, vector));
            text.ok().flatten()
        });
        framed.unwrap_or_else(|| self.tuple(vector.components()))
    }

    fn in_frame(&self, frame: &Frame, vector: &Vector) -> Option<String> {
        let is_own =
            |part: &Fraction| part.occurring_variables().iter().any(|variable| frame.own.contains(variable));
        if !vector.components().iter().any(is_own) {
            return None;
        }
        let along = |vector: &Vector| {
            let parts = frame.directions.each_ref().map(|direction| vector.dot(direction).lowest_terms());
            (!parts.iter().any(is_own)).then_some(parts)
        };
        let (position, parts) = match along(vector) {
            Some(parts) => (None, parts),
            None => (Some(frame.name.clone()), along(&(vector - &frame.position))?),
        };
        let mut terms: Vec<String> = position.into_iter().collect();
        for (part, name) in parts.iter().zip(&frame.names).filter(|(part, _)| !part.is_zero()) {
            terms.push(match self.scalar(part).as_str() {
                "1" => name.clone(),
                "-1" => format!("-{name}"),
                text => format!("{}*{name}", formula::grouped(text)),
            });
        }
        Some(sum(&terms))
    }

    /// A scalar or a vector with square roots.
    pub(super) fn rooted(&self, parts: &[QuadraticFraction]) -> String {
        let part = |value: &QuadraticFraction| {
            if let Some(rational) = value.to_rational_function() {
                return self.scalar(&rational);
            }
            let root = format!("sqrt({})", self.poly(value.radicand()));
            let root = match self.scalar(value.root_part()).as_str() {
                "1" => root,
                "-1" => format!("-{root}"),
                factor => format!("{}*{root}", formula::grouped(factor)),
            };
            if value.rational_part().is_zero() {
                root
            } else {
                sum(&[self.scalar(value.rational_part()), root])
            }
        };
        match parts {
            [one] => part(one),
            many => format!("({})", many.iter().map(part).collect::<Vec<_>>().join(", ")),
        }
    }

    /// A list of homogeneous coordinates, or of the coordinates of a vector.
    fn tuple(&self, parts: &[Fraction]) -> String {
        let longest = self.longest / parts.len().max(1);
        let parts: Vec<String> = parts.iter().map(|part| self.short(part, longest)).collect();
        format!("({})", parts.join(", "))
    }

    /// A scalar.
    pub(super) fn scalar(&self, scalar: &Fraction) -> String {
        self.short(scalar, self.longest)
    }

    fn short(&self, scalar: &Fraction, longest: usize) -> String {
        self.meet(scalar.numerator());
        scalar.factors().iter().for_each(|(factor, _)| self.meet(factor));
        formula::fraction(scalar, longest)
    }

    /// A polynomial as a product.
    pub(super) fn poly(&self, poly: &Poly) -> String {
        self.meet(poly);
        formula::factored(poly, self.longest)
    }

    /// A number, with a decimal beside it where it is not rational.
    pub(super) fn number(&self, number: &Poly) -> String {
        self.meet(number);
        let exact = formula::polynomial(number, self.longest);
        if number.to_rational().is_some() {
            exact
        } else {
            format!("{exact} = {}…", number.to_decimal(DIGITS))
        }
    }

    /// The scope whose values are written.
    pub(super) fn scope(&self) -> &'a Scope {
        self.scope
    }

    /// The radicals that have occurred: a name, what its square is, and its value to some digits.
    pub(super) fn radicals(&self) -> Vec<(String, String)> {
        let mut radicals: Vec<(String, String)> = Vec::new();
        for field in self.fields.borrow().iter() {
            for (position, generator) in field.generators().iter().enumerate() {
                let radicand = formula::polynomial(&field.radicand(position), self.longest);
                let value = Poly::generator(field, position).to_decimal(DIGITS);
                let relation = format!("{} = sqrt({radicand}) = {value}…", generator.name());
                if !radicals.iter().any(|(_, known)| *known == relation) {
                    radicals.push((generator.name().to_owned(), relation));
                }
            }
        }
        radicals
    }

    fn meet(&self, poly: &Poly) {
        let pruned = poly.pruned();
        let field = pruned.ring().field();
        if !field.generators().is_empty() && !self.fields.borrow().contains(field) {
            self.fields.borrow_mut().push(field.clone());
        }
    }
}

/// The name of a coordinate of a tuple with this many of them.
pub(super) fn component_name(count: usize, index: usize) -> String {
    match count {
        2 | 3 => [".x", ".y", ".z"][index.min(2)].to_owned(),
        4 => format!(".{}", COORDINATES[index.min(3)]),
        _ => format!("[{index}]"),
    }
}

/// Terms as a sum.
fn sum(terms: &[String]) -> String {
    let mut text = String::new();
    for term in terms {
        match (text.is_empty(), term.strip_prefix('-')) {
            (true, _) => text += term,
            (false, Some(rest)) => text += &format!(" - {rest}"),
            (false, None) => text += &format!(" + {term}"),
        }
    }
    if text.is_empty() { "0".to_owned() } else { text }
}
