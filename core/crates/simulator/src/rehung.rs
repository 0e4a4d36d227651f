//! A rig's hull hung as somebody asks, released by hand: what practice and rehearsals swing.

use std::collections::BTreeMap;

use gyradius_base::error::{Error, Result};
use gyradius_mechanics::effects::{self, Described, EffectValues, Knock};
use gyradius_mechanics::sensors::{self, PhoneSlip, SensorDescribed};
use gyradius_recording::{Excitation, Swing};

use super::rig::{RigFile, RiggedSwing, is_of_sensors};
use super::sampling::Sampling;
use super::truth::{experiment, keys};

/// What goes along with a turn swings by this part of its angle: sway beside yaw, surge beside
/// pitch.
const BESIDE: f64 = 1.0 / 3.0;
/// A touch lasts so long, s, and pushes so hard for each kg of the hull, N s and N m s: 60 N at the
/// bow of 600 kg.
const TOUCH_S: f64 = 0.3;
const TOUCH_N_S_PER_KG: f64 = 0.03;
const TOUCH_N_M_S_PER_KG: f64 = 0.06;
/// A slip lasts so long, s, and turns the phone by so much, rad (8°).
const SLIP_S: f64 = 0.5;
const SLIP_RAD: f64 = 0.14;

/// How a hull is let go.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Release {
    /// What is set going.
    pub excited: Vec<Excitation>,
    /// Angle of the turning, or of the lines where none is excited, degrees; 0 leaves it at rest.
    pub amplitude_deg: f64,
    /// Held so long before, s.
    pub held_s: f64,
    /// Swings so long after it, s.
    pub swings_s: f64,
}

/// What goes wrong, times in s from the first sample.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Mistakes {
    /// The amplitude is this many times what was asked for; absent: as asked for.
    pub amplitude: Option<f64>,
    /// Sway that nobody asked for, m at the release.
    pub sway_m: f64,
    /// Somebody touches the hull.
    pub touch_s: Option<f64>,
    /// The phone slips.
    pub slip_s: Option<f64>,
}

impl RigFile {
    /// The rig's hull hung and released so, with the effects that act in every swing. `told` are
    /// keys of `[truth]` that go before those of the rig; `place` tells its chance from that of
    /// other swings.
    ///
    /// Fails with [`Error::Argument`] for an unknown key, and for a release that the lines do not
    /// leave free.
    pub fn rehung(
        &self,
        swing: &Swing,
        release: &Release,
        mistakes: &Mistakes,
        told: &BTreeMap<String, f64>,
        place: usize,
    ) -> Result<RiggedSwing> {
        let keys = keys();
        let mut truth = self.truth.clone();
        let mut starts = start(swing, release, mistakes);
        starts.extend(told.clone());
        for (name, value) in &starts {
            let known = keys.iter().find(|(key, _)| key == name);
            let (key, _) =
                known.ok_or_else(|| Error::argument("told", "a key of [truth]", name))?;
            truth.set(key, *value);
        }
        let mass_kg = self.session.body.mass_kg.map_or(100.0, |mass| mass.value);
        let mut all = self.effects.clone();
        all.extend(
            mistakes
                .touch_s
                .map(|at_s| touch(at_s - release.held_s, mass_kg))
                .transpose()?,
        );
        all.extend(mistakes.slip_s.map(slip).transpose()?);
        let (of_sensors, of_hull) = all.into_iter().partition(is_of_sensors);
        let experiment = experiment(&self.session, swing, &truth, [of_hull, of_sensors])?;
        let rate_hz = truth.sampling().rate_hz;
        let sampling = Sampling {
            duration_s: release.held_s + release.swings_s,
            rate_hz,
        };
        Ok(RiggedSwing {
            id: swing.id.clone(),
            place,
            file: String::new(),
            experiment,
            sampling,
            truth,
        })
    }
}

/// Keys of the start.
fn start(swing: &Swing, release: &Release, mistakes: &Mistakes) -> BTreeMap<String, f64> {
    let angle_deg = release.amplitude_deg * mistakes.amplitude.unwrap_or(1.0);
    let turns = release.excited.iter().any(|one| one.turns());
    let lines_deg = if turns { BESIDE * angle_deg } else { angle_deg };
    let length_m = swing
        .suspension
        .line_length_m
        .map_or(1.0, |length| length.value);
    let aside_m = length_m * lines_deg.to_radians().sin();
    let mut start = BTreeMap::from([("held_s".to_owned(), release.held_s)]);
    if angle_deg != 0.0 {
        start.extend(release.excited.iter().map(|excited| match excited {
            Excitation::Yaw => ("yaw_deg".to_owned(), angle_deg),
            Excitation::Pitch => ("pitch_deg".to_owned(), angle_deg),
            Excitation::Roll => ("roll_deg".to_owned(), angle_deg),
            Excitation::Sway => ("sway_m".to_owned(), aside_m),
            Excitation::Surge => ("surge_m".to_owned(), aside_m),
        }));
    }
    if mistakes.sway_m != 0.0 {
        *start.entry("sway_m".to_owned()).or_default() += mistakes.sway_m;
    }
    start
}

fn touch(at_s: f64, mass_kg: f64) -> Result<EffectValues> {
    let (push, turn) = (TOUCH_N_S_PER_KG * mass_kg, TOUCH_N_M_S_PER_KG * mass_kg);
    EffectValues::of(
        &effects::catalogue(),
        Knock::<f64>::ID,
        &[
            ("at_s", at_s),
            ("over_s", TOUCH_S),
            ("impulse_y_n_s", push),
            ("turn_z_n_m_s", turn),
        ],
    )
}

fn slip(at_s: f64) -> Result<EffectValues> {
    EffectValues::of(
        &sensors::catalogue(),
        PhoneSlip::<f64>::ID,
        &[
            ("at_s", at_s),
            ("over_s", SLIP_S),
            ("turn_x_rad", SLIP_RAD),
            ("shift_x_m", 0.02),
        ],
    )
}
