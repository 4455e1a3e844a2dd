//! Cosines and sines of rational multiples of π that square roots can construct.

use std::fmt;

use num_integer::Integer;

use super::complex::minimize_complex;
use crate::{Complex, Int, Poly, Rational, integer, minimize_field, ratio};

/// The largest power of two, as an exponent, in the denominator of an angle over π.
pub const MAX_ANGLE_HALVINGS: u32 = 10;

/// The Fermat primes that a denominator may contain, each at most once.
const FERMAT_PRIMES: [u32; 3] = [3, 5, 17];

/// The error of an angle whose cosine and sine are not offered as numbers of a tower of square roots.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotConstructible {
    /// The angle divided by π.
    pub angle: Rational,
}

impl fmt::Display for NotConstructible {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let angle = &self.angle;
        write!(
            f,
            "the angle ({angle})*pi is not available exactly: the denominator of angle/pi, here {}, must be a power of \
             two up to 2^{MAX_ANGLE_HALVINGS} times a product of distinct ones of 3, 5 and 17, as in pi/8, 2*pi/5 or \
             pi/12",
            angle.denom()
        )
    }
}

impl std::error::Error for NotConstructible {}

/// `exp(I·π·q) = cos(πq) + I·sin(πq)`.
///
/// The angle is reduced modulo 2π and halved back from a multiple of π over an odd denominator `m`; that one is a
/// product of powers of the roots of unity of the prime factors of `m` (Gauss, *Disquisitiones arithmeticae*, §§ 354
/// and 365).
///
/// # Errors
/// [`NotConstructible`] unless the denominator of `q` is `2^k` with `k ≤` [`MAX_ANGLE_HALVINGS`] times a product of
/// distinct ones of 3, 5 and 17.
///
/// # Example
/// ```
/// use hodograph_algebra::{exp_i_pi, ratio};
/// assert_eq!(exp_i_pi(&ratio(-3, 4)).unwrap().to_string(), "-1/2*sqrt2 + I*(-1/2*sqrt2)");
/// assert!(exp_i_pi(&ratio(1, 7)).unwrap_err().to_string().contains("here 7"));
/// ```
pub fn exp_i_pi(q: &Rational) -> Result<Complex, NotConstructible> {
    let halvings = halvings(q).ok_or_else(|| NotConstructible { angle: q.clone() })?;
    let [reduced] = minimize_complex(&[unit_at(&modulo_2(q), halvings)]);
    Ok(reduced)
}

/// `cos(πq)`, over the smallest field found that holds it.
///
/// # Errors
/// As [`exp_i_pi`].
///
/// # Example
/// ```
/// use hodograph_algebra::{cos_pi, ratio};
/// assert_eq!(cos_pi(&ratio(1, 5)).unwrap().to_string(), "1/4*sqrt5 + 1/4");
/// let cosine = cos_pi(&ratio(1, 8)).unwrap();
/// assert_eq!(cosine.to_string(), "1/2*theta");
/// assert_eq!(cosine.ring().field().relation(1).to_string(), "theta^2 - sqrt2 - 2");
/// ```
pub fn cos_pi(q: &Rational) -> Result<Poly, NotConstructible> {
    Ok(minimize_field(&[exp_i_pi(q)?.re]).swap_remove(0))
}

/// `sin(πq)`, over the smallest field found that holds it.
///
/// # Errors
/// As [`exp_i_pi`].
///
/// # Example
/// ```
/// use hodograph_algebra::{ratio, sin_pi};
/// assert_eq!(sin_pi(&ratio(-5, 6)).unwrap().to_string(), "-1/2");
/// ```
pub fn sin_pi(q: &Rational) -> Result<Poly, NotConstructible> {
    Ok(minimize_field(&[exp_i_pi(q)?.im]).swap_remove(0))
}

/// The exponent of 2 in the denominator of `q`, if the angle `πq` is one of those offered.
fn halvings(q: &Rational) -> Option<u32> {
    let mut odd = q.denom().clone();
    let mut halvings = 0;
    while odd.is_even() {
        halvings += 1;
        if halvings > MAX_ANGLE_HALVINGS {
            return None;
        }
        odd = odd.shr(1);
    }
    let largest = FERMAT_PRIMES.iter().product::<u32>();
    Int::from(largest).is_multiple_of(&odd).then_some(halvings)
}

/// `q` modulo 2, between −1 (excluded) and 1.
fn modulo_2(q: &Rational) -> Rational {
    let turns = ((integer(1) - q) * ratio(1, 2)).floor();
    q + turns * integer(2)
}

/// `exp(I·π·q)` for `−1 < q ≤ 1` with `halvings` factors 2 in its denominator.
fn unit_at(q: &Rational, halvings: u32) -> Complex {
    if halvings == 0 {
        return unit_at_odd(q);
    }
    // The principal root has its angle between −π/2 and π/2, the only one there that doubles to 2πq.
    let root = bisected(&unit_at(&modulo_2(&(q * integer(2))), halvings - 1));
    if *q > ratio(-1, 2) && *q <= ratio(1, 2) { root } else { -root }
}

/// The principal square root of a number of absolute value 1: `cos(α/2) = √((1 + cos α)/2)`, `sin(α/2) = sin α/(2·cos(α/2))`.
fn bisected(unit: &Complex) -> Complex {
    let square = (&unit.re + Poly::one()).scale(&ratio(1, 2));
    match square.sqrt() {
        Some(re) if !re.is_zero() => {
            let im = (&unit.im * square.inverse()).scale(&ratio(1, 2)) * &re;
            let [root] = minimize_complex(&[Complex::new(re, im)]);
            root
        }
        _ => unit.sqrt(),
    }
}

