//! PH quintics from Hermite data: the data are met exactly, and the solution of least rotation is the right one.

use std::cmp::Ordering;

use hodograph_algebra::{
    Complex, Hermite, HermiteDatum, HermiteError, Poly, Preimage, Variable, budget, exp_i_pi, integer, ratio,
};
use proptest::prelude::*;

fn point(x: i64, y: i64) -> Complex {
    Complex::new(Poly::integer(x), Poly::integer(y))
}

fn root(n: i64) -> Poly {
    Poly::sqrt_of(&integer(n))
}

fn value(poly: &Poly, t: &Variable, at: i64) -> Poly {
    poly.substitute(t, &Poly::integer(at))
}

/// The curve of `preimage` has exactly the data.
fn assert_interpolates(preimage: &Preimage, data: &[Complex; 4]) {
    let t = Variable::new(1, "t");
    let curve = preimage.curve(&t, &data[0]);
    for (poly, at, expected) in [
        (&curve.position, 0, &data[0]),
        (&curve.hodograph, 0, &data[1]),
        (&curve.position, 1, &data[2]),
        (&curve.hodograph, 1, &data[3]),
    ] {
        assert_eq!(value(&poly.re, &t, at), expected.re);
        assert_eq!(value(&poly.im, &t, at), expected.im);
    }
}

fn hermite(data: &[Complex; 4]) -> Result<Hermite, HermiteError> {
    Hermite::new(&data[0], &data[1], &data[2], &data[3])
}

fn example_2() -> [Complex; 4] {
    [point(0, 0), point(0, 4), point(2, 2), point(4, 0)]
}

fn example_4() -> [Complex; 4] {
    [point(0, 0), point(-2, 0), point(0, 1), point(2, 0)]
}

#[test]
fn example_2_of_farouki_and_nittler() {
    let preimage = hermite(&example_2()).unwrap().least_rotation().unwrap();
    assert_interpolates(&preimage, &example_2());
    let w = preimage.coefficients();
    assert_eq!(w[0], Complex::new(root(2), root(2)));
    assert_eq!(w[2], point(2, 0));
    // w1 = (sqrt(45*sqrt2 + 10)*exp(I*pi/8) - 3*(1 + exp(I*pi/4)))/2, as printed.
    let radical = (root(2).scale(&integer(45)) + Poly::integer(10)).sqrt().unwrap();
    let units = [ratio(1, 8), ratio(1, 4)].map(|q| exp_i_pi(&q).unwrap());
    let printed = units[0].times_real(&radical) - (Complex::one() + &units[1]).scale(&integer(3));
    assert_eq!(w[1], printed.scale(&ratio(1, 2)));

    let t = Variable::new(1, "t");
    let curve = preimage.curve(&t, &Complex::zero());
    for part in
        [&curve.hodograph.re, &curve.hodograph.im, &curve.speed, &curve.position.re, &curve.position.im]
    {
        let field = part.ring().field();
        assert_eq!(field.degree(), 4);
        assert_eq!(field.relation(0).to_string(), "sqrt2^2 - 2");
        assert_eq!(field.relation(1).to_string(), "theta^2 - 100*sqrt2 - 110");
    }
    assert_eq!(curve.hodograph.norm2(), curve.speed.pow(2));
}

#[test]
fn example_4_of_farouki_and_nittler() {
    let preimage = hermite(&example_4()).unwrap().least_rotation().unwrap();
    assert_interpolates(&preimage, &example_4());
    let w = preimage.coefficients();
    assert_eq!(w[0], Complex::new(Poly::zero(), root(2)));
    assert_eq!(w[2], Complex::from(root(2)));
    let printed = (root(35) - Poly::integer(3)) * root(2).scale(&integer(2)).inverse();
    assert_eq!(w[1], Complex::new(printed.clone(), printed));

    let t = Variable::new(1, "t");
    let curve = preimage.curve(&t, &Complex::zero());
    let field = curve.speed.ring().field();
    assert_eq!(field.degree(), 2);
    assert_eq!(field.relation(0).to_string(), "sqrt35^2 - 35");
}

#[test]
fn all_four_solutions_interpolate() {
    for data in [example_2(), example_4()] {
        let interpolation = hermite(&data).unwrap();
        assert_eq!(interpolation.indices(), [0, 1, 2, 3]);
        for index in 0..4 {
            assert_interpolates(&interpolation.solution(index).unwrap(), &data);
        }
        assert_eq!(interpolation.solution(4), Err(HermiteError::NoSuchSolution { index: 4 }));
    }
}

#[test]
fn data_may_be_irrational() {
    let data = [point(0, 0), Complex::new(root(3), Poly::one()), point(2, 1), Complex::from(root(2))];
    let preimage = hermite(&data).unwrap().least_rotation().unwrap();
    assert_interpolates(&preimage, &data);
}

