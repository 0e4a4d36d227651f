//! Every cause that the criticism knows, each a few parameters and what they do to the experiment
//! of a swing.
//!
//! A cause may come in several forms (`variants`): laws with a number that a first look cannot find
//! by itself (an exponent, a frequency, a moment) are tried from several values of it.

mod friction;
mod internal;
mod outside;
mod phone;
mod rigging;

use std::sync::Arc;

use gyradius_base::error::Result;
use gyradius_identification::theory::{mode_names, swing_body, swing_rig};
use gyradius_mechanics::effects::EffectValues;
use gyradius_mechanics::{Experiment, Jet, Real};
use gyradius_recording::{ModeName, Orientation};

use super::cause_id::CauseId;
use super::fitted_swing::Base;
use super::parameter_id::ParameterName;
use super::point::{Cause, CauseParameter, Form, NO_LIMITS, Point, Put};
use super::unit::UnitName;

pub use friction::{GUSTS, gust};
pub use internal::{ringing, seconds};
pub use outside::{GIVES_S, TERMS, knock_at, learned_force, line_slip_at, reach};
pub use phone::{SLIP_S, mounts, slip_at};

/// What scales everyday strengths, from the fitted base.
#[derive(Debug, Clone)]
pub struct Scales {
    /// Mass, kg; 1 where it was not stated.
    pub mass_kg: f64,
    /// Squares of the gyradii about x, y, z, m².
    pub gyradii2_m2: [f64; 3],
    pub depth_m: f64,
    pub line_m: f64,
    pub spacing_m: f64,
    pub gravity_m_s2: f64,
    /// Angular frequencies of yaw and of the slowest and the fastest motion, rad/s.
    pub yaw_rad_s: f64,
    pub slowest_rad_s: f64,
    pub fastest_rad_s: f64,
    /// Whether the hull is free to pitch (lines side by side) rather than to roll.
    pub pitches: bool,
    /// Half of the hull's length where stated, else the yaw gyradius twice, m.
    pub half_length_m: f64,
}

impl Scales {
    pub fn of(base: &Base, point: &Point) -> Result<Self> {
        let layout = base.layout();
        let setup = &base.swings[0].setup;
        let body = swing_body(layout, &point.x, setup.swing, setup.index)?;
        let rig = swing_rig(layout, &point.x, setup.swing, setup.index)?;
        let modes = gyradius_mechanics::small_modes(&rig, &body)?;
        let orientation = setup.swing.suspension.orientation;
        let names = mode_names(&body, &modes, orientation);
        let yaw = names.iter().position(|n| *n == ModeName::Yaw).unwrap_or(0);
        let k2 = [0, 1, 2].map(|i| body.inertia_kg_m2[(i, i)] / body.mass_kg);
        Ok(Self {
            mass_kg: base.session.body.mass_kg.map_or(1.0, |m| m.value),
            gyradii2_m2: k2,
            depth_m: -body.cm_m.z,
            line_m: rig.lines[0].length_m,
            spacing_m: (rig.lines[1].hull_point_m - rig.lines[0].hull_point_m).norm(),
            gravity_m_s2: rig.gravity_m_s2,
            yaw_rad_s: modes.omega_rad_s[yaw],
            slowest_rad_s: modes.omega_rad_s[0],
            fastest_rad_s: modes.omega_rad_s[3],
            pitches: orientation == Orientation::Athwartships,
            half_length_m: base
                .session
                .body
                .length_overall_m
                .map_or(2.0 * k2[2].sqrt(), |l| 0.5 * l),
        })
    }

    /// Square of the gyradius of the turn about the suspension's direction, m².
    fn turn2_m2(&self) -> f64 {
        if self.pitches {
            self.gyradii2_m2[1]
        } else {
            self.gyradii2_m2[0]
        }
    }
}

/// Every variant of every cause that a simulation shows.
pub fn catalogue(scales: &Scales) -> Vec<Cause> {
    [
        friction::causes(scales),
        rigging::causes(scales),
        internal::causes(scales),
        phone::causes(),
    ]
    .concat()
}

/// A strength in proportion to which the effect grows.
fn strength(name: ParameterName, unit: UnitName, factor: f64, u: f64) -> CauseParameter {
    CauseParameter {
        factor,
        is_strength: true,
        ..number(name, unit, 0.0, u)
    }
}

/// A number that the effect depends on in other ways.
fn number(name: ParameterName, unit: UnitName, mean: f64, u: f64) -> CauseParameter {
    CauseParameter {
        name,
        unit,
        factor: 1.0,
        zero: 0.0,
        is_log: false,
        prior: (mean, u),
        stiff_below: 0.0,
        is_strength: false,
        of_swing: false,
        limits: NO_LIMITS,
    }
}

/// The same by its logarithm.
fn logarithm(name: ParameterName, unit: UnitName, mean: f64, u: f64) -> CauseParameter {
    CauseParameter {
        is_log: true,
        ..number(name, unit, mean.ln(), u)
    }
}

/// No further from the mean of its prior than so many of its standard deviations.
fn within(count: f64, parameter: CauseParameter) -> CauseParameter {
    let (mean, u) = parameter.prior;
    CauseParameter {
        limits: (mean - count * u, mean + count * u),
        ..parameter
    }
}

fn cause(id: CauseId, parameters: Vec<CauseParameter>, put: Put) -> Cause {
    Cause {
        id,
        parameters,
        put,
        kinked: false,
        alone: false,
        apart: false,
        one_sided: false,
        form: Form::Law,
        look: None,
    }
}

/// A [`Put`] from a function of the values.
fn put(
    f: impl Fn(&[Jet], usize, &mut Experiment<Jet>) -> Result<()> + Send + Sync + 'static,
) -> Put {
    Arc::new(f)
}

/// A value kept within limits: beyond them the law does not depend on it.
fn clamped(value: Jet, low: f64, high: f64) -> Jet {
    if (low..=high).contains(&value.value) {
        value
    } else {
        Jet::constant(value.value.clamp(low, high))
    }
}

/// A number that no parameter changes.
fn fixed(value: f64) -> Jet {
    Jet::constant(value)
}

/// Values by the names that an effect has for its numbers, those of the parameters.
fn by_name(names: &[ParameterName], value: impl Fn(usize) -> Jet) -> Vec<(&'static str, Jet)> {
    let named = |(k, name): (usize, &ParameterName)| (name.name(), value(k));
    names.iter().enumerate().map(named).collect()
}

/// Adds an effect of the hull.
fn add(experiment: &mut Experiment<Jet>, id: &str, numbers: &[(&str, Jet)]) -> Result<()> {
    experiment
        .scene
        .effects
        .push(EffectValues::new(id, numbers)?);
    Ok(())
}
