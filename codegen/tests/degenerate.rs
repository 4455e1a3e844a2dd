//! Degenerate data: each case ends in the right surface, compared with coordinates that were worked out by hand, or in a
//! message at its place.

use hodograph_algebra::{OffsetError, SweptSurface, budget};
use hodograph_codegen::language::ast::Verdict;
use hodograph_codegen::language::{Diagnostics, Report, parse_text};
use hodograph_codegen::meaning::{Judgement, Model, models};
use hodograph_codegen::program::{Floats, Variant, interpret};
use hodograph_codegen::schedule::outputs;

/// The profile is a parabola, so that x and z have different degrees; nothing of it cancels.
const PROFILE: &str = "profile p(u) = u*i + u^2*k;";

/// `w = 1 + I v`: x = v − v³/3, y = v², σ = 1 + v².
const CUBIC: &str = "path s(v) = ph([1, 1 + I]);";

const TRANSLATION: &str = "s + p.x*s.normal + p.z*k";
const INVOLUTE: &str = "s.involute - p.x*s.tangent + p.z*k";
const EVOLUTE: &str = "s.evolute + p.x*s.tangent + p.z*k";

fn models_of(text: &str) -> Result<Vec<Model>, Vec<String>> {
    let (file, source) = parse_text("t", text).map_err(|report| report.lines())?;
    let (models, diagnostics) = models(&file);
    if diagnostics.is_empty() { Ok(models) } else { Err(Report::new(source, diagnostics).lines()) }
}

fn judge(text: &str) -> Result<Vec<Judgement>, Vec<String>> {
    let (mut judgements, mut mistakes) = (Vec::new(), Diagnostics::new());
    for model in models_of(text)? {
        for claim in &model.claims {
            match model.check(claim, budget::DEFAULT_LIMIT) {
                Ok(judgement) => judgements.push(judgement),
                Err(diagnostic) => mistakes.push(*diagnostic),
            }
        }
    }
    if mistakes.is_empty() {
        return Ok(judgements);
    }
    let (_, source) = parse_text("t", text).map_err(|report| report.lines())?;
    Err(Report::new(source, mistakes).lines())
}

fn sweep(definitions: &str, surface: &str, domain: &str, claims: &[String]) -> String {
    let claims: String = claims.iter().map(|claim| format!("claim \"id\": {claim};\n")).collect();
    format!("sweep t {{\n{definitions}\nsurface R = {surface};\ndomain {domain};\n{claims}}}")
}

const UNIT: &str = "u in 0..1, v in 0..1";

/// All claims on the surface hold.
#[track_caller]
fn holds(definitions: &str, surface: &str, domain: &str, claims: &[&str]) {
    let claims: Vec<String> = claims.iter().map(|claim| (*claim).to_owned()).collect();
    let text = sweep(definitions, surface, domain, &claims);
    for judgement in judge(&text).unwrap_or_else(|mistakes| panic!("{text}\n{mistakes:?}")) {
        assert_eq!(
            judgement.verdict,
            Verdict::Proved,
            "{text}\n{}: {} {:?}",
            judgement.statement,
            judgement.derived,
            judgement.witness
        );
    }
}

/// The surface has these homogeneous coordinates, which are polynomials without common factor, of these degrees.
#[track_caller]
fn coordinates(definitions: &str, surface: &str, domain: &str, by_hand: [(&str, (i64, i64)); 4]) {
    let hand: Vec<&str> = by_hand.iter().map(|(coordinate, _)| *coordinate).collect();
    let hand = hand.join(", ");
    let mut claims = vec![format!("parallel((W, X, Y, Z), ({hand}))"), format!("coprime({hand})")];
    for (name, (coordinate, degree)) in ["W", "X", "Y", "Z"].iter().zip(by_hand) {
        claims.push(format!("degree({name}) == {degree:?}"));
        claims.push(format!("degree({coordinate}) == {degree:?}"));
    }
    let claims: Vec<&str> = claims.iter().map(String::as_str).collect();
    holds(definitions, surface, domain, &claims);
}

