//! Bernstein forms of polynomials in one or several variables.

use num_traits::One;

use super::interval::Interval;
use super::tensor::Tensor;
use crate::{Int, Poly, Rational, Variable, budget};

/// One direction of a [`Bernstein`] form: a variable, the interval that it runs over, and the degree in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Axis {
    variable: Variable,
    interval: Interval,
    degree: u32,
}

impl Axis {
    /// The axes of the box `domain`, of the degrees that `poly` has.
    pub(super) fn all(poly: &Poly, domain: &[(Variable, Interval)]) -> Vec<Axis> {
        let axis = |(variable, interval): &(Variable, Interval)| Axis {
            variable: variable.clone(),
            interval: interval.clone(),
            degree: poly.degree(variable).unwrap_or(0),
        };
        domain.iter().map(axis).collect()
    }

    /// The variable.
    #[must_use]
    pub fn variable(&self) -> &Variable {
        &self.variable
    }

    /// The interval over which the form stands.
    #[must_use]
    pub fn interval(&self) -> &Interval {
        &self.interval
    }

    /// The degree, which may exceed that of the polynomial.
    #[must_use]
    pub fn degree(&self) -> u32 {
        self.degree
    }
}

/// A polynomial in Bernstein form over an interval or a box:
/// `f = Σ b(i, j) · B(m, i)(s) · B(n, j)(t)` with `B(n, i)(t) = C(n, i)·tⁱ·(1 − t)ⁿ⁻ⁱ` and `s`, `t` running from 0 to 1 as
/// the variables run over their intervals.
///
/// The coefficients are numbers, or polynomials in whatever other variables occur. If they are numbers, the values on
/// the box lie between the least and the greatest of them, and those at the corners are values of `f` (Farouki, *The Bernstein
/// polynomial basis: a centennial retrospective*, 2012).
///
/// # Example
/// ```
/// use hodograph_algebra::{Bernstein, Interval, Poly, Variable};
/// let (u, w) = (Variable::new(0, "u"), Variable::new(Variable::SYMBOL, "w"));
/// let f = Poly::variable(&u).pow(2) + Poly::variable(&w);
/// let form = Bernstein::new(&f, &[(u, Interval::unit())]);
/// let coefficients: Vec<String> = form.coefficients().iter().map(Poly::to_string).collect();
/// assert_eq!(coefficients, ["w", "w", "w + 1"]);
/// assert_eq!(form.to_poly(), f);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bernstein {
    axes: Vec<Axis>,
    /// The index of the first axis is the outermost one.
    coefficients: Vec<Poly>,
}

impl Bernstein {
    /// The form of `poly` over the box `domain`, of the polynomial's own degree in each variable.
    ///
    /// Complexity: `O(n)` operations for each coefficient, where `n` is the degree: on integers if the ends of all intervals
    /// are rational, else on polynomials.
    #[must_use]
    pub fn new(poly: &Poly, domain: &[(Variable, Interval)]) -> Bernstein {
        let degrees = domain.iter().map(|(variable, _)| poly.degree(variable).unwrap_or(0));
        Bernstein::of_degrees(poly, domain, degrees)
    }

    /// The form of `poly` over the box `domain`, of the given degree in each variable; `None` if one of the degrees is
    /// missing or below that of the polynomial.
    #[must_use]
    pub fn with_degrees(poly: &Poly, domain: &[(Variable, Interval)], degrees: &[u32]) -> Option<Bernstein> {
        let enough = |((variable, _), &degree): (&(Variable, Interval), &u32)| {
            poly.degree(variable).unwrap_or(0) <= degree
        };
        if degrees.len() != domain.len() || !domain.iter().zip(degrees).all(enough) {
            return None;
        }
        Some(Bernstein::of_degrees(poly, domain, degrees.iter().copied()))
    }

    fn of_degrees(
        poly: &Poly,
        domain: &[(Variable, Interval)],
        degrees: impl Iterator<Item = u32>,
    ) -> Bernstein {
        let axis = |((variable, interval), degree): (&(Variable, Interval), u32)| Axis {
            variable: variable.clone(),
            interval: interval.clone(),
            degree,
        };
        let axes: Vec<Axis> = domain.iter().zip(degrees).map(axis).collect();
        let coefficients = budget::doing("a Bernstein form", || match Tensor::new(poly, &axes) {
            Some(tensor) => {
                let count = axes.iter().map(|axis| axis.degree as usize + 1).product();
                tensor.into_polys(poly, count)
            }
            None => convert(poly, &axes),
        });
        Bernstein { axes, coefficients }
    }

    /// The directions, in the order in which the box was given.
    #[must_use]
    pub fn axes(&self) -> &[Axis] {
        &self.axes
    }

    /// All coefficients; the index of the first axis is the outermost one.
    #[must_use]
    pub fn coefficients(&self) -> &[Poly] {
        &self.coefficients
    }

