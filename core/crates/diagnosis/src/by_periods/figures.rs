//! The figures of the causes of periods, and how they are told.

use std::collections::BTreeMap;

use super::causes::{CauseNumber, Shown};
use super::model::{Fitted, Setting};
use crate::parameter_id::ParameterId;
use crate::result::ParameterResult;
use crate::unit::{Unit, UnitName};
use crate::words;
use gyradius_base::message::{Argument, Message};
use gyradius_recording::Quantity;

/// Beyond this a number of a cause is told from nothing.
const TOLD: f64 = 2.0;

/// A figure with two digits of its uncertainty; a pure number has no unit.
pub fn figure(q: Quantity, unit: Unit) -> String {
    let digit = if q.u > 0.0 {
        q.u.log10().floor() as i32 - 1
    } else {
        -4
    };
    let decimals = (-digit).clamp(0, 9) as usize;
    let round = |x: f64| {
        if digit > 0 {
            (x / 10f64.powi(digit)).round() * 10f64.powi(digit)
        } else {
            x
        }
    };
    let unit = match unit {
        Unit::Of(UnitName::One) => String::new(),
        unit => unit.to_string(),
    };
    let (value, u) = (round(q.value), round(q.u));
    format!("{value:.decimals$} ± {u:.decimals$} {unit}")
        .trim_end()
        .into()
}

/// The numbers of the model's last cause, in units of the rig.
pub fn parameters(setting: &Setting, fitted: &Fitted) -> BTreeMap<ParameterId, ParameterResult> {
    shown_numbers(setting, fitted)
        .into_iter()
        .map(|(number, shown)| (number.name.into(), shown))
        .collect()
}

/// Those of its numbers that the session has something to say of.
fn shown_numbers(
    setting: &Setting,
    fitted: &Fitted,
) -> Vec<(&'static CauseNumber, ParameterResult)> {
    let Some(cause) = fitted.causes.last() else {
        return vec![];
    };
    let numbers = fitted.numbers();
    let own = &numbers[numbers.len() - cause.numbers.len()..];
    cause
        .numbers
        .iter()
        .zip(own)
        .filter(|(_, q)| q.u > 0.0 && (cause.numbers.len() == 1 || q.u < 0.9))
        .map(|(number, q)| (number, shown(setting, number, *q)))
        .collect()
}

fn shown(setting: &Setting, number: &CauseNumber, q: Quantity) -> ParameterResult {
    let scales = &setting.scales;
    let width = (number.width)(scales);
    let (value, u) = match number.shown {
        Shown::Times(factor) => (
            q.value * width * factor(scales),
            q.u * width * factor(scales),
        ),
        Shown::Over(factor) => {
            let value = factor(scales) / (q.value * width);
            (value, (value * q.u / q.value).abs())
        }
        Shown::Size => (q.value.abs() * width, q.u * width),
    };
    let unit = if number.by_mass && !scales.mass_is_known {
        Unit::ForEachKilogram(number.unit)
    } else {
        number.unit.into()
    };
    ParameterResult { value, u, unit }
}

/// The model's last cause with its figures.
pub fn cause(setting: &Setting, fitted: &Fitted) -> Message {
    described(setting, fitted, "")
}

/// The same as a sentence, or with the ending of its keys as a part of one.
pub fn described(setting: &Setting, fitted: &Fitted, inside: &str) -> Message {
    let Some(cause) = fitted.causes.last() else {
        return Message::default();
    };
    let numbers = fitted.numbers();
    let own = &numbers[numbers.len() - cause.numbers.len()..];
    let named = ("cause", words::word(&format!("periods.{}", cause.id)));
    if own.iter().all(|q| q.value.abs() <= TOLD * q.u) {
        return words::message(&format!("nothing_shown{inside}"), [named]);
    }
    words::message(
        &format!("with_figures{inside}"),
        [named, ("figures", figures(setting, fitted))],
    )
}

fn figures(setting: &Setting, fitted: &Fitted) -> Argument {
    let one = |(number, p): &(&CauseNumber, ParameterResult)| {
        let name = number.name.without(number.unit);
        let figure = words::written(figure(Quantity::new(p.value, p.u), p.unit));
        let name = words::word(&format!("number.{name}"));
        words::part(Some(words::message(
            "figure",
            [("name", name), ("figure", figure)],
        )))
    };
    words::row(
        shown_numbers(setting, fitted).iter().map(one).collect(),
        "row",
        "and",
    )
}
