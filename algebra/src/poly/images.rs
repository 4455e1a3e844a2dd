//! Images of polynomials modulo primes.

use std::sync::Arc;

use num_traits::Zero;

use super::ring::{Monomial, Ring};
use super::{Poly, Term};
use crate::modular::field::{PrimeField, Residue};
use crate::modular::lift::{Modulo, Rationals};
use crate::modular::multivariate::{Layout, Multivariate};
use crate::modular::prime::price;
use crate::modular::splitting::{Radicand, Splitting};
use crate::{Int, Rational, budget};

/// How the polynomials of a ring are read modulo primes: some of its variables in a chosen order, the first one being
/// the most significant.
#[derive(Clone, Debug)]
pub(crate) struct Frame {
    ring: Arc<Ring>,
    /// The positions in the ring of the chosen variables.
    positions: Vec<usize>,
    layout: Layout,
    /// The positions in the field of the generators that occur, or that these depend on.
    generators: Vec<usize>,
    /// Their rules, in terms of each other.
    radicands: Vec<Radicand>,
}

/// The primitive part of a polynomial in the order of a [`Frame`].
#[derive(Clone, Debug)]
pub(crate) struct FramedTerms {
    terms: Vec<FramedTerm>,
}

#[derive(Clone, Debug)]
struct FramedTerm {
    /// The monomial in the variables.
    word: u128,
    /// The index of the basis element of the field, see [`Splitting`].
    index: usize,
    coefficient: Int,
}

impl Frame {
    /// The frame for `polys`, polynomials of one ring where only the variables at `positions` occur, to at most these
    /// `degrees`.
    pub(crate) fn new(polys: [&Poly; 2], positions: Vec<usize>, degrees: &[u32]) -> Frame {
        let Some(layout) = Layout::new(degrees) else {
            budget::refuse("exponents beyond the range of monomials");
        };
        let ring = polys[0].ring().clone();
        let generators = occurring_generators(&ring, polys);
        let radicands = generators.iter().map(|&generator| {
            let terms = ring.field().generators()[generator].radicand_terms();
            let earlier = |exponents: &[u32]| {
                generators.iter().filter_map(|&position| exponents.get(position).copied()).collect()
            };
            terms.map(|(exponents, coefficient)| (earlier(&exponents), coefficient)).collect()
        });
        Frame { radicands: radicands.collect(), generators, ring, positions, layout }
    }

    /// The packing of exponents.
    pub(crate) fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Whether all coefficients are rational.
    pub(crate) fn is_rational(&self) -> bool {
        self.generators.is_empty()
    }

    /// The next of `fields` with homomorphisms from the number field, with them.
    ///
    /// Leaves the computation if no prime is left.
    pub(crate) fn splitting(&self, fields: &mut impl Iterator<Item = PrimeField>) -> Arc<Splitting> {
        let found = fields.find_map(|field| {
            budget::spend(price(field.modulus()));
            self.ring.field().splitting(field, &self.generators, &self.radicands)
        });
        match found {
            Some(splitting) => splitting,
            None => budget::refuse("no prime is left"),
        }
    }

    /// The images of all generators of the field under the first homomorphism of `splitting`; zero for those that do not occur.
    pub(crate) fn generator_images(&self, splitting: &Splitting) -> Vec<Residue> {
        let mut images = vec![Residue::ZERO; self.ring.field().generators().len()];
        for (i, &generator) in self.generators.iter().rev().enumerate() {
            images[generator] = splitting.basis()[0][1 << i];
        }
        images
    }

    /// The primitive part of `poly` in this frame.
    pub(crate) fn terms(&self, poly: &Poly) -> FramedTerms {
        let read = |term: &Term| {
            let (mut word, mut index) = (0, 0);
            for (i, &position) in self.positions.iter().enumerate() {
                word |= self.layout.power(i, self.ring.exponent(term.monomial, position));
            }
            for &generator in &self.generators {
                index = 2 * index + self.ring.generator_exponent(term.monomial, generator) as usize;
            }
            FramedTerm { word, index, coefficient: term.coefficient.clone() }
        };
        let mut terms: Vec<FramedTerm> = poly.terms().iter().map(read).collect();
        if !terms.is_sorted_by(|a, b| a.word >= b.word) {
            terms.sort_by_key(|term| std::cmp::Reverse(term.word));
        }
        FramedTerms { terms }
    }

