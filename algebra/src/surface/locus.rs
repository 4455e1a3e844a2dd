//! Where polynomials in symbols vanish together.

use std::collections::BTreeMap;
use std::fmt;

use super::elimination::{shortened, without_multiples};
use crate::{Poly, Term, Variable, budget, integer};

/// Units of work for the simplification of one locus; beyond them its equations stay as they are.
const SIMPLIFICATION: u64 = 600_000;

/// Among how many equations one is chosen to be split.
const CANDIDATES: usize = 12;

/// How many branches a simplification may have.
const MOST_BRANCHES: usize = 200;

/// How many terms the alternatives may have in any case; with more of them the equations must be twice as long.
const LONG: usize = 60;

/// A set of real values of symbols: all those at which certain polynomials vanish together.
///
/// It is a union of *alternatives*, each one a list of polynomials that vanish together. Products are split as far as
/// squarefree decomposition, gcds and the discriminants of quadratic polynomials go; a sum of squares vanishes only
/// where all of them do, since symbols are real. So no alternative contains another one as far as the remaining
/// polynomials show. Gröbner bases or a cylindrical decomposition would decide more, at a cost that no budget bounds well; what is
/// wanted here is the few short conditions that a person can read.
///
/// # Example
/// ```
/// use hodograph_algebra::{Locus, Poly, Variable};
/// let [a, b, c] = ["a", "b", "c"].map(|name| Poly::variable(&Variable::new(Variable::SYMBOL, name)));
/// let product = (a.pow(2) - b.pow(2)) * &c;
/// let locus = Locus::of(&[product], &[]);
/// assert_eq!(locus.to_string(), "c == 0 or a + b == 0 or a - b == 0");
/// assert_eq!(Locus::of(&[a.pow(2) + b.pow(2)], &[]).to_string(), "a == 0 and b == 0");
/// assert!(Locus::of(&[a.pow(2) + Poly::one()], &[]).is_empty());
/// ```
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Locus {
    alternatives: Vec<Vec<Poly>>,
}

impl Locus {
    /// The real points at which all of `equations` vanish; `known` are polynomials that may divide them.
    ///
    /// Complexity: exponential in the number of symbols at worst, but bounded: what exceeds a fixed budget is left as it
    /// is, in one alternative without repeated factors.
    #[must_use]
    pub fn of(equations: &[Poly], known: &[Poly]) -> Locus {
        let solved = budget::with_budget(SIMPLIFICATION, || {
            let mut solver = Solver { known, alternatives: Vec::new(), branches: MOST_BRANCHES };
            solver.solve(Vec::new(), shortened(equations)).then_some(solver.alternatives)
        });
        let plain: Vec<Vec<Poly>> = tidy(equations.to_vec()).into_iter().collect();
        let terms = |alternatives: &[Vec<Poly>]| -> usize {
            alternatives.iter().flatten().map(|poly| poly.terms().len()).sum()
        };
        // What cannot be solved only gets longer by cases.
        let mut alternatives = match solved {
            Ok(Some(alternatives)) if terms(&alternatives) <= LONG.max(terms(&plain) / 2) => alternatives,
            _ => plain,
        };
        alternatives.sort_by_cached_key(|alternative| size(alternative));
        Locus { alternatives }
    }

    /// The points at which all of `equations` vanish, as they are.
    #[must_use]
    pub fn all(equations: &[Poly]) -> Locus {
        Locus { alternatives: vec![equations.to_vec()] }
    }

    /// The set without points.
    #[must_use]
    pub fn empty() -> Locus {
        Locus::default()
    }

    /// Whether it is certainly empty.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.alternatives.is_empty()
    }

    /// The alternatives: at a point of the set all polynomials of at least one of them vanish.
    #[must_use]
    pub fn alternatives(&self) -> &[Vec<Poly>] {
        &self.alternatives
    }

    /// Whether all points of `other` certainly belong to it.
    #[must_use]
    pub fn covers(&self, other: &Locus) -> bool {
        let inside = |inner: &Vec<Poly>| self.alternatives.iter().any(|outer| implies(inner, outer));
        other.alternatives.iter().all(inside)
    }

    /// The set without those alternatives that certainly lie in `other`.
    #[must_use]
    pub fn without(&self, other: &Locus) -> Locus {
        let outside = self.alternatives.iter().filter(|all| !other.covers(&Locus::all(all)));
        Locus { alternatives: outside.cloned().collect() }
    }

    /// The points of either.
    #[must_use]
    pub fn union(&self, other: &Locus) -> Locus {
        let mut alternatives = self.alternatives.clone();
        for alternative in &other.alternatives {
            insert(&mut alternatives, alternative.clone());
        }
        alternatives.sort_by_cached_key(|alternative| size(alternative));
        Locus { alternatives }
    }

    /// Whether the point belongs to it; `None` if a symbol has no value there.
    #[must_use]
    pub fn contains(&self, point: &BTreeMap<Variable, Poly>) -> Option<bool> {
        let mut found = false;
        for alternative in &self.alternatives {
            let values: Vec<Poly> = alternative.iter().map(|poly| poly.evaluate(point)).collect();
            if !values.iter().all(Poly::is_constant) {
                return None;
            }
            found |= values.iter().all(Poly::is_zero);
        }
        Some(found)
    }
}

