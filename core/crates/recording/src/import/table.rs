//! Delimited tables with a header, read by column: the common ground of every recording and export.
//!
//! # Conventions
//! An empty cell is `None` (no sample); `NaN` and `inf` are `Some` and left to the repairs. Lines
//! count from 1 in the file as it stands, blank lines included.

use std::borrow::Cow;

use csv::{ByteRecord, Reader, ReaderBuilder};

use super::layout;
use gyradius_base::{Error, Result};

/// A file whose header has been read and whose rows are read column by column on demand.
pub struct Table<'a> {
    file: &'a str,
    bytes: Cow<'a, [u8]>,
    separator: u8,
    comment: Option<u8>,
    mark: Option<u8>,
    /// Whether it is the project's own: then every line must be a row.
    is_native: bool,
    header: Vec<String>,
    units: Vec<String>,
    preamble: Vec<String>,
    named: bool,
    header_at: usize,
    rows_at: usize,
}

/// The chosen columns of the chosen rows.
pub(crate) struct Columns {
    /// Number of each row in the table.
    pub row: Vec<usize>,
    /// Byte offset of each row, from which an error finds its line.
    pub offset: Vec<usize>,
    /// `cells[column][row]`.
    pub cells: Vec<Vec<Option<f64>>>,
}

/// Rows whose cell in a column has a certain text.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tag {
    pub column: usize,
    pub text: String,
}

impl<'a> Table<'a> {
    /// A table with `,` and `.` and its header in the first line, as the project's own recordings
    /// are.
    pub fn native(bytes: &'a [u8], file: &'a str) -> Result<Self> {
        let mut table = Self {
            file,
            bytes: text_bytes(bytes, file)?,
            separator: b',',
            comment: None,
            mark: Some(b'.'),
            is_native: true,
            header: Vec::new(),
            units: Vec::new(),
            preamble: Vec::new(),
            named: true,
            header_at: 0,
            rows_at: 0,
        };
        let mut reader = table.reader();
        let mut record = ByteRecord::new();
        if !table.next(&mut reader, &mut record)? {
            return Err(table.empty());
        }
        let rows_at = reader.position().byte() as usize;
        drop(reader);
        table.rows_at = rows_at;
        table.header = record
            .iter()
            .map(|cell| String::from_utf8_lossy(cell).trim().to_owned())
            .collect();
        while table.header.last().is_some_and(String::is_empty) {
            table.header.pop();
        }
        Ok(table)
    }

    /// A table as people have it ([`layout`]): header and rows are found below a preamble, the
    /// separator is read off the rows, the decimal mark off the first number that has one.
    pub fn open(bytes: &'a [u8], file: &'a str) -> Result<Self> {
        let (bytes, layout) = layout::find(text_bytes(bytes, file)?);
        let found = layout.is_some();
        let layout = layout.unwrap_or_default();
        let table = Self {
            file,
            bytes,
            separator: layout.separator,
            comment: layout.comment,
            mark: None,
            is_native: false,
            header: layout.header,
            units: layout.units,
            preamble: layout.preamble,
            named: layout.named,
            header_at: layout.header_at,
            rows_at: layout.rows_at,
        };
        if found { Ok(table) } else { Err(table.empty()) }
    }

    fn empty(&self) -> Error {
        self.malformed(None, "a header and rows", "an empty file")
    }

    /// Lines above the header.
    pub fn preamble(&self) -> &[String] {
        &self.preamble
    }

    /// False where the columns have numbers instead of names.
    pub fn is_named(&self) -> bool {
        self.named
    }

