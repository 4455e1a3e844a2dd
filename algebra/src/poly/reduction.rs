//! The rules g² = r of a number field, applied to sums of products of its numbers.

use num_traits::{One, Zero};

use super::Term;
use super::ring::{Monomial, Ring, generator_monomial};
use super::terms::collect;
use crate::number::field::Generator;
use crate::{Int, budget};

/// Fields with more generators have no table, which would have 4ⁿ rows.
const MOST_GENERATORS: usize = 4;

/// What the rules of a number field make of each product of powers of its generators up to the second: its coordinates in
/// the basis of products of distinct generators.
///
/// These are the structure constants of the field (compare Cohen, *A Course in Computational Algebraic Number Theory*, section
/// 4.2). Complexity: for each term as many additions as its row has entries, at most the degree of the field; rules one
/// after the other would sort all terms once for each generator.
#[derive(Debug)]
pub(crate) struct Reduction {
    /// By the word of a product, the place in the basis of each element that occurs and its coefficient.
    rows: Vec<Vec<(usize, Int)>>,
    /// The words of the basis, ascending.
    basis: Vec<u128>,
}

impl Reduction {
    /// The table for a field; `None` if it is too large for one.
    pub(crate) fn new(generators: &[Generator]) -> Option<Reduction> {
        let count = generators.len();
        if count > MOST_GENERATORS {
            return None;
        }
        let word = |exponents: &[u32]| generator_monomial(exponents).0;
        let bits = |element: usize| (0..count).map(|i| (element >> i & 1) as u32).collect::<Vec<u32>>();
        let basis: Vec<u128> = (0..1 << count).map(|element| word(&bits(element))).collect();
        let mut rows = vec![Vec::new(); word(&vec![3; count]) as usize + 1];
        for number in 0..3_usize.pow(count as u32) {
            let exponents: Vec<u32> =
                (0..count as u32).map(|i| (number / 3_usize.pow(i) % 3) as u32).collect();
            let mut coordinates = vec![Int::ZERO; basis.len()];
            let odd = |i: &usize| exponents[*i] == 1;
            coordinates[(0..count).filter(odd).map(|i| 1 << i).sum::<usize>()] = Int::ONE;
            for i in (0..count).filter(|i| exponents[*i] == 2) {
                coordinates = times_radicand(&coordinates, generators, i);
            }
            let nonzero = coordinates.into_iter().enumerate().filter(|(_, coordinate)| !coordinate.is_zero());
            rows[word(&exponents) as usize] = nonzero.collect();
        }
        Some(Reduction { rows, basis })
    }

    /// Applies the rules to sorted terms with exponents of generators up to 2: the terms of each monomial in the variables
    /// are neighbors.
    fn apply(&self, mask: u128, terms: &[Term]) -> Vec<Term> {
        let mut reduced = Vec::with_capacity(terms.len());
        let mut cells = vec![Int::ZERO; self.basis.len()];
        let mut next = 0;
        while next < terms.len() {
            let variables = terms[next].monomial.0 & !mask;
            while next < terms.len() && terms[next].monomial.0 & !mask == variables {
                let term = &terms[next];
                for (place, factor) in &self.rows[(term.monomial.0 & mask) as usize] {
                    if factor.is_one() {
                        cells[*place] += &term.coefficient;
                    } else {
                        cells[*place] += &term.coefficient * factor;
                    }
                }
                next += 1;
            }
            for (word, cell) in self.basis.iter().zip(&mut cells).rev() {
                if !cell.is_zero() {
                    let monomial = Monomial(variables | word);
                    reduced.push(Term { monomial, coefficient: std::mem::take(cell) });
                }
            }
        }
        reduced
    }
}

/// The product of a number, given by its coordinates, and the radicand of the generator at `position`.
fn times_radicand(coordinates: &[Int], generators: &[Generator], position: usize) -> Vec<Int> {
    let mut sum = vec![Int::ZERO; coordinates.len()];
    for (exponents, coefficient) in generators[position].radicand_terms() {
        let factors = exponents.iter().enumerate().filter(|(_, exponent)| **exponent > 0);
        let product =
            factors.fold(coordinates.to_vec(), |product, (i, _)| times_generator(&product, generators, i));
        for (sum, cell) in sum.iter_mut().zip(product) {
            *sum += cell * &coefficient;
        }
    }
    sum
}