#[test]
fn straight_data_give_the_straight_segment() {
    let data = [point(1, 1), point(1, 0), point(2, 1), point(1, 0)];
    let preimage = hermite(&data).unwrap().least_rotation().unwrap();
    assert_eq!(preimage.coefficients(), [Complex::one(), Complex::one(), Complex::one()]);
    // The others stop on their way: their speed vanishes inside, although they do not turn either.
    let t = Variable::new(1, "t");
    let speed = hermite(&data).unwrap().solution(1).unwrap().speed(&t);
    assert!(speed.coefficients(&t).iter().any(|coefficient| coefficient.sign() == Ordering::Less));
}

#[test]
fn mirror_images_tie() {
    let data = [point(0, 0), point(1, 0), point(-1, 0), point(1, 0)];
    let interpolation = hermite(&data).unwrap();
    let error = interpolation.least_rotation().unwrap_err();
    let HermiteError::Tie { solutions } = &error else { panic!("a tie is expected, not {error}") };
    let conjugate: Vec<Complex> = solutions[1].preimage.coefficients().iter().map(Complex::conj).collect();
    assert_eq!(solutions.len(), 2);
    assert_eq!(solutions[0].preimage.coefficients(), conjugate);
    let text = error.to_string();
    assert!(text.contains("same least absolute rotation index"), "{text}");
    assert!(
        text.contains("solution 2: w0 = 1 ≈ 1.0000 + 0.0000*I; w1 = I*(sqrt10) ≈ 0.0000 + 3.1623*I"),
        "{text}"
    );
    assert_interpolates(&interpolation.solution(solutions[0].index).unwrap(), &data);
}

#[test]
fn mirror_images_with_both_roots_of_the_end_tangent_tie() {
    let data = [point(0, 0), point(1, 0), point(3, 0), point(-1, 0)];
    let error = hermite(&data).unwrap().least_rotation().unwrap_err();
    let HermiteError::Tie { solutions } = error else { panic!("a tie is expected, not {error}") };
    let indices: Vec<usize> = solutions.iter().map(|solution| solution.index).collect();
    assert_eq!(indices.len(), 2);
    assert!(indices[0] < 2 && indices[1] >= 2, "{indices:?}");
}

#[test]
fn coincident_solutions_are_one() {
    // 120*(s(1) - s(0)) = 15*(1 + 1) - 10 makes the root vanish for w2 = 1.
    let data = [point(0, 0), point(1, 0), Complex::from(ratio(1, 6)), point(1, 0)];
    let interpolation = hermite(&data).unwrap();
    assert_eq!(interpolation.indices(), [0, 2, 3]);
    assert_eq!(interpolation.solution(0), interpolation.solution(1));
    assert_interpolates(&interpolation.solution(0).unwrap(), &data);
}

#[test]
fn impossible_data_are_refused() {
    let tangent = point(1, 0);
    let zero = Complex::zero();
    for (data, datum, reason) in [
        ([&zero, &zero, &tangent, &tangent], HermiteDatum::StartTangent, "the start tangent s'(0) is zero"),
        ([&zero, &tangent, &tangent, &zero], HermiteDatum::EndTangent, "the end tangent s'(1) is zero"),
    ] {
        let error = Hermite::new(data[0], data[1], data[2], data[3]).unwrap_err();
        assert_eq!(error, HermiteError::ZeroTangent { datum });
        assert!(error.to_string().starts_with(reason), "{error}");
    }
    let symbol = Complex::from(Poly::variable(&Variable::new(Variable::SYMBOL, "r")));
    let error = Hermite::new(&zero, &tangent, &symbol, &tangent).unwrap_err();
    assert_eq!(error, HermiteError::NotANumber { datum: HermiteDatum::End });
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 24,
        failure_persistence: None,
        rng_seed: proptest::test_runner::RngSeed::Fixed(1995),
        ..ProptestConfig::default()
    })]

    #[test]
    fn random_data_are_met_exactly(
        start in (-4_i64..=4, -4_i64..=4),
        end in (-4_i64..=4, 1_i64..=3, -4_i64..=4),
        tangents in [(-3_i64..=3, -3_i64..=3), (-3_i64..=3, -3_i64..=3)],
    ) {
        prop_assume!(tangents.iter().all(|tangent| *tangent != (0, 0)));
        let end = Complex::new(Poly::constant(ratio(end.0, end.1)), Poly::integer(end.2));
        let data = [
            point(start.0, start.1),
            point(tangents[0].0, tangents[0].1),
            end,
            point(tangents[1].0, tangents[1].1),
        ];
        // Deterministic units of work bound the time.
        let outcome = budget::with_budget(1_000_000_000, || hermite(&data).map(|found| found.least_rotation()));
        match outcome {
            Ok(Ok(Ok(preimage))) => assert_interpolates(&preimage, &data),
            Ok(Ok(Err(HermiteError::Tie { solutions }))) => {
                prop_assert!(solutions.len() > 1);
                assert_interpolates(&solutions[0].preimage, &data);
            }
            other => prop_assert!(false, "{other:?}"),
        }
    }
}
