//! The names of one item and their values.

use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use hodograph_algebra::{
    Calculus, Conditions, Curve, Fraction, Homogeneous, Interval, Poly, SweptSurface, Variable, Vector,
};

use super::fault::Fault;
use super::group::CoefficientGroup;
use super::pieces::Joints;
use super::value::{ComplexFraction, Value};
use crate::language::ast::{Item, Name};
use crate::language::{Diagnostic, Span, closest};

/// Functions of the language, which cannot be redefined.
pub(super) const FUNCTIONS: &[&str] = &[
    "abs",
    "approx",
    "bernstein",
    "bernstein_coefficient",
    "bernstein_product",
    "bezier",
    "bezier_patch",
    "canal",
    "conj",
    "continuity",
    "coprime",
    "cos",
    "cross",
    "curve_from_hodograph",
    "degree",
    "diff",
    "dot",
    "exp",
    "frame",
    "frames",
    "frames_file",
    "gcd",
    "homogeneous",
    "im",
    "is_pn",
    "is_rational",
    "norm2",
    "normal",
    "offset",
    "parallel",
    "ph",
    "ph_hermite",
    "ph_spatial",
    "pipe",
    "polynomial_curve",
    "positive",
    "quat",
    "rational_curve",
    "re",
    "regular_curve",
    "resultant",
    "rrmf",
    "rrmf_hermite",
    "similarity",
    "similarity_offset",
    "sin",
    "sqrt",
];

/// Names that always have a value, which cannot be redefined.
const CONSTANTS: &[&str] = &["I", "i", "j", "k", "pi"];

/// Homogeneous coordinates with their conditions.
type KnownConditions = (Homogeneous, Option<Rc<Conditions>>);

/// What a clause introduces besides its own name.
#[derive(Clone, Debug, Default)]
struct News {
    groups: Vec<CoefficientGroup>,
    calculus: Option<Rc<Calculus>>,
    joints: Option<Joints>,
}

/// The names of one item and their values.
#[derive(Clone, Debug)]
pub(super) struct Scope {
    values: BTreeMap<String, (Value, Span)>,
    /// Names whose definitions failed.
    poisoned: BTreeSet<String>,
    /// The parameters, in their order.
    pub(super) parameters: Vec<Variable>,
    /// The interval of each parameter that has a domain.
    pub(super) domains: BTreeMap<Variable, Interval>,
    /// Unknown constants, in the order of their declaration.
    pub(super) symbols: Vec<Variable>,
    /// Symbols that are coefficients of curves.
    pub(super) groups: Vec<CoefficientGroup>,
    /// Unknown functions.
    pub(super) calculus: Rc<Calculus>,
    /// The curve that the clause under way defines.
    pub(super) curve: Option<super::curves::CurveContext>,
    /// Symbols and rules that the clause under way introduces.
    news: RefCell<News>,
    /// Whether the item has a surface, be it further down.
    pub(super) has_surface: bool,
    /// The conditions of homogeneous coordinates that have been asked for; `None` where the budget did not suffice.
    pub(super) conditions: Rc<RefCell<Vec<KnownConditions>>>,
    /// Vectors that have been taken for surfaces, with their forms.
    pub(super) patches: Rc<RefCell<Vec<Rc<SweptSurface>>>>,
    /// The item that it belongs to.
    pub(super) item: Option<Rc<Item>>,
    /// Symbols that have values, which may contain other symbols.
    pub(super) settings: BTreeMap<Variable, Fraction>,
    /// The item's own surface.
    pub(super) surface: Option<Rc<SweptSurface>>,
    /// The texts of other files that the source names.
    pub(super) inputs: Rc<BTreeMap<String, Result<String, String>>>,
    /// Which piece is evaluated, from 0.
    pub(super) segment: usize,
    /// Where the pieces meet, once frames have been read.
    pub(super) joints: Option<Joints>,
    /// The scopes of all pieces, where a claim is checked; none if there is one piece only.
    pub(super) siblings: Rc<[Scope]>,
    /// What `continuity` has found, by the place of its argument; all pieces share it.
    pub(super) continuities: Rc<RefCell<Vec<(Span, i64)>>>,
    /// The units of work for all clauses together, and what is left of them.
    pub(super) limit: u64,
    pub(super) left: u64,
}

