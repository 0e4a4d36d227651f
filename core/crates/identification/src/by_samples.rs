//! The estimate from the samples of all swings that the simulation explains, and the periods of the
//! others.
//!
//! Level swings are fitted each by itself, tilted ones beside what the level ones say (a tilted
//! hull seen from its other end is another hull), swings that contradict the rest once more beside
//! the rest; in the end all of them together.

use super::names::{Input, InputKind};
use crate::modes::NamedMode;
use gyradius_base::error::Result;
use gyradius_base::parallel::in_parallel;
use gyradius_recording::{ModeName, Quantity, Session, SuspensionKind, Swing};

use super::estimate::{Observation, Observed, Solution, System};
use super::findings::{Finding, of_amplitude};
use super::measure::{estimate, work_of};
use super::measurement::{ModeResult, SwingResult};
use super::observe::{Evidence, hints_contradicted, parasites};
use super::parameters::Layout;
use super::routes::finite_amplitude::yaw_period_at_amplitude_s;
use super::routes::yaw::yaw_gyradius_m;
use super::samples::{FittedSwing, Statement, Ways};
use super::swing_work::{SwingWork, WEAKEST_DB};
use super::theory::{swing_lines, upright};

/// A swing contradicts the others where leaving it out takes more off χ²: chance takes 30 of some
/// ten figures once in a thousand times (χ² of 10 degrees of freedom).
const CONTRADICTION: f64 = 30.0;
/// Of swings that contradict each other, those that take off so much of the most may be the one
/// that is wrong.
const ALIKE: f64 = 0.5;
/// Of the logarithm of a gyradius, where a swing by itself says little of it.
const ABOUT_LOG_U: f64 = 0.1;
/// Pitch of a hanging that counts as level, degrees.
const LEVEL_DEG: f64 = 3.0;
/// Residual over noise beyond which a fit may have lost its way.
const LOST: f64 = 3.0;
/// Logarithms of yaw gyradii to begin anew with, beside the one agreed on.
const OTHER_YAWS: [f64; 5] = [0.0, -0.25, -0.12, 0.12, 0.25];
/// A line in the spectrum this near to a simulated period is that mode, relative.
const SAME_LINE: f64 = 0.02;

/// What is fitted, and the swings' evidence.
struct Samples<'a> {
    session: &'a Session,
    layout: &'a Layout,
    evidence: Vec<Option<&'a Evidence>>,
}

type Fits<'a> = Vec<Option<FittedSwing<'a>>>;

/// From the estimate by periods to that by samples, which takes the place of the periods of every
/// swing that it explains.
pub fn by_samples(
    system: &mut System,
    works: &mut [SwingWork],
    inclines: &[Option<Quantity>],
    by_periods: Result<Solution>,
) -> (Result<Solution>, Vec<Finding>) {
    let (session, layout) = (system.session, system.layout.clone());
    let x = by_periods
        .as_ref()
        .map_or_else(|_| layout.start(), |s| s.x.clone());
    let evidence = works.iter().map(|w| w.evidence.as_ref()).collect();
    let samples = Samples {
        session,
        layout: &layout,
        evidence,
    };
    let mut fits = samples.fitted(system, &x, inclines);
    let is_simulated = fits.iter().any(Option::is_some);
    let (x, together) = match is_simulated {
        true => samples.together(system, &mut fits, inclines),
        false => None,
    }
    .unwrap_or((x, false));
    let found: Vec<Option<Found>> = fits
        .iter()
        .map(|fit| fit.as_ref().and_then(Found::of))
        .collect();
    let mut said = statements(&fits, together);
    said.iter_mut()
        .zip(&found)
        .filter(|(_, found)| found.is_none())
        .for_each(|(said, _)| said.clear());
    drop(fits);
    let (any, told) = as_one_motion(system, works, &|i| found[i].is_none());
    let by_periods = match any {
        true => estimate(system, session, works, inclines),
        false => by_periods,
    };
    if !is_simulated {
        return (by_periods, told);
    }
    let is_other =
        |o: &Observation| !matches!(o.what, Observed::Period(i, _) if found[i].is_some());
    system.periods.retain(is_other);
    let others = system.periods.clone();
    system.state(&others, &said, inclines);
    for (i, found) in found
        .into_iter()
        .enumerate()
        .filter_map(|(i, found)| Some((i, found?)))
    {
        system
            .periods
            .extend(periods(i, &found.modes, &session.swings[i]));
        works[i].take_modes(found, &session.swings[i]);
    }
    (system.solve(&x), told)
}

