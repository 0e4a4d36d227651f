//! What is not plausible in a session, and what its data cannot hold: looked for before a gyradius
//! is stated, in one place.
//!
//! A finding says what was seen, of which swing and channel, and what to do. `Refused` takes the
//! figures concerned out of the result.

mod amplitude;
mod dimensions;
mod rate;
mod recording;
mod support;
mod unused;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use gyradius_base::message::{Argument, Message, advice_and_said, text_and_said};
use gyradius_base::named;
use gyradius_recording::AssumedU;

pub(super) use amplitude::of_amplitude;
pub(super) use dimensions::{of_dimensions, of_size, unchecked};
pub(super) use recording::{
    LEAST_DESCRIBED, NOISE_MISMATCH, clear_of_limit, of_list, of_recording, of_residual,
};
pub use support::NEAR_IN_PHASE;
pub(super) use support::{
    duplicates, incline_without_mass, is_supported, near_resonance, not_one_motion, phone,
    phone_moved, undetermined, unsupported,
};

pub(super) use unused::not_used;

use super::estimate::Solution;
use super::sentences::message;

named! {
    /// What kind of thing was found.
    FindingKind: "kind" {
        /// A channel that does not change.
        ConstantChannel = "constant_channel",
        /// Stated figures that cannot all be right.
        Contradiction = "contradiction",
        /// A dimension without a stated uncertainty, which got the usual one.
        DefaultU = "default_u",
        /// Two swings with the same samples.
        DuplicateRecording = "duplicate_recording",
        /// A list of periods that are long and short by turns.
        HalfPeriods = "half_periods",
        /// A figure that no body of this size has.
        ImplausibleSize = "implausible_size",
        /// A motion too large to be a sum of damped oscillations.
        LargeAmplitude = "large_amplitude",
        /// Yaw near to the pitch in phase, which trades energy with it.
        NearResonance = "near_resonance",
        /// A residual that is not of the size of the noise.
        NoiseMismatch = "noise_mismatch",
        /// A quantity that no swing shows.
        NotIdentifiable = "not_identifiable",
        /// A phone recorded, and its mass is not among the attachments.
        PhoneMassMissing = "phone_mass_missing",
        /// A phone that was taken off and put on again between swings, or a pitch that is stated wrong.
        PhoneMoved = "phone_moved",
        /// Gyroscope and accelerometer that do not show one and the same motion.
        SensorsDisagree = "sensors_disagree",
        /// Samples at the limit of a sensor.
        Saturated = "saturated",
        /// Different samples with one stamp.
        SharedStamps = "shared_stamps",
        /// A clock that steps.
        StampStep = "stamp_step",
        /// A dimension that nothing in the session tests.
        UncheckedDimension = "unchecked_dimension",
        /// Too few samples a period to exclude a faster motion.
        Undersampled = "undersampled",
        /// A channel or a dimension that looks as if it were in another unit.
        UnitSuspect = "unit_suspect",
    }
}

named! {
    /// What a finding does to the result.
    Severity: "severity" {
        /// Nothing: a reader may want to know.
        Noted = "noted",
        /// The figures concerned are not stated.
        Refused = "refused",
        /// A reader must know.
        Warned = "warned",
        /// The uncertainty was made larger.
        Widened = "widened",
    }
}

/// Something that is not plausible, or that the data cannot hold.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Finding {
    /// What kind.
    pub kind: FindingKind,
    /// What it does to the result.
    pub severity: Severity,
    /// Of which swing; none of the session.
    pub swing: Option<String>,
    /// Of which channel or dimension, where it is one.
    pub channel: Option<String>,
    /// The numbers behind it, SI, by name.
    pub numbers: BTreeMap<String, f64>,
    /// What was found.
    #[serde(flatten, with = "text_and_said")]
    #[schemars(with = "text_and_said::TextAndSaid")]
    pub message: Message,
    /// What to do.
    #[serde(flatten, with = "advice_and_said")]
    #[schemars(with = "advice_and_said::AdviceAndSaid")]
    pub advice: Message,
}

