//! The main job: from a loaded session, or a bare recording, to a [`Measurement`].

use std::f64::consts::TAU;

use num_complex::Complex64;

use crate::chance::SURE;
use crate::modes::{Hanging, tilt_between_rad};
use gyradius_base::error::{Error, Result};
use gyradius_base::frames::Vec3;
use gyradius_base::message::{Argument, Message};
use gyradius_base::progress::{Progress, UNWATCHED, tell};
use gyradius_recording::{
    Incline, InclineAngle, LoadedData, LoadedSession, LoadedSwing, ModeName, PeriodList, Quantity,
    Recording, Session, SuspensionKind, Swing, SwingData,
};
use gyradius_signal::{
    FittedMode, FlaggedPeriod, PeriodTrend, Pole, SmallAmplitude, WindowPoint, WindowedMode,
    against_amplitude, period_from_list, small_amplitude_limit,
};

use super::alternatives::{RouteCalculation, routes};
use super::amplitude_correction::{Correction, corrections};
use super::beats;
use super::by_samples::by_samples;
use super::consistency::{ConsistencyTests, FLAG_SIGMA, Hidden, consistency_tests};
use super::estimate::{Observation, Observed, Solution, System};
use super::findings::{
    Finding, duplicates, incline_without_mass, near_resonance, not_one_motion, not_used,
    of_amplitude, of_dimensions, of_list, of_recording, of_residual, of_size, phone, phone_moved,
    unchecked,
};
use super::measurement::{
    AmplitudePoint, Claim, Measurement, ModeResult, MotionResult, SwingResult, TrendResult,
};
use super::names::{AmplitudeUnit, Input, Subject};
use super::observe::{
    Evidence, NEAR_SWAY, hints_contradicted, names_by_period, observe_recording, observe_track,
    parasites,
};
use super::one_motion::PENDULUM;
use super::outputs::write_averaged;
use super::parameters::{Layout, effective_gravity, period_key};
use super::routes::guard::{Limit, verdict};
use super::sentences::{inputs, message, name, plain};
use super::spread::Spread;
pub use super::swing_work::SwingWork;
use super::swing_work::WEAKEST_DB;
use super::theory::has_motion;

/// Name and version of the result's format.
pub const FORMAT: &str = "gyradius-measurement/1";
/// Uncertainty of the angle between two tilts of one phone, degrees. Noise over seconds is nothing
/// beside it, and a bias that stays cancels but for its part along gravity times the angle; what is
/// left is a bias that has moved meanwhile, by 0.02 m/s² or so as the phone warms, and axes whose
/// scales differ by a percent or two.
pub const PHONE_TILT_U_DEG: f64 = 0.15;
/// A typed period without uncertainty is taken as good to this, relative (a stopwatch's last
/// digit).
const TYPED_PERIOD_U_RELATIVE: f64 = 1e-6;

/// A mode weaker than this in a record whose residual exceeds its noise by this factor may be part
/// of the misfit: strong motions that are no damped lines leave such traces beside them.
const DOUBTFUL_DB: f64 = -40.0;
const DOUBTFUL_MISFIT: f64 = 1.5;

/// Frequencies of sidebands over that of their mode: up to a little more than its third multiple, which
/// a limit of the sensor makes.
const SIDEBANDS: f64 = 3.5;

/// A roll gyradius of which weak priors decide less than this share is measured.
const ROLL_WEAK_SHARE: f64 = 0.05;

/// Roughly the shares of the work that are done once the swings are read, the periods solved, the
/// samples fitted.
const OBSERVED_SHARE: f64 = 0.4;
const SOLVED_SHARE: f64 = 0.5;
const FITTED_SHARE: f64 = 0.9;

/// What a caller may ask beyond the measurement.
#[derive(Debug, Clone, Default)]
pub struct MeasureOptions {
    /// Class limits to judge against.
    pub limits: Vec<Limit>,
}

/// A measurement with the evidence that pictures are drawn from.
#[derive(Debug, Clone)]
pub struct Analysis {
    /// The result.
    pub measurement: Measurement,
    /// What was found in each recording, in swing order; swings without a recording have none.
    pub evidence: Vec<Option<Evidence>>,
}

/// Measures a session.
pub fn measure(loaded: &LoadedSession, options: &MeasureOptions) -> Result<Measurement> {
    analyse(loaded, options).map(|a| a.measurement)
}

/// A session ready to be estimated: what its swings show, and the system that they make.
pub struct Prepared<'a> {
    /// Every swing, in session order.
    pub works: Vec<SwingWork>,
    /// Angle of every incline, rad, where it could be read.
    pub inclines: Vec<Option<Quantity>>,
    /// Parameters and observations of the session.
    pub system: System<'a>,
    /// What a reader must know.
    pub warnings: Vec<Message>,
    /// What is not plausible in it; swings that are refused have no periods any more.
    pub findings: Vec<Finding>,
}

