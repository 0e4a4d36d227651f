//! Sensors that say too much or too little in proportion.

use super::effect::{SensorDescribed, SensorEffect};
use crate::numbers::numbers;
use crate::phone::Reading;
use crate::real::{Real, V3};

numbers! {
    /// r → (1 + s) r by axis, on the gyroscope.
    pub struct GyroScale {
        /// s along x.
        x: "1",
        /// s along y.
        y: "1",
        /// s along z.
        z: "1",
    }
}

impl<S> SensorDescribed for GyroScale<S> {
    const ID: &'static str = "gyro_scale";
}

impl<S: Real> SensorEffect<S> for GyroScale<S> {
    fn distort(&self, _clock_s: S, reading: &mut Reading<S>) {
        reading.gyro += reading.gyro.component_mul(&V3::new(self.x, self.y, self.z));
    }
}

numbers! {
    /// r → (1 + s) r by axis, on the accelerometer.
    pub struct AccScale {
        /// s along x.
        x: "1",
        /// s along y.
        y: "1",
        /// s along z.
        z: "1",
    }
}

impl<S> SensorDescribed for AccScale<S> {
    const ID: &'static str = "acc_scale";
}

impl<S: Real> SensorEffect<S> for AccScale<S> {
    fn distort(&self, _clock_s: S, reading: &mut Reading<S>) {
        reading.force += reading
            .force
            .component_mul(&V3::new(self.x, self.y, self.z));
    }
}
