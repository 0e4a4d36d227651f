//! What the operator should do: which lines, which swings, how far and how long, and what that is
//! expected to give.
//!
//! | file | does |
//! |---|---|
//! | `request`, `result` | what is asked; the plan |
//! | `hull`, `means`, `wanted` | what is known of the hull, what is at hand, which uncertainty is wanted |
//! | `design`, `step` | dimensions → steps; one step |
//! | `predict` | what the steps will show and how well everything will then be known, by the machinery of a measurement |
//! | `search` | the way that reaches what is wanted with the least effort |
//! | `optimum` | dimensions at which a gyradius depends least on what is measured |
//! | `warnings`, `limits`, `words` | what to know before the first swing |
//! | `tell_apart`, `suggested` | the swing that tells two causes apart; a swing that the criticism suggests as a step |
//! | `files` | the plan as a session to fill in, and as a rig to rehearse it with |

mod design;
mod files;
mod hull;
mod limits;
mod means;
mod optimum;
mod predict;
mod request;
mod result;
mod search;
mod step;
mod suggested;
mod tell_apart;
mod wanted;
mod warnings;
mod words;

pub use files::{rig_toml, session_toml};
pub use hull::{BOAT_TYPES, BoatType, Hull, Ratios, RoughHull};
pub use means::Means;
pub use optimum::{Optima, best_length_over_depth, yaw_meets_in_phase_m};
pub use predict::{Beat, PredictedSwing, omega_u};
pub use request::{Request, plan, plan_on};
pub use result::{FORMAT, HangingAdvice, Plan, PredictedQuantity};
pub use step::{PlannedIncline, PlannedSwing, Step};
pub use suggested::suggested;
pub use tell_apart::plan_to_tell_apart;
pub use wanted::Wanted;
pub use warnings::{Warning, WarningKind};
