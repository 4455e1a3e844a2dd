//! Polynomial rings: ordered variables, then the generators of a number field.

use std::cmp::Ordering;
use std::fmt;
use std::sync::Arc;

use crate::budget;
use crate::number::field::NumberField;

/// A variable of polynomials: a parameter such as `u`, or a symbol such as `a0`.
///
/// Variables are ordered by rank, then by name; the order decides how polynomials print and which variable is the main
/// one. Two variables are the same if both rank and name agree.
///
/// # Example
/// ```
/// use hodograph_algebra::Variable;
/// let (u, a0) = (Variable::new(0, "u"), Variable::new(Variable::SYMBOL, "a0"));
/// assert!(u < a0);
/// assert_eq!(u.to_string(), "u");
/// ```
#[derive(Clone, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Variable {
    rank: u32,
    name: Arc<str>,
}

impl Variable {
    /// The rank of symbols: after the parameters of a surface, which have the ranks 0, 1, ….
    pub const SYMBOL: u32 = 16;

    /// The variable `name` of the given rank.
    #[must_use]
    pub fn new(rank: u32, name: &str) -> Variable {
        Variable { rank, name: name.into() }
    }

    /// The name that it prints with.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The rank: small ranks come first.
    #[must_use]
    pub fn rank(&self) -> u32 {
        self.rank
    }
}

impl fmt::Display for Variable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name)
    }
}

impl fmt::Debug for Variable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name)
    }
}

/// The exponents of all variables and generators of a [`Ring`], packed into one word.
///
/// The first variable has the most significant bits, so that the order of words is the lexicographic order of
/// monomials; the generators of the number field come last, so that the terms of one coefficient in the field are
/// neighbors. The product of monomials is the sum of words. The exponents are read through [`Ring::exponent`].
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub struct Monomial(pub(crate) u128);

impl Monomial {
    /// The monomial 1.
    pub const ONE: Monomial = Monomial(0);
}

/// Bits of the exponent of a generator: at most 1 + 1 after a product, and one more while it is being reduced.
const GENERATOR_BITS: u32 = 2;
/// Bits of the exponent of a variable, where there are few variables.
const MOST_BITS: u32 = 20;
/// Bits of the exponent of a variable, at least.
const LEAST_BITS: u32 = 5;

/// The ring `K[x₁, …, xₙ]` over a [`NumberField`] `K`, whose generators are further symbols with rules `g² = r`.
///
/// Rings are shared by reference counting and grow on demand: an operation on polynomials of different rings takes
/// place in the smallest ring that holds both.
#[derive(Debug)]
pub struct Ring {
    variables: Vec<Variable>,
    field: Arc<NumberField>,
    /// Bits of each variable's exponent, of which the highest is the guard.
    bits: u32,
    /// The guard bits of all variables.
    guards: u128,
    /// The position of the lowest bit of the first variable's exponent.
    first_shift: u32,
}

impl PartialEq for Ring {
    fn eq(&self, other: &Ring) -> bool {
        self.variables == other.variables && self.field == other.field
    }
}

impl Ring {
    /// The ring in `variables` over `field`. The variables are put into their order; duplicates count once.
    ///
    /// Leaves the computation (see [`budget`]) if there are more variables than fit a monomial.
    #[must_use]
    pub fn new(variables: impl IntoIterator<Item = Variable>, field: Arc<NumberField>) -> Arc<Ring> {
        let mut variables: Vec<Variable> = variables.into_iter().collect();
        variables.sort();
        variables.dedup();
        let generator_bits = GENERATOR_BITS * u32::try_from(field.generators().len()).unwrap_or(u32::MAX / 4);
        let count = u32::try_from(variables.len()).unwrap_or(u32::MAX);
        let bits = 128_u32.saturating_sub(generator_bits) / count.max(1);
        let bits = bits.min(MOST_BITS);
        if bits < LEAST_BITS || generator_bits > 64 {
            budget::refuse(format!(
                "{count} symbols and {} square roots are more than one polynomial can hold",
                field.generators().len()
            ));
        }
        let guards = (0..count).map(|i| 1_u128 << (generator_bits + bits * (i + 1) - 1)).sum();
        let first_shift = generator_bits + bits * count.saturating_sub(1);
        Arc::new(Ring { variables, field, bits, guards, first_shift })
    }

