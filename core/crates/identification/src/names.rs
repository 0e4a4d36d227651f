//! What results are of: quantities, inputs, ways to a quantity, units and decisions. Their names in
//! files are written and read here alone.

use std::borrow::Borrow;
use std::fmt::{Display, Formatter};
use std::str::FromStr;

use gyradius_base::error::{Error, Result};
use gyradius_base::{named, ordered_as_text, written_as_text};
use gyradius_recording::{End, ModeName};

/// A quantity of a result.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum QuantityName {
    /// Yaw gyradius, m.
    KYaw,
    /// Pitch gyradius, m.
    KPitch,
    /// Roll gyradius, m.
    KRoll,
    /// Depth of the centre of mass below the suspension points, m.
    CmDepth,
    /// Angle of the principal axis, bow up, degrees.
    Psi,
    /// Gyradii about the principal axes, m.
    PrincipalGyradii,
    /// Inertia tensor, kg m².
    Inertia,
    /// Moment of inertia about the vertical through the centre of mass, kg m²; it and the two below
    /// stand where the tensor is not known in full.
    InertiaYaw,
    /// Moment of inertia about the athwartships axis, kg m².
    InertiaPitch,
    /// Moment of inertia about the fore-and-aft axis, kg m².
    InertiaRoll,
    /// Small-amplitude period of a swing, s.
    SmallPeriod(SmallPeriod),
}

/// The name of a swing's small-amplitude period: `small_period_swing-1_s`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SmallPeriod(String);

impl QuantityName {
    /// The numbers of a hull, in the order of the report.
    pub const SCALARS: [Self; 5] = [
        Self::KYaw,
        Self::KPitch,
        Self::KRoll,
        Self::CmDepth,
        Self::Psi,
    ];

    /// Short names of the same, without the unit: what people type.
    pub const SHORT: [(&str, Self); 5] = [
        ("k_yaw", Self::KYaw),
        ("k_pitch", Self::KPitch),
        ("k_roll", Self::KRoll),
        ("depth", Self::CmDepth),
        ("psi", Self::Psi),
    ];

    const FIXED: [Self; 10] = [
        Self::KYaw,
        Self::KPitch,
        Self::KRoll,
        Self::CmDepth,
        Self::Psi,
        Self::PrincipalGyradii,
        Self::Inertia,
        Self::InertiaYaw,
        Self::InertiaPitch,
        Self::InertiaRoll,
    ];
    const SMALL_PERIOD: [&str; 2] = ["small_period_", "_s"];

    /// The small-amplitude period of a swing.
    pub fn small_period_of(swing: &str) -> Self {
        let [before, after] = Self::SMALL_PERIOD;
        Self::SmallPeriod(SmallPeriod(format!("{before}{swing}{after}")))
    }

    /// The quantity that somebody types: by its name in files, or by its short one.
    ///
    /// # Errors
    /// Where no quantity has that name.
    pub fn called(text: &str) -> Result<Self> {
        let short = Self::SHORT.into_iter().find(|(short, _)| *short == text);
        short.map_or_else(|| text.parse(), |(_, name)| Ok(name))
    }

    /// Whether it is one number, and not a vector or a matrix.
    pub fn is_one_number(&self) -> bool {
        !matches!(self, Self::PrincipalGyradii | Self::Inertia)
    }

    /// Its name in files.
    pub fn as_str(&self) -> &str {
        match self {
            Self::KYaw => "k_yaw_m",
            Self::KPitch => "k_pitch_m",
            Self::KRoll => "k_roll_m",
            Self::CmDepth => "cm_depth_m",
            Self::Psi => "psi_deg",
            Self::PrincipalGyradii => "principal_gyradii_m",
            Self::Inertia => "inertia_kg_m2",
            Self::InertiaYaw => "inertia_yaw_kg_m2",
            Self::InertiaPitch => "inertia_pitch_kg_m2",
            Self::InertiaRoll => "inertia_roll_kg_m2",
            Self::SmallPeriod(name) => &name.0,
        }
    }

    /// The moment of inertia that belongs to a gyradius.
    pub fn moment(&self) -> Option<Self> {
        match self {
            Self::KYaw => Some(Self::InertiaYaw),
            Self::KPitch => Some(Self::InertiaPitch),
            Self::KRoll => Some(Self::InertiaRoll),
            _ => None,
        }
    }

