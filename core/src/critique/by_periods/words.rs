//! The criticism of periods in words and figures.

use std::collections::BTreeMap;

use super::causes::{CauseNumber, Shown};
use super::choice::Choice;
use super::model::{Fitted, HeldOut, Setting};
use crate::critique::result::{CauseResult, Discrepancy, ParameterResult};
use crate::inertia::estimate::{Observation, Observed};
use crate::inertia::parameters::{Parameter, Role};
use crate::inertia::words::{claim_name, claim_unit, mode_text};
use crate::recording::{ModeName, Quantity};

/// A difference that stands out: chance does that once in 16 000 for a normal error.
const STANDS_OUT: f64 = 4.0;
/// Beyond this a number of a cause is told from nothing.
const TOLD: f64 = 2.0;
/// Gravity, buoyancy taken off or not; what implies another value does not speak of gravity.
const EARTH_M_S2: std::ops::Range<f64> = 9.75..9.85;
/// A swing is hinted at where without it so much of the contradiction is left at most.
const MOST_LEFT: f64 = 0.2;

/// What follows from a choice.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Standing {
    /// Nothing is missing.
    Adequate,
    /// By causes that nothing else replaces.
    Explained,
    /// By causes that others could replace.
    Ambiguous,
    /// Contradictions remain.
    Unexplained,
}

impl Standing {
    /// As the format spells it.
    pub fn name(self) -> &'static str {
        match self {
            Standing::Adequate => "adequate",
            Standing::Explained => "explained",
            Standing::Ambiguous => "ambiguous",
            Standing::Unexplained => "unexplained",
        }
    }
}

/// A figure with two digits of its uncertainty; a pure number has no unit.
pub fn figure(q: Quantity, unit: &str) -> String {
    let digit = if q.u > 0.0 { q.u.log10().floor() as i32 - 1 } else { -4 };
    let decimals = (-digit).clamp(0, 9) as usize;
    let round = |x: f64| if digit > 0 { (x / 10f64.powi(digit)).round() * 10f64.powi(digit) } else { x };
    let (value, u, unit) = (round(q.value), round(q.u), if unit == "1" { "" } else { unit });
    format!("{value:.decimals$} ± {u:.decimals$} {unit}").trim_end().into()
}

/// Names in a sentence.
pub fn listed(names: &[String], last: &str) -> String {
    match names {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., end] => format!("{} {last} {end}", first.join(", ")),
    }
}

/// What the base model gets wrong, the most significant first.
pub fn discrepancies(base: &Fitted) -> Vec<Discrepancy> {
    let count = base.system.observations.len();
    let mut found: Vec<Discrepancy> = base
        .held_out()
        .iter()
        .enumerate()
        .filter_map(|(row, held)| {
            let held = held.filter(|h| h.z.abs() > STANDS_OUT)?;
            match base.system.observations.get(row) {
                Some(observation) => Some(between_swings(base, observation, held)),
                None => dimension(base, base.solution.free[row - count], held),
            }
        })
        .collect();
    // A period and the dimension that it contradicts differ by as much: the swing is named first.
    let order = |d: &Discrepancy| (-(10.0 * d.sigma).round() as i64, d.what.clone());
    found.sort_by_key(order);
    found
}

fn between_swings(base: &Fitted, observation: &Observation, held: HeldOut) -> Discrepancy {
    let relative = observation.value.value / held.predicted - 1.0;
    let longer = match (observation.what, relative > 0.0) {
        (Observed::Period(..), true) => "longer",
        (Observed::Period(..), false) => "shorter",
        (_, true) => "larger",
        (_, false) => "smaller",
    };
    let as_if = as_if(base, observation.what, relative);
    Discrepancy {
        swing: swing_id(base, observation.what),
        what: "between_swings".into(),
        size: relative,
        unit: "1".into(),
        sigma: held.z.abs(),
        text: format!(
            "The {} is {:.2} % {longer} than the rest of the session implies: {:.1} standard uncertainties{as_if}.",
            observation.label,
            100.0 * relative.abs(),
            held.z.abs(),
        ),
    }
}

/// Periods of yaw and sway go with the root of the length.
fn as_if(base: &Fitted, what: Observed, relative: f64) -> String {
    let Observed::Period(i, ModeName::Yaw | ModeName::Sway) = what else { return String::new() };
    let Some(length) = base.system.layout.swings[i].line_length else { return String::new() };
    let off_m = 2.0 * relative * base.solution.x[length];
    let longer = if off_m > 0.0 { "longer" } else { "shorter" };
    format!(", as if its lines were {:.0} mm {longer}", 1000.0 * off_m.abs())
}