/// Yaw on lines that no simulation explains, dry friction or drag say, or of which only one sensor
/// tells: as one motion in one angle, where that describes it. Whether there is any, and what is not
/// plausible in it; a swing that is refused is no motion any more.
fn as_one_motion(
    system: &System,
    works: &mut [SwingWork],
    is_wanted: &dyn Fn(usize) -> bool,
) -> (bool, Vec<Finding>) {
    let session = system.session;
    let (mut any, mut told) = (false, vec![]);
    for (i, work) in works.iter_mut().enumerate() {
        let swing = &session.swings[i];
        let hung_on_lines = matches!(
            swing.suspension.kind,
            SuspensionKind::Bifilar | SuspensionKind::Trifilar
        );
        if !(hung_on_lines && is_wanted(i)) {
            continue;
        }
        let evidence = work.evidence.as_ref();
        let Some(found) = evidence.and_then(Evidence::with_yaw_motion) else {
            continue;
        };
        let law = system.hardness_of_lines(i, &found);
        let finding = law.and_then(|law| of_amplitude(&swing.id, &found, (ModeName::Yaw, law)));
        *work = work_of(found, Some(swing));
        if finding.as_ref().is_some_and(Finding::refuses) {
            work.refuse();
        }
        told.extend(finding);
        any = true;
    }
    (any, told)
}

/// The simulation nearest to each swing that a phone recorded on two lines, from parameters of the
/// session.
pub fn nearest_fits<'a>(
    system: &'a System<'a>,
    works: &'a [SwingWork],
    x: &[f64],
    inclines: &[Option<Quantity>],
) -> Vec<Option<FittedSwing<'a>>> {
    let evidence = works.iter().map(|w| w.evidence.as_ref()).collect();
    let samples = Samples {
        session: system.session,
        layout: &system.layout,
        evidence,
    };
    samples.nearest(system, x, inclines)
}

/// What the simulation found in a swing.
struct Found {
    modes: Vec<ModeResult>,
    rms_over_noise: f64,
}

impl Found {
    fn of(fit: &FittedSwing) -> Option<Self> {
        Some(Self {
            modes: fit.modes().ok()?,
            rms_over_noise: fit.rms_over_noise(),
        })
    }
}

/// What each swing says.
fn statements(fits: &Fits, together: bool) -> Vec<Vec<Statement>> {
    fits.iter()
        .map(|fit| fit.as_ref().map_or(vec![], |fit| fit.statements(together)))
        .collect()
}