impl fmt::Display for Locus {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let equation = |poly: &Poly| format!("{poly} == 0");
        let alternatives = self
            .alternatives
            .iter()
            .map(|alternative| alternative.iter().map(equation).collect::<Vec<_>>().join(" and "));
        f.write_str(&alternatives.collect::<Vec<_>>().join(" or "))
    }
}

/// What orders alternatives: short ones first.
fn size(alternative: &[Poly]) -> (usize, usize, String) {
    let terms = alternative.iter().map(|poly| poly.terms().len()).sum();
    let text: Vec<String> = alternative.iter().map(Poly::to_string).collect();
    (alternative.len(), terms, text.join(" "))
}

/// The equations without repeated factors, duplicates and multiples, the shortest first; `None` if one cannot hold.
fn tidy(equations: Vec<Poly>) -> Option<Vec<Poly>> {
    let mut left: Vec<Poly> = equations.into_iter().filter(|poly| !poly.is_zero()).collect();
    if left.iter().any(Poly::is_constant) {
        return None;
    }
    left = left.iter().map(|poly| poly.pruned().normalized()).collect();
    Some(without_multiples(left))
}

/// Splits a system of equations into alternatives, by cases.
struct Solver<'a> {
    known: &'a [Poly],
    alternatives: Vec<Vec<Poly>>,
    /// How many more cases may be looked at.
    branches: usize,
}

impl Solver<'_> {
    /// Collects the alternatives of the system `done` and `pending`, of which `done` cannot be split; gives up with
    /// `false` if there are too many cases.
    fn solve(&mut self, done: Vec<Poly>, pending: Vec<Poly>) -> bool {
        if self.branches == 0 {
            return false;
        }
        self.branches -= 1;
        let Some(pending) = tidy(pending) else { return true };
        let mut pending: Vec<Poly> =
            pending.into_iter().filter(|poly| !done.iter().any(|other| other.divides(poly))).collect();
        if pending.is_empty() {
            let mut done = done;
            done.sort_by_cached_key(|poly| (poly.terms().len(), poly.to_string()));
            insert(&mut self.alternatives, done);
            return true;
        }
        let common = Poly::gcd_many(&pending);
        if pending.len() > 1 && !common.is_constant() {
            let rest = pending.iter().map(|poly| poly.exact_div(&common).unwrap_or_else(Poly::one)).collect();
            return self.solve(done.clone(), vec![common]) && self.solve(done, rest);
        }
        let (position, cases) = self.next(&pending);
        pending.remove(position);
        for factor in cases {
            let squares = sum_of_squares(&factor).or_else(|| sum_of_squares(&-&factor));
            let (mut done, mut pending) = (done.clone(), pending.clone());
            match squares {
                Some(parts) if parts.iter().any(Poly::is_constant) => continue,
                Some(parts) => pending.extend(parts),
                None => match linear_solution(&factor) {
                    Some((variable, value)) => {
                        let (touched, kept) = done.into_iter().partition(|poly| poly.contains(&variable));
                        done = kept;
                        pending.extend::<Vec<Poly>>(touched);
                        for poly in &mut pending {
                            *poly = poly.substitute(&variable, &value);
                        }
                        done.push(factor);
                    }
                    None => done.push(factor),
                },
            }
            if !self.solve(done, pending) {
                return false;
            }
        }
        true
    }
}

