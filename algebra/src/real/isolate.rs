//! Isolation of the real roots of squarefree polynomials on rational intervals.

use std::cmp::Ordering;

use num_traits::{One, Signed, Zero};

use super::bernstein::variations;
use super::interval::Interval;
use super::net::Net;
use crate::{Int, Poly, Rational, Variable, budget, ratio};

/// A place where a squarefree polynomial has exactly one root.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// The root itself.
    Point(Rational),
    /// An open interval, at whose ends the polynomial does not vanish.
    Open(Rational, Rational),
}

/// The places of all roots of the squarefree `poly` in the closed interval from `lower` to `upper`, ascending and
/// disjoint.
///
/// Bisection, decided by the sign variations of the Bernstein coefficients: none means no root inside, one means one
/// (Mourrain, Rouillier and Roy, *The Bernstein basis and real root isolation*, 2005). It ends because the roots are
/// simple. Complexity: `O(n²)` sums of integers for each bisection. Sturm's sequence, which counts roots as well, would be
/// evaluated anew for each bisection, where the coefficients of the halves of a form come from its own ones.
pub(crate) fn isolate(poly: &Poly, variable: &Variable, lower: &Rational, upper: &Rational) -> Vec<Place> {
    let mut places = Vec::new();
    let ends = Interval::new(Poly::constant(lower.clone()), Poly::constant(upper.clone()));
    let Some(interval) = ends else {
        // A single point.
        if lower == upper && sign_at(poly, variable, lower).is_eq() {
            places.push(Place::Point(lower.clone()));
        }
        return places;
    };
    let Some(net) = Net::of(poly, &[(variable.clone(), interval)]) else { return places };
    if net.corner_sign(&[false]).is_eq() {
        places.push(Place::Point(lower.clone()));
    }
    let root_at_upper = net.corner_sign(&[true]).is_eq();
    let mut stack = vec![(net, lower.clone(), upper.clone(), false)];
    let mut done = 0;
    while let Some((net, lower, upper, root_at_lower)) = stack.pop() {
        // As far as it is known yet, each interval in hand is a step.
        budget::progress(done, done + 1 + stack.len() as u64);
        done += 1;
        if root_at_lower {
            places.push(Place::Point(lower.clone()));
        }
        let (at_lower, at_upper) = (net.corner_sign(&[false]), net.corner_sign(&[true]));
        match variations(net.signs()) {
            0 => {}
            1 if at_lower.is_ne() && at_upper.is_ne() => places.push(Place::Open(lower, upper)),
            _ => {
                let middle = (&lower + &upper) * ratio(1, 2);
                let (below, above) = net.halves(0);
                let root_at_middle = above.corner_sign(&[false]).is_eq();
                stack.push((above, middle.clone(), upper, root_at_middle));
                stack.push((below, lower, middle, false));
            }
        }
    }
    if root_at_upper {
        places.push(Place::Point(upper.clone()));
    }
    places
}

/// Narrows an open interval, at whose ends `poly` does not vanish and inside which it has one simple root, to at most
/// `width`; `rising` tells whether `poly` is negative at the lower end.
///
/// Quadratic interval refinement: the secant proposes one of `2^bits` parts of the interval, and two signs show whether
/// the root is there; each success doubles `bits`, so that the number of correct digits is doubled as well, and each
/// failure halves it. With one bit it is bisection, which never fails (Abbott, *Quadratic interval refinement for real
/// roots*, 2006).
pub(crate) fn narrow(
    poly: &Poly,
    variable: &Variable,
    (mut lower, mut upper): (Rational, Rational),
    rising: bool,
    width: &Rational,
) -> Place {
    let mut bits = 1;
    while &upper - &lower > *width {
        let count = Int::ONE.shl(bits);
        let step = (&upper - &lower) / Rational::from(count.clone());
        let guess = if bits == 1 { Int::ONE } else { secant(poly, variable, &lower, &upper, bits) };
        let guess = guess.clamp(Int::ONE, &count - Int::ONE);
        let at = |index: &Int| &lower + &step * Rational::from(index.clone());
        let is_below = |index: &Int| -> Option<bool> {
            if index.is_zero() || *index == count {
                return Some(index.is_zero());
            }
            match sign_at(poly, variable, &at(index)) {
                Ordering::Equal => None,
                sign => Some(sign.is_lt() == rising),
            }
        };
        let Some(guess_is_below) = is_below(&guess) else { return Place::Point(at(&guess)) };
        let neighbor = if guess_is_below { &guess + Int::ONE } else { &guess - Int::ONE };
        let Some(neighbor_is_below) = is_below(&neighbor) else { return Place::Point(at(&neighbor)) };
        let (guess, neighbor) = (at(&guess), at(&neighbor));
        match (guess_is_below, neighbor_is_below) {
            (true, false) => (lower, upper) = (guess, neighbor),
            (false, true) => (lower, upper) = (neighbor, guess),
            (true, true) => lower = neighbor,
            (false, false) => upper = neighbor,
        }
        bits = if guess_is_below == neighbor_is_below { (bits / 2).max(1) } else { 2 * bits };
    }
    Place::Open(lower, upper)
}

