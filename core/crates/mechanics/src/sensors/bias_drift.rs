//! A bias that does not stay.

use super::effect::{SensorDescribed, SensorEffect};
use crate::numbers::numbers;
use crate::phone::Reading;
use crate::real::{Real, V3};

numbers! {
    /// b(t) = r t + w (1 − e^{−t/τ}), on top of the phone's constant bias: a steady drift, and a
    /// sensor that warms up (first order, as a body heated at a steady power: Newton's law of
    /// cooling). τ = 0 leaves the warming out.
    pub struct BiasDrift {
        /// r of the gyroscope.
        gyro_rate_x_rad_s2: "rad/s^2",
        /// r of the gyroscope.
        gyro_rate_y_rad_s2: "rad/s^2",
        /// r of the gyroscope.
        gyro_rate_z_rad_s2: "rad/s^2",
        /// r of the accelerometer.
        acc_rate_x_m_s3: "m/s^3",
        /// r of the accelerometer.
        acc_rate_y_m_s3: "m/s^3",
        /// r of the accelerometer.
        acc_rate_z_m_s3: "m/s^3",
        /// w of the gyroscope.
        gyro_warm_x_rad_s: "rad/s",
        /// w of the gyroscope.
        gyro_warm_y_rad_s: "rad/s",
        /// w of the gyroscope.
        gyro_warm_z_rad_s: "rad/s",
        /// w of the accelerometer.
        acc_warm_x_m_s2: "m/s^2",
        /// w of the accelerometer.
        acc_warm_y_m_s2: "m/s^2",
        /// w of the accelerometer.
        acc_warm_z_m_s2: "m/s^2",
        /// τ.
        warm_up_s: "s",
    }
}

impl<S> SensorDescribed for BiasDrift<S> {
    const ID: &'static str = "bias_drift";
}

impl<S: Real> SensorEffect<S> for BiasDrift<S> {
    fn distort(&self, clock_s: S, reading: &mut Reading<S>) {
        let warm = if self.warm_up_s.value() > 0.0 {
            S::one() - (-clock_s / self.warm_up_s).exp()
        } else {
            S::zero()
        };
        reading.gyro += V3::new(
            self.gyro_rate_x_rad_s2,
            self.gyro_rate_y_rad_s2,
            self.gyro_rate_z_rad_s2,
        ) * clock_s
            + V3::new(
                self.gyro_warm_x_rad_s,
                self.gyro_warm_y_rad_s,
                self.gyro_warm_z_rad_s,
            ) * warm;
        reading.force += V3::new(
            self.acc_rate_x_m_s3,
            self.acc_rate_y_m_s3,
            self.acc_rate_z_m_s3,
        ) * clock_s
            + V3::new(
                self.acc_warm_x_m_s2,
                self.acc_warm_y_m_s2,
                self.acc_warm_z_m_s2,
            ) * warm;
    }
}
