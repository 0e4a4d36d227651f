//! Several trials in one table: rows numbered by a column, a clock that starts again, columns side
//! by side, tables one below the other.

use super::detect::{self, Content};
use super::labels::is_time;
use super::run_label::{RunLabel, run_of};
use super::source::{Source, base};
use super::stacked::{Stacked, tables};
use super::table::Table;
use gyradius_base::{Error, Result};

/// Names of a column that numbers the trials.
const COLUMNS: &[&str] = &[
    "trial",
    "run",
    "trialnumber",
    "runnumber",
    "trialid",
    "runid",
];
/// Names of a column of time.
const TIMES: &[&str] = &[
    "t",
    "time",
    "times",
    "secondselapsed",
    "timestamp",
    "elapseds",
    "ts",
];
/// More trials than this are a column of something else.
const MOST: usize = 1000;
/// Rows that must stay below the time before them, for the clock to have started again.
const RESTARTED_ROWS: usize = 10;

/// The trials of a table.
struct Trials {
    /// Where they are told apart.
    by: String,
    /// What the file calls each; its number where it has no name for it.
    names: Vec<String>,
    /// How many rows each has.
    rows: Vec<usize>,
    /// Where each stands.
    places: Places,
}

/// Where the trials of a table stand.
enum Places {
    /// Number of each row's trial.
    Rows(Vec<usize>),
    /// The columns of each, and their names without the trial's.
    Columns(Vec<Vec<(usize, String)>>),
    /// A table for each.
    Tables(Vec<Stacked>),
}

impl Trials {
    /// `None` where there is but one.
    fn of(table: &Table) -> Result<Option<Self>> {
        let plain = |name: &str| -> String {
            let letters = name.chars().filter(|c| c.is_alphanumeric());
            letters.collect::<String>().to_lowercase()
        };
        let find = |names: &[&str]| table.find(|name| names.contains(&plain(name).as_str()));
        let found = if let Some(apart) = Self::apart(table)? {
            Some(apart)
        } else if let Some(column) = find(COLUMNS) {
            Some(Self::numbered(table, column)?)
        } else if let Some(column) = find(TIMES) {
            Some(Self::restarted(table, column)?)
        } else {
            None
        };
        Ok(found.filter(|trials| (2..=MOST).contains(&trials.names.len())))
    }

    /// Trials that have columns or tables of their own.
    fn apart(table: &Table) -> Result<Option<Self>> {
        match Self::stacked(table) {
            Some(stacked) => Ok(Some(stacked)),
            None => Self::side_by_side(table),
        }
    }

    fn stacked(table: &Table) -> Option<Self> {
        let (bytes, header_at) = table.text();
        let found = tables(bytes, table.separator(), header_at);
        (found.len() > 1).then(|| Self {
            by: "tables one below the other".to_owned(),
            names: (1..=found.len()).map(|number| number.to_string()).collect(),
            rows: found.iter().map(|one| one.rows).collect(),
            places: Places::Tables(found),
        })
    }

    fn side_by_side(table: &Table) -> Result<Option<Self>> {
        let header = table.header();
        let runs = worded(header)
            .or_else(|| numbered_names(header))
            .or_else(|| repeated(table));
        let Some((by, runs)) = runs else {
            return Ok(None);
        };
        let (names, columns): (Vec<String>, Vec<Vec<(usize, String)>>) = runs.into_iter().unzip();
        let rows = columns.iter().map(|columns| {
            // The longest of its columns.
            let filled = |(column, _): &(usize, String)| {
                let texts = table.texts_of(*column)?;
                Ok(texts.iter().filter(|text| !text.is_empty()).count())
            };
            let filled: Result<Vec<usize>> = columns.iter().map(filled).collect();
            Ok(filled?.into_iter().max().unwrap_or(0))
        });
        Ok(Some(Self {
            by,
            names,
            rows: rows.collect::<Result<_>>()?,
            places: Places::Columns(columns),
        }))
    }

    fn by_rows(by: String, names: Vec<String>, of_row: Vec<usize>) -> Self {
        let mut rows = vec![0; names.len()];
        for trial in &of_row {
            if let Some(count) = rows.get_mut(*trial) {
                *count += 1;
            }
        }
        Self {
            by,
            names,
            rows,
            places: Places::Rows(of_row),
        }
    }

