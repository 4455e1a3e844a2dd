//! What the macro `sweep!` expands to.

use std::path::{Path, PathBuf};

use proc_macro2::{Span, TokenStream, TokenTree};
use quote::quote;
use syn::LitStr;

use crate::compile::expand;
use crate::language::ast::File;
use crate::language::{Report, decode, parse_macro, parse_text, read_input};

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
    let (mut file, source) = match parse_macro(input) {
        Ok(parsed) => parsed,
        Err(error) => return error.into_compile_error(),
    };
    let tracked = attach(&mut file, Path::new(""));
    let (tokens, diagnostics) = expand(&file);
    let errors = source.error(&diagnostics).map(syn::Error::into_compile_error);
    quote! { #errors #tracked #tokens }
}

fn from_file(literal: &LitStr) -> TokenStream {
    let fail = |message: String| syn::Error::new(literal.span(), message).into_compile_error();
    let name = literal.value();
    let bytes = match std::fs::read(manifest_folder().join(Path::new(&name))) {
        Ok(bytes) => bytes,
        Err(error) => {
            return fail(format!(
                "cannot read {name}: {error}; the path is relative to the folder of Cargo.toml"
            ));
        }
    };
    let parsed = decode(&name, &bytes).and_then(|text| parse_text(&name, text));
    let (mut file, source) = match parsed {
        Ok(parsed) => parsed,
        Err(report) => return fail(report.message()),
    };
    let tracked = attach(&mut file, Path::new(&name).parent().unwrap_or(Path::new("")));
    let (tokens, diagnostics) = expand(&file);
    if !diagnostics.is_empty() {
        return fail(Report::new(source, diagnostics).message());
    }
    let own = tracking(&name);
    quote! { #own #tracked #tokens }
}

/// Reads the files that a source names, from a folder relative to that of the manifest. What is returned makes the compiler read
/// them again when they change.
fn attach(file: &mut File, folder: &Path) -> TokenStream {
    let mut tracked = TokenStream::new();
    file.attach(|name| {
        let path = folder.join(name);
        let text = read_input(&manifest_folder().join(&path), name)?;
        if let Some(path) = path.to_str() {
            tracked.extend(tracking(path));
        }
        Ok(text)
    });
    tracked
}

fn manifest_folder() -> PathBuf {
    std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from).unwrap_or_default()
}

/// An item by which the compiler knows that the code depends on a file.
fn tracking(path: &str) -> TokenStream {
    if Path::new(path).is_absolute() {
        let path = LitStr::new(path, Span::call_site());
        return quote! { const _: &[u8] = ::core::include_bytes!(#path); };
    }
    let path = LitStr::new(&format!("/{path}"), Span::call_site());
    quote! {
        const _: &[u8] = ::core::include_bytes!(::core::concat!(::core::env!("CARGO_MANIFEST_DIR"), #path));
    }
}

#[cfg(test)]
mod tests {
    use super::sweep;

    #[test]
    fn files_of_frames_are_tracked() {
        let text = |name: &str| {
            format!(
                "sweep turn {{ frames F(v) = frames_file({name:?}, orientation = direct, continuity = 1); \
                 surface R = F.sweep((0, u, 0)); domain u in 0..1; }}"
            )
        };
        let expansion = |text: String| sweep(text.parse().unwrap()).to_string();
        let name = "../generated/formulas/gutter.json";
        let generated = expansion(text(name));
        assert!(!generated.contains("compile_error"), "{generated}");
        assert!(
            generated.contains("include_bytes")
                && generated.contains("\"/../generated/formulas/gutter.json\"")
        );
        let missing = expansion(text("none.json"));
        assert!(missing.contains("compile_error") && missing.contains("cannot read none.json"), "{missing}");
    }
}
