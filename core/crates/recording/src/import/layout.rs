//! Where the header and the rows of a table stand in a text file, and what separates its cells.
//!
//! # Conventions
//! The rows begin at the first line of which more than half the cells are numbers or times, and
//! that another such line follows. The header is the line of text before it; a line of units may
//! stand between the two. Lines before the header, comments (`#`, `%`, `//`) and a `sep=` line are
//! the preamble. Without a header the columns are named `1`, `2`, ….

use std::borrow::Cow;

use super::clock::seconds_of_text;
use super::units::unit_of_header;

/// Lines that are searched for the first row.
const SCANNED_LINES: usize = 2000;
/// Lines that the names of a header may take more than one.
const MOST_LINES_OF_A_NAME: usize = 40;

/// A table's parts.
#[derive(Debug, Default)]
pub(super) struct Layout {
    pub separator: u8,
    /// A row that starts with it is a comment.
    pub comment: Option<u8>,
    pub header: Vec<String>,
    /// Units of the columns, where a row of them follows the header.
    pub units: Vec<String>,
    /// Offset of the header, and of what follows it.
    pub header_at: usize,
    pub rows_at: usize,
    /// Lines before the header.
    pub preamble: Vec<String>,
    /// False where the columns have numbers instead of names.
    pub named: bool,
}

/// A line with text: where it starts and ends.
#[derive(Clone, Copy)]
struct Line<'a> {
    at: usize,
    end: usize,
    text: &'a str,
}

impl Line<'_> {
    fn is_comment(&self) -> bool {
        self.text.starts_with(['#', '%']) || self.text.starts_with("//")
    }

    /// The separator that a `sep=` line states.
    fn stated_separator(&self) -> Option<u8> {
        let bare = self.text.trim_matches('"');
        let stated = bare
            .strip_prefix("sep=")
            .or_else(|| bare.strip_prefix("SEP="))?;
        Some(stated.bytes().next().unwrap_or(b'\t'))
    }
}

/// Takes a file apart; `None` where it holds no text. The bytes may be rewritten line by line where
/// blanks separate the cells, or where a serial monitor put the time before them.
pub(super) fn find(bytes: Cow<'_, [u8]>) -> (Cow<'_, [u8]>, Option<Layout>) {
    let bytes = match arrows(&bytes) {
        Some(rewritten) => Cow::Owned(rewritten),
        None => bytes,
    };
    let (bytes, labels) = match unlabelled(&bytes) {
        Some((rewritten, labels)) => (Cow::Owned(rewritten), Some(labels)),
        None => (bytes, None),
    };
    let (bytes, layout) = without_labels(bytes);
    let named = |mut layout: Layout| {
        if let Some(labels) = labels.filter(|labels| labels.len() == layout.header.len()) {
            (layout.header, layout.named) = (labels, true);
        }
        layout
    };
    (bytes, layout.map(named))
}

fn without_labels(bytes: Cow<'_, [u8]>) -> (Cow<'_, [u8]>, Option<Layout>) {
    let text = String::from_utf8_lossy(&bytes);
    // Another encoding: positions in the text are not those in the file, so the bytes are replaced.
    let replaced = matches!(text, Cow::Owned(_)).then(|| text.clone().into_owned().into_bytes());
    let layout = of_text(&text);
    let blanks = layout
        .as_ref()
        .is_some_and(|layout| layout.separator == b' ');
    drop(text);
    let bytes = replaced.map_or(bytes, Cow::Owned);
    if blanks {
        let single = single_blanks(&bytes);
        let layout = of_text(&String::from_utf8_lossy(&single));
        return (Cow::Owned(single), layout);
    }
    (bytes, layout)
}

fn of_text(text: &str) -> Option<Layout> {
    let lines = lines(text);
    let stated = lines.iter().find_map(Line::stated_separator);
    let content: Vec<Line> = lines
        .iter()
        .copied()
        .filter(|line| !line.is_comment() && line.stated_separator().is_none())
        .collect();
    let first = *content.first()?;
    let is_row = |line: &Line| separator_of_row(line.text, stated);
    let row = content.iter().enumerate().find_map(|(i, line)| {
        let separator = is_row(line)?;
        let goes_on = content.get(i + 1).is_none_or(|next| is_row(next).is_some());
        goes_on.then_some((i, separator))
    });
    let comment = lines.iter().find(|line| line.is_comment());
    let comment = comment
        .and_then(|line| line.text.bytes().next())
        .filter(|b| *b != b'/');
    let mut layout = Layout {
        comment: comment.or(Some(b'#')),
        named: true,
        ..Layout::default()
    };
    let Some((row, separator)) = row else {
        layout.separator = stated.unwrap_or_else(|| separator_of_header(first.text));
        layout.header = trimmed(cells(first.text, layout.separator));
        (layout.header_at, layout.rows_at) = (first.at, first.end);
        layout.preamble = before(&lines, first.at);
        return Some(layout);
    };
    layout.separator = separator;
    let count = cells(content[row].text, separator).len();
    layout.place_header(&lines, &content[..row], content[row], count);
    layout.preamble = before(&lines, layout.header_at);
    Some(layout)
}

