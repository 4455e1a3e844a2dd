//! The body of a generated function: named values, then expressions.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::code::Code;
use crate::program::{Input, Operation, Program, Stage, Value};

/// How tightly an expression binds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Sign,
    Atom,
}

/// The body of a function that computes some values of a program.
pub(super) struct Body {
    /// `let` statements for values that have a name or occur more than once.
    pub(super) statements: TokenStream,
    /// The results.
    pub(super) results: Vec<TokenStream>,
    /// The parameters that occur.
    pub(super) inputs: BTreeSet<Input>,
}

impl Body {
    /// The body that computes `results` where the values `given` have expressions already.
    pub(super) fn new(code: &Code<'_>, results: &[Value], given: &BTreeMap<Value, TokenStream>) -> Body {
        let Code { program, functions, names, .. } = code;
        let known = |value: Value| given.contains_key(&value) || functions.contains_key(&value);
        let needed = needed(program, results, known);
        let mut uses: BTreeMap<Value, usize> = BTreeMap::new();
        let computed = needed.iter().filter(|&&value| !known(value));
        let operands = computed.flat_map(|&value| program.operation(value).operands());
        for value in operands.chain(results.iter().copied()) {
            *uses.entry(value).or_default() += 1;
        }
        let mut writer = Writer { code, program, variables: given.clone(), inputs: BTreeSet::new() };
        let mut statements = TokenStream::new();
        for value in needed {
            let repeated = uses.get(&value).is_some_and(|&count| count > 1);
            // A single result is returned without being named first.
            let named = program.name_of(value).is_some() && results != [value];
            let leaf = matches!(program.operation(value), Operation::Constant(_) | Operation::Input(_));
            if given.contains_key(&value) || leaf || !(repeated || named) {
                continue;
            }
            let expression = writer.expression(value).0;
            let variable = names.of(program, value);
            statements.extend(quote! { let #variable = #expression; });
            writer.variables.insert(value, quote! { #variable });
        }
        let results = results.iter().map(|&result| writer.value(result).0).collect();
        Body { statements, results, inputs: writer.inputs }
    }
}

/// The variable that holds a symbol.
pub(super) fn symbol(name: &str) -> Ident {
    // Words that are no identifiers of their own, in any edition, and patterns that mean something else.
    const TAKEN: [&str; 5] = ["Err", "None", "Ok", "Some", "gen"];
    let name = match syn::parse_str::<Ident>(name) {
        Ok(_) if !TAKEN.contains(&name) => name.to_string(),
        _ => format!("{name}_"),
    };
    Ident::new(&name, Span::call_site())
}

/// The names of variables: those of the program, and numbered ones that no value of the program has.
pub(super) struct Names(BTreeSet<String>);

impl Names {
    pub(super) fn new(program: &Program<f64>) -> Names {
        let named = program.values().filter_map(|value| program.name_of(value)).map(str::to_string);
        let symbols = program.symbols().iter().map(|name| symbol(name).to_string());
        Names(named.chain(symbols).collect())
    }

    /// The variable for `value`.
    pub(super) fn of(&self, program: &Program<f64>, value: Value) -> Ident {
        let name = match (program.operation(value), program.name_of(value)) {
            (Operation::Input(Input::U), _) => "u".to_string(),
            (Operation::Input(Input::V), _) => "v".to_string(),
            (Operation::Input(Input::Symbol(place)), _) => {
                return symbol(&program.symbols()[*place as usize]);
            }
            (_, Some(name)) if ["u", "v", "of_u", "of_v"].contains(&name) => format!("{name}_value"),
            (_, Some(name)) => name.to_string(),
            (_, None) => {
                let mut name = format!("t{}", value.index());
                while self.0.contains(&name) {
                    name.push('_');
                }
                name
            }
        };
        Ident::new(&name, Span::call_site())
    }
}

/// The values that `results` are computed from, in order; what those `known` are computed from is not among them.
fn needed(program: &Program<f64>, results: &[Value], known: impl Fn(Value) -> bool) -> Vec<Value> {
    let mut wanted = BTreeSet::new();
    let mut open: Vec<Value> = results.to_vec();
    while let Some(value) = open.pop() {
        if wanted.insert(value) && !known(value) {
            open.extend(program.operation(value).operands());
        }
    }
    wanted.into_iter().collect()
}

struct Writer<'a> {
    code: &'a Code<'a>,
    program: &'a Program<f64>,
    variables: BTreeMap<Value, TokenStream>,
    inputs: BTreeSet<Input>,
}

impl Writer<'_> {
    /// The variable that holds a value, or its expression.
    fn value(&mut self, value: Value) -> (TokenStream, Binding) {
        match self.variables.get(&value) {
            Some(variable) => (variable.clone(), Binding::Atom),
            None => self.expression(value),
        }
    }

    /// The expression that computes a value, also where a variable holds it.
    fn expression(&mut self, value: Value) -> (TokenStream, Binding) {
        if let Some(function) = self.code.functions.get(&value) {
            let input = if self.program.stage(value) == Stage::U { Input::U } else { Input::V };
            let (parameter, path) = (self.input(input), self.code.path(function));
            return (quote! { #path(#parameter) }, Binding::Atom);
        }
        match *self.program.operation(value) {
            Operation::Constant(constant) => constant_expression(constant),
            Operation::Input(input) => (self.input(input), Binding::Atom),
            Operation::Add(a, b) => {
                let left = self.within(a, Binding::Sum);
                if let Some(magnitude) = self.negative_literal(b) {
                    return (quote! { #left - #magnitude }, Binding::Sum);
                }
                let right = self.within(b, Binding::Product);
                (quote! { #left + #right }, Binding::Sum)
            }
            Operation::Subtract(a, b) => {
                let (left, right) = (self.within(a, Binding::Sum), self.within(b, Binding::Product));
                (quote! { #left - #right }, Binding::Sum)
            }
            Operation::Multiply(a, b) => {
                let (left, right) = (self.within(a, Binding::Product), self.within(b, Binding::Sign));
                (quote! { #left * #right }, Binding::Product)
            }
            Operation::Divide(a, b) => {
                let (left, right) = (self.within(a, Binding::Product), self.within(b, Binding::Sign));
                (quote! { #left / #right }, Binding::Product)
            }
            Operation::Negate(a) => {
                let inner = self.within(a, Binding::Atom);
                (quote! { -#inner }, Binding::Sign)
            }
            Operation::SquareRoot(a) => {
                let (inner, runtime) = (self.value(a).0, self.code.runtime);
                (quote! { #runtime::float::sqrt(#inner) }, Binding::Atom)
            }
        }
    }

    /// The expression for a value, in parentheses if it binds less than `least`.
    fn within(&mut self, value: Value, least: Binding) -> TokenStream {
        let (expression, binding) = self.value(value);
        if binding < least {
            quote! { (#expression) }
        } else {
            expression
        }
    }

    /// The name of a parameter, which is thereby read, or of a symbol.
    fn input(&mut self, input: Input) -> TokenStream {
        self.inputs.insert(input);
        match input {
            Input::U => quote! { u },
            Input::V => quote! { v },
            Input::Symbol(place) => {
                let name = symbol(&self.program.symbols()[place as usize]);
                quote! { #name }
            }
        }
    }

    /// −c where the value is a negative constant c that is written out.
    fn negative_literal(&self, value: Value) -> Option<TokenStream> {
        match *self.program.operation(value) {
            Operation::Constant(constant) if constant < 0.0 && !self.variables.contains_key(&value) => {
                Some(literal(-constant))
            }
            _ => None,
        }
    }
}

fn constant_expression(constant: f64) -> (TokenStream, Binding) {
    let binding = if constant.is_sign_negative() { Binding::Sign } else { Binding::Atom };
    (literal(constant), binding)
}

/// A float, written with the fewest digits that are read back as the same float.
pub(super) fn literal(value: f64) -> TokenStream {
    let text = format!("{:?}", value.abs());
    let Ok(magnitude) = text.parse::<Literal>() else { unreachable!("`{text}` is a finite float") };
    if value.is_sign_negative() {
        quote! { -#magnitude }
    } else {
        quote! { #magnitude }
    }
}
