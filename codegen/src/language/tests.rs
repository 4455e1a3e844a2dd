//! Whole sources: what they mean, and what is said about mistakes.

use proptest::prelude::*;

use super::ast::{ClauseKind, CurveRole, ItemKind, Verdict};
use super::parser::parse_single_expression;
use super::token::{Span, SpanId};
use super::*;

const EXAMPLE_2: &str = r#"
// A comment.
/// The oriented translation sweep.
sweep oriented_translation_example_2 {
    source "Farouki & Nittler 2014, eq. (17), Example 2";
    profile p(u) = (1 - u^2)/(1 + u^2) * i + 2*u/(1 + u^2) * k;
    path    s(v) = ph_hermite((0, 0), (0, 4), (2, 2), (4, 0));
    surface R = s + p.x * s.normal + p.z * k;
    domain u in 0..1, v in -1/2..1;
    claim "FN-Ex2-deg": degree(W, Z) == (2, 4), "Example 2", expect refuted;
    claim "FN-17,19": parallel(cross(diff(R, u), diff(R, v)), diff(p.x, u) * k - diff(p.z, u) * s.normal), "(19)";
    claim "FN-Ex2-offset": not is_rational(offset(R, 1/3)), when c0 > 0, when not c1 == 2;
}
lemma frames {
    symbol c0, c1;
    function x(u), z(u);
    let c = c0 + c1;
    let f(u, v) = x(u)*v;
    curve q(t) = ph([1, I, 2], factor = 1 + t, start = (0, 0));
    substitute u = v^2;
}
"#;

fn parsed(text: &str) -> File {
    parse_text("test", text).unwrap_or_else(|wrong| panic!("{wrong}")).0
}

/// All mistakes, as `line:column: message (help)`.
fn mistakes(text: &str) -> Vec<String> {
    let report = parse_text("", text).expect_err(text);
    let help = report.diagnostics().iter().map(|wrong| wrong.help.clone().unwrap_or_default());
    report.lines().iter().zip(help).map(|(line, help)| format!("{} ({help})", &line[1..])).collect()
}

/// The only mistake in a clause of an otherwise complete sweep: the text at its place, the message, and the help.
fn clause_mistake(clause: &str) -> (String, String, String) {
    let text = format!("sweep a {{ surface R = k; domain u in 0..1, v in 0..1;\n{clause}\n}}");
    let report = parse_text("", &text).expect_err(clause);
    assert_eq!(report.diagnostics().count(), 1, "{report}");
    let wrong = report.diagnostics().iter().next().unwrap_or_else(|| panic!("no mistake in {clause}"));
    let place = report.source().text()[report.source().range(wrong.span)].to_string();
    (place, wrong.message.clone(), wrong.help.clone().unwrap_or_default())
}

#[test]
fn every_clause_is_read() {
    let file = parsed(EXAMPLE_2);
    let [sweep, lemma] = file.items.as_slice() else { panic!("{file:?}") };
    assert_eq!((sweep.kind, lemma.kind), (ItemKind::Sweep, ItemKind::Lemma));
    assert_eq!(sweep.docs[0].value, " The oriented translation sweep.");
    let kinds: Vec<&ClauseKind> = sweep.clauses.iter().map(|clause| &clause.kind).collect();
    let [
        ClauseKind::Source(source),
        ClauseKind::Curve(profile),
        ClauseKind::Curve(path),
        ClauseKind::Surface(surface),
        ClauseKind::Domain(domain),
        ClauseKind::Claim(degree),
        ClauseKind::Claim(normal),
        ClauseKind::Claim(offset),
    ] = kinds.as_slice()
    else {
        panic!("{kinds:?}")
    };
    assert_eq!(source.value, "Farouki & Nittler 2014, eq. (17), Example 2");
    assert_eq!((profile.role, path.role), (CurveRole::Profile, CurveRole::Path));
    assert_eq!(profile.value.to_string(), "(1 - u^2)/(1 + u^2)*i + 2*u/(1 + u^2)*k");
    assert_eq!(surface.value.to_string(), "s + p.x*s.normal + p.z*k");
    assert_eq!(domain[1].start.to_string(), "-1/2");
    assert_eq!(degree.relation.to_string(), "degree(W, Z) == (2, 4)");
    assert_eq!(degree.expected.as_ref().map(|verdict| verdict.value), Some(Verdict::Refuted));
    assert_eq!(degree.notes[0].value, "Example 2");
    assert_eq!(normal.id.value, "FN-17,19");
    let conditions: Vec<String> = offset.conditions.iter().map(ToString::to_string).collect();
    assert_eq!(conditions, ["c0 > 0", "not c1 == 2"]);

    let kinds: Vec<&ClauseKind> = lemma.clauses.iter().map(|clause| &clause.kind).collect();
    let [
        ClauseKind::Symbol(symbols),
        ClauseKind::Function(functions),
        ClauseKind::Let(constant),
        ClauseKind::Let(field),
        ClauseKind::Curve(curve),
        ClauseKind::Substitute(substitution),
    ] = kinds.as_slice()
    else {
        panic!("{kinds:?}")
    };
    assert_eq!((symbols[0].value.as_str(), symbols[1].value.as_str()), ("c0", "c1"));
    assert_eq!((functions[1].name.value.as_str(), functions[1].parameter.value.as_str()), ("z", "u"));
    assert_eq!((constant.parameters.len(), field.parameters.len()), (0, 2));
    assert_eq!(curve.value.to_string(), "ph([1, I, 2], factor = 1 + t, start = (0, 0))");
    assert_eq!(substitution.value.to_string(), "v^2");
}