impl Layout {
    fn place_header(&mut self, lines: &[Line], above: &[Line], row: Line, count: usize) {
        let split = |line: &Line| trimmed(cells(line.text, self.separator));
        let numbers_rows = is_numbered(row, self.separator);
        let is_header = |names: &Vec<String>| match self.separator {
            // Words of a sentence are no columns.
            b' ' => names.len() == count || (numbers_rows && names.len() + 1 == count),
            _ => names.len() >= 2 || count == 1,
        };
        let text: Vec<(Line, Vec<String>)> = above
            .iter()
            .map(|line| (*line, split(line)))
            .filter(|(_, names)| is_header(names))
            .collect();
        self.rows_at = row.at;
        let last_comment = lines
            .iter()
            .rev()
            .find(|line| line.at < row.at && line.is_comment());
        let in_comment = last_comment
            .map(|line| (line, split_comment(line, self.separator)))
            .filter(|(_, names)| names.len() == count && count > 1);
        // The last line above the rows is the header only if nothing else stands between.
        let last = text
            .last()
            .filter(|(line, _)| above.last().is_some_and(|a| a.at == line.at));
        match (last, text.len().checked_sub(2).and_then(|i| text.get(i))) {
            (Some((_, units)), Some((line, names))) if are_units(units) => {
                (self.header, self.units, self.header_at) = (names.clone(), units.clone(), line.at);
            }
            (Some((line, names)), _) => (self.header, self.header_at) = (names.clone(), line.at),
            (None, _) => {
                self.header_at = row.at;
                match in_comment {
                    Some((_, names)) => self.header = names,
                    None => {
                        self.named = false;
                        self.header = (1..=count).map(|n| n.to_string()).collect();
                    }
                }
            }
        }
        // R writes the names of its rows before the first column, and none above them.
        if numbers_rows && self.named && self.header.len() + 1 == count {
            self.header.insert(0, String::new());
            if !self.units.is_empty() {
                self.units.insert(0, String::new());
            }
        }
    }
}

/// Whether a row begins with its number, as text: `"1" 0.00 …`.
fn is_numbered(row: Line, separator: u8) -> bool {
    let cells = cells(row.text, separator);
    let first = cells.first().map(|cell| cell.trim().trim_matches('"'));
    let is_number = first.is_some_and(|cell| !cell.is_empty() && cell.parse::<u32>().is_ok());
    row.text.starts_with('"') && is_number
}

fn split_comment(line: &Line, separator: u8) -> Vec<String> {
    let bare = line.text.trim_start_matches(['#', '%', '/']);
    trimmed(cells(bare.trim(), separator))
}

pub(super) fn are_units(cells: &[String]) -> bool {
    let filled: Vec<&str> = cells
        .iter()
        .map(|cell| cell.trim_matches(['(', ')', '[', ']']))
        .filter(|cell| !cell.is_empty())
        .collect();
    let units = filled.iter().filter(|cell| unit_of_header(cell).is_some());
    !filled.is_empty() && 2 * units.count() >= filled.len()
}

fn before(lines: &[Line], at: usize) -> Vec<String> {
    let above = lines.iter().filter(|line| line.at < at);
    above.map(|line| line.text.to_owned()).collect()
}

/// The first lines that are not blank; separators alone are blank too.
fn lines(text: &str) -> Vec<Line<'_>> {
    let mut at = 0;
    let mut lines = Vec::new();
    while let Some(rest) = text.get(at..).filter(|rest| !rest.is_empty()) {
        let piece = &rest[..length_of_line(rest)];
        let end = at + piece.len();
        // A separator at the start of a row is an empty cell.
        let text = piece.trim_matches(['\n', '\r', ' ']);
        if !text.trim_matches(['\t', ',', ';', '|', ' ']).is_empty() {
            lines.push(Line { at, end, text });
        }
        if lines.len() == SCANNED_LINES {
            break;
        }
        at = end;
    }
    lines
}

