//! Splines through given points, exactly: linear systems over the field of the points.

use crate::motion::error::MotionError;
use crate::{Interval, Poly, Variable, budget, integer};

/// How smooth a spline is at its knots, and of which degree.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Smoothness {
    /// C¹, of degree 2.
    Quadratic,
    /// C², of degree 3.
    Cubic,
}

impl Smoothness {
    /// The degree of the pieces.
    #[must_use]
    pub fn degree(self) -> usize {
        match self {
            Smoothness::Quadratic => 2,
            Smoothness::Cubic => 3,
        }
    }
}

/// What a spline does at its ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Ends {
    /// The bending energy `∫|C''|²` is least. For a cubic spline `C'' = 0` at both ends.
    Natural,
    /// The derivatives at both ends. A quadratic spline has room for the first of them alone.
    Clamped(Vec<Poly>, Vec<Poly>),
    /// The end continues at the beginning, with the derivatives there or, if `opposite`, with their negatives: then the last
    /// point is the negative of the first one. For cubic splines.
    Periodic {
        /// Whether the spline closes with the opposite sign.
        opposite: bool,
    },
}

/// A curve of Bézier segments in a space of any dimension, one between each two neighboring knots.
///
/// # Example
/// The natural cubic spline through 0, 1, 0.
/// ```
/// use hodograph_algebra::{Ends, Poly, Smoothness, Spline, Variable};
/// let numbers = |numbers: &[i64]| numbers.iter().map(|&n| Poly::integer(n)).collect::<Vec<_>>();
/// let points: Vec<Vec<Poly>> = [0, 1, 0].iter().map(|&n| numbers(&[n])).collect();
/// let spline = Spline::through(&numbers(&[0, 1, 2]), &points, Smoothness::Cubic, &Ends::Natural).unwrap();
/// let v = Variable::new(1, "v");
/// assert_eq!(spline.polynomials(0, &v)[0].to_string(), "-1/2*v^3 + 3/2*v");
/// assert_eq!(spline.control_points(1).len(), 4);
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spline {
    knots: Vec<Poly>,
    /// For each segment its control points.
    segments: Vec<Vec<Vec<Poly>>>,
}

impl Spline {
    /// The spline that passes at each of the increasing `knots` through the point with the same index. All points have as many
    /// coordinates.
    ///
    /// The unknowns are the derivatives `dᵢ` at the knots. For a cubic spline, with `h` for the widths of the segments and Δ for
    /// the slopes of the chords, they satisfy `hᵢ dᵢ₋₁ + 2(hᵢ₋₁ + hᵢ) dᵢ + hᵢ₋₁ dᵢ₊₁ = 3(hᵢ Δᵢ₋₁ + hᵢ₋₁ Δᵢ)` and two equations of
    /// the ends. For a quadratic one `dᵢ₊₁ = 2Δᵢ − dᵢ`, and the ends determine `d₀`. Complexity: `O(N)` operations on numbers
    /// for each coordinate.
    ///
    /// # Errors
    /// [`MotionError::Ends`] for ends that a quadratic spline cannot have.
    ///
    /// # Panics
    /// If there are fewer than two knots, or more or fewer points than knots.
    pub fn through(
        knots: &[Poly],
        points: &[Vec<Poly>],
        smoothness: Smoothness,
        ends: &Ends,
    ) -> Result<Spline, MotionError> {
        assert!(knots.len() >= 2 && knots.len() == points.len(), "a point for each knot, two at least");
        budget::doing("a spline through the frames", || {
            let widths: Vec<Poly> = knots.windows(2).map(|pair| &pair[1] - &pair[0]).collect();
            let slopes: Vec<Vec<Poly>> = points
                .windows(2)
                .zip(&widths)
                .map(|(pair, width)| combine(&pair[1], &pair[0], |a, b| (a - b) * width.inverse()))
                .collect();
            let derivatives = match smoothness {
                Smoothness::Cubic => cubic(&widths, &slopes, ends)?,
                Smoothness::Quadratic => quadratic(&widths, &slopes, ends)?,
            };
            let degree = integer(smoothness.degree() as i64);
            let segment = |index: usize| {
                let (start, end) = (&points[index], &points[index + 1]);
                let third = widths[index].scale(&degree.recip());
                let first = combine(start, &derivatives[index], |point, d| point + d * &third);
                let last = combine(end, &derivatives[index + 1], |point, d| point - d * &third);
                match smoothness {
                    Smoothness::Cubic => vec![start.clone(), first, last, end.clone()],
                    Smoothness::Quadratic => vec![start.clone(), first, end.clone()],
                }
            };
            Ok(Spline { knots: knots.to_vec(), segments: (0..widths.len()).map(segment).collect() })
        })
    }

    /// The knots.
    #[must_use]
    pub fn knots(&self) -> &[Poly] {
        &self.knots
    }

