//! The consistency tests as dots and whiskers: how far each implied figure lies from the stated
//! one.

use super::Figure;
use crate::chart::{self, WIDTH, colour, dashed, dot, line, number, rectangle, text};
use crate::digits::sigmas;
use crate::markup::Markup;
use crate::words::{self, say};
use gyradius_base::language::Language;
use gyradius_identification::Claim;

/// Rows shown; all that are flagged are among them, for the claims come with the largest difference
/// first.
pub(crate) const MOST_ROWS: usize = 14;
/// Where the axis ends, standard uncertainties; what lies beyond is drawn as an arrow with its
/// figure.
const END_SIGMA: f64 = 6.0;
const ROW: f64 = 42.0;
const TOP: f64 = 2.0;
const LEFT: f64 = 10.0;
const RIGHT: f64 = WIDTH - 58.0;

/// The picture; none without claims.
pub(crate) fn consistency(claims: &[Claim], language: Language) -> Option<Figure> {
    if claims.is_empty() {
        return None;
    }
    let rows = &claims[..claims.len().min(MOST_ROWS)];
    let bottom = TOP + ROW * rows.len() as f64;
    let mut body = Markup::in_language(language);
    draw_axis(&mut body, bottom);
    for (i, claim) in rows.iter().enumerate() {
        draw_row(&mut body, claim, TOP + ROW * i as f64);
    }
    let caption = say(language, "consistency_dots", []);
    let title = say(language, "stated_against_implied", []);
    let svg = chart::svg(&title, bottom + 38.0, body);
    Some(Figure::new("consistency-tests", title, caption, svg))
}

fn place(sigma: f64) -> f64 {
    let share = (sigma.clamp(-END_SIGMA, END_SIGMA) + END_SIGMA) / (2.0 * END_SIGMA);
    LEFT + share * (RIGHT - LEFT)
}

fn draw_axis(out: &mut Markup, bottom: f64) {
    line(out, (LEFT, bottom), (RIGHT, bottom), colour::MUTED, 1.0);
    for sigma in [-6, -3, 0, 3, 6] {
        let x = place(f64::from(sigma));
        line(out, (x, bottom), (x, bottom + 4.0), colour::MUTED, 1.0);
        let label = match sigma {
            0 => out.say("as_stated"),
            s if s < 0 => format!("−{}", -s),
            s => format!("+{s}"),
        };
        text(out, x, bottom + 16.0, "middle", colour::MUTED, &label);
    }
    let label = out.say("implied_less_stated");
    text(
        out,
        place(0.0),
        bottom + 32.0,
        "middle",
        colour::MUTED,
        &label,
    );
}

/// The lane in which a dot moves: grey where it agrees, a line where the report speaks up.
fn draw_lane(out: &mut Markup, y: f64) {
    let (top, bottom) = (y - 8.0, y + 8.0);
    line(out, (LEFT, y), (RIGHT, y), colour::GRID, 1.0);
    rectangle(
        out,
        (place(-2.0), top),
        (place(2.0) - place(-2.0), bottom - top),
        "#e9edf1",
    );
    line(
        out,
        (place(0.0), top),
        (place(0.0), bottom),
        colour::MUTED,
        1.0,
    );
    for sigma in [-3.0, 3.0] {
        dashed(
            out,
            (place(sigma), top),
            (place(sigma), bottom),
            colour::FLAG,
            0.8,
            "3 3",
        );
    }
}

fn draw_row(out: &mut Markup, claim: &Claim, top: f64) {
    let fill = if claim.flagged {
        colour::FLAG
    } else {
        colour::MODEL
    };
    let sigma = if claim.sigma.is_finite() {
        claim.sigma.abs()
    } else {
        0.0
    };
    let signed = if claim.implied < claim.stated {
        -sigma
    } else {
        sigma
    };
    let y = top + 27.0;
    draw_lane(out, y);
    text(
        out,
        LEFT,
        top + 13.0,
        "start",
        colour::INK,
        &label(claim, out.language()),
    );
    let figure = if claim.sigma.is_finite() {
        out.language().number(&format!("{} σ", sigmas(sigma)))
    } else {
        "–".into()
    };
    text(out, WIDTH - 4.0, y + 4.0, "end", fill, &figure);
    if sigma > END_SIGMA {
        draw_arrow(out, signed.signum(), y, fill);
        return;
    }
    line(
        out,
        (place(signed - 1.0), y),
        (place(signed + 1.0), y),
        fill,
        1.6,
    );
    dot(out, place(signed), y, 4.0, fill);
}

/// What lies off the axis.
fn draw_arrow(out: &mut Markup, side: f64, y: f64, fill: &str) {
    let tip = place(side * END_SIGMA);
    let back = tip - side * 9.0;
    line(out, (tip - side * 26.0, y), (back, y), fill, 1.6);
    let corners = [(tip, y), (back, y - 5.0), (back, y + 5.0)];
    let points: Vec<String> = corners
        .iter()
        .map(|(x, y)| format!("{},{}", number(*x), number(*y)))
        .collect();
    out.empty("polygon", &[("points", &points.join(" ")), ("fill", fill)]);
}

fn label(claim: &Claim, language: Language) -> String {
    let whole = format!(
        "{} · {}",
        words::sentence_case(&words::claim_name(&claim.claim, language)),
        words::claim_from(claim, language)
    );
    chart::shortened(&whole, WIDTH - LEFT)
}
