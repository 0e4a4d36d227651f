//! What planned swings will show: starts, periods, and the uncertainties that a measurement of them
//! will have.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use serde::{Deserialize, Serialize};

use super::design::session_of;
use super::hull::Hull;
use super::means::Means;
use super::step::{PlannedSwing, Step};
use gyradius_base::error::Result;
use gyradius_base::frames::{Vec3, world_from_hull_pitched};
use gyradius_identification::expected::{Brought, Expected, Prospect, Released};
use gyradius_identification::routes::beat::{
    average_period_s, beat_period_s, oscillations_per_beat,
};
use gyradius_identification::routes::finite_amplitude::{
    pendulum_period_ratio, yaw_period_at_amplitude_s,
};
use gyradius_identification::routes::yaw::{Lines, yaw_period_s};
use gyradius_identification::samples::Recorded;
use gyradius_identification::theory::axis;
use gyradius_mechanics::{Body, Dimensions, Hanging, Scene, Start, SuspensionAxis};
use gyradius_recording::{Excitation, ModeName, Orientation, Quantity};

/// What a planned swing will show.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct PredictedSwing {
    /// The swing.
    pub id: String,
    /// Small-amplitude periods of every mode, s.
    pub periods_s: BTreeMap<ModeName, f64>,
    /// How much longer yaw and sway take at the amplitude of the release, parts per million (heave
    /// included).
    pub longer_at_release_ppm: BTreeMap<ModeName, f64>,
    /// The beat of yaw against sway.
    pub beat: Option<Beat>,
}

/// A beat, (10)–(13).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Beat {
    /// From one minimum to the next, s; absent where yaw and sway keep step.
    pub period_s: Option<f64>,
    /// Oscillations of the average motion in a beat, n; absent likewise.
    pub oscillations: Option<f64>,
    /// Period of the average motion, s.
    pub average_period_s: f64,
}

/// How far and where a swing is let go from rest.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Let {
    /// Yaw, bow to port, degrees.
    pub yaw_deg: f64,
    /// To port, m.
    pub sway_m: f64,
    /// Forward, m.
    pub surge_m: f64,
    /// Bow up, degrees.
    pub pitch_deg: f64,
    /// To starboard, degrees.
    pub roll_deg: f64,
}

impl Let {
    /// Of a planned swing. A turn begins at its amplitude. A shift beside a yaw is that of a hull
    /// turned about its stern, which makes both equal there (the paper beside (9)), unless that
    /// leans the lines by more than the amplitude.
    pub fn of(swing: &PlannedSwing, hull: &Hull) -> Self {
        let has = |e: Excitation| swing.excited.contains(&e);
        let length_m = swing.suspension.line_length_m.map_or(1.0, |q| q.value);
        let angle_rad = swing.amplitude_deg.to_radians();
        let leaning_m = |rad: f64| length_m * rad.sin();
        let shift_m = if has(Excitation::Yaw) {
            (0.5 * hull.length_m * angle_rad).min(leaning_m(angle_rad.min(TAU / 4.0)))
        } else if has(Excitation::Roll) || has(Excitation::Pitch) {
            leaning_m(0.5 * angle_rad)
        } else {
            leaning_m(angle_rad)
        };
        let turned = |e: Excitation| if has(e) { swing.amplitude_deg } else { 0.0 };
        let moved = |e: Excitation| if has(e) { shift_m } else { 0.0 };
        Self {
            yaw_deg: turned(Excitation::Yaw),
            sway_m: moved(Excitation::Sway),
            surge_m: moved(Excitation::Surge),
            pitch_deg: turned(Excitation::Pitch),
            roll_deg: turned(Excitation::Roll),
        }
    }

    /// Along the suspension's direction and across it, m; turn about it and about the vertical,
    /// rad.
    pub fn start(&self, orientation: Orientation) -> [f64; 4] {
        let rad = f64::to_radians;
        // The direction is +y or +x; across is then +x or −y.
        match orientation {
            Orientation::Athwartships => [
                self.sway_m,
                self.surge_m,
                -rad(self.pitch_deg),
                rad(self.yaw_deg),
            ],
            Orientation::ForeAndAft => [
                self.surge_m,
                -self.sway_m,
                rad(self.roll_deg),
                rad(self.yaw_deg),
            ],
        }
    }
}

/// The swings among the steps.
pub fn swings(steps: &[Step]) -> impl Iterator<Item = &PlannedSwing> {
    steps.iter().filter_map(|step| match step {
        Step::Swing(swing) => Some(swing),
        Step::Incline(_) => None,
    })
}

