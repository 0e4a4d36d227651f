//! The unknowns and the stated inputs of the joint estimate.
//!
//! One body, one set of tape readings: swings that state the same figure for the same dimension
//! share one parameter, so that the correlation between them is kept.
//!
//! # Conventions
//! Body parameters describe everything that hangs (attachments included, a swing's added masses
//! excluded), about its own centre of mass, hull axes. Gyradii enter as logarithms (that about x
//! relative to that about z), the product of inertia as I_xz / M in m² with I_xz = −∫ x z dm (the
//! tensor's own off-diagonal element).

use gyradius_base::constants::{
    PHONE_CLOCK_BETWEEN_SWINGS_U_RELATIVE, PHONE_CLOCK_U_RELATIVE, STANDARD_GRAVITY_M_S2,
};
use gyradius_base::error::Result;
use gyradius_base::message::Message;
use gyradius_recording::{Quantity, Session, SwingData};

use super::names::{Input, InputKind};
use super::routes::corrections::{
    NORMAL_GRAVITY_U_M_S2, buoyant_gravity_m_s2, normal_gravity_m_s2,
};
use super::routes::yaw::{Lines, yaw_gyradius_m};
use super::sentences::message;

/// Uncertainty of the level of a hull whose pitch nobody stated, degrees: what a spirit level and
/// an eye give.
const UNSTATED_PITCH_U_DEG: f64 = 0.2;
/// Swings whose stated pitch differs by less than this hang from the same points, degrees.
const SAME_HANGING_DEG: f64 = 1.0;
/// Weak prior of the logarithm of an unknown length (a factor of 7 either way): keeps the system
/// solvable, and what it decides is not reported.
const WEAK_LOG_U: f64 = 2.0;

/// Weak prior of I_xz / (M k²): principal axes within some 10° of the hull's, as hulls have them (ψ
/// of the paper's model is 5.6°, of its keelboat 1°).
const WEAK_PRODUCT: f64 = 0.12;

/// Roll over yaw gyradius of a hull before it is measured (the paper's: 0.66 and 0.59) and how far
/// hulls scatter about it, as a logarithm.
const ROLL_SHARE: f64 = 0.52;
const ROLL_SHARE_LOG_U: f64 = 0.3;

/// Pitch of a hanging that counts as level, degrees.
pub const LEVEL_DEG: f64 = 2.0;
/// Step of numerical derivatives by a clock's error.
const CLOCK_STEP: f64 = 1e-6;

/// What a parameter is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// A figure somebody stated, with its uncertainty.
    Stated,
    /// An unknown of the body.
    Unknown,
}

/// One parameter.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// Name for budgets and consistency tests.
    pub name: Input,
    /// Stated or unknown.
    pub role: Role,
    /// Prior value and its uncertainty; u = 0 holds it fixed.
    pub prior: Quantity,
    /// Step for numerical derivatives, its own unit.
    pub step: f64,
}

/// Indices of one swing's parameters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct SwingIndex {
    /// Length of the lines.
    pub line_length: Option<usize>,
    /// Spacing at the hull.
    pub spacing: Option<usize>,
    /// Spacing at the top (the same parameter where it was not stated).
    pub top_spacing: Option<usize>,
    /// Bow-up angle, degrees.
    pub pitch_deg: usize,
    /// Logarithm of the depth of the centre of mass in this hanging.
    pub log_depth: usize,
    /// Height of a compound pendulum's axis.
    pub axis_height: Option<usize>,
    /// Relative error of the phone's clock in this swing beyond that in all; none where no phone
    /// told the time.
    pub clock: Option<usize>,
}

/// All parameters and where to find them.
#[derive(Debug, Clone, PartialEq)]
pub struct Layout {
    /// The parameters.
    pub parameters: Vec<Parameter>,
    /// Gravity with buoyancy taken off, m/s².
    pub gravity: usize,
    /// Relative error of the phones' clocks, what all swings share of it.
    pub clock: usize,
    /// Total mass, kg.
    pub mass: usize,
    /// Logarithms of: the roll gyradius over the yaw gyradius, the pitch gyradius, the yaw
    /// gyradius.
    pub log_gyradii: [usize; 3],
    /// I_xz / M, m².
    pub product_xz: usize,
    /// Masses of the attachments.
    pub attachment_masses: Vec<usize>,
    /// Their positions, hull axes, from the mid-point of the suspension points, m.
    pub attachment_positions_m: Vec<[f64; 3]>,
    /// By swing.
    pub swings: Vec<SwingIndex>,
}

