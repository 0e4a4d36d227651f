//! What the criticism of a session says: what `critique --json` writes (`gyradius-critique/1`).
//!
//! Fields that the contract names are spelled as there; what is added is additional keys only.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use gyradius_base::error::{Error, Result};
use gyradius_base::message::Message;
use gyradius_base::message::channel_and_said;
use gyradius_base::message::text_and_said;
use gyradius_base::message::warnings_and_said;
use gyradius_identification::{Finding, QuantityName, QuantityResult};
use gyradius_recording::Excitation;

use super::cause_id::CauseId;
use super::coordinate::ForceCoordinate;
use super::parameter_id::ParameterId;
use super::unit::{Unit, UnitName};
use gyradius_base::named;

/// The criticism of a session.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Critique {
    /// `gyradius-critique/1`.
    pub format: String,
    /// The session's title.
    pub title: String,
    /// The simulation without any cause.
    pub baseline: ModelResult,
    /// What it gets wrong, the most significant first.
    pub discrepancies: Vec<Discrepancy>,
    /// Causes that were tried in full, the most probable first. `unknown` among them is what no
    /// known cause accounts for.
    pub causes: Vec<CauseResult>,
    /// What follows.
    pub verdict: CauseVerdict,
    /// The simulation with the verdict's causes in it.
    pub extended: ModelResult,
    /// What that gained.
    pub gain: Gain,
    /// The missing force as the data show it, where no known cause accounts for them.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub learned: Option<LearnedForce>,
    /// What is not plausible in the session, and what its data cannot hold.
    #[serde(default)]
    pub findings: Vec<Finding>,
    /// What a reader must know.
    #[serde(flatten, with = "warnings_and_said")]
    #[schemars(with = "warnings_and_said::WarningsAndSaid")]
    pub warnings: Vec<Message>,
}

impl Critique {
    /// One thing more that a reader must know.
    pub(super) fn warn(&mut self, message: Message) {
        self.warnings.push(message);
    }

    /// With what the measurement found implausible.
    pub(super) fn with(mut self, findings: Vec<Finding>) -> Self {
        let told = findings.iter().filter_map(Finding::told);
        self.warnings.extend(told);
        self.findings = findings;
        self
    }

    /// A criticism from its `gyradius-critique/1` text.
    pub fn from_json(text: &str) -> Result<Self> {
        serde_json::from_str(text).map_err(|error| Error::argument("critique", "its JSON", error))
    }
}

/// A simulation fitted to the session.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct ModelResult {
    /// Residual over noise of the samples that it was fitted to: 1 where nothing is left.
    pub rms_over_noise: Option<f64>,
    /// The same of samples that took no part in the fit.
    pub heldout_rms_over_noise: Option<f64>,
    /// The body by this simulation.
    pub quantities: BTreeMap<QuantityName, QuantityResult>,
}

named! {
    /// The kinds of things that the base simulation gets wrong.
    DiscrepancyKind: "kind of discrepancy" {
        /// The body turns about another axis than the one that it hangs from.
        AcrossTheAxis = "across_the_axis",
        /// Swings contradict each other.
        BetweenSwings = "between_swings",
        /// The oscillation decays otherwise with its amplitude.
        DecayVsAmplitude = "decay_vs_amplitude",
        /// A stated figure contradicts the swings.
        Dimension = "dimension",
        /// A frequency stands out of the residual.
        LineInSpectrum = "line_in_spectrum",
        /// The period changes otherwise with the amplitude.
        PeriodVsAmplitude = "period_vs_amplitude",
        /// The residual depends on the phase of the oscillation.
        ResidualVsPhase = "residual_vs_phase",
        /// The residual depends on the time.
        ResidualVsTime = "residual_vs_time",
        /// Readings lie at the end of a sensor's range.
        Saturated = "saturated",
        /// The residual is larger than the noise.
        Structure = "structure",
    }
}

named! {
    /// The verdict on the simulation, in one word. Its default is the one that claims nothing.
    #[derive(Default)]
    Status: "status of the verdict" {
        /// Nothing is missing.
        Adequate = "adequate",
        /// By causes that others could replace.
        Ambiguous = "ambiguous",
        /// By causes that nothing else replaces.
        Explained = "explained",
        /// Contradictions remain.
        #[default]
        Unexplained = "unexplained",
    }
}

/// One thing that the base simulation gets wrong.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Discrepancy {
    /// The swing; empty for what shows between swings.
    pub swing: String,
    /// What kind of thing.
    pub what: DiscrepancyKind,
    /// How large it is.
    pub size: f64,
    /// Unit of the size.
    pub unit: Unit,
    /// Its significance in standard deviations.
    pub sigma: f64,
    /// In words.
    #[serde(flatten, with = "text_and_said")]
    #[schemars(with = "text_and_said::TextAndSaid")]
    pub message: Message,
}

