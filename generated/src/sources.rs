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

/// The files of data that the catalogue's formulas name, by their whole names.
///
/// ```
/// let frames = hodograph::inputs().iter().find(|input| input.name == "gutter.json").unwrap();
/// assert!(frames.text.contains("quaternion"));
/// ```
#[must_use]
pub const fn inputs() -> &'static [Source] {
    &[Source { name: "gutter.json", text: include_str!("../formulas/gutter.json") }]
}

/// The files of this library that evaluators need, which are modules of these names: with them and a module `float` of
/// `sqrt`, `sqrt_f32`, `mul_add` and `mul_add_f32`, emitted source compiles on its own. They have no unsafe code: what the
/// machine can do is what the build assumes.
///
/// ```
/// let names: Vec<&str> = hodograph::runtime().iter().map(|source| source.name).collect();
/// assert!(names.contains(&"surface") && names.contains(&"batch"));
/// ```
#[must_use]
pub const fn runtime() -> &'static [Source] {
    &[
        Source { name: "batch", text: include_str!("batch.rs") },
        Source { name: "bernstein", text: include_str!("bernstein.rs") },
        Source { name: "bounds", text: include_str!("bounds.rs") },
        Source { name: "dispatch", text: include_str!("dispatch.rs") },
        Source { name: "family", text: include_str!("family.rs") },
        Source { name: "machine", text: include_str!("machine/fixed.rs") },
        Source { name: "output", text: include_str!("output.rs") },
        Source { name: "pieces", text: include_str!("pieces.rs") },
        Source { name: "real", text: include_str!("real.rs") },
        Source { name: "surface", text: include_str!("surface.rs") },
        Source { name: "task", text: include_str!("task.rs") },
        Source { name: "tracked", text: include_str!("tracked.rs") },
        Source { name: "undefined", text: include_str!("undefined.rs") },
        Source { name: "values", text: include_str!("values.rs") },
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
    "rotation_minimizing_example",
    "pipe_example",
    "frames_gutter",
    "scaled_rotation_family",
    "oriented_translation_family",
    "oriented_translation_of_profiles",
    "offset_translation_family",
    "oriented_involute_family",
    "evolute_sweep_family",
    "generalized_conical_family",
    "generalized_conical_quadratic_family",
    "similarity_offset_example_4_7",
    "similarity_offset_example_4_8",
    "similarity_offset_example_5_3",
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
    "frames_sphere",
    "frames_surfaces",
    "frames_constructions",
    "similarity_invariance",
    "similarity_offsets",
    "similarity_examples",
    "similarity_offset_degrees",
    "spatial_frames",
];
