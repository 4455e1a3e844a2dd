//! Times of rustc for generated code.

use std::fs;
use std::io;
use std::path::Path;
use std::process::Stdio;
use std::time::{Duration, Instant};

use hodograph_tests::build::rustc;
use tempfile::TempDir;

/// How much the compiler does.
#[derive(Clone, Copy)]
pub(crate) enum Level {
    /// What `cargo build` asks for.
    Plain,
    /// What `cargo build --release` asks for.
    Optimizing,
}

/// A compiler at a level, with the runtime of generated code compiled for it.
pub(crate) struct Compiler {
    level: Level,
    folder: TempDir,
    /// The time for a crate that is empty but for the runtime's name.
    empty: Duration,
}

/// The parts of the runtime that generated code uses.
const RUNTIME: &str = "
pub use batch::{Batch, BatchError};
pub use bounds::{Bound, Bounds};
pub use dispatch::Variant;
pub use family::ParameterError;
pub use real::{Float, Fused, Plain, Real, constants, horner};
pub use surface::{Domain, Patch, Surface, offset_net};
pub use task::{First, Homogeneous, Local, Normal, Point, Second, Separated, Stages, Sweep};
";

/// The crate without anything generated.
const EMPTY: &str = "pub use hodograph::Surface;\n";

impl Compiler {
    /// Compiles the runtime, the package `hodograph` without its catalogue.
    ///
    /// # Errors
    /// Why rustc does not run or fails.
    pub(crate) fn new(level: Level, runs: u32) -> io::Result<Compiler> {
        let mut compiler = Compiler { level, folder: tempfile::tempdir()?, empty: Duration::ZERO };
        let float = Path::new(env!("CARGO_MANIFEST_DIR")).join("../generated/src/float.rs");
        let mut runtime = format!("#[path = {float:?}]\npub mod float;\n{RUNTIME}");
        for source in hodograph::runtime() {
            fs::write(compiler.folder.path().join(source.name).with_extension("rs"), source.text)?;
            runtime += &format!("pub mod {};\n", source.name);
        }
        compiler.compile("hodograph", &runtime)?;
        compiler.empty = compiler.time(EMPTY, runs)?;
        Ok(compiler)
    }

    /// The shortest time of some runs for `code`, beyond that for an empty crate.
    ///
    /// # Errors
    /// Why rustc does not run or fails.
    pub(crate) fn time(&self, code: &str, runs: u32) -> io::Result<Duration> {
        let mut shortest = Duration::MAX;
        for _ in 0..runs {
            shortest = shortest.min(self.compile("entry", code)?);
        }
        Ok(shortest.saturating_sub(self.empty))
    }

    /// Compiles a library, and gives the time that it took.
    fn compile(&self, name: &str, text: &str) -> io::Result<Duration> {
        let file = format!("{name}.rs");
        fs::write(self.folder.path().join(&file), text)?;
        let mut command = rustc();
        command.args([
            "--edition=2024",
            "--crate-type=rlib",
            "-Ccodegen-units=1",
            "-L.",
            "--cfg=feature=\"std\"",
        ]);
        command.args(match self.level {
            Level::Plain => ["-Copt-level=0", "-Cdebuginfo=2"],
            Level::Optimizing => ["-Copt-level=3", "-Cdebuginfo=0"],
        });
        if name != "hodograph" {
            command.arg("--extern=hodograph");
        }
        command.args(["--cap-lints=allow", &file]).current_dir(self.folder.path()).stdin(Stdio::null());
        let start = Instant::now();
        let output = command.output()?;
        let time = start.elapsed();
        if output.status.success() {
            return Ok(time);
        }
        Err(io::Error::other(format!("rustc: {}", String::from_utf8_lossy(&output.stderr).trim())))
    }
}
