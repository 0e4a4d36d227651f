//! A sensor that follows with a lag of the first order.

use super::effect::{Sensor, SensorDescribed, SensorEffect};
use crate::numbers::numbers;
use crate::real::Real;
use gyradius_base::error::{Error, Result};

numbers! {
    /// τ ẏ + y = r, that is y(t) = ∫₀^∞ e^{−x} r(t − τ x) dx: eight Gauss–Laguerre nodes over the
    /// motion itself, whatever the rate of the samples. Exact for polynomials of degree 15; for a
    /// motion e^{iωt} with ωτ < 0.3 to 1e-8. What changes within a few τ, as at the release of a
    /// held hull, comes out as a stair.
    pub struct LowPass {
        /// τ of the gyroscope.
        gyro_time_constant_s: "s",
        /// τ of the accelerometer.
        acc_time_constant_s: "s",
    }
}

impl<S> SensorDescribed for LowPass<S> {
    const ID: &'static str = "low_pass";
}

/// Nodes and weights of ∫₀^∞ e^{−x} f(x) dx (Abramowitz and Stegun, table 25.9, n = 8).
#[rustfmt::skip]
const LAGUERRE: [(f64, f64); 8] = [
    (0.170_279_632_305_101, 0.369_188_589_341_637_5), (0.903_701_776_799_38, 0.418_786_780_814_343),
    (2.251_086_629_866_130_7, 0.175_794_986_637_171_8), (4.266_700_170_287_659, 0.033_343_492_261_215_65),
    (7.045_905_402_393_466, 0.002_794_536_235_225_673), (10.758_516_010_180_996, 9.076_508_773_358_213e-5),
    (15.740_678_641_278, 8.485_746_716_272_532e-7), (22.863_131_736_889_265, 1.048_001_174_871_51e-9),
];

impl<S: Real> SensorEffect<S> for LowPass<S> {
    fn check(&self) -> Result<()> {
        let shortest = self
            .gyro_time_constant_s
            .value()
            .min(self.acc_time_constant_s.value());
        if shortest < 0.0 {
            return Err(Error::argument(
                "low_pass",
                "time constants of 0 or above",
                shortest,
            ));
        }
        Ok(())
    }
    fn memory_of(&self, sensor: Sensor) -> Vec<(S, f64)> {
        let tau = match sensor {
            Sensor::Gyroscope => self.gyro_time_constant_s,
            Sensor::Accelerometer => self.acc_time_constant_s,
        };
        LAGUERRE
            .map(|(node, weight)| (tau.scale(node), weight))
            .to_vec()
    }
}
