//! Function bodies in Rust.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::code::{Code, Mode};
use super::expression::{Binding, Body, Expression};
use crate::program::Input;

/// The statements and the results of a body in Rust, over any `R: Real` or over `f64`.
pub(super) fn write(code: &Code<'_>, mode: Mode, body: &Body) -> (TokenStream, Vec<TokenStream>) {
    let writer = Writer { code, mode };
    let statement = |(name, expression): &(String, Expression)| {
        let (name, expression) = (Ident::new(name, Span::call_site()), writer.write(expression).0);
        quote! { let #name = #expression; }
    };
    let statements = body.statements.iter().map(statement).collect();
    (statements, body.results.iter().map(|result| writer.write(result).0).collect())
}

/// A number that depends on no parameter, over `f64`.
pub(super) fn number(code: &Code<'_>, number: &Expression) -> TokenStream {
    Writer { code, mode: Mode::Plain }.write(number).0
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

struct Writer<'a> {
    code: &'a Code<'a>,
    mode: Mode,
}

impl Writer<'_> {
    fn write(&self, expression: &Expression) -> (TokenStream, Binding) {
        match expression {
            Expression::Variable(name) => {
                let name = Ident::new(name, Span::call_site());
                (quote! { #name }, Binding::Atom)
            }
            Expression::Input(Input::U) => (quote! { u }, Binding::Atom),
            Expression::Input(Input::V) => (quote! { v }, Binding::Atom),
            Expression::Input(Input::Symbol(place)) => {
                let name = symbol(&self.code.program.symbols()[*place as usize]);
                (quote! { #name }, Binding::Atom)
            }
            Expression::Kept(value) => {
                let (name, place) = &self.code.kept[value];
                let place = Literal::usize_unsuffixed(*place);
                let kept = quote! { self.coefficients.#name[#place] };
                let number = match self.mode {
                    Mode::Generic => quote! { R::of(#kept) },
                    Mode::Plain => kept,
                };
                (number, Binding::Atom)
            }
            Expression::Constant(constant) => self.constant(*constant),
            Expression::Sum(operands) => self.sum(operands),
            Expression::Difference(operands) => {
                let [a, b] = &**operands;
                let (a, b) = (self.within(a, Binding::Sum), self.within(b, Binding::Product));
                (quote! { #a - #b }, Binding::Sum)
            }
            Expression::Product(operands) => {
                let [a, b] = &**operands;
                match (a, b) {
                    (Expression::Constant(-1.0), other) | (other, Expression::Constant(-1.0))
                        if self.mode == Mode::Plain =>
                    {
                        return self.write(&Expression::Negative(Box::new(other.clone())));
                    }
                    _ => {}
                }
                let (a, b) = (self.within(a, Binding::Product), self.within(b, Binding::Sign));
                (quote! { #a * #b }, Binding::Product)
            }
            Expression::Quotient(operands) => {
                let [a, b] = &**operands;
                let (a, b) = (self.within(a, Binding::Product), self.within(b, Binding::Sign));
                (quote! { #a / #b }, Binding::Product)
            }
            Expression::Negative(a) => {
                let a = self.within(a, Binding::Atom);
                (quote! { -#a }, Binding::Sign)
            }
            // Floats have none of these by themselves, not even roots where there is no standard library.
            Expression::Root(a) if self.mode == Mode::Plain => {
                self.of_floats("root", std::slice::from_ref(a))
            }
            Expression::Orient(operands) if self.mode == Mode::Plain => {
                self.of_floats("orient", &operands[..])
            }
            Expression::Scale(operands) if self.mode == Mode::Plain => self.of_floats("scale", &operands[..]),
            Expression::Root(a) => {
                let a = self.within(a, Binding::Atom);
                (quote! { #a.sqrt() }, Binding::Atom)
            }
            Expression::MultiplyAdd(operands) if self.mode == Mode::Plain => {
                let [a, b, c] = &**operands;
                self.sum(&[Expression::Product(Box::new([a.clone(), b.clone()])), c.clone()])
            }
            Expression::MultiplyAdd(operands) => {
                let [a, b, c] = &**operands;
                let (a, b, c) = (self.within(a, Binding::Atom), self.write(b).0, self.write(c).0);
                (quote! { #a.mul_add(#b, #c) }, Binding::Atom)
            }
            Expression::Orient(operands) => {
                let [a, b] = &**operands;
                let (a, b) = (self.within(a, Binding::Atom), self.write(b).0);
                (quote! { #a.orient(#b) }, Binding::Atom)
            }
            Expression::Scale(operands) => {
                let operands = operands.iter().map(|operand| self.write(operand).0);
                (quote! { R::scale(#(#operands),*) }, Binding::Atom)
            }
            Expression::Horner(value, coefficients, base) => {
                let (runtime, base) = (self.code.runtime, self.write(base).0);
                let horner = match self.code.array(*value) {
                    Some(array) => quote! { #runtime::horner(#runtime::constants(#array), #base) },
                    None => {
                        let coefficients = coefficients.iter().map(|coefficient| self.write(coefficient).0);
                        quote! { #runtime::horner([#(#coefficients),*], #base) }
                    }
                };
                (horner, Binding::Atom)
            }
        }
    }

    /// A call of a function of floats of the runtime.
    fn of_floats(&self, name: &str, operands: &[Expression]) -> (TokenStream, Binding) {
        let (runtime, name) = (self.code.runtime, Ident::new(name, Span::call_site()));
        let operands = operands.iter().map(|operand| self.write(operand).0);
        (quote! { #runtime::family::#name(#(#operands),*) }, Binding::Atom)
    }

    /// a + b
    fn sum(&self, [a, b]: &[Expression; 2]) -> (TokenStream, Binding) {
        let left = self.within(a, Binding::Sum);
        match b {
            Expression::Constant(constant) if *constant < 0.0 => {
                let magnitude = self.constant(-constant).0;
                (quote! { #left - #magnitude }, Binding::Sum)
            }
            _ => {
                let right = self.within(b, Binding::Product);
                (quote! { #left + #right }, Binding::Sum)
            }
        }
    }

    fn constant(&self, constant: f64) -> (TokenStream, Binding) {
        let literal = literal(constant);
        match self.mode {
            Mode::Generic => (quote! { R::of(#literal) }, Binding::Atom),
            Mode::Plain if constant.is_sign_negative() => (literal, Binding::Sign),
            Mode::Plain => (literal, Binding::Atom),
        }
    }

    /// An expression, in parentheses if it binds less than `least`.
    fn within(&self, expression: &Expression, least: Binding) -> TokenStream {
        let (text, binding) = self.write(expression);
        if binding < least {
            quote! { (#text) }
        } else {
            text
        }
    }
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
