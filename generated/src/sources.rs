//! The text of the catalogue's formulas.

/// A file of the catalogue in the sweep language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Source {
    /// The name of the file, without its extension `.sweep`.
    pub name: &'static str,
    /// The whole text.
    pub text: &'static str,
}

/// All files of the catalogue: surfaces first, then those that hold nothing but claims.
///
/// ```
/// let names: Vec<&str> = hodograph::sources().iter().map(|source| source.name).collect();
/// assert!(names.contains(&"oriented_translation_example_2"));
/// ```
#[must_use]
pub const fn sources() -> &'static [Source] {
    SOURCES
}

/// The files with these names, in this order.
macro_rules! formulas {
    ($($name:literal),* $(,)?) => {
        &[$(Source { name: $name, text: include_str!(concat!("../formulas/", $name, ".sweep")) }),*]
    };
}

const SOURCES: &[Source] = formulas![
    "scaled_rotation_example_1",
    "oriented_translation_example_2",
    "offset_translation_example_3",
    "offset_translation_example_3_square",
    "offset_translation_example_3_negative_square",
    "planar_frame",
    "scaled_rotation",
    "oriented_translation",
    "offset_translation",
    "ph_offsets",
    "ph_quintic_example_2",
    "bilinear_forms",
];
