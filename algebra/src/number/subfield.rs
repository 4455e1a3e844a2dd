//! The smallest number field that holds given numbers.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::algebraic::last_generator;
use super::field::{self, NumberField};
use super::square_root::{class_within, extend};
use crate::budget;
use crate::modular::field::{PrimeField, Residue};
use crate::modular::lift::Modulo;
use crate::poly::{Poly, Ring};

/// The same polynomials over the smallest field that holds their coefficients.
///
/// First, generators of the largest nesting depth that occur only in products are replaced by those products (in FN
/// Example 2, `√(2+√2)·√(10+45√2)` becomes `√(110+100√2)`), by a basis of the exponents modulo 2; then the same is done to
/// what they leave, level by level. If the degree of what the coefficients generate is smaller still, that field is built
/// from below: `√(3+√7) + √(3−√7)` is `√(6+2√2)`. A field in which that would take too much work, as one with more
/// than 7 generators, is left as the first step gives it. All results are represented over one and the same field.
///
/// # Example
/// ```
/// use hodograph_algebra::{Poly, integer, minimize_field};
/// let root7 = Poly::sqrt_of(&integer(7));
/// let [plus, minus] = [&root7, &-&root7].map(|root| (Poly::integer(3) + root).sqrt().unwrap());
/// let sum = &minimize_field(&[plus + minus])[0];
/// assert_eq!(sum.to_string(), "theta");
/// assert_eq!(sum.ring().field().relation(1).to_string(), "theta^2 - 2*sqrt2 - 6");
/// ```
#[must_use]
pub fn minimize_field(polys: &[Poly]) -> Vec<Poly> {
    let mut field = NumberField::rationals();
    for poly in polys {
        field = field::join(&field, poly.ring().field()).0;
    }
    let (minimized, field) = minimize(&anchor(polys, &field), &field);
    let minimized = anchor(&minimized, &field);
    let smallest = budget::with_budget(SMALLEST, || smallest(&minimized, &field)).ok().flatten();
    smallest.unwrap_or(minimized)
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

/// The units of work that the search for a smaller field may take.
const SMALLEST: u64 = 5_000_000;

/// The number of generators of a tower up to which a smaller field is sought.
const TALLEST: usize = 7;

/// The polynomials over the field `L` that their coefficients generate; `None` if that is all of `field`, or is not found.
///
/// A subfield of a tower of square roots is such a tower itself: the Galois group is a 2-group, in which every proper
/// subgroup is contained in one of index 2. So `L`, if larger than the part `M` that is known, contains some `√c` with `c`
/// in `M`. The classes of all `c` whose root lies in the field come from the classes of the radicands; of their products
/// those are taken whose root lies in `L`. These are adjoined to `M`, and the tower is built anew above it.
fn smallest(polys: &[Poly], field: &Arc<NumberField>) -> Option<Vec<Poly>> {
    let count = field.generators().len();
    if !(2..=TALLEST).contains(&count) || Span::generated(polys, field)?.is_everything() {
        return None;
    }
    let (mut polys, mut tower) = (polys.to_vec(), field.clone());
    let mut known = NumberField::rationals();
    loop {
        let base = known.generators().len();
        if polys.iter().all(|poly| last_generator(poly).is_none_or(|last| last < base)) {
            let images: Vec<Poly> = (0..base).map(|i| Poly::generator(&known, i)).collect();
            return Some(polys.iter().map(|poly| poly.map_generators(&known, &images)).collect());
        }
        let classes: Vec<Poly> = (base..tower.generators().len())
            .filter_map(|i| class_within(&tower.radicand(i), &tower, i, base))
            .collect();
        let span = Span::generated(&polys, &tower)?;
        let roots: Vec<Poly> = classes
            .iter()
            .map(|class| class.transfer_to(&Ring::new([], tower.clone())).sqrt_in_field())
            .collect::<Option<_>>()?;
        // Products of roots in L, one for each dimension: a product of two that were found is nothing new.
        let mut found: Vec<u64> = Vec::new();
        for mask in 1..1_u64 << classes.len() {
            let chosen = |numbers: &[Poly]| -> Poly {
                numbers
                    .iter()
                    .enumerate()
                    .filter(|(i, _)| mask >> i & 1 == 1)
                    .map(|(_, n)| n.clone())
                    .product()
            };
            let is_new = !spanned(&found, mask);
            if is_new && span.contains(&chosen(&roots)) {
                found.push(mask);
                let images: Vec<Poly> = (0..base).map(|i| Poly::generator(&known, i)).collect();
                known =
                    extend(&known, &chosen(&classes).map_generators(&known, &images)).ring().field().clone();
            }
        }
        if found.is_empty() {
            return None;
        }
        polys = anchor(&polys, &known);
        tower = polys.first()?.ring().field().clone();
    }
}

/// Whether `mask` is a sum of some of `masks` over the field of two elements.
fn spanned(masks: &[u64], mask: u64) -> bool {
    let basis = basis_modulo_2(masks.iter().copied());
    basis_modulo_2(masks.iter().copied().chain([mask])).len() == basis.len()
}

/// The subfield that numbers generate, as a vector space modulo a prime: the span of the powers of a random combination.
///
/// It is taken for the span of the true powers, which decides nothing but how far the field is reduced.
struct Span<'a> {
    tower: ModularTower<'a>,
    /// Vectors in echelon form, with the place of the leading entry, which is 1.
    rows: Vec<(usize, Vec<Residue>)>,
}

