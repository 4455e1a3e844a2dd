//! The command `hodograph`, run as scripts and people run it: output, keys of JSON, exit status, bad input.

use std::io::Write;
use std::process::{Command, Output, Stdio};

use serde_json::Value;

/// What the command did.
struct Run {
    status: i32,
    out: String,
    err: String,
}

impl From<Output> for Run {
    fn from(output: Output) -> Run {
        let text = |bytes: Vec<u8>| String::from_utf8_lossy(&bytes).into_owned();
        Run { status: output.status.code().unwrap_or(-1), out: text(output.stdout), err: text(output.stderr) }
    }
}

impl Run {
    /// The standard output as JSON, of a run that should succeed with this status.
    #[track_caller]
    fn json(&self, status: i32) -> Value {
        assert_eq!(self.status, status, "{}", self.err);
        serde_json::from_str(&self.out).unwrap_or_else(|error| panic!("{error}: {}", self.out))
    }

    /// Checks that the run failed as bad input does, with this in its message.
    #[track_caller]
    fn refused(&self, message: &str) {
        assert_eq!((self.status, self.out.as_str()), (2, ""), "{}", self.err);
        assert!(self.err.contains(message), "{}", self.err);
        assert!(!self.err.contains("panicked"), "{}", self.err);
    }
}

fn run(arguments: &[&str]) -> Run {
    Command::new(&hodograph_tests::build::built().binary)
        .args(arguments)
        .stdin(Stdio::null())
        .output()
        .map(Run::from)
        .unwrap_or_else(|e| panic!("{e}"))
}

/// Runs the command with a text as its standard input.
fn run_with(input: &[u8], arguments: &[&str]) -> Run {
    let mut command = Command::new(&hodograph_tests::build::built().binary);
    command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap_or_else(|error| panic!("{error}"));
    if let Some(mut stdin) = child.stdin.take() {
        // The command may refuse its input before it has read all of it.
        let _ = stdin.write_all(input);
    }
    child.wait_with_output().map(Run::from).unwrap_or_else(|error| panic!("{error}"))
}

fn strings(value: &Value) -> Vec<&str> {
    value.as_array().into_iter().flatten().filter_map(Value::as_str).collect()
}

/// The keys of an object, in their order.
fn keys(text: &str, value: &Value) -> Vec<String> {
    let mut keys: Vec<String> = value.as_object().into_iter().flatten().map(|(key, _)| key.clone()).collect();
    keys.sort_by_key(|key| text.find(&format!("\"{key}\":")));
    keys
}

const CYLINDER: &str = "\
/// Half a cylinder.
sweep cylinder {
    source \"by hand\";
    path s(u) = ((1 - u^2)/(1 + u^2), 2*u/(1 + u^2));
    surface R = s + v*k;
    domain u in -1..1, v in 0..2;
    claim \"degree\": degree(R) == (2, 1);
}
";

const SYMBOLS: &str = "\
sweep paraboloid {
    symbol a, b;
    surface R = u*i + v*j + (a*u^2 + b*v^2)*k;
    domain u in 0..1, v in 0..1;
}
sweep hyperbola {
    surface R = u*i + v/u*j;
    domain u in 1..2, v in 0..1;
}
lemma fact {
    claim \"two\": 1 + 1 == 2;
}
";

#[test]
fn verify_says_what_is_expected_by_its_status() {
    let lemma =
        |claims: &str| run_with(format!("lemma l {{ symbol a; {claims} }}").as_bytes(), &["verify", "-"]);
    let (truth, lie) = ("claim \"t\": 1 + 1 == 2", "claim \"l\": a^2 == a");
    for (claims, status) in [
        (format!("{truth};"), 0),
        (format!("{lie}, expect refuted;"), 0),
        (format!("{truth}; {lie};"), 1),
        (format!("{truth}, expect refuted;"), 1),
        (format!("{truth}, expect undecided;"), 1),
        ("claim \"u\": a > 0;".to_owned(), 3),
        ("claim \"u\": a > 0, expect undecided;".to_owned(), 0),
        (format!("claim \"u\": a > 0; {lie};"), 1),
    ] {
        let run = lemma(&claims);
        assert_eq!(run.status, status, "{claims}\n{}{}", run.out, run.err);
        assert_eq!(run.err, "");
        assert_eq!(run.out.contains("all as expected"), status == 0, "{}", run.out);
    }
    let run = lemma(&format!("{lie}, \"a remark\";"));
    for part in ["! ✗ l ", "expected proved", "witness: a = ", "note: a remark", "1 refuted"] {
        assert!(run.out.contains(part), "{}", run.out);
    }
}