/// The text has these mistakes, each at its place.
#[track_caller]
fn mistakes(text: &str, expected: &[&str]) {
    let found = judge(text).expect_err(text);
    let agree = |(found, expected): (&String, &&str)| found.starts_with(expected);
    assert!(found.len() == expected.len() && found.iter().zip(expected).all(agree), "{text}\n{found:#?}");
}

fn surface_of(definitions: &str, surface: &str, domain: &str) -> SweptSurface {
    let text = sweep(definitions, surface, domain, &[]);
    let models = models_of(&text).unwrap_or_else(|mistakes| panic!("{text}\n{mistakes:?}"));
    SweptSurface::clone(models[0].surface.as_ref().expect("a sweep has a surface"))
}

/// Where there is no normal, and where there are poles.
fn singular_and_poles(definitions: &str, surface: &str, domain: &str) -> (Vec<String>, String) {
    let derivation = surface_of(definitions, surface, domain).derive().expect("a surface");
    let geometry = derivation.geometry.expect("there is no limit");
    (geometry.singular_zeros, derivation.poles.expect("no symbols").to_string())
}

#[track_caller]
fn is_no_surface(definitions: &str, surface: &str) {
    let derivation = surface_of(definitions, surface, UNIT).derive();
    assert_eq!(derivation.err(), Some(OffsetError::NoSurface), "{definitions} {surface}");
}

#[test]
fn vanishing_leading_coefficients() {
    // w = 1 + I v²: x' = 1 − v⁴, y' = 2v²; y is a cubic.
    let definitions = format!("{PROFILE} path s(v) = ph([1, 1, 1 + I]);");
    let sigma = "15*(1 + v^4)";
    coordinates(
        &definitions,
        TRANSLATION,
        UNIT,
        [
            (sigma, (0, 4)),
            ("(1 + v^4)*(15*v - 3*v^5) + 30*v^2*u", (1, 9)),
            ("10*(1 + v^4)*v^3 - 15*(1 - v^4)*u", (1, 7)),
            ("15*(1 + v^4)*u^2", (2, 4)),
        ],
    );
    // A quintic by its coefficients, a straight line in truth.
    let definitions = format!("{PROFILE} path s(v) = ph([2, 2, 2]);");
    let line = [("1", (0, 0)), ("4*v", (0, 1)), ("-u", (1, 0)), ("u^2", (2, 0))];
    coordinates(&definitions, TRANSLATION, UNIT, line);
    // Bézier curves that are elevated from a line, and from a circle.
    let definitions = format!("{PROFILE} path s(v) = bezier([(0, 0), (1, 0), (2, 0), (3, 0)]);");
    let line = [("1", (0, 0)), ("3*v", (0, 1)), ("-u", (1, 0)), ("u^2", (2, 0))];
    coordinates(&definitions, TRANSLATION, UNIT, line);
}

#[test]
fn symmetric_curves() {
    // w = (2v − v²) + I(1 − v²): x' = −1 + 6v² − 4v³ is of lower degree than y' = 4v − 2v² − 4v³ + 2v⁴.
    let definitions = format!("{PROFILE} path s(v) = ph([I, 1 + I, 1]);");
    let sigma = "(1 + 2*v^2 - 4*v^3 + 2*v^4)";
    coordinates(
        &definitions,
        TRANSLATION,
        UNIT,
        [
            (&format!("15*{sigma}"), (0, 4)),
            (&format!("15*{sigma}*(2*v^3 - v - v^4) + 15*(4*v - 2*v^2 - 4*v^3 + 2*v^4)*u"), (1, 8)),
            (&format!("{sigma}*(30*v^2 - 10*v^3 - 15*v^4 + 6*v^5) - 15*(6*v^2 - 1 - 4*v^3)*u"), (1, 9)),
            (&format!("15*{sigma}*u^2"), (2, 4)),
        ],
    );
}

