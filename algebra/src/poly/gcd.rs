//! Greatest common divisors, certified by exact division.

use std::sync::Arc;

use num_integer::Integer;
use num_traits::One;

use super::evaluation::Evaluation;
use super::images::Frame;
use super::ring::{Monomial, Ring, Variable};
use super::{Poly, Term};
use crate::modular::field::PrimeField;
use crate::modular::lift::{Chinese, Modulo};
use crate::modular::multivariate::{Layout, Multivariate};
use crate::modular::splitting::Splitting;
use crate::{Int, Rational};

impl Poly {
    /// The greatest common divisor over the number field, [normalized](Poly::normalized): content 1, and the leading
    /// coefficient is a positive integer. It is zero only if both are zero; numbers divide everything, so the gcd with a
    /// nonzero number is 1.
    ///
    /// Common monomials and variables that cannot occur are split off first; images in one variable bound the degree in
    /// each variable, which certifies coprimality at once. What remains is computed modulo primes that split completely
    /// in the number field, under all their homomorphisms, by the interpolation of Brown (*On Euclid's algorithm and the
    /// computation of polynomial greatest common divisors*, 1971) and, where that is cheaper, Zippel (*Probabilistic
    /// algorithms for sparse polynomials*, 1979), lifted to the number field by Chinese remainders and
    /// rational reconstruction, and accepted only if it divides both (Encarnación, *Computing gcds of polynomials over
    /// algebraic number fields*, 1995). Complexity: for each prime at most one gcd in one variable for every point of a
    /// grid of the size of the gcd's degrees in the other variables; for a sparse gcd of t terms, some t for each degree.
    ///
    /// ```
    /// use hodograph_algebra::{Poly, Variable, integer};
    /// let (u, v) = (Poly::variable(&Variable::new(0, "u")), Poly::variable(&Variable::new(1, "v")));
    /// let a = (&u + &v) * (&u - &v);
    /// let b = (&u + &v).pow(2);
    /// assert_eq!(a.gcd(&b).to_string(), "u + v");
    /// let root = Poly::sqrt_of(&integer(2));
    /// assert_eq!((u.pow(2) - Poly::integer(2)).gcd(&(&u * &root - Poly::integer(2))), &u - &root);
    /// ```
    #[must_use]
    pub fn gcd(&self, other: &Poly) -> Poly {
        if self.is_zero() || other.is_zero() {
            return if self.is_zero() { other.normalized() } else { self.normalized() };
        }
        if self.is_constant() || other.is_constant() {
            return Poly::one();
        }
        let (a, b) = Poly::unify(self, other);
        let (a_monomial, a) = split_monomial(&a);
        let (b_monomial, b) = split_monomial(&b);
        let monomial = common_monomial(&a.ring, a_monomial, b_monomial);
        monomial * gcd_without_monomials(&a, &b)
    }

    /// The greatest common divisor of several polynomials, normalized as by [`Poly::gcd`]; zero if all are zero.
    ///
    /// ```
    /// use hodograph_algebra::{Poly, Variable};
    /// let u = Poly::variable(&Variable::new(0, "u"));
    /// assert_eq!(Poly::gcd_many(&[u.pow(3), &u * Poly::integer(6), Poly::zero()]), u);
    /// ```
    #[must_use]
    pub fn gcd_many(polys: &[Poly]) -> Poly {
        let mut nonzero: Vec<&Poly> = polys.iter().filter(|poly| !poly.is_zero()).collect();
        nonzero.sort_by_key(|poly| poly.terms.len());
        let mut gcd = Poly::zero();
        for poly in nonzero {
            if gcd.is_zero() || poly.exact_div(&gcd).is_none() {
                gcd = gcd.gcd(poly);
            }
            if gcd.is_one() {
                break;
            }
        }
        gcd
    }

    /// Whether no polynomial but numbers divides all of `polys`. This is a proof, either way.
    ///
    /// ```
    /// use hodograph_algebra::{Poly, Variable};
    /// let u = Poly::variable(&Variable::new(0, "u"));
    /// assert!(Poly::coprime(&[u.clone(), &u + Poly::one()]));
    /// assert!(!Poly::coprime(&[u.clone(), u.pow(2)]));
    /// ```
    #[must_use]
    pub fn coprime(polys: &[Poly]) -> bool {
        Poly::gcd_many(polys).is_one()
    }

    /// The content with respect to `variable`: the gcd of the coefficients of its powers, normalized as by
    /// [`Poly::gcd`].
    #[must_use]
    pub fn content_in(&self, variable: &Variable) -> Poly {
        Poly::gcd_many(&self.coefficients(variable))
    }

