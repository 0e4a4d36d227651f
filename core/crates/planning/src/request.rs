//! From what is asked to a plan.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::hull::{Hull, RoughHull};
use super::limits::{not_reached, rough};
use super::means::Means;
use super::optimum::Optima;
use super::predict::{predicted, swings};
use super::result::{FORMAT, HangingAdvice, Plan, PredictedQuantity};
use super::search::{Way, search};
use super::step::Step;
use super::wanted::Wanted;
use super::warnings::of_swings;
use super::words::message;
use gyradius_base::error::{Error, Result};
use gyradius_base::message::{Argument, Message};
use gyradius_identification::{MeasureOptions, Measurement, QuantityName, measure};
use gyradius_recording::{LoadedSession, Orientation, Quantity, Suspension};

/// What is asked for, as apps and commands send it.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Request {
    /// What the plan is for, free text.
    pub title: String,
    /// The hull; left out where a session tells of it.
    pub hull: RoughHull,
    /// `k_yaw=0.1%`, …; what class measurers need where nothing is said.
    pub wanted: Vec<String>,
    /// What is at hand.
    pub means: Means,
}

impl Request {
    /// From JSON; keys that are left out have their defaults.
    ///
    /// # Errors
    /// [`Error::Argument`] that names what is wrong, and where.
    pub fn from_json(text: &str) -> Result<Self> {
        serde_json::from_str(text).map_err(|e| Error::argument("request", "a plan request", e))
    }

    fn wanted(&self) -> Result<Vec<Wanted>> {
        let wanted: Vec<Wanted> = self
            .wanted
            .iter()
            .map(|text| text.parse())
            .collect::<Result<_>>()?;
        Ok(if wanted.is_empty() {
            Wanted::usual()
        } else {
            wanted
        })
    }
}

/// The plan for a hull of which rough figures are known.
///
/// # Errors
/// [`Error::Argument`] for what is missing or outside its domain, [`Error::NoResult`] where the
/// hull cannot be hung.
pub fn plan(request: &Request) -> Result<Plan> {
    planned(&request.title, request.hull.completed()?, request)
}

/// The plan for a hull that a session has measured so far; what the request tells of the hull goes
/// before that.
///
/// # Errors
/// As [`plan`], and those of the measurement.
pub fn plan_on(loaded: &LoadedSession, request: &Request) -> Result<Plan> {
    let measurement = measure(loaded, &MeasureOptions::default())?;
    planned(
        &measurement.title,
        so_far(loaded, &measurement, request)?,
        request,
    )
}

/// The hull as a session has it, overlaid by what is told.
pub(super) fn so_far(
    loaded: &LoadedSession,
    measurement: &Measurement,
    request: &Request,
) -> Result<Hull> {
    let hull = Hull::so_far(&loaded.session, measurement)?;
    let told = &request.hull;
    let known = RoughHull {
        mass_kg: told.mass_kg.or(Some(hull.mass_kg)),
        length_m: told.length_m.or(Some(hull.length_m)),
        beam_m: told.beam_m.or(Some(hull.beam_m)),
        boat_type: told.boat_type.clone(),
        k_yaw_m: told.k_yaw_m.or(Some(hull.k_yaw_m)),
        k_pitch_m: told.k_pitch_m.or(Some(hull.k_pitch_m)),
        k_roll_m: told.k_roll_m.or(Some(hull.k_roll_m)),
        cm_depth_m: told.cm_depth_m.or(Some(hull.cm_depth_m)),
        psi_deg: told.psi_deg.or(Some(hull.psi_deg)),
    };
    Ok(Hull {
        sources: hull.sources,
        ..known.completed()?
    })
}

fn planned(title: &str, hull: Hull, request: &Request) -> Result<Plan> {
    let (means, wanted) = (&request.means, request.wanted()?);
    means.checked()?;
    let optima = Optima::of(&hull, means.gravity_m_s2.value);
    let way = search(&hull, means, &wanted, &optima)?;
    let predicted = predicted(&hull, means, &way.steps)?;
    let warnings = [
        of_swings(&hull, means, &way.steps, &predicted),
        not_reached(&hull, means, &wanted, &way),
        rough(&hull),
    ];
    Ok(Plan {
        format: FORMAT.into(),
        title: if title.is_empty() {
            "plan".into()
        } else {
            title.into()
        },
        suspensions: suspensions(&way.steps),
        predicted,
        quantities: quantities(&hull, &wanted, &way),
        optima,
        effort_s: way.effort_s,
        tells_apart: None,
        warnings: warnings.concat(),
        budget: way.expected.budget,
        steps: way.steps,
        means: means.clone(),
        hull,
    })
}

