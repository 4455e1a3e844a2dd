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
}

#[test]
fn conditions_that_make_no_sense_are_mistakes() {
    for (condition, message) in [
        ("0 > 1", "this condition never holds"),
        ("1 != 1", "this condition never holds"),
        ("v == 1", "a condition is about symbols, which do not depend on parameters"),
        ("a*a == b", "-"),
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
