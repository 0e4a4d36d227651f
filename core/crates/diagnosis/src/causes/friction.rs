//! What brakes the hull, and the air that it carries along.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use super::super::point::{Cause, CauseParameter, Form};
use super::{Scales, add, cause, logarithm, number, put, strength, within};

/// Speed and rate at which the strengths of drags are given, m/s and rad/s.
const REFERENCE: f64 = 0.1;

pub fn causes(scales: &Scales) -> Vec<Cause> {
    let mut all = vec![
        quadratic_drag(scales),
        power_law_damping(scales),
        bearing_friction(scales),
    ];
    all.extend([0.005, 0.015, 0.045].map(|give_rad| presliding_bearing(scales, give_rad)));
    all.push(amplitude_added_mass(scales));
    all.extend(WINDS.map(|(direction_rad, centre)| wind(scales, direction_rad, centre)));
    all
}

/// Mass twice and moments of inertia about the suspension's direction and the vertical, per
/// kilogram.
fn inertias(scales: &Scales) -> [f64; 4] {
    [1.0, 1.0, scales.turn2_m2(), scales.gyradii2_m2[2]]
}

/// Strengths along x, along y, about the suspension and about the vertical: rates at which the
/// motion dies away.
fn four(
    names: [&'static str; 4],
    units: [&'static str; 4],
    per: [f64; 4],
    u: f64,
) -> Vec<CauseParameter> {
    (0..4)
        .map(|i| strength(names[i], units[i], per[i], u))
        .collect()
}

fn quadratic_drag(scales: &Scales) -> Cause {
    let (i, mass, turn) = (inertias(scales), scales.mass_kg, scales.turn());
    let names = [
        "surge_force_coefficient",
        "sway_force_coefficient",
        if turn == "pitch" {
            "pitch_torque_coefficient"
        } else {
            "roll_torque_coefficient"
        },
        "yaw_torque_coefficient",
    ];
    let units = ["N s^2/m^2", "N s^2/m^2", "N m s^2", "N m s^2"];
    let parameters = four(names, units, i.map(|i| i * mass / REFERENCE), 0.01);
    let law = put(move |q, _, e| {
        let numbers: Vec<(&str, f64)> = (0..4)
            .map(|k| (names[k], q[k] * i[k] / REFERENCE))
            .collect();
        add(e, "quadratic_drag", &numbers)
    });
    Cause {
        one_sided: true,
        ..cause("quadratic_drag", parameters, law)
    }
}

fn power_law_damping(scales: &Scales) -> Cause {
    let (i, mass) = (inertias(scales), scales.mass_kg);
    let names = [
        "surge_n_s_m",
        "sway_n_s_m",
        if scales.pitches {
            "pitch_n_m_s"
        } else {
            "roll_n_m_s"
        },
        "yaw_n_m_s",
    ];
    let mut parameters = four(
        names,
        ["N s/m", "N s/m", "N m s", "N m s"],
        i.map(|i| i * mass),
        0.01,
    );
    parameters.push(number("exponent", "1", 0.5, 0.2));
    let law = put(move |q, _, e| {
        let mut numbers: Vec<(&str, f64)> = (0..4).map(|k| (names[k], q[k] * i[k])).collect();
        numbers.push(("exponent", q[4].clamp(-0.5, 1.5)));
        add(e, "power_law_damping", &numbers)
    });
    Cause {
        one_sided: true,
        ..cause("power_law_damping", parameters, law)
    }
}

/// Rate and speed over which dry friction turns its sign, rad/s and m/s: a hundredth of a swing's.
const TRANSITION: f64 = 7e-4;

fn bearing_friction(scales: &Scales) -> Cause {
    let (i, mass) = (inertias(scales), scales.mass_kg);
    let names = [
        "surge_n",
        "sway_n",
        if scales.pitches {
            "pitch_n_m"
        } else {
            "roll_n_m"
        },
        "yaw_n_m",
    ];
    let parameters = four(names, ["N", "N", "N m", "N m"], i.map(|i| i * mass), 5e-4);
    let law = put(move |q, _, e| {
        let mut numbers: Vec<(&str, f64)> = (0..4).map(|k| (names[k], q[k] * i[k])).collect();
        numbers.push(("transition_rad_s", TRANSITION));
        add(e, "bearing_friction", &numbers)
    });
    Cause {
        kinked: true,
        stiff: true,
        apart: true,
        one_sided: true,
        ..cause("bearing_friction", parameters, law)
    }
}

fn presliding_bearing(scales: &Scales, give_rad: f64) -> Cause {
    let (i, mass, line_m) = (inertias(scales), scales.mass_kg, scales.line_m);
    let names = [
        "surge_n",
        "sway_n",
        if scales.pitches {
            "pitch_n_m"
        } else {
            "roll_n_m"
        },
        "yaw_n_m",
    ];
    let mut parameters = four(names, ["N", "N", "N m", "N m"], i.map(|i| i * mass), 5e-4);
    parameters.push(logarithm("give_rad", "rad", give_rad, 0.7));
    let law = put(move |q, _, e| {
        let give_rad = q[4].exp();
        let mut numbers: Vec<(&str, f64)> = (0..4).map(|k| (names[k], q[k] * i[k])).collect();
        numbers.extend([("give_rad", give_rad), ("give_m", give_rad * line_m)]);
        add(e, "presliding_bearing", &numbers)
    });
    Cause {
        kinked: true,
        one_sided: true,
        ..cause("presliding_bearing", parameters, law)
    }
}

/// Strengths are shares of mass and inertia at 0.1 rad.
fn amplitude_added_mass(scales: &Scales) -> Cause {
    let (mass, line_m, i) = (scales.mass_kg, scales.line_m, inertias(scales));
    let reach = [0.1 * line_m, 0.1 * line_m, 0.1, 0.1];
    let mut names = vec!["surge_kg_m", "sway_kg_m", "yaw_kg_m2_rad"];
    let mut which = vec![0, 1, 3];
    let mut units = vec!["kg/m", "kg/m", "kg m^2/rad"];
    if scales.pitches {
        names.push("pitch_kg_m2_rad");
        which.push(2);
        units.push("kg m^2/rad");
    }
    let parameters = (0..names.len()).map(|k| {
        strength(
            names[k],
            units[k],
            i[which[k]] * mass / reach[which[k]],
            0.01,
        )
    });
    let parameters = parameters.collect();
    let law = put(move |q, _, e| {
        let value = |k: usize| q[k] * i[which[k]] / reach[which[k]];
        let numbers: Vec<(&str, f64)> = (0..names.len()).map(|k| (names[k], value(k))).collect();
        add(e, "amplitude_added_mass", &numbers)
    });
    Cause {
        one_sided: true,
        ..cause("amplitude_added_mass", parameters, law)
    }
}

/// Directions of the wind against the hull, rad, and centres of pressure, shares of half the hull's
/// length, to begin with. From ahead or abeam alone it brakes as a linear damping does, unless its
/// centre lies off the hull's.
const WINDS: [(f64, f64); 4] = [
    (FRAC_PI_2, 0.2),
    (FRAC_PI_2, -0.2),
    (FRAC_PI_4, 0.0),
    (-FRAC_PI_4, 0.0),
];

/// What of a wind's drag acts along a hull against what acts across it, as the areas that it shows:
/// 0.1 to 1.6 of 95 in 100.
const ALONG: f64 = 0.4;
const ALONG_LOG_U: f64 = 0.7;

/// A wind is within so many standard deviations of what is known of winds, a breath of 0.05 m/s to
/// a gale of 20: as one of 55 m/s along the hull it once took part of what a rope did that rubbed.
const LIKELY: f64 = 3.0;

/// A steady wind brakes with its own speed times the hull's: motions across it turn the hull, and
/// across its direction act on each other.
fn wind(scales: &Scales, direction_rad: f64, centre: f64) -> Cause {
    let (mass, half_m, depth_m) = (scales.mass_kg, scales.half_length_m, scales.depth_m);
    let parameters = vec![
        strength("drag_n_s_m", "N s/m", mass, 0.01),
        within(LIKELY, logarithm("speed_m_s", "m/s", 1.0, 1.0)),
        number("direction_rad", "rad", direction_rad, 1.6),
        number("centre_x_m", "m", centre * half_m, 0.3 * half_m),
        number("centre_z_m", "m", 0.0, 0.3 * depth_m.max(0.3 * half_m)),
        within(
            LIKELY,
            logarithm("along_over_across", "1", ALONG, ALONG_LOG_U),
        ),
    ];
    let law = put(|q, _, e| {
        let speed_m_s = q[1].exp();
        let numbers = [
            ("force_coefficient", q[0] / speed_m_s),
            ("less_along", 1.0 - q[5].exp()),
            ("gust_time_s", 1.0),
            ("steady_x_m_s", speed_m_s * q[2].cos()),
            ("steady_y_m_s", speed_m_s * q[2].sin()),
            ("centre_x_m", q[3]),
            ("centre_z_m", q[4]),
        ];
        add(e, "wind", &numbers)
    });
    Cause {
        one_sided: true,
        ..cause(WIND, parameters, law)
    }
}

/// Name of the cause whose gusts are found after it.
pub const WIND: &str = "wind";

/// Names of the numbers of each tone that a wind may have.
pub const GUSTS: [[&str; 3]; 4] = [
    ["tone_1_hz", "tone_1_cos", "tone_1_sin"],
    ["tone_2_hz", "tone_2_cos", "tone_2_sin"],
    ["tone_3_hz", "tone_3_cos", "tone_3_sin"],
    ["tone_4_hz", "tone_4_cos", "tone_4_sin"],
];

/// A tone in the wind that is there already; every swing meets it at another phase. A recording of
/// `duration_s` tells frequencies from each other to 1/duration.
pub fn gust(tone: [&'static str; 3], frequency_hz: f64, duration_s: f64) -> Cause {
    let share = |name| CauseParameter {
        of_swing: true,
        ..strength(name, "1", 1.0, 0.2)
    };
    let parameters = vec![
        CauseParameter {
            step: 0.01 / duration_s,
            ..number("gust_hz", "Hz", frequency_hz, 1.0 / duration_s)
        },
        share("gust_cos"),
        share("gust_sin"),
    ];
    let law = put(move |q, _, e| {
        if let Some(wind) = e
            .scene
            .effects
            .iter_mut()
            .find(|effect| effect.kind.id == WIND)
        {
            tone.iter()
                .zip(q)
                .try_for_each(|(name, value)| wind.set(name, *value))?;
        }
        Ok(())
    });
    Cause {
        form: Form::Gust,
        ..cause(WIND, parameters, law)
    }
}
