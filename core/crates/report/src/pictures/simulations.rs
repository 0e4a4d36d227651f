//! A swing against both simulations, and what each leaves of it in units of the noise.

use super::Figure;
use crate::chart::{Mark, Panel, colour, stacked};
use crate::digits::significant;
use crate::scale::extent;
use crate::source::Curve;
use crate::thin::thinned;
use gyradius_diagnosis::SwingTrace;

/// Cycles in a close-up.
const CLOSE_UP_CYCLES: usize = 4;

/// One picture for each swing that was fitted.
pub(crate) fn against_simulations(traces: &[SwingTrace]) -> Vec<Figure> {
    traces
        .iter()
        .enumerate()
        .map(|(i, trace)| picture(i, trace))
        .collect()
}

fn picture(i: usize, trace: &SwingTrace) -> Figure {
    let curves = Curves::of(trace);
    let title = format!("{}: {}", trace.swing, trace.channel.english);
    let svg = stacked(&title, &curves.panels());
    let caption = format!(
        "The swing, and what each simulation leaves of it in units of the noise of one sample ({} {}); the lines stand one \
         noise either way. Last, the few cycles in which the base simulation is furthest off.",
        significant(trace.noise, 2),
        trace.unit
    );
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

    fn panels(&self) -> Vec<Panel<'_>> {
        let unit = &self.unit;
        let mut panels = vec![
            overlaid(format!("whole record, {unit}"), &self.whole),
            residual(
                "left by the base simulation, noise",
                &self.before,
                &self.band,
                colour::SECOND,
            ),
        ];
        // Where nothing was missing there is but one simulation.
        if self.whole[1] != self.whole[2] {
            panels.push(residual(
                "left by the extended one, noise",
                &self.after,
                &self.band,
                colour::MODEL,
            ));
        }
        if let Some(last) = panels.last_mut() {
            last.x_label = "time, s";
        }
        let close_up = overlaid(format!("where the base is worst, {unit}"), &self.close_up);
        panels.push(Panel {
            x_label: "time, s",
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

fn overlaid(heading: String, [measured, base, extended]: &[Curve; 3]) -> Panel<'_> {
    Panel {
        heading,
        legend: vec![
            (colour::MEASURED, "measured"),
            (colour::SECOND, "base"),
            (colour::MODEL, "extended"),
        ],
        x_label: "",
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
    heading: &str,
    curve: &'a Curve,
    band: &'a [Curve; 2],
    colour: &'static str,
) -> Panel<'a> {
    Panel {
        heading: heading.into(),
        legend: vec![],
        x_label: "",
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
