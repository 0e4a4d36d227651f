//! The criticism of periods in words and figures.

use std::collections::BTreeMap;

use super::choice::Choice;
use super::figures::{described, figure};
use super::model::{Fitted, HeldOut, Setting};
use crate::cause_id::CauseId;
use crate::result::{CauseResult, Discrepancy, DiscrepancyKind, Status};
use crate::unit::UnitName;
use crate::words;
use gyradius_base::message::{Argument, Message};
use gyradius_identification::estimate::{Observation, Observed};
use gyradius_identification::parameters::{Parameter, Role};
use gyradius_identification::{InputKind, QuantityName};
use gyradius_recording::{ModeName, Quantity};

/// A difference that stands out: chance does that once in 16 000 for a normal error.
const STANDS_OUT: f64 = 4.0;
/// Gravity, buoyancy taken off or not; what implies another value does not speak of gravity.
const EARTH_M_S2: std::ops::Range<f64> = 9.75..9.85;
/// A swing is hinted at where without it so much of the contradiction is left at most.
const MOST_LEFT: f64 = 0.2;

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
    let order = |d: &Discrepancy| (-(10.0 * d.sigma).round() as i64, d.what);
    found.sort_by_key(order);
    found
}

fn between_swings(base: &Fitted, observation: &Observation, held: HeldOut) -> Discrepancy {
    let relative = observation.value.value / held.predicted - 1.0;
    let key = match (observation.what, relative > 0.0) {
        (Observed::Period(..), true) => "longer",
        (Observed::Period(..), false) => "shorter",
        (_, true) => "larger",
        (_, false) => "smaller",
    };
    let swing = swing_id(base, observation.what);
    let what = match observation.what {
        Observed::Period(_, mode) => words::part(Some(words::message(
            "period_of",
            [
                ("motion", words::motion(mode)),
                ("swing", words::id(&swing)),
            ],
        ))),
        _ => Argument::Plain(observation.label.to_string()),
    };
    let said = words::message(
        key,
        [
            ("what", what),
            ("percent", words::number(100.0 * relative.abs(), 2)),
            ("sigma", words::number(held.z.abs(), 1)),
            (
                "as_if",
                words::part(as_if(base, observation.what, relative)),
            ),
        ],
    );
    Discrepancy::of(
        &swing,
        DiscrepancyKind::BetweenSwings,
        (relative, UnitName::One),
        held.z.abs(),
        said,
    )
}

/// Periods of yaw and sway go with the root of the length.
fn as_if(base: &Fitted, what: Observed, relative: f64) -> Option<Message> {
    let Observed::Period(i, ModeName::Yaw | ModeName::Sway) = what else {
        return None;
    };
    let off_m = 2.0 * relative * base.solution.x[base.system.layout.swings[i].line_length?];
    let key = if off_m > 0.0 {
        "as_if_longer"
    } else {
        "as_if_shorter"
    };
    Some(words::message(
        key,
        [("mm", words::number(1000.0 * off_m.abs(), 0))],
    ))
}

fn swing_id(base: &Fitted, what: Observed) -> String {
    match what {
        Observed::Period(i, _) | Observed::Moved(i) => base.system.session.swings[i].id.clone(),
        Observed::Incline(_) | Observed::Statement(_) => String::new(),
    }
}

/// A stated figure against what the swings imply.
fn dimension(base: &Fitted, place: usize, held: HeldOut) -> Option<Discrepancy> {
    let Parameter {
        name, role, prior, ..
    } = &base.system.layout.parameters[place];
    if name.kind == InputKind::Gravity && !EARTH_M_S2.contains(&held.predicted) {
        return None;
    }
    let unit = UnitName::from(name.kind);
    let implied_u = (held.u * held.u - prior.u * prior.u).max(0.0).sqrt();
    (*role == Role::Stated).then(|| {
        let said = words::message(
            "stated",
            [
                ("name", words::word(&format!("parameter.{name}"))),
                ("swings", words::part(of_swings(base, place))),
                ("stated", words::written(figure(*prior, unit.into()))),
                (
                    "implied",
                    words::written(figure(
                        Quantity::new(held.predicted, implied_u),
                        unit.into(),
                    )),
                ),
                ("sigma", words::number(held.z.abs(), 1)),
            ],
        );
        Discrepancy::of(
            "",
            DiscrepancyKind::Dimension,
            (prior.value - held.predicted, unit),
            held.z.abs(),
            said,
        )
    })
}