    /// The polynomial with these coefficients, by words of the variables and indices of basis elements.
    pub(crate) fn poly(&self, (numerators, denominator): Rationals<(u128, usize)>) -> Poly {
        let nonzero = numerators.into_iter().filter(|(_, coefficient)| !coefficient.is_zero());
        let mut terms: Vec<Term> = nonzero
            .map(|((word, index), coefficient)| Term { monomial: self.monomial(word, index), coefficient })
            .collect();
        terms.sort_by_key(|term| std::cmp::Reverse(term.monomial));
        // The denominator is positive.
        Poly::from_sorted(self.ring.clone(), Rational::new_raw(Int::ONE, denominator), terms)
    }

    /// The monomial of the ring for a word of the variables and the index of a basis element.
    fn monomial(&self, word: u128, index: usize) -> Monomial {
        let mut exponents = vec![0; self.ring.variables().len()];
        for (i, &position) in self.positions.iter().enumerate() {
            exponents[position] = self.layout.exponent(word, i);
        }
        let mut generators = vec![0; self.ring.field().generators().len()];
        for (i, &generator) in self.generators.iter().rev().enumerate() {
            generators[generator] = (index >> i & 1) as u32;
        }
        self.ring.monomial(&exponents, &generators)
    }
}

/// The positions of the generators that occur in `polys` or in the radicands of those that do, ascending.
fn occurring_generators(ring: &Ring, polys: [&Poly; 2]) -> Vec<usize> {
    let union = polys.iter().flat_map(|poly| poly.terms()).fold(0, |union, term| union | term.monomial.0);
    let all = ring.field().generators();
    let mut occurs: Vec<bool> =
        (0..all.len()).map(|i| ring.generator_exponent(Monomial(union), i) > 0).collect();
    // Radicands hold earlier generators only, so one pass from the last one down finds all.
    for i in (0..all.len()).rev() {
        if occurs[i] {
            for (exponents, _) in all[i].radicand_terms() {
                exponents.iter().zip(&mut occurs).for_each(|(&exponent, occurs)| *occurs |= exponent > 0);
            }
        }
    }
    (0..all.len()).filter(|&i| occurs[i]).collect()
}

impl FramedTerms {
    /// The word of the leading monomial in the variables.
    pub(crate) fn leading_word(&self) -> u128 {
        self.terms.first().map_or(0, |term| term.word)
    }

    /// The coefficient of the leading monomial, if it is an integer.
    pub(crate) fn leading_integer(&self) -> Option<&Int> {
        let leading = self.leading_word();
        match self.terms.as_slice() {
            [_, second, ..] if second.word == leading => None,
            [first, ..] if first.index == 0 => Some(&first.coefficient),
            _ => None,
        }
    }

    /// The images under all homomorphisms of `splitting`.
    pub(crate) fn images(&self, splitting: &Splitting) -> Vec<Multivariate> {
        let residues = self.residues(splitting);
        (0..splitting.basis().len()).map(|choice| self.image_of(splitting, choice, &residues)).collect()
    }

    /// The coefficients modulo the prime of `splitting`.
    pub(crate) fn residues(&self, splitting: &Splitting) -> Vec<Residue> {
        self.terms.iter().map(|term| term.coefficient.modulo(splitting.field())).collect()
    }

    /// The image under the homomorphism `choice` of `splitting`, from the [residues](FramedTerms::residues) of the coefficients.
    pub(crate) fn image_of(
        &self,
        splitting: &Splitting,
        choice: usize,
        residues: &[Residue],
    ) -> Multivariate {
        budget::spend(self.terms.len() as u64);
        let (field, basis) = (splitting.field(), &splitting.basis()[choice]);
        let terms = self.terms.iter().zip(residues);
        let values = terms.map(|(term, &residue)| (term.word, field.mul(residue, basis[term.index])));
        Multivariate::new(field, values.collect())
    }
}
