//! Surfaces of several pieces: the functions of the whole take the piece that v belongs to, as those in Rust do.

use std::fmt::Write;
use std::fs;

use hodograph::catalogue::{frames_gutter, frames_gutter_1, frames_gutter_2, frames_gutter_3};
use hodograph::{Pieces, Piecewise};
use hodograph_codegen::bound::{Precision, Rounding};
use hodograph_codegen::compile::compile_all;
use hodograph_codegen::emit::{Artifact, header};
use hodograph_codegen::language::parse_text;
use hodograph_codegen::meaning::models;
use hodograph_codegen::program::Variant;
use hodograph_tests::catalogue::files;
use hodograph_tests::points::{neighbor, rounded};
use hodograph_tests::random::SplitMix64;
use hodograph_tests::surfaces::Evaluator;

use crate::constants::stated;
use crate::evaluation::{Called, POINTS, evaluation, with_distances};
use crate::functions::{Function, Outcome, Place, TYPES, Type, bits, runtime};
use crate::program::{Expected, LANGUAGES, beginning, compare, has_compiler, run};

sweeps! {
    // Joints that are no floats of one precision or of both, a pole at u = 2, and no normal at u = 0. Its name begins as those of
    // the header do.
    sweep hodograph_steps {
        profile c(u) = (0, u^2/(2 - u), 0);
        frames F(v) = frames([
            frame((0, 0, 0), (1, 0, 0, 0)), frame((1, 0, 0), (1, 0, 0, 0)), frame((3, 0, 0), (1, 0, 0, 0)), frame((4, 0, 1), (1, 0, 0, 0)),
            frame((5, 0, 0), (1, 0, 0, 0)), frame((9, 0, 0), (1, 0, 0, 0))], knots = [0, 1/3, 1/2, 7/10, 1, 2]);
        surface R = F.sweep(c);
        domain u in 0..1;
    }
}

/// A whole with its pieces by themselves.
struct Whole<'a, P> {
    name: &'a str,
    surface: Piecewise<P>,
    pieces: &'a [&'a dyn Evaluator],
}

impl<P: Pieces> Called for Whole<'_, P> {
    fn name(&self) -> &str {
        self.name
    }

    /// At the joints and beside them, outside of the domain, at no places, and all over the domain: many v follow one of another
    /// piece, and some of the same.
    fn places(&self, precision: Precision) -> Vec<Place> {
        let mut random = SplitMix64::new(5);
        let round = |number: f64| rounded(number, precision);
        let ([u_first, u_last], [v_first, v_last]) = (P::DOMAIN.u, P::DOMAIN.v);
        let mut vs = Vec::new();
        for joint in P::JOINTS.iter().map(|&joint| round(joint)) {
            vs.extend([joint, neighbor(joint, precision, false), joint, neighbor(joint, precision, true)]);
        }
        for end in [round(v_last), round(v_first)] {
            vs.extend([end, neighbor(end, precision, false), neighbor(end, precision, true)]);
        }
        vs.extend([f64::NAN, v_last + 2.5, v_first - 2.5, f64::INFINITY, -0.0, f64::NEG_INFINITY, 1e30]);
        assert!(vs.len() < self.rows());
        let mut us = vec![u_last, 0.0, 2.0, -1.5, 1e18, f64::NAN, u_first, f64::NEG_INFINITY];
        let mut between = |[first, last]: [f64; 2]| round(first + (last - first) * random.next_f64());
        while vs.len() < POINTS {
            let v = between(P::DOMAIN.v);
            vs.extend([v, neighbor(v, precision, true)]);
        }
        us.extend((us.len()..vs.len()).map(|_| between(P::DOMAIN.u)));
        // So that the same v are tried at other u among the independent points.
        us.rotate_right(self.rows());
        with_distances(us.into_iter().map(round).zip(vs.into_iter().map(round)).collect(), precision)
    }

    fn rows(&self) -> usize {
        40
    }

    /// What the whole gives in Rust, which is what the piece gives.
    fn outcome(&self, function: &Function, precision: Precision, place: Place) -> Outcome {
        let outcome = match precision {
            Precision::Double => runtime::<f64>(&self.surface, function.name, place),
            Precision::Single => runtime::<f32>(&self.surface, function.name, place),
        };
        let piece = self.pieces[P::JOINTS.iter().filter(|&&joint| joint <= place.1).count()];
        let of_piece = function.outcome(piece, Rounding { precision, variant: Variant::Plain }, place);
        assert_eq!(bits(&outcome), bits(&of_piece), "{} of {} at {place:?}", function.name, self.name);
        outcome
    }
}

