//! Real roots against Sturm's theorem and against polynomials with known roots, and signs on boxes against samples.

#[path = "support/config.rs"]
mod config;
#[path = "support/intervals.rs"]
mod intervals;
#[path = "naive/sturm.rs"]
mod sturm;

use std::cmp::Ordering;

use config::config;
use hodograph_algebra::{BoxSign, Interval, Poly, RealRoot, budget, integer, ratio};
use intervals::{intervals, numbers, root2, u, v};
use proptest::prelude::*;
use sturm::count_roots;

fn x() -> Poly {
    Poly::variable(&u())
}

fn integers() -> impl Strategy<Value = Poly> {
    (-9_i64..10).prop_map(Poly::integer)
}

fn polynomials(coefficients: impl Strategy<Value = Poly>, degree: usize) -> impl Strategy<Value = Poly> {
    prop::collection::vec(coefficients, 1..degree + 2)
        .prop_map(|coefficients| Poly::from_coefficients(&u(), &coefficients))
        .prop_filter("zero has no isolated roots", |poly| !poly.is_zero())
}

/// Checks the roots of `poly` in the interval in all ways that do not need to know them.
fn check(poly: &Poly, interval: &Interval) -> Result<(), TestCaseError> {
    let roots = poly.real_roots_in(&u(), interval).expect("the polynomial is not zero");
    prop_assert_eq!(roots.len(), count_roots(poly, &u(), interval.lower(), interval.upper()));
    for pair in roots.windows(2) {
        prop_assert_eq!(pair[0].compare(&pair[1]), Ordering::Less);
        prop_assert_eq!(pair[1].compare(&pair[0]), Ordering::Greater);
        let (a, b) = (pair[0].enclosure(0), pair[1].enclosure(0));
        prop_assert!(pair[0].exact().is_some() || pair[1].exact().is_some() || a.upper() <= b.lower());
    }
    for root in &roots {
        prop_assert!(root.compare_number(interval.lower()) != Ordering::Less);
        prop_assert!(root.compare_number(interval.upper()) != Ordering::Greater);
        // The multiplicity is the number of derivatives that vanish.
        let mut derivative = poly.clone();
        for _ in 0..root.multiplicity() {
            prop_assert_eq!(root.sign_of(&derivative), Some(Ordering::Equal));
            derivative = derivative.derivative(&u());
        }
        prop_assert!(root.sign_of(&derivative) != Some(Ordering::Equal));
        let enclosure = root.enclosure(40);
        let ends = [enclosure.lower(), enclosure.upper()].map(|end| Poly::constant(end.clone()));
        prop_assert!(root.compare_number(&ends[0]) != Ordering::Less);
        prop_assert!(root.compare_number(&ends[1]) != Ordering::Greater);
        prop_assert_eq!(root.compare(&root.refined(70)), Ordering::Equal);
        if root.exact().is_none() {
            let above = &x() - &ends[0];
            prop_assert_eq!(root.sign_of(&above), Some(Ordering::Greater));
            prop_assert_eq!(root.sign_of(&-above), Some(Ordering::Less));
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(config(64))]

    #[test]
    fn counts_agree_with_sturm(f in polynomials(integers(), 8), interval in intervals()) {
        check(&f, &interval)?;
    }

    #[test]
    fn counts_agree_with_sturm_over_a_number_field(f in polynomials(numbers(), 4), interval in intervals()) {
        check(&f, &interval)?;
    }

    #[test]
    fn repeated_factors_are_counted(
        f in polynomials(integers(), 2),
        g in polynomials(integers(), 3),
        interval in intervals(),
    ) {
        check(&(f.pow(3) * g.pow(2) * &f), &interval)?;
    }

    #[test]
    fn all_real_roots_lie_within_the_bound(f in polynomials(integers(), 6)) {
        let roots = f.real_roots(&u()).expect("the polynomial is not zero");
        let far = Interval::new(Poly::integer(-1000), Poly::integer(1000)).expect("the ends are in order");
        let in_far = f.real_roots_in(&u(), &far).expect("the polynomial is not zero");
        // Cauchy's bound for coefficients below 10.
        prop_assert_eq!(roots.len(), in_far.len());
        for (a, b) in roots.iter().zip(&in_far) {
            prop_assert_eq!(a.compare(b), Ordering::Equal);
            prop_assert_eq!(a.multiplicity(), b.multiplicity());
            prop_assert_eq!(a.to_decimal(25), b.to_decimal(25));
        }
    }

    #[test]
    fn known_roots_are_found_exactly(
        known in prop::collection::btree_map((-20_i64..21, 1_i64..8).prop_map(|(n, d)| ratio(n, d)), 1_u32..4, 1..5),
        radicand in 2_i64..8,
    ) {
        let square = x().pow(2) - Poly::integer(radicand);
        let f = known.iter().map(|(root, m)| (x() - Poly::constant(root.clone())).pow(*m)).product::<Poly>()
            * (x().pow(4) + &x() + Poly::integer(3));
        let found: Vec<_> =
            f.real_roots(&u()).unwrap().iter().map(|root| (root.to_rational(), root.multiplicity())).collect();
        let expected: Vec<_> = known.iter().map(|(root, m)| (Some(root.clone()), *m)).collect();
        prop_assert_eq!(found, expected);
        // Squares that are irrational are roots of a quadratic factor, hence exact as well.
        let surds: Vec<RealRoot> = square.real_roots(&u()).unwrap();
        let expected = Poly::sqrt_of(&integer(radicand));
        prop_assert_eq!(surds.iter().map(RealRoot::exact).collect::<Vec<_>>(), [Some(&-&expected), Some(&expected)]);
    }

    #[test]
    fn equal_roots_of_different_polynomials_are_equal(f in polynomials(integers(), 5), g in polynomials(numbers(), 2)) {
        let product = &f * &g;
        let roots = product.real_roots(&u()).expect("the product is not zero");
        for root in f.real_roots(&u()).expect("the polynomial is not zero") {
            let same = roots.iter().filter(|other| other.compare(&root) == Ordering::Equal);
            prop_assert_eq!(same.count(), 1);
        }
    }

    #[test]
    fn signs_on_boxes_agree_with_samples(
        terms in prop::collection::vec((numbers(), 0..3_u32, 0..3_u32), 1..5),
        shift in 0_i64..12,
    ) {
        let term = |(number, i, j): &(Poly, u32, u32)| number * x().pow(*i) * Poly::variable(&v()).pow(*j);
        let f = terms.iter().map(term).sum::<Poly>() + Poly::integer(shift);
        let half = Interval::new(Poly::integer(-1), Poly::constant(ratio(1, 2))).expect("the ends are in order");
        let domain = [(u(), half), (v(), Interval::unit())];
        let sample = |i: i64, j: i64| {
            let (a, b) = (domain[0].1.point(&ratio(i, 6)), domain[1].1.point(&ratio(j, 6)));
            f.substitute(&u(), &a).substitute(&v(), &b).sign()
        };
        let samples: Vec<Ordering> = (0..=6).flat_map(|i| (0..=6).map(move |j| (i, j))).map(|(i, j)| sample(i, j)).collect();
        let all = |allowed: &[Ordering]| samples.iter().all(|sign| allowed.contains(sign));
        use Ordering::{Equal, Greater, Less};
        match f.sign_on(&domain).expect("the box names all variables") {
            BoxSign::Positive => prop_assert!(all(&[Greater])),
            BoxSign::Negative => prop_assert!(all(&[Less])),
            BoxSign::NonNegative { zeros } => prop_assert!(all(&[Greater, Equal]) && !zeros.is_empty()),
            BoxSign::NonPositive { zeros } => prop_assert!(all(&[Less, Equal]) && !zeros.is_empty()),
            BoxSign::ChangesSign { positive, negative } => {
                prop_assert_eq!(f.evaluate(&positive).sign(), Greater);
                prop_assert_eq!(f.evaluate(&negative).sign(), Less);
                for (variable, interval) in &domain {
                    prop_assert!(interval.contains(&positive[variable]) && interval.contains(&negative[variable]));
                }
            }
            BoxSign::Zero => prop_assert!(f.is_zero()),
            BoxSign::Undecided { zero, .. } => {
                prop_assert!(!(samples.contains(&Greater) && samples.contains(&Less)));
                if let Some(zero) = zero {
                    prop_assert!(f.evaluate(&zero).is_zero());
                }
            }
            other => prop_assert!(false, "an unknown answer {:?}", other),
        }
    }

    #[test]
    fn sums_of_squares_are_not_negative(
        terms in prop::collection::vec((integers(), 0..3_u32, 0..3_u32), 1..4),
        positive in any::<bool>(),
    ) {
        let term = |(number, i, j): &(Poly, u32, u32)| number * x().pow(*i) * Poly::variable(&v()).pow(*j);
        let f = terms.iter().map(term).sum::<Poly>();
        let domain = [(u(), Interval::unit()), (v(), Interval::unit())];
        let square = f.pow(2) + Poly::constant(ratio(i64::from(positive), 100));
        match square.sign_on(&domain).expect("the box names all variables") {
            BoxSign::Positive => {}
            BoxSign::NonNegative { .. } => prop_assert!(!positive),
            BoxSign::Zero => prop_assert!(f.is_zero() && !positive),
            other => prop_assert!(false, "{} is said to be {:?}", square, other),
        }
    }
}

#[test]
fn wilkinson_and_mignotte() {
    let wilkinson: Poly = (1..=20).map(|n| x() - Poly::integer(n)).product();
    let roots = wilkinson.real_roots(&u()).unwrap();
    let texts: Vec<String> = roots.iter().map(ToString::to_string).collect();
    assert_eq!(texts, (1..=20).map(|n| n.to_string()).collect::<Vec<_>>());
    // x^11 − 2·(50x − 1)²: two roots that agree to many digits.
    let mignotte = x().pow(11) - (x().scale(&integer(50)) - Poly::one()).pow(2).scale(&integer(2));
    let roots = mignotte.real_roots_in(&u(), &Interval::unit()).unwrap();
    assert_eq!(roots.len(), 2);
    let [a, b] = [&roots[0], &roots[1]].map(|root| root.to_decimal(8));
    assert_eq!([a.as_str(), b.as_str()], ["0.02000000", "0.02000000"]);
    assert_eq!(roots[0].compare(&roots[1]), Ordering::Less);
}

#[test]
fn work_is_counted() {
    let f = x().pow(60) - Poly::integer(2) * x() + Poly::constant(ratio(1, 3));
    let error = budget::with_budget(1000, || f.real_roots(&u())).unwrap_err();
    assert!(error.to_string().contains("more than the budget"));
}

/// A number of degree 8.
fn degree8() -> Poly {
    let root = Poly::sqrt_of(&integer(3)) + root2();
    (root + Poly::integer(5)).sqrt().expect("the number is positive")
}

#[test]
fn clusters_are_separated() {
    // x^20 − 2·(100x − 1)²: two roots that agree to some 20 digits.
    let mignotte = x().pow(20) - (x().scale(&integer(100)) - Poly::one()).pow(2).scale(&integer(2));
    let roots = mignotte.real_roots_in(&u(), &Interval::unit()).unwrap();
    assert_eq!(roots.len(), count_roots(&mignotte, &u(), &Poly::zero(), &Poly::one()));
    let hundredth = Poly::constant(ratio(1, 100));
    assert_eq!(roots[0].compare_number(&hundredth), Ordering::Less);
    assert_eq!(roots[1].compare_number(&hundredth), Ordering::Greater);
    assert_eq!(roots[0].to_decimal(20), roots[1].to_decimal(20));
    assert_ne!(roots[0].to_decimal(24), roots[1].to_decimal(24));
    // The same around an irrational number, with irrational coefficients.
    let shifted = mignotte.substitute(&u(), &(x() - root2()));
    let interval = Interval::new(root2(), root2() + Poly::one()).unwrap();
    let found = shifted.real_roots_in(&u(), &interval).unwrap();
    assert_eq!(found.len(), roots.len());
    assert_eq!(found[0].compare_number(&(root2() + &hundredth)), Ordering::Less);
}

#[test]
fn roots_over_nested_fields_are_exact() {
    let theta = degree8();
    assert_eq!(theta.ring().field().degree(), 8);
    // Roots at both ends of the interval, a double one, and one that is no number of the field.
    let cubic = x().pow(3) - &theta * &x() - Poly::one();
    let f = (x() - &theta) * (x() - root2()).pow(2) * (x() + Poly::one()).pow(3) * &cubic;
    let interval = Interval::new(Poly::integer(-1), theta.clone()).unwrap();
    let roots = f.real_roots_in(&u(), &interval).unwrap();
    let exact: Vec<Option<&Poly>> = roots.iter().map(RealRoot::exact).collect();
    let multiplicities: Vec<u32> = roots.iter().map(RealRoot::multiplicity).collect();
    assert_eq!(roots.len(), count_roots(&f, &u(), interval.lower(), interval.upper()));
    assert_eq!(exact[0], Some(&Poly::integer(-1)));
    assert!(roots.last().is_some_and(|last| last.compare_number(&theta).is_eq()));
    assert_eq!(multiplicities.iter().sum::<u32>() as usize, roots.len() + 3);
    for root in &roots {
        assert_eq!(root.sign_of(&f), Some(Ordering::Equal));
    }
    // Inside of the interval alone, neither end is a root.
    let inner =
        Interval::new(Poly::constant(ratio(-99, 100)), &theta - Poly::constant(ratio(1, 1000))).unwrap();
    assert_eq!(f.real_roots_in(&u(), &inner).unwrap().len(), roots.len() - 2);
}

proptest! {
    #![proptest_config(config(12))]

    #[test]
    fn counts_agree_with_sturm_in_degree_8(
        coefficients in prop::collection::vec((-5_i64..6, -3_i64..4, -2_i64..3), 2..5),
        interval in intervals(),
    ) {
        let theta = degree8();
        let number = |&(a, b, c): &(i64, i64, i64)| {
            Poly::integer(a) + root2().scale(&integer(b)) + theta.scale(&integer(c))
        };
        let coefficients: Vec<Poly> = coefficients.iter().map(number).collect();
        let f = Poly::from_coefficients(&u(), &coefficients);
        if !f.is_zero() {
            let roots = f.real_roots_in(&u(), &interval).expect("the polynomial is not zero");
            prop_assert_eq!(roots.len(), count_roots(&f, &u(), interval.lower(), interval.upper()));
        }
    }
}
