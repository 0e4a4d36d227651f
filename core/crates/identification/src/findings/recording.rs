//! What is not plausible in one swing's record, or in its list of periods.

use std::f64::consts::PI;

use gyradius_base::frames::Vec3;
use gyradius_base::message::Argument;
use gyradius_recording::{ChannelQuantity, PeriodList, Recording, Repair, RepairKind, Sensor};
use gyradius_signal::{ChannelGroup, FittedMode};
use num_complex::Complex64;

use super::rate::{Sampled, sampled_enough};
use super::support::of_axes;
use super::{Finding, FindingKind as Kind, Severity};
use crate::measurement::SwingResult;
use crate::modes::ChannelMap;
use crate::observe::Evidence;

/// What moves has so many times the variance of the noise …
const STANDS_OUT: f64 = 10.0;
/// … and at least this share of it is in the oscillations that were found.
pub const LEAST_DESCRIBED: f64 = 0.5;
/// Where no more than this share of the samples are lost at the sensor's limit, a decaying swing
/// loses at most a tenth of its first periods. A sinusoid that lost a tenth of its samples at its
/// peaks is still told from its third harmonic: over |sin x| < 0.988 the two correlate by 0.24, over
/// |sin x| < 0.65 by 0.97.
const LOST_AT_LIMIT: f64 = 0.02;
/// A swing is looked for in the rest of a record if it is at least this part.
const LEAST_REST: f64 = 0.25;
/// Zero-g offset and scale of accelerometers in phones (data sheets: ±80 mg, ±3 %) add to this part
/// of gravity at most.
const GRAVITY_TOLERANCE: f64 = 0.1;
/// A unit is named if the size fits it so well.
const UNIT_TOLERANCE: f64 = 0.15;
/// Residual over noise beyond which the noise was not estimated right, or the model is not.
pub const NOISE_MISMATCH: f64 = 1.5;
/// An alternation is real beyond so many standard errors: chance does that once in 10⁸.
const ALTERNATION: f64 = 6.0;
/// Fewest periods that show an alternation.
const FEWEST_PERIODS: usize = 8;

/// When a record is free of its sensor's limit, s: the earliest time after which hardly any samples
/// were lost there; none where it never is. The share lost up to there is told.
pub fn clear_of_limit(groups: &[ChannelGroup], at_limit_s: &[f64]) -> (Option<f64>, f64) {
    let densest = groups.iter().max_by_key(|group| group.t_s.len());
    let (Some(group), false) = (densest, at_limit_s.is_empty()) else {
        return (Some(f64::NEG_INFINITY), 0.0);
    };
    let kept_from = |t: f64| group.t_s.len() - group.t_s.partition_point(|s| *s < t);
    let share = |lost: usize, kept: usize| lost as f64 / (lost + kept).max(1) as f64;
    let whole = share(at_limit_s.len(), group.t_s.len());
    if whole <= LOST_AT_LIMIT {
        return (Some(f64::NEG_INFINITY), whole);
    }
    let clear = (0..at_limit_s.len()).find(|&i| {
        let lost = at_limit_s.len() - i - 1;
        share(lost, kept_from(at_limit_s[i])) <= LOST_AT_LIMIT
    });
    let enough = |t: &f64| kept_from(*t) as f64 >= LEAST_REST * group.t_s.len() as f64;
    (clear.map(|i| at_limit_s[i]).filter(enough), whole)
}

/// Of a phone's recording: `evidence` is what was found in it, where something was.
pub fn of_recording(
    id: &str,
    recording: &Recording,
    evidence: Option<&Evidence>,
    gravity_m_s2: f64,
) -> Vec<Finding> {
    let mut found = constant_channels(recording);
    found.extend(missing_axes(recording));
    found.extend(of_repairs(&recording.repairs));
    if let Some(evidence) = evidence {
        found.extend(at_limit(evidence));
        found.extend(cut_at_gap(evidence));
        found.extend(more_than_half_a_turn(evidence));
        found.extend(gravity(evidence, gravity_m_s2));
        found.extend(too_few_samples(evidence));
        found.extend(not_described(evidence));
        found.extend(of_axes(evidence));
    }
    found.into_iter().map(|one| one.of_swing(id)).collect()
}

pub(super) fn number(value: f64, decimals: u8) -> Argument {
    Argument::Number(value, decimals)
}

fn channels_of(recording: &Recording) -> Vec<(&'static str, &[f64])> {
    let sensors = recording.sensors().into_iter();
    sensors.flat_map(|sensor| sensor.channels).collect()
}

