//! A swing in one motion: its gyroscope's samples, the law that it follows, and what is fitted to
//! it.
//!
//! # Conventions
//! The swing turns about one axis fixed in the phone, which the shape of its line in the spectrum
//! shows. Along it the gyroscope reads the rate of the swing, a constant bias, and weak lines:
//! damped oscillations that the record holds beside the swing. What turns across the axis is no
//! part of the motion in one angle. Times count from the start of the part that is used. Parameters
//! in order: [`OWN`] of the swing itself, [`LINE`] of each line, those of the causes.

use std::ops::Range;

use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;

use super::super::point::{CauseParameter, Part};
use super::super::shape::{direction, energy, shape};
use super::causes::{Cause, Now, Scales, catalogue};
use gyradius_base::frames::Vec3;
use gyradius_identification::Evidence;
use gyradius_identification::estimate::System;
use gyradius_identification::measure::SwingWork;
use gyradius_identification::routes::yaw::Lines;
use gyradius_identification::samples::{Stream, Turning};
use gyradius_mechanics::one_angle::{Law, Torque, TwoLines, follow};
use gyradius_recording::{ModeName, Suspension, SuspensionKind};
use gyradius_signal::{FittedMode, Pole};

/// Angle and rate at the start, logarithm of the frequency over that of the spectrum, linear
/// damping, bias.
const OWN: usize = 5;
const START_RAD: usize = 0;
const START_RAD_S: usize = 1;
pub const FREQUENCY: usize = 2;
pub const DAMPING: usize = 3;
const BIAS: usize = 4;
/// Logarithm of a line's frequency over that of the spectrum, its damping, and its amplitudes
/// (cosine, sine).
const LINE: usize = 4;
/// So many weak lines are taken off at most.
const MOST_LINES: usize = 2;
/// A line nearer to the swing than this, relative, cannot be told from the swing's own changes;
/// nearer than the second to one of its multiples it is a part of it.
const OWN_LINE: f64 = 0.1;
const OVERTONE: f64 = 0.03;
/// A weak line must stand out by this, dB.
const LEAST_LINE_DB: f64 = 20.0;
/// Widths of the priors: logarithm of the swing's frequency, share of critical damping, logarithm
/// of a line's frequency.
const FREQUENCY_U: f64 = 0.3;
pub const DAMPING_U: f64 = 0.1;
const LINE_U: f64 = 0.02;
/// A line stays where the spectrum has it to this: one that wandered to the swing's own frequency
/// would take a part of the swing.
const LINE_STAYS: f64 = 0.05;
/// Steps of numerical derivatives, in widths of the priors.
const STEP: f64 = 1e-5;

/// A line beside the swing.
#[derive(Debug, Clone)]
struct Line {
    omega_rad_s: f64,
    alpha_per_s: f64,
    /// Amplitudes of cosine and sine.
    amplitudes: [f64; 2],
}

/// A swing that can be criticised.
pub struct Swing<'a> {
    pub id: &'a str,
    /// Place in the session.
    pub number: usize,
    /// Name of its motion.
    pub mode: ModeName,
    pub suspension: &'a Suspension,
    /// The gyroscope's samples, and their part along the axis with its noise, rad/s.
    pub stream: Stream,
    pub rates_rad_s: Vec<f64>,
    pub noise_rad_s: f64,
    pub duration_s: f64,
    pub law: Law,
    pub scales: Scales,
    /// All causes, strengths scaled to this swing.
    pub catalogue: Vec<Cause>,
    /// The axis of the swing in the phone.
    pub axis: Vec3,
    lines: Vec<Line>,
    /// Where a fit begins.
    pub start: Vec<f64>,
}

