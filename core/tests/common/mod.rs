//! What several test programs share.

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// A fresh generator; the seed is printed so that a failure can be repeated.
pub fn rng() -> ChaCha8Rng {
    let seed: u64 = rand::random();
    println!("seed {seed}");
    ChaCha8Rng::seed_from_u64(seed)
}
