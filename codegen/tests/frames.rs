//! Frames in the language: files and their mistakes, pieces, claims on all of them.

use hodograph_codegen::language::ast::Verdict;
use hodograph_codegen::language::{Report, parse_text};
use hodograph_codegen::meaning::{Judgement, Model, models};

/// The models of a text, with `json` for every file that it names.
fn read(text: &str, json: &str) -> Result<Vec<Model>, Vec<String>> {
    let (mut file, source) = parse_text("a.sweep", text).unwrap();
    file.attach(|_| Ok(json.to_owned()));
    let (models, mistakes) = models(&file);
    if mistakes.is_empty() { Ok(models) } else { Err(Report::new(source, mistakes).lines()) }
}

/// The mistakes of frames in a file.
fn mistakes(json: &str) -> Vec<String> {
    read("lemma a { frames F(v) = frames_file(\"f.json\"); }", json).unwrap_err()
}

/// The only mistake, behind the place of the file's name.
fn mistake(json: &str) -> String {
    let lines = mistakes(json);
    let [line] = lines.as_slice() else { panic!("{lines:?}") };
    line.strip_prefix("a.sweep:1:37: ").unwrap().to_owned()
}

fn judge(text: &str) -> Vec<Judgement> {
    let models = read(text, "[]").unwrap_or_else(|lines| panic!("{lines:?}"));
    models
        .iter()
        .flat_map(|model| model.claims.iter().map(|claim| model.check(claim, u64::MAX).unwrap()))
        .collect()
}

const THREE: &str = "frames([frame((0, 0, 0), (0, 0, 0, 1)), frame((1, 0, 0), (0, 0, 3/5, 4/5)), frame((3, 1, 0), (0, 4/5, 0, 3/5))]";

#[test]
fn files_are_exact() {
    let json = r#"[
        {"position": [0, -0.1, 1e-3], "quaternion": ["-3/5", 0, 0, ".8"]},
        {"scale": "2.5", "quaternion": [ 1 , 0 , 0 , 0 ], "position": ["1/3", "-1/3", 2]}
    ]"#;
    let text = r#"lemma a {
        frames F(v) = frames_file("f.json");
        claim "start": F.position(0) == (0, -1/10, 1/1000);
        claim "end": F.position(1) == (1/3, -1/3, 2);
        claim "scale": F.scale(1) == 5/2;
        claim "quaternion": (F.quaternion(0).w, F.quaternion(0).z) == (-3/5, 4/5);
    }"#;
    let models = read(text, json).unwrap();
    for claim in &models[0].claims {
        let judgement = models[0].check(claim, u64::MAX).unwrap();
        assert_eq!(judgement.verdict, Verdict::Proved, "{judgement:?}");
    }
}

#[test]
fn mistakes_in_files_have_their_places() {
    assert_eq!(mistake(""), "f.json:1:1: expected a value, found the end");
    assert_eq!(mistake("{}"), "f.json:1:1: a list of frames is expected, but this is an object");
    assert_eq!(mistake("[1, \n"), "f.json:1:4: expected a value, found the end");
    assert_eq!(mistake("[1, 2,\n]"), "f.json:1:6: nothing follows this comma");
    assert_eq!(mistake("[[}]"), "f.json:1:3: expected a value, found `}`");
    assert_eq!(mistake("[7]"), "f.json:1:2: a frame is expected, but this is a number");
    assert_eq!(mistake("[01]"), "f.json:1:2: a number in JSON does not begin with a zero that says nothing");
    assert_eq!(mistake("[{\"a\": 1, \"a\": 2}]"), "f.json:1:11: the key \"a\" stands twice");
    assert_eq!(mistake("[{\"a\" 1}]"), "f.json:1:7: expected `:`, found the number 1");
    assert_eq!(mistake("[{a: 1}]"), "f.json:1:3: expected a key in double quotes, found `a`");
    assert!(mistake(&"[".repeat(100_000)).ends_with("this is nested more than 32 levels deep"));
    assert_eq!(mistake("[]"), "a motion needs two frames at least, and here are 0");
    let of = |quaternion: &str, rest: &str| {
        format!(
            "[{{\"position\": [0, 0, 0], \"quaternion\": [0, 0, 0, 1]}},\n {{\"position\": [1, 0, 0], \"quaternion\": {quaternion}{rest}}}]"
        )
    };
    assert_eq!(
        mistake(&of("[0, 0, 0.6, 0.81]", "")),
        "f.json:2:40: the quaternion q of frame 2 is no unit quaternion: |q|² = 10161/10000",
    );
    assert_eq!(
        mistake(&of("[0, 0, 0, 0]", "")),
        "f.json:2:40: the quaternion of frame 2 is zero, so it has no orientation"
    );
    assert_eq!(
        mistake(&of("[0, 0, 1]", "")),
        "f.json:2:40: the quaternion is a list of 4 numbers, but here are 3"
    );
    assert_eq!(mistake(&of("[0, 0, 0, \"1/0\"]", "")), "f.json:2:50: \"1/0\" is no number");
    assert_eq!(mistake(&of("[0, 0, 0, \"-1/-2\"]", "")), "f.json:2:50: \"-1/-2\" is no number");
    assert_eq!(
        mistake(&of("[0, 0, 0, true]", "")),
        "f.json:2:50: a number is expected here, but this is a word"
    );
    assert_eq!(
        mistake(&of("[0, 0, 0, 1]", ", \"scale\": -1")),
        "f.json:2:63: the scale of frame 2 is not positive"
    );
    assert_eq!(mistake(&of("[0, 0, 0, 1]", ", \"size\": 1")), "f.json:2:54: a frame has no \"size\"");
    let twice = "{\"position\": [0, 0, 0], \"quaternion\": [0, 0, 0, 1]}";
    assert_eq!(mistake(&format!("[{twice},\n{twice}]")), "f.json:2:1: frame 2 is the same as frame 1");
    let all = mistakes("[{\"position\": 1, \"quaternion\": [1]}, {}, {}]");
    assert_eq!(
        all,
        ["a.sweep:1:37: f.json:1:15: the position is a list of 3 numbers, but this is a number; \
          f.json:1:32: the quaternion is a list of 4 numbers, but here are 1; f.json:1:38: this frame has no \"position\"; \
          f.json:1:38: this frame has no \"quaternion\"; … and 2 more mistakes"],
    );
}

