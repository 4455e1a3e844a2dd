//! Schedules of small surfaces, made by hand.

use hodograph_algebra::{Poly, Rational, Variable, integer, ratio};
use proptest::prelude::*;

use super::{Derived, Fractions, Mismatch, ScheduleError, check, outputs, schedule};
use crate::program::{Floats, Program, Stage, Variant, interpret};
use crate::round::{exact, nearest, round};

/// A surface with all that a schedule asks for.
pub(crate) struct Example {
    pub(crate) u: Variable,
    pub(crate) v: Variable,
    pub(crate) homogeneous: [Poly; 4],
    pub(crate) normal: [Poly; 3],
    pub(crate) root: Option<Poly>,
    pub(crate) singular: Option<Poly>,
    pub(crate) known: Vec<(String, Poly)>,
    pub(crate) domain: [[Rational; 2]; 2],
}

impl Example {
    pub(crate) fn derived(&self) -> Derived<'_> {
        Derived {
            parameters: [&self.u, &self.v],
            homogeneous: &self.homogeneous,
            scale: integer(1),
            normal: Some(&self.normal),
            normal_root: self.root.as_ref(),
            singular: self.singular.as_ref(),
            factor: None,
            known: &self.known,
            domain: &self.domain,
            conditions: &[],
        }
    }
}

fn parameters() -> (Variable, Variable, Poly, Poly) {
    let (u, v) = (Variable::new(0, "u"), Variable::new(1, "v"));
    let (pu, pv) = (Poly::variable(&u), Poly::variable(&v));
    (u, v, pu, pv)
}

fn unit_square() -> [[Rational; 2]; 2] {
    [[integer(0), integer(1)], [integer(0), integer(1)]]
}

/// The oriented translation (17) of a unit circle along the PH curve with preimage w = a + i·b, a quadratic each:
/// W = Dσ, X = Dσx + Py', Y = Dσy − Px', Z = 2uσ for D = 1 + u², P = 1 − u².
pub(crate) fn translation(a: &Poly, b: &Poly) -> Example {
    let (u, v, pu, pv) = parameters();
    let _ = pv;
    let (d, p) = (Poly::one() + pu.pow(2), Poly::one() - pu.pow(2));
    let (sigma, dx, dy) = (a * a + b * b, a * a - b * b, Poly::integer(2) * a * b);
    let (x, y) = (dx.integral(&v), dy.integral(&v));
    let two_u = Poly::integer(2) * &pu;
    Example {
        homogeneous: [&d * &sigma, &d * &sigma * &x + &p * &dy, &d * &sigma * &y - &p * &dx, &two_u * &sigma],
        // σ·D·(x'k − z'n)/σ(u), up to sign: (P·y', −P·x', 2u·σ)
        normal: [-(&p * &dy), &p * &dx, -(&two_u * &sigma)],
        root: Some(&d * &sigma),
        singular: None,
        known: [("sigma", &sigma), ("x", &x), ("y", &y), ("x_prime", &dx), ("y_prime", &dy)]
            .map(|(name, poly)| (name.to_string(), poly.clone()))
            .into(),
        domain: unit_square(),
        u,
        v,
    }
}

pub(crate) fn quintic_translation() -> Example {
    shifted_translation(0)
}

/// The same surface with v − `start` in place of v, on the unit interval that begins there.
fn shifted_translation(start: i64) -> Example {
    let (_, _, _, v) = parameters();
    let v = v - Poly::integer(start);
    let a = Poly::integer(2) + v.scale(&ratio(1, 3)) - v.pow(2).scale(&ratio(3, 7));
    let b = Poly::integer(1) - v.scale(&ratio(5, 2)) + v.pow(2).scale(&ratio(1, 5));
    let mut example = translation(&a, &b);
    example.domain[1] = [integer(start), integer(start + 1)];
    example
}

/// The bilinear rational patch (v, u, 1)·(1 + …) with a weight that is no product.
pub(crate) fn bilinear() -> Example {
    let (u, v, pu, pv) = parameters();
    let weight = Poly::one() + &pu * &pv;
    let homogeneous = [weight.clone(), pu.clone(), pv.clone(), &pu - &pv];
    // R_u × R_v up to the power of W: det of (W, X, Y, Z) and its derivatives.
    let column = |poly: &Poly| [poly.clone(), poly.derivative(&u), poly.derivative(&v)];
    let det = |a: &Poly, b: &Poly| {
        let ([w, wu, wv], [a, au, av], [b, bu, bv]) = (column(&weight), column(a), column(b));
        &w * (&au * &bv - &av * &bu) - &a * (&wu * &bv - &wv * &bu) + &b * (&wu * &av - &wv * &au)
    };
    let normal = [
        det(&homogeneous[2], &homogeneous[3]),
        det(&homogeneous[3], &homogeneous[1]),
        det(&homogeneous[1], &homogeneous[2]),
    ];
    Example {
        u,
        v,
        homogeneous,
        normal,
        root: None,
        singular: None,
        known: Vec::new(),
        domain: unit_square(),
    }
}

