//! What brakes the hull, and the air that it carries along.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use gyradius_mechanics::Real;

use super::super::cause_id::CauseId;
use super::super::parameter_id::ParameterName;
use super::super::point::{Cause, CauseParameter, Form};
use super::super::unit::UnitName;
use super::{
    Scales, add, by_name, cause, clamped, fixed, logarithm, number, put, strength, within,
};

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
    names: [ParameterName; 4],
    units: [UnitName; 4],
    per: [f64; 4],
    u: f64,
) -> Vec<CauseParameter> {
    (0..4)
        .map(|i| strength(names[i], units[i], per[i], u))
        .collect()
}

/// What the turn about the suspension is called: pitch or roll.
fn turning(scales: &Scales, pitch: ParameterName, roll: ParameterName) -> ParameterName {
    if scales.pitches { pitch } else { roll }
}

fn quadratic_drag(scales: &Scales) -> Cause {
    let (i, mass) = (inertias(scales), scales.mass_kg);
    let names = [
        ParameterName::SurgeForceCoefficient,
        ParameterName::SwayForceCoefficient,
        turning(
            scales,
            ParameterName::PitchTorqueCoefficient,
            ParameterName::RollTorqueCoefficient,
        ),
        ParameterName::YawTorqueCoefficient,
    ];
    let units = [
        UnitName::NewtonSecondSquaredPerMetreSquared,
        UnitName::NewtonSecondSquaredPerMetreSquared,
        UnitName::NewtonMetreSecondSquared,
        UnitName::NewtonMetreSecondSquared,
    ];
    let parameters = four(names, units, i.map(|i| i * mass / REFERENCE), 0.01);
    let law = put(move |q, _, e| {
        let numbers = by_name(&names, |k| q[k] * (i[k] / REFERENCE));
        add(e, "quadratic_drag", &numbers)
    });
    Cause {
        one_sided: true,
        ..cause(CauseId::QuadraticDrag, parameters, law)
    }
}

fn power_law_damping(scales: &Scales) -> Cause {
    let (i, mass) = (inertias(scales), scales.mass_kg);
    let names = [
        ParameterName::SurgeNSM,
        ParameterName::SwayNSM,
        turning(scales, ParameterName::PitchNMS, ParameterName::RollNMS),
        ParameterName::YawNMS,
    ];
    let mut parameters = four(
        names,
        [
            UnitName::NewtonSecondPerMetre,
            UnitName::NewtonSecondPerMetre,
            UnitName::NewtonMetreSecond,
            UnitName::NewtonMetreSecond,
        ],
        i.map(|i| i * mass),
        0.01,
    );
    parameters.push(number(ParameterName::Exponent, UnitName::One, 0.5, 0.2));
    let law = put(move |q, _, e| {
        let mut numbers = by_name(&names, |k| q[k] * i[k]);
        numbers.push(("exponent", clamped(q[4], -0.5, 1.5)));
        add(e, "power_law_damping", &numbers)
    });
    Cause {
        one_sided: true,
        ..cause(CauseId::PowerLawDamping, parameters, law)
    }
}

/// Rate and speed over which dry friction turns its sign, rad/s and m/s: a hundredth of a swing's.
const TRANSITION: f64 = 7e-4;

/// Strengths of a dry friction.
fn dry_friction(scales: &Scales) -> ([ParameterName; 4], Vec<CauseParameter>) {
    let names = [
        ParameterName::SurgeN,
        ParameterName::SwayN,
        turning(scales, ParameterName::PitchNM, ParameterName::RollNM),
        ParameterName::YawNM,
    ];
    let units = [
        UnitName::Newton,
        UnitName::Newton,
        UnitName::NewtonMetre,
        UnitName::NewtonMetre,
    ];
    let per = inertias(scales).map(|i| i * scales.mass_kg);
    (names, four(names, units, per, 5e-4))
}

fn bearing_friction(scales: &Scales) -> Cause {
    let i = inertias(scales);
    let (names, parameters) = dry_friction(scales);
    let law = put(move |q, _, e| {
        let mut numbers = by_name(&names, |k| q[k] * i[k]);
        numbers.push(("transition_rad_s", fixed(TRANSITION)));
        add(e, "bearing_friction", &numbers)
    });
    Cause {
        kinked: true,
        apart: true,
        one_sided: true,
        ..cause(CauseId::BearingFriction, parameters, law)
    }
}

