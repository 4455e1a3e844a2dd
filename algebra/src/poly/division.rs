//! Exact division.

use std::sync::Arc;

use num_integer::Integer;
use num_traits::{One, Zero};

use super::ring::{Monomial, Ring, Variable};
use super::{Poly, Term, quotient};
use crate::modular::heap::{NextProduct, ProductHeap};
use crate::{Int, Rational, budget};

/// Over a number field, from this many products of terms on, a quotient is found by its images modulo primes; below, by
/// taking off terms, which costs less to set up.
const MODULAR_FROM: usize = 500;

impl Poly {
    /// The quotient `self / divisor`, if that is a polynomial.
    ///
    /// Over the rationals the primitive parts are divided over the integers, which is enough by Gauss's lemma. Over a
    /// number field the divisor is first made monic; from a certain size on, images modulo primes are divided instead. The
    /// terms of the quotient are found from the largest down; the first that cannot be one ends the attempt. Complexity:
    /// one step in a heap for each product of a term of the quotient and one of the divisor.
    ///
    /// # Panics
    /// If `divisor` is zero.
    #[must_use]
    pub fn exact_div(&self, divisor: &Poly) -> Option<Poly> {
        assert!(!divisor.is_zero(), "division by the zero polynomial");
        if self.is_zero() {
            return Some(Poly::zero());
        }
        if let Some(value) = divisor.to_rational() {
            return Some(self.scale(&value.recip()));
        }
        if self.ring.field() == divisor.ring.field() && !self.may_divide(divisor) {
            return None;
        }
        let (a, b) = Poly::unify(self, divisor);
        let bounds = quotient_degrees(&a, &b)?;
        if a.ring.field().generators().is_empty() {
            let quotient = divide(&a.ring, &a.terms, &b.terms, &bounds)?;
            return Some(Poly::from_sorted(a.ring.clone(), &a.content / &b.content, quotient));
        }
        if a.terms.len() * b.terms.len() > MODULAR_FROM {
            return quotient::modular_quotient(&a, &b);
        }
        // b = c·m with m monic over the field, so a/b = (a/m)/c.
        let inverse = b.leading_coefficient().inverse();
        let monic = (&*b * &inverse).transfer_to(&a.ring);
        let quotient = divide_monic(&a.ring, &a, &monic, &bounds)?;
        Some(quotient * inverse)
    }

    /// Whether a nonzero divisor over the same field may divide, as far as degrees and, over the rationals, the first and the
    /// last coefficients of the primitive parts tell.
    fn may_divide(&self, divisor: &Poly) -> bool {
        if self.ring.field().generators().is_empty() {
            let ends =
                [(self.terms.first(), divisor.terms.first()), (self.terms.last(), divisor.terms.last())];
            let divides = |end: &(Option<&Term>, Option<&Term>)| match end {
                (Some(a), Some(b)) => b.coefficient.is_one() || a.coefficient.is_multiple_of(&b.coefficient),
                _ => true,
            };
            if !ends.iter().all(divides) {
                return false;
            }
        }
        let own = self.degrees();
        let at_least = |(variable, degree): (&Variable, u32)| {
            degree == 0 || self.ring.position(variable).is_some_and(|position| own[position] >= degree)
        };
        divisor.ring.variables().iter().zip(divisor.degrees()).all(at_least)
    }

    /// Whether `self` divides `other`; zero divides only zero.
    #[must_use]
    pub fn divides(&self, other: &Poly) -> bool {
        if self.is_zero() { other.is_zero() } else { other.exact_div(self).is_some() }
    }

    /// Divides by `divisor` as often as that goes: `(m, q)` with `self = divisor^m · q`. For constants `(0, self)`.
    #[must_use]
    pub fn take_out(&self, divisor: &Poly) -> (u32, Poly) {
        let mut rest = self.clone();
        let mut multiplicity = 0;
        if divisor.is_constant() || self.is_zero() {
            return (0, rest);
        }
        while let Some(quotient) = rest.exact_div(divisor) {
            rest = quotient;
            multiplicity += 1;
        }
        (multiplicity, rest)
    }