    /// Its unit as it is printed.
    pub fn unit(&self) -> &'static str {
        match self {
            Self::KYaw | Self::KPitch | Self::KRoll | Self::CmDepth | Self::PrincipalGyradii => "m",
            Self::Psi => "°",
            Self::Inertia | Self::InertiaYaw | Self::InertiaPitch | Self::InertiaRoll => "kg m²",
            Self::SmallPeriod(_) => "s",
        }
    }
}

impl Display for QuantityName {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        f.pad(self.as_str())
    }
}

impl FromStr for QuantityName {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let [before, after] = Self::SMALL_PERIOD;
        if let Some(known) = Self::FIXED.into_iter().find(|q| q.as_str() == text) {
            return Ok(known);
        }
        match text
            .strip_prefix(before)
            .and_then(|rest| rest.strip_suffix(after))
        {
            Some(swing) => Ok(Self::small_period_of(swing)),
            None => {
                let known = Self::FIXED.each_ref().map(Self::as_str).join(", ");
                let expected = format!("{known} or {before}…{after}");
                Err(Error::argument("quantity", expected, text))
            }
        }
    }
}

/// Maps by quantity can be asked by name.
impl Borrow<str> for QuantityName {
    fn borrow(&self) -> &str {
        self.as_str()
    }
}

impl std::hash::Hash for QuantityName {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        self.as_str().hash(state);
    }
}

ordered_as_text!(QuantityName);
written_as_text!(
    QuantityName,
    "A quantity with its unit: k_yaw_m, k_pitch_m, k_roll_m, cm_depth_m, psi_deg, principal_gyradii_m, inertia_kg_m2, inertia_yaw_kg_m2, inertia_pitch_kg_m2, inertia_roll_kg_m2 or small_period_<swing>_s"
);

named! {
    /// How a quantity was got.
    Method: "method" {
        /// From everything in the session at once.
        JointEstimate = "joint_estimate",
        /// The same, without a figure of the principal axes' tilt.
        JointEstimateAlongHullAxes = "joint_estimate, hull axes taken as principal",
        /// From the simulation of one motion.
        SimulationOfOneMotion = "simulation of one motion",
    }
}

named! {
    /// A closed-form estimator of a quantity.
    RouteMethod: "method" {
        /// Oscillations per beat of yaw and sway, (13).
        BeatCount = "beat_count",
        /// Compound pendulum with the depth of the joint estimate, (23).
        CompoundPendulum = "compound_pendulum",
        /// Both periods of the double pendulum and the sway period, (17), (18).
        DoublePendulum = "double_pendulum",
        /// The same with the line length in place of the sway period.
        DoublePendulumAndLineLength = "double_pendulum_and_line_length",
        /// A weight hung from one end, (20).
        Incline = "incline",
        /// The same weight at bow and stern, (21).
        InclineBothEnds = "incline_both_ends",
        /// Compound pendulum at two heights, (22), (23).
        Lamboley = "lamboley",
        /// Roll, yaw and one tilted yaw, (4).
        OneTilt = "one_tilt",
        /// Yaw period over sway period, (8).
        PeriodRatio = "period_ratio",
        /// Suspension points moved along the deck.
        PointsMoved = "points_moved",
        /// Yaw at all tilts by least squares, (3).
        TiltFit = "tilt_fit",
        /// Yaw level and at two tilts, (25).
        TiltedYaw = "tilted_yaw",
        /// Yaw level and at two tilts a right angle apart, (26).
        TiltedYawRightAngle = "tilted_yaw_right_angle",
        /// Yaw period with line length and spacing, (5), (6).
        YawPeriod = "yaw_period",
    }
}

named! {
    /// The unit of a mode's amplitude.
    AmplitudeUnit: "amplitude_unit" {
        /// No amplitude is known.
        None = "",
        /// Metres.
        Metre = "m",
        /// Angle of the body or of the lines.
        Radian = "rad",
        /// Where only the rate is known.
        RadianPerSecond = "rad/s",
    }
}

named! {
    /// Which side of a class limit conforms.
    Relation: "relation" {
        /// The value must not exceed the limit.
        AtMost = "<=",
        /// The value must reach the limit.
        AtLeast = ">=",
    }
}