/// What sensors of which axes are missing cannot tell.
fn missing_axes(recording: &Recording) -> Vec<Finding> {
    let sensors = recording.sensors().into_iter();
    let partial = sensors.filter(|one| recording.incomplete.iter().any(|p| p.sensor == one.sensor));
    partial
        .map(|one| {
            let names: Vec<&str> = one.channels.iter().map(|(name, _)| *name).collect();
            let key = match one.sensor {
                Sensor::Gyroscope => "gyroscope_axes",
                _ => "accelerometer_axes",
            };
            let names = names.join(", ");
            let arguments = [("channels", Argument::Plain(names.clone()))];
            Finding::new((Kind::NotIdentifiable, Severity::Warned), key, arguments)
                .of_channel(&names)
                .with("axes", one.channels.len() as f64)
        })
        .collect()
}

fn constant_channels(recording: &Recording) -> Vec<Finding> {
    let is_constant = |samples: &[f64]| samples.windows(2).all(|pair| pair[0] == pair[1]);
    channels_of(recording)
        .into_iter()
        .filter(|(_, samples)| is_constant(samples))
        .map(|(name, samples)| {
            let value = samples.first().copied().unwrap_or_default();
            Finding::new(
                (Kind::ConstantChannel, Severity::Warned),
                "constant_channel",
                [
                    ("channel", Argument::Plain(name.into())),
                    ("value", Argument::Figure(value.to_string())),
                ],
            )
            .of_channel(name)
            .with("value", value)
        })
        .collect()
}

/// Repairs of stamps change what is measured: they are findings too.
fn of_repairs(repairs: &[Repair]) -> Vec<Finding> {
    let finding = |repair: &Repair| {
        let (kind, severity, key) = match repair.kind {
            RepairKind::SharedStamps => (Kind::SharedStamps, Severity::Warned, "shared_stamps"),
            RepairKind::StampStep => (Kind::StampStep, Severity::Warned, "stamp_step"),
            RepairKind::OtherClock => (Kind::StampStep, Severity::Warned, "other_clock"),
            _ => return None,
        };
        let arguments = [("count", number(repair.count as f64, 0))];
        let finding = Finding::new((kind, severity), key, arguments);
        Some(finding.with("samples", repair.count as f64))
    };
    let mut found: Vec<Finding> = Vec::new();
    for one in repairs.iter().filter_map(finding) {
        // Sensors that share their rows share this.
        if !found.contains(&one) {
            found.push(one);
        }
    }
    found
}

fn at_limit(evidence: &Evidence) -> Option<Finding> {
    let lost = evidence.lost_at_limit;
    let percent = number(100.0 * lost, 0);
    if evidence.is_at_limit {
        let refused = (Kind::Saturated, Severity::Refused);
        return Some(
            Finding::new(refused, "saturated", [("percent", percent)]).with("share", lost),
        );
    }
    let from_s = evidence.cut_at_limit_s?;
    let arguments = [("percent", percent), ("from_s", number(from_s, 1))];
    let finding = Finding::new(
        (Kind::Saturated, Severity::Warned),
        "saturated_start",
        arguments,
    );
    Some(finding.with("share", lost).with("from_s", from_s))
}

fn cut_at_gap(evidence: &Evidence) -> Option<Finding> {
    let at_s = evidence.cut_at_gap_s?;
    let warned = (Kind::StampStep, Severity::Warned);
    let (from_s, to_s) = (evidence.span.start_s, evidence.span.end_s);
    let arguments = [
        ("at_s", number(at_s, 1)),
        ("from_s", number(from_s, 1)),
        ("to_s", number(to_s, 1)),
    ];
    Some(Finding::new(warned, "cut_at_gap", arguments).with("at_s", at_s))
}

/// Rotation of a mode by the gyroscope alone, rad.
fn rotation_rad(evidence: &Evidence, mode: usize) -> Option<f64> {
    evidence.turn_rad(evidence.found.modes.get(mode)?)
}

/// Nothing that hangs turns by more than half a turn to either side. Where the samples themselves do
/// not, the damped oscillations that were found are no motions: it swings too far to be their sum.
fn more_than_half_a_turn(evidence: &Evidence) -> Option<Finding> {
    let modes = 0..evidence.found.modes.len();
    let angle = modes
        .filter_map(|mode| rotation_rad(evidence, mode))
        .fold(0.0, f64::max);
    if angle <= PI {
        return None;
    }
    let (channel, seen) = seen_rad(evidence)?;
    let degrees = |angle: f64| number(angle.to_degrees(), 0);
    let (kind, key) = match evidence.single {
        _ if seen <= PI => (Kind::LargeAmplitude, "large_swing"),
        Some(ChannelQuantity::Angle) => (Kind::UnitSuspect, "angle_unit"),
        _ => (Kind::UnitSuspect, "half_a_turn"),
    };
    let found = Finding::new(
        (kind, Severity::Refused),
        key,
        [
            ("channel", Argument::Plain(channel.into())),
            ("angle_deg", degrees(angle)),
            ("seen_deg", degrees(seen)),
            ("in_deg", number(angle, 0)),
        ],
    );
    let found = found.of_channel(channel).with("angle_rad", angle);
    Some(match kind {
        Kind::UnitSuspect => found.with("factor", PI / 180.0),
        _ => found.with("seen_rad", seen),
    })
}

