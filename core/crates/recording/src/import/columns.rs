//! One sensor's columns of a table, read and brought to the core's units.

use std::collections::{BTreeSet, HashMap};

use super::clock::{seconds_of_text, unwrapped};
use super::source::base;
use super::table::{Columns, Table, Tag, clipped};
use crate::csv::collect;
use crate::repair::RawSeries;
use crate::samples::{Recording, Repair, Sensor};
use gyradius_base::Result;

/// Stamps above this are Unix time: no recording lasts three years.
const UNIX_TIME_S: f64 = 1e8;
/// Names of columns that a note lists before it counts the others.
const LISTED: usize = 12;

/// Where the time of a row comes from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Clock {
    /// A column of numbers, and the factor to s.
    Number { column: usize, factor: f64 },
    /// A column with a clock, or a date and a clock.
    Text { column: usize },
    /// The rows themselves, at a rate in Hz.
    Rows { rate_hz: f64 },
}

impl Clock {
    /// A column in s, or in text where its first filled cell is one.
    pub fn of_column(table: &Table, column: usize) -> Result<Self> {
        let texts = table.texts_of(column)?;
        let first = texts.iter().find(|text| !text.is_empty());
        let is_text = first.is_some_and(|text| seconds_of_text(text).is_some());
        Ok(if is_text {
            Clock::Text { column }
        } else {
            Clock::Number {
                column,
                factor: 1.0,
            }
        })
    }

    fn column(self) -> Option<usize> {
        match self {
            Clock::Number { column, .. } | Clock::Text { column } => Some(column),
            Clock::Rows { .. } => None,
        }
    }
}

/// Where a sensor's samples stand, and the factors to the core's unit.
#[derive(Debug, Clone)]
pub(super) struct SensorColumns {
    pub sensor: Sensor,
    pub clock: Clock,
    pub axes: Vec<usize>,
    /// Which axis each of them is: 0 is x.
    pub directions: Vec<usize>,
    pub factors: Vec<f64>,
    /// The rows that are this sensor's, where they are tagged.
    pub tag: Option<Tag>,
}

impl SensorColumns {
    /// Columns in s and in one unit on all axes.
    pub fn new(sensor: Sensor, time: usize, axes: [usize; 3], factor: f64) -> Self {
        let clock = Clock::Number {
            column: time,
            factor: 1.0,
        };
        Self {
            sensor,
            clock,
            axes: axes.to_vec(),
            directions: vec![0, 1, 2],
            factors: vec![factor; 3],
            tag: None,
        }
    }

    /// The columns that it takes.
    pub fn used(&self) -> impl Iterator<Item = usize> {
        let tag = self.tag.as_ref().map(|tag| tag.column);
        let axes = self.axes.iter().copied();
        axes.chain(self.clock.column()).chain(tag)
    }

    /// Reads the samples; `NaN` in every axis at the end of a column is padding to a longer one
    /// beside it.
    pub fn read(&self, table: &Table) -> Result<RawSeries> {
        let mut numbers = self.numbers(table)?;
        // An axis that is NaN throughout was not recorded.
        for cells in numbers.cells.iter_mut().skip(1) {
            if cells.iter().flatten().all(|value| value.is_nan()) {
                cells.fill(None);
            }
        }
        let places: Vec<(usize, usize)> = self.directions.iter().copied().zip(1..).collect();
        let mut raw = collect(table, &numbers, self.sensor, &places)?;
        let empty = |row: usize| raw.channels.iter().all(|channel| channel[row].is_nan());
        let length = (0..raw.t_s.len())
            .rev()
            .find(|&row| !empty(row))
            .map_or(0, |last| last + 1);
        raw.truncate(length);
        for (channel, axis) in raw.channels.iter_mut().zip(&raw.axes) {
            let place = self.directions.iter().position(|one| one == axis);
            let factor = place.and_then(|place| self.factors.get(place));
            channel
                .iter_mut()
                .for_each(|value| *value *= factor.copied().unwrap_or(1.0));
        }
        Ok(raw)
    }