impl<'a> Swing<'a> {
    /// A swing of a session; `None` where no gyroscope saw it, or nothing turns.
    pub fn of(system: &System<'a>, x: &[f64], work: &'a SwingWork, number: usize) -> Option<Self> {
        let session = system.session;
        let evidence = work.evidence.as_ref()?;
        let (rates, modes) = (evidence.rates(), &evidence.found.modes);
        let strength = |m: &usize| shape(&modes[*m], &rates).map_or(0.0, |s| energy(&s));
        let main = (0..modes.len()).max_by(|a, b| strength(a).total_cmp(&strength(b)))?;
        let (mode, name) = (&modes[main], evidence.named.get(main)?.name);
        let turning = Turning::of(evidence, mode.period_s())?;
        let from_s = turning.start_s - evidence.found.t_ref_s;
        // Rate and angle at the start of the part that is used: pole and amplitude of the spectrum
        // led on to there.
        let pole = Complex64::new(-mode.alpha_per_s, mode.omega_rad_s);
        let seen = shape(mode, &rates)?;
        let axis = direction(&seen);
        let rate = (0..3).map(|k| seen[k] * axis[k]).sum::<Complex64>() * (pole * from_s).exp();
        let angle = rate / pole;
        let scales = Scales {
            omega_rad_s: mode.omega_rad_s,
            reach_rad: angle.norm(),
        };
        if scales.reach_rad <= 0.0 {
            return None;
        }
        let lines = lines(evidence, (rates, axis), main, from_s);
        let mut start = vec![angle.re, rate.re, 0.0, mode.alpha_per_s.max(0.0), 0.0];
        for line in &lines {
            start.extend([
                0.0,
                line.alpha_per_s,
                line.amplitudes[0],
                line.amplitudes[1],
            ]);
        }
        let suspension = &session.swings[number].suspension;
        let is_compound = suspension.kind == SuspensionKind::Compound;
        Some(Self {
            id: &session.swings[number].id,
            number,
            mode: if is_compound {
                ModeName::Compound
            } else {
                name
            },
            suspension,
            rates_rad_s: turning.stream.values.iter().map(|v| v.dot(&axis)).collect(),
            noise_rad_s: turning.stream.noise_along(&axis),
            stream: turning.stream,
            duration_s: turning.duration_s,
            law: law(system, x, number, name),
            scales,
            catalogue: catalogue(&scales),
            axis,
            lines,
            start,
        })
    }

    /// Mean, standard deviation of the prior and step of the derivative of each parameter.
    pub fn priors(&self, causes: &[&Cause]) -> Vec<(f64, f64)> {
        let (omega, rate) = (self.scales.omega_rad_s, self.scales.rate_rad_s());
        let mut priors = vec![
            (self.start[START_RAD], self.scales.reach_rad),
            (self.start[START_RAD_S], rate),
            (0.0, FREQUENCY_U),
            (0.0, DAMPING_U * omega),
        ];
        priors.push((0.0, rate));
        for line in &self.lines {
            priors.extend([
                (0.0, LINE_U),
                (line.alpha_per_s, DAMPING_U * line.omega_rad_s),
            ]);
            priors.extend([(0.0, rate); 2]);
        }
        priors.extend(
            causes
                .iter()
                .flat_map(|cause| cause.parameters.iter().map(|p| p.prior)),
        );
        priors
    }

    /// Places of the logarithms of the lines' frequencies, and how far each may be from that of the
    /// spectrum.
    pub fn line_limits(&self) -> impl Iterator<Item = (usize, f64)> {
        (0..self.lines.len()).map(|l| (OWN + LINE * l, LINE_STAYS))
    }

    /// Places of what cannot be below zero: damping of the swing and of the lines, strengths.
    pub fn one_sided(&self, causes: &[&Cause]) -> Vec<usize> {
        let mut place = self.first_cause();
        let mut places = vec![DAMPING];
        places.extend((0..self.lines.len()).map(|l| OWN + LINE * l + 1));
        for cause in causes {
            for CauseParameter { is_strength, .. } in &cause.parameters {
                if cause.one_sided && *is_strength {
                    places.push(place);
                }
                place += 1;
            }
        }
        places
    }

    /// Where the causes' parameters begin.
    pub fn first_cause(&self) -> usize {
        OWN + LINE * self.lines.len()
    }

