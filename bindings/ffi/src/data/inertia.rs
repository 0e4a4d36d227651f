//! Plain data of the module `inertia`: the result of a measurement.

use gyradius_core::identification::{
    AmplitudePoint, BudgetLine, Claim, Finding, Measurement, ModeResult, ModulationResult,
    MotionResult, QuantityResult, Route, SwingResult, TrendResult, Value, Verdict,
};
use gyradius_core::recording::{ModeName, Repair};

use super::names::{
    AmplitudeUnitName, DecisionName, InputName, KindOfFinding, MethodName, QuantityKey,
    RelationSign, RouteName, SeverityName, SubjectName,
};
use super::sentence::Sentence;
use super::{BudgetsByName, Count, Ends, NumbersByName, QuantitiesByName, RoutesByName};

/// What a quantity's value or uncertainty is.
#[derive(Debug, Clone, PartialEq, uniffi::Enum)]
pub enum QuantityValue {
    /// A number.
    Scalar {
        /// The number.
        value: f64,
    },
    /// Three numbers, e.g. principal gyradii.
    Vector {
        /// The numbers.
        values: Vec<f64>,
    },
    /// Three by three numbers, by rows: the inertia tensor, hull axes.
    Matrix {
        /// The rows.
        rows: Vec<Vec<f64>>,
    },
    /// Not known.
    Absent,
}

uniffi::custom_type!(Value, QuantityValue, {
    remote,
    lower: |value| value.into(),
    try_lift: |value| value.core(),
});

impl From<Value> for QuantityValue {
    fn from(value: Value) -> Self {
        match value {
            other if !other.is_finite() => Self::Absent,
            Value::Scalar(value) => Self::Scalar { value },
            Value::Vector(values) => Self::Vector {
                values: values.to_vec(),
            },
            Value::Matrix(rows) => Self::Matrix {
                rows: rows.iter().map(|row| row.to_vec()).collect(),
            },
        }
    }
}

impl QuantityValue {
    /// The core's value; a vector or matrix of another size than 3 is an error.
    fn core(self) -> uniffi::Result<Value> {
        let three = |values: Vec<f64>| <[f64; 3]>::try_from(values.as_slice());
        Ok(match self {
            Self::Scalar { value } => Value::Scalar(value),
            Self::Vector { values } => Value::Vector(three(values)?),
            Self::Matrix { rows } => {
                let rows: Vec<[f64; 3]> = rows.into_iter().map(three).collect::<Result<_, _>>()?;
                Value::Matrix(rows.as_slice().try_into()?)
            }
            Self::Absent => Value::Scalar(f64::NAN),
        })
    }
}

/// A correlation between two quantities.
#[derive(Debug, Clone, PartialEq, uniffi::Record)]
pub struct Correlation {
    /// One quantity.
    pub one: String,
    /// The other.
    pub other: String,
    /// Their coefficient of correlation, −1 to 1.
    pub r: f64,
}

/// A correlation of the core.
pub type CorrelationTuple = (QuantityKey, QuantityKey, f64);
uniffi::custom_type!(CorrelationTuple, Correlation, {
    remote,
    lower: |tuple| Correlation { one: tuple.0.to_string(), other: tuple.1.to_string(), r: tuple.2 },
    try_lift: |of| Ok((of.one.parse()?, of.other.parse()?, of.r)),
});

/// The result of a session. Foundation has a `Measurement` of its own.
pub type InertiaResult = Measurement;

/// A session's or a bare recording's result.
#[uniffi::remote(Record)]
pub struct InertiaResult {
    /// `gyradius-measurement/1`.
    pub format: String,
    /// The session's title, or the recording's name.
    pub title: String,
    /// Every swing, in session order.
    pub swings: Vec<SwingResult>,
    /// The joint estimate, by quantity.
    pub quantities: QuantitiesByName,
    /// Single routes to each quantity, beside the joint estimate.
    pub alternatives: RoutesByName,
    /// Contributions of each input to each quantity, largest first.
    pub budget: BudgetsByName,
    /// Correlations between the scalar quantities.
    pub correlations: Vec<CorrelationTuple>,
    /// Every stated dimension against what the swings imply, every route against every other.
    pub consistency: Vec<Claim>,
    /// Verdicts against class limits, where asked for.
    pub verdicts: Vec<Verdict>,
    /// What is not plausible in the session, and what its data cannot hold.
    pub findings: Vec<Finding>,
    /// What a reader must know.
    pub warnings: Vec<Sentence>,
}

