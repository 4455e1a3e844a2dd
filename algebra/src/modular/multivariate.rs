//! Sparse polynomials in several variables over a prime field, and their greatest common divisor.

use std::collections::BTreeMap;

use super::field::{PrimeField, Residue};
use super::heap::{NextProduct, ProductHeap};
use super::sparse::Skeleton;
use super::univariate::{Interpolation, Univariate};
use crate::budget;

/// How exponents are packed into one word: the first variable has the most significant bits.
///
/// The order of words is the lexicographic order of monomials. Words are never added beyond the degrees that the layout
/// was made for, so there are no guard bits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Layout {
    /// The position of the lowest bit of each variable's exponent; one more entry than there are variables, above all.
    shifts: Vec<u32>,
}

impl Layout {
    /// The layout for variables of at most these degrees; `None` if that takes more than 128 bits.
    pub(crate) fn new(degrees: &[u32]) -> Option<Self> {
        let mut shifts = vec![0_u32; degrees.len() + 1];
        for (i, degree) in degrees.iter().enumerate().rev() {
            shifts[i] = shifts[i + 1] + (32 - degree.leading_zeros()).max(1);
        }
        // The first entry becomes the total, the others the shifts of the variables.
        let total = shifts[0];
        shifts.rotate_left(1);
        if let Some(last) = shifts.last_mut() {
            *last = total;
        }
        (total <= 128).then_some(Self { shifts })
    }

    /// The number of variables.
    pub(crate) fn len(&self) -> usize {
        self.shifts.len() - 1
    }

    /// The word of a monomial.
    #[cfg(test)]
    pub(crate) fn pack(&self, exponents: &[u32]) -> u128 {
        exponents.iter().zip(&self.shifts).map(|(&exponent, &shift)| u128::from(exponent) << shift).sum()
    }

    /// The word of a power of the variable `position`.
    pub(crate) fn power(&self, position: usize, exponent: u32) -> u128 {
        u128::from(exponent) << self.shifts[position]
    }

    /// The exponent of the variable `position`.
    pub(crate) fn exponent(&self, word: u128, position: usize) -> u32 {
        let below = if position == 0 { self.shifts[self.len()] } else { self.shifts[position - 1] };
        let bits = below - self.shifts[position];
        // The mask leaves at most 32 bits.
        (word >> self.shifts[position] & ((1 << bits) - 1)) as u32
    }

    /// The word with the exponents of `position` and all later variables cleared.
    fn prefix(&self, word: u128, position: usize) -> u128 {
        let below = if position == 0 { self.shifts[self.len()] } else { self.shifts[position - 1] };
        if below == 128 { 0 } else { word >> below << below }
    }
}

/// A polynomial over F_p: words of a [`Layout`], strictly descending, with nonzero coefficients.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Multivariate {
    terms: Vec<(u128, Residue)>,
}

impl Multivariate {
    /// The sum of these terms, whose words may repeat and stand in any order.
    pub(crate) fn new(field: &PrimeField, mut terms: Vec<(u128, Residue)>) -> Self {
        if !terms.is_sorted_by(|a, b| a.0 > b.0) {
            terms.sort_unstable_by_key(|term| std::cmp::Reverse(term.0));
            terms.dedup_by(|next, kept| {
                let same = next.0 == kept.0;
                if same {
                    kept.1 = field.add(kept.1, next.1);
                }
                same
            });
        }
        terms.retain(|term| !term.1.is_zero());
        Self { terms }
    }

    /// A constant.
    pub(crate) fn constant(value: Residue) -> Self {
        Self { terms: if value.is_zero() { Vec::new() } else { vec![(0, value)] } }
    }

    /// The terms, in descending order of their words.
    pub(crate) fn terms(&self) -> &[(u128, Residue)] {
        &self.terms
    }

