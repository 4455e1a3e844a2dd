//! What the sweep language means: values of its functions and members, verdicts, witnesses, and mistakes at their places.

use hodograph_algebra::budget;
use hodograph_codegen::language::ast::Verdict;
use hodograph_codegen::language::{Diagnostics, Report, parse_text};
use hodograph_codegen::meaning::{Judgement, MAX_EXPONENT, Model, models};

/// The budget of one claim.
const BUDGET: u64 = budget::DEFAULT_LIMIT;

/// More units of work than any of these texts may take: a few budgets, as each clause has its own.
const TOO_MUCH: u64 = 3 * BUDGET;

fn read(text: &str) -> Result<Vec<Model>, Vec<String>> {
    let (file, source) = parse_text("t", text).map_err(|report| report.lines())?;
    let (models, diagnostics) = models(&file);
    if diagnostics.is_empty() { Ok(models) } else { Err(Report::new(source, diagnostics).lines()) }
}

/// The judgement of every claim, or the mistakes of the text and its claims, as `file:line:column: message`.
fn judge(text: &str) -> Result<Vec<Judgement>, Vec<String>> {
    let (result, units) = budget::measured(|| judge_at_leisure(text));
    assert!(units < TOO_MUCH, "{text} takes {units} units");
    result
}

fn judge_at_leisure(text: &str) -> Result<Vec<Judgement>, Vec<String>> {
    let (_, source) = parse_text("t", text).map_err(|report| report.lines())?;
    let (mut judgements, mut mistakes) = (Vec::new(), Diagnostics::new());
    for model in read(text)? {
        for claim in &model.claims {
            match model.check(claim, BUDGET) {
                Ok(judgement) => judgements.push(judgement),
                Err(diagnostic) => mistakes.push(*diagnostic),
            }
        }
    }
    if mistakes.is_empty() { Ok(judgements) } else { Err(Report::new(source, mistakes).lines()) }
}

fn lemma(definitions: &str, claims: &[&str]) -> Vec<Judgement> {
    let claims: Vec<String> = claims.iter().map(|claim| format!("claim \"id\": {claim};")).collect();
    let text = format!("lemma t {{ {definitions} {} }}", claims.join("\n"));
    judge(&text).unwrap_or_else(|mistakes| panic!("{text}: {mistakes:?}"))
}

/// All claims hold.
#[track_caller]
fn proved(definitions: &str, claims: &[&str]) {
    for (claim, judgement) in claims.iter().zip(lemma(definitions, claims)) {
        assert_eq!(judgement.verdict, Verdict::Proved, "{claim}: {}", judgement.derived);
    }
}

/// Both sides are equal; unless both are zero, the left side is not the double of the right side.
#[track_caller]
fn equal(definitions: &str, equations: &[(&str, &str)]) {
    for (left, right) in equations {
        let claims = [&*format!("{left} == {right}"), &*format!("{left} == 2*({right})")];
        let judgements = lemma(definitions, &claims);
        assert_eq!(
            judgements[0].verdict,
            Verdict::Proved,
            "{left} is not {right}: {}",
            judgements[0].derived
        );
        let zero = ["are 0", "are (0, 0, 0)"].iter().any(|zero| judgements[0].derived.ends_with(zero));
        assert!(zero || judgements[1].verdict == Verdict::Refuted, "{left} equals everything");
    }
}

/// The mistakes of a text, each with its place and the beginning of its message.
#[track_caller]
fn mistakes(text: &str, expected: &[&str]) {
    let found = judge(text).expect_err(text);
    let agree = |(found, expected): (&String, &&str)| found.starts_with(expected);
    assert!(found.len() == expected.len() && found.iter().zip(expected).all(agree), "{text}\n{found:#?}");
}

#[track_caller]
fn mistake(text: &str, expected: &str) {
    mistakes(text, &[expected]);
}

/// `w = 1 + I v`, so `x = v − v³/3`, `y = v²` and `σ = 1 + v²`.
const PH_CUBIC: &str = "path s(v) = ph([1, 1 + I]); domain v in 0..1;";

#[test]
fn members_of_a_ph_cubic() {
    equal(
        PH_CUBIC,
        &[
            ("s", "(v - v^3/3, v^2)"),
            ("s.x", "v - v^3/3"),
            ("s.y", "v^2"),
            ("s.z", "0"),
            ("s.hodograph", "(1 - v^2, 2*v)"),
            ("s.speed", "1 + v^2"),
            ("s.tangent", "(1 - v^2, 2*v)/(1 + v^2)"),
            ("s.normal", "(2*v, v^2 - 1)/(1 + v^2)"),
            ("s.curvature", "2/(1 + v^2)^2"),
            ("s.arclength", "v + v^3/3"),
            ("s.length", "4/3"),
            ("s.involute", "(v - v^3/3, v^2) - (v + v^3/3)/(1 + v^2)*(1 - v^2, 2*v)"),
            ("s.evolute", "(-4*v^3/3, (1 + 2*v^2 - v^4)/2)"),
            ("s.offset(3)", "(v - v^3/3, v^2) + 3/(1 + v^2)*(2*v, v^2 - 1)"),
            ("offset(s, 3)", "s.offset(3)"),
            ("s(1)", "(2/3, 1)"),
            ("s.normal(1)", "i"),
            ("s.curvature(1)", "1/2"),
            ("diff(s, v)(1)", "(0, 2)"),
            ("diff(s, v, 2)", "(-2*v, 2)"),
        ],
    );
}

