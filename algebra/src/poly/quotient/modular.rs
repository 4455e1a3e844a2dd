//! Exact quotients of large polynomials, by way of primes.

use num_traits::{Signed, Zero};

use crate::Int;
use crate::modular::field::PrimeField;
use crate::modular::lift::Chinese;
use crate::poly::Poly;
use crate::poly::images::Frame;

/// The quotient of polynomials, if `divisor`, which is not zero, divides.
///
/// The images modulo primes, under all homomorphisms of the number field, are divided and lifted, as gcds are (von zur Gathen and
/// Gerhard, *Modern Computer Algebra*, chapter 6): coefficients of the field stay one word long on the way. A remainder modulo one
/// prime that keeps the leading coefficient of the divisor is a proof that it does not divide. Over the rationals the
/// quotient is certified by its size: the product with the divisor is congruent to the dividend modulo a number
/// larger than the difference can be. Over a number field it is multiplied out. Complexity: for each prime and
/// homomorphism one product and one step in a heap for each pair of a term of the quotient and one of the divisor.
pub(super) fn quotient(dividend: &Poly, divisor: &Poly) -> Option<Poly> {
    if dividend.is_zero() {
        return Some(Poly::zero());
    }
    let (a, b) = Poly::unify(dividend, divisor);
    let degrees: Vec<(u32, u32)> = a.degrees().into_iter().zip(b.degrees()).collect();
    if degrees.iter().any(|(dividend, divisor)| divisor > dividend) {
        return None;
    }
    let positions: Vec<usize> = (0..degrees.len()).filter(|&i| degrees[i].0 > 0).collect();
    let most: Vec<u32> = positions.iter().map(|&i| degrees[i].0).collect();
    let bounds: Vec<u32> = positions.iter().map(|&i| degrees[i].0 - degrees[i].1).collect();
    let frame = Frame::new([&a, &b], positions, &most);
    let (a_terms, b_terms) = (frame.terms(&a), frame.terms(&b));
    let content = &a.content / &b.content;
    let mut fields = PrimeField::sequence();
    let mut known: Chinese<(u128, usize)> = Chinese::new();
    loop {
        let splitting = frame.splitting(&mut fields);
        let residues = [&a_terms, &b_terms].map(|terms| terms.residues(&splitting));
        let mut images = Vec::new();
        // One homomorphism after the other: most divisors that do not divide fail at the first one.
        for choice in 0..splitting.basis().len() {
            let a_image = a_terms.image_of(&splitting, choice, &residues[0]);
            let b_image = b_terms.image_of(&splitting, choice, &residues[1]);
            if b_image.leading_word() != b_terms.leading_word() {
                break;
            }
            images.push(a_image.quotient(splitting.field(), frame.layout(), &b_image, &bounds)?);
        }
        if images.len() < splitting.basis().len() {
            continue;
        }
        known.absorb(splitting.field(), &splitting.lift_coefficients(&images));
        if frame.is_rational() {
            // Primitive integer polynomials have an integer quotient, by Gauss's lemma.
            let values = known.symmetric();
            let largest = |values: &mut dyn Iterator<Item = Int>| {
                values.fold(Int::zero(), |most, value| most.max(value.abs()))
            };
            let sizes =
                [&a, &b].map(|poly| largest(&mut poly.terms.iter().map(|term| term.coefficient.clone())));
            let count = Int::from(values.len().min(b.terms.len()) as u64);
            if &sizes[0] + count * &sizes[1] * largest(&mut values.values().cloned()) < *known.modulus() {
                return Some(frame.poly((values.into_iter().collect(), Int::ONE)).scale(&content));
            }
        } else if let Some(values) = known.reconstruct() {
            let quotient = frame.poly(values);
            if &quotient * b.primitive() == a.primitive() {
                return Some(quotient.scale(&content));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Variable, integer, ratio};

    fn operands() -> [Poly; 3] {
        let [u, v, a] = ["u", "v", "a"].map(|name| Poly::variable(&Variable::new(0, name)));
        let large = Poly::integer(10).pow(30) + Poly::constant(ratio(1, 3));
        [
            (&u * &v - &a + Poly::integer(2)).pow(3) * &large,
            (&u * &a * Poly::integer(7) + &v * &v - Poly::constant(ratio(5, 2))).pow(2),
            u + v.pow(3) * &a * &large - Poly::one(),
        ]
    }

    fn check(factors: &[Poly]) {
        for a in factors {
            for b in factors {
                let product = a * b;
                assert_eq!(quotient(&product, b), product.exact_div(b));
                assert_eq!(quotient(&product, b).as_ref(), Some(a));
                assert_eq!(quotient(&(&product + Poly::one()), b), None);
                assert_eq!(quotient(a, &product), None);
            }
        }
    }

    #[test]
    fn agrees_with_the_division_of_terms_over_the_rationals() {
        check(&operands());
        assert_eq!(quotient(&Poly::zero(), &operands()[0]), Some(Poly::zero()));
    }

    #[test]
    fn agrees_with_the_division_of_terms_over_a_number_field() {
        let root = Poly::sqrt_of(&integer(2));
        let theta = (Poly::integer(110) + &root * Poly::integer(100)).sqrt().expect("a positive number");
        let [a, b, c] = operands();
        check(&[&a * &root + &b, &b + &c * &theta, &c * (&root - Poly::integer(1)) + &theta * &a]);
        // (1 + √5)/2 is integral: quotients of primitive polynomials need not have integer coefficients.
        let golden = (Poly::sqrt_of(&integer(5)) + Poly::one()).scale(&ratio(1, 2));
        check(&[&a + &b * &golden, &c * &golden + Poly::integer(3)]);
    }
}
