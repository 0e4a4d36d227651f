//! A swing in one motion: what the sensor read of its turn, the law that it follows, and where a fit
//! begins.
//!
//! # Conventions
//! The swing turns about one axis fixed in the sensor. Times count from the start of the part that is
//! used. Numbers are in the order of [`Problem`]; those of the causes come last, in the order of a
//! set.

use std::ops::Range;

use gyradius_estimation::{Rows, Wanted};
use gyradius_identification::Evidence;
use gyradius_identification::estimate::System;
use gyradius_identification::measure::SwingWork;
use gyradius_identification::one_motion::{
    DRAG, FREQUENCY, FRICTION, Fitted, Fitting, HARDNESS_PLACE, Line, Problem, REST, Readings,
    Turn, dispersion, fit_from_afar, solve, variance,
};
use gyradius_identification::routes::yaw::Lines;
use gyradius_mechanics::one_angle::effects::Scales;
use gyradius_mechanics::one_angle::{Law, TwoLines};
use gyradius_recording::{ModeName, Suspension, SuspensionKind};
use gyradius_signal::{ChannelGroup, Pole};
use nalgebra::{DMatrix, DVector};

use super::super::cause_id::CauseId;
use super::super::point::Part;
use super::super::white::in_record;
use super::catalogue::{Cause, catalogue, nearly};

/// A swing that can be criticised.
pub struct Swing<'a> {
    pub id: &'a str,
    /// Place in the session.
    pub number: usize,
    /// Name of its motion.
    pub mode: ModeName,
    pub suspension: &'a Suspension,
    /// The sensor's channels.
    pub group: &'a ChannelGroup,
    pub law: Law,
    /// Every form of every cause.
    pub catalogue: Vec<Cause>,
    /// Fitted as every swing is that is measured: readings along the axis, lines beside the swing, and
    /// a motion near the truth.
    pub measured: Fitted,
    /// Noise that a model's evidence counts with: what even the richest model leaves is noise to
    /// all of them.
    pub noise: f64,
    /// Blocks that are fitted where something is held out, and those held out.
    parts: [Vec<Range<usize>>; 2],
}

impl<'a> Swing<'a> {
    /// A swing of a session; `None` where no sensor tells its turn, or no motion can be fitted.
    pub fn of(system: &System<'a>, x: &[f64], work: &'a SwingWork, number: usize) -> Option<Self> {
        let evidence = work.evidence.as_ref()?;
        let (turn, span_s) = evidence.turn()?;
        let suspension = &system.session.swings[number].suspension;
        let name = |mode: usize| match suspension.kind {
            SuspensionKind::Compound => ModeName::Compound,
            _ => name_of(evidence, &turn, mode),
        };
        let fits = turn.strongest().into_iter().filter_map(|mode| {
            let readings = Readings::of(&turn, span_s, mode)?;
            let all = variance(&readings.values);
            let law = law(system, x, number, name(mode));
            // By the law that is stated, and by one that is fitted: whichever follows the swing.
            let ways = [Some(law), None].into_iter();
            let fits = ways.filter_map(|law| {
                let fitted = fit_from_afar(readings.clone(), law)?;
                let left = fitted.left()?;
                let square = left.iter().map(|r| r * r).sum::<f64>() / left.len().max(1) as f64;
                Some((square / all, fitted))
            });
            let best = fits.min_by(|a, b| a.0.total_cmp(&b.0))?;
            Some((best.0, best.1, law, mode))
        });
        let (_, measured, law, mode) = fits.min_by(|a, b| a.0.total_cmp(&b.0))?;
        let readings = &measured.readings;
        let duration_s = readings.duration_s();
        let part = |part: Part| {
            let counts = |b: &&Range<usize>| part.has(readings.t_s[b.start], duration_s);
            readings.blocks.iter().filter(counts).cloned().collect()
        };
        let parts = [part(Part::Fitted), part(Part::HeldOut)];
        let scales = measured.start.scales();
        let mut swing = Self {
            id: &system.session.swings[number].id,
            number,
            mode: name(mode),
            suspension,
            group: turn.group,
            law,
            catalogue: catalogue(&scales, law, readings.is_angle, duration_s),
            noise: readings.noise,
            parts,
            measured,
        };
        let (level, dispersion) = swing.richest()?;
        swing.measured.readings.noise *= level;
        swing.noise *= dispersion.max(1.0).sqrt();
        Some(swing)
    }

    pub fn scales(&self) -> Scales {
        self.measured.start.scales()
    }

    pub fn readings(&self) -> &Readings {
        &self.measured.readings
    }

