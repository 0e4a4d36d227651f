//! The project's own recordings: `t,gx,gy,gz,ax,ay,az`, tracks `t,y` and period lists `t,period`.
//!
//! # Conventions
//! Columns are found by name, in any order; s, rad/s, m/s² of specific force, m. An empty cell
//! means that the sensor has no sample in that row, so that sensors keep their own clocks.
//! `lx,ly,lz` is acceleration without gravity.

use super::import::table::{Columns, Table};
use super::repair::{self, RawSeries, Repaired, Sampling};
use super::samples::{
    ChannelQuantity, PeriodList, Recording, Repair, RepairKind, Sensor, SingleChannel, Track, Triad,
};
use gyradius_base::{Error, Result};

/// The three-axis sensors with the names of their columns.
pub(crate) const TRIADS: [(Sensor, [&str; 3]); 3] = [
    (Sensor::Gyroscope, ["gx", "gy", "gz"]),
    (Sensor::Accelerometer, ["ax", "ay", "az"]),
    (Sensor::LinearAccelerometer, ["lx", "ly", "lz"]),
];

/// A sampled record of more rows than this at more than a second each has its stamps in another
/// unit.
const SLOW_ROWS: usize = 100;

/// Beside a gap, a value beyond this part of the channel's range is near its limit …
const NEAR_LIMIT: f64 = 0.9;
/// … where this share of all gaps is, …
const MOSTLY: f64 = 0.8;
/// … and there are so many.
const FEWEST_CUTS: usize = 6;

/// Reads a phone's recording, or a single channel `t,angle`, `t,rate` or one axis of a gyroscope;
/// repairs listed.
pub fn read_recording(bytes: &[u8], name: &str) -> Result<Recording> {
    let table = Table::native(bytes, name)?;
    match single_column(&table) {
        Some((column, quantity)) => {
            single_channel(bytes, name, &column, quantity).map(Recording::from)
        }
        None => read_table(&table),
    }
}

/// The only column beside the time, where it is a single channel.
pub(crate) fn single_column(table: &Table) -> Option<(String, ChannelQuantity)> {
    let names = table.header().iter().map(|name| name.trim());
    let mut others = names.filter(|column| *column != "t");
    let (column, None) = (others.next()?, others.next()) else {
        return None;
    };
    let (_, axes) = TRIADS[0];
    let quantity = match column {
        name if name == ChannelQuantity::Angle.name() => ChannelQuantity::Angle,
        name if name == ChannelQuantity::Rate.name() || axes.contains(&name) => {
            ChannelQuantity::Rate
        }
        _ => return None,
    };
    Some((column.to_owned(), quantity))
}

/// The same from a table whose header has been found already.
pub(crate) fn read_table(table: &Table) -> Result<Recording> {
    let known: Vec<&str> = std::iter::once("t")
        .chain(TRIADS.iter().flat_map(|triad| triad.1))
        .collect();
    check_header(table, &known)?;
    let time = required(table, "t")?;
    let mut sensors = Vec::new();
    for (sensor, axes) in TRIADS {
        if let Some(columns) = all_or_none(table, axes)? {
            sensors.push((sensor, columns.to_vec()));
        }
    }
    if sensors.is_empty() {
        return Err(table.malformed(
            Some(0),
            "columns gx,gy,gz (gyroscope) or ax,ay,az (accelerometer)",
            &format!("`{}`", table.header_text()),
        ));
    }
    let series = read_series(table, time, &sensors)?;
    check_clock(&series, table)?;
    recording(table.file(), series)
}

/// Reads a rangefinder's track `t,y`.
pub fn read_track(bytes: &[u8], name: &str) -> Result<Track> {
    let series = read_single(bytes, name, "y", Sensor::Displacement, Sampling::Regular)?;
    track_of(series, name)
}

/// Repairs a track that comes from another program.
pub(crate) fn track(name: &str, series: RawSeries) -> Result<Track> {
    track_of(vec![series], name)
}

