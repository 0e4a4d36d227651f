//! Plain data of the module `recording`: what is stated of a session, what its recordings needed.

use super::{Count, Vector3};

use gyradius_core::recording::{
    AddedMass, Attachment, Body, End, Excitation, ModeName, Orientation, Overwrite, Quantity,
    Repair, RepairKind, Sensor, Site, Suspension, SuspensionKind,
};

/// A value and its standard uncertainty in the same unit (GUM: `u`, one sigma; 0 = stated as
/// exact).
#[uniffi::remote(Record)]
pub struct Quantity {
    /// The value.
    pub value: f64,
    /// Its standard uncertainty, 0 or more.
    pub u: f64,
}

/// What happens to files that are already there.
#[uniffi::remote(Enum)]
pub enum Overwrite {
    /// They stay, and writing is an error before anything is written.
    Refuse,
    /// They are replaced.
    Replace,
}

/// Which sensor.
#[uniffi::remote(Enum)]
pub enum Sensor {
    /// Rotation rate, rad/s.
    Gyroscope,
    /// Specific force, m/s² (at rest, screen up: z = +g).
    Accelerometer,
    /// Acceleration with gravity already taken out by the phone, m/s².
    LinearAccelerometer,
    /// A rangefinder's displacement, m.
    Displacement,
    /// A stopwatch or photogate: times and periods, s.
    Timer,
}

/// The body as stated. Kotlin and Swift call it so because a view of SwiftUI has a `Body` too.
pub type HullBody = Body;

/// The body as stated.
#[uniffi::remote(Record)]
pub struct HullBody {
    /// Name, free text.
    pub name: String,
    /// Everything that swings, added masses of single swings excluded, kg.
    pub mass_kg: Option<Quantity>,
    /// Length overall, m.
    pub length_overall_m: Option<f64>,
    /// Mean density, kg/m³; switches the buoyancy correction on.
    pub density_kg_m3: Option<f64>,
}

/// The place.
#[uniffi::remote(Record)]
pub struct Site {
    /// Free-fall acceleration as stated, m/s².
    pub gravity_m_s2: Option<Quantity>,
    /// Latitude, degrees; gravity is computed from it and the altitude where it is not stated.
    pub latitude_deg: Option<f64>,
    /// Altitude above the ellipsoid, m.
    pub altitude_m: Option<f64>,
    /// Air density, kg/m³.
    pub air_density_kg_m3: Option<f64>,
}

/// A body that rides on the hull and is taken off the result.
#[uniffi::remote(Record)]
pub struct Attachment {
    /// Name, free text.
    pub name: String,
    /// Mass, kg.
    pub mass_kg: Quantity,
    /// Centre of mass, hull axes, from the mid-point of the suspension points, m.
    pub position_m: Vector3,
    /// Standard uncertainty of each of its coordinates, m.
    pub position_u_m: f64,
    /// Gyradii about its own centre and hull axes, m (0 for a point).
    pub gyradii_m: Vector3,
}

/// A mass added for one swing.
#[uniffi::remote(Record)]
pub struct AddedMass {
    /// Mass, kg.
    pub mass_kg: Quantity,
    /// Position, hull axes, from the mid-point of the suspension points, m.
    pub position_m: Vector3,
}

/// What an operator can mean to excite.
#[uniffi::remote(Enum)]
pub enum Excitation {
    /// A turn about the vertical.
    Yaw,
    /// A shift athwartships.
    Sway,
    /// A shift fore and aft.
    Surge,
    /// A turn about the athwartships axis.
    Pitch,
    /// A turn about the fore-and-aft axis.
    Roll,
}

/// The names of the modes of motion, by shape.
#[uniffi::remote(Enum)]
pub enum ModeName {
    /// A turn about the vertical.
    Yaw,
    /// A simple pendulum along the line that joins the suspension points.
    Sway,
    /// The long-period mode of the double pendulum in pitch.
    PitchInPhase,
    /// The short-period mode of the double pendulum in pitch.
    PitchOutOfPhase,
    /// The long-period mode of the double pendulum in roll.
    RollInPhase,
    /// The short-period mode of the double pendulum in roll.
    RollOutOfPhase,
    /// A turn about a fixed horizontal axis.
    Compound,
    /// Anything else.
    Other,
}

