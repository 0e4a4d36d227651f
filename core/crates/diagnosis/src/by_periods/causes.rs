//! What may make a session's periods contradict its dimensions, and what each cause does to small
//! oscillations.

use gyradius_base::frames::Vec3;
use gyradius_mechanics::{Rig, RigidBody, SmallEffects};

use crate::cause_id::CauseId;
use crate::parameter_id::ParameterName;
use crate::unit::UnitName;

/// Sizes of a session that causes are measured by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scales {
    /// Everything that hangs, added masses excluded, kg; 1 where no mass was stated.
    pub mass_kg: f64,
    /// Whether a mass was stated.
    pub mass_is_known: bool,
    /// m/s².
    pub gravity_m_s2: f64,
    /// Mean length of the lines, m.
    pub length_m: f64,
    /// Mean distance of the lines, m.
    pub spacing_m: f64,
    /// Yaw gyradius, m.
    pub k_yaw_m: f64,
}

impl Scales {
    /// Mean stiffness of the yaw, M g d²/l, N m/rad.
    fn yaw_stiffness_n_m(&self) -> f64 {
        self.mass_kg * self.gravity_m_s2 * (0.5 * self.spacing_m).powi(2) / self.length_m
    }

    /// Stiffness of the sway, M g/l, N/m.
    fn sway_stiffness_n_m(&self) -> f64 {
        self.mass_kg * self.gravity_m_s2 / self.length_m
    }
}

/// How wide a swing was, rad; 0 where nobody said.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Amplitudes {
    /// Of the yaw.
    pub yaw_rad: f64,
    /// Of the lines in sway.
    pub sway_rad: f64,
}

/// A swing as it hangs, for causes to change.
#[derive(Debug, Clone, Copy)]
pub struct Hung<'a> {
    /// The lines and gravity.
    pub rig: Rig,
    /// The body.
    pub body: RigidBody,
    /// What else acts.
    pub effects: SmallEffects,
    /// Relative error of all periods.
    pub clock_error: f64,
    /// Direction of the suspension, horizontal.
    pub axis: Vec3,
    /// How wide it swings.
    pub amplitudes: Amplitudes,
    /// Sizes of the session.
    pub scales: &'a Scales,
}

/// A number of a cause.
#[derive(Debug, Clone, Copy)]
pub struct CauseNumber {
    /// Name, as the effect of that name in rig files has it.
    pub name: ParameterName,
    /// Its unit.
    pub unit: UnitName,
    /// Whether it is in proportion to the mass.
    pub by_mass: bool,
    /// Standard deviation of what is believed of it beforehand, about zero: wide, but no wider than
    /// things are.
    pub width: fn(&Scales) -> f64,
    /// Whether only positive values make sense: then the belief is the positive half.
    pub positive: bool,
    /// How it is shown.
    pub shown: Shown,
}

/// From a cause's inner number to that of rig files.
#[derive(Debug, Clone, Copy)]
pub enum Shown {
    /// Times a factor.
    Times(fn(&Scales) -> f64),
    /// A factor over it.
    Over(fn(&Scales) -> f64),
    /// Its size: periods do not tell its sign.
    Size,
}

/// A cause.
#[derive(Debug, Clone, Copy)]
pub struct Cause {
    /// Its name in the contract.
    pub id: CauseId,
    /// Its numbers.
    pub numbers: &'static [CauseNumber],
    /// Puts it on a swing.
    pub put: fn(&[f64], &mut Hung),
}

/// A tape that is read, held or tied wrong errs by a few per cent; so do the other things that are
/// left out.
const WRONG: f64 = 0.02;

fn as_is(_: &Scales) -> f64 {
    1.0
}

fn of_length(scales: &Scales) -> f64 {
    WRONG * scales.length_m
}

fn of_spacing(scales: &Scales) -> f64 {
    WRONG * scales.spacing_m
}

fn share(_: &Scales) -> f64 {
    WRONG
}

const METRES: CauseNumber = CauseNumber {
    name: ParameterName::ExcessM,
    unit: UnitName::Metre,
    by_mass: false,
    width: of_length,
    positive: false,
    shown: Shown::Times(as_is),
};

const SHARE: CauseNumber = CauseNumber {
    width: share,
    positive: true,
    ..METRES
};

/// Compliances are counted as the share by which sway seems to hang on longer lines: M g/(k l).
const COMPLIANCE: CauseNumber = CauseNumber {
    unit: UnitName::NewtonPerMetre,
    by_mass: true,
    shown: Shown::Over(Scales::sway_stiffness_n_m),
    ..SHARE
};

/// Share of the inertia that each radian of amplitude adds; that of the flying machine on two lines
/// that swung in still air was some 0.2.
fn share_by_radian(_: &Scales) -> f64 {
    0.5
}

fn side(i: usize) -> f64 {
    if i == 0 { -1.0 } else { 1.0 }
}

