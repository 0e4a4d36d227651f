//! What each oscillation is, from its shape.
//!
//! # Conventions
//! Sizes of motions are angles, so that they compare: a rotation by its own angle, a translation by
//! the angle of the lines, |a| / g (a pendulum of any length is accelerated by g times its angle).

use serde::{Deserialize, Serialize};

use super::motion::PhoneMotion;
use gyradius_base::frames::Vec3;
use gyradius_recording::{ModeName, Orientation, Suspension, SuspensionKind};

/// A translation whose rotation is below this share of its line angle is a sway. A sway of a level
/// hull does not rotate at all; the double-pendulum modes turn by at least 1/(R² − 1) of the line
/// angle (ratio of the two angles from eq. 16: φ2/φ1 = (g/ω² − l1)/l2), which is above 0.25 for R <
/// 2.2.
const SWAY_ROTATION_SHARE: f64 = 0.12;

/// A mode must stand this many standard errors out of the noise before its shape is believed.
const SHAPE_SIGMA: f64 = 5.0;

/// A driven line is smaller than either of its drivers by at least this.
const DRIVER_RATIO: f64 = 3.0;
/// How near a line must be to a combination: amplitudes move frequencies by up to a percent.
const COMBINATION_TOLERANCE: f64 = 0.012;

/// What is known of the hanging when modes are named; all absent for a bare recording.
#[derive(Debug, Clone, Copy, Default)]
pub struct Hanging {
    /// Bifilar or compound, and which way.
    pub suspension: Option<(SuspensionKind, Orientation)>,
    /// Period of the simple pendulum of the lines' length, s (eq. 7).
    pub sway_period_s: Option<f64>,
}

impl Hanging {
    /// From a stated suspension.
    pub fn of(suspension: &Suspension, gravity_m_s2: f64) -> Self {
        let sway_period_s = suspension
            .line_length_m
            .filter(|_| suspension.kind != SuspensionKind::Compound);
        let is_stated = suspension.kind != SuspensionKind::Free;
        Hanging {
            suspension: is_stated.then_some((suspension.kind, suspension.orientation)),
            // eq. (7)
            sway_period_s: sway_period_s
                .map(|l| std::f64::consts::TAU * (l.value / gravity_m_s2).sqrt()),
        }
    }
}

/// A mode's name with the angle that measures its size.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct NamedMode {
    /// Name by shape.
    pub name: ModeName,
    /// Size, rad (see the module's conventions); absent where the sensors do not give it.
    pub angle_rad: Option<f64>,
}

/// Names the modes of one record.
///
/// Every name but `other` is given at most once, to the largest motion that claims it.
pub fn name_modes(
    motions: &[PhoneMotion],
    up: Option<Vec3>,
    gravity_m_s2: f64,
    hanging: &Hanging,
) -> Vec<NamedMode> {
    let Some(up) = up else {
        return motions
            .iter()
            .map(|m| NamedMode {
                name: ModeName::Other,
                angle_rad: rotation(m),
            })
            .collect();
    };
    let mut named: Vec<NamedMode> = motions
        .iter()
        .map(|m| by_shape(m, &up, gravity_m_s2, hanging))
        .collect();
    unname_combinations(&mut named, motions);
    if hanging.sway_period_s.is_none() {
        order_double_pendulum(&mut named, motions);
    }
    keep_largest_of_each(&mut named);
    named
}

/// A weak line at a sum, difference or multiple of stronger modes' frequencies is their doing (a
/// yaw and a sway push the pitch at ω_yaw ± ω_sway), whatever its shape.
fn unname_combinations(named: &mut [NamedMode], motions: &[PhoneMotion]) {
    let size: Vec<f64> = named.iter().map(|n| n.angle_rad.unwrap_or(0.0)).collect();
    for i in 0..named.len() {
        let stronger: Vec<f64> = (0..named.len())
            .filter(|j| size[*j] > DRIVER_RATIO * size[i])
            .map(|j| motions[j].omega_rad_s)
            .collect();
        if stronger.iter().any(|a| {
            stronger
                .iter()
                .any(|b| is_combination(motions[i].omega_rad_s, *a, *b))
        }) {
            named[i].name = ModeName::Other;
        }
    }
}