#[test]
fn arc_length_begins_where_the_domain_does() {
    let definitions = "path s(v) = ph([1, 1 + I]); domain v in 1..2;";
    equal(definitions, &[("s.arclength", "v + v^3/3 - 4/3"), ("s.length", "10/3"), ("s.arclength(1)", "0")]);
}

#[test]
fn curves_in_other_coordinate_planes() {
    let cosine = "(1 - t^2)/(1 + t^2)";
    let definitions = format!(
        "curve a(t) = {cosine}*i + 2*t/(1 + t^2)*k; curve b(t) = {cosine}*j + 2*t/(1 + t^2)*k;
         curve c(t) = ({cosine}, 2*t/(1 + t^2)); domain t in 0..1;"
    );
    equal(
        &definitions,
        &[
            ("a.speed", "2/(1 + t^2)"),
            ("a.normal", "cross(a.tangent, j)"),
            ("a.normal", "-a"),
            ("b.normal", "cross(b.tangent, i)"),
            ("b.normal", "b"),
            ("c.normal", "cross(c.tangent, k)"),
            ("c.normal", "c"),
            ("c.curvature", "1"),
            ("c.evolute", "(0, 0, 0)"),
        ],
    );
}

#[test]
fn functions_of_numbers() {
    equal(
        "",
        &[
            ("sqrt(8)", "2*sqrt(2)"),
            ("sqrt(3 + 2*sqrt(2))", "1 + sqrt(2)"),
            ("cos(pi/4)", "sqrt(2)/2"),
            ("sin(pi/6)", "1/2"),
            ("cos(pi/5)", "(1 + sqrt(5))/4"),
            ("exp(I*pi/4)", "(1 + I)/sqrt(2)"),
            ("exp(I*pi)", "-1"),
            ("exp(I*pi/8)^8", "-1"),
            ("(1 + 2*I)*(3 - I)", "5 + 5*I"),
            ("(1 + 2*I)/(3 - I)", "(1 + 7*I)/10"),
            ("conj(1 + 2*I)", "1 - 2*I"),
            ("re(1 + 2*I)", "1"),
            ("im(1 + 2*I)", "2"),
            ("norm2(1 + 2*I)", "5"),
            ("norm2((1, 2, 3))", "14"),
            ("abs(1 - sqrt(2))", "sqrt(2) - 1"),
            ("dot((1, 2), (3, 4, 5))", "11"),
            ("cross(i, j)", "k"),
            ("cross((1, 2), (3, 4))", "-2*k"),
            ("0.125", "1/8"),
            ("1.5e-3", "3/2000"),
            ("-2^2", "-4"),
            ("2^-3", "1/8"),
            ("2^3^2", "512"),
            ("I^2", "-1"),
            ("(1 + I)^-2", "-I/2"),
        ],
    );
}

#[test]
fn functions_of_polynomials() {
    let definitions = "let f(u, v) = u^2*v + u; let c(u) = u^3; domain u in 0..1, v in 0..1; symbol a;";
    equal(
        definitions,
        &[
            ("diff(f, u)", "2*u*v + 1"),
            ("diff(f, u, 2)", "2*v"),
            ("diff(f, u, 0)", "f"),
            ("diff(u/v, v)", "-u/v^2"),
            ("diff((u^2, v), u)", "(2*u, 0)"),
            ("diff((u + I*v)^2, u)", "2*(u + I*v)"),
            ("f(2, 3)", "14"),
            ("f(v, u)", "v^2*u + v"),
            ("c(1 + v)", "(1 + v)^3"),
            ("f(c, v)", "u^6*v + u^3"),
            ("gcd(u^2 - 1, u^2 + 2*u + 1)", "u + 1"),
            ("gcd(a*u, a*v)", "a"),
            ("resultant(u^2 - a, u*v - 1, parameter = u)", "1 - a*v^2"),
            ("resultant(u^2 + 1, u^2 + v^2, parameter = u)", "(v^2 - 1)^2"),
            ("resultant(u^2 + 1, (u^2 + 1)*v, parameter = u)", "0"),
            ("sqrt(4*(1 + u)^2)", "2 + 2*u"),
            ("sqrt((u - 2)^2)", "2 - u"),
            ("sqrt((a^2 - a + 1)^2*(u - 2)^2)", "(a^2 - a + 1)*(2 - u)"),
            ("sqrt(2*(u + v)^2/(1 + v)^4)", "sqrt(2)*(u + v)/(1 + v)^2"),
            ("(u^2 - 1)/(u - 1)", "u + 1"),
        ],
    );
    let claims = [
        "degree(f) == (2, 1)",
        "degree(f, c) == (3, 1)",
        "degree(f) <= (2, 2)",
        "not degree(f) <= (1, 2)",
        "degree(f) >= (2, 1)",
        "degree(u - u) == (-1, -1)",
        "degree(f, parameter = u) == 2",
        "degree(a*u, parameter = v) == 0",
        "degree((u/v, v, 1)) == (1, 2)",
        "homogeneous((u/v, v, 1)).W == v",
        "parallel(homogeneous((u/v, v, 1)), (v, u, v^2, v))",
        "degree(homogeneous((u/v, v, 1)).Y) == (0, 2)",
    ];
    proved(definitions, &claims);
}

