//! The control net of a member of a family in Rust, and the check of its curves' speeds.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::{Coefficients, Form, Statement, Term, conditions, terms};
use crate::emit::Artifact;
use crate::emit::body::{literal, number};
use crate::emit::code::Code;
use crate::emit::expression::Expression;
use crate::program::Input;

/// The function that computes the control net from the homogeneous coordinates.
pub(in crate::emit) fn net(artifact: &Artifact, code: &Code<'_>) -> TokenStream {
    let runtime = code.runtime;
    let (m, n) = (artifact.degree.0 as usize, artifact.degree.1 as usize);
    let computation = terms(artifact, code);
    let statements = computation.statements.iter().map(|line| statement(code, line));
    let sums = computation.result.iter().map(|term| {
        let Term { coordinate, negative, numbers, u, v } = term;
        let coordinate = Literal::usize_unsuffixed(*coordinate);
        let sign = negative.then(|| quote! { - });
        let mut numbers = numbers.iter().map(|factor| number(code, factor));
        let first = numbers.next().unwrap_or_else(|| literal(1.0));
        let [u, v] = [(u, m), (v, n)].map(|(factor, degree)| match factor {
            Some(factor) => coefficients(code, factor),
            None => {
                let length = Literal::usize_unsuffixed(degree + 1);
                quote! { [1.0; #length] }
            }
        });
        quote! { #runtime::bernstein::accumulate(&mut net, #coordinate, #sign #first #(* #numbers)*, &#u, &#v); }
    });
    let length = Literal::usize_unsuffixed((m + 1) * (n + 1));
    quote! {
        /// The control net over the domain.
        fn net(&self) -> [[f64; 4]; #length] {
            #(#statements)*
            let mut net = [[0.0; 4]; #length];
            #(#sums)*
            net
        }
    }
}

/// The function that certifies parametric speeds to be positive on the domain, if values of symbols decide on that.
pub(in crate::emit) fn speeds(code: &Code<'_>) -> Option<TokenStream> {
    let runtime = code.runtime;
    let conditions = conditions(code);
    let checks = conditions.iter().map(|condition| {
        let statements = condition.statements.iter().map(|line| statement(code, line));
        let coefficients = coefficients(code, &condition.result);
        quote! { {
            #(#statements)*
            #runtime::family::check_speed(&#coefficients)?;
        } }
    });
    (!conditions.is_empty()).then(|| {
        quote! {
            /// Checks that the curves have positive parametric speeds.
            fn check_speeds(&self) -> ::core::result::Result<(), #runtime::ParameterError> {
                #(#checks)*
                ::core::result::Result::Ok(())
            }
        }
    })
}

/// The Bernstein coefficients as an array.
fn coefficients(code: &Code<'_>, coefficients: &Coefficients) -> TokenStream {
    match coefficients {
        Coefficients::Number(expression) => {
            let number = number(code, expression);
            quote! { [#number] }
        }
        Coefficients::Polynomial(name, _) => {
            let name = Ident::new(name, Span::call_site());
            quote! { #name }
        }
    }
}

fn statement(code: &Code<'_>, Statement { name, degree, form }: &Statement) -> TokenStream {
    let runtime = code.runtime;
    let array = |operand: &Coefficients| coefficients(code, operand);
    let value = match form {
        Form::Parameter(Input::U) => quote! { Self::DOMAIN.u },
        Form::Parameter(_) => quote! { Self::DOMAIN.v },
        Form::Scaled(a, factor) => {
            let (a, factor) = (array(a), number(code, factor));
            quote! { #runtime::bernstein::scaled(&#a, #factor) }
        }
        Form::Sum(a, b, negative) => {
            let (a, b, sign) = (array(a), array(b), literal(if *negative { -1.0 } else { 1.0 }));
            quote! { #runtime::bernstein::sum(&#a, &#b, #sign) }
        }
        Form::Product(a, b) => {
            let (a, b) = (array(a), array(b));
            quote! { #runtime::bernstein::product(&#a, &#b) }
        }
        Form::Elevated(a) => {
            let a = array(a);
            quote! { #runtime::bernstein::elevated(&#a) }
        }
        Form::Horner(value, numbers, base) => {
            let base = array(base);
            let coefficients = code.array(*value).unwrap_or_else(|| {
                let numbers = numbers.iter().map(|expression: &Expression| number(code, expression));
                quote! { [#(#numbers),*] }
            });
            quote! { #runtime::bernstein::horner(&#coefficients, &#base) }
        }
    };
    let (name, length) = (Ident::new(name, Span::call_site()), Literal::usize_unsuffixed(degree + 1));
    quote! { let #name: [f64; #length] = #value; }
}
