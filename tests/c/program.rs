//! Programs in C: what they begin with, how they are compiled and run, and what they are expected to print.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use crate::functions::{TYPES, Type};

/// Options that every file is compiled with.
const OPTIONS: [&str; 6] = ["-ffp-contract=off", "-O2", "-Wall", "-Wextra", "-Werror", "-pedantic"];

/// The languages that the header is written in.
pub(crate) const LANGUAGES: [[&str; 3]; 2] = [["-x", "c", "-std=c11"], ["-x", "c++", "-std=c++11"]];

/// What the compiler does with a file in one of the languages; `None` if there is no compiler.
pub(crate) fn cc(folder: &Path, language: [&str; 3], arguments: &[&str]) -> Option<Output> {
    let mut command = Command::new("cc");
    match command.args(language).args(OPTIONS).args(arguments).current_dir(folder).output() {
        Ok(output) => Some(output),
        Err(error) => {
            eprintln!("not tested, since there is no C compiler: cc: {error}");
            None
        }
    }
}

/// Whether there is a compiler for a language.
pub(crate) fn has_compiler(folder: &Path, language: [&str; 3]) -> bool {
    fs::write(folder.join("nothing.c"), "int main(void) { return 0; }\n").unwrap();
    cc(folder, language, &["-fsyntax-only", "nothing.c"]).is_some_and(|output| output.status.success())
}

/// Compiles `main.c` and gives what the program prints.
pub(crate) fn run(folder: &Path, language: [&str; 3]) -> String {
    let output = cc(folder, language, &["main.c", "-o", "program", "-lm"]).unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let output = Command::new(folder.join("program")).output().unwrap();
    assert!(output.status.success(), "{output:?}");
    String::from_utf8(output.stdout).unwrap()
}

/// A line that is expected, with what it is about.
pub(crate) type Expected = Vec<(String, String)>;

/// What prints and compares numbers.
const PRINTING: &str = r#"
static const char *const reasons[] = {"", "pole", "singular", "parameter", "overflow"};

static void report(bool equal, hodograph_missing missing, hodograph_missing expected)
{
    const bool agree = equal && missing.count == expected.count && missing.first == expected.first;
    printf("%s, %lu missing from %lu\n", agree ? "equal" : "different", (unsigned long)missing.count, (unsigned long)missing.first);
}
"#;

/// The same for each precision.
const PRINTING_OF: &str = r#"
static void putF(hodograph_status status, const void *numbers, size_t count)
{
    for (size_t i = 0; status == HODOGRAPH_OK && i < count; i++) {
        BITS bits;
        memcpy(&bits, (const char *)numbers + i * sizeof bits, sizeof bits);
        printf("%s%0DIGITS" FORMAT, i > 0 ? " " : "", bits);
    }
    puts(reasons[status]);
}

static bool sameF(hodograph_status status, const void *one, const void *item, size_t count, REAL none, size_t place, hodograph_missing *missing)
{
    const hodograph_missing here = {1, 0};
    bool same = true;
    if (status == HODOGRAPH_OK)
        return memcmp(one, item, count * sizeof none) == 0;
    hodograph_add(missing, here, place);
    for (size_t i = 0; i < count; i++)
        same &= memcmp(&none, (const char *)item + i * sizeof none, sizeof none) == 0;
    return same;
}

"#;

/// The beginning of a program: the header, and what prints numbers.
pub(crate) fn beginning() -> String {
    let mut text = String::from("#include \"surfaces.h\"\n#include <inttypes.h>\n#include <stdio.h>\n");
    text.push_str(PRINTING);
    for (Type { name, suffix, bits, .. }, [digits, format]) in
        TYPES.into_iter().zip([["16", "PRIx64"], ["8", "PRIx32"]])
    {
        let replaced = PRINTING_OF.replace("putF", &format!("put{suffix}"));
        let replaced = replaced.replace("sameF", &format!("same{suffix}")).replace("BITS", bits);
        text.push_str(&replaced.replace("DIGITS", digits).replace("FORMAT", format).replace("REAL", name));
    }
    text
}

/// Compares what a program prints, line by line.
pub(crate) fn compare(printed: &str, expected: &Expected) {
    for (found, (label, line)) in printed.lines().zip(expected) {
        assert_eq!(found, line, "{label}");
    }
    assert_eq!(printed.lines().count(), expected.len());
}
