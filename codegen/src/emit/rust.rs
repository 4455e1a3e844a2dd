//! Rust items: a documented unit struct for each surface, which implements the runtime's `Surface`.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, quote};

use super::Artifact;
use super::body::{Body, literal};
use super::code::Code;
use super::family;
use super::polynomial::polynomials;
use crate::program::{Input, Stage, Value};
use crate::schedule::outputs;

/// The documented module `pub mod name { … }` of a surface, over the runtime at the path `runtime`.
///
/// `runtime` is `::hodograph`, or the path of a copy.
#[must_use]
pub fn module(artifact: &Artifact, runtime: &TokenStream) -> TokenStream {
    let name = Ident::new(&artifact.name, Span::call_site());
    let docs = documentation(artifact);
    let items = items(artifact, runtime);
    // The names of sweeps and symbols are their author's.
    let names = std::iter::once(&artifact.name).chain(artifact.program.symbols());
    let capital = names.into_iter().any(|name| name.contains(char::is_uppercase));
    let names = capital.then(|| quote! { #[allow(non_snake_case)] });
    quote! {
        #docs
        #[allow(clippy::doc_markdown)]
        #names
        pub mod #name {
            #items
        }
    }
}

/// The items of a surface: a struct with inherent constants and evaluators, and its `impl Surface`. It is a unit struct
/// unless the surface is one of a family.
///
/// Evaluators are straight-line code over `f64`. What a point needs of u alone, of v alone and of both are separate
/// functions, so that `grid` evaluates exactly what `point` does.
fn items(artifact: &Artifact, runtime: &TokenStream) -> TokenStream {
    let name = Ident::new(&camel_case(&artifact.name), Span::call_site());
    let text = format!("The surface `{}` as a value.", artifact.name);
    let docs = doc([text.as_str()]);
    let code = &Code::new(&artifact.program, runtime);
    let constants = constants(artifact, runtime);
    let polynomials = polynomials(code);
    let evaluators = evaluators(code);
    let implementation = implementation(&name, code);
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

        #[allow(
            clippy::approx_constant,
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
        impl #name {
            #constants
            #construction
            #evaluators
            #polynomials
        }

        #implementation
    }
}

/// Documentation of the module: formula, source, degrees, domain and operation counts.
fn documentation(artifact: &Artifact) -> TokenStream {
    let mut lines: Vec<String> = artifact.documentation.clone();
    if lines.is_empty() {
        lines.push(format!("The surface `{}`.", artifact.name));
    }
    lines.extend([String::new(), "```text".to_string()]);
    lines.extend(artifact.formula.lines().map(str::to_string));
    lines.extend(["```".to_string(), String::new()]);
    if let Some(source) = &artifact.source {
        lines.extend([format!("Source: `{}`.", source.replace('`', "'")), String::new()]);
    }
    let (m, n) = artifact.degree;
    let [w, x, y, z] = artifact.coordinate_degrees.map(|(m, n)| format!("({m}, {n})"));
    let [[u_first, u_last], [v_first, v_last]] = artifact.domain;
    lines.push(format!("- Degree ({m}, {n}): W {w}, X {x}, Y {y}, Z {z}."));
    lines.push(format!("- Domain: u from {u_first:?} to {u_last:?}, v from {v_first:?} to {v_last:?}."));
    let program = &artifact.program;
    let point = program.results(outputs::POINT);
    let counts = [Stage::V, Stage::U, Stage::Both].map(|stage| program.count(point, stage));
    lines.push(format!(
        "- Cost of a point: {}; on a grid {} for each v, {} for each u and {} for each point.",
        program.count_all(point),
        counts[0],
        counts[1],
        counts[2]
    ));
    if !artifact.symbols.is_empty() {
        let all: Vec<Value> = program.outputs().iter().flat_map(|output| output.values.clone()).collect();
        let once = program.count(&all, Stage::Symbols);
        lines.push(format!("- A family: each member computes its coefficients once, in {once}."));
        lines.push("- The degrees are those of a general member.".to_string());
    }
    doc(lines.iter().map(String::as_str))
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
    }
}

