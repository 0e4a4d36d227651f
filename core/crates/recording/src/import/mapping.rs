//! Any table, its columns and units named by the caller.

use std::collections::BTreeMap;

use super::columns::{
    Clock, SensorColumns, add_repair, assemble, columns_not_used, from_first_stamp, gravity_doubt,
};
use super::file_not_used;
use super::imported::{Format, ImportedData, ImportedRecording};
use super::phyphox::Pauses;
use super::source::{Source, stem};
use super::table::{Table, Tag};
use super::tagged::column_of_tag;
use super::units::{Dimension, Unit};
use crate::assembled::{channel, track};
use crate::repair::RawSeries;
use crate::samples::{ChannelQuantity, Sensor};
use gyradius_base::{Error, Result};

/// Which column of a foreign table is which of the project's, and in which unit.
///
/// # Conventions
/// Keys are those of the project's recordings: `t`; `gx,gy,gz`; `ax,ay,az` (specific force);
/// `lx,ly,lz` (gravity taken out); `y` (a rangefinder's track); `angle` and `rate` (about the axis
/// of the motion). `tg`, `ta` and `tl` are clocks of one sensor alone. A column is named as the
/// header names it or by `#` and its number, from 1; `x@Gyro` is the column `x` of the file, or of
/// the rows tagged, `Gyro`. `t=row:100Hz`, or `t=frame:100/s`, counts the rows. Separator, decimal mark and the line of
/// the header are found by themselves.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ColumnMapping {
    /// Foreign column by the project's name.
    pub columns: BTreeMap<String, MappedColumn>,
}

/// A foreign column.
#[derive(Debug, Clone, PartialEq)]
pub struct MappedColumn {
    /// Name in the file's header.
    pub name: String,
    /// Its unit.
    pub unit: Unit,
}

impl ColumnMapping {
    /// A mapping from entries such as `t=Time:ms`, `gx=xGyro:deg/s`, `az=Acc Z:-g`.
    pub fn from_entries<S: AsRef<str>>(entries: impl IntoIterator<Item = S>) -> Result<Self> {
        let mut columns = BTreeMap::new();
        for entry in entries {
            let entry = entry.as_ref();
            let bad = || Error::argument("mapping", "entries such as gx=xGyro:deg/s", entry);
            let (key, rest) = entry.split_once('=').ok_or_else(bad)?;
            let (name, unit) = rest.rsplit_once(':').ok_or_else(bad)?;
            let column = MappedColumn {
                name: name.trim().to_owned(),
                unit: unit.trim().parse()?,
            };
            let fits = fits(key.trim(), column.unit.quantity);
            if !fits.ok_or_else(|| unknown_key(key.trim()))? {
                return Err(Error::argument(
                    "mapping",
                    format!("a unit that fits `{}`", key.trim()),
                    entry,
                ));
            }
            if columns.insert(key.trim().to_owned(), column).is_some() {
                let expected = format!("one column for `{}`", key.trim());
                return Err(Error::argument("mapping", expected, entry));
            }
        }
        Ok(Self { columns })
    }
}

fn unknown_key(key: &str) -> Error {
    Error::argument(
        "mapping",
        "one of t, gx, gy, gz, ax, ay, az, lx, ly, lz, y, angle, rate, tg, ta, tl",
        key,
    )
}

/// True where a unit fits a field.
fn fits(key: &str, unit: Dimension) -> Option<bool> {
    Some(match key {
        "t" | "tg" | "ta" | "tl" => matches!(unit, Dimension::Time | Dimension::Clock),
        "gx" | "gy" | "gz" | "rate" => unit == Dimension::AngularRate,
        "ax" | "ay" | "az" | "lx" | "ly" | "lz" => unit == Dimension::Acceleration,
        "y" => unit == Dimension::Length,
        "angle" => unit == Dimension::Angle,
        _ => return None,
    })
}

/// What a mapping asks for: a sensor, its fields, and the field of a clock of its own.
#[derive(Clone, Copy)]
struct Wanted {
    sensor: Sensor,
    kind: Kind,
    fields: &'static [&'static str],
    clock: &'static str,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Triad,
    Track,
    Channel(ChannelQuantity),
}

