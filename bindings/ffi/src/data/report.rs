//! Plain data of the module `report`: pictures, their curves already thinned.

use gyradius_core::report::{Curve, Figure, Peak, RecordingFigureData, SpectrumFigureData, Trace};

/// Points joined by a line; a value that is not a number breaks the line.
#[uniffi::remote(Record)]
pub struct Curve {
    /// Abscissas.
    pub x: Vec<f64>,
    /// Ordinates, as many.
    pub y: Vec<f64>,
}

/// Two curves of a close-up.
#[derive(Debug, Clone, PartialEq, uniffi::Record)]
pub struct CloseUp {
    /// As measured.
    pub measured: Curve,
    /// The fit.
    pub model: Curve,
}

/// A close-up of the core.
pub type CurvePair = [Curve; 2];
uniffi::custom_type!(CurvePair, CloseUp, {
    remote,
    lower: |pair| { let [measured, model] = pair; CloseUp { measured, model } },
    try_lift: |shown| Ok([shown.measured, shown.model]),
});

/// A recording's curves.
#[uniffi::remote(Record)]
pub struct RecordingFigureData {
    /// The swing's id.
    pub id: String,
    /// The channels shown: the strongest of each sensor.
    pub traces: Vec<Trace>,
    /// Amplitude spectrum of the strongest channel.
    pub spectrum: Option<SpectrumFigureData>,
}

/// One channel with its fit, against time in s.
#[uniffi::remote(Record)]
pub struct Trace {
    /// What the channel is.
    pub label: String,
    /// Its unit.
    pub unit: String,
    /// As measured.
    pub measured: Curve,
    /// The fit.
    pub model: Curve,
    /// What the fit leaves.
    pub residual: Curve,
    /// White noise of one sample, unit of the channel.
    pub noise: Option<f64>,
    /// A few cycles, every sample: measured and fit.
    pub close_up: Option<CurvePair>,
}

/// A spectrum with its lines named.
#[uniffi::remote(Record)]
pub struct SpectrumFigureData {
    /// What the channel is.
    pub label: String,
    /// Its unit.
    pub unit: String,
    /// Amplitude of a sinusoid (y) at each frequency (x, Hz).
    pub amplitude: Curve,
    /// The same of the residual.
    pub residual: Option<Curve>,
    /// The modes.
    pub peaks: Vec<Peak>,
}

/// A named line of a spectrum.
#[uniffi::remote(Record)]
pub struct Peak {
    /// Frequency, Hz.
    pub freq_hz: f64,
    /// Name of the mode.
    pub name: String,
}

/// A picture of the report with what is said below it.
pub type ReportFigure = Figure;

/// A picture of the report with what is said below it.
#[uniffi::remote(Record)]
pub struct ReportFigure {
    /// Unique in the report; letters, digits and hyphens.
    pub id: String,
    /// What is shown.
    pub title: String,
    /// How to read it.
    pub caption: String,
    /// The picture, a whole SVG.
    pub svg: String,
}
