//! What the phone and its sensors get wrong.

use std::sync::Arc;

use gyradius_base::error::Result;
use gyradius_base::frames::Vec3;
use gyradius_mechanics::{Experiment, Jet, Real, V3};

use super::super::cause_id::CauseId;
use super::super::parameter_id::ParameterName;
use super::super::point::{Cause, CauseParameter, Form, LookAlike, Nearest, Seen, sensor};
use super::super::unit::UnitName;
use super::{by_name, cause, clamped, fixed, logarithm, number, put, strength};

const AXES: [&str; 3] = ["x", "y", "z"];

pub fn causes() -> Vec<Cause> {
    vec![
        bias_drift(60.0),
        bias_drift(300.0),
        clock_scale(),
        gyro_scale(),
    ]
}

/// A sensor that warms up, alike in every swing: w (1 − e^(−t/τ)).
fn bias_drift(warm_up_s: f64) -> Cause {
    let names = [
        [
            ParameterName::GyroWarmXRadS,
            ParameterName::GyroWarmYRadS,
            ParameterName::GyroWarmZRadS,
        ],
        [
            ParameterName::AccWarmXMS2,
            ParameterName::AccWarmYMS2,
            ParameterName::AccWarmZMS2,
        ],
    ]
    .concat();
    let unit = |k: usize| {
        if k < 3 {
            UnitName::RadianPerSecond
        } else {
            UnitName::MetrePerSecondSquared
        }
    };
    let u = |k: usize| if k < 3 { 3e-3 } else { 3e-2 };
    let mut parameters: Vec<CauseParameter> = (0..6)
        .map(|k| strength(names[k], unit(k), 1.0, u(k)))
        .collect();
    parameters.push(logarithm(
        ParameterName::WarmUpS,
        UnitName::Second,
        warm_up_s,
        0.8,
    ));
    let law = put(move |q, _, e| {
        let mut numbers = by_name(&names, |k| q[k]);
        numbers.push(("warm_up_s", clamped(q[6], 0.0, 10.0).exp()));
        e.sensors.push(sensor("bias_drift", &numbers)?);
        Ok(())
    });
    Cause {
        ..cause(CauseId::BiasDrift, parameters, law)
    }
}

/// Beyond what is known of phones' clocks.
fn clock_scale() -> Cause {
    let parameters = vec![strength(ParameterName::Error, UnitName::One, 1.0, 5e-3)];
    let law = put(|q, _, e| {
        e.sensors[0].values[0] += q[0];
        Ok(())
    });
    Cause {
        ..cause(CauseId::ClockScale, parameters, law)
    }
}

fn gyro_scale() -> Cause {
    let parameters = vec![strength(
        ParameterName::ScaleError,
        UnitName::One,
        1.0,
        0.01,
    )];
    let law = put(|q, _, e| {
        e.sensors
            .push(sensor("gyro_scale", &AXES.map(|axis| (axis, q[0])))?);
        Ok(())
    });
    Cause {
        ..cause(CauseId::GyroScale, parameters, law)
    }
}

/// Length of a slip, s, and of its logarithm: a jolt, or tape that creeps.
pub const SLIP_S: f64 = 0.15;
const SLIP_LOG_U: f64 = 1.0;
/// Lengths that are told apart from none and from a drift, s.
const SLIPS_S: [f64; 2] = [0.02, 3.0];

/// A phone that slips at a moment of a swing, and stays so in all that follow. The moment is the
/// middle of the slip.
pub fn slip_at(swing: usize, at_s: f64) -> Cause {
    let mut parameters: Vec<CauseParameter> = Vec::new();
    for name in [
        ParameterName::TurnXRad,
        ParameterName::TurnYRad,
        ParameterName::TurnZRad,
    ] {
        parameters.push(strength(name, UnitName::Radian, 1.0, 0.02));
    }
    for name in [
        ParameterName::ShiftXM,
        ParameterName::ShiftYM,
        ParameterName::ShiftZM,
    ] {
        parameters.push(strength(name, UnitName::Metre, 1.0, 0.01));
    }
    parameters.push(number(ParameterName::AtS, UnitName::Second, at_s, 2.0));
    parameters.push(logarithm(
        ParameterName::OverS,
        UnitName::Second,
        SLIP_S,
        SLIP_LOG_U,
    ));
    let names: Vec<ParameterName> = parameters[..6].iter().map(|p| p.name).collect();
    let law = put(move |q, s, e| {
        if s < swing {
            return Ok(());
        }
        let over_s = clamped(q[7].exp(), SLIPS_S[0], SLIPS_S[1]);
        let at_s = if s == swing {
            q[6] - over_s * 0.5
        } else {
            fixed(-10.0)
        };
        let mut numbers = by_name(&names, |k| q[k]);
        numbers.extend([("at_s", at_s), ("over_s", over_s)]);
        e.sensors.push(sensor("phone_slip", &numbers)?);
        Ok(())
    });
    Cause {
        form: Form::PhoneSlip(swing),
        ..cause(CauseId::PhoneSlip, parameters, law)
    }
}

