//! Generic degrees: where the symbols of a surface change them.

use std::slice::from_ref;

use super::common_zero::CommonZero;
use super::elimination::{modulo, shortened, without_multiples};
use super::homogeneous::Homogeneous;
use super::locus::{Locus, factors};
use crate::{Bidegree, Poly, Variable, budget};

/// Units of work for the resultants with a factor of the weight that depends on both parameters.
const MIXED: u64 = 4_000_000;

/// Units of work for the simplification of the polynomials that must vanish identically at the same time.
const IDENTICALLY: u64 = 2_000_000;

/// How many factors of leading coefficients are tried in others.
const MOST_KNOWN: usize = 16;

/// Where the degrees of a surface with symbols in it are other than the generic ones.
///
/// The homogeneous coordinates are polynomials in the parameters whose coefficients depend on the symbols. With values in
/// place of these, a degree falls exactly where the coefficients of the highest power vanish together, or where the
/// coordinates get a common factor. A surface without symbols has no conditions.
///
/// # Example
/// ```
/// use hodograph_algebra::{Conditions, Fraction, Homogeneous, Poly, Variable, Vector};
/// let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
/// let [u, v] = parameters.each_ref().map(|p| Fraction::from(Poly::variable(p)));
/// let [a, b] = ["a", "b"].map(|name| Fraction::from(Poly::variable(&Variable::new(Variable::SYMBOL, name))));
/// // R = ((u + a)/(u − b), v, b v²)
/// let position = Vector::new(&(&u + &a) / &(&u - &b), v.clone(), &b * &(&v * &v));
/// let conditions = Conditions::of(&Homogeneous::of(&position, &parameters));
/// assert_eq!(conditions.patch[1].to_string(), "b == 0");
/// assert!(conditions.patch[0].is_empty() && conditions.weight.is_empty());
/// // W = u − b divides Y and Z, and X = u + a where a = −b.
/// assert_eq!(conditions.common_factors[0].locus.as_ref().unwrap().to_string(), "a + b == 0");
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Conditions {
    /// The degrees of W, X, Y, Z without the conditions.
    pub generic: [Bidegree; 4],
    /// For each of W, X, Y, Z, where its degree in the first and in the second parameter is lower.
    pub coordinates: [[Locus; 2]; 4],
    /// Where the degree of the patch in the first and in the second parameter is lower.
    pub patch: [Locus; 2],
    /// Where W vanishes identically, so that there is no surface.
    pub weight: Locus,
    /// Where W, X, Y and Z get a common factor, apart from where W vanishes. Of a factor of W that is a quadratic polynomial
    /// in one parameter without real zeros, the polynomials are this factor alone.
    pub common_factors: Vec<CommonZero>,
    /// The factors of W for which that could not be determined within the budget.
    pub undetermined: Vec<Poly>,
    /// Polynomials that may divide leading coefficients, found with them.
    pub leading_factors: Vec<Poly>,
}

impl Conditions {
    /// Units of work that conditions of a surface, or of what is claimed of it, are worth: some two seconds. Where they do not
    /// suffice, nothing but the conditions is lost.
    pub const BUDGET: u64 = 60_000_000;

    /// The conditions on the symbols of a surface.
    ///
    /// A common factor divides a factor of the weight. For one that depends on a single parameter it exists exactly where
    /// the factor and the coefficients of X, Y and Z by the other parameter have a [common zero](CommonZero); for one that
    /// depends on both, the resultants with X, Y and Z must vanish identically.
    #[must_use]
    pub fn of(surface: &Homogeneous) -> Conditions {
        let parameters = surface.parameters();
        let coordinates = surface.coordinates();
        let mut known = leading_factors(surface);
        let falls = |polys: &[&Poly], known: &[Poly]| {
            parameters.each_ref().map(|parameter| falling_degree(polys, parameter, parameters, known))
        };
        let loci = coordinates.each_ref().map(|coordinate| {
            let loci = falls(&[coordinate], &known);
            // What divides a leading coefficient may divide the next.
            for alternative in loci.iter().flat_map(Locus::alternatives) {
                if let ([one], true) = (alternative.as_slice(), known.len() < MOST_KNOWN) {
                    known.push(one.clone());
                }
            }
            loci
        });
        let patch = falls(&coordinates.each_ref(), &known);
        let factors = weight_factors(surface);
        let mut weight = Locus::empty();
        for factor in &factors {
            weight = weight.union(&vanishing(from_ref(factor), parameters, &[]));
        }
        let [_, others @ ..] = coordinates;
        let (mut common_factors, undetermined) = with_common_factor(&factors, others, parameters);
        // Where the weight vanishes there is nothing to have a factor in common.
        for case in &mut common_factors {
            case.locus = case.locus.as_ref().map(|locus| locus.without(&weight));
        }
        common_factors.retain(|case| case.locus.as_ref().is_none_or(|locus| !locus.is_empty()));
        Conditions {
            generic: surface.degrees(),
            patch,
            coordinates: loci,
            weight,
            common_factors,
            undetermined,
            leading_factors: known,
        }
    }