/// How far the samples themselves say that it turns to either side, rad: a rate by the slowest
/// oscillation that was found.
fn seen_rad(evidence: &Evidence) -> Option<(&'static str, f64)> {
    let half_range = |channel: &Vec<f64>| {
        let low = channel.iter().copied().fold(f64::INFINITY, f64::min);
        let high = channel.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        0.5 * (high - low)
    };
    let name = match evidence.single {
        Some(_) => evidence.channels.first().copied()?,
        None if evidence.rates().is_empty() => return None,
        None => "gyroscope",
    };
    let channels = evidence.groups.first()?.channels.iter();
    let range = channels.map(|c| half_range(c).powi(2)).sum::<f64>().sqrt();
    if evidence.single == Some(ChannelQuantity::Angle) {
        return Some((name, range));
    }
    let omegas = evidence.found.modes.iter().map(|mode| mode.omega_rad_s);
    Some((name, range / omegas.fold(f64::INFINITY, f64::min)))
}

/// The size of gravity as the accelerometer has it.
fn gravity(evidence: &Evidence, gravity_m_s2: f64) -> Option<Finding> {
    let ChannelMap {
        accelerometer: Some(first),
        gravity_free: false,
        ..
    } = evidence.map
    else {
        return None;
    };
    let level = |i: usize| evidence.found.level.get(first + i).copied().unwrap_or(0.0);
    let size = Vec3::new(level(0), level(1), level(2)).norm();
    let ratio = size / gravity_m_s2;
    if (ratio - 1.0).abs() <= GRAVITY_TOLERANCE {
        return None;
    }
    let is_near = |unit: &&(&str, f64)| (size * unit.1 / gravity_m_s2).ln().abs() < UNIT_TOLERANCE;
    // What the samples would have to be multiplied by.
    let units = [
        ("g", 9.80665),
        ("mg", 9.80665e-3),
        ("cm/s²", 1e-2),
        ("mm/s²", 1e-3),
    ];
    let size_text = number(size, 2);
    let finding = match units.iter().find(is_near) {
        Some((unit, factor)) => Finding::new(
            (Kind::UnitSuspect, Severity::Refused),
            "gravity_unit",
            [
                ("size", size_text),
                ("unit", Argument::Plain((*unit).into())),
                ("factor", Argument::Figure(factor.to_string())),
            ],
        )
        .with("factor", *factor),
        None => Finding::new(
            (Kind::UnitSuspect, Severity::Warned),
            "gravity_size",
            [("size", size_text), ("expected", number(gravity_m_s2, 2))],
        ),
    };
    Some(finding.of_channel("accelerometer").with("size_m_s2", size))
}

/// The strongest mode may be an alias of a faster one.
fn too_few_samples(evidence: &Evidence) -> Option<Finding> {
    let mode = evidence.found.modes.first()?;
    let sampled = sampled_enough(&evidence.groups, mode)?;
    let (severity, key) = match sampled {
        Sampled::Enough => return None,
        Sampled::Few { .. } => (Severity::Warned, "few_samples"),
        Sampled::TooFew { .. } => (Severity::Refused, "undersampled"),
        Sampled::Alias { .. } => (Severity::Refused, "alias"),
    };
    let (a_period, other_s) = sampled.numbers();
    let arguments = [
        ("period_s", number(mode.period_s(), 3)),
        ("a_period", number(a_period, 1)),
        ("other_s", number(other_s, 3)),
    ];
    let finding = Finding::new((Kind::Undersampled, severity), key, arguments);
    Some(
        finding
            .with("samples_per_period", a_period)
            .with("other_period_s", other_s),
    )
}

