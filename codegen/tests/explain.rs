//! Derivations of verdicts: every relation says why it holds or fails.

use hodograph_algebra::budget::DEFAULT_LIMIT;
use hodograph_codegen::language::{ast::Verdict, parse_text};
use hodograph_codegen::meaning::{Explanation, models};

/// The derivations of all claims of a text.
fn explain_within(text: &str, limit: u64, full: bool) -> Vec<Explanation> {
    let (file, _source) = parse_text("example.sweep", text).unwrap_or_else(|report| panic!("{report}"));
    let (models, mistakes) = models(&file);
    assert!(mistakes.is_empty(), "{mistakes:?}");
    let claims = models.iter().flat_map(|model| model.claims.iter().map(move |claim| (model, claim)));
    claims
        .map(|(model, claim)| {
            model.explain(claim, limit, full).unwrap_or_else(|mistake| panic!("{mistake:?}"))
        })
        .collect()
}

/// The steps of the only claim of a text: what, formula and reason.
fn steps(text: &str) -> Vec<(String, String, String)> {
    let explanations = explain_within(text, DEFAULT_LIMIT, false);
    assert_eq!(explanations.len(), 1);
    let steps = explanations.into_iter().flat_map(|explanation| explanation.steps);
    steps.map(|step| (step.what.to_owned(), step.formula, step.because)).collect()
}

/// The formulas of one kind of steps.
fn of(steps: &[(String, String, String)], what: &str) -> Vec<String> {
    steps.iter().filter(|step| step.0 == what).map(|step| step.1.clone()).collect()
}

fn reasons(steps: &[(String, String, String)], what: &str) -> Vec<String> {
    steps.iter().filter(|step| step.0 == what).map(|step| step.2.clone()).collect()
}

#[test]
fn a_claim_rests_on_what_it_names_alone() {
    let steps = steps(
        "lemma l {
            symbol a, b;
            let unused = b;
            let f(v) = a*v;
            let g(v) = f^2 + 1;
            claim \"1\": diff(g, v) == 2*a^2*v;
        }",
    );
    assert_eq!(of(&steps, "definition"), ["symbol a", "let f(v) = a*v", "let g(v) = f^2 + 1"]);
    assert_eq!(of(&steps, "value"), ["g = a^2*v^2 + 1"]);
    assert_eq!(of(&steps, "left side"), ["diff(g, v) = 2*a^2*v"]);
    assert_eq!(of(&steps, "difference"), ["0"]);
}

#[test]
fn parts_are_shown_from_the_inside() {
    let steps = steps(
        "sweep s {
            surface R = (u, v, u*v);
            domain u in 0..1, v in 0..1;
            claim \"1\": dot(cross(diff(R, u), diff(R, v)), k) == 1;
        }",
    );
    assert_eq!(
        of(&steps, "value"),
        ["diff(R, u) = (1, 0, v)", "diff(R, v) = (0, 1, u)", "cross(diff(R, u), diff(R, v)) = (-v, -u, 1)"],
    );
}

#[test]
fn vectors_of_regular_curves_are_written_in_their_frame() {
    let text = "lemma l {
        function sigma(v), kappa(v), d(u);
        curve s(v) = regular_curve(sigma, kappa);
        let R(u, v) = s + d*s.normal;
        claim \"1\": diff(R, v) == sigma*s.tangent, expect refuted;
    }";
    let steps = steps(text);
    assert!(of(&steps, "value").contains(&"diff(s.normal, v) = kappa*sigma*s.tangent".to_owned()));
    assert_eq!(of(&steps, "left side"), ["diff(R, v) = sigma*(d*kappa + 1)*s.tangent"]);
    assert_eq!(of(&steps, "difference"), ["d*kappa*sigma*s.tangent"]);
    assert_eq!(
        reasons(&steps, "condition"),
        ["so that the root that is taken for the parametric speed is not negative"]
    );
}

#[test]
fn parallel_vectors_have_a_factor_and_others_a_minor() {
    let parallel = steps("lemma l { domain u in 0..1; claim \"1\": parallel((u, u^2), (1, u)); }");
    assert_eq!(of(&parallel, "factor"), ["left = (u)*right"]);
    let other =
        steps("lemma l { domain u in 0..1; claim \"1\": parallel((u, u^2), (1, 2*u)), expect refuted; }");
    assert_eq!(of(&other, "minor"), ["left.x*right.y - left.y*right.x = u^2"]);
    assert_eq!(of(&other, "witness").len(), 1);
}

#[test]
fn degrees_have_a_leading_coefficient() {
    let text = "sweep s {
        symbol c;
        surface R = (u, c*u^2*v, v);
        domain u in 0..1, v in 0..1;
        claim \"1\": degree(X, Y) == (2, 3), expect refuted;
    }";
    let steps = steps(text);
    assert_eq!(
        of(&steps, "coefficient"),
        [
            "the coefficient of u^2 in Y is c*v",
            "the coefficient of v^3 in X is 0",
            "the coefficient of v^3 in Y is 0",
            "the coefficient of v^1 in Y is c*u^2",
        ],
    );
    assert_eq!(of(&steps, "degree"), ["degree(X, Y) = (2, 1)"]);
    assert_eq!(of(&steps, "value")[0..2], ["W = 1", "X = u"]);
}

