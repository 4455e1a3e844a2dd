//! Compiles the sweep of this package into `OUT_DIR`.

use hodograph_codegen::{BuildError, Builder};

fn main() -> Result<(), BuildError> {
    Builder::new().file("formulas/gutter.sweep").build()?;
    Ok(())
}
