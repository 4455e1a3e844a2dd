//! The catalogue: a module for each sweep, expanded from its formula in `formulas/` at build time.

use hodograph_macros::sweep;

sweep!(file = "formulas/oriented_translation_example_2.sweep");
