//! Conditions of judgements: what a claim states, and the values of symbols at which what holds in general may fail.

use hodograph_algebra::budget::DEFAULT_LIMIT;
use hodograph_codegen::language::ast::Verdict;
use hodograph_codegen::language::parse_text;
use hodograph_codegen::meaning::{Judgement, models};

/// What becomes of the claims of a text.
fn judge(text: &str) -> Vec<Judgement> {
    let (file, _source) = parse_text("test.sweep", text).unwrap();
    let (models, mistakes) = models(&file);
    assert!(mistakes.is_empty(), "{mistakes:?}");
    let claims = |model: &hodograph_codegen::meaning::Model| -> Vec<Judgement> {
        model.claims.iter().map(|claim| model.check(claim, DEFAULT_LIMIT).unwrap()).collect()
    };
    models.iter().flat_map(claims).collect()
}

/// Checks the conditions of claims that are proved; `-` stands for none.
fn check(text: &str, conditions: &[&str]) {
    let judgements = judge(text);
    let found: Vec<&str> =
        judgements.iter().map(|judgement| judgement.condition.as_deref().unwrap_or("-")).collect();
    assert_eq!(found, conditions);
    for judgement in judgements {
        assert_eq!(judgement.verdict, Verdict::Proved, "{}: {}", judgement.statement, judgement.derived);
    }
}

#[test]
fn degrees_hold_where_leading_coefficients_do_not_vanish() {
    check(
        r#"sweep quadratic {
            symbol c0, c1, c2;
            profile p(u) = ph([1, 2 + I, 3]);
            let d(v) = c0 + c1*v + c2*v^2;
            surface R = p + d*p.normal + v*k;
            domain u in 0..1, v in 0..1;
            claim "1": degree(X) == (9, 2);
            claim "2": degree(X) == (9, 2), when c2 != 0;
            claim "3": degree(X) == (9, 2), when c2 < 0;
            claim "4": degree(X) == (9, 1), when c2 == 0;
            claim "5": degree(R) == (9, 2), when c1 == 2*c2;
            claim "6": degree(R) == (9, 2), when c1 - 2*c2 == 1;
            claim "7": degree(R) <= (9, 2);
            claim "8": degree(R) != (9, 3);
            claim "9": not degree(R) >= (9, 3);
            claim "10": degree(Z) == (4, 1);
            claim "11": degree(X, parameter = u) == 9;
        }"#,
        &[
            "c2 != 0",
            "c2 != 0",
            "c2 < 0",
            "c2 == 0 and c1 != 0",
            "c1 == 2*c2 and c1 != 0",
            "c1 - 2*c2 == 1 and c1 - 1 != 0",
            "-",
            "-",
            "-",
            "not (c0 == 0 and c1 == 0 and c2 == 0)",
            "not (c0 == 0 and c1 == 0 and c2 == 0)",
        ],
    );
}

#[test]
fn the_conditions_of_a_symbolic_curve() {
    check(
        r#"sweep cubic {
            path s(v) = ph(3);
            profile p(u) = (1 - u^2)/(1 + u^2)*i + 2*u/(1 + u^2)*k;
            surface R = s + p.x*s.normal + p.z*k;
            domain u in 0..1, v in 0..1;
            claim "1": degree(W) == (2, 2);
            claim "2": degree(X) == (2, 5);
            claim "3": degree(R) == (2, 5);
            claim "4": coprime(W, X, Y, Z);
            claim "5": parallel((W, X, Y, Z), (s.speed, s.speed*R.x, s.speed*R.y, s.speed*R.z));
        }"#,
        &[
            "a0*b1 - a1*b0 != 0",
            "a0*b1 - a1*b0 != 0 and a0 - a1 + b0 - b1 != 0 and a0 - a1 - b0 + b1 != 0",
            "a0*b1 - a1*b0 != 0",
            "a0*b1 - a1*b0 != 0",
            "-",
        ],
    );
}

#[test]
fn coprime_polynomials_and_gcds() {
    check(
        r#"lemma quadratics {
            symbol a, b, c;
            domain v in 0..1;
            let f(v) = a*v^2 + b*v + c;
            let g(v) = v^2 - 1;
            claim "1": coprime(f, g);
            claim "2": gcd(f*v, g*v) == v;
            claim "3": degree(f, g, parameter = v) == 2;
            claim "4": degree(f, parameter = v) == 2;
            claim "5": degree(f, parameter = v) == 2, when a^2 + b^2 > 0, when a != 0;
            claim "6": f + g == (a + 1)*v^2 + b*v + c - 1;
        }"#,
        &[
            "a + b + c != 0 and a - b + c != 0",
            "a + b + c != 0 and a - b + c != 0",
            "-",
            "a != 0",
            "a^2 + b^2 > 0 and a != 0",
            "-",
        ],
    );
}