#[test]
fn non_primitive_hodographs() {
    // s' = v·w²: the factor v of σ cancels from W, X, Y, Z.
    let definitions = format!("{PROFILE} path s(v) = ph([1, 1 + I], factor = v);");
    coordinates(
        &definitions,
        TRANSLATION,
        UNIT,
        [
            ("12*(1 + v^2)", (0, 2)),
            ("(1 + v^2)*(6*v^2 - 3*v^4) + 24*v*u", (1, 6)),
            ("8*(1 + v^2)*v^3 - 12*(1 - v^2)*u", (1, 5)),
            ("12*(1 + v^2)*u^2", (2, 2)),
        ],
    );
    let surface = surface_of(&definitions, TRANSLATION, UNIT);
    assert_eq!(surface.homogeneous().common_factor().to_string(), "v");
    // s' = (1 + v²)·w² with w = 1 + I v: σ is a square, but W needs one factor of it only.
    let definitions = format!("{PROFILE} path s(v) = ph([1, 1 + I], factor = 1 + v^2);");
    holds(
        &definitions,
        TRANSLATION,
        UNIT,
        &["W == 10*(1 + v^2)", "degree(R) == (2, 7)", "s.speed == (1 + v^2)^2"],
    );
}

#[test]
fn a_hodograph_whose_factor_changes_its_sign() {
    let text = |domain: &str| {
        sweep(
            &format!("{PROFILE}\npath s(v) = ph([1, 1 + I], factor = 2*v - 1);"),
            TRANSLATION,
            &format!("u in 0..1, v in {domain}"),
            &["s.speed == (1 - 2*v)*(1 + v^2)".to_owned()],
        )
    };
    let message = "t:4:21: the parametric speed is not rational on this domain: its factor 2*v - 1 changes its sign there";
    mistakes(&text("0..1"), &[message]);
    // On one side of the cusp the speed is |h|·|w|².
    assert_eq!(judge(&text("0..1/2")).unwrap()[0].verdict, Verdict::Proved);
    let (_, poles) = singular_and_poles(
        &format!("{PROFILE} path s(v) = ph([1, 1 + I], factor = 2*v - 1);"),
        TRANSLATION,
        "u in 0..1, v in 0..1/2",
    );
    assert_eq!(poles, "none");
}

#[test]
fn profiles_through_the_origin() {
    let definitions = format!("{PROFILE} {CUBIC}");
    // The scaled rotation has no normal where x(u) = 0; on u = 0 it is the point (0, 0, 0).
    let rotation = "p.x*s + p.z*k";
    coordinates(
        &definitions,
        rotation,
        UNIT,
        [("3", (0, 0)), ("(3*v - v^3)*u", (1, 3)), ("3*v^2*u", (1, 2)), ("3*u^2", (2, 0))],
    );
    let (singular, _) = singular_and_poles(&definitions, rotation, UNIT);
    assert_eq!(singular, ["u = 0"]);
    // The oriented translation passes through the curve itself, and has a normal there.
    holds(&definitions, TRANSLATION, UNIT, &["R(0, v) == s"]);
    assert_eq!(singular_and_poles(&definitions, TRANSLATION, UNIT).0, Vec::<String>::new());
}

#[test]
fn scales_that_vanish() {
    let definitions = format!("{PROFILE} {CUBIC}");
    // At v = 0 the profile is scaled to a point.
    let conical = "s + v*(p.x*s.normal + p.z*k)";
    coordinates(
        &definitions,
        conical,
        UNIT,
        [
            ("3*(1 + v^2)", (0, 2)),
            ("(1 + v^2)*(3*v - v^3) + 6*v^2*u", (1, 5)),
            ("3*(1 + v^2)*v^2 - 3*v*(1 - v^2)*u", (1, 4)),
            ("3*(1 + v^2)*v*u^2", (2, 3)),
        ],
    );
    assert_eq!(singular_and_poles(&definitions, conical, UNIT).0, ["v = 0"]);
    is_no_surface(&definitions, "s + 0*(p.x*s.normal + p.z*k)");
    // The arc length itself vanishes at the start: (29) with c₀ = 0.
    let conical = "s + s.arclength/s.length*(p.x*s.normal + p.z*k)";
    coordinates(
        &definitions,
        conical,
        UNIT,
        [
            ("12*(1 + v^2)", (0, 2)),
            ("(1 + v^2)*(12*v - 4*v^3) + 3*(3*v + v^3)*2*v*u", (1, 5)),
            ("12*(1 + v^2)*v^2 - 3*(3*v + v^3)*(1 - v^2)*u", (1, 5)),
            ("3*(1 + v^2)*(3*v + v^3)*u^2", (2, 5)),
        ],
    );
}

