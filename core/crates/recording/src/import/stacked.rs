//! Several tables in one file, one below the other: each has a header of its own.

use std::ops::Range;

use super::layout::{are_units, cells, is_row};

/// One of the tables.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Stacked {
    /// Where it stands, its header included.
    pub span: Range<usize>,
    /// Rows of values in it.
    pub rows: usize,
}

/// A line, and whether it is a row of values.
struct Line {
    span: Range<usize>,
    kind: Kind,
}

#[derive(PartialEq)]
enum Kind {
    Blank,
    Row(usize),
    Text(Vec<String>),
}

/// The tables of a text from the first header on. A header is a line of names, as many as the row
/// below it has cells (a row of units may stand between), that repeats the first header or that
/// something else than a row stands before.
pub(super) fn tables(bytes: &[u8], separator: u8, header_at: usize) -> Vec<Stacked> {
    let lines = lines(bytes, separator, header_at);
    let header = lines.iter().find_map(|line| match &line.kind {
        Kind::Text(names) => Some(names),
        _ => None,
    });
    let mut found: Vec<Stacked> = Vec::new();
    // Whether a row has been met since anything else.
    let mut after_row = false;
    for (i, line) in lines.iter().enumerate() {
        match &line.kind {
            Kind::Row(_) => {
                after_row = true;
                match found.last_mut() {
                    Some(last) => {
                        last.rows += 1;
                        last.span.end = line.span.end;
                    }
                    None => found.push(Stacked {
                        span: header_at..line.span.end,
                        rows: 1,
                    }),
                }
            }
            Kind::Text(names) => {
                let is_new = !after_row || Some(names) == header;
                if is_new
                    && !found.is_empty()
                    && !are_units(names)
                    && is_header(names, &lines[i + 1..])
                {
                    found.push(Stacked {
                        span: line.span.clone(),
                        rows: 0,
                    });
                }
                after_row = false;
            }
            Kind::Blank => after_row = false,
        }
    }
    found
}

/// Whether names are those of the rows that follow.
fn is_header(names: &[String], following: &[Line]) -> bool {
    let mut next = following.iter().filter(|line| line.kind != Kind::Blank);
    let mut row = next.next();
    if let Some(Line {
        kind: Kind::Text(units),
        ..
    }) = row
        && are_units(units)
    {
        row = next.next();
    }
    names.len() > 1
        && matches!(row, Some(Line { kind: Kind::Row(count), .. }) if *count >= names.len())
}

fn lines(bytes: &[u8], separator: u8, from: usize) -> Vec<Line> {
    let mut at = from;
    let rest = bytes.get(from..).unwrap_or_default();
    let pieces = rest.split_inclusive(|b| *b == b'\n' || *b == b'\r');
    pieces
        .map(|piece| {
            let span = at..at + piece.len();
            at = span.end;
            let text = String::from_utf8_lossy(piece);
            let kind = kind_of(text.trim_matches(['\n', '\r', ' ']), separator);
            Line { span, kind }
        })
        .collect()
}

fn kind_of(text: &str, separator: u8) -> Kind {
    let is_comment = text.starts_with(['#', '%']) || text.starts_with("//");
    if is_comment || text.trim_matches(['\t', ',', ';', '|', ' ']).is_empty() {
        return Kind::Blank;
    }
    // The common case, told without taking the line apart.
    let count = || text.bytes().filter(|b| *b == separator).count() + 1;
    if text.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '+' | '.')) {
        return Kind::Row(count());
    }
    let mut cells = cells(text, separator);
    if is_row(&cells) {
        return Kind::Row(cells.len());
    }
    while cells.last().is_some_and(String::is_empty) {
        cells.pop();
    }
    Kind::Text(cells)
}
