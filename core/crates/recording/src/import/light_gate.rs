//! The event log of a two-gate timer: one row per beam edge.

use super::columns::columns_not_used;
use super::imported::{Format, ImportedData, ImportedRecording};
use super::table::Table;
use crate::samples::GateEvents;
use gyradius_base::Result;

/// Reads a log with `Time` (or `Event Time`), `State at A` and `State at B`; a row of units may
/// follow the header.
pub(super) fn import(bytes: &[u8], name: &str) -> Result<ImportedRecording> {
    let table = Table::open(bytes, name)?;
    let find = |wanted: &str| table.find(|column| column.eq_ignore_ascii_case(wanted));
    let missing = |column: &str| {
        table.malformed(
            Some(0),
            &format!("a column `{column}`"),
            &format!("`{}`", table.header_text()),
        )
    };
    // `Time` carries more digits than `Event Time`.
    let time = find("Time")
        .or_else(|| find("Event Time"))
        .ok_or_else(|| missing("Time"))?;
    let a = find("State at A").ok_or_else(|| missing("State at A"))?;
    let b = find("State at B").ok_or_else(|| missing("State at B"))?;
    let numbers = table.numbers(&[time, a, b])?;
    let mut events = GateEvents::default();
    let mut dropped = 0;
    for (row, &offset) in numbers.offset.iter().enumerate() {
        let state = |column: usize| match numbers.cells[column][row] {
            Some(0.0) => Ok(false),
            Some(1.0) => Ok(true),
            _ => Err(table.malformed(Some(offset), "a gate's state 0 or 1", "something else")),
        };
        let (a, b) = (state(1)?, state(2)?);
        let t_s = numbers.cells[0][row].filter(|t| t.is_finite());
        let t_s =
            t_s.ok_or_else(|| table.malformed(Some(offset), "the time of an edge", "no number"))?;
        if events.t_s.last().is_some_and(|last| t_s < *last) {
            dropped += 1;
            continue;
        }
        events.t_s.push(t_s);
        events.a.push(a);
        events.b.push(b);
    }
    if events.t_s.len() < 2 {
        return Err(table.malformed(None, "at least two edges", &events.t_s.len().to_string()));
    }
    let mut notes = Vec::new();
    if dropped > 0 {
        notes.push(format!(
            "{dropped} edges step back in time and are left out"
        ));
    }
    // `Event Time` is `Time` with fewer digits.
    let events_time = find("Event Time");
    let left = columns_not_used(&table, [time, a, b].into_iter().chain(events_time));
    let data = ImportedData::GateEvents(events);
    Ok(ImportedRecording::of(name, Format::LightGate, data, notes).without(left))
}