named! {
    /// What is decided of a value at a class limit.
    Decision: "verdict" {
        /// It does not conform.
        Fail = "fail",
        /// It conforms.
        Pass = "pass",
        /// It is too near to the limit to tell.
        Undecided = "undecided",
    }
}

named! {
    /// An input of a result.
    InputKind: "input" {
        /// Height of a compound pendulum's axis.
        AxisHeight = "axis_height",
        /// Period of a compound pendulum.
        CompoundPeriod = "compound pendulum period",
        /// Doubt which stated figure of a session that contradicts itself is wrong.
        Contradiction = "contradiction",
        /// Depth of the centre of mass.
        Depth = "depth",
        /// The correction of periods for finite amplitude.
        FiniteAmplitude = "finite-amplitude correction",
        /// Gravity at the site, buoyancy taken off.
        Gravity = "gravity",
        /// A gyradius that is not asked for.
        Gyradius = "gyradius",
        /// Pitch of the hull as hung.
        HullPitch = "hull_pitch",
        /// Heel of the hull as hung.
        HullRoll = "hull_roll",
        /// Angle by a weight at the bow.
        InclineBow = "incline bow",
        /// Angle by a weight at the stern.
        InclineStern = "incline stern",
        /// The scale of an instrument, in all of its readings.
        InstrumentScale = "scale",
        /// The zero of an instrument, in all of its readings.
        InstrumentZero = "zero",
        /// Length of the lines.
        LineLength = "line_length",
        /// A mass.
        Mass = "mass",
        /// A number of a cause that the criticism tries; no budget shows it.
        CauseNumber = "number of a cause",
        /// The phone's clock.
        PhoneClock = "phone_clock",
        /// Period of the pendulum's pitch in phase.
        PitchInPhasePeriod = "pitch in phase period",
        /// Period of the pendulum's pitch out of phase.
        PitchOutOfPhasePeriod = "pitch out of phase period",
        /// Where something rides on the hull.
        Position = "position",
        /// Product of inertia.
        ProductXz = "product_xz",
        /// Period of the pendulum's roll in phase.
        RollInPhasePeriod = "roll in phase period",
        /// Period of the pendulum's roll out of phase.
        RollOutOfPhasePeriod = "roll out of phase period",
        /// The samples of a swing.
        Samples = "samples",
        /// Spacing of the lines at the hull.
        Spacing = "spacing",
        /// How far the suspension points were moved.
        SuspensionPoints = "suspension points",
        /// Period of sway.
        SwayPeriod = "sway period",
        /// Spacing of the lines at the top.
        TopSpacing = "top_spacing",
        /// What the tilt of the principal axes, not known, makes of the second order.
        UnknownTilt = "unknown tilt of the principal axes",
        /// Period of a motion without a name.
        UnnamedPeriod = "unnamed motion period",
        /// Period of yaw.
        YawPeriod = "yaw period",
    }
}

impl InputKind {
    /// The period of a mode.
    pub fn period(mode: ModeName) -> Self {
        match mode {
            ModeName::Yaw => Self::YawPeriod,
            ModeName::Sway => Self::SwayPeriod,
            ModeName::PitchInPhase => Self::PitchInPhasePeriod,
            ModeName::PitchOutOfPhase => Self::PitchOutOfPhasePeriod,
            ModeName::RollInPhase => Self::RollInPhasePeriod,
            ModeName::RollOutOfPhase => Self::RollOutOfPhasePeriod,
            ModeName::Compound => Self::CompoundPeriod,
            ModeName::Other => Self::UnnamedPeriod,
        }
    }

    /// The incline at an end.
    pub fn incline(end: End) -> Self {
        match end {
            End::Bow => Self::InclineBow,
            End::Stern => Self::InclineStern,
        }
    }

    /// Unit of a stated figure as it is printed; none of what nobody states.
    pub fn unit(self) -> &'static str {
        match self {
            Self::LineLength | Self::Spacing | Self::TopSpacing | Self::AxisHeight => "m",
            Self::Gravity => "m/s²",
            Self::HullPitch | Self::HullRoll => "°",
            _ => "",
        }
    }
}

