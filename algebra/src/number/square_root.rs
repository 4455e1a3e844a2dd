//! Square roots of numbers: in the number's own field where there is one, denested where that is possible, else adjoined.

use std::cmp::Ordering;
use std::sync::Arc;

use num_traits::Signed;

use super::algebraic::last_generator;
use super::field::{self, NumberField};
use crate::poly::{Poly, Ring};
use crate::{budget, ratio, rational_sqrt, square_part};

impl Poly {
    /// The nonnegative square root of a number, in its field or in a quadratic extension of it; `None` if the number is
    /// negative.
    ///
    /// The root is sought in the field first, by norms to the smaller fields of the tower; so equal numbers are recognized
    /// however they are written. What is no square there may have a multiple that is one: if `number·c` is a square in
    /// the field, `√number = √(number·c)·√c/c` needs only `√c`, and of all such `c` that norms lead to, one of the
    /// least nesting is taken. So nested radicals denest: `√(8300 + 1800√2)` is `90 + 10√2`, and `√(3 + √5)` is
    /// `(√10 + √2)/2` (Borodin, Fagin, Hopcroft and Tompa, *Decreasing the nesting depth of expressions involving square
    /// roots*, 1985).
    ///
    /// ```
    /// use hodograph_algebra::{Poly, integer};
    /// let root2 = Poly::sqrt_of(&integer(2));
    /// let nested = root2.scale(&integer(1800)) + Poly::integer(8300);
    /// assert_eq!(nested.sqrt().unwrap().to_string(), "10*sqrt2 + 90");
    /// ```
    ///
    /// # Panics
    /// If `self` has variables.
    #[must_use]
    pub fn sqrt(&self) -> Option<Poly> {
        if self.sign() == Ordering::Less { None } else { Some(adjoin_sqrt(self.ring().field(), self)) }
    }

    /// The nonnegative square root of a number, if it lies in the number's own field.
    #[must_use]
    pub fn sqrt_in_field(&self) -> Option<Poly> {
        let field = self.ring().field();
        let root = sqrt_below(self, field, field.generators().len())?;
        Some(if root.sign() == Ordering::Less { -root } else { root })
    }
}

/// A square root of `number` in the field of the first `count` generators, if there is one; its sign is arbitrary.
///
/// For `a + b·g` with `b ≠ 0` the root is `p + q·g` with `p² = (a ± s)/2` and `q = b/(2p)`, where `s² = a² − r·b²`;
/// each of `s` and `p` is sought in the next smaller field.
fn sqrt_below(number: &Poly, field: &Arc<NumberField>, count: usize) -> Option<Poly> {
    budget::spend(16);
    if let Some(value) = number.to_rational() {
        if value.is_negative() {
            return None;
        }
        if let Some(root) = rational_sqrt(&value) {
            return Some(Poly::constant(root));
        }
    }
    let last = count.checked_sub(1)?;
    if last_generator(number).is_none_or(|position| position < last) {
        // A square here is a square below, or the radicand times one.
        if let Some(root) = sqrt_below(number, field, last) {
            return Some(root);
        }
        let scaled = sqrt_below(&(number * field.radicand(last).inverse()), field, last)?;
        return Some(scaled * Poly::generator(field, last));
    }
    let (a, b) = split(number, last);
    let s = sqrt_below(&norm(number, last), field, last)?;
    for p_squared in [&a + &s, &a - &s] {
        let p_squared = p_squared.scale(&ratio(1, 2));
        if p_squared.is_zero() {
            continue;
        }
        if let Some(p) = sqrt_below(&p_squared, field, last) {
            let q = &b * p.scale(&crate::integer(2)).inverse();
            return Some(p + q * Poly::generator(field, last));
        }
    }
    None
}

/// The nonnegative square root of the nonnegative `number` of `field`, in that field or in an extension of it.
pub(crate) fn adjoin_sqrt(field: &Arc<NumberField>, number: &Poly) -> Poly {
    budget::doing("a square root in a number field", || {
        let number = number.transfer_to(&Ring::new([], field.clone()));
        let root = match number.sqrt_in_field() {
            Some(root) => root,
            None => denest(&number).unwrap_or_else(|| extend(field, &number)),
        };
        // The root is understood over the whole field, even where it does not need it.
        root.transfer_to(&Ring::new([], field::join(field, root.ring().field()).0))
    })
}

