//! The C header has the functions of the runtime, with the bits of its plain variant, where the system has a C compiler.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use hodograph::{Bound, ParameterError, Undefined, offset_net};
use hodograph_codegen::bound::{Precision, Rounding};
use hodograph_codegen::compile::compile;
use hodograph_codegen::emit::{Artifact, Setting, header};
use hodograph_codegen::language::parse_text;
use hodograph_codegen::meaning::{Model, models};
use hodograph_codegen::program::Variant;
use hodograph_codegen::proofs::BOUNDED;
use hodograph_tests::catalogue::{Formulas, files};
use hodograph_tests::points::{Points, rounded};
use hodograph_tests::random::SplitMix64;
use hodograph_tests::search::bound_of;
use hodograph_tests::surfaces::{Evaluator, Subject, all, moved};

/// Points of each surface, in each precision.
const POINTS: usize = 200;

/// The first so many parameters of these are those of a grid: more than are computed at a time.
const COLUMNS: usize = 150;
const ROWS: usize = 4;

/// The distances of offsets, one after the other.
const DISTANCES: [f64; 5] = [0.25, -1.5, 0.0, f64::INFINITY, 1e30];

/// Options that every file is compiled with.
const OPTIONS: [&str; 6] = ["-ffp-contract=off", "-O2", "-Wall", "-Wextra", "-Werror", "-pedantic"];

/// The languages that the header is written in.
const LANGUAGES: [[&str; 3]; 2] = [["-x", "c", "-std=c11"], ["-x", "c++", "-std=c++11"]];

/// How C names a precision, and its functions.
#[derive(Clone, Copy)]
struct Type {
    precision: Precision,
    name: &'static str,
    suffix: &'static str,
    bits: &'static str,
}

const TYPES: [Type; 2] = [
    Type { precision: Precision::Double, name: "double", suffix: "", bits: "uint64_t" },
    Type { precision: Precision::Single, name: "float", suffix: "f", bits: "uint32_t" },
];

impl Type {
    fn digits(self, number: f64) -> String {
        match self.precision {
            Precision::Double => format!("{:016x}", number.to_bits()),
            Precision::Single => format!("{:08x}", (number as f32).to_bits()),
        }
    }

    fn line(self, numbers: &[f64]) -> String {
        numbers.iter().map(|&number| self.digits(number)).collect::<Vec<String>>().join(" ")
    }

    /// What is printed of a result: its bits, or why there is none.
    fn outcome(self, outcome: &Outcome) -> String {
        match outcome {
            Ok(numbers) => self.line(numbers),
            Err(Undefined::Pole) => "pole".to_owned(),
            Err(Undefined::Singular) => "singular".to_owned(),
            Err(Undefined::Parameter) => "parameter".to_owned(),
            Err(Undefined::Overflow) => "overflow".to_owned(),
            Err(other) => panic!("C does not know {other:?}"),
        }
    }
}

/// The numbers of a result, or why there is none.
type Outcome = Result<Vec<f64>, Undefined>;

/// A place with a distance: u, v and r.
type Place = (f64, f64, f64);

/// A function that evaluates a surface at a place; C and Rust have one name for it.
struct Function {
    name: &'static str,
    /// The struct of its result, if it is one.
    structure: Option<&'static str>,
    /// The task that its numbers are of, the first of them there and their count.
    task: &'static str,
    first: usize,
    size: usize,
    /// What begins the names of its batches.
    batch: Option<&'static str>,
}

