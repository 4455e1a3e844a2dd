//! The catalogue: a module for each sweep, expanded from its formula in `formulas/` at build time.
//!
//! Files with claims alone, and sweeps with symbolic constants, which no evaluator can know, are for `hodograph verify`.

use hodograph_macros::sweep;

use crate::Surface;

sweep!(file = "formulas/scaled_rotation_example_1.sweep");
sweep!(file = "formulas/oriented_translation_example_2.sweep");
sweep!(file = "formulas/offset_translation_example_3.sweep");
sweep!(file = "formulas/offset_translation_example_3_square.sweep");
sweep!(file = "formulas/offset_translation_example_3_negative_square.sweep");

/// All surfaces of the catalogue, in a fixed order: that of the examples in their papers.
///
/// ```
/// let surfaces = hodograph::catalogue::all();
/// let example = surfaces.iter().find(|surface| surface.name() == "oriented_translation_example_2").unwrap();
/// assert_eq!(example.degree(), (2, 9));
/// assert_eq!(example.point(0.0, 0.0), [1.0, 0.0, 0.0]);
/// ```
#[must_use]
pub fn all() -> &'static [&'static dyn Surface] {
    &[
        &scaled_rotation_example_1::ScaledRotationExample1,
        &oriented_translation_example_2::OrientedTranslationExample2,
        &offset_translation_example_3::OffsetTranslationExample3,
        &offset_translation_example_3_square::OffsetTranslationExample3Square,
        &offset_translation_example_3_negative_square::OffsetTranslationExample3NegativeSquare,
    ]
}
