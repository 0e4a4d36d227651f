//! Plain data of the module `plan`: what is asked of the planner, and what it advises.

use gyradius_core::diagnosis::NextSwing;
use gyradius_core::planning::{
    Beat, HangingAdvice, Hull, Means, Optima, Plan, PlannedIncline, PlannedSwing,
    PredictedQuantity, PredictedSwing, Request, RoughHull, Step, Warning, WarningKind,
};
use gyradius_core::recording::{AddedMass, End, Excitation, Quantity, Suspension};

use super::names::QuantityKey;
use super::sentence::Sentence;
use super::{
    BudgetsByName, NumbersByMode, NumbersByName, PredictionsByName, SourcesByName, TextsByName,
};

/// What is asked of the planner.
pub type PlanRequest = Request;

/// What is asked of the planner.
#[uniffi::remote(Record)]
pub struct PlanRequest {
    /// What the plan is for, free text.
    pub title: String,
    /// The hull; a session tells of it where one is planned on.
    pub hull: RoughHull,
    /// `k_yaw=0.1%`, …; what class measurers need where nothing is said.
    pub wanted: Vec<String>,
    /// What is at hand.
    pub means: Means,
}

/// What is at hand: `usual_means` gives every figure its default.
#[uniffi::remote(Record)]
pub struct Means {
    /// Room for the lines, m.
    pub most_line_length_m: f64,
    /// The shortest lines that can be rigged, m.
    pub least_line_length_m: f64,
    /// The widest spacing of the points, m.
    pub most_spacing_m: Option<f64>,
    /// The narrowest, m.
    pub least_spacing_m: Option<f64>,
    /// Standard uncertainty of a line's measured length, m.
    pub u_line_length_m: f64,
    /// Standard uncertainty of a spacing, m.
    pub u_spacing_m: f64,
    /// Standard uncertainty of the level of the hull, degrees.
    pub u_hull_pitch_deg: f64,
    /// Acceleration of free fall, m/s².
    pub gravity_m_s2: Quantity,
    /// White noise of each axis of the gyroscope, rad/s.
    pub gyro_noise_rad_s: f64,
    /// White noise of each axis of the accelerometer, m/s².
    pub acc_noise_m_s2: f64,
    /// Samples per second.
    pub rate_hz: f64,
    /// Decay time of the motions, s.
    pub decay_s: f64,
    /// Angle of a release, degrees.
    pub amplitude_deg: f64,
    /// The shortest recording, s.
    pub least_duration_s: f64,
    /// The longest recording, s.
    pub most_duration_s: f64,
}

/// What a user tells of a hull. Gyradii and depth that are told go before those of the type.
#[uniffi::remote(Record)]
pub struct RoughHull {
    /// Everything that hangs, kg.
    pub mass_kg: Option<f64>,
    /// Length overall, m.
    pub length_m: Option<f64>,
    /// Largest beam, m.
    pub beam_m: Option<f64>,
    /// Name of the type: one of `boat_types`.
    pub boat_type: Option<String>,
    /// Yaw gyradius, m.
    pub k_yaw_m: Option<Quantity>,
    /// Pitch gyradius, m.
    pub k_pitch_m: Option<Quantity>,
    /// Roll gyradius, m.
    pub k_roll_m: Option<Quantity>,
    /// Depth of the centre of mass below the suspension points, hung level, m.
    pub cm_depth_m: Option<Quantity>,
    /// ψ, bow up, degrees.
    pub psi_deg: Option<Quantity>,
}

/// A hull as the plan assumes it.
pub type AssumedHull = Hull;

/// A hull as the plan assumes it: each figure with how far it may be off, and where it comes from.
#[uniffi::remote(Record)]
pub struct AssumedHull {
    /// Everything that hangs, kg.
    pub mass_kg: f64,
    /// Length overall, m.
    pub length_m: f64,
    /// Largest beam, m.
    pub beam_m: f64,
    /// Yaw gyradius, m.
    pub k_yaw_m: Quantity,
    /// Pitch gyradius, m.
    pub k_pitch_m: Quantity,
    /// Roll gyradius, m.
    pub k_roll_m: Quantity,
    /// Depth of the centre of mass below the suspension points, hung level, m.
    pub cm_depth_m: Quantity,
    /// ψ, bow up, degrees.
    pub psi_deg: Quantity,
    /// Where each figure comes from.
    pub sources: SourcesByName,
}

/// What to do, and what it is expected to give.
pub type PlanResult = Plan;

/// What to do, and what it is expected to give.
#[uniffi::remote(Record)]
pub struct PlanResult {
    /// `gyradius-plan/1`.
    pub format: String,
    /// What is planned for.
    pub title: String,
    /// The hull as it is assumed.
    pub hull: AssumedHull,
    /// What is assumed to be at hand.
    pub means: Means,
    /// How to hang it, in the order of the swings.
    pub suspensions: Vec<HangingAdvice>,
    /// What to do, in order.
    pub steps: Vec<PlanStep>,
    /// What each swing will show.
    pub predicted: Vec<PredictedSwing>,
    /// What a measurement of all of them is expected to give, by quantity.
    pub quantities: PredictionsByName,
    /// Contributions of each input, largest first.
    pub budget: BudgetsByName,
    /// Dimensions that would serve best.
    pub optima: Optima,
    /// Time that it takes, roughly, s.
    pub effort_s: f64,
    /// The swing that tells two causes apart, where that was asked.
    pub tells_apart: Option<NextSwing>,
    /// What to know before the first swing.
    pub warnings: Vec<PlanWarning>,
}

/// One thing to do, in the order of the plan.
pub type PlanStep = Step;