#[test]
fn an_offset_over_a_root_of_the_symbols_has_a_degree() {
    let judgements = judge(
        r#"sweep linear {
            symbol c0, c1, r;
            profile p(u) = ph([1, 2 + I, 3]);
            let d(v) = c0 + c1*v;
            surface R = p + d*p.normal + v*k;
            domain u in 0..1, v in 0..1;
            claim "degree": degree(offset(R, r)) == (9, 1);
        }"#,
    );
    assert_eq!(judgements[0].verdict, Verdict::Proved);
    assert_eq!(judgements[0].derived, "(9, 1)");
    assert_eq!(judgements[0].scope, "general c0, c1, r");
    assert_eq!(judgements[0].condition.as_deref(), Some("general values of the symbols"));
}

#[test]
fn conditions_that_make_no_sense_are_mistakes() {
    for (condition, message) in [
        ("0 > 1", "this condition never holds"),
        ("1 != 1", "this condition never holds"),
        ("v == 1", "a condition is about symbols, which do not depend on parameters"),
        ("a*a == b", "-"),
        ("a > 0, when a == -1", "this condition never holds"),
        ("a > pi", "pi is not algebraic, so it can only stand in angles"),
        (
            "a*b == 1",
            "this equation cannot be solved for a symbol: none stands in it linearly, times a number",
        ),
        ("positive(a)", "a condition is an equation or an inequality of symbols"),
    ] {
        let text =
            format!("lemma l {{ symbol a, b; let f(v) = a*v; claim \"1\": f == a*v, when {condition}; }}");
        let (models, mistakes) = models(&parse_text("test.sweep", &text).unwrap().0);
        assert!(mistakes.is_empty());
        let judged = models[0].check(&models[0].claims[0], DEFAULT_LIMIT);
        let found = judged.err().map_or_else(|| "-".to_owned(), |diagnostic| diagnostic.message.clone());
        assert_eq!(found, message, "{condition}");
    }
}

/// Checks verdict, scope and condition of claims; `-` stands for no condition.
#[track_caller]
fn told(text: &str, expected: &[(Verdict, &str, &str)]) {
    let judgements = judge(text);
    assert_eq!(judgements.len(), expected.len());
    for (judgement, (verdict, scope, condition)) in judgements.iter().zip(expected) {
        let statement = &judgement.statement;
        assert_eq!(judgement.verdict, *verdict, "{statement}: {}", judgement.derived);
        assert_eq!(judgement.scope, *scope, "{statement}");
        assert_eq!(judgement.condition.as_deref().unwrap_or("-"), *condition, "{statement}");
    }
}

const GENERAL: &str = "general values of the symbols";

#[test]
fn offsets_at_the_distance_zero() {
    told(
        r#"sweep saddle {
            symbol r;
            surface R = (u, v, u*v);
            domain u in 0..1, v in 0..1;
            claim "1": is_rational(offset(R, 0));
            claim "2": is_rational(offset(R, r)), when r == 0;
            claim "3": not is_rational(offset(R, r));
            claim "4": not is_rational(offset(R, r^2 - 1)), when r > 1;
            claim "5": offset(R, 0) == R;
        }"#,
        &[
            (Verdict::Proved, "the sweep saddle", "-"),
            (Verdict::Proved, "the sweep saddle", "r == 0"),
            (Verdict::Proved, "general r", "r != 0"),
            (Verdict::Proved, "general r", "r > 1 and r + 1 != 0"),
            (Verdict::Proved, "the sweep saddle", "-"),
        ],
    );
    told(
        r#"sweep paraboloid {
            symbol c, r;
            surface R = (u, v, c*u*v);
            domain u in 0..1, v in 0..1;
            claim "1": not is_rational(offset(R, r));
        }"#,
        &[(Verdict::Proved, "general c, r", "r != 0 and general values of the symbols")],
    );
}