/// `exp(I·π·q)` for a denominator that divides 3·5·17.
fn unit_at_odd(q: &Rational) -> Complex {
    let order = q.denom();
    // exp(Iπ·n/m) = −exp(2πI·((n + m)/2)/m) for odd n and m.
    let odd = q.numer().is_odd();
    let steps = if odd { (q.numer() + order).shr(1) } else { q.numer().shr(1) };
    let mut unit = if odd { -Complex::one() } else { Complex::one() };
    for prime in FERMAT_PRIMES.iter().filter(|prime| order.is_multiple_of(&Int::from(**prime))) {
        // j/m is the sum of the e/p over its primes p with e·(m/p) ≡ j modulo p, up to an integer.
        let prime_int = Int::from(*prime);
        let cofactor = order / &prime_int;
        let solves = |e: &u32| (&cofactor * Int::from(*e) - &steps).is_multiple_of(&prime_int);
        unit = unit * root_of_unity(*prime).pow((0..*prime).find(solves).unwrap_or(0));
    }
    unit
}

/// `exp(2πI/p)` for a Fermat prime `p`.
fn root_of_unity(prime: u32) -> Complex {
    let root = |n: i64| Poly::sqrt_of(&integer(n));
    let nested = |number: &Poly| number.sqrt().unwrap_or_else(Poly::zero);
    let cosine = match prime {
        3 => Poly::constant(ratio(-1, 2)),
        5 => (root(5) - Poly::one()).scale(&ratio(1, 4)),
        _ => {
            // 16·cos(2π/17) = −1 + √17 + √(34 − 2√17) + 2·√(17 + 3√17 − √(34 − 2√17) − 2·√(34 + 2√17)).
            let whole = root(17);
            let minus = nested(&(Poly::integer(34) - whole.scale(&integer(2))));
            let plus = nested(&(Poly::integer(34) + whole.scale(&integer(2))));
            let inner = Poly::integer(17) + whole.scale(&integer(3)) - &minus - plus.scale(&integer(2));
            (whole - Poly::one() + minus + nested(&inner).scale(&integer(2))).scale(&ratio(1, 16))
        }
    };
    // The angle 2π/p is below π, so the sine is positive.
    let sine = nested(&(Poly::one() - &cosine * &cosine));
    Complex::new(cosine, sine)
}

#[cfg(test)]
mod tests {
    use std::cmp::Ordering;

    use super::*;

    /// The Chebyshev polynomial `T_n(x) = cos(n·arccos x)` by its recurrence.
    fn chebyshev(n: u32, x: &Poly) -> Poly {
        let (mut before, mut value) = (Poly::one(), x.clone());
        for _ in 1..n {
            let next = (x * &value).scale(&integer(2)) - &before;
            before = std::mem::replace(&mut value, next);
        }
        value
    }

    #[test]
    fn chebyshev_polynomials_confirm_the_cosines() {
        for denominator in [2_u32, 3, 4, 5, 6, 8, 10, 12, 15, 16, 17, 20, 24, 30] {
            let cosine = cos_pi(&ratio(1, i64::from(denominator))).unwrap();
            assert_eq!(chebyshev(denominator, &cosine), Poly::integer(-1), "cos(pi/{denominator})");
            // The largest root but one of T_d + 1 is cos(3π/d), so a large value is the right one.
            let next = cos_pi(&ratio(3, i64::from(denominator))).unwrap();
            assert_eq!(
                cosine.compare(&next),
                if denominator == 2 { Ordering::Equal } else { Ordering::Greater }
            );
        }
    }

    #[test]
    fn units_multiply_as_angles_add() {
        let angles = [ratio(7, 8), ratio(-5, 12), ratio(11, 10), ratio(123, 4), ratio(2, 3), ratio(-17, 6)];
        for a in &angles {
            let unit = exp_i_pi(a).unwrap();
            assert!(unit.norm2().is_one(), "cos^2 + sin^2 at {a}");
            assert_eq!(unit.conj(), exp_i_pi(&-a).unwrap());
            for b in &angles {
                assert_eq!(&unit * exp_i_pi(b).unwrap(), exp_i_pi(&(a + b)).unwrap(), "{a} + {b}");
            }
        }
    }

    #[test]
    fn signs_follow_the_quadrants() {
        for n in -24..=24_i64 {
            let unit = exp_i_pi(&ratio(n, 12)).unwrap();
            let turn = n.rem_euclid(24);
            let sine = if turn % 12 == 0 { Ordering::Equal } else { 12.cmp(&turn) };
            assert_eq!(unit.im.sign(), sine, "sin({n}*pi/12)");
            let shifted = (turn + 6) % 24;
            let cosine = if shifted % 12 == 0 { Ordering::Equal } else { 12.cmp(&shifted) };
            assert_eq!(unit.re.sign(), cosine, "cos({n}*pi/12)");
        }
        assert_eq!(cos_pi(&ratio(1, 17)).unwrap().to_decimal(12), "0.982973099684");
        assert_eq!(sin_pi(&ratio(22, 15)).unwrap().to_decimal(12), "-0.994521895368");
    }

    #[test]
    fn deep_halvings_are_reached_and_deeper_ones_refused() {
        let cosine = cos_pi(&ratio(1, 1024)).unwrap();
        assert_eq!(cosine.ring().field().generators().len(), 9);
        assert_eq!(cosine.to_decimal(12), "0.999995293810");
        for angle in [ratio(1, 2048), ratio(1, 7), ratio(1, 9), ratio(1, 25), ratio(1, 1 << 40)] {
            assert_eq!(cos_pi(&angle), Err(NotConstructible { angle }));
        }
    }
}
