//! Criticism of swings in one motion by the gyroscope alone.
//!
//! Where no recording holds what a simulation of the whole body needs (a compound pendulum; no
//! accelerometer, or one whose gravity was taken off), the turn about one axis is simulated: θ'' =
//! −ω² f(θ) − 2 α θ', with f the law of the suspension ([`Law`](gyradius_mechanics::one_angle::Law)). Each cause adds a torque over the
//! moment of inertia ([`causes`]).

mod causes;
mod findings;
mod fitting;
mod learned;
mod next_swing;
mod search;
mod swing;
mod verdict;

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use super::FORMAT;
use super::gain;
use super::point::{SETTLING_S, first_settled};
use super::result::{CauseVerdict, Criticism, Critique, ModelResult, SwingTrace};
use super::unit::UnitName;
use super::words;
use findings::findings;
use gyradius_base::error::{Error, Result};
use gyradius_base::message::Message;
use gyradius_base::progress::{Progress, tell};
use gyradius_identification::estimate::{Observed, System};
use gyradius_identification::measure::{SwingWork, title};
use gyradius_identification::outputs::write_quantities;
use gyradius_identification::{COVERAGE_95, Measurement, Method, QuantityName, QuantityResult};
use gyradius_recording::{LoadedSession, Quantity};
use next_swing::next_swing;
use search::{Extended, Found, LEAST_PERIODS, is_long_enough, search};
use swing::{FREQUENCY, Swing};

/// Criticises every swing of a session that a gyroscope saw, each in its strongest motion; `x` are
/// the session's parameters by the periods. `None` where there is no such swing, or one of them
/// cannot be simulated.
pub fn criticise(
    loaded: &LoadedSession,
    system: &System,
    (works, x): (&[SwingWork], &[f64]),
    warnings: Vec<Message>,
    progress: &Progress,
) -> Result<Option<Criticism>> {
    let all: Vec<Swing> = (works.iter().enumerate())
        .filter_map(|(number, work)| Swing::of(system, x, work, number))
        .collect();
    let (swings, short): (Vec<Swing>, Vec<Swing>) = all.into_iter().partition(is_long_enough);
    if swings.is_empty() {
        return short
            .first()
            .map_or(Ok(None), |first| Err(too_short(first)));
    }
    tell(progress, 0.15, "fitting each swing")?;
    let Some(found) = search(&swings, progress)? else {
        return Ok(None);
    };
    tell(progress, 0.9, "judging by samples held out")?;
    Ok(conclude(loaded, (system, x), &found, warnings))
}

/// Why a swing that was recorded is not judged.
fn too_short(swing: &Swing) -> Error {
    let period_s = TAU / swing.scales.omega_rad_s;
    let needed_s = SETTLING_S + LEAST_PERIODS * period_s;
    let reason = format!(
        "too short: {:.1} s are {:.1} periods; a criticism needs {needed_s:.0} s, the settling time of {SETTLING_S} s and {LEAST_PERIODS} periods",
        swing.duration_s,
        swing.duration_s / period_s,
    );
    Error::no_result(swing.id, reason)
}

fn conclude(
    loaded: &LoadedSession,
    session: (&System, &[f64]),
    found: &Found,
    mut warnings: Vec<Message>,
) -> Option<Criticism> {
    let (before, rows) = found.held_out(&found.base)?;
    let (after, _) = found.held_out(&found.best)?;
    let rms = |chi2: f64| (chi2 / rows.max(1) as f64).sqrt();
    let result = |model: &Extended, chi2: f64| ModelResult {
        rms_over_noise: Some(model.rms()),
        heldout_rms_over_noise: Some(rms(chi2)),
        quantities: quantities(session, found, model),
    };
    let (baseline, extended) = (result(&found.base, before), result(&found.best, after));
    let gain = gain((before, after), rows, &baseline, &extended);
    let next = found
        .rivals()
        .first()
        .filter(|_| !found.is_unexplained())
        .and_then(|r| next_swing(found, r));
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
        learned: learned::force(found, rms(after)),
        findings: Vec::new(),
        warnings,
    };
    Some(Criticism {
        critique,
        traces: traces(found)?,
    })
}

/// Period of small swings, undamped, s; uncertainty widened by what is left.
fn small_period_s(swing: &Swing, model: &Extended, s: usize) -> Option<Quantity> {
    let fitted = &model.fits[s];
    let period_s = TAU / swing.omega_rad_s(&fitted.point);
    let variance = fitted.covariance()?[(FREQUENCY, FREQUENCY)] * model.left.inflation();
    Some(Quantity::new(period_s, period_s * variance.sqrt()))
}

/// The small periods, and the body as the joint estimate has it from them.
fn quantities(
    (system, x): (&System, &[f64]),
    found: &Found,
    model: &Extended,
) -> BTreeMap<QuantityName, QuantityResult> {
    let mut system = system.with(system.layout.clone());
    let mut result = Measurement::default();
    let mut periods = BTreeMap::new();
    for (s, swing) in found.swings.iter().enumerate() {
        let Some(period) = small_period_s(swing, model, s) else {
            continue;
        };
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
        let first = first_settled(&swing.stream.t_s);
        let of = |model: &Extended| {
            Some(
                swing
                    .readings(&model.fits[s].point, &model.causes_of(swing))?
                    .split_off(first),
            )
        };
        let channel = words::message("channel_swing", []);
        Some(SwingTrace {
            swing: swing.id.into(),
            channel,
            unit: UnitName::RadianPerSecond.into(),
            noise: swing.noise_rad_s,
            t_s: swing.stream.t_s[first..].to_vec(),
            measured: swing.rates_rad_s[first..].to_vec(),
            base: of(&found.base)?,
            extended: of(&found.best)?,
        })
    };
    (0..found.swings.len()).map(one).collect()
}