#[test]
fn a_macro_reads_the_same_as_a_text() {
    let (file, _) = parse_macro(EXAMPLE_2.parse().expect("tokens of Rust")).expect("no mistakes");
    assert_eq!(file, parsed(EXAMPLE_2));
}

#[test]
fn operators_bind_as_in_mathematics() {
    let same = |text: &str, meaning: &str| {
        let read = |text| parse_expression("test", text).unwrap_or_else(|wrong| panic!("{wrong}")).0;
        assert_eq!(read(text), read(meaning), "{text}");
    };
    same("-u^2", "-(u^2)");
    same("2^-3^2", "2^(-(3^2))");
    same("a^b^c", "a^(b^c)");
    same("-a*b", "(-a)*b");
    same("a/b*c", "a / b * c");
    same("-f(x).y^2", "-((f(x).y)^2)");
    same("not a + b == c", "not ((a + b) == c)");
    let different = |text: &str, other: &str| {
        let read = |text| parse_expression("test", text).unwrap_or_else(|wrong| panic!("{wrong}")).0;
        assert_ne!(read(text), read(other), "{text}");
    };
    different("-u^2", "(-u)^2");
    different("a - (b - c)", "a - b - c");
    different("a/(b*c)", "a/b*c");
}

#[test]
fn mistakes_in_clauses() {
    for (clause, place, message, help) in [
        ("surfce R = k;", "surfce", "there is no clause `surfce`", "did you mean `surface`?"),
        ("q = 2;", "q", "there is no clause `q`", "a definition begins with its kind, as in `let q = …`"),
        ("let c = a == b == c;", "==", "relations do not chain", "write a claim for each relation"),
        (
            "prefer speed;",
            "speed",
            "expected what is preferred, found `speed`",
            "write `prefer fast;`, which is the default, or `prefer accurate;`",
        ),
        ("let c = 2(u + 1);", "(", "a number cannot be called", "write `2*(…)` for a product"),
        ("let c = 1.5.x;", "x", "a number has no members", "write `1.5*…` for a product"),
        (
            "let c = a b;",
            "b",
            "expected `;`, found `b`",
            "a product is written with `*`, and every clause ends with `;`",
        ),
        ("let c = a ** b;", "*", "expected an expression, found `*`", "a power is written `a^b`"),
        ("let c = +a;", "+", "expected an expression, found `+`", "leave out the `+`"),
        (
            "let c = .5;",
            ".",
            "expected an expression, found `.`",
            "a decimal begins with a digit, such as 0.5",
        ),
        ("let c = (a, b;", ";", "expected `,` or `)`, found `;`", ""),
        ("let c = (a,);", "(a,)", "a vector has two or three components", "write `(a, b)` or `(a, b, c)`"),
        (
            "let c = f(n = 1, 2);",
            "2",
            "an argument without a name after named ones",
            "put the arguments without names first",
        ),
        ("let c = f(n = 1, n = 2);", "n", "`n` is given twice", ""),
        ("let f(u, u) = u;", "u", "two parameters are called `u`", ""),
        (
            "let c = a + not b;",
            "not",
            "expected an expression, found `not`",
            "`not` stands before a whole relation; put it in parentheses",
        ),
        ("let _ = a;", "_", "expected the name that is defined, found `_`", ""),
        (
            "path s = k;",
            "=",
            "expected the parameter of `s`, found `=`",
            "name it in parentheses, as in `s(u)`",
        ),
        ("path s(u, v) = k;", "(", "`s` is to have one parameter", ""),
        (
            "domain w of 0..1;",
            "of",
            "expected `in`, found `of`",
            "a domain is written `domain u in 0..1, v in 0..1;`",
        ),
        ("domain u in 0..1;", "u", "two domains of `u` are given", "leave one of them out"),
        (
            "domain w in 0..=1;",
            "=",
            "expected the end of the domain, found `=`",
            "domains are closed; write `0..1`",
        ),
        ("domain w in 0..1;", "w", "`w` is no parameter of the surface", "its parameters are `u` and `v`"),
        ("surface S = k;", "S", "two surfaces are given", "leave one of them out"),
        ("claim \"a\": b = c;", "=", "expected `;`, found `=`", "equality is written `==`"),
        (
            "claim \"a\": b \"c\";",
            "\"c\"",
            "expected `,` or `;`, found the text \"c\"",
            "the parts of a claim are separated by commas",
        ),
        (
            "claim \"a\": b, expect refutd;",
            "refutd",
            "expected `proved`, `refuted` or `undecided`, found `refutd`",
            "did you mean `refuted`?",
        ),
        (
            "claim \"a\": b, expct refuted;",
            "expct",
            "expected a note in double quotes, `expect …` or `when …`, found `expct`",
            "did you mean `expect`?",
        ),
        (
            "claim \"a\": b, effect grave \"c\";",
            "grave",
            "expected `major`, `moderate` or `minor`, found `grave`",
            "",
        ),
        (
            "claim \"a\": b, effect minor \"c\", effect major \"d\";",
            "effect major \"d\"",
            "a claim has two parts `effect`",
            "",
        ),
        (
            "claim \"a\": b, instead \"c\", instead \"d\";",
            "instead \"d\"",
            "a claim has two parts `instead`",
            "",
        ),
        (
            "claim \"a\": b, insted \"c\";",
            "insted",
            "expected a note in double quotes, `expect …` or `when …`, found `insted`",
            "did you mean `instead`?",
        ),
        ("claim \" \": b;", "\" \"", "a claim needs an id to be known by", ""),
        ("claim a: b;", "a", "expected the claim's id in double quotes, found `a`", ""),
        ("/// c", "/// c", "nothing follows that this could document", "write `//` for a comment"),
        (";", ";", "there is no clause before this `;`", "leave it out"),
        ("let c = √2;", "√", "unknown character `√`", "write `sqrt(…)`"),
    ] {
        let found = clause_mistake(clause);
        assert_eq!(
            (found.0.as_str(), found.1.as_str(), found.2.as_str()),
            (place, message, help),
            "{clause}"
        );
    }
}

