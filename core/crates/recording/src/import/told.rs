//! What a table's lines hold that is passed over as its rows are read.

use super::layout::{cells, is_row};
use super::source::base;
use super::table::{Table, clipped};

/// Sentences on lines that look like rows but are comments, and on a last line that is no row.
pub(super) fn passed_over(bytes: &[u8], name: &str) -> Vec<String> {
    let Ok(table) = Table::open(bytes, name) else {
        return Vec::new();
    };
    let notes = [commented(&table), last_line(&table)];
    notes
        .into_iter()
        .flatten()
        .map(|note| format!("{}: {note}", base(name)))
        .collect()
}

/// Comments that would be rows of the table.
fn commented(table: &Table) -> Option<String> {
    let mark = table.comment_mark()?;
    let width = table.header().len();
    let mut rows = table.lines_below().filter(|(_, line)| {
        if width <= 1 || !line.starts_with(mark) {
            return false;
        }
        let cells = cells(line, table.separator());
        cells.len() == width && is_row(&cells[1..])
    });
    let (first, _) = rows.next()?;
    let count = 1 + rows.count();
    Some(format!(
        "{count} lines that begin with {mark} are comments and no rows, although they have as many cells; line {} is the first",
        table.line_at(first)
    ))
}

/// What a logger writes when it stops.
fn last_line(table: &Table) -> Option<String> {
    let is_row = |line: &str| is_row(&cells(line, table.separator()));
    let is_comment = |line: &str| {
        table
            .comment_mark()
            .is_some_and(|mark| line.starts_with(mark))
    };
    let (mut before, mut last) = (None, None);
    for line in table.lines_below().filter(|(_, line)| !is_comment(line)) {
        before = last.replace(line);
    }
    let ((_, before), (at, last)) = (before?, last?);
    (is_row(&before) && !is_row(&last)).then(|| {
        format!(
            "line {} is no row and is left out: `{}`",
            table.line_at(at),
            clipped(&last.replace('\0', " "), 40).trim()
        )
    })
}