/// A scaled rotation (13): the circle's profile along a parabola, with the factor x(u) of its normal.
fn rotation() -> Example {
    let (u, v, pu, pv) = parameters();
    let (d, p, two_u) = (Poly::one() + pu.pow(2), Poly::one() - pu.pow(2), Poly::integer(2) * &pu);
    let (x, y) = (Poly::one() + pv.pow(2), pv.scale(&ratio(1, 2)));
    let (dx, dy) = (x.derivative(&v), y.derivative(&v));
    // [x'·s + z'·k] × s' with x' = −4u/D², z' = 2(1 − u²)/D²
    let (slope, rise) = (-Poly::integer(2) * &pu, p.clone());
    let normal = [-(&rise * &dy), &rise * &dx, &slope * &(&x * &dy - &y * &dx)];
    Example {
        homogeneous: [d, &p * &x, &p * &y, two_u],
        normal,
        root: None,
        singular: Some(p),
        known: Vec::new(),
        domain: unit_square(),
        u,
        v,
    }
}

/// The plane z = 0.
pub(crate) fn plane() -> Example {
    let (u, v, pu, pv) = parameters();
    Example {
        homogeneous: [Poly::one(), pu, pv, Poly::zero()],
        normal: [Poly::zero(), Poly::zero(), Poly::one()],
        root: Some(Poly::one()),
        singular: None,
        known: Vec::new(),
        domain: unit_square(),
        u,
        v,
    }
}

/// The offset translation (20) of a PH cubic with w = 1 + i·u by d = v²: W = σ(u), X = σx + d·y', Y = σy − d·x', Z = σv.
fn offset_translation() -> Example {
    let (u, v, pu, pv) = parameters();
    let (dx, dy) = (Poly::one() - pu.pow(2), Poly::integer(2) * &pu);
    let (sigma, x, y, d) = (Poly::one() + pu.pow(2), dx.integral(&u), dy.integral(&u), pv.pow(2));
    // (n − d'k) times σ
    let normal = [dy.clone(), -&dx, -(&sigma * &pv * Poly::integer(2))];
    Example {
        homogeneous: [sigma.clone(), &sigma * &x + &d * &dy, &sigma * &y - &d * &dx, &sigma * &pv],
        normal,
        root: None,
        singular: None,
        known: Vec::new(),
        domain: unit_square(),
        u,
        v,
    }
}

/// The unit sphere by stereographic projection: neither its weight nor the root of its normal is a product.
fn sphere() -> Example {
    let (u, v, pu, pv) = parameters();
    let square = pu.pow(2) + pv.pow(2);
    let (weight, x, y, z) =
        (&square + Poly::one(), Poly::integer(2) * pu, Poly::integer(2) * pv, square - Poly::one());
    Example {
        homogeneous: [weight.clone(), x.clone(), y.clone(), z.clone()],
        normal: [-x, -y, -z],
        root: Some(weight),
        singular: None,
        known: Vec::new(),
        domain: unit_square(),
        u,
        v,
    }
}

/// Surfaces of all kinds.
pub(crate) fn examples() -> [Example; 7] {
    [
        quintic_translation(),
        bilinear(),
        rotation(),
        sphere(),
        shifted_translation(20),
        hermite_translation(),
        offset_translation(),
    ]
}

/// The program of an example, proved.
pub(crate) fn scheduled(example: &Example) -> Program<Poly> {
    let program = schedule(&example.derived()).unwrap();
    assert_eq!(check(&program, &example.derived()), Ok(()));
    program
}

#[test]
fn other_sweeps_are_as_short() {
    let program = scheduled(&offset_translation());
    assert_eq!(operations(&program, outputs::SEPARATED_POINT, Stage::Both), 4);
    let program = scheduled(&plane());
    assert_eq!(program.count_all(program.results(outputs::POINT)).total(), 0);
}

#[test]
fn what_cannot_be_scheduled_is_an_error() {
    let mut example = plane();
    example.homogeneous[1] = Poly::variable(&Variable::new(Variable::SYMBOL, "c0"));
    let program = schedule(&example.derived()).unwrap();
    assert_eq!(program.symbols(), ["c0"]);
    example.homogeneous[0] = Poly::zero();
    assert_eq!(schedule(&example.derived()).unwrap_err(), ScheduleError::NoWeight);
}

fn operations(program: &Program<Poly>, output: &str, stage: Stage) -> usize {
    program.count(program.results(output), stage).total()
}

