//! Where polynomials in one parameter get a common zero, depending on symbols.

use super::elimination::{Quotient, modulo, remainder, shortened, without_multiples};
use super::locus::{Locus, factors};
use crate::{Poly, Variable, budget};

/// Units of work for splitting one system into cases.
const SPLITTING: u64 = 6_000_000;

/// How many terms a polynomial may have for its repeated factors to be looked for every time.
const SHORT: usize = 60;

/// How many terms a polynomial may have for all its factors to be looked for.
const LONG: usize = 400;

/// Units of work for the resultants of one case.
const ELIMINATION: u64 = 4_000_000;

/// How many cases one system may have.
const MOST_CASES: usize = 60;

/// Real values of symbols at which polynomials in one parameter have a common zero, real or complex.
///
/// # Example
/// ```
/// use hodograph_algebra::{CommonZero, Poly, Variable};
/// let v = Variable::new(1, "v");
/// let [t, a, b] = [v.clone(), Variable::new(Variable::SYMBOL, "a"), Variable::new(Variable::SYMBOL, "b")]
///     .each_ref()
///     .map(Poly::variable);
/// // (v − a)(v − b) and v² − 1 have one where a or b is 1 or −1.
/// let cases = CommonZero::of(&[(&t - &a) * (&t - &b), t.pow(2) - Poly::one()], &v);
/// let loci: Vec<String> = cases.iter().map(|case| case.locus.as_ref().unwrap().to_string()).collect();
/// assert_eq!(loci.join("; "), "a + 1 == 0; a - 1 == 0; b + 1 == 0; b - 1 == 0");
/// assert!(cases.iter().all(|case| case.exact && case.except.is_empty()));
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CommonZero {
    /// The parameter.
    pub parameter: Variable,
    /// The polynomials, simplified: the system vanishes together at some value of the parameter exactly where these do.
    /// Some of them may be free of the parameter.
    pub polynomials: Vec<Poly>,
    /// The values of the symbols at which they do, the parameter eliminated by resultants; `None` if that needs more than
    /// its share of the budget.
    pub locus: Option<Locus>,
    /// Whether there is a common zero on all of the locus; else it is one that contains all of them.
    pub exact: bool,
    /// Where that may fail, because the degrees of the polynomials fall (the zero is at infinity), or one of them vanishes
    /// identically.
    pub except: Locus,
}

impl CommonZero {
    /// The cases in which the polynomials, not all zero, have a common zero in `parameter`.
    ///
    /// The system is reduced (products split into cases, linear combinations that are squares replaced by their roots,
    /// what lies in the ideal of the others dropped), and then the parameter is eliminated from what is left. Two
    /// polynomials have a common zero exactly where their resultant vanishes, unless both leading coefficients do; of more,
    /// the resultants of the shortest one with all others must vanish (Cox, Little and O'Shea, *Ideals, Varieties, and Algorithms*,
    /// chapter 3, section 6). Complexity: that of the resultants, each of which is under a budget of its own.
    #[must_use]
    pub fn of(polynomials: &[Poly], parameter: &Variable) -> Vec<CommonZero> {
        let split = budget::with_budget(SPLITTING, || {
            let mut cases = Vec::new();
            split(polynomials.to_vec(), parameter, &mut cases).then_some(cases)
        });
        let cases = match split {
            Ok(Some(cases)) => cases,
            _ => vec![polynomials.to_vec()],
        };
        let mut kept: Vec<CommonZero> = Vec::new();
        for case in cases.into_iter().map(|case| eliminated(case, parameter)) {
            if !kept.iter().any(|other| other.covers(&case)) {
                kept.retain(|other| !case.covers(other));
                kept.push(case);
            }
        }
        let terms = |case: &CommonZero| case.polynomials.iter().map(|poly| poly.terms().len()).sum::<usize>();
        kept.sort_by_cached_key(|case| (terms(case), case.locus.as_ref().map(Locus::to_string)));
        kept
    }
}

impl CommonZero {
    /// Whether the other locus certainly lies in this one.
    fn covers(&self, other: &CommonZero) -> bool {
        match (&self.locus, &other.locus) {
            (_, Some(inner)) if inner.is_empty() => true,
            (Some(outer), Some(inner)) => self.exact && outer.covers(inner),
            _ => false,
        }
    }
}

