//! Axes of a sensor that are not square to each other.

use super::effect::{SensorDescribed, SensorEffect};
use crate::numbers::numbers;
use crate::phone::Reading;
use crate::real::{M3, Real};

numbers! {
    /// r → (1 + C) r with zeros on C's diagonal: a share of one axis in another, by misalignment or
    /// cross-talk.
    pub struct CrossAxis {
        /// Of y in x, gyroscope.
        gyro_xy: "1",
        /// Of z in x, gyroscope.
        gyro_xz: "1",
        /// Of x in y, gyroscope.
        gyro_yx: "1",
        /// Of z in y, gyroscope.
        gyro_yz: "1",
        /// Of x in z, gyroscope.
        gyro_zx: "1",
        /// Of y in z, gyroscope.
        gyro_zy: "1",
        /// Of y in x, accelerometer.
        acc_xy: "1",
        /// Of z in x, accelerometer.
        acc_xz: "1",
        /// Of x in y, accelerometer.
        acc_yx: "1",
        /// Of z in y, accelerometer.
        acc_yz: "1",
        /// Of x in z, accelerometer.
        acc_zx: "1",
        /// Of y in z, accelerometer.
        acc_zy: "1",
    }
}

impl<S> SensorDescribed for CrossAxis<S> {
    const ID: &'static str = "cross_axis";
}

impl<S: Real> SensorEffect<S> for CrossAxis<S> {
    fn distort(&self, _clock_s: S, reading: &mut Reading<S>) {
        let none = S::zero();
        let gyro = M3::new(
            none,
            self.gyro_xy,
            self.gyro_xz,
            self.gyro_yx,
            none,
            self.gyro_yz,
            self.gyro_zx,
            self.gyro_zy,
            none,
        );
        let acc = M3::new(
            none,
            self.acc_xy,
            self.acc_xz,
            self.acc_yx,
            none,
            self.acc_yz,
            self.acc_zx,
            self.acc_zy,
            none,
        );
        reading.gyro += gyro * reading.gyro;
        reading.force += acc * reading.force;
    }
}