const fn channel_of(
    sensor: Sensor,
    quantity: ChannelQuantity,
    field: &'static [&'static str],
) -> Wanted {
    Wanted {
        sensor,
        kind: Kind::Channel(quantity),
        fields: field,
        clock: "t",
    }
}

const fn triad_of(sensor: Sensor, fields: &'static [&'static str], clock: &'static str) -> Wanted {
    Wanted {
        sensor,
        kind: Kind::Triad,
        fields,
        clock,
    }
}

const TRIADS: [Wanted; 3] = [
    triad_of(Sensor::Gyroscope, &["gx", "gy", "gz"], "tg"),
    triad_of(Sensor::Accelerometer, &["ax", "ay", "az"], "ta"),
    triad_of(Sensor::LinearAccelerometer, &["lx", "ly", "lz"], "tl"),
];
const TRACK: Wanted = Wanted {
    sensor: Sensor::Displacement,
    kind: Kind::Track,
    fields: &["y"],
    clock: "t",
};
const ANGLE: Wanted = channel_of(Sensor::Displacement, ChannelQuantity::Angle, &["angle"]);
const RATE: Wanted = channel_of(Sensor::Gyroscope, ChannelQuantity::Rate, &["rate"]);
impl ColumnMapping {
    fn wanted(&self) -> Result<Vec<Wanted>> {
        let has = |key: &str| self.columns.contains_key(key);
        let samples: Vec<&String> = self
            .columns
            .keys()
            .filter(|key| !key.starts_with('t'))
            .collect();
        let alone = [TRACK, ANGLE, RATE]
            .into_iter()
            .find(|wanted| has(wanted.fields[0]));
        if let Some(wanted) = alone {
            return match samples.len() {
                1 => Ok(vec![wanted]),
                _ => Err(Error::argument(
                    "mapping",
                    format!("`{}` and no other samples beside it", wanted.fields[0]),
                    samples
                        .iter()
                        .map(|key| key.as_str())
                        .collect::<Vec<_>>()
                        .join(", "),
                )),
            };
        }
        let triads = TRIADS
            .into_iter()
            .filter(|wanted| wanted.fields.iter().any(|key| has(key)));
        let triads: Vec<Wanted> = triads.collect();
        if triads.is_empty() {
            return Err(Error::argument(
                "mapping",
                "an entry for samples, such as gx, ax, angle or y",
                "none",
            ));
        }
        Ok(triads)
    }

    fn column(&self, key: &str) -> Result<&MappedColumn> {
        let column = self
            .columns
            .get(key)
            .ok_or_else(|| Error::argument("mapping", format!("an entry for `{key}`"), "none"))?;
        if fits(key, column.unit.quantity) == Some(true) {
            return Ok(column);
        }
        Err(Error::argument(
            "mapping",
            format!("a unit that fits `{key}`"),
            &column.name,
        ))
    }

    /// The columns of a sensor in a table; what is missing is an error.
    fn place(&self, table: &Table, wanted: Wanted) -> Result<SensorColumns> {
        let mut tag = None;
        let mut axes = Vec::new();
        let mut directions = Vec::new();
        let mut factors = Vec::new();
        let stated = wanted.fields.iter().enumerate();
        for (axis, key) in stated.filter(|(_, key)| self.columns.contains_key(**key)) {
            let mapped = self.column(key)?;
            let place = find(table, mapped)?;
            axes.push(place.0);
            directions.push(axis);
            factors.push(mapped.unit.factor);
            if axes.len() > 1 && tag != place.1 {
                return Err(Error::argument(
                    "mapping",
                    format!(
                        "rows of one tag for all axes of the {}; rows of another are another sensor's",
                        wanted.sensor.name()
                    ),
                    format!("`{}`", mapped.name),
                ));
            }
            tag = place.1;
        }
        let own = self.columns.contains_key(wanted.clock);
        let mapped = self.column(if own { wanted.clock } else { "t" })?;
        let is_rate = mapped.unit.quantity == Dimension::Time;
        // A column of that name numbers the frames itself.
        let counts = matches!(mapped.name.as_str(), "" | "row" | "frame")
            && table.find(|column| column == mapped.name).is_none();
        let clock = if counts && is_rate {
            Clock::Rows {
                rate_hz: 1.0 / mapped.unit.factor,
            }
        } else {
            let column = find(table, mapped)?.0;
            match mapped.unit.quantity {
                Dimension::Clock => Clock::Text { column },
                _ => Clock::Number {
                    column,
                    factor: mapped.unit.factor,
                },
            }
        };
        Ok(SensorColumns {
            sensor: wanted.sensor,
            clock,
            axes,
            directions,
            factors,
            tag,
        })
    }
}