/// Bytes of the first line; a name in quotes may run on over a few, none of which is a row.
fn length_of_line(text: &str) -> usize {
    let mut pieces = text.split_inclusive(['\n', '\r']);
    let first = pieces.next().map_or(0, str::len);
    let is_open = |text: &str| text.bytes().filter(|b| *b == b'"').count() % 2 == 1;
    let mut length = first;
    for piece in pieces.take(MOST_LINES_OF_A_NAME) {
        if !is_open(&text[..length]) {
            return length;
        }
        if separator_of_row(piece.trim(), None).is_some() {
            return first;
        }
        length += piece.len();
    }
    if is_open(&text[..length]) {
        first
    } else {
        length
    }
}

/// The separator by which a line is a row of values, if it is one.
fn separator_of_row(line: &str, stated: Option<u8>) -> Option<u8> {
    if let Some(stated) = stated {
        return is_row(&cells(line, stated)).then_some(stated);
    }
    let by_blanks = cells(line, b' ');
    // `0,5 1,5`: with blanks between them, these are two numbers, not three.
    if !line.contains(['\t', ';', '|'])
        && by_blanks.len() > 1
        && by_blanks.iter().all(|cell| is_number(cell))
    {
        return Some(b' ');
    }
    let mut separators = [b'\t', b';', b'|', b','].into_iter();
    let found = separators.find(|&separator| {
        let cells = cells(line, separator);
        cells.len() > 1 && is_row(&cells)
    });
    let single = || is_value(line.trim_matches('"')).then_some(b',');
    let blanks = || (by_blanks.len() > 2 && is_row(&by_blanks)).then_some(b' ');
    found.or_else(blanks).or_else(single)
}

/// The separator of a header without rows of numbers. TAB, `;` and `|` never stand in a name.
fn separator_of_header(line: &str) -> u8 {
    let mut quoted = false;
    let mut bare = line.bytes().filter(|&b| {
        quoted ^= b == b'"';
        !quoted
    });
    bare.find(|b| matches!(b, b'\t' | b';' | b'|'))
        .unwrap_or(b',')
}

pub(super) fn is_row(cells: &[String]) -> bool {
    let filled = cells
        .iter()
        .filter(|cell| !cell.is_empty() && !is_missing(cell.as_bytes()));
    let values = filled.clone().filter(|cell| is_value(cell)).count();
    values > 0 && 2 * values > filled.count()
}

fn is_value(cell: &str) -> bool {
    let is_time = cell.starts_with(|c: char| c.is_ascii_digit()) && seconds_of_text(cell).is_some();
    let is_infinite = || {
        cell.trim_start_matches(['-', '+'])
            .eq_ignore_ascii_case("inf")
    };
    is_number(cell) || cell.eq_ignore_ascii_case("nan") || is_infinite() || is_time
}

/// How R, Excel, databases and Python write that there is no value.
pub(super) fn is_missing(cell: &[u8]) -> bool {
    let known: [&[u8]; 8] = [
        b"na", b"n/a", b"#n/a", b"null", b"none", b"<na>", b"-", b"--",
    ];
    known.iter().any(|known| cell.eq_ignore_ascii_case(known))
}

fn is_number(cell: &str) -> bool {
    let starts =
        cell.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '.' | ','));
    starts
        && !cell.ends_with(',')
        && (cell.parse::<f64>().is_ok() || cell.replacen(',', ".", 1).parse::<f64>().is_ok())
}

/// The cells of one line, trimmed, quotes taken off; runs of blanks count once.
pub(super) fn cells(line: &str, separator: u8) -> Vec<String> {
    let separator = char::from(separator);
    let mut quoted = false;
    let pieces = line.split(|c: char| {
        quoted ^= c == '"';
        !quoted && (c == separator || separator == ' ' && c == '\t')
    });
    let cells = pieces.map(|cell| one_line(cell.trim().trim_matches('"').trim()));
    match separator {
        ' ' => cells.filter(|cell| !cell.is_empty()).collect(),
        _ => cells.collect(),
    }
}

/// A cell without the line breaks that a spreadsheet allows in it.
fn one_line(cell: &str) -> String {
    match cell.contains(['\n', '\r']) {
        true => cell.split_whitespace().collect::<Vec<_>>().join(" "),
        false => cell.to_owned(),
    }
}

