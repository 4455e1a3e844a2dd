//! What the macro `sweep!` expands to.

use std::path::{Path, PathBuf};

use proc_macro2::{Span, TokenStream, TokenTree};
use quote::quote;
use syn::LitStr;

use crate::compile::expand;
use crate::language::{Report, decode, parse_macro, parse_text};

/// The expansion of `sweep! { … }` or `sweep!(file = "…")`: modules, or compile errors at the user's tokens.
///
/// A file is looked up from the folder of the calling crate's manifest. Its mistakes are reported at the file's name, and
/// say file, line and column.
#[must_use]
pub fn sweep(input: TokenStream) -> TokenStream {
    match file_argument(&input) {
        Some(path) => from_file(&path),
        None => from_body(input),
    }
}

/// The literal of `file = "…"`, if that is the whole input.
fn file_argument(input: &TokenStream) -> Option<LitStr> {
    let mut tokens = input.clone().into_iter();
    let is_file = matches!(tokens.next(), Some(TokenTree::Ident(name)) if name == "file");
    let is_equal = matches!(tokens.next(), Some(TokenTree::Punct(punct)) if punct.as_char() == '=');
    let literal = tokens.next()?;
    let rest: Vec<TokenTree> = tokens.collect();
    let comma = |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ',');
    if !is_file || !is_equal || rest.len() > 1 || !rest.iter().all(comma) {
        return None;
    }
    syn::parse2(TokenStream::from(literal)).ok()
}

fn from_body(input: TokenStream) -> TokenStream {
    let (file, source) = match parse_macro(input) {
        Ok(parsed) => parsed,
        Err(error) => return error.into_compile_error(),
    };
    let (tokens, diagnostics) = expand(&file);
    let errors = source.error(&diagnostics).map(syn::Error::into_compile_error);
    quote! { #errors #tokens }
}

fn from_file(literal: &LitStr) -> TokenStream {
    let fail = |message: String| syn::Error::new(literal.span(), message).into_compile_error();
    let name = literal.value();
    let folder = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from).unwrap_or_default();
    let bytes = match std::fs::read(folder.join(Path::new(&name))) {
        Ok(bytes) => bytes,
        Err(error) => {
            return fail(format!(
                "cannot read {name}: {error}; the path is relative to the folder of Cargo.toml"
            ));
        }
    };
    let parsed = decode(&name, &bytes).and_then(|text| parse_text(&name, text));
    let (file, source) = match parsed {
        Ok(parsed) => parsed,
        Err(report) => return fail(report.message()),
    };
    let (tokens, diagnostics) = expand(&file);
    if !diagnostics.is_empty() {
        return fail(Report::new(source, diagnostics).message());
    }
    let path = LitStr::new(&format!("/{name}"), Span::call_site());
    quote! {
        // The compiler reads the file again when it changes.
        const _: &[u8] = ::core::include_bytes!(::core::concat!(::core::env!("CARGO_MANIFEST_DIR"), #path));
        #tokens
    }
}