    /// The coefficient with the given index on each axis; `None` if there is no such one.
    #[must_use]
    pub fn coefficient(&self, indices: &[u32]) -> Option<&Poly> {
        if indices.len() != self.axes.len() {
            return None;
        }
        let mut place = 0;
        for (axis, &index) in self.axes.iter().zip(indices) {
            if index > axis.degree {
                return None;
            }
            place = place * (axis.degree as usize + 1) + index as usize;
        }
        self.coefficients.get(place)
    }

    /// The polynomial in powers of the variables.
    #[must_use]
    pub fn to_poly(&self) -> Poly {
        collapse(&self.coefficients, &self.axes)
    }

    /// The same polynomial, of a degree on the axis at `position` that is higher by one:
    /// `b'ᵢ = (i·bᵢ₋₁ + (n + 1 − i)·bᵢ)/(n + 1)`.
    ///
    /// # Panics
    /// If there is no axis at `position`.
    #[must_use]
    pub fn elevated(&self, position: usize) -> Bernstein {
        let raised = i64::from(self.axes[position].degree) + 1;
        let coefficients = self.along(position, |line| {
            let weight = |i: usize| Rational::new(Int::from(i as u64), Int::from(raised));
            let element = |i: usize| {
                let before = i.checked_sub(1).map_or(Poly::zero(), |before| line[before].scale(&weight(i)));
                let here =
                    line.get(i).map_or(Poly::zero(), |here| here.scale(&(Rational::one() - weight(i))));
                before + here
            };
            (0..=line.len()).map(element).collect()
        });
        let mut axes = self.axes.clone();
        axes[position].degree += 1;
        Bernstein { axes, coefficients }
    }

    /// The forms over the two parts of the box below and above `value` of the axis at `position`, by the algorithm of
    /// de Casteljau; `None` unless `value` is a number strictly inside the axis's interval.
    ///
    /// # Panics
    /// If there is no axis at `position`.
    #[must_use]
    pub fn subdivided(&self, position: usize, value: &Poly) -> Option<(Bernstein, Bernstein)> {
        let interval = &self.axes[position].interval;
        let below = Interval::new(interval.lower().clone(), value.clone())?;
        let above = Interval::new(value.clone(), interval.upper().clone())?;
        let t = below.width() * interval.width().inverse();
        let part = |interval: Interval, upper: bool| {
            let mut axes = self.axes.clone();
            axes[position].interval = interval;
            let coefficients = self.along(position, |line| {
                let (low, high) = casteljau(line, &t);
                if upper { high } else { low }
            });
            Bernstein { axes, coefficients }
        };
        Some((part(below, false), part(above, true)))
    }

    /// The number of sign changes in the sequence of coefficients, zeros left out; `None` if a coefficient is not a
    /// number.
    ///
    /// For a form in one variable it exceeds the number of roots inside the interval, counted with multiplicity, by an
    /// even number, zero included (Descartes' rule of signs; Mourrain, Rouillier and Roy, *The Bernstein basis and real
    /// root isolation*, 2005).
    #[must_use]
    pub fn sign_variations(&self) -> Option<usize> {
        self.coefficients
            .iter()
            .all(Poly::is_constant)
            .then(|| variations(self.coefficients.iter().map(Poly::sign)))
    }

    /// The least and the greatest coefficient, between which lie all values on the box; `None` if a coefficient is not a
    /// number.
    #[must_use]
    pub fn range(&self) -> Option<(&Poly, &Poly)> {
        if !self.coefficients.iter().all(Poly::is_constant) {
            return None;
        }
        let least = self.coefficients.iter().min_by(|a, b| a.compare(b))?;
        let greatest = self.coefficients.iter().max_by(|a, b| a.compare(b))?;
        Some((least, greatest))
    }

    /// Applies `change` to each line of coefficients along the axis at `position`.
    fn along(&self, position: usize, change: impl Fn(&[Poly]) -> Vec<Poly>) -> Vec<Poly> {
        let lengths = self.axes.iter().map(|axis| axis.degree as usize + 1);
        let inner: usize = lengths.clone().skip(position + 1).product();
        let length = self.axes[position].degree as usize + 1;
        let mut changed = Vec::new();
        for block in self.coefficients.chunks(length * inner) {
            let lines: Vec<Vec<Poly>> = (0..inner)
                .map(|offset| {
                    let line: Vec<Poly> = block.iter().skip(offset).step_by(inner).cloned().collect();
                    change(&line)
                })
                .collect();
            let new_length = lines.first().map_or(0, Vec::len);
            for i in 0..new_length {
                changed.extend(lines.iter().map(|line| line[i].clone()));
            }
        }
        changed
    }
}

/// The number of sign changes in a sequence of signs, zeros left out.
pub(crate) fn variations(signs: impl IntoIterator<Item = std::cmp::Ordering>) -> usize {
    let mut last = std::cmp::Ordering::Equal;
    let mut count = 0;
    for sign in signs {
        if sign.is_eq() {
            continue;
        }
        count += usize::from(last.is_ne() && last != sign);
        last = sign;
    }
    count
}