/// One thing to do, in the order of the plan.
#[uniffi::remote(Enum)]
pub enum PlanStep {
    /// Hang it so, set it going, record.
    Swing(PlannedSwing),
    /// Hang a weight from an end, read the tilt.
    Incline(PlannedIncline),
}

/// A swing to be made.
#[uniffi::remote(Record)]
pub struct PlannedSwing {
    /// Unique id, that of the swing in the session to come.
    pub id: String,
    /// How to hang it; dimensions with the uncertainty they are to be measured to.
    pub suspension: Suspension,
    /// Masses to fix to the hull for this swing.
    pub added_masses: Vec<AddedMass>,
    /// What to set going.
    pub excited: Vec<Excitation>,
    /// Angle of the release, degrees.
    pub amplitude_deg: f64,
    /// Length of the recording, s.
    pub duration_s: f64,
    /// Periods to expect, s.
    pub periods_s: NumbersByMode,
    /// Standard uncertainty of the period, as a part of it, that is enough for what is wanted.
    pub period_u_wanted: f64,
}

/// An incline test to be made.
#[uniffi::remote(Record)]
pub struct PlannedIncline {
    /// The end that the weight hangs from.
    pub end: End,
    /// The weight, kg.
    pub mass_kg: f64,
    /// Horizontal distance from the suspension points to the weight's, m.
    pub arm_m: f64,
    /// Depth of the weight's suspension point below the hull's, m.
    pub depth_m: f64,
    /// Tilt to expect, bow up positive, degrees.
    pub pitch_deg: f64,
}

/// One way to hang the hull.
#[uniffi::remote(Record)]
pub struct HangingAdvice {
    /// Points of the square frame, as Table 4 of the paper has them: `B-F`.
    pub frame_points: String,
    /// Dimensions.
    pub suspension: Suspension,
    /// What it measures.
    pub gives: Vec<QuantityKey>,
    /// The swings made on it.
    pub swings: Vec<String>,
    /// In words.
    pub message: Sentence,
}

/// What a planned swing will show.
#[uniffi::remote(Record)]
pub struct PredictedSwing {
    /// The swing.
    pub id: String,
    /// Small-amplitude periods of every mode, s.
    pub periods_s: NumbersByMode,
    /// How much longer yaw and sway take at the amplitude of the release, parts per million.
    pub longer_at_release_ppm: NumbersByMode,
    /// The beat of yaw against sway.
    pub beat: Option<Beat>,
}

/// A beat of yaw against sway.
#[uniffi::remote(Record)]
pub struct Beat {
    /// From one minimum to the next, s; absent where yaw and sway keep step.
    pub period_s: Option<f64>,
    /// Oscillations of the average motion in a beat; absent likewise.
    pub oscillations: Option<f64>,
    /// Period of the average motion, s.
    pub average_period_s: f64,
}

/// A quantity and how well it will be known.
#[uniffi::remote(Record)]
pub struct PredictedQuantity {
    /// As it is assumed, m or degrees.
    pub value: f64,
    /// Standard uncertainty to expect, same unit; absent where it will not be determined.
    pub u: Option<f64>,
    /// What was wanted, same unit.
    pub wanted_u: Option<f64>,
    /// Whether that is reached; absent where nothing was wanted.
    pub is_reached: Option<bool>,
}

/// The best dimensions for a hull, whether there is room for them or not.
#[uniffi::remote(Record)]
pub struct Optima {
    /// Line length for the pitch gyradius with the depth known, m.
    pub line_length_depth_known_m: Option<f64>,
    /// The same with gyradius and depth both solved for, m.
    pub line_length_joint_m: Option<f64>,
    /// For the roll gyradius, depth known, m.
    pub line_length_roll_depth_known_m: Option<f64>,
    /// With both solved for, m.
    pub line_length_roll_joint_m: Option<f64>,
    /// Twice the yaw gyradius, m.
    pub spacing_m: f64,
    /// Best depth of the centre of mass below the axis of a compound pendulum in pitch, m.
    pub compound_pitch_axis_to_cm_m: f64,
    /// Height of that axis above the suspension points, m.
    pub compound_pitch_axis_height_m: f64,
    /// The same in roll, m.
    pub compound_roll_axis_to_cm_m: f64,
    /// Height of the axis in roll, m.
    pub compound_roll_axis_height_m: f64,
}

/// What a warning of the plan is about: the key of its sentence.
pub type PlanWarningKind = WarningKind;

/// What a warning of the plan is about: the key of its sentence.
#[uniffi::remote(Enum)]
pub enum PlanWarningKind {
    /// Yaw has nearly the period of the in-phase pitch (or roll) mode: Kane and Tseng.
    YawNearInPhase,
    /// Yaw and sway keep step.
    NoBeat,
    /// A line goes slack.
    SlackLine,
    /// ψ asks for a tilt.
    TiltNeeded,
    /// No spacing in reach gives the uncertainty that is wanted with the tape at hand.
    SpacingTooShort,
    /// An uncertainty that is wanted is not reached for another input.
    NotReached,
    /// The swings do not determine a quantity that is wanted.
    NotDetermined,
    /// A figure of the hull is so rough that what hangs on it is too.
    RoughHull,
}

/// One warning of the plan.
pub type PlanWarning = Warning;

/// One warning of the plan.
#[uniffi::remote(Record)]
pub struct PlanWarning {
    /// What it is about.
    pub kind: PlanWarningKind,
    /// The swing, where it is about one.
    pub swing: Option<String>,
    /// Numbers by name, with their units.
    pub numbers: NumbersByName,
    /// Names in the sentence: a quantity, an input.
    pub names: TextsByName,
    /// In English.
    pub text: String,
}