    /// Time in s and the axes as they stand.
    fn numbers(&self, table: &Table) -> Result<Columns> {
        let tag = self.tag.as_ref();
        if let Clock::Number { column, factor } = self.clock {
            let columns: Vec<usize> = std::iter::once(column)
                .chain(self.axes.iter().copied())
                .collect();
            let mut numbers = table.numbers_of(&columns, tag)?;
            if let Some(times) = numbers.cells.first_mut() {
                times.iter_mut().flatten().for_each(|t| *t *= factor);
            }
            return Ok(numbers);
        }
        let mut numbers = table.numbers_of(&self.axes, tag)?;
        let times = match self.clock {
            Clock::Rows { rate_hz } => {
                let blank = table.blank_rows(&numbers.offset);
                let rows = numbers.row.iter().zip(blank);
                rows.map(|(row, blank)| Some((row + blank) as f64 / rate_hz))
                    .collect()
            }
            Clock::Number { column, .. } | Clock::Text { column } => {
                let texts = table.tagged_texts(column, tag)?;
                let times = unwrapped(&texts);
                let wrong = |at: usize| times[at].is_none() && !texts[at].is_empty();
                if !times.is_empty() && (0..times.len()).all(wrong) {
                    return Err(table.malformed(
                        numbers.offset.first().copied(),
                        &format!(
                            "a time of day in column `{}`, as 10:27:38.103 (frames are counted by their rate: t=row:25fps)",
                            table.name_of(column)
                        ),
                        &format!("`{}`", clipped(&texts[0], 40)),
                    ));
                }
                // A stamp that cannot be read is damage like a number that is none.
                let stamp = |at: usize| times[at].or_else(|| wrong(at).then_some(f64::NAN));
                (0..times.len()).map(stamp).collect()
            }
        };
        numbers.cells.insert(0, times);
        Ok(numbers)
    }
}

/// Names of the columns that nothing reads, as one sentence.
pub(super) fn columns_not_used(
    table: &Table,
    used: impl IntoIterator<Item = usize>,
) -> Option<String> {
    let used: BTreeSet<usize> = used.into_iter().collect();
    let names: Vec<String> = (0..table.header().len())
        .filter(|column| !used.contains(column))
        .map(|column| table.name_of(column))
        .filter(|name| !name.is_empty())
        .map(|name| format!("`{}`", clipped(&name, 40)))
        .collect();
    let more = names.len().saturating_sub(LISTED);
    let file = base(table.file());
    let listed = names.get(..names.len() - more)?.join(", ");
    match (names.len(), more) {
        (0, _) => None,
        (1, _) => Some(format!("{file}: column {listed} is not used")),
        (_, 0) => Some(format!("{file}: columns {listed} are not used")),
        _ => Some(format!(
            "{file}: columns {listed} and {more} more are not used"
        )),
    }
}

/// The columns `prefix` + x, y, z by exact name, in upper or lower case.
pub(super) fn xyz(table: &Table, name: impl Fn(&str) -> String) -> Option<[usize; 3]> {
    let find = |axis: &str| {
        let wanted = name(axis).to_lowercase();
        table.find(|column| column.to_lowercase() == wanted)
    };
    Some([find("x")?, find("y")?, find("z")?])
}

/// Gravity-free acceleration plus gravity at the stamps that both have.
pub(super) fn sum(free: &RawSeries, gravity: &RawSeries) -> RawSeries {
    let rows: HashMap<u64, usize> = gravity.t_s.iter().map(|t| t.to_bits()).zip(0..).collect();
    // Of the axes that both have: each with its places among the channels.
    let common = free.axes.iter().enumerate().filter_map(|(i, axis)| {
        let j = gravity.axes.iter().position(|other| other == axis)?;
        Some((*axis, (i, j)))
    });
    let (axes, places): (Vec<usize>, Vec<(usize, usize)>) = common.unzip();
    let mut total = RawSeries::of_axes(Sensor::Accelerometer, axes);
    for (row, &t_s) in free.t_s.iter().enumerate() {
        if let Some(&other) = rows.get(&t_s.to_bits()) {
            let sums = places
                .iter()
                .map(|&(i, j)| free.channels[i][row] + gravity.channels[j][other]);
            total.push(free.row[row], t_s, sums);
        }
    }
    total
}

