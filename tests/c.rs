//! The C header has the bits of the plain variant, where the system has a C compiler.

use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use hodograph_codegen::bound::{Precision, Rounding};
use hodograph_codegen::compile::compile;
use hodograph_codegen::emit::{Artifact, Setting, TASKS, header};
use hodograph_codegen::program::Variant;
use hodograph_tests::catalogue::{Formulas, files};
use hodograph_tests::points::Points;
use hodograph_tests::surfaces::{Subject, all};

/// Points of each surface, in each precision.
const POINTS: usize = 200;

/// The first so many parameters of these are those of a grid: more than are computed at a time.
const COLUMNS: usize = 150;
const ROWS: usize = 4;

/// Options that every file is compiled with.
const OPTIONS: [&str; 7] =
    ["-std=c11", "-ffp-contract=off", "-O2", "-Wall", "-Wextra", "-Werror", "-pedantic"];

/// How C names a precision, and its functions.
#[derive(Clone, Copy)]
struct Type {
    rounding: Rounding,
    name: &'static str,
    suffix: &'static str,
    bits: &'static str,
}

const TYPES: [Type; 2] = [
    Type {
        rounding: Rounding { precision: Precision::Double, variant: Variant::Plain },
        name: "double",
        suffix: "",
        bits: "uint64_t",
    },
    Type {
        rounding: Rounding { precision: Precision::Single, variant: Variant::Plain },
        name: "float",
        suffix: "f",
        bits: "uint32_t",
    },
];

impl Type {
    fn digits(self, number: f64) -> String {
        match self.rounding.precision {
            Precision::Double => format!("{:016x}", number.to_bits()),
            Precision::Single => format!("{:08x}", (number as f32).to_bits()),
        }
    }

    /// A line with the bits of these numbers, if they are finite.
    fn line(self, numbers: &[f64]) -> String {
        if numbers.iter().all(|number| number.is_finite()) {
            numbers.iter().map(|&number| self.digits(number)).collect::<Vec<String>>().join(" ")
        } else {
            "undefined".to_owned()
        }
    }
}

/// What the compiler does with a file; `None` if there is no compiler.
fn cc(folder: &Path, arguments: &[&str]) -> Option<Output> {
    match Command::new("cc").args(OPTIONS).args(arguments).current_dir(folder).output() {
        Ok(output) => Some(output),
        Err(error) => {
            eprintln!("not tested, since there is no C compiler: cc: {error}");
            None
        }
    }
}

/// Places where a surface is evaluated: on its domain, beside it, and no places at all.
fn places(subject: &Subject, precision: Precision) -> Vec<(f64, f64)> {
    let mut points = Points::new(subject.surface.as_ref(), precision, 11);
    let mut places = points.border();
    places.extend([(0.0, -0.0), (-1.5, 2.0), (1e18, 0.5), (f64::NAN, 0.0), (0.5, f64::INFINITY)]);
    while places.len() < POINTS {
        places.push(points.anywhere());
        places.push(points.near_border());
    }
    places.truncate(POINTS);
    places
}

/// The C code of a program that prints what a surface is at its places, with the lines that are expected.
fn evaluation(
    text: &mut String,
    expected: &mut Vec<(String, String)>,
    place: usize,
    artifact: &Artifact,
    subject: &Subject,
) {
    let name = &artifact.name;
    let member = if artifact.symbols.is_empty() { "" } else { "&surface, " };
    _ = writeln!(text, "static void run{place}(void)\n{{");
    if !member.is_empty() {
        let mut arguments = String::new();
        for setting in &artifact.symbols {
            match setting {
                Setting::Number(symbol) => _ = write!(arguments, ", {:?}", subject.symbols[symbol.as_str()]),
                Setting::Curve { name, rows, .. } => {
                    let row = |row: &Vec<String>| {
                        let numbers =
                            row.iter().map(|symbol| format!("{:?}", subject.symbols[symbol.as_str()]));
                        format!("{{{}}}", numbers.collect::<Vec<String>>().join(", "))
                    };
                    let rows_text: Vec<String> = rows.iter().map(row).collect();
                    let (count, width) = (rows.len(), rows.first().map_or(0, Vec::len));
                    let rows_text = rows_text.join(", ");
                    _ = writeln!(text, "    static const double {name}[{count}][{width}] = {{{rows_text}}};");
                    _ = write!(arguments, ", {name}");
                }
            }
        }
        _ = writeln!(text, "    {name} surface;\n    {name}_set(&surface{arguments});");
    }
    for kind in TYPES {
        let Type { rounding, name: real, suffix, bits } = kind;
        let places = places(subject, rounding.precision);
        let list: Vec<String> =
            places.iter().map(|&(u, v)| format!("{{0x{}, 0x{}}}", kind.digits(u), kind.digits(v))).collect();
        _ = writeln!(
            text,
            "    {{\n        static const {bits} places[{POINTS}][2] = {{{}}};",
            list.join(", ")
        );
        _ = writeln!(text, "        static {real} us[{POINTS}], vs[{POINTS}], grid[{ROWS} * {COLUMNS}][3];");
        _ = writeln!(text, "        for (size_t i = 0; i < {POINTS}; i++) {{\n            {real} out[64];");
        _ = writeln!(text, "            memcpy(&us[i], &places[i][0], sizeof us[i]);");
        _ = writeln!(text, "            memcpy(&vs[i], &places[i][1], sizeof vs[i]);");
        for task in TASKS {
            let (task, size) = (task.name.to_lowercase(), task.results(&artifact.program).len());
            _ = writeln!(
                text,
                "            put{suffix}({name}_{task}{suffix}({member}us[i], vs[i], out), out, {size});"
            );
        }
        _ = writeln!(text, "        }}");
        _ = writeln!(
            text,
            "        puts({name}_grid{suffix}({member}us, {COLUMNS}, vs, {ROWS}, grid) ? \"all\" : \"some\");"
        );
        _ = writeln!(text, "        for (size_t i = 0; i < {ROWS} * {COLUMNS}; i++)");
        _ = writeln!(
            text,
            "            put{suffix}(hodograph_all_finite{suffix}(grid[i], 3), grid[i], 3);\n    }}"
        );
        for &at in &places {
            for task in TASKS {
                let numbers = subject.surface.numbers(task.name, rounding, at);
                let label = format!("{} of {name} at {at:?}, {real}", task.name);
                expected.push((label, kind.line(&numbers)));
            }
        }
        let mut lines = Vec::new();
        for &(_, v) in &places[..ROWS] {
            for &(u, _) in &places[..COLUMNS] {
                let numbers = subject.surface.numbers("Point", rounding, (u, v));
                lines.push((format!("grid of {name} at ({u:?}, {v:?}), {real}"), kind.line(&numbers)));
            }
        }
        let all = lines.iter().all(|(_, line)| line != "undefined");
        expected.push((format!("grid of {name}, {real}"), if all { "all" } else { "some" }.to_owned()));
        expected.extend(lines);
    }
    text.push_str("}\n\n");
}