fn swing_id(base: &Fitted, what: Observed) -> String {
    match what {
        Observed::Period(i, _) | Observed::Moved(i) => base.system.session.swings[i].id.clone(),
        Observed::Incline(_) | Observed::Statement(_) => String::new(),
    }
}

/// A stated figure against what the swings imply.
fn dimension(base: &Fitted, place: usize, held: HeldOut) -> Option<Discrepancy> {
    let Parameter { name, role, prior, .. } = &base.system.layout.parameters[place];
    if name == "gravity" && !EARTH_M_S2.contains(&held.predicted) {
        return None;
    }
    let unit = claim_unit(name);
    let implied_u = (held.u * held.u - prior.u * prior.u).max(0.0).sqrt();
    let text = format!(
        "The {}{} is stated as {}; the rest of the session implies {}: {:.1} standard uncertainties.",
        claim_name(name),
        of_swings(base, place),
        figure(*prior, unit),
        figure(Quantity::new(held.predicted, implied_u), unit),
        held.z.abs(),
    );
    (*role == Role::Stated).then(|| Discrepancy {
        swing: String::new(),
        what: "dimension".into(),
        size: prior.value - held.predicted,
        unit: unit.into(),
        sigma: held.z.abs(),
        text,
    })
}

/// Which swings share a stated figure; empty where all do.
fn of_swings(base: &Fitted, place: usize) -> String {
    let session = base.system.session;
    let has = |i: usize| {
        let index = &base.system.layout.swings[i];
        [index.line_length, index.spacing, index.top_spacing, index.axis_height, Some(index.pitch_deg)]
            .contains(&Some(place))
    };
    let ids: Vec<String> =
        (0..session.swings.len()).filter(|i| has(*i)).map(|i| session.swings[i].id.clone()).collect();
    if ids.is_empty() || ids.len() == session.swings.len() {
        return String::new();
    }
    format!(" of {}", listed(&ids, "and"))
}

/// The numbers of the model's last cause, in units of the rig.
pub fn parameters(setting: &Setting, fitted: &Fitted) -> BTreeMap<String, ParameterResult> {
    shown_numbers(setting, fitted).into_iter().map(|(number, shown)| (number.name.into(), shown)).collect()
}

/// Those of its numbers that the session has something to say of.
fn shown_numbers(setting: &Setting, fitted: &Fitted) -> Vec<(&'static CauseNumber, ParameterResult)> {
    let Some(cause) = fitted.causes.last() else { return vec![] };
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
        Shown::Times(factor) => (q.value * width * factor(scales), q.u * width * factor(scales)),
        Shown::Over(factor) => {
            let value = factor(scales) / (q.value * width);
            (value, (value * q.u / q.value).abs())
        }
        Shown::Size => (q.value.abs() * width, q.u * width),
    };
    let each = if number.by_mass && !scales.mass_is_known { " for each kg" } else { "" };
    ParameterResult { value, u, unit: format!("{}{each}", number.unit) }
}

/// The model's last cause with its figures.
pub fn cause(setting: &Setting, fitted: &Fitted) -> String {
    let Some(cause) = fitted.causes.last() else { return String::new() };
    let numbers = fitted.numbers();
    let own = &numbers[numbers.len() - cause.numbers.len()..];
    if own.iter().all(|q| q.value.abs() <= TOLD * q.u) {
        return format!("{}: the session shows nothing of it.", capital(cause.sentence));
    }
    format!("{}: {}.", capital(cause.sentence), figures(setting, fitted))
}

fn figures(setting: &Setting, fitted: &Fitted) -> String {
    let one = |(number, p): &(&CauseNumber, ParameterResult)| {
        let name = number.name.trim_end_matches(&format!("_{}", suffix(number)));
        format!("{} {}", name.replace('_', " "), figure(Quantity::new(p.value, p.u), &p.unit))
    };
    let all: Vec<String> = shown_numbers(setting, fitted).iter().map(one).collect();
    listed(&all, "and")
}

