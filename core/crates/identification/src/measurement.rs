//! The result of a session: what `measure --json` writes (`gyradius-measurement/1`).
//!
//! Fields that the contract names are spelled as there; what is added is additional keys only.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use gyradius_base::message::Message;
use gyradius_base::message::text_and_said;
use gyradius_base::message::warnings_and_said;
use gyradius_recording::{ModeName, Repair};

use super::findings::Finding;
use super::names::{
    AmplitudeUnit, Decision, Input, Method, QuantityName, Relation, RouteMethod, Subject,
};
use super::one_motion::OneMotion;
use super::value::Value;
use gyradius_signal::{PeriodTrend, mean_square_amplitude};

/// A session's or a bare recording's result.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Measurement {
    /// `gyradius-measurement/1`.
    pub format: String,
    /// The session's title, or the recording's name.
    pub title: String,
    /// Every swing, in session order.
    pub swings: Vec<SwingResult>,
    /// The joint estimate, by quantity.
    pub quantities: BTreeMap<QuantityName, QuantityResult>,
    /// Single routes to each quantity, beside the joint estimate.
    pub alternatives: BTreeMap<QuantityName, Vec<Route>>,
    /// Contributions of each input to each quantity, largest first.
    pub budget: BTreeMap<QuantityName, Vec<BudgetLine>>,
    /// Correlations between the scalar quantities: `[name, name, r]`.
    pub correlations: Vec<(QuantityName, QuantityName, f64)>,
    /// Every stated dimension against what the swings imply, every route against every other.
    pub consistency: Vec<Claim>,
    /// Verdicts against class limits, where asked for.
    pub verdicts: Vec<Verdict>,
    /// What is not plausible in the session, and what its data cannot hold.
    #[serde(default)]
    pub findings: Vec<Finding>,
    /// What a reader must know.
    #[serde(flatten, with = "warnings_and_said")]
    #[schemars(with = "warnings_and_said::WarningsAndSaid")]
    pub warnings: Vec<Message>,
}

impl Measurement {
    /// One thing more that a reader must know.
    pub(super) fn warn(&mut self, message: Message) {
        self.warnings.push(message);
    }

    /// A finding, which a reader must know unless it is only noted.
    pub(super) fn find(&mut self, finding: Finding) {
        self.warnings.extend(finding.told());
        self.findings.push(finding);
    }

    /// Takes a quantity out, and what is made of it.
    pub(super) fn take_out(&mut self, name: &QuantityName) {
        let made_of_it = [QuantityName::PrincipalGyradii, QuantityName::Inertia];
        let also = match name {
            QuantityName::KYaw | QuantityName::KPitch | QuantityName::KRoll => &made_of_it[..],
            _ => &[],
        };
        let moment = name.moment();
        for gone in also.iter().chain([name]).chain(&moment) {
            self.quantities.remove(gone);
            self.budget.remove(gone);
        }
        self.correlations.retain(|(a, b, _)| a != name && b != name);
    }
}

/// One swing's modes.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct SwingResult {
    /// The swing's id.
    pub id: String,
    /// Start and end of the part analysed, s.
    pub span_s: Option<[f64; 2]>,
    /// Modes, strongest first.
    pub modes: Vec<ModeResult>,
    /// Repairs of the recording.
    pub repairs: Vec<Repair>,
    /// What a reader must know of this swing.
    #[serde(flatten, with = "warnings_and_said")]
    #[schemars(with = "warnings_and_said::WarningsAndSaid")]
    pub warnings: Vec<Message>,
    /// Residual over noise: 1 where the fit explains everything.
    pub rms_over_noise: Option<f64>,
    /// What a list of periods follows, eq. (14).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub trend: Option<TrendResult>,
    /// The swing as one motion about a fixed axis, where it was fitted as one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub motion: Option<MotionResult>,
    /// Whether the simulation of the hull was fitted to the samples; else damped oscillations were.
    #[serde(default)]
    pub simulated: bool,
}

impl SwingResult {
    /// How long the part was that was analysed, s; 0 of a swing that was not recorded.
    pub(super) fn duration_s(&self) -> f64 {
        self.span_s.map_or(0.0, |[start, end]| end - start)
    }

    /// With what a reader must know of it.
    pub(super) fn warned(self, warnings: Vec<Message>) -> Self {
        Self { warnings, ..self }
    }
}

impl ModeResult {
    /// The mean square of its amplitude that its period answers to, over that at the start, where so
    /// much was recorded, s.
    pub(super) fn mean_square(&self, duration_s: f64) -> f64 {
        let decays = self.decay_time_s.map_or(0.0, |tau| duration_s / tau);
        mean_square_amplitude(decays)
    }
}