/// Observes every swing and lays out the session's parameters.
pub fn prepare(loaded: &LoadedSession) -> Result<Prepared<'_>> {
    prepare_watched(loaded, UNWATCHED)
}

fn prepare_watched<'a>(loaded: &'a LoadedSession, progress: &Progress) -> Result<Prepared<'a>> {
    let session = &loaded.session;
    let (gravity, gravity_warning) = effective_gravity(session)?;
    let work = |(place, (swing, data)): (usize, (&Swing, &LoadedSwing))| {
        let share = OBSERVED_SHARE * place as f64 / session.swings.len() as f64;
        tell(progress, share, &format!("reading {}", swing.id))?;
        Ok(work_swing(swing, &data.data, gravity.value))
    };
    let mut works: Vec<SwingWork> = session
        .swings
        .iter()
        .zip(&loaded.data)
        .enumerate()
        .map(work)
        .collect::<Result<_>>()?;
    let mut findings = plausibility(loaded, gravity.value, &mut works);
    let is_refused = findings.iter().any(Finding::refuses);
    if works.iter().all(|w| w.result.modes.is_empty()) && !session.swings.is_empty() && !is_refused
    {
        return Err(Error::no_result(&loaded.source, no_modes_reason(&works)));
    }
    let (pitch, moved) = phone_pitches(session, &works);
    findings.extend(moved);
    let inclines = recorded_inclines(loaded, &works);
    let yaws: Vec<Option<f64>> = works.iter().map(yaw_period_s).collect();
    let layout = Layout::of(session, gravity, &pitch, &yaws, &inclines);
    let mut system = System::new(session, layout);
    system.observe(observations(session, &works, &[]), &inclines);
    Ok(Prepared {
        works,
        inclines,
        system,
        warnings: gravity_warning.into_iter().collect(),
        findings,
    })
}

/// What is not plausible in the swings and the stated lengths. Nothing is taken from a swing that is
/// refused.
fn plausibility(
    loaded: &LoadedSession,
    gravity_m_s2: f64,
    works: &mut [SwingWork],
) -> Vec<Finding> {
    let session = &loaded.session;
    let of_swing = |((work, swing), stated): ((&SwingWork, &LoadedSwing), &Swing)| match &swing.data
    {
        LoadedData::Recording(recording) => {
            let evidence = work.evidence.as_ref();
            let mut found = of_recording(&swing.id, recording, evidence, gravity_m_s2);
            if stated.suspension.kind != SuspensionKind::Free {
                let law = (ModeName::Compound, PENDULUM);
                found.extend(evidence.and_then(|one| of_amplitude(&swing.id, one, law)));
            }
            found
        }
        LoadedData::Periods(list) => of_list(&swing.id, list),
        LoadedData::Track(_) | LoadedData::Typed => vec![],
    };
    let swings = works.iter().zip(&loaded.data).zip(&session.swings);
    let mut found: Vec<Finding> = swings.flat_map(of_swing).collect();
    found.extend(of_dimensions(session));
    found.extend(Finding::default_u(&loaded.assumed));
    for work in works.iter_mut() {
        let is_its = |one: &&Finding| one.swing.as_deref() == Some(work.result.id.as_str());
        if found.iter().filter(is_its).any(Finding::refuses) {
            work.refuse();
        }
    }
    for (place, finding) in duplicates(session, &loaded.data) {
        works[place].refuse();
        found.push(finding);
    }
    found
}

/// Measures a session and keeps the evidence.
pub fn analyse(loaded: &LoadedSession, options: &MeasureOptions) -> Result<Analysis> {
    analyse_watched(loaded, options, UNWATCHED)
}

/// The same, told of and stopped by a callback, swing by swing and step by step.
pub fn analyse_watched(
    loaded: &LoadedSession,
    options: &MeasureOptions,
    progress: &Progress,
) -> Result<Analysis> {
    let session = &loaded.session;
    let Prepared {
        mut works,
        inclines,
        mut system,
        warnings,
        findings,
    } = prepare_watched(loaded, progress)?;
    let mut result = Measurement {
        format: FORMAT.into(),
        title: title(session),
        ..Default::default()
    };
    warnings.into_iter().for_each(|said| result.warn(said));
    findings.into_iter().for_each(|one| result.find(one));
    tell(progress, OBSERVED_SHARE, "solving the periods")?;
    let estimated = estimate(&mut system, session, &mut works, &inclines);
    tell(
        progress,
        SOLVED_SHARE,
        "fitting the simulation to the samples",
    )?;
    let (solved, told) = by_samples(&mut system, &mut works, &inclines, estimated);
    told.into_iter().for_each(|one| result.find(one));
    let has_failed = solved.is_err();
    match solved {
        Ok(solution) => {
            tell(progress, FITTED_SHARE, "weighing uncertainties")?;
            let counted = |w: &SwingWork| {
                w.evidence
                    .as_ref()
                    .and_then(|e| beats::counted(e, &w.result))
            };
            let beats: Vec<_> = works.iter().map(counted).collect();
            let routes = routes(&system, &solution, &beats);
            let hidden = conclude(&system, &solution, &routes, &mut result);
            beyond_the_data((&system, &solution), &hidden, &works, &mut result);
            judge(options, &mut result);
        }
        Err(error) => result.warn(message("no_joint_estimate", [("reason", plain(error))])),
    }
    let unused = not_used(&system, &works, &result, has_failed);
    unused.into_iter().for_each(|one| result.find(one));
    let (swings, evidence) = works.into_iter().map(|w| (w.result, w.evidence)).unzip();
    result.swings = swings;
    Ok(Analysis {
        measurement: result,
        evidence,
    })
}

