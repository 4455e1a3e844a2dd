//! Where a surface has no normal.

use super::normal::Normal;
use crate::real::common::common_zeros;
use crate::{Interval, Poly, RealRoot, Variable, ZeroSet, budget};

/// The points of the domain at which `R_u × R_v` vanishes.
///
/// With `R_u × R_v = factor · N` and `N` in lowest terms these are the zeros of the numerator of the factor, such as
/// `1 + κ(v)x(u)`, and the common zeros of the components of `N`, which are the zeros of `|N|²`. Poles, where the weight is 0, are
/// none of them.
///
/// # Example
/// A cone has no normal at its apex:
/// ```
/// use hodograph_algebra::{Fraction, Interval, Poly, SingularLocus, SweptSurface, Variable, Vector};
/// let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
/// let [u, v] = parameters.each_ref().map(|parameter| Fraction::from(Poly::variable(parameter)));
/// let rulings = Vector::new(Fraction::one(), v.clone(), &v * &v);
/// let domain = [Interval::unit(), Interval::unit()];
/// let cone = SweptSurface::new(rulings.scale(&u), parameters, domain);
/// let weight = &cone.homogeneous().coordinates()[0];
/// let locus = SingularLocus::of(cone.normal().unwrap(), weight, cone.parameters(), cone.domain());
/// assert_eq!(locus.factor.to_string(), "u");
/// assert_eq!(locus.factor_zeros.unwrap().to_string(), "u = 0");
/// assert!(locus.normal_zeros.unwrap().is_empty());
/// ```
#[derive(Clone, Debug)]
pub struct SingularLocus {
    /// The numerator of the factor, without content.
    pub factor: Poly,
    /// The zeros of the factor on the domain, without those of parts that it has in common with the weight; `None` where unknown
    /// symbols or the budget keep them from being determined.
    pub factor_zeros: Option<ZeroSet>,
    /// The zeros of `|N|²` on the domain that are no poles, and no zeros of the factor; `None` where unknown symbols or the budget
    /// keep them from being determined.
    pub normal_zeros: Option<ZeroSet>,
}

/// The units of work that the zeros of one polynomial may take: what else is derived is not to be lost with them.
pub(super) const BUDGET: u64 = 100_000_000;

/// The units of work after which zeros of `|N|²` are better found as common zeros of its components.
const QUICK: u64 = 4_000_000;

/// The zeros of a polynomial on the domain, if they can be determined.
pub(super) fn zeros(poly: &Poly, domain: &[(Variable, Interval)]) -> Option<ZeroSet> {
    zeros_within(BUDGET, poly, domain)
}

fn zeros_within(limit: u64, poly: &Poly, domain: &[(Variable, Interval)]) -> Option<ZeroSet> {
    budget::with_budget(limit, || poly.zeros_on(domain)).ok().flatten()
}

impl SingularLocus {
    /// The locus for a normal on the domain, of a surface with this weight.
    #[must_use]
    pub fn of(
        normal: &Normal,
        weight: &Poly,
        parameters: &[Variable; 2],
        domain: &[Interval; 2],
    ) -> SingularLocus {
        let factor_zeros = normal.factor_zeros(weight, parameters, domain, BUDGET);
        let normal_zeros = normal.zeros(weight, parameters, domain, BUDGET);
        let normal_zeros = normal_zeros.map(|zeros| match &factor_zeros {
            Some(factor) => zeros.without(factor),
            None => zeros,
        });
        let factor = normal.factor().lowest_terms().numerator().primitive();
        SingularLocus { factor, factor_zeros, normal_zeros }
    }

    /// Whether the surface is certified to have a normal everywhere on the domain.
    #[must_use]
    pub fn is_regular(&self) -> bool {
        [&self.factor_zeros, &self.normal_zeros]
            .iter()
            .all(|zeros| zeros.as_ref().is_some_and(ZeroSet::is_empty))
    }

    /// The zeros, one text each, such as `u = 1`, or for a curve its equation, such as `u^2 - v = 0`, and where it meets the
    /// boundary of the domain; the word `undetermined` in place of those that depend on
    /// symbols. Numbers print as what `over` maps them to.
    #[must_use]
    pub fn descriptions(&self, mut over: impl FnMut(&Poly) -> Poly) -> Vec<String> {
        let mut all = Vec::new();
        for zeros in [&self.factor_zeros, &self.normal_zeros] {
            let Some(zeros) = zeros else {
                all.push("undetermined: it depends on symbols, or needs more than its budget".to_owned());
                continue;
            };
            for line in &zeros.lines {
                let value =
                    line.exact().map_or_else(|| line.refined(16).to_string(), |n| over(n).to_string());
                all.push(format!("{} = {value}", line.variable()));
            }
            for point in &zeros.points {
                let equations = point.iter().map(|(variable, value)| format!("{variable} = {}", over(value)));
                all.push(equations.collect::<Vec<_>>().join(", "));
            }
            for edge in &zeros.roots {
                let (fixed, value) = (&edge.fixed, over(&edge.value));
                let text = |root: &RealRoot| {
                    format!("{fixed} = {value}, {} = {}", root.variable(), root.refined(16))
                };
                all.extend(edge.roots.iter().map(text));
            }
            for curve in &zeros.curves {
                let certainty = if curve.crossing.is_some() { "" } else { " (undecided)" };
                let mut text = format!("{} = 0{certainty}", over(&curve.polynomial));
                let mut ends = Vec::new();
                for edge in &curve.edges {
                    for root in &edge.roots {
                        let value = root
                            .exact()
                            .map_or_else(|| root.refined(16).to_string(), |n| over(n).to_string());
                        ends.push(format!(
                            "{} = {}, {} = {value}",
                            edge.fixed,
                            over(&edge.value),
                            root.variable()
                        ));
                    }
                }
                if !ends.is_empty() {
                    text.push_str(&format!(", on the boundary at {}", ends.join("; ")));
                }
                all.push(text);
            }
        }
        all.sort();
        all.dedup();
        all
    }
}

