//! Each swing: modes, repairs, and its pictures.

use crate::digits::{NOTHING, significant, with_u};
use crate::markup::Markup;
use crate::pictures;
use crate::source::ReportSource;
use crate::table::{figures, list, table};
use crate::words::{self, figure, id_in, plain, say};
use gyradius_base::language::{Language, minus};
use gyradius_identification::{AmplitudeUnit, ModeResult, SwingResult};

pub(super) fn write(source: &ReportSource, out: &mut Markup) {
    if source.measurement.swings.is_empty() {
        return;
    }
    out.folded("recordings", "each_swing", |out| {
        source
            .measurement
            .swings
            .iter()
            .for_each(|swing| one(source, swing, out));
    });
}

fn one(source: &ReportSource, swing: &SwingResult, out: &mut Markup) {
    let language = source.language;
    out.within("section", &[("class", "swing")], |out| {
        out.element(
            "h3",
            &[],
            &out.tell("swing", [("id", plain(id_in(&swing.id, language)))]),
        );
        let said: Vec<String> = [span(swing, out), misfit(swing, out)]
            .into_iter()
            .flatten()
            .collect();
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
                .map(|text| words::sentence_case(&text.in_language(language)))
                .collect::<Vec<_>>(),
        );
        repairs(swing, out);
        figures(out, &pictures::of_swing(source, swing));
    });
}

fn span(swing: &SwingResult, out: &Markup) -> Option<String> {
    let [start, end] = swing.span_s?;
    let named = [
        ("start", figure(significant(start, 4))),
        ("end", figure(significant(end, 4))),
    ];
    Some(out.tell("free_swing", named))
}

/// How well the fit describes the record.
fn misfit(swing: &SwingResult, out: &Markup) -> Option<String> {
    let ratio = swing.rms_over_noise.filter(|ratio| ratio.is_finite())?;
    let key = match ratio {
        r if r < 1.05 => "misfit_none",
        r if r < 1.5 => "misfit_little",
        _ => "misfit_some",
    };
    Some(out.tell(key, [("times", figure(significant(ratio, 3)))]))
}

fn modes(swing: &SwingResult, out: &mut Markup) {
    if swing.modes.is_empty() {
        out.element("p", &[], &out.say("no_oscillation"));
        return;
    }
    let heads = [
        "mode",
        "small_period_s",
        "observed_period_s",
        "decay_time_s",
        "amplitude",
        "size",
    ];
    let language = out.language();
    let rows = swing.modes.iter().map(|mode| row(mode, language));
    table(out, &heads, &rows.collect::<Vec<_>>());
}

fn row(mode: &ModeResult, language: Language) -> Vec<String> {
    let name = words::mode_text(mode.mode, language);
    let name = match (mode.parasitic, mode.doubtful) {
        (_, true) => say(language, "mode_doubtful", [("mode", plain(name))]),
        (true, false) => say(language, "mode_not_meant", [("mode", plain(name))]),
        (false, false) => name,
    };
    let number = |text: &str| language.number(text);
    let observed_u = if mode.period_se_s > 0.0 {
        mode.period_se_s
    } else {
        f64::NAN
    };
    vec![
        words::sentence_case(&name),
        number(&with_u(mode.period_s, mode.period_se_s)),
        number(&crate::digits::rounded(mode.period_observed_s, observed_u)),
        mode.decay_time_s.map_or(NOTHING.into(), |tau| {
            number(&with_u(tau, mode.decay_time_se_s.unwrap_or(0.0)))
        }),
        number(&amplitude(mode)),
        minus(&format!("{:.0}", mode.relative_db)).to_string() + " dB",
    ]
}

/// Angles read as degrees.
fn amplitude(mode: &ModeResult) -> String {
    let Some(size) = mode.amplitude else {
        return NOTHING.into();
    };
    match mode.amplitude_unit {
        AmplitudeUnit::Radian => format!("{}°", significant(size.to_degrees(), 3)),
        AmplitudeUnit::Metre => format!("{} mm", significant(1e3 * size, 3)),
        AmplitudeUnit::RadianPerSecond => format!("{}°/s", significant(size.to_degrees(), 3)),
        AmplitudeUnit::None => significant(size, 3),
    }
}

fn repairs(swing: &SwingResult, out: &mut Markup) {
    if swing.repairs.is_empty() {
        return;
    }
    out.element("h4", &[], &out.say("repairs"));
    let sentences: Vec<String> = swing
        .repairs
        .iter()
        .map(|repair| {
            let kind = words::sentence_case(&words::repair(repair.kind, out.language()));
            let count = if repair.count > 1 {
                format!(" ({})", repair.count)
            } else {
                String::new()
            };
            format!(
                "{kind}{count}: {}",
                words::repair_text(repair, out.language())
            )
        })
        .collect();
    list(out, "notes", &sentences);
}
