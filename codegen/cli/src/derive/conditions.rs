//! The conditions on symbols under which degrees are other than the generic ones, as sentences.

use hodograph_algebra::{CommonZero, Conditions, Homogeneous, Locus, Offset, Poly, Variable, budget};

/// What is said where there are none because of the budget.
pub(super) const UNDETERMINED: &str = "conditions on the symbols are not determined within the budget";

/// A sentence on what happens for some values of the symbols, and for which ones.
#[derive(Clone, Debug)]
pub(super) struct Statement {
    /// What happens: `the degree of X in v falls below 9`.
    pub(super) what: String,
    /// Where it happens: the alternatives.
    pub(super) alternatives: Vec<Alternative>,
}

/// One of several ways in which something happens.
#[derive(Clone, Debug)]
pub(super) struct Alternative {
    /// The polynomials in the symbols that vanish there; `None` if only `common_zero` is known.
    pub(super) equations: Option<Vec<Poly>>,
    /// The parameter, and polynomials that have a common zero in it there.
    pub(super) common_zero: Option<(Variable, Vec<Poly>)>,
    /// Whether it happens wherever the polynomials vanish; else it does nowhere but there.
    pub(super) exact: bool,
    /// Where it may or may not happen.
    pub(super) unless: Locus,
}

impl Alternative {
    /// How what happens is related to the equations, if it is one of `several` alternatives or the only one.
    pub(super) fn relation(&self, several: bool) -> &'static str {
        match (self.exact, several) {
            (true, false) => "exactly where",
            (true, true) => "where",
            (false, false) => "only where",
            (false, true) => "perhaps where",
        }
    }
}

/// The conditions of a surface, if their share of the budget suffices.
pub(super) fn of(surface: &Homogeneous, limit: u64) -> Option<Conditions> {
    budget::with_budget(limit.min(Conditions::BUDGET), || Conditions::of(surface)).ok()
}

/// The conditions of the offset, if it has coordinates and the budget suffices.
pub(super) fn of_offset(offset: &Offset, limit: u64) -> Option<Conditions> {
    match offset {
        Offset::Rational(surface) => of(surface, limit),
        Offset::SymbolicRadical { radicand, radical, surface } => {
            let mut conditions = of(surface, limit)?;
            let root = Poly::variable(radical);
            let loci = conditions.coordinates.iter_mut().flatten().chain(&mut conditions.patch);
            let exceptions = conditions.common_factors.iter_mut().map(|common| &mut common.except);
            for locus in loci.chain(exceptions).chain([&mut conditions.weight]) {
                *locus = without_root(locus, &root, radicand);
            }
            Some(conditions)
        }
        _ => None,
    }
}

/// The locus where `root` is the square root of `radicand`: it vanishes where that does, which may be nowhere.
fn without_root(locus: &Locus, root: &Poly, radicand: &Poly) -> Locus {
    let zeros = Locus::of(std::slice::from_ref(radicand), &[]);
    let mut result = Locus::empty();
    for alternative in locus.alternatives() {
        if !alternative.contains(root) {
            result = result.union(&Locus::all(alternative));
        } else if !zeros.alternatives().is_empty() {
            let equations: Vec<Poly> = alternative
                .iter()
                .map(|equation| if equation == root { radicand.clone() } else { equation.clone() })
                .collect();
            result = result.union(&Locus::all(&equations));
        }
    }
    result
}

/// The sentences; what happens only where there is no surface is left out.
pub(super) fn statements(conditions: &Conditions, parameters: &[Variable; 2]) -> Vec<Statement> {
    let mut statements = Vec::new();
    let mut add = |what: String, alternatives: Vec<Alternative>| {
        if !alternatives.is_empty() {
            statements.push(Statement { what, alternatives });
        }
    };
    let weight = &conditions.weight;
    add("W vanishes identically".to_owned(), vanishing(weight, &Locus::empty()));
    let [w, x, y, z] = conditions.generic;
    let patch = w.max(x).max(y).max(z);
    let named = Homogeneous::NAMES.iter().zip(conditions.generic).zip(&conditions.coordinates);
    for ((name, degree), loci) in named {
        for ((parameter, locus), degree) in parameters.iter().zip(loci).zip([degree.u, degree.v]) {
            let what = match degree {
                0 => format!("{name} vanishes identically"),
                _ => format!("the degree of {name} in {parameter} falls below {degree}"),
            };
            // Of a coordinate that is constant in both, once is enough.
            let again = degree == 0 && *parameter == parameters[1] && loci[0] == loci[1];
            if !again {
                add(what, vanishing(locus, weight));
            }
        }
    }
    for ((parameter, locus), degree) in parameters.iter().zip(&conditions.patch).zip([patch.u, patch.v]) {
        let what = format!("the degree of the patch in {parameter} falls below {degree}");
        add(what, vanishing(locus, weight));
    }
    let mut common: Vec<Alternative> = conditions.common_factors.iter().flat_map(common_factor).collect();
    common.extend(conditions.undetermined.iter().map(|factor| Alternative {
        equations: None,
        common_zero: Some((parameters[1].clone(), vec![factor.clone()])),
        exact: false,
        unless: Locus::empty(),
    }));
    add("W, X, Y and Z have a common factor".to_owned(), common);
    statements
}

fn vanishing(locus: &Locus, weight: &Locus) -> Vec<Alternative> {
    let elsewhere = locus.without(weight);
    let alternatives = elsewhere.alternatives().iter();
    alternatives
        .map(|alternative| Alternative {
            equations: Some(alternative.clone()),
            common_zero: None,
            exact: true,
            unless: Locus::empty(),
        })
        .collect()
}

fn common_factor(case: &CommonZero) -> Vec<Alternative> {
    let alternative = |equations: Option<Vec<Poly>>| Alternative {
        equations,
        common_zero: Some((case.parameter.clone(), case.polynomials.clone())),
        exact: case.exact,
        unless: case.except.clone(),
    };
    match &case.locus {
        Some(locus) => locus.alternatives().iter().cloned().map(|all| alternative(Some(all))).collect(),
        None => vec![Alternative { exact: true, ..alternative(None) }],
    }
}