const EXPLAINED: &str = "\
lemma square {
    source \"a book\";
    symbol a, b;
    let f(v) = (a + b*v)^2;
    claim \"A-1,2\": f == a^2 + b^2*v^2, \"as printed\", effect major \"areas are too small\", expect refuted;
    claim \"A-1,2\": f == a^2 + 2*a*b*v + b^2*v^2, instead \"with the mixed product\";
    claim \"other\": 1 + 1 == 2;
}
";

#[test]
fn verify_explains_a_claim() {
    let explain = |arguments: &[&str]| {
        run_with(EXPLAINED.as_bytes(), &[&["verify", "-", "--explain"], arguments].concat())
    };
    let answer = explain(&["A-1,2"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    for part in [
        "A-1,2: refuted, as expected",
        "lemma square in <standard input>: a book",
        "definition     let f(v) = (a + b*v)^2",
        "left side      f = (b*v + a)^2",
        "difference     2*a*b*v",
        "what is right  f == a^2 + 2*a*b*v + b^2*v^2",
        "A-1,2: 1 proved, 1 refuted, 0 undecided",
    ] {
        assert!(answer.out.contains(part), "{part}: {}", answer.out);
    }
    assert!(!answer.out.contains("1 + 1"), "{}", answer.out);

    let answer = explain(&["A-1,2", "--format", "json"]);
    let json = answer.json(0);
    assert_eq!((&json["schema"], json["claims"].as_array().map(Vec::len)), (&Value::from(1), Some(2)));
    let steps = json["claims"][0]["steps"].as_array().cloned().unwrap_or_default();
    assert_eq!(keys(&answer.out, &steps[0]), ["what", "formula", "because"]);
    let last = steps.last().cloned().unwrap_or_default();
    assert_eq!((&last["what"], &last["formula"]), (&Value::from("verdict"), &Value::from("refuted")));

    explain(&["a-1"]).refused("there is no claim `a-1`");
    assert!(explain(&["a-1"]).err.contains("there are A-1,2"));
    assert!(explain(&["othr"]).err.contains("did you mean `other`?"));
    assert!(explain(&["nothing like it"]).err.contains("the ids are A-1,2, other"));
    assert_eq!(run_with(b"lemma l { claim \"x\": 1 == 2; }", &["verify", "-", "--explain", "x"]).status, 1);
    assert_eq!(run(&["verify", "--full"]).status, 2);
}

#[test]
fn verify_explains_claims_of_the_catalogue() {
    let run = run(&["verify", "--explain", "FN-Ex1-rho"]);
    assert_eq!((run.status, run.err.as_str()), (0, ""));
    assert!(run.out.contains("number         sqrt(norm2(s(1/2))) = 4/5*sqrt2"), "{}", run.out);
}

#[test]
fn errors_of_sources_are_a_page() {
    let page = run_with(EXPLAINED.as_bytes(), &["errors", "-"]);
    assert_eq!((page.status, page.err.as_str()), (0, ""));
    for part in [
        "| major | [A-1,2](#a-12) | a book | as printed |",
        "## A-1,2\n\nSeverity: major.",
        "**Printed** (a book): as printed.\n\n```text\nf == a^2 + b^2*v^2\n```",
        "difference: 2*a*b*v   // not the zero function",
        "with the mixed product.\n\n```text\nf == a^2 + 2*a*b*v + b^2*v^2\n```",
        "**Effect.** Areas are too small.",
    ] {
        assert!(page.out.contains(part), "{part}: {}", page.out);
    }
    let wrong = b"lemma l { claim \"x\": 1 == 1, expect refuted; }";
    run_with(wrong, &["errors", "-"]).refused("this is expected to be refuted, but it is proved");
}

#[test]
fn verify_writes_json() {
    let input = "lemma l { source \"a book\"; symbol a; claim \"x\": a == a^2, expect refuted; claim \"y\": a == 1, when a == 1; }";
    let run = run_with(input.as_bytes(), &["verify", "-", "--format", "json"]);
    let json = run.json(0);
    assert_eq!(json["schema"], 1);
    let claims = json["claims"].as_array().map_or(&[][..], Vec::as_slice);
    assert_eq!(claims.len(), 2);
    let expected = [
        "id",
        "sweep",
        "source",
        "statement",
        "verdict",
        "scope",
        "condition",
        "expected",
        "derived",
        "witness",
    ];
    assert_eq!(keys(&run.out, &claims[0]), expected);
    assert_eq!(claims[0]["verdict"], "refuted");
    assert_eq!(claims[0]["expected"], "refuted");
    assert_eq!(claims[0]["source"], "a book");
    assert_eq!(claims[0]["statement"], "a == a^2");
    assert!(
        claims[0]["witness"].as_str().is_some_and(|witness| witness.starts_with("a = ")),
        "{}",
        claims[0]
    );
    assert_eq!(claims[0]["condition"], Value::Null);
    assert_eq!(claims[1]["condition"], "a == 1");
    assert_eq!(claims[1]["verdict"], "proved");
    assert_eq!(claims[1]["witness"], Value::Null);
}

#[test]
fn the_catalogue_is_as_expected() {
    let run = run(&[]);
    assert_eq!(run.status, 0, "{}{}", run.out, run.err);
    assert_eq!(run.err, "", "progress is for terminals");
    assert!(run.out.contains("oriented_translation_example_2"), "{}", run.out);
    assert!(run.out.contains("all as expected"), "{}", run.out);
    assert!(!run.out.contains('\u{1b}'), "colors are for terminals");
    let long = run.out.lines().find(|line| line.chars().count() > 100 && line.contains(' '));
    assert_eq!(long, None);
}

#[test]
fn entries_of_the_catalogue_have_names() {
    let entry = run(&["verify", "oriented_translation_example_2"]);
    assert_eq!(entry.status, 0, "{}", entry.err);
    assert!(entry.out.contains("1 sweep and 0 lemmas"), "{}", entry.out);
    run(&["derive", "oriented_translation_exmple_2"])
        .refused("did you mean `oriented_translation_example_2`?");
    run(&["derive", "nothing_like_it"]).refused("neither a file nor an entry");
}

#[test]
fn derive_writes_json() {
    let run = run_with(CYLINDER.as_bytes(), &["derive", "-", "--format", "json"]);
    let json = run.json(0);
    assert_eq!(json["schema"], 1);
    let sweep = &json["sweeps"][0];
    let expected = [
        "name",
        "source",
        "parameters",
        "symbols",
        "field",
        "homogeneous",
        "degree",
        "raw_degree",
        "common_factor",
        "conditions",
        "normal",
        "speeds",
        "singular",
        "offset",
        "control_net",
    ];
    let found: Vec<&str> = sweep.as_object().into_iter().flatten().map(|(key, _)| key.as_str()).collect();
    assert!(expected.iter().all(|key| found.contains(key)) && found.len() == expected.len(), "{found:?}");
    assert_eq!(sweep["name"], "cylinder");
    assert_eq!(strings(&sweep["parameters"]), ["u", "v"]);
    assert_eq!(sweep["field"], serde_json::json!({ "degree": 1, "generators": [] }));
    let polynomial = |name: &str| sweep["homogeneous"][name]["polynomial"].clone();
    assert_eq!(
        ["W", "X", "Y", "Z"].map(polynomial),
        ["u^2 + 1", "-u^2 + 1", "2*u", "u^2*v + v"].map(Value::from)
    );
    assert_eq!(
        sweep["homogeneous"]["Z"],
        serde_json::json!({ "degree": [2, 1], "terms": 2, "polynomial": "u^2*v + v" })
    );
    assert_eq!(sweep["degree"], serde_json::json!([2, 1]));
    assert_eq!(sweep["common_factor"], "1");
    assert_eq!(sweep["normal"]["rational"], true);
    assert_eq!(sweep["speeds"], serde_json::json!({ "u": "2/(u^2 + 1)", "v": "1" }));
    assert_eq!(strings(&sweep["singular"]["zeros"]), [""; 0]);
    assert_eq!(sweep["offset"]["rational"], true);
    let offset = sweep["offset"]["homogeneous"]["Y"]["polynomial"].as_str().unwrap_or_default();
    assert!(["2*r*u + 2*u", "-2*r*u + 2*u"].contains(&offset), "{offset}");
    // Over u in -1..1 the half circle has the control points (1, -1, -1), (0, 2, 0), (1, ...) times a common factor.
    let points = sweep["control_net"]["points"].as_array().map_or(0, Vec::len);
    assert_eq!((points, &sweep["control_net"]["degree"]), (6, &serde_json::json!([2, 1])));
    assert_eq!(strings(&sweep["control_net"]["points"][3]), ["0", "2", "0", "0"]);
}

#[test]
fn derive_shows_number_fields() {
    let run = run(&["derive", "oriented_translation_example_2", "--format", "json"]);
    let json = run.json(0);
    let sweep = &json["sweeps"][0];
    assert_eq!(sweep["field"]["degree"], 4);
    assert_eq!(sweep["degree"], serde_json::json!([2, 9]));
    let generators = sweep["field"]["generators"].as_array().map_or(&[][..], Vec::as_slice);
    assert_eq!(generators.len(), 2);
    assert_eq!(generators[0]["relation"], "sqrt2^2 - 2");
    for generator in generators {
        let digits = generator["approximation"].as_str().unwrap_or_default();
        assert!(digits.chars().filter(char::is_ascii_digit).count() >= 17, "{digits}");
    }
}

#[test]
fn derive_prints_for_people() {
    let run = run_with(CYLINDER.as_bytes(), &["derive", "-"]);
    assert_eq!(run.status, 0, "{}", run.err);
    for part in [
        "sweep cylinder\n  by hand\n\n  Half a cylinder.\n",
        "  surface R = s + v*k;\n",
        "  patch     (2, 1)\n",
        "  W = u^2 + 1\n",
        "  Z = v*(u^2 + 1)\n",
        "  |R_u| = 2 / (u^2 + 1)\n",
        "there is a normal everywhere",
        "  rational: |N|^2 is the square of a polynomial",
        "  b[1,0] = (0, 2, 0, 0)\n",
    ] {
        assert!(run.out.contains(part), "{part}: {}", run.out);
    }
    let latex = run_with(CYLINDER.as_bytes(), &["derive", "-", "--format", "latex"]);
    assert!(
        latex.out.contains("s(u) &= \\left(\\frac{1 - u^{2}}{1 + u^{2}}, \\frac{2\\, u}{1 + u^{2}}\\right)"),
        "{}",
        latex.out
    );
    assert!(latex.out.contains("Z &= v\\bigl(u^{2} + 1\\bigr)"), "{}", latex.out);
}

#[test]
fn derive_takes_one_sweep_of_several() {
    let derive = |arguments: &[&str]| run_with(SYMBOLS.as_bytes(), &[&["derive", "-"], arguments].concat());
    let all = derive(&["--format", "json"]).json(0);
    assert_eq!(all["sweeps"].as_array().map(Vec::len), Some(2));
    assert_eq!(strings(&all["sweeps"][0]["symbols"]), ["a", "b"]);
    let one = derive(&["--format", "json", "--sweep", "paraboloid"]).json(0);
    assert_eq!(one["sweeps"].as_array().map(Vec::len), Some(1));
    assert_eq!(one["sweeps"][0]["offset"]["homogeneous"], Value::Null);
    derive(&["--sweep", "fact"]).refused("`fact` is a lemma, so it has no surface");
    derive(&["--sweep", "parabolid"]).refused("did you mean `paraboloid`?");
    run_with(b"lemma a { claim \"x\": 1 == 1; }", &["derive", "-"]).refused("only lemmas");
    run_with(b"sweep a { surface R = u*i + u^2*k; domain u in 0..1, v in 0..1; }", &["derive", "-"])
        .refused("a curve or a point, not a surface");
}

#[test]
fn eval_is_exact() {
    let eval = |arguments: &[&str]| {
        run_with(CYLINDER.as_bytes(), &[&["eval", "-", "--format", "json"], arguments].concat())
    };
    let run = eval(&["--u", "1/2", "--v", "0.25"]);
    let json = run.json(0);
    assert_eq!(keys(&run.out, &json), ["schema", "sweep", "u", "v", "what", "exact", "decimal"]);
    assert_eq!((&json["what"], &json["u"], &json["v"]), (&"point".into(), &"1/2".into(), &"1/4".into()));
    assert_eq!(strings(&json["exact"]), ["3/5", "4/5", "1/4"]);
    assert_eq!(strings(&json["decimal"]), ["0.6", "0.8", "0.25"]);
    assert_eq!(run.err, "");
    for (what, exact) in [
        ("homogeneous", &["5/4", "3/4", "1", "5/16"][..]),
        ("du", &["-32/25", "24/25", "0"]),
        ("dv", &["0", "0", "1"]),
        ("normal", &["24/25", "32/25", "0"]),
        ("unit-normal", &["3/5", "4/5", "0"]),
        ("speed-u", &["8/5"]),
        ("speed-v", &["1"]),
    ] {
        let json = eval(&["--u", "1/2", "--v", "1/4", "--what", what]).json(0);
        assert_eq!(strings(&json["exact"]), exact, "{what}");
    }
    let offset = eval(&["--u", "1/2", "--v", "1/4", "--what", "offset", "--set", "r=-1"]).json(0);
    assert_eq!(strings(&offset["exact"]), ["0", "0", "1/4"]);
    let root = eval(&["--u", "sqrt(2) - 1", "--v", "-sqrt(2)/2", "--digits", "30"]);
    let json = root.json(0);
    assert_eq!(strings(&json["exact"]), ["1/2*sqrt(2)", "1/2*sqrt(2)", "-1/2*sqrt(2)"]);
    assert_eq!(strings(&json["decimal"])[2], "-0.707106781186547524400844362105");
    assert!(root.err.contains("v = ") && root.err.contains("outside of the domain 0..2"), "{}", root.err);
}

/// The domain of a surface in several pieces is that of all of them.
#[test]
fn eval_knows_the_whole_domain() {
    for (v, noted) in [("4", true), ("-1", true), ("0", false), ("3/2", false), ("3", false)] {
        let run = run(&["eval", "frames_gutter", "--u", "1/2", &format!("--v={v}")]);
        let note = format!("v = {v} lies outside of the domain 0..3");
        assert_eq!(run.err.contains(&note), noted, "{}", run.err);
        assert_eq!(run.err.contains("outside"), noted, "{}", run.err);
    }
}

#[test]
fn eval_needs_every_symbol() {
    let eval = |arguments: &[&str]| {
        run_with(
            SYMBOLS.as_bytes(),
            &[&["eval", "-", "--sweep", "paraboloid", "--u", "1/2", "--v", "-1/3"], arguments].concat(),
        )
    };
    let text = eval(&["--set", "a=2", "--set", "b=-9"]);
    assert_eq!(text.status, 0, "{}", text.err);
    assert!(
        text.out.contains("  x = 1/2\n    = 0.5\n  y = -1/3\n    ≈ -0.33333333333333333\n  z = -1/2\n"),
        "{}",
        text.out
    );
    eval(&[]).refused("needs values for a, b");
    eval(&["--set", "a=1"]).refused("needs a value for b");
    eval(&["--set", "a=1", "--set", "b=1", "--set", "c=1"]).refused("no symbol `c`");
    eval(&["--set", "a=1", "--set", "a=2", "--set", "b=1"]).refused("two values");
    eval(&["--set", "a", "--set", "b=1"]).refused("--set a0=1/2");
    eval(&["--set", "a=x", "--set", "b=1"]).refused("`x` is not defined");
    eval(&["--set", "a=1", "--set", "b=1", "--what", "offset"]).refused("needs a value for r");
    run_with(SYMBOLS.as_bytes(), &["eval", "-", "--u", "1", "--v", "1"])
        .refused("choose one with --sweep: paraboloid, hyperbola");
}

#[test]
fn eval_says_where_there_is_nothing() {
    let hyperbola = ["eval", "-", "--sweep", "hyperbola", "--v", "1"];
    run_with(SYMBOLS.as_bytes(), &[&hyperbola[..], &["--u", "0"]].concat()).refused("pole at u = 0, v = 1");
    let infinite = ["--u", "0", "--what", "homogeneous", "--format", "json"];
    let json = run_with(SYMBOLS.as_bytes(), &[&hyperbola[..], &infinite].concat()).json(0);
    assert_eq!(strings(&json["exact"]), ["0", "0", "1", "0"]);
    run(&["eval", "scaled_rotation_example_1", "--u", "1", "--v", "1/2", "--what", "unit-normal"])
        .refused("singular at u = 1, v = 1/2");
    run(&["eval", "scaled_rotation_example_1", "--u", "1/0", "--v", "0"]).refused("division by zero");
    run(&["eval", "scaled_rotation_example_1", "--u", "I", "--v", "0"]).refused("complex");
    run(&["eval", "scaled_rotation_example_1", "--u", "0", "--v", "0", "--digits", "100000000"])
        .refused("--digits");
    run(&["eval", "scaled_rotation_example_1", "--u", "2^-10000", "--v", "0"]).refused("limit");
}

#[test]
fn emit_writes_and_checks() -> Result<(), Box<dyn std::error::Error>> {
    let directory = tempfile::tempdir()?;
    let formula = directory.path().join("a formula.sweep");
    std::fs::write(&formula, CYLINDER)?;
    let (formula, source) = (formula.display().to_string(), directory.path().join("cylinder.rs"));
    let path = source.display().to_string();
    let emit = ["emit", &formula, "--target", "rust"];
    let printed = run(&emit);
    assert_eq!(printed.status, 0, "{}", printed.err);
    assert!(printed.out.contains("pub mod cylinder"), "{}", printed.out);

    let to_file = [&emit[..], &["-o", &path]].concat();
    let check = [&to_file[..], &["--check"]].concat();
    let missing = run(&check);
    assert_eq!(missing.status, 1);
    assert!(missing.err.contains("does not exist"), "{}", missing.err);
    assert_eq!(run(&to_file).status, 0);
    assert_eq!(std::fs::read_to_string(&source)?, printed.out);
    assert_eq!(run(&check).status, 0);

    std::fs::write(&source, printed.out.replace("pub mod", "mod"))?;
    let stale = run(&check);
    assert_eq!((stale.status, stale.out.as_str()), (1, ""));
    assert!(
        stale.err.contains(&format!("hodograph emit '{formula}' --target rust -o {path}")),
        "{}",
        stale.err
    );
    assert!(std::fs::read_to_string(&source)?.contains("\nmod cylinder"), "a check writes nothing");

    run(&[&emit[..], &["-o", &directory.path().display().to_string()]].concat()).refused("is a directory");
    run(&[&emit[..], &["--check"]].concat()).refused("--output");
    let clash = b"sweep tube { surface R = (u, v, u*v); domain u in 0..1, v in 0..1; }
        sweep tube_normal { surface R = (u, v, u^2); domain u in 0..1, v in 0..1; }";
    run_with(clash, &["emit", "-", "--target", "c"]).refused("would both define `tube_normal_");
    let header = run(&["emit", &formula, "--target", "c"]);
    assert!(
        header.status == 0
            && header.out.contains("static inline hodograph_status cylinder_point(double u, double v"),
        "{}",
        header.err
    );
    Ok(())
}

#[test]
fn mistakes_are_shown_with_their_places() {
    let text =
        "sweep a {\n    surface R = q + S;\n    domain u in 0..1, v in 0..1;\n    claim \"x\": Q == 1;\n}\n";
    let run = run_with(text.as_bytes(), &["verify", "-", "--format", "json"]);
    run.refused("<standard input>:2:17");
    assert!(run.err.contains("<standard input>:4:16"), "all mistakes are reported: {}", run.err);
    run_with(b"lemma l { claim \"x\": 1 + (1, 2) == 3; }", &["verify", "-"]).refused("cannot be added");
}

#[test]
fn bad_input_is_refused() -> Result<(), Box<dyn std::error::Error>> {
    let directory = tempfile::tempdir()?;
    let file = |name: &str, bytes: &[u8]| -> Result<String, std::io::Error> {
        let path = directory.path().join(name);
        std::fs::write(&path, bytes)?;
        Ok(path.display().to_string())
    };
    run(&["derive", &file("empty.sweep", b"")?]).refused("neither a sweep nor a lemma");
    run(&["derive", &file("binary", b"\x7fELF\0\0")?]).refused("binary");
    run(&["derive", &file("latin.sweep", b"// caf\xe9")?]).refused("not UTF-8");
    run(&["derive", &file("long.sweep", &vec![b' '; 3_000_000])?]).refused("longer than the limit");
    run(&["derive", &directory.path().display().to_string()]).refused("is a directory");
    run(&["derive", "missing.sweep"]).refused("cannot read missing.sweep");
    run(&["verify", "missing.sweep", "nothing_like_it"]).refused("nothing_like_it");
    run(&["derive"]).refused("required");
    run(&["frobnicate"]).refused("unrecognized subcommand");
    run(&["export", "a.sweep"]).refused("unrecognized subcommand");
    run(&["derive", "a.sweep", "--format", "yaml"]).refused("yaml");
    Ok(())
}

#[test]
fn a_closed_pipe_is_no_failure() {
    let mut command = Command::new(&hodograph_tests::build::built().binary);
    command.args(["derive", "oriented_translation_example_2", "--format", "json"]);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap_or_else(|error| panic!("{error}"));
    drop(child.stdout.take());
    let run = child.wait_with_output().map(Run::from).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((run.status, run.err.as_str()), (0, ""));
}

#[test]
fn help_names_the_exit_status() {
    let help = run(&["--help"]);
    assert_eq!(help.status, 0);
    for part in ["verify", "derive", "eval", "emit", "Exit status"] {
        assert!(help.out.contains(part), "{}", help.out);
    }
}

#[test]
fn what_a_derivation_has_is_not_lost_with_what_the_budget_does_not_suffice_for() {
    let derive = |format: &str| {
        run(&["derive", "oriented_translation_example_2", "--budget", "80_000", "--format", format])
    };
    let derived = derive("json").json(0);
    let derived = &derived["sweeps"][0];
    assert_eq!(derived["degree"], serde_json::json!([2, 9]));
    assert_eq!(derived["control_net"]["degree"], derived["degree"]);
    for missing in ["normal", "speeds", "singular", "offset"] {
        assert!(derived[missing].is_null(), "{missing}");
    }
    let reasons = derived["undetermined"].as_array().expect("a list");
    assert!(reasons[0].as_str().is_some_and(|reason| reason.contains("units of work; it was computing ")));
    assert!(derive("text").out.contains("undetermined: this needs more than"));
    assert!(derive("latex").out.contains("are undetermined"));
}

#[test]
fn a_budget_is_a_limit_for_each_command() {
    let source = "sweep tube {
    profile p(u) = (1 - u^2)/(1 + u^2)*i + 2*u/(1 + u^2)*k;
    path s(v) = ph(5);
    surface R = s + p.x*s.normal + p.z*k;
    domain u in 0..1, v in 0..1;
    claim \"power\": (1 + u + v)^200 != 1;
}";
    let with = |arguments: &[&str]| run_with(source.as_bytes(), arguments);
    let derive = with(&["derive", "-", "--budget", "3000", "--format", "json"]);
    derive.refused("this needs more than the budget of 3000 units of work");
    assert!(derive.err.contains("<standard input>:3:17"), "{}", derive.err);
    with(&["emit", "-", "--target", "rust", "--budget", "100_000"]).refused("the budget of 100000 units");
    with(&["eval", "-", "--u", "1/2", "--v", "sqrt(2)", "--budget", "10"]).refused("the budget of 10 units");
    // What does not fit into the definitions has the place of the innermost expression, and what does not fit into a claim
    // leaves it undecided.
    let verify = with(&["verify", "-", "--budget", "500"]);
    verify.refused("the budget of 500 units of work");
    let verdict = with(&["verify", "-", "--budget", "20_000", "--format", "json"]).json(3);
    let claim = &verdict["claims"][0];
    assert_eq!(claim["verdict"], "undecided");
    assert!(
        claim["derived"].as_str().is_some_and(|text| text.contains("the budget of 20000 units")),
        "{claim}"
    );
    for wrong in ["0", "1e6", "-5"] {
        assert_eq!(with(&["verify", "-", "--budget", wrong]).status, 2);
    }
}
