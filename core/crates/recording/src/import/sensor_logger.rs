//! Sensor Logger: one file per sensor, columns in the order z, y, x.
//!
//! # Conventions
//! `GyroscopeUncalibrated` is preferred to `Gyroscope`, whose bias the phone re-calibrates in
//! mid-record in steps; the analysis fits a bias itself. The accelerometer is `TotalAcceleration`,
//! or else `Accelerometer` (gravity-free) plus `Gravity`, or else `AccelerometerUncalibrated`; a
//! watch's `WristMotion` holds all in one table. On iOS accelerations carry the opposite
//! sign unless the metadata say `standardisation=true`.

use std::collections::{BTreeMap, BTreeSet};

use super::columns::{
    Clock, SensorColumns, assemble, columns_not_used, gravity_doubt, mean_length, sum, xyz,
};
use super::file_not_used;
use super::imported::{Format, ImportedRecording};
use super::options::{ImportOptions, Platform};
use super::source::{Source, base, stem, stem_of_copy};
use super::table::Table;
use crate::repair::RawSeries;
use crate::samples::Sensor;
use gyradius_base::Result;
use gyradius_base::constants::STANDARD_GRAVITY_M_S2;

type File<'a> = (&'a str, &'a [u8]);

/// The file of a watch: rotation rate, gravity and the acceleration without it, in one table.
const MOTION: &str = "wristmotion";
/// Files without `seconds_elapsed` are known by their names.
const SENSORS: [&str; 6] = [
    "gyroscope",
    "gyroscopeuncalibrated",
    "accelerometer",
    "accelerometeruncalibrated",
    "totalacceleration",
    "gravity",
];

/// The phone's gyroscope, preferred first.
const GYROSCOPES: [&str; 2] = ["gyroscopeuncalibrated", "gyroscope"];

/// True for a sensor's file by its columns, and by its name where it tells no elapsed time.
pub(super) fn recognises(table: &Table, name: &str) -> bool {
    let has = |wanted: &str| table.find(|column| column == wanted).is_some();
    let named = SENSORS.contains(&stem_of_copy(name).to_lowercase().as_str());
    has("seconds_elapsed") || named && ["time", "z", "y", "x"].into_iter().all(has)
}

/// One recording from the sensor files of a source.
pub(super) fn import(
    source: &Source,
    files: &[File],
    metadata: &[File],
    options: &ImportOptions,
    device: &mut BTreeMap<String, String>,
) -> Result<Option<ImportedRecording>> {
    let mut stated = BTreeMap::new();
    for (name, bytes) in metadata {
        stated.extend(read_metadata(bytes, name)?);
    }
    let mut files_of = Files::new(files);
    let mut other = Vec::new();
    // A watch that was recorded with it tells the phone's system.
    let has_watch = files_of.has(MOTION);
    let device_of = files_of.keep_one_device(&mut other)?;
    let is_apple = has_watch || device_of == Device::Watch;
    let (sign, mut notes) = acceleration_sign(&stated, options, is_apple);
    notes.extend(other);
    let mut series: Vec<RawSeries> = Vec::new();
    series.extend(gyroscope(&mut files_of, &mut notes)?);
    series.extend(acceleration(&mut files_of, sign, &mut notes)?);
    if series.is_empty() {
        return Ok(None);
    }
    let name = if source.archive.is_some() {
        source.name.as_str()
    } else {
        files[0].0
    };
    let recording = assemble(name, series.into_iter().enumerate().collect())?;
    notes.extend(gravity_doubt(&recording));
    device.extend(stated);
    let imported = ImportedRecording::new(name, Format::SensorLogger, recording, notes);
    Ok(Some(imported.without(files_of.left())))
}

fn read_metadata(bytes: &[u8], name: &str) -> Result<BTreeMap<String, String>> {
    let table = Table::open(bytes, name)?;
    let values = table.texts()?.into_iter().next().unwrap_or_default();
    Ok(table.header().iter().cloned().zip(values).collect())
}