impl<'a> Samples<'a> {
    /// The swings fitted, each as well as what the others say allows.
    fn fitted(&self, system: &mut System, x: &[f64], inclines: &[Option<Quantity>]) -> Fits<'a> {
        let mut fits = self.each(
            system,
            x,
            &|i| self.is_level(i),
            (&self.about(x), Ways::FIRST),
        );
        let level = statements(&fits, false).concat();
        let x = system
            .agreed(&statements(&fits, false), inclines)
            .unwrap_or_else(|| x.to_vec());
        let tilted = self.each(system, &x, &|i| !self.is_level(i), (&level, Ways::FIRST));
        fits.iter_mut()
            .zip(tilted)
            .filter(|(_, tilted)| tilted.is_some())
            .for_each(|(fit, tilted)| *fit = tilted);
        for _ in 0..fits.len() {
            let Some((i, fit)) = self.mended(system, &fits, inclines) else {
                break;
            };
            fits[i] = Some(fit);
        }
        self.fill(system, &mut fits, inclines);
        fits
    }

    /// Gyradii are about those given: a swing by itself that says nothing of one would lead it
    /// astray, and what it says of the others would be told from there.
    fn about(&self, x: &[f64]) -> Vec<Statement> {
        let about = |i: usize| Statement {
            row: vec![(i, ABOUT_LOG_U.recip())],
            value: x[i] / ABOUT_LOG_U,
        };
        self.layout.log_gyradii.map(about).to_vec()
    }

    fn is_level(&self, i: usize) -> bool {
        self.layout.parameters[self.layout.swings[i].pitch_deg]
            .prior
            .value
            .abs()
            < LEVEL_DEG
    }

    fn fit(
        &self,
        i: usize,
        starts: &[Vec<f64>],
        (known, ways): (&[Statement], Ways),
    ) -> Option<FittedSwing<'a>> {
        FittedSwing::of(
            (self.session, self.layout, i),
            starts,
            known,
            self.evidence[i]?,
            ways,
        )
    }

    /// Each of the swings wanted, side by side.
    fn each(
        &self,
        system: &System,
        x: &[f64],
        wanted: &(dyn Fn(usize) -> bool + Sync),
        beside: (&[Statement], Ways),
    ) -> Fits<'a> {
        let one = |i: usize| {
            if !wanted(i) || self.evidence[i].is_none() {
                return None;
            }
            self.fit(i, &self.starts(system, x, i), beside)
        };
        in_parallel(self.evidence.len(), one)
    }

    /// The simulation nearest to each swing that a phone recorded on two lines, whether it explains
    /// the record or not. A swing that has lost its way begins anew from what all agree on; one
    /// that is lost says little there.
    fn nearest(&self, system: &System, x: &[f64], inclines: &[Option<Quantity>]) -> Fits<'a> {
        let nearest = |i: usize, starts: &[Vec<f64>]| {
            FittedSwing::nearest((self.session, self.layout, i), starts, self.evidence[i]?)
        };
        let mut fits = in_parallel(self.evidence.len(), |i| {
            nearest(i, &self.starts(system, x, i))
        });
        let Some(agreed) = system.agreed(&statements(&fits, false), inclines) else {
            return fits;
        };
        let is_lost = |i: &usize| {
            fits[*i]
                .as_ref()
                .is_none_or(|fit| fit.rms_over_noise() > LOST && !fit.explains())
        };
        let lost: Vec<usize> = (0..fits.len()).filter(is_lost).collect();
        let again = in_parallel(lost.len(), |k| nearest(lost[k], &self.other_yaws(&agreed)));
        for (i, found) in lost.into_iter().zip(again) {
            let cost = |fit: &Option<FittedSwing<'a>>| {
                fit.as_ref().map_or(f64::INFINITY, FittedSwing::cost)
            };
            if cost(&found) < cost(&fits[i]) {
                fits[i] = found;
            }
        }
        fits
    }

    /// Parameters, and the same with other yaw gyradii: a hull whose motions act strongly on each
    /// other may show no line at its yaw period.
    fn other_yaws(&self, x: &[f64]) -> Vec<Vec<f64>> {
        let [_, _, yaw] = self.layout.log_gyradii;
        let at = |by: &f64| {
            let mut other = x.to_vec();
            other[yaw] += by;
            other
        };
        OTHER_YAWS.iter().map(at).collect()
    }

    /// Sets of the session's parameters to begin with: those of all periods, those stated, those of
    /// this swing's periods; a hull whose yaw gyradius is that in pitch, as hulls nearly have it;
    /// and a tilted hull hung from other points of the same deck, whose centre of mass then lies
    /// deeper by 1/cos of the tilt.
    fn starts(&self, system: &System, x: &[f64], i: usize) -> Vec<Vec<f64>> {
        let [_, pitch, yaw] = self.layout.log_gyradii;
        let mut alike = x.to_vec();
        alike[yaw] = x[pitch];
        let mut starts = vec![x.to_vec(), self.layout.start(), alike];
        if let Some(level) = (0..self.layout.swings.len())
            .find(|i| self.is_level(*i))
            .filter(|_| !self.is_level(i))
        {
            let (index, level) = (&self.layout.swings[i], &self.layout.swings[level]);
            let mut deeper = x.to_vec();
            deeper[index.log_depth] = x[level.log_depth] - upright(x, index).ln();
            starts.insert(0, deeper);
        }
        starts.extend(system.by_one_swing(i));
        starts
    }

    /// The swing that contradicts the others most, fitted beside what they say, where that serves
    /// all better.
    fn mended(
        &self,
        system: &System,
        fits: &Fits<'a>,
        inclines: &[Option<Quantity>],
    ) -> Option<(usize, FittedSwing<'a>)> {
        let said = statements(fits, false);
        let all = system.agreement(&said, inclines)?;
        let without = |i: usize| {
            let mut others = said.clone();
            others[i].clear();
            let rest = system.agreement(&others, inclines)?;
            Some((i, all.chi2 - rest.chi2, rest.x, others.concat()))
        };
        let taken: Vec<_> = (0..fits.len())
            .filter(|i| fits[*i].is_some())
            .filter_map(without)
            .collect();
        let most = taken.iter().map(|t| t.1).fold(0.0, f64::max);
        if most < CONTRADICTION {
            return None;
        }
        let suspects: Vec<_> = taken.into_iter().filter(|t| t.1 > ALIKE * most).collect();
        let again = in_parallel(suspects.len(), |k| {
            let (i, _, x, known) = &suspects[k];
            let before = fits[*i].as_ref()?;
            let fit = self.fit(*i, &self.starts_beside(x, before), (known, Ways::FIRST))?;
            let misfit: f64 = known.iter().map(|s| s.misfit(before.x()).powi(2)).sum();
            let gain = before.cost() + misfit - fit.cost();
            (gain > CONTRADICTION).then_some((gain, *i, fit))
        });
        let best = again
            .into_iter()
            .flatten()
            .max_by(|a, b| a.0.total_cmp(&b.0))?;
        Some((best.1, best.2))
    }

    /// What the others agree on; and the same with what they may say nothing of as the swing itself
    /// had it.
    fn starts_beside(&self, x: &[f64], before: &FittedSwing) -> Vec<Vec<f64>> {
        let [_, _, yaw] = self.layout.log_gyradii;
        let with = |own: &[usize]| {
            let mut start = x.to_vec();
            own.iter().for_each(|i| start[*i] = before.x()[*i]);
            start
        };
        vec![
            x.to_vec(),
            with(&[yaw]),
            with(&[yaw, self.layout.product_xz]),
        ]
    }

    /// What a swing misses from its own start, it may find from what the others say, or in other ways.
    fn fill(&self, system: &System, fits: &mut Fits<'a>, inclines: &[Option<Quantity>]) {
        let said = statements(fits, false);
        let Some(agreed) = system.agreed(&said, inclines) else {
            return;
        };
        let known = said.concat();
        let beside = (&known[..], Ways::ALL);
        let found = self.each(system, &agreed, &|i| fits[i].is_none(), beside);
        fits.iter_mut()
            .zip(found)
            .filter(|(fit, _)| fit.is_none())
            .for_each(|(fit, found)| *fit = found);
    }

    /// One body for all swings: the parameters they agree on, and whether they do.
    fn together(
        &self,
        system: &mut System,
        fits: &mut Fits<'a>,
        inclines: &[Option<Quantity>],
    ) -> Option<(Vec<f64>, bool)> {
        let mut x = system.agreed(&statements(fits, false), inclines)?;
        let product = self.layout.product_xz;
        if !fits.iter().flatten().any(FittedSwing::tells_bow_from_stern) {
            // The swing that is surest of it; its sign hangs on a heading that nobody knows.
            let of = |fit: &FittedSwing<'a>| fit.product();
            let surest = fits
                .iter()
                .flatten()
                .map(of)
                .max_by(|a, b| a.1.total_cmp(&b.1))?;
            x[product] = surest.0;
        }
        let from = [vec![x.clone()], self.other_hangings(fits, &x)].concat();
        let mut fitted: Vec<&mut FittedSwing> = fits.iter_mut().flatten().collect();
        let agree = from
            .iter()
            .any(|x| FittedSwing::fit_together(&mut fitted, x).unwrap_or(false));
        Some((x, agree))
    }

    /// Parameters with the pitch of the swing that by itself hangs most unlike them, bow up and bow
    /// down, where that is another by more than its stated uncertainty: how a hull hangs and how
    /// its principal axes lie look much alike, and the sign of both hangs on a heading.
    fn other_hangings(&self, fits: &Fits, x: &[f64]) -> Vec<Vec<f64>> {
        let own = fits
            .iter()
            .zip(&self.layout.swings)
            .filter_map(|(fit, index)| {
                let (pitch, own) = (index.pitch_deg, fit.as_ref()?.x()[index.pitch_deg]);
                Some((
                    pitch,
                    own,
                    (own - x[pitch]).abs() / self.layout.parameters[pitch].prior.u,
                ))
            });
        let Some((pitch, own, _)) = own.filter(|o| o.2 > 1.0).max_by(|a, b| a.2.total_cmp(&b.2))
        else {
            return vec![];
        };
        let at = |deg: f64| {
            let mut other = x.to_vec();
            other[pitch] = deg;
            other
        };
        vec![at(own), at(-own)]
    }
}