/// The session's periods, freed of finite amplitude, with its stated figures as one system, and the
/// solution; samples are not looked at beyond their periods.
pub fn solved_periods(loaded: &LoadedSession) -> Result<(System<'_>, Solution)> {
    let Prepared {
        mut system,
        mut works,
        inclines,
        ..
    } = prepare(loaded)?;
    let solution = estimate(&mut system, &loaded.session, &mut works, &inclines)?;
    Ok((system, solution))
}

fn yaw_period_s(work: &SwingWork) -> Option<f64> {
    let is_yaw = |(m, _): &&(usize, Quantity)| work.result.modes[*m].mode == ModeName::Yaw;
    work.periods
        .iter()
        .find(is_yaw)
        .map(|(_, period)| period.value)
}

/// The session's title, or its body's name.
pub fn title(session: &Session) -> String {
    if session.title.is_empty() {
        session.body.name.clone()
    } else {
        session.title.clone()
    }
}

fn in_english(warnings: &[Message]) -> String {
    let english: Vec<&str> = warnings.iter().map(|w| w.english.as_str()).collect();
    english.join("; ")
}

fn no_modes_reason(works: &[SwingWork]) -> String {
    let reasons: Vec<String> = works
        .iter()
        .map(|w| format!("{}: {}", w.result.id, in_english(&w.result.warnings)))
        .collect();
    format!(
        "no swing gives a period ({}); let go of the hull, and record ten periods or more",
        reasons.join(" | ")
    )
}

/// First without, then with the correction for finite amplitude, which needs a body to simulate.
pub fn estimate(
    system: &mut System,
    session: &Session,
    works: &mut [SwingWork],
    inclines: &[Option<Quantity>],
) -> Result<Solution> {
    works.iter_mut().for_each(SwingWork::uncorrect);
    system.observe(observations(session, works, &[]), inclines);
    if system.observations.is_empty() {
        let is_free = |swing: &Swing| swing.suspension.kind == SuspensionKind::Free;
        let reason = match !session.swings.is_empty() && session.swings.iter().all(is_free) {
            true => "nothing is stated of the suspension: the periods stand alone",
            false => "no mode of any swing could be named",
        };
        return Err(Error::no_result(title(session), reason));
    }
    let first = system.solve(&system.layout.start())?;
    let other = roll_unmeasured(system, &first);
    let corrections: Vec<Vec<Correction>> = (0..works.len())
        .map(|i| {
            let (swing, index) = (&session.swings[i], &system.layout.swings[i]);
            let mut found = corrections(
                &system.layout,
                (&first.x, other.as_deref()),
                swing,
                index,
                &works[i].result,
            );
            for (correction, mode) in found.iter_mut().zip(&works[i].result.modes) {
                *correction = beside_record(*correction, mode);
                *correction = correction.and(unnamed_beside(mode, &works[i], swing));
            }
            // The motion itself is followed to small amplitude already.
            let motion = works[i].evidence.as_ref().and_then(Evidence::one_motion);
            if let (Some(motion), Some(first)) = (motion, found.first_mut()) {
                *first = Correction::known(motion.period_s.value / motion.observed_s);
            }
            found
        })
        .collect();
    for (work, corrections) in works.iter_mut().zip(&corrections) {
        apply(&mut work.result, corrections);
    }
    system.observe(observations(session, works, &corrections), inclines);
    system.solve(&first.x)
}