#[test]
fn translations_take_four_operations_a_grid_point() {
    let example = quintic_translation();
    let program = scheduled(&example);
    assert_eq!(operations(&program, outputs::SEPARATED_POINT, Stage::Both), 4);
    let single = program.count_all(program.results(outputs::POINT));
    assert!(single.total() <= 60, "{single}");
    assert_eq!(single.divisions, 1);
    // One reciprocal for each parameter.
    assert_eq!(program.count_all(program.results(outputs::SEPARATED_POINT)).divisions, 2);
    assert_eq!(operations(&program, outputs::UNIT_NORMAL, Stage::Both), 2);
}

#[test]
fn a_known_preimage_saves_operations() {
    let (_, _, _, v) = parameters();
    let (a, b) = (Poly::integer(3) + &v - v.pow(2), Poly::one() - v.pow(2).scale(&ratio(1, 2)) + &v);
    let mut example = translation(&a, &b);
    example.known.extend([("re_w".to_string(), a), ("im_w".to_string(), b)]);
    let program = scheduled(&example);
    let single = program.count_all(program.results(outputs::POINT));
    assert!(single.total() <= 46, "{single}");
}

#[test]
fn program_of_a_translation_reads_as_the_paper() {
    let (_, _, _, v) = parameters();
    let example = translation(&(Poly::one() + v.pow(2)), &(Poly::integer(2) - v));
    let program = scheduled(&example);
    assert_eq!(program.to_string(), include_str!("translation.txt"));
}

#[test]
fn other_weights_and_singular_factors_are_scheduled() {
    for example in [bilinear(), sphere()] {
        let program = scheduled(&example);
        assert_eq!(program.count_all(program.results(outputs::POINT)).divisions, 1);
    }
    let program = scheduled(&rotation());
    assert_eq!(operations(&program, outputs::SEPARATED_POINT, Stage::Both), 2);
}

/// The patch of Farouki & Nittler's Example 2, whose preimage lies in a field of degree 4.
fn hermite_translation() -> Example {
    let (_, _, _, v) = parameters();
    let rational = |n, d| Poly::constant(ratio(n, d));
    let root2 = Poly::sqrt_of(&integer(2));
    let theta = (Poly::integer(110) + &root2 * Poly::integer(100)).sqrt().unwrap();
    let part = &root2 * rational(3, 4);
    let re = &theta * rational(1, 4) - rational(3, 2) - &part;
    let im = (Poly::integer(90) + &root2 * Poly::integer(10)) * (&theta * Poly::integer(4)).inverse() - &part;
    let rest = Poly::one() - &v;
    let bernstein =
        |w: [&Poly; 3]| w[0] * rest.pow(2) + w[1] * Poly::integer(2) * &v * &rest + w[2] * v.pow(2);
    let (a, b) = (bernstein([&root2, &re, &Poly::integer(2)]), bernstein([&root2, &im, &Poly::zero()]));
    translation(&a, &b)
}

#[test]
fn radicals_stay_exact() {
    let example = hermite_translation();
    // s(1) = (2, 2), which ties the radicals together.
    let end = |place: usize| example.known[place].1.at(&[(&example.v, &integer(1))]);
    assert_eq!([end(1), end(2)], [Poly::integer(2), Poly::integer(2)]);
    let program = scheduled(&example);
    assert_eq!(operations(&program, outputs::SEPARATED_POINT, Stage::Both), 4);
    let single = program.count_all(program.results(outputs::POINT));
    assert!(single.total() <= 60, "{single}");
}

#[test]
fn names_are_not_needed() {
    let mut example = hermite_translation();
    example.known.clear();
    let program = scheduled(&example);
    assert_eq!(operations(&program, outputs::SEPARATED_POINT, Stage::Both), 4);
    let single = program.count_all(program.results(outputs::POINT));
    assert!(single.total() <= 60, "{single}");
}

#[test]
fn a_common_number_costs_nothing() {
    let mut example = quintic_translation();
    let before = scheduled(&example);
    example.homogeneous = example.homogeneous.map(|c| c.scale(&integer(44_100)));
    let after = scheduled(&example);
    let point = |program: &Program<Poly>| program.count_all(program.results(outputs::POINT));
    assert_eq!(point(&before), point(&after));
}

