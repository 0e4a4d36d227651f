//! What to know before the first swing, as plain data with keys for translation.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::hull::Hull;
use super::means::Means;
use super::optimum::yaw_meets_in_phase_m;
use super::predict::{PredictedSwing, has, scene, swings};
use super::step::{PlannedSwing, Step};
use gyradius_identification::NEAR_IN_PHASE;
use gyradius_mechanics::Fineness;
use gyradius_recording::{Excitation, ModeName};

/// Lines are watched for so many periods of the slowest motion.
const WATCHED_PERIODS: f64 = 4.0;

/// What a warning is about.
#[derive(
    Debug,
    Clone,
    Copy,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Hash,
    Serialize,
    Deserialize,
    schemars::JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum WarningKind {
    /// Yaw has nearly the period of the in-phase pitch (or roll) mode: Kane and Tseng.
    YawNearInPhase,
    /// Yaw and sway keep step: the spacing is twice the gyradius.
    NoBeat,
    /// A line goes slack.
    SlackLine,
    /// ψ asks for a tilt.
    TiltNeeded,
    /// No spacing in reach gives the uncertainty that is wanted with the tape at hand.
    SpacingTooShort,
    /// An uncertainty that is wanted is not reached for another input.
    NotReached,
    /// The swings do not determine a quantity that is wanted.
    NotDetermined,
    /// A figure of the hull is so rough that what hangs on it is too.
    RoughHull,
}

/// One warning.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Warning {
    /// What it is about: the key of its sentence.
    pub kind: WarningKind,
    /// The swing, where it is about one.
    pub swing: Option<String>,
    /// Numbers by name, with their units.
    pub numbers: BTreeMap<String, f64>,
    /// Names in the sentence: a quantity, an input.
    pub names: BTreeMap<String, String>,
    /// In English.
    pub text: String,
}

impl Warning {
    /// A warning with its sentence.
    pub fn new(
        kind: WarningKind,
        swing: Option<&str>,
        numbers: &[(&str, f64)],
        names: &[(&str, &str)],
    ) -> Self {
        let numbers: BTreeMap<String, f64> =
            numbers.iter().map(|(n, v)| ((*n).into(), *v)).collect();
        let names: BTreeMap<String, String> = names
            .iter()
            .map(|(n, v)| ((*n).into(), (*v).into()))
            .collect();
        let bare = Self {
            kind,
            swing: swing.map(Into::into),
            numbers,
            names,
            text: String::new(),
        };
        Self {
            text: bare.message().english,
            ..bare
        }
    }
}

/// What the swings themselves give rise to.
pub fn of_swings(
    hull: &Hull,
    means: &Means,
    steps: &[Step],
    predicted: &[PredictedSwing],
) -> Vec<Warning> {
    let each = || swings(steps).zip(predicted);
    let near = each().filter_map(|(swing, shown)| near_in_phase(hull, swing, shown));
    let no_beat = each().filter_map(|(swing, shown)| no_beat(hull, swing, shown));
    let slack = swings(steps).filter_map(|swing| slack_line(hull, means, swing));
    let tilted = swings(steps).filter_map(|swing| tilt_needed(hull, swing));
    once_each_hanging(near.chain(no_beat))
        .chain(slack)
        .chain(tilted)
        .collect()
}

/// Swings on the same lines have the same to say.
fn once_each_hanging(warnings: impl Iterator<Item = Warning>) -> impl Iterator<Item = Warning> {
    let mut known: Vec<Warning> = Vec::new();
    for warning in warnings {
        if known
            .iter()
            .all(|k| (k.kind, &k.numbers) != (warning.kind, &warning.numbers))
        {
            known.push(warning);
        }
    }
    known.into_iter()
}

/// Relative distance of the yaw period from that of the in-phase mode.
pub fn from_in_phase(periods_s: &BTreeMap<ModeName, f64>) -> Option<f64> {
    let yaw = *periods_s.get(&ModeName::Yaw)?;
    let slow = periods_s
        .get(&ModeName::PitchInPhase)
        .or_else(|| periods_s.get(&ModeName::RollInPhase))?;
    Some(yaw / slow - 1.0)
}