/// What each swing will show: all small periods, what the amplitude of the release does to yaw and
/// sway, the beat.
pub fn predicted(hull: &Hull, means: &Means, steps: &[Step]) -> Result<Vec<PredictedSwing>> {
    let session = session_of("plan", hull, means, steps).with_same_hangings();
    let prospect = Prospect::new(&session, &hull.body())?;
    let each = swings(steps).zip(&prospect.periods_s);
    Ok(each
        .map(|(swing, periods)| {
            let periods_s: BTreeMap<ModeName, f64> = periods.iter().copied().collect();
            let beat = beat(&periods_s, swing);
            let longer_at_release_ppm = longer(hull, means, swing);
            PredictedSwing {
                id: swing.id.clone(),
                periods_s,
                longer_at_release_ppm,
                beat,
            }
        })
        .collect())
}

/// Whether a swing has all these motions set going.
pub fn has(swing: &PlannedSwing, excited: &[Excitation]) -> bool {
    excited.iter().all(|e| swing.excited.contains(e))
}

fn beat(periods_s: &BTreeMap<ModeName, f64>, swing: &PlannedSwing) -> Option<Beat> {
    if !has(swing, &[Excitation::Yaw, Excitation::Sway]) {
        return None;
    }
    let (yaw, sway) = (
        *periods_s.get(&ModeName::Yaw)?,
        *periods_s.get(&ModeName::Sway)?,
    );
    Some(Beat {
        period_s: beat_period_s(yaw, sway).ok(),
        oscillations: oscillations_per_beat(yaw, sway).ok(),
        average_period_s: average_period_s(yaw, sway).ok()?,
    })
}

fn longer(hull: &Hull, means: &Means, swing: &PlannedSwing) -> BTreeMap<ModeName, f64> {
    let hung = &swing.suspension;
    let (Some(length), Some(spacing)) = (hung.line_length_m, hung.spacing_m) else {
        return BTreeMap::new();
    };
    let lines = Lines::parallel(length.value, 0.5 * spacing.value);
    let start = Let::of(swing, hull);
    let (g, k) = (means.gravity_m_s2.value, hull.k_yaw_m.value);
    let along_m = match hung.orientation {
        Orientation::Athwartships => start.sway_m,
        Orientation::ForeAndAft => start.surge_m,
    };
    let yaw = || {
        let wide = yaw_period_at_amplitude_s(k, &lines, g, start.yaw_deg.to_radians()).ok()?;
        Some(wide / yaw_period_s(k, &lines, g).ok()? - 1.0)
    };
    let sway = || {
        Some(
            pendulum_period_ratio((along_m / length.value).clamp(-1.0, 1.0).asin().abs()).ok()?
                - 1.0,
        )
    };
    let both = [
        (ModeName::Yaw, (start.yaw_deg != 0.0).then(yaw).flatten()),
        (ModeName::Sway, (along_m != 0.0).then(sway).flatten()),
    ];
    both.into_iter()
        .filter_map(|(mode, ratio)| Some((mode, 1e6 * ratio?)))
        .collect()
}

/// What the steps are expected to bring, by periods alone (quickly, good enough to choose by) or by
/// the samples.
pub fn expected(hull: &Hull, means: &Means, steps: &[Step], by_samples: bool) -> Result<Expected> {
    let session = session_of("plan", hull, means, steps).with_same_hangings();
    let prospect = Prospect::new(&session, &hull.body())?;
    let brought: Vec<Brought> = swings(steps)
        .zip(&prospect.periods_s)
        .map(|(swing, periods)| {
            if by_samples {
                samples(hull, means, swing)
            } else {
                periods_alone(means, swing, periods)
            }
        })
        .collect();
    prospect.expected(&brought)
}

fn samples(hull: &Hull, means: &Means, swing: &PlannedSwing) -> Brought {
    let start = Let::of(swing, hull).start(swing.suspension.orientation);
    let recorded = Recorded {
        duration_s: swing.duration_s,
        rate_hz: means.rate_hz,
        gyro_rad_s: means.gyro_noise_rad_s,
        acc_m_s2: means.acc_noise_m_s2,
    };
    Brought::Samples(
        Released {
            start,
            decay_s: means.decay_s,
        },
        recorded,
    )
}

/// Modes that are set going, with the Cramér–Rao bound of their periods.
fn periods_alone(means: &Means, swing: &PlannedSwing, periods: &[(ModeName, f64)]) -> Brought {
    let of = |(mode, period_s): &(ModeName, f64)| {
        Some((*mode, period_u(means, swing, *mode, *period_s)?))
    };
    Brought::Periods(periods.iter().filter_map(of).collect())
}

