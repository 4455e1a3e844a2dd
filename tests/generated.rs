//! The catalogue's evaluators against exact evaluation.

use std::fmt::Write;

use hodograph::{BatchError, Separated, Surface, Sweep as _, Undefined, catalogue};
use hodograph_algebra::{Homogeneous, Rational};
use hodograph_codegen::round::nearest;
use hodograph_tests::catalogue::{Entry, entries};
use hodograph_tests::fixed::BITS;
use hodograph_tests::measure::{DISTANCES, RESOLUTION, UNIT, measure, parameters};
use hodograph_tests::oracle::Oracle;
use hodograph_tests::precision::{Quantity, allowance, allowance_on};
use hodograph_tests::random::SplitMix64;
use num_traits::One;

/// Runs `test` for each surface of the catalogue with what is derived from its formula.
fn for_each(mut test: impl FnMut(&'static dyn Surface, &Entry)) {
    let entries = entries();
    assert!(!entries.is_empty());
    assert_eq!(entries.len(), catalogue::all().len(), "the catalogue misses a sweep");
    for &surface in catalogue::all() {
        let entry = entries.iter().find(|entry| entry.model.name == surface.name());
        test(surface, entry.unwrap_or_else(|| panic!("{} has no formula", surface.name())));
    }
}

#[test]
fn floats_are_as_near_to_the_exact_values_as_stated() {
    let mut table = String::from("Largest errors, in units of 2^-53 times the size on the patch\n");
    let mut excessive = Vec::new();
    for_each(|surface, entry| {
        _ = writeln!(table, "\n{}", surface.name());
        let errors = measure(surface, &entry.derivation, &Rational::one());
        for quantity in Quantity::ALL {
            let errors = errors.get(&quantity).unwrap_or_else(|| panic!("{quantity:?} is not measured"));
            let (found, allowed) = (errors.relative(quantity), allowance_on(surface, quantity));
            let components: Vec<String> =
                errors.of_components().iter().map(|error| format!("{error:8.2}")).collect();
            let components = components.join(" ");
            let name = quantity.name();
            _ = writeln!(
                table,
                "  {name:<14}{found:8.2} of {allowed:6.1} allowed; by component {components}"
            );
            if found > allowed {
                excessive.push(format!("{} of {}: {found:.2} > {allowed}", name, surface.name()));
            }
        }
    });
    println!("{table}");
    assert!(excessive.is_empty(), "{table}\nbeyond what is allowed:\n{}", excessive.join("\n"));
}

hodograph::sweep! {
    /// The weight overflows before the other coordinates do.
    sweep far {
        surface R = (u^2, v^2, 1)/(1 + u^2 + v^2);
        domain u in 0..1, v in 0..1;
    }
}

#[test]
fn weights_beyond_the_range_of_floats_give_no_points() {
    let (far, t) = (far::Far, 1.2e154);
    assert_eq!(far.point(t, t), Err(Undefined::Overflow));
    assert_eq!(far.separated_point(t, t), Err(Undefined::Overflow));
    assert_eq!(far.partial_u(t, t), Err(Undefined::Overflow));
    assert_eq!(far.point(1.6e19_f32, 1.6e19), Err(Undefined::Overflow));
    let mut row = [[0.0_f64; 3]; 2];
    assert!(far.grid(&[0.5, t], &[t], &mut row).is_err());
    assert!(row[0].iter().all(|x| x.is_finite()) && row[1].iter().all(|x| x.is_infinite()), "{row:?}");
    assert!(far.batch(Separated).grid(&[0.5, t], &[t], &mut row[..]).is_err());
    // The weight does not overflow.
    let [x, y, z]: [f64; 3] = far.point(1e150, 0.0).unwrap();
    assert!((x - 1.0).abs() <= f64::EPSILON && y == 0.0 && z > 0.0, "{x}, {y}, {z}");
}

#[test]
fn enclosures_hold_the_numbers_of_the_field() {
    for_each(|surface, entry| {
        let oracle = Oracle::new(&entry.derivation);
        for (u, v) in parameters(surface).into_iter().take(16) {
            let enclosed = oracle.at(u, v).homogeneous;
            let size = enclosed.iter().fold(1.0, |size: f64, number| size.max(number.magnitude()));
            for (number, enclosed) in oracle.homogeneous_in_field(u, v).iter().zip(&enclosed) {
                assert!(enclosed.encloses(&number.enclosure(2 * BITS)), "{} at ({u}, {v})", surface.name());
                assert!(enclosed.width() < RESOLUTION * size, "{} at ({u}, {v})", surface.name());
            }
        }
    });
}

#[test]
fn surfaces_state_what_was_derived() {
    for_each(|surface, entry| {
        let degree = entry.derivation.homogeneous.degree();
        assert_eq!(surface.degree(), (degree.u as u32, degree.v as u32), "{}", surface.name());
        let domain = surface.domain();
        for (ends, interval) in [domain.u, domain.v].iter().zip(&entry.derivation.domain) {
            assert_eq!(
                ends.map(Ok),
                [nearest(interval.lower()), nearest(interval.upper())],
                "{}",
                surface.name()
            );
        }
        let exact = entry.control_net().points.iter().flatten();
        let exact: Vec<[f64; 4]> =
            exact.map(|point| point.each_ref().map(|number| nearest(number).unwrap())).collect();
        assert_eq!(surface.control_net(), exact, "{}", surface.name());
    });
}

#[test]
fn control_nets_meet_their_surfaces_at_the_corners() {
    for_each(|surface, _| {
        let (m, n) = (surface.degree().0 as usize, surface.degree().1 as usize);
        let net = surface.control_net();
        assert_eq!(net.len(), (m + 1) * (n + 1), "{}", surface.name());
        let corners = [(0.0, 0.0, 0), (0.0, 1.0, n), (1.0, 0.0, m * (n + 1)), (1.0, 1.0, net.len() - 1)];
        for (s, t, index) in corners {
            let (u, v) = surface.domain().at(s, t);
            let size = net.iter().flatten().fold(0.0, |size: f64, x| size.max(x.abs()));
            let allowed = allowance(Quantity::Homogeneous) * UNIT * size;
            for (i, (found, exact)) in surface.homogeneous(u, v).unwrap().iter().zip(net[index]).enumerate() {
                let name = Homogeneous::NAMES[i];
                assert!((found - exact).abs() <= allowed, "{}: {name} at ({u}, {v})", surface.name());
            }
        }
    });
}

#[test]
fn grids_have_the_bits_of_points() {
    for_each(|surface, _| {
        let mut random = SplitMix64::new(7);
        // One point, a row, a column, and more columns than are computed at a time.
        for (m, n) in [(1, 1), (17, 1), (1, 9), (16, 5), (300, 3)] {
            let (us, vs): (Vec<f64>, Vec<f64>) = {
                let mut list = |count: usize, end: usize| -> Vec<f64> {
                    let numbers = (0..count).map(|_| random.next_f64());
                    let pair = |t| {
                        if end == 0 { surface.domain().at(t, 0.0).0 } else { surface.domain().at(0.0, t).1 }
                    };
                    numbers.map(pair).collect()
                };
                (list(m, 0), list(n, 1))
            };
            let mut out = vec![[f64::NAN; 3]; m * n];
            assert_eq!(surface.grid(&us, &vs, &mut out), Ok(()));
            for (j, &v) in vs.iter().enumerate() {
                for (i, &u) in us.iter().enumerate() {
                    let (found, point) =
                        (out[j * m + i].map(f64::to_bits), surface.point(u, v).unwrap().map(f64::to_bits));
                    assert_eq!(found, point, "{} at ({u}, {v})", surface.name());
                }
            }
        }
        let mut short = [[7.0; 3]; 3];
        let wrong = surface.grid(&[0.0, 1.0], &[0.0, 1.0], &mut short);
        assert_eq!(wrong, Err(BatchError::Length { expected: 4, found: 3 }), "{}", surface.name());
        assert_eq!(short, [[7.0; 3]; 3], "{}", surface.name());
    });
}

#[test]
fn singular_points_are_explicit() {
    let surface: &dyn Surface = &catalogue::scaled_rotation_example_1::ScaledRotationExample1;
    for k in 0..=64 {
        let v = f64::from(k) / 64.0;
        // x(u) = 0 at u = 1, where the whole edge is one point of the axis.
        assert_eq!(surface.point(1.0, v), Ok([0.0, 0.0, 1.0]));
        assert_eq!(surface.unit_normal(1.0, v), Err(Undefined::Singular), "v = {v}");
        for r in DISTANCES {
            assert_eq!(surface.offset_point(r, 1.0, v), Err(Undefined::Singular), "v = {v}");
        }
        let before = surface.unit_normal(1.0 - f64::EPSILON, v);
        assert!(before.is_ok(), "v = {v}");
    }
}

#[test]
fn normals_are_of_unit_length_and_never_nan() {
    let floats =
        [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN_POSITIVE, -0.0, 1e-320, 1e160];
    for_each(|surface, _| {
        let places = floats.iter().flat_map(|&u| floats.iter().map(move |&v| (u, v)));
        for (u, v) in places.chain(parameters(surface)) {
            let (normal, offset) = (surface.unit_normal(u, v), surface.offset_point(0.5, u, v));
            if let Ok([x, y, z]) = normal {
                let length = (x * x + y * y + z * z).sqrt();
                let allowed = 2.0 * allowance(Quantity::UnitNormal) * UNIT;
                let inside = surface.domain().contains(u, v);
                assert!(length.is_finite(), "{} at ({u}, {v})", surface.name());
                assert!(
                    !inside || (length - 1.0).abs() <= allowed,
                    "{} at ({u}, {v}): {length}",
                    surface.name()
                );
            }
            if let Ok(point) = offset {
                assert!(point.iter().all(|x| x.is_finite()), "{} at ({u}, {v})", surface.name());
            }
        }
    });
}