/// Relative doubt of a period by motions that nothing explains, where shapes name those of a hull. They
/// are wrong readings of its own: samples that are missing, a limit, a clock. Of relative size r, they
/// are the sidebands of a phase that scatters by r; one that is pulled back once in a period, evenly in
/// between, runs ahead by √12 r, and the period is wrong by √12 r / 2π. What is faster than the third
/// multiple, or slower by as much, is no sideband.
fn unnamed_beside(mode: &ModeResult, work: &SwingWork, swing: &Swing) -> f64 {
    let is_bifilar = swing.suspension.kind == SuspensionKind::Bifilar;
    let is_read = is_bifilar && work.evidence.as_ref().is_some_and(Evidence::has_shapes);
    if mode.mode == ModeName::Other || !is_read {
        return 0.0;
    }
    let is_beside = |other: &&ModeResult| {
        let ratio = mode.period_observed_s / other.period_observed_s;
        other.mode == ModeName::Other && ratio.ln().abs() < SIDEBANDS.ln()
    };
    let beside = work.result.modes.iter().filter(is_beside);
    let squares: f64 = beside
        .map(|other| 10f64.powf((other.relative_db - mode.relative_db) / 10.0))
        .sum();
    (12.0 * squares).sqrt() / TAU
}

/// A law brings a period to small amplitude, and the record itself does, by how it changes while the
/// swing dies away. Where they surely differ, the law is not that of this swing: what they differ by
/// is in doubt.
fn beside_record(by_law: Correction, mode: &ModeResult) -> Correction {
    let (small_s, observed_s) = (mode.period_s, mode.period_observed_s);
    let apart = (small_s / observed_s - by_law.factor).abs();
    let u = by_law.u_relative.hypot(mode.period_se_s / observed_s);
    let is_of_record = small_s != observed_s;
    match is_of_record && apart > SURE * u {
        true => Correction {
            u_relative: by_law.u_relative.hypot(apart),
            ..by_law
        },
        false => by_law,
    }
}

impl System<'_> {
    fn observe(&mut self, periods: Vec<Observation>, inclines: &[Option<Quantity>]) {
        self.observations = periods.clone();
        let beside = self.beside_swings(inclines);
        self.observations.extend(beside);
        self.periods = periods;
    }
}

/// The solution with its roll gyradius one standard uncertainty off; none where the swings measure
/// it.
fn roll_unmeasured(system: &System, solution: &Solution) -> Option<Vec<f64>> {
    let roll = system.layout.log_gyradii[0];
    let known = solution.derive(&system.layout, |x| Some(x[roll]))?;
    let mut other = solution.x.clone();
    other[roll] += known.u;
    (known.weak_share > ROLL_WEAK_SHARE).then_some(other)
}

/// Writes the small-amplitude period of each corrected mode.
fn apply(result: &mut SwingResult, corrections: &[Correction]) {
    for (mode, correction) in result.modes.iter_mut().zip(corrections) {
        mode.period_s = mode.period_observed_s * correction.factor;
        mode.period_se_s = mode
            .period_se_s
            .hypot(mode.period_s * correction.u_relative);
    }
}

/// Quantities, routes and contradictions; errors in stated figures that would not show.
fn conclude(
    system: &System,
    solution: &Solution,
    calculations: &[RouteCalculation],
    result: &mut Measurement,
) -> Vec<Hidden> {
    let spread = Spread::of(system, solution);
    write_averaged(system, &spread, result);
    for calculation in calculations {
        let known = result
            .alternatives
            .entry(calculation.quantity.clone())
            .or_default();
        known.push(calculation.route());
    }
    let ConsistencyTests { claims, hidden } = consistency_tests(system, solution, calculations);
    result.consistency = claims;
    worst_of_each(&result.consistency)
        .into_iter()
        .for_each(|said| result.warn(said));
    if !spread.suspects.is_empty() {
        let suspects = inputs(&spread.suspects);
        result.find(Finding::contradiction(
            solution.chi2,
            solution.dof,
            suspects,
        ));
    } else if solution.birge > 1.0 {
        result.find(Finding::unexplained_contradiction(solution));
    }
    hidden
}

/// What the result shows of the session: sizes, resonances, what rides along, what nothing tests.
fn beyond_the_data(
    (system, solution): (&System, &Solution),
    hidden: &[Hidden],
    works: &[SwingWork],
    result: &mut Measurement,
) {
    let session = system.session;
    let mut found = of_size(session, result);
    found.extend(works.iter().filter_map(|w| of_residual(&w.result)));
    found.extend(not_one_motion(session, works));
    found.extend(near_resonance(system, solution, works, result));
    found.extend(phone(session, works, result));
    found.extend(incline_without_mass(session));
    found.extend(unchecked((system, solution), hidden, result));
    found.into_iter().for_each(|one| result.find(one));
}

/// Verdicts on class limits.
fn judge(options: &MeasureOptions, result: &mut Measurement) {
    for limit in &options.limits {
        let quantity = ("quantity", name(&format!("id.{}", limit.quantity)));
        match result
            .quantities
            .get(limit.quantity.as_str())
            .and_then(|q| Some((q.value.scalar()?, q.u.scalar()?)))
        {
            Some((value, u)) => match verdict(Quantity::new(value, u), limit) {
                Ok(judged) => result.verdicts.push(judged),
                Err(error) => {
                    result.warn(message("no_verdict", [quantity, ("reason", plain(error))]))
                }
            },
            None => result.warn(message("no_verdict_undetermined", [quantity])),
        }
    }
}

