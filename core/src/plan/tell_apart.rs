//! The swing that tells two causes apart, as a plan. What it is, the criticism's own `next_swing` decides.

use std::collections::BTreeMap;

use super::optimum::Optima;
use super::request::{Request, so_far, suspensions};
use super::result::{FORMAT, Plan};
use super::step::{PlannedSwing, Step};
use super::warnings::{of_swings, predicted};
use crate::critique::{NextSwing, Progress, tell_apart};
use crate::error::Result;
use crate::inertia::{MeasureOptions, measure};
use crate::recording::{Excitation, LoadedSession, Orientation, Quantity, Suspension, SuspensionKind};

/// A phone's clock is good to 20 ppm: no period need be known better.
const PERIOD_U_WANTED: f64 = 2e-5;

/// The plan of the one swing that would tell two causes (names of the criticism) apart, for a session that could not.
///
/// # Errors
/// [`crate::Error::Argument`] for a name that is no cause, [`crate::Error::NoResult`] where no swing tells them, and those of
/// the measurement.
pub fn plan_to_tell_apart(
    loaded: &LoadedSession,
    causes: [&str; 2],
    request: &Request,
    progress: &Progress,
) -> Result<Plan> {
    let means = &request.means;
    means.checked()?;
    let next = tell_apart(loaded, causes, progress)?;
    let measurement = measure(loaded, &MeasureOptions::default())?;
    let hull = so_far(loaded, &measurement, request)?;
    let orientation =
        loaded.session.swings.first().map_or(Orientation::Athwartships, |s| s.suspension.orientation);
    let mut steps = vec![Step::Swing(swing(&next, orientation, request, hull.cm_depth_m.value))];
    let predicted = predicted(&hull, means, &steps)?;
    for (step, shown) in steps.iter_mut().zip(&predicted) {
        if let Step::Swing(swing) = step {
            swing.periods_s = shown.periods_s.clone();
        }
    }
    Ok(Plan {
        format: FORMAT.into(),
        title: measurement.title,
        suspensions: suspensions(&steps),
        optima: Optima::of(&hull, means.gravity_m_s2.value),
        warnings: of_swings(&hull, means, &steps, &predicted),
        effort_s: next.duration_s,
        predicted,
        steps,
        quantities: BTreeMap::new(),
        budget: BTreeMap::new(),
        means: means.clone(),
        tells_apart: Some(next),
        hull,
    })
}

fn swing(next: &NextSwing, orientation: Orientation, request: &Request, depth_m: f64) -> PlannedSwing {
    let means = &request.means;
    let is_tilted = next.hull_pitch_deg.abs() > 1.0;
    let moved_m = depth_m * next.hull_pitch_deg.to_radians().tan();
    PlannedSwing {
        id: "next".into(),
        suspension: Suspension {
            kind: SuspensionKind::Bifilar,
            orientation,
            line_length_m: Some(Quantity::new(next.line_length_m, means.u_line_length_m)),
            spacing_m: Some(Quantity::new(next.spacing_m, means.u_spacing_m)),
            top_spacing_m: None,
            hull_pitch_deg: Some(Quantity::new(next.hull_pitch_deg, means.u_hull_pitch_deg)),
            points_moved_m: is_tilted.then_some(Quantity::new(moved_m, means.u_spacing_m)),
            axis_height_m: None,
        },
        added_masses: vec![],
        excited: next.excited.iter().map(|name| excitation(name, orientation)).collect(),
        amplitude_deg: next.amplitude_deg,
        duration_s: next.duration_s,
        periods_s: BTreeMap::new(),
        period_u_wanted: PERIOD_U_WANTED,
    }
}

/// The criticism calls a shift along the suspension sway and the turn about it pitch.
fn excitation(name: &str, orientation: Orientation) -> Excitation {
    match (name, orientation) {
        ("yaw", _) => Excitation::Yaw,
        ("sway", Orientation::Athwartships) => Excitation::Sway,
        ("sway", Orientation::ForeAndAft) => Excitation::Surge,
        (_, Orientation::Athwartships) => Excitation::Pitch,
        (_, Orientation::ForeAndAft) => Excitation::Roll,
    }
}
