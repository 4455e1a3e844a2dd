//! Where a surface has no normal.

use super::normal::Normal;
use crate::{Interval, Poly, Variable, ZeroSet, budget};

/// The points of the domain at which `R_u × R_v` vanishes.
///
/// With `R_u × R_v = factor · N` and `N` in lowest terms these are the zeros of the numerator of the factor, such as
/// `1 + κ(v)x(u)`, and the common zeros of the components of `N`, which are the zeros of `|N|²`.
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
/// let locus = SingularLocus::of(cone.normal().unwrap(), cone.parameters(), cone.domain());
/// assert_eq!(locus.factor.to_string(), "u");
/// assert_eq!(locus.factor_zeros.unwrap().to_string(), "u = 0");
/// assert!(locus.normal_zeros.unwrap().is_empty());
/// ```
#[derive(Clone, Debug)]
pub struct SingularLocus {
    /// The numerator of the factor, without content.
    pub factor: Poly,
    /// The zeros of the factor on the domain; `None` where unknown symbols or the budget keep them from being determined.
    pub factor_zeros: Option<ZeroSet>,
    /// The zeros of `|N|²` on the domain; `None` where unknown symbols or the budget keep them from being determined.
    pub normal_zeros: Option<ZeroSet>,
}

/// The units of work that the zeros of one polynomial may take: what else is derived is not to be lost with them.
pub(super) const BUDGET: u64 = 100_000_000;

/// The zeros of a polynomial on the domain, if they can be determined.
pub(super) fn zeros(poly: &Poly, domain: &[(Variable, Interval)]) -> Option<ZeroSet> {
    budget::with_budget(BUDGET, || poly.zeros_on(domain)).ok().flatten()
}

impl SingularLocus {
    /// The locus for a normal on the domain.
    #[must_use]
    pub fn of(normal: &Normal, parameters: &[Variable; 2], domain: &[Interval; 2]) -> SingularLocus {
        let factor = normal.factor().lowest_terms().numerator().primitive();
        let domain: Vec<(Variable, Interval)> =
            parameters.iter().cloned().zip(domain.iter().cloned()).collect();
        let factor_zeros = zeros(&factor, &domain);
        // |N|² is a sum of squares: its zeros are those of the square root where there is one.
        let squared = normal.squared_length();
        let normal_zeros = match squared.expanded() {
            _ if squared.split().is_square() => zeros(&squared.split().root, &domain),
            Some(square) => {
                let radical = budget::with_budget(BUDGET, || square.squarefree().radical());
                radical.ok().and_then(|radical| zeros(&radical, &domain))
            }
            None => None,
        };
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
