//! How a swing hung, as far as the caller states it.

use std::collections::BTreeMap;

use gyradius_base::error::{Error, Result};
use gyradius_recording::{Orientation, Quantity, Suspension, SuspensionKind};

/// What is stated of how swings hung.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Hanging {
    /// The kind of suspension.
    pub kind: Option<SuspensionKind>,
    /// What joins the points.
    pub orientation: Option<Orientation>,
    /// Figures by the key that `session.toml` has for them; u is NaN where nobody states it.
    pub figures: BTreeMap<String, Quantity>,
}

impl Hanging {
    /// A suspension of which nothing else is known: two lines, athwartships.
    pub fn alone(&self) -> Result<Suspension> {
        let usual = Suspension::unmeasured(SuspensionKind::Bifilar, Orientation::Athwartships);
        self.over(&usual)
    }

    /// A suspension with what is stated in the place of its own; of another kind, it keeps the
    /// figures that both have. A figure that the kind does not have is refused.
    pub fn over(&self, base: &Suspension) -> Result<Suspension> {
        let kind = self.kind.unwrap_or(base.kind);
        for (key, figure) in &self.figures {
            let why_not = kind.why_not(key);
            if !why_not.is_empty() {
                return Err(Error::argument(
                    key,
                    format!("no figure ({why_not}; `suspension` states another kind)"),
                    figure.value,
                ));
            }
        }
        let orientation = self.orientation.unwrap_or(base.orientation);
        let mut hung = Suspension::unmeasured(kind, orientation);
        for key in kind.figures() {
            let stated = self.figures.get(*key).copied();
            hung.set_figure(key, stated.or_else(|| base.figure(key)));
        }
        // Points lie along the suspension, and say how far apart they are.
        let is_along = kind == base.kind && orientation == base.orientation;
        if is_along && !self.figures.contains_key("spacing") {
            hung.points_m = base.points_m.clone();
        }
        Ok(hung)
    }
}
