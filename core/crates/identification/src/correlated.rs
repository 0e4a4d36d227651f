//! Readings of one instrument share the errors of its scale and its zero: rows of the estimate that
//! are correlated (JCGM 100, F.1.2.3).

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

use super::names::Input;
use super::parameters::{Reading, Shared};

/// At least this part of a reading's variance is its own: readings without an error of their own
/// would make two of them one.
const LEAST_OWN: f64 = 1e-6;

/// Rows that share errors, and what makes them independent.
pub(super) struct Correlated {
    rows: Vec<usize>,
    /// Of the correlation matrix.
    root: Cholesky<f64, Dyn>,
    /// What each error contributes to each row, in standard uncertainties of the row.
    by_error: Vec<(Input, DVector<f64>)>,
}

impl Correlated {
    /// Groups the readings by the errors that they share; `row` tells the row of a reading and its
    /// whole uncertainty. A reading that is held more tightly than its instrument reads is not its
    /// reading any more.
    pub fn of(shared: &[Shared], row: impl Fn(&Reading) -> Option<(usize, f64)>) -> Vec<Self> {
        let mut groups: Vec<(Vec<usize>, Vec<&Shared>)> = Vec::new();
        let rows_of = |one: &Shared| -> Vec<usize> {
            let rows = one.readings.iter().filter_map(|(reading, _)| row(reading));
            rows.map(|(row, _)| row).collect()
        };
        for one in shared {
            let (mut rows, mut errors) = (rows_of(one), vec![one]);
            let (touching, apart): (Vec<_>, Vec<_>) = groups
                .into_iter()
                .partition(|(known, _)| known.iter().any(|row| rows.contains(row)));
            for (known, of_known) in touching {
                rows.extend(known);
                errors.extend(of_known);
            }
            rows.sort_unstable();
            rows.dedup();
            groups = apart;
            groups.push((rows, errors));
        }
        let built = groups
            .into_iter()
            .filter_map(|(rows, errors)| Self::group(rows, &errors, &row));
        built.collect()
    }

    fn group(
        rows: Vec<usize>,
        errors: &[&Shared],
        row: &impl Fn(&Reading) -> Option<(usize, f64)>,
    ) -> Option<Self> {
        let mut by_error: Vec<(Input, DVector<f64>)> = Vec::new();
        for one in errors {
            let mut changes = DVector::zeros(rows.len());
            for (reading, change) in &one.readings {
                if let Some((at, u)) = row(reading)
                    && let Ok(k) = rows.binary_search(&at)
                    && u > 0.0
                {
                    changes[k] += change / u;
                }
            }
            by_error.push((one.name.clone(), changes));
        }
        let all_shared = |k: usize| -> f64 {
            let squares = by_error.iter().map(|(_, changes)| changes[k].powi(2));
            squares.sum()
        };
        let held: Vec<bool> = (0..rows.len())
            .map(|k| all_shared(k) > 1.0 + 1e-9)
            .collect();
        for (_, changes) in &mut by_error {
            for k in (0..rows.len()).filter(|k| held[*k]) {
                changes[k] = 0.0;
            }
        }
        let mut matrix = DMatrix::identity(rows.len(), rows.len());
        for (_, changes) in &by_error {
            for i in 0..rows.len() {
                for j in (0..rows.len()).filter(|j| *j != i) {
                    matrix[(i, j)] += (1.0 - LEAST_OWN) * changes[i] * changes[j];
                }
            }
        }
        Some(Self {
            rows,
            root: matrix.cholesky()?,
            by_error,
        })
    }

    /// Makes the rows independent, each of unit variance.
    pub fn whiten(&self, rows: &mut [f64]) {
        let mut own = DVector::from_iterator(self.rows.len(), self.rows.iter().map(|i| rows[*i]));
        self.root.l_dirty().solve_lower_triangular_mut(&mut own);
        for (place, value) in self.rows.iter().zip(own.iter()) {
            rows[*place] = *value;
        }
    }

    /// Changes by one standard uncertainty of each independent row made changes by one of each
    /// reading.
    pub fn by_reading(&self, by_row: &mut [f64]) -> Option<()> {
        let changes = self.changes(by_row)?;
        let places = self.rows.iter().zip(changes.iter());
        places.for_each(|(place, change)| by_row[*place] = *change);
        Some(())
    }

    fn changes(&self, by_row: &[f64]) -> Option<DVector<f64>> {
        let own = DVector::from_iterator(self.rows.len(), self.rows.iter().map(|i| by_row[*i]));
        self.root.l().transpose().solve_upper_triangular(&own)
    }

    /// Contributions by independent row made contributions by reading and by shared error: of each
    /// reading what is its own, and of each error all that it does.
    pub fn by_source(&self, by_row: &mut [f64]) -> Vec<(Input, f64)> {
        let Some(by_reading) = self.changes(by_row) else {
            return vec![];
        };
        for (k, place) in self.rows.iter().enumerate() {
            let shared: f64 = self.by_error.iter().map(|(_, c)| c[k].powi(2)).sum();
            by_row[*place] = by_reading[k] * (1.0 - shared).max(0.0).sqrt();
        }
        let of = |(name, changes): &(Input, DVector<f64>)| (name.clone(), changes.dot(&by_reading));
        self.by_error.iter().map(of).collect()
    }
}
