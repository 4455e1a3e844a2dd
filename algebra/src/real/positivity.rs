//! The sign of a polynomial on a closed box, decided exactly.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use super::interval::Interval;
use super::roots::RealRoot;
use super::subdivision::{self, Decision, Point};
use super::zeros::{self, ZeroCurve, ZeroSet};
use crate::{Poly, Rational, Variable, budget, ratio};

/// The sign of a polynomial on a closed box.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum BoxSign {
    /// It is positive everywhere on the box.
    Positive,
    /// It is negative everywhere on the box.
    Negative,
    /// It is nowhere negative and not identically zero.
    NonNegative {
        /// Where it vanishes; perhaps nowhere, if this is [not complete](ZeroSet::is_complete).
        zeros: ZeroSet,
    },
    /// It is nowhere positive and not identically zero.
    NonPositive {
        /// Where it vanishes; perhaps nowhere, if this is [not complete](ZeroSet::is_complete).
        zeros: ZeroSet,
    },
    /// It takes both signs.
    ChangesSign {
        /// A point of the box where it is positive.
        positive: Point,
        /// A point of the box where it is negative.
        negative: Point,
    },
    /// It is the zero polynomial.
    Zero,
    /// Subdivision reached its limit.
    Undecided {
        /// The number of halvings that the smallest boxes had gone through.
        depth: u32,
        /// A point of the box where it vanishes, if one was found: it is not positive or negative everywhere then.
        zero: Option<Point>,
    },
}

impl Poly {
    /// Decides the sign of the polynomial on the closed box `domain`, which gives each variable an interval; `None` if
    /// other variables occur.
    ///
    /// The squarefree factors are decided one by one. Those in one variable are decided by their real roots; the others by
    /// subdivision of their Bernstein forms, up to a fixed number of boxes (Farouki and Rajan, *On the numerical condition
    /// of polynomials in Bernstein form*, 1987, for the forms; Garloff, *Convergent bounds for the range of multivariate
    /// polynomials*, 1986, for the subdivision), and those in two by their discriminants where that does not suffice. A
    /// product changes its sign exactly if a factor of odd multiplicity does, since the common zeros of coprime factors
    /// separate nothing. All answers but [`BoxSign::Undecided`] are proofs. What usually cannot be decided is a curve or an
    /// irrational point of zeros without a change of sign.
    ///
    /// # Example
    /// ```
    /// use hodograph_algebra::{BoxSign, Interval, Poly, Variable};
    /// let (u, v) = (Variable::new(0, "u"), Variable::new(1, "v"));
    /// let (x, y) = (Poly::variable(&u), Poly::variable(&v));
    /// let domain = [(u, Interval::unit()), (v, Interval::unit())];
    /// let f = &x * (y.pow(2) + Poly::integer(1));
    /// let Some(BoxSign::NonNegative { zeros }) = f.sign_on(&domain) else { panic!() };
    /// assert_eq!(zeros.to_string(), "u = 0");
    /// assert!(matches!((&x - &y).sign_on(&domain), Some(BoxSign::ChangesSign { .. })));
    /// assert!(matches!((x * y + Poly::one()).sign_on(&domain), Some(BoxSign::Positive)));
    /// ```
    #[must_use]
    pub fn sign_on(&self, domain: &[(Variable, Interval)]) -> Option<BoxSign> {
        if self.is_zero() {
            return Some(BoxSign::Zero);
        }
        let parts = parts(self, domain)?;
        Some(budget::doing("the sign of a polynomial on a box", || combine(self, domain, parts)))
    }

    /// The zeros of the polynomial on the closed box `domain`; `None` for the zero polynomial, and if other variables
    /// occur.
    ///
    /// # Example
    /// ```
    /// use hodograph_algebra::{Interval, Poly, Variable};
    /// let (u, v) = (Variable::new(0, "u"), Variable::new(1, "v"));
    /// let (x, y) = (Poly::variable(&u), Poly::variable(&v));
    /// let domain = [(u, Interval::unit()), (v, Interval::unit())];
    /// let f = (&x + &x - Poly::one()).pow(2) * (&x + y.pow(2) - Poly::one());
    /// assert_eq!(f.zeros_on(&domain).unwrap().to_string(), "u = 1/2; u + v^2 - 1 = 0");
    /// ```
    #[must_use]
    pub fn zeros_on(&self, domain: &[(Variable, Interval)]) -> Option<ZeroSet> {
        if self.is_zero() {
            return None;
        }
        let parts = parts(self, domain)?;
        Some(budget::doing("the zeros of a polynomial on a box", || parts.zeros()))
    }
}

