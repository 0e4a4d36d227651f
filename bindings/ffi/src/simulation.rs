//! Simulated swings: a rig becomes arrays, or a session that was never swung.

use std::sync::Arc;

use gyradius_core::mechanics::{Moment, Slack};
use gyradius_core::recording::Overwrite;
use gyradius_core::simulator::{self, RigFile, Simulated, Variation};

use crate::block;
use crate::data::{Count, NamedNumber};
use crate::error::Result;
use crate::work::aside;

/// What a rig file says: a session as it is stated, and what is true of it.
#[derive(Debug, uniffi::Object)]
pub struct Rig {
    inner: RigFile,
}

impl Rig {
    /// The file's content.
    pub fn file(&self) -> &RigFile {
        &self.inner
    }
}

/// A number of a simulation.
#[derive(Debug, Clone, PartialEq, uniffi::Record)]
pub struct RigNumber {
    /// Its name; effects read `effect.number`, the phone `phone.position_x_m`.
    pub name: String,
    /// Its value.
    pub value: f64,
    /// Its unit.
    pub unit: String,
}

#[uniffi::export]
impl Rig {
    /// Reads a rig file.
    #[uniffi::constructor]
    pub fn read(path: &str) -> Result<Arc<Self>> {
        Ok(Arc::new(Self {
            inner: simulator::read_rig_file(path)?,
        }))
    }

    /// Reads the text of a rig file; `name` is what messages call it.
    #[uniffi::constructor]
    pub fn parse(text: &str, name: &str) -> Result<Arc<Self>> {
        Ok(Arc::new(Self {
            inner: simulator::read_rig(text, name)?,
        }))
    }

    /// The same under another title, which its sessions bear.
    pub fn titled(&self, title: String) -> Arc<Self> {
        let mut inner = self.inner.clone();
        inner.session.title = title;
        Arc::new(Self { inner })
    }

    /// Ids of the swings, in the order of the file.
    pub fn swing_ids(&self) -> Vec<String> {
        self.inner
            .swings
            .iter()
            .map(|swing| swing.id.clone())
            .collect()
    }

    /// Every number of a swing.
    pub fn numbers(&self, swing: &str) -> Result<Vec<RigNumber>> {
        let experiment = &self.inner.swing(swing)?.experiment;
        let named = experiment.names().into_iter().zip(experiment.values());
        Ok(named
            .map(|((name, unit), value)| RigNumber {
                name,
                value,
                unit: unit.into(),
            })
            .collect())
    }

    /// Simulates all swings and writes the session into a folder, and what is true into a file
    /// outside of it. The same seed gives the same files.
    pub fn write(
        &self,
        folder: &str,
        truth_file: &str,
        seed: u64,
        overwrite: Overwrite,
    ) -> Result<()> {
        aside(|| {
            simulator::save_practised(
                &simulator::practise(&self.inner, seed)?,
                folder,
                truth_file,
                overwrite,
            )
        })
    }

    /// Simulates a swing as its phone samples it. `values` replace numbers, `derivatives` names
    /// those to differentiate by; without a seed there is no chance in it.
    pub fn simulate(
        &self,
        swing: &str,
        values: Vec<NamedNumber>,
        derivatives: Vec<String>,
        seed: Option<u64>,
    ) -> Result<Arc<Simulation>> {
        self.simulated(swing, values, derivatives, None, seed)
    }

    /// The same at the times of a block of floats, s on the phone's clock.
    pub fn simulate_at(
        &self,
        swing: &str,
        t_s: &[u8],
        values: Vec<NamedNumber>,
        derivatives: Vec<String>,
        seed: Option<u64>,
    ) -> Result<Arc<Simulation>> {
        self.simulated(
            swing,
            values,
            derivatives,
            Some(block::floats("t_s", t_s)?),
            seed,
        )
    }
}

impl Rig {
    fn simulated(
        &self,
        swing: &str,
        values: Vec<NamedNumber>,
        derivatives: Vec<String>,
        t_s: Option<Vec<f64>>,
        seed: Option<u64>,
    ) -> Result<Arc<Simulation>> {
        let values = values
            .into_iter()
            .map(|one| (one.name, one.value))
            .collect();
        let varied = Variation {
            values,
            derivatives,
            t_s,
            seed,
        };
        let inner = aside(|| self.inner.swing(swing)?.simulated(&varied))?;
        Ok(Arc::new(Simulation { inner }))
    }
}

/// When a line first went slack.
#[derive(Debug, Clone, Copy, PartialEq, uniffi::Record)]
pub struct SlackLine {
    /// When, s.
    pub t_s: f64,
    /// Which line, from 0.
    pub line: Count,
}

impl From<Slack> for SlackLine {
    fn from(slack: Slack) -> Self {
        Self {
            t_s: slack.t_s,
            line: slack.line,
        }
    }
}

/// A simulated swing; each array is a block of floats, row by row.
#[derive(Debug, uniffi::Object)]
pub struct Simulation {
    inner: Simulated,
}

#[uniffi::export]
impl Simulation {
    /// Time stamps, s.
    pub fn t_s(&self) -> Vec<u8> {
        block::of_floats(&self.inner.record.t_s)
    }

    /// Angular rate (rad/s) x, y, z and specific force (m/s²) x, y, z, phone axes: a row for each
    /// stamp.
    pub fn readings(&self) -> Vec<u8> {
        let rows: Vec<[f64; 6]> = self
            .inner
            .record
            .readings
            .iter()
            .map(|reading| reading.six())
            .collect();
        block::of_floats(rows.as_flattened())
    }

    /// Derivatives of the readings: by stamp, in it by reading, in it by number.
    pub fn derivatives(&self) -> Vec<u8> {
        block::of_floats(&self.inner.derivatives)
    }

    /// Centre of mass, world axes, m: x, y, z for each stamp.
    pub fn position_m(&self) -> Vec<u8> {
        self.rows(|moment| moment.position.into())
    }

    /// Quaternion w, x, y, z, world from hull, for each stamp.
    pub fn attitude(&self) -> Vec<u8> {
        self.rows(|moment| moment.attitude)
    }

    /// Velocity of the centre of mass, world axes, m/s: x, y, z for each stamp.
    pub fn velocity_m_s(&self) -> Vec<u8> {
        self.rows(|moment| moment.velocity.into())
    }

    /// Angular rate, hull axes, rad/s: x, y, z for each stamp.
    pub fn rate_rad_s(&self) -> Vec<u8> {
        self.rows(|moment| moment.rate.into())
    }

    /// When a line first went slack; what follows on lines of given length is not to be used.
    pub fn slack(&self) -> Option<SlackLine> {
        self.inner.record.path.slack.map(SlackLine::from)
    }
}

impl Simulation {
    fn rows<const N: usize>(&self, row: impl Fn(&Moment<f64>) -> [f64; N]) -> Vec<u8> {
        let rows: Vec<[f64; N]> = self.inner.record.moments.iter().map(row).collect();
        block::of_floats(rows.as_flattened())
    }
}