impl Function {
    const fn new(
        (name, structure): (&'static str, Option<&'static str>),
        (task, first, size): (&'static str, usize, usize),
        batch: Option<&'static str>,
    ) -> Function {
        Function { name, structure, task, first, size, batch }
    }

    /// The declaration of a variable for the result, and how it is passed.
    fn result(&self, kind: Type, variable: &str) -> (String, String) {
        match (self.structure, self.size) {
            (Some(structure), _) => {
                (format!("{structure}{} {variable}", kind.suffix), format!("&{variable}"))
            }
            (None, 1) => (format!("{} {variable}", kind.name), format!("&{variable}")),
            (None, size) => (format!("{} {variable}[{size}]", kind.name), variable.to_owned()),
        }
    }

    /// The definition of a pointer to the function, which the compiler does not see through: it has to inline the function once.
    fn pointer(&self, Type { name: real, suffix, .. }: Type, (name, member): (&str, &str)) -> String {
        let surface = if member.is_empty() { String::new() } else { format!("const {name}_surface *, ") };
        let distance = if self.is_offset() { format!("{real}, ") } else { String::new() };
        let result = self.structure.map_or(real.to_owned(), |structure| format!("{structure}{suffix}"));
        let function = format!("{name}_{}{suffix}", self.name);
        format!(
            "hodograph_status (*volatile evaluate)({surface}{distance}{real}, {real}, {result} *) = {function}"
        )
    }

    /// Whether its first parameter is a distance.
    fn is_offset(&self) -> bool {
        self.name.starts_with("offset")
    }

    /// Whether there is no result where the surface has no normal.
    fn needs_normal(&self) -> bool {
        self.is_offset() || ["Normal", "Local"].contains(&self.task) && !self.name.starts_with("speed")
    }

    /// The result, from the numbers of tasks.
    fn outcome(&self, surface: &dyn Evaluator, rounding: Rounding, (u, v, r): Place) -> Outcome {
        let numbers = |task: &str| surface.numbers(task, rounding, (u, v));
        let is_finite = |numbers: &[f64]| numbers.iter().all(|number| number.is_finite());
        let result = match (self.name, rounding) {
            (name, _) if name.starts_with("offset") && !r.is_finite() => return Err(Undefined::Parameter),
            ("offset_point", rounding) => moved(&numbers("Point"), &numbers("Normal"), r, rounding),
            ("offset_first_order", rounding) => {
                let local = numbers("Local");
                moved(&local[..9], &[&local[18..21], &local[33..39]].concat(), r, rounding)
            }
            _ => numbers(self.task)[self.first..self.first + self.size].to_vec(),
        };
        if is_finite(&result) {
            return Ok(result);
        }
        let homogeneous = numbers("Homogeneous");
        let has_point = is_finite(&homogeneous) && is_finite(&numbers("Point"));
        Err(if !(u.is_finite() && v.is_finite()) {
            Undefined::Parameter
        } else if homogeneous[0] == 0.0 && self.task != "Homogeneous" {
            Undefined::Pole
        } else if self.needs_normal() && has_point && !is_finite(&numbers("Normal")) {
            Undefined::Singular
        } else {
            Undefined::Overflow
        })
    }
}

/// What the runtime's method gives.
fn runtime(surface: &dyn Evaluator, method: &str, (u, v, r): Place) -> Outcome {
    match method {
        "homogeneous" => surface.homogeneous(u, v).map(Vec::from),
        "point" => surface.point(u, v).map(Vec::from),
        "separated_point" => surface.separated_point(u, v).map(Vec::from),
        "partial_u" => surface.partial_u(u, v).map(Vec::from),
        "partial_v" => surface.partial_v(u, v).map(Vec::from),
        "first_order" => surface.first_order(u, v).map(|result| result.numbers().into()),
        "second_order" => surface.second_order(u, v).map(|result| result.numbers().into()),
        "unit_normal" => surface.unit_normal(u, v).map(Vec::from),
        "local_geometry" => surface.local_geometry(u, v).map(|result| result.numbers().into()),
        "speed_u" => surface.speed_u(u, v).map(|speed| vec![speed]),
        "speed_v" => surface.speed_v(u, v).map(|speed| vec![speed]),
        "offset_point" => surface.offset_point(r, u, v).map(Vec::from),
        "offset_first_order" => surface.offset_first_order(r, u, v).map(|result| result.numbers().into()),
        _ => panic!("there is no method {method}"),
    }
}

const FUNCTIONS: [Function; 13] = {
    const FIRST: Option<&str> = Some("hodograph_first_order");
    const SECOND: Option<&str> = Some("hodograph_second_order");
    const LOCAL: Option<&str> = Some("hodograph_local_geometry");
    [
        Function::new(("homogeneous", None), ("Homogeneous", 0, 4), Some("homogeneous_")),
        Function::new(("point", None), ("Point", 0, 3), Some("")),
        Function::new(("separated_point", None), ("Separated", 0, 3), Some("separated_")),
        Function::new(("partial_u", None), ("First", 3, 3), None),
        Function::new(("partial_v", None), ("First", 6, 3), None),
        Function::new(("first_order", FIRST), ("First", 0, 9), Some("first_")),
        Function::new(("second_order", SECOND), ("Second", 0, 18), Some("second_")),
        Function::new(("unit_normal", None), ("Normal", 0, 3), Some("normal_")),
        Function::new(("local_geometry", LOCAL), ("Local", 0, 39), Some("local_")),
        Function::new(("speed_u", None), ("Local", 31, 1), None),
        Function::new(("speed_v", None), ("Local", 32, 1), None),
        Function::new(("offset_point", None), ("Normal", 0, 3), None),
        Function::new(("offset_first_order", FIRST), ("Local", 0, 9), None),
    ]
};

/// What the compiler does with a file in one of the languages; `None` if there is no compiler.
fn cc(folder: &Path, language: [&str; 3], arguments: &[&str]) -> Option<Output> {
    let mut command = Command::new("cc");
    match command.args(language).args(OPTIONS).args(arguments).current_dir(folder).output() {
        Ok(output) => Some(output),
        Err(error) => {
            eprintln!("not tested, since there is no C compiler: cc: {error}");
            None
        }
    }
}

/// Whether there is a compiler for a language.
fn has_compiler(folder: &Path, language: [&str; 3]) -> bool {
    fs::write(folder.join("nothing.c"), "int main(void) { return 0; }\n").unwrap();
    cc(folder, language, &["-fsyntax-only", "nothing.c"]).is_some_and(|output| output.status.success())
}

/// Compiles `main.c` and gives what the program prints.
fn run(folder: &Path, language: [&str; 3]) -> String {
    let output = cc(folder, language, &["main.c", "-o", "program", "-lm"]).unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let output = Command::new(folder.join("program")).output().unwrap();
    assert!(output.status.success(), "{output:?}");
    String::from_utf8(output.stdout).unwrap()
}

/// Places where a surface is evaluated, with distances: on its domain, beside it, and no places at all.
fn places(surface: &dyn Evaluator, precision: Precision) -> Vec<Place> {
    let mut points = Points::new(surface, precision, 11);
    let mut places = points.border();
    places.extend([(0.0, -0.0), (-1.5, 2.0), (1e18, 0.5), (f64::NAN, 0.0), (0.5, f64::INFINITY)]);
    while places.len() < POINTS {
        places.push(points.anywhere());
        places.push(points.near_border());
    }
    places.truncate(POINTS);
    let distances = DISTANCES.iter().cycle();
    places.into_iter().zip(distances).map(|((u, v), &r)| (u, v, rounded(r, precision))).collect()
}

/// A line that is expected, with what it is about.
type Expected = Vec<(String, String)>;

/// The C code that evaluates everything at the places, and the lines that it prints.
fn evaluation(
    text: &mut String,
    expected: &mut Expected,
    (name, member): (&str, &str),
    surface: &dyn Evaluator,
) {
    for kind in TYPES {
        let Type { name: real, suffix, bits, precision } = kind;
        let places = places(surface, precision);
        let list: Vec<String> = places
            .iter()
            .map(|&(u, v, r)| format!("{{0x{}, 0x{}, 0x{}}}", kind.digits(u), kind.digits(v), kind.digits(r)))
            .collect();
        _ = writeln!(
            text,
            "    {{\n        static const {bits} places[{POINTS}][3] = {{{}}};",
            list.join(", ")
        );
        _ = writeln!(text, "        static {real} us[{POINTS}], vs[{POINTS}], rs[{POINTS}];");
        _ = writeln!(text, "        for (size_t i = 0; i < {POINTS}; i++) {{");
        for (k, letter) in ["us", "vs", "rs"].iter().enumerate() {
            _ = writeln!(text, "            memcpy(&{letter}[i], &places[i][{k}], sizeof {letter}[i]);");
        }
        _ = writeln!(text, "        }}");
        for function in &FUNCTIONS {
            let Function { name: method, size, .. } = function;
            let (declaration, result) = function.result(kind, "result");
            let distance = if function.is_offset() { "rs[i], " } else { "" };
            let pointer = function.pointer(kind, (name, member));
            _ = writeln!(
                text,
                "        {{
        {pointer};
        for (size_t i = 0; i < {POINTS}; i++) {{
            {declaration};
            const hodograph_status status = evaluate({member}{distance}us[i], vs[i], {result});
            put{suffix}(status, {result}, {size});
        }}
        }}"
            );
            let rounding = Rounding { precision, variant: Variant::Plain };
            let outcome = |&place: &Place| function.outcome(surface, rounding, place);
            for place in &places {
                let label = format!("{method} of {name} at {place:?}, {real}");
                expected.push((label, kind.outcome(&outcome(place))));
            }
            let Some(prefix) = function.batch else { continue };
            batches(text, (name, member, prefix), kind, function);
            let grid = places[..ROWS].iter().flat_map(|&(_, v, _)| {
                places[..COLUMNS].iter().map(move |&(u, ..)| function.outcome(surface, rounding, (u, v, 0.0)))
            });
            let of_grid = missing(grid);
            let of_points = missing(places.iter().map(outcome));
            for (what, line) in [("grid", &of_grid), ("points", &of_points), ("rows", &of_grid)] {
                expected.push((format!("{what} of {method} of {name}, {real}"), line.clone()));
            }
        }
        text.push_str("    }\n");
    }
}

