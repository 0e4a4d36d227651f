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
use gyradius_mechanics::Real;
use gyradius_recording::{
    Attachment, Incline, InclineAngle, ModeName, Quantity, Session, SuspensionKind, Swing,
    SwingData,
};

use super::estimate::Observed;
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
    /// A stated figure of what rides along: the hull alone depends on it, the motion hardly does.
    Riding,
}

/// What a stated figure's error acts on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Reading {
    /// A parameter (index).
    Parameter(usize),
    /// A row of the observations.
    Observed(Observed),
}

/// An error that an instrument shares among its readings.
#[derive(Debug, Clone, PartialEq)]
pub struct Shared {
    /// Name for budgets.
    pub name: Input,
    /// Change of each reading by one standard uncertainty of it, the reading's own unit.
    pub readings: Vec<(Reading, f64)>,
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

impl Parameter {
    /// Whether a swing's motion may move it.
    pub fn is_free_in_motion(&self) -> bool {
        self.prior.u > 0.0 && self.role != Role::Riding
    }
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
    /// Heel, starboard down, degrees, where it is stated.
    pub roll_deg: Option<usize>,
    /// Logarithm of the depth of the centre of mass in this hanging.
    pub log_depth: usize,
    /// Height of a compound pendulum's axis.
    pub axis_height: Option<usize>,
    /// Relative error of the phone's clock in this swing beyond that in all; none where no phone
    /// told the time.
    pub clock: Option<usize>,
    /// Its added masses (index into [`Layout::added_masses`]).
    pub added_masses: usize,
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
    /// Their positions' coordinates, hull axes, from the mid-point of the suspension points, m.
    pub attachment_positions: Vec<[usize; 3]>,
    /// Masses added for a swing, by swing.
    pub added_masses: Vec<Vec<usize>>,
    /// By swing.
    pub swings: Vec<SwingIndex>,
    /// What instruments share among their readings.
    pub shared: Vec<Shared>,
}

impl Layout {
    /// Lays out the parameters of a session. `gravity` is the effective one, buoyancy included;
    /// `pitch_deg` holds what the phones' own tilts say of each swing's pitch, where they say
    /// anything, `yaw_periods_s` the observed yaw period of each swing, where there is one,
    /// `inclines_deg` the angle of each incline that was recorded.
    pub fn of(
        session: &Session,
        gravity: Quantity,
        pitch_deg: &[Option<Quantity>],
        yaw_periods_s: &[Option<f64>],
        inclines_deg: &[Option<Quantity>],
    ) -> Self {
        let mut builder = Builder::of(session);
        let gravity = builder.stated(InputKind::Gravity, gravity);
        let clock = Quantity::new(0.0, PHONE_CLOCK_U_RELATIVE);
        let clock = builder.stated_with_step(InputKind::PhoneClock, clock, CLOCK_STEP);
        let mass = session.body.mass_kg.unwrap_or(Quantity::exact(1.0));
        let mass = builder.read("body.mass", InputKind::Mass, mass);
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
        let riding = session.attachments.iter().enumerate();
        let (attachment_masses, attachment_positions) =
            riding.map(|(i, one)| builder.riding(i, one)).unzip();
        let mut added_masses = Vec::new();
        let mut swings = Vec::new();
        for i in 0..session.swings.len() {
            let phone_pitch = pitch_deg.get(i).copied().flatten();
            let hung = builder.swing(session, i, phone_pitch, scale_m, &swings);
            swings.push(hung);
            added_masses.push(builder.added(i, &session.swings[i]));
        }
        builder.read_beside(session, inclines_deg);
        Layout {
            shared: builder.shared,
            parameters: builder.parameters,
            gravity,
            clock,
            mass,
            log_gyradii,
            product_xz,
            attachment_masses,
            attachment_positions,
            added_masses,
            swings,
        }
    }

    /// Logarithm of the depth in a level hanging, where there is one.
    pub fn level_depth(&self) -> Option<usize> {
        let is_level = |i: usize| self.parameters[i].prior.value.abs() < LEVEL_DEG;
        let level = |s: &&SwingIndex| is_level(s.pitch_deg) && s.roll_deg.is_none_or(is_level);
        self.swings.iter().find(level).map(|s| s.log_depth)
    }