#[test]
fn constructors_of_curves() {
    let definitions = "
        path a(v) = bezier([(0, 0), (1, 2), (3, 0)]);
        path b(v) = bezier([(1, 0), (1, 1), (0, 1)], weights = [1, 1, 2]);
        path c(v) = ph([1, I], start = (5, 6), factor = 2*v);
        path h(v) = ph_hermite((0, 0), (1, 0), (1, 0), (1, 0));
        domain v in 0..1;";
    equal(
        definitions,
        &[
            ("a", "(2*(1 - v)*v + 3*v^2, 4*(1 - v)*v)"),
            ("b", "(1 - v^2, 2*v)/(1 + v^2)"),
            ("c(0)", "(5, 6)"),
            // w = 1 − v + I v, so w² = 1 − 2v + 2I v(1 − v).
            ("c.hodograph", "2*v*(1 - 2*v, 2*v*(1 - v))"),
            ("c.speed", "2*v*(1 - 2*v + 2*v^2)"),
            ("h", "(v, 0)"),
        ],
    );
    let symbolic = "path p(v) = polynomial_curve(2); path q(v) = rational_curve(1); path r(v) = ph(3);";
    equal(
        symbolic,
        &[
            ("p", "(p_x0 + p_x1*v + p_x2*v^2, p_y0 + p_y1*v + p_y2*v^2)"),
            ("q", "(q_x0 + q_x1*v, q_y0 + q_y1*v)/(q_w0 + q_w1*v)"),
            ("r.speed(0)", "r_a0^2 + r_b0^2"),
            ("r.hodograph(1)", "(r_a1^2 - r_b1^2, 2*r_a1*r_b1)"),
        ],
    );
    equal("path r(v) = ph(3);", &[("r.speed(0)", "a0^2 + b0^2")]);
    equal(
        "function sigma(v), kappa(v); curve s(v) = regular_curve(sigma, kappa);",
        &[("s.speed", "sigma"), ("s.curvature", "kappa"), ("diff(s.arclength, v)", "sigma")],
    );
    equal(
        "function a(v), b(v); curve s(v) = curve_from_hodograph((a^2 - b^2, 2*a*b));",
        &[
            ("s.speed", "a^2 + b^2"),
            ("diff(s, v)", "(a^2 - b^2, 2*a*b)"),
            ("diff(s.arclength, v)", "a^2 + b^2"),
        ],
    );
}

#[test]
fn the_solutions_of_hermite_data_interpolate_them() {
    for solution in 0..4 {
        let definitions =
            format!("path s(v) = ph_hermite((0, 0), (0, 4), (2, 2), (4, 0), solution = {solution});");
        let equations = [
            ("s(0)", "(0, 0)"),
            ("s.hodograph(0)", "(0, 4)"),
            ("s(1)", "(2, 2)"),
            ("s.hodograph(1)", "(4, 0)"),
        ];
        equal(&definitions, &equations);
    }
}

#[test]
fn members_of_a_sphere() {
    let claims = [
        "parallel((W, X, Y, Z), ((1 + u^2)*(1 + v^2), (1 - u^2)*(1 - v^2), (1 - u^2)*2*v, 2*u*(1 + v^2)))",
        "R.W == W",
        "R.x == X/W",
        "norm2(R) == 1",
        "degree(R) == (2, 2)",
        "degree(Z) == (1, 2)",
        "parallel(normal(R), R)",
        "is_rational(offset(R, r))",
        // R_u x R_v points inwards.
        "offset(R, r) == (1 - r)*R",
        "offset(R, 1/2).z == R.z/2",
        "R(0, 0) == i",
        "degree(offset(R, r)) == (2, 2)",
    ];
    let claims: String = claims.iter().map(|claim| format!("claim \"id\": {claim};\n")).collect();
    let text = format!(
        "sweep t {{
            symbol r;
            profile p(u) = (1 - u^2)/(1 + u^2)*i + 2*u/(1 + u^2)*k;
            path s(v) = ((1 - v^2)/(1 + v^2), 2*v/(1 + v^2));
            surface R = p.x*s + p.z*k;
            domain u in 0..1/2, v in 0..1;
            {claims}
        }}"
    );
    for judgement in judge(&text).unwrap() {
        assert_eq!(judgement.verdict, Verdict::Proved, "{}: {}", judgement.statement, judgement.derived);
    }
}

#[test]
fn verdicts() {
    use Verdict::{Proved, Refuted, Undecided};
    let definitions =
        "let f(u, v) = u*v; symbol c; function g(u); path q(v) = (v, v^2); domain u in 0..1, v in 0..1;";
    let table = [
        ("1 == 1", Proved),
        ("not 1 == 1", Refuted),
        ("not not 1 == 1", Proved),
        ("u == v", Refuted),
        ("not u == v", Proved),
        ("c == 0", Refuted),
        ("g == 0", Refuted),
        ("(1, 2) == (1, 2, 0)", Proved),
        ("1 <= 1", Proved),
        ("1 < 1", Refuted),
        ("1 > 1", Refuted),
        ("sqrt(2) < 1.41421357", Proved),
        ("sqrt(2) > 1.41421356", Proved),
        ("f <= 1", Proved),
        ("f < 1", Refuted),
        ("f >= 0", Proved),
        ("f > 0", Refuted),
        ("positive(f)", Refuted),
        ("positive(1 + f)", Proved),
        ("positive(-1 - f)", Refuted),
        ("(u - v)^2 >= 0", Proved),
        ("(u - v)^2 > 0", Refuted),
        ("u <= v", Refuted),
        ("not u <= v", Proved),
        ("positive(1/(1 + u))", Proved),
        ("positive(1/(u - 2))", Refuted),
        ("1/(u - 2)^2 > 0", Proved),
        ("positive(1/u)", Undecided),
        ("not positive(1/u)", Undecided),
        ("positive(c)", Undecided),
        ("f <= c", Undecided),
        ("parallel((1, 2), (2, 4))", Proved),
        ("parallel((1, 2), (-2, -4))", Proved),
        ("parallel((1, 2), (2, 5))", Refuted),
        ("parallel((0, 0), (1, 2))", Refuted),
        ("parallel((1, 2), u*(0, 0))", Refuted),
        ("parallel((u, v, 1), (u*v, v^2, v))", Proved),
        ("parallel((1, u, 0, 0), (1, v, 0, 0))", Refuted),
        ("coprime(u^2 - 1, u + 2)", Proved),
        ("coprime(u^2 - 1, v, u + 1)", Proved),
        ("coprime(u^2 - 1, u + 1)", Refuted),
        ("is_rational(q)", Proved),
        ("is_rational(q.speed)", Refuted),
        ("is_rational(q.offset(1))", Refuted),
        ("not is_rational(q.normal)", Proved),
        ("is_rational(sqrt(1 + u^2))", Refuted),
        ("is_rational(sqrt(1 + 2*u + u^2))", Proved),
        ("approx(sqrt(2), 1.4142)", Proved),
        ("approx(sqrt(2), 1.41422)", Refuted),
        ("approx(-sqrt(2), -1.4142)", Proved),
        // Half a unit of the last digit is rounded to either side.
        ("approx(2.5, 2)", Proved),
        ("approx(2.5, 3)", Proved),
        ("approx(2.51, 2)", Refuted),
        ("approx(12345, 1.2e4)", Proved),
        ("approx(12545, 1.2e4)", Refuted),
    ];
    let claims = table.map(|(claim, _)| claim);
    for ((claim, expected), judgement) in table.iter().zip(lemma(definitions, &claims)) {
        assert_eq!(judgement.verdict, *expected, "{claim}: {}", judgement.derived);
    }
}