/// A polynomial as a product, each factor with what is known of it on the box.
struct Parts {
    /// The sign of the factor without variables.
    unit: Ordering,
    /// The factors in one variable, all those in the same one together.
    univariate: Vec<Univariate>,
    mixed: Vec<Mixed>,
}

struct Univariate {
    variable: Variable,
    interval: Interval,
    poly: Poly,
    roots: Vec<RealRoot>,
}

struct Mixed {
    poly: Poly,
    multiplicity: u32,
    decision: Decision,
    edges: Vec<zeros::EdgeZeros>,
}

fn parts(poly: &Poly, domain: &[(Variable, Interval)]) -> Option<Parts> {
    let known = |variable: &Variable| domain.iter().any(|(other, _)| other == variable);
    if !poly.occurring_variables().iter().all(known) {
        return None;
    }
    let squarefree = poly.squarefree();
    let mut by_variable: BTreeMap<Variable, Poly> = BTreeMap::new();
    let mut mixed = Vec::new();
    for (factor, multiplicity) in &squarefree.factors {
        let mut rest = factor.clone();
        for (variable, part) in univariate_factors(factor) {
            rest = rest.exact_div(&part)?;
            *by_variable.entry(variable).or_insert_with(Poly::one) *= part.pow(*multiplicity);
        }
        if !rest.is_constant() {
            let (decision, edges) = zeros::decide_factor(&rest, domain);
            mixed.push(Mixed { poly: rest, multiplicity: *multiplicity, decision, edges });
        }
    }
    let mut univariate = Vec::new();
    for (variable, poly) in by_variable {
        let interval = domain.iter().find(|(other, _)| *other == variable)?.1.clone();
        let roots = poly.real_roots_in(&variable, &interval)?;
        univariate.push(Univariate { variable, interval, poly, roots });
    }
    Some(Parts { unit: squarefree.unit.sign(), univariate, mixed })
}

/// The largest factors in a single variable, normalized; the quotient by all of them has none.
fn univariate_factors(poly: &Poly) -> Vec<(Variable, Poly)> {
    let variables = poly.occurring_variables();
    let mut factors = Vec::new();
    for variable in &variables {
        let others: Vec<Variable> = variables.iter().filter(|other| *other != variable).cloned().collect();
        let coefficients: Vec<Poly> = poly.coefficients_of(&others).into_values().collect();
        let factor = Poly::gcd_many(&coefficients);
        if !factor.is_constant() {
            factors.push((variable.clone(), factor));
        }
    }
    factors
}

impl Parts {
    fn zeros(&self) -> ZeroSet {
        let mut zeros = ZeroSet::default();
        for part in &self.univariate {
            zeros.lines.extend(part.roots.iter().cloned());
        }
        for part in &self.mixed {
            let crossing = match &part.decision {
                Decision::Strict(_) => continue,
                Decision::Touches { points, .. } => {
                    let new = points.iter().filter(|point| !zeros.points.contains(point)).cloned();
                    zeros.points.extend(new.collect::<Vec<Point>>());
                    continue;
                }
                Decision::Changes { positive, negative } => Some((positive.clone(), negative.clone())),
                Decision::Unknown { zero, .. } => {
                    zeros.points.extend(zero.iter().cloned());
                    None
                }
            };
            zeros.curves.push(ZeroCurve {
                polynomial: part.poly.clone(),
                multiplicity: part.multiplicity,
                crossing,
                edges: part.edges.clone(),
            });
        }
        // What is on a line or a curve is not isolated.
        let points = std::mem::take(&mut zeros.points);
        zeros.points = points.into_iter().filter(|point| !zeros.covers(point)).collect();
        zeros
    }
}

impl Univariate {
    /// Numbers between the roots inside the interval, and at most one on either side of all: between neighbors there is
    /// exactly one root.
    fn samples(&self) -> Vec<Poly> {
        let mut samples = Vec::new();
        let mut from = self.interval.lower().clone();
        let half = |sum: Poly| sum.scale(&ratio(1, 2));
        for root in &self.roots {
            if root.compare_number(self.interval.lower()).is_gt() {
                let (below, above) = root.bounds();
                samples.push(half(&from + below));
                from = above;
            } else {
                // A root at the lower end.
                from = self.interval.lower().clone();
            }
        }
        let at_end = self.roots.last().is_some_and(|root| root.compare_number(self.interval.upper()).is_eq());
        if !at_end {
            samples.push(half(from + self.interval.upper()));
        }
        samples
    }

    fn sign_at(&self, value: &Poly) -> Ordering {
        self.poly.substitute(&self.variable, value).sign()
    }
}