/// An input of a result, and the swing or the mass that it is of.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Input {
    /// What.
    pub kind: InputKind,
    /// Of which swing or mass, where there are several.
    pub of: Option<String>,
}

impl Input {
    /// An input of one swing or one mass.
    pub fn of(kind: InputKind, which: &str) -> Self {
        Self {
            kind,
            of: Some(which.to_owned()),
        }
    }

    /// The period of a mode in a swing.
    pub fn period(mode: ModeName, swing: &str) -> Self {
        Self::of(InputKind::period(mode), swing)
    }
}

impl From<InputKind> for Input {
    fn from(kind: InputKind) -> Self {
        Self { kind, of: None }
    }
}

impl Display for Input {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match &self.of {
            Some(which) => write!(f, "{} of {which}", self.kind),
            None => Display::fmt(&self.kind, f),
        }
    }
}

impl FromStr for Input {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        // A name may hold an "of" of its own: "pitch out of phase period of bow-up".
        let of_one = InputKind::ALL.iter().find_map(|kind| {
            let which = text.strip_prefix(kind.name())?.strip_prefix(" of ")?;
            Some(Self::of(*kind, which))
        });
        match of_one {
            Some(input) => Ok(input),
            None => text.parse::<InputKind>().map(Self::from),
        }
    }
}

ordered_as_text!(Input);
written_as_text!(
    Input,
    "An input, of one swing or mass where there are several: spacing, yaw period of yaw-1, mass of crew"
);

/// What a route starts from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Origin {
    /// A swing, by its id.
    Swing(String),
    /// An incline.
    Incline(InputKind),
}

impl Display for Origin {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Swing(id) => f.pad(id),
            Self::Incline(kind) => Display::fmt(kind, f),
        }
    }
}

/// What two ways of knowing are compared about.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Subject {
    /// A stated figure.
    Stated(InputKind),
    /// A quantity of the hull.
    Quantity(QuantityName),
}

impl Subject {
    /// Its unit as it is printed.
    pub fn unit(&self) -> &'static str {
        match self {
            Self::Stated(kind) => kind.unit(),
            Self::Quantity(name) => name.unit(),
        }
    }
}

impl Display for Subject {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Stated(kind) => Display::fmt(kind, f),
            Self::Quantity(name) => Display::fmt(name, f),
        }
    }
}

impl FromStr for Subject {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let quantity = || text.parse().map(Self::Quantity);
        text.parse().map(Self::Stated).or_else(|_| quantity())
    }
}

written_as_text!(
    Subject,
    "A stated figure such as line_length, or a quantity such as k_yaw_m"
);

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn names_read_back() {
        for name in QuantityName::FIXED {
            assert_eq!(name.to_string().parse::<QuantityName>().unwrap(), name);
        }
        let period = QuantityName::small_period_of("yaw-1");
        assert_eq!(period.as_str(), "small_period_yaw-1_s");
        assert_eq!(period.as_str().parse::<QuantityName>().unwrap(), period);
        for kind in InputKind::ALL {
            for input in [Input::from(*kind), Input::of(*kind, "bow of oak")] {
                assert_eq!(input.to_string().parse::<Input>().unwrap(), input);
            }
        }
        for (short, name) in QuantityName::SHORT {
            assert_eq!(QuantityName::called(short).unwrap(), name);
            assert_eq!(QuantityName::called(name.as_str()).unwrap(), name);
            // In files only the full name counts.
            assert!(short.parse::<QuantityName>().is_err());
        }
        let said = "k_yam_m".parse::<QuantityName>().unwrap_err().to_string();
        assert!(
            said.contains("k_yaw_m") && said.contains("k_yam_m"),
            "{said}"
        );
    }

    /// Written results are in the order of their names.
    #[test]
    fn the_order_is_that_of_the_names() {
        let is_sorted = |names: &[&str]| names.is_sorted();
        assert!(is_sorted(
            &RouteMethod::ALL
                .iter()
                .map(|m| m.name())
                .collect::<Vec<_>>()
        ));
        let mut all = QuantityName::FIXED.to_vec();
        all.push(QuantityName::small_period_of("a"));
        all.sort();
        assert!(is_sorted(
            &all.iter().map(QuantityName::as_str).collect::<Vec<_>>()
        ));
    }
}