    /// The primitive part with respect to `variable`: `self` divided by [`Poly::content_in`]; zero for zero.
    #[must_use]
    pub fn primitive_in(&self, variable: &Variable) -> Poly {
        if self.is_zero() { self.clone() } else { exact_quotient(self, &self.content_in(variable)) }
    }
}

/// The quotient by a polynomial that is known to divide.
pub(crate) fn exact_quotient(dividend: &Poly, divisor: &Poly) -> Poly {
    dividend.exact_div(divisor).expect("a certified divisor divides")
}

/// The largest monomial in the variables that divides a nonzero polynomial, as exponents, and the quotient.
pub(crate) fn split_monomial(poly: &Poly) -> (Vec<u32>, Poly) {
    let ring = &poly.ring;
    let least = |i: usize| poly.terms.iter().map(|term| ring.exponent(term.monomial, i)).min().unwrap_or(0);
    let exponents: Vec<u32> = (0..ring.variables().len()).map(least).collect();
    if exponents.iter().all(|&exponent| exponent == 0) {
        return (exponents, poly.clone());
    }
    let word = ring.monomial(&exponents, &[]).0;
    let lower = |term: &Term| Term { monomial: Monomial(term.monomial.0 - word), ..term.clone() };
    let quotient = Poly { terms: poly.terms.iter().map(lower).collect(), ..poly.clone() };
    (exponents, quotient)
}

fn common_monomial(ring: &Arc<Ring>, a: Vec<u32>, b: Vec<u32>) -> Poly {
    let exponents: Vec<u32> = a.into_iter().zip(b).map(|(a, b)| a.min(b)).collect();
    let term = Term { monomial: ring.monomial(&exponents, &[]), coefficient: Int::ONE };
    Poly { ring: ring.clone(), content: Rational::one(), terms: vec![term] }
}

/// The gcd of polynomials of one ring that no variable divides.
fn gcd_without_monomials(a: &Poly, b: &Poly) -> Poly {
    if a.is_constant() || b.is_constant() {
        return Poly::one();
    }
    if a.terms == b.terms {
        return a.normalized();
    }
    let (a_degrees, b_degrees) = (a.degrees(), b.degrees());
    let most: Vec<u32> = a_degrees.iter().zip(&b_degrees).map(|(&a, &b)| a.max(b)).collect();
    let mut fields = PrimeField::sequence();
    loop {
        let bounds = degree_bounds(a, b, &mut fields);
        if bounds.iter().all(|&bound| bound == 0) {
            return Poly::one();
        }
        // One operand may be the gcd itself; its degrees tell when that is possible.
        for (divisor, degrees, dividend) in [(a, &a_degrees, b), (b, &b_degrees, a)] {
            if *degrees == bounds && dividend.exact_div(divisor).is_some() {
                return divisor.normalized();
            }
        }
        let free = |i: &usize| bounds[*i] == 0 && most[*i] > 0;
        let free: Vec<Variable> =
            (0..bounds.len()).filter(free).map(|i| a.ring.variables()[i].clone()).collect();
        if !free.is_empty() {
            // These variables do not occur in the gcd, which therefore divides all coefficients of their monomials.
            let coefficients = [a, b].into_iter().flat_map(|poly| poly.coefficients_of(&free).into_values());
            return Poly::gcd_many(&coefficients.collect::<Vec<_>>());
        }
        // Interpolation runs over all variables but the first, which therefore is one of the highest degree.
        let mut positions: Vec<usize> = (0..bounds.len()).filter(|&i| bounds[i] > 0).collect();
        positions.sort_by_key(|&i| std::cmp::Reverse(bounds[i]));
        if positions.len() > 2 {
            // Sparse interpolation needs a gcd that is primitive in the first variable.
            let main = &a.ring.variables()[positions[0]];
            let content = Poly::gcd_many(&[a.coefficients(main), b.coefficients(main)].concat());
            if !content.is_one() {
                let [a, b] = [a, b].map(|poly| exact_quotient(poly, &content));
                return content * a.gcd(&b);
            }
        }
        let pick = |values: &[u32]| positions.iter().map(|&i| values[i]).collect::<Vec<u32>>();
        let frame = Frame::new([a, b], positions.clone(), &pick(&most));
        if let Some((divisor, cofactors)) = modular_divisor(&frame, a, b, &pick(&bounds), &mut fields) {
            // A divisor that reaches the proved bounds is the greatest one; else the cofactors have the last word.
            let greatest = divisor.transfer_to(&a.ring).degrees() == bounds;
            return if greatest { divisor } else { divisor * cofactors[0].gcd(&cofactors[1]) };
        }
    }
}