#[test]
fn scales_that_share_a_factor_with_the_parametric_speed() {
    let definitions = format!("{PROFILE} {CUBIC}");
    // c = σ: the surface is polynomial.
    coordinates(
        &definitions,
        "s + s.speed*(p.x*s.normal + p.z*k)",
        UNIT,
        [
            ("3", (0, 0)),
            ("3*v - v^3 + 6*v*u", (1, 3)),
            ("3*v^2 - 3*(1 - v^2)*u", (1, 2)),
            ("3*(1 + v^2)*u^2", (2, 2)),
        ],
    );
    // c = 1/σ.
    coordinates(
        &definitions,
        "s + (p.x*s.normal + p.z*k)/s.speed",
        UNIT,
        [
            ("3*(1 + v^2)^2", (0, 4)),
            ("(1 + v^2)^2*(3*v - v^3) + 6*v*u", (1, 7)),
            ("3*(1 + v^2)^2*v^2 - 3*(1 - v^2)*u", (1, 6)),
            ("3*(1 + v^2)*u^2", (2, 2)),
        ],
    );
}

#[test]
fn weights_that_cancel() {
    let text = sweep("path s(v) = bezier([(0, 0), (1, 1)],\n weights = [0, 0]);", "s + u*k", UNIT, &[]);
    mistakes(&text, &["t:2:13: the weights cancel: their sum is zero for every parameter"]);
    // Equal weights are those of a polynomial curve.
    let curve = "path s(v) = bezier([(0, 0), (1, 2), (2, 0)], weights = [5, 5, 5]);";
    coordinates(
        curve,
        "s + u*k",
        UNIT,
        [("1", (0, 0)), ("2*v", (0, 1)), ("4*v - 4*v^2", (0, 2)), ("u", (1, 0))],
    );
    // Numerator and weight have the factor 1 + v: in truth x = v/(1 + v), y = 1/(1 + v).
    let curve = "path s(v) = bezier([(0, 1), (1/4, 3/4), (1/2, 1/2)], weights = [1, 2, 4]);";
    coordinates(
        curve,
        "s + u*k",
        UNIT,
        [("1 + v", (0, 1)), ("v", (0, 1)), ("1", (0, 0)), ("u*(1 + v)", (1, 1))],
    );
    // Weights of both signs: x = −v/(1 − 2v) has a pole on the domain, which is found.
    let curve = "path s(v) = bezier([(0, 0), (1, 1)], weights = [1, -1]);";
    let by_hand = [("1 - 2*v", (0, 1)), ("-v", (0, 1)), ("-v", (0, 1)), ("u*(1 - 2*v)", (1, 1))];
    coordinates(curve, "s + u*k", UNIT, by_hand);
    assert_eq!(singular_and_poles(curve, "s + u*k", UNIT).1, "v = 1/2");
    // All points but the first have no weight: a point.
    is_no_surface("path s(v) = bezier([(0, 0), (1, 1), (2, 0)], weights = [2, 0, 0]);", "s + u*k");
    // The leading coefficient of the weight cancels.
    let curve = "path s(v) = bezier([(0, 0), (1, 1), (2, 0)], weights = [1, 0, -1]);";
    let by_hand = [("1 - 2*v", (0, 1)), ("-2*v^2", (0, 2)), ("0", (-1, -1)), ("u*(1 - 2*v)", (1, 1))];
    coordinates(curve, "s + u*k", UNIT, by_hand);
}

#[test]
fn what_is_wrong_with_a_surface_stands_at_its_formula() {
    let text = "lemma l { }\nsweep t {\n  surface R =\n    u*i + u^2*j;\n  domain u in 0..1, v in 0..1;\n}";
    let (file, source) = parse_text("t", text).unwrap();
    let (models, _) = models(&file);
    let place = |model: &Model| {
        let position = source.position(model.place);
        (position.line, position.column)
    };
    assert_eq!(models.iter().map(place).collect::<Vec<_>>(), [(1, 7), (4, 5)]);
}

