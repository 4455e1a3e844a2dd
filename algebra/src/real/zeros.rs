//! Where a polynomial vanishes on a box.

use std::cmp::Ordering;
use std::fmt;

use super::interval::Interval;
use super::roots::RealRoot;
use super::subdivision::{self, Decision, Point};
use crate::{Poly, Variable};

/// The zeros of a polynomial on a closed box, by its factors.
///
/// Factors in one variable vanish on lines `u = c`, given by their exact roots. The others are described one by one.
///
/// # Example
/// ```
/// use hodograph_algebra::{Interval, Poly, Variable};
/// let (u, v) = (Variable::new(0, "u"), Variable::new(1, "v"));
/// let (x, y) = (Poly::variable(&u), Poly::variable(&v));
/// let domain = [(u, Interval::unit()), (v, Interval::unit())];
/// // A line, a point and a curve: (2u − 1)·(u² + v²)²·(u + v − 1).
/// let f = (&x + &x - Poly::one()) * (x.pow(2) + y.pow(2)).pow(2) * (&x + &y - Poly::one());
/// let zeros = f.zeros_on(&domain).unwrap();
/// assert_eq!(zeros.to_string(), "u = 1/2; (u, v) = (0, 0); u + v - 1 = 0");
/// assert!(zeros.is_complete());
/// let point = zeros.witness(&domain).unwrap();
/// assert!(f.evaluate(&point).is_zero());
/// ```
#[derive(Clone, Debug, Default)]
pub struct ZeroSet {
    /// The lines `variable = root` of the factors in one variable, their multiplicities included.
    pub lines: Vec<RealRoot>,
    /// Isolated zeros of the other factors, besides those on lines and curves.
    pub points: Vec<Point>,
    /// Isolated zeros of which one coordinate is known as a number, and the other one as a root.
    pub roots: Vec<EdgeZeros>,
    /// The factors in several variables that have, or may have, further zeros on the box.
    pub curves: Vec<ZeroCurve>,
}

/// A squarefree factor in several variables that vanishes on a box, or may do so.
#[derive(Clone, Debug)]
pub struct ZeroCurve {
    /// The factor, normalized.
    pub polynomial: Poly,
    /// How often it divides.
    pub multiplicity: u32,
    /// Points of the box at which it is positive and negative, so that a curve of zeros separates them; `None` if it is
    /// not known whether there are any zeros inside.
    pub crossing: Option<(Point, Point)>,
    /// Its zeros on the four edges of a box in two variables.
    pub edges: Vec<EdgeZeros>,
}

/// The zeros of a polynomial in two variables on one edge of a box, or on another line where one of the variables is constant.
#[derive(Clone, Debug)]
pub struct EdgeZeros {
    /// The variable that is constant.
    pub fixed: Variable,
    /// Its value.
    pub value: Poly,
    /// The other variable at the zeros.
    pub roots: Vec<RealRoot>,
}

