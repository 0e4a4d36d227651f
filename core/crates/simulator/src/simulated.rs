//! One swing of a rig as arrays: with other numbers, at other times, with or without chance.

use std::fs;
use std::path::Path;

use gyradius_base::error::{Error, Result};
use gyradius_mechanics::Record;

use super::rig::{RigFile, RiggedSwing, read_rig_bytes};

/// A swing with numbers of the caller's.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Variation {
    /// Numbers that are replaced, by name ([`gyradius_mechanics::Experiment::names`]).
    pub values: Vec<(String, f64)>,
    /// Numbers that the readings are differentiated by.
    pub derivatives: Vec<String>,
    /// Times on the phone's clock, s; absent: as the phone samples.
    pub t_s: Option<Vec<f64>>,
    /// Seed of all chance; absent: there is none.
    pub seed: Option<u64>,
}

/// A simulated swing.
#[derive(Debug, Clone)]
pub struct Simulated {
    /// What the phone says, and the motion.
    pub record: Record,
    /// Derivatives of the six readings: by sample, in it by reading, in it by number.
    pub derivatives: Vec<f64>,
}

/// Reads a rig file.
pub fn read_rig_file(path: impl AsRef<Path>) -> Result<RigFile> {
    let file = path.as_ref().display().to_string();
    match fs::read(path) {
        Ok(bytes) => read_rig_bytes(&bytes, &file),
        Err(error) => Err(Error::Unreadable {
            file,
            reason: error.to_string(),
        }),
    }
}

impl RigFile {
    /// The swing of an id. Fails with [`Error::Argument`] that lists the ids.
    pub fn swing(&self, id: &str) -> Result<&RiggedSwing> {
        let ids = || {
            self.swings
                .iter()
                .map(|swing| swing.id.as_str())
                .collect::<Vec<_>>()
                .join(", ")
        };
        let found = self.swings.iter().find(|swing| swing.id == id);
        found.ok_or_else(|| Error::argument("swing", ids(), id))
    }
}

impl RiggedSwing {
    /// Simulates it. Fails with [`Error::Argument`] for a number that it does not have, and as the
    /// simulation does.
    pub fn simulated(&self, varied: &Variation) -> Result<Simulated> {
        let mut numbers = self.experiment.values();
        for (name, value) in &varied.values {
            numbers[self.experiment.index(name)?] = *value;
        }
        let experiment = self.experiment.with_values(&numbers)?;
        let wanted = varied
            .derivatives
            .iter()
            .map(|name| experiment.index(name))
            .collect::<Result<Vec<_>>>()?;
        let t_s = varied
            .t_s
            .clone()
            .unwrap_or_else(|| self.sampling.times_s());
        let draws = self.draws(varied.seed, t_s.len())?;
        let record = experiment.record(&t_s, &draws)?;
        let derivatives = experiment.derivatives(&wanted, &t_s, &draws)?;
        Ok(Simulated {
            record,
            derivatives,
        })
    }
}