/// Puts series of one or several tables together, each on its own clock. Unix time is counted from
/// the first stamp of all sensors, which keeps their clocks together.
pub(super) fn assemble(name: &str, mut series: Vec<(usize, RawSeries)>) -> Result<Recording> {
    for (table, raw) in &mut series {
        raw.table = *table;
    }
    let mut series: Vec<RawSeries> = series.into_iter().map(|(_, raw)| raw).collect();
    from_first_stamp(&mut series);
    crate::assembled::recording_told(name, series)
}

/// Counts Unix time from the first stamp.
pub(super) fn from_first_stamp(series: &mut [RawSeries]) {
    let first = series
        .iter()
        .filter_map(|raw| raw.t_s.iter().copied().find(|t| t.is_finite()))
        .fold(f64::INFINITY, f64::min);
    if first > UNIX_TIME_S && first.is_finite() {
        series
            .iter_mut()
            .flat_map(|raw| &mut raw.t_s)
            .for_each(|t| *t -= first);
    }
}

/// A repair that holds for every sensor of a recording.
pub(super) fn add_repair(recording: &mut Recording, repair: &Repair) {
    let sensors: Vec<Sensor> = recording.sensors().iter().map(|one| one.sensor).collect();
    for sensor in sensors {
        let text = format!("{}: {}", sensor.name(), repair.text);
        recording.repairs.push(Repair {
            sensor,
            text,
            ..repair.clone()
        });
    }
}

/// A remark where the size of gravity contradicts the unit or the kind of acceleration.
pub(super) fn gravity_doubt(recording: &Recording) -> Option<String> {
    let Some(mean) = mean_size(recording) else {
        return free_doubt(recording);
    };
    let likely = match mean {
        m if (7.0..=13.0).contains(&m) => return free_doubt(recording),
        m if (0.7..=1.3).contains(&m) => "the unit is probably g, not m/s2",
        m if (69.0..=128.0).contains(&m) => "the unit is probably m/s2, not g",
        m if m < 0.7 => "gravity is probably already taken out (columns lx, ly, lz)",
        _ => "neither m/s2 nor g fits gravity",
    };
    Some(format!(
        "the mean size of the acceleration is {mean:.3} m/s2 where gravity is 9.8: {likely}"
    ))
}

/// The same of an acceleration that is said to be free of gravity.
fn free_doubt(recording: &Recording) -> Option<String> {
    let mean = mean_length(&recording.linear_accelerometer.as_ref()?.axes);
    (7.0..=13.0).contains(&mean).then(|| {
        format!(
            "the mean size of the acceleration without gravity is {mean:.3} m/s2, which is that of gravity: it is probably not taken out (columns ax, ay, az)"
        )
    })
}

/// Whether the size of gravity says that accelerations are in g.
pub(super) fn is_in_g(recording: &Recording) -> bool {
    mean_size(recording).is_some_and(|mean| (0.7..=1.3).contains(&mean))
}

fn mean_size(recording: &Recording) -> Option<f64> {
    let triad = recording.accelerometer.as_ref()?;
    Some(mean_length(&triad.axes))
}

/// The mean size of vectors by axis.
pub(super) fn mean_length(axes: &[Vec<f64>]) -> f64 {
    let samples = axes.first().map_or(0, Vec::len);
    let size = |i: usize| axes.iter().map(|axis| axis[i].powi(2)).sum::<f64>().sqrt();
    (0..samples).map(size).sum::<f64>() / samples as f64
}
