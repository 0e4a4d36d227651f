//! A swing against both simulations, and what each leaves of it in units of the noise.

use super::Figure;
use crate::chart::{Mark, Panel, colour, stacked};
use crate::digits::significant;
use crate::scale::extent;
use crate::source::Curve;
use crate::thin::thinned;
use crate::words::{figure, id_in, plain, say};
use gyradius_base::language::Language;
use gyradius_diagnosis::SwingTrace;

/// Cycles in a close-up.
const CLOSE_UP_CYCLES: usize = 4;

/// One picture for each swing that was fitted.
pub(crate) fn against_simulations(traces: &[SwingTrace], language: Language) -> Vec<Figure> {
    traces
        .iter()
        .enumerate()
        .map(|(i, trace)| picture(i, trace, language))
        .collect()
}

fn picture(i: usize, trace: &SwingTrace, language: Language) -> Figure {
    let curves = Curves::of(trace);
    let channel = trace.channel.in_language(language);
    let title = format!("{}: {channel}", id_in(&trace.swing, language));
    let svg = stacked(&title, &curves.panels(language), language);
    let noise = figure(format!("{} {}", significant(trace.noise, 2), trace.unit));
    let caption = say(language, "simulations_are", [("noise", noise)]);
    Figure::new(
        &format!("critique-{}-{}", i + 1, trace.swing),
        title,
        caption,
        svg,
    )
}

/// Curves to draw.
struct Curves {
    unit: String,
    whole: [Curve; 3],
    close_up: [Curve; 3],
    before: Curve,
    after: Curve,
    /// One noise above and below zero.
    band: [Curve; 2],
}

impl Curves {
    fn of(trace: &SwingTrace) -> Self {
        let all = |from: usize, to: usize| {
            [&trace.measured, &trace.base, &trace.extended]
                .map(|y| thinned(part(&trace.t_s, from, to), part(y, from, to)))
        };
        let (from, to) = worst(trace);
        let ends = extent(trace.t_s.iter().copied());
        Self {
            unit: trace.unit.to_string(),
            whole: all(0, trace.t_s.len()),
            close_up: all(from, to),
            before: over_noise(trace, &trace.base),
            after: over_noise(trace, &trace.extended),
            band: [-1.0, 1.0].map(|y| Curve::of(ends.into_iter().flatten().map(|t| (t, y)))),
        }
    }

    fn panels(&self, language: Language) -> Vec<Panel<'_>> {
        let heading = |key: &str| say(language, key, [("unit", plain(&self.unit))]);
        let time = || say(language, "time_s", []);
        let mut panels = vec![
            overlaid(heading("whole_record"), &self.whole, language),
            residual(
                say(language, "left_by_base", []),
                &self.before,
                &self.band,
                colour::SECOND,
            ),
        ];
        // Where nothing was missing there is but one simulation.
        if self.whole[1] != self.whole[2] {
            panels.push(residual(
                say(language, "left_by_extended", []),
                &self.after,
                &self.band,
                colour::MODEL,
            ));
        }
        if let Some(last) = panels.last_mut() {
            last.x_label = time();
        }
        let close_up = overlaid(heading("where_worst"), &self.close_up, language);
        panels.push(Panel {
            x_label: time(),
            ..close_up
        });
        panels
    }
}

/// A curve as a line.
fn line<'a>(curve: &'a Curve, colour: &'static str, width: f64) -> Mark<'a> {
    Mark::Line {
        x: &curve.x,
        y: &curve.y,
        colour,
        width,
    }
}

fn overlaid(
    heading: String,
    [measured, base, extended]: &[Curve; 3],
    language: Language,
) -> Panel<'_> {
    Panel {
        heading,
        legend: vec![
            (colour::MEASURED, say(language, "measured", [])),
            (colour::SECOND, say(language, "base", [])),
            (colour::MODEL, say(language, "extended", [])),
        ],
        x_label: String::new(),
        x_range: None,
        log_y: false,
        height: 90.0,
        marks: vec![
            line(measured, colour::MEASURED, 3.0),
            line(base, colour::SECOND, 0.9),
            line(extended, colour::MODEL, 0.9),
        ],
    }
}

fn residual<'a>(
    heading: String,
    curve: &'a Curve,
    band: &'a [Curve; 2],
    colour: &'static str,
) -> Panel<'a> {
    Panel {
        heading,
        legend: vec![],
        x_label: String::new(),
        x_range: None,
        log_y: false,
        // High enough for ticks on both sides of zero.
        height: 110.0,
        marks: vec![
            line(curve, colour, 0.7),
            line(&band[0], colour::INK, 0.8),
            line(&band[1], colour::INK, 0.8),
        ],
    }
}

/// Samples from one place to another, as far as there are any.
fn part(samples: &[f64], from: usize, to: usize) -> &[f64] {
    samples.get(from..to.min(samples.len())).unwrap_or_default()
}

fn over_noise(trace: &SwingTrace, simulated: &[f64]) -> Curve {
    let left: Vec<f64> = trace
        .measured
        .iter()
        .zip(simulated)
        .map(|(y, model)| (y - model) / trace.noise)
        .collect();
    thinned(&trace.t_s, &left)
}

/// The few cycles in which the base simulation is furthest off.
fn worst(trace: &SwingTrace) -> (usize, usize) {
    let samples = trace.measured.len();
    let length = (CLOSE_UP_CYCLES * samples / cycles(&trace.base).max(1)).clamp(1, samples.max(1));
    let misfit = |from: &usize| -> f64 {
        let range = *from..(from + length).min(samples);
        range
            .map(|i| (trace.measured[i] - trace.base.get(i).unwrap_or(&f64::NAN)).powi(2))
            .sum()
    };
    let last = samples.saturating_sub(length);
    let starts = (0..=last).step_by(length);
    let from = starts
        .max_by(|a, b| misfit(a).total_cmp(&misfit(b)))
        .unwrap_or(0);
    (from, from + length)
}

/// Cycles of a curve about its mean.
fn cycles(y: &[f64]) -> usize {
    let mean = y.iter().sum::<f64>() / y.len().max(1) as f64;
    y.windows(2)
        .filter(|pair| pair[0] < mean && pair[1] >= mean)
        .count()
}