fn track_of(series: Vec<RawSeries>, name: &str) -> Result<Track> {
    let mut repaired = repair_single(series, name, Sampling::Regular)?;
    let y_m = repaired.channels.pop().unwrap_or_default();
    Ok(Track {
        name: name.to_owned(),
        t_s: repaired.t_s,
        y_m,
        repairs: repaired.repairs,
    })
}

/// Reads a single channel `t,angle` (rad) or `t,rate` (rad/s).
pub fn read_channel(bytes: &[u8], name: &str) -> Result<SingleChannel> {
    let table = Table::native(bytes, name)?;
    match single_column(&table) {
        Some((column, quantity)) => single_channel(bytes, name, &column, quantity),
        None => Err(table.malformed(
            Some(0),
            "the columns t and angle, rate or one of gx, gy, gz",
            &format!("`{}`", table.header_text()),
        )),
    }
}

fn single_channel(
    bytes: &[u8],
    name: &str,
    column: &str,
    quantity: ChannelQuantity,
) -> Result<SingleChannel> {
    let sensor = match quantity {
        ChannelQuantity::Angle => Sensor::Displacement,
        ChannelQuantity::Rate => Sensor::Gyroscope,
    };
    let mut series = read_single(bytes, name, column, sensor, Sampling::Regular)?;
    match series.pop() {
        Some(raw) => channel(name, raw, quantity),
        None => Err(too_few(name, &[])),
    }
}

/// Repairs a single channel that comes from another program.
pub(crate) fn channel(
    name: &str,
    series: RawSeries,
    quantity: ChannelQuantity,
) -> Result<SingleChannel> {
    let sensor = series.sensor.name();
    let mut repaired = repair_single(vec![series], name, Sampling::Regular)?;
    for repair in &mut repaired.repairs {
        repair.text = repair.text.replacen(sensor, quantity.name(), 1);
    }
    Ok(SingleChannel {
        name: name.to_owned(),
        quantity,
        t_s: repaired.t_s,
        values: repaired.channels.pop().unwrap_or_default(),
        repairs: repaired.repairs,
    })
}

/// Reads a list of periods `t,period`.
pub fn read_period_list(bytes: &[u8], name: &str) -> Result<PeriodList> {
    let series = read_single(bytes, name, "period", Sensor::Timer, Sampling::Events)?;
    let mut repaired = repair_single(series, name, Sampling::Events)?;
    let period_s = repaired.channels.pop().unwrap_or_default();
    Ok(PeriodList {
        name: name.to_owned(),
        t_s: repaired.t_s,
        period_s,
        repairs: repaired.repairs,
    })
}

/// Repairs the series of one recording and puts them in their places.
pub(crate) fn recording(name: &str, series: Vec<RawSeries>) -> Result<Recording> {
    let sensors: Vec<Sensor> = series.iter().map(|raw| raw.sensor).collect();
    let repaired = repair::repair_file(series, name, Sampling::Regular)?;
    let mut out = Recording {
        name: name.to_owned(),
        ..Recording::default()
    };
    for (sensor, repaired) in sensors.into_iter().zip(repaired) {
        out.repairs.extend(repaired.repairs.iter().cloned());
        out.at_limit_s.extend(&repaired.at_limit_s);
        let place = match sensor {
            Sensor::Gyroscope => &mut out.gyroscope,
            Sensor::Accelerometer => &mut out.accelerometer,
            Sensor::LinearAccelerometer => &mut out.linear_accelerometer,
            Sensor::Displacement | Sensor::Timer => continue,
        };
        *place = triad(repaired);
    }
    if out.at_limit_s.is_empty() {
        let sensors = [&out.gyroscope, &out.accelerometer];
        out.at_limit_s = sensors
            .into_iter()
            .flatten()
            .flat_map(left_out_at_limit)
            .collect();
    }
    out.at_limit_s.sort_by(f64::total_cmp);
    drop_other_clocks(&mut out);
    let usable = [
        &out.gyroscope,
        &out.accelerometer,
        &out.linear_accelerometer,
    ];
    if usable.iter().all(|triad| triad.is_none()) {
        return Err(too_few(name, &out.repairs));
    }
    Ok(out)
}

