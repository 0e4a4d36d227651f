//! What is to be measured, and how: what a procedure starts from.

use serde::{Deserialize, Serialize};

use gyradius_planning::{Plan, Step};
use gyradius_recording::{Attachment, Body, Quantity, Session, Site};

/// What is known of the hull, and what is to be done with it, in order.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Task {
    /// Title of the session to come.
    pub title: String,
    /// The body that swings.
    pub body: Body,
    /// Where it swings.
    pub site: Site,
    /// What rides on the hull and is taken off the result.
    pub attachments: Vec<Attachment>,
    /// What to do, in this order.
    pub steps: Vec<Step>,
}

impl Task {
    /// The session without its swings.
    pub(super) fn head(&self) -> Session {
        Session {
            title: self.title.clone(),
            body: self.body.clone(),
            site: self.site.clone(),
            attachments: self.attachments.clone(),
            ..Session::default()
        }
    }
}

impl From<&Plan> for Task {
    /// What follows a plan: its steps, with the mass and the gravity that it assumes.
    fn from(plan: &Plan) -> Self {
        let body = Body {
            name: plan.title.clone(),
            mass_kg: Some(Quantity::exact(plan.hull.mass_kg)),
            length_overall_m: Some(plan.hull.length_m),
            density_kg_m3: None,
        };
        let site = Site {
            gravity_m_s2: Some(plan.means.gravity_m_s2),
            ..Site::default()
        };
        let (title, steps) = (plan.title.clone(), plan.steps.clone());
        Self {
            title,
            body,
            site,
            attachments: Vec::new(),
            steps,
        }
    }
}
