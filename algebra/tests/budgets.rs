//! Short inputs that ask for more than there is end at their budget, and say what was computed and how far it came.

use hodograph_algebra::budget::{self, Exhausted};
use hodograph_algebra::{
    Bernstein, Fraction, Int, Interval, Poly, Preimage, SweptSurface, Variable, Vector, cos_pi, integer,
    ratio,
};

fn u() -> Poly {
    Poly::variable(&Variable::new(0, "u"))
}

fn symbol(name: &str) -> Poly {
    Poly::variable(&Variable::new(Variable::SYMBOL, name))
}

/// The error of work that must not fit into `limit` units, and must not go far beyond them.
fn exhausted<T>(limit: u64, work: impl FnOnce() -> T) -> Exhausted {
    let (outcome, spent) = budget::measured(|| budget::with_budget(limit, work));
    assert!(spent < 2 * limit, "{spent} units of {limit}");
    match outcome {
        Ok(_) => panic!("{spent} units suffice"),
        Err(error) => error,
    }
}

#[test]
fn powers_are_refused_before_they_are_computed() {
    let sum = Poly::one() + u() + symbol("a") + symbol("b");
    let (error, spent) = budget::measured(|| exhausted(budget::DEFAULT_LIMIT, || sum.pow(2000)));
    assert_eq!(error.doing, ["a power of a polynomial"]);
    assert!(spent < 1000, "{spent}");
    let error = exhausted(1000, || (Poly::one() + u()).pow(1_000_000_000));
    assert!(error.to_string().contains("exponent"), "{error}");
    exhausted(budget::DEFAULT_LIMIT, || Int::from(3).pow(1_000_000_000));
    // Repeated squares grow without an exponent that shows it.
    exhausted(1_000_000, || (0..60).fold(Poly::one() + u(), |square, _| &square * &square));
    exhausted(1_000_000, || (0..60).fold(Int::from(3), |square, _| &square * &square));
}

#[test]
fn powers_tell_how_far_they_came() {
    let sum = Poly::one() + u() + symbol("a");
    let error = exhausted(60_000, || {
        budget::doing("the first power", || sum.pow(20));
        // The estimate is below what the powers of a number take.
        let number = Poly::sqrt_of(&integer(2)) + Poly::sqrt_of(&integer(3)) + Poly::one();
        (&number * &sum).pow(60)
    });
    assert_eq!(error.done[0].task, "the first power");
    assert!(error.to_string().contains(", after the first power ("), "{error}");
}

#[test]
fn nested_and_independent_roots_end() {
    let error = exhausted(3_000_000, || {
        (2..40).fold(Poly::zero(), |number, n| (number + Poly::integer(n * n - n + 17)).sqrt().unwrap())
    });
    assert!(error.doing.contains(&"a square root in a number field".to_owned()), "{error}");
    let primes = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59];
    let error = exhausted(budget::DEFAULT_LIMIT, || {
        primes.map(|p| Poly::sqrt_of(&integer(p))).into_iter().sum::<Poly>()
    });
    assert!(error.to_string().starts_with("these numbers need more than 16 independent square roots"));
    // A field of degree 2^16 has room for numbers whose inverses have none.
    exhausted(3_000_000, || {
        let sum: Poly = primes[..14].iter().map(|&p| Poly::sqrt_of(&integer(p))).sum();
        sum.inverse()
    });
    exhausted(3_000_000, || cos_pi(&ratio(7, 1024 * 255)));
}

#[test]
fn large_arrays_are_refused_before_they_are_there() {
    let v = Variable::new(1, "v");
    let saddle = u().pow(30_000) * Poly::variable(&v).pow(30_000) + Poly::one();
    let domain = [(Variable::new(0, "u"), Interval::unit()), (v, Interval::unit())];
    let (error, spent) =
        budget::measured(|| exhausted(budget::DEFAULT_LIMIT, || Bernstein::new(&saddle, &domain)));
    assert_eq!(error.doing, ["a Bernstein form"]);
    assert!(spent < budget::DEFAULT_LIMIT / 2, "{spent}");
    // 2500 · 2500 scattered terms.
    let scattered = |name: &str| -> Poly {
        (0..50)
            .flat_map(|i| (0..50).map(move |j| (i, j)))
            .map(|(i, j)| symbol(name).pow(i * i + 7) * u().pow(j * j))
            .sum()
    };
    let (a, b) = (scattered("a"), scattered("b"));
    exhausted(5_000_000, || &a * &b);
}

#[test]
fn clustered_roots_end() {
    let v = Variable::new(0, "u");
    let near = (u().scale(&integer(1_000_000)) - Poly::one()).pow(2);
    let mignotte = u().pow(200) - near.scale(&integer(2));
    let error = exhausted(5_000_000, || mignotte.real_roots(&v));
    assert_eq!(error.doing, ["the real roots of a polynomial"]);
    let (done, known) = error.progress.expect("the intervals are counted");
    assert!(done < known, "{error}");
}

#[test]
fn a_derivation_tells_what_was_finished() {
    let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
    let circle = Poly::one() + u().pow(2);
    let x = Fraction::new(Poly::one() - u().pow(2), [(circle.clone(), 1)]);
    let z = Fraction::new(u().scale(&integer(2)), [(circle, 1)]);
    let v = Poly::variable(&parameters[1]);
    let height = Fraction::from((&v * &v + symbol("a") * &v + symbol("b")).pow(6));
    let position = Vector::new(&x * &height, Fraction::from(v.pow(5)), &z * &height);
    let domain = [Interval::unit(), Interval::unit()];
    // What exceeded the budget, of the derivation or of one of its parts.
    let derive = |limit: u64| {
        let surface = SweptSurface::new(position.clone(), parameters.clone(), domain.clone());
        let derivation = budget::with_budget(limit, || surface.derive().expect("a surface"))?;
        derivation.geometry.map(|_| ()).and(derivation.control_net.map(|_| ()))
    };
    let (whole, units) = budget::measured(|| derive(u64::MAX));
    assert_eq!(whole, Ok(()));
    let mut told = Vec::new();
    for limit in [units / 1000, units / 10, units / 2, units - units / 20] {
        let (outcome, spent) = budget::measured(|| derive(limit));
        assert!(spent < 2 * limit, "{spent} units of {limit}");
        let error = outcome.expect_err("the limit is too low");
        assert!(!error.doing.is_empty(), "{error}");
        told.push(error.done.iter().filter(|finished| finished.task.starts_with("the ")).count());
    }
    // At last the control net alone does not fit: what was finished before is there.
    assert!(told[..3].is_sorted() && told[0] < told[2] && told[3] == 0, "{told:?}");
    // There must be room for its memory as well.
    assert_eq!(derive(10 * units), Ok(()));
    // What is spent does not depend on what was spent before.
    assert_eq!(budget::measured(|| derive(u64::MAX)).1, units);
}

#[test]
fn preimages_of_any_degree_end() {
    let v = Variable::new(1, "v");
    let outcome =
        budget::with_budget(1_000_000, || Preimage::symbolic(9999, "").map(|preimage| preimage.speed(&v)));
    assert!(!matches!(outcome, Ok(Ok(_))));
}
