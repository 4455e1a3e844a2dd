//! The tables, as text and as Markdown.

use crate::families::Family;
use crate::fit::exponent;
use crate::measure::{Row, STEPS, Step};

/// A family and its measurements.
pub(crate) type Measured<'a> = (&'a Family, Vec<Row>);

/// The heading of the text of a table.
pub(crate) fn heading() -> String {
    let columns = format!("{:>10} {:>7} {:>6} {:>6} {:>5}", "ms", "terms", "bits", "kunits", "u/us");
    let steps = STEPS.map(|step| format!(" | {step:^38}")).concat();
    format!("{:>6}{steps}\n{:>6}{}", "", "degree", format!(" | {columns}").repeat(STEPS.len()))
}

/// The exponents of a family, as text.
pub(crate) fn exponents(rows: &[Row]) -> String {
    let texts = by_degree(rows).map(|exponent| format!(" | {:>10}{:28}", shown(exponent), ""));
    format!("{:>6}{}", "power", texts.concat())
}

/// The exponent for each step: time as a power of the path's degree.
fn by_degree(rows: &[Row]) -> [Option<f64>; 3] {
    std::array::from_fn(|i| {
        let point = |row: &Row| Some((f64::from(row.degree), row.steps[i]?.milliseconds()));
        exponent(&rows.iter().filter_map(point).collect::<Vec<_>>())
    })
}

/// The exponent for each step: time as a power of the field's degree, for paths of the given degree.
fn by_field(families: &[&Measured<'_>], degree: u32) -> [Option<f64>; 3] {
    std::array::from_fn(|i| {
        let point = |(family, rows): &&Measured<'_>| {
            let row = rows.iter().find(|row| row.degree == degree)?;
            Some((f64::from(family.field_degree()), row.steps[i]?.milliseconds()))
        };
        exponent(&families.iter().filter_map(point).collect::<Vec<_>>())
    })
}

fn shown(exponent: Option<f64>) -> String {
    exponent.map_or_else(|| "–".to_owned(), |exponent| format!("{exponent:.1}"))
}

/// What stands before the tables.
const INTRODUCTION: &str = "\
# How work grows

What the oriented translation FN (17) of the arc FN (16) costs along PH curves of rising degree n, with coefficients of the preimage
of several kinds: the coordinates W, X, Y, Z from these coefficients; the normal, whose components are certified to be coprime; the
homogeneous coordinates of the offset by a symbol r, which begin with the square root of |N|². For each step the tables hold the least
time of several runs (milliseconds, optimized, one thread of a virtual x86-64 machine), the terms of all polynomials of
the result together, the bits of its largest coefficient, and thousands of units of the [`budget`]. Random coefficients come from a
fixed stream. Times are measured, all else is the same everywhere:

```text
cargo run --release -p hodograph-algebra --example growth -- --write
```

What all families have in common: W, X, Y, Z are sums of products of the position, the normal and the denominators σ and 1 + u²,
which stay factors; that nothing more cancels is seen from images modulo one prime. The normal is found from the
directions of the derivatives, whose lengths are never multiplied out. The root of |N|² is lifted from roots modulo primes,
and its square decides. So a step costs a few products and exact quotients of its own operands: the number of pairs of
terms, times the product of the lengths of their coefficients in words once these exceed one.
";

/// The document with all tables.
pub(crate) fn markdown(families: &[Measured<'_>]) -> String {
    let mut parts = vec![INTRODUCTION.to_owned()];
    for (family, rows) in families {
        parts.push(format!("## {}\n\n{}\n\n{}", family.title, family.explanation, table(rows)));
    }
    parts.push(fields(families));
    parts.push(units(families));
    parts.join("\n")
}

fn table(rows: &[Row]) -> String {
    let columns = STEPS.map(|step| format!(" {step}: ms | terms | bits | units/1000 |")).concat();
    let rule = "---: |".repeat(1 + 4 * STEPS.len());
    let cells = |step: &Option<Step>| match step {
        None => " | | | |".to_owned(),
        Some(step) => {
            let units = step.units.div_ceil(1000);
            format!(" {} | {} | {} | {units} |", significant(step.milliseconds()), step.terms, step.bits)
        }
    };
    let line = |row: &Row| format!("| {} |{}\n", row.degree, row.steps.iter().map(cells).collect::<String>());
    let powers = by_degree(rows).map(|exponent| format!(" n^{} | | | |", shown(exponent))).concat();
    let lines: String = rows.iter().map(line).collect();
    let end =
        rows.iter().find_map(|row| row.end.as_ref()).map(|end| format!("\nThe last one was left: {end}.\n"));
    format!("| n |{columns}\n| {rule}\n{lines}| fit |{powers}\n{}", end.unwrap_or_default())
}

/// Three digits, or all before the point.
fn significant(value: f64) -> String {
    let digits = if value < 1.0 {
        3
    } else if value < 10.0 {
        2
    } else {
        usize::from(value < 100.0)
    };
    format!("{value:.digits$}")
}

/// The kinds of coefficients that there are over fields of several degrees.
const KINDS: [(&str, [&str; 4]); 3] = [
    ("integers, square roots", ["rational-small", "field-2-small", "field-4-small", "field-8-small"]),
    ("integers, nested roots", ["rational-small", "field-2-small", "tower-4", "tower-8"]),
    ("rationals, square roots", ["rational-20", "field-2-20", "field-4-20", "field-8-20"]),
];

fn fields(families: &[Measured<'_>]) -> String {
    let mut text = "## The degree of the field\n\n\
        The exponent p with which the time grows as dᵖ with the degree d = 1, 2, 4, 8 of the field. A number has d coordinates,\n\
        and a product of numbers d² products of coordinates: that is the exponent 2 of short coefficients. To make the weight rational at the\n\
        domain's beginning, as the homogeneous coordinates are scaled, takes a product with d − 1 conjugates, which makes long\n\
        coefficients d times longer, and a product of these d² times as slow: exponents between 2 and 4.\n\n\
        | coefficients | n | W, X, Y, Z | normal | offset |\n| --- | ---: | ---: | ---: | ---: |\n"
        .to_owned();
    for (kind, names) in KINDS {
        let chosen: Vec<&Measured<'_>> =
            families.iter().filter(|(family, _)| names.contains(&family.name)).collect();
        for degree in chosen.last().map_or(&[][..], |(family, _)| family.degrees) {
            let cells = by_field(&chosen, *degree).map(|exponent| format!(" {} |", shown(exponent))).concat();
            text += &format!("| {kind} | {degree} |{cells}\n");
        }
    }
    text
}

fn units(families: &[Measured<'_>]) -> String {
    let steps = families.iter().flat_map(|(_, rows)| rows).flat_map(|row| row.steps.iter().flatten());
    let mut rates: Vec<f64> = steps.map(Step::rate).collect();
    rates.sort_by(f64::total_cmp);
    let [least, .., most] = rates.as_slice() else { return String::new() };
    let middle = rates[rates.len() / 2];
    format!(
        "## Units of the budget\n\n\
         A microsecond of all these steps is {least:.0} to {most:.0} units, {middle:.0} in the median; nominally it is some 30, and\n\
         [`budget::DEFAULT_LIMIT`] some ten seconds. Few units in a microsecond are those of the smallest operands, where all time\n\
         goes into setting up; many are the trials of primes that were remembered.\n"
    )
}