#[test]
fn conditions_set_symbols() {
    let claims = ["s.speed(1) == 4, when c == 2", "s.speed(1) == 4"];
    let judgements = lemma("symbol c; path s(v) = ph([1, c*I]);", &claims);
    assert_eq!(judgements[0].verdict, Verdict::Proved);
    assert_eq!(judgements[0].condition.as_deref(), Some("c == 2"));
    assert_eq!(judgements[1].verdict, Verdict::Refuted);
    assert_eq!(judgements[1].derived, "the left side is c^2");
    // Also in the rules for derivatives, and the arc length stays the same symbol.
    let claims = [
        "s.speed == 1, when c == 1",
        "diff(s, v) == s.tangent, when c == 1",
        "diff(length, v) == 1, when c == 1",
        "s.arclength == length, when c == 1",
        "s.curvature == kappa, when c == 1",
    ];
    let definitions =
        "symbol c; function kappa(v); curve s(v) = regular_curve(c, kappa); let length = s.arclength;";
    proved(definitions, &claims);
}

#[test]
fn a_finding_says_for_what_it_holds() {
    let definitions = "symbol c; function x(u), kappa(v); curve s(v) = regular_curve(1, kappa);";
    let table = [
        ("c - c == 0*x", "all functions x and all c"),
        ("(c + x)^2 == c^2 + 2*c*x + x^2", "all functions x and all c"),
        ("norm2(s.tangent) == 1", "every curve s"),
        ("coprime(c*u, 1 + u)", "general c"),
        ("degree(c*u*v) == (1, 1)", "general c"),
        ("degree(c*u*v) <= (1, 1)", "all c"),
        ("not diff(x, u) == x", "general functions x"),
        ("u*v == v*u", "the example of the lemma t"),
    ];
    let claims = table.map(|(claim, _)| claim);
    for ((claim, expected), judgement) in table.iter().zip(lemma(definitions, &claims)) {
        assert_eq!(judgement.verdict, Verdict::Proved, "{claim}");
        assert_eq!(judgement.scope, *expected, "{claim}");
    }
}

/// The witness of a refuted equation or inequality is put into the formulas again.
#[test]
fn witnesses_refute() {
    let sides = [
        ("u^2*v", "==", "u*v"),
        ("u/(1 + v)", "==", "u"),
        ("(u, v)", "==", "(v, u)"),
        ("(1 - u)*u", "==", "0"),
        ("sqrt(2)*u", "==", "u*v"),
        ("(u - 1/2)^2", ">", "0"),
        ("u - v", ">=", "0"),
        ("u*v", "<", "1"),
        ("1/(1 + u) - 9/10*v", ">", "0"),
        ("(u - 1/3)*(u - 1/5)", ">=", "0"),
    ];
    for (left, operator, right) in sides {
        let definitions =
            format!("let f(u, v) = {left}; let g(u, v) = {right}; domain u in 0..1, v in 0..1;");
        let judgement = lemma(&definitions, &[&format!("{left} {operator} {right}")]).remove(0);
        assert_eq!(judgement.verdict, Verdict::Refuted, "{left} {operator} {right}");
        let witness = judgement.witness.expect("a refuted relation has a witness");
        let (point, values) = witness.split_once(": left ").unwrap_or((&witness, ""));
        let mut place = ["1/2", "1/2"];
        for equation in point.split(", ") {
            let (parameter, value) = equation.split_once(" = ").expect("a witness is a list of equations");
            place[usize::from(parameter == "v")] = value;
        }
        let at = place.join(", ");
        let mut claims = vec![format!("not f({at}) {operator} g({at})")];
        if let Some((l, r)) = values.split_once(", right ") {
            let number = |text: &str| text.replace("sqrt2", "sqrt(2)");
            claims.extend([format!("f({at}) == {}", number(l)), format!("g({at}) == {}", number(r))]);
        }
        let claims: Vec<&str> = claims.iter().map(String::as_str).collect();
        proved(&definitions, &claims);
    }
}