/// Something that is not plausible, or that the data cannot hold; `warnings` tell it too.
#[uniffi::remote(Record)]
pub struct Finding {
    /// What kind.
    pub kind: KindOfFinding,
    /// What it does to the result.
    pub severity: SeverityName,
    /// Of which swing; none of the session.
    pub swing: Option<String>,
    /// Of which channel or dimension, where it is one.
    pub channel: Option<String>,
    /// The numbers behind it, SI.
    pub numbers: NumbersByName,
    /// What was found.
    pub message: Sentence,
    /// What to do.
    pub advice: Sentence,
}

/// One swing's modes.
#[uniffi::remote(Record)]
pub struct SwingResult {
    /// The swing's id.
    pub id: String,
    /// Start and end of the part analysed, s.
    pub span_s: Option<Ends>,
    /// Modes, strongest first.
    pub modes: Vec<ModeResult>,
    /// Repairs of the recording.
    pub repairs: Vec<Repair>,
    /// What a reader must know of this swing.
    pub warnings: Vec<Sentence>,
    /// Residual over noise: 1 where the fit explains everything.
    pub rms_over_noise: Option<f64>,
    /// What a list of periods follows, eq. (14).
    pub trend: Option<TrendResult>,
    /// The swing as one motion about a fixed axis, where it was fitted as one.
    pub motion: Option<MotionResult>,
    /// Whether the simulation of the hull was fitted to the samples; else damped oscillations were.
    pub simulated: bool,
}

/// A swing as one motion: θ'' = −ω² f(θ) − 2 α θ' − b |θ'| θ' − c sgn θ', with f(θ) = θ + κ (sin θ −
/// θ).
#[uniffi::remote(Record)]
pub struct MotionResult {
    /// κ: 0 of a spring, 1 of a pendulum, below 0 where the restoring torque hardens.
    pub hardness: f64,
    /// Its standard error.
    pub hardness_se: f64,
    /// α, 1/s.
    pub damping_per_s: f64,
    /// Its standard error; none where it stands at zero, below which it cannot be.
    pub damping_per_s_se: Option<f64>,
    /// b, 1/rad.
    pub drag_per_rad: f64,
    /// Its standard error; none where it stands at zero, below which it cannot be.
    pub drag_per_rad_se: Option<f64>,
    /// c, rad/s².
    pub friction_rad_s2: f64,
    /// Its standard error; none where it stands at zero, below which it cannot be.
    pub friction_rad_s2_se: Option<f64>,
}

/// A list of periods against time, eq. (14): T(t) = T_0 (1 + b t) + C exp(−t/τ_m) sin(2π t/T_m +
/// φ_m), t from the first entry.
#[uniffi::remote(Record)]
pub struct TrendResult {
    /// T_0, s.
    pub t0_s: f64,
    /// Its standard error, s.
    pub t0_se_s: f64,
    /// b, 1/s; 0 where none is seen.
    pub b_per_s: f64,
    /// Its standard error, 1/s.
    pub b_se_per_s: f64,
    /// The modulation by a second motion, where there is one.
    pub modulation: Option<ModulationResult>,
    /// Scatter of the periods about the curve, s.
    pub scatter_s: f64,
}

/// The modulation of eq. (14).
#[uniffi::remote(Record)]
pub struct ModulationResult {
    /// C, s.
    pub c_s: f64,
    /// Its standard error, s.
    pub c_se_s: f64,
    /// T_m, s: the beat of the two motions.
    pub t_m_s: f64,
    /// Its standard error, s.
    pub t_m_se_s: f64,
    /// τ_m, s; absent where no decay is seen.
    pub tau_m_s: Option<f64>,
    /// φ_m, rad.
    pub phase_rad: f64,
}