impl Scope {
    /// A scope with nothing but the parameters, whose clauses may take `limit` units of work together.
    pub(super) fn new(parameters: Vec<Variable>, limit: u64) -> Scope {
        Scope {
            values: BTreeMap::new(),
            poisoned: BTreeSet::new(),
            parameters,
            domains: BTreeMap::new(),
            symbols: Vec::new(),
            groups: Vec::new(),
            calculus: Rc::default(),
            curve: None,
            news: RefCell::default(),
            has_surface: false,
            conditions: Rc::default(),
            patches: Rc::default(),
            item: None,
            settings: BTreeMap::new(),
            surface: None,
            inputs: Rc::default(),
            segment: 0,
            joints: None,
            siblings: Rc::new([]),
            continuities: Rc::default(),
            limit,
            left: limit,
        }
    }

    /// Introduces a curve's symbolic coefficients with the clause under way.
    pub(super) fn announce(&self, group: CoefficientGroup) {
        self.news.borrow_mut().groups.push(group);
    }

    /// Introduces rules for derivatives with the clause under way.
    pub(super) fn announce_calculus(&self, calculus: Rc<Calculus>) {
        self.news.borrow_mut().calculus = Some(calculus);
    }

    /// Introduces the joints of a motion with the clause under way.
    pub(super) fn announce_joints(&self, joints: Joints) {
        self.news.borrow_mut().joints = Some(joints);
    }

    /// Takes over what the clause that stands at `span` has introduced.
    pub(super) fn settle(&mut self, span: Span) -> Result<(), Fault> {
        let news = self.news.take();
        if let Some(calculus) = news.calculus {
            self.calculus = calculus;
        }
        if let Some(joints) = news.joints {
            self.cut(joints, span)?;
        }
        let mut symbols: Vec<Variable> = news.groups.iter().flat_map(|group| group.rows.concat()).collect();
        symbols.sort();
        symbols.dedup();
        self.groups.extend(news.groups);
        for symbol in symbols {
            let name = Name { value: symbol.name().to_owned(), span };
            self.define_symbol(&name)?;
        }
        Ok(())
    }

    /// Cuts the interval of a parameter at the knots of frames: what follows is about one of the pieces.
    fn cut(&mut self, joints: Joints, span: Span) -> Result<(), Fault> {
        let parameter = joints.parameter.clone();
        let stated = self.domains.get(&parameter).filter(|_| self.joints.is_none());
        if let (Some(stated), Some(whole)) = (stated, joints.whole())
            && *stated != whole
        {
            let message =
                format!("the frames run through {whole}, but the domain of `{parameter}` is {stated}");
            return Err(Fault::new(span, message).help("leave out the domain, or give `knots` that fill it"));
        }
        if let Some(interval) = joints.interval(self.segment) {
            self.domains.insert(parameter, interval);
        }
        self.joints = Some(joints);
        Ok(())
    }

    /// Defines a name.
    pub(super) fn define(&mut self, name: &Name, value: Value) -> Result<(), Fault> {
        self.check_new(name)?;
        self.values.insert(name.value.clone(), (value, name.span));
        Ok(())
    }

    /// Reports a name that has a meaning already.
    pub(super) fn check_new(&self, name: &Name) -> Result<(), Fault> {
        let text = name.value.as_str();
        if let Some((_, first)) = self.values.get(text) {
            let message = format!("`{text}` is defined twice");
            let diagnostic = Diagnostic::new(name.span, message).also(*first, "first defined here");
            return Err(diagnostic.help("use another name").into());
        }
        let taken = if let Some(taken) = self.reserved(text) {
            taken
        } else if self.parameters.iter().any(|parameter| parameter.name() == text) {
            "is a parameter"
        } else if self.calculus.is_function(&Variable::new(Variable::SYMBOL, text)) {
            "stands for a derivative of an unknown function, or for a coordinate of a curve"
        } else {
            return Ok(());
        };
        Err(Fault::new(name.span, format!("`{text}` {taken}")).help("use another name"))
    }

