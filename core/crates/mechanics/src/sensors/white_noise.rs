//! Noise that is new with every sample.

use super::effect::{SensorDescribed, SensorEffect};
use crate::numbers::numbers;
use crate::phone::Reading;
use crate::real::{Real, V3};

numbers! {
    /// r → r + σ z with standard normal z, anew for every sample and axis.
    pub struct WhiteNoise {
        /// σ of the gyroscope.
        gyro_rad_s: "rad/s",
        /// σ of the accelerometer.
        acc_m_s2: "m/s^2",
    }
}

impl<S> SensorDescribed for WhiteNoise<S> {
    const ID: &'static str = "white_noise";
}

impl<S: Real> SensorEffect<S> for WhiteNoise<S> {
    fn draws(&self) -> usize {
        6
    }
    fn add_noise(
        &self,
        _since_s: Option<f64>,
        draws: &[f64],
        _states: &mut [S],
        reading: &mut Reading<S>,
    ) {
        reading.gyro += V3::from_fn(|i, _| self.gyro_rad_s.scale(draws[i]));
        reading.force += V3::from_fn(|i, _| self.acc_m_s2.scale(draws[3 + i]));
    }
}
