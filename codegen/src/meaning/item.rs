//! Items to models: the surface and the claims that a sweep or a lemma stands for.

use std::collections::BTreeMap;
use std::rc::Rc;

use hodograph_algebra::{Curve, Poly, SweptSurface, Variable, budget};

use super::clauses::{run, with_settings};
use super::group::CoefficientGroup;
use super::outline::{parameter_names, parameters, surface_place, symbolic_curves};
use super::pieces::Piece;
use super::scope::Scope;
use crate::language::ast::{
    Claim, Clause, ClauseKind, CurveRole, Expr, ExprKind, File, Item, ItemKind, Preference,
};
use crate::language::{Diagnostic, Diagnostics, Span};

/// What a sweep or a lemma means: its surface, and its claims ready to be checked.
///
/// # Example
/// ```
/// use hodograph_codegen::{language::parse_text, meaning::models};
///
/// let text = "/// A tube.
/// sweep tube {
///     source \"FN (17)\";
///     path s(v) = ph([1, 1 + I]);
///     surface R = s + u*k;
///     domain u in 0..1, v in 0..1;
/// }";
/// let (file, _source) = parse_text("tube.sweep", text).unwrap();
/// let (models, _mistakes) = models(&file);
/// let model = &models[0];
/// assert_eq!((model.name.as_str(), model.source.as_deref()), ("tube", Some("FN (17)")));
/// assert_eq!(model.docs, ["A tube."]);
/// assert_eq!(model.formula[1], "surface R = s + u*k;");
/// assert_eq!(model.surface.as_ref().unwrap().homogeneous().to_string(), "(3, -v^3 + 3*v, 3*v^2, 3*u)");
/// let [(name, curve)] = model.curves()[..] else { panic!() };
/// assert_eq!(format!("{name}: {}", curve.speed().unwrap()), "s: v^2 + 1");
/// ```
#[derive(Clone, Debug)]
pub struct Model {
    /// Sweep or lemma.
    pub kind: ItemKind,
    /// The name.
    pub name: String,
    /// Where the formula of the surface stands; for a lemma, its name.
    pub place: Span,
    /// The documentation, line by line.
    pub docs: Vec<String>,
    /// Where the formula is taken from, as `source` says.
    pub source: Option<String>,
    /// The clauses that define the surface, as the language writes them, one a line.
    pub formula: Vec<String>,
    /// What evaluators should be above all.
    pub preference: Preference,
    /// The surface of a sweep.
    pub surface: Option<Rc<SweptSurface>>,
    /// Which piece of an item in several pieces it is. Each piece is a model with a surface over the piece's own interval, called
    /// by the name of the item, `_` and its number from 1; the pieces of an item follow one another.
    pub piece: Option<Piece>,
    /// The claims, in the order of the source. Of several pieces the first one has the claims, which are about all of them.
    pub claims: Vec<Claim>,
    /// The units of work that a derivation or a program of the surface may take; see [`models_within`].
    pub limit: u64,
    pub(super) path: Option<String>,
    pub(super) scope: Scope,
}

/// The models of all items of a file, and the mistakes in them, within [`budget::DEFAULT_LIMIT`].
///
/// # Example
/// ```
/// use hodograph_codegen::{language::parse_text, meaning::models};
///
/// let text = "lemma right { let a = 1/2; } lemma wrong { let a = (1, 2)*k; }";
/// let (file, _source) = parse_text("two.sweep", text).unwrap();
/// let (models, mistakes) = models(&file);
/// assert_eq!(models.iter().map(|model| model.name.as_str()).collect::<Vec<_>>(), ["right"]);
/// let messages: Vec<&str> = mistakes.iter().map(|mistake| mistake.message.as_str()).collect();
/// assert_eq!(messages, ["a vector and a vector cannot be multiplied with `*`"]);
/// ```
#[must_use]
pub fn models(file: &File) -> (Vec<Model>, Diagnostics) {
    models_within(file, budget::DEFAULT_LIMIT)
}

