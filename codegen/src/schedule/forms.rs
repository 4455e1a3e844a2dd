//! Ways to evaluate a polynomial of one parameter: which there are, what they cost, and which one is taken.
//!
//! | scheme | value | operations | roundings of the term of c_j, at most |
//! | --- | --- | --- | --- |
//! | Horner | c_0 + x·(c_1 + x·(c_2 + …)) | 2n | 2j + 2 |
//! | Estrin | (c_0 + c_1·x) + x²·(c_2 + c_3·x) + x⁴·(…) | 2n + ⌊log₂ n⌋ | j + ⌈log₂(n + 1)⌉ + 2 |
//! | Bernstein | Σ_j β_j·t^j·s^(n−j), t = x − a, s = b − x | 2n + 1 and 3n once | 3n + 2 |
//!
//! The first two are taken around zero, or around a place near the middle of the domain, where every term has j
//! roundings more. (Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd ed., 2002, §5.1; Estrin,
//! *Organization of computer systems*, 1960; Farouki & Rajan, *On the numerical condition of polynomials in Bernstein
//! form*, 1987.)
//!
//! The *error figure* of a scheme is the largest sum of |terms| times roundings on the domain, in unit roundoffs: a
//! bound of the error up to second order. In powers of x it is Σ_j k_j·|c_j|·r^j for the largest distance r from the
//! center; in the Bernstein basis, which is a partition of unity, k·max|b_j|. A polynomial whose Bernstein
//! coefficients have one sign is evaluated without cancellation. Figures are computed in floats: they choose, and
//! prove nothing.

use hodograph_algebra::{Bernstein, Interval, Poly, Rational, Variable, integer};

use crate::round::{exact, nearest};

/// What evaluators should be above all.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Debug)]
pub enum Preference {
    /// Fast: of the schemes for a polynomial the one with the least sum of operations and steps of latency. Around
    /// the middle of the domain it is evaluated if that makes the error figure 8 times smaller, and in the Bernstein
    /// basis if it makes it 64 times smaller.
    #[default]
    Fast,
    /// Accurate: of the schemes for a polynomial the one with the least error figure. The program has one more
    /// output, the [accurate point](super::outputs::ACCURATE_POINT).
    Accurate,
}

/// How a polynomial of one parameter is written.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Scheme {
    Horner,
    Estrin,
    Bernstein,
}

/// A scheme, around zero or around the center of the domain.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Choice {
    pub(super) scheme: Scheme,
    pub(super) centered: bool,
    /// Operations and steps of latency, where a sum with a product is one step.
    cost: usize,
    /// The error figure; `None` where coefficients are no numbers, or have no floats.
    error: Option<f64>,
}

/// How many times smaller the error figure around the center must be, to be worth an operation and simple coefficients.
const CENTER_GAIN: f64 = 8.0;
/// How many times smaller the error figure in the Bernstein basis must be, to be worth twice the operations.
const BERNSTEIN_GAIN: f64 = 64.0;
/// Error figures that differ by less than this factor are taken for equal.
const EQUAL: f64 = 1.25;

/// The scheme for a polynomial of `variable` on a domain.
///
/// O(n²) operations on floats and, around the center, on numbers.
pub(super) fn choose(
    poly: &Poly,
    variable: &Variable,
    range: Option<&Range>,
    preference: Preference,
) -> Choice {
    let line = Line::of(&poly.coefficients(variable));
    let plain = line.schemes(range.map(|range| range.magnitude), false);
    let Some(range) = range else { return cheapest(plain) };
    if preference == Preference::Fast && plain[0].error.is_none_or(|error| error <= line.least_figure(range))
    {
        return cheapest(plain);
    }
    let moved = poly.substitute(variable, &(Poly::variable(variable) + &range.center));
    let moved = Line::of(&moved.coefficients(variable));
    let centered = moved.schemes(Some(range.reach), true);
    let bernstein = moved.bernstein(range.reach);
    match preference {
        Preference::Fast => {
            let (mut chosen, centered) = (cheapest(plain), cheapest(centered));
            if is_better(&centered, &chosen, CENTER_GAIN) {
                chosen = centered;
            }
            bernstein.filter(|other| is_better(other, &chosen, BERNSTEIN_GAIN)).unwrap_or(chosen)
        }
        Preference::Accurate => {
            let all = plain.into_iter().chain(centered).chain(bernstein);
            let most_accurate = |best: Choice, other: Choice| {
                let cheaper = other.cost < best.cost && !is_better(&best, &other, EQUAL);
                if cheaper || is_better(&other, &best, EQUAL) { other } else { best }
            };
            all.reduce(most_accurate).unwrap_or_else(|| cheapest(plain))
        }
    }
}

