//! The surface of several pieces of the catalogue: its code, its joints, and its evaluators over all of its parameters.

use hodograph::catalogue::frames_gutter::FramesGutter;
use hodograph::catalogue::{
    frames_gutter_1::FramesGutter1, frames_gutter_2::FramesGutter2, frames_gutter_3::FramesGutter3,
};
use hodograph::{Float, Normal, Patch, Separated, Surface, Variant};
use hodograph_codegen::compile::compile_all;
use hodograph_codegen::emit;
use hodograph_tests::catalogue::files;
use hodograph_tests::cost::CHECKED_IN;

/// The code as it is checked in.
const CODE: &str = include_str!("../generated/src/catalogue/frames_gutter.rs");

#[test]
fn checked_in_code_is_what_the_formula_gives() {
    let formulas = files().into_iter().find(|formulas| formulas.stem == CHECKED_IN).unwrap();
    let artifacts: Vec<_> =
        compile_all(&formulas.models).into_iter().map(|(_, artifact)| artifact.unwrap()).collect();
    let text = emit::format(emit::modules(&artifacts, &"::hodograph".parse().unwrap())).unwrap();
    let line = CODE.lines().zip(text.lines()).take_while(|(found, expected)| found == expected).count() + 1;
    assert!(
        CODE == text,
        "line {line} differs; `cargo run -- emit frames_gutter --target rust -o generated/src/catalogue/frames_gutter.rs` mends it"
    );
}

/// Parameters u across the domain.
fn us<F: Float>() -> Vec<F> {
    (0..=200).map(|i| F::of(f64::from(i - 100) / 100.0)).collect()
}

/// The largest distance of the points of two neighbors at a joint.
fn gap<F: Float>(before: &dyn Surface<F>, after: &dyn Surface<F>, joint: f64) -> f64 {
    let distance = |u: F| {
        let [a, b] = [before, after].map(|piece| piece.point(u, F::of(joint)).unwrap().map(F::to_f64));
        a.iter().zip(&b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
    };
    us().into_iter().map(distance).fold(0.0, f64::max)
}

fn joints_are_closed<F: Float>(variant: Variant, least: f64) {
    use hodograph::Sweep;
    let jump = FramesGutter.jump::<F>(variant);
    let gaps = [
        gap::<F>(&FramesGutter1.pinned(variant), &FramesGutter2.pinned(variant), 1.0),
        gap::<F>(&FramesGutter2.pinned(variant), &FramesGutter3.pinned(variant), 2.0),
    ];
    println!("{variant:?}: gaps {gaps:?}, at most {jump}");
    assert!(gaps.iter().all(|&gap| gap <= jump), "{gaps:?} {jump}");
    // The bound is of the size of rounding errors, and there are some.
    assert!(jump < 100.0 * least && gaps.iter().any(|&gap| gap > 0.0), "{gaps:?} {jump}");
}

#[test]
fn neighbors_meet_within_the_proved_bound() {
    assert_eq!(FramesGutter.piece_at(1.0) - FramesGutter.piece_at(1.0_f64.next_down()), 1);
    for variant in [Variant::Plain, Variant::Fused] {
        joints_are_closed::<f64>(variant, 12.0 * 2.0_f64.powi(-53));
        joints_are_closed::<f32>(variant, 12.0 * 2.0_f64.powi(-24));
    }
}

#[test]
fn the_whole_is_evaluated_by_its_pieces() {
    assert_eq!(FramesGutter.degree(), (2, 15));
    assert_eq!(FramesGutter.domain(), hodograph::Domain { u: [-1.0, 1.0], v: [0.0, 3.0] });
    let (us, vs) = (us::<f64>(), (0..=90).map(|j| f64::from(j) / 30.0).collect::<Vec<_>>());
    let mut grid = vec![[0.0; 3]; us.len() * vs.len()];
    FramesGutter.grid(&us, &vs, &mut grid).unwrap();
    let mut separated = grid.clone();
    FramesGutter.batch(Separated).grid(&us, &vs, &mut separated[..]).unwrap();
    let mut normals = grid.clone();
    assert_eq!(FramesGutter.batch(Normal).grid(&us, &vs, &mut normals[..]), Ok(0));
    for (j, &v) in vs.iter().enumerate() {
        let piece: &dyn Surface = match v {
            ..1.0 => &FramesGutter1,
            ..2.0 => &FramesGutter2,
            _ => &FramesGutter3,
        };
        for (i, &u) in us.iter().enumerate() {
            let at = j * us.len() + i;
            assert_eq!(Ok(grid[at]), piece.point(u, v));
            assert_eq!(Ok(separated[at]), piece.separated_point(u, v));
            assert_eq!(Ok(normals[at]), piece.unit_normal(u, v));
            assert_eq!(FramesGutter.local_geometry(u, v), piece.local_geometry(u, v));
        }
    }
    // It passes through the frames: half a circle about the first and the last position.
    let near = |u: f64, v: f64, expected: [f64; 3]| {
        let found = FramesGutter.point(u, v).unwrap();
        found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-14)
    };
    // The first frame turns (0, -1) by 2 arccos(24/25) about the z-axis.
    assert!(near(-1.0, 0.0, [2.0 * 0.96 * 0.28, -(0.96 * 0.96 - 0.28 * 0.28), 2.0]));
    assert!(near(0.0, 0.0, [0.0, 0.0, 1.0]));
    assert!(near(0.0, 3.0, [12.0, 0.0, -1.0]));
}
