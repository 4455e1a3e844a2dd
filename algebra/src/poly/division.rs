//! Exact division.

use std::sync::Arc;

use num_integer::Integer;
use num_traits::One;

use super::quotient::quotient;
use super::ring::{Ring, Variable};
use super::{Poly, Term};

impl Poly {
    /// The quotient `self / divisor`, if that is a polynomial.
    ///
    /// The terms of the quotient are found from the largest down; the first that cannot be one ends the attempt. Complexity:
    /// one product of coefficients for each pair of a term of the quotient and one of the divisor, and what it takes to sum
    /// these.
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
        quotient(&a, &b)
    }

    /// Whether a nonzero divisor over the same field may divide, as far as it is seen without a common ring: from the first and the
    /// last terms, or from the degrees.
    fn may_divide(&self, divisor: &Poly) -> bool {
        let ends = [(self.terms.first(), divisor.terms.first()), (self.terms.last(), divisor.terms.last())];
        let ends = ends.into_iter().filter_map(|(a, b)| a.zip(b));
        if self.ring.field().generators().is_empty() {
            let divides = |(a, b): (&Term, &Term)| {
                b.coefficient.is_one() || a.coefficient.is_multiple_of(&b.coefficient)
            };
            if !ends.clone().all(divides) {
                return false;
            }
        }
        let ring = &self.ring;
        if ring.variables() == divisor.ring.variables() {
            let part = |term: &Term| ring.variable_part(term.monomial);
            return ends.clone().all(|(a, b)| ring.quotient(part(a), part(b)).is_some());
        }
        let own = self.degrees();
        let at_least = |(variable, degree): (&Variable, u32)| {
            degree == 0 || ring.position(variable).is_some_and(|position| own[position] >= degree)
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

    /// Divides all of `polys` by `divisor` as often as that goes, at most `most` times, and gives the number of times. Short ones are
    /// tried first, since they fail sooner. Numbers are not taken out.
    pub(crate) fn take_out_of_all(polys: &mut [Poly], divisor: &Poly, most: u32) -> u32 {
        if divisor.is_constant() || polys.iter().all(Poly::is_zero) {
            return 0;
        }
        let mut order: Vec<usize> = (0..polys.len()).collect();
        order.sort_by_key(|&place| polys[place].terms.len());
        for times in 0..most {
            let quotients = order.iter().map(|&place| polys[place].exact_div(divisor));
            let Some(quotients) = quotients.collect::<Option<Vec<Poly>>>() else { return times };
            order.iter().zip(quotients).for_each(|(&place, quotient)| polys[place] = quotient);
        }
        most
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

#[cfg(test)]
impl Poly {
    /// The polynomial with the given rational coefficients of distinct reduced monomials.
    pub(crate) fn from_rational_terms(
        ring: Arc<Ring>,
        mut coefficients: Vec<(super::Monomial, crate::Rational)>,
    ) -> Poly {
        coefficients.retain(|(_, value)| *value.numer() != crate::Int::ZERO);
        coefficients.sort_by_key(|(monomial, _)| std::cmp::Reverse(*monomial));
        let denominator = coefficients.iter().fold(crate::Int::ONE, |d, (_, value)| d.lcm(value.denom()));
        let terms = coefficients.into_iter().map(|(monomial, value)| {
            let coefficient = value.numer() * (&denominator / value.denom());
            Term { monomial, coefficient }
        });
        let terms = terms.collect();
        Poly::from_sorted(ring, crate::Rational::new(crate::Int::ONE, denominator), terms)
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use proptest::prelude::*;

    use super::*;
    use crate::{Monomial, Rational, ratio};

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
