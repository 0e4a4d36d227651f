//! Which event is which action.

use std::collections::BTreeSet;

use super::event::{Event, Measured};
use super::state::Action;
use gyradius_recording::Quantity;

/// The action that an event is; none for what happens without the operator.
pub(super) fn action_of(event: &Event) -> Option<Action> {
    match event {
        Event::Begin { .. } => Some(Action::Begin),
        Event::SetReference => Some(Action::SetReference),
        Event::Accept => Some(Action::Accept),
        Event::Repeat => Some(Action::Repeat),
        Event::Skip => Some(Action::Skip),
        Event::Measured(_) => Some(Action::Measured),
        Event::StartRecording { .. } => Some(Action::StartRecording),
        Event::StopRecording => Some(Action::StopRecording),
        Event::Continue => Some(Action::Continue),
        Event::Keep => Some(Action::Keep),
        Event::Reopen { .. } => Some(Action::Reopen),
        Event::Retry => Some(Action::Retry),
        Event::Samples(_)
        | Event::SensorStopped { .. }
        | Event::SlipSeen { .. }
        | Event::DiskFull
        | Event::Tick { .. } => None,
    }
}

/// An action as JSON names it.
pub(super) fn name_of(action: Action) -> String {
    serde_json::to_value(action)
        .ok()
        .and_then(|name| name.as_str().map(String::from))
        .unwrap_or_default()
}

impl Measured {
    /// What of it holds of a hanging that differs in these figures.
    pub(super) fn but_for(self, differences: &BTreeSet<String>) -> Self {
        let same =
            |key: &str, measured: Option<Quantity>| measured.filter(|_| !differences.contains(key));
        let is_same_way = ["hull_pitch_deg", "hull_roll_deg", "points_moved"]
            .iter()
            .all(|key| !differences.contains(*key));
        let turned = |measured: Option<Quantity>| measured.filter(|_| is_same_way);
        Self {
            line_length_m: same("line_length", self.line_length_m),
            spacing_m: same("spacing", self.spacing_m),
            top_spacing_m: same("top_spacing", self.top_spacing_m),
            hull_pitch_deg: turned(self.hull_pitch_deg),
            points_moved_m: turned(self.points_moved_m),
            axis_height_m: same("axis_height", self.axis_height_m),
            ..Self::default()
        }
    }

    /// What is absent here is taken from an earlier measurement of the same.
    pub(super) fn over(self, earlier: Option<Self>) -> Self {
        let earlier = earlier.unwrap_or_default();
        Self {
            line_length_m: self.line_length_m.or(earlier.line_length_m),
            spacing_m: self.spacing_m.or(earlier.spacing_m),
            top_spacing_m: self.top_spacing_m.or(earlier.top_spacing_m),
            hull_pitch_deg: self.hull_pitch_deg.or(earlier.hull_pitch_deg),
            points_moved_m: self.points_moved_m.or(earlier.points_moved_m),
            axis_height_m: self.axis_height_m.or(earlier.axis_height_m),
            mass_kg: self.mass_kg.or(earlier.mass_kg),
            arm_m: self.arm_m.or(earlier.arm_m),
            depth_m: self.depth_m.or(earlier.depth_m),
        }
    }
}
