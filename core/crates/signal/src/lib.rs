//! Periods, decays and amplitudes from samples.
//!
//! May know `recording` and what that may know. Knows nothing of hulls.

mod amplitude;
mod basis;
mod beat;
mod compress;
mod crossings;
mod curve_fit;
mod decompose;
mod evaluate;
mod fit;
mod floor;
mod gates;
mod modulation;
mod motion;
mod noise;
pub mod online;
mod order;
mod period_list;
mod prediction;
mod proposals;
mod record;
mod search;
mod small_amplitude;
mod spectrum;
mod trim;
mod types;
mod uncertainty;
mod words;

pub use amplitude::{Pole, WindowPoint, WindowedMode, against_amplitude};
pub use beat::{BeatCount, beat_count};
pub use crossings::{
    Crossing, CrossingPeriod, PeriodSeries, crossing_periods, period_from_crossings, zero_crossings,
};
pub use decompose::{decompose, decompose_heavily_damped};
pub use evaluate::{model, residuals};
pub use gates::{GatePeriods, gate_periods};
pub use modulation::{Modulation, PeriodTrend, fit_period_trend};
pub use noise::white_level;
pub use period_list::{FlaggedPeriod, ListedPeriod, period_from_list};
pub use small_amplitude::{PeriodLaw, SmallAmplitude, small_amplitude_limit};
pub use spectrum::spectrum;
pub use trim::{FreeSpan, SpanNote, SpanNoteKind, free_swing_span, undisturbed_span};
pub use types::{
    AmplitudeLaw, ChannelGroup, CombinationTone, DecomposeOptions, Decomposition, FittedMode,
    Spectrum,
};
pub use uncertainty::mean_square_amplitude;
