//! The project's own recordings: `t,gx,gy,gz,ax,ay,az`, tracks `t,y` and period lists `t,period`.
//!
//! # Conventions
//! Columns are found by name, in any order; s, rad/s, m/s² of specific force, m. An empty cell
//! means that the sensor has no sample in that row, so that sensors keep their own clocks.
//! `lx,ly,lz` is acceleration without gravity.

use super::assembled::{channel, periods, recording, recording_told, track};
use super::import::table::{Columns, Table};
use super::repair::{self, RawSeries};
use super::samples::{
    ChannelQuantity, PeriodList, Recording, Sensor, SingleChannel, TRIADS, Track,
};
use gyradius_base::{Error, Result};

/// A sampled record of more rows than this at more than a second each has its stamps in another
/// unit.
const SLOW_ROWS: usize = 100;

/// Reads a phone's recording, of any of its axes, or a single channel `t,angle`, `t,rate`; repairs
/// listed.
pub fn read_recording(bytes: &[u8], name: &str) -> Result<Recording> {
    let table = Table::native(bytes, name)?;
    match single_column(&table) {
        Some(quantity) => single_channel(&table, quantity).map(Recording::from),
        None => read_table(&table),
    }
}

/// What the only column beside the time is, where it has no axis.
fn single_column(table: &Table) -> Option<ChannelQuantity> {
    let names = table.header().iter().map(|name| name.trim());
    let mut others = names.filter(|column| *column != "t");
    let (column, None) = (others.next()?, others.next()) else {
        return None;
    };
    let mut all = [ChannelQuantity::Angle, ChannelQuantity::Rate].into_iter();
    all.find(|quantity| quantity.name() == column)
}

/// The axes of a phone's sensors from a table whose header has been found already.
pub(crate) fn read_table(table: &Table) -> Result<Recording> {
    let known: Vec<&str> = std::iter::once("t")
        .chain(TRIADS.iter().flat_map(|triad| triad.1))
        .collect();
    check_header(table, &known)?;
    let (series, _) = axes_of(table)?;
    recording(table.file(), series)
}

/// The same whatever other columns there are, names in upper or lower case; with the columns that are
/// read.
pub(crate) fn read_axes(table: &Table) -> Result<(Recording, Vec<usize>)> {
    let (series, columns) = axes_of(table)?;
    Ok((recording_told(table.file(), series)?, columns))
}

fn axes_of(table: &Table) -> Result<(Vec<RawSeries>, Vec<usize>)> {
    let find = |name: &str| known_once(table, name);
    let time = find("t")?.ok_or_else(|| missing(table, "t"))?;
    let mut columns = vec![time];
    let mut sensors = Vec::new();
    for (sensor, axes) in TRIADS {
        let mut places = Vec::new();
        for (axis, name) in axes.into_iter().enumerate() {
            if let Some(column) = find(name)? {
                places.push((axis, columns.len()));
                columns.push(column);
            }
        }
        if !places.is_empty() {
            sensors.push((sensor, places));
        }
    }
    if sensors.is_empty() {
        return Err(table.malformed(
            Some(0),
            "columns of gx,gy,gz (gyroscope) or ax,ay,az (accelerometer)",
            &format!("`{}`", table.header_text()),
        ));
    }
    let numbers = table.numbers(&columns)?;
    let series = sensors
        .iter()
        .map(|(sensor, places)| collect(table, &numbers, *sensor, places))
        .collect::<Result<Vec<_>>>()?;
    check_clock(&series, table)?;
    Ok((series, columns))
}

/// A column by its name, in upper or lower case; two of one name are refused.
fn known_once(table: &Table, name: &str) -> Result<Option<usize>> {
    let names = table.header().iter().enumerate();
    let mut having = names.filter(|(_, column)| column.eq_ignore_ascii_case(name));
    let first = having.next().map(|(column, _)| column);
    match having.next() {
        None => Ok(first),
        Some(_) => Err(table.malformed(
            Some(0),
            &format!("column `{name}` once"),
            &format!("`{}`", table.header_text()),
        )),
    }
}

/// Reads a single channel `t,angle` (rad) or `t,rate` (rad/s).
pub fn read_channel(bytes: &[u8], name: &str) -> Result<SingleChannel> {
    channel_of(&Table::native(bytes, name)?)
}

/// The same from a table whose header has been found already.
pub(crate) fn channel_of(table: &Table) -> Result<SingleChannel> {
    match single_column(table) {
        Some(quantity) => single_channel(table, quantity),
        None => Err(table.malformed(
            Some(0),
            "the columns t and angle, or t and rate",
            &format!("`{}`", table.header_text()),
        )),
    }
}

fn single_channel(table: &Table, quantity: ChannelQuantity) -> Result<SingleChannel> {
    let raw = read_single(table, quantity.name(), quantity.sensor())?;
    check_clock(std::slice::from_ref(&raw), table)?;
    channel(table.file(), raw, quantity)
}

/// Reads a rangefinder's track `t,y`.
pub fn read_track(bytes: &[u8], name: &str) -> Result<Track> {
    track_of(&Table::native(bytes, name)?)
}

/// The same from a table whose header has been found already.
pub(crate) fn track_of(table: &Table) -> Result<Track> {
    let raw = read_single(table, "y", Sensor::Displacement)?;
    check_clock(std::slice::from_ref(&raw), table)?;
    track(table.file(), raw)
}

