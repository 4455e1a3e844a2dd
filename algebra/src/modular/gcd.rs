//! Greatest common divisors of polynomials over prime fields.

use std::collections::BTreeMap;

use super::field::{PrimeField, Residue};
use super::multivariate::{Layout, Multivariate, Points};
use super::sparse::Skeleton;
use super::univariate::{Interpolation, Univariate};
use crate::budget;

impl Multivariate {
    /// The greatest common divisor, with leading coefficient 1; zero only of two zeros.
    ///
    /// Brown's evaluation and interpolation (*On Euclid's algorithm and the computation of polynomial greatest common
    /// divisors*, 1971; Geddes, Czapor, Labahn, *Algorithms for Computer Algebra*, Algorithm 7.2), from the last
    /// variable to the first, with a sparse shortcut (`Skeleton`). `bounds` holds the degree of the result in each variable,
    /// or more. The result is right unless all points that were tried are unlucky in the same way, so the reader certifies it.
    pub(crate) fn gcd(&self, field: &PrimeField, layout: &Layout, other: &Self, bounds: &[u32]) -> Self {
        Divisor { field, layout, bounds, points: Points::new(field) }.gcd(self, other)
    }
}

/// The state of one computation of a gcd.
struct Divisor<'a> {
    field: &'a PrimeField,
    layout: &'a Layout,
    bounds: &'a [u32],
    points: Points,
}

/// The images at points of one variable that agree on the leading monomial.
#[derive(Default)]
struct Images {
    points: Vec<Residue>,
    images: Vec<Multivariate>,
}

impl Divisor<'_> {
    fn gcd(&mut self, a: &Multivariate, b: &Multivariate) -> Multivariate {
        if a.is_zero() || b.is_zero() {
            return if a.is_zero() { b.monic(self.field) } else { a.monic(self.field) };
        }
        if a.is_constant() || b.is_constant() {
            return Multivariate::constant(self.field.one());
        }
        // The last variable that occurs in either.
        let union = [a, b].into_iter().flat_map(|p| p.terms()).fold(0, |union, term| union | term.0);
        let occurring = (0..self.layout.len()).rev().find(|&i| self.layout.exponent(union, i) > 0);
        let position = occurring.unwrap_or(0);
        match (a.degree(self.layout, position), b.degree(self.layout, position)) {
            (0, _) => self.gcd_with_coefficients(a, b, position),
            (_, 0) => self.gcd_with_coefficients(b, a, position),
            _ => self.gcd_by_interpolation(a, b, position),
        }
    }

    /// The gcd of `a`, where the variable `position` does not occur, and all coefficients of `b` as a polynomial in it.
    fn gcd_with_coefficients(&mut self, a: &Multivariate, b: &Multivariate, position: usize) -> Multivariate {
        let mut coefficients: BTreeMap<u32, Vec<(u128, Residue)>> = BTreeMap::new();
        for &(word, coefficient) in b.terms() {
            let exponent = self.layout.exponent(word, position);
            let cleared = word - self.layout.power(position, exponent);
            coefficients.entry(exponent).or_default().push((cleared, coefficient));
        }
        let mut coefficients: Vec<_> = coefficients.into_values().map(Multivariate::from_sorted).collect();
        coefficients.sort_by_key(|coefficient| coefficient.terms().len());
        let mut gcd = a.monic(self.field);
        for coefficient in coefficients {
            if gcd.is_constant() {
                break;
            }
            gcd = self.gcd(&gcd, &coefficient);
        }
        gcd
    }

    /// The gcd of polynomials in the variables up to `position`, where it occurs in both.
    fn gcd_by_interpolation(&mut self, a: &Multivariate, b: &Multivariate, position: usize) -> Multivariate {
        let field = self.field;
        let (mut a, mut b) = (a.split(self.layout, position), b.split(self.layout, position));
        let (a_content, b_content) = (remove_content(field, &mut a), remove_content(field, &mut b));
        let content = a_content.gcd(field, &b_content);
        if a[0].0 == 0 || b[0].0 == 0 {
            // One of the two is free of the earlier variables, hence is its own content.
            return Multivariate::join(self.layout, position, &[(0, content)]);
        }
        // The result times the gcd of the leading coefficients is a polynomial with images of known leading coefficient.
        let scale = a[0].1.gcd(field, &b[0].1);
        let degree =
            |parts: &[(u128, Univariate)]| parts.iter().map(|part| part.1.degree()).max().unwrap_or(0);
        let bound = degree(&a).min(degree(&b)).min(self.bounds[position] as usize);
        let needed = bound + scale.degree() + 1;
        let words = [&a, &b].map(|parts| parts.iter().map(|part| part.0).collect::<Vec<u128>>());
        let mut collected = Images::default();
        let mut skeleton: Option<Skeleton> = None;
        while collected.points.len() < needed {
            let point = self.points.next();
            let values = [&a, &b].map(|parts| evaluate(field, parts, point));
            if values.iter().any(|values| values[0].is_zero()) || collected.points.contains(&point) {
                continue;
            }
            let before = budget::spent();
            let known =
                skeleton.as_ref().and_then(|skeleton| skeleton.image(field, [&values[0], &values[1]]));
            let image = known.unwrap_or_else(|| {
                skeleton = None;
                let [a, b] = [0, 1].map(|k: usize| combine(&words[k], &values[k]));
                self.gcd(&a, &b)
            });
            if image.is_constant() {
                return Multivariate::join(self.layout, position, &[(0, content)]);
            }
            let least = collected.images.first().map_or(u128::MAX, Multivariate::leading_word);
            if image.leading_word() > least {
                // An unlucky point: the degree of a gcd can only grow under evaluation.
                continue;
            }
            if image.leading_word() < least {
                collected = Images::default();
                // From the second image on the monomials are known; below two other variables there is nothing to save.
                let dense = budget::spent() - before;
                let point = self.points.take(self.layout.len());
                let prepare = || Skeleton::new(field, self.layout, &image, [&words[0], &words[1]], &point);
                let wanted = position >= 2 && needed > 1;
                skeleton = if wanted { prepare().filter(|skeleton| skeleton.cost() < dense) } else { None };
            }
            collected.images.push(image.scale(field, scale.evaluate(field, point)));
            collected.points.push(point);
        }
        let mut parts = interpolate(field, &collected);
        remove_content(field, &mut parts);
        for (_, part) in &mut parts {
            *part = part.mul(field, &content);
        }
        Multivariate::join(self.layout, position, &parts).monic(field)
    }
}