/// What prints numbers.
const PRINTING: &str = r#"
static void put(bool finite, const double *numbers, size_t count)
{
    for (size_t i = 0; finite && i < count; i++) {
        uint64_t bits;
        memcpy(&bits, &numbers[i], sizeof bits);
        printf("%s%016" PRIx64, i > 0 ? " " : "", bits);
    }
    puts(finite ? "" : "undefined");
}

static void putf(bool finite, const float *numbers, size_t count)
{
    for (size_t i = 0; finite && i < count; i++) {
        uint32_t bits;
        memcpy(&bits, &numbers[i], sizeof bits);
        printf("%s%08" PRIx32, i > 0 ? " " : "", bits);
    }
    puts(finite ? "" : "undefined");
}

"#;

/// All surfaces, one member of each family, with their artifacts.
fn surfaces() -> Vec<(Artifact, Subject)> {
    let models: Vec<_> =
        files().into_iter().filter(Formulas::is_expanded).flat_map(|formulas| formulas.models).collect();
    let mut subjects = all();
    subjects.reverse();
    subjects.dedup_by_key(|subject| subject.surface.name().to_owned());
    let found = |subject: Subject| {
        let name = subject.surface.name().to_owned();
        let model = models.iter().find(|model| model.name == name);
        let artifact = compile(model.unwrap_or_else(|| panic!("{name} has no formula")));
        (artifact.unwrap_or_else(|error| panic!("{name}: {error}")), subject)
    };
    let surfaces: Vec<(Artifact, Subject)> = subjects.into_iter().map(found).collect();
    assert_eq!(surfaces.len(), models.len(), "a sweep is missing");
    surfaces
}

#[test]
fn c_has_the_bits_of_the_plain_variant() {
    let folder = tempfile::tempdir().unwrap();
    if cc(folder.path(), &["--version"]).is_none() {
        return;
    }
    let surfaces = surfaces();
    let artifacts: Vec<Artifact> = surfaces.iter().map(|(artifact, _)| artifact.clone()).collect();
    fs::write(folder.path().join("surfaces.h"), header(&artifacts)).unwrap();
    let mut text = String::from("#include <inttypes.h>\n#include <stdio.h>\n#include \"surfaces.h\"\n");
    text.push_str(PRINTING);
    let mut expected = Vec::new();
    for (place, (artifact, subject)) in surfaces.iter().enumerate() {
        evaluation(&mut text, &mut expected, place, artifact, subject);
    }
    let calls: Vec<String> = (0..surfaces.len()).map(|place| format!("    run{place}();\n")).collect();
    _ = write!(text, "int main(void)\n{{\n{}    return 0;\n}}\n", calls.concat());
    fs::write(folder.path().join("main.c"), text).unwrap();
    let output = cc(folder.path(), &["main.c", "-o", "surfaces", "-lm"]).unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let output = Command::new(folder.path().join("surfaces")).output().unwrap();
    assert!(output.status.success(), "{output:?}");
    let printed = String::from_utf8(output.stdout).unwrap();
    assert_eq!(printed.lines().count(), expected.len());
    for (found, (label, line)) in printed.lines().zip(&expected) {
        assert_eq!(found, line, "{label}");
    }
    // Both kinds of results are there.
    assert!(expected.iter().any(|(_, line)| line == "undefined") && expected.len() > 1000 * surfaces.len());
}

#[test]
fn options_that_change_results_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("empty.c"), format!("{}\nint main(void) {{ return 0; }}\n", header(&[])))
        .unwrap();
    let Some(plain) = cc(folder.path(), &["-fsyntax-only", "-Wno-unused-function", "empty.c"]) else {
        return;
    };
    assert!(plain.status.success(), "{}", String::from_utf8_lossy(&plain.stderr));
    let fast =
        cc(folder.path(), &["-ffast-math", "-fsyntax-only", "-Wno-unused-function", "empty.c"]).unwrap();
    let message = String::from_utf8_lossy(&fast.stderr);
    assert!(!fast.status.success() && message.contains("-ffast-math"), "{message}");
}
