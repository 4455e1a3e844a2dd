//! The results of the workloads that are timed: their terms and hashes, which other computer algebra systems agree on.

#[path = "../examples/workloads/hash.rs"]
mod hash;
#[path = "../examples/workloads/products.rs"]
mod products;
#[path = "../examples/workloads/sweeps.rs"]
mod sweeps;

use hodograph_algebra::Poly;

fn check(name: &str, result: &[Poly], variables: &[&str], terms: &[usize], hash: u64) {
    let found: Vec<usize> = result.iter().map(|poly| poly.terms().len()).collect();
    assert_eq!((found.as_slice(), hash::hash(result, variables)), (terms, hash), "{name}");
    assert!(result.iter().all(Poly::is_valid), "{name}");
}

#[test]
fn homogeneous_coordinates() {
    let check = |name, surface: &_, terms: &[usize], hash| {
        check(name, &sweeps::coordinates(surface), sweeps::VARIABLES, terms, hash);
    };
    check("translation", &sweeps::translation(), &[72, 578, 672, 36], 2_080_522_242_622_299_795);
    check("involute", &sweeps::involute(), &[72, 296, 470, 36], 1_233_508_153_502_845_049);
    let conical = sweeps::conical(sweeps::symbolic_path());
    check("conical", &conical, &[468, 4304, 4034, 842], 1_814_613_368_754_324_962);
}

#[test]
fn normals() {
    let check = |name, surface: &_, variables: &[&str], terms: &[usize], hash| {
        check(name, &sweeps::normal(surface), variables, terms, hash);
    };
    check("translation", &sweeps::translation(), sweeps::VARIABLES, &[54, 72, 36], 57_180_347_496_603_980);
    let (numeric, symbolic) =
        (sweeps::conical(sweeps::numeric_path()), sweeps::conical(sweeps::symbolic_path()));
    check("conical", &numeric, sweeps::PARAMETERS_AND_SCALE, &[103, 103, 70], 55_646_917_759_354_291);
    check("conical, full", &symbolic, sweeps::VARIABLES, &[22_030, 22_137, 17_198], 929_716_752_535_679_421);
}

#[test]
fn plain_products() {
    check("fateman", &products::fateman()(), products::FIVE, &[20_475], 44_907_762_978_070_011);
    check("sparse", &products::sparse()(), products::FIVE, &[2_096_600], 825_953_556_311_143_379);
}

#[test]
fn plain_gcds() {
    let check = |text, terms, hash| check("gcd", &products::gcd(text)(), products::FOUR, &[terms], hash);
    check(include_str!("../examples/workloads/gcd_small.txt"), 50, 36_166_127_560);
    check(include_str!("../examples/workloads/gcd_middle.txt"), 100, 2_963_845_060_273);
    check(include_str!("../examples/workloads/gcd_large.txt"), 200, 544_160_219_396_196);
}
