//! Tables in which rows of several sensors stand among each other, each with a tag.

use super::labels::{ACCELEROMETER, FREE, GYROSCOPE, Label, axis_of_word, entry_of, value, words};
use super::table::Table;
use gyradius_base::Result;
use std::collections::BTreeSet;

/// What says which sensor a row is of.
pub(super) const TAG: &[&str] = &[
    "sensor", "type", "source", "stream", "channel", "device", "name", "id",
];
/// The few texts that a column has by turns, where they are names of sensors or the header calls
/// them so: then rows of several sensors stand among each other.
pub(super) fn tags_of(rows: &[Vec<String>], column: usize, is_called_so: bool) -> Vec<String> {
    let mut tags: Vec<String> = Vec::new();
    for cell in rows.iter().filter_map(|row| row.get(column)) {
        if !cell.is_empty() && !tags.contains(cell) {
            tags.push(cell.clone());
        }
        if tags.len() > MOST_TAGS {
            return Vec::new();
        }
    }
    let is_sensor = |tag: &String| field_of_tag(tag).is_some();
    let holds = tags.iter().any(is_sensor) || (is_called_so && tags.len() > 1);
    if holds { tags } else { Vec::new() }
}

/// The column whose cells are a tag, the one that has it most often: a number may be a tag too. Where
/// `strict`, its other cells must be tags as well, few in kind.
pub(super) fn column_of_tag(table: &Table, tag: &str, strict: bool) -> Result<Option<usize>> {
    let mut columns: Vec<(usize, BTreeSet<Vec<u8>>)> =
        vec![Default::default(); table.header().len()];
    table.each_row(None, |_, _, record| {
        for ((count, kinds), cell) in columns.iter_mut().zip(record) {
            let cell = cell.trim_ascii();
            *count += usize::from(cell == tag.as_bytes());
            if kinds.len() <= MOST_TAGS && !kinds.contains(cell) {
                kinds.insert(cell.to_vec());
            }
        }
        Ok(())
    })?;
    let having = columns
        .iter()
        .enumerate()
        .filter(|(_, (count, kinds))| *count > 0 && (!strict || kinds.len() <= MOST_TAGS));
    let most = having.max_by_key(|(_, (count, _))| *count);
    Ok(most.map(|(column, _)| column))
}

/// More than so many kinds of rows are no kinds.
const MOST_TAGS: usize = 12;

/// The field or the letter of its sensor that a tag names: `Gyro`, `ACC`, `gz`.
fn field_of_tag(tag: &str) -> Option<String> {
    let words = words(tag);
    let has = |known: &[&str]| words.iter().any(|word| known.contains(&word.as_str()));
    let axis = words.iter().rev().find_map(|word| axis_of_word(word));
    let axis = axis.map_or("", |axis| ["x", "y", "z"][axis]);
    let is_letter = |letter: &str| !axis.is_empty() && has(&[letter]);
    if has(GYROSCOPE) || is_letter("g") || is_letter("w") {
        return Some(format!("g{axis}"));
    }
    let letter = if has(FREE) { "l" } else { "a" };
    (has(ACCELEROMETER) || is_letter("a")).then(|| format!("{letter}{axis}"))
}

/// The entries for a table whose rows are tagged by sensor; `None` where nothing tells which tag is
/// which.
pub(super) fn tagged(
    table: &Table,
    rows: &[Vec<String>],
    (labels, time): (&[Label], usize),
    (column, tags): (usize, &[String]),
) -> Option<String> {
    let by_name = (0..3).map(|axis| labels.iter().position(|label| label.axis == Some(axis)));
    let numbers = |c: &usize| {
        let mut cells = rows.iter().filter_map(|row| row.get(*c));
        *c != time && *c != column && cells.all(|cell| cell.is_empty() || value(cell).is_some())
    };
    let by_place: Vec<usize> = (0..labels.len()).filter(numbers).collect();
    let axes: Vec<usize> = by_name.collect::<Option<Vec<usize>>>().unwrap_or(by_place);
    let mut entries: Vec<(String, String, &str)> = Vec::new();
    for tag in tags {
        let Some(field) = field_of_tag(tag) else {
            continue;
        };
        // Axes of one sensor in rows of their own cannot be read together.
        let is_known = entries
            .iter()
            .any(|(known, ..)| known.starts_with(&field[..1]));
        if is_known {
            continue;
        }
        let unit = if field.starts_with('g') {
            "rad/s"
        } else {
            "m/s2"
        };
        match field.len() {
            1 => entries.extend(["x", "y", "z"].iter().zip(&axes).map(|(axis, place)| {
                let column = format!("{}@{tag}", table.name_of(*place));
                (format!("{field}{axis}"), column, unit)
            })),
            _ => {
                let place = axes.first()?;
                entries.push((field, format!("{}@{tag}", table.name_of(*place)), unit));
            }
        }
    }
    let texts = entries
        .iter()
        .map(|(field, column, unit)| entry_of(field, column, unit));
    let texts: Vec<String> = texts.collect();
    if texts.is_empty() {
        // Numbers for sensors: which is which is the reader's to say.
        let entry = |(axis, place): (&&str, &usize)| {
            let column = format!("{}@TAG", table.name_of(*place));
            entry_of(&format!("g{axis}"), &column, "rad/s")
        };
        let all: Vec<String> = ["x", "y", "z"].iter().zip(&axes).map(entry).collect();
        return Some(all.join(" "));
    }
    Some(texts.join(" "))
}
