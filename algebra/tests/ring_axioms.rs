//! The axioms of rings and fields, and every operation of polynomials and numbers against a naive twin.

#[path = "support/config.rs"]
mod config;
#[path = "naive/polynomial.rs"]
mod naive;

use std::cmp::Ordering;
use std::collections::BTreeMap;

use config::config;
use hodograph_algebra::{
    Int, Poly, Rational, minimize_field, parse_decimal, ratio, rational_gcd, rational_sqrt,
};
use naive::{GENERATORS, Naive, VARIABLES, big, generators, small, variables};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{Num, One, Pow, Signed, Zero};
use proptest::prelude::*;

/// Integers around the edges of a machine word, and some of several words.
fn integers() -> impl Strategy<Value = BigInt> {
    prop_oneof![
        (-20_i64..20).prop_map(BigInt::from),
        any::<i64>().prop_map(BigInt::from),
        (0_i64..3, any::<bool>()).prop_map(|(offset, low)| {
            let edge = if low { i64::MIN } else { i64::MAX };
            BigInt::from(edge) + BigInt::from(offset - 1)
        }),
        (any::<i128>(), any::<i64>()).prop_map(|(a, b)| BigInt::from(a) * BigInt::from(b)),
    ]
}

fn rationals() -> impl Strategy<Value = BigRational> {
    prop_oneof![
        (-12_i64..12, 1_i64..6).prop_map(|(n, d)| BigRational::new(n.into(), d.into())),
        (integers(), integers())
            .prop_filter("a denominator is not zero", |(_, d)| !d.is_zero())
            .prop_map(|(n, d)| BigRational::new(n, d)),
    ]
}

/// Coefficients that are mostly small: a polynomial has the common denominator of all.
fn coefficients() -> impl Strategy<Value = BigRational> {
    prop_oneof![
        8 => (-12_i64..12, 1_i64..6).prop_map(|(n, d)| BigRational::new(n.into(), d.into())),
        1 => integers().prop_map(BigRational::from),
    ]
}

/// The field Q, Q(√2) or Q(√2, θ), by its number of generators.
fn fields() -> impl Strategy<Value = usize> {
    0..=GENERATORS
}

fn exponents(degree: u32, count: usize) -> impl Strategy<Value = Vec<u32>> {
    (prop::collection::vec(0..=degree, VARIABLES), prop::collection::vec(0..=1_u32, count)).prop_map(
        |(mut exponents, powers)| {
            exponents.extend(powers);
            exponents.resize(VARIABLES + GENERATORS, 0);
            exponents
        },
    )
}

/// Few terms of high degree, whose products are collected by sorting.
fn sparse(field: usize) -> impl Strategy<Value = Naive> {
    prop::collection::vec((exponents(60, field), coefficients()), 0..5).prop_map(Naive::new)
}

/// All monomials of a small box, whose products are collected in an array.
fn dense(field: usize) -> impl Strategy<Value = Naive> {
    let box_of_exponents: Vec<Vec<u32>> = (0..3_u32)
        .flat_map(|i| (0..3_u32).map(move |j| vec![i, j, 0]))
        .flat_map(|e| {
            (0..1_u32 << field).map(move |mask| [e.clone(), vec![mask & 1, mask >> 1 & 1]].concat())
        })
        .collect();
    let count = box_of_exponents.len();
    prop::collection::vec(coefficients(), count)
        .prop_map(move |values| Naive::new(box_of_exponents.iter().cloned().zip(values)))
}

fn polynomials(field: usize) -> impl Strategy<Value = Naive> {
    prop_oneof![2 => sparse(field), 1 => dense(field)]
}

fn three() -> impl Strategy<Value = [Naive; 3]> {
    fields().prop_flat_map(|field| [polynomials(field), polynomials(field), polynomials(field)])
}

