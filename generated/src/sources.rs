//! The text of the catalogue's formulas, and of the runtime that generated code uses.

/// A file by its name and text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Source {
    /// The name of the file, without its extension.
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

/// The files of this library that evaluators need, which are modules of these names: with them, emitted source compiles on
/// its own.
///
/// ```
/// let names: Vec<&str> = hodograph::runtime().iter().map(|source| source.name).collect();
/// assert_eq!(names, ["bernstein", "family", "grid", "regularity", "surface"]);
/// ```
#[must_use]
pub const fn runtime() -> &'static [Source] {
    &[
        Source { name: "bernstein", text: include_str!("bernstein.rs") },
        Source { name: "family", text: include_str!("family.rs") },
        Source { name: "grid", text: include_str!("grid.rs") },
        Source { name: "regularity", text: include_str!("regularity.rs") },
        Source { name: "surface", text: include_str!("surface.rs") },
    ]
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
    "oriented_involute_example_4",
    "evolute_sweep",
    "generalized_conical_example_5",
    "generalized_conical_quadratic",
    "scaled_rotation_family",
    "oriented_translation_family",
    "oriented_translation_of_profiles",
    "offset_translation_family",
    "oriented_involute_family",
    "evolute_sweep_family",
    "generalized_conical_family",
    "generalized_conical_quadratic_family",
    "planar_frame",
    "ph_hodographs",
    "ph_offsets",
    "ph_quintic_example_2",
    "scaled_rotation",
    "oriented_translation",
    "offset_translation",
    "oriented_involute",
    "evolute",
    "generalized_conical",
    "generalized_conical_common_factor",
    "symbolic_normals",
    "bilinear_forms",
];