    pub fn fittings(&self, set: &[usize]) -> Vec<Fitting<'_>> {
        set.iter()
            .map(|form| self.catalogue[*form].fitting())
            .collect()
    }

    /// The fit of causes to the whole record.
    pub fn problem<'b>(&'b self, effects: &'b [Fitting<'b>]) -> Problem<'b> {
        Problem {
            readings: self.readings(),
            law: self.law,
            scales: self.scales(),
            lines: &self.measured.lines,
            effects,
            blocks: &self.readings().blocks,
            noise: self.noise,
        }
    }

    /// What is left of the blocks that are held out, over the noise of the samples; fitted to the others
    /// from a start.
    pub fn held_out(&self, effects: &[Fitting], start: &[f64]) -> Option<DVector<f64>> {
        let [fitted, held_out] = &self.parts;
        let there = Problem {
            blocks: fitted,
            ..self.problem(effects)
        };
        let held_out = Problem {
            blocks: held_out,
            noise: self.readings().noise,
            ..self.problem(effects)
        };
        let x = solve(&there, start)?.x;
        Some(held_out.rows(0, &x, &[], Wanted::Residuals)?.residuals)
    }

    /// Where the causes' numbers begin.
    pub fn first_cause(&self) -> usize {
        self.problem(&[]).first_effect()
    }

    /// The causes of a set with the places of their numbers in a model of it.
    pub fn causes_of<'b>(
        &'b self,
        set: &'b [usize],
    ) -> impl Iterator<Item = (usize, &'b Cause, Range<usize>)> {
        let mut next = self.first_cause();
        set.iter().map(move |form| {
            let cause = &self.catalogue[*form];
            let from = next;
            next += cause.known.len();
            (*form, cause, from..next)
        })
    }

    /// The form of each cause with the widest prior.
    pub fn form_of(&self, id: CauseId) -> Option<usize> {
        self.catalogue.iter().rposition(|cause| cause.id == id)
    }

    /// Drag, friction, restoring force: the set that a measurement fits.
    pub fn measured_set(&self) -> Vec<usize> {
        let ids = [
            CauseId::QuadraticDrag,
            CauseId::BearingFriction,
            CauseId::RestoringForce,
        ];
        ids.iter().filter_map(|id| self.form_of(*id)).collect()
    }

    /// Where a fit of a set begins by what was measured: causes that it does not hold do nothing.
    pub fn start_of(&self, set: &[usize]) -> Vec<f64> {
        let (first, x) = (self.first_cause(), &self.measured.fit.x);
        let number = |place: usize| x.get(first + place).copied();
        let mut start = x[..first].to_vec();
        for form in set {
            let cause = &self.catalogue[*form];
            let known = match cause.id {
                CauseId::QuadraticDrag => number(DRAG),
                CauseId::BearingFriction => number(FRICTION),
                CauseId::RestoringForce => self.bent(number(HARDNESS_PLACE)),
                _ => None,
            };
            match known {
                Some(value) => start.push(value),
                None => start.extend(cause.absent()),
            }
        }
        start
    }

    /// κ beside the law that is stated, of the κ beside a spring that was fitted.
    fn bent(&self, hardness: Option<f64>) -> Option<f64> {
        match (self.law, hardness) {
            (_, None) | (Law::TwoLines(_), _) => Some(0.0),
            (Law::Linear, known) => known,
            (Law::Pendulum, Some(known)) => Some(known - 1.0),
        }
    }

    /// What the richest model says of the noise: by what factor it is larger than thought where
    /// nothing but white noise is left, and by what factor more is left along what is fitted than such
    /// noise would leave, squared.
    fn richest(&self) -> Option<(f64, f64)> {
        let mut set = self.measured_set();
        set.extend(self.form_of(CauseId::Unknown));
        let effects = self.fittings(&set);
        let fit = solve(&self.problem(&effects), &self.start_of(&set))?;
        let left = self.left(&set, &fit.x)?;
        let level = (left.norm_squared() / left.len().max(1) as f64).sqrt();
        let levelled = left / level;
        let is_white = in_record((0, 0), &self.block_times_s(), levelled.as_slice(), 1).is_empty();
        let dispersion = self.dispersion(&set, &fit.x, &fit.covariance().ok()?)?;
        Some((if is_white { level.max(1.0) } else { 1.0 }, dispersion))
    }

    /// By what factor a model leaves more than white noise would along all that is fitted, or along the
    /// frequency if that is more, squared.
    pub fn dispersion(&self, set: &[usize], x: &[f64], covariance: &DMatrix<f64>) -> Option<f64> {
        let effects = self.fittings(set);
        let problem = self.problem(&effects);
        let free = covariance.diagonal().iter().filter(|v| **v > 0.0).count();
        let eigen = covariance.clone().symmetric_eigen();
        let scale = eigen.eigenvalues.map(|value| value.max(0.0).sqrt());
        let directions = &eigen.eigenvectors * DMatrix::from_diagonal(&scale);
        let rows = problem.rows(0, x, &[], Wanted::Jacobian)?;
        let of_all = dispersion(&problem, &rows, free, &directions)?;
        let frequency = DMatrix::from_columns(&[covariance.column(FREQUENCY)]);
        Some(of_all.max(dispersion(&problem, &rows, free, &frequency)?))
    }

    /// What is left of the blocks, over the noise of the samples.
    pub fn left(&self, set: &[usize], x: &[f64]) -> Option<DVector<f64>> {
        let effects = self.fittings(set);
        let problem = Problem {
            noise: self.readings().noise,
            ..self.problem(&effects)
        };
        Some(problem.rows(0, x, &[], Wanted::Residuals)?.residuals)
    }

    /// When the blocks begin, s.
    pub fn block_times_s(&self) -> Vec<f64> {
        let readings = self.readings();
        let blocks = readings.blocks.iter();
        blocks.map(|block| readings.t_s[block.start]).collect()
    }

    /// What the sensor reads at every sample.
    pub fn simulated(&self, set: &[usize], x: &[f64]) -> Option<Vec<f64>> {
        self.problem(&self.fittings(set)).at_samples(x)
    }

    /// Poles of the weak lines beside it.
    pub fn poles(&self, x: &[f64]) -> Vec<Pole> {
        Line::poles(&self.measured.lines, &x[REST + 1..])
    }

    /// Standard uncertainty of the logarithm of the frequency where the laws of causes are nearly
    /// right: a force acts beside them that is so large a share of theirs. None where they have none.
    pub fn frequency_u(&self, set: &[usize], x: &[f64], share: f64) -> Option<f64> {
        let scales = self.scales();
        let mut forces = [0.0; 2];
        for (_, cause, places) in self.causes_of(set) {
            if cause.id != CauseId::Unknown {
                let own = cause.shares(&x[places], &scales);
                forces = [forces[0] + share * own[0], forces[1] + share * own[1]];
            }
        }
        let (effect, parameters) = nearly(forces);
        if parameters.is_empty() {
            return None;
        }
        let mut effects = self.fittings(set);
        effects.push(Fitting {
            effect: &effect,
            parameters: &parameters,
        });
        let problem = self.problem(&effects);
        let mut numbers = x.to_vec();
        numbers.resize(problem.count(), 0.0);
        let jacobian = problem.rows(0, &numbers, &[], Wanted::Jacobian)?.jacobian?;
        let mut information = jacobian.tr_mul(&jacobian);
        for (k, parameter) in problem.parameters().iter().enumerate() {
            information[(k, k)] += parameter.prior.map_or(0.0, |(_, u)| u.powi(-2));
        }
        let covariance = information.cholesky()?.inverse();
        Some(covariance[(FREQUENCY, FREQUENCY)].max(0.0).sqrt())
    }

    /// Period of small undamped swings, s.
    pub fn period_s(&self, numbers: &[f64]) -> f64 {
        std::f64::consts::TAU / (self.scales().omega_rad_s * numbers[FREQUENCY].exp())
    }
}