fn presliding_bearing(scales: &Scales, give_rad: f64) -> Cause {
    let (i, line_m) = (inertias(scales), scales.line_m);
    let (names, mut parameters) = dry_friction(scales);
    parameters.push(logarithm(
        ParameterName::GiveRad,
        UnitName::Radian,
        give_rad,
        0.7,
    ));
    let law = put(move |q, _, e| {
        let give_rad = q[4].exp();
        let mut numbers = by_name(&names, |k| q[k] * i[k]);
        numbers.extend([("give_rad", give_rad), ("give_m", give_rad * line_m)]);
        add(e, "presliding_bearing", &numbers)
    });
    Cause {
        kinked: true,
        one_sided: true,
        ..cause(CauseId::PreslidingBearing, parameters, law)
    }
}

/// Strengths are shares of mass and inertia at 0.1 rad.
fn amplitude_added_mass(scales: &Scales) -> Cause {
    let (mass, line_m, i) = (scales.mass_kg, scales.line_m, inertias(scales));
    let reach = [0.1 * line_m, 0.1 * line_m, 0.1, 0.1];
    let mut names = vec![
        ParameterName::SurgeKgM,
        ParameterName::SwayKgM,
        ParameterName::YawKgM2Rad,
    ];
    let mut which = vec![0, 1, 3];
    let mut units = vec![
        UnitName::KilogramPerMetre,
        UnitName::KilogramPerMetre,
        UnitName::KilogramMetreSquaredPerRadian,
    ];
    if scales.pitches {
        names.push(ParameterName::PitchKgM2Rad);
        which.push(2);
        units.push(UnitName::KilogramMetreSquaredPerRadian);
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
        let value = |k: usize| q[k] * (i[which[k]] / reach[which[k]]);
        let numbers = by_name(&names, value);
        add(e, "amplitude_added_mass", &numbers)
    });
    Cause {
        one_sided: true,
        ..cause(CauseId::AmplitudeAddedMass, parameters, law)
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
        strength(
            ParameterName::DragNSM,
            UnitName::NewtonSecondPerMetre,
            mass,
            0.01,
        ),
        within(
            LIKELY,
            logarithm(ParameterName::SpeedMS, UnitName::MetrePerSecond, 1.0, 1.0),
        ),
        number(
            ParameterName::DirectionRad,
            UnitName::Radian,
            direction_rad,
            1.6,
        ),
        number(
            ParameterName::CentreXM,
            UnitName::Metre,
            centre * half_m,
            0.3 * half_m,
        ),
        number(
            ParameterName::CentreZM,
            UnitName::Metre,
            0.0,
            0.3 * depth_m.max(0.3 * half_m),
        ),
        within(
            LIKELY,
            logarithm(
                ParameterName::AlongOverAcross,
                UnitName::One,
                ALONG,
                ALONG_LOG_U,
            ),
        ),
    ];
    let law = put(|q, _, e| {
        let speed_m_s = q[1].exp();
        let numbers = [
            ("force_coefficient", q[0] / speed_m_s),
            ("less_along", -q[5].exp() + 1.0),
            ("gust_time_s", fixed(1.0)),
            ("steady_x_m_s", speed_m_s * q[2].cos()),
            ("steady_y_m_s", speed_m_s * q[2].sin()),
            ("centre_x_m", q[3]),
            ("centre_z_m", q[4]),
        ];
        add(e, "wind", &numbers)
    });
    Cause {
        one_sided: true,
        ..cause(CauseId::Wind, parameters, law)
    }
}

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
        ..strength(name, UnitName::One, 1.0, 0.2)
    };
    let parameters = vec![
        number(
            ParameterName::GustHz,
            UnitName::Hertz,
            frequency_hz,
            1.0 / duration_s,
        ),
        share(ParameterName::GustCos),
        share(ParameterName::GustSin),
    ];
    let law = put(move |q, _, e| {
        if let Some(wind) = e
            .scene
            .effects
            .iter_mut()
            .find(|effect| effect.kind.id == CauseId::Wind.name())
        {
            tone.iter()
                .zip(q)
                .try_for_each(|(name, value)| wind.set(name, *value))?;
        }
        Ok(())
    });
    Cause {
        alone: true,
        form: Form::Gust,
        ..cause(CauseId::Wind, parameters, law)
    }
}