fn near_in_phase(hull: &Hull, swing: &PlannedSwing, shown: &PredictedSwing) -> Option<Warning> {
    if !has(swing, &[Excitation::Yaw]) {
        return None;
    }
    let apart = from_in_phase(&shown.periods_s).filter(|apart| apart.abs() < NEAR_IN_PHASE)?;
    let yaw = *shown.periods_s.get(&ModeName::Yaw)?;
    let d = 0.5 * swing.suspension.spacing_m?.value;
    let meets = yaw_meets_in_phase_m(
        d,
        hull.k_yaw_m.value,
        hull.k_pitch_m.value,
        hull.cm_depth_m.value,
    );
    let numbers = [
        ("yaw_period_s", yaw),
        ("in_phase_period_s", yaw / (1.0 + apart)),
        ("apart_percent", 100.0 * apart.abs()),
        ("meeting_line_length_m", meets.unwrap_or(f64::NAN)),
    ];
    let told = numbers
        .iter()
        .copied()
        .filter(|(_, v)| v.is_finite())
        .collect::<Vec<_>>();
    Some(Warning::new(
        WarningKind::YawNearInPhase,
        Some(&swing.id),
        &told,
        &[],
    ))
}

fn no_beat(hull: &Hull, swing: &PlannedSwing, shown: &PredictedSwing) -> Option<Warning> {
    let beat = shown.beat.as_ref()?;
    // A beat that a recording does not hold cannot be counted.
    if beat
        .period_s
        .is_some_and(|period_s| period_s < swing.duration_s)
    {
        return None;
    }
    let mut numbers = vec![
        ("spacing_m", swing.suspension.spacing_m?.value),
        ("twice_k_yaw_m", 2.0 * hull.k_yaw_m.value),
        ("duration_s", swing.duration_s),
    ];
    numbers.extend(beat.period_s.map(|period_s| ("beat_period_s", period_s)));
    Some(Warning::new(
        WarningKind::NoBeat,
        Some(&swing.id),
        &numbers,
        &[],
    ))
}

fn slack_line(hull: &Hull, means: &Means, swing: &PlannedSwing) -> Option<Warning> {
    let t_s = slack_s(hull, means, swing)?;
    // Leaning by θ along the suspension, the lines pull as d + l2 tan θ to d − l2 tan θ: moments
    // about the centre of mass.
    let half_spacing_m = swing.suspension.spacing_m.map_or(0.0, |q| 0.5 * q.value);
    let lean_deg = (half_spacing_m / hull.cm_depth_m.value).atan().to_degrees();
    let numbers = [
        ("amplitude_deg", swing.amplitude_deg),
        ("t_s", t_s),
        ("most_lean_deg", lean_deg),
    ];
    Some(Warning::new(
        WarningKind::SlackLine,
        Some(&swing.id),
        &numbers,
        &[],
    ))
}

/// When the tension of a line first vanishes, s, by the full motion; 0 where the release itself
/// leaves one slack or cannot be made on lines that are straight.
pub fn slack_s(hull: &Hull, means: &Means, swing: &PlannedSwing) -> Option<f64> {
    let scene = scene(hull, means, swing).ok()?;
    let slowest_s = swing.periods_s.values().copied().fold(1.0, f64::max);
    let watched_s = (WATCHED_PERIODS * slowest_s).min(swing.duration_s);
    match scene.motion_as(Fineness::OF_FITS, watched_s) {
        Ok(path) => path.slack.map(|slack| slack.t_s),
        Err(_) => Some(0.0),
    }
}

fn tilt_needed(hull: &Hull, swing: &PlannedSwing) -> Option<Warning> {
    let hung = &swing.suspension;
    let moved_m = hung.points_moved_m?.value;
    // The corners of the frame lie half of its side from the middle: Table 4, A-G and C-E.
    let corner_deg = (0.5 * hung.spacing_m?.value / hull.cm_depth_m.value)
        .atan()
        .to_degrees();
    let numbers = [
        ("tilt_deg", hung.hull_pitch_deg?.value),
        ("points_moved_m", moved_m),
        ("corner_tilt_deg", corner_deg),
    ];
    Some(Warning::new(
        WarningKind::TiltNeeded,
        Some(&swing.id),
        &numbers,
        &[],
    ))
}
