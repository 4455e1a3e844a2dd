//! What a surface computes of u alone, of v alone, and of both.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::body::{literal, write};
use super::code::{Code, Mode};
use super::expression::{Body, Expression};
use super::rust::doc;
use super::task::{TASKS, Task};
use crate::program::{Input, Operation, Program, Stage, Value};

/// The values of one parameter that a task's last stage reads.
pub(super) struct Frontier {
    pub(super) u: Vec<Value>,
    pub(super) v: Vec<Value>,
}

impl Frontier {
    pub(super) fn of(program: &Program<f64>, results: &[Value]) -> Frontier {
        let mut parts = [BTreeSet::new(), BTreeSet::new()];
        let mut add = |value: Value| {
            // Signs are changed where they are needed.
            let value = match *program.operation(value) {
                Operation::Negate(a) if program.stage(a) > Stage::Symbols => a,
                _ => value,
            };
            match program.stage(value) {
                Stage::U => _ = parts[0].insert(value),
                Stage::V => _ = parts[1].insert(value),
                Stage::Constant | Stage::Symbols | Stage::Both => {}
            }
        };
        results.iter().for_each(|&result| add(result));
        for value in program.needed(results) {
            if program.stage(value) == Stage::Both {
                program.operation(value).operands().into_iter().for_each(&mut add);
            }
        }
        let [u, v] = parts.map(|values| values.into_iter().collect());
        Frontier { u, v }
    }
}

/// The constant arrays of coefficients.
pub(super) fn constants(code: &Code<'_>) -> TokenStream {
    /// The longest formula that documentation shows.
    const LONGEST: usize = 100;
    let array = |(name, value, numbers): &(Ident, Value, Vec<f64>)| {
        let table = super::chain::table_of(code.program, *value);
        let formula = table.filter(|table| table.formula.len() <= LONGEST);
        let letter = if code.program.stage(*value) == Stage::U { "u" } else { "v" };
        let text = match (table, formula) {
            (_, Some(table)) => format!("`{} = {}`", table.name, table.formula),
            (Some(table), None) => format!("The polynomial `{}` of {letter}.", table.name),
            (None, None) => format!("A polynomial of {letter}."),
        };
        let whole = table.is_some_and(|table| table.value == *value);
        let docs = if whole {
            doc([text.as_str()])
        } else {
            doc([&text, "", "Without its factor that is a power of the parameter."])
        };
        let length = Literal::usize_unsuffixed(numbers.len());
        let numbers = numbers.iter().map(|&number| literal(number));
        quote! { #docs const #name: [f64; #length] = [#(#numbers),*]; }
    };
    code.constants.iter().map(array).collect()
}

/// The structs of stage values and the functions that compute them; then the stages of each task.
pub(super) fn stages(name: &Ident, code: &Code<'_>) -> (TokenStream, TokenStream, TokenStream) {
    let frontiers: Vec<Frontier> =
        TASKS.iter().map(|task| Frontier::of(code.program, &task.results(code.program))).collect();
    let union = |part: fn(&Frontier) -> &Vec<Value>| -> Vec<Value> {
        let all: BTreeSet<Value> =
            frontiers.iter().flat_map(|frontier| part(frontier).iter().copied()).collect();
        all.into_iter().collect()
    };
    let parts = [
        Part { input: Input::U, letter: "u", values: union(|frontier| &frontier.u), owner: name },
        Part { input: Input::V, letter: "v", values: union(|frontier| &frontier.v), owner: name },
    ];
    let structs = parts.iter().map(|part| part.definition(code)).collect();
    let functions = parts.iter().map(|part| part.function(code)).collect();
    let implementations = TASKS
        .iter()
        .zip(&frontiers)
        .map(|(task, frontier)| implementation(name, code, task, frontier))
        .collect();
    (structs, functions, implementations)
}

/// All that tasks need of one parameter.
struct Part<'a> {
    input: Input,
    letter: &'a str,
    values: Vec<Value>,
    owner: &'a Ident,
}

