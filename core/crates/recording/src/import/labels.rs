//! What the columns of a table are, by the words and the units of its header.
//!
//! Read are `Gyroscope x (rad/s)`, `Angular velocity x (rad/s)`, `Gyr X (°/s)`, `S1_Gyro_X_CAL` with
//! `deg/s` below it, and their like. What a header only suggests goes into a proposal.

use super::clock::seconds_of_text;
use super::columns::{Clock, SensorColumns};
use super::run_label::without_run;
use super::source;
use super::table::Table;
use super::tagged::{TAG, tagged, tags_of};
use super::units::{Dimension, Unit, unit_of_header};
use crate::samples::Sensor;

const TIME: &[&str] = &[
    "time",
    "t",
    "timestamp",
    "stamp",
    "elapsed",
    "seconds",
    "epoc",
    "epoch",
    "clock",
    "datetime",
    "millis",
    "ms",
    "us",
    "ns",
    "micros",
];
pub(super) const GYROSCOPE: &[&str] = &["gyroscope", "gyro", "gyr", "rotation", "angular", "omega"];
pub(super) const ACCELEROMETER: &[&str] = &["acceleration", "accelerometer", "accel", "acc"];
pub(super) const FREE: &[&str] = &["linear", "user", "without"];
const DEGREES: &[&str] = &["deg", "degree", "degrees", "dps"];
/// What numbers the rows, and is no time without a rate.
const COUNTS: &[&str] = &[
    "frame", "frames", "row", "index", "sample", "samples", "counter",
];
const RATE: &[&str] = &["rate", "velocity", "speed", "omega"];
const DISPLACEMENT: &[&str] = &["displacement", "position", "distance", "deflection"];
const ANGLE: &[&str] = &["angle", "theta", "phi", "position"];

/// A header cell taken apart: `Linear Acceleration x (m/s^2)`.
pub(super) struct Label {
    words: Vec<String>,
    pub axis: Option<usize>,
    unit: Option<Unit>,
    /// Whether its brackets hold something that is no known unit.
    is_unknown: bool,
}

impl Label {
    pub(super) fn of(table: &Table, column: usize) -> Self {
        let cell = without_run(&table.name_of(column));
        let (name, bracket) = match cell.rsplit_once(['(', '[']) {
            Some((name, rest)) => (name, rest.trim().trim_end_matches([')', ']'])),
            None => (cell.as_str(), ""),
        };
        // `m/(s^2)` has brackets of its own.
        let outer = cell.split_once(['(', '[']).map_or("", |(_, rest)| rest);
        let unit = unit_of_header(bracket)
            .or_else(|| unit_of_header(outer))
            .or_else(|| table.unit(column).and_then(unit_of_header));
        let mut words = words(name);
        let index = ["0", "1", "2"].iter().position(|index| *index == bracket);
        let axis = words
            .iter()
            .rev()
            .find_map(|word| axis_of_word(word))
            .or_else(|| index.filter(|_| cell.ends_with(']')));
        words.retain(|word| axis_of_word(word).is_none() && word != "axis");
        let is_unknown = unit.is_none() && index.is_none() && !bracket.is_empty();
        Self {
            words,
            axis,
            unit,
            is_unknown,
        }
    }

    fn has(&self, any: &[&str]) -> bool {
        self.words.iter().any(|word| any.contains(&word.as_str()))
    }

    /// The field of a mapping that one channel is, by a word and a unit that fit each other.
    pub(super) fn channel(&self) -> Option<(&'static str, Unit)> {
        let unit = self.unit?;
        let is_bare = self.words.is_empty() && self.axis.is_some();
        let field = match unit.quantity {
            Dimension::Angle if self.has(ANGLE) => "angle",
            Dimension::Length if is_bare || self.has(DISPLACEMENT) => "y",
            Dimension::AngularRate if self.axis.is_none() && self.has(RATE) => "rate",
            _ => return None,
        };
        Some((field, unit))
    }

    pub(super) fn time_factor(&self) -> Option<f64> {
        let unit = self.unit.filter(|unit| unit.quantity == Dimension::Time)?;
        self.has(TIME).then_some(unit.factor)
    }

