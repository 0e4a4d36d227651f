//! What the simulation gets wrong, why, and what mending it gains.

use std::collections::BTreeSet;

use crate::digits::{NOTHING, joined, percent, rounded, sigmas, signed, significant, with_u};
use crate::markup::Markup;
use crate::pictures;
use crate::source::ReportSource;
use crate::table::{figures, list, table};
use crate::words::{self, figure, id_in, plain, say};
use gyradius_base::language::Language;
use gyradius_base::message;
use gyradius_diagnosis::{
    CauseResult, Criticism, Critique, Discrepancy, LearnedForce, ModelResult, NextSwing,
    ParameterId, ParameterResult, Status,
};
use gyradius_identification::{QuantityName, QuantityResult, Value};

/// Discrepancies that are worth a row; the rest is in the JSON.
const MOST_DISCREPANCIES: usize = 10;
/// A parameter less certain than so many times its size is not determined.
const UNDETERMINED: f64 = 3.0;

pub(super) fn write(source: &ReportSource, out: &mut Markup) {
    let Some(criticism) = &source.criticism else {
        return;
    };
    out.folded("critique", "critique", |out| match criticism {
        Ok(criticism) => written(criticism, out),
        Err(reason) => {
            let text = out.tell("no_critique", [("reason", plain(reason))]);
            out.element("p", &[], &text);
        }
    });
}

fn written(criticism: &Criticism, out: &mut Markup) {
    let critique = &criticism.critique;
    verdict(critique, out);
    warnings(critique, out);
    causes(critique, out);
    misfit(critique, out);
    if !is_adequate(critique) {
        gain(critique, out);
        quantities(critique, out);
    }
    learned(critique.learned.as_ref(), out);
    next_swing(critique.verdict.next_swing.as_ref(), out);
    discrepancies(&critique.discrepancies, out);
    if !criticism.traces.is_empty() {
        out.element("h3", &[], &out.say("against_simulated"));
        let shown = pictures::against_simulations(&criticism.traces, out.language());
        figures(out, &shown);
    }
}

/// True where nothing is missing: both simulations are one.
fn is_adequate(critique: &Critique) -> bool {
    critique.verdict.status == Status::Adequate
}

pub(super) fn verdict(critique: &Critique, out: &mut Markup) {
    let (word, class) = match critique.verdict.status {
        Status::Adequate => ("nothing_missing", "verdict pass"),
        Status::Explained => ("explained", "verdict pass"),
        Status::Ambiguous => ("ambiguous", "verdict undecided"),
        Status::Unexplained => ("unexplained", "verdict fail"),
    };
    out.within("p", &[("class", class)], |out| {
        out.element("strong", &[], &out.say(word));
        let sentence = critique.verdict.message.in_language(out.language());
        if !sentence.is_empty() {
            out.write(&format!(". {}", words::sentence_case(&sentence)));
        }
    });
}

fn warnings(critique: &Critique, out: &mut Markup) {
    let sentences: Vec<String> = critique
        .warnings
        .iter()
        .map(|text| words::sentence_case(&text.in_language(out.language())))
        .collect();
    list(out, "notes", &sentences);
}

fn causes(critique: &Critique, out: &mut Markup) {
    if critique.causes.is_empty() {
        return;
    }
    out.element("h3", &[], &out.say("causes_tried"));
    out.element("p", &[], &out.say("causes_tried_how"));
    let language = out.language();
    let rows: Vec<Vec<String>> = critique
        .causes
        .iter()
        .map(|cause| cause_row(critique, cause, language))
        .collect();
    let heads = [
        "cause",
        "probability",
        "log_evidence",
        "what_and_how_strong",
    ];
    table(out, &heads, &rows);
    figures(out, pictures::causes(critique, language).as_slice());
}

fn cause_row(critique: &Critique, cause: &CauseResult, language: Language) -> Vec<String> {
    let name = words::cause(cause.id, language);
    let name = match (
        cause.taken,
        critique.verdict.indistinguishable_from.contains(&cause.id),
    ) {
        (true, _) => say(language, "cause_taken", [("cause", plain(name))]),
        (false, true) => say(language, "cause_not_told_apart", [("cause", plain(name))]),
        (false, false) => name,
    };
    let parameters = cause.parameters.iter();
    let figures: Vec<String> = parameters.map(|one| parameter(one, language)).collect();
    let text = cause.message.in_language(language);
    let text = Some(text.trim_end_matches('.').to_string()).filter(|text| !text.is_empty());
    let said: Vec<String> = text
        .into_iter()
        .chain(Some(figures.join("; ")).filter(|f| !f.is_empty()))
        .collect();
    vec![
        words::sentence_case(&name),
        format!("{} %", percent(cause.probability, language)),
        language.number(&signed(
            cause.log_evidence_gain,
            &significant(cause.log_evidence_gain, 3),
        )),
        words::sentence_case(&said.join(": ")),
    ]
}

