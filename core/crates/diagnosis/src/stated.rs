//! What a stated figure is of.

use gyradius_identification::parameters::{Layout, SwingIndex};

/// What a stated figure is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stated {
    /// A length of the rig.
    Length,
    /// Gravity.
    Gravity,
    /// How far the bow is up.
    Tilt,
    /// A phone's clock.
    Clock,
    /// The body's mass, or an attachment's.
    Mass,
}

impl Stated {
    /// That of a place among a layout's parameters, all of which but masses say where they are.
    pub fn of(layout: &Layout, place: usize) -> Self {
        let of_swings = |own: fn(&SwingIndex) -> [Option<usize>; 4]| {
            let mut swings = layout.swings.iter();
            swings.any(|swing| own(swing).contains(&Some(place)))
        };
        if place == layout.gravity {
            Self::Gravity
        } else if place == layout.clock || of_swings(|s| [s.clock, None, None, None]) {
            Self::Clock
        } else if of_swings(|s| [Some(s.pitch_deg), None, None, None]) {
            Self::Tilt
        } else if of_swings(|s| [s.line_length, s.spacing, s.top_spacing, s.axis_height]) {
            Self::Length
        } else {
            Self::Mass
        }
    }
}
