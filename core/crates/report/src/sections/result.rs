//! The result: quantities, verdicts, warnings.

use super::critique;
use crate::digits::{interval, joined, percent, significant, with_u};
use crate::headline::Headline;
use crate::markup::Markup;
use crate::pictures;
use crate::source::ReportSource;
use crate::table::{figures, list, matrix};
use crate::words::{self, figure, plain};
use gyradius_base::language::Language;
use gyradius_identification::{
    COVERAGE_95, Decision, Method, QuantityName, QuantityResult, Relation, Value, Verdict,
};

pub(super) fn write(source: &ReportSource, out: &mut Markup) {
    let headline = Headline::of(source);
    out.within("section", &[("id", "result")], |out| {
        out.element("h2", &[], &out.say("result"));
        out.within("div", &[("class", "columns")], |out| {
            out.within("div", &[], |out| {
                quantities(&headline, out);
                verdicts(&headline, out);
                if let Some(criticism) = source.criticised() {
                    critique::verdict(&criticism.critique, out);
                }
                warnings(source, out);
            });
            figures(out, pictures::rig(source).as_slice());
        });
        tensor(&headline, out);
    });
}

fn quantities(headline: &Headline, out: &mut Markup) {
    let all = &headline.quantities;
    let mut keys: Vec<&QuantityName> = all.keys().filter(|key| is_listed(&all[*key])).collect();
    if keys.is_empty() {
        out.element("p", &[], &out.say("no_inertia"));
        return;
    }
    keys.sort_by_key(|key| (words::rank(key), *key));
    out.within("div", &[("class", "scroll")], |out| {
        out.within("table", &[("class", "result")], |out| {
            out.raw("<thead><tr>");
            for head in ["quantity", "value_u", "interval"] {
                out.element("th", &[], &out.say(head));
            }
            if !headline.replaced.is_empty() {
                out.element("th", &[], &out.say("base_simulation"));
            }
            out.raw("</tr></thead>");
            out.within("tbody", &[], |out| {
                keys.iter().for_each(|key| quantity(out, key, headline))
            });
        });
    });
    out.element("p", &[("class", "note")], &out.say("u_is"));
    if !headline.replaced.is_empty() {
        out.element("p", &[("class", "note")], &out.say("values_extended"));
    }
}

/// Numbers and triples; a tensor has a table of its own.
fn is_listed(quantity: &QuantityResult) -> bool {
    let is_tensor = matches!(quantity.value, Value::Matrix(_));
    quantity.value.is_finite() && !is_tensor
}

fn quantity(out: &mut Markup, key: &QuantityName, headline: &Headline) {
    let (quantity, language) = (&headline.quantities[key], out.language());
    if !matches!(quantity.value, Value::Scalar(_)) {
        return triple(out, key, headline);
    }
    out.within("tr", &[], |out| {
        out.within("th", &[], |out| {
            out.write(&words::quantity_name(key, language));
            if let Some(sign) = words::symbol(key) {
                out.write(" ");
                symbol(out, sign);
            }
        });
        out.element(
            "td",
            &[("class", "value")],
            &value_text(key, quantity, language),
        );
        let u = quantity.u.scalar().unwrap_or(0.0);
        let bounds = quantity.interval_95.map_or(String::new(), |bounds| {
            language.number(&interval(bounds, u))
        });
        out.element("td", &[("class", "interval")], &bounds);
        if !headline.replaced.is_empty() {
            let base = headline
                .replaced
                .get(key)
                .map_or(String::new(), |base| value_text(key, base, language));
            out.element("td", &[("class", "base")], &base);
        }
    });
}

/// One row for each axis.
fn triple(out: &mut Markup, key: &QuantityName, headline: &Headline) {
    let name = if *key == QuantityName::PrincipalGyradii {
        out.say("about_principal")
    } else {
        words::quantity_name(key, out.language())
    };
    let language = out.language();
    let base = headline.replaced.get(key).map(pairs).unwrap_or_default();
    let values = pairs(&headline.quantities[key])
        .into_iter()
        .zip(["x", "y", "z"]);
    for (i, ((value, u), axis)) in values.enumerate() {
        out.within("tr", &[], |out| {
            out.element("th", &[], &format!("{name} {axis}"));
            out.element(
                "td",
                &[("class", "value")],
                &language.number(&joined(&with_u(value, u), key.unit())),
            );
            let half = COVERAGE_95 * u;
            out.element(
                "td",
                &[("class", "interval")],
                &language.number(&interval([value - half, value + half], u)),
            );
            if !headline.replaced.is_empty() {
                let base = base
                    .get(i)
                    .map_or(String::new(), |(value, u)| with_u(*value, *u));
                out.element(
                    "td",
                    &[("class", "base")],
                    &language.number(&joined(&base, key.unit())),
                );
            }
        });
    }
}