/// The worst contradiction of each claim; all of them stand in `consistency`.
fn worst_of_each(claims: &[Claim]) -> Vec<Message> {
    let mut about: Vec<&Subject> = Vec::new();
    let mut said = Vec::new();
    for claim in claims.iter().filter(|c| c.flagged) {
        if !about.contains(&&claim.claim) {
            about.push(&claim.claim);
            said.push(claim.message.clone());
        }
    }
    said
}

fn work_swing(swing: &Swing, data: &LoadedData, gravity_m_s2: f64) -> SwingWork {
    let hanging = Hanging::of(&swing.suspension, gravity_m_s2);
    let worked = match data {
        LoadedData::Recording(recording) => {
            observe_recording(&swing.id, recording, gravity_m_s2, &hanging, Some(swing))
                .map(|e| work_of(e, Some(swing)))
        }
        LoadedData::Track(track) => {
            observe_track(&swing.id, track, &hanging, swing).map(|e| work_of(e, Some(swing)))
        }
        LoadedData::Periods(list) => work_list(swing, list, &hanging),
        LoadedData::Typed => Ok(work_typed(swing)),
    };
    worked.unwrap_or_else(|error| {
        let result = SwingResult {
            id: swing.id.clone(),
            ..Default::default()
        };
        let result = result.warned(vec![Message::in_english(error.to_string())]);
        SwingWork::of(result, None, vec![])
    })
}

/// What is used of a swing's evidence.
pub(super) fn work_of(evidence: Evidence, swing: Option<&Swing>) -> SwingWork {
    let mut warnings = evidence.warnings.clone();
    warnings.extend(hints_contradicted(&evidence.named, swing));
    let parasitic = parasites(&evidence.named, swing, &mut warnings);
    let modes: Vec<ModeResult> = evidence
        .found
        .modes
        .iter()
        .zip(&evidence.named)
        .zip(parasitic)
        .enumerate()
        .map(|(i, ((mode, named), (db, parasitic)))| ModeResult {
            relative_db: db,
            parasitic,
            doubtful: db < DOUBTFUL_DB && evidence.found.rms_over_noise > DOUBTFUL_MISFIT,
            ..mode_result(&evidence, i, mode, named.name, named.angle_rad)
        })
        .collect();
    let periods = modes
        .iter()
        .enumerate()
        .filter(|(i, m)| {
            // A damped oscillation that does not die away is driven; a motion is not.
            let is_free = m.decay_time_s.is_some() || (*i == 0 && evidence.one_motion().is_some());
            m.mode != ModeName::Other && m.relative_db > WEAKEST_DB && is_free
        })
        .map(|(i, m)| {
            (
                i,
                Quantity::new(m.period_observed_s, evidence.found.modes[i].period_se_s()),
            )
        })
        .collect();
    let result = SwingResult {
        id: evidence.id.clone(),
        span_s: Some([evidence.span.start_s, evidence.span.end_s]),
        modes,
        repairs: evidence.repairs.clone(),
        rms_over_noise: Some(evidence.found.rms_over_noise),
        motion: evidence.one_motion().map(MotionResult::from),
        ..Default::default()
    };
    let result = result.warned(warnings);
    SwingWork::of(result, Some(evidence), periods)
}

fn mode_result(
    evidence: &Evidence,
    i: usize,
    mode: &FittedMode,
    name: ModeName,
    amplitude: Option<f64>,
) -> ModeResult {
    let points = windows(evidence, i);
    let limit = match evidence.one_motion() {
        Some(motion) if i == 0 => motion.period_s,
        _ => small_limit(mode, &points),
    };
    ModeResult {
        mode: name,
        period_s: limit.value,
        period_se_s: limit.u,
        period_observed_s: mode.period_s(),
        decay_time_s: (mode.alpha_per_s > 0.0).then(|| 1.0 / mode.alpha_per_s),
        decay_time_se_s: (mode.alpha_per_s > 0.0)
            .then(|| mode.alpha_se_per_s / mode.alpha_per_s.powi(2)),
        amplitude,
        amplitude_unit: amplitude.map_or(AmplitudeUnit::None, |_| evidence.amplitude_unit),
        phase_rad: Some(phase_rad(mode)),
        relative_db: 0.0,
        parasitic: false,
        doubtful: false,
        against_amplitude: points_in_unit(&points, amplitude),
    }
}

