//! What all functions of a surface's evaluator share: its program, and the names of its parts.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use super::chain::{Chain, Coefficient, chains, table_of};
use super::expression::{Body, Expression};
use super::names::Names;
use super::task::all_results;
use crate::program::{Operation, Program, Stage, Value};
use crate::schedule::outputs;

/// Over what a function's code computes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Mode {
    /// Any `R` that is `Real`.
    Generic,
    /// `f64` in the plain variant.
    Plain,
}

/// Coefficients of a member that have a common name.
pub(super) struct Field<'a> {
    pub(super) name: &'a Ident,
    pub(super) numbers: Vec<Number>,
}

/// A coefficient of a member of a family.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Number {
    /// The computed value at this place.
    Computed(usize),
    /// A number that is the same for all members.
    Constant(f64),
}

/// A program on its way to source text.
pub(super) struct Code<'a> {
    pub(super) program: &'a Program<f64>,
    /// The path of the runtime.
    pub(super) runtime: &'a TokenStream,
    /// Polynomials that are evaluated by Horner's scheme in one call.
    pub(super) chains: BTreeMap<Value, Chain>,
    /// The arrays of `f64` coefficients of those chains that have one: their names, and whether they are constants.
    pub(super) arrays: BTreeMap<Value, (Ident, bool)>,
    /// Arrays of numbers that are constants, by name.
    pub(super) constants: Vec<(Ident, Value, Vec<f64>)>,
    /// The coefficients that a member of a family keeps, by groups that have a name.
    pub(super) fields: Vec<(Ident, Vec<Coefficient>)>,
    /// The `f64` values that are kept: the coefficients of a family.
    pub(super) kept: BTreeMap<Value, (Ident, usize)>,
    /// The names of variables.
    pub(super) names: Names,
}

impl<'a> Code<'a> {
    pub(super) fn new(program: &'a Program<f64>, runtime: &'a TokenStream) -> Code<'a> {
        let results: Vec<Value> =
            all_results(program).into_iter().chain(program.results(outputs::CONDITIONS).to_vec()).collect();
        let chains = chains(program, &results);
        let ident = |name: &str| Ident::new(name, Span::call_site());
        let (mut arrays, mut constants) = (BTreeMap::new(), Vec::new());
        let mut fields: Vec<(Ident, Vec<Coefficient>)> = Vec::new();
        let mut names = BTreeSet::new();
        for (&value, chain) in &chains {
            let Some(table) = table_of(program, value) else { continue };
            if !names.insert(&table.name) {
                continue;
            }
            let number = |coefficient: &Coefficient| match coefficient {
                Coefficient::One => Some(1.0),
                Coefficient::MinusOne => Some(-1.0),
                Coefficient::Value(value) => match program.operation(*value) {
                    Operation::Constant(constant) => Some(*constant),
                    _ => None,
                },
            };
            let numbers: Option<Vec<f64>> = chain.coefficients.iter().map(number).collect();
            if let Some(numbers) = numbers {
                let name = ident(&table.name.to_uppercase());
                arrays.insert(value, (name.clone(), true));
                constants.push((name, value, numbers));
            } else {
                let name = ident(&table.name);
                arrays.insert(value, (name.clone(), false));
                fields.push((name, chain.coefficients.clone()));
            }
        }
        let others = others(program, &results, &fields);
        fields.extend((!others.is_empty()).then(|| (ident("others"), others)));
        let mut kept = BTreeMap::new();
        for (name, values) in &fields {
            for (place, coefficient) in values.iter().enumerate() {
                let Coefficient::Value(value) = coefficient else { continue };
                if matches!(program.operation(*value), Operation::Constant(_)) {
                    continue;
                }
                kept.entry(*value).or_insert_with(|| (name.clone(), place));
            }
        }
        Code { program, runtime, chains, arrays, constants, fields, kept, names: Names::new(program) }
    }

    /// Whether the surface has coefficients of its own.
    pub(super) fn is_family(&self) -> bool {
        !self.program.symbols().is_empty()
    }

    /// The body that computes `results`, where the values `given` have expressions and coefficients are kept.
    pub(super) fn body(&self, results: &[Value], given: &BTreeMap<Value, Expression>) -> Body {
        let kept = self.kept.keys().map(|&value| (value, Expression::Kept(value)));
        let all = kept.chain(given.iter().map(|(value, expression)| (*value, expression.clone())));
        Body::new(self, results, &all.collect())
    }

    /// The values that are computed once for a member of a family, and the fields that they are kept in.
    pub(super) fn computed(&self) -> (Vec<Value>, Vec<Field<'_>>) {
        let value = |coefficient: &Coefficient| match coefficient {
            Coefficient::Value(value) => Some(*value),
            Coefficient::One | Coefficient::MinusOne => None,
        };
        let all = self.fields.iter().flat_map(|(_, coefficients)| coefficients.iter().filter_map(value));
        let values: Vec<Value> = all.collect::<BTreeSet<_>>().into_iter().collect();
        let number = |coefficient: &Coefficient| match coefficient {
            Coefficient::Value(value) => Number::Computed(values.partition_point(|other| other < value)),
            Coefficient::One => Number::Constant(1.0),
            Coefficient::MinusOne => Number::Constant(-1.0),
        };
        let fields = self.fields.iter();
        let fields =
            fields.map(|(name, all)| Field { name, numbers: all.iter().map(number).collect() }).collect();
        (values, fields)
    }

    /// Whether the coefficients of a chain have an array.
    pub(super) fn has_array(&self, value: Value) -> bool {
        self.arrays.contains_key(&value)
    }

    /// The array of a chain's coefficients.
    pub(super) fn array(&self, value: Value) -> Option<TokenStream> {
        let (name, constant) = self.arrays.get(&value)?;
        Some(if *constant {
            quote! { Self::#name }
        } else {
            quote! { self.coefficients.#name }
        })
    }

    /// The numbers of an array that is constant.
    pub(super) fn constant_array(&self, name: &Ident) -> &[f64] {
        let found = self.constants.iter().find(|(other, ..)| other == name);
        found.map_or(&[], |(.., numbers)| numbers)
    }

    /// The number that a value without parameters is: it has no statements, since it is kept or follows from what is.
    pub(super) fn number(&self, value: Value) -> Expression {
        let mut body = self.body(&[value], &BTreeMap::new());
        body.results.swap_remove(0)
    }
}

/// The values that depend on symbols alone and that evaluators read, without those that have a place in `fields`.
fn others(
    program: &Program<f64>,
    results: &[Value],
    fields: &[(Ident, Vec<Coefficient>)],
) -> Vec<Coefficient> {
    let symbolic = |value: &Value| program.stage(*value) == Stage::Symbols;
    let later = program.needed(results).into_iter().filter(|value| program.stage(*value) > Stage::Symbols);
    let operands = later.flat_map(|value| program.operation(value).operands());
    let read: BTreeSet<Value> = results.iter().copied().chain(operands).filter(symbolic).collect();
    let kept = |value: &Value| fields.iter().any(|(_, values)| values.contains(&Coefficient::Value(*value)));
    read.into_iter().filter(|value| !kept(value)).map(Coefficient::Value).collect()
}
