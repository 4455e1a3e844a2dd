//! Sweeps whose evaluators are to be accurate: the error of each coordinate relative to itself.

use hodograph::{Domain, Patch, Surface, Sweep, Variant};
use hodograph_codegen::compile::derive;
use hodograph_codegen::language::parse_text;
use hodograph_codegen::meaning::models;
use hodograph_tests::oracle::Oracle;
use hodograph_tests::random::SplitMix64;

hodograph::sweep! {
    /// Example 2 of the catalogue, accurately.
    sweep translation {
        profile p(u) = (1 - u^2)/(1 + u^2)*i + 2*u/(1 + u^2)*k;
        path s(v) = ph_hermite((0, 0), (0, 4), (2, 2), (4, 0));
        surface R = s + p.x*s.normal + p.z*k;
        domain u in 0..1, v in 0..1;
        prefer accurate;
    }

    /// Example 1 of the catalogue, accurately.
    sweep rotation {
        profile p(u) = (1 - u^2)/(1 + u^2)*i + 2*u/(1 + u^2)*k;
        path s(v) = bezier([(1, 0), (1, 0.8), (0.8, 1), (0, 1)]);
        surface R = p.x*s + p.z*k;
        domain u in 0..1, v in 0..1;
        prefer accurate;
    }

    /// Coordinates with zeros at ends of the domain that are no floats.
    sweep between {
        surface R = ((1/10 - v)^3*(1 + u), (1/3 - u)^2*(v + 1), (u + 1/7)*(1/10 - v)/(1 + u*v + u^2));
        domain u in -1/7..1/3, v in 0..1/10;
        prefer accurate;
    }
}

/// The most units in the last place that a coordinate may be off where its control points have one sign.
const MOST: f64 = 16.0;

/// The largest error of each coordinate in units of its own last place; `None` where control points have both signs.
fn largest_errors(surface: &dyn Surface, formula: &str) -> [Option<f64>; 3] {
    let text = format!("sweep s {{ {formula} }}");
    let (file, _) = parse_text("s.sweep", &text).unwrap();
    let derivation = derive(&models(&file).0[0]).unwrap();
    let oracle = Oracle::new(&derivation);
    let net = surface.control_net();
    let one_sign = |k: usize| {
        net.iter().all(|point| point[k] / point[0] >= 0.0)
            || net.iter().all(|point| point[k] / point[0] <= 0.0)
    };
    let mut largest = [1, 2, 3].map(|k| one_sign(k).then_some(0.0_f64));
    let mut random = SplitMix64::new(16);
    let Domain { u: of_u, v: of_v } = surface.domain();
    for k in 0..1000 {
        // Near the corners and edges too, where coordinates are small.
        let near = |t: f64| if k % 3 == 0 { t * 1e-9 } else { t };
        let (s, t) = (near(random.next_f64()), near(random.next_f64()));
        let at = |[first, last]: [f64; 2], s: f64| {
            let place = if k % 2 == 0 { first + (last - first) * s } else { last - (last - first) * s };
            // The float of an end may be beyond it.
            place.clamp(first.next_up(), last.next_down())
        };
        let (u, v) = (at(of_u, s), at(of_v, t));
        let point = surface.point(u, v).unwrap();
        for ((largest, found), exact) in largest.iter_mut().zip(point).zip(&oracle.at(u, v).point) {
            let Some(largest) = largest else { continue };
            let unit = f64::from_bits(found.abs().to_bits() + 1) - found.abs();
            *largest = largest.max(exact.distance(found) / unit);
        }
    }
    largest
}

#[test]
fn coordinates_are_accurate_where_control_points_have_one_sign() {
    let mut checked = 0;
    for variant in [Variant::Plain, Variant::Fused] {
        let (translation, rotation) =
            (translation::Translation.pinned(variant), rotation::Rotation.pinned(variant));
        let between = between::Between.pinned(variant);
        let surfaces: [(&dyn Surface, &str); 3] = [
            (&translation, translation::Translation::FORMULA),
            (&rotation, rotation::Rotation::FORMULA),
            (&between, between::Between::FORMULA),
        ];
        for (surface, formula) in surfaces {
            let largest = largest_errors(surface, formula);
            println!("{} {variant:?}: {largest:.2?} units in the last place", surface.name());
            checked += largest.iter().flatten().count();
            assert!(largest.iter().flatten().all(|&error| error <= MOST), "{}: {largest:?}", surface.name());
        }
    }
    assert!(checked >= 16, "only {checked} coordinates are checked");
}

#[test]
fn the_fast_point_is_not_as_accurate() {
    let fast = hodograph::catalogue::oriented_translation_example_2::OrientedTranslationExample2;
    let largest = largest_errors(
        &fast,
        hodograph::catalogue::oriented_translation_example_2::OrientedTranslationExample2::FORMULA,
    );
    assert!(largest.iter().flatten().any(|&error| error > MOST), "{largest:?}");
    // The preference is told to readers of the formula.
    assert!(translation::Translation::FORMULA.contains("prefer accurate;"));
    assert_eq!(translation::Translation.degree(), fast.degree());
}
