//! Which figures each kind of suspension has, by their keys in `session.toml`.

use super::names::KINDS;
use super::quantity::Quantity;
use super::session::{Orientation, Suspension, SuspensionKind};

pub(crate) const LINE_LENGTH: &str = "line_length";
pub(crate) const SPACING: &str = "spacing";
const TOP_SPACING: &str = "top_spacing";
const RADIUS: &str = "radius";
const TOP_RADIUS: &str = "top_radius";
pub(crate) const HULL_PITCH: &str = "hull_pitch_deg";
pub(crate) const HULL_ROLL: &str = "hull_roll_deg";
const POINTS_MOVED: &str = "points_moved";
const AXIS_HEIGHT: &str = "axis_height";

impl SuspensionKind {
    /// Keys of the figures that a suspension of this kind may state, in the order of a written
    /// session.
    pub fn figures(self) -> &'static [&'static str] {
        match self {
            Self::Bifilar => &[
                LINE_LENGTH,
                SPACING,
                TOP_SPACING,
                HULL_PITCH,
                HULL_ROLL,
                POINTS_MOVED,
            ],
            Self::Compound => &[HULL_PITCH, HULL_ROLL, POINTS_MOVED, AXIS_HEIGHT],
            Self::Trifilar => &[
                LINE_LENGTH,
                RADIUS,
                TOP_RADIUS,
                HULL_PITCH,
                HULL_ROLL,
                POINTS_MOVED,
            ],
            Self::Free => &[HULL_PITCH],
        }
    }

    /// Keys of the figures among them without which it cannot be measured.
    pub fn needs(self) -> &'static [&'static str] {
        match self {
            Self::Bifilar => &[LINE_LENGTH, SPACING],
            Self::Compound => &[AXIS_HEIGHT],
            Self::Trifilar => &[LINE_LENGTH, RADIUS],
            Self::Free => &[],
        }
    }

    /// Whether something joins the suspension points in a direction of its own.
    pub fn has_direction(self) -> bool {
        matches!(self, Self::Bifilar | Self::Compound)
    }

    /// Why a suspension of this kind has no figure of that key; empty where it has one.
    pub fn why_not(self, key: &str) -> String {
        if self.figures().contains(&key) {
            return String::new();
        }
        let has = |kind: &SuspensionKind| kind.figures().contains(&key);
        let names: Vec<&str> = KINDS
            .iter()
            .filter(|(_, kind)| has(kind))
            .map(|(name, _)| *name)
            .collect();
        let described = match self.needs() {
            [] => format!("of a {} one nothing is stated", self.name()),
            needs => format!(
                "a {} one is described by {}",
                self.name(),
                needs.join(" and ")
            ),
        };
        format!(
            "it belongs to a {} suspension; {described}",
            names.join(" or ")
        )
    }
}

impl Suspension {
    /// A suspension of which no figure is stated.
    pub fn unmeasured(kind: SuspensionKind, orientation: Orientation) -> Self {
        Self {
            kind,
            orientation,
            line_length_m: None,
            spacing_m: None,
            top_spacing_m: None,
            hull_pitch_deg: None,
            hull_roll_deg: None,
            points_m: None,
            points_moved_m: None,
            axis_height_m: None,
        }
    }

    /// The figure of a key, as it is stated; none of a key that its kind does not have.
    pub fn figure(&self, key: &str) -> Option<Quantity> {
        // Of a copy, so that reading and stating share one list of places.
        let mut copy = self.clone();
        let (place, scale) = copy.place(key)?;
        place.map(|figure| Quantity::new(figure.value / scale, figure.u / scale))
    }

    /// States the figure of a key; without effect for a key that its kind does not have.
    pub fn set_figure(&mut self, key: &str, figure: Option<Quantity>) {
        if let Some((place, scale)) = self.place(key) {
            *place = figure.map(|one| Quantity::new(scale * one.value, scale * one.u));
        }
    }

    /// Where a figure is kept, and what it is multiplied with to be kept there.
    fn place(&mut self, key: &str) -> Option<(&mut Option<Quantity>, f64)> {
        if !self.kind.figures().contains(&key) {
            return None;
        }
        Some(match key {
            LINE_LENGTH => (&mut self.line_length_m, 1.0),
            SPACING => (&mut self.spacing_m, 1.0),
            TOP_SPACING => (&mut self.top_spacing_m, 1.0),
            RADIUS => (&mut self.spacing_m, 2.0),
            TOP_RADIUS => (&mut self.top_spacing_m, 2.0),
            HULL_PITCH => (&mut self.hull_pitch_deg, 1.0),
            HULL_ROLL => (&mut self.hull_roll_deg, 1.0),
            POINTS_MOVED => (&mut self.points_moved_m, 1.0),
            AXIS_HEIGHT => (&mut self.axis_height_m, 1.0),
            _ => return None,
        })
    }
}
