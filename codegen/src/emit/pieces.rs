//! Surfaces of several pieces: a module for each piece, and one for the whole.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::body::literal;
use super::rust::{allowed, bounds_value, camel_case, doc};
use super::{Artifact, documentation, module};
use crate::proofs::Proofs;

/// The modules of surfaces, in their order, over the runtime at the path `runtime`; that of a surface of several pieces comes after
/// those of its pieces. Families have none, since each of their pieces is made of values by itself.
#[must_use]
pub fn modules(artifacts: &[Artifact], runtime: &TokenStream) -> TokenStream {
    let mut tokens = TokenStream::new();
    for (index, artifact) in artifacts.iter().enumerate() {
        tokens.extend(module(artifact, runtime));
        tokens.extend(pieces(&artifacts[..=index]).map(|pieces| whole(pieces, runtime)));
    }
    tokens
}

/// The pieces of the surface that the last artifact completes.
pub(super) fn pieces(artifacts: &[Artifact]) -> Option<&[Artifact]> {
    let last = artifacts.last()?.piece.as_ref()?;
    let first = artifacts.len().checked_sub(last.count)?;
    let pieces = &artifacts[first..];
    let of_one = |(index, artifact): (usize, &Artifact)| {
        let piece = artifact.piece.as_ref();
        artifact.symbols.is_empty() && piece.is_some_and(|piece| piece.of == last.of && piece.index == index)
    };
    pieces.iter().enumerate().all(of_one).then_some(pieces)
}

/// The bounds that hold on all pieces.
pub(super) fn proofs(pieces: &[Artifact]) -> Option<Proofs> {
    Proofs::together(&pieces.iter().map(|piece| piece.proofs.as_ref()).collect::<Option<Vec<_>>>()?)
}

/// Upper bounds of the jumps of points at the joints, in each of the roundings: what two neighbors differ by from the point where
/// they meet. Infinite where no bound is known, or a joint is no float of the precision.
pub(super) fn jumps(pieces: &[Artifact]) -> [f64; 4] {
    let mut jumps = [0.0_f64; 4];
    for pair in pieces.windows(2) {
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
                (Some(first), Some(second)) if joint => (first + second).next_up(),
                _ => f64::INFINITY,
            };
            *jump = jump.max(sum);
        }
    }
    jumps
}

/// The module of the whole.
fn whole(pieces: &[Artifact], runtime: &TokenStream) -> TokenStream {
    let (Some(first), Some(last)) = (pieces.first(), pieces.last()) else { return TokenStream::new() };
    let name = first.piece.as_ref().map_or(first.name.as_str(), |piece| &piece.of);
    let lines = documentation::of_pieces(name, pieces);
    let docs = doc(lines.iter().map(String::as_str));
    let (module, surface) =
        (Ident::new(name, Span::call_site()), Ident::new(&camel_case(name), Span::call_site()));
    let of_pieces = Ident::new(&format!("{surface}Pieces"), Span::call_site());
    let type_docs = doc([format!("The surface `{name}`.").as_str()]);
    let value_docs = doc([format!("The surface `{name}` as a value.").as_str()]);
    let pieces_docs = doc([format!("The pieces of the surface `{name}`.").as_str()]);
    let degree = |of: fn(&Artifact) -> u32| Literal::u32_unsuffixed(pieces.iter().map(of).max().unwrap_or(0));
    let (m, n) = (degree(|piece| piece.degree.0), degree(|piece| piece.degree.1));
    let [[u_first, u_last], [v_first, _]] = first.domain.map(|ends| ends.map(literal));
    let v_last = literal(last.domain[1][1]);
    let joints =
        pieces.iter().skip(1).filter_map(|piece| piece.piece.as_ref().map(|piece| literal(piece.start)));
    let bounds = match proofs(pieces) {
        Some(proofs) => {
            let bounds = bounds_value(&proofs, runtime);
            quote! { ::core::option::Option::Some(&#bounds) }
        }
        None => quote! { ::core::option::Option::None },
    };
    let jumps = jumps(pieces).map(|jump| {
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
