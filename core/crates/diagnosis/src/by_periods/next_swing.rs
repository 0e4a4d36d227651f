//! The swing that would tell causes apart.
//!
//! Every model predicts the periods of a swing that was not made, each with the uncertainty that
//! its parameters and a fresh tape leave. Wanted is the swing in which the models differ most.

use nalgebra::{DMatrix, DVector};

use super::causes::Amplitudes;
use super::model::{Fitted, Setting};
use crate::cause_id::CauseId;
use crate::result::NextSwing;
use crate::words;
use gyradius_base::message::Argument;
use gyradius_identification::InputKind;
use gyradius_identification::parameters::{LEVEL_DEG, Layout, Parameter, Role, SwingIndex};
use gyradius_recording::{
    Excitation, ModeName, Orientation, Quantity, Suspension, SuspensionKind, Swing, SwingData,
};

/// Lengths and spacings that are tried, in those of the session.
const LENGTHS: [f64; 5] = [0.5, 0.7, 1.0, 1.4, 2.0];
const SPACINGS: [f64; 5] = [0.5, 0.75, 1.0, 1.25, 1.5];
/// Lengths and spacings are proposed in steps of this, m.
const STEP_M: f64 = 0.01;
/// A period of a swing of two minutes is good to this, relative: a phone's clock.
const PERIOD_U: f64 = 20e-6;
/// A tape without uncertainty is taken as good to this, m.
const TAPE_U_M: f64 = 5e-4;
const AMPLITUDE_DEG: f64 = 5.0;
/// Where air that grows with the amplitude is in doubt, the swing is wide.
const WIDE_DEG: f64 = 12.0;
const DURATION_S: f64 = 120.0;
/// Models that differ by so many standard deviations are told apart.
const TOLD_APART: f64 = 3.0;

/// A swing that was not made.
struct Plan {
    line_length_m: Quantity,
    spacing_m: Quantity,
    amplitude_deg: f64,
    modes: &'static [ModeName],
}

const YAW: &[ModeName] = &[ModeName::Yaw];
const SWAY: &[ModeName] = &[ModeName::Sway];
const BOTH: &[ModeName] = &[ModeName::Yaw, ModeName::Sway];
const PITCH: &[ModeName] = &[ModeName::PitchInPhase, ModeName::PitchOutOfPhase];
const ALL: &[ModeName] = &[
    ModeName::Yaw,
    ModeName::Sway,
    ModeName::PitchInPhase,
    ModeName::PitchOutOfPhase,
];
/// The simplest first: it is kept where others do no better.
const EXCITED: [&[ModeName]; 5] = [YAW, SWAY, BOTH, PITCH, ALL];
/// By how much a swing with more modes must be better.
const BETTER: f64 = 1.1;

/// The swing that tells the model from its rivals best; `None` without rivals, and where no swing
/// tells any of them.
pub fn next_swing(setting: &Setting, best: &Fitted, rivals: &[Fitted]) -> Option<NextSwing> {
    let amplitude_deg = if in_doubt(best, rivals, CauseId::AmplitudeAddedMass) {
        WIDE_DEG
    } else {
        AMPLITUDE_DEG
    };
    let mut found: Option<(Worth, Plan)> = None;
    for modes in EXCITED {
        for plan in plans(setting, modes, amplitude_deg) {
            let Some(worth) = Worth::of(setting, best, rivals, &plan) else {
                continue;
            };
            if found.as_ref().is_none_or(|(known, _)| worth.beats(known)) {
                found = Some((worth, plan));
            }
        }
    }
    let (worth, plan) = found.filter(|(worth, _)| worth.told > 0)?;
    Some(plan.described(
        &setting.system.session.swings[level_swing(setting)?],
        &worth,
        rivals,
        best,
    ))
}

fn in_doubt(best: &Fitted, rivals: &[Fitted], id: CauseId) -> bool {
    std::iter::once(best)
        .chain(rivals)
        .any(|f| f.causes.iter().any(|c| c.id == id))
}

fn plans(setting: &Setting, modes: &'static [ModeName], amplitude_deg: f64) -> Vec<Plan> {
    let (length, spacing) = (
        tape(setting, |s| s.line_length),
        tape(setting, |s| s.spacing),
    );
    let rounded = |x: f64| (x / STEP_M).round() * STEP_M;
    let at = |base: Quantity, factor: f64| Quantity::new(rounded(base.value * factor), base.u);
    let grid = LENGTHS
        .iter()
        .flat_map(|l| SPACINGS.iter().map(move |s| (*l, *s)));
    grid.map(|(l, s)| Plan {
        line_length_m: at(length, l),
        spacing_m: at(spacing, s),
        amplitude_deg,
        modes,
    })
    .collect()
}