/// Follows one mode through the record, its channels combined as its shape says.
fn windows(evidence: &Evidence, i: usize) -> Vec<WindowPoint> {
    let found = &evidence.found;
    let pole = |m: &FittedMode| Pole {
        omega_rad_s: m.omega_rad_s,
        alpha_per_s: m.alpha_per_s,
    };
    let others: Vec<Pole> = found
        .modes
        .iter()
        .enumerate()
        .filter(|(j, _)| *j != i)
        .map(|(_, m)| pole(m))
        .collect();
    let project = projection(&found.modes[i], &found.noise);
    let wanted = WindowedMode {
        span_s: (found.t_ref_s, found.t_end_s),
        mode: pole(&found.modes[i]),
        others: &others,
        project: &project,
    };
    against_amplitude(&evidence.groups, &wanted)
}

/// The combination of channels that reads 1 for the mode's own shape with the least noise.
fn projection(mode: &FittedMode, noise: &[f64]) -> Vec<Complex64> {
    let weight = |c: usize| {
        noise
            .get(c)
            .filter(|n| **n > 0.0)
            .map_or(0.0, |n| 1.0 / (n * n))
    };
    let energy: f64 = mode
        .shape
        .iter()
        .enumerate()
        .map(|(c, a)| a.norm_sqr() * weight(c))
        .sum();
    mode.shape
        .iter()
        .enumerate()
        .map(|(c, a)| a.conj() * weight(c) / energy.max(f64::MIN_POSITIVE))
        .collect()
}

/// Phase of the channel that shows the mode best.
fn phase_rad(mode: &FittedMode) -> f64 {
    mode.shape
        .iter()
        .max_by(|a, b| a.norm().total_cmp(&b.norm()))
        .map_or(0.0, |c| c.arg())
}

/// The windows' amplitude is relative to that at the start of the span: scaled to the mode's own.
fn points_in_unit(points: &[WindowPoint], amplitude: Option<f64>) -> Vec<AmplitudePoint> {
    let scale = amplitude.unwrap_or(1.0);
    points
        .iter()
        .map(|p| AmplitudePoint {
            t_s: p.t_s,
            amplitude: p.amplitude * scale,
            period_s: p.period_s,
            period_se_s: p.period_se_s,
            decrement: p.decrement,
            decrement_se: p.decrement_se,
        })
        .collect()
}

/// The period at small amplitude as the record itself shows it: by its windows where the period
/// depends on the amplitude, else the period of the whole record.
fn small_limit(mode: &FittedMode, points: &[WindowPoint]) -> Quantity {
    let observed = Quantity::new(mode.period_s(), mode.period_se_s());
    if mode.law.shift_rad_s == 0.0 {
        return observed;
    }
    match small_amplitude_limit(points) {
        Some(SmallAmplitude {
            period_s,
            period_se_s,
            ..
        }) => Quantity::new(period_s, period_se_s),
        None => {
            let omega = mode.law.omega_small_rad_s;
            Quantity::new(
                TAU / omega,
                TAU / omega * mode.law.omega_small_se_rad_s / omega,
            )
        }
    }
}

fn typed_mode(mode: ModeName, period: Quantity, amplitude_rad: Option<f64>) -> ModeResult {
    ModeResult {
        mode,
        period_s: period.value,
        period_se_s: period.u,
        period_observed_s: period.value,
        decay_time_s: None,
        decay_time_se_s: None,
        amplitude: amplitude_rad,
        amplitude_unit: amplitude_rad.map_or(AmplitudeUnit::None, |_| AmplitudeUnit::Radian),
        phase_rad: None,
        relative_db: 0.0,
        parasitic: false,
        doubtful: false,
        against_amplitude: vec![],
    }
}

fn work_typed(swing: &Swing) -> SwingWork {
    let SwingData::PeriodsS(typed) = &swing.data else {
        return SwingWork::of(SwingResult::default(), None, vec![]);
    };
    let modes: Vec<ModeResult> = typed
        .iter()
        .map(|(mode, period)| {
            typed_mode(
                *mode,
                *period,
                swing.amplitude_deg.get(mode).map(|a| a.to_radians()),
            )
        })
        .collect();
    let floor = |q: Quantity| Quantity::new(q.value, q.u.max(TYPED_PERIOD_U_RELATIVE * q.value));
    let periods = typed
        .values()
        .enumerate()
        .map(|(i, q)| (i, floor(*q)))
        .collect();
    let result = SwingResult {
        id: swing.id.clone(),
        modes,
        ..Default::default()
    };
    SwingWork::of(result, None, periods)
}