/// A column by its name, or by `#` and its number. What stands after an `@` names the file or the
/// tag of the rows.
fn find(table: &Table, mapped: &MappedColumn) -> Result<(usize, Option<Tag>)> {
    let by_name = |name: &str| {
        let number = name
            .strip_prefix('#')
            .and_then(|number| number.parse::<usize>().ok());
        table.find(|column| column == name).or_else(|| {
            number?
                .checked_sub(1)
                .filter(|column| *column < table.header().len())
        })
    };
    if let Some(column) = by_name(&mapped.name) {
        return Ok((column, None));
    }
    let missing = |what: &str| {
        let (expected, found) = (
            format!("a column `{what}`"),
            format!("`{}`", table.header_text()),
        );
        table.malformed(Some(0), &expected, &found)
    };
    let (name, of) = mapped
        .name
        .rsplit_once('@')
        .ok_or_else(|| missing(&mapped.name))?;
    let column = by_name(name).ok_or_else(|| missing(name))?;
    // A column of tags says what a row is; the file's name does so only where there is none.
    let names_file = stem(table.file())
        .to_lowercase()
        .contains(&of.to_lowercase());
    match column_of_tag(table, of, names_file)? {
        Some(place) => {
            let text = of.to_owned();
            Ok((
                column,
                Some(Tag {
                    column: place,
                    text,
                }),
            ))
        }
        None if names_file => Ok((column, None)),
        None => Err(table.malformed(
            None,
            &format!("`{of}`, part of the file's name or a cell of its rows"),
            "neither",
        )),
    }
}

/// A table and what it has of the mapping.
struct Holding<'a> {
    table: Table<'a>,
    columns: Vec<Option<SensorColumns>>,
}

/// Reads the tables of a source by a mapping: each that has all of its columns is a recording of
/// its own; otherwise each sensor is taken from the one table that has its columns. A mean
/// acceleration that contradicts its unit is an error that names the likely one.
pub(super) fn import(source: &Source, mapping: &ColumnMapping) -> Result<Vec<ImportedRecording>> {
    let wanted = mapping.wanted()?;
    let mut holdings: Vec<Holding> = Vec::new();
    let mut not_used: Vec<String> = source
        .ignored
        .iter()
        .map(|name| file_not_used(name))
        .collect();
    // Of the table with the most columns, which is the one that the mapping is likely to mean.
    let mut worst: Option<(usize, Error)> = None;
    let mut failed = |columns: usize, error: Error| {
        if worst.as_ref().is_none_or(|(most, _)| columns > *most) {
            worst = Some((columns, error));
        }
    };
    let mut pauses = Pauses::default();
    for (name, bytes) in source.members() {
        if let Some(found) = Pauses::of_file(bytes, name)? {
            pauses = found;
            continue;
        }
        let table = match Table::open(bytes, name) {
            Ok(table) => table,
            Err(error) => {
                failed(0, error);
                not_used.push(file_not_used(name));
                continue;
            }
        };
        let mut columns = Vec::new();
        for one in &wanted {
            match mapping.place(&table, *one) {
                Ok(placed) => columns.push(Some(placed)),
                Err(error) => {
                    failed(table.header().len(), error);
                    columns.push(None);
                }
            }
        }
        if columns.iter().all(Option::is_none) {
            not_used.push(file_not_used(name));
        } else {
            holdings.push(Holding { table, columns });
        }
    }
    let complete = |holding: &Holding| holding.columns.iter().all(Option::is_some);
    let mut recordings = Vec::new();
    if holdings.iter().any(complete) {
        for holding in holdings {
            if complete(&holding) {
                recordings.push(read(holding.table.file(), &wanted, &[&holding], &pauses)?);
            } else {
                not_used.push(file_not_used(holding.table.file()));
            }
        }
    } else {
        for (i, one) in wanted.iter().enumerate() {
            let having: Vec<&str> = holdings
                .iter()
                .filter(|holding| holding.columns[i].is_some())
                .map(|holding| holding.table.file())
                .collect();
            match having[..] {
                [_] => {}
                [] => {
                    let error = Error::argument("mapping", "columns of the file", "none of them");
                    return Err(worst.map_or(error, |(_, worst)| worst));
                }
                [a, b, ..] => {
                    return Err(Error::argument(
                        "mapping",
                        format!(
                            "`{}` with the file's name after its column, as in `{}=x@gyro:rad/s`",
                            one.fields[0], one.fields[0]
                        ),
                        format!("its columns in `{a}` and in `{b}`"),
                    ));
                }
            }
        }
        let name = match (&source.archive, holdings.first()) {
            (None, Some(first)) => first.table.file(),
            _ => source.name.as_str(),
        };
        recordings.push(read(
            name,
            &wanted,
            &holdings.iter().collect::<Vec<_>>(),
            &pauses,
        )?);
    }
    if let Some(last) = recordings.last_mut() {
        last.not_used.extend(not_used);
    }
    Ok(recordings)
}