fn is_better(choice: &Choice, than: &Choice, gain: f64) -> bool {
    matches!((choice.error, than.error), (Some(error), Some(other)) if other > gain * error)
}

fn cheapest(choices: [Choice; 2]) -> Choice {
    let [horner, estrin] = choices;
    if estrin.cost < horner.cost { estrin } else { horner }
}

/// The coefficients of 1, x, x², … as floats.
struct Line {
    sparsity: Sparsity,
    count: usize,
    /// `None` if they are no numbers, or have no floats.
    floats: Option<Vec<f64>>,
}

impl Line {
    fn of(coefficients: &[Poly]) -> Line {
        let floats = coefficients.iter().map(|c| nearest(c).ok()).collect();
        Line { sparsity: Sparsity::of(coefficients), count: coefficients.len(), floats }
    }

    /// Horner's and Estrin's scheme for powers of a number of magnitude `reach` at most.
    fn schemes(&self, reach: Option<f64>, centered: bool) -> [Choice; 2] {
        let Sparsity { lowest, step } = self.sparsity;
        let steps = self.count.saturating_sub(1 + lowest) / step;
        let levels = levels(steps + 1);
        let error = |roundings: &dyn Fn(usize) -> usize| {
            let (floats, reach) = (self.floats.as_ref()?, reach?);
            let terms = floats.iter().enumerate().rev();
            Some(terms.fold(0.0, |sum, (j, c)| {
                let count = roundings(j) + if centered { j } else { 0 };
                sum * reach + count as f64 * c.abs()
            }))
        };
        let operations = 2 * steps + usize::from(lowest > 0) + usize::from(centered);
        let squares = levels.saturating_sub(1);
        let choice = |scheme, cost, error| Choice { scheme, centered, cost, error };
        [
            choice(Scheme::Horner, operations + steps, error(&|j| 2 * j + 2)),
            choice(Scheme::Estrin, operations + squares + levels, error(&|j| j + levels + 2)),
        ]
    }

    /// What no figure can be less than by the factor that the center must gain: two roundings of the largest of some
    /// values.
    fn least_figure(&self, range: &Range) -> f64 {
        let floats = self.floats.as_deref().unwrap_or_default();
        let value = |x: f64| floats.iter().rev().fold(0.0, |sum, c| sum * x + c).abs();
        let largest = range.samples.map(value).into_iter().fold(0.0, f64::max);
        2.0 * CENTER_GAIN * largest
    }

    /// The Bernstein scheme for coefficients of powers around the center of a domain that reaches so far.
    fn bernstein(&self, reach: f64) -> Option<Choice> {
        let degree = self.count.checked_sub(1).filter(|degree| *degree > 1)?;
        let mut line = self.floats.clone()?;
        // Powers of y = x/reach; then, around its least value −1, powers of y + 1; then of (y + 1)/2, which goes from 0 to 1.
        scale(&mut line, |k| reach.powi(k as i32));
        for done in 0..degree {
            for k in (done..degree).rev() {
                line[k] -= line[k + 1];
            }
        }
        scale(&mut line, |k| 2_f64.powi(k as i32) / binomial(degree, k));
        // Those over C(n, k) are the differences Δ^k b_0.
        for done in (0..degree).rev() {
            for k in done + 1..=degree {
                line[k] += line[k - 1];
            }
        }
        let largest = line.iter().fold(0.0_f64, |largest, b| largest.max(b.abs()));
        let error = Some(largest * (3 * degree + 2) as f64);
        Some(Choice { scheme: Scheme::Bernstein, centered: false, cost: 6 * degree + 1, error })
    }
}

/// ⌈log₂ count⌉
pub(super) fn levels(count: usize) -> usize {
    count.next_power_of_two().trailing_zeros() as usize
}

/// The domain of a parameter.
pub(super) struct Range {
    /// Its ends, or the floats that are nearest to them.
    ends: [Poly; 2],
    /// A number near the middle with a short binary expansion.
    pub(super) center: Poly,
    /// Half of the domain's length, and the largest distance from the center.
    reach: f64,
    /// The largest magnitude.
    magnitude: f64,
    /// Some of its numbers.
    samples: [f64; 3],
}