impl Layout {
    /// Lays out the parameters of a session. `gravity` is the effective one, buoyancy included;
    /// `pitch_deg` holds what the phones' own tilts say of each swing's pitch, where they say
    /// anything, `yaw_periods_s` the observed yaw period of each swing, where there is one.
    pub fn of(
        session: &Session,
        gravity: Quantity,
        pitch_deg: &[Option<Quantity>],
        yaw_periods_s: &[Option<f64>],
    ) -> Self {
        let mut builder = Builder::default();
        let gravity = builder.stated(InputKind::Gravity, gravity);
        let clock = Quantity::new(0.0, PHONE_CLOCK_U_RELATIVE);
        let clock = builder.stated_with_step(InputKind::PhoneClock, clock, CLOCK_STEP);
        let mass = builder.stated(
            InputKind::Mass,
            session.body.mass_kg.unwrap_or(Quantity::exact(1.0)),
        );
        let scale_m = length_scale_m(session, builder.value(gravity), yaw_periods_s);
        let log_roll_share =
            builder.unknown(InputKind::Gyradius, ROLL_SHARE.ln(), ROLL_SHARE_LOG_U, 1e-6);
        let [pitch, yaw] =
            [0, 1].map(|_| builder.unknown(InputKind::Gyradius, scale_m.ln(), WEAK_LOG_U, 1e-6));
        let log_gyradii = [log_roll_share, pitch, yaw];
        let product_xz = builder.unknown(
            InputKind::ProductXz,
            0.0,
            WEAK_PRODUCT * scale_m * scale_m,
            1e-6 * scale_m * scale_m,
        );
        let attachment_masses = session
            .attachments
            .iter()
            .map(|a| builder.stated(Input::of(InputKind::Mass, &a.name), a.mass_kg))
            .collect();
        let swings = (0..session.swings.len())
            .map(|i| builder.swing(session, i, pitch_deg.get(i).copied().flatten(), scale_m))
            .collect();
        Layout {
            parameters: builder.parameters,
            gravity,
            clock,
            mass,
            log_gyradii,
            product_xz,
            attachment_masses,
            attachment_positions_m: session.attachments.iter().map(|a| a.position_m).collect(),
            swings,
        }
    }

    /// Logarithm of the depth in a level hanging, where there is one.
    pub fn level_depth(&self) -> Option<usize> {
        let level = |s: &&SwingIndex| self.parameters[s.pitch_deg].prior.value.abs() < LEVEL_DEG;
        self.swings.iter().find(level).map(|s| s.log_depth)
    }

    /// Relative error of the clock that a swing was timed with.
    pub fn clock_error(&self, x: &[f64], swing: &SwingIndex) -> f64 {
        swing.clock.map_or(0.0, |own| x[self.clock] + x[own])
    }

    /// Prior values, the point from which the solution starts.
    pub fn start(&self) -> Vec<f64> {
        self.parameters.iter().map(|p| p.prior.value).collect()
    }
}

#[derive(Default)]
struct Builder {
    parameters: Vec<Parameter>,
    hangings: Vec<(f64, usize)>,
}

impl Builder {
    fn push(&mut self, name: Input, role: Role, prior: Quantity, step: f64) -> usize {
        self.parameters.push(Parameter {
            name,
            role,
            prior,
            step,
        });
        self.parameters.len() - 1
    }

    fn value(&self, index: usize) -> f64 {
        self.parameters[index].prior.value
    }

    fn unknown(&mut self, name: impl Into<Input>, value: f64, u: f64, step: f64) -> usize {
        self.push(name.into(), Role::Unknown, Quantity::new(value, u), step)
    }

    fn stated(&mut self, name: impl Into<Input>, prior: Quantity) -> usize {
        self.stated_with_step(name, prior, 1e-6 * prior.value.abs().max(1e-3))
    }

    /// The same figure stated for the same thing is the same parameter.
    fn stated_with_step(&mut self, name: impl Into<Input>, prior: Quantity, step: f64) -> usize {
        let name = name.into();
        let known = self
            .parameters
            .iter()
            .position(|p| p.name == name && p.prior == prior);
        known.unwrap_or_else(|| self.push(name, Role::Stated, prior, step))
    }