#[test]
fn files_that_cannot_be_read_are_named() {
    let text = "lemma a { frames F(v) = frames_file(\"f.json\"); }";
    let (mut file, source) = parse_text("a.sweep", text).unwrap();
    let lines = Report::new(source.clone(), models(&file).1).lines();
    assert_eq!(lines, ["a.sweep:1:37: there is no text of f.json here"]);
    file.attach(|name| Err(format!("no {name} on this day")));
    let lines = Report::new(source, models(&file).1).lines();
    assert_eq!(lines, ["a.sweep:1:37: cannot read f.json: no f.json on this day"]);
}

#[test]
fn mistakes_in_formulas() {
    let wrong = |clauses: &str| {
        let lines = read(&format!("lemma a {{ {clauses} }}"), "[]").unwrap_err();
        lines[0].split_once(": ").unwrap().1.to_owned()
    };
    let with = |options: &str| wrong(&format!("frames F(v) = {THREE}, {options});"));
    assert_eq!(with("end = loose"), "expected `natural` or `rest` or `periodic`");
    assert_eq!(with("knots = [0, 1]"), "there are 2 knots for 3 frames");
    assert_eq!(with("knots = [0, 2, 1]"), "knot 3 is not greater than the one before it");
    assert_eq!(with("end = periodic"), "the last frame is not the first one, so the motion is not closed");
    assert_eq!(with("continuity = 3"), "the order of continuity is 1 or 2");
    assert_eq!(
        with("continuity = 1, end = rest"),
        "a quadratic spline cannot close, and has one free derivative only"
    );
    assert!(with("color = red").starts_with("`frames` has no argument `color`"));
    assert_eq!(wrong("frames F(v) = (v, 0);"), "a motion is expected here, but this is a vector");
    assert_eq!(wrong(&format!("path s(v) = {THREE});")), "a motion is no curve");
    assert_eq!(wrong(&format!("let s = {THREE});")), "`frames` makes a motion");
    assert_eq!(wrong("frames F(v) = frames([1, 2]);"), "a frame is expected here, but this is a number");
    assert_eq!(
        wrong(&format!("frames F(v) = {THREE}); frames G(v) = {THREE}, knots = [0, 1, 4]);")),
        "these frames have other knots than those before them",
    );
    assert_eq!(
        wrong(&format!("frames F(v) = {THREE}); domain v in 0..1;")),
        "the frames run through [0, 2], but the domain of `v` is [0, 1]",
    );
    assert_eq!(
        wrong(&format!("frames F(v) = {THREE}); let a = F.quaternoin;")),
        "a motion has no member `quaternoin`"
    );
    assert_eq!(
        wrong(&format!("frames F(v) = {THREE}); let a = F.position(3/2);")),
        "v = 3/2 lies in another piece than the one that this clause defines",
    );
    assert_eq!(
        wrong("let s = frame((u, 0, 0), (1, 0, 0, 0)); domain u in 0..1;"),
        "the position of a frame consists of numbers, but u is none"
    );
}