/// The case with the parameter eliminated.
fn eliminated(polynomials: Vec<Poly>, parameter: &Variable) -> CommonZero {
    let (mut moving, fixed): (Vec<&Poly>, Vec<&Poly>) =
        polynomials.iter().partition(|poly| poly.contains(parameter));
    // The one that comes first shall not vanish identically where that can be seen.
    let may_vanish =
        |poly: &Poly| !poly.coefficients(parameter).iter().any(|c| c.is_constant() && !c.is_zero());
    moving.sort_by_key(|poly| (poly.degree(parameter), may_vanish(poly), poly.terms().len()));
    let fixed: Vec<Poly> = fixed.into_iter().cloned().collect();
    let with = |others: Vec<Poly>| fixed.iter().cloned().chain(others).collect::<Vec<Poly>>();
    let leading = |poly: &Poly| poly.coefficients(parameter).pop().unwrap_or_else(Poly::zero);
    let (locus, except) = match moving.as_slice() {
        [] => (Some(Locus::of(&fixed, &[])), Locus::empty()),
        [one] => {
            // A polynomial has a zero unless it becomes constant.
            let varying = one.coefficients(parameter).split_off(1);
            (Some(Locus::of(&fixed, &[])), Locus::of(&with(varying), &[]))
        }
        [first, others @ ..] => {
            let resultants = budget::with_budget(ELIMINATION, || {
                others.iter().map(|other| first.resultant(other, parameter)).collect::<Vec<Poly>>()
            });
            let known: Vec<Poly> = moving.iter().map(|poly| leading(poly)).collect();
            let locus = resultants.ok().map(|resultants| Locus::of(&with(resultants), &known));
            let mut except = Locus::of(&with(known), &[]);
            if others.len() > 1 {
                // Where the first one vanishes identically, the resultants say nothing of the others.
                except = except.union(&Locus::of(&with(first.coefficients(parameter)), &[]));
            }
            (locus, except)
        }
    };
    // A linear one has a single zero, at which all others must vanish.
    let exact = moving.len() <= 2 || moving[0].degree(parameter) == Some(1);
    CommonZero { parameter: parameter.clone(), polynomials, locus, exact, except }
}

/// Collects the cases of a system; gives up with `false` if there are too many.
fn split(system: Vec<Poly>, parameter: &Variable, cases: &mut Vec<Vec<Poly>>) -> bool {
    if cases.len() >= MOST_CASES {
        return false;
    }
    let Some(system) = tidy(system, parameter) else { return true };
    let Some(system) = tidy(shortened(&system), parameter) else { return true };
    let Some(system) = tidy(square_roots(system, parameter), parameter) else { return true };
    for (position, poly) in system.iter().enumerate() {
        let mut others = system.clone();
        others.remove(position);
        let Some(factors) = several_factors(poly, &others) else { continue };
        return factors.into_iter().all(|factor| {
            let mut case = others.clone();
            case.push(factor);
            split(case, parameter, cases)
        });
    }
    let reduced = reduced(&system, parameter);
    if reduced != system {
        return split(reduced, parameter, cases);
    }
    let contains = |case: &Vec<Poly>, other: &Vec<Poly>| other.iter().all(|poly| case.contains(poly));
    if !cases.iter().any(|old| contains(&system, old)) {
        cases.retain(|old| !contains(old, &system));
        cases.push(system);
    }
    true
}

/// Factors of `poly`, if it has several, or a repeated one: what it has in common with others, or, if it is not too long,
/// all that are found.
fn several_factors(poly: &Poly, others: &[Poly]) -> Option<Vec<Poly>> {
    for other in others {
        let common = poly.gcd(other);
        if !common.is_constant()
            && let Some(quotient) = poly.exact_div(&common).filter(|quotient| !quotient.is_constant())
        {
            return Some(vec![common, quotient]);
        }
    }
    if poly.terms().len() > LONG {
        return None;
    }
    let factors = factors(poly, &[]);
    let is_itself = matches!(factors.as_slice(), [one] if one.terms().len() == poly.terms().len());
    (!is_itself).then_some(factors)
}

/// The system without zeros and multiples, shortest first, the short ones without repeated factors.
///
/// Polynomials in the parameter alone are replaced by their gcd, the others by their remainders modulo that. `None` if one is
/// a number other than zero.
fn tidy(system: Vec<Poly>, parameter: &Variable) -> Option<Vec<Poly>> {
    let (plain, symbolic): (Vec<Poly>, Vec<Poly>) =
        system.into_iter().partition(|poly| poly.occurring_variables().iter().all(|v| v == parameter));
    let common = Poly::gcd_many(&plain);
    let mut system: Vec<Poly> = symbolic;
    if !common.is_zero() {
        system = system.iter().map(|poly| modulo(poly, &common, parameter)).collect();
        system.push(common);
    }
    system.retain(|poly| !poly.is_zero());
    if system.iter().any(Poly::is_constant) {
        return None;
    }
    let simple = |poly: &Poly| {
        if poly.terms().len() > SHORT { poly.pruned() } else { poly.squarefree().radical().pruned() }
    };
    Some(without_multiples(system.iter().map(simple).collect()))
}