    fn numbered(table: &Table, column: usize) -> Result<Self> {
        let mut names: Vec<String> = Vec::new();
        let mut of_row = Vec::new();
        for text in table.texts_of(column)? {
            let place = names.iter().rposition(|name| *name == text);
            of_row.push(place.unwrap_or(names.len()));
            if place.is_none() {
                names.push(text);
            }
            if names.len() > MOST {
                break;
            }
        }
        let by = format!("column `{}`", table.name_of(column));
        Ok(Self::by_rows(by, names, of_row))
    }

    fn restarted(table: &Table, column: usize) -> Result<Self> {
        let texts = table.texts_of(column)?;
        let number = |text: &String| text.replacen(',', ".", 1).parse::<f64>().ok();
        let t: Vec<f64> = texts
            .iter()
            .map(|text| number(text).unwrap_or(f64::NAN))
            .collect();
        let mut of_row = Vec::with_capacity(t.len());
        let mut trial = 0;
        for (i, now) in t.iter().enumerate() {
            let before = i.checked_sub(1).map_or(f64::NAN, |last| t[last]);
            let following = t.get(i..i + RESTARTED_ROWS).unwrap_or_default();
            let again = *now < before && following.iter().all(|later| *later < before);
            trial += usize::from(again && !following.is_empty());
            of_row.push(trial);
        }
        let by = format!(
            "the clock starts again in column `{}`",
            table.name_of(column)
        );
        let names = (1..=trial + 1).map(|number| number.to_string()).collect();
        Ok(Self::by_rows(by, names, of_row))
    }

    fn listed(&self) -> String {
        let one = |(name, rows): (&String, &usize)| format!("{name} ({rows} rows)");
        let each = self.names.iter().zip(&self.rows).take(20);
        let listed: Vec<String> = each.map(one).collect();
        let more = if self.names.len() > listed.len() {
            ", …"
        } else {
            ""
        };
        format!(
            "{} trials, {}: {}{more}",
            self.names.len(),
            self.by,
            listed.join(", ")
        )
    }

    /// The file with one of them alone.
    fn alone(&self, table: &Table, wanted: usize) -> Result<Vec<u8>> {
        match &self.places {
            Places::Rows(of_row) => table.with_rows(|row| of_row.get(row) == Some(&wanted)),
            Places::Columns(trials) => {
                let of_trial = trials.get(wanted).cloned().unwrap_or_default();
                // A row of units below the header goes into the names.
                let named = of_trial
                    .into_iter()
                    .map(|(column, name)| match table.unit(column) {
                        Some(unit) if !name.ends_with([')', ']']) => {
                            (column, format!("{name} ({unit})"))
                        }
                        _ => (column, name),
                    });
                let (columns, names): (Vec<usize>, Vec<String>) = named.unzip();
                table.with_columns(&columns, &names)
            }
            Places::Tables(tables) => {
                let (bytes, _) = table.text();
                let mut alone = bytes.to_vec();
                let first = tables.first().map_or(0, |one| one.span.start);
                let own = tables.get(wanted).map(|one| one.span.clone());
                let own = own.unwrap_or_default();
                // What stands between the tables is part of none.
                for (at, byte) in alone.iter_mut().enumerate().skip(first) {
                    if !own.contains(&at) && !matches!(*byte, b'\n' | b'\r') {
                        *byte = table.separator();
                    }
                }
                Ok(alone)
            }
        }
    }
}

/// The columns of each run, by its name.
type Runs = Vec<(String, Vec<(usize, String)>)>;

/// Columns by the run that their names tell, in the order of the file.
fn by_run(header: &[String], wanted: impl Fn(&RunLabel) -> bool) -> Runs {
    let mut runs: Runs = Vec::new();
    for (column, name) in header.iter().enumerate() {
        let Some(label) = run_of(name).filter(&wanted) else {
            continue;
        };
        let entry = (column, label.rest);
        match runs.iter_mut().find(|(run, _)| *run == label.run) {
            Some((_, columns)) => columns.push(entry),
            None => runs.push((label.run, vec![entry])),
        }
    }
    runs
}

fn has_time(columns: &[(usize, String)]) -> bool {
    columns.iter().any(|(_, name)| is_time(name))
}

/// Runs that the header tells in words; a time without a run is that of all.
fn worded(header: &[String]) -> Option<(String, Runs)> {
    let mut runs = by_run(header, |label| label.is_worded);
    let is_common = |name: &String| run_of(name).is_none_or(|label| !label.is_worded);
    let common: Vec<(usize, String)> = header
        .iter()
        .cloned()
        .enumerate()
        .filter(|(_, name)| is_common(name))
        .collect();
    for (_, columns) in runs.iter_mut().filter(|(_, columns)| !has_time(columns)) {
        columns.splice(0..0, common.iter().cloned());
    }
    runs.retain(|(_, columns)| columns.len() > 1 && has_time(columns));
    (runs.len() > 1).then(|| ("columns side by side".to_owned(), runs))
}