fn evaluators(code: &Code<'_>) -> TokenStream {
    let (program, runtime) = (code.program, code.runtime);
    let function = |output: &str, first: &str, name: &str, size: usize| {
        let results = program.results(output);
        let body = code.body(results);
        let text = format!("{first}: {}.", program.count_all(results));
        evaluator(&text, name, &body, size)
    };
    let homogeneous = function(
        outputs::HOMOGENEOUS,
        "The homogeneous coordinates (W, X, Y, Z) at (u, v)",
        "homogeneous",
        4,
    );
    let partial_u = function(outputs::PARTIAL_U, "The partial derivative `R_u`", "partial_u", 3);
    let partial_v = function(outputs::PARTIAL_V, "The partial derivative `R_v`", "partial_v", 3);
    let point = point(code);
    let unit_normal = unit_normal(code);
    quote! {
        #homogeneous
        #point
        #partial_u
        #partial_v
        #unit_normal

        /// The parametric speed `‖R_u‖` of the curves v = const.
        #[inline]
        #[must_use]
        pub fn speed_u(&self, u: f64, v: f64) -> f64 {
            #runtime::Surface::speed_u(self, u, v)
        }

        /// The parametric speed `‖R_v‖` of the curves u = const.
        #[inline]
        #[must_use]
        pub fn speed_v(&self, u: f64, v: f64) -> f64 {
            #runtime::Surface::speed_v(self, u, v)
        }

        /// The point R + r·N of the offset surface, where the surface is regular.
        #[inline]
        pub fn offset_point(&self, r: f64, u: f64, v: f64) -> #runtime::Regularity {
            #runtime::Surface::offset_point(self, r, u, v)
        }
    }
}

/// A public evaluator that returns the results of `body` as an array.
fn evaluator(text: &str, name: &str, body: &Body, size: usize) -> TokenStream {
    let (docs, name, size) =
        (doc([text]), Ident::new(name, Span::call_site()), Literal::usize_unsuffixed(size));
    let (u, v) = (parameter(body, Input::U), parameter(body, Input::V));
    let Body { statements, results, .. } = body;
    quote! {
        #docs
        #[inline]
        #[must_use]
        pub fn #name(&self, #u: f64, #v: f64) -> [f64; #size] {
            #statements
            [#(#results),*]
        }
    }
}

