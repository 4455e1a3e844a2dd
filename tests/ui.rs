//! What users of `sweep!` read when something is wrong with their input: our messages, at their tokens.

use std::path::Path;

use hodograph_tests::build::target_folder;

#[test]
fn mistakes_are_explained() {
    // Files are looked up from the folder of the calling crate, which is trybuild's.
    let crate_folder = target_folder().join("tests/trybuild/hodograph-tests");
    std::fs::create_dir_all(&crate_folder).unwrap();
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("ui");
    let mut included = 0;
    for file in std::fs::read_dir(&own).unwrap().flatten() {
        if file.path().extension().is_some_and(|extension| extension == "sweep") {
            std::fs::copy(file.path(), crate_folder.join(file.file_name())).unwrap();
            included += 1;
        }
    }
    assert!(included > 0, "{} holds no file to include", own.display());
    trybuild::TestCases::new().compile_fail("ui/*.rs");
}