/// The rows of Pascal's triangle up to the power `degree`.
fn binomials(degree: usize) -> Vec<Vec<Int>> {
    budget::spend((degree as u64 + 1).pow(2));
    let mut rows = vec![vec![Int::ONE]];
    for n in 0..degree {
        let row = &rows[n];
        let inner = row.windows(2).map(|pair| &pair[0] + &pair[1]);
        rows.push([Int::ONE].into_iter().chain(inner).chain([Int::ONE]).collect());
    }
    rows
}

/// The coefficients over a box with any ends, by general arithmetic.
fn convert(poly: &Poly, axes: &[Axis]) -> Vec<Poly> {
    let Some((axis, rest)) = axes.split_first() else { return vec![poly.clone()] };
    let degree = axis.degree as usize;
    let x = Poly::variable(&axis.variable);
    let unit = poly.substitute(&axis.variable, &(axis.interval.lower() + x * axis.interval.width()));
    let mut powers = unit.coefficients(&axis.variable);
    powers.resize(degree + 1, Poly::zero());
    let binomial = binomials(degree);
    for (i, power) in powers.iter_mut().enumerate() {
        *power = power.scale(&Rational::new(Int::ONE, binomial[degree][i].clone()));
    }
    // b(j) = Σ C(j, i)/C(n, i) · a(i) over i ≤ j.
    let coefficient = |j: usize| -> Poly {
        (0..=j).map(|i| powers[i].scale(&Rational::from(binomial[j][i].clone()))).sum()
    };
    (0..=degree).flat_map(|j| convert(&coefficient(j), rest)).collect()
}

fn collapse(coefficients: &[Poly], axes: &[Axis]) -> Poly {
    let Some((axis, rest)) = axes.split_first() else {
        return coefficients.first().cloned().unwrap_or_else(Poly::zero);
    };
    let degree = axis.degree as usize;
    let size = coefficients.len() / (degree + 1);
    let values: Vec<Poly> = coefficients.chunks(size).map(|block| collapse(block, rest)).collect();
    let binomial = binomials(degree);
    // a(i) = C(n, i) · Σ (−1)^(i−j) · C(i, j) · b(j) over j ≤ i.
    let power = |i: usize| -> Poly {
        let term = |j: usize| {
            let scaled = values[j].scale(&Rational::from(binomial[i][j].clone()));
            if (i - j).is_multiple_of(2) { scaled } else { -scaled }
        };
        (0..=i).map(term).sum::<Poly>().scale(&Rational::from(binomial[degree][i].clone()))
    };
    let powers: Vec<Poly> = (0..=degree).map(power).collect();
    let unit = Poly::from_coefficients(&axis.variable, &powers);
    let width = axis.interval.width().inverse();
    unit.substitute(&axis.variable, &((Poly::variable(&axis.variable) - axis.interval.lower()) * width))
}

/// The coefficients of both parts of the unit interval below and above `t`.
fn casteljau(line: &[Poly], t: &Poly) -> (Vec<Poly>, Vec<Poly>) {
    let rest = Poly::one() - t;
    let mut row = line.to_vec();
    let (mut low, mut high) = (Vec::new(), Vec::new());
    while let (Some(first), Some(last)) = (row.first(), row.last()) {
        low.push(first.clone());
        high.push(last.clone());
        row = row.windows(2).map(|pair| &pair[0] * &rest + &pair[1] * t).collect();
    }
    high.reverse();
    (low, high)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ratio;

    fn u() -> Variable {
        Variable::new(0, "u")
    }

    #[test]
    fn a_parabola_over_the_symmetric_interval() {
        let interval = Interval::new(Poly::integer(-1), Poly::integer(1)).unwrap();
        let form = Bernstein::new(&Poly::variable(&u()).pow(2), &[(u(), interval)]);
        assert_eq!(form.coefficients(), [Poly::integer(1), Poly::integer(-1), Poly::integer(1)]);
        assert_eq!(form.sign_variations(), Some(2));
        assert_eq!(form.range(), Some((&Poly::integer(-1), &Poly::integer(1))));
        let (low, high) = form.subdivided(0, &Poly::zero()).unwrap();
        assert_eq!(low.coefficients(), [Poly::integer(1), Poly::zero(), Poly::zero()]);
        assert_eq!(high.coefficients(), [Poly::zero(), Poly::zero(), Poly::integer(1)]);
        assert_eq!(form.elevated(0).coefficient(&[1]), Some(&Poly::constant(ratio(-1, 3))));
        assert!(form.subdivided(0, &Poly::integer(1)).is_none());
    }

    #[test]
    fn too_small_degrees_are_refused() {
        let f = Poly::variable(&u()).pow(2);
        assert!(Bernstein::with_degrees(&f, &[(u(), Interval::unit())], &[1]).is_none());
        assert!(Bernstein::with_degrees(&f, &[(u(), Interval::unit())], &[]).is_none());
        let form = Bernstein::with_degrees(&f, &[(u(), Interval::unit())], &[3]).unwrap();
        assert_eq!(form, Bernstein::new(&f, &[(u(), Interval::unit())]).elevated(0));
    }
}