#[test]
fn signs_have_certificates_or_roots() {
    let lemma =
        |claim: &str| steps(&format!("lemma l {{ domain u in 0..1, v in 0..1; claim \"1\": {claim}; }}"));
    let certified = lemma("positive(u^2 - u + 1)");
    assert_eq!(reasons(&certified, "certificate"), ["its Bernstein coefficients 1, 1/2, 1 are all positive"]);
    let isolated = lemma("positive(4*u^2 - 4*u + 1001/1000)");
    assert!(reasons(&isolated, "certificate")[0].starts_with("no real zero in 0..1"), "{isolated:?}");
    let vanishing = lemma("positive(2*u - 1), expect refuted");
    assert_eq!(reasons(&vanishing, "root"), ["where u = 1/2"]);
    assert_eq!(of(&vanishing, "at a point"), ["2*u - 1 = -1/2"]);
    let both = lemma("u + v < 3");
    assert_eq!(
        reasons(&both, "certificate"),
        ["all Bernstein coefficients on the box are negative, the one nearest to 0 is -1"],
    );
    assert_eq!(reasons(&both, "factor"), ["a negative number"]);
    let divided = lemma("positive((u - v)^2 + u*v + 1/64)");
    assert!(reasons(&divided, "certificate")[0].contains(" boxes that cover it are positive"), "{divided:?}");
    let tangent = lemma("u*v >= 0");
    assert_eq!(reasons(&tangent, "sign"), ["zeros: u = 0; v = 0"]);
    let number = lemma("2 > 1");
    assert_eq!(of(&number, "value"), ["the difference to zero is 1"]);
}

#[test]
fn rationality_is_a_question_of_squares() {
    let plane = steps(
        "sweep s {
            surface R = (u, v, u*v);
            domain u in 0..1, v in 0..1;
            claim \"1\": not is_rational(offset(R, 1));
        }",
    );
    assert_eq!(of(&plane, "square"), ["|N|^2 = u^2 + v^2 + 1"]);
    assert_eq!(of(&plane, "negation").len(), 1);
    let root = steps("lemma l { domain v in 0..1; claim \"1\": is_rational(sqrt(4*v^2*(v + 1)^2)); }");
    assert_eq!(of(&root, "square"), ["4*v^2*(v + 1)^2 = 4*(v*(v + 1))^2"]);
    let speed =
        steps("lemma l { curve s(v) = (v, v^2); claim \"1\": is_rational(s.normal), expect refuted; }");
    assert_eq!(of(&speed, "square"), ["norm2(s.hodograph) = 4*v^2 + 1"]);
}

#[test]
fn coprime_polynomials_have_a_certificate() {
    let text = "lemma l { symbol c; domain v in 0..1; claim \"1\": coprime(v^2 + 1, v - c, v + 2); }";
    let proved = steps(text);
    let certificates = of(&proved, "certificate");
    assert_eq!(certificates.len(), 1, "{proved:?}");
    let certificate = &certificates[0];
    // The resultant that is stated, computed by the language itself.
    let (formula, at) = certificate.split_once(" at ").unwrap_or_else(|| panic!("{certificate}"));
    let (left, right) = formula.split_once(" = ").unwrap_or_else(|| panic!("{certificate}"));
    // The equation sign of the parameter's name is the first one.
    let (left, right) = match right.split_once(" = ") {
        Some((name, value)) => (format!("{left} = {name}"), value),
        None => (left.to_owned(), right),
    };
    let condition = at.replace('=', "==");
    let check = format!(
        "lemma l {{ symbol c; domain v in 0..1; claim \"1\": {left} == {right}, when {condition}; }}"
    );
    assert_eq!(explain_within(&check, DEFAULT_LIMIT, false)[0].judgement.verdict, Verdict::Proved, "{check}");
    let refuted =
        steps("lemma l { domain v in 0..1; claim \"1\": coprime(v^2 - 1, v + 1), expect refuted; }");
    assert_eq!(of(&refuted, "common factor"), ["v + 1"]);
}

#[test]
fn decimals_stand_beside_an_enclosure() {
    let steps = steps("lemma l { claim \"1\": approx(sqrt(2), 1.4142); }");
    assert_eq!(of(&steps, "number"), ["sqrt(2) = sqrt2", "1.4142135623 < sqrt(2) < 1.4142135625"]);
    assert_eq!(of(&steps, "where"), ["sqrt2 = sqrt(2) = 1.41421356…"]);
}