/// A sensor whose stamps do not overlap with the gyroscope's (with the accelerometer's where there is
/// none) has a clock of another origin: its samples cannot be put beside the others'.
fn drop_other_clocks(out: &mut Recording) {
    let span = |triad: &Option<Triad>| {
        let t_s = &triad.as_ref()?.t_s;
        Some((*t_s.first()?, *t_s.last()?))
    };
    let Some(main) = span(&out.gyroscope).or(span(&out.accelerometer)) else {
        return;
    };
    for (sensor, place) in [
        (Sensor::Accelerometer, &mut out.accelerometer),
        (Sensor::LinearAccelerometer, &mut out.linear_accelerometer),
    ] {
        let Some((first_s, last_s)) = span(place) else {
            continue;
        };
        let overlap_s = last_s.min(main.1) - first_s.max(main.0);
        if overlap_s >= 0.5 * (last_s - first_s).min(main.1 - main.0) {
            continue;
        }
        let count = place.take().map_or(0, |triad| triad.t_s.len());
        out.repairs.push(Repair {
            kind: RepairKind::OtherClock,
            sensor,
            count,
            first_s,
            last_s,
            text: format!(
                "{}: its stamps ({first_s} to {last_s} s) lie outside those of the other sensor ({} to {} s), as with a clock of its own; left out",
                sensor.name(),
                main.0,
                main.1
            ),
        });
    }
}

/// When samples were at the limit of a sensor that whoever wrote the file has left out already:
/// nearly all gaps begin and end near the same extreme of one channel. By chance a gap of a sinusoid
/// does so once in three.
fn left_out_at_limit(triad: &Triad) -> Vec<f64> {
    let Some(interval_s) = repair::median_interval_s(&triad.t_s) else {
        return vec![];
    };
    let t_s = &triad.t_s;
    let gaps: Vec<usize> = (1..t_s.len())
        .filter(|&i| t_s[i] - t_s[i - 1] > repair::MISSING_INTERVALS * interval_s)
        .collect();
    let is_cut = |channel: &Vec<f64>| {
        let low = channel.iter().copied().fold(f64::INFINITY, f64::min);
        let high = channel.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let edge = (1.0 - NEAR_LIMIT) * (high - low);
        let near = |v: f64| (v > high - edge, v < low + edge);
        let cut = |&&i: &&usize| {
            let (before, after) = (near(channel[i - 1]), near(channel[i]));
            (before.0 && after.0) || (before.1 && after.1)
        };
        let cuts = gaps.iter().filter(cut).count();
        // Beside one far value all others are near an extreme.
        let anywhere = channel
            .iter()
            .filter(|v| near(**v) != (false, false))
            .count();
        let is_rare = 2 * anywhere < channel.len();
        is_rare && cuts as f64 > MOSTLY * gaps.len() as f64
    };
    if gaps.len() < FEWEST_CUTS || !triad.axes.iter().any(is_cut) {
        return vec![];
    }
    let lost = |&i: &usize| {
        let missing = ((t_s[i] - t_s[i - 1]) / interval_s).round() as usize;
        // A pause among them is none of them.
        let few = Some(missing).filter(|n| *n < t_s.len() / gaps.len() * FEWEST_CUTS);
        (1..few.unwrap_or(1)).map(move |k| t_s[i - 1] + k as f64 * interval_s)
    };
    gaps.iter().flat_map(lost).collect()
}

/// One sample has no clock: a sensor needs two.
fn triad(repaired: Repaired) -> Option<Triad> {
    let axes: [Vec<f64>; 3] = repaired.channels.try_into().ok()?;
    (repaired.t_s.len() >= 2).then_some(Triad {
        t_s: repaired.t_s,
        axes,
    })
}