    fn of_causes<'c>(&self, point: &'c [f64], causes: &[&'c Cause]) -> Vec<(&'c Cause, &'c [f64])> {
        let mut rest = &point[self.first_cause()..];
        let mut split = |cause: &&'c Cause| {
            let (own, others) = rest.split_at(cause.parameters.len());
            rest = others;
            (*cause, own)
        };
        causes.iter().map(&mut split).collect()
    }

    /// Angular frequency of small swings, rad/s.
    pub fn omega_rad_s(&self, point: &[f64]) -> f64 {
        self.scales.omega_rad_s * point[FREQUENCY].exp()
    }

    /// Rates of the motion at the times of the samples, rad/s.
    fn motion(&self, point: &[f64], causes: &[&Cause]) -> Option<Vec<f64>> {
        let equation = Equation {
            law: self.law,
            omega_rad_s: self.omega_rad_s(point),
            alpha_per_s: point[DAMPING],
            causes: self.of_causes(point, causes),
            scales: self.scales,
        };
        let start = Now::start(point[START_RAD], point[START_RAD_S]);
        let motion = follow(&equation, start, self.scales.omega_rad_s, &self.stream.t_s)?;
        Some(motion.into_iter().map(|[_, rate]| rate).collect())
    }

    /// Readings of the gyroscope along the axis, rad/s; `None` where no motion can be computed.
    pub fn readings(&self, point: &[f64], causes: &[&Cause]) -> Option<Vec<f64>> {
        Some(self.read(point, causes, &self.motion(point, causes)?))
    }

    fn read(&self, point: &[f64], causes: &[&Cause], rates_rad_s: &[f64]) -> Vec<f64> {
        let (mut scale, mut drift) = (1.0, 0.0);
        for (cause, q) in self.of_causes(point, causes) {
            scale += cause.scale_error(q);
            drift += cause.drift_rad_s(q) / self.duration_s;
        }
        let times = self.stream.t_s.iter().zip(rates_rad_s);
        times
            .map(|(t, rate)| scale * rate + point[BIAS] + drift * t + self.beside(point, *t))
            .collect()
    }

    /// What the weak lines add at a time.
    fn beside(&self, point: &[f64], t_s: f64) -> f64 {
        let parts = self.lines.iter().zip(point[OWN..].chunks_exact(LINE));
        parts.fold(0.0, |sum, (line, own)| {
            let (sin, cos) = (line.omega_rad_s * own[0].exp() * t_s).sin_cos();
            sum + (own[2] * cos + own[3] * sin) * (-own[1] * t_s).exp()
        })
    }

    /// Poles of the weak lines at a point.
    pub fn poles(&self, point: &[f64]) -> Vec<Pole> {
        let parts = self.lines.iter().zip(point[OWN..].chunks_exact(LINE));
        parts
            .map(|(line, own)| Pole {
                omega_rad_s: line.omega_rad_s * own[0].exp(),
                alpha_per_s: own[1],
            })
            .collect()
    }

    /// Linear damping where a fit begins, 1/s.
    pub fn start_damping_per_s(&self) -> f64 {
        self.start[DAMPING]
    }

    /// A point released so many times as wide.
    pub fn wider(&self, point: &[f64], times: f64) -> Vec<f64> {
        let mut wider = point.to_vec();
        wider[START_RAD] *= times;
        wider[START_RAD_S] *= times;
        wider
    }

    /// Times of the blocks that count in a part, s.
    pub fn times_s(&self, part: Part) -> Vec<f64> {
        self.blocks(part)
            .map(|block| self.stream.t_s[block.start])
            .collect()
    }

    /// Blocks of samples that count in a part.
    fn blocks(&self, part: Part) -> impl Iterator<Item = &std::ops::Range<usize>> {
        self.stream
            .blocks
            .iter()
            .filter(move |b| part.has(self.stream.t_s[b.start], self.duration_s))
    }

    /// Means of blocks of a figure at the samples, over their noise.
    fn over_noise(&self, part: Part, at: impl Fn(usize) -> f64) -> DVector<f64> {
        let mean = |block: &std::ops::Range<usize>| {
            let count = block.len() as f64;
            block.clone().map(&at).sum::<f64>() / (count.sqrt() * self.noise_rad_s)
        };
        DVector::from_vec(self.blocks(part).map(mean).collect())
    }

    /// Residuals at a point: measured less simulated over the noise, block by block.
    pub fn residual(&self, point: &[f64], causes: &[&Cause], part: Part) -> Option<DVector<f64>> {
        let readings = self.readings(point, causes)?;
        let rows = self.over_noise(part, |i| self.rates_rad_s[i] - readings[i]);
        rows.iter().all(|r| r.is_finite()).then_some(rows)
    }

    /// Derivatives of the simulated rows by every parameter.
    pub fn jacobian(&self, point: &[f64], causes: &[&Cause], part: Part) -> Option<DMatrix<f64>> {
        let rates_rad_s = self.motion(point, causes)?;
        let leaves_the_motion = |k: usize| (BIAS..self.first_cause()).contains(&k);
        let rows = |at: &[f64], k: usize| {
            let readings = if leaves_the_motion(k) {
                self.read(at, causes, &rates_rad_s)
            } else {
                self.readings(at, causes)?
            };
            Some(self.over_noise(part, |i| readings[i]))
        };
        let mut columns = Vec::with_capacity(point.len());
        for (k, (_, u)) in self.priors(causes).iter().enumerate() {
            let step = STEP * u;
            let moved = |by: f64| {
                let mut moved = point.to_vec();
                moved[k] += by;
                rows(&moved, k)
            };
            columns.push((moved(step)? - moved(-step)?) / (2.0 * step));
        }
        Some(DMatrix::from_columns(&columns))
    }
}

