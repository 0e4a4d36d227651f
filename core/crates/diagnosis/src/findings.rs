//! What the base simulation gets wrong, as sentences.

use num_complex::Complex64;

use gyradius_base::error::Result;
use gyradius_base::frames::Vec3;
use gyradius_identification::InputKind;
use gyradius_identification::parameters::Role;
use gyradius_identification::samples::Sensor;
use gyradius_recording::{ModeName, RepairKind};
use gyradius_signal::{FittedMode, Pole};

use super::fitted_swing::Base;
use super::fitting::Fitted;
use super::point::{Model, Point};
use super::result::{Discrepancy, DiscrepancyKind};
use super::seen::Seen;
use super::shape::{direction, energy, shape};
use super::unit::UnitName;
use super::white::{Band, Left};
use super::words;
use gyradius_base::message::{Argument, Message};

/// A stated dimension that is pulled by more standard uncertainties is told of.
const PULLED: f64 = 3.0;
/// Lines told of in each swing.
const LINES: usize = 3;
/// So many motions of each swing are followed by themselves.
const MOTIONS: usize = 2;
const AXES: [&str; 3] = ["x", "y", "z"];

/// Everything found, the most significant first.
pub fn findings(model: &Model, fitted: &Fitted, left: &Left) -> Result<Vec<Discrepancy>> {
    let mut all = structure(model, &fitted.point, left)?;
    for s in 0..model.base.swings.len() {
        all.extend(motions(model, &fitted.point, s)?);
    }
    all.extend(dimensions(model.base, &fitted.point));
    all.extend(saturated(model.base));
    all.sort_by(|a, b| b.sigma.total_cmp(&a.sigma));
    Ok(all)
}

/// By swing: how much is left, how it goes with time, and at which frequencies.
fn structure(model: &Model, point: &Point, left: &Left) -> Result<Vec<Discrepancy>> {
    let mut all = Vec::new();
    for (s, fitted_swing) in model.base.swings.iter().enumerate() {
        let bands: Vec<&Band> = left.bands.iter().filter(|b| b.swing == s).collect();
        if bands.is_empty() {
            continue;
        }
        let rows = model.rows(point, s)?;
        let times: Vec<f64> = model.blocks(s).iter().map(|block| block.t_s).collect();
        let id = &fitted_swing.setup.swing.id;
        let record = Record {
            id,
            rows: &rows,
            times_s: &times,
            duration_s: fitted_swing.samples.duration_s,
        };
        all.extend(structure_of(&record, 6, bands, &|channel| {
            let key = if channel < 3 {
                "line_gyroscope"
            } else {
                "line_accelerometer"
            };
            words::message(key, [("axis", words::written(AXES[channel % 3]))])
        }));
    }
    Ok(all)
}

/// The strongest turns of a swing, each about its axis: period and decay against amplitude, what is
/// left against phase.
fn motions(model: &Model, point: &Point, s: usize) -> Result<Vec<Discrepancy>> {
    let fitted_swing = model.swing(s);
    let (evidence, streams) = (fitted_swing.evidence, &fitted_swing.samples.streams);
    let Some(stream) = streams
        .iter()
        .position(|stream| stream.sensor == Sensor::Gyroscope)
    else {
        return Ok(vec![]);
    };
    let (samples, readings) = (&streams[stream], model.readings(point, s)?);
    let poles: Vec<Pole> = evidence.found.modes.iter().map(pole).collect();
    let mut turns: Vec<(usize, [Complex64; 3])> = Vec::new();
    for (m, mode) in evidence.found.modes.iter().enumerate() {
        turns.extend(shape(mode, &evidence.rates()).map(|shape| (m, shape)));
    }
    turns.sort_by(|a, b| energy(&b.1).total_cmp(&energy(&a.1)));
    let mut all = Vec::new();
    for (m, shape) in turns.into_iter().take(MOTIONS) {
        let axis = direction(&shape);
        let along = |values: &[Vec3]| values.iter().map(|v| v.dot(&axis)).collect::<Vec<f64>>();
        let others: Vec<Pole> = (0..poles.len())
            .filter(|o| *o != m)
            .map(|o| poles[o])
            .collect();
        let seen = Seen {
            swing: &fitted_swing.setup.swing.id,
            motion: evidence
                .named
                .get(m)
                .map_or(ModeName::Other, |named| named.name),
            t_s: &samples.t_s,
            measured: &along(&samples.values),
            simulated: &along(&readings[stream]),
            is_angle: false,
            noise: samples.noise_along(&axis),
            duration_s: fitted_swing.samples.duration_s,
            mode: poles[m],
            others: &others,
        };
        all.extend(seen.findings());
    }
    Ok(all)
}

fn pole(mode: &FittedMode) -> Pole {
    Pole {
        omega_rad_s: mode.omega_rad_s,
        alpha_per_s: mode.alpha_per_s,
    }
}

/// Residuals of a swing over their noise, so many rows at each time.
pub struct Record<'a> {
    pub id: &'a str,
    pub rows: &'a [f64],
    pub times_s: &'a [f64],
    pub duration_s: f64,
}