    /// The Bézier points of a segment.
    ///
    /// # Panics
    /// If there is no such segment.
    #[must_use]
    pub fn control_points(&self, segment: usize) -> &[Vec<Poly>] {
        &self.segments[segment]
    }

    /// The coordinates on a segment as polynomials in `variable`, which runs from its knot to the next one.
    ///
    /// # Panics
    /// If there is no such segment.
    #[must_use]
    pub fn polynomials(&self, segment: usize, variable: &Variable) -> Vec<Poly> {
        let points = &self.segments[segment];
        let inverse = (&self.knots[segment + 1] - &self.knots[segment]).inverse();
        let t = (Poly::variable(variable) - &self.knots[segment]) * inverse;
        let coordinate = |axis: usize| {
            let coefficients: Vec<Poly> = points.iter().map(|point| point[axis].clone()).collect();
            bernstein_sum(&coefficients, &t)
        };
        (0..points[0].len()).map(coordinate).collect()
    }

    /// The interval of a segment; `None` if the knots do not increase.
    pub(crate) fn interval(&self, segment: usize) -> Option<Interval> {
        Interval::new(self.knots[segment].clone(), self.knots[segment + 1].clone())
    }
}

/// The polynomial `Σ bᵢ C(n, i) tⁱ (1 − t)ⁿ⁻ⁱ` with these Bernstein coefficients, of which there is one at least, for a
/// polynomial `t`.
///
/// ```
/// use hodograph_algebra::{Poly, Variable, bernstein_sum};
/// let t = Poly::variable(&Variable::new(0, "t"));
/// assert_eq!(bernstein_sum(&[0, 0, 3, 3].map(Poly::integer), &t).to_string(), "-6*t^3 + 9*t^2");
/// ```
#[must_use]
pub fn bernstein_sum(coefficients: &[Poly], t: &Poly) -> Poly {
    let n = coefficients.len() as i64 - 1;
    let (mut sum, mut power, mut binomial) = (Poly::zero(), Poly::one(), integer(1));
    let mut differences = coefficients.to_vec();
    for i in 0..=n {
        if let Some(first) = differences.first() {
            sum += (first * &power).scale(&binomial);
        }
        power = &power * t;
        binomial = binomial * integer(n - i) / integer(i + 1);
        differences = differences.windows(2).map(|pair| &pair[1] - &pair[0]).collect();
    }
    sum
}

/// The Bernstein coefficients of a product (JW Lemma 5.1): `dₖ = Σ C(m, i) C(n, j) / C(m + n, k) · bᵢ cⱼ` over `i + j = k`.
///
/// ```
/// use hodograph_algebra::{Poly, bernstein_product, bernstein_sum, Variable};
/// let (b, c) = ([1, 2].map(Poly::integer), [0, 1, 5].map(Poly::integer));
/// let t = Poly::variable(&Variable::new(0, "t"));
/// let product = bernstein_sum(&b, &t) * bernstein_sum(&c, &t);
/// assert_eq!(bernstein_sum(&bernstein_product(&b, &c), &t), product);
/// ```
#[must_use]
pub fn bernstein_product(b: &[Poly], c: &[Poly]) -> Vec<Poly> {
    if b.is_empty() || c.is_empty() {
        return Vec::new();
    }
    let binomials = |n: usize| {
        let next = |value: &mut crate::Rational, i: i64| {
            let here = value.clone();
            *value = &*value * integer(n as i64 - i) / integer(i + 1);
            Some(here)
        };
        (0..=n as i64).scan(integer(1), next).collect::<Vec<_>>()
    };
    let (m, n) = (b.len() - 1, c.len() - 1);
    let (over_b, over_c, over) = (binomials(m), binomials(n), binomials(m + n));
    let mut product = vec![Poly::zero(); m + n + 1];
    for (i, b) in b.iter().enumerate() {
        for (j, c) in c.iter().enumerate() {
            product[i + j] += (b * c).scale(&(&over_b[i] * &over_c[j] / &over[i + j]));
        }
    }
    product
}

fn combine(a: &[Poly], b: &[Poly], with: impl Fn(&Poly, &Poly) -> Poly) -> Vec<Poly> {
    a.iter().zip(b).map(|(a, b)| with(a, b)).collect()
}

/// A row of a linear system: its coefficients, and its right sides.
type Row = (Vec<Poly>, Vec<Poly>);

