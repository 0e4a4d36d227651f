//! The result: quantities, verdicts, warnings.

use crate::digits::{interval, joined, percent, significant, with_u};
use crate::headline::Headline;
use crate::markup::Markup;
use crate::source::ReportSource;
use crate::table::{list, matrix};
use crate::words;
use gyradius_identification::{COVERAGE_95, QuantityResult, Value, Verdict};

pub(super) fn write(source: &ReportSource, out: &mut Markup) {
    let headline = Headline::of(source);
    out.within("section", &[("id", "result")], |out| {
        out.element("h2", &[], "Result");
        quantities(&headline, out);
        verdicts(&headline, out);
        warnings(source, out);
        tensor(&headline, out);
    });
}

fn quantities(headline: &Headline, out: &mut Markup) {
    let all = &headline.quantities;
    let mut keys: Vec<&String> = all.keys().filter(|key| is_listed(&all[*key])).collect();
    if keys.is_empty() {
        let text = "The swings do not determine any inertia: below are the modes that were found.";
        out.element("p", &[], text);
        return;
    }
    keys.sort_by_key(|key| (words::rank(key), key.to_string()));
    out.within("div", &[("class", "scroll")], |out| {
        out.within("table", &[("class", "result")], |out| {
            out.raw("<thead><tr><th>Quantity</th><th>Value ± u</th><th>95 % interval</th>");
            out.raw(if headline.replaced.is_empty() {
                ""
            } else {
                "<th>Base simulation</th>"
            });
            out.raw("</tr></thead>");
            out.within("tbody", &[], |out| {
                keys.iter().for_each(|key| quantity(out, key, headline))
            });
        });
    });
    let note = "u is one standard uncertainty: every input and what inputs share is counted. The interval holds the true \
                value with a probability of 95 %, provided that what is stated below is true.";
    out.element("p", &[("class", "note")], note);
    if !headline.replaced.is_empty() {
        let note = "The simulation of a hull on its lines was found wanting. The values are those of the simulation with what was \
                    found to be missing; the last column is without it. What was found stands below.";
        out.element("p", &[("class", "note")], note);
    }
}

/// Numbers and triples; a tensor has a table of its own.
fn is_listed(quantity: &QuantityResult) -> bool {
    let is_tensor = matches!(quantity.value, Value::Matrix(_));
    quantity.value.is_finite() && !is_tensor
}

fn quantity(out: &mut Markup, key: &str, headline: &Headline) {
    let quantity = &headline.quantities[key];
    if !matches!(quantity.value, Value::Scalar(_)) {
        return triple(out, key, headline);
    }
    out.within("tr", &[], |out| {
        out.within("th", &[], |out| {
            out.write(&words::quantity_name(key));
            if let Some(words) = words::quantity(key) {
                out.write(" ");
                symbol(out, words.symbol);
            }
        });
        out.element("td", &[("class", "value")], &value_text(key, quantity));
        let u = quantity.u.scalar().unwrap_or(0.0);
        let bounds = quantity
            .interval_95
            .map_or(String::new(), |bounds| interval(bounds, u));
        out.element("td", &[("class", "interval")], &bounds);
        if !headline.replaced.is_empty() {
            let base = headline
                .replaced
                .get(key)
                .map_or(String::new(), |base| value_text(key, base));
            out.element("td", &[("class", "base")], &base);
        }
    });
}

/// One row for each axis.
fn triple(out: &mut Markup, key: &str, headline: &Headline) {
    let name = if key == "principal_gyradii_m" {
        "Gyradius about principal".into()
    } else {
        words::quantity_name(key)
    };
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
                &joined(&with_u(value, u), words::unit_of(key)),
            );
            let half = COVERAGE_95 * u;
            out.element(
                "td",
                &[("class", "interval")],
                &interval([value - half, value + half], u),
            );
            if !headline.replaced.is_empty() {
                let base = base
                    .get(i)
                    .map_or(String::new(), |(value, u)| with_u(*value, *u));
                out.element(
                    "td",
                    &[("class", "base")],
                    &joined(&base, words::unit_of(key)),
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

fn value_text(key: &str, quantity: &QuantityResult) -> String {
    let pairs: Vec<String> = pairs(quantity)
        .into_iter()
        .map(|(value, u)| with_u(value, u))
        .collect();
    joined(&pairs.join(", "), words::unit_of(key))
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
        let word = match &*verdict.verdict {
            "pass" => "Pass",
            "fail" => "Fail",
            _ => "Undecided",
        };
        let class = format!("verdict {}", word.to_lowercase());
        out.within("p", &[("class", &class)], |out| {
            out.element("strong", &[], word);
            out.write(&format!(": {}", verdict_text(headline, verdict)));
        });
    }
}

fn verdict_text(headline: &Headline, verdict: &Verdict) -> String {
    let unit = words::unit_of(&verdict.quantity);
    let measured = headline.quantities.get(&verdict.quantity);
    let value = measured.and_then(|q| Some((q.value.scalar()?, q.u.scalar()?)));
    let relation = match &*verdict.relation {
        ">=" => "at least",
        "<=" => "at most",
        other => other,
    };
    let asked = format!(
        "{} asked to be {relation} {} {unit}",
        words::quantity_name(&verdict.quantity).to_lowercase(),
        significant(verdict.limit, 6)
    );
    let found = value.map_or(String::new(), |(v, u)| {
        format!(", measured {} {unit}", with_u(v, u))
    });
    let explained = match &*verdict.verdict {
        "pass" | "fail" => "",
        _ => " The limit lies within the guard band: neither can be stated with confidence.",
    };
    format!(
        "{asked}{found}; guard band {} {unit}, probability that the hull conforms {} %.{explained}",
        significant(verdict.guard_band, 2),
        percent(verdict.conformance_probability)
    )
}

/// The tensor about the centre of mass, and the correlations of the scalars.
fn tensor(headline: &Headline, out: &mut Markup) {
    let Some(inertia) = headline.quantities.get("inertia_kg_m2") else {
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
            std::iter::once(axis.to_string()).chain(cells).collect()
        })
        .collect();
    out.element(
        "h3",
        &[],
        "Inertia about the centre of mass, hull axes, kg m²",
    );
    matrix(out, &["", "x", "y", "z"], &rows);
    if !headline.replaced.is_empty() && !headline.replaced.contains_key("inertia_kg_m2") {
        out.element("p", &[("class", "note")], "By the base simulation.");
    }
    if inertia.method.contains("taken as principal") {
        let text =
            "The products of inertia were not measured: the hull's axes are taken as principal.";
        out.element("p", &[("class", "note")], text);
    }
}

fn warnings(source: &ReportSource, out: &mut Markup) {
    let warnings = &source.measurement.warnings;
    if warnings.is_empty() {
        return;
    }
    out.within("div", &[("class", "warnings")], |out| {
        out.element("h3", &[], "To be read with the result");
        let sentences: Vec<String> = warnings
            .iter()
            .map(|text| words::sentence_case(&text.english))
            .collect();
        list(out, "", &sentences);
    });
}
