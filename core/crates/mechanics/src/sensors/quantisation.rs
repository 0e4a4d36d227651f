//! Readings in whole steps.

use super::effect::{SensorDescribed, SensorEffect};
use crate::numbers::numbers;
use crate::phone::Reading;
use crate::real::{Real, V3};

numbers! {
    /// r → q round(r / q); q = 0 leaves it out. Derivatives pass as if there were no steps, and
    /// none goes by q: what the steps do to a fit is noise, variance q²/12.
    pub struct Quantisation {
        /// q of the gyroscope.
        gyro_rad_s: "rad/s",
        /// q of the accelerometer.
        acc_m_s2: "m/s^2",
    }
}

impl<S> SensorDescribed for Quantisation<S> {
    const ID: &'static str = "quantisation";
}

fn stepped<S: Real>(r: S, step: f64) -> S {
    if step > 0.0 {
        r.chain(step * (r.value() / step).round(), 1.0)
    } else {
        r
    }
}

impl<S: Real> SensorEffect<S> for Quantisation<S> {
    fn convert(&self, reading: &mut Reading<S>) {
        let step = |v: &V3<S>, q: S| v.map(|r| stepped(r, q.value()));
        reading.gyro = step(&reading.gyro, self.gyro_rad_s);
        reading.force = step(&reading.force, self.acc_m_s2);
    }
}
