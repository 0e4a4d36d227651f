//! Delimited tables with a header, read by column: the common ground of every recording and export.
//!
//! # Conventions
//! An empty cell is `None` (no sample); `NaN` and `inf` are `Some` and left to the repairs. Lines
//! count from 1 in the file as it stands, blank lines included.

use csv::{ByteRecord, Reader, ReaderBuilder};

use gyradius_base::{Error, Result};

/// A file whose header has been read and whose rows are read column by column on demand.
pub struct Table<'a> {
    file: &'a str,
    bytes: &'a [u8],
    separator: u8,
    mark: Option<u8>,
    header: Vec<String>,
}

/// The chosen columns of all rows.
pub(crate) struct Columns {
    /// Byte offset of each row, from which an error finds its line.
    pub offset: Vec<usize>,
    /// `cells[column][row]`.
    pub cells: Vec<Vec<Option<f64>>>,
}

impl<'a> Table<'a> {
    /// A table with `,` and `.`, as the project's own recordings are.
    pub fn native(bytes: &'a [u8], file: &'a str) -> Result<Self> {
        Self::with_separator(bytes, file, b',', Some(b'.'))
    }

    /// A table whose separator is read off its header and whose decimal mark off its first number
    /// that has one.
    pub fn open(bytes: &'a [u8], file: &'a str) -> Result<Self> {
        Self::with_separator(bytes, file, separator_of(bytes), None)
    }

    fn with_separator(
        bytes: &'a [u8],
        file: &'a str,
        separator: u8,
        mark: Option<u8>,
    ) -> Result<Self> {
        let bytes = text_bytes(bytes, file)?;
        let mut table = Self {
            file,
            bytes,
            separator,
            mark,
            header: Vec::new(),
        };
        let mut record = ByteRecord::new();
        if !table.next(&mut table.reader(), &mut record)? {
            return Err(table.malformed(None, "a header and rows", "an empty file"));
        }
        table.header = record
            .iter()
            .map(|cell| String::from_utf8_lossy(cell).trim().to_owned())
            .collect();
        while table.header.last().is_some_and(String::is_empty) {
            table.header.pop();
        }
        Ok(table)
    }

    /// Column names, trimmed; nameless columns at the end are left out.
    pub fn header(&self) -> &[String] {
        &self.header
    }

    /// The header as one text, for messages.
    pub fn header_text(&self) -> String {
        clipped(&self.header.join(","), 200)
    }

    /// The file as the user knows it.
    pub fn file(&self) -> &'a str {
        self.file
    }

    /// Number of the first column whose name satisfies `wanted`.
    pub fn find(&self, wanted: impl Fn(&str) -> bool) -> Option<usize> {
        self.header.iter().position(|name| wanted(name))
    }

    /// The cells of the given columns as numbers.
    pub fn numbers(&self, columns: &[usize]) -> Result<Columns> {
        self.numbers_after(columns, 0)
    }

    /// The same, with `skipped` rows between header and data (units, for example).
    pub fn numbers_after(&self, columns: &[usize], skipped: usize) -> Result<Columns> {
        let mut out = Columns {
            offset: Vec::new(),
            cells: vec![Vec::new(); columns.len()],
        };
        let mut mark = self.mark;
        let needed = columns.iter().max().map_or(0, |last| last + 1);
        let mut short: Option<(usize, usize)> = None;
        self.each_row(skipped, |offset, record| {
            if let Some((offset, cells)) = short {
                return Err(self.ragged(offset, cells));
            }
            if record.len() < needed {
                // Only the last row may be short: the app was killed while writing it.
                short = Some((offset, record.len()));
            }
            if record
                .iter()
                .skip(self.header.len())
                .any(|cell| !cell.trim_ascii().is_empty())
            {
                return Err(self.ragged(offset, record.len()));
            }
            for (cells, &column) in out.cells.iter_mut().zip(columns) {
                let cell = record.get(column).unwrap_or_default();
                cells.push(
                    number(cell, &mut mark)
                        .map_err(|()| self.not_a_number(offset, column, cell))?,
                );
            }
            out.offset.push(offset);
            Ok(())
        })?;
        Ok(out)
    }

    /// All rows as texts, for the small tables that exports carry beside their samples.
    pub fn texts(&self) -> Result<Vec<Vec<String>>> {
        let mut rows = Vec::new();
        self.each_row(0, |_, record| {
            rows.push(
                record
                    .iter()
                    .map(|cell| String::from_utf8_lossy(cell).trim().to_owned())
                    .collect(),
            );
            Ok(())
        })?;
        Ok(rows)
    }

    /// One column of all rows as texts, row by row as [`Table::numbers`] counts them.
    pub fn texts_of(&self, column: usize) -> Result<Vec<String>> {
        let mut cells = Vec::new();
        self.each_row(0, |_, record| {
            cells.push(
                String::from_utf8_lossy(record.get(column).unwrap_or_default())
                    .trim()
                    .to_owned(),
            );
            Ok(())
        })?;
        Ok(cells)
    }

    /// True where the row after the header holds no number in `column`: a row of units.
    pub fn row_after_header_is_text(&self, column: usize) -> Result<bool> {
        let mut reader = self.reader();
        let mut record = ByteRecord::new();
        self.next(&mut reader, &mut record)?;
        let there = self.next(&mut reader, &mut record)?;
        Ok(there && number(record.get(column).unwrap_or_default(), &mut None).is_err())
    }

    fn each_row(
        &self,
        skipped: usize,
        mut visit: impl FnMut(usize, &ByteRecord) -> Result<()>,
    ) -> Result<()> {
        let mut reader = self.reader();
        let mut record = ByteRecord::new();
        for _ in 0..=skipped {
            self.next(&mut reader, &mut record)?;
        }
        while self.next(&mut reader, &mut record)? {
            let offset = record.position().map_or(0, |at| at.byte() as usize);
            if record.iter().any(|cell| !cell.trim_ascii().is_empty()) {
                visit(offset, &record)?;
            }
        }
        Ok(())
    }

    fn reader(&self) -> Reader<&'a [u8]> {
        ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .delimiter(self.separator)
            .from_reader(self.bytes)
    }

    fn next(&self, reader: &mut Reader<&'a [u8]>, record: &mut ByteRecord) -> Result<bool> {
        reader
            .read_byte_record(record)
            .map_err(|e| Error::Unreadable {
                file: self.file.to_owned(),
                reason: e.to_string(),
            })
    }

    fn not_a_number(&self, offset: usize, column: usize, cell: &[u8]) -> Error {
        let name = self.header.get(column).map_or("", String::as_str);
        let found = clipped(&String::from_utf8_lossy(cell), 40);
        self.malformed(
            Some(offset),
            &format!("a number in column `{name}`"),
            &format!("`{found}`"),
        )
    }

    fn ragged(&self, offset: usize, cells: usize) -> Error {
        let expected = format!("{} cells, as in the header", self.header.len());
        self.malformed(Some(offset), &expected, &format!("{cells}"))
    }

    /// An error at the row that starts at `offset`, or about the file as a whole.
    pub fn malformed(&self, offset: Option<usize>, expected: &str, found: &str) -> Error {
        Error::Malformed {
            file: self.file.to_owned(),
            line: offset.map(|at| self.line_at(at)),
            expected: expected.to_owned(),
            found: found.to_owned(),
        }
    }

    /// Line of the row that the reader met from `offset` on; terminators before the row belong to
    /// it.
    pub fn line_at(&self, offset: usize) -> usize {
        let rest = self.bytes.get(offset..).unwrap_or_default();
        let blank = rest
            .iter()
            .take_while(|&&b| b == b'\r' || b == b'\n')
            .count();
        let before = &self.bytes[..(offset + blank).min(self.bytes.len())];
        let bare_returns = before
            .windows(2)
            .filter(|pair| pair[0] == b'\r' && pair[1] != b'\n')
            .count();
        1 + before.iter().filter(|&&b| b == b'\n').count() + bare_returns
    }
}