#[test]
fn type_mistakes_are_told_in_terms_of_geometry() {
    let with = |claim: &str| format!("lemma t {{\n  {PH_CUBIC} symbol c;\n  claim \"id\": {claim};\n}}");
    let table = [
        ("s + 1 == s", "t:3:19: a curve and a number cannot be added"),
        ("s*s == 1", "t:3:17: a curve and a curve cannot be multiplied with `*`"),
        ("1/s == 1", "t:3:17: a number cannot be divided by a curve"),
        ("i^2 == 1", "t:3:15: a vector cannot be raised to a power"),
        ("1 == (1, 2)", "t:3:15: a number is compared with a vector"),
        ("(1, 2) < (3, 4)", "t:3:15: an inequality compares scalars, but this is a vector"),
        ("s.z.x == 1", "t:3:19: a number has no members"),
        ("s.tangent.speed == 1", "t:3:25: a vector has no member `speed`"),
        ("((1, 2), 3) == 1", "t:3:16: a component must be a scalar, but this is a vector"),
        ("dot(c, s) == 1", "t:3:19: `dot` needs a vector here, but this is a scalar function"),
        ("re(s) == 1", "t:3:18: `re` needs a complex number, but this is a curve"),
        ("normal(s) == 1", "t:3:22: `normal` needs the surface, but this is a curve"),
        ("offset(1, 2) == 1", "t:3:22: `offset` needs a surface or a curve, but this is a number"),
        ("s(1, 2) == 1", "t:3:15: this depends on v, so it takes one value"),
        ("c(1) == 1", "t:3:15: a scalar function cannot be called"),
        ("s.offset == 1", "t:3:15: `offset` needs the distance"),
        ("diff(s, 2) == 1", "t:3:23: a parameter is expected here"),
        ("diff(s, c) == 1", "t:3:23: `c` is not a parameter"),
        ("diff(s, v, -1) == 1", "t:3:26: the order of a derivative is an integer from 0 to 100"),
        ("cross(i) == 1", "t:3:15: `cross` takes 2 arguments, not 1"),
        ("dot(i, j, by = 2) == 1", "t:3:25: `dot` has no argument `by`"),
        ("s", "t:3:15: this is a value, not a relation"),
        ("coprime(c)", "t:3:15: `coprime` takes two polynomials at least"),
        ("coprime(1/v, c)", "t:3:23: this must be a polynomial, but it has the denominator v"),
        ("approx(1, c)", "t:3:25: a decimal number is expected here"),
        ("approx(c, 1)", "t:3:22: what is approximated must be a number, but this depends on `c`"),
        ("parallel(1, i)", "t:3:24: `parallel` compares vectors, but this is a number"),
        ("parallel((1, 2, 3, 4), i)", "t:3:24: 4 components are compared with 3"),
        ("degree(c, parameter = v) == (1, 1)", "t:3:43: a degree is compared with an integer"),
        ("degree(c) == (1, 1)", "t:3:15: a bidegree needs two parameters"),
        ("resultant(v, c) == 1", "t:3:15: `resultant` takes two polynomials and the parameter to eliminate"),
        ("resultant(v, c, parameter = c) == 1", "t:3:43: `c` is not a parameter"),
        (
            "resultant(1/v, c, parameter = v) == 1",
            "t:3:25: this must be a polynomial, but it has the denominator v",
        ),
        ("homogeneous(s).Q == 1", "t:3:30: a list of homogeneous coordinates has no member `Q`"),
        ("1 + positive(c) == 1", "t:3:19: `positive` is a relation and has no value"),
        ("dot == 1", "t:3:15: `dot` is a function and needs arguments"),
        ("ph(3) == 1", "t:3:15: `ph` makes a curve"),
        ("1 == 1, when v == 2", "t:3:28: a condition is about symbols, which do not depend on parameters"),
        ("1 == 1, when c*c == 2", "t:3:28: this equation cannot be solved for a symbol"),
        ("sqrt(c^2) == c", "t:3:20: this square root is the absolute value of c"),
        ("positive(w - 1)", "t:3:24: `w` is not defined"),
    ];
    for (claim, expected) in table {
        mistake(&with(claim), expected);
    }
}

/// The report of a text's mistakes, as a person reads it.
fn report(text: &str) -> String {
    let (file, source) = parse_text("t", text).expect("the syntax is right");
    Report::new(source, models(&file).1).to_string()
}

#[test]
fn unknown_names_are_told_with_the_closest_known_one() {
    for (definition, message, meant) in [
        ("let a = dto(i, j);", "`dto` is not defined", "dot"),
        ("symbol alpha; let a = alhpa + 1;", "`alhpa` is not defined", "alpha"),
        ("path way(v) = (v, 0); let a = wya;", "`wya` is not defined", "way"),
        ("path s(v) = ph([1, I]); let a = s.nromal;", "a curve has no member `nromal`", "normal"),
    ] {
        let report = report(&format!("lemma t {{ {definition} }}"));
        assert!(report.contains(message), "{report}");
        assert!(report.contains(&format!("did you mean `{meant}`?")), "{report}");
    }
}

#[test]
fn a_name_that_failed_is_not_reported_again() {
    let text = "lemma t {
 symbol I, c;
 let a = 1 + i;
 claim \"id\": a == c;
 claim \"id\": 2*a == I;
}";
    mistakes(text, &["t:2:9: `I` has a meaning of its own", "t:3:14: a number and a vector cannot be added"]);
}

