//! Criticism of swings in one motion: a turn about one axis that a gyroscope, a single rate or an
//! angle tells.
//!
//! Where no recording holds what a simulation of the whole body needs, the turn is simulated as it is
//! measured ([`gyradius_identification::one_motion`]): θ'' = −ω² f(θ) − 2 α θ', with f the law of the
//! suspension ([`Law`](gyradius_mechanics::one_angle::Law)). The causes ([`catalogue`]) are torques
//! over the moment of inertia or errors of the sensor; which of them the data ask for is one
//! selection among all sets ([`selection`](super::selection)).

mod catalogue;
mod competing;
mod findings;
mod found;
mod learned;
mod next_swing;
mod swing;

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use super::FORMAT;
use super::decision::{LEAST_SHARE, NEARLY};
use super::doubt::half_width_95;
use super::gain;
use super::point::{SETTLING_S, first_settled};
use super::result::{CauseVerdict, Criticism, Critique, ModelResult, SwingTrace};
use super::unit::UnitName;
use super::words;
use competing::{Model, One};
use findings::findings;
use found::{Found, find};
use gyradius_base::error::{Error, Result};
use gyradius_base::message::Message;
use gyradius_base::progress::{Progress, tell};
use gyradius_identification::estimate::{Observed, System};
use gyradius_identification::measure::{SwingWork, title};
use gyradius_identification::outputs::write_quantities;
use gyradius_identification::{COVERAGE_95, Measurement, Method, QuantityName, QuantityResult};
use gyradius_recording::{LoadedSession, Quantity};
use next_swing::next_swing;
use swing::Swing;

/// Periods beyond what is left out that a record must hold to be judged: fewer do not tell how the
/// period and the damping go with the amplitude.
const LEAST_PERIODS: f64 = 6.0;

/// Criticises every swing of a session whose turn a sensor tells, each in its strongest motion; `x`
/// are the session's parameters by the periods. `None` where there is no such swing, or one of them
/// cannot be simulated.
pub fn criticise(
    loaded: &LoadedSession,
    system: &System,
    (works, x): (&[SwingWork], &[f64]),
    warnings: Vec<Message>,
    progress: &Progress,
) -> Result<Option<Criticism>> {
    tell(progress, 0.15, "fitting each swing")?;
    let all: Vec<Swing> = (works.iter().enumerate())
        .filter_map(|(number, work)| Swing::of(system, x, work, number))
        .collect();
    let (swings, short): (Vec<Swing>, Vec<Swing>) = all.into_iter().partition(is_long_enough);
    if swings.is_empty() {
        return short
            .first()
            .map_or(Ok(None), |first| Err(too_short(first)));
    }
    let Some(found) = find(&swings, progress)? else {
        return Ok(None);
    };
    Ok(conclude(loaded, (system, x), &found, warnings))
}

/// Whether a record is long enough to be judged.
fn is_long_enough(swing: &Swing) -> bool {
    let period_s = TAU / swing.scales().omega_rad_s;
    swing.readings().duration_s() > SETTLING_S + LEAST_PERIODS * period_s
}

/// Why a swing that was recorded is not judged.
fn too_short(swing: &Swing) -> Error {
    let period_s = TAU / swing.scales().omega_rad_s;
    let needed_s = SETTLING_S + LEAST_PERIODS * period_s;
    let reason = format!(
        "too short: {:.1} s are {:.1} periods; a criticism needs {needed_s:.0} s, the settling time of {SETTLING_S} s and {LEAST_PERIODS} periods",
        swing.readings().duration_s(),
        swing.readings().duration_s() / period_s,
    );
    Error::no_result(swing.id, reason)
}

fn conclude(
    loaded: &LoadedSession,
    session: (&System, &[f64]),
    found: &Found,
    mut warnings: Vec<Message>,
) -> Option<Criticism> {
    let (before, after, rows) = found.decision.held_out;
    let rms = |chi2: f64| (chi2 / rows.max(1) as f64).sqrt();
    let result = |model: &Model, chi2: f64, periods: Vec<Option<Quantity>>| ModelResult {
        rms_over_noise: Some(found.rms(model)),
        heldout_rms_over_noise: Some(rms(chi2)),
        quantities: quantities(session, found, periods),
    };
    let each = 0..found.swings.len();
    let alone = each.clone().map(|s| base_period_s(found, s));
    let baseline = result(&found.decision.base, before, alone.collect());
    let averaged = each.map(|s| averaged_period_s(found, s));
    let extended = result(&found.decision.best, after, averaged.collect());
    let gain = gain((before, after), rows, &baseline, &extended);
    let next = next_swing(found);
    warnings.push(words::message("turns_alone", []));
    let critique = Critique {
        format: FORMAT.into(),
        title: title(&loaded.session),
        discrepancies: findings(found),
        causes: found.causes(),
        verdict: CauseVerdict {
            next_swing: next,
            ..found.verdict()
        },
        baseline,
        extended,
        gain,
        learned: learned::force(found),
        findings: Vec::new(),
        warnings,
    };
    Some(Criticism {
        critique,
        traces: traces(found)?,
    })
}