/// Numbers of Q(√2, θ).
fn numbers() -> impl Strategy<Value = Poly> {
    (fields(), prop::collection::vec(coefficients(), 4)).prop_map(|(field, values)| {
        let exponents = (0..1_u32 << field).map(|mask| vec![0, 0, 0, mask & 1, mask >> 1 & 1]);
        Naive::new(exponents.zip(values)).to_poly()
    })
}

/// Whether the polynomial is canonical and equals the naive one.
fn check(poly: &Poly, expected: &Naive) -> Result<(), TestCaseError> {
    prop_assert!(poly.is_valid(), "not canonical: {}", poly);
    prop_assert_eq!(&Naive::of(poly), expected);
    Ok(())
}

proptest! {
    #![proptest_config(config(256))]

    #[test]
    fn integers_agree_with_big_ones(a in integers(), b in integers(), exponent in 0_u32..5) {
        let (x, y) = (Int::from(a.clone()), Int::from(b.clone()));
        for (result, expected) in [
            (&x + &y, &a + &b),
            (&x - &y, &a - &b),
            (&x * &y, &a * &b),
            (-&x, -&a),
            (x.abs(), a.abs()),
            (x.signum(), a.signum()),
            (x.gcd(&y), a.gcd(&b)),
            (x.lcm(&y), a.lcm(&b)),
            (x.pow(exponent), Pow::pow(&a, exponent)),
            (x.shl(70), &a << 70),
            (x.shr(5), &a >> 5),
        ] {
            prop_assert!(result.is_valid());
            prop_assert_eq!(result.to_big(), expected);
        }
        prop_assert_eq!(x.cmp(&y), a.cmp(&b));
        prop_assert_eq!(x.bits(), a.bits());
        prop_assert_eq!(x.is_even(), a.is_even());
        prop_assert_eq!(x.to_string(), a.to_string());
        prop_assert_eq!(&a.to_string().parse::<Int>().unwrap(), &x);
        prop_assert_eq!(&Int::from_str_radix(&a.to_str_radix(16), 16).unwrap(), &x);
        if !b.is_zero() {
            prop_assert_eq!((&x / &y).to_big(), &a / &b);
            prop_assert_eq!((&x % &y).to_big(), &a % &b);
            let ((q, r), (expected_q, expected_r)) = (x.div_mod_floor(&y), a.div_mod_floor(&b));
            prop_assert!(q.is_valid() && r.is_valid());
            prop_assert_eq!((q.to_big(), r.to_big()), (expected_q, expected_r));
            let (q, r) = x.div_rem(&y);
            prop_assert_eq!((q.to_big(), r.to_big()), a.div_rem(&b));
            prop_assert_eq!(x.is_multiple_of(&y), a.is_multiple_of(&b));
        }
        let square = &x * &x;
        prop_assert_eq!(square.exact_sqrt(), Some(x.abs()));
        prop_assert_eq!((&square + Int::ONE).exact_sqrt().is_some(), x.is_zero());
    }

    #[test]
    fn rationals_agree_with_big_ones(a in rationals(), b in rationals()) {
        let (x, y) = (small(&a), small(&b));
        for (result, expected) in [
            (&x + &y, &a + &b),
            (&x - &y, &a - &b),
            (&x * &y, &a * &b),
            (x.floor(), a.floor()),
            (x.round(), a.round()),
        ] {
            prop_assert_eq!(big(&result), expected);
        }
        if !b.is_zero() {
            prop_assert_eq!(big(&(&x / &y)), &a / &b);
        }
        prop_assert_eq!(x.cmp(&y), a.cmp(&b));
        prop_assert_eq!(rational_sqrt(&(&x * &x)), Some(x.abs()));
        let gcd = rational_gcd(&x, &y);
        if !gcd.is_zero() {
            let (p, q) = (&x / &gcd, &y / &gcd);
            prop_assert!(gcd.is_positive() && p.is_integer() && q.is_integer());
            prop_assert!(p.numer().gcd(q.numer()).is_one());
        }
    }

    #[test]
    fn decimals_are_read_exactly(digits in 0_i64..1_000_000_000, places in 0_usize..9) {
        let text = format!("{digits:010}");
        let (whole, fraction) = text.split_at(10 - places);
        let expected = ratio(digits, 10_i64.pow(places as u32));
        prop_assert_eq!(parse_decimal(&format!("{whole}.{fraction}")), Some(expected));
    }
}