impl Range {
    /// The range of a domain; `None` if its ends or its middle are beyond the range of floats, or it has no length.
    ///
    /// Accuracy at ends that are no floats takes these ends; else the nearest floats are as good, and differences from them are
    /// single operations.
    pub(super) fn of([first, last]: &[Rational; 2], preference: Preference) -> Option<Range> {
        let float = |value: &Rational| nearest(&Poly::constant(value.clone())).ok();
        let (start, end) = (float(first)?, float(last)?);
        // The center is a multiple of a power of two of the size of a quarter of the domain.
        let step = f64::from_bits(((end - start) / 4.0).to_bits() & !((1 << 52) - 1));
        let center = ((start / 2.0 + end / 2.0) / step).round() * step;
        let (reach, magnitude) = ((end - center).max(center - start), start.abs().max(end.abs()));
        let number = |float: f64| exact(float).map(Poly::constant);
        (step > 0.0 && reach.is_finite()).then_some(())?;
        let samples = [start, center, end];
        let ends = match preference {
            Preference::Fast => [number(start)?, number(end)?],
            Preference::Accurate => [first, last].map(|end| Poly::constant(end.clone())),
        };
        Some(Range { ends, center: number(center)?, reach, magnitude, samples })
    }

    /// The ends.
    pub(super) fn ends(&self) -> &[Poly; 2] {
        &self.ends
    }

    /// The interval, to be a side of a box.
    pub(super) fn interval(&self) -> Option<Interval> {
        let [start, end] = self.ends.clone();
        Interval::new(start, end)
    }
}

fn scale(line: &mut [f64], factor: impl Fn(usize) -> f64) {
    for (k, coefficient) in line.iter_mut().enumerate() {
        *coefficient *= factor(k);
    }
}

fn binomial(n: usize, k: usize) -> f64 {
    (0..k).fold(1.0, |product, i| product * (n - i) as f64 / (i + 1) as f64)
}

/// The least power of a polynomial, and the greatest power of its parameter that it is a polynomial of otherwise.
pub(super) struct Sparsity {
    pub(super) lowest: usize,
    pub(super) step: usize,
}

impl Sparsity {
    /// That of the polynomial with these coefficients of 1, x, x², …
    pub(super) fn of(coefficients: &[Poly]) -> Sparsity {
        let lowest = coefficients.iter().position(|c| !c.is_zero()).unwrap_or(0);
        let coefficients = &coefficients[lowest..];
        let even = |step: &usize| {
            coefficients.iter().enumerate().all(|(i, c)| i.is_multiple_of(*step) || c.is_zero())
        };
        Sparsity { lowest, step: (1..=coefficients.len()).rev().find(even).unwrap_or(1) }
    }

    /// How many operations Horner's scheme takes, when the powers that it needs are known.
    pub(super) fn operations(coefficients: &[Poly]) -> usize {
        let Sparsity { lowest, step } = Sparsity::of(coefficients);
        2 * (coefficients.len().saturating_sub(1 + lowest) / step) + usize::from(lowest > 0)
    }
}

/// Coefficients β_ij with p(u, v) = Σ β_ij·(u − a)^i·(b − u)^(m−i)·(v − c)^j·(d − v)^(n−j), a row for each power of u.
pub(super) fn unscaled_net(poly: &Poly, axes: &[(Variable, &Range, u32)]) -> Option<Vec<Poly>> {
    let domain: Option<Vec<(Variable, Interval)>> =
        axes.iter().map(|(variable, range, _)| Some((variable.clone(), range.interval()?))).collect();
    let degrees: Vec<u32> = axes.iter().map(|(.., degree)| *degree).collect();
    let form = Bernstein::with_degrees(poly, &domain?, &degrees)?;
    // C(n, j)/(b − a)^n along each axis.
    let mut factors = vec![Poly::one()];
    for (_, range, degree) in axes {
        let [start, end] = range.ends();
        let length = (end - start).pow(*degree).inverse();
        let mut weights = vec![length];
        for j in 0..i64::from(*degree) {
            let last = weights[weights.len() - 1].scale(&(integer(i64::from(*degree) - j) / integer(j + 1)));
            weights.push(last);
        }
        factors =
            factors.iter().flat_map(|factor| weights.iter().map(move |weight| factor * weight)).collect();
    }
    Some(form.coefficients().iter().zip(&factors).map(|(b, factor)| b * factor).collect())
}

#[cfg(test)]
mod tests {
    use hodograph_algebra::{Poly, Rational, Variable, integer, ratio};
    use proptest::prelude::*;

