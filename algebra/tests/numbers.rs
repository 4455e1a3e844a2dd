//! Numbers with nested roots: denesting, smallest fields, signs and equalities, against exact linear algebra and decimals.

#[path = "support/config.rs"]
mod config;

use std::cmp::Ordering;
use std::collections::BTreeMap;

use config::config;
use hodograph_algebra::{Poly, Rational, cos_pi, integer, minimize_field, ratio};
use num_traits::Zero;
use proptest::prelude::*;

fn root(n: i64) -> Poly {
    Poly::sqrt_of(&integer(n))
}

fn sqrt(number: &Poly) -> Poly {
    number.sqrt().expect("the number is not negative")
}

/// Coordinates of a number, by the exponents of generators.
type Coordinates = BTreeMap<Vec<u32>, Rational>;

/// The degree of a number over the rationals: the number of its powers that are linearly independent, by elimination.
fn degree(number: &Poly) -> u64 {
    let mut rows: Vec<(Vec<u32>, Coordinates)> = Vec::new();
    let mut power = Poly::one();
    loop {
        let coordinates = power.generator_coefficients().into_iter();
        let count = number.ring().field().generators().len();
        let mut vector: Coordinates = coordinates
            .map(|(mut exponents, value)| {
                exponents.resize(count, 0);
                (exponents, value.to_rational().expect("coordinates are rational"))
            })
            .collect();
        for (pivot, row) in &rows {
            let factor = vector.get(pivot).cloned().unwrap_or_else(Rational::zero);
            for (place, value) in row {
                *vector.entry(place.clone()).or_insert_with(Rational::zero) -= &factor * value;
            }
        }
        let Some((pivot, leading)) = vector.iter().find(|(_, value)| !value.is_zero()) else {
            return rows.len() as u64;
        };
        let (pivot, leading) = (pivot.clone(), leading.clone());
        vector.values_mut().for_each(|value| *value = &*value / &leading);
        rows.push((pivot, vector));
        power = &power * number;
    }
}

/// Numbers made of at most four roots, later ones of earlier ones.
fn nested_numbers() -> impl Strategy<Value = Poly> {
    let step = (-3_i64..8, -3_i64..4, 0_usize..4, 0_usize..4, -2_i64..3);
    (prop::collection::vec(step, 1..5), -3_i64..4).prop_map(|(steps, last)| {
        let mut known = vec![Poly::one()];
        let mut sum = Poly::zero();
        for (a, b, i, j, c) in steps {
            let [x, y] = [i, j].map(|index| known[index % known.len()].clone());
            let number = Poly::integer(a) + x.scale(&integer(b)) + &x * &y.scale(&integer(c));
            // Any number has a root up to its sign.
            let found = number.sqrt().unwrap_or_else(|| sqrt(&-&number));
            sum += &found * &y;
            known.push(found);
        }
        sum + known[known.len() - 1].scale(&integer(last))
    })
}

proptest! {
    #![proptest_config(config(48))]

    #[test]
    fn fields_are_the_smallest_ones(number in nested_numbers()) {
        let small = minimize_field(std::slice::from_ref(&number)).swap_remove(0);
        prop_assert!(small.is_valid());
        prop_assert_eq!(small.ring().field().degree(), degree(&number), "the degree of {}", number);
        prop_assert_eq!(&small, &number);
        prop_assert_eq!(small.to_decimal(40), number.to_decimal(40));
    }

    #[test]
    fn roots_square_to_their_radicands(number in nested_numbers()) {
        let (positive, negative) = (number.sqrt(), (-&number).sqrt());
        prop_assert_eq!(positive.is_some() && negative.is_some(), number.is_zero());
        let found = positive.or(negative).expect("one of them is not negative");
        prop_assert!(found.is_valid() && found.sign() != Ordering::Less);
        let square = &found * &found;
        prop_assert!(square == number || square == -number);
        // The root of the square is found again, as the same number.
        prop_assert_eq!(sqrt(&square), found);
    }

    #[test]
    fn nested_signs_agree_with_decimals(a in nested_numbers(), b in nested_numbers()) {
        let difference = &a - &b;
        let decimal = difference.to_decimal(60);
        let zero = decimal.chars().all(|c| matches!(c, '0' | '.' | '-'));
        let expected = match (zero, decimal.starts_with('-')) {
            (true, _) => Ordering::Equal,
            (false, true) => Ordering::Less,
            (false, false) => Ordering::Greater,
        };
        prop_assert_eq!(difference.sign(), expected);
        prop_assert_eq!(a == b, zero);
    }
}

