//! The page around the report's parts, and all its pictures by themselves.

use serde::Serialize;

use super::headline::Headline;
use super::markup::Markup;
use super::pictures::{self, Figure};
use super::sections;
use super::source::ReportSource;
use gyradius_diagnosis::{Criticism, judged_with};

const STYLE: &str = include_str!("style.css");

/// The report as one self-contained HTML file.
pub fn html(source: &ReportSource) -> String {
    let mut out = Markup::in_language(source.language);
    out.raw("<!DOCTYPE html>\n");
    out.within("html", &[("lang", source.language.tag())], |out| {
        out.within("head", &[], |out| head(source, out));
        out.within("body", &[], |out| {
            out.within("main", &[], |out| sections::body(source, out));
            numbers(source, out);
        });
    });
    out.raw("\n");
    out.into_string()
}

fn head(source: &ReportSource, out: &mut Markup) {
    out.empty("meta", &[("charset", "utf-8")]);
    out.empty(
        "meta",
        &[
            ("name", "viewport"),
            ("content", "width=device-width, initial-scale=1"),
        ],
    );
    if !source.generated_by.is_empty() {
        out.empty(
            "meta",
            &[("name", "generator"), ("content", &source.generated_by)],
        );
    }
    out.element("title", &[], &sections::title(source));
    out.within("style", &[], |out| out.raw(STYLE));
}

/// The results as `report --json` and `critique --json` write them.
fn numbers(source: &ReportSource, out: &mut Markup) {
    match source.criticised() {
        Some(Criticism { critique, .. }) => {
            let measurement = judged_with(&source.measurement, critique);
            embedded("gyradius-measurement", &measurement, out);
            embedded("gyradius-critique", critique, out);
        }
        None => embedded("gyradius-measurement", &source.measurement, out),
    }
}

fn embedded(id: &str, result: &impl Serialize, out: &mut Markup) {
    // A result serialises whatever it holds; numbers that are none become null.
    let json = serde_json::to_string(result).unwrap_or_default();
    let attributes = [("type", "application/json"), ("id", id)];
    out.within("script", &attributes, |out| out.json(&json));
}

/// Every picture of the report, in its order.
pub fn figures(source: &ReportSource) -> Vec<Figure> {
    let (measurement, language) = (&source.measurement, source.language);
    let mut all: Vec<Figure> = pictures::rig(source).into_iter().collect();
    all.extend(pictures::consistency(&measurement.consistency, language));
    if let Some(criticism) = source.criticised() {
        all.extend(pictures::causes(&criticism.critique, language));
        all.extend(pictures::against_simulations(&criticism.traces, language));
        all.extend(
            criticism
                .critique
                .learned
                .as_ref()
                .and_then(|force| pictures::learned_force(force, language)),
        );
    }
    all.extend(pictures::budgets(measurement, language));
    for swing in &measurement.swings {
        all.extend(pictures::of_swing(source, swing));
    }
    all.extend(pictures::ellipsoids(
        &Headline::of(source).quantities,
        language,
    ));
    all
}
