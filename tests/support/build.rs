//! What tests build and run: the command, the library, and Rust sources on their own.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use serde_json::Value;

/// What the workspace builds for users, in the profile of the running test.
#[derive(Clone, Debug)]
pub struct Built {
    /// The command `hodograph`.
    pub binary: PathBuf,
    /// The examples of all packages, by name.
    pub examples: BTreeMap<String, PathBuf>,
    /// The compiled library `hodograph`.
    pub library: PathBuf,
    /// The folder of the compiled libraries that it names.
    pub dependencies: PathBuf,
}

/// The target folder of the running test: it lies in `target/<profile>/deps`.
///
/// # Panics
/// If a test runs elsewhere.
#[must_use]
pub fn target_folder() -> PathBuf {
    profile_folder()
        .parent()
        .map(Path::to_owned)
        .unwrap_or_else(|| panic!("tests are built in a target folder"))
}

fn profile_folder() -> PathBuf {
    let own = std::env::current_exe().unwrap_or_else(|error| panic!("a running test has a path: {error}"));
    let folder = own.ancestors().nth(2).map(Path::to_owned);
    folder.unwrap_or_else(|| panic!("{} is not in a target folder", own.display()))
}

/// The command and the library, built once a test run where they are not up to date.
///
/// # Panics
/// If the build fails.
pub fn built() -> &'static Built {
    static BUILT: OnceLock<Built> = OnceLock::new();
    BUILT.get_or_init(|| {
        let mut cargo = Command::new(env!("CARGO"));
        // With examples and the profile of tests, features and settings of all packages are those of `cargo test`, so that only
        // the command is compiled.
        cargo.args(["build", "--offline", "--message-format", "json", "--workspace", "--bins", "--examples"]);
        let profile = if profile_folder().ends_with("debug") { "test" } else { "release" };
        cargo.args(["--profile", profile]);
        cargo.current_dir(env!("CARGO_MANIFEST_DIR")).env("CARGO_TARGET_DIR", target_folder());
        let output = cargo.output().unwrap_or_else(|error| panic!("cargo: {error}"));
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let messages: Vec<Value> = String::from_utf8_lossy(&output.stdout)
            .lines()
            .filter_map(|line| serde_json::from_str(line).ok())
            .collect();
        let of = |kind: &'static str| {
            let is_kind = move |target: &Value| target["name"] == "hodograph" && target["kind"][0] == kind;
            messages.iter().filter(move |message| is_kind(&message["target"]))
        };
        let binary = of("bin").find_map(|message| message["executable"].as_str());
        let library = of("lib")
            .filter_map(|message| message["filenames"].as_array())
            .flatten()
            .filter_map(Value::as_str)
            .find(|name| name.ends_with(".rlib"));
        let is_example = |message: &&Value| message["target"]["kind"][0] == "example";
        let named = |message: &Value| {
            let name = message["target"]["name"].as_str()?;
            Some((name.to_owned(), message["executable"].as_str()?.into()))
        };
        let examples = messages.iter().filter(is_example).filter_map(named).collect();
        let (Some(binary), Some(library)) = (binary, library) else {
            panic!("cargo names no command or no library: {messages:?}")
        };
        let dependencies = profile_folder().join("deps");
        Built { binary: binary.into(), examples, library: library.into(), dependencies }
    })
}

/// The compiler that built the workspace.
#[must_use]
pub fn rustc() -> Command {
    let cargo = Path::new(env!("CARGO"));
    let beside = cargo.with_file_name(format!("rustc{}", std::env::consts::EXE_SUFFIX));
    Command::new(if beside.exists() { beside } else { "rustc".into() })
}
