//! Rust items: a documented unit struct for each surface, which implements the runtime's `Surface`.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::body::literal;
use super::code::Code;
use super::family;
use super::stages;
use super::{Artifact, documentation};
use crate::offset::OffsetPatch;
use crate::proofs::Proofs;
use crate::schedule::outputs;

/// The documented module `pub mod name { … }` of a surface, over the runtime at the path `runtime`.
///
/// `runtime` is `::hodograph`, or the path of a copy.
#[must_use]
pub fn module(artifact: &Artifact, runtime: &TokenStream) -> TokenStream {
    let name = Ident::new(&artifact.name, Span::call_site());
    let lines = documentation::lines(artifact);
    let docs = doc(lines.iter().map(String::as_str));
    let items = items(artifact, runtime);
    let names =
        std::iter::once(artifact.name.as_str()).chain(artifact.program.symbols().iter().map(AsRef::as_ref));
    let allowed = allowed(names);
    quote! {
        #docs
        #allowed
        pub mod #name {
            #items
        }
    }
}

/// The lints that generated code does not keep; the names of sweeps and symbols are their author's.
pub(super) fn allowed<'a>(names: impl IntoIterator<Item = &'a str>) -> TokenStream {
    let unusual = names.into_iter().any(|name| name.contains(char::is_uppercase) || name.contains("__"));
    let names = unusual.then(|| quote! { #[allow(non_snake_case)] });
    quote! {
        #[allow(
            clippy::approx_constant,
            clippy::doc_markdown,
            clippy::excessive_precision,
            clippy::float_cmp,
            clippy::many_single_char_names,
            clippy::missing_const_for_fn,
            clippy::possible_missing_comma,
            clippy::similar_names,
            clippy::suboptimal_flops,
            clippy::trivially_copy_pass_by_ref,
            clippy::unreadable_literal,
            clippy::unused_self
        )]
        #names
    }
}

/// The items of a surface: a struct with inherent constants and evaluators, and its `impl Surface`. It is a unit struct
/// unless the surface is one of a family.
///
/// Evaluators are straight-line code over any real numbers of the runtime. What is needed of u alone, of v alone and of both are
/// separate functions, so that grids evaluate exactly what single points do.
fn items(artifact: &Artifact, runtime: &TokenStream) -> TokenStream {
    let name = Ident::new(&camel_case(&artifact.name), Span::call_site());
    let text = format!("The surface `{}` as a value.", artifact.name);
    let docs = doc([text.as_str()]);
    let code = &Code::new(&artifact.program, runtime);
    let constants = constants(artifact, runtime);
    let polynomials = stages::constants(code);
    let (structs, functions, stages) = stages::stages(&name, code);
    let implementation = implementation(&name, code, artifact.proofs.is_some());
    let (definition, construction) = if artifact.symbols.is_empty() {
        let definition = quote! {
            #docs
            #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
            pub struct #name;
        };
        (definition, TokenStream::new())
    } else {
        (family::definition(&name, artifact, code), family::construction(artifact, code))
    };
    quote! {
        #definition

        impl #name {
            #constants
            #construction
            #polynomials
            #functions
        }

        #structs
        #stages
        #implementation
    }
}