/// The bytes after a byte order mark; spreadsheets and other encodings are refused by name.
fn text_bytes<'a>(bytes: &'a [u8], file: &str) -> Result<&'a [u8]> {
    let refused = |found: &str| {
        Err(Error::Malformed {
            file: file.to_owned(),
            line: None,
            expected: "comma-separated text (export as CSV)".to_owned(),
            found: found.to_owned(),
        })
    };
    match bytes {
        [0xD0, 0xCF, 0x11, 0xE0, ..] => refused("an Excel workbook (xls)"),
        [b'P', b'K', 3 | 5, 4 | 6, ..] => refused("a zip archive or an Excel workbook (xlsx)"),
        [0xFF, 0xFE, ..] | [0xFE, 0xFF, ..] => refused("UTF-16 text; save it as UTF-8"),
        [0xEF, 0xBB, 0xBF, rest @ ..] => Ok(rest),
        _ => Ok(bytes),
    }
}

/// The separator that the header uses outside quotes. TAB, `;` and `|` never stand in a column
/// name.
fn separator_of(bytes: &[u8]) -> u8 {
    let is_end = |b: &u8| *b == b'\n' || *b == b'\r';
    let line = bytes
        .split(is_end)
        .find(|line| !line.trim_ascii().is_empty())
        .unwrap_or_default();
    let mut quoted = false;
    let mut bare = line.iter().copied().filter(|&b| {
        quoted ^= b == b'"';
        !quoted
    });
    bare.find(|b| matches!(b, b'\t' | b';' | b'|'))
        .unwrap_or(b',')
}

/// A cell as a number. The first decimal mark met holds for the rest of the file.
fn number(cell: &[u8], mark: &mut Option<u8>) -> std::result::Result<Option<f64>, ()> {
    let cell = cell.trim_ascii();
    if cell.is_empty() {
        return Ok(None);
    }
    let found = cell.iter().copied().find(|b| matches!(b, b'.' | b','));
    if let Some(found) = found
        && *mark.get_or_insert(found) != found
    {
        return Err(());
    }
    let text = std::str::from_utf8(cell).map_err(|_| ())?;
    let value = if found == Some(b',') {
        text.replacen(',', ".", 1).parse()
    } else {
        text.parse()
    };
    value.map(Some).map_err(|_| ())
}

/// The first `length` characters, for messages about damaged files.
pub(crate) fn clipped(text: &str, length: usize) -> String {
    match text.char_indices().nth(length) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}