/// A symbol with its index set low.
fn symbol(out: &mut Markup, symbol: &str) {
    let (letter, index) = symbol.split_once('_').unwrap_or((symbol, ""));
    out.within("var", &[], |out| {
        out.write(letter);
        if !index.is_empty() {
            out.element("sub", &[], index);
        }
    });
}

fn value_text(key: &QuantityName, quantity: &QuantityResult, language: Language) -> String {
    let pairs: Vec<String> = pairs(quantity)
        .into_iter()
        .map(|(value, u)| language.number(&with_u(value, u)))
        .collect();
    joined(&pairs.join(", "), key.unit())
}

/// Values with their uncertainties, whatever the shape.
fn pairs(quantity: &QuantityResult) -> Vec<(f64, f64)> {
    flat(&quantity.value)
        .into_iter()
        .zip(flat(&quantity.u).into_iter().chain(std::iter::repeat(0.0)))
        .collect()
}

/// Numbers of a value, whatever its shape; NaN where one is not finite.
fn flat(value: &Value) -> Vec<f64> {
    let known = |number: &f64| Some(*number).filter(|v| v.is_finite());
    let numbers = value.numbers().iter();
    numbers.map(|v| known(v).unwrap_or(f64::NAN)).collect()
}

fn verdicts(headline: &Headline, out: &mut Markup) {
    for verdict in &headline.verdicts {
        let word = verdict.verdict.name();
        let class = format!("verdict {word}");
        out.within("p", &[("class", &class)], |out| {
            out.element("strong", &[], &out.say(word));
            out.write(&format!(": {}", verdict_text(headline, verdict, out)));
        });
    }
}

fn verdict_text(headline: &Headline, verdict: &Verdict, out: &Markup) -> String {
    let unit = verdict.quantity.unit();
    let measured = headline.quantities.get(&verdict.quantity);
    let value = measured.and_then(|q| Some((q.value.scalar()?, q.u.scalar()?)));
    let relation = out.say(match verdict.relation {
        Relation::AtLeast => "at_least",
        Relation::AtMost => "at_most",
    });
    let language = out.language();
    let asked = [
        (
            "quantity",
            plain(words::quantity_inside(&verdict.quantity, language)),
        ),
        ("relation", plain(relation)),
        (
            "limit",
            figure(format!("{} {unit}", significant(verdict.limit, 6))),
        ),
    ];
    let asked = out.tell("asked", asked);
    let asked = match value {
        Some((v, u)) => {
            let found = figure(format!("{} {unit}", with_u(v, u)));
            out.tell(
                "asked_measured",
                [("asked", plain(asked)), ("measured", found)],
            )
        }
        None => asked,
    };
    let probability = percent(verdict.conformance_probability, language);
    let named = [
        ("asked", plain(asked)),
        (
            "guard_band",
            figure(format!("{} {unit}", significant(verdict.guard_band, 2))),
        ),
        ("percent", plain(probability)),
    ];
    let judged = out.tell("judged", named);
    match verdict.verdict {
        Decision::Pass | Decision::Fail => judged,
        Decision::Undecided => format!("{judged} {}", out.say("neither_way")),
    }
}

/// The tensor about the centre of mass, and the correlations of the scalars.
fn tensor(headline: &Headline, out: &mut Markup) {
    let Some(inertia) = headline.quantities.get(&QuantityName::Inertia) else {
        return;
    };
    let (values, us) = (flat(&inertia.value), flat(&inertia.u));
    if values.len() != 9 {
        return;
    }
    let u = |i: usize| us.get(i).copied().unwrap_or(0.0);
    let rows: Vec<Vec<String>> = ["x", "y", "z"]
        .iter()
        .enumerate()
        .map(|(i, axis)| {
            let cells = (0..3).map(|j| with_u(values[3 * i + j], u(3 * i + j)));
            let cells = cells.map(|cell| out.language().number(&cell));
            std::iter::once(axis.to_string()).chain(cells).collect()
        })
        .collect();
    out.element("h3", &[], &out.say("tensor"));
    matrix(out, ["", "x", "y", "z"], &rows);
    if !headline.replaced.is_empty() && !headline.replaced.contains_key(&QuantityName::Inertia) {
        out.element("p", &[("class", "note")], &out.say("by_base"));
    }
    if inertia.method == Method::JointEstimateAlongHullAxes {
        out.element("p", &[("class", "note")], &out.say("no_products"));
    }
}

fn warnings(source: &ReportSource, out: &mut Markup) {
    let warnings = &source.measurement.warnings;
    if warnings.is_empty() {
        return;
    }
    out.within("div", &[("class", "warnings")], |out| {
        out.element("h3", &[], &out.say("to_be_read"));
        let sentences: Vec<String> = warnings
            .iter()
            .map(|text| words::sentence_case(&text.in_language(out.language())))
            .collect();
        list(out, "", &sentences);
    });
}