/// What is printed of a batch that has the results of single evaluations.
fn missing(outcomes: impl Iterator<Item = Outcome>) -> String {
    let places: Vec<usize> =
        outcomes.enumerate().filter(|(_, outcome)| outcome.is_err()).map(|(i, _)| i).collect();
    format!("equal, {} missing from {}", places.len(), places.first().copied().unwrap_or(0))
}

/// The C code that evaluates batches, and compares them with single evaluations.
fn batches(text: &mut String, (name, member, prefix): (&str, &str, &str), kind: Type, function: &Function) {
    let (suffix, size) = (kind.suffix, function.size);
    let (declaration, result) = function.result(kind, "result");
    let (out, _) = function.result(kind, &format!("out[{}]", ROWS * COLUMNS));
    let out = match function.structure {
        Some(_) => out,
        None => format!("{} out[{}][{size}]", kind.name, ROWS * COLUMNS),
    };
    let pointer = function.pointer(kind, (name, member));
    let none = if function.needs_normal() { "0" } else { "INFINITY" };
    _ = writeln!(
        text,
        "        {{
            {pointer};
            static {out};
            static {name}_{task}_of_u{suffix} strip[{COLUMNS}];
            hodograph_missing missing, expected = {{0, 0}};
            bool equal = true;
            missing = {name}_{prefix}grid{suffix}({member}us, {COLUMNS}, vs, {ROWS}, out);
            for (size_t i = 0; i < {ROWS} * {COLUMNS}; i++) {{
                {declaration};
                const hodograph_status status = evaluate({member}us[i % {COLUMNS}], vs[i / {COLUMNS}], {result});
                equal &= same{suffix}(status, {result}, &out[i], {size}, {none}, i, &expected);
            }}
            report(equal, missing, expected);
            expected.count = expected.first = 0;
            equal = true;
            missing = {name}_{prefix}points{suffix}({member}us, vs, {POINTS}, out);
            for (size_t i = 0; i < {POINTS}; i++) {{
                {declaration};
                const hodograph_status status = evaluate({member}us[i], vs[i], {result});
                equal &= same{suffix}(status, {result}, &out[i], {size}, {none}, i, &expected);
            }}
            report(equal, missing, expected);
            expected.count = expected.first = 0;
            equal = true;
            missing = expected;
            {name}_{prefix}prepare{suffix}({member}us, {COLUMNS}, strip);
            for (size_t j = 0; j < {ROWS}; j++) {{
                hodograph_add(&missing, {name}_{prefix}row{suffix}({member}strip, {COLUMNS}, vs[j], out), j * {COLUMNS});
                for (size_t i = 0; i < {COLUMNS}; i++) {{
                    {declaration};
                    const hodograph_status status = evaluate({member}us[i], vs[j], {result});
                    equal &= same{suffix}(status, {result}, &out[i], {size}, {none}, j * {COLUMNS} + i, &expected);
                }}
            }}
            report(equal, missing, expected);
        }}",
        task = if prefix.is_empty() { "point" } else { prefix.trim_end_matches('_') },
    );
}