    /// Whether no values of the symbols change a degree.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.coordinates.iter().flatten().chain(&self.patch).all(Locus::is_empty)
            && self.weight.is_empty()
            && self.common_factors.is_empty()
            && self.undetermined.is_empty()
    }
}

/// Where the degree of a group of polynomials in `by`, one of the parameters, is lower than the generic one: where all
/// coefficients of the highest power vanish. `known` are polynomials that may divide these.
///
/// # Example
/// ```
/// use hodograph_algebra::{Poly, Variable, falling_degree};
/// let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
/// let [u, v] = parameters.each_ref().map(Poly::variable);
/// let [a, b] = ["a", "b"].map(|name| Poly::variable(&Variable::new(Variable::SYMBOL, name)));
/// let f = &a * &u * v.pow(2) + &b * v.pow(2) + &u;
/// assert!(falling_degree(&[&f], &parameters[0], &parameters, &[]).is_empty());
/// assert_eq!(falling_degree(&[&f], &parameters[1], &parameters, &[]).to_string(), "a == 0 and b == 0");
/// ```
#[must_use]
pub fn falling_degree(polys: &[&Poly], by: &Variable, parameters: &[Variable], known: &[Poly]) -> Locus {
    let Some(degree) = polys.iter().filter_map(|poly| poly.degree(by)).max() else { return Locus::empty() };
    let highest = polys.iter().filter(|poly| poly.degree(by) == Some(degree));
    let leading: Vec<Poly> = highest.filter_map(|poly| poly.coefficients(by).pop()).collect();
    vanishing(&leading, parameters, known)
}

/// Where polynomials vanish identically in the parameters.
fn vanishing(polys: &[Poly], parameters: &[Variable], known: &[Poly]) -> Locus {
    let cases = budget::with_budget(IDENTICALLY, || cases_of_vanishing(polys, known));
    let cases = cases.unwrap_or_else(|_| vec![polys.to_vec()]);
    let loci = cases.iter().map(|case| {
        let equations = case.iter().flat_map(|poly| poly.coefficients_of(parameters).into_values());
        Locus::of(&equations.collect::<Vec<_>>(), known)
    });
    loci.fold(Locus::empty(), |union, locus| union.union(&locus))
}

/// The cases in which polynomials vanish, by factors that they have in common and those of the shortest one; multiples of
/// others are left out.
fn cases_of_vanishing(polys: &[Poly], known: &[Poly]) -> Vec<Vec<Poly>> {
    let mut kept = without_multiples(shortened(polys));
    let common = Poly::gcd_many(&kept);
    let mut cases: Vec<Vec<Poly>> = Vec::new();
    if !common.is_constant() {
        cases.extend(factors(&common, known).into_iter().map(|factor| vec![factor]));
        kept = kept.iter().map(|poly| poly.exact_div(&common).unwrap_or_else(Poly::one)).collect();
    }
    if !kept.iter().any(Poly::is_constant) && !kept.is_empty() {
        let first = kept.remove(0);
        let with_others = |factor| std::iter::once(factor).chain(kept.iter().cloned()).collect();
        cases.extend(factors(&first, known).into_iter().map(with_others));
    }
    cases
}

/// Where polynomials without common factor get one, for values of the symbols in them, and the factors of the shortest
/// polynomial for which that could not be determined within the budget.
///
/// # Example
/// ```
/// use hodograph_algebra::{Poly, Variable, common_factors};
/// let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
/// let [u, v] = parameters.each_ref().map(Poly::variable);
/// let a = Poly::variable(&Variable::new(Variable::SYMBOL, "a"));
/// let (cases, undetermined) = common_factors(&[&v - &a, &u * (v.pow(2) - Poly::one())], &parameters);
/// assert!(undetermined.is_empty());
/// let loci: Vec<String> = cases.iter().map(|case| case.locus.as_ref().unwrap().to_string()).collect();
/// assert_eq!(loci, ["a + 1 == 0", "a - 1 == 0"]);
/// ```
#[must_use]
pub fn common_factors(polys: &[Poly], parameters: &[Variable; 2]) -> (Vec<CommonZero>, Vec<Poly>) {
    let mut polys: Vec<Poly> = polys.iter().filter(|poly| !poly.is_zero()).cloned().collect();
    polys.sort_by_key(|poly| poly.terms().len());
    let Some((first, others)) = polys.split_first() else { return (Vec::new(), Vec::new()) };
    with_common_factor(&separated(&[(first.clone(), 1)], parameters), others, parameters)
}