    /// The coefficient, in the field, of the lexicographically largest monomial in the variables; zero for zero.
    #[must_use]
    pub fn leading_coefficient(&self) -> Poly {
        let Some(first) = self.terms.first() else { return Poly::zero() };
        let leading = self.ring.variable_part(first.monomial);
        let terms: Vec<Term> = self
            .terms
            .iter()
            .take_while(|term| self.ring.variable_part(term.monomial) == leading)
            .map(|term| Term { monomial: self.ring.generator_part(term.monomial), ..term.clone() })
            .collect();
        Poly::from_sorted(self.ring.clone(), self.content.clone(), terms)
    }

    /// `self` divided by its leading coefficient (see [`Poly::leading_coefficient`]); zero for zero.
    #[must_use]
    pub fn monic(&self) -> Poly {
        if self.is_zero() { self.clone() } else { self * self.leading_coefficient().inverse() }
    }

    /// The representative of all nonzero multiples by numbers of the field that has a rational leading coefficient, and
    /// content 1.
    ///
    /// It is what gcds and factors are normalized to, so that equal factors compare equal.
    #[must_use]
    pub fn normalized(&self) -> Poly {
        if self.ring.field().generators().is_empty() || self.leading_coefficient().to_rational().is_some() {
            return self.primitive();
        }
        self.monic().primitive()
    }

    /// The number `c` with `self = c·divisor`, if there is one; `None` if `divisor` is zero.
    ///
    /// Most polynomials that are no multiples of each other are told apart by their monomials, or by the first and the last
    /// coefficient; the others cost two products with a number.
    ///
    /// ```
    /// use hodograph_algebra::{Poly, Variable, integer};
    /// let (u, root) = (Poly::variable(&Variable::new(0, "u")), Poly::sqrt_of(&integer(2)));
    /// let f = &u + &root;
    /// assert_eq!((&u * &root + Poly::integer(2)).number_quotient(&f), Some(root));
    /// assert_eq!(f.number_quotient(&u), None);
    /// ```
    #[must_use]
    pub fn number_quotient(&self, divisor: &Poly) -> Option<Poly> {
        if divisor.is_zero() {
            return None;
        }
        if self.is_zero() {
            return Some(Poly::zero());
        }
        let rational =
            self.ring.field().generators().is_empty() && divisor.ring.field().generators().is_empty();
        let alike = if rational { self.same_coefficients(divisor) } else { self.same_shape(divisor) };
        if !alike {
            return None;
        }
        let (a, b) = Poly::unify(self, divisor);
        if a.terms == b.terms {
            return Some(Poly::constant(&a.content / &b.content));
        }
        if rational {
            return None;
        }
        let (a_groups, b_groups) = (a.groups(), b.groups());
        let monomial = |poly: &Poly, place: usize| poly.ring.variable_part(poly.terms[place].monomial);
        let same = |(&i, &j): (&usize, &usize)| monomial(&a, i) == monomial(&b, j);
        if a_groups.len() != b_groups.len() || !a_groups.iter().zip(&b_groups).all(same) {
            return None;
        }
        let coefficients = |poly: &Poly, groups: &[usize]| {
            let last = poly.terms[groups[groups.len() - 1]..].to_vec();
            let last = last.into_iter().map(|t| Term { monomial: poly.ring.generator_part(t.monomial), ..t });
            (
                poly.leading_coefficient(),
                Poly::from_sorted(poly.ring.clone(), poly.content.clone(), last.collect()),
            )
        };
        let ((a_first, a_last), (b_first, b_last)) =
            (coefficients(&a, &a_groups), coefficients(&b, &b_groups));
        let proportional = &a_first * &b_last == &b_first * &a_last && &*a * &b_first == &*b * &a_first;
        proportional.then(|| a_first * b_first.inverse())
    }

    /// The places where the terms of each monomial in the variables begin.
    pub(crate) fn groups(&self) -> Vec<usize> {
        let mut groups = Vec::new();
        let mut last = None;
        for (place, term) in self.terms.iter().enumerate() {
            let monomial = self.ring.variable_part(term.monomial);
            if last != Some(monomial) {
                groups.push(place);
                last = Some(monomial);
            }
        }
        groups
    }

    pub(crate) fn transfer_to(&self, ring: &Arc<Ring>) -> Poly {
        if *self.ring == **ring { Poly { ring: ring.clone(), ..self.clone() } } else { self.transfer(ring) }
    }
}

