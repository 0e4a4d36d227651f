//! Each swing: modes, repairs, and its pictures.

use crate::digits::{NOTHING, significant, with_u};
use crate::markup::Markup;
use crate::pictures;
use crate::source::ReportSource;
use crate::table::{figures, list, table};
use crate::words;
use gyradius_base::language::minus;
use gyradius_identification::{ModeResult, SwingResult};

pub(super) fn write(source: &ReportSource, out: &mut Markup) {
    if source.measurement.swings.is_empty() {
        return;
    }
    out.within("section", &[("id", "recordings")], |out| {
        out.element("h2", &[], "Each swing");
        source
            .measurement
            .swings
            .iter()
            .for_each(|swing| one(source, swing, out));
    });
}

fn one(source: &ReportSource, swing: &SwingResult, out: &mut Markup) {
    out.within("section", &[("class", "swing")], |out| {
        out.element("h3", &[], &format!("Swing {}", swing.id));
        let said: Vec<String> = [span(swing), misfit(swing)].into_iter().flatten().collect();
        if !said.is_empty() {
            out.element("p", &[], &said.join(" "));
        }
        modes(swing, out);
        list(
            out,
            "notes",
            &swing
                .warnings
                .iter()
                .map(|text| words::sentence_case(&text.english))
                .collect::<Vec<_>>(),
        );
        repairs(swing, out);
        let mut shown = Vec::new();
        if let Some(recording) = source
            .recordings
            .iter()
            .find(|recording| recording.id == swing.id)
        {
            shown.extend(pictures::fits(recording));
            shown.extend(pictures::spectrum(recording));
        }
        shown.extend(pictures::against_amplitude(swing));
        figures(out, &shown);
    });
}

fn span(swing: &SwingResult) -> Option<String> {
    let [start, end] = swing.span_s?;
    Some(format!(
        "Free swing from {} s to {} s.",
        significant(start, 4),
        significant(end, 4)
    ))
}

/// How well the fit describes the record.
fn misfit(swing: &SwingResult) -> Option<String> {
    let ratio = swing.rms_over_noise.filter(|ratio| ratio.is_finite())?;
    let meaning = match ratio {
        r if r < 1.05 => "the fit describes the record down to its noise",
        r if r < 1.5 => {
            "a little is left that the fit does not know, and the standard errors are widened for it"
        }
        _ => {
            "something moves that the fit does not know, and the standard errors are widened for it"
        }
    };
    Some(format!(
        "The residual of all channels is {} times the noise: {meaning}.",
        significant(ratio, 3)
    ))
}

fn modes(swing: &SwingResult, out: &mut Markup) {
    if swing.modes.is_empty() {
        out.element("p", &[], "No oscillation was found.");
        return;
    }
    let heads = [
        "Mode",
        "Period at small amplitude, s",
        "Period as swung, s",
        "Decay time, s",
        "Amplitude",
        "Size",
    ];
    table(
        out,
        &heads,
        &swing.modes.iter().map(row).collect::<Vec<_>>(),
    );
}

fn row(mode: &ModeResult) -> Vec<String> {
    let unmeant = match (mode.parasitic, mode.doubtful) {
        (_, true) => " (doubtful: it may be part of the misfit)",
        (true, false) => " (not meant)",
        (false, false) => "",
    };
    let observed_u = if mode.period_se_s > 0.0 {
        mode.period_se_s
    } else {
        f64::NAN
    };
    vec![
        words::sentence_case(&format!("{}{unmeant}", words::mode_text(mode.mode))),
        with_u(mode.period_s, mode.period_se_s),
        crate::digits::rounded(mode.period_observed_s, observed_u),
        mode.decay_time_s.map_or(NOTHING.into(), |tau| {
            with_u(tau, mode.decay_time_se_s.unwrap_or(0.0))
        }),
        amplitude(mode),
        minus(&format!("{:.0}", mode.relative_db)).to_string() + " dB",
    ]
}

/// Angles read as degrees.
fn amplitude(mode: &ModeResult) -> String {
    let Some(size) = mode.amplitude else {
        return NOTHING.into();
    };
    match &*mode.amplitude_unit {
        "rad" => format!("{}°", significant(size.to_degrees(), 3)),
        "m" => format!("{} mm", significant(1e3 * size, 3)),
        "rad/s" => format!("{}°/s", significant(size.to_degrees(), 3)),
        unit => format!("{} {unit}", significant(size, 3))
            .trim_end()
            .to_string(),
    }
}

fn repairs(swing: &SwingResult, out: &mut Markup) {
    if swing.repairs.is_empty() {
        return;
    }
    out.element(
        "h4",
        &[],
        "What was wrong with the recording, and what was done",
    );
    let sentences: Vec<String> = swing
        .repairs
        .iter()
        .map(|repair| {
            let kind = words::sentence_case(words::repair(repair.kind));
            let count = if repair.count > 1 {
                format!(" ({})", repair.count)
            } else {
                String::new()
            };
            format!("{kind}{count}: {}", repair.text)
        })
        .collect();
    list(out, "notes", &sentences);
}
