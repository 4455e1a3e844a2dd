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
/// neighbors. The product of monomials is the sum of words, and the highest bit of each exponent, which is a guard, tells
/// quotients and excess (Bachmann and Schönemann, *Monomial representations for Gröbner bases computations*, 1998). The
/// exponents are read through [`Ring::exponent`].
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
const LEAST_BITS: u32 = 4;
/// Bits of the exponent of each parameter where there are so many symbols that equal widths would give fewer: the degree of a
/// sweep in its parameters grows with that of its curves, its degree in each symbol does not.
const PARAMETER_BITS: u32 = 9;

/// The ring `K[x₁, …, xₙ]` over a [`NumberField`] `K`, whose generators are further symbols with rules `g² = r`.
///
/// Rings are shared by reference counting and grow on demand: an operation on polynomials of different rings takes
/// place in the smallest ring that holds both.
#[derive(Debug)]
pub struct Ring {
    variables: Vec<Variable>,
    field: Arc<NumberField>,
    /// How many of the variables, the first ones, are parameters and not symbols.
    parameters: usize,
    /// Bits of the exponent of each parameter and of each symbol, of which the highest is the guard.
    bits: [u32; 2],
    /// The guard bits of all parameters and of all symbols.
    guards: [u128; 2],
    /// The position of the lowest bit above all exponents of symbols, and above those of generators.
    shifts: [u32; 2],
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
        let parameters = variables.partition_point(|variable| variable.rank < Variable::SYMBOL);
        let bits = exponent_bits(128_u32.saturating_sub(generator_bits), parameters as u32, count);
        if bits[1] < LEAST_BITS || generator_bits > 64 {
            budget::refuse(format!(
                "{count} symbols and {} square roots are more than one polynomial can hold",
                field.generators().len()
            ));
        }
        let symbols = count - parameters as u32;
        let shifts = [generator_bits + bits[1] * symbols, generator_bits];
        let guards = |kind: usize, count: u32| -> u128 {
            (1..=count).map(|i| 1_u128 << (shifts[kind] + bits[kind] * i - 1)).sum()
        };
        let guards = [guards(0, parameters as u32), guards(1, symbols)];
        Arc::new(Ring { variables, field, parameters, bits, guards, shifts })
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
        low_word(monomial.0 >> self.shift(position) & self.low_mask(position))
    }

    /// The exponent in `monomial` of the generator at `position` of the field.
    #[must_use]
    pub fn generator_exponent(&self, monomial: Monomial, position: usize) -> u32 {
        let mask = (1_u128 << GENERATOR_BITS) - 1;
        low_word(monomial.0 >> generator_shift(position) & mask)
    }

    /// The largest exponent that every variable can have; parameters of many symbols can have larger ones.
    #[must_use]
    pub fn max_exponent(&self) -> u32 {
        self.limit(1)
    }

    /// The monomial with the given exponents of the variables and generators, in their order.
    ///
    /// Leaves the computation (see [`budget`]) if an exponent is beyond the range of its variable, see [`Ring::max_exponent`].
    #[must_use]
    pub fn monomial(&self, exponents: &[u32], generators: &[u32]) -> Monomial {
        let mut word = generator_monomial(generators).0;
        for (position, &exponent) in exponents.iter().enumerate() {
            if exponent > self.limit(self.kind(position)) {
                self.refuse_exponent(self.kind(position));
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
        let guards = self.guards[0] | self.guards[1];
        let difference = (monomial.0 | guards).wrapping_sub(divisor.0);
        (difference & guards == guards).then_some(Monomial(difference & !guards))
    }

    /// Leaves the computation if `combined`, the union of the words of a result, shows an exponent beyond the range.
    pub(crate) fn check_exponents(&self, combined: u128) {
        for (kind, guards) in self.guards.into_iter().enumerate() {
            if combined & guards != 0 {
                self.refuse_exponent(kind);
            }
        }
    }

    /// The larger exponent of each variable and generator, of words without excess.
    pub(crate) fn maximum(&self, a: u128, b: u128) -> u128 {
        // A guard bit survives where the exponent of a is not smaller, and becomes a mask of that exponent's other bits.
        let [parameters, symbols] = self.guards;
        let kept = (a | parameters | symbols) - (b & !self.generator_mask());
        let [first, second] = [kept & parameters, kept & symbols];
        let mask = (first | second) - (first >> (self.bits[0] - 1)) - (second >> (self.bits[1] - 1));
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
        let variables = (0..self.variables.len()).map(|i| (self.shift(i), self.low_mask(i)));
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

    /// Whether the variable at `position` is a parameter, 0, or a symbol, 1.
    fn kind(&self, position: usize) -> usize {
        usize::from(position >= self.parameters)
    }

    fn shift(&self, position: usize) -> u32 {
        let kind = self.kind(position);
        let end = if kind == 0 { self.parameters } else { self.variables.len() };
        // Positions are below 128/LEAST_BITS.
        self.shifts[kind] + self.bits[kind] * (end - 1 - position) as u32
    }

    /// The bits of the exponent of the variable at `position`, shifted down.
    fn low_mask(&self, position: usize) -> u128 {
        (1 << self.bits[self.kind(position)]) - 1
    }

    /// The largest exponent of a parameter or of a symbol.
    fn limit(&self, kind: usize) -> u32 {
        (1 << (self.bits[kind] - 1)) - 1
    }

    fn refuse_exponent(&self, kind: usize) -> ! {
        budget::refuse(format!(
            "a polynomial in {} symbols would reach an exponent beyond {}",
            self.variables.len(),
            self.limit(kind)
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
        self.low_mask(position) << self.shift(position)
    }

    /// How the monomials of this ring are written in the ring `to`, which has this field's generators first among its own;
    /// variables that it does not have must not occur.
    pub(crate) fn transfer<'a>(&self, to: &'a Ring) -> Transfer<'a> {
        let (mut runs, mut excess): (Vec<(u128, u32, u32)>, [u128; 2]) = (Vec::new(), [0, 0]);
        let mut push = |mask: u128, from: u32, onto: u32| {
            // Neighbors that move by as many bits move together.
            match runs.last_mut().filter(|last| last.1 + onto == last.2 + from) {
                Some(last) => *last = (last.0 | mask, from, onto),
                None => runs.push((mask, from, onto)),
            }
        };
        for (position, variable) in self.variables.iter().enumerate() {
            let (mask, from) = (self.exponent_mask(position), self.shift(position));
            // A variable that the other ring lacks does not occur.
            let Some(target) = to.position(variable) else { continue };
            let kind = to.kind(target);
            excess[kind] |= mask & !(u128::from(to.limit(kind)) << from);
            push(mask, from, to.shift(target));
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
    /// The bits of exponents of parameters and of symbols that there is no room for.
    excess: [u128; 2],
}

impl Transfer<'_> {
    /// The monomial in the other ring. It leaves the computation if an exponent is beyond its range.
    pub(crate) fn monomial(&self, monomial: Monomial) -> Monomial {
        if monomial.0 & (self.excess[0] | self.excess[1]) != 0 {
            self.to.refuse_exponent(usize::from(monomial.0 & self.excess[0] == 0));
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

/// The bits of the exponent of each parameter and of each symbol, for `count` variables in a word of `room` bits.
fn exponent_bits(room: u32, parameters: u32, count: u32) -> [u32; 2] {
    let equal = (room / count.max(1)).min(MOST_BITS);
    let left = room.saturating_sub(PARAMETER_BITS * parameters) / (count - parameters).max(1);
    if equal + 1 >= PARAMETER_BITS || parameters == count || left < LEAST_BITS {
        return [equal; 2];
    }
    [PARAMETER_BITS, left.min(MOST_BITS)]
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
    use proptest::prelude::*;

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

    proptest! {
        #[test]
        fn words_agree_with_lists_of_exponents(
            count in 1_usize..9,
            lists in [prop::collection::vec(0_u32..40, 8), prop::collection::vec(0_u32..40, 8)],
            generators in [[0_u32..2, 0_u32..2], [0_u32..2, 0_u32..2]],
        ) {
            let field = (crate::Poly::sqrt_of(&crate::integer(2)) + crate::Poly::sqrt_of(&crate::integer(3))).ring().field().clone();
            // Every second variable of the larger ring.
            let ring = Ring::new((0..count as u32).map(|rank| Variable::new(2 * rank, "x")), field.clone());
            let large = Ring::new((0..2 * count as u32).map(|rank| Variable::new(rank, "x")), field);
            let [a, b] = lists.map(|list| list[..count].to_vec());
            let [x, y] = [(&a, generators[0]), (&b, generators[1])].map(|(list, own)| ring.monomial(list, &own));
            prop_assert_eq!((ring.exponents(x), ring.generator_exponents(x)), (a.clone(), generators[0].to_vec()));
            prop_assert_eq!(x.cmp(&y), a.cmp(&b).then(generators[0].iter().rev().cmp(generators[1].iter().rev())));
            let each = |f: fn(u32, u32) -> u32| a.iter().zip(&b).map(|(&i, &j)| f(i, j)).collect::<Vec<u32>>();
            let most = [0, 1].map(|i: usize| generators[0][i].max(generators[1][i]));
            prop_assert_eq!(ring.maximum(x.0, y.0), ring.monomial(&each(u32::max), &most).0);
            let divisor = ring.variable_part(y);
            let divides = a.iter().zip(&b).all(|(i, j)| i >= j);
            let quotient = ring.quotient(x, divisor);
            prop_assert_eq!(quotient, divides.then(|| ring.monomial(&each(u32::saturating_sub), &generators[0])));
            prop_assert_eq!(ring.variable_part(x).0 + divisor.0, ring.monomial(&each(|i, j| i + j), &[]).0);
            let there = ring.transfer(&large).monomial(x);
            let spread: Vec<u32> = a.iter().flat_map(|&exponent| [exponent, 0]).collect();
            prop_assert_eq!(there, large.monomial(&spread, &generators[0]));
            prop_assert_eq!(large.transfer(&ring).monomial(there), x);
        }
    }

    #[test]
    fn parameters_of_many_symbols_have_larger_exponents() {
        let variable = |i: u32| Variable::new(if i < 2 { i } else { Variable::SYMBOL }, &format!("x{i:02}"));
        let field = crate::Poly::sqrt_of(&crate::integer(2)).ring().field().clone();
        let [small, large] = [4, 24].map(|count| Ring::new((0..count).map(variable), field.clone()));
        let within = |ring: &Ring, list: &[u32]| {
            let mut exponents = list.to_vec();
            exponents.resize(ring.variables().len(), 0);
            ring.monomial(&exponents, &[1])
        };
        let word = within(&large, &[200, 3, 7, 5]);
        assert_eq!(small.transfer(&large).monomial(within(&small, &[200, 3, 7, 5])), word);
        assert_eq!(large.transfer(&small).monomial(word), within(&small, &[200, 3, 7, 5]));
        assert_eq!((large.max_exponent(), large.exponents(word)[..4].to_vec()), (7, vec![200, 3, 7, 5]));
        let other = within(&large, &[17, 255, 2, 6]);
        assert_eq!(large.maximum(word.0, other.0), within(&large, &[200, 255, 7, 6]).0);
        let divisor = large.variable_part(within(&large, &[1, 3, 7, 0]));
        assert_eq!(large.quotient(word, divisor), Some(within(&large, &[199, 0, 0, 5])));
        assert_eq!(large.quotient(other, divisor), None);
        for (exponents, text) in [([0, 256, 0, 0], "beyond 255"), ([0, 0, 0, 8], "beyond 7")] {
            let transferred = || small.transfer(&large).monomial(within(&small, &exponents));
            let error = budget::with_budget(1, transferred).unwrap_err();
            assert!(error.to_string().contains(text), "{error}");
            let error = budget::with_budget(1, || within(&large, &exponents)).unwrap_err();
            assert!(error.to_string().contains(text), "{error}");
        }
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