impl Solver<'_> {
    /// The equation to split next, with its factors: the shortest one whose factors can all be solved for a symbol, else
    /// the shortest one.
    fn next(&self, pending: &[Poly]) -> (usize, Vec<Poly>) {
        let solvable = |factor: &Poly| {
            linear_solution(factor).is_some()
                || sum_of_squares(factor).is_some()
                || sum_of_squares(&-factor).is_some()
        };
        let mut first = None;
        for (position, poly) in pending.iter().enumerate().take(CANDIDATES) {
            let factors = factors(poly, self.known);
            if factors.iter().all(solvable) {
                return (position, factors);
            }
            first.get_or_insert(factors);
        }
        (0, first.unwrap_or_default())
    }
}

/// The first variable in which a polynomial of degree 1 can be solved, and its value where the polynomial vanishes.
fn linear_solution(poly: &Poly) -> Option<(Variable, Poly)> {
    let total = |term: &Term| poly.ring().exponents(term.monomial).iter().sum::<u32>();
    if poly.terms().iter().any(|term| total(term) > 1) {
        return None;
    }
    let variable = poly.occurring_variables().into_iter().next()?;
    let coefficients = poly.coefficients(&variable);
    let value = -(&coefficients[0] * coefficients[1].inverse());
    Some((variable, value))
}

/// Adds an alternative, unless another one holds wherever it does; those that hold only where it does are dropped.
fn insert(alternatives: &mut Vec<Vec<Poly>>, new: Vec<Poly>) {
    if alternatives.iter().any(|old| implies(&new, old)) {
        return;
    }
    alternatives.retain(|old| !implies(old, &new));
    alternatives.push(new);
}

/// Whether all of `conclusion` vanish where all of `premise` do, as far as solving for variables and division show.
fn implies(premise: &[Poly], conclusion: &[Poly]) -> bool {
    let mut premise = premise.to_vec();
    let mut conclusion = conclusion.to_vec();
    while let Some(position) = premise.iter().position(|poly| linear_solution(poly).is_some()) {
        let Some((variable, value)) = linear_solution(&premise.remove(position)) else { break };
        for poly in premise.iter_mut().chain(&mut conclusion) {
            *poly = poly.substitute(&variable, &value);
        }
    }
    let divided = |poly: &Poly| premise.iter().any(|divisor| !divisor.is_zero() && divisor.divides(poly));
    conclusion.iter().all(|poly| poly.is_zero() || divided(poly))
}

/// The different factors of a polynomial that is not constant, as far as they are found without general factorization:
/// squarefree decomposition, gcds with `known`, contents, and discriminants of quadratic polynomials.
pub(crate) fn factors(poly: &Poly, known: &[Poly]) -> Vec<Poly> {
    let mut left: Vec<Poly> = poly.squarefree().factors.into_iter().map(|(factor, _)| factor).collect();
    let mut found = Vec::new();
    while let Some(factor) = left.pop() {
        let variables = factor.occurring_variables();
        let contents = variables.iter().map(|variable| factor.content_in(variable));
        let divisor = known.iter().map(|known| known.gcd(&factor)).chain(contents);
        let mut divisor = divisor.filter(|divisor| !divisor.is_constant() && *divisor != factor);
        match divisor.next().or_else(|| quadratic_divisor(&factor)) {
            Some(divisor) => {
                if let Some(quotient) = factor.exact_div(&divisor) {
                    left.push(quotient.normalized());
                }
                left.push(divisor);
            }
            None if found.contains(&factor) => {}
            None => found.push(factor),
        }
    }
    found.sort_by_key(|factor| factor.terms().len());
    found
}

/// A proper divisor of a squarefree polynomial without contents, of degree 2 in some variable: it exists exactly if the
/// discriminant is a square.
fn quadratic_divisor(poly: &Poly) -> Option<Poly> {
    let variables = poly.occurring_variables();
    if variables.iter().any(|variable| poly.degree(variable) == Some(1)) {
        return None;
    }
    let variable = variables.into_iter().find(|variable| poly.degree(variable) == Some(2))?;
    let [c, b, a] = <[Poly; 3]>::try_from(poly.coefficients(&variable)).ok()?;
    let discriminant = &b * &b - (&a * &c).scale(&integer(4));
    let split = discriminant.square_split();
    if !split.is_square() {
        return None;
    }
    let root = split.root * split.unit.sqrt_in_field()?;
    let numerator = (&a * Poly::variable(&variable)).scale(&integer(2)) + b - root;
    let divisor = numerator.gcd(poly);
    (!divisor.is_constant() && divisor != poly.normalized()).then_some(divisor)
}