    /// The unit of a column by the row of units below the header.
    pub fn unit(&self, column: usize) -> Option<&str> {
        let unit = self.units.get(column)?.trim_matches(['(', ')', '[', ']']);
        (!unit.is_empty()).then_some(unit)
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

    /// The name of a column, for messages.
    pub fn name_of(&self, column: usize) -> String {
        self.header.get(column).cloned().unwrap_or_default()
    }

    /// Number of the first column whose name satisfies `wanted`.
    pub fn find(&self, wanted: impl Fn(&str) -> bool) -> Option<usize> {
        self.header.iter().position(|name| wanted(name))
    }

    /// The cells of the given columns as numbers.
    pub fn numbers(&self, columns: &[usize]) -> Result<Columns> {
        self.numbers_of(columns, None)
    }

    /// The same of the rows that have a tag.
    pub(super) fn numbers_of(&self, columns: &[usize], tag: Option<&Tag>) -> Result<Columns> {
        let mut out = Columns {
            row: Vec::new(),
            offset: Vec::new(),
            cells: vec![Vec::new(); columns.len()],
        };
        let mut mark = self.mark;
        let needed = columns.iter().max().map_or(0, |last| last + 1);
        let mut short: Option<(usize, usize)> = None;
        let mut no_row: Option<Error> = None;
        self.each_row(tag, |row, offset, record| {
            if let Some((offset, cells)) = short {
                return Err(self.ragged(offset, cells));
            }
            if let Some(error) = no_row.take() {
                return Err(error);
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
            let mut numbers = Vec::with_capacity(columns.len());
            for &column in columns {
                let cell = record.get(column).unwrap_or_default();
                match number(cell, &mut mark) {
                    Ok(number) => numbers.push(number),
                    Err(()) => {
                        // Only the last line may be no row: what a logger writes when it stops.
                        no_row = Some(self.not_a_number(offset, column, cell));
                        if self.is_native || is_row(record) || out.row.is_empty() {
                            return no_row.take().map_or(Ok(()), Err);
                        }
                        return Ok(());
                    }
                }
            }
            for (cells, number) in out.cells.iter_mut().zip(numbers) {
                cells.push(number);
            }
            out.row.push(row);
            out.offset.push(offset);
            Ok(())
        })?;
        Ok(out)
    }

    /// All rows as texts, for the small tables that exports carry beside their samples.
    pub fn texts(&self) -> Result<Vec<Vec<String>>> {
        let mut rows = Vec::new();
        self.each_row(None, |_, _, record| {
            rows.push(record.iter().map(text_of).collect());
            Ok(())
        })?;
        Ok(rows)
    }

    /// One column of all rows as texts, row by row as [`Table::numbers`] counts them.
    pub fn texts_of(&self, column: usize) -> Result<Vec<String>> {
        self.tagged_texts(column, None)
    }

    /// One column as texts, of the rows that have a tag.
    pub(super) fn tagged_texts(&self, column: usize, tag: Option<&Tag>) -> Result<Vec<String>> {
        let mut cells = Vec::new();
        self.each_row(tag, |_, _, record| {
            cells.push(text_of(record.get(column).unwrap_or_default()));
            Ok(())
        })?;
        Ok(cells)
    }

    /// What separates the cells.
    pub(super) fn separator(&self) -> u8 {
        self.separator
    }

    /// What a line begins with that is a comment.
    pub(super) fn comment_mark(&self) -> Option<char> {
        self.comment.map(char::from)
    }

    /// The lines from the first row on that are not blank, each with its place.
    pub(super) fn lines_below(&self) -> impl Iterator<Item = (usize, Cow<'_, str>)> {
        let mut at = self.rows_at;
        let rows = self.bytes.get(at..).unwrap_or_default();
        let lines = rows.split_inclusive(|b| matches!(b, b'\n' | b'\r'));
        let placed = lines.map(move |line| {
            let start = at;
            at += line.len();
            (start, String::from_utf8_lossy(line.trim_ascii()))
        });
        placed.filter(|(_, line)| !line.trim_matches(char::from(self.separator)).is_empty())
    }

    /// The text, and where its header starts.
    pub(super) fn text(&self) -> (&[u8], usize) {
        (&self.bytes, self.header_at)
    }

    /// The file with some columns alone, by these names; lines keep their numbers.
    pub(super) fn with_columns(&self, columns: &[usize], names: &[String]) -> Result<Vec<u8>> {
        let written = |cell: &[u8]| {
            let has_separator = cell.contains(&self.separator);
            let quote: &[u8] = if has_separator { b"\"" } else { b"" };
            [quote, cell, quote].concat()
        };
        let line = |cells: &mut dyn Iterator<Item = &[u8]>| {
            cells.map(written).collect::<Vec<_>>().join(&self.separator)
        };
        let ends = |from: usize, to: usize| {
            let between = self.bytes.get(from..to).unwrap_or_default();
            between.iter().filter(|b| **b == b'\n').count()
        };
        let mut out = self.bytes[..self.header_at].to_vec();
        out.extend(line(&mut names.iter().map(|name| name.as_bytes())));
        let mut at = self.header_at;
        self.each_row(None, |_, offset, record| {
            // The reader may meet blank lines before the row.
            out.extend(std::iter::repeat_n(b'\n', ends(at, offset).max(1)));
            at = offset;
            let cell = |column: &usize| record.get(*column).unwrap_or_default().trim_ascii();
            let mut cells = columns.iter().map(cell);
            if cells.clone().any(|cell| !cell.is_empty()) {
                out.extend(line(&mut cells));
            }
            Ok(())
        })?;
        out.push(b'\n');
        Ok(out)
    }

    /// The file with the rows that are not wanted left blank, so that lines keep their numbers.
    pub(super) fn with_rows(&self, wanted: impl Fn(usize) -> bool) -> Result<Vec<u8>> {
        let mut starts = Vec::new();
        self.each_row(None, |row, offset, _| {
            starts.push((row, offset));
            Ok(())
        })?;
        let mut bytes = self.bytes.to_vec();
        let ends = starts.iter().skip(1).map(|(_, offset)| *offset);
        let ends = ends.chain([bytes.len()]).collect::<Vec<_>>();
        for ((row, start), end) in starts.into_iter().zip(ends) {
            if let Some(text) = bytes.get_mut(start..end).filter(|_| !wanted(row)) {
                let rewritten = text.iter_mut().filter(|b| !matches!(**b, b'\n' | b'\r'));
                rewritten.for_each(|b| *b = self.separator);
            }
        }
        Ok(bytes)
    }

    pub(super) fn each_row(
        &self,
        tag: Option<&Tag>,
        mut visit: impl FnMut(usize, usize, &ByteRecord) -> Result<()>,
    ) -> Result<()> {
        let mut reader = self.reader();
        let mut record = ByteRecord::new();
        let mut row = 0;
        while self.next(&mut reader, &mut record)? {
            let offset = self.rows_at + record.position().map_or(0, |at| at.byte() as usize);
            if self.swallows_rows(&record) {
                let expected = "a quote that is closed before the next row begins";
                return Err(self.malformed(Some(offset), expected, "a quote left open"));
            }
            if record.iter().all(|cell| cell.trim_ascii().is_empty()) {
                continue;
            }
            let has = |tag: &Tag| {
                let cell = record.get(tag.column).unwrap_or_default();
                cell.trim_ascii() == tag.text.as_bytes()
            };
            if tag.is_none_or(has) {
                visit(row, offset, &record)?;
            }
            row += 1;
        }
        Ok(())
    }

    /// For each row, the blank lines that stand between the rows before it: frames in which nothing was
    /// seen. Where every other line or more are blank they are nothing but space, and none counts.
    pub(super) fn blank_rows(&self, offsets: &[usize]) -> Vec<usize> {
        let is_blank = |line: &[u8]| {
            let mut bytes = line.iter();
            bytes.all(|b| *b == self.separator || b.is_ascii_whitespace())
        };
        let between = |pair: &[usize]| {
            let text = self.bytes.get(pair[0]..pair[1]).unwrap_or_default();
            let end = if text.contains(&b'\n') { b'\n' } else { b'\r' };
            // What follows the last end is the row's own line, and so is the line that is filled.
            let lines = text.split(|b| *b == end);
            lines
                .filter(|line| is_blank(line))
                .count()
                .saturating_sub(1)
        };
        let mut blank = vec![0; offsets.len()];
        let starts: Vec<usize> = offsets.iter().map(|at| self.text_at(*at)).collect();
        for (i, pair) in starts.windows(2).enumerate() {
            blank[i + 1] = blank[i] + between(pair);
        }
        let last = blank.last().copied().unwrap_or(0);
        if last + 1 < offsets.len() {
            blank
        } else {
            vec![0; offsets.len()]
        }
    }

    /// Where the text of a row begins that the reader met from `offset` on.
    fn text_at(&self, offset: usize) -> usize {
        let rest = self.bytes.get(offset..).unwrap_or_default();
        let ends = rest.iter().take_while(|b| matches!(b, b'\r' | b'\n'));
        offset + ends.count()
    }

    /// Whether a quoted cell runs on over lines that are rows themselves: its quote was left open.
    fn swallows_rows(&self, record: &ByteRecord) -> bool {
        let is_row = |line: &str| layout::is_row(&layout::cells(line, self.separator));
        let runs_on = |cell: &[u8]| {
            let text = String::from_utf8_lossy(cell);
            text.split(['\n', '\r']).skip(1).any(is_row)
        };
        let has_end = |bytes: &[u8]| bytes.iter().any(|b| matches!(b, b'\n' | b'\r'));
        has_end(record.as_slice()) && record.iter().any(runs_on)
    }

    fn reader(&self) -> Reader<&[u8]> {
        ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .delimiter(self.separator)
            .comment(self.comment)
            .from_reader(self.bytes.get(self.rows_at..).unwrap_or_default())
    }

    fn next(&self, reader: &mut Reader<&[u8]>, record: &mut ByteRecord) -> Result<bool> {
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
            line: offset.map(|at| self.line_at(at.max(self.header_at))),
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

fn text_of(cell: &[u8]) -> String {
    String::from_utf8_lossy(cell).trim().to_owned()
}

/// The bytes after a byte order mark, as UTF-8; what is no text is refused by name, with the way
/// out.
fn text_bytes<'a>(bytes: &'a [u8], file: &str) -> Result<Cow<'a, [u8]>> {
    let refused = |found: &str| {
        Err(Error::Malformed {
            file: file.to_owned(),
            line: None,
            expected: "comma-separated text (export as CSV)".to_owned(),
            found: found.to_owned(),
        })
    };
    let wide = |rest: &[u8], unit: fn([u8; 2]) -> u16| {
        let units = rest.chunks_exact(2).map(|pair| unit([pair[0], pair[1]]));
        let text: String = char::decode_utf16(units)
            .map(|one| one.unwrap_or(char::REPLACEMENT_CHARACTER))
            .collect();
        Ok(Cow::Owned(text.into_bytes()))
    };
    match bytes {
        [0xD0, 0xCF, 0x11, 0xE0, ..] => refused("an Excel workbook (xls)"),
        [b'P', b'K', 3 | 5, 4 | 6, ..] => refused("a zip archive or an Excel workbook (xlsx)"),
        [0x89, b'H', b'D', b'F', ..] => refused(
            "an HDF5 or MATLAB v7.3 file; in MATLAB, `writetable` or `writematrix` writes CSV",
        ),
        _ if bytes.starts_with(b"MATLAB 5.0") => refused(
            "a MATLAB file, which the command `gyradius import` alone reads; `writetable` or `writematrix` writes CSV",
        ),
        [0xFF, 0xFE, rest @ ..] => wide(rest, u16::from_le_bytes),
        [0xFE, 0xFF, rest @ ..] => wide(rest, u16::from_be_bytes),
        [0xEF, 0xBB, 0xBF, rest @ ..] => Ok(Cow::Borrowed(rest)),
        _ => Ok(Cow::Borrowed(bytes)),
    }
}

/// Whether most cells are values.
pub(super) fn is_row(record: &ByteRecord) -> bool {
    layout::is_row(&record.iter().map(text_of).collect::<Vec<_>>())
}

/// A cell as a number, NaN where a program says that there is none. The first decimal mark met holds for the rest of the file.
fn number(cell: &[u8], mark: &mut Option<u8>) -> std::result::Result<Option<f64>, ()> {
    let cell = cell.trim_ascii();
    if cell.is_empty() {
        return Ok(None);
    }
    if layout::is_missing(cell) {
        return Ok(Some(f64::NAN));
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