/// The name of what a mode of the turn is.
fn name_of(evidence: &Evidence, turn: &Turn, mode: usize) -> ModeName {
    let omega = turn.found.modes[mode].omega_rad_s;
    let near = |(k, _): &(usize, _)| {
        let other = evidence.found.modes.get(*k);
        other.is_some_and(|other| (other.omega_rad_s / omega - 1.0).abs() < 1e-6)
    };
    let named = evidence.named.iter().enumerate().find(near);
    named.map_or(ModeName::Other, |(_, named)| named.name)
}

/// The law of a swing as its suspension is stated.
fn law(system: &System, x: &[f64], number: usize, mode: ModeName) -> Law {
    let (suspension, index) = (
        &system.session.swings[number].suspension,
        &system.layout.swings[number],
    );
    if suspension.kind == SuspensionKind::Compound {
        return Law::Pendulum;
    }
    let value = |i: Option<usize>| i.map(|i| x[i]);
    let lines = || {
        let (bottom, top) = (value(index.spacing)?, value(index.top_spacing)?);
        let lines = Lines {
            length_m: value(index.line_length)?,
            half_spacing_m: 0.5 * bottom,
            top_half_spacing_m: 0.5 * top,
        };
        let height_m = lines.height_m().ok()?;
        let half_spacings_m = [lines.half_spacing_m, lines.top_half_spacing_m];
        let gravity_m_s2 = x[system.layout.gravity];
        Some(TwoLines::new(half_spacings_m, height_m, gravity_m_s2))
    };
    let yaw = (mode == ModeName::Yaw).then(lines).flatten();
    yaw.map_or(Law::Linear, Law::TwoLines)
}
