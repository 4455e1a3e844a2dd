//! Families of the catalogue: evaluators whose coefficients are set at run time, against exact evaluation.

use std::fmt::Write;

use hodograph::ph::{PhError, hermite};
use hodograph::{ParameterError, Surface, Undefined, catalogue};
use hodograph_algebra::{Complex, Hermite, Poly};
use hodograph_codegen::round::nearest;
use hodograph_tests::catalogue::{families, member};
use hodograph_tests::measure::measure;
use hodograph_tests::precision::family_allowance;
use hodograph_tests::random::SplitMix64;
use hodograph_tests::surfaces::{Subject, members};

#[test]
fn families_are_as_near_to_the_exact_values_as_stated() {
    let mut table = String::from("Largest errors, in units of 2^-53 times the size on the patch\n");
    let mut excessive = Vec::new();
    let families = families();
    assert!(!families.is_empty());
    for family in &families {
        let members = members(&family.name);
        assert!(!members.is_empty(), "the test has no member of {}", family.name);
        for (place, Subject { surface, symbols, .. }) in members.iter().enumerate() {
            let (derivation, scale) = member(family, symbols);
            let degree = derivation.homogeneous.degree();
            assert!(surface.degree() >= (degree.u as u32, degree.v as u32), "{}", family.name);
            _ = writeln!(table, "\n{} {place}", surface.name());
            for (quantity, errors) in measure(surface.as_ref(), &derivation, &scale) {
                let (found, allowed) = (errors.relative(quantity), family_allowance(quantity));
                let name = quantity.name();
                _ = writeln!(table, "  {name:<14}{found:8.2} of {allowed:6.1} allowed");
                if found > allowed {
                    excessive.push(format!("{name} of {} {place}: {found:.2} > {allowed}", surface.name()));
                }
            }
        }
    }
    println!("{table}");
    assert!(excessive.is_empty(), "{table}\nbeyond what is allowed:\n{}", excessive.join("\n"));
}

#[test]
fn grids_of_families_have_the_bits_of_points() {
    for family in families() {
        for Subject { surface, .. } in members(&family.name) {
            let (us, vs) = ([0.0, 0.3, 1.0], [0.1, 0.9]);
            let mut out = [[f64::NAN; 3]; 6];
            assert_eq!(surface.grid(&us, &vs, &mut out), Ok(()));
            for (j, &v) in vs.iter().enumerate() {
                for (i, &u) in us.iter().enumerate() {
                    let (found, point) =
                        (out[j * 3 + i].map(f64::to_bits), surface.point(u, v).unwrap().map(f64::to_bits));
                    assert_eq!(found, point, "{} at ({u}, {v})", surface.name());
                }
            }
        }
    }
}

#[test]
fn members_agree_with_the_concrete_examples() {
    use catalogue::oriented_translation_example_2::OrientedTranslationExample2;
    use catalogue::oriented_translation_family::{OrientedTranslationFamily, Parameters};
    let s = hermite([0.0, 0.0], [0.0, 4.0], [2.0, 2.0], [4.0, 0.0]).unwrap();
    let member = OrientedTranslationFamily::new(Parameters { s }).unwrap();
    assert_eq!(member.parameters(), &Parameters { s });
    for k in 0..=16 {
        let (u, v) = (f64::from(k) / 16.0, f64::from((5 * k) % 17) / 16.0);
        let (found, exact) = (member.point(u, v).unwrap(), OrientedTranslationExample2.point(u, v).unwrap());
        for (a, b) in found.iter().zip(exact) {
            assert!((a - b).abs() < 1e-14, "at ({u}, {v})");
        }
    }
}

#[test]
fn parameters_are_checked() {
    use catalogue::oriented_translation_family::{OrientedTranslationFamily, Parameters};
    let new = |s| OrientedTranslationFamily::new(Parameters { s });
    let wrong = new([[1.0, 0.0], [f64::NAN, 0.0], [1.0, 1.0]]);
    assert_eq!(wrong.unwrap_err(), ParameterError::NotFinite { parameter: "s" });
    // w = 1 − 2v vanishes at 1/2, where the curve has a cusp.
    let Err(ParameterError::Pole { v, .. }) = new([[1.0, 0.0], [0.0, 0.0], [-1.0, 0.0]]) else {
        panic!("a cusp passes")
    };
    assert!((v - 0.5).abs() < 1e-6, "{v}");
    // w = v − 1/3 vanishes where no halving of the domain ends.
    let third = [[-1.0 / 3.0, 0.0], [1.0 / 6.0, 0.0], [2.0 / 3.0, 0.0]];
    let Err(ParameterError::Pole { v, .. }) = new(third) else { panic!("a cusp passes") };
    assert!((v - 1.0 / 3.0).abs() < 1e-4, "{v}");
    assert_eq!(new([[1e200, 0.0], [1.0, 0.0], [1.0, 1.0]]).unwrap_err(), ParameterError::Overflow);
    assert!(matches!(new([[0.0; 2]; 3]), Err(ParameterError::Pole { .. })));
}

#[test]
fn singular_points_of_families_are_explicit() {
    use catalogue::oriented_translation_family::{OrientedTranslationFamily, Parameters};
    // A circle-like turn to the right: 1 + κx changes its sign on the domain, and the normal turns over there.
    let surface =
        OrientedTranslationFamily::new(Parameters { s: [[1.0, 0.0], [1.0, -1.0], [0.5, -2.0]] }).unwrap();
    let sides: Vec<bool> = (0..=200)
        .filter_map(|k| surface.unit_normal(0.0, f64::from(k) / 200.0).ok())
        .map(|[x, y, _]| x + y > 0.0)
        .collect();
    assert!(sides.len() >= 200, "normals are there almost everywhere");
    let turns = sides.windows(2).filter(|pair| pair[0] != pair[1]).count();
    assert!(turns > 0, "the normal turns over where 1 + kappa x changes its sign");
    assert_eq!(surface.unit_normal(f64::NAN, 0.0), Err(Undefined::Parameter));
}