#[test]
fn surfaces_that_collapse() {
    let translated = |profile: &str| format!("profile p(u) = {profile}; {CUBIC}");
    // The profile is a point, the path is a point, both are.
    is_no_surface(&translated("3*i + 2*k"), TRANSLATION);
    is_no_surface(&format!("{PROFILE} path s(v) = (1, 2);"), "s + p.x*i + p.z*k");
    is_no_surface("profile p(u) = (1, 2); path s(v) = (1, 2);", "s + p");
    // The path is a straight line, and the profile along it.
    is_no_surface("profile p(u) = u*i; path s(v) = (v, 0);", "s + p");
    // The involute of a line is a point, its tangent constant: only the profile is left.
    let line = format!("{PROFILE} path s(v) = (3*v, 4*v);");
    is_no_surface(&line, INVOLUTE);
    holds(&line, TRANSLATION, UNIT, &["s.involute == (0, 0)", "s.curvature == 0", "degree(R) == (2, 1)"]);
    // What verifies a degenerate sweep still knows its coordinates: those of the line itself.
    let claims = ["degree(R) == (0, 1)", "degree(W) == (0, 0)"];
    holds("profile p(u) = (1, 2); path s(v) = (v, 0);", "s + 0*p.x*k", UNIT, &claims);
}

#[test]
fn zero_curvature_everywhere() {
    let text = sweep(&format!("{PROFILE}\npath s(v) = (3*v, 4*v);"), EVOLUTE, UNIT, &[]);
    mistakes(
        &text,
        &["t:4:13: the curvature is zero everywhere, so there is no evolute and no Frenet frame"],
    );
    // A line that runs through its points with a rational speed is one, too.
    let text = sweep(&format!("{PROFILE}\npath s(v) = v^3*(3, 4)/(1 + v);"), EVOLUTE, UNIT, &[]);
    mistakes(
        &text,
        &["t:4:13: the curvature is zero everywhere, so there is no evolute and no Frenet frame"],
    );
    // The evolute of a circle is its center, and the sweep a paraboloid of revolution.
    let circle = format!("{PROFILE} path s(v) = ((1 - v^2)/(1 + v^2), 2*v/(1 + v^2));");
    coordinates(
        &circle,
        EVOLUTE,
        UNIT,
        [("1 + v^2", (0, 2)), ("-2*v*u", (1, 1)), ("(1 - v^2)*u", (1, 2)), ("(1 + v^2)*u^2", (2, 2))],
    );
    holds(&circle, EVOLUTE, UNIT, &["s.evolute == (0, 0)", "R.x^2 + R.y^2 == R.z"]);
    // Where the curvature has a zero the evolute has a pole: w = 1 + I v², κ = 4v/σ².
    let flat = format!("{PROFILE} path s(v) = ph([1, 1, 1 + I]);");
    assert_eq!(singular_and_poles(&flat, EVOLUTE, UNIT).1, "v = 0");
}

#[test]
fn arc_lengths_that_are_not_rational() {
    let circle = format!("{PROFILE}\npath s(v) = ((1 - v^2)/(1 + v^2), 2*v/(1 + v^2));");
    let message = "the arc length is not rational: the integral of the parametric speed 2/(v^2 + 1) consists of \
                   logarithms or arctangents";
    mistakes(&sweep(&circle, INVOLUTE, UNIT, &[]), &[&format!("t:4:13: {message}")]);
    let conical = "s + (1 + s.arclength/s.length)*(p.x*s.normal + p.z*k)";
    mistakes(
        &sweep(&circle, conical, UNIT, &[]),
        &[&format!("t:4:22: {message}"), &format!("t:4:34: {message}")],
    );
    let refuted =
        format!("lemma t {{ {} claim \"id\": is_rational(s.arclength); }}", &circle[PROFILE.len()..]);
    let judgements = judge(&refuted).unwrap();
    assert_eq!(judgements[0].verdict, Verdict::Refuted);
    assert_eq!(judgements[0].derived, message);
}

