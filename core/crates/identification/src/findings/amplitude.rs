//! Whether the motion itself agrees with the amplitude that the sensor gives it.

use std::f64::consts::PI;

use gyradius_recording::{ChannelQuantity, ModeName};

use super::recording::number;
use super::{Finding, FindingKind as Kind, Severity};
use crate::chance::SURE;
use crate::observe::Evidence;
use crate::one_motion::{OneMotion, PENDULUM};

/// Half of what gravity makes of an amplitude: no spring or drag that leaves a swing to measure takes
/// more of it, or adds more.
const SHARE: f64 = 0.5;
/// Nobody swings a body by less to measure it, degrees: read as rad it would be 11°.
const LEAST_SWING_DEG: f64 = 0.2;

/// What a period does with the amplitude, where it grows by κ A²/16 of itself by the law of its
/// suspension.
pub fn of_amplitude(
    id: &str,
    evidence: &Evidence,
    (name, law): (ModeName, f64),
) -> Option<Finding> {
    let motion = evidence.motion.as_ref()?;
    let place = if motion.is_described {
        0
    } else {
        motion.mode()
    };
    if evidence.named.get(place)?.name != name {
        return None;
    }
    let found = match evidence.single {
        Some(ChannelQuantity::Angle) => None,
        _ => too_harmonic(motion, law).filter(|_| motion.is_described),
    };
    let found = found.or_else(|| against_law(motion, law))?;
    Some(found.of_swing(id))
}

/// κ is surely no less and no more than this.
fn bounds(motion: &OneMotion) -> [f64; 2] {
    let (value, u) = (motion.hardness.value, SURE * motion.hardness.u);
    [value - u, value + u]
}

/// Where the period surely does otherwise than the law, and by more than it is uncertain, something
/// else than gravity is at work.
fn against_law(motion: &OneMotion, law: f64) -> Option<Finding> {
    let [least, most] = bounds(motion);
    let within = SHARE * law.abs().max(PENDULUM);
    let is_law = most > law - within && least < law + within;
    // By what part of itself the period is longer at the first amplitude than at none.
    let [growth, law] =
        [motion.hardness.value, law].map(|kappa| kappa * motion.amplitude_rad.powi(2) / 16.0);
    let matters = (growth - law).abs() * motion.period_s.value > SURE * motion.period_s.u;
    (!is_law && matters).then(|| {
        let arguments = [
            ("percent", number(100.0 * growth, 2)),
            ("law_percent", number(100.0 * law, 2)),
            ("angle_deg", number(motion.amplitude_rad.to_degrees(), 0)),
        ];
        let warned = (Kind::NoiseMismatch, Severity::Warned);
        let found = Finding::new(warned, "against_law", arguments);
        found.with("growth", growth).with("expected", law)
    })
}

/// Where the period surely grows by less than half of that, as little as a spring's, the amplitude is
/// not what the gyroscope says.
fn too_harmonic(motion: &OneMotion, law: f64) -> Option<Finding> {
    let angle = motion.amplitude_rad;
    let is_swing = (LEAST_SWING_DEG..=PI).contains(&angle);
    let [least, most] = bounds(motion);
    let is_spring = most < SHARE * law && least > -SHARE * law;
    (is_swing && is_spring).then(|| {
        let refused = (Kind::UnitSuspect, Severity::Refused);
        let arguments = [
            ("angle_deg", number(angle.to_degrees(), 0)),
            ("in_deg", number(angle, 1)),
        ];
        let found = Finding::new(refused, "too_harmonic", arguments).of_channel("gyroscope");
        found.with("angle_rad", angle).with("factor", PI / 180.0)
    })
}
