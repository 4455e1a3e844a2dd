//! Curvatures of known surfaces, and of all examples against the textbook's formulas in exact arithmetic.

use hodograph_algebra::{Poly, Rational, Variable, ratio};

use super::outputs;
use super::tests::{Example, bilinear, examples, scheduled};
use crate::program::{Floats, Program, Variant, interpret};
use crate::round::{exact, nearest, round};

/// Results of a program in floats.
fn floats(program: &Program<f64>, output: &str, (u, v): (f64, f64)) -> Vec<f64> {
    let numbers = Floats { u, v, symbols: &[], variant: Variant::Plain };
    interpret(program, program.results(output), &numbers).unwrap()
}

/// The derivatives of the Cartesian coordinates at a point, by the quotient rule: R, R_u, R_v, R_uu, R_uv, R_vv.
fn derivatives(example: &Example, point: &[(&Variable, &Rational)]) -> [[Poly; 3]; 6] {
    let (u, v) = (&example.u, &example.v);
    let orders: [&[&Variable]; 6] = [&[], &[u], &[v], &[u, u], &[u, v], &[v, v]];
    orders.map(|order| {
        let [weight, coordinates @ ..] = &example.homogeneous;
        coordinates.each_ref().map(|coordinate| {
            let start = (coordinate.clone(), weight.clone());
            let (numerator, denominator) =
                order.iter().fold(start, |(n, d), s| (n.derivative(s) * &d - &n * d.derivative(s), &d * &d));
            numerator.at(point) * denominator.at(point).inverse()
        })
    })
}

fn dot(a: &[Poly; 3], b: &[Poly; 3]) -> Poly {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn cross(a: &[Poly; 3], b: &[Poly; 3]) -> [Poly; 3] {
    let minor = |i: usize, j: usize| &a[i] * &b[j] - &a[j] * &b[i];
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

fn float(number: &Poly) -> f64 {
    nearest(number).unwrap()
}

/// A root that need not be in the field: of an exact number, rounded.
fn root(number: &Poly) -> f64 {
    float(number).sqrt()
}

fn assert_close(found: &[f64], expected: &[f64], size: f64, what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= 1e-12 * size, "{what}: {found:e} instead of {expected:e}");
    }
}

/// Compares all that depends on second derivatives at some points of the domain with
/// K = (LN − M²)/(EG − F²), H = (EN − 2FM + GL)/(2(EG − F²)), k = H ± √(H² − K), and n_u, n_v by Weingarten's equations
/// (do Carmo, §3-3).
fn compare(example: &Example) {
    let program = round(&scheduled(example)).unwrap();
    let at = |[first, last]: &[Rational; 2], i: i64| {
        exact(float(&Poly::constant(first + (last - first) * ratio(2 * i + 1, 7)))).unwrap()
    };
    for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
        let (u, v) = (at(&example.domain[0], i), at(&example.domain[1], j));
        let [_, of_u, of_v, of_uu, of_uv, of_vv] =
            derivatives(example, &[(&example.u, &u), (&example.v, &v)]);
        let found = |output| {
            let [u, v] = [&u, &v].map(|number| float(&Poly::constant(number.clone())));
            floats(&program, output, (u, v))
        };
        let vector = |vector: &[Poly; 3]| vector.each_ref().map(float);
        for (output, expected) in
            [(outputs::PARTIAL_UU, &of_uu), (outputs::PARTIAL_UV, &of_uv), (outputs::PARTIAL_VV, &of_vv)]
        {
            let size = 1.0 + root(&dot(expected, expected));
            assert_close(&found(output), &vector(expected), size, output);
        }

        // L, M and N without their common factor 1/‖R_u × R_v‖.
        let normal = cross(&of_u, &of_v);
        let (e, f, g) = (dot(&of_u, &of_u), dot(&of_u, &of_v), dot(&of_v, &of_v));
        let [l, m, n] = [&of_uu, &of_uv, &of_vv].map(|second| dot(&normal, second));
        let square = &e * &g - &f * &f;
        let area = root(&square);
        let gaussian = (&l * &n - &m * &m) * (&square * &square).inverse();
        let mean = (&e * &n - Poly::integer(2) * &f * &m + &g * &l) * (Poly::integer(2) * &square).inverse();
        let mean_square = &mean * &mean * square.inverse();
        let half_gap = root(&(&mean_square - &gaussian));
        let (mean, bend) = (float(&mean) / area, half_gap + root(&mean_square));

        let normal_size = |vector: &[Poly; 3]| vector.each_ref().map(|x| float(x) / area);
        assert_close(&found(outputs::UNIT_NORMAL), &normal_size(&normal), 1.0, "n");
        assert_close(&found(outputs::FIRST_FORM), &[&e, &f, &g].map(float), float(&(&e + &g)), "E, F, G");
        let size = [&of_uu, &of_uv, &of_vv].map(|second| root(&dot(second, second))).iter().sum::<f64>();
        assert_close(&found(outputs::SECOND_FORM), &[&l, &m, &n].map(|x| float(x) / area), size, "L, M, N");
        assert_close(&found(outputs::SPEEDS), &[root(&e), root(&g)], root(&(&e + &g)), "speeds");
        assert_close(&found(outputs::GAUSSIAN), &[float(&gaussian)], bend * bend + 1e-3, "K");
        assert_close(&found(outputs::MEAN), &[mean], bend + 1e-3, "H");
        // Where the principal curvatures are equal the root in the textbook's formula loses half of the digits.
        let principal = found(outputs::PRINCIPAL);
        assert!(principal[0] >= principal[1]);
        let (sum, product) = (principal[0] + principal[1], principal[0] * principal[1]);
        assert_close(
            &[sum / 2.0, product],
            &[mean, float(&gaussian)],
            bend + bend * bend + 1e-3,
            "principal",
        );

        // (EG − F²)·n_u = (FM − GL)·R_u + (FL − EM)·R_v, and the same with N for M and M for L.
        for (output, l, m) in [(outputs::NORMAL_U, &l, &m), (outputs::NORMAL_V, &m, &n)] {
            let (a, b) = (&f * m - &g * l, &f * l - &e * m);
            let expected: Vec<f64> = of_u
                .iter()
                .zip(&of_v)
                .map(|(x, y)| float(&((&a * x + &b * y) * square.inverse())) / area)
                .collect();
            let size = bend * root(&(&e + &g)) * (1.0 + root(&g) / root(&e)) + 1e-3;
            assert_close(&found(output), &expected, size, output);
        }
    }
}