#[test]
fn mistakes_in_items() {
    for (text, expected) in [
        (
            "",
            "1:1: there is neither a sweep nor a lemma here (write `sweep name { … }` or `lemma name { … }`)",
        ),
        (
            "// a\n",
            "1:5: there is neither a sweep nor a lemma here (write `sweep name { … }` or `lemma name { … }`)",
        ),
        ("swep a {}", "1:1: expected `sweep` or `lemma`, found `swep` (did you mean `sweep`?)"),
        (
            "domain u in 0..1;",
            "1:1: expected `sweep` or `lemma`, found `domain` (clauses stand in `sweep name { … }`)",
        ),
        ("lemma a {} }", "1:12: this `}` closes nothing (leave it out)"),
        ("lemma a {\nlemma b {}", "2:1: the lemma `a` is not closed (close it with `}`)"),
        ("lemma a { source \"b\";", "1:22: the lemma `a` is not closed (close it with `}`)"),
        ("lemma a {} lemma a {}", "1:18: `a` is defined twice (give each sweep and lemma a name of its own)"),
        ("lemma fn {}", "1:7: `fn` is a keyword of Rust (choose another name, such as `fn_lemma`)"),
        (
            "lemma a { surface R = k; }",
            "1:19: the lemma `a` has a surface (a surface belongs to a sweep: write `sweep` instead of `lemma`)",
        ),
        (
            "sweep hodograph { surface R = k; domain u in 0..1, v in 0..1; }",
            "1:7: no code can be generated for a sweep called `hodograph` (use another name)",
        ),
        (
            "sweep _self__ { surface R = k; domain u in 0..1, v in 0..1; }",
            "1:7: no code can be generated for a sweep called `_self__` (use another name)",
        ),
        (
            "sweep _1a { surface R = k; domain u in 0..1, v in 0..1; }",
            "1:7: no code can be generated for a sweep called `_1a` (use another name)",
        ),
        (
            "sweep a { domain u in 0..1, v in 0..1; }",
            "1:7: the sweep `a` has no surface (add its formula, `surface R = …;`, or write `lemma` for claims without a surface)",
        ),
        (
            "sweep a { surface R = k; domain u in 0..1; }",
            "1:7: the sweep `a` has no domain for `v` (add `domain v in 0..1;`)",
        ),
        (
            "sweep a { surface R(s, t) = k; }",
            "1:7: the sweep `a` has no domain for `s` and `t` (add `domain s in 0..1, t in 0..1;`)",
        ),
        (
            "sweep a { surface R(s) = k; domain s in 0..1; }",
            "1:20: a surface has two parameters (write `surface R(u, v) = …`)",
        ),
        (
            "sweep a { surface R = k domain u in 0..1, v in 0..1; }",
            "1:25: expected `;`, found `domain` (the clause before this one ends with `;`)",
        ),
        ("lemma a { let b = 1 }", "1:21: expected `;`, found `}` (every clause ends with `;`)"),
    ] {
        assert_eq!(mistakes(text), [expected], "{text}");
    }
}

