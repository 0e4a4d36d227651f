//! The force that was learned from the data, against where and how fast the hull moved, and when.

use super::Figure;
use crate::chart::{Mark, Panel, colour, stacked};
use crate::scale::{drawable, extent};
use crate::words::{self, say};
use gyradius_base::language::Language;
use gyradius_diagnosis::{ForceCoordinate, LearnedForce};

/// The picture; none without points.
pub(crate) fn learned_force(force: &LearnedForce, language: Language) -> Option<Figure> {
    let points: Vec<&[f64; 5]> = force.points.iter().filter(|p| drawable(p[3])).collect();
    let column = |i: usize| -> Vec<f64> { points.iter().map(|p| p[i]).collect() };
    let (f, u) = (column(3), column(4));
    let labels = match force.coordinate {
        ForceCoordinate::Surge | ForceCoordinate::Sway | ForceCoordinate::All => {
            ["displacement_m", "velocity_m_s", "time_s"]
        }
        ForceCoordinate::Yaw
        | ForceCoordinate::Pitch
        | ForceCoordinate::PitchInPhase
        | ForceCoordinate::PitchOutOfPhase
        | ForceCoordinate::Roll
        | ForceCoordinate::RollInPhase
        | ForceCoordinate::RollOutOfPhase
        | ForceCoordinate::Compound
        | ForceCoordinate::Other => ["angle_rad", "turn_rate_rad_s", "time_s"],
    };
    let columns: Vec<(Vec<f64>, &'static str)> = (0..3)
        .map(column)
        .zip(labels)
        .filter(|(x, _)| varies(x))
        .collect();
    if columns.is_empty() {
        return None;
    }
    let heading = format!(
        "{}, {}",
        words::force(force.coordinate, language),
        words::unit_text(force.unit)
    );
    let panels: Vec<Panel> = columns
        .iter()
        .map(|(x, x_label)| panel(heading.clone(), say(language, x_label, []), [x, &f, &u]))
        .collect();
    let title = say(language, "missing_force", []);
    let caption = say(language, "missing_force_is", []);
    let svg = stacked(&title, &panels, language);
    Some(Figure::new("critique-force", title, caption, svg))
}

fn panel<'a>(heading: String, x_label: String, [x, y, u]: [&'a [f64]; 3]) -> Panel<'a> {
    Panel {
        heading,
        legend: vec![],
        x_label,
        x_range: None,
        log_y: false,
        height: 100.0,
        marks: vec![Mark::Points {
            x,
            y,
            u,
            colour: colour::MODEL,
        }],
    }
}

/// True of a column that is worth an axis.
fn varies(x: &[f64]) -> bool {
    extent(x.iter().copied()).is_some_and(|[low, high]| high > low)
}