/// The product of a number and the generator at `position`: what has it already gets its radicand instead.
fn times_generator(coordinates: &[Int], generators: &[Generator], position: usize) -> Vec<Int> {
    let bit = 1 << position;
    let (mut without, mut with) = (vec![Int::ZERO; coordinates.len()], vec![Int::ZERO; coordinates.len()]);
    for (element, cell) in coordinates.iter().enumerate() {
        if element & bit == 0 {
            with[element | bit] = cell.clone();
        } else {
            without[element & !bit] = cell.clone();
        }
    }
    let squared = times_radicand(&without, generators, position);
    with.into_iter().zip(squared).map(|(a, b)| a + b).collect()
}

/// Applies the rules `g² = r` of the number field to sorted terms, until no exponent of a generator exceeds 1.
pub(crate) fn reduce(ring: &Ring, terms: Vec<Term>) -> Vec<Term> {
    let squares = ring.generator_squares();
    if !terms.iter().any(|term| term.monomial.0 & squares != 0) {
        return terms;
    }
    match ring.field().reduction() {
        Some(reduction) => reduction.apply(ring.generator_mask(), &terms),
        None => apply_rules(ring, terms, ring.field().generators().len()),
    }
}

/// Applies the rules of the first `count` generators, one after the other.
fn apply_rules(ring: &Ring, mut terms: Vec<Term>, count: usize) -> Vec<Term> {
    // From the last generator down: its radicand is free of itself and of later ones.
    for position in (0..count).rev() {
        if terms.iter().all(|term| ring.generator_exponent(term.monomial, position) < 2) {
            continue;
        }
        // The rule may add 1 to the exponents of all earlier generators, which have no room for more than 3.
        let full = |term: &Term| (0..position).any(|i| ring.generator_exponent(term.monomial, i) > 2);
        if terms.iter().any(full) {
            terms = apply_rules(ring, terms, position);
        }
        // An exponent is 3 at most, so one application is enough.
        let word = ring.generator_word(position);
        let radicand: Vec<(Monomial, Int)> = ring.field().generators()[position]
            .radicand_terms()
            .map(|(exponents, coefficient)| (generator_monomial(&exponents), coefficient))
            .collect();
        let mut expanded = Vec::with_capacity(charge(ring, &terms, position, &radicand));
        for term in terms {
            if ring.generator_exponent(term.monomial, position) < 2 {
                expanded.push(term);
                continue;
            }
            let rest = term.monomial.0 - 2 * word;
            for (monomial, coefficient) in &radicand {
                let coefficient = &term.coefficient * coefficient;
                expanded.push(Term { monomial: Monomial(rest + monomial.0), coefficient });
            }
        }
        terms = collect(expanded);
    }
    terms
}

/// Spends the work of replacing `g²` in `terms`, for the generator `g` at `position`, and reserves the memory; the number of
/// terms that become of them.
fn charge(ring: &Ring, terms: &[Term], position: usize, radicand: &[(Monomial, Int)]) -> usize {
    let squares = terms.iter().filter(|term| ring.generator_exponent(term.monomial, position) > 1).count();
    let count = terms.len() - squares + squares * radicand.len();
    let bits = terms.iter().map(|term| term.coefficient.bits()).max().unwrap_or(0);
    // A number of more than a word has a place of its own, with some overhead.
    let bytes = size_of::<Term>() as u64 + if bits < 63 { 0 } else { 96 + bits / 8 };
    budget::reserve(2 * bytes * count as u64);
    budget::spend(squares as u64 * radicand.len() as u64 * (1 + bits / 512));
    count
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::{Poly, Variable, integer};

    /// Q(√2, θ, √5, η) with θ² = 110 + 100√2 and η² = 7 + θ√2 + √5.
    fn ring() -> std::sync::Arc<Ring> {
        let root = Poly::sqrt_of(&integer(2));
        let theta = (Poly::integer(110) + &root * Poly::integer(100)).sqrt().unwrap();
        let five = &theta + Poly::sqrt_of(&integer(5));
        let eta = (Poly::integer(7) + &theta * &root + Poly::sqrt_of(&integer(5))).sqrt().unwrap();
        let field = (five + eta).ring().field().clone();
        assert_eq!(field.generators().len(), 4);
        Ring::new([Variable::new(0, "u"), Variable::new(1, "v")], field)
    }

    proptest! {
        #[test]
        fn table_and_rules_agree(
            terms in prop::collection::vec((0_u32..3, 0_u32..3, [0_u32..3, 0..3, 0..3, 0..3], -9_i64..9), 0..40)
        ) {
            let ring = ring();
            let term = |(u, v, generators, coefficient): (u32, u32, [u32; 4], i64)| Term {
                monomial: ring.monomial(&[u, v], &generators),
                coefficient: coefficient.into(),
            };
            let terms = collect(terms.into_iter().map(term).collect());
            prop_assert_eq!(reduce(&ring, terms.clone()), apply_rules(&ring, terms, 4));
        }
    }
}
