//! How the result was got, in plain language: swings, equations, the joint estimate, single routes
//! beside it.

use crate::digits::{NOTHING, interval, joined, rounded, signed, significant, with_u, with_unit};
use crate::markup::Markup;
use crate::source::{ReportSource, StatedFigure};
use crate::table::{list, table};
use crate::words;
use gyradius_identification::{Measurement, Route, SwingResult};

pub(super) fn write(source: &ReportSource, out: &mut Markup) {
    out.within("section", &[("id", "method")], |out| {
        out.element("h2", &[], "How it was got");
        swings(&source.measurement, out);
        stated(&source.stated, out);
        estimate(&source.measurement, out);
        routes(&source.measurement, out);
        correlations(&source.measurement, out);
    });
}

fn swings(measurement: &Measurement, out: &mut Markup) {
    let text = "The body hung on lines, was set swinging and let go. Each recording was fitted with damped oscillations \
                shared by all channels, their number decided from the data; each oscillation was named by the shape \
                of the motion.";
    out.element("p", &[], text);
    let simulated: Vec<&str> = measurement
        .swings
        .iter()
        .filter(|s| s.simulated)
        .map(|s| &*s.id)
        .collect();
    if !simulated.is_empty() {
        let text = format!(
            "Then the full motion of the hull on its lines was simulated and fitted to the samples themselves, all of these \
             swings together: {}. Their periods below are those of the fitted hull at small amplitude.",
            simulated.join(", ")
        );
        out.element("p", &[], &text);
    }
    list(
        out,
        "",
        &measurement
            .swings
            .iter()
            .map(swing_sentence)
            .collect::<Vec<_>>(),
    );
}

fn swing_sentence(swing: &SwingResult) -> String {
    let span = swing.span_s.map_or(String::new(), |[start, end]| {
        format!(" ({} s of free swing)", significant(end - start, 3))
    });
    let modes: Vec<String> = swing
        .modes
        .iter()
        .map(|m| {
            format!(
                "{} {} s",
                words::mode_text(m.mode),
                with_u(m.period_s, m.period_se_s)
            )
        })
        .collect();
    if modes.is_empty() {
        return format!("{}{span}: no period was found.", swing.id);
    }
    format!("{}{span}: {}.", swing.id, modes.join("; "))
}

fn stated(stated: &[StatedFigure], out: &mut Markup) {
    if stated.is_empty() {
        return;
    }
    out.element("h3", &[], "Stated figures");
    let row = |figure: &StatedFigure| {
        let uncertain = figure.value.u > 0.0;
        let value = with_unit(figure.value, &figure.unit);
        vec![
            words::sentence_case(&figure.what),
            if uncertain {
                value
            } else {
                format!("{value} (as exact)")
            },
            if figure.applies_to.is_empty() {
                "all".into()
            } else {
                figure.applies_to.join(", ")
            },
        ]
    };
    table(
        out,
        &["Figure", "Stated ± u", "For"],
        &stated.iter().map(row).collect::<Vec<_>>(),
    );
}

fn estimate(measurement: &Measurement, out: &mut Markup) {
    if measurement.quantities.is_empty() {
        return;
    }
    out.element("h3", &[], "The joint estimate");
    let text = "Swings, dimensions and angles were then fitted together: one body, one gravity, one tape. Each figure \
                weighs by its uncertainty, and what several figures share is counted once, with its correlation. Where \
                no simulation was fitted, the periods of small, undamped swings enter.";
    out.element("p", &[], text);
}

fn routes(measurement: &Measurement, out: &mut Markup) {
    let all: Vec<(&String, &Route)> = measurement
        .alternatives
        .iter()
        .flat_map(|(key, routes)| routes.iter().map(move |r| (key, r)))
        .collect();
    if all.is_empty() {
        return;
    }
    out.element("h3", &[], "Single routes beside it");
    let text = "Each route uses few of the figures and the equations of the paper whose numbers stand beside it. Routes \
                are shown as a check; they take no further part.";
    out.element("p", &[], text);
    let mut rows: Vec<(usize, Vec<String>)> = all
        .iter()
        .map(|(key, route)| (words::rank(key), route_row(measurement, key, route)))
        .collect();
    rows.sort_by_key(|(rank, _)| *rank);
    let rows: Vec<Vec<String>> = rows.into_iter().map(|(_, row)| row).collect();
    table(
        out,
        &[
            "Quantity",
            "Route",
            "Value ± u",
            "Less joint",
            "Equation",
            "From",
        ],
        &rows,
    );
}

fn route_row(measurement: &Measurement, key: &str, route: &Route) -> Vec<String> {
    let unit = words::unit_of(key);
    let joint = measurement
        .quantities
        .get(key)
        .and_then(|q| q.value.scalar());
    let difference = joint.map_or(NOTHING.into(), |joint| {
        let difference = route.value - joint;
        signed(difference, &rounded(difference, route.u))
    });
    vec![
        words::quantity_name(key),
        words::sentence_case(&words::route(&route.method)),
        with_interval(key, route, &joined(&with_u(route.value, route.u), unit)),
        difference,
        route.equation.clone(),
        route.from.join(", "),
    ]
}

/// ψ is never printed without its interval (errata to (4)).
fn with_interval(key: &str, route: &Route, value: &str) -> String {
    match key {
        "psi_deg" => format!("{value} ({})", interval(route.interval_95, route.u)),
        _ => value.into(),
    }
}

fn correlations(measurement: &Measurement, out: &mut Markup) {
    let pairs: Vec<String> = measurement
        .correlations
        .iter()
        .filter(|(_, _, r)| r.is_finite())
        .map(|(a, b, r)| {
            let value = gyradius_base::language::minus(&format!("{r:.2}"));
            format!("{} and {} {value}", name(a), name(b))
        })
        .collect();
    if !pairs.is_empty() {
        let text = format!("Correlations of the results: {}.", pairs.join("; "));
        out.element("p", &[("class", "note")], &text);
    }
}

fn name(key: &str) -> String {
    words::quantity_name(key).to_lowercase()
}
