//! The procedural macro [`sweep!`].

use proc_macro::TokenStream;

/// Expands sweeps to documented modules with their evaluators, at build time.
///
/// The input is the text of the sweep language, or `file = "…"` with the path of a `.sweep` file relative to the folder
/// of the crate's `Cargo.toml`. Files that the text names, such as `frames_file("turn.json")`, are looked up from the folder of the
/// `.sweep` file, or else from that of `Cargo.toml`. Each sweep becomes a module of its name with a unit struct that implements
/// `hodograph::Surface`; lemmas generate nothing. Claims are checked as far as a small budget goes: a false claim does
/// not compile.
///
/// ```text
/// hodograph::sweep! {
///     sweep paraboloid {
///         surface R = u*i + v*j + (u^2 + v^2)*k;
///         domain u in 0..1, v in 0..1;
///         claim "degree": degree(Z) == (2, 2);
///     }
/// }
/// ```
#[proc_macro]
pub fn sweep(input: TokenStream) -> TokenStream {
    hodograph_codegen::expansion::sweep(input.into()).into()
}