/// The C code that prints the constants of a surface, and the lines that are expected.
fn constants(text: &mut String, expected: &mut Expected, artifact: &Artifact, subject: &Subject) {
    let name = &artifact.name;
    let surface = subject.surface.as_ref();
    let double = TYPES[0];
    let mut expect = |what: &str, numbers: &[f64]| {
        expected.push((format!("{what} of {name}"), double.line(numbers)));
    };
    let (domain, (m, n)) = (surface.domain(), surface.degree());
    _ = writeln!(text, "    put(HODOGRAPH_OK, &{name}_domain, 4);");
    expect("domain", &[domain.u, domain.v].concat());
    _ = writeln!(
        text,
        "    {{\n        const double degree[2] = {{{name}_degree_u, {name}_degree_v}};\n        put(HODOGRAPH_OK, degree, 2);\n    }}"
    );
    expect("degree", &[m, n].map(f64::from));
    if let Some(bounds) = &subject.bounds {
        let net = surface.control_net();
        _ = writeln!(text, "    put(HODOGRAPH_OK, {name}_control_net, {});", 4 * net.len());
        expect("control net", net.as_flattened());
        let plain = |bound: &Bound| {
            let ([double, _, single, _], [relative, _, relative_single, _]) =
                (bound.errors, bound.relative_errors);
            [double, single, relative, relative_single, bound.size]
        };
        let numbers: Vec<f64> = BOUNDED.iter().flat_map(|output| plain(bound_of(bounds, output))).collect();
        _ = writeln!(text, "    put(HODOGRAPH_OK, &{name}_bounds, {});", numbers.len());
        expect("bounds", &numbers);
    }
    if let Some(patch) = &artifact.offset {
        let length = patch.net.len();
        _ = writeln!(
            text,
            "    {{
        const double degree[2] = {{{name}_offset_degree_u, {name}_offset_degree_v}};
        static double net[({name}_offset_degree_u + 1) * ({name}_offset_degree_v + 1)][4];
        {name}_offset_control_net(-0.3, net);
        put(HODOGRAPH_OK, degree, 2);
        put(HODOGRAPH_OK, net, 4 * {length});
    }}"
        );
        expect("degree of offsets", &[patch.degree.0, patch.degree.1].map(f64::from));
        let net: Vec<[f64; 4]> = patch
            .net
            .iter()
            .flat_map(|&[point, [_, a, b, c]]| offset_net(&[(point, [a, b, c])], -0.3))
            .collect();
        expect("control net of an offset", net.as_flattened());
    }
}

