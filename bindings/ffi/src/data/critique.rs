//! Plain data of the module `critique`: what the simulation gets wrong, and why.

use std::collections::BTreeMap;

use gyradius_core::diagnosis::{
    CauseResult, CauseVerdict, Critique, Discrepancy, Gain, LearnedForce, ModelResult, NextSwing,
    ParameterId, ParameterResult,
};
use gyradius_core::identification::Finding;
use gyradius_core::recording::Excitation;

use super::names::{CauseName, CauseStatus, CoordinateName, KindOfDiscrepancy, UnitText};
use super::sentence::Sentence;
use super::{QuantitiesByName, ShiftsByName};

/// A fitted parameter of a cause, by name.
#[derive(Debug, Clone, PartialEq, uniffi::Record)]
pub struct NamedParameter {
    /// The parameter.
    pub name: String,
    /// What it was found to be.
    pub parameter: ParameterResult,
}

/// Parameters as the core holds them.
pub type ParametersByName = BTreeMap<ParameterId, ParameterResult>;
uniffi::custom_type!(ParametersByName, Vec<NamedParameter>, {
    remote,
    lower: |map| {
        let named = |(id, parameter): (ParameterId, ParameterResult)| {
            NamedParameter { name: id.to_string(), parameter }
        };
        map.into_iter().map(named).collect()
    },
    try_lift: |list| {
        let keyed = |one: NamedParameter| Ok((one.name.parse()?, one.parameter));
        list.into_iter().map(keyed).collect()
    },
});

/// A force that was learned, at one place.
#[derive(Debug, Clone, PartialEq, uniffi::Record)]
pub struct ForcePoint {
    /// Where the coordinate stands, rad or m.
    pub position: f64,
    /// How fast it changes, rad/s or m/s.
    pub rate: f64,
    /// When, s.
    pub t_s: f64,
    /// The force there, in the learned force's unit.
    pub force: f64,
    /// Its standard uncertainty.
    pub force_u: f64,
}

/// A point of the core.
pub type ForceRow = [f64; 5];
uniffi::custom_type!(ForceRow, ForcePoint, {
    remote,
    lower: |row| ForcePoint { position: row[0], rate: row[1], t_s: row[2], force: row[3], force_u: row[4] },
    try_lift: |at| Ok([at.position, at.rate, at.t_s, at.force, at.force_u]),
});

/// The criticism of a session.
#[uniffi::remote(Record)]
pub struct Critique {
    /// `gyradius-critique/1`.
    pub format: String,
    /// The session's title.
    pub title: String,
    /// The simulation without any cause.
    pub baseline: ModelResult,
    /// What it gets wrong, the most significant first.
    pub discrepancies: Vec<Discrepancy>,
    /// Causes that were tried in full, the most probable first.
    pub causes: Vec<CauseResult>,
    /// What follows.
    pub verdict: CauseVerdict,
    /// The simulation with the verdict's causes in it.
    pub extended: ModelResult,
    /// What that gained.
    pub gain: Gain,
    /// The missing force as the data show it, where no known cause accounts for them.
    pub learned: Option<LearnedForce>,
    /// What is not plausible in the session, and what its data cannot hold.
    pub findings: Vec<Finding>,
    /// What a reader must know.
    pub warnings: Vec<Sentence>,
}

/// A simulation fitted to the session.
#[uniffi::remote(Record)]
pub struct ModelResult {
    /// Residual over noise of the samples that it was fitted to: 1 where nothing is left.
    pub rms_over_noise: Option<f64>,
    /// The same of samples that took no part in the fit.
    pub heldout_rms_over_noise: Option<f64>,
    /// The body by this simulation.
    pub quantities: QuantitiesByName,
}

/// One thing that the base simulation gets wrong.
#[uniffi::remote(Record)]
pub struct Discrepancy {
    /// The swing; empty for what shows between swings.
    pub swing: String,
    /// `structure`, `period_vs_amplitude`, `decay_vs_amplitude`, `residual_vs_time` …
    pub what: KindOfDiscrepancy,
    /// How large it is.
    pub size: f64,
    /// Unit of the size.
    pub unit: UnitText,
    /// Its significance in standard deviations.
    pub sigma: f64,
    /// In words.
    pub message: Sentence,
}

/// A cause that was tried.
#[uniffi::remote(Record)]
pub struct CauseResult {
    /// Its name: `quadratic_drag`, `line_stretch`, `stated_length` …
    pub id: CauseName,
    /// Of the causes tried in its place, that it is this one.
    pub probability: f64,
    /// Logarithm (natural) of the evidence with it over that without.
    pub log_evidence_gain: f64,
    /// Its parameters, in units of the rig.
    pub parameters: ParametersByName,
    /// What it is and how strong, in words.
    pub message: Sentence,
    /// Whether the extended model has it.
    pub taken: bool,
}

/// A fitted parameter.
#[uniffi::remote(Record)]
pub struct ParameterResult {
    /// Value.
    pub value: f64,
    /// Its standard uncertainty.
    pub u: f64,
    /// Unit.
    pub unit: UnitText,
}

/// What follows from it all.
#[uniffi::remote(Record)]
pub struct CauseVerdict {
    /// `adequate`, `explained`, `ambiguous` or `unexplained`.
    pub status: CauseStatus,
    /// Causes named.
    pub causes: Vec<CauseName>,
    /// Causes that these data cannot tell from those.
    pub indistinguishable_from: Vec<CauseName>,
    /// The swing that would tell them apart.
    pub next_swing: Option<NextSwing>,
    /// In words.
    pub message: Sentence,
}

/// A swing worth making.
#[uniffi::remote(Record)]
pub struct NextSwing {
    /// The swing of the session that it hangs like but for what is told here.
    pub like: String,
    /// Length of the lines, m.
    pub line_length_m: f64,
    /// Spacing of the lines, m.
    pub spacing_m: f64,
    /// What to set going.
    pub excited: Vec<Excitation>,
    /// Angle of the release, degrees.
    pub amplitude_deg: f64,
    /// Length of the recording, s.
    pub duration_s: f64,
    /// Bow-up angle, degrees.
    pub hull_pitch_deg: f64,
    /// How far the predictions of the causes in doubt then differ, standard deviations.
    pub sigma: f64,
    /// In words.
    pub message: Sentence,
}

/// What the extension gained.
#[uniffi::remote(Record)]
pub struct Gain {
    /// Held-out residual of the base simulation over that of the extended one.
    pub heldout_rms_ratio: Option<f64>,
    /// Gain of the logarithm (natural) of the density of held-out samples, each.
    pub log_score_per_sample: Option<f64>,
    /// Change of the yaw gyradius, m.
    pub k_yaw_shift_m: Option<f64>,
    /// Change of every quantity that both models give.
    pub shifts: ShiftsByName,
}

/// A generalised force learned from the data inside the simulation.
#[uniffi::remote(Record)]
pub struct LearnedForce {
    /// `yaw`, `pitch`, `roll`, `surge`, `sway` or `all`.
    pub coordinate: CoordinateName,
    /// Unit of the force.
    pub unit: UnitText,
    /// The force at places, rates and times.
    pub points: Vec<ForceRow>,
    /// The simplest closed form that does as well.
    pub equation: String,
    /// The same in words.
    pub message: Sentence,
    /// Held-out residual over noise with the force in the simulation.
    pub heldout_rms_over_noise: Option<f64>,
    /// The same with the closed form.
    pub closed_heldout_rms_over_noise: Option<f64>,
}