#[test]
fn clashing_names() {
    let table = [
        ("let a = 1; let a = 2;", "`a` is defined twice"),
        ("symbol a; path a(v) = (v, 0);", "`a` is defined twice"),
        ("let dot = 1;", "`dot` has a meaning of its own"),
        ("let k = 1;", "`k` has a meaning of its own"),
        ("path s(v) = (v, 0); let v = 1;", "`v` is a parameter"),
        ("let sqrt2 = 1;", "`sqrt2` is reserved for square roots"),
        ("let theta3 = 1;", "`theta3` is reserved for square roots"),
        ("symbol a0; path s(v) = ph(3);", "`a0` is defined twice"),
        ("path s(v) = ph(3); symbol b1;", "`b1` is defined twice"),
        ("function x(u); symbol x_u;", "`x_u` stands for a derivative of an unknown function"),
        ("symbol x_uu; function x(u);", "`x_uu` would also be the name of a derivative"),
        ("function x_u(u), x(u);", "`x_u` would also be the name of a derivative"),
        (
            "function a(v); symbol s_m; curve s(v) = regular_curve(a, a);",
            "`s_m` would also be the name of a coordinate",
        ),
        ("function a(v), s_x(v); curve s(v) = curve_from_hodograph((a, 1));", "`s_x` would also be the name"),
        ("function a(v); curve s(v) = regular_curve(a, a); let s_y = 1;", "`s_y` stands for"),
    ];
    for (definitions, expected) in table {
        let found = judge(&format!("lemma t {{ {definitions} }}")).expect_err(definitions);
        let [message] = found.as_slice() else { panic!("{definitions}: {found:?}") };
        assert!(message.contains(expected), "{definitions}: {message}");
    }
}

#[test]
fn curves_without_a_property() {
    let with = |curve: &str, value: &str| format!("lemma t {{\n {curve}\n claim \"id\": {value} == 1;\n}}");
    let table = [
        (
            "curve s(v) = (v, v^2);",
            "s.normal",
            "t:3:14: the parametric speed is not rational: |s'|^2 = 4*v^2 + 1, in which 4*v^2 + 1 is not a square",
        ),
        (
            "curve s(v) = (v^2, v^4);",
            "s.curvature",
            "t:3:14: the parametric speed is not rational: |s'|^2 = 16*v^6 + 4*v^2, in which 4*v^4 + 1 is not a square",
        ),
        ("curve s(v) = (1, 2);", "s.tangent", "t:3:14: the curve is a single point: its derivative is zero"),
        (
            "curve s(v) = (3*v, 4*v, 12*v);",
            "s.normal",
            "t:3:14: the curve is a straight line that is parallel to no coordinate plane, so that no plane determines",
        ),
        (
            "curve s(v) = (3*v, 4*v);",
            "s.evolute",
            "t:3:14: the curvature is zero everywhere, so there is no evolute and no Frenet frame",
        ),
        ("curve s(v) = ph([1, I]);", "s.length", "t:3:14: no domain is stated for the curve's parameter"),
        (
            "domain v in -1..1; curve s(v) = (v^2/2 - v^4/4, 2*v^3/3);",
            "s.speed",
            "t:3:14: the parametric speed is not rational on this domain: its factor v changes its sign there",
        ),
    ];
    for (curve, value, expected) in table {
        mistake(&with(curve, value), expected);
    }
}

#[test]
fn parameters_cannot_be_words_of_the_language() {
    let sweep = "sweep t { surface R(i, v) = i*k + v*j; domain i in 0..1, v in 0..1; }";
    mistake(sweep, "t:1:21: `i` has a meaning of its own, so it cannot be a parameter");
    mistake(
        "lemma t { path s(theta) = (1, theta); }",
        "t:1:18: `theta` is reserved for square roots, so it cannot be",
    );
}

#[test]
fn speeds_are_absolute_values() {
    // On one side of its cusp the curve has the speed |v|(1 + v^2).
    let half = |domain: &str| format!("domain v in {domain}; path s(v) = (v^2/2 - v^4/4, 2*v^3/3);");
    equal(&half("0..1"), &[("s.speed", "v + v^3"), ("s.length", "3/4")]);
    equal(&half("-1..0"), &[("s.speed", "-v - v^3"), ("s.length", "3/4")]);
    // Also where the curve is given by its hodograph.
    equal(
        "domain v in 0..1; curve g(v) = curve_from_hodograph((v - 2)*(3, 4));",
        &[("g.speed", "10 - 5*v"), ("diff(g.arclength, v)", "10 - 5*v")],
    );
    // The sign of an unknown is taken to be positive, and said so.
    let text =
        "lemma t { symbol c; path s(v) = (c*v, 0); claim \"id\": s.speed == c; claim \"id\": s.x == c*v; }";
    let judgements = judge(text).expect("no mistakes");
    assert_eq!(judgements[0].verdict, Verdict::Proved);
    assert_eq!(judgements[0].condition.as_deref(), Some("c > 0"));
    // The integral of this one is twice an arctangent.
    let circle = "lemma t { curve s(v) = ((1 - v^2)/(1 + v^2), 2*v/(1 + v^2)); claim \"id\": is_rational(s.arclength); }";
    let judgements = judge(circle).expect("no mistakes");
    assert_eq!(judgements[0].verdict, Verdict::Refuted);
    assert!(judgements[0].derived.contains("the arc length is not rational"), "{}", judgements[0].derived);
}

#[test]
fn homogeneous_coordinates_are_names_of_every_sweep() {
    let sweep =
        |clause: &str| format!("sweep t {{ {clause} surface R = u*i + v*j; domain u in 0..1, v in 0..1; }}");
    mistake(&sweep("let W = 1;"), "t:1:15: `W` is a homogeneous coordinate of the surface");
    mistake(&sweep("symbol c, X;"), "t:1:21: `X` is a homogeneous coordinate of the surface");
    mistake(&sweep("path Z(v) = (v, v);"), "t:1:16: `Z` is a homogeneous coordinate of the surface");
    let parameter = "sweep t { surface R(W, v) = W*i + v*j; domain W in 0..1, v in 0..1; }";
    mistake(parameter, "t:1:21: `W` is a homogeneous coordinate of the surface, so it cannot be a parameter");
    // A lemma has no surface.
    proved("symbol W;", &["W == W"]);
}

