//! Surfaces of several pieces: a module for each piece, and one for the whole.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::body::literal;
use super::rust::{allowed, bounds_value, camel_case, doc};
use super::{Artifact, documentation, module};
use crate::proofs::{Proofs, rounded_up};

/// The modules of surfaces, in their order, over the runtime at the path `runtime`; that of a surface of several pieces comes after
/// those of its pieces. Families have none, since each of their pieces is made of values by itself.
#[must_use]
pub fn modules(artifacts: &[Artifact], runtime: &TokenStream) -> TokenStream {
    let mut tokens = TokenStream::new();
    for (index, artifact) in artifacts.iter().enumerate() {
        tokens.extend(module(artifact, runtime));
        tokens.extend(Whole::completed(&artifacts[..=index]).map(|whole| whole_module(whole, runtime)));
    }
    tokens
}

/// A surface of several pieces.
#[derive(Clone, Copy)]
pub(super) struct Whole<'a> {
    /// Its name.
    pub(super) name: &'a str,
    /// Its pieces, of which there is at least one.
    pub(super) pieces: &'a [Artifact],
}

impl<'a> Whole<'a> {
    /// The surface that the last of the artifacts completes.
    pub(super) fn completed(artifacts: &'a [Artifact]) -> Option<Whole<'a>> {
        let last = artifacts.last()?.piece.as_ref()?;
        let first = artifacts.len().checked_sub(last.count)?;
        let pieces = &artifacts[first..];
        let of_one = |(index, artifact): (usize, &Artifact)| {
            let piece = artifact.piece.as_ref();
            artifact.symbols.is_empty()
                && piece.is_some_and(|piece| piece.of == last.of && piece.index == index)
        };
        pieces.iter().enumerate().all(of_one).then_some(Whole { name: &last.of, pieces })
    }

    /// The largest degrees of all pieces in u and in v.
    pub(super) fn degree(&self) -> (u32, u32) {
        let degrees = self.pieces.iter().map(|piece| piece.degree);
        degrees.fold((0, 0), |(m, n), degree| (m.max(degree.0), n.max(degree.1)))
    }

    /// First and last value of u, then of v.
    pub(super) fn domain(&self) -> [[f64; 2]; 2] {
        let [first, last] = [0, self.pieces.len() - 1].map(|index| self.pieces[index].domain);
        [first[0], [first[1][0], last[1][1]]]
    }

    /// The joints as they are evaluated: of one that is no float, the next larger one.
    pub(super) fn joints(&self) -> impl Iterator<Item = f64> + 'a {
        self.pieces.iter().skip(1).filter_map(|piece| Some(piece.piece.as_ref()?.start))
    }

    /// The bounds that hold on all pieces.
    pub(super) fn proofs(&self) -> Option<Proofs> {
        Proofs::together(&self.pieces.iter().map(|piece| piece.proofs.as_ref()).collect::<Option<Vec<_>>>()?)
    }

    /// Upper bounds of the jumps of points at the joints, in each of the roundings: what two neighbors differ by from the point
    /// where they meet. Infinite where no bound is known, or a joint is no float of the precision.
    pub(super) fn jumps(&self) -> [f64; 4] {
        let mut jumps = [0.0_f64; 4];
        for pair in self.pieces.windows(2) {
            let error = |piece: &Artifact, place: usize| {
                let point = piece.proofs.as_ref()?.bounds.iter().find(|bound| bound.name == "point")?;
                Some(point.errors[place])
            };
            let start = pair[1].piece.as_ref();
            for (place, jump) in jumps.iter_mut().enumerate() {
                let joint = start.is_some_and(|piece| {
                    piece.meets
                        && piece.start_is_exact
                        && (place < 2 || f64::from(piece.start as f32) == piece.start)
                });
                let sum = match (error(&pair[0], place), error(&pair[1], place)) {
                    (Some(first), Some(second)) if joint => rounded_up((first + second).next_up()),
                    _ => f64::INFINITY,
                };
                *jump = jump.max(sum);
            }
        }
        jumps
    }
}

/// The module of the whole.
fn whole_module(whole: Whole<'_>, runtime: &TokenStream) -> TokenStream {
    let Whole { name, pieces } = whole;
    let lines = documentation::of_pieces(whole, |piece| format!("[`{piece}`]"));
    let docs = doc(lines.iter().map(String::as_str));
    let (module, surface) =
        (Ident::new(name, Span::call_site()), Ident::new(&camel_case(name), Span::call_site()));
    let of_pieces = Ident::new(&format!("{surface}Pieces"), Span::call_site());
    let type_docs = doc([format!("The surface `{name}`.").as_str()]);
    let value_docs = doc([format!("The surface `{name}` as a value.").as_str()]);
    let pieces_docs = doc([format!("The pieces of the surface `{name}`.").as_str()]);
    let (m, n) = whole.degree();
    let (m, n) = (Literal::u32_unsuffixed(m), Literal::u32_unsuffixed(n));
    let [[u_first, u_last], [v_first, v_last]] = whole.domain().map(|ends| ends.map(literal));
    let joints = whole.joints().map(literal);
    let bounds = match whole.proofs() {
        Some(proofs) => {
            let bounds = bounds_value(&proofs, runtime);
            quote! { ::core::option::Option::Some(&#bounds) }
        }
        None => quote! { ::core::option::Option::None },
    };
    let jumps = whole.jumps().map(|jump| {
        if jump.is_finite() {
            literal(jump)
        } else {
            quote! { f64::INFINITY }
        }
    });
    let values: Vec<TokenStream> = pieces
        .iter()
        .map(|piece| {
            let module = Ident::new(&piece.name, Span::call_site());
            let value = Ident::new(&camel_case(&piece.name), Span::call_site());
            quote! { super::#module::#value }
        })
        .collect();
    let (others, end) = (&values[..values.len() - 1], &values[values.len() - 1]);
    let numbers = (0..others.len()).map(Literal::usize_unsuffixed);
    let allowed = allowed([name]);
    quote! {
        #docs
        #allowed
        pub mod #module {
            #pieces_docs
            #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
            pub struct #of_pieces;

            #type_docs
            pub type #surface = #runtime::Piecewise<#of_pieces>;

            #value_docs
            #[allow(non_upper_case_globals)]
            pub const #surface: #surface = #runtime::Piecewise::NEW;

            impl #runtime::Pieces for #of_pieces {
                const NAME: &'static str = #name;
                const DEGREE: (u32, u32) = (#m, #n);
                const DOMAIN: #runtime::Domain = #runtime::Domain { u: [#u_first, #u_last], v: [#v_first, #v_last] };
                const JOINTS: &'static [f64] = &[#(#joints),*];
                const BOUNDS: ::core::option::Option<&'static #runtime::Bounds> = #bounds;
                const JUMPS: [f64; 4] = [#(#jumps),*];

                fn visit<V: #runtime::Visitor>(piece: usize, visitor: V) -> V::Output {
                    match piece {
                        #(#numbers => visitor.visit(#others),)*
                        _ => visitor.visit(#end),
                    }
                }
            }
        }
    }
}