/// The factors of the weight, each once.
fn weight_factors(surface: &Homogeneous) -> Vec<Poly> {
    separated(surface.weight_factors(), surface.parameters())
}

/// The bases of powers, with what depends on the symbols or on one parameter alone split off.
fn separated(powers: &[(Poly, u32)], parameters: &[Variable; 2]) -> Vec<Poly> {
    let [u, v] = parameters;
    let mut factors: Vec<Poly> = Vec::new();
    for (base, _) in powers {
        let mut rest = base.clone();
        for parameters in [parameters.as_slice(), from_ref(u), from_ref(v)] {
            let content = Poly::gcd_many(&rest.coefficients_of(parameters).into_values().collect::<Vec<_>>());
            if let (false, Some(quotient)) = (content.is_constant(), rest.exact_div(&content)) {
                factors.push(content);
                rest = quotient;
            }
        }
        if !rest.is_constant() {
            factors.push(rest);
        }
    }
    factors
}

/// Polynomials that may divide leading coefficients: the factors of the weight and their own leading coefficients.
fn leading_factors(surface: &Homogeneous) -> Vec<Poly> {
    let mut known = weight_factors(surface);
    for mut factor in known.clone() {
        for parameter in surface.parameters() {
            factor = factor.coefficients(parameter).pop().unwrap_or_else(Poly::zero);
        }
        if !factor.is_constant() {
            known.push(factor);
        }
    }
    known
}

/// Where one of `factors` gets a factor in common with all of `others`, and those of which that is not known.
fn with_common_factor(
    factors: &[Poly],
    others: &[Poly],
    parameters: &[Variable; 2],
) -> (Vec<CommonZero>, Vec<Poly>) {
    let mut cases = Vec::new();
    let mut undetermined = Vec::new();
    for factor in factors {
        match common_factor(factor, others, parameters) {
            Some(found) => cases.extend(found),
            None => undetermined.push(factor.clone()),
        }
    }
    (cases, undetermined)
}

/// The cases in which all of `others` have a factor in common with `factor`; `None` if the budget does not suffice.
fn common_factor(factor: &Poly, others: &[Poly], parameters: &[Variable; 2]) -> Option<Vec<CommonZero>> {
    let symbolic = |poly: &Poly| poly.occurring_variables().iter().any(|v| !parameters.contains(v));
    if !symbolic(factor) && !others.iter().any(symbolic) {
        return Some(Vec::new());
    }
    let [u, v] = parameters;
    let by = |parameter: &Variable, other: &Variable| {
        let system = std::iter::once(factor).chain(others).flat_map(|poly| poly.coefficients(other));
        CommonZero::of(&system.filter(|poly| !poly.is_zero()).collect::<Vec<_>>(), parameter)
    };
    // At complex zeros of a real quadratic factor the real and the imaginary part must vanish.
    if let Some(parameter) = parameters.iter().find(|parameter| is_definite_quadratic(factor, parameter)) {
        let rests = others.iter().flat_map(|other| modulo(other, factor, parameter).coefficients(parameter));
        let parts: Vec<Poly> = rests.filter(|poly| !poly.is_zero()).collect();
        let locus = vanishing(&parts, parameters, &[]);
        let case = CommonZero {
            parameter: parameter.clone(),
            polynomials: vec![factor.clone()],
            exact: true,
            except: Locus::empty(),
            locus: Some(locus),
        };
        return Some(if case.locus.as_ref().is_some_and(Locus::is_empty) { Vec::new() } else { vec![case] });
    }
    match (factor.contains(u), factor.contains(v)) {
        (false, false) => Some(Vec::new()),
        (true, false) => Some(by(u, v)),
        (false, true) => Some(by(v, u)),
        (true, true) => {
            let resultants = budget::with_budget(MIXED, || {
                let resultants = others.iter().map(|other| factor.resultant(other, v));
                resultants.flat_map(|resultant| resultant.coefficients(u)).collect::<Vec<Poly>>()
            });
            let locus = Locus::of(&resultants.ok()?, &[]);
            let mut cases = by(u, v);
            if !locus.is_empty() {
                cases.push(CommonZero {
                    parameter: v.clone(),
                    polynomials: std::iter::once(factor).chain(others).cloned().collect(),
                    locus: Some(locus),
                    exact: false,
                    except: Locus::empty(),
                });
            }
            Some(cases)
        }
    }
}

/// Whether a polynomial is of degree 2 in `parameter`, free of other variables, and has no real zeros.
fn is_definite_quadratic(poly: &Poly, parameter: &Variable) -> bool {
    if poly.occurring_variables() != from_ref(parameter) {
        return false;
    }
    let Ok([c, b, a]) = <[Poly; 3]>::try_from(poly.coefficients(parameter)) else { return false };
    (&b * &b - a * c * Poly::integer(4)).sign().is_lt()
}
