//! Nets of Bernstein coefficients over the integers, up to a positive factor: the fast form for subdivision.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::sync::Arc;

use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use super::bernstein::{Axis, Bernstein};
use super::interval::Interval;
use super::tensor::Tensor;
use crate::number::field;
use crate::poly::Ring;
use crate::{Int, Monomial, NumberField, Poly, Rational, Variable, budget};

/// Widths in bits at which enclosures of the basis decide a sign before exact arithmetic is asked.
const PRECISIONS: [u64; 2] = [28, 192];

/// A basis of the number field that is sufficient for the coefficients of a net.
#[derive(Debug)]
pub(crate) struct Basis {
    /// Products of distinct generators.
    elements: Vec<Poly>,
    /// For each precision and element, integers below and above `2^precision` times the element.
    enclosures: Vec<Vec<(Int, Int)>>,
}

impl Basis {
    fn new(elements: Vec<Poly>) -> Basis {
        let scaled = |value: &Poly, bits: u64| {
            let enclosure = value.enclosure(bits).scale(&Rational::from(Int::ONE.shl(bits)));
            (enclosure.lower().floor().to_integer(), enclosure.upper().ceil().to_integer())
        };
        let row = |&bits: &u64| elements.iter().map(|element| scaled(element, bits)).collect();
        let enclosures = PRECISIONS.iter().map(row).collect();
        Basis { elements, enclosures }
    }

    /// The sign of the number with the given coordinates.
    fn sign(&self, coordinates: &[Int]) -> Ordering {
        let mut nonzero = coordinates.iter().enumerate().filter(|(_, coordinate)| !coordinate.is_zero());
        let Some((_, first)) = nonzero.next() else { return Ordering::Equal };
        if nonzero.next().is_none() {
            // The elements of the basis are positive.
            return first.cmp(&Int::ZERO);
        }
        for row in &self.enclosures {
            let (mut lower, mut upper) = (Int::ZERO, Int::ZERO);
            for (coordinate, (low, high)) in coordinates.iter().zip(row) {
                let (low, high) = if *coordinate < Int::ZERO { (high, low) } else { (low, high) };
                lower += coordinate * low;
                upper += coordinate * high;
            }
            if lower > Int::ZERO {
                return Ordering::Greater;
            }
            if upper < Int::ZERO {
                return Ordering::Less;
            }
        }
        let pairs = self.elements.iter().zip(coordinates);
        pairs.map(|(element, c)| element.scale(&Rational::from(c.clone()))).sum::<Poly>().sign()
    }
}

/// The Bernstein coefficients of a polynomial over a box, times some positive rational number.
///
/// The coordinates in the number field are one more, innermost, axis of the array, along which nothing is ever mixed.
#[derive(Clone, Debug)]
pub(crate) struct Net {
    basis: Arc<Basis>,
    /// The number of coefficients along each axis.
    lengths: Vec<usize>,
    cells: Vec<Int>,
}

impl Net {
    /// The net of a polynomial over the box `domain`, of its own degrees; `None` if other variables occur.
    pub(crate) fn of(poly: &Poly, domain: &[(Variable, Interval)]) -> Option<Net> {
        let axes = Axis::all(poly, domain);
        let Some(tensor) = Tensor::new(poly, &axes) else { return Net::new(&Bernstein::new(poly, domain)) };
        let ring = poly.ring();
        if tensor.layers.keys().any(|&word| ring.variable_part(Monomial(word)) != Monomial::ONE) {
            return None;
        }
        let lengths: Vec<usize> = axes.iter().map(|axis| axis.degree() as usize + 1).collect();
        let product = |word: &u128| -> Poly {
            let exponents = ring.generator_exponents(Monomial(*word));
            let chosen = (0..exponents.len()).filter(|&i| exponents[i] == 1);
            chosen.map(|i| Poly::generator(ring.field(), i)).product()
        };
        let mut elements: Vec<Poly> = tensor.layers.keys().map(product).collect();
        if elements.is_empty() {
            elements.push(Poly::one());
        }
        let mut cells = vec![Int::ZERO; lengths.iter().product::<usize>() * elements.len()];
        let width = elements.len();
        for (element, layer) in tensor.layers.into_values().enumerate() {
            for (place, coefficient) in layer.into_iter().enumerate() {
                cells[place * width + element] =
                    if tensor.content.is_negative() { -coefficient } else { coefficient };
            }
        }
        let net = Net { basis: Arc::new(Basis::new(elements)), lengths, cells: Vec::new() };
        Some(net.with_cells(cells))
    }