/// The unit as names end in it: `N/m` is `n_m`.
fn suffix(number: &CauseNumber) -> String {
    let plain = number.unit.to_lowercase().replace('^', "");
    plain.replace(['/', ' '], "_")
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// What remains when all causes have been tried: the evidence of one more factor on all uncertainties, and the swing without
/// which the rest would agree.
pub fn unknown(setting: &Setting, choice: &Choice) -> CauseResult {
    let (chi2, dof) = (choice.extended().solution.chi2, choice.extended().solution.dof);
    let beyond = format!(
        "Contradictions remain that no known cause accounts for (χ² = {chi2:.0} with {dof:.1} degrees of freedom)."
    );
    CauseResult {
        id: "unknown".into(),
        probability: 1.0,
        // ln of the likelihood with every variance larger by χ²/dof over that with none.
        log_evidence_gain: 0.5 * (chi2 - dof - dof * (chi2 / dof).ln()),
        parameters: BTreeMap::new(),
        text: [Some(beyond), without_one(setting, choice)]
            .into_iter()
            .flatten()
            .collect::<Vec<_>>()
            .join(" "),
        taken: false,
    }
}

/// The swing without which the least contradiction is left, with the cause that then suggests itself.
fn without_one(setting: &Setting, choice: &Choice) -> Option<String> {
    let session = setting.system.session;
    let attempts: Vec<(usize, Fitted)> =
        (0..session.swings.len()).filter_map(|i| Some((i, choice.without(setting, i)?))).collect();
    let count = attempts.len();
    let (i, fitted) =
        attempts.into_iter().min_by(|(_, a), (_, b)| a.beyond_chance().total_cmp(&b.beyond_chance()))?;
    // Chosen among many: a single swing is blamed only where nearly all of the contradiction goes with it.
    let is_much = fitted.beyond_chance() < MOST_LEFT * choice.extended().beyond_chance();
    let with = match fitted.causes.last() {
        Some(_) => format!(" and with one cause ({})", lower(&cause(setting, &fitted))),
        None => String::new(),
    };
    is_much.then(|| {
        format!(
            "Without the swing {}{with} χ² would be {:.0} with {:.1} degrees of freedom: of {count} swings left out in turn this one takes off the most, which is a hint and no more.",
            session.swings[i].id, fitted.solution.chi2, fitted.solution.dof,
        )
    })
}

fn lower(text: &str) -> String {
    let mut letters = text.trim_end_matches('.').chars();
    letters.next().map_or(String::new(), |first| first.to_lowercase().chain(letters).collect())
}

/// The verdict in words.
pub fn verdict(choice: &Choice) -> String {
    let extended = choice.extended();
    let names: Vec<String> = extended.causes.iter().map(|c| c.id.replace('_', " ")).collect();
    let rivals: Vec<String> = choice.rival_names().iter().map(|n| n.replace('_', " ")).collect();
    let named = listed(&names, "and");
    match choice.standing() {
        Standing::Adequate => {
            "Periods and dimensions agree within their uncertainties: nothing is missing.".into()
        }
        Standing::Explained => {
            format!("The contradictions go away with {named}, and with nothing else that was tried.")
        }
        Standing::Ambiguous => format!(
            "The contradictions go away with {named}; these periods cannot tell it from {}.{}",
            listed(&rivals, "or"),
            consequences(choice)
        ),
        Standing::Unexplained if names.is_empty() => {
            "The session contradicts itself, and no known cause accounts for it.".into()
        }
        Standing::Unexplained => {
            let instead = match rivals.is_empty() {
                true => String::new(),
                false => format!(", which these periods cannot tell from {}", listed(&rivals, "or")),
            };
            format!(
                "Most of the contradictions go away with {named}{instead}, but more remain than chance leaves.{}",
                consequences(choice)
            )
        }
    }
}

/// What hangs on the choice between the causes.
fn consequences(choice: &Choice) -> String {
    let of = |fitted: &Fitted| {
        let quantities = super::quantities(fitted);
        let k = quantities.get("k_yaw_m")?;
        Some(Quantity::new(k.value.as_f64()?, k.u.as_f64()?))
    };
    let all: Vec<Quantity> =
        std::iter::once(choice.extended()).chain(&choice.rivals).filter_map(of).collect();
    let (Some(least), Some(most)) = (
        all.iter().copied().min_by(|a, b| a.value.total_cmp(&b.value)),
        all.iter().copied().max_by(|a, b| a.value.total_cmp(&b.value)),
    ) else {
        return String::new();
    };
    if most.value - least.value < most.u.max(least.u) {
        return String::new();
    }
    format!(" The yaw gyradius hangs on it: {} by one, {} by another.", figure(least, "m"), figure(most, "m"))
}

/// Modes in words.
pub fn modes(names: &[ModeName]) -> String {
    listed(&names.iter().map(|m| mode_text(*m).into()).collect::<Vec<String>>(), "and")
}
