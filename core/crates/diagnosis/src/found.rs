//! What a search has found so far.

use super::cause_id::CauseId;
use super::fitting::Fitted;
use super::look::Look;
use super::point::{Cause, Model, Point};
use super::white::Left;

/// A fit whose last step gained more of χ² than this has not come to its end.
pub const STILL_GAINS: f64 = 1.0;

/// One round: what was tried, the best first.
#[derive(Clone)]
pub struct Round {
    pub tried: Vec<Tried>,
    pub taken: bool,
    /// Where none was taken: all first looks.
    pub looked: Option<Looked>,
}

impl Round {
    /// Nothing begins any more at what was tried, but where it has no name it may yet be taken up:
    /// of the others derivatives, most of what a fit holds, are let go.
    pub fn of(mut tried: Vec<Tried>, taken: bool, looked: Option<Looked>) -> Self {
        let named = tried.iter_mut().filter(|t| t.cause.id != CauseId::Unknown);
        named.for_each(|t| t.fitted.jacobians = vec![]);
        Self {
            tried,
            taken,
            looked,
        }
    }
}

/// First looks, and what they were made beside (without its derivatives).
#[derive(Clone)]
pub struct Looked {
    pub looks: Vec<Look>,
    pub fitted: Fitted,
}

/// What the search found.
pub struct Found<'a> {
    pub base: Fitted,
    pub base_left: Left,
    pub model: Model<'a>,
    pub fitted: Fitted,
    pub left: Left,
    pub rounds: Vec<Round>,
    /// Where the last cause was looked for.
    pub looked_from: Point,
    /// Where the fits of single swings lead.
    pub begin: Point,
}

/// A cause fitted in full beside those taken before.
#[derive(Clone)]
pub struct Tried {
    pub cause: Cause,
    /// Those taken before, and this one.
    pub causes: Vec<Cause>,
    pub fitted: Fitted,
    /// Of the logarithm of the evidence, over the model without it.
    pub gain: f64,
    /// What is left, χ² beyond noise.
    pub left: Left,
    /// Where it was looked for.
    pub from: Point,
    /// Where fits of its other forms ended, the best first.
    pub ends: Vec<Tried>,
}

impl Tried {
    /// Whether its fit used up its steps on the way.
    pub fn is_on_its_way(&self) -> bool {
        self.fitted.last_gained >= STILL_GAINS
    }
}
