//! What a measurement would find, before anything has swung: the joint estimate with expected rows
//! in the place of data.
//!
//! Parameters, theory, solution, quantities and budget are those of a measurement; only the rows
//! differ. They are what the samples of a swing would say of the parameters
//! (`samples::expected_statements`), or, quicker and for a stopwatch, its periods with their
//! uncertainties.

use std::collections::BTreeMap;

use gyradius_base::error::{Error, Result};
use gyradius_base::frames::Rotation;
use gyradius_mechanics::RigidBody;
use gyradius_recording::{ModeName, Quantity, Session};

use super::estimate::{Observation, Observed, System};
use super::measure::PHONE_TILT_U_DEG;
use super::measurement::{BudgetLine, Measurement, QuantityResult};
use super::names::{Input, QuantityName};
use super::outputs::write_quantities;
use super::parameters::{Layout, effective_gravity};
use super::samples::{Own, Recorded, Statement, SwingSetup, expected_statements, place};
use super::theory::{swing_periods, upright};

/// Numbers of a start: along the suspension, across it, turn about it, yaw.
const START: usize = place::YAW + 1;

/// Of a period that the samples show: no figure, they say what they say of it; it is known to be
/// there.
const SHOWN_U_RELATIVE: f64 = 1e-4;

/// What a swing to come would bring.
#[derive(Debug, Clone, PartialEq)]
pub enum Brought {
    /// Samples of a phone.
    Samples(Released, Recorded),
    /// Periods of these modes, each with its relative standard uncertainty.
    Periods(Vec<(ModeName, f64)>),
}

/// How a swing begins, from rest, and how it dies away.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Released {
    /// Shift along the suspension's direction and across it (direction × up), m; turn about that
    /// direction and about the vertical, rad.
    pub start: [f64; START],
    /// Decay time of the amplitude of all motions, s.
    pub decay_s: f64,
}

/// What is expected.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Expected {
    /// As a measurement has them.
    pub quantities: BTreeMap<QuantityName, QuantityResult>,
    /// Contributions of each input, largest first, with the names that a measurement gives them.
    pub budget: BTreeMap<QuantityName, Vec<BudgetLine>>,
}

/// A session that was planned and the hull that it is expected to find: inertia about the centre of
/// mass in hull axes, that centre below the mid-point of the suspension points of a level hanging,
/// everything included that hangs.
pub struct Prospect<'a> {
    session: &'a Session,
    layout: Layout,
    x: Vec<f64>,
    /// Small-amplitude periods of every mode, by swing, s.
    pub periods_s: Vec<Vec<(ModeName, f64)>>,
}

impl<'a> Prospect<'a> {
    /// Lays out the parameters, the body's in place.
    ///
    /// # Errors
    /// Where a swing's suspension lacks a dimension, or the body cannot hang so.
    pub fn new(session: &'a Session, body: &RigidBody) -> Result<Self> {
        let (gravity, _) = effective_gravity(session)?;
        let yaws = vec![None; session.swings.len()];
        let layout = Layout::of(session, gravity, &phone_pitches(session), &yaws, &[]);
        let x = placed(&layout, body)?;
        let each = session.swings.iter().zip(&layout.swings);
        let periods_s = each
            .map(|(swing, index)| swing_periods(&layout, &x, swing, index))
            .collect::<Result<_>>()?;
        Ok(Self {
            session,
            layout,
            x,
            periods_s,
        })
    }

    /// What the joint estimate would make of what the swings bring beside the inclines as stated.
    ///
    /// # Errors
    /// Where the swings cannot be simulated or admit no solution.
    pub fn expected(&self, brought: &[Brought]) -> Result<Expected> {
        let mut system = System::new(self.session, self.layout.clone());
        let mut periods = Vec::new();
        let mut shown = Vec::new();
        let mut said: Vec<Vec<Statement>> = Vec::new();
        for (i, brought) in brought.iter().enumerate() {
            match brought {
                Brought::Samples(released, recorded) => {
                    shown.extend(self.shown(i, released));
                    said.push(self.said(i, released, recorded)?)
                }
                Brought::Periods(modes) => {
                    periods.extend(
                        modes
                            .iter()
                            .filter_map(|(mode, u)| self.period(i, *mode, *u)),
                    );
                    said.push(vec![]);
                }
            }
        }
        system.state(&periods, &said, &[]);
        system.periods = [periods, shown].concat();
        let solution = system.solve(&self.x)?;
        let mut found = Measurement::default();
        write_quantities(&system, &solution, &mut found);
        let Measurement {
            quantities, budget, ..
        } = found;
        Ok(Expected { quantities, budget })
    }