    /// The ring without variables over the rationals.
    #[must_use]
    pub fn rationals() -> Arc<Ring> {
        Ring::new([], NumberField::rationals())
    }

    /// The variables, in their order.
    #[must_use]
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// The number field of the coefficients.
    #[must_use]
    pub fn field(&self) -> &Arc<NumberField> {
        &self.field
    }

    /// The position of `variable`, if the ring has it.
    #[must_use]
    pub fn position(&self, variable: &Variable) -> Option<usize> {
        self.variables.binary_search(variable).ok()
    }

    /// The exponent in `monomial` of the variable at `position`.
    #[must_use]
    pub fn exponent(&self, monomial: Monomial, position: usize) -> u32 {
        let mask = (1_u128 << self.bits) - 1;
        low_word(monomial.0 >> self.shift(position) & mask)
    }

    /// The exponent in `monomial` of the generator at `position` of the field.
    #[must_use]
    pub fn generator_exponent(&self, monomial: Monomial, position: usize) -> u32 {
        let mask = (1_u128 << GENERATOR_BITS) - 1;
        low_word(monomial.0 >> generator_shift(position) & mask)
    }

    /// The largest exponent that a variable can have.
    #[must_use]
    pub fn max_exponent(&self) -> u32 {
        (1 << (self.bits - 1)) - 1
    }

    /// The monomial with the given exponents of the variables and generators, in their order.
    ///
    /// Leaves the computation (see [`budget`]) if an exponent is beyond [`Ring::max_exponent`].
    #[must_use]
    pub fn monomial(&self, exponents: &[u32], generators: &[u32]) -> Monomial {
        let mut word = generator_monomial(generators).0;
        for (position, &exponent) in exponents.iter().enumerate() {
            if exponent > self.max_exponent() {
                self.refuse_exponent();
            }
            word |= u128::from(exponent) << self.shift(position);
        }
        Monomial(word)
    }

    /// The exponents of all variables, in their order.
    #[must_use]
    pub fn exponents(&self, monomial: Monomial) -> Vec<u32> {
        (0..self.variables.len()).map(|position| self.exponent(monomial, position)).collect()
    }

    /// The exponents of all generators, in their order.
    #[must_use]
    pub fn generator_exponents(&self, monomial: Monomial) -> Vec<u32> {
        (0..self.generator_count()).map(|position| self.generator_exponent(monomial, position)).collect()
    }

    /// The part of `monomial` in the variables.
    #[must_use]
    pub fn variable_part(&self, monomial: Monomial) -> Monomial {
        Monomial(monomial.0 & !self.generator_mask())
    }

    /// The part of `monomial` in the generators of the field.
    #[must_use]
    pub fn generator_part(&self, monomial: Monomial) -> Monomial {
        Monomial(monomial.0 & self.generator_mask())
    }

    /// `monomial / divisor` in the variables, if that is a monomial. `divisor` is free of generators.
    pub(crate) fn quotient(&self, monomial: Monomial, divisor: Monomial) -> Option<Monomial> {
        // A borrow out of an exponent clears the guard bit that was set there.
        let difference = (monomial.0 | self.guards).wrapping_sub(divisor.0);
        (difference & self.guards == self.guards).then_some(Monomial(difference & !self.guards))
    }

    /// Leaves the computation if `combined`, the union of the words of a result, shows an exponent beyond the range.
    pub(crate) fn check_exponents(&self, combined: u128) {
        if combined & self.guards != 0 {
            self.refuse_exponent();
        }
    }

    /// The larger exponent of each variable and generator, of words without excess.
    pub(crate) fn maximum(&self, a: u128, b: u128) -> u128 {
        // A guard bit survives where the exponent of a is not smaller, and becomes a mask of that exponent's other bits.
        let kept = ((a | self.guards) - (b & !self.generator_mask())) & self.guards;
        let mask = kept - (kept >> (self.bits - 1));
        (a & mask) | (b & !mask) | (a & self.generator_mask())
    }

