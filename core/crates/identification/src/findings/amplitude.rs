//! Whether the motion itself agrees with the amplitude that the sensor gives it.

use std::f64::consts::PI;

use gyradius_recording::{ChannelQuantity, ModeName};
use gyradius_signal::{FittedMode, WindowPoint, growth_with_square};

use super::recording::number;
use super::{Finding, FindingKind as Kind, Severity};
use crate::measurement::{AmplitudePoint, SwingResult};
use crate::modes::NamedMode;
use crate::observe::Evidence;

/// Half of what gravity makes of an amplitude: no spring or drag that leaves a swing to measure takes
/// more of it.
const LEAST_SHARE: f64 = 0.5;
/// As much more than gravity makes of it.
const MOST_SHARE: f64 = 1.5;
/// Nobody swings a body by less to measure it, degrees: read as rad it would be 11°.
const LEAST_SWING_DEG: f64 = 0.2;
/// So many standard errors are sure: chance does that once in 10⁶.
const SURE: f64 = 5.0;

/// What a period does with the amplitude: on a fixed axis, where gravity alone brings it back, the
/// period grows by A²/16 of itself.
pub fn of_amplitude(swing: &SwingResult, evidence: &Evidence) -> Option<Finding> {
    let (mode, growth) = growth(swing, evidence)?;
    let found = match evidence.single {
        Some(ChannelQuantity::Angle) => None,
        _ => too_harmonic(&growth),
    };
    let found = found.or_else(|| against_law(mode, &growth))?;
    Some(found.of_swing(&swing.id))
}

/// Where the period surely does otherwise than the law, and by more than it is uncertain, the figures
/// are not those of small swings.
fn against_law(mode: &FittedMode, growth: &Growth) -> Option<Finding> {
    let law = growth.law();
    let is_law = growth.most() > LEAST_SHARE * law && growth.least() < MOST_SHARE * law;
    let matters = (growth.value - law).abs() * mode.period_s() > SURE * mode.period_se_s();
    (!is_law && matters).then(|| {
        let arguments = [
            ("percent", number(100.0 * growth.value, 2)),
            ("law_percent", number(100.0 * law, 2)),
            ("angle_deg", number(growth.angle.to_degrees(), 0)),
        ];
        let warned = (Kind::NoiseMismatch, Severity::Warned);
        let found = Finding::new(warned, "against_law", arguments);
        found.with("growth", growth.value).with("expected", law)
    })
}

/// By what part of itself a period is longer at the first amplitude than at none.
struct Growth {
    value: f64,
    u: f64,
    /// The first amplitude, rad.
    angle: f64,
}

impl Growth {
    /// On a fixed axis, A²/16.
    fn law(&self) -> f64 {
        self.angle * self.angle / 16.0
    }

    fn most(&self) -> f64 {
        self.value + SURE * self.u
    }

    fn least(&self) -> f64 {
        self.value - SURE * self.u
    }
}

/// The growth of a compound pendulum's period, where the whole turn is seen.
fn growth<'a>(swing: &SwingResult, evidence: &'a Evidence) -> Option<(&'a FittedMode, Growth)> {
    let is_whole = evidence.map.gyroscope.is_some() || evidence.single.is_some();
    let compound = |named: &NamedMode| named.name == ModeName::Compound;
    let modes = &evidence.named;
    let place = modes.iter().position(compound).filter(|_| is_whole)?;
    let angle = modes[place].angle_rad?;
    let windows = &swing.modes.get(place)?.against_amplitude;
    let windows: Vec<WindowPoint> = windows.iter().map(WindowPoint::from).collect();
    let (value, u) = growth_with_square(&windows)?;
    let [value, u] = [value, u].map(|by_square| by_square * angle * angle);
    let mode = evidence.found.modes.get(place)?;
    Some((mode, Growth { value, u, angle }))
}

impl From<&AmplitudePoint> for WindowPoint {
    fn from(point: &AmplitudePoint) -> Self {
        Self {
            t_s: point.t_s,
            amplitude: point.amplitude,
            period_s: point.period_s,
            period_se_s: point.period_se_s,
            decrement: point.decrement,
            decrement_se: point.decrement_se,
        }
    }
}

/// Where the period surely grows by less than half of that, the amplitude is not what the gyroscope
/// says.
fn too_harmonic(growth: &Growth) -> Option<Finding> {
    let angle = growth.angle;
    let is_swing = (LEAST_SWING_DEG..=PI).contains(&angle);
    (is_swing && growth.most() < LEAST_SHARE * growth.law()).then(|| {
        let refused = (Kind::UnitSuspect, Severity::Refused);
        let arguments = [
            ("angle_deg", number(angle.to_degrees(), 0)),
            ("in_deg", number(angle, 1)),
        ];
        let found = Finding::new(refused, "too_harmonic", arguments).of_channel("gyroscope");
        found.with("angle_rad", angle).with("factor", PI / 180.0)
    })
}