#[test]
fn pi_stands_in_angles_only() {
    for claim in [
        "pi == 3",
        "pi == pi",
        "pi > 3",
        "parallel((pi, 1), (1, pi))",
        "is_rational(pi)",
        "degree(pi*u) == (1, 0)",
    ] {
        let text = format!("lemma t {{ domain u in 0..1, v in 0..1;\n claim \"id\": {claim};\n}}");
        mistake(&text, "t:2:14: pi is not algebraic, so it can only stand in angles");
    }
    proved("let angle = pi/3;", &["cos(angle) == 1/2", "cos(2*angle) == -1/2"]);
}

#[test]
fn numbers_have_a_limit() {
    let text = |digits: usize| format!("lemma t {{ claim \"id\": {} > 1; }}", "9".repeat(digits));
    assert_eq!(judge(&text(4096)).unwrap()[0].verdict, Verdict::Proved);
    mistake(&text(4097), "t:1:23: the number 999999");
}

#[test]
fn substitution_changes_the_parameter_of_the_surface() {
    let sweep = |value: &str| {
        format!(
            "sweep t {{ surface R = u*i + v*j + u*v*k; substitute v = {value}; domain u in 0..1, v in 0..1; \
             claim \"id\": R == u*i + v^2*j + u*v^2*k; claim \"id\": degree(Z) == (1, 2); }}"
        )
    };
    let judgements = judge(&sweep("v^2")).expect("no mistakes");
    assert!(judgements.iter().all(|judgement| judgement.verdict == Verdict::Proved));
    mistake(&sweep("w"), "t:1:57: `w` is not defined");
}

#[test]
fn wrong_curves() {
    let table = [
        ("ph([0, 0])", 18, "the preimage has no nonzero coefficient"),
        ("ph([])", 18, "the preimage has no nonzero coefficient"),
        ("ph([1, (1, 2)])", 22, "a preimage's coefficient must be a complex number, but this is a vector"),
        ("ph([1, v])", 15, "this curve of `t` contains the parameter `v`"),
        ("ph(4)", 18, "a PH curve with a preimage has an odd degree 1, 3, 5, …, not 4"),
        ("ph(9999)", 18, "a PH curve of degree 9999 is asked for; the largest degree is 201"),
        ("ph(1/2)", 18, "the degree of a PH curve is an odd positive integer"),
        ("ph(3, factor = 0)", 30, "the factor of a hodograph is zero"),
        ("ph(3, fcator = 1)", 21, "`ph` has no argument `fcator`"),
        ("ph_hermite((0, 0), (0, 0), (1, 0), (1, 0))", 15, "the start tangent s'(0) is zero"),
        ("ph_hermite((0, 0), (1, 0), (1, 0), (0, 0))", 15, "the end tangent s'(1) is zero"),
        ("ph_hermite((0, 0), (1, 0), (1, 0))", 15, "`ph_hermite` takes 4 arguments, not 3"),
        ("ph_hermite((0, 0), (1, 0), (1, 0), 5)", 50, "a point or vector of the plane is expected"),
        ("bezier([(0, 0)])", 22, "a Bézier curve needs two control points at least"),
        ("bezier([(0, 0), 1])", 31, "a control point must be a vector, but this is a number"),
        ("bezier([(0, 0), (1, 1)], weights = [1])", 50, "1 weights for 2 control points"),
        ("bezier([(0, 0), (1, 1)], weights = [0, 0])", 15, "the weights cancel"),
        ("bezier([(0, 0), (v, 1)])", 15, "this curve of `t` contains the parameter `v`"),
        ("polynomial_curve(0)", 32, "the degree of a symbolic curve is an integer from 1 to 32"),
        ("rational_curve(33)", 30, "the degree of a symbolic curve is an integer from 1 to 32"),
        ("curve_from_hodograph((v, t))", 15, "this curve of `t` contains the parameter `v`"),
        ("curve_from_hodograph(t)", 36, "a hodograph must be a vector, but this is a scalar function"),
        ("(t, g)", 15, "this curve of `t` contains the function `g`"),
        ("(t, v)", 15, "this curve of `t` contains the parameter `v`"),
        ("t^2", 15, "a curve must be a vector, but this is a scalar function"),
        ("pi*t*i", 15, "pi is not algebraic, so it can only stand in angles"),
    ];
    for (curve, column, expected) in table {
        let text = format!("lemma t {{ function g(v);\n curve s(t) = {curve};\n}}");
        mistake(&text, &format!("t:2:{column}: {expected}"));
    }
}

#[test]
fn a_tie_of_hermite_interpolants_lists_the_candidates() {
    let tie = "ph_hermite((0, 0), (1, 0), (0, 0), (-1, 0)";
    let report = report(&format!("lemma t {{ path s(v) = {tie}); }}"));
    assert!(
        report.contains("2 of the PH quintics with these Hermite data have the same least absolute"),
        "{report}"
    );
    assert!(report.contains("solution 0:") && report.contains("solution 2:"), "{report}");
    assert!(report.contains("help: add `solution = …` with one of these numbers"), "{report}");
    // Each candidate can be chosen, and they are mirror images.
    let definitions = format!("path s(v) = {tie}, solution = 0); path t(v) = {tie}, solution = 2);");
    equal(&definitions, &[("s(1)", "(0, 0)"), ("t(1)", "(0, 0)"), ("s.x", "t.x"), ("s.y", "-t.y")]);
}

