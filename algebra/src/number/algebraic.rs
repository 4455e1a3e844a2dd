//! Numbers of a number field, that is polynomials without variables: inverse, sign, enclosures and square roots.

use std::cmp::Ordering;
use std::sync::Arc;

use num_traits::{Signed, Zero};

use super::bracket::Bracket;
use super::enclosure::Enclosure;
use super::field::{self, NumberField};
use crate::poly::{Poly, Ring};
use crate::{Int, Rational, budget, integer, ratio, rational_sqrt, square_part};

impl Poly {
    /// The number `1/self`, for a nonzero number of the field.
    ///
    /// The norm to the next smaller field of the tower, `(a + b·g)(a − b·g) = a² − r·b²`, takes out one generator after
    /// the other.
    ///
    /// # Panics
    /// If `self` is zero, or has variables.
    #[must_use]
    pub fn inverse(&self) -> Poly {
        assert!(!self.is_zero(), "division by zero in a number field");
        if let Some(value) = self.to_rational() {
            return Poly::constant(value.recip());
        }
        assert!(self.is_constant(), "only a number has an inverse");
        let Some(last) = last_generator(self) else { unreachable!("an irrational number has a generator") };
        let conjugate = self.conjugate(last);
        let norm = self * &conjugate;
        conjugate * norm.inverse()
    }

    /// An interval of width at most `2^-bits` that holds the number.
    ///
    /// # Panics
    /// If `self` has variables.
    #[must_use]
    pub fn enclosure(&self, bits: u64) -> Enclosure {
        if let Some(value) = self.to_rational() {
            return Enclosure::exact(value);
        }
        assert!(self.is_constant(), "only a number has a value");
        let mut working = bits + 32;
        loop {
            let bracket = self.working_bracket(working);
            if bracket.is_narrow(self.content(), working, bits) {
                return bracket.times(self.content(), working);
            }
            working *= 2;
        }
    }

    fn working_bracket(&self, bits: u64) -> Bracket {
        budget::spend(bits * self.terms().len() as u64);
        self.bracket(bits)
    }

    /// The sign of the number.
    ///
    /// Zero is recognized by the canonical form; otherwise enclosures are refined until they exclude zero.
    ///
    /// # Panics
    /// If `self` has variables.
    #[must_use]
    pub fn sign(&self) -> Ordering {
        if self.is_zero() {
            return Ordering::Equal;
        }
        if self.to_rational().is_some() {
            return self.content().cmp(&Rational::zero());
        }
        assert!(self.is_constant(), "only a number has a sign");
        let mut bits = 64;
        let primitive = loop {
            let bracket = self.working_bracket(bits);
            if bracket.lower.is_positive() {
                break Ordering::Greater;
            }
            if bracket.upper.is_negative() {
                break Ordering::Less;
            }
            bits *= 2;
        };
        if self.content().is_negative() { primitive.reverse() } else { primitive }
    }

    /// Compares two numbers by their real values.
    #[must_use]
    pub fn compare(&self, other: &Poly) -> Ordering {
        (self - other).sign()
    }

    /// The nonnegative square root of a number, in its field or in a quadratic extension of it; `None` if the number is
    /// negative.
    ///
    /// Nested radicals denest where that saves a root: `√(8300 + 1800√2)` is `90 + 10√2`, and `√(3 + √5)` is
    /// `(√10 + √2)/2`, following Borodin, Fagin, Hopcroft and Tompa, *Decreasing the nesting depth of expressions
    /// involving square roots*, 1985.
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

    /// The number as a decimal, correctly rounded to `digits` places after the point, halves away from zero.
    #[must_use]
    pub fn to_decimal(&self, digits: u32) -> String {
        let scale = Rational::from(Int::from(10).pow(digits));
        let mut bits = 64 + 4 * u64::from(digits);
        let rounded = loop {
            let enclosure = self.enclosure(bits);
            let round = |value: &Rational| (value * &scale).round().to_integer();
            let (low, high) = (round(enclosure.lower()), round(enclosure.upper()));
            if low == high {
                break low;
            }
            // An irrational number is no midpoint of two decimals, so narrower enclosures decide.
            bits *= 2;
        };
        let text = format!("{:0>width$}", rounded.abs().to_string(), width = digits as usize + 1);
        let (whole, fraction) = text.split_at(text.len() - digits as usize);
        let sign = if rounded.is_negative() { "-" } else { "" };
        if digits == 0 { format!("{sign}{whole}") } else { format!("{sign}{whole}.{fraction}") }
    }
}

