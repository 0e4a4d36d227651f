//! Causes by their probability, as bars.

use super::Figure;
use crate::chart::{self, WIDTH, colour, rectangle, shortened, text};
use crate::digits::percent;
use crate::markup::Markup;
use crate::words::{self, say};
use gyradius_base::language::Language;
use gyradius_diagnosis::{CauseResult, Critique};

const MOST_BARS: usize = 12;
const ROW: f64 = 32.0;
const BAR: f64 = 9.0;
const VALUE_WIDTH: f64 = 96.0;

/// The picture; none where no cause was tried.
pub(crate) fn causes(critique: &Critique, language: Language) -> Option<Figure> {
    if critique.causes.is_empty() {
        return None;
    }
    let shown = &critique.causes[..critique.causes.len().min(MOST_BARS)];
    let mut body = Markup::in_language(language);
    for (i, cause) in shown.iter().enumerate() {
        draw_bar(&mut body, ROW * i as f64, cause);
    }
    let title = say(language, "cause_probabilities", []);
    let caption = say(language, "cause_probabilities_are", []);
    let svg = chart::svg(&title, ROW * shown.len() as f64 + 2.0, body);
    Some(Figure::new("critique-causes", title, caption, svg))
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
    let label = words::sentence_case(&words::cause(cause.id, out.language()));
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
        &format!("{} %", percent(cause.probability, out.language())),
    );
    rectangle(out, (0.0, top + 18.0), (WIDTH, BAR), "#eef1f4");
    rectangle(out, (0.0, top + 18.0), (WIDTH * share, BAR), fill);
}