/// The degrees of `a/b` in each variable, unless one would be negative.
fn quotient_degrees(a: &Poly, b: &Poly) -> Option<Vec<u32>> {
    a.degrees().into_iter().zip(b.degrees()).map(|(a, b)| a.checked_sub(b)).collect()
}

fn within(ring: &Ring, monomial: Monomial, bounds: &[u32]) -> bool {
    bounds.iter().enumerate().all(|(i, &bound)| ring.exponent(monomial, i) <= bound)
}

/// The quotient over the integers, by a heap of the products that are to be taken off next (Johnson, *Sparse polynomial
/// arithmetic*, 1974): one product of each term of the divisor waits in it at a time.
fn divide(ring: &Ring, a: &[Term], b: &[Term], bounds: &[u32]) -> Option<Vec<Term>> {
    let (leading, tail) = b.split_first()?;
    // The smallest terms must divide as well: a cheap test that most failures do not pass.
    let (last_a, last_b) = (a.last()?, b.last()?);
    ring.quotient(last_a.monomial, last_b.monomial)?;
    if !last_a.coefficient.is_multiple_of(&last_b.coefficient) {
        return None;
    }
    let mut quotient: Vec<Term> = Vec::new();
    let mut heap = ProductHeap::default();
    // Terms of the tail whose next partner is not known yet.
    let mut waiting: Vec<usize> = (0..tail.len()).collect();
    let mut own = 0;
    loop {
        let next = a.get(own).map(|term| term.monomial.0).max(heap.top().map(|product| product.word));
        let Some(word) = next else { return Some(quotient) };
        let mut coefficient = Int::ZERO;
        if let Some(term) = a.get(own).filter(|term| term.monomial.0 == word) {
            coefficient = term.coefficient.clone();
            own += 1;
        }
        while let Some(product) = heap.top_at(word) {
            let NextProduct { divisor: j, quotient: i, .. } = product;
            coefficient -= &tail[j].coefficient * &quotient[i].coefficient;
            if let Some(partner) = quotient.get(i + 1) {
                let word = tail[j].monomial.0 + partner.monomial.0;
                heap.replace_top(NextProduct { word, divisor: j, quotient: i + 1 });
            } else {
                heap.pop();
                waiting.push(j);
            }
        }
        if coefficient.is_zero() {
            continue;
        }
        budget::spend(4 * b.len() as u64);
        let monomial =
            ring.quotient(Monomial(word), leading.monomial).filter(|&m| within(ring, m, bounds))?;
        let (factor, remainder) = coefficient.div_rem(&leading.coefficient);
        if !remainder.is_zero() {
            return None;
        }
        for j in waiting.drain(..) {
            let word = tail[j].monomial.0 + monomial.0;
            heap.push(NextProduct { word, divisor: j, quotient: quotient.len() });
        }
        quotient.push(Term { monomial, coefficient: factor });
    }
}

/// The quotient by a divisor with the leading coefficient 1, of which each step takes off one monomial in the variables with its
/// coefficient in the field.
fn divide_monic(ring: &Arc<Ring>, a: &Poly, b: &Poly, bounds: &[u32]) -> Option<Poly> {
    let leading = ring.variable_part(b.terms.first()?.monomial);
    // The smallest monomials must divide as well.
    let smallest = |poly: &Poly| poly.terms.last().map(|term| ring.variable_part(term.monomial));
    ring.quotient(smallest(a)?, smallest(b)?)?;
    let mut rest = a.transfer_to(ring);
    let mut quotient: Vec<(Monomial, Rational)> = Vec::new();
    while let Some(first) = rest.terms.first() {
        budget::spend(16 * b.terms.len() as u64);
        let monomial = ring
            .quotient(ring.variable_part(first.monomial), leading)
            .filter(|&m| within(ring, m, bounds))?;
        let mut step = rest.leading_coefficient();
        for term in &mut step.terms {
            term.monomial = Monomial(term.monomial.0 | monomial.0);
        }
        let scaled = |term: &Term| (term.monomial, &step.content * Rational::from(term.coefficient.clone()));
        quotient.extend(step.terms.iter().map(scaled));
        rest -= step * b;
    }
    Some(Poly::from_rational_terms(ring.clone(), quotient))
}