    /// The net of a Bernstein form; `None` if a coefficient is not a number.
    pub(crate) fn new(form: &Bernstein) -> Option<Net> {
        let coefficients = form.coefficients();
        if !coefficients.iter().all(Poly::is_constant) {
            return None;
        }
        let content = Poly::common_content(coefficients);
        let scale = if content.is_zero() { content } else { content.recip() };
        let integral: Vec<Poly> = over_one_field(coefficients).iter().map(|c| c.scale(&scale)).collect();
        // Coordinates by the exponents of the generators.
        let coordinates: Vec<BTreeMap<Vec<u32>, Poly>> =
            integral.iter().map(Poly::generator_coefficients).collect();
        let mut index: BTreeMap<Vec<u32>, usize> = BTreeMap::new();
        for exponents in coordinates.iter().flat_map(BTreeMap::keys) {
            index.entry(exponents.clone()).or_insert(0);
        }
        let mut elements = Vec::new();
        let field = integral.first().map_or_else(NumberField::rationals, |c| c.ring().field().clone());
        for (place, (exponents, position)) in index.iter_mut().enumerate() {
            *position = place;
            let chosen = (0..exponents.len()).filter(|&i| exponents[i] == 1);
            elements.push(chosen.map(|i| Poly::generator(&field, i)).product());
        }
        if elements.is_empty() {
            elements.push(Poly::one());
        }
        let mut cells = vec![Int::ZERO; integral.len() * elements.len()];
        for (cell, coordinates) in cells.chunks_mut(elements.len()).zip(&coordinates) {
            for (exponents, value) in coordinates {
                cell[index[exponents]] = value.content().to_integer();
            }
        }
        let lengths = form.axes().iter().map(|axis| axis.degree() as usize + 1).collect();
        Some(Net { basis: Arc::new(Basis::new(elements)), lengths, cells })
    }

    /// The number of machine words of all integers in it.
    pub(crate) fn words(&self) -> u64 {
        self.cells.iter().map(|cell| 1 + cell.bits() / 64).sum()
    }

    /// The number of coefficients along each axis.
    pub(crate) fn lengths(&self) -> &[usize] {
        &self.lengths
    }

    /// The signs of all coefficients, the index of the first axis outermost.
    pub(crate) fn signs(&self) -> impl Iterator<Item = Ordering> + '_ {
        budget::spend(self.cells.len() as u64);
        self.cells.chunks(self.basis.elements.len()).map(|cell| self.basis.sign(cell))
    }

    /// The sign at a corner of the box: `upper[k]` tells which end of axis `k`.
    pub(crate) fn corner_sign(&self, upper: &[bool]) -> Ordering {
        let place = self.corner_place(upper);
        let width = self.basis.elements.len();
        self.basis.sign(&self.cells[place * width..(place + 1) * width])
    }

    fn corner_place(&self, upper: &[bool]) -> usize {
        let ends = self.lengths.iter().zip(upper);
        ends.fold(0, |place, (length, upper)| place * length + if *upper { length - 1 } else { 0 })
    }

    /// The corners of the box, each as the ends that it is made of.
    pub(crate) fn corners(&self) -> Vec<Vec<bool>> {
        let axes = self.lengths.len();
        (0..1_usize << axes).map(|mask| (0..axes).map(|k| mask >> k & 1 == 1).collect()).collect()
    }

    /// The sign of all nonzero coefficients, if they agree, and so the sign inside the box; `None` if they do not, or
    /// all vanish.
    pub(crate) fn definite_sign(&self) -> Option<Ordering> {
        let mut agreed = None;
        for sign in self.signs().filter(|sign| sign.is_ne()) {
            if *agreed.get_or_insert(sign) != sign {
                return None;
            }
        }
        agreed
    }

    /// Whether all coefficients along some edge of the box are zero.
    pub(crate) fn vanishes_on_an_edge(&self) -> bool {
        let width = self.basis.elements.len();
        let zero = |place: usize| self.cells[place * width..(place + 1) * width].iter().all(Zero::is_zero);
        self.corners().iter().any(|corner| {
            let lower_ends = (0..self.lengths.len()).filter(|&axis| !corner[axis]);
            lower_ends.into_iter().any(|axis| {
                let stride: usize = self.lengths[axis + 1..].iter().product();
                let start = self.corner_place(corner);
                (0..self.lengths[axis]).all(|i| zero(start + i * stride))
            })
        })
    }

    /// The nets of both halves along an axis.
    ///
    /// De Casteljau's algorithm at 1/2 with sums in place of means: the `r`-th row of sums is `2^r` times the row of
    /// means, so multiplying with `2^(n − r)` gives integers, times the same `2^n` everywhere. Complexity: `n²` additions for
    /// each line of `n` coefficients, without a division.
    pub(crate) fn halves(&self, axis: usize) -> (Net, Net) {
        let length = self.lengths[axis];
        let inner = self.basis.elements.len() * self.lengths[axis + 1..].iter().product::<usize>();
        // Each half sums as many lines as the whole, of numbers that grow by a bit for each sum.
        let words = self.cells.iter().map(Int::bits).max().unwrap_or(0) / 64;
        budget::spend((self.cells.len() * length) as u64 * (1 + words / 8) / 2);
        let (mut low, mut high) = (self.cells.clone(), self.cells.clone());
        for (block, (low, high)) in self
            .cells
            .chunks(length * inner)
            .zip(low.chunks_mut(length * inner).zip(high.chunks_mut(length * inner)))
        {
            let mut row = block.to_vec();
            for r in 0..length {
                let last = length - 1 - r;
                let scale = Int::ONE.shl(last as u64);
                for k in 0..inner {
                    low[r * inner + k] = &row[k] * &scale;
                    high[last * inner + k] = &row[last * inner + k] * &scale;
                }
                for place in 0..last * inner {
                    row[place] = &row[place] + &row[place + inner];
                }
            }
        }
        (self.without_twos(low), self.without_twos(high))
    }

    /// The same net with other cells, of which the common power of two is taken out: all that halving puts in.
    fn without_twos(&self, mut cells: Vec<Int>) -> Net {
        let mut twos = None;
        for cell in cells.iter().filter(|cell| !cell.is_zero()) {
            let own = cell.trailing_zeros().unwrap_or(0);
            twos = Some(twos.map_or(own, |twos: u64| twos.min(own)));
            if own == 0 {
                break;
            }
        }
        if let Some(twos @ 1..) = twos {
            for cell in &mut cells {
                *cell = cell.shr(twos);
            }
        }
        Net { basis: self.basis.clone(), lengths: self.lengths.clone(), cells }
    }

    /// The same net with other cells, of which the common divisor is taken out.
    fn with_cells(&self, mut cells: Vec<Int>) -> Net {
        let mut divisor = Int::ZERO;
        for cell in &cells {
            divisor = divisor.gcd(cell);
            if divisor.is_one() {
                break;
            }
        }
        if !divisor.is_zero() && !divisor.is_one() {
            for cell in &mut cells {
                *cell /= &divisor;
            }
        }
        Net { basis: self.basis.clone(), lengths: self.lengths.clone(), cells }
    }
}

