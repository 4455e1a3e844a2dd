//! What all functions of a surface's evaluator share: its program, and the names of its parts.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::body::{Body, Names};
use super::polynomial::functions;
use crate::program::{Program, Stage, Value};

/// A program on its way to source text.
pub(super) struct Code<'a> {
    pub(super) program: &'a Program<f64>,
    /// The path of the runtime.
    pub(super) runtime: &'a TokenStream,
    /// The functions of polynomials that have one.
    pub(super) functions: BTreeMap<Value, Ident>,
    /// The coefficients that a member of a family keeps, by groups that have a name.
    pub(super) fields: Vec<(Ident, Vec<Value>)>,
    /// Values that have an expression already: the coefficients of a family.
    pub(super) given: BTreeMap<Value, TokenStream>,
    /// The names of variables.
    pub(super) names: Rc<Names>,
}

impl<'a> Code<'a> {
    pub(super) fn new(program: &'a Program<f64>, runtime: &'a TokenStream) -> Code<'a> {
        let functions = functions(program);
        let fields = fields(program);
        let mut given = BTreeMap::new();
        for (name, values) in &fields {
            for (place, value) in values.iter().enumerate() {
                let place = Literal::usize_unsuffixed(place);
                given.entry(*value).or_insert_with(|| quote! { self.coefficients.#name[#place] });
            }
        }
        Code { program, runtime, functions, fields, given, names: Rc::new(Names::new(program)) }
    }

    /// The same where the function of the polynomial `value` is not to be called, for its own body.
    pub(super) fn within(&self, value: Value) -> Code<'a> {
        let mut functions = self.functions.clone();
        functions.remove(&value);
        let (fields, given, names) = (self.fields.clone(), self.given.clone(), Rc::clone(&self.names));
        Code { functions, fields, given, names, program: self.program, runtime: self.runtime }
    }

    /// Whether the surface has coefficients of its own.
    pub(super) fn is_family(&self) -> bool {
        !self.program.symbols().is_empty()
    }

    /// The body that computes `results`.
    pub(super) fn body(&self, results: &[Value]) -> Body {
        self.body_given(results, &BTreeMap::new())
    }

    /// The body that computes `results` where the values `given` have expressions besides.
    pub(super) fn body_given(&self, results: &[Value], given: &BTreeMap<Value, TokenStream>) -> Body {
        let mut all = self.given.clone();
        all.extend(given.iter().map(|(value, expression)| (*value, expression.clone())));
        Body::new(self, results, &all)
    }

    /// A private function of the surface: what it is called by.
    pub(super) fn path(&self, function: &Ident) -> TokenStream {
        if self.is_family() {
            quote! { self.#function }
        } else {
            quote! { Self::#function }
        }
    }

    /// The receiver of private functions, which only a family needs.
    pub(super) fn receiver(&self) -> TokenStream {
        if self.is_family() {
            quote! { &self, }
        } else {
            TokenStream::new()
        }
    }
}

/// The values that depend on symbols alone and that evaluators read: the coefficients of each polynomial under its name,
/// all others under the name `others`.
fn fields(program: &Program<f64>) -> Vec<(Ident, Vec<Value>)> {
    let symbolic = |value: &Value| program.stage(*value) == Stage::Symbols;
    let ident = |name: &str| Ident::new(name, Span::call_site());
    let tables = program.tables().iter().filter(|table| table.coefficients.iter().any(symbolic));
    let mut fields: Vec<(Ident, Vec<Value>)> =
        tables.map(|table| (ident(&table.name), table.coefficients.clone())).collect();
    let results = program.outputs().iter().flat_map(|output| output.values.iter().copied());
    let later = program.values().filter(|value| program.stage(*value) > Stage::Symbols);
    let read: BTreeSet<Value> =
        results.chain(later.flat_map(|value| program.operation(value).operands())).filter(symbolic).collect();
    let kept = |value: &Value| fields.iter().any(|(_, values)| values.contains(value));
    let others: Vec<Value> = read.into_iter().filter(|value| !kept(value)).collect();
    if !others.is_empty() {
        fields.push((ident("others"), others));
    }
    fields
}
