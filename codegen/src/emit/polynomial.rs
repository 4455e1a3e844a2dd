//! Functions for the polynomials of one parameter that a surface is made of.

use std::collections::BTreeMap;

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::body::{Body, literal};
use super::code::Code;
use crate::program::{Operation, Program, Stage, Table, Value};

/// The names of the functions for those polynomials whose coefficients are too long to stand in a formula.
pub(super) fn functions(program: &Program<f64>) -> BTreeMap<Value, Ident> {
    // What the items of a surface are called otherwise.
    const TAKEN: [&str; 21] = [
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
        "new",
        "parameters",
        "coefficients",
        "net",
        "check_speeds",
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
pub(super) fn polynomials(code: &Code<'_>) -> TokenStream {
    let tables = code.program.tables().iter().filter(|table| code.functions.contains_key(&table.value));
    tables.map(|table| polynomial(code, table)).collect()
}

/// The function of a polynomial: its coefficients, then Horner's scheme.
fn polynomial(code: &Code<'_>, table: &Table) -> TokenStream {
    let program = code.program;
    let name = &code.functions[&table.value];
    let mut given = BTreeMap::new();
    let symbolic = is_symbolic(program, table);
    for (place, &coefficient) in table.coefficients.iter().enumerate().filter(|_| !symbolic) {
        let place = Literal::usize_unsuffixed(place);
        given.entry(coefficient).or_insert_with(|| quote! { C[#place] });
    }
    let Body { statements, results, .. } = code.within(table.value).body_given(&[table.value], &given);
    let coefficients = table.coefficients.iter().filter_map(|&coefficient| constant(program, coefficient));
    let length = Literal::usize_unsuffixed(table.coefficients.len());
    let letter = if program.stage(table.value) == Stage::U { "u" } else { "v" };
    let parameter = Ident::new(letter, Span::call_site());
    let text = if table.formula.len() <= LONGEST {
        format!(" `{} = {}`", table.name, table.formula)
    } else {
        format!(" The polynomial `{}` of {letter}.", table.name)
    };
    let receiver = code.receiver();
    let table = (!symbolic).then(|| quote! { const C: [f64; #length] = [#(#coefficients),*]; });
    quote! {
        #[doc = #text]
        #[inline]
        fn #name(#receiver #parameter: f64) -> f64 {
            #table
            #statements
            #(#results)*
        }
    }
}

/// The longest formula that documentation shows.
const LONGEST: usize = 100;

/// Whether a coefficient depends on symbols.
fn is_symbolic(program: &Program<f64>, table: &Table) -> bool {
    table.coefficients.iter().any(|&coefficient| program.stage(coefficient) == Stage::Symbols)
}

/// Whether a coefficient is too long for a formula, or known at run time only.
fn is_long(program: &Program<f64>, table: &Table) -> bool {
    let mut constants = table.coefficients.iter().filter_map(|&coefficient| constant(program, coefficient));
    is_symbolic(program, table) || constants.any(|c| c.to_string().len() > 6)
}

fn constant(program: &Program<f64>, value: Value) -> Option<TokenStream> {
    match program.operation(value) {
        Operation::Constant(constant) => Some(literal(*constant)),
        _ => None,
    }
}