/// Which swings share a stated figure; nothing where all do.
fn of_swings(base: &Fitted, place: usize) -> Option<Message> {
    let session = base.system.session;
    let has = |i: usize| {
        let index = &base.system.layout.swings[i];
        [
            index.line_length,
            index.spacing,
            index.top_spacing,
            index.axis_height,
            Some(index.pitch_deg),
        ]
        .contains(&Some(place))
    };
    let ids: Vec<Argument> = (0..session.swings.len())
        .filter(|i| has(*i))
        .map(|i| words::id(&session.swings[i].id))
        .collect();
    let is_some = !ids.is_empty() && ids.len() < session.swings.len();
    is_some.then(|| words::message("of_swings", [("swings", words::row(ids, "row", "and"))]))
}

/// What remains when all causes have been tried: the evidence of one more factor on all
/// uncertainties, and the swing without which the rest would agree.
pub fn unknown(setting: &Setting, choice: &Choice) -> CauseResult {
    let (chi2, dof) = (
        choice.extended().solution.chi2,
        choice.extended().solution.dof,
    );
    let said = words::message(
        "contradictions",
        [
            ("chi2", words::number(chi2, 0)),
            ("dof", words::number(dof, 1)),
            ("hint", words::part(without_one(setting, choice))),
        ],
    );
    CauseResult {
        id: CauseId::Unknown,
        probability: 1.0,
        // ln of the likelihood with every variance larger by χ²/dof over that with none.
        log_evidence_gain: 0.5 * (chi2 - dof - dof * (chi2 / dof).ln()),
        parameters: BTreeMap::new(),
        message: said,
        taken: false,
    }
}

/// The swing without which the least contradiction is left, with the cause that then suggests
/// itself.
fn without_one(setting: &Setting, choice: &Choice) -> Option<Message> {
    let session = setting.system.session;
    let attempts: Vec<(usize, Fitted)> = (0..session.swings.len())
        .filter_map(|i| Some((i, choice.without(setting, i)?)))
        .collect();
    let count = attempts.len();
    let (i, fitted) = attempts
        .into_iter()
        .min_by(|(_, a), (_, b)| a.beyond_chance().total_cmp(&b.beyond_chance()))?;
    // Chosen among many: a single swing is blamed only where nearly all of the contradiction goes
    // with it.
    let is_much = fitted.beyond_chance() < MOST_LEFT * choice.extended().beyond_chance();
    let with = fitted.causes.last().map(|_| {
        words::message(
            "with_one",
            [(
                "cause",
                words::part(Some(described(setting, &fitted, "_inside"))),
            )],
        )
    });
    is_much.then(|| {
        words::message(
            "without_one",
            [
                ("swing", words::id(&session.swings[i].id)),
                ("with", words::part(with)),
                ("chi2", words::number(fitted.solution.chi2, 0)),
                ("dof", words::number(fitted.solution.dof, 1)),
                ("count", words::number(count as f64, 0)),
            ],
        )
    })
}

/// The verdict in words.
pub fn verdict(choice: &Choice) -> Message {
    let extended = choice.extended();
    let (named, rivals) = (&extended.causes, choice.rival_names());
    let causes = || {
        (
            "causes",
            words::names(named.iter().map(|cause| cause.id), "and"),
        )
    };
    let others = || ("others", words::names(rivals.iter().copied(), "or"));
    let hangs = || ("hangs", words::part(consequences(choice)));
    match choice.standing() {
        Status::Adequate => words::message("periods_adequate", []),
        Status::Explained => words::message("periods_explained", [causes()]),
        Status::Ambiguous => words::message("periods_ambiguous", [causes(), others(), hangs()]),
        Status::Unexplained if named.is_empty() => words::message("periods_contradiction", []),
        Status::Unexplained => {
            let instead =
                (!rivals.is_empty()).then(|| words::message("periods_instead", [others()]));
            words::message(
                "periods_remain",
                [causes(), ("instead", words::part(instead)), hangs()],
            )
        }
    }
}

/// What hangs on the choice between the causes.
fn consequences(choice: &Choice) -> Option<Message> {
    let of = |fitted: &Fitted| {
        let quantities = super::quantities(fitted);
        let k = quantities.get(&QuantityName::KYaw)?;
        Some(Quantity::new(k.value.scalar()?, k.u.scalar()?))
    };
    let all: Vec<Quantity> = std::iter::once(choice.extended())
        .chain(&choice.rivals)
        .filter_map(of)
        .collect();
    let least = all
        .iter()
        .copied()
        .min_by(|a, b| a.value.total_cmp(&b.value))?;
    let most = all
        .iter()
        .copied()
        .max_by(|a, b| a.value.total_cmp(&b.value))?;
    if most.value - least.value < most.u.max(least.u) {
        return None;
    }
    let written = |k: Quantity| words::written(figure(k, UnitName::Metre.into()));
    Some(words::message(
        "periods_hang",
        [("least", written(least)), ("most", written(most))],
    ))
}