/// `2^bits` times the position, between 0 and 1, at which the secant from end to end vanishes, as an integer nearby.
fn secant(poly: &Poly, variable: &Variable, lower: &Rational, upper: &Rational, bits: u64) -> Int {
    if let (Some(from), Some(to)) = (numerator_at(poly, variable, lower), numerator_at(poly, variable, upper))
    {
        let degree = poly.degree(variable).unwrap_or(0);
        let from = from * upper.denom().pow(degree);
        let to = to * lower.denom().pow(degree);
        return (from.shl(bits) / (&from - to)).abs();
    }
    let [from, to] = [lower, upper].map(|end| poly.at(&[(variable, end)]));
    let position = &from * (&from - to).inverse();
    let scaled = position.enclosure(bits + 2).lower() * Rational::from(Int::ONE.shl(bits));
    scaled.round().to_integer()
}

/// The sign of a polynomial in one variable at a rational point.
pub(crate) fn sign_at(poly: &Poly, variable: &Variable, value: &Rational) -> Ordering {
    match numerator_at(poly, variable, value) {
        Some(numerator) => numerator.cmp(&Int::ZERO),
        None => poly.at(&[(variable, value)]).sign(),
    }
}

/// `qⁿ·f(p/q)` up to a positive factor that depends on `f` alone, for a polynomial `f` of degree `n` with rational
/// coefficients: Horner's rule for `Σ aᵢ·pⁱ·qⁿ⁻ⁱ`. `None` if a coefficient is irrational.
fn numerator_at(poly: &Poly, variable: &Variable, value: &Rational) -> Option<Int> {
    let ring = poly.ring();
    if !ring.field().generators().is_empty() {
        return None;
    }
    let position = ring.position(variable)?;
    let (p, q) = (value.numer(), value.denom());
    let (mut sum, mut power) = (Int::ZERO, Int::ONE);
    let mut terms = poly.terms().iter().peekable();
    for exponent in (0..=poly.degree(variable)?).rev() {
        sum *= p;
        if let Some(term) = terms.next_if(|term| ring.exponent(term.monomial, position) == exponent) {
            sum += &term.coefficient * &power;
        }
        power *= q;
        budget::spend(1 + power.bits() / 64);
    }
    Some(if poly.content().is_negative() { -sum } else { sum })
}

/// A power of two that exceeds the absolute values of all real roots of a polynomial of positive degree: at least
/// `2·max |aₙ₋ₖ/aₙ|^(1/k)` (Fujiwara, *Über die obere Schranke des absoluten Betrages der Wurzeln einer algebraischen
/// Gleichung*, 1916).
pub(crate) fn root_bound(poly: &Poly, variable: &Variable) -> Rational {
    let coefficients = poly.coefficients(variable);
    let Some((leading, lower)) = coefficients.split_last() else { return Rational::one() };
    let inverse = leading.inverse();
    let exponents = lower.iter().rev().zip(1_i64..).filter(|(coefficient, _)| !coefficient.is_zero());
    let exponent = exponents
        .map(|(coefficient, k)| {
            let quotient = (coefficient * &inverse).enclosure(8);
            let bits = log2_bound(quotient.lower()).max(log2_bound(quotient.upper()));
            -(-bits).div_euclid(k) + 1
        })
        .max()
        .unwrap_or(0);
    let power = Int::ONE.shl(exponent.unsigned_abs());
    budget::spend(exponent.unsigned_abs());
    if exponent < 0 { Rational::new(Int::ONE, power) } else { power.into() }
}

