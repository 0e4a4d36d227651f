//! The damped oscillations of any record.

use std::sync::Arc;

use gyradius_core::signal::{self, ChannelGroup, DecomposeOptions};

use crate::error::{Result, bad_argument};
use crate::work::aside;
use crate::{as_json, block};

/// The damped oscillations found in a record, shared by all channels.
#[derive(Debug, uniffi::Object)]
pub struct Decomposition {
    inner: signal::Decomposition,
}

/// One damped oscillation.
#[derive(Debug, Clone, Copy, PartialEq, uniffi::Record)]
pub struct Oscillation {
    /// Period at the record's mean amplitude, s.
    pub period_s: f64,
    /// Its standard error, s.
    pub period_se_s: f64,
    /// Decay rate, 1/s.
    pub alpha_per_s: f64,
    /// Its standard error, 1/s.
    pub alpha_se_per_s: f64,
    /// Energy over the noise variance, summed over channels, dB.
    pub snr_db: f64,
}

impl From<&signal::FittedMode> for Oscillation {
    fn from(mode: &signal::FittedMode) -> Self {
        let (period_s, period_se_s) = (mode.period_s(), mode.period_se_s());
        let signal::FittedMode {
            alpha_per_s,
            alpha_se_per_s,
            snr_db,
            ..
        } = *mode;
        Self {
            period_s,
            period_se_s,
            alpha_per_s,
            alpha_se_per_s,
            snr_db,
        }
    }
}

#[uniffi::export]
impl Decomposition {
    /// Finds the damped oscillations of channels that share one clock: `t_s` is a block of times,
    /// s, `channels` one channel after the other, each as long as `t_s`.
    #[uniffi::constructor]
    pub fn of(t_s: &[u8], channels: &[u8]) -> Result<Arc<Self>> {
        let (t_s, flat) = (
            block::floats("t_s", t_s)?,
            block::floats("channels", channels)?,
        );
        if t_s.is_empty() || flat.len() % t_s.len() != 0 {
            return Err(bad_argument(
                "channels",
                "channels as long as the times",
                flat.len(),
            ));
        }
        let channels = flat.chunks(t_s.len()).map(<[f64]>::to_vec).collect();
        let groups = [ChannelGroup { t_s, channels }];
        let inner = aside(|| signal::decompose(&groups, &DecomposeOptions::default()))?;
        Ok(Arc::new(Self { inner }))
    }

    /// The oscillations, strongest first.
    pub fn oscillations(&self) -> Vec<Oscillation> {
        self.inner.modes.iter().map(Oscillation::from).collect()
    }

    /// Everything that was found, as JSON.
    pub fn json(&self) -> Result<String> {
        as_json(&self.inner)
    }

    /// The fitted oscillations at a block of times, s, without the baseline: one channel after the
    /// other.
    pub fn evaluate(&self, t_s: &[u8]) -> Result<Vec<u8>> {
        let fit = signal::model(&block::floats("t_s", t_s)?, &self.inner);
        Ok(fit
            .iter()
            .flat_map(|channel| block::of_floats(channel))
            .collect())
    }
}