#[test]
fn the_order_in_which_roots_are_given_does_not_matter() {
    let [a, b, c] = [root(2), root(3), root(5)];
    let square = (&a + &b + &c).pow(2);
    for sum in [[&a, &b, &c], [&c, &a, &b], [&b, &c, &a]] {
        let sum: Poly = sum.into_iter().cloned().sum();
        assert_eq!(sqrt(&square), sum);
        assert_eq!(degree(&sum), 8);
        let small = minimize_field(&[sum.clone(), square.clone()]);
        assert_eq!(small[0].ring().field().degree(), 8);
        assert_eq!(minimize_field(std::slice::from_ref(&square))[0].ring().field().degree(), 4);
    }
}

#[test]
fn chains_of_roots_are_compared_exactly() {
    // 2·cos(π/2^(k+1)) = √(2 + √(2 + … )), which tends to 2 like 4^(−k).
    let mut number = Poly::zero();
    for depth in 1..=8_u32 {
        let next = sqrt(&(&number + Poly::integer(2)));
        assert_eq!(&next * &next - Poly::integer(2), number);
        assert_eq!(next, cos_pi(&ratio(1, 1 << (depth + 1))).unwrap().scale(&integer(2)));
        assert_eq!(next.compare(&Poly::integer(2)), Ordering::Less);
        assert_eq!(next.compare(&number), Ordering::Greater);
        assert_eq!(next.ring().field().degree(), 1 << depth);
        number = next;
    }
    // A tower without any relation: √(3 + √(5 + √(7 + … ))).
    let mut number = root(19);
    for prime in [17, 13, 11, 7, 5, 3, 2] {
        number = sqrt(&(number + Poly::integer(prime)));
    }
    assert_eq!(number.ring().field().degree(), 256);
    assert_eq!(number.to_decimal(30), NESTED);
    assert!((&number * number.inverse()).is_one());
}

/// `√(2 + √(3 + √(5 + √(7 + √(11 + √(13 + √(17 + √19)))))))`.
const NESTED: &str = "2.103596274198021337311967141785";

#[test]
fn near_coincidences_are_told_apart() {
    // √(n + 1) − √n, which is nearly 1/(2√n).
    let large = Rational::from(hodograph_algebra::Int::from(10).pow(60));
    let difference = Poly::sqrt_of(&(&large + integer(1))) - Poly::sqrt_of(&large);
    assert_eq!(difference.sign(), Ordering::Greater);
    assert_eq!(difference.to_decimal(32), "0.00000000000000000000000000000050");
    let close = Poly::constant(ratio(1, 2) / Rational::from(hodograph_algebra::Int::from(10).pow(30)));
    assert_eq!(difference.compare(&close), Ordering::Less);
    assert_eq!((&close - &difference).to_decimal(95).trim_start_matches(['0', '.']), "12500");
    // Convergents of √2 agree with it to 30 digits and more, from alternate sides.
    let (mut p, mut q) = (integer(1), integer(1));
    for step in 0..50 {
        let convergent = Poly::constant(&p / &q);
        let expected = if step % 2 == 0 { Ordering::Less } else { Ordering::Greater };
        assert_eq!(convergent.compare(&root(2)), expected);
        (p, q) = (&p + &q * integer(2), &p + &q);
    }
    // Sums of roots whose difference has a norm of 1.
    let sums = [(10, 11, 5, 18), (7, 14, 3, 22), (5, 30, 11, 17)];
    for (a, b, c, d) in sums {
        let (left, right) = (root(a) + root(b), root(c) + root(d));
        assert_eq!(left.compare(&right), left.to_decimal(20).cmp(&right.to_decimal(20)), "{a} {b} {c} {d}");
    }
}

#[test]
fn what_is_negative_has_no_root() {
    assert_eq!((root(2) - root(3)).sqrt(), None);
    assert_eq!((root(8) - root(2).scale(&integer(2))).sqrt(), Some(Poly::zero()));
    let tiny = (root(2) - Poly::one()).pow(40);
    assert_eq!((-&tiny).sqrt(), None);
    assert_eq!(sqrt(&tiny), (root(2) - Poly::one()).pow(20));
}