/// Divides all parts by their monic gcd, which is returned.
fn remove_content(field: &PrimeField, parts: &mut [(u128, Univariate)]) -> Univariate {
    let mut content = Univariate::default();
    for (_, part) in parts.iter() {
        content = content.gcd(field, part);
        if content.is_constant() {
            return content;
        }
    }
    for (_, part) in parts.iter_mut() {
        // The content is not zero, as no part is.
        if let Some((quotient, _)) = part.divide(field, &content) {
            *part = quotient;
        }
    }
    content
}

/// The values of all parts at `point`.
fn evaluate(field: &PrimeField, parts: &[(u128, Univariate)], point: Residue) -> Vec<Residue> {
    budget::spend(parts.iter().map(|part| part.1.coefficients().len() as u64).sum());
    parts.iter().map(|part| part.1.evaluate(field, point)).collect()
}

/// The polynomial with these monomials, in descending order, and coefficients, some of which may be zero.
fn combine(words: &[u128], values: &[Residue]) -> Multivariate {
    let terms = words.iter().copied().zip(values.iter().copied());
    Multivariate::from_sorted(terms.filter(|term| !term.1.is_zero()).collect())
}

/// The polynomial in one more variable that has these images.
fn interpolate(field: &PrimeField, collected: &Images) -> Vec<(u128, Univariate)> {
    let mut values: BTreeMap<u128, Vec<Residue>> = BTreeMap::new();
    for (i, image) in collected.images.iter().enumerate() {
        for &(word, value) in image.terms() {
            values.entry(word).or_insert_with(|| vec![Residue::ZERO; collected.points.len()])[i] = value;
        }
    }
    // The points are distinct by construction.
    let Some(interpolation) = Interpolation::new(field, &collected.points) else { return Vec::new() };
    let parts = values.iter().rev().map(|(&word, values)| (word, interpolation.interpolate(field, values)));
    parts.filter(|part| !part.1.is_zero()).collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::super::multivariate::tests::{
        VARIABLES, field, layout, naive_quotient, polynomial, polynomials, product,
    };
    use super::*;

    /// The degrees that bound the gcd of two polynomials without any knowledge.
    fn trivial_bounds(a: &Multivariate, b: &Multivariate) -> Vec<u32> {
        let layout = layout();
        (0..VARIABLES).map(|i| a.degree(&layout, i).min(b.degree(&layout, i))).collect()
    }

    #[test]
    fn leading_coefficients_and_contents_are_kept() {
        // a = (z² − 1)(z·x + y), b = (z + 1)(z·x + y)·y
        let common = polynomial(&[([1, 0, 1], 1), ([0, 1, 0], 1)]);
        let a = product(&common, &polynomial(&[([0, 0, 2], 1), ([0, 0, 0], -1)]));
        let b = product(&common, &polynomial(&[([0, 1, 1], 1), ([0, 1, 0], 1)]));
        let gcd = a.gcd(&field(), &layout(), &b, &trivial_bounds(&a, &b));
        assert_eq!(gcd, product(&common, &polynomial(&[([0, 0, 1], 1), ([0, 0, 0], 1)])));
    }

    proptest! {
        #[test]
        fn gcd_of_multiples(a in polynomials(5), b in polynomials(5), g in polynomials(5)) {
            let (field, layout) = (field(), layout());
            prop_assume!(!a.is_zero() && !b.is_zero() && !g.is_zero());
            let (x, y) = (product(&a, &g), product(&b, &g));
            let gcd = x.gcd(&field, &layout, &y, &trivial_bounds(&x, &y));
            let cofactors = (naive_quotient(&x, &gcd), naive_quotient(&y, &gcd));
            prop_assert!(naive_quotient(&gcd, &g).is_some());
            let (Some(a), Some(b)) = cofactors else { return Err(TestCaseError::fail("not a divisor")) };
            let rest = a.gcd(&field, &layout, &b, &trivial_bounds(&a, &b));
            prop_assert!(rest.is_constant());
        }
    }
}