#[test]
fn what_a_sweep_lacks() {
    mistake("sweep t { domain u in 0..1, v in 0..1; }", "t:1:7: the sweep `t` has no surface");
    mistake(
        "sweep t { surface R = (u, v, 0); domain u in 0..1; }",
        "t:1:7: the sweep `t` has no domain for `v`",
    );
    mistake(
        "sweep t { surface R = (u, v, 0); domain u in 1..1, v in 0..1; }",
        "t:1:46: this domain does not end after its beginning",
    );
    mistake(
        "sweep t { surface R = u*v; domain u in 0..1, v in 0..1; }",
        "t:1:23: the surface must be a vector in space, but this is a scalar function",
    );
    mistake(
        "sweep t { function x(u); surface R = (x, v, 1); domain u in 0..1, v in 0..1; }",
        "t:1:38: the surface contains the unknown function `x`",
    );
    mistake(
        "sweep t { path s(t) = ph([1, I]); surface R(u, v) = s + u*i + v*k; domain u in 0..1, v in 0..1; }",
        "t:1:53: the surface contains the parameter `t`, which is not one of its own",
    );
    mistake(
        "lemma t { let a(u) = u; claim \"id\": positive(a); }",
        "t:1:37: the domain of `u` is not stated",
    );
    mistake("lemma t { surface R = (u, v, 0); }", "t:1:19: the lemma `t` has a surface");
}

#[test]
fn what_divides_by_zero() {
    mistake("lemma t { let a(u) = 1/(u - u); }", "t:1:24: division by zero");
    mistake("lemma t { let a = 0^-1; }", "t:1:19: division by zero");
    mistake("lemma t { let a = 1/(1 + I^2); }", "t:1:21: division by zero");
    mistake(
        "lemma t { let a(u) = 1/u; claim \"id\": a(0) == 1; }",
        "t:1:39: the expression is not defined at u = 0",
    );
    // What cancels is no pole.
    equal("let a(u) = (u^2 - u)/u;", &[("a(0)", "-1")]);
}

#[test]
fn numbers_beyond_limits() {
    let beyond = format!("t:1:28: the exponent 1000000000 is beyond the limit of {MAX_EXPONENT}");
    mistake("lemma t { let a(u) = (1+u)^(10^9); }", &beyond);
    mistake("lemma t { let a = 2^1001; }", "t:1:21: the exponent 1001 is beyond the limit");
    mistake("lemma t { let a = 2^(1/2); }", "t:1:21: the exponent 1/2 is not an integer");
    mistake("lemma t { let a = 1e999999999; }", "t:1:19: the number 1e999999999 is beyond the range");
    mistake("lemma t { let a = sqrt(-2); }", "t:1:24: the radicand -2 is negative");
    mistake("lemma t { let a = cos(1); }", "t:1:23: this angle is not a rational multiple of pi");
    mistake("lemma t { let a = cos(pi/7); }", "t:1:23: the angle (1/7)*pi is not available exactly");
    mistake(
        "lemma t { let a = exp(1); }",
        "t:1:23: the exponential of a number with a real part is not algebraic",
    );
}

#[test]
fn expressions_beyond_limits() {
    let nested =
        |depth: usize| (0..depth).fold("2".to_owned(), |radicand, _| format!("1 + sqrt({radicand})"));
    let primes = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71];
    let independent = primes.map(|prime| format!("sqrt({prime})")).join(" + ");
    // The place is that of the 17th root from within.
    for (number, column) in [(nested(20), 50), (independent, 19)] {
        mistake(
            &format!("lemma t {{ let a = {number}; }}"),
            &format!("t:1:{column}: these numbers need more than 16 independent square roots"),
        );
    }
    // The 65th level is the 33rd radicand.
    mistake(
        &format!("lemma t {{ let a = {}; }}", nested(40)),
        "t:1:307: this is nested more than 64 levels deep",
    );
    let doubled = (0..31).fold("2".to_owned(), |number, _| format!("norm2(({number}, 1))"));
    // The place is that of the innermost product that is too large.
    let text = format!("lemma t {{ let a = {doubled}; }}");
    let (file, source) = parse_text("t", &text).expect("the text is well-formed");
    let lines = Report::new(source, models(&file).1).lines();
    assert!(
        matches!(lines.as_slice(), [line] if line.contains(": this needs more than the budget")),
        "{lines:?}"
    );
    assert!(!lines[0].starts_with("t:1:19:"), "{lines:?}");
}

#[test]
fn arguments_are_evaluated_once() {
    // Twice at each level would be 2³¹ times.
    let nested = (0..31).fold("1".to_owned(), |number, _| format!("norm2(({number}, 0))"));
    equal("", &[(&nested, "1")]);
}

#[test]
fn an_unknown_function_has_no_degree_and_no_value() {
    let with =
        |claim: &str| format!("lemma t {{ function x(u); let a(u, v) = x*v;\n claim \"id\": {claim}; }}");
    mistake(&with("degree(a) == (0, 1)"), "t:2:14: the unknown function `x` has no degree");
    mistake(&with("x(0) == 1"), "t:2:14: the unknown function `x` has no value at a point");
    mistake(&with("a(0, v) == 1"), "t:2:14: the unknown function `x` has no value at a point");
    equal("function x(u); let a(u, v) = x*v;", &[("a(u, 2)", "2*x"), ("diff(a, u)", "v*diff(x, u)")]);
}