/// The models of all items of a file, and the mistakes in them. The clauses of the whole file, but for the claims, may
/// take `limit` units of work together, and so may what is derived from each model: see [`Model::limit`].
///
/// # Example
/// ```
/// use hodograph_codegen::{language::{Report, parse_text}, meaning::models_within};
///
/// let text = "lemma power { domain u in 0..1; symbol a; let small = (u + a)^2; let f = 1 + (u + a)^60; }";
/// let (file, source) = parse_text("power", text).unwrap();
/// assert!(models_within(&file, 100_000).1.is_empty());
/// let report = Report::new(source, models_within(&file, 1000).1);
/// assert!(report.lines()[0].starts_with("power:1:78: this needs more than the budget of 1000 units of work"));
/// ```
#[must_use]
pub fn models_within(file: &File, limit: u64) -> (Vec<Model>, Diagnostics) {
    let mut diagnostics = Diagnostics::new();
    let mut models = Vec::new();
    let mut left = limit;
    let inputs = Rc::new(file.inputs.clone());
    for item in &file.items {
        let before = diagnostics.count();
        let inputs = &inputs;
        let (pieces, spent) = budget::measured(|| pieces(item, inputs, limit, left, &mut diagnostics));
        debug_assert!(!pieces.is_empty() || diagnostics.count() > before);
        models.extend(pieces);
        left = left.saturating_sub(spent);
        if left == 0 {
            break;
        }
    }
    check_piece_names(file, &models, &mut diagnostics);
    (models, diagnostics)
}

/// Reports a piece that would have the name of another item.
fn check_piece_names(file: &File, models: &[Model], diagnostics: &mut Diagnostics) {
    for model in models.iter().filter(|model| model.piece.is_some()) {
        if let Some(item) = file.items.iter().find(|item| item.name.value == model.name) {
            let message = format!("`{}` is also the name of a piece of `{}`", model.name, model.item_name());
            diagnostics.push(Diagnostic::new(item.name.span, message).help("use another name"));
        }
    }
}

/// The texts of other files.
type Inputs = Rc<BTreeMap<String, Result<String, String>>>;

/// The models of an item, of which `left` units are left for its clauses: one, or one for each piece of a sweep in several
/// pieces.
fn pieces(item: &Item, inputs: &Inputs, limit: u64, left: u64, diagnostics: &mut Diagnostics) -> Vec<Model> {
    let shared = Rc::new(item.clone());
    let mut scope = Scope::new(parameters(item), limit);
    scope.left = left;
    scope.item = Some(shared.clone());
    scope.inputs = inputs.clone();
    let Some(first) = model(item, scope.clone(), diagnostics) else { return Vec::new() };
    let Some(joints) = first.scope.joints.clone().filter(|joints| joints.count() > 1) else {
        return vec![first];
    };
    let count = joints.count();
    let mut models = vec![first];
    for index in 1..count {
        scope.segment = index;
        scope.left = models.last().map_or(0, |model| model.scope.left);
        let Some(next) = model(item, scope.clone(), diagnostics) else { return Vec::new() };
        models.push(next);
    }
    models[0].scope.siblings = models.iter().map(|model| model.scope.clone()).collect();
    if item.kind == ItemKind::Lemma {
        models.truncate(1);
        return models;
    }
    for (index, model) in models.iter_mut().enumerate() {
        let of = std::mem::replace(&mut model.name, format!("{}_{}", item.name.value, index + 1));
        model.piece = Some(Piece { of, index, count });
        if index > 0 {
            model.claims.clear();
        }
    }
    models
}