    /// The same; without a level hanging, that of the first, in which weights are put on then.
    pub fn level_or_first_depth(&self) -> Option<usize> {
        self.level_depth()
            .or(self.swings.first().map(|s| s.log_depth))
    }

    /// Relative error of the clock that a swing was timed with.
    pub fn clock_error<S: Real>(&self, x: &[S], swing: &SwingIndex) -> S {
        swing.clock.map_or(S::zero(), |own| x[self.clock] + x[own])
    }

    /// Prior values, the point from which the solution starts.
    pub fn start(&self) -> Vec<f64> {
        self.parameters.iter().map(|p| p.prior.value).collect()
    }
}

/// What turns a hull on its lines.
const TURNING: [&str; 3] = ["hull_pitch_deg", "hull_roll_deg", "points_moved"];

/// Indices of how a hull was turned.
struct Turned {
    pitch_deg: usize,
    roll_deg: Option<usize>,
    log_depth: usize,
}

struct Builder<'a> {
    session: &'a Session,
    parameters: Vec<Parameter>,
    hangings: Vec<([f64; 2], usize)>,
    shared: Vec<Shared>,
}

impl<'a> Builder<'a> {
    fn of(session: &'a Session) -> Self {
        Self {
            session,
            parameters: vec![],
            hangings: vec![],
            shared: vec![],
        }
    }

    /// A stated figure by its key in the session: a reading of its own, which shares with others what
    /// their instrument does, and nothing else.
    fn read(&mut self, key: &str, name: impl Into<Input>, figure: Quantity) -> usize {
        self.read_with_step(key, name, figure, usual_step(figure))
    }

    /// A diameter of which the radius was read.
    fn read_radius(&mut self, key: &str, kind: InputKind, diameter: Quantity) -> usize {
        let radius = Quantity::new(0.5 * diameter.value, 0.5 * diameter.u);
        self.read_times(2.0, key, kind.into(), radius, usual_step(diameter))
    }

    fn read_with_step(
        &mut self,
        key: &str,
        name: impl Into<Input>,
        figure: Quantity,
        step: f64,
    ) -> usize {
        self.read_times(1.0, key, name.into(), figure, step)
    }

    /// A parameter that is a multiple of what was read.
    fn read_times(
        &mut self,
        factor: f64,
        key: &str,
        name: Input,
        figure: Quantity,
        step: f64,
    ) -> usize {
        let read = self.session.reading(key, figure);
        let prior = Quantity::new(factor * read.value, factor * read.u);
        let place = self.push(name, Role::Stated, prior, step);
        self.share(key, Reading::Parameter(place), figure.value, factor);
        place
    }

    /// Notes what a reading shares with others of its instrument; `slope` is the change of the row
    /// by that of the reading.
    fn share(&mut self, key: &str, reading: Reading, value: f64, slope: f64) {
        let Some(instrument) = self.session.instrument(key) else {
            return;
        };
        let errors = [
            (InputKind::InstrumentScale, instrument.scale_u * value),
            (InputKind::InstrumentZero, instrument.zero_u),
        ];
        for (kind, change) in errors.into_iter().filter(|(_, change)| *change != 0.0) {
            let name = Input::of(kind, &instrument.id);
            let entry = (reading, slope * change);
            match self.shared.iter_mut().find(|one| one.name == name) {
                Some(known) => known.readings.push(entry),
                None => self.shared.push(Shared {
                    name,
                    readings: vec![entry],
                }),
            }
        }
    }

    /// What rides along: its mass and place.
    fn riding(&mut self, i: usize, one: &Attachment) -> (usize, [usize; 3]) {
        let first = self.parameters.len();
        let name = Input::of(InputKind::Mass, &one.name);
        let mass = self.read(&format!("attachment[{}].mass", i + 1), name, one.mass_kg);
        let place = one.position_m.map(|x| {
            let name = Input::of(InputKind::Position, &one.name);
            let (prior, step) = (Quantity::new(x, one.position_u_m), 1e-6);
            self.push(name, Role::Stated, prior, step)
        });
        for riding in &mut self.parameters[first..] {
            riding.role = Role::Riding;
        }
        (mass, place)
    }

    /// The masses added for a swing.
    fn added(&mut self, i: usize, swing: &Swing) -> Vec<usize> {
        let each = swing.added_masses.iter().enumerate();
        each.map(|(k, one)| {
            let key = format!("swing[{}].added_mass[{}].mass", i + 1, k + 1);
            let name = Input::of(InputKind::Mass, &format!("added mass {}", k + 1));
            self.read(&key, name, one.mass_kg)
        })
        .collect()
    }

