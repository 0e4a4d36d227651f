//! The report's pictures.

mod amplitude;
mod budget;
mod causes;
mod consistency;
mod ellipsoid;
mod force;
mod periods;
mod recording;
mod rig;
mod simulations;

use amplitude::against_amplitude;
use periods::periods;
use recording::{fits, spectrum};

use crate::source::ReportSource;
use gyradius_identification::SwingResult;

pub(super) use budget::budgets;
pub(super) use causes::causes;
pub(super) use consistency::{MOST_ROWS, consistency};
pub(super) use ellipsoid::{ellipsoids, no_ellipsoid_reason};
pub(super) use force::learned_force;
pub(super) use rig::rig;
pub(super) use simulations::against_simulations;

/// The pictures of one swing: its recording, its listed periods, its modes against amplitude.
pub(super) fn of_swing(source: &ReportSource, swing: &SwingResult) -> Vec<Figure> {
    let language = source.language;
    let mut all = Vec::new();
    let recording = source.recordings.iter().find(|one| one.id == swing.id);
    if let Some(recording) = recording {
        all.extend(fits(recording, language));
        all.extend(spectrum(recording, language));
    }
    let list = source.periods.iter().find(|one| one.id == swing.id);
    if let (Some(list), Some(trend)) = (list, &swing.trend) {
        all.extend(periods(list, trend, language));
    }
    all.extend(against_amplitude(swing, language));
    all
}

/// A picture with what is said below it.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Unique in the report; letters, digits and hyphens.
    pub id: String,
    /// What is shown.
    pub title: String,
    /// How to read it.
    pub caption: String,
    /// The picture, a whole SVG.
    pub svg: String,
}

impl Figure {
    fn new(id: &str, title: String, caption: String, svg: String) -> Self {
        let id = id
            .chars()
            .map(|c| if c.is_ascii_alphanumeric() { c } else { '-' })
            .collect();
        Self {
            id,
            title,
            caption,
            svg,
        }
    }
}