    fn swing(
        &mut self,
        session: &Session,
        i: usize,
        phone_pitch: Option<Quantity>,
        scale_m: f64,
    ) -> SwingIndex {
        let swing = &session.swings[i];
        let hung = &swing.suspension;
        let spacing = hung.spacing_m.map(|q| self.stated(InputKind::Spacing, q));
        let pitch = phone_pitch
            .or(hung.hull_pitch_deg)
            .unwrap_or(Quantity::new(0.0, UNSTATED_PITCH_U_DEG));
        SwingIndex {
            line_length: hung
                .line_length_m
                .map(|q| self.stated(InputKind::LineLength, q)),
            spacing,
            top_spacing: hung
                .top_spacing_m
                .map(|q| self.stated(InputKind::TopSpacing, q))
                .or(spacing),
            pitch_deg: self.stated_with_step(InputKind::HullPitch, pitch, 1e-3),
            log_depth: self.depth(
                hung.hull_pitch_deg.map_or(pitch.value, |q| q.value),
                scale_m,
            ),
            axis_height: hung
                .axis_height_m
                .map(|q| self.stated(InputKind::AxisHeight, q)),
            clock: matches!(swing.data, SwingData::Recording(_)).then(|| self.clock_of_swing()),
        }
    }

    fn clock_of_swing(&mut self) -> usize {
        let u = PHONE_CLOCK_BETWEEN_SWINGS_U_RELATIVE;
        self.push(
            InputKind::PhoneClock.into(),
            Role::Stated,
            Quantity::new(0.0, u),
            CLOCK_STEP,
        )
    }

    fn depth(&mut self, pitch_deg: f64, scale_m: f64) -> usize {
        let known = self
            .hangings
            .iter()
            .find(|(p, _)| (p - pitch_deg).abs() < SAME_HANGING_DEG)
            .map(|h| h.1);
        known.unwrap_or_else(|| {
            let index = self.unknown(InputKind::Depth, (0.4 * scale_m).ln(), WEAK_LOG_U, 1e-6);
            self.hangings.push((pitch_deg, index));
            index
        })
    }
}

/// A first guess of the body's gyradius, m: from a yaw period by (6), else the spacing, else the
/// axis height.
fn length_scale_m(session: &Session, gravity_m_s2: f64, yaw_periods_s: &[Option<f64>]) -> f64 {
    let by_yaw = session
        .swings
        .iter()
        .zip(yaw_periods_s)
        .find_map(|(swing, period_s)| {
            let hung = &swing.suspension;
            let lines = Lines::parallel(hung.line_length_m?.value, 0.5 * hung.spacing_m?.value);
            yaw_gyradius_m((*period_s)?, &lines, gravity_m_s2).ok()
        });
    let half_spacing = session
        .swings
        .iter()
        .find_map(|s| s.suspension.spacing_m.map(|q| 0.5 * q.value));
    let height = session
        .swings
        .iter()
        .find_map(|s| s.suspension.axis_height_m.map(|q| q.value));
    by_yaw.or(half_spacing).or(height).unwrap_or(1.0)
}

/// Gravity as stated, or computed from the latitude, or standard with what that leaves open on
/// Earth; times the buoyancy factor (1 − ρ_air/ρ) where a density is stated.
pub fn effective_gravity(session: &Session) -> Result<(Quantity, Option<Message>)> {
    let site = &session.site;
    let (free_fall, warning) = match (site.gravity_m_s2, site.latitude_deg) {
        (Some(g), _) => (g, None),
        (None, Some(latitude)) => {
            let normal = normal_gravity_m_s2(latitude, site.altitude_m.unwrap_or(0.0))?;
            (Quantity::new(normal, NORMAL_GRAVITY_U_M_S2), None)
        }
        // Sea-level gravity runs from 9.780 at the equator to 9.832 at the poles: rectangular, u =
        // 0.026/√3.
        (None, None) => (
            Quantity::new(STANDARD_GRAVITY_M_S2, 0.015),
            Some(message("no_gravity", [])),
        ),
    };
    let Some(density) = session.body.density_kg_m3 else {
        return Ok((free_fall, warning));
    };
    let air = site.air_density_kg_m3.unwrap_or(DEFAULT_AIR_DENSITY_KG_M3);
    let value = buoyant_gravity_m_s2(free_fall.value, air, density)?;
    Ok((
        Quantity::new(value, free_fall.u * value / free_fall.value),
        warning,
    ))
}

/// Dry air at 15 °C and 1013.25 hPa (ISO 2533 standard atmosphere), kg/m³.
const DEFAULT_AIR_DENSITY_KG_M3: f64 = 1.225;