/// The root of a positive number that is no square in its field, over the root of a simpler one.
fn denest(number: &Poly) -> Option<Poly> {
    let field = number.ring().field();
    let mut simplest: Option<((usize, usize), Poly)> = None;
    let mut left = MOST_CLASSES;
    let count = field.generators().len();
    visit_class(number, field, count, 0, &mut left, &mut |candidate| {
        let complexity = complexity(candidate);
        if simplest.as_ref().is_none_or(|(least, _)| complexity < *least) {
            simplest = Some((complexity, candidate.clone()));
        }
        // Nothing is simpler than a rational number.
        complexity.0 == 0
    });
    let (least, factor) = simplest?;
    if least >= complexity(number) {
        return None;
    }
    // The root of the product, and that of the factor, which is positive like the number, are positive.
    let product = (number * &factor).sqrt_in_field()?;
    let root = extend(field, &factor);
    Some(product * root * factor.inverse())
}

/// How many candidates for the class of a number are looked at, at most.
const MOST_CLASSES: u32 = 128;

/// The depth of nesting of a number's generators, and how many of them occur.
fn complexity(number: &Poly) -> (usize, usize) {
    let ring = number.ring();
    let occurs = |i: &usize| number.terms().iter().any(|term| ring.generator_exponent(term.monomial, *i) > 0);
    let occurring: Vec<usize> = (0..ring.field().generators().len()).filter(occurs).collect();
    (occurring.iter().map(|&i| ring.field().depth(i)).max().unwrap_or(0), occurring.len())
}

/// Visits numbers of the class of the nonzero `number` modulo squares of the field of the first `count` generators, from
/// which generators other than the first `base` ones were removed as far as possible, until one is accepted. True if one
/// was.
///
/// If the norm `a² − r·b²` of `a + b·g` is a square `s²` below `g`, then `2(a + s)·(a + b·g) = (a + s + b·g)²`, so that
/// `2(a + s)`, and likewise `2(a − s)`, is of the same class; if it is none, no number below `g` is. A number without
/// `g` is of the class of its product with `r` as well. So the search finds a number of the field of the first `base`
/// generators if the class has one, and `left` candidates suffice.
fn visit_class(
    number: &Poly,
    field: &Arc<NumberField>,
    count: usize,
    base: usize,
    left: &mut u32,
    accept: &mut impl FnMut(&Poly) -> bool,
) -> bool {
    budget::spend(16);
    let Some(last) = count.checked_sub(1).filter(|last| *last >= base) else {
        *left = left.saturating_sub(1);
        return accept(number);
    };
    if *left == 0 {
        return false;
    }
    // Of two candidates whose quotient lies in the field of the first `base` generators, one is enough.
    let rational = last_generator(&field.radicand(last)).is_none_or(|position| position < base);
    if last_generator(number).is_none_or(|position| position < last) {
        return visit_class(number, field, last, base, left, accept)
            || (!rational && visit_class(&(number * field.radicand(last)), field, last, base, left, accept));
    }
    let Some(s) = sqrt_below(&norm(number, last), field, last) else {
        *left -= 1;
        return accept(number);
    };
    let (a, _) = split(number, last);
    visit_class(&(&a + &s).scale(&crate::integer(2)), field, last, base, left, accept)
        || (!rational && visit_class(&(a - s).scale(&crate::integer(2)), field, last, base, left, accept))
}

/// A number of the field of the first `base` generators whose root is `√number` times a number of the field of the first
/// `count` ones, in which the nonzero `number` lies; `None` if there is none, or it is beyond the limit of the search.
pub(super) fn class_within(
    number: &Poly,
    field: &Arc<NumberField>,
    count: usize,
    base: usize,
) -> Option<Poly> {
    let mut found = None;
    visit_class(number, field, count, base, &mut { MOST_CLASSES }, &mut |candidate| {
        let within = last_generator(candidate).is_none_or(|position| position < base);
        found = within.then(|| candidate.clone());
        within
    });
    found
}

/// `a` and `b` of `number = a + b·g`, where `g` is the generator at `position`, which is the last one that occurs.
fn split(number: &Poly, position: usize) -> (Poly, Poly) {
    let conjugate = number.conjugate(position);
    let a = (number + &conjugate).scale(&ratio(1, 2));
    let b = (number - &conjugate).scale(&ratio(1, 2)) * generator_inverse(number.ring(), position);
    (a, b)
}

