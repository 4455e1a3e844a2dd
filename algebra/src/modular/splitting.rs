//! Primes that split completely in a tower of quadratic extensions, and the images of its elements.

use std::collections::BTreeMap;

use super::field::{PrimeField, Residue};
use super::lift::Modulo;
use super::multivariate::Multivariate;
use crate::Int;

/// The rule g² = r of a generator: the terms of r, each with the exponents (0 or 1) of the earlier generators.
pub(crate) type Radicand = Vec<(Vec<u32>, Int)>;

/// All homomorphisms from Z[g₁, …, gₙ], gᵢ² = rᵢ(g₁, …, gᵢ₋₁), to a prime field where every rᵢ is a nonzero square.
///
/// There are 2ⁿ of them, one for each choice of signs. A basis element g₁^e₁…gₙ^eₙ has the index Σ eᵢ·2^(n−i).
/// Since p is odd and divides no discriminant of the tower, the homomorphisms are the residue maps of the primes over
/// p, and the tower is integrally closed there: Gauss's lemma holds for each of them.
///
/// One prime in 2ⁿ splits, or fewer; in return all arithmetic is that of F_p. Other primes would ask for arithmetic in residue
/// rings with zero divisors (van Hoeij and Monagan, *A modular GCD algorithm over number fields presented with multiple
/// extensions*, 2002).
#[derive(Clone, Debug)]
pub(crate) struct Splitting {
    field: PrimeField,
    /// `roots[i][prefix]` is the positive choice for generator i, where `prefix` are the choices for those before it.
    roots: Vec<Vec<Residue>>,
    /// `basis[choice][index]` is the image of a basis element.
    basis: Vec<Vec<Residue>>,
}

impl Splitting {
    /// The homomorphisms to `field`; `None` if a radicand is zero or not a square for some choice of signs.
    pub(crate) fn new(field: PrimeField, radicands: &[Radicand]) -> Option<Self> {
        let mut roots = Vec::with_capacity(radicands.len());
        let mut choices: Vec<Vec<Residue>> = vec![Vec::new()];
        for radicand in radicands {
            let level =
                choices.iter().map(|values| root(&field, radicand, values)).collect::<Option<Vec<_>>>()?;
            let signs = |(values, &root): (&Vec<Residue>, &Residue)| {
                [root, field.neg(root)].map(|root| values.iter().copied().chain([root]).collect())
            };
            choices = choices.iter().zip(&level).flat_map(signs).collect();
            roots.push(level);
        }
        let product = |values: &[Residue], index: usize| {
            let factor =
                |(i, &value): (usize, &Residue)| (index >> (values.len() - 1 - i) & 1 == 1).then_some(value);
            values
                .iter()
                .enumerate()
                .filter_map(factor)
                .fold(field.one(), |product, value| field.mul(product, value))
        };
        let images =
            |values: &Vec<Residue>| (0..1 << radicands.len()).map(|index| product(values, index)).collect();
        let basis = choices.iter().map(images).collect();
        Some(Self { field, roots, basis })
    }

    /// The prime field.
    pub(crate) fn field(&self) -> &PrimeField {
        &self.field
    }

    /// For each homomorphism the images of all basis elements, by index.
    pub(crate) fn basis(&self) -> &[Vec<Residue>] {
        &self.basis
    }

    /// The polynomial that has these images under all homomorphisms: nonzero coordinates of its coefficients, by word of
    /// the monomial and index of the basis element.
    pub(crate) fn lift_coefficients(&self, images: &[Multivariate]) -> BTreeMap<(u128, usize), Residue> {
        let mut values: BTreeMap<u128, Vec<Residue>> = BTreeMap::new();
        for (choice, image) in images.iter().enumerate() {
            for &(word, value) in image.terms() {
                values.entry(word).or_insert_with(|| vec![Residue::ZERO; images.len()])[choice] = value;
            }
        }
        let mut result = BTreeMap::new();
        for (word, mut values) in values {
            self.coordinates(&mut values);
            let nonzero = values.into_iter().enumerate().filter(|(_, value)| !value.is_zero());
            result.extend(nonzero.map(|(index, value)| ((word, index), value)));
        }
        result
    }

    /// Replaces the images of an element under all homomorphisms by its coordinates modulo p, by index.
    ///
    /// A transform like Hadamard's, one generator at a time from the last one: x = a + b·g has the images a ± b·ρ.
    fn coordinates(&self, images: &mut [Residue]) {
        let field = &self.field;
        let half = field.invert(field.residue(2)).unwrap_or_default();
        for (i, level) in self.roots.iter().enumerate().rev() {
            let stride = 1 << (self.roots.len() - 1 - i);
            for (block, &root) in images.chunks_mut(2 * stride).zip(level) {
                let scale = field.mul(half, field.invert(root).unwrap_or_default());
                let (plus, minus) = block.split_at_mut(stride);
                for (plus, minus) in plus.iter_mut().zip(minus) {
                    let (sum, difference) = (field.add(*plus, *minus), field.sub(*plus, *minus));
                    (*plus, *minus) = (field.mul(sum, half), field.mul(difference, scale));
                }
            }
        }
    }
}