impl Normal {
    /// Where the factor vanishes on the domain, on a surface with this weight; points that are poles are left out, and so are the
    /// zeros of what the factor has in common with the weight. `None` where symbols, or the limit of units of work, keep it from
    /// being determined.
    ///
    /// # Example
    /// The cuspidal edge (u, v², v³), whose normal is v·(0, −3v, 2):
    /// ```
    /// use hodograph_algebra::{Fraction, Interval, Poly, SweptSurface, Variable, Vector};
    /// let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
    /// let [u, v] = parameters.each_ref().map(|parameter| Fraction::from(Poly::variable(parameter)));
    /// let around = || Interval::new(Poly::integer(-1), Poly::integer(1)).unwrap();
    /// let square = &v * &v;
    /// let edge = SweptSurface::new(Vector::new(u, square.clone(), &square * &v), parameters, [around(), around()]);
    /// let normal = edge.normal().unwrap();
    /// let zeros = normal.factor_zeros(&Poly::one(), edge.parameters(), edge.domain(), 1_000_000);
    /// assert_eq!(zeros.unwrap().to_string(), "v = 0");
    /// ```
    #[must_use]
    pub fn factor_zeros(
        &self,
        weight: &Poly,
        parameters: &[Variable; 2],
        domain: &[Interval; 2],
        limit: u64,
    ) -> Option<ZeroSet> {
        let region = region(parameters, domain);
        if !occur_in(std::slice::from_ref(self.factor().numerator()), parameters) {
            return None;
        }
        let zeros = budget::with_budget(limit, || {
            let factor = self.factor().lowest_terms().numerator().primitive();
            without_factors_of(factor, weight)?.zeros_on(&region)
        });
        Some(zeros.ok().flatten()?.without_zeros_of(weight))
    }

    /// The points of the domain where the numerator vanishes, but for poles of a surface with this weight; `None` where symbols, or
    /// the limit of units of work, keep them from being determined. A zero whose coordinates are both no
    /// numbers of a known field is one of those of `|N|²`, which are not decided then.
    ///
    /// # Example
    /// Whitney's umbrella (uv, u, v²), whose normal is (−2v, 2v², −u) and 0 at the pinch point:
    /// ```
    /// use hodograph_algebra::{Fraction, Interval, Poly, SweptSurface, Variable, Vector};
    /// let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
    /// let [u, v] = parameters.each_ref().map(|parameter| Fraction::from(Poly::variable(parameter)));
    /// let around = || Interval::new(Poly::integer(-1), Poly::integer(1)).unwrap();
    /// let umbrella = SweptSurface::new(Vector::new(&u * &v, u, &v * &v), parameters, [around(), around()]);
    /// let normal = umbrella.normal().unwrap();
    /// let zeros = normal.zeros(&Poly::one(), umbrella.parameters(), umbrella.domain(), 1_000_000);
    /// assert_eq!(zeros.unwrap().to_string(), "(u, v) = (0, 0)");
    /// ```
    #[must_use]
    pub fn zeros(
        &self,
        weight: &Poly,
        parameters: &[Variable; 2],
        domain: &[Interval; 2],
        limit: u64,
    ) -> Option<ZeroSet> {
        let region = region(parameters, domain);
        if !occur_in(self.numerator(), parameters) {
            return None;
        }
        // |N|² is a sum of squares: its zeros are those of the square root where there is one.
        let of_square = |limit: u64| {
            let squared = self.squared_length();
            if squared.split().is_square() {
                return zeros_within(limit, &squared.split().root, &region);
            }
            let square = squared.expanded()?;
            let radical = budget::with_budget(limit, || square.squarefree().radical());
            radical.ok().and_then(|radical| zeros_within(limit, &radical, &region))
        };
        let points = || budget::with_budget(limit, || common_zeros(self.numerator(), &region)).ok().flatten();
        let quick = of_square(limit.min(QUICK));
        let zeros = match quick {
            Some(zeros) if zeros.is_complete() => zeros,
            Some(undecided) => points().unwrap_or(undecided),
            None => points().or_else(|| if limit > QUICK { of_square(limit) } else { None })?,
        };
        Some(zeros.without_zeros_of(weight))
    }
}

/// A polynomial without all that it has in common with another one.
pub(super) fn without_factors_of(mut poly: Poly, other: &Poly) -> Option<Poly> {
    let mut common = poly.gcd(other);
    while !common.is_constant() {
        poly = poly.exact_div(&common)?;
        common = poly.gcd(&common);
    }
    Some(poly)
}

fn region(parameters: &[Variable; 2], domain: &[Interval; 2]) -> Vec<(Variable, Interval)> {
    parameters.iter().cloned().zip(domain.iter().cloned()).collect()
}

/// Whether the polynomials have no other variables than the parameters.
fn occur_in(polys: &[Poly], parameters: &[Variable; 2]) -> bool {
    polys.iter().flat_map(Poly::occurring_variables).all(|variable| parameters.contains(&variable))
}
