//! The ways that the engine chooses among, and the naive ones, side by side on the same work.
//!
//! Each group is one piece of work. `engine` is what the library does; the other entries are the alternatives: the naive twins
//! that the tests compare it with, and the library's own other ways, which isomorphic operands bring about. The homomorphism
//! `x ↦ xᵏ` of all variables scatters exponents and changes nothing else, so `scattered` is the same work by the ways
//! for scattered exponents: the hash table for products, the heap for quotients. A field with unused generators has
//! no table of its rules.

#[path = "../../tests/naive/brown.rs"]
mod brown;
mod coprimality;
#[path = "../../tests/naive/euclid.rs"]
mod euclid;
mod fractions;
mod gcds;
mod number_fields;
mod operands;
#[path = "../../tests/naive/packed.rs"]
mod packed;
#[path = "../../tests/naive/pairs.rs"]
mod pairs;
mod products;
mod quotients;
mod roots;
#[path = "../../tests/naive/square_root.rs"]
mod square_root;
mod squares;
#[path = "../../tests/naive/sturm.rs"]
mod sturm;
#[expect(dead_code, reason = "the workloads time more sweeps than these benchmarks")]
#[path = "../../examples/workloads/sweeps.rs"]
mod sweeps;

use std::time::Duration;

fn main() {
    let benchmarks = divan::Divan::default().sample_count(20).max_time(Duration::from_secs(1));
    benchmarks.config_with_args().main();
}