#[test]
fn a_wrong_program_is_refused() {
    let (right, mut wrong) = (quintic_translation(), quintic_translation());
    let program = scheduled(&right);
    wrong.homogeneous[2] = &wrong.homogeneous[2] + Poly::one();
    let difference = Mismatch::Differs { output: outputs::HOMOGENEOUS.to_string(), place: 2 };
    assert_eq!(check(&program, &wrong.derived()), Err(difference));
    let mut root = quintic_translation();
    root.root = Some(Poly::integer(7));
    assert_eq!(check(&program, &root.derived()), Err(Mismatch::Root));
    let mut turned = quintic_translation();
    turned.normal[1] = -&turned.normal[1];
    let normal = |place| Mismatch::Differs { output: outputs::UNIT_NORMAL.to_string(), place };
    assert_eq!(check(&program, &turned.derived()), Err(normal(1)));
    let (flat, mut turning) = (scheduled(&bilinear()), bilinear());
    turning.singular = Some(Poly::one() + Poly::variable(&turning.u));
    assert_eq!(check(&flat, &turning.derived()), Err(Mismatch::Missing(outputs::UNIT_NORMAL.to_string())));
    let mut other = turning.derived();
    let factor = Poly::variable(&turning.v);
    other.singular = Some(&factor);
    assert_eq!(check(&schedule(&other).unwrap(), &turning.derived()), Err(normal(0)));
    assert_eq!(
        check(&Program::new(), &right.derived()),
        Err(Mismatch::Missing(outputs::HOMOGENEOUS.to_string()))
    );
}

/// The largest error of the rounded program at some points, in units of 2^-53 of the result's size.
fn largest_error(example: &Example, output: &str) -> f64 {
    let program = scheduled(example);
    let floats = round(&program).unwrap();
    let results = program.results(output);
    let mut largest = 0.0_f64;
    for (i, j) in (0..=4).flat_map(|i| (0..=4).map(move |j| (i, j))) {
        let at = |[first, last]: &[Rational; 2], i: i64| {
            nearest(&Poly::constant(first + (last - first) * ratio(i, 4))).unwrap()
        };
        let (u, v) = (at(&example.domain[0], i), at(&example.domain[1], j));
        let numbers = Fractions {
            u: Poly::constant(exact(u).unwrap()),
            v: Poly::constant(exact(v).unwrap()),
            symbols: Vec::new(),
        };
        let expected: Vec<Poly> = interpret(&program, results, &numbers)
            .unwrap()
            .into_iter()
            .map(|(numerator, denominator)| numerator * denominator.inverse())
            .collect();
        let size = expected.iter().map(|x| nearest(x).unwrap().powi(2)).sum::<f64>().sqrt();
        for (found, expected) in
            interpret(&floats, results, &Floats { u, v, symbols: &[], variant: Variant::Plain })
                .unwrap()
                .iter()
                .zip(&expected)
        {
            let error = nearest(&(Poly::constant(exact(*found).unwrap()) - expected)).unwrap().abs();
            largest = largest.max(error / size * 2.0_f64.powi(53));
        }
    }
    largest
}

#[test]
fn rounded_programs_are_accurate() {
    for example in examples() {
        for output in [
            outputs::HOMOGENEOUS,
            outputs::POINT,
            outputs::SEPARATED_POINT,
            outputs::PARTIAL_U,
            outputs::PARTIAL_V,
        ] {
            let error = largest_error(&example, output);
            assert!(error < 16.0, "{output} is off by {error} units");
        }
    }
}

#[test]
fn far_domains_are_evaluated_around_their_middle() {
    let example = shifted_translation(20);
    let program = scheduled(&example);
    assert!(program.to_string().contains("= v - 41/2"), "{program}");
}

/// Σ c_ij u^i v^j with small coefficients, many of them zero.
fn small_poly(rows: usize, columns: usize) -> impl Strategy<Value = Poly> {
    let coefficient = prop_oneof![2 => Just(0), 3 => -3_i64..=3];
    let matrix = prop::collection::vec(prop::collection::vec(coefficient, columns), rows);
    matrix.prop_map(|matrix| {
        let (_, _, u, v) = parameters();
        let entry = |(i, j, c): (u32, u32, i64)| Poly::integer(c) * u.pow(i) * v.pow(j);
        let row = |(i, row): (u32, Vec<i64>)| (0..).zip(row).map(move |(j, c)| (i, j, c));
        (0..).zip(matrix).flat_map(row).map(entry).sum()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn schedules_of_any_surface_are_proved(
        factors in (small_poly(3, 1), small_poly(1, 3)),
        mixed in small_poly(2, 2),
        is_product in any::<bool>(),
        coordinates in [small_poly(4, 3), small_poly(3, 4), small_poly(2, 2)],
        normal in [small_poly(2, 3), small_poly(3, 2), small_poly(2, 2)],
    ) {
        let (u, v, ..) = parameters();
        let weight = if is_product { &factors.0 * &factors.1 } else { mixed };
        prop_assume!(!weight.is_zero());
        let [x, y, z] = coordinates;
        let example = Example {
            homogeneous: [weight, x, y, z],
            normal,
            root: None,
            singular: None,
            known: Vec::new(),
            domain: unit_square(),
            u,
            v,
        };
        let program = schedule(&example.derived()).unwrap();
        prop_assert_eq!(check(&program, &example.derived()), Ok(()));
    }
}
