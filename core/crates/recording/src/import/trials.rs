//! Several trials in one table: rows numbered by a column, or a clock that starts again.

use super::source::base;
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
    /// What the column calls each; its number where the clock tells them apart.
    names: Vec<String>,
    /// Number of each row's trial.
    of_row: Vec<usize>,
}

impl Trials {
    /// `None` where there is but one.
    fn of(table: &Table) -> Result<Option<Self>> {
        let plain = |name: &str| -> String {
            let letters = name.chars().filter(|c| c.is_alphanumeric());
            letters.collect::<String>().to_lowercase()
        };
        let find = |names: &[&str]| table.find(|name| names.contains(&plain(name).as_str()));
        let found = if let Some(column) = find(COLUMNS) {
            Some(Self::numbered(table, column)?)
        } else if let Some(column) = find(TIMES) {
            Some(Self::restarted(table, column)?)
        } else {
            None
        };
        Ok(found.filter(|trials| (2..=MOST).contains(&trials.names.len())))
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
        Ok(Self {
            by: format!("column `{}`", table.name_of(column)),
            names,
            of_row,
        })
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
        Ok(Self {
            by: format!(
                "the clock starts again in column `{}`",
                table.name_of(column)
            ),
            names: (1..=trial + 1).map(|number| number.to_string()).collect(),
            of_row,
        })
    }

    fn listed(&self) -> String {
        let one = |(place, name): (usize, &String)| {
            let rows = self.of_row.iter().filter(|trial| **trial == place).count();
            format!("{name} ({rows} rows)")
        };
        let listed: Vec<String> = self.names.iter().enumerate().take(20).map(one).collect();
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
}

/// A file with the rows of one trial alone, the others blank so that lines keep their numbers;
/// `None` where it holds but one.
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
    let is_wanted = |row: usize| trials.of_row.get(row) == Some(&wanted);
    table.with_rows(is_wanted).map(Some)
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