/// A list of periods against time, eq. (14) with the amplitude that its print lost: T(t) = T_0 (1 +
/// b t) + C exp(−t/τ_m) sin(2π t/T_m + φ_m), t from the first entry.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
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
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
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

impl From<&PeriodTrend> for TrendResult {
    fn from(trend: &PeriodTrend) -> Self {
        let modulation = trend.modulation.as_ref().map(|m| ModulationResult {
            c_s: m.c_s,
            c_se_s: m.c_se_s,
            t_m_s: m.t_m_s,
            t_m_se_s: m.t_m_se_s,
            tau_m_s: Some(m.tau_m_s()).filter(|tau| tau.is_finite()),
            phase_rad: m.phase_rad,
        });
        Self {
            t0_s: trend.t0_s,
            t0_se_s: trend.t0_se_s,
            b_per_s: trend.b_per_s,
            b_se_per_s: trend.b_se_per_s,
            modulation,
            scatter_s: trend.scatter_s,
        }
    }
}

/// A swing as one motion: θ'' = −ω² f(θ) − 2 α θ' − b |θ'| θ' − c sgn θ', with f(θ) = θ + κ (sin θ −
/// θ).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
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

impl From<&OneMotion> for MotionResult {
    fn from(motion: &OneMotion) -> Self {
        Self {
            hardness: motion.hardness.value,
            hardness_se: motion.hardness.u,
            damping_per_s: motion.damping_per_s.0,
            damping_per_s_se: motion.damping_per_s.1,
            drag_per_rad: motion.drag_per_rad.0,
            drag_per_rad_se: motion.drag_per_rad.1,
            friction_rad_s2: motion.friction_rad_s2.0,
            friction_rad_s2_se: motion.friction_rad_s2.1,
        }
    }
}

/// One mode of one swing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct ModeResult {
    /// Name by shape.
    pub mode: ModeName,
    /// Small-amplitude period, s; with a session's dimensions it is freed of damping too.
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
    /// `rad` (angle of the body or of the lines), `m`, or `rad/s` where only the rate is known.
    pub amplitude_unit: AmplitudeUnit,
    /// Phase at the start of the span, rad: the motion is amplitude · cos(ωt + phase).
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub phase_rad: Option<f64>,
    /// Energy of the mode relative to the strongest of the swing, dB (0 for the strongest).
    pub relative_db: f64,
    /// True where the operator did not mean to excite it.
    pub parasitic: bool,
    /// True for a weak mode of a record that the fit does not describe: it may be part of the
    /// misfit.
    #[serde(default)]
    pub doubtful: bool,
    /// Period and decay against amplitude, by window.
    pub against_amplitude: Vec<AmplitudePoint>,
}

/// Period and decay at one amplitude.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
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
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct QuantityResult {
    /// Value.
    pub value: Value,
    /// One standard uncertainty, same shape.
    pub u: Value,
    /// 95 % interval of a scalar.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub interval_95: Option<[f64; 2]>,
    /// How it was got.
    pub method: Method,
}

/// A single route to a quantity.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Route {
    /// The closed-form estimator.
    pub method: RouteMethod,
    /// Value.
    pub value: f64,
    /// One standard uncertainty.
    pub u: f64,
    /// 95 % interval.
    pub interval_95: [f64; 2],
    /// The paper's equations.
    pub equation: String,
    /// The swings or inclines it used.
    pub from: Vec<String>,
}

/// One line of an uncertainty budget.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct BudgetLine {
    /// The input.
    pub input: Input,
    /// |sensitivity| × u(input), unit of the quantity.
    pub u_contribution: f64,
}

/// One comparison of the consistency tests.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Claim {
    /// What is claimed: a stated figure such as `line_length`, or a route such as `k_yaw_m`.
    pub claim: Subject,
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
    #[serde(flatten, with = "text_and_said")]
    #[schemars(with = "text_and_said::TextAndSaid")]
    pub message: Message,
    /// Routes: how many pairs of swings stand behind this one, which differs most.
    #[serde(skip_serializing_if = "is_one", default = "one")]
    pub pairs: usize,
    /// Routes: the smallest and the largest difference among those pairs, standard uncertainties.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub sigma_range: Option<[f64; 2]>,
}

/// A guard-banded verdict against a class limit (JCGM 106).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Verdict {
    /// The quantity.
    pub quantity: QuantityName,
    /// `>=` or `<=`.
    pub relation: Relation,
    /// The limit.
    pub limit: f64,
    /// Guard band, in the unit of the quantity.
    pub guard_band: f64,
    /// Probability that the true value conforms.
    pub conformance_probability: f64,
    /// `pass`, `fail` or `undecided`.
    pub verdict: Decision,
}

fn one() -> usize {
    1
}

fn is_one(count: &usize) -> bool {
    *count == 1
}
