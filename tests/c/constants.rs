//! The C code that prints what is stated of a surface as a whole, and that makes members of families.

use std::fmt::Write;

use hodograph::{Bound, Bounds, Patch, Variant, offset_net};
use hodograph_codegen::emit::{Artifact, Setting};
use hodograph_codegen::proofs::BOUNDED;
use hodograph_codegen::schedule::outputs;
use hodograph_tests::search::bound_of;
use hodograph_tests::surfaces::Subject;

use crate::functions::TYPES;
use crate::program::Expected;

/// The C code that prints the domain, the degree and the bounds of a surface, and the lines that are expected.
pub(crate) fn stated(
    text: &mut String,
    expected: &mut Expected,
    name: &str,
    surface: &dyn Patch,
    bounds: Option<&Bounds>,
) {
    let mut expect = |what: &str, numbers: &[f64]| {
        expected.push((format!("{what} of {name}"), TYPES[0].line(numbers)));
    };
    let (domain, (m, n)) = (surface.domain(), surface.degree());
    _ = writeln!(text, "    put(HODOGRAPH_OK, &{name}_domain, 4);");
    expect("domain", &[domain.u, domain.v].concat());
    _ = writeln!(
        text,
        "    {{\n        const double degree[2] = {{{name}_degree_u, {name}_degree_v}};\n        put(HODOGRAPH_OK, degree, 2);\n    }}"
    );
    expect("degree", &[m, n].map(f64::from));
    let Some(bounds) = bounds else { return };
    let plain = |bound: &Bound| {
        let ([double, _, single, _], [relative, _, relative_single, _]) =
            (bound.errors, bound.relative_errors);
        [double, single, relative, relative_single, bound.size, bound.most]
    };
    let coordinates = [0, 2].map(|place| bounds.coordinates.map(|errors| errors[place]));
    let numbers: Vec<f64> = BOUNDED
        .iter()
        .flat_map(|&output| {
            let coordinates = if output == outputs::POINT { coordinates.as_flattened() } else { &[] };
            [&plain(bound_of(bounds, output)), coordinates].concat()
        })
        .collect();
    _ = writeln!(text, "    put(HODOGRAPH_OK, &{name}_bounds, {});", numbers.len());
    expect("bounds", &numbers);
    for r in ["0.0", "-0.25", "1e3", "1e37", "-1e38", "1e39", "1e308", "NAN"] {
        _ = writeln!(
            text,
            "    {{
        double errors[8] = {{
            hodograph_offset_point_error(&{name}_bounds, {r}), hodograph_offset_point_errorf(&{name}_bounds, {r})}};
        hodograph_offset_first_order_errors(&{name}_bounds, {r}, errors + 2);
        hodograph_offset_first_order_errorsf(&{name}_bounds, {r}, errors + 5);
        put(HODOGRAPH_OK, errors, 8);
    }}"
        );
        let r: f64 = r.parse().unwrap_or_else(|error| panic!("{r}: {error}"));
        let points =
            [bounds.offset_point::<f64>(Variant::Plain, r), bounds.offset_point::<f32>(Variant::Plain, r)];
        let doubles = bounds.offset_first_order::<f64>(Variant::Plain, r);
        let singles = bounds.offset_first_order::<f32>(Variant::Plain, r);
        expect("bounds of offsets", &[&points[..], &doubles, &singles].concat());
    }
}

/// The C code that prints the constants of a surface, and the lines that are expected.
pub(crate) fn constants(text: &mut String, expected: &mut Expected, artifact: &Artifact, subject: &Subject) {
    let name = &artifact.name;
    let surface = subject.surface.as_ref();
    stated(text, expected, name, surface, subject.bounds.as_ref());
    let mut expect = |what: &str, numbers: &[f64]| {
        expected.push((format!("{what} of {name}"), TYPES[0].line(numbers)));
    };
    if subject.bounds.is_some() {
        let net = surface.control_net();
        _ = writeln!(text, "    put(HODOGRAPH_OK, {name}_control_net, {});", 4 * net.len());
        expect("control net", net.as_flattened());
    }
    if let Some(patch) = &artifact.offset {
        let length = patch.net.len();
        _ = writeln!(
            text,
            "    {{
        const double degree[2] = {{{name}_offset_degree_u, {name}_offset_degree_v}};
        static double net[({name}_offset_degree_u + 1) * ({name}_offset_degree_v + 1)][4];
        {name}_offset_control_net(-0.3, net);
        put(HODOGRAPH_OK, degree, 2);
        put(HODOGRAPH_OK, net, 4 * {length});
    }}"
        );
        expect("degree of offsets", &[patch.degree.0, patch.degree.1].map(f64::from));
        let net: Vec<[f64; 4]> = patch
            .net
            .iter()
            .flat_map(|&[point, [_, a, b, c]]| offset_net(&[(point, [a, b, c])], -0.3))
            .collect();
        expect("control net of an offset", net.as_flattened());
    }
}

/// The C code that makes a member of a family, and that tries to make one of something that is no number.
pub(crate) fn member(text: &mut String, expected: &mut Expected, artifact: &Artifact, subject: &Subject) {
    let (name, mut values, mut first) = (&artifact.name, Vec::new(), String::new());
    for setting in &artifact.symbols {
        let number = |symbol: &String| format!("{:?}", subject.symbols[symbol.as_str()]);
        let (field, value) = match setting {
            Setting::Number(symbol) => (symbol.clone(), number(symbol)),
            Setting::Curve { name, rows, .. } => {
                let row = |row: &Vec<String>| {
                    format!("{{{}}}", row.iter().map(number).collect::<Vec<String>>().join(", "))
                };
                let rows: Vec<String> = rows.iter().map(row).collect();
                (format!("{name}[0][0]"), format!("{{{}}}", rows.join(", ")))
            }
        };
        values.push(value);
        first = field;
    }
    _ = writeln!(
        text,
        "    {name}_parameters parameters = {{{}}};
    {name}_surface surface;
    puts(hodograph_reason({name}_new(&parameters, &surface)));
    {{
        {name}_parameters wrong = parameters;
        {name}_surface none;
        wrong.{first} = NAN;
        puts(hodograph_reason({name}_new(&wrong, &none)));
        wrong.{first} = 1e308;
        puts({name}_new(&wrong, &none) != HODOGRAPH_PARAMETER ? \"a number\" : \"no number\");
    }}",
        values.join(", ")
    );
    for line in ["there is a result", "a parameter is infinite or NaN", "a number"] {
        expected.push((format!("making {name}"), line.to_owned()));
    }
    let net = subject.surface.control_net();
    _ = writeln!(text, "    put(HODOGRAPH_OK, surface.control_net, {});", 4 * net.len());
    expected.push((format!("control net of {name}"), TYPES[0].line(net.as_flattened())));
}