/// Reads a list of periods `t,period`.
pub fn read_period_list(bytes: &[u8], name: &str) -> Result<PeriodList> {
    periods_of(&Table::native(bytes, name)?)
}

/// The same from a table whose header has been found already.
pub(crate) fn periods_of(table: &Table) -> Result<PeriodList> {
    periods(table.file(), read_single(table, "period", Sensor::Timer)?)
}

/// The only column of a table beside the time.
fn read_single(table: &Table, column: &str, sensor: Sensor) -> Result<RawSeries> {
    check_header(table, &["t", column])?;
    let columns = [required(table, "t")?, required(table, column)?];
    let numbers = table.numbers(&columns)?;
    if sensor == Sensor::Timer {
        check_periods(table, &numbers)?;
    }
    collect(table, &numbers, sensor, &[(0, 1)])
}

fn check_periods(table: &Table, numbers: &Columns) -> Result<()> {
    for (offset, period) in numbers.offset.iter().zip(&numbers.cells[1]) {
        if let Some(period) = period.filter(|period| *period <= 0.0) {
            return Err(table.malformed(
                Some(*offset),
                "a period above 0 s in column `period`",
                &period.to_string(),
            ));
        }
    }
    Ok(())
}

/// Samples of one sensor from its columns, each an axis and its place among the numbers;
/// `cells[0]` is time. An axis of which no row has a cell was not recorded.
pub(crate) fn collect(
    table: &Table,
    numbers: &Columns,
    sensor: Sensor,
    places: &[(usize, usize)],
) -> Result<RawSeries> {
    let is_filled = |place: usize| numbers.cells[place].iter().any(Option::is_some);
    let filled = || places.iter().filter(|(_, place)| is_filled(*place));
    let filled: Vec<(usize, usize)> = match filled().count() {
        0 => places.to_vec(),
        _ => filled().copied().collect(),
    };
    let mut raw = RawSeries::of_axes(sensor, filled.iter().map(|(axis, _)| *axis).collect());
    raw.empty = places
        .iter()
        .filter(|(_, place)| !is_filled(*place))
        .map(|(axis, _)| sensor.axis_name(*axis).to_owned())
        .collect();
    for (row, &offset) in numbers.offset.iter().enumerate() {
        let number = numbers.row.get(row).copied().unwrap_or(row);
        let cells = || filled.iter().map(|&(_, place)| numbers.cells[place][row]);
        if cells().all(|cell| cell.is_none()) {
            continue;
        }
        let Some(t_s) = numbers.cells[0][row] else {
            return Err(table.malformed(Some(offset), "a time stamp", "an empty cell"));
        };
        raw.push(number, t_s, cells().map(|cell| cell.unwrap_or(f64::NAN)));
    }
    Ok(raw)
}

/// Refuses names that are unknown or stand twice.
fn check_header(table: &Table, known: &[&str]) -> Result<()> {
    for (i, name) in table.header().iter().enumerate() {
        if !known.contains(&name.as_str()) {
            return Err(Error::UnknownKey {
                file: table.file().to_owned(),
                line: Some(table.line_at(0)),
                key: super::import::table::clipped(name, 40),
                nearest: nearest(name, known),
            });
        }
        if table.header()[..i].contains(name) {
            return Err(table.malformed(
                Some(0),
                &format!("column `{name}` once"),
                &format!("`{}`", table.header_text()),
            ));
        }
    }
    Ok(())
}

fn nearest(name: &str, known: &[&str]) -> Option<String> {
    let name = name.to_lowercase();
    known
        .iter()
        .min_by_key(|key| strsim::damerau_levenshtein(key, &name))
        .map(|key| (*key).to_owned())
}

fn required(table: &Table, column: &str) -> Result<usize> {
    table
        .find(|name| name == column)
        .ok_or_else(|| missing(table, column))
}

fn missing(table: &Table, column: &str) -> Error {
    table.malformed(
        Some(0),
        &format!("a column `{column}`"),
        &format!("`{}`", table.header_text()),
    )
}

/// Stamps in milliseconds or nanoseconds would make every period a thousand times too long: refused
/// aloud.
fn check_clock(series: &[RawSeries], table: &Table) -> Result<()> {
    for raw in series {
        let Some(median) = repair::median_interval_s(&raw.t_s) else {
            continue;
        };
        // Packets share a stamp: on average they come as fast as they were taken.
        let stamps = || raw.t_s.iter().copied().filter(|t| t.is_finite());
        let (first, last) = (stamps().reduce(f64::min), stamps().reduce(f64::max));
        let span_s = first.zip(last).map_or(0.0, |(first, last)| last - first);
        let interval = median.min(span_s / (raw.t_s.len().max(2) - 1) as f64);
        if raw.t_s.len() <= SLOW_ROWS || interval <= 1.0 {
            continue;
        }
        let unit = match interval {
            m if m >= 1e5 => "nanoseconds",
            m if m >= 1e3 => "microseconds",
            _ => "milliseconds",
        };
        return Err(table.malformed(
            Some(0),
            "time in seconds in column `t`",
            &format!("a sample every {interval} s; the stamps look like {unit}"),
        ));
    }
    Ok(())
}
