//! What each entry of the catalogue may cost the compiler, in figures that are the same everywhere.
//!
//! `cargo run -p hodograph-tests --example costs` shows what it does cost, with times.

use std::collections::BTreeMap;

use hodograph_tests::cost::{Expansion, expanded};

/// The entries with the units of work and the tokens that their expansions may take: a little more than they do.
const CEILINGS: [(&str, u64, usize); 22] = [
    ("scaled_rotation_example_1", 1_200_000, 7_000),
    ("oriented_translation_example_2", 1_300_000, 8_300),
    ("offset_translation_example_3", 700_000, 8_100),
    ("offset_translation_example_3_square", 1_100_000, 7_500),
    ("offset_translation_example_3_negative_square", 1_100_000, 7_500),
    ("oriented_involute_example_4", 1_500_000, 9_100),
    ("evolute_sweep", 1_100_000, 10_000),
    ("generalized_conical_example_5", 2_100_000, 11_000),
    ("generalized_conical_quadratic", 2_500_000, 13_000),
    ("similarity_offset_example_4_7", 2_200_000, 19_000),
    ("similarity_offset_example_4_8", 1_800_000, 15_000),
    ("similarity_offset_example_5_3", 2_700_000, 13_000),
    ("rotation_minimizing_example", 1_300_000, 12_000),
    ("pipe_example", 1_100_000, 8_800),
    ("scaled_rotation_family", 8_500, 6_600),
    ("oriented_translation_family", 180_000, 12_000),
    ("oriented_translation_of_profiles", 160_000, 9_200),
    ("offset_translation_family", 230_000, 13_000),
    ("oriented_involute_family", 570_000, 15_000),
    ("evolute_sweep_family", 960_000, 17_000),
    ("generalized_conical_family", 710_000, 9_500),
    ("generalized_conical_quadratic_family", 340_000, 11_000),
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
