//! One channel over time, told by the words and the units of a header: `t (s), theta (deg)`,
//! `Time (s), Position (mm)`, `Run 1: Time (s), Run 1: Angle (rad)`.
//!
//! # Conventions
//! The time has its unit, or is called `t` and is in s, as in the project's own recordings. Of
//! several quantities the angle is taken, then the displacement, then the rate: a sensor of angle
//! computes the others from it. Two columns of one quantity are ambiguous, and left to a mapping.

use std::collections::BTreeMap;

use super::imported::ImportedRecording;
use super::labels::{Label, quantity_name};
use super::mapping::{ColumnMapping, MappedColumn, import_table};
use super::table::Table;
use super::units::{Dimension, Unit};
use gyradius_base::Result;

/// Whether a header tells one channel.
pub(super) fn recognises(table: &Table) -> bool {
    told(table).is_some()
}

/// Reads it.
pub(super) fn import(bytes: &[u8], name: &str) -> Result<ImportedRecording> {
    let table = Table::open(bytes, name)?;
    let Some(told) = told(&table) else {
        return Err(table.malformed(None, "one channel with its unit", &table.header_text()));
    };
    let column = table.name_of(told.column);
    let note = format!("column `{column}` is read as {}", quantity_name(told.field));
    let mapped = |column: usize, unit: Unit| MappedColumn {
        name: format!("#{}", column + 1),
        unit,
    };
    let columns = BTreeMap::from([
        ("t".to_owned(), mapped(told.time, told.time_unit)),
        (told.field.to_owned(), mapped(told.column, told.unit)),
    ]);
    let mut imported = import_table(table, &ColumnMapping { columns })?;
    imported.notes.push(note);
    Ok(imported)
}

/// A channel of a table.
struct Told {
    time: usize,
    time_unit: Unit,
    /// The field of a mapping.
    field: &'static str,
    column: usize,
    unit: Unit,
}

fn told(table: &Table) -> Option<Told> {
    let labels: Vec<Label> = (0..table.header().len())
        .map(|column| Label::of(table, column))
        .collect();
    let seconds = Unit {
        quantity: Dimension::Time,
        factor: 1.0,
    };
    let time_unit = |column: usize| {
        let stated = labels[column].time_factor();
        let bare = table.name_of(column).eq_ignore_ascii_case("t");
        stated
            .or(bare.then_some(1.0))
            .map(|factor| Unit { factor, ..seconds })
    };
    let mut times = (0..labels.len()).filter_map(|column| Some((column, time_unit(column)?)));
    let (Some((time, time_unit)), None) = (times.next(), times.next()) else {
        return None;
    };
    for field in ["angle", "y", "rate"] {
        let mut columns = labels.iter().enumerate().filter_map(|(column, label)| {
            let (told, unit) = label.channel()?;
            (column != time && told == field).then_some((column, unit))
        });
        match (columns.next(), columns.next()) {
            (Some((column, unit)), None) => {
                return Some(Told {
                    time,
                    time_unit,
                    field,
                    column,
                    unit,
                });
            }
            (Some(_), Some(_)) => return None,
            (None, _) => {}
        }
    }
    None
}