impl Poly {
    /// The polynomial with the given rational coefficients of distinct reduced monomials.
    pub(crate) fn from_rational_terms(ring: Arc<Ring>, mut coefficients: Vec<(Monomial, Rational)>) -> Poly {
        coefficients.retain(|(_, value)| !value.is_zero());
        coefficients.sort_by_key(|(monomial, _)| std::cmp::Reverse(*monomial));
        let denominator = coefficients.iter().fold(Int::ONE, |d, (_, value)| d.lcm(value.denom()));
        let terms = coefficients
            .into_iter()
            .map(|(monomial, value)| {
                let coefficient = value.numer() * (&denominator / value.denom());
                Term { monomial, coefficient }
            })
            .collect();
        Poly::from_sorted(ring, Rational::new(Int::one(), denominator), terms)
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use proptest::prelude::*;

    use super::*;
    use crate::{Variable, ratio};

    /// The division that takes all products off a map of the remainder at once.
    fn naive_quotient(a: &Poly, b: &Poly) -> Option<Poly> {
        if a.is_zero() {
            return Some(Poly::zero());
        }
        let ring = &a.ring;
        let bounds = quotient_degrees(a, b)?;
        let mut rest: BTreeMap<Monomial, Rational> =
            a.terms.iter().map(|term| (term.monomial, Rational::from(term.coefficient.clone()))).collect();
        let mut quotient = Vec::new();
        while let Some((monomial, coefficient)) = rest.pop_last() {
            if coefficient.is_zero() {
                continue;
            }
            let monomial =
                ring.quotient(monomial, b.terms[0].monomial).filter(|&m| within(ring, m, &bounds))?;
            let factor = coefficient / Rational::from(b.terms[0].coefficient.clone());
            for term in &b.terms[1..] {
                let entry = rest.entry(Monomial(monomial.0 + term.monomial.0)).or_insert_with(Rational::zero);
                *entry -= &factor * Rational::from(term.coefficient.clone());
            }
            quotient.push((monomial, factor));
        }
        Some(Poly::from_rational_terms(ring.clone(), quotient).scale(&(&a.content / &b.content)))
    }

    fn polynomials(terms: usize) -> impl Strategy<Value = Poly> {
        prop::collection::vec((0_u32..4, 0_u32..4, 0_u32..3, -9_i64..=9), 1..=terms).prop_map(|terms| {
            let [u, v, a] =
                [(0, "u"), (1, "v"), (Variable::SYMBOL, "a")].map(|(rank, name)| Variable::new(rank, name));
            let ring = Ring::new([u, v, a], crate::NumberField::rationals());
            let term =
                |(i, j, k, value): (u32, u32, u32, i64)| (ring.monomial(&[i, j, k], &[]), ratio(value, 3));
            let distinct: BTreeMap<Monomial, Rational> = terms.into_iter().map(term).collect();
            Poly::from_rational_terms(ring.clone(), distinct.into_iter().collect())
        })
    }

    proptest! {
        #[test]
        fn quotients_agree_with_the_naive_division(a in polynomials(8), b in polynomials(8), r in polynomials(2)) {
            prop_assume!(!b.is_zero());
            let exact = (&a * &b).transfer_to(&b.ring);
            for dividend in [exact.clone(), exact + r] {
                prop_assert_eq!(dividend.exact_div(&b), naive_quotient(&dividend, &b));
            }
        }

        #[test]
        fn multiples_by_numbers_are_found(a in polynomials(6), b in polynomials(6), m in 1_i64..5, n in -5_i64..5) {
            let root = Poly::sqrt_of(&ratio(2, 1));
            let f = &a + &b * &root;
            prop_assume!(!f.is_zero());
            let number = Poly::integer(m) + root.scale(&ratio(n, 2));
            let multiple = &f * &number;
            prop_assert_eq!(multiple.number_quotient(&f), Some(number));
            let other = &multiple + &b;
            let quotient = other.number_quotient(&f);
            let expected = other.exact_div(&f).filter(Poly::is_constant);
            prop_assert_eq!(quotient, expected);
        }
    }
}