/// What moves the body.
struct Equation<'a> {
    law: Law,
    /// Angular frequency of small swings, rad/s, and linear damping α, 1/s.
    omega_rad_s: f64,
    alpha_per_s: f64,
    /// Causes with their values.
    causes: Vec<(&'a Cause, &'a [f64])>,
    scales: Scales,
}

impl Torque<f64> for Equation<'_> {
    fn acceleration(&self, now: &Now) -> f64 {
        let (mut torque, mut inertia) =
            self.law.at(self.omega_rad_s, now.angle_rad, now.rate_rad_s);
        torque -= 2.0 * self.alpha_per_s * now.rate_rad_s;
        for (cause, q) in &self.causes {
            torque += cause.torque(q, &self.scales, now);
            inertia += cause.added_inertia(q, &self.scales, now);
        }
        torque / inertia
    }

    /// Dahl's law along a way in one sense: the bearing gives as 1 − exp(−way/θ_s) of what is left.
    fn given(&self, now: &Now, angle_rad: f64) -> f64 {
        let give_rad = self.causes.iter().find_map(|(cause, q)| cause.give_rad(q));
        give_rad.map_or(0.0, |give_rad| {
            let way = (now.sense * (angle_rad - now.angle_rad)).max(0.0);
            now.sense + (now.given - now.sense) * (-way / give_rad).exp()
        })
    }
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

/// The strongest lines beside the swing that are no part of it, led on to the start of the part
/// that is used.
fn lines(
    evidence: &Evidence,
    (rates, axis): (Range<usize>, Vec3),
    main: usize,
    from_s: f64,
) -> Vec<Line> {
    let modes = &evidence.found.modes;
    let main_rad_s = modes[main].omega_rad_s;
    let is_own = |omega: f64| {
        let ratio = omega / main_rad_s;
        (ratio - 1.0).abs() < OWN_LINE || (ratio / ratio.round().max(1.0) - 1.0).abs() < OVERTONE
    };
    let along = |mode: &FittedMode| -> Option<Complex64> {
        let seen = shape(mode, &rates)?;
        Some((0..3).map(|k| seen[k] * axis[k]).sum())
    };
    let mut others: Vec<(&FittedMode, Complex64)> = modes
        .iter()
        .filter(|mode| !is_own(mode.omega_rad_s) && mode.snr_db > LEAST_LINE_DB)
        .filter_map(|mode| Some((mode, along(mode)?)))
        .collect();
    others.sort_by(|a, b| b.1.norm().total_cmp(&a.1.norm()));
    let line = |(mode, amplitude): (&FittedMode, Complex64)| {
        let turned =
            amplitude * (Complex64::new(-mode.alpha_per_s, mode.omega_rad_s) * from_s).exp();
        Line {
            omega_rad_s: mode.omega_rad_s,
            alpha_per_s: mode.alpha_per_s.max(0.0),
            amplitudes: [turned.re, -turned.im],
        }
    };
    others.into_iter().take(MOST_LINES).map(line).collect()
}