#[test]
fn rational_arc_lengths_of_rational_curves() {
    // s' = (1 − v², 2v)/v⁴, σ = (1 + v²)/v⁴; the arc length from 1 is 4/3 − 1/v − 1/(3v³).
    let definitions = format!("{PROFILE} path s(v) = ((3*v^2 - 1)/(3*v^3), -1/v^2);");
    let domain = "u in 0..1, v in 1..2";
    coordinates(
        &definitions,
        INVOLUTE,
        domain,
        [
            ("3*v^2*(1 + v^2)", (0, 4)),
            ("4*v*(v^3 - v + 1) - 3*v^2*(1 - v^2)*u", (1, 4)),
            ("3*v^2 - 8*v^3 - 1 - 6*v^3*u", (1, 3)),
            ("3*v^2*(1 + v^2)*u^2", (2, 4)),
        ],
    );
    let claims =
        ["s.arclength == 4/3 - 1/v - 1/(3*v^3)", "s.length == 19/24", "diff(s.arclength, v) == s.speed"];
    holds(&definitions, "s + (1 + s.arclength)*(p.x*s.normal + p.z*k)", domain, &claims);
    // (29), with S = 19/24: W = S σ v⁴ and the scale has the denominator v³.
    let conical = "s + (1 + s.arclength/s.length)*(p.x*s.normal + p.z*k)";
    coordinates(
        &definitions,
        conical,
        domain,
        [
            ("57*v^3*(1 + v^2)", (0, 5)),
            ("19*(1 + v^2)*(3*v^2 - 1) + 6*v*(51*v^3 - 24*v^2 - 8)*u", (1, 4)),
            ("-57*v*(1 + v^2) - 3*(1 - v^2)*(51*v^3 - 24*v^2 - 8)*u", (1, 5)),
            ("3*(1 + v^2)*(51*v^3 - 24*v^2 - 8)*u^2", (2, 5)),
        ],
    );
}

#[test]
fn offset_translations_along_any_curve_of_rational_speed() {
    // (20), (21): the curve is the profile. A PH cubic times v, of which the factor cancels.
    let offset = "p + d*p.normal + v*k";
    let definitions = "profile p(u) = ph([1, 1 + I], factor = u); let d(v) = v^3/(1 + v);";
    coordinates(
        definitions,
        offset,
        UNIT,
        [
            ("12*(1 + u^2)*(1 + v)", (2, 1)),
            ("(1 + u^2)*(6*u^2 - 3*u^4)*(1 + v) + 24*u*v^3", (6, 3)),
            ("8*(1 + u^2)*u^3*(1 + v) - 12*(1 - u^2)*v^3", (5, 3)),
            ("12*(1 + u^2)*(1 + v)*v", (2, 2)),
        ],
    );
    // A circle in the xz-plane, where n = t × j is the inward normal: a surface of revolution about the y-axis.
    let definitions = "profile p(u) = (1 - u^2)/(1 + u^2)*i + 2*u/(1 + u^2)*k; let d(v) = v^2;";
    coordinates(
        definitions,
        "p + d*p.normal + v*j",
        UNIT,
        [
            ("1 + u^2", (2, 0)),
            ("(1 - u^2)*(1 - v^2)", (2, 2)),
            ("(1 + u^2)*v", (2, 1)),
            ("2*u*(1 - v^2)", (1, 2)),
        ],
    );
    // A straight line: with d linear the surface is a plane.
    let definitions = "profile p(u) = (3*u, 4*u); let d(v) = v;";
    coordinates(
        definitions,
        offset,
        UNIT,
        [("5", (0, 0)), ("15*u + 4*v", (1, 1)), ("20*u - 3*v", (1, 1)), ("5*v", (0, 1))],
    );
}

#[test]
fn an_infinite_arc_length() {
    let text = |domain: &str| {
        format!("lemma t {{\ncurve s(v) = (1/v, 0);\n{domain}\nclaim \"id\": s.arclength == 1 - 1/v;\n}}")
    };
    let message = "t:4:13: the arc length is infinite: v in the denominator of the parametric speed vanishes on the domain";
    mistakes(&text("domain v in 0..1;"), &[message]);
    mistakes(&text("domain v in -1..1;"), &[message]);
    // Without a domain it begins at 0.
    mistakes(&text(""), &[message]);
    assert_eq!(judge(&text("domain v in 1..2;")).unwrap()[0].verdict, Verdict::Proved);
}

