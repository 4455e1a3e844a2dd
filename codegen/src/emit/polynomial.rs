//! Functions for the polynomials of one parameter that a surface is made of.

use std::collections::BTreeMap;

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::body::{Body, literal};
use crate::program::{Operation, Program, Stage, Table, Value};

/// The names of the functions for those polynomials whose coefficients are too long to stand in a formula.
pub(super) fn functions(program: &Program<f64>) -> BTreeMap<Value, Ident> {
    // What the items of a surface are called otherwise.
    const TAKEN: [&str; 16] = [
        "homogeneous",
        "point",
        "partial_u",
        "partial_v",
        "unit_normal",
        "speed_u",
        "speed_v",
        "offset_point",
        "grid",
        "of_u",
        "of_v",
        "join",
        "name",
        "degree",
        "domain",
        "control_net",
    ];
    let long = program.tables().iter().filter(|table| is_long(program, table));
    long.map(|table| {
        let name = &table.name;
        let name = if TAKEN.contains(&name.as_str()) { format!("{name}_polynomial") } else { name.clone() };
        (table.value, Ident::new(&name, Span::call_site()))
    })
    .collect()
}

/// The functions of all polynomials that have one.
pub(super) fn polynomials(program: &Program<f64>, runtime: &TokenStream) -> TokenStream {
    let functions = functions(program);
    let tables = program.tables().iter().filter(|table| functions.contains_key(&table.value));
    tables.map(|table| polynomial(program, table, &functions, runtime)).collect()
}

/// The function of a polynomial: its coefficients, then Horner's scheme.
fn polynomial(
    program: &Program<f64>,
    table: &Table,
    functions: &BTreeMap<Value, Ident>,
    runtime: &TokenStream,
) -> TokenStream {
    let name = &functions[&table.value];
    let mut others = functions.clone();
    others.remove(&table.value);
    let mut given = BTreeMap::new();
    for (place, &coefficient) in table.coefficients.iter().enumerate() {
        let place = Literal::usize_unsuffixed(place);
        given.entry(coefficient).or_insert_with(|| quote! { C[#place] });
    }
    let Body { statements, results, .. } = Body::new(program, &[table.value], &given, &others, runtime);
    let coefficients = table.coefficients.iter().filter_map(|&coefficient| constant(program, coefficient));
    let length = Literal::usize_unsuffixed(table.coefficients.len());
    let letter = if program.stage(table.value) == Stage::U { "u" } else { "v" };
    let parameter = Ident::new(letter, Span::call_site());
    let text = if table.formula.len() <= LONGEST {
        format!(" `{} = {}`", table.name, table.formula)
    } else {
        format!(" The polynomial `{}` of {letter}.", table.name)
    };
    quote! {
        #[doc = #text]
        #[inline]
        fn #name(#parameter: f64) -> f64 {
            const C: [f64; #length] = [#(#coefficients),*];
            #statements
            #(#results)*
        }
    }
}

/// The longest formula that documentation shows.
const LONGEST: usize = 100;

/// Whether a coefficient is too long for a formula.
fn is_long(program: &Program<f64>, table: &Table) -> bool {
    table
        .coefficients
        .iter()
        .filter_map(|&coefficient| constant(program, coefficient))
        .any(|c| c.to_string().len() > 6)
}

fn constant(program: &Program<f64>, value: Value) -> Option<TokenStream> {
    match program.operation(value) {
        Operation::Constant(constant) => Some(literal(*constant)),
        _ => None,
    }
}