#[test]
fn roots_of_symbols_are_constants() {
    told(
        r#"lemma roots {
            symbol c, d, slope;
            domain u in 0..1;
            claim "1": is_rational(sqrt(1 + c^2));
            claim "2": is_rational(sqrt(c*(1 + u)^2));
            claim "3": is_rational(sqrt(c)), when c > 0;
            claim "4": is_rational(sqrt(c^2 + d^2)/2);
            claim "5": not is_rational(sqrt(1 + (slope*u)^2));
            claim "6": is_rational(sqrt(1 + u^2)), expect refuted;
            claim "7": is_rational(sqrt(c^3/(1 + u)^2));
            claim "8": is_rational(sqrt(-1 - c^2));
            claim "9": is_rational(sqrt(c)), when c < 0;
            claim "10": is_rational(sqrt(c)), when c == 4;
        }"#,
        &[
            (Verdict::Proved, "all c", "-"),
            (Verdict::Proved, "all c", "c >= 0"),
            (Verdict::Proved, "all c", "c > 0"),
            (Verdict::Undecided, "all c, d", "-"),
            (Verdict::Proved, "general slope", GENERAL),
            (Verdict::Refuted, "the example of the lemma roots", "-"),
            (Verdict::Proved, "all c", "c >= 0"),
            (Verdict::Undecided, "all c", "-"),
            (Verdict::Undecided, "all c", "c < 0"),
            (Verdict::Proved, "the example of the lemma roots", "c == 4"),
        ],
    );
}

#[test]
fn greatest_common_divisors_hold_in_general() {
    told(
        r#"lemma divisors {
            symbol a, b, c;
            function x(u), y(u);
            domain u in 0..1, v in 0..1;
            let g = gcd(v - a, v - b);
            claim "1": gcd(x, y) == 1;
            claim "2": gcd(v - a, v - b) == 1;
            claim "3": g == 1;
            claim "4": degree(g, parameter = v) == 0;
            claim "5": degree(gcd(v - a, v - b), parameter = v) <= 0;
            claim "6": coprime(v*(c*v + 1), (v + 1)*(c*v + 1)), expect refuted;
            claim "7": not coprime(c*v + 1, 2*c*v + 2);
            claim "8": coprime(c*u, 1 + u);
            claim "9": coprime(c*u, c*(1 + u));
            claim "10": gcd(v^2 - 1, v - 1)*c == c*(v - 1);
            claim "11": gcd(x*c, y*c) == c;
        }"#,
        &[
            (Verdict::Proved, "general functions x, y", "-"),
            (Verdict::Proved, "general a, b", "a - b != 0"),
            (Verdict::Proved, "general a, b", "a - b != 0"),
            (Verdict::Proved, "general a, b", "a - b != 0"),
            (Verdict::Proved, "general a, b", "a - b != 0"),
            (Verdict::Refuted, "general c", "c != 0"),
            (Verdict::Proved, "general c", "c != 0"),
            (Verdict::Proved, "general c", "c != 0"),
            (Verdict::Proved, "general c", "c != 0"),
            (Verdict::Proved, "all c", "-"),
            (Verdict::Proved, "general functions x, y and general c", GENERAL),
        ],
    );
}

#[test]
fn named_homogeneous_coordinates_have_the_conditions_of_the_surface() {
    told(
        r#"sweep parabolas {
            symbol a, b, c;
            let S = (u, v*(u - a)/(u - b), c*v^2);
            surface R = (u, v*(u - a)/(u - b), c*v^2);
            let H = homogeneous(S);
            domain u in 0..1, v in 0..1;
            claim "1": degree(H.W) == (1, 0);
            claim "2": degree(homogeneous(R).Z) == (1, 2);
            claim "3": degree(R) == (2, 2);
            claim "4": homogeneous(R) == (u - b, u*(u - b), v*(u - a), c*v^2*(u - b));
        }"#,
        &[
            (Verdict::Proved, "general a, b, c", "a - b != 0"),
            (Verdict::Proved, "general a, b, c", "c != 0 and a - b != 0"),
            (Verdict::Proved, "general a, b, c", "c != 0 and a - b != 0"),
            (Verdict::Proved, "general a, b, c", "a - b != 0"),
        ],
    );
}

#[test]
fn witnesses_satisfy_the_conditions() {
    let text = r#"lemma witnesses {
        symbol c, d;
        domain v in 0..1;
        claim "1": c == 1, when c < 0, expect refuted;
        claim "2": c*v == v, when c > 1000, when c < 1001, expect refuted;
        claim "3": c*v == d, when c < d, when d < 0, expect refuted;
        claim "4": c*v == 0, when c <= 0, when c >= 0;
        claim "5": c*v == d, when d >= 0, when d <= 0, expect refuted;
        claim "6": c*v == 0, when c < 0, when c > 0;
        claim "7": c*v != 0, when c <= 0, when c >= 0;
        claim "8": c == c, when c < 0, when c > 0;
        claim "9": c*d == v, when c^2 + d^2 < 1/100, expect refuted;
        claim "10": c*v != 0, when c < 0;
        claim "11": degree(c*v, parameter = v) == 1, when c < 0, when c > 0;
    }"#;
    let expected = [
        (Verdict::Refuted, Some("c = -1: left -1, right 1")),
        (Verdict::Refuted, Some("v = 1/2, c = 5001/5")),
        (Verdict::Refuted, Some("v = 0, c = -1, d = -4/5")),
        (Verdict::Undecided, None),
        (Verdict::Refuted, Some("v = 1/2, c = 2, d = 0")),
        (Verdict::Undecided, None),
        (Verdict::Undecided, None),
        (Verdict::Proved, None),
        (Verdict::Refuted, Some("v = 1/2, c")),
        (Verdict::Proved, None),
        (Verdict::Undecided, None),
    ];
    let judgements = judge(text);
    assert_eq!(judgements.len(), expected.len());
    for (judgement, (verdict, witness)) in judgements.iter().zip(expected) {
        let (statement, found) = (&judgement.statement, judgement.witness.as_deref());
        assert_eq!(judgement.verdict, verdict, "{statement}: {}", judgement.derived);
        assert_eq!(found.is_some(), witness.is_some(), "{statement}: {found:?}");
        let begins = found.unwrap_or("").starts_with(witness.unwrap_or(""));
        assert!(begins, "{statement}: {found:?}");
    }
}