#[test]
fn zero_speed() {
    let text = sweep("path s(v) = (1, 2);", "s + u*s.normal", UNIT, &[]);
    mistakes(&text, &["t:3:19: the curve is a single point: its derivative is zero"]);
    let text = sweep("path s(v) = ph([0, 0, 0]);", "s + u*s.normal", UNIT, &[]);
    mistakes(&text, &["t:2:16: the preimage has no nonzero coefficient"]);
    let text = sweep("path s(v) = ph([1, I], factor = 0);", "s + u*s.normal", UNIT, &[]);
    mistakes(&text, &["t:2:33: the factor of a hodograph is zero"]);
    let text = sweep("path s(v) = ph_hermite((0, 0), (0, 0), (1, 1), (1, 0));", "s + u*s.normal", UNIT, &[]);
    mistakes(&text, &["t:2:13: the start tangent s'(0) is zero"]);
    // A curve that stands still at one point only: (v², v²) is the line from there.
    let definitions = format!("{PROFILE} path s(v) = (3*v^2, 4*v^2);");
    coordinates(
        &definitions,
        TRANSLATION,
        UNIT,
        [("5", (0, 0)), ("15*v^2 + 4*u", (1, 2)), ("20*v^2 - 3*u", (1, 2)), ("5*u^2", (2, 0))],
    );
}

#[test]
fn curves_in_any_plane() {
    // A PH cubic in the plane 4z = 3x: (4x, y, 3x) of (x, 5y, …), with the speed 5(1 + v²).
    let definitions = format!("{PROFILE} path s(v) = (v - v^3/3)*(4*i + 3*k) + 5*v^2*j;");
    let sweep = "s + p.x*s.normal + p.z*s.axis";
    let claims = [
        "s.speed == 5*(1 + v^2)",
        "s.axis == (-3, 0, 4)/5",
        "s.normal == cross(s.tangent, s.axis)",
        "s.curvature == 2/5/(1 + v^2)^2",
        "diff(s.tangent, v) == -s.speed*s.curvature*s.normal",
        "diff(s.normal, v) == s.speed*s.curvature*s.tangent",
        "diff(s.evolute, v) == -diff(1/s.curvature, v)*s.normal",
        "diff(s.involute, v) == s.arclength*s.speed*s.curvature*s.normal",
        "s.length == 20/3",
        "degree(R) == (2, 5)",
    ];
    holds(&definitions, sweep, UNIT, &claims);
    // The rotation by which the plane is that of x and y gives the sweep along the PH cubic, five times as large.
    let (x, y) = ("5*(1 + v^2)*(3*v - v^3) + 6*v*u", "15*(1 + v^2)*v^2 - 3*(1 - v^2)*u");
    coordinates(
        &definitions,
        sweep,
        UNIT,
        [
            ("15*(1 + v^2)", (0, 2)),
            (&format!("4*({x}) - 9*(1 + v^2)*u^2"), (2, 5)),
            (&format!("5*({y})"), (1, 4)),
            (&format!("3*({x}) + 12*(1 + v^2)*u^2"), (2, 5)),
        ],
    );
    // Parallel to a coordinate plane; across two of them, where √2 is adjoined.
    let shifted = format!("{PROFILE} path s(v) = (v - v^3/3, v^2, 7);");
    holds(
        &shifted,
        TRANSLATION,
        UNIT,
        &["s.axis == k", "s.normal == (2*v, v^2 - 1)/(1 + v^2)", "s.evolute.z == 7"],
    );
    let diagonal = format!("{PROFILE} path s(v) = (v - v^3/3)*(i + j)/sqrt(2) + v^2*k;");
    holds(
        &diagonal,
        sweep,
        UNIT,
        &["s.axis == (j - i)/sqrt(2)", "s.speed == 1 + v^2", "is_rational(s.offset(1))"],
    );
    // Of a symbolic plane the unit normal is not rational; of a curve in space there is none.
    let judgements =
        judge("lemma t { symbol c; curve s(v) = (v, v^2, c*v); claim \"id\": s.axis == k; }").unwrap();
    assert_eq!(judgements[0].verdict, Verdict::Undecided);
    assert_eq!(
        judgements[0].derived,
        "the unit normal of the curve's plane is not rational in the symbols: c^2 + 1 is not a square"
    );
    let space =
        |claim: &str| format!("lemma t {{\n curve s(v) = (v, v^2, v^3);\n claim \"id\": {claim};\n}}");
    mistakes(&space("s.axis == k"), &["t:3:14: the curve lies in no plane"]);
}