    /// Whether this is the zero polynomial.
    pub(crate) fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The word of the leading monomial; zero for the zero polynomial too.
    pub(crate) fn leading_word(&self) -> u128 {
        self.terms.first().map_or(0, |term| term.0)
    }

    /// Whether this is constant (zero included).
    pub(crate) fn is_constant(&self) -> bool {
        self.leading_word() == 0
    }

    /// The polynomial divided by its leading coefficient; zero stays zero.
    pub(crate) fn monic(&self, field: &PrimeField) -> Self {
        let leading = self.terms.first().map_or(Residue::ZERO, |term| term.1);
        field.invert(leading).map_or_else(Self::default, |inverse| self.scale(field, inverse))
    }

    /// The polynomial times a nonzero constant.
    pub(crate) fn scale(&self, field: &PrimeField, factor: Residue) -> Self {
        Self { terms: self.terms.iter().map(|&(word, value)| (word, field.mul(value, factor))).collect() }
    }

    /// The degree in the variable `position`; zero for the zero polynomial.
    pub(crate) fn degree(&self, layout: &Layout, position: usize) -> u32 {
        self.terms.iter().map(|&(word, _)| layout.exponent(word, position)).max().unwrap_or(0)
    }

    /// The image in `F_p[x]`, x the variable `position`, for the given values of all other variables.
    pub(crate) fn univariate_image(
        &self,
        field: &PrimeField,
        layout: &Layout,
        position: usize,
        point: &[Residue],
    ) -> Univariate {
        budget::spend((self.terms.len() * layout.len()) as u64);
        let powers: Vec<Vec<Residue>> =
            (0..layout.len()).map(|i| powers(field, point[i], self.degree(layout, i))).collect();
        let mut image = vec![Residue::ZERO; self.degree(layout, position) as usize + 1];
        for &(word, coefficient) in &self.terms {
            let mut value = coefficient;
            for (i, powers) in powers.iter().enumerate() {
                let exponent = layout.exponent(word, i);
                if i != position && exponent > 0 {
                    value = field.mul(value, powers[exponent as usize]);
                }
            }
            let target = &mut image[layout.exponent(word, position) as usize];
            *target = field.add(*target, value);
        }
        Univariate::new(image)
    }

    /// For each variable the [image](Multivariate::univariate_image) where all others are set to their coordinates of
    /// `point`.
    ///
    /// Each term is evaluated at the point once: for a variable the power of its coordinate is divided out again.
    pub(crate) fn univariate_images(
        &self,
        field: &PrimeField,
        layout: &Layout,
        point: &[Residue],
    ) -> Vec<Univariate> {
        let count = layout.len();
        budget::spend((self.terms.len() * count) as u64);
        let degrees: Vec<u32> = (0..count).map(|i| self.degree(layout, i)).collect();
        let inverses: Option<Vec<Residue>> = point.iter().map(|&value| field.invert(value)).collect();
        let Some(inverses) = inverses else {
            return (0..count).map(|i| self.univariate_image(field, layout, i, point)).collect();
        };
        let table = |bases: &[Residue]| -> Vec<Vec<Residue>> {
            bases.iter().zip(&degrees).map(|(&base, &degree)| powers(field, base, degree)).collect()
        };
        let (powers, divisors) = (table(point), table(&inverses));
        let mut images: Vec<Vec<Residue>> =
            degrees.iter().map(|&degree| vec![Residue::ZERO; degree as usize + 1]).collect();
        let mut exponents = vec![0_usize; count];
        for &(word, coefficient) in &self.terms {
            let mut value = coefficient;
            for i in 0..count {
                let exponent = layout.exponent(word, i) as usize;
                exponents[i] = exponent;
                if exponent > 0 {
                    value = field.mul(value, powers[i][exponent]);
                }
            }
            for i in 0..count {
                let exponent = exponents[i];
                let part = if exponent > 0 { field.mul(value, divisors[i][exponent]) } else { value };
                images[i][exponent] = field.add(images[i][exponent], part);
            }
        }
        images.into_iter().map(Univariate::new).collect()
    }