/// The model of an item, or of one piece of it, in a scope that knows no names yet.
fn model(item: &Item, mut scope: Scope, diagnostics: &mut Diagnostics) -> Option<Model> {
    let before = diagnostics.count();
    let limit = scope.limit;
    scope.has_surface = surface_place(item).is_some();
    for name in parameter_names(item) {
        if let Some(taken) = scope.reserved(&name.value) {
            let message = format!("`{}` {taken}, so it cannot be a parameter", name.value);
            diagnostics.push(Diagnostic::new(name.span, message).help("use another name"));
        }
    }
    let prefixes = symbolic_curves(item) > 1;
    for fault in run(item, &mut scope, prefixes) {
        fault.into_diagnostics().into_iter().for_each(|one| diagnostics.push(one));
    }
    let surface = scope.surface.clone();
    let source = item.clauses.iter().find_map(|clause| match &clause.kind {
        ClauseKind::Source(text) => Some(text.value.clone()),
        _ => None,
    });
    let preference = item.clauses.iter().find_map(|clause| match &clause.kind {
        ClauseKind::Prefer(preference) => Some(preference.value),
        _ => None,
    });
    let claims: Vec<Claim> = item
        .clauses
        .iter()
        .filter_map(
            |clause| if let ClauseKind::Claim(claim) = &clause.kind { Some(claim.clone()) } else { None },
        )
        .collect();
    // Without budget, definitions are missing that are no mistake.
    for claim in claims.iter().filter(|_| scope.left > 0) {
        for expr in std::iter::once(&claim.relation).chain(&claim.conditions) {
            check_names(&scope, expr, diagnostics);
        }
    }
    if diagnostics.count() > before {
        return None;
    }
    Some(Model {
        kind: item.kind,
        name: item.name.value.clone(),
        place: surface_place(item).unwrap_or(item.name.span),
        docs: item.docs.iter().map(|line| line.value.trim().to_owned()).collect(),
        source,
        limit,
        formula: formula(item, surface.as_deref()),
        preference: preference.unwrap_or_default(),
        surface,
        piece: None,
        claims,
        path: item.clauses.iter().find_map(|clause| match &clause.kind {
            ClauseKind::Curve(curve) if curve.role == CurveRole::Path => Some(curve.name.value.clone()),
            _ => None,
        }),
        scope,
    })
}

/// The clauses that define the surface, one a line; symbols that only claims use are left out.
fn formula(item: &Item, surface: Option<&SweptSurface>) -> Vec<String> {
    let used = surface.map(SweptSurface::symbols).unwrap_or_default();
    let defines = |clause: &&Clause| match &clause.kind {
        ClauseKind::Source(_) | ClauseKind::Claim(_) => false,
        ClauseKind::Symbol(names) if surface.is_some() => {
            names.iter().any(|name| used.iter().any(|symbol| symbol.name() == name.value))
        }
        _ => true,
    };
    item.clauses.iter().filter(defines).map(ToString::to_string).collect()
}

/// Reports unknown names in a claim, which is evaluated only when it is checked.
pub(super) fn check_names(scope: &Scope, expr: &Expr, diagnostics: &mut Diagnostics) {
    match expr.kind() {
        ExprKind::Ident(name) => {
            if !scope.knows(name) {
                diagnostics.push(*scope.unknown(name, expr.span()).diagnostic);
            }
        }
        _ => expr.children().for_each(|child| check_names(scope, child, diagnostics)),
    }
}

impl Model {
    /// The same item where symbols have these values; every clause is evaluated anew.
    ///
    /// # Errors
    /// The first mistake that the values make, such as a curve that becomes a point.
    pub fn with_values(&self, values: &BTreeMap<Variable, Poly>) -> Result<Model, Box<Diagnostic>> {
        let settings = values.iter().map(|(symbol, value)| (symbol.clone(), value.clone().into())).collect();
        let scope = match &self.scope.item {
            Some(item) => with_settings(&self.scope, item, settings).map_err(|fault| fault.diagnostic)?,
            None => self.scope.clone(),
        };
        Ok(Model { surface: scope.surface.clone(), scope, ..self.clone() })
    }

    /// The name of the item in the source; that of a [piece](Model::piece) has its number behind it.
    #[must_use]
    pub fn item_name(&self) -> &str {
        self.piece.as_ref().map_or(&self.name, |piece| &piece.of)
    }

    /// The symbols that are coefficients of curves, in the order of the clauses.
    #[must_use]
    pub fn coefficient_groups(&self) -> &[CoefficientGroup] {
        &self.scope.groups
    }

    /// The curves of the item by their names; the path comes first, then by name.
    #[must_use]
    pub fn curves(&self) -> Vec<(&str, &Curve)> {
        let mut curves = self.scope.curves();
        curves.sort_by_key(|(name, _)| (Some(*name) != self.path.as_deref(), *name));
        curves
    }
}