fn periods(i: usize, modes: &[ModeResult], stated: &Swing) -> Vec<Observation> {
    let observation = |mode: &ModeResult| Observation {
        what: Observed::Period(i, mode.mode),
        value: Quantity::new(mode.period_s, mode.period_se_s),
        u_amplitude: 0.0,
        label: Input::period(mode.mode, &stated.id),
    };
    modes
        .iter()
        .filter(|m| m.relative_db > WEAKEST_DB)
        .map(observation)
        .collect()
}

impl System<'_> {
    /// κ of the stated lines: by how much the period of a yaw grows to its first amplitude, over A²/16.
    fn hardness_of_lines(&self, i: usize, evidence: &Evidence) -> Option<f64> {
        let motion = evidence.one_motion()?;
        let x = self.layout.start();
        let lines = swing_lines(&x, &self.session.swings[i], &self.layout.swings[i]).ok()?;
        let (small_s, gravity) = (motion.period_s.value, x[self.layout.gravity]);
        let k_m = yaw_gyradius_m(small_s, &lines, gravity).ok()?;
        let amplitude = motion.amplitude_rad;
        let large_s = yaw_period_at_amplitude_s(k_m, &lines, gravity, amplitude).ok()?;
        Some((large_s / small_s - 1.0) * 16.0 / amplitude.powi(2))
    }

    /// Parameters from the periods of one swing alone.
    fn by_one_swing(&self, i: usize) -> Option<Vec<f64>> {
        let mut alone = self.with(self.layout.clone());
        alone
            .observations
            .retain(|o| matches!(o.what, Observed::Period(j, _) if i == j));
        Some(alone.solve(&self.layout.start()).ok()?.x)
    }

    /// What the swings agree on by their samples.
    fn agreement(
        &self,
        said: &[Vec<Statement>],
        inclines: &[Option<Quantity>],
    ) -> Option<Solution> {
        let mut system = self.with(self.layout.clone());
        system.state(&[], said, inclines);
        system.solve(&self.layout.start()).ok()
    }

    /// Whether statements of the swings and inclines agree: those that do.
    pub fn agreed(
        &self,
        said: &[Vec<Statement>],
        inclines: &[Option<Quantity>],
    ) -> Option<Vec<f64>> {
        Some(self.agreement(said, inclines)?.x)
    }

    /// Takes in what the fitted swings say, the periods of the others and the inclines.
    pub fn state(
        &mut self,
        others: &[Observation],
        said: &[Vec<Statement>],
        inclines: &[Option<Quantity>],
    ) {
        self.observations = others.to_vec();
        let beside = self.beside_swings(inclines);
        self.observations.extend(beside);
        self.statements.clear();
        for (i, statements) in said.iter().enumerate() {
            for statement in statements {
                self.observations.push(Observation {
                    what: Observed::Statement(self.statements.len()),
                    value: Quantity::new(statement.value, 1.0),
                    u_amplitude: 0.0,
                    label: Input::of(InputKind::Samples, &self.session.swings[i].id),
                });
                self.statements.push(statement.clone());
            }
        }
    }
}

