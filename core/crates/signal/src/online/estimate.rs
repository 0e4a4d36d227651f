//! What is known at a moment, and the advice that follows from it.

use serde::{Deserialize, Serialize};

use super::advice::Advice;
use super::gaps::GapList;
use super::state::{SensorState, SwingState, TimeLeft};

/// A motion beside the main one from this share on is worth another release.
const UNWANTED_SHARE: f64 = 0.05;
/// Below this amplitude friction and currents of air show more than inertia, degrees.
const LOW_AMPLITUDE_DEG: f64 = 2.0;
/// A sensor whose newest stamp is this far behind the other's has fallen silent, s.
const SILENT_AFTER_S: f64 = 1.0;

/// Everything that is known at a moment.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Estimate {
    /// The newest stamp of all sensors, s; 0 before the first sample.
    pub now_s: f64,
    /// What each sensor does: gyroscope, accelerometer.
    pub sensors: Vec<SensorState>,
    /// Every gap of theirs.
    pub gaps: GapList,
    /// The swing, once there is one to speak of.
    pub swing: Option<SwingState>,
    /// What the operator should know or do, most urgent first.
    pub advice: Vec<Advice>,
}

/// What follows from an estimate whose other fields stand; `known` is what was found beside it.
pub(super) fn advise(estimate: &Estimate, known: Vec<Advice>) -> Vec<Advice> {
    let mut advice: Vec<Advice> = estimate
        .sensors
        .iter()
        .filter_map(|s| silent(s, estimate.now_s))
        .collect();
    advice.extend(known);
    advice.extend(
        estimate
            .sensors
            .iter()
            .flat_map(|sensor| limits(sensor).into_iter().flatten()),
    );
    if let Some(swing) = &estimate.swing {
        advice.extend(of_swing(swing));
    }
    advice
}

fn silent(sensor: &SensorState, now_s: f64) -> Option<Advice> {
    let is_silent = now_s - sensor.last_s.unwrap_or(0.0) > SILENT_AFTER_S;
    is_silent.then_some(Advice::SensorSilent {
        sensor: sensor.sensor,
        since_s: sensor.last_s,
    })
}

fn limits(state: &SensorState) -> [Option<Advice>; 2] {
    let SensorState {
        sensor,
        saturated,
        gaps,
        longest_gap_s,
        ..
    } = *state;
    [
        (saturated > 0).then_some(Advice::Saturated {
            sensor,
            samples: saturated,
        }),
        (gaps > 0).then_some(Advice::Gaps {
            sensor,
            gaps,
            longest_s: longest_gap_s,
        }),
    ]
}

fn of_swing(swing: &SwingState) -> Vec<Advice> {
    let low = swing
        .amplitude_deg
        .filter(|amplitude_deg| *amplitude_deg < LOW_AMPLITUDE_DEG);
    let mut advice: Vec<Advice> = low
        .map(|amplitude_deg| Advice::AmplitudeLow { amplitude_deg })
        .into_iter()
        .collect();
    let unwanted = swing
        .lines
        .iter()
        .filter(|line| line.share >= UNWANTED_SHARE);
    advice.extend(unwanted.map(|line| Advice::Unwanted {
        kind: line.kind,
        share: line.share,
        period_s: line.period_s,
    }));
    match swing.time_left {
        TimeLeft::Reached => advice.push(Advice::LongEnough),
        TimeLeft::OutOfReach => advice.push(Advice::OutOfReach),
        TimeLeft::Seconds(_) => {}
    }
    advice
}
