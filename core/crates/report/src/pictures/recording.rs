//! A recording: the fit over the data with the residual below on its own scale, and the spectrum
//! with its modes named.

use super::Figure;
use crate::chart::{Mark, Panel, colour, stacked};
use crate::digits::significant;
use crate::source::{Curve, RecordingFigureData, SpectrumFigureData, Trace};

/// A spectrum is shown up to this multiple of its highest named line.
const BEYOND_LAST_PEAK: f64 = 3.0;

/// Fit and residual of each channel shown.
pub(crate) fn fits(recording: &RecordingFigureData) -> Vec<Figure> {
    let fit = |(i, trace): (usize, &Trace)| {
        let title = format!("{}: {}", recording.id, trace.label);
        let svg = stacked(&title, &panels(trace));
        Figure::new(
            &format!("{}-fit-{}", recording.id, i + 1),
            title,
            caption(trace),
            svg,
        )
    };
    recording.traces.iter().enumerate().map(fit).collect()
}

fn panels(trace: &Trace) -> Vec<Panel<'_>> {
    let overlaid = |heading: &str, measured, model, height| Panel {
        heading: heading.into(),
        legend: vec![(colour::MEASURED, "measured"), (colour::MODEL, "fit")],
        x_label: "",
        x_range: None,
        log_y: false,
        height,
        marks: vec![
            line(measured, colour::MEASURED, 2.6),
            line(model, colour::MODEL, 0.9),
        ],
    };
    let whole = overlaid(
        &format!("whole record, {}", trace.unit),
        &trace.measured,
        &trace.model,
        130.0,
    );
    let residual = Panel {
        heading: format!("what the fit leaves, {}", trace.unit),
        legend: vec![],
        x_label: "time, s",
        marks: vec![line(&trace.residual, colour::MUTED, 0.7)],
        height: 70.0,
        ..overlaid("", &trace.measured, &trace.model, 0.0)
    };
    let mut panels = vec![whole, residual];
    if let Some([measured, model]) = &trace.close_up {
        panels.push(Panel {
            x_label: "time, s",
            ..overlaid(&format!("close up, {}", trace.unit), measured, model, 90.0)
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

fn caption(trace: &Trace) -> String {
    let text = "Damped oscillations, shared by all channels, over the data; below, what they leave, on its own scale.";
    match trace.noise.filter(|noise| noise.is_finite()) {
        Some(noise) => format!(
            "{text} Noise of one sample: {} {}.",
            significant(noise, 2),
            trace.unit
        ),
        None => text.into(),
    }
}

/// The spectrum, where there is one.
pub(crate) fn spectrum(recording: &RecordingFigureData) -> Option<Figure> {
    let data = recording.spectrum.as_ref()?;
    let title = format!("{}: spectrum of {}", recording.id, data.label);
    let mut marks = vec![line(&data.amplitude, colour::MODEL, 1.2)];
    let mut legend = vec![(colour::MODEL, "measured")];
    if let Some(residual) = &data.residual {
        marks.push(line(residual, colour::MEASURED, 1.0));
        legend.push((colour::MEASURED, "residual"));
    }
    marks.push(Mark::Names {
        x: data
            .peaks
            .iter()
            .map(|peak| (peak.freq_hz, peak.name.clone()))
            .collect(),
    });
    let panel = Panel {
        heading: format!("amplitude, {}", data.unit),
        legend,
        x_label: "frequency, Hz",
        x_range: range_hz(data),
        log_y: true,
        height: 170.0,
        marks,
    };
    let caption = "Amplitude of a sinusoid at each frequency, on a logarithmic scale. The lines with names are the modes \
                   that the fit found."
        .to_string();
    let svg = stacked(&title, &[panel]);
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
