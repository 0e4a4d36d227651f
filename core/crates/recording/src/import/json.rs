//! A list of samples in JSON, as Sensor Logger exports it, turned into one table a sensor.

use std::collections::BTreeMap;
use std::fmt;

use serde::de::{Deserializer, SeqAccess, Visitor};
use serde_json::Value;

use gyradius_base::{Error, Result};

/// True for bytes that begin like a list or an object.
pub(super) fn looks_like_json(bytes: &[u8]) -> bool {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    let start = bytes.trim_ascii_start();
    match start {
        [b'{', ..] => true,
        [b'[', rest @ ..] => matches!(rest.trim_ascii_start().first(), Some(b'{' | b']')),
        _ => false,
    }
}

/// The samples of one sensor as they come, columns in the order in which they are met.
#[derive(Default)]
struct Samples {
    columns: Vec<String>,
    rows: Vec<Vec<String>>,
}

/// The tables of a file, by name: `Gyroscope.csv` for samples whose `sensor` is `Gyroscope`.
pub(super) fn tables(bytes: &[u8], file: &str) -> Result<Vec<(String, Vec<u8>)>> {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    let mut json = serde_json::Deserializer::from_slice(bytes);
    let read = json
        .deserialize_seq(List)
        .and_then(|all| json.end().map(|()| all));
    let samples = read.map_err(|error| Error::Malformed {
        file: file.to_owned(),
        line: Some(error.line()),
        expected: "a list of samples, each with its `sensor`, as Sensor Logger writes it"
            .to_owned(),
        found: error.to_string(),
    })?;
    Ok(samples
        .into_iter()
        .map(|(sensor, samples)| (format!("{sensor}.csv"), samples.as_csv()))
        .collect())
}

struct List;

impl<'de> Visitor<'de> for List {
    type Value = BTreeMap<String, Samples>;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("a list of samples")
    }

    fn visit_seq<A: SeqAccess<'de>>(
        self,
        mut list: A,
    ) -> std::result::Result<Self::Value, A::Error> {
        let mut all: BTreeMap<String, Samples> = BTreeMap::new();
        while let Some(mut sample) = list.next_element::<serde_json::Map<String, Value>>()? {
            let sensor = sample.remove("sensor").map(|name| text_of(&name));
            let sensor = sensor.unwrap_or_else(|| "samples".to_owned());
            all.entry(sensor).or_default().push(sample);
        }
        Ok(all)
    }
}

impl Samples {
    fn push(&mut self, sample: serde_json::Map<String, Value>) {
        let mut row = vec![String::new(); self.columns.len()];
        for (key, value) in sample {
            let text = text_of(&value);
            match self.columns.iter().position(|column| *column == key) {
                Some(column) => row[column] = text,
                None => {
                    self.columns.push(key);
                    row.push(text);
                }
            }
        }
        self.rows.push(row);
    }

    fn as_csv(&self) -> Vec<u8> {
        let mut out = String::new();
        for row in std::iter::once(&self.columns).chain(&self.rows) {
            let cells: Vec<String> = (0..self.columns.len())
                .map(|column| quoted(row.get(column).map_or("", String::as_str)))
                .collect();
            out.push_str(&cells.join(","));
            out.push('\n');
        }
        out.into_bytes()
    }
}

fn text_of(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Null => String::new(),
        other => other.to_string(),
    }
}

/// A cell of a table, in quotes where it needs them.
pub(super) fn quoted(cell: &str) -> String {
    if cell.contains([',', '"', '\n', '\r', ';', '\t', '|']) {
        format!("\"{}\"", cell.replace('"', "\"\""))
    } else {
        cell.to_owned()
    }
}
