//! Noise that wanders: flicker, 1/f.

use super::effect::{SensorDescribed, SensorEffect};
use crate::numbers::numbers;
use crate::phone::Reading;
use crate::real::Real;

numbers! {
    /// One-sided spectral density S(f) = B²/f within 10 % from 1 mHz to 1 Hz (IEEE Std 952, bias
    /// instability B), as the sum of first-order Gauss–Markov processes whose time constants τ
    /// stand in a constant ratio ρ: each has the variance B² ln ρ, because the integral of 4 τ / (1
    /// + (2π f τ)²) over ln τ is 1/f. Each begins in its steady state.
    pub struct ColouredNoise {
        /// B of the gyroscope.
        gyro_rad_s: "rad/s",
        /// B of the accelerometer.
        acc_m_s2: "m/s^2",
    }
}

impl<S> SensorDescribed for ColouredNoise<S> {
    const ID: &'static str = "coloured_noise";
}

/// Time constants τ: from [`SHORTEST_S`] on, each [`RATIO`] times the one before.
const PROCESSES: usize = 11;
const SHORTEST_S: f64 = 0.01;
const RATIO: f64 = 3.162_277_660_168_379_5;

impl<S: Real> SensorEffect<S> for ColouredNoise<S> {
    fn draws(&self) -> usize {
        6 * PROCESSES
    }
    fn noise_states(&self) -> usize {
        6 * PROCESSES
    }
    fn add_noise(
        &self,
        since_s: Option<f64>,
        draws: &[f64],
        states: &mut [S],
        reading: &mut Reading<S>,
    ) {
        let size = RATIO.ln().sqrt();
        for (k, (state, draw)) in states.iter_mut().zip(draws).enumerate() {
            let (channel, process) = (k / PROCESSES, k % PROCESSES);
            let tau_s = SHORTEST_S * RATIO.powi(process as i32);
            let kept = since_s.map_or(0.0, |since_s| (-since_s / tau_s).exp());
            let sigma = if channel < 3 {
                self.gyro_rad_s
            } else {
                self.acc_m_s2
            }
            .scale(size);
            *state = state.scale(kept) + sigma.scale((1.0 - kept * kept).sqrt() * draw);
            if channel < 3 {
                reading.gyro[channel] += *state;
            } else {
                reading.force[channel - 3] += *state;
            }
        }
    }
}