/// +1 for Android's sign, −1 for that of iOS, with a note where it had to be assumed.
fn acceleration_sign(
    stated: &BTreeMap<String, String>,
    options: &ImportOptions,
    watch: bool,
) -> (f64, Vec<String>) {
    let says = |key: &str, value: &str| {
        stated
            .iter()
            .any(|(k, v)| k.eq_ignore_ascii_case(key) && v.to_lowercase().contains(value))
    };
    let stated = match (says("platform", "ios"), says("platform", "android")) {
        (true, _) => Some(Platform::Ios),
        (_, true) => Some(Platform::Android),
        _ => None,
    };
    // A watch that writes this file is Apple's.
    let watch = watch.then_some(Platform::Ios);
    match stated.or(options.platform).or(watch) {
        Some(Platform::Ios) if says("standardisation", "true") => (1.0, Vec::new()),
        Some(Platform::Ios) => (
            -1.0,
            vec!["accelerations have the sign of iOS and are turned".to_owned()],
        ),
        Some(Platform::Android) => (1.0, Vec::new()),
        None => {
            let note = "the files do not name the phone's system: accelerations are taken to have Android's sign";
            (1.0, vec![note.to_owned()])
        }
    }
}

/// The sensor files of one recording, and which of them have been used.
struct Files<'a> {
    by_name: BTreeMap<String, File<'a>>,
    used: BTreeSet<String>,
    not_used: Vec<String>,
    /// Files of another device or recording, as the user knows them.
    of_other: Vec<&'a str>,
}

/// What a file was recorded by: a phone and a watch sit apart, each with axes of its own.
#[derive(Clone, Copy, PartialEq)]
enum Device {
    Phone,
    Watch,
}

