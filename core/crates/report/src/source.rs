//! What a report is made from: plain data, so that any program can fill it in.

use gyradius_base::language::Language;
use gyradius_diagnosis::Criticism;
use gyradius_identification::Measurement;
use gyradius_recording::Quantity;

/// Everything in a report.
#[derive(Debug, Clone, Default)]
pub struct ReportSource {
    /// The language of the report; names of stated figures and channels come in it already.
    pub language: Language,
    /// The result.
    pub measurement: Measurement,
    /// What the simulation gets wrong, or why nothing can be said of it; absent where nobody asked.
    pub criticism: Option<Result<Criticism, String>>,
    /// The body that swung.
    pub body: BodyFacts,
    /// Dimensions and masses as stated.
    pub stated: Vec<StatedFigure>,
    /// How the first swing on two lines hung.
    pub rig: Option<RigFigureData>,
    /// Phone and recording program, as far as they are known.
    pub recorded_by: Vec<String>,
    /// What was recorded, thinned for pictures; found by the swing's id.
    pub recordings: Vec<RecordingFigureData>,
    /// Lists of periods with what they follow; found by the swing's id.
    pub periods: Vec<PeriodsFigureData>,
    /// When it was measured, as the operator writes it; the report leaves a blank where it is not
    /// given.
    pub measured_on: Option<String>,
    /// Program and version.
    pub generated_by: String,
}

impl ReportSource {
    /// The criticism, where there is one.
    pub fn criticised(&self) -> Option<&Criticism> {
        self.criticism.as_ref()?.as_ref().ok()
    }
}

/// The body as stated.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BodyFacts {
    /// Name.
    pub name: String,
    /// Everything that swung, kg.
    pub mass_kg: Option<Quantity>,
    /// Length overall, m.
    pub length_overall_m: Option<f64>,
}

/// A figure that somebody stated.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct StatedFigure {
    /// What it is, in words.
    pub what: String,
    /// Value and standard uncertainty.
    pub value: Quantity,
    /// Unit.
    pub unit: String,
    /// The swings it is stated for.
    pub applies_to: Vec<String>,
}

/// A hanging on two lines.
#[derive(Debug, Clone, PartialEq)]
pub struct RigFigureData {
    /// The swing's id.
    pub swing: String,
    /// Length of the lines, m.
    pub line_length_m: Quantity,
    /// Between the points on the body, m.
    pub spacing_m: Quantity,
    /// Between the points above, m; that on the body where it is not stated.
    pub top_spacing_m: Option<Quantity>,
}

/// A recording's curves.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RecordingFigureData {
    /// The swing's id.
    pub id: String,
    /// The channels shown: the strongest of each sensor.
    pub traces: Vec<Trace>,
    /// Amplitude spectrum of the strongest channel.
    pub spectrum: Option<SpectrumFigureData>,
}

/// A list of periods against time, s, with eq. (14).
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PeriodsFigureData {
    /// The swing's id.
    pub id: String,
    /// The periods, entries that are no single period left out.
    pub listed: Curve,
    /// Eq. (14).
    pub curve: Curve,
    /// The same without its modulation: T_0 (1 + b t).
    pub unmodulated: Curve,
    /// What the curve leaves of the periods.
    pub residual: Curve,
}

/// One channel with its fit.
#[derive(Debug, Clone, PartialEq, Default)]
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
    pub close_up: Option<[Curve; 2]>,
}

/// A spectrum with its lines named.
#[derive(Debug, Clone, PartialEq, Default)]
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
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Peak {
    /// Frequency, Hz.
    pub freq_hz: f64,
    /// Name of the mode.
    pub name: String,
}

/// Points joined by a line; a value that is not a number breaks the line.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Curve {
    /// Abscissas.
    pub x: Vec<f64>,
    /// Ordinates.
    pub y: Vec<f64>,
}

impl Curve {
    /// The points.
    pub fn points(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.x.iter().copied().zip(self.y.iter().copied())
    }

    /// A curve of points.
    pub fn of(points: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let (x, y) = points.into_iter().unzip();
        Self { x, y }
    }
}
