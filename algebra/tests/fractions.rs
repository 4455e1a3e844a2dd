//! Rational functions: field axioms, derivatives and substitution, compared with numerators over multiplied-out
//! denominators.

use std::collections::BTreeMap;

use hodograph_algebra::{Fraction, Poly, Rational, Variable, integer, ratio};
use proptest::prelude::*;

fn variables() -> [Variable; 2] {
    [Variable::new(0, "u"), Variable::new(1, "v")]
}

/// A polynomial of low degree in u and v, now and then over Q(√2).
fn poly() -> impl Strategy<Value = Poly> {
    prop::collection::vec((0..3_u32, 0..3_u32, -4..5_i64, 0..6_u8), 1..4).prop_map(|terms| {
        let [u, v] = variables();
        let term = |(i, j, coefficient, radical): (u32, u32, i64, u8)| {
            let monomial = Poly::variable(&u).pow(i) * Poly::variable(&v).pow(j);
            let scaled = monomial.scale(&integer(coefficient));
            if radical == 0 { scaled * Poly::sqrt_of(&integer(2)) } else { scaled }
        };
        terms.into_iter().map(term).sum()
    })
}

fn nonzero() -> impl Strategy<Value = Poly> {
    poly().prop_map(|poly| if poly.is_zero() { Poly::one() } else { poly })
}

fn fraction() -> impl Strategy<Value = Fraction> {
    (poly(), nonzero(), nonzero(), 0..3_u32)
        .prop_map(|(numerator, f, g, exponent)| Fraction::new(numerator, [(f, 1), (g, exponent)]))
}

/// Whether two fractions agree by cross multiplication of what they print.
fn agree(a: &Fraction, b: &Fraction) -> bool {
    a.numerator() * b.denominator() == b.numerator() * a.denominator()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn they_form_a_field(a in fraction(), b in fraction(), c in fraction()) {
        prop_assert!([&a, &b, &c].iter().all(|f| f.is_valid()));
        prop_assert!((&a + &b).is_valid() && (&a * &b).is_valid());
        prop_assert_eq!(&(&a + &b) + &c, &a + &(&b + &c));
        prop_assert_eq!(&a * &(&b + &c), &(&a * &b) + &(&a * &c));
        prop_assert!((&a - &a).is_zero());
        if let Some(inverse) = b.reciprocal(&[]) {
            prop_assert!(inverse.is_valid());
            prop_assert_eq!(&b * &inverse, Fraction::one());
            prop_assert_eq!(a.checked_div(&b).unwrap(), &a * &inverse);
        } else {
            prop_assert!(b.is_zero());
        }
    }

    #[test]
    fn reduction_keeps_the_function(a in fraction(), common in nonzero()) {
        let unreduced = &Fraction::new(&common * a.numerator(), a.factors().iter().cloned())
            * &Fraction::new(Poly::one(), [(common, 1)]);
        for reduced in [unreduced.reduced(), unreduced.lowest_terms()] {
            prop_assert!(reduced.is_valid());
            prop_assert!(agree(&reduced, &a));
        }
        let lowest = unreduced.lowest_terms();
        prop_assert!(lowest.is_zero() || Poly::coprime(&[lowest.numerator().clone(), lowest.denominator()]));
    }

    #[test]
    fn reduced_products_are_reduced(a in fraction(), b in fraction(), common in nonzero()) {
        // Factors that cancel crosswise, and within what is left.
        let (x, y) = (&a * &Fraction::from(common.clone()), &b * &Fraction::new(Poly::one(), [(common, 2)]));
        let (x, y) = (x.reduced(), y.reduced());
        let product = x.reduced_product(&y);
        prop_assert!(product.is_valid());
        prop_assert_eq!(&product, &(&x * &y));
        // No factor is left to cancel, though factors that are not coprime can be cancelled in several ways.
        let again = product.reduced();
        prop_assert_eq!((product.numerator(), product.factors()), (again.numerator(), again.factors()));
    }

    #[test]
    fn derivatives_obey_the_quotient_rule(a in fraction()) {
        for variable in variables() {
            let (n, d) = (a.numerator(), a.denominator());
            let numerator = n.derivative(&variable) * &d - n * d.derivative(&variable);
            let naive = Fraction::new(numerator, [(d, 2)]);
            prop_assert_eq!(a.derivative(&variable), naive);
        }
    }

    #[test]
    fn substitution_is_a_homomorphism(a in fraction(), b in fraction(), x in -9..10_i64, y in 1..7_i64) {
        let [u, v] = variables();
        let one = Fraction::from(Poly::one());
        let values = BTreeMap::from([
            (u, Fraction::from(ratio(x, y))),
            (v.clone(), &one / &(&one + &Fraction::from(Poly::variable(&v).pow(2)))),
        ]);
        if let (Some(p), Some(q)) = (a.substitute(&values), b.substitute(&values)) {
            prop_assert_eq!((&a * &b).substitute(&values), Some(&p * &q));
            if let Some(sum) = (&a + &b).substitute(&values) {
                prop_assert_eq!(sum, &p + &q);
            }
        }
    }
}

#[test]
fn known_factors_are_kept_apart() {
    let [u, v] = variables().map(|variable| Poly::variable(&variable));
    let (f, g) = (u.pow(2) + Poly::one(), v.pow(2) + Poly::one());
    let a = Fraction::new(Poly::one(), [(f.clone(), 1)]);
    let b = Fraction::new(v.clone(), [(f.clone(), 2), (g.clone(), 1)]);
    assert_eq!((&a + &b).factors(), [(f.clone(), 2), (g.clone(), 1)]);
    assert_eq!((&a * &b).to_string(), "v/((u^2 + 1)^3*(v^2 + 1))");
    let cancelled = &(&a * &b) * &Fraction::from(f.pow(3));
    assert_eq!(cancelled.reduced().to_string(), "v/(v^2 + 1)");
    assert_eq!(Fraction::new(Poly::one(), [(f, 1)]).to_rational(), None::<Rational>);
    assert!(a.checked_div(&Fraction::zero()).is_none());
}
