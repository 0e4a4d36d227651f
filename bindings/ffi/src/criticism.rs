//! What the simulation gets wrong, with the samples that pictures are drawn from.

use std::sync::Arc;

use gyradius_core::diagnosis::{self, Critique, SwingTrace};
use gyradius_core::procedure::{self, keep_criticism};
use gyradius_core::report::{Curve, thinned};

use crate::as_json;
use crate::data::sentence::Sentence;
use crate::error::Result;

/// A swing's most telling channel against both simulations, thinned for plots.
#[derive(Debug, Clone, PartialEq, uniffi::Record)]
pub struct ComparedSwing {
    /// The swing.
    pub swing: String,
    /// The channel.
    pub channel: Sentence,
    /// Unit of the readings.
    pub unit: String,
    /// Standard deviation of the noise.
    pub noise: f64,
    /// Measured, against s from the start of the analysed part.
    pub measured: Curve,
    /// By the base simulation.
    pub base: Curve,
    /// By the extended one.
    pub extended: Curve,
}

impl From<&SwingTrace> for ComparedSwing {
    fn from(trace: &SwingTrace) -> Self {
        let SwingTrace {
            swing,
            channel,
            unit,
            noise,
            t_s,
            measured,
            base,
            extended,
        } = trace;
        let [measured, base, extended] = [measured, base, extended].map(|y| thinned(t_s, y));
        let (swing, channel, unit) = (swing.clone(), channel.clone(), unit.to_string());
        Self {
            swing,
            channel,
            unit,
            noise: *noise,
            measured,
            base,
            extended,
        }
    }
}

/// A criticism.
#[derive(Debug, uniffi::Object)]
pub struct Criticism {
    inner: diagnosis::Criticism,
}

impl Criticism {
    /// A criticism of the core.
    pub fn new(inner: diagnosis::Criticism) -> Arc<Self> {
        Arc::new(Self { inner })
    }

    /// The core's own.
    pub fn inner(&self) -> &diagnosis::Criticism {
        &self.inner
    }
}

#[uniffi::export]
impl Criticism {
    /// A criticism from its `gyradius-critique/1` text, for a report; it has no traces.
    #[uniffi::constructor]
    pub fn from_json(text: &str) -> Result<Arc<Self>> {
        let critique = diagnosis::Critique::from_json(text)?;
        Ok(Self::new(diagnosis::Criticism {
            critique,
            traces: Vec::new(),
        }))
    }

    /// Keeps it in a folder with what pictures are drawn from, in the place of an earlier one.
    pub fn keep(&self, folder: &str) -> Result<()> {
        Ok(keep_criticism(folder, &self.inner)?)
    }

    /// The result.
    pub fn result(&self) -> Critique {
        self.inner.critique.clone()
    }

    /// The `gyradius-critique/1` text.
    pub fn json(&self) -> Result<String> {
        as_json(&self.inner.critique)
    }

    /// Each swing that was fitted against both simulations.
    pub fn compared(&self) -> Vec<ComparedSwing> {
        self.inner.traces.iter().map(ComparedSwing::from).collect()
    }
}

/// The criticism that a folder keeps, a procedure's or one that [`Criticism::keep`] was told;
/// absent where it keeps none.
#[uniffi::export]
pub fn kept_criticism(folder: &str) -> Result<Option<Arc<Criticism>>> {
    Ok(procedure::kept_criticism(folder)?.map(Criticism::new))
}
