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
    let contents = Contents::of(file.as_ref())?;
    let Some(origin_ns) = contents.origin_ns else {
        return Err(Error::no_result(
            file.as_ref().display().to_string(),
            "the recorder's file holds no samples",
        ));
    };
    let table = format!("{name}.csv");
    let sensors: Vec<(Stream, &str)> = COLUMNS
        .into_iter()
        .filter(|(stream, _)| contents.holds[stream.index()])
        .collect();
    write_table(
        file.as_ref(),
        &folder.as_ref().join(&table),
        origin_ns,
        &sensors,
    )?;
    let bias = contents.holds[Stream::GyroscopeBias.index()].then(|| format!("{name}-bias.csv"));
    if let Some(bias) = &bias {
        write_table(
            file.as_ref(),
            &folder.as_ref().join(bias),
            origin_ns,
            &[BIAS_COLUMNS],
        )?;
    }
    Ok(contents.recorded(table, bias, origin_ns))
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

    fn recorded(self, file: String, bias: Option<String>, origin_ns: i64) -> Recorded {
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
            file,
            origin_ns,
            phone: self.header.phone,
            bias,
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

/// One CSV table of some of the streams; replaced by renaming, so that nobody sees half of it.
fn write_table(file: &Path, path: &Path, origin_ns: i64, columns: &[(Stream, &str)]) -> Result<()> {
    let doing = format!("converting `{}`", file.display());
    let fail = |error: std::io::Error| Error::unwritable(path.display(), &doing, &error);
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(fail)?;
    }
    let mut out = BufWriter::new(Partial::create(path).map_err(fail)?);
    let mut rows: String = std::iter::once("t")
        .chain(columns.iter().map(|column| column.1))
        .collect::<Vec<_>>()
        .join(",");
    rows.push('\n');
    let mut merge = Merge::new(origin_ns, columns.len());
    let mut reader = Reader::open(file)?;
    while let Some(piece) = reader.next_piece()? {
        let Piece::Samples(samples) = piece else {
            continue;
        };
        let Some(group) = columns.iter().position(|column| column.0 == samples.stream) else {
            continue;
        };
        merge.push(group, &samples, &mut rows);
        out.write_all(rows.as_bytes()).map_err(fail)?;
        rows.clear();
    }
    merge.finish(&mut rows);
    out.write_all(rows.as_bytes()).map_err(fail)?;
    let partial = out.into_inner().map_err(|error| fail(error.into_error()))?;
    partial.take_place().map_err(fail)
}
