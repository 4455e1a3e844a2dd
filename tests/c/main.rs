//! The C header has the functions of the runtime, with the bits of its plain variant, where the system has a C compiler.

/// Expands sweeps and keeps their text.
macro_rules! sweeps {
    ($($tokens:tt)*) => {
        hodograph::sweep! { $($tokens)* }
        const TEXT: &str = stringify!($($tokens)*);
    };
}

mod constants;
mod evaluation;
mod functions;
mod pieces;
mod program;

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;

use hodograph::ParameterError;
use hodograph_codegen::bound::{Precision, Rounding};
use hodograph_codegen::compile::{CompileError, compile, compile_all};
use hodograph_codegen::emit::{Artifact, header};
use hodograph_codegen::language::parse_text;
use hodograph_codegen::meaning::{Model, models};
use hodograph_codegen::program::Variant;
use hodograph_tests::catalogue::{Formulas, files};
use hodograph_tests::random::SplitMix64;
use hodograph_tests::surfaces::{Evaluator, Subject, all};

use constants::{constants, member};
use evaluation::{Expanded, evaluation, places};
use functions::{FUNCTIONS, bits, runtime};
use program::{Expected, LANGUAGES, beginning, cc, compare, has_compiler, run};

/// All surfaces that have an evaluator, one member of each family; with those whose evaluators the tests can call.
fn surfaces() -> Vec<(Artifact, Option<Subject>)> {
    let models: Vec<_> =
        files().into_iter().filter(Formulas::is_expanded).flat_map(|formulas| formulas.models).collect();
    let mut subjects: BTreeMap<String, Subject> = BTreeMap::new();
    for subject in all() {
        subjects.entry(subject.surface.name().to_owned()).or_insert(subject);
    }
    let with_subject = |(model, artifact): (&Model, Result<Artifact, CompileError>)| {
        let artifact = artifact.unwrap_or_else(|error| panic!("{}: {error}", model.name));
        (artifact, subjects.remove(&model.name))
    };
    let surfaces = compile_all(&models).into_iter().map(with_subject).collect();
    assert!(subjects.is_empty(), "these have no formula: {:?}", subjects.keys());
    surfaces
}

#[test]
fn results_are_those_of_the_runtime() {
    let variant = match hodograph::Variant::native() {
        hodograph::Variant::Plain => Variant::Plain,
        hodograph::Variant::Fused => Variant::Fused,
    };
    let rounding = Rounding { precision: Precision::Double, variant };
    for Subject { surface, .. } in all() {
        for place in places(surface.as_ref(), Precision::Double) {
            for function in &FUNCTIONS {
                let outcome = function.outcome(surface.as_ref(), rounding, place);
                let found = runtime::<f64>(surface.as_ref(), function.name, place);
                assert_eq!(
                    bits(&found),
                    bits(&outcome),
                    "{} of {} at {place:?}",
                    function.name,
                    surface.name()
                );
            }
        }
    }
}

#[test]
fn c_has_the_bits_of_the_plain_variant() {
    let folder = tempfile::tempdir().unwrap();
    let surfaces = surfaces();
    let artifacts: Vec<Artifact> = surfaces.iter().map(|(artifact, _)| artifact.clone()).collect();
    fs::write(folder.path().join("surfaces.h"), header(&artifacts).unwrap()).unwrap();
    let (mut text, mut expected) = (beginning(), Expected::new());
    let called = surfaces.iter().filter_map(|(artifact, subject)| Some((artifact, subject.as_ref()?)));
    for (place, (artifact, subject)) in called.clone().enumerate() {
        _ = writeln!(text, "static void run{place}(void)\n{{");
        constants(&mut text, &mut expected, artifact, subject);
        let of_family = !artifact.symbols.is_empty();
        if of_family {
            member(&mut text, &mut expected, artifact, subject);
        }
        let prefix = if of_family { "&surface, " } else { "" };
        let called = Expanded(&artifact.name, prefix, subject.surface.as_ref());
        evaluation(&mut text, &mut expected, &called);
        text.push_str("}\n\n");
    }
    let calls: Vec<String> =
        (0..called.clone().count()).map(|place| format!("    run{place}();\n")).collect();
    _ = write!(text, "int main(void)\n{{\n{}    return 0;\n}}\n", calls.concat());
    fs::write(folder.path().join("main.c"), text).unwrap();
    // The other tests run what is compiled as C++.
    if has_compiler(folder.path(), LANGUAGES[0]) {
        compare(&run(folder.path(), LANGUAGES[0]), &expected);
    }
    if has_compiler(folder.path(), LANGUAGES[1]) {
        let output = cc(folder.path(), LANGUAGES[1], &["-fsyntax-only", "main.c"]).unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    }
    assert!(expected.len() > 5000 * called.count());
}

