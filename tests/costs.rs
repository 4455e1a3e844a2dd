//! What each entry of the catalogue may cost the compiler, in figures that are the same everywhere.
//!
//! `cargo run -p hodograph-tests --example costs` shows what it does cost, with times.

use std::collections::BTreeMap;

use hodograph_tests::cost::{Expansion, expanded};

/// The entries with the units of work and the tokens that their expansions may take: a little more than they do.
const CEILINGS: [(&str, u64, usize); 17] = [
    ("scaled_rotation_example_1", 20_000, 2_200),
    ("oriented_translation_example_2", 430_000, 3_100),
    ("offset_translation_example_3", 180_000, 2_700),
    ("offset_translation_example_3_square", 180_000, 2_900),
    ("offset_translation_example_3_negative_square", 180_000, 3_000),
    ("oriented_involute_example_4", 320_000, 3_600),
    ("evolute_sweep", 110_000, 3_500),
    ("generalized_conical_example_5", 460_000, 5_200),
    ("generalized_conical_quadratic", 710_000, 6_100),
    ("scaled_rotation_family", 8_400, 4_200),
    ("oriented_translation_family", 190_000, 8_300),
    ("oriented_translation_of_profiles", 150_000, 6_400),
    ("offset_translation_family", 240_000, 8_400),
    ("oriented_involute_family", 590_000, 9_200),
    ("evolute_sweep_family", 990_000, 11_600),
    ("generalized_conical_family", 710_000, 9_500),
    ("generalized_conical_quadratic_family", 330_000, 6_700),
];

/// A ceiling that is so many times as high as what it is for holds nothing.
const SLACK: u64 = 2;

#[test]
fn expansions_stay_below_their_ceilings() {
    let mut ceilings: BTreeMap<&str, (u64, usize)> =
        CEILINGS.map(|(name, units, tokens)| (name, (units, tokens))).into();
    assert_eq!(ceilings.len(), CEILINGS.len(), "an entry is there twice");
    let mut wrong = Vec::new();
    for entry in expanded() {
        let expansion = Expansion::of(&entry);
        let (units, tokens) = (expansion.units, expansion.tokens());
        let ceiling = ceilings.remove(entry.name);
        let held = |cost: u64, ceiling: u64| cost <= ceiling && ceiling <= SLACK * cost;
        let is_held =
            |ceiling: &(u64, usize)| held(units, ceiling.0) && held(tokens as u64, ceiling.1 as u64);
        if !ceiling.as_ref().is_some_and(is_held) {
            wrong.push(format!(
                "{} takes {units} units and {tokens} tokens; the ceilings are {ceiling:?}",
                entry.name
            ));
        }
    }
    wrong.extend(ceilings.keys().map(|name| format!("{name} is not in the catalogue")));
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn expansions_spend_the_same_each_time() {
    let entries = expanded();
    let first: Vec<u64> = entries.iter().map(|entry| Expansion::of(entry).units).collect();
    let again: Vec<u64> = entries.iter().rev().map(|entry| Expansion::of(entry).units).collect();
    assert!(first.iter().eq(again.iter().rev()), "{first:?}, backwards {again:?}");
}
