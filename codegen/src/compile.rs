//! The pipeline: from an item's meaning to the source text of its evaluator.
//!
//! ```text
//! Model --derive--> Derivation --schedule--> Program, exact --check--> --round--> Program, floats --emit--> tokens
//! ```

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::fmt;

use hodograph_algebra::budget::{self, Exhausted};
use hodograph_algebra::{
    BoxSign, ControlNet, Derivation, Essentials, Fraction, OffsetError, Poly, Rational, SweptSurface,
    Variable, integer,
};
use proc_macro2::TokenStream;
use quote::quote;

use crate::choice;
use crate::emit::{self, Artifact, PieceOf, Setting};
use crate::language::ast::{self, ExprKind, File, ItemKind, Verdict};
use crate::language::{Diagnostic, Diagnostics};
use crate::meaning::{Model, Piece, models};
use crate::offset::OffsetPatch;
use crate::proofs::{self, proofs};
use crate::round::{self, RoundError};
use crate::schedule::{self, Derived, Mismatch, Preference, ScheduleError, outputs};

/// The work that the macro spends on the claims of one sweep, in units of [`budget`]; claims on degrees always count as
/// affordable. What does not fit is left to `hodograph verify` and the tests.
pub const CLAIMS_LIMIT: u64 = 400_000;

/// Why a sweep has no evaluator.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum CompileError {
    /// It is a lemma, which has no surface.
    NoSurface,
    /// The formula gives a curve or a point.
    Degenerate(OffsetError),
    /// The derivation needs more than the budget.
    Exhausted(Exhausted),
    /// The polynomials have no schedule.
    Schedule(ScheduleError),
    /// The schedule is not what was derived: a bug.
    Mismatch(Mismatch),
    /// A constant has no float.
    Round(RoundError),
}

