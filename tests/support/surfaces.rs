//! The surfaces of the catalogue with all that their expansions compute, whatever their types.

use std::collections::BTreeMap;

use hodograph::bernstein::power_coefficients;
use hodograph::ph::{from_control_points, hermite};
use hodograph::{
    Bounds, First, Float, Fused, Homogeneous, Local, Normal, Part, Plain, Point, Rounded, Second, Separated,
    Stages, Surface, Sweep, Task, catalogue,
};
use hodograph_codegen::bound::{Precision, Rounding};
use hodograph_codegen::program::Variant;

/// A surface that is expanded from a formula: its evaluators as they stand in the expansion, without the runtime around them.
pub trait Evaluator: Surface {
    /// The numbers of a task of [`TASKS`](hodograph_codegen::emit::TASKS), finite or not. In single precision the parameters
    /// are numbers of that precision.
    ///
    /// # Panics
    /// If there is no such task.
    fn numbers(&self, task: &str, rounding: Rounding, parameters: (f64, f64)) -> Vec<f64>;
}

/// The numbers moved along others by `r`, x + r·n, by the operation that the runtime has for offsets.
#[must_use]
pub fn moved(numbers: &[f64], along: &[f64], r: f64, Rounding { precision, variant }: Rounding) -> Vec<f64> {
    let moved = |(&x, &n): (&f64, &f64)| match (precision, variant) {
        (Precision::Double, Variant::Plain) => r * n + x,
        (Precision::Double, Variant::Fused) => r.mul_add(n, x),
        (Precision::Single, Variant::Plain) => f64::from(r as f32 * n as f32 + x as f32),
        (Precision::Single, Variant::Fused) => f64::from((r as f32).mul_add(n as f32, x as f32)),
    };
    numbers.iter().zip(along).map(moved).collect()
}

impl<S: Sweep> Evaluator for S {
    fn numbers(
        &self,
        task: &str,
        Rounding { precision, variant }: Rounding,
        parameters: (f64, f64),
    ) -> Vec<f64> {
        match (precision, variant) {
            (Precision::Double, Variant::Plain) => numbers::<S, f64, Plain<f64>>(self, task, parameters),
            (Precision::Double, Variant::Fused) => numbers::<S, f64, Fused<f64>>(self, task, parameters),
            (Precision::Single, Variant::Plain) => numbers::<S, f32, Plain<f32>>(self, task, parameters),
            (Precision::Single, Variant::Fused) => numbers::<S, f32, Fused<f32>>(self, task, parameters),
        }
    }
}

fn numbers<S: Sweep, F: Float, R: Rounded<F>>(surface: &S, task: &str, parameters: (f64, f64)) -> Vec<f64> {
    match task {
        "Homogeneous" => stages::<Homogeneous, S, F, R>(surface, parameters),
        "Point" => stages::<Point, S, F, R>(surface, parameters),
        "Separated" => stages::<Separated, S, F, R>(surface, parameters),
        "First" => stages::<First, S, F, R>(surface, parameters),
        "Second" => stages::<Second, S, F, R>(surface, parameters),
        "Normal" => stages::<Normal, S, F, R>(surface, parameters),
        "Local" => stages::<Local, S, F, R>(surface, parameters),
        _ => panic!("there is no task {task}"),
    }
}

fn stages<T: Task, S: Stages<T>, F: Float, R: Rounded<F>>(surface: &S, (u, v): (f64, f64)) -> Vec<f64> {
    let values = surface.join(surface.of_u(R::new(F::of(u))), surface.of_v(R::new(F::of(v))));
    (0..<T::Values<R> as Part<R>>::LENGTH).map(|k| values.get(k).value().to_f64()).collect()
}

/// A surface of the catalogue, or a member of one of its families.
pub struct Subject {
    /// Its evaluators.
    pub surface: Box<dyn Evaluator>,
    /// The values of a family's symbols.
    pub symbols: BTreeMap<&'static str, f64>,
    /// The bounds in the expansion of a surface that is no member of a family.
    pub bounds: Option<Bounds>,
}