impl Finding {
    /// Figures that are stated without an uncertainty; they got the usual one of their kind.
    pub(super) fn default_u(assumed: &[AssumedU]) -> Option<Self> {
        let first = assumed.first()?;
        let arguments = [
            ("count", Argument::Number(assumed.len() as f64, 0)),
            ("first", Argument::Plain(first.path.clone())),
            ("u", Argument::Figure(format!("{:.2e}", first.u))),
        ];
        let found = Self::new(
            (FindingKind::DefaultU, Severity::Noted),
            "default_u",
            arguments,
        );
        Some(found.with_all(assumed.iter().map(|one| (one.path.as_str(), one.u))))
    }

    /// Stated figures that cannot all be right: any one of `suspects` could be the wrong one.
    pub(super) fn contradiction(chi2: f64, dof: f64, suspects: Argument) -> Self {
        let (kind, severity) = (FindingKind::Contradiction, Severity::Widened);
        let arguments = [
            ("chi2", Argument::Number(chi2, 1)),
            ("dof", Argument::Number(dof, 1)),
            ("suspects", suspects),
        ];
        Self::new((kind, severity), "contradiction", arguments)
            .with("chi2", chi2)
            .with("dof", dof)
    }

    /// Stated figures and swings that cannot all be right, and no one of them explains it.
    pub(super) fn unexplained_contradiction(solution: &Solution) -> Self {
        let (kind, severity) = (FindingKind::Contradiction, Severity::Widened);
        let numbers = [
            ("chi2", solution.chi2),
            ("dof", solution.dof),
            ("factor", solution.birge),
        ];
        let arguments = numbers.map(|(name, value)| (name, Argument::Number(value, 1)));
        Self::new((kind, severity), "contradiction_unnamed", arguments).with_all(numbers)
    }

    /// A finding whose sentences have the keys `finding.KEY` and `advice.KEY`, with the same
    /// arguments.
    fn new<'a>(
        (kind, severity): (FindingKind, Severity),
        key: &str,
        arguments: impl IntoIterator<Item = (&'a str, Argument)>,
    ) -> Self {
        let arguments: Vec<(&str, Argument)> = arguments.into_iter().collect();
        Self {
            kind,
            severity,
            swing: None,
            channel: None,
            numbers: BTreeMap::new(),
            message: message(&format!("finding.{key}"), arguments.clone()),
            advice: message(&format!("advice.{key}"), arguments),
        }
    }

    fn of_swing(self, id: &str) -> Self {
        Self {
            swing: Some(id.to_owned()),
            ..self
        }
    }

    fn of_channel(self, channel: impl Into<String>) -> Self {
        Self {
            channel: Some(channel.into()),
            ..self
        }
    }

    fn with(mut self, name: &str, value: f64) -> Self {
        self.numbers.insert(name.to_owned(), value);
        self
    }

    fn with_all<'a>(self, numbers: impl IntoIterator<Item = (&'a str, f64)>) -> Self {
        let with = |found: Self, (name, value)| found.with(name, value);
        numbers.into_iter().fold(self, with)
    }

    /// Whether the figures concerned are not stated.
    pub fn refuses(&self) -> bool {
        self.severity == Severity::Refused
    }

    /// The finding and what to do, as one warning; none of what is only noted, and of the residual,
    /// which the analysis of the record tells.
    pub fn told(&self) -> Option<Message> {
        if self.severity == Severity::Noted || self.kind == FindingKind::NoiseMismatch {
            return None;
        }
        let texts = |message: &Message| Argument::Texts(vec![message.clone()]);
        let (what, todo) = (texts(&self.message), texts(&self.advice));
        Some(match &self.swing {
            Some(id) => message(
                "finding_of",
                [
                    ("swing", Argument::Id(id.clone())),
                    ("what", what),
                    ("todo", todo),
                ],
            ),
            None => message("finding", [("what", what), ("todo", todo)]),
        })
    }
}
