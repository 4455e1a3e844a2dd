//! The compiled expansions are their programs: bit for bit what interpreting the programs gives.

use hodograph::{Float, Fused, Plain, Rounded};
use hodograph_codegen::bound::{Precision, Rounding};
use hodograph_codegen::compile::compile;
use hodograph_codegen::emit::{Artifact, TASKS};
use hodograph_codegen::meaning::Model;
use hodograph_codegen::program::{Interpreter, Value, Variant};
use hodograph_tests::arithmetic::Reals;
use hodograph_tests::catalogue::{Formulas, files};
use hodograph_tests::points::Points;
use hodograph_tests::surfaces::{Subject, concrete, members};

/// Points of each surface, in each precision and variant.
const POINTS: usize = 1000;

/// The sweeps of the catalogue that are expanded.
fn models() -> Vec<Model> {
    files().into_iter().filter(Formulas::is_expanded).flat_map(|formulas| formulas.models).collect()
}

/// The numbers of all tasks at all points, by interpretation: a list for each task and point.
fn interpreted<F: Float, R: Rounded<F>>(
    artifact: &Artifact,
    symbols: &[f64],
    tasks: &[Vec<Value>],
    places: &[(f64, f64)],
) -> Vec<Vec<Vec<f64>>> {
    let reals = Reals::new(
        places.iter().map(|&(u, _)| R::new(F::of(u))).collect(),
        places.iter().map(|&(_, v)| R::new(F::of(v))).collect(),
        symbols,
    );
    let mut interpreter = Interpreter::new(&artifact.program, &reals);
    interpreter.run(&tasks.concat()).unwrap();
    let numbers = |values: &[Value], place: usize| -> Vec<f64> {
        values.iter().map(|&value| interpreter.number(value).unwrap().at(place).value().to_f64()).collect()
    };
    tasks.iter().map(|values| (0..places.len()).map(|place| numbers(values, place)).collect()).collect()
}

fn compare(artifact: &Artifact, subject: &Subject) {
    let Subject { surface, symbols, .. } = subject;
    let symbols: Vec<f64> = artifact.program.symbols().iter().map(|name| symbols[name.as_str()]).collect();
    let tasks: Vec<Vec<Value>> = TASKS.iter().map(|task| task.results(&artifact.program)).collect();
    // Which NaN it is means nothing.
    let bits = |x: &f64| if x.is_nan() { f64::NAN.to_bits() } else { x.to_bits() };
    for (seed, rounding) in Rounding::ALL.into_iter().enumerate() {
        let mut points = Points::new(surface.as_ref(), rounding.precision, seed as u64);
        let mut places = points.border();
        while places.len() < POINTS {
            places.push(points.anywhere());
            places.push(points.near_border());
        }
        places.extend([(0.0, -0.0), (-3.0, 1e10), (f64::MAX, 0.5), (f64::NAN, 0.0), (0.5, f64::INFINITY)]);
        let interpreted = match (rounding.precision, rounding.variant) {
            (Precision::Double, Variant::Plain) => interpreted::<f64, Plain<f64>>,
            (Precision::Double, Variant::Fused) => interpreted::<f64, Fused<f64>>,
            (Precision::Single, Variant::Plain) => interpreted::<f32, Plain<f32>>,
            (Precision::Single, Variant::Fused) => interpreted::<f32, Fused<f32>>,
        };
        for (task, expected) in TASKS.iter().zip(interpreted(artifact, &symbols, &tasks, &places)) {
            for (&at, expected) in places.iter().zip(&expected) {
                let found = surface.numbers(task.name, rounding, at);
                assert!(
                    found.iter().map(bits).eq(expected.iter().map(bits)),
                    "{} of {} at {at:?} in {rounding:?}: {found:?}, by its program {expected:?}",
                    task.name,
                    surface.name()
                );
            }
        }
    }
}

#[test]
fn surfaces_compute_what_their_programs_do() {
    let (models, subjects) = (models(), concrete());
    for subject in &subjects {
        let model = models.iter().find(|model| model.name == subject.surface.name());
        let artifact = compile(model.unwrap_or_else(|| panic!("{} has no formula", subject.surface.name())));
        compare(&artifact.unwrap(), subject);
    }
    let catalogue: Vec<&str> = hodograph::catalogue::all().iter().map(|surface| surface.name()).collect();
    let tested: Vec<&str> = subjects.iter().map(|subject| subject.surface.name()).collect();
    assert_eq!(tested, catalogue);
}

#[test]
fn families_compute_what_their_programs_do() {
    let mut count = 0;
    for model in models() {
        // One member is enough: all of them are evaluated by the same code.
        if let Some(member) = members(&model.name).first() {
            compare(&compile(&model).unwrap(), member);
            count += 1;
        }
    }
    assert_eq!(count, hodograph_tests::catalogue::families().len());
}