    /// The quotient by a nonzero polynomial, if it divides; `bounds` are the differences of the degrees.
    ///
    /// The products of terms are merged by a heap, which holds at most one for each term of the divisor.
    pub(crate) fn quotient(
        &self,
        field: &PrimeField,
        layout: &Layout,
        divisor: &Self,
        bounds: &[u32],
    ) -> Option<Self> {
        let (&(leading, first), tail) = divisor.terms.split_first()?;
        let inverse = field.invert(first)?;
        let mut quotient: Vec<(u128, Residue)> = Vec::new();
        let mut heap = ProductHeap::default();
        // Terms of the tail whose next partner is not known yet.
        let mut waiting: Vec<usize> = (0..tail.len()).collect();
        let mut own = 0;
        loop {
            let word = self.terms.get(own).map(|term| term.0).max(heap.top().map(|product| product.word));
            let Some(word) = word else { return Some(Self { terms: quotient }) };
            let mut value = Residue::ZERO;
            if let Some(term) = self.terms.get(own).filter(|term| term.0 == word) {
                value = term.1;
                own += 1;
            }
            while let Some(NextProduct { divisor: j, quotient: i, .. }) = heap.top_at(word) {
                value = field.sub(value, field.mul(tail[j].1, quotient[i].1));
                if let Some(partner) = quotient.get(i + 1) {
                    heap.replace_top(NextProduct {
                        word: tail[j].0 + partner.0,
                        divisor: j,
                        quotient: i + 1,
                    });
                } else {
                    heap.pop();
                    waiting.push(j);
                }
            }
            if value.is_zero() {
                continue;
            }
            budget::spend(divisor.terms.len() as u64);
            // Within the bounds no product of a term with one of the divisor leaves the layout.
            let exponent = |i: usize| layout.exponent(word, i).checked_sub(layout.exponent(leading, i));
            if !(0..layout.len()).all(|i| exponent(i).is_some_and(|exponent| exponent <= bounds[i])) {
                return None;
            }
            let position = quotient.len();
            quotient.push((word - leading, field.mul(value, inverse)));
            for j in waiting.drain(..) {
                heap.push(NextProduct { word: tail[j].0 + (word - leading), divisor: j, quotient: position });
            }
        }
    }

    /// The greatest common divisor, with leading coefficient 1; zero only of two zeros.
    ///
    /// Brown's evaluation and interpolation (*On Euclid's algorithm and the computation of polynomial greatest common
    /// divisors*, 1971; Geddes, Czapor, Labahn, *Algorithms for Computer Algebra*, Algorithm 7.2), from the last
    /// variable to the first, with a sparse shortcut (`Skeleton`). `bounds` holds the degree of the result in each variable, or more. The result is right
    /// unless all points that were tried are unlucky in the same way, so the reader certifies it.
    pub(crate) fn gcd(&self, field: &PrimeField, layout: &Layout, other: &Self, bounds: &[u32]) -> Self {
        Divisor { field, layout, bounds, points: Points::new(field) }.gcd(self, other)
    }

    /// The coefficients as polynomials in the variable `position`, none later than which occurs, by descending monomial
    /// of the variables before it.
    fn split(&self, layout: &Layout, position: usize) -> Vec<(u128, Univariate)> {
        let prefix = |word| layout.prefix(word, position);
        let groups = self.terms.chunk_by(|a, b| prefix(a.0) == prefix(b.0));
        let collect = |group: &[(u128, Residue)]| {
            let mut coefficients = vec![Residue::ZERO; layout.exponent(group[0].0, position) as usize + 1];
            for &(word, coefficient) in group {
                coefficients[layout.exponent(word, position) as usize] = coefficient;
            }
            (prefix(group[0].0), Univariate::new(coefficients))
        };
        groups.map(collect).collect()
    }