/// Period of small swings, undamped, s, by a model, its uncertainty so many times as wide.
fn period_s(swing: &Swing, one: &One, wider: f64) -> Option<Quantity> {
    let period_s = swing.period_s(&one.x);
    Some(Quantity::new(
        period_s,
        wider * period_s * one.frequency_u()?,
    ))
}

/// That of the base.
fn base_period_s(found: &Found, s: usize) -> Option<Quantity> {
    let (swing, one) = (&found.swings[s], &found.decision.base.swings[s]);
    period_s(swing, one, one.wider(swing, &found.decision.base.set))
}

/// The same by the model that is believed, with an uncertainty that holds 95 % of all models by their
/// shares of the posterior. Where none explains the swing, the law that is stated is as likely as
/// all of them.
fn averaged_period_s(found: &Found, s: usize) -> Option<Quantity> {
    let (swing, best) = (&found.swings[s], &found.decision.best.swings[s]);
    let wider = best.wider(swing, &found.decision.best.set);
    let mut believed = period_s(swing, best, wider)?;
    // The laws of the causes are nearly right, no more.
    let nearly = swing.frequency_u(&found.decision.best.set, &best.x, NEARLY.sqrt());
    believed.u = (believed.u).max(nearly.unwrap_or(0.0) * wider * believed.value);
    let off = |period: Quantity, share: f64| (share, period.value - believed.value, period.u);
    let models = found
        .decision
        .selection
        .candidates
        .iter()
        .zip(found.decision.selection.weights());
    let mut all: Vec<(f64, f64, f64)> = models
        .filter(|(_, share)| *share > LEAST_SHARE)
        .filter_map(|(model, share)| {
            let mut period = period_s(swing, &model.model.swings[s], wider)?;
            period.u = period.u.max(believed.u);
            Some(off(period, share))
        })
        .collect();
    if found.is_unexplained() {
        all.extend(base_period_s(found, s).map(|base| off(base, 1.0)));
    }
    if all.is_empty() {
        return Some(believed);
    }
    Some(Quantity::new(
        believed.value,
        half_width_95(&all) / COVERAGE_95,
    ))
}

/// The small periods, and the body as the joint estimate has it from them.
fn quantities(
    (system, x): (&System, &[f64]),
    found: &Found,
    small_s: Vec<Option<Quantity>>,
) -> BTreeMap<QuantityName, QuantityResult> {
    let mut system = system.with(system.layout.clone());
    let mut result = Measurement::default();
    let mut periods = BTreeMap::new();
    for (swing, period) in found.swings.iter().zip(small_s) {
        let Some(period) = period else { continue };
        let is_its = |what: Observed| what == Observed::Period(swing.number, swing.mode);
        system
            .observations
            .iter_mut()
            .filter(|o| is_its(o.what))
            .for_each(|o| o.value = period);
        let half = COVERAGE_95 * period.u;
        let quantity = QuantityResult {
            value: period.value.into(),
            u: period.u.into(),
            interval_95: Some([period.value - half, period.value + half]),
            method: Method::SimulationOfOneMotion,
        };
        periods.insert(QuantityName::small_period_of(swing.id), quantity);
    }
    if let Ok(solution) = system.solve(x) {
        write_quantities(&system, &solution, &mut result);
    }
    result.quantities.extend(periods);
    result.quantities
}

/// The turn about each swing's axis, measured and by both simulations, from where they are
/// compared.
fn traces(found: &Found) -> Option<Vec<SwingTrace>> {
    let one = |s: usize| {
        let swing = &found.swings[s];
        let readings = swing.readings();
        let first = first_settled(&readings.t_s);
        let of = |model: &Model| {
            let mut all = swing.simulated(&model.set, &model.swings[s].x)?;
            Some(all.split_off(first))
        };
        let unit = if readings.is_angle {
            UnitName::Radian
        } else {
            UnitName::RadianPerSecond
        };
        Some(SwingTrace {
            swing: swing.id.into(),
            channel: words::message("channel_swing", []),
            unit: unit.into(),
            noise: readings.noise,
            t_s: readings.t_s[first..].to_vec(),
            measured: readings.values[first..].to_vec(),
            base: of(&found.decision.base)?,
            extended: of(&found.decision.best)?,
        })
    };
    (0..found.swings.len()).map(one).collect()
}