impl Part<'_> {
    fn type_name(&self) -> Ident {
        let usual = format!("Of{}", self.letter.to_uppercase());
        let name = if *self.owner == usual { format!("Values{usual}") } else { usual };
        Ident::new(&name, Span::call_site())
    }

    fn definition(&self, code: &Code<'_>) -> TokenStream {
        if self.values.is_empty() {
            return TokenStream::new();
        }
        let name = self.type_name();
        let text = format!("What points need of {} alone.", self.letter);
        let docs = doc([text.as_str()]);
        let fields = self.values.iter().map(|&value| ident(&code.names.of(code.program, value)));
        quote! {
            #docs
            struct #name<R> {
                #(#fields: R),*
            }
        }
    }

    fn function(&self, code: &Code<'_>) -> TokenStream {
        if self.values.is_empty() {
            return TokenStream::new();
        }
        let (name, runtime) = (self.type_name(), code.runtime);
        let function = function_name(self.letter);
        let body = code.body(&self.values, &BTreeMap::new());
        let parameter = parameter(&body, self.input);
        let (statements, results) = write(code, Mode::Generic, &body);
        let fields = self.values.iter().zip(&results).map(|(&value, result)| {
            let field = ident(&code.names.of(code.program, value));
            if field == result.to_string() {
                quote! { #field }
            } else {
                quote! { #field: #result }
            }
        });
        let receiver = receiver(code);
        let text = format!("What points need of {} alone.", self.letter);
        let docs = doc([text.as_str()]);
        quote! {
            #docs
            #[inline(always)]
            fn #function<R: #runtime::Real>(#receiver #parameter: R) -> #name<R> {
                #statements
                #name { #(#fields),* }
            }
        }
    }
}

fn ident(name: &str) -> Ident {
    Ident::new(name, Span::call_site())
}

fn function_name(letter: &str) -> Ident {
    Ident::new(&format!("values_of_{letter}"), Span::call_site())
}

/// The receiver of private functions, which only a family needs.
fn receiver(code: &Code<'_>) -> TokenStream {
    if code.is_family() {
        quote! { &self, }
    } else {
        TokenStream::new()
    }
}

/// The stages of one task.
fn implementation(name: &Ident, code: &Code<'_>, task: &Task, frontier: &Frontier) -> TokenStream {
    let (program, runtime) = (code.program, code.runtime);
    let results = task.results(program);
    let marker = Ident::new(task.name, Span::call_site());
    let of = |values: &[Value], letter: &str| {
        let parameter = Ident::new(letter, Span::call_site());
        if values.is_empty() {
            let unused = Ident::new(&format!("_{letter}"), Span::call_site());
            return quote! { (&self, #unused: R) -> [R; 0] { [] } };
        }
        let fields = values.iter().map(|&value| ident(&code.names.of(program, value)));
        let (size, function) = (Literal::usize_unsuffixed(values.len()), function_name(letter));
        let call = if code.is_family() {
            quote! { self.#function }
        } else {
            quote! { Self::#function }
        };
        quote! { (&self, #parameter: R) -> [R; #size] {
            let values = #call(#parameter);
            [#(values.#fields),*]
        } }
    };
    let (of_u, of_v) = (of(&frontier.u, "u"), of(&frontier.v, "v"));
    let named = |&value: &Value| (value, Expression::Variable(code.names.of(program, value)));
    let given: BTreeMap<Value, Expression> = frontier.u.iter().chain(&frontier.v).map(named).collect();
    let (statements, joined) = write(code, Mode::Generic, &code.body(&results, &given));
    let names = |values: &[Value]| -> Vec<Ident> {
        values.iter().map(|&value| ident(&code.names.of(program, value))).collect()
    };
    let (names_u, names_v) = (names(&frontier.u), names(&frontier.v));
    let [size_u, size_v, size] =
        [frontier.u.len(), frontier.v.len(), results.len()].map(Literal::usize_unsuffixed);
    quote! {
        impl #runtime::Stages<#runtime::#marker> for #name {
            type OfU<R: ::core::marker::Copy + ::core::default::Default> = [R; #size_u];
            type OfV<R: ::core::marker::Copy + ::core::default::Default> = [R; #size_v];
            #[inline(always)]
            fn of_u<R: #runtime::Real> #of_u
            #[inline(always)]
            fn of_v<R: #runtime::Real> #of_v
            #[inline(always)]
            fn join<R: #runtime::Real>(&self, of_u: [R; #size_u], of_v: [R; #size_v]) -> [R; #size] {
                let [#(#names_u),*] = of_u;
                let [#(#names_v),*] = of_v;
                #statements
                [#(#joined),*]
            }
        }
    }
}

/// The name of a parameter, with an underscore if the body does not read it.
fn parameter(body: &Body, input: Input) -> Ident {
    let name = match (input, body.inputs.contains(&input)) {
        (Input::U, true) => "u",
        (Input::U, false) => "_u",
        (_, true) => "v",
        (_, false) => "_v",
    };
    Ident::new(name, Span::call_site())
}
