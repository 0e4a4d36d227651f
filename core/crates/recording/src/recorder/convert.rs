//! A recorder's file as the recordings of a session.

use std::fs;
use std::io::{BufWriter, Write};
use std::path::Path;

use super::damage::Damage;
use super::merge::{Merge, seconds};
use super::reader::Reader;
use super::types::{Event, Header, Piece, Stream};
use crate::replace::Partial;
use crate::{Recorded, RecordedEvent, RecordedRepair, RecordedSensor};
use gyradius_base::error::{Error, Result};

/// Writes a recorder's file as `<name>.csv` into the folder of a session, and beside it
/// `<name>-bias.csv` where the phone gave its estimate of the gyroscope's bias. Gives what the
/// session says of it, repairs included.
///
/// Every stamp and every value reads back to the same bits. Reads the file twice, in constant
/// memory. Fails with [`Error::NoResult`] where no sample is left, with [`Error::Unreadable`],
/// [`Error::Malformed`] and [`Error::Unwritable`] as reading and writing do; files that are there
/// already are replaced in one step.
pub fn convert(file: impl AsRef<Path>, folder: impl AsRef<Path>, name: &str) -> Result<Recorded> {
    let file = file.as_ref();
    let (contents, origin_ns) = held(file)?;
    for table in contents.tables(name) {
        write_table(file, &folder.as_ref().join(&table.name), origin_ns, &table)?;
    }
    Ok(contents.recorded(name, origin_ns))
}

/// The same without writing: what the session says of the file, and its tables by name and bytes.
pub fn converted(file: impl AsRef<Path>, name: &str) -> Result<(Recorded, NamedTables)> {
    let file = file.as_ref();
    let (contents, origin_ns) = held(file)?;
    let mut tables = Vec::new();
    for table in contents.tables(name) {
        let mut bytes = Vec::new();
        let fail = |error: std::io::Error| Error::unwritable(&table.name, "", &error);
        write_rows(file, &mut bytes, origin_ns, &table, &fail)?;
        tables.push((table.name, bytes));
    }
    Ok((contents.recorded(name, origin_ns), tables))
}

/// Tables by name and bytes.
pub type NamedTables = Vec<(String, Vec<u8>)>;

/// All of a file but its samples, and the stamp of the first.
fn held(file: &Path) -> Result<(Contents, i64)> {
    let contents = Contents::of(file)?;
    match contents.origin_ns {
        Some(origin_ns) => Ok((contents, origin_ns)),
        None => Err(Error::no_result(
            file.display().to_string(),
            "the recorder's file holds no samples",
        )),
    }
}

/// A table to be written: its file's name, and the streams with the names of their columns.
struct Columns {
    name: String,
    streams: Vec<(Stream, &'static str)>,
}

/// The streams of a recording with the names of their columns.
const COLUMNS: [(Stream, &str); 2] = [
    (Stream::Gyroscope, "gx,gy,gz"),
    (Stream::Accelerometer, "ax,ay,az"),
];
const BIAS_COLUMNS: (Stream, &str) = (Stream::GyroscopeBias, "gx,gy,gz");

/// All of a file but its samples.
#[derive(Default)]
struct Contents {
    header: Header,
    origin_ns: Option<i64>,
    /// Whether there are samples, by stream.
    holds: [bool; 3],
    events: Vec<Event>,
    damage: Vec<Damage>,
}

impl Contents {
    fn of(file: &Path) -> Result<Self> {
        let mut reader = Reader::open(file)?;
        let mut contents = Self::default();
        while let Some(piece) = reader.next_piece()? {
            match piece {
                Piece::Header(header) => contents.header = header,
                Piece::Event(event) => contents.events.push(event),
                Piece::Samples(samples) => {
                    contents.holds[samples.stream.index()] |= !samples.stamps_ns.is_empty();
                    if samples.stream != Stream::GyroscopeBias {
                        contents.origin_ns =
                            contents.origin_ns.or(samples.stamps_ns.first().copied());
                    }
                }
                Piece::Resumed { .. } => {}
            }
        }
        contents.damage = reader.damage().to_vec();
        Ok(contents)
    }

    /// The tables that the file becomes.
    fn tables(&self, name: &str) -> Vec<Columns> {
        let streams = COLUMNS
            .into_iter()
            .filter(|(stream, _)| self.holds[stream.index()]);
        let samples = Columns {
            name: table_name(name),
            streams: streams.collect(),
        };
        let bias = self.bias_name(name).map(|name| Columns {
            name,
            streams: vec![BIAS_COLUMNS],
        });
        std::iter::once(samples).chain(bias).collect()
    }

    fn bias_name(&self, name: &str) -> Option<String> {
        self.holds[Stream::GyroscopeBias.index()].then(|| format!("{name}-bias.csv"))
    }

    fn recorded(self, name: &str, origin_ns: i64) -> Recorded {
        let since = |stamp_ns: i64| seconds(stamp_ns, origin_ns);
        let sensor = |info: super::types::SensorInfo| RecordedSensor {
            stream: info.stream.name().to_owned(),
            name: info.name,
            full_scale: info.full_scale,
        };
        let repair = |damage: &Damage| RecordedRepair {
            from_s: damage.after_ns.map(since),
            to_s: damage.before_ns.map(since),
            text: damage.text(),
            ..RecordedRepair::default()
        };
        Recorded {
            file: table_name(name),
            bias: self.bias_name(name),
            origin_ns,
            measured_on: String::new(),
            phone: self.header.phone,
            logger: String::new(),
            sensors: self.header.sensors.into_iter().map(sensor).collect(),
            notes: self.header.notes,
            events: self
                .events
                .into_iter()
                .map(|event| RecordedEvent {
                    t_s: since(event.stamp_ns),
                    key: event.key,
                })
                .collect(),
            repairs: self.damage.iter().map(repair).collect(),
        }
    }
}

fn table_name(name: &str) -> String {
    format!("{name}.csv")
}

/// One CSV table of some of the streams; replaced by renaming, so that nobody sees half of it.
fn write_table(file: &Path, path: &Path, origin_ns: i64, table: &Columns) -> Result<()> {
    let doing = format!("converting `{}`", file.display());
    let fail = |error: std::io::Error| Error::unwritable(path.display(), &doing, &error);
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(fail)?;
    }
    let mut out = BufWriter::new(Partial::create(path).map_err(fail)?);
    write_rows(file, &mut out, origin_ns, table, &fail)?;
    let partial = out.into_inner().map_err(|error| fail(error.into_error()))?;
    partial.take_place().map_err(fail)
}

/// Header and rows of a table, in constant memory.
fn write_rows(
    file: &Path,
    out: &mut impl Write,
    origin_ns: i64,
    table: &Columns,
    fail: &impl Fn(std::io::Error) -> Error,
) -> Result<()> {
    let mut rows: String = std::iter::once("t")
        .chain(table.streams.iter().map(|column| column.1))
        .collect::<Vec<_>>()
        .join(",");
    rows.push('\n');
    let mut merge = Merge::new(origin_ns, table.streams.len());
    let mut reader = Reader::open(file)?;
    while let Some(piece) = reader.next_piece()? {
        let Piece::Samples(samples) = piece else {
            continue;
        };
        let of_table = |column: &(Stream, &str)| column.0 == samples.stream;
        let Some(group) = table.streams.iter().position(of_table) else {
            continue;
        };
        merge.push(group, &samples, &mut rows);
        out.write_all(rows.as_bytes()).map_err(fail)?;
        rows.clear();
    }
    merge.finish(&mut rows);
    out.write_all(rows.as_bytes()).map_err(fail)
}