    /// The word that holds one power of the generator at `position`.
    pub(crate) fn generator_word(&self, position: usize) -> u128 {
        1 << generator_shift(position)
    }

    /// The word that holds one power of the variable at `position`.
    pub(crate) fn variable_word(&self, position: usize) -> u128 {
        1 << self.shift(position)
    }

    /// For each variable then each generator, its shift and mask, most significant first.
    pub(crate) fn fields(&self) -> Vec<(u32, u128)> {
        let variables = (0..self.variables.len()).map(|i| (self.shift(i), (1 << self.bits) - 1));
        let generators = (0..self.generator_count()).map(|i| (generator_shift(i), (1 << GENERATOR_BITS) - 1));
        let mut fields: Vec<(u32, u128)> = variables.chain(generators).collect();
        fields.sort_by_key(|&(shift, _)| std::cmp::Reverse(shift));
        fields
    }

    pub(crate) fn generator_mask(&self) -> u128 {
        (1 << (GENERATOR_BITS as usize * self.generator_count())) - 1
    }

    /// The bits that are set where the exponent of a generator exceeds 1.
    pub(crate) fn generator_squares(&self) -> u128 {
        // The upper one of each pair of bits.
        self.generator_mask() / 3 * 2
    }

    fn generator_count(&self) -> usize {
        self.field.generators().len()
    }

    fn shift(&self, position: usize) -> u32 {
        // Positions are below 128/LEAST_BITS.
        self.first_shift - self.bits * position as u32
    }

    fn refuse_exponent(&self) -> ! {
        budget::refuse(format!(
            "a polynomial in {} symbols would reach an exponent beyond {}",
            self.variables.len(),
            self.max_exponent()
        ))
    }

    /// The smallest ring with the variables of both over `field`, which extends both fields.
    pub(crate) fn union(a: &Arc<Ring>, b: &Arc<Ring>, field: &Arc<NumberField>) -> Arc<Ring> {
        let variables = merge(&a.variables, &b.variables);
        for ring in [a, b] {
            if ring.variables == variables && ring.field == *field {
                return ring.clone();
            }
        }
        Ring::new(variables, field.clone())
    }

    /// The ring with `variable` as well.
    #[must_use]
    pub fn with_variable(self: &Arc<Ring>, variable: &Variable) -> Arc<Ring> {
        if self.position(variable).is_some() {
            return self.clone();
        }
        Ring::new(self.variables.iter().cloned().chain([variable.clone()]), self.field.clone())
    }

    /// The bits of the exponent of the variable at `position`.
    pub(crate) fn exponent_mask(&self, position: usize) -> u128 {
        ((1 << self.bits) - 1) << self.shift(position)
    }

    /// How the monomials of this ring are written in the ring `to`, which has this field's generators first among its own;
    /// variables that it does not have must not occur.
    pub(crate) fn transfer<'a>(&self, to: &'a Ring) -> Transfer<'a> {
        let (mut runs, mut excess): (Vec<(u128, u32, u32)>, u128) = (Vec::new(), 0);
        let mut push = |mask: u128, from: u32, onto: u32| {
            // Neighbors that move by as many bits move together.
            match runs.last_mut().filter(|last| last.1 + onto == last.2 + from) {
                Some(last) => *last = (last.0 | mask, from, onto),
                None => runs.push((mask, from, onto)),
            }
        };
        for (position, variable) in self.variables.iter().enumerate() {
            let (mask, from) = (self.exponent_mask(position), self.shift(position));
            excess |= mask & !(u128::from(to.max_exponent()) << from);
            if let Some(target) = to.position(variable) {
                push(mask, from, to.shift(target));
            }
        }
        push(self.generator_mask(), 0, 0);
        Transfer { to, runs, excess }
    }
}

