//! The swing that tells two causes apart, as a plan. What it is, the criticism's own `next_swing`
//! decides.

use std::collections::BTreeMap;

use super::optimum::Optima;
use super::predict::predicted;
use super::request::{Request, so_far, suspensions};
use super::result::{FORMAT, Plan};
use super::step::Step;
use super::suggested::suggested;
use super::warnings::of_swings;
use gyradius_base::error::{Error, Result};
use gyradius_diagnosis::{CauseId, Progress, tell_apart};
use gyradius_identification::{MeasureOptions, measure};
use gyradius_recording::LoadedSession;

/// The plan of the one swing that would tell two causes apart, for a
/// session that could not.
///
/// # Errors
/// [`gyradius_base::Error::Argument`] for a cause that
/// this kind of session does not show, [`gyradius_base::Error::NoResult`] where no
/// swing tells them, and those of the measurement.
pub fn plan_to_tell_apart(
    loaded: &LoadedSession,
    causes: [CauseId; 2],
    request: &Request,
    progress: &Progress,
) -> Result<Plan> {
    let means = &request.means;
    means.checked()?;
    let next = tell_apart(loaded, causes, progress)?;
    let measurement = measure(loaded, &MeasureOptions::default())?;
    let hull = so_far(loaded, &measurement, request)?;
    let swing = suggested(&next, &loaded.session, Some(hull.cm_depth_m.value));
    let missing = || {
        Error::no_result(
            "plan",
            format!("the session has no swing `{}` to hang it like", next.like),
        )
    };
    let mut swing = swing.ok_or_else(missing)?;
    let predicted = predicted(&hull, means, &[Step::Swing(swing.clone())])?;
    swing.periods_s = predicted
        .first()
        .map(|shown| shown.periods_s.clone())
        .unwrap_or_default();
    let steps = vec![Step::Swing(swing)];
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