impl<'a> Span<'a> {
    /// The span for the coefficients of `polys` over `field`, modulo the first of the primes; `None` if there is none.
    fn generated(polys: &[Poly], field: &'a Arc<NumberField>) -> Option<Span<'a>> {
        let prime = PrimeField::sequence().next()?;
        let tower = ModularTower { field, prime };
        let mut generic = vec![Residue::ZERO; tower.degree()];
        let mut seed = 1_u64;
        for poly in polys {
            budget::spend(poly.terms().len() as u64);
            let mut weights: BTreeMap<_, Residue> = BTreeMap::new();
            for term in poly.terms() {
                // A different weight for each monomial in the variables; the rational content changes nothing.
                let weight = weights.entry(poly.ring().variable_part(term.monomial)).or_insert_with(|| {
                    seed =
                        seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                    prime.residue_of_word(seed >> 16)
                });
                let cell = &mut generic[tower.place(poly, term.monomial)];
                *cell = prime.add(*cell, prime.mul(*weight, term.coefficient.modulo(&prime)));
            }
        }
        let mut span = Span { tower, rows: Vec::new() };
        let mut power = vec![Residue::ZERO; span.tower.degree()];
        power[0] = prime.one();
        while let Some(row) = span.reduced(power.clone()) {
            span.rows.push(row);
            power = span.tower.product(&power, &generic);
        }
        Some(span)
    }

    /// Whether the numbers generate the whole field.
    fn is_everything(&self) -> bool {
        self.rows.len() == self.tower.degree()
    }

    /// Whether a number of the field lies in the span.
    fn contains(&self, number: &Poly) -> bool {
        let mut vector = vec![Residue::ZERO; self.tower.degree()];
        for term in number.terms() {
            vector[self.tower.place(number, term.monomial)] = term.coefficient.modulo(&self.tower.prime);
        }
        self.reduced(vector).is_none()
    }

    /// What is left of a vector modulo the rows, with its leading place; `None` for nothing.
    fn reduced(&self, mut vector: Vec<Residue>) -> Option<(usize, Vec<Residue>)> {
        let prime = &self.tower.prime;
        budget::spend((self.rows.len() * vector.len()) as u64);
        for (place, row) in &self.rows {
            let factor = vector[*place];
            if !factor.is_zero() {
                for (cell, entry) in vector.iter_mut().zip(row) {
                    *cell = prime.sub(*cell, prime.mul(factor, *entry));
                }
            }
        }
        let place = vector.iter().position(|cell| !cell.is_zero())?;
        let inverse = prime.invert(vector[place])?;
        vector.iter_mut().for_each(|cell| *cell = prime.mul(*cell, inverse));
        Some((place, vector))
    }
}

/// The ring `Z[g₁, …, gₙ]` modulo a prime; a product of generators stands at the place `Σ 2ⁱ` over their positions `i`.
struct ModularTower<'a> {
    field: &'a Arc<NumberField>,
    prime: PrimeField,
}