#[test]
fn names_have_the_conditions_of_their_definitions() {
    told(
        r#"sweep saddle {
            symbol c, r;
            surface R = (u, v, u*v);
            let O = offset(R, r);
            let g = degree(c*u, c*v);
            let h = gcd(u - c, u*v);
            domain u in 0..1, v in 0..1;
            claim "1": is_rational(O), when r == 0;
            claim "2": not is_rational(O);
            claim "3": g == (1, 1);
            claim "4": degree(R) <= degree(c*u*v);
            claim "5": positive(h);
        }"#,
        &[
            (Verdict::Proved, "the sweep saddle", "r == 0"),
            (Verdict::Proved, "general r", "r != 0"),
            (Verdict::Proved, "general c", "c != 0"),
            (Verdict::Proved, "general c", "c != 0"),
            (Verdict::Proved, "general c", "c != 0"),
        ],
    );
}

#[test]
fn sides_that_depend_on_symbols_are_conditions() {
    let text = "sweep sheet {
        symbol c, r;
        surface R = u*i + c*v*j;
        domain u in 0..1, v in 0..1;
        let N = normal(R);
        claim \"side\": N == k;
        claim \"side\": offset(R, r) == (u, c*v, r);
        claim \"other\": offset(R, r) == (u, -v, -r), when c == -1;
        claim \"none\": parallel(normal(R), k);
    }";
    let (file, _source) = parse_text("sheet.sweep", text).unwrap();
    let (models, mistakes) = models(&file);
    assert!(mistakes.is_empty());
    let judged: Vec<_> =
        models[0].claims.iter().map(|claim| models[0].check(claim, DEFAULT_LIMIT).unwrap()).collect();
    assert!(judged.iter().all(|judgement| judgement.verdict == Verdict::Proved));
    let conditions: Vec<Option<&str>> =
        judged.iter().map(|judgement| judgement.condition.as_deref()).collect();
    assert_eq!(conditions[0], Some("c > 0"));
    assert!(conditions[1].is_some_and(|condition| condition.contains("c > 0")));
    assert_eq!(conditions[2], Some("c == -1"));
    assert_eq!(conditions[3], None);
}

#[test]
fn values_of_symbols_are_put_into_the_formulas() {
    // |s'| = 5|c|, so the normal turns over with c; a definition is evaluated anew, not substituted in.
    let text = "sweep line {
        symbol c;
        curve l(v) = c*v*(3, 4);
        surface R = l + u*l.normal + u^2*k;
        domain u in 0..1, v in 0..1;
        let n = degree(Z);
        let g(v) = gcd(v - c, v - 1);
        claim \"x\": R(1, 0) == (-4/5, 3/5, 1), when c == -1;
        claim \"y\": R(1, 0) == (4/5, -3/5, 1), when c == 2;
        claim \"g\": g == v - 1, when c == 1;
        claim \"n\": degree(Z) == n, when c == 3;
    }";
    let (file, _source) = parse_text("line.sweep", text).unwrap();
    let (models, mistakes) = models(&file);
    assert!(mistakes.is_empty());
    for claim in &models[0].claims {
        let judgement = models[0].check(claim, DEFAULT_LIMIT).unwrap();
        assert_eq!(judgement.verdict, Verdict::Proved, "{}: {}", judgement.statement, judgement.derived);
    }
    let symbol = hodograph_algebra::Variable::new(hodograph_algebra::Variable::SYMBOL, "c");
    let point = [(symbol.clone(), hodograph_algebra::Poly::zero())].into();
    let mistake = models[0].with_values(&point).unwrap_err();
    assert!(mistake.message.contains("point"), "{}", mistake.message);
}
