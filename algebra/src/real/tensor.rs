//! Bernstein coefficients over boxes with rational ends, as arrays of integers.

use std::collections::BTreeMap;

use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use super::bernstein::Axis;
use crate::poly::{Poly, Term};
use crate::{Int, Monomial, Rational, budget};

/// The coefficients of a Bernstein form, `content` times integers.
///
/// What is no variable of an axis, that is generators of the number field and other variables, is kept apart by its
/// monomial: each has an array of its own, with the index of the first axis outermost.
pub(super) struct Tensor {
    /// The common factor of all integers.
    pub(super) content: Rational,
    /// The arrays by the monomial's word, ascending; a polynomial other than zero has at least one.
    pub(super) layers: BTreeMap<u128, Vec<Int>>,
}

impl Tensor {
    /// The coefficients of `poly` over the box of the `axes`; `None` if one of its ends is irrational.
    ///
    /// Along each axis, `a(x) = Σ aᵢ·xⁱ` over `[p/q, (p + r)/q]` becomes `qⁿ·a((p + r·t)/q) = Σ cᵢ·tⁱ` by Horner's rule
    /// (the Taylor shift of von zur Gathen and Gerhard, *Fast algorithms for Taylor shifts and certain difference
    /// equations*, 1997, method A), and `b(j) = Σ C(j, i)/C(n, i)·cᵢ` is found by additions as in Pascal's triangle, with
    /// the least common multiple of the `C(n, i)` as common denominator. Complexity: `n²` additions, and for other intervals
    /// than the unit one as many products with `p`, for each line that is not zero; general arithmetic of polynomials takes
    /// a hundred times as long in degree (100, 100).
    pub(super) fn new(poly: &Poly, axes: &[Axis]) -> Option<Tensor> {
        let ends: Vec<(Rational, Rational)> = axes
            .iter()
            .map(|axis| {
                Some((axis.interval().lower().to_rational()?, axis.interval().width().to_rational()?))
            })
            .collect::<Option<_>>()?;
        let lengths: Vec<usize> = axes.iter().map(|axis| axis.degree() as usize + 1).collect();
        let mut tensor = Tensor::of_powers(poly, axes, &lengths);
        for (position, (lower, width)) in ends.iter().enumerate() {
            tensor.convert(position, &lengths, lower, width);
        }
        Some(tensor)
    }

    /// The coefficients of the powers.
    fn of_powers(poly: &Poly, axes: &[Axis], lengths: &[usize]) -> Tensor {
        let ring = poly.ring();
        let positions: Vec<Option<usize>> = axes.iter().map(|axis| ring.position(axis.variable())).collect();
        let size = lengths.iter().fold(1_u64, |size, &length| size.saturating_mul(length as u64));
        let mut layers: BTreeMap<u128, Vec<Int>> = BTreeMap::new();
        for term in poly.terms() {
            let (mut rest, mut place) = (term.monomial.0, 0);
            for (position, length) in positions.iter().zip(lengths) {
                let exponent = position.map_or(0, |position| ring.exponent(term.monomial, position));
                if let Some(position) = position {
                    rest -= ring.variable_word(*position) * u128::from(exponent);
                }
                place = place * length + exponent as usize;
            }
            let layer = layers.entry(rest).or_insert_with(|| {
                budget::reserve(size.saturating_mul(size_of::<Int>() as u64));
                budget::spend(size);
                vec![Int::ZERO; size as usize]
            });
            layer[place] = term.coefficient.clone();
        }
        Tensor { content: poly.content().clone(), layers }
    }

    /// Replaces powers along the axis at `position` by Bernstein polynomials over the interval from `lower`.
    fn convert(&mut self, position: usize, lengths: &[usize], lower: &Rational, width: &Rational) {
        let length = lengths[position];
        let stride: usize = lengths[position + 1..].iter().product();
        let map = AffineMap::new(lower, width);
        let weights = Weights::new(length - 1);
        let mut line = Vec::with_capacity(length);
        for layer in self.layers.values_mut() {
            for start in 0..layer.len() / length {
                // Lines begin at the places whose index along the axis is zero.
                let start = start / stride * stride * length + start % stride;
                let places = || (0..length).map(|i| start + i * stride);
                if places().all(|place| layer[place].is_zero()) {
                    continue;
                }
                line.clear();
                line.extend(places().map(|place| std::mem::take(&mut layer[place])));
                map.apply(&mut line);
                weights.apply(&mut line);
                for (place, cell) in places().zip(line.drain(..)) {
                    layer[place] = cell;
                }
            }
        }
        let degree = (length - 1) as u32;
        let denominator = map.denominator.pow(degree) * &weights.common;
        self.content = &self.content / Rational::from(denominator);
        self.take_out_divisor();
    }

