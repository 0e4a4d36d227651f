//! A way to measure: the hangings and swings that a choice of dimensions makes, and what each
//! costs.

use std::collections::BTreeMap;

use super::hull::Hull;
use super::means::Means;
use super::step::{PlannedIncline, PlannedSwing, Step};
use gyradius_identification::measure::PHONE_TILT_U_DEG;
use gyradius_recording::{
    Body, End, Excitation, Incline, InclineAngle, Orientation, Quantity, Session, Site, Suspension,
    SuspensionKind, Swing, SwingData,
};

/// Cost of hanging the hull anew, of a swing beside its recording, of an incline, s, and of a metre
/// of line, s.
const HANGING_S: f64 = 1200.0;
const SWING_S: f64 = 180.0;
const INCLINE_S: f64 = 300.0;
const METRE_S: f64 = 60.0;
/// A degree of tilt: the steeper a hull hangs the longer it takes to make fast.
const TILT_S: f64 = 60.0;
/// The weight of an incline test tilts the hull by so much, degrees, and is known to this part, as
/// its arm.
const INCLINE_DEG: f64 = 5.0;
const INCLINE_WEIGHT_U: f64 = 1e-3;
/// Dimensions are proposed in steps of this, m.
const STEP_M: f64 = 0.01;

/// Dimensions and what is done with them.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    /// Length of the lines, m.
    pub line_length_m: f64,
    /// A second length, at which the level swings are repeated, m.
    pub second_length_m: Option<f64>,
    /// Distance of the points, m.
    pub spacing_m: f64,
    /// Level, lines side by side.
    pub is_level: bool,
    /// Level, lines fore and aft.
    pub is_fore_and_aft: bool,
    /// Tilts at which the hull is hung beside, degrees bow up.
    pub tilts_deg: Vec<f64>,
    /// With an incline test.
    pub is_inclined: bool,
    /// Length of each recording, s.
    pub duration_s: f64,
    /// Yaw and sway each by itself.
    pub is_apart: bool,
    /// What the pitch modes are for.
    pub with_pitch: bool,
}

/// To so many steps of a centimetre.
pub fn rounded(length_m: f64) -> f64 {
    // A model's lines are short: a hundredth of their length, if that is finer.
    let step = if length_m < 1.0 { 0.1 * STEP_M } else { STEP_M };
    (length_m / step).round() * step
}

impl Design {
    /// What it costs, s of an operator's time.
    pub fn effort_s(&self, steps: &[Step]) -> f64 {
        let hangings =
            usize::from(self.is_level) + usize::from(self.is_fore_and_aft) + self.tilts_deg.len();
        let hangings = hangings + usize::from(self.second_length_m.is_some());
        let of_step = |step: &Step| match step {
            Step::Swing(swing) => SWING_S + swing.duration_s,
            Step::Incline(_) => INCLINE_S,
        };
        HANGING_S * hangings as f64
            + TILT_S * self.tilts_deg.iter().map(|tilt| tilt.abs()).sum::<f64>()
            + METRE_S * (self.line_length_m + self.second_length_m.unwrap_or(0.0))
            + steps.iter().map(of_step).sum::<f64>()
    }

    /// The steps, periods left open.
    pub fn steps(&self, hull: &Hull, means: &Means) -> Vec<Step> {
        let mut steps = Vec::new();
        let mut swing = |id: &str, suspension: Suspension, excited: &[Excitation]| {
            steps.push(Step::Swing(PlannedSwing {
                id: id.into(),
                suspension,
                added_masses: vec![],
                excited: excited.to_vec(),
                amplitude_deg: means.amplitude_deg,
                duration_s: self.duration_s,
                periods_s: BTreeMap::new(),
                period_u_wanted: 0.0,
            }));
        };
        use Excitation::{Pitch, Roll, Surge, Sway, Yaw};
        let side_by_side = |length_m: f64| self.hung(means, Orientation::Athwartships, length_m);
        let mut level = |suffix: &str, length_m: f64| {
            if self.is_apart {
                swing(&format!("yaw{suffix}"), side_by_side(length_m), &[Yaw]);
                swing(&format!("sway{suffix}"), side_by_side(length_m), &[Sway]);
            } else {
                swing(
                    &format!("yaw-sway{suffix}"),
                    side_by_side(length_m),
                    &[Yaw, Sway],
                );
            }
            if self.with_pitch {
                swing(&format!("pitch{suffix}"), side_by_side(length_m), &[Pitch]);
            }
        };
        if self.is_level {
            level("", self.line_length_m);
            if let Some(length_m) = self.second_length_m {
                level("-2", length_m);
            }
        }
        if self.is_fore_and_aft {
            swing(
                "roll",
                self.hung(means, Orientation::ForeAndAft, self.line_length_m),
                &[Roll, Surge],
            );
        }
        for tilt_deg in &self.tilts_deg {
            let id = if *tilt_deg > 0.0 {
                "bow-up"
            } else {
                "bow-down"
            };
            swing(id, self.tilted(hull, means, *tilt_deg), &[Yaw, Sway]);
        }
        if self.is_inclined {
            steps.push(Step::Incline(incline(hull)));
        }
        steps
    }

