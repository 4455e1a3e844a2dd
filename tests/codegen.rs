//! The code that is generated for the catalogue: what it reads like, that all doors give the same, that it compiles, and
//! that every program is proved.

use std::convert::Infallible;
use std::path::Path;

use hodograph_algebra::{Essentials, Poly};
use hodograph_codegen::compile::{check_program, compile, exact_program, expand};
use hodograph_codegen::emit::{Artifact, format, module, standalone};
use hodograph_codegen::expansion;
use hodograph_codegen::language::{parse_macro, read_input};
use hodograph_codegen::meaning::Model;
use hodograph_codegen::program::{Floats, Operation, Program, Value, Variant, interpret};
use hodograph_codegen::schedule::outputs;
use hodograph_tests::build::{built, rustc};
use hodograph_tests::catalogue::{entries, families, files, folder};
use proc_macro2::TokenStream;
use quote::quote;

/// Compares with `snapshots/codegen__NAME.snap`.
fn compare(name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

fn artifacts() -> Vec<Artifact> {
    let concrete = entries().into_iter().map(|entry| entry.model);
    let artifacts: Vec<Artifact> = concrete.chain(families()).map(|model| compile(&model).unwrap()).collect();
    assert!(!artifacts.is_empty());
    artifacts
}

/// The text of all modules over the package `hodograph`.
fn over_the_package(artifacts: &[Artifact]) -> String {
    let modules = artifacts.iter().map(|artifact| module(artifact, &quote!(::hodograph)));
    format(quote!(#(#modules)*)).unwrap()
}

#[test]
fn expansions_read_as_recorded() {
    for artifact in artifacts() {
        compare(&artifact.name, &over_the_package(std::slice::from_ref(&artifact)));
    }
}

#[test]
fn programs_read_as_recorded() {
    for artifact in artifacts() {
        compare(&format!("{}_program", artifact.name), &artifact.program.to_string());
    }
}

#[test]
fn every_door_gives_the_same_code() {
    for formulas in files().into_iter().filter(|formulas| formulas.is_expanded()) {
        let stem = &formulas.stem;
        let (from_text, diagnostics) = expand(&formulas.file);
        assert!(diagnostics.is_empty(), "{stem}");
        let from_text = format(from_text).unwrap();

        let tokens: TokenStream = formulas.text.parse().unwrap();
        let (mut file, _) = parse_macro(tokens.clone()).unwrap();
        let mut names_files = false;
        file.attach(|name| {
            names_files = true;
            read_input(&folder().join(name), name)
        });
        assert_eq!(format(expand(&file).0).unwrap(), from_text, "{stem}");
        // The files that a body names are in the folder of the manifest, where those of the catalogue are not.
        if !names_files {
            assert_eq!(format(expansion::sweep(tokens)).unwrap(), from_text, "{stem}");
        }

        // The macro's other form, which has the compiler watch the file and those that it names.
        let path = format!("../generated/formulas/{stem}.sweep");
        let from_file = format(expansion::sweep(quote!(file = #path))).unwrap();
        let (watch, code) = from_file.rsplit_once("\n);\n").unwrap_or_else(|| panic!("{from_file}"));
        assert_eq!(watch.matches("include_bytes!").count(), 1 + usize::from(names_files), "{watch}");
        assert_eq!(code, from_text, "{stem}");
    }
}

/// Runs rustc on `text` in a folder of its own with warnings denied; its messages if it fails.
fn compiles(folder: &Path, text: &str, arguments: &[&str]) -> Result<(), String> {
    let lints = ["-Dwarnings", "-Dmissing_docs", "-Dunsafe_code", "-Dunused", "-Drust_2018_idioms"];
    let file = folder.join("emitted.rs");
    std::fs::write(&file, text).unwrap();
    let output = rustc()
        .current_dir(folder)
        .args(["--edition", "2024"])
        .args(lints)
        .args(arguments)
        .arg(&file)
        .output();
    let output = output.unwrap();
    if output.status.success() { Ok(()) } else { Err(String::from_utf8_lossy(&output.stderr).into_owned()) }
}

#[test]
fn emitted_code_compiles_against_the_library_alone() {
    let folder = tempfile::tempdir().unwrap();
    let built = built();
    let text = std::format!("//! Surfaces.\n#![no_std]\n{}", over_the_package(&artifacts()));
    let library = std::format!("hodograph={}", built.library.display());
    let dependencies = std::format!("dependency={}", built.dependencies.display());
    let arguments = ["--crate-type", "lib", "--emit", "metadata", "--extern", &library, "-L", &dependencies];
    assert_eq!(compiles(folder.path(), &text, &arguments), Ok(()));
    let wrong = text.replace("::hodograph::Sweep for", "::hodograph::Curve for");
    assert!(compiles(folder.path(), &wrong, &arguments).is_err_and(|message| message.contains("Curve")));
}

/// Parameters at which a standalone program prints its points.
const PLACES: [(f64, f64); 5] = [(0.0, 0.0), (1.0, 1.0), (0.25, 0.75), (0.1, 0.9), (1.0 / 3.0, 0.7)];

#[test]
fn standalone_code_needs_nothing_and_gives_the_same_bits() {
    let folder = tempfile::tempdir().unwrap();
    let artifacts = artifacts();
    let runtime: Vec<(&str, &str)> = hodograph::runtime().iter().map(|file| (file.name, file.text)).collect();
    let text = standalone(&artifacts, &runtime).unwrap();
    assert!(!text.contains("hodograph"), "the text names the package");
    let library = std::format!("//! Surfaces.\n{text}");
    assert_eq!(compiles(folder.path(), &library, &["--crate-type", "lib", "--emit", "metadata"]), Ok(()));

    // The same text as a program that prints the bits of points and normals.
    let concrete: Vec<&Artifact> = artifacts.iter().filter(|artifact| artifact.symbols.is_empty()).collect();
    let surfaces = concrete.iter().map(|artifact| {
        let name: TokenStream = artifact.name.parse().unwrap();
        let kind: TokenStream = type_of(&artifact.name).parse().unwrap();
        quote!(&#name::#kind)
    });
    let places = PLACES.map(|(u, v)| quote!((#u, #v)));
    let main = quote! {
        fn main() {
            let bits = |point: [f64; 3]| point.map(f64::to_bits);
            let surfaces: &[&dyn runtime::Surface] = &[#(#surfaces),*];
            for surface in surfaces {
                for (u, v) in [#(#places),*] {
                    let normal = surface.unit_normal(u, v).ok().map(bits);
                    println!("{} {:?} {normal:?}", surface.name(), surface.point(u, v).ok().map(bits));
                }
            }
        }
    };
    let program = std::format!("//! A program.\n{text}\n{}", format(main).unwrap());
    assert_eq!(
        compiles(folder.path(), &program, &["-Adead_code", "--crate-name", "emitted", "-o", "emitted"]),
        Ok(())
    );
    let output = std::process::Command::new(folder.path().join("emitted")).output().unwrap();
    assert!(output.status.success());
    let mut expected = String::new();
    for artifact in concrete {
        for (u, v) in PLACES {
            // The build assumes no fused multiply-add of the machine.
            let floats = Floats { u, v, symbols: &[], variant: Variant::Plain };
            let bits = |output| {
                let numbers = interpret(&artifact.program, artifact.program.results(output), &floats).ok();
                let numbers = numbers.filter(|numbers| numbers.iter().all(|number| number.is_finite()));
                numbers.map(|numbers| numbers.iter().map(|number| number.to_bits()).collect::<Vec<u64>>())
            };
            let (point, normal) = (bits(outputs::POINT), bits(outputs::UNIT_NORMAL));
            expected.push_str(&std::format!("{} {point:?} {normal:?}\n", artifact.name));
        }
    }
    assert_eq!(String::from_utf8_lossy(&output.stdout), expected);
}

/// The name of a surface's type: `AName` for `a_name`.
fn type_of(name: &str) -> String {
    let capital = |word: &str| word[..1].to_uppercase() + &word[1..];
    name.split('_').map(capital).collect()
}

/// Every expanded sweep, families too, with its program.
fn programs() -> Vec<(Model, Essentials, Program<Poly>)> {
    let concrete = entries().into_iter().map(|entry| entry.model);
    let with_program = |model: Model| {
        let essentials = model.surface.as_ref().unwrap().essentials().unwrap();
        let program = exact_program(&model, &essentials).unwrap();
        (model, essentials, program)
    };
    concrete.chain(families()).map(with_program).collect()
}

#[test]
fn programs_are_proved() {
    for (model, essentials, program) in programs() {
        assert_eq!(check_program(&model, &essentials, &program), Ok(()), "{}", model.name);
    }
}

#[test]
fn no_changed_constant_passes_the_proof() {
    // The pieces of one surface are alike.
    let mut programs = programs();
    programs.retain(|(model, ..)| model.piece.as_ref().is_none_or(|piece| piece.index == 0));
    for (model, essentials, program) in programs {
        let name = &model.name;
        let proved = program.outputs().iter().flat_map(|output| output.values.clone());
        let needed = program.needed(&proved.collect::<Vec<Value>>());
        let is_constant = |value: &Value| matches!(program.operation(*value), Operation::Constant(_));
        let constants: Vec<Value> = program.values().filter(is_constant).collect();
        assert!(needed.iter().any(is_constant), "{name}");
        for (changed, _) in constants.iter().enumerate().filter(|(_, value)| needed.contains(value)) {
            let mut place = 0;
            let broken: Result<Program<Poly>, Infallible> = program.map_constants(|constant| {
                place += 1;
                Ok(if place - 1 == changed { constant + &Poly::one() } else { constant.clone() })
            });
            let Ok(broken) = broken;
            assert!(
                check_program(&model, &essentials, &broken).is_err(),
                "{name} with another constant {changed}"
            );
        }
    }
}

#[test]
fn no_exchange_of_parameters_passes_the_proof() {
    for (model, mut essentials, program) in programs() {
        essentials.parameters.swap(0, 1);
        assert!(check_program(&model, &essentials, &program).is_err(), "{}", model.name);
    }
}
