//! The control net of a member of a family: its polynomials, computed in the Bernstein basis at run time.

use std::collections::BTreeMap;

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, quote};

use super::Artifact;
use super::body::literal;
use super::chain::Coefficient;
use super::code::Code;
use crate::program::{Input, Operation, Stage, Term, Value};
use crate::schedule::outputs;

/// The function that computes the control net from the homogeneous coordinates.
pub(super) fn net(artifact: &Artifact, code: &Code<'_>) -> TokenStream {
    let runtime = code.runtime;
    let (m, n) = (artifact.degree.0 as usize, artifact.degree.1 as usize);
    let mut writer = Writer::new(code);
    let mut sums = TokenStream::new();
    for (coordinate, &result) in code.program.results(outputs::HOMOGENEOUS).iter().enumerate() {
        let Some(terms) = code.program.terms(result) else {
            unreachable!("homogeneous coordinates are polynomials")
        };
        for term in terms {
            let coordinate = Literal::usize_unsuffixed(coordinate);
            let factor = writer.factor(&term);
            let (u, v) = (writer.elevated(&term.u, m), writer.elevated(&term.v, n));
            sums.extend(
                quote! { #runtime::bernstein::accumulate(&mut net, #coordinate, #factor, &#u, &#v); },
            );
        }
    }
    let statements = writer.statements;
    let length = Literal::usize_unsuffixed((m + 1) * (n + 1));
    quote! {
        /// The control net over the domain.
        fn net(&self) -> [[f64; 4]; #length] {
            #statements
            let mut net = [[0.0; 4]; #length];
            #sums
            net
        }
    }
}

/// Statements, and then the Bernstein coefficients of a value that depends on one parameter.
pub(super) fn of_one_parameter(code: &Code<'_>, value: Value) -> (TokenStream, TokenStream) {
    let mut writer = Writer::new(code);
    let coefficients = match writer.value(value) {
        Form::Number(number) => quote! { [#number] },
        Form::Polynomial(name, _) => name.to_token_stream(),
    };
    (writer.statements, coefficients)
}

/// A value: a number, or the variable with a polynomial's Bernstein coefficients and its degree.
#[derive(Clone)]
enum Form {
    Number(TokenStream),
    Polynomial(Ident, usize),
}

impl Form {
    /// The Bernstein coefficients and the degree.
    fn coefficients(self) -> (TokenStream, usize) {
        match self {
            Form::Number(number) => (quote! { [#number] }, 0),
            Form::Polynomial(name, degree) => (name.to_token_stream(), degree),
        }
    }
}

struct Writer<'a> {
    code: &'a Code<'a>,
    statements: TokenStream,
    known: BTreeMap<Value, Form>,
    temporaries: usize,
}

impl<'a> Writer<'a> {
    fn new(code: &'a Code<'a>) -> Writer<'a> {
        Writer { code, statements: TokenStream::new(), known: BTreeMap::new(), temporaries: 0 }
    }

    /// The number in front of a term.
    fn factor(&mut self, term: &Term) -> TokenStream {
        let mut negative = term.negative;
        let mut numbers = Vec::new();
        for &value in &term.numbers {
            numbers.push(match self.code.program.operation(value) {
                Operation::Constant(constant) => {
                    negative ^= constant.is_sign_negative();
                    literal(constant.abs())
                }
                _ => self.number(value),
            });
        }
        let sign = negative.then(|| quote! { - });
        let mut numbers = numbers.into_iter();
        let first = numbers.next().unwrap_or_else(|| literal(1.0));
        quote! { #sign #first #(* #numbers)* }
    }

    /// The coefficients of a product of polynomials of one parameter, for a degree that is not too low.
    fn elevated(&mut self, factors: &[Value], degree: usize) -> TokenStream {
        let runtime = self.code.runtime;
        let length = Literal::usize_unsuffixed(degree + 1);
        let mut product: Option<(TokenStream, usize)> = None;
        for &factor in factors {
            let (name, own) = self.value(factor).coefficients();
            product = Some(match product {
                None => (name, own),
                Some((other, sum)) => {
                    let code = quote! { #runtime::bernstein::product(&#other, &#name) };
                    (self.temporary(sum + own, &code).to_token_stream(), sum + own)
                }
            });
        }
        match product {
            None => quote! { [1.0; #length] },
            Some((name, own)) if own == degree => name,
            Some((name, _)) => {
                let code = quote! { #runtime::bernstein::elevated(&#name) };
                self.temporary(degree, &code).to_token_stream()
            }
        }
    }

    fn temporary(&mut self, degree: usize, code: &TokenStream) -> Ident {
        self.temporaries += 1;
        let name = Ident::new(&format!("e{}", self.temporaries), Span::call_site());
        self.bind(&name, degree, code);
        name
    }

    fn bind(&mut self, name: &Ident, degree: usize, code: &TokenStream) {
        let length = Literal::usize_unsuffixed(degree + 1);
        self.statements.extend(quote! { let #name: [f64; #length] = #code; });
    }

    /// The form of a value that depends on one parameter at most.
    fn value(&mut self, value: Value) -> Form {
        if let Some(form) = self.known.get(&value) {
            return form.clone();
        }
        let form = self.new_value(value);
        self.known.insert(value, form.clone());
        form
    }

    fn new_value(&mut self, value: Value) -> Form {
        let (program, runtime) = (self.code.program, self.code.runtime);
        if program.stage(value) <= Stage::Symbols {
            return Form::Number(self.number(value));
        }
        if let Some(chain) = self.code.chains.get(&value) {
            let (base, degree) = self.value(chain.base).coefficients();
            let coefficients = match self.code.array(value) {
                Some(array) => array,
                None => {
                    let numbers = chain.coefficients.iter().map(|coefficient| match coefficient {
                        Coefficient::Value(value) => self.number(*value),
                        Coefficient::One => literal(1.0),
                        Coefficient::MinusOne => literal(-1.0),
                    });
                    quote! { [#(#numbers),*] }
                }
            };
            let name = Ident::new(&format!("b{}", value.index()), Span::call_site());
            let degree = degree * (chain.coefficients.len() - 1);
            self.bind(&name, degree, &quote! { #runtime::bernstein::horner(&#coefficients, &#base) });
            return Form::Polynomial(name, degree);
        }
        let (degree, code) = match *program.operation(value) {
            Operation::Input(Input::U) => (1, quote! { Self::DOMAIN.u }),
            Operation::Input(_) => (1, quote! { Self::DOMAIN.v }),
            Operation::Negate(a) => {
                let (a, degree) = self.value(a).coefficients();
                (degree, quote! { #runtime::bernstein::scaled(&#a, -1.0) })
            }
            Operation::Add(a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                self.sum(a, b, &quote! { 1.0 })
            }
            Operation::Subtract(a, b) => {
                let (a, b) = (self.value(a), self.value(b));
                self.sum(a, b, &quote! { -1.0 })
            }
            Operation::Multiply(a, b) => self.product(a, b),
            Operation::MultiplyAdd(a, b, c) => {
                let (degree, code) = self.product(a, b);
                let product = Form::Polynomial(self.temporary(degree, &code), degree);
                let c = self.value(c);
                self.sum(product, c, &quote! { 1.0 })
            }
            Operation::Constant(_)
            | Operation::Divide(..)
            | Operation::SquareRoot(_)
            | Operation::Orient(..)
            | Operation::Scale(..) => {
                unreachable!("homogeneous coordinates and conditions are polynomials")
            }
        };
        let name = Ident::new(&format!("b{}", value.index()), Span::call_site());
        self.bind(&name, degree, &code);
        Form::Polynomial(name, degree)
    }

    /// The degree and the code of a·b.
    fn product(&mut self, a: Value, b: Value) -> (usize, TokenStream) {
        let runtime = self.code.runtime;
        match (self.value(a), self.value(b)) {
            (Form::Number(factor), other) | (other, Form::Number(factor)) => {
                let (other, degree) = other.coefficients();
                (degree, quote! { #runtime::bernstein::scaled(&#other, #factor) })
            }
            (Form::Polynomial(a, m), Form::Polynomial(b, n)) => {
                (m + n, quote! { #runtime::bernstein::product(&#a, &#b) })
            }
        }
    }

    /// The degree and the code of a + `sign`·b; a number comes last where that is all the same.
    fn sum(&mut self, mut first: Form, mut second: Form, sign: &TokenStream) -> (usize, TokenStream) {
        let runtime = self.code.runtime;
        if matches!(first, Form::Number(_)) && sign.to_string() == "1.0" {
            std::mem::swap(&mut first, &mut second);
        }
        let ((a, m), (b, n)) = (first.coefficients(), second.coefficients());
        (m.max(n), quote! { #runtime::bernstein::sum(&#a, &#b, #sign) })
    }

    /// A value that depends on no parameter.
    fn number(&self, value: Value) -> TokenStream {
        self.code.number(value)
    }
}
