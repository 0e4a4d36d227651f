//! The samples of one sensor before repairs, and what becomes of each.

use crate::samples::{RepairKind, Sensor};

/// The samples of one sensor in file order, before repairs.
#[derive(Debug, Clone)]
pub(crate) struct RawSeries {
    /// Which sensor.
    pub sensor: Sensor,
    /// Which table of an export the samples come from; 0 where there is one.
    pub table: usize,
    /// Row of the table each sample comes from; shared by the sensors of one file.
    pub row: Vec<usize>,
    /// Time stamps, s; may be anything.
    pub t_s: Vec<f64>,
    /// The axis of each channel: 0 is x.
    pub axes: Vec<usize>,
    /// Samples by channel; NaN where a cell is missing beside filled ones.
    pub channels: Vec<Vec<f64>>,
    /// Names of the columns of its axes that hold no sample in any row.
    pub empty: Vec<String>,
    /// The sensor's stated limit, in the channels' unit.
    pub limit: Option<f64>,
}

/// Why each sample is left out; `None` keeps it.
pub(crate) type Fates = Vec<Option<RepairKind>>;

impl RawSeries {
    /// A series without samples, one channel for each axis.
    pub fn of_axes(sensor: Sensor, axes: Vec<usize>) -> Self {
        Self {
            sensor,
            table: 0,
            row: Vec::new(),
            t_s: Vec::new(),
            channels: vec![Vec::new(); axes.len()],
            axes,
            empty: Vec::new(),
            limit: None,
        }
    }

    /// Appends a sample.
    pub fn push(&mut self, row: usize, t_s: f64, values: impl IntoIterator<Item = f64>) {
        self.row.push(row);
        self.t_s.push(t_s);
        for (channel, value) in self.channels.iter_mut().zip(values) {
            channel.push(value);
        }
    }

    /// Whether there are enough samples for a clock: one has none.
    pub fn has_samples(&self) -> bool {
        self.t_s.len() >= 2
    }

    /// Leaves out everything from sample `length` on.
    pub fn truncate(&mut self, length: usize) {
        self.row.truncate(length);
        self.t_s.truncate(length);
        self.channels
            .iter_mut()
            .for_each(|channel| channel.truncate(length));
    }
}
