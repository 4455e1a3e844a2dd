//! Emitted surfaces: they parse, and say what they should.

use hodograph_algebra::Poly;
use quote::quote;

use super::{Artifact, documentation, format, module, standalone};
use crate::compile::compile;
use crate::language::parse_text;
use crate::meaning::models;
use crate::round::round;
use crate::schedule::tests::{Example, bilinear, plane, quintic_translation, scheduled};

fn artifact(name: &str, example: &Example) -> Artifact {
    let exact = scheduled(example);
    let degree = |poly: &Poly, variable| poly.degree(variable).map_or(-1, i64::from);
    let coordinate_degrees =
        example.homogeneous.each_ref().map(|c| (degree(c, &example.u), degree(c, &example.v)));
    let largest =
        |degrees: [i64; 4]| degrees.into_iter().max().and_then(|d| u32::try_from(d).ok()).unwrap_or(0);
    Artifact {
        name: name.to_string(),
        documentation: vec!["A surface made by hand.".to_string()],
        formula: "R(u, v) = s + p.x * s.normal + p.z * k".to_string(),
        source: Some("Farouki & Nittler 2014, eq. (17)".to_string()),
        coordinate_degrees,
        degree: (largest(coordinate_degrees.map(|d| d.0)), largest(coordinate_degrees.map(|d| d.1))),
        domain: [[0.0, 1.0], [0.0, 1.0]],
        symbols: Vec::new(),
        control_net: vec![[1.0, 0.5, -0.25, 1e-7]],
        proofs: None,
        offset: None,
        piece: None,
        is_accurate: false,
        program: round(&exact.fused()).unwrap(),
    }
}

#[test]
fn modules_read_well() {
    let tokens = module(&artifact("circle_translation", &quintic_translation()), &quote! { ::hodograph });
    assert_eq!(format(tokens).unwrap(), include_str!("translation.expected"));
}

#[test]
fn parameters_that_are_not_read_are_marked() {
    let text = format(module(&artifact("plane", &plane()), &quote! { ::hodograph })).unwrap();
    assert!(text.contains("fn of_u<R: ::hodograph::Real>(&self, _u: R) -> [R; 0] {"), "{text}");
    assert!(text.contains("[R::of(0.0), R::of(0.0), R::of(1.0)]"), "{text}");
    let text = format(module(&artifact("bilinear_patch", &bilinear()), &quote! { ::hodograph })).unwrap();
    assert!(text.contains("pub struct BilinearPatch;"), "{text}");
    assert!(text.contains("R::scale("), "{text}");
}

#[test]
fn standalone_text_names_no_package() {
    let surface = "//! The trait.\n\n/// A surface.\n///\n/// ```\n/// use hodograph::Surface;\n/// ```\npub trait Surface {}\n";
    let runtime = [("surface", surface)];
    let text =
        standalone(&[artifact("patch", &bilinear()), artifact("other", &quintic_translation())], &runtime)
            .unwrap();
    assert!(!text.contains("hodograph"), "{text}");
    assert!(!text.contains("cfg(test"), "{text}");
    assert!(text.contains("pub trait Surface"));
}

/// Squares of the coordinates overflow in single precision, and what is computed together with them has no bound in it.
#[test]
fn what_overflows_in_one_precision_has_no_bound_in_it() {
    let text = "sweep big { surface R = (1e25*u, 1e25*v, 1e25*u*v); domain u in 1..2, v in 1..2; }";
    let (file, _source) = parse_text("big", text).unwrap();
    let (models, _) = models(&file);
    let artifact = compile(&models[0]).unwrap();
    for bound in &artifact.proofs.as_ref().unwrap().bounds {
        let overflows =
            !["homogeneous", "point", "unit_normal"].contains(&bound.name) && !bound.name.contains("partial");
        let in_single = bound.name == "separated_point" || !overflows;
        assert_eq!(bound.errors.map(f64::is_finite), [true, true, in_single, in_single], "{}", bound.name);
    }
    let lines = documentation::lines(&artifact);
    let start = "- No bound for the error of ";
    let boundless: Vec<&str> = lines.iter().filter_map(|line| line.strip_prefix(start)).collect();
    let names: Vec<&str> = boundless.iter().filter_map(|line| line.split(" in `f32`: ").next()).collect();
    let expected =
        ["first form", "second form", "gaussian", "mean", "principal", "speeds", "normal u", "normal v"];
    assert_eq!(names, expected);
}

#[test]
fn names_are_their_authors() {
    let runtime = [("surface", "pub trait Surface {}")];
    let text =
        standalone(&[artifact("runtime", &bilinear()), artifact("Patch", &plane())], &runtime).unwrap();
    assert!(text.contains("pub mod runtime_of_surfaces {"), "{text}");
    assert!(text.contains("impl super::runtime_of_surfaces::Patch for Runtime {"), "{text}");
    assert!(!text.contains("super::runtime::"), "{text}");
    assert_eq!(text.matches("#[allow(non_snake_case)]\npub mod Patch {").count(), 1, "{text}");
    assert_eq!(text.matches("non_snake_case").count(), 1, "{text}");
}