impl fmt::Display for CompileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CompileError::NoSurface => f.write_str("a lemma has no surface, so there is nothing to generate"),
            CompileError::Degenerate(error) => error.fmt(f),
            CompileError::Exhausted(error) => error.fmt(f),
            CompileError::Schedule(error) => error.fmt(f),
            CompileError::Mismatch(error) => {
                write!(f, "the schedule does not give the derived surface: {error}")
            }
            CompileError::Round(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for CompileError {}

/// Derives a model's surface within the [limit](Model::limit) of the model.
///
/// # Errors
/// [`CompileError`] up to the derivation.
pub fn derive(model: &Model) -> Result<Derivation, CompileError> {
    let surface = model.surface.as_ref().ok_or(CompileError::NoSurface)?;
    match budget::with_budget(model.limit, || surface.derive()) {
        Ok(derivation) => derivation.map_err(CompileError::Degenerate),
        Err(exhausted) => Err(CompileError::Exhausted(exhausted)),
    }
}

/// The exact program of a derived surface, proved to give back the derived polynomials.
///
/// # Errors
/// [`CompileError::Schedule`], and [`CompileError::Mismatch`] if the proof fails.
pub fn exact_program(
    model: &Model,
    derivation: &Essentials,
) -> Result<crate::program::Program<Poly>, CompileError> {
    with_derived(model, derivation, |derived| {
        let scheduled =
            |preference| schedule::schedule_preferring(derived, preference).map_err(CompileError::Schedule);
        if model.preference == ast::Preference::Fast {
            let program = scheduled(Preference::Fast)?;
            schedule::check(&program, derived).map_err(CompileError::Mismatch)?;
            return Ok(program);
        }
        let mut program = scheduled(Preference::Accurate)?;
        if derivation.symbols.is_empty() {
            let domain = proofs::domain(derivation);
            let fast = scheduled(Preference::Fast)?;
            let keep = schedule::have_one_sign(derived.parameters, derived.homogeneous, derived.domain);
            program = choice::of_both(program, &fast, &domain, keep).map_err(CompileError::Round)?;
        }
        schedule::check(&program, derived).map_err(CompileError::Mismatch)?;
        // Both are proved to be the point.
        program.replace_output(outputs::POINT, outputs::ACCURATE_POINT);
        Ok(program)
    })
}

/// Proves that a program computes a derived surface.
///
/// # Errors
/// The [`Mismatch`].
pub fn check_program(
    model: &Model,
    derivation: &Essentials,
    program: &crate::program::Program<Poly>,
) -> Result<(), Mismatch> {
    with_derived(model, derivation, |derived| schedule::check(program, derived))
}

/// What a program is scheduled from.
fn with_derived<T>(model: &Model, derivation: &Essentials, work: impl FnOnce(&Derived<'_>) -> T) -> T {
    let length = length(derivation);
    let known = known_polynomials(model, &derivation.parameters);
    let domain = derivation
        .domain
        .each_ref()
        .map(|interval| [rational_near(interval.lower()), rational_near(interval.upper())]);
    let conditions = conditions(model, derivation);
    let is_family = !derivation.symbols.is_empty();
    let unit = |polys: &[Poly]| if is_family { integer(1) } else { round::power_of_size(polys) };
    let coordinates = derivation.homogeneous.coordinates();
    let scale = unit(coordinates);
    let homogeneous = coordinates.each_ref().map(|poly| poly.scale(&scale.recip()));
    // The unit normal does not depend on the size of N.
    let of_normal = derivation.normal.as_ref().map_or_else(|| integer(1), |normal| unit(normal.numerator()));
    let normal = derivation
        .normal
        .as_ref()
        .map(|normal| normal.numerator().each_ref().map(|poly| poly.scale(&of_normal.recip())));
    let normal_root = length.map(|root| root.scale(&of_normal.recip()));
    let factor = derivation.normal.as_ref().map(|normal| normal.factor().scale(&of_normal));
    work(&Derived {
        parameters: derivation.parameters.each_ref(),
        homogeneous: &homogeneous,
        scale,
        normal: normal.as_ref(),
        normal_root: normal_root.as_ref(),
        singular: derivation.orientation.as_ref(),
        factor: factor.as_ref(),
        known: &known,
        domain: &domain,
        conditions: &conditions,
    })
}

/// What the symbols' values must make positive on the domain, so that the curves' parametric speeds are what the formulas
/// take them for.
fn conditions(model: &Model, derivation: &Essentials) -> Vec<Poly> {
    let mut conditions: Vec<Poly> = Vec::new();
    for (_, curve) in model.curves() {
        let condition = curve.speed_condition().filter(|poly| {
            let parameters = derivation.parameters.iter().filter(|parameter| poly.contains(parameter));
            let known = |variable: &Variable| {
                derivation.symbols.contains(variable) || derivation.parameters.contains(variable)
            };
            parameters.count() <= 1 && poly.occurring_variables().iter().all(known)
        });
        conditions.extend(condition.filter(|poly| !conditions.contains(poly)).cloned());
    }
    conditions
}

/// The length of the normal's numerators, if it is a polynomial that is certified to be positive on the domain.
///
/// The sign of a root that depends on symbols is not known; a family takes the root of |N|² instead.
fn length(derivation: &Essentials) -> Option<Poly> {
    let normal = derivation.normal.as_ref().filter(|_| derivation.symbols.is_empty())?;
    let length = normal.length(&derivation.parameters, &derivation.domain)?;
    positive(&length, derivation).then_some(length)
}

/// Whether a polynomial is certified to be positive on the domain.
fn positive(poly: &Poly, derivation: &Essentials) -> bool {
    let parameters = derivation.parameters.iter().cloned();
    let domain: Vec<_> = parameters.zip(derivation.domain.iter().cloned()).collect();
    matches!(poly.sign_on(&domain), Some(BoxSign::Positive))
}

/// The artifact of a model: everything that is emitted for it, within the [limit](Model::limit) of the model.
///
/// # Errors
/// [`CompileError`].
///
/// # Example
/// ```
/// use hodograph_codegen::{compile::compile, language::parse_text, meaning::models};
///
/// let text = "sweep paraboloid {
///     surface R = u*i + v*j + (u^2 + v^2)*k;
///     domain u in 0..1, v in 0..1;
/// }";
/// let (file, _source) = parse_text("paraboloid.sweep", text).unwrap();
/// let artifact = compile(&models(&file).0[0]).unwrap();
/// assert_eq!(artifact.degree, (2, 2));
/// assert_eq!(artifact.coordinate_degrees, [(0, 0), (1, 0), (0, 1), (2, 2)]);
/// assert_eq!(artifact.control_net[8], [1.0, 1.0, 1.0, 2.0]);
/// ```
pub fn compile(model: &Model) -> Result<Artifact, CompileError> {
    let work = || budget::doing("the evaluator", || compile_unlimited(model));
    budget::with_budget(model.limit, work).unwrap_or_else(|exhausted| Err(CompileError::Exhausted(exhausted)))
}

fn compile_unlimited(model: &Model) -> Result<Artifact, CompileError> {
    let surface = model.surface.as_ref().ok_or(CompileError::NoSurface)?;
    let derivation = surface.essentials().map_err(CompileError::Degenerate)?;
    let exact = exact_program(model, &derivation)?;
    let exact = exact.fused();
    let program = round::round(&exact).map_err(CompileError::Round)?;
    let nearest = |number: &Poly| round::nearest(number).map_err(CompileError::Round);
    let symbols = symbols(model, &derivation);
    let mut control_net = Vec::new();
    if symbols.is_empty() {
        let net = ControlNet::of(&derivation.homogeneous, &derivation.domain);
        for point in net.points.iter().flatten() {
            let [w, x, y, z] = point;
            control_net.push([nearest(w)?, nearest(x)?, nearest(y)?, nearest(z)?]);
        }
    }
    let concrete = symbols.is_empty();
    let proofs = concrete
        .then(|| budget::doing("the bounds of rounding errors", || proofs(&derivation, &exact, &program)));
    let offset = match (&derivation.normal, length(&derivation)) {
        (Some(normal), Some(length)) => {
            OffsetPatch::of(&derivation, normal.numerator(), &length).map_err(CompileError::Round)?
        }
        _ => None,
    };
    let [u, v] = &derivation.domain;
    let degree = derivation.homogeneous.degree();
    Ok(Artifact {
        name: model.name.clone(),
        documentation: model.docs.clone(),
        formula: model.formula.join("\n"),
        source: model.source.clone(),
        coordinate_degrees: derivation.homogeneous.degrees().map(|degree| (degree.u, degree.v)),
        degree: (degree.u.max(0) as u32, degree.v.max(0) as u32),
        domain: [[nearest(u.lower())?, nearest(u.upper())?], [nearest(v.lower())?, nearest(v.upper())?]],
        control_net,
        proofs,
        offset,
        piece: model.piece.as_ref().map(|piece| piece_of(piece, v.lower())).transpose()?,
        is_accurate: model.preference == ast::Preference::Accurate && symbols.is_empty(),
        symbols,
        program,
    })
}

/// The place of a surface that begins at an exact v, among the pieces of a larger one.
fn piece_of(piece: &Piece, start: &Poly) -> Result<PieceOf, CompileError> {
    let nearest = round::nearest(start).map_err(CompileError::Round)?;
    let difference = round::exact(nearest).map(|float| (&Poly::from(float) - start).sign());
    Ok(PieceOf {
        of: piece.of.clone(),
        index: piece.index,
        count: piece.count,
        start: if difference == Some(Ordering::Less) { nearest.next_up() } else { nearest },
        start_is_exact: difference == Some(Ordering::Equal),
        meets: false,
    })
}

/// The artifacts of models, in their order; of pieces of one surface that follow one another it is known whether they meet.
pub fn compile_all<'a>(
    models: impl IntoIterator<Item = &'a Model>,
) -> Vec<(&'a Model, Result<Artifact, CompileError>)> {
    let mut previous: Option<&Model> = None;
    let mut artifacts = Vec::new();
    for model in models {
        let mut artifact = compile(model);
        if let (Ok(Artifact { piece: Some(piece), .. }), Some(before)) = (&mut artifact, previous) {
            piece.meets = before.item_name() == model.item_name()
                && budget::with_budget(model.limit, || meets(before, model)).unwrap_or(false);
        }
        artifacts.push((model, artifact));
        previous = Some(model);
    }
    artifacts
}

/// Whether a piece begins with exactly the points with which another one ends.
fn meets(before: &Model, model: &Model) -> bool {
    let (Some(first), Some(second)) = (&before.surface, &model.surface) else { return false };
    let [_, v] = second.domain();
    let points = |surface: &SweptSurface| {
        let [_, parameter] = surface.parameters();
        let at = BTreeMap::from([(parameter.clone(), Fraction::from(v.lower().clone()))]);
        let value = |component: &Fraction| {
            component.substitute(&at).or_else(|| component.lowest_terms().substitute(&at))
        };
        surface.position().components().iter().map(value).collect::<Option<Vec<_>>>()
    };
    let (ends, begins) = (points(first), points(second));
    ends.is_some() && ends == begins
}

/// The expansion of a file: a module for each sweep. Lemmas generate nothing.
///
/// Mistakes in the file, sweeps without evaluator, and claims that are found to be other than expected within
/// [`CLAIMS_LIMIT`], are reported at their places.
///
/// # Example
/// ```
/// use hodograph_codegen::{compile::expand, language::{Report, parse_text}};
///
/// let sweep = |degree: &str| {
///     format!("sweep saddle {{ surface R = (u, v, u*v); domain u in 0..1, v in 0..1; claim \"d\": degree(R) == {degree}; }}")
/// };
/// let (file, _source) = parse_text("saddle.sweep", &sweep("(1, 1)")).unwrap();
/// let (tokens, mistakes) = expand(&file);
/// assert!(mistakes.is_empty());
/// assert!(tokens.to_string().contains("mod saddle"));
///
/// let (file, source) = parse_text("saddle.sweep", &sweep("(2, 2)")).unwrap();
/// let report = Report::new(source, expand(&file).1);
/// assert_eq!(report.lines(), ["saddle.sweep:1:81: the claim \"d\" is refuted: (1, 1)"]);
/// ```
#[must_use]
pub fn expand(file: &File) -> (TokenStream, Diagnostics) {
    let (models, mut diagnostics) = models(file);
    let sweeps = || models.iter().filter(|model| model.kind == ItemKind::Sweep);
    for model in sweeps() {
        check_claims(model, &mut diagnostics);
    }
    let mut artifacts = Vec::new();
    for (model, artifact) in compile_all(sweeps()) {
        match artifact {
            Ok(artifact) => artifacts.push(artifact),
            Err(error) => diagnostics.push(Diagnostic::new(model.place, error.to_string())),
        }
    }
    (emit::modules(&artifacts, &quote!(::hodograph)), diagnostics)
}

fn check_claims(model: &Model, diagnostics: &mut Diagnostics) {
    let mut left = CLAIMS_LIMIT;
    for claim in &model.claims {
        let degree = concerns_degree(claim.relation.kind());
        let limit = if degree { budget::DEFAULT_LIMIT } else { left };
        let (judgement, spent) = budget::measured(|| model.check_verdict(claim, limit));
        if !degree {
            left = left.saturating_sub(spent);
        }
        match judgement {
            Err(diagnostic) => diagnostics.push(*diagnostic),
            Ok(judgement)
                if judgement.verdict == judgement.expected || judgement.verdict == Verdict::Undecided => {}
            Ok(judgement) => {
                let message =
                    format!("the claim {:?} is {}: {}", judgement.id, judgement.verdict, judgement.derived);
                let diagnostic = Diagnostic::new(claim.relation.span(), message);
                let help = match (&judgement.witness, judgement.verdict) {
                    (Some(witness), _) => format!("it fails at {witness}"),
                    (None, Verdict::Proved) => "leave out `expect`".to_owned(),
                    (None, _) => "correct the claim, or add `expect refuted`".to_owned(),
                };
                diagnostics.push(diagnostic.help(help));
            }
        }
    }
}

fn concerns_degree(relation: &ExprKind) -> bool {
    match relation {
        ExprKind::Relation { left, .. } => match left.kind() {
            ExprKind::Call { callee, .. } => {
                matches!(callee.kind(), ExprKind::Ident(name) if name == "degree")
            }
            _ => false,
        },
        ExprKind::Not(inner) => concerns_degree(inner.kind()),
        _ => false,
    }
}

/// The polynomials that the paper has names for: speed, position, hodograph and preimage of the curves.
fn known_polynomials(model: &Model, parameters: &[Variable; 2]) -> Vec<(String, Poly)> {
    let mut known: Vec<(String, Poly)> = Vec::new();
    let symbols = model.surface.as_ref().map(|surface| surface.symbols()).unwrap_or_default();
    for (index, (name, curve)) in model.curves().into_iter().enumerate() {
        let prefix = if index == 0 { String::new() } else { format!("{name}_") };
        let mut add = |name: &str, poly: Option<Poly>| {
            let usable = poly.filter(|poly| {
                let occurring = poly.occurring_variables();
                let own = occurring.iter().filter(|variable| parameters.contains(variable)).count();
                let known = |variable| parameters.contains(variable) || symbols.contains(variable);
                own == 1 && occurring.iter().all(known)
            });
            known.extend(usable.map(|poly| (format!("{prefix}{name}"), poly)));
        };
        if let Some([a, b]) = curve.preimage() {
            add("preimage_re", Some(a.clone()));
            add("preimage_im", Some(b.clone()));
        }
        add("sigma", curve.speed().ok().and_then(|speed| speed.to_poly()));
        for (letter, (position, derivative)) in ["x", "y", "z"]
            .iter()
            .zip(curve.position().components().iter().zip(curve.hodograph().components()))
        {
            add(letter, position.to_poly());
            add(&format!("{letter}_prime"), derivative.to_poly());
            if position.to_poly().is_none() {
                add(&format!("{letter}_numerator"), Some(position.numerator().clone()));
            }
        }
        if !symbols.is_empty() {
            add("arclength", curve.arclength().ok().and_then(|arclength| arclength.to_poly()));
        }
    }
    known
}

/// The symbols of a family in the order in which they are set: first the curves' coefficients, then the others.
fn symbols(model: &Model, derivation: &Essentials) -> Vec<Setting> {
    let mut left = derivation.symbols.clone();
    let mut settings = Vec::new();
    for group in model.coefficient_groups() {
        if group.rows.iter().flatten().any(|symbol| left.contains(symbol)) {
            left.retain(|symbol| !group.rows.iter().flatten().any(|other| other == symbol));
            let name = |symbol: &Variable| symbol.name().to_string();
            let rows = group.rows.iter().map(|row| row.iter().map(name).collect()).collect();
            settings.push(Setting::Curve { name: group.curve.clone(), kind: group.kind, rows });
        }
    }
    settings.extend(left.iter().map(|symbol| Setting::Number(symbol.name().to_string())));
    settings
}

/// A rational next to a number, to choose a form of evaluation by.
fn rational_near(number: &Poly) -> Rational {
    number.to_rational().unwrap_or_else(|| number.enclosure(64).lower().clone())
}
