//! A list of periods against time with eq. (14), as Fig. 6 of the paper: the beat of a second motion
//! in the periods of the first.

use super::Figure;
use crate::chart::{Mark, Panel, colour, stacked};
use crate::digits::{prefix, significant, with_u};
use crate::source::PeriodsFigureData;
use crate::words::{figure, id_in, plain, say};
use gyradius_base::language::Language;
use gyradius_identification::{ModulationResult, TrendResult};

/// The periods of a swing with what they follow, and what that leaves of them.
pub(crate) fn periods(
    data: &PeriodsFigureData,
    trend: &TrendResult,
    language: Language,
) -> Option<Figure> {
    if data.listed.x.len() < 2 {
        return None;
    }
    let name = |key: &str| say(language, key, []);
    let title = say(
        language,
        "periods_of",
        [("swing", plain(id_in(&data.id, language)))],
    );
    let largest = data
        .residual
        .y
        .iter()
        .fold(0.0, |most: f64, y| most.max(y.abs()));
    let (scale, letter) = prefix(largest);
    let left: Vec<f64> = data.residual.y.iter().map(|y| scale * y).collect();
    let none = vec![0.0; left.len()];
    let curve = Panel {
        heading: name("period_s"),
        legend: vec![
            (colour::MEASURED, name("listed")),
            (colour::MODEL, name("equation_14")),
            (colour::SECOND, name("unmodulated")),
        ],
        x_label: String::new(),
        x_range: None,
        log_y: false,
        height: 130.0,
        marks: vec![
            Mark::Points {
                x: &data.listed.x,
                y: &data.listed.y,
                u: &none,
                colour: colour::MEASURED,
            },
            Mark::Line {
                x: &data.unmodulated.x,
                y: &data.unmodulated.y,
                colour: colour::SECOND,
                width: 1.2,
            },
            Mark::Line {
                x: &data.curve.x,
                y: &data.curve.y,
                colour: colour::MODEL,
                width: 1.2,
            },
        ],
    };
    let residual = Panel {
        heading: say(
            language,
            "fit_leaves",
            [("unit", plain(format!("{letter}s")))],
        ),
        legend: vec![],
        x_label: name("time_s"),
        x_range: None,
        log_y: false,
        height: 70.0,
        marks: vec![Mark::Points {
            x: &data.residual.x,
            y: &left,
            u: &none,
            colour: colour::MUTED,
        }],
    };
    let svg = stacked(&title, &[curve, residual], language);
    let caption = caption(trend, language);
    Some(Figure::new(
        &format!("{}-periods", data.id),
        title,
        caption,
        svg,
    ))
}

/// What eq. (14) has for the list: T_0, b; T_m, C, τ_m.
fn caption(trend: &TrendResult, language: Language) -> String {
    let t0 = ("t0", figure(with_u(trend.t0_s, trend.t0_se_s)));
    let mut said = vec![match trend.b_per_s {
        0.0 => say(language, "trend_steady", [t0]),
        b => {
            // Of a million.
            let drift = figure(with_u(1e6 * b, 1e6 * trend.b_se_per_s));
            say(language, "trend_drifts", [t0, ("drift", drift)])
        }
    }];
    if let Some(modulation) = &trend.modulation {
        said.push(modulated(modulation, language));
    }
    let scatter = figure(significant(1e3 * trend.scatter_s, 2));
    said.push(say(language, "trend_scatter", [("scatter", scatter)]));
    said.join(" ")
}

fn modulated(modulation: &ModulationResult, language: Language) -> String {
    let beat = figure(with_u(modulation.t_m_s, modulation.t_m_se_s));
    let size = figure(with_u(1e3 * modulation.c_s, 1e3 * modulation.c_se_s));
    let named = [("beat", beat), ("size", size)];
    match modulation.tau_m_s {
        Some(tau) => {
            let decay = ("decay", figure(significant(tau, 3)));
            say(language, "trend_beats", named.into_iter().chain([decay]))
        }
        None => say(language, "trend_beats_on", named),
    }
}
