//! Repaired series, each in its place of a recording, a track or a list.

use super::repair::{self, RawSeries, Repaired, Sampling};
use super::samples::{
    ChannelQuantity, PartialTriad, PeriodList, Recording, Repair, RepairKind, Sensor,
    SingleChannel, Track, Triad,
};
use gyradius_base::{Error, Result};

/// Beside a gap, a value beyond this part of the channel's range is near its limit …
const NEAR_LIMIT: f64 = 0.9;
/// … where this share of all gaps is, …
const MOSTLY: f64 = 0.8;
/// … and there are so many.
const FEWEST_CUTS: usize = 6;

/// Repairs a track.
pub(crate) fn track(name: &str, series: RawSeries) -> Result<Track> {
    let mut repaired = repair_single(series, name, Sampling::Regular)?;
    let y_m = repaired.channels.pop().unwrap_or_default();
    Ok(Track {
        name: name.to_owned(),
        t_s: repaired.t_s,
        y_m,
        repairs: repaired.repairs,
    })
}

/// Repairs a single channel.
pub(crate) fn channel(
    name: &str,
    series: RawSeries,
    quantity: ChannelQuantity,
) -> Result<SingleChannel> {
    let sensor = series.sensor.name();
    let mut repaired = repair_single(series, name, Sampling::Regular)?;
    for repair in &mut repaired.repairs {
        repair.text = repair.text.replacen(sensor, quantity.name(), 1);
    }
    Ok(SingleChannel {
        name: name.to_owned(),
        quantity,
        t_s: repaired.t_s,
        values: repaired.channels.pop().unwrap_or_default(),
        repairs: repaired.repairs,
        at_limit_s: repaired.at_limit_s,
    })
}

/// Repairs a list of periods.
pub(crate) fn periods(name: &str, series: RawSeries) -> Result<PeriodList> {
    let mut repaired = repair_single(series, name, Sampling::Events)?;
    let period_s = repaired.channels.pop().unwrap_or_default();
    Ok(PeriodList {
        name: name.to_owned(),
        t_s: repaired.t_s,
        period_s,
        repairs: repaired.repairs,
    })
}

/// What a sensor recorded, repaired.
struct Placed {
    sensor: Sensor,
    t_s: Vec<f64>,
    /// The channels with their axes.
    axes: Vec<(usize, Vec<f64>)>,
}

impl Placed {
    /// One sample has no clock: a sensor needs two.
    fn of((sensor, axes): (Sensor, Vec<usize>), repaired: Repaired) -> Option<Self> {
        (repaired.t_s.len() >= 2).then(|| Self {
            sensor,
            t_s: repaired.t_s,
            axes: axes.into_iter().zip(repaired.channels).collect(),
        })
    }

    fn span(&self) -> Option<(f64, f64)> {
        Some((*self.t_s.first()?, *self.t_s.last()?))
    }

    fn put_into(self, out: &mut Recording) {
        let place = match self.sensor {
            Sensor::Gyroscope => &mut out.gyroscope,
            Sensor::Accelerometer => &mut out.accelerometer,
            Sensor::LinearAccelerometer => &mut out.linear_accelerometer,
            Sensor::Displacement | Sensor::Timer => return,
        };
        let mut axes = [const { None }; 3];
        for (axis, channel) in self.axes {
            if let Some(place) = axes.get_mut(axis) {
                *place = Some(channel);
            }
        }
        match axes {
            [Some(x), Some(y), Some(z)] => {
                *place = Some(Triad {
                    t_s: self.t_s,
                    axes: [x, y, z],
                });
            }
            axes => out.incomplete.push(PartialTriad {
                sensor: self.sensor,
                t_s: self.t_s,
                axes,
            }),
        }
    }
}