/// Polynomials of which a positive multiple of `poly` is a sum of squares with positive coefficients, where completing
/// squares or even powers show it: `poly` vanishes exactly where all of them do.
fn sum_of_squares(poly: &Poly) -> Option<Vec<Poly>> {
    if poly.is_zero() {
        return Some(Vec::new());
    }
    if poly.is_constant() {
        return poly.sign().is_gt().then(|| vec![Poly::one()]);
    }
    if let Some(roots) = even_powers(poly) {
        return Some(roots);
    }
    for variable in poly.occurring_variables() {
        if poly.degree(&variable) != Some(2) {
            continue;
        }
        let [c, b, a] = <[Poly; 3]>::try_from(poly.coefficients(&variable)).ok()?;
        if !a.is_constant() || a.sign().is_le() {
            continue;
        }
        // 4a·f = (2a x + b)² + 4ac − b²
        let mut squares = sum_of_squares(&((&a * &c).scale(&integer(4)) - &b * &b))?;
        squares.insert(0, (&a * Poly::variable(&variable)).scale(&integer(2)) + b);
        return Some(squares);
    }
    None
}

/// For a sum of even powers with positive coefficients, the square roots of the powers.
fn even_powers(poly: &Poly) -> Option<Vec<Poly>> {
    let variables = poly.occurring_variables();
    let monomials = poly.coefficients_of(&variables);
    let root = |(exponents, coefficient): (&Vec<u32>, &Poly)| {
        let even = exponents.iter().all(|exponent| exponent % 2 == 0) && coefficient.sign().is_gt();
        let powers = variables.iter().zip(exponents).filter(|(_, exponent)| **exponent > 0);
        even.then(|| powers.map(|(variable, _)| Poly::variable(variable)).product::<Poly>())
    };
    monomials.iter().map(root).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn symbols<const N: usize>(names: [&str; N]) -> [Poly; N] {
        names.map(|name| Poly::variable(&Variable::new(Variable::SYMBOL, name)))
    }

    #[test]
    fn definite_quadratic_forms_vanish_at_the_origin_alone() {
        let [a, b, c] = symbols(["a", "b", "c"]);
        let form = a.pow(2) + &a * &b + b.pow(2);
        assert_eq!(Locus::of(std::slice::from_ref(&form), &[]).to_string(), "a == 0 and b == 0");
        assert!(Locus::of(&[&form + Poly::one()], &[]).is_empty());
        let shifted = (&a - &b + Poly::one()).pow(2) + (&b + &c.pow(2)).pow(2);
        assert_eq!(Locus::of(&[shifted], &[]).to_string(), "b + c^2 == 0 and a - b + 1 == 0");
        // Indefinite ones are left.
        assert_eq!(Locus::of(&[a.pow(2) - &b * &c], &[]).alternatives().len(), 1);
    }

    #[test]
    fn alternatives_do_not_contain_each_other() {
        let [a, b] = symbols(["a", "b"]);
        let sum = a.pow(2) + b.pow(2);
        let both = Locus::of(&[&sum * (a.pow(2) - b.pow(2))], std::slice::from_ref(&sum));
        assert_eq!(both.to_string(), "a + b == 0 or a - b == 0");
        let [x, y] = [a.pow(2) - b.pow(2), &a * &b];
        assert_eq!(Locus::of(&[&sum * x, sum * y], &[]).to_string(), "a == 0 and b == 0");
        assert_eq!(Locus::of(&[], &[]).alternatives(), [Vec::new()]);
        let union = Locus::of(std::slice::from_ref(&a), &[]).union(&Locus::of(&[a, b], &[]));
        assert_eq!(union.to_string(), "a == 0");
    }

    #[test]
    fn numbers_of_a_field_are_signed() {
        let [a, b] = symbols(["a", "b"]);
        let root = Poly::sqrt_of(&integer(2));
        assert!(Locus::of(&[a.pow(2) * &root + Poly::one()], &[]).is_empty());
        let split = Locus::of(&[a.pow(2) - b.pow(2).scale(&integer(2)) * (&root * &root)], &[]);
        assert_eq!(split.to_string(), "a + 2*b == 0 or a - 2*b == 0");
        let irrational = a.pow(2) - b.pow(2).scale(&integer(2));
        assert_eq!(Locus::of(std::slice::from_ref(&irrational), &[]).alternatives(), [[irrational.clone()]]);
        let known = Locus::of(&[irrational], &[&a - &b * &root]);
        assert_eq!(known.alternatives().len(), 2);
    }
}