/// One mode of one swing.
#[uniffi::remote(Record)]
pub struct ModeResult {
    /// Name by shape.
    pub mode: ModeName,
    /// Small-amplitude period, s.
    pub period_s: f64,
    /// Its standard error, s.
    pub period_se_s: f64,
    /// Period as observed at the record's mean amplitude, s.
    pub period_observed_s: f64,
    /// Decay time of the amplitude, s; absent where none was measured.
    pub decay_time_s: Option<f64>,
    /// Its standard error, s.
    pub decay_time_se_s: Option<f64>,
    /// Amplitude at the start of the span.
    pub amplitude: Option<f64>,
    /// `rad`, `m`, or `rad/s` where only the rate is known.
    pub amplitude_unit: AmplitudeUnitName,
    /// Phase at the start of the span, rad: the motion is amplitude · cos(ωt + phase).
    pub phase_rad: Option<f64>,
    /// Energy relative to the strongest mode of the swing, dB.
    pub relative_db: f64,
    /// True where the operator did not mean to excite it.
    pub parasitic: bool,
    /// True for a weak mode of a record that the fit does not describe.
    pub doubtful: bool,
    /// Period and decay against amplitude, by window.
    pub against_amplitude: Vec<AmplitudePoint>,
}

/// Period and decay at one amplitude.
#[uniffi::remote(Record)]
pub struct AmplitudePoint {
    /// Middle of the window, s.
    pub t_s: f64,
    /// Amplitude there, unit of the mode.
    pub amplitude: f64,
    /// Period there, s.
    pub period_s: f64,
    /// Its standard error, s.
    pub period_se_s: f64,
    /// Relative loss of amplitude per cycle (logarithmic decrement).
    pub decrement: f64,
    /// Its standard error.
    pub decrement_se: f64,
}

/// A quantity with its uncertainty.
#[uniffi::remote(Record)]
pub struct QuantityResult {
    /// Value: a number, a vector or a matrix.
    pub value: Value,
    /// One standard uncertainty, same shape.
    pub u: Value,
    /// 95 % interval of a number.
    pub interval_95: Option<Ends>,
    /// How it was got.
    pub method: MethodName,
}

/// A single route to a quantity.
#[uniffi::remote(Record)]
pub struct Route {
    /// `yaw_period`, `period_ratio`, `beat_count`, `double_pendulum` …
    pub method: RouteName,
    /// Value.
    pub value: f64,
    /// One standard uncertainty.
    pub u: f64,
    /// 95 % interval.
    pub interval_95: Ends,
    /// The paper's equations.
    pub equation: String,
    /// The swings or inclines it used.
    pub from: Vec<String>,
}

/// One line of an uncertainty budget.
#[uniffi::remote(Record)]
pub struct BudgetLine {
    /// The input.
    pub input: InputName,
    /// |sensitivity| × u(input), unit of the quantity.
    pub u_contribution: f64,
}

/// One comparison of the consistency tests.
#[uniffi::remote(Record)]
pub struct Claim {
    /// What is claimed: a stated dimension, or a route such as `k_yaw_m`.
    pub claim: SubjectName,
    /// As stated, or by the first route.
    pub stated: f64,
    /// Its standard uncertainty.
    pub stated_u: f64,
    /// As the rest of the session implies.
    pub implied: f64,
    /// Its standard uncertainty.
    pub implied_u: f64,
    /// |difference| over its standard uncertainty.
    pub sigma: f64,
    /// What implies it.
    pub from: String,
    /// True above the threshold at which the report speaks up.
    pub flagged: bool,
    /// A sentence for the report.
    pub message: Sentence,
    /// Routes: how many pairs of swings stand behind this one, which differs most.
    pub pairs: Count,
    /// Routes: the smallest and the largest difference among those pairs, standard uncertainties.
    pub sigma_range: Option<Ends>,
}

/// A guard-banded verdict against a class limit (JCGM 106).
#[uniffi::remote(Record)]
pub struct Verdict {
    /// The quantity.
    pub quantity: QuantityKey,
    /// `>=` or `<=`.
    pub relation: RelationSign,
    /// The limit.
    pub limit: f64,
    /// Guard band, in the unit of the quantity.
    pub guard_band: f64,
    /// Probability that the true value conforms.
    pub conformance_probability: f64,
    /// `pass`, `fail` or `undecided`.
    pub verdict: DecisionName,
}