/// The same numbers, all over a field that holds each of them.
fn over_one_field(numbers: &[Poly]) -> Vec<Poly> {
    let mut field = NumberField::rationals();
    for number in numbers {
        field = field::join(&field, number.ring().field()).0;
    }
    let anchor = Poly::constant_in(Ring::new([], field.clone()), Rational::zero());
    let ring = Ring::new([], field);
    numbers.iter().map(|number| Poly::unify(&anchor, number).1.transfer_to(&ring)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Interval, Variable, integer, ratio};

    #[test]
    fn halves_agree_with_subdivision() {
        let (u, v) = (Variable::new(0, "u"), Variable::new(1, "v"));
        let (x, y) = (Poly::variable(&u), Poly::variable(&v));
        let root = Poly::sqrt_of(&integer(2));
        let f = x.pow(3) * &root - &x * &y * Poly::integer(3) + y.pow(2).scale(&ratio(1, 3)) - &root;
        let domain = [(u, Interval::new(Poly::integer(-1), root).unwrap()), (v, Interval::unit())];
        let form = Bernstein::new(&f, &domain);
        let net = Net::new(&form).unwrap();
        for (axis, (_, interval)) in domain.iter().enumerate() {
            let middle = interval.point(&ratio(1, 2));
            let (low, high) = form.subdivided(axis, &middle).unwrap();
            let (net_low, net_high) = net.halves(axis);
            for (net, form) in [(net_low, low), (net_high, high)] {
                let expected: Vec<Ordering> = form.coefficients().iter().map(Poly::sign).collect();
                assert_eq!(net.signs().collect::<Vec<_>>(), expected);
                assert_eq!(net.corner_sign(&[true, false]), form.coefficient(&[3, 0]).unwrap().sign());
                // The cells are those of the form, up to one positive factor.
                let again = Net::new(&form).unwrap();
                let factor = |net: &Net| net.cells.iter().fold(Int::ZERO, |g, c| g.gcd(c));
                let (p, q) = (factor(&net), factor(&again));
                for (a, b) in net.cells.iter().zip(&again.cells) {
                    assert_eq!(a / &p, b / &q);
                }
            }
        }
    }

    #[test]
    fn signs_of_close_numbers_are_exact() {
        // (√2 − 1)^150 is about 2^−190, written with coordinates of 190 bits.
        let tiny = (Poly::sqrt_of(&integer(2)) - Poly::one()).pow(150);
        let form = Bernstein::new(&tiny, &[]);
        let net = Net::new(&form).unwrap();
        assert_eq!(net.signs().collect::<Vec<_>>(), [Ordering::Greater]);
    }
}
