//! Quaternions, spatial PH curves and their frames in the language: verdicts, and mistakes at their places.

use hodograph_algebra::budget::DEFAULT_LIMIT;
use hodograph_codegen::language::ast::Verdict;
use hodograph_codegen::language::{Diagnostics, Report, parse_text};
use hodograph_codegen::meaning::{Judgement, models};

/// The judgement of every claim, or the mistakes of the text and its claims, as `file:line:column: message`.
fn judge(text: &str) -> Result<Vec<Judgement>, Vec<String>> {
    let (file, source) = parse_text("t", text).map_err(|report| report.lines())?;
    let (models, mut mistakes) = models(&file);
    let (mut judgements, mut own) = (Vec::new(), Diagnostics::new());
    for model in &models {
        for claim in &model.claims {
            match model.check(claim, DEFAULT_LIMIT) {
                Ok(judgement) => judgements.push(judgement),
                Err(diagnostic) => own.push(*diagnostic),
            }
        }
    }
    if mistakes.is_empty() {
        mistakes = own;
    }
    if mistakes.is_empty() { Ok(judgements) } else { Err(Report::new(source, mistakes).lines()) }
}

#[track_caller]
fn verdicts(definitions: &str, expected: Verdict, claims: &[&str]) -> Vec<Judgement> {
    let listed: Vec<String> = claims.iter().map(|claim| format!("claim \"id\": {claim};")).collect();
    let text = format!("lemma t {{ {definitions} {} }}", listed.join("\n"));
    let judgements = judge(&text).unwrap_or_else(|mistakes| panic!("{text}: {mistakes:?}"));
    for (claim, judgement) in claims.iter().zip(&judgements) {
        assert_eq!(judgement.verdict, expected, "{claim}: {}", judgement.derived);
    }
    judgements
}

#[track_caller]
fn mistake(text: &str, expected: &str) {
    let mistakes = judge(text).expect_err(text);
    assert!(mistakes.iter().any(|line| line.starts_with(expected)), "{expected:?} is not in {mistakes:?}");
}

#[test]
fn quaternions_have_hamiltons_product() {
    let definitions =
        "symbol a, b; let p = quat(1, 2, 3, 4); let q = quat(a, b, 0, 1); let f(v) = quat(v, v^2, 0, 1);";
    verdicts(
        definitions,
        Verdict::Proved,
        &[
            "quat(0, 1, 0, 0)*j == k",
            "j*quat(0, 1, 0, 0) == -k",
            "p*q != q*p",
            "conj(p*q) == conj(q)*conj(p)",
            "norm2(p*q) == norm2(p)*norm2(q)",
            "norm2(p) == 30",
            "p*conj(p) == 30",
            "p + 1 - 2*i == quat(2, 0, 3, 4)",
            "p/2 == quat(1/2, 1, 3/2, 2)",
            "-p == quat(-1, -2, -3, -4)",
            "p.w == 1",
            "p.z == 4",
            "p.vector == (2, 3, 4)",
            "dot(p*i*conj(p), p*j*conj(p)) == 0",
            "f(2) == quat(2, 4, 0, 1)",
            "diff(f, v) == quat(1, 2*v, 0, 0)",
            "is_rational(f)",
            "parallel(p, 2*p)",
        ],
    );
    verdicts(definitions, Verdict::Refuted, &["p == q", "p == 1", "p == i", "parallel(p, q)"]);
}

#[test]
fn frames_are_decided() {
    let definitions = "symbol c; function x(u);
        curve e(v) = ph_spatial(5);
        curve s(v) = ph_spatial([1, quat(1, 2, 3, 1), quat(0, 1, 1, 2)]);
        curve t(v) = rrmf(1, quat(1, 2, 1, c), 1);
        curve p(v) = ph([1, 1 + I, 2*I]);
        curve z(v) = ph_spatial([1, quat(1, 1, 0, 2)], start = (1, 2, 3));
        domain v in 0..1;";
    verdicts(
        definitions,
        Verdict::Proved,
        &[
            "is_rational(t.rmf)",
            "is_rational(t.rmf.f)",
            "is_rational(p.rmf)",
            "p.rmf.f == -p.normal",
            "p.frenet.normal == -p.normal",
            "is_rational(s.frame)",
            "s.frame.spin == 2*(conj(s.preimage)*diff(s.preimage, v)).x/s.speed",
            "dot(diff(s.frame.f, v), s.frame.g) == s.frame.spin",
            "norm2(s.frenet.normal(1/2)) == 1",
            "s.frenet.tangent(1/2) == s.tangent(1/2)",
            "z(0) == (1, 2, 3)",
            "z.frenet.spin == dot(diff(z.frenet.normal, v), z.frenet.binormal)",
            "is_rational(s + x*t.rmf.f)",
        ],
    );
    let refuted = verdicts(
        definitions,
        Verdict::Refuted,
        &["is_rational(s.rmf)", "is_rational(s.rmf.g)", "is_rational(s.frenet)", "is_rational(e.rmf)"],
    );
    assert!(refuted[0].derived.contains("no rational rotation-minimizing frame: at the zeros of"));
    assert!(refuted[2].derived.contains("the Frenet frame is not rational: |s' x s''|^2"));
    assert_eq!(refuted[3].condition.as_deref(), Some("general values of the symbols"));
}

