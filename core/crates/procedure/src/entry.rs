//! What the journal keeps: every decision, in order. Everything else follows from them and the
//! recordings.

use serde::{Deserialize, Serialize};

use super::event::{Measured, PhoneInfo, Placement};
use super::judgement::Judgement;
use super::rest::Rest;
use super::state::{CritiqueView, ResultView, Work};
use super::task::Task;
use gyradius_planning::Step;

/// Name and major version of the format.
pub(super) const FORMAT: &str = "gyradius-procedure/1";

/// One line of the journal.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(tag = "entry", rename_all = "snake_case")]
#[allow(clippy::large_enum_variant)]
pub(super) enum Entry {
    Created {
        format: String,
        task: Task,
    },
    Begun {
        at_utc: String,
        #[serde(default)]
        measured_on: String,
        phone: PhoneInfo,
        placement: Placement,
    },
    /// Direction of specific force in the phone while the hull was level.
    Levelled {
        up: [f64; 3],
    },
    Rested {
        rest: Rest,
    },
    RestSkipped,
    Hung {
        step: usize,
        measured: Measured,
    },
    Started {
        step: usize,
        take: usize,
        at_utc: String,
    },
    Ended {
        step: usize,
        take: usize,
        judgement: Judgement,
    },
    Decided {
        step: usize,
        take: usize,
        accepted: bool,
    },
    Skipped {
        step: usize,
    },
    Reopened {
        step: usize,
    },
    Measured {
        result: ResultView,
    },
    Failed {
        work: Work,
        reason: String,
    },
    Retried,
    Criticised {
        critique: CritiqueView,
        suggestion: Option<Step>,
    },
    CritiqueSkipped,
    SuggestionTaken {
        step: Step,
    },
    SuggestionDeclined,
}
