//! The live estimator: samples in, what is known at any moment out.

use std::sync::{Arc, Mutex};

use gyradius_core::message::Message;
use gyradius_core::online::{Advice, Estimate, Live, LiveOptions};
use gyradius_core::recording::Sensor;

use crate::error::Result;
use crate::{as_json, block, locked};

/// Period, amplitude, decay, unwanted motion and advice, from samples as they come.
#[derive(Debug, uniffi::Object)]
pub struct LiveEstimator {
    inner: Mutex<Live>,
}

#[uniffi::export]
impl LiveEstimator {
    /// An estimator that has seen nothing. `wanted`: relative standard uncertainty of the period
    /// that is enough (1e-4 is usual); full scales in rad/s and m/s², where the phone tells.
    #[uniffi::constructor]
    pub fn new(
        wanted: f64,
        gyroscope_full_scale_rad_s: Option<f64>,
        accelerometer_full_scale_m_s2: Option<f64>,
    ) -> Result<Arc<Self>> {
        let options = LiveOptions {
            wanted,
            gyroscope_full_scale_rad_s,
            accelerometer_full_scale_m_s2,
        };
        Ok(Arc::new(Self {
            inner: Mutex::new(Live::new(options)?),
        }))
    }

    /// Takes a block of stamps (ns) and one of values (x, y, z; rad/s or m/s² of specific force) of
    /// the gyroscope or the accelerometer. Now and then this looks at the swing anew: tens of
    /// milliseconds.
    pub fn push(&self, sensor: Sensor, stamps_ns: &[u8], values: &[u8]) -> Result<()> {
        let (stamps_ns, values) = (block::stamps(stamps_ns)?, block::triples("values", values)?);
        Ok(locked(&self.inner).push(sensor, &stamps_ns, &values)?)
    }

    /// What is known now.
    pub fn estimate(&self) -> Estimate {
        locked(&self.inner).estimate()
    }

    /// What is known now, as JSON.
    pub fn estimate_json(&self) -> Result<String> {
        as_json(&self.estimate())
    }
}

/// The sentence of a piece of advice, with its key and what it names.
#[uniffi::export]
pub fn live_sentence(advice: &Advice) -> Message {
    advice.message()
}