/// Frequency at which a first look sees a mount, Hz. Far above the swing's own a mount gives way at
/// once, and its frequency is no more than how much it gives.
const MOUNT_HZ: f64 = 5.0;
const MOUNT_DAMPING: f64 = 0.06;
/// Axes that a first look tries, phone axes.
const MOUNT_AXES: [[f64; 3]; 7] = [
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, -1.0],
];

/// Mounts that turn about one axis, driven on a lever across it.
pub fn mounts() -> Vec<Cause> {
    MOUNT_AXES.map(mount).to_vec()
}

/// An axis and two directions across it.
#[derive(Clone, Copy)]
struct Hinge {
    axis: Vec3,
    across: [Vec3; 2],
}

impl Hinge {
    fn along(axis: [f64; 3]) -> Self {
        let axis = Vec3::from(axis).normalize();
        let across = axis.cross(&Vec3::ith(axis.iamin(), 1.0)).normalize();
        Self {
            axis,
            across: [across, axis.cross(&across)],
        }
    }

    fn put(
        axis: &V3<Jet>,
        lever: &V3<Jet>,
        (hz, zeta): (Jet, Jet),
        share: Jet,
        e: &mut Experiment<Jet>,
    ) -> Result<()> {
        let lever = lever - axis * axis.dot(lever);
        let numbers = [
            ("turn_hz", hz),
            ("damping_ratio", zeta),
            ("turning_share", share),
            ("axis_x", axis.x),
            ("axis_y", axis.y),
            ("axis_z", axis.z),
            ("lever_x_per_m", lever.x),
            ("lever_y_per_m", lever.y),
            ("lever_z_per_m", lever.z),
        ];
        e.sensors.push(sensor("phone_mount_resonance", &numbers)?);
        Ok(())
    }
}

fn mount(axis: [f64; 3]) -> Cause {
    let hinge = Hinge::along(axis);
    let parameters = vec![
        logarithm(ParameterName::FrequencyHz, UnitName::Hertz, MOUNT_HZ, 0.7),
        logarithm(
            ParameterName::DampingRatio,
            UnitName::One,
            MOUNT_DAMPING,
            1.0,
        ),
        number(ParameterName::AxisTurn1Rad, UnitName::Radian, 0.0, 1.0),
        number(ParameterName::AxisTurn2Rad, UnitName::Radian, 0.0, 1.0),
        number(ParameterName::Lever1PerM, UnitName::PerMetre, 0.0, 3.0),
        number(ParameterName::Lever2PerM, UnitName::PerMetre, 0.0, 3.0),
    ];
    let law = put(move |q, _, e| {
        let [one, other] = hinge.across.map(|way| way.map(fixed));
        let axis = hinge.axis.map(fixed) + one * q[2] + other * q[3];
        let axis = axis / axis.dot(&axis).sqrt();
        let hz_and_zeta = (
            clamped(q[0], -1.0, 4.0).exp(),
            clamped(q[1], -7.0, -0.1).exp(),
        );
        let lever = one * q[4] + other * q[5];
        Hinge::put(&axis, &lever, hz_and_zeta, fixed(1.0), e)
    });
    let seen = vec![
        strength(ParameterName::Turning, UnitName::One, 1.0, 2.0),
        strength(ParameterName::Lever1, UnitName::PerMetre, 1.0, 4.0),
        strength(ParameterName::Lever2, UnitName::PerMetre, 1.0, 4.0),
    ];
    let parts = put(move |q, _, e| {
        let [one, other] = hinge.across.map(|way| way.map(fixed));
        let axis = hinge.axis.map(fixed);
        let hz_and_zeta = (fixed(MOUNT_HZ), fixed(MOUNT_DAMPING));
        Hinge::put(&axis, &(one * q[1] + other * q[2]), hz_and_zeta, q[0], e)
    });
    let cause_of_parts = Cause {
        alone: true,
        ..cause(CauseId::PhoneMountResonance, seen, parts)
    };
    // A mount of another frequency gives by its square.
    let nearest = |seen: &Seen| {
        let (strengths, share) = (seen.strengths.clone(), seen.strengths[0]);
        let frequency = (MOUNT_HZ / share.sqrt()).ln();
        let lever = [1, 2].map(|k| strengths[k] / share);
        let parameters = vec![frequency, f64::NAN, 0.0, 0.0, lever[0], lever[1]];
        (share > LEAST_TURNING).then_some(Nearest {
            strengths,
            parameters,
        })
    };
    let look = LookAlike {
        cause: cause_of_parts,
        nearest: Box::new(nearest),
    };
    Cause {
        apart: true,
        look: Some(Arc::new(look)),
        ..cause(CauseId::PhoneMountResonance, parameters, law)
    }
}

/// A mount that turns by less than this share of one at the look's frequency (above some 25 Hz) is
/// not seen.
const LEAST_TURNING: f64 = 0.04;