fn too_few(name: &str, repairs: &[Repair]) -> Error {
    let texts: Vec<&str> = repairs.iter().map(|repair| repair.text.as_str()).collect();
    let found = if texts.is_empty() {
        "fewer than two".to_owned()
    } else {
        format!("fewer than two ({})", texts.join("; "))
    };
    Error::Malformed {
        file: name.to_owned(),
        line: None,
        expected: "at least two rows of usable samples".to_owned(),
        found,
    }
}

fn read_single(
    bytes: &[u8],
    name: &str,
    column: &str,
    sensor: Sensor,
    sampling: Sampling,
) -> Result<Vec<RawSeries>> {
    let table = Table::native(bytes, name)?;
    check_header(&table, &["t", column])?;
    let columns = [required(&table, "t")?, required(&table, column)?];
    let numbers = table.numbers(&columns)?;
    if sensor == Sensor::Timer {
        check_periods(&table, &numbers)?;
    }
    let series = vec![collect(&table, &numbers, sensor, &[1])?];
    if sampling == Sampling::Regular {
        check_clock(&series, &table)?;
    }
    Ok(series)
}

fn repair_single(series: Vec<RawSeries>, name: &str, sampling: Sampling) -> Result<Repaired> {
    let repaired = repair::repair_file(series, name, sampling)?
        .pop()
        .unwrap_or_default();
    if repaired.t_s.len() < 2 {
        return Err(too_few(name, &repaired.repairs));
    }
    Ok(repaired)
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

/// The samples of several sensors from one table, each with the rows in which it has cells.
fn read_series(
    table: &Table,
    time: usize,
    sensors: &[(Sensor, Vec<usize>)],
) -> Result<Vec<RawSeries>> {
    let columns: Vec<usize> = std::iter::once(time)
        .chain(sensors.iter().flat_map(|sensor| sensor.1.iter().copied()))
        .collect();
    let numbers = table.numbers(&columns)?;
    let mut next = 1;
    let mut series = Vec::new();
    for (sensor, axes) in sensors {
        let places: Vec<usize> = (next..next + axes.len()).collect();
        next += axes.len();
        series.push(collect(table, &numbers, *sensor, &places)?);
    }
    Ok(series)
}

/// Samples of one sensor from its columns; `cells[0]` is time.
pub(crate) fn collect(
    table: &Table,
    numbers: &Columns,
    sensor: Sensor,
    places: &[usize],
) -> Result<RawSeries> {
    let mut raw = RawSeries::new(sensor, places.len());
    for (row, &offset) in numbers.offset.iter().enumerate() {
        let number = numbers.row.get(row).copied().unwrap_or(row);
        let cells = || places.iter().map(|&place| numbers.cells[place][row]);
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
    table.find(|name| name == column).ok_or_else(|| {
        table.malformed(
            Some(0),
            &format!("a column `{column}`"),
            &format!("`{}`", table.header_text()),
        )
    })
}

fn all_or_none(table: &Table, axes: [&str; 3]) -> Result<Option<[usize; 3]>> {
    match axes.map(|axis| table.find(|name| name == axis)) {
        [None, None, None] => Ok(None),
        [Some(x), Some(y), Some(z)] => Ok(Some([x, y, z])),
        _ => Err(table.malformed(
            Some(0),
            &format!("columns {} together", axes.join(", ")),
            &format!("`{}`", table.header_text()),
        )),
    }
}

/// Stamps in milliseconds or nanoseconds would make every period a thousand times too long: refused
/// aloud.
fn check_clock(series: &[RawSeries], table: &Table) -> Result<()> {
    for raw in series {
        let Some(median) = repair::median_interval_s(&raw.t_s) else {
            continue;
        };
        if raw.t_s.len() <= SLOW_ROWS || median <= 1.0 {
            continue;
        }
        let unit = match median {
            m if m >= 1e5 => "nanoseconds",
            m if m >= 1e3 => "microseconds",
            _ => "milliseconds",
        };
        return Err(table.malformed(
            Some(0),
            "time in seconds in column `t`",
            &format!("a sample every {median} s; the stamps look like {unit}"),
        ));
    }
    Ok(())
}
