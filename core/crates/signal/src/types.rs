//! What goes into and comes out of the analysis of a record.

use num_complex::Complex64;
use serde::{Deserialize, Serialize};

use gyradius_base::message::Message;
use gyradius_base::message::warnings_and_said;

/// Channels that share one clock: a sensor's three axes, or a displacement.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ChannelGroup {
    /// Time stamps, s, strictly increasing; uneven is fine.
    pub t_s: Vec<f64>,
    /// Samples by channel, each as long as `t_s`.
    pub channels: Vec<Vec<f64>>,
}

/// What [`decompose`](super::decompose) may look for. The default leaves every decision to the
/// data.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct DecomposeOptions {
    /// Most modes to look for.
    pub max_modes: usize,
    /// Exactly so many modes, without order selection and without amplitude laws.
    pub mode_count: Option<usize>,
    /// Lowest and highest frequency of a mode, Hz; by default 1.5 cycles in the span (at least 0.02
    /// Hz) to 10 Hz (at most 0.45 of the sampling rate).
    pub band_hz: Option<(f64, f64)>,
}

impl Default for DecomposeOptions {
    fn default() -> Self {
        Self {
            max_modes: 8,
            mode_count: None,
            band_hz: None,
        }
    }
}

/// Amplitude spectrum of every channel, thinned for plots.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Spectrum {
    /// Frequencies, Hz.
    pub freq_hz: Vec<f64>,
    /// Amplitude of a sinusoid at each frequency, by channel, channel unit.
    pub amplitude: Vec<Vec<f64>>,
}

/// The damped oscillations found in a record, shared by all channels.
///
/// # Conventions
/// Channel c of the record is `baseline_c(t) + Re Σ_m shape[m][c] · z_m(t)`, where for the plain
/// damped mode `z_m(t) = exp((−α + iω)(t − t_ref))`. `t_ref_s` is the start of the analysed span.
/// Channels count through the groups in the order given. Modes are sorted by strength (largest
/// signal-to-noise first).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Decomposition {
    /// Reference time of amplitudes and phases, s.
    pub t_ref_s: f64,
    /// End of the analysed span, s.
    pub t_end_s: f64,
    /// Modes, strongest first.
    pub modes: Vec<FittedMode>,
    /// Lines explained by modes (harmonics, sums, differences), not modes of their own.
    pub tones: Vec<CombinationTone>,
    /// Noise standard deviation per sample of each channel (white level), channel unit.
    pub noise: Vec<f64>,
    /// Baseline of each channel as Legendre coefficients over `t_ref_s … t_end_s`, channel unit.
    pub baseline: Vec<Vec<f64>>,
    /// Mean level (baseline at mid-span) of each channel, channel unit: for the accelerometer,
    /// gravity.
    pub level: Vec<f64>,
    /// rms of the residual over the white noise level, all channels; 1 where the model is complete.
    pub rms_over_noise: f64,
    /// What a reader should know.
    #[serde(flatten, with = "warnings_and_said")]
    #[schemars(with = "warnings_and_said::WarningsAndSaid")]
    pub warnings: Vec<Message>,
}

/// One damped oscillation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct FittedMode {
    /// Angular frequency ω of the damped oscillation at the record's effective
    /// mean amplitude, rad/s.
    pub omega_rad_s: f64,
    /// Its standard error, misfit and colour of the noise included, rad/s.
    pub omega_se_rad_s: f64,
    /// Decay rate α (envelope exp(−αt)), 1/s.
    pub alpha_per_s: f64,
    /// Its standard error, 1/s.
    pub alpha_se_per_s: f64,
    /// Complex amplitude of each channel at `t_ref_s`, channel unit.
    #[schemars(with = "Vec<[f64; 2]>")]
    pub shape: Vec<Complex64>,
    /// Standard error of each of the real and imaginary parts, channel unit.
    pub shape_se: Vec<f64>,
    /// Signal-to-noise ratio: energy of the mode over the noise variance, summed over channels, as
    /// 10 log10.
    pub snr_db: f64,
    /// Dependence on amplitude where the data show one.
    pub law: AmplitudeLaw,
}

/// How frequency and decay of a mode depend on its own amplitude, relative to that at `t_ref_s`.
///
/// With E(t) the envelope, E(t_ref) = 1: `ω(t) = omega_small + shift · E^power`, `dE/dt = −E (alpha
/// + beta · E)`. All zero where the data show no dependence.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct AmplitudeLaw {
    /// Small-amplitude angular frequency, rad/s (equal to `omega_rad_s` where there is no
    /// dependence).
    pub omega_small_rad_s: f64,
    /// Its standard error, rad/s.
    pub omega_small_se_rad_s: f64,
    /// Small-amplitude decay rate, 1/s (equal to `alpha_per_s` where there is no dependence).
    pub alpha_small_per_s: f64,
    /// Power of the envelope that the frequency follows: 2 for smooth restoring forces (a
    /// pendulum), 1 where the data prefer it (dry friction, slack); 0 where there is no dependence.
    pub power: u8,
    /// Frequency shift at the amplitude of `t_ref_s`, rad/s.
    pub shift_rad_s: f64,
    /// Its standard error, rad/s.
    pub shift_se_rad_s: f64,
    /// Quadratic damping at the amplitude of `t_ref_s`, 1/s.
    pub beta_per_s: f64,
    /// Its standard error, 1/s.
    pub beta_se_per_s: f64,
}

impl FittedMode {
    /// Period 2π/ω at the record's mean amplitude, s.
    pub fn period_s(&self) -> f64 {
        std::f64::consts::TAU / self.omega_rad_s
    }

    /// Standard error of the period, s.
    pub fn period_se_s(&self) -> f64 {
        self.period_s() * self.omega_se_rad_s / self.omega_rad_s
    }

    /// Undamped angular frequency √(ω² + α²), rad/s (errata, damping).
    pub fn undamped_omega_rad_s(&self) -> f64 {
        self.omega_rad_s.hypot(self.alpha_per_s)
    }
}

/// A line at a whole-number combination of mode frequencies.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct CombinationTone {
    /// Multiples of each mode's frequency, in the order of `Decomposition::modes`.
    pub multiples: Vec<i32>,
    /// Complex amplitude of each channel at `t_ref_s`.
    #[schemars(with = "Vec<[f64; 2]>")]
    pub shape: Vec<Complex64>,
}