/// Every cause that periods can show.
pub const CAUSES: [Cause; 12] = [
    Cause {
        id: CauseId::StatedLength,
        numbers: &[METRES],
        put: |p, hung| {
            hung.rig
                .lines
                .iter_mut()
                .for_each(|line| line.length_m += p[0])
        },
    },
    Cause {
        id: CauseId::LineStretch,
        numbers: &[CauseNumber {
            name: ParameterName::ForcePerStrainN,
            unit: UnitName::Newton,
            by_mass: true,
            // Each of the two lines bears half of the weight.
            shown: Shown::Over(|s| 0.5 * s.mass_kg * s.gravity_m_s2),
            ..SHARE
        }],
        put: |p, hung| {
            let strain = p[0] * hung.body.mass_kg / hung.scales.mass_kg;
            hung.rig
                .lines
                .iter_mut()
                .for_each(|line| line.length_m *= 1.0 + strain);
        },
    },
    Cause {
        id: CauseId::StatedSpacing,
        numbers: &[CauseNumber {
            width: of_spacing,
            ..METRES
        }],
        put: |p, hung| {
            for (i, line) in hung.rig.lines.iter_mut().enumerate() {
                line.top_m += hung.axis * (0.5 * side(i) * p[0]);
                line.hull_point_m += hung.axis * (0.5 * side(i) * p[0]);
            }
        },
    },
    Cause {
        id: CauseId::NonparallelLines,
        numbers: &[CauseNumber {
            width: of_spacing,
            ..METRES
        }],
        put: |p, hung| {
            for (i, line) in hung.rig.lines.iter_mut().enumerate() {
                line.top_m += hung.axis * (0.5 * side(i) * p[0]);
            }
        },
    },
    Cause {
        id: CauseId::LineTorsion,
        numbers: &[CauseNumber {
            name: ParameterName::StiffnessNMRad,
            unit: UnitName::NewtonMetrePerRadian,
            by_mass: true,
            shown: Shown::Times(Scales::yaw_stiffness_n_m),
            ..SHARE
        }],
        // κ = Σ G J/l
        put: |p, hung| {
            let length_m = hung.rig.lines[0].length_m;
            let stiffness_n_m =
                p[0] * hung.scales.yaw_stiffness_n_m() * hung.scales.length_m / length_m;
            hung.effects.stiffness[(5, 5)] += stiffness_n_m;
        },
    },
    Cause {
        id: CauseId::SupportCompliance,
        numbers: &[
            CauseNumber {
                name: ParameterName::StiffnessAlongNM,
                ..COMPLIANCE
            },
            CauseNumber {
                name: ParameterName::StiffnessAcrossNM,
                ..COMPLIANCE
            },
        ],
        put: |p, hung| {
            let across = hung.axis.cross(&Vec3::z());
            let gives = hung.axis.abs() * p[0] + across.abs() * p[1];
            hung.effects.support_m_n += gives / hung.scales.sway_stiffness_n_m();
        },
    },
    Cause {
        id: CauseId::AddedMass,
        numbers: &[CauseNumber {
            name: ParameterName::SwayKg,
            unit: UnitName::Kilogram,
            by_mass: true,
            shown: Shown::Times(|s| s.mass_kg),
            ..SHARE
        }],
        put: |p, hung| hung.effects.mass[(1, 1)] += p[0] * hung.scales.mass_kg,
    },
    Cause {
        id: CauseId::AmplitudeAddedMass,
        numbers: &[
            CauseNumber {
                name: ParameterName::YawKgM2Rad,
                unit: UnitName::KilogramMetreSquaredPerRadian,
                by_mass: true,
                width: share_by_radian,
                shown: Shown::Times(|s| s.mass_kg * s.k_yaw_m.powi(2)),
                ..SHARE
            },
            CauseNumber {
                name: ParameterName::SwayKgM,
                unit: UnitName::KilogramPerMetre,
                by_mass: true,
                width: share_by_radian,
                shown: Shown::Times(|s| s.mass_kg / s.length_m),
                ..SHARE
            },
        ],
        put: |p, hung| {
            let scales = hung.scales;
            let sway_m = hung.amplitudes.sway_rad * hung.rig.lines[0].length_m;
            let mass = hung.axis.abs() * (p[1] * scales.mass_kg / scales.length_m * sway_m);
            let inertia = p[0] * scales.mass_kg * scales.k_yaw_m.powi(2) * hung.amplitudes.yaw_rad;
            (0..3).for_each(|i| hung.effects.mass[(i, i)] += mass[i]);
            hung.effects.mass[(5, 5)] += inertia;
        },
    },
    Cause {
        id: CauseId::OffCentreCm,
        // Its effect on periods is of the second order.
        numbers: &[CauseNumber {
            name: ParameterName::AlongM,
            width: |s| 0.05 * s.spacing_m,
            shown: Shown::Size,
            ..METRES
        }],
        put: |p, hung| hung.body.cm_m += hung.axis * p[0],
    },
    Cause {
        id: CauseId::UnequalLines,
        numbers: &[CauseNumber {
            name: ParameterName::DifferenceM,
            shown: Shown::Size,
            ..METRES
        }],
        put: |p, hung| {
            for (i, line) in hung.rig.lines.iter_mut().enumerate() {
                line.length_m += 0.5 * side(i) * p[0];
            }
        },
    },
    Cause {
        id: CauseId::ClockScale,
        // A watch or a logger is off by some ten parts in a million; one that counts by the mains,
        // by more.
        numbers: &[CauseNumber {
            name: ParameterName::Error,
            unit: UnitName::One,
            width: |_| 2e-4,
            ..METRES
        }],
        put: |p, hung| hung.clock_error += p[0],
    },
    Cause {
        id: CauseId::StatedGravity,
        // Over the Earth: 9.780 to 9.832 m/s², rectangular.
        numbers: &[CauseNumber {
            name: ParameterName::ExcessMS2,
            unit: UnitName::MetrePerSecondSquared,
            width: |_| 0.015,
            ..METRES
        }],
        put: |p, hung| hung.rig.gravity_m_s2 += p[0],
    },
];