/// The norm `a² − r·b²` of `number = a + b·g`, where `g` is the generator at `position`.
fn norm(number: &Poly, position: usize) -> Poly {
    number * number.conjugate(position)
}

/// `1/g = g/r` for the generator `g` at `position`.
fn generator_inverse(ring: &Arc<Ring>, position: usize) -> Poly {
    Poly::generator(ring.field(), position) * ring.field().radicand(position).inverse()
}

/// The root of a positive `number` that is no square in `field` as a new generator, times a rational: `√(c·P) = s·√(f·P)`
/// for `c = s²·f`.
pub(super) fn extend(field: &Arc<NumberField>, number: &Poly) -> Poly {
    let (root, rest) = square_part(&number.content().abs());
    let mut radicand = number.primitive().scale(&rest.into());
    if number.content().is_negative() {
        radicand = -radicand;
    }
    let extended = field::adjoin(field, &radicand);
    Poly::generator(&extended, field.generators().len()).scale(&root)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{integer, minimize_field};

    fn root(n: i64) -> Poly {
        Poly::sqrt_of(&integer(n))
    }

    /// `√(a + b·c)`.
    fn nested(a: i64, b: i64, c: &Poly) -> Poly {
        (Poly::integer(a) + c.scale(&integer(b))).sqrt().unwrap()
    }

    fn degree(number: &Poly) -> u64 {
        minimize_field(std::slice::from_ref(number))[0].ring().field().degree()
    }

    #[test]
    fn squares_are_recognized() {
        let number = Poly::integer(3) + root(5);
        let root_of = number.sqrt().unwrap();
        assert_eq!(&root_of * &root_of, number);
        assert_eq!(root_of, (root(10) + root(2)).scale(&ratio(1, 2)));
        assert_eq!((Poly::integer(1) - root(2)).sqrt(), None);
    }

    #[test]
    fn radicals_denest() {
        assert_eq!(nested(8300, 1800, &root(2)).to_string(), "10*sqrt2 + 90");
        assert_eq!(nested(5, 2, &root(6)), root(2) + root(3));
        assert_eq!(
            nested(
                112,
                1,
                &(root(2) * Poly::integer(70) + root(5) * Poly::integer(46) + root(10) * Poly::integer(34))
            ),
            Poly::integer(5) + root(2) * Poly::integer(4) + root(5) * (Poly::integer(3) + root(2))
        );
        // Shanks, Incredible identities, 1974.
        let inner = nested(55, -10, &root(29));
        let whole =
            (Poly::integer(16) - root(29).scale(&integer(2)) + inner.scale(&integer(2))).sqrt().unwrap();
        assert_eq!(whole, root(5) + nested(11, -2, &root(29)));
        // Three roots under one, and the sum of Borodin, Fagin, Hopcroft and Tompa that vanishes.
        let three = Poly::integer(10) + (root(6) + root(10) + root(15)).scale(&integer(2));
        assert_eq!(three.sqrt().unwrap(), root(2) + root(3) + root(5));
        let sum = nested(1, 1, &root(3)) + nested(3, 3, &root(3)) - nested(10, 6, &root(3));
        assert!(sum.is_zero());
    }

    #[test]
    fn multiples_of_known_radicands_need_simple_roots_only() {
        // √(6 + 3√2) = √3·√(2 + √2).
        let sum = nested(2, 1, &root(2)) + nested(6, 3, &root(2));
        let field = sum.ring().field();
        assert_eq!(field.degree(), 8);
        let depths: Vec<usize> = (0..3).map(|i| field.depth(i)).collect();
        assert_eq!(depths, [1, 2, 1]);
        assert_eq!(degree(&(root(8) + root(18) + Poly::sqrt_of(&ratio(2, 9)))), 2);
    }

    #[test]
    fn classes_are_found_wherever_they_are() {
        // In Q(√7, √(3 + √7), √(3 − √7)) the product of the roots is √2.
        let field = (nested(3, 1, &root(7)) + nested(3, -1, &root(7))).ring().field().clone();
        assert_eq!(class_within(&field.radicand(1), &field, 1, 0), None);
        let number = class_within(&field.radicand(2), &field, 2, 0).unwrap();
        let product = &number * field.radicand(2);
        assert!(number.to_rational().is_some() && sqrt_below(&product, &field, 2).is_some());
    }
}