    use super::super::separate::Parameters;
    use super::super::{Fractions, Preference, univariate::Builder};
    use super::{Range, Scheme, choose};
    use crate::program::{Floats, Variant, interpret};
    use crate::round::{exact, nearest, round};

    fn unit() -> [Rational; 2] {
        [integer(0), integer(1)]
    }

    fn scheme(poly: &Poly, domain: &[Rational; 2], preference: Preference) -> (Scheme, bool) {
        let range = Range::of(domain, Preference::Fast);
        let choice = choose(poly, &Variable::new(1, "v"), range.as_ref(), preference);
        (choice.scheme, choice.centered)
    }

    #[test]
    fn schemes_are_chosen_by_cost_or_by_error() {
        use Preference::{Accurate, Fast};
        let v = Poly::variable(&Variable::new(1, "v"));
        let dense =
            |degree: u32| (0..=degree).map(|j| v.pow(j).scale(&ratio(1, 1 + i64::from(j)))).sum::<Poly>();
        assert_eq!(scheme(&dense(3), &unit(), Fast), (Scheme::Horner, false));
        assert_eq!(scheme(&dense(9), &unit(), Fast), (Scheme::Estrin, false));
        assert_eq!(scheme(&dense(9), &[integer(20), integer(21)], Fast), (Scheme::Estrin, false));
        let shifted = dense(5).substitute(&Variable::new(1, "v"), &(&v - Poly::integer(20)));
        assert_eq!(scheme(&shifted, &[integer(20), integer(21)], Fast), (Scheme::Horner, true));
        // v^12·(1 − v)^12 is 2^-24 at most, and its terms around the middle sum up to 2^-12.
        let product = (&v * (Poly::one() - &v)).pow(12);
        assert_eq!(scheme(&product, &unit(), Fast).0, Scheme::Bernstein);
        let low = (Poly::one() - &v).pow(4) + v.pow(4).scale(&integer(2));
        assert_ne!(scheme(&low, &unit(), Fast).0, Scheme::Bernstein);
        assert_eq!(scheme(&low, &unit(), Accurate), (Scheme::Horner, true));
        assert_eq!(scheme(&product, &unit(), Accurate).0, Scheme::Bernstein);
        let symbol = Poly::variable(&Variable::new(Variable::SYMBOL, "c0"));
        assert_eq!(scheme(&(&symbol * &v + v.pow(2)), &unit(), Accurate), (Scheme::Horner, false));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        /// Every scheme is the polynomial, exactly, and with floats no farther from it than its figure says.
        #[test]
        fn figures_bound_errors(
            numbers in prop::collection::vec(-40_i64..=40, 3..12),
            start in -6_i64..6,
            accurate in any::<bool>(),
            place in 0.0..1.0_f64,
        ) {
            let (u, v) = (Variable::new(0, "u"), Variable::new(1, "v"));
            let x = Poly::variable(&v);
            let poly: Poly = (0..).zip(&numbers).map(|(j, &n)| x.pow(j).scale(&ratio(n, 7))).sum();
            prop_assume!(poly.degree(&v).is_some_and(|degree| degree > 1));
            let domain = [[integer(0), integer(1)], [ratio(start, 2), ratio(start + 3, 2)]];
            let preference = if accurate { Preference::Accurate } else { Preference::Fast };
            let parameters = Parameters { u: u.clone(), v: v.clone() };
            let mut builder = Builder::new(&parameters, &[], &domain, preference);
            let value = builder.polynomial(&poly);
            let numbers = Fractions { u: Poly::variable(&u), v: x, symbols: Vec::new() };
            let (numerator, denominator) = interpret(&builder.program, &[value], &numbers).unwrap().remove(0);
            prop_assert_eq!(&numerator, &(&poly * &denominator));

            let choice = choose(&poly, &v, Range::of(&domain[1], preference).as_ref(), preference);
            let at = (start as f64 + 3.0 * place) / 2.0;
            let program = round(&builder.program).unwrap();
            let floats = Floats { u: 0.0, v: at, symbols: &[], variant: Variant::Plain };
            let found = interpret(&program, &[value], &floats).unwrap()[0];
            let expected = poly.at(&[(&v, &exact(at).unwrap())]);
            let error = nearest(&(Poly::constant(exact(found).unwrap()) - expected)).unwrap().abs();
            let figure = choice.error.unwrap();
            prop_assert!(error <= 1.0001 * figure * f64::EPSILON / 2.0, "{choice:?} {error:e}");
        }
    }
}