#[test]
fn both_places_of_a_repetition_are_shown() {
    let report = parse_text("a.sweep", "lemma a {\n}\nlemma a {}").expect_err("a name is given twice");
    let shown = report.to_string();
    assert!(shown.contains("a.sweep:3:7") && shown.contains("a.sweep:1:7"), "{shown}");
    assert_eq!(
        report.message(),
        "a.sweep:3:7: `a` is defined twice\n  a.sweep:1:7: it is defined first here\n  help: give each sweep and lemma a name of its own"
    );
}

#[test]
fn several_mistakes_are_reported_together() {
    let text = "sweep a {\n  let b = 2u;\n  path s(u = 3;\n  profle p(v) = v;\n  let c = (1;\n}\nlemma b {\n  claim \"c\": d = e;\n  symbol ;\n}";
    let places: Vec<String> =
        mistakes(text).iter().map(|line| line.split(": ").next().unwrap_or("").to_string()).collect();
    assert_eq!(places, ["1:7", "1:7", "2:11", "3:12", "4:3", "5:13", "8:16", "9:10"]);
    let macro_error = parse_macro(text.replace('(', "( ").parse().unwrap_or_default());
    assert!(macro_error.is_err());
}

#[test]
fn nesting_has_a_limit() {
    let deep =
        |open: &str, close: &str, levels: usize| format!("{}a{}", open.repeat(levels), close.repeat(levels));
    for (open, close) in [
        ("(", ")"),
        ("f(", ")"),
        ("[", "]"),
        ("-", ""),
        ("not ", ""),
        ("a^", ""),
        ("", ".x"),
        ("", "(1)"),
        ("a^-(", ")"),
    ] {
        assert!(parse_expression("test", &deep(open, close, 100)).is_ok(), "{open} {close}");
        let report = parse_expression("test", &deep(open, close, 50_000)).expect_err(open);
        let lines = report.lines();
        assert!(
            lines.len() == 1 && lines[0].ends_with("this is nested more than 256 levels deep"),
            "{lines:?}"
        );
    }
    // The place is where the limit is passed.
    for (sign, column) in [("-", 257), ("not ", 1025)] {
        let lines = parse_expression("test", &deep(sign, "", 50_000)).expect_err(sign).lines();
        assert!(lines[0].starts_with(&format!("test:1:{column}: ")), "{lines:?}");
    }
}

#[test]
fn the_limit_on_nesting_needs_little_stack() {
    let text = format!("{}a{}", "[f(1, -2^-".repeat(50), ")]".repeat(50));
    let deepest = format!("{}a{}", "(".repeat(255), ")".repeat(255));
    let work = move || {
        for text in [text, deepest] {
            let (expr, _) = parse_expression("test", &text).expect("not too deep");
            assert_eq!(parse_expression("test", &expr.to_string()).expect("the same").0, expr.clone());
        }
    };
    let thread = std::thread::Builder::new().stack_size(3 << 19).spawn(work).expect("a thread");
    assert!(thread.join().is_ok());
}

#[test]
fn long_chains_are_flat() {
    for operator in ["+", "-", "*", "/"] {
        let text = format!("a{}", format!("{operator}1").repeat(100_000));
        let (expr, _) = parse_expression("test", &text).expect("a long chain");
        assert_eq!(expr.depth(), 2);
        assert_eq!(expr.children().count(), 100_001);
    }
}

