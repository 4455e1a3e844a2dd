//! Sparse polynomials in several variables over a number field.

pub(crate) mod arithmetic;
pub(crate) mod boxes;
pub(crate) mod display;
pub(crate) mod division;
pub(crate) mod evaluation;
pub(crate) mod gcd;
pub(crate) mod images;
pub(crate) mod perfect_square;
pub(crate) mod product;
pub(crate) mod quotient;
pub(crate) mod reduction;
pub(crate) mod resultant;
pub(crate) mod ring;
pub(crate) mod squarefree;
pub(crate) mod substitute;
pub(crate) mod terms;

use std::borrow::Cow;
use std::sync::Arc;

use num_integer::Integer;
use num_traits::{One, Signed, Zero};

use crate::number::field::{self, NumberField};
use crate::{Int, Rational, rational_gcd};
pub use perfect_square::SquareSplit;
pub use ring::{Monomial, Ring, Variable};
pub use squarefree::Squarefree;

/// One term of the primitive part of a [`Poly`].
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub struct Term {
    /// The exponents, to be read through the polynomial's ring.
    pub monomial: Monomial,
    /// The coefficient, which is not zero.
    pub coefficient: Int,
}

/// A sparse polynomial in several variables, with coefficients in a number field.
///
/// It is the product of a rational *content* and a primitive sum of terms with integer coefficients. The terms stand in
/// lexicographically descending order, their coefficients have no common divisor and the first one is positive, so
/// every polynomial has one representation. The generators of the number field are symbols like the variables, with the
/// rule `g² = r` applied throughout: no exponent of a generator exceeds 1.
///
/// Polynomials of different rings combine in the smallest ring that holds both, so `u + √2` needs no ceremony. A number
/// of the field is a polynomial without variables.
///
/// # Example
/// ```
/// use hodograph_algebra::{Poly, Variable, integer};
/// let (u, v) = (Poly::variable(&Variable::new(0, "u")), Poly::variable(&Variable::new(1, "v")));
/// let f = (&u + &v).pow(2);
/// assert_eq!(f.to_string(), "u^2 + 2*u*v + v^2");
/// assert_eq!(f.exact_div(&(&u + &v)), Some(u + v));
/// let root = Poly::sqrt_of(&integer(2));
/// assert_eq!((&root * &root).to_string(), "2");
/// ```
#[derive(Clone)]
pub struct Poly {
    ring: Arc<Ring>,
    content: Rational,
    terms: Vec<Term>,
}

impl Poly {
    /// Zero.
    #[must_use]
    pub fn zero() -> Poly {
        Poly { ring: Ring::rationals(), content: Rational::zero(), terms: Vec::new() }
    }

    /// One.
    #[must_use]
    pub fn one() -> Poly {
        Poly::constant(Rational::one())
    }

    /// The constant polynomial `value`.
    #[must_use]
    pub fn constant(value: Rational) -> Poly {
        Poly::constant_in(Ring::rationals(), value)
    }

    /// The integer `value`.
    #[must_use]
    pub fn integer(value: i64) -> Poly {
        Poly::constant(crate::integer(value))
    }

    /// The polynomial `variable`.
    #[must_use]
    pub fn variable(variable: &Variable) -> Poly {
        let ring = Ring::new([variable.clone()], NumberField::rationals());
        let monomial = ring.monomial(&[1], &[]);
        Poly { ring, content: Rational::one(), terms: vec![Term { monomial, coefficient: Int::ONE }] }
    }

    /// The generator at `position` of `field`, as a polynomial without variables.
    #[must_use]
    pub fn generator(field: &Arc<NumberField>, position: usize) -> Poly {
        let ring = Ring::new([], field.clone());
        let monomial = Monomial(ring.generator_word(position));
        Poly { ring, content: Rational::one(), terms: vec![Term { monomial, coefficient: Int::ONE }] }
    }

    /// The nonnegative square root of the rational `value ≥ 0`, as a number of a field that has it.
    ///
    /// # Panics
    /// If `value` is negative.
    #[must_use]
    pub fn sqrt_of(value: &Rational) -> Poly {
        assert!(!value.is_negative(), "the square root of a negative rational is not real");
        let (root, rest) = crate::square_part(value);
        if rest.is_one() {
            return Poly::constant(root);
        }
        let field = field::adjoin(&NumberField::rationals(), &Poly::constant(rest.into()));
        Poly::generator(&field, field.generators().len() - 1).scale(&root)
    }

