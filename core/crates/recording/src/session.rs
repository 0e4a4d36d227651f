//! What a measurement is: the plain data of `session.toml`.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::quantity::Quantity;
use super::recorded::Recorded;
use super::same_hanging::HungAs;

/// One hull, measured in one sitting (`gyradius-session/1`).
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Session {
    /// Title, free text.
    pub title: String,
    /// When it was measured, as people write it (`2026-05-04`); empty where nobody said.
    #[serde(default)]
    pub measured_on: String,
    /// Model of the phone; empty where nobody said.
    #[serde(default)]
    pub phone: String,
    /// Program that recorded; empty where nobody said.
    #[serde(default)]
    pub logger: String,
    /// The body that swings.
    pub body: Body,
    /// Where it swings.
    pub site: Site,
    /// What rides on the hull and is taken off the result.
    pub attachments: Vec<Attachment>,
    /// The swings, in file order; ids are unique.
    pub swings: Vec<Swing>,
    /// Incline tests.
    pub inclines: Vec<Incline>,
    /// What the recorder says of the recordings that it made.
    pub recorded: Vec<Recorded>,
    /// The instruments that figures were read with.
    #[serde(default)]
    pub instruments: Vec<Instrument>,
    /// Which figure was read with which instrument: the instrument's id by the figure's key,
    /// `swing[1].suspension.spacing`.
    #[serde(default)]
    pub read_with: BTreeMap<String, String>,
    /// Swings that hang as an earlier one did, by the id of the later: figures that are not stated of
    /// it anew are the same readings.
    #[serde(default)]
    pub hung_as: BTreeMap<String, HungAs>,
}

impl Session {
    /// The instrument that a figure was read with, by the figure's key.
    pub fn instrument(&self, key: &str) -> Option<&Instrument> {
        let id = self.read_with.get(key)?;
        self.instruments.iter().find(|one| one.id == *id)
    }

    /// A figure with all of its uncertainty: its own, and what its instrument shares among all of
    /// its readings.
    pub fn reading(&self, key: &str, figure: Quantity) -> Quantity {
        let Some(instrument) = self.instrument(key) else {
            return figure;
        };
        let scale = instrument.scale_u * figure.value;
        Quantity::new(figure.value, figure.u.hypot(scale).hypot(instrument.zero_u))
    }
}

/// What figures were read with: its errors are common to all of its readings.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Instrument {
    /// Unique id.
    pub id: String,
    /// What it is.
    pub kind: InstrumentKind,
    /// Standard uncertainty of its scale, relative.
    pub scale_u: f64,
    /// Standard uncertainty of its zero, in the unit of its readings.
    pub zero_u: f64,
}

/// Which instrument.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum InstrumentKind {
    /// Reads lengths.
    Tape,
    /// Reads periods.
    Clock,
    /// Reads angles.
    Protractor,
    /// Reads masses.
    Scale,
}

/// The body as stated.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Body {
    /// Name, free text.
    pub name: String,
    /// Everything that swings, added masses of single swings excluded, kg. Optional: without it
    /// there are gyradii but no moments of inertia, and attachments cannot be taken off.
    pub mass_kg: Option<Quantity>,
    /// Length overall, m.
    pub length_overall_m: Option<f64>,
    /// Mean density, kg/m³; switches the buoyancy correction on.
    pub density_kg_m3: Option<f64>,
}

/// The place.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Site {
    /// Free-fall acceleration as stated, m/s².
    pub gravity_m_s2: Option<Quantity>,
    /// Latitude, degrees, and altitude, m, from which gravity is computed where it is not stated.
    pub latitude_deg: Option<f64>,
    /// Altitude above the ellipsoid, m.
    pub altitude_m: Option<f64>,
    /// Air density, kg/m³.
    pub air_density_kg_m3: Option<f64>,
}

/// A body that rides on the hull and is taken off the result.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Attachment {
    /// Name, free text.
    pub name: String,
    /// Mass, kg.
    pub mass_kg: Quantity,
    /// Centre of mass, hull axes, from the mid-point of the suspension points, m.
    pub position_m: [f64; 3],
    /// Standard uncertainty of each of its coordinates, m.
    #[serde(default)]
    pub position_u_m: f64,
    /// Gyradii about its own centre and hull axes, m (0 for a point).
    pub gyradii_m: [f64; 3],
}

/// A mass added for one swing.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct AddedMass {
    /// Mass, kg.
    pub mass_kg: Quantity,
    /// Position, hull axes, from the mid-point of the suspension points, m.
    pub position_m: [f64; 3],
}

/// One swing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Swing {
    /// Unique id.
    pub id: String,
    /// What was recorded.
    pub data: SwingData,
    /// What the operator meant to excite; a hint only.
    pub excited: Vec<Excitation>,
    /// Masses added for this swing.
    pub added_masses: Vec<AddedMass>,
    /// Amplitudes of typed-in periods by mode, degrees.
    pub amplitude_deg: BTreeMap<ModeName, f64>,
    /// How it hung.
    pub suspension: Suspension,
}

