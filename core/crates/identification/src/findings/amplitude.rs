//! Whether the motion itself agrees with the amplitude that the sensor gives it.

use std::f64::consts::{PI, TAU};

use gyradius_recording::ModeName;
use gyradius_signal::growth_with_square;
use num_complex::Complex64;

use super::recording::{number, oscillation};
use super::{Finding, FindingKind as Kind, Severity};
use crate::measure::windows;
use crate::observe::Evidence;

/// Half of what gravity makes of an amplitude: no spring or drag that leaves a swing to measure takes
/// more of it.
const LEAST_SHARE: f64 = 0.5;
/// As much more than gravity makes of it.
const MOST_SHARE: f64 = 1.5;
/// Nobody swings a body by less to measure it, degrees; read as rad, 11°.
const LEAST_SWING_DEG: f64 = 0.2;
/// So many standard errors are sure: chance does that once in 10⁶.
const SURE: f64 = 5.0;
/// What is faster than this share of half the rate, a filter may have taken.
const MOST_OF_NYQUIST: f64 = 0.6;

/// What a swing's period does with its amplitude, and its motion with its angle.
pub fn of_amplitude(id: &str, evidence: &Evidence) -> Option<Finding> {
    too_harmonic(id, evidence).or_else(|| against_law(id, evidence))
}

/// On a fixed axis the law is known: the period grows by A²/16 of itself. Where it surely does
/// otherwise, and by more than it is uncertain, the figures are not those of small swings.
fn against_law(id: &str, evidence: &Evidence) -> Option<Finding> {
    let compound = evidence
        .named
        .iter()
        .position(|n| n.name == ModeName::Compound)?;
    let mode = &evidence.found.modes[compound];
    let angle = evidence.named[compound].angle_rad?;
    let (growth, u) = growth_with_square(&windows(evidence, compound))?;
    let law = angle * angle / 16.0;
    let is_law = growth + SURE * u > LEAST_SHARE * law && growth - SURE * u < MOST_SHARE * law;
    let matters = (growth - law).abs() * mode.period_s() > SURE * mode.period_se_s();
    (!is_law && matters).then(|| {
        let arguments = [
            ("percent", number(100.0 * growth, 2)),
            ("law_percent", number(100.0 * law, 2)),
            ("angle_deg", number(angle.to_degrees(), 0)),
        ];
        let warned = (Kind::NoiseMismatch, Severity::Warned);
        let found = Finding::new(warned, "against_law", arguments).of_swing(id);
        found.with("growth", growth).with("expected", law)
    })
}

/// Of a swing on lines or on an axis, which gravity alone brings back. Its force goes with the sine
/// of the angle, A − A³/6: the period grows by A²/16 of itself, and the rate has A²/64 of itself at
/// three times the frequency (Duffing's equation to first order); of yaw on two or three lines both
/// are up to twice that. Where one of the two is surely less than half of it, and the other does not
/// surely show, the amplitude is not what the gyroscope says.
fn too_harmonic(id: &str, evidence: &Evidence) -> Option<Finding> {
    let swings = |name: ModeName| matches!(name, ModeName::Yaw | ModeName::Compound);
    let named = evidence.named.iter().zip(&evidence.found.modes).enumerate();
    let (strongest, (named, mode)) = named
        .filter(|(_, (named, _))| swings(named.name))
        .max_by(|a, b| a.1.1.snr_db.total_cmp(&b.1.1.snr_db))?;
    let swung = LEAST_SWING_DEG..=PI;
    let angle = named.angle_rad.filter(|angle| swung.contains(angle))?;
    let square = angle * angle;
    let growth = growth_with_square(&windows(evidence, strongest));
    let third = third_harmonic(evidence, strongest);
    let shares = [
        growth.map(|(growth, u)| [growth, u].map(|part| 16.0 * part / square)),
        third.map(|(third, u)| [third, u].map(|part| 64.0 * part / square)),
    ];
    let known = || shares.iter().flatten();
    let is_absent = |[share, u]: &[f64; 2]| share + SURE * u < LEAST_SHARE;
    let is_there = |[share, u]: &[f64; 2]| share - SURE * u > LEAST_SHARE;
    (known().any(is_absent) && !known().any(is_there)).then(|| {
        let refused = (Kind::UnitSuspect, Severity::Refused);
        let arguments = [
            ("angle_deg", number(angle.to_degrees(), 0)),
            ("in_deg", number(angle, 1)),
            ("period_s", number(mode.period_s(), 3)),
        ];
        let found = Finding::new(refused, "too_harmonic", arguments).of_channel("gyroscope");
        let found = found.with("angle_rad", angle).with("factor", PI / 180.0);
        found.of_swing(id)
    })
}

/// What a record of rates holds at three times a mode's frequency, as a share of the mode, with its
/// standard error: by the channel that shows the mode best, in a window that sees no neighbour.
fn third_harmonic(evidence: &Evidence, mode: usize) -> Option<(f64, f64)> {
    let group = evidence.groups.first()?;
    let mode = &evidence.found.modes[mode];
    let size = |c: &usize| mode.shape.get(*c).map_or(0.0, |shape| shape.norm());
    let channel = evidence
        .rates()
        .max_by(|a, b| size(a).total_cmp(&size(b)))?;
    let (begin, end) = (*group.t_s.first()?, *group.t_s.last()?);
    let omega = 3.0 * mode.omega_rad_s;
    let rate = group.t_s.len() as f64 / (end - begin);
    if omega > MOST_OF_NYQUIST * PI * rate {
        return None;
    }
    let (mut sum, mut squares, mut envelope) = (Complex64::default(), 0.0, 0.0);
    for (t, value) in group.t_s.iter().zip(group.channels.get(channel)?) {
        let rest = value - oscillation(evidence, channel, *t) - evidence.found.level[channel];
        let weight = 1.0 - (TAU * (t - begin) / (end - begin)).cos();
        sum += weight * rest * Complex64::from_polar(1.0, -omega * t);
        squares += weight * weight;
        envelope += weight * (-mode.alpha_per_s * (t - evidence.found.t_ref_s)).exp();
    }
    let own = size(&channel) * envelope;
    let noise = evidence.found.noise.get(channel)?;
    (own > 0.0).then(|| (2.0 * sum.norm() / own, noise * (2.0 * squares).sqrt() / own))
}