    fn said(&self, i: usize, released: &Released, recorded: &Recorded) -> Result<Vec<Statement>> {
        let setup = SwingSetup {
            layout: &self.layout,
            swing: &self.session.swings[i],
            index: &self.layout.swings[i],
        };
        let mut own = Own::at_rest(Rotation::identity());
        own.values[..START].copy_from_slice(&released.start);
        // A force of rate · mass · speed takes half the rate off the amplitude.
        own.values[place::DAMPING].fill(2.0 / released.decay_s);
        expected_statements(&setup, &self.x, &own, recorded)
    }

    /// The periods that the samples of a swing show: of what it is released in.
    fn shown(&self, i: usize, released: &Released) -> Vec<Observation> {
        let [along, across, turn, yaw] = released.start.map(|size| size != 0.0);
        let is_released = |mode: ModeName| match mode {
            ModeName::Yaw => yaw,
            ModeName::Sway => along,
            _ => across || turn,
        };
        let modes = self.periods_s[i].iter().map(|(mode, _)| *mode);
        modes
            .filter(|mode| is_released(*mode))
            .filter_map(|mode| self.period(i, mode, SHOWN_U_RELATIVE))
            .collect()
    }

    fn period(&self, i: usize, mode: ModeName, u_relative: f64) -> Option<Observation> {
        let (_, period_s) = self.periods_s[i].iter().find(|(name, _)| *name == mode)?;
        Some(Observation {
            what: Observed::Period(i, mode),
            value: Quantity::new(*period_s, period_s * u_relative),
            u_amplitude: 0.0,
            label: Input::period(mode, &self.session.swings[i].id),
        })
    }
}

/// The stated pitches as the phones will have them: each tilted hanging against the one nearest to
/// level.
fn phone_pitches(session: &Session) -> Vec<Option<Quantity>> {
    let hung = |i: usize| &session.swings[i].suspension;
    let stated = |i: usize| {
        hung(i)
            .hull_pitch_deg
            .filter(|_| hung(i).hull_roll_deg.is_none())
    };
    let size = |i: &usize| stated(*i).map_or(0.0, |q| q.value.abs());
    let upright = (0..session.swings.len()).filter(|i| hung(*i).hull_roll_deg.is_none());
    let reference = upright.min_by(|a, b| size(a).total_cmp(&size(b)));
    let base = reference.and_then(stated).unwrap_or_default();
    let tilted = |i: usize| {
        let pitch = stated(i).filter(|q| (q.value - base.value).abs() > 0.5)?;
        (Some(i) != reference).then(|| Quantity::new(pitch.value, base.u.hypot(PHONE_TILT_U_DEG)))
    };
    (0..session.swings.len()).map(tilted).collect()
}

/// The parameters' prior values with the body's in place.
fn placed(layout: &Layout, body: &RigidBody) -> Result<Vec<f64>> {
    let k = |i: usize| (body.inertia_kg_m2[(i, i)] / body.mass_kg).sqrt();
    let (roll, pitch, yaw, depth) = (k(0), k(1), k(2), -body.cm_m.z);
    if ![roll, pitch, yaw, depth]
        .iter()
        .all(|v| v.is_finite() && *v > 0.0)
    {
        return Err(Error::argument(
            "hull",
            "gyradii and a depth above 0",
            format!("{roll}, {pitch}, {yaw}, {depth} m"),
        ));
    }
    let mut x = layout.start();
    let [log_roll, log_pitch, log_yaw] = layout.log_gyradii;
    (x[log_roll], x[log_pitch], x[log_yaw]) = ((roll / yaw).ln(), pitch.ln(), yaw.ln());
    x[layout.product_xz] = body.inertia_kg_m2[(0, 2)] / body.mass_kg;
    for swing in &layout.swings {
        // Moved along the deck until the centre hangs below them, the points lie 1/cos of the tilt
        // higher above it.
        x[swing.log_depth] = (depth / upright(&x, swing)).ln();
    }
    Ok(x)
}
