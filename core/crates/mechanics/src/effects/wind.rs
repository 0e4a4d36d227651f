//! Wind, steady and in gusts.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::effect::{Described, Effect, Loads};
use crate::numbers::numbers;
use crate::real::{Real, V3};
use crate::state::Now;
use crate::suspended::Suspended;

/// Sinusoids of a gust.
const TONES: usize = 24;

numbers! {
    /// What a wind W adds to the drag of still air: F = c (|W − v| (W − v) + |v| v) in the
    /// horizontal plane, v the velocity of the centre of mass, of which the part along the hull is
    /// less; its moment is taken about the centre of pressure.
    ///
    /// W is steady plus a gust, along x and y of the world independently: `24` sinusoids of equal
    /// size whose frequencies halve the spectrum 2σ²τ/(1 + ω²τ²) into equal parts (coloured noise
    /// of correlation time τ: M. Shinozuka and C. M. Jan, J. Sound Vib. 25 (1972) 111). Their
    /// phases follow from the seed by a hash of integers, so that a gust is smooth and can be had
    /// again; the derivative by the seed is zero. Tones of given frequencies make the steady wind
    /// swell and ebb: W = W₀ (1 + Σ aₖ cos 2π fₖ t + bₖ sin 2π fₖ t).
    pub struct Wind {
        /// ½ ρ C_D A, c.
        force_coefficient: "N s^2/m^2",
        /// By what share c is less along the hull than across it: a hull is narrower from ahead
        /// than from abeam.
        less_along: "1",
        /// Steady wind along the world's x.
        steady_x_m_s: "m/s",
        /// Steady wind along the world's y.
        steady_y_m_s: "m/s",
        /// Root mean square of the gusts along each, σ.
        gust_m_s: "m/s",
        /// Their correlation time, τ.
        gust_time_s: "s",
        /// A whole number that chooses the gusts.
        seed: "1",
        /// Frequency of a tone of the wind, and its size as shares of the steady wind.
        tone_1_hz: "Hz",
        /// Of its cosine.
        tone_1_cos: "1",
        /// Of its sine.
        tone_1_sin: "1",
        /// The same of another tone.
        tone_2_hz: "Hz",
        /// Of its cosine.
        tone_2_cos: "1",
        /// Of its sine.
        tone_2_sin: "1",
        /// The same of another tone.
        tone_3_hz: "Hz",
        /// Of its cosine.
        tone_3_cos: "1",
        /// Of its sine.
        tone_3_sin: "1",
        /// The same of another tone.
        tone_4_hz: "Hz",
        /// Of its cosine.
        tone_4_cos: "1",
        /// Of its sine.
        tone_4_sin: "1",
        /// Centre of pressure from the centre of mass, hull axes.
        centre_x_m: "m",
        /// The same.
        centre_y_m: "m",
        /// The same.
        centre_z_m: "m",
    }
}

impl<S> Described for Wind<S> {
    const ID: &'static str = "wind";
    const POSITIVE: &'static [&'static str] = &["gust_time_s"];
    const KINKED: bool = true;
}

