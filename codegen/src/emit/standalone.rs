//! Source that compiles without any dependency.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;
use syn::{Attribute, Expr, ExprLit, Item, Lit, Meta};

use super::{Artifact, format, modules, pieces};

/// The modules of `artifacts` and, in a module `runtime`, what they need of the runtime, laid out as text.
///
/// `files` are the runtime's files by the names of their modules, as `hodograph::runtime()` gives them.
///
/// Functions are those of the standard library, and fused multiply-add is used where the build assumes it of the machine: the
/// text has no unsafe code. Examples in the runtime's documentation are left out, since they
/// name its package.
///
/// # Errors
/// The error of syn if the runtime's files do not parse, which its own build would have reported.
pub fn standalone(artifacts: &[Artifact], files: &[(&str, &str)]) -> Result<String, syn::Error> {
    // A sweep may have the usual name.
    let taken = artifacts.iter().any(|artifact| artifact.name == "runtime");
    let name = Ident::new(if taken { "runtime_of_surfaces" } else { "runtime" }, Span::call_site());
    let modules = modules(artifacts, &quote! { super::#name });
    let families = artifacts.iter().any(|artifact| !artifact.symbols.is_empty());
    let in_pieces = (1..=artifacts.len()).any(|end| pieces::Whole::completed(&artifacts[..end]).is_some());
    let wanted = |module: &str| {
        (families || !OF_FAMILIES.contains(&module)) && (in_pieces || !OF_PIECES.contains(&module))
    };
    let files: Vec<(&str, &str)> = files.iter().copied().filter(|(module, _)| wanted(module)).collect();
    let mut exports = TokenStream::new();
    exports.extend(families.then(|| {
        quote! {
            pub use family::ParameterError;
            pub use tracked::{NumberBound, error_bounds};
        }
    }));
    exports
        .extend(in_pieces.then(|| quote! { pub use pieces::{Pieces, Piecewise, PiecewiseBatch, Visitor}; }));
    let runtime = runtime(&name, &files, &exports)?;
    format(quote! {
        #modules
        #runtime
    })
}

/// The files that only families need.
const OF_FAMILIES: [&str; 3] = ["bernstein", "family", "tracked"];

/// The file that only surfaces of several pieces need.
const OF_PIECES: [&str; 1] = ["pieces"];

/// The module `name` with what surfaces need.
fn runtime(name: &Ident, files: &[(&str, &str)], exports: &TokenStream) -> Result<TokenStream, syn::Error> {
    let mut modules = TokenStream::new();
    for (module, text) in files {
        let mut file: syn::File = syn::parse_str(&text.replace("crate::", "super::"))?;
        file.items.retain(|item| !matches!(item, Item::Mod(module) if module.ident == "tests"));
        file.attrs.retain(|attribute| !attribute.path().is_ident("doc"));
        for item in &mut file.items {
            shorten(item);
        }
        let (module, items) = (Ident::new(module, Span::call_site()), file.items);
        modules.extend(quote! { pub mod #module { #(#items)* } });
    }
    Ok(quote! {
        /// What the surfaces need to run.
        #[allow(dead_code, missing_docs, unused_imports, rustdoc::broken_intra_doc_links, clippy::all, clippy::pedantic, clippy::nursery)]
        pub mod #name {
            #exports
            pub use batch::{Batch, BatchError, Rows};
            pub use bounds::{Bound, Bounds};
            pub use dispatch::Variant;
            pub use output::{Item, Output, Window};
            pub use real::{Float, Fused, Plain, Real, Rounded, constants, horner};
            pub use surface::{Domain, Patch, Surface, offset_net};
            pub use task::{
                First, Homogeneous, Local, Normal, Part, Pinned, Point, Second, Separated, Staged, Stages, Sweep, Task,
            };
            pub use undefined::Undefined;
            pub use values::{FirstOrder, LocalGeometry, SecondOrder};

            pub mod float {
                /// Whether `mul_add` is an instruction wherever the code runs.
                pub const HAS_FUSED: bool = cfg!(any(target_feature = "fma", target_arch = "aarch64"));

                /// The correctly rounded square root.
                #[inline(always)]
                #[must_use]
                pub fn sqrt(x: f64) -> f64 {
                    x.sqrt()
                }

                /// The correctly rounded square root in single precision.
                #[inline(always)]
                #[must_use]
                pub fn sqrt_f32(x: f32) -> f32 {
                    x.sqrt()
                }

                /// a·b + c, rounded once.
                #[inline(always)]
                #[must_use]
                pub fn mul_add(a: f64, b: f64, c: f64) -> f64 {
                    a.mul_add(b, c)
                }

                /// a·b + c in single precision, rounded once.
                #[inline(always)]
                #[must_use]
                pub fn mul_add_f32(a: f32, b: f32, c: f32) -> f32 {
                    a.mul_add(b, c)
                }
            }
            #modules
        }
    })
}

/// Leaves out the examples in an item's documentation.
fn shorten(item: &mut Item) {
    match item {
        Item::Enum(item) => shorten_documentation(&mut item.attrs),
        Item::Struct(item) => shorten_documentation(&mut item.attrs),
        Item::Fn(item) => shorten_documentation(&mut item.attrs),
        Item::Trait(item) => {
            shorten_documentation(&mut item.attrs);
            for item in &mut item.items {
                if let syn::TraitItem::Fn(function) = item {
                    shorten_documentation(&mut function.attrs);
                }
            }
        }
        Item::Impl(item) => {
            for item in &mut item.items {
                if let syn::ImplItem::Fn(function) = item {
                    shorten_documentation(&mut function.attrs);
                }
            }
        }
        _ => {}
    }
}

fn shorten_documentation(attributes: &mut Vec<Attribute>) {
    let mut within = false;
    attributes.retain(|attribute| {
        let Meta::NameValue(meta) = &attribute.meta else { return true };
        let Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) = &meta.value else { return true };
        let fence = text.value().trim_start().starts_with("```");
        let keep = !within && !fence;
        within ^= fence;
        keep
    });
    while attributes.last().is_some_and(is_blank) {
        attributes.pop();
    }
}

fn is_blank(attribute: &Attribute) -> bool {
    let Meta::NameValue(meta) = &attribute.meta else { return false };
    matches!(&meta.value, Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) if text.value().trim().is_empty())
}
