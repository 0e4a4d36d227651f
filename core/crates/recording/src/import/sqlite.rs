//! Tables of a SQLite database, as Sensor Logger exports it: the documented file format, read only.
//!
//! Read are the pages of rowid tables (<https://www.sqlite.org/fileformat2.html>, sections 1.3, 1.6
//! and 2); indices, views and tables without rowid hold no samples. Text may be in UTF-8 or UTF-16.
//! Every place in the file is checked; a page that is met twice, or rows beyond what the file can
//! hold, end the reading with an error.

mod columns;

use std::collections::BTreeSet;

use super::json::quoted;
use columns::{Declared, declared};
use gyradius_base::{Error, Result};

/// The start of every database.
const MAGIC: &[u8] = b"SQLite format 3\0";
/// Bytes of the file's header, which stands before the first page's.
const HEADER: usize = 100;
/// Text that a database can become, times its own size: a float of eight bytes has up to 24
/// letters, and a whole number of none has one.
const MOST_TEXT: usize = 8;

pub(super) fn looks_like_sqlite(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC)
}

/// The tables of a database by name: `Gyroscope.csv` for the table `Gyroscope`.
pub(super) fn tables(bytes: &[u8], file: &str) -> Result<Vec<(String, Vec<u8>)>> {
    let damaged = |found: String| Error::Malformed {
        file: file.to_owned(),
        line: None,
        expected: "a whole SQLite database (copied while no program had it open, or exported)"
            .to_owned(),
        found,
    };
    let database = Database::of(bytes).map_err(damaged)?;
    let mut tables = Vec::new();
    for table in database.schema().map_err(damaged)? {
        let text = database.as_csv(&table).map_err(damaged)?;
        tables.push((format!("{}.csv", table.name), text));
    }
    if tables.is_empty() {
        // Until a program closes a database, what is new stands in the file beside it.
        let found = "no table; where a file `…-wal` lies beside it, open and close it with a program for databases";
        return Err(damaged(found.to_owned()));
    }
    Ok(tables)
}

/// What is wrong with the file.
type Read<T> = std::result::Result<T, String>;

/// A value of a row.
#[derive(Debug, Clone, PartialEq)]
enum Cell {
    Null,
    Integer(i64),
    Real(f64),
    Text(String),
    Blob,
}

/// A table that the database declares.
struct Stored {
    name: String,
    root: usize,
    columns: Declared,
}

struct Database<'a> {
    bytes: &'a [u8],
    page_size: usize,
    /// Bytes of a page that hold content.
    usable: usize,
    encoding: u32,
}

fn big_endian(bytes: &[u8]) -> u64 {
    bytes
        .iter()
        .fold(0, |all, byte| (all << 8) | u64::from(*byte))
}

impl<'a> Database<'a> {
    fn of(bytes: &'a [u8]) -> Read<Self> {
        let header = bytes.get(..HEADER).ok_or("fewer bytes than its header")?;
        let page_size = match big_endian(&header[16..18]) as usize {
            1 => 65536,
            other => other,
        };
        let usable = page_size.saturating_sub(usize::from(header[20]));
        if !page_size.is_power_of_two() || page_size < 512 || usable < 480 {
            return Err(format!("pages of {page_size} bytes"));
        }
        Ok(Self {
            bytes,
            page_size,
            usable,
            encoding: big_endian(&header[56..60]) as u32,
        })
    }

