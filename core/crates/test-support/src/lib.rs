//! What several test programs share.
#![allow(dead_code)] // None of them uses all of it.

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// A fresh seed, printed so that a failure can be repeated: `GYRADIUS_SEED=<seed> cargo test <name
/// of the test>`.
pub fn seed(what: &str) -> u64 {
    let seed = std::env::var("GYRADIUS_SEED")
        .map_or_else(|_| rand::random(), |text| text.parse().unwrap());
    println!("{what}: seed {seed}");
    seed
}

/// A generator from such a seed.
pub fn fresh(what: &str) -> ChaCha8Rng {
    ChaCha8Rng::seed_from_u64(seed(what))
}

/// One of a test that needs no name.
pub fn rng() -> ChaCha8Rng {
    fresh("drawn")
}
