//! Files of NIST's Statistical Reference Datasets, nonlinear regression.

use std::fs;
use std::path::Path;

/// A problem: two starts, what is certified, and the data.
pub struct Certified {
    pub name: String,
    pub starts: [Vec<f64>; 2],
    pub parameters: Vec<f64>,
    pub deviations: Vec<f64>,
    pub rss: f64,
    /// Response first, then the predictors.
    pub rows: Vec<Vec<f64>>,
}

fn numbers(text: &str) -> Vec<f64> {
    text.split_whitespace().flat_map(str::parse).collect()
}

fn after<'a>(lines: &[&'a str], key: &str) -> &'a str {
    let line = lines.iter().find_map(|l| l.trim().strip_prefix(key));
    line.unwrap_or_else(|| panic!("no line «{key}»"))
}

pub fn read(name: &str) -> Certified {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/strd");
    let text = fs::read_to_string(folder.join(format!("{name}.dat"))).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    let row = |line: &&str| {
        let (left, right) = line.split_once('=')?;
        let named = left.trim().strip_prefix('b')?.parse::<usize>().is_ok();
        let four = numbers(right);
        (named && four.len() == 4).then_some(four)
    };
    let table: Vec<Vec<f64>> = lines.iter().filter_map(row).collect();
    let column = |k: usize| table.iter().map(|row| row[k]).collect::<Vec<f64>>();
    // The second line that begins so is the head of the data.
    let head = lines.iter().rposition(|l| l.starts_with("Data:")).unwrap();
    let rows: Vec<Vec<f64>> = lines[head + 1..]
        .iter()
        .map(|l| numbers(l))
        .filter(|row| !row.is_empty())
        .collect();
    let count = after(&lines, "Number of Observations:").trim();
    assert_eq!(rows.len(), count.parse::<usize>().unwrap(), "{name}");
    let rss = numbers(after(&lines, "Residual Sum of Squares:"))[0];
    Certified {
        name: name.into(),
        starts: [column(0), column(1)],
        parameters: column(2),
        deviations: column(3),
        rss,
        rows,
    }
}
