//! The report's pictures.

mod amplitude;
mod budget;
mod causes;
mod court;
mod ellipsoid;
mod force;
mod recording;
mod simulations;

pub(super) use amplitude::against_amplitude;
pub(super) use budget::budgets;
pub(super) use causes::causes;
pub(super) use court::{MOST_ROWS, court};
pub(super) use ellipsoid::{ellipsoids, no_ellipsoid_reason};
pub(super) use force::learned_force;
pub(super) use recording::{fits, spectrum};
pub(super) use simulations::against_simulations;

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