fn work_list(swing: &Swing, list: &PeriodList, hanging: &Hanging) -> Result<SwingWork> {
    let found = period_from_list(list)?;
    let period = Quantity::new(found.period_s, found.u_s);
    let name = names_by_period(&[period.value], hanging, swing)[0];
    let left_out = |entry: &FlaggedPeriod| {
        let (at_s, period_s) = (
            Argument::Number(entry.t_s, 1),
            Argument::Number(entry.period_s, 4),
        );
        message("no_single_period", [("at_s", at_s), ("period_s", period_s)])
    };
    let amplitude = |mode: &ModeName| swing.amplitude_deg.get(mode).map(|a| a.to_radians());
    let mut modes = vec![typed_mode(name, period, amplitude(&name))];
    if name == ModeName::Yaw
        && let Some(sway) = beaten_sway(period, &found.trend, hanging)
    {
        modes.push(typed_mode(ModeName::Sway, sway, amplitude(&ModeName::Sway)));
    }
    let floor = |m: &ModeResult| m.period_se_s.max(TYPED_PERIOD_U_RELATIVE * m.period_s);
    let named = modes.iter().enumerate();
    let named = named.filter(|(_, m)| m.mode != ModeName::Other);
    let periods = named
        .map(|(i, m)| (i, Quantity::new(m.period_s, floor(m))))
        .collect();
    let result = SwingResult {
        id: swing.id.clone(),
        repairs: list.repairs.clone(),
        modes,
        trend: Some(TrendResult::from(&found.trend)),
        ..Default::default()
    };
    let result = result.warned(found.flagged.iter().map(left_out).collect());
    Ok(SwingWork::of(result, None, periods))
}

/// The sway that modulates a list of yaw periods: the two beat at T_m, so 1/T_s = 1/T_y ± 1/T_m, and
/// the stated length of the lines tells which.
fn beaten_sway(yaw: Quantity, trend: &PeriodTrend, hanging: &Hanging) -> Option<Quantity> {
    let modulation = trend.modulation.as_ref()?;
    let stated_s = hanging.sway_period_s?;
    let frequency = |sign: f64| 1.0 / yaw.value + sign / modulation.t_m_s;
    let sway = [1.0, -1.0].map(|sign| 1.0 / frequency(sign));
    let distance = |period: &f64| (period / stated_s).ln().abs();
    let mut near = sway
        .into_iter()
        .filter(|period| distance(period) < NEAR_SWAY);
    // Where both are near, the stated lines do not tell which it is.
    let (Some(period_s), None) = (near.next(), near.next()) else {
        return None;
    };
    let u_hz = (yaw.u / yaw.value.powi(2)).hypot(modulation.t_m_se_s / modulation.t_m_s.powi(2));
    Some(Quantity::new(period_s, period_s * period_s * u_hz))
}

/// All observed periods with their corrections (which free them of amplitude and damping), as far
/// as these are known.
fn observations(
    session: &Session,
    works: &[SwingWork],
    corrections: &[Vec<Correction>],
) -> Vec<Observation> {
    let mut all = Vec::new();
    for (i, work) in works.iter().enumerate() {
        let hung = &session.swings[i].suspension;
        for (m, observed) in work
            .periods
            .iter()
            .filter(|(m, _)| has_motion(hung, work.result.modes[*m].mode))
        {
            let mode = &work.result.modes[*m];
            let observed = session.reading(&period_key(i, mode.mode), *observed);
            let correction = corrections.get(i).and_then(|c| c.get(*m)).copied();
            let correction = correction.unwrap_or_else(|| Correction::unknown(mode));
            let value = observed.value * correction.factor;
            let u_amplitude = value * correction.u_relative;
            all.push(Observation {
                what: Observed::Period(i, mode.mode),
                value: Quantity::new(value, observed.u.hypot(u_amplitude)),
                u_amplitude,
                label: Input::period(mode.mode, &work.result.id),
            });
        }
    }
    all
}

/// What the phones say of the pitch of each swing: the tilt against the first level swing, its
/// sense as stated. Where it is not the stated pitch, the phone was moved or the pitch misread: then
/// both are possible, and it is said.
fn phone_pitches(session: &Session, works: &[SwingWork]) -> (Vec<Option<Quantity>>, Vec<Finding>) {
    let stated = |i: usize| session.swings[i].suspension.hull_pitch_deg;
    // The tilt of a phone on a heeled hull is not the pitch.
    let is_upright = |i: &usize| session.swings[*i].suspension.hull_roll_deg.is_none();
    let seen = |i: usize| works[i].evidence.as_ref().and_then(|e| e.up);
    let up = |i: usize| seen(i).filter(|_| is_upright(&i));
    let reference = (0..works.len())
        .filter(|i| up(*i).is_some())
        .min_by(|a, b| pitch_size(stated(*a)).total_cmp(&pitch_size(stated(*b))));
    let mut moved = Vec::new();
    let pitches = (0..works.len()).map(|i| {
        let (reference, here) = (reference?, up(i)?);
        let base = stated(reference).unwrap_or_default();
        let tilt = tilt_between_rad(&up(reference)?, &here).to_degrees();
        let stated = stated(i)?;
        let sense = (stated.value - base.value).signum();
        // Below half a degree the unsigned tilt is its own noise: the stated angle stands.
        if i == reference || tilt <= 0.5 {
            return None;
        }
        let by_phone = Quantity::new(base.value + sense * tilt, base.u.hypot(PHONE_TILT_U_DEG));
        let apart = by_phone.value - stated.value;
        if apart.abs() <= FLAG_SIGMA * by_phone.u.hypot(stated.u) {
            return Some(by_phone);
        }
        let id = &session.swings[i].id;
        moved.push(phone_moved(id, stated.value, by_phone.value));
        // The standard deviation of two equally likely figures is half their distance.
        let middle = 0.5 * (by_phone.value + stated.value);
        Some(Quantity::new(
            middle,
            by_phone.u.min(stated.u).hypot(0.5 * apart),
        ))
    });
    (pitches.collect(), moved)
}