impl<P: Pieces> Whole<'_, P> {
    /// The C code of a function that evaluates everything, and the lines that it prints.
    fn function(&self, text: &mut String, expected: &mut Expected) {
        let name = self.name;
        _ = writeln!(text, "static void run_{name}(void)\n{{");
        stated(text, expected, name, &self.surface, P::BOUNDS);
        let mut expect = |what: &str, numbers: &[f64]| {
            expected.push((format!("{what} of {name}"), TYPES[0].line(numbers)));
        };
        _ = writeln!(text, "    put(HODOGRAPH_OK, {name}_joints, {name}_count - 1);");
        expect("joints", P::JOINTS);
        _ = writeln!(
            text,
            "    {{\n        const double jumps[2] = {{{name}_jump, {name}_jump_f}};\n        put(HODOGRAPH_OK, jumps, 2);\n    }}"
        );
        let plain = hodograph::Variant::Plain;
        expect("jumps", &[self.surface.jump::<f64>(plain), self.surface.jump::<f32>(plain)]);
        for kind @ Type { name: real, suffix, precision, .. } in TYPES {
            let vs: Vec<f64> = self.places(precision).into_iter().map(|(_, v, _)| v).collect();
            let list: Vec<String> = vs.iter().map(|&v| literal(kind, v)).collect();
            let length = vs.len();
            _ = writeln!(
                text,
                "    {{
        const {real} vs[{length}] = {{{}}};
        double pieces[{length}];
        for (size_t i = 0; i < {length}; i++)
            pieces[i] = (double){name}_piece_at{suffix}(vs[i]);
        put(HODOGRAPH_OK, pieces, {length});
    }}",
                list.join(", ")
            );
            let piece_at = |&v: &f64| match precision {
                Precision::Double => self.surface.piece_at(v) as f64,
                Precision::Single => self.surface.piece_at(v as f32) as f64,
            };
            expect("pieces", &vs.iter().map(piece_at).collect::<Vec<f64>>());
        }
        evaluation(text, expected, self);
        text.push_str("}\n\n");
    }
}

/// A number in C.
fn literal(kind: Type, number: f64) -> String {
    match (number, kind.precision) {
        _ if number.is_nan() => "NAN".to_owned(),
        (f64::INFINITY, _) => "INFINITY".to_owned(),
        (f64::NEG_INFINITY, _) => "-INFINITY".to_owned(),
        (_, Precision::Double) => format!("{number:?}"),
        (_, Precision::Single) => format!("{:?}f", number as f32),
    }
}

/// All pieces of both surfaces.
fn artifacts() -> Vec<Artifact> {
    let gutter = files().into_iter().find(|formulas| formulas.stem == "frames_gutter").unwrap();
    let (steps, mistakes) = models(&parse_text("steps.sweep", TEXT).unwrap().0);
    assert!(mistakes.is_empty(), "{mistakes:?}");
    let models = gutter.models.iter().chain(&steps);
    compile_all(models).into_iter().map(|(_, artifact)| artifact.unwrap()).collect()
}

#[test]
fn the_whole_has_the_bits_of_its_pieces() {
    let gutter = Whole {
        name: "frames_gutter",
        surface: frames_gutter::FramesGutter.pinned(hodograph::Variant::Plain),
        pieces: &[
            &frames_gutter_1::FramesGutter1,
            &frames_gutter_2::FramesGutter2,
            &frames_gutter_3::FramesGutter3,
        ],
    };
    let steps = Whole {
        name: "sweep_hodograph_steps",
        surface: hodograph_steps::HodographSteps.pinned(hodograph::Variant::Plain),
        pieces: &[
            &hodograph_steps_1::HodographSteps1,
            &hodograph_steps_2::HodographSteps2,
            &hodograph_steps_3::HodographSteps3,
            &hodograph_steps_4::HodographSteps4,
            &hodograph_steps_5::HodographSteps5,
        ],
    };
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("surfaces.h"), header(&artifacts()).unwrap()).unwrap();
    let (mut text, mut expected) = (beginning(), Expected::new());
    gutter.function(&mut text, &mut expected);
    steps.function(&mut text, &mut expected);
    text.push_str(
        "int main(void)\n{\n    run_frames_gutter();\n    run_sweep_hodograph_steps();\n    return 0;\n}\n",
    );
    fs::write(folder.path().join("main.c"), text).unwrap();
    for language in LANGUAGES {
        if has_compiler(folder.path(), language) {
            compare(&run(folder.path(), language), &expected);
        }
    }
    for line in ["pole", "singular", "parameter", "overflow"] {
        assert!(expected.iter().any(|(_, found)| found == line), "nothing is undefined for being {line}");
    }
    let jump = steps.surface.jump::<f64>(hodograph::Variant::Plain);
    assert!(jump.is_infinite() && gutter.surface.jump::<f64>(hodograph::Variant::Plain).is_finite());
}