/// Sebastiano Vigna's SplitMix64: an integer into one that looks like chance.
fn hash(n: u64) -> u64 {
    let z = n.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// Frequency of a tone times τ: the middle of its part of the spectrum.
fn tone(n: usize) -> f64 {
    (FRAC_PI_2 * (n as f64 + 0.5) / TONES as f64).tan()
}

impl<S: Real> Wind<S> {
    fn gust(&self, t_s: S, direction: u64) -> S {
        let time = t_s / self.gust_time_s;
        let seed = hash(self.seed.value() as u64);
        let one = |n: usize| {
            let chance = hash(seed ^ hash(2 * n as u64 + direction));
            let phase = TAU * (chance >> 11) as f64 / (1u64 << 53) as f64;
            (time.scale(tone(n)) + S::constant(phase)).sin()
        };
        let sum = (0..TONES).map(one).fold(S::zero(), |sum, x| sum + x);
        self.gust_m_s * sum.scale((2.0 / TONES as f64).sqrt())
    }

    fn tones(&self) -> [[S; 3]; 4] {
        [
            [self.tone_1_hz, self.tone_1_cos, self.tone_1_sin],
            [self.tone_2_hz, self.tone_2_cos, self.tone_2_sin],
            [self.tone_3_hz, self.tone_3_cos, self.tone_3_sin],
            [self.tone_4_hz, self.tone_4_cos, self.tone_4_sin],
        ]
    }

    /// The steady wind's size over its mean.
    fn swell(&self, t_s: S) -> S {
        let heard = self.tones().into_iter().filter(|[hz, ..]| !hz.is_zero());
        heard.fold(S::one(), |sum, [hz, cos, sin]| {
            let phase = (hz * t_s).scale(TAU);
            sum + cos * phase.cos() + sin * phase.sin()
        })
    }

    fn has_gusts(&self) -> bool {
        !self.gust_m_s.is_zero()
    }
}

fn squared<S: Real>(v: &V3<S>) -> V3<S> {
    v * v.dot(v).sqrt()
}

impl<S: Real> Effect<S> for Wind<S> {
    fn load(&self, now: &Now<S>, _memory: &[S], _system: &Suspended<S>, loads: &mut Loads<S>) {
        let mut wind =
            V3::new(self.steady_x_m_s, self.steady_y_m_s, S::zero()) * self.swell(now.t_s);
        if self.has_gusts() {
            wind.x += self.gust(now.t_s, 0);
            wind.y += self.gust(now.t_s, 1);
        }
        let own = V3::new(now.velocity.x, now.velocity.y, S::zero());
        let abeam = (squared(&(wind - own)) + squared(&own)) * self.force_coefficient;
        let ahead = V3::new(now.turn[(0, 0)], now.turn[(1, 0)], S::zero());
        let force = abeam - ahead * (abeam.dot(&ahead) / ahead.dot(&ahead) * self.less_along);
        let arm = V3::new(self.centre_x_m, self.centre_y_m, self.centre_z_m);
        loads.force += force;
        loads.torque += arm.cross(&now.turn.tr_mul(&force));
    }

    fn fastest_rad_s(&self, _system: &Suspended<S>) -> f64 {
        let of_gusts = if self.has_gusts() {
            tone(TONES - 1) / self.gust_time_s.value()
        } else {
            0.0
        };
        self.tones()
            .iter()
            .map(|[hz, ..]| TAU * hz.value().abs())
            .fold(of_gusts, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A gust of 1 m/s with τ = 1 s.
    fn gust(seed: f64) -> Wind {
        Wind {
            gust_m_s: 1.0,
            gust_time_s: 1.0,
            seed,
            ..Wind::default()
        }
    }

    #[test]
    fn gusts_have_the_stated_size_and_memory() {
        // Over many seeds the mean of W(0) W(t) is σ² e^(−t/τ): the spectrum's Fourier transform.
        // 4000 products of sums of 24 independent sinusoids scatter by 1.4/√4000 = 0.022.
        for t in [0.0, 0.3, 1.0, 3.0] {
            let product =
                |seed: u32| gust(f64::from(seed)).gust(0.0, 0) * gust(f64::from(seed)).gust(t, 0);
            let mean = (0..4000).map(product).sum::<f64>() / 4000.0;
            assert!((mean - (-t).exp()).abs() < 0.1, "{t} s: {mean}");
        }
    }

    #[test]
    fn the_two_directions_are_independent() {
        let product =
            |seed: u32| gust(f64::from(seed)).gust(0.0, 0) * gust(f64::from(seed)).gust(0.0, 1);
        let mean = (0..4000).map(product).sum::<f64>() / 4000.0;
        assert!(mean.abs() < 0.1, "{mean}");
    }
}