fn pitch_size(stated: Option<Quantity>) -> f64 {
    stated.map_or(0.0, |q| q.value.abs())
}

/// Incline angles from phones: the tilt against the level swings' vertical.
fn recorded_inclines(loaded: &LoadedSession, works: &[SwingWork]) -> Vec<Option<Quantity>> {
    let level = works
        .iter()
        .find_map(|w| w.evidence.as_ref().and_then(|e| e.up));
    loaded
        .inclines
        .iter()
        .zip(&loaded.session.inclines)
        .map(|(recording, incline)| recorded_incline(recording.as_ref()?, incline, &level?))
        .collect()
}

fn recorded_incline(recording: &Recording, incline: &Incline, level: &Vec3) -> Option<Quantity> {
    if !matches!(incline.angle, InclineAngle::Recording(_)) {
        return None;
    }
    let force = recording.accelerometer.as_ref()?;
    let mean = Vec3::from_fn(|i, _| force.axes[i].iter().sum::<f64>() / force.axes[i].len() as f64);
    let up = mean.try_normalize(1.0)?;
    Some(Quantity::new(
        tilt_between_rad(level, &up).to_degrees(),
        PHONE_TILT_U_DEG,
    ))
}

/// The last part of a path.
fn file_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}

/// Through fewer windows a law of two parameters goes whatever they are.
const FEWEST_WINDOWS: usize = 3;

/// The modes of a swing of which nobody says how it hangs. Where its record shows no dependence on the
/// amplitude, its period at small amplitude may be the same (a spring), shorter by A²/16 (a pendulum)
/// or by twice that (yaw on lines): of 0 to 2 A²/16 the root mean square is 2/√3 of A²/16.
fn hung_somehow(work: &SwingWork) -> Vec<ModeResult> {
    let duration_s = work.result.duration_s();
    let is_motion = |i: usize| {
        let evidence = work.evidence.as_ref();
        i == 0 && evidence.is_some_and(|e| e.one_motion().is_some())
    };
    let shows_law = |i: usize| {
        let found = work.evidence.as_ref().and_then(|e| e.found.modes.get(i));
        found.is_none_or(|mode| mode.law.shift_rad_s != 0.0)
    };
    let modes = work.result.modes.iter().enumerate();
    let corrected = modes.map(|(i, mode)| {
        let in_rad = mode.amplitude_unit == AmplitudeUnit::Radian;
        let is_known =
            is_motion(i) || (shows_law(i) && mode.against_amplitude.len() >= FEWEST_WINDOWS);
        let Some(amplitude) = mode.amplitude.filter(|_| in_rad && !is_known) else {
            return mode.clone();
        };
        let growth = amplitude * amplitude * mode.mean_square(duration_s) / 16.0;
        let unknown_s = 2.0 * growth * mode.period_s / 3.0_f64.sqrt();
        ModeResult {
            period_se_s: mode.period_se_s.hypot(unknown_s),
            ..mode.clone()
        }
    });
    corrected.collect()
}

/// Measures a bare recording: the modes alone.
pub fn measure_recording(recording: &Recording, _options: &MeasureOptions) -> Result<Analysis> {
    let gravity = gyradius_base::constants::STANDARD_GRAVITY_M_S2;
    let evidence = observe_recording(
        file_name(&recording.name),
        recording,
        gravity,
        &Hanging::default(),
        None,
    )?;
    let mut work = work_of(evidence, None);
    work.result.modes = hung_somehow(&work);
    let mut result = Measurement {
        format: FORMAT.into(),
        title: file_name(&recording.name).into(),
        ..Default::default()
    };
    result.warn(message("bare_recording", []));
    let mut found = of_recording(&work.result.id, recording, work.evidence.as_ref(), gravity);
    found.extend(of_residual(&work.result));
    if found.iter().any(Finding::refuses) {
        work.refuse();
    }
    found.into_iter().for_each(|one| result.find(one));
    result.swings.push(work.result);
    Ok(Analysis {
        measurement: result,
        evidence: vec![work.evidence],
    })
}