#[test]
fn claims_are_about_all_pieces() {
    let judgements = judge(&format!(
        r#"lemma a {{
            frames F(v) = {THREE});
            let g(v) = F.position.x;
            claim "1": g >= 0;
            claim "2": g <= 2, expect refuted;
            claim "3": (g(0), g(1), g(2)) == (0, 1, 3);
            claim "4": F.position.y == 0;
            claim "5": F.position.y != 0;
            claim "6": not F.position.y == 0;
            claim "7": not F.position.z == 0;
            claim "8": continuity(F.sweep((1, 2, 3))) == 2;
            claim "9": continuity(v) == 9;
        }}"#
    ));
    let verdicts: Vec<String> = judgements.iter().map(|judgement| judgement.verdict.to_string()).collect();
    assert_eq!(
        verdicts,
        ["proved", "refuted", "proved", "refuted", "proved", "proved", "refuted", "proved", "proved"],
    );
    let witness = judgements[1].witness.as_deref().unwrap();
    assert!(witness.starts_with("piece 2 (v in 1..2), v = "), "{witness}");
}

#[test]
fn pieces_are_models_of_their_own() {
    let text = format!(
        "sweep a {{ profile c(u) = (u, 0, 0); frames F(v) = {THREE}); surface R = F.sweep(c); domain u in 0..1; \
         claim \"d\": degree(R) == (1, 15); }} lemma b {{ }}"
    );
    let models = read(&text, "").unwrap();
    let names: Vec<(&str, &str, usize)> =
        models.iter().map(|model| (model.name.as_str(), model.item_name(), model.claims.len())).collect();
    assert_eq!(names, [("a_1", "a", 1), ("a_2", "a", 0), ("b", "b", 0)]);
    let judgement = models[0].check(&models[0].claims[0], u64::MAX).unwrap();
    assert_eq!((judgement.sweep.as_str(), judgement.scope.as_str()), ("a", "the sweep a"));
    let lines = read(&text.replace("lemma b", "lemma a_2"), "").unwrap_err();
    assert_eq!(lines[0].split_once(": ").unwrap().1, "`a_2` is also the name of a piece of `a`");
    // Two frames make one piece, and a sweep like any other.
    let two = "sweep a { frames F(v) = frames([frame((0, 0, 0), (0, 0, 0, 1)), frame((1, 0, 0), (0, 0, 1, 0))]); \
               surface R = F.sweep((u, 0, 0)); domain u in 0..1; }";
    let models = read(two, "").unwrap();
    assert_eq!((models.len(), models[0].name.as_str(), models[0].piece.as_ref()), (1, "a", None));
    let first = "sweep a { frames F(v) = frames([frame((0, 0, 0), (0, 0, 0, 1)), frame((1, 0, 0), (0, 0, 1, 0))]); \
                 surface R(v, u) = F.sweep((u, 0, 0)); domain u in 0..1; }";
    let lines = read(first, "").unwrap_err();
    assert!(lines[0].ends_with("the frames run along `v`, which must be the second parameter"), "{lines:?}");
}

#[test]
fn symbols_take_values_in_all_pieces() {
    let judgements = judge(&format!(
        "sweep a {{ symbol r; profile c(u) = (r*u, 0, 0); frames F(v) = {THREE}, orientation = direct); surface R = F.sweep(c); \
         domain u in 0..1; claim \"d\": degree(R) == (1, 9); claim \"d\": degree(R) == (-1, 0), when r == 0, expect refuted; \
         claim \"c\": continuity(R) == 2, when r == 3; }}"
    ));
    assert_eq!(judgements[0].condition.as_deref(), Some("r > 0 and r != 0"));
    assert_eq!(judgements[1].derived, "(0, 3)");
    assert!(judgements.iter().all(|judgement| judgement.verdict == judgement.expected), "{judgements:?}");
}

#[test]
fn closed_motions_go_on_where_they_began() {
    // Half a turn about each of two axes comes back with the opposite sign.
    let frames = "frames([frame((0, 0, 0), (1, 0, 0, 0)), frame((1, 0, 0), (0, 0, 0, 1)), frame((1, 1, 0), (-1, 0, 0, 0)), \
                  frame((0, 1, 0), (0, 0, 0, -1)), frame((0, 0, 0), (1, 0, 0, 0))], end = periodic, orientation = direct)";
    let judgements = judge(&format!(
        "lemma a {{ frames F(v) = {frames}; let g(v) = F.sweep((1, 2, 3)); let d(v) = diff(g, v); let e(v) = diff(g, v, 2); \
         claim \"0\": g(0) == g(4); claim \"1\": d(0) == d(4); claim \"2\": e(0) == e(4); }}"
    ));
    assert!(judgements.iter().all(|judgement| judgement.verdict == Verdict::Proved), "{judgements:?}");
}