/// What a swing left behind.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SwingData {
    /// A phone's recording: file name in the session.
    Recording(String),
    /// A rangefinder's track of one point: file name, and the point in hull axes from the mid-point
    /// of the suspension points, m.
    Displacement {
        /// File name in the session.
        file: String,
        /// The point, if stated.
        at_m: Option<[f64; 3]>,
    },
    /// A list of periods in time order: file name in the session.
    Periods(String),
    /// Periods typed in, by mode, s.
    PeriodsS(BTreeMap<ModeName, Quantity>),
}

/// What an operator can mean to excite.
#[derive(
    Debug,
    Clone,
    Copy,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Hash,
    Serialize,
    Deserialize,
    schemars::JsonSchema,
)]
#[serde(rename_all = "snake_case")]
#[allow(missing_docs)]
pub enum Excitation {
    Yaw,
    Sway,
    Surge,
    Pitch,
    Roll,
}

impl Excitation {
    /// Whether the hull turns; else it shifts alone.
    pub fn turns(self) -> bool {
        !matches!(self, Self::Sway | Self::Surge)
    }

    /// The shift along the line that joins the suspension points.
    pub fn along(orientation: Orientation) -> Self {
        match orientation {
            Orientation::Athwartships => Self::Sway,
            Orientation::ForeAndAft => Self::Surge,
        }
    }

    /// The turn about that line.
    pub fn about(orientation: Orientation) -> Self {
        match orientation {
            Orientation::Athwartships => Self::Pitch,
            Orientation::ForeAndAft => Self::Roll,
        }
    }

    /// What sets a mode going.
    pub fn of(mode: ModeName, orientation: Orientation) -> Self {
        match mode {
            ModeName::Yaw => Self::Yaw,
            ModeName::Sway => Self::along(orientation),
            _ => Self::about(orientation),
        }
    }
}

/// The names of the modes of motion, by shape.
///
/// # Conventions
/// `Sway` is the simple-pendulum motion along the line that joins the suspension points
/// (athwartships on an athwartships suspension, fore and aft on a fore-and-aft one). `…InPhase` is
/// the long-period, `…OutOfPhase` the short-period mode of the double pendulum (errata to eq. 16).
#[derive(
    Debug,
    Clone,
    Copy,
    PartialEq,
    Eq,
    PartialOrd,
    Ord,
    Hash,
    Serialize,
    Deserialize,
    schemars::JsonSchema,
)]
#[serde(rename_all = "snake_case")]
#[allow(missing_docs)]
pub enum ModeName {
    Yaw,
    Sway,
    PitchInPhase,
    PitchOutOfPhase,
    RollInPhase,
    RollOutOfPhase,
    Compound,
    Other,
}

/// Which suspension.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SuspensionKind {
    /// Two lines.
    Bifilar,
    /// Two inverted Vs: a fixed horizontal axis.
    Compound,
    /// Three lines on a circle about the vertical axis: `spacing_m` is the circle's diameter.
    Trifilar,
    /// Nothing is stated: the recording gives periods and damping alone.
    Free,
}

/// The direction that joins the suspension points (bifilar) or the swing axis (compound).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
#[allow(missing_docs)]
pub enum Orientation {
    Athwartships,
    ForeAndAft,
}

/// How the body hung, as stated.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Suspension {
    /// Bifilar or compound.
    pub kind: SuspensionKind,
    /// Direction of the line through the suspension points.
    pub orientation: Orientation,
    /// Length of the lines, m (bifilar).
    pub line_length_m: Option<Quantity>,
    /// Distance between the points on the hull, 2d, m (bifilar).
    pub spacing_m: Option<Quantity>,
    /// Distance between the points above, m; absent = spacing.
    pub top_spacing_m: Option<Quantity>,
    /// Bow-up angle, degrees.
    pub hull_pitch_deg: Option<Quantity>,
    /// Heel, starboard down, degrees.
    #[serde(default)]
    pub hull_roll_deg: Option<Quantity>,
    /// The two points of suspension in hull axes, m, where these are stated in place of a spacing.
    #[serde(default)]
    pub points_m: Option<Vec<[f64; 3]>>,
    /// How far forward along the deck the suspension points are of those of a level hanging, Δ, m.
    pub points_moved_m: Option<Quantity>,
    /// Compound: height l0 of the swing axis above the hull's suspension points, m.
    pub axis_height_m: Option<Quantity>,
}

/// Which end an incline weight hung from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
#[allow(missing_docs)]
pub enum End {
    Bow,
    Stern,
}

/// An incline test.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Incline {
    /// The end.
    pub end: End,
    /// The weight, kg.
    pub mass_kg: Quantity,
    /// Horizontal distance from the suspension points to the weight's, L_s, m.
    pub arm_m: Quantity,
    /// Depth of the weight's suspension point below the hull's, b_s, m.
    pub depth_m: Quantity,
    /// The angle.
    pub angle: InclineAngle,
}

/// Where an incline's angle comes from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum InclineAngle {
    /// Read off, degrees.
    Stated(Quantity),
    /// From a phone's gravity vector: file name in the session.
    Recording(String),
}