#[test]
fn a_text_may_not_be_too_long() {
    let report = parse_text("a", &" ".repeat(MAX_LENGTH + 1)).expect_err("too long");
    assert_eq!(report.lines(), ["a:1:1: this source is 1048577 bytes long, more than the limit of 1048576"]);
    let report = parse_text("a", &"√".repeat(MAX_LENGTH / 6)).expect_err("no sweep");
    assert!(report.to_string().len() < 10_000);
    let report = parse_text("a", &"√ ".repeat(MAX_LENGTH / 6)).expect_err("no sweep");
    assert!(report.to_string().ends_with("more mistakes"));
}

/// Reads the text at both doors; nothing may panic, every mistake stands in the text, and the text is shown.
fn survives(text: &str) {
    if let Err(report) = parse_text("test", text) {
        assert!(!report.diagnostics().is_empty());
        for wrong in report.diagnostics().iter() {
            for span in [wrong.span].into_iter().chain(wrong.also.iter().map(|(span, _)| *span)) {
                let range = report.source().range(span);
                assert!(text.get(range.clone()).is_some(), "{range:?} is not in the text {text:?}");
            }
        }
        assert!(report.to_string().contains("error: "));
        assert!(report.colored().contains("error"));
    }
    let _whatever = parse_expression("test", text);
    if let Ok(stream) = text.parse::<TokenStream>() {
        let at_macro = parse_macro(stream).map(|(file, _)| file);
        if let (Ok((text_file, _)), Ok(macro_file)) = (parse_text("test", text), &at_macro) {
            assert_eq!(macro_file, &text_file);
        }
    }
}

#[test]
fn every_part_of_a_source_is_survived() {
    for (at, _) in EXAMPLE_2.char_indices() {
        survives(&EXAMPLE_2[..at]);
        survives(&EXAMPLE_2[at..]);
    }
}

fn word() -> impl Strategy<Value = String> {
    prop_oneof![
        prop::sample::select(vec![
            "sweep",
            "lemma",
            "source",
            "symbol",
            "function",
            "let",
            "profile",
            "path",
            "curve",
            "surface",
            "domain",
            "claim",
            "substitute",
            "in",
            "not",
            "expect",
            "when",
            "refuted",
            "u",
            "v",
            "_",
            "σ",
            "r#a",
        ])
        .prop_map(String::from),
        prop::sample::select(vec![
            "+", "-", "*", "/", "^", "(", ")", "[", "]", "{", "}", ",", ";", ":", ".", "..", "=", "==", "<",
            "<=", ">", ">=", "!", "√", "²", "'", "\"", "“", "\\", "/*", "*/", "//", "///", "//!", "\n", "#",
            "\u{a0}",
        ])
        .prop_map(String::from),
        prop::sample::select(vec![
            "1", "2u", "0.5", "1.", "1e-3", "0x1F", "\"a\"", "'c'", "b\"x\"", "/// d\n"
        ])
        .prop_map(String::from),
    ]
}

proptest! {
    #[test]
    fn any_bytes_are_survived(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        match decode("test", &bytes) {
            Ok(text) => survives(text),
            Err(report) => assert_eq!(report.lines().len(), 1),
        }
    }

    #[test]
    fn any_characters_are_survived(text in "\\PC{0,60}") {
        survives(&text);
    }

    #[test]
    fn any_words_are_survived(words in prop::collection::vec((word(), any::<bool>()), 0..60)) {
        let text: String = words.iter().map(|(word, space)| format!("{word}{}", if *space { " " } else { "" })).collect();
        survives(&text);
        survives(&format!("sweep a {{ {text}"));
        survives(&format!("lemma a {{ claim \"a\": {text}; }}"));
    }

    #[test]
    fn any_tokens_are_survived(kinds in prop::collection::vec(any::<prop::sample::Index>(), 0..60)) {
        let all = lex("test", "sweep a { let b = c . d ( 1 , \"e\" ) ; } /// f\n claim : in 0 .. not == [ ] ^ - * # <").0;
        let last = Span::at(SpanId(0));
        let tokens = kinds.iter().map(|index| all.at(index.index(all.kinds().len() - 1)).clone()).collect();
        let tokens = Tokens::new(tokens, last);
        let (file, wrong) = parse(&tokens);
        let has_unknown = tokens.kinds().contains(&TokenKind::Unknown);
        prop_assert!(!file.items.is_empty() || !wrong.is_empty() || has_unknown);
        let (expr, wrong) = parse_single_expression(&tokens);
        prop_assert!(expr.is_some() || !wrong.is_empty() || has_unknown);
    }
}
