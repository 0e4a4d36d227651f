//! What is to be measured, and how: what a procedure starts from.

use serde::{Deserialize, Serialize};

use crate::plan::Step;
use crate::recording::{Attachment, Body, Session, Site};

/// What is known of the hull, and what is to be done with it, in order.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
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