sweeps! {
    // Coefficients that single precision takes for zero.
    sweep tiny { surface R = (u * 1e-300, v * 1e-300, u*v * 1e-300); domain u in 0..1, v in 0..1; }
    // Coefficients that are beyond the range of single precision.
    sweep huge { surface R = (u * 1e100, v * 1e100 - u * 1e60, u*v - 1e100); domain u in 0..1, v in 0..1; }
    // Both of them, and numbers that have neither many digits nor few.
    sweep wide { surface R = (u * 1e39, (1e-46 - v)/(1 + u^2), u*v/3 + 1e38); domain u in -1..1, v in 0..1; }
    // Names that mean something to C or C++.
    sweep double_ {
        let new(v) = v^2 + 1;
        let sqrtf(u) = u^3 + u + 1;
        let out(u) = u^2 + 2;
        surface R = (u * new, sqrtf * new, out * v);
        domain u in 0..1, v in 0..1;
    }
    // A pole at v = 2, and no normal at u = 0, but for poles.
    sweep cone { surface R = (u/(2 - v), u*v/(2 - v), u^2); domain u in 0..1, v in 0..1; }
    // A weight that overflows before the other coordinates do.
    sweep far { surface R = (u^2, v^2, 1)/(1 + u^2 + v^2); domain u in 0..1, v in 0..1; }
    // A family along a cubic with the hodograph (1 + c v) w², whose parametric speed must stay positive.
    sweep along_cubic {
        symbol c, class;
        path s(v) = ph([1, 1 + I], factor = 1 + c*v);
        surface R = s + u*class*s.normal + u*k;
        domain u in 0..1, v in 0..2;
    }
    // A name as those of the header begin.
    sweep hodograph_first { surface R = (u, v, u*v); domain u in 0..1, v in 0..1; }
}

#[test]
fn constants_and_names_at_the_edges() {
    let folder = tempfile::tempdir().unwrap();
    let (file, _) = parse_text("edges.sweep", TEXT).unwrap();
    let artifacts: Vec<Artifact> = models(&file)
        .0
        .iter()
        .map(|model| compile(model).unwrap_or_else(|error| panic!("{error}")))
        .collect();
    let surfaces: [(&str, &dyn Evaluator); 7] = [
        ("tiny", &tiny::Tiny),
        ("huge", &huge::Huge),
        ("wide", &wide::Wide),
        ("cone", &cone::Cone),
        ("far", &far::Far),
        ("double_", &double_::Double),
        ("sweep_hodograph_first", &hodograph_first::HodographFirst),
    ];
    assert_eq!(artifacts.len(), surfaces.len() + 1);
    fs::write(folder.path().join("surfaces.h"), header(&artifacts).unwrap()).unwrap();
    let (mut text, mut expected) = (beginning(), Expected::new());
    text.push_str("int main(void)\n{\n");
    for (name, surface) in surfaces {
        evaluation(&mut text, &mut expected, &Expanded(name, "", surface));
    }
    text.push_str("    return 0;\n}\n");
    fs::write(folder.path().join("main.c"), text).unwrap();
    for language in LANGUAGES {
        if has_compiler(folder.path(), language) {
            compare(&run(folder.path(), language), &expected);
        }
    }
    // Every kind of result is there.
    for line in ["pole", "singular", "parameter", "overflow"] {
        assert!(expected.iter().any(|(_, found)| found == line), "nothing is undefined for being {line}");
    }
    // In single precision some points overflow, and others are zero.
    let of = |label: &str| expected.iter().find(|(found, _)| found == label).map(|(_, line)| line.as_str());
    assert_eq!(of("point of tiny at (1.0, 1.0, 0.0), float"), Some("00000000 00000000 00000000"));
    assert_eq!(of("point of huge at (1.0, 1.0, 0.0), float"), Some("overflow"));
    let (_, far) = expected.iter().find(|(label, _)| label.starts_with("point of far at (1.2e154")).unwrap();
    assert_eq!(far, "overflow");
}