fn combine(poly: &Poly, domain: &[(Variable, Interval)], parts: Parts) -> BoxSign {
    let mut sign = parts.unit;
    let mut undecided = None;
    // Pairs of points between which a factor of odd multiplicity changes its sign.
    let mut pairs: Vec<(Point, Point)> = Vec::new();
    for part in &parts.univariate {
        let samples = part.samples();
        let signs: Vec<Ordering> = samples.iter().map(|sample| part.sign_at(sample)).collect();
        for (values, signs) in samples.windows(2).zip(signs.windows(2)) {
            if signs[0] != signs[1] {
                let point = |value: &Poly| Point::from([(part.variable.clone(), value.clone())]);
                pairs.push((point(&values[0]), point(&values[1])));
            }
        }
        sign = times(sign, signs.first().copied().unwrap_or(Ordering::Equal));
    }
    for part in parts.mixed.iter().filter(|part| part.multiplicity % 2 == 1) {
        match &part.decision {
            Decision::Strict(own) | Decision::Touches { sign: own, .. } => sign = times(sign, *own),
            Decision::Changes { positive, negative } => pairs.push((positive.clone(), negative.clone())),
            Decision::Unknown { depth, .. } => undecided = undecided.max(Some(*depth)),
        }
    }
    let zeros = parts.zeros();
    if !pairs.is_empty() {
        return match witnesses(poly, domain, &pairs) {
            Some((positive, negative)) => BoxSign::ChangesSign { positive, negative },
            None => BoxSign::Undecided { depth: undecided.unwrap_or(0), zero: zeros.witness(domain) },
        };
    }
    if let Some(depth) = undecided {
        return BoxSign::Undecided { depth, zero: zeros.witness(domain) };
    }
    match (sign, zeros.is_empty()) {
        (Ordering::Greater, true) => BoxSign::Positive,
        (Ordering::Less, true) => BoxSign::Negative,
        (Ordering::Less, false) => BoxSign::NonPositive { zeros },
        _ => BoxSign::NonNegative { zeros },
    }
}

fn times(a: Ordering, b: Ordering) -> Ordering {
    if b.is_lt() { a.reverse() } else { a }
}

