//! What an export says of its recording beside the samples: the day, the phone, the program.

use std::collections::BTreeMap;

use super::clock::date_of_text;
use super::imported::Format;
use super::source::{Source, stem};
use super::table::Table;

/// What an export says of a recording beside its samples; empty where it says nothing.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Facts {
    /// The day, as `2026-05-04`.
    pub measured_on: String,
    /// Model of the phone.
    pub phone: String,
    /// The program that recorded, with its version where it is told.
    pub logger: String,
}

/// The facts of a source: of the small tables that apps put beside the samples, and of each table
/// of samples.
pub(super) struct FactsOfSource {
    beside: Facts,
    of_samples: Vec<(String, Facts)>,
    is_archive: bool,
}

impl FactsOfSource {
    pub fn new(source: &Source) -> Self {
        let mut all = Self {
            beside: Facts::default(),
            of_samples: Vec::new(),
            is_archive: source.archive.is_some(),
        };
        for (name, bytes) in source.members() {
            let Ok(table) = Table::open(bytes, name) else {
                continue;
            };
            match beside_samples(&table) {
                Some(facts) => all.beside.take(facts),
                None => all
                    .of_samples
                    .push((stem(name).to_owned(), of_samples(&table))),
            }
        }
        all
    }

    /// Those of one recording: loose files of one folder may be of several days.
    pub fn of(&self, recording: &str) -> Facts {
        let mut facts = self.beside.clone();
        for (name, own) in &self.of_samples {
            if self.is_archive || name == recording {
                facts.take(own.clone());
            }
        }
        facts
    }
}

impl Facts {
    /// The same, with the program where the format alone names it.
    pub(super) fn recorded_by(mut self, format: Format) -> Self {
        if let (true, Some(logger)) = (self.logger.is_empty(), format.logger()) {
            self.logger = logger.to_owned();
        }
        self
    }

    /// Fills what is empty.
    fn take(&mut self, other: Self) {
        for (mine, its) in [
            (&mut self.measured_on, other.measured_on),
            (&mut self.phone, other.phone),
            (&mut self.logger, other.logger),
        ] {
            if mine.is_empty() {
                *mine = its;
            }
        }
    }
}

/// What a table says that phyphox or Sensor Logger puts beside the samples.
fn beside_samples(table: &Table) -> Option<Facts> {
    let find = |wanted: &str| table.find(|column| column.eq_ignore_ascii_case(wanted));
    let day = |column: usize| day_of(table, column);
    if let (Some(property), Some(value)) = (find("property"), find("value")) {
        let properties = pairs(table, property, value);
        let of = |key: &str| properties.get(key).cloned().unwrap_or_default();
        return Some(Facts {
            phone: of("devicemodel"),
            logger: with_version("phyphox", &of("version")),
            ..Facts::default()
        });
    }
    if let (Some(_), Some(column)) = (find("experiment time"), find("system time text")) {
        return Some(Facts {
            measured_on: day(column).unwrap_or_default(),
            ..Facts::default()
        });
    }
    if let (Some(_), Some(device)) = (find("platform"), find("device name")) {
        let first = |column: Option<usize>| {
            let texts = column.and_then(|column| table.texts_of(column).ok());
            texts.into_iter().flatten().next().unwrap_or_default()
        };
        return Some(Facts {
            measured_on: find("recording time").and_then(day).unwrap_or_default(),
            phone: first(Some(device)),
            logger: with_version("Sensor Logger", &first(find("appVersion"))),
        });
    }
    None
}

/// What a table of samples says: the day by SensorLog's column, the program by Gyroflow's preamble.
fn of_samples(table: &Table) -> Facts {
    let dated = table.find(|column| column.to_lowercase().starts_with("loggingtime"));
    Facts {
        measured_on: dated
            .and_then(|column| day_of(table, column))
            .unwrap_or_default(),
        logger: preamble(table, "vendor"),
        ..Facts::default()
    }
}

/// The first day that a column tells.
fn day_of(table: &Table, column: usize) -> Option<String> {
    let texts = table.texts_of(column).unwrap_or_default();
    texts.iter().find_map(|text| date_of_text(text))
}

/// The value of a line such as `vendor,name` above the header, as Gyroflow logs have it.
fn preamble(table: &Table, key: &str) -> String {
    let mut lines = table.preamble().iter();
    let value = lines.find_map(|line| line.split_once(',').filter(|(name, _)| *name == key));
    value.map_or(String::new(), |(_, value)| value.trim().to_owned())
}

fn pairs(table: &Table, key: usize, value: usize) -> BTreeMap<String, String> {
    let rows = table.texts().unwrap_or_default();
    let cell = |row: &[String], column: usize| row.get(column).cloned().unwrap_or_default();
    rows.iter()
        .map(|row| (cell(row, key).to_lowercase(), cell(row, value)))
        .collect()
}

fn with_version(name: &str, version: &str) -> String {
    format!("{name} {version}").trim_end().to_owned()
}