impl Discrepancy {
    /// One of a swing: what it is, its size with the unit, its significance, and in words.
    pub(super) fn of(
        swing: &str,
        what: DiscrepancyKind,
        (size, unit): (f64, UnitName),
        sigma: f64,
        message: Message,
    ) -> Self {
        Self {
            swing: swing.into(),
            what,
            size,
            unit: unit.into(),
            sigma,
            message,
        }
    }
}

impl NextSwing {
    /// With its words.
    pub(super) fn told(self, message: Message) -> Self {
        Self { message, ..self }
    }
}

/// A cause that was tried.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct CauseResult {
    /// Its name in the contract.
    pub id: CauseId,
    /// Of the causes tried in its place, that it is this one.
    pub probability: f64,
    /// Logarithm (natural) of the evidence with it over that without.
    pub log_evidence_gain: f64,
    /// Its parameters, in units of the rig.
    pub parameters: BTreeMap<ParameterId, ParameterResult>,
    /// What it is and how strong, in words.
    #[serde(flatten, with = "text_and_said")]
    #[schemars(with = "text_and_said::TextAndSaid")]
    pub message: Message,
    /// Whether the extended model has it.
    #[serde(default)]
    pub taken: bool,
}

/// A fitted parameter.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct ParameterResult {
    /// Value.
    pub value: f64,
    /// Its standard uncertainty.
    pub u: f64,
    /// Unit.
    pub unit: Unit,
}

/// What follows from it all.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct CauseVerdict {
    /// Which of the four verdicts.
    pub status: Status,
    /// Causes named.
    pub causes: Vec<CauseId>,
    /// Causes that these data cannot tell from those.
    pub indistinguishable_from: Vec<CauseId>,
    /// The swing that would tell them apart.
    pub next_swing: Option<NextSwing>,
    /// In words.
    #[serde(flatten, with = "text_and_said")]
    #[schemars(with = "text_and_said::TextAndSaid")]
    pub message: Message,
}

/// A swing worth making.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct NextSwing {
    /// The swing of the session that it hangs like but for what is told here.
    #[serde(default)]
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
    #[serde(flatten, with = "text_and_said")]
    #[schemars(with = "text_and_said::TextAndSaid")]
    pub message: Message,
}

/// What the extension gained.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Gain {
    /// Held-out residual of the base simulation over that of the extended one.
    pub heldout_rms_ratio: Option<f64>,
    /// Gain of the logarithm (natural) of the density of held-out samples, each.
    pub log_score_per_sample: Option<f64>,
    /// Change of the yaw gyradius, m.
    pub k_yaw_shift_m: Option<f64>,
    /// Change of every quantity that both models give.
    #[serde(default)]
    pub shifts: BTreeMap<QuantityName, f64>,
}

/// A generalised force learned from the data inside the simulation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct LearnedForce {
    /// What it acts on.
    pub coordinate: ForceCoordinate,
    /// Unit of the force.
    pub unit: Unit,
    /// The force at places, rates and times: rows of position, rate, time, force, its standard
    /// uncertainty.
    pub points: Vec<[f64; 5]>,
    /// The simplest closed form that does as well.
    pub equation: String,
    /// The same in words.
    #[serde(flatten, with = "text_and_said")]
    #[schemars(with = "text_and_said::TextAndSaid")]
    pub message: Message,
    /// Held-out residual over noise with the force in the simulation.
    pub heldout_rms_over_noise: Option<f64>,
    /// The same with the closed form.
    pub closed_heldout_rms_over_noise: Option<f64>,
}

/// A criticism and what its pictures are drawn from.
#[derive(Debug, Clone, Default)]
pub struct Criticism {
    /// The result.
    pub critique: Critique,
    /// One for each swing that was fitted.
    pub traces: Vec<SwingTrace>,
}

/// Samples of a swing's most telling channel against both simulations.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct SwingTrace {
    /// The swing.
    pub swing: String,
    /// The channel, in words.
    #[serde(flatten, with = "channel_and_said")]
    #[schemars(with = "channel_and_said::ChannelAndSaid")]
    pub channel: Message,
    /// Unit of the readings.
    pub unit: Unit,
    /// Standard deviation of the noise.
    pub noise: f64,
    /// Times from the start of the analysed part, s.
    pub t_s: Vec<f64>,
    /// Measured.
    pub measured: Vec<f64>,
    /// By the base simulation.
    pub base: Vec<f64>,
    /// By the extended one.
    pub extended: Vec<f64>,
}

pub use gyradius_base::progress::Progress;
