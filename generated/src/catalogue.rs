//! The catalogue: a module for each sweep, expanded from its formula in `formulas/` at build time.
//!
//! A sweep whose coefficients are all numbers is a unit type. One with symbolic constants is a family: its members are made at
//! run time, from preimages, Hermite data, control points and numbers, and checked then. Files with claims alone are for
//! `hodograph verify`.

use hodograph_macros::sweep;

use crate::Surface;

sweep!(file = "formulas/scaled_rotation_example_1.sweep");
sweep!(file = "formulas/oriented_translation_example_2.sweep");
sweep!(file = "formulas/offset_translation_example_3.sweep");
sweep!(file = "formulas/offset_translation_example_3_square.sweep");
sweep!(file = "formulas/offset_translation_example_3_negative_square.sweep");
sweep!(file = "formulas/oriented_involute_example_4.sweep");
sweep!(file = "formulas/evolute_sweep.sweep");
sweep!(file = "formulas/generalized_conical_example_5.sweep");
sweep!(file = "formulas/generalized_conical_quadratic.sweep");
sweep!(file = "formulas/rotation_minimizing_example.sweep");
sweep!(file = "formulas/pipe_example.sweep");

sweep!(file = "formulas/similarity_offset_example_4_7.sweep");
sweep!(file = "formulas/similarity_offset_example_4_8.sweep");
sweep!(file = "formulas/similarity_offset_example_5_3.sweep");

// The three patches of degree (2, 15) take longer to derive than all other entries together, so their code is checked in:
// `hodograph emit frames_gutter --target rust -o generated/src/catalogue/frames_gutter.rs` writes it, and the tests compare it.
include!("catalogue/frames_gutter.rs");

sweep!(file = "formulas/scaled_rotation_family.sweep");
sweep!(file = "formulas/oriented_translation_family.sweep");
sweep!(file = "formulas/oriented_translation_of_profiles.sweep");
sweep!(file = "formulas/offset_translation_family.sweep");
sweep!(file = "formulas/oriented_involute_family.sweep");
sweep!(file = "formulas/evolute_sweep_family.sweep");
sweep!(file = "formulas/generalized_conical_family.sweep");
sweep!(file = "formulas/generalized_conical_quadratic_family.sweep");

/// All surfaces of the catalogue, in a fixed order: that of their papers. Families are not among them; of a surface of several pieces
/// the pieces are.
///
/// ```
/// let surfaces = hodograph::catalogue::all();
/// let example = surfaces.iter().find(|surface| surface.name() == "oriented_translation_example_2").unwrap();
/// assert_eq!(example.degree(), (2, 9));
/// let [x, y, z] = example.point(0.0, 0.0).unwrap();
/// assert!(x == 1.0 && y.abs() < 1e-16 && z == 0.0);
/// ```
#[must_use]
pub fn all() -> &'static [&'static dyn Surface] {
    &[
        &scaled_rotation_example_1::ScaledRotationExample1,
        &oriented_translation_example_2::OrientedTranslationExample2,
        &offset_translation_example_3::OffsetTranslationExample3,
        &offset_translation_example_3_square::OffsetTranslationExample3Square,
        &offset_translation_example_3_negative_square::OffsetTranslationExample3NegativeSquare,
        &oriented_involute_example_4::OrientedInvoluteExample4,
        &evolute_sweep::EvoluteSweep,
        &generalized_conical_example_5::GeneralizedConicalExample5,
        &generalized_conical_quadratic::GeneralizedConicalQuadratic,
        &similarity_offset_example_4_7::SimilarityOffsetExample47,
        &similarity_offset_example_4_8::SimilarityOffsetExample48,
        &similarity_offset_example_5_3_mean_over_gaussian::SimilarityOffsetExample53MeanOverGaussian,
        &similarity_offset_example_5_3_inverse_mean::SimilarityOffsetExample53InverseMean,
        &rotation_minimizing_example::RotationMinimizingExample,
        &pipe_example::PipeExample,
        &frames_gutter_1::FramesGutter1,
        &frames_gutter_2::FramesGutter2,
        &frames_gutter_3::FramesGutter3,
    ]
}