    /// Makes the common divisor of all integers a factor of the content.
    fn take_out_divisor(&mut self) {
        let mut divisor = Int::ZERO;
        for cell in self.layers.values().flatten().filter(|cell| !cell.is_zero()) {
            if divisor.is_zero() {
                divisor = cell.abs();
            } else if !cell.is_multiple_of(&divisor) {
                divisor = divisor.gcd(cell);
            }
            if divisor.is_one() {
                return;
            }
        }
        if !divisor.is_zero() {
            for cell in self.layers.values_mut().flatten().filter(|cell| !cell.is_zero()) {
                *cell = &*cell / &divisor;
            }
            self.content = &self.content * Rational::from(divisor);
        }
    }

    /// The coefficients as polynomials in the ring of `poly`, from which they were made.
    pub(super) fn into_polys(self, poly: &Poly, count: usize) -> Vec<Poly> {
        budget::reserve((count * (size_of::<Poly>() + size_of::<Term>())) as u64);
        budget::spend(CELL * count as u64);
        let mut lists: Vec<Vec<Term>> = vec![Vec::new(); count];
        for (word, layer) in self.layers.into_iter().rev() {
            for (list, coefficient) in lists.iter_mut().zip(layer) {
                if !coefficient.is_zero() {
                    list.push(Term { monomial: Monomial(word), coefficient });
                }
            }
        }
        let build = |list| Poly::from_sorted(poly.ring().clone(), self.content.clone(), list);
        lists.into_iter().map(build).collect()
    }
}

/// The price of a coefficient as a polynomial.
const CELL: u64 = 8;

/// Spends the work of `n²/2` sums or products of the numbers in a line.
fn charge(line: &[Int], grown: u64) {
    let bits = line.iter().map(Int::bits).max().unwrap_or(0) + grown;
    let operations = (line.len() as u64).pow(2) / 2;
    budget::spend(operations.saturating_mul(if bits < 64 { 1 } else { 4 + bits / 256 }) / 8);
}

/// `x = (p + r·t)/q`.
struct AffineMap {
    constant: Int,
    factor: Int,
    denominator: Int,
}

impl AffineMap {
    fn new(lower: &Rational, width: &Rational) -> AffineMap {
        let denominator = lower.denom().lcm(width.denom());
        let over = |value: &Rational| value.numer() * (&denominator / value.denom());
        AffineMap { constant: over(lower), factor: over(width), denominator }
    }

    /// The coefficients of `qⁿ·a((p + r·t)/q)` in place of those of `a`.
    fn apply(&self, line: &mut [Int]) {
        let degree = line.len() - 1;
        let powers = |factor: &Int, line: &mut dyn Iterator<Item = &mut Int>| {
            let mut power = Int::ONE;
            for coefficient in line {
                *coefficient = &*coefficient * &power;
                power *= factor;
            }
        };
        if !self.denominator.is_one() {
            powers(&self.denominator, &mut line.iter_mut().rev());
        }
        if !self.constant.is_zero() {
            charge(line, self.constant.abs().bits() * degree as u64);
            for start in 0..degree {
                for i in (start..degree).rev() {
                    let shifted = &line[i + 1] * &self.constant;
                    line[i] += shifted;
                }
            }
        }
        if !self.factor.is_one() {
            powers(&self.factor, &mut line.iter_mut());
        }
    }
}

/// The least common multiple of the binomial coefficients `C(n, i)`, and what it is of each of them.
struct Weights {
    common: Int,
    quotients: Vec<Int>,
}

impl Weights {
    fn new(degree: usize) -> Weights {
        budget::spend(64 * (degree as u64 + 1));
        let mut binomials = vec![Int::ONE];
        for i in 0..degree {
            let next = &binomials[i] * Int::from((degree - i) as u64) / Int::from(i as u64 + 1);
            binomials.push(next);
        }
        let common = binomials.iter().fold(Int::ONE, |common, binomial| common.lcm(binomial));
        let quotients = binomials.iter().map(|binomial| &common / binomial).collect();
        Weights { common, quotients }
    }

    /// The Bernstein coefficients, times the common multiple, in place of those of the powers.
    fn apply(&self, line: &mut [Int]) {
        for (coefficient, quotient) in line.iter_mut().zip(&self.quotients) {
            *coefficient = &*coefficient * quotient;
        }
        charge(line, line.len() as u64);
        // After k rounds, every entry from the k-th on is a sum of 2ᵏ, with the binomial coefficients C(k, ·).
        for start in 1..line.len() {
            for j in (start..line.len()).rev() {
                let before = std::mem::take(&mut line[j - 1]);
                line[j] += &before;
                line[j - 1] = before;
            }
        }
    }
}