proptest! {
    #![proptest_config(config(64))]

    #[test]
    fn polynomials_agree_with_naive_ones([a, b, _] in three(), place in 0..VARIABLES) {
        let (x, y) = (a.to_poly(), b.to_poly());
        check(&x, &a)?;
        check(&(&x + &y), &a.add(&b))?;
        check(&(&x * &y), &a.mul(&b))?;
        let minus_one = Naive::one().mul(&Naive::of(&Poly::integer(-1)));
        check(&(&x - &y), &a.add(&b.mul(&minus_one)))?;
        check(&-&x, &a.mul(&minus_one))?;
        let variable = &variables()[place];
        check(&x.derivative(variable), &a.derivative(place))?;
        let integral = x.integral(variable);
        prop_assert!(integral.is_valid());
        prop_assert_eq!(&integral.derivative(variable), &x);
        prop_assert!(integral.substitute(variable, &Poly::zero()).is_zero());
    }

    #[test]
    fn rings_obey_their_axioms([a, b, c] in three()) {
        let [a, b, c] = [a, b, c].map(|naive| naive.to_poly());
        prop_assert_eq!(&a + &b, &b + &a);
        prop_assert_eq!((&a + &b) + &c, &a + (&b + &c));
        prop_assert_eq!(&a * &b, &b * &a);
        prop_assert_eq!(&(&a * &b) * &c, &a * (&b * &c));
        prop_assert_eq!(&a * (&b + &c), &a * &b + &a * &c);
        prop_assert_eq!(&a * Poly::one(), a.clone());
        prop_assert_eq!(&a + Poly::zero(), a.clone());
        prop_assert!((&a - &a).is_zero() && (&a - &a).is_valid());
        prop_assert!((&a * Poly::zero()).is_zero());
        prop_assert_eq!(a.pow(3), &a * &a * &a);
    }

    #[test]
    fn division_undoes_multiplication([a, b, _] in three()) {
        let (a, b) = (a.to_poly(), b.to_poly());
        prop_assume!(!b.is_zero());
        let quotient = (&a * &b).exact_div(&b);
        prop_assert_eq!(quotient.as_ref(), Some(&a));
        prop_assert!(quotient.is_some_and(|quotient| quotient.is_valid()));
        if !b.is_constant() {
            // A multiple plus a nonzero number is no multiple.
            prop_assert_eq!((&a * &b + Poly::one()).exact_div(&b), None);
        }
        let monic = b.monic();
        prop_assert!(monic.is_valid() && monic.leading_coefficient().is_one());
        prop_assert_eq!(&(monic * b.leading_coefficient()), &b);
        prop_assert_eq!(b.normalized(), (&b * generators()[0].clone()).normalized());
    }

    #[test]
    fn substitution_agrees_with_the_naive_one(
        a in fields().prop_flat_map(dense),
        values in prop::collection::vec(sparse_small(), 2),
        place in 0..2_usize,
    ) {
        let x = a.to_poly();
        let variable = variables()[place].clone();
        check(&x.substitute(&variable, &values[0].to_poly()), &a.substitute(place, &values[0]))?;
        // Both variables at once, where the values contain the variables again.
        let [u, v, _] = variables();
        let both = BTreeMap::from([(u.clone(), values[0].to_poly()), (v.clone(), values[1].to_poly())]);
        let expected = x
            .coefficients_of(&[u, v])
            .iter()
            .map(|(e, c)| c * values[0].to_poly().pow(e[0]) * values[1].to_poly().pow(e[1]))
            .sum::<Poly>();
        prop_assert_eq!(x.evaluate(&both), expected);
        let coefficients = x.coefficients(&variable);
        prop_assert!(coefficients.iter().all(Poly::is_valid));
        prop_assert_eq!(&Poly::from_coefficients(&variable, &coefficients), &x);
        let denominator = values[1].to_poly();
        let degree = x.degree(&variable).unwrap_or(0);
        let fraction = x.substitute_fraction(&variable, &values[0].to_poly(), &denominator, degree);
        let expected = coefficients.iter().zip(0..).map(|(c, i)| {
            c * values[0].to_poly().pow(i) * denominator.pow(degree - i)
        });
        prop_assert_eq!(fraction, expected.sum::<Poly>());
    }

    #[test]
    fn numbers_form_a_field(a in numbers(), b in numbers()) {
        prop_assume!(!b.is_zero());
        let inverse = b.inverse();
        prop_assert!(inverse.is_valid());
        prop_assert!((&b * &inverse).is_one());
        prop_assert_eq!((&a * &inverse).exact_div(&inverse), Some(a.clone()));
        prop_assert_eq!(a.exact_div(&b), Some(&a * &inverse));
        prop_assert_eq!(inverse.inverse(), b);
    }

    #[test]
    fn squares_have_roots(a in numbers()) {
        let square = &a * &a;
        let root = square.sqrt().expect("a square is not negative");
        prop_assert!(root.is_valid());
        prop_assert!(root == a || root == -&a);
        prop_assert!(root.sign() != Ordering::Less);
        prop_assert_eq!(square.sqrt_in_field().map(|root| &root * &root), Some(square.clone()));
        prop_assert_eq!((-&square).sqrt().is_some(), a.is_zero());
    }

    #[test]
    fn signs_agree_with_enclosures(a in numbers(), b in numbers(), digits in 0_u32..20) {
        let difference = &a - &b;
        let enclosure = difference.enclosure(600);
        let expected = if enclosure.contains_zero() {
            // No difference of such numbers is as small as this, except zero.
            Ordering::Equal
        } else {
            enclosure.lower().cmp(&Rational::zero())
        };
        prop_assert_eq!(difference.sign(), expected);
        prop_assert_eq!(a.compare(&b), expected);
        prop_assert_eq!(expected == Ordering::Equal, a == b);
        let decimal: Rational = {
            let text = a.to_decimal(digits);
            let absolute = parse_decimal(text.trim_start_matches('-')).expect("a decimal");
            if text.starts_with('-') { -absolute } else { absolute }
        };
        let error = a - Poly::constant(decimal);
        let unit = Poly::constant(Rational::new(Int::ONE, Int::from(2) * Int::from(10).pow(digits)));
        prop_assert!(error.compare(&unit) != Ordering::Greater && (-error).compare(&unit) != Ordering::Greater);
    }

    #[test]
    fn smaller_fields_keep_values(a in numbers(), b in numbers(), radicand in 1_i64..30) {
        let c = Poly::sqrt_of(&ratio(radicand, 7)) * &a;
        let minimized = minimize_field(&[a.clone(), b.clone(), c.clone()]);
        for (small, number) in minimized.iter().zip([&a, &b, &c]) {
            prop_assert!(small.is_valid());
            prop_assert_eq!(small, number);
            prop_assert_eq!((small - number).sign(), Ordering::Equal);
            prop_assert_eq!(small.to_decimal(30), number.to_decimal(30));
        }
        // The square of √r·a needs no more than the field of a.
        let square = &minimize_field(&[&c * &c])[0];
        prop_assert!(square.ring().field().degree() <= a.ring().field().degree());
        prop_assert_eq!(square, &(&a * &a).scale(&ratio(radicand, 7)));
    }
}

/// Few terms of low degree.
fn sparse_small() -> impl Strategy<Value = Naive> {
    fields().prop_flat_map(|field| {
        let coefficient = (-5_i64..6, 1_i64..4).prop_map(|(n, d)| BigRational::new(n.into(), d.into()));
        prop::collection::vec((exponents(2, field), coefficient), 0..4).prop_map(Naive::new)
    })
}