/// A square root of the image of a radicand, if that is a nonzero square.
fn root(field: &PrimeField, radicand: &Radicand, values: &[Residue]) -> Option<Residue> {
    let term = |(exponents, coefficient): &(Vec<u32>, Int)| {
        let powers =
            exponents.iter().zip(values).map(|(&exponent, &value)| field.pow(value, exponent.into()));
        powers.fold(coefficient.modulo(field), |product, power| field.mul(product, power))
    };
    let image = radicand.iter().map(term).fold(Residue::ZERO, |sum, value| field.add(sum, value));
    field.sqrt(image).filter(|root| !root.is_zero())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// √2 and √(110 + 100√2).
    fn tower() -> Vec<Radicand> {
        let term = |exponents: &[u32], value: i64| (exponents.to_vec(), Int::from(value));
        vec![vec![term(&[], 2)], vec![term(&[0], 110), term(&[1], 100)]]
    }

    #[test]
    fn images_respect_the_rules_and_come_back() {
        let splitting = PrimeField::sequence().find_map(|field| Splitting::new(field, &tower())).unwrap();
        let field = splitting.field();
        assert_eq!(splitting.basis().len(), 4);
        // 5 + 7θ − 3√2 + 11√2θ, whose coordinates stand in the order 1, θ, √2, √2θ.
        let coordinates = [5, 7, -3, 11].map(|value| field.residue(value));
        let image = |basis: &Vec<Residue>| {
            let products =
                basis.iter().zip(coordinates).map(|(&value, coordinate)| field.mul(value, coordinate));
            products.fold(Residue::ZERO, |sum, product| field.add(sum, product))
        };
        let mut images: Vec<Residue> = splitting.basis().iter().map(image).collect();
        for basis in splitting.basis() {
            let (theta, root) = (basis[1], basis[2]);
            assert_eq!(field.mul(root, root), field.residue(2));
            let radicand = field.add(field.residue(110), field.mul(field.residue(100), root));
            assert_eq!(field.mul(theta, theta), radicand);
            assert_eq!(basis[3], field.mul(theta, root));
        }
        splitting.coordinates(&mut images);
        assert_eq!(images, coordinates);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn coordinates_come_back_from_their_images(
            radicands in [1_i64..9, -9_i64..9, -9_i64..9],
            values in prop::collection::vec(any::<i64>(), 8),
        ) {
            // g₁² = r₁, g₂² = r₂ + g₁, g₃² = r₃ + g₁·g₂.
            let term = |exponents: &[u32], value: i64| (exponents.to_vec(), Int::from(value));
            let [first, second, third] = radicands;
            let tower = vec![
                vec![term(&[], first)],
                vec![term(&[0], second), term(&[1], 1)],
                vec![term(&[0, 0], third), term(&[1, 1], 1)],
            ];
            let mut fields = (10_000..100_000).filter_map(PrimeField::new);
            let Some(splitting) = fields.find_map(|field| Splitting::new(field, &tower)) else {
                return Err(TestCaseError::reject("a radicand is zero"));
            };
            let field = splitting.field();
            let coordinates: Vec<Residue> = values.iter().map(|&value| field.residue(value)).collect();
            let image = |basis: &Vec<Residue>| {
                let products = basis.iter().zip(&coordinates).map(|(&value, &coordinate)| field.mul(value, coordinate));
                products.fold(Residue::ZERO, |sum, product| field.add(sum, product))
            };
            let mut images: Vec<Residue> = splitting.basis().iter().map(image).collect();
            splitting.coordinates(&mut images);
            prop_assert_eq!(images, coordinates);
        }
    }

    #[test]
    fn primes_that_do_not_split_are_refused() {
        // 2 is a square modulo 7 but not modulo 5, and zero modulo 2 alone; 7 divides the radicand 14.
        let radicand = |value: i64| vec![vec![(Vec::new(), Int::from(value))]];
        let field = |prime| PrimeField::new(prime).unwrap();
        assert!(Splitting::new(field(7), &radicand(2)).is_some());
        assert!(Splitting::new(field(5), &radicand(2)).is_none());
        assert!(Splitting::new(field(7), &radicand(14)).is_none());
        assert_eq!(Splitting::new(field(7), &[]).unwrap().basis(), [[field(7).one()]]);
    }
}