/// Proved bounds for the degrees of the gcd in all variables of the ring, from an image modulo the next prime.
///
/// The gcd of images in x alone, where all else is replaced by numbers modulo p, has at least the degree in x of the
/// gcd, if the degree in x of one of the two operands is kept.
fn degree_bounds(a: &Poly, b: &Poly, fields: &mut impl Iterator<Item = PrimeField>) -> Vec<u32> {
    let (a_degrees, b_degrees) = (a.degrees(), b.degrees());
    let positions: Vec<usize> =
        (0..a_degrees.len()).filter(|&i| a_degrees[i] > 0 || b_degrees[i] > 0).collect();
    let most: Vec<u32> = positions.iter().map(|&i| a_degrees[i].max(b_degrees[i])).collect();
    let frame = Frame::new([a, b], positions.clone(), &most);
    let splitting = frame.splitting(fields);
    let field = splitting.field();
    let evaluation = Evaluation::new(&a.ring, field, &frame.generator_images(&splitting));
    let [a_images, b_images] = [a, b].map(|poly| evaluation.images(poly));
    let mut bounds = vec![0; a_degrees.len()];
    for position in positions {
        let least = a_degrees[position].min(b_degrees[position]);
        if least == 0 {
            continue;
        }
        let (a_image, b_image) = (&a_images[position], &b_images[position]);
        let kept = a_image.degree() == a_degrees[position] as usize
            || b_image.degree() == b_degrees[position] as usize;
        let found = a_image.gcd(field, b_image).degree();
        bounds[position] =
            if kept { u32::try_from(found).map_or(least, |found| found.min(least)) } else { least };
    }
    bounds
}

/// How many primes may disagree with the leading monomial that the others found, before all is tried again.
const MOST_MISSES: u32 = 4;

/// A common divisor of two polynomials in the variables of `frame`, not a number, with both cofactors: very likely the
/// greatest one, whose degrees are at most `bounds`. `None` where the images contradict these or each other.
fn modular_divisor(
    frame: &Frame,
    a: &Poly,
    b: &Poly,
    bounds: &[u32],
    fields: &mut impl Iterator<Item = PrimeField>,
) -> Option<(Poly, [Poly; 2])> {
    let (a_terms, b_terms) = (frame.terms(a), frame.terms(b));
    // The leading coefficient of the gcd divides this one, so with it the coefficients are integers.
    let scale = match (a_terms.leading_integer(), b_terms.leading_integer()) {
        (Some(a), Some(b)) => a.gcd(b),
        _ => Int::ONE,
    };
    let mut leading = u128::MAX;
    let mut known: Chinese<(u128, usize)> = Chinese::new();
    let mut refused = None;
    let mut misses = 0;
    while misses < MOST_MISSES {
        let splitting = frame.splitting(fields);
        let (a_images, b_images) = (a_terms.images(&splitting), b_terms.images(&splitting));
        let keeps = |images: &[Multivariate], word| images.iter().all(|image| image.leading_word() == word);
        if !keeps(&a_images, a_terms.leading_word()) || !keeps(&b_images, b_terms.leading_word()) {
            continue;
        }
        let images = gcd_images(&splitting, frame.layout(), &a_images, &b_images, bounds);
        // The leading monomial of an image is not smaller than that of the gcd, so the smallest is the best guess.
        let least = images.iter().map(Multivariate::leading_word).min().unwrap_or(0);
        if least == 0 {
            return None;
        }
        if least < leading {
            leading = least;
            known = Chinese::new();
            refused = None;
        }
        if !keeps(&images, leading) {
            misses += 1;
            continue;
        }
        let factor = scale.modulo(splitting.field());
        let images: Vec<Multivariate> =
            images.iter().map(|image| image.scale(splitting.field(), factor)).collect();
        known.absorb(splitting.field(), &splitting.lift_coefficients(&images));
        let Some(values) = known.reconstruct() else { continue };
        let candidate = frame.poly(values).normalized();
        if refused.as_ref() == Some(&candidate) {
            continue;
        }
        let cofactors = a.exact_div(&candidate).and_then(|first| Some([first, b.exact_div(&candidate)?]));
        if let Some(cofactors) = cofactors {
            return Some((candidate, cofactors));
        }
        refused = Some(candidate);
    }
    None
}

/// The monic gcds of corresponding images.
fn gcd_images(
    splitting: &Splitting,
    layout: &Layout,
    a: &[Multivariate],
    b: &[Multivariate],
    bounds: &[u32],
) -> Vec<Multivariate> {
    a.iter().zip(b).map(|(a, b)| a.gcd(splitting.field(), layout, b, bounds)).collect()
}