fn constants(artifact: &Artifact, runtime: &TokenStream) -> TokenStream {
    let Artifact { name, formula, .. } = artifact;
    let source = match &artifact.source {
        Some(source) => quote! { ::core::option::Option::Some(#source) },
        None => quote! { ::core::option::Option::None },
    };
    let (m, n) = (Literal::u32_unsuffixed(artifact.degree.0), Literal::u32_unsuffixed(artifact.degree.1));
    let [[u_first, u_last], [v_first, v_last]] = artifact.domain.map(|ends| ends.map(literal));
    let net = artifact.control_net.iter().map(|point| {
        let [w, x, y, z] = point.map(literal);
        quote! { [#w, #x, #y, #z] }
    });
    let length = Literal::usize_unsuffixed(artifact.control_net.len());
    let net = artifact.symbols.is_empty().then(|| {
        quote! {
            /// Homogeneous Bézier control points (W, X, Y, Z) over the domain, rounded; the index of u is the outer one.
            pub const CONTROL_NET: [[f64; 4]; #length] = [#(#net),*];
        }
    });
    let bounds = artifact.proofs.as_ref().map(|proofs| bounds(proofs, runtime));
    let offset = artifact.offset.as_ref().map(|patch| offset(patch, runtime));
    quote! {
        /// The name of the sweep.
        pub const NAME: &'static str = #name;
        /// The formula that it was generated from.
        pub const FORMULA: &'static str = #formula;
        /// Where the formula is from.
        pub const SOURCE: ::core::option::Option<&'static str> = #source;
        /// The patch degree in u and v.
        pub const DEGREE: (u32, u32) = (#m, #n);
        /// The parameters over which the surface is stated.
        pub const DOMAIN: #runtime::Domain = #runtime::Domain { u: [#u_first, #u_last], v: [#v_first, #v_last] };
        #net
        #offset
        #bounds
    }
}

/// The constant of the bounds of errors.
fn bounds(proofs: &Proofs, runtime: &TokenStream) -> TokenStream {
    let value = bounds_value(proofs, runtime);
    quote! {
        /// Proved bounds of the errors of the evaluators over the domain.
        pub const BOUNDS: #runtime::Bounds = #value;
    }
}

/// The bounds of errors.
pub(super) fn bounds_value(proofs: &Proofs, runtime: &TokenStream) -> TokenStream {
    let number = |number: f64| match number.is_finite() {
        true => literal(number),
        false => quote! { f64::INFINITY },
    };
    let fields = proofs.bounds.iter().map(|bound| {
        let name = Ident::new(bound.name, Span::call_site());
        let (errors, relative) = (bound.errors.map(number), bound.relative_errors.map(number));
        let (size, most) = (literal(bound.size), number(bound.most));
        let coordinates = (bound.name == outputs::POINT).then(|| {
            let each = bound.results.iter().map(|result| {
                let errors = result.errors.map(number);
                quote! { [#(#errors),*] }
            });
            quote! { , coordinates: [#(#each),*] }
        });
        quote! {
            #name: #runtime::Bound {
                errors: [#(#errors),*], relative_errors: [#(#relative),*], size: #size, most: #most
            }
            #coordinates
        }
    });
    quote! { #runtime::Bounds { #(#fields),* } }
}

/// The exact offset patches.
fn offset(patch: &OffsetPatch, runtime: &TokenStream) -> TokenStream {
    let (m, n) = (Literal::u32_unsuffixed(patch.degree.0), Literal::u32_unsuffixed(patch.degree.1));
    let length = Literal::usize_unsuffixed(patch.net.len());
    let net = patch.net.iter().map(|[point, normal]| {
        let ([w, x, y, z], [_, a, b, c]) = (point.map(literal), normal.map(literal));
        quote! { ([#w, #x, #y, #z], [#a, #b, #c]) }
    });
    quote! {
        /// The patch degree in u and v of the offsets.
        pub const OFFSET_DEGREE: (u32, u32) = (#m, #n);
        /// Homogeneous Bézier control points of the offsets over the domain, rounded: (W, X, Y, Z) for the distance 0, and what
        /// X, Y and Z increase by for each unit of distance; the index of u is the outer one.
        pub const OFFSET_NET: [([f64; 4], [f64; 3]); #length] = [#(#net),*];

        /// The homogeneous control points of the exact offset R + r·N over the domain, of degree `OFFSET_DEGREE`.
        ///
        /// The side of the normal does not turn over where R_u × R_v does.
        #[must_use]
        pub fn offset_control_net(r: f64) -> [[f64; 4]; #length] {
            #runtime::offset_net(&Self::OFFSET_NET, r)
        }
    }
}

/// The facts.
fn implementation(name: &Ident, code: &Code<'_>, has_bounds: bool) -> TokenStream {
    let runtime = code.runtime;
    let net = if code.is_family() {
        quote! { &self.control_net }
    } else {
        quote! { &Self::CONTROL_NET }
    };
    let bounds = has_bounds.then(|| {
        quote! {
            fn bounds(&self) -> ::core::option::Option<&#runtime::Bounds> {
                ::core::option::Option::Some(&Self::BOUNDS)
            }
        }
    });
    quote! {
        impl #runtime::Sweep for #name {}

        impl #runtime::Patch for #name {
            fn name(&self) -> &str {
                Self::NAME
            }

            fn degree(&self) -> (u32, u32) {
                Self::DEGREE
            }

            fn domain(&self) -> #runtime::Domain {
                Self::DOMAIN
            }

            fn control_net(&self) -> &[[f64; 4]] {
                #net
            }

            #bounds
        }
    }
}

/// `///` lines.
pub(super) fn doc<'a>(lines: impl IntoIterator<Item = &'a str>) -> TokenStream {
    let lines =
        lines.into_iter().map(|line| if line.is_empty() { String::new() } else { format!(" {line}") });
    quote! { #(#[doc = #lines])* }
}

/// `a_name` as `AName`.
pub(super) fn camel_case(name: &str) -> String {
    let word = |word: &str| {
        let mut letters = word.chars();
        letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
    };
    name.split('_').map(word).collect()
}