/// What was known of a curve when it was made is known of its frame, also where symbols or many roots occur.
#[test]
fn quintics_with_rational_frames_are_decided_for_all_data() {
    verdicts(
        "symbol a0, b0, c0, d0, a1, b1, c1, d1, c;
        path s(v) = rrmf(quat(a0, b0, c0, d0), quat(a1, b1, c1, d1), c);",
        Verdict::Proved,
        &["is_rational(s.rmf)", "s.rmf.spin == 0"],
    );
    for data in [
        "(1, 1, 0), (1, 0, 2)",
        "(3, 2, 1), (0, 1, 1)",
        "(3/2, 1/4, 0), (1/2, 1, 3/4)",
        "(1, 2, 0), (0, 1, 1), middle = 1/3 + I/2, solution = 1",
        "(3, -1, 2), (2, 5, -1)",
        "(-1, 0, 0), (0, 3, 1)",
        "(1, 2, 3), (-2, -4, -6)",
    ] {
        verdicts(
            &format!("path s(v) = rrmf_hermite((0, 0, 0), {data}); domain u in 0..1, v in 0..1;"),
            Verdict::Proved,
            &[
                "is_rational(s.rmf)",
                "s.rmf.spin == 0",
                "parallel(s.hodograph(1), s.tangent(1))",
                "is_rational(s + u*s.rmf.f)",
            ],
        );
    }
}

#[test]
fn pipes_and_canal_surfaces() {
    let judgements = judge(
        "sweep t {
            symbol r;
            path s(v) = ph_spatial([1, quat(1, 1, 1, 0)]);
            surface R = canal(s, 1/2 + v/4);
            domain u in -1..1, v in 0..1;
            claim \"radius\": norm2(R - s) == (1/2 + v/4)^2;
            claim \"envelope\": dot(R - s, s.hodograph) == -(1/2 + v/4)/4;
            claim \"pipe\": norm2(pipe(s, r) - s) == r^2;
            claim \"frame\": pipe(s, r, frame = s.frame) == pipe(s, r);
            claim \"fast\": is_rational(canal(s, 9*v)), expect refuted;
        }",
    );
    for judgement in judgements.unwrap() {
        assert_eq!(judgement.verdict, judgement.expected, "{}: {}", judgement.id, judgement.derived);
    }
}

#[test]
fn mistakes_have_their_places() {
    let table = [
        ("path s(v) = ph_spatial([1, (1, v, 2)]);", 28, "this depends on `v`, but it must be constant"),
        ("path s(v) = ph_spatial([1, I]);", 28, "a preimage's coefficient must be a quaternion"),
        ("path s(v) = ph_spatial([0, 0]);", 24, "the preimage has no nonzero coefficient"),
        ("path s(v) = ph_spatial([]);", 24, "the preimage has no nonzero coefficient"),
        ("path s(v) = ph_spatial(4);", 24, "a PH curve with a preimage has an odd degree"),
        ("path s(v) = ph_spatial(1/2);", 24, "the degree of a PH curve is an odd positive integer"),
        ("path s(v) = ph_spatial();", 13, "`ph_spatial` takes the preimage's coefficients, or a degree"),
        ("path s(v) = rrmf(0, 1, 2);", 18, "this coefficient is zero"),
        ("path s(v) = rrmf(1, 1);", 13, "`rrmf` takes 3 arguments, not 2"),
        ("path s(v) = rrmf_hermite(0*i, 0*i, j);", 31, "this tangent is zero"),
        ("path s(v) = rrmf_hermite(0*i, v*i, j);", 31, "a tangent must consist of numbers"),
        (
            "path s(v) = rrmf_hermite(0*i, i, j, middle = 1);",
            46,
            "no such quintic has this middle coefficient: |middle|^2 lies between 0.146447 and 0.853553",
        ),
        (
            "path s(v) = rrmf_hermite(0*i, i, -i, middle = 1);",
            47,
            "tangents of opposite directions leave no choice",
        ),
        ("path s(v) = rrmf_hermite(0*i, i, j, middle = i);", 46, "the middle coefficient is a number"),
        ("path s(v) = rrmf_hermite(0*i, i, j, solution = 2);", 48, "the solutions are numbered 0 and 1"),
        ("path s(v) = rrmf_hermite(0*i, i, j, turn = 2);", 37, "`rrmf_hermite` has no argument `turn`"),
        ("let a = quat(1, 2, 3);", 9, "`quat` takes 4 arguments, not 3"),
        ("let a = quat(1, 2, 3, i);", 23, "a component of a quaternion must be a scalar"),
        ("let a = 1/quat(1, 2, 3, 4);", 11, "a number cannot be divided by a quaternion"),
        ("let a = quat(1, 2, 3, 4) + I;", 28, "a quaternion and a complex number cannot be added"),
        ("let a = quat(1, 2, 3, 4).v;", 26, "a quaternion has no member `v`"),
        ("let a = ph_spatial(3);", 9, "`ph_spatial` makes a curve"),
        ("let a = pipe(i, 1);", 14, "`pipe` needs a curve, but this is a vector"),
        ("path s(v) = ph_spatial([1, i]); let a = pipe(s, v);", 49, "this radius depends on `v`"),
        ("path s(v) = ph_spatial([1, i]); let a = pipe(s, 1, frame = j);", 60, "a frame is expected here"),
        ("path s(v) = ph_spatial([1, i]); let a = s.rmf.normal;", 47, "this frame has no member `normal`"),
        (
            "path s(v) = ph_spatial([1, i]); let a = s.rmf + i;",
            49,
            "a frame of a curve and a vector cannot be added",
        ),
        ("path s(v) = (v, v^2); let a = s.rmf.f;", 31, "the parametric speed is not rational"),
        ("path s(v) = (v, v^2); let a = s.preimage;", 31, "this curve was not made from a preimage"),
        ("path s(v) = ph_spatial([1]); let a = s.frenet.f;", 38, "the curvature is zero everywhere"),
    ];
    for (text, column, expected) in table {
        mistake(&format!("lemma t {{ domain v in 0..1;\n{text} }}"), &format!("t:2:{column}: {expected}"));
    }
}