#[test]
fn members_are_rejected_for_the_same_reasons() {
    use hodograph::catalogue::oriented_translation_family::{OrientedTranslationFamily, Parameters};
    let folder = tempfile::tempdir().unwrap();
    let words = |result: Result<(), ParameterError>| match result {
        Ok(()) => "there is a result",
        Err(ParameterError::NotFinite { .. }) => "a parameter is infinite or NaN",
        Err(ParameterError::Overflow) => "the result is beyond the range of numbers",
        Err(ParameterError::Pole { .. }) => {
            "the weight of the surface vanishes there, or in a family comes too near to zero"
        }
        Err(ParameterError::Speed) => "the parametric speed of a curve is not positive",
        Err(other) => panic!("C does not know {other:?}"),
    };
    let (mut calls, mut expected) = (String::new(), Expected::new());
    for (c, class) in [(0.5, 1.0), (-0.5, 1.0), (-0.499, 1.0), (-1.0, 2.0), (1e308, 1e308), (0.0, f64::NAN)] {
        let made = along_cubic::AlongCubic::new(along_cubic::Parameters { c, class });
        let class = if class.is_nan() { "NAN".to_owned() } else { format!("{class:?}") };
        _ = writeln!(calls, "    {{");
        _ = writeln!(calls, "        const along_cubic_parameters parameters = {{{c:?}, {class}}};");
        _ = writeln!(calls, "        along_cubic_surface surface;");
        _ = writeln!(
            calls,
            "        puts(hodograph_reason(along_cubic_new(&parameters, &surface)));\n    }}"
        );
        expected.push((format!("along_cubic {c} {class}"), words(made.map(|_| ())).to_owned()));
    }
    // A cusp at 1/2, one where no halving ends, an overflow, a curve that is a point, and curves of all kinds.
    let mut preimages = vec![
        [[1.0, 0.0], [0.0, 0.0], [-1.0, 0.0]],
        [[-1.0 / 3.0, 0.0], [1.0 / 6.0, 0.0], [2.0 / 3.0, 0.0]],
        [[1e200, 0.0], [1.0, 0.0], [1.0, 1.0]],
        [[0.0; 2]; 3],
    ];
    let mut random = SplitMix64::new(22);
    let mut number = || (random.next_f64() * 5.0).floor() - 2.0;
    preimages.extend((0..200).map(|_| [[(); 2]; 3].map(|row| row.map(|()| number()))));
    for s in preimages {
        let made = OrientedTranslationFamily::new(Parameters { s });
        let rows = s.map(|[re, im]| format!("{{{re:?}, {im:?}}}")).join(", ");
        _ = writeln!(calls, "    {{");
        _ = writeln!(
            calls,
            "        const oriented_translation_family_parameters parameters = {{{{{rows}}}}};"
        );
        _ = writeln!(calls, "        oriented_translation_family_surface surface;");
        _ = writeln!(
            calls,
            "        puts(hodograph_reason(oriented_translation_family_new(&parameters, &surface)));\n    }}"
        );
        expected.push((format!("oriented_translation_family {s:?}"), words(made.map(|_| ())).to_owned()));
    }
    for (_, line) in &expected {
        let count = expected.iter().filter(|(_, other)| other == line).count();
        assert!(count < expected.len() - 20, "nearly all members are `{line}`");
    }
    let (file, _) = parse_text("edges.sweep", TEXT).unwrap();
    let edges = models(&file).0;
    let all = files().into_iter().flat_map(|formulas| formulas.models).chain(edges);
    let wanted = ["along_cubic", "oriented_translation_family"];
    let wanted = all.filter(|model| wanted.contains(&model.name.as_str()));
    let artifacts: Vec<Artifact> = wanted.map(|model| compile(&model).unwrap()).collect();
    fs::write(folder.path().join("surfaces.h"), header(&artifacts).unwrap()).unwrap();
    let text = format!(
        "#include \"surfaces.h\"\n#include <stdio.h>\nint main(void)\n{{\n{calls}    return 0;\n}}\n"
    );
    fs::write(folder.path().join("main.c"), text).unwrap();
    for language in LANGUAGES {
        if has_compiler(folder.path(), language) {
            compare(&run(folder.path(), language), &expected);
        }
    }
}

#[test]
fn options_that_change_results_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(
        folder.path().join("empty.c"),
        format!("{}\nint main(void) {{ return 0; }}\n", header(&[]).unwrap()),
    )
    .unwrap();
    let check = ["-fsyntax-only", "-Wno-unused-function", "empty.c"];
    let Some(plain) = cc(folder.path(), LANGUAGES[0], &check) else { return };
    assert!(plain.status.success(), "{}", String::from_utf8_lossy(&plain.stderr));
    let fast = [&["-ffast-math"], check.as_slice()].concat();
    let fast = cc(folder.path(), LANGUAGES[0], &fast).unwrap();
    let message = String::from_utf8_lossy(&fast.stderr);
    assert!(!fast.status.success() && message.contains("-ffast-math"), "{message}");
}