    /// The sensor this is an axis of; some headers name the axis alone, and the file names the
    /// sensor.
    fn sensor(&self, set: &str) -> Option<Sensor> {
        let free = self.has(FREE) || names_free(set);
        let set = set.to_lowercase();
        let named = self.has(ACCELEROMETER);
        match self.unit?.quantity {
            Dimension::AngularRate if self.has(GYROSCOPE) || self.words.is_empty() => {
                Some(Sensor::Gyroscope)
            }
            Dimension::Acceleration if self.has(&["angular", "gravity"]) => None,
            Dimension::Acceleration
                if named || self.words.is_empty() && (free || set.contains("accel")) =>
            {
                Some(if free {
                    Sensor::LinearAccelerometer
                } else {
                    Sensor::Accelerometer
                })
            }
            _ => None,
        }
    }

    /// The field of a mapping that the words alone suggest.
    fn field(&self) -> Option<String> {
        let axis = self.axis.map(|axis| ["x", "y", "z"][axis]);
        let joined = self.words.join("");
        let gyroscope = self.has(GYROSCOPE) || joined == "g" || joined == "w";
        let accelerometer = self.has(ACCELEROMETER)
            || joined == "a"
            || self.words.iter().any(|word| word.starts_with("acc"))
            || joined == "gf";
        let gyroscope = gyroscope || self.words.iter().any(|word| word.starts_with("gyr"));
        let by_words = match axis {
            Some(axis) if accelerometer && self.has(FREE) => Some(format!("l{axis}")),
            Some(axis) if accelerometer => Some(format!("a{axis}")),
            Some(axis) if gyroscope => Some(format!("g{axis}")),
            Some(axis) if self.words.is_empty() => match self.unit?.quantity {
                Dimension::AngularRate => Some(format!("g{axis}")),
                Dimension::Acceleration => Some(format!("a{axis}")),
                _ => None,
            },
            None if self.has(&["angular", "rate"]) && !self.has(ANGLE) => Some("rate".to_owned()),
            None if self.has(ANGLE) => Some("angle".to_owned()),
            _ => None,
        };
        let of_channel = || self.channel().map(|(field, _)| field.to_owned());
        by_words
            .or_else(of_channel)
            .or_else(|| self.field_of_unit())
    }

    /// The field that fits the unit, where the words are of another language.
    fn field_of_unit(&self) -> Option<String> {
        let letter = match (self.unit?.quantity, self.axis) {
            (Dimension::AngularRate, Some(_)) => "g",
            (Dimension::Acceleration, Some(_)) => "a",
            (Dimension::AngularRate, None) => return Some("rate".to_owned()),
            (Dimension::Angle, None) => return Some("angle".to_owned()),
            (Dimension::Length, None) => return Some("y".to_owned()),
            _ => return None,
        };
        Some(format!("{letter}{}", ["x", "y", "z"][self.axis?]))
    }
}

/// Whether the name of a set of sensors is that of an accelerometer without gravity: `Linear
/// Accelerometer`, `Acceleration without g`. `nonlinear yaw` and `linear rig` name none.
fn names_free(set: &str) -> bool {
    let words = words(set);
    words
        .windows(2)
        .any(|pair| match [pair[0].as_str(), pair[1].as_str()] {
            ["linear" | "user", sensor] => ACCELEROMETER.contains(&sensor),
            ["without", gravity] => matches!(gravity, "g" | "gravity"),
            _ => false,
        })
}

/// What a field of one channel is, in words.
pub(super) fn quantity_name(field: &str) -> &'static str {
    match field {
        "angle" => "the angle",
        "y" => "the displacement of one point",
        _ => "the rate of turn",
    }
}

/// Whether a name is that of a column of time.
pub(super) fn is_time(name: &str) -> bool {
    let bare = name.split(['(', '[']).next().unwrap_or_default();
    words(bare).iter().any(|word| TIME.contains(&word.as_str()))
}

