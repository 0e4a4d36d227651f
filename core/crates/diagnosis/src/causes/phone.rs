//! What the phone and its sensors get wrong.

use std::sync::Arc;

use gyradius_base::error::Result;
use gyradius_base::frames::Vec3;
use gyradius_mechanics::Experiment;

use super::super::point::{Cause, CauseParameter, Form, LookAlike, Nearest, Seen, sensor};
use super::{cause, logarithm, number, put, strength};

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
            "gyro_warm_x_rad_s",
            "gyro_warm_y_rad_s",
            "gyro_warm_z_rad_s",
        ],
        ["acc_warm_x_m_s2", "acc_warm_y_m_s2", "acc_warm_z_m_s2"],
    ]
    .concat();
    let unit = |k: usize| if k < 3 { "rad/s" } else { "m/s^2" };
    let u = |k: usize| if k < 3 { 3e-3 } else { 3e-2 };
    let mut parameters: Vec<CauseParameter> = (0..6)
        .map(|k| strength(names[k], unit(k), 1.0, u(k)))
        .collect();
    parameters.push(logarithm("warm_up_s", "s", warm_up_s, 0.8));
    let law = put(move |q, _, e| {
        let mut numbers: Vec<(&str, f64)> = (0..6).map(|k| (names[k], q[k])).collect();
        numbers.push(("warm_up_s", q[6].clamp(0.0, 10.0).exp()));
        e.sensors.push(sensor("bias_drift", &numbers)?);
        Ok(())
    });
    Cause {
        on_phone: true,
        ..cause("bias_drift", parameters, law)
    }
}

/// Beyond what is known of phones' clocks.
fn clock_scale() -> Cause {
    let parameters = vec![strength("error", "1", 1.0, 5e-3)];
    let law = put(|q, _, e| {
        e.sensors[0].values[0] += q[0];
        Ok(())
    });
    Cause {
        on_phone: true,
        ..cause("clock_scale", parameters, law)
    }
}

fn gyro_scale() -> Cause {
    let parameters = vec![strength("scale_error", "1", 1.0, 0.01)];
    let law = put(|q, _, e| {
        e.sensors
            .push(sensor("gyro_scale", &AXES.map(|axis| (axis, q[0])))?);
        Ok(())
    });
    Cause {
        on_phone: true,
        ..cause("gyro_scale", parameters, law)
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
    for name in ["turn_x_rad", "turn_y_rad", "turn_z_rad"] {
        parameters.push(strength(name, "rad", 1.0, 0.02));
    }
    for name in ["shift_x_m", "shift_y_m", "shift_z_m"] {
        parameters.push(strength(name, "m", 1.0, 0.01));
    }
    parameters.push(CauseParameter {
        step: 0.02,
        ..number("at_s", "s", at_s, 2.0)
    });
    parameters.push(CauseParameter {
        step: 0.05,
        ..logarithm("over_s", "s", SLIP_S, SLIP_LOG_U)
    });
    let names: Vec<&'static str> = parameters[..6].iter().map(|p| p.name).collect();
    let law = put(move |q, s, e| {
        if s < swing {
            return Ok(());
        }
        let over_s = q[7].exp().clamp(SLIPS_S[0], SLIPS_S[1]);
        let at_s = if s == swing {
            q[6] - 0.5 * over_s
        } else {
            -10.0
        };
        let mut numbers: Vec<(&str, f64)> = names.iter().copied().zip(q.iter().copied()).collect();
        numbers.extend([("at_s", at_s), ("over_s", over_s)]);
        e.sensors.push(sensor("phone_slip", &numbers)?);
        Ok(())
    });
    Cause {
        on_phone: true,
        form: Form::PhoneSlip(swing),
        ..cause("phone_slip", parameters, law)
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
        axis: &Vec3,
        lever: &Vec3,
        (hz, zeta): (f64, f64),
        share: f64,
        e: &mut Experiment,
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
        logarithm("frequency_hz", "Hz", MOUNT_HZ, 0.7),
        logarithm("damping_ratio", "1", MOUNT_DAMPING, 1.0),
        number("axis_turn_1_rad", "rad", 0.0, 1.0),
        number("axis_turn_2_rad", "rad", 0.0, 1.0),
        number("lever_1_per_m", "1/m", 0.0, 3.0),
        number("lever_2_per_m", "1/m", 0.0, 3.0),
    ];
    let law = put(move |q, _, e| {
        let [one, other] = hinge.across;
        let axis = (hinge.axis + one * q[2] + other * q[3]).normalize();
        let hz_and_zeta = (q[0].clamp(-1.0, 4.0).exp(), q[1].clamp(-7.0, -0.1).exp());
        Hinge::put(&axis, &(one * q[4] + other * q[5]), hz_and_zeta, 1.0, e)
    });
    let seen = vec![
        strength("turning", "1", 1.0, 2.0),
        strength("lever_1", "1/m", 1.0, 4.0),
        strength("lever_2", "1/m", 1.0, 4.0),
    ];
    let parts = put(move |q, _, e| {
        let lever = hinge.across[0] * q[1] + hinge.across[1] * q[2];
        if q[..3] == [0.0; 3] {
            return Ok(());
        }
        Hinge::put(&hinge.axis, &lever, (MOUNT_HZ, MOUNT_DAMPING), q[0], e)
    });
    let cause_of_parts = Cause {
        on_phone: true,
        ..cause("phone_mount_resonance", seen, parts)
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
        on_phone: true,
        apart: true,
        look: Some(Arc::new(look)),
        ..cause("phone_mount_resonance", parameters, law)
    }
}

/// A mount that turns by less than this share of one at the look's frequency (above some 25 Hz) is
/// not seen.
const LEAST_TURNING: f64 = 0.04;