#[test]
fn long_formulas_are_cut_unless_all_is_asked_for() {
    let text = "lemma l { domain u in 0..1, v in 0..1; claim \"1\": (1 + u + v^3)^9*(1 + v) + u == v, expect refuted; }";
    let [short, long] = [false, true].map(|full| {
        let steps = explain_within(text, DEFAULT_LIMIT, full).remove(0).steps;
        steps.into_iter().find(|step| step.what == "left side").map(|step| step.formula).unwrap_or_default()
    });
    assert!(short.contains("… (") && short.ends_with(" monomials)"), "{short}");
    assert!(!long.contains('…') && long.len() > 4 * short.len(), "{long}");
}

#[test]
fn the_verdict_is_that_of_a_check_and_budgets_hold() {
    let text = "lemma l { symbol a; let f(v) = (a + v)^30; claim \"1\": f*f == (a + v)^60; }";
    for limit in [1, 1000, 100_000, DEFAULT_LIMIT] {
        let explanation = explain_within(text, limit, false).remove(0);
        let (file, _source) = parse_text("example.sweep", text).unwrap_or_else(|report| panic!("{report}"));
        let (models, _mistakes) = models(&file);
        let checked = models[0].check(&models[0].claims[0], limit).unwrap_or_else(|e| panic!("{e:?}"));
        assert_eq!(explanation.judgement, checked, "{limit}");
        assert_eq!(explanation.steps.last().map(|step| step.what), Some("verdict"), "{limit}");
    }
}

/// Rotation-minimizing frames: what the Euler-Rodrigues frame turns, and what turns it back, or why nothing does.
#[test]
fn frames_are_explained_by_their_rotation() {
    let found = steps(
        "lemma l {
            path s(v) = ph_spatial([quat(-2, 0, 0, 1), quat(-2, 1/2, -3/2, 1), quat(-1, 1, -3, 1)]);
            claim \"1\": is_rational(s.rmf);
        }",
    );
    assert_eq!(of(&found, "preimage"), ["s.frame.preimage = A = (v^2 - 2, v, -3*v, 1)"]);
    assert_eq!(
        of(&found, "spin"),
        ["h = -s.frame.spin/2 = 1/(v^2 + 1)", "dot(diff(s.rmf.f, v), s.rmf.g) = 0"]
    );
    assert_eq!(of(&found, "rotation"), ["W = 1 + v*I"]);
    assert_eq!(
        reasons(&found, "rotation"),
        ["Im(conj(W)*W')/|W|^2 - h = 0, identically: |W|^2 is the denominator of h"]
    );
    let none = steps(
        "lemma l {
            path s(v) = ph_spatial([1, quat(1, 2, 1, 0)]);
            claim \"1\": is_rational(s.rmf.g), expect refuted;
        }",
    );
    assert_eq!(of(&none, "residues"), ["residue^2 = r with 5*r - 4 = 0, at the zeros of 5*v^2 + 1"]);
    let general = steps("lemma l { path s(v) = ph_spatial(5); claim \"1\": not is_rational(s.rmf); }");
    assert!(reasons(&general, "residues")[0].contains("there is no W (for a0 = "));
}

#[test]
fn frenet_frames_are_explained_without_the_speed() {
    let refuted = steps(
        "lemma l { path s(v) = rrmf(2, quat(1, 2, 1, 0), 2); claim \"1\": not is_rational(s.frenet); }",
    );
    assert_eq!(
        of(&refuted, "square"),
        [
            "norm2(cross(s.hodograph, diff(s.hodograph, v)))/s.speed^2 = 32*(17*v^4 - 26*v^3 + 16*v^2 - 4*v + 2)"
        ]
    );
    let symbolic = steps("lemma l { path s(v) = ph_spatial(3); claim \"1\": is_rational(s.frenet.normal); }");
    assert!(reasons(&symbolic, "square")[0].starts_with("the last factor depends on the symbols alone"));
    let without =
        steps("lemma l { path s(v) = (v, v^2, v^3); claim \"1\": is_rational(s.rmf), expect refuted; }");
    assert_eq!(of(&without, "square"), ["norm2(s.hodograph) = 9*v^4 + 4*v^2 + 1"]);
}

#[test]
fn joints_have_their_orders_and_jumps() {
    let joints = |relation: &str| {
        steps(&format!(
            "sweep t {{
                profile c(u) = (u, 0, 0);
                frames F(v) = frames([frame((0, 0, 0), (1, 0, 0, 0)), frame((0, 0, 1), (1, 0, 0, 0)), frame((0, 1, 2), (1, 0, 0, 0))]);
                surface R = F.sweep(c);
                domain u in 0..1;
                claim \"1\": {relation};
            }}"
        ))
    };
    let spline = joints("continuity(R) == 2");
    assert_eq!(of(&spline, "joint"), ["diff(R, v, 3) jumps by (0, -3, 0) at v = 1"]);
    assert_eq!(reasons(&spline, "joint"), ["the derivatives from both sides are equal up to order 2"]);
    let smooth = joints("continuity(R.z) == 9");
    assert_eq!(of(&smooth, "joint"), ["diff(R.z, v, 9) does not jump at v = 1"]);
}
