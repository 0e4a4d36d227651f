//! What was measured, and the lines for who signs for it.

use crate::digits::{significant, with_unit};
use crate::markup::Markup;
use crate::source::ReportSource;
use crate::words::say;

pub(super) fn write(source: &ReportSource, out: &mut Markup) {
    out.within("header", &[], |out| {
        out.element("p", &[("class", "kind")], &out.say("kind_of_document"));
        out.element("h1", &[], &title(source));
        facts(source, out);
        signing(source, out);
    });
}

/// The title, or what stands for it.
pub(crate) fn title(source: &ReportSource) -> String {
    let names = [&source.measurement.title, &source.body.name];
    names
        .into_iter()
        .find(|name| !name.trim().is_empty())
        .map_or_else(|| say(source.language, "untitled", []), String::clone)
}

fn facts(source: &ReportSource, out: &mut Markup) {
    let body = &source.body;
    let number = |text: &str| source.language.number(text);
    let mut facts: Vec<(String, String)> = Vec::new();
    if !body.name.is_empty() && body.name != title(source) {
        facts.push((out.say("body"), body.name.clone()));
    }
    if let Some(mass) = body.mass_kg {
        facts.push((out.say("mass_that_swung"), number(&with_unit(mass, "kg"))));
    }
    if let Some(length) = body.length_overall_m {
        facts.push((
            out.say("length_overall"),
            number(&format!("{} m", significant(length, 5))),
        ));
    }
    let count = source.measurement.swings.len();
    facts.push((out.say("swings"), count.to_string()));
    if let Some(date) = &source.measured_on {
        facts.push((out.say("measured_on"), date.clone()));
    }
    if !source.recorded_by.is_empty() {
        facts.push((out.say("recorded_by"), source.recorded_by.join(", ")));
    }
    if !source.generated_by.is_empty() {
        facts.push((out.say("analysed_by"), source.generated_by.clone()));
    }
    let line: Vec<String> = facts
        .into_iter()
        .map(|(name, value)| format!("{name}: {value}"))
        .collect();
    out.element("p", &[("class", "facts")], &line.join(" · "));
}

/// Blanks to sign; a table, so that it prints as lines.
fn signing(source: &ReportSource, out: &mut Markup) {
    let date = source.measured_on.as_deref().unwrap_or("");
    let blanks = [
        [out.say("measured_by"), String::new()],
        [out.say("date_and_place"), date.into()],
        [out.say("signature"), String::new()],
    ];
    out.within("table", &[("class", "sign")], |out| {
        out.within("tbody", &[], |out| {
            for [name, value] in blanks {
                out.within("tr", &[], |out| {
                    out.element("th", &[], &name);
                    out.element("td", &[], &value);
                });
            }
        });
    });
}
