//! What the simulation gets wrong, why, and what mending it gains.

use std::collections::BTreeSet;

use crate::digits::{NOTHING, joined, percent, rounded, sigmas, signed, significant, with_u};
use crate::markup::Markup;
use crate::pictures;
use crate::source::ReportSource;
use crate::table::{figures, list, table};
use crate::words;
use gyradius_diagnosis::{
    CauseResult, Criticism, Critique, Discrepancy, LearnedForce, ModelResult, NextSwing,
    ParameterId, ParameterResult, Status,
};
use gyradius_identification::{QuantityResult, Value};

/// Discrepancies that are worth a row; the rest is in the JSON.
const MOST_DISCREPANCIES: usize = 10;
/// A parameter less certain than so many times its size is not determined.
const UNDETERMINED: f64 = 3.0;

pub(super) fn write(source: &ReportSource, out: &mut Markup) {
    let Some(criticism) = &source.criticism else {
        return;
    };
    out.within("section", &[("id", "critique")], |out| {
        out.element("h2", &[], "What the simulation gets wrong, and why");
        match criticism {
            Ok(criticism) => written(criticism, out),
            Err(reason) => {
                let text =
                    format!("There is no criticism of the simulation for this session: {reason}.");
                out.element("p", &[], &text);
            }
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
        out.element("h3", &[], "Measured against simulated");
        figures(out, &pictures::against_simulations(&criticism.traces));
    }
}

/// True where nothing is missing: both simulations are one.
fn is_adequate(critique: &Critique) -> bool {
    critique.verdict.status == Status::Adequate
}

fn verdict(critique: &Critique, out: &mut Markup) {
    let (word, class) = match critique.verdict.status {
        Status::Adequate => ("Nothing is missing", "verdict pass"),
        Status::Explained => ("Explained", "verdict pass"),
        Status::Ambiguous => ("Ambiguous", "verdict undecided"),
        Status::Unexplained => ("Unexplained", "verdict fail"),
    };
    out.within("p", &[("class", class)], |out| {
        out.element("strong", &[], word);
        if !critique.verdict.message.english.is_empty() {
            out.write(&format!(
                ". {}",
                words::sentence_case(&critique.verdict.message.english)
            ));
        }
    });
}

fn warnings(critique: &Critique, out: &mut Markup) {
    let sentences: Vec<String> = critique
        .warnings
        .iter()
        .map(|text| words::sentence_case(&text.english))
        .collect();
    list(out, "notes", &sentences);
}

fn causes(critique: &Critique, out: &mut Markup) {
    if critique.causes.is_empty() {
        return;
    }
    out.element("h3", &[], "The causes tried");
    let text = "Each cause was put into the simulation and fitted to the samples together with the body. Evidence counts what \
                it gains against what its freedom costs: a logarithm of 5 is odds of 150 to 1.";
    out.element("p", &[], text);
    let rows: Vec<Vec<String>> = critique
        .causes
        .iter()
        .map(|cause| cause_row(critique, cause))
        .collect();
    let heads = [
        "Cause",
        "Probability",
        "Log evidence",
        "What it is, and how strong",
    ];
    table(out, &heads, &rows);
    figures(out, pictures::causes(critique).as_slice());
}

fn cause_row(critique: &Critique, cause: &CauseResult) -> Vec<String> {
    let remark = match (
        cause.taken,
        critique.verdict.indistinguishable_from.contains(&cause.id),
    ) {
        (true, _) => " (in the extended simulation)",
        (false, true) => " (cannot be told apart)",
        (false, false) => "",
    };
    let figures: Vec<String> = cause.parameters.iter().map(parameter).collect();
    let text = Some(cause.message.english.trim_end_matches('.').to_string())
        .filter(|text| !text.is_empty());
    let said: Vec<String> = text
        .into_iter()
        .chain(Some(figures.join("; ")).filter(|f| !f.is_empty()))
        .collect();
    vec![
        words::sentence_case(&format!("{}{remark}", words::cause(cause.id))),
        format!("{} %", percent(cause.probability)),
        signed(
            cause.log_evidence_gain,
            &significant(cause.log_evidence_gain, 3),
        ),
        words::sentence_case(&said.join(": ")),
    ]
}

/// `yaw torque coefficient 12.10 ± 0.30 N m s²`.
fn parameter((id, parameter): (&ParameterId, &ParameterResult)) -> String {
    let name = words::spaced(&words::without_unit(*id, parameter.unit));
    // An uncertainty that is no number determines nothing either.
    if parameter.u <= UNDETERMINED * parameter.value.abs() {
        let figure = joined(
            &with_u(parameter.value, parameter.u),
            &words::unit_text(parameter.unit),
        );
        format!("{name} {figure}")
    } else {
        format!("{name} not determined")
    }
}

fn misfit(critique: &Critique, out: &mut Markup) {
    out.element("h3", &[], "How much is left");
    let ratio = |value: Option<f64>| value.map_or(NOTHING.into(), |value| significant(value, 3));
    let row = |name: &str, model: &ModelResult| {
        vec![
            name.to_string(),
            ratio(model.rms_over_noise),
            ratio(model.heldout_rms_over_noise),
        ]
    };
    let mut rows = vec![row("Base simulation", &critique.baseline)];
    if !is_adequate(critique) {
        rows.push(row("Extended simulation", &critique.extended));
    }
    table(
        out,
        &["Residual over noise", "Samples fitted", "Samples held out"],
        &rows,
    );
}

fn gain(critique: &Critique, out: &mut Markup) {
    let gained = critique.gain.heldout_rms_ratio.map(|ratio| {
        format!(
            "On samples that took no part in the fit the residual is {} times smaller.",
            significant(ratio, 3)
        )
    });
    let score = critique.gain.log_score_per_sample.map(|gain| {
        format!(
            "The logarithm of the density of each such sample grows by {}.",
            significant(gain, 2)
        )
    });
    let said: Vec<String> = [gained, score].into_iter().flatten().collect();
    if !said.is_empty() {
        out.element("p", &[], &said.join(" "));
    }
}

fn quantities(critique: &Critique, out: &mut Markup) {
    let (base, extended) = (&critique.baseline.quantities, &critique.extended.quantities);
    let mut keys: Vec<&String> = base
        .keys()
        .chain(extended.keys())
        .collect::<BTreeSet<_>>()
        .into_iter()
        .collect();
    keys.sort_by_key(|key| words::rank(key));
    let rows: Vec<Vec<String>> = keys
        .into_iter()
        .flat_map(|key| quantity_rows(key, base.get(key), extended.get(key)))
        .collect();
    if rows.is_empty() {
        return;
    }
    out.element("h3", &[], "The body before and after");
    table(
        out,
        &[
            "Quantity",
            "Base ± u",
            "Extended ± u",
            "Shift",
            "Shift over u",
        ],
        &rows,
    );
}

/// One row for a number, one for each axis of a triple; a tensor has none.
fn quantity_rows(
    key: &str,
    base: Option<&QuantityResult>,
    extended: Option<&QuantityResult>,
) -> Vec<Vec<String>> {
    let (base, extended) = (elements(base), elements(extended));
    let count = base.len().max(extended.len());
    let name = |i: usize| match count {
        1 => words::quantity_name(key),
        _ => format!("{} {}", words::quantity_name(key), ["x", "y", "z"][i]),
    };
    (0..count)
        .map(|i| quantity_row(name(i), words::unit_of(key), base.get(i), extended.get(i)))
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

fn quantity_row(
    name: String,
    unit: &str,
    base: Option<&Figure>,
    extended: Option<&Figure>,
) -> Vec<String> {
    let text = |figure: Option<&Figure>| {
        figure.map_or(NOTHING.into(), |(value, u)| {
            joined(&with_u(*value, *u), unit)
        })
    };
    let shift = base
        .zip(extended)
        .map(|(base, extended)| (extended.0 - base.0, base.1));
    vec![
        name,
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
    out.element("h3", &[], "The force that no known cause gives");
    out.element("p", &[], &words::sentence_case(&force.text));
    if !force.equation.is_empty() {
        out.within("p", &[], |out| {
            out.write("The simplest equation that does as well: ");
            out.element("strong", &[], &force.equation);
        });
    }
    let left = |what: &str, value: Option<f64>| {
        value.map(|v| format!("{} with {what}", significant(v, 3)))
    };
    let figures_left: Vec<String> = [
        left("the learned force", force.heldout_rms_over_noise),
        left("the equation", force.closed_heldout_rms_over_noise),
    ]
    .into_iter()
    .flatten()
    .collect();
    if !figures_left.is_empty() {
        let text = format!(
            "Residual over noise of the samples held out: {}.",
            figures_left.join(", ")
        );
        out.element("p", &[], &text);
    }
    figures(out, pictures::learned_force(force).as_slice());
}

fn next_swing(next: Option<&NextSwing>, out: &mut Markup) {
    let Some(next) = next else { return };
    out.element("h3", &[], "The next swing");
    if !next.message.english.is_empty() {
        out.element("p", &[], &words::sentence_case(&next.message.english));
    }
    let row = |name: &str, value: f64, unit: &str| {
        vec![name.into(), joined(&significant(value, 4), unit)]
    };
    let rows = [
        vec!["Hung like the swing".into(), next.like.clone()],
        row("Length of the lines", next.line_length_m, "m"),
        row("Spacing of the lines", next.spacing_m, "m"),
        row("Bow-up angle", next.hull_pitch_deg, "°"),
        vec![
            "Set going".into(),
            next.excited
                .iter()
                .map(|one| one.name())
                .collect::<Vec<_>>()
                .join(", "),
        ],
        row("Angle of the release", next.amplitude_deg, "°"),
        row("Length of the recording", next.duration_s, "s"),
        vec![
            "The causes in doubt then differ by".into(),
            format!("{} σ", sigmas(next.sigma)),
        ],
    ];
    table(out, &["What", "Set to"], &rows);
}

fn discrepancies(all: &[Discrepancy], out: &mut Markup) {
    if all.is_empty() {
        return;
    }
    out.element("h3", &[], "What shows in the data");
    let text = "Where the base simulation differs from the samples in a way that chance would not, the clearest first.";
    out.element("p", &[], text);
    let shown = &all[..all.len().min(MOST_DISCREPANCIES)];
    table(
        out,
        &["Swing", "What", "Size", "Significance", "In words"],
        &shown.iter().map(row).collect::<Vec<_>>(),
    );
    let rest = all.len() - shown.len();
    if rest > 0 {
        out.element(
            "p",
            &[("class", "note")],
            &format!("And {rest} more, in the data of this file."),
        );
    }
}

fn row(found: &Discrepancy) -> Vec<String> {
    vec![
        if found.swing.is_empty() {
            "between swings".into()
        } else {
            found.swing.clone()
        },
        words::sentence_case(&words::spaced(
            &found.what.name().replace("_vs_", " against "),
        )),
        joined(&significant(found.size, 3), &words::unit_text(found.unit)),
        format!("{} σ", sigmas(found.sigma)),
        words::sentence_case(&found.message.english),
    ]
}
