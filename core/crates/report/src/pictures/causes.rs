//! Causes by their probability, as bars.

use super::Figure;
use crate::chart::{self, WIDTH, colour, rectangle, shortened, text};
use crate::digits::percent;
use crate::markup::Markup;
use crate::words;
use gyradius_diagnosis::{CauseResult, Critique};

const MOST_BARS: usize = 12;
const ROW: f64 = 32.0;
const BAR: f64 = 9.0;
const VALUE_WIDTH: f64 = 96.0;

/// The picture; none where no cause was tried.
pub(crate) fn causes(critique: &Critique) -> Option<Figure> {
    if critique.causes.is_empty() {
        return None;
    }
    let shown = &critique.causes[..critique.causes.len().min(MOST_BARS)];
    let mut body = Markup::default();
    for (i, cause) in shown.iter().enumerate() {
        draw_bar(&mut body, ROW * i as f64, cause);
    }
    let title = "Probability of each cause".to_string();
    let caption =
        "Of the causes tried in its place, that it is this one. Blue: in the extended simulation.";
    let svg = chart::svg(&title, ROW * shown.len() as f64 + 2.0, body);
    Some(Figure::new("critique-causes", title, caption.into(), svg))
}

fn draw_bar(out: &mut Markup, top: f64, cause: &CauseResult) {
    let share = if cause.probability.is_finite() {
        cause.probability.clamp(0.0, 1.0)
    } else {
        0.0
    };
    let fill = if cause.taken {
        colour::MODEL
    } else {
        colour::MEASURED
    };
    let label = words::sentence_case(&words::cause(cause.id));
    text(
        out,
        0.0,
        top + 13.0,
        "start",
        colour::INK,
        &shortened(&label, WIDTH - VALUE_WIDTH),
    );
    text(
        out,
        WIDTH,
        top + 13.0,
        "end",
        colour::MUTED,
        &format!("{} %", percent(cause.probability)),
    );
    rectangle(out, (0.0, top + 18.0), (WIDTH, BAR), "#eef1f4");
    rectangle(out, (0.0, top + 18.0), (WIDTH * share, BAR), fill);
}