/// The oscillations that were found must make up most of what moves, in one sensor at least: else
/// the motion is not among them, and what they say of periods is of something else.
fn not_described(evidence: &Evidence) -> Option<Finding> {
    if evidence.one_motion().is_some() {
        return None;
    }
    let mut first = 0;
    let mut best: Option<f64> = None;
    for group in &evidence.groups {
        let squares = group.channels.iter().map(|c| about_line(&group.t_s, c));
        let (strongest, square) = squares.enumerate().max_by(|a, b| a.1.total_cmp(&b.1))?;
        let channel = first + strongest;
        let noise = evidence.found.noise.get(channel).copied().unwrap_or(0.0);
        first += group.channels.len();
        if noise > 0.0 && square > STANDS_OUT * noise * noise {
            let share = described(evidence, channel, group) / square;
            best = Some(best.map_or(share, |best| best.max(share)));
        }
    }
    let share = best.filter(|share| *share < LEAST_DESCRIBED)?;
    (!evidence.found.modes.is_empty()).then(|| {
        let refused = (Kind::NoiseMismatch, Severity::Refused);
        let percent = number(100.0 * share, 0);
        Finding::new(refused, "not_described", [("percent", percent)]).with("share", share)
    })
}

/// Mean square of a channel about its straight line: a bias that warms is no motion.
fn about_line(t_s: &[f64], channel: &[f64]) -> f64 {
    let count = channel.len().max(1) as f64;
    let mean = |values: &[f64]| values.iter().sum::<f64>() / count;
    let (t, x) = (mean(t_s), mean(channel));
    let pairs = || t_s.iter().zip(channel).map(|(a, b)| (a - t, b - x));
    let squares = pairs().map(|(a, _)| a * a).sum::<f64>();
    let slope = pairs().map(|(a, b)| a * b).sum::<f64>() / squares.max(f64::MIN_POSITIVE);
    pairs().map(|(a, b)| (b - slope * a).powi(2)).sum::<f64>() / count
}

/// Mean square of the oscillations in a channel.
fn described(evidence: &Evidence, channel: usize, group: &ChannelGroup) -> f64 {
    let values = group.t_s.iter().map(|t| oscillation(evidence, channel, *t));
    values.map(|v| v * v).sum::<f64>() / group.t_s.len().max(1) as f64
}

/// The oscillations that were found, in a channel at a time.
fn oscillation(evidence: &Evidence, channel: usize, t_s: f64) -> f64 {
    let of = |mode: &FittedMode| {
        let pole = Complex64::new(-mode.alpha_per_s, mode.omega_rad_s);
        let size = mode.shape.get(channel).copied().unwrap_or_default();
        (size * (pole * (t_s - evidence.found.t_ref_s)).exp()).re
    };
    evidence.found.modes.iter().map(of).sum()
}

/// Of the residual in the end, as the result has it.
pub fn of_residual(swing: &SwingResult) -> Option<Finding> {
    let ratio = swing.rms_over_noise?;
    let key = match ratio {
        r if r > NOISE_MISMATCH => "residual_large",
        r if r < 1.0 / NOISE_MISMATCH => "residual_small",
        _ => return None,
    };
    let finding = Finding::new(
        (Kind::NoiseMismatch, Severity::Warned),
        key,
        [("ratio", number(ratio, 2))],
    );
    Some(finding.of_swing(&swing.id).with("rms_over_noise", ratio))
}

/// A gate off the rest position that writes an entry at each passage lists the two parts of every
/// period: long and short by turns, whatever the swing does.
pub fn of_list(id: &str, list: &PeriodList) -> Vec<Finding> {
    let n = list.period_s.len();
    if n < FEWEST_PERIODS {
        return vec![];
    }
    let Some((by_s, se_s)) = alternation(&list.period_s) else {
        return vec![];
    };
    if by_s.abs() <= ALTERNATION * se_s {
        return vec![];
    }
    let finding = Finding::new(
        (Kind::HalfPeriods, Severity::Refused),
        "half_periods",
        [("by_s", number(2.0 * by_s.abs(), 4))],
    );
    vec![finding.of_swing(id).with("difference_s", 2.0 * by_s.abs())]
}

/// How much entries are long and short by turns about a straight line, with its standard error, s.
fn alternation(period_s: &[f64]) -> Option<(f64, f64)> {
    let n = period_s.len() as f64;
    let row = |i: usize| {
        let sign = if i.is_multiple_of(2) { 1.0 } else { -1.0 };
        nalgebra::Vector3::new(1.0, i as f64 / n - 0.5, sign)
    };
    let rows = || period_s.iter().enumerate().map(|(i, p)| (row(i), *p));
    let normal: nalgebra::Matrix3<f64> = rows().map(|(x, _)| x * x.transpose()).sum();
    let right: nalgebra::Vector3<f64> = rows().map(|(x, p)| x * p).sum();
    let inverse = normal.try_inverse()?;
    let fit = inverse * right;
    let squares: f64 = rows().map(|(x, p)| (p - x.dot(&fit)).powi(2)).sum();
    let resolution = 1e-9 * fit[0].abs();
    let se = (squares / (n - 3.0) * inverse[(2, 2)])
        .sqrt()
        .max(resolution);
    Some((fit[2], se))
}
