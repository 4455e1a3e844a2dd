//! Images of polynomials modulo primes.

use std::sync::Arc;

use super::ring::{Monomial, Ring};
use super::{Poly, Term};
use crate::Int;
use crate::budget;
use crate::modular::field::{PrimeField, Residue};
use crate::modular::lift::Modulo;
use crate::modular::multivariate::{Layout, Multivariate};
use crate::modular::splitting::{Radicand, Splitting};

/// How the polynomials of a ring are read modulo primes: some of its variables in a chosen order, the first one being
/// the most significant.
#[derive(Clone, Debug)]
pub(crate) struct Frame {
    ring: Arc<Ring>,
    /// The positions in the ring of the chosen variables.
    positions: Vec<usize>,
    layout: Layout,
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
    /// The frame of the variables at `positions`, the only ones to occur, of at most these `degrees`.
    pub(crate) fn new(ring: &Arc<Ring>, positions: Vec<usize>, degrees: &[u32]) -> Frame {
        let Some(layout) = Layout::new(degrees) else {
            budget::refuse("exponents beyond the range of monomials");
        };
        let radicands = ring.field().generators().iter().map(|generator| generator.radicand_terms().collect());
        Frame { radicands: radicands.collect(), ring: ring.clone(), positions, layout }
    }

    /// The packing of exponents.
    pub(crate) fn layout(&self) -> &Layout {
        &self.layout
    }

    /// The next of `fields` with homomorphisms from the number field, with them.
    ///
    /// Leaves the computation if no prime is left.
    pub(crate) fn splitting(&self, fields: &mut impl Iterator<Item = PrimeField>) -> Splitting {
        match Splitting::find(fields, &self.radicands) {
            Some(splitting) => splitting,
            None => budget::refuse("no prime is left"),
        }
    }

    /// The primitive part of `poly` in this frame.
    pub(crate) fn terms(&self, poly: &Poly) -> FramedTerms {
        let generators = self.radicands.len();
        let read = |term: &Term| {
            let exponents: Vec<u32> =
                self.positions.iter().map(|&position| self.ring.exponent(term.monomial, position)).collect();
            let word = self.layout.pack(&exponents);
            let bit = |i: usize| (self.ring.generator_exponent(term.monomial, i) as usize) << (generators - 1 - i);
            let index = (0..generators).map(bit).sum();
            FramedTerm { word, index, coefficient: term.coefficient.clone() }
        };
        let mut terms: Vec<FramedTerm> = poly.terms().iter().map(read).collect();
        terms.sort_by_key(|term| std::cmp::Reverse(term.word));
        FramedTerms { terms }
    }

    /// The monomial of the ring for a word of the variables and the index of a basis element.
    pub(crate) fn monomial(&self, word: u128, index: usize) -> Monomial {
        let mut exponents = vec![0; self.ring.variables().len()];
        for (i, &position) in self.positions.iter().enumerate() {
            exponents[position] = self.layout.exponent(word, i);
        }
        let count = self.radicands.len();
        let generators: Vec<u32> = (0..count).map(|i| (index >> (count - 1 - i) & 1) as u32).collect();
        self.ring.monomial(&exponents, &generators)
    }
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
        (0..splitting.basis().len()).map(|choice| self.combine(splitting, choice, &residues)).collect()
    }

    /// The image under the homomorphism `choice` of `splitting`.
    pub(crate) fn image(&self, splitting: &Splitting, choice: usize) -> Multivariate {
        self.combine(splitting, choice, &self.residues(splitting))
    }

    fn residues(&self, splitting: &Splitting) -> Vec<Residue> {
        self.terms.iter().map(|term| term.coefficient.modulo(splitting.field())).collect()
    }

    fn combine(&self, splitting: &Splitting, choice: usize, residues: &[Residue]) -> Multivariate {
        budget::spend(self.terms.len() as u64);
        let (field, basis) = (splitting.field(), &splitting.basis()[choice]);
        let terms = self.terms.iter().zip(residues);
        let values = terms.map(|(term, &residue)| (term.word, field.mul(residue, basis[term.index])));
        Multivariate::new(field, values.collect())
    }
}