    pub(crate) fn constant_in(ring: Arc<Ring>, value: Rational) -> Poly {
        if value.is_zero() {
            return Poly { ring, content: value, terms: Vec::new() };
        }
        Poly { ring, content: value, terms: vec![Term { monomial: Monomial::ONE, coefficient: Int::ONE }] }
    }

    /// The polynomial `content · Σ terms` for terms that are sorted, distinct, nonzero and reduced, but may have a
    /// common divisor.
    pub(crate) fn from_sorted(ring: Arc<Ring>, content: Rational, mut terms: Vec<Term>) -> Poly {
        if terms.is_empty() || content.is_zero() {
            return Poly { ring, content: Rational::zero(), terms: Vec::new() };
        }
        let mut divisor = Int::ZERO;
        for term in &terms {
            divisor = divisor.gcd(&term.coefficient);
            if divisor.is_one() {
                break;
            }
        }
        if terms[0].coefficient.is_negative() {
            divisor = -divisor;
        }
        if divisor.is_one() {
            return Poly { ring, content, terms };
        }
        for term in &mut terms {
            term.coefficient /= &divisor;
        }
        Poly { ring, content: content * Rational::from(divisor), terms }
    }

    /// The ring that it is represented in; it may have variables that do not occur.
    #[must_use]
    pub fn ring(&self) -> &Arc<Ring> {
        &self.ring
    }

    /// The rational content: the polynomial is `content · Σ terms`. Zero for the zero polynomial.
    #[must_use]
    pub fn content(&self) -> &Rational {
        &self.content
    }

    /// The terms of the primitive part, in descending order.
    #[must_use]
    pub fn terms(&self) -> &[Term] {
        &self.terms
    }

    /// The primitive part: integer coefficients without common divisor, the first one positive; zero for zero.
    #[must_use]
    pub fn primitive(&self) -> Poly {
        if self.is_zero() {
            return self.clone();
        }
        Poly { content: Rational::one(), ..self.clone() }
    }

    /// Whether it is the zero polynomial.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Whether it is the polynomial 1.
    #[must_use]
    pub fn is_one(&self) -> bool {
        self.to_rational().is_some_and(|value| value.is_one())
    }

    /// Whether no variable occurs, so that it is a number of the field.
    #[must_use]
    pub fn is_constant(&self) -> bool {
        self.terms.iter().all(|term| self.ring.variable_part(term.monomial) == Monomial::ONE)
    }

    /// Its value, if it is a rational number.
    #[must_use]
    pub fn to_rational(&self) -> Option<Rational> {
        match self.terms.as_slice() {
            [] => Some(Rational::zero()),
            [term] if term.monomial == Monomial::ONE => Some(self.content.clone()),
            _ => None,
        }
    }

    /// The number of monomials in the variables (terms that differ in generators alone count once).
    #[must_use]
    pub fn monomial_count(&self) -> usize {
        let mut count = 0;
        let mut last = None;
        for term in &self.terms {
            let part = self.ring.variable_part(term.monomial);
            if last != Some(part) {
                count += 1;
                last = Some(part);
            }
        }
        count
    }

    /// The degree in `variable`; `None` for the zero polynomial.
    #[must_use]
    pub fn degree(&self, variable: &Variable) -> Option<u32> {
        let first = self.terms.first()?;
        let degree = |position| match position {
            // The first variable decides the order of terms.
            0 => self.ring.exponent(first.monomial, 0),
            _ => self.terms.iter().map(|term| self.ring.exponent(term.monomial, position)).max().unwrap_or(0),
        };
        Some(self.ring.position(variable).map_or(0, degree))
    }

    /// The degrees in all variables of the ring.
    pub(crate) fn degrees(&self) -> Vec<u32> {
        self.ring.exponents(Monomial(terms::maximum(&self.ring, &self.terms)))
    }

    /// Whether `variable` occurs.
    #[must_use]
    pub fn contains(&self, variable: &Variable) -> bool {
        self.degree(variable).unwrap_or(0) > 0
    }

    /// The variables that occur, in their order.
    #[must_use]
    pub fn occurring_variables(&self) -> Vec<Variable> {
        let union = self.terms.iter().fold(0, |union, term| union | term.monomial.0);
        let ring = &self.ring;
        let occurs = |&i: &usize| ring.exponent(Monomial(union), i) > 0;
        (0..ring.variables().len()).filter(occurs).map(|i| ring.variables()[i].clone()).collect()
    }