/// Mean of a stated dimension and what the tape is good to.
fn tape(setting: &Setting, place: fn(&SwingIndex) -> Option<usize>) -> Quantity {
    let layout = &setting.system.layout;
    let stated: Vec<Quantity> = layout
        .swings
        .iter()
        .filter_map(place)
        .map(|i| layout.parameters[i].prior)
        .collect();
    let count = stated.len().max(1) as f64;
    let u = stated.iter().map(|q| q.u).fold(0.0, f64::max);
    let value = stated.iter().map(|q| q.value).sum::<f64>() / count;
    Quantity::new(value, if u > 0.0 { u } else { TAPE_U_M })
}

/// What a swing would tell.
struct Worth {
    /// By rival, standard deviations.
    sigma: Vec<f64>,
    /// Rivals told apart.
    told: usize,
    /// The least difference of those.
    least: f64,
}

impl Worth {
    fn of(setting: &Setting, best: &Fitted, rivals: &[Fitted], plan: &Plan) -> Option<Self> {
        let own = Prediction::of(setting, best, plan)?;
        let mut sigma = Vec::new();
        for rival in rivals {
            sigma.push(own.differs(&Prediction::of(setting, rival, plan)?)?);
        }
        let apart: Vec<f64> = sigma.iter().copied().filter(|s| *s > TOLD_APART).collect();
        let least = apart.iter().copied().fold(f64::INFINITY, f64::min);
        Some(Self {
            told: apart.len(),
            least,
            sigma,
        })
    }

    fn beats(&self, other: &Self) -> bool {
        self.told > other.told
            || (self.told == other.told && self.told > 0 && self.least > BETTER * other.least)
    }
}

/// The first swing that hung level on two lines.
fn level_swing(setting: &Setting) -> Option<usize> {
    let layout = &setting.system.layout;
    let is_level = |s: &SwingIndex| layout.parameters[s.pitch_deg].prior.value.abs() < LEVEL_DEG;
    layout
        .swings
        .iter()
        .position(|s| s.axis_height.is_none() && is_level(s))
}

/// Periods of a planned swing by a model.
struct Prediction {
    period_s: DVector<f64>,
    covariance: DMatrix<f64>,
    /// What the fresh tape adds.
    tape: DMatrix<f64>,
}

impl Prediction {
    fn of(setting: &Setting, fitted: &Fitted, plan: &Plan) -> Option<Self> {
        let level = level_swing(setting)?;
        let (layout, index) = plan.laid_out(setting, &fitted.system.layout, level);
        let swing = plan.swing(setting.system.session.swings[level].suspension.orientation);
        let mut x = fitted.solution.x.clone();
        // The causes' numbers stand last: the new dimensions go in before them.
        let first = x.len() - fitted.numbers().len();
        x.splice(
            first..first,
            [plan.line_length_m.value, plan.spacing_m.value],
        );
        let theory = setting.theory(&fitted.causes, first + 2, (&swing.id, plan.amplitudes()));
        let periods = |x: &[f64]| {
            let all = theory(&layout, x, &swing, &index).ok()?;
            let of = |mode: &ModeName| all.iter().find(|(name, _)| name == mode).map(|(_, t)| *t);
            plan.modes
                .iter()
                .map(of)
                .collect::<Option<Vec<f64>>>()
                .map(DVector::from_vec)
        };
        let slope = |i: usize| {
            let step = layout.parameters[i].step;
            let moved = |sign: f64| {
                let mut moved = x.clone();
                moved[i] += sign * step;
                periods(&moved)
            };
            Some((moved(1.0)? - moved(-1.0)?) / (2.0 * step))
        };
        let period_s = periods(&x)?;
        let mut by_row = DMatrix::zeros(plan.modes.len(), fitted.solution.gain.ncols());
        for (k, place) in fitted.solution.free.iter().enumerate() {
            let place = if *place < first { *place } else { place + 2 };
            by_row += slope(place)? * fitted.solution.gain.row(k);
        }
        let by_tape = [(first, plan.line_length_m.u), (first + 1, plan.spacing_m.u)];
        let mut tape = DMatrix::zeros(plan.modes.len(), plan.modes.len());
        for (place, u) in by_tape {
            let change = slope(place)? * u;
            tape += &change * change.transpose();
        }
        Some(Self {
            covariance: &by_row * by_row.transpose(),
            period_s,
            tape,
        })
    }