    /// The inverse of [`Multivariate::split`].
    fn join(layout: &Layout, position: usize, parts: &[(u128, Univariate)]) -> Self {
        let mut terms = Vec::new();
        for (prefix, part) in parts {
            for (exponent, &coefficient) in part.coefficients().iter().enumerate().rev() {
                if !coefficient.is_zero() {
                    terms.push((prefix | (exponent as u128) << layout.shifts[position], coefficient));
                }
            }
        }
        Self { terms }
    }
}

/// The powers 0 … `highest` of `base`.
pub(crate) fn powers(field: &PrimeField, base: Residue, highest: u32) -> Vec<Residue> {
    let mut powers = vec![field.one()];
    for i in 0..highest as usize {
        powers.push(field.mul(powers[i], base));
    }
    powers
}

/// A reproducible stream of evaluation points without visible structure (Steele, Lea, Flood, *SplitMix*, 2014).
#[derive(Clone, Debug)]
pub(crate) struct Points {
    field: PrimeField,
    state: u64,
}

impl Points {
    /// The stream that belongs to `field`.
    pub(crate) fn new(field: &PrimeField) -> Self {
        Self { field: *field, state: field.modulus() }
    }

    /// The next point.
    pub(crate) fn next(&mut self) -> Residue {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut word = self.state;
        word = (word ^ (word >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        word = (word ^ (word >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        self.field.residue_of_word(word ^ (word >> 31))
    }

    /// The next `count` points.
    pub(crate) fn take(&mut self, count: usize) -> Vec<Residue> {
        (0..count).map(|_| self.next()).collect()
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
        let union = [a, b].into_iter().flat_map(|p| &p.terms).fold(0, |union, term| union | term.0);
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
        for &(word, coefficient) in &b.terms {
            let exponent = self.layout.exponent(word, position);
            let cleared = word - (u128::from(exponent) << self.layout.shifts[position]);
            coefficients.entry(exponent).or_default().push((cleared, coefficient));
        }
        let mut coefficients: Vec<_> =
            coefficients.into_values().map(|terms| Multivariate { terms }).collect();
        coefficients.sort_by_key(|coefficient| coefficient.terms.len());
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
    Multivariate { terms: terms.filter(|term| !term.1.is_zero()).collect() }
}

/// The polynomial in one more variable that has these images.
fn interpolate(field: &PrimeField, collected: &Images) -> Vec<(u128, Univariate)> {
    let mut values: BTreeMap<u128, Vec<Residue>> = BTreeMap::new();
    for (i, image) in collected.images.iter().enumerate() {
        for &(word, value) in &image.terms {
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

    use super::*;

    const VARIABLES: usize = 3;

    fn field() -> PrimeField {
        PrimeField::new(1_000_003).unwrap()
    }

    fn layout() -> Layout {
        Layout::new(&[30; VARIABLES]).unwrap()
    }

    fn polynomial(terms: &[([u32; VARIABLES], i64)]) -> Multivariate {
        let layout = layout();
        let terms = terms.iter().map(|(exponents, value)| (layout.pack(exponents), field().residue(*value)));
        Multivariate::new(&field(), terms.collect())
    }

    fn polynomials(most: usize) -> impl Strategy<Value = Multivariate> {
        let term = ([0_u32..3, 0_u32..3, 0_u32..3], -4_i64..=4);
        prop::collection::vec(term, 1..most).prop_map(|terms| polynomial(&terms))
    }

    fn product(a: &Multivariate, b: &Multivariate) -> Multivariate {
        let field = field();
        let pairs =
            a.terms.iter().flat_map(|x| b.terms.iter().map(move |y| (x.0 + y.0, field.mul(x.1, y.1))));
        Multivariate::new(&field, pairs.collect())
    }

    /// The quotient by the naive division of leading terms, if it is exact.
    fn naive_quotient(a: &Multivariate, b: &Multivariate) -> Option<Multivariate> {
        let (field, layout) = (field(), layout());
        let mut rest = a.clone();
        let mut terms = Vec::new();
        let inverse = field.invert(b.terms[0].1).unwrap();
        while !rest.is_zero() {
            let (word, value) = rest.terms[0];
            let divides = |i| layout.exponent(word, i) >= layout.exponent(b.leading_word(), i);
            if !(0..VARIABLES).all(divides) {
                return None;
            }
            let term = (word - b.leading_word(), field.mul(value, inverse));
            terms.push(term);
            let minus = product(&Multivariate { terms: vec![(term.0, field.neg(term.1))] }, b);
            rest = Multivariate::new(&field, [rest.terms, minus.terms].concat());
        }
        Some(Multivariate { terms })
    }

    /// The degrees that bound the gcd of two polynomials without any knowledge.
    fn trivial_bounds(a: &Multivariate, b: &Multivariate) -> Vec<u32> {
        let layout = layout();
        (0..VARIABLES).map(|i| a.degree(&layout, i).min(b.degree(&layout, i))).collect()
    }

    proptest! {
        #[test]
        fn images_of_one_evaluation_agree_with_single_ones(a in polynomials(8), point in [0_i64..50, 1_i64..50, 1_i64..50]) {
            let (field, layout) = (field(), layout());
            let point = point.map(|value| field.residue(value));
            let single = |i: usize| a.univariate_image(&field, &layout, i, &point);
            let expected: Vec<Univariate> = (0..VARIABLES).map(single).collect();
            prop_assert_eq!(a.univariate_images(&field, &layout, &point), expected);
        }
    }

    #[test]
    fn words_pack_and_unpack() {
        let layout = Layout::new(&[3, 0, 255, 1 << 20]).unwrap();
        let word = layout.pack(&[2, 1, 200, 1 << 20]);
        assert_eq!((0..4).map(|i| layout.exponent(word, i)).collect::<Vec<_>>(), [2, 1, 200, 1 << 20]);
        assert_eq!(layout.prefix(word, 2), layout.pack(&[2, 1, 0, 0]));
        assert_eq!(layout.prefix(word, 0), 0);
        let full = Layout::new(&[u32::MAX; 4]).unwrap();
        assert_eq!(full.exponent(full.pack(&[u32::MAX, 0, 0, 7]), 0), u32::MAX);
        assert_eq!(full.prefix(u128::MAX, 0), 0);
        assert_eq!(Layout::new(&[u32::MAX; 5]), None);
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

        #[test]
        fn quotients_agree_with_the_naive_division(a in polynomials(6), b in polynomials(6), r in polynomials(3)) {
            let (field, layout) = (field(), layout());
            prop_assume!(!b.is_zero());
            let exact = product(&a, &b);
            let inexact = Multivariate::new(&field, [exact.terms.clone(), r.terms].concat());
            for dividend in [exact, inexact] {
                let degree = |poly: &Multivariate, i| poly.degree(&layout, i);
                let bounds: Vec<u32> =
                    (0..VARIABLES).map(|i| degree(&dividend, i).saturating_sub(degree(&b, i))).collect();
                prop_assert_eq!(dividend.quotient(&field, &layout, &b, &bounds), naive_quotient(&dividend, &b));
            }
        }

        #[test]
        fn images_in_one_variable(a in polynomials(6), point in prop::array::uniform3(-50_i64..50)) {
            let (field, layout) = (field(), layout());
            let point = point.map(|value| field.residue(value));
            let value = |image: Univariate, i: usize| image.evaluate(&field, point[i]);
            let values: Vec<_> =
                (0..VARIABLES).map(|i| value(a.univariate_image(&field, &layout, i, &point), i)).collect();
            prop_assert_eq!(values[0], values[1]);
            prop_assert_eq!(values[0], values[2]);
        }
    }
}