/// Repairs the series of one recording and puts them in their places.
pub(crate) fn recording(name: &str, series: Vec<RawSeries>) -> Result<Recording> {
    let known: Vec<(Sensor, Vec<usize>)> = series
        .iter()
        .map(|raw| (raw.sensor, raw.axes.clone()))
        .collect();
    let repaired = repair::repair_file(series, name, Sampling::Regular)?;
    let mut out = Recording {
        name: name.to_owned(),
        ..Recording::default()
    };
    let mut all = Vec::new();
    for (known, repaired) in known.into_iter().zip(repaired) {
        out.repairs.extend(repaired.repairs.iter().cloned());
        out.at_limit_s.extend(&repaired.at_limit_s);
        all.extend(Placed::of(known, repaired));
    }
    if out.at_limit_s.is_empty() {
        let seen = [Sensor::Gyroscope, Sensor::Accelerometer];
        let sensors = all.iter().filter(|one| seen.contains(&one.sensor));
        out.at_limit_s = sensors.flat_map(left_out_at_limit).collect();
    }
    out.at_limit_s.sort_by(f64::total_cmp);
    drop_other_clocks(&mut all, &mut out.repairs);
    if all.is_empty() {
        return Err(too_few(name, &out.repairs));
    }
    all.into_iter().for_each(|one| one.put_into(&mut out));
    Ok(out)
}

/// The same of what another program exported, with what it has columns for but no sample of.
pub(crate) fn recording_told(name: &str, series: Vec<RawSeries>) -> Result<Recording> {
    let empty: Vec<Repair> = series.iter().filter_map(not_recorded).collect();
    let mut out = recording(name, series)?;
    out.repairs.extend(empty);
    Ok(out)
}

/// A sensor, or an axis of one, that has columns but no sample in them.
fn not_recorded(raw: &RawSeries) -> Option<Repair> {
    let what = match raw.has_samples() {
        true if raw.empty.is_empty() => return None,
        true => format!("{} without a sample", raw.empty.join(", ")),
        false if raw.t_s.is_empty() => "no sample in any row".to_owned(),
        false => "one sample alone, which has no clock".to_owned(),
    };
    let sensor = raw.sensor;
    Some(Repair {
        kind: RepairKind::NotImported,
        sensor,
        count: 0,
        first_s: raw.t_s.first().copied().unwrap_or(0.0),
        last_s: raw.t_s.last().copied().unwrap_or(0.0),
        text: format!("{}: {what}; left out", sensor.name()),
    })
}

/// A sensor whose stamps do not overlap with the gyroscope's (with the accelerometer's where there is
/// none) has a clock of another origin: its samples cannot be put beside the others'.
fn drop_other_clocks(all: &mut Vec<Placed>, repairs: &mut Vec<Repair>) {
    let of = |sensor: Sensor| all.iter().find(|one| one.sensor == sensor)?.span();
    let Some(main) = of(Sensor::Gyroscope).or(of(Sensor::Accelerometer)) else {
        return;
    };
    all.retain(|one| {
        let Some((first_s, last_s)) = one.span() else {
            return false;
        };
        let overlap_s = last_s.min(main.1) - first_s.max(main.0);
        if overlap_s >= 0.5 * (last_s - first_s).min(main.1 - main.0) {
            return true;
        }
        repairs.push(Repair {
            kind: RepairKind::OtherClock,
            sensor: one.sensor,
            count: one.t_s.len(),
            first_s,
            last_s,
            text: format!(
                "{}: its stamps ({first_s} to {last_s} s) lie outside those of the other sensor ({} to {} s), as with a clock of its own; left out",
                one.sensor.name(),
                main.0,
                main.1
            ),
        });
        false
    });
}

/// When samples were at the limit of a sensor that whoever wrote the file has left out already:
/// nearly all gaps begin and end near the same extreme of one channel. By chance a gap of a sinusoid
/// does so once in three.
fn left_out_at_limit(one: &Placed) -> Vec<f64> {
    let Some(interval_s) = repair::median_interval_s(&one.t_s) else {
        return vec![];
    };
    let t_s = &one.t_s;
    let gaps: Vec<usize> = (1..t_s.len())
        .filter(|&i| t_s[i] - t_s[i - 1] > repair::MISSING_INTERVALS * interval_s)
        .collect();
    let is_cut = |(_, channel): &(usize, Vec<f64>)| {
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
    if gaps.len() < FEWEST_CUTS || !one.axes.iter().any(is_cut) {
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

fn repair_single(series: RawSeries, name: &str, sampling: Sampling) -> Result<Repaired> {
    let repaired = repair::repair_file(vec![series], name, sampling)?
        .pop()
        .unwrap_or_default();
    if repaired.t_s.len() < 2 {
        return Err(too_few(name, &repaired.repairs));
    }
    Ok(repaired)
}