/// The same of one swing with so many channels, each of a name.
pub fn structure_of(
    record: &Record,
    channels: usize,
    mut bands: Vec<&Band>,
    name: &dyn Fn(usize) -> Message,
) -> Vec<Discrepancy> {
    let Record { id, rows, .. } = *record;
    let excess: f64 = bands.iter().map(|b| b.excess).sum();
    let rms = (rows.iter().map(|r| r * r).sum::<f64>() / rows.len().max(1) as f64).sqrt();
    let said = words::message(
        "structure",
        [("swing", words::id(id)), ("rms", words::number(rms, 2))],
    );
    let mut all = vec![Discrepancy::of(
        id,
        DiscrepancyKind::Structure,
        (rms, UnitName::One),
        excess.sqrt(),
        said,
    )];
    all.extend(against_time(record));
    bands.sort_by(|a, b| b.excess.total_cmp(&a.excess));
    all.extend(
        bands
            .iter()
            .take(LINES)
            .map(|band| line(id, band, rows.len() / channels, name(band.channel))),
    );
    all
}

fn line(id: &str, band: &Band, rows_of_channel: usize, channel: Message) -> Discrepancy {
    let middle_hz = 0.5 * (band.from_hz + band.to_hz);
    // A sinusoid of amplitude a (in noise) adds n a²/2 to χ² of n samples.
    let size = (2.0 * band.excess / rows_of_channel as f64).sqrt();
    let said = words::message(
        "line",
        [
            ("swing", words::id(id)),
            ("middle_hz", words::number(middle_hz, 3)),
            ("channel", words::part(Some(channel))),
            ("size", words::number(size, 2)),
        ],
    );
    Discrepancy::of(
        id,
        DiscrepancyKind::LineInSpectrum,
        (size, UnitName::One),
        band.sigma,
        said,
    )
}

/// Whether more is left at the beginning or at the end: by the halves of the record.
fn against_time(record: &Record) -> Option<Discrepancy> {
    let Record {
        id,
        rows,
        times_s,
        duration_s,
    } = *record;
    let (half_s, size) = (0.5 * duration_s, rows.len() / times_s.len().max(1));
    let (mut sums, mut counts) = ([0.0; 2], [0.0; 2]);
    for (t_s, row) in times_s.iter().zip(rows.chunks_exact(size.max(1))) {
        let k = usize::from(*t_s > half_s);
        sums[k] += row.iter().map(|r| r * r).sum::<f64>();
        counts[k] += size as f64;
    }
    let [early, late] = [0, 1].map(|k| sums[k] / f64::max(counts[k], 1.0));
    let sigma = (early - late).abs() / (2.0 / counts[0].max(1.0) + 2.0 / counts[1].max(1.0)).sqrt();
    (sigma > 5.0).then(|| {
        let said = words::message(
            if early > late {
                "first_half"
            } else {
                "second_half"
            },
            [
                ("swing", words::id(id)),
                ("more", words::number(early.max(late).sqrt(), 2)),
                ("less", words::number(early.min(late).sqrt(), 2)),
            ],
        );
        Discrepancy::of(
            id,
            DiscrepancyKind::ResidualVsTime,
            (early.sqrt() - late.sqrt(), UnitName::One),
            sigma,
            said,
        )
    })
}

/// Stated figures that the swings pull away from what was stated.
fn dimensions(base: &Base, point: &Point) -> Vec<Discrepancy> {
    let mut all = Vec::new();
    for i in &base.free {
        let parameter = &base.layout().parameters[*i];
        let sigma = (point.x[*i] - parameter.prior.value) / parameter.prior.u;
        if parameter.role != Role::Stated || sigma.abs() < PULLED {
            continue;
        }
        let change = point.x[*i] - parameter.prior.value;
        let unit = unit_of(parameter.name.kind);
        let stated = parameter.prior.value;
        let times = ("sigma", words::number(sigma.abs(), 1));
        let said = if parameter.name.kind == InputKind::PhoneClock {
            words::message(
                "clock",
                [
                    ("ppm", words::written(format!("{:+.0}", 1e6 * change))),
                    times,
                ],
            )
        } else {
            words::message(
                "pulled",
                [
                    (
                        "name",
                        words::word(&format!("parameter.{}", parameter.name)),
                    ),
                    ("stated", words::number(stated, 5)),
                    ("unit", Argument::Plain(unit.to_string())),
                    ("change", words::written(format!("{change:+.5}"))),
                    times,
                ],
            )
        };
        all.push(Discrepancy::of(
            "",
            DiscrepancyKind::Dimension,
            (change, unit),
            sigma.abs(),
            said,
        ));
    }
    all
}

/// Clocks and masses have a unit here.
fn unit_of(kind: InputKind) -> UnitName {
    match kind {
        InputKind::PhoneClock => UnitName::One,
        InputKind::Mass => UnitName::Kilogram,
        other => other.into(),
    }
}

/// Sensors that came to the end of their range.
fn saturated(base: &Base) -> Vec<Discrepancy> {
    let mut all = Vec::new();
    for fitted_swing in &base.swings {
        let id = &fitted_swing.setup.swing.id;
        let samples: usize = fitted_swing
            .samples
            .streams
            .iter()
            .map(|s| s.t_s.len())
            .max()
            .unwrap_or(0);
        for repair in fitted_swing
            .evidence
            .repairs
            .iter()
            .filter(|r| r.kind == RepairKind::Saturation)
        {
            let size = repair.count as f64 / (samples + repair.count).max(1) as f64;
            let said = words::message(
                "saturated",
                [
                    ("swing", words::id(id)),
                    ("repair", Argument::Plain(repair.text.clone())),
                ],
            );
            all.push(Discrepancy::of(
                id,
                DiscrepancyKind::Saturated,
                (size, UnitName::One),
                (repair.count as f64).sqrt(),
                said,
            ));
        }
    }
    all
}