    /// Why the item can neither define this name nor use it for a parameter, if that is so.
    pub(super) fn reserved(&self, name: &str) -> Option<&'static str> {
        if CONSTANTS.contains(&name) || FUNCTIONS.contains(&name) {
            Some("has a meaning of its own")
        } else if is_radical(name) {
            Some("is reserved for square roots")
        } else if self.has_surface && COORDINATES.contains(&name) {
            Some("is a homogeneous coordinate of the surface")
        } else {
            None
        }
    }

    /// The curves by their names.
    pub(super) fn curves(&self) -> Vec<(&str, &Curve)> {
        let mut curves = Vec::new();
        for (name, (value, _)) in &self.values {
            if let Value::Curve(curve) = value {
                curves.push((name.as_str(), curve.as_ref()));
            }
        }
        curves
    }

    /// Reports names in use that the derivatives of a new unknown function would have.
    pub(super) fn check_derivatives(&self, function: &Name, parameter: &Variable) -> Result<(), Fault> {
        let mut derivatives = Calculus::new();
        derivatives.function(&function.value, parameter);
        let is_derivative = |name: &&String| derivatives.is_function(&Variable::new(Variable::SYMBOL, name));
        self.check_unused(self.values.keys().find(is_derivative), function.span, "a derivative")
    }

    /// Reports a name in use that the curve `curve` would have for its coordinate `suffix`.
    pub(super) fn check_coordinate(&self, curve: &str, suffix: &str, span: Span) -> Result<(), Fault> {
        let name = format!("{curve}_{suffix}");
        self.check_unused(self.values.contains_key(&name).then_some(&name), span, "a coordinate")
    }

    fn check_unused(&self, taken: Option<&String>, span: Span, role: &str) -> Result<(), Fault> {
        let Some(taken) = taken else { return Ok(()) };
        let message = format!("`{taken}` would also be the name of {role} of this");
        let mut diagnostic = Diagnostic::new(span, message);
        if let Some((_, first)) = self.values.get(taken) {
            diagnostic = diagnostic.also(*first, "defined here");
        }
        Err(diagnostic.help("use another name").into())
    }

    /// The declared function that `variable` is, or is a derivative of; or the curve that it belongs to, with `true`.
    pub(super) fn owner(&self, variable: &Variable) -> Option<(&str, bool)> {
        if !self.calculus.is_function(variable) {
            return None;
        }
        let belongs = |name: &str| {
            let rest = variable.name().strip_prefix(name);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('_'))
        };
        let declared = self.values.iter().filter_map(|(name, (value, _))| match value {
            Value::Function(_) if belongs(name) => Some((name.as_str(), false)),
            Value::Curve(_) if belongs(name) => Some((name.as_str(), true)),
            _ => None,
        });
        declared.max_by_key(|(name, _)| name.len())
    }

    /// All unknown constants and functions.
    pub(super) fn unknowns(&self) -> Vec<Variable> {
        let functions = self.values.keys().map(|name| Variable::new(Variable::SYMBOL, name));
        let functions = functions.filter(|variable| self.calculus.is_function(variable));
        self.symbols.iter().cloned().chain(functions).collect()
    }

    /// Puts another surface in the place of the item's own.
    pub(super) fn replace_surface(&mut self, surface: &Rc<SweptSurface>) {
        let own = self.surface.take();
        for (value, _) in self.values.values_mut() {
            if let (Value::Surface(known), Some(own)) = (&*value, &own)
                && Rc::ptr_eq(known, own)
            {
                *value = Value::Surface(surface.clone());
            }
        }
        self.surface = Some(surface.clone());
    }

    /// Whether a name stands for a parameter, a symbol, an unknown function or a word of the language.
    pub(super) fn is_plain(&self, name: &str) -> bool {
        match self.values.get(name) {
            Some((value, _)) => value.scalar().is_some_and(|scalar| {
                // What a symbol or a function is defined as is itself.
                scalar.factors().is_empty() && scalar.numerator().to_string() == name
            }),
            None => !COORDINATES.contains(&name),
        }
    }

    /// Marks a name whose definition failed: what uses it is not reported again.
    pub(super) fn poison(&mut self, name: &Name) {
        self.poisoned.insert(name.value.clone());
    }

    /// Whether a name has a meaning.
    pub(super) fn knows(&self, name: &str) -> bool {
        self.values.contains_key(name)
            || self.poisoned.contains(name)
            || self.parameters.iter().any(|parameter| parameter.name() == name)
            || constant(name).is_some()
            || FUNCTIONS.contains(&name)
            || (self.surface.is_some() && COORDINATES.contains(&name))
    }

    /// The same scope with a scalar in place of a symbol: the item's clauses, evaluated anew.
    pub(super) fn with_symbol(
        &self,
        symbol: &Variable,
        value: &Fraction,
        span: Span,
    ) -> Result<Scope, Fault> {
        let undefined = |known: &Fraction| {
            let message = format!("`{known}` is not defined where {symbol} = {value}");
            Fault::new(span, message).help("its denominator vanishes there")
        };
        let one = BTreeMap::from([(symbol.clone(), value.clone())]);
        let mut settings = BTreeMap::new();
        for (set, known) in &self.settings {
            settings.insert(set.clone(), known.substitute(&one).ok_or_else(|| undefined(known))?);
        }
        settings.insert(symbol.clone(), value.clone());
        let Some(item) = &self.item else { return Err(Fault::silent(span)) };
        super::clauses::with_settings(self, item, settings).map_err(|fault| {
            let message = format!("where {symbol} = {value}: {}", fault.diagnostic.message);
            let told = Fault::new(span, message);
            if fault.undecidable { told.undecidable() } else { told }
        })
    }

    /// Defines an unknown constant, or gives the name the value that is set for it.
    pub(super) fn define_symbol(&mut self, name: &Name) -> Result<(), Fault> {
        let symbol = Variable::new(Variable::SYMBOL, &name.value);
        match self.settings.get(&symbol) {
            Some(value) => self.define(name, Value::Scalar(value.clone())),
            None => {
                self.define(name, Value::Scalar(Poly::variable(&symbol).into()))?;
                self.symbols.push(symbol);
                Ok(())
            }
        }
    }

    /// The polynomial that a curve's symbolic coefficient is.
    pub(super) fn coefficient(&self, symbol: &Variable, span: Span) -> Result<Poly, Fault> {
        match self.settings.get(symbol) {
            None => Ok(Poly::variable(symbol)),
            Some(value) => value.to_poly().ok_or_else(|| {
                let message = format!("the coefficient {symbol} of a curve is set to the quotient {value}");
                Fault::new(span, message).help("set coefficients of curves to polynomials in other symbols")
            }),
        }
    }

    /// The value of a name.
    pub(super) fn value(&self, name: &str, span: Span) -> Result<Value, Fault> {
        if let Some((value, _)) = self.values.get(name) {
            return Ok(value.clone());
        }
        if self.poisoned.contains(name) {
            return Err(Fault::silent(span));
        }
        if let Some(parameter) = self.parameters.iter().find(|parameter| parameter.name() == name) {
            return Ok(Value::Scalar(Poly::variable(parameter).into()));
        }
        if let Some(value) = constant(name) {
            return Ok(value);
        }
        if let (Some(surface), Some(index)) =
            (&self.surface, COORDINATES.iter().position(|known| *known == name))
        {
            return Ok(Value::Scalar(surface.homogeneous().coordinates()[index].clone().into()));
        }
        if FUNCTIONS.contains(&name) {
            let fault = Fault::new(span, format!("`{name}` is a function and needs arguments"));
            return Err(fault.help(format!("write `{name}(…)`")));
        }
        Err(self.unknown(name, span))
    }

    /// An unknown name, with the closest known one.
    pub(super) fn unknown(&self, name: &str, span: Span) -> Fault {
        let parameters = self.parameters.iter().map(Variable::name);
        let known = self.values.keys().map(String::as_str).chain(parameters);
        let coordinates = COORDINATES.iter().filter(|_| self.surface.is_some());
        let known = known
            .chain(FUNCTIONS.iter().copied())
            .chain(CONSTANTS.iter().copied())
            .chain(coordinates.copied());
        let fault = Fault::new(span, format!("`{name}` is not defined"));
        match closest(name, known) {
            Some(similar) => fault.help(format!("did you mean `{similar}`?")),
            None if COORDINATES.contains(&name) => fault.help("W, X, Y and Z are known after `surface`"),
            None => fault
                .help("define it before its use: `let`, `symbol`, `function`, `profile`, `path` or `curve`"),
        }
    }
}

/// The homogeneous coordinates of an item's surface.
pub(super) const COORDINATES: [&str; 4] = ["W", "X", "Y", "Z"];

fn constant(name: &str) -> Option<Value> {
    Some(match name {
        "i" => Value::Vector(Vector::unit(0)),
        "j" => Value::Vector(Vector::unit(1)),
        "k" => Value::Vector(Vector::unit(2)),
        "pi" => Value::Scalar(Poly::variable(&Variable::new(Variable::SYMBOL, "pi")).into()),
        "I" => {
            let one = ComplexFraction::from(Fraction::one());
            Value::Complex(ComplexFraction { re: one.im, im: one.re })
        }
        _ => return None,
    })
}

/// Whether a name is one that generators of number fields print with: `sqrt2`, `theta`, `theta2`.
fn is_radical(name: &str) -> bool {
    let digits = name.strip_prefix("sqrt").filter(|rest| !rest.is_empty()).or(name.strip_prefix("theta"));
    digits.is_some_and(|digits| digits.bytes().all(|byte| byte.is_ascii_digit()))
}