/// The system without those that lie in the ideal of the others, as far as division shows; those whose remainder modulo
/// another one is much shorter are replaced by it.
fn reduced(system: &[Poly], parameter: &Variable) -> Vec<Poly> {
    let mut system = system.to_vec();
    for position in (0..system.len()).rev() {
        let poly = system.remove(position);
        if remainder(&poly, &system, Quotient::Polynomial).is_zero()
            || vanishes_with(&poly, &system, parameter)
        {
            continue;
        }
        let single = |divisor: &Poly| remainder(&poly, std::slice::from_ref(divisor), Quotient::Polynomial);
        let rests = system.iter().map(single).filter(|rest| 2 * rest.terms().len() <= poly.terms().len());
        let shortest = rests.min_by_key(|rest| rest.terms().len());
        system.insert(position, shortest.unwrap_or(poly));
    }
    system
}

/// Whether `poly` certainly vanishes wherever all of `system` do: after these have been solved for symbols in which they are
/// linear, with coefficients that vanish at rational values of the parameter alone, and at these values.
fn vanishes_with(poly: &Poly, system: &[Poly], parameter: &Variable) -> bool {
    let mut image = poly.clone();
    let mut left = system.to_vec();
    let mut exceptions: Vec<Poly> = Vec::new();
    while let Some((position, symbol)) = solvable(&left, parameter) {
        let solved = left.remove(position).coefficients(&symbol);
        let [constant, slope] = [-&solved[0], solved[1].clone()];
        for poly in left.iter_mut().chain([&mut image]) {
            let degree = poly.degree(&symbol).unwrap_or(0);
            *poly = poly.substitute_fraction(&symbol, &constant, &slope, degree);
        }
        let Some(roots) = slope.real_roots(parameter) else { return false };
        let values: Option<Vec<Poly>> = roots.iter().map(|root| root.exact().cloned()).collect();
        let Some(values) = values else { return false };
        // The slope may have no other zeros than these.
        let multiplicity: u32 = roots.iter().map(|root| root.multiplicity()).sum();
        if slope.degree(parameter) != Some(multiplicity) {
            return false;
        }
        exceptions.extend(values);
    }
    let at = |poly: &Poly, value: &Poly| poly.substitute(parameter, value);
    image.is_zero()
        && exceptions.iter().all(|value| {
            let premises: Vec<Poly> = system.iter().map(|poly| at(poly, value)).collect();
            Locus::of(&[at(poly, value)], &[]).covers(&Locus::of(&premises, &[]))
        })
}

/// The first polynomial that is linear in a symbol, with a coefficient that contains the parameter alone.
fn solvable(system: &[Poly], parameter: &Variable) -> Option<(usize, Variable)> {
    system.iter().enumerate().find_map(|(position, poly)| {
        let linear = |symbol: &Variable| {
            symbol != parameter
                && poly.degree(symbol) == Some(1)
                && poly.coefficients(symbol)[1].occurring_variables().iter().all(|v| v == parameter)
        };
        poly.occurring_variables().into_iter().find(linear).map(|symbol| (position, symbol))
    })
}

/// The system with two polynomials replaced by the roots of their sum and difference where these are squares: σ and x' of a
/// PH curve by the parts of its preimage.
fn square_roots(system: Vec<Poly>, parameter: &Variable) -> Vec<Poly> {
    let mut system = system;
    let root = |poly: Poly| {
        let split = poly.square_split();
        (split.is_square() && !split.root.is_constant()).then_some(split.root)
    };
    for i in 0..system.len() {
        for j in 0..i {
            let (a, b) = (&system[i], &system[j]);
            let (m, n) = (a.degree(parameter).unwrap_or(0), b.degree(parameter).unwrap_or(0));
            if m.max(n) % 2 == 1 || m.max(n) == 0 || a.is_constant() || b.is_constant() {
                continue;
            }
            let (sum, difference) = (root(a + b), root(a - b));
            match (sum, difference) {
                (Some(sum), Some(difference)) => {
                    system[i] = sum;
                    system[j] = difference;
                }
                (Some(one), None) | (None, Some(one)) => {
                    let longer = if a.terms().len() > b.terms().len() { i } else { j };
                    system[longer] = one;
                }
                (None, None) => {}
            }
        }
    }
    system
}
