//! What the tests of several crates share: seeds.
//!
//! Tests draw the same every time. `GYRADIUS_SEED=random` draws afresh, `GYRADIUS_SEED=<number>`
//! repeats a draw.

use proptest::test_runner::{Config, RngSeed};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// The seed of a test, printed so that a draw can be repeated: fixed by its name, or as
/// `GYRADIUS_SEED` says.
pub fn seed(what: &str) -> u64 {
    let seed = match std::env::var("GYRADIUS_SEED") {
        Err(_) => fixed(what),
        Ok(word) if word == "random" => rand::random(),
        Ok(number) => number.parse().unwrap_or_else(|_| fixed(&number)),
    };
    println!("{what}: seed {seed}");
    seed
}

/// The same number for the same name, in every run, on every machine and with every compiler: FNV-1a
/// of its bytes, 64 bits.
fn fixed(name: &str) -> u64 {
    name.bytes().fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

/// A generator from such a seed.
pub fn fresh(what: &str) -> ChaCha8Rng {
    ChaCha8Rng::seed_from_u64(seed(what))
}

/// One of a test that needs no name.
pub fn rng() -> ChaCha8Rng {
    fresh("drawn")
}

/// A configuration of proptest from such a seed, with that many cases; failures are told, not kept.
pub fn cases(count: u32) -> Config {
    Config {
        cases: count,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(seed("proptest")),
        ..Config::default()
    }
}
