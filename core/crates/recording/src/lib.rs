//! Sessions and recordings: reading, writing, importing, repairs.
//!
//! May know `error`, `constants`, `frames`. Knows nothing of what is done with the data.

mod assembled;
mod csv;
mod csv_write;
mod domain;
pub mod import;
mod instruments;
mod keys;
mod load;
mod member_path;
mod named_file;
mod names;
mod quantity;
mod recorded;
pub mod recorder;
mod repair;
mod replace;
mod same_hanging;
mod samples;
mod save;
mod session;
mod store;
mod suspension;
mod toml_read;
mod toml_recorded;
mod toml_swing;
mod toml_write;
mod unzip;

pub use csv::{read_channel, read_period_list, read_recording, read_track};
pub use csv_write::write_recording;
pub use load::{LoadedData, LoadedSession, LoadedSwing, SESSION_FILE, load_session, load_store};
pub use quantity::Quantity;
pub use recorded::{DISTURBED, Recorded, RecordedEvent, RecordedRepair, RecordedSensor};
pub use repair::{
    CUT_STEPS, MISSING_INTERVALS, RUN_SAMPLES, RUNS, STATED_RANGE, median_interval_s,
};
pub use same_hanging::HungAs;
pub use samples::{
    Channel, ChannelQuantity, GateEvents, PartialTriad, PeriodList, Recording, Repair, RepairKind,
    Sensor, SensorChannels, SingleChannel, Track, Triad,
};
pub use save::{
    Overwrite, save_session, save_session_with, save_session_zip, session_zip_bytes, write_files,
};
pub use session::{
    AddedMass, Attachment, Body, End, Excitation, Incline, InclineAngle, Instrument,
    InstrumentKind, ModeName, Orientation, Session, Site, Suspension, SuspensionKind, Swing,
    SwingData,
};
pub use store::Store;
pub use toml_read::read_session;
pub use toml_write::{write_session, write_session_to_fill_in, write_swings_to_fill_in};

pub use domain::Domain;
pub use keys::{AssumedU, Table};
pub use load::utf8;
pub use replace::replace_file;
pub use toml_read::{ParsedSession, ROOT, parse_session, session, with_root};
pub use toml_swing::SWING;
