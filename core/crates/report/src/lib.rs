//! The result as a document: one self-contained HTML file, and its pictures for other layouts.
//!
//! # Conventions
//! The file loads nothing: style and pictures are in it, the numbers too, as JSON in the elements
//! `gyradius-measurement` and, where the simulation was criticised, `gyradius-critique`. Text from
//! outside is escaped wherever it lands. There is no clock: a date is what the operator wrote, or a
//! blank. Numbers carry as many digits as two digits of their standard uncertainty allow.

mod chart;
mod digits;
mod gather;
mod headline;
mod markup;
mod page;
mod pictures;
mod scale;
mod sections;
mod source;
mod table;
mod thin;
mod words;

pub use page::{figures, html};
pub use pictures::Figure;
pub use source::{
    BodyFacts, Curve, Peak, PeriodsFigureData, RecordingFigureData, ReportSource, RigFigureData,
    SpectrumFigureData, StatedFigure, Trace,
};
pub use thin::{MOST_POINTS, thinned};
