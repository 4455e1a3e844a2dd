//! `hodograph emit`: the generated source.

use std::path::Path;
use std::process::ExitCode;

use hodograph_codegen::compile::compile_all;
use hodograph_codegen::emit;
use hodograph_codegen::language::{Diagnostic, Diagnostics, Report};
use hodograph_codegen::meaning::Model;
use quote::quote;

use crate::args::{EmitArguments, Target};
use crate::console::{self, Progress};
use crate::failure::Failure;
use crate::input::{self, Document};
use crate::output::{self, quoted};

/// Runs the command.
///
/// # Errors
/// Bad input; a surface without evaluator; a file that cannot be written.
pub(crate) fn run(arguments: &EmitArguments) -> Result<ExitCode, Failure> {
    let document = input::load(&arguments.input.input, arguments.budget.limit)?;
    let text = source(&document, arguments)?;
    match &arguments.output {
        None => console::print(&text)?,
        Some(path) if arguments.check => return output::check(path, &text, &mending(path, arguments)),
        Some(path) => output::write(path, &text)?,
    }
    Ok(ExitCode::SUCCESS)
}

/// The source of all sweeps that were asked for.
fn source(document: &Document, arguments: &EmitArguments) -> Result<String, Failure> {
    let progress = Progress::new();
    let mut artifacts = Vec::new();
    let mut diagnostics = Diagnostics::new();
    let models = document.sweeps(arguments.input.sweep.as_deref())?;
    let shown = models.iter().copied().inspect(|model| progress.show(&format!("compiling {}", model.name)));
    for (model, artifact) in compile_all(shown) {
        match artifact {
            Ok(artifact) => artifacts.push(artifact),
            Err(error) => diagnostics.push(Diagnostic::new(model.place, error.to_string())),
        }
    }
    if !diagnostics.is_empty() {
        return Err(Failure::Report(Box::new(Report::new(document.source.clone(), diagnostics))));
    }
    if arguments.target == Target::C {
        return emit::header(&artifacts).map_err(|clash| {
            let help = "rename one of them, or emit each into a header of its own with `--sweep`";
            let is_second = |model: &&Model| model.name == clash.second || model.item_name() == clash.second;
            match models.iter().copied().find(is_second) {
                Some(model) => {
                    let wrong = Diagnostic::new(model.place, clash.to_string());
                    Failure::at(&document.source, wrong.help(help))
                }
                None => Failure::new(clash.to_string()).help(help),
            }
        });
    }
    let text = if arguments.standalone {
        let runtime: Vec<(&str, &str)> =
            hodograph::runtime().iter().map(|file| (file.name, file.text)).collect();
        emit::standalone(&artifacts, &runtime)
    } else {
        emit::format(emit::modules(&artifacts, &quote!(::hodograph)))
    };
    text.map_err(|error| Failure::new(format!("the generated source is not valid Rust: {error}")))
}

/// The command that writes the file.
fn mending(path: &Path, arguments: &EmitArguments) -> String {
    let mut command = format!("hodograph emit {}", quoted(&arguments.input.input));
    if let Some(sweep) = &arguments.input.sweep {
        command += &format!(" --sweep {}", quoted(sweep));
    }
    command += match arguments.target {
        Target::Rust => " --target rust",
        Target::C => " --target c",
    };
    if arguments.standalone {
        command += " --standalone";
    }
    format!("{command} -o {}", quoted(&path.display().to_string()))
}
