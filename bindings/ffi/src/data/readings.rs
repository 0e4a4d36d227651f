//! Plain data of the module `procedure`: what sensors and recordings say.

use gyradius_core::online::{GapList, SwingState};
use gyradius_core::procedure::{
    Against, InclineReading, Judgement, Moving, Recommend, RecordingView, Rest, RestView,
    SensorRest, Tilt,
};

use super::live::LiveEstimate;
use super::sentence::Sentence;
use super::{Count, Vector3};

/// A tilt, and what it is against.
#[uniffi::remote(Record)]
pub struct Tilt {
    /// What the angles are against.
    pub against: TiltAgainst,
    /// Angle between gravity now and gravity there, degrees; absent where there is nothing to be
    /// against.
    pub angle_deg: Option<f64>,
    /// Bow up, degrees; known only where the phone lies flat with its top edge to the bow.
    pub bow_up_deg: Option<f64>,
    /// Starboard side down, degrees; known only where the phone lies so.
    pub starboard_down_deg: Option<f64>,
}

/// What a tilt is against.
pub type TiltAgainst = Against;

/// What a tilt is against.
#[uniffi::remote(Enum)]
pub enum TiltAgainst {
    /// The phone's own plane, which lies flat on the hull.
    PhonePlane,
    /// The reading at which the operator said that the hull was level.
    Reference,
    /// Nothing yet.
    Nothing,
}

/// The rest while it is taken.
#[uniffi::remote(Record)]
pub struct RestView {
    /// So long everything has been still, s.
    pub still_s: f64,
    /// So long it must be, s.
    pub wanted_s: f64,
    /// How the hull moved when it last did.
    pub moving: Option<Moving>,
    /// What was found, once it was still for long enough.
    pub found: Option<RestReading>,
}

/// How a hull moved.
#[uniffi::remote(Record)]
pub struct Moving {
    /// Largest rate against the mean over the last seconds, degrees per s.
    pub rate_deg_s: f64,
    /// Largest turn of gravity against the mean over the last seconds, degrees.
    pub tilt_deg: f64,
}

/// The sensors at rest.
pub type RestReading = Rest;

/// The sensors at rest.
#[uniffi::remote(Record)]
pub struct RestReading {
    /// Length of the still part, s.
    pub still_s: f64,
    /// Gyroscope, rad/s; its mean is the bias.
    pub gyroscope: SensorRest,
    /// Accelerometer, m/s².
    pub accelerometer: Option<SensorRest>,
    /// Size of the accelerometer's mean, m/s².
    pub gravity_m_s2: Option<f64>,
}

/// One sensor at rest.
#[uniffi::remote(Record)]
pub struct SensorRest {
    /// Samples.
    pub samples: Count,
    /// Real rate by its own stamps, gaps left out, Hz.
    pub rate_hz: f64,
    /// Intervals of more than one and a half usual ones.
    pub gaps: Count,
    /// Mean by axis, unit of the sensor, phone axes.
    pub mean: Vector3,
    /// Standard deviation of a sample by axis.
    pub noise: Vector3,
}

/// The recording while it runs, or as far as it goes.
#[uniffi::remote(Record)]
pub struct RecordingView {
    /// File inside the procedure's folder.
    pub file: String,
    /// So much was recorded, s.
    pub recorded_s: f64,
    /// So long the hull has been swinging freely, s; absent before the release.
    pub swinging_s: Option<f64>,
    /// The recording ends by itself after so much more, s; absent before the release.
    pub left_s: Option<f64>,
    /// Amplitude of the latest half swing, degrees.
    pub amplitude_deg: Option<f64>,
    /// Amplitude after the release, degrees.
    pub released_deg: Option<f64>,
    /// What the planned amplitude is, degrees.
    pub wanted_deg: Option<f64>,
    /// Stillness of an incline, s.
    pub still_s: Option<f64>,
    /// The live estimate; absent for inclines and interrupted recordings.
    pub live: Option<LiveEstimate>,
    /// What to know or do, most urgent first.
    pub advice: Vec<Sentence>,
}

/// What is to be thought of a recording.
#[uniffi::remote(Record)]
pub struct Judgement {
    /// What the operator is advised to do; it is theirs to decide.
    pub recommend: Recommend,
    /// Why it should be repeated, the gravest first; empty where it is good.
    pub reasons: Vec<Sentence>,
    /// What else to know.
    pub notes: Vec<Sentence>,
    /// So much was recorded, s.
    pub recorded_s: f64,
    /// The free swing that says most of the period.
    pub swing: Option<SwingState>,
    /// Amplitude after the release, degrees.
    pub released_deg: Option<f64>,
    /// The tilt of an incline.
    pub incline: Option<InclineReading>,
    /// Every gap of a swing's recording.
    pub gaps: GapList,
}

/// Advice for the end of a recording.
#[uniffi::remote(Enum)]
pub enum Recommend {
    /// It is good.
    Accept,
    /// It should be made again.
    Repeat,
}

/// The tilt that a weight makes.
#[uniffi::remote(Record)]
pub struct InclineReading {
    /// Angle between gravity at rest and with the weight, degrees.
    pub angle_deg: f64,
    /// Its standard uncertainty, degrees.
    pub u_deg: f64,
}