    fn hung(&self, means: &Means, orientation: Orientation, length_m: f64) -> Suspension {
        Suspension {
            line_length_m: Some(Quantity::new(length_m, means.u_line_length_m)),
            spacing_m: Some(Quantity::new(self.spacing_m, means.u_spacing_m)),
            hull_pitch_deg: Some(Quantity::new(0.0, means.u_hull_pitch_deg)),
            ..Suspension::unmeasured(SuspensionKind::Bifilar, orientation)
        }
    }

    fn tilted(&self, hull: &Hull, means: &Means, tilt_deg: f64) -> Suspension {
        // l2 = Δ / tan φ: forward of the level ones, bow up.
        let moved_m = hull.cm_depth_m.value * tilt_deg.to_radians().tan();
        Suspension {
            hull_pitch_deg: Some(Quantity::new(tilt_deg, means.u_hull_pitch_deg)),
            points_moved_m: Some(Quantity::new(moved_m, means.u_spacing_m)),
            ..self.hung(means, Orientation::Athwartships, self.line_length_m)
        }
    }
}

/// A weight at the stern, a third of the length from the points, that tilts the hull enough to be
/// read, (20).
fn incline(hull: &Hull) -> PlannedIncline {
    let arm_m = rounded(0.35 * hull.length_m);
    let mass_kg = hull.mass_kg * hull.cm_depth_m.value * INCLINE_DEG.to_radians().tan() / arm_m;
    PlannedIncline {
        end: End::Stern,
        mass_kg,
        arm_m,
        depth_m: 0.0,
        pitch_deg: INCLINE_DEG,
    }
}

/// Name of the recording of a swing.
pub fn recording_of(id: &str) -> String {
    format!("{id}.csv")
}

/// The session that the steps will make, their recordings still to come. Inclines hold the angle to
/// expect.
pub fn session_of(title: &str, hull: &Hull, means: &Means, steps: &[Step]) -> Session {
    let mut session = Session {
        title: title.into(),
        body: Body {
            name: title.into(),
            mass_kg: Some(Quantity::new(hull.mass_kg, 0.0)),
            length_overall_m: Some(hull.length_m),
            density_kg_m3: None,
        },
        site: Site {
            gravity_m_s2: Some(means.gravity_m_s2),
            ..Site::default()
        },
        ..Session::default()
    };
    for step in steps {
        match step {
            Step::Swing(swing) => session.swings.push(Swing {
                id: swing.id.clone(),
                data: SwingData::Recording(recording_of(&swing.id)),
                excited: swing.excited.clone(),
                added_masses: swing.added_masses.clone(),
                amplitude_deg: BTreeMap::new(),
                suspension: swing.suspension.clone(),
            }),
            Step::Incline(incline) => session.inclines.push(Incline {
                end: incline.end,
                mass_kg: Quantity::new(incline.mass_kg, INCLINE_WEIGHT_U * incline.mass_kg),
                arm_m: Quantity::new(incline.arm_m, means.u_spacing_m),
                depth_m: Quantity::new(incline.depth_m, means.u_spacing_m),
                angle: InclineAngle::Stated(Quantity::new(incline.pitch_deg, PHONE_TILT_U_DEG)),
            }),
        }
    }
    session
}