/// `yaw torque coefficient 12.10 ± 0.30 N m s²`.
fn parameter((id, parameter): (&ParameterId, &ParameterResult), language: Language) -> String {
    let name = words::parameter(*id, parameter.unit, language);
    // An uncertainty that is no number determines nothing either.
    if parameter.u <= UNDETERMINED * parameter.value.abs() {
        let figure = joined(
            &with_u(parameter.value, parameter.u),
            &words::unit_text(parameter.unit),
        );
        format!("{name} {}", language.number(&figure))
    } else {
        say(language, "not_determined", [("name", plain(name))])
    }
}

fn misfit(critique: &Critique, out: &mut Markup) {
    out.element("h3", &[], &out.say("how_much_is_left"));
    let language = out.language();
    let ratio = |value: Option<f64>| {
        value.map_or(NOTHING.into(), |value| {
            language.number(&significant(value, 3))
        })
    };
    let row = |name: &str, model: &ModelResult| {
        vec![
            say(language, name, []),
            ratio(model.rms_over_noise),
            ratio(model.heldout_rms_over_noise),
        ]
    };
    let mut rows = vec![row("base_simulation", &critique.baseline)];
    if !is_adequate(critique) {
        rows.push(row("extended_simulation", &critique.extended));
    }
    table(
        out,
        &["residual_over_noise", "samples_fitted", "samples_held_out"],
        &rows,
    );
}

fn gain(critique: &Critique, out: &mut Markup) {
    let gained = critique.gain.heldout_rms_ratio.map(|ratio| {
        let times = figure(significant(ratio, 3));
        out.tell("residual_smaller", [("times", times)])
    });
    let score = critique.gain.log_score_per_sample.map(|gain| {
        let gain = figure(significant(gain, 2));
        out.tell("log_density_grows", [("gain", gain)])
    });
    let said: Vec<String> = [gained, score].into_iter().flatten().collect();
    if !said.is_empty() {
        out.element("p", &[], &said.join(" "));
    }
}

fn quantities(critique: &Critique, out: &mut Markup) {
    let language = out.language();
    let (base, extended) = (&critique.baseline.quantities, &critique.extended.quantities);
    let mut keys: Vec<&QuantityName> = base
        .keys()
        .chain(extended.keys())
        .collect::<BTreeSet<_>>()
        .into_iter()
        .collect();
    keys.sort_by_key(|key| words::rank(key));
    let rows: Vec<Vec<String>> = keys
        .into_iter()
        .flat_map(|key| quantity_rows(key, [base.get(key), extended.get(key)], language))
        .collect();
    if rows.is_empty() {
        return;
    }
    out.element("h3", &[], &out.say("body_before_and_after"));
    table(
        out,
        &["quantity", "base_u", "extended_u", "shift", "shift_over_u"],
        &rows,
    );
}

/// One row for a number, one for each axis of a triple; a tensor has none.
fn quantity_rows(
    key: &QuantityName,
    both: [Option<&QuantityResult>; 2],
    language: Language,
) -> Vec<Vec<String>> {
    let [base, extended] = both.map(elements);
    let of = words::quantity_name(key, language);
    let count = base.len().max(extended.len());
    let name = |i: usize| match count {
        1 => of.clone(),
        _ => format!("{of} {}", ["x", "y", "z"][i]),
    };
    (0..count)
        .map(|i| quantity_row(key.unit(), [base.get(i), extended.get(i)]))
        .map(|cells| cells.map(|cell| language.number(&cell)))
        .enumerate()
        .map(|(i, cells)| std::iter::once(name(i)).chain(cells).collect())
        .collect()
}

/// Value and uncertainty of a number, or of each axis of a triple.
fn elements(quantity: Option<&QuantityResult>) -> Vec<(f64, f64)> {
    let Some(quantity) = quantity else {
        return vec![];
    };
    match (quantity.value, quantity.u) {
        (value @ Value::Scalar(number), u) if value.is_finite() => {
            vec![(number, u.scalar().unwrap_or(f64::NAN))]
        }
        (value @ Value::Vector(numbers), Value::Vector(us)) if value.is_finite() => {
            numbers.into_iter().zip(us).collect()
        }
        _ => vec![],
    }
}