/// Lower-case words of a name: at blanks, signs, and where a capital follows a small letter.
pub(super) fn words(name: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut small = false;
    for c in name.chars() {
        if !c.is_alphanumeric() || small && c.is_uppercase() {
            words.push(String::new());
        }
        if c.is_alphanumeric()
            && let Some(word) = words.last_mut()
        {
            word.extend(c.to_lowercase());
        }
        small = c.is_lowercase();
    }
    words.retain(|word| !word.is_empty());
    // `gx`, `wz`, `accx`, `gyroy`: the axis stands at the end of the word.
    let stems = ["g", "w", "a", "gf", "acc", "accel", "gyr", "gyro"];
    let split = words.into_iter().flat_map(|word| {
        let axis = word.chars().last().filter(|c| matches!(c, 'x' | 'y' | 'z'));
        let stem = word.get(..word.len() - axis.map_or(0, char::len_utf8));
        match (axis, stem) {
            (Some(axis), Some(stem)) if stems.contains(&stem) => {
                vec![stem.to_owned(), axis.to_string()]
            }
            _ => vec![word],
        }
    });
    split.collect()
}

pub(super) fn axis_of_word(word: &str) -> Option<usize> {
    ["x", "y", "z"].iter().position(|axis| *axis == word)
}

/// A sensor of which some axes have been met: column and factor of each.
struct Met {
    sensor: Sensor,
    /// The words of its labels, the axis aside.
    words: Vec<String>,
    clock: Clock,
    axes: [Option<(usize, f64)>; 3],
}

impl Met {
    fn count(&self) -> usize {
        self.axes.iter().flatten().count()
    }

    /// The axes that there are.
    fn columns(self) -> SensorColumns {
        let mut columns = SensorColumns {
            sensor: self.sensor,
            clock: self.clock,
            axes: Vec::new(),
            directions: Vec::new(),
            factors: Vec::new(),
            tag: None,
        };
        for (axis, met) in self.axes.into_iter().enumerate() {
            if let Some((column, factor)) = met {
                columns.axes.push(column);
                columns.directions.push(axis);
                columns.factors.push(factor);
            }
        }
        columns
    }
}

/// The sensors of a table whose header tells units, each with the axes that it has and its clock; `set`
/// is the name of the file.
///
/// The axes of one sensor have labels that differ in nothing but the axis. Of several sensors of one
/// kind the one with the most axes is taken, then the one that is called so most plainly: `Gyroscope
/// x`, not `Filtered gyroscope x`.
pub(super) fn sensors(table: &Table, set: &str) -> Vec<SensorColumns> {
    let mut clocks: Vec<TimeColumn> = Vec::new();
    let mut met: Vec<Met> = Vec::new();
    for column in 0..table.header().len() {
        let label = Label::of(table, column);
        if let Some(factor) = label.time_factor() {
            let clock = Clock::Number { column, factor };
            clocks.push((clock, label.words));
            continue;
        }
        let (Some(sensor), Some(axis), Some(unit), Some(clock)) = (
            label.sensor(set),
            label.axis,
            label.unit,
            clock_of(&clocks, &label.words),
        ) else {
            continue;
        };
        let is_same =
            |met: &&mut Met| met.sensor == sensor && met.words == label.words && met.clock == clock;
        match met.iter_mut().find(is_same) {
            Some(met) => {
                met.axes[axis].get_or_insert((column, unit.factor));
            }
            None => {
                let mut axes = [None; 3];
                axes[axis] = Some((column, unit.factor));
                met.push(Met {
                    sensor,
                    words: label.words,
                    clock,
                    axes,
                });
            }
        }
    }
    chosen(met).into_iter().map(Met::columns).collect()
}

/// A column of time with the words of its label.
type TimeColumn = (Clock, Vec<String>);

/// The nearest column of time before a sensor's axis that is called the time, or that sensor's time,
/// and nothing else: a lap time or an exposure time is no clock where there is another.
fn clock_of(clocks: &[TimeColumn], sensor: &[String]) -> Option<Clock> {
    let is_plain = |(_, words): &&TimeColumn| {
        let mut words = words.iter();
        words.all(|word| TIME.contains(&word.as_str()) || sensor.contains(word))
    };
    let nearest = clocks.iter().rev().find(is_plain).or(clocks.last());
    nearest.map(|(clock, _)| *clock)
}

