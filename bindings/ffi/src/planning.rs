//! Plans.

use std::sync::Arc;

use gyradius_core::planning::{self, BOAT_TYPES, Means, Request};
use gyradius_core::procedure::Task;

use crate::as_json;
use crate::error::Result;
use crate::work::{Listener, announced};

/// What to do, and what it is expected to give.
#[derive(Debug, uniffi::Object)]
pub struct Plan {
    inner: planning::Plan,
}

impl Plan {
    /// A plan of the core.
    pub fn new(inner: planning::Plan) -> Arc<Self> {
        Arc::new(Self { inner })
    }
}

#[uniffi::export]
impl Plan {
    /// The plan for a hull of which rough figures are known: seconds.
    #[uniffi::constructor]
    pub fn make_blocking(request: Request, listener: Listener) -> Result<Arc<Self>> {
        announced(&listener, "planning", || planning::plan(&request)).map(Self::new)
    }

    /// The plan.
    pub fn result(&self) -> planning::Plan {
        self.inner.clone()
    }

    /// The `gyradius-plan/1` text.
    pub fn json(&self) -> Result<String> {
        as_json(&self.inner)
    }

    /// The `session.toml` that its swings will fill.
    pub fn session_toml(&self) -> String {
        planning::session_toml(&self.inner)
    }

    /// The rig file that rehearses it.
    pub fn rig_toml(&self) -> Result<String> {
        Ok(planning::rig_toml(&self.inner)?)
    }

    /// What a procedure that follows the plan starts from: its steps, mass and gravity.
    pub fn task(&self) -> Task {
        Task::from(&self.inner)
    }
}

/// What is at hand where nothing is said.
#[uniffi::export]
pub fn usual_means() -> Means {
    Means::default()
}

/// A request that asks for what class measurers need, of a hull of which nothing is told yet.
#[uniffi::export]
pub fn usual_plan_request() -> Request {
    Request::default()
}

/// A request from its JSON; keys that are left out have their defaults.
#[uniffi::export]
pub fn plan_request_from_json(text: &str) -> Result<Request> {
    Ok(Request::from_json(text)?)
}

/// Names of the types of boats of which rough ratios are known.
#[uniffi::export]
pub fn boat_types() -> Vec<String> {
    BOAT_TYPES.iter().map(|(name, _)| (*name).into()).collect()
}
