//! Families: surfaces whose coefficients are set at run time.

use std::collections::BTreeMap;

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, quote};

use super::body::{literal, symbol, write};
use super::code::{Code, Field, Mode, Number};
use super::expression::Body;
use super::rust::{camel_case, doc};
use super::{Artifact, Setting, net};
use crate::meaning::CoefficientKind;

/// The struct of what is set, the struct of what is computed from that, and the surface itself.
pub(super) fn definition(name: &Ident, artifact: &Artifact, code: &Code<'_>) -> TokenStream {
    let settings = artifact.symbols.iter().map(|setting| {
        let (name, docs) = (field(setting), doc([documentation(setting).as_str()]));
        let shape = match setting {
            Setting::Number(_) => quote! { f64 },
            Setting::Curve { rows, .. } => {
                let (count, width) = shape(rows);
                quote! { [[f64; #width]; #count] }
            }
        };
        quote! { #docs pub #name: #shape }
    });
    let kept = code.fields.iter().map(|(name, values)| {
        let length = Literal::usize_unsuffixed(values.len());
        quote! { #name: [f64; #length] }
    });
    let length = net_length(artifact);
    let text = format!("A surface of the family `{}`, with its coefficients.", artifact.name);
    let docs = doc([text.as_str(), "", "It is made by [`new`](Self::new), which checks its parameters."]);
    let text = format!("What a surface of the family `{}` is made of.", artifact.name);
    let parameters_docs = doc([text.as_str()]);
    let [parameters, coefficients] = types(artifact);
    quote! {
        #parameters_docs
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct #parameters {
            #(#settings),*
        }

        #docs
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct #name {
            parameters: #parameters,
            coefficients: #coefficients,
            control_net: [[f64; 4]; #length],
        }

        /// What evaluators need of the parameters alone.
        #[derive(Clone, Copy, Debug, PartialEq)]
        struct #coefficients {
            #(#kept),*
        }
    }
}

/// The constructor, and what it computes.
pub(super) fn construction(artifact: &Artifact, code: &Code<'_>) -> TokenStream {
    let runtime = code.runtime;
    let checks = artifact.symbols.iter().map(|setting| {
        let name = field(setting);
        let text = name.to_string();
        let values = match setting {
            Setting::Number(_) => quote! { &[parameters.#name] },
            Setting::Curve { .. } => quote! { parameters.#name.as_flattened() },
        };
        quote! { #runtime::family::check_finite(#text, #values)?; }
    });
    let columns = Literal::usize_unsuffixed(artifact.degree.1 as usize + 1);
    let computation = coefficients(artifact, code);
    let [parameters, _] = types(artifact);
    let length = net_length(artifact);
    let net = net::net(artifact, code);
    let speeds = net::speeds(code);
    let check_speeds = speeds.is_some().then(|| quote! { surface.check_speeds()?; });
    quote! {
        /// The surface with these parameters.
        ///
        /// # Errors
        /// If a parameter is infinite or NaN, or so large that a coefficient overflows; if the weight W vanishes on the
        /// domain, or comes nearer to zero than rounding can tell; if a parametric speed is not positive.
        pub fn new(parameters: #parameters) -> ::core::result::Result<Self, #runtime::ParameterError> {
            #(#checks)*
            let coefficients = Self::coefficients(&parameters);
            let mut surface = Self { parameters, coefficients, control_net: [[0.0; 4]; #length] };
            surface.control_net = surface.net();
            #runtime::family::check_net(&surface.control_net, #columns, &Self::DOMAIN)?;
            #check_speeds
            ::core::result::Result::Ok(surface)
        }

        /// What the surface is made of.
        #[must_use]
        pub fn parameters(&self) -> &#parameters {
            &self.parameters
        }

        #computation
        #net
        #speeds
    }
}

/// The function that computes what all evaluators need of the parameters.
fn coefficients(artifact: &Artifact, code: &Code<'_>) -> TokenStream {
    let (values, fields) = code.computed();
    let body = Body::new(code, &values, &BTreeMap::new());
    let (statements, results) = write(code, Mode::Plain, &body);
    let inputs = body.inputs;
    let fields = fields.into_iter().map(|Field { name, numbers }| {
        let numbers = numbers.into_iter().map(|number| match number {
            Number::Computed(place) => results[place].clone(),
            Number::Constant(number) => literal(number),
        });
        quote! { #name: [#(#numbers),*] }
    });
    let used = |name: &str| {
        let place = code.program.symbols().iter().position(|known| known == name);
        place.is_some_and(|place| inputs.contains(&crate::program::Input::Symbol(place as u32)))
    };
    let variable = |name: &String| {
        if used(name) {
            symbol(name).to_token_stream()
        } else {
            quote! { _ }
        }
    };
    let patterns = artifact.symbols.iter().map(|setting| {
        let name = field(setting);
        match setting {
            Setting::Number(text) => {
                if used(text) {
                    // The field and the variable have one name.
                    return quote! { #name };
                }
                quote! { #name: _ }
            }
            Setting::Curve { rows, .. } => {
                let rows = rows.iter().map(|row| {
                    let row = row.iter().map(variable);
                    quote! { [#(#row),*] }
                });
                quote! { #name: [#(#rows),*] }
            }
        }
    });
    let [parameters, coefficients] = types(artifact);
    quote! {
        fn coefficients(parameters: &#parameters) -> #coefficients {
            let #parameters { #(#patterns),* } = *parameters;
            #statements
            #coefficients { #(#fields),* }
        }
    }
}

/// The names of the types of what is set and of what is computed from that; the surface itself may have one of the usual ones.
fn types(artifact: &Artifact) -> [Ident; 2] {
    let own = camel_case(&artifact.name);
    ["Parameters", "Coefficients"].map(|usual| {
        let name = if own == usual { format!("Family{usual}") } else { usual.to_string() };
        Ident::new(&name, Span::call_site())
    })
}

/// The name of what is set.
fn field(setting: &Setting) -> Ident {
    match setting {
        Setting::Number(name) | Setting::Curve { name, .. } => symbol(name),
    }
}

/// What is said of a parameter.
pub(super) fn documentation(setting: &Setting) -> String {
    match setting {
        Setting::Number(name) => format!("The number `{name}`."),
        Setting::Curve { name, kind, rows } => {
            let symbols: Vec<String> = rows.iter().map(|row| format!("({})", row.join(", "))).collect();
            let symbols = symbols.join(", ");
            match kind {
                CoefficientKind::Preimage => format!(
                    "The preimage of the curve `{name}`: real and imaginary parts {symbols} of its Bernstein coefficients."
                ),
                CoefficientKind::Quaternion => format!(
                    "The preimage of the spatial curve `{name}`: components {symbols} of its Bernstein coefficients, quaternions."
                ),
                CoefficientKind::Polynomial => {
                    format!("The curve `{name}`: the coefficients {symbols} of the powers of its parameter.")
                }
                CoefficientKind::Rational => format!(
                    "The curve `{name}`: weight and homogeneous coordinates {symbols} as coefficients of the powers of its parameter."
                ),
            }
        }
    }
}

/// Numbers of rows and columns.
fn shape(rows: &[Vec<String>]) -> (Literal, Literal) {
    let width = rows.first().map_or(0, Vec::len);
    (Literal::usize_unsuffixed(rows.len()), Literal::usize_unsuffixed(width))
}

fn net_length(artifact: &Artifact) -> Literal {
    let (m, n) = artifact.degree;
    Literal::usize_unsuffixed((m as usize + 1) * (n as usize + 1))
}
