//! A swing with the phone that records it: what is simulated, as one list of named numbers.

use super::numbers::{Number, Numbers};
use super::path::{Fineness, Moment, Path};
use super::phone::{Phone, Reading};
use super::real::{Dual, Real};
use super::scene::{LANES, Scene, seeded};
use crate::error::{Error, Result};
use crate::frames::Rotation;

/// A scene and the phone on its hull.
#[derive(Debug, Clone, PartialEq)]
pub struct Experiment {
    /// Body, rig, start and effects.
    pub scene: Scene,
    /// Nominal `hull_from_phone`, on top of which the phone's turn comes.
    pub hull_from_phone: Rotation,
    /// The phone.
    pub phone: Phone,
    /// So long the hull is held at its start before it is let go, s.
    pub held_s: f64,
}

/// The motion and what the phone says of it.
#[derive(Debug, Clone)]
pub struct Record<S: Real> {
    /// The motion from the release on.
    pub path: Path<S>,
    /// Where the hull was at each time.
    pub moments: Vec<Moment<S>>,
    /// What the phone said.
    pub readings: Vec<Reading<S>>,
}

impl Experiment {
    /// Names and units of all its numbers: those of the scene, then those of the phone as `phone.position_x_m`.
    pub fn names(&self) -> Vec<(String, &'static str)> {
        let of_phone = <Phone as Numbers<f64>>::NUMBERS.iter();
        let mut names = self.scene.names();
        names.extend(of_phone.map(|n: &Number| (format!("phone.{}", n.name), n.unit)));
        names
    }

    /// All its numbers, in the order of [`Experiment::names`].
    pub fn values(&self) -> Vec<f64> {
        [self.scene.values(), self.phone.to_numbers()].concat()
    }

    /// The experiment with other numbers, in the order of [`Experiment::names`].
    pub fn with_values(&self, values: &[f64]) -> Result<Self> {
        let (of_scene, rest) = values.split_at(self.scene.values().len().min(values.len()));
        Ok(Self {
            scene: self.scene.with_values(of_scene)?,
            phone: Phone::from_numbers(&mut rest.iter().copied()).ok_or_else(|| too_few(values.len()))?,
            ..self.clone()
        })
    }

    /// Place of a number in [`Experiment::names`].
    pub fn index(&self, name: &str) -> Result<usize> {
        let found = self.names().iter().position(|(n, _)| n == name);
        found.ok_or_else(|| Error::argument("number", "a number of the simulation", name))
    }

    /// The record at these times, s.
    pub fn record(&self, t_s: &[f64]) -> Result<Record<f64>> {
        self.run(self.values(), Fineness::FULL, t_s)
    }

    /// Derivatives of gyroscope x, y, z and specific force x, y, z by the numbers at `wanted`: one row per time, in it
    /// the six readings, in each the derivatives.
    pub fn derivatives(&self, wanted: &[usize], t_s: &[f64]) -> Result<Vec<[Vec<f64>; 6]>> {
        let mut rows = vec![[(); 6].map(|()| Vec::with_capacity(wanted.len())); t_s.len()];
        for lanes in wanted.chunks(LANES) {
            let values: Vec<Dual<LANES>> = seeded(&self.values(), lanes)?;
            let record = self.run(values, Fineness::OF_DERIVATIVES, t_s)?;
            for (row, reading) in rows.iter_mut().zip(&record.readings) {
                for (found, cell) in reading.six().iter().zip(row) {
                    cell.extend_from_slice(&found.slope[..lanes.len()]);
                }
            }
        }
        Ok(rows)
    }

    fn run<S: Real>(&self, mut values: Vec<S>, fineness: Fineness, t_s: &[f64]) -> Result<Record<S>> {
        let of_phone = values.split_off(self.scene.values().len());
        let step_s = self.scene.step_s(fineness.steps_per_period)?;
        let last_s = t_s.iter().fold(0.0, |last: f64, t| last.max(t - self.held_s));
        let path = self.scene.run(values, last_s.max(step_s), step_s, fineness)?;
        let count = of_phone.len();
        let phone = Phone::from_numbers(&mut of_phone.into_iter()).ok_or_else(|| too_few(count))?;
        let mounted = phone.mounted(&self.hull_from_phone, &path.cm_m, path.gravity_m_s2);
        let moments: Vec<Moment<S>> = t_s.iter().map(|t| held(&path, t - self.held_s)).collect();
        let readings = moments.iter().map(|moment| mounted.read(moment)).collect();
        Ok(Record { path, moments, readings })
    }
}

fn too_few(count: usize) -> Error {
    Error::argument("values", "as many as the simulation has numbers", count)
}

/// The hull at a time from the release on; before it the hull is held where it starts.
fn held<S: Real>(path: &Path<S>, t_s: f64) -> Moment<S> {
    if t_s >= 0.0 { path.at(t_s) } else { path.at(0.0).stopped() }
}
