//! How the result was got, in plain language: swings, equations, the joint estimate, single routes
//! beside it.

use crate::digits::{NOTHING, interval, joined, rounded, signed, significant, with_u, with_unit};
use crate::markup::Markup;
use crate::source::{ReportSource, StatedFigure};
use crate::table::{list, table};
use crate::words::{self, figure, id_in, ids, plain, say};
use gyradius_base::language::{Language, minus};
use gyradius_identification::{Measurement, QuantityName, Route, SwingResult, input};

pub(super) fn write(source: &ReportSource, out: &mut Markup) {
    out.folded("method", "method", |out| {
        swings(&source.measurement, out);
        stated(&source.stated, out);
        estimate(&source.measurement, out);
        routes(&source.measurement, out);
        correlations(&source.measurement, out);
    });
}

fn swings(measurement: &Measurement, out: &mut Markup) {
    let language = out.language();
    out.element("p", &[], &out.say("swings_fitted"));
    let simulated = measurement.swings.iter().filter(|s| s.simulated);
    let simulated = ids(simulated.map(|s| &s.id), language);
    if !simulated.is_empty() {
        let text = out.tell("swings_simulated", [("swings", plain(simulated))]);
        out.element("p", &[], &text);
    }
    let about_one_axis = measurement.swings.iter().filter(|s| s.motion.is_some());
    let about_one_axis = ids(about_one_axis.map(|s| &s.id), language);
    if !about_one_axis.is_empty() {
        let text = out.tell("swings_one_motion", [("swings", plain(about_one_axis))]);
        out.element("p", &[], &text);
    }
    list(
        out,
        "",
        &measurement
            .swings
            .iter()
            .map(|swing| swing_sentence(swing, language))
            .collect::<Vec<_>>(),
    );
}

fn swing_sentence(swing: &SwingResult, language: Language) -> String {
    let id = id_in(&swing.id, language);
    let name = match swing.span_s {
        Some([start, end]) => {
            let seconds = figure(significant(end - start, 3));
            let named = [("swing", plain(id)), ("seconds", seconds)];
            say(language, "swing_of_seconds", named)
        }
        None => id,
    };
    let modes: Vec<String> = swing
        .modes
        .iter()
        .map(|m| {
            let period = language.number(&with_u(m.period_s, m.period_se_s));
            format!("{} {period} s", words::mode_text(m.mode, language))
        })
        .collect();
    if modes.is_empty() {
        return say(language, "no_period", [("swing", plain(name))]);
    }
    format!("{name}: {}.", modes.join("; "))
}

fn stated(stated: &[StatedFigure], out: &mut Markup) {
    if stated.is_empty() {
        return;
    }
    out.element("h3", &[], &out.say("stated_figures"));
    let language = out.language();
    let row = |stated: &StatedFigure| {
        let uncertain = stated.value.u > 0.0;
        let value = language.number(&with_unit(stated.value, &stated.unit));
        vec![
            words::sentence_case(&stated.what),
            if uncertain {
                value
            } else {
                say(language, "as_exact", [("value", plain(value))])
            },
            if stated.applies_to.is_empty() {
                say(language, "for_all", [])
            } else {
                ids(&stated.applies_to, language)
            },
        ]
    };
    let rows: Vec<Vec<String>> = stated.iter().map(row).collect();
    table(out, &["figure", "stated_u", "applies_to"], &rows);
}

fn estimate(measurement: &Measurement, out: &mut Markup) {
    if measurement.quantities.is_empty() {
        return;
    }
    out.element("h3", &[], &out.say("joint_estimate"));
    out.element("p", &[], &out.say("joint_estimate_is"));
}

fn routes(measurement: &Measurement, out: &mut Markup) {
    let all: Vec<(&QuantityName, &Route)> = measurement
        .alternatives
        .iter()
        .flat_map(|(key, routes)| routes.iter().map(move |r| (key, r)))
        .collect();
    if all.is_empty() {
        return;
    }
    out.element("h3", &[], &out.say("single_routes"));
    out.element("p", &[], &out.say("single_routes_are"));
    let language = out.language();
    let mut rows: Vec<(usize, Vec<String>)> = all
        .iter()
        .map(|(key, route)| {
            (
                words::rank(key),
                route_row(measurement, (key, route), language),
            )
        })
        .collect();
    rows.sort_by_key(|(rank, _)| *rank);
    let rows: Vec<Vec<String>> = rows.into_iter().map(|(_, row)| row).collect();
    table(
        out,
        &[
            "quantity",
            "route",
            "value_u",
            "less_joint",
            "equation",
            "from",
        ],
        &rows,
    );
}

fn route_row(
    measurement: &Measurement,
    (key, route): (&QuantityName, &Route),
    language: Language,
) -> Vec<String> {
    let number = |text: &str| language.number(text);
    let from = route.from.iter();
    let from: Vec<String> = from
        .map(|label| input(label).in_language(language))
        .collect();
    let unit = key.unit();
    let joint = measurement
        .quantities
        .get(key)
        .and_then(|q| q.value.scalar());
    let difference = joint.map_or(NOTHING.into(), |joint| {
        let difference = route.value - joint;
        number(&signed(difference, &rounded(difference, route.u)))
    });
    vec![
        words::quantity_name(key, language),
        words::sentence_case(&words::route(route.method, language)),
        number(&with_interval(
            key,
            route,
            &joined(&with_u(route.value, route.u), unit),
        )),
        difference,
        words::equation(route, language),
        from.join(", "),
    ]
}

/// ψ is never printed without its interval (errata to (4)).
fn with_interval(key: &QuantityName, route: &Route, value: &str) -> String {
    match key {
        QuantityName::Psi => format!("{value} ({})", interval(route.interval_95, route.u)),
        _ => value.into(),
    }
}

fn correlations(measurement: &Measurement, out: &mut Markup) {
    let language = out.language();
    let pairs: Vec<String> = measurement
        .correlations
        .iter()
        .filter(|(_, _, r)| r.is_finite())
        .map(|(a, b, r)| {
            let [one, other] = [a, b].map(|key| plain(words::quantity_inside(key, language)));
            let r = figure(minus(&format!("{r:.2}")));
            say(
                language,
                "correlation",
                [("one", one), ("other", other), ("r", r)],
            )
        })
        .collect();
    if !pairs.is_empty() {
        let text = out.tell("correlations", [("pairs", plain(pairs.join("; ")))]);
        out.element("p", &[("class", "note")], &text);
    }
}