/// `t1, x1, t2, x2`: each number has a time of its own, and what all have is called alike.
fn numbered_names(header: &[String]) -> Option<(String, Runs)> {
    let runs = by_run(header, |label| !label.is_worded);
    let names = |columns: &[(usize, String)]| -> Vec<String> {
        let mut names: Vec<String> = columns.iter().map(|(_, name)| name.clone()).collect();
        names.sort();
        names
    };
    let first = names(&runs.first()?.1);
    let is_alike = |columns: &[(usize, String)]| {
        columns.len() > 1 && has_time(columns) && names(columns) == first
    };
    let are_alike = runs.len() > 1 && runs.iter().all(|(_, columns)| is_alike(columns));
    are_alike.then(|| ("columns side by side".to_owned(), runs))
}

/// `Time, Angle, Time, Angle`: the same names again and again; the line above may name the trials.
fn repeated(table: &Table) -> Option<(String, Runs)> {
    let header = table.header();
    let width = (2..=header.len() / 2).find(|width| {
        let mut blocks = header.chunks(*width);
        header.len().is_multiple_of(*width) && blocks.all(|block| block == &header[..*width])
    })?;
    let count = header.len() / width;
    let above = table.preamble().last().map(|line| {
        let cells = line.split(char::from(table.separator()));
        let names = cells.map(|cell| cell.trim().trim_matches('"').to_owned());
        let names: Vec<String> = names.filter(|name| !name.is_empty()).collect();
        names
    });
    let named = above.filter(|names| names.len() == count);
    let name = |block: usize| match &named {
        Some(names) => names[block].clone(),
        None => (block + 1).to_string(),
    };
    let block = |k: usize| {
        let columns = k * width..(k + 1) * width;
        let columns = columns.map(|column| (column, header[column].clone()));
        (name(k), columns.collect::<Vec<_>>())
    };
    let runs: Runs = (0..count).map(block).collect();
    let has_times = runs.iter().all(|(_, columns)| has_time(columns));
    has_times.then(|| ("columns side by side".to_owned(), runs))
}

/// A file with one trial alone, what is not its left blank so that lines keep their numbers; `None`
/// where it holds but one.
pub(super) fn choose(bytes: &[u8], name: &str, trial: &str) -> Result<Option<Vec<u8>>> {
    let Ok(table) = Table::open(bytes, name) else {
        return Ok(None);
    };
    let Some(trials) = Trials::of(&table)? else {
        return Ok(None);
    };
    let wanted = trials.names.iter().position(|name| name == trial);
    let wanted = wanted.ok_or_else(|| Error::Malformed {
        file: name.to_owned(),
        line: None,
        expected: format!("trial `{trial}`"),
        found: trials.listed(),
    })?;
    trials.alone(&table, wanted).map(Some)
}

/// Refuses a file whose trials cannot be read as one recording: tables one below the other, and,
/// unless a mapping names the columns, columns side by side.
pub(super) fn refuse_several(source: &Source, is_mapped: bool) -> Result<()> {
    let is_known = |name: &str, bytes: &[u8]| {
        Table::open(bytes, name)
            .is_ok_and(|table| detect::content(&table, name) != Content::Unknown)
    };
    // Beside files that are known, a table that is not known is not used, however many it holds.
    let holds_known = source.members().any(|(name, bytes)| is_known(name, bytes));
    for (name, bytes) in source.members() {
        let Ok(table) = Table::open(bytes, name) else {
            continue;
        };
        let Some(trials) = Trials::apart(&table)? else {
            continue;
        };
        let is_beside = holds_known && !is_mapped && !is_known(name, &trials.alone(&table, 0)?);
        if is_beside {
            continue;
        }
        if !(is_mapped && matches!(trials.places, Places::Columns(_))) {
            return Err(Error::Malformed {
                file: name.to_owned(),
                line: None,
                expected: "one trial, chosen with --trial".to_owned(),
                found: trials.listed(),
            });
        }
    }
    Ok(())
}

/// What to tell of a file that holds several trials.
pub(super) fn note(bytes: &[u8], name: &str) -> Option<String> {
    let table = Table::open(bytes, name).ok()?;
    let trials = Trials::of(&table).ok()??;
    Some(format!(
        "`{}` holds {}; choose one with --trial",
        base(name),
        trials.listed()
    ))
}
