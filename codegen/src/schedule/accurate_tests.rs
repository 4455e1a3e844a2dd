//! The accurate point, in units in the last place of each coordinate.

use hodograph_algebra::{Bernstein, Interval, Poly, Rational, Variable, ratio};

use super::tests::{Example, examples};
use super::{Preference, check, outputs, schedule_preferring};
use crate::program::{Floats, Program, Variant, interpret};
use crate::round::{exact, nearest, round};

fn accurate(example: &Example) -> Program<Poly> {
    let program = schedule_preferring(&example.derived(), Preference::Accurate).unwrap();
    assert_eq!(check(&program, &example.derived()), Ok(()));
    program
}

/// Which coordinates have control points of one sign.
fn one_sign(example: &Example) -> [bool; 3] {
    let interval = |[first, last]: &[Rational; 2]| {
        Interval::new(Poly::constant(first.clone()), Poly::constant(last.clone())).unwrap()
    };
    let [u, v] = example.domain.each_ref().map(interval);
    let domain = [(example.u.clone(), u), (example.v.clone(), v)];
    let [_, coordinates @ ..] = &example.homogeneous;
    coordinates.each_ref().map(|poly| {
        let form = Bernstein::new(poly, &domain);
        let signs: Vec<f64> = form.coefficients().iter().map(|b| nearest(b).unwrap()).collect();
        signs.iter().all(|b| *b >= 0.0) || signs.iter().all(|b| *b <= 0.0)
    })
}

/// The unit in the last place of a float.
fn ulp(x: f64) -> f64 {
    let x = x.abs().max(f64::MIN_POSITIVE);
    f64::from_bits(x.to_bits() + 1) - x
}

/// The largest error of each coordinate of an output, in units in the last place, at n² points of the domain.
fn errors(example: &Example, program: &Program<Poly>, output: &str, n: i64) -> [f64; 3] {
    let rounded = round(program).unwrap();
    let fused = rounded.fused();
    let mut largest = [0.0_f64; 3];
    for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
        let at = |[first, last]: &[Rational; 2], i: i64| {
            nearest(&Poly::constant(first + (last - first) * ratio(i * i, n * n))).unwrap()
        };
        let (u, v) = (at(&example.domain[0], i), at(&example.domain[1], j));
        let [weight, coordinates @ ..] = &example.homogeneous;
        let place: [(&Variable, Rational); 2] =
            [(&example.u, exact(u).unwrap()), (&example.v, exact(v).unwrap())];
        let place = place.each_ref().map(|(variable, number)| (*variable, number));
        let inverse = weight.at(&place).inverse();
        let expected = coordinates.each_ref().map(|x| x.at(&place) * &inverse);
        for (program, variant) in [(&rounded, Variant::Plain), (&fused, Variant::Fused)] {
            let floats = Floats { u, v, symbols: &[], variant };
            let found = interpret(program, program.results(output), &floats).unwrap();
            for ((found, expected), largest) in found.iter().zip(&expected).zip(&mut largest) {
                let error = nearest(&(Poly::constant(exact(*found).unwrap()) - expected)).unwrap().abs();
                *largest = largest.max(error / ulp(nearest(expected).unwrap()));
            }
        }
    }
    largest
}

#[test]
fn coordinates_of_one_sign_do_not_cancel() {
    for example in examples() {
        let program = accurate(&example);
        let (signs, errors) = (one_sign(&example), errors(&example, &program, outputs::ACCURATE_POINT, 5));
        for (sign, error) in signs.into_iter().zip(errors) {
            assert!(!sign || error <= 16.0, "{signs:?} {errors:?}");
        }
    }
}