/// The derivatives of the C² cubic spline at its knots.
fn cubic(widths: &[Poly], slopes: &[Vec<Poly>], ends: &Ends) -> Result<Vec<Vec<Poly>>, MotionError> {
    let last = widths.len();
    let row = |entries: &[(usize, Poly)]| {
        let mut row = vec![Poly::zero(); last + 1];
        for (column, entry) in entries {
            row[*column] += entry;
        }
        row
    };
    let scaled =
        |slopes: &[Poly], factor: Poly| slopes.iter().map(|slope| slope * &factor).collect::<Vec<_>>();
    let sum = |a: Vec<Poly>, b: Vec<Poly>| combine(&a, &b, |a, b| a + b);
    let [one, two, three] = [1, 2, 3].map(Poly::integer);
    let mut rows: Vec<Row> = Vec::new();
    let (first, final_row): (Row, Row) = match ends {
        Ends::Natural => (
            (row(&[(0, two.clone()), (1, one.clone())]), scaled(&slopes[0], three.clone())),
            (row(&[(last - 1, one), (last, two)]), scaled(&slopes[last - 1], three.clone())),
        ),
        Ends::Clamped(start, end) => {
            ((row(&[(0, one.clone())]), start.clone()), (row(&[(last, one)]), end.clone()))
        }
        Ends::Periodic { opposite } => {
            let sign = Poly::integer(if *opposite { -1 } else { 1 });
            let zero = vec![Poly::zero(); slopes[0].len()];
            let (h0, hn) = (&widths[0], &(&widths[last - 1] * &sign));
            let twice = |h: &Poly| h.scale(&integer(2));
            let bend = row(&[(last - 1, h0.clone()), (last, twice(h0)), (0, twice(hn)), (1, hn.clone())]);
            let right = sum(scaled(&slopes[last - 1], h0 * &three), scaled(&slopes[0], hn * &three));
            ((row(&[(0, sign), (last, -one)]), zero), (bend, right))
        }
    };
    rows.push(first);
    for i in 1..last {
        let (before, after) = (&widths[i - 1], &widths[i]);
        let middle = (before + after).scale(&integer(2));
        let left = row(&[(i - 1, after.clone()), (i, middle), (i + 1, before.clone())]);
        let right = sum(scaled(&slopes[i - 1], after * &three), scaled(&slopes[i], before * &three));
        rows.push((left, right));
    }
    rows.push(final_row);
    solve(rows).ok_or(MotionError::Ends)
}

/// The derivatives of the C¹ quadratic spline at its knots.
fn quadratic(widths: &[Poly], slopes: &[Vec<Poly>], ends: &Ends) -> Result<Vec<Vec<Poly>>, MotionError> {
    // Each derivative is ±d₀ plus what the chords give.
    let from = |start: Vec<Poly>| {
        let mut all = vec![start];
        for slope in slopes {
            let next = combine(slope, &all[all.len() - 1], |slope, d| slope.scale(&integer(2)) - d);
            all.push(next);
        }
        all
    };
    match ends {
        Ends::Clamped(start, _) => Ok(from(start.clone())),
        Ends::Natural => {
            // C'' is 2(Δᵢ − dᵢ)/hᵢ: the least ∫|C''|² is a mean with the weights 1/hᵢ.
            let rest = from(vec![Poly::zero(); slopes[0].len()]);
            let mut weight = Poly::zero();
            let mut mean = vec![Poly::zero(); slopes[0].len()];
            for (i, slope) in slopes.iter().enumerate() {
                let inverse = widths[i].inverse();
                let signed = if i % 2 == 0 { inverse.clone() } else { -&inverse };
                let error = combine(slope, &rest[i], |slope, d| (slope - d) * &signed);
                mean = combine(&mean, &error, |mean, error| mean + error);
                weight += &inverse;
            }
            let inverse = weight.inverse();
            Ok(from(mean.iter().map(|mean| mean * &inverse).collect()))
        }
        Ends::Periodic { .. } => Err(MotionError::Ends),
    }
}

/// The solution of a linear system of numbers by elimination; `None` if it is singular. Zeros are skipped, so that a banded
/// system takes linear time.
fn solve(mut rows: Vec<Row>) -> Option<Vec<Vec<Poly>>> {
    let n = rows.len();
    for column in 0..n {
        let pivot = (column..n).find(|&row| !rows[row].0[column].is_zero())?;
        rows.swap(column, pivot);
        let inverse = rows[column].0[column].inverse();
        let (above, below) = rows.split_at_mut(column + 1);
        let (left, right) = &above[column];
        for (other_left, other_right) in below.iter_mut().filter(|(left, _)| !left[column].is_zero()) {
            let factor = &other_left[column] * &inverse;
            let entries = other_left.iter_mut().zip(left).chain(other_right.iter_mut().zip(right));
            for (entry, own) in entries.filter(|(_, own)| !own.is_zero()) {
                *entry -= own * &factor;
            }
        }
    }
    let mut solution: Vec<Vec<Poly>> = Vec::new();
    for column in (0..n).rev() {
        let (left, right) = &rows[column];
        let mut value = right.clone();
        for (known, entry) in solution.iter().rev().zip(&left[column + 1..]).filter(|(_, e)| !e.is_zero()) {
            value = combine(&value, known, |value, known| value - known * entry);
        }
        let inverse = left[column].inverse();
        solution.push(value.iter().map(|value| value * &inverse).collect());
    }
    solution.reverse();
    Some(solution)
}