impl ZeroSet {
    /// Whether there are no zeros on the box. This is a proof if true; if false, a curve may turn out to have none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.lines.is_empty() && self.points.is_empty() && self.roots.is_empty() && self.curves.is_empty()
    }

    /// Whether all zeros are known: those of each curve are where it says.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.curves.iter().all(|curve| curve.crossing.is_some())
    }

    /// Whether a point lies on one of the lines or curves, or is one of the points.
    ///
    /// # Example
    /// ```
    /// use hodograph_algebra::{Interval, Point, Poly, Variable};
    /// let (u, v) = (Variable::new(0, "u"), Variable::new(1, "v"));
    /// let (x, y) = (Poly::variable(&u), Poly::variable(&v));
    /// let domain = [(u.clone(), Interval::unit()), (v.clone(), Interval::unit())];
    /// let zeros = (&y * (&x + &y).pow(2) * (&x - &y)).zeros_on(&domain).unwrap();
    /// // u + v vanishes at (0, 0) alone, which is on the line already.
    /// assert_eq!(zeros.to_string(), "v = 0; u - v = 0");
    /// let at = |a, b| Point::from([(u.clone(), Poly::integer(a)), (v.clone(), Poly::integer(b))]);
    /// assert!(zeros.covers(&at(1, 0)) && zeros.covers(&at(1, 1)) && !zeros.covers(&at(0, 1)));
    /// ```
    #[must_use]
    pub fn covers(&self, point: &Point) -> bool {
        let is_on = |root: &RealRoot| {
            point.get(root.variable()).is_some_and(|value| root.compare_number(value).is_eq())
        };
        let mut curves = self.curves.iter().filter(|curve| curve.crossing.is_some());
        self.lines.iter().any(is_on)
            || self.points.contains(point)
            || curves.any(|curve| curve.polynomial.evaluate(point).is_zero())
    }

    /// The zeros without those isolated ones that are zeros of another set.
    #[must_use]
    pub fn without(mut self, other: &ZeroSet) -> ZeroSet {
        self.points.retain(|point| !other.covers(point));
        let is_on = |line: &RealRoot, edge: &EdgeZeros, root: &RealRoot| {
            let is_fixed = *line.variable() == edge.fixed;
            if is_fixed { line.compare_number(&edge.value).is_eq() } else { line.compare(root).is_eq() }
        };
        self.keep_roots(|edge, root| {
            let mut curves = other.curves.iter().filter(|curve| curve.crossing.is_some());
            !other.lines.iter().any(|line| is_on(line, edge, root))
                && !curves.any(|curve| edge.has_zero(&curve.polynomial, root))
        });
        self
    }

    /// The zeros without the isolated ones at which another polynomial vanishes.
    pub(crate) fn without_zeros_of(mut self, poly: &Poly) -> ZeroSet {
        self.points.retain(|point| !poly.evaluate(point).is_zero());
        self.keep_roots(|edge, root| !edge.has_zero(poly, root));
        self
    }

    fn keep_roots(&mut self, keep: impl Fn(&EdgeZeros, &RealRoot) -> bool) {
        for edge in &mut self.roots {
            let roots = std::mem::take(&mut edge.roots);
            edge.roots = roots.into_iter().filter(|root| keep(edge, root)).collect();
        }
        self.roots.retain(|edge| !edge.roots.is_empty());
    }

    /// A point of the box `domain` where the polynomial vanishes, if one is known as numbers.
    #[must_use]
    pub fn witness(&self, domain: &[(Variable, Interval)]) -> Option<Point> {
        let from_line =
            self.lines.iter().find_map(|root| Some((root.variable().clone(), root.exact()?.clone())));
        let on_edge = |curve: &ZeroCurve| {
            curve.edges.iter().find_map(|edge| {
                let root = edge.roots.iter().find(|root| root.exact().is_some())?;
                let other = (root.variable().clone(), root.exact()?.clone());
                Some(Point::from([(edge.fixed.clone(), edge.value.clone()), other]))
            })
        };
        let mut point = from_line
            .map(|line| Point::from([line]))
            .or_else(|| self.points.first().cloned())
            .or_else(|| self.curves.iter().find_map(on_edge))?;
        for (variable, interval) in domain {
            point.entry(variable.clone()).or_insert_with(|| interval.lower().clone());
        }
        Some(point)
    }
}

impl EdgeZeros {
    /// Whether a polynomial vanishes at one of the points of the line.
    fn has_zero(&self, poly: &Poly, root: &RealRoot) -> bool {
        root.sign_of(&poly.substitute(&self.fixed, &self.value)).is_some_and(Ordering::is_eq)
    }
}

impl fmt::Display for ZeroSet {
    /// Lines, points and curves, separated by semicolons, such as `u = 0; (u, v) = (1, 1/2); u^2 - v = 0`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines = self.lines.iter().map(|root| format!("{} = {root}", root.variable()));
        let points = self.points.iter().map(|point| {
            let names: Vec<&str> = point.keys().map(Variable::name).collect();
            let values: Vec<String> = point.values().map(Poly::to_string).collect();
            format!("({}) = ({})", names.join(", "), values.join(", "))
        });
        let roots = self.roots.iter().flat_map(|edge| {
            let text = |root: &RealRoot| {
                let (fixed, value, free) = (edge.fixed.name(), &edge.value, root.variable());
                if edge.fixed < *free {
                    format!("({fixed}, {free}) = ({value}, {root})")
                } else {
                    format!("({free}, {fixed}) = ({root}, {value})")
                }
            };
            edge.roots.iter().map(text)
        });
        let curves = self.curves.iter().map(|curve| {
            let certainty = if curve.crossing.is_some() { "" } else { " (undecided)" };
            format!("{} = 0{certainty}", curve.polynomial)
        });
        let parts: Vec<String> = lines.chain(points).chain(roots).chain(curves).collect();
        f.write_str(if parts.is_empty() { "none" } else { "" })?;
        f.write_str(&parts.join("; "))
    }
}

