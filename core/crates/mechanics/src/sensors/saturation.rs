//! A sensor at the end of its range.

use super::effect::{SensorDescribed, SensorEffect};
use crate::numbers::numbers;
use crate::phone::Reading;
use crate::real::{Real, V3};

numbers! {
    /// r → min(max(r, −R), R); R = 0 leaves it out. A reading at the limit follows the limit: its
    /// derivative by R is ±1, by everything else 0.
    pub struct Saturation {
        /// R of the gyroscope.
        gyro_rad_s: "rad/s",
        /// R of the accelerometer.
        acc_m_s2: "m/s^2",
    }
}

impl<S> SensorDescribed for Saturation<S> {
    const ID: &'static str = "saturation";
}

fn clipped<S: Real>(r: S, limit: S) -> S {
    if limit.value() <= 0.0 || r.value().abs() <= limit.value() {
        r
    } else {
        limit.scale(r.value().signum())
    }
}

impl<S: Real> SensorEffect<S> for Saturation<S> {
    fn convert(&self, reading: &mut Reading<S>) {
        let clip = |v: &V3<S>, limit: S| v.map(|r| clipped(r, limit));
        reading.gyro = clip(&reading.gyro, self.gyro_rad_s);
        reading.force = clip(&reading.force, self.acc_m_s2);
    }
}