    /// Whether the representation is canonical, as described at [`Poly`].
    #[must_use]
    pub fn is_valid(&self) -> bool {
        if self.terms.is_empty() {
            return self.content.is_zero();
        }
        let sorted = self.terms.windows(2).all(|pair| pair[0].monomial > pair[1].monomial);
        let reduced = self
            .terms
            .iter()
            .all(|term| self.ring.generator_exponents(term.monomial).iter().all(|&exponent| exponent <= 1));
        let divisor = self.terms.iter().fold(Int::ZERO, |g, term| g.gcd(&term.coefficient));
        sorted
            && reduced
            && divisor.is_one()
            && self.terms[0].coefficient.is_positive()
            && self.terms.iter().all(|term| !term.coefficient.is_zero() && term.coefficient.is_valid())
            && !self.content.is_zero()
    }

    /// The positive greatest rational that divides all coefficients of all `polys`; zero if all are zero.
    #[must_use]
    pub fn common_content(polys: &[Poly]) -> Rational {
        polys.iter().fold(Rational::zero(), |g, poly| rational_gcd(&g, &poly.content))
    }

    /// The same polynomial in the ring `to`, which must have all variables that occur, over a field that begins with
    /// this one.
    pub(crate) fn transfer(&self, to: &Arc<Ring>) -> Poly {
        if Arc::ptr_eq(&self.ring, to) || self.ring == *to {
            return Poly { ring: to.clone(), ..self.clone() };
        }
        let transfer = self.ring.transfer(to);
        // The order of variables is the same in every ring, so the terms stay sorted.
        let mut terms = Vec::with_capacity(self.terms.len());
        for term in &self.terms {
            let monomial = transfer.monomial(term.monomial);
            terms.push(Term { monomial, coefficient: term.coefficient.clone() });
        }
        Poly { ring: to.clone(), content: self.content.clone(), terms }
    }

    /// Whether the primitive parts of polynomials over the same field have the same coefficients, in the order of terms.
    fn same_coefficients(&self, other: &Poly) -> bool {
        let (a, b) = (self.terms.as_slice(), other.terms.as_slice());
        if a.len() != b.len() {
            return false;
        }
        let mut i = 0;
        while i < a.len() && a[i].coefficient == b[i].coefficient {
            i += 1;
        }
        i == a.len()
    }

    /// Whether nonzero polynomials have the same degrees, and as many monomials in the variables.
    fn same_shape(&self, other: &Poly) -> bool {
        let mut variables = self.ring.variables().iter().chain(other.ring.variables());
        variables.all(|variable| self.degree(variable) == other.degree(variable))
            && self.monomial_count() == other.monomial_count()
    }

    /// Whether the same monomials in the variables occur, with the same coefficients if the field is the same, as far as
    /// that is seen without a common ring.
    fn may_equal(&self, other: &Poly) -> bool {
        if self.ring.field() == other.ring.field()
            && (self.content != other.content || !self.same_coefficients(other))
        {
            return false;
        }
        if self.ring.variables() != other.ring.variables() {
            return true;
        }
        let (own, others) = (self.groups(), other.groups());
        let same = |(&i, &j): (&usize, &usize)| {
            self.ring.exponents(self.terms[i].monomial) == other.ring.exponents(other.terms[j].monomial)
        };
        own.len() == others.len() && own.iter().zip(&others).all(same)
    }

    /// Both polynomials in one ring: copies of those only that are written in another one.
    pub(crate) fn unify<'a>(a: &'a Poly, b: &'a Poly) -> (Cow<'a, Poly>, Cow<'a, Poly>) {
        if Arc::ptr_eq(&a.ring, &b.ring) || a.ring == b.ring {
            return (Cow::Borrowed(a), Cow::Borrowed(b));
        }
        let (field, renamed) = field::join(a.ring.field(), b.ring.field());
        let b = match renamed {
            None => Cow::Borrowed(b),
            Some(images) => Cow::Owned(b.map_generators(&field, &images)),
        };
        let ring = Ring::union(&a.ring, &b.ring, &field);
        let within = |poly: Cow<'a, Poly>| {
            if *poly.ring == *ring { poly } else { Cow::Owned(poly.transfer(&ring)) }
        };
        (within(Cow::Borrowed(a)), within(b))
    }
}

impl PartialEq for Poly {
    fn eq(&self, other: &Poly) -> bool {
        if Arc::ptr_eq(&self.ring, &other.ring) || self.ring == other.ring {
            return self.content == other.content && self.terms == other.terms;
        }
        if !self.may_equal(other) {
            return false;
        }
        let (a, b) = Poly::unify(self, other);
        a.content == b.content && a.terms == b.terms
    }
}

impl Eq for Poly {}
