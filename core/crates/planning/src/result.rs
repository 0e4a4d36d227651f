//! The plan: what `plan --json` writes (`gyradius-plan/1`).

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::hull::Hull;
use super::means::Means;
use super::optimum::Optima;
use super::predict::PredictedSwing;
use super::step::Step;
use super::warnings::Warning;
use gyradius_base::message::Message;
use gyradius_base::message::text_and_said;
use gyradius_diagnosis::NextSwing;
use gyradius_identification::{BudgetLine, QuantityName};
use gyradius_recording::Suspension;

/// Name and version of the result's format.
pub const FORMAT: &str = "gyradius-plan/1";

/// What to do, and what it is expected to give.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Plan {
    /// `gyradius-plan/1`.
    pub format: String,
    /// What is planned for.
    pub title: String,
    /// The hull as it is assumed.
    pub hull: Hull,
    /// What is assumed to be at hand.
    pub means: Means,
    /// How to hang it, in the order of the swings.
    pub suspensions: Vec<HangingAdvice>,
    /// What to do, in order.
    pub steps: Vec<Step>,
    /// What each swing will show.
    pub predicted: Vec<PredictedSwing>,
    /// What a measurement of all of them is expected to give, by quantity.
    pub quantities: BTreeMap<QuantityName, PredictedQuantity>,
    /// Contributions of each input, largest first, with the names that a measurement gives them.
    pub budget: BTreeMap<QuantityName, Vec<BudgetLine>>,
    /// Dimensions that would serve best.
    pub optima: Optima,
    /// Time that it takes, roughly, s.
    pub effort_s: f64,
    /// The swing that tells two causes apart, where that was asked.
    pub tells_apart: Option<NextSwing>,
    /// What to know before the first swing.
    pub warnings: Vec<Warning>,
}

/// One way to hang the hull.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct HangingAdvice {
    /// Points of the square frame of Fig. 21, as Table 4 has them: `B-F`.
    pub frame_points: String,
    /// Dimensions.
    pub suspension: Suspension,
    /// What it measures, by Table 4.
    pub gives: Vec<QuantityName>,
    /// The swings made on it.
    pub swings: Vec<String>,
    /// In words.
    #[serde(flatten, with = "text_and_said")]
    #[schemars(with = "text_and_said::TextAndSaid")]
    pub message: Message,
}

/// A quantity and how well it will be known.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct PredictedQuantity {
    /// As it is assumed, m or degrees.
    pub value: f64,
    /// Standard uncertainty that the measurement is expected to have, same unit; absent where it
    /// will not determine it.
    pub u: Option<f64>,
    /// What was wanted, same unit.
    pub wanted_u: Option<f64>,
    /// Whether that is reached; absent where nothing was wanted.
    pub is_reached: Option<bool>,
}