/// One of each kind of sensor.
fn chosen(met: Vec<Met>) -> Vec<Met> {
    let mut chosen: Vec<Met> = Vec::new();
    for one in met {
        let rank = |met: &Met| (met.count(), usize::MAX - met.words.len());
        match chosen.iter_mut().find(|other| other.sensor == one.sensor) {
            Some(other) if rank(&one) > rank(other) => *other = one,
            Some(_) => {}
            None => chosen.push(one),
        }
    }
    chosen
}

/// Rows by which a proposal judges a column.
const JUDGED_ROWS: usize = 200;

/// The mapping that a table's header, or else the order of its columns, suggests.
pub(super) fn proposal(table: &Table) -> Option<String> {
    let rows: Vec<Vec<String>> = table.texts().ok()?.into_iter().take(JUDGED_ROWS).collect();
    let labels: Vec<Label> = (0..table.header().len())
        .map(|column| Label::of(table, column))
        .collect();
    let rising = |column: &usize| time_unit(&rows, *column).is_some();
    let time = (0..labels.len())
        .find(|column| labels[*column].time_factor().is_some())
        .or_else(|| (0..labels.len()).find(|c| labels[*c].has(TIME) && rising(c)))
        .or_else(|| (0..labels.len()).find(rising))?;
    let stated = labels[time].time_factor().map(seconds_name);
    let is_count = stated.is_none() && labels[time].has(COUNTS);
    let time_unit = match () {
        _ if is_count => "RATEfps".to_owned(),
        _ if labels[time].is_unknown => UNIT.to_owned(),
        _ => stated.or_else(|| time_unit(&rows, time).map(str::to_owned))?,
    };
    let time_unit = time_unit.as_str();
    let mut fields: Vec<(String, usize)> = Vec::new();
    for (column, label) in labels
        .iter()
        .enumerate()
        .filter(|(column, _)| *column != time)
    {
        if let Some(field) = label.field()
            && !fields.iter().any(|(other, _)| *other == field)
        {
            fields.push((field, column));
        }
    }
    let tags = (0..labels.len()).filter(|column| *column != time);
    for column in tags {
        let known = tags_of(&rows, column, labels[column].has(TAG));
        if !known.is_empty() {
            let entries = tagged(table, &rows, (&labels, time), (column, &known))?;
            let time = entry_of("t", &table.name_of(time), time_unit);
            return Some(format!("{time} {entries}"));
        }
    }
    if fields.is_empty() {
        fields = by_axis(&labels, source::stem(table.file()));
    }
    // Names say what a column is; their order says it only where there are none.
    if fields.is_empty() && !table.is_named() {
        fields = by_order(table, &rows, time);
    }
    let entry = |field: &str, column: usize, unit: &str| {
        let name = table.name_of(column);
        let is_once = table
            .header()
            .iter()
            .filter(|other| **other == name)
            .count()
            == 1;
        let name = if is_once {
            name
        } else {
            format!("#{}", column + 1)
        };
        entry_of(field, &name, unit)
    };
    let mut entries = vec![entry("t", time, time_unit)];
    for (field, column) in &fields {
        let kind = field.get(..1).unwrap_or_default();
        let label = &labels[*column];
        let named = label.unit.and_then(unit_name);
        let unit = match kind {
            _ if named.is_some() => named.unwrap_or_default(),
            _ if label.is_unknown || label.unit.is_some() => UNIT,
            "a" | "l" if field.len() == 2 => acceleration_unit(&rows, &fields, kind),
            "a" if label.has(DEGREES) => "deg",
            "a" => "rad",
            "y" => "m",
            _ if label.has(DEGREES) => "deg/s",
            _ => "rad/s",
        };
        entries.push(entry(field, *column, unit));
    }
    (entries.len() > 1).then(|| entries.join(" "))
}

pub(super) fn entry_of(field: &str, column: &str, unit: &str) -> String {
    format!("--map \"{field}={column}:{unit}\"")
}

/// What stands for a unit that the reader must fill in.
const UNIT: &str = "UNIT";

/// A unit of time as a mapping writes it.
fn seconds_name(factor: f64) -> String {
    let names = [(1.0, "s"), (1e-3, "ms"), (1e-6, "us"), (1e-9, "ns")];
    let known = names.iter().find(|(known, _)| *known == factor);
    known.map_or_else(|| format!("{factor}*s"), |(_, name)| (*name).to_owned())
}