/// The point in three functions, for what is known of u, of v and of both, and the grid that calls them.
fn point(code: &Code<'_>) -> TokenStream {
    let (program, runtime) = (code.program, code.runtime);
    let results = program.results(outputs::POINT);
    let mut parts = [BTreeSet::new(), BTreeSet::new()];
    let mut frontier = |value: Value| match program.stage(value) {
        Stage::U => _ = parts[0].insert(value),
        Stage::V => _ = parts[1].insert(value),
        Stage::Constant | Stage::Symbols | Stage::Both => {}
    };
    results.iter().for_each(|&result| frontier(result));
    for value in program.needed(results) {
        if program.stage(value) == Stage::Both {
            program.operation(value).operands().into_iter().for_each(&mut frontier);
        }
    }
    let [of_u, of_v] = parts.map(|values| values.into_iter().collect::<Vec<Value>>());
    let receiver = code.receiver();
    let part = |values: &[Value], input: Input, name: &str, stage: Stage| {
        let body = code.body(values);
        let (name, size) = (Ident::new(name, Span::call_site()), Literal::usize_unsuffixed(values.len()));
        let parameter = parameter(&body, input);
        let letter = if input == Input::U { 'u' } else { 'v' };
        let text = doc([
            format!("What a point needs of {letter} alone: {}.", program.count(results, stage)).as_str()
        ]);
        let Body { statements, results, .. } = body;
        quote! {
            #text
            #[inline]
            fn #name(#receiver #parameter: f64) -> [f64; #size] {
                #statements
                [#(#results),*]
            }
        }
    };
    let function_of_u = part(&of_u, Input::U, "of_u", Stage::U);
    let function_of_v = part(&of_v, Input::V, "of_v", Stage::V);
    let named = |&value| (value, code.names.of(program, value).to_token_stream());
    let given = of_u.iter().chain(&of_v).map(named).collect();
    let Body { statements, results: joined, .. } = code.body_given(results, &given);
    let (names_u, names_v) = (of_u.iter().map(|value| &given[value]), of_v.iter().map(|value| &given[value]));
    let (size_u, size_v) = (Literal::usize_unsuffixed(of_u.len()), Literal::usize_unsuffixed(of_v.len()));
    let [call_u, call_v, join] =
        ["of_u", "of_v", "join"].map(|name| code.path(&Ident::new(name, Span::call_site())));
    let staged = if code.is_family() {
        quote! { |u| self.of_u(u), |v| self.of_v(v), |of_u, of_v| self.join(of_u, of_v) }
    } else {
        quote! { Self::of_u, Self::of_v, Self::join }
    };
    let text = doc([format!("The point of both parts: {}.", program.count(results, Stage::Both)).as_str()]);
    let point_text = doc([format!("The point R(u, v): {}.", program.count_all(results)).as_str()]);
    quote! {
        #function_of_u
        #function_of_v
        #text
        #[inline]
        fn join(#receiver of_u: &[f64; #size_u], of_v: &[f64; #size_v]) -> [f64; 3] {
            let [#(#names_u),*] = *of_u;
            let [#(#names_v),*] = *of_v;
            #statements
            [#(#joined),*]
        }

        #point_text
        #[inline]
        #[must_use]
        pub fn point(&self, u: f64, v: f64) -> [f64; 3] {
            #join(&#call_u(u), &#call_v(v))
        }

        /// Writes R(`us[i]`, `vs[j]`) to `out[j * us.len() + i]`, with the bits of `point`.
        ///
        /// # Errors
        /// If the length of `out` is not `us.len() * vs.len()`.
        #[inline]
        pub fn grid(
            &self,
            us: &[f64],
            vs: &[f64],
            out: &mut [[f64; 3]],
        ) -> ::core::result::Result<(), #runtime::GridError> {
            #runtime::grid::staged(us, vs, out, #staged)
        }
    }
}

fn unit_normal(code: &Code<'_>) -> TokenStream {
    let (program, runtime) = (code.program, code.runtime);
    let rational = program.results(outputs::UNIT_NORMAL);
    let crossed = program.results(outputs::CROSS_PRODUCT);
    let (constructor, vector) = match (rational.is_empty(), crossed.is_empty()) {
        (false, _) => (quote! { finite }, rational),
        (true, true) => (quote! { unit }, program.results(outputs::NORMAL_DIRECTION)),
        (true, false) => (quote! { unit }, crossed),
    };
    let singular = program.results(outputs::SINGULAR);
    let results: Vec<Value> = vector.iter().chain(singular).copied().collect();
    let body = code.body(&results);
    let mut text = format!("The unit normal, where the surface is regular: {}", program.count_all(&results));
    text.push_str(match (rational.is_empty(), crossed.is_empty()) {
        (false, _) => ", since it is rational.",
        (true, true) => " for its direction.",
        (true, false) => " for its direction, which is the vector product of the derivatives.",
    });
    let docs = doc([text.as_str()]);
    let (u, v) = (parameter(&body, Input::U), parameter(&body, Input::V));
    let Body { statements, results, .. } = body;
    let (vector, singular) = results.split_at(vector.len());
    // R_u × R_v is the factor times the vector, so the normal turns over where the factor changes its sign.
    let oriented = !singular.is_empty();
    let guard = singular.iter().map(|factor| {
        quote! {
            let factor = #factor;
            if factor == 0.0 {
                return #runtime::Regularity::Singular;
            }
            let side = if factor < 0.0 { -1.0 } else { 1.0 };
        }
    });
    let vector = vector.iter().map(|component| {
        if oriented {
            quote! { side * (#component) }
        } else {
            quote! { #component }
        }
    });
    quote! {
        #docs
        #[inline]
        pub fn unit_normal(&self, #u: f64, #v: f64) -> #runtime::Regularity {
            #statements
            #(#guard)*
            #runtime::Regularity::#constructor([#(#vector),*])
        }
    }
}

/// The trait's implementation, which calls the inherent evaluators.
fn implementation(name: &Ident, code: &Code<'_>) -> TokenStream {
    let runtime = code.runtime;
    let net = if code.is_family() {
        quote! { &self.control_net }
    } else {
        quote! { &Self::CONTROL_NET }
    };
    let evaluators = [
        ("homogeneous", quote! { [f64; 4] }),
        ("point", quote! { [f64; 3] }),
        ("partial_u", quote! { [f64; 3] }),
        ("partial_v", quote! { [f64; 3] }),
        ("unit_normal", quote! { #runtime::Regularity }),
    ]
    .map(|(method, result)| {
        let method = Ident::new(method, Span::call_site());
        quote! {
            #[inline]
            fn #method(&self, u: f64, v: f64) -> #result {
                Self::#method(self, u, v)
            }
        }
    });
    quote! {
        impl #runtime::Surface for #name {
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

            #(#evaluators)*

            fn grid(
                &self,
                us: &[f64],
                vs: &[f64],
                out: &mut [[f64; 3]],
            ) -> ::core::result::Result<(), #runtime::GridError> {
                Self::grid(self, us, vs, out)
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