impl SwingWork {
    /// The modes of the simulation in place of lines in the spectrum; those lines take their names.
    fn take_modes(&mut self, found: Found, stated: &Swing) {
        let Found {
            mut modes,
            rms_over_noise,
        } = found;
        let Some(evidence) = self.evidence.as_mut() else {
            return;
        };
        for (line, named) in evidence.found.modes.iter().zip(&mut evidence.named) {
            let near = modes
                .iter()
                .find(|m| (line.period_s() / m.period_s - 1.0).abs() < SAME_LINE);
            named.name = near.map_or(ModeName::Other, |m| m.mode);
        }
        for mode in &mut modes {
            let of_line =
                |l: &&ModeResult| (l.period_observed_s / mode.period_s - 1.0).abs() < SAME_LINE;
            if let Some(line) = self
                .result
                .modes
                .iter()
                .filter(of_line)
                .max_by(|a, b| a.relative_db.total_cmp(&b.relative_db))
            {
                mode.period_observed_s = line.period_observed_s;
                mode.against_amplitude = line.against_amplitude.clone();
            }
        }
        let named: Vec<NamedMode> = modes
            .iter()
            .map(|m| NamedMode {
                name: m.mode,
                angle_rad: m.amplitude,
            })
            .collect();
        let mut warnings = evidence.warnings.clone();
        // Those of the damped oscillations, which no longer stand.
        warnings.retain(|w| !evidence.found.warnings.contains(w));
        warnings.extend(hints_contradicted(&named, Some(stated)));
        for (mode, (db, parasitic)) in
            modes
                .iter_mut()
                .zip(parasites(&named, Some(stated), &mut warnings))
        {
            (mode.relative_db, mode.parasitic) = (db, parasitic);
        }
        self.periods = vec![];
        let result = SwingResult {
            modes,
            rms_over_noise: Some(rms_over_noise),
            simulated: true,
            ..std::mem::take(&mut self.result)
        };
        self.result = result.warned(warnings);
    }
}