/// The squared length of `s' x s''` is a square but for a factor of symbols, so that the frame is rational in v.
#[test]
fn frenet_frames_over_symbols_are_rational() {
    let judgements = verdicts(
        "symbol c; curve s(v) = ph_spatial(3); curve t(v) = ph_spatial([1, quat(c, 1, 2, 3)]);",
        Verdict::Proved,
        &[
            "is_rational(s.frenet)",
            "is_rational(s.frenet.normal)",
            "is_rational(t.frenet)",
            "not is_rational(s.rmf)",
        ],
    );
    assert_eq!(judgements[0].scope, "a general spatial PH cubic s");
    assert_eq!(judgements[0].condition.as_deref(), Some("general values of the symbols"));
    verdicts(
        "path s(v) = rrmf(1, quat(1, 2, 1, 0), 1); symbol c; curve t(v) = ph_spatial([1, quat(c, 1, 2, 3)]);",
        Verdict::Refuted,
        &["is_rational(s.frenet)", "is_rational(s.frenet.f)", "is_rational(sqrt(1 + c^2*v^2)*t.frenet.f)"],
    );
}

/// Identities of maps are about all numbers; curves with a given hodograph are no unknown ones.
#[test]
fn verdicts_say_for_what_they_hold() {
    let scopes = |definitions: &str, claims: &[&str]| -> Vec<String> {
        let judgements = verdicts(definitions, Verdict::Proved, claims);
        judgements.into_iter().map(|judgement| judgement.scope).collect()
    };
    assert_eq!(
        scopes(
            "symbol a; let M(p, q, r, w) = (p + w, q, r); let n(p, q) = p^2 + q^2;",
            &[
                "parallel(M(p, q, r, 0), (p, q, r))",
                "n == p^2 + q^2",
                "(n - q^2) - p^2 == 0",
                "a*n == a*p^2 + a*q^2",
                "M(1, 2, 3, 4) == (5, 2, 3)",
                "degree(n, parameter = p) == 2",
            ],
        ),
        [
            "all p, q, r",
            "all p, q",
            "all p, q",
            "all a, p, q",
            "the example of the lemma t",
            "the example of the lemma t",
        ],
    );
    assert_eq!(
        scopes(
            "symbol a; function x(v), sigma(v), kappa(v);
            curve s(v) = curve_from_hodograph((1, v, v^2));
            curve t(v) = curve_from_hodograph((1, a*v, v^2));
            curve f(v) = curve_from_hodograph((1, x, v^2));
            curve r(v) = regular_curve(sigma, kappa);",
            &[
                "diff(s, v) == (1, v, v^2)",
                "dot(diff(t, v), k) == v^2",
                "diff(f, v) == f.hodograph",
                "norm2(r.tangent) == 1"
            ],
        ),
        [
            "the example of the lemma t",
            "all a",
            "all functions x and every curve f",
            "all functions sigma and every curve r"
        ],
    );
}
