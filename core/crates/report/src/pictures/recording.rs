//! A recording: the fit over the data with the residual below on its own scale, and the spectrum
//! with its modes named.

use super::Figure;
use crate::chart::{Mark, Panel, colour, stacked};
use crate::digits::significant;
use crate::source::{Curve, RecordingFigureData, SpectrumFigureData, Trace};
use crate::words::{figure, id_in, plain, say};
use gyradius_base::language::Language;

/// A spectrum is shown up to this multiple of its highest named line.
const BEYOND_LAST_PEAK: f64 = 3.0;

/// Fit and residual of each channel shown.
pub(crate) fn fits(recording: &RecordingFigureData, language: Language) -> Vec<Figure> {
    let fit = |(i, trace): (usize, &Trace)| {
        let title = format!("{}: {}", id_in(&recording.id, language), trace.label);
        let svg = stacked(&title, &panels(trace, language), language);
        Figure::new(
            &format!("{}-fit-{}", recording.id, i + 1),
            title,
            caption(trace, language),
            svg,
        )
    };
    recording.traces.iter().enumerate().map(fit).collect()
}

fn panels(trace: &Trace, language: Language) -> Vec<Panel<'_>> {
    let name = |key: &str| say(language, key, []);
    let heading = |key: &str| say(language, key, [("unit", plain(&trace.unit))]);
    let overlaid = |heading: String, measured, model, height| Panel {
        heading,
        legend: vec![
            (colour::MEASURED, name("measured")),
            (colour::MODEL, name("fit")),
        ],
        x_label: String::new(),
        x_range: None,
        log_y: false,
        height,
        marks: vec![
            line(measured, colour::MEASURED, 2.6),
            line(model, colour::MODEL, 0.9),
        ],
    };
    let whole = overlaid(
        heading("whole_record"),
        &trace.measured,
        &trace.model,
        130.0,
    );
    let residual = Panel {
        heading: heading("fit_leaves"),
        legend: vec![],
        x_label: name("time_s"),
        marks: vec![line(&trace.residual, colour::MUTED, 0.7)],
        height: 70.0,
        ..overlaid(String::new(), &trace.measured, &trace.model, 0.0)
    };
    let mut panels = vec![whole, residual];
    if let Some([measured, model]) = &trace.close_up {
        panels.push(Panel {
            x_label: name("time_s"),
            ..overlaid(heading("close_up"), measured, model, 90.0)
        });
    }
    panels
}

fn line<'a>(curve: &'a Curve, colour: &'static str, width: f64) -> Mark<'a> {
    Mark::Line {
        x: &curve.x,
        y: &curve.y,
        colour,
        width,
    }
}

fn caption(trace: &Trace, language: Language) -> String {
    let text = say(language, "fit_is", []);
    match trace.noise.filter(|noise| noise.is_finite()) {
        Some(noise) => {
            let noise = figure(format!("{} {}", significant(noise, 2), trace.unit));
            let noise = say(language, "noise_of_a_sample", [("noise", noise)]);
            format!("{text} {noise}")
        }
        None => text,
    }
}

/// The spectrum, where there is one.
pub(crate) fn spectrum(recording: &RecordingFigureData, language: Language) -> Option<Figure> {
    let data = recording.spectrum.as_ref()?;
    let named = [
        ("swing", plain(id_in(&recording.id, language))),
        ("channel", plain(&data.label)),
    ];
    let title = say(language, "spectrum_of", named);
    let mut marks = vec![line(&data.amplitude, colour::MODEL, 1.2)];
    let mut legend = vec![(colour::MODEL, say(language, "measured", []))];
    if let Some(residual) = &data.residual {
        marks.push(line(residual, colour::MEASURED, 1.0));
        legend.push((colour::MEASURED, say(language, "residual", [])));
    }
    marks.push(Mark::Names {
        x: data
            .peaks
            .iter()
            .map(|peak| (peak.freq_hz, peak.name.clone()))
            .collect(),
    });
    let panel = Panel {
        heading: say(language, "amplitude_in", [("unit", plain(&data.unit))]),
        legend,
        x_label: say(language, "frequency_hz", []),
        x_range: range_hz(data),
        log_y: true,
        height: 170.0,
        marks,
    };
    let caption = say(language, "spectrum_is", []);
    let svg = stacked(&title, &[panel], language);
    Some(Figure::new(
        &format!("{}-spectrum", recording.id),
        title,
        caption,
        svg,
    ))
}

/// From zero to some way beyond the last named line, within what was recorded.
fn range_hz(data: &SpectrumFigureData) -> Option<[f64; 2]> {
    let top = data
        .amplitude
        .x
        .iter()
        .copied()
        .filter(|f| f.is_finite())
        .fold(0.0, f64::max);
    let last = data
        .peaks
        .iter()
        .map(|peak| peak.freq_hz)
        .filter(|f| f.is_finite())
        .fold(0.0, f64::max);
    let wanted = if last > 0.0 {
        top.min(BEYOND_LAST_PEAK * last)
    } else {
        top
    };
    (wanted > 0.0).then_some([0.0, wanted])
}