fn is_combination(omega: f64, a: f64, b: f64) -> bool {
    let near = |line: f64| (line.abs() / omega - 1.0).abs() < COMBINATION_TOLERANCE;
    [a + b, a - b, 2.0 * a + b, 2.0 * a - b]
        .into_iter()
        .filter(|line| *line != a)
        .any(near)
}

fn rotation(motion: &PhoneMotion) -> Option<f64> {
    motion
        .rotation_rad
        .map(|theta| theta.iter().map(|c| c.norm_sqr()).sum::<f64>().sqrt())
}

fn by_shape(motion: &PhoneMotion, up: &Vec3, gravity_m_s2: f64, hanging: &Hanging) -> NamedMode {
    let (turn_vertical, turn_level) = motion.rotation_split(up).unwrap_or((0.0, 0.0));
    let (lift, push) = motion.acceleration_split(up).unwrap_or((0.0, 0.0));
    let turn = turn_vertical.hypot(turn_level);
    let line_angle = push / gravity_m_s2;
    let turn_seen = turn > SHAPE_SIGMA * motion.rotation_se_rad && motion.rotation_rad.is_some();
    let push_seen = push > SHAPE_SIGMA * motion.acceleration_se_m_s2;
    let turns = turn_seen && turn > SWAY_ROTATION_SHARE * line_angle;
    let name = if turns && turn_vertical > turn_level {
        ModeName::Yaw
    } else if turns {
        level_axis_name(motion.omega_rad_s, hanging)
    } else if push_seen && lift < push && motion.rotation_rad.is_some() {
        ModeName::Sway
    } else {
        ModeName::Other
    };
    let angle = match name {
        ModeName::Yaw => turn_vertical,
        ModeName::Sway => line_angle,
        ModeName::Other => turn.max(line_angle),
        _ => turn_level,
    };
    NamedMode {
        name,
        angle_rad: Some(angle),
    }
}

/// A turn about a level axis. In (17) both factors are positive, so T_out < T_s < T_in whatever the
/// hull.
fn level_axis_name(omega_rad_s: f64, hanging: &Hanging) -> ModeName {
    let period_s = std::f64::consts::TAU / omega_rad_s;
    let in_phase = hanging.sway_period_s.is_none_or(|sway| period_s > sway);
    match (hanging.suspension, in_phase) {
        (Some((SuspensionKind::Compound, _)), _) => ModeName::Compound,
        (Some((SuspensionKind::Trifilar, _)), _) => ModeName::Other,
        (Some((_, Orientation::ForeAndAft)), true) => ModeName::RollInPhase,
        (Some((_, Orientation::ForeAndAft)), false) => ModeName::RollOutOfPhase,
        (_, true) => ModeName::PitchInPhase,
        (_, false) => ModeName::PitchOutOfPhase,
    }
}

/// Without the lines' length: of two double-pendulum modes the short one is the out-of-phase one; a
/// single one beside a sway is judged against the sway's period; a single one alone stays unnamed.
fn order_double_pendulum(named: &mut [NamedMode], motions: &[PhoneMotion]) {
    let is_level =
        |n: &NamedMode| matches!(n.name, ModeName::PitchInPhase | ModeName::PitchOutOfPhase);
    let sway = named
        .iter()
        .position(|n| n.name == ModeName::Sway)
        .map(|i| motions[i].omega_rad_s);
    let mut level: Vec<usize> = (0..named.len()).filter(|i| is_level(&named[*i])).collect();
    level.sort_by(|a, b| motions[*a].omega_rad_s.total_cmp(&motions[*b].omega_rad_s));
    match (level.as_slice(), sway) {
        ([only], Some(sway)) if motions[*only].omega_rad_s > sway => {
            named[*only].name = ModeName::PitchOutOfPhase
        }
        ([_], Some(_)) => {}
        ([slow, fast], _) => {
            named[*slow].name = ModeName::PitchInPhase;
            named[*fast].name = ModeName::PitchOutOfPhase;
        }
        (many, _) => many.iter().for_each(|i| named[*i].name = ModeName::Other),
    }
}

fn keep_largest_of_each(named: &mut [NamedMode]) {
    let size = |n: &NamedMode| n.angle_rad.unwrap_or(0.0);
    for i in 0..named.len() {
        let outdone = (0..named.len()).any(|j| {
            named[j].name == named[i].name
                && (size(&named[j]) > size(&named[i])
                    || (size(&named[j]) == size(&named[i]) && j < i))
        });
        if outdone {
            named[i].name = ModeName::Other;
        }
    }
}