/// The C code that makes a member of a family, and that tries to make one of something that is no number.
fn member(text: &mut String, expected: &mut Expected, artifact: &Artifact, subject: &Subject) {
    let (name, mut values, mut first) = (&artifact.name, Vec::new(), String::new());
    for setting in &artifact.symbols {
        let number = |symbol: &String| format!("{:?}", subject.symbols[symbol.as_str()]);
        let (field, value) = match setting {
            Setting::Number(symbol) => (symbol.clone(), number(symbol)),
            Setting::Curve { name, rows, .. } => {
                let row = |row: &Vec<String>| {
                    format!("{{{}}}", row.iter().map(number).collect::<Vec<String>>().join(", "))
                };
                let rows: Vec<String> = rows.iter().map(row).collect();
                (format!("{name}[0][0]"), format!("{{{}}}", rows.join(", ")))
            }
        };
        values.push(value);
        first = field;
    }
    _ = writeln!(
        text,
        "    {name}_parameters parameters = {{{}}};
    {name}_surface surface;
    puts(hodograph_reason({name}_new(&parameters, &surface)));
    {{
        {name}_parameters wrong = parameters;
        {name}_surface none;
        wrong.{first} = NAN;
        puts(hodograph_reason({name}_new(&wrong, &none)));
        wrong.{first} = 1e308;
        puts({name}_new(&wrong, &none) != HODOGRAPH_PARAMETER ? \"a number\" : \"no number\");
    }}",
        values.join(", ")
    );
    for line in ["there is a result", "a parameter is infinite or NaN", "a number"] {
        expected.push((format!("making {name}"), line.to_owned()));
    }
    let net = subject.surface.control_net();
    _ = writeln!(text, "    put(HODOGRAPH_OK, surface.control_net, {});", 4 * net.len());
    expected.push((format!("control net of {name}"), TYPES[0].line(net.as_flattened())));
}

/// What prints and compares numbers.
const PRINTING: &str = r#"
static const char *const reasons[] = {"", "pole", "singular", "parameter", "overflow"};

static void report(bool equal, hodograph_missing missing, hodograph_missing expected)
{
    const bool agree = equal && missing.count == expected.count && missing.first == expected.first;
    printf("%s, %lu missing from %lu\n", agree ? "equal" : "different", (unsigned long)missing.count, (unsigned long)missing.first);
}
"#;

/// The same for each precision.
const PRINTING_OF: &str = r#"
static void putF(hodograph_status status, const void *numbers, size_t count)
{
    for (size_t i = 0; status == HODOGRAPH_OK && i < count; i++) {
        BITS bits;
        memcpy(&bits, (const char *)numbers + i * sizeof bits, sizeof bits);
        printf("%s%0DIGITS" FORMAT, i > 0 ? " " : "", bits);
    }
    puts(reasons[status]);
}

static bool sameF(hodograph_status status, const void *one, const void *item, size_t count, REAL none, size_t place, hodograph_missing *missing)
{
    const hodograph_missing here = {1, 0};
    bool same = true;
    if (status == HODOGRAPH_OK)
        return memcmp(one, item, count * sizeof none) == 0;
    hodograph_add(missing, here, place);
    for (size_t i = 0; i < count; i++)
        same &= memcmp(&none, (const char *)item + i * sizeof none, sizeof none) == 0;
    return same;
}

"#;

/// The beginning of a program: the header, and what prints numbers.
fn beginning() -> String {
    let mut text = String::from("#include \"surfaces.h\"\n#include <inttypes.h>\n#include <stdio.h>\n");
    text.push_str(PRINTING);
    for (Type { name, suffix, bits, .. }, [digits, format]) in
        TYPES.into_iter().zip([["16", "PRIx64"], ["8", "PRIx32"]])
    {
        let replaced = PRINTING_OF.replace("putF", &format!("put{suffix}"));
        let replaced = replaced.replace("sameF", &format!("same{suffix}")).replace("BITS", bits);
        text.push_str(&replaced.replace("DIGITS", digits).replace("FORMAT", format).replace("REAL", name));
    }
    text
}

/// Compares what a program prints, line by line.
fn compare(printed: &str, expected: &Expected) {
    for (found, (label, line)) in printed.lines().zip(expected) {
        assert_eq!(found, line, "{label}");
    }
    assert_eq!(printed.lines().count(), expected.len());
}

/// All surfaces that have an evaluator, one member of each family; with those whose evaluators the tests can call.
fn surfaces() -> Vec<(Artifact, Option<Subject>)> {
    let models: Vec<_> =
        files().into_iter().filter(Formulas::is_expanded).flat_map(|formulas| formulas.models).collect();
    let mut subjects: BTreeMap<String, Subject> = BTreeMap::new();
    for subject in all() {
        subjects.entry(subject.surface.name().to_owned()).or_insert(subject);
    }
    let with_subject = |model: &Model| {
        let artifact = compile(model).unwrap_or_else(|error| panic!("{}: {error}", model.name));
        (artifact, subjects.remove(&model.name))
    };
    let surfaces = models.iter().map(with_subject).collect();
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
    let bits =
        |outcome: Outcome| outcome.map(|numbers| numbers.into_iter().map(f64::to_bits).collect::<Vec<_>>());
    for Subject { surface, .. } in all() {
        for place in places(surface.as_ref(), Precision::Double) {
            for function in &FUNCTIONS {
                let outcome = function.outcome(surface.as_ref(), rounding, place);
                let found = runtime(surface.as_ref(), function.name, place);
                assert_eq!(
                    bits(found),
                    bits(outcome),
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
    fs::write(folder.path().join("surfaces.h"), header(&artifacts)).unwrap();
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
        evaluation(&mut text, &mut expected, (&artifact.name, prefix), subject.surface.as_ref());
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

/// Expands sweeps and keeps their text.
macro_rules! sweeps {
    ($($tokens:tt)*) => {
        hodograph::sweep! { $($tokens)* }
        const TEXT: &str = stringify!($($tokens)*);
    };
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
    let surfaces: [(&str, &dyn Evaluator); 6] = [
        ("tiny", &tiny::Tiny),
        ("huge", &huge::Huge),
        ("wide", &wide::Wide),
        ("cone", &cone::Cone),
        ("double_", &double_::Double),
        ("sweep_hodograph_first", &hodograph_first::HodographFirst),
    ];
    assert_eq!(artifacts.len(), surfaces.len() + 1);
    fs::write(folder.path().join("surfaces.h"), header(&artifacts)).unwrap();
    let (mut text, mut expected) = (beginning(), Expected::new());
    text.push_str("int main(void)\n{\n");
    for (name, surface) in surfaces {
        evaluation(&mut text, &mut expected, (name, ""), surface);
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
}

#[test]
fn members_are_rejected_for_the_same_reasons() {
    use hodograph::catalogue::oriented_translation_family::{OrientedTranslationFamily, Parameters};
    let folder = tempfile::tempdir().unwrap();
    let words = |result: Result<(), ParameterError>| match result {
        Ok(()) => "there is a result",
        Err(ParameterError::NotFinite { .. }) => "a parameter is infinite or NaN",
        Err(ParameterError::Overflow) => "the result is beyond the range of numbers",
        Err(ParameterError::Pole { .. }) => "the surface has a pole there",
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
    fs::write(folder.path().join("surfaces.h"), header(&artifacts)).unwrap();
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
    fs::write(folder.path().join("empty.c"), format!("{}\nint main(void) {{ return 0; }}\n", header(&[])))
        .unwrap();
    let check = ["-fsyntax-only", "-Wno-unused-function", "empty.c"];
    let Some(plain) = cc(folder.path(), LANGUAGES[0], &check) else { return };
    assert!(plain.status.success(), "{}", String::from_utf8_lossy(&plain.stderr));
    let fast = [&["-ffast-math"], check.as_slice()].concat();
    let fast = cc(folder.path(), LANGUAGES[0], &fast).unwrap();
    let message = String::from_utf8_lossy(&fast.stderr);
    assert!(!fast.status.success() && message.contains("-ffast-math"), "{message}");
}