type Figure = (f64, f64);

fn quantity_row(unit: &str, [base, extended]: [Option<&Figure>; 2]) -> [String; 4] {
    let text = |figure: Option<&Figure>| {
        figure.map_or(NOTHING.into(), |(value, u)| {
            joined(&with_u(*value, *u), unit)
        })
    };
    let shift = base
        .zip(extended)
        .map(|(base, extended)| (extended.0 - base.0, base.1));
    [
        text(base),
        text(extended),
        shift.map_or(NOTHING.into(), |(shift, u)| {
            joined(&signed(shift, &rounded(shift, u)), unit)
        }),
        shift.map_or(NOTHING.into(), |(shift, u)| sigmas(shift.abs() / u)),
    ]
}

fn learned(force: Option<&LearnedForce>, out: &mut Markup) {
    let Some(force) = force else { return };
    out.element("h3", &[], &out.say("unknown_force"));
    out.element(
        "p",
        &[],
        &words::sentence_case(&force.message.in_language(out.language())),
    );
    if !force.equation.is_empty() {
        out.within("p", &[], |out| {
            out.write(&format!("{} ", out.say("simplest_equation")));
            out.element("strong", &[], &force.equation);
        });
    }
    let left = |with: &str, value: Option<f64>| {
        value.map(|v| out.tell(with, [("ratio", figure(significant(v, 3)))]))
    };
    let figures_left: Vec<String> = [
        left("with_the_force", force.heldout_rms_over_noise),
        left("with_the_equation", force.closed_heldout_rms_over_noise),
    ]
    .into_iter()
    .flatten()
    .collect();
    if !figures_left.is_empty() {
        let ratios = plain(figures_left.join(", "));
        let text = out.tell("left_of_samples_held_out", [("ratios", ratios)]);
        out.element("p", &[], &text);
    }
    let picture = pictures::learned_force(force, out.language());
    figures(out, picture.as_slice());
}

fn next_swing(next: Option<&NextSwing>, out: &mut Markup) {
    let Some(next) = next else { return };
    out.element("h3", &[], &out.say("next_swing"));
    let language = out.language();
    let sentence = next.message.in_language(language);
    if !sentence.is_empty() {
        out.element("p", &[], &words::sentence_case(&sentence));
    }
    let row = |key: &str, value: String| vec![say(language, key, []), value];
    let number = |key: &str, value: f64, unit: &str| {
        row(key, language.number(&joined(&significant(value, 4), unit)))
    };
    let excited = next.excited.iter();
    let excited = excited
        .filter_map(|one| message::name(&format!("inertia.motion.{}", one.name()), language));
    let rows = [
        row("hung_like", id_in(&next.like, language)),
        number("next_line_length", next.line_length_m, "m"),
        number("next_spacing", next.spacing_m, "m"),
        number("bow_up_angle", next.hull_pitch_deg, "°"),
        row("set_going", excited.collect::<Vec<_>>().join(", ")),
        number("release_angle", next.amplitude_deg, "°"),
        number("recording_length", next.duration_s, "s"),
        row(
            "causes_then_differ",
            language.number(&format!("{} σ", sigmas(next.sigma))),
        ),
    ];
    table(out, &["what", "set_to"], &rows);
}

fn discrepancies(all: &[Discrepancy], out: &mut Markup) {
    if all.is_empty() {
        return;
    }
    out.element("h3", &[], &out.say("discrepancies"));
    out.element("p", &[], &out.say("discrepancies_are"));
    let language = out.language();
    let shown = &all[..all.len().min(MOST_DISCREPANCIES)];
    table(
        out,
        &["of_swing", "what", "size", "significance", "in_words"],
        &shown
            .iter()
            .map(|one| row(one, language))
            .collect::<Vec<_>>(),
    );
    let rest = all.len() - shown.len();
    if rest > 0 {
        let text = out.tell("and_more", [("count", plain(rest.to_string()))]);
        out.element("p", &[("class", "note")], &text);
    }
}

fn row(found: &Discrepancy, language: Language) -> Vec<String> {
    vec![
        if found.swing.is_empty() {
            say(language, "between_swings", [])
        } else {
            id_in(&found.swing, language)
        },
        words::sentence_case(&words::discrepancy(found.what, language)),
        language.number(&joined(
            &significant(found.size, 3),
            &words::unit_text(found.unit),
        )),
        language.number(&format!("{} σ", sigmas(found.sigma))),
        words::sentence_case(&found.message.in_language(language)),
    ]
}