fn quantities(
    hull: &Hull,
    wanted: &[Wanted],
    way: &Way,
) -> BTreeMap<QuantityName, PredictedQuantity> {
    let mut names = QuantityName::SCALARS.to_vec();
    names.retain(|n| {
        way.expected.quantities.contains_key(n) || wanted.iter().any(|w| w.quantity == *n)
    });
    let of = |name: QuantityName| {
        let u = way
            .expected
            .quantities
            .get(&name)
            .and_then(|q| q.u.scalar());
        let wanted_u = wanted
            .iter()
            .filter(|w| w.quantity == name)
            .map(|w| w.u_of(hull))
            .min_by(f64::total_cmp);
        let value = hull.quantity(&name).map_or(f64::NAN, |q| q.value);
        let is_reached = wanted_u.map(|wanted_u| u.is_some_and(|u| u <= wanted_u));
        (
            name,
            PredictedQuantity {
                value,
                u,
                wanted_u,
                is_reached,
            },
        )
    };
    names.into_iter().map(of).collect()
}

/// The ways to hang the hull, in the order of the swings.
pub(super) fn suspensions(steps: &[Step]) -> Vec<HangingAdvice> {
    let mut list: Vec<HangingAdvice> = Vec::new();
    for swing in swings(steps) {
        match list
            .iter_mut()
            .find(|known| known.suspension == swing.suspension)
        {
            Some(known) => known.swings.push(swing.id.clone()),
            None => list.push(advice(&swing.suspension, &swing.id)),
        }
    }
    list
}

/// Table 4 of the paper; A, H and G are taken to be the corners and the middle of the frame's
/// forward side.
fn advice(hung: &Suspension, id: &str) -> HangingAdvice {
    let tilt_deg = hung.hull_pitch_deg.map_or(0.0, |q| q.value);
    let is_tilted = hung.points_moved_m.is_some();
    let (points, gives): (&str, &[QuantityName]) =
        match (hung.orientation, is_tilted, tilt_deg > 0.0) {
            (Orientation::ForeAndAft, ..) => (
                "H-D",
                &[
                    QuantityName::KYaw,
                    QuantityName::KRoll,
                    QuantityName::CmDepth,
                ],
            ),
            (Orientation::Athwartships, false, _) => (
                "B-F",
                &[
                    QuantityName::KYaw,
                    QuantityName::KPitch,
                    QuantityName::CmDepth,
                ],
            ),
            (Orientation::Athwartships, true, true) => (
                "A-G",
                &[
                    QuantityName::Psi,
                    QuantityName::KPitch,
                    QuantityName::CmDepth,
                ],
            ),
            (Orientation::Athwartships, true, false) => (
                "C-E",
                &[
                    QuantityName::Psi,
                    QuantityName::KPitch,
                    QuantityName::CmDepth,
                ],
            ),
        };
    HangingAdvice {
        frame_points: points.into(),
        suspension: hung.clone(),
        gives: gives.to_vec(),
        swings: vec![id.into()],
        message: hanging(hung, points, tilt_deg),
    }
}

/// How to hang it, in words.
fn hanging(hung: &Suspension, points: &str, tilt_deg: f64) -> Message {
    let metres = |q: Option<Quantity>| Argument::Number(q.map_or(0.0, |q| q.value.abs()), 3);
    let key = match (hung.orientation, hung.points_moved_m) {
        (Orientation::ForeAndAft, _) => "hang_fore_and_aft",
        (Orientation::Athwartships, None) => "hang_level",
        (Orientation::Athwartships, Some(moved)) if moved.value > 0.0 => "hang_bow_up",
        (Orientation::Athwartships, Some(_)) => "hang_bow_down",
    };
    let arguments = [
        ("length_m", metres(hung.line_length_m)),
        ("spacing_m", metres(hung.spacing_m)),
        ("moved_m", metres(hung.points_moved_m)),
        ("points", Argument::Plain(points.to_owned())),
        ("tilt_deg", Argument::Number(tilt_deg.abs(), 0)),
    ];
    message(key, arguments)
}
