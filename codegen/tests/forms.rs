//! Fundamental forms, square roots of functions, similarity offsets and Bézier patches in the language.

use hodograph_algebra::budget::DEFAULT_LIMIT;
use hodograph_codegen::language::ast::Verdict;
use hodograph_codegen::language::{Diagnostics, Report, parse_text};
use hodograph_codegen::meaning::{Judgement, models};

/// The judgements of all claims, or the mistakes.
fn judge(text: &str) -> Result<Vec<Judgement>, Vec<String>> {
    let (file, source) = parse_text("t", text).map_err(|report| report.lines())?;
    let (models, mut mistakes) = models(&file);
    let mut judgements = Vec::new();
    for model in &models {
        for claim in &model.claims {
            match model.check(claim, DEFAULT_LIMIT) {
                Ok(judgement) => judgements.push(judgement),
                Err(diagnostic) => mistakes.push(*diagnostic),
            }
        }
    }
    if mistakes.is_empty() { Ok(judgements) } else { Err(lines(source, mistakes)) }
}

fn lines(source: hodograph_codegen::language::Source, mistakes: Diagnostics) -> Vec<String> {
    Report::new(source, mistakes).lines()
}

/// A lemma on `S` over the unit square with these claims.
fn text(surface: &str, claims: &[&str]) -> String {
    let claims: Vec<String> = claims.iter().map(|claim| format!("claim \"id\": {claim};")).collect();
    let claims = claims.join("\n");
    format!("lemma t {{ symbol c; domain u in 0..1, v in 0..1; let S(u, v) = {surface};\n{claims} }}")
}

#[track_caller]
fn verdicts(surface: &str, expected: Verdict, claims: &[&str]) {
    let judgements = judge(&text(surface, claims)).unwrap_or_else(|mistakes| panic!("{mistakes:#?}"));
    for (claim, judgement) in claims.iter().zip(judgements) {
        assert_eq!(judgement.verdict, expected, "{claim}: {}", judgement.derived);
    }
}

/// The only claim is a mistake, of this message.
#[track_caller]
fn mistake(surface: &str, claim: &str, message: &str) {
    let found = judge(&text(surface, &[claim])).expect_err(claim);
    assert!(found.len() == 1 && found[0].contains(message), "{claim}: {found:#?}");
}

const SADDLE: &str = "(u, v, u*v)";
const SPHERE: &str = "(2*u, 2*v, 1 - u^2 - v^2)/(1 + u^2 + v^2)";

#[test]
fn square_roots_are_exact() {
    verdicts(
        SADDLE,
        Verdict::Proved,
        &[
            "sqrt(1 + u^2)^2 == 1 + u^2",
            "sqrt(8*(1 + u^2)) == 2*sqrt(2)*sqrt(1 + u^2)",
            "sqrt((1 + u)^2*(1 + v^2)) == (1 + u)*sqrt(1 + v^2)",
            "sqrt((u - 2)^2*(1 + v^2)) == (2 - u)*sqrt(1 + v^2)",
            "1/(u + sqrt(1 + u^2)) == sqrt(1 + u^2) - u",
            "sqrt(1 + u^2)*sqrt(1 + v^2) == sqrt((1 + u^2)*(1 + v^2))",
            "diff(sqrt(1 + u^2), u) == u/sqrt(1 + u^2)",
            "sqrt(1 + u^2) > 0",
            "not is_rational(sqrt(1 + u^2))",
            "is_rational(sqrt(1 + u^2)^4)",
            "sqrt(1 + u^2) != u",
            "sqrt(1 + u^2) - u > 0",
            "2 - sqrt(1 + u^2) > 0",
            "norm2(S.unit_normal) == 1",
            "dot(S.unit_normal, diff(S, u)) == 0",
            "S.unit_normal(1, 1) == (-1, -1, 1)/sqrt(3)",
            "S.M(1, 1) == 1/sqrt(3)",
            "-S.M + S.M == 0",
            "c*S.M == S.M*c",
        ],
    );
    verdicts(
        SADDLE,
        Verdict::Refuted,
        &["sqrt(1 + u^2) == u", "sqrt(1 + u^2) < 1/2", "is_rational(u + sqrt(1 + u^2))", "S.M == -S.M"],
    );
    verdicts(SADDLE, Verdict::Undecided, &["sqrt(1 + u^2) < 1"]);
    mistake(SADDLE, "sqrt(1 + u^2) + sqrt(1 + v^2) == 0", "another square root");
    mistake(
        SADDLE,
        "degree(sqrt(1 + u^2), parameter = u) == 1",
        "is not a rational function: u^2 + 1 is not a square",
    );
}

