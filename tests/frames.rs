//! The constructions of sweeps through frames, compared: the table of the documentation is what the engine computes.

use hodograph_codegen::language::parse_text;
use hodograph_codegen::meaning::models;

/// The table as it stands in the documentation.
const DOCUMENTED: &str = include_str!("../codegen/src/meaning/reference/frames.md");

/// A construction: what it is called, the options of the motion, the sizes of the frames, and the method.
const CONSTRUCTIONS: [(&str, &str, [u8; 4], &str); 11] = [
    ("printed net, Theorem 7.1", "orientation = sphere", [1, 1, 1, 1], "published"),
    ("exact sweep", "orientation = sphere", [1, 1, 1, 1], "sweep"),
    ("quaternions' own spline", "orientation = direct", [1, 1, 1, 1], "sweep"),
    ("printed net, Theorem 7.2, with scales", "orientation = sphere", [1, 2, 1, 3], "published"),
    ("exact sweep with scales", "orientation = sphere", [1, 2, 1, 3], "sweep"),
    ("quaternions' own spline with scales", "orientation = direct", [1, 2, 1, 3], "sweep"),
    ("printed net, C¹ orientation", "continuity = (2, 1, 2)", [1, 1, 1, 1], "published"),
    ("exact sweep, C¹ orientation", "continuity = (2, 1, 2)", [1, 1, 1, 1], "sweep"),
    (
        "quaternions' own spline, C¹ orientation",
        "continuity = (2, 1, 2), orientation = direct",
        [1, 1, 1, 1],
        "sweep",
    ),
    ("exact sweep with scales, all C¹", "continuity = 1", [1, 2, 1, 3], "sweep"),
    (
        "quaternions' own spline with scales, all C¹",
        "continuity = 1, orientation = direct",
        [1, 2, 1, 3],
        "sweep",
    ),
];

/// What the engine derives for `expr` in place of a value that it does not have.
fn derived(options: &str, scales: [u8; 4], claim: &str) -> String {
    let [a, b, c, d] = scales;
    let text = format!(
        r#"lemma a {{
            curve c(u) = ((1 - u^2)/(1 + u^2), 2*u/(1 + u^2), 0);
            frames F(v) = frames([
                frame((0, 0, 0), (24/25, 0, 0, 7/25), {a}), frame((4, 1, 0), (71/73, 12/73, 0, 12/73), {b}),
                frame((8, 0, 1), (-7/25, 0, 24/25, 0), {c}), frame((9, 3, 3), (1/9, 4/9, 0, 8/9), {d})], {options});
            domain u in 0..1;
            claim "a": {claim};
        }}"#
    );
    let (models, mistakes) = models(&parse_text("a.sweep", &text).unwrap().0);
    assert!(mistakes.is_empty(), "{mistakes:?}");
    models[0].check(&models[0].claims[0], u64::MAX).unwrap().derived
}

fn table() -> String {
    let mut table = String::from(
        "| construction | bidegree | continuity of the surface | control points of a patch |\n| --- | --- | --- | --- |\n",
    );
    for (name, options, scales, method) in CONSTRUCTIONS {
        let degree = derived(options, scales, &format!("degree(F.{method}(c)) == (0, 0)"));
        let order = derived(options, scales, &format!("continuity(F.{method}(c)) == -1"));
        let order = order.strip_prefix("the left side is ").unwrap_or_else(|| panic!("{order}"));
        // On all pieces the degree is the same, else the text names the piece.
        let numbers = degree.trim_matches(['(', ')']).split_once(", ").unwrap_or_else(|| panic!("{degree}"));
        let [u, v] = [numbers.0, numbers.1].map(|n| n.parse::<u32>().unwrap_or_else(|_| panic!("{degree}")));
        table +=
            &format!("| {name} | {degree} | {order} | {} × {} = {} |\n", u + 1, v + 1, (u + 1) * (v + 1));
    }
    table
}

#[test]
fn the_table_of_the_documentation_is_what_the_engine_computes() {
    let (_, after) = DOCUMENTED.split_once("\n\n| construction").unwrap();
    let documented = format!("| construction{after}");
    let computed = table();
    assert!(
        documented == computed,
        "codegen/src/meaning/reference/frames.md should have the table\n{computed}"
    );
}
