//! The sheets of an Excel workbook (xlsx), as phyphox exports it: one a set, two for `meta`.

use std::io::Cursor;
use std::panic::{AssertUnwindSafe, catch_unwind};

use calamine::{DataRef, Reader, SheetType, Xlsx, open_workbook_from_rs};

use super::json::quoted;
use crate::store::Store;
use gyradius_base::{Error, Result};

/// Columns of a sheet that is read; more are no table of samples.
const MOST_COLUMNS: usize = 1000;
/// Cells of a sheet that is read, empty ones included: ten hours of a phone's samples.
const MOST_CELLS: usize = 50_000_000;

/// True for the members of an archive that is a workbook.
pub(super) fn is_workbook(members: &[String]) -> bool {
    members
        .iter()
        .any(|member| member == "[Content_Types].xml" || member.starts_with("xl/"))
}

/// The sheets by name: `Gyroscope.csv` for the sheet `Gyroscope`.
pub(super) fn tables(bytes: &[u8], file: &str) -> Result<Vec<(String, Vec<u8>)>> {
    // The same limits as for any archive: the workbook's reader has none.
    Store::from_zip_bytes(file, bytes)?;
    // A damaged workbook must not take the program with it.
    let read = catch_unwind(AssertUnwindSafe(|| sheets(bytes)));
    let read = read.unwrap_or_else(|_| Err("its sheets are damaged".to_owned()));
    read.map_err(|reason| Error::Unreadable {
        file: file.to_owned(),
        reason: format!("not an Excel workbook that can be read ({reason}); export as CSV"),
    })
}

fn sheets(bytes: &[u8]) -> std::result::Result<Vec<(String, Vec<u8>)>, String> {
    let mut workbook: Xlsx<_> = open_workbook_from_rs(Cursor::new(bytes))
        .map_err(|e: calamine::XlsxError| e.to_string())?;
    let mut tables = Vec::new();
    let sheets = workbook.sheets_metadata().iter();
    let names: Vec<String> = sheets
        .filter(|sheet| sheet.typ == SheetType::WorkSheet)
        .map(|sheet| sheet.name.clone())
        .collect();
    for name in names {
        let mut cells = workbook
            .worksheet_cells_reader(&name)
            .map_err(|e| e.to_string())?;
        let mut rows: Vec<Row> = Vec::new();
        while let Some(cell) = cells.next_cell().map_err(|e| e.to_string())? {
            let (number, column) = cell.get_position();
            let column = column as usize;
            if column >= MOST_COLUMNS {
                return Err(format!(
                    "sheet `{name}` has more than {MOST_COLUMNS} columns"
                ));
            }
            if rows.last().is_none_or(|row| row.number != number) {
                rows.push(Row {
                    number,
                    ..Row::default()
                });
            }
            if let Some(row) = rows.last_mut() {
                row.go_to(column)?;
                row.text.push_str(&text_of(cell.get_value()));
            }
        }
        // Cells are left out at the end of a row as anywhere.
        let last = rows.iter().filter_map(|row| row.last).max().unwrap_or(0);
        if rows.len().saturating_mul(last) > MOST_CELLS {
            return Err(format!("sheet `{name}` has more than {MOST_CELLS} cells"));
        }
        let mut out = String::new();
        for mut row in rows {
            if row.last < Some(last) {
                row.go_to(last)?;
            }
            out.push_str(&row.text);
            out.push('\n');
        }
        tables.push((format!("{name}.csv"), out.into_bytes()));
    }
    Ok(tables)
}

/// A row as far as it is read.
#[derive(Default)]
struct Row {
    number: u32,
    /// Column of the last cell.
    last: Option<usize>,
    text: String,
}

impl Row {
    /// Empty cells up to a column, which is beyond the last.
    fn go_to(&mut self, column: usize) -> std::result::Result<(), &'static str> {
        if self.last >= Some(column) {
            return Err("cells out of order");
        }
        let commas = column - self.last.unwrap_or(0);
        self.text.extend(std::iter::repeat_n(',', commas));
        self.last = Some(column);
        Ok(())
    }
}

fn text_of(value: &DataRef) -> String {
    match value {
        DataRef::Int(value) => value.to_string(),
        DataRef::Float(value) => format!("{value:?}"),
        DataRef::String(text) | DataRef::DateTimeIso(text) | DataRef::DurationIso(text) => {
            quoted(text)
        }
        DataRef::SharedString(text) => quoted(text),
        DataRef::Bool(value) => value.to_string(),
        DataRef::DateTime(time) if time.is_duration() => (86_400.0 * time.as_f64()).to_string(),
        DataRef::DateTime(time) => {
            let (year, month, day, hour, minute, second, milli) = time.to_ymd_hms_milli();
            format!("{year:04}-{month:02}-{day:02} {hour:02}:{minute:02}:{second:02}.{milli:03}")
        }
        DataRef::Error(_) | DataRef::Empty => String::new(),
    }
}
