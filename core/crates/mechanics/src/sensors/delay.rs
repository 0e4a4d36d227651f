//! Readings that come late.

use super::effect::{Sensor, SensorDescribed, SensorEffect};
use crate::numbers::numbers;
use crate::real::Real;

numbers! {
    /// What is read at t was felt at t − d.
    pub struct Delay {
        /// d of the gyroscope.
        gyro_s: "s",
        /// d of the accelerometer.
        acc_s: "s",
    }
}

impl<S> SensorDescribed for Delay<S> {
    const ID: &'static str = "delay";
}

impl<S: Real> SensorEffect<S> for Delay<S> {
    fn memory_of(&self, sensor: Sensor) -> Vec<(S, f64)> {
        match sensor {
            Sensor::Gyroscope => vec![(self.gyro_s, 1.0)],
            Sensor::Accelerometer => vec![(self.acc_s, 1.0)],
        }
    }
}