/// The part of `domain` in the variables that occur in `poly`.
pub(crate) fn occurring(poly: &Poly, domain: &[(Variable, Interval)]) -> Vec<(Variable, Interval)> {
    domain.iter().filter(|(variable, _)| poly.contains(variable)).cloned().collect()
}

/// The decision about one factor that has no factors in a single variable, and its zeros on the edges.
///
/// The box is divided at rational zeros on its edges. If that is not enough, discriminants are computed: where nothing vanishes on an
/// edge and one of them has no root, there are no zeros; rational repeated roots are coordinates of possible singular points, at
/// which the box is divided too.
pub(crate) fn decide_factor(poly: &Poly, domain: &[(Variable, Interval)]) -> (Decision, Vec<EdgeZeros>) {
    let domain = occurring(poly, domain);
    let edges = edge_zeros(poly, &domain);
    let mut cuts: Vec<(Variable, Poly)> = Vec::new();
    let mut cut = |root: &RealRoot| {
        if let (Some(value), true) = (root.to_rational(), cuts.len() < MOST_CUTS) {
            let cut = (root.variable().clone(), Poly::constant(value));
            if !cuts.contains(&cut) {
                cuts.push(cut);
            }
        }
    };
    edges.iter().flat_map(|edge| &edge.roots).for_each(&mut cut);
    let decision = subdivision::decide(poly, &domain, &cuts);
    if !matches!(decision, Decision::Unknown { .. }) || domain.len() != 2 {
        return (decision, edges);
    }
    let folds = folds(poly, &domain);
    if edges.is_empty() && folds.iter().flatten().any(Vec::is_empty) {
        // Zeros on the lines of one variable neither meet nor leave through an edge: there are as many on all, as on an edge.
        let corner =
            domain.iter().map(|(variable, range)| (variable.clone(), range.lower().clone())).collect();
        return (Decision::Strict(poly.evaluate(&corner).sign()), edges);
    }
    let known = cuts.len();
    let singular = folds.iter().flatten().flatten().filter(|root| root.multiplicity() > 1);
    cuts.extend(
        singular.filter_map(|root| Some((root.variable().clone(), Poly::constant(root.to_rational()?)))),
    );
    if cuts.len() == known {
        return (decision, edges);
    }
    (subdivision::decide(poly, &domain, &cuts), edges)
}

/// How many cuts are made for zeros on edges, at most.
const MOST_CUTS: usize = 8;

fn edge_zeros(poly: &Poly, domain: &[(Variable, Interval)]) -> Vec<EdgeZeros> {
    let [first, second] = domain else { return Vec::new() };
    let mut edges = Vec::new();
    for ((fixed, range), (free, interval)) in [(first, second), (second, first)] {
        for value in [range.lower(), range.upper()] {
            let restricted = poly.substitute(fixed, value);
            // A polynomial without factors in one variable vanishes on no edge.
            let roots = restricted.real_roots_in(free, interval).unwrap_or_default();
            if !roots.is_empty() {
                edges.push(EdgeZeros { fixed: fixed.clone(), value: value.clone(), roots });
            }
        }
    }
    edges
}

/// For each variable its values inside the box where two zeros on the line with this value may meet: all at which the other one's
/// derivative vanishes too, real or complex, are among them. `None` where they are not determined.
fn folds(poly: &Poly, domain: &[(Variable, Interval)]) -> [Option<Vec<RealRoot>>; 2] {
    let [first, second] = domain else { return [None, None] };
    [(first, second), (second, first)].map(|((kept, interval), (eliminated, _))| {
        let derivative = poly.derivative(eliminated);
        let degrees = (poly.degree(eliminated)?, derivative.degree(kept)?);
        if degrees.0 * degrees.1 > MOST_ELIMINATED {
            return None;
        }
        poly.resultant(&derivative, eliminated).real_roots_in(kept, interval)
    })
}

/// The product of degrees up to which a discriminant is computed.
const MOST_ELIMINATED: u32 = 64;
