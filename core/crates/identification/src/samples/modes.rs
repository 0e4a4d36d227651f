//! The modes of a fitted swing: small oscillations of the fitted body, with the amplitudes of its
//! start.

use nalgebra::{DVector, Vector6};

use super::fit::Fit;
use super::model::SwingModel;
use super::scene::{OWN, Own};
use crate::amplitude_correction::angle_of_shape;
use crate::measurement::ModeResult;
use crate::names::AmplitudeUnit;
use crate::theory::{axis, mode_names, swing_body, swing_periods, swing_rig};
use gyradius_base::error::Result;
use gyradius_base::frames::{Rotation, Vec3};
use gyradius_mechanics::{Moment, RigidBody, SmallModes, small_modes};
use gyradius_recording::ModeName;

/// A mode weaker than this beside the strongest is not listed, dB.
const WEAKEST_DB: f64 = -40.0;
/// A mode is there where its amplitude stands out so many standard errors from nothing.
const SIGNIFICANT: f64 = 6.0;

/// Amplitude, phase and decay of one mode.
#[derive(Debug, Clone, Copy)]
struct Motion {
    angle_rad: f64,
    phase_rad: f64,
    alpha_per_s: f64,
}

/// Modes of the fitted swing, strongest first; their small-amplitude periods with standard errors
/// by this swing alone.
pub fn fitted_modes(model: &SwingModel, fit: &Fit) -> Result<Vec<ModeResult>> {
    let setup = &model.setup;
    let orientation = setup.swing.suspension.orientation;
    let body = swing_body(setup.layout, &fit.x, setup.swing, setup.index)?;
    let modes = small_modes(
        &swing_rig(setup.layout, &fit.x, setup.swing, setup.index)?,
        &body,
    )?;
    let names = mode_names(&body, &modes, orientation);
    let motions = motions(model, fit, &fit.own, &body, &modes, &names)?;
    let errors = errors(model, fit, &body, &modes, &names)?;
    let largest = motions
        .iter()
        .map(|m| m.angle_rad)
        .fold(f64::MIN_POSITIVE, f64::max);
    let mut found: Vec<ModeResult> = (0..4)
        .filter_map(|k| {
            let (motion, error) = (motions[k], errors[k]);
            let relative_db = 20.0 * (motion.angle_rad / largest).log10();
            let there =
                relative_db > WEAKEST_DB && motion.angle_rad > SIGNIFICANT * error.angle_rad;
            let period_s = modes.period_s(k);
            let decays = motion.alpha_per_s > 0.0;
            there.then(|| ModeResult {
                mode: names[k],
                period_s,
                period_se_s: error.period_s,
                period_observed_s: period_s,
                decay_time_s: decays.then(|| 1.0 / motion.alpha_per_s),
                decay_time_se_s: decays.then(|| error.alpha_per_s / motion.alpha_per_s.powi(2)),
                amplitude: Some(motion.angle_rad),
                amplitude_unit: AmplitudeUnit::Radian,
                phase_rad: Some(motion.phase_rad),
                relative_db,
                parasitic: false,
                doubtful: false,
                against_amplitude: vec![],
            })
        })
        .collect();
    found.sort_by(|a, b| b.relative_db.total_cmp(&a.relative_db));
    Ok(found)
}

fn motions(
    model: &SwingModel,
    fit: &Fit,
    own: &Own,
    body: &RigidBody,
    modes: &SmallModes,
    names: &[ModeName; 4],
) -> Result<[Motion; 4]> {
    let scene = model.setup.scene(&fit.x, own)?;
    let first = scene.first_moment()?;
    let damping = scene.effects.first().map_or(&[0.0; 6][..], |e| &e.values);
    let unit = axis(model.setup.swing.suspension.orientation).unit();
    Ok([0, 1, 2, 3].map(|k| {
        let shape = Vector6::from(modes.shapes[k]);
        let weight = |v: &Vector6<f64>| mass_weighted(body, modes, &shape, v);
        let (displacement, rate) = displaced(&first, modes);
        let (q, speed) = (weight(&displacement), weight(&rate) / modes.omega_rad_s[k]);
        // Shapes are normalised by the body's mass, the scene's damping is per kilogram.
        let loss: f64 = (0..6)
            .map(|i| body.mass_kg * damping[i] * shape[i] * shape[i])
            .sum();
        Motion {
            angle_rad: q.hypot(speed) * angle_of_shape(modes, k, names[k], &unit),
            phase_rad: (-speed).atan2(q),
            alpha_per_s: 0.5 * loss,
        }
    }))
}

