//! Images of polynomials in one variable modulo a prime, with numbers for all other variables.

use super::ring::Ring;
use super::{Poly, Term, terms};
use crate::budget;
use crate::modular::field::{PrimeField, Residue};
use crate::modular::lift::Modulo;
use crate::modular::multivariate::{Points, powers};
use crate::modular::univariate::Univariate;

/// A homomorphism to a prime field: values for all variables of a ring and for the generators of its number field.
///
/// Neighboring terms share most exponents, so the products of powers before the first exponent that differs are kept: about two
/// products modulo the prime for each term (compare Monagan and Tuncer, *Sparse multivariate Hensel lifting*, 2018, on the cost
/// of evaluation).
pub(super) struct Evaluation<'a> {
    ring: &'a Ring,
    field: PrimeField,
    /// Shift, mask and value for each variable, then for each generator, the most significant first.
    places: Vec<(u32, u128, Residue)>,
    /// The place of each bit of a word.
    place_of_bit: [u8; 128],
}

impl<'a> Evaluation<'a> {
    /// Values without structure for the variables, and the given ones for the generators, in their order.
    pub(super) fn new(ring: &'a Ring, field: &PrimeField, generators: &[Residue]) -> Evaluation<'a> {
        let mut points = Points::new(field);
        let values =
            (0..ring.variables().len()).map(|_| points.next()).chain(generators.iter().rev().copied());
        let fields = ring.fields();
        let places: Vec<_> =
            fields.into_iter().zip(values).map(|((shift, mask), value)| (shift, mask, value)).collect();
        let mut place_of_bit = [0; 128];
        for (place, &(shift, mask, _)) in places.iter().enumerate() {
            for bit in shift..shift + mask.count_ones() {
                place_of_bit[bit as usize] = place as u8;
            }
        }
        Evaluation { ring, field: *field, places, place_of_bit }
    }

    /// The powers of the values up to the largest exponents in `terms`; for the variable at `skipped`, those of 1.
    fn powers(&self, terms: &[Term], skipped: Option<usize>) -> Vec<Vec<Residue>> {
        let most = terms::maximum(self.ring, terms);
        let places = self.places.iter().enumerate();
        let table = |(place, &(shift, mask, value)): (usize, &(u32, u128, Residue))| {
            let value = if Some(place) == skipped { self.field.one() } else { value };
            // An exponent has at most 20 bits.
            powers(&self.field, value, (most >> shift & mask) as u32)
        };
        places.map(table).collect()
    }

    /// Shows each term's word and value to `visit`.
    fn walk(&self, terms: &[Term], powers: &[Vec<Residue>], mut visit: impl FnMut(u128, Residue)) {
        let (field, places) = (&self.field, self.places.as_slice());
        budget::spend(terms.len() as u64);
        // The products of the powers of all values before a place.
        let mut products = vec![field.one(); places.len() + 1];
        let (mut last, mut i) = (None, 0);
        while i < terms.len() {
            let word = terms[i].monomial.0;
            let mut place = match last {
                None => 0,
                // Distinct words differ.
                Some(last) => {
                    let difference: u128 = word ^ last;
                    usize::from(self.place_of_bit[127 - difference.leading_zeros() as usize])
                }
            };
            while place < places.len() {
                let (shift, mask, _) = places[place];
                let exponent = (word >> shift & mask) as usize;
                products[place + 1] = if exponent == 0 {
                    products[place]
                } else {
                    field.mul(products[place], powers[place][exponent])
                };
                place += 1;
            }
            visit(word, field.mul(products[place], terms[i].coefficient.modulo(field)));
            last = Some(word);
            i += 1;
        }
    }

    /// The image of the primitive part in the variable at `position`.
    pub(super) fn image(&self, poly: &Poly, position: usize) -> Univariate {
        let powers = self.powers(&poly.terms, Some(position));
        let (shift, mask, _) = self.places[position];
        let mut image = vec![Residue::ZERO; powers[position].len()];
        self.walk(&poly.terms, &powers, |word, value| {
            let target = &mut image[(word >> shift & mask) as usize];
            *target = self.field.add(*target, value);
        });
        Univariate::new(image)
    }

    /// The images of the primitive part in each variable of the ring.
    ///
    /// Each term is evaluated once: for a variable the power of its value is divided out again.
    pub(super) fn images(&self, poly: &Poly) -> Vec<Univariate> {
        let count = self.ring.variables().len();
        let values: Vec<Residue> = self.places[..count].iter().map(|place| place.2).collect();
        let inverses: Option<Vec<Residue>> = values.iter().map(|&value| self.field.invert(value)).collect();
        let Some(inverses) = inverses else {
            return (0..count).map(|position| self.image(poly, position)).collect();
        };
        let tables = self.powers(&poly.terms, None);
        let divisors: Vec<Vec<Residue>> = inverses
            .iter()
            .zip(&tables)
            .map(|(&inverse, table)| powers(&self.field, inverse, table.len() as u32 - 1))
            .collect();
        let mut images: Vec<Vec<Residue>> =
            divisors.iter().map(|table| vec![Residue::ZERO; table.len()]).collect();
        let occurring: Vec<usize> = (0..count).filter(|&i| images[i].len() > 1).collect();
        let mut total = Residue::ZERO;
        self.walk(&poly.terms, &tables, |word, value| {
            total = self.field.add(total, value);
            for &i in &occurring {
                let (shift, mask, _) = self.places[i];
                let exponent = (word >> shift & mask) as usize;
                let part = if exponent > 0 { self.field.mul(value, divisors[i][exponent]) } else { value };
                images[i][exponent] = self.field.add(images[i][exponent], part);
            }
        });
        for image in images.iter_mut().filter(|image| image.len() == 1) {
            image[0] = total;
        }
        images.into_iter().map(Univariate::new).collect()
    }
}

/// Whether an image modulo a prime proves that `b` does not divide `a`, over the rationals.
///
/// A divisor of `a` has an image that divides that of `a`, unless this image is zero. Complexity: some two products modulo a prime
/// for each term; where the division of the images would take much more than that, nothing is tried. A divisor that does not
/// divide passes with a probability of about 2⁻⁶⁰.
pub(super) fn image_excludes(a: &Poly, b: &Poly) -> bool {
    let Some(field) = PrimeField::sequence().next() else { return false };
    let degrees = a.degrees().into_iter().zip(b.degrees()).enumerate();
    let cost = |(position, (a, b)): (usize, (u32, u32))| {
        let steps = u64::from(a.saturating_sub(b)) + 1;
        (b > 0).then_some((steps * u64::from(b), position))
    };
    let Some((cost, position)) = degrees.filter_map(cost).min() else { return false };
    if cost > PRODUCTS_PER_TERM * (a.terms.len() + b.terms.len()) as u64 {
        return false;
    }
    let evaluation = Evaluation::new(&a.ring, &field, &[]);
    let divisor = evaluation.image(b, position);
    let remainder = evaluation.image(a, position).divide(&field, &divisor);
    remainder.is_some_and(|(_, remainder)| !remainder.is_zero())
}

/// The division of two images may take so many products for each term that was evaluated.
const PRODUCTS_PER_TERM: u64 = 8;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::{Variable, integer};