impl Subject {
    fn member(
        surface: impl Sweep + 'static,
        symbols: impl IntoIterator<Item = (&'static str, f64)>,
    ) -> Subject {
        Subject { surface: Box::new(surface), symbols: symbols.into_iter().collect(), bounds: None }
    }
}

/// The surfaces without symbols, in the order of the catalogue.
#[must_use]
pub fn concrete() -> Vec<Subject> {
    macro_rules! subjects {
        ($($module:ident::$surface:ident),* $(,)?) => {
            vec![$({
                use catalogue::$module::$surface;
                Subject { surface: Box::new($surface), symbols: BTreeMap::new(), bounds: Some($surface::BOUNDS) }
            }),*]
        };
    }
    subjects![
        scaled_rotation_example_1::ScaledRotationExample1,
        oriented_translation_example_2::OrientedTranslationExample2,
        offset_translation_example_3::OffsetTranslationExample3,
        offset_translation_example_3_square::OffsetTranslationExample3Square,
        offset_translation_example_3_negative_square::OffsetTranslationExample3NegativeSquare,
        oriented_involute_example_4::OrientedInvoluteExample4,
        evolute_sweep::EvoluteSweep,
        generalized_conical_example_5::GeneralizedConicalExample5,
        generalized_conical_quadratic::GeneralizedConicalQuadratic,
        similarity_offset_example_4_7::SimilarityOffsetExample47,
        similarity_offset_example_4_8::SimilarityOffsetExample48,
        similarity_offset_example_5_3_mean_over_gaussian::SimilarityOffsetExample53MeanOverGaussian,
        similarity_offset_example_5_3_inverse_mean::SimilarityOffsetExample53InverseMean,
        rotation_minimizing_example::RotationMinimizingExample,
        pipe_example::PipeExample,
        frames_gutter_1::FramesGutter1,
        frames_gutter_2::FramesGutter2,
        frames_gutter_3::FramesGutter3,
    ]
}

/// Preimages of PH quintics: Hermite interpolants, one of them near Example 2, and one from its control points. They are
/// rounded to few bits, so that the exact numbers of the oracle stay short.
fn preimages() -> Vec<[[f64; 2]; 3]> {
    let points = [[0.0, 0.0], [0.2, 0.0], [0.4, 0.1], [17.0 / 30.0, 0.3], [2.0 / 3.0, 0.6], [2.0 / 3.0, 1.0]];
    let preimages = [
        hermite([0.0, 0.0], [0.0, 4.0], [2.0, 2.0], [4.0, 0.0]),
        hermite([0.0, 0.0], [3.0, 0.5], [2.0, 2.5], [0.25, 3.0]),
        from_control_points(&points),
    ];
    let rounded = |w: [[f64; 2]; 3]| w.map(|coefficient| coefficient.map(|x| (x * 256.0).round() / 256.0));
    preimages.map(|w| rounded(w.unwrap_or_else(|error| panic!("a curve of the tests: {error}")))).into()
}

/// The symbols of a preimage without a prefix.
fn preimage_symbols(w: &[[f64; 2]; 3]) -> Vec<(&'static str, f64)> {
    ["a0", "b0", "a1", "b1", "a2", "b2"].into_iter().zip(w.as_flattened().iter().copied()).collect()
}

/// Members of the family `name`.
///
/// # Panics
/// If a constructor rejects one.
#[must_use]
pub fn members(name: &str) -> Vec<Subject> {
    use catalogue::{
        evolute_sweep_family, generalized_conical_family, generalized_conical_quadratic_family,
        offset_translation_family, oriented_involute_family, oriented_translation_family,
        oriented_translation_of_profiles, scaled_rotation_family,
    };
    let along = |make: &dyn Fn([[f64; 2]; 3]) -> Subject, more: &[(&'static str, f64)]| {
        let member = |w: [[f64; 2]; 3]| {
            let mut member = make(w);
            member.symbols = preimage_symbols(&w).into_iter().chain(more.iter().copied()).collect();
            member
        };
        preimages().into_iter().map(member).collect::<Vec<Subject>>()
    };
    fn accepted<S: Sweep + 'static>(surface: Result<S, hodograph::ParameterError>) -> Subject {
        Subject::member(surface.unwrap_or_else(|error| panic!("a member of the tests: {error}")), [])
    }
    match name {
        "scaled_rotation_family" => {
            use scaled_rotation_family::{Parameters, ScaledRotationFamily};
            // A parabola from (2, 0) to (1, 1), and a quarter of the unit circle.
            let p = power_coefficients(&[[2.0, 0.0], [2.0, 0.75], [1.0, 1.0]]);
            let s = power_coefficients(&[[1.0, 1.0, 0.0], [1.0, 1.0, 1.0], [2.0, 0.0, 2.0]]);
            let mut member = accepted(ScaledRotationFamily::new(Parameters { p, s }));
            let names = ["s_w0", "s_x0", "s_y0", "s_w1", "s_x1", "s_y1", "s_w2", "s_x2", "s_y2"];
            member.symbols.extend(names.into_iter().zip(s.as_flattened().iter().copied()));
            let names = ["p_x0", "p_y0", "p_x1", "p_y1", "p_x2", "p_y2"];
            member.symbols.extend(names.into_iter().zip(p.as_flattened().iter().copied()));
            vec![member]
        }
        "oriented_translation_family" => {
            use oriented_translation_family::{OrientedTranslationFamily, Parameters};
            along(&|s| accepted(OrientedTranslationFamily::new(Parameters { s })), &[])
        }
        "oriented_translation_of_profiles" => {
            use oriented_translation_of_profiles::{OrientedTranslationOfProfiles, Parameters};
            let ([x0, x1, x2], [z0, z1, z2]) = ([0.25, 0.5, 0.125], [0.0, 0.75, 1.0]);
            along(
                &|s| accepted(OrientedTranslationOfProfiles::new(Parameters { s, x0, z0, x1, z1, x2, z2 })),
                &[("x0", x0), ("x1", x1), ("x2", x2), ("z0", z0), ("z1", z1), ("z2", z2)],
            )
        }
        "offset_translation_family" => {
            use offset_translation_family::{OffsetTranslationFamily, Parameters};
            let (c0, c1) = (0.125, 0.1875);
            along(
                &|p| accepted(OffsetTranslationFamily::new(Parameters { p, c0, c1 })),
                &[("c0", c0), ("c1", c1)],
            )
        }
        "oriented_involute_family" => {
            use oriented_involute_family::{OrientedInvoluteFamily, Parameters};
            along(&|s| accepted(OrientedInvoluteFamily::new(Parameters { s })), &[])
        }
        "evolute_sweep_family" => {
            use evolute_sweep_family::{EvoluteSweepFamily, Parameters};
            // Curves without vertices: elsewhere the sweep has singular points, near which normals are inaccurate.
            let curves = [[[1.0, 0.0], [2.0, 1.0], [2.0, 4.0]], [[1.0, 0.0], [1.0, 0.5], [1.0, 1.0]]];
            let member = |s: [[f64; 2]; 3]| {
                let mut member = accepted(EvoluteSweepFamily::new(Parameters { s }));
                member.symbols.extend(preimage_symbols(&s));
                member
            };
            curves.into_iter().map(member).collect()
        }
        "generalized_conical_family" => {
            use generalized_conical_family::{GeneralizedConicalFamily, Parameters};
            let (c0, c1) = (1.0, 0.5);
            along(
                &|s| accepted(GeneralizedConicalFamily::new(Parameters { s, c0, c1 })),
                &[("c0", c0), ("c1", c1)],
            )
        }
        "generalized_conical_quadratic_family" => {
            use generalized_conical_quadratic_family::{GeneralizedConicalQuadraticFamily, Parameters};
            let (c0, c1, c2) = (1.0, 0.25, 0.5);
            let mut member = accepted(GeneralizedConicalQuadraticFamily::new(Parameters { c0, c1, c2 }));
            member.symbols.extend([("c0", c0), ("c1", c1), ("c2", c2)]);
            vec![member]
        }
        _ => Vec::new(),
    }
}

/// All surfaces without symbols, and all members.
///
/// # Panics
/// As [`members`] does, and if there is no member of a family.
#[must_use]
pub fn all() -> Vec<Subject> {
    let mut all = concrete();
    for family in crate::catalogue::families() {
        let members = members(&family.name);
        assert!(!members.is_empty(), "there is no member of {}", family.name);
        all.extend(members);
    }
    all
}
