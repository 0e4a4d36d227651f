//! Pauses of an experiment: its time stands still, the system's goes on.

use crate::import::table::Table;
use crate::samples::{Repair, RepairKind, Sensor};
use gyradius_base::Result;

/// The pauses of an experiment: experiment time of each, and how long it lasted, s.
#[derive(Debug, Clone, Default)]
pub struct Pauses {
    pauses: Vec<(f64, f64)>,
}

impl Pauses {
    /// The pauses, if a file is phyphox's `meta/time.csv`.
    pub fn of_file(bytes: &[u8], name: &str) -> Result<Option<Self>> {
        let is_it = Table::open(bytes, name).is_ok_and(|table| {
            ["event", "experiment time", "system time"]
                .iter()
                .all(|wanted| {
                    table
                        .find(|column| column.to_lowercase() == *wanted)
                        .is_some()
                })
        });
        is_it.then(|| Self::read(bytes, name)).transpose()
    }

    /// Reads `meta/time.csv`: START and PAUSE rows with experiment and system time.
    pub fn read(bytes: &[u8], name: &str) -> Result<Self> {
        let table = Table::open(bytes, name)?;
        let column = |wanted: &str| {
            table
                .find(|column| column.to_lowercase() == wanted)
                .ok_or_else(|| {
                    table.malformed(
                        Some(0),
                        &format!("a column `{wanted}`"),
                        &format!("`{}`", table.header_text()),
                    )
                })
        };
        let numbers = table.numbers(&[column("experiment time")?, column("system time")?])?;
        let events = table.texts_of(column("event")?)?;
        let mut paused: Option<f64> = None;
        let mut pauses = Vec::new();
        for (row, event) in events.iter().enumerate() {
            let cell = |column: usize| numbers.cells[column].get(row).copied().flatten();
            let (Some(experiment_s), Some(system_s)) = (cell(0), cell(1)) else {
                continue;
            };
            match event.to_uppercase().as_str() {
                "PAUSE" => paused = Some(system_s),
                "START" => {
                    let length = paused.take().map_or(0.0, |since| system_s - since);
                    if length.is_finite() && length > 0.0 {
                        pauses.push((experiment_s, length));
                    }
                }
                _ => {}
            }
        }
        Ok(Self { pauses })
    }

    /// Experiment time with the pauses before it put back. A sample at the very stamp of a pause
    /// came before it.
    pub fn wall_s(&self, experiment_s: f64) -> f64 {
        let before = self.pauses.iter().filter(|pause| pause.0 < experiment_s);
        experiment_s + before.map(|pause| pause.1).sum::<f64>()
    }

    /// The pauses as a repair, without naming a sensor; `None` where there are none.
    pub fn repair(&self) -> Option<Repair> {
        let (first, last) = (self.pauses.first()?, self.pauses.last()?);
        let total: f64 = self.pauses.iter().map(|pause| pause.1).sum();
        let count = self.pauses.len();
        let times = if count == 1 {
            "once".to_owned()
        } else {
            format!("{count} times")
        };
        Some(Repair {
            kind: RepairKind::Pause,
            sensor: Sensor::Gyroscope,
            count,
            first_s: self.wall_s(first.0),
            last_s: self.wall_s(last.0),
            text: format!("paused {times}, {total:.3} s in all; put back from the system clock"),
        })
    }
}