#[test]
fn the_float_solver_chooses_the_curve_that_exact_comparison_chooses() {
    let mut random = SplitMix64::new(1995);
    let mut compared = 0;
    for _ in 0..60 {
        let mut number = || (random.next_f64() * 16.0).floor() - 8.0;
        let data: [[f64; 2]; 4] = std::array::from_fn(|_| [number(), number()]);
        let exact = data.map(|[x, y]| Complex::new(Poly::integer(x as i64), Poly::integer(y as i64)));
        let [from, tangent, to, end] = data;
        let found = hermite(from, tangent, to, end);
        let Ok(exact) = Hermite::new(&exact[0], &exact[1], &exact[2], &exact[3]) else {
            assert_eq!(found, Err(PhError::ZeroTangent), "{data:?}");
            continue;
        };
        // Ties, and curves through a point without tangent, are left to the caller there.
        let Ok(preimage) = exact.least_rotation() else { continue };
        let found = found.unwrap();
        let truth: Vec<[f64; 2]> = preimage
            .coefficients()
            .iter()
            .map(|w| [nearest(&w.re).unwrap(), nearest(&w.im).unwrap()])
            .collect();
        // Both signs of w give the same curve.
        let same = |sign: f64| {
            let pairs = found.as_flattened().iter().zip(truth.as_flattened());
            pairs.map(|(a, b)| (a - sign * b).abs()).fold(0.0, f64::max)
        };
        let size = truth.as_flattened().iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        assert!(same(1.0).min(same(-1.0)) <= 1e-14 * size, "{data:?}: {found:?}, exactly {truth:?}");
        compared += 1;
    }
    assert!(compared >= 40, "only {compared} data are compared");
}

hodograph::sweep! {
    /// A sweep along a cubic with the hodograph (1 + c v) w², whose parametric speed must stay positive.
    sweep parameters {
        symbol c, where_;
        path s(v) = ph([1, 1 + I], factor = 1 + c*v);
        surface R = s + u*where_*s.normal + u*k;
        domain u in 0..1, v in 0..2;
    }
}

#[test]
fn parametric_speeds_are_checked() {
    let new = |c| parameters::Parameters::new(parameters::FamilyParameters { c, where_: 1.0 });
    let surface = new(0.5).unwrap();
    assert_eq!(surface.point(0.0, 0.0), Ok([0.0; 3]));
    // s' = (1 + c v)(1 + i v)², s(1) = 2/3 + c/4 + i (1 + 2c/3)
    let [x, y, z]: [f64; 3] = surface.point(0.0, 1.0).unwrap();
    assert!((x - (2.0 / 3.0 + 0.125)).abs() < 1e-15 && (y - 4.0 / 3.0).abs() < 1e-15 && z == 0.0);
    // 1 + c v vanishes at v = 2, and changes its sign on the domain.
    assert_eq!(new(-0.5).unwrap_err(), ParameterError::Speed);
    assert_eq!(new(-1.0).unwrap_err(), ParameterError::Speed);
    assert!(new(-0.499).is_ok());
}

hodograph::sweep! {
    /// A family of planes, of which the normal depends on the symbol alone.
    sweep tilted {
        symbol a;
        surface R = (u, v, a*u);
        domain u in 0..1, v in 0..1;
    }
}

hodograph::sweep! {
    /// The same where the symbol is a divisor, so that the derivative of a coordinate is one of its factors.
    sweep divided {
        symbol a;
        surface R = (u, v, u/a);
        domain u in 0..1, v in 0..1;
    }
}

hodograph::sweep! {
    /// A family of cylinders that is singular for a = 0.
    sweep cylinder {
        symbol a;
        surface R = (a*u, a*u^2, v);
        domain u in 0..1, v in 0..1;
    }
}

#[test]
fn normals_may_depend_on_symbols_alone() {
    fn is_near<const N: usize>(found: Result<[f64; N], Undefined>, expected: [f64; N]) -> bool {
        found.is_ok_and(|found| found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= f64::EPSILON))
    }
    let plane = tilted::Tilted::new(tilted::Parameters { a: 0.75 }).unwrap();
    assert!(is_near(plane.unit_normal(0.25, 0.5), [-0.6, 0.0, 0.8]));
    let other = divided::Divided::new(divided::Parameters { a: 4.0 / 3.0 }).unwrap();
    assert!(is_near(other.point(0.5, 0.25), [0.5, 0.25, 0.375]));
    assert!(is_near(other.unit_normal(0.25, 0.5), [-0.6, 0.0, 0.8]));
    for sign in [1.0, -1.0] {
        let cylinder = cylinder::Cylinder::new(cylinder::Parameters { a: 2.0 * sign }).unwrap();
        assert!(is_near(cylinder.unit_normal(0.375, 0.5), [0.6 * sign, -0.8 * sign, 0.0]));
    }
    let degenerate = cylinder::Cylinder::new(cylinder::Parameters { a: 0.0 }).unwrap();
    assert_eq!(degenerate.unit_normal(0.375, 0.5), Err(Undefined::Singular));
}