/// Displacement from rest and its rate, `[δr; θ]`, world axes.
fn displaced(moment: &Moment<f64>, modes: &SmallModes) -> (Vector6<f64>, Vector6<f64>) {
    let rest = &modes.equilibrium.pose;
    let [w, x, y, z] = moment.attitude;
    let attitude = Rotation::new_normalize(nalgebra::Quaternion::new(w, x, y, z));
    let join = |a: Vec3, b: Vec3| Vector6::new(a.x, a.y, a.z, b.x, b.y, b.z);
    let turn = (attitude * rest.world_from_body.inverse()).scaled_axis();
    (
        join(moment.position - rest.position_m, turn),
        join(moment.velocity, attitude * moment.rate),
    )
}

fn mass_weighted(
    body: &RigidBody,
    modes: &SmallModes,
    shape: &Vector6<f64>,
    v: &Vector6<f64>,
) -> f64 {
    let turn = modes.equilibrium.pose.world_from_body.to_rotation_matrix();
    let inertia = turn.matrix() * body.inertia_kg_m2 * turn.matrix().transpose();
    let part = |v: &Vector6<f64>, i: usize| Vec3::new(v[i], v[i + 1], v[i + 2]);
    body.mass_kg * part(shape, 0).dot(&part(v, 0)) + part(shape, 3).dot(&(inertia * part(v, 3)))
}

/// Standard errors of a mode's figures.
#[derive(Debug, Clone, Copy, Default)]
struct Errors {
    period_s: f64,
    angle_rad: f64,
    alpha_per_s: f64,
}

fn errors(
    model: &SwingModel,
    fit: &Fit,
    body: &RigidBody,
    modes: &SmallModes,
    names: &[ModeName; 4],
) -> Result<[Errors; 4]> {
    let count = fit.free.len() + OWN;
    let mut slopes = vec![
        [
            DVector::zeros(count),
            DVector::zeros(count),
            DVector::zeros(count)
        ];
        4
    ];
    for (column, i) in fit.free.iter().enumerate() {
        let step = model.setup.layout.parameters[*i].step;
        let periods = |sign: f64| {
            let mut moved = fit.x.clone();
            moved[*i] += sign * step;
            swing_periods(
                model.setup.layout,
                &moved,
                model.setup.swing,
                model.setup.index,
            )
        };
        let (up, down) = (periods(1.0)?, periods(-1.0)?);
        for k in 0..4 {
            let of = |all: &[(ModeName, f64)]| {
                all.iter()
                    .find(|(n, _)| *n == names[k])
                    .map_or(0.0, |(_, t)| *t)
            };
            slopes[k][0][column] = (of(&up) - of(&down)) / (2.0 * step);
        }
    }
    // Start and damping decide amplitude and decay.
    for i in 0..13 {
        const STEP: f64 = 1e-6;
        let shifted = |sign: f64| {
            let mut own = fit.own.clone();
            own.values[i] += sign * STEP;
            motions(model, fit, &own, body, modes, names)
        };
        let (up, down) = (shifted(1.0)?, shifted(-1.0)?);
        for k in 0..4 {
            slopes[k][1][fit.free.len() + i] = (up[k].angle_rad - down[k].angle_rad) / (2.0 * STEP);
            slopes[k][2][fit.free.len() + i] =
                (up[k].alpha_per_s - down[k].alpha_per_s) / (2.0 * STEP);
        }
    }
    let covariance = model.covariance(fit);
    let error = |slope: &DVector<f64>| {
        covariance
            .as_ref()
            .map_or(f64::INFINITY, |c| slope.dot(&(c * slope)).sqrt())
    };
    Ok([0, 1, 2, 3].map(|k| Errors {
        period_s: error(&slopes[k][0]),
        angle_rad: error(&slopes[k][1]),
        alpha_per_s: error(&slopes[k][2]),
    }))
}
