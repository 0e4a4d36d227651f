//! Chance from a seed: the same seed gives the same numbers for each effect, whatever else is
//! simulated.

use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

use gyradius_base::error::Result;
use gyradius_mechanics::Draws;

use super::rig::RiggedSwing;

/// Streams of a seed for the effects of one swing.
const STREAMS_PER_SWING: u64 = 1 << 20;

impl RiggedSwing {
    /// Standard normal numbers for so many samples; none without a seed.
    pub fn draws(&self, seed: Option<u64>, samples: usize) -> Result<Draws> {
        let Some(seed) = seed else {
            return Ok(Draws::new());
        };
        let counts = self.experiment.draws_per_sample()?;
        let of_effect = |(effect, count): (usize, usize)| {
            let mut generator = ChaCha8Rng::seed_from_u64(seed);
            generator.set_stream(self.place as u64 * STREAMS_PER_SWING + effect as u64);
            (0..samples * count)
                .map(|_| StandardNormal.sample(&mut generator))
                .collect()
        };
        Ok(counts.into_iter().enumerate().map(of_effect).collect())
    }
}