/// The last generator that occurs in `poly`.
fn last_generator(poly: &Poly) -> Option<usize> {
    let ring = poly.ring();
    let count = ring.field().generators().len();
    (0..count).rev().find(|&i| poly.terms().iter().any(|term| ring.generator_exponent(term.monomial, i) > 0))
}

/// `a` and `b` of `number = a + b·g`, where `g` is the generator at `position`, which is the last one that occurs.
fn split(number: &Poly, position: usize) -> (Poly, Poly) {
    let conjugate = number.conjugate(position);
    let a = (number + &conjugate).scale(&ratio(1, 2));
    let b = (number - &conjugate).scale(&ratio(1, 2)) * generator_inverse(number.ring(), position);
    (a, b)
}

/// `1/g = g/r` for the generator `g` at `position`.
fn generator_inverse(ring: &Arc<Ring>, position: usize) -> Poly {
    Poly::generator(ring.field(), position) * ring.field().radicand(position).inverse()
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
    let norm = &a * &a - field.radicand(last) * &b * &b;
    let s = sqrt_below(&norm, field, last)?;
    for p_squared in [&a + &s, &a - &s] {
        let p_squared = p_squared.scale(&ratio(1, 2));
        if p_squared.is_zero() {
            continue;
        }
        if let Some(p) = sqrt_below(&p_squared, field, last) {
            let q = &b * p.scale(&integer(2)).inverse();
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

/// `√(a + b·g) = p + b·g/(2p)` with `p = √((a + s)/2)`, if `s = √(a² − r·b²)` lies below `g`: a root of less depth.
fn denest(number: &Poly) -> Option<Poly> {
    let last = last_generator(number)?;
    let field = number.ring().field();
    let (a, b) = split(number, last);
    let norm = &a * &a - field.radicand(last) * &b * &b;
    let s = sqrt_below(&norm, field, last)?;
    let s = if s.sign() == Ordering::Less { -s } else { s };
    // The number and its conjugate are positive, hence so is their mean a.
    let half = (&a + &s).scale(&ratio(1, 2));
    let p = adjoin_sqrt(field, &half);
    let q = &b * p.scale(&integer(2)).inverse();
    let root = &p + q * Poly::generator(field, last);
    Some(if root.sign() == Ordering::Less { -root } else { root })
}

/// The root of `number` as a new generator, times a rational: √(c·P) = s·√(f·P) for c = s²·f.
fn extend(field: &Arc<NumberField>, number: &Poly) -> Poly {
    let (root, rest) = square_part(&number.content().abs());
    let mut radicand = number.primitive().scale(&rest.into());
    if number.content().is_negative() {
        radicand = -radicand;
    }
    let extended = field::adjoin(field, &radicand);
    Poly::generator(&extended, field.generators().len()).scale(&root)
}

/// The same polynomials over a field with as few generators as this can find.
///
/// Generators of the largest nesting depth that occur only in products are replaced by those products (in FN Example 2,
/// `√(2+√2)·√(10+45√2)` becomes `√(110+100√2)`), by a basis of the exponents modulo 2; then the same is done to what
/// they leave, level by level. All results are represented over one and the same field.
#[must_use]
pub fn minimize_field(polys: &[Poly]) -> Vec<Poly> {
    let mut field = NumberField::rationals();
    for poly in polys {
        field = field::join(&field, poly.ring().field()).0;
    }
    let (minimized, field) = minimize(&anchor(polys, &field), &field);
    anchor(&minimized, &field)
}

/// A product of generators of one depth, as the positions in the field.
type GeneratorProduct = Vec<usize>;

fn minimize(polys: &[Poly], field: &Arc<NumberField>) -> (Vec<Poly>, Arc<NumberField>) {
    let occurs = |poly: &Poly, i: usize| {
        poly.terms().iter().any(|t| poly.ring().generator_exponent(t.monomial, i) > 0)
    };
    let occurring = (0..field.generators().len()).filter(|&i| polys.iter().any(|poly| occurs(poly, i)));
    let occurring: Vec<usize> = occurring.collect();
    let Some(depth) = occurring.iter().map(|&i| field.depth(i)).max() else {
        let rationals = NumberField::rationals();
        return (polys.iter().map(|poly| poly.map_generators(&rationals, &[])).collect(), rationals);
    };
    let top: Vec<usize> = occurring.into_iter().filter(|&i| field.depth(i) == depth).collect();
    // Each polynomial as a sum of coefficients below the top level, by the set of top generators in the term.
    let parts: Vec<Vec<(u64, Poly)>> = polys.iter().map(|poly| split_by_generators(poly, &top)).collect();
    let basis = basis_modulo_2(parts.iter().flatten().map(|(mask, _)| *mask));
    let products: Vec<GeneratorProduct> = basis.iter().map(|&mask| positions(mask, &top)).collect();

    // Everything below the top level, minimized together.
    let mut below: Vec<Poly> = Vec::new();
    let mut combinations: Vec<Vec<u64>> = Vec::new();
    for part in &parts {
        let mut members = Vec::new();
        for (mask, coefficient) in part {
            let combination = combination(&basis, *mask);
            // g^mask = Π products / Π radicands of the generators that these share.
            let shared = top.iter().enumerate().map(|(bit, &position)| {
                field.radicand(position).pow(members_with(&basis, combination, bit) / 2)
            });
            below.push(coefficient * shared.product::<Poly>().inverse());
            members.push(combination);
        }
        combinations.push(members);
    }
    let radicand = |product: &GeneratorProduct| product.iter().map(|&i| field.radicand(i)).product::<Poly>();
    below.extend(products.iter().map(radicand));
    let (mut below, mut field) = minimize(&anchor(&below, field), field);
    let radicands = below.split_off(below.len() - products.len());

    let mut roots = Vec::new();
    for radicand in &radicands {
        let root = extend(&field, &radicand.transfer_to(&Ring::new([], field.clone())));
        field = root.ring().field().clone();
        roots.push(root);
    }
    let mut below = below.into_iter();
    let mut rebuild = |members: Vec<u64>| {
        members.into_iter().fold(Poly::zero(), |sum, members| {
            let chosen = roots.iter().enumerate().filter(|(i, _)| members >> i & 1 == 1);
            let product: Poly = chosen.map(|(_, root)| root.clone()).product();
            sum + below.next().unwrap_or_else(Poly::zero) * product
        })
    };
    (combinations.into_iter().map(&mut rebuild).collect(), field)
}

/// All polynomials over `field`, into which all of theirs are joined.
fn anchor(polys: &[Poly], field: &Arc<NumberField>) -> Vec<Poly> {
    polys
        .iter()
        .map(|poly| {
            let (joined, images) = field::join(field, poly.ring().field());
            let poly = images.map_or_else(|| poly.clone(), |images| poly.map_generators(&joined, &images));
            poly.transfer_to(&Ring::new(poly.ring().variables().iter().cloned(), joined))
        })
        .collect()
}

fn split_by_generators(poly: &Poly, top: &[usize]) -> Vec<(u64, Poly)> {
    let mut parts: Vec<(u64, Poly)> = Vec::new();
    let field = poly.ring().field();
    for (exponents, coefficient) in poly.generator_coefficients() {
        let mask = top.iter().enumerate().map(|(bit, &i)| u64::from(exponents[i]) << bit).sum();
        let rest: Poly = (0..exponents.len())
            .filter(|i| exponents[*i] == 1 && !top.contains(i))
            .map(|i| Poly::generator(field, i))
            .product();
        let part = coefficient * rest;
        match parts.iter_mut().find(|(other, _)| *other == mask) {
            Some((_, sum)) => *sum += part,
            None => parts.push((mask, part)),
        }
    }
    parts
}

/// A basis, in reduced echelon form, of the span of `masks` over the field of two elements.
fn basis_modulo_2(masks: impl Iterator<Item = u64>) -> Vec<u64> {
    let mut basis: Vec<u64> = Vec::new();
    for mut mask in masks {
        for &member in &basis {
            if mask & lowest_bit(member) != 0 {
                mask ^= member;
            }
        }
        if mask == 0 {
            continue;
        }
        for member in &mut basis {
            if *member & lowest_bit(mask) != 0 {
                *member ^= mask;
            }
        }
        basis.push(mask);
    }
    basis.sort_by_key(|&member| lowest_bit(member));
    basis
}

/// The members of the basis, as a mask of indices, whose sum is `mask`.
fn combination(basis: &[u64], mask: u64) -> u64 {
    basis.iter().enumerate().map(|(i, member)| u64::from(mask & lowest_bit(*member) != 0) << i).sum()
}

fn members_with(basis: &[u64], members: u64, bit: usize) -> u32 {
    let has = |(i, member): (usize, &u64)| u32::from(members >> i & 1 == 1 && member >> bit & 1 == 1);
    basis.iter().enumerate().map(has).sum()
}

fn lowest_bit(mask: u64) -> u64 {
    mask & mask.wrapping_neg()
}

fn positions(mask: u64, top: &[usize]) -> Vec<usize> {
    top.iter().enumerate().filter(|(bit, _)| mask >> bit & 1 == 1).map(|(_, &position)| position).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn root(n: i64) -> Poly {
        Poly::sqrt_of(&integer(n))
    }

    #[test]
    fn equal_numbers_are_equal() {
        // √2·√3 = √6, and √(5 + 2√6) = √2 + √3.
        assert_eq!(root(2) * root(3), root(6));
        let nested = (root(6).scale(&integer(2)) + Poly::integer(5)).sqrt().unwrap();
        assert_eq!(nested, root(2) + root(3));
        assert_eq!((root(2) - root(2)).sign(), Ordering::Equal);
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
    fn inverses_multiply_to_one() {
        let number = Poly::integer(7) + root(2) * root(3) - root(5).scale(&ratio(2, 3));
        assert!((&number * number.inverse()).is_one());
        let nested = (Poly::integer(2) + root(2)).sqrt().unwrap() + root(2);
        assert!((&nested * nested.inverse()).is_one());
    }

    #[test]
    fn signs_of_close_numbers() {
        // 99²·… : 577/408 is just above √2.
        assert_eq!((Poly::constant(ratio(577, 408)) - root(2)).sign(), Ordering::Greater);
        assert_eq!((Poly::constant(ratio(239, 169)) - root(2)).sign(), Ordering::Less);
    }

    #[test]
    fn products_of_radicals_shrink_the_field() {
        let a = (Poly::integer(2) + root(2)).sqrt().unwrap();
        let b = (Poly::integer(10) + root(2).scale(&integer(45))).sqrt().unwrap();
        let product = &a * &b;
        assert_eq!(product.ring().field().degree(), 8);
        let small = minimize_field(&[product.clone(), root(2)]);
        assert_eq!(small[0].ring().field().degree(), 4);
        assert_eq!(small[0], product);
        let relations: Vec<String> =
            (0..2).map(|i| small[0].ring().field().relation(i).to_string()).collect();
        assert_eq!(relations, ["sqrt2^2 - 2", "theta^2 - 100*sqrt2 - 110"]);
        let only = minimize_field(&[root(2) * root(5)]);
        assert_eq!(only[0].to_string(), "sqrt10");
        assert_eq!(minimize_field(&[root(2) * root(2)])[0].ring().field().degree(), 1);
    }

    #[test]
    fn decimals_are_rounded_correctly() {
        assert_eq!(root(2).to_decimal(5), "1.41421");
        assert_eq!((-root(2)).to_decimal(4), "-1.4142");
        assert_eq!(Poly::constant(ratio(1, 3)).to_decimal(3), "0.333");
        assert_eq!(Poly::constant(ratio(5, 2)).to_decimal(0), "3");
        assert_eq!(Poly::constant(ratio(-1, 20)).to_decimal(1), "-0.1");
    }
}