/// How the monomials of one ring are written in another one.
pub(crate) struct Transfer<'a> {
    to: &'a Ring,
    /// The bits of neighboring exponents, and the positions of the lowest of them in the old and the new word.
    runs: Vec<(u128, u32, u32)>,
    /// The bits of exponents that there is no room for.
    excess: u128,
}

impl Transfer<'_> {
    /// The monomial in the other ring. It leaves the computation if an exponent is beyond its range.
    pub(crate) fn monomial(&self, monomial: Monomial) -> Monomial {
        if monomial.0 & self.excess != 0 {
            self.to.refuse_exponent();
        }
        let mut word = 0;
        let runs = self.runs.as_slice();
        let mut i = 0;
        while i < runs.len() {
            let (mask, from, onto) = runs[i];
            word |= (monomial.0 & mask) >> from << onto;
            i += 1;
        }
        Monomial(word)
    }
}

/// The last generator, which may contain all others in its radicand, is the most significant one.
fn generator_shift(position: usize) -> u32 {
    // Positions are below 64/GENERATOR_BITS.
    GENERATOR_BITS * position as u32
}

/// The monomial with the given exponents of generators, which is the same in every ring over a field.
pub(crate) fn generator_monomial(exponents: &[u32]) -> Monomial {
    let place = |(position, &exponent): (usize, &u32)| u128::from(exponent) << generator_shift(position);
    Monomial(exponents.iter().enumerate().map(place).sum())
}

fn low_word(value: u128) -> u32 {
    // The callers mask the value to at most MOST_BITS bits.
    value as u32
}

fn merge(a: &[Variable], b: &[Variable]) -> Vec<Variable> {
    let (mut i, mut j) = (0, 0);
    let mut merged = Vec::with_capacity(a.len() + b.len());
    while i < a.len() && j < b.len() {
        match a[i].cmp(&b[j]) {
            Ordering::Less => {
                merged.push(a[i].clone());
                i += 1;
            }
            Ordering::Greater => {
                merged.push(b[j].clone());
                j += 1;
            }
            Ordering::Equal => {
                merged.push(a[i].clone());
                i += 1;
                j += 1;
            }
        }
    }
    merged.extend_from_slice(&a[i..]);
    merged.extend_from_slice(&b[j..]);
    merged
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exponents_pack_and_unpack() {
        let names = ["u", "v", "w"];
        let ring = Ring::new(names.map(|name| Variable::new(0, name)), NumberField::rationals());
        let monomial = ring.monomial(&[3, 0, 524_287], &[]);
        assert_eq!(ring.exponents(monomial), [3, 0, 524_287]);
        assert_eq!(ring.quotient(monomial, ring.monomial(&[1, 1, 0], &[])), None);
        let quotient = ring.quotient(monomial, ring.monomial(&[1, 0, 7], &[]));
        assert_eq!(quotient, Some(ring.monomial(&[2, 0, 524_280], &[])));
    }

    #[test]
    fn monomials_are_written_in_other_rings() {
        let variable = |rank: u32| Variable::new(rank, "x");
        let root = crate::Poly::sqrt_of(&crate::integer(2));
        let small = Ring::new([variable(1), variable(4), variable(5)], root.ring().field().clone());
        let large = Ring::new((0..12).map(variable), root.ring().field().clone());
        let monomial = small.monomial(&[3, 0, 7], &[1]);
        let there = small.transfer(&large).monomial(monomial);
        assert_eq!(there, large.monomial(&[0, 3, 0, 0, 0, 7, 0, 0, 0, 0, 0, 0], &[1]));
        assert_eq!(large.transfer(&small).monomial(there), monomial);
        let narrow =
            budget::with_budget(1, || small.transfer(&large).monomial(small.monomial(&[0, 512, 0], &[0])));
        assert!(narrow.unwrap_err().to_string().contains("beyond 511"));
    }

    #[test]
    fn too_large_exponents_are_refused() {
        let error = budget::with_budget(1, || {
            let ring = Ring::new([Variable::new(0, "u")], NumberField::rationals());
            ring.monomial(&[600_000], &[])
        });
        assert!(error.unwrap_err().to_string().contains("beyond 524287"));
    }
}