    /// How far two predictions differ, standard deviations.
    fn differs(&self, other: &Self) -> Option<f64> {
        let difference = &self.period_s - &other.period_s;
        let timing = DMatrix::from_diagonal(&self.period_s.map(|t| (PERIOD_U * t).powi(2)));
        let covariance = &self.covariance + &other.covariance + &self.tape + timing;
        Some(
            difference
                .dot(&covariance.cholesky()?.solve(&difference))
                .sqrt(),
        )
    }
}

impl Plan {
    fn swing(&self, orientation: Orientation) -> Swing {
        Swing {
            id: String::new(),
            data: SwingData::PeriodsS(Default::default()),
            excited: vec![],
            added_masses: vec![],
            amplitude_deg: Default::default(),
            suspension: Suspension {
                line_length_m: Some(self.line_length_m),
                spacing_m: Some(self.spacing_m),
                ..Suspension::unmeasured(SuspensionKind::Bifilar, orientation)
            },
        }
    }

    fn amplitudes(&self) -> Amplitudes {
        let angle = self.amplitude_deg.to_radians();
        Amplitudes {
            yaw_rad: angle,
            sway_rad: angle,
        }
    }

    /// The session's parameters and the two new dimensions, and where to find them for a hanging
    /// like that of `level`.
    fn laid_out(
        &self,
        setting: &Setting,
        with_causes: &Layout,
        level: usize,
    ) -> (Layout, SwingIndex) {
        let mut layout = with_causes.clone();
        let first = setting.system.layout.parameters.len();
        let index = SwingIndex {
            line_length: Some(first),
            spacing: Some(first + 1),
            top_spacing: Some(first + 1),
            clock: None,
            ..layout.swings[level]
        };
        let dimension = |kind: InputKind, prior: Quantity| Parameter {
            name: kind.into(),
            role: Role::Stated,
            prior,
            step: 1e-6 * prior.value,
        };
        let new = [
            dimension(InputKind::LineLength, self.line_length_m),
            dimension(InputKind::Spacing, self.spacing_m),
        ];
        layout.parameters.splice(first..first, new);
        (layout, index)
    }

    fn described(
        &self,
        like: &Swing,
        worth: &Worth,
        rivals: &[Fitted],
        best: &Fitted,
    ) -> NextSwing {
        let orientation = like.suspension.orientation;
        let mut excited: Vec<Excitation> = Vec::new();
        for mode in self.modes {
            let one = Excitation::of(*mode, orientation);
            if !excited.contains(&one) {
                excited.push(one);
            }
        }
        let own = |fitted: &Fitted| {
            let is_new = |id: &CauseId| best.causes.iter().all(|c| c.id != *id);
            words::names(fitted.causes.iter().map(|c| c.id).filter(is_new), "and")
        };
        let split = |is_told: bool| -> Vec<Argument> {
            let matching = worth
                .sigma
                .iter()
                .zip(rivals)
                .filter(|(s, _)| (**s > TOLD_APART) == is_told);
            let mut names: Vec<Argument> = matching.map(|(_, rival)| own(rival)).collect();
            names.dedup();
            names
        };
        let row = |all: Vec<Argument>| words::row(all, "row", "and");
        let open = split(false);
        let left =
            (!open.is_empty()).then(|| words::message("next_leaves", [("causes", row(open))]));
        let said = words::message(
            "next_periods",
            [
                ("line_length_m", words::number(self.line_length_m.value, 2)),
                ("spacing_m", words::number(self.spacing_m.value, 2)),
                (
                    "excited",
                    row(excited
                        .iter()
                        .map(|one| Argument::Word(one.name().into()))
                        .collect()),
                ),
                (
                    "causes",
                    words::names(best.causes.iter().map(|c| c.id), "and"),
                ),
                ("others", row(split(true))),
                (
                    "modes",
                    row(self.modes.iter().map(|mode| words::motion(*mode)).collect()),
                ),
                ("sigma", words::number(worth.least, 1)),
                ("left", words::part(left)),
            ],
        );
        NextSwing {
            like: like.id.clone(),
            line_length_m: self.line_length_m.value,
            spacing_m: self.spacing_m.value,
            excited,
            amplitude_deg: self.amplitude_deg,
            duration_s: DURATION_S,
            hull_pitch_deg: 0.0,
            sigma: worth.least,
            message: said,
        }
    }
}