/// Columns that name an axis and nothing else, each once: the file's name may tell the sensor.
fn by_axis(labels: &[Label], set: &str) -> Vec<(String, usize)> {
    let kind = match words(set).iter().any(|word| word.starts_with("acc")) {
        true => "a",
        false => "g",
    };
    let bare = |axis: usize| {
        let is_axis = |label: &Label| label.axis == Some(axis) && label.words.is_empty();
        let mut columns = (0..labels.len()).filter(|column| is_axis(&labels[*column]));
        columns.next().filter(|_| columns.next().is_none())
    };
    let fields = ["x", "y", "z"].iter().enumerate();
    let found: Option<Vec<(String, usize)>> = fields
        .map(|(axis, name)| Some((format!("{kind}{name}"), bare(axis)?)))
        .collect();
    found.unwrap_or_default()
}

/// Columns of numbers that nothing names: the gyroscope first, then the accelerometer.
fn by_order(table: &Table, rows: &[Vec<String>], time: usize) -> Vec<(String, usize)> {
    let is_number = |column: &usize| {
        let cells = rows.iter().filter_map(|row| row.get(*column));
        let mut numbers = cells.map(|cell| value(cell));
        numbers.next().flatten().is_some() && numbers.all(|number| number.is_some())
    };
    let columns: Vec<usize> = (0..table.header().len())
        .filter(|column| *column != time)
        .filter(is_number)
        .collect();
    let fields: &[&str] = match columns.len() {
        0 => &[],
        1 => &["rate"],
        2 => &[],
        3..6 => &["gx", "gy", "gz"],
        _ => &["gx", "gy", "gz", "ax", "ay", "az"],
    };
    let pairs = fields.iter().zip(columns);
    pairs
        .map(|(field, column)| ((*field).to_owned(), column))
        .collect()
}

pub(super) fn value(cell: &str) -> Option<f64> {
    cell.replacen(',', ".", 1).parse().ok()
}

/// The unit in which a column that never falls gives 2 to 2000 samples a second.
fn time_unit(rows: &[Vec<String>], column: usize) -> Option<&'static str> {
    let cells: Vec<&str> = rows
        .iter()
        .filter_map(|row| Some(row.get(column)?.as_str()))
        .collect();
    if cells
        .first()
        .is_some_and(|cell| value(cell).is_none() && seconds_of_text(cell).is_some())
    {
        return Some("clock");
    }
    let numbers: Vec<f64> = cells
        .iter()
        .map(|cell| value(cell))
        .collect::<Option<_>>()?;
    let rises = numbers.windows(2).all(|pair| pair[1] >= pair[0]);
    let (first, last) = (*numbers.first()?, *numbers.last()?);
    let interval = (last - first) / (numbers.len().max(2) - 1) as f64;
    let units = [("s", 1.0), ("ms", 1e-3), ("us", 1e-6), ("ns", 1e-9)];
    let fits = |factor: f64| (5e-4..=0.5).contains(&(interval * factor));
    let unit = units.into_iter().find(|(_, factor)| fits(*factor))?;
    (rises && numbers.len() > 1).then_some(unit.0)
}

/// The unit by the size of gravity.
fn acceleration_unit(rows: &[Vec<String>], fields: &[(String, usize)], kind: &str) -> &'static str {
    let columns = fields
        .iter()
        .filter(|(field, _)| field.starts_with(kind) && field.len() == 2);
    let columns: Vec<usize> = columns.map(|(_, column)| *column).collect();
    let Some(row) = rows.first() else {
        return "m/s2";
    };
    let axes = columns.iter().filter_map(|column| value(row.get(*column)?));
    let size = axes.map(|axis| axis * axis).sum::<f64>().sqrt();
    match size {
        _ if kind == "a" && (0.5..=2.0).contains(&size) => "g",
        _ if kind == "a" && (500.0..=2000.0).contains(&size) => "mg",
        _ => "m/s2",
    }
}

fn unit_name(unit: Unit) -> Option<&'static str> {
    let names = [
        "rad/s", "deg/s", "m/s2", "g", "mg", "rad", "deg", "m", "cm", "mm",
    ];
    names
        .into_iter()
        .find(|name| name.parse::<Unit>().is_ok_and(|named| named == unit))
}