/// Reads one table by a mapping that it has all columns of.
pub(super) fn import_table(table: Table, mapping: &ColumnMapping) -> Result<ImportedRecording> {
    let wanted = mapping.wanted()?;
    let columns = wanted
        .iter()
        .map(|one| mapping.place(&table, *one).map(Some));
    let columns = columns.collect::<Result<Vec<_>>>()?;
    let file = table.file();
    let holding = Holding { table, columns };
    read(file, &wanted, &[&holding], &Pauses::default())
}

fn read(
    name: &str,
    wanted: &[Wanted],
    holdings: &[&Holding],
    pauses: &Pauses,
) -> Result<ImportedRecording> {
    let mut series = Vec::new();
    let mut left = Vec::new();
    for (place, holding) in holdings.iter().enumerate() {
        for columns in holding.columns.iter().flatten() {
            let mut raw = columns.read(&holding.table)?;
            refuse_empty(&raw, columns, &holding.table)?;
            raw.t_s.iter_mut().for_each(|t| *t = pauses.wall_s(*t));
            series.push((place, raw));
        }
        let used = holding
            .columns
            .iter()
            .flatten()
            .flat_map(|columns| columns.used());
        left.extend(columns_not_used(&holding.table, used));
    }
    let kind = wanted.first().map_or(Kind::Triad, |one| one.kind);
    let data = match (kind, series.pop()) {
        (Kind::Track, Some((_, raw))) => ImportedData::Track(track(name, since_first(raw))?),
        (Kind::Channel(quantity), Some((_, raw))) => {
            ImportedData::Channel(channel(name, since_first(raw), quantity)?)
        }
        (_, last) => {
            series.extend(last);
            let mut recording = assemble(name, series)?;
            if let Some(repair) = pauses.repair() {
                add_repair(&mut recording, &repair);
            }
            if let (Some(doubt), Some(holding)) = (gravity_doubt(&recording), holdings.first()) {
                let expected = "accelerations in the stated unit";
                return Err(holding.table.malformed(None, expected, &doubt));
            }
            ImportedData::Recording(recording)
        }
    };
    let imported = ImportedRecording::of(name, Format::Mapped, data, Vec::new());
    Ok(imported.without(left))
}

/// Columns that the caller named hold samples, or the mapping is a mistake.
fn refuse_empty(raw: &RawSeries, columns: &SensorColumns, table: &Table) -> Result<()> {
    let is_empty = |direction: &usize| !raw.has_samples() || !raw.axes.contains(direction);
    let empty = columns.directions.iter().zip(&columns.axes);
    let empty = empty.filter(|(direction, _)| is_empty(direction));
    let names: Vec<String> = empty
        .map(|(_, column)| format!("`{}`", table.name_of(*column)))
        .collect();
    if names.is_empty() {
        return Ok(());
    }
    let expected = format!("samples in {} (or a mapping without it)", names.join(", "));
    Err(table.malformed(None, &expected, "none"))
}

fn since_first(raw: RawSeries) -> RawSeries {
    let mut one = [raw];
    from_first_stamp(&mut one);
    let [raw] = one;
    raw
}