/// An integer `e` with `|value| < 2^e`, and a very negative one for zero.
fn log2_bound(value: &Rational) -> i64 {
    if value.is_zero() {
        return -(1 << 30);
    }
    let bits = |value: &Int| i64::try_from(value.bits()).unwrap_or(i64::MAX / 4);
    bits(value.numer()) - bits(value.denom()) + 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integer;

    #[test]
    fn roots_at_the_ends_and_at_bisection_points_count_once() {
        let u = Variable::new(0, "u");
        let x = Poly::variable(&u);
        let roots = [ratio(0, 1), ratio(1, 4), ratio(1, 2), ratio(1, 3), ratio(1, 1)];
        let poly: Poly = roots.iter().map(|root| &x - Poly::constant(root.clone())).product();
        let places = isolate(&poly, &u, &integer(0), &integer(1));
        assert_eq!(places.len(), 5);
        assert_eq!(places[0], Place::Point(integer(0)));
        assert_eq!(places[1], Place::Point(ratio(1, 4)));
        assert!(matches!(&places[2], Place::Open(a, b) if *a < ratio(1, 3) && *b > ratio(1, 3)));
        assert_eq!(places[4], Place::Point(integer(1)));
        assert_eq!(isolate(&poly, &u, &integer(1), &integer(1)), [Place::Point(integer(1))]);
    }

    #[test]
    fn signs_agree_with_evaluation() {
        let u = Variable::new(0, "u");
        let x = Poly::variable(&u);
        for f in
            [x.pow(5) - x.pow(2).scale(&ratio(7, 3)) + Poly::one(), Poly::integer(2) - &x * &x, x.clone()]
        {
            for n in -9..9 {
                let value = ratio(n, 4);
                assert_eq!(sign_at(&f, &u, &value), f.at(&[(&u, &value)]).sign(), "{f} at {value}");
            }
        }
    }

    #[test]
    fn narrow_intervals_hold_the_root() {
        let u = Variable::new(0, "u");
        let x = Poly::variable(&u);
        let root = Poly::sqrt_of(&integer(2));
        for (f, rising) in [
            (x.pow(2) - Poly::integer(2), true),
            (&root - &x, false),
            (&root * &x - x.pow(7).scale(&ratio(1, 4)), false),
        ] {
            let width = Rational::new(Int::ONE, Int::ONE.shl(300));
            let ends = (integer(1), integer(2));
            let Place::Open(lower, upper) = narrow(&f, &u, ends, rising, &width) else { panic!("{f}") };
            assert!(&upper - &lower <= width);
            assert_ne!(sign_at(&f, &u, &lower), sign_at(&f, &u, &upper));
            assert_eq!(sign_at(&f, &u, &lower).is_lt(), rising);
        }
        let third = &x - Poly::constant(ratio(3, 2));
        assert_eq!(
            narrow(&third, &u, (integer(1), integer(2)), true, &ratio(1, 9)),
            Place::Point(ratio(3, 2))
        );
    }

    #[test]
    fn bounds_exceed_all_roots() {
        let u = Variable::new(0, "u");
        let x = Poly::variable(&u);
        let poly = (&x - Poly::integer(1000)) * (&x + Poly::integer(3));
        assert!(root_bound(&poly, &u) > integer(1000));
        assert!(root_bound(&x.pow(2), &u) > integer(0));
        let small = &x - Poly::constant(ratio(1, 1000));
        assert!(root_bound(&small, &u) > ratio(1, 1000) && root_bound(&small, &u) < ratio(1, 100));
    }
}