/// Which suspension.
#[uniffi::remote(Enum)]
pub enum SuspensionKind {
    /// Two lines.
    Bifilar,
    /// Two inverted Vs: a fixed horizontal axis.
    Compound,
    /// Three lines on a circle about the vertical axis.
    Trifilar,
    /// Nothing is stated.
    Free,
}

/// The direction that joins the suspension points (bifilar) or of the swing axis (compound).
#[uniffi::remote(Enum)]
pub enum Orientation {
    /// From side to side.
    Athwartships,
    /// From bow to stern.
    ForeAndAft,
}

/// How the body hung, as stated.
#[uniffi::remote(Record)]
pub struct Suspension {
    /// Bifilar or compound.
    pub kind: SuspensionKind,
    /// Direction of the line through the suspension points.
    pub orientation: Orientation,
    /// Length of the lines, m (bifilar).
    pub line_length_m: Option<Quantity>,
    /// Distance between the points on the hull, m (bifilar).
    pub spacing_m: Option<Quantity>,
    /// Distance between the points above, m; absent = spacing.
    pub top_spacing_m: Option<Quantity>,
    /// Bow-up angle, degrees.
    pub hull_pitch_deg: Option<Quantity>,
    /// Heel, starboard down, degrees.
    pub hull_roll_deg: Option<Quantity>,
    /// The two points of suspension in hull axes, m, where these are stated in place of a spacing.
    pub points_m: Option<Vec<Vector3>>,
    /// How far forward along the deck the suspension points are of those of a level hanging, m.
    pub points_moved_m: Option<Quantity>,
    /// Compound: height of the swing axis above the hull's suspension points, m.
    pub axis_height_m: Option<Quantity>,
}

/// Which end of the hull.
#[uniffi::remote(Enum)]
pub enum End {
    /// Forward.
    Bow,
    /// Aft.
    Stern,
}

/// The kinds of damage a recording can have.
#[uniffi::remote(Enum)]
pub enum RepairKind {
    /// Time stamps scatter about their rate: used as they stand.
    Jitter,
    /// A time stamp repeats the one before: the row is dropped for that sensor.
    RepeatedStamp,
    /// A time stamp steps back: the row is dropped for that sensor.
    BackwardStamp,
    /// Rows are missing (gap of 1.5 to 10 intervals): left as a gap.
    MissingRows,
    /// The record stood still (gap over 10 intervals): left as a gap.
    Stall,
    /// Cells that are not numbers: the row is dropped for that sensor.
    NotANumber,
    /// Samples at the sensor's limit: dropped for that sensor.
    Saturation,
    /// A pause, put back from the system clock.
    Pause,
    /// Parts that the recorder's file had lost before it became this recording.
    LostByRecorder,
    /// A second swing: only the longest is used.
    SecondSwing,
    /// Different samples share a stamp: spread evenly from one stamp to the next.
    SharedStamps,
    /// The clock steps ahead: what lies beyond is dropped.
    StampStep,
    /// A sensor with a clock of its own: dropped.
    OtherClock,
    /// Columns, files or sensors of an export that the import did not use.
    NotImported,
    /// What a recorder writes where it has no reading: dropped for that sensor.
    NoReading,
}

/// One kind of damage of one sensor: how often, where, what was done.
#[uniffi::remote(Record)]
pub struct Repair {
    /// Kind.
    pub kind: RepairKind,
    /// Sensor.
    pub sensor: Sensor,
    /// How many samples or gaps.
    pub count: Count,
    /// Time of the first, s.
    pub first_s: f64,
    /// Time of the last, s.
    pub last_s: f64,
    /// A sentence for the report.
    pub text: String,
}