impl<'a> Files<'a> {
    fn new(files: &[File<'a>]) -> Self {
        let mut all = Self {
            by_name: BTreeMap::new(),
            used: BTreeSet::new(),
            not_used: Vec::new(),
            of_other: Vec::new(),
        };
        for file in files {
            // `Gyroscope (1).csv` beside `Gyroscope.csv` is another recording.
            let is_copy = |name: &str| stem_of_copy(name) != stem(name);
            let name = stem_of_copy(file.0).to_lowercase();
            let Some(kept) = all.by_name.get_mut(&name) else {
                all.by_name.insert(name, *file);
                continue;
            };
            let other = match is_copy(kept.0) && !is_copy(file.0) {
                true => std::mem::replace(kept, *file).0,
                false => file.0,
            };
            all.of_other.push(other);
        }
        all
    }

    /// Takes the files of one device: the phone, or the watch where the phone has no gyroscope.
    /// Two devices in one recording would be two bodies.
    fn keep_one_device(&mut self, notes: &mut Vec<String>) -> Result<Device> {
        let is_watch = |name: &str| name.starts_with("wrist");
        let has_both = self.has(MOTION)
            && self
                .by_name
                .keys()
                .any(|name| SENSORS.contains(&name.as_str()));
        let device = match self.has(MOTION) && !self.phone_turns()? {
            true => Device::Watch,
            false => Device::Phone,
        };
        if !has_both {
            return Ok(device);
        }
        let (kept, left) = std::mem::take(&mut self.by_name)
            .into_iter()
            .partition(|(name, _)| is_watch(name) == (device == Device::Watch));
        self.by_name = kept;
        self.of_other
            .extend(BTreeMap::into_values(left).map(|file| file.0));
        let (read, other) = match device {
            Device::Phone => ("phone", "watch"),
            Device::Watch => ("watch, as the phone has no gyroscope", "phone"),
        };
        notes.push(format!(
            "the files are of a phone and of a watch, which have axes of their own: read are those of the {read}; for the {other}, import its files by themselves"
        ));
        Ok(device)
    }

    /// Whether the phone's gyroscope has samples.
    fn phone_turns(&self) -> Result<bool> {
        for name in GYROSCOPES {
            if let Some(file) = self.by_name.get(name)
                && read(file, str::to_owned, Sensor::Gyroscope)?.has_samples()
            {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The three columns of a file, if it is there, in the unit in which it has them.
    fn read(
        &mut self,
        name: &str,
        columns: impl Fn(&str) -> String,
        sensor: Sensor,
    ) -> Result<Option<RawSeries>> {
        let Some(file) = self.by_name.get(name) else {
            return Ok(None);
        };
        self.used.insert(name.to_owned());
        read(file, columns, sensor).map(Some)
    }

    fn has(&self, name: &str) -> bool {
        self.by_name.contains_key(name)
    }

    /// Whether a file is there with samples in it.
    fn holds(&self, name: &str) -> Result<bool> {
        let file = self.by_name.get(name);
        let raw = file.map(|file| read(file, str::to_owned, Sensor::Accelerometer));
        Ok(raw.transpose()?.is_some_and(|raw| raw.has_samples()))
    }

    /// A file without samples is not taken, and told.
    fn without_samples(&mut self, name: &str, sensor: Sensor, notes: &mut Vec<String>) {
        self.used.remove(name);
        notes.push(format!(
            "{}: `{}` holds no sample",
            sensor.name(),
            self.file(name)
        ));
    }

    /// The file as the user knows it.
    fn file(&self, name: &str) -> &'a str {
        self.by_name.get(name).map_or("", |file| base(file.0))
    }

    /// Columns of the watch's table that are left, quaternions for example.
    fn columns_left(&self) -> Option<String> {
        let file = self
            .by_name
            .get(MOTION)
            .filter(|_| self.used.contains(MOTION))?;
        let table = Table::open(file.1, file.0).ok()?;
        let known = ["time", "seconds_elapsed"];
        let prefixes = ["rotationrate", "gravity", "acceleration"];
        let used = (0..table.header().len()).filter(|column| {
            let name = table.name_of(*column).to_lowercase();
            known.contains(&name.as_str()) || prefixes.iter().any(|start| name.starts_with(start))
        });
        columns_not_used(&table, used)
    }

    /// What is left unused, as sentences.
    fn left(&self) -> impl Iterator<Item = String> {
        let left = self
            .by_name
            .iter()
            .filter(|(name, _)| !self.used.contains(*name));
        let left = left.map(|(_, file)| file.0);
        let left = left.chain(self.of_other.iter().copied()).map(file_not_used);
        left.chain(self.not_used.iter().cloned())
            .chain(self.columns_left())
    }
}

fn gyroscope(files: &mut Files, notes: &mut Vec<String>) -> Result<Option<RawSeries>> {
    for name in GYROSCOPES.into_iter().chain([MOTION]) {
        let columns = |axis: &str| match name {
            MOTION => format!("rotationRate{axis}"),
            _ => axis.to_owned(),
        };
        if let Some(raw) = files.read(name, columns, Sensor::Gyroscope)? {
            if raw.has_samples() {
                notes.push(format!("gyroscope: `{}`", files.file(name)));
                return Ok(Some(raw));
            }
            files.without_samples(name, Sensor::Gyroscope, notes);
        }
    }
    Ok(None)
}

fn acceleration(
    files: &mut Files,
    sign: f64,
    notes: &mut Vec<String>,
) -> Result<Option<RawSeries>> {
    let plain = |axis: &str| axis.to_owned();
    let parts = files.holds("accelerometer")? && files.holds("gravity")?;
    let mut whole = None;
    for name in ["totalacceleration", "accelerometeruncalibrated"] {
        if whole.is_some() || (name != "totalacceleration" && parts) {
            continue;
        }
        match files.read(name, plain, Sensor::Accelerometer)? {
            Some(raw) if raw.has_samples() => {
                notes.push(format!("accelerometer: `{}`", files.file(name)));
                whole = Some(raw);
            }
            Some(_) => files.without_samples(name, Sensor::Accelerometer, notes),
            None => {}
        }
    }
    if let Some(mut total) = whole {
        let unit = unit_of(&total, notes);
        scale(&mut total, sign * unit);
        return Ok(Some(total));
    }
    if files.holds("accelerometer")? {
        let Some(mut free) = files.read("accelerometer", plain, Sensor::LinearAccelerometer)?
        else {
            return Ok(None);
        };
        scale(&mut free, sign);
        let Some(mut gravity) = files.read("gravity", plain, Sensor::Accelerometer)? else {
            return Ok(Some(free));
        };
        scale(&mut gravity, sign);
        let names = (files.file("accelerometer"), files.file("gravity"));
        let (total, used) = together(free, &gravity, names, notes);
        if !used {
            let left = format!("`{}` has stamps of its own and is not used", names.1);
            files.not_used.push(left);
        }
        return Ok(Some(total));
    }
    let name = files.file(MOTION);
    let user = files.read(
        MOTION,
        |a| format!("acceleration{a}"),
        Sensor::LinearAccelerometer,
    );
    let gravity = files.read(MOTION, |a| format!("gravity{a}"), Sensor::Accelerometer);
    if let (Ok(Some(mut user)), Ok(Some(mut gravity))) = (user, gravity) {
        let factor = sign * unit_of(&gravity, notes);
        scale(&mut user, factor);
        scale(&mut gravity, factor);
        notes.push(format!(
            "accelerometer: gravity plus acceleration of `{name}`"
        ));
        return Ok(Some(sum(&user, &gravity)));
    }
    Ok(None)
}

/// Gravity-free acceleration with gravity put back, if the two are sampled together; there is
/// nothing to add without resampling where they are not.
fn together(
    free: RawSeries,
    gravity: &RawSeries,
    names: (&str, &str),
    notes: &mut Vec<String>,
) -> (RawSeries, bool) {
    let total = sum(&free, gravity);
    if 2 * total.t_s.len() < free.t_s.len() {
        return (free, false);
    }
    notes.push(format!(
        "accelerometer: `{}` plus `{}` where their stamps agree",
        names.0, names.1
    ));
    (total, true)
}

/// Factor to m/s²: some files of iOS are in g, which the size of gravity tells.
fn unit_of(gravity: &RawSeries, notes: &mut Vec<String>) -> f64 {
    let in_g = (0.7..=1.3).contains(&mean_length(&gravity.channels));
    if in_g {
        notes.push("accelerations are in g, by the size of gravity".to_owned());
    }
    if in_g { STANDARD_GRAVITY_M_S2 } else { 1.0 }
}

fn scale(raw: &mut RawSeries, factor: f64) {
    let values = raw.channels.iter_mut().flatten();
    values.for_each(|value| *value *= factor);
}

fn read(file: &File, columns: impl Fn(&str) -> String, sensor: Sensor) -> Result<RawSeries> {
    let table = Table::open(file.1, file.0)?;
    let missing = |what: &str| {
        table.malformed(
            Some(0),
            &format!("columns {what}"),
            &format!("`{}`", table.header_text()),
        )
    };
    let wanted = format!("{}, {} and {}", columns("x"), columns("y"), columns("z"));
    let axes = xyz(&table, columns).ok_or_else(|| missing(&wanted))?;
    let find = |wanted: &str| table.find(|column| column == wanted);
    let elapsed = find("seconds_elapsed");
    let time = elapsed
        .or_else(|| find("time"))
        .ok_or_else(|| missing("`seconds_elapsed` or `time`"))?;
    let mut columns = SensorColumns::new(sensor, time, axes, 1.0);
    // `time` is in nanoseconds since 1970.
    let factor = if elapsed.is_none() { 1e-9 } else { 1.0 };
    columns.clock = Clock::Number {
        column: time,
        factor,
    };
    columns.read(&table)
}