/// Points where `poly` is positive and negative, given pairs of points between which one of its factors changes sign.
fn witnesses(
    poly: &Poly,
    domain: &[(Variable, Interval)],
    pairs: &[(Point, Point)],
) -> Option<(Point, Point)> {
    // Values for free variables, at which other factors vanish only by accident.
    let fractions: [Rational; 5] = [ratio(1, 2), ratio(1, 3), ratio(3, 5), ratio(2, 7), ratio(8, 11)];
    let (mut positive, mut negative) = (None, None);
    for fraction in &fractions {
        for point in pairs.iter().flat_map(|(a, b)| [a, b]) {
            let mut point = point.clone();
            for (variable, interval) in domain {
                point.entry(variable.clone()).or_insert_with(|| interval.point(fraction));
            }
            match poly.evaluate(&point).sign() {
                Ordering::Greater => _ = positive.get_or_insert(point),
                Ordering::Less => _ = negative.get_or_insert(point),
                Ordering::Equal => {}
            }
            if let (Some(positive), Some(negative)) = (&positive, &negative) {
                return Some((positive.clone(), negative.clone()));
            }
        }
    }
    match subdivision::decide(poly, domain, &[]) {
        Decision::Changes { positive, negative } => Some((positive, negative)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integer;

    fn setting() -> (Poly, Poly, [(Variable, Interval); 2]) {
        let (u, v) = (Variable::new(0, "u"), Variable::new(1, "v"));
        let (x, y) = (Poly::variable(&u), Poly::variable(&v));
        (x, y, [(u, Interval::unit()), (v, Interval::unit())])
    }

    fn number(n: i64, d: i64) -> Poly {
        Poly::constant(ratio(n, d))
    }

    #[test]
    fn zeros_on_the_boundary() {
        let (x, y, domain) = setting();
        for (f, expected) in [
            (&x * (y.pow(2) + Poly::one()), "u = 0"),
            (&x + &y, "(u, v) = (0, 0)"),
            (&x + (&y - number(1, 3)).pow(2), "(u, v) = (0, 1/3)"),
            ((&x - number(1, 2)).pow(2) + (&y - number(1, 3)).pow(2), "(u, v) = (1/2, 1/3)"),
            ((&x - number(1, 2)).pow(2) * (&y + Poly::one()), "u = 1/2"),
        ] {
            let Some(BoxSign::NonNegative { zeros }) = f.sign_on(&domain) else { panic!("{f}") };
            assert_eq!(zeros.to_string(), expected);
            assert!(zeros.is_complete());
            let witness = zeros.witness(&domain).unwrap();
            assert!(f.evaluate(&witness).is_zero());
            assert!(matches!((-f).sign_on(&domain), Some(BoxSign::NonPositive { .. })));
        }
    }

    #[test]
    fn changes_of_sign_have_witnesses() {
        let (x, y, domain) = setting();
        let half = number(1, 2);
        let thin = (&x - &half) * (&x - &half - Poly::constant(ratio(1, 1 << 60)));
        for f in [
            &x - &y,
            (&x - &half) * (&y - &half),
            (&x - &half) * (&x - &y),
            &thin * (&y + Poly::one()),
            &thin * (&x - &y).pow(2),
            (&x - &y) * (&x + &y - Poly::one()),
            x.pow(2) * Poly::integer(2) - Poly::one(),
        ] {
            let Some(BoxSign::ChangesSign { positive, negative }) = f.sign_on(&domain) else { panic!("{f}") };
            assert_eq!(f.evaluate(&positive).sign(), Ordering::Greater);
            assert_eq!(f.evaluate(&negative).sign(), Ordering::Less);
            for (variable, interval) in &domain {
                assert!(interval.contains(&positive[variable]) && interval.contains(&negative[variable]));
            }
        }
    }

    #[test]
    fn strict_signs_over_number_fields_and_boxes() {
        let (x, y, mut domain) = setting();
        let root = Poly::sqrt_of(&integer(2));
        let f = x.pow(2) + y.pow(2) - &root * &x * &y + number(1, 1000);
        assert!(matches!(f.sign_on(&domain), Some(BoxSign::Positive)));
        assert!(matches!((-&f).sign_on(&domain), Some(BoxSign::Negative)));
        domain[0].1 = Interval::new(root.clone(), Poly::integer(2)).unwrap();
        let g = (x.pow(2) - Poly::integer(2)) * (&y + Poly::one());
        let Some(BoxSign::NonNegative { zeros }) = g.sign_on(&domain) else { panic!() };
        assert_eq!(zeros.to_string(), "u = sqrt2");
        let symbol = Poly::variable(&Variable::new(Variable::SYMBOL, "w"));
        assert!((g * symbol).sign_on(&domain).is_none());
        assert!(matches!(Poly::zero().sign_on(&domain), Some(BoxSign::Zero)));
        assert!(matches!(Poly::integer(-3).sign_on(&domain), Some(BoxSign::Negative)));
    }

    #[test]
    fn valleys_above_zero_are_positive() {
        let (x, y, domain) = setting();
        let least = Poly::constant(ratio(1, 1_000_000_000_000));
        for f in [
            (&x - &y).pow(2) + &least,
            ((&x - &y) * (&x + &y + Poly::one())).pow(2) + &least,
            (&x - y.pow(2)).pow(2) * Poly::integer(3) + x.pow(2) * &least + &least,
            (x.pow(2) * Poly::integer(2) - Poly::one()).pow(2) + (&x - &y).pow(2) + &least,
        ] {
            assert!(matches!(f.sign_on(&domain), Some(BoxSign::Positive)), "{f}");
            assert!(matches!((-&f).sign_on(&domain), Some(BoxSign::Negative)), "{f}");
            // Below zero, the same valleys have zeros.
            let sign = (&f - &least - &least).sign_on(&domain);
            assert!(
                matches!(sign, Some(BoxSign::ChangesSign { .. } | BoxSign::Undecided { .. })),
                "{f}: {sign:?}"
            );
        }
    }

    #[test]
    fn what_cannot_be_decided_says_so() {
        // A sum of squares that vanishes at an irrational point.
        let (x, y, domain) = setting();
        let f = (x.pow(2) * Poly::integer(2) - Poly::one()).pow(2) + (&x - &y).pow(2);
        assert!(matches!(f.sign_on(&domain), Some(BoxSign::Undecided { zero: None, .. })));
        let zeros = f.zeros_on(&domain).unwrap();
        assert!(!zeros.is_complete() && !zeros.is_empty());
    }

    #[test]
    fn edges_of_a_circle() {
        let (x, y, domain) = setting();
        let circle = x.pow(2) + y.pow(2) - Poly::constant(ratio(1, 4));
        let zeros = circle.zeros_on(&domain).unwrap();
        let edges: Vec<String> = zeros.curves[0]
            .edges
            .iter()
            .map(|edge| format!("{} = {}: {}", edge.fixed, edge.value, edge.roots[0]))
            .collect();
        assert_eq!(edges, ["u = 0: 1/2", "v = 0: 1/2"]);
        assert!(zeros.curves[0].crossing.is_some());
    }
}