/// Relative Cramér–Rao bound of a period of a planned swing; `None` of a mode that nobody sets
/// going.
pub fn period_u(means: &Means, swing: &PlannedSwing, mode: ModeName, period_s: f64) -> Option<f64> {
    let (angle_rad, omega) = (swing.amplitude_deg.to_radians(), TAU / period_s);
    // A gyroscope sees the turn's rate; of the lines' lean an accelerometer sees g times the angle.
    // Two modes share a release.
    let over_noise = match mode {
        ModeName::Sway => means.gravity_m_s2.value * angle_rad / means.acc_noise_m_s2,
        ModeName::Yaw => angle_rad * omega / means.gyro_noise_rad_s,
        _ => 0.5 * angle_rad * omega / means.gyro_noise_rad_s,
    };
    let is_going = swing.excited.iter().any(|e| sets_going(*e, mode));
    is_going.then(|| omega_u(over_noise, means.rate_hz, swing.duration_s, means.decay_s) / omega)
}

/// Whether an excitation sets a mode going.
pub fn sets_going(excitation: Excitation, mode: ModeName) -> bool {
    use ModeName::{PitchInPhase, PitchOutOfPhase, RollInPhase, RollOutOfPhase, Sway, Yaw};
    match excitation {
        Excitation::Yaw => mode == Yaw,
        Excitation::Sway => matches!(mode, Sway | RollInPhase | RollOutOfPhase),
        Excitation::Surge => matches!(mode, Sway | PitchInPhase | PitchOutOfPhase),
        Excitation::Pitch => matches!(mode, PitchInPhase | PitchOutOfPhase),
        Excitation::Roll => matches!(mode, RollInPhase | RollOutOfPhase),
    }
}

/// Cramér–Rao bound of the standard deviation of an angular frequency, rad/s, of A e^(−αt) cos(ωt +
/// φ) in white noise: var ≥ 2σ² / (A² f_s M₂), M₂ = ∫ e^(−2αt) (t − t̄)² dt with t̄ weighted alike;
/// without damping 24σ²/(A² f_s T³).
pub fn omega_u(amplitude_over_noise: f64, rate_hz: f64, duration_s: f64, decay_s: f64) -> f64 {
    const STEPS: usize = 256;
    let step = duration_s / STEPS as f64;
    let moments = (0..STEPS).fold([0.0; 3], |sum, i| {
        let t = (i as f64 + 0.5) * step;
        let weight = (-2.0 * t / decay_s).exp() * step;
        [
            sum[0] + weight,
            sum[1] + weight * t,
            sum[2] + weight * t * t,
        ]
    });
    let second = moments[2] - moments[1] * moments[1] / moments[0];
    (2.0 / (amplitude_over_noise.powi(2) * rate_hz * second)).sqrt()
}

/// The scene of a planned swing, for its lines' tension.
pub fn scene(hull: &Hull, means: &Means, swing: &PlannedSwing) -> Result<Scene> {
    let pitch_deg = swing.suspension.hull_pitch_deg.map_or(0.0, |q| q.value);
    let mut body = hull
        .body()
        .rotated(world_from_hull_pitched(pitch_deg.to_radians()));
    // The points are moved along the deck until the centre hangs below them.
    body.cm_m = Vec3::new(
        0.0,
        0.0,
        -hull.cm_depth_m.value / pitch_deg.to_radians().cos(),
    );
    let orientation = swing.suspension.orientation;
    let value = |q: Option<Quantity>| q.map_or(1.0, |q| q.value);
    let spacing_m = value(swing.suspension.spacing_m);
    let [along_m, across_m, turn_rad, yaw_rad] = Let::of(swing, hull).start(orientation);
    let direction: SuspensionAxis = axis(orientation);
    Ok(Scene {
        hanging: Hanging::Bifilar(direction),
        body: Body::new(body.mass_kg, &body.inertia_kg_m2, &body.cm_m),
        dimensions: Dimensions {
            line_length_m: value(swing.suspension.line_length_m),
            spacing_m,
            top_spacing_m: swing
                .suspension
                .top_spacing_m
                .map_or(spacing_m, |q| q.value),
            gravity_m_s2: means.gravity_m_s2.value,
            ..Dimensions::default()
        },
        start: Start {
            along_m,
            across_m,
            turn_rad,
            yaw_rad,
            ..Start::default()
        },
        effects: vec![],
    })
}
