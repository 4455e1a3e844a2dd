//! All evaluators compute the same surface.

use hodograph::Surface;
use hodograph::catalogue::oriented_translation_example_2::OrientedTranslationExample2;
use hodograph_peers::{
    Curvo, DeCasteljau, Evaluator, First, Hoisted, Horner, Local, Net, Normal, Point, Quantity, Second, Truck,
};

fn net() -> Net {
    Net::new(OrientedTranslationExample2::DEGREE, &OrientedTranslationExample2::CONTROL_NET)
}

/// A length that is not a multiple of the number of lanes.
fn parameters() -> Vec<f64> {
    (0..=50).map(|k| f64::from(k) / 50.0).collect()
}

#[track_caller]
fn assert_near<const L: usize>(name: &str, found: [f64; L], expected: [f64; L]) {
    let size = expected.iter().fold(1.0_f64, |size, c| size.max(c.abs()));
    for (k, (found, expected)) in found.into_iter().zip(expected).enumerate() {
        assert!((found - expected).abs() <= 1e-12 * size, "{name}: number {k} is {found}, not {expected}");
    }
}

fn agree<Q: Quantity<L>, const L: usize>() {
    let net = net();
    let reference = DeCasteljau::new(&net);
    let (horner, mut hoisted) = (Horner::new(&net), Hoisted::new(&net));
    let (truck, curvo) = (Truck::new(&net), Curvo::new(&net));
    let us = parameters();
    let [mut row, mut points] = [(); 2].map(|()| vec![[f64::NAN; L]; us.len()]);
    for v in parameters() {
        hoisted.row::<Q, _, L>(&us, v, &mut row, |numbers| numbers);
        horner.points::<Q, _, L>(&us, &vec![v; us.len()], &mut points, |numbers| numbers);
        for (k, &u) in us.iter().enumerate() {
            let expected = reference.at::<Q, L>(u, v);
            assert_near("Horner", horner.at::<Q, L>(u, v), expected);
            assert_near("Horner on lanes", points[k], expected);
            assert_near("hoisted", row[k], expected);
            assert_near("truck", truck.at::<Q, L>(u, v), expected);
            assert_near("curvo", curvo.at::<Q, L>(u, v), expected);
        }
    }
}

#[test]
fn points() {
    agree::<Point, 3>();
}

#[test]
fn first_derivatives() {
    agree::<First, 9>();
}

#[test]
fn second_derivatives() {
    agree::<Second, 18>();
}

#[test]
fn normals() {
    agree::<Normal, 3>();
}

#[test]
fn curvatures() {
    agree::<Local, 39>();
}

#[test]
fn the_reference_is_the_surface() {
    let (surface, reference) = (OrientedTranslationExample2, DeCasteljau::new(&net()));
    for u in parameters() {
        for v in parameters() {
            let geometry = surface.local_geometry(u, v).expect("the patch is regular");
            assert_near("the surface", geometry.numbers(), reference.at::<Local, 39>(u, v));
        }
    }
}