    /// A page by its number, from 1.
    fn page(&self, number: usize) -> Read<&'a [u8]> {
        let start = number
            .checked_sub(1)
            .and_then(|before| before.checked_mul(self.page_size));
        start
            .and_then(|start| self.bytes.get(start..)?.get(..self.page_size))
            .ok_or_else(|| format!("no page {number}, which it names"))
    }

    /// The tables with rowids, from the schema, which is the table on page 1.
    fn schema(&self) -> Read<Vec<Stored>> {
        let mut tables = Vec::new();
        self.each_row(1, &mut |_, cells| {
            let text = |at: usize| match cells.get(at) {
                Some(Cell::Text(text)) => text.as_str(),
                _ => "",
            };
            let Some(Cell::Integer(root)) = cells.get(3) else {
                return Ok(());
            };
            let columns = declared(text(4));
            let is_samples = text(0) == "table" && !text(1).starts_with("sqlite_");
            if let (true, Some(columns)) = (is_samples, columns) {
                tables.push(Stored {
                    name: text(1).to_owned(),
                    root: usize::try_from(*root).unwrap_or_default(),
                    columns,
                });
            }
            Ok(())
        })?;
        Ok(tables)
    }

    fn as_csv(&self, table: &Stored) -> Read<Vec<u8>> {
        let names: Vec<String> = table
            .columns
            .names
            .iter()
            .map(|name| quoted(name))
            .collect();
        let mut out = names.join(",");
        out.push('\n');
        let most = MOST_TEXT.saturating_mul(self.bytes.len());
        self.each_row(table.root, &mut |rowid, cells| {
            for column in 0..names.len() {
                if column > 0 {
                    out.push(',');
                }
                let is_rowid = table.columns.rowid == Some(column);
                match cells.get(column) {
                    // The column that names the row is not stored twice.
                    Some(Cell::Null) if is_rowid => out.push_str(&rowid.to_string()),
                    Some(Cell::Integer(value)) => out.push_str(&value.to_string()),
                    Some(Cell::Real(value)) => out.push_str(&format!("{value:?}")),
                    Some(Cell::Text(text)) => out.push_str(&quoted(text)),
                    // A column that was added later is missing from older rows.
                    Some(Cell::Null | Cell::Blob) | None => {}
                }
            }
            out.push('\n');
            if out.len() > most {
                return Err("more rows than it can hold".to_owned());
            }
            Ok(())
        })?;
        Ok(out.into_bytes())
    }

    /// Visits the rows of a table in the order of their rowids.
    fn each_row(&self, root: usize, visit: &mut dyn FnMut(i64, &[Cell]) -> Read<()>) -> Read<()> {
        let mut pages = vec![root];
        let mut seen = BTreeSet::new();
        // No byte belongs to two rows.
        let mut unread = self.bytes.len();
        while let Some(number) = pages.pop() {
            if !seen.insert(number) {
                return Err(format!("page {number} twice in one table"));
            }
            let page = self.page(number)?;
            let header = page
                .get(if number == 1 { HEADER } else { 0 }..)
                .unwrap_or_default();
            let count = big_endian(&header[3..5]) as usize;
            let pointers = |at: usize| {
                let cells = header.get(at..at + 2 * count).ok_or("a page cut short")?;
                Ok::<_, String>(cells.chunks_exact(2).map(|two| big_endian(two) as usize))
            };
            match header[0] {
                0x0D => {
                    for cell in pointers(8)? {
                        let (rowid, payload) = self.payload(page, cell)?;
                        unread = unread
                            .checked_sub(payload.len())
                            .ok_or("more rows than it can hold")?;
                        visit(rowid, &self.record(&payload)?)?;
                    }
                }
                0x05 => {
                    // The last child first: pages are taken from the end.
                    pages.push(big_endian(&header[8..12]) as usize);
                    let children: Vec<usize> = pointers(12)?
                        .map(|cell| page.get(cell..cell + 4).map(|at| big_endian(at) as usize))
                        .collect::<Option<_>>()
                        .ok_or("a page cut short")?;
                    pages.extend(children.into_iter().rev());
                }
                other => return Err(format!("a page of kind {other} in a table")),
            }
        }
        Ok(())
    }

    /// Rowid and content of a row, with what stands on pages of its own.
    fn payload(&self, page: &[u8], cell: usize) -> Read<(i64, Vec<u8>)> {
        let mut rest = page.get(cell..self.usable).unwrap_or_default();
        let length = varint(&mut rest)? as usize;
        let rowid = varint(&mut rest)?;
        if length > self.bytes.len() {
            return Err(format!("a row of {length} bytes"));
        }
        let most = self.usable - 35;
        let least = (self.usable - 12) * 32 / 255 - 23;
        let here = match least + length.saturating_sub(least) % (self.usable - 4) {
            _ if length <= most => length,
            part if part <= most => part,
            _ => least,
        };
        let mut payload = rest.get(..here).ok_or("a row cut short")?.to_vec();
        let mut next = match length > here {
            true => big_endian(rest.get(here..here + 4).ok_or("a row cut short")?),
            false => 0,
        };
        while payload.len() < length {
            let page = self.page(next as usize)?;
            let part = (length - payload.len()).min(self.usable - 4);
            payload.extend(&page[4..4 + part]);
            next = big_endian(&page[..4]);
        }
        Ok((rowid, payload))
    }

    /// The values of a row.
    fn record(&self, payload: &[u8]) -> Read<Vec<Cell>> {
        let mut types = payload;
        let header = varint(&mut types)? as usize;
        let read = payload.len() - types.len();
        types = payload.get(read..header).ok_or("a row cut short")?;
        let mut values = payload.get(header..).unwrap_or_default();
        let mut cells = Vec::new();
        while !types.is_empty() {
            let kind = varint(&mut types)?;
            cells.push(self.cell(kind, &mut values)?);
        }
        Ok(cells)
    }

    fn cell(&self, kind: i64, values: &mut &[u8]) -> Read<Cell> {
        let length = match kind {
            0 | 8 | 9 => 0,
            1..=4 => kind as usize,
            5 => 6,
            6 | 7 => 8,
            12.. => usize::try_from((kind - 12) / 2).unwrap_or(usize::MAX),
            _ => return Err(format!("a value of kind {kind}")),
        };
        let (bytes, rest) = values.split_at_checked(length).ok_or("a row cut short")?;
        *values = rest;
        Ok(match kind {
            0 => Cell::Null,
            7 => Cell::Real(f64::from_bits(big_endian(bytes))),
            8 => Cell::Integer(0),
            9 => Cell::Integer(1),
            1..=6 => {
                // Two's complement of so many bytes.
                let unused = 64 - 8 * length as u32;
                Cell::Integer((big_endian(bytes) << unused) as i64 >> unused)
            }
            _ if kind % 2 == 1 => Cell::Text(self.text(bytes)),
            _ => Cell::Blob,
        })
    }

    fn text(&self, bytes: &[u8]) -> String {
        let wide = |unit: fn([u8; 2]) -> u16| {
            let units: Vec<u16> = bytes
                .chunks_exact(2)
                .map(|two| unit([two[0], two[1]]))
                .collect();
            String::from_utf16_lossy(&units)
        };
        match self.encoding {
            2 => wide(u16::from_le_bytes),
            3 => wide(u16::from_be_bytes),
            _ => String::from_utf8_lossy(bytes).into_owned(),
        }
    }
}

/// A number of one to nine bytes, seven bits each but for the ninth.
fn varint(rest: &mut &[u8]) -> Read<i64> {
    let mut all: u64 = 0;
    for place in 0..9 {
        let (byte, after) = rest.split_first().ok_or("a number cut short")?;
        *rest = after;
        if place == 8 {
            return Ok(((all << 8) | u64::from(*byte)) as i64);
        }
        all = (all << 7) | u64::from(byte & 0x7F);
        if byte & 0x80 == 0 {
            break;
        }
    }
    Ok(all as i64)
}