#[test]
fn witnesses_of_roots_are_numbers() {
    let judgements = judge(&text(SADDLE, &["S.M == 1"])).unwrap();
    let witness = judgements[0].witness.as_deref();
    assert_eq!(witness, Some("u = 1/2, v = 1/3: left 6/7, right 1"));
}

#[test]
fn curvatures_and_offsets_of_the_sphere() {
    verdicts(
        SPHERE,
        Verdict::Proved,
        &[
            "is_pn(S)",
            "S.K == 1",
            "S.H^2 == 1",
            "S.E == S.G",
            "S.F == 0",
            "S.H/S.K == S.H",
            "similarity_offset(S, S.H/S.K, c) == (1 - c)*S",
            "similarity_offset(S, 1/S.H, c) == (1 - c)*S",
            "similarity_offset(S, S.E/S.L, c) == (1 - c)*S",
            "similarity_offset(S, 2*S.H/S.K - 1/S.H, c) == (1 - c)*S",
        ],
    );
}

#[test]
fn formulas_that_are_no_similarity_functions_say_why() {
    let offset = |function: &str| format!("degree(similarity_offset(S, {function}, 1)) == (1, 1)");
    mistake(SADDLE, &offset("S.K"), "multiplies this formula by rho^-2, not by rho; it has an even number");
    mistake(SADDLE, &offset("S.E*S.L"), "multiplies this formula by rho^3, not by rho");
    mistake(SADDLE, &offset("S.L + S.E"), "by different powers of rho");
    mistake(SADDLE, &offset("u"), "is a formula in E, F, G, L, M, N, K, H, but this is a scalar function");
    mistake(SADDLE, &offset("(u, v, u + v).E/S.M"), "but this is a function with a square root");
    mistake(SADDLE, &offset("(u, v, u^2).L"), "the fundamental forms of another surface");
    mistake("(u, v, u^2)", &offset("S.H/S.K"), "it is developable");
    mistake("(u, v, u + v)", &offset("1/S.H"), "a minimal surface or a plane");
    mistake("(u, u, u)", &offset("S.L"), "R_u x R_v is zero everywhere");
}

#[test]
fn bezier_patches() {
    verdicts(
        "bezier_patch([[(0, 0, 0), (0, 1, 0), (0, 2, 0)], [(1, 0, 0), (1, 1, c), (1, 2, 0)]], weights = [[1, 1, 1], [2, 2, 2]])",
        Verdict::Proved,
        &["degree(S) == (1, 2)", "S == (2*u/(1 + u), 2*v, 4*c*u*v*(1 - v)/(1 + u))", "S(1, 1) == (1, 2, 0)"],
    );
    for (patch, message) in [
        ("bezier_patch([[(0, 0), (1, 1)], [(0, 1)]])", "another length than the first"),
        ("bezier_patch([(0, 0), (1, 1)])", "must be a list"),
        (
            "bezier_patch([[(0, 0), (1, 1)]], weights = [[1], [1]])",
            "1 by 2 control points need as many weights",
        ),
        ("bezier_patch([[(0, 0), (1, 1)]], weights = [[0, 0]])", "the weights cancel"),
        ("bezier_patch([[(0, 0), 3]])", "a control point must be a vector, but this is a number"),
        ("similarity((1, 2, 3), rotation = (0, 0, 0, 0))", "the quaternion zero is no rotation"),
        ("similarity((1, 2, 3), rotation = (1, 0, 0))", "a rotation is a quaternion of four components"),
    ] {
        let found = judge(&text(patch, &[])).expect_err(patch);
        assert!(found.len() == 1 && found[0].contains(message), "{patch}: {found:#?}");
    }
}

#[test]
fn similarities_keep_angles() {
    verdicts(
        SADDLE,
        Verdict::Proved,
        &[
            "similarity((1, 0, 0), rotation = (1, 0, 0, 1)) == j",
            "similarity(i, ratio = 2, translation = k) == 2*i + k",
            "similarity(S, ratio = 3).E == 9*S.E",
            "similarity(S, ratio = 3, rotation = (1, 2, 0, 0)).H == S.H/3",
        ],
    );
}

#[test]
fn sides_of_surfaces_with_symbols_are_conditions() {
    let claims = ["S.H == 0", "S.L == 0", "S.K == -c^2/(1 + c^2*(u^2 + v^2))^2"];
    let judgements =
        judge(&text("(c*u, v, c*u*v)", &["S.unit_normal(0, 0) == k", "S.K(0, 0) == -1"])).unwrap();
    assert_eq!(judgements[0].condition.as_deref(), Some("c > 0"));
    assert_eq!(judgements[1].condition, None);
    verdicts("(u, v, c*u*v)", Verdict::Refuted, &claims[..1]);
    verdicts("(u, v, c*u*v)", Verdict::Proved, &claims[1..]);
}