    proptest! {
        #[test]
        fn images_are_those_of_the_naive_evaluation(
            terms in prop::collection::vec((0_u32..5, 0_u32..3, 0_u32..4, 0_u32..2, -9_i64..=9), 1..30)
        ) {
            let variables = [0, 1, 2].map(|rank| Variable::new(rank, "x"));
            let root = Poly::sqrt_of(&integer(2));
            let term = |&(i, j, k, root_exponent, value): &(u32, u32, u32, u32, i64)| {
                let powers = variables.iter().zip([i, j, k]).map(|(variable, exponent)| Poly::variable(variable).pow(exponent));
                powers.product::<Poly>() * root.pow(root_exponent) * Poly::integer(value)
            };
            let all: Poly = variables.iter().map(Poly::variable).product::<Poly>() * &root;
            let poly = (terms.iter().map(term).sum::<Poly>() + &all).transfer(all.ring());
            prop_assume!(!poly.is_zero());
            let field = PrimeField::sequence().next().unwrap();
            // Any number will do where no rule is applied.
            let generator = field.residue(12345);
            let evaluation = Evaluation::new(poly.ring(), &field, &[generator]);
            let found = evaluation.images(&poly);
            for (position, image) in found.iter().enumerate() {
                prop_assert_eq!(image, &evaluation.image(&poly, position));
                let mut naive = vec![Residue::ZERO; 8];
                for term in poly.terms() {
                    let mut value = term.coefficient.modulo(&field);
                    for (other, place) in evaluation.places[..3].iter().enumerate().filter(|(other, _)| *other != position) {
                        let exponent = poly.ring().exponent(term.monomial, other);
                        value = field.mul(value, field.pow(place.2, exponent.into()));
                    }
                    let exponent = poly.ring().generator_exponent(term.monomial, 0);
                    value = field.mul(value, field.pow(generator, exponent.into()));
                    let target = &mut naive[poly.ring().exponent(term.monomial, position) as usize];
                    *target = field.add(*target, value);
                }
                prop_assert_eq!(image, &Univariate::new(naive));
            }
        }
    }

    #[test]
    fn images_of_high_degree_are_not_divided() {
        let [u, v] = [0, 1].map(|rank| Poly::variable(&Variable::new(rank, "x")));
        let sum = |x: &Poly, step: u32| (0..11).map(|i| x.pow(step * i)).sum::<Poly>();
        let quotient = sum(&u, 3000) * sum(&v, 2000);
        let divisor = u.pow(3000) + v.pow(2000) + Poly::one();
        let product = &quotient * &divisor;
        // Dense images would take 10⁸ products.
        assert_eq!(budget::with_budget(100_000, || product.exact_div(&divisor)), Ok(Some(quotient)));
    }

    #[test]
    fn images_exclude_what_does_not_divide() {
        let [u, v, a] = ["u", "v", "a"].map(|name| Poly::variable(&Variable::new(0, name)));
        let divisor = &u * &v - &a + Poly::integer(2);
        let product = (&divisor * (&u + &a).pow(3)).transfer(divisor.ring());
        assert!(!image_excludes(&product, &divisor));
        assert!(image_excludes(&(product + Poly::one()), &divisor));
    }
}