#[test]
fn families_compile_whose_named_polynomials_have_further_symbols() {
    // The path's position has symbols that do not occur in every polynomial of the surface.
    let sweeps = [
        "symbol c; profile p(u) = (c + u)*i + u^2*k; path s(v) = ph(3); let z(u) = p.z;",
        "profile p(u) = rational_curve(2); path s(v) = ph(5); let z(u) = p.y;",
        "symbol c, d; profile p(u) = c*(1 - u^2)/(1 + u^2)*i + d*2*u/(1 + u^2)*k; path s(v) = ph([1, 1 + I]); let z(u) = p.z;",
    ];
    for (sweep, weight) in sweeps.into_iter().zip([(0, 2), (2, 4), (2, 2)]) {
        let text = format!(
            "sweep family {{ {sweep} surface R = s + p.x*s.normal + z*k; domain u in 0..1, v in 0..1; }}"
        );
        let (file, _source) = hodograph_codegen::language::parse_text("family.sweep", &text).unwrap();
        let (models, mistakes) = hodograph_codegen::meaning::models(&file);
        assert!(mistakes.is_empty(), "{sweep}");
        let artifact = hodograph_codegen::compile::compile(&models[0]).unwrap();
        assert_eq!(artifact.coordinate_degrees[0], weight, "{sweep}");
        assert!(!artifact.symbols.is_empty(), "{sweep}");
    }
}

/// Coefficients whose products no float would hold are scaled by powers of two; what is evaluated is the same.
#[test]
fn coefficients_of_any_size_have_evaluators() {
    let text = "sweep large {
        surface R = (3^120*u + v^2, v/3^90, u*v + 2^100*u^2)/(5^70 + 7^60*u*v);
        domain u in 0..1, v in 0..1;
    }";
    let (file, _) = hodograph_codegen::language::parse_text("large.sweep", text).unwrap();
    let (models, _) = hodograph_codegen::meaning::models(&file);
    let artifact = hodograph_codegen::compile::compile(&models[0]).unwrap();
    let floats = Floats { u: 0.5, v: 0.25, symbols: &[], variant: Variant::Plain };
    let result = |output| interpret(&artifact.program, artifact.program.results(output), &floats).unwrap();
    let weight = 5_f64.powi(70) + 7_f64.powi(60) * 0.125;
    let expected = [
        (3_f64.powi(120) * 0.5 + 0.0625) / weight,
        0.25 / 3_f64.powi(90) / weight,
        (0.125 + 2_f64.powi(98)) / weight,
    ];
    for (found, expected) in result(outputs::POINT).into_iter().zip(expected) {
        assert!((found / expected - 1.0).abs() < 1e-13, "{found} is not {expected}");
    }
    let homogeneous = result(outputs::HOMOGENEOUS);
    assert!((homogeneous[1] / homogeneous[0] / expected[0] - 1.0).abs() < 1e-13);
}

/// The normal of these vanishes at poles, and at points that subdivision does not find.
#[test]
fn poles_are_no_singular_points() {
    let (singular, poles) = singular_and_poles("", "(u/v, (1 + u^2)/(u + v), v)", UNIT);
    assert_eq!((singular, poles.as_str()), (Vec::new(), "v = 0"));
    let surface = "(u/(v - 1/3), v^2/(u*u + (v - 1/3)), u)";
    let (singular, poles) = singular_and_poles("", surface, "u in -1..1, v in 0..1");
    assert_eq!(singular, ["u = 0, v = 0", "u = 0, v = 2/3"]);
    assert_eq!(poles, "v = 1/3; 3*u^2 + 3*v - 1 = 0");
    // R_u × R_v = u·(…) where u = 0 is a pole.
    let (singular, poles) = singular_and_poles("", "(1/u, v*u^3, v*u^4)", "u in 0..1, v in 0..1");
    assert_eq!((singular, poles.as_str()), (Vec::new(), "u = 0"));
}