    /// What instruments share among readings that are rows of their own: typed periods, inclines,
    /// points that were moved.
    fn read_beside(&mut self, session: &Session, inclines_deg: &[Option<Quantity>]) {
        for (i, swing) in session.swings.iter().enumerate() {
            if let SwingData::PeriodsS(typed) = &swing.data {
                for (mode, period) in typed {
                    let reading = Reading::Observed(Observed::Period(i, *mode));
                    self.share(&period_key(i, *mode), reading, period.value, 1.0);
                }
            }
            let is_own = session.measured_at(i, "points_moved") == i;
            if let Some(moved) = swing.suspension.points_moved_m.filter(|_| is_own) {
                let reading = Reading::Observed(Observed::Moved(i));
                self.share(&moved_key(i), reading, moved.value, 1.0);
            }
        }
        for (i, incline) in session.inclines.iter().enumerate() {
            let reading = Reading::Observed(Observed::Incline(i));
            let recorded_deg = inclines_deg.get(i).copied().flatten();
            for part in incline_parts(incline, i, recorded_deg) {
                self.share(&part.key, reading, part.figure.value, part.slope_deg);
            }
        }
    }

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
        self.stated_with_step(name, prior, usual_step(prior))
    }

    /// What is assumed, or seen by one phone, is one parameter wherever it is the same.
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
        before: &[SwingIndex],
    ) -> SwingIndex {
        let swing = &session.swings[i];
        let is_recorded = matches!(swing.data, SwingData::Recording(_));
        let hung = &swing.suspension;
        let key = |name: &str| format!("swing[{}].suspension.{name}", i + 1);
        // A figure of the swing that this one hangs as is that one's reading.
        let earlier = |name: &str| before.get(session.measured_at(i, name));
        let mut read = |name: &str, kind: InputKind, figure: Option<Quantity>| {
            figure.map(|figure| self.read(&key(name), kind, figure))
        };
        let line_length = match earlier("line_length") {
            Some(first) => first.line_length,
            None => read("line_length", InputKind::LineLength, hung.line_length_m),
        };
        let axis_height = match earlier("axis_height") {
            Some(first) => first.axis_height,
            None => read("axis_height", InputKind::AxisHeight, hung.axis_height_m),
        };
        let mut across = |name: &str, kind: InputKind, figure: Option<Quantity>| {
            figure.map(|figure| match hung.kind {
                SuspensionKind::Trifilar => self.read_radius(&key(name), kind, figure),
                _ => self.read(&key(name), kind, figure),
            })
        };
        let (below, above) = match hung.kind {
            SuspensionKind::Trifilar => ("radius", "top_radius"),
            _ => ("spacing", "top_spacing"),
        };
        let spacing = match earlier(below) {
            Some(first) => first.spacing,
            None => across(below, InputKind::Spacing, hung.spacing_m),
        };
        // Where it is not stated it is the spacing below.
        let top_spacing = match (hung.top_spacing_m, earlier(above)) {
            (None, _) => spacing,
            (Some(_), Some(first)) => first.top_spacing,
            (stated, None) => across(above, InputKind::TopSpacing, stated),
        };
        let turned = self.turned(session, i, phone_pitch, scale_m, before);
        SwingIndex {
            line_length,
            spacing,
            top_spacing,
            pitch_deg: turned.pitch_deg,
            roll_deg: turned.roll_deg,
            log_depth: turned.log_depth,
            axis_height,
            added_masses: i,
            clock: is_recorded.then(|| self.clock_of_swing()),
        }
    }

    /// How a swing's hull was turned, and the depth that goes with it: those of the swing that it
    /// hangs as, unless something that turns it is stated anew.
    fn turned(
        &mut self,
        session: &Session,
        i: usize,
        phone_pitch: Option<Quantity>,
        scale_m: f64,
        before: &[SwingIndex],
    ) -> Turned {
        let hung = &session.swings[i].suspension;
        let key = |name: &str| format!("swing[{}].suspension.{name}", i + 1);
        let first = session.same_hanging(i);
        let is_same_way = first.is_some_and(|first| {
            session.swings[first].suspension.orientation == hung.orientation
                && TURNING.iter().all(|key| !session.states(i, key))
        });
        if let Some(first) = first.filter(|_| is_same_way).and_then(|at| before.get(at)) {
            return Turned {
                pitch_deg: first.pitch_deg,
                roll_deg: first.roll_deg,
                log_depth: first.log_depth,
            };
        }
        let earlier = |name: &str| before.get(session.measured_at(i, name));
        let pitch = phone_pitch
            .or(hung.hull_pitch_deg)
            .unwrap_or(Quantity::new(0.0, UNSTATED_PITCH_U_DEG));
        let stated = hung.hull_pitch_deg.filter(|_| phone_pitch.is_none());
        let pitch_deg = match (stated, earlier("hull_pitch_deg")) {
            (Some(_), Some(first)) => first.pitch_deg,
            (Some(_), None) => {
                self.read_with_step(&key("hull_pitch_deg"), InputKind::HullPitch, pitch, 1e-3)
            }
            (None, _) => self.stated_with_step(InputKind::HullPitch, pitch, 1e-3),
        };
        let log_depth = self.depth(
            [
                hung.hull_pitch_deg.map_or(pitch.value, |q| q.value),
                hung.hull_roll_deg.map_or(0.0, |q| q.value),
            ],
            scale_m,
        );
        let roll_deg = hung
            .hull_roll_deg
            .and_then(|roll| match earlier("hull_roll_deg") {
                Some(first) => first.roll_deg,
                None => {
                    let key = key("hull_roll_deg");
                    Some(self.read_with_step(&key, InputKind::HullRoll, roll, 1e-3))
                }
            });
        Turned {
            pitch_deg,
            roll_deg,
            log_depth,
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

    fn depth(&mut self, turned_deg: [f64; 2], scale_m: f64) -> usize {
        let known = self
            .hangings
            .iter()
            .find(|(known, _)| (0..2).all(|k| (known[k] - turned_deg[k]).abs() < SAME_HANGING_DEG))
            .map(|h| h.1);
        known.unwrap_or_else(|| {
            let index = self.unknown(InputKind::Depth, (0.4 * scale_m).ln(), WEAK_LOG_U, 1e-6);
            self.hangings.push((turned_deg, index));
            index
        })
    }
}

fn usual_step(figure: Quantity) -> f64 {
    1e-6 * figure.value.abs().max(1e-3)
}

/// The key of a typed period.
pub fn period_key(swing: usize, mode: ModeName) -> String {
    format!("swing[{}].periods_s.{}", swing + 1, mode.name())
}

/// The key of how far suspension points were moved.
pub fn moved_key(swing: usize) -> String {
    format!("swing[{}].suspension.points_moved", swing + 1)
}

/// A figure of an incline, and what it makes of the angle.
pub struct InclinePart {
    /// The figure's key.
    pub key: String,
    /// The figure.
    pub figure: Quantity,
    /// Change of the angle as read, less that as predicted by (20), by that of the figure, degrees.
    pub slope_deg: f64,
}

/// The figures of an incline that were read: its angle, and the weight's own, which widen the angle
/// whether it is stated or recorded.
pub fn incline_parts(
    incline: &Incline,
    i: usize,
    recorded_deg: Option<Quantity>,
) -> Vec<InclinePart> {
    let angle = match incline.angle {
        InclineAngle::Stated(angle) => angle,
        InclineAngle::Recording(_) => recorded_deg.unwrap_or_default(),
    };
    let part = |name: &str, figure: Quantity, slope_deg: f64| InclinePart {
        key: format!("incline[{}].{name}", i + 1),
        figure,
        slope_deg,
    };
    let slopes = incline_slopes_deg(incline, angle.value);
    let [mass, arm, depth] = slopes;
    vec![
        part("angle_deg", angle, 1.0),
        part("mass", incline.mass_kg, -mass),
        part("arm", incline.arm_m, -arm),
        part("depth", incline.depth_m, -depth),
    ]
}

/// Change of an incline's angle by its weight's mass, arm and depth, degrees by kg, m, m.
pub fn incline_slopes_deg(incline: &Incline, angle_deg: f64) -> [f64; 3] {
    let tangent = angle_deg.to_radians().tan();
    let slope = (tangent / (1.0 + tangent * tangent)).to_degrees();
    [
        slope / incline.mass_kg.value,
        slope / incline.arm_m.value,
        -slope * tangent / incline.arm_m.value,
    ]
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