#[test]
fn curvatures_are_those_of_the_textbook() {
    for example in examples() {
        compare(&example);
    }
    compare(&torus());
    compare(&cylinder());
}

/// x = 2u/(1 + u²) and z = (1 − u²)/(1 + u²), as numerators with their denominator.
fn circle(u: &Poly) -> [Poly; 3] {
    [Poly::integer(2) * u, Poly::one() - u.pow(2), Poly::one() + u.pow(2)]
}

/// A surface with the normal (A_u × A_v)/…, whatever its common factor: without root.
fn surface(homogeneous: [Poly; 4], normal: [Poly; 3], (u, v): (Variable, Variable)) -> Example {
    Example { homogeneous, normal, u, v, ..bilinear() }
}

/// The torus of radii 3 and 1: both of its circles have rational parametrizations of the same form.
fn torus() -> Example {
    let (u, v) = (Variable::new(0, "u"), Variable::new(1, "v"));
    let [sin, cos, d] = circle(&Poly::variable(&u));
    let [y, x, c] = circle(&Poly::variable(&v));
    let radius = Poly::integer(3) * &d + &cos;
    let homogeneous = [&d * &c, &radius * &x, &radius * &y, &sin * &c];
    surface(homogeneous, [-(&cos * &x), -(&cos * &y), -(&sin * &c)], (u, v))
}

/// The cylinder of radius 2.
fn cylinder() -> Example {
    let (u, v) = (Variable::new(0, "u"), Variable::new(1, "v"));
    let [y, x, c] = circle(&Poly::variable(&v));
    let homogeneous = [c.clone(), Poly::integer(2) * &x, Poly::integer(2) * &y, &c * &Poly::variable(&u)];
    surface(homogeneous, [-&x, -&y, Poly::zero()], (u, v))
}

#[test]
fn spheres_cylinders_and_tori_bend_as_they_do() {
    let sphere = &examples()[3];
    let program = round(&scheduled(sphere)).unwrap();
    for at in [(0.0, 0.0), (0.5, 0.25), (1.0, 0.75)] {
        assert_close(&floats(&program, outputs::GAUSSIAN, at), &[1.0], 1.0, "sphere");
        let [greater, less] = floats(&program, outputs::PRINCIPAL, at)[..] else { panic!("two curvatures") };
        assert!((greater.abs() - 1.0).abs() < 1e-7 && (less - greater).abs() < 1e-7);
    }
    let program = round(&scheduled(&cylinder())).unwrap();
    assert_close(&floats(&program, outputs::GAUSSIAN, (0.5, 0.25)), &[0.0], 1.0, "cylinder");
    assert_close(&floats(&program, outputs::PRINCIPAL, (0.5, 0.25)), &[0.5, 0.0], 1.0, "cylinder");
    // Outside, K = cos φ/(3 + cos φ) with cos φ = (1 − u²)/(1 + u²).
    let program = round(&scheduled(&torus())).unwrap();
    for u in [0.0, 0.25, 0.5, 1.0] {
        let cosine = (1.0 - u * u) / (1.0 + u * u);
        assert_close(
            &floats(&program, outputs::GAUSSIAN, (u, 0.75)),
            &[cosine / (3.0 + cosine)],
            1.0,
            "torus",
        );
        let mut expected = [1.0, cosine / (3.0 + cosine)];
        if floats(&program, outputs::MEAN, (u, 0.75))[0] < 0.0 {
            expected = [-expected[1], -expected[0]];
        }
        assert_close(&floats(&program, outputs::PRINCIPAL, (u, 0.75)), &expected, 1.0, "torus");
    }
}

#[test]
fn the_circle_of_a_translation_keeps_its_curvature() {
    // The profile of an oriented translation is a section in its normal plane, and a line of curvature.
    let program = round(&scheduled(&examples()[0])).unwrap();
    for at in [(0.125, 0.25), (0.5, 0.5), (0.75, 0.875)] {
        let principal = floats(&program, outputs::PRINCIPAL, at);
        assert!(principal.iter().any(|k| (k.abs() - 1.0).abs() < 1e-12), "{principal:?}");
    }
}