impl ModularTower<'_> {
    fn degree(&self) -> usize {
        1 << self.field.generators().len()
    }

    fn place(&self, poly: &Poly, monomial: crate::Monomial) -> usize {
        let exponents = poly.ring().generator_exponents(monomial);
        exponents.iter().enumerate().map(|(i, &exponent)| (exponent as usize) << i).sum()
    }

    /// The product of numbers of the field of the first generators, as many as the length says: by that of Karatsuba for
    /// `a + b·g`, four products of half the length.
    fn product(&self, x: &[Residue], y: &[Residue]) -> Vec<Residue> {
        let prime = &self.prime;
        if let ([x], [y]) = (x, y) {
            return vec![prime.mul(*x, *y)];
        }
        budget::spend(x.len() as u64);
        let half = x.len() / 2;
        let ((a, b), (c, d)) = (x.split_at(half), y.split_at(half));
        let sum = |a: &[Residue], b: &[Residue]| -> Vec<Residue> {
            a.iter().zip(b).map(|(&a, &b)| prime.add(a, b)).collect()
        };
        let (low, high) = (self.product(a, c), self.product(b, d));
        let mixed = self.product(&sum(a, b), &sum(c, d));
        let position = half.trailing_zeros() as usize;
        let mut radicand = vec![Residue::ZERO; half];
        for (exponents, coefficient) in self.field.generators()[position].radicand_terms() {
            let place: usize =
                exponents.iter().enumerate().map(|(i, &exponent)| (exponent as usize) << i).sum();
            radicand[place] = coefficient.modulo(prime);
        }
        let mut product = sum(&low, &self.product(&high, &radicand));
        let rest = mixed.iter().zip(low.iter().zip(&high));
        product.extend(rest.map(|(&mixed, (&low, &high))| prime.sub(mixed, prime.add(low, high))));
        product
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{integer, ratio};

    fn root(n: i64) -> Poly {
        Poly::sqrt_of(&integer(n))
    }

    /// `√(a + b)`.
    fn nested(a: i64, b: &Poly) -> Poly {
        (Poly::integer(a) + b).sqrt().unwrap()
    }

    /// The degree of the field of a number, and the number over it.
    fn minimized(number: &Poly) -> (u64, Poly) {
        let small = minimize_field(std::slice::from_ref(number)).swap_remove(0);
        (small.ring().field().degree(), small)
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
    fn subfields_that_no_products_of_generators_span_are_found() {
        for (number, degree) in [
            (nested(3, &root(7)) + nested(3, &-root(7)), 4),
            (nested(1, &(root(2) + root(3))) + nested(1, &(root(3) - root(2))), 8),
            (nested(5, &root(5)) + nested(5, &-root(5)), 4),
            (nested(3, &root(7)) * nested(3, &-root(7)), 2),
            // √(4 + √11) + √(4 − √11) = √(8 + 2√5), whose sum with √5 stays there.
            (nested(4, &root(11)) + nested(4, &-root(11)) + root(5), 4),
            (nested(4, &root(11)) + nested(4, &-root(11)).scale(&integer(2)), 8),
        ] {
            let (found, small) = minimized(&number);
            assert_eq!(found, degree, "the degree of {number}");
            assert_eq!(small, number);
            assert_eq!(small.to_decimal(30), number.to_decimal(30));
        }
    }

    #[test]
    fn polynomials_share_the_smallest_field() {
        let u = Poly::variable(&crate::Variable::new(0, "u"));
        let sum = nested(3, &root(7)) + nested(3, &-root(7));
        let polys = [&u * &sum + Poly::integer(1), u.pow(2).scale(&ratio(1, 3)) - root(2), Poly::zero()];
        let small = minimize_field(&polys);
        assert_eq!(small[0].ring().field().degree(), 4);
        assert!(small.iter().all(|poly| poly.ring().field() == small[0].ring().field()));
        assert_eq!(small, polys);
    }

    #[test]
    fn products_modulo_a_prime_are_those_of_the_field() {
        let number = nested(2, &root(2)) + root(3) * nested(7, &(root(2) * root(3))) - root(2);
        let field = number.ring().field();
        let span = Span::generated(std::slice::from_ref(&number), field).unwrap();
        let coordinates = |number: &Poly| {
            let mut vector = vec![Residue::ZERO; span.tower.degree()];
            for term in number.terms() {
                let coefficient = &term.coefficient * number.content().to_integer();
                vector[span.tower.place(number, term.monomial)] = coefficient.modulo(&span.tower.prime);
            }
            vector
        };
        let x = coordinates(&number);
        assert_eq!(span.tower.product(&x, &x), coordinates(&(&number * &number)));
        assert!(span.is_everything() && span.contains(&number));
    }
}
