//! The commands of the README, run as it shows them.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use hodograph_tests::build::built;

/// A command of a fenced block, with the output that the block shows after it.
#[derive(Debug, PartialEq, Eq)]
struct Shown {
    line: usize,
    command: String,
    output: Vec<String>,
}

/// The folder of the workspace.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The commands of all `sh` and `console` blocks. In a `console` block they follow `$ `, and other lines are output; a
/// backslash at a line's end continues it.
fn commands(text: &str) -> Vec<Shown> {
    let mut all: Vec<Shown> = Vec::new();
    let mut language = None;
    let mut continued = false;
    for (index, line) in text.lines().enumerate() {
        if let Some(fence) = line.trim_start().strip_prefix("```") {
            language = if language.is_none() { Some(fence.trim().to_owned()) } else { None };
            continued = false;
            continue;
        }
        let command = match language.as_deref() {
            Some("sh" | "bash" | "shell") => {
                Some(line).filter(|line| !line.trim().is_empty() && !line.starts_with('#'))
            }
            Some("console") => line.strip_prefix("$ ").or_else(|| continued.then_some(line)),
            _ => continue,
        };
        match (command, all.last_mut()) {
            (Some(command), last) => {
                let (part, more) = match command.strip_suffix('\\') {
                    Some(part) => (part, true),
                    None => (command, false),
                };
                match last {
                    Some(last) if continued => last.command.push_str(part),
                    _ => all.push(Shown { line: index + 1, command: part.to_owned(), output: Vec::new() }),
                }
                continued = more;
            }
            (None, Some(last)) if language.as_deref() == Some("console") => last.output.push(line.to_owned()),
            (None, _) => {}
        }
    }
    all
}

/// Whether a command is of those that no test runs: the tests themselves, and comparisons with other programs.
fn is_left_out(command: &str) -> bool {
    ["cargo test", "cargo bench", "cargo install", ".ci/"].iter().any(|start| command.starts_with(start))
}

/// The command with the built binary, or the built example, in place of `cargo run …`.
fn on_the_binary(command: &str) -> String {
    let built = built();
    if let Some(rest) = command.strip_prefix("cargo run") {
        let (options, arguments) = rest.split_once(" -- ").unwrap_or((rest, ""));
        let program = match options.split_once(" --example ") {
            None => &built.binary,
            Some((_, name)) => {
                built.examples.get(name.trim()).unwrap_or_else(|| panic!("there is no example of {command}"))
            }
        };
        return format!("'{}' {arguments}", program.display()).trim_end().to_owned();
    }
    match command.strip_prefix("hodograph") {
        Some(rest) if rest.is_empty() || rest.starts_with(' ') => {
            format!("'{}'{rest}", built.binary.display())
        }
        _ => command.to_owned(),
    }
}

#[test]
fn blocks_are_read_as_meant() {
    let text = "# Title\n```sh\ncargo run --release\n# a comment\nhodograph verify \\\n  a.sweep\n```\ntext\n```console\n$ hodograph derive x\n\
                line one\nline two\n```\n```rust\n$ no command\n```\n";
    let shown = |line, command: &str, output: &[&str]| Shown {
        line,
        command: command.to_owned(),
        output: output.iter().map(ToString::to_string).collect(),
    };
    let expected = [
        shown(3, "cargo run --release", &[]),
        shown(5, "hodograph verify   a.sweep", &[]),
        shown(10, "hodograph derive x", &["line one", "line two"]),
    ];
    assert_eq!(commands(text), expected);
    assert!(is_left_out("cargo test") && !is_left_out("cargo run --release"));
    let verify = format!("'{}' verify a.sweep", built().binary.display());
    for command in
        ["cargo run --release -- verify a.sweep", "cargo run -- verify a.sweep", "hodograph verify a.sweep"]
    {
        assert_eq!(on_the_binary(command), verify);
    }
    let costs = on_the_binary("cargo run --release -p hodograph-tests --example costs -- --runs 1");
    assert_eq!(costs, format!("'{}' --runs 1", built().examples["costs"].display()));
    assert_eq!(on_the_binary("cargo run --release"), format!("'{}'", built().binary.display()));
}

#[test]
fn commands_do_what_is_shown() {
    let text = std::fs::read_to_string(root().join("README.md")).unwrap();
    let commands = commands(&text);
    let run: Vec<&Shown> = commands.iter().filter(|shown| !is_left_out(&shown.command)).collect();
    assert!(!run.is_empty(), "the README shows no command");
    // Commands run beside the catalogue, and leave what they write in a folder of their own.
    let folder = tempfile::tempdir().unwrap();
    for name in ["generated", "algebra", "codegen"] {
        #[cfg(unix)]
        std::os::unix::fs::symlink(root().canonicalize().unwrap().join(name), folder.path().join(name))
            .unwrap();
    }
    for shown in run {
        let command = on_the_binary(&shown.command);
        let output = Command::new("sh")
            .args(["-c", &command])
            .current_dir(folder.path())
            .env("NO_COLOR", "1")
            .stdin(Stdio::null())
            .output()
            .unwrap();
        let (out, err) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
        let place = format!("README.md:{}: {}", shown.line, shown.command);
        assert!(output.status.success(), "{place}\n{out}{err}");
        let mut lines = out.lines();
        for expected in shown.output.iter().filter(|line| !matches!(line.trim(), "…" | "..." | "")) {
            let found = lines.any(|line| line.trim_end() == expected.trim_end());
            assert!(found, "{place}\ndoes not print, in this order: {expected}\nbut\n{out}{err}");
        }
    }
}