/// Nameless columns at the end are left out.
fn trimmed(mut cells: Vec<String>) -> Vec<String> {
    while cells.last().is_some_and(String::is_empty) {
        cells.pop();
    }
    cells
}

/// Lines with one blank between cells and none around them; what stands in quotes stays.
fn single_blanks(bytes: &[u8]) -> Vec<u8> {
    let mut out = Vec::with_capacity(bytes.len());
    let (mut quoted, mut pending) = (false, false);
    for &byte in bytes {
        quoted ^= byte == b'"';
        let end = byte == b'\n' || byte == b'\r';
        if end {
            quoted = false;
        } else if !quoted && (byte == b' ' || byte == b'\t') {
            pending = true;
            continue;
        }
        let at_start = out
            .last()
            .is_none_or(|&last| last == b'\n' || last == b'\r');
        if pending && !end && !at_start {
            out.push(b' ');
        }
        pending = false;
        out.push(byte);
    }
    out
}

/// Rows whose cells name themselves, as for a serial plotter (`gx:0.6,gy:1.2`): the rows without the
/// names, and the names. A cell without a name keeps its number for one.
fn unlabelled(bytes: &[u8]) -> Option<(Vec<u8>, Vec<String>)> {
    let start = String::from_utf8_lossy(bytes.get(..bytes.len().min(4096))?).into_owned();
    let mut rows = start.lines().filter(|line| !line.trim().is_empty());
    let (first, second) = (rows.next()?, rows.next()?);
    let separator = label_separator(first)?;
    let names = |line: &str| -> Vec<Option<String>> {
        let cells = cells(line, separator);
        cells
            .iter()
            .map(|cell| label(cell).map(str::to_owned))
            .collect()
    };
    let labels = names(first);
    if labels.iter().all(Option::is_none) || labels != names(second) {
        return None;
    }
    let mut out = Vec::with_capacity(bytes.len());
    for line in String::from_utf8_lossy(bytes).split_inclusive('\n') {
        let bare = line.trim_end_matches(['\n', '\r']);
        let values = cells(bare, separator)
            .into_iter()
            .map(|cell| match label(&cell) {
                Some(label) => cell[label.len()..]
                    .trim_start_matches([':', '=', ' '])
                    .to_owned(),
                None => cell,
            });
        let row = values
            .collect::<Vec<_>>()
            .join(&char::from(separator).to_string());
        out.extend(row.as_bytes());
        out.extend(&line.as_bytes()[bare.len()..]);
    }
    let names = labels.into_iter().zip(1..);
    let names = names.map(|(label, number): (_, usize)| label.unwrap_or(number.to_string()));
    Some((out, names.collect()))
}

/// What separates cells that name themselves; some may be values alone.
fn label_separator(line: &str) -> Option<u8> {
    [b'\t', b';', b',', b' '].into_iter().find(|separator| {
        let cells = cells(line, *separator);
        let told = |cell: &String| label(cell).is_some() || is_value(cell);
        cells.len() > 1 && cells.iter().all(told)
    })
}

/// The name in `gx:0.6` or `gx = 0.6`.
fn label(cell: &str) -> Option<&str> {
    let (name, value) = cell.split_once([':', '='])?;
    let is_name = name.starts_with(char::is_alphabetic);
    (is_name && is_number(value.trim())).then(|| name.trim_end())
}

/// A serial monitor's `10:00:00.000 -> 1,2,3`: the arrow becomes what separates the cells.
fn arrows(bytes: &[u8]) -> Option<Vec<u8>> {
    const ARROW: &str = " -> ";
    let start = String::from_utf8_lossy(bytes.get(..bytes.len().min(4096))?).into_owned();
    let separator = start.lines().find_map(|line| {
        let (time, row) = line.split_once(ARROW)?;
        seconds_of_text(time)?;
        separator_of_row(row.trim(), None).or_else(|| label_separator(row.trim()))
    })?;
    let mut out = Vec::with_capacity(bytes.len());
    let arrow = ARROW.as_bytes();
    for line in bytes.split_inclusive(|&b| b == b'\n') {
        match line.windows(arrow.len()).position(|part| part == arrow) {
            Some(at) => {
                out.extend(&line[..at]);
                out.push(separator);
                out.extend(&line[at + arrow.len()..]);
            }
            None => out.extend(line),
        }
    }
    Some(out)
}
